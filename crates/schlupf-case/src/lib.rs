//! Case files: TOML with units as text, from text to a [`schlupf::Problem`].
//!
//! One table of fields ([`fields::SECTIONS`]) says which fields there are, what each must be and
//! what it is by default. Reading, the check for unknown fields, the JSON schema and the commented
//! case file of `schlupf init` all follow from it.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

#[macro_use]
pub mod fields;
mod case;
mod case_file;
pub mod document;
mod edited;
pub mod error;
pub mod files;
pub mod place;
mod presets;
mod family;
pub mod identification;
mod kept;
mod law_stiffness;
mod laws;
pub mod look_up_table;
pub mod contact_table;
mod names;
mod notice;
mod profiles;
mod range;
mod read;
mod roughness_request;
mod schema;
mod setting;
mod settings;
mod side;
mod subsurface;
pub mod surface;
mod tables;
mod template;
pub mod units;
pub mod import;
pub mod fmu;

pub use case::{Case, Effective, Rolling};
pub use case_file::{CaseFile, Overrides, read_case};
pub use error::{CaseError, CaseErrors, Cause};
pub use family::Family;
pub use fields::FieldPath;
pub use fields::choice::ElasticityModel;
pub use files::{DataUrl, Files, Folder, InputFile, LARGEST_FILE, read_up_to};
pub use law_stiffness::{LawStiffness, MicroContact, MicroKey, StiffnessOrigin, caveats};
pub use laws::Laws;
pub use names::{FieldNames, quantity_field};
pub use notice::Notice;
pub use place::{Place, Source};
pub use presets::{Preset, conditions, presets};
pub use profiles::ProfileReading;
pub use range::{Points, depths, direction, length, points, position, pressures};
pub use roughness_request::{GivenByOption, RoughnessRequest};
pub use schema::schema;
pub use setting::{Refusal, Setting};
pub use subsurface::SubsurfaceRequest;
pub use tables::{CREEP_COLUMNS, DISPLACEMENT_COLUMNS, POINT_COLUMNS, TableColumn};
pub use tables::{Displacements, Records, read_displacements, read_points};
pub use template::{template, template_with};
