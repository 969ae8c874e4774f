//! Queries of a syntax tree shared by several rules.

use proc_macro2::{TokenStream, TokenTree};
use syn::{Attribute, ImplItem, Item, Meta};

/// Whether attributes restrict an item to tests.
pub fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::Path(path) => path.is_ident("test"),
        Meta::List(list) => {
            let condition = list.tokens.clone();
            list.path.is_ident("cfg")
                && has_ident(condition.clone(), "test")
                && !has_ident(condition, "not")
        }
        Meta::NameValue(_) => false,
    })
}

/// Whether an item is compiled for tests only.
pub fn is_test_item(item: &Item) -> bool {
    is_for_tests(match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    })
}

/// Whether an item of an `impl` block is compiled for tests only.
pub fn is_test_impl_item(item: &ImplItem) -> bool {
    is_for_tests(match item {
        ImplItem::Const(item) => &item.attrs,
        ImplItem::Fn(item) => &item.attrs,
        ImplItem::Type(item) => &item.attrs,
        _ => &[],
    })
}

/// Whether a word occurs among the tokens, in groups as well.
fn has_ident(tokens: TokenStream, word: &str) -> bool {
    flatten(tokens).iter().any(|token| matches!(token, TokenTree::Ident(ident) if ident == word))
}

/// All tokens in the order of the text, a group before its content.
pub fn flatten(tokens: TokenStream) -> Vec<TokenTree> {
    let mut flat = Vec::new();
    for token in tokens {
        let content = match &token {
            TokenTree::Group(group) => flatten(group.stream()),
            _ => Vec::new(),
        };
        flat.push(token);
        flat.extend(content);
    }
    flat
}

/// Whether a token is this character of punctuation.
pub fn is_punct(token: Option<&TokenTree>, character: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == character)
}
