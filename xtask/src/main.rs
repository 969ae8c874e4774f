//! Development tasks: `cargo xtask ci` and its parts.

fn main() {}
