//! Height of a wheel at which its contacts carry the vertical force.
//!
//! The force of each contact with its tractions is, along, across and normal to its plane, so many
//! times the force F of its pressure; resolved, their sum is the vertical force. It grows with the
//! depth d below first touch as some d^1.5, which guides a bracketed search. Contacts in planes of
//! their own raise each other's surfaces by F (n·n′)/(π E* r) at their distance r (Boussinesq
//! 1885).

use std::f64::consts::PI;
use std::sync::Arc;

use super::contact_plane::{ContactPlane, Joining, planes};
use super::gap::Gap;
use super::opening::Opening;
use super::pair::Pair;
use super::pose::{Attitude, Pose, dot, minus};
use super::pressed::Pressed;
use super::pressing::{Accuracy, Pressing, Raised};
use super::virtual_penetration::NormalMethod;
use crate::numerics::root::Bracket;
use crate::reporting::{Error, Watch, WheelRailError};

/// Power of the depth with which the force of a contact grows (Hertz 1882), dimensionless.
const POWER: f64 = 1.5;

/// Largest depth below first touch, in m.
pub(super) const DEEPEST: f64 = 5e-3;

/// Passes in which contacts raise each other's surfaces.
const PASSES: usize = 4;

/// Change of such a rise relative to the depth below which it does not matter, dimensionless.
const NEGLIGIBLE_RISE: f64 = 1e-5;

/// What the tractions of a contact do.
#[derive(Debug, Clone, Default)]
pub(super) struct Tractions {
    /// Where it is in the track, in m.
    pub origin: [f64; 3],
    /// Force along, across (outwards) and normal to the plane over that of the pressure without
    /// them, dimensionless.
    pub force: [f64; 3],
    /// How far they move the surfaces apart, if that changes the pressure.
    pub opening: Option<Arc<Opening>>,
}

/// A wheel above a rail, to be lowered.
pub(super) struct Lowering<'a> {
    pub pair: &'a Pair,
    pub gap: &'a Gap,
    pub attitude: Attitude,
    pub joining: Joining,
    /// E*, in Pa.
    pub contact_modulus: f64,
    /// Combined Poisson's ratio, dimensionless.
    pub poisson_ratio: f64,
    pub method: NormalMethod,
    pub watch: Watch<'a>,
}

/// How the vertical force is expected to depend on the depth below first touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Guess {
    /// Depth at which the contacts carry the load, in m.
    pub depth: f64,
    /// Power of the depth with which the force grows there, dimensionless.
    pub power: f64,
}

/// Contacts at a depth below first touch.
#[derive(Debug, Clone)]
pub(super) struct Lowered {
    /// The depth, and how the force grows there.
    pub at: Guess,
    pub contacts: Vec<Pressed>,
}

impl Guess {
    /// With the power of a contact of smooth bodies (Hertz 1882), at a depth in m.
    pub fn smooth(depth: f64) -> Self {
        Self { depth, power: POWER }
    }
}

