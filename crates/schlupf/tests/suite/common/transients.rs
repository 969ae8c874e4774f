//! CONTACT's transients: their problem, histories and forces.

use std::f64::consts::TAU;
use std::sync::Arc;

use schlupf::bodies::{Kinematics, Material};
use schlupf::elasticity::HalfSpace;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::normal::Hertz;
use schlupf::problem::History;
use schlupf::{Problem, Solution};

use super::{problem, rolling};

/// Load of the reference, in N, and μ N.
pub const LOAD: f64 = 75_398.224;
pub const LIMIT: f64 = 0.3 * LOAD;

/// E = 210 GPa, ν = 0.28, a = b = 6 mm, p0 = 1 GPa, μ = 0.3, ξ = 0.0011: CONTACT's transients in
/// `data/contact_transient.csv`. At 1 m/s a second is a metre.
pub fn reference(contact_law: ContactLaw) -> Problem {
    let steel = Material { young_modulus: 210e9, poisson_ratio: 0.28, ..Material::STEEL };
    let modulus = 0.5 * 210e9 / (1.0 - 0.28 * 0.28);
    let radius = 2.0 * 6e-3 * modulus / (0.5 * TAU * 1e9);
    let curvature = 0.5 / radius;
    let kinematics = Kinematics { speed: 1.0, ..rolling(0.0011, 0.0, 0.0) };
    let mut reference = problem(kinematics);
    reference.normal =
        Arc::new(Hertz::from_curvatures(curvature, curvature, modulus, LOAD).unwrap());
    reference.interface.elasticity = Arc::new(HalfSpace::new(&steel, &steel).unwrap());
    reference.interface.contact_law = contact_law;
    reference.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    reference
}

/// The load N0 (1 + swing sin(2π s/wave)) up to a distance, lengths in m.
pub fn swinging(swing: f64, wave: f64, distance: f64) -> History {
    let time: Vec<f64> = (0..=2000).map(|k| distance * f64::from(k) / 2000.0).collect();
    let load = time.iter().map(|s| LOAD * (1.0 + swing * (TAU * s / wave).sin())).collect();
    History { time, load: Some(load), ..History::default() }
}

/// No change over a distance, in m.
pub fn constant(distance: f64) -> History {
    History { time: vec![0.0, distance], ..History::default() }
}

/// −Fx/(μ N0) after a distance, in m.
pub fn force_at(solution: &Solution, distance: f64) -> f64 {
    let history = &solution.history;
    let after = history.partition_point(|i| i.distance < distance - 1e-12).min(history.len() - 1);
    let (start, from) = match after.checked_sub(1) {
        Some(before) => (history[before].distance, history[before].force.x),
        None => (0.0, 0.0),
    };
    let share = (distance - start) / (history[after].distance - start);
    -(from + share * (history[after].force.x - from)) / LIMIT
}

/// Forces of one case of CONTACT over the distance (in m), on its finer grid.
pub fn contact(case: &str) -> Vec<[f64; 2]> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/contact_transient.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let lines = reader.records().map(Result::unwrap).filter(|line| &line[0] == case);
    let number = |line: &csv::StringRecord, k: usize| line[k].parse::<f64>().unwrap();
    lines.map(|line| [1e-3 * number(&line, 1), -number(&line, 6)]).collect()
}

pub fn largest_difference(solution: &Solution, reference: &[[f64; 2]]) -> f64 {
    let off = reference.iter().map(|[s, force]| (force_at(solution, *s) - force).abs());
    off.fold(0.0, f64::max)
}
