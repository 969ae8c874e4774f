//! The slope of a creep curve at zero creepage.

use crate::normal::NormalSummary;
use crate::problem::Problem;
use crate::reporting::{Error, Warning};
use crate::solution::{Resultant, Sensitivity};
use crate::solver::reference_point;

use super::{Abscissa, Creepages, Path, Points};

/// Derivatives of the forces on the wheel with respect to the abscissa ν of the curve, where all
/// varied creepages are zero; the others keep their values.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct InitialSlope {
    /// d(Fx, Fy, Mz)/dν: in N and N m with respect to a dimensionless creepage, in N m and N m²
    /// with respect to spin.
    pub force: Resultant,
    /// d(F/(μ0 N), Mz/(μ0 N √(ab)))/dν: dimensionless with respect to a creepage, in m with respect
    /// to spin.
    pub normalised: Resultant,
    /// The same in the form of Kalker's coefficients, dimensionless and positive if the force
    /// opposes the creepage: −dF/dν over G c² and −dMz/dν over G c³, c = √(ab), for spin each over
    /// another c. For ξ it is C11, for η C22 (and −C23), for φ C23 and C33 of a half-space with the
    /// shear modulus G of both bodies that has the same slope, with moments about the centre of the
    /// patch. `None` if another creepage is not zero, because then something slides already, and
    /// for spin about another point than that centre.
    pub kalker: Option<Resultant>,
}

/// The result, or why there is none.
#[derive(Debug, Default)]
pub(super) struct Finding {
    pub value: Option<InitialSlope>,
    pub warning: Option<Warning>,
}

/// The slope of a path that goes through the zero of all varied creepages: exact, from the Jacobian
/// of the equilibrium there; for a fast method, from a finite difference.
pub(super) fn find(solver: &mut Points, normal: &NormalSummary) -> Result<Finding, Error> {
    let path = solver.path;
    // With other forces prescribed the derivatives at given creepages are not those of the curve.
    // A wheel does not roll freely at zero creepage of its nominal radius.
    let has_slope = solver.problem.prescribed.is_none() && !solver.solver.is_of_wheel();
    if !path.has_origin() || !has_slope {
        return Ok(Finding::default());
    }
    let origin = path.at(0.0);
    let scale = Scale {
        limit: solver.problem.interface.friction.cold_coefficient() * normal.load,
        lever: (normal.semi_axis_x * normal.semi_axis_y).sqrt(),
    };
    let force = if solver.solver.has_derivatives() {
        solver
            .differentiate(0.0)?
            .and_then(|solution| solution.sensitivity)
            .map(|sensitivity| along(path, &sensitivity))
    } else {
        Some(difference(solver, &scale)?)
    };
    let problem = &solver.problem;
    let Some(force) = force else {
        let warning = Warning::NoInitialSlope { abscissa: path.quantity() };
        return Ok(Finding { value: None, warning: Some(warning) });
    };
    let normalised = scale.normalised(&force);
    let place = reference_point::place(problem.reference, normal)?;
    // About another point spin also changes the creepages of the patch; a creepage is the same
    // there.
    let is_comparable = place == [0.0; 2] || path.start().spin == path.end().spin;
    let kalker = (origin == Creepages::default() && is_comparable).then(|| {
        let about_patch = force.about(place.map(|part| -part));
        scale.kalker(&about_patch, problem, path)
    });
    Ok(Finding { value: Some(InitialSlope { force, normalised, kalker }), warning: None })
}

/// The derivative of the forces along a path.
fn along(path: &Path, sensitivity: &Sensitivity) -> Resultant {
    let [one, other] = path.range().map(|abscissa| path.at(abscissa).components());
    let length = path.range()[1] - path.range()[0];
    let parts = [sensitivity.creepage_x, sensitivity.creepage_y, sensitivity.spin];
    let rates = (0..3).map(|c| (other[c] - one[c]) / length);
    parts.iter().zip(rates).fold(Resultant::default(), |sum, (part, rate)| sum.plus(rate, part))
}

/// Half the range of a central difference, relative to the abscissa at which the linear force would
/// be about the friction limit.
const STEP: f64 = 1e-6;

/// The slope for a fast method, which has no derivatives but is accurate to rounding error.
fn difference(solver: &mut Points, scale: &Scale) -> Result<Resultant, Error> {
    let modulus = Scale::modulus(&solver.problem);
    let typical = scale.limit / (modulus * scale.lever.powi(2) * scale.per_creepage(solver.path));
    let step = STEP * typical;
    let [more, less] = [solver.solve(step)?.force, solver.solve(-step)?.force];
    let rate = (2.0 * step).recip();
    Ok(more.plus(-1.0, &less).scaled(rate, rate))
}

/// Reference values for forces.
#[derive(Debug, Clone, Copy)]
struct Scale {
    /// μ0 N, in N.
    limit: f64,
    /// √(ab), in m.
    lever: f64,
}

impl Scale {
    fn normalised(&self, force: &Resultant) -> Resultant {
        force.scaled(self.limit.recip(), (self.limit * self.lever).recip())
    }

    fn kalker(&self, slope: &Resultant, problem: &Problem, path: &Path) -> Resultant {
        let per_force =
            -1.0 / (Self::modulus(problem) * self.lever.powi(2) * self.per_creepage(path));
        slope.scaled(per_force, per_force / self.lever)
    }

    /// Shear modulus of both bodies, in Pa.
    fn modulus(problem: &Problem) -> f64 {
        let [wheel, rail] =
            [&problem.interface.wheel, &problem.interface.rail].map(|b| b.material.shear_modulus());
        2.0 / (1.0 / wheel + 1.0 / rail)
    }

    /// The abscissa that corresponds to a creepage of one at the distance c.
    fn per_creepage(&self, path: &Path) -> f64 {
        if path.abscissa() == Some(Abscissa::Spin) { self.lever } else { 1.0 }
    }
}
