//! The tests of the crate, in one program.

mod support;

mod bad_heat;
mod bad_input;
mod defaults;
mod every_field;
mod fmu;
mod good_input;
mod import;
mod long_input;
mod roughness;
mod sides;
mod slices;
mod surface_files;
mod unusual_values;
mod wheel_from_table;
mod wheel_rail;
mod wheel_rail_scan;
