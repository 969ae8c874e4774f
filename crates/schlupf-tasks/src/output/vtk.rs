//! The fields as a legacy VTK file, for `ParaView` and similar programs.

use schlupf::Quantity;
use schlupf::reporting::Record;
use schlupf::solution::{Fields, Solution};

/// The fields on the uniform grid of the patch: binary structured points, one value per cell, zero
/// outside the contact; `contact` distinguishes the cells of the patch from the others.
pub fn structured_points(title: &str, solution: &Solution) -> Vec<u8> {
    let fields = &solution.fields;
    let mut file = header(title, fields).into_bytes();
    let columns = Fields::COLUMNS.iter().filter(|column| !POSITION.contains(&column.quantity));
    for column in columns {
        let number = |cell| (column.value)(fields, cell).number().unwrap_or_default();
        match column.quantity.vector() {
            Some((name, "x")) => vectors(&mut file, fields, name),
            Some(_) => {}
            None => scalars(&mut file, fields, column.name, number),
        }
    }
    scalars(&mut file, fields, "contact", |_| 1.0);
    file
}

/// Columns provided by the grid.
const POSITION: [Quantity; 2] = [Quantity::X, Quantity::Y];

/// The column of a component.
fn component(fields: &Fields, vector: &str, name: &str) -> impl Fn(usize) -> f64 {
    let wanted = Some((vector, name));
    let column = Fields::COLUMNS.iter().find(|column| column.quantity.vector() == wanted);
    move |cell| column.and_then(|column| (column.value)(fields, cell).number()).unwrap_or_default()
}

fn header(title: &str, fields: &Fields) -> String {
    let grid = &fields.grid;
    format!(
        "# vtk DataFile Version 3.0\n{}\nBINARY\nDATASET STRUCTURED_POINTS\n\
         DIMENSIONS {} {} 1\nORIGIN {:e} {:e} 0\nSPACING {:e} {:e} 1\nCELL_DATA {}\n",
        title_line(title),
        grid.columns + 1,
        grid.rows + 1,
        grid.origin_x,
        grid.origin_y,
        grid.spacing_x,
        grid.spacing_y,
        grid.len()
    )
}

/// The format allows one line of at most 255 ASCII characters.
pub(crate) fn title_line(title: &str) -> String {
    let ascii = |c: char| {
        if c.is_ascii() && !c.is_ascii_control() { c } else { ' ' }
    };
    let line: String = title.chars().map(ascii).take(250).collect();
    if line.trim().is_empty() { "schlupf".to_owned() } else { line }
}

fn scalars(file: &mut Vec<u8>, fields: &Fields, name: &str, value: impl Fn(usize) -> f64) {
    file.extend(format!("SCALARS {name} double 1\nLOOKUP_TABLE default\n").bytes());
    append(file, &on_grid(fields, |cell| [value(cell)]));
}

fn vectors(file: &mut Vec<u8>, fields: &Fields, name: &str) {
    let [x, y] = ["x", "y"].map(|axis| component(fields, name, axis));
    file.extend(format!("VECTORS {name} double\n").bytes());
    append(file, &on_grid(fields, |cell| [x(cell), y(cell), 0.0]));
}

/// Values of the contact cells at their positions on the grid, zero elsewhere.
fn on_grid<const N: usize>(fields: &Fields, value: impl Fn(usize) -> [f64; N]) -> Vec<[f64; N]> {
    let mut values = vec![[0.0; N]; fields.grid.len()];
    for (cell, &[column, row]) in fields.cell.iter().enumerate() {
        values[fields.grid.index(column, row)] = value(cell);
    }
    values
}

/// The format requires the most significant byte first.
pub(crate) fn append<const N: usize>(file: &mut Vec<u8>, values: &[[f64; N]]) {
    file.extend(values.iter().flatten().flat_map(|value| value.to_be_bytes()));
    file.push(b'\n');
}
