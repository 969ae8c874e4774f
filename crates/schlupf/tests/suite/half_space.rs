//! Rolling on the elastic half-space with nearly Coulomb friction, against CONTACT.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::common::{cells, problem, rolling};
use schlupf::bodies::Material;
use schlupf::elasticity::HalfSpace;
use schlupf::interface::Incremental;
use schlupf::interface::friction::Constant;
use schlupf::normal::Ellipse;
use schlupf::{Solution, Status, unwatched};

/// Where a file of validation data is.
fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// The numbers of a file of validation data line by line; what is not a number is NaN.
fn numbers(name: &str) -> Vec<Vec<f64>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(data(name)).unwrap();
    let line = |record: csv::StringRecord| {
        record.iter().map(|field| field.parse().unwrap_or(f64::NAN)).collect()
    };
    reader.records().map(|record| line(record.unwrap())).collect()
}

/// One line of `data/contact_creep.csv`, without its name.
#[derive(Debug)]
struct Reference {
    semi_axes: [f64; 2],
    creepage: [f64; 3],
    force: [f64; 3],
    /// What is uncertain of the forces, over μN.
    uncertain: f64,
}

impl Reference {
    fn all() -> Vec<Self> {
        let line = |n: &Vec<f64>| Self {
            semi_axes: [n[2], n[3]],
            creepage: [n[4], n[5], n[6]],
            force: [n[7], n[8], n[9]],
            uncertain: n[10],
        };
        numbers("contact_creep.csv").iter().map(line).collect()
    }

    /// Creepage along or across rolling only.
    fn is_pure(&self) -> bool {
        let [xi, eta, spin] = self.creepage;
        spin == 0.0 && (xi == 0.0 || eta == 0.0)
    }

    /// Largest error of Fx, Fy (over μN) and Mz (over μN √(ab)) on a grid of `across` cells.
    fn error(&self, across: usize) -> f64 {
        let force = solve(self.semi_axes, self.creepage, across).normalised;
        let pairs = [force.x, force.y, force.moment_z.unwrap()].into_iter().zip(self.force);
        pairs.map(|(got, expected)| (got - expected).abs()).fold(0.0, f64::max)
    }
}

/// The contact of the validation data, 52.36 kN and μ = 0.3 between steel bodies, with a contact
/// law of k_c = 1e8/m, by the steady driver.
fn solve([a, b]: [f64; 2], [xi, eta, spin]: [f64; 3], across: usize) -> Solution {
    let mut coulomb = problem(rolling(xi, eta, spin));
    coulomb.normal = Arc::new(Ellipse::from_load(a, b, 52_359.878).unwrap());
    coulomb.interface.elasticity =
        Arc::new(HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap());
    coulomb.interface.contact_law = Incremental::new(1e8).unwrap().into();
    coulomb.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    let solution = schlupf::solver::solve(&coulomb, &cells(across), &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0, "marched: {:?}", solution.warnings);
    solution
}

/// Solves every `step`-th case on a grid and holds its error to `allowed`, for pure longitudinal or
/// lateral creepage and for the rest, and `uncertain` times what is uncertain of the reference.
fn compare(across: usize, step: usize, allowed: [f64; 2], uncertain: f64) {
    let mut largest = [0.0_f64; 2];
    let mut failed = Vec::new();
    for reference in Reference::all().iter().step_by(step) {
        let class = usize::from(!reference.is_pure());
        let error = reference.error(across);
        largest[class] = largest[class].max(error);
        if error > allowed[class] + uncertain * reference.uncertain {
            failed.push((error, reference.semi_axes, reference.creepage));
        }
    }
    println!("{across} cells: largest errors {largest:.5?}");
    assert!(failed.is_empty(), "{} too far off: {failed:#?}", failed.len());
}

/// Vollebregt 2022 (CONTACT, extrapolated over grids): forces and moment of all 178 cases at 40
/// cells across, within 0.6 % for pure longitudinal or lateral creepage and 1 % with spin or
/// combined.
#[test]
fn vollebregt_2022_creep_forces_at_40_cells() {
    compare(40, 1, [0.006, 0.01], 0.0);
}

/// The same at 80 cells across within half of that, every seventh case.
#[test]
fn vollebregt_2022_creep_forces_at_80_cells() {
    compare(80, 7, [0.003, 0.005], 0.0);
}

/// The same, all cases. On one, k_c = 1e8/m itself moves the converged force by 0.36 % of μN from
/// that of Coulomb's law, of which the reference leaves 0.13 % open.
#[test]
#[ignore = "long: cargo xtask long"]
fn vollebregt_2022_all_creep_forces_at_80_cells() {
    compare(80, 1, [0.003, 0.005], 1.0);
}

/// The traction field of CONTACT on its own cells: relative L2 difference within 5 %. Its grid of
/// 80 × 80 has 72 × 72 cells across the ellipse, and ours of 72 × 72 coincides with those.
fn compare_field(name: &str, semi_axes: [f64; 2], creepage: [f64; 3]) {
    const ACROSS: usize = 72;
    let fields = solve(semi_axes, creepage, ACROSS).fields;
    let positions = fields.cell.iter().enumerate();
    let at: HashMap<[usize; 2], usize> = positions.map(|(k, cell)| (*cell, k)).collect();
    let grid = fields.grid;
    let (mut difference, mut total, mut area) = (0.0, 0.0, 0.0);
    for line in numbers(name) {
        let column = ((line[0] - grid.x(0)) / grid.spacing_x).round();
        let row = ((line[1] - grid.y(0)) / grid.spacing_y).round();
        let cell = [column as usize, row as usize];
        let off = (grid.x(cell[0]) - line[0]).abs() / grid.spacing_x
            + (grid.y(cell[1]) - line[1]).abs() / grid.spacing_y;
        assert!(off < 1e-3, "cells do not coincide: {off}");
        let k = at[&cell];
        let gap = [fields.traction_x[k] - line[3], fields.traction_y[k] - line[4]];
        difference += gap[0].powi(2) + gap[1].powi(2);
        total += line[3].powi(2) + line[4].powi(2);
        area += grid.cell_area();
    }
    let exact = std::f64::consts::PI * semi_axes[0] * semi_axes[1];
    assert!((area / exact - 1.0).abs() < 0.02, "{area} of {exact} compared");
    let relative = f64::sqrt(difference / total);
    println!("{name}: {relative:.4}");
    assert!(relative < 0.05, "{name}: {relative}");
}

/// Vollebregt 2022: longitudinal creepage on a circle.
#[test]
fn vollebregt_2022_traction_field_of_longitudinal_creepage() {
    compare_field("contact_field_ab1_xi002.csv", [5e-3, 5e-3], [0.002, 0.0, 0.0]);
}

/// Vollebregt 2022: both creepages and spin on an ellipse.
#[test]
fn vollebregt_2022_traction_field_of_combined_creepage() {
    let semi_axes = [6.123_724_36e-3, 4.082_482_90e-3];
    compare_field("contact_field_ab1.5_combined.csv", semi_axes, [0.001, 0.001, 0.2]);
}
