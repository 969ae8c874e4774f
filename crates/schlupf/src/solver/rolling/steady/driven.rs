//! The steady state and the creepages that prescribed forces cause, as one equilibrium: the
//! tractions and one creepage for each prescribed force are unknown, and besides F(p, ξ) = 0 every
//! force is to be the prescribed one.
//!
//! The Jacobian is that of the tractions with a border of a row and a column for each creepage:
//! the forces are sums of tractions, and ∂F/∂ξ is known in closed form. Neither costs a product, so
//! the creepages come at the price of the few more directions that the Krylov method needs.

use nalgebra::{DMatrix, DVector};

use crate::bodies::Kinematics;
use crate::numerics::vector::{add_scaled, norm};
use crate::problem::{Direction, PrescribedForces, Problem};
use crate::reporting::Error;
use crate::solution::Resultant;
use crate::solver::equilibrium::Equilibrium;
use crate::solver::settings;
use crate::solver::simplified::EllipticContact;
use crate::solver::summary;

use super::level::Level;
use super::sensitivity::standing;
use super::steady_state::{Direct, SteadyState};

/// A creepage that a prescribed force causes, both at the reference point.
#[derive(Debug, Clone, Copy)]
pub(in crate::solver::rolling) struct Drive {
    pub direction: Direction,
    /// The prescribed force, in N or N m.
    pub force: f64,
    /// The motion at the centre of the patch when the creepage is one.
    pub motion: Kinematics,
    /// −∂(force)/∂(creepage) for vanishing creepages, positive, in N or N m per unit of the
    /// creepage: the unknown is the creepage times this and the unit below.
    pub stiffness: f64,
    /// Converts a difference of forces into one that counts as much as one of the tractions: for a
    /// change of all tractions by a share of μ pₙ it is that of ‖μ pₙ‖₂; in Pa/N or Pa/(N m).
    pub unit: f64,
}

/// The drives of a contact whose reference point lies at `place` (x and y in m).
#[derive(Debug, Clone)]
pub(in crate::solver::rolling) struct Drives {
    pub all: Vec<Drive>,
    /// Position of the reference point in the contact frame, x and y in m.
    pub place: [f64; 2],
}

impl Drives {
    /// Those of forces (about a reference point that lies at a place in the contact frame, x and y
    /// in m) on a level of a problem.
    ///
    /// # Errors
    /// Those of Kalker's coefficients.
    pub fn of(
        problem: &Problem,
        level: &Level,
        (prescribed, place): (&PrescribedForces, [f64; 2]),
    ) -> Result<Self, Error> {
        let normal = &level.contact.normal;
        let contact = EllipticContact::of(problem, *normal)?;
        let lever = contact.lever();
        let pressures: Vec<f64> =
            level.contact.patch.cells.iter().map(|cell| cell.pressure).collect();
        let unit = norm(&pressures) / normal.load;
        let drive = |(direction, force): (Direction, f64)| {
            let at_centre = contact.linear_force(&direction.unit()).along(direction);
            Drive {
                direction,
                force,
                motion: direction.unit().at(place.map(|part| -part)),
                stiffness: at_centre.map_or(1.0, f64::abs),
                unit: if direction == Direction::Spin { unit / lever } else { unit },
            }
        };
        Ok(Self { all: prescribed.under(normal.load).into_iter().map(drive).collect(), place })
    }

    /// None about the same reference point.
    pub fn without(&self) -> Self {
        Self { all: Vec::new(), ..*self }
    }

    /// The prescribed forces, in N or N m.
    pub fn forces(&self) -> Vec<(Direction, f64)> {
        self.all.iter().map(|drive| (drive.direction, drive.force)).collect()
    }

    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The forces over their units on the wheel, less those prescribed, in Pa.
    fn excess(&self, force: &Resultant, is_change: bool) -> Vec<f64> {
        let force = force.about(self.place);
        let excess = |drive: &Drive| {
            let prescribed = if is_change { 0.0 } else { drive.force };
            drive.unit * (force.along(drive.direction).unwrap_or(0.0) - prescribed)
        };
        self.all.iter().map(excess).collect()
    }
}

