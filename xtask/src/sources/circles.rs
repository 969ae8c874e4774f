//! Files of a crate that use each other in a cycle cannot be read, tested or moved one by one.
//!
//! A file uses another if its code names an item of it, by any path: an item re-exported by a
//! `pub use` belongs to the file that it comes from. Files above and below each other in the module
//! tree belong together: a `mod.rs` may call what its children make of the types that it gives
//! them.

use std::collections::{BTreeMap, VecDeque};

use super::paths::{module_of, named_paths};
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "circles",
    demand: "files beside each other do not use each other in a circle",
    check,
};

type Module = Vec<String>;

fn check(sources: &[Source]) -> Vec<Finding> {
    let mut crates: BTreeMap<&str, Vec<(Module, &Source)>> = BTreeMap::new();
    for source in sources.iter().filter(|source| !source.for_tests) {
        if let Some((package, path)) = source.path.split_once("/src/") {
            crates.entry(package).or_default().push((module_of(path), source));
        }
    }
    crates.into_values().flat_map(|files| circles(&Crate::new(files))).collect()
}

/// The files of a crate.
struct Crate<'a> {
    files: Vec<(Module, &'a Source)>,
    /// Names that a module re-exports: module and name, and the path behind it.
    exports: BTreeMap<(Module, String), Module>,
    /// The files that each file uses, and the first line where it does.
    uses: Vec<BTreeMap<usize, usize>>,
}

impl<'a> Crate<'a> {
    fn new(files: Vec<(Module, &'a Source)>) -> Self {
        let mut found = Self { files, exports: BTreeMap::new(), uses: Vec::new() };
        let paths: Vec<_> = found
            .files
            .iter()
            .map(|(module, file)| named_paths(&file.file.items, module))
            .collect();
        for ((module, _), paths) in found.files.iter().zip(&paths) {
            let exports = paths.iter().filter_map(|path| Some((path.export.clone()?, &path.names)));
            let exports = exports.map(|(name, path)| ((module.clone(), name), path.clone()));
            found.exports.extend(exports);
        }
        for (file, paths) in paths.iter().enumerate() {
            let mut uses = BTreeMap::new();
            for path in paths {
                let used = found.file_of(&path.names, MOST_EXPORTS);
                if let Some(used) = used.filter(|used| !found.are_related(file, *used)) {
                    uses.entry(used).or_insert(path.line);
                }
            }
            found.uses.push(uses);
        }
        found
    }

    fn file(&self, module: &[String]) -> Option<usize> {
        self.files.iter().position(|(other, _)| other == module)
    }

    /// The file that an item comes from, through at most so many re-exports.
    fn file_of(&self, path: &[String], exports: usize) -> Option<usize> {
        let mut depth = 0;
        while depth < path.len() && self.file(&path[..=depth]).is_some() {
            depth += 1;
        }
        let module = &path[..depth];
        let behind =
            path.get(depth).and_then(|name| self.exports.get(&(module.to_vec(), name.clone())));
        match behind.filter(|behind| exports > 0 && behind.as_slice() != path) {
            Some(behind) => self.file_of(behind, exports - 1),
            None => self.file(module),
        }
    }

    /// Whether one of two files is the other or is above it in the module tree.
    fn are_related(&self, one: usize, other: usize) -> bool {
        let [one, other] = [one, other].map(|file| &self.files[file].0);
        one.starts_with(other) || other.starts_with(one)
    }

    /// The shortest path from a file back to it through one that it uses.
    fn circle(&self, start: usize, used: usize) -> Option<Vec<usize>> {
        let mut ways = VecDeque::from([vec![start, used]]);
        let mut is_reached = vec![false; self.files.len()];
        while let Some(way) = ways.pop_front() {
            for &next in self.uses[*way.last()?].keys() {
                if next == start {
                    return Some(way);
                }
                if !std::mem::replace(&mut is_reached[next], true) {
                    ways.push_back([way.as_slice(), &[next]].concat());
                }
            }
        }
        None
    }
}

/// More names for one item would be pointless.
const MOST_EXPORTS: usize = 8;

/// Each cycle once, at the first of its files.
fn circles(files: &Crate) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (start, (module, source)) in files.files.iter().enumerate() {
        for (&used, &line) in &files.uses[start] {
            let circle = files.circle(start, used);
            let Some(circle) = circle.filter(|circle| circle.iter().min() == Some(&start)) else {
                continue;
            };
            let names = circle.iter().map(|file| &files.files[*file].0).chain([module]);
            let names: Vec<String> = names.map(|module| module.join("::")).collect();
            findings.push(source.finding(line, names.join(" uses ")));
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, found};
    use super::*;

    fn in_crate(files: &[(&str, &str)]) -> Vec<(usize, String)> {
        let paths: Vec<String> =
            files.iter().map(|(path, _)| format!("crates/a/src/{path}")).collect();
        let files: Vec<_> =
            paths.iter().zip(files).map(|(path, (_, text))| (path.as_str(), *text)).collect();
        found(&RULE, &files)
    }

    #[test]
    fn no_files_use_each_other_in_a_circle() {
        assert_holds(&RULE);
    }

    #[test]
    fn every_way_to_use_a_file_closes_a_circle() {
        for text in [
            "use super::pen::INK;",
            "use super::{pen::INK};",
            "use crate::figure::pen;",
            "use super::INK;",
            "use crate::INK;",
            "\nfn ink() -> &str { super::pen::INK }",
            "fn ink() { println!(\"{}\", crate::figure::pen::INK) }",
        ] {
            let found = in_crate(&[
                ("lib.rs", "pub mod figure; pub use figure::INK;"),
                ("figure/mod.rs", "mod pen; mod label; pub use pen::INK;"),
                ("figure/label.rs", text),
                ("figure/pen.rs", "use super::paper::Paper;"),
                ("figure/paper.rs", "use crate::figure::label;"),
            ]);
            let circle = "figure::label uses figure::pen uses figure::paper uses figure::label";
            let line = if text.starts_with('\n') { 2 } else { 1 };
            assert_eq!(found, [(line, circle.to_owned())], "{text}");
        }
    }

    #[test]
    fn what_stands_above_or_is_for_tests_closes_none() {
        let found = in_crate(&[
            ("lib.rs", "mod figure; fn draw() { figure::draw() }"),
            (
                "figure/mod.rs",
                "mod pen; mod label; pub fn draw() { pen::draw(INK); label::write() }",
            ),
            ("figure/label.rs", "use super::pen::draw; use super::INK;"),
            (
                "figure/pen.rs",
                "use super::INK; #[cfg(test)] mod tests { use super::super::label::x; }",
            ),
        ]);
        assert_eq!(found, []);
    }
}
