//! Shared by steady rolling and marching.

pub(crate) mod contact;
pub(crate) mod cell;
pub(crate) mod passage;
pub(in crate::solver::rolling) mod strip;
pub(crate) mod warnings;
