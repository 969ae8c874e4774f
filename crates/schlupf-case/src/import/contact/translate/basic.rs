//! A case of module 3.

use std::sync::Arc;

use crate::Source;

use crate::import::Notice;
use crate::import::contact::basic::{Basic, Motion, Rolling};
use crate::import::contact::control::Control;
use crate::import::contact::friction::Friction;

use super::case::Translation;
use super::contact::{Contact, NormalProblem};
use super::frame::{Frame, WheelBody};
use super::friction;
use super::laws;
use super::normal;

/// Speed of what does not roll, in mm/s: irrelevant there, but every case has one.
const RESTING: f64 = 1e3;

/// Translates a steady state or a single shift; `stem` begins the names of its files.
pub fn translate(
    source: &Arc<Source>,
    (control, basic): (&Control, &Basic),
    wheel: WheelBody,
    stem: &str,
) -> Translation {
    let mut case = Translation::new(source);
    let written = write(&mut case, (control, basic), wheel, stem);
    if let (Some(written), Some(motion)) = (written, &basic.motion) {
        motion_of(&mut case, control, motion, (written, forces_at(control, basic, written)));
    }
    case
}

/// What every case of module 3 has.
#[derive(Debug, Clone, Copy)]
pub struct Written {
    /// Axes.
    pub frame: Frame,
    /// Normal contact.
    pub contact: Contact,
}

/// Writes all but the motion.
pub fn write(
    case: &mut Translation,
    (control, basic): (&Control, &Basic),
    wheel: WheelBody,
    stem: &str,
) -> Option<Written> {
    laws::notice_digits(case, control);
    let rolling = control.is_rolling().then_some(basic.rolling.as_ref()).flatten();
    let frame = frame(case, control, rolling, wheel);
    if let Some(elastic) = &basic.elastic {
        laws::elastic(case, elastic, wheel);
        if elastic.influence.is(4) {
            laws::refuse_conformal(case, elastic);
        }
        laws::unlike_bodies(case, elastic, basic.outer_iterations);
        laws::method(case, control, elastic, Some(wheel));
        if control.bound.value >= 5.0 {
            let what = "approximate contacts (KPEC, ANALYN) need two profiles";
            case.refuse(control.bound, what, "B = 0 solves the normal contact");
        }
        if let Some(motion) = &basic.motion {
            let is_along = motion.tangential[1].value == 0.0 && motion.spin.value == 0.0;
            laws::notice_fastsim(case, control, elastic, is_along);
        }
    } else {
        case.miss(control.influence, "the materials");
    }
    laws::heat(case, control, basic.heat.as_ref(), wheel);
    if basic.friction.is_none() {
        case.miss(control.friction_law, "the law of friction");
    }
    extra_slip(case, basic);
    let (Some(elastic), Some(area), Some(motion)) = (&basic.elastic, &basic.area, &basic.motion)
    else {
        if basic.area.is_none() {
            case.miss(control.grid, "the potential contact area");
        }
        return None;
    };
    let frame = frame?;
    let given = NormalProblem { control, motion, elastic, area, frame };
    let contact = normal::write(case, given, basic, stem)?;
    if let Some(friction) = &basic.friction {
        write_friction(case, friction, frame, contact);
    }
    speed(case, rolling);
    Some(Written { frame, contact })
}

fn frame(
    case: &mut Translation,
    control: &Control,
    rolling: Option<&Rolling>,
    wheel: WheelBody,
) -> Option<Frame> {
    if control.is_rolling() && rolling.is_none() {
        case.miss(control.influence, "the rolling direction and speed");
    }
    let frame = Frame::new(wheel, rolling);
    if let (None, Some(rolling)) = (frame, rolling) {
        let what = "rolling is available along x only";
        case.refuse(rolling.direction, what, "CHI = 0 or 180d");
    }
    frame
}

fn speed(case: &mut Translation, rolling: Option<&Rolling>) {
    // mm/s.
    match rolling {
        Some(rolling) => case.quantity(field!("kinematics.speed"), rolling.speed, (1e-3, "m/s")),
        None => case.document.quantity(field!("kinematics.speed"), 1e-3 * RESTING, "m/s"),
    }
}

/// Creepages, forces (in kN) or a shift.
fn motion_of(
    case: &mut Translation,
    control: &Control,
    motion: &Motion,
    (written, forces): (Written, Forces),
) {
    match control.tangential.whole() {
        0 => case.remark("Without creepage there are no tangential tractions (T = 0)."),
        1 => shift(case, control, motion, (written, forces)),
        _ => creepages(case, control, motion, (written, forces)),
    }
}

/// Creepages, or forces (in kN) in their place.
pub fn creepages(
    case: &mut Translation,
    control: &Control,
    motion: &Motion,
    (written, [force_x, force_y]): (Written, Forces),
) {
    let [x, y] = creepages_at(motion, written);
    let contact = written.contact;
    let spin = 1e3 * motion.spin.value;
    if force_x.is_some() {
        check_forces(case, control, motion);
    }
    match force_x {
        Some(force) => case.document.quantity(field!("kinematics.force_x"), force, "kN"),
        None => case.document.number(field!("kinematics.creepage_x"), x),
    }
    match force_y {
        Some(force) => case.document.quantity(field!("kinematics.force_y"), force, "kN"),
        None => case.document.number(field!("kinematics.creepage_y"), y),
    }
    case.document.quantity(field!("kinematics.spin"), spin, "1/m");
    for (path, given) in [
        (
            if force_x.is_some() {
                field!("kinematics.force_x")
            } else {
                field!("kinematics.creepage_x")
            },
            0,
        ),
        (
            if force_y.is_some() {
                field!("kinematics.force_y")
            } else {
                field!("kinematics.creepage_y")
            },
            1,
        ),
    ] {
        case.stands(path, motion.tangential[given]);
    }
    case.stands(field!("kinematics.spin"), motion.spin);
    if contact.centre != [0.0; 2] {
        case.notice(Notice::MomentAtMiddle { centre: contact.centre }, motion.spin);
    }
}

