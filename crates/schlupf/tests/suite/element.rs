//! The force element: its forces, derivatives and states.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::common::transients::{self, LIMIT, LOAD, contact};
use crate::common::{self, Random};
use approx::assert_relative_eq;
use schlupf::analysis::table_building::{NothingKept, TableOptions, build};
use schlupf::bodies::Kinematics;
use schlupf::element::{Element, Evaluation, Motion, Normal, Settings, Status};
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::{Exponential, Product, SlipTerms, TemperatureLinear};
use schlupf::interface::heat::{Duhamel, Heat};
use schlupf::problem::{AreaReduction, Brush, FastMethod, Method};
use schlupf::solution::Resultant;
use schlupf::solver::reference::CattaneoMindlin;
use schlupf::solver::simplified::FastContact;
use schlupf::{Options, Problem, Quantity, unwatched};

const MOTION: Kinematics =
    Kinematics { creepage_x: 1e-3, creepage_y: -5e-4, spin: 0.2, ..Kinematics::free_rolling(20.0) };

const VELOCITIES: Settings = Settings {
    motion: Motion::Velocities,
    normal: Normal::Load,
    has_memory: false,
    standstill_speed: 0.01,
    rolling_radius: 0.46,
};

const BY_CREEPAGES: Settings = Settings { motion: Motion::Creepages, ..VELOCITIES };

const REMEMBERING: Settings = Settings { has_memory: true, ..VELOCITIES };

fn methods() -> Vec<FastMethod> {
    let polach = FastMethod::Polach(AreaReduction { area_adhesion: 0.9, area_slip: 0.4 });
    let options = TableOptions {
        axis_ratios: [0.5, 2.0],
        tolerance: 0.3,
        states: 10,
        ..TableOptions::default()
    };
    let table = Arc::new(build(&options, &NothingKept, &unwatched).unwrap().table);
    let table = FastMethod::Table(table);
    vec![FastMethod::KalkerLinear, FastMethod::ShenHedrickElkins, polach, table]
}

/// Friction that falls with temperature and slip speed.
fn falling() -> Problem {
    let hot = TemperatureLinear::new(0.4, 700.0, 0.1).unwrap();
    let fast = Exponential(SlipTerms::new(0.4, 0.1, 2.0, None).unwrap());
    let mut problem = Problem::builder().load(80e3).kinematics(MOTION).build().unwrap();
    problem.interface.friction.law = Arc::new(Product::new(Arc::new(hot), Arc::new(fast)).unwrap());
    problem
}

fn element(problem: &Problem, method: &FastMethod, settings: Settings) -> Element {
    let method = Method::Fast(method.clone());
    Element::new(problem, (&method, &Options::default()), settings).unwrap()
}

fn evaluate(element: &mut Element, inputs: &[f64], states: &[f64]) -> Evaluation {
    let mut found = element.evaluation();
    assert_eq!(element.evaluate(inputs, states, &mut found), Status::Found);
    found
}

/// Outputs and rates.
fn values(found: &Evaluation) -> Vec<f64> {
    [found.outputs.clone(), found.rates.clone()].concat()
}

/// Lets time pass (in s) until nothing changes.
fn settled(element: &Element, inputs: &[f64], duration: f64) -> Vec<f64> {
    let mut states = vec![0.0; element.states().len()];
    element.advance(inputs, &mut states, duration);
    states
}

