//! Nothing is left to be done later.

use std::ops::Range;

use proc_macro2::{TokenStream, TokenTree};

use super::syntax::{flatten, is_punct, line};
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule =
    Rule { name: "loose ends", demand: "no TODO, FIXME or XXX in a comment and no dbg!", check };

const WORDS: [&str; 3] = ["TODO", "FIXME", "XXX"];

fn check(sources: &[Source]) -> Vec<Finding> {
    sources.iter().flat_map(check_file).collect()
}

fn check_file(source: &Source) -> Vec<Finding> {
    // It has been parsed before.
    let tokens = flatten(source.text.parse::<TokenStream>().unwrap_or_default());
    let mut findings: Vec<Finding> = comments(&source.text, &tokens)
        .into_iter()
        .flat_map(|comment| words(source, comment))
        .collect();
    for (i, token) in tokens.iter().enumerate() {
        let is_debug = matches!(token, TokenTree::Ident(name) if name == "dbg");
        if is_debug && is_punct(tokens.get(i + 1), '!') {
            findings.push(source.finding(line(token), "`dbg!`"));
        }
    }
    findings.sort_by_key(|finding| finding.line);
    findings
}

fn words(source: &Source, comment: Range<usize>) -> Vec<Finding> {
    let first = source.text[..comment.start].matches('\n').count() + 1;
    let mut findings = Vec::new();
    for (i, text) in source.text[comment].split('\n').enumerate() {
        let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
        if let Some(word) = words.find(|word| WORDS.contains(word)) {
            findings.push(source.finding(first + i, format!("`{word}`")));
        }
    }
    findings
}

/// Where the comments are: between the tokens, except that a doc comment is a `#` as long as the
/// comment.
fn comments(text: &str, tokens: &[TokenTree]) -> Vec<Range<usize>> {
    let mut comments = Vec::new();
    let mut end = 0;
    for token in tokens {
        let span = match token {
            TokenTree::Group(group) => group.span_open(),
            token => token.span(),
        };
        let range = span.byte_range();
        if range.start > end {
            comments.push(end..range.start);
        }
        if is_punct(Some(token), '#') && range.len() > 1 {
            comments.push(range.clone());
        }
        end = end.max(range.end);
    }
    comments.push(end..text.len());
    comments
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, lines};
    use super::*;

    #[test]
    fn nothing_is_left_to_be_done_later() {
        assert_holds(&RULE);
    }

    #[test]
    fn comments_of_all_kinds_are_read_and_strings_are_not() {
        let text = "//! TODO\n/// µ FIXME: a\nfn a() { // XXX\n\n/* µ\n TODO */ b(\"// TODO\", r#\"/* XXX\"#);\n\
                    dbg!(1);\n// TODOS\n}\n// FIXME";
        assert_eq!(lines(&RULE, "crates/schlupf/tests/a.rs", text), [1, 2, 3, 6, 7, 10]);
    }
}
