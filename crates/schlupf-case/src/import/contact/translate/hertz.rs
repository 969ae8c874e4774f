//! Hertz's contact from whatever the input file gives of it.

use schlupf::Error;
use schlupf::bodies::{Material, contact_modulus};
use schlupf::normal::{Hertz, NormalSummary, PressureSource};

use crate::import::contact::material::Elastic;

/// E* of both bodies, in Pa.
pub fn modulus(elastic: &Elastic) -> f64 {
    let [first, second] = [0, 1].map(|body| {
        let (shear, poisson) = (elastic.shear_modulus[body].value, elastic.poisson[body].value);
        Material {
            young_modulus: 2e6 * shear * (1.0 + poisson),
            poisson_ratio: poisson,
            ..Material::STEEL
        }
    });
    contact_modulus(&first, &second)
}

/// The contact with the distance A x² + B y² (both in 1/m) under a load (in N).
pub fn contact(curvatures: [f64; 2], modulus: f64, load: f64) -> Result<NormalSummary, Error> {
    let [x, y] = curvatures;
    Ok(Hertz::from_curvatures(x, y, modulus, load)?.normal_contact(None)?.summary)
}

/// The load (in N) under which the approach (in m) is reached: it grows with it to the power of
/// 3/2.
pub fn load(curvatures: [f64; 2], modulus: f64, approach: f64) -> Result<f64, Error> {
    let unit = contact(curvatures, modulus, 1.0)?;
    let of_unit = unit.approach.unwrap_or(f64::NAN);
    Ok((approach / of_unit).powf(1.5))
}

/// B over A for which the ellipse has a ratio a/b, dimensionless.
///
/// The axis ratio falls with A/B and does not depend on load or modulus: bisection on ln(B/A).
pub fn curvature_ratio(axis_ratio: f64) -> Result<f64, Error> {
    let (mut low, mut high) = (1e-5_f64.ln(), 1e5_f64.ln());
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let found = contact([1.0, middle.exp()], 1e9, 1.0)?;
        if found.semi_axis_x / found.semi_axis_y < axis_ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    let ratio = (0.5 * (low + high)).exp();
    let found = contact([1.0, ratio], 1e9, 1.0)?;
    if (found.semi_axis_x / found.semi_axis_y / axis_ratio - 1.0).abs() < 1e-6 {
        return Ok(ratio);
    }
    // So slender that it is a line: the error says so.
    let beyond = ratio * ratio * ratio;
    contact([1.0, beyond], 1e9, 1.0).map(|_| beyond)
}

/// The load (in N) under which bodies whose ellipse is given (in m) have an approach (in m).
pub fn load_of_ellipse([a, b]: [f64; 2], modulus: f64, approach: f64) -> Result<f64, Error> {
    // Similar contacts have the same approach over A a².
    let ratio = curvature_ratio(a / b)?;
    let unit = contact([1.0, ratio], modulus, 1.0)?;
    let of_unit = unit.approach.unwrap_or(f64::NAN);
    let distance = approach / (a * a) * unit.semi_axis_x.powi(2) / of_unit;
    load([distance, distance * ratio], modulus, approach)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A contact found from its curvatures is found again from each of its other descriptions.
    #[test]
    fn all_descriptions_are_of_one_contact() {
        for curvatures in [[0.8, 2.5], [1.5, 1.5], [3.0, 0.2]] {
            let known = contact(curvatures, 1.1e11, 7e4).unwrap();
            let approach = known.approach.unwrap();
            let axes = known.semi_axes();
            assert_relative_eq!(
                load(curvatures, 1.1e11, approach).unwrap(),
                7e4,
                max_relative = 1e-12
            );
            let ratio = curvature_ratio(axes[0] / axes[1]).unwrap();
            assert_relative_eq!(ratio, curvatures[1] / curvatures[0], max_relative = 1e-9);
            assert_relative_eq!(
                load_of_ellipse(axes, 1.1e11, approach).unwrap(),
                7e4,
                max_relative = 1e-9
            );
        }
    }
}
