//! The C library as others find it: shared and static, headers, Fortran, pkg-config, CMake.

use std::fs;
use std::path::Path;

use crate::step::Step;

const PACKAGE: &str = "crates/schlupf-c";

/// What a program needs besides the static library.
const PRIVATE: &str = if cfg!(target_os = "macos") {
    "-liconv -lSystem -lc -lm"
} else {
    "-lgcc_s -lutil -lrt -lpthread -lm -ldl -lc"
};

/// Builds it with a profile of cargo and installs it below a folder.
pub fn install(
    workspace: &Path,
    target: &Path,
    prefix: &Path,
    profile: &str,
) -> Result<(), String> {
    if cfg!(windows) {
        return Err("the C library is installed on Linux and macOS only".to_owned());
    }
    let number = abi_version(workspace)?;
    let (shared, own_name) = if cfg!(target_os = "macos") {
        (format!("libschlupf.{number}.dylib"), "-install_name,@rpath/")
    } else {
        (format!("libschlupf.so.{number}"), "-soname,")
    };
    Step::cargo(&format!(
        "rustc --package schlupf-c --lib --profile {profile} --crate-type cdylib,staticlib \
         --target-dir {} -- -C link-arg=-Wl,{own_name}{shared}",
        target.display()
    ))
    .run(workspace)?;
    let built = target.join(if profile == "dev" { "debug" } else { profile });
    let ending = std::env::consts::DLL_EXTENSION;
    let place = Place { workspace, prefix, shared: &shared };
    place.copy(&built.join(format!("libschlupf_c.{ending}")), &format!("lib/{shared}"))?;
    place.copy(&built.join("libschlupf_c.a"), "lib/libschlupf.a")?;
    link(&shared, &prefix.join(format!("lib/libschlupf.{ending}")))?;
    for header in ["schlupf.h", "schlupf.hpp"] {
        let header = format!("include/{header}");
        place.copy(&workspace.join(PACKAGE).join(&header), &header)?;
    }
    let module = workspace.join(PACKAGE).join("fortran/schlupf.f90");
    place.copy(&module, "share/schlupf/schlupf.f90")?;
    place.fill("schlupf.pc", "lib/pkgconfig")?;
    place.fill("schlupf-config.cmake", "lib/cmake/schlupf")?;
    place.fill("schlupf-config-version.cmake", "lib/cmake/schlupf")
}

/// Where it is installed.
struct Place<'a> {
    workspace: &'a Path,
    prefix: &'a Path,
    shared: &'a str,
}

impl Place<'_> {
    fn copy(&self, from: &Path, to: &str) -> Result<(), String> {
        let to = self.prefix.join(to);
        create_parent(&to)?;
        fs::copy(from, &to)
            .map(|_| ())
            .map_err(|error| format!("{} to {}: {error}", from.display(), to.display()))
    }

    /// A file of the packaging, with names and numbers in it.
    fn fill(&self, name: &str, folder: &str) -> Result<(), String> {
        let text = read(&self.workspace.join(PACKAGE).join("packaging").join(name))?;
        let version = env!("CARGO_PKG_VERSION");
        let values = [("@VERSION@", version), ("@PRIVATE@", PRIVATE), ("@SHARED@", self.shared)];
        let text = values.iter().fold(text, |text, (name, value)| text.replace(name, value));
        let to = self.prefix.join(folder).join(name);
        create_parent(&to)?;
        fs::write(&to, text).map_err(|error| format!("{}: {error}", to.display()))
    }
}

fn create_parent(path: &Path) -> Result<(), String> {
    path.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(unix)]
fn link(name: &str, place: &Path) -> Result<(), String> {
    let fail = |error: std::io::Error| format!("{}: {error}", place.display());
    if place.symlink_metadata().is_ok() {
        fs::remove_file(place).map_err(fail)?;
    }
    std::os::unix::fs::symlink(name, place).map_err(fail)
}

#[cfg(not(unix))]
fn link(_: &str, place: &Path) -> Result<(), String> {
    Err(format!("{}: no symbolic links", place.display()))
}

/// The version of the binary interface, from the header.
fn abi_version(workspace: &Path) -> Result<String, String> {
    let header = workspace.join(PACKAGE).join("include/schlupf.h");
    let text = read(&header)?;
    let mut lines = text.lines();
    lines
        .find_map(|line| line.strip_prefix("#define SCHLUPF_ABI_VERSION "))
        .map(str::to_owned)
        .ok_or_else(|| format!("{} has no SCHLUPF_ABI_VERSION", header.display()))
}

/// The text of a file.
pub fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}
