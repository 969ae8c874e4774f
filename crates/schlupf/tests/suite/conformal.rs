//! Contacts on the curved surface of the rail, and the tractions of wheels that change their
//! pressure.

use std::sync::Arc;

use crate::common::cells;
use approx::assert_relative_eq;
use schlupf::analysis::subsurface::SubsurfaceStress;
use schlupf::analysis::temperature_field::Side as Below;
use schlupf::bodies::{Body, Material, contact_modulus};
use schlupf::elasticity::{HalfSpace, Rigid};
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::Heat;
use schlupf::interface::{ContactLaw, Interface};
use schlupf::normal::{Hertz, PressureSource, Radii};
use schlupf::wheel_rail::{
    Along, Contact, Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve,
    RailPlace, RailShape, RowsMove, Side, Sides, Support, Tangential, Track, WheelAt, WheelOnRail,
    WheelOverTime, WheelShape, WheelSolution,
};
use schlupf::{Options, Problem, Quantity, Status, Warning, solve, unwatched};

const fn elastic(shear_modulus: f64) -> Material {
    let young_modulus = 2.0 * 1.28 * shear_modulus;
    Material { young_modulus, poisson_ratio: 0.28, ..Material::STEEL }
}

const STEEL: Material = elastic(80e9);
const ALUMINIUM: Material = elastic(25e9);

/// Of the wheel, in m.
const RADIUS: f64 = 0.42;

/// An arc of a radius (in m, negative about its lowest point) about its highest point.
fn arc(radius: f64, half_width: f64, quantity: Quantity) -> ProfileCurve {
    let point = |k: i32| {
        let y = half_width * f64::from(k) / 400.0;
        [y, (radius * radius - y * y).sqrt().copysign(radius) - radius]
    };
    let points: Vec<_> = (-400..=400).map(point).collect();
    ProfileCurve::new(&points, 0.0, quantity).unwrap()
}

fn pair(wheel: ProfileCurve, rail: ProfileCurve) -> Sides<Arc<Pair>> {
    let wheel = WheelShape {
        profile: wheel.into(),
        nominal_radius: RADIUS,
        flange_back_position: 0.0,
        deviation: Deviation::default(),
    };
    let rail = RailShape { place: RailPlace::Origin([0.68, 0.0]), ..RailShape::new(rail, 0.0) };
    Sides::both(Arc::new(Pair::new(&wheel, &rail, &Track::default()).unwrap()))
}

/// A ball of 10 mm in a groove.
fn groove(radius: f64) -> Sides<Arc<Pair>> {
    let ball = arc(-10e-3, 9.9e-3, Quantity::WheelProfile);
    pair(ball, arc(-radius, 9.9e-3, Quantity::RailProfile))
}

fn wheel(pairs: Sides<Arc<Pair>>, normal_method: NormalMethod) -> WheelOnRail {
    WheelOnRail {
        pairs,
        side: Side::Left,
        position: Position { lateral: 0.0, yaw: 0.0, roll: 0.0 },
        motion: Motion::straight(RADIUS, 1.001),
        follows: false,
        drive: Drive::AngularVelocity,
        support: Support::Force(10e3),
        joining: Joining::default(),
        rows: RowsMove::Automatic,
        friction_variation: None,
        normal_method,
        cells: 64,
    }
}

fn interface([wheel, rail]: [Material; 2]) -> Interface {
    let body = |material| Body { material, ..Body::STEEL };
    let builder = Problem::builder()
        .wheel(body(wheel))
        .rail(body(rail))
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(0.3).unwrap())
        .heat(Heat::none())
        .elasticity(HalfSpace::new(&wheel, &rail).unwrap());
    builder.build().unwrap().interface
}

fn solved(wheel: &WheelOnRail) -> WheelSolution {
    let (interface, options) = (interface([STEEL; 2]), cells(40));
    let found = wheel.solve(&Tangential::new(&interface, &options), &unwatched).unwrap();
    assert_eq!(found.status(), Status::Converged);
    assert!(found.warnings().is_empty(), "{:?}", found.warnings());
    found
}