impl Lowering<'_> {
    /// Height of first touch, relative to the nominal height, in m.
    pub fn touch(&self) -> f64 {
        self.gap.least().map_or(0.0, |point| -point.gap)
    }

    /// Depth below first touch at a height, in m.
    ///
    /// # Errors
    /// A wheel that does not touch.
    pub fn depth(&self, height: f64) -> Result<f64, Error> {
        let depth = self.touch() - height;
        if depth > 0.0 { Ok(depth) } else { Err(WheelRailError::Lifted { gap: -depth }.into()) }
    }

    /// That of the wheelset.
    pub fn pose(&self, depth: f64) -> Pose {
        self.attitude.at_height(self.pair.nominal_radius, self.touch() - depth)
    }

    /// The contacts at a depth whose surfaces tractions have moved apart.
    pub fn at(
        &self,
        depth: f64,
        tractions: &[Tractions],
        accuracy: Accuracy,
    ) -> Result<Vec<Pressed>, Error> {
        if depth > DEEPEST {
            return Err(WheelRailError::DeepOverlap { depth }.into());
        }
        let regions = self.gap.regions(self.touch() - depth, self.pair.radius_along());
        let how = (&self.joining, self.method == NormalMethod::Conformal);
        let planes = planes(self.pair, &regions, how);
        let pose = self.pair.wheel_in(&self.pose(depth));
        let pressing = Pressing {
            pair: self.pair,
            pose: &pose,
            contact_modulus: self.contact_modulus,
            poisson_ratio: self.poisson_ratio,
            method: self.method,
            watch: self.watch,
        };
        let mut raised = vec![0.0; planes.len()];
        for pass in 1.. {
            let solve = |k: usize| {
                let near = near(&planes[k], tractions);
                let opening = near.and_then(|near| near.opening.as_deref());
                pressing.solve(&planes[k], Raised { everywhere: raised[k], opening }, accuracy)
            };
            let found = (0..planes.len()).map(solve).collect::<Result<Vec<_>, Error>>()?;
            let next: Vec<f64> = planes.iter().map(|plane| self.rise(plane, &found)).collect();
            let change = raised.iter().zip(&next).map(|(one, two)| (one - two).abs());
            if pass >= PASSES || change.fold(0.0, f64::max) <= NEGLIGIBLE_RISE * depth {
                return Ok(found.into_iter().flatten().collect());
            }
            raised = next;
        }
        Ok(Vec::new())
    }

    /// How far the contacts other than that in a plane move the surfaces there apart, in m.
    fn rise(&self, plane: &ContactPlane, found: &[Option<Pressed>]) -> f64 {
        let others = found.iter().flatten().filter(|other| other.plane.origin != plane.origin);
        let rise = |other: &Pressed| {
            let way = minus(plane.origin, other.plane.origin);
            let facing = dot(plane.normal(), other.plane.normal());
            other.force * facing / (PI * self.contact_modulus * dot(way, way).sqrt())
        };
        others.map(rise).sum()
    }

    /// The contacts at a depth that is tried as part of a search.
    pub fn lowered(
        &self,
        at: Guess,
        tractions: &[Tractions],
        accuracy: Accuracy,
    ) -> Result<Lowered, Error> {
        Ok(Lowered { at, contacts: self.at(at.depth, tractions, accuracy)? })
    }

    /// The depth at which contacts carry a vertical force (in N) to a tolerance (dimensionless),
    /// from a guess. The bracket closes whatever the force does; where it jumps over the load, that
    /// is the state at one end of the jump.
    pub fn carrying(
        &self,
        load: f64,
        tractions: &[Tractions],
        guess: Guess,
        (accuracy, tolerance): (Accuracy, f64),
    ) -> Result<Lowered, Error> {
        let mut bracket = Bracket::new([0.0, f64::INFINITY]);
        let mut at = Guess { depth: guess.depth.min(0.5 * DEEPEST), ..guess };
        let mut before: Option<[f64; 2]> = None;
        let mut held: Option<Held> = None;
        let mut least = LEAST_STEP;
        loop {
            let lowered = self.lowered(at, tractions, accuracy)?;
            held = lowered.held(tractions).or(held);
            let depth = at.depth;
            let share = lowered.vertical_force(tractions) / load;
            at.power = local_power([depth, share], before).unwrap_or(at.power);
            bracket.note(depth, share < 1.0);
            let is_closed = bracket.width() <= ROUNDING * depth;
            if (share - 1.0).abs() <= tolerance || is_closed {
                return Ok(Lowered { at, ..lowered });
            }
            if share < 1.0 && depth >= DEEPEST {
                return Err(not_carried(share * load, held));
            }
            before = (share > 0.0).then_some([depth, share]);
            let mut factor = if share > 0.0 { share.powf(-at.power.recip()) } else { FASTEST };
            if share < 1.0 {
                // Until the load is passed, steps do not become too short to pass it.
                factor = factor.max(1.0 + least);
                least *= 2.0;
            }
            at.depth = bracket.next(depth * factor.min(FASTEST)).min(DEEPEST);
        }
    }
}

impl Lowered {
    /// Vertical force of the contacts with given friction, in N.
    pub fn vertical_force(&self, tractions: &[Tractions]) -> f64 {
        self.contacts.iter().map(|contact| contact.force * weight(contact, tractions)).sum()
    }

    /// A contact whose friction lets it carry nothing.
    fn held(&self, tractions: &[Tractions]) -> Option<Held> {
        let mut held = self.contacts.iter().filter(|contact| weight(contact, tractions) <= 0.0);
        let ratio =
            |contact: &Pressed| near(&contact.plane, tractions).map_or(0.0, |near| near.force[1]);
        held.next().map(|contact| (contact.plane.inclination, ratio(contact)))
    }
}

/// Inclination (in rad) of a contact, and its ratio of lateral to normal force.
type Held = (f64, f64);

/// Largest factor by which a depth grows in one step.
const FASTEST: f64 = 3.0;

/// Shortest first step to a larger depth, relative to it; each further one may be twice as long.
const LEAST_STEP: f64 = 1e-7;

/// Width of a bracket relative to the depth below which rounding decides.
const ROUNDING: f64 = 1e-10;

/// The power of the depth with which the force grows: through the last two points (depth in m,
/// force over load) in logarithms.
fn local_power([depth, share]: [f64; 2], before: Option<[f64; 2]>) -> Option<f64> {
    let [depth_before, share_before] = before?;
    let power = (share / share_before).ln() / (depth / depth_before).ln();
    (power.is_finite() && power > LEAST_POWER).then_some(power)
}

/// A force that grows more slowly than this power of the depth is no guide.
const LEAST_POWER: f64 = 0.5;

/// Why no depth carries the load, from the force at the largest one (in N) and from a contact whose
/// friction lets it carry nothing.
fn not_carried(force: f64, held: Option<Held>) -> Error {
    match held {
        Some((angle, ratio)) => WheelRailError::Jammed { angle: angle.abs(), ratio }.into(),
        None => WheelRailError::NotCarried { deepest: DEEPEST, force }.into(),
    }
}

/// Vertical over normal force of a contact, dimensionless.
fn weight(contact: &Pressed, tractions: &[Tractions]) -> f64 {
    let force = near(&contact.plane, tractions).map_or([0.0, 0.0, 1.0], |near| near.force);
    contact.plane.resolved(force)[2]
}

/// Those of the contact nearest to a plane.
fn near<'a>(plane: &ContactPlane, tractions: &'a [Tractions]) -> Option<&'a Tractions> {
    let distance = |of: &Tractions| {
        let away = minus(of.origin, plane.origin);
        dot(away, away)
    };
    tractions.iter().min_by(|one, other| distance(one).total_cmp(&distance(other)))
}
