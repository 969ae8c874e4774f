//! The modules of the core are listed in the order of data flow.

use syn::Item;

use super::paths::{Path, module_of, named_paths};
use super::syntax::is_test_item;
use super::tree::Source;
use super::{Finding, Rule};

pub const RULE: Rule = Rule {
    name: "module order",
    demand: "a module of the core uses only what is named above it",
    check,
};

const CORE: &str = "crates/schlupf/src/";

fn check(sources: &[Source]) -> Vec<Finding> {
    let core = sources.iter().filter_map(|source| source.path.strip_prefix(CORE));
    let lists = core.filter_map(|path| {
        let folder = path.strip_suffix("mod.rs").or_else(|| path.strip_suffix("lib.rs"))?;
        Some((folder, path.strip_prefix(folder)?))
    });
    lists.flat_map(|(folder, root)| check_folder(sources, folder, root)).collect()
}

fn check_folder(sources: &[Source], folder: &str, root: &str) -> Vec<Finding> {
    let root = format!("{CORE}{folder}{root}");
    let Some(named) = sources.iter().find(|source| source.path == root) else {
        return Vec::new();
    };
    let root = Root::read(named, folder);
    // The root itself represents all modules: it only lists them and re-exports.
    let modules = sources.iter().filter(|source| !source.for_tests && source.path != named.path);
    modules.flat_map(|source| check_file(source, &root)).collect()
}

fn check_file(source: &Source, root: &Root) -> Vec<Finding> {
    let Some(module) = source.path.strip_prefix(CORE).map(module_of) else { return Vec::new() };
    // The root itself represents all modules: it only lists them and re-exports.
    let below = module.strip_prefix(root.path.as_slice());
    let Some(top) = below.and_then(|below| below.first()) else { return Vec::new() };
    let Some(position) = root.position(top) else { return Vec::new() };
    let wrong = named_paths(&source.file.items, &module).into_iter().filter_map(
        |Path { names, line, .. }| {
            let name = names.strip_prefix(root.path.as_slice())?.first()?;
            let module = root.module_of(name);
            match root.position(module) {
                Some(used) if used <= position => None,
                Some(_) => Some(
                    source.finding(line, format!("`{top}` uses `{module}`, which stands below it")),
                ),
                // An item of the file that lists the modules, or the macro.
                None if !root.path.is_empty() || name == "columns" => None,
                None => {
                    Some(source.finding(line, format!("`crate::{name}` does not name its module")))
                }
            }
        },
    );
    wrong.collect()
}

/// The contents of lib.rs or mod.rs: the modules in their order, and whose items it re-exports.
struct Root {
    /// The module itself.
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
            if let Item::Mod(module) = item {
                root.modules.push(module.ident.to_string());
            }
        }
        let exports = named_paths(&source.file.items, &[]).into_iter();
        let exports = exports.filter(|path| path.export.is_some());
        root.exports =
            exports.filter_map(|path| Some((path.export?, path.names[0].clone()))).collect();
        root
    }

    fn position(&self, module: &str) -> Option<usize> {
        self.modules.iter().position(|other| other == module)
    }

    /// The module behind a name at the root; an item may have the name of a module, too.
    fn module_of<'a>(&'a self, name: &'a str) -> &'a str {
        if self.position(name).is_some() {
            return name;
        }
        self.exports.iter().find(|(export, _)| export == name).map_or(name, |(_, module)| module)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_holds, found};
    use super::*;

    const ROOT: (&str, &str) = (
        "crates/schlupf/src/lib.rs",
        "pub mod material;\npub mod grid;\npub mod heat;\npub mod solver;\npub use heat::{Heat, Rise as Flash};",
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

    /// Inside an ordered folder, too: by any of the paths.
    #[test]
    fn a_folder_has_its_own_order() {
        let root = ("crates/schlupf/src/solver/rolling/mod.rs", "mod shared;\nmod steady;");
        let of = |text| {
            found(&RULE, &[ROOT, root, ("crates/schlupf/src/solver/rolling/shared/a.rs", text)])
        };
        assert_eq!(
            of("use super::b::B;\nuse crate::heat::Heat;\nuse crate::solver::rolling::shared::b;"),
            []
        );
        for text in ["use super::super::steady::A;", "use crate::solver::rolling::steady::A;"] {
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
