//! Exact derivatives of the forces against central differences of whole solutions.

use std::sync::Arc;

use crate::common::{half_space, problem, rolling};
use schlupf::analysis::calibration::KalkerBed;
use schlupf::bodies::{Material, ReferenceSpeed, contact_modulus};
use schlupf::elasticity::elastic_layer::{ElasticLayer, Springs};
use schlupf::elasticity::{CalibratedLayer, HalfSpace, Winkler};
use schlupf::interface::friction::{
    Across, Changes, Constant, Exponential, Friction, FrictionLaw, FrictionMemory, Polach, Product,
    SecondTerm, SlipTerms, TemperatureLinear, Variation,
};
use schlupf::interface::heat::{ConstantSource, Duhamel, Heat, Partition};
use schlupf::interface::{Incremental, InterfaceConstant, TotalDisplacement};
use schlupf::normal::{Hertz, PressureSource, Radii};
use schlupf::solution::{Resultant, Sensitivity};
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solution, Status, unwatched};

const LOAD: f64 = 80e3;

fn hertz(load: f64) -> Arc<dyn PressureSource> {
    let wheel = Radii { x: 0.46, y: f64::INFINITY };
    let rail = Radii { x: f64::INFINITY, y: 0.3 };
    let modulus = contact_modulus(&Material::STEEL, &Material::STEEL);
    Arc::new(Hertz::new(wheel, rail, modulus, load).unwrap())
}

fn at(problem: &Problem) -> Solution {
    on_cells(problem, 14, TOLERANCE)
}

/// Small enough for differences, and above rounding for k_c = 5e6/m.
const TOLERANCE: f64 = 1e-11;

fn on_cells(problem: &Problem, cells: usize, tolerance: f64) -> Solution {
    let options = Options {
        tolerance,
        cells_x: cells,
        cells_y: cells,
        sensitivity: true,
        ..Options::default()
    };
    let solution = schlupf::solver::solve(problem, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0);
    solution
}

/// The problem with one parameter set.
type Setter<'a> = &'a dyn Fn(&Problem, f64) -> Problem;

/// (F(θ + h) − F(θ − h))/2h with h a small part of `scale`, so that what the tolerance leaves open
/// counts little.
fn difference(base: &Problem, with: Setter, [value, scale]: [f64; 2], tolerance: f64) -> [f64; 3] {
    let h = 2e6 * tolerance * scale;
    let [plus, minus] =
        [value + h, value - h].map(|value| on_cells(&with(base, value), 14, tolerance).force);
    let over = |plus: f64, minus: f64| (plus - minus) / (2.0 * h);
    [
        over(plus.x, minus.x),
        over(plus.y, minus.y),
        over(plus.moment_z.unwrap(), minus.moment_z.unwrap()),
    ]
}

/// Compares all derivatives of a problem with k_c = 5e6/m.
fn check(name: &str, base: &Problem, friction: Setter, stiffness: Setter) {
    check_at(name, base, friction, (stiffness, 5e6));
}

/// The same with another k_c, in 1/m.
fn check_at(name: &str, base: &Problem, friction: Setter, (stiffness, k_c): (Setter, f64)) {
    // Stiff bristles amplify rounding.
    let tolerance = if k_c > 5e6 { 4.0 * TOLERANCE } else { TOLERANCE };
    let solution = on_cells(base, 14, tolerance);
    let Sensitivity { creepage_x, creepage_y, spin, load, friction_coefficient, contact_stiffness } =
        solution.sensitivity.unwrap();
    let k = base.kinematics;
    assert!(load.is_some(), "{name}");
    let parameters: [(&str, Option<Resultant>, Setter, f64, f64); 6] = [
        ("ξ", Some(creepage_x), &|p, v| moved(p, |k| k.creepage_x = v), k.creepage_x, 1e-3),
        ("η", Some(creepage_y), &|p, v| moved(p, |k| k.creepage_y = v), k.creepage_y, 1e-3),
        ("φ", Some(spin), &|p, v| moved(p, |k| k.spin = v), k.spin, 0.2),
        ("N", load, &|p, v| Problem { normal: hertz(v), ..p.clone() }, LOAD, LOAD),
        ("μ0", Some(friction_coefficient), friction, 0.4, 0.4),
        ("k_c", Some(contact_stiffness), stiffness, k_c, k_c),
    ];
    for (parameter, exact, with, value, scale) in parameters {
        let Some(exact) = exact else { continue };
        let approximate = difference(base, with, [value, scale], tolerance);
        assert_alike(&format!("{name}, {parameter}"), &exact, approximate, scale);
    }
}

