//! Work that is repeated within a solution allocates nothing.

#![allow(unsafe_code, reason = "the interface of allocators is unsafe")]

#[path = "suite/common/mod.rs"]
mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::{Arc, Mutex};

use common::{cells, half_space, layer, problem, rolling};
use schlupf::bodies::Kinematics;
use schlupf::elasticity::{Elasticity, Rigid, Winkler};
use schlupf::interface::TotalDisplacement;
use schlupf::interface::friction::TemperatureLinear;
use schlupf::interface::heat::{ConstantSource, Duhamel, Heat, Partition};
use schlupf::normal::{Grid, VectorField};
use schlupf::problem::look_up_table::{LookUpTable, TableNodes};
use schlupf::problem::{AreaReduction, Brush, FastMethod, SlopeReduction};
use schlupf::solver::simplified::FastContact;
use schlupf::solver::{SteadySolver, march};
use schlupf::{Options, Problem, Solver, Transient, unwatched};
use std::ops::ControlFlow;

/// The system's allocator, counting what each thread asks of it: tests run side by side.
struct Counting;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

fn count() {
    COUNT.with(|count| count.set(count.get() + 1));
}

// SAFETY: whatever is asked for goes to the system's allocator unchanged. The counter has neither
// an initialiser nor a destructor that could allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        unsafe { System.realloc(pointer, layout, size) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations so far, in this thread.
fn allocations() -> usize {
    COUNT.with(Cell::get)
}

/// Sticking in front and sliding behind, with spin.
fn rolling_at(creepage_x: f64) -> Kinematics {
    rolling(creepage_x, 0.001, 0.2)
}

/// Both elasticities of which products take long, with and without heat, and both contact laws.
fn problems() -> Vec<Problem> {
    let layer = problem(rolling_at(0.002));
    let half_space = layer.clone().with_interface(|interface| interface.elasticity = half_space());
    let mut hot = half_space.clone();
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    // The paper's models.
    let mut paper = hot
        .clone()
        .with_interface(|interface| interface.elasticity = Arc::clone(&layer.interface.elasticity));
    paper.interface.heat.model = Some(Arc::new(ConstantSource));
    paper.interface.contact_law = TotalDisplacement::new(5e6).unwrap().into();
    vec![layer, half_space, hot, paper]
}

/// A product is the innermost work of all.
#[test]
fn a_product_allocates_nothing() {
    let elasticities: [Arc<dyn Elasticity>; 4] =
        [layer(), half_space(), Arc::new(Winkler::new(2e13, 2e13).unwrap()), Arc::new(Rigid)];
    let normal = problem(rolling_at(0.0)).normal.normal_contact(None).unwrap();
    for elasticity in elasticities {
        for cells_across in [7, 20, 24, 53] {
            let grid = Grid::across(&normal.extent(), cells_across, cells_across);
            let mut compliance = elasticity.compliance(&grid).unwrap();
            let traction = VectorField { x: vec![1.0; grid.len()], y: vec![2.0; grid.len()] };
            let mut displacement = VectorField::zeros(grid.len());
            let before = allocations();
            compliance.displacement(&traction, &mut displacement);
            assert_eq!(allocations(), before, "{elasticity:?} {cells_across}");
        }
    }
}

/// Least allocations of a solution among neighbouring ones, and the mean number of products.
///
/// Solutions before have made room. A larger Krylov space than ever before still allocates, so the
/// least of several counts.
fn in_a_warm_solution(base: &Problem, options: &Options) -> (usize, f64) {
    const POINTS: [f64; 3] = [0.002, 0.0025, 0.0022];
    let mut solver = SteadySolver::new(options);
    let mut solve = |creepage_x: f64| {
        let problem = Problem { kinematics: rolling_at(creepage_x), ..base.clone() };
        let before = allocations();
        let solution = solver.solve(&problem, &unwatched).unwrap();
        assert_eq!(solution.work.steps, 0, "marched");
        (allocations() - before, solution.work.operator_products)
    };
    for creepage_x in POINTS {
        solve(creepage_x);
    }
    let counts: Vec<_> = POINTS.into_iter().cycle().take(6).map(solve).collect();
    let products: f64 = counts.iter().map(|(_, products)| products).sum();
    (counts.iter().map(|(count, _)| *count).min().unwrap(), products / counts.len() as f64)
}