/// A ball of 10 mm that rolls freely in grooves (Li 2002) under 10 kN, with the influence functions
/// of Blanco-Lorenzo et al. 2016: the largest pressure, the approach, the integral of the pressure
/// and ω R/v0 of CONTACT (grid of 0.1 × 0.25 mm, whose slip is that of the undeformed wheel).
/// Planes have 25 % more pressure in the closest groove.
#[test]
fn blanco_lorenzo_2016_balls_in_grooves() {
    for (groove_radius, [pressure, approach, load, turning]) in [
        (10.25e-3, [520.6e6, 22.37e-6, 9956.0, 1.000_236_6]),
        (10.10e-3, [397.6e6, 19.28e-6, 9967.0, 1.000_466_7]),
        (10.05e-3, [336.1e6, 17.18e-6, 10_050.0, 1.000_697_5]),
        (10.02e-3, [283.6e6, 14.93e-6, 10_340.0, 1.001_074_4]),
    ] {
        let ball = wheel(groove(groove_radius), NormalMethod::Conformal);
        let drive = Drive::Force { force: 0.0, along: Along::Track };
        let found = solved(&WheelOnRail { drive, ..ball });
        let normal = &found.contacts[0].solution.normal;
        assert_relative_eq!(normal.peak_pressure, pressure, max_relative = 5e-3);
        assert_relative_eq!(normal.approach.unwrap(), approach, max_relative = 1.1e-2);
        assert_relative_eq!(normal.load, load, max_relative = 1e-3);
        assert_relative_eq!(found.angular_velocity, turning, epsilon = 5e-5);
        assert_relative_eq!(found.force[2], 10e3, max_relative = 1e-4);
        assert!(found.force[0].abs() < 1.0 && found.force[1].abs() < 1.0, "{:?}", found.force);
    }
}

/// Over time a contact on a curved surface grows into that of steady rolling.
#[test]
fn rolling_in_a_groove_becomes_steady() {
    let ball = wheel(groove(10.1e-3), NormalMethod::Conformal);
    let (interface, options) = (interface([STEEL; 2]), cells(16));
    let tangential = Tangential::new(&interface, &options);
    let steady = ball.solve(&tangential, &unwatched).unwrap();
    let at = |time: f64| WheelAt { time, wheel: ball.clone() };
    let instants = vec![at(0.0), at(0.06)];
    let history =
        WheelOverTime { instants, starts_rolling: false, rests: false, shift_duration: 0.0 };
    let (last, _) = history.march(&tangential, &unwatched).unwrap();
    assert_eq!(last.status(), Status::Converged);
    for k in 0..3 {
        assert_relative_eq!(last.force[k], steady.force[k], epsilon = 5e-3 * 3e3);
    }
    let [found, expected] = [&last, &steady].map(|wheel| &wheel.contacts[0].solution.normal);
    assert_relative_eq!(found.peak_pressure, expected.peak_pressure, max_relative = 5e-3);
}

/// Where the surface hardly turns, it is a plane.
#[test]
fn contacts_that_hardly_turn_are_plane() {
    let pairs = || {
        let round = arc(-0.5, 40e-3, Quantity::WheelProfile);
        pair(round, arc(0.3, 40e-3, Quantity::RailProfile))
    };
    let [curved, plane] = [NormalMethod::Conformal, NormalMethod::HalfSpaces]
        .map(|method| solved(&wheel(pairs(), method)).contacts.remove(0).solution);
    assert_relative_eq!(curved.force.x, plane.force.x, max_relative = 2e-3);
    let pressure = [curved, plane].map(|solution| solution.normal.peak_pressure);
    assert_relative_eq!(pressure[0], pressure[1], max_relative = 2e-3);
}

/// Left and right are mirror images, with lateral creepage, too; what carries is what is asked for.
#[test]
fn curved_contacts_of_both_sides_are_mirror_images() {
    let sides = [Side::Left, Side::Right].map(|side| {
        let ball = wheel(groove(10.1e-3), NormalMethod::Conformal);
        let outwards = if side == Side::Left { 1.0 } else { -1.0 };
        let motion = Motion { lateral_velocity: 1e-3 * outwards, ..ball.motion };
        let position = Position { lateral: 1e-5 * outwards, ..ball.position };
        solved(&WheelOnRail { side, motion, position, ..ball })
    });
    let [left, right] = &sides;
    for side in &sides {
        assert_relative_eq!(side.force[2], 10e3, max_relative = 1e-4);
    }
    assert!(left.force[1].abs() > 500.0, "{:?}", left.force);
    assert_relative_eq!(left.force[1], -right.force[1], max_relative = 1e-6);
    assert_relative_eq!(left.force[0], right.force[0], max_relative = 1e-6);
    let middle = |side: &WheelSolution| side.contacts[0].position[1].abs();
    assert_relative_eq!(middle(left), middle(right), max_relative = 1e-9);
}

