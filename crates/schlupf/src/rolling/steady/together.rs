//! The search for a state together with the creepages that prescribed forces cause, on nested
//! grids.

use crate::equilibrium::{Limits, Outcome};
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::problem::Problem;

use super::branches;
use super::driven::{Driven, Drives};
use super::setup::{COARSE_TOLERANCE, Search, Setup};

impl Setup {
    /// The state whose forces are those of the drives, and its motion; the unknown creepages of the
    /// problem are a first guess.
    pub fn find_together(
        &mut self,
        problem: &Problem,
        drives: &Drives,
        search: &mut Search,
    ) -> Result<(Outcome, Kinematics), Error> {
        let cells = self.levels[0].contact.patch.len();
        (search.work.cells, search.work.outer_iterations) = (cells, 1);
        let is_warm = !self.earlier.is_empty();
        self.earlier.truncate(1);
        self.problem = problem.clone();
        let coarse = COARSE_TOLERANCE;
        let coarsest = self.levels.len() - 1;
        let mut outcome = Outcome::default();
        for depth in (0..self.levels.len()).rev() {
            self.levels[depth].set_problem(&self.problem.clone());
            self.guess(depth, 0.0);
            if depth == coarsest && !is_warm {
                // Tractions at the guessed motion: from none at all the creepages would first grow
                // as if everything stuck.
                self.solve_level(depth, coarse, search)?;
            }
            let tolerance = if depth == 0 { search.options.tolerance } else { coarse };
            outcome = self.drive_level(depth, tolerance, (drives, search))?;
            self.levels[depth].has_news = true;
            self.levels[depth].is_found = outcome.converged && depth == 0;
            if !outcome.converged && depth > 0 {
                break;
            }
        }
        if outcome.converged {
            self.remember(self.problem.kinematics);
        } else {
            self.earlier.clear();
        }
        Ok((outcome, self.problem.kinematics))
    }

    /// Newton's method on one level, for the tractions and the creepages of the present problem.
    fn drive_level(
        &mut self,
        depth: usize,
        tolerance: f64,
        (drives, search): (&Drives, &mut Search),
    ) -> Result<Outcome, Error> {
        let problem = self.problem.clone();
        let limits = Limits {
            tolerance,
            max_iterations: search.options.max_iterations,
            is_monotone: branches::may_be_several(&problem, &self.levels[depth], false),
        };
        let mut unknowns = std::mem::take(&mut self.levels[depth].traction);
        let size = unknowns.len();
        unknowns.extend(Driven::unknowns(&problem, drives));
        let mut system = Driven::new(&problem, &mut self.levels[depth..], drives);
        let solved = search.newton.solve(&mut system, &mut unknowns, &limits, search.watch);
        let kinematics = Driven::motion(&problem.kinematics, drives, &unknowns[size..]);
        unknowns.truncate(size);
        let level = &mut self.levels[depth];
        level.traction = unknowns;
        let solved = solved?;
        level.response.clear();
        level
            .response
            .extend_from_slice(&solved.response[..solved.response.len() - drives.all.len()]);
        let mut outcome = solved.outcome;
        search.work.newton_iterations += outcome.iterations;
        search.work.operator_products += self.part_of_product(depth) * outcome.products as f64;
        let found = Problem { kinematics, ..problem };
        outcome.converged &= found.kinematics.check().is_ok();
        if outcome.converged {
            self.problem = found;
        }
        let level = &mut self.levels[depth];
        if !level.friction.is_coupled {
            level.friction.set_problem(&self.problem, &level.contact.patch);
        }
        Ok(outcome)
    }
}
