//! Forces in place of creepages: the creepages that cause them.

use crate::common;
use std::sync::Arc;

use schlupf::analysis::creep_curve::{Creepages, Path, Sampling, trace};
use schlupf::bodies::Kinematics;
use schlupf::elasticity::Rigid;
use schlupf::interface::friction::{Constant, Friction, Polach, TemperatureLinear};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental, TotalDisplacement};
use schlupf::normal::Ellipse;
use schlupf::problem::{
    AreaReduction, Branch, Brush, Driver, FastMethod, History, LongitudinalForce, Method,
    PrescribedForces, TractionBound,
};
use schlupf::reporting::{ForceError, Names};
use schlupf::solver::{SteadySolver, march};
use schlupf::{
    Error, Options, Problem, Quantity, Solution, Solver, Status, Transient, Warning, unwatched,
};

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
    let text = include_str!("../../../../data/contact_prescribed_force.csv");
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
        ..common::problem(Kinematics::free_rolling(30.0))
    }
    .with_interface(|interface| {
        interface.elasticity = common::half_space();
        interface.contact_law = ContactLaw::Coulomb;
        interface.friction = Friction::new(Arc::new(Constant::new(FRICTION).unwrap()), 20.0);
    })
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
    let mut solver = Method::Full.solver(options);
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
        let given = Problem {
            kinematics: motion,
            prescribed: PrescribedForces::default(),
            ..problem.clone()
        };
        let given = solve(&given, &options(40));
        let [one, other] = [&found, &given].map(|solution| solution.work.operator_products);
        println!(
            "{name}: {one:.1} products, {other:.1} with given creepages, {} {}",
            found.work.newton_iterations, given.work.newton_iterations
        );
        assert!(one <= 2.0 * other, "{name}: {one} {other}");
    }
}

fn found_by(method: &Method, problem: &Problem) -> Solution {
    let mut solver = method.solver(&options(16));
    let solution = solver.solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged);
    solution
}

/// The same problem with the motion of a solution given.
fn with_motion_of(problem: &Problem, solution: &Solution) -> Problem {
    let prescribed = PrescribedForces::default();
    Problem { kinematics: solution.kinematics, prescribed, ..problem.clone() }
}

/// Whatever is prescribed and with whatever law, the motion that was found has these forces when it
/// is given.
#[test]
fn the_motion_has_the_forces_when_it_is_given() {
    let coulomb = contact();
    let bristles = common::problem(Kinematics::free_rolling(30.0));
    let falling = Arc::new(Polach::new(0.4, 0.5, 0.6).unwrap());
    let falling = bristles
        .clone()
        .with_interface(|interface| interface.friction = Friction::new(falling, 20.0));
    let total = bristles.clone().with_interface(|interface| {
        interface.contact_law = TotalDisplacement::new(5e6).unwrap().into();
    });
    let hot = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    let heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    let hot = bristles.clone().with_interface(|interface| {
        interface.friction = Friction::new(hot, 20.0);
        interface.heat = heat;
    });
    for (name, problem) in [
        ("coulomb", coulomb),
        ("bristles", bristles),
        ("total", total),
        ("falling", falling),
        ("hot", hot),
    ] {
        let load = problem.normal.normal_contact(None).unwrap().summary.load;
        for [x, y, moment] in
            [[-0.1, f64::NAN, f64::NAN], [0.15, -0.1, f64::NAN], [-0.1, 0.05, 1e-4]]
        {
            let given = |part: f64| (!part.is_nan()).then_some(part * load);
            let x = given(x).map(LongitudinalForce::Force);
            let prescribed = PrescribedForces { x, y: given(y), moment_z: given(moment) };
            let problem = Problem { prescribed, ..problem.clone() };
            let found = found_by(&Method::Full, &problem);
            let again = found_by(&Method::Full, &with_motion_of(&problem, &found));
            println!(
                "{name} {prescribed:?}: {:?} {:.0} products",
                found.kinematics, found.work.operator_products
            );
            let close = |one: f64, other: f64| {
                assert!((one - other).abs() < 2e-5 * load, "{name}: {one} {other}");
            };
            for state in [&found, &again] {
                if let Some(force) = prescribed.x {
                    close(state.force.x, force.under(load));
                }
                if let Some(force) = prescribed.y {
                    close(state.force.y, force);
                }
                if let Some(moment) = prescribed.moment_z {
                    close(state.force.moment_z.unwrap() / 5e-3, moment / 5e-3);
                }
            }
        }
    }
}

