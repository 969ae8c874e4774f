//! The columns of a study's table, and a row of it.

use schlupf::columns::{Column as ResultColumn, Record, Value};
use schlupf::{Solution, Warning};

use crate::design::{Design, Entry, Values};
use crate::table::{Cells, Column, Kind, Rows};

/// The columns: the index of the row, what varies, the status, results under the dotted names of
/// the JSON of a solution, codes of warnings, and why a row failed.
pub(crate) fn columns(design: &Design) -> Vec<Column> {
    let mut columns = vec![Column::new("index", "", Kind::Count)];
    let carried = design.carried().iter();
    columns.extend(carried.map(|column| Column::new(column.name, column.unit, Kind::Number)));
    columns.extend(design.varied().iter().map(|varied| {
        let kind = match varied.values {
            Values::Numbers(_) => Kind::Number,
            Values::Texts(_) => Kind::Text,
        };
        Column::new(varied.field.path, varied.field.kind.unit(), kind)
    }));
    columns.push(Column::new("status", "", Kind::Text));
    let taken: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let results = results(&taken);
    let results: Vec<Column> = results
        .map(|column| Column::new(column.name, column.quantity.unit(), Kind::Number))
        .collect();
    columns.extend(results);
    columns.push(Column::new("warnings", "", Kind::Text));
    columns.push(Column::new("error", "", Kind::Text));
    columns
}

/// The results that a table has: a field that varies has its column already.
fn results<'a>(
    taken: &'a [&'a str],
) -> impl Iterator<Item = &'static ResultColumn<Solution>> + use<'a> {
    let is_free = |column: &&ResultColumn<Solution>| !taken.contains(&column.name);
    <Solution as Record>::columns().iter().filter(is_free)
}

/// What became of a state.
pub(crate) enum Outcome {
    Solved(Box<Solution>),
    /// Why not.
    Failed(String),
}

impl Outcome {
    /// Name of the status in a table.
    fn status(&self) -> &'static str {
        match self {
            Self::Solved(solution) => solution.status.name(),
            Self::Failed(_) => FAILED,
        }
    }
}

/// The status of a state that could not be solved at all.
pub(crate) const FAILED: &str = "failed";

/// A row of a table.
pub(crate) struct Row<'a> {
    pub index: usize,
    pub carried: Vec<f64>,
    pub entries: &'a [Entry],
    pub outcome: &'a Outcome,
}

/// Adds a row to a table with these columns.
pub(crate) fn push(rows: &mut Rows, columns: &[Column], row: &Row) {
    let Row { index, carried, entries, outcome } = row;
    let mut cells = rows.iter_mut();
    let mut put = |value: Put| {
        let Some(cells) = cells.next() else { return };
        match (cells, value) {
            (Cells::Counts(counts), Put::Count(count)) => counts.push(count),
            (Cells::Numbers(numbers), Put::Number(number)) => numbers.push(number),
            (Cells::Texts(texts), Put::Text(text)) => texts.push(text),
            // The columns are made for these values.
            (Cells::Numbers(numbers), _) => numbers.push(f64::NAN),
            (Cells::Counts(counts), _) => counts.push(0),
            (Cells::Texts(texts), _) => texts.push(String::new()),
        }
    };
    put(Put::Count(*index as i64));
    for number in carried {
        put(Put::Number(*number));
    }
    for entry in *entries {
        put(match entry {
            Entry::Number(number) => Put::Number(*number),
            Entry::Text(text) => Put::Text(text.clone()),
        });
    }
    put(Put::Text(outcome.status().to_owned()));
    let solution = match outcome {
        Outcome::Solved(solution) => Some(solution),
        Outcome::Failed(_) => None,
    };
    let given = 2 + carried.len() + entries.len();
    let taken: Vec<&str> = columns[..given].iter().map(|column| column.name.as_str()).collect();
    for column in results(&taken) {
        let value = solution.map_or(Value::Unknown, |solution| (column.value)(solution, 0));
        put(Put::Number(value.number().unwrap_or(f64::NAN)));
    }
    let codes = solution.map_or_else(Vec::new, |solution| {
        let mut codes: Vec<&str> = solution.warnings.iter().map(Warning::code).collect();
        codes.dedup();
        codes
    });
    put(Put::Text(codes.join(" ")));
    put(Put::Text(match outcome {
        Outcome::Solved(_) => String::new(),
        Outcome::Failed(reason) => reason.clone(),
    }));
}

enum Put {
    Count(i64),
    Number(f64),
    Text(String),
}
