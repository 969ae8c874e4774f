//! The tests of the crate, in one program.

mod support;

mod bad_input;
mod calibrate;
mod commands;
mod compare;
mod contact_table;
mod curve;
mod damage;
mod documentation;
mod features;
mod fit;
mod fmu;
mod gallery;
mod heat;
mod import;
mod input;
#[cfg(unix)]
mod interrupt;
#[cfg(unix)]
mod locks;
mod outputs;
mod patch;
mod prescribed_forces;
mod roughness;
mod solve;
mod subsurface;
#[cfg(feature = "parquet")]
mod sweep;
mod table;
mod temperature;
mod threads;
mod validation;
mod wear;
mod wheelset;