/// Bristles from soft ones through those of which some are treated as stick and slip (30 to 60
/// times as stiff as a cell) to stiff ones, with F_x alone and with F_x, F_y and spin: the motion
/// that was found has the forces when it is given, at most twice the products of that.
#[test]
fn bristles_of_any_stiffness() {
    let mut problem = contact();
    let limit = limit(&problem);
    for stiffness in [1e7, 2e7, 2.5e7, 3e7, 4e7, 6e7, 1e8, 1e9] {
        problem.interface.contact_law = Incremental::new(stiffness).unwrap().into();
        for (x, y, spin) in [(-0.5, None, 0.0), (-0.3, Some(0.4), 0.3), (-0.9, Some(0.0), 0.3)] {
            problem.kinematics = Kinematics { spin, ..Kinematics::free_rolling(30.0) };
            problem.prescribed = forces(x * limit, y.map(|y| y * limit));
            let found = solve(&problem, &options(40));
            let given = with_motion_of(&problem, &found);
            let again = Method::Full.solver(&options(40)).solve(&given, &unwatched).unwrap();
            let [one, other] = [&found, &again].map(|solution| solution.work.operator_products);
            println!("{stiffness:e} {x} {y:?}: {one:.1} products, {other:.1} with creepages given");
            for state in [&found, &again] {
                assert!((state.force.x - x * limit).abs() < 2e-5 * limit, "{stiffness:e} {x}");
                if let Some(y) = y {
                    assert!((state.force.y - y * limit).abs() < 2e-5 * limit, "{stiffness:e} {x}");
                }
            }
            assert!(one <= 2.0 * other, "{stiffness:e} {x} {y:?}: {one} {other}");
        }
    }
}

/// Forces and torques that say the same: F_x = −0.1 N = T/r.
#[test]
fn a_traction_coefficient_and_a_torque_are_forces() {
    let problem = contact();
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let braking = -0.1 * load;
    let found = |x| {
        let prescribed = PrescribedForces { x: Some(x), ..PrescribedForces::default() };
        found_by(&Method::Full, &Problem { prescribed, ..problem.clone() }).kinematics.creepage_x
    };
    let of_force = found(LongitudinalForce::Force(braking));
    assert!(of_force > 0.0, "a braking force is negative, its creepage positive");
    assert_eq!(found(LongitudinalForce::OverLoad(0.1)), of_force);
    let torque = LongitudinalForce::Torque { torque: 0.46 * braking, radius: 0.46 };
    assert!((found(torque) / of_force - 1.0).abs() < 1e-12);
}

/// Forces that are next to nothing follow Kalker's linear theory to the accuracy of the grid, and
/// exactly in proportion: 1 N and 1 µN on a contact of 75 kN.
#[test]
fn small_forces_are_linear() {
    let problem = contact();
    let creepage = |force: f64| {
        let problem = Problem { prescribed: forces(force, None), ..problem.clone() };
        solve(&problem, &options(40)).kinematics.creepage_x / force
    };
    assert!((creepage(1.0) / creepage(1e-6) - 1.0).abs() < 1e-4);
    let linear = Problem { prescribed: forces(1.0, None), ..problem.clone() };
    let kalker = found_by(&Method::Fast(FastMethod::KalkerLinear), &linear).kinematics.creepage_x;
    // Errors of a contact that sticks up to its trailing edge fall as the size of its cells.
    let linear = Problem { prescribed: forces(1e-6, None), ..problem.clone() };
    let coarse = solve(&linear, &options(20)).kinematics.creepage_x / 1e-6;
    let found = 2.0 * creepage(1e-6) - coarse;
    assert!((found / kalker - 1.0).abs() < 0.005, "{}", found / kalker);
}