/// Forces along x and y in kN, where they are given in place of the creepages.
pub type Forces = [Option<f64>; 2];

/// The forces that are given; relative ones refer to the friction limit.
pub fn forces_at(control: &Control, basic: &Basic, written: Written) -> Forces {
    let Written { frame, contact } = written;
    let Some(motion) = &basic.motion else { return [None; 2] };
    let level = basic.friction.as_ref().map_or(0.0, Friction::force_scale) * contact.load;
    let force =
        |component: f64, place: usize| component * motion.tangential[place].value * level / 1e3;
    let is_given = [!control.force.is(0), control.force.is(2)];
    [(frame.component_x, 0), (frame.component_y, 1)]
        .map(|(component, place)| is_given[place].then(|| force(component, place)))
}

/// Refuses forces at the friction limit, which no creepage causes.
pub fn check_forces(case: &mut Translation, control: &Control, motion: &Motion) {
    let [x, y] = motion.tangential;
    let size = if control.force.is(2) { x.value.hypot(y.value) } else { x.value.abs() };
    if size >= 1.0 {
        let what = "the force must be less than 1 in size, the friction limit FSTAT FN";
        case.refuse(x, what, "FXREL and FYREL are forces over that limit");
    }
}

/// Creepages of the wheel over the rail at the middle of the contact.
pub fn creepages_at(motion: &Motion, Written { frame, contact }: Written) -> [f64; 2] {
    let [x, y] = at_centre(motion, contact.centre);
    [frame.component_x * x, frame.component_y * y]
}

/// Creepages at a point (in mm) that are given about the spin centre.
fn at_centre(motion: &Motion, centre: [f64; 2]) -> [f64; 2] {
    let from = motion.spin_centre.map_or([0.0; 2], |centre| centre.map(|given| given.value));
    let [x, y] = motion.tangential.map(|given| given.value);
    let spin = motion.spin.value;
    [x - spin * (centre[1] - from[1]), y + spin * (centre[0] - from[0])]
}

/// A shift from a contact without tractions.
fn shift(
    case: &mut Translation,
    control: &Control,
    motion: &Motion,
    (written, [force_x, force_y]): (Written, Forces),
) {
    check_shift(case, control, motion);
    // mm.
    let [x, y] = creepages_at(motion, written);
    match force_x {
        Some(force) => case.document.quantity(field!("kinematics.force_x"), force, "kN"),
        None => case.document.quantity(field!("history.shift_x"), x, "mm"),
    }
    match force_y {
        Some(force) => case.document.quantity(field!("kinematics.force_y"), force, "kN"),
        None => case.document.quantity(field!("history.shift_y"), y, "mm"),
    }
    if motion.spin.value != 0.0 || force_y.is_some() {
        case.document.quantity(field!("history.turn"), motion.spin.value, "rad");
    }
}

/// Refuses what a shift cannot have.
pub fn check_shift(case: &mut Translation, control: &Control, motion: &Motion) {
    if control.previous.is(3) {
        let what = "a shift that is repeated (P = 3) is not available";
        case.refuse(control.previous, what, "P = 0 is a new step");
    }
    if !control.force.is(0) {
        check_forces(case, control, motion);
    }
    if matches!(control.friction_law.whole(), 2..=4) {
        let what =
            "friction that depends on the slip speed is not available in a shift, which has none";
        case.refuse(control.friction_law, what, "L = 0 has constant friction");
    }
}

/// The law of friction, also one that varies across the contact.
fn write_friction(case: &mut Translation, friction: &Friction, frame: Frame, contact: Contact) {
    let digit = friction.variation;
    match (digit.whole(), contact.rows) {
        (0, _) => friction::uniform(case, friction),
        (3, Some([from, width])) => {
            let mut rows = friction.clone();
            let place = |row: usize| frame.coordinate_y * (from + row as f64 * width);
            let mut places: Vec<f64> = (0..rows.sets.len()).map(place).collect();
            if frame.coordinate_y < 0.0 {
                places.reverse();
                rows.sets.reverse();
            }
            friction::varying(case, &rows, (field!("friction.variation_y"), &places, "mm"));
        }
        (3, None) => {
            let what = "friction by row is available for Hertz's contact only";
            case.refuse(digit, what, "V = 0 is the same everywhere");
        }
        _ => {
            let what = "friction over the rail or the track is of two profiles";
            case.refuse(digit, what, "V = 3 is by row, V = 0 the same everywhere");
        }
    }
}

fn extra_slip(case: &mut Translation, basic: &Basic) {
    if let Some(digit) = basic.extra_slip {
        let what = match digit.whole() {
            0 => return,
            2 | 3 => "spin in one direction only is not available",
            _ => "an extra term of the rigid slip (EXRHS) is not available",
        };
        case.refuse(digit, what, "E = 0 is without");
    }
}
