//! Results as JSON, CSV, VTK, text and figures.

mod common;
mod calibration;
mod comparison;
mod creep_curve;
mod damage;
mod figures;
mod identification;
mod roughness;
mod tables;
mod temperature;
