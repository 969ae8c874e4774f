//! Forces as a function of the unknown creepages, both without dimension.

use nalgebra::{DMatrix, DVector};

use crate::bodies::Kinematics;
use crate::problem::{Direction, PrescribedForces, Problem};
use crate::reporting::{Error, Watch};
use crate::solution::{Resultant, Solution, Status};
use crate::solver::simplified::EllipticContact;
use crate::solver::{Solver, reference_point, settings};

/// A problem with the forces that it prescribes, in the units in which small creepages and their
/// forces are alike and friction limits both to about one: forces over μ0 N, moments over
/// μ0 N √(ab), and creepages times their initial stiffness over the same. Forces are those on the
/// rail, so that they grow with the creepages.
#[derive(Clone)]
pub(super) struct Scaled {
    /// The problem without the forces.
    pub problem: Problem,
    /// What is prescribed.
    pub prescribed: PrescribedForces,
    /// The normal load, in N.
    pub load: f64,
    /// μ0 N, in N.
    pub limit: f64,
    /// The prescribed forces, dimensionless.
    pub target: DVector<f64>,
    contact: EllipticContact,
    directions: Vec<Direction>,
    /// N or N m per unit of force, and creepage per unit of creepage.
    force_units: Vec<f64>,
    creepage_units: Vec<f64>,
    /// Position of the reference point in the contact frame, x and y in m.
    place: [f64; 2],
}

/// The state at some creepages.
#[derive(Clone)]
pub(super) struct Response {
    /// Dimensionless, as all of these.
    pub creepages: DVector<f64>,
    /// Dimensionless.
    pub forces: DVector<f64>,
    /// ∂(forces)/∂(creepages), dimensionless.
    pub jacobian: DMatrix<f64>,
    pub solution: Solution,
}

impl Response {
    /// Whether it lies on a falling branch: between it and those at rest the path has turned.
    pub fn falls(&self) -> bool {
        self.jacobian.determinant() < 0.0
    }
}

impl Scaled {
    /// # Errors
    /// Those of the normal contact and of Kalker's coefficients.
    pub fn new(problem: &Problem, watch: Watch) -> Result<Self, Error> {
        problem.check()?;
        problem.normal.prepare(None, watch)?;
        let normal = problem.normal.normal_contact(None)?.summary;
        let place = reference_point::place(problem.reference, &normal)?;
        let contact = EllipticContact::of(problem, normal)?;
        let (load, lever) = (contact.normal.load, contact.lever());
        let limit = problem.interface.friction.cold_coefficient() * load;
        let unit = if limit > 0.0 { limit } else { load };
        let wanted = problem.prescribed.under(load);
        let directions: Vec<Direction> = wanted.iter().map(|(direction, _)| *direction).collect();
        let unit_of =
            |direction: &Direction| unit * lever.powi(i32::from(*direction == Direction::Spin));
        let force_units: Vec<f64> = directions.iter().map(unit_of).collect();
        let target = wanted.iter().zip(&force_units).map(|((_, force), unit)| -force / unit);
        let target = DVector::from_iterator(wanted.len(), target);
        let stiffness = |direction: &Direction| {
            contact.linear_force(&direction.unit()).along(*direction).unwrap_or(1.0).abs()
        };
        let pairs = directions.iter().zip(&force_units);
        let creepage_units = pairs.map(|(direction, unit)| unit / stiffness(direction)).collect();
        let (mut given, prescribed) = (problem.clone(), problem.prescribed);
        given.prescribed = PrescribedForces::default();
        Ok(Self {
            problem: given,
            prescribed,
            load,
            limit,
            target,
            contact,
            directions,
            force_units,
            creepage_units,
            place,
        })
    }

    /// Whether friction is μ0 everywhere, whatever the motion.
    pub fn has_uniform_friction(&self) -> bool {
        self.problem.uniform_friction(self.contact.normal.semi_axis_y).is_some()
    }

