//! Péclet numbers: speed of a body through the contact relative to the speed at which heat spreads
//! in it.

use crate::reporting::Warning;

/// The Péclet number v a/κ below which, times (b/a)² on patches that are longer than wide, heat
/// also flows along the surface. At this number a flux like Hertz's pressure gives 0.2 % less than
/// with conduction perpendicular to the surface only; the difference is inversely proportional to
/// it.
const FAST: f64 = 500.0;

/// Péclet numbers of wheel and rail in a contact of semi-axes a along and b across rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peclet {
    /// v a/κ of wheel and rail, dimensionless.
    pub numbers: [f64; 2],
    /// b/a, dimensionless.
    aspect: f64,
}

impl Peclet {
    /// Péclet numbers for semi-axes `a`, `b` (in m), speeds of the material of wheel and rail
    /// through the contact (in m/s), and diffusivities κ (in m²/s).
    pub fn new([a, b]: [f64; 2], speeds: [f64; 2], diffusivities: [f64; 2]) -> Self {
        let number = |body: usize| speeds[body] * a / diffusivities[body];
        Self { numbers: [number(0), number(1)], aspect: b / a }
    }

    /// Whether heat flows perpendicular to the surface only, in both bodies, to about 0.2 % of the
    /// largest rise.
    pub fn is_fast(&self) -> bool {
        let narrow = self.aspect.powi(2).min(1.0);
        self.numbers.iter().all(|number| number * narrow >= FAST)
    }

    /// A warning if this does not hold, for temperatures that assume it: those of the contact, or
    /// those of the field below and behind it.
    pub fn caveat(&self, is_field: bool) -> Option<Warning> {
        let (peclet, is_narrow) = (self.numbers, self.aspect < 1.0);
        (!self.is_fast()).then_some(Warning::SlowRolling { peclet, is_narrow, is_field })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slower of the two bodies is decisive, and a narrow patch must be faster.
    #[test]
    fn the_slower_body_and_the_narrow_patch_count() {
        let of = |axes, speeds| Peclet::new(axes, speeds, [1e-5; 2]);
        assert!(of([1e-2, 1e-2], [1.0, 1.0]).is_fast());
        assert!(!of([1e-2, 1e-2], [1.0, 0.4]).is_fast());
        assert!(!of([1e-2, 5e-3], [1.0, 1.0]).is_fast());
        assert!(of([1e-2, 5e-2], [1.0, 1.0]).is_fast());
        assert_eq!(of([1e-2, 5e-2], [1.0, 1.0]).caveat(false), None);
        let caveat = of([1e-2, 1e-2], [1.0, 1e-2]).caveat(false).unwrap().to_string();
        assert!(caveat.contains("1.000e3 (wheel) and 1.000e1 (rail). Temperatures of all but"));
    }
}
