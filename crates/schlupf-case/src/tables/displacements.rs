//! Displacements under known tractions, such as those of a finite-element model.

use schlupf::analysis::calibration::displacements::Sample;
use schlupf::normal::{Axis, BORDER, Grid};

use super::columns::{Column, Columns};
use super::lattice::Lattice;
use crate::error::CaseError;
use crate::files::InputFile;
use crate::units::Measure;

const fn column(name: &'static str, measure: &'static Measure, required: bool) -> Column {
    Column { name, measure: Some(measure), required, holes: false }
}

/// The columns of a table of displacements.
pub const COLUMNS: [Column; 6] = [
    column("x", &Measure::LENGTH, true),
    column("y", &Measure::LENGTH, true),
    column("traction_x", &Measure::PRESSURE, false),
    column("traction_y", &Measure::PRESSURE, false),
    column("displacement_x", &Measure::LENGTH, false),
    column("displacement_y", &Measure::LENGTH, false),
];

/// Traction and displacement of a file: along x and along y, where it has them.
#[derive(Debug, Clone)]
pub struct Displacements {
    /// Its name.
    pub name: String,
    /// One for each component that is loaded.
    pub samples: [Option<Sample>; 2],
}

/// Reads a CSV file that `option` of the command line names: columns x, y and, for one or both
/// components, traction on the wheel and displacement of the wheel relative to the rail. A
/// component without traction is left out.
pub fn read(option: &str, file: &InputFile) -> Result<Displacements, CaseError> {
    let name = file.path().display().to_string();
    let what = format!("the file of {option}");
    let bytes = file.read().map_err(|error| CaseError::unreadable(option, &what, &name, &error))?;
    from_csv(name, bytes, option)
}

fn from_csv(name: String, bytes: Vec<u8>, option: &str) -> Result<Displacements, CaseError> {
    let columns = Columns::read(name.clone(), bytes, option, &COLUMNS)?;
    let [xs, ys, components @ ..] = &columns.values[..] else {
        return Err(columns.error(columns.header_line, "columns x and y are needed"));
    };
    let lattice = Lattice::of(xs, ys, &columns, "give traction 0 where nothing is loaded")?;
    let grid = grid(&lattice.x, &lattice.y);
    let sample = |component: usize| {
        let [traction, displacement] = [&components[component], &components[component + 2]];
        let names = [COLUMNS[component + 2].name, COLUMNS[component + 4].name];
        check_pair(names, [traction, displacement], &columns)?;
        if traction.iter().all(|t| *t == 0.0) {
            return Ok(None);
        }
        check_direction(names, [traction, displacement], &columns)?;
        let traction = within_border(&grid, &lattice, traction, 0.0);
        let known: Vec<_> = displacement.iter().copied().map(Some).collect();
        let displacement = within_border(&grid, &lattice, &known, None);
        let sample = Sample::new(grid, traction, displacement);
        sample.map(Some).map_err(|error| columns.error(columns.header_line, error.to_string()))
    };
    let samples = [sample(0)?, sample(1)?];
    if samples.iter().all(Option::is_none) {
        let message = "traction_x or traction_y must not be zero everywhere: without a load there is nothing \
                       to fit to";
        return Err(columns.error(columns.header_line, message));
    }
    Ok(Displacements { name, samples })
}

/// A traction needs its displacement, and the other way round.
fn check_pair(
    names: [&str; 2],
    [traction, displacement]: [&[f64]; 2],
    columns: &Columns,
) -> Result<(), CaseError> {
    let (missing, given) = match (traction.is_empty(), displacement.is_empty()) {
        (true, false) => (names[0], names[1]),
        (false, true) => (names[1], names[0]),
        _ => return Ok(()),
    };
    let message = format!("column `{missing}` is missing, which `{given}` needs");
    Err(columns.error(columns.header_line, message))
}

