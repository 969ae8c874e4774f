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

/// Translates a steady state, or the first step of a history; `folder` stands before the names of
/// profiles.
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
        Some(track) => write_track(&mut case, control, track),
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
    let (what, help) = match control.force.whole() {
        1 | 2 if control.tangential.is(0) => (
            "a force in place of VPITCH needs friction, but T = 0 is without",
            "T = 3 rolls steadily",
        ),
        1 | 2 if control.normal.is(0) => (
            "a force in place of VPITCH needs the vertical force, but N = 0 gives the height",
            "N = 1 gives FZ",
        ),
        1 | 2 if matches!(control.tangential.whole(), 1 | 2) => {
            let what = "a force in place of VPITCH is not available in a history";
            (what, "F = 0 gives the angular velocity")
        }
        3 => ("rails that give way are not available", "F = 0 gives positions and velocities"),
        _ => return,
    };
    case.refuse(control.force, what, help);
}

fn materials(case: &mut Translation, control: &Control, wheel_rail: &WheelRail) {
    let is_curved = wheel_rail.search.as_ref().is_some_and(|search| search.method.is(4));
    if let Some(elastic) = &wheel_rail.elastic {
        laws::elastic(case, elastic, BODY);
        match elastic.influence.whole() {
            4 if !is_curved => laws::refuse_conformal(case, elastic),
            2 if is_curved => case.notice(Notice::BentHalfSpaces {}, elastic.influence),
            _ => {}
        }
        laws::method(case, control, elastic, None);
        laws::notice_fastsim(case, control, elastic, false);
        match control.bound.whole() {
            5 => {
                case.document.text(field!("normal.method"), "ellipse-corrected");
                case.notice(Notice::OtherShares {}, control.bound);
            }
            6 => case.document.text(field!("normal.method"), "analyn"),
            _ => {}
        }
    } else {
        case.miss(control.influence, "the materials");
    }
    laws::heat(case, control, wheel_rail.heat.as_ref(), BODY);
    match &wheel_rail.friction {
        Some(friction) => {
            let place = wheel_rail.position.map(|[s, ..]| s.value);
            write_friction(case, (control, friction), place, is_curved);
        }
        None => case.miss(control.friction_law, "the law of friction"),
    }
}

fn write_friction(
    case: &mut Translation,
    (control, friction): (&Control, &Friction),
    place: Option<f64>,
    is_curved: bool,
) {
    if control.tangential.is(0) {
        case.remark("Without friction (T = 0): as good as none.");
        case.document.text(field!("friction.model"), "constant");
        case.document.number(field!("friction.coefficient"), FRICTIONLESS);
        return;
    }
    let places: Vec<f64> = friction.places.iter().map(|place| place.value).collect();
    match (friction.variation.whole(), place) {
        (1, _) => {
            if !is_curved {
                case.notice(Notice::FrictionByRow {}, friction.variation);
            }
            let places: Vec<f64> = places.iter().map(|angle| angle.to_degrees()).collect();
            let path = field!("friction.variation_inclination");
            friction::varying(case, friction, (path, &places, "deg"));
        }
        (2, Some(place)) => friction::uniform(case, &friction.between(&places, place)),
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
        4 if control.bound.value >= 5.0 => case.refuse(
            control.bound,
            "approximate contacts (KPEC, ANALYN) are in a plane, not on a curved surface",
            "B = 0 solves the normal contact",
        ),
        4 => case.document.text(field!("normal.method"), "conformal"),
        _ => case.document.text(field!("normal.row_motion"), "plane"),
    }
    let angle = search.angle.value.clamp(0.0, FRAC_PI_2);
    case.document.quantity(field!("normal.join_distance"), search.distance.value.max(0.0), "mm");
    case.document.quantity(field!("normal.join_angle"), angle.to_degrees(), "deg");
    case.stands(field!("normal.join_distance"), search.distance);
    case.stands(field!("normal.join_angle"), search.angle);
    if search.whole_distance.value < search.distance.value {
        case.notice(Notice::WholeContacts {}, search.whole_distance);
    }
}

