//! The columns of a study's table, and a row of it.

use crate::states::{CONTACTS, FAILED, NO_CONTACT};
use schlupf::reporting::{Column as ResultColumn, Message, Record, Value};
use schlupf::wheel_rail::{Contact, WheelSolution};
use schlupf::{Quantity, Solution};
use schlupf_case::DataUrl;

use crate::study::design::{Design, Entry, Values};
use crate::study::table::{Cells, Column, Kind, Rows};

/// What a column of results is of.
#[derive(Clone, Copy)]
pub(crate) enum ResultOf {
    State(&'static ResultColumn<Solution>),
    Wheel(&'static ResultColumn<WheelSolution>),
    /// Of a contact of a wheel, by its place.
    Contact(usize, &'static ResultColumn<Contact>),
}

impl ResultOf {
    fn quantity(self) -> Quantity {
        match self {
            Self::State(column) => column.quantity,
            Self::Wheel(column) => column.quantity,
            Self::Contact(_, column) => column.quantity,
        }
    }

    fn name(self) -> String {
        match self {
            Self::State(column) => column.name.to_owned(),
            Self::Wheel(column) => column.name.to_owned(),
            Self::Contact(place, column) => contact_column(place, column.name),
        }
    }

    fn of(self, outcome: &Outcome) -> f64 {
        let value = match (outcome, self) {
            (Outcome::Solved { solution, .. }, Self::State(column)) => (column.value)(solution, 0),
            (Outcome::Solved { wheel: Some(wheel), .. }, Self::Wheel(column)) => {
                (column.value)(wheel, 0)
            }
            (Outcome::Solved { wheel: Some(wheel), .. }, Self::Contact(place, column)) => {
                let contact = wheel.contacts.get(place);
                contact.map_or(Value::Unknown, |contact| (column.value)(contact, 0))
            }
            // What acts is none: forces, moments, powers, areas.
            (Outcome::NoContact, _) if ACTS.contains(&self.quantity().unit()) => Value::Number(0.0),
            _ => Value::Unknown,
        };
        value.number().unwrap_or(f64::NAN)
    }
}

/// Units of what acts, or on what.
const ACTS: [&str; 4] = ["N", "N m", "W", "m^2"];

/// The name of a column of a contact, by its place.
pub(crate) fn contact_column(place: usize, name: &str) -> String {
    format!("contact_{}.{name}", place + 1)
}

/// The name of a column of results in a table that has a field of the same name.
pub(crate) fn beside_field(name: &str) -> String {
    format!("result.{name}")
}

/// The columns: the index of the row, what varies, the status, results under the dotted names of
/// the JSON of a solution, codes of warnings, and why a row failed.
pub(crate) fn columns(design: &Design, has_wheel: bool) -> Vec<Column> {
    let mut columns = vec![Column::new("index", "", Kind::Count)];
    let carried = design.carried().iter();
    columns.extend(carried.map(|column| Column::new(column.name, column.unit, Kind::Number)));
    columns.extend(design.varied().iter().map(|varied| {
        let kind = match varied.values {
            Values::Numbers(_) => Kind::Number,
            Values::Texts(_) => Kind::Text,
        };
        Column::new(&varied.field.path, varied.field.kind.unit(), kind)
    }));
    columns.push(Column::new("status", "", Kind::Text));
    let taken: Vec<String> = columns.iter().map(|column| column.name.clone()).collect();
    columns.extend(results(has_wheel).map(|of| {
        let name = of.name();
        let name = if taken.contains(&name) { beside_field(&name) } else { name };
        Column::new(&name, of.quantity().unit(), Kind::Number)
    }));
    columns.push(Column::new("warnings", "", Kind::Text));
    columns.push(Column::new("error", "", Kind::Text));
    columns
}

/// The results that a table has.
pub(crate) fn results(has_wheel: bool) -> impl Iterator<Item = ResultOf> {
    let state = <Solution as Record>::COLUMNS.iter().map(ResultOf::State);
    let wheel = <WheelSolution as Record>::COLUMNS.iter().map(ResultOf::Wheel);
    let contacts = (0..CONTACTS).flat_map(|place| {
        <Contact as Record>::COLUMNS.iter().map(move |column| ResultOf::Contact(place, column))
    });
    state.chain(wheel.chain(contacts).filter(move |_| has_wheel))
}

/// What became of a state.
pub(crate) enum Outcome {
    Solved {
        solution: Box<Solution>,
        /// The wheel, if the case has profiles.
        wheel: Option<std::sync::Arc<WheelSolution>>,
        /// Its warnings, each kind once.
        warnings: Vec<Message>,
    },
    /// There is no normal load, or the wheel does not touch the rail.
    NoContact,
    /// Why not.
    Failed(String),
}

impl Outcome {
    /// Name of the status in a table.
    fn status(&self) -> &'static str {
        match self {
            Self::Solved { solution, wheel, .. } => {
                let wheel = wheel.as_ref();
                wheel.map_or(solution.status, |wheel| wheel.status()).name()
            }
            Self::NoContact => NO_CONTACT,
            Self::Failed(_) => FAILED,
        }
    }
}

/// A row of a table.
pub(crate) struct Row<'a> {
    pub index: usize,
    pub carried: Vec<f64>,
    pub entries: &'a [Entry],
    /// Whether the table has the columns of a wheel.
    pub has_wheel: bool,
    pub outcome: &'a Outcome,
}

/// Adds a row to a table with these columns.
pub(crate) fn push(rows: &mut Rows, row: &Row) {
    let Row { index, carried, entries, has_wheel, outcome } = row;
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
            Entry::Text(text) => Put::Text(DataUrl::label(text).to_owned()),
        });
    }
    put(Put::Text(outcome.status().to_owned()));
    for of in results(*has_wheel) {
        put(Put::Number(of.of(outcome)));
    }
    let codes = match outcome {
        Outcome::Solved { warnings, .. } => {
            let mut codes: Vec<&str> = warnings.iter().map(|warning| warning.code).collect();
            codes.sort_unstable();
            codes.dedup();
            codes.join(" ")
        }
        Outcome::NoContact | Outcome::Failed(_) => String::new(),
    };
    put(Put::Text(codes));
    put(Put::Text(match outcome {
        Outcome::Failed(reason) => reason.clone(),
        Outcome::Solved { .. } | Outcome::NoContact => String::new(),
    }));
}

enum Put {
    Count(i64),
    Number(f64),
    Text(String),
}