/// Asserts that two derivatives of forces and moment, times the scale of the parameter, differ by
/// less than 2e-6 of μN.
fn assert_alike(name: &str, exact: &Resultant, approximate: [f64; 3], scale: f64) {
    let (lever, limit) = (5e-3, 0.4 * LOAD);
    let pairs = [exact.x, exact.y, exact.moment_z.unwrap() / lever].into_iter();
    let pairs = pairs.zip([approximate[0], approximate[1], approximate[2] / lever]);
    for (component, (exact, approximate)) in pairs.enumerate() {
        let error = (exact - approximate).abs() * scale / limit;
        assert!(error < 2e-6, "{name}, component {component}: {exact:e}, not {approximate:e}");
    }
}

fn moved(problem: &Problem, set: impl Fn(&mut schlupf::bodies::Kinematics)) -> Problem {
    let mut problem = problem.clone();
    set(&mut problem.kinematics);
    problem
}

fn incremental(problem: &Problem, stiffness: f64) -> Problem {
    problem.clone().with_interface(|interface| {
        interface.contact_law = Incremental::new(stiffness).unwrap().into();
    })
}

fn constant(problem: &Problem, coefficient: f64) -> Problem {
    let mut problem = problem.clone();
    problem.interface.friction.law = Arc::new(Constant::new(coefficient).unwrap());
    problem
}

fn falling(problem: &Problem, coefficient: f64) -> Problem {
    let mut problem = problem.clone();
    problem.interface.friction.law =
        Arc::new(TemperatureLinear::new(coefficient, 700.0, 0.05).unwrap());
    problem
}

fn base() -> Problem {
    Problem { normal: hertz(LOAD), ..problem(rolling(0.0012, 0.0015, 0.25)) }
}

#[test]
fn on_the_layer_and_the_half_space() {
    let layer = base();
    check("layer", &layer, &constant, &incremental);
    let half = base().with_interface(|interface| interface.elasticity = half_space());
    check("half-space", &half, &constant, &incremental);
    let springs = Springs { bedding: 8e6, coupling: 3e7 };
    let discrete = ElasticLayer::from_springs(springs, springs, Some(15e-3)).unwrap();
    check(
        "springs",
        &base().with_interface(|interface| interface.elasticity = Arc::new(discrete)),
        &constant,
        &incremental,
    );
    let uncoupled = base().with_interface(|interface| {
        interface.elasticity = Arc::new(Winkler::new(2e13, 1e13).unwrap());
    });
    check("Winkler", &uncoupled, &constant, &incremental);
}

/// Stiffnesses that are calibrated change with the patch, and so with the load.
#[test]
fn on_calibrated_springs() {
    let steel = Material::STEEL;
    let bodies = HalfSpace::new(&steel, &steel).unwrap();
    let layer = CalibratedLayer::new(&steel, &steel, None).unwrap();
    let with_bed = |p: &Problem, load: f64| {
        Problem { normal: hertz(load), ..p.clone() }
            .with_interface(|interface| interface.elasticity = Arc::new(KalkerBed { bodies }))
    };
    let with_layer = |p: &Problem, load: f64| {
        Problem { normal: hertz(load), ..p.clone() }
            .with_interface(|interface| interface.elasticity = Arc::new(layer))
    };
    let models: [(&str, Setter); 2] = [("Winkler", &with_bed), ("layer", &with_layer)];
    for (name, with) in models {
        let solution = at(&with(&base(), LOAD));
        let exact = solution.sensitivity.unwrap().load.unwrap();
        let [x, y, _] = difference(&base(), with, [LOAD, LOAD], TOLERANCE);
        for (exact, approximate) in [(exact.x, x), (exact.y, y)] {
            let error = (exact - approximate).abs() / 0.4;
            assert!(error < 2e-6, "{name}: {exact:e}, not {approximate:e}");
        }
    }
}