/// The forces are those of the method, by creepages and by velocities, without memory and with
/// memory in steady rolling.
#[test]
fn the_forces_are_those_of_the_method() {
    let problem = falling();
    for method in methods() {
        let options = Options::default();
        let mut contact = FastContact::new(&problem, method.clone(), &options).unwrap();
        let exact = contact.force(&MOTION).unwrap();
        let plain = element(&problem, &method, BY_CREEPAGES);
        let by_velocities = element(&problem, &method, VELOCITIES);
        let remembering = element(&problem, &method, REMEMBERING);
        for (mut element, allowed) in [(plain, 1e-12), (by_velocities, 1e-6), (remembering, 1e-5)] {
            let mut inputs = element.start();
            if element.inputs()[0] == Quantity::VelocityX {
                // The same slip and (v_x + ωR)/2.
                inputs[0] = 20.0 * (1.0 + 0.5e-3);
                inputs[3] = 20.0 * (1.0 - 0.5e-3) / 0.46;
            }
            let states = settled(&element, &inputs, 10.0);
            let found = evaluate(&mut element, &inputs, &states);
            let limit = 0.4 * 80e3;
            assert!((found.outputs[0] - exact.x).abs() < allowed * limit, "{method:?}");
            assert!((found.outputs[1] - exact.y).abs() < allowed * limit, "{method:?}");
            assert_eq!(exact.moment_z.is_some(), element.outputs()[2] == Quantity::MomentZ);
        }
    }
}

/// Every derivative, by creepages and velocities, loads and approaches, without and with memory,
/// at speed, near standstill, backwards and at rest, against central differences.
#[test]
fn derivatives_are_those_of_central_differences() {
    let problem = falling();
    let mut random = Random(7);
    for method in methods() {
        for motion in [Motion::Creepages, Motion::Velocities] {
            for normal in [Normal::Load, Normal::Approach] {
                for has_memory in [false, true] {
                    let settings = Settings { motion, normal, has_memory, ..VELOCITIES };
                    let mut element = element(&problem, &method, settings);
                    // The splines of a table are of single precision.
                    let is_table = matches!(method, FastMethod::Table(..));
                    let near = if is_table { [30.0, 5e-3, 1e-6] } else { [1.0, 2e-4, 1e-9] };
                    for speed in [20.0, 0.013, 4e-3, -6e-3, -3.0] {
                        check_derivatives(&mut element, speed, near, &mut random);
                    }
                }
            }
        }
    }
}

/// The forces of the methods that solve for tractions, and their derivatives, with friction that
/// falls with slip and temperature: at speed, and where the wheel slides at standstill.
#[test]
fn solvers_are_elements_too() {
    let problem = falling();
    let mut random = Random(11);
    let options = Options { tolerance: 1e-11, ..common::cells(6) };
    for method in [Method::Fast(FastMethod::Fastsim(Brush::KALKER)), Method::Full] {
        let exact = method.solver(&options).solve(&problem, &unwatched).unwrap();
        for settings in [BY_CREEPAGES, Settings { has_memory: true, ..BY_CREEPAGES }] {
            let mut element = Element::new(&problem, (&method, &options), settings).unwrap();
            let inputs = element.start();
            let states = settled(&element, &inputs, 10.0);
            let found = evaluate(&mut element, &inputs, &states);
            let Resultant { x, y, moment_z } = exact.force;
            for (found, exact) in found.outputs.iter().zip([x, y, moment_z.unwrap()]) {
                assert!((found - exact).abs() < 1e-4 * 0.4 * 80e3, "{found} {exact}");
            }
            for speed in [20.0, 1e-3] {
                check_derivatives(&mut element, speed, [300.0, 2e-2, 1e-6], &mut random);
            }
        }
    }
}

