//! In place of Parquet in a program that is built without: there is no writer and no reader of it.

use std::path::Path;

use super::{Cells, Column, Contents, NEEDS_PARQUET, Place, Rows};
use crate::study::error::StudyError;

fn refused(path: &Path) -> StudyError {
    StudyError::table(path, format!("Parquet {NEEDS_PARQUET}"))
}

/// Would write a table.
pub enum ParquetWriter {}

impl ParquetWriter {
    pub fn create(path: &Path, _: &Contents) -> Result<Self, StudyError> {
        Err(refused(path))
    }

    pub fn append(&mut self, _: &Rows) -> Result<(), StudyError> {
        match *self {}
    }

    pub fn finish(self) -> Result<(), StudyError> {
        match self {}
    }
}

/// Would read a table.
pub enum ParquetReader {}

impl ParquetReader {
    pub fn open(path: &Path) -> Result<(Contents, Self), StudyError> {
        Err(refused(path))
    }

    pub fn place(&self) -> Place {
        match *self {}
    }

    pub fn go_to(&mut self, _: Place) {
        match *self {}
    }

    pub fn next_batch(
        &mut self,
        _: &Contents,
        _: impl Fn(&Column) -> bool,
    ) -> Result<Option<Rows>, StudyError> {
        match *self {}
    }
}

/// Would read the columns of a file.
pub fn read_columns(path: &Path) -> Result<Vec<(String, Cells)>, StudyError> {
    Err(refused(path))
}
