//! No deliberate panic is reachable by a user.

use syn::visit::{self, Visit};
use syn::{ExprMethodCall, ExprPath, Ident, ImplItem, Item, Macro};

use super::syntax::{flatten, is_punct, is_test_impl_item, is_test_item, line};
use super::tree::Source;
use super::{Finding, Rule};
use proc_macro2::TokenTree;

pub const RULE: Rule =
    Rule { name: "panics", demand: "outside of tests an error is returned, never a panic", check };

const METHODS: [&str; 2] = ["unwrap", "expect"];
const MACROS: [&str; 4] = ["panic", "todo", "unimplemented", "unreachable"];

fn check(sources: &[Source]) -> Vec<Finding> {
    let shipped = sources.iter().filter(|source| !source.for_tests);
    let findings = shipped.flat_map(|source| {
        let mut panics = Panics(Vec::new());
        panics.visit_file(&source.file);
        panics.0.into_iter().map(|(line, what)| source.finding(line, what))
    });
    findings.collect()
}

/// Line and what was found there.
struct Panics(Vec<(usize, String)>);

impl Panics {
    fn method(&mut self, name: &Ident) {
        if METHODS.iter().any(|method| name == method) {
            self.0.push((name.span().start().line, format!("`{name}(`")));
        }
    }

    /// The tokens of a macro call have no syntax tree.
    fn tokens(&mut self, tokens: &[TokenTree]) {
        for (i, token) in tokens.iter().enumerate() {
            let TokenTree::Ident(name) = token else { continue };
            let after_dot = i > 0 && is_punct(tokens.get(i - 1), '.');
            if after_dot {
                self.method(name);
            } else if is_punct(tokens.get(i + 1), '!') && MACROS.iter().any(|word| name == word) {
                self.0.push((line(token), format!("`{name}!`")));
            }
        }
    }
}

impl<'ast> Visit<'ast> for Panics {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_test_item(item) {
            visit::visit_item(self, item);
        }
    }

    fn visit_impl_item(&mut self, item: &'ast ImplItem) {
        if !is_test_impl_item(item) {
            visit::visit_impl_item(self, item);
        }
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        self.method(&call.method);
        visit::visit_expr_method_call(self, call);
    }

    /// `Option::unwrap` as a function.
    fn visit_expr_path(&mut self, path: &'ast ExprPath) {
        if let Some(last) = path.path.segments.last().filter(|_| path.path.segments.len() > 1) {
            self.method(&last.ident);
        }
        visit::visit_expr_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        if let Some(name) = call.path.segments.last().map(|segment| &segment.ident)
            && MACROS.iter().any(|word| name == word)
        {
            self.0.push((name.span().start().line, format!("`{name}!`")));
        }
        self.tokens(&flatten(call.tokens.clone()));
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    #[test]
    fn nothing_outside_of_tests_panics_on_purpose() {
        assert_holds(&RULE);
    }

    #[test]
    fn every_form_is_found_outside_of_tests_only() {
        let text = "fn a() {
            b.unwrap();
            b.expect(\"c\");
            panic!();
            std::unreachable!(\"{}\", 1);
            println!(\"{}\", b.unwrap());
            println!(\"{}\", if b { todo!() } else { 1 });
            b.map(Option::unwrap);
            b.unwrap_or(1);
            let unwrap = \"unwrap()\"; // unwrap()
        }
        #[cfg(test)] mod tests { fn a() { b.unwrap(); } }
        #[test] fn c() { b.unwrap(); }";
        let file = "crates/schlupf-cli/src/a.rs";
        assert_eq!(lines(&RULE, file, text), [2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(lines(&RULE, "crates/schlupf-cli/tests/a.rs", text), []);
    }
}