/// Steps of the inputs and the states that matter, each in its unit.
fn check_derivatives(
    element: &mut Element,
    speed: f64,
    [wide, allowed, noise]: [f64; 3],
    random: &mut Random,
) {
    let mut inputs = element.start();
    let is_by_velocities = element.inputs()[0] == Quantity::VelocityX;
    let scale = if is_by_velocities { speed.abs() + 0.01 } else { 1.0 };
    let creepages = [2e-3, 2e-3, 0.5].map(|most| random.between(-most, most) * scale);
    if is_by_velocities {
        inputs[0] = speed + creepages[0];
        inputs[1] = creepages[1];
        inputs[2] = creepages[2];
        inputs[3] = speed / 0.46;
    } else {
        inputs[..3].copy_from_slice(&creepages);
        inputs[3] = speed;
    }
    inputs[4] *= random.between(0.2, 1.5);
    inputs[5] = random.between(0.5, 1.5);
    inputs[6] = random.between(20.0, 300.0);
    inputs[7] = random.between(20.0, 300.0);
    let most = [2e-5, 2e-5, 5e-3];
    let states: Vec<f64> =
        most[..element.states().len()].iter().map(|most| random.between(-most, *most)).collect();
    let found = evaluate(element, &inputs, &states);
    let mut steps = [scale, scale, 10.0 * scale, 1.0, 1e4, 1.0, 300.0, 300.0].map(|s| 1e-6 * s);
    steps[3] *= if is_by_velocities { 1e-2 * scale } else { speed.abs().max(0.01) };
    if element.inputs()[4] == Quantity::Approach {
        steps[4] = 1e-6 * inputs[4];
    }
    steps.iter_mut().take(2).for_each(|step| *step *= 1e-2);
    let steps = steps.iter().copied().chain([1e-10, 1e-10, 1e-7]).map(|step| wide * step);
    let given = [inputs, states].concat();
    for (by, step) in (0..given.len()).zip(steps) {
        let [more, less] = [step, -step].map(|step| {
            let mut moved = given.clone();
            moved[by] += step;
            values(&evaluate(element, &moved[..8], &moved[8..]))
        });
        for (of, (more, less)) in more.iter().zip(less).enumerate() {
            let difference = (more - less) / (2.0 * step);
            let exact = found.derivative(of, by);
            let value = values(&found)[of].abs();
            let size = if of < 2 { value.max(1e4) } else { value } / step;
            let error = (exact - difference).abs();
            let allowed = allowed * difference.abs().max(exact.abs()) + noise * size;
            assert!(error <= allowed, "{of} by {by} at {speed}: {exact} {difference}\n{given:?}");
        }
    }
}

/// The contact of CONTACT's transients, at 1 m/s.
fn transient() -> Element {
    let problem = transients::reference(ContactLaw::Coulomb);
    element(&problem, &FastMethod::ShenHedrickElkins, REMEMBERING)
}

/// −Fx/(μN).
fn ratio(element: &mut Element, inputs: &[f64], states: &[f64]) -> f64 {
    -evaluate(element, inputs, states).outputs[0] / LIMIT
}

/// CONTACT, rolling from a contact without tractions: one lag is within 6 % of μN on the way.
#[test]
fn rolling_from_rest_follows_contact() {
    let mut element = transient();
    let (inputs, mut states, mut before) = (element.start(), vec![0.0; 3], 0.0);
    for [distance, exact] in contact("T1") {
        element.advance(&inputs, &mut states, distance - before);
        before = distance;
        let found = ratio(&mut element, &inputs, &states);
        assert!((found - exact).abs() < 0.06, "{distance}: {found} {exact}");
    }
}

/// Cattaneo 1938, Mindlin 1949: a wheel at rest sticks with the stiffness of the patch, slides as a
/// whole a little beyond the exact shift, and goes on to slide; on the way back one elastic
/// deformation is unwound.
#[test]
fn a_wheel_at_rest_sticks_and_slides() {
    let mut element = transient();
    let spheres = CattaneoMindlin {
        radius: 6e-3,
        load: LOAD,
        friction_coefficient: 0.3,
        shear_modulus: 0.5 * 210e9 / 1.28,
        poisson_ratio: 0.28,
    };
    let full = spheres.full_sliding_shift();
    let mut inputs = element.start();
    let mut states = vec![0.0; 3];
    // The wheel's centre moves by a share of the shift a second, and back.
    let mut shift = |states: &mut Vec<f64>, share: f64| {
        (inputs[0], inputs[3]) = (share * full, 0.0);
        element.advance(&inputs, states, 1.0);
        ratio(&mut element, &inputs, states)
    };
    let initial = shift(&mut states, 1e-3) / 1e-3;
    assert_relative_eq!(initial, 1.5, max_relative = 2e-3);
    let mut at = 1e-3;
    while at < 1.0 {
        at += 0.05;
        let found = shift(&mut states, 0.05);
        assert!((found - spheres.force_over_limit(at * full)).abs() < 0.06, "{at}: {found}");
    }
    for _ in 0..100 {
        assert!(shift(&mut states, 0.5) > 0.99);
    }
    let back = (1..100).find(|_| shift(&mut states, -0.1) < 0.0);
    assert!(back.is_some_and(|steps| (5..25).contains(&steps)), "{back:?}");
}

