//! Measured points of creep curves.

use schlupf::analysis::identification::{Component, Condition, DataPoint};
use schlupf::bodies::Kinematics;

use super::columns::{Column, Columns};
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::{NOT_PER_CENT, Requirement, creepage_in_per_cent, readable};
use crate::names::FieldNames;
use crate::units::Measure;

/// A column, and what its numbers must be: as in a field of the case, or this.
struct Given {
    column: Column,
    requirement: Result<FieldPath, Requirement>,
}

const fn plain(name: &'static str, requirement: Result<FieldPath, Requirement>) -> Given {
    Given { column: Column { name, measure: None, required: false, holes: false }, requirement }
}

const fn quantity(name: &'static str, measure: &'static Measure, field: FieldPath) -> Given {
    Given {
        column: Column { name, measure: Some(measure), required: false, holes: false },
        requirement: Ok(field),
    }
}

/// More no friction gives: such a number is no ratio.
const RATIO: Requirement = Requirement::Magnitude(3.0);
const DEVIATION: Requirement = Requirement::AboveUpTo(0.0, 1.0);

const GIVEN: [Given; 9] = [
    plain("creepage_x", Ok(field!("kinematics.creepage_x"))),
    plain("creepage_y", Ok(field!("kinematics.creepage_y"))),
    quantity("spin", &Measure::SPIN, field!("kinematics.spin")),
    plain("force_ratio", Err(RATIO)),
    plain("force_ratio_x", Err(RATIO)),
    plain("force_ratio_y", Err(RATIO)),
    quantity("speed", &Measure::SPEED, field!("kinematics.speed")),
    quantity("load", &Measure::FORCE, field!("normal.load")),
    plain("standard_deviation", Err(DEVIATION)),
];

/// The columns of a table of measured points.
pub const COLUMNS: [Column; GIVEN.len()] = {
    let mut columns = [GIVEN[0].column; GIVEN.len()];
    let mut place = 1;
    while place < GIVEN.len() {
        columns[place] = GIVEN[place].column;
        place += 1;
    }
    columns
};

/// Places of the columns in the table.
const CREEPAGE_X: usize = 0;
const CREEPAGE_Y: usize = 1;
const SPIN: usize = 2;
const FORCE: usize = 3;
const FORCE_X: usize = 4;
const FORCE_Y: usize = 5;
const SPEED: usize = 6;
const LOAD: usize = 7;
const STANDARD_DEVIATION: usize = 8;

/// Points of a CSV file that `option` names. What has no column is that of `kinematics`.
pub fn from_csv(
    option: &str,
    name: String,
    bytes: Vec<u8>,
    kinematics: &Kinematics,
) -> Result<Vec<DataPoint>, CaseError> {
    let columns = Columns::read(name, bytes, option, &COLUMNS)?;
    check_numbers(&columns)?;
    let forces = forces(&columns)?;
    let mut points = Vec::new();
    for (row, line) in columns.lines.iter().enumerate() {
        let value = |column: usize| columns.values[column].get(row).copied();
        let kinematics = Kinematics {
            speed: value(SPEED).unwrap_or(kinematics.speed),
            creepage_x: value(CREEPAGE_X).unwrap_or(kinematics.creepage_x),
            creepage_y: value(CREEPAGE_Y).unwrap_or(kinematics.creepage_y),
            spin: value(SPIN).unwrap_or(kinematics.spin),
            ..*kinematics
        };
        kinematics.check().map_err(|error| {
            let help = value(CREEPAGE_X).and_then(|x| creepage_in_per_cent("creepage_x", x));
            columns.error(*line, error.to_string()).help(help)
        })?;
        let condition = Condition { kinematics, load: value(LOAD) };
        for (column, component) in &forces {
            points.push(DataPoint {
                condition,
                component: *component,
                force_ratio: value(*column).unwrap_or(f64::NAN),
                standard_deviation: value(STANDARD_DEVIATION),
            });
        }
    }
    if points.is_empty() {
        return Err(columns.error(columns.header_line, format!("{option} must have points")));
    }
    Ok(points)
}

fn check_numbers(columns: &Columns) -> Result<(), CaseError> {
    for (Given { column, requirement }, values) in GIVEN.iter().zip(&columns.values) {
        let requirement = match requirement {
            Ok(path) => path.field().requirement,
            Err(requirement) => *requirement,
        };
        let Some(row) = values.iter().position(|value| !requirement.holds(*value)) else {
            continue;
        };
        let (name, value) = (column.name, readable(values[row]));
        let unit = column.unit();
        let text = requirement.text(unit, &FieldNames::CASE);
        let message = format!("{name} must be {text}, but is {value} {unit}");
        let error = columns.error(columns.lines[row], message.trim_end());
        let help = if name.starts_with("force_ratio") {
            Some("it is the force over the load, F/N, neither in N nor in per cent".to_owned())
        } else if name == GIVEN[STANDARD_DEVIATION].column.name && values[row] > 1.0 {
            Some(NOT_PER_CENT.to_owned())
        } else {
            creepage_in_per_cent(name, values[row])
        };
        return Err(error.help(help));
    }
    Ok(())
}