/// A fast method with friction that falls: the two creepages are the roots of its own creep curve,
/// found by bisection on either side of its maximum, and beyond the maximum there is none.
#[test]
fn polach_falling_friction_has_two_creepages() {
    let law = Arc::new(Polach::new(0.55, 0.4, 0.6).unwrap());
    let problem = common::problem(Kinematics::free_rolling(10.0))
        .with_interface(|interface| interface.friction = Friction::new(law, 20.0));
    let method = Method::Fast(FastMethod::Polach(AreaReduction::DRY));
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let force = |creepage_x: f64| {
        let kinematics = Kinematics { creepage_x, ..problem.kinematics };
        let problem = Problem { kinematics, ..problem.clone() };
        -method.solver(&options(16)).solve(&problem, &unwatched).unwrap().force.x
    };
    let peak = (1..4000)
        .map(|k| f64::from(k) * 1e-4)
        .max_by(|a, b| force(*a).total_cmp(&force(*b)))
        .unwrap();
    let root = |mut below: f64, mut above: f64, wanted: f64| {
        for _ in 0..60 {
            let middle = 0.5 * (below + above);
            *(if force(middle) < wanted { &mut below } else { &mut above }) = middle;
        }
        below
    };
    let wanted = 0.97 * force(peak);
    let [low, high] = [root(0.0, peak, wanted), root(0.9, peak, wanted)];
    let problem = Problem { prescribed: forces(-wanted, None), ..problem.clone() };
    for (branch, here, there) in [(Branch::LowSlip, low, high), (Branch::HighSlip, high, low)] {
        let problem = Problem { branch, ..problem.clone() };
        let found = method.solver(&options(16)).solve(&problem, &unwatched).unwrap();
        assert!((found.kinematics.creepage_x / here - 1.0).abs() < 1e-4);
        let other = found.warnings.iter().find_map(|warning| match warning {
            Warning::SeveralMotions { creepages, .. } => Some(creepages[0]),
            _ => None,
        });
        assert!((other.unwrap() / there - 1.0).abs() < 1e-4);
    }
    let beyond = Problem { prescribed: forces(-1.01 * force(peak), None), ..problem.clone() };
    let error = method.solver(&options(16)).solve(&beyond, &unwatched).unwrap_err();
    let Error::Force { error: ForceError::Unreachable { largest, limit: None, .. } } = error else {
        panic!("{error}")
    };
    assert!((-largest / force(peak) - 1.0).abs() < 1e-5, "{largest} {} of {load}", force(peak));
}

/// The full solver on falling friction: both states have the force when their creepages are given.
#[test]
fn both_states_of_falling_friction_have_the_force() {
    let law = Arc::new(Polach::new(0.4, 0.4, 0.3).unwrap());
    let problem = common::problem(Kinematics::free_rolling(20.0))
        .with_interface(|interface| interface.friction = Friction::new(law, 20.0));
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let problem = Problem { prescribed: forces(-0.3 * load, None), ..problem };
    let low = found_by(&Method::Full, &problem);
    let high = found_by(&Method::Full, &Problem { branch: Branch::HighSlip, ..problem.clone() });
    assert!(high.kinematics.creepage_x > 4.0 * low.kinematics.creepage_x);
    for state in [&low, &high] {
        let again = found_by(&Method::Full, &with_motion_of(&problem, state));
        assert!((again.force.x / load + 0.3).abs() < 2e-5, "{}", again.force.x / load);
    }
}

