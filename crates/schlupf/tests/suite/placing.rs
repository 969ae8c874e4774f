//! Where wheels and rails are: by gauge or origin, as they deviate, on both sides, in curves and on
//! rollers.

use std::sync::Arc;

use schlupf::bodies::{Body, Material, contact_modulus};
use schlupf::elasticity::HalfSpace;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::Heat;
use schlupf::normal::{Hertz, PressureSource, Radii};
use schlupf::wheel_rail::{
    Contact, Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve,
    RailPlace, RailShape, RestingWheelset, Roll, RollingRadiusDifference, RowsMove, Side, Sides,
    Support, Tangential, Track, WheelOnRail, WheelShape, WheelSolution,
};
use schlupf::{Options, Problem, Quantity, unwatched};

const STEEL: Material =
    Material { young_modulus: 2.0 * 82e9 * 1.28, poisson_ratio: 0.28, ..Body::STEEL.material };

const RADIUS: f64 = 0.46;

/// A line of a slope, or an arc of a radius (in m; negative where hollow) about its top at y = 0.
enum Shape {
    Line(f64),
    Arc(f64),
}

fn curve(shape: &Shape, quantity: Quantity) -> ProfileCurve {
    let point = |k: i32| {
        let y = 2e-4 * f64::from(k);
        match *shape {
            Shape::Line(slope) => [y, slope * y],
            Shape::Arc(radius) => [y, (radius * radius - y * y).sqrt().copysign(radius) - radius],
        }
    };
    let points: Vec<_> = (-225..=225).map(point).collect();
    ProfileCurve::new(&points, 0.0, quantity).unwrap()
}

/// A wheel whose profile has its origin 750 mm from the middle.
fn wheel_shape(shape: &Shape, nominal_radius: f64) -> WheelShape {
    WheelShape {
        profile: curve(shape, Quantity::WheelProfile).into(),
        nominal_radius,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    }
}

/// A rail whose profile has its origin there, too.
fn rail_shape(shape: &Shape) -> RailShape {
    RailShape {
        place: RailPlace::Origin([0.75, 0.0]),
        ..RailShape::new(curve(shape, Quantity::RailProfile), 0.0)
    }
}

fn pair(wheel: &WheelShape, rail: &RailShape) -> Arc<Pair> {
    Arc::new(Pair::new(wheel, rail, &Track::default()).unwrap())
}

/// A cone on an arc.
fn cone(slope: f64) -> Arc<Pair> {
    pair(&wheel_shape(&Shape::Line(slope), RADIUS), &rail_shape(&Shape::Arc(0.3)))
}

fn on(pairs: Sides<Arc<Pair>>, side: Side, support: Support) -> WheelOnRail {
    let radius = 2.0 / 0.46;
    WheelOnRail {
        pairs,
        side,
        position: Position { lateral: 0.0, yaw: 0.0, roll: 0.0 },
        motion: Motion::straight(2.0, radius),
        follows: false,
        drive: Drive::AngularVelocity,
        support,
        joining: Joining::default(),
        rows: RowsMove::WithPlane,
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 64,
    }
}

fn solve(wheel: &WheelOnRail) -> WheelSolution {
    let body = Body { material: STEEL, ..Body::STEEL };
    let builder = Problem::builder()
        .wheel(body)
        .rail(body)
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(0.3).unwrap())
        .heat(Heat::none())
        .elasticity(HalfSpace::new(&STEEL, &STEEL).unwrap());
    let interface = &builder.build().unwrap().interface;
    wheel.solve(&Tangential::new(interface, &Options::default()), &unwatched).unwrap()
}

fn close(name: &str, value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{name}: {value}, expected {expected}");
}

/// Forces over the normal force, creepages, spin in 1/m times 1 m, angle, and positions on both
/// profiles in m.
fn numbers(wheel: &WheelSolution) -> Vec<f64> {
    let contact = &wheel.contacts[0];
    let (load, force) = (contact.solution.normal.load, contact.solution.force);
    let motion = &contact.solution.kinematics;
    vec![
        force.x / load,
        force.y / load,
        motion.creepage_x,
        motion.creepage_y,
        motion.spin,
        contact.angle,
        contact.rail_position,
        contact.wheel_position,
        1e-5 * load,
    ]
}

fn same(name: &str, one: &WheelSolution, two: &WheelSolution, tolerance: f64) {
    for (k, (one, two)) in numbers(one).into_iter().zip(numbers(two)).enumerate() {
        close(&format!("{name}, number {k}"), one, two, tolerance);
    }
}

/// A rail with cant that is placed by its gauge, and the same at the origin that follows from that.
#[test]
fn a_rail_is_in_the_same_place_by_its_gauge_and_by_its_origin() {
    let wheel = wheel_shape(&Shape::Line(0.05), RADIUS);
    let by_gauge = RailShape::new(curve(&Shape::Arc(0.3), Quantity::RailProfile), 0.025);
    let gauge = pair(&wheel, &by_gauge);
    assert_eq!(gauge.gauge_depth().map(|depth| depth < 14e-3), Some(true));
    let place = RailPlace::Origin(gauge.rail_origin());
    let origin = pair(&wheel, &RailShape { place, ..by_gauge });
    assert_eq!(origin.gauge_depth(), None);
    let of = |pair| solve(&on(Sides::both(pair), Side::Left, Support::Force(8e4)));
    same("origin", &of(gauge), &of(origin), 0.0);
}