#[test]
fn with_stiff_bristles() {
    let half = base().with_interface(|interface| interface.elasticity = half_space());
    check_at("half-space", &incremental(&half, 1e8), &constant, (&incremental, 1e8));
    check_at("layer", &incremental(&base(), 1e8), &constant, (&incremental, 1e8));
    check_at("soft", &incremental(&half, 1e7), &constant, (&incremental, 1e7));
}

/// Driving, with a floor of friction in part of the patch.
#[test]
fn with_a_floor_in_part_of_the_patch() {
    let floored = |problem: &Problem, coefficient: f64| {
        let mut problem = problem.clone();
        problem.interface.friction.law =
            Arc::new(TemperatureLinear::new(coefficient, 700.0, 0.35).unwrap());
        problem
    };
    let mut hot =
        floored(&base().with_interface(|interface| interface.elasticity = half_space()), 0.4);
    hot.kinematics.creepage_x = -0.012;
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    let coefficients = at(&hot).fields.friction_coefficient;
    let at_floor = coefficients.iter().filter(|mu| **mu == 0.35).count();
    assert!(at_floor > 5 && at_floor < coefficients.len() - 5, "{at_floor}");
    check("floor", &hot, &floored, &incremental);
}

#[test]
fn with_heat_that_lowers_friction() {
    let mut hot =
        falling(&base().with_interface(|interface| interface.elasticity = half_space()), 0.4);
    hot.kinematics.creepage_x = 0.012;
    hot.interface.wheel.bulk_temperature = 120.0;
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    check("Duhamel", &hot, &falling, &incremental);
    hot.kinematics.reference_speed = ReferenceSpeed::Mean;
    check("mean speed", &hot, &falling, &incremental);
    hot.interface.heat =
        Heat { model: Some(Arc::new(ConstantSource)), partition: Partition::Given(0.5) };
    check("constant source", &hot, &falling, &incremental);
}

/// Friction that lags behind a law of temperature, slip speed and y.
#[test]
fn with_friction_that_remembers() {
    let lagging = |problem: &Problem, coefficient: f64| {
        let by_heat: Arc<dyn FrictionLaw> =
            Arc::new(TemperatureLinear::new(coefficient, 700.0, 0.05).unwrap());
        let polach = Arc::new(Polach::new(coefficient, 0.4, 0.6).unwrap());
        let product = Arc::new(Product::new(by_heat, polach).unwrap());
        let across =
            Across::new(product, Variation::over_y(vec![-8e-3, 8e-3], vec![1.25, 0.75]).unwrap());
        let mut problem = problem.clone();
        problem.interface.friction.law = Arc::new(across);
        problem.interface.friction.memory = Some(FrictionMemory::new(3e-5, 1e-3).unwrap());
        problem
    };
    let mut hot =
        lagging(&base().with_interface(|interface| interface.elasticity = half_space()), 0.4);
    hot.kinematics.creepage_x = 0.012;
    hot.interface.wheel.bulk_temperature = 120.0;
    hot.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    check("memory", &hot, &lagging, &incremental);
}

#[test]
fn with_the_law_in_total_displacement() {
    let total = |problem: &Problem, stiffness: f64| {
        problem.clone().with_interface(|interface| {
            interface.contact_law = TotalDisplacement::new(stiffness).unwrap().into();
        })
    };
    let base = total(&base(), 5e6);
    check("total displacement", &base, &constant, &total);
}

/// By the constants of the friction laws, through heat, slip and memory.
#[test]
fn by_the_constants_of_friction() {
    let heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    let mut hot = base().with_interface(|interface| {
        interface.elasticity = half_space();
        interface.heat = heat;
    });
    hot.kinematics.creepage_x = 0.012;
    hot.interface.wheel.bulk_temperature = 120.0;
    let by_heat: Arc<dyn FrictionLaw> = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.05).unwrap());
    let polach: Arc<dyn FrictionLaw> = Arc::new(Polach::new(0.4, 0.4, 0.6).unwrap());
    let product = Arc::new(Product::new(Arc::clone(&by_heat), Arc::clone(&polach)).unwrap());
    let second = Some(SecondTerm { coefficient: 0.05, half_speed: 0.05 });
    let terms = SlipTerms::new(0.4, 0.25, 0.5, second).unwrap();
    let laws: [(&str, Arc<dyn FrictionLaw>); 5] = [
        ("constant", Arc::new(Constant::new(0.4).unwrap())),
        ("heat", by_heat),
        ("Polach", polach),
        ("two terms", Arc::new(Exponential(terms))),
        (
            "product",
            Arc::new(Across::new(
                product,
                Variation::over_y(vec![-8e-3, 8e-3], vec![1.25, 0.75]).unwrap(),
            )),
        ),
    ];
    for (name, law) in laws {
        let memory = (name == "product").then(|| FrictionMemory::new(3e-5, 1e-3).unwrap());
        hot.interface.friction = Friction { memory, ..Friction::new(law, 20.0) };
        check_constants(name, &hot);
    }
}