/// Forces and slopes.
type Sample = (Vec<f64>, Vec<f64>);

/// Forces and their slopes have no jumps from rolling forwards through standstill to rolling
/// backwards, with spin and with slip that reverses.
#[test]
fn nothing_jumps_at_standstill() {
    let problem = falling();
    for method in methods() {
        for settings in [VELOCITIES, REMEMBERING] {
            let mut element = element(&problem, &method, settings);
            let states = [4e-6, -2e-6, 1e-3][..element.states().len()].to_vec();
            let at = |k: i32| {
                let speed = 2e-6 * f64::from(k);
                let mut inputs = element.start();
                let slip = [0.03 * speed + 1e-5, 1e-5 - 0.05 * speed];
                (inputs[0], inputs[1], inputs[2]) = (speed + slip[0], slip[1], 1e-3);
                inputs[3] = speed / 0.46;
                let found = evaluate(&mut element, &inputs, &states);
                let slopes = (0..2).map(|of| found.derivative(of, of)).collect::<Vec<_>>();
                (found.outputs[..2].to_vec(), slopes)
            };
            let all: Vec<_> = (-10_000..10_000).map(at).collect();
            let largest = |of: fn(&Sample) -> &Vec<f64>| {
                let size = all.iter().flat_map(of).fold(1e-9, |size: f64, x| size.max(x.abs()));
                let jump = |pair: &[Sample]| {
                    let pairs = of(&pair[0]).iter().zip(of(&pair[1]));
                    pairs.fold(0.0, |jump: f64, (one, two)| jump.max((one - two).abs()))
                };
                all.windows(2).map(jump).fold(0.0, f64::max) / size
            };
            assert!(largest(|at| &at.0) < 0.01, "{method:?} {}", largest(|at| &at.0));
            // Polach's forces have kinks with spin, where η_c changes between η and η + φa.
            let is_smooth = !matches!(method, FastMethod::Polach(..));
            assert!(!is_smooth || largest(|at| &at.1) < 0.05, "{method:?} {}", largest(|at| &at.1));
        }
    }
}

/// The states move as their rates say.
#[test]
fn advancing_is_integrating_the_rates() {
    let mut element = element(&falling(), &FastMethod::ShenHedrickElkins, REMEMBERING);
    let mut inputs = element.start();
    (inputs[0], inputs[2], inputs[3]) = (0.031, 0.2, 0.03 / 0.46);
    let mut exact = vec![1e-5, -1e-5, 1e-3];
    let mut stepped = exact.clone();
    element.advance(&inputs, &mut exact, 0.4);
    let steps = 20_000;
    for _ in 0..steps {
        let rates = evaluate(&mut element, &inputs, &stepped).rates;
        for (state, rate) in stepped.iter_mut().zip(rates) {
            *state += rate * 0.4 / f64::from(steps);
        }
    }
    for (exact, stepped) in exact.iter().zip(stepped) {
        assert_relative_eq!(*exact, stepped, max_relative = 1e-3);
    }
}

