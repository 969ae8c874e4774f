//! Copies the gallery of cases to where maturin takes it into the wheel: `schlupf.examples`.

use std::env;
use std::fs;
use std::io;
use std::path::Path;

fn main() -> io::Result<()> {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    println!("cargo::rerun-if-changed={}", gallery.display());
    let Some(output) = env::var_os("OUT_DIR") else { return Err(io::ErrorKind::NotFound.into()) };
    let copies = Path::new(&output).join("cases");
    // Without those of cases that are gone.
    if copies.exists() {
        fs::remove_dir_all(&copies)?;
    }
    fs::create_dir_all(&copies)?;
    for entry in fs::read_dir(gallery)? {
        let path = entry?.path();
        let is_pinned = path.to_string_lossy().ends_with(".expected.json");
        if let Some(name) = path.file_name().filter(|_| !is_pinned) {
            fs::copy(&path, copies.join(name))?;
        }
    }
    Ok(())
}
