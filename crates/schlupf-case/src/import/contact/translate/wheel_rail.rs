//! A case of module 1.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::{FieldPath, Source};

use crate::import::Notice;
use crate::import::contact::control::Control;
use crate::import::contact::friction::Friction;
use crate::import::contact::given::Given;
use crate::import::contact::wheel_rail::{Profile, Track, WheelRail};

use super::case::Translation;
use super::frame::WheelBody;
use super::friction;
use super::laws;

/// Translates a steady state; `folder` stands before the names of profiles.
pub fn translate(
    source: &Arc<Source>,
    (control, wheel_rail): (&Control, &WheelRail),
    folder: &str,
) -> Translation {
    let mut case = Translation::new(source);
    laws::notice_digits(&mut case, control);
    digits(&mut case, control);
    materials(&mut case, control, wheel_rail);
    case.document.text(field!("normal.model"), "wheel-rail");
    search(&mut case, control, wheel_rail);
    match &wheel_rail.track {
        Some(track) => write_track(&mut case, track),
        None => case.miss(control.distance, "the track"),
    }
    match &wheel_rail.rail {
        Some(profile) => write_profile(&mut case, profile, &RAIL, folder),
        None => case.miss(control.distance, "the profile of the rail"),
    }
    match &wheel_rail.wheel {
        Some(profile) => write_profile(&mut case, profile, &WHEEL, folder),
        None => case.miss(control.extra, "the profile of the wheel"),
    }
    wheelset(&mut case, control, wheel_rail);
    case
}

fn digits(case: &mut Translation, control: &Control) {
    if control.config.value >= 4.0 {
        case.refuse(control.config, "rollers are not available", "C1 = 0 or 1 is a track");
    }
    match control.tangential.whole() {
        1 => case.refuse(
            control.tangential,
            "a shift is not available with two profiles",
            "T = 3 rolls steadily",
        ),
        2 => case.refuse(
            control.tangential,
            "transient rolling is not available with two profiles",
            "T = 3 rolls steadily",
        ),
        _ => {}
    }
    let (what, help) = match control.force.whole() {
        1 | 2 if control.tangential.is(0) => (
            "a force in place of VPITCH needs friction, but T = 0 is without",
            "T = 3 rolls steadily",
        ),
        1 | 2 if control.normal.is(0) => (
            "a force in place of VPITCH needs the vertical force, but N = 0 gives the height",
            "N = 1 gives FZ",
        ),
        3 => ("rails that give way are not available", "F = 0 gives positions and velocities"),
        _ => return,
    };
    case.refuse(control.force, what, help);
}

fn materials(case: &mut Translation, control: &Control, wheel_rail: &WheelRail) {
    // Both modules of a wheel on a rail have the wheel as body 2; the same materials follow from
    // either order of equal ones.
    if let Some(elastic) = &wheel_rail.elastic {
        laws::elastic(case, elastic, BODY);
        laws::method(case, control, elastic);
        laws::notice_fastsim(case, control, elastic, false);
        if control.bound.is(5) {
            case.document.text(field!("normal.method"), "ellipse-corrected");
        }
    } else {
        case.miss(control.influence, "the materials");
    }
    laws::heat(case, control, wheel_rail.heat.as_ref(), BODY);
    match &wheel_rail.friction {
        Some(friction) => write_friction(case, control, friction, wheel_rail.position),
        None => case.miss(control.friction_law, "the law of friction"),
    }
}

fn write_friction(
    case: &mut Translation,
    control: &Control,
    friction: &Friction,
    position: Option<[Given; 6]>,
) {
    if control.tangential.is(0) {
        case.remark("Without friction (T = 0): as good as none.");
        case.document.text(field!("friction.model"), "constant");
        case.document.number(field!("friction.coefficient"), FRICTIONLESS);
        return;
    }
    let places: Vec<f64> = friction.places.iter().map(|place| place.value).collect();
    match (friction.variation.whole(), position) {
        (1, _) => {
            let places: Vec<f64> = places.iter().map(|angle| angle.to_degrees()).collect();
            let path = field!("friction.variation_inclination");
            friction::varying(case, friction, (path, &places, "deg"));
        }
        (2, Some([s, ..])) => friction::uniform(case, &friction.between(&places, s.value)),
        _ => friction::uniform(case, friction),
    }
}

/// The wheel in module 1.
const BODY: WheelBody = WheelBody::Second;
/// What carries nothing, dimensionless.
const FRICTIONLESS: f64 = 1e-9;

