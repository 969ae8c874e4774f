//! Fields of the states, in chunks of their own: a Parquet file for each batch, in a folder beside
//! the table.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use schlupf::Solution;
use schlupf::reporting::{Column as ResultColumn, Record};
use schlupf::solution::Fields;

use crate::study::error::StudyError;
use crate::study::parts::{Parts, sync};
use crate::study::table::{Cells, Column, Contents, Format, Kind, Rows, Writer};

/// A quantity of every cell.
pub(crate) type FieldColumn = ResultColumn<Fields>;

/// All of them.
pub(crate) fn all() -> Vec<&'static FieldColumn> {
    Fields::COLUMNS.iter().collect()
}

/// The columns of a chunk: the index of the row in the table, then the quantities of a cell.
pub(crate) fn columns(fields: &[&'static FieldColumn]) -> Vec<Column> {
    let index = Column::new("index", "", Kind::Count);
    let fields = fields.iter().map(|field| {
        let unit = field.quantity.unit();
        Column::new(field.name, unit, Kind::Number)
    });
    std::iter::once(index).chain(fields).collect()
}

/// Adds the cells of a solution.
pub(crate) fn push(
    rows: &mut Rows,
    fields: &[&'static FieldColumn],
    index: usize,
    solution: &Solution,
) {
    let count = solution.fields.rows();
    let mut columns = rows.iter_mut();
    if let Some(Cells::Counts(indices)) = columns.next() {
        indices.extend(std::iter::repeat_n(index as i64, count));
    }
    for (cells, field) in columns.zip(fields) {
        let number = |k| (field.value)(&solution.fields, k).number().unwrap_or(f64::NAN);
        if let Cells::Numbers(numbers) = cells {
            numbers.extend((0..count).map(number));
        }
    }
}

/// The folder of the chunks of a table.
#[derive(Debug)]
pub(crate) struct Chunks {
    folder: PathBuf,
    program: String,
    study: String,
    columns: Vec<Column>,
}

impl Chunks {
    /// That of a table; a run whose parts are new wants none there yet.
    pub fn of(
        output: &Path,
        contents: &Contents,
        columns: Vec<Column>,
        parts: &Parts,
    ) -> Result<Self, StudyError> {
        let mut name = output.file_name().unwrap_or_default().to_owned();
        name.push(".fields");
        let folder = output.with_file_name(name);
        match fs::create_dir(&folder) {
            Ok(()) => {}
            Err(cause) if cause.kind() == ErrorKind::AlreadyExists && parts.is_new() => {
                let reason = "it has fields of another run: remove it, or name another output";
                return Err(StudyError::table(&folder, reason));
            }
            Err(cause) if cause.kind() == ErrorKind::AlreadyExists => {}
            Err(cause) => return Err(StudyError::file(&folder, cause)),
        }
        let (program, study) = (contents.program.clone(), contents.study.clone());
        Ok(Self { folder, program, study, columns })
    }

    /// Writes the chunk of a batch, whole or not at all: it grows among the parts, so that only
    /// chunks are ever in its folder.
    pub fn keep(&self, batch: usize, rows: &Rows, parts: &Parts) -> Result<(), StudyError> {
        let path = self.folder.join(format!("batch-{batch:08}.parquet"));
        let count = rows.first().map_or(0, Cells::len);
        let contents = Contents {
            program: self.program.clone(),
            study: self.study.clone(),
            rows: count,
            batch: count.max(1),
            shard: [1, 1],
            columns: self.columns.clone(),
            case: String::new(),
        };
        let fail = |cause| StudyError::file(&path, cause);
        let unfinished = parts.unfinished().map_err(fail)?.into_temp_path();
        let mut writer = Writer::create(&unfinished, Format::Parquet, &contents)?;
        if count > 0 {
            writer.append(rows)?;
        }
        writer.finish()?;
        unfinished.persist(&path).map_err(|error| StudyError::file(&path, error.error))?;
        sync(&self.folder);
        Ok(())
    }
}
