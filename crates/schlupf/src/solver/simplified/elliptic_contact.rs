//! The contact of the fast methods: an ellipse, its load, and Kalker's coefficients.

use std::f64::consts::PI;

use crate::bodies::Kinematics;
use crate::elasticity::HalfSpace;
use crate::interface::friction::FrictionState;
use crate::normal::NormalSummary;
use crate::numerics::dual::Number;
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solution::Resultant;
use crate::solver::kalker_coefficients::interpolated_coefficients;
use crate::solver::reference::{CreepCoefficients, linear_force};

/// An elliptic contact of two half-spaces. A non-elliptical patch is represented by the ellipse
/// with its length and width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipticContact {
    /// Load and semi-axes.
    pub normal: NormalSummary,
    /// Shear modulus G of both bodies, 1/G = ½ (1/G₁ + 1/G₂), in Pa.
    pub shear_modulus: f64,
    /// C11, C22, C23, C33 of the bodies alone.
    of_bodies: CreepCoefficients,
    /// Compliance h/G of the layer between the surfaces (in m/Pa); zero if there is none.
    layer_compliance: f64,
    /// C11, C22, C23, C33, with the layer.
    pub coefficients: CreepCoefficients,
}

impl EllipticContact {
    /// The contact of a problem.
    pub fn new(problem: &Problem) -> Result<Self, Error> {
        Self::of(problem, problem.normal.normal_contact(None)?.summary)
    }

    /// The contact of a problem with the given sizes.
    pub(crate) fn of(problem: &Problem, normal: NormalSummary) -> Result<Self, Error> {
        let bodies =
            HalfSpace::new(&problem.interface.wheel.material, &problem.interface.rail.material)?;
        let axis_ratio = normal.semi_axis_x / normal.semi_axis_y;
        let of_bodies = interpolated_coefficients(axis_ratio, bodies.poisson_ratio())?;
        let shear_modulus = bodies.shear_modulus();
        Ok(Self::new_of(normal, shear_modulus, of_bodies, problem.interface.layer_compliance()))
    }

    /// An ellipse with bodies of shear modulus G (in Pa) and a layer of compliance h/G, in m/Pa.
    pub(crate) fn new_of(
        normal: NormalSummary,
        shear_modulus: f64,
        of_bodies: CreepCoefficients,
        layer_compliance: f64,
    ) -> Self {
        let coefficients = of_bodies;
        let contact = Self { normal, shear_modulus, of_bodies, layer_compliance, coefficients };
        contact.resized(normal)
    }

    /// The same bodies and layer with another load and another size of a like patch.
    pub(crate) fn resized(&self, normal: NormalSummary) -> Self {
        let [c11, c22, c23, c33] = self.ellipse(normal.semi_axes()).coefficients;
        let coefficients = CreepCoefficients { c11, c22, c23, c33 };
        Self { normal, coefficients, ..*self }
    }

    /// The patch under its load.
    pub(super) fn present_ellipse(&self) -> Ellipse<f64> {
        let CreepCoefficients { c11, c22, c23, c33 } = self.coefficients;
        Ellipse {
            semi_axes: self.normal.semi_axes(),
            shear_modulus: self.shear_modulus,
            coefficients: [c11, c22, c23, c33],
        }
    }

    /// The patch with semi-axes (in m) of the same ratio, which may have derivatives.
    pub(crate) fn ellipse<T: Number>(&self, semi_axes: [T; 2]) -> Ellipse<T> {
        let CreepCoefficients { c11, c22, c23, c33 } = self.of_bodies;
        let of_bodies = [c11, c22, c23, c33].map(T::from);
        Ellipse::with_layer(of_bodies, semi_axes, (self.shear_modulus, self.layer_compliance))
    }

    /// Compliance h/G of the layer between the surfaces, in m/Pa.
    pub(crate) fn layer_compliance(&self) -> f64 {
        self.layer_compliance
    }

