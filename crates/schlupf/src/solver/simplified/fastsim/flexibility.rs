//! The flexibilities of FASTSIM, from Kalker's coefficients.

use std::f64::consts::PI;

use crate::bodies::Kinematics;
use crate::numerics::lanes::{Lanes, dot};
use crate::problem::{Brush, Flexibilities, SlopeReduction};
use crate::solver::simplified::EllipticContact;

use super::path::Path;

/// L1, L2, L3 for longitudinal, lateral and spin creepage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flexibility {
    /// L1, in m³/N.
    pub longitudinal: f64,
    /// L2, in m³/N.
    pub lateral: f64,
    /// L3, in m³/N.
    pub spin: f64,
    /// k of modified FASTSIM, by which the flexibilities of the bodies have been divided; otherwise
    /// 1. Dimensionless.
    pub reduction: f64,
}

impl Flexibility {
    /// That of no bodies.
    pub const RIGID: Self = Self { longitudinal: 0.0, lateral: 0.0, spin: 0.0, reduction: 1.0 };

    /// L1 = 8a/(3 G C11), L2 = 8a/(3 G C22), L3 = π a²/(4 G √(ab) C23): with these a patch in full
    /// adhesion has the forces of the linear theory (Kalker 1982).
    fn three(contact: &EllipticContact) -> Self {
        let a = contact.normal.semi_axis_x;
        let per_modulus = a / contact.shear_modulus;
        let c = &contact.coefficients;
        Self {
            longitudinal: 8.0 / 3.0 * per_modulus / c.c11,
            lateral: 8.0 / 3.0 * per_modulus / c.c22,
            spin: 0.25 * PI * per_modulus * a / (contact.lever() * c.c23),
            reduction: 1.0,
        }
    }

    /// The flexibilities for a motion: all three, or their mean L = (|ξ| L1 + |η| L2 + c|φ|
    /// L3)/√(ξ² + η² + c²φ²) with c = √(ab) (Kalker 1982).
    pub fn new(brush: Brush, contact: &EllipticContact, motion: &Kinematics) -> Self {
        let three = Self::three(contact);
        let Kinematics { creepage_x, creepage_y, spin, .. } = *motion;
        let turning = contact.lever() * spin;
        let total = creepage_x.hypot(creepage_y).hypot(turning);
        if brush.flexibilities == Flexibilities::Three || total == 0.0 {
            return three;
        }
        let sum = creepage_x.abs() * three.longitudinal
            + creepage_y.abs() * three.lateral
            + turning.abs() * three.spin;
        let mean = sum / total;
        Self { longitudinal: mean, lateral: mean, spin: mean, reduction: 1.0 }
    }

    /// Growth of the traction on the rail along a path of a row in adhesion, in Pa.
    #[inline]
    pub fn stick_increment<T: Lanes>(&self, motion: &Kinematics, path: &Path<T>) -> [T; 2] {
        let more = path.of_row();
        let stiffness = [self.longitudinal, self.lateral].map(|l| T::from(l.recip()));
        let (turning, in_row) = (T::from(motion.spin / self.spin), T::from(self.spin.recip()));
        let along = (T::from(motion.creepage_x) * path.distance + more[0]) * stiffness[0];
        let across = (T::from(motion.creepage_y) * path.distance + more[1]) * stiffness[1];
        [along - turning * path.moment_y, across + (turning + path.spin * in_row) * path.moment_x]
    }

    /// The single flexibility (in m³/N) that converts traction (in Pa) lost to the limit into slip:
    /// the one that converts the increment of the traction into the rigid slip (in m) of the same
    /// path, as far as both are parallel, but within the largest and the smallest of the three.
    #[inline]
    pub fn along<T: Lanes>(&self, stick_increment: [T; 2], rigid_slip: [T; 2]) -> T {
        let Self { longitudinal, lateral, spin, .. } = *self;
        let smallest = T::from(longitudinal.min(lateral).min(spin));
        let largest = T::from(longitudinal.max(lateral).max(spin));
        let square = dot(stick_increment, stick_increment);
        let ratio = dot(stick_increment, rigid_slip) / square;
        let nothing = square.at_most(T::from(0.0));
        T::choose(nothing, smallest, ratio.max(smallest).min(largest))
    }

    /// The flexibilities divided by k.
    pub fn softened(self, reduction: f64) -> Self {
        Self {
            longitudinal: self.longitudinal / reduction,
            lateral: self.lateral / reduction,
            spin: self.spin / reduction,
            reduction,
        }
    }
}

/// k = k0 ((1 − α)/(1 + β ε) + α) for a [stress gradient](EllipticContact::stress_gradient) ε, all
/// dimensionless.
///
/// Source: Spiryagin, Polach and Cole, Creep force modelling for rail traction vehicles based on
/// the Fastsim algorithm, Vehicle System Dynamics 51 (2013) 1765–1783. Here ε is computed from
/// Kalker's coefficients without k0 and without spin; it is twice that for which the authors state
/// β.
pub(super) fn slope_reduction(reduction: SlopeReduction, gradient: f64) -> f64 {
    let SlopeReduction { initial, limit_ratio, decay } = reduction;
    initial * ((1.0 - limit_ratio) / (1.0 + decay * gradient) + limit_ratio)
}
