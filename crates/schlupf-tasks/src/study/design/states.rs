//! States of a file: a row each, with columns named as fields, such as `normal.load [kN]`.

use std::path::Path;
use std::sync::Arc;

use schlupf::reporting::{quoted, shortened};
use schlupf_case::fields::{self, Field, FieldPath, Kind};
use schlupf_case::place::INDEX;
use schlupf_case::units::{Conversion, Measure, comma, comma_readings, parse_unit};
use schlupf_case::{CaseError, InputFile, Place, Records, Source};

use super::{Carried, Design, Values, Varied};
use crate::study::error::StudyError;
use crate::study::table::{Cells, Format, read_parquet_columns};

/// Columns that are carried along: name and what they measure.
const CARRIED: [(&str, &Measure); 3] =
    [("time", &Measure::TIME), ("distance", &Measure::LENGTH), ("position_y", &Measure::LENGTH)];

/// Reads the states of a file.
///
/// # Errors
/// A file that cannot be read, columns that are no fields or lack their unit, and cells that are no
/// numbers where there should be.
pub(crate) fn read(file: &InputFile) -> Result<Design, StudyError> {
    let path = &*file.path();
    let format = if file.data().is_some() { Format::Csv } else { Format::of(path)? };
    let columns = match format {
        Format::Csv => from_csv(file)?,
        Format::Parquet => {
            let columns = read_parquet_columns(path)?;
            let place = Place::File { name: path.display().to_string() };
            let heads = columns.iter().map(|(name, _)| Head::read(name, &place));
            let heads = heads.collect::<Result<Vec<_>, _>>()?;
            heads.into_iter().zip(columns).map(|(head, (_, cells))| (head, cells)).collect()
        }
    };
    design(path, columns)
}

fn design(path: &Path, columns: Vec<(Head, Cells)>) -> Result<Design, StudyError> {
    let refused = |message: String| {
        let place = Place::File { name: path.display().to_string() };
        StudyError::from(CaseError::new("", message, place))
    };
    let (mut varied, mut carried): (Vec<Varied>, Vec<Carried>) = (Vec::new(), Vec::new());
    for (Head { what, convert }, cells) in columns {
        let convert = |number: f64| convert.map_or(number, |convert| convert.apply(number));
        let wrong = |name: &str| refused(format!("{name} must be numbers, but is text"));
        match (what, cells) {
            (What::Carried(name, _), _) if carried.iter().any(|other| other.name == name) => {
                return Err(refused(format!("there are two columns {name}")));
            }
            (What::Carried(name, unit), Cells::Numbers(numbers)) => {
                let values = numbers.into_iter().map(convert).collect();
                carried.push(Carried { name, unit, values });
            }
            (What::Carried(name, _), _) => return Err(wrong(name)),
            (What::Field(field), cells) => {
                if varied.iter().any(|other| other.field.path == field.path) {
                    return Err(refused(format!("there are two columns {}", field.path)));
                }
                let values = match (field.kind, cells) {
                    (kind, Cells::Texts(texts)) if !is_number(kind) => Values::Texts(texts),
                    (kind, Cells::Numbers(numbers)) if is_number(kind) => {
                        Values::Numbers(numbers.into_iter().map(convert).collect())
                    }
                    (Kind::Count, Cells::Numbers(numbers)) => {
                        Values::Texts(numbers.iter().map(ToString::to_string).collect())
                    }
                    (kind, _) if is_number(kind) => return Err(wrong(field.path.as_str())),
                    _ => return Err(refused(format!("{} must be text, but is not", field.path))),
                };
                varied.push(Varied { field, values });
            }
        }
    }
    if varied.is_empty() {
        return Err(refused("a file of states needs columns named as fields".to_owned()));
    }
    if varied.iter().any(|varied| varied.values.is_empty()) {
        return Err(refused("a file of states must have rows, but has none".to_owned()));
    }
    Ok(Design::Rows(varied, carried))
}

/// Whether the values of a field are numbers that may have a unit.
fn is_number(kind: Kind) -> bool {
    matches!(kind, Kind::Quantity(_) | Kind::Number)
}

/// The head of a column.
struct Head {
    what: What,
    convert: Option<Conversion>,
}