/// What is loaded moves with its load: else one of the two has the sign of the other body.
fn check_direction(
    names: [&str; 2],
    [traction, displacement]: [&[f64]; 2],
    columns: &Columns,
) -> Result<(), CaseError> {
    let middle = displacement.iter().sum::<f64>() / displacement.len() as f64;
    let work = traction.iter().zip(displacement).map(|(t, u)| t * (u - middle)).sum::<f64>();
    if work > 0.0 {
        return Ok(());
    }
    let [traction, displacement] = names;
    let message = format!(
        "{displacement} must go with {traction}, but where the traction is large it is the same as elsewhere or \
         opposite"
    );
    let advice =
        "give the traction on the wheel and the displacement of the wheel less that of the rail";
    Err(columns.error(columns.header_line, message).help(advice.to_owned()))
}

/// Cells around the points, with the border that every grid has.
fn grid(x: &Axis, y: &Axis) -> Grid {
    Grid {
        columns: x.count + 2 * BORDER,
        rows: y.count,
        spacing_x: x.spacing,
        spacing_y: y.spacing,
        origin_x: x.start - (0.5 + BORDER as f64) * x.spacing,
        origin_y: y.start - 0.5 * y.spacing,
    }
}

/// Values of the file on the grid, and another one on its border.
fn within_border<T: Copy>(grid: &Grid, lattice: &Lattice, column: &[T], border: T) -> Vec<T> {
    let mut values = vec![border; grid.len()];
    for (&place, &value) in lattice.places.iter().zip(column) {
        let (i, j) = (place % lattice.x.count, place / lattice.x.count);
        values[grid.index(i + BORDER, j)] = value;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "# by hand\nx [mm],y [mm],traction_x [MPa],displacement_x [um]\n\
                        1,0,10,2\n0,0,0,1\n2,0,0,1\n0,0.5,0,0\n1,0.5,0,1\n2,0.5,0,0.5\n";

    fn read(text: &str) -> Result<Displacements, String> {
        let read = from_csv("d.csv".to_owned(), text.as_bytes().to_vec(), "--displacements");
        read.map_err(|error| error.to_string())
    }

    #[test]
    fn points_are_cells_within_a_border() {
        let Displacements { samples: [x, y], .. } = read(GOOD).unwrap();
        let x = x.unwrap();
        assert!(y.is_none());
        assert_eq!((x.grid.columns, x.grid.rows), (3 + 2 * BORDER, 2));
        assert!((x.grid.x(BORDER + 1) - 1e-3).abs() < 1e-12 && x.grid.y(0).abs() < 1e-12);
        let loaded = x.grid.index(BORDER + 1, 0);
        assert_eq!((x.traction[loaded], x.displacement[loaded]), (10e6, Some(2e-6)));
        assert_eq!(x.displacement.iter().flatten().count(), 6);
        assert_eq!(x.displacement[x.grid.index(BORDER - 1, 0)], None);
    }

    #[test]
    fn each_defect_is_named_with_its_line() {
        let cases = [
            ("1,0,10,2\n", "", "d.csv:3:1: the points must fill a rectangle of 3 by 2"),
            ("1,0,10,2", "0,0,10,2", "d.csv:4:1: every point must be given once"),
            ("1,0,10,2", "1,0,10,", "d.csv:3:1: displacement_x must be a finite number"),
            ("1,0,10,2", "1,0,0,2", "must not be zero everywhere"),
            ("1,0,10,2", "1,0,10,-2", "d.csv:2:1: displacement_x must go with traction_x"),
            ("[um]", "[MPa]", "column `displacement_x` must name its unit"),
            ("displacement_x", "displacement_y", "column `displacement_x` is missing, which"),
            ("traction_x", "traction_z", "did you mean `traction_x`?"),
            (GOOD, "", "--displacements must have a header such as `x [m],y [m],traction_x [Pa]"),
            (GOOD, "x [mm],y [mm]\n0,0\n0,1\n1,0\n1,1\n", "must not be zero everywhere"),
        ];
        for (from, to, expected) in cases {
            let message = read(&GOOD.replacen(from, to, 1)).unwrap_err();
            assert!(message.contains(expected), "{from:?} -> {to:?}: {message}");
        }
    }
}
