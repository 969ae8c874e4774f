//! Time of a rough contact, beside Tamaas where a Python has it.

#[path = "../tests/tamaas/mod.rs"]
mod tamaas;

use std::time::Instant;

use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::surface::synthesis::{Roughness, SelfAffine};
use schlupf::surface::{HeightMap, Lattice};
use schlupf::unwatched;

const GRIDS: [usize; 3] = [256, 512, 1024];

/// Mean pressures over the contact modulus, with gradients of 0.1: contact of some 4, 20 and 40 %.
const PRESSURES: [f64; 3] = [0.002, 0.01, 0.02];

/// Each program measures in its own way; with these both give pressures to some 10⁻⁶ of the
/// largest.
const TOLERANCE: f64 = 1e-6;
const TAMAAS_TOLERANCE: f64 = 1e-6;

fn surface(cells: usize) -> HeightMap {
    let spectrum = SelfAffine {
        roughness: Roughness::Gradient(0.1),
        hurst_exponent: 0.8,
        longest_wavelength: 1.0 / 4.0,
        roll_off_wavelength: 1.0 / 4.0,
        shortest_wavelength: 8.0 / cells as f64,
    };
    spectrum.surface(Lattice::square(cells, 1.0), 1).unwrap()
}

/// As Markdown.
pub fn table() -> String {
    let python = tamaas::python();
    let mut lines = vec![
        "Normal contact of a rough surface, periodic, each load from nothing, one thread:\n\n\
         | cells | contact | iterations | products | s | Tamaas, s | largest difference, % of the \
         largest pressure |\n|--:|--:|--:|--:|--:|--:|--:|"
            .to_owned(),
    ];
    for cells in GRIDS {
        let surface = surface(cells);
        let theirs = python
            .as_ref()
            .map(|python| tamaas::solve(python, &surface, TAMAAS_TOLERANCE, &PRESSURES));
        for (k, pressure) in PRESSURES.into_iter().enumerate() {
            let theirs = theirs.as_ref().map(|solutions| &solutions[k]);
            lines.push(line(&surface, pressure, theirs));
        }
    }
    lines.join("\n")
}

fn line(surface: &HeightMap, pressure: f64, theirs: Option<&tamaas::TamaasSolution>) -> String {
    let options = RoughContactOptions { tolerance: TOLERANCE, ..RoughContactOptions::default() };
    let start = Instant::now();
    let distance = surface.distance_to_plane();
    let mut contact = RoughContact::new(distance, 1.0, Boundary::Periodic).unwrap();
    let ours = contact.press(pressure, &options, &unwatched).unwrap();
    let time = start.elapsed().as_secs_f64();
    assert!(ours.is_converged);
    let beside = theirs.map_or("– | –".to_owned(), |theirs| {
        let pairs = ours.pressure.iter().zip(&theirs.pressure);
        let largest = ours.pressure.iter().copied().fold(0.0, f64::max);
        let difference = pairs.map(|(p, q)| (p - q).abs()).fold(0.0, f64::max) / largest;
        format!("{:.2} | {:.4}", theirs.time, 100.0 * difference)
    });
    format!(
        "| {0}² | {1:.1} % | {2} | {3} | {time:.2} | {beside} |",
        surface.lattice().columns,
        100.0 * ours.contact_area,
        ours.iterations,
        ours.products
    )
}
