//! The modules of the core stand in the order in which data flows.

use proc_macro2::TokenTree;
use syn::visit::{self, Visit};
use syn::{Ident, ImplItem, Item, ItemMod, ItemUse, Macro, Path, UseTree};

use super::syntax::{flatten, is_punct, is_test_impl_item, is_test_item};
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "module order",
    demand: "a module of the core, and of its rolling, uses only what is named above it",
    check,
};

const CORE: &str = "crates/schlupf/src/";

/// The folders of the core whose modules stand in order, each with the file that names them.
const ORDERED: [(&str, &str); 5] = [
    ("", "lib.rs"),
    ("rolling/", "mod.rs"),
    ("rolling/shared/", "mod.rs"),
    ("rolling/marching/", "mod.rs"),
    ("rolling/steady/", "mod.rs"),
];

fn check(sources: &[Source]) -> Vec<Finding> {
    ORDERED.iter().flat_map(|(folder, root)| check_folder(sources, folder, root)).collect()
}

fn check_folder(sources: &[Source], folder: &str, root: &str) -> Vec<Finding> {
    let root = format!("{CORE}{folder}{root}");
    let Some(named) = sources.iter().find(|source| source.path == root) else {
        return Vec::new();
    };
    let root = Root::read(named, folder);
    // The root itself stands for all modules: it only names them and re-exports.
    let modules = sources.iter().filter(|source| !source.for_tests && source.path != named.path);
    modules.flat_map(|source| check_file(source, &root)).collect()
}

fn check_file(source: &Source, root: &Root) -> Vec<Finding> {
    let Some(file) = source.path.strip_prefix(CORE) else { return Vec::new() };
    let mut module: Vec<String> =
        file.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if module.last().is_some_and(|last| last == "mod") {
        module.pop();
    }
    let below = module.strip_prefix(root.path.as_slice());
    let Some(top) = below.and_then(|below| below.first()).cloned() else { return Vec::new() };
    let Some(position) = root.position(&top) else { return Vec::new() };
    let mut uses = Uses { module, named: Vec::new() };
    uses.visit_file(&source.file);
    let named = uses.named.into_iter().filter_map(|(path, line)| {
        let name = path.strip_prefix(root.path.as_slice())?.first()?.clone();
        Some((name, line))
    });
    let wrong = named.filter_map(|(name, line)| {
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

/// What lib.rs or mod.rs says: the modules in their order and whose items it re-exports.
struct Root {
    /// The module that it is.
    path: Vec<String>,
    modules: Vec<String>,
    /// Name at the root, module it comes from.
    exports: Vec<(String, String)>,
}

impl Root {
    fn read(source: &Source, folder: &str) -> Self {
        let path = folder.split_terminator('/').map(str::to_owned).collect();
        let mut root = Self { path, modules: Vec::new(), exports: Vec::new() };
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

/// Collects what a file names in the crate.
struct Uses {
    /// The present module.
    module: Vec<String>,
    /// Paths from the root of the crate, and lines.
    named: Vec<(Vec<String>, usize)>,
}

impl Uses {
    fn note(&mut self, path: &[(String, usize)]) {
        let path = match path {
            [(first, _), rest @ ..] if first == "self" => rest,
            _ => path,
        };
        let climbed = path.iter().take_while(|(name, _)| name == "super").count();
        let (start, below) = match path {
            [(first, _), rest @ ..] if first == "crate" => (0, rest),
            _ if climbed > 0 && climbed <= self.module.len() => {
                (self.module.len() - climbed, &path[climbed..])
            }
            _ => return,
        };
        let Some((_, line)) = below.first() else { return };
        let own = self.module[..start].iter().cloned();
        self.named.push((own.chain(below.iter().map(|(name, _)| name.clone())).collect(), *line));
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
        self.module.push(module.ident.to_string());
        visit::visit_item_mod(self, module);
        self.module.pop();
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

    /// Inside a folder that is ordered, too: by any of the ways.
    #[test]
    fn a_folder_has_its_own_order() {
        let root = ("crates/schlupf/src/rolling/mod.rs", "mod shared;\nmod steady;");
        let of =
            |text| found(&RULE, &[ROOT, root, ("crates/schlupf/src/rolling/shared/a.rs", text)]);
        assert_eq!(
            of("use super::b::B;\nuse crate::heat::Heat;\nuse crate::rolling::shared::b;"),
            []
        );
        for text in ["use super::super::steady::A;", "use crate::rolling::steady::A;"] {
            let message = "`shared` uses `steady`, which stands below it".to_owned();
            assert_eq!(of(text), [(1, message)], "{text}");
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