/// Beyond friction: μN is the largest force of Coulomb's law, with spin less where the wheel would
/// have to lock; both are errors that say so.
#[test]
fn forces_beyond_friction_are_refused_with_the_largest() {
    let problem = contact();
    let limit = limit(&problem);
    let refused = |x, y, spin| {
        let kinematics = Kinematics { spin, ..problem.kinematics };
        let problem = Problem { prescribed: forces(x, y), kinematics, ..problem.clone() };
        let mut solver = Method::Full.solver(&options(16));
        match solver.solve(&problem, &unwatched).unwrap_err() {
            Error::Force { error: ForceError::Unreachable { quantity, largest, limit, .. } } => {
                (quantity, largest, limit.unwrap())
            }
            other => panic!("{other}"),
        }
    };
    let (quantity, largest, of) = refused(-1.2 * limit, None, 0.0);
    assert_eq!(quantity, Quantity::ForceX);
    assert!((largest + limit).abs() < 1e-9 * limit && (of - limit).abs() < 1e-9 * limit);
    let (_, largest, _) = refused(0.8 * limit, Some(0.8 * limit), 0.0);
    assert!((largest - limit * 0.5_f64.sqrt()).abs() < 1e-9 * limit);
    // Just short of the limit there is a creepage.
    let near = Problem { prescribed: forces(-0.995 * limit, None), ..problem.clone() };
    let found = found_by(&Method::Full, &near);
    assert!((found.force.x / limit + 0.995).abs() < 1e-5);
}

/// Close to the peak of falling friction both creepages are found, each on its side of it: with
/// laws of the temperature and of the slip speed, with the full solver and with FASTSIM.
#[test]
fn both_states_next_to_the_peak() {
    let polach = Arc::new(Polach::new(0.36, 0.38, 0.7).unwrap());
    let falling =
        contact().with_interface(|interface| interface.friction = Friction::new(polach, 20.0));
    let brush = Brush { bound: TractionBound::Elliptic, ..Brush::KALKER };
    let fastsim = Method::Fast(FastMethod::Fastsim(brush));
    for (name, problem, method) in [
        ("heat", heated(), Method::Full),
        ("speed", falling.clone(), Method::Full),
        ("FASTSIM", falling, fastsim),
    ] {
        let own = Creepages::of(&problem.kinematics);
        let path = Path::new(own, Creepages { x: 0.1, ..own }).unwrap();
        let mut solver = method.solver(&options(12));
        let curve = trace(&mut *solver, &problem, &path, &Sampling::default(), &unwatched).unwrap();
        let peak = curve.maximum().unwrap();
        for part in [0.9, 0.97, 0.98, 0.99, 0.995, 0.998] {
            let force = part * peak.force.x;
            let prescribed = forces(force, None);
            let at = |branch: Branch| {
                let problem = Problem { prescribed, branch, ..problem.clone() };
                let solution = method.solver(&options(12)).solve(&problem, &unwatched);
                let solution = solution.unwrap_or_else(|error| panic!("{name}, {part}: {error}"));
                let off = (solution.force.x / force - 1.0).abs();
                assert!(off < 1e-4, "{name}, {part}: {off:e}");
                let is_told = |warning: &Warning| matches!(warning, Warning::SeveralMotions { .. });
                assert!(solution.warnings.iter().any(is_told), "{name}, {part}");
                solution.kinematics.creepage_x
            };
            let (low, high) = (at(Branch::LowSlip), at(Branch::HighSlip));
            let top = peak.kinematics.creepage_x;
            assert!(low < top && high > top, "{name}, {part}: {low} {top} {high}");
        }
    }
}

/// Forces over time beyond falling friction: the first step that misses them is named, and the
/// creepages stay those of a wheel that turns.
#[test]
fn forces_over_time_beyond_falling_friction_are_named() {
    let mut problem = heated();
    problem.kinematics = Kinematics::free_rolling(30.0);
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let history = History {
        time: vec![0.0, 1e-3, 2e-3],
        force_x: Some([0.0, -0.4, -0.1].map(|part| part * load).to_vec()),
        ..History::default()
    };
    let transient = Transient { problem, history, initial_state: None };
    let marched = march(&transient, &options(8), &unwatched).unwrap();
    assert_eq!(marched.status, Status::NotConverged);
    let told = marched.warnings[0].message(&Names).text;
    assert!(told.contains("the time step that ends at") && told.contains("force_x"), "{told}");
    let creepages = marched.history.iter().map(|instant| instant.kinematics.creepage_x);
    let largest = creepages.fold(0.0_f64, |largest, creepage| largest.max(creepage.abs()));
    assert!(largest <= 0.951, "{largest}");
}

