//! Tables as CSV: a comment with what they are of, one with units, a header, then a row a line.

use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::{Cells, Column, Contents, Kind, Place, Rows};
use crate::study::error::StudyError;
use schlupf::reporting::quoted;

/// What the first line begins with.
const MARK: &str = "# schlupf study ";

/// Writes a table.
pub struct CsvWriter {
    path: PathBuf,
    file: BufWriter<File>,
}

impl CsvWriter {
    pub fn create(path: &Path, contents: &Contents) -> Result<Self, StudyError> {
        let fail = |cause| StudyError::file(path, cause);
        let file = File::create(path).map_err(fail)?;
        let mut file = BufWriter::new(file);
        let about = serde_json::to_string(contents).map_err(|error| fail(error.into()))?;
        let unit = |column: &Column| match (column.kind, column.unit.as_str()) {
            (Kind::Text, _) => "text".to_owned(),
            (_, "") => "1".to_owned(),
            (_, unit) => unit.to_owned(),
        };
        let units: Vec<String> = contents.columns.iter().map(unit).collect();
        let names: Vec<&str> = contents.columns.iter().map(|column| column.name.as_str()).collect();
        let head = format!("{MARK}{about}\n# units: {}\n{}\n", units.join(", "), names.join(","));
        file.write_all(head.as_bytes()).map_err(fail)?;
        Ok(Self { path: path.to_owned(), file })
    }

    pub fn append(&mut self, rows: &Rows) -> Result<(), StudyError> {
        write_rows(&mut self.file, rows).map_err(|cause| StudyError::file(&self.path, cause))
    }

    pub fn finish(self) -> Result<(), StudyError> {
        let Self { path, file } = self;
        let synced = file.into_inner().map_err(std::io::IntoInnerError::into_error);
        synced.and_then(|file| file.sync_all()).map_err(|cause| StudyError::file(&path, cause))
    }
}

/// Writes rows without a header.
pub fn write_rows(file: &mut impl Write, rows: &Rows) -> std::io::Result<()> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(file);
    let count = rows.first().map_or(0, Cells::len);
    for row in 0..count {
        let cells = rows.iter().map(|cells| match cells {
            Cells::Numbers(numbers) if numbers[row].is_nan() => String::new(),
            // 0 for −0.
            Cells::Numbers(numbers) => format!("{:e}", numbers[row] + 0.0),
            Cells::Counts(counts) => counts[row].to_string(),
            Cells::Texts(texts) => texts[row].clone(),
        });
        writer.write_record(cells)?;
    }
    writer.flush()
}

/// Reads rows without a header, up to `most`; why not, if a cell is wrong.
pub fn read_rows(
    reader: &mut csv::Reader<impl Read>,
    columns: &[Column],
    most: usize,
) -> Result<Rows, String> {
    read_some(reader, columns, most, |_| true)
}

/// Reads such rows for some of the columns; the others stay empty.
fn read_some(
    reader: &mut csv::Reader<impl Read>,
    columns: &[Column],
    most: usize,
    is_read: impl Fn(&Column) -> bool,
) -> Result<Rows, String> {
    let mut rows: Rows = columns.iter().map(|column| Cells::empty(column.kind)).collect();
    let mut record = csv::StringRecord::new();
    for _ in 0..most {
        if !reader.read_record(&mut record).map_err(|error| error.to_string())? {
            break;
        }
        if record.len() != columns.len() {
            let (found, wanted) = (record.len(), columns.len());
            return Err(format!("a row has {found} cells, but there are {wanted} columns"));
        }
        let all = rows.iter_mut().zip(&record).zip(columns);
        for ((cells, text), column) in all.filter(|(_, column)| is_read(column)) {
            let wrong = || format!("{} must be a number, but is {}", column.name, quoted(text));
            match cells {
                Cells::Numbers(numbers) if text.is_empty() => numbers.push(f64::NAN),
                Cells::Numbers(numbers) => numbers.push(text.parse().map_err(|_| wrong())?),
                Cells::Counts(counts) => counts.push(text.parse().map_err(|_| wrong())?),
                Cells::Texts(texts) => texts.push(text.to_owned()),
            }
        }
    }
    Ok(rows)
}

/// Reads a table.
pub struct CsvReader {
    path: PathBuf,
    reader: csv::Reader<BufReader<File>>,
    /// Where the reader began, in bytes from the start of the file.
    start: u64,
    batches: Box<dyn Iterator<Item = usize> + Send>,
    /// Batches that are read already.
    read: usize,
}

impl CsvReader {
    pub fn open(path: &Path) -> Result<(Contents, Self), StudyError> {
        let fail = |cause| StudyError::file(path, cause);
        let mut file = BufReader::new(File::open(path).map_err(fail)?);
        let mut lines = [const { String::new() }; 3];
        let mut start = 0;
        for line in &mut lines {
            start += file.read_line(line).map_err(fail)? as u64;
        }
        let about = lines[0].strip_prefix(MARK).and_then(|about| serde_json::from_str(about).ok());
        let contents: Contents =
            about.ok_or_else(|| StudyError::table(path, "it is no table of a study"))?;
        let batches = Box::new(contents.own_batches());
        let reader = csv::ReaderBuilder::new().has_headers(false).from_reader(file);
        Ok((contents, Self { path: path.to_owned(), reader, start, batches, read: 0 }))
    }

    pub fn place(&self) -> Place {
        Place { batches: self.read, byte: self.start + self.reader.position().byte() }
    }

    /// From the beginning of the table on.
    pub fn go_to(&mut self, place: Place) -> Result<(), StudyError> {
        let fail = |cause| StudyError::file(&self.path, cause);
        let mut file = BufReader::new(File::open(&self.path).map_err(fail)?);
        file.seek(SeekFrom::Start(place.byte)).map_err(fail)?;
        self.reader = csv::ReaderBuilder::new().has_headers(false).from_reader(file);
        self.start = place.byte;
        if let Some(last) = place.batches.checked_sub(1) {
            self.batches.nth(last);
        }
        self.read = place.batches;
        Ok(())
    }

    pub fn next_batch(
        &mut self,
        contents: &Contents,
        is_read: impl Fn(&Column) -> bool,
    ) -> Result<Option<Rows>, StudyError> {
        let Some(batch) = self.batches.next() else { return Ok(None) };
        self.read += 1;
        let wanted = contents.rows_of(batch).len();
        let rows = read_some(&mut self.reader, &contents.columns, wanted, is_read);
        let rows = rows.map_err(|reason| StudyError::table(&self.path, reason))?;
        Ok((!rows.iter().all(Cells::is_empty)).then_some(rows))
    }
}
