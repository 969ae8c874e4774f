//! Limits on the size of files and functions.

use syn::visit::{self, Visit};
use syn::{Block, FnArg, ImplItemFn, ItemFn, Signature, TraitItemFn};

use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "sizes",
    demand: "a file has at most 600 lines, a function 80 lines and five arguments besides self",
    check,
};

const FILE_LINES: usize = 600;
const FUNCTION_LINES: usize = 80;
const ARGUMENTS: usize = 5;

fn check(sources: &[Source]) -> Vec<Finding> {
    sources.iter().flat_map(check_file).collect()
}

fn check_file(source: &Source) -> Vec<Finding> {
    let mut findings = Vec::new();
    let length = source.text.lines().count();
    if length > FILE_LINES {
        findings.push(source.finding(1, format!("{length} lines, at most {FILE_LINES}")));
    }
    for Function { name, line, lines, arguments } in functions(source) {
        if lines > FUNCTION_LINES {
            let what = format!("`{name}` has {lines} lines, at most {FUNCTION_LINES}");
            findings.push(source.finding(line, what));
        }
        if arguments > ARGUMENTS {
            let what = format!("`{name}` has {arguments} arguments, at most {ARGUMENTS}");
            findings.push(source.finding(line, what));
        }
    }
    findings
}

/// A line with the median length of files and functions.
pub fn medians(sources: &[Source]) -> String {
    let files = median(sources.iter().map(|source| source.text.lines().count()).collect());
    let bodies = sources.iter().flat_map(functions).map(|function| function.lines);
    let functions = median(bodies.collect());
    let count = sources.len();
    format!("{count} files; median length: file {files} lines, function {functions} lines")
}

/// The middle value, the lower one of two.
fn median(mut lengths: Vec<usize>) -> usize {
    lengths.sort_unstable();
    lengths.get(lengths.len().saturating_sub(1) / 2).copied().unwrap_or(0)
}

struct Function {
    name: String,
    line: usize,
    /// From its `fn` to its last brace.
    lines: usize,
    /// Without `self`.
    arguments: usize,
}

fn functions(source: &Source) -> Vec<Function> {
    let mut functions = Functions(Vec::new());
    functions.visit_file(&source.file);
    functions.0
}

struct Functions(Vec<Function>);

impl Functions {
    fn note(&mut self, signature: &Signature, body: Option<&Block>) {
        let line = signature.fn_token.span.start().line;
        let end = body.map_or(line, |body| body.brace_token.span.close().end().line);
        let named = signature.inputs.iter().filter(|input| matches!(input, FnArg::Typed(_)));
        self.0.push(Function {
            name: signature.ident.to_string(),
            line,
            lines: end - line + 1,
            arguments: named.count(),
        });
    }
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.note(&item.sig, Some(&item.block));
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.note(&item.sig, Some(&item.block));
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        self.note(&item.sig, item.default.as_ref());
        visit::visit_trait_item_fn(self, item);
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    const FILE: &str = "crates/schlupf-case/src/a.rs";

    #[test]
    fn files_and_functions_are_small() {
        assert_holds(&RULE);
        println!("{}", medians(&super::super::tree::load(&crate::workspace()).unwrap()));
    }

    #[test]
    fn the_limits_are_legal_and_one_more_is_not() {
        let function = |lines: usize| format!("fn a() {{{}}}", "\n".repeat(lines - 1));
        assert_eq!(lines(&RULE, FILE, &function(80)), []);
        assert_eq!(lines(&RULE, FILE, &function(81)), [1]);
        assert_eq!(lines(&RULE, FILE, &"\n".repeat(600)), []);
        assert_eq!(lines(&RULE, FILE, &"\n".repeat(601)), [1]);
        let five = "impl A { fn a(&self, a: A, b: B, c: C, d: D, e: E) {} }";
        assert_eq!(lines(&RULE, FILE, five), []);
        assert_eq!(lines(&RULE, FILE, "\nfn a(a: A, b: B, c: C, d: D, e: E, f: F) {}"), [2]);
    }

    #[test]
    fn the_median_is_the_middle() {
        assert_eq!(median(vec![3, 1, 2]), 2);
        assert_eq!(median(vec![4, 1, 2, 3]), 2);
        assert_eq!(median(Vec::new()), 0);
    }
}