/// Compares the derivatives by all constants of friction and k_c with central differences.
fn check_constants(name: &str, base: &Problem) {
    let constants = base.interface.friction.law.adjustable().unwrap().constants();
    let mut wanted: Vec<InterfaceConstant> =
        constants.iter().map(|(constant, _)| InterfaceConstant::Friction(*constant)).collect();
    wanted.push(InterfaceConstant::ContactStiffness);
    let options = Options { tolerance: TOLERANCE, cells_x: 14, cells_y: 14, ..Options::default() };
    let mut solver = SteadySolver::new(&options);
    let (_, found) = solver.solve_with_derivatives_by(base, &wanted, &unwatched).unwrap().unwrap();
    for ((constant, value), exact) in constants.into_iter().zip(&found) {
        if value == 0.05 && name != "two terms" {
            // The floor is not reached.
            assert_eq!([exact.x, exact.y, exact.moment_z.unwrap()], [0.0; 3]);
            continue;
        }
        let with = |problem: &Problem, value: f64| {
            let mut problem = problem.clone();
            let law = base.interface.friction.law.adjustable().unwrap();
            problem.interface.friction.law =
                law.with_constants(&Changes(&[(constant, value)])).unwrap();
            problem
        };
        let approximate = difference(base, &with, [value, value], TOLERANCE);
        assert_alike(&format!("{name}, {constant:?}"), exact, approximate, value);
    }
    let sensitivity = on_cells(base, 14, TOLERANCE).sensitivity.unwrap();
    let by_stiffness = sensitivity.contact_stiffness;
    let whole = [by_stiffness.x, by_stiffness.y, by_stiffness.moment_z.unwrap()];
    assert_alike(&format!("{name}, k_c"), found.last().unwrap(), whole, 5e6);
}

/// With the size of the patch given, only the pressure grows with the load; beyond saturation the
/// force is μN.
#[test]
fn of_a_sliding_patch_of_given_size() {
    let sliding = problem(rolling(0.05, 0.0, 0.0));
    let sensitivity = at(&sliding).sensitivity.unwrap();
    let by_load = sensitivity.load.unwrap();
    assert!((by_load.x + 0.4).abs() < 1e-6, "{by_load:?}");
    assert!(sensitivity.creepage_x.x.abs() < 1e-3 * 0.4 * LOAD, "{sensitivity:?}");
}

/// Kalker 1967: at rest the slope of the force is the same in both directions of a creepage, and
/// derivatives exist there.
#[test]
fn kalker_1967_at_rest() {
    let rest = problem(rolling(0.0, 0.0, 0.0))
        .with_interface(|interface| interface.elasticity = half_space());
    let slope = at(&rest).sensitivity.unwrap();
    let small = 1e-8;
    let moved = at(&Problem { kinematics: rolling(small, 0.0, 0.0), ..rest.clone() }).force;
    assert!((slope.creepage_x.x * small / moved.x - 1.0).abs() < 1e-4, "{slope:?} {moved:?}");
    // By reciprocity C23 is in Fy under spin and in −Mz under lateral creepage, where the bristles,
    // whose stiffness goes with the pressure, give way little; the rest is the grid's, and of the
    // first order.
    let off = |stiffness: f64, across: usize| {
        let stiff = incremental(&rest, stiffness);
        let slope = on_cells(&stiff, across, 1e-9).sensitivity.unwrap();
        (slope.spin.y / slope.creepage_y.moment_z.unwrap() + 1.0).abs()
    };
    for stiffness in [2e7, 1e8] {
        let on_grids = [20, 40, 80].map(|across| off(stiffness, across));
        assert!(on_grids.windows(2).all(|off| off[1] < 0.6 * off[0]), "{on_grids:?}");
    }
}
