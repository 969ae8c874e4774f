//! Every allowed lint needs a reason.

use syn::visit::{self, Visit};
use syn::{Attribute, Meta};

use super::syntax::has_ident;
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "allowances",
    demand: "`allow` and `expect` have a reason, or a comment above or behind them",
    check,
};

const WORDS: [&str; 2] = ["allow", "expect"];

fn check(sources: &[Source]) -> Vec<Finding> {
    let findings = sources.iter().flat_map(|source| {
        let lines: Vec<&str> = source.text.lines().collect();
        let mut allowances = Allowances(Vec::new());
        allowances.visit_file(&source.file);
        let bare = allowances.0.into_iter().filter(move |place| !has_comment(&lines, place));
        bare.map(|place| source.finding(place.first, "a lint is allowed without a reason"))
    });
    findings.collect()
}

/// Lines of an attribute, starting from 1, and the column after its end in the last line.
struct Place {
    first: usize,
    last: usize,
    end: usize,
}

fn has_comment(lines: &[&str], place: &Place) -> bool {
    let above =
        place.first.checked_sub(2).and_then(|i| lines.get(i)).map_or("", |line| line.trim());
    let is_doc = above.starts_with("///") || above.starts_with("//!");
    let behind: String =
        lines.get(place.last - 1).map_or("", |line| line).chars().skip(place.end).collect();
    (above.starts_with("//") && !is_doc) || behind.trim().starts_with("//")
}

struct Allowances(Vec<Place>);

impl<'ast> Visit<'ast> for Allowances {
    fn visit_attribute(&mut self, attribute: &'ast Attribute) {
        if let Meta::List(list) = &attribute.meta {
            let allows = WORDS.iter().any(|word| {
                list.path.is_ident(word)
                    || (list.path.is_ident("cfg_attr") && has_ident(list.tokens.clone(), word))
            });
            if allows && !has_ident(list.tokens.clone(), "reason") {
                let close = attribute.bracket_token.span.close().end();
                self.0.push(Place {
                    first: attribute.pound_token.span.start().line,
                    last: close.line,
                    end: close.column,
                });
            }
        }
        visit::visit_attribute(self, attribute);
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    #[test]
    fn every_allowance_has_a_reason() {
        assert_holds(&RULE);
    }

    #[test]
    fn a_reason_or_a_comment_is_needed_and_a_doc_comment_is_none() {
        let text = "#![allow(a)]
            #[allow(a, reason = \"b\")] fn a() {}
            // Because.
            #[allow(a)] fn b() {}
            #[allow(a)] // Because.
            fn c() {}
            /// Does.
            #[allow(a)] fn d() {}
            fn e() { #[expect(a)] let f = 1; }
            #[cfg_attr(test, allow(a))] fn g() {}";
        assert_eq!(lines(&RULE, "crates/schlupf/src/a.rs", text), [1, 8, 9, 10]);
    }
}
