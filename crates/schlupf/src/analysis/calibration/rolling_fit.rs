//! Motions of a rolling patch, and the response of the half-space and its substitutes.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::bodies::Kinematics;
use crate::elasticity::Elasticity;
use crate::numerics::parallel;
use crate::numerics::vector::norm;
use crate::problem::{Options, Problem};
use crate::reporting::{CalibrationError, Error, Progress, Stage, Watch, within};
use crate::solution::{Solution, Status};
use crate::solver::{Solver, SteadySolver};

use super::Deviation;
use super::displacements::{Sample, fit};
use super::kalker_bed::bedding;
use super::rolling_contact::{RollingContact, SIZE};

/// Motions to which stiffnesses are fitted: creepages as fractions of those at which Kalker's
/// linear theory gives the force μN, along, across, spin.
pub(super) const FITTED: [[f64; 3]; 24] = [
    [0.3, 0.0, 0.0],
    [0.7, 0.0, 0.0],
    [1.2, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [3.0, 0.0, 0.0],
    [0.0, 0.3, 0.0],
    [0.0, 0.7, 0.0],
    [0.0, 1.2, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 3.0, 0.0],
    [0.5, 0.5, 0.0],
    [1.2, 0.8, 0.0],
    [0.0, 0.0, 0.3],
    [0.0, 0.0, 0.7],
    [0.0, 0.0, 1.2],
    [0.0, 0.0, 2.0],
    [0.7, 0.0, 0.5],
    [1.2, 0.0, 1.0],
    [0.0, 0.7, 0.5],
    [0.0, -0.7, 0.5],
    [0.0, 1.2, 1.0],
    [0.0, -1.2, 1.0],
    [0.6, 0.6, 0.5],
    [0.6, -0.6, 0.5],
];

/// Motions on which stiffnesses are assessed: none of those to which they are fitted.
pub(super) const OTHERS: [[f64; 3]; 20] = [
    [0.5, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.6, 0.0, 0.0],
    [0.0, 0.5, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 1.6, 0.0],
    [0.9, 0.6, 0.0],
    [0.4, 1.0, 0.0],
    [0.0, 0.0, 0.5],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, 1.6],
    [1.0, 0.0, 0.7],
    [0.5, 0.0, 1.2],
    [0.0, 1.0, 0.7],
    [0.0, -1.0, 0.7],
    [0.0, 0.5, 1.2],
    [0.0, -0.5, 1.2],
    [0.9, 0.6, 0.8],
    [0.9, -0.6, 0.8],
    [0.3, 0.3, 1.6],
];

/// Differences with weight one in the fit: of forces over μN, without and with spin, and of fields.
const FORCE: f64 = 0.01;
const FORCE_WITH_SPIN: f64 = 0.02;
const FIELD: f64 = 0.06;

/// The motions of one ellipse, and the response of the half-space.
pub(super) struct Motions<'a> {
    contact: RollingContact,
    ways: Vec<Kinematics>,
    exact: Vec<Solution>,
    options: Options,
    watch: Watch<'a>,
    /// Motions solved so far.
    solved: AtomicUsize,
}

/// Number of motions that one solver computes in a row, each starting from the previous ones.
/// Chains are solved in parallel.
const CHAIN: usize = 6;

impl<'a> Motions<'a> {
    pub fn new(
        axis_ratio: f64,
        poisson_ratio: f64,
        cells: usize,
        motions: &[[f64; 3]],
        watch: Watch<'a>,
    ) -> Result<Self, Error> {
        let contact = RollingContact::new(axis_ratio, poisson_ratio)?;
        let options =
            Options { cells_x: cells, cells_y: cells, tolerance: 1e-7, ..Options::default() };
        let ways = motions.iter().map(|parts| contact.motion(*parts)).collect();
        let (exact, solved) = (Vec::new(), AtomicUsize::new(0));
        let mut this = Self { contact, ways, exact, options, watch, solved };
        let elasticity = Arc::clone(&this.contact.problem.interface.elasticity);
        this.exact =
            this.answers(&elasticity)?.ok_or(CalibrationError::NotConverged { axis_ratio })?;
        Ok(this)
    }

