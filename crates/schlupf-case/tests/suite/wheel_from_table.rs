//! Wheels from tables of contacts beside exact ones, and beside what people use.

use std::sync::Arc;
use std::time::{Duration, Instant};

use schlupf::bodies::{Body, Material};
use schlupf::elasticity::HalfSpace;
use schlupf::element::{Element, Settings, WheelParts};
use schlupf::interface::friction::Constant;
use schlupf::interface::{ContactLaw, Interface};
use schlupf::problem::{Brush, FastMethod, Method, TractionBound};
use schlupf::wheel_rail::{
    ContactTable, ContactTableOptions, Deviation, Drive, Joining, Motion, NormalMethod, Pair,
    Position, ProfileCurve, RailShape, RowsMove, Side, Sides, Support, Tangential, Track,
    WheelOnRail, WheelShape,
};
use schlupf::{Options, Problem, Quantity, unwatched};
use schlupf_case::look_up_table::standard;

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
    let builder = builder.elasticity(elasticity).contact_law(ContactLaw::Coulomb);
    builder.friction(Constant::new(0.3).unwrap()).build().unwrap().interface
}

/// Uniform numbers between 0 and 1 (Knuth's generator).
struct Random(u64);

impl Random {
    fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A pose and a motion of a wheelset.
fn random_wheel(random: &mut Random, pair: &Arc<Pair>) -> WheelOnRail {
    let speed = 30.0;
    let position = Position {
        lateral: random.between([-8e-3, 8e-3]),
        yaw: random.between([-8e-3, 8e-3]),
        roll: random.between([-5e-3, 5e-3]),
    };
    let turning = speed / 0.46 * (1.0 + random.between([-4e-3, 4e-3]));
    let motion = Motion {
        lateral_velocity: speed * random.between([-4e-3, 4e-3]),
        yaw_rate: random.between([-0.3, 0.3]),
        ..Motion::straight(speed, turning)
    };
    WheelOnRail {
        pairs: Sides::both(Arc::clone(pair)),
        side: Side::Left,
        position,
        motion,
        follows: false,
        drive: Drive::AngularVelocity,
        support: Support::Force(random.between([20e3, 120e3])),
        joining: Joining::default(),
        rows: RowsMove::WithPlane,
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 48,
    }
}

/// Those of an element for a wheel at a height (in m), from those at its start.
fn inputs(wheel: &WheelOnRail, height: f64, mut inputs: Vec<f64>) -> Vec<f64> {
    let Position { lateral, yaw, roll } = wheel.position;
    let Motion { speed, lateral_velocity, angular_velocity, yaw_rate, .. } = wheel.motion;
    let pose = [lateral, height, roll, yaw];
    let motion = [speed, lateral_velocity, 0.0, 0.0, angular_velocity, yaw_rate];
    inputs[..10].copy_from_slice(&[&pose[..], &motion[..]].concat());
    inputs
}

/// What wheels from a table are worth beside exact ones, and beside virtual penetration with
/// FASTSIM, which people use: errors of the force in the track over the friction limit, and of the
/// vertical force over itself, at the same height. Tangential forces of the table are those of
/// the ellipse with the second moments of the pressure, by the standard table.
#[test]
#[ignore = "long: cargo xtask long"]
fn wheels_from_tables_beside_exact_ones_and_virtual_penetration() {
    let (pair, interface) = (pair(), interface());
    let own = (interface.contact_modulus(), Joining::default());
    let options = ContactTableOptions { poses: 10_000, ..ContactTableOptions::default() };
    let (table, errors) = ContactTable::build(&pair, own, &options, &unwatched).unwrap();
    let axes = table.nodes().axes.map(|axis| axis.count);
    println!("nodes {axes:?}\n{errors:#?}");
    assert!(errors.load.ninety_percent < 0.01, "{errors:?}");
    assert!(errors.place.ninety_nine_percent < 50e-6, "{errors:?}");
    let parts = WheelParts {
        table: Arc::new(table),
        side: Side::Left,
        pose: [0.0; 4],
        motion: Motion::straight(30.0, 30.0 / 0.46),
        interface: &interface,
    };
    let method = Method::Fast(FastMethod::Table(Arc::clone(&standard().unwrap().table)));
    let mut element = Element::of_wheel(parts, &method, Settings::default()).unwrap();
    let mut found = element.evaluation_without_derivatives();
    let options = Options::default();
    let full = Tangential::new(&interface, &options);
    let fastsim = Method::Fast(FastMethod::Fastsim(Brush {
        bound: TractionBound::Elliptic,
        ..Brush::KALKER
    }));
    let simplified = Tangential { method: &fastsim, ..Tangential::new(&interface, &options) };
    let mut random = Random(11);
    let mut rows = [Vec::new(), Vec::new()];
    let mut loads = [Vec::new(), Vec::new()];
    let mut times = [Duration::ZERO; 2];
    for _ in 0..200 {
        let wheel = random_wheel(&mut random, &pair);
        let Ok(exact) = wheel.solve(&full, &unwatched) else { continue };
        let at_height = |normal_method| WheelOnRail {
            support: Support::Height(exact.height),
            normal_method,
            ..wheel.clone()
        };
        let start = Instant::now();
        let other = at_height(NormalMethod::KikPiotrowski).solve(&simplified, &unwatched);
        times[1] += start.elapsed();
        let Ok(other) = other else { continue };
        let inputs = inputs(&wheel, exact.height, element.start());
        let start = Instant::now();
        element.evaluate(&inputs, &[], &mut found);
        times[0] += start.elapsed();
        let limit = 0.3 * exact.contacts.iter().map(|c| c.solution.normal.load).sum::<f64>();
        for (k, force) in [&found.outputs[..3], &other.force[..]].into_iter().enumerate() {
            let off = [0, 1].map(|axis| force[axis] - exact.force[axis]);
            rows[k].push(off[0].hypot(off[1]) / limit);
            loads[k].push((force[2] / exact.force[2] - 1.0).abs());
        }
    }
    let quantile = |all: &[f64], part: f64| {
        let mut all = all.to_vec();
        all.sort_by(f64::total_cmp);
        all[((all.len() - 1) as f64 * part) as usize]
    };
    let count = rows[0].len();
    for (name, k) in [("table", 0), ("virtual penetration and FASTSIM", 1)] {
        let of =
            |all: &[f64]| [0.5, 0.75, 0.9, 1.0].map(|part| format!("{:.4}", quantile(all, part)));
        let good = rows[k].iter().filter(|error| **error <= 0.02).count();
        println!(
            "{name}: force {:?}, load {:?}, {good} of {count} within 2 %, {:?} a wheel",
            of(&rows[k]),
            of(&loads[k]),
            times[k] / count as u32,
        );
    }
    assert!(count > 150);
    assert!(quantile(&rows[0], 0.5) < 0.003 && quantile(&rows[0], 0.75) < 0.02);
    assert!(quantile(&loads[0], 0.5) < 0.001 && quantile(&loads[0], 0.9) < 0.02);
    for part in [0.5, 0.9, 1.0] {
        assert!(quantile(&rows[0], part) < quantile(&rows[1], part), "{part}");
        assert!(quantile(&loads[0], part) < quantile(&loads[1], part), "{part}");
    }
}
