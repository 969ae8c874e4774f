//! The coupled elastic layer of Neuhaus and Sextro (2014), marched to the steady state, against
//! grid-converged values of an independent computation (a prototype in Python with the same
//! continuous model, extrapolated over grids).

mod common;

use std::sync::Arc;

use approx::assert_relative_eq;
use common::{cells, problem, rolling, solve};
use schlupf::interface::contact_law::TotalDisplacement;

/// ξ, η, φ in 1/m; Fx/μN, Fy/μN, Mz/μN√(ab).
const CONVERGED: [([f64; 3], [f64; 3]); 6] = [
    ([0.001, 0.0, 0.0], [-0.3370, 0.0, 0.0]),
    ([0.002, 0.0, 0.0], [-0.5849, 0.0, 0.0]),
    ([0.004, 0.0, 0.0], [-0.8782, 0.0, 0.0]),
    ([0.002, 0.002, 0.0], [-0.5199, -0.5199, 0.0773]),
    ([0.0, 0.001, 0.4], [0.0, -0.6098, -0.0949]),
    ([0.0, 0.0, 1.0], [0.0, -0.622, -0.345]),
];

fn check_forces(cells_across: usize, largest_steps: usize, [plain, with_spin]: [f64; 2]) {
    for ([xi, eta, spin], expected) in CONVERGED {
        let solution = solve(&problem(rolling(xi, eta, spin)), &cells(cells_across));
        let force = solution.normalised;
        let allowed = if spin == 0.0 { plain } else { with_spin };
        for (got, expected) in [force.x, force.y, force.moment_z].iter().zip(expected) {
            assert!(
                (got - expected).abs() < allowed,
                "ξ {xi}, η {eta}, φ {spin} at {cells_across} cells: {force:?}, not {expected:?}"
            );
        }
        assert!(solution.work.steps <= largest_steps, "{:?}", solution.work);
        let newton_per_step = solution.work.newton_iterations as f64 / solution.work.steps as f64;
        assert!(newton_per_step < 6.0, "{:?}", solution.work);
    }
}

/// Forces and moment within 0.5 % of μN, with spin 1 %, at 40 cells across.
#[test]
fn neuhaus_sextro_2014_layer_forces_at_40_cells() {
    check_forces(40, 240, [0.005, 0.01]);
}

/// At 20 cells within 0.1 % of μN, with spin 0.6 % (of which the reference's digits are 0.2 %).
#[test]
fn neuhaus_sextro_2014_layer_forces_at_20_cells() {
    check_forces(20, 120, [0.001, 0.006]);
}

/// The error of the force falls at least as h^1.5 on the way from 10 to 40 cells.
#[test]
fn refinement_converges() {
    let force = |n| solve(&problem(rolling(0.002, 0.0, 0.0)), &cells(n)).normalised.x;
    let finest = force(60);
    let (coarse, fine) = ((force(10) - finest).abs(), (force(30) - finest).abs());
    assert!(fine < coarse * (1.0_f64 / 3.0).powf(1.5), "{coarse} → {fine}");
}

/// ∫ q dA = −v0 (ξFx + ηFy + φMz) in the steady state: 0.5 % at 20 cells, 0.1 % at 40.
#[test]
fn friction_power_is_the_power_of_the_creep_forces() {
    for (cells_across, allowed) in [(20, 5e-3), (40, 1e-3)] {
        for (xi, eta, spin) in [(0.002, 0.0, 0.0), (0.0, 0.001, 0.4), (0.001, -0.002, -0.5)] {
            let solution = solve(&problem(rolling(xi, eta, spin)), &cells(cells_across));
            let power = solution.power;
            assert_relative_eq!(power.friction, power.creep, max_relative = allowed);
            // Elasticity does no work at all, so the balance is far better than asked for.
            assert_relative_eq!(power.friction, power.creep, max_relative = 1e-4);
        }
    }
}

/// Neuhaus and Sextro 2014, Eq. (8): on a patch the two forms of the contact law agree within
/// 2e-4 of μN in the forces and 2 % of μp0 in the tractions under pure ξ or η, where the direction
/// of sliding hardly turns.
#[test]
fn neuhaus_sextro_2014_total_displacement_against_increments() {
    for (xi, eta) in [(0.002, 0.0), (0.0, 0.002)] {
        let incremental = problem(rolling(xi, eta, 0.0));
        let mut total = incremental.clone();
        total.contact_law = Arc::new(TotalDisplacement::new(5e6).unwrap());
        let (one, two) = (solve(&incremental, &cells(20)), solve(&total, &cells(20)));
        let differs =
            (one.normalised.x - two.normalised.x).hypot(one.normalised.y - two.normalised.y);
        assert!(differs < 2e-4, "ξ {xi}, η {eta}: {differs}");
        for k in 0..one.fields.len() {
            let x = one.fields.traction_x[k] - two.fields.traction_x[k];
            let y = one.fields.traction_y[k] - two.fields.traction_y[k];
            assert!(x.hypot(y) < 0.02 * 0.4e9);
        }
    }
}

/// Under large spin the two forms differ: the total distance forgets how its direction came about.
#[test]
fn total_displacement_fails_under_spin() {
    let incremental = problem(rolling(0.0, 0.0, 2.0));
    let mut total = incremental.clone();
    total.contact_law = Arc::new(TotalDisplacement::new(5e6).unwrap());
    let (one, two) = (solve(&incremental, &cells(16)), solve(&total, &cells(16)));
    assert!((one.normalised.y - two.normalised.y).abs() > 0.05);
}

/// |t| ≤ μ pₙ everywhere, Σ pₙ ΔA = N, and areas add up.
#[test]
fn bounds_hold_in_every_cell() {
    let solution = solve(&problem(rolling(0.002, 0.001, 0.7)), &cells(24));
    let fields = &solution.fields;
    let mut load = 0.0;
    for k in 0..fields.len() {
        let traction = fields.traction_x[k].hypot(fields.traction_y[k]);
        assert!(traction <= 0.4 * fields.pressure[k] * (1.0 + 1e-5));
        load += fields.pressure[k] * fields.grid.cell_area();
    }
    assert_relative_eq!(load, solution.normal.load, max_relative = 1e-12);
    let area = solution.area;
    assert_relative_eq!(area.contact, std::f64::consts::PI * 30e-6, max_relative = 1e-10);
    assert_relative_eq!(area.stick + area.slip, area.contact, max_relative = 1e-12);
}

/// Odd in (ξ, η, φ), and mirrored in y: η, φ, Fy and Mz change sign, Fx does not.
#[test]
fn symmetries_hold() {
    let solve_at = |xi, eta, spin| solve(&problem(rolling(xi, eta, spin)), &cells(16)).normalised;
    let one = solve_at(0.001, 0.0015, 0.5);
    let odd = solve_at(-0.001, -0.0015, -0.5);
    let mirrored = solve_at(0.001, -0.0015, -0.5);
    for (sum, scale) in [
        (one.x + odd.x, 1.0),
        (one.y + odd.y, 1.0),
        (one.moment_z + odd.moment_z, 1.0),
        (one.x - mirrored.x, 1.0),
        (one.y + mirrored.y, 1.0),
        (one.moment_z + mirrored.moment_z, 1.0),
    ] {
        assert!(sum.abs() < 2e-6 * scale, "{one:?} {odd:?} {mirrored:?}");
    }
}
