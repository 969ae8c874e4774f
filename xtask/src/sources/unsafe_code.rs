//! The crates that need no unsafe code cannot have any.

use syn::{AttrStyle, Meta};

use super::syntax::has_ident;
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule =
    Rule { name: "unsafe code", demand: "core, case and output forbid unsafe code", check };

const ROOTS: [&str; 3] = [
    "crates/schlupf/src/lib.rs",
    "crates/schlupf-case/src/lib.rs",
    "crates/schlupf-output/src/lib.rs",
];

fn check(sources: &[Source]) -> Vec<Finding> {
    let roots = sources.iter().filter(|source| ROOTS.contains(&source.path.as_str()));
    let open = roots.filter(|source| !forbids_unsafe_code(source));
    open.map(|source| source.finding(1, "no `#![forbid(unsafe_code)]`")).collect()
}

fn forbids_unsafe_code(source: &Source) -> bool {
    source.file.attrs.iter().any(|attribute| match (&attribute.style, &attribute.meta) {
        (AttrStyle::Inner(_), Meta::List(list)) => {
            list.path.is_ident("forbid") && has_ident(list.tokens.clone(), "unsafe_code")
        }
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    #[test]
    fn core_case_and_output_forbid_unsafe_code() {
        assert_holds(&RULE);
        let sources = super::super::tree::load(&crate::workspace()).unwrap();
        for root in ROOTS {
            assert!(sources.iter().any(|source| source.path == root), "{root} is missing");
        }
    }

    #[test]
    fn only_forbidding_is_enough() {
        assert_eq!(lines(&RULE, ROOTS[0], "//! A.\n#![forbid(unsafe_code)]"), []);
        assert_eq!(lines(&RULE, ROOTS[0], "#![deny(unsafe_code)]"), [1]);
    }
}
