//! Tells the command whether there is a page of the explorer, which `cargo xtask web` makes.

fn main() {
    println!("cargo::rerun-if-changed=page");
    println!("cargo::rustc-check-cfg=cfg(has_page)");
    if std::path::Path::new("page/page.zip").exists() {
        println!("cargo::rustc-cfg=has_page");
    }
}
