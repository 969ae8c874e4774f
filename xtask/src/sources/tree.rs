//! The sources of the workspace, read and parsed.

use std::fs;
use std::path::{Path, PathBuf};

use syn::Item;

use super::Finding;
use super::syntax::is_for_tests;

/// A source file.
pub struct Source {
    /// Path from the root of the workspace, with slashes.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Its syntax tree.
    pub file: syn::File,
    /// Whether it is compiled for tests, examples and benchmarks only.
    pub for_tests: bool,
}

impl Source {
    /// Parses `text`, which belongs to the file at `path`.
    pub fn parse(path: &str, text: String) -> Result<Self, String> {
        let file = syn::parse_file(&text)
            .map_err(|error| format!("{path}:{}: {error}", error.span().start().line))?;
        let for_tests = !path.split('/').any(|folder| folder == "src");
        Ok(Self { path: path.to_owned(), text, file, for_tests })
    }

    /// A finding in this file.
    pub fn finding(&self, line: usize, what: impl Into<String>) -> Finding {
        Finding { path: self.path.clone(), line, what: what.into() }
    }

    /// The module files that are compiled for tests only, as paths without extension.
    fn test_modules(&self) -> Vec<String> {
        let stem = self.path.trim_end_matches(".rs");
        let (folder, name) = stem.rsplit_once('/').unwrap_or(("", stem));
        let home = if matches!(name, "lib" | "main" | "mod") { folder } else { stem };
        let modules = self.file.items.iter().filter_map(|item| match item {
            Item::Mod(module) if module.content.is_none() && is_for_tests(&module.attrs) => {
                Some(format!("{home}/{}", module.ident))
            }
            _ => None,
        });
        modules.collect()
    }
}

/// Reads every source of the workspace, in the order of the paths.
pub fn load(workspace: &Path) -> Result<Vec<Source>, String> {
    let mut packages = entries(&workspace.join("crates"))?;
    packages.push(workspace.join("xtask"));
    let mut paths = Vec::new();
    for package in packages {
        for part in ["benches", "build.rs", "examples", "src", "tests"] {
            collect(&package.join(part), &mut paths)?;
        }
    }
    let mut sources = paths
        .iter()
        .map(|path| {
            let text = fs::read_to_string(path).map_err(|error| explain(path, &error))?;
            let relative = path.strip_prefix(workspace).unwrap_or(path);
            let folders: Vec<_> =
                relative.iter().map(|folder| folder.to_string_lossy().into_owned()).collect();
            Source::parse(&folders.join("/"), text)
        })
        .collect::<Result<Vec<_>, _>>()?;
    mark_test_modules(&mut sources);
    Ok(sources)
}

/// A module behind `#[cfg(test)]` may be in its own file, with files below it.
fn mark_test_modules(sources: &mut [Source]) {
    let modules: Vec<String> = sources.iter().flat_map(Source::test_modules).collect();
    for source in sources {
        source.for_tests |= modules.iter().any(|module| {
            let rest = source.path.strip_prefix(module);
            rest.is_some_and(|rest| rest == ".rs" || rest.starts_with('/'))
        });
    }
}

/// The Rust files at or below a path, which need not exist.
fn collect(path: &Path, files: &mut Vec<PathBuf>) -> Result<(), String> {
    if path.is_dir() {
        for entry in entries(path)? {
            collect(&entry, files)?;
        }
    } else if path.is_file() && path.extension().is_some_and(|extension| extension == "rs") {
        files.push(path.to_owned());
    }
    Ok(())
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut paths = fs::read_dir(folder)
        .and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>, _>>())
        .map_err(|error| explain(folder, &error))?;
    paths.sort();
    Ok(paths)
}

fn explain(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {error}", path.display())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_test_module_in_its_own_file_counts_as_test() {
        let parse = |path, text: &str| Source::parse(path, text.to_owned()).unwrap();
        let mut sources = [
            parse("crates/a/src/grid.rs", "#[cfg(test)] mod tests; mod cells;"),
            parse("crates/a/src/grid/tests.rs", ""),
            parse("crates/a/src/grid/cells.rs", ""),
            parse("crates/a/tests/grid.rs", ""),
        ];
        mark_test_modules(&mut sources);
        assert_eq!(sources.map(|source| source.for_tests), [false, true, false, true]);
    }

    #[test]
    fn the_workspace_is_found() {
        let sources = load(&crate::workspace()).unwrap();
        assert!(sources.iter().any(|source| source.path == "crates/schlupf/src/lib.rs"));
        assert!(sources.iter().any(|source| source.path == "xtask/src/main.rs"));
    }

    #[test]
    fn a_file_that_does_not_parse_is_named_with_its_line() {
        let error = Source::parse("a.rs", "fn a() {}\nfn {}".to_owned()).err().unwrap();
        assert!(error.starts_with("a.rs:2: "), "{error}");
    }
}
