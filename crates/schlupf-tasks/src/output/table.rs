//! Records as tables: CSV, and the arrays of a JSON document.

use schlupf::Quantity;
use schlupf::reporting::{Column, Record, Value};
use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::output::number::without_sign_of_zero;

/// A column of a table as an array.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnValues {
    /// Name in results.
    pub name: &'static str,
    /// The quantity: symbol, unit, description.
    pub quantity: Quantity,
    /// Its entries, row by row.
    pub values: Values,
}

/// The entries of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers in the unit of the quantity; unknown ones are not a number.
    Numbers(Vec<f64>),
    /// Whole numbers.
    Counts(Vec<usize>),
    /// Yes or no.
    Flags(Vec<bool>),
    /// Names; unknown ones are empty.
    Names(Vec<&'static str>),
}

/// The columns of a record as arrays.
pub fn columns<R: Record + ?Sized>(record: &R) -> Vec<ColumnValues> {
    let column = |column: &Column<R>| {
        let entries = || (0..record.rows()).map(|row| (column.value)(record, row));
        let is_known = |entry: &Value| *entry != Value::Unknown;
        let values = match entries().find(is_known) {
            Some(Value::Name(_)) => Values::Names(
                entries()
                    .map(|entry| if let Value::Name(name) = entry { name } else { "" })
                    .collect(),
            ),
            Some(Value::Flag(_)) if entries().all(|entry| is_known(&entry)) => {
                Values::Flags(entries().map(|entry| entry == Value::Flag(true)).collect())
            }
            Some(Value::Count(_)) if entries().all(|entry| is_known(&entry)) => Values::Counts(
                entries().map(|entry| entry.number().unwrap_or_default() as usize).collect(),
            ),
            _ => {
                Values::Numbers(entries().map(|entry| entry.number().unwrap_or(f64::NAN)).collect())
            }
        };
        ColumnValues { name: column.name, quantity: column.quantity, values }
    };
    R::COLUMNS.iter().map(column).collect()
}

/// A table of text.
#[derive(Debug, Default)]
pub(crate) struct Table {
    names: Vec<String>,
    units: Vec<String>,
    rows: Vec<String>,
}

impl Table {
    /// A table with a column of text before the columns of records.
    pub fn with(mut self, name: &str, unit: &str) -> Self {
        self.names.push(name.to_owned());
        self.units.push(unit.to_owned());
        self
    }

    /// The same table with the columns of a record added.
    pub fn with_columns<R: Record + ?Sized>(mut self) -> Self {
        for column in R::COLUMNS {
            self = self.with(column.name, unit(column.quantity));
        }
        self
    }

    /// Adds a row.
    pub fn push(&mut self, entries: impl IntoIterator<Item = String>) {
        self.rows.push(entries.into_iter().collect::<Vec<_>>().join(","));
    }

    /// The table as CSV; `note` contains additional information, written after the units.
    pub fn csv(&self, note: &str) -> String {
        let note = if note.is_empty() { String::new() } else { format!("; {note}") };
        let head = format!("# units: {}{note}\n{}\n", self.units.join(", "), self.names.join(","));
        self.rows.iter().fold(head, |text, row| text + row + "\n")
    }
}

/// A record as CSV.
pub(crate) fn csv<R: Record + ?Sized>(record: &R, note: &str) -> String {
    let mut table = Table::default().with_columns::<R>();
    for row in 0..record.rows() {
        table.push(entries(record, row));
    }
    table.csv(note)
}

/// The entries of a row.
pub(crate) fn entries<R: Record + ?Sized>(record: &R, row: usize) -> impl Iterator<Item = String> {
    R::COLUMNS.iter().map(move |column| entry((column.value)(record, row)))
}

/// An entry: the shortest text that reads back as the same number.
pub(crate) fn entry(value: Value) -> String {
    match value {
        Value::Number(number) if number.is_finite() => {
            format!("{:e}", without_sign_of_zero(number))
        }
        Value::Count(count) => count.to_string(),
        Value::Flag(flag) => u8::from(flag).to_string(),
        Value::Name(name) => name.to_owned(),
        Value::Number(_) | Value::Unknown => String::new(),
    }
}

/// The unit of the entries of a column.
fn unit(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Sliding => "0 or 1",
        Quantity::Convergence => "converged or not-converged",
        Quantity::Component => "x or y",
        Quantity::WheelSide => "left or right",
        Quantity::Method | Quantity::Elasticity => "name",
        other if other.unit().is_empty() => "1",
        other => other.unit(),
    }
}

/// A text, quoted if it would otherwise not be a single entry (RFC 4180).
pub(crate) fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r', '#']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// A record as arrays of the same length, one for each column.
pub(crate) struct Arrays<'a, R: ?Sized>(pub &'a R);

impl<R: Record + ?Sized> Serialize for Arrays<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(R::COLUMNS.len()))?;
        for column in R::COLUMNS {
            let values = (0..self.0.rows()).map(|row| Entry((column.value)(self.0, row)));
            map.serialize_entry(column.name, &values.collect::<Vec<_>>())?;
        }
        map.end()
    }
}

/// The first row of a record; all entries are `null` if there is no record.
pub(crate) struct Row<'a, R: ?Sized>(pub Option<&'a R>);

impl<R: Record + ?Sized> Serialize for Row<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(R::COLUMNS.len()))?;
        for column in R::COLUMNS {
            let value = self.0.map_or(Value::Unknown, |record| (column.value)(record, 0));
            map.serialize_entry(column.name, &Entry(value))?;
        }
        map.end()
    }
}

/// A value in JSON form.
pub(crate) struct Entry(pub Value);

impl Serialize for Entry {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Number(number) => serializer.serialize_f64(number),
            Value::Count(count) => serializer.serialize_u64(count as u64),
            Value::Flag(flag) => serializer.serialize_bool(flag),
            Value::Name(name) => serializer.serialize_str(name),
            Value::Unknown => serializer.serialize_none(),
        }
    }
}
