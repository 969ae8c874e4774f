//! Rows of a CSV text with the lines in which they begin.

use csv::{ReaderBuilder, StringRecord};

/// Reads the rows of a CSV text one after the other. Lines that begin with `#` are comments, and
/// empty lines are none.
///
/// ```
/// use schlupf_case::Records;
///
/// let mut records = Records::new("# a\n\nx,y\r\n1,\"2\n3\"\n\n4,5");
/// let mut lines = Vec::new();
/// while let Some(line) = records.read() {
///     lines.push((line, records.cells().len()));
/// }
/// assert_eq!(lines, [(3, 2), (4, 2), (7, 2)]);
/// ```
pub struct Records<'a> {
    text: &'a str,
    reader: csv::Reader<&'a [u8]>,
    record: StringRecord,
    /// How far lines are counted, in bytes, and the line there.
    counted: (usize, usize),
}

impl<'a> Records<'a> {
    /// Those of a text.
    pub fn new(text: &'a str) -> Self {
        let mut builder = ReaderBuilder::new();
        builder.has_headers(false).flexible(true).comment(Some(b'#'));
        let reader = builder.from_reader(text.as_bytes());
        Self { text, reader, record: StringRecord::new(), counted: (0, 1) }
    }

    /// Reads the next row; the line in which it begins, from 1, as a text editor counts, or `None`
    /// at the end.
    pub fn read(&mut self) -> Option<usize> {
        // It fails only on what is not UTF-8.
        while self.reader.read_record(&mut self.record).is_ok_and(|is_record| is_record) {
            if self.record.len() == 1 && self.record[0].trim().is_empty() {
                continue;
            }
            return Some(self.line());
        }
        None
    }

    /// The cells of the latest row, without spaces around them and without quotation marks that
    /// stand behind a space.
    pub fn cells(&self) -> Vec<&str> {
        self.record.iter().map(|cell| cell.trim().trim_matches('"').trim()).collect()
    }

    /// The line in which the latest row begins: its position is that of the empty lines and
    /// comments before it.
    fn line(&mut self) -> usize {
        let position = self.record.position().map_or(0, |position| position.byte() as usize);
        let mut start = position;
        for line in self.text[position..].split_inclusive('\n') {
            if !line.trim_end_matches(['\r', '\n']).is_empty() && !line.starts_with('#') {
                break;
            }
            start += line.len();
        }
        let (from, line) = self.counted;
        let line = line + self.text[from..start].bytes().filter(|byte| *byte == b'\n').count();
        self.counted = (start, line);
        line
    }
}
