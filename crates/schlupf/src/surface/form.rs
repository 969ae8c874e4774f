//! Removal of form: the plane, cylinder or sphere that fits a surface best (ISO 25178-2,
//! F-operator).
//!
//! The fit minimises the sum of the squared vertical deviations. Cylinder and sphere are the
//! quadric
//!
//! n·r = ½ κ (|r|² − (t·r)²)
//!
//! with r = (x, y, z − c), the unit normal n in the middle of the surface, the curvature κ, and the
//! direction t of the axis (t = 0 for a sphere). These parameters are well defined for a flat
//! piece, too, where the centre is at infinity. They are found by least squares, starting from the
//! best paraboloid.

use nalgebra::DMatrix;

use super::HeightMap;
use crate::numerics::least_squares::{Limits, Minimum, Residuals, minimise};
use crate::numerics::vector::norm;
use crate::reporting::{Error, SurfaceError};

/// A nominal form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Form {
    /// A tilted plane.
    Plane,
    /// A circular cylinder in any direction.
    Cylinder,
    /// A sphere.
    Sphere,
}

impl Form {
    /// Name in case files and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Cylinder => "cylinder",
            Self::Sphere => "sphere",
        }
    }
}

/// A surface and the form removed from it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FormRemoval {
    /// The remaining vertical deviations.
    pub surface: HeightMap,
    /// Slope of the form along x and y in the middle, dimensionless.
    pub slope: [f64; 2],
    /// Radius of the form (in m), positive if convex; infinite for a plane.
    pub radius: f64,
    /// Angle between a cylinder's axis and x (in rad), from −π/2 to π/2; zero for other forms.
    pub axis: f64,
}

impl HeightMap {
    /// Removes a form.
    ///
    /// ```
    /// use schlupf::surface::{HeightMap, Lattice};
    /// use schlupf::surface::form::Form;
    ///
    /// let lattice = Lattice { columns: 20, rows: 10, spacing_x: 1e-6, spacing_y: 1e-6 };
    /// let tilted = (0..200).map(|cell| 1e-8 * f64::from(cell % 20));
    /// let ripple = (0..200).map(|cell| 1e-9 * f64::from(cell % 2));
    /// let heights = tilted.zip(ripple).map(|(plane, ripple)| plane + ripple).collect();
    /// let flat = HeightMap::new(lattice, heights)?.without_form(Form::Plane)?;
    /// assert!(flat.surface.heights().iter().all(|height| height.abs() < 1e-9));
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A form that does not fit the surface.
    pub fn without_form(&self, form: Form) -> Result<FormRemoval, Error> {
        let lattice = self.lattice();
        let scale = 0.5 * lattice.length_x().hypot(lattice.length_y());
        let points = lattice.points().map(|[x, y]| [x / scale, y / scale]);
        let found = Fit::new(points, self.heights(), scale).form(form)?;
        let Minimum { parameters, residuals, .. } =
            found.ok_or(SurfaceError::NoForm { form: form.name() })?;
        Ok(FormRemoval {
            surface: Self::new(*lattice, over(scale, residuals))?,
            slope: [parameters[1], parameters[2]],
            radius: parameters.get(3).map_or(f64::NEG_INFINITY, |curvature| -scale / curvature),
            axis: parameters.get(4).map_or(0.0, |angle| half_turn(*angle)),
        })
    }
}

/// Heights (in m) along a line, with points at a given spacing (in m), above the circle that fits
/// best, and its radius (in m), positive if convex.
pub(super) fn line_without_circle(spacing: f64, heights: &[f64]) -> Result<(Vec<f64>, f64), Error> {
    let half = 0.5 * heights.len() as f64;
    let scale = half * spacing;
    // A line across a sphere along y = 0: the parameters for y stay zero.
    let points = (0..heights.len()).map(|i| [(i as f64 + 0.5) / half - 1.0, 0.0]);
    let found = Fit::new(points, heights, scale).form(Form::Sphere)?;
    let Minimum { parameters, residuals, .. } =
        found.ok_or(SurfaceError::NoForm { form: "circle" })?;
    Ok((over(scale, residuals), -scale / parameters[3]))
}

/// Heights above a form (in m), from the residuals of the fit.
fn over(scale: f64, residuals: Vec<f64>) -> Vec<f64> {
    residuals.into_iter().map(|residual| -scale * residual).collect()
}

/// The same direction of a line, between −π/2 and π/2.
fn half_turn(angle: f64) -> f64 {
    use std::f64::consts::PI;
    angle - PI * (angle / PI).round()
}

