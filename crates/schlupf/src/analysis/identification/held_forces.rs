//! Fits where some forces are prescribed: a change of a constant then changes the creepages of
//! those directions, too.

use nalgebra::{DMatrix, DVector};

use crate::bodies::Kinematics;
use crate::interface::InterfaceConstant;
use crate::problem::{Direction, Method, Options, Problem};
use crate::reporting::{Error, ForceError, Watch};
use crate::solution::{Resultant, Solution};
use crate::solver::{Solver, SteadySolver};

/// Finds states and their derivatives by constants, with whatever forces a problem prescribes.
pub(super) struct HeldForces {
    /// At given creepages.
    steady: SteadySolver,
    /// Finds creepages; used only where forces are prescribed.
    motions: Box<dyn Solver>,
}

impl HeldForces {
    pub fn new(options: &Options) -> Self {
        Self { steady: SteadySolver::new(options), motions: Method::Full.solver(options) }
    }

    /// Discards all solutions.
    pub fn forget(&mut self) {
        self.steady.forget();
        self.motions.forget();
    }

    /// The state under a load (in N) with the derivatives of its forces by constants (in N and N m
    /// per unit of the constant), prescribed forces held. `None` if it is not found, or if these
    /// constants do not allow for the forces.
    pub fn solve(
        &mut self,
        problem: &Problem,
        load: f64,
        (constants, watch): (&[InterfaceConstant], Watch),
    ) -> Result<Option<(Solution, Vec<Resultant>)>, Error> {
        let wanted = problem.prescribed.under(load);
        if wanted.is_empty() {
            return self.steady.solve_with_derivatives_by(problem, constants, watch);
        }
        let found = match self.motions.solve(problem, watch) {
            Ok(solution) => solution,
            Err(Error::Force {
                error: ForceError::Unreachable { .. } | ForceError::NotFound { .. },
            }) => return Ok(None),
            Err(error) => return Err(error),
        };
        let given = Problem { kinematics: found.kinematics, ..problem.without_forces() };
        let directions: Vec<Direction> = wanted.iter().map(|(direction, _)| *direction).collect();
        let by = self.steady.solve_with_derivatives_by(&given, constants, watch)?;
        let Some((mut solution, by)) = by else { return Ok(None) };
        let changes: Vec<Kinematics> = directions.iter().map(|of| of.unit()).collect();
        let slopes = self.steady.solve_with_slopes(&given, &changes, watch)?;
        let Some((again, slopes)) = slopes else { return Ok(None) };
        for work in [found.work, again.work] {
            solution.work.add(&work);
        }
        Ok(held(&by, &slopes, &directions).map(|by| (solution, by)))
    }
}

/// dF/dc = ∂F/∂c − (∂F/∂ξ) (∂P/∂ξ)⁻¹ ∂P/∂c, with the prescribed forces P and their creepages ξ.
/// `None` where the forces do not determine the creepages.
fn held(
    by: &[Resultant],
    slopes: &[Resultant],
    directions: &[Direction],
) -> Option<Vec<Resultant>> {
    let of_prescribed = |force: &Resultant| {
        let parts = directions.iter().map(|direction| force.along(*direction));
        Some(DVector::from_vec(parts.collect::<Option<Vec<f64>>>()?))
    };
    let columns: Vec<_> = slopes.iter().map(of_prescribed).collect::<Option<_>>()?;
    let inverse = DMatrix::from_columns(&columns).try_inverse()?;
    let held = |by: &Resultant| {
        let creepages = &inverse * of_prescribed(by)?;
        let pairs = slopes.iter().zip(creepages.iter());
        Some(pairs.fold(*by, |held, (slope, change)| held.plus(-change, slope)))
    };
    by.iter().map(held).collect()
}
