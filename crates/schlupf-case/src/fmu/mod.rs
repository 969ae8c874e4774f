//! Functional mock-up units: a force element with its case, for the tools that read FMI 2.0 or 3.0.
//!
//! An archive has one description, which is of one version of the standard. `resources` holds the
//! case with the files that it names; the library in `binaries` makes the element from them. The
//! token, or GUID, is a digest of both.

mod resources;
mod variables;
mod description;
mod archive;

pub use archive::{Binary, Fmu};
pub use description::Version;
pub use resources::Resources;
pub use variables::{Role, Variable, variables};
