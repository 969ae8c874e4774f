//! The header and the Fortran module say what the library does.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use cbindgen::{Config, DocumentationStyle, ExportConfig, Language};
use schlupf_c::Status;

fn package() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// `NoContact` as `NO_CONTACT`.
fn upper(name: &str) -> String {
    let mut upper = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !upper.is_empty() {
            upper.push('_');
        }
        upper.extend(letter.to_uppercase());
    }
    upper
}

/// The codes of the header, which cbindgen does not see behind a macro.
fn codes() -> String {
    let mut text =
        "/**\n * What became of a call. Codes never change; there may be more of them.\n \
                    */\nenum {\n"
            .to_owned();
    for status in Status::ALL {
        let (name, code) = (upper(&format!("{status:?}")), *status as i32);
        let meaning = status.text().to_str().unwrap();
        writeln!(text, "  /** {meaning} */\n  SCHLUPF_{name} = {code},").unwrap();
    }
    text + "};"
}

fn header() -> String {
    let export = ExportConfig {
        rename: [("Code", "SchlupfStatus"), ("Element", "SchlupfElement")]
            .map(|(from, to)| (from.to_owned(), to.to_owned()))
            .into(),
        ..ExportConfig::default()
    };
    let config = Config {
        language: Language::C,
        header: Some("/* schlupf: the force element. Made by cbindgen: do not edit. */".to_owned()),
        include_guard: Some("SCHLUPF_H".to_owned()),
        after_includes: Some(format!("\n{}", codes())),
        cpp_compat: true,
        no_includes: true,
        sys_includes: vec!["stddef.h".to_owned(), "stdint.h".to_owned()],
        usize_is_size_t: true,
        documentation_style: DocumentationStyle::Doxy,
        export,
        ..Config::default()
    };
    let builder = cbindgen::Builder::new().with_config(config);
    let bindings = builder.with_src(package().join("src/interface.rs")).generate().unwrap();
    let mut text = Vec::new();
    bindings.write(&mut text);
    // A heading for Rust alone.
    String::from_utf8(text).unwrap().replace(" * # Safety\n", "")
}

/// `SCHLUPF_PIN=1` writes it anew.
#[test]
fn the_header_is_up_to_date() {
    let path = package().join("include/schlupf.h");
    if std::env::var_os("SCHLUPF_PIN").is_some() {
        fs::write(&path, header()).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap();
    assert!(found == header(), "{} is not that of the sources: SCHLUPF_PIN=1", path.display());
}

/// Codes and kinds of the Fortran module are those of the header.
#[test]
fn fortran_has_all_codes() {
    let text = fs::read_to_string(package().join("fortran/schlupf.f90")).unwrap();
    let codes = Status::ALL.iter().map(|status| (upper(&format!("{status:?}")), *status as i32));
    let kinds = ["INPUTS", "OUTPUTS", "STATES"].map(str::to_owned).into_iter().zip(0..);
    for (name, code) in codes.chain(kinds) {
        let name = name.to_lowercase();
        assert!(text.contains(&format!("schlupf_{name} = {code}")), "{name}");
    }
}