/// The equilibrium on the first of several levels, as [`SteadyState`]. The unknowns are p, and
/// after it the creepages in Pa.
pub(super) struct Driven<'a> {
    problem: Problem,
    levels: &'a mut [Level],
    drives: &'a Drives,
    /// The unknown creepages (in Pa) at which the levels are.
    at: Vec<f64>,
    /// ∂F/∂(creepage in Pa), dimensionless, and what the preconditioner makes of it.
    columns: Vec<Vec<f64>>,
    images: Vec<Vec<f64>>,
    /// Inverse of the matrix by which the forces (in Pa) change with the creepages (in Pa), by the
    /// preconditioner.
    inverse: DMatrix<f64>,
    /// Whether columns and images are those of the last residual.
    has_columns: bool,
    has_images: bool,
}

impl<'a> Driven<'a> {
    /// With the creepages of the given problem, which must be those of the levels.
    pub fn new(problem: &Problem, levels: &'a mut [Level], drives: &'a Drives) -> Self {
        let (count, size) = (drives.all.len(), levels[0].size());
        Self {
            problem: problem.clone(),
            at: Self::unknowns(problem, drives),
            drives,
            columns: vec![vec![0.0; size]; count],
            images: vec![vec![0.0; size]; count],
            inverse: DMatrix::identity(count, count),
            has_columns: false,
            has_images: false,
            levels,
        }
    }

    /// The unknown creepages of a problem at the centre of the patch, in Pa.
    pub fn unknowns(problem: &Problem, drives: &Drives) -> Vec<f64> {
        let motion = problem.kinematics.at(drives.place);
        let unknown = |drive: &Drive| drive.scale() * drive.direction.creepage(&motion);
        drives.all.iter().map(unknown).collect()
    }

    /// A motion with other unknown creepages, in Pa.
    pub fn motion(kinematics: &Kinematics, drives: &Drives, unknowns: &[f64]) -> Kinematics {
        let mut motion = kinematics.at(drives.place);
        for (drive, unknown) in drives.all.iter().zip(unknowns) {
            *drive.direction.creepage_of(&mut motion) = unknown / drive.scale();
        }
        motion.at(drives.place.map(|part| -part))
    }

    fn count(&self) -> usize {
        self.drives.all.len()
    }

    /// What the forces of a traction, or of a change of it, exceed the prescribed ones by.
    fn excess(&self, traction: &[f64], is_change: bool) -> Vec<f64> {
        if self.drives.is_empty() {
            return Vec::new();
        }
        let patch = &self.levels[0].contact.patch;
        self.drives.excess(&summary::resultant(patch, traction), is_change)
    }

    fn state(&mut self) -> SteadyState<'_> {
        SteadyState::new(&self.problem, self.levels)
    }

    /// Moves the levels to other creepages, unless no wheel has them.
    fn move_to(&mut self, unknowns: &[f64]) -> bool {
        if self.at == unknowns {
            return true;
        }
        let motion = Self::motion(&self.problem.kinematics, self.drives, unknowns);
        if motion.check().is_err() || motion.creepage_x < -settings::spinning() {
            return false;
        }
        self.at.copy_from_slice(unknowns);
        self.problem.kinematics = motion;
        self.levels[0].set_motion(&self.problem);
        true
    }

    fn find_columns(&mut self) {
        if self.has_columns {
            return;
        }
        let mut columns = std::mem::take(&mut self.columns);
        for (drive, column) in self.drives.all.iter().zip(&mut columns) {
            let over_scale = drive.scale().recip();
            let motion = Kinematics { speed: standing(&self.problem).speed, ..drive.motion };
            let mut direct = Direct::nothing(self.levels[0].strips.len());
            for (k, cell) in self.levels[0].contact.patch.cells.iter().enumerate() {
                direct.set_motion(k, cell, &motion);
            }
            self.state().change_by(&direct, column);
            for entry in column.iter_mut() {
                *entry *= over_scale;
            }
        }
        self.columns = columns;
        self.has_columns = true;
    }

    /// M⁻¹ of the columns, and by how much this changes the forces.
    fn find_images(&mut self) {
        if self.has_images {
            return;
        }
        self.find_columns();
        let count = self.count();
        let mut by_creepage = DMatrix::zeros(count, count);
        for j in 0..count {
            let mut image = self.columns[j].clone();
            self.state().precondition(&mut image);
            by_creepage.set_column(j, &DVector::from_vec(self.excess(&image, true)));
            self.images[j] = image;
        }
        self.inverse = regular_inverse(&by_creepage);
        self.has_images = true;
    }
}