/// Parameters of the quadric, with all lengths divided by the scale: height c and slopes in the
/// middle, curvature κ (negative if convex), and the angle of a cylinder's axis. Computed from the
/// best paraboloid 1, x, y, x², xy, y².
fn start(paraboloid: &[f64], form: Form) -> Vec<f64> {
    let [c, slope_x, slope_y, xx, xy, yy] = [0, 1, 2, 3, 4, 5].map(|k| paraboloid[k]);
    let mut parameters = vec![c, slope_x, slope_y, xx + yy];
    if form == Form::Cylinder {
        let turn = xy.hypot(xx - yy);
        // The axis is perpendicular to the direction of the larger curvature.
        let (curvature, sign) =
            if xx + yy >= 0.0 { (xx + yy + turn, 1.0) } else { (xx + yy - turn, -1.0) };
        let steepest = 0.5 * (sign * xy).atan2(sign * (xx - yy));
        parameters[3] = curvature;
        parameters.push(steepest + std::f64::consts::FRAC_PI_2);
    }
    parameters
}

/// Height of the quadric at a point; NaN where it does not extend that far.
fn quadric(parameters: &[f64], [x, y]: [f64; 2]) -> f64 {
    let [c, slope_x, slope_y, curvature] = [0, 1, 2, 3].map(|k| parameters[k]);
    let length = (1.0 + slope_x * slope_x + slope_y * slope_y).sqrt();
    let n = [-slope_x / length, -slope_y / length, length.recip()];
    let t = parameters.get(4).map_or([0.0; 3], |angle| tangent(n, *angle));
    // a z² + b z + d = 0
    let along = t[0] * x + t[1] * y;
    let a = -0.5 * curvature * (1.0 - t[2] * t[2]);
    let b = n[2] + curvature * t[2] * along;
    let d = n[0] * x + n[1] * y - 0.5 * curvature * (x * x + y * y - along * along);
    c - 2.0 * d / (b + (b * b - 4.0 * a * d).sqrt())
}

/// The unit vector across n at an angle from the x-direction.
fn tangent(n: [f64; 3], angle: f64) -> [f64; 3] {
    let length = n[0].hypot(n[2]);
    let first = [n[2] / length, 0.0, -n[0] / length];
    // n × first
    let second = [
        n[1] * first[2] - n[2] * first[1],
        n[2] * first[0] - n[0] * first[2],
        n[0] * first[1] - n[1] * first[0],
    ];
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    [0, 1, 2].map(|k| cosine * first[k] + sine * second[k])
}

/// Points and heights divided by the scale, and the form to be fitted.
struct Fit {
    points: Vec<[f64; 2]>,
    heights: Vec<f64>,
    shape: fn(&[f64], [f64; 2]) -> f64,
}

/// Maximum number of reductions of the initial curvature.
const FLATTENINGS: usize = 200;

/// Step for the derivatives.
const DIFFERENCE: f64 = 1e-6;

/// Fits end at rounding error.
const LIMITS: Limits =
    Limits { tolerance: 1e-12, reducible: 1e-16, negligible: 0.0, max_iterations: 100 };

impl Residuals for Fit {
    fn residuals(&mut self, parameters: &[f64]) -> Result<Option<Vec<f64>>, Error> {
        let pairs = self.points.iter().zip(&self.heights);
        let deviations: Vec<f64> = pairs.map(|(at, z)| (self.shape)(parameters, *at) - z).collect();
        Ok(norm(&deviations).is_finite().then_some(deviations))
    }

    /// By central differences, which are zero for a parameter without effect.
    fn jacobian(
        &mut self,
        parameters: &[f64],
        residuals: &[f64],
    ) -> Result<Option<DMatrix<f64>>, Error> {
        let mut jacobian = DMatrix::zeros(residuals.len(), parameters.len());
        for (k, mut column) in jacobian.column_iter_mut().enumerate() {
            let [above, below] = [DIFFERENCE, -DIFFERENCE].map(|step| {
                let mut moved = parameters.to_vec();
                moved[k] += step;
                moved
            });
            for (slope, at) in column.iter_mut().zip(&self.points) {
                let rise = (self.shape)(&above, *at) - (self.shape)(&below, *at);
                *slope = rise / (2.0 * DIFFERENCE);
            }
        }
        Ok(Some(jacobian))
    }
}

impl Fit {
    fn new(points: impl Iterator<Item = [f64; 2]>, heights: &[f64], scale: f64) -> Self {
        let heights = heights.iter().map(|height| height / scale).collect();
        Self { points: points.collect(), heights, shape: polynomial }
    }

