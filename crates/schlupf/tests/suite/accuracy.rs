//! How exact the forces are on few cells: against those on many.

use std::sync::Arc;

use crate::common::{cells, half_space, problem, rolling};
use schlupf::interface::Incremental;
use schlupf::normal::Ellipse;
use schlupf::solution::Resultant;
use schlupf::{Problem, Status, unwatched};

/// Cells across the patch of the grid that stands for the converged one.
const CONVERGED: usize = 120;

/// Creepages and spin times √(ab); single ones, and together with spin.
const PURE: [[f64; 3]; 4] =
    [[0.0007, 0.0, 0.0], [0.002, 0.0, 0.0], [0.0, 0.0007, 0.0], [0.0, 0.002, 0.0]];
const SPINNING: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.002],
    [0.0, 0.0, 0.006],
    [0.0, 0.0, 0.02],
    [0.001, 0.001, 0.002],
    [0.0, 0.001, 0.004],
    [0.002, -0.001, 0.006],
];

fn force(axis_ratio: f64, stiffness: f64, [xi, eta, spin]: [f64; 3], across: usize) -> Resultant {
    let mean = 5e-3;
    let (a, b) = (mean * axis_ratio.sqrt(), mean / axis_ratio.sqrt());
    let rolling = Problem {
        normal: Arc::new(Ellipse::from_peak_pressure(a, b, 1e9).unwrap()),
        ..problem(rolling(xi, eta, spin / mean))
    }
    .with_interface(|interface| {
        interface.elasticity = half_space();
        interface.contact_law = Incremental::new(stiffness).unwrap().into();
    });
    let solution = schlupf::solver::solve(&rolling, &cells(across), &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution.normalised
}

/// Largest error of Fx and Fy over μN at 20 cells across.
fn error(axis_ratio: f64, stiffness: f64, motions: &[[f64; 3]]) -> f64 {
    let of = |motion: &[f64; 3]| {
        let coarse = force(axis_ratio, stiffness, *motion, 20);
        let fine = force(axis_ratio, stiffness, *motion, CONVERGED);
        (coarse.x - fine.x).abs().max((coarse.y - fine.y).abs())
    };
    motions.iter().map(of).fold(0.0, f64::max)
}

fn check(stiffness: f64, axis_ratios: &[f64], allowed: [f64; 2]) {
    for axis_ratio in axis_ratios {
        let errors = [&PURE[..], &SPINNING].map(|motions| error(*axis_ratio, stiffness, motions));
        println!("k_c = {stiffness:e}/m, a/b = {axis_ratio}: {errors:.5?}");
        assert!(errors[0] <= allowed[0] && errors[1] <= allowed[1], "{axis_ratio}: {errors:?}");
    }
}

#[test]
fn on_20_cells_with_soft_bristles() {
    check(5e6, &[0.5, 1.0, 2.0], [0.005, 0.01]);
}

#[test]
fn on_20_cells_with_stiff_bristles() {
    check(1e8, &[0.2, 1.0, 5.0], [0.005, 0.008]);
}
