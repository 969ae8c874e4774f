//! The full equations in an element under loads that change: the grid of one load serves for all
//! where only the unit of length differs.

use crate::common;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use schlupf::bodies::{Kinematics, Material};
use schlupf::elasticity::{
    CalibratedLayer, Compliance, Elasticity, EllipsoidalTraction, HalfSpace, Rigid,
};
use schlupf::element::{Element, Given, Motion, Normal, Rows, Settings, Status};
use schlupf::interface::friction::{
    Across, Constant, Exponential, FrictionLaw, FrictionMemory, Product, SlipTerms,
    TemperatureLinear, Variation,
};
use schlupf::interface::heat::{Heat, Partition};
use schlupf::interface::{ContactLaw, Interface, TotalDisplacement};
use schlupf::normal::{AtLoad, Grid, VectorField};
use schlupf::{Error, Method, Options, Problem, unwatched};

const MOTION: Kinematics =
    Kinematics { creepage_x: 1e-3, creepage_y: -5e-4, spin: 0.2, ..Kinematics::free_rolling(20.0) };

const BY_CREEPAGES: Settings = Settings {
    motion: Motion::Creepages,
    normal: Normal::Load,
    has_memory: false,
    standstill_speed: 0.01,
    rolling_radius: 0.46,
};

fn constant(problem: &mut Problem) {
    problem.interface.friction.law = Arc::new(Constant::new(0.4).unwrap());
}

/// A half-space whose friction falls with temperature and slip speed.
fn half_space() -> Problem {
    let hot = TemperatureLinear::new(0.4, 700.0, 0.1).unwrap();
    let fast = Exponential(SlipTerms::new(0.4, 0.1, 2.0, None).unwrap());
    let mut problem = Problem::builder().load(80e3).kinematics(MOTION).build().unwrap();
    problem.interface.elasticity = common::half_space();
    problem.interface.friction.law = Arc::new(Product::new(Arc::new(hot), Arc::new(fast)).unwrap());
    problem
}

/// Problems that differ in all that has a length.
fn problems() -> Vec<Problem> {
    let with = |change: &dyn Fn(&mut Problem)| {
        let mut problem = half_space();
        change(&mut problem);
        problem
    };
    let across = |law: &Arc<dyn FrictionLaw>| {
        let variation = Variation::over_y(vec![-4e-3, -1e-3, 3e-3], vec![0.5, 1.1, 0.7]).unwrap();
        Arc::new(Across::new(Arc::clone(law), variation))
    };
    vec![
        with(&constant),
        with(&|problem| {
            constant(problem);
            problem.interface.contact_law = ContactLaw::Coulomb;
        }),
        with(&|problem| {
            problem.interface.contact_law = TotalDisplacement::new(3e6).unwrap().into();
        }),
        with(&|problem| {
            let friction = &mut problem.interface.friction;
            friction.law = across(&friction.law);
            friction.memory = Some(FrictionMemory::new(2e-5, 1e-2).unwrap());
        }),
        with(&|problem| {
            // So slow that heat spreads along the surface.
            problem.kinematics.speed = 0.05;
            problem.interface.heat = Heat { partition: Partition::Given(0.3), ..Heat::default() };
        }),
        with(&|problem| {
            let steel = Material::STEEL;
            let layer = CalibratedLayer::new(&steel, &steel, None).unwrap();
            problem.interface.elasticity = Arc::new(layer);
        }),
        with(&|problem| problem.interface.elasticity = Arc::new(Rigid)),
        // Not similar: stiffnesses of their own, and bodies that move under the pressure.
        with(&|problem| problem.interface.elasticity = common::layer()),
        with(&|problem| {
            problem.interface.wheel.material.young_modulus = 100e9;
            let Interface { wheel, rail, .. } = &problem.interface;
            let bodies = HalfSpace::new(&wheel.material, &rail.material).unwrap();
            problem.interface.elasticity = Arc::new(bodies);
        }),
        // A patch of given size.
        Problem { kinematics: MOTION, ..common::problem(MOTION) },
    ]
}

/// Forces and derivatives under other loads, with other friction and bulk temperatures, are those
/// of a solution of that problem.
#[test]
fn an_element_solves_the_problem_of_its_load() {
    let options = Options { tolerance: 1e-11, ..common::cells(10) };
    for (number, problem) in problems().into_iter().enumerate() {
        let method = (&Method::Full, &options);
        let mut element = Element::new(&problem, method, BY_CREEPAGES).unwrap();
        let mut inputs = element.start();
        let own = inputs[4];
        let mut found = element.evaluation();
        for part in [1.0, 0.02, 1.7] {
            inputs[4] = part * own;
            inputs[6] = 20.0 + 50.0 * part;
            assert_eq!(element.evaluate(&inputs, &[], &mut found), Status::Found);
            let mut exact = problem.clone();
            exact.normal = Arc::new(AtLoad::new(Arc::clone(&problem.normal), inputs[4]).unwrap());
            exact.interface.wheel.bulk_temperature = inputs[6];
            let solved = Method::Full.solver(&options).solve_with_derivatives(&exact, &unwatched);
            let solved = solved.unwrap().unwrap();
            let by = solved.sensitivity.unwrap();
            let of = |row: usize, by: usize| found.derivative(row, by);
            let force = solved.force;
            let rows = [force.x, force.y, force.moment_z.unwrap()];
            let size = rows[0].hypot(rows[1]);
            for (row, unit) in [1.0, 1.0, 1e-2].into_iter().enumerate() {
                let error = (found.outputs[row] - rows[row]).abs();
                assert!(error < 1e-7 * unit * size, "{number} {part} {row}: {error}");
                let slopes = [
                    (0, Some(by.creepage_x), 1e-3),
                    (1, Some(by.creepage_y), 1e-3),
                    (2, Some(by.spin), 0.2),
                    (4, by.load, inputs[4]),
                ];
                for (place, exact, step) in slopes {
                    let Some(exact) = exact else { continue };
                    let exact = [exact.x, exact.y, exact.moment_z.unwrap()][row];
                    let error = (of(row, place) - exact).abs() * step;
                    assert!(error < 1e-3 * unit * size, "{number} {part} {row} {place}: {error}");
                }
            }
        }
    }
}

