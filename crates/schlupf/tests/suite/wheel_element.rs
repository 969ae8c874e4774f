//! The force element of a wheel on a rail: against exact wheels, in its derivatives, and at its
//! edges.

use std::sync::{Arc, OnceLock};

use schlupf::bodies::{Body, Material};
use schlupf::elasticity::HalfSpace;
use schlupf::element::{CONTACTS, Element, Settings, Status, WheelParts};
use schlupf::interface::Interface;
use schlupf::interface::friction::Constant;
use schlupf::problem::{AreaReduction, FastMethod, Method};
use schlupf::wheel_rail::{
    ContactTable, ContactTableErrors, ContactTableOptions, Deviation, Joining, Motion, Pair,
    ProfileCurve, RailShape, Side, Track, WheelShape,
};
use schlupf::{Problem, Quantity, unwatched};

/// Points of a profile of the Manchester benchmark, y outwards and z up, in m.
fn profile(name: &str, quantity: Quantity) -> ProfileCurve {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let point = |line: &str| {
        let (y, z) = line.split_once(',').unwrap();
        [1e-3 * y.parse::<f64>().unwrap(), -1e-3 * z.parse::<f64>().unwrap()]
    };
    ProfileCurve::new(&lines.map(point).collect::<Vec<_>>(), 0.0, quantity).unwrap()
}

fn pair() -> Arc<Pair> {
    let wheel = WheelShape {
        profile: profile("profile_s1002.csv", Quantity::WheelProfile).into(),
        nominal_radius: 0.46,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let rail = RailShape::new(profile("profile_uic60_canted.csv", Quantity::RailProfile), 0.0);
    Arc::new(Pair::new(&wheel, &rail, &Track::default()).unwrap())
}

fn interface() -> Interface {
    let elasticity = HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap();
    let builder = Problem::builder().wheel(Body::STEEL).rail(Body::STEEL);
    let builder = builder.elasticity(elasticity);
    builder.friction(Constant::new(0.3).unwrap()).build().unwrap().interface
}

/// A table for small angles, and its errors.
fn table() -> &'static (Arc<ContactTable>, ContactTableErrors) {
    static TABLE: OnceLock<(Arc<ContactTable>, ContactTableErrors)> = OnceLock::new();
    TABLE.get_or_init(|| {
        let options = ContactTableOptions {
            roll: 0.003,
            yaw: 0.006,
            tolerance: 0.02,
            most_nodes: 20_000,
            cells: 24,
            poses: 200,
            ..ContactTableOptions::default()
        };
        let own = (interface().contact_modulus(), Joining::default());
        let (table, errors) = ContactTable::build(&pair(), own, &options, &unwatched).unwrap();
        (Arc::new(table), errors)
    })
}

fn element(side: Side, method: FastMethod) -> Element {
    let motion = Motion { lateral_velocity: 0.02, ..Motion::straight(20.0, 20.0 / 0.46) };
    let parts = WheelParts {
        table: Arc::clone(&table().0),
        side,
        pose: [1e-3, -60e-6, 0.5e-3, 1e-3],
        motion,
        interface: &interface(),
    };
    Element::of_wheel(parts, &Method::Fast(method), Settings::default()).unwrap()
}

fn place(element: &Element, quantity: Quantity) -> usize {
    element.inputs().iter().position(|signal| *signal == quantity).unwrap()
}

/// Contacts of a coarse table against exact ones: where they are, at which angle, and their force.
#[test]
fn contacts_are_near_exact_ones() {
    let errors = &table().1;
    println!("{errors:?}");
    assert!(errors.poses > 150);
    assert!(errors.load.median < 2e-3 && errors.load.ninety_percent < 0.02, "{errors:?}");
    assert!(errors.place.largest < 50e-6 && errors.angle.ninety_nine_percent < 2e-3, "{errors:?}");
}

/// All derivatives against central differences, on tread and flange, on both sides.
#[test]
fn derivatives_are_those_of_differences() {
    let methods = [
        FastMethod::Polach(AreaReduction::DRY),
        FastMethod::ShenHedrickElkins,
        FastMethod::KalkerLinear,
    ];
    for method in methods {
        for (side, lateral) in [(Side::Left, 1e-3), (Side::Right, 1e-3), (Side::Right, 6.2e-3)] {
            let mut element = element(side, method.clone());
            let mut inputs = element.start();
            inputs[0] = lateral;
            let mut found = element.evaluation();
            let status = lower(&mut element, &mut inputs);
            assert_eq!(status, Status::Found);
            element.evaluate(&inputs, &[], &mut found);
            let at = found.clone();
            for (column, step) in STEPS.iter().enumerate() {
                let mut value = |by: f64| {
                    let mut moved = inputs.clone();
                    moved[column] += by;
                    element.evaluate(&moved, &[], &mut found);
                    found.outputs.clone()
                };
                let (less, more) = (value(-step), value(*step));
                for row in 0..at.outputs.len() {
                    let difference = (more[row] - less[row]) / (2.0 * step);
                    let exact = at.derivative(row, column);
                    let size = at.outputs[row].abs() / step * 2e-6 + difference.abs() * 2e-3;
                    let signal = element.outputs()[row].name();
                    assert!(
                        (difference - exact).abs() <= size + 1e-9,
                        "{signal} by {} on the {side:?} at {lateral}: {exact} {difference}",
                        element.inputs()[column].name(),
                    );
                }
            }
        }
    }
}

