//! What varies in a study: its fields and their values in every row.

mod sample;
mod sobol;
mod states;

pub use sample::{Method, Sample};

pub(crate) use states::read as read_states;

pub use crate::states::Entry;
pub(crate) use crate::states::assignment;
use schlupf_case::fields::Field;
use schlupf_case::{CaseFile, FieldPath, Setting, field};

/// The field with the source of the pressure, and its name for two profiles.
const NORMAL_MODEL: FieldPath = field!("normal.model");
const WHEEL_RAIL: &str = "wheel-rail";

/// Values of a field, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers in SI units.
    Numbers(Vec<f64>),
    /// Anything else.
    Texts(Vec<String>),
}

impl Values {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Texts(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One of them.
    pub fn entry(&self, k: usize) -> Entry {
        match self {
            Self::Numbers(values) => Entry::Number(values[k]),
            Self::Texts(values) => Entry::Text(values[k].clone()),
        }
    }

    /// The place of a value that stands before it, too.
    pub fn repeated(&self) -> Option<usize> {
        /// The first place of a value that an earlier place has.
        fn first<T: Ord>(values: impl Iterator<Item = T>) -> Option<usize> {
            let mut places: Vec<(T, usize)> = values.zip(0..).collect();
            places.sort_unstable();
            let twice = places.windows(2).filter(|two| two[0].0 == two[1].0);
            twice.map(|two| two[1].1).min()
        }
        match self {
            // Zero has two signs, but is one value.
            Self::Numbers(values) => first(values.iter().map(|value| (value + 0.0).to_bits())),
            Self::Texts(values) => first(values.iter()),
        }
    }

    /// Whether they are numbers.
    pub fn are_numbers(&self) -> bool {
        matches!(self, Self::Numbers(_))
    }
}

/// A field that varies, with its values.
#[derive(Debug, Clone)]
pub struct Varied {
    /// The field.
    pub field: &'static Field,
    /// Its values: in every row, or those that a factorial combines.
    pub values: Values,
}

/// A column of states that no field is: it comes back in the table, so that rows can be told apart.
#[derive(Debug, Clone)]
pub struct Carried {
    /// Its name.
    pub name: &'static str,
    /// The SI unit.
    pub unit: &'static str,
    /// Its numbers.
    pub values: Vec<f64>,
}

/// The rows of a study.
#[derive(Debug, Clone)]
pub enum Design {
    /// All combinations; the last field varies fastest.
    Factorial(Vec<Varied>),
    /// A value of each field for every row, and what is carried along.
    Rows(Vec<Varied>, Vec<Carried>),
}

impl Design {
    /// The fields that vary.
    pub fn varied(&self) -> &[Varied] {
        match self {
            Self::Factorial(varied) | Self::Rows(varied, _) => varied,
        }
    }

    /// Columns that are carried along.
    pub fn carried(&self) -> &[Carried] {
        match self {
            Self::Factorial(_) => &[],
            Self::Rows(_, carried) => carried,
        }
    }

    /// Whether any of the states of a case may be of a wheel with profiles.
    pub(crate) fn has_wheel(&self, case: &CaseFile) -> bool {
        let mut models = self.varied().iter().filter(|varied| varied.field.path == NORMAL_MODEL);
        case.value(NORMAL_MODEL) == Some(Setting::Choice(WHEEL_RAIL))
            || models.any(|varied| match &varied.values {
                Values::Texts(names) => names.iter().any(|name| name == WHEEL_RAIL),
                Values::Numbers(_) => false,
            })
    }

    /// Number of rows; `None` if they are too many to count.
    pub fn rows(&self) -> Option<usize> {
        let mut lengths = self.varied().iter().map(|varied| varied.values.len());
        match self {
            Self::Factorial(_) => lengths.try_fold(1_usize, usize::checked_mul),
            Self::Rows(..) => lengths.next(),
        }
    }

    /// The value of each field in a row.
    pub fn row(&self, row: usize) -> Vec<Entry> {
        let varied = self.varied();
        if matches!(self, Self::Rows(..)) {
            return varied.iter().map(|varied| varied.values.entry(row)).collect();
        }
        let mut entries: Vec<Entry> = Vec::with_capacity(varied.len());
        let mut rest = row;
        for Varied { values, .. } in varied.iter().rev() {
            entries.push(values.entry(rest % values.len()));
            rest /= values.len();
        }
        entries.reverse();
        entries
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn varied(path: FieldPath, values: &[f64]) -> Varied {
        Varied { field: path.field(), values: Values::Numbers(values.to_vec()) }
    }

    #[test]
    fn the_last_field_of_a_factorial_varies_fastest() {
        let design = Design::Factorial(vec![
            varied(field!("normal.load"), &[1.0, 2.0]),
            varied(field!("kinematics.creepage_x"), &[0.1, 0.2, 0.3]),
        ]);
        assert_eq!(design.rows(), Some(6));
        let rows: Vec<Vec<Entry>> = (0..6).map(|row| design.row(row)).collect();
        assert_eq!(rows[1], [Entry::Number(1.0), Entry::Number(0.2)]);
        assert_eq!(rows[3], [Entry::Number(2.0), Entry::Number(0.1)]);
    }

    #[test]
    fn assignments_can_be_read_by_a_case() {
        let load = field!("normal.load").field();
        assert_eq!(assignment(load, &Entry::Number(8e4)), "normal.load=\"80000.0 N\"");
        let method = field!("solver.method").field();
        let polach = Entry::Text("polach".to_owned());
        assert_eq!(assignment(method, &polach), "solver.method=polach");
        let cells = field!("grid.cells_x").field();
        assert_eq!(assignment(cells, &Entry::Text("12".to_owned())), "grid.cells_x=12");
    }
}