    /// Number of unknown creepages.
    pub fn count(&self) -> usize {
        self.directions.len()
    }

    /// The motion with the given unknown creepages.
    pub fn motion(&self, creepages: &DVector<f64>) -> Kinematics {
        let mut motion = self.problem.kinematics;
        for (k, direction) in self.directions.iter().enumerate() {
            *direction.creepage_of(&mut motion) = creepages[k] * self.creepage_units[k];
        }
        motion
    }

    /// The unknown creepages of a motion, dimensionless.
    pub fn creepages(&self, motion: &Kinematics) -> DVector<f64> {
        let pairs = self.directions.iter().zip(&self.creepage_units);
        let all = pairs.map(|(direction, unit)| direction.creepage(motion) / unit);
        DVector::from_iterator(self.count(), all)
    }

    /// The problem with another motion and all creepages given.
    pub fn at(&self, kinematics: Kinematics) -> Problem {
        Problem { kinematics, ..self.problem.clone() }
    }

    /// The same with the forces prescribed.
    pub fn from(&self, kinematics: Kinematics) -> Problem {
        Problem { prescribed: self.prescribed, ..self.at(kinematics) }
    }

    /// A first guess of the motion: the linear forces of Kalker's theory that the saturation of
    /// Shen, Hedrick and Elkins (1983), F/(μN) = 1 − (1 − F_linear/(3μN))³, reduces to the
    /// prescribed ones, with the given creepages.
    pub fn guess(&self) -> Kinematics {
        let count = self.count();
        let nothing = self.linear(&self.motion(&DVector::zeros(count)));
        let ratio = self.target.norm();
        let linear = 3.0 * (1.0 - (1.0 - ratio.min(settings::largest_guess())).cbrt());
        let grown = if ratio > 0.0 { linear / ratio } else { 1.0 };
        let mut matrix = DMatrix::zeros(count, count);
        for j in 0..count {
            let mut unit = DVector::zeros(count);
            unit[j] = 1.0;
            matrix.set_column(j, &(self.linear(&self.motion(&unit)) - &nothing));
        }
        let creepages = matrix.lu().solve(&(&self.target * grown - &nothing));
        let motion = self.motion(&creepages.unwrap_or_else(|| DVector::zeros(count)));
        if motion.check().is_ok() { motion } else { self.motion(&DVector::zeros(count)) }
    }

    fn linear(&self, motion: &Kinematics) -> DVector<f64> {
        let at_centre = motion.at(self.place.map(|part| -part));
        let force = self.contact.linear_force(&at_centre).about(self.place);
        self.forces(&force).unwrap_or_else(|| DVector::zeros(self.count()))
    }

    /// Forces in their units; `None` where the method lacks one.
    fn forces(&self, force: &Resultant) -> Option<DVector<f64>> {
        let pairs = self.directions.iter().zip(&self.force_units);
        let all = pairs.map(|(direction, unit)| Some(-force.along(*direction)? / unit));
        Some(DVector::from_vec(all.collect::<Option<Vec<f64>>>()?))
    }

    /// By how much the forces of a state fall short of the prescribed ones, dimensionless; `None`
    /// where the method lacks one.
    pub fn missing(&self, solution: &Solution) -> Option<DVector<f64>> {
        Some(&self.target - self.forces(&solution.force)?)
    }

    /// What is prescribed first, its value, and that which belongs to given forces; in the unit of
    /// the quantity.
    pub fn in_terms(&self, forces: &DVector<f64>) -> Option<(crate::Quantity, [f64; 2])> {
        // The component that is asked for most stands for all.
        let most = self.target.iamax();
        let found = -forces[most] * self.force_units[most];
        let asked = -self.target[most] * self.force_units[most];
        match self.directions[most] {
            Direction::X => self.prescribed.x.map(|force| {
                let (quantity, value) = force.given();
                (quantity, [value, force.in_terms(found, self.load)])
            }),
            Direction::Y => Some((crate::Quantity::ForceY, [asked, found])),
            Direction::Spin => Some((crate::Quantity::MomentZ, [asked, found])),
        }
    }

