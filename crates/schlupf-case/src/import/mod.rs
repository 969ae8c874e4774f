//! Inputs of other programs as case files: those of CONTACT ([`contact`]).

mod document;
mod notice;
pub mod contact;
mod file;

pub use file::{LARGEST_INPUT, Request, contact_file, read};
pub use notice::Notice;
