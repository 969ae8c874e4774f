//! Inputs of other programs as case files: those of CONTACT ([`contact`]).

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod contact;
mod document;
mod notice;

pub use notice::Notice;
