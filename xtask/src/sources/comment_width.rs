//! Comments are not wider than the code.

use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule =
    Rule { name: "comment width", demand: "a line of a comment has at most 100 characters", check };

const WIDEST: usize = 100;

fn check(sources: &[Source]) -> Vec<Finding> {
    sources.iter().flat_map(check_file).collect()
}

fn check_file(source: &Source) -> Vec<Finding> {
    let lines = source.text.lines().enumerate();
    let wide = lines.filter_map(|(k, line)| {
        let width = line.chars().count();
        let is_comment = line.trim_start().starts_with("//");
        (is_comment && width > WIDEST).then(|| source.finding(k + 1, format!("{width} characters")))
    });
    wide.collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    #[test]
    fn comments_are_not_wider_than_the_code() {
        assert_holds(&RULE);
    }

    #[test]
    fn a_wide_comment_is_found() {
        let wide = "x".repeat(100);
        let text = format!("/// {wide}\nfn f() {{}}\n// short\n");
        assert_eq!(lines(&RULE, "a.rs", &text), [1]);
    }
}
