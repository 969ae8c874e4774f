//! What follows from a solution (temperatures and stresses below the surface, wear, damage), and
//! from many (creep curves, calibration, identification, look-up tables).

pub mod temperature_field;
pub mod subsurface;
pub mod bulk_temperature;
pub mod damage;
pub mod creep_curve;
mod ideal_contact;
pub mod calibration;
pub mod identification;
pub mod table_building;
