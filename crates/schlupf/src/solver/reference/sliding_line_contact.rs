//! Stresses below a line contact: McEwen, *Stresses in elastic cylinders in contact along a
//! generatrix*, Phil. Mag. (1949), for the pressure; Smith and Liu, *Stresses due to tangential and
//! normal loads on an elastic solid with application to some contact stress problems*, J. Appl.
//! Mech. (1953), for the traction; both in the form of Johnson, *Contact Mechanics* (1985), §4.2
//! and §7.1.

/// A half-space in plane strain under the pressure p0 √(1 − x²/a²) and the traction f p0 √(1 −
/// x²/a²) along x, both acting on it.
///
/// With r = a² − x² + z², m² = ½ (√(r² + 4x²z²) + r), n² = ½ (√(r² + 4x²z²) − r), and n with the
/// sign of x, and z into the half-space, the pressure causes
///
/// σxx = −(p0/a) (m (1 + (z² + n²)/(m² + n²)) − 2z),
/// σzz = −(p0/a) m (1 − (z² + n²)/(m² + n²)),  σxz = −(p0/a) n (m² − z²)/(m² + n²),
///
/// and the traction f times σzz' = σxz, σxz' = σxx, both of the pressure, and
///
/// σxx' = (p0/a) (n (2 − (z² − m²)/(m² + n²)) − 2x).
///
/// Limits: elastic, long across rolling compared with a.
///
/// ```
/// use schlupf::solver::reference::SlidingLineContact;
///
/// let line = SlidingLineContact { half_length: 5e-3, peak_pressure: 1e9, traction_ratio: 0.3 };
/// let [xx, zz, _] = line.stress(0.0, 0.0);
/// assert_eq!([xx, zz], [-1e9, -1e9]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingLineContact {
    /// Half-length of the contact a, in m.
    pub half_length: f64,
    /// Largest pressure p0, in Pa.
    pub peak_pressure: f64,
    /// Traction over pressure f, dimensionless: positive along x.
    pub traction_ratio: f64,
}

impl SlidingLineContact {
    /// σxx, σzz and σxz (in Pa) at x and at a depth z (both in m); z points into the body.
    pub fn stress(&self, x: f64, z: f64) -> [f64; 3] {
        let a = self.half_length;
        let r = a * a - x * x + z * z;
        let root = r.hypot(2.0 * x * z);
        let sum = root;
        let m = (0.5 * (root + r).max(0.0)).sqrt();
        let n = (0.5 * (root - r).max(0.0)).sqrt().copysign(x);
        // At the ends of the contact m, n and z vanish, and these ratios are multiplied by them.
        let over = |value: f64| if sum > 0.0 { value / sum } else { 0.0 };
        let part = over(z * z + n * n);
        let xx = 2.0 * z - m * (1.0 + part);
        let zz = m * (part - 1.0);
        let xz = -n * over(m * m - z * z);
        let dragged = n * (2.0 - over(z * z - m * m)) - 2.0 * x;
        let f = self.traction_ratio;
        [xx + f * dragged, zz + f * xz, xz + f * xx].map(|s| s * self.peak_pressure / a)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

    use approx::assert_relative_eq;

    use super::*;

    /// At the ends of the contact only the traction is left: σxx = ∓2 f p0 (Johnson 1985, §7.1).
    #[test]
    fn the_ends_are_stretched_and_compressed_by_the_traction() {
        let line =
            SlidingLineContact { half_length: 2e-3, peak_pressure: 1e9, traction_ratio: 0.3 };
        assert_eq!(line.stress(2e-3, 0.0), [-0.6e9, 0.0, 0.0]);
        assert_eq!(line.stress(-2e-3, 0.0), [0.6e9, 0.0, 0.0]);
    }

    /// The sum of the stresses of Flamant under line loads, normal (−2P/π x²z, z³, xz² over r⁴) and
    /// tangential (−2Q/π x³, xz², x²z over r⁴), by the midpoint rule over s = a sin θ.
    #[test]
    fn flamant_1892_line_loads_add_up() {
        const PARTS: u32 = 4000;
        let line = SlidingLineContact { half_length: 2.0, peak_pressure: 3.0, traction_ratio: 0.4 };
        for [x, z] in [[0.3, 0.5], [-1.7, 0.9], [2.6, 0.4], [-3.0, 2.0], [0.0, 1.5]] {
            let mut sum = [0.0; 3];
            for k in 0..PARTS {
                let angle = ((f64::from(k) + 0.5) / f64::from(PARTS) * 2.0 - 1.0) * FRAC_PI_2;
                let load =
                    3.0 * angle.cos() * 2.0 * angle.cos() * 2.0 * FRAC_PI_2 / f64::from(PARTS);
                let way = x - 2.0 * angle.sin();
                let factor = -FRAC_2_PI * load / (way * way + z * z).powi(2) * (z + 0.4 * way);
                for (total, part) in sum.iter_mut().zip([way * way, z * z, way * z]) {
                    *total += factor * part;
                }
            }
            for (found, expected) in line.stress(x, z).into_iter().zip(sum) {
                assert_relative_eq!(found, expected, max_relative = 1e-9, epsilon = 1e-9);
            }
        }
    }
}