/// Where friction falls so little that the wheel would lock before a force is reached again, the
/// falling branch that was asked for is missed aloud.
#[test]
fn a_branch_that_is_not_there_is_told() {
    let law = Arc::new(Polach::new(0.4, 0.9, 0.1).unwrap());
    let problem =
        contact().with_interface(|interface| interface.friction = Friction::new(law, 20.0));
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let prescribed = forces(-0.2 * load, None);
    let problem = Problem { prescribed, branch: Branch::HighSlip, ..problem };
    let solution = Method::Full.solver(&options(12)).solve(&problem, &unwatched);
    let solution = solution.unwrap();
    assert!(solution.warnings.contains(&Warning::OneMotion {}), "{:?}", solution.warnings);
    assert!((solution.force.x / load + 0.2).abs() < 2e-5);
}

/// Friction that falls with heat: on the way to a small force the search tries creepages at which
/// the wheel would turn millions of times as fast as it rolls, whose conduction took all memory.
#[test]
fn creepages_that_no_wheel_has_are_not_tried() {
    let mut problem = heated();
    problem.kinematics = Kinematics::free_rolling(10.0);
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    for part in [0.01, 0.03, 0.05, 0.1] {
        let prescribed = forces(-part * load, None);
        let found = solve(&Problem { prescribed, ..problem.clone() }, &options(8));
        assert!((found.force.x / load + part).abs() < 2e-5, "{part}");
    }
}

/// Friction that falls with heat, and spin.
fn heated() -> Problem {
    let hot = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    let heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    let kinematics = Kinematics { spin: 0.3, ..Kinematics::free_rolling(30.0) };
    common::problem(kinematics).with_interface(|interface| {
        interface.friction = Friction::new(hot, 20.0);
        interface.heat = heat;
    })
}

/// Friction that falls with heat, spin, and no lateral force: the largest braking force is the peak
/// of the curve over ξ along which the lateral force vanishes; both creepages of a smaller force
/// are found, in at most five times the products of one solution.
#[test]
fn the_largest_force_of_falling_friction_is_the_peak() {
    let problem = heated();
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let free = PrescribedForces { y: Some(0.0), ..PrescribedForces::default() };
    let braking = |creepage_x: f64| {
        let kinematics = Kinematics { creepage_x, ..problem.kinematics };
        let problem = Problem { kinematics, prescribed: free, ..problem.clone() };
        -solve(&problem, &options(16)).force.x
    };
    let peak = (1..40).map(|k| braking(5e-4 * f64::from(k))).fold(0.0, f64::max);
    let of_force =
        |force: f64| Problem { prescribed: forces(-force, Some(0.0)), ..problem.clone() };
    // A little beyond the peak, and so far that all of the curve is within one step.
    for wanted in [0.399 * load, 1e12] {
        let beyond = of_force(wanted);
        let error = Method::Full.solver(&options(16)).solve(&beyond, &unwatched);
        match error.unwrap_err() {
            Error::Force { error: ForceError::Unreachable { value, largest, limit: None, .. } } => {
                assert!((-largest / peak - 1.0).abs() < 1e-3, "{largest} {peak}");
                assert!((-value / wanted - 1.0).abs() < 1e-12, "{value}");
            }
            error => panic!("{error}"),
        }
    }
    let found = solve(&of_force(0.8 * peak), &options(24));
    let other = found.warnings.iter().find_map(|warning| match warning {
        Warning::SeveralMotions { creepages, .. } => Some(*creepages),
        _ => None,
    });
    assert!(other.unwrap()[0] > 5.0 * found.kinematics.creepage_x);
    let given = solve(&with_motion_of(&problem, &found), &options(24));
    let [one, other] = [&found, &given].map(|solution| solution.work.operator_products);
    println!("{one:.1} products, {other:.1} with creepages given");
    assert!(one <= 5.0 * other, "{one} {other}");
}

