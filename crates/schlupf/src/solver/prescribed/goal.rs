//! Prescribed forces as the goal of any search: which creepages are free, and what the forces that
//! they cause are still short of.
//!
//! Both are without dimension, in units in which small creepages and their forces are alike and
//! friction limits both to about one: forces over μ0 N, moments over μ0 N √(ab), and creepages
//! times their initial stiffness (Kalker 1967) over the same. Forces are those on the rail, so that
//! they grow with the creepages.

use nalgebra::{DMatrix, DVector};

use crate::bodies::Kinematics;
use crate::normal::NormalSummary;
use crate::problem::{Direction, PrescribedForces, Problem};
use crate::reporting::{Error, ForceError, Quantity};
use crate::solution::Resultant;
use crate::solver::settings;
use crate::solver::simplified::EllipticContact;

/// The forces that a contact is to have by its free creepages.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ForceGoal {
    prescribed: PrescribedForces,
    /// The forces that are wanted, dimensionless.
    pub target: DVector<f64>,
    free: Vec<FreeCreepage>,
    /// Position of the reference point of creepages and moment from where motions and forces are
    /// given, x and y in m.
    place: [f64; 2],
    /// Normal load, in N.
    load: f64,
    /// μ0, dimensionless.
    friction: f64,
}

/// A free creepage, with what one unit of it and of its force is.
#[derive(Debug, Clone, Copy, PartialEq)]
struct FreeCreepage {
    direction: Direction,
    /// In N or N m.
    force_unit: f64,
    /// Dimensionless or in 1/m.
    creepage_unit: f64,
}

impl ForceGoal {
    /// That of a normal contact of a problem, whose reference point is at `place` (x and y in m)
    /// from where motions and forces are given.
    ///
    /// # Errors
    /// Those of Kalker's coefficients.
    pub fn new(
        problem: &Problem,
        prescribed: &PrescribedForces,
        (normal, place): (&NormalSummary, [f64; 2]),
    ) -> Result<Self, Error> {
        if prescribed.is_none() {
            return Ok(Self::default());
        }
        let contact = EllipticContact::of(problem, *normal)?;
        let friction = problem.interface.friction.cold_coefficient();
        let unit = normal.load * positive(friction);
        let free = |(direction, _): (Direction, f64)| {
            let stiffness = contact.linear_force(&direction.unit()).along(direction);
            let force_unit =
                unit * if direction == Direction::Spin { contact.lever() } else { 1.0 };
            let creepage_unit = force_unit / stiffness.unwrap_or(1.0).abs();
            FreeCreepage { direction, force_unit, creepage_unit }
        };
        let free = prescribed.under(normal.load).into_iter().map(free).collect();
        Ok(Self { free, place, friction, ..Self::default() }.with(prescribed, normal.load))
    }

    /// The same creepages with other forces under a load, in N.
    pub fn with(&self, prescribed: &PrescribedForces, load: f64) -> Self {
        let forces = prescribed.under(load);
        let pairs = forces.iter().zip(&self.free);
        let target = pairs.map(|((_, force), free)| -force / free.force_unit);
        let target = DVector::from_iterator(self.count(), target);
        Self { prescribed: *prescribed, target, load, ..self.clone() }
    }

    /// Whether all creepages are given.
    pub fn is_none(&self) -> bool {
        self.free.is_empty()
    }

    /// Number of free creepages.
    pub fn count(&self) -> usize {
        self.free.len()
    }

    /// What is prescribed.
    pub fn prescribed(&self) -> &PrescribedForces {
        &self.prescribed
    }

    /// The motion that has the given creepages where they are free.
    pub fn motion(&self, given: &Kinematics, creepages: &[f64]) -> Kinematics {
        let mut motion = given.at(self.place);
        for (free, creepage) in self.free.iter().zip(creepages) {
            *free.direction.creepage_of(&mut motion) = creepage * free.creepage_unit;
        }
        motion.at(self.place.map(|part| -part))
    }

    /// The free creepages of a motion, dimensionless.
    pub fn creepages(&self, motion: &Kinematics) -> DVector<f64> {
        let motion = motion.at(self.place);
        let creepage = |free: &FreeCreepage| free.direction.creepage(&motion) / free.creepage_unit;
        DVector::from_iterator(self.count(), self.free.iter().map(creepage))
    }

    /// The changes of the motion by one unit of each free creepage.
    pub fn changes(&self) -> Vec<Kinematics> {
        let change = |number: usize| {
            let unit = |k: usize| if k == number { 1.0 } else { 0.0 };
            let units: Vec<f64> = (0..self.count()).map(unit).collect();
            self.motion(&Kinematics::free_rolling(0.0), &units)
        };
        (0..self.count()).map(change).collect()
    }

    /// The forces that belong to free creepages, dimensionless; `None` where a method lacks one.
    pub fn forces(&self, force: &Resultant) -> Option<DVector<f64>> {
        let force = force.about(self.place);
        let along = |free: &FreeCreepage| Some(-force.along(free.direction)? / free.force_unit);
        let all = self.free.iter().map(along).collect::<Option<Vec<f64>>>()?;
        Some(DVector::from_vec(all))
    }

