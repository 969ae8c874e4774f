//! Prescribed forces over time: in every step, the creepages with which it ends at these forces.
//!
//! Within a step the forces follow the creepages, which last as long as the step, almost linearly
//! until everything slides, and alike from step to step. So the slopes are learnt from step to step
//! (Broyden 1965), and most steps need two or three equilibria instead of one.

use nalgebra::{DMatrix, DVector};

use crate::bodies::Kinematics;
use crate::normal::NormalSummary;
use crate::problem::{Direction, History, PrescribedForces, Problem};
use crate::reporting::{Error, ForceError, Quantity};
use crate::solution::Resultant;
use crate::solver::equilibrium::measure;
use crate::solver::settings;
use crate::solver::simplified::EllipticContact;

/// The forces, and the creepages that they cause in the present step.
#[derive(Debug, Clone)]
pub(super) struct ForceControl {
    prescribed: PrescribedForces,
    directions: Vec<Direction>,
    /// Position of the reference point in the contact frame, x and y in m.
    place: [f64; 2],
    /// N or N m per unit of force: μ0 N, and times √(ab); and creepage per unit of creepage, with
    /// which Kalker's slopes are one.
    force_units: Vec<f64>,
    creepage_units: Vec<f64>,
    /// Creepages, in their units.
    creepages: DVector<f64>,
    /// ∂(forces)/∂(creepages) at the end of a step, in their units.
    slopes: DMatrix<f64>,
    /// Creepages of the last step that ended at its forces, and the slopes before any step.
    reached: DVector<f64>,
    /// Their change over that step, if it was more than noise and the step before was one, too.
    trend: DVector<f64>,
    /// Whether the last step was one.
    has_reached: bool,
    first_slopes: DMatrix<f64>,
    /// Creepages and missing forces of the trial before.
    before: Option<(DVector<f64>, DVector<f64>)>,
    trials: usize,
    /// Missing forces in their units, dimensionless.
    pub missing: f64,
}

/// Refuses tangential forces of at least μN, if friction is the same everywhere.
fn refuse_beyond_friction(
    problem: &Problem,
    forces: &PrescribedForces,
    (load, width): (f64, f64),
) -> Result<(), Error> {
    let Some(friction) = problem.uniform_friction(width) else { return Ok(()) };
    let [x, y] = [forces.x.map_or(0.0, |force| force.under(load)), forces.y.unwrap_or(0.0)];
    let ratio = x.hypot(y) / (friction * load);
    if ratio < 1.0 {
        return Ok(());
    }
    let (quantity, value, largest) = match forces.x.filter(|_| x.abs() >= y.abs()) {
        Some(force) => {
            let (quantity, value) = force.given();
            (quantity, value, force.in_terms(x / ratio, load))
        }
        None => (Quantity::ForceY, y, y / ratio),
    };
    let (limit, has_others) = (Some(friction * load), forces.x.is_some() && forces.y.is_some());
    Err(ForceError::Unreachable { quantity, value, largest, limit, has_others }.into())
}

impl ForceControl {
    /// That of a problem and a history, if forces are prescribed: about a reference point at
    /// `place`, in time steps over a path (both in m).
    ///
    /// # Errors
    /// Those of Kalker's coefficients.
    pub fn of(
        problem: &Problem,
        (prescribed, history): (&PrescribedForces, &History),
        normal: &NormalSummary,
        (place, path): ([f64; 2], f64),
    ) -> Result<Option<Self>, Error> {
        let prescribed = history.prescribed(history.span()[0], prescribed);
        if prescribed.is_none() {
            return Ok(None);
        }
        let contact = EllipticContact::of(problem, *normal)?;
        let (load, lever) = (normal.load, contact.lever());
        for time in &history.time {
            let load = history.load(*time).unwrap_or(load);
            let forces = history.prescribed(*time, &prescribed);
            let at_time = |error| Error::AtTime { error: Box::new(error), time: *time };
            refuse_beyond_friction(problem, &forces, (load, normal.semi_axis_y))
                .map_err(at_time)?;
        }
        let directions: Vec<Direction> =
            prescribed.under(load).iter().map(|(direction, _)| *direction).collect();
        let limit = problem.interface.friction.cold_coefficient() * load;
        let limit = if limit > 0.0 { limit } else { load };
        let unit = |of: &Direction| limit * if *of == Direction::Spin { lever } else { 1.0 };
        let force_units: Vec<f64> = directions.iter().map(unit).collect();
        let stiffness =
            |of: &Direction| contact.linear_force(&of.unit()).along(*of).unwrap_or(1.0).abs();
        let pairs = directions.iter().zip(&force_units);
        let creepage_units = pairs.map(|(of, unit)| unit / stiffness(of)).collect();
        let count = directions.len();
        // Kalker's slopes take the passage of the patch.
        let of_step = (path / normal.semi_axis_x).min(1.0);
        let first_slopes = DMatrix::identity(count, count) * of_step;
        Ok(Some(Self {
            prescribed,
            directions,
            place,
            force_units,
            creepage_units,
            creepages: DVector::zeros(count),
            slopes: first_slopes.clone(),
            reached: DVector::zeros(count),
            trend: DVector::zeros(count),
            has_reached: false,
            first_slopes,
            before: None,
            trials: 0,
            missing: 0.0,
        }))
    }