/// The columns of forces, with their components.
fn forces(columns: &Columns) -> Result<Vec<(usize, Component)>, CaseError> {
    let has = |column: usize| !columns.values[column].is_empty();
    let error = |message: &str| Err(columns.error(columns.header_line, message));
    if columns.lines.is_empty() {
        return Ok(Vec::new());
    }
    if ![CREEPAGE_X, CREEPAGE_Y, SPIN].into_iter().any(has) {
        return error("a column creepage_x, creepage_y or spin is missing");
    }
    let named = [(FORCE_X, Component::Longitudinal), (FORCE_Y, Component::Lateral)];
    let named: Vec<_> = named.into_iter().filter(|(column, _)| has(*column)).collect();
    match (has(FORCE), named.is_empty()) {
        (false, true) => error("a column force_ratio, force_ratio_x or force_ratio_y is missing"),
        (false, false) => Ok(named),
        (true, false) => {
            error("force_ratio must not be given beside force_ratio_x or force_ratio_y")
        }
        (true, true) => match [has(CREEPAGE_X), has(CREEPAGE_Y)] {
            [true, false] => Ok(vec![(FORCE, Component::Longitudinal)]),
            [false, true] => Ok(vec![(FORCE, Component::Lateral)]),
            _ => error(
                "force_ratio says its direction only beside one of creepage_x and creepage_y: call it \
                 force_ratio_x or force_ratio_y",
            ),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OWN: Kinematics = Kinematics::free_rolling(30.0);

    fn read(text: &str) -> Result<Vec<DataPoint>, String> {
        let bytes = text.as_bytes().to_vec();
        from_csv("--data", "d.csv".to_owned(), bytes, &OWN).map_err(|error| error.to_string())
    }

    #[test]
    fn missing_columns_are_those_of_the_case() {
        let points = read("# a curve\ncreepage_x,force_ratio\n0.001,0.1\n0.01,0.3\n").unwrap();
        assert_eq!(points.len(), 2);
        assert_eq!(points[1].condition.kinematics, Kinematics { creepage_x: 0.01, ..OWN });
        assert_eq!((points[1].condition.load, points[1].standard_deviation), (None, None));
        assert_eq!((points[1].component, points[1].force_ratio), (Component::Longitudinal, 0.3));
    }

    #[test]
    fn columns_are_converted_and_components_are_points() {
        let text = "speed [km/h],load [kN],spin [1/mm],creepage_y,force_ratio_x,force_ratio_y,standard_deviation\n\
                    36,80,0.001,0.002,0,0.2,0.01\n";
        let points = read(text).unwrap();
        let [x, y] = points.as_slice() else { panic!("{points:?}") };
        let condition = x.condition;
        assert_eq!(condition, y.condition);
        assert_eq!((condition.kinematics.speed, condition.load), (10.0, Some(80e3)));
        assert_eq!((condition.kinematics.spin, condition.kinematics.creepage_y), (1.0, 0.002));
        assert_eq!((x.component, y.component), (Component::Longitudinal, Component::Lateral));
        assert_eq!((y.force_ratio, y.standard_deviation), (0.2, Some(0.01)));
        let lateral = read("creepage_y,force_ratio\n0.001,0.1\n").unwrap();
        assert_eq!(lateral[0].component, Component::Lateral);
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let cases = [
            (
                "creepage_x,force_ratio\n0.1,30\n",
                "d.csv:2:1: force_ratio must be finite and at most",
            ),
            ("creepage_x,force_ratio\n0.1,30\n", "neither in N nor in per cent"),
            ("creepage_x,force_ratio\n1.5,0.3\n", "d.csv:2:1: creepage_x must be below"),
            ("creepage_x,force_ratio\n1.539,0.3\n", "not a percentage: 1 % is 0.01"),
            ("creepage_y,force_ratio\n1.539,0.3\n", "not a percentage: 1 % is 0.01"),
            ("creepage_x [%],force_ratio\n0.5,0.3\n", "d.csv:1:1: column `creepage_x` must be dim"),
            ("creepage_x [%],force_ratio\n0.5,0.3\n", "not a percentage: 1 % is 0.01"),
            ("creepage_x,force_ratio [%]\n0.5,0.3\n", "not a percentage: 1 % is 0.01"),
            (
                "creepage_x,force_ratio,standard_deviation [%]\n0,0,1\n",
                "column `standard_deviation` must be dimensionless, but has the unit `%` (give a \
                 fraction, not a percentage: 1 % is 0.01)",
            ),
            ("creepage_x,force_ratio,standard_deviation\n0,0,2\n", "not a percentage: 1 % is 0.01"),
            ("creepage_x,force_ratio,speed [m/s]\n0,0,0\n", "d.csv:2:1: speed must be between"),
            ("creepage_x,force_ratio,speed\n0,0,1\n", "column `speed` must name its unit"),
            ("creepage_x\n0\n", "a column force_ratio, force_ratio_x or force_ratio_y is missing"),
            ("force_ratio\n0\n", "a column creepage_x, creepage_y or spin is missing"),
            ("creepage_x,creepage_y,force_ratio\n0,0,0\n", "call it force_ratio_x"),
            ("creepage_x,force_ratio,force_ratio_y\n0,0,0\n", "must not be given beside"),
            ("creepage_x,force_ratio\n", "--data must have points"),
            ("creepage_x,force\n0,0\n", "has a column `force`"),
            (
                "creepage_x,force_ratio,standard_deviation\n0,0,0\n",
                "standard_deviation must be above 0 and at most 1",
            ),
        ];
        for (text, expected) in cases {
            let message = read(text).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
    }
}
