//! From the cases of an input file to case files.

mod case;
mod frame;
mod contact;
mod approach;
mod elements;
mod hertz;
mod line;
mod laws;
mod friction;
mod normal;
mod basic;
mod wheel_rail;
mod wheel_history;
mod sequence;
mod all;
mod study;

pub use all::{Import, ImportedCase, Options, import};
pub use frame::WheelBody;
pub use study::{Grouped, ImportedStudy, grouped, ranges};
