//! The rigid slip of the rows of a contact between a wheel and a rail, against the rigid motion of
//! points on the surfaces that are found by trial.
//!
//! The independent computation knows of the wheel only the radius of its surface over y, of the
//! rail only its height: in a row s of the contact's plane the wheel is the lowest point, by golden
//! section over x, of the roots n of hypot(Q_x, Q_z) = r(Q_y) on the line along the plane's normal,
//! and the rail the root of its height on the same line. Slopes are central differences. The motion
//! of a point is that of the wheelset, whose attitude is written down here once more.

use std::sync::Arc;

use schlupf::elasticity::Rigid;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::Heat;
use schlupf::reporting::Error;
use schlupf::wheel_rail::{
    Contact, Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve,
    RailShape, RowsMove, Side, Sides, Support, Tangential, Track, WheelOnRail, WheelShape,
    WheelSolution,
};
use schlupf::{Options, Problem, Quantity, unwatched};

const NOMINAL: f64 = 0.46;

fn solve(wheel: &WheelOnRail) -> Result<WheelSolution, Error> {
    let builder = Problem::builder().friction(Constant::new(0.3)?).heat(Heat::none());
    let interface = &builder.elasticity(Rigid).build()?.interface;
    let options = &Options { cells_x: 12, cells_y: 12, ..Options::default() };
    wheel.solve(&Tangential::new(interface, options), &unwatched)
}

/// Radius of the wheel and height of the rail over y, both outwards in the coordinates of their
/// profiles; in m.
struct Shapes<'a> {
    radius: &'a dyn Fn(f64) -> f64,
    rail: &'a dyn Fn(f64) -> f64,
}

/// A wheel, seen from the left, and a contact of it.
struct Scene<'a> {
    shapes: Shapes<'a>,
    pair: &'a Pair,
    /// Origin of the rail's profile in the track, y and z in m.
    rail_origin: [f64; 2],
    axle: [f64; 3],
    attitude: [[f64; 3]; 3],
    origin: [f64; 3],
    inclination: f64,
}

fn dot(v: [f64; 3], w: [f64; 3]) -> f64 {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

fn product(one: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| one[i][k] * other[k][j]).sum()))
}

/// A root between two ends of a function that changes its sign, by bisection.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let rises = f(high) > f(low);
    assert!((f(low) > 0.0) != (f(high) > 0.0));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == rises { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

impl Scene<'_> {
    fn point(&self, x: f64, s: f64, n: f64) -> [f64; 3] {
        let (sin, cos) = self.inclination.sin_cos();
        let [x0, y0, z0] = self.origin;
        [x0 + x, y0 + s * cos - n * sin, z0 + s * sin + n * cos]
    }

    /// Lowest height of the wheel in a row, in m.
    fn wheel(&self, s: f64) -> f64 {
        let height = |x: f64| {
            let off = |n: f64| {
                let place = self.point(x, s, n);
                let arm = [0, 1, 2].map(|k| place[k] - self.axle[k]);
                let q: [f64; 3] =
                    [0, 1, 2].map(|k| (0..3).map(|j| self.attitude[j][k] * arm[j]).sum());
                q[0].hypot(q[2]) - (self.shapes.radius)(q[1] - self.pair.wheel_offset())
            };
            root(-3e-3, 3e-3, off)
        };
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut from, mut to) = (-8e-3, 8e-3);
        while to - from > 1e-6 {
            let [one, two] = [to - golden * (to - from), from + golden * (to - from)];
            if height(one) < height(two) { to = two } else { from = one }
        }
        height(0.5 * (from + to))
    }

    fn rail(&self, s: f64) -> f64 {
        let off = |n: f64| {
            let [_, y, z] = self.point(0.0, s, n);
            z - self.rail_origin[1] - (self.shapes.rail)(y - self.rail_origin[0])
        };
        root(-3e-3, 3e-3, off)
    }

    fn interface(&self, s: f64) -> f64 {
        0.5 * (self.wheel(s) + self.rail(s))
    }
}

