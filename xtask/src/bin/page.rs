//! Parts of `cargo xtask web` that take crates of their own: `bindings MODULE FOLDER` makes the
//! JavaScript of a WebAssembly module, `pack FOLDER ARCHIVE` puts a page into an archive.

use std::error::Error;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use wasm_bindgen_cli_support::Bindgen;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["bindings", module, folder] => bindings(module, folder),
        ["pack", folder, archive] => Ok(pack(Path::new(folder), Path::new(archive))?),
        _ => Err("usage: bindings MODULE FOLDER, or pack FOLDER ARCHIVE".into()),
    }
}

fn bindings(module: &str, folder: &str) -> Result<(), Box<dyn Error>> {
    let mut bindgen = Bindgen::new();
    bindgen.input_path(module).remove_name_section(true).remove_producers_section(true);
    Ok(bindgen.web(true)?.typescript(true).generate(folder)?)
}

fn pack(folder: &Path, archive: &Path) -> io::Result<()> {
    let part = archive.with_extension("part");
    let mut writer = ZipWriter::new(File::create(&part)?);
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        let mut paths = fs::read_dir(&next)?.map(|entry| Ok(entry?.path()));
        let mut paths: Vec<_> = paths.by_ref().collect::<io::Result<_>>()?;
        paths.sort();
        for path in paths {
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(folder).map_err(io::Error::other)?;
            let name = name.to_string_lossy().replace('\\', "/");
            writer.start_file(name, SimpleFileOptions::default())?;
            writer.write_all(&fs::read(&path)?)?;
        }
    }
    writer.finish()?;
    fs::rename(part, archive)
}
