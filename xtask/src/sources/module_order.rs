//! The modules of the core stand in the order in which data flows.

use proc_macro2::TokenTree;
use syn::visit::{self, Visit};
use syn::{Ident, ImplItem, Item, ItemMod, ItemUse, Macro, Path, UseTree};

use super::syntax::{flatten, is_punct, is_test_impl_item, is_test_item};
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "module order",
    demand: "a module of the core uses only what stands above it in lib.rs",
    check,
};

const CORE: &str = "crates/schlupf/src/";

fn check(sources: &[Source]) -> Vec<Finding> {
    let Some(root) = sources.iter().find(|source| source.path == format!("{CORE}lib.rs")) else {
        return Vec::new();
    };
    let root = Root::read(root);
    let modules = sources.iter().filter(|source| !source.for_tests);
    modules.flat_map(|source| check_file(source, &root)).collect()
}

fn check_file(source: &Source, root: &Root) -> Vec<Finding> {
    let Some(file) = source.path.strip_prefix(CORE) else { return Vec::new() };
    let mut module: Vec<&str> = file.trim_end_matches(".rs").split('/').collect();
    if module.last() == Some(&"mod") {
        module.pop();
    }
    // The root itself stands for all modules: it only names them and re-exports.
    let Some(&top) = module.first().filter(|&&top| top != "lib") else { return Vec::new() };
    let Some(position) = root.position(top) else { return Vec::new() };
    let mut uses = Uses { depth: module.len(), named: Vec::new() };
    uses.visit_file(&source.file);
    let wrong = uses.named.into_iter().filter_map(|(name, line)| {
        let module = root.module_of(&name);
        match root.position(module) {
            Some(used) if used <= position => None,
            Some(_) => Some(
                source.finding(line, format!("`{top}` uses `{module}`, which stands below it")),
            ),
            None => Some(source.finding(line, format!("`crate::{name}` does not name its module"))),
        }
    });
    wrong.collect()
}

/// What lib.rs says: the modules in their order and whose items it re-exports.
struct Root {
    modules: Vec<String>,
    /// Name at the root, module it comes from.
    exports: Vec<(String, String)>,
}

impl Root {
    fn read(source: &Source) -> Self {
        let mut root = Self { modules: Vec::new(), exports: Vec::new() };
        for item in source.file.items.iter().filter(|item| !is_test_item(item)) {
            match item {
                Item::Mod(module) => root.modules.push(module.ident.to_string()),
                Item::Use(export) => root.exports.extend(exports(export)),
                _ => {}
            }
        }
        root
    }

    fn position(&self, module: &str) -> Option<usize> {
        self.modules.iter().position(|other| other == module)
    }

    /// The module behind a name at the root.
    fn module_of<'a>(&'a self, name: &'a str) -> &'a str {
        self.exports.iter().find(|(export, _)| export == name).map_or(name, |(_, module)| module)
    }
}

fn exports(item: &ItemUse) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    spread(&item.tree, &mut Vec::new(), &mut paths);
    let named = paths.into_iter().filter_map(|path| {
        let module = path.iter().find(|(name, _)| name != "crate" && name != "self")?;
        Some((path.last()?.0.clone(), module.0.clone()))
    });
    named.collect()
}

/// Segments of a path with their lines.
type Segments = Vec<(String, usize)>;

fn segment(ident: &Ident) -> (String, usize) {
    (ident.to_string(), ident.span().start().line)
}

/// The paths of a `use`, each from its beginning; a renamed one ends in its new name.
fn spread(tree: &UseTree, before: &mut Segments, paths: &mut Vec<Segments>) {
    match tree {
        UseTree::Path(path) => {
            before.push(segment(&path.ident));
            spread(&path.tree, before, paths);
            before.pop();
        }
        UseTree::Group(group) => {
            for tree in &group.items {
                spread(tree, before, paths);
            }
        }
        UseTree::Name(name) => paths.push([before.as_slice(), &[segment(&name.ident)]].concat()),
        UseTree::Rename(name) => {
            let ends = [segment(&name.ident), segment(&name.rename)];
            paths.push([before.as_slice(), &ends].concat());
        }
        UseTree::Glob(glob) => {
            let star = ("*".to_owned(), glob.star_token.span.start().line);
            paths.push([before.as_slice(), &[star]].concat());
        }
    }
}

