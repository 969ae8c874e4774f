//! Hertz contact.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{NormalContact, NormalSummary, Pressure, PressureSource};
use crate::numerics::root::bisection;
use crate::reporting::{Error, Quantity, Requirement, require, require_positive};

/// Radii of curvature of a body at the contact: positive where convex, negative where concave,
/// infinite where flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Radii {
    /// In the plane along rolling, in m.
    pub x: f64,
    /// In the plane across rolling, in m.
    pub y: f64,
}

impl Radii {
    /// A body curved along rolling only, with a radius in m: a cylindrical wheel.
    pub const fn along(radius: f64) -> Self {
        Self { x: radius, y: f64::INFINITY }
    }

    /// A body curved across rolling only, with a radius in m: a straight rail.
    pub const fn across(radius: f64) -> Self {
        Self { x: f64::INFINITY, y: radius }
    }
}

/// Hertz contact determined by the radii of two bodies and their load.
///
/// Hertz contact of two smooth elastic bodies with curvatures in two planes (Hertz 1882; Johnson,
/// *Contact Mechanics*, 1985, §4.2).
///
/// The displacement under a semi-ellipsoidal pressure is, for an ellipse with semi-axes a and b,
///
/// u_z(x, y) = 3N/(4πE*) ∫₀^∞ (1 − x²/(a²+s) − y²/(b²+s)) ds / √((a²+s)(b²+s)s),
///
/// and must equal δ − A x² − B y². In Carlson's symmetric integrals, for any ratio of a to b,
///
/// δ = 3N/(2πE*) R_F(0, a², b²),  A = N/(2πE*) R_D(0, b², a²),  B = N/(2πE*) R_D(0, a², b²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    curvature_x: f64,
    curvature_y: f64,
    contact_modulus: f64,
    load: f64,
}

/// Largest ratio of the curvature sums; beyond it the contact is a line.
const LARGEST_CURVATURE_RATIO: f64 = 1e5;

impl Hertz {
    /// A contact of bodies with the given radii and contact modulus E* (in Pa) under `load` (in N).
    ///
    /// ```
    /// use schlupf::bodies::{Material, contact_modulus};
    /// use schlupf::normal::{PressureSource, Hertz, Radii};
    ///
    /// let modulus = contact_modulus(&Material::STEEL, &Material::STEEL);
    /// // Crossed cylinders of one radius touch in a circle.
    /// let hertz = Hertz::new(Radii::along(0.46), Radii::across(0.46), modulus, 80e3)?;
    /// let contact = hertz.normal_contact(None)?.summary;
    /// assert!((contact.semi_axis_x / contact.semi_axis_y - 1.0).abs() < 1e-9);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A radius of zero, a curvature sum that is not positive (a flat contact, or a line), or one
    /// so much smaller than the other that the contact is practically a line.
    pub fn new(wheel: Radii, rail: Radii, contact_modulus: f64, load: f64) -> Result<Self, Error> {
        require_positive(Quantity::Load, load)?;
        let curvature_x =
            curvature_sum([(Quantity::WheelRadiusX, wheel.x), (Quantity::RailRadiusX, rail.x)])?;
        let curvature_y =
            curvature_sum([(Quantity::WheelRadiusY, wheel.y), (Quantity::RailRadiusY, rail.y)])?;
        let ratio = curvature_x / curvature_y;
        if !(1.0 / LARGEST_CURVATURE_RATIO..=LARGEST_CURVATURE_RATIO).contains(&ratio) {
            let curvatures = [curvature_x, curvature_y];
            return Err(Error::LineContact { curvatures, most: LARGEST_CURVATURE_RATIO });
        }
        Ok(Self { curvature_x, curvature_y, contact_modulus, load })
    }

    /// The same to an approach δ of distant points (in m) in place of a load, N ∝ δ^(3/2).
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn from_approach(
        wheel: Radii,
        rail: Radii,
        contact_modulus: f64,
        approach: f64,
    ) -> Result<Self, Error> {
        require_positive(Quantity::Approach, approach)?;
        let unit = Self::new(wheel, rail, contact_modulus, 1.0)?;
        let load = (approach / unit.approach(1.0)).powf(1.5);
        require_positive(Quantity::Load, load)?;
        Ok(Self { load, ..unit })
    }

    /// A contact with the undeformed distance z = A x² + B y², A and B in 1/m.
    pub fn from_curvatures(
        distance_x: f64,
        distance_y: f64,
        contact_modulus: f64,
        load: f64,
    ) -> Result<Self, Error> {
        let radii = Radii { x: 0.5 / distance_x, y: 0.5 / distance_y };
        let flat = Radii { x: f64::INFINITY, y: f64::INFINITY };
        Self::new(radii, flat, contact_modulus, load)
    }