    /// Lever arm √(ab), in m.
    pub fn lever(&self) -> f64 {
        (self.normal.semi_axis_x * self.normal.semi_axis_y).sqrt()
    }

    /// Forces and moment on the wheel in full adhesion.
    pub fn linear_force(&self, kinematics: &Kinematics) -> Resultant {
        let semi_axes = self.normal.semi_axes();
        self.coefficients.force(kinematics, semi_axes, self.shear_modulus)
    }

    /// Polach's gradient of the tangential stress in the area of adhesion, dimensionless, for a
    /// friction limit μN in N: ε = G π a b √((C11 ξ)² + (C22 η)²)/(4 μN), without spin.
    pub fn stress_gradient(&self, kinematics: &Kinematics, limit: f64) -> f64 {
        let force = self.linear_force(&Kinematics { spin: 0.0, ..*kinematics });
        0.25 * PI * force.x.hypot(force.y) / limit
    }
}

/// The patch of an elliptic contact, in numbers that may have derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ellipse<T> {
    /// a and b, in m.
    pub semi_axes: [T; 2],
    /// G of both bodies, in Pa.
    pub shear_modulus: f64,
    /// C11, C22, C23 and C33, dimensionless.
    pub coefficients: [T; 4],
}

impl<T: Number> Ellipse<T> {
    /// From C11, C22, C23 and C33 of the bodies alone, the semi-axes (in m), the shear modulus (in
    /// Pa), and the compliance h/G of a layer, in m/Pa.
    ///
    /// The coefficients are those with the layer in series, for which the springs that stand for
    /// the bodies, L1 = 8a/(3 G C11), L2 = 8a/(3 G C22), L3 = π a²/(4 G √(ab) C23) (Kalker 1982)
    /// and 8 b/(15 G C33) for the moment, are as much softer as the layer.
    pub fn with_layer(
        of_bodies: [T; 4],
        semi_axes: [T; 2],
        (shear_modulus, layer_compliance): (f64, f64),
    ) -> Self {
        let [a, b] = semi_axes;
        let relative = layer_compliance * shear_modulus;
        let soft = |c: T, unit: T| c / (T::from(1.0) + c * relative / unit);
        let [c11, c22, c23, c33] = of_bodies;
        let coefficients = if relative > 0.0 {
            [
                soft(c11, a * (8.0 / 3.0)),
                soft(c22, a * (8.0 / 3.0)),
                soft(c23, a * a / (a * b).sqrt() * (0.25 * PI)),
                soft(c33, b * (8.0 / 15.0)),
            ]
        } else {
            of_bodies
        };
        Self { semi_axes, shear_modulus, coefficients }
    }

    /// √(ab), in m.
    pub fn lever(&self) -> T {
        (self.semi_axes[0] * self.semi_axes[1]).sqrt()
    }

    /// Fx, Fy (in N) and Mz (in N m) in full adhesion, under ξ, η (dimensionless) and φ, in 1/m.
    pub fn linear_force(&self, creepages: [T; 3]) -> [T; 3] {
        linear_force(self.coefficients, creepages, self.semi_axes, self.shear_modulus)
    }
}

/// Friction limit μN of the force, in N, with friction at the slip speed v0 √(ξ² + η²) of the
/// contact as a whole, at y = 0, at the temperature of the entering material.
pub(super) fn friction_limit(problem: &Problem, load: f64) -> f64 {
    let law = &problem.interface.friction.law;
    // The temperature of the entering material takes half as long as a fast method.
    let state = if law.is_constant() { FrictionState::default() } else { friction_state(problem) };
    load * law.respond(&state).coefficient
}

/// The arguments of the friction law there.
pub fn friction_state(problem: &Problem) -> FrictionState {
    let motion = &problem.kinematics;
    let slip_speed = motion.speed * motion.creepage_x.hypot(motion.creepage_y);
    problem.interface.friction_state(&problem.interface.conduction(motion), 0.0, slip_speed, 0.0)
}
