//! Prescribed forces on falling friction where the force at zero creepage is larger than that
//! asked for: the second motion lies behind it, seen from the first one.

use crate::common;
use std::sync::Arc;

use schlupf::bodies::Kinematics;
use schlupf::interface::friction::{Friction, Polach};
use schlupf::problem::{AreaReduction, Branch, Brush, FastMethod, Method, PrescribedForces};
use schlupf::{Options, Problem, Solution, Status, Warning, unwatched};

fn options() -> Options {
    Options { cells_x: 12, cells_y: 12, ..Options::default() }
}

/// Friction that falls to a fifth, with spin; speeds of 30 m/s.
fn problem(creepage_x: f64, spin: f64) -> Problem {
    let motion = Kinematics { creepage_x, spin, ..Kinematics::free_rolling(30.0) };
    let law = Arc::new(Polach::new(0.4, 0.2, 0.3).unwrap());
    common::problem(motion)
        .with_interface(|interface| interface.friction = Friction::new(law, 20.0))
}

fn limit(problem: &Problem) -> f64 {
    0.4 * problem.normal.normal_contact(None).unwrap().summary.load
}

/// F_y over μ0 N at a lateral creepage.
fn lateral(method: &Method, problem: &Problem, creepage_y: f64) -> f64 {
    let kinematics = Kinematics { creepage_y, ..problem.kinematics };
    let given = Problem { kinematics, ..problem.clone() };
    let solution = method.solver(&options()).solve(&given, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged);
    solution.force.y / limit(problem)
}

/// Lateral creepages at which F_y over μ0 N is `target`: by a scan and bisection.
fn roots(method: &Method, problem: &Problem, target: f64) -> Vec<f64> {
    let place = |k: i32| {
        let share = f64::from(k) / 40.0;
        0.95 * share.abs().powi(4) * share.signum()
    };
    let off = |creepage: f64| lateral(method, problem, creepage) - target;
    let values: Vec<(f64, f64)> = (-40..=40).map(|k| (place(k), off(place(k)))).collect();
    let mut found = Vec::new();
    for pair in values.windows(2) {
        let [mut low, mut high] = [pair[0], pair[1]];
        if (low.1 > 0.0) == (high.1 > 0.0) {
            continue;
        }
        for _ in 0..24 {
            let middle = 0.5 * (low.0 + high.0);
            let value = off(middle);
            *(if (value > 0.0) == (low.1 > 0.0) { &mut low } else { &mut high }) = (middle, value);
        }
        found.push(0.5 * (low.0 + high.0));
    }
    found.sort_by(|one, other| one.abs().total_cmp(&other.abs()));
    found
}

fn found(method: &Method, problem: &Problem, force: PrescribedForces, branch: Branch) -> Solution {
    let prescribed = Problem { prescribed: force, branch, ..problem.clone() };
    let solution = method.solver(&options()).solve(&prescribed, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged);
    solution
}

/// Scan over spin and forces, with fast methods and the full one: F_y prescribed, found on both
/// branches, against the roots of the method's own curve.
#[test]
fn both_motions_of_a_lateral_force_with_spin() {
    let polach = Method::Fast(FastMethod::Polach(AreaReduction::DRY));
    let fastsim = Method::Fast(FastMethod::Fastsim(Brush::KALKER));
    let mut behind = 0;
    for (method, spins, targets) in [
        (polach, &[0.3, 0.8, -0.8, 1.5][..], &[-0.45, -0.3, -0.25, 0.0, 0.25, 0.3, 0.5][..]),
        (fastsim, &[0.8, -1.5], &[-0.3, 0.25, 0.3]),
        (Method::Full, &[0.8, -1.5], &[-0.3, 0.25, 0.3]),
    ] {
        for spin in spins {
            let problem = problem(0.0, *spin);
            let rest = lateral(&method, &problem, 0.0);
            for target in targets {
                let roots = roots(&method, &problem, *target);
                let force =
                    PrescribedForces { y: Some(target * limit(&problem)), ..Default::default() };
                let name = format!("{method:?} φ = {spin}, F_y = {target}, at rest {rest:.3}");
                let [low, high] = [Branch::LowSlip, Branch::HighSlip]
                    .map(|branch| found(&method, &problem, force, branch));
                let [low_at, high_at] =
                    [&low, &high].map(|solution| solution.kinematics.creepage_y);
                let near = |one: f64, other: f64| (one - other).abs() < 1e-3 * other.abs() + 1e-6;
                assert!(near(low_at, roots[0]), "{name}: {low_at}, not {roots:?}");
                let is_told = |solution: &Solution| {
                    let is_other = |w: &Warning| matches!(w, Warning::SeveralMotions { .. });
                    solution.warnings.iter().any(is_other)
                };
                if let Some(second) = roots.get(1) {
                    assert!(near(high_at, *second), "{name}: {high_at}, not {roots:?}");
                    assert!(is_told(&low) && is_told(&high), "{name}");
                    behind += usize::from((rest > *target) == (*target > 0.0));
                }
            }
        }
    }
    assert!(behind > 3, "{behind}");
}
