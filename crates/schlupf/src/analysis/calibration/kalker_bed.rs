//! Winkler bedding with Kalker's flexibilities: under small creepages its forces are those of the
//! half-space.

use crate::elasticity::{Compliance, Elasticity, HalfSpace, Winkler};
use crate::normal::Grid;
use crate::reporting::Error;
use crate::solver::kalker_coefficients::interpolated_coefficients;
use crate::solver::reference::CreepCoefficients;

/// A Winkler bedding whose stiffnesses follow from the patch, of semi-axes a and b:
///
/// c_x = 3 C11 G/(8a),  c_y = 3 C22 G/(8a),
///
/// with which an elliptic patch without sliding has the forces of Kalker's linear theory under
/// longitudinal and lateral creepage (Kalker, A fast algorithm for the simplified theory of rolling
/// contact, Vehicle System Dynamics 11 (1982) 1–13). This does not hold under spin, which would
/// need a third constant. Other patches are treated like the ellipse with the same extent.
///
/// ```
/// use schlupf::analysis::calibration::KalkerBed;
/// use schlupf::bodies::Material;
/// use schlupf::elasticity::HalfSpace;
/// use schlupf::Problem;
///
/// let bodies = HalfSpace::new(&Material::STEEL, &Material::STEEL)?;
/// let problem = Problem::builder().elasticity(KalkerBed { bodies }).build()?;
/// assert!(problem.check().is_ok());
/// # Ok::<(), schlupf::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KalkerBed {
    /// The bodies whose forces it has.
    pub bodies: HalfSpace,
}

impl KalkerBed {
    /// The bedding for a patch with these semi-axes along and across rolling, in m.
    ///
    /// # Errors
    /// Semi-axes that are not positive and finite.
    pub fn on(&self, semi_axes: [f64; 2]) -> Result<Winkler, Error> {
        let [a, b] = semi_axes;
        let coefficients = interpolated_coefficients(a / b, self.bodies.poisson_ratio())?;
        let [x, y] = bedding(&coefficients, self.bodies.shear_modulus(), a);
        Ok(Winkler::new(x, y)?.growing_with_the_patch())
    }
}

impl Elasticity for KalkerBed {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        self.on(grid.semi_axes())?.compliance(grid)
    }

    fn assumes_ellipse(&self) -> bool {
        true
    }
}

/// Beddings along and across rolling (in N/m³) for a shear modulus G (in Pa) and a semi-axis a (in
/// m).
pub(super) fn bedding(
    coefficients: &CreepCoefficients,
    shear_modulus: f64,
    semi_axis_x: f64,
) -> [f64; 2] {
    [coefficients.c11, coefficients.c22].map(|c| 3.0 * c * shear_modulus / (8.0 * semi_axis_x))
}