fn search(case: &mut Translation, control: &Control, wheel_rail: &WheelRail) {
    let Some(search) = &wheel_rail.search else {
        return case.miss(control.grid, "the search for contacts");
    };
    match search.method.whole() {
        3 => case.refuse(
            search.method,
            "the rigid slip of the actual surfaces in the directions of the plane is not available",
            "D = 2 is that of the contact's plane; normal.row_motion = \"surface\" has that of the \
             surfaces, in the directions of every row",
        ),
        4 => case.refuse(
            search.method,
            "contacts on a curved surface are not available",
            "D = 2 is in a plane; with normal.row_motion = \"surface\" the rows slip as the curved \
             surface, under the pressure in a plane",
        ),
        _ => {}
    }
    let angle = search.angle.value.clamp(0.0, FRAC_PI_2);
    case.document.quantity(field!("normal.join_distance"), search.distance.value.max(0.0), "mm");
    case.document.quantity(field!("normal.join_angle"), angle.to_degrees(), "deg");
    case.stands(field!("normal.join_distance"), search.distance);
    case.stands(field!("normal.join_angle"), search.angle);
    if search.whole_distance.value < search.distance.value {
        case.notice(Notice::WholeContacts {}, search.whole_distance);
    }
    case.document.text(field!("normal.row_motion"), "plane");
}

fn write_track(case: &mut Translation, track: &Track) {
    if track.gauge_height.value <= 0.0 {
        case.refuse(
            track.gauge_height,
            "rails placed by their origin (RAILY0, RAILZ0) are not available",
            "GAUGHT > 0 places them by the gauge GAUGWD",
        );
        return;
    }
    if track.face.value > 1.0 {
        case.refuse(track.face, "gauge faces other than the first are not available", "GAUGSQ = 0");
    }
    case.quantity(field!("track.gauge"), track.gauge, (1.0, "mm"));
    case.quantity(field!("track.gauge_depth"), track.gauge_height, (1.0, "mm"));
    case.document.number(field!("rail.cant"), track.cant.value.tan());
    case.stands(field!("rail.cant"), track.cant);
    if let Some(curvature) = track.curvature {
        case.refuse_unless_zero(curvature, "curved track is not available", "CURV = 0 is straight");
    }
}

/// Paths of the fields of a profile.
struct ProfilePaths {
    profile: FieldPath,
    y: FieldPath,
    z: FieldPath,
    smoothing: FieldPath,
}

const RAIL: ProfilePaths = ProfilePaths {
    profile: field!("rail.profile"),
    y: field!("rail.profile_y"),
    z: field!("rail.profile_z"),
    smoothing: field!("rail.profile_smoothing"),
};
const WHEEL: ProfilePaths = ProfilePaths {
    profile: field!("wheel.profile"),
    y: field!("wheel.profile_y"),
    z: field!("wheel.profile_z"),
    smoothing: field!("wheel.profile_smoothing"),
};

/// Endings of files of several profiles.
const SLICES: [&str; 2] = [".slcs", ".slcw"];

fn write_profile(case: &mut Translation, profile: &Profile, paths: &ProfilePaths, folder: &str) {
    let name = profile.file.text.trim().replace('\\', "/");
    let lower = name.to_ascii_lowercase();
    if SLICES.iter().any(|ending| lower.ends_with(ending)) {
        let given = Given { name: profile.file.name, value: 0.0, at: profile.file.at };
        case.refuse_text(given, &name, "profiles that vary along the track are not available");
    }
    let is_absolute = name.starts_with('/') || name.get(1..2) == Some(":");
    let path = if is_absolute { name } else { format!("{folder}{name}") };
    case.document.text(paths.profile, &path);
    case.places.push((paths.profile, profile.file.at));
    let outwards = if profile.mirror_y.is(1) { "inwards" } else { "outwards" };
    case.document.text(paths.y, outwards);
    match profile.mirror_z.map(Given::whole) {
        Some(1) => case.document.text(paths.z, "up"),
        Some(-1) => case.document.text(paths.z, "down"),
        _ => {}
    }
    if let Some(options) = profile.thresholds {
        case.notice(Notice::ThresholdsLeftOut { profile: paths.profile }, options);
    }
    if profile.scale.value != 1.0 {
        case.refuse(
            profile.scale,
            "a scale of a profile is not available",
            "SCALEYZ = 1 for a file in mm; the header `y [m],z [m]` names other units",
        );
    }
    let smoothing = profile.smoothing;
    if smoothing.value <= 0.0 {
        return;
    }
    match profile.smoothing_method.map_or(0, Given::whole) {
        1 => case.quantity(paths.smoothing, smoothing, (1.0, "mm")),
        _ => case.refuse(
            smoothing,
            "this method of smoothing is not available",
            "ISMOOTH = 1 (PRFOPT = 1) smooths with a length L_FILT in mm",
        ),
    }
}

