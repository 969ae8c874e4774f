//! Maps of coefficients of wear.

use schlupf::analysis::damage::WearMap;
use schlupf::reporting::Requirement;

use super::columns::Columns;
use super::layouts::WEAR_MAP as COLUMNS;
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::readable;
use crate::names::FieldNames;

const FILE: FieldPath = field!("damage.wear_map");

/// A map from a CSV file: in each row the slip speed and the pressure over the hardness from which
/// on a coefficient holds, up to the next of each. There is a row for every pair, in any order.
pub fn from_csv(name: String, bytes: Vec<u8>) -> Result<WearMap, CaseError> {
    let columns = Columns::read(name, bytes, &FILE, &COLUMNS)?;
    let requirements = [
        Requirement::Between(0.0, f64::MAX),
        Requirement::Between(0.0, f64::MAX),
        Requirement::Between(0.0, 1.0),
    ];
    for ((column, values), requirement) in COLUMNS.iter().zip(&columns.values).zip(requirements) {
        if let Some(row) = values.iter().position(|value| !requirement.holds(*value)) {
            let unit = column.unit();
            let needed = match requirement {
                Requirement::Between(_, most) if most < f64::MAX => {
                    requirement.text(unit, &FieldNames::CASE)
                }
                _ => "at least 0".to_owned(),
            };
            let (name, value) = (column.name, readable(values[row]));
            let message = format!("{name} must be {needed}, but is {value} {unit}");
            return Err(columns.error(columns.lines[row], message.trim_end()));
        }
    }
    let [speeds, ratios, coefficients] = &columns.values[..] else { return Err(empty(&columns)) };
    let edges = |values: &[f64]| {
        let mut edges = values.to_vec();
        edges.sort_unstable_by(f64::total_cmp);
        edges.dedup();
        edges
    };
    let (across, down) = (edges(speeds), edges(ratios));
    for (values, column) in [(&across, &COLUMNS[0]), (&down, &COLUMNS[1])] {
        let Some(first) = values.first() else { return Err(empty(&columns)) };
        if *first != 0.0 {
            let (name, first) = (column.name, readable(*first));
            let message = format!("{name} must begin at 0, but its lowest value is {first}");
            return Err(columns.error(columns.header_line, message));
        }
    }
    let (count, expected) = (columns.lines.len(), across.len() * down.len());
    if count < expected {
        let [speeds, ratios] = [across.len(), down.len()];
        let message = format!(
            "a map with {speeds} slip speeds and {ratios} pressures needs {expected} rows, but has \
             {count}"
        );
        return Err(columns.error(columns.header_line, message));
    }
    let mut table = vec![f64::NAN; expected];
    for (row, line) in columns.lines.iter().enumerate() {
        let place = |edges: &[f64], value: f64| edges.partition_point(|edge| *edge < value);
        let at = place(&down, ratios[row]) * across.len() + place(&across, speeds[row]);
        if !table[at].is_nan() {
            let [speed, ratio] = [speeds[row], ratios[row]].map(readable);
            let message = format!("there is a row for {speed} m/s and p/H = {ratio} already");
            return Err(columns.error(*line, message));
        }
        table[at] = coefficients[row];
    }
    WearMap::new(across, down, table)
        .map_err(|error| columns.error(columns.header_line, error.to_string()))
}

fn empty(columns: &Columns) -> CaseError {
    columns.error(columns.header_line, format!("{FILE} must have a row, but has none"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<WearMap, String> {
        from_csv("m.csv".to_owned(), text.as_bytes().to_vec()).map_err(|error| error.to_string())
    }

    #[test]
    fn rows_may_have_any_order() {
        let map = read(
            "coefficient,slip_speed [mm/s],pressure_ratio\n4e-4,500,0.4\n1e-4,0,0\n\
             3e-4,0,0.4\n2e-4,500,0\n",
        );
        let expected =
            WearMap::new(vec![0.0, 0.5], vec![0.0, 0.4], vec![1e-4, 2e-4, 3e-4, 4e-4]).unwrap();
        assert_eq!(map.unwrap(), expected);
    }

    #[test]
    fn what_is_no_map_is_refused_with_its_line() {
        let head = "slip_speed [m/s],pressure_ratio,coefficient\n";
        for (rows, part) in [
            ("", "m.csv:1"),
            ("0,0,2\n", "m.csv:2:1: coefficient must be between 0 and 1, but is 2"),
            ("-1,0,1e-4\n", "m.csv:2:1: slip_speed must be at least 0, but is -1 m/s"),
            ("0.1,0,1e-4\n", "slip_speed must begin at 0, but its lowest value is 0.1"),
            ("0,0,1e-4\n0,0,2e-4\n", "m.csv:3:1: there is a row for 0 m/s and p/H = 0 already"),
            ("0,0,1e-4\n0.2,0.5,2e-4\n", "2 slip speeds and 2 pressures needs 4 rows, but has 2"),
        ] {
            let error = read(&format!("{head}{rows}")).unwrap_err();
            assert!(error.contains(part), "{rows:?}: {error}");
        }
        assert!(read("slip_speed,pressure_ratio,coefficient\n0,0,1e-4\n").is_err(), "no unit");
    }
}
