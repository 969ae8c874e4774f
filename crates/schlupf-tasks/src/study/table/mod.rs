//! The table of a study: a row for each state, in batches, as CSV or Parquet.

mod csv_file;
#[cfg_attr(not(feature = "parquet"), path = "no_parquet.rs")]
mod parquet_file;

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::study::error::StudyError;
use csv_file::{CsvReader, CsvWriter};
use parquet_file::{ParquetReader, ParquetWriter};

pub(crate) use csv_file::{read_rows, write_rows};
pub(crate) use parquet_file::read_columns as read_parquet_columns;

/// Whether tables can be Parquet.
pub(crate) const HAS_PARQUET: bool = cfg!(feature = "parquet");

/// Endings of the files of tables.
pub const ENDINGS: &str = if HAS_PARQUET { ".csv or .parquet" } else { ".csv" };

/// What is said of that which needs Parquet, where there is none.
pub(crate) const NEEDS_PARQUET: &str =
    "needs a program built with the feature parquet, but this one is built without";

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Kind {
    /// Numbers in the unit of the column; NaN where there is none.
    Number,
    /// Whole numbers.
    Count,
    /// Text; empty where there is none.
    Text,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Its name, such as `force.x`.
    pub name: String,
    /// The SI unit of its numbers, temperatures in degC; empty if they have none.
    pub unit: String,
    /// What it holds.
    pub kind: Kind,
}

impl Column {
    /// A column.
    pub fn new(name: &str, unit: &str, kind: Kind) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned(), kind }
    }
}

/// Values of a column.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Cells {
    /// Numbers; NaN where there is none.
    Numbers(Vec<f64>),
    /// Whole numbers.
    Counts(Vec<i64>),
    /// Text; empty where there is none.
    Texts(Vec<String>),
}

impl Cells {
    /// None yet, for a column of some kind.
    pub fn empty(kind: Kind) -> Self {
        match kind {
            Kind::Number => Self::Numbers(Vec::new()),
            Kind::Count => Self::Counts(Vec::new()),
            Kind::Text => Self::Texts(Vec::new()),
        }
    }

    /// Adds others behind them; of another kind, they are left out.
    pub fn append(&mut self, other: Self) {
        match (self, other) {
            (Self::Numbers(all), Self::Numbers(mut part)) => all.append(&mut part),
            (Self::Counts(all), Self::Counts(mut part)) => all.append(&mut part),
            (Self::Texts(all), Self::Texts(mut part)) => all.append(&mut part),
            _ => {}
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Counts(values) => values.len(),
            Self::Texts(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Some rows of a table: cells for each of its columns.
pub type Rows = Vec<Cells>;

/// What a table is of.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Contents {
    /// The program that made it.
    pub program: String,
    /// Digest of the study.
    pub study: String,
    /// Rows of the whole study.
    pub rows: usize,
    /// Rows of a batch.
    pub batch: usize,
    /// Which share of the batches it has, from 1, and of how many.
    pub shard: [usize; 2],
    /// Its columns.
    pub columns: Vec<Column>,
    /// The text of the case, which laws of damage are taken from; empty where it is not kept.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub case: String,
}

impl Contents {
    /// Number of batches of the whole study.
    pub fn batches(&self) -> usize {
        self.rows.div_ceil(self.batch)
    }

    /// The batches of its share, in order.
    pub fn own_batches(&self) -> impl Iterator<Item = usize> + use<> {
        let [shard, shards] = self.shard;
        (shard - 1..self.batches()).step_by(shards)
    }

    /// What messages call another table in place of this one.
    pub(crate) fn other(&self, found: &Self) -> String {
        if found.program == self.program {
            return "another study or shard".to_owned();
        }
        format!("{}, but this is {}", found.program, self.program)
    }

    /// The rows of a batch.
    pub fn rows_of(&self, batch: usize) -> std::ops::Range<usize> {
        let start = batch * self.batch;
        start..(start + self.batch).min(self.rows)
    }
}

/// Format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// Comma-separated values.
    Csv,
    /// Apache Parquet, compressed with Snappy.
    Parquet,
}

impl Format {
    /// That of a file by the ending of its name.
    ///
    /// # Errors
    /// Another ending, or that of Parquet without the feature `parquet`.
    pub fn of(path: &Path) -> Result<Self, StudyError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        match ending.to_ascii_lowercase().as_str() {
            "csv" => Ok(Self::Csv),
            "parquet" if HAS_PARQUET => Ok(Self::Parquet),
            "parquet" => Err(StudyError::table(path, format!("a .parquet file {NEEDS_PARQUET}"))),
            _ => Err(StudyError::table(path, format!("a table must be a {ENDINGS} file"))),
        }
    }
}

/// Writes a table batch by batch.
pub(crate) enum Writer {
    Csv(CsvWriter),
    Parquet(Box<ParquetWriter>),
}

impl Writer {
    /// Begins a table at a path.
    pub fn create(path: &Path, format: Format, contents: &Contents) -> Result<Self, StudyError> {
        Ok(match format {
            Format::Csv => Self::Csv(CsvWriter::create(path, contents)?),
            Format::Parquet => Self::Parquet(Box::new(ParquetWriter::create(path, contents)?)),
        })
    }

