//! The slope of a creep curve at zero creepage.

use crate::error::Error;
use crate::normal::NormalSummary;
use crate::problem::{Options, Problem};
use crate::solution::{Resultant, Work};

use super::{Abscissa, Creepages, Path, Solver};

/// Derivatives of the forces on the wheel with respect to the abscissa ν of the curve, where everything
/// that varies is zero; what does not vary keeps its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InitialSlope {
    /// d(Fx, Fy, Mz)/dν: in N and N m over a dimensionless creepage, in N m and N m² over spin.
    pub force: Resultant,
    /// d(F/(μ0 N), Mz/(μ0 N √(ab)))/dν: dimensionless over a creepage, in m over spin.
    pub normalised: Resultant,
    /// The same in the form of Kalker's coefficients, dimensionless and positive where the force opposes
    /// the creepage: −dF/dν over G c² and −dMz/dν over G c³, c = √(ab), over spin each over another c.
    /// Over ξ it is C11, over η C22 (and −C23), over φ C23 and C33 of a half-space with the shear
    /// modulus G of both bodies that would have this slope. `None` where another creepage is not zero:
    /// then something slides already.
    pub kalker: Option<Resultant>,
}

/// What was found, or why nothing was.
#[derive(Debug, Default)]
pub(super) struct Finding {
    pub value: Option<InitialSlope>,
    pub warning: Option<String>,
    pub work: Work,
}

/// Change of the normalised forces at which the difference is taken: far below saturation, where the
/// curve is bent. A third or thrice of it will do.
const CHANGE: f64 = 1e-3;

/// Tolerance of the solutions: far below the change.
const TOLERANCE: f64 = 1e-9;

/// Largest residual of a solution that counts: the slope is exact to some thousandths then.
const LARGEST_RESIDUAL: f64 = 1e-6;

/// Creepage of the first trial: that of a steel wheel.
const FIRST_TRIAL: f64 = 1e-6;

/// Most trials for a creepage with the right change.
const MAX_TRIALS: usize = 12;

/// The slope of a path that goes through zero of everything that varies, from differences over two
/// distances, extrapolated to none.
pub(super) fn find(
    problem: &Problem,
    options: &Options,
    path: &Path,
    normal: &NormalSummary,
) -> Result<Finding, Error> {
    if !path.has_origin() {
        return Ok(Finding::default());
    }
    let scale = Scale {
        limit: problem.friction.cold_coefficient() * normal.load,
        lever: (normal.semi_axis_x * normal.semi_axis_y).sqrt(),
    };
    let options = Options { tolerance: options.tolerance.min(TOLERANCE), ..options.clone() };
    let mut differences = Differences {
        solver: Solver::new(problem, &options, path),
        is_from_rest: path.at(0.0) == Creepages::default(),
        scale,
    };
    let result = differences.slope()?;
    let work = differences.solver.work;
    Ok(match result {
        Err(reason) => {
            Finding { value: None, warning: Some(format!("no initial slope: {reason}")), work }
        }
        Ok(force) => {
            let normalised = scale.normalised(&force);
            let kalker = differences.is_from_rest.then(|| scale.kalker(&force, problem, path));
            Finding { value: Some(InitialSlope { force, normalised, kalker }), warning: None, work }
        }
    })
}

/// What forces are measured in.
#[derive(Debug, Clone, Copy)]
struct Scale {
    /// μ0 N, in N.
    limit: f64,
    /// √(ab), in m.
    lever: f64,
}

impl Scale {
    fn normalised(&self, force: &Resultant) -> Resultant {
        scaled(force, 1.0 / self.limit, 1.0 / (self.limit * self.lever))
    }

    fn kalker(&self, slope: &Resultant, problem: &Problem, path: &Path) -> Resultant {
        let [wheel, rail] = [&problem.wheel, &problem.rail].map(|b| b.material.shear_modulus());
        let modulus = 2.0 / (1.0 / wheel + 1.0 / rail);
        let per_force = -1.0 / (modulus * self.lever.powi(2) * self.per_creepage(path));
        scaled(slope, per_force, per_force / self.lever)
    }

    /// The abscissa that makes a creepage of one at the distance c.
    fn per_creepage(&self, path: &Path) -> f64 {
        if path.abscissa() == Abscissa::Spin { self.lever } else { 1.0 }
    }
}

fn scaled(force: &Resultant, factor: f64, moment_factor: f64) -> Resultant {
    Resultant { x: force.x * factor, y: force.y * factor, moment_z: force.moment_z * moment_factor }
}

/// The sum of multiples of two.
fn sum(one: &Resultant, factor: f64, other: &Resultant, other_factor: f64) -> Resultant {
    Resultant {
        x: factor * one.x + other_factor * other.x,
        y: factor * one.y + other_factor * other.y,
        moment_z: factor * one.moment_z + other_factor * other.moment_z,
    }
}

/// A quotient of differences, or why there is none.
type Quotient = Result<Resultant, String>;

/// Differences of the forces about zero of everything that varies.
struct Differences<'a> {
    solver: Solver<'a>,
    /// Whether nothing else moves there: no creepage, no force.
    is_from_rest: bool,
    scale: Scale,
}

impl Differences<'_> {
    fn slope(&mut self) -> Result<Quotient, Error> {
        let mut distance = FIRST_TRIAL / self.scale.per_creepage(self.solver.path);
        for _ in 0..MAX_TRIALS {
            let quotient = match self.over(distance)? {
                Ok(quotient) => quotient,
                Err(reason) => return Ok(Err(reason)),
            };
            let normalised = self.scale.normalised(&quotient);
            let largest = normalised.x.abs().max(normalised.y.abs()).max(normalised.moment_z.abs());
            let change = largest * distance;
            if (CHANGE / 3.0..=3.0 * CHANGE).contains(&change) {
                // The error is linear in the distance where something slides on either side.
                let half = self.over(0.5 * distance)?;
                return Ok(half.map(|half| sum(&half, 2.0, &quotient, -1.0)));
            }
            distance *= (CHANGE / change).clamp(1e-3, 1e3);
        }
        Ok(Err("no creepage is small enough for the forces to follow it".to_owned()))
    }

    /// The difference quotient over a distance: from the origin, where the force is known to be zero,
    /// or else to both sides of it.
    fn over(&mut self, distance: f64) -> Result<Quotient, Error> {
        let after = self.force(distance)?;
        let (before, width) = if self.is_from_rest {
            (Ok(Resultant::default()), distance)
        } else {
            (self.force(-distance)?, 2.0 * distance)
        };
        Ok(after
            .and_then(|after| before.map(|before| sum(&after, 1.0 / width, &before, -1.0 / width))))
    }

    fn force(&mut self, abscissa: f64) -> Result<Quotient, Error> {
        let solution = self.solver.solve(abscissa)?;
        if solution.residual <= LARGEST_RESIDUAL {
            return Ok(Ok(solution.force));
        }
        Ok(Err(format!(
            "the solution at {} did not converge, its relative residual is {:.1e}",
            self.solver.path.abscissa().equation(abscissa),
            solution.residual
        )))
    }
}
