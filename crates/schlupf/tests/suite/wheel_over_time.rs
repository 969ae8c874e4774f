//! A wheel on a rail whose position and motion change with time: contacts that go on from each
//! other, move, split and merge.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use approx::assert_relative_eq;
use schlupf::bodies::{Body, Material};
use schlupf::elasticity::HalfSpace;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::problem::{History, State};
use schlupf::solution::Instant;
use schlupf::solver::{march, shift};
use schlupf::wheel_rail::{
    Along, Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve,
    RailShape, RowsMove, Side, Sides, Support, Tangential, Track, WheelAt, WheelOnRail,
    WheelOverTime, WheelShape, WheelSolution,
};
use schlupf::{Options, Problem, Quantity, Status, Transient, Watch, unwatched};

const STEEL: Material =
    Material { young_modulus: 2.0 * 82e9 * 1.28, poisson_ratio: 0.28, ..Body::STEEL.material };
const RADIUS: f64 = 0.46;
const SPEED: f64 = 2.0;

fn points(name: &str) -> Vec<[f64; 2]> {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let number = |text: &str| text.parse::<f64>().unwrap();
    let point = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        [1e-3 * number(cells[0]), -1e-3 * number(cells[1])]
    };
    lines.map(point).collect()
}

fn pair(wheel: &[[f64; 2]], rail: &[[f64; 2]], track: &Track) -> Arc<Pair> {
    let curve = |points, quantity| ProfileCurve::new(points, 0.0, quantity).unwrap();
    let wheel = WheelShape {
        profile: curve(wheel, Quantity::WheelProfile).into(),
        nominal_radius: RADIUS,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let rail = RailShape::new(curve(rail, Quantity::RailProfile), 0.0);
    Arc::new(Pair::new(&wheel, &rail, track).unwrap())
}

fn benchmark() -> Arc<Pair> {
    let [wheel, rail] = ["profile_s1002.csv", "profile_uic60_canted.csv"].map(points);
    pair(&wheel, &rail, &Track { gauge: 1.435, ..Track::default() })
}

/// A wheel of the benchmark at a lateral position (in m), which turns faster than it rolls freely.
fn wheel(pair: &Arc<Pair>, lateral: f64, creepage: f64) -> WheelOnRail {
    WheelOnRail {
        pairs: Sides::both(Arc::clone(pair)),
        side: Side::Left,
        position: Position { lateral, yaw: 0.0, roll: 0.0 },
        motion: Motion::straight(SPEED, (1.0 - creepage) * SPEED / RADIUS),
        follows: false,
        drive: Drive::AngularVelocity,
        support: Support::Force(10e3),
        joining: Joining::default(),
        rows: RowsMove::default(),
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 48,
    }
}

fn solve_with<R>(options: &Options, work: impl FnOnce(&Tangential) -> R) -> R {
    let body = Body { material: STEEL, ..Body::STEEL };
    let builder = Problem::builder()
        .wheel(body)
        .rail(body)
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(0.3).unwrap())
        .heat(schlupf::interface::heat::Heat::none())
        .elasticity(HalfSpace::new(&STEEL, &STEEL).unwrap());
    let interface = &builder.build().unwrap().interface;
    work(&Tangential::new(interface, options))
}

fn options(cells: usize) -> Options {
    Options { cells_x: cells, cells_y: cells, ..Options::default() }
}

/// Instants at which it has rolled so far, in m.
fn history_of(wheels: Vec<(f64, WheelOnRail)>) -> WheelOverTime {
    let at = |(distance, wheel): (f64, WheelOnRail)| WheelAt { time: distance / SPEED, wheel };
    let instants = wheels.into_iter().map(at).collect();
    WheelOverTime { instants, starts_rolling: false, rests: false, shift_duration: 1.0 }
}

fn over_time(wheels: Vec<(f64, WheelOnRail)>, cells: usize) -> (WheelSolution, Vec<Instant>) {
    march_wheel(&history_of(wheels), cells)
}

fn march_wheel(history: &WheelOverTime, cells: usize) -> (WheelSolution, Vec<Instant>) {
    let found =
        solve_with(&options(cells), |tangential| history.march(tangential, &unwatched).unwrap());
    assert_eq!(found.0.status(), Status::Converged);
    assert!(found.1.iter().all(|instant| instant.residual <= 1e-6));
    found
}