/// Whether the wheel is the left one.
fn is_left(control: &Control) -> bool {
    control.config.is(0) || control.config.is(4)
}

/// Whether it runs on a roller.
fn is_on_roller(control: &Control) -> bool {
    control.config.value >= 4.0
}

fn write_track(case: &mut Translation, control: &Control, track: &Track) {
    if track.gauge_height.value <= 0.0 {
        // y to the right and z downwards there.
        let outwards = if is_left(control) { -1.0 } else { 1.0 };
        case.quantity(field!("rail.origin_y"), track.face, (outwards, "mm"));
        case.quantity(field!("rail.origin_z"), track.gauge, (-1.0, "mm"));
    } else {
        if track.face.value > 1.0 {
            let what = "gauge faces other than the first are not available";
            case.refuse(track.face, what, "GAUGSQ = 0");
        }
        case.quantity(field!("track.gauge"), track.gauge, (1.0, "mm"));
        case.quantity(field!("track.gauge_depth"), track.gauge_height, (1.0, "mm"));
    }
    if is_on_roller(control) {
        case.quantity(field!("rail.radius_x"), track.cant, (1.0, "mm"));
    } else {
        case.document.number(field!("rail.cant"), track.cant.value.tan());
        case.stands(field!("rail.cant"), track.cant);
    }
    if let Some(curvature) = track.curvature.filter(|curvature| curvature.value != 0.0) {
        let radius = Given { value: curvature.value.recip(), ..curvature };
        case.quantity(field!("track.curve_radius"), radius, (-1e-3, "m"));
    }
}

/// Paths of the fields of a profile.
struct ProfilePaths {
    profile: FieldPath,
    y: FieldPath,
    z: FieldPath,
    scale: FieldPath,
    smoothing: FieldPath,
}

const RAIL: ProfilePaths = ProfilePaths {
    profile: field!("rail.profile"),
    y: field!("rail.profile_y"),
    z: field!("rail.profile_z"),
    scale: field!("rail.profile_scale"),
    smoothing: field!("rail.profile_smoothing"),
};
const WHEEL: ProfilePaths = ProfilePaths {
    profile: field!("wheel.profile"),
    y: field!("wheel.profile_y"),
    z: field!("wheel.profile_z"),
    scale: field!("wheel.profile_scale"),
    smoothing: field!("wheel.profile_smoothing"),
};

/// Whether a file has profiles that change along the way.
fn has_slices(profile: Option<&Profile>) -> bool {
    profile.is_some_and(|profile| crate::profiles::has_slices(profile.file.text.trim()))
}

fn write_profile(case: &mut Translation, profile: &Profile, paths: &ProfilePaths, folder: &str) {
    let name = profile.file.text.trim().replace('\\', "/");
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
        case.document.number(paths.scale, profile.scale.value);
        case.stands(paths.scale, profile.scale);
    }
    let smoothing = profile.smoothing;
    if smoothing.value <= 0.0 {
        return;
    }
    match profile.smoothing_method.map_or(0, Given::whole) {
        1 => case.quantity(paths.smoothing, smoothing, (1.0, "mm")),
        2 => {
            case.remark(format!(
                "{}: penalty of the second derivative in place of the third, with the wavelength \
                 that both halve.",
                paths.smoothing
            ));
            case.quantity(paths.smoothing, smoothing, (1.0, "mm"));
        }
        _ => case.refuse(
            smoothing,
            "this method of smoothing, whose wavelength depends on the points, is not available",
            "ISMOOTH = 1 (PRFOPT = 1) smooths with a length L_FILT in mm",
        ),
    }
}

/// Positions of the tape circle that turn it off, in mm.
const NO_TAPE_CIRCLE: f64 = 1e3;