/// A march to the steady state meets the forces as the direct solver does, though its state is
/// another one where it takes heat from the step before.
#[test]
fn a_marching_solver_meets_the_forces() {
    let problem = heated();
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let problem = Problem { prescribed: forces(-0.25 * load, Some(0.0)), ..problem };
    let mut solver = Method::Full.solver_by(Driver::Marching, &options(10));
    let found = solver.solve(&problem, &unwatched).unwrap();
    assert_eq!(found.status, Status::Converged);
    assert!((found.force.x / load + 0.25).abs() < 1e-5, "{}", found.force.x / load);
    assert!((found.force.y / load).abs() < 1e-5, "{}", found.force.y / load);
}

/// Every fast method finds the creepages of a force by its own equations; one without a moment
/// refuses to have it prescribed.
#[test]
fn fast_methods_find_their_own_creepages() {
    let problem = Problem { prescribed: forces(-9e3, Some(4e3)), ..contact() };
    for method in [
        FastMethod::KalkerLinear,
        FastMethod::ShenHedrickElkins,
        FastMethod::Polach(AreaReduction::DRY),
        FastMethod::Fastsim(Brush::KALKER),
    ] {
        let found = found_by(&Method::Fast(method), &problem);
        assert!((found.force.x + 9e3).abs() < 1.0 && (found.force.y - 4e3).abs() < 1.0);
        assert!(found.kinematics.creepage_x > 0.0 && found.kinematics.creepage_y < 0.0);
    }
    let turning = PrescribedForces { moment_z: Some(1.0), ..PrescribedForces::default() };
    let turning = Problem { prescribed: turning, ..contact() };
    let method = Method::Fast(FastMethod::Polach(AreaReduction::DRY));
    let error = method.solver(&options(16)).solve(&turning, &unwatched).unwrap_err();
    assert_eq!(error.code(), "force-not-possible");
}

/// Where creepages must be given, forces are not ignored.
#[test]
fn forces_are_never_ignored() {
    let problem = Problem { prescribed: forces(-9e3, None), ..contact() };
    let error = SteadySolver::new(&options(16)).solve_given(&problem, &unwatched).unwrap_err();
    assert_eq!(error.code(), "force-not-possible");
}

/// Braking that sets in over time and then stays: at the end of every time step the force is the
/// one prescribed, and in the end the creepage is that of steady rolling with this force, whatever
/// the law. A step takes at most 11 products, a third more than with the creepages given.
#[test]
fn forces_over_time_end_in_the_steady_creepage() {
    let bristles = common::problem(Kinematics { spin: 0.2, ..Kinematics::free_rolling(30.0) });
    let coulomb = Problem {
        kinematics: bristles.kinematics,
        normal: Arc::clone(&bristles.normal),
        ..contact()
    };
    let stiff = Incremental::new(1e8).unwrap().into();
    let stiff = coulomb.clone().with_interface(|interface| interface.contact_law = stiff);
    for (name, problem) in [("bristles", bristles), ("coulomb", coulomb), ("stiff", stiff)] {
        let load = problem.normal.normal_contact(None).unwrap().summary.load;
        let wanted = [-0.12 * load, 0.06 * load];
        let over = |force: f64| Some(vec![0.0, force, force]);
        let history = History {
            time: vec![0.0, 0.5e-3, 4e-3],
            force_x: over(wanted[0]),
            force_y: over(wanted[1]),
            ..History::default()
        };
        let problem = Problem { kinematics: problem.kinematics, ..problem };
        let transient = Transient { problem: problem.clone(), history, initial_state: None };
        let marched = march(&transient, &options(16), &unwatched).unwrap();
        assert_eq!(marched.status, Status::Converged);
        for instant in &marched.history {
            let share = (instant.time / 0.5e-3).min(1.0);
            for (force, wanted) in [instant.force.x, instant.force.y].iter().zip(wanted) {
                assert!((force - share * wanted).abs() < 1e-5 * load, "{name} {force} {wanted}");
            }
        }
        let prescribed = forces(wanted[0], Some(wanted[1]));
        let steady = found_by(&Method::Full, &Problem { prescribed, ..problem.clone() }).kinematics;
        let end = marched.kinematics;
        println!("{name}: {end:?} {steady:?}");
        assert!((end.creepage_x / steady.creepage_x - 1.0).abs() < 1e-3);
        assert!((end.creepage_y / steady.creepage_y - 1.0).abs() < 1e-3);
        let creepages = |of: fn(&Kinematics) -> f64| {
            Some(marched.history.iter().map(|instant| of(&instant.kinematics)).collect())
        };
        let given = History {
            time: marched.history.iter().map(|instant| instant.time).collect(),
            creepage_x: creepages(|motion| motion.creepage_x),
            creepage_y: creepages(|motion| motion.creepage_y),
            ..History::default()
        };
        let given = Transient { problem, history: given, initial_state: None };
        let given = march(&given, &options(16), &unwatched).unwrap();
        let [one, other] = [&marched, &given].map(|march| march.work.operator_products);
        let of_a_step = [one, other].map(|products| products / marched.work.steps as f64);
        println!("{name}: {of_a_step:.1?} products of a step");
        assert!(of_a_step[0] < 11.0 && one < 1.33 * other, "{name}: {of_a_step:?}");
    }
}

