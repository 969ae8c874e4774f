//! Forces in place of creepages: the creepages that cause them.

mod common;

use std::sync::Arc;

use schlupf::interface::contact_law::Coulomb;
use schlupf::interface::friction::{Friction, constant::Constant};
use schlupf::kinematics::Kinematics;
use schlupf::method::{FastMethod, Method};
use schlupf::normal::ellipse::Ellipse;
use schlupf::prescribed::ForceSolver;
use schlupf::prescribed_forces::{LongitudinalForce, PrescribedForces};
use schlupf::{Options, Problem, Solution, Solver, Status, unwatched};

const FRICTION: f64 = 0.3;

/// A case of CONTACT: forces over μN, spin in 1/m, and the creepages that were found.
struct Case {
    name: String,
    fx: f64,
    fy: Option<f64>,
    spin: f64,
    creepages: [f64; 2],
}

fn cases() -> Vec<Case> {
    let text = include_str!("../../../data/contact_prescribed_force.csv");
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let number = |text: &str| text.parse().unwrap();
    rows.map(|row| {
        let cells: Vec<&str> = row.split(',').collect();
        Case {
            name: cells[0].to_owned(),
            fx: number(cells[5]),
            fy: cells[6].parse().ok(),
            spin: number(cells[7]),
            creepages: [number(cells[12]), number(cells[13])],
        }
    })
    .collect()
}

/// a = b = 6 mm, p0 = 1 GPa, half-space, Coulomb's law with μ = 0.3.
fn contact() -> Problem {
    Problem {
        normal: Arc::new(Ellipse::from_peak_pressure(6e-3, 6e-3, 1e9).unwrap()),
        elasticity: common::half_space(),
        contact_law: Arc::new(Coulomb),
        friction: Friction::new(Arc::new(Constant::new(FRICTION).unwrap()), 20.0),
        ..common::problem(Kinematics::free_rolling(30.0))
    }
}

fn limit(problem: &Problem) -> f64 {
    FRICTION * problem.normal.normal_contact(None).unwrap().summary.load
}

fn forces(x: f64, y: Option<f64>) -> PrescribedForces {
    PrescribedForces { x: Some(LongitudinalForce::Force(x)), y, moment_z: None }
}

fn options(cells: usize) -> Options {
    Options { cells_x: cells, cells_y: cells, ..Options::default() }
}

fn solve(problem: &Problem, options: &Options) -> Solution {
    let mut solver = ForceSolver::new(Method::Full.solver(options));
    let solution = solver.solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged);
    solution
}

/// CONTACT (Vollebregt, rev. 2707) with total forces in place of creepages, `data/`: within 1 % of
/// the creepage, or 2·10⁻⁵, at most twice the products of a solution with these creepages given.
#[test]
fn contact_creepages_of_prescribed_forces() {
    let mut problem = contact();
    let limit = limit(&problem);
    for Case { name, fx, fy, spin, creepages } in cases() {
        problem.kinematics = Kinematics { spin, ..Kinematics::free_rolling(30.0) };
        problem.prescribed = forces(fx * limit, fy.map(|fy| fy * limit));
        let found = solve(&problem, &options(40));
        let motion = found.kinematics;
        assert!((found.force.x - fx * limit).abs() < 1e-5 * limit);
        for (found, expected) in [motion.creepage_x, motion.creepage_y].iter().zip(creepages) {
            println!("{name}: {found:.7} {expected:.7} {:+.2e}", found - expected);
            assert!((found - expected).abs() < (0.01 * expected.abs()).max(2e-5), "{name}");
        }
        let given = Problem { kinematics: motion, prescribed: PrescribedForces::default(), ..problem.clone() };
        let given = solve(&given, &options(40));
        let [one, other] = [&found, &given].map(|solution| solution.work.operator_products);
        println!("{name}: {one:.1} products, {other:.1} with given creepages, {} {}", found.work.newton_iterations, given.work.newton_iterations);
        assert!(one <= 2.0 * other, "{name}: {one} {other}");
    }
}