fn wheelset(case: &mut Translation, control: &Control, wheel_rail: &WheelRail) {
    let side = if is_left(control) { "left" } else { "right" };
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
    let [along, y, support, roll, yaw, pitch] = position;
    if has_slices(wheel_rail.rail.as_ref()) {
        case.quantity(field!("wheelset.track_position"), along, (1e-3, "m"));
    }
    if has_slices(wheel_rail.wheel.as_ref()) {
        let bent = wheel_rail.wheel_deviation.map_or(0.0, |[deviation, _]| deviation[5].value);
        let pitch = Given { value: pitch.value + bent, ..pitch };
        case.quantity(field!("wheelset.pitch_angle"), pitch, (-1.0, "rad"));
    }
    if is_on_roller(control) {
        let what = "a wheel before or behind the top of its roller is not available";
        case.refuse_unless_zero(along, what, "X_WS = 0 is above its axle");
    }
    case.quantity(field!("wheelset.lateral_position"), y, (-1.0, "mm"));
    case.quantity(field!("wheelset.yaw_angle"), yaw, (-1e3, "mrad"));
    case.quantity(field!("wheelset.roll_angle"), roll, (1e3, "mrad"));
    if control.normal.is(0) {
        case.quantity(field!("wheelset.height"), support, (-1.0, "mm"));
    } else {
        case.quantity(field!("normal.load"), support, (1e-3, "kN"));
    }
    let [forward, lateral, vertical, roll, yaw, pitch] = velocity;
    if is_on_roller(control) {
        case.quantity(field!("rail.angular_velocity"), forward, (1.0, "rad/s"));
    } else {
        case.quantity(field!("kinematics.speed"), forward, (1e-3, "m/s"));
    }
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
        // In a history it is a column.
        _ if matches!(control.tangential.whole(), 1 | 2) => {}
        _ => case.quantity(field!("kinematics.angular_velocity"), pitch, (-1.0, "rad/s")),
    }
    deviations(case, is_left(control), wheel_rail);
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

/// A field of a deviation, on the left and on the right, with the factor and the unit that make it
/// of a value; `None` for what has no effect.
type Deviation = Option<([FieldPath; 2], (f64, &'static str))>;

macro_rules! own {
    ($body:literal, $name:literal, $factor:literal, $unit:literal) => {
        Some((
            [field!("left_", $body, ".", $name), field!("right_", $body, ".", $name)],
            ($factor, $unit),
        ))
    };
}

/// DYRAIL, DZRAIL, DROLLR, VYRAIL, VZRAIL and VROLLR.
const OF_RAIL: [Deviation; 6] = [
    own!("rail", "lateral_displacement", -1.0, "mm"),
    own!("rail", "vertical_displacement", -1.0, "mm"),
    own!("rail", "roll_angle", 1e3, "mrad"),
    own!("rail", "lateral_velocity", -1.0, "mm/s"),
    own!("rail", "vertical_velocity", -1.0, "mm/s"),
    own!("rail", "roll_rate", 1.0, "rad/s"),
];
/// DXWHL to DPITCHW, of which the last one is part of the pitch. Then VXWHL to VPITCHW.
const OF_WHEEL: [Deviation; 12] = [
    own!("wheel", "longitudinal_displacement", 1.0, "mm"),
    own!("wheel", "lateral_displacement", -1.0, "mm"),
    own!("wheel", "vertical_displacement", -1.0, "mm"),
    own!("wheel", "roll_angle", 1e3, "mrad"),
    own!("wheel", "yaw_angle", -1e3, "mrad"),
    None,
    own!("wheel", "longitudinal_velocity", 1.0, "mm/s"),
    own!("wheel", "lateral_velocity", -1.0, "mm/s"),
    own!("wheel", "vertical_velocity", -1.0, "mm/s"),
    own!("wheel", "roll_rate", 1.0, "rad/s"),
    own!("wheel", "yaw_rate", -1.0, "rad/s"),
    own!("wheel", "pitch_rate", -1.0, "rad/s"),
];

fn deviations(case: &mut Translation, is_left: bool, wheel_rail: &WheelRail) {
    let of_wheel = wheel_rail.wheel_deviation.into_iter().flatten().flatten().zip(OF_WHEEL);
    let of_rail = wheel_rail.rail_deviation.into_iter().flatten().zip(OF_RAIL);
    for (given, field) in of_rail.chain(of_wheel).filter(|(given, _)| given.value != 0.0) {
        if let Some(([left, right], into)) = field {
            case.quantity(if is_left { left } else { right }, given, into);
        }
    }
}