    /// The best form: its parameters, and the deviations from it, divided by the scale.
    fn form(&mut self, form: Form) -> Result<Option<Minimum>, Error> {
        let terms = if form == Form::Plane { 3 } else { 6 };
        self.shape = polynomial;
        let found = minimise(self, &[0.0; 6][..terms], &LIMITS)?;
        let Some(Minimum { parameters, .. }) = &found else { return Ok(None) };
        if form == Form::Plane {
            return Ok(found);
        }
        self.shape = quadric;
        let mut start = start(parameters, form);
        for _ in 0..FLATTENINGS {
            if self.residuals(&start)?.is_some() {
                break;
            }
            // The paraboloid was too strongly curved for a sphere of its curvature to reach the
            // corners.
            start[3] *= 0.8;
        }
        minimise(self, &start, &LIMITS)
    }
}

/// Σ of the parameters times 1, x, y, x², xy, y², as many as there are.
fn polynomial(parameters: &[f64], [x, y]: [f64; 2]) -> f64 {
    parameters.iter().zip([1.0, x, y, x * x, x * y, y * y]).map(|(p, term)| p * term).sum()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::Lattice;
    use super::*;

    const LATTICE: Lattice = Lattice { columns: 60, rows: 45, spacing_x: 1e-5, spacing_y: 2e-5 };

    fn texture(x: f64, y: f64) -> f64 {
        1e-9 * (3e5 * x + 1e5 * y).sin()
    }

    fn largest(surface: &HeightMap) -> f64 {
        surface.heights().iter().fold(0.0, |largest, height| height.abs().max(largest))
    }

    #[test]
    fn a_plane_is_taken_off() {
        let plane = |x: f64, y: f64| 1e-6 + 0.02 * x - 0.1 * y;
        let surface = HeightMap::from_fn(LATTICE, |x, y| plane(x, y) + texture(x, y)).unwrap();
        let removal = surface.without_form(Form::Plane).unwrap();
        assert!(largest(&removal.surface) < 1.3e-9);
        assert_relative_eq!(removal.slope[1], -0.1, max_relative = 1e-4);
        assert_eq!(removal.radius.abs(), f64::INFINITY);
    }

    /// A ball of radius 2 mm whose summit is off-centre, and a cup: exact to rounding error.
    #[test]
    fn a_sphere_is_taken_off() {
        for sign in [1.0, -1.0] {
            let ball = |x: f64, y: f64| {
                let (x, y) = (x - 1e-4, y + 2e-4);
                sign * (4e-6_f64 - x * x - y * y).sqrt()
            };
            let surface = HeightMap::from_fn(LATTICE, ball).unwrap();
            let removal = surface.without_form(Form::Sphere).unwrap();
            assert_relative_eq!(removal.radius, sign * 2e-3, max_relative = 1e-8);
            assert!(largest(&removal.surface) < 1e-14, "{}", largest(&removal.surface));
        }
    }

    /// A wheel tread of 5 mm radius whose axis is oblique and tilted.
    #[test]
    fn a_cylinder_is_taken_off() {
        for angle in [0.3_f64, -1.2, 1.5] {
            let axis = [angle.cos(), angle.sin()];
            let tread = |x: f64, y: f64| {
                let across = -axis[1] * x + axis[0] * y - 1e-4;
                (25e-6 - across * across).sqrt() + texture(x, y)
            };
            let surface = HeightMap::from_fn(LATTICE, tread).unwrap();
            let removal = surface.without_form(Form::Cylinder).unwrap();
            assert_relative_eq!(removal.radius, 5e-3, max_relative = 1e-3);
            assert_relative_eq!(removal.axis, angle, epsilon = 1e-4);
            assert!(largest(&removal.surface) < 1.5e-9, "{}", largest(&removal.surface));
        }
    }

    /// Heights whose squares overflow have no form, and this is reported in finite time.
    #[test]
    fn heights_beyond_all_bounds_have_no_form() {
        let huge = HeightMap::from_fn(LATTICE, |x, _| 1e165 * (x / 1e-5).sin()).unwrap();
        for form in [Form::Sphere, Form::Cylinder] {
            let message = huge.without_form(form).unwrap_err().to_string();
            assert!(message.contains("fits the surface"), "{message}");
        }
    }

    /// A surface without curvature gives a sphere of nearly infinite radius, not an error.
    #[test]
    fn a_plane_is_a_large_sphere() {
        let surface = HeightMap::from_fn(LATTICE, |x, y| 0.3 * x + texture(x, y)).unwrap();
        for form in [Form::Sphere, Form::Cylinder] {
            let removal = surface.without_form(form).unwrap();
            assert!(removal.radius.abs() > 1.0, "{form:?} {}", removal.radius);
            assert!(largest(&removal.surface) < 1.3e-9);
        }
    }
}