fn steady(wheel: &WheelOnRail, cells: usize) -> WheelSolution {
    solve_with(&options(cells), |tangential| wheel.solve(tangential, &unwatched).unwrap())
}

fn assert_ends_as(last: &WheelSolution, expected: &WheelSolution, tolerance: f64) {
    for k in 0..3 {
        assert_relative_eq!(last.force[k], expected.force[k], epsilon = tolerance * 3e3);
    }
}

/// Tractions go on from step to step: contacts without a past would have next to none after one
/// cell, a fifth of what they have in steady rolling.
fn assert_goes_on(instants: &[Instant]) {
    for pair in instants.windows(2) {
        let [before, now] = [0, 1].map(|k| pair[k].force.x.hypot(pair[k].force.y));
        assert!(now > 0.6 * before, "{before} N, then {now} N at {} s", pair[1].time);
    }
}

/// Rolling from rest grows into steady rolling, step by step as the contact alone does on a grid of
/// its own; within 0.3 % of μN.
#[test]
fn rolling_from_rest_becomes_steady() {
    // In driving, where the rolling speed is above that of the wheelset.
    let wheel = wheel(&benchmark(), 0.0, -0.001);
    let expected = steady(&wheel, 20);
    let (last, instants) = over_time(vec![(0.0, wheel.clone()), (0.03, wheel)], 20);
    assert_ends_as(&last, &expected, 2e-3);
    let problem = expected.contacts[0].problem.clone();
    let history = History { time: vec![0.0, 0.03 / SPEED], ..History::default() };
    let transient = Transient { history, ..Transient::to_steady_state(&problem) };
    let alone = march(&transient, &options(20), &unwatched).unwrap().history;
    assert_eq!(alone.len(), instants.len());
    for (instant, alone) in instants.iter().zip(&alone) {
        assert_relative_eq!(instant.force.x, alone.force.x, epsilon = 3e-3 * 3e3);
        // Cells are those of the contact without friction, under 0.05 % less load.
        assert_relative_eq!(instant.distance, alone.distance, max_relative = 2e-4);
        let creep = instant.creep_power.unwrap();
        assert!(creep > 0.0 && instant.load > 9.9e3);
    }
}

/// From steady rolling nothing changes while the motion stays, and it ends in another steady state
/// where the motion does.
#[test]
fn steady_rolling_goes_on() {
    let [before, after] = [0.001, 0.0005].map(|creepage| wheel(&benchmark(), 0.0, creepage));
    let [expected, then] = [&before, &after].map(|wheel| steady(wheel, 12));
    let wheels = [(0.0, &before), (0.002, &before), (0.0021, &after), (0.03, &after)];
    let history = history_of(wheels.map(|(distance, wheel)| (distance, wheel.clone())).to_vec());
    let (last, instants) = march_wheel(&WheelOverTime { starts_rolling: true, ..history }, 12);
    assert_eq!((instants[0].time, instants[0].distance), (0.0, 0.0));
    for instant in instants.iter().take_while(|instant| instant.distance < 0.002) {
        assert_relative_eq!(instant.force.x, instants[0].force.x, max_relative = 1e-6);
    }
    assert_relative_eq!(instants[0].force.x, expected.contacts[0].solution.force.x, epsilon = 15.0);
    assert_ends_as(&last, &then, 5e-3);
}

/// A wheelset that rests on both rails does so with the tractions of each step, of both wheels: it
/// ends in the state in which it rolls steadily.
#[test]
fn both_wheels_of_a_resting_wheelset_go_on() {
    let mut wheel = wheel(&benchmark(), 0.0, 0.001);
    wheel.position.lateral = 2e-3;
    let [expected, _] =
        solve_with(&options(12), |how| wheel.solve_resting(how, &unwatched).unwrap());
    let history = history_of(vec![(0.0, wheel.clone()), (0.03, wheel)]);
    let history = WheelOverTime { rests: true, ..history };
    let (last, _) = solve_with(&options(12), |how| history.march(how, &unwatched).unwrap());
    assert_eq!(last.status(), Status::Converged);
    assert_relative_eq!(last.position.roll, expected.position.roll, epsilon = 4e-7);
    assert_ends_as(&last, &expected, 3e-3);
}