/// What is not a contact is a status: no load, numbers that are not finite, other sizes.
#[test]
fn nothing_in_the_loop_is_an_error() {
    let problem = falling();
    for method in methods() {
        let mut element = element(&problem, &method, REMEMBERING);
        let mut found = element.evaluation();
        for load in [0.0, -1e5, -f64::MIN_POSITIVE] {
            let mut inputs = element.start();
            inputs[4] = load;
            let status = element.evaluate(&inputs, &[1e-5, 0.0, 0.0], &mut found);
            assert_eq!(status, Status::NoContact);
            assert!(found.outputs[..4].iter().all(|force| *force == 0.0));
            let numbers = found.derivatives.iter().chain(&found.rates);
            assert!(numbers.clone().all(|number| number.is_finite()));
        }
        let mut inputs = element.start();
        for bad in [f64::NAN, f64::INFINITY] {
            inputs[0] = bad;
            assert_eq!(element.evaluate(&inputs, &[0.0; 3], &mut found), Status::NotFinite);
            assert!(found.outputs.iter().all(|output| output.is_nan()));
            assert_eq!(element.advance(&inputs, &mut [0.0; 3], 0.1), Status::NotFinite);
        }
        assert_eq!(element.evaluate(&inputs[1..], &[0.0; 3], &mut found), Status::WrongSize);
        assert_eq!(element.evaluate(&inputs, &[], &mut found), Status::WrongSize);
        // From the smallest to huge loads, slips and speeds.
        for scale in [1e-12, 1e-3, 1e3] {
            for speed in [0.0, 1e-12, 1e-3, -100.0, 1e3] {
                let inputs =
                    [speed + scale, -scale, scale, speed / 0.46, 80e3 * scale, 1.0, 20.0, 20.0];
                evaluate(&mut element, &inputs, &[scale, 0.0, -scale]);
                assert!(found.outputs.len() == element.outputs().len());
            }
        }
    }
}

/// A wheel that lands has no more force than friction allows, from the first touch on.
#[test]
fn landing_begins_without_a_force() {
    let mut element = transient();
    let mut inputs = element.start();
    (inputs[0], inputs[3]) = (20.0, 19.0 / 0.46);
    let mut states = vec![0.0; 3];
    inputs[4] = -1.0;
    let mut found = element.evaluation();
    assert_eq!(element.advance(&inputs, &mut states, 0.1), Status::NoContact);
    for k in 1..=1000 {
        inputs[4] = LOAD * f64::from(k) / 1000.0;
        element.advance(&inputs, &mut states, 1e-5);
        assert_eq!(element.evaluate(&inputs, &states, &mut found), Status::Found);
        let limit = 0.3 * inputs[4] * (1.0 + 1e-9);
        assert!(found.outputs[0].hypot(found.outputs[1]) <= limit);
    }
}

/// What a contact element does not take is refused by name.
#[test]
fn what_it_does_not_take_is_refused() {
    let problem = falling();
    let still = Settings { standstill_speed: 0.0, ..VELOCITIES };
    let method = Method::Fast(FastMethod::ShenHedrickElkins);
    let error = Element::new(&problem, (&method, &Options::default()), still).unwrap_err();
    assert_eq!(error.quantity(), Quantity::StandstillSpeed);
    // A patch of given size has no approach.
    let given = common::problem(MOTION);
    let by_approach = Settings { normal: Normal::Approach, ..VELOCITIES };
    let error = Element::new(&given, (&method, &Options::default()), by_approach).unwrap_err();
    assert_eq!(error.code(), "approach-of-element");
}

type Vector5 = nalgebra::SVector<f64, 5>;
type Matrix5 = nalgebra::SMatrix<f64, 5, 5>;

/// A wheel with its share of a vehicle on a gradient, by the implicit Euler method: speed, turning
/// rate and elastic shifts.
struct Rolling {
    element: Element,
    torque: f64,
}

const MASS: f64 = 10e3;
const INERTIA: f64 = 100.0;
const RADIUS: f64 = 0.46;

impl Rolling {
    /// Residual of a step (in s) and its derivatives.
    fn residual(&mut self, [from, to]: [&[f64; 5]; 2], step: f64) -> (Vector5, Matrix5) {
        let mut inputs = self.element.start();
        (inputs[0], inputs[1], inputs[2], inputs[3]) = (to[0], 0.0, 0.0, to[1]);
        let found = evaluate(&mut self.element, &inputs, &to[2..]);
        let (force, outputs) = (found.outputs[0], found.outputs.len());
        let gradient = 0.02 * 9.81;
        let mut rates = vec![force / MASS - gradient, (self.torque - RADIUS * force) / INERTIA];
        rates.extend(&found.rates);
        let column = |k: usize| [0, 3, 8, 9, 10][k];
        let slope = |row: usize, by: usize| match row {
            0 => found.derivative(0, column(by)) / MASS,
            1 => -RADIUS * found.derivative(0, column(by)) / INERTIA,
            _ => found.derivative(outputs + row - 2, column(by)),
        };
        let residual = Vector5::from_fn(|k, _| to[k] - from[k] - step * rates[k]);
        let derivatives =
            Matrix5::from_fn(|row, by| f64::from(u8::from(row == by)) - step * slope(row, by));
        (residual, derivatives)
    }

