//! Problems that several tests solve.

#![allow(dead_code, reason = "each test file uses its part of it")]

pub mod transients;

use std::sync::Arc;

use schlupf::bodies::{Kinematics, Material, ReferenceSpeed};
use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness};
use schlupf::elasticity::{Elasticity, HalfSpace};
use schlupf::interface::Incremental;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::{Heat, Partition};
use schlupf::normal::Ellipse;
use schlupf::problem::{History, State};
use schlupf::solver::march;
use schlupf::{Options, Problem, Solution, Status, Transient, unwatched};

/// Numbers between 0 and 1 (Park and Miller 1988).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Median, 90 % and largest of some values.
pub fn quantiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let at = |part: f64| values[((values.len() - 1) as f64 * part).round() as usize];
    [at(0.5), at(0.9), at(1.0)]
}

/// Rolling at 30 m/s with the given creepages and spin (in 1/m).
pub fn rolling(creepage_x: f64, creepage_y: f64, spin: f64) -> Kinematics {
    Kinematics { creepage_x, creepage_y, spin, ..Kinematics::free_rolling(30.0) }
}

/// A rail that passes at the first of two speeds (in m/s) below a wheel whose circumference has the
/// second: by creepages that refer to that of the vehicle, and to the mean.
pub fn motions([rail, wheel]: [f64; 2]) -> [Kinematics; 2] {
    let by_vehicle =
        Kinematics { creepage_x: (rail - wheel) / rail, ..Kinematics::free_rolling(rail) };
    let speed = 0.5 * (rail + wheel);
    let by_mean = Kinematics {
        creepage_x: (rail - wheel) / speed,
        reference_speed: ReferenceSpeed::Mean,
        ..Kinematics::free_rolling(speed)
    };
    [by_vehicle, by_mean]
}

/// The isotropic layer c = 1e13 N/m³, g = 3.24e7 N/m.
pub fn layer() -> Arc<dyn Elasticity> {
    Arc::new(elastic_layer())
}

/// The same by its own type.
pub fn elastic_layer() -> ElasticLayer {
    let stiffness =
        LayerStiffness { bedding: 1e13, coupling_along_x: 3.24e7, coupling_along_y: 3.24e7 };
    ElasticLayer::new(stiffness, stiffness, Some(15e-3)).unwrap()
}

/// The half-space of two steel bodies.
pub fn half_space() -> Arc<dyn Elasticity> {
    Arc::new(HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap())
}

/// a = 6 mm, b = 5 mm, p0 = 1 GPa, μ = 0.4, k_c = 5e6/m, no heat.
pub fn problem(kinematics: Kinematics) -> Problem {
    let problem = Problem::builder()
        .normal(Ellipse::from_peak_pressure(6e-3, 5e-3, 1e9).unwrap())
        .elasticity(elastic_layer())
        .contact_law(Incremental::new(5e6).unwrap())
        .friction(Constant::new(0.4).unwrap())
        .heat(Heat { model: None, partition: Partition::Given(0.5) })
        .build()
        .unwrap();
    Problem { kinematics, ..problem }
}

/// A grid of `cells` in both directions.
pub fn cells(cells: usize) -> Options {
    Options { cells_x: cells, cells_y: cells, ..Options::default() }
}

/// Solves for the steady state, and accepts neither a march nor less than convergence.
pub fn at_once(problem: &Problem, options: &Options) -> Solution {
    let solution = schlupf::solver::solve(problem, options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0, "marched: {:?}", solution.warnings);
    solution
}

/// Marches to the steady state, and does not accept less than convergence.
pub fn solve(problem: &Problem, options: &Options) -> Solution {
    follow(&Transient::to_steady_state(problem), options)
}

/// The same over a history.
pub fn solve_over(problem: &Problem, history: History, options: &Options) -> Solution {
    follow(&Transient { history, ..Transient::to_steady_state(problem) }, options)
}

/// Goes on from a state to the steady one.
pub fn from_state(problem: &Problem, state: State) -> Transient {
    Transient { initial_state: Some(state), ..Transient::to_steady_state(problem) }
}

/// Marches, and does not accept less than convergence.
pub fn follow(transient: &Transient, options: &Options) -> Solution {
    let solution = march(transient, options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}
