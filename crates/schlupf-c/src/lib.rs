//! The force element for C, C++ and Fortran.
//!
//! `include/schlupf.h` is made of the documentation of [`interface`]. An element is a number that
//! no other element had: one that was destroyed, or never made, ends in a [`Status`], as do null
//! pointers, wrong sizes and panics.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod status;
mod texts;
mod trouble;
mod held;
mod table;
mod pointers;
pub mod interface;
mod fmi;

pub use status::Status;
