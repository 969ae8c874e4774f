//! Sliding without rolling: where every point slides, the traction is μ pₙ against the rigid slip.

use std::f64::consts::PI;

use crate::problem::look_up_table::Shape;

/// Rings and sectors of the ellipse. The integrand has a direction but no limit at the centre of
/// rotation, which costs a part of about a cell's area.
const RINGS: u32 = 160;
const SECTORS: u32 = 320;

/// Points of the unit circle with their share of Hertz's load.
pub(super) struct FullSliding {
    points: Vec<[f64; 3]>,
}

impl FullSliding {
    /// With ρ = sin θ the load between two ellipses is proportional to cos²θ sin θ dθ, and what
    /// slides around the centre is a smooth function of θ.
    pub fn new() -> Self {
        let mut points = Vec::new();
        for ring in 0..RINGS {
            let (radius, depth) = (0.5 * PI * (f64::from(ring) + 0.5) / f64::from(RINGS)).sin_cos();
            for sector in 0..SECTORS {
                let angle = 2.0 * PI * (f64::from(sector) + 0.5) / f64::from(SECTORS);
                points.push([radius * angle.cos(), radius * angle.sin(), depth * depth * radius]);
            }
        }
        let total: f64 = points.iter().map(|[_, _, load]| load).sum();
        for [_, _, load] in &mut points {
            *load /= total;
        }
        Self { points }
    }

    /// Fx/(μN), Fy/(μN), Mz/(μN √(ab)) for a direction of x; dimensionless.
    pub fn force(&self, shape: &Shape, axis_ratio: f64, direction: [f64; 3]) -> [f64; 3] {
        self.under_slip(axis_ratio, std::array::from_fn(|k| direction[k] / shape.scales[k]))
    }

    /// The same under the rigid slip (ξ' − φ' y, η' + φ' x); dimensionless.
    fn under_slip(&self, axis_ratio: f64, [along, across, spin]: [f64; 3]) -> [f64; 3] {
        let (length, width) = (axis_ratio.sqrt(), axis_ratio.sqrt().recip());
        let mut force = [0.0; 3];
        for [x, y, load] in &self.points {
            let [x, y] = [length * x, width * y];
            let slip = [along - spin * y, across + spin * x];
            let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
            if speed > 0.0 {
                let [pull_x, pull_y] = slip.map(|slip| -load * slip / speed);
                force[0] += pull_x;
                force[1] += pull_y;
                force[2] += x * pull_y - y * pull_x;
            }
        }
        force
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Without spin the force is μN against the slip; under spin alone the moment on a circle is μN
    /// times the mean radius weighted with Hertz's pressure, 3 ∫ ρ² √(1 − ρ²) dρ = 3π/16.
    #[test]
    fn spin_of_a_circle() {
        let circle = FullSliding::new();
        let [x, y, moment] = circle.under_slip(1.0, [3.0, -4.0, 0.0]);
        assert_relative_eq!(x, -0.6, epsilon = 2e-5);
        assert_relative_eq!(y, 0.8, epsilon = 2e-5);
        assert_relative_eq!(moment, 0.0, epsilon = 1e-9);
        let [x, y, moment] = circle.under_slip(1.0, [0.0, 0.0, 1.0]);
        assert_relative_eq!(x.hypot(y), 0.0, epsilon = 1e-9);
        assert_relative_eq!(moment, -3.0 * PI / 16.0, max_relative = 1e-4);
    }
}