/// Collects what a file names at the root of the crate.
struct Uses {
    /// How deep the present module lies below the root.
    depth: usize,
    /// Name and line.
    named: Vec<(String, usize)>,
}

impl Uses {
    fn note(&mut self, path: &[(String, usize)]) {
        let path = match path {
            [(first, _), rest @ ..] if first == "self" => rest,
            _ => path,
        };
        let climbed = path.iter().take_while(|(name, _)| name == "super").count();
        let below = match path {
            [(first, _), rest @ ..] if first == "crate" => rest,
            _ if climbed > 0 && climbed == self.depth => &path[climbed..],
            _ => return,
        };
        self.named.extend(below.first().cloned());
    }
}

impl<'ast> Visit<'ast> for Uses {
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

    fn visit_item_mod(&mut self, module: &'ast ItemMod) {
        self.depth += 1;
        visit::visit_item_mod(self, module);
        self.depth -= 1;
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        let mut paths = Vec::new();
        spread(&item.tree, &mut Vec::new(), &mut paths);
        for path in paths {
            self.note(&path);
        }
    }

    fn visit_path(&mut self, path: &'ast Path) {
        let segments: Segments = path.segments.iter().map(|part| segment(&part.ident)).collect();
        self.note(&segments);
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        let tokens = flatten(call.tokens.clone());
        for path in paths_among(&tokens) {
            self.note(&path);
        }
        visit::visit_macro(self, call);
    }
}

/// The paths among the tokens of a macro call, which has no syntax tree.
fn paths_among(tokens: &[TokenTree]) -> Vec<Segments> {
    let mut paths = Vec::new();
    let mut path = Segments::new();
    for (i, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Ident(ident) => {
                if !(i > 0 && is_punct(tokens.get(i - 1), ':')) {
                    paths.push(std::mem::take(&mut path));
                }
                path.push(segment(ident));
            }
            TokenTree::Punct(punct) if punct.as_char() == ':' => {}
            _ => paths.push(std::mem::take(&mut path)),
        }
    }
    paths.push(path);
    paths
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, found};
    use super::*;

    const ROOT: (&str, &str) = (
        "crates/schlupf/src/lib.rs",
        "pub mod material;\npub mod grid;\npub mod heat;\npub use heat::{Heat, Rise as Flash};",
    );

    fn in_grid(text: &str) -> Vec<(usize, String)> {
        found(&RULE, &[ROOT, ("crates/schlupf/src/grid/cells.rs", text)])
    }

    #[test]
    fn the_core_keeps_the_order_of_data_flow() {
        assert_holds(&RULE);
    }

    #[test]
    fn what_stands_above_and_the_module_itself_may_be_used() {
        assert_eq!(
            in_grid("use crate::material::Body;\nuse crate::grid::Strip;\nuse super::X;"),
            []
        );
    }

    #[test]
    fn every_way_of_naming_a_later_module_is_found() {
        for text in [
            "use crate::heat::Heat;",
            "use crate::{material::Body, heat};",
            "use crate::Flash;",
            "use super::super::heat::Heat;",
            "fn a() -> crate::heat::Heat { b() }",
            "fn a() { println!(\"{}\", crate::heat::rise(1)); }",
            "mod inner { use super::super::super::heat; }",
        ] {
            let message = "`grid` uses `heat`, which stands below it".to_owned();
            assert_eq!(in_grid(text), [(1, message)], "{text}");
        }
    }

    #[test]
    fn a_name_without_a_module_is_refused() {
        let message = "`crate::*` does not name its module".to_owned();
        assert_eq!(in_grid("use crate::*;"), [(1, message)]);
    }

    #[test]
    fn tests_may_use_anything() {
        assert_eq!(in_grid("#[cfg(test)]\nmod tests { use crate::heat::Heat; }"), []);
    }
}