/// To which a normal contact is solved; in which place counts for its iterations.
const NORMAL: f64 = 1e-8;

/// Both rails moved by 2 mm to the left: as if the wheelset were 2 mm farther to the right. The
/// same with wheels that are moved in the wheelset, and with velocities.
#[test]
fn moved_rails_are_a_wheelset_moved_the_other_way() {
    let shapes = (wheel_shape(&Shape::Line(0.05), RADIUS), rail_shape(&Shape::Arc(0.3)));
    let moved = |way: f64, velocity: f64| Deviation {
        displacement: [0.0, way, 0.0],
        velocity: [0.0, velocity, 0.0],
        ..Deviation::default()
    };
    let [way, velocity] = [2e-3, 1e-3];
    for side in [Side::Left, Side::Right] {
        let sign = side.outwards();
        let rail = RailShape { deviation: moved(sign * way, sign * velocity), ..shapes.1.clone() };
        let wheel =
            WheelShape { deviation: moved(-sign * way, -sign * velocity), ..shapes.0.clone() };
        let support = Support::Force(8e4);
        let place = |pair| on(Sides::both(pair), side, support);
        let mut wheelset = place(pair(&shapes.0, &shapes.1));
        wheelset.position.lateral = -way;
        wheelset.motion.lateral_velocity = -velocity;
        let wheelset = solve(&wheelset);
        let rails = solve(&place(pair(&shapes.0, &rail)));
        same("rails", &rails, &wheelset, NORMAL);
        close("y", rails.contacts[0].position[1], wheelset.contacts[0].position[1] + way, 1e-12);
        same("wheels", &solve(&place(pair(&wheel, &shapes.1))), &wheelset, NORMAL);
    }
}

/// A wheelset that rolls, and one whose wheels roll about the origins of their profiles by the same
/// angle and are displaced as the roll of the wheelset displaces them.
#[test]
fn wheels_that_turn_are_a_wheelset_that_turns() {
    let (wheel, rail) = (wheel_shape(&Shape::Line(0.05), RADIUS), rail_shape(&Shape::Arc(0.3)));
    let angle = 4e-3_f64;
    let mut rolled = on(Sides::both(pair(&wheel, &rail)), Side::Left, Support::Height(-2.5585e-3));
    rolled.position.roll = angle;
    rolled.motion.roll_rate = 0.01;
    let (sin, cos) = angle.sin_cos();
    let [y, z] = [0.75, -RADIUS];
    let deviation = Deviation {
        displacement: [0.0, cos * y - sin * z - y, sin * y + cos * z - z],
        roll: angle,
        ..Deviation::default()
    };
    let bent = WheelShape { deviation, ..wheel };
    let mut straight = on(Sides::both(pair(&bent, &rail)), Side::Left, Support::Height(-2.5585e-3));
    straight.motion.roll_rate = 0.01;
    let [rolled, bent] = [rolled, straight].map(|wheel| solve(&wheel));
    let [one, two] = [&rolled.contacts[0], &bent.contacts[0]];
    close("load", one.solution.normal.load / two.solution.normal.load, 1.0, 1e-9);
    for k in 0..3 {
        close("position", one.position[k], two.position[k], 1e-12);
    }
    // The wheel that leans turns about the axle of the wheelset, which does not.
    let turning =
        |contact: &Contact| contact.solution.kinematics.spin * contact.solution.kinematics.speed;
    let inclination = -one.angle;
    let expected = 2.0 / RADIUS * ((angle - inclination).sin() + inclination.sin());
    close("spin", turning(one) - turning(two), expected, 1e-9);
}