    /// The state after a step (in s), and the Newton steps it took.
    fn step(&mut self, from: &[f64; 5], step: f64) -> ([f64; 5], usize) {
        let mut to = *from;
        for newton in 1..50 {
            let (residual, derivatives) = self.residual([from, &to], step);
            let change = derivatives.lu().solve(&residual).unwrap();
            (0..5).for_each(|k| to[k] -= change[k]);
            if (0..5).all(|k| change[k].abs() < 1e-7 * to[k].abs().max(1e-3)) {
                return (to, newton);
            }
        }
        panic!("{from:?} {to:?}");
    }
}

/// From rolling uphill through standstill to rolling downhill, braked and then driven: an implicit
/// integrator takes no more than 1.2 times as many Newton steps at standstill as at speed.
#[test]
fn newtons_method_converges_as_well_at_standstill() {
    for method in [FastMethod::ShenHedrickElkins, methods().remove(3)] {
        let problem = transients::reference(ContactLaw::Coulomb);
        let element = element(&problem, &method, REMEMBERING);
        let mut rolling = Rolling { element, torque: -2e3 };
        let mut state = [1.0, 1.0 / RADIUS, 0.0, 0.0, 0.0];
        let (mut counts, mut time) = ([[0.0; 2]; 2], 0.0);
        while state[0] > -1.0 {
            // Without a ripple hardly anything changes at speed.
            rolling.torque = -2e3 * (1.0 + 0.5 * (TAU * 30.0 * time).sin());
            time += 1e-3;
            let (next, newton) = rolling.step(&state, 1e-3);
            let (place, speed) = (usize::from(next[0].abs() < 0.02), next[0].abs());
            if place == 1 || speed > 0.5 {
                counts[place] = [counts[place][0] + newton as f64, counts[place][1] + 1.0];
            }
            state = next;
        }
        let [at_speed, at_standstill] = counts.map(|[newton, steps]| newton / steps);
        println!(
            "{method:?}: Newton steps {at_speed:.2} at speed, {at_standstill:.2} at standstill"
        );
        assert!(at_standstill < 1.2 * at_speed, "{at_standstill} {at_speed}");
    }
}

/// At rest nothing below the friction limit moves a wheel for good, however it swings, and with
/// whatever load.
#[test]
fn a_wheel_at_rest_does_not_creep_under_vibration() {
    let element = transient();
    let mut inputs = element.start();
    let mut states = vec![0.0; 3];
    let mut move_by = |states: &mut Vec<f64>, shift: f64, load: f64| {
        (inputs[0], inputs[3], inputs[4]) = (shift, 0.0, load);
        element.advance(&inputs, states, 1.0);
    };
    move_by(&mut states, 2e-6, LOAD);
    let held = states.clone();
    for k in 0..1000 {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        move_by(&mut states, sign * 1e-6, LOAD * (1.0 + 0.2 * sign));
    }
    // A locked wheel that moves at all rolls a little.
    assert_relative_eq!(states[0], held[0], max_relative = 1e-5);
}

