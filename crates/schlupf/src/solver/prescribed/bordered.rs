//! Prescribed forces and tractions as one equilibrium: besides the tractions the free creepages are
//! unknown, and besides F(p, ξ) = 0 the forces are to be those of the goal.
//!
//! The Jacobian is that of the tractions with a border of a row and a column for each creepage: the
//! forces are sums of tractions, and ∂F/∂ξ is known in closed form. Neither costs a product, so the
//! creepages come at the price of the few more directions that the Krylov method needs.

use nalgebra::{DMatrix, DVector};

use crate::bodies::Kinematics;
use crate::normal::patch::Patch;
use crate::numerics::vector::{add_scaled, norm};
use crate::reporting::{Error, Watch};
use crate::solver::equilibrium::{Directions, Equilibrium, Limits, Newton, Outcome};
use crate::solver::{settings, summary};

use super::goal::ForceGoal;

/// An equilibrium of a motion, given at the centre of the patch.
pub(crate) trait MovedEquilibrium: Equilibrium {
    /// The patch of the tractions.
    fn patch(&self) -> &Patch;

    /// Switches to another motion.
    fn set_motion(&mut self, motion: &Kinematics);

    /// Change of F (in Pa) at the p of the last residual when the motion changes.
    fn change_by_motion(&mut self, change: &Kinematics, of_residual: &mut [f64]);
}

/// The tractions p (in Pa), in place, and the motion that they have with the forces of a goal.
/// Without forces it is the one that is given, as it is where Newton's method fails.
pub(crate) fn solve(
    newton: &mut Newton,
    system: &mut impl MovedEquilibrium,
    (goal, motion): (&ForceGoal, &mut Kinematics),
    p: &mut Vec<f64>,
    (limits, watch): (&Limits, Watch),
) -> Result<Outcome, Error> {
    if goal.is_none() {
        return Ok(newton.solve(system, p, limits, watch)?.outcome);
    }
    let size = p.len();
    let mut bordered = Bordered::new(system, goal, motion);
    p.extend_from_slice(&bordered.at);
    let solved = newton.solve(&mut bordered, p, limits, watch).map(|solved| solved.outcome);
    let found = bordered.motion(&p[size..]);
    p.truncate(size);
    let mut outcome = solved?;
    outcome.converged &= found.check().is_ok();
    if outcome.converged {
        *motion = found;
    }
    Ok(outcome)
}

/// The unknowns are p, and after it the free creepages times a unit of traction, in Pa.
struct Bordered<'a, E> {
    system: &'a mut E,
    goal: &'a ForceGoal,
    given: Kinematics,
    /// Pa for each unit of force and creepage.
    unit: f64,
    /// The free creepages (in Pa) at which the system is.
    at: Vec<f64>,
    /// ∂F/∂(creepage in Pa), dimensionless, and what the preconditioner makes of it.
    columns: Vec<Vec<f64>>,
    images: Vec<Vec<f64>>,
    /// Inverse of the matrix by which the forces (in Pa) change with the creepages (in Pa), by the
    /// preconditioner.
    inverse: DMatrix<f64>,
    /// Whether all these are those of the last residual.
    has_border: bool,
}

impl<'a, E: MovedEquilibrium> Bordered<'a, E> {
    /// With the motion of the system.
    fn new(system: &'a mut E, goal: &'a ForceGoal, motion: &Kinematics) -> Self {
        let pressures: Vec<f64> = system.patch().cells.iter().map(|cell| cell.pressure).collect();
        let unit = goal.unit_of_traction(norm(&pressures));
        let (count, size) = (goal.count(), system.size());
        Self {
            at: (goal.creepages(motion) * unit).as_slice().to_vec(),
            system,
            goal,
            given: *motion,
            unit,
            columns: vec![vec![0.0; size]; count],
            images: Vec::new(),
            inverse: DMatrix::identity(count, count),
            has_border: false,
        }
    }

    /// The motion at the centre of the patch with free creepages in Pa.
    fn motion(&self, unknowns: &[f64]) -> Kinematics {
        let creepages: Vec<f64> = unknowns.iter().map(|unknown| unknown / self.unit).collect();
        self.goal.motion(&self.given, &creepages)
    }

    /// The forces of tractions, in Pa.
    fn forces(&self, traction: &[f64]) -> DVector<f64> {
        let force = summary::resultant(self.system.patch(), traction);
        self.goal
            .forces(&force)
            .map_or_else(|| &self.goal.target * 0.0, |forces| forces * self.unit)
    }