    /// The state at some creepages with its derivatives; `None` if the wheel does not roll there,
    /// or if the solver does not find it.
    pub fn respond(
        &self,
        creepages: DVector<f64>,
        solver: &mut dyn Solver,
        watch: Watch,
    ) -> Result<Option<Response>, Error> {
        let kinematics = self.motion(&creepages);
        if kinematics.check().is_err() {
            return Ok(None);
        }
        let problem = self.at(kinematics);
        let (solution, slopes) = if solver.has_derivatives() {
            match solver.solve_with_slopes(&problem, &self.directions, watch)? {
                Some((solution, slopes)) => (solution, Some(slopes)),
                None => return Ok(None),
            }
        } else {
            (solver.solve(&problem, watch)?, None)
        };
        let is_found = solution.status == Status::Converged;
        let Some(forces) = self.forces(&solution.force).filter(|_| is_found) else {
            return Ok(None);
        };
        let jacobian = match slopes {
            Some(slopes) => self.jacobian(&slopes),
            None => self.difference(&creepages, solver, watch)?,
        };
        Ok(jacobian.map(|jacobian| Response { creepages, forces, jacobian, solution }))
    }

    fn jacobian(&self, slopes: &[Resultant]) -> Option<DMatrix<f64>> {
        let mut jacobian = DMatrix::zeros(self.count(), self.count());
        for (j, slope) in slopes.iter().enumerate() {
            jacobian.set_column(j, &(self.forces(slope)? * self.creepage_units[j]));
        }
        Some(jacobian)
    }

    /// Central differences.
    fn difference(
        &self,
        creepages: &DVector<f64>,
        solver: &mut dyn Solver,
        watch: Watch,
    ) -> Result<Option<DMatrix<f64>>, Error> {
        let mut jacobian = DMatrix::zeros(self.count(), self.count());
        for j in 0..self.count() {
            let step = settings::difference() * creepages[j].abs().max(1.0);
            let mut ends = [DVector::zeros(self.count()), DVector::zeros(self.count())];
            for (end, step) in ends.iter_mut().zip([step, -step]) {
                let mut there = creepages.clone();
                there[j] += step;
                let kinematics = self.motion(&there);
                if kinematics.check().is_err() {
                    return Ok(None);
                }
                let solution = solver.solve(&self.at(kinematics), watch)?;
                let Some(forces) = self.forces(&solution.force) else { return Ok(None) };
                *end = forces;
            }
            let [more, less] = ends;
            jacobian.set_column(j, &((more - less) / (2.0 * step)));
        }
        Ok(Some(jacobian))
    }

    /// Tangential force prescribed over μ0 N, dimensionless.
    pub fn tangential(&self) -> f64 {
        let forces = self.directions.iter().zip(self.target.iter());
        forces.filter(|(d, _)| **d != Direction::Spin).map(|(_, f)| f * f).sum::<f64>().sqrt()
    }

    /// With all forces reduced by the same part to a largest tangential one over μ0 N; `None` if
    /// that is not exceeded.
    pub fn reduced(&self, largest: f64) -> Option<Self> {
        let ratio = self.tangential();
        let target = &self.target * (largest / ratio);
        (ratio > largest).then(|| Self { target, ..self.clone() })
    }

    /// Whether two states have different motions.
    pub fn are_distinct(&self, one: &Solution, other: &Solution) -> bool {
        let [x, y] = [one, other].map(|state| self.creepages(&state.kinematics));
        (&x - &y).norm() > settings::distinct_motions() * x.norm().max(y.norm())
    }

    /// Whether a method has all forces that are prescribed.
    pub fn has_forces(&self, force: &Resultant) -> bool {
        self.forces(force).is_some()
    }
}
