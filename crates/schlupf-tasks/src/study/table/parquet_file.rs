//! Tables as Parquet: a row group for each batch, compressed with Snappy; what they are of and the
//! units stand in the metadata of the file.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::{KeyValue, RowGroupMetaData};
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::{Cells, Column, Contents, Kind, Place, Rows};
use crate::study::error::StudyError;

/// The key of what a table is of.
const ABOUT: &str = "schlupf study";

/// The key of the units, a JSON object.
const UNITS: &str = "units";

/// Writes a table.
pub struct ParquetWriter {
    path: PathBuf,
    writer: SerializedFileWriter<File>,
}

impl ParquetWriter {
    pub fn create(path: &Path, contents: &Contents) -> Result<Self, StudyError> {
        let file = File::create(path).map_err(|cause| StudyError::file(path, cause))?;
        let create = || {
            let fields = contents.columns.iter().map(|column| Ok(Arc::new(field(column)?)));
            let fields = fields.collect::<Result<_, ParquetError>>()?;
            let schema = Type::group_type_builder("study").with_fields(fields).build()?;
            let properties = WriterProperties::builder()
                .set_compression(Compression::SNAPPY)
                .set_created_by(contents.program.clone())
                .set_key_value_metadata(Some(metadata(contents)?))
                .build();
            SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
        };
        let writer = create().map_err(|error| failure(path, &error))?;
        Ok(Self { path: path.to_owned(), writer })
    }

    pub fn append(&mut self, rows: &Rows) -> Result<(), StudyError> {
        self.write(rows).map_err(|error| failure(&self.path, &error))
    }

    fn write(&mut self, rows: &Rows) -> Result<(), ParquetError> {
        let mut group = self.writer.next_row_group()?;
        for cells in rows {
            let Some(mut column) = group.next_column()? else { break };
            write_column(column.untyped(), cells)?;
            column.close()?;
        }
        group.close()?;
        Ok(())
    }

    pub fn finish(self) -> Result<(), StudyError> {
        let Self { path, writer } = self;
        // What is buffered is written only now, and whatever keeps it from that is told as text.
        let file = writer.into_inner().map_err(|error| match error {
            ParquetError::General(text) => StudyError::file(&path, std::io::Error::other(text)),
            other => failure(&path, &other),
        })?;
        file.sync_all().map_err(|cause| StudyError::file(&path, cause))
    }
}

fn metadata(contents: &Contents) -> Result<Vec<KeyValue>, ParquetError> {
    let json = |error: serde_json::Error| ParquetError::External(Box::new(error));
    let units: std::collections::BTreeMap<&str, &str> = contents
        .columns
        .iter()
        .map(|column| (column.name.as_str(), column.unit.as_str()))
        .collect();
    let about = serde_json::to_string(contents).map_err(json)?;
    let units = serde_json::to_string(&units).map_err(json)?;
    Ok(vec![KeyValue::new(ABOUT.to_owned(), about), KeyValue::new(UNITS.to_owned(), units)])
}

fn field(column: &Column) -> Result<Type, ParquetError> {
    let (physical, repetition, logical) = match column.kind {
        Kind::Number => (Physical::DOUBLE, Repetition::OPTIONAL, None),
        Kind::Count => (Physical::INT64, Repetition::REQUIRED, None),
        Kind::Text => (Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String)),
    };
    Type::primitive_type_builder(&column.name, physical)
        .with_repetition(repetition)
        .with_logical_type(logical)
        .build()
}

fn write_column(writer: &mut ColumnWriter<'_>, cells: &Cells) -> Result<(), ParquetError> {
    match (writer, cells) {
        (ColumnWriter::DoubleColumnWriter(writer), Cells::Numbers(numbers)) => {
            // A level of 0 means that there is no number.
            let levels: Vec<i16> = numbers.iter().map(|n| i16::from(!n.is_nan())).collect();
            let known = numbers.iter().filter(|n| !n.is_nan()).map(|n| n + 0.0);
            writer.write_batch(&known.collect::<Vec<_>>(), Some(&levels), None)?;
        }
        (ColumnWriter::Int64ColumnWriter(writer), Cells::Counts(counts)) => {
            writer.write_batch(counts, None, None)?;
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Cells::Texts(texts)) => {
            let texts: Vec<ByteArray> = texts.iter().map(|text| text.as_str().into()).collect();
            writer.write_batch(&texts, None, None)?;
        }
        _ => return Err(ParquetError::General("a column of another kind".to_owned())),
    }
    Ok(())
}

/// Reads a table.
pub struct ParquetReader {
    path: PathBuf,
    reader: SerializedFileReader<File>,
    next: usize,
}

impl ParquetReader {
    pub fn open(path: &Path) -> Result<(Contents, Self), StudyError> {
        let reader = open(path)?;
        let about = reader.metadata().file_metadata().key_value_metadata();
        let about = about.and_then(|pairs| pairs.iter().find(|pair| pair.key == ABOUT));
        let about = about.and_then(|pair| serde_json::from_str(pair.value.as_deref()?).ok());
        let contents: Contents =
            about.ok_or_else(|| StudyError::table(path, "it is no table of a study"))?;
        Ok((contents, Self { path: path.to_owned(), reader, next: 0 }))
    }

    pub fn place(&self) -> Place {
        Place { batches: self.next, byte: 0 }
    }

    pub fn go_to(&mut self, place: Place) {
        self.next = place.batches;
    }