    /// A motion at the centre of the patch with the present creepages.
    pub fn motion(&self, given: &Kinematics) -> Kinematics {
        let mut motion = given.at(self.place);
        for (k, direction) in self.directions.iter().enumerate() {
            *direction.creepage_of(&mut motion) = self.creepages[k] * self.creepage_units[k];
        }
        motion.at(self.place.map(|part| -part))
    }

    /// Prepares a step that ends at a time, in s: the creepages go on to change. After one whose
    /// forces no creepage causes the search goes on from the last that had its forces.
    pub fn begin(&mut self, history: &History, time: f64) {
        if self.trials >= settings::most_trials() {
            self.creepages.copy_from(&self.reached);
            self.slopes.copy_from(&self.first_slopes);
            self.trend.fill(0.0);
            self.has_reached = false;
        }
        let mut change = self.trend.clone();
        self.keep_possible(&mut change);
        self.creepages += change;
        self.prescribed = history.prescribed(time, &self.prescribed);
        (self.before, self.trials) = (None, 0);
    }

    /// What is prescribed first, if the last step did not end with its forces.
    pub fn missed(&self) -> Option<Quantity> {
        self.prescribed.first().filter(|_| self.trials >= settings::most_trials())
    }

    /// Compares the forces of a trial with those prescribed under a load in N, to an accuracy
    /// relative to the bounds ‖μ pₙ‖₂ and the tractions ‖p‖₂ (in Pa). Returns whether the step is
    /// done; if not, the creepages are those of the next trial.
    pub fn is_reached(
        &mut self,
        (force, load): (&Resultant, f64),
        (accuracy, bound, traction): (f64, f64, f64),
    ) -> bool {
        let force = force.about(self.place);
        let wanted = self.prescribed.under(load);
        let missing = wanted.iter().zip(&self.force_units).map(|((direction, wanted), unit)| {
            // On the rail, so that the slopes are positive.
            (force.along(*direction).unwrap_or(0.0) - wanted) / unit
        });
        let missing = DVector::from_iterator(wanted.len(), missing);
        let size = wanted.iter().zip(&self.force_units).map(|((_, wanted), unit)| wanted / unit);
        let size = size.fold(0.0_f64, f64::hypot).min(1.0);
        let share = if bound > 0.0 { measure(bound, traction) / bound } else { 1.0 };
        self.missing = missing.norm();
        self.trials += 1;
        let allowed = accuracy * size.max(share);
        if self.missing <= allowed {
            self.trials = self.trials.min(settings::most_trials() - 1);
            self.trend = &self.creepages - &self.reached;
            if !self.has_reached || (&self.slopes * &self.trend).norm() <= allowed {
                self.trend.fill(0.0);
            }
            self.has_reached = true;
            self.reached.copy_from(&self.creepages);
            return true;
        }
        if self.trials >= settings::most_trials() {
            return true;
        }
        self.learn(&missing);
        let mut change =
            self.slopes.clone().lu().solve(&missing).unwrap_or_else(|| missing.clone());
        let longest = settings::longest_trial() * self.creepages.norm().max(1.0);
        if change.norm() > longest {
            change *= longest / change.norm();
        }
        self.keep_possible(&mut change);
        self.before = Some((self.creepages.clone(), missing));
        self.creepages += change;
        false
    }

    /// Shortens a change of the creepages with which the wheel would lock, turn backwards or turn
    /// many times as fast as it rolls.
    fn keep_possible(&self, change: &mut DVector<f64>) {
        let mut part = 1.0_f64;
        for (k, direction) in self.directions.iter().enumerate() {
            let bounds = match direction {
                Direction::X => [-settings::spinning(), settings::locking()],
                Direction::Y => [-settings::locking(), settings::locking()],
                Direction::Spin => continue,
            };
            let unit = self.creepage_units[k];
            let next = (self.creepages[k] + change[k]) * unit;
            let bound = if next > bounds[1] { bounds[1] } else { next.max(bounds[0]) };
            if bound != next {
                part = part.min((bound / unit - self.creepages[k]) / change[k]);
            }
        }
        *change *= part.max(0.0);
    }

    /// Corrects the slopes by what the last change of the creepages did.
    fn learn(&mut self, missing: &DVector<f64>) {
        let Some((creepages, before)) = &self.before else { return };
        let change = &self.creepages - creepages;
        let squared = change.norm_squared();
        if squared > 0.0 {
            let unforeseen = before - missing - &self.slopes * &change;
            let corrected = &self.slopes + unforeseen * change.transpose() / squared;
            if corrected.determinant().is_finite() && corrected.determinant() > 0.0 {
                self.slopes = corrected;
            }
        }
    }
}