enum What {
    Field(&'static Field),
    /// Name and unit.
    Carried(&'static str, &'static str),
}

impl Head {
    /// Reads `name [unit]`.
    fn read(text: &str, place: &Place) -> Result<Self, CaseError> {
        let refused = |message: String| CaseError::new("", message, place.clone());
        let (name, unit) = match text.split_once('[') {
            Some((name, unit)) => {
                let unit =
                    unit.trim_end().strip_suffix(']').filter(|unit| !unit.contains(['[', ']']));
                let form = || {
                    refused(format!(
                        "a column must be named as name [unit], not `{}`",
                        shortened(text)
                    ))
                };
                (name.trim(), Some(unit.ok_or_else(form)?))
            }
            None => (text.trim(), None),
        };
        let carried = CARRIED.iter().find(|(carried, _)| *carried == name);
        let (what, measure) = match (carried, fields::find(name)) {
            (Some((name, measure)), _) => (What::Carried(name, measure.unit), Some(*measure)),
            (None, Some(field)) => {
                let measure = match field.kind {
                    Kind::Quantity(measure) => Some(measure),
                    Kind::Quantities(_) | Kind::Numbers => {
                        return Err(refused(format!("{name} is a list and cannot vary")));
                    }
                    _ => None,
                };
                (What::Field(field), measure)
            }
            (None, None) => {
                let error = refused(format!(
                    "unknown column `{}`: columns are named as fields",
                    shortened(name)
                ));
                return Err(error.help(help(text)));
            }
        };
        let convert = match (measure, unit) {
            (Some(measure), Some(unit)) => {
                let convert = parse_unit(unit, measure);
                Some(
                    convert.map_err(|error| {
                        refused(format!("{name} [{}]: {error}", shortened(unit)))
                    })?,
                )
            }
            (Some(measure), None) => {
                let unit = measure.unit;
                let message = format!("{name} needs a unit in the header, such as {name} [{unit}]");
                return Err(refused(message));
            }
            (None, Some(unit)) => {
                return Err(refused(format!(
                    "{name} has no unit, but the header gives [{}]",
                    shortened(unit)
                )));
            }
            (None, None) => None,
        };
        Ok(Self { what, convert })
    }

