//! Hertz's contact for the depth and the size of an overlap, from which that of a table deviates.

use crate::normal::{Hertz, PressureSource, approach_shares};
use crate::numerics::dual::Number;
use crate::numerics::interpolation::Cubics;
use crate::reporting::Error;

/// Logarithm of the largest ratio of the width to the length of an overlap, and steps up to it.
const LARGEST: f64 = 5.5;
const STEPS: usize = 88;

/// Logarithms of N/(E* a δ), and of a and b of the contact over those of the overlap, over the
/// logarithm of the ratio b/a of the overlap; dimensionless.
#[derive(Debug, Clone)]
pub(super) struct Ellipses(Cubics<3>);

/// A contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressed<T> {
    /// N, in N.
    pub load: T,
    /// a and b, in m.
    pub semi_axes: [T; 2],
}

impl Ellipses {
    pub fn new() -> Result<Self, Error> {
        let at = |log: f64| -> Result<_, Error> {
            let ratio = log.exp();
            // Overlaps of length 1 and width b/a are those of z = δ (x² + (y a/b)²).
            let shares = approach_shares(ratio * ratio).map(|share| 0.5 * share.ln());
            let of_unit = Hertz::from_curvatures(1.0, ratio.powi(-2), 1.0, 1.0)?;
            let approach = of_unit.normal_contact(None)?.summary.approach.unwrap_or(f64::NAN);
            Ok([-1.5 * approach.ln(), shares[0], shares[1]])
        };
        Ok(Self(Cubics::new([-LARGEST, LARGEST], STEPS, at)?))
    }

    /// The contact of bodies with E* (in Pa) whose overlap has a depth and semi-axes a and b, in m.
    pub fn pressed<T: Number>(&self, contact_modulus: f64, depth: T, [a, b]: [T; 2]) -> Pressed<T> {
        let ratio = b / a;
        let value = ratio.value();
        let [loads, along, across] = self.0.at(value.ln());
        let of = |[value, slope]: [f64; 2]| {
            let value = value.exp();
            ratio.chain(value, value * slope / ratio.value())
        };
        let load = a * depth * of(loads) * contact_modulus;
        Pressed { load, semi_axes: [a * of(along), b * of(across)] }
    }
}
