//! The depth at which the contacts of a wheel carry the vertical force with their own friction.
//!
//! With friction solved at every depth that is tried, the vertical force G(d) = Σ F (cos β + ρ sin
//! β) is a function of the depth d alone. The next depth is that at which the contacts carry the
//! load with the friction tractions ρ of the last one; it is taken as a proposal within a bracket,
//! which closes whatever is proposed. At a steep flange a last digit of ρ counts several times in
//! G, so that G jumps where a row of cells comes into contact, and where contacts join a plane. A
//! bracket that closes on a jump ends with the state that is nearer to the load.

use super::coupled::{Coupled, change};
use super::equilibrium::{DEEPEST, Guess, Lowered, Lowering, Tractions};
use super::pressed::Pressed;
use super::pressing::Accuracy;
use super::sliding::Tangential;
use super::wheel::{Found, NEARLY_SETTLED, Near, SETTLED, WheelOnRail, first_guess};
use crate::numerics::root::Bracket;
use crate::problem::Options;
use crate::reporting::{Error, Unconverged, Watch};
use crate::solver::settings;

/// Share of the tolerance with which a depth is found at given friction, dimensionless.
const SHARE: f64 = 0.2;

/// Width of a bracket, relative to the depth and over the tolerance, within which only a jump
/// changes the force by more than the tolerance; dimensionless.
const NARROW: f64 = 1e-2;

/// Shortest first step to a larger depth, relative to it; each further one is twice as long until
/// the load is passed.
const LEAST_STEP: f64 = 1e-6;

/// Factor by which a depth grows where no depth carries with the friction of the last one.
const DEEPER: f64 = 1.5;

/// Inclination of a contact below which its friction hardly carries, in rad.
const FLAT: f64 = 0.02;

/// What is known before: the friction of contacts, the depth, and the angular velocity of a driven
/// wheel in rad/s.
#[derive(Clone)]
pub(super) struct Start {
    pub tractions: Vec<Tractions>,
    pub guess: Guess,
    /// The angular velocity of a driven wheel, in rad/s.
    pub turned: Option<f64>,
    /// The contacts at the depth of the guess, if they are known.
    pub lowered: Option<Lowered>,
}

/// A wheel that is lowered until it carries a force.
pub(super) struct Settling<'a> {
    pub wheel: &'a WheelOnRail,
    pub lowering: &'a Lowering<'a>,
    pub accuracy: Accuracy,
    /// Of the vertical force, dimensionless.
    pub tolerance: f64,
    /// How the tangential problems are posed, and with which options they are solved.
    pub how: (&'a Tangential<'a>, &'a Options),
    pub watch: Watch<'a>,
}

/// A wheel at a depth, with its friction.
pub(super) struct Settled {
    pub coupled: Coupled,
    /// What a search nearby begins with.
    pub start: Start,
    /// Vertical force over that asked for, minus one; dimensionless.
    pub residual: f64,
    /// Depths at which friction was solved.
    pub rounds: usize,
}

/// Fewest cells, in the direction with fewer of them, on which friction is first estimated.
const FEWEST_CELLS: usize = 8;

/// Accuracy of that estimate, dimensionless.
const ESTIMATE: f64 = 1e-3;

