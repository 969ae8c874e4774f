//! Rules for the sources that neither compiler nor clippy checks. Each is a file here, with a test
//! that applies it to the tree, so that `cargo test --workspace` fails where `cargo xtask sources`
//! reports a violation.

mod circles;
mod comment_width;
mod module_order;
mod paths;
mod syntax;
mod tree;
mod units;

use std::fmt;
use std::path::Path;

use tree::Source;

/// A rule about the sources.
struct Rule {
    /// A short name.
    name: &'static str,
    /// The requirement.
    demand: &'static str,
    /// Finds all violations.
    check: fn(&[Source]) -> Vec<Finding>,
}

/// A place that violates a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Finding {
    /// Path from the root of the workspace.
    path: String,
    /// Line in the file, starting from 1.
    line: usize,
    /// What is wrong there.
    what: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.path, self.line, self.what)
    }
}

const RULES: [Rule; 4] = [module_order::RULE, circles::RULE, units::RULE, comment_width::RULE];

/// Prints the violations of the rules; an error gives their number.
pub fn report(workspace: &Path) -> Result<(), String> {
    let sources = tree::load(workspace)?;
    let mut count = 0;
    for rule in RULES {
        let findings = (rule.check)(&sources);
        let verdict =
            if findings.is_empty() { "ok".to_owned() } else { findings.len().to_string() };
        println!("{}: {verdict} ({})", rule.name, rule.demand);
        for finding in &findings {
            println!("  {finding}");
        }
        count += findings.len();
    }
    if count == 0 { Ok(()) } else { Err(format!("{count} places violate the rules")) }
}

/// Names of the examples of the library.
pub fn examples(workspace: &Path) -> Result<Vec<String>, String> {
    let sources = tree::load(workspace)?;
    let name = |source: &Source| {
        Some(source.path.strip_prefix(EXAMPLES)?.trim_end_matches(".rs").to_owned())
    };
    Ok(sources.iter().filter_map(name).collect())
}

const EXAMPLES: &str = "crates/schlupf/examples/";

#[cfg(test)]
mod tests {
    use super::*;

    /// Asserts that the tree satisfies a rule; the message lists every violation.
    pub fn assert_holds(rule: &Rule) {
        let sources = tree::load(&crate::workspace()).unwrap();
        let findings = (rule.check)(&sources);
        let list: Vec<_> = findings.iter().map(ToString::to_string).collect();
        assert!(findings.is_empty(), "{}: {}\n{}", rule.name, rule.demand, list.join("\n"));
    }

    /// The violations of a rule in sources given as path and text: line and message.
    pub fn found(rule: &Rule, files: &[(&str, &str)]) -> Vec<(usize, String)> {
        let sources: Vec<_> = files
            .iter()
            .map(|(path, text)| Source::parse(path, (*text).to_owned()).unwrap())
            .collect();
        (rule.check)(&sources).into_iter().map(|finding| (finding.line, finding.what)).collect()
    }

    /// The lines alone.
    pub fn lines(rule: &Rule, path: &str, text: &str) -> Vec<usize> {
        found(rule, &[(path, text)]).into_iter().map(|(line, _)| line).collect()
    }

    /// The example programs of the library are short, and the one in the README is one of them.
    #[test]
    fn examples_are_short_and_one_is_in_the_readme() {
        let workspace = crate::workspace();
        let names = examples(&workspace).unwrap();
        assert!(names.len() >= 6, "{names:?}");
        let sources = tree::load(&workspace).unwrap();
        for source in sources.iter().filter(|source| source.path.starts_with(EXAMPLES)) {
            assert!(source.text.lines().count() < 60, "{}", source.path);
        }
        let first = std::fs::read_to_string(workspace.join(EXAMPLES).join("first_solution.rs"));
        let readme = std::fs::read_to_string(workspace.join("README.md")).unwrap();
        assert!(readme.contains(&format!("```rust\n{}```\n", first.unwrap())));
    }

    #[test]
    fn a_finding_reads_like_that_of_a_compiler() {
        let finding = Finding { path: "a.rs".to_owned(), line: 3, what: "wrong".to_owned() };
        assert_eq!(finding.to_string(), "a.rs:3: wrong");
    }
}
