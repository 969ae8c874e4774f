//! The stresses in all layers as a legacy VTK file, for `ParaView` and similar programs.

use schlupf::analysis::subsurface::{Stress, StressVolume};
use schlupf::analysis::temperature_field::Side;

use super::StressReport;
use crate::output::vtk::{append, title_line};

/// The stresses as a tensor, and their invariants, at the points of the layers: a binary
/// rectilinear grid in the contact frame, so z is negative in the rail.
pub(super) fn rectilinear_grid(report: &StressReport) -> Vec<u8> {
    let volume = &report.volume;
    let grid = &volume.grid;
    let order = upwards(volume, report.stresses.side());
    let height = |layer: &usize| match report.stresses.side() {
        Side::Wheel => volume.layers[*layer].depth,
        Side::Rail => -volume.layers[*layer].depth,
    };
    let title = title_line(&report.title);
    let (columns, rows, layers) = (grid.columns, grid.rows, order.len());
    let mut file = format!(
        "# vtk DataFile Version 3.0\n{title}\nBINARY\nDATASET RECTILINEAR_GRID\nDIMENSIONS \
         {columns} {rows} {layers}\n"
    )
    .into_bytes();
    coordinates(&mut file, "X", (0..columns).map(|i| grid.x(i)));
    coordinates(&mut file, "Y", (0..rows).map(|j| grid.y(j)));
    coordinates(&mut file, "Z", order.iter().map(height));
    file.extend(format!("POINT_DATA {}\n", columns * rows * layers).bytes());
    let stresses = || order.iter().flat_map(|layer| &volume.layers[*layer].stress);
    let tensor = |stress: &Stress| -> [f64; 9] {
        let rows = stress.tensor();
        std::array::from_fn(|k| rows[k / 3][k % 3])
    };
    file.extend(b"TENSORS stress double\n");
    append(&mut file, &stresses().map(tensor).collect::<Vec<_>>());
    let scalars: [(&str, Invariant); 4] = [
        ("von_mises_stress", Stress::von_mises),
        ("largest_shear_stress", Stress::largest_shear),
        ("largest_principal_stress", |stress| stress.principal()[0]),
        ("hydrostatic_stress", Stress::hydrostatic),
    ];
    for (name, value) in scalars {
        file.extend(format!("SCALARS {name} double 1\nLOOKUP_TABLE default\n").bytes());
        append(&mut file, &stresses().map(|stress| [value(stress)]).collect::<Vec<_>>());
    }
    file
}

/// A number of a tensor.
type Invariant = fn(&Stress) -> f64;

/// The layers in the order of increasing z.
fn upwards(volume: &StressVolume, side: Side) -> Vec<usize> {
    let mut order: Vec<usize> = (0..volume.layers.len()).collect();
    if side == Side::Rail {
        order.reverse();
    }
    order
}

fn coordinates(file: &mut Vec<u8>, axis: &str, values: impl Iterator<Item = f64>) {
    let values: Vec<[f64; 1]> = values.map(|value| [value]).collect();
    file.extend(format!("{axis}_COORDINATES {} double\n", values.len()).bytes());
    append(file, &values);
}
