//! What can be wrong with a wheel on a rail.

use super::Error;
use crate::reporting::{Quantity, messages, readable};

messages! {
    /// Why two profiles and a position give no contacts.
    WheelRailError:

    /// A profile of a wheel or a rail has too few points.
    "few-profile-points" FewPoints {
        /// That of the wheel or of the rail.
        profile: Quantity,
        /// Points that it has, those too close to their neighbours not counted.
        count: usize,
        /// Points that it needs.
        fewest: usize,
    } *profile, |name, words| format!(
        "{name} needs at least {fewest} points that are 0.03 mm apart, got {count}"
    );

    /// A profile that changes along the way has too few sections.
    "few-sections" FewSections {
        /// That of the wheel or of the rail.
        profile: Quantity,
        /// Sections that it has.
        count: usize,
        /// Sections that it needs.
        fewest: usize,
    } *profile, |name, words| format!(
        "{name} needs at least {fewest} sections to change along the way, got {count}"
    );

    /// A section does not fit the others.
    "section" Section {
        /// That of the wheel or of the rail.
        profile: Quantity,
        /// Which one, counted from 1.
        index: usize,
    } *profile, |name, words| format!(
        "section {index} of {name} must be behind the one before it and have as many breaks, at \
         least two of them in a row and ascending, but does not"
    );

    /// A part has no neighbour with which it could be a surface.
    "lonely-part" LonelyPart {
        /// That of the wheel or of the rail.
        profile: Quantity,
        /// Which one, counted from 1.
        part: usize,
        /// Of its section, in m or rad.
        place: f64,
    } *profile, |name, words| format!(
        "part {part} of the section of {name} at {place} must be part of a section beside it, too, but \
         is not"
    );

    /// Sections of a wheel go beyond half a turn, but not around it.
    "part-of-turn" PartOfTurn {
        /// Angles of the first and of the last section, in rad.
        ends: [f64; 2],
    } Quantity::WheelProfile, |name, words| format!(
        "sections of {name} must be within -π and π rad or cover the whole circumference, but are \
         from {} to {} rad", ends[0], ends[1]
    );

    /// The last section of a wheel is not the first one, a turn earlier.
    "open-turn" OpenTurn {
        /// Angle of the last section, in rad.
        place: f64,
    } Quantity::WheelProfile, |name, words| format!(
        "the last section of {name} must be the first one again, which it follows by a turn, but is \
         another one at {place} rad"
    );

    /// A profile has no side on which the other body could touch it.
    "no-running-surface" NoRunningSurface {
        /// That of the wheel or of the rail.
        profile: Quantity,
    } *profile, |name, words| format!(
        "{name}: y does not grow along any part of the profile, so there is no surface for the other \
         body to touch"
    );

    /// A finite radius of a curve with rails that are rollers.
    "rollers-in-curve" RollersInCurve {
        /// Radius of the curve, in m.
        radius: f64,
    } Quantity::CurveRadius, |name, words| format!(
        "{name}: a wheelset on rollers stays where it is and runs in no curve; leave it infinite, got \
         {} m",
        readable(*radius)
    );

    /// Contacts on the curved surface of the rail with an elasticity of plane surfaces.
    "no-curved-surface" NoCurvedSurface {} Quantity::Elasticity, |name, words| format!(
        "{name}: contacts on the curved surface of the rail need half-spaces"
    );

    /// A force element of a wheel with a method that computes fields.
    "method-of-element" MethodOfElement {} Quantity::Method, |name, words| format!(
        "{name}: a force element of a wheel with two profiles takes a method without fields"
    );

    /// A table of contacts of profiles that change along the way, or of a roller.
    "no-contact-table" NoContactTable {} Quantity::RailProfile, |name, words| format!(
        "{name}: a table of contacts is of profiles that do not change along the way, on a rail"
    );

    /// A table of contacts of profiles that do not touch each other.
    "empty-contact-table" EmptyContactTable {} Quantity::RailProfile, |name, words| format!(
        "{name}: wheel and rail do not touch at any place, roll and yaw angle of the table"
    );

    /// A table of contacts of other profiles in other places, or of other bodies.
    "other-contact-table" OtherContactTable {} Quantity::ContactTable, |name, words| format!(
        "{name} must be that of these profiles in these places, of these bodies and of these \
         distances within which contacts share a plane, but is another one"
    );

    /// Numbers that make no table of contacts.
    "bad-contact-table" BadContactTable {} Quantity::ContactTable, |name, words| format!(
        "{name} must have axes of equal steps and finite values, of which forces and sizes are \
         positive"
    );

    /// A force element of a wheel that deviates with a velocity, or on such a rail.
    "moving-deviation" MovingDeviation {} Quantity::WheelDeviation, |name, words| format!(
        "{name}: a force element of a wheel with two profiles takes no velocity of a deviation but \
         those of the rail that are its inputs"
    );

    /// Stresses below a contact on the curved surface of the rail.
    "curved-below" CurvedBelow {} Quantity::Elasticity, |name, words| format!(
        "{name}: stresses below the surface are those of plane half-spaces, which a contact on the \
         curved surface of the rail has not"
    );

    /// Approximate contacts, or those on the curved surface, with profiles that change along the
    /// way.
    "varying-profiles" VaryingProfiles {} Quantity::RailProfile, |name, words| format!(
        "{name}: contacts of profiles that change along the way are those of half-spaces in planes, \
         without another normal.method"
    );

    /// A roller with a profile that changes along the way.
    "varying-roller" VaryingRoller {} Quantity::RailProfile, |name, words| format!(
        "{name}: a roller has the same profile all around, but this one changes along the way"
    );

    /// The wheel is nowhere above the rail.
    "wheel-beside-rail" BesideRail {
        /// Lateral positions of the wheel's profile, in m.
        wheel: [f64; 2],
        /// Lateral positions of the rail's profile, in m.
        rail: [f64; 2],
    } Quantity::LateralPosition, |name, words| {
        let span = |[from, to]: &[f64; 2]| format!("{:.3} to {:.3} mm", 1e3 * from, 1e3 * to);
        format!(
            "{name}: the wheel is beside the rail: from the middle of the track its profile spans {}, \
             the rail's {}",
            span(wheel),
            span(rail)
        )
    };

    /// At the given height the wheel does not touch the rail.
    "wheel-lifted" Lifted {
        /// Least vertical gap to the rail, in m.
        gap: f64,
    } Quantity::WheelsetHeight, |name, words| format!(
        "{name}: at this height the wheel does not touch the rail; the least gap is {} mm",
        readable(1e3 * gap)
    );

    /// Friction holds the wheel at a steep contact angle, whatever the normal force.
    "jammed" Jammed {
        /// Contact angle, outwards, in rad.
        angle: f64,
        /// Lateral over normal force in the contact, dimensionless.
        ratio: f64,
    } Quantity::Load, |name, words| format!(
        "{name}: the wheel is jammed: at a contact angle of {} rad and with a lateral force of {} times \
         the normal one, friction alone holds it, and no normal force carries the load",
        readable(*angle),
        readable(*ratio)
    );

    /// The contact reaches the end of the named profile.
    "contact-at-profile-end" AtProfileEnd {
        /// That of the wheel or of the rail.
        profile: Quantity,
        /// y of its end, outwards from its origin, in m.
        end: f64,
        /// Lateral position of the contact in the track, outwards, in m.
        position: f64,
    } *profile, |name, words| format!(
        "{name}: the contact {:.3} mm from the middle of the track reaches the end of this profile at \
         y = {:.1} mm (outwards from its origin); give a longer profile, or check position and gauge",
        1e3 * position,
        1e3 * end
    );

    /// Wheel and rail would overlap by millimetres: wrong units or gauge?
    "deep-overlap" DeepOverlap {
        /// Depth, in m.
        depth: f64,
    } Quantity::WheelsetHeight, |name, words| format!(
        "{name}: the bodies would overlap by {} mm, which is no elastic contact: check height, gauge \
         and the profiles' units",
        readable(1e3 * depth)
    );

    /// No elastic contact carries the vertical force: wrong units or gauge?
    "load-not-carried" NotCarried {
        /// Depth below first touch at which the search ends, in m.
        deepest: f64,
        /// Vertical force of the contacts there, in N.
        force: f64,
    } Quantity::Load, |name, words| format!(
        "{name}: no elastic contact of these profiles carries it: {} mm below first touch they carry \
         {force:.3e} N; check load, gauge and the profiles' units",
        readable(1e3 * deepest)
    );

    /// No roll angle was found at which both wheels rest.
    "roll-not-settled" RollNotSettled {
        /// Rounds that were made.
        rounds: usize,
        /// Last change of the roll angle, in rad.
        step: f64,
    } Quantity::RollAngle, |name, words| format!(
        "{name}: no roll angle was found in {rounds} rounds at which both wheels carry their \
         forces at one height of the wheelset; the last one changed it by {step:.1e} rad"
    );

    /// No state of the wheel on the rail was found.
    "unsolved-wheel" Unsolved {} Quantity::WheelProfile, |name, words| format!(
        "{name}: no state of the wheel on the rail was found"
    );
}

impl From<WheelRailError> for Error {
    fn from(error: WheelRailError) -> Self {
        Self::WheelRail { error }
    }
}