    /// Adds the rows of a batch.
    pub fn append(&mut self, rows: &Rows) -> Result<(), StudyError> {
        match self {
            Self::Csv(writer) => writer.append(rows),
            Self::Parquet(writer) => writer.append(rows),
        }
    }

    /// Ends the table; it is on the disk then.
    pub fn finish(self) -> Result<(), StudyError> {
        match self {
            Self::Csv(writer) => writer.finish(),
            Self::Parquet(writer) => writer.finish(),
        }
    }
}

/// Reads a table batch by batch.
pub struct Reader {
    contents: Contents,
    source: Source,
    /// Names of the columns that are read, if not all are.
    only: Option<Vec<String>>,
}

/// Where reading a table goes on after its file was closed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Batches that are read already.
    batches: usize,
    /// Where the next row of CSV begins, in bytes from the start of the file.
    byte: u64,
}

enum Source {
    Csv(Box<CsvReader>),
    Parquet(Box<ParquetReader>),
}

impl Reader {
    /// Opens a table that a study has made.
    ///
    /// # Errors
    /// A file that cannot be read, or is no such table.
    pub fn open(path: &Path) -> Result<Self, StudyError> {
        let (contents, source) = match Format::of(path)? {
            Format::Csv => {
                let (contents, reader) = CsvReader::open(path)?;
                (contents, Source::Csv(Box::new(reader)))
            }
            Format::Parquet => {
                let (contents, reader) = ParquetReader::open(path)?;
                (contents, Source::Parquet(Box::new(reader)))
            }
        };
        let [shard, shards] = contents.shard;
        if shard == 0 || shard > shards || contents.batch == 0 {
            return Err(StudyError::table(path, "what it says about its shard is wrong"));
        }
        Ok(Self { contents, source, only: None })
    }

    /// Opens a table for some of its columns: the others stay empty.
    ///
    /// # Errors
    /// Those of [`Self::open`].
    pub fn open_only(path: &Path, names: &[&str]) -> Result<Self, StudyError> {
        let only = names.iter().map(|name| (*name).to_owned()).collect();
        Ok(Self { only: Some(only), ..Self::open(path)? })
    }

    /// Opens a table again where another reader of it has stopped.
    ///
    /// # Errors
    /// Those of [`Self::open`].
    pub(crate) fn open_at(path: &Path, place: Place) -> Result<Self, StudyError> {
        let mut reader = Self::open(path)?;
        match &mut reader.source {
            Source::Csv(source) => source.go_to(place)?,
            Source::Parquet(source) => source.go_to(place),
        }
        Ok(reader)
    }

    /// Where reading goes on.
    pub(crate) fn place(&self) -> Place {
        match &self.source {
            Source::Csv(source) => source.place(),
            Source::Parquet(source) => source.place(),
        }
    }

    /// What the table is of.
    pub fn contents(&self) -> &Contents {
        &self.contents
    }

