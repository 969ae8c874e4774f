//! A wheel on a rail under a longitudinal force or a torque: against CONTACT, and statics.

use std::sync::Arc;

use schlupf::bodies::{Body, Material};
use schlupf::elasticity::HalfSpace;
use schlupf::interface::friction::{Constant, Friction, Polach};
use schlupf::interface::{ContactLaw, Interface};
use schlupf::reporting::ForceError;
use schlupf::wheel_rail::{
    Along, Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve,
    RailShape, RowsMove, Side, Sides, Support, Tangential, Track, WheelOnRail, WheelShape,
    WheelSolution,
};
use schlupf::{Error, Options, Problem, Quantity, unwatched};

/// Rows of a table in the data folder, as text.
fn table(name: &str) -> Vec<Vec<String>> {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

fn curve(points: &[[f64; 2]], quantity: Quantity) -> ProfileCurve {
    ProfileCurve::new(points, 0.0, quantity).unwrap()
}

fn benchmark() -> Arc<Pair> {
    let points = |name: &str| -> Vec<[f64; 2]> {
        table(name).iter().map(|row| [1e-3 * number(&row[0]), -1e-3 * number(&row[1])]).collect()
    };
    let wheel = WheelShape {
        profile: curve(&points("profile_s1002.csv"), Quantity::WheelProfile).into(),
        nominal_radius: 0.46,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let rail = curve(&points("profile_uic60_canted.csv"), Quantity::RailProfile);
    let rail = RailShape::new(rail, 0.0);
    Arc::new(Pair::new(&wheel, &rail, &Track { gauge: 1.435, ..Track::default() }).unwrap())
}

/// A cylinder of radius 300 mm on an arc of radius 300 mm whose top is 750 mm from the middle: the
/// patch is a circle, and the wheel has no spin.
fn circle() -> Arc<Pair> {
    let line: Vec<[f64; 2]> = (-300..=300).map(|k| [2e-4 * f64::from(k), 0.0]).collect();
    let angle = |k: i32| 1e-3 * f64::from(k);
    let arc: Vec<[f64; 2]> =
        (-120..=120).map(|k| [0.3 * angle(k).sin(), 0.3 * (angle(k).cos() - 1.0)]).collect();
    let wheel = WheelShape {
        profile: curve(&line, Quantity::WheelProfile).into(),
        nominal_radius: 0.3,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let rail = RailShape::new(curve(&arc, Quantity::RailProfile), 0.0);
    let track = Track { gauge: 1.5 - 2.0 * 0.3 * 0.12_f64.sin(), ..Track::default() };
    Arc::new(Pair::new(&wheel, &rail, &track).unwrap())
}

fn wheel(pair: &Arc<Pair>, side: Side, position: Position, drive: Drive) -> WheelOnRail {
    WheelOnRail {
        pairs: Sides::both(Arc::clone(pair)),
        side,
        position,
        // Where a force turns the wheel, its angular velocity is not used.
        motion: Motion::straight(2.0, 4.0),
        follows: false,
        drive,
        support: Support::Force(10e3),
        joining: Joining::default(),
        rows: RowsMove::WithPlane,
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 64,
    }
}

/// Works with steel of a shear modulus (in Pa), a friction law, Coulomb's law and square grids.
fn solve_with<R>(
    (shear_modulus, friction): (f64, Friction),
    cells: usize,
    work: impl FnOnce(&Tangential) -> R,
) -> R {
    let material = Material {
        young_modulus: 2.0 * shear_modulus * 1.28,
        poisson_ratio: 0.28,
        ..Body::STEEL.material
    };
    let body = Body { material, ..Body::STEEL };
    let builder = Problem::builder()
        .wheel(body)
        .rail(body)
        .heat(schlupf::interface::heat::Heat::none())
        .contact_law(ContactLaw::Coulomb)
        .elasticity(HalfSpace::new(&material, &material).unwrap());
    let interface = &Interface { friction, ..builder.build().unwrap().interface };
    let options = &Options { cells_x: cells, cells_y: cells, ..Options::default() };
    work(&Tangential::new(interface, options))
}

fn constant(coefficient: f64) -> Friction {
    Friction::new(Arc::new(Constant::new(coefficient).unwrap()), 20.0)
}

fn solve(wheel: &WheelOnRail) -> Result<WheelSolution, Error> {
    solve_with((82e9, constant(0.3)), 24, |tangential| wheel.solve(tangential, &unwatched))
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: {found} instead of {expected}, off by {off:.2e}");
}

/// Shackleton and Iwnicki 2008, Manchester contact benchmark as CONTACT solves it: with its
/// longitudinal forces in place of its pitch rates, the wheels turn as they do there, within 2 %
/// of the size of the creepage, as far as the forces of the file determine it.
#[test]
fn wheels_turn_as_in_the_manchester_benchmark() {
    let pair = benchmark();
    for row in table("manchester_a22.csv") {
        let of = |k: usize| number(&row[k]);
        let name = format!("{} {}", row[0], row[1]);
        if name == "right 5.0" {
            // Two regions, joined: the file's own plane differs.
            continue;
        }
        let side = if row[0] == "left" { Side::Left } else { Side::Right };
        let position = Position { lateral: -1e-3 * of(1), yaw: -of(2), roll: of(3) };
        // Forces of the file act on the rail, along the track.
        let drive = Drive::Force { force: -of(16), along: Along::Track };
        let solution = solve(&wheel(&pair, side, position, drive)).unwrap();
        close(&name, solution.force[0], -of(16), 0.05);
        let size = of(12).hypot(of(13)) + 1e-3;
        let turning = -of(4);
        close(&name, solution.angular_velocity / turning - 1.0, 0.0, 0.02 * size);
        close(&name, solution.contacts[0].solution.kinematics.creepage_x, -of(12), 0.02 * size);
    }
}

/// CONTACT (rev. 2707), total force Fx = −0.5 μN on a circular patch without spin (a = b = 6 mm,
/// `contact_prescribed_force.csv`): the creepage over the radius of the patch is the same for all
/// circles under one largest pressure, so a wheel with R = 300 mm has it, too, with ξ ∝ p0/G.
/// Within 1 % and the flattening of a 300 mm wheel, in at most 85 products.
#[test]
fn the_creepage_of_a_circular_patch() {
    let row = &table("contact_prescribed_force.csv")[0];
    assert_eq!((row[0].as_str(), row[4].as_str()), ("F01", "Fx"));
    let expected = number(&row[12]);
    let shear_modulus = 210e9 / 2.56;
    for sign in [1.0, -1.0] {
        let drive = Drive::OverLoad(sign * 0.5 * 0.3);
        let position = Position { lateral: 0.0, yaw: 0.0, roll: 0.0 };
        let wheel = wheel(&circle(), Side::Left, position, drive);
        let law = (shear_modulus, constant(0.3));
        let solution =
            solve_with(law, 40, |tangential| wheel.solve(tangential, &unwatched)).unwrap();
        let contact = &solution.contacts[0].solution;
        close("Fx", contact.force.x, -sign * 0.15 * 10e3, 0.05);
        let scaled = expected * contact.normal.peak_pressure / 1e9;
        close("ξ", contact.kinematics.creepage_x / (sign * scaled), 1.0, 0.01);
        let products = contact.work.operator_products;
        println!("{products:.1} products");
        assert!(products < 85.0, "{products}");
    }
}

/// Statics: the torque about the axle balances the tangential forces at the rolling radius and the
/// part of the spin moments along the axle, on the tread and on the flange, both sides.
#[test]
fn torques_balance_the_tractions() {
    let pair = benchmark();
    for (side, lateral) in [(Side::Left, 0.0), (Side::Right, 0.0), (Side::Left, 7.5e-3)] {
        for torque in [-800.0, 300.0] {
            let position = Position { lateral, yaw: 0.0, roll: 0.0 };
            let found = solve(&wheel(&pair, side, position, Drive::Torque(torque))).unwrap();
            let part = |contact: &schlupf::wheel_rail::Contact| {
                let force = &contact.solution.force;
                // The normal (0, −sin δ, cos δ) has this part along the axle.
                let moment = force.moment_z.unwrap() * contact.angle.sin();
                contact.rolling_radius * force.x - moment
            };
            let balance: f64 = found.contacts.iter().map(part).sum();
            close(&format!("{side:?} {lateral} {torque}"), balance, torque, 0.05);
        }
    }
}

/// A force across the axle of a yawed wheelset has a part of the lateral force in it, by the
/// rotation of the wheelset; and a wheel whose angular velocity is the one found has the force.
#[test]
fn forces_across_the_axle() {
    let position = Position { lateral: -4e-3, yaw: -9.6e-3, roll: -2.6e-4 };
    let drive = Drive::Force { force: -700.0, along: Along::Wheelset };
    let driven = wheel(&benchmark(), Side::Left, position, drive);
    let found = solve(&driven).unwrap();
    let [x, y, z] = found.force;
    let (roll, yaw) = (position.roll, position.yaw);
    let across = x * yaw.cos() + yaw.sin() * (y * roll.cos() + z * roll.sin());
    close("across the axle", across, -700.0, 0.05);
    assert!((x + 700.0).abs() > 10.0, "{x}");
    let motion = Motion { angular_velocity: found.angular_velocity, ..driven.motion };
    let given = WheelOnRail { motion, drive: Drive::AngularVelocity, ..driven };
    let again = solve(&given).unwrap();
    close("the same force", again.force[0], x, 0.05);
    close("the same height", again.height, found.height, 1e-9);
}

/// A force on one wheel of a wheelset turns both.
#[test]
fn both_wheels_are_on_one_axle() {
    let pair = benchmark();
    let position = Position { lateral: 2e-3, yaw: 0.0, roll: 0.0 };
    for side in [Side::Left, Side::Right] {
        let drive = Drive::Force { force: -1e3, along: Along::Track };
        let driven = wheel(&pair, side, position, drive);
        let law = (82e9, constant(0.3));
        let [own, other] =
            solve_with(law, 16, |with| driven.solve_resting(with, &unwatched)).unwrap();
        assert_eq!([own.side, other.side], [side, side.other()]);
        close("force", own.force[0], -1e3, 0.05);
        assert_eq!(own.angular_velocity.to_bits(), other.angular_velocity.to_bits());
        assert!((other.force[0] + 1e3).abs() > 10.0, "{}", other.force[0]);
    }
}

/// Beyond friction the largest force is told: μN where friction is constant; where it falls, the
/// peak of the creep curve, which a scan of creepages has, too. Below it the motion is that of the
/// rising branch.
#[test]
fn forces_beyond_friction_are_told() {
    let position = Position { lateral: 0.0, yaw: 0.0, roll: 0.0 };
    let at = |drive| wheel(&circle(), Side::Left, position, drive);
    let driven = |force: f64| at(Drive::Force { force, along: Along::Track });
    let largest = |error: Error| match error {
        Error::Force {
            error: ForceError::Unreachable { quantity: Quantity::ForceX, largest, .. },
        } => largest,
        other => panic!("{other}"),
    };
    for force in [-3.2e3, 5e3] {
        let found = largest(solve(&driven(force)).unwrap_err());
        close("the largest force", found / force.signum(), 3e3, 3.0);
    }
    let falling: Friction = Friction::new(Arc::new(Polach::new(0.3, 0.4, 20.0).unwrap()), 20.0);
    let solve = |wheel: &WheelOnRail| {
        solve_with((82e9, falling.clone()), 16, |with| wheel.solve(with, &unwatched))
    };
    let scan = |creepage: f64| {
        let mut wheel = at(Drive::AngularVelocity);
        wheel.motion.angular_velocity = (1.0 - creepage) * 2.0 / 0.3;
        solve(&wheel).unwrap().force[0]
    };
    let (place, peak) = (1..=60)
        .map(|k| (1e-4 * f64::from(k), scan(1e-4 * f64::from(k))))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap();
    let found = largest(solve(&driven(-3.1e3)).unwrap_err());
    close("the peak", found, peak, 3e-3 * peak.abs());
    for part in [0.5, 0.9, 0.97] {
        let found = solve(&driven(part * peak)).unwrap();
        close("force", found.force[0], part * peak, 0.05);
        let creepage = 1.0 - found.angular_velocity * 0.3 / 2.0;
        assert!(0.0 < creepage && creepage < place, "{part}: {creepage}, peak at {place}");
    }
}

/// On an inclined contact the normal force follows friction, so the first rounds know another force
/// than the last: what a scan of angular velocities reaches is found, and the largest force that is
/// told does not depend on what was asked for.
#[test]
fn falling_friction_on_an_inclined_contact() {
    let position = Position { lateral: -6e-3, yaw: 0.0, roll: 0.0 };
    let pair = benchmark();
    let falling: Friction = Friction::new(Arc::new(Polach::new(0.3, 0.4, 20.0).unwrap()), 20.0);
    let solve = |drive: Drive, angular_velocity: f64| {
        let mut wheel = wheel(&pair, Side::Left, position, drive);
        wheel.support = Support::Force(80e3);
        wheel.motion.angular_velocity = angular_velocity;
        solve_with((82e9, falling.clone()), 16, |with| wheel.solve(with, &unwatched))
    };
    let free = 2.0 / 0.46;
    let driven = |force: f64| solve(Drive::Force { force, along: Along::Track }, free);
    let scan =
        |creepage: f64| solve(Drive::AngularVelocity, (1.0 - creepage) * free).unwrap().force[0];
    let lowest = |places: &mut dyn Iterator<Item = f64>| {
        places.map(|place| (place, scan(place))).min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    };
    let (near, _) = lowest(&mut (0..40).map(|k| 1e-3 * f64::from(k) - 5e-3));
    let (_, peak) = lowest(&mut (-10..=10).map(|k| near + 1e-4 * f64::from(k)));
    for part in [0.9, 0.97, 0.99] {
        close("force", driven(part * peak).unwrap().force[0], part * peak, 1.0);
    }
    let largest = |error: Error| match error {
        Error::Force { error: ForceError::Unreachable { largest, .. } } => largest,
        other => panic!("{other}"),
    };
    for part in [1.02, 1.1, 2.0] {
        let told = largest(driven(part * peak).unwrap_err());
        close("the largest", told, peak, 5e-3 * peak.abs());
    }
}