/// What drives a wheel on a curved surface is the resultant of tractions where they are: with
/// lateral creepage in a groove over the vertical force, and about the axle.
#[test]
fn forces_that_turn_a_wheel_are_those_along_the_surface() {
    let radius = 10.1e-3;
    let ball = wheel(groove(radius), NormalMethod::Conformal);
    let motion = Motion { lateral_velocity: 1e-3, ..ball.motion };
    let driven = |drive: Drive| solved(&WheelOnRail { drive, motion, ..ball.clone() });
    let braked = driven(Drive::OverLoad(0.1));
    assert_relative_eq!(-braked.force[0] / braked.force[2], 0.1, max_relative = 1e-5);
    // The lateral force turns with the surface.
    let contact = &braked.contacts[0];
    let [normal, across] = [contact.solution.normal.load, contact.solution.force.y];
    let plane = normal * contact.angle.cos() - across * contact.angle.sin();
    assert!((plane / braked.force[2] - 1.0).abs() > 1e-3, "{plane} {:?}", braked.force);
    let torque = 300.0;
    let found = driven(Drive::Torque(torque));
    let contact = &found.contacts[0];
    let fields = &contact.solution.fields;
    let [x0, y0] = contact.solution.normal.origin.unwrap();
    let middle = ((contact.position[1] - 0.68) / radius).asin();
    let sum: f64 = (0..fields.x.len())
        .map(|k| {
            let angle = middle + (fields.y[k] + y0) / radius;
            let below = RADIUS + found.height - radius * (1.0 - angle.cos());
            let x = contact.position[0] + x0 + fields.x[k];
            fields.traction_x[k] * below + fields.traction_y[k] * angle.sin() * x
        })
        .sum();
    let sum = sum * fields.grid.cell_area();
    assert_relative_eq!(sum, torque, max_relative = 1e-4);
}

/// Profiles of constant curvature are Hertz's bodies: steel on aluminium has the pressure and the
/// forces of these, each found with the other.
#[test]
fn unlike_wheels_and_rails_are_those_of_hertz() {
    let materials = [STEEL, ALUMINIUM];
    let (interface, options) = (interface(materials), cells(40));
    let round = arc(-0.6, 40e-3, Quantity::WheelProfile);
    let pairs = pair(round, arc(0.3, 40e-3, Quantity::RailProfile));
    let wheel = wheel(pairs, NormalMethod::HalfSpaces);
    let found = wheel.solve(&Tangential::new(&interface, &options), &unwatched).unwrap();
    let solution = &found.contacts[0].solution;
    assert!(solution.warnings.is_empty(), "{:?}", solution.warnings);
    let radii = [Radii { x: RADIUS, y: 0.6 }, Radii { x: f64::INFINITY, y: 0.3 }];
    let modulus = contact_modulus(&materials[0], &materials[1]);
    let hertz = Hertz::new(radii[0], radii[1], modulus, solution.normal.load).unwrap();
    let without = hertz.normal_contact(None).unwrap().summary.peak_pressure;
    let problem = Problem::builder()
        .wheel(interface.wheel)
        .rail(interface.rail)
        .normal(hertz)
        .elasticity(HalfSpace::new(&materials[0], &materials[1]).unwrap())
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(0.3).unwrap())
        .heat(Heat::none())
        .kinematics(solution.kinematics)
        .build()
        .unwrap();
    let expected = solve(&problem, &options, &unwatched).unwrap();
    let change = expected.normal.peak_pressure / without - 1.0;
    assert!(change.abs() > 2e-3, "the pressure hardly changes: {change}");
    assert_relative_eq!(solution.force.x, expected.force.x, max_relative = 5e-3);
    let [found, expected] = [solution, &expected].map(|solution| solution.normal.peak_pressure);
    assert_relative_eq!(found, expected, max_relative = 0.5 * change.abs());
}

/// The lightest contacts are those of Hertz, too: down to 1 µN, on a patch of 2 µm.
#[test]
fn loads_of_any_size_are_those_of_hertz() {
    let (interface, options) = (interface([STEEL; 2]), cells(20));
    let round = arc(-0.6, 40e-3, Quantity::WheelProfile);
    let wheel =
        wheel(pair(round, arc(0.3, 40e-3, Quantity::RailProfile)), NormalMethod::HalfSpaces);
    for load in [1.0, 1e-3, 1e-6] {
        // Off the middle, so that first touch is between two points of the profile.
        let position = Position { lateral: 3.3e-3, yaw: 1e-3, ..wheel.position };
        let wheel = WheelOnRail { support: Support::Force(load), position, ..wheel.clone() };
        let found = wheel.solve(&Tangential::new(&interface, &options), &unwatched).unwrap();
        assert_eq!(found.status(), Status::Converged);
        let normal = &found.contacts[0].solution.normal;
        let radii = [Radii { x: RADIUS, y: 0.6 }, Radii { x: f64::INFINITY, y: 0.3 }];
        let modulus = contact_modulus(&STEEL, &STEEL);
        let hertz = Hertz::new(radii[0], radii[1], modulus, normal.load).unwrap();
        let hertz = hertz.normal_contact(None).unwrap().summary;
        assert_relative_eq!(normal.peak_pressure, hertz.peak_pressure, max_relative = 5e-3);
        let [found, expected] = [normal, &hertz].map(|of| of.approach.unwrap());
        assert_relative_eq!(found, expected, max_relative = 5e-3);
    }
}