    /// Combined shear modulus of the bodies, in Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.contact.bodies.shear_modulus()
    }

    /// Beddings c s/G (dimensionless) of the Winkler bedding with Kalker's flexibilities.
    pub fn slope_bedding(&self) -> [f64; 2] {
        bedding(&self.contact.coefficients, SIZE, self.contact.semi_axes[0])
    }

    /// Logarithms of the relative stiffnesses (dimensionless) that fit the half-space's
    /// displacements under the tractions of nearly full stick and of full sliding.
    pub fn start(&self) -> Result<Vec<f64>, Error> {
        let sliding = [(0, 4), (5, 9)];
        let mut start = Vec::with_capacity(6);
        for (component, (stick, slide)) in sliding.into_iter().enumerate() {
            let samples = [stick, slide].map(|k| Sample::of(&self.exact[k], component));
            let found = fit(&samples)?;
            let reach = |coupling: f64| (coupling / found.bedding).sqrt() / SIZE;
            let bedding = found.bedding * SIZE / self.shear_modulus();
            for (value, range) in [
                (bedding, [f64::MIN_POSITIVE, f64::MAX]),
                (reach(found.coupling_along_x), REACHES),
                (reach(found.coupling_along_y), REACHES),
            ] {
                start.push(value.clamp(range[0], range[1]).ln());
            }
        }
        Ok(start)
    }

    /// Solutions of all motions; `None` if one is not found.
    fn answers(&self, elasticity: &Arc<dyn Elasticity>) -> Result<Option<Vec<Solution>>, Error> {
        let base = self
            .contact
            .problem
            .clone()
            .with_interface(|interface| interface.elasticity = Arc::clone(elasticity));
        let chains = self.ways.chunks(CHAIN).collect();
        let answers = parallel::try_map(chains, |ways| self.chain(&base, ways))?;
        let answers: Option<Vec<Vec<Solution>>> = answers.into_iter().collect();
        Ok(answers.map(|answers| answers.concat()))
    }

    fn chain(&self, base: &Problem, ways: &[Kinematics]) -> Result<Option<Vec<Solution>>, Error> {
        let mut solver = SteadySolver::new(&self.options);
        let mut solutions = Vec::with_capacity(ways.len());
        for kinematics in ways {
            let problem = Problem { kinematics: *kinematics, ..base.clone() };
            let solved = self.solved.fetch_add(1, Ordering::Relaxed);
            let watch = within(self.watch, Progress::count(Stage::Calibration, solved));
            let solution = match solver.solve(&problem, &watch) {
                Err(Error::Stopped {}) => return Err(Error::Stopped {}),
                Ok(solution) if solution.status == Status::Converged => solution,
                _ => return Ok(None),
            };
            solutions.push(solution);
        }
        Ok(Some(solutions))
    }

    /// Differences of forces, and of the tractions if they are included, each divided by the
    /// difference with weight one; dimensionless.
    pub fn residuals(
        &self,
        elasticity: &Arc<dyn Elasticity>,
        fields: bool,
    ) -> Result<Option<Vec<f64>>, Error> {
        let Some(answers) = self.answers(elasticity)? else { return Ok(None) };
        let mut residuals = Vec::new();
        for ((answer, exact), motion) in answers.iter().zip(&self.exact).zip(&self.ways) {
            let force = if motion.spin == 0.0 { FORCE } else { FORCE_WITH_SPIN };
            residuals.push((answer.normalised.x - exact.normalised.x) / force);
            residuals.push((answer.normalised.y - exact.normalised.y) / force);
            if fields {
                let weight = 1.0 / (FIELD * size_of(exact));
                let (here, there) = (&answer.fields, &exact.fields);
                let along = here.traction_x.iter().zip(&there.traction_x);
                let across = here.traction_y.iter().zip(&there.traction_y);
                residuals.extend(along.chain(across).map(|(t, u)| weight * (t - u)));
            }
        }
        Ok(Some(residuals))
    }

    pub fn deviation(&self, elasticity: &Arc<dyn Elasticity>) -> Result<Option<Deviation>, Error> {
        let Some(answers) = self.answers(elasticity)? else { return Ok(None) };
        let mut deviation = Deviation::default();
        let mut counts = [0.0; 2];
        for ((answer, exact), motion) in answers.iter().zip(&self.exact).zip(&self.ways) {
            let (one, other) = (answer.normalised, exact.normalised);
            let force = (one.x - other.x).hypot(one.y - other.y);
            let (here, there) = (&answer.fields, &exact.fields);
            let squares = |one: &[f64], other: &[f64]| -> f64 {
                one.iter().zip(other).map(|(t, u)| (t - u).powi(2)).sum()
            };
            let apart = squares(&here.traction_x, &there.traction_x)
                + squares(&here.traction_y, &there.traction_y);
            let field = apart.sqrt() / size_of(exact);
            if motion.spin == 0.0 {
                deviation.force = deviation.force.max(force);
                deviation.field += field;
                counts[0] += 1.0;
            } else {
                deviation.force_with_spin = deviation.force_with_spin.max(force);
                deviation.field_with_spin += field;
                counts[1] += 1.0;
            }
        }
        deviation.field /= counts[0];
        deviation.field_with_spin /= counts[1];
        Ok(Some(deviation))
    }
}

/// Initial decay lengths of a fit.
const REACHES: [f64; 2] = [0.05, 0.8];

/// ‖t‖₂ over all cells, in Pa.
fn size_of(solution: &Solution) -> f64 {
    let fields = &solution.fields;
    norm(&fields.traction_x).hypot(norm(&fields.traction_y))
}