/// The steady driver: Newton steps, line searches, Krylov vectors, products and preconditioning on
/// all grids allocate nothing, so that a tolerance that asks for more of them does not either.
#[test]
fn more_steady_iterations_allocate_no_more() {
    for base in problems() {
        for cells_across in [20, 36] {
            let at = |tolerance| {
                in_a_warm_solution(&base, &Options { tolerance, ..cells(cells_across) })
            };
            let ((coarse, few), (fine, many)) = (at(1e-4), at(1e-9));
            assert!(many > 1.5 * few, "{many} {few}");
            assert_eq!(
                coarse, fine,
                "{:?}, {few:.0} and {many:.0} products",
                base.interface.elasticity
            );
        }
    }
}

/// Least allocations of a time step in the second passage of the material, when the first has made
/// room, and the Newton steps of all of those.
fn in_a_time_step(problem: &Problem, options: &Options) -> (usize, usize) {
    let passage = options.cells_x..2 * options.cells_x;
    let counts = Mutex::new((Vec::with_capacity(options.max_steps), allocations()));
    let solution = march(&Transient::to_steady_state(problem), options, &|progress| {
        let mut counts = counts.lock().unwrap();
        // Newton steps tell the number of the last time step.
        if progress.done > counts.0.len() {
            let now = allocations();
            let before = std::mem::replace(&mut counts.1, now);
            counts.0.push(now - before);
        }
        ControlFlow::Continue(())
    });
    let (counts, _) = counts.into_inner().unwrap();
    let history = solution.unwrap().history;
    let steps = history[passage.clone()].iter().map(|instant| instant.newton_iterations);
    (*counts[passage].iter().min().unwrap(), steps.sum())
}

/// Marching: a time step allocates for what it carries over, but nothing in its iterations.
#[test]
fn more_iterations_of_a_time_step_allocate_no_more() {
    for base in problems() {
        let at =
            |tolerance| in_a_time_step(&base, &Options { tolerance, max_steps: 40, ..cells(16) });
        let ((coarse, few), (fine, many)) = (at(1e-4), at(1e-9));
        assert!(many > few + few / 4, "{many} {few}");
        assert_eq!(coarse, fine, "{:?}, {few} and {many} Newton steps", base.interface.elasticity);
    }
}

/// A table with the forces of full adhesion up to the friction limit.
fn table() -> LookUpTable {
    let nodes = TableNodes {
        poisson_ratio: 0.28,
        axis_ratios: vec![0.1, 0.5, 2.0, 10.0],
        azimuths: vec![0.0, 0.8, 1.6, 2.4],
        inclinations: vec![0.0, 0.5, 1.0, std::f64::consts::FRAC_PI_2],
        saturations: vec![0.0, 0.3, 0.6, 1.0],
        values: vec![[0.0; 3]; 256],
        creep_coefficients: vec![[4.0, 4.0, 1.5, 0.5]; 4],
    };
    LookUpTable::new(nodes).unwrap()
}

/// The fast methods, for any motion and load, with both heat models.
#[test]
fn a_fast_force_allocates_nothing() {
    let methods = [
        FastMethod::KalkerLinear,
        FastMethod::ShenHedrickElkins,
        FastMethod::Polach(AreaReduction::DRY),
        FastMethod::Fastsim(Brush::KALKER),
        FastMethod::ModifiedFastsim(Brush::KALKER, SlopeReduction::DRY),
        FastMethod::Table(Arc::new(table())),
    ];
    for base in problems() {
        for method in &methods {
            let mut contact = FastContact::new(&base, method.clone(), &cells(12)).unwrap();
            // Heat makes room once.
            contact.force(&rolling_at(0.001)).unwrap();
            let before = allocations();
            for (creepage_x, load) in [(0.002, 60e3), (-0.01, 100e3), (0.0, 80e3)] {
                contact.set_load(load).unwrap();
                contact.force(&rolling_at(creepage_x)).unwrap();
            }
            assert_eq!(allocations(), before, "{method:?}");
        }
    }
}
