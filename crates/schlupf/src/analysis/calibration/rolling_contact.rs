//! The contact on which the half-space and its substitutes are compared: an ellipse, a stiff
//! contact law, constant friction.

use std::f64::consts::PI;

use crate::analysis::ideal_contact::IdealContact;
use crate::bodies::Kinematics;
use crate::elasticity::HalfSpace;
use crate::interface::Incremental;
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solver::kalker_coefficients::creep_coefficients;
use crate::solver::reference::CreepCoefficients;

/// √(ab), in m; any value would do.
pub(super) const SIZE: f64 = 6e-3;

/// p0, in Pa.
pub(super) const PEAK_PRESSURE: f64 = 1e9;

/// μ, dimensionless.
pub(super) const FRICTION: f64 = 0.3;

/// k_c, in 1/m: close to Coulomb's law.
const STIFFNESS: f64 = 1e8;

/// One ellipse between half-spaces.
pub(super) struct RollingContact {
    pub bodies: HalfSpace,
    pub coefficients: CreepCoefficients,
    /// Along and across rolling, in m.
    pub semi_axes: [f64; 2],
    /// Rolling without creepage, on the half-space.
    pub problem: Problem,
}

impl RollingContact {
    pub fn new(axis_ratio: f64, poisson_ratio: f64) -> Result<Self, Error> {
        let coefficients = creep_coefficients(axis_ratio, poisson_ratio)?;
        let ideal = IdealContact { size: SIZE, peak_pressure: PEAK_PRESSURE, friction: FRICTION };
        let law = Incremental::new(STIFFNESS)?;
        let (problem, bodies) = ideal.problem(axis_ratio, poisson_ratio, law)?;
        let semi_axes = ideal.semi_axes(axis_ratio);
        Ok(Self { bodies, coefficients, semi_axes, problem })
    }

    /// Kinematics for creepages given as fractions of those at which Kalker's linear theory gives
    /// the force μN: along, across, spin.
    pub fn motion(&self, [along, across, spin]: [f64; 3]) -> Kinematics {
        // μN over C G s² and C G s³, N = (2/3) π s² p0.
        let strain = FRICTION * 2.0 / 3.0 * PI * PEAK_PRESSURE / self.bodies.shear_modulus();
        let CreepCoefficients { c11, c22, c23, .. } = self.coefficients;
        Kinematics {
            creepage_x: along * strain / c11,
            creepage_y: across * strain / c22,
            spin: spin * strain / (c23 * SIZE),
            ..Kinematics::free_rolling(1.0)
        }
    }
}
