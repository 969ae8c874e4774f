//! Profiles that change along the way, against closed expressions: a ramp, an eccentric wheel, a
//! flat, and a wheel that goes over from a wing rail to a nose.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use schlupf::bodies::{Body, Material, contact_modulus};
use schlupf::elasticity::HalfSpace;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::Heat;
use schlupf::wheel_rail::{
    Contact, Deviation, Drive, Interpolation, Joining, Motion, NormalMethod, Pair, Position,
    ProfileCurve, RailPlace, RailShape, RowsMove, Section, Sections, Side, Sides, Support, Surface,
    Tangential, Track, WheelOnRail, WheelShape, WheelSolution,
};
use schlupf::{Options, Problem, Quantity, unwatched};

const STEEL: Material = Body::STEEL.material;
const RADIUS: f64 = 0.46;
const CROWN: f64 = 0.3;
const COULOMB: f64 = 0.3;

/// A curve z(y) between two y, with points every 0.2 mm.
fn curve(z: impl Fn(f64) -> f64, [from, to]: [f64; 2], quantity: Quantity) -> ProfileCurve {
    let count = ((to - from) / 2e-4).round() as i32;
    let point = |k: i32| {
        let y = from + (to - from) * f64::from(k) / f64::from(count);
        [y, z(y)]
    };
    ProfileCurve::new(&(0..=count).map(point).collect::<Vec<_>>(), 0.0, quantity).unwrap()
}

fn crown(y: f64) -> f64 {
    (CROWN * CROWN - y * y).sqrt() - CROWN
}

const WIDTH: [f64; 2] = [-0.03, 0.03];

fn section(place: f64, curve: ProfileCurve) -> Section {
    let breaks = vec![Some(0.0), Some(curve.length())];
    Section { place, curve, breaks }
}

/// A rail of sections z(u, y) at places between two, in m.
fn rail_of(z: impl Fn(f64, f64) -> f64, [from, to]: [f64; 2], count: usize) -> Arc<Sections> {
    let sections: Vec<Section> = (0..count)
        .map(|k| from + (to - from) * k as f64 / (count - 1) as f64)
        .map(|u| section(u, curve(|y| z(u, y), WIDTH, Quantity::RailProfile)))
        .collect();
    Arc::new(Sections::new(&sections, Interpolation::Through, Quantity::RailProfile).unwrap())
}

/// A wheel with the radius r at angles between two, and a level profile.
fn wheel_of(r: impl Fn(f64) -> f64, [from, to]: [f64; 2], count: usize) -> Arc<Sections> {
    let sections: Vec<Section> = (0..count)
        .map(|k| from + (to - from) * k as f64 / (count - 1) as f64)
        .map(|u| section(u, curve(|_| RADIUS - r(u), WIDTH, Quantity::WheelProfile)))
        .collect();
    Arc::new(Sections::new(&sections, Interpolation::Through, Quantity::WheelProfile).unwrap())
}

fn round() -> Surface {
    curve(|_| 0.0, WIDTH, Quantity::WheelProfile).into()
}

fn straight() -> Surface {
    curve(crown, WIDTH, Quantity::RailProfile).into()
}