    /// ∂(forces)/∂(free creepages), dimensionless, from the derivatives by [`Self::changes`].
    pub fn jacobian(&self, slopes: &[Resultant]) -> Option<DMatrix<f64>> {
        let columns = slopes.iter().map(|slope| self.forces(slope)).collect::<Option<Vec<_>>>()?;
        Some(DMatrix::from_columns(&columns))
    }

    /// What the tractions of cells of a norm (in Pa) under p = pₙ count as one unit of force, in
    /// Pa: a change of all of them by a share of μ0 pₙ changes the forces by that share.
    pub fn unit_of_traction(&self, pressure: f64) -> f64 {
        pressure * positive(self.friction)
    }

    /// A first guess of the motion, with the creepages that are given, by Kalker's linear theory
    /// with a saturation. Motions and forces are at a place in the contact frame, x and y in m.
    pub fn guess(
        &self,
        problem: &Problem,
        (normal, place): (&NormalSummary, [f64; 2]),
    ) -> Result<Kinematics, Error> {
        let contact = EllipticContact::of(problem, *normal)?;
        let linear = |motion: &Kinematics| {
            let force = contact.linear_force(&motion.at(place.map(|part| -part)));
            self.forces(&force.about(place)).unwrap_or_else(|| &self.target * 0.0)
        };
        let at_rest = self.motion(&problem.kinematics, &vec![0.0; self.count()]);
        let ratio = self.target.norm();
        let grown = if ratio > 0.0 { linear_share(ratio) / ratio } else { 1.0 };
        let columns: Vec<_> = self.changes().iter().map(linear).collect();
        let wanted = &self.target * grown - linear(&at_rest);
        let creepages = DMatrix::from_columns(&columns).lu().solve(&wanted);
        let guess = creepages.map(|guess| self.motion(&at_rest, guess.as_slice()));
        Ok(guess.filter(|motion| motion.check().is_ok()).unwrap_or(at_rest))
    }

    /// Tangential force over μ0 N, dimensionless; over N without friction.
    fn tangential(&self) -> f64 {
        let parts = self.free.iter().zip(self.target.iter());
        let forces = parts.filter(|(free, _)| free.direction != Direction::Spin);
        let force = forces.map(|(free, part)| (free.force_unit * part).powi(2)).sum::<f64>().sqrt();
        force / (self.load * positive(self.friction))
    }

    /// Refuses tangential forces of the limit of friction and beyond, which need no search.
    pub fn refuse_beyond_friction(&self) -> Result<(), Error> {
        let missed = self.reduced().map(|nearest| self.missed(&nearest.target, (true, true)));
        missed.map_or(Ok(()), |missed| Err(missed.into()))
    }

    /// With all forces reduced by the same part to the limit of friction; `None` if that is not
    /// reached.
    pub fn reduced(&self) -> Option<Self> {
        let ratio = self.tangential();
        (ratio >= 1.0).then(|| Self { target: &self.target / ratio, ..self.clone() })
    }

    /// Why the forces are not reached where others are the nearest: because these are the largest
    /// (with friction of a fixed limit or not), or because the search has ended before.
    pub fn missed(
        &self,
        nearest: &DVector<f64>,
        (are_largest, has_limit): (bool, bool),
    ) -> ForceError {
        let (quantity, [value, nearest]) = self.in_terms(nearest);
        if !are_largest || nearest.abs() > value.abs() {
            return ForceError::NotFound { quantity, value, nearest };
        }
        let (largest, limit) = (nearest, has_limit.then_some(self.friction * self.load));
        let has_others = self.count() > 1;
        ForceError::Unreachable { quantity, value, largest, limit, has_others }
    }

    /// The quantity that is asked for most, its value, and that which belongs to given forces, in
    /// the unit of the quantity.
    fn in_terms(&self, forces: &DVector<f64>) -> (Quantity, [f64; 2]) {
        let most = self.target.iamax();
        let free = &self.free[most];
        let [asked, found] = [&self.target, forces].map(|f| -f[most] * free.force_unit);
        match (free.direction, self.prescribed.x) {
            (Direction::X, Some(force)) => {
                let (quantity, value) = force.given();
                (quantity, [value, force.in_terms(found, self.load)])
            }
            (Direction::Spin, _) => (Quantity::MomentZ, [asked, found]),
            (Direction::X | Direction::Y, _) => (Quantity::ForceY, [asked, found]),
        }
    }
}

/// A coefficient of friction (dimensionless); one where there is none.
fn positive(friction: f64) -> f64 {
    if friction > 0.0 { friction } else { 1.0 }
}

/// F_linear/(μN) of the share F/(μN) to which the saturation of Shen, Hedrick and Elkins (1983)
/// reduces it, F/(μN) = 1 − (1 − F_linear/(3μN))³; both dimensionless.
pub(crate) fn linear_share(share: f64) -> f64 {
    3.0 * (1.0 - (1.0 - share.min(settings::largest_guess())).cbrt())
}