/// Compares the rows of a contact with the rigid motion: longitudinal and lateral creepage to
/// 1e-9, spin over the half-width of the contact, too.
fn compare(name: &str, wheel: &WheelOnRail, shapes: Shapes, rail_origin: [f64; 2]) -> Contact {
    let solution = solve(wheel).unwrap();
    let contact = &solution.contacts[0];
    // A right wheel is the mirror image of a left one.
    let sign = wheel.side.outwards();
    let Position { lateral, yaw, roll } = wheel.position;
    let [(sin_roll, cos_roll), (sin_yaw, cos_yaw)] = [sign * roll, sign * yaw].map(f64::sin_cos);
    let roll = [[1.0, 0.0, 0.0], [0.0, cos_roll, -sin_roll], [0.0, sin_roll, cos_roll]];
    let yaw = [[cos_yaw, -sin_yaw, 0.0], [sin_yaw, cos_yaw, 0.0], [0.0, 0.0, 1.0]];
    let attitude = product(roll, yaw);
    let [x, y, z] = contact.position;
    let scene = Scene {
        shapes,
        pair: wheel.pair(),
        rail_origin,
        axle: [0.0, sign * lateral, NOMINAL + solution.height],
        attitude,
        origin: [x, sign * y, z],
        inclination: -sign * contact.angle,
    };
    let motion = &wheel.motion;
    let turning = [sign * motion.roll_rate, motion.angular_velocity, sign * motion.yaw_rate];
    let turning = attitude.map(|row| dot(row, turning));
    let moved = [motion.speed, sign * motion.lateral_velocity, motion.vertical_velocity];
    let velocity = |place: [f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|k| place[k] - scene.axle[k]);
        let [p, q, r] = turning;
        [moved[0] + q * z - r * y, moved[1] + r * x - p * z, moved[2] + p * y - q * x]
    };
    let normal = contact.problem.normal.normal_contact(None).unwrap();
    let [_, middle] = normal.summary.origin.unwrap();
    let [x0, _] = normal.summary.origin.unwrap();
    let (plane, rows) = (&contact.solution.kinematics, normal.rows.unwrap());
    // The point Q of the wheel that Kalker's creepages are of: the interface goes through it.
    let depth = contact.solution.normal.approach.unwrap();
    let at_origin = scene.interface(0.0);
    let half_width = contact.solution.normal.semi_axis_y;
    let mut largest = [0.0_f64; 3];
    for (y, row) in rows.nodes().step_by(11) {
        let s = sign * (y + middle);
        let n = scene.interface(s);
        let step = 2e-5;
        let [f, g, p, q] = [2.0, 1.0, -1.0, -2.0].map(|k| scene.interface(s + k * step));
        let slope = (8.0 * (g - p) - (f - q)) / (12.0 * step);
        let turned = scene.inclination + slope.atan();
        let (sin, cos) = turned.sin_cos();
        let v = velocity(scene.point(0.0, s, n - at_origin - depth));
        let expected = [
            v[0] / plane.speed - (plane.creepage_x - plane.spin * sign * s),
            sign * (v[1] * cos + v[2] * sin) / plane.speed - plane.creepage_y,
            sign * (turning[2] * cos - turning[1] * sin) / plane.speed - plane.spin,
        ];
        // The table is in the frame of the patch, whose x begins at x0.
        let found = [row.creepage_x, row.creepage_y - row.spin * x0, row.spin];
        for c in 0..3 {
            let off = (found[c] - expected[c]).abs() * if c == 2 { half_width } else { 1.0 };
            largest[c] = largest[c].max(expected[c].abs());
            assert!(
                off < 1e-9,
                "{name}, y = {y}, part {c}: {} {}, {off:.1e}",
                found[c],
                expected[c]
            );
        }
    }
    println!("{name}: turns by {:.3} rad, largest {largest:?}", contact.turn);
    contact.clone()
}

fn shape(points: impl Iterator<Item = [f64; 2]>, quantity: Quantity) -> ProfileCurve {
    ProfileCurve::new(&points.collect::<Vec<_>>(), 0.0, quantity).unwrap()
}

/// Everything that a wheelset can do.
fn motion() -> Motion {
    Motion {
        speed: 20.0,
        lateral_velocity: 0.15,
        vertical_velocity: -0.02,
        angular_velocity: 20.0 / NOMINAL,
        roll_rate: 0.03,
        yaw_rate: -0.05,
        curve_radius: f64::INFINITY,
    }
}