    /// Semi-axes a and b (in m) under `load` (in N).
    fn semi_axes(&self, load: f64) -> [f64; 2] {
        let ratio = axis_ratio(self.curvature_x / self.curvature_y);
        // With a = r c and b = c/r the integrals scale as c⁻³.
        let root = ratio.sqrt();
        let unit_integral = carlson_d(root.recip().powi(2), root.powi(2));
        let distance_x = 0.5 * self.curvature_x;
        let scale = (load * unit_integral / (TAU * self.contact_modulus * distance_x)).cbrt();
        [scale * root, scale / root]
    }

    /// Approach (in m) under `load` (in N).
    fn approach(&self, load: f64) -> f64 {
        let [a, b] = self.semi_axes(load);
        3.0 * load / (TAU * self.contact_modulus) * carlson_f(a * a, b * b)
    }
}

impl PressureSource for Hertz {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        let load = load.unwrap_or(self.load);
        require_positive(Quantity::Load, load)?;
        let [a, b] = self.semi_axes(load);
        let summary = NormalSummary {
            load,
            semi_axis_x: a,
            semi_axis_y: b,
            peak_pressure: 3.0 * load / (TAU * a * b),
            approach: Some(self.approach(load)),
            origin: None,
            parts: 1,
        };
        Ok(NormalContact { summary, pressure: Pressure::Elliptic, rows: None })
    }

    fn undeformed_distance(&self, x: &[f64], y: &[f64]) -> Option<Vec<f64>> {
        let [along, across] = [self.curvature_x, self.curvature_y].map(|curvature| 0.5 * curvature);
        let row = |y: &f64| {
            let of_row = across * y * y;
            x.iter().map(move |x| along * x * x + of_row)
        };
        Some(y.iter().flat_map(row).collect())
    }

    fn load_exponent(&self) -> Option<f64> {
        Some(1.0 / 3.0)
    }
}

/// 1/R₁ + 1/R₂, in 1/m, which must be positive.
pub(super) fn curvature_sum(radii: [(Quantity, f64); 2]) -> Result<f64, Error> {
    for (quantity, radius) in radii {
        require(quantity, Requirement::NotZero, radius)?;
    }
    let sum = radii[0].1.recip() + radii[1].1.recip();
    if sum > 0.0 && sum.is_finite() {
        return Ok(sum);
    }
    Err(Error::CurvatureSum { radii: radii.map(|(quantity, _)| quantity), sum })
}

/// Axis ratio a/b of the ellipse for the ratio of curvature sums A/B = R_D(0,b²,a²)/R_D(0,a²,b²).
///
/// The right-hand side falls monotonically from ∞ to 0 with a/b: bisection on ln(a/b).
fn axis_ratio(curvature_ratio: f64) -> f64 {
    let excess = |log_ratio: f64| {
        let square = log_ratio.exp();
        carlson_d(square.recip(), square) / carlson_d(square, square.recip()) - curvature_ratio
    };
    // 20 · 2⁻⁶⁰ is below the spacing of floating-point numbers around 10.
    let [low, high] = bisection([-10.0, 10.0], 60, |log_ratio| excess(log_ratio) > 0.0);
    (0.5 * (low + high)).exp()
}

/// Shares A a²/δ and B b²/δ of the approach by which the distance grows up to the ends of the
/// ellipse, dimensionless, for the ratio A/B of curvature sums; from the largest ratio on those of
/// a line.
pub(crate) fn approach_shares(curvature_ratio: f64) -> [f64; 2] {
    shares_and_integral(curvature_ratio).0
}

/// These shares, and p0/(a A E*), dimensionless: the largest pressure over what it is in proportion
/// to, whatever the load.
pub(crate) fn shares_and_pressure(curvature_ratio: f64) -> ([f64; 2], f64) {
    let (shares, integral) = shares_and_integral(curvature_ratio);
    (shares, 1.0 / (shares[0] * integral))
}

/// The shares and R_F(0, a²/b², 1), with δ = p0 a/E* R_F.
fn shares_and_integral(curvature_ratio: f64) -> ([f64; 2], f64) {
    let range = [1.0 / LARGEST_CURVATURE_RATIO, LARGEST_CURVATURE_RATIO];
    let curvature_ratio = curvature_ratio.clamp(range[0], range[1]);
    let square = axis_ratio(curvature_ratio).powi(2);
    let integral = carlson_f(square, 1.0);
    let under = 3.0 * integral;
    ([square * carlson_d(1.0, square) / under, carlson_d(square, 1.0) / under], integral)
}

