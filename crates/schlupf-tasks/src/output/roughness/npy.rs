//! Heights, pressures and gaps in NumPy's .npy format, version 1.0.

use schlupf::surface::Lattice;

use super::RoughnessReport;

/// The header including its magic string ends at a multiple of this.
const ALIGNMENT: usize = 64;

/// Combined heights of both surfaces, without form, in m, each row along x: float64, little-endian.
pub(super) fn heights(report: &RoughnessReport) -> Vec<u8> {
    field(report.surface.lattice(), report.surface.heights())
}

/// Pressures in Pa and gaps in m at the largest mean pressure, in the same format.
pub(super) fn contact(report: &RoughnessReport) -> Option<[Vec<u8>; 2]> {
    let (spots, lattice) = (report.spots.as_ref()?, report.surface.lattice());
    Some([field(lattice, &spots.pressure), field(lattice, &spots.gap)])
}

fn field(lattice: &Lattice, values: &[f64]) -> Vec<u8> {
    let mut header = format!(
        "{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}",
        lattice.rows, lattice.columns
    );
    let magic = b"\x93NUMPY\x01\x00";
    let before = magic.len() + 2;
    let total = (before + header.len() + 1).next_multiple_of(ALIGNMENT);
    header.push_str(&" ".repeat(total - before - header.len() - 1));
    header.push('\n');
    let mut bytes = magic.to_vec();
    // Some 80 to 130 characters.
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}