/// Steps of the inputs, in their units.
const STEPS: [f64; 17] = [
    1e-8, 1e-8, 1e-7, 1e-7, 1e-4, 1e-5, 1e-5, 1e-5, 1e-4, 1e-5, 1e-4, 1e-2, 1e-2, 1e-8, 1e-8, 1e-5,
    1e-5,
];

/// Lowers the wheel until it carries about 80 kN.
fn lower(element: &mut Element, inputs: &mut [f64]) -> Status {
    let mut found = element.evaluation();
    let (mut high, mut low) = (2e-3, -4e-3);
    let mut status = Status::NoContact;
    for _ in 0..40 {
        inputs[1] = 0.5 * (low + high);
        status = element.evaluate(inputs, &[], &mut found);
        let is_light = status == Status::NoContact || found.outputs[2] < 80e3;
        *(if is_light { &mut high } else { &mut low }) = inputs[1];
    }
    status
}

/// The slope of the vertical force by yaw is the same just before and after none.
#[test]
fn nothing_jumps_without_yaw() {
    let mut element = element(Side::Left, FastMethod::Polach(AreaReduction::DRY));
    let mut inputs = element.start();
    let mut found = element.evaluation();
    for lateral in [0.0, 3e-3, 6.2e-3] {
        inputs[0] = lateral;
        inputs[3] = 0.0;
        lower(&mut element, &mut inputs);
        let [less, more] = [-1e-9, 1e-9].map(|yaw| {
            inputs[3] = yaw;
            element.evaluate(&inputs, &[], &mut found);
            found.derivative(2, 3)
        });
        assert!((more - less).abs() <= 1e-4 * more.abs() + 1.0, "{lateral}: {less} {more}");
    }
}

/// A left wheel is the mirror image of a right one, and a rail that is displaced that of a
/// wheelset the other way.
#[test]
fn mirror_images_and_displaced_rails_are_the_same() {
    let method = FastMethod::Polach(AreaReduction::DRY);
    let [mut left, mut right] = [Side::Left, Side::Right].map(|side| element(side, method.clone()));
    let (mut found, mut mirrored) = (left.evaluation(), right.evaluation());
    let mut inputs = left.start();
    lower(&mut left, &mut inputs);
    left.evaluate(&inputs, &[], &mut found);
    let mut opposite = inputs.clone();
    for quantity in [
        Quantity::LateralPosition,
        Quantity::RollAngle,
        Quantity::WheelsetYaw,
        Quantity::LateralVelocity,
        Quantity::RollRate,
        Quantity::YawRate,
    ] {
        opposite[place(&left, quantity)] *= -1.0;
    }
    right.evaluate(&opposite, &[], &mut mirrored);
    for ((signal, one), two) in left.outputs().iter().zip(&found.outputs).zip(&mirrored.outputs) {
        assert!(one.abs() == two.abs(), "{}: {one} {two}", signal.name());
    }
    // Lateral force, and the angle of the first contact.
    assert_eq!(found.outputs[1], -mirrored.outputs[1]);
    assert_eq!(found.outputs[9], -mirrored.outputs[9]);
    assert!(found.outputs[9] != 0.0);
    let before = found.clone();
    inputs[0] += 1e-4;
    inputs[1] -= 2e-5;
    inputs[13] += 1e-4;
    inputs[14] -= 2e-5;
    left.evaluate(&inputs, &[], &mut found);
    for (one, two) in before.outputs.iter().zip(&found.outputs) {
        assert!((one - two).abs() <= 1e-9 * one.abs().max(1e-6), "{one} {two}");
    }
}

/// A wheel above the rail, beside it, upside down, at rest, and numbers that are none.
#[test]
fn edges_are_statuses() {
    let mut element = element(Side::Left, FastMethod::ShenHedrickElkins);
    let mut found = element.evaluation();
    let mut start = element.start();
    lower(&mut element, &mut start);
    assert_eq!(element.inputs().len(), 17);
    assert_eq!(element.outputs().len(), 7 + 16 * CONTACTS);
    let with = |place: usize, value: f64| {
        let mut inputs = start.clone();
        inputs[place] = value;
        inputs
    };
    for (place, value) in [(1, 0.01), (0, 0.5), (0, -0.5), (0, 1e6), (2, 0.9)] {
        let status = element.evaluate(&with(place, value), &[], &mut found);
        let all = || found.outputs.iter().chain(&found.derivatives);
        assert!(all().all(|value| value.is_finite()), "{place} {value}");
        if status == Status::NoContact {
            assert!(found.outputs[..6].iter().all(|force| *force == 0.0), "{place} {value}");
        } else {
            assert_eq!(status, Status::Found, "{place} {value}");
        }
    }
    let mut rest = start.clone();
    rest[4..10].fill(0.0);
    assert_eq!(element.evaluate(&rest, &[], &mut found), Status::Found);
    assert!(found.derivatives.iter().all(|slope| slope.is_finite()));
    for place in 0..start.len() {
        let status = element.evaluate(&with(place, f64::NAN), &[], &mut found);
        assert_eq!(status, Status::NotFinite);
        assert!(found.outputs.iter().all(|value| value.is_nan()));
    }
    assert_eq!(element.evaluate(&start[1..], &[], &mut found), Status::WrongSize);
    assert_eq!(element.evaluate(&start, &[0.0], &mut found), Status::WrongSize);
}