/// A wheel that lifts off at rest comes back without traction; where its load falls, it keeps what
/// friction bears.
#[test]
fn lifting_off_at_rest_sheds_the_traction() {
    let mut element = transient();
    let mut inputs = element.start();
    (inputs[0], inputs[1], inputs[2], inputs[3]) = (0.0, 0.0, 0.0, 0.0);
    let mut states = vec![1e-5, 0.0, 0.0];
    let before = ratio(&mut element, &inputs, &states);
    inputs[4] = 0.0;
    element.advance(&inputs, &mut states, 1.0);
    inputs[4] = LOAD;
    assert!(before > 0.3 && ratio(&mut element, &inputs, &states) < 1e-3 * before);
    states[0] = 1e-5;
    inputs[4] = 0.01 * LOAD;
    element.advance(&inputs, &mut states, 1.0);
    inputs[4] = LOAD;
    let after = ratio(&mut element, &inputs, &states);
    assert!((1e-3..0.2).contains(&after), "{after}");
}

/// Sliding at standstill heats as it does without memory: the same slip speed acts.
#[test]
fn sliding_at_standstill_has_its_slip_speed() {
    let mut problem = falling();
    problem.interface.heat = Heat { model: Some(Arc::new(Duhamel)), ..Heat::default() };
    let method = Method::Fast(FastMethod::Fastsim(Brush::KALKER));
    for slip in [0.1, 1.0, 5.0] {
        let [plain, remembering] = [VELOCITIES, REMEMBERING].map(|settings| {
            let options = Options::default();
            let mut element = Element::new(&problem, (&method, &options), settings).unwrap();
            let mut inputs = element.start();
            (inputs[0], inputs[1], inputs[2], inputs[3]) = (0.0, slip, 0.0, 0.0);
            let states = settled(&element, &inputs, 10.0);
            evaluate(&mut element, &inputs, &states).outputs[1]
        });
        assert_relative_eq!(plain, remembering, max_relative = 0.05);
    }
}

/// At a creepage of 1 both surfaces are as hot as in the same motion by the vehicle's speed.
#[test]
fn heat_follows_the_speeds_of_both_surfaces() {
    let [rail, wheel] = [30.0, 10.0];
    let motion = Kinematics { creepage_x: (rail - wheel) / rail, ..Kinematics::free_rolling(rail) };
    let mut problem = Problem::builder().load(80e3).kinematics(motion).build().unwrap();
    problem.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 2e5, 0.1).unwrap());
    problem.interface.heat = Heat { model: Some(Arc::new(Duhamel)), ..Heat::default() };
    let fastsim = FastMethod::Fastsim(Brush::KALKER);
    let expected =
        FastContact::new(&problem, fastsim.clone(), &Options::default()).unwrap().force(&motion);
    let expected = expected.unwrap().x;
    let mut element = element(&problem, &fastsim, VELOCITIES);
    let mut inputs = element.start();
    (inputs[0], inputs[3]) = (rail, wheel / VELOCITIES.rolling_radius);
    let found = evaluate(&mut element, &inputs, &[]).outputs[0];
    println!("{found} {expected}");
    assert!(expected.abs() < 0.39 * 80e3, "heat lowers friction");
    assert_relative_eq!(found, expected, max_relative = 1e-4);
}

/// Without friction, with hardly any, or with less than none: no forces, and finite rates.
#[test]
fn friction_may_vanish() {
    for method in methods() {
        let mut element = element(&falling(), &method, REMEMBERING);
        for factor in [0.0, -1.0, 1e-300, 1e-9] {
            let mut inputs = element.start();
            inputs[5] = factor;
            let found = evaluate(&mut element, &inputs, &[1e-5, 0.0, 1e-3]);
            let is_bounded = !matches!(method, FastMethod::KalkerLinear);
            assert!(!is_bounded || found.outputs[0].abs() < 1e-3, "{:?}", found.outputs);
            let states = settled(&element, &inputs, 10.0);
            assert!(states.iter().all(|state| state.is_finite()));
        }
        // Too large to be numbers.
        let mut found = element.evaluation();
        for (place, value) in [(4, 1e300), (0, 1e200), (0, 1e308)] {
            let mut inputs = element.start();
            inputs[place] = value;
            let status = element.evaluate(&inputs, &[0.0; 3], &mut found);
            let is_finite = found.outputs.iter().all(|output| output.is_finite());
            assert!(status == Status::NotFinite || is_finite);
        }
    }
}