/// With derivatives, too, which solve each contact once more, a pressure that does not settle is
/// told, and one that does is said to be neglected in the derivatives only.
#[test]
#[ignore = "long: cargo xtask long"]
fn derivatives_keep_what_is_said_of_the_pressure() {
    let soft = Material { young_modulus: 1e9, poisson_ratio: 0.0, ..STEEL };
    let round = arc(-0.6, 40e-3, Quantity::WheelProfile);
    let pairs = pair(round, arc(0.3, 40e-3, Quantity::RailProfile));
    let options = Options { sensitivity: true, ..cells(20) };
    for (friction, status) in [(0.3, Status::Converged), (5.0, Status::NotConverged)] {
        let mut interface = interface([soft, STEEL]);
        interface.friction.law = Arc::new(Constant::new(friction).unwrap());
        let wheel = wheel(pairs.clone(), NormalMethod::HalfSpaces);
        let motion = Motion { angular_velocity: 0.9, ..wheel.motion };
        let wheel = WheelOnRail { support: Support::Force(1e3), motion, ..wheel };
        let found = wheel.solve(&Tangential::new(&interface, &options), &unwatched).unwrap();
        let solution = &found.contacts[0].solution;
        assert_eq!(found.status(), status, "{:?}", solution.warnings);
        let neglected = |warning: &Warning| {
            matches!(warning, Warning::UnchangedPressure { in_derivatives: false, .. })
        };
        assert!(!solution.warnings.iter().any(neglected), "{:?}", solution.warnings);
    }
}

/// Where a gauge corner of 13 mm meets a crown of 80 mm, the curvature varies over the contact:
/// said with the angle that the mean is off. Stresses below curved surfaces are refused.
#[test]
fn varying_curvature_is_told() {
    let profile = |[crown, corner]: [f64; 2], quantity| {
        let (step, mut points) = (5e-5, vec![]);
        for [radius, end] in [[crown, -20e-3], [corner, 10e-3]] {
            let count = (end / step).abs() as i32;
            points.extend((0..=count).map(|k| {
                let angle = step * f64::from(k).copysign(end) / radius;
                [radius * angle.sin(), radius * (angle.cos() - 1.0)]
            }));
        }
        points.sort_by(|one, two| one[0].total_cmp(&two[0]));
        points.dedup_by_key(|point| point[0]);
        ProfileCurve::new(&points, 0.0, quantity).unwrap()
    };
    let wheel_profile = profile([84e-3, 13.1e-3], Quantity::WheelProfile);
    let pairs = pair(wheel_profile, profile([80e-3, 13e-3], Quantity::RailProfile));
    let wheel = wheel(pairs, NormalMethod::Conformal);
    let wheel = WheelOnRail { support: Support::Force(30e3), ..wheel };
    let (interface, options) = (interface([STEEL; 2]), cells(20));
    let found = wheel.solve(&Tangential::new(&interface, &options), &unwatched).unwrap();
    let warnings = found.warnings();
    let [Warning::UnevenCurvature { angle, curvature }] = warnings[..] else {
        panic!("{warnings:?}");
    };
    let turn = found.contacts[0].turn;
    assert!(angle > 0.1 && angle < 0.5 * turn, "{angle} of {turn}");
    assert!(curvature > 1.0 / 80e-3 && curvature < 1.0 / 13e-3, "{curvature}");
    let Contact { problem, solution, .. } = &found.contacts[0];
    let error = SubsurfaceStress::new(problem, solution, Below::Rail).map(drop).unwrap_err();
    assert_eq!(error.code(), "curved-below");
}

/// Only half-spaces can be bent.
#[test]
fn other_elasticities_have_no_curved_surface() {
    let ball = wheel(groove(10.1e-3), NormalMethod::Conformal);
    let interface = Interface { elasticity: Arc::new(Rigid), ..interface([STEEL; 2]) };
    let error = ball.solve(&Tangential::new(&interface, &cells(20)), &unwatched).unwrap_err();
    assert_eq!(error.code(), "no-curved-surface");
}
