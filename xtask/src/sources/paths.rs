//! The paths that a file names, relative to the root of its crate.

use proc_macro2::TokenTree;
use syn::visit::{self, Visit};
use syn::{Ident, ImplItem, Item, ItemMod, ItemUse, Macro, UseTree, Visibility};

use super::syntax::{flatten, is_punct, is_test_impl_item, is_test_item};

/// A path from the root of the crate. One that begins with a plain name is assumed to begin in its
/// module, whether it does or not.
pub struct Path {
    /// Its segments.
    pub names: Vec<String>,
    /// Its line.
    pub line: usize,
    /// The name under which a `pub use` re-exports it.
    pub export: Option<String>,
}

/// The module of a file at a path below `src/`.
pub fn module_of(path: &str) -> Vec<String> {
    let mut module: Vec<String> =
        path.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if module.last().is_some_and(|last| matches!(last.as_str(), "mod" | "lib" | "main")) {
        module.pop();
    }
    module
}

/// The paths among the items of a module, without those of its tests.
pub fn named_paths(items: &[Item], module: &[String]) -> Vec<Path> {
    let mut visitor = Visitor { module: module.to_vec(), named: Vec::new() };
    for item in items {
        visitor.visit_item(item);
    }
    visitor.named
}

struct Visitor {
    /// The current module.
    module: Vec<String>,
    named: Vec<Path>,
}

/// Segments of a path as written, with their lines.
type Segments = Vec<(String, usize)>;

impl Visitor {
    fn note(&mut self, path: &[(String, usize)], export: Option<String>) {
        let Some(&(ref first, line)) = path.first() else { return };
        let climbed = path.iter().take_while(|(name, _)| name == "super").count();
        let (home, rest) = match first.as_str() {
            "crate" => (&[][..], &path[1..]),
            "self" => (&self.module[..], &path[1..]),
            _ if climbed > self.module.len() => return,
            _ => (&self.module[..self.module.len() - climbed], &path[climbed..]),
        };
        let names = home.iter().chain(rest.iter().map(|(name, _)| name)).cloned().collect();
        self.named.push(Path { names, line, export });
    }

    /// The paths of a `use`, each with the name that it introduces.
    fn note_tree(&mut self, tree: &UseTree, before: &mut Segments, is_export: bool) {
        let (last, name) = match tree {
            UseTree::Path(path) => {
                before.push(segment(&path.ident));
                self.note_tree(&path.tree, before, is_export);
                before.pop();
                return;
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.note_tree(tree, before, is_export);
                }
                return;
            }
            UseTree::Name(name) => (segment(&name.ident), name.ident.to_string()),
            UseTree::Rename(name) => (segment(&name.ident), name.rename.to_string()),
            UseTree::Glob(glob) => {
                (("*".to_owned(), glob.star_token.span.start().line), "*".to_owned())
            }
        };
        let path = [before.as_slice(), &[last]].concat();
        self.note(&path, is_export.then_some(name));
    }
}

fn segment(ident: &Ident) -> (String, usize) {
    (ident.to_string(), ident.span().start().line)
}

impl<'ast> Visit<'ast> for Visitor {
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
        let is_export = !matches!(item.vis, Visibility::Inherited);
        self.note_tree(&item.tree, &mut Vec::new(), is_export);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let segments: Segments = path.segments.iter().map(|part| segment(&part.ident)).collect();
        self.note(&segments, None);
        visit::visit_path(self, path);
    }

    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_macro(&mut self, call: &'ast Macro) {
        let tokens = flatten(call.tokens.clone());
        for path in paths_among(&tokens) {
            self.note(&path, None);
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