/// A wheel under a longitudinal force has it in every step, and ends as in steady rolling.
#[test]
fn a_driven_wheel_has_its_force_in_every_step() {
    let force = 1e3;
    let still = wheel(&benchmark(), 0.0, 0.0);
    let wheel = WheelOnRail { drive: Drive::Force { force, along: Along::Track }, ..still };
    let expected = steady(&wheel, 12);
    let (last, instants) = over_time(vec![(0.0, wheel.clone()), (0.03, wheel)], 12);
    for instant in &instants {
        assert_relative_eq!(instant.force.x, force, max_relative = 1e-3);
    }
    assert_ends_as(&last, &expected, 3e-3);
    let creepage = |wheel: &WheelSolution| wheel.creepage(RADIUS, SPEED);
    assert_relative_eq!(creepage(&last), creepage(&expected), max_relative = 2e-2);
}

/// A shift at rest is that of the contact: the same force within 0.3 % of μN.
#[test]
fn a_shift_of_the_wheel_is_one_of_the_contact() {
    let rests = wheel(&benchmark(), 0.0, 0.0);
    // In one second 10 µm along the track, of which it turns 8 µm.
    let mut shifted = rests.clone();
    shifted.motion.speed = 1e-5;
    shifted.motion.angular_velocity = 8e-6 / RADIUS;
    let (last, instants) = over_time(vec![(0.0, rests.clone()), (0.0, shifted.clone())], 20);
    assert_eq!(instants.len(), 1);
    let [x, y, turn] = instants[0].shift.unwrap();
    let contact = &steady(&shifted, 20).contacts[0];
    let motion = contact.problem.kinematics;
    assert_relative_eq!(x, motion.speed * motion.creepage_x, max_relative = 1e-9);
    assert_relative_eq!(y, motion.speed * motion.creepage_y, epsilon = 1e-12);
    let alone = shift(&contact.problem, [x, y], &options(20), &unwatched).unwrap();
    assert!((x - 2e-6).abs() < 1e-7 && turn.abs() < 1e-6, "{x} {turn}");
    assert_relative_eq!(last.force[0], alone.force.x, epsilon = 3e-3 * 3e3);
    // Without a duration nothing is shifted, as a contact is not without a shift.
    let history =
        WheelOverTime { shift_duration: 0.0, ..history_of(vec![(0.0, rests), (0.0, shifted)]) };
    let found = solve_with(&options(20), |how| history.march(how, &unwatched).unwrap());
    assert_eq!(found.1[0].shift, Some([0.0; 3]));
    assert!(found.0.force[0].abs() < 1e-6, "{:?}", found.0.force);
}

/// Work is counted in iterations of normal contacts and Newton steps. A step over time in another
/// position solves no steady state; in the same one with the same friction the normal contact is
/// not solved again.
#[test]
fn steps_go_on_from_the_step_before() {
    let pair = benchmark();
    let counted = |work: &mut dyn FnMut(Watch)| {
        let count = AtomicUsize::new(0);
        work(&|_| {
            count.fetch_add(1, Ordering::Relaxed);
            ControlFlow::Continue(())
        });
        count.into_inner()
    };
    let [here, there] = [0.0, -0.002].map(|lateral| wheel(&pair, lateral, 0.001));
    let steady = counted(&mut |watch| {
        solve_with(&options(16), |how| here.solve(how, watch).map(drop).unwrap());
    });
    let over = |end: &WheelOnRail, distance: f64| {
        let history = history_of(vec![(0.0, here.clone()), (distance, end.clone())]);
        let mut steps = 0;
        let work = |how: &Tangential, watch: Watch| history.march(how, watch).unwrap().1.len();
        let count = counted(&mut |watch| solve_with(&options(16), |how| steps = work(how, watch)));
        [count, steps].map(|number| number as f64)
    };
    for (end, share) in [(&there, 0.6), (&here, 0.1)] {
        let [short, long] = [0.01, 0.02].map(|distance| over(end, distance));
        let by_step = (long[0] - short[0]) / (long[1] - short[1]);
        assert!(by_step < share * steady as f64, "{by_step} of {steady}");
    }
}