    /// The rows of the next batch; `None` at the end.
    ///
    /// # Errors
    /// A file that cannot be read further.
    pub fn next_batch(&mut self) -> Result<Option<Rows>, StudyError> {
        let Self { contents, source, only } = self;
        let is_read =
            |column: &Column| only.as_ref().is_none_or(|only| only.contains(&column.name));
        match source {
            Source::Csv(reader) => reader.next_batch(contents, is_read),
            Source::Parquet(reader) => reader.next_batch(contents, is_read),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contents(rows: usize) -> Contents {
        let columns = vec![
            Column::new("index", "", Kind::Count),
            Column::new("force.x", "N", Kind::Number),
            Column::new("error", "", Kind::Text),
        ];
        let (program, study) = ("schlupf".to_owned(), "abc".to_owned());
        let case = "title = \"# a, b\"\n".to_owned();
        Contents { program, study, rows, batch: 2, shard: [1, 1], columns, case }
    }

    fn rows(start: i64, numbers: &[f64], texts: &[&str]) -> Rows {
        vec![
            Cells::Counts((start..start + numbers.len() as i64).collect()),
            Cells::Numbers(numbers.to_vec()),
            Cells::Texts(texts.iter().map(|text| (*text).to_owned()).collect()),
        ]
    }

    const TABLES: &[&str] =
        if HAS_PARQUET { &["table.csv", "table.parquet"] } else { &["table.csv"] };

    /// What is written is read back, number for number, batch for batch.
    #[test]
    fn tables_survive() {
        let folder = tempfile::tempdir().unwrap();
        for name in TABLES {
            let path = folder.path().join(name);
            let format = Format::of(&path).unwrap();
            let contents = contents(3);
            let batches = [
                rows(0, &[0.1 + 0.2, -1e-300], &["", "a, \"b\"\n# c"]),
                rows(2, &[f64::INFINITY], &["µ"]),
            ];
            let mut writer = Writer::create(&path, format, &contents).unwrap();
            for batch in &batches {
                writer.append(batch).unwrap();
            }
            writer.finish().unwrap();
            let mut reader = Reader::open(&path).unwrap();
            assert_eq!(*reader.contents(), contents);
            for batch in &batches {
                assert_eq!(reader.next_batch().unwrap().as_ref(), Some(batch), "{name}");
                let place = reader.place();
                reader = Reader::open_at(&path, place).unwrap();
            }
            assert_eq!(reader.next_batch().unwrap(), None);
        }
    }

    /// Columns that are not asked for stay empty, and cost nothing.
    #[test]
    fn some_columns_are_read_alone() {
        let folder = tempfile::tempdir().unwrap();
        for name in TABLES {
            let path = folder.path().join(name);
            let format = Format::of(&path).unwrap();
            let mut writer = Writer::create(&path, format, &contents(3)).unwrap();
            writer.append(&rows(0, &[1.0, 2.0], &["a", "b"])).unwrap();
            writer.append(&rows(2, &[3.0], &["c"])).unwrap();
            writer.finish().unwrap();
            let mut reader = Reader::open_only(&path, &["force.x", "none"]).unwrap();
            for numbers in [vec![1.0, 2.0], vec![3.0]] {
                let batch = reader.next_batch().unwrap().unwrap();
                assert_eq!(batch[1], Cells::Numbers(numbers), "{name}");
                assert!(batch[0].is_empty() && batch[2].is_empty(), "{name}");
            }
            assert_eq!(reader.next_batch().unwrap(), None);
        }
    }

    #[test]
    fn missing_numbers_are_not_numbers() {
        let folder = tempfile::tempdir().unwrap();
        for name in TABLES {
            let path = folder.path().join(name);
            let mut writer =
                Writer::create(&path, Format::of(&path).unwrap(), &contents(1)).unwrap();
            writer.append(&rows(0, &[f64::NAN], &[""])).unwrap();
            writer.finish().unwrap();
            let batch = Reader::open(&path).unwrap().next_batch().unwrap().unwrap();
            let Cells::Numbers(numbers) = &batch[1] else { panic!("{name}") };
            assert!(numbers[0].is_nan());
        }
    }

    #[test]
    fn what_is_no_table_of_a_study_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let refused = |name: &str, bytes: &[u8]| {
            let path = folder.path().join(name);
            std::fs::write(&path, bytes).unwrap();
            Reader::open(&path).err().unwrap().to_string()
        };
        assert!(refused("a.csv", b"x,y\n1,2\n").contains("no table of a study"));
        let parquet = if HAS_PARQUET { "Parquet" } else { "the feature parquet" };
        assert!(refused("a.parquet", b"PAR1").contains(parquet));
        assert!(refused("a.txt", b"").contains(ENDINGS));
    }
}
