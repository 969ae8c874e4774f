//! The elastic layer calibrated to answer like the half-space.

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

use crate::common::{cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::analysis::calibration::displacements::{Sample, fit};
use schlupf::analysis::calibration::side_by_side::{Answer, Model, side_by_side};
use schlupf::analysis::calibration::{
    Calibration, CalibrationOptions, Deviation, KalkerBed, calibrate, deviation_of_table,
};
use schlupf::bodies::Material;
use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
use schlupf::elasticity::{CalibratedLayer, Elasticity, HalfSpace, tabulated_stiffness};
use schlupf::interface::Incremental;
use schlupf::normal::{Ellipse, Extent, Grid, VectorField};
use schlupf::{solver, unwatched};

/// The goal: forces within 2 % of μN, with spin 4 %.
fn assert_near(deviation: &Deviation, what: &str) {
    assert!(deviation.force < 0.02, "{what}: {deviation:?}");
    assert!(deviation.force_with_spin < 0.04, "{what}: {deviation:?}");
}

/// Between the entries of the table, over a/b from 0.2 to 5 and for several ν: forces within 2 % of
/// μN of the half-space, and within 4 % where spin takes part.
#[test]
fn tabulated_stiffnesses_are_near_the_half_space() {
    let options = CalibrationOptions { cells: 16, ..CalibrationOptions::default() };
    for (axis_ratio, poisson_ratio) in
        [(0.2, 0.28), (0.5, 0.3), (1.2, 0.25), (2.0, 0.45), (5.0, 0.1)]
    {
        let deviation =
            deviation_of_table(axis_ratio, poisson_ratio, &options, &unwatched).unwrap();
        println!("a/b {axis_ratio}, ν {poisson_ratio}: {deviation:.4?}");
        assert_near(&deviation, &format!("{axis_ratio} {poisson_ratio}"));
    }
}

/// A calibration finds what the table says, and its tractions are about twice as close to the
/// half-space's as those of a bed of springs without coupling that is fitted to the same forces.
#[test]
#[ignore = "long: cargo xtask long"]
fn coupling_halves_the_distance_of_the_tractions() {
    let options = CalibrationOptions { cells: 14, ..CalibrationOptions::default() };
    let found = calibrate(1.0, 0.28, &options, &unwatched).unwrap();
    assert!(found.converged);
    assert_near(&found.layer, "layer");
    assert!(found.layer.field < 0.5 * found.winkler.field, "{found:?}");
    assert!(found.layer.field_with_spin < 0.5 * found.winkler.field_with_spin, "{found:?}");
    let tabulated = tabulated_stiffness(1.0, 0.28).unwrap();
    for (found, tabulated) in found.stiffness.iter().zip(tabulated) {
        assert_relative_eq!(found.bedding, tabulated.bedding, max_relative = 0.1);
    }
}

/// The same over all axes ratios and several ν. Tractions twice as close is the goal, held here to
/// a fifth for ν up to 0.28, that of steel. For ν = 0.4 it is missed (0.61 at a/b = 0.2, with
/// spin); there they are printed, and only forces are held. The table is assessed on 40 cells: on
/// 20, the discretisation errors of layer and half-space add 1 % with spin at a/b = 5 (the table
/// deviates by 3.8 % on 20 cells, 3.3 % on 40 and 2.8 % on 80). A calibration on 20 cells deviates
/// by 5.2 % there; on 36 cells, where the errors are less than half as large, it still deviates by
/// 4.4 %: the goal of 4 % is missed by the fit, not by its grid.
#[test]
#[ignore = "long: cargo xtask long"]
fn calibrations_over_all_axes_ratios() {
    let options = CalibrationOptions::default();
    let finer = CalibrationOptions { cells: 40, ..options };
    let mut missed = Vec::new();
    println!("| a/b | ν | layer: forces, with spin, tractions, with spin | table | uncoupled |");
    for axis_ratio in [0.2, 0.5, 1.0, 2.0, 5.0] {
        for (poisson_ratio, part) in [(0.0, 0.6), (0.28, 0.6), (0.4, f64::INFINITY)] {
            let found = calibrate(axis_ratio, poisson_ratio, &options, &unwatched).unwrap();
            let table = deviation_of_table(axis_ratio, poisson_ratio, &finer, &unwatched).unwrap();
            let columns = [found.layer, table, found.winkler].map(percent).join(" | ");
            println!("| {axis_ratio} | {poisson_ratio} | {columns} |");
            let is_near = |d: &Deviation, spin| d.force < 0.02 && d.force_with_spin < spin;
            let is_closer = found.layer.field < part * found.winkler.field
                && found.layer.field_with_spin < part * found.winkler.field_with_spin;
            let is_found = found.converged && is_near(&found.layer, 0.055);
            if !(is_found && is_near(&table, 0.04) && is_closer) {
                missed.push((table, found));
            }
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}

/// All deviations together, dimensionless.
fn sum(deviation: &Deviation) -> f64 {
    let Deviation { force, force_with_spin, field, field_with_spin } = deviation;
    force + force_with_spin + field + field_with_spin
}

/// Forces without and with spin (% of μN), tractions without and with spin (%).
fn percent(deviation: Deviation) -> String {
    let Deviation { force, force_with_spin, field, field_with_spin } = deviation;
    let parts = [force, force_with_spin, field, field_with_spin];
    parts.map(|part| format!("{:.1}", 100.0 * part)).join(", ")
}

/// Writes the table anew with `SCHLUPF_PIN=1`, else compares it with a computation at three of its
/// entries, by how near forces and tractions are to those of the half-space. Single stiffnesses
/// matter little to them: for a/b = 0.25 and ν = 0 the fitted bedding is 20.9, 21.8 and 21.3·10¹²
/// N/m³ on 20, 30 and 40 cells, with forces 0.89, 0.94 and 0.95 % of μN from those of the
/// half-space.
#[test]
#[ignore = "long: cargo xtask long"]
fn the_table_is_as_near_as_a_new_calibration() {
    let options = CalibrationOptions::default();
    let ratio = |n: usize| 10.0_f64.powf(0.2 * n as f64 - 1.0);
    if std::env::var_os("SCHLUPF_PIN").is_none() {
        for (n, poisson_ratio) in [(2, 0.0), (5, 1.0 / 3.0), (8, 0.5)] {
            let found = calibrate(ratio(n), poisson_ratio, &options, &unwatched).unwrap();
            let table = deviation_of_table(ratio(n), poisson_ratio, &options, &unwatched).unwrap();
            println!("{} | {}", percent(found.layer), percent(table));
            assert!(sum(&table) < 1.05 * sum(&found.layer), "{table:?} {found:?}");
            assert!(table.force < found.layer.force + 5e-3, "{table:?} {found:?}");
            assert!(table.force_with_spin < found.layer.force_with_spin + 5e-3);
        }
        return;
    }
    let mut text = String::new();
    for row in 0..4 {
        text += "    [\n";
        for n in 0..11 {
            let found = calibrate(ratio(n), f64::from(row) / 6.0, &options, &unwatched).unwrap();
            println!("{found:.4?}");
            text += &entry(&found);
        }
        text += "    ],\n";
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/elasticity/calibration_table.rs");
    let old = std::fs::read_to_string(&file).unwrap();
    let start = old.find("pub(super) const TABLE").unwrap();
    let table = format!("pub(super) const TABLE: [[[f64; 6]; 11]; 4] = [\n{text}];\n");
    std::fs::write(file, old[..start].to_owned() + &table).unwrap();
}

fn entry(found: &Calibration) -> String {
    let mut text = "        [".to_owned();
    for (k, stiffness) in found.stiffness.iter().enumerate() {
        let (x, y) = (stiffness.reach_along_x, stiffness.reach_along_y);
        let comma = if k == 0 { ", " } else { "" };
        write!(text, "{:.5}, {x:.5}, {y:.5}{comma}", stiffness.bedding).unwrap();
    }
    text + "],\n"
}

/// The case's layer is that of its patch: forces near those of the half-space, and of two bodies
/// scaled alike the same.
#[test]
fn the_calibrated_layer_knows_the_patch() {
    let base = problem(rolling(0.002, 0.001, 0.0));
    let layer = CalibratedLayer::new(&Material::STEEL, &Material::STEEL, None).unwrap();
    let solve = |elasticity: Arc<dyn Elasticity>| {
        let problem = base.clone().with_interface(|interface| interface.elasticity = elasticity);
        solver::solve(&problem, &cells(24), &unwatched).unwrap().normalised
    };
    let (here, exact) = (solve(Arc::new(layer)), solve(half_space()));
    assert!((here.x - exact.x).hypot(here.y - exact.y) < 0.02, "{here:?} {exact:?}");
    let explicit = layer.layer([6e-3, 5e-3]).unwrap();
    let same = solve(Arc::new(explicit));
    assert_relative_eq!(here.x, same.x, max_relative = 1e-9);
}

/// Kalker (1982): without sliding, a bed with c = 3 C G/(8a) has the forces of the linear theory.
/// Coefficients as printed in Kalker 1990, Table E.3, for ν = 0.25 and a/b = 0.5, 1, 2; tolerance
/// that of the print and of cells that the edge cuts.
#[test]
fn kalker_1982_the_bed_has_the_forces_of_the_linear_theory() {
    let material = Material { poisson_ratio: 0.25, ..Material::STEEL };
    let bodies = HalfSpace::new(&material, &material).unwrap();
    for (axis_ratio, c11, c22) in [(0.5, 3.62, 3.01), (1.0, 4.12, 3.67), (2.0, 5.10, 4.90)] {
        let (b, g): (f64, f64) = (5e-3, bodies.shear_modulus());
        let a = axis_ratio * b;
        let bed = KalkerBed { bodies }.on([a, b]).unwrap();
        let [x, y] = bed.bedding();
        assert_relative_eq!(x, 3.0 * c11 * g / (8.0 * a), max_relative = 1e-2);
        assert_relative_eq!(y, 3.0 * c22 * g / (8.0 * a), max_relative = 1e-2);
        let stick = schlupf::Problem {
            normal: Arc::new(Ellipse::from_peak_pressure(a, b, 1e9).unwrap()),
            ..problem(rolling(1e-6, 2e-6, 0.0))
        }
        .with_interface(|interface| {
            interface.elasticity = Arc::new(bed);
            interface.contact_law = Incremental::new(1e9).unwrap().into();
        });
        let force = solver::solve(&stick, &cells(40), &unwatched).unwrap().force;
        assert_relative_eq!(force.x, -c11 * g * a * b * 1e-6, max_relative = 2e-2);
        assert_relative_eq!(force.y, -c22 * g * a * b * 2e-6, max_relative = 2e-2);
    }
}

/// Half-space, layer, bed and FASTSIM side by side: on the way of the longitudinal creepage the
/// layer is within 2 % of μN of the half-space at every point, and under spin within 4 %; all slide
/// at the end, and all tractions obey friction.
#[test]
fn side_by_side_the_layer_is_near_the_half_space() {
    let stiffness = tabulated_stiffness(1.0, 0.28).unwrap();
    let sides = side_by_side(1.0, 0.28, stiffness, &unwatched).unwrap();
    assert!(sides.is_converged());
    for (course, tolerance) in [(&sides.longitudinal, 0.02), (&sides.spin, 0.04)] {
        let [exact, layer, bed, fastsim] = &course.answers[..] else { panic!("four answers") };
        assert_eq!(exact.model, Model::HalfSpace);
        let apart = |one: &Answer| -> f64 {
            let pairs = one.force.iter().zip(&exact.force);
            pairs.map(|(f, g)| (f - g).abs()).fold(0.0, f64::max)
        };
        assert!(apart(layer) < tolerance, "{}", apart(layer));
        assert!(apart(layer) < apart(bed) && apart(layer) < apart(fastsim));
        for answer in [exact, layer, bed] {
            let bound = |x: f64| (1.0 - x * x).max(0.0).sqrt();
            let excess = answer.traction.iter().map(|[x, t]| t.abs() - bound(*x));
            assert!(excess.fold(f64::MIN, f64::max) < 0.02, "{:?}", answer.model);
        }
    }
    for answer in &sides.longitudinal.answers {
        assert!((0.94..=1.0).contains(answer.force.last().unwrap()), "{answer:?}");
    }
}

#[test]
fn ratios_outside_the_table_are_refused() {
    let message = tabulated_stiffness(20.0, 0.3).unwrap_err().to_string();
    assert!(message.contains("a/b = 20") && message.contains("between 0.1 and 10"), "{message}");
    let message = tabulated_stiffness(1.0, 0.6).unwrap_err().to_string();
    assert!(message.contains("poisson_ratio"), "{message}");
}

/// Displacements u = u0 exp(−r²/w²) and the tractions c u − g ∇²u that a layer needs for them:
/// whatever the decay length, the width and the extent, the stiffnesses come back, the nearer the
/// finer the grid.
#[test]
fn displacements_of_a_known_layer_give_back_its_stiffnesses() {
    let bedding = 1.4e13;
    for (half, cells) in [(16e-3, 41), (16e-3, 81), (12e-3, 31), (8e-3, 21), (8e-3, 41)] {
        for reach in [0.7e-3, 1.46e-3, 2.5e-3] {
            for width in [3e-3, 4e-3] {
                let coupling = bedding * reach * reach;
                let side = [-half, half];
                let grid = Grid::across(&Extent { x: side, y: side }, cells, cells);
                let square = |k: usize| {
                    let (x, y) = (grid.x(k % grid.columns), grid.y(k / grid.columns));
                    (x * x + y * y) / (width * width)
                };
                let u = |k: usize| 20e-6 * (-square(k)).exp();
                let laplacian = |k: usize| u(k) * 4.0 * (square(k) - 1.0) / (width * width);
                let traction = |k: usize| bedding * u(k) - coupling * laplacian(k);
                let cells = grid.len();
                let traction = (0..cells).map(traction).collect();
                let given = (0..cells).map(|k| Some(u(k) + 3e-6)).collect();
                let found = fit(&[Sample::new(grid, traction, given).unwrap()]).unwrap();
                let case = format!("{half} {} {reach} {width}: {found:?}", grid.columns);
                assert!(found.converged && found.is_open == [false; 2], "{case}");
                // Differences of second order, and the free edge of the layer beyond the grid.
                assert!(found.deviation[0] < 0.03, "{case}");
                assert!((found.bedding / bedding - 1.0).abs() < 0.03, "{case}");
                for found in [found.coupling_along_x, found.coupling_along_y] {
                    assert!((found / coupling - 1.0).abs() < 0.1, "{case}");
                }
            }
        }
    }
}

/// A layer's own displacements give back its stiffnesses, whatever rigid displacement is added.
#[test]
fn displacements_give_back_the_stiffnesses() {
    let stiffness = LayerStiffness { bedding: 8e12, coupling_along_x: 5e7, coupling_along_y: 2e7 };
    let layer = ElasticLayer::new(stiffness, stiffness, None).unwrap();
    let grid = Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-4e-3, 4e-3] }, 20, 16);
    let mut compliance = layer.compliance(&grid).unwrap();
    let inside = |k: usize| {
        let (x, y) = (grid.x(k % grid.columns) / 5e-3, grid.y(k / grid.columns) / 3e-3);
        (1.0 - x * x - y * y).max(0.0).sqrt()
    };
    let traction: Vec<f64> = (0..grid.len()).map(|k| 3e8 * inside(k)).collect();
    let field = VectorField { x: traction.clone(), y: vec![0.0; grid.len()] };
    let mut displacement = VectorField::zeros(grid.len());
    compliance.displacement(&field, &mut displacement);
    let shifted = displacement.x.iter().map(|u| Some(u + 7e-6)).collect();
    let sample = Sample::new(grid, traction, shifted).unwrap();
    let found = fit(&[sample]).unwrap();
    assert!(found.converged && found.deviation[0] < 1e-4, "{found:?}");
    assert_relative_eq!(found.bedding, stiffness.bedding, max_relative = 2e-3);
    assert_relative_eq!(found.coupling_along_x, stiffness.coupling_along_x, max_relative = 5e-3);
    assert_relative_eq!(found.coupling_along_y, stiffness.coupling_along_y, max_relative = 5e-3);
}
