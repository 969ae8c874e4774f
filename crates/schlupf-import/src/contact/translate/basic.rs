//! A case of module 3.

use std::sync::Arc;

use schlupf_case::Source;

use crate::contact::basic::{Basic, Motion, Rolling};
use crate::contact::control::Control;
use crate::contact::friction::Friction;

use super::case::Translation;
use super::frame::{Frame, WheelBody};
use super::laws;
use super::normal::{self, Contact, Given3};

/// Speed of what does not roll, in mm/s: irrelevant there, but every case has one.
const RESTING: f64 = 1e3;

/// Translates a steady state or a shift; `stem` begins the names of its files.
pub fn translate(
    source: &Arc<Source>,
    (control, basic): (&Control, &Basic),
    wheel: WheelBody,
    stem: &str,
) -> Translation {
    let mut case = Translation::new(source);
    write(&mut case, (control, basic), wheel, stem);
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

/// Writes all but the history of transient rolling.
pub fn write(
    case: &mut Translation,
    (control, basic): (&Control, &Basic),
    wheel: WheelBody,
    stem: &str,
) -> Option<Written> {
    laws::refuse_digits(case, control);
    let rolling = control.is_rolling().then_some(basic.rolling.as_ref()).flatten();
    let frame = frame(case, control, rolling, wheel);
    if let Some(elastic) = &basic.elastic {
        laws::elastic(case, elastic, wheel);
        laws::method(case, control, elastic);
    } else {
        case.miss(control.influence, "the materials");
    }
    laws::heat(case, control, basic.heat.as_ref(), wheel);
    if let Some(friction) = &basic.friction {
        laws::friction(case, friction);
        variation(case, friction);
    } else {
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
    let given = Given3 { control, motion, elastic, area, frame };
    let contact = normal::write(case, given, basic, stem)?;
    speed(case, rolling);
    motion_of(case, control, motion, basic.friction.as_ref(), Written { frame, contact });
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
    let speed = rolling.map_or(RESTING, |rolling| rolling.speed.value);
    // mm/s.
    case.document.quantity("kinematics.speed", speed / 1e3, "m/s");
}

/// Creepages, forces or a shift.
fn motion_of(
    case: &mut Translation,
    control: &Control,
    motion: &Motion,
    friction: Option<&Friction>,
    written: Written,
) {
    match control.tangential.whole() {
        0 => case.remark("Without creepage there are no tangential tractions (T = 0)."),
        1 => shift(case, control, motion, written.frame),
        2 => case.refuse(
            control.tangential,
            "transient rolling is not available",
            "T = 3 rolls steadily",
        ),
        _ => creepages(case, control, motion, friction, written),
    }
}

fn creepages(
    case: &mut Translation,
    control: &Control,
    motion: &Motion,
    friction: Option<&Friction>,
    Written { frame, contact }: Written,
) {
    let [x, y] = at_centre(motion, contact.centre);
    let spin = 1e3 * motion.spin.value;
    let level = friction.map_or(0.0, Friction::static_coefficient) * contact.load;
    if control.force.is(0) {
        case.document.number("kinematics.creepage_x", frame.component_x * x);
    } else {
        let force = frame.component_x * motion.tangential[0].value * level;
        case.document.quantity("kinematics.force_x", force / 1e3, "kN");
        prescribed(case, motion, contact);
    }
    if control.force.is(2) {
        let force = frame.component_y * motion.tangential[1].value * level;
        case.document.quantity("kinematics.force_y", force / 1e3, "kN");
    } else {
        case.document.number("kinematics.creepage_y", frame.component_y * y);
    }
    case.document.quantity("kinematics.spin", spin, "1/m");
    if contact.centre != [0.0; 2] {
        case.remark(format!(
            "Creepages are those at the middle of the contact, which is at ({}, {}) mm in the input; the \
             moment is taken about it, too.",
            crate::document::number(contact.centre[0]),
            crate::document::number(contact.centre[1])
        ));
    }
}

/// Forces in the frame of a contact.
fn prescribed(case: &mut Translation, motion: &Motion, _contact: Contact) {
    let [x, _] = motion.tangential;
    if x.value.abs() > 1.0 {
        case.refuse(x, "must be at most 1, the friction limit", "");
    }
}

/// Creepages at a point (in mm) that are given about the spin centre.
fn at_centre(motion: &Motion, centre: [f64; 2]) -> [f64; 2] {
    let from = motion.spin_centre.map_or([0.0; 2], |centre| centre.map(|given| given.value));
    let [x, y] = motion.tangential.map(|given| given.value);
    let spin = motion.spin.value;
    [x - spin * (centre[1] - from[1]), y + spin * (centre[0] - from[0])]
}

/// A shift from a contact without tractions.
fn shift(case: &mut Translation, control: &Control, motion: &Motion, frame: Frame) {
    if control.previous.value < 2.0 {
        let what = "a shift that goes on from an earlier one is not available";
        case.refuse(control.previous, what, "P = 2 begins without tractions");
    }
    if !control.force.is(0) {
        let what = "forces in a shift are not available";
        case.refuse(control.force, what, "F = 0 gives the shift CKSI, CETA");
        return;
    }
    let what = "a turn in a shift is not available";
    case.refuse_unless_zero(motion.spin, what, "CPHI = 0 shifts without it");
    if matches!(control.friction_law.whole(), 2..=4) {
        let what =
            "friction that depends on the slip speed is not available in a shift, which has none";
        case.refuse(control.friction_law, what, "L = 0 has constant friction");
    }
    let [x, y] = motion.tangential.map(|given| given.value);
    // mm.
    case.document.quantity("history.shift_x", frame.component_x * x, "mm");
    case.document.quantity("history.shift_y", frame.component_y * y, "mm");
}

fn variation(case: &mut Translation, friction: &Friction) {
    if !friction.variation.is(0) {
        let what = "friction that varies with the place is not taken over";
        case.refuse(
            friction.variation,
            what,
            "friction.variation_y and variation_factor of a case file vary it across the patch",
        );
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
