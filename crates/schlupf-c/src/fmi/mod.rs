//! Functional mock-up units: the functions of FMI 2.0 and 3.0 for one force element.

#![allow(unsafe_code, reason = "tools call these functions with pointers")]

mod instance;
#[macro_use]
mod component;
mod fmi2;
mod fmi3;
