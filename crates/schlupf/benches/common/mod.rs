//! What the benchmarks time: the problem of the tests, so that their counts and these times belong
//! together.

#![allow(dead_code, reason = "each benchmark uses its part of it")]

#[path = "../../tests/suite/common/mod.rs"]
mod problems;
pub mod transforms;

use std::sync::Arc;

use schlupf::bodies::Kinematics;
use schlupf::elasticity::Compliance;
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::{Grid, VectorField};
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solution, Solver, Status, unwatched};

pub use problems::{elastic_layer, rolling};

/// How the bodies deform.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bodies {
    Layer,
    HalfSpace,
}

/// A problem on a grid.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    pub bodies: Bodies,
    /// Whether friction falls with the temperature.
    pub is_heated: bool,
    /// Cells across the patch, in both directions.
    pub cells: usize,
}

/// The motion of a cold solution: both creepages and spin, sticking in front and sliding behind.
pub const MOTION: [f64; 3] = [0.003, 0.001, 0.2];

/// Points of the creep curve.
pub const POINTS: usize = 30;

/// Last creepage of the creep curve, dimensionless.
pub const LAST_CREEPAGE: f64 = 0.008;

impl Case {
    pub fn name(&self) -> &'static str {
        match self.bodies {
            Bodies::Layer => "layer",
            Bodies::HalfSpace => "half-space",
        }
    }

    pub fn options(&self) -> Options {
        problems::cells(self.cells)
    }

    /// Those of a point of a creep curve, which keeps no state of the material.
    pub fn curve_options(&self) -> Options {
        Options { keeps_state: false, ..self.options() }
    }

    /// The problem at rest: others are this one with another motion, so that they share its set-up.
    pub fn at_rest(&self) -> Problem {
        let mut problem = problems::problem(rolling(0.0, 0.0, 0.0));
        problem.interface.elasticity = match self.bodies {
            Bodies::Layer => problems::layer(),
            Bodies::HalfSpace => problems::half_space(),
        };
        if self.is_heated {
            problem.interface.friction.law =
                Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
            problem.interface.heat =
                Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
        }
        problem
    }

    /// A solver that has its set-up and no solution to start from: that at rest is forgotten.
    pub fn solver_at_rest(&self, options: &Options) -> SteadySolver {
        let mut solver = SteadySolver::new(options);
        solve(&mut solver, &self.at_rest());
        solver
    }

    /// The grid of the patch.
    pub fn grid(&self) -> Grid {
        let normal = self.at_rest().normal.normal_contact(None).unwrap();
        Grid::across(&normal.extent(), self.cells, self.cells)
    }
}

/// A problem with another motion.
pub fn moving(at_rest: &Problem, kinematics: Kinematics) -> Problem {
    Problem { kinematics, ..at_rest.clone() }
}

/// That of a cold solution.
pub fn cold(at_rest: &Problem) -> Problem {
    let [xi, eta, spin] = MOTION;
    moving(at_rest, rolling(xi, eta, spin))
}

/// The points of the creep curve, ξ = 0.008 (i/30)^1.5.
pub fn creep_curve(at_rest: &Problem) -> Vec<Problem> {
    let creepage = |i: usize| LAST_CREEPAGE * (i as f64 / POINTS as f64).powf(1.5);
    (1..=POINTS).map(|i| moving(at_rest, rolling(creepage(i), 0.0, 0.0))).collect()
}

/// Solves at once: a march would be something else to time.
pub fn solve(solver: &mut SteadySolver, problem: &Problem) -> Solution {
    let solution = solver.solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0, "marched");
    solution
}

/// A product u = A t with all that it needs.
pub struct Product {
    compliance: Box<dyn Compliance>,
    traction: VectorField,
    displacement: VectorField,
}

impl Product {
    pub fn new(case: &Case) -> Self {
        let grid = case.grid();
        let compliance = case.at_rest().interface.elasticity.compliance(&grid).unwrap();
        let mut traction = VectorField::zeros(grid.len());
        for (k, (x, y)) in traction.x.iter_mut().zip(&mut traction.y).enumerate() {
            (*x, *y) = ((k as f64).sin(), (k as f64).cos());
        }
        Self { compliance, traction, displacement: VectorField::zeros(grid.len()) }
    }

    pub fn run(&mut self) {
        self.compliance.displacement(&self.traction, &mut self.displacement);
    }
}
