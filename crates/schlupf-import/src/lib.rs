//! Inputs of other programs as case files: those of CONTACT ([`contact`]).

#![forbid(unsafe_code)]

mod document;
pub mod contact;
