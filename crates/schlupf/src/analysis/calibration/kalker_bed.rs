//! Winkler bedding with Kalker's flexibilities: under small creepages its forces are those of the
//! half-space.

use crate::elasticity::Winkler;
use crate::elasticity::half_space::HalfSpace;
use crate::reporting::Error;
use crate::solver::kalker_coefficients::interpolated_coefficients;
use crate::solver::reference::kalker_linear::CreepCoefficients;

/// The Winkler bedding for an elliptic patch with these semi-axes along and across rolling (in m):
///
/// c_x = 3 C11 G/(8a),  c_y = 3 C22 G/(8a),
///
/// with which a patch without sliding has the forces of Kalker's linear theory under longitudinal
/// and lateral creepage (Kalker, A fast algorithm for the simplified theory of rolling contact,
/// Vehicle System Dynamics 11 (1982) 1–13). This does not hold under spin, which would need a third
/// constant.
///
/// ```
/// use schlupf::analysis::calibration::kalker_bed;
/// use schlupf::elasticity::half_space::HalfSpace;
/// use schlupf::bodies::Material;
/// use schlupf::Problem;
///
/// let steel = HalfSpace::new(&Material::STEEL, &Material::STEEL)?;
/// let problem = Problem::builder().elasticity(kalker_bed(&steel, [6e-3, 5e-3])?).build()?;
/// assert!(problem.check().is_ok());
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Semi-axes that are not positive and finite.
pub fn kalker_bed(bodies: &HalfSpace, semi_axes: [f64; 2]) -> Result<Winkler, Error> {
    let [a, b] = semi_axes;
    let coefficients = interpolated_coefficients(a / b, bodies.poisson_ratio())?;
    let [x, y] = bedding(&coefficients, bodies.shear_modulus(), a);
    Ok(Winkler::new(x, y)?.growing_with_the_patch())
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