/// Forces that jump and reverse from one time step to the next are met in every step, on
/// half-spaces with and without bristles and between rigid bodies, in at most 18 products a step.
#[test]
fn forces_over_time_may_jump() {
    let mut bristles = contact();
    bristles.interface.contact_law = Incremental::new(5e6).unwrap().into();
    let mut rigid = bristles.clone();
    rigid.interface.elasticity = Arc::new(Rigid);
    for (name, problem) in [("coulomb", contact()), ("bristles", bristles), ("rigid", rigid)] {
        let limit = limit(&problem);
        let over = |parts: [f64; 4]| {
            let twice = parts.iter().flat_map(|part| [part * limit; 2]);
            Some(twice.collect::<Vec<f64>>())
        };
        let history = History {
            time: vec![0.0, 0.5e-3, 0.501e-3, 1e-3, 1.001e-3, 1.5e-3, 1.501e-3, 2e-3],
            force_x: over([-0.8, 0.8, 0.1, -0.6]),
            force_y: over([0.3, -0.4, 0.9, -0.7]),
            ..History::default()
        };
        let transient = Transient { problem, history, initial_state: None };
        let marched = march(&transient, &options(12), &unwatched).unwrap();
        assert_eq!(marched.status, Status::Converged, "{name}");
        for instant in &marched.history {
            let has_passed = |jump: &&f64| instant.time >= **jump;
            let which = [0.501e-3, 1.001e-3, 1.501e-3].iter().filter(has_passed).count();
            let [x, y] = [[-0.8, 0.8, 0.1, -0.6][which], [0.3, -0.4, 0.9, -0.7][which]];
            let is_between = [0.5e-3, 1e-3, 1.5e-3]
                .iter()
                .any(|jump| (0.0..1e-6).contains(&(instant.time - jump)));
            let off = (instant.force.x / limit - x).hypot(instant.force.y / limit - y);
            assert!(is_between || off < 2e-5, "{name} at {}: {off:e}", instant.time);
        }
        let of_a_step = marched.work.operator_products / marched.work.steps as f64;
        println!("{name}: {of_a_step:.1} products of a step");
        assert!(of_a_step < 18.0, "{name}: {of_a_step}");
    }
}

/// A force over time that friction cannot bear is refused with its time.
#[test]
fn forces_over_time_beyond_friction_are_refused() {
    let problem = contact();
    let force_x = Some(vec![0.0, -1.5 * limit(&problem)]);
    let history = History { time: vec![0.0, 1e-3], force_x, ..History::default() };
    let transient = Transient { problem: problem.clone(), history, initial_state: None };
    let error = march(&transient, &options(16), &unwatched).unwrap_err();
    assert_eq!((error.code(), error.quantity()), ("unreachable-force", Quantity::HistoryForceX));
    assert!(error.to_string().starts_with("at 1e-3 s, force_x_history"), "{error}");
}