/// Positions of the tape circle that turn it off, in mm.
const NO_TAPE_CIRCLE: f64 = 1e3;

fn wheelset(case: &mut Translation, control: &Control, wheel_rail: &WheelRail) {
    let side = if control.config.is(0) || control.config.is(4) { "left" } else { "right" };
    case.document.text(field!("wheelset.side"), side);
    let (Some(size), Some(position), Some(velocity)) =
        (wheel_rail.wheelset, wheel_rail.position, wheel_rail.velocity)
    else {
        return case.miss(control.extra, "size, position and velocity of the wheelset");
    };
    let [distance, flange_back, radius] = size;
    case.quantity(field!("track.flange_back_distance"), distance, (1.0, "mm"));
    case.quantity(field!("wheel.flange_back_position"), flange_back, (1.0, "mm"));
    case.quantity(field!("wheel.radius_x"), radius, (1.0, "mm"));
    if let Some(tape) = wheel_rail.tape_circle.filter(|tape| tape.value.abs() < NO_TAPE_CIRCLE) {
        let what = "a radius NOMRADW at the tape circle is not available";
        let help = "leave YTAPE out and give the radius at the origin of the profile";
        case.refuse(tape, what, help);
    }
    if changed_meaning(control, &velocity[5]) {
        let what = "the velocities that are kept end with this value, but the digit F asks for another one";
        case.refuse(velocity[5], what, "E = 2 to 5 gives them anew");
    }
    // y to the right and z downwards there: a turn by π about x.
    let [_, y, support, roll, yaw, _] = position;
    case.quantity(field!("wheelset.lateral_position"), y, (-1.0, "mm"));
    case.quantity(field!("wheelset.yaw_angle"), yaw, (-1e3, "mrad"));
    case.quantity(field!("wheelset.roll_angle"), roll, (1e3, "mrad"));
    if control.normal.is(0) {
        case.quantity(field!("wheelset.height"), support, (-1.0, "mm"));
    } else {
        case.quantity(field!("normal.load"), support, (1e-3, "kN"));
    }
    let [forward, lateral, vertical, roll, yaw, pitch] = velocity;
    case.quantity(field!("kinematics.speed"), forward, (1e-3, "m/s"));
    case.quantity(field!("wheelset.lateral_velocity"), lateral, (-1.0, "mm/s"));
    case.quantity(field!("wheelset.vertical_velocity"), vertical, (-1.0, "mm/s"));
    case.quantity(field!("wheelset.roll_rate"), roll, (1.0, "rad/s"));
    case.quantity(field!("wheelset.yaw_rate"), yaw, (-1.0, "rad/s"));
    match control.force.whole() {
        // On the rail and along the wheelset there; a turn by π about x leaves x as it is.
        1 => {
            case.quantity(field!("kinematics.force_x"), pitch, (-1e-3, "kN"));
            case.document.text(field!("wheelset.force_axis"), "wheelset");
        }
        // The moment of the tractions on the rail about the axle: it balances the torque that
        // drives the wheel, and the axle points the other way there. N mm.
        2 => case.quantity(field!("kinematics.wheel_torque"), pitch, (-1e-3, "N m")),
        _ => case.quantity(field!("kinematics.angular_velocity"), pitch, (-1.0, "rad/s")),
    }
    deviations(case, wheel_rail);
}

/// Whether the last velocity is another quantity than the digit F says, as one that an earlier case
/// with another F gave.
fn changed_meaning(control: &Control, last: &Given) -> bool {
    let name = match control.force.whole() {
        1 => "FX_WS",
        2 => "MY_WS",
        _ => "VPITCH",
    };
    last.name != name
}

/// Deviations from the design are refused unless they vanish.
fn deviations(case: &mut Translation, wheel_rail: &WheelRail) {
    let of_wheel = wheel_rail.wheel_deviation.into_iter().flatten().flatten();
    let of_rail = wheel_rail.rail_deviation.into_iter().flatten();
    for given in of_rail.chain(of_wheel) {
        let what = "a deviation from the design is not available";
        case.refuse_unless_zero(given, what, "0 is the design itself");
    }
}
