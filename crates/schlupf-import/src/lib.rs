//! Inputs of other programs as case files: those of CONTACT ([`contact`]).

#![forbid(unsafe_code)]

pub mod contact;
mod document;
mod notice;

pub use notice::Notice;