/// The inverse of a matrix that is about the identity where the contact sticks; with something
/// added to its diagonal where that makes it regular.
fn regular_inverse(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let count = matrix.nrows();
    for share in [0.0, settings::least_creep_stiffness(), 1.0] {
        let shifted = matrix + share * DMatrix::identity(count, count);
        if let Some(inverse) = shifted.try_inverse().filter(|inverse| {
            inverse.iter().all(|entry| entry.abs() < settings::least_creep_stiffness().recip())
        }) {
            return inverse;
        }
    }
    DMatrix::identity(count, count)
}

impl Drive {
    /// Pa per unit of the creepage.
    fn scale(&self) -> f64 {
        self.stiffness * self.unit
    }
}

impl Equilibrium for Driven<'_> {
    fn size(&self) -> usize {
        self.levels[0].size() + self.count()
    }

    fn response_size(&self) -> usize {
        let cells = self.levels[0].size();
        cells * if self.levels[0].friction.is_coupled { 2 } else { 1 } + self.count()
    }

    fn scale(&self, p: &[f64]) -> f64 {
        let [p, _] = self.parts(p);
        crate::solver::equilibrium::measure(self.levels[0].strips.scale(), norm(p))
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        let split = u.len() - self.count();
        let (u, same) = u.split_at_mut(split);
        let (p, unknowns) = p.split_at(p.len() - same.len());
        self.state().compliance_product(p, u);
        same.copy_from_slice(unknowns);
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        let [p, unknowns] = self.parts(p);
        let [u, _] = self.parts(u);
        if !self.move_to(unknowns) {
            // Too long a step.
            residual.fill(f64::NAN);
            return;
        }
        let excess = self.excess(p, false);
        let (of_cells, of_forces) = residual.split_at_mut(p.len());
        self.state().residual(p, u, of_cells);
        for (residual, excess) in of_forces.iter_mut().zip(excess) {
            *residual = -excess;
        }
        (self.has_columns, self.has_images) = (false, false);
    }

    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]) {
        self.find_columns();
        let [v, unknowns] = self.parts(v);
        let [response, _] = self.parts(response);
        let (of_cells, of_forces) = product.split_at_mut(v.len());
        self.state().tangent_product(v, response, of_cells);
        for (column, change) in self.columns.iter().zip(unknowns) {
            add_scaled(of_cells, *change, column);
        }
        let excess = self.excess(v, true);
        for (product, excess) in of_forces.iter_mut().zip(excess) {
            *product = -excess;
        }
    }

    fn other_guess(&mut self, p: &mut [f64]) -> bool {
        let split = p.len() - self.count();
        let (p, unknowns) = p.split_at_mut(split);
        unknowns.copy_from_slice(&self.at);
        self.state().other_guess(p)
    }

    /// Block elimination with the preconditioner of the tractions in place of their inverse.
    fn precondition(&mut self, v: &mut [f64]) {
        self.find_images();
        let split = v.len() - self.count();
        let (v, unknowns) = v.split_at_mut(split);
        self.state().precondition(v);
        let made = self.excess(v, true);
        // −(forces of v − image · x) = what is asked for.
        let asked = unknowns.iter().zip(&made).map(|(asked, made)| asked + made);
        let found = &self.inverse * DVector::from_iterator(made.len(), asked);
        for (unknown, found) in unknowns.iter_mut().zip(found.iter()) {
            *unknown = *found;
        }
        for (image, found) in self.images.iter().zip(unknowns) {
            add_scaled(v, -*found, image);
        }
    }
}

impl Driven<'_> {
    /// What belongs to the cells, and what to the creepages.
    fn parts<'v>(&self, values: &'v [f64]) -> [&'v [f64]; 2] {
        let (cells, creepages) = values.split_at(values.len() - self.count());
        [cells, creepages]
    }
}
