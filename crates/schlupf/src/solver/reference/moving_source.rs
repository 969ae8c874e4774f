//! Surface temperature under a fast-moving heat source.

use std::f64::consts::PI;

/// A semi-elliptic source q0 √(1 − x²/a²) that moves fast over a half-space: the largest surface
/// temperature rise is 1.2346 q √(a/v)/β at x = −0.65 a, with q the share of q0 that the body
/// receives.
///
/// ```
/// use schlupf::solver::reference::SemiEllipticSource;
///
/// let source =
///     SemiEllipticSource { flux: 1e8, half_length: 5e-3, speed: 30.0, effusivity: 13_290.0 };
/// let largest = 1.2346 * 1e8 * (5e-3_f64 / 30.0).sqrt() / 13_290.0;
/// assert!((source.temperature_rise(-0.65 * 5e-3) / largest - 1.0).abs() < 1e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SemiEllipticSource {
    /// Largest heat flux into the body q, in W/m².
    pub flux: f64,
    /// Half-length of the source a, in m.
    pub half_length: f64,
    /// Speed of the body through the source v, in m/s.
    pub speed: f64,
    /// Effusivity of the body β, in W √s/(m² K).
    pub effusivity: f64,
}

impl SemiEllipticSource {
    /// Temperature rise of the surface (in K) at x (in m), leading edge at x = a:
    /// T = 1/(β √(πv)) ∫ₓᵃ q(x') dx'/√(x' − x) (Knothe and Liebelt 1995), by the midpoint rule in
    /// √(x' − x), which removes the singularity.
    pub fn temperature_rise(&self, x: f64) -> f64 {
        let a = self.half_length;
        if x >= a {
            return 0.0;
        }
        let longest = (a - x).sqrt();
        let shortest = (-a - x).max(0.0).sqrt();
        let width = (longest - shortest) / NODES as f64;
        let sum: f64 = (0..NODES)
            .map(|k| {
                let root = shortest + (k as f64 + 0.5) * width;
                let position = (x + root * root) / a;
                (1.0 - position * position).max(0.0).sqrt()
            })
            .sum();
        self.flux * 2.0 * sum * width / (self.effusivity * (PI * self.speed).sqrt())
    }
}

const NODES: usize = 20_000;

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Knothe and Liebelt 1995: the maximum is 1.2346 q √(a/v)/β at x = −0.65 a, and the rise at
    /// the trailing edge is 0.862 of it.
    #[test]
    fn knothe_liebelt_1995_flash_temperature() {
        let source =
            SemiEllipticSource { flux: 1e8, half_length: 6e-3, speed: 30.0, effusivity: 13_290.0 };
        let unit = 1e8 * (6e-3_f64 / 30.0).sqrt() / 13_290.0;
        let (mut largest, mut place) = (0.0, 0.0);
        for k in 0..400_u32 {
            let x = 6e-3 * (1.0 - f64::from(k) / 200.0);
            let rise = source.temperature_rise(x);
            if rise > largest {
                (largest, place) = (rise, x / 6e-3);
            }
        }
        assert_relative_eq!(largest, 1.2346 * unit, max_relative = 1e-4);
        assert_relative_eq!(place, -0.65, epsilon = 0.01);
        let trailing = source.temperature_rise(-6e-3);
        assert_relative_eq!(trailing / largest, 0.862, max_relative = 1e-3);
    }
}