/// Cones of different slopes on arcs: without roll each contact stays where the arc has the slope
/// of the cone, so Δr grows by tan γ₁ + tan γ₂ over the lateral position, from the difference of
/// the radii there; the equivalent conicity is the mean of the slopes, about the middle of the
/// motion.
#[test]
fn unequal_cones_by_hand() {
    let (slopes, radii) = ([0.05, 0.02], [0.4595, 0.46]);
    let [left, right] = [0, 1].map(|k| {
        let mut wheel = wheel_shape(&Shape::Line(slopes[k]), RADIUS);
        wheel.profile = wheel.profile.placed(0.0, [0.0, RADIUS - radii[k]]);
        pair(&wheel, &rail_shape(&Shape::Arc(0.3)))
    });
    let pairs = Sides { left, right };
    let found =
        RollingRadiusDifference::new(&pairs, (8e-3, 32), Roll::Neglected, &unwatched).unwrap();
    assert_eq!(found.end, None);
    assert_eq!(found.ends(), [-8e-3, 8e-3]);
    let on_wheel = |slope: f64| -0.3 * slope.atan().sin();
    let radius = |k: usize| radii[k] - slopes[k] * on_wheel(slopes[k]);
    for (lateral, difference) in found.lateral.iter().zip(&found.difference) {
        let expected = radius(0) - radius(1) + (slopes[0] + slopes[1]) * lateral;
        close("difference", *difference, expected, 2e-7);
    }
    for amplitude in [1e-3, 2e-3] {
        let conicity = found.equivalent_conicity(amplitude).unwrap().unwrap();
        close("conicity", conicity, 0.035, 1e-4);
        let conicity = found.harmonic_conicity(amplitude).unwrap().unwrap();
        close("harmonic", conicity, 0.035, 1e-4);
    }
    // At rest both wheels are at the same height, so the wheelset has rolled.
    let resting = RestingWheelset::new(&pairs, 0.0, 0.0).unwrap();
    assert!(resting.roll.abs() > 1e-5, "{}", resting.roll);
    // Mirror images of each other.
    let mirrored = Sides { left: pairs.right, right: pairs.left };
    let image = RestingWheelset::new(&mirrored, 0.0, 0.0).unwrap();
    close("roll", image.roll, -resting.roll, 1e-9);
}

/// In a curve to the left the left rail passes more slowly, v (1 − y/R), and the track turns away:
/// ξ and η differ by −y/R and x/R from those on straight track, over V/v, and φ by 1/R.
#[test]
fn rails_pass_at_different_speeds_in_a_curve() {
    let pairs = Sides::both(cone(0.05));
    for (side, radius) in [(Side::Left, 300.0), (Side::Right, 300.0), (Side::Right, -150.0)] {
        let mut wheel = on(pairs.clone(), side, Support::Force(8e4));
        wheel.position.yaw = 2e-3;
        let straight = solve(&wheel);
        wheel.motion.curve_radius = radius;
        let curved = solve(&wheel);
        let [straight, curved] = [&straight.contacts[0], &curved.contacts[0]];
        let [x, y, _] = curved.position;
        let [before, after] = [straight, curved].map(|contact| contact.solution.kinematics);
        let slip = |motion: &schlupf::bodies::Kinematics| {
            [motion.creepage_x, motion.creepage_y, motion.spin].map(|part| part * motion.speed)
        };
        let [before, after] = [slip(&before), slip(&after)];
        let (_, cos) = curved.angle.sin_cos();
        close("x", after[0] - before[0], -2.0 * y / radius, 1e-6);
        close("y", after[1] - before[1], 2.0 * x / radius * cos, 1e-6);
        close("spin", after[2] - before[2], 2.0 / radius * cos, 1e-5);
    }
}

/// A wheelset on rollers runs in no curve.
#[test]
fn rollers_have_no_curve() {
    let roller = RailShape { radius: 0.5, ..rail_shape(&Shape::Arc(0.3)) };
    let pairs = Sides::both(pair(&wheel_shape(&Shape::Arc(-0.4), RADIUS), &roller));
    let mut wheel = on(pairs, Side::Left, Support::Force(5e4));
    assert!(wheel.check().is_ok());
    wheel.motion.curve_radius = 300.0;
    assert_eq!(wheel.check().unwrap_err().code(), "rollers-in-curve");
}

/// A wheel with an arc across on a roller: Hertz's contact with 1/R = 1/R_w + 1/R_r. A large roller
/// is a straight rail.
#[test]
fn hertz_1882_on_rollers() {
    let load = 5e4;
    let (wheel, arc) = (wheel_shape(&Shape::Arc(-0.4), RADIUS), Shape::Arc(0.3));
    let rolling = |radius: f64| {
        let rail = RailShape { radius, ..rail_shape(&arc) };
        solve(&on(Sides::both(pair(&wheel, &rail)), Side::Left, Support::Force(load)))
    };
    for radius in [0.2, 0.5, 2.0] {
        let found = rolling(radius);
        let normal = &found.contacts[0].solution.normal;
        let of_wheel = Radii { x: RADIUS, y: 0.4 };
        let of_roller = Radii { x: radius, y: 0.3 };
        let hertz = Hertz::new(of_wheel, of_roller, contact_modulus(&STEEL, &STEEL), load).unwrap();
        let expected = hertz.normal_contact(None).unwrap().summary;
        let peak = normal.peak_pressure / expected.peak_pressure;
        close("largest pressure", peak, 1.0, 2e-3);
        close("semi-axis", normal.semi_axis_x / expected.semi_axis_x, 1.0, 1e-2);
        let approach = normal.approach.unwrap() / expected.approach.unwrap();
        close("approach", approach, 1.0, 2e-3);
        // Circumferences at the same speed.
        let motion = found.contacts[0].solution.kinematics;
        close("speed", motion.speed, 2.0, 1e-3);
    }
    let [large, straight] = [1e4, f64::INFINITY].map(rolling);
    same("large roller", &large, &straight, 2e-4);
    close("height", large.height, straight.height, 1e-8);
}