/// A half-space that counts its set-ups and products.
#[derive(Debug)]
struct Counted(HalfSpace, Arc<[AtomicUsize; 2]>);

impl Elasticity for Counted {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        self.1[0].fetch_add(1, Ordering::Relaxed);
        Ok(Box::new(Counting(self.0.compliance(grid)?, Arc::clone(&self.1))))
    }

    fn under_ellipsoid(&self, semi_axes: [f64; 2]) -> Option<EllipsoidalTraction> {
        self.0.under_ellipsoid(semi_axes)
    }

    fn is_scale_free(&self) -> bool {
        self.0.is_scale_free()
    }
}

#[derive(Debug)]
struct Counting(Box<dyn Compliance>, Arc<[AtomicUsize; 2]>);

impl Compliance for Counting {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        self.1[1].fetch_add(1, Ordering::Relaxed);
        self.0.displacement(traction, displacement);
    }

    fn displacement_by_size(&mut self, traction: &VectorField, to: &mut VectorField) -> bool {
        self.1[1].fetch_add(1, Ordering::Relaxed);
        self.0.displacement_by_size(traction, to)
    }

    fn couples_cells(&self) -> bool {
        self.0.couples_cells()
    }
}

/// A wheel on 20 × 20 cells whose load, creepages and spin change a little from one evaluation to
/// the next needs no set-up, and few products on all grids: some 15 for the forces, 31 for the
/// derivatives, of which most are known from those before.
#[test]
fn a_changing_load_costs_no_set_up() {
    for law in [ContactLaw::default(), ContactLaw::Coulomb] {
        let counts = Arc::new([AtomicUsize::new(0), AtomicUsize::new(0)]);
        let mut problem = half_space();
        constant(&mut problem);
        problem.interface.contact_law = law;
        let steel = HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap();
        problem.interface.elasticity = Arc::new(Counted(steel, Arc::clone(&counts)));
        let method = (&Method::Full, &common::cells(20));
        let mut element = Element::new(&problem, method, BY_CREEPAGES).unwrap();
        let [with, without] = [element.evaluation(), element.evaluation_without_derivatives()];
        for (mut found, most) in [(without, 18.0), (with, 48.0)] {
            let (start, mut before) = (element.start(), [0; 2]);
            for k in 0..200 {
                let mut inputs = start.clone();
                let phase = 0.05 * f64::from(k);
                inputs[0] *= 1.0 + 0.3 * phase.sin();
                inputs[2] *= (1.3 * phase).cos();
                inputs[4] *= 1.0 + 0.4 * (0.7 * phase).sin();
                assert_eq!(element.evaluate(&inputs, &[], &mut found), Status::Found);
                if k == 0 {
                    before = [0, 1].map(|of| counts[of].load(Ordering::Relaxed));
                }
            }
            let [set_ups, products] =
                [0, 1].map(|of| counts[of].load(Ordering::Relaxed) - before[of]);
            let mean = products as f64 / 199.0;
            assert!(set_ups == 0 && mean < most, "{law:?}: {set_ups} {mean}");
        }
    }
}

/// More than two blocks.
const ROWS: usize = 40;

/// Rows that fill more than a block are those of one evaluation after the other.
#[test]
fn rows_are_single_evaluations() {
    let options = Options { tolerance: 1e-10, ..common::cells(6) };
    let mut problem = half_space();
    constant(&mut problem);
    let mut element = Element::new(&problem, (&Method::Full, &options), BY_CREEPAGES).unwrap();
    let row = |k: usize| {
        let mut inputs = element.start();
        inputs[0] *= (k as f64).sin();
        inputs[4] *= 1.0 + k as f64 / ROWS as f64;
        inputs
    };
    let inputs: Vec<_> = (0..ROWS).flat_map(row).collect();
    let width = element.outputs().len();
    let (mut outputs, mut status) = (vec![0.0; ROWS * width], vec![Status::WrongSize; ROWS]);
    let rows =
        Rows { outputs: &mut outputs, rates: &mut [], derivatives: None, status: &mut status };
    element.evaluate_rows(Given { inputs: &inputs, states: &[] }, rows).unwrap();
    let mut found = element.evaluation_without_derivatives();
    for (k, inputs) in inputs.chunks_exact(element.inputs().len()).enumerate() {
        assert_eq!(element.evaluate(inputs, &[], &mut found), status[k]);
        for (one, other) in found.outputs.iter().zip(&outputs[k * width..]) {
            assert!((one - other).abs() <= 1e-6 * one.abs().max(1e3), "{k}: {one} {other}");
        }
    }
}