/// A wheel on an arc of a radius (in m) whose top is 750 mm from the middle of the track.
fn on_arc(profile: ProfileCurve, radius: f64, side: Side, position: Position) -> WheelOnRail {
    let wheel = WheelShape {
        profile: profile.into(),
        nominal_radius: NOMINAL,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let angle = 0.036 / radius;
    let points = (-400..=400).map(|k| {
        let angle = angle * f64::from(k) / 400.0;
        [radius * angle.sin(), radius * (angle.cos() - 1.0)]
    });
    let rail = RailShape::new(shape(points, Quantity::RailProfile), 0.0);
    let track = Track { gauge: 1.5 - 2.0 * radius * angle.sin(), ..Track::default() };
    WheelOnRail {
        pairs: Sides::both(Arc::new(Pair::new(&wheel, &rail, &track).unwrap())),
        side,
        position,
        motion: motion(),
        follows: false,
        drive: Drive::AngularVelocity,
        support: Support::Force(80e3),
        joining: Joining::default(),
        rows: RowsMove::WithSurface,
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 48,
    }
}

const TURNED: Position = Position { lateral: 1e-3, yaw: 6e-3, roll: 2e-4 };

/// A cone 1:20 on an arc of 300 mm.
#[test]
fn rows_of_a_cone() {
    let line = (-350..=300).map(|k| [2e-4 * f64::from(k), 0.05 * 2e-4 * f64::from(k)]);
    let profile = shape(line, Quantity::WheelProfile);
    for side in [Side::Left, Side::Right] {
        let wheel = on_arc(profile.clone(), 0.3, side, TURNED);
        let shapes =
            Shapes { radius: &|y| NOMINAL - 0.05 * y, rail: &|y| (0.09 - y * y).sqrt() - 0.3 };
        compare("cone", &wheel, shapes, [0.75, 0.0]);
    }
}

/// A torus that is concave across with a radius of 100 mm, on an arc of 80 mm, yawed.
#[test]
fn rows_of_a_torus() {
    let arc = (-300..=300).map(|k| {
        let angle = 1e-3 * f64::from(k);
        [0.1 * angle.sin(), 0.1 * (angle.cos() - 1.0)]
    });
    let profile = shape(arc, Quantity::WheelProfile);
    for side in [Side::Left, Side::Right] {
        let wheel = on_arc(profile.clone(), 0.08, side, TURNED);
        let shapes = Shapes {
            radius: &|y| NOMINAL - (0.1_f64.powi(2) - y * y).sqrt() + 0.1,
            rail: &|y| (0.0064 - y * y).sqrt() - 0.08,
        };
        compare("torus", &wheel, shapes, [0.75, 0.0]);
    }
}

/// Points of a profile of the Manchester benchmark, y outwards and z up, in m.
fn points(name: &str) -> Vec<[f64; 2]> {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let row = |line: &str| {
        let mut numbers = line.split(',').map(|text| text.parse::<f64>().unwrap());
        [1e-3 * numbers.next().unwrap(), -1e-3 * numbers.next().unwrap()]
    };
    lines.map(row).collect()
}

/// z of a profile at a given y, on the side of an arc length on which it is; all in m.
fn height(curve: &ProfileCurve, near: f64, y: f64) -> f64 {
    let off = |arc: f64| curve.at(arc).place[0] - y;
    let step = if off(near) < 0.0 { 5e-4 } else { -5e-4 };
    let mut to = near + step;
    while (off(to) < 0.0) == (off(near) < 0.0) && (0.0..curve.length()).contains(&to) {
        to += step;
    }
    curve.at(root(near.min(to), near.max(to), off)).place[1]
}

/// The arc length (in m) at which a profile passes y (in m), by trial on its way from small y.
fn arc_at(curve: &ProfileCurve, y: f64) -> f64 {
    let steps = (curve.length() / 1e-4) as usize;
    let arcs = (0..steps).map(|k| 1e-4 * k as f64);
    arcs.min_by(|p, q| {
        let off = |arc: &f64| (curve.at(*arc).place[0] - y).abs();
        off(p).total_cmp(&off(q))
    })
    .unwrap()
}

/// S1002 on a canted UIC 60.
fn benchmark() -> Arc<Pair> {
    let profile = |name, quantity| ProfileCurve::new(&points(name), 0.0, quantity).unwrap();
    let wheel = WheelShape {
        profile: profile("profile_s1002.csv", Quantity::WheelProfile).into(),
        nominal_radius: NOMINAL,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let rail = profile("profile_uic60_canted.csv", Quantity::RailProfile);
    let rail = RailShape::new(rail, 0.0);
    Arc::new(Pair::new(&wheel, &rail, &Track::default()).unwrap())
}

/// Its right wheel, `lateral` (in m) towards its flange.
fn at(pair: &Arc<Pair>, lateral: f64, rows: RowsMove) -> WheelOnRail {
    WheelOnRail {
        pairs: Sides::both(Arc::clone(pair)),
        side: Side::Right,
        position: Position { lateral: -lateral, yaw: 4e-3, roll: -2e-4 },
        motion: motion(),
        follows: false,
        drive: Drive::AngularVelocity,
        support: Support::Force(80e3),
        joining: Joining::default(),
        rows,
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 48,
    }
}

/// S1002 on a canted UIC 60 under 80 kN: on the tread, where both conform over 20 mm, and in the
/// flange root.
#[test]
fn rows_of_s1002_in_the_flange_root() {
    let pair = benchmark();
    for (lateral, turn) in [(0.0, 0.08), (5.5e-3, 0.3), (6e-3, 0.25)] {
        let wheel = at(&pair, lateral, RowsMove::WithSurface);
        let first = solve(&wheel).unwrap().contacts[0].clone();
        let [tread, rail] = [pair.wheel(), pair.rail()].map(|of| of.uniform().unwrap());
        let on_wheel = arc_at(tread, first.wheel_position);
        let on_rail = arc_at(rail, -first.position[1]);
        let shapes = Shapes {
            radius: &|y| NOMINAL - height(tread, on_wheel, y),
            rail: &|y| height(rail, on_rail, y),
        };
        let contact = compare(&format!("S1002 at {lateral} m"), &wheel, shapes, [0.0; 2]);
        assert!(contact.turn > turn, "{lateral} {}", contact.turn);
    }
}

/// By themselves rows move with the plane where the surface turns by up to 0.2 rad, with the
/// surface from 0.3 rad on, and in between with a mean that neither jumps nor has a kink; methods
/// without rows say that they take the plane.
#[test]
fn rows_follow_the_surface_where_it_is_curved() {
    let pair = benchmark();
    let rows = |lateral, rows| {
        // At the same height, because that depends on friction.
        let height = solve(&at(&pair, lateral, RowsMove::WithPlane)).unwrap().height;
        let wheel = WheelOnRail { support: Support::Height(height), ..at(&pair, lateral, rows) };
        let contact = solve(&wheel).unwrap().contacts[0].clone();
        let rows = contact.problem.normal.normal_contact(None).unwrap().rows;
        (contact.turn, rows)
    };
    for (lateral, share) in [(0.0, Some(0.0)), (5.5e-3, Some(1.0)), (5e-3, None)] {
        let (turn, all) = rows(lateral, RowsMove::WithSurface);
        let (_, some) = rows(lateral, RowsMove::Automatic);
        assert!(rows(lateral, RowsMove::WithPlane).1.is_none());
        let place = ((turn - 0.2) / (0.3 - 0.2)).clamp(0.0, 1.0);
        let expected = place * place * (3.0 - 2.0 * place);
        assert!(share.is_none_or(|share| share == expected), "{lateral} {turn}");
        let all = all.unwrap();
        let Some(some) = some else {
            assert_eq!(share, Some(0.0));
            continue;
        };
        for ((_, one), (_, other)) in some.nodes().zip(all.nodes()) {
            assert!((one.spin - expected * other.spin).abs() < 1e-12, "{lateral}");
            assert!((one.creepage_x - expected * other.creepage_x).abs() < 1e-15, "{lateral}");
        }
    }
    let warning = |rows| {
        let solution = solve(&at(&pair, 5.5e-3, rows)).unwrap();
        solution.warnings().iter().map(ToString::to_string).collect::<String>()
    };
    assert!(warning(RowsMove::Automatic).contains("the spin follows the surface"));
    assert!(warning(RowsMove::WithPlane).contains("the plane's middle is taken for all"));
}

/// On the flange root all power of the creep forces becomes frictional heat, with the slip of every
/// row; with that of the plane alone the balance would be off.
#[test]
fn the_powers_of_a_flange_root_balance() {
    let contact =
        solve(&at(&benchmark(), 5.5e-3, RowsMove::WithSurface)).unwrap().contacts[0].clone();
    let (power, force, motion) =
        (contact.solution.power.unwrap(), contact.solution.force, contact.solution.kinematics);
    let plane = -motion.speed
        * (motion.creepage_x * force.x
            + motion.creepage_y * force.y
            + motion.spin * force.moment_z.unwrap());
    assert!((power.friction / power.creep - 1.0).abs() < 1e-6, "{power:?}");
    assert!((plane / power.creep - 1.0).abs() > 1e-3, "{plane} {power:?}");
    // Tγ at the position of the contact: its parts, signed, are the power over the speed.
    let wear = contact.solution.t_gamma;
    let [lateral, by_spin] = wear.rows;
    let x = -motion.creepage_x * force.x;
    let y = lateral - motion.creepage_y * force.y;
    let spin = by_spin - motion.spin * force.moment_z.unwrap();
    assert!(((x + y + spin) * motion.speed / power.creep - 1.0).abs() < 1e-9);
    assert!((wear.without_spin - x.abs() - y.abs()).abs() < 1e-9 * x.abs());
    assert!((wear.with_spin.unwrap() - x.abs() - y.abs() - spin.abs()).abs() < 1e-9 * x.abs());
}
