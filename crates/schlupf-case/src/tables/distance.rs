//! Undeformed distance of wheel and rail: on a lattice, or across at x = 0.

use schlupf::normal::profile::UndeformedDistance;

use super::columns::Columns;
use super::lattice::{self, FILE, NpyFile};
use super::layouts::DISTANCE as COLUMNS;
use crate::error::CaseError;
use crate::names::FieldNames;

/// The distance from a CSV file: with columns x, y and distance on a lattice, its rows in any
/// order; with y and distance alone across at x = 0, where `rolling_radius` gives the relative
/// radius (in m) along rolling; with x and distance alone along it, where `length` gives the length
/// of the line contact, in m.
pub fn from_csv(
    name: String,
    bytes: Vec<u8>,
    rolling_radius: impl Fn() -> Result<f64, CaseError>,
    length: impl Fn() -> Result<f64, CaseError>,
) -> Result<UndeformedDistance, CaseError> {
    let columns = Columns::read(name, bytes, &FILE, &COLUMNS)?;
    let [xs, ys, distances] = &columns.values[..] else {
        return Err(columns.error(columns.header_line, "columns are missing"));
    };
    let sorted = |order: &[usize], values: &[f64]| order.iter().map(|row| values[*row]).collect();
    let distance = if columns.has(0) && columns.has(1) {
        let help = "give the distance everywhere, or the column y alone for a profile across";
        let table = lattice::from_columns(&columns, [xs, ys, distances], help)?;
        UndeformedDistance::on_lattice(table.x, table.y, table.values)
    } else {
        let (name, places) = match [columns.has(0), columns.has(1)] {
            [true, _] => ('x', xs),
            [false, true] => ('y', ys),
            [false, false] => {
                let message = "column `y` is missing, or `x`, or both";
                return Err(columns.error(columns.header_line, message));
            }
        };
        let order = ascending(&columns, name, places)?;
        let [places, distances] = [places, distances].map(|values| sorted(&order, values));
        if name == 'x' {
            UndeformedDistance::along(places, distances, length()?)
        } else {
            UndeformedDistance::across(places, distances, rolling_radius()?)
        }
    };
    distance.map_err(|error| columns.error(columns.header_line, error.text(&FieldNames::CASE)))
}

/// The rows in the order of a position, each of which must be given once.
fn ascending(columns: &Columns, name: char, ys: &[f64]) -> Result<Vec<usize>, CaseError> {
    let mut order: Vec<usize> = (0..ys.len()).collect();
    order.sort_unstable_by(|a, b| ys[*a].total_cmp(&ys[*b]));
    let twice = order.windows(2).find(|pair| ys[pair[0]] == ys[pair[1]]);
    let Some(&[first, second]) = twice else { return Ok(order) };
    let message = format!(
        "every {name} must be given once, but {name} = {} mm stands in line {} too (for a distance that changes \
         in both directions give columns `x` and `y`)",
        lattice::millimetres(ys[first]),
        columns.lines[first.min(second)]
    );
    Err(columns.error(columns.lines[first.max(second)], message))
}

/// The distance from an .npy file, in m.
pub fn from_npy(file: &NpyFile) -> Result<UndeformedDistance, CaseError> {
    let table = file.table(f64::is_finite, "finite distances")?;
    UndeformedDistance::on_lattice(table.x, table.y, table.values)
        .map_err(|cause| file.error(&format!("is no distance: {}", cause.text(&FieldNames::CASE))))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLANE: &str = "# worn\nx [mm],y [mm],distance [um]\n0,0,1\n1,0,1\n2,0,1\n3,0,1\n\
                         0,1,1\n1,1,1\n2,1,1\n3,1,1\n0,2,1\n1,2,1\n2,2,1\n3,2,1\n0,3,1\n1,3,1\n2,3,1\n3,3,1\n";
    const LINE: &str = "y [mm],distance [mm]\n# left\n2,0.4\n1,0.1\n0,0\n-1,0.1\n";

    fn read(text: &str) -> Result<UndeformedDistance, String> {
        let read = from_csv("d.csv".to_owned(), text.as_bytes().to_vec(), || Ok(0.46), || Ok(0.2));
        read.map_err(|error| error.to_string())
    }

    #[test]
    fn a_profile_may_run_either_way() {
        let expected = UndeformedDistance::across(
            vec![-1e-3, 0.0, 1e-3, 2e-3],
            vec![1e-4, 0.0, 1e-4, 4e-4],
            0.46,
        );
        assert_eq!(read(LINE).unwrap(), expected.unwrap());
        assert!(read(PLANE).is_ok());
        let along = UndeformedDistance::along(
            vec![-1e-3, 0.0, 1e-3, 2e-3],
            vec![1e-4, 0.0, 1e-4, 4e-4],
            0.2,
        );
        assert_eq!(read(&LINE.replace("y [mm]", "x [mm]")).unwrap(), along.unwrap());
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let cases = [
            (
                PLANE,
                "1,1,1\n",
                "",
                "d.csv:7:1: the points must fill a rectangle of 4 by 4, but 1 of them",
            ),
            (PLANE, "1,1,1\n", "1.5,1,1\n", "must be equidistant"),
            (PLANE, "1,1,1\n", "1,1,nan\n", "d.csv:8:1: distance must be a finite number"),
            (PLANE, "1,1,1\n", "0,1,1\n", "d.csv:8:1: every point must be given once"),
            (PLANE, "[um]", "", "d.csv:2:1: column `distance` must name its unit"),
            (PLANE, "[um]", "[MPa]", "column `distance` must name its unit"),
            (PLANE, "distance", "gap", "has a column `gap"),
            (PLANE, "x [mm],y", "y [mm],z", "has a column `z"),
            (LINE, LINE, "distance [mm]\n1\n", "column `y` is missing"),
            (
                LINE,
                "1,0.1\n",
                "2,0.1\n",
                "d.csv:4:1: every y must be given once, but y = 2 mm stands in line 3",
            ),
            (LINE, "1,0.1\n", "", "at least 4 values of y, got 3"),
            (LINE, LINE, "y [mm],distance [mm]\n", "at least 4 values of y, got 0"),
        ];
        for (text, from, to, expected) in cases {
            let message = read(&text.replacen(from, to, 1)).unwrap_err();
            assert!(message.contains(expected), "{from:?} -> {to:?}: {message}");
        }
    }
}
