//! Normalised forces of single states, from the solver.

use std::f64::consts::PI;

use crate::analysis::ideal_contact::IdealContact;
use crate::bodies::Kinematics;
use crate::interface::ContactLaw;
use crate::problem::{Options, Problem};
use crate::reporting::{Error, Watch};
use crate::solution::{Resultant, Solution, Status};
use crate::solver::{Solver, SteadySolver};

/// Cells along the longer side of the patch over those across the narrower one: the ratio of the
/// sides to this power, dimensionless.
pub const LONGER_SIDE_EXPONENT: f64 = 0.5;

/// √(ab), in m; any value would do.
const SIZE: f64 = 5e-3;

/// p0, in Pa: so small that all creepages are.
const PEAK_PRESSURE: f64 = 1e5;

/// μ, dimensionless; any value would do.
const FRICTION: f64 = 0.3;

/// Relative residual of the solutions.
const TOLERANCE: f64 = 1e-5;

/// Estimated error of a force over μN above which it is solved on cells half as large: one force in
/// eight.
const COARSE: f64 = 2e-3;

/// Finds forces on patches of one shape.
pub(super) struct StateSolver {
    problem: Problem,
    /// Normalised creepages over creepages, with the spin times √(ab).
    unit: f64,
    coarse: SteadySolver,
    fine: SteadySolver,
}

/// A state that was solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    /// Fx/(μN), Fy/(μN), Mz/(μN √(ab)); dimensionless.
    pub force: [f64; 3],
    /// Whether its solution converged.
    pub converged: bool,
}

impl StateSolver {
    /// On so many cells across the narrower side of the patch, and on twice as many.
    pub fn new(axis_ratio: f64, poisson_ratio: f64, cells: usize) -> Result<Self, Error> {
        let ideal = IdealContact { size: SIZE, peak_pressure: PEAK_PRESSURE, friction: FRICTION };
        let (problem, bodies) = ideal.problem(axis_ratio, poisson_ratio, ContactLaw::Coulomb)?;
        let load = 2.0 / 3.0 * PI * SIZE * SIZE * PEAK_PRESSURE;
        let unit = bodies.shear_modulus() * SIZE * SIZE / (FRICTION * load);
        let on = |cells: usize| {
            let along_side = |slenderness: f64| {
                // Even, for the grid of half as many.
                2 * (0.5 * cells as f64 * slenderness.max(1.0).powf(LONGER_SIDE_EXPONENT)).round()
                    as usize
            };
            SteadySolver::new(&Options {
                cells_x: along_side(axis_ratio),
                cells_y: along_side(axis_ratio.recip()),
                tolerance: TOLERANCE,
                extrapolate: true,
                keeps_state: false,
                ..Options::default()
            })
        };
        Ok(Self { problem, unit, coarse: on(cells), fine: on(2 * cells) })
    }

    /// The force under normalised creepages, extrapolated from two grids.
    pub fn solve(&mut self, creepages: [f64; 3], watch: Watch) -> Result<Solved, Error> {
        let [along, across, spin] = creepages.map(|creepage| creepage / self.unit);
        self.problem.kinematics = Kinematics {
            creepage_x: along,
            creepage_y: across,
            spin: spin / SIZE,
            ..Kinematics::free_rolling(1.0)
        };
        let coarse = Self::on(&mut self.coarse, &self.problem, watch)?;
        let extrapolation = coarse.extrapolation;
        let is_accurate = extrapolation.is_some_and(|extrapolation| {
            let plain = components(&coarse.normalised);
            let better = components(&extrapolation.normalised);
            plain.iter().zip(better).all(|(plain, better)| (plain - better).abs() <= COARSE)
        });
        if is_accurate && coarse.status == Status::Converged {
            return Ok(Solved::new(&coarse));
        }
        Ok(Solved::new(&Self::on(&mut self.fine, &self.problem, watch)?))
    }

    /// Starts anew where earlier solutions lead to none.
    fn on(solver: &mut SteadySolver, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let solution = solver.solve(problem, watch)?;
        if solution.status == Status::Converged {
            return Ok(solution);
        }
        solver.forget();
        solver.solve(problem, watch)
    }
}

impl Solved {
    fn new(solution: &Solution) -> Self {
        let best = solution.extrapolation.map_or(solution.normalised, |better| better.normalised);
        Self { force: components(&best), converged: solution.status == Status::Converged }
    }
}

fn components(force: &Resultant) -> [f64; 3] {
    [force.x, force.y, force.moment_z.unwrap_or(f64::NAN)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::table_building::{distance, shape};
    use crate::reporting::unwatched;

    /// Goal: states of slender patches that nearly all slide while they spin about a point within,
    /// where the slip turns round over few cells, are right within 0.4 % of μN on the cells of a
    /// table. Against three times as many cells.
    #[test]
    fn slender_patches_that_spin_have_enough_cells() {
        for ratio in [0.15, 0.4, 3.0, 8.0] {
            let shape = shape(ratio, 0.28).unwrap();
            for (angle, size) in [(0.7_f64, 30.0), (2.2, 100.0), (4.1, 300.0)] {
                let (sine, cosine) = angle.sin_cos();
                let [x, y] = [0.6 * cosine * ratio.sqrt(), 0.6 * sine / ratio.sqrt()];
                let [along, across, spin] = shape.scales;
                let plain = [along * y, -across * x, spin];
                let length = plain.iter().map(|part| part * part).sum::<f64>().sqrt();
                let creepages = std::array::from_fn(|k| size * plain[k] / length / shape.scales[k]);
                let [found, exact] = [24, 72].map(|cells| {
                    let mut solver = StateSolver::new(ratio, 0.28, cells).unwrap();
                    solver.solve(creepages, &unwatched).unwrap()
                });
                assert!(found.converged && exact.converged);
                let error = distance(found.force, exact.force);
                assert!(error < 4e-3, "{ratio} {angle} {size}: {error}");
            }
        }
    }
}
