//! The fields as a legacy VTK file, for `ParaView` and its kin.

use schlupf::solution::{Fields, Solution};

/// The fields on the uniform grid of the patch: binary structured points, one value per cell, zero
/// outside the contact; `contact` tells the cells of the patch from the others.
pub fn structured_points(title: &str, solution: &Solution) -> Vec<u8> {
    let fields = &solution.fields;
    let mut file = header(title, fields).into_bytes();
    scalars(&mut file, fields, "pressure", |cell| fields.pressure[cell]);
    vectors(&mut file, fields, "traction", [&fields.traction_x, &fields.traction_y]);
    vectors(&mut file, fields, "slip", [&fields.slip_x, &fields.slip_y]);
    vectors(&mut file, fields, "displacement", [&fields.displacement_x, &fields.displacement_y]);
    scalars(&mut file, fields, "temperature_rise_wheel", |cell| {
        fields.temperature_rise_wheel[cell]
    });
    scalars(&mut file, fields, "temperature_rise_rail", |cell| fields.temperature_rise_rail[cell]);
    scalars(&mut file, fields, "friction_power", |cell| fields.friction_power[cell]);
    scalars(&mut file, fields, "friction_coefficient", |cell| fields.friction_coefficient[cell]);
    scalars(&mut file, fields, "covered", |cell| fields.covered[cell]);
    scalars(&mut file, fields, "sliding", |cell| f64::from(u8::from(fields.sliding[cell])));
    scalars(&mut file, fields, "contact", |_| 1.0);
    file
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
fn title_line(title: &str) -> String {
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

fn vectors(file: &mut Vec<u8>, fields: &Fields, name: &str, components: [&[f64]; 2]) {
    file.extend(format!("VECTORS {name} double\n").bytes());
    append(file, &on_grid(fields, |cell| [components[0][cell], components[1][cell], 0.0]));
}

/// Values of the contact cells at their places on the grid, zero elsewhere.
fn on_grid<const N: usize>(fields: &Fields, value: impl Fn(usize) -> [f64; N]) -> Vec<[f64; N]> {
    let mut values = vec![[0.0; N]; fields.grid.len()];
    for (cell, &[column, row]) in fields.cell.iter().enumerate() {
        values[fields.grid.index(column, row)] = value(cell);
    }
    values
}

/// The format wants the most significant byte first.
fn append<const N: usize>(file: &mut Vec<u8>, values: &[[f64; N]]) {
    file.extend(values.iter().flatten().flat_map(|value| value.to_be_bytes()));
    file.push(b'\n');
}
