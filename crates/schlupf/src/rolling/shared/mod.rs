//! Shared by steady rolling and marching.

pub(crate) mod contact;
pub(crate) mod cell;
pub(crate) mod turn;
pub(crate) mod passage;
pub(crate) mod warnings;