/// ∫₀¹ √((1 − t²)/(t² + η²)) dt, dimensionless: what a row of a semi-elliptic pressure does at a
/// distance of η times its half length.
pub(crate) fn row_potential(eta: f64) -> f64 {
    let square = 1.0 + eta * eta;
    carlson_d(eta * eta / square, 1.0) / (3.0 * square.sqrt())
}

/// R_D(0, y, z) of positive arguments.
fn carlson_d(y: f64, z: f64) -> f64 {
    3.0 * elliptic((z / y).sqrt(), [1.0, 0.0]) / (z * y.sqrt())
}

/// R_F(0, y, z) of positive arguments.
fn carlson_f(y: f64, z: f64) -> f64 {
    elliptic((z / y).sqrt(), [1.0, 1.0]) / y.sqrt()
}

/// ∫ (a cos²φ + b sin²φ)/√(cos²φ + k² sin²φ) dφ from 0 to π/2 for k > 0, by Landen's
/// transformation (R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions
/// III, Numerische Mathematik 13 (1969)); near its end every step squares the error.
fn elliptic(mut k: f64, [mut a, mut b]: [f64; 2]) -> f64 {
    let (mut mean, mut sum, mut product) = (1.0, 1.0, k);
    loop {
        let part = product / sum;
        (a, b) = (a + b / sum, 2.0 * (b + a * part));
        sum += part;
        let before = mean;
        mean += k;
        // What is not positive ends it, too.
        if (before - k).abs() <= 1e-8 * before || !(k > 0.0 && k.is_finite()) {
            return FRAC_PI_2 * (b + a * mean) / (mean * (mean + sum));
        }
        k = 2.0 * product.sqrt();
        product = k * mean;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const FLAT: Radii = Radii { x: f64::INFINITY, y: f64::INFINITY };

    /// DLMF 19.20.18: R_D(0, y, y) = 3π/(4 y^1.5), and R_D(0, 2, 1) = 1.7972103521 (Carlson 1995,
    /// Numerical computation of real or complex elliptic integrals, §4); R_F(0, y, y) = π/(2 √y),
    /// and R_F(0, 1, 2) = 1.3110287771 (there).
    #[test]
    fn carlson_integrals_are_the_published_ones() {
        assert_relative_eq!(carlson_d(4.0, 4.0), 3.0 * FRAC_PI_2 / 16.0, max_relative = 1e-15);
        assert_relative_eq!(carlson_d(2.0, 1.0), 1.797_210_352_103_388_3, max_relative = 1e-15);
        assert_relative_eq!(carlson_f(4.0, 4.0), FRAC_PI_2 / 2.0, max_relative = 1e-15);
        assert_relative_eq!(carlson_f(1.0, 2.0), 1.311_028_777_146_059_9, max_relative = 1e-15);
    }

    /// Contact modulus of two bodies with G = 82 GPa and ν = 0.28.
    fn steel() -> f64 {
        82.0e9 / (1.0 - 0.28)
    }

    /// Johnson 1985, Eqs. (4.22)–(4.24): a³ = 3NR/(4E*), δ = a²/R, p0 = 3N/(2πa²).
    #[test]
    fn johnson_1985_sphere_on_plane() {
        let (radius, load) = (0.4, 5.0e4);
        let hertz = Hertz::new(Radii { x: radius, y: radius }, FLAT, steel(), load).unwrap();
        let contact = hertz.normal_contact(None).unwrap().summary;
        let a = (0.75 * load * radius / steel()).cbrt();
        assert_relative_eq!(contact.semi_axis_x, a, max_relative = 1e-12);
        assert_relative_eq!(contact.semi_axis_y, a, max_relative = 1e-12);
        assert_relative_eq!(contact.approach.unwrap(), a * a / radius, max_relative = 1e-12);
    }

    /// Eurosprinter wheel of the CONTACT user guide (Vollebregt 2022), R = 625 mm, 106.7 kN.
    #[test]
    fn vollebregt_2022_locomotive_wheel() {
        let hertz = Hertz::new(Radii { x: 0.625, y: 1.7767 }, FLAT, steel(), 106.7e3).unwrap();
        let contact = hertz.normal_contact(None).unwrap().summary;
        // Half a unit of the last printed digit, and of that of the curvature.
        assert_relative_eq!(contact.semi_axis_x, 6.304e-3, max_relative = 1e-4);
        assert_relative_eq!(contact.semi_axis_y, 12.61e-3, max_relative = 4e-4);
        assert_relative_eq!(contact.peak_pressure, 641.1e6, max_relative = 2e-4);
        assert_relative_eq!(contact.approach.unwrap(), 0.0765e-3, max_relative = 1e-3);
    }

    /// Curvature sums of CONTACT's Manchester-type example: a = 5.88 mm, b = 10.54 mm, 770.4 MPa.
    #[test]
    fn vollebregt_2022_curvature_sums() {
        let hertz = Hertz::from_curvatures(1.015, 0.4215, steel(), 100.0e3).unwrap();
        let contact = hertz.normal_contact(None).unwrap().summary;
        assert_relative_eq!(contact.semi_axis_x, 5.88e-3, max_relative = 1e-3);
        assert_relative_eq!(contact.semi_axis_y, 10.54e-3, max_relative = 1e-3);
        assert_relative_eq!(contact.peak_pressure, 770.4e6, max_relative = 1e-3);
    }

    /// Rotating the bodies by 90° swaps the axes and changes nothing else; the displacement under
    /// the pressure equals the undeformed distance.
    #[test]
    fn hertz_1882_axes_swap_with_the_radii() {
        for radius in [0.01, 0.1, 0.5, 2.0, 500.0] {
            let along = Radii { x: radius, y: f64::INFINITY };
            let across = Radii { x: f64::INFINITY, y: radius };
            let cylinder = Radii { x: f64::INFINITY, y: 0.3 };
            let turned = Radii { x: 0.3, y: f64::INFINITY };
            let one = Hertz::new(along, cylinder, steel(), 1e5).unwrap();
            let two = Hertz::new(across, turned, steel(), 1e5).unwrap();
            let (one, two) = (
                one.normal_contact(None).unwrap().summary,
                two.normal_contact(None).unwrap().summary,
            );
            assert_relative_eq!(one.semi_axis_x, two.semi_axis_y, max_relative = 1e-10);
            assert_relative_eq!(one.semi_axis_y, two.semi_axis_x, max_relative = 1e-10);
            assert_relative_eq!(one.approach.unwrap(), two.approach.unwrap(), max_relative = 1e-10);
        }
    }

    /// Johnson 1985: half of the approach of a sphere; the shares are those of the closed form.
    #[test]
    fn shares_of_the_approach() {
        for share in approach_shares(1.0) {
            assert_relative_eq!(share, 0.5, max_relative = 1e-12);
        }
        let hertz = Hertz::from_curvatures(1.015, 0.4215, steel(), 100.0e3).unwrap();
        let contact = hertz.normal_contact(None).unwrap().summary;
        let [along, across] = approach_shares(1.015 / 0.4215);
        let approach = contact.approach.unwrap();
        assert_relative_eq!(along, 1.015 * contact.semi_axis_x.powi(2) / approach, epsilon = 1e-9);
        assert_relative_eq!(
            across,
            0.4215 * contact.semi_axis_y.powi(2) / approach,
            epsilon = 1e-9
        );
    }

    /// By the midpoint rule.
    #[test]
    fn potential_of_a_row() {
        for eta in [0.03, 0.4, 5.0_f64] {
            let value = |k: i32| {
                let square = ((f64::from(k) + 0.5) / 4e4).powi(2);
                ((1.0 - square) / (square + eta * eta)).sqrt() / 4e4
            };
            let sum: f64 = (0..40_000).map(value).sum();
            assert_relative_eq!(row_potential(eta), sum, max_relative = 1e-6);
        }
    }

    #[test]
    fn a_concave_rail_is_legal_and_a_line_is_refused() {
        let wheel = Radii { x: 0.46, y: 0.33 };
        let groove = Radii { x: f64::INFINITY, y: -0.4 };
        assert!(Hertz::new(wheel, groove, steel(), 8e4).is_ok());
        let tight = Radii { x: f64::INFINITY, y: -0.2 };
        let error = Hertz::new(wheel, tight, steel(), 8e4).unwrap_err().to_string();
        assert!(error.contains("must be positive"), "{error}");
        let roller = Radii { x: 0.46, y: f64::INFINITY };
        let error = Hertz::new(roller, FLAT, steel(), 8e4).unwrap_err().to_string();
        assert!(error.contains("line contact"), "{error}");
        let zero = Radii { x: 0.0, y: 1.0 };
        let error = Hertz::new(zero, FLAT, steel(), 8e4).unwrap_err().to_string();
        assert!(error.contains("wheel_radius_x must be other than 0"), "{error}");
    }
}
