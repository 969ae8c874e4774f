//! Rough contact against Tamaas, another program for the same problem (Frérot et al. 2020).

#[path = "../tamaas/mod.rs"]
mod program;

use std::time::Instant;

use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::surface::Lattice;
use schlupf::surface::synthesis::{Roughness, SelfAffine};
use schlupf::unwatched;

/// Goal: pressures of rough surfaces within 1 % of those of Tamaas. Set-up: two self-affine
/// surfaces of 256² cells, three loads each, contact of 2 to 40 %; both solve the same discrete
/// equations, so that only their tolerances part them. Source: Tamaas 2.9.0, where a Python has it
/// (`.ci/run` installs it).
#[test]
fn frerot_2020_same_pressures() {
    let Some(python) = program::python() else {
        println!("skipped: no Python with Tamaas");
        return;
    };
    let pressures = [0.001, 0.004, 0.02];
    for (seed, hurst_exponent) in [(1, 0.8), (2, 0.4)] {
        let spectrum = SelfAffine {
            roughness: Roughness::Gradient(0.1),
            hurst_exponent,
            longest_wavelength: 1.0 / 4.0,
            roll_off_wavelength: 1.0 / 8.0,
            shortest_wavelength: 1.0 / 32.0,
        };
        let surface = spectrum.surface(Lattice::square(256, 1.0), seed).unwrap();
        let theirs = program::solve(&python, &surface, 1e-9, &pressures);
        let distance = surface.distance_to_plane();
        let mut contact = RoughContact::new(distance, 1.0, Boundary::Periodic).unwrap();
        let options = RoughContactOptions { tolerance: 1e-8, ..RoughContactOptions::default() };
        for (mean, theirs) in pressures.into_iter().zip(theirs) {
            let start = Instant::now();
            let ours = contact.press(mean, &options, &unwatched).unwrap();
            let time = start.elapsed().as_secs_f64();
            assert!(ours.is_converged);
            let largest = ours.pressure.iter().copied().fold(0.0, f64::max);
            let pairs = || ours.pressure.iter().zip(&theirs.pressure);
            let worst = pairs().map(|(p, q)| (p - q).abs()).fold(0.0, f64::max) / largest;
            let squares: f64 = ours.pressure.iter().map(|p| p * p).sum();
            let error = pairs().map(|(p, q)| (p - q).powi(2)).sum::<f64>();
            let error = (error / squares).sqrt();
            println!(
                "A/A₀ = {:.3}: differ by {error:.1e}, at most {worst:.1e} of the largest; {time:.3} s, \
                 Tamaas {:.3} s",
                ours.contact_area, theirs.time
            );
            assert!(error < 1e-4 && worst < 1e-3, "{error} {worst}");
        }
    }
}