/// A wheel that moves across the rail and stays: at the end it rolls steadily where it is.
#[test]
fn contacts_move_across_the_rail() {
    let pair = benchmark();
    let moves = |lateral: f64| {
        let still = wheel(&pair, lateral, 0.001);
        let motion = Motion { lateral_velocity: -0.003 / 0.02 * SPEED, ..still.motion };
        WheelOnRail { motion, ..still }
    };
    let (start, end) = (moves(0.0), moves(-0.003));
    let stays = wheel(&pair, -0.003, 0.001);
    let wheels = vec![(0.0, start), (0.02, end), (0.0201, stays.clone()), (0.05, stays.clone())];
    let (last, instants) = over_time(wheels, 16);
    assert_goes_on(&instants[2..]);
    assert_ends_as(&last, &steady(&stays, 16), 5e-3);
}

/// One contact becomes two and one again as the wheel moves to the flange of the benchmark (where
/// its case "right, 5 mm" has two) and back: it ends in the state in which it rolls steadily there,
/// as if it had been there from the start.
#[test]
fn contacts_split_and_merge() {
    let pair = benchmark();
    // Position, yaw and roll of the benchmark's cases at 4, 5 and 6 mm, to the right.
    let at = |lateral: f64, yaw: f64, roll: f64| {
        let still = wheel(&pair, 0.0, 0.001);
        let position = Position { lateral: -1e-3 * lateral, yaw: -yaw, roll };
        let joining = Joining { distance: 5e-4, angle: 0.1 };
        WheelOnRail { side: Side::Right, position, joining, ..still }
    };
    let [inner, double] = [at(4.0, 0.0096, -0.0002), at(5.0, 0.012, -0.000_355_4)];
    let [alone, both] = [&inner, &double].map(|wheel| steady(wheel, 12));
    assert_eq!([alone.contacts.len(), both.contacts.len()], [1, 2]);
    let wheels = vec![(0.0, inner.clone()), (5e-3, double.clone()), (0.02, double)];
    let (last, _) = over_time(wheels.clone(), 12);
    assert_eq!(last.contacts.len(), 2);
    assert_ends_as(&last, &both, 5e-3);
    let back = vec![(0.025, inner.clone()), (0.04, inner)];
    let (last, instants) = over_time([wheels, back].concat(), 12);
    assert_goes_on(&instants[2..]);
    assert_ends_as(&last, &alone, 5e-3);
}

/// A march that goes on from a state is the same march, also where the motion jumps from full
/// lateral sliding to rolling straight ahead: within 1 % of μN.
#[test]
fn rolling_goes_on_where_the_motion_jumps() {
    let straight = steady(&wheel(&benchmark(), 0.0, 0.001), 16).contacts[0].problem.clone();
    let mut slides = straight.clone();
    slides.kinematics.creepage_y = -0.15;
    let rolled = |problem: &Problem, history: History, initial_state: Option<State>| {
        let transient = Transient { problem: problem.clone(), history, initial_state };
        march(&transient, &options(16), &unwatched).unwrap()
    };
    let until = |time: f64| History { time: vec![0.0, time], ..History::default() };
    let first = rolled(&slides, until(12e-3 / SPEED), None);
    let (steps, jump) = (first.history.len(), first.state.time);
    let history = History {
        time: vec![0.0, jump, jump * (1.0 + 1e-9), jump + 2e-3 / SPEED],
        creepage_y: Some(vec![-0.15, -0.15, 0.0, 0.0]),
        ..History::default()
    };
    let whole = rolled(&straight, history, None).history;
    let state = State { time: 0.0, ..first.state };
    let then = rolled(&straight, until(2e-3 / SPEED), Some(state)).history;
    assert!(then.len() > 5);
    for (found, expected) in then.iter().zip(&whole[steps..]) {
        assert_relative_eq!(found.force.y, expected.force.y, epsilon = 0.01 * 3e3);
        assert_relative_eq!(found.force.x, expected.force.x, epsilon = 0.01 * 3e3);
        assert!(found.force.y > 1e3, "{:?}", found.force);
    }
}
