//! From the cases of an input file to case files.

mod case;
mod frame;
mod hertz;
mod contact;
mod elements;
mod laws;
mod friction;
mod normal;
mod basic;
mod wheel_rail;
mod sequence;
mod all;
mod study;

pub use all::{Import, ImportedCase, Options, import};
pub use frame::WheelBody;
pub use study::{Grouped, ImportedStudy, grouped, ranges};
