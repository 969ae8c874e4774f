//! Look-up tables of creep forces as files, and the standard table of schlupf.
//!
//! A file is a `.npz` archive, which NumPy reads: the nodes and the values of
//! [`TableNodes`](schlupf::problem::look_up_table::TableNodes) under their names, and
//! `metadata.json`, with the version of the format, what the table holds for, its error, and a
//! checksum of the numbers.

pub(crate) mod archive;
mod metadata;
pub(crate) mod npy;
mod shared;
mod standard;

pub use archive::{StoredTable, TableFileError};
pub use metadata::{Metadata, StatedError};
pub use shared::shared;
pub use standard::{provide, standard};
