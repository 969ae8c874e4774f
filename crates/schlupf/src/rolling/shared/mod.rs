//! Shared by steady rolling and marching.

pub(crate) mod contact;
pub(crate) mod cell;
pub(crate) mod passage;
pub(in crate::rolling) mod coulomb;
pub(crate) mod warnings;