    pub fn next_batch(
        &mut self,
        contents: &Contents,
        is_read: impl Fn(&Column) -> bool,
    ) -> Result<Option<Rows>, StudyError> {
        if self.next >= self.reader.num_row_groups() {
            return Ok(None);
        }
        let read = || {
            let group = self.reader.get_row_group(self.next)?;
            let read = |(k, column): (usize, &Column)| {
                let empty = Cells::empty(column.kind);
                if is_read(column) { read_column(&*group, k, column.kind) } else { Ok(empty) }
            };
            contents.columns.iter().enumerate().map(read).collect()
        };
        let rows: Result<Rows, ParquetError> = read();
        let rows = rows.map_err(|error| failure(&self.path, &error))?;
        self.next += 1;
        Ok(Some(rows))
    }
}

fn open(path: &Path) -> Result<SerializedFileReader<File>, StudyError> {
    let file = File::open(path).map_err(|cause| StudyError::file(path, cause))?;
    let reader = SerializedFileReader::new(file).map_err(|error| failure(path, &error))?;
    check_compression(path, &reader)?;
    Ok(reader)
}

/// Refuses what is compressed otherwise than with Snappy.
fn check_compression(path: &Path, reader: &SerializedFileReader<File>) -> Result<(), StudyError> {
    let mut columns = reader.metadata().row_groups().iter().flat_map(RowGroupMetaData::columns);
    let is_foreign =
        |codec: Compression| !matches!(codec, Compression::UNCOMPRESSED | Compression::SNAPPY);
    let Some(column) = columns.find(|column| is_foreign(column.compression())) else {
        return Ok(());
    };
    let codec = column.compression().to_string();
    let codec = codec.split('(').next().unwrap_or_default();
    let name = column.column_path().string();
    let reason = format!(
        "it must be compressed with Snappy or not at all, but its column {name} is with {codec}: \
         write it with compression=\"snappy\""
    );
    Err(StudyError::table(path, reason))
}

/// All columns of a file: their names, and their numbers or texts.
pub fn read_columns(path: &Path) -> Result<Vec<(String, Cells)>, StudyError> {
    let reader = open(path)?;
    let schema = reader.metadata().file_metadata().schema_descr_ptr();
    let mut columns = Vec::new();
    for (k, column) in schema.columns().iter().enumerate() {
        let kind = match column.physical_type() {
            Physical::BYTE_ARRAY => Kind::Text,
            _ => Kind::Number,
        };
        let mut all = Cells::empty(kind);
        for group in 0..reader.num_row_groups() {
            let read = || read_column(&*reader.get_row_group(group)?, k, kind);
            all.append(read().map_err(|error| failure(path, &error))?);
        }
        columns.push((column.path().string().trim_matches('"').to_owned(), all));
    }
    Ok(columns)
}

fn read_column(group: &dyn RowGroupReader, k: usize, kind: Kind) -> Result<Cells, ParquetError> {
    let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
    macro_rules! read {
        ($reader:expr) => {{
            let (mut values, mut levels) = (Vec::new(), Vec::new());
            $reader.read_records(count, Some(&mut levels), None, &mut values)?;
            (values, levels)
        }};
    }
    let numbers = |values: Vec<f64>, levels: Vec<i16>| {
        let mut values = values.into_iter();
        if levels.is_empty() {
            return Cells::Numbers(values.collect());
        }
        let number = |level: i16| if level > 0 { values.next() } else { None };
        Cells::Numbers(levels.into_iter().map(number).map(|n| n.unwrap_or(f64::NAN)).collect())
    };
    let column = group.get_column_reader(k)?;
    Ok(match (column, kind) {
        (ColumnReader::Int64ColumnReader(mut reader), Kind::Count) => {
            Cells::Counts(read!(reader).0)
        }
        (ColumnReader::DoubleColumnReader(mut reader), Kind::Number) => {
            let (values, levels) = read!(reader);
            numbers(values, levels)
        }
        (ColumnReader::FloatColumnReader(mut reader), Kind::Number) => {
            let (values, levels) = read!(reader);
            numbers(values.into_iter().map(f64::from).collect(), levels)
        }
        (ColumnReader::Int64ColumnReader(mut reader), Kind::Number) => {
            let (values, levels) = read!(reader);
            numbers(values.into_iter().map(|value: i64| value as f64).collect(), levels)
        }
        (ColumnReader::Int32ColumnReader(mut reader), Kind::Number) => {
            let (values, levels) = read!(reader);
            numbers(values.into_iter().map(|value: i32| f64::from(value)).collect(), levels)
        }
        (ColumnReader::ByteArrayColumnReader(mut reader), Kind::Text) => {
            let (values, levels): (Vec<ByteArray>, _) = read!(reader);
            let mut texts = values.iter().map(|bytes| bytes.as_utf8().map(str::to_owned));
            let mut text = |level: i16| if level > 0 { texts.next() } else { None };
            let levels = if levels.is_empty() { vec![1; values.len()] } else { levels };
            let texts: Result<Vec<Option<String>>, ParquetError> =
                levels.into_iter().map(|level| text(level).transpose()).collect();
            Cells::Texts(texts?.into_iter().map(Option::unwrap_or_default).collect())
        }
        _ => return Err(ParquetError::General("a column is neither number nor text".to_owned())),
    })
}

fn failure(path: &Path, error: &ParquetError) -> StudyError {
    match error {
        ParquetError::External(cause) => match cause.downcast_ref::<std::io::Error>() {
            Some(cause) => {
                StudyError::file(path, std::io::Error::new(cause.kind(), cause.to_string()))
            }
            None => StudyError::table(path, cause.to_string()),
        },
        other => StudyError::table(path, format!("not Parquet as expected: {other}")),
    }
}
