//! Input files of CONTACT (Vollebregt and Kalker; E. A. H. Vollebregt, *User guide for CONTACT*):
//! modules 1 and 3.
//!
//! A file is a sequence of cases, each of which keeps what it does not give anew. [`import`] reads
//! all of them and writes those as case files that are available here; of the others it tells what
//! is not, with name, value and line.
//!
//! A file is read as groups of numbers, each with its name and its place; `input` follows what a
//! case keeps of earlier ones, so that every case is complete; `translate` writes fields or says
//! why it cannot. All refusals of a file are collected.

mod given;
mod reader;
mod control;
mod friction;
mod material;
mod skipped;
mod basic;
mod wheel_rail;
mod input;
mod translate;

pub use translate::{
    Grouped, Import, ImportedCase, ImportedStudy, Options, WheelBody, grouped, import, ranges,
};