impl WheelOnRail {
    /// The contacts at a height, in m.
    pub(super) fn solve_at(
        &self,
        lowering: &Lowering,
        (height, near): (f64, Option<&Near>),
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<Found, Error> {
        let depth = lowering.depth(height)?;
        let (accuracy, options) = (Accuracy::Cells(self.cells), tangential.searching());
        let how = (tangential, &options);
        let settling = Settling { wheel: self, lowering, accuracy, tolerance: SETTLED, how, watch };
        let known = near.and_then(|near| self.known(near));
        let lowered = match known.filter(|known| known.at.depth == depth) {
            Some(known) => known,
            None => lowering.lowered(Guess::smooth(depth), &[], accuracy)?,
        };
        let coupled = settling.coupled(lowered, near.and_then(|near| near.turned))?;
        self.found(lowering, coupled, 1)
    }

    /// Height and friction in turns, first with coarse cells unless there is a solution nearby.
    pub(super) fn settle(
        &self,
        lowering: &Lowering,
        (force, near): (f64, Option<&Near>),
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<Found, Error> {
        let Options { cells_x, cells_y, .. } = *tangential.options;
        // As wide for their length as those asked for.
        let share = (FEWEST_CELLS as f64 / cells_x.min(cells_y) as f64).clamp(0.5, 1.0);
        let fewer = |count: usize| (share * count as f64).ceil() as usize;
        let coarse = Options {
            cells_x: fewer(cells_x),
            cells_y: fewer(cells_y),
            tolerance: tangential.options.tolerance.max(ESTIMATE),
            keeps_state: false,
            ..tangential.searching()
        };
        let settling = |accuracy: Accuracy, tolerance: f64, options| Settling {
            wheel: self,
            lowering,
            accuracy,
            tolerance,
            how: (tangential, options),
            watch,
        };
        let (from, rounds) = if let Some(near) = near {
            let (tractions, guess) = (near.tractions.clone(), near.lowered.at);
            (Start { tractions, guess, turned: near.turned, lowered: self.known(near) }, 0)
        } else {
            let guess = first_guess(lowering, force);
            let from = Start { tractions: Vec::new(), guess, turned: None, lowered: None };
            let coarse = settling(Accuracy::Coarse, NEARLY_SETTLED, &coarse).find(force, from)?;
            (coarse.start, coarse.rounds)
        };
        let searching = tangential.searching();
        let fine = settling(Accuracy::Cells(self.cells), SETTLED, &searching);
        let Settled { coupled, residual, rounds: more, .. } = fine.find(force, from)?;
        let (mut solution, solvers) = self.found(lowering, coupled, rounds + more)?;
        solution.residual = residual;
        Ok((solution, solvers))
    }

    /// The contacts of a wheel nearby, if it is where this one is.
    fn known(&self, near: &Near) -> Option<Lowered> {
        (near.position == self.position).then(|| near.lowered.clone())
    }
}

impl Settling<'_> {
    /// The depth at which the wheel carries a vertical force, in N.
    ///
    /// # Errors
    /// A wheel that is jammed: that carries less at all depths, down to one at which it cannot be.
    pub fn find(&self, force: f64, mut start: Start) -> Result<Settled, Error> {
        let mut bracket = Bracket::new([0.0, f64::INFINITY]);
        let mut best: Option<Settled> = None;
        let mut rounds = 0;
        loop {
            let coupled = self.next((force, &start), (&bracket, rounds))?;
            let Coupled { lowered, turning, tractions } = &coupled;
            rounds += 1;
            let (tractions, guess, turned) = (tractions.clone(), lowered.at, turning.nearby());
            start = Start { tractions, guess, turned, lowered: None };
            let residual = lowered.vertical_force(&start.tractions) / force - 1.0;
            let depth = lowered.at.depth;
            bracket.note(depth, residual < 0.0);
            // Coarse cells tell how much friction carries; where it hardly does, once is enough.
            let is_told = self.accuracy == Accuracy::Coarse && is_flat(lowered);
            let is_closed = bracket.width() <= NARROW * self.tolerance * depth;
            let is_found = residual.abs() <= self.tolerance || is_told || is_closed;
            let start = start.clone();
            let now = Settled { coupled, start, residual, rounds };
            let nearer = match best.take() {
                Some(best) if best.residual.abs() <= residual.abs() => best,
                _ => now,
            };
            if is_found {
                return Ok(Settled { rounds, ..nearer });
            }
            best = Some(nearer);
        }
    }

    /// The wheel at the next depth.
    fn next(
        &self,
        (force, start): (f64, &Start),
        (bracket, rounds): (&Bracket, usize),
    ) -> Result<Coupled, Error> {
        let how = (self.accuracy, SHARE * self.tolerance);
        let carries = |known: &&Lowered| {
            (known.vertical_force(&start.tractions) / force - 1.0).abs() <= how.1
        };
        let carrying = match start.lowered.as_ref().filter(carries) {
            Some(known) => Ok(known.clone()),
            None => self.lowering.carrying(force, &start.tractions, start.guess, how),
        };
        let [low, high] = bracket.ends();
        let error = match carrying {
            Ok(lowered) => {
                let proposal = lowered.at.depth;
                let least = low * (1.0 + LEAST_STEP * 2_f64.powi(rounds.min(30) as i32));
                let is_open = high.is_infinite();
                let depth = bracket.next(if is_open { proposal.max(least) } else { proposal });
                let is_proposal = depth == proposal;
                let lowered = if is_proposal { lowered } else { self.lowered(depth, start)? };
                return self.solved(lowered, start);
            }
            Err(error) => error,
        };
        if matches!(error, Error::Stopped { .. }) || start.tractions.is_empty() {
            return Err(error);
        }
        // The friction of the last depth lets none carry: that of others may.
        if high.is_finite() {
            return self.solved(self.lowered(bracket.next(f64::NAN), start)?, start);
        }
        let depth = if low > 0.0 { DEEPER * low } else { start.guess.depth };
        if depth > DEEPEST {
            return Err(error);
        }
        let deeper = self.lowered(depth, start).and_then(|lowered| self.solved(lowered, start));
        match deeper {
            Err(Error::Stopped {}) => deeper,
            // What is wrong deep in the rail is due to that.
            deeper => deeper.map_err(|_| error),
        }
    }

    fn lowered(&self, depth: f64, start: &Start) -> Result<Lowered, Error> {
        let at = Guess { depth, ..start.guess };
        self.lowering.lowered(at, &start.tractions, self.accuracy)
    }

    fn solved(&self, lowered: Lowered, start: &Start) -> Result<Coupled, Error> {
        self.coupled(lowered, start.turned)
    }

    /// Pressure and tractions in turns (Panagiotopoulos 1975) at the height of contacts that are
    /// lowered; the angular velocity of a driven wheel is sought from `turned`, in rad/s.
    fn coupled(&self, mut lowered: Lowered, mut turned: Option<f64>) -> Result<Coupled, Error> {
        let tolerance = self.tolerance;
        let mut iterations = 0;
        loop {
            iterations += 1;
            let sliding = self.wheel.sliding((self.lowering, &lowered), self.how, self.watch);
            let mut turning = sliding.solve(turned)?;
            let tractions = self.wheel.tractions(&turning.contacts)?;
            let change = change(&lowered, &tractions);
            let is_found = change <= tolerance;
            if is_found || iterations == settings::most_pressures() {
                let missed = Unconverged::Pressure { iterations, change, tolerance };
                turning.told((!is_found).then_some(&missed));
                return Ok(Coupled { lowered, turning, tractions });
            }
            turned = turning.nearby();
            lowered = self.lowering.lowered(lowered.at, &tractions, self.accuracy)?;
        }
    }
}

/// Whether friction hardly counts in the vertical force.
fn is_flat(lowered: &Lowered) -> bool {
    let lean = |contact: &Pressed| contact.plane.inclination.abs().max(contact.plane.rise.abs());
    lowered.contacts.iter().all(|contact| lean(contact) < FLAT)
}