/// A left wheel in the middle of its rail.
fn on(wheel: Surface, rail: Surface, support: Support) -> WheelOnRail {
    let wheel = WheelShape {
        profile: wheel,
        nominal_radius: RADIUS,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let place = RailPlace::Origin([0.75, 0.0]);
    let rail = RailShape { place, ..RailShape::new(rail, 0.0) };
    WheelOnRail {
        pairs: Sides::both(Arc::new(Pair::new(&wheel, &rail, &Track::default()).unwrap())),
        side: Side::Left,
        position: Position { lateral: 0.0, yaw: 0.0, roll: 0.0 },
        motion: Motion::straight(10.0, 10.0 / RADIUS),
        follows: true,
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
    let builder = Problem::builder()
        .wheel(Body::STEEL)
        .rail(Body::STEEL)
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(COULOMB).unwrap())
        .heat(Heat::none())
        .elasticity(HalfSpace::new(&STEEL, &STEEL).unwrap());
    let interface = &builder.build().unwrap().interface;
    wheel.solve(&Tangential::new(interface, &Options::default()), &unwatched).unwrap()
}

fn close(name: &str, value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{name}: {value}, expected {expected}");
}

/// Sections that are equal are the prism and the body of revolution: as surfaces, and in contact.
#[test]
fn equal_sections_are_the_uniform_body() {
    let equal = rail_of(|_, y| crown(y), [-0.2, 0.2], 7);
    let rail = Surface::along(equal, 0.03);
    let wheel = Surface::around(wheel_of(|_| RADIUS, [-0.3, 0.3], 7), 0.1);
    for k in 0..50 {
        let (way, along) = (4e-3 * f64::from(k) - 0.1, 1.1e-3 * f64::from(k));
        let [one, other] = [&rail, &straight()].map(|of| of.point(way, along).unwrap());
        for c in 0..2 {
            close("place", one.place[c], other.place[c], 1e-15);
            close("tangent", one.tangent[c], other.tangent[c], 1e-13);
            close("bend", one.bend[c], other.bend[c], 1e-9);
        }
    }
    let height = Support::Height(-80e-6);
    let uniform = solve(&on(round(), straight(), height));
    let varying = solve(&on(wheel, rail, height));
    let of = |wheel: &WheelSolution| wheel.contacts[0].clone();
    let (one, other) = (of(&varying), of(&uniform));
    let relative = |name: &str, one: f64, other: f64| close(name, one / other, 1.0, 2e-5);
    relative("load", one.solution.normal.load, other.solution.normal.load);
    relative("peak", one.solution.normal.peak_pressure, other.solution.normal.peak_pressure);
    let share = |contact: &Contact| contact.solution.force.x / contact.solution.normal.load;
    close("force", share(&one), share(&other), 1e-5);
    close("x", one.position[0], other.position[0], 1e-9);
}

/// A rail that rises by 1 in 20: the wheel rests on an inclined plane, of which the normal and the
/// force lean back. It slides at V/cos θ − ωR there.
#[test]
fn a_ramp_is_an_inclined_plane() {
    let angle = 0.05_f64.atan();
    let ramp = Surface::along(rail_of(|u, y| crown(y) + 0.05 * u, [-0.5, 0.5], 5), 0.0);
    let force = 50e3;
    let wheel = solve(&on(round(), ramp, Support::Force(force)));
    let level = solve(&on(round(), straight(), Support::Force(force / angle.cos())));
    let [contact, flat] = [&wheel, &level].map(|wheel| wheel.contacts[0].clone());
    close("rise", contact.rise, angle, 2e-6);
    close("x", contact.position[0], RADIUS * angle.sin(), 2e-6);
    // At first touch the axle is R (1/cos θ − 1) higher, and the depth is that along the normal.
    let lift = RADIUS * (1.0 / angle.cos() - 1.0);
    close("height", wheel.height + wheel.depth(), lift, 1e-7);
    let load = contact.solution.normal.load;
    let along = contact.solution.force.x;
    close("vertical", load * angle.cos() + along * angle.sin(), force, 2e-4 * force);
    close("forwards", wheel.force[0], along * angle.cos() - load * angle.sin(), 1e-5 * force);
    // The wheel's own surface is R from the axle; the rolling speed is the mean of both.
    let creepage = (1.0 - angle.cos()) / (0.5 + 0.5 * angle.cos());
    close("creepage", contact.solution.kinematics.creepage_x, creepage, 1e-6);
    let peaks = [&contact, &flat].map(|contact| contact.solution.normal.peak_pressure);
    let expected = (load * angle.cos() / force).cbrt();
    close("peak", peaks[0] / peaks[1], expected, 2e-3);
}

/// A cylinder that turns about a point 2 mm beside its axis, as 90 sections around that point: the
/// contact is below the axis, and the axle rises and falls.
#[test]
fn an_eccentric_wheel_is_a_displaced_cylinder() {
    let eccentricity = 2e-3;
    let radius = |angle: f64| {
        let across = eccentricity * angle.sin();
        eccentricity * angle.cos() + (RADIUS * RADIUS - across * across).sqrt()
    };
    let sections = wheel_of(radius, [-3.2, 3.2], 90);
    let load = Support::Force(50e3);
    let round = solve(&on(round(), straight(), load));
    for pitch in [-4.0, -PI, -1.3, 0.0, 0.7, 2.0, 9.0] {
        let wheel = Surface::around(Arc::clone(&sections), pitch);
        let wheel = solve(&on(wheel, straight(), load));
        let contact = &wheel.contacts[0];
        close("x", contact.position[0], -eccentricity * pitch.sin(), 3e-6);
        close("rise", contact.rise, 0.0, 1e-12);
        let lift = eccentricity * pitch.cos();
        close("height", wheel.height - round.height, lift, 2e-7);
        let [one, other] =
            [&wheel, &round].map(|wheel| wheel.contacts[0].solution.normal.peak_pressure);
        close("peak", one / other, 1.0, 2e-3);
    }
}

/// Contacts at an angle, under yaw: a rail that rises and a wheel whose radius changes move the
/// wheelset up or down, and the material slides across as on the level rail and the round wheel.
/// A vertical velocity that says the same changes nothing, and one of zero slides by its part.
#[test]
fn a_wheel_that_climbs_slides_no_further_across() {
    const SLOPE: f64 = 0.1;
    let eccentricity = 1e-3;
    let radius = |angle: f64| {
        let across = eccentricity * angle.sin();
        eccentricity * angle.cos() + (RADIUS * RADIUS - across * across).sqrt()
    };
    let cone = |r: f64| curve(move |y| RADIUS - r + SLOPE * y, WIDTH, Quantity::WheelProfile);
    let around: Vec<Section> = (0..90)
        .map(|k| -3.2 + 6.4 * f64::from(k) / 89.0)
        .map(|u| section(u, cone(radius(u))))
        .collect();
    let quantity = Quantity::WheelProfile;
    let around = Arc::new(Sections::new(&around, Interpolation::Through, quantity).unwrap());
    let rail = |rise: f64| {
        let along = rail_of(move |u, y| crown(y) + SLOPE * y + rise * u, [-0.5, 0.5], 5);
        Surface::along(along, 0.0)
    };
    let yawed = |wheel: Surface, rail: Surface, velocity: Option<f64>| {
        let mut posed = on(wheel, rail, Support::Force(40e3));
        posed.position.yaw = 2e-3;
        posed.follows = velocity.is_none();
        posed.motion.vertical_velocity = velocity.unwrap_or_default();
        let solved = solve(&posed);
        let kinematics = solved.contacts[0].solution.kinematics;
        ([kinematics.creepage_y, kinematics.spin], posed.motion)
    };
    let ([level, spin], motion) = yawed(cone(RADIUS).into(), rail(0.0), None);
    assert!((level.abs() / 2e-3 - 1.0).abs() < 0.02 && spin.abs() > 0.1, "{level} {spin}");
    // Equal slices are the prism, also where the wheelset moves across.
    let moving = |rail: Surface| {
        let mut posed = on(cone(RADIUS).into(), rail, Support::Force(40e3));
        (posed.motion.lateral_velocity, posed.motion.roll_rate) = (0.05, 0.1);
        solve(&posed).contacts[0].solution.kinematics.creepage_y
    };
    let plain = curve(|y| crown(y) + SLOPE * y, WIDTH, Quantity::RailProfile);
    close("moving", moving(rail(0.0)), moving(plain.into()), 1e-6);
    let climbing = 0.02;
    let pitched = |pitch| Surface::around(Arc::clone(&around), pitch);
    for (wheel, rise, velocity) in [
        (cone(RADIUS).into(), climbing, climbing * motion.speed),
        (pitched(1.2), 0.0, -motion.angular_velocity * eccentricity * 1.2_f64.sin()),
    ] {
        let ([across, _], _) = yawed(Surface::clone(&wheel), rail(rise), None);
        close("across", across, level, 4e-6);
        let ([given, _], _) = yawed(Surface::clone(&wheel), rail(rise), Some(velocity));
        close("given", given, level, 4e-6);
        let ([still, _], _) = yawed(wheel, rail(rise), Some(0.0));
        let missing = velocity / motion.speed * SLOPE.atan().sin();
        close("still", (still - level).abs(), missing.abs(), 0.1 * missing.abs());
    }
}

/// Sections that cover the circumference are a smooth surface all around, wherever they begin: a
/// wave of 3 lobes has the same heights and slopes as at places where no section begins or ends.
#[test]
fn sections_around_a_wheel_go_on_at_half_a_turn() {
    let quantity = Quantity::WheelProfile;
    let lobes = |angle: f64| 1e-3 * (3.0 * angle + 0.4).sin();
    let sections = |from: f64, count: usize| -> Vec<Section> {
        (0..count)
            .map(|k| from + TAU * k as f64 / 72.0)
            .map(|u| section(u, curve(|_| lobes(u), WIDTH, quantity)))
            .collect()
    };
    let around = |sections: &[Section], method| Sections::around(sections, method);
    for (from, count) in [(-PI, 72), (-3.0, 72), (0.0, 72), (-PI, 73)] {
        let mut sections = sections(from, count);
        sections.truncate(72);
        if count == 73 {
            let first = sections[0].clone();
            sections.push(Section { place: PI, ..first });
        }
        for method in [Interpolation::Through, Interpolation::Smooth] {
            let surface = Surface::around(Arc::new(around(&sections, method).unwrap()), 0.0);
            let height = |angle: f64| surface.point(angle, 0.02).unwrap().place[1];
            for k in -400..400 {
                // A third of a turn apart everything is the same.
                let angle = 0.0131 * f64::from(k);
                close("lobe", height(angle), height(angle + TAU / 3.0), 1e-14);
                if method == Interpolation::Through {
                    close("height", height(angle), lobes(angle), 2e-8);
                }
            }
        }
    }
    let refused =
        |sections: &[Section]| around(sections, Interpolation::Through).unwrap_err().to_string();
    let mut open = sections(-PI, 72);
    open.push(section(PI, curve(|_| 1e-3, WIDTH, quantity)));
    assert!(refused(&open).contains("must be the first one again"));
    assert!(refused(&sections(1.0, 36)).contains("or cover the whole circumference"));
    assert!(around(&sections(-1.0, 12), Interpolation::Through).unwrap().span()[1] < 0.0);
}

/// A fresh flat, 1 mm deep, straight down: a plane of the length of the chord on the crown of the
/// rail. Away from its ends the pressure is that of a cylinder and a plane under the load over
/// that length.
#[test]
fn a_flat_is_a_plane_as_long_as_its_chord() {
    let depth = 1e-3;
    let half = (1.0 - depth / RADIUS).acos();
    let radius = |angle: f64| RADIUS * (half.cos() / angle.cos()).min(1.0);
    let sections = wheel_of(radius, [-2.0 * half, 2.0 * half], 241);
    let force = 40e3;
    let flat = on(Surface::around(sections, 0.0), straight(), Support::Force(force));
    let wheel = solve(&flat);
    let contact = &wheel.contacts[0];
    // A corner is less than 2 mm wide between the steps at which first touch is looked for.
    close("touch", wheel.height + wheel.depth(), -depth, 2e-5);
    let length = 2.0 * RADIUS * half.sin();
    close("length", 2.0 * contact.solution.normal.semi_axis_x, length, 2e-3);
    let modulus = contact_modulus(&STEEL, &STEEL);
    let fields = &contact.solution.fields;
    for column in 0..fields.grid.columns {
        let own = || (0..fields.cell.len()).filter(|k| fields.cell[*k][0] == column);
        if own().next().is_none_or(|k| fields.x[k].abs() > 0.25 * length) {
            continue;
        }
        let per_length: f64 = own().map(|k| fields.pressure[k] * fields.grid.spacing_y).sum();
        let peak = own().map(|k| fields.pressure[k]).fold(0.0, f64::max);
        let expected = (per_length * modulus / (PI * CROWN)).sqrt();
        close("peak of the strip", peak / expected, 1.0, 0.02);
    }
}

/// A wing rail that falls and a nose that rises, both by 1 in 50 and level across, the nose as a
/// part that begins at u = 0: the wheel goes over where both are equally high, at u = 0.2 m.
#[test]
fn a_wheel_jumps_from_wing_to_nose() {
    let quantity = Quantity::RailProfile;
    let slope = 0.02;
    let sections: Vec<Section> = (0..17)
        .map(|k| 0.05 * f64::from(k) - 0.2)
        .map(|u| {
            let nose = |y: f64| slope * u - (y + 0.02).powi(2) / (2.0 * CROWN);
            let wing = |y: f64| slope * (0.4 - u) - (y - 0.02).powi(2) / (2.0 * CROWN);
            // Tops of both, and straight to the bottom of the groove between them.
            let z = |y: f64| match y {
                _ if y <= -0.01 => nose(y),
                _ if y >= 0.01 => wing(y),
                _ if y < 0.0 => nose(-0.01) + (y + 0.01) / 0.01 * (-0.03 - nose(-0.01)),
                _ => wing(0.01) + (0.01 - y) / 0.01 * (-0.03 - wing(0.01)),
            };
            let whole = curve(z, WIDTH, quantity);
            let at = |y: f64| {
                let mut ends = [0.0, whole.length()];
                for _ in 0..60 {
                    let middle = 0.5 * (ends[0] + ends[1]);
                    ends[usize::from(whole.at(middle).place[0] > y)] = middle;
                }
                ends[0]
            };
            let of_nose = (u > -1e-9).then_some([0.0, at(-0.01)]);
            let breaks = vec![
                of_nose.map(|[from, _]| from),
                of_nose.map(|[_, to]| to),
                Some(at(0.0)),
                Some(at(0.01)),
                Some(whole.length()),
            ];
            Section { place: u, curve: whole, breaks }
        })
        .collect();
    let sections = Arc::new(Sections::new(&sections, Interpolation::Through, quantity).unwrap());
    let at = |u: f64| {
        let rail = Surface::along(Arc::clone(&sections), u);
        solve(&on(round(), rail, Support::Force(20e3)))
    };
    let places = |wheel: &WheelSolution| -> Vec<f64> {
        wheel.contacts.iter().map(|contact| contact.rail_position).collect()
    };
    let wing = places(&at(0.19));
    assert_eq!(wing.len(), 1);
    close("wing", wing[0], 0.02, 1e-5);
    let nose = places(&at(0.21));
    assert_eq!(nose.len(), 1);
    close("nose", nose[0], -0.02, 1e-5);
    let both = at(0.2);
    let loads: Vec<f64> =
        both.contacts.iter().map(|contact| contact.solution.normal.load).collect();
    assert_eq!(loads.len(), 2);
    close("shares", loads[0] / loads[1], 1.0, 0.05);
    for contact in &both.contacts {
        let rise = if contact.rail_position < 0.0 { slope } else { -slope };
        close("rise", contact.rise, rise.atan(), 1e-5);
        close("x", contact.position[0], RADIUS * rise.atan().sin(), 1e-4);
    }
}

/// What sections cannot be.
#[test]
fn sections_that_do_not_fit_are_refused() {
    let quantity = Quantity::RailProfile;
    let at = |place: f64| section(place, curve(crown, WIDTH, quantity));
    let refused = |sections: &[Section]| {
        let error = Sections::new(sections, Interpolation::Through, quantity).unwrap_err();
        error.to_string()
    };
    assert!(refused(&[at(0.0)]).contains("at least 2 sections"));
    assert!(refused(&[at(0.0), at(0.0)]).starts_with("section 2 of"));
    let mut longer = at(1.0);
    longer.breaks[1] = Some(1.0);
    assert!(refused(&[at(0.0), longer]).contains("in place 2"));
    let mut fewer = at(1.0);
    fewer.breaks.pop();
    assert!(refused(&[at(0.0), fewer]).starts_with("section 2 of"));
}
