//! The explorer: its WebAssembly module, its page, and tests of both in a browser.

use std::fs;
use std::path::Path;

use crate::step::Step;

/// Profile and target of the module.
const PROFILE: &str = "web";
const TARGET: &str = "wasm32-unknown-unknown";

/// Vectors as they are written; more of them make the module larger, not faster.
const FLAGS: &str = "-C target-feature=+simd128 -C no-vectorize-loops";

/// The table of creep forces, which the page fetches when it is asked for.
const TABLE: &str = "crates/schlupf-case/src/look_up_table/standard.npz";

/// Builds the module and the page, puts it where the command takes it from, and tests both in
/// Chromium.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    let build = Step {
        variable: Some(("RUSTFLAGS", FLAGS.to_owned())),
        ..Step::cargo(&format!(
            "build --package schlupf-wasm --target {TARGET} --profile {PROFILE}"
        ))
    };
    build.run(workspace)?;
    let module = target.join(TARGET).join(PROFILE).join("schlupf_wasm.wasm");
    page(&format!("bindings {} web/pkg", module.display())).run(workspace)?;
    let public = workspace.join("web/public");
    let copied = fs::create_dir_all(&public)
        .and_then(|()| fs::copy(workspace.join(TABLE), public.join("standard.npz")));
    copied.map_err(|error| format!("{}: {error}", public.display()))?;
    let web = workspace.join("web");
    Step::new("npm".into(), "ci --no-audit --no-fund").run(&web)?;
    Step::new("npm".into(), "run build").run(&web)?;
    page("pack web/dist/explore crates/schlupf-cli/page/page.zip").run(workspace)?;
    // With the features of the workspace, so that nothing is built twice.
    Step::cargo("build --workspace --bin schlupf").run(workspace)?;
    let command = target.join("debug").join(format!("schlupf{}", std::env::consts::EXE_SUFFIX));
    let variable = Some(("SCHLUPF_COMMAND", command.display().to_string()));
    Step { variable, ..Step::new("npm".into(), "test") }.run(&web)
}

fn page(arguments: &str) -> Step {
    Step::cargo(&format!("run --quiet --package xtask --features page --bin page -- {arguments}"))
}