    fn is_number(&self) -> bool {
        match self.what {
            What::Carried(..) => true,
            What::Field(field) => is_number(field.kind),
        }
    }
}

/// What may have been meant by a head that is no column.
fn help(text: &str) -> Option<String> {
    let (name, unit) = match text.split_once(['[', '(']) {
        Some((name, unit)) => (name.trim(), Some(unit.trim_end_matches([']', ')']))),
        None => (text.trim(), None),
    };
    let carried = CARRIED.iter().map(|(name, _)| *name).find(|carried| *carried == name);
    let meant = carried.or_else(|| fields::closest_path(name).map(FieldPath::as_str))?;
    Some(match unit {
        Some(unit) => format!("did you mean `{meant} [{}]`?", shortened(unit)),
        None => format!("did you mean `{meant}`?"),
    })
}

/// Why the first line is no header, if its columns are not separated by commas.
fn wrong_separator(header: &[&str]) -> Option<String> {
    let [only] = header else { return None };
    let separator = [(';', "semicolons"), ('\t', "tabs")].into_iter();
    let (_, what) = separator.into_iter().find(|(character, _)| only.contains(*character))?;
    Some(format!("columns must be separated by commas, but are by {what}"))
}

fn from_csv(file: &InputFile) -> Result<Vec<(Head, Cells)>, StudyError> {
    let path = &*file.path();
    let bytes = file.read().map_err(|cause| StudyError::file(path, cause))?;
    let name = path.display().to_string();
    let mut text = String::from_utf8(bytes).map_err(|_| {
        let place = Place::File { name: name.clone() };
        CaseError::new("", "states must be text in UTF-8, but are not", place)
    })?;
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    let source = Arc::new(Source { name, text });
    let at_line = |line: usize| Place::line(&source, line);
    let mut records = Records::new(&source.text);
    let mut first = 0;
    let mut columns: Vec<(Head, Cells)> = Vec::new();
    while let Some(line) = records.read() {
        let refused = |message: String| CaseError::new("", message, at_line(line));
        let row = records.cells();
        if columns.is_empty() {
            first = usize::from(row.first() == Some(&INDEX));
        }
        let row = row.get(first..).unwrap_or_default();
        if columns.is_empty() {
            if let Some(message) = wrong_separator(row) {
                return Err(refused(message).into());
            }
            for head in row {
                let head = Head::read(head, &at_line(line))?;
                let cells = if head.is_number() {
                    Cells::Numbers(Vec::new())
                } else {
                    Cells::Texts(Vec::new())
                };
                columns.push((head, cells));
            }
            continue;
        }
        if row.len() != columns.len() {
            let (found, count) = (row.len(), columns.len());
            return Err(refused(format!("a row must have {count} cells, but has {found}")).into());
        }
        for ((head, cells), text) in columns.iter_mut().zip(row.iter().copied()) {
            match cells {
                Cells::Numbers(numbers) => numbers.push(text.parse().map_err(|_| {
                    let name = match head.what {
                        What::Field(field) => field.path.as_str(),
                        What::Carried(name, _) => name,
                    };
                    let readings = comma_readings(text);
                    refused(format!("{name} must be a number, but is {}", quoted(text)))
                        .help((!readings.is_empty()).then(|| comma(&readings)))
                })?),
                Cells::Texts(texts) => texts.push(text.to_owned()),
                Cells::Counts(_) => {}
            }
        }
    }
    Ok(columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::design::Entry;

    fn states(text: &str) -> Result<Design, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("states.csv");
        std::fs::write(&path, text).unwrap();
        read(&InputFile::at(&path)).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_are_fields_with_units() {
        let design = states(
            "# a run\ntime [ms], normal.load [kN], kinematics.creepage_x, solver.method\n\
             1, 60, 0.001, full\n2, 80, 0.002, polach\n",
        );
        let design = design.unwrap();
        assert_eq!(design.rows(), Some(2));
        let polach = Entry::Text("polach".to_owned());
        assert_eq!(design.row(1), [Entry::Number(8e4), Entry::Number(0.002), polach]);
        assert_eq!(design.carried()[0].values, [1e-3, 2e-3]);
    }

    #[test]
    fn heads_with_units_in_other_brackets_are_understood_but_not_taken() {
        for (head, meant) in [
            ("normal.load (kN)", "did you mean `normal.load [kN]`?"),
            ("normal.laod [kN]", "did you mean `normal.load [kN]`?"),
            ("time (s)", "did you mean `time [s]`?"),
            ("kinematics.creepage", "did you mean `kinematics.creepage_x`?"),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("states.csv");
            std::fs::write(&path, format!("{head}\n1\n")).unwrap();
            let Err(StudyError::Input(errors)) = read(&InputFile::at(&path)) else {
                panic!("{head}")
            };
            assert_eq!(errors.first.help.as_deref(), Some(meant), "{head}");
        }
    }

    #[cfg(feature = "parquet")]
    /// By pyarrow 22: `write_table(table, …, compression="zstd")`, the default of Polars.
    #[test]
    fn another_compression_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("states.parquet");
        std::fs::write(&path, include_bytes!("../../../tests/data/states_zstd.parquet")).unwrap();
        let message = read(&InputFile::at(&path)).unwrap_err().to_string();
        for part in ["states.parquet", "kinematics.creepage_x", "ZSTD", "compression=\"snappy\""] {
            assert!(message.contains(part), "{part:?} is not in {message}");
        }
    }

    /// As a text editor counts lines, with comments, empty lines, line breaks within
    /// quotation marks and both ends of lines; what is long is quoted short.
    #[test]
    fn a_wrong_cell_is_told_with_its_line() {
        let text = "# a\n\nnormal.load [N],wheel.profile\n# b\n\n1,\"a\nb\"\n\nx,c\n";
        for text in [text.to_owned(), text.replace('\n', "\r\n")] {
            let message = states(&text).unwrap_err();
            assert!(message.contains("states.csv:9:1: normal.load must be a number"), "{message}");
        }
        let long = "1x".repeat(30_000);
        for text in [
            format!("normal.load [N]\n{long}\n"),
            format!("{long} [N]\n1\n"),
            format!("normal.load [{long}]\n1\n"),
            format!("normal.load [N\n{long}\n"),
        ] {
            assert!(states(&text).unwrap_err().len() < 600);
        }
        let comma = states("normal.load [N],title\n\"80,000\",a\n").unwrap_err();
        assert!(comma.contains("write 80000 or 80"), "{comma}");
    }

    #[test]
    fn wrong_columns_and_cells_are_named_with_their_line() {
        let refused = |text: &str| states(text).unwrap_err();
        let misnamed = refused("normal.laod [N]\n1\n");
        assert!(misnamed.contains("normal.laod") && misnamed.contains("normal.load"), "{misnamed}");
        assert!(refused("normal.load\n1\n").contains("needs a unit in the header"));
        assert!(refused("normal.load [m]\n1\n").contains("normal.load [m]"));
        assert!(refused("kinematics.creepage_x [m]\n1\n").contains("has no unit"));
        let cell = refused("normal.load [N]\n1\nx\n");
        assert!(cell.contains("states.csv:3:1") && cell.contains("\"x\""), "{cell}");
        let short = refused("normal.load [N],kinematics.creepage_x\n1\n");
        assert!(short.contains("must have 2 cells, but has 1"), "{short}");
        assert!(refused("history.time [s]\n1\n").contains("is a list"));
        assert!(refused("time [s]\n1\n").contains("needs columns named as fields"));
        let none = refused("normal.load [N]\n");
        assert!(none.contains("states.csv: a file of states must have rows"), "{none}");
        let separated = refused("normal.load [N];kinematics.creepage_x\n1;0,1\n");
        assert!(separated.contains("states.csv:1:1"), "{separated}");
        assert!(separated.contains("by commas, but are by semicolons"), "{separated}");
        let twice = refused("normal.load [N],normal.load [kN]\n1,2\n");
        assert!(twice.contains("two columns normal.load"));
    }
}