    /// What belongs to the cells, and what to the creepages.
    fn parts<'v>(&self, values: &'v [f64]) -> (&'v [f64], &'v [f64]) {
        values.split_at(values.len() - self.goal.count())
    }

    /// Moves the system to other creepages, unless no wheel has them.
    fn move_to(&mut self, unknowns: &[f64]) -> bool {
        if self.at == unknowns {
            return true;
        }
        let motion = self.motion(unknowns);
        let is_possible = motion.check().is_ok() && motion.creepage_x >= -settings::spinning();
        if is_possible {
            self.at.copy_from_slice(unknowns);
            self.system.set_motion(&motion);
        }
        is_possible
    }

    fn find_border(&mut self) {
        if std::mem::replace(&mut self.has_border, true) {
            return;
        }
        for (change, column) in self.goal.changes().iter().zip(&mut self.columns) {
            self.system.change_by_motion(change, column);
            for entry in column.iter_mut() {
                *entry /= self.unit;
            }
        }
        self.images.clone_from(&self.columns);
        for image in &mut self.images {
            self.system.precondition(image);
        }
        let columns: Vec<_> = self.images.iter().map(|image| -self.forces(image)).collect();
        self.inverse = regular_inverse(&DMatrix::from_columns(&columns));
    }
}

/// The inverse of a matrix that is about the identity where the contact sticks; with something
/// added to its diagonal where that makes it regular.
fn regular_inverse(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let count = matrix.nrows();
    let least = settings::least_creep_stiffness();
    let shifted = |share: f64| (matrix + share * DMatrix::identity(count, count)).try_inverse();
    let is_regular = |inverse: &DMatrix<f64>| inverse.iter().all(|part| part.abs() < least.recip());
    let inverse = [0.0, least, 1.0].into_iter().filter_map(shifted).find(is_regular);
    inverse.unwrap_or_else(|| DMatrix::identity(count, count))
}

impl<E: MovedEquilibrium> Equilibrium for Bordered<'_, E> {
    fn size(&self) -> usize {
        self.system.size() + self.goal.count()
    }

    fn response_size(&self) -> usize {
        self.system.response_size() + self.goal.count()
    }

    fn scale(&self, p: &[f64]) -> f64 {
        self.system.scale(self.parts(p).0)
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        let (p, unknowns) = self.parts(p);
        let (u, same) = u.split_at_mut(u.len() - unknowns.len());
        self.system.compliance_product(p, u);
        same.copy_from_slice(unknowns);
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        let ((p, unknowns), (u, _)) = (self.parts(p), self.parts(u));
        if !self.move_to(unknowns) {
            // Too long a step.
            residual.fill(f64::NAN);
            return;
        }
        let excess = self.forces(p) - &self.goal.target * self.unit;
        let (of_cells, of_forces) = residual.split_at_mut(p.len());
        self.system.residual(p, u, of_cells);
        of_forces.copy_from_slice(excess.as_slice());
        self.has_border = false;
    }

    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]) {
        self.find_border();
        let ((v, unknowns), (response, _)) = (self.parts(v), self.parts(response));
        let (of_cells, of_forces) = product.split_at_mut(v.len());
        self.system.tangent_product(v, response, of_cells);
        for (column, change) in self.columns.iter().zip(unknowns) {
            add_scaled(of_cells, *change, column);
        }
        of_forces.copy_from_slice(self.forces(v).as_slice());
    }

    fn other_guess(&mut self, p: &mut [f64]) -> bool {
        let (p, unknowns) = p.split_at_mut(p.len() - self.goal.count());
        unknowns.copy_from_slice(&self.at);
        self.system.other_guess(p)
    }

    fn directions(&mut self) -> Option<&mut Directions> {
        self.system.directions()
    }

    /// Block elimination with the preconditioner of the tractions in place of their inverse.
    fn precondition(&mut self, v: &mut [f64]) {
        self.find_border();
        let (v, unknowns) = v.split_at_mut(v.len() - self.goal.count());
        self.system.precondition(v);
        let asked = DVector::from_column_slice(unknowns) - self.forces(v);
        unknowns.copy_from_slice((&self.inverse * asked).as_slice());
        for (image, found) in self.images.iter().zip(unknowns) {
            add_scaled(v, -*found, image);
        }
    }
}
