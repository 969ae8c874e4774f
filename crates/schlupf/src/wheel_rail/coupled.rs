//! Contacts whose tractions change their pressure: both in turns (Panagiotopoulos 1975) at one
//! height.

use super::equilibrium::{Lowered, Lowering, Tractions};
use super::opening::Opening;
use super::pressing::Accuracy;
use super::sliding::Tangential;
use super::turning::Turning;
use super::wheel::WheelOnRail;
use crate::problem::Options;
use crate::reporting::{Error, Unconverged, Watch};
use crate::solver::settings;
use crate::solver::unlike_bodies::finished;

/// A wheel at a height, and how its contacts are solved.
pub(super) struct Coupling<'a> {
    pub wheel: &'a WheelOnRail,
    pub lowering: &'a Lowering<'a>,
    /// How the tangential problems are posed, and with which options they are solved.
    pub how: (&'a Tangential<'a>, &'a Options),
    pub accuracy: Accuracy,
    /// Of the opening relative to the approach, dimensionless.
    pub tolerance: f64,
    pub watch: Watch<'a>,
}

/// Contacts with tractions that belong to their pressure.
pub(super) struct Coupled {
    pub lowered: Lowered,
    pub turning: Turning,
    pub tractions: Vec<Tractions>,
}

impl Coupling<'_> {
    /// The contacts at the height of those that are lowered; the angular velocity of a driven wheel
    /// is sought from `turned`, in rad/s.
    pub fn solve(&self, mut lowered: Lowered, mut turned: Option<f64>) -> Result<Coupled, Error> {
        let tolerance = self.tolerance;
        for iterations in 1.. {
            let sliding = self.wheel.sliding((self.lowering, &lowered), self.how, self.watch);
            let mut turning = sliding.solve(turned)?;
            let tractions = self.wheel.tractions(&turning.contacts)?;
            let change = change(&lowered, &tractions);
            let is_found = change <= tolerance;
            if is_found || iterations == settings::most_pressures() {
                let missed = Unconverged::Pressure { iterations, change, tolerance };
                turning.told((!is_found).then_some(missed));
                return Ok(Coupled { lowered, turning, tractions });
            }
            turned = turning.nearby();
            lowered = self.lowering.lowered(lowered.at, &tractions, self.accuracy)?;
        }
        Err(Error::Stopped {})
    }
}

impl Turning {
    /// Tells of contacts whose pressure and tractions belong together, or missed it.
    fn told(&mut self, missed: Option<Unconverged>) {
        for (_, problem, solution) in &mut self.contacts {
            let coupling = problem.interface.elasticity.pressure_coupling();
            if let Some(coupling) = coupling.filter(|coupling| coupling.is_mutual) {
                *solution = finished(solution.clone(), missed.clone(), coupling.constant);
            }
        }
    }
}

/// Largest change of an opening where there is pressure, over the approach; dimensionless.
fn change(lowered: &Lowered, tractions: &[Tractions]) -> f64 {
    let mut largest = 0.0_f64;
    for pressed in &lowered.contacts {
        let found = tractions.iter().find(|found| found.y == pressed.plane.origin[1]);
        let opening = found.and_then(|found| found.opening.as_deref());
        let Some(now) = opening.map(|opening: &Opening| opening.sample(&pressed.x, &pressed.s))
        else {
            continue;
        };
        let loaded = now.iter().zip(&pressed.pressure).enumerate().filter(|(_, (_, p))| **p > 0.0);
        let before = |k: usize| pressed.opening.get(k).copied().unwrap_or(0.0);
        let changes = loaded.map(|(k, (now, _))| (now - before(k)).abs() / pressed.approach);
        largest = changes.fold(largest, f64::max);
    }
    largest
}
