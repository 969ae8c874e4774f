//! Surface temperature of a half-space that moves under stationary heat sources: steady conduction
//! in all three directions (Jaeger 1942; Carslaw and Jaeger 1959, §10.7).

use std::f64::consts::PI;

use crate::normal::Grid;
use crate::numerics::quadrature;
use crate::numerics::vector::add_scaled;

/// A half-space that moves in the −x direction under a grid of cells, each of which releases heat
/// uniformly.
///
/// Heat that a rectangular cell of flux q released a time t ago has been carried a distance v t
/// downstream and has spread in x and y as F = ½ erf((X + ½Δ)/√(4κt)) − ½ erf((X − ½Δ)/√(4κt)), and
/// into the depth, so
///
/// T = (2q/(β√π)) ∫ F_x(x + v τ²) F_y(y) dτ,    τ = √t from 0 to ∞,
///
/// where F = 1 gives conduction perpendicular to the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MovingHalfSpace {
    /// Speed v, in m/s.
    pub speed: f64,
    /// Diffusivity κ, in m²/s.
    pub diffusivity: f64,
    /// Effusivity β, in W √s/(m² K).
    pub effusivity: f64,
}

/// Steps of √t grow by this fraction, as long as
const STEP_RATIO: f64 = 0.5;

/// they do not exceed this times √κ/v: within that, the released heat moves as far as it spreads.
const STEP: f64 = 1.0;

/// Value of s at which exp(−s²) is rounding error.
const NEGLIGIBLE: f64 = 6.0;

/// Farthest spreading considered, relative to the length of the grid: under a body at rest the
/// remainder decreases as its inverse.
const FARTHEST: f64 = 1e8;

impl MovingHalfSpace {
    /// Temperature rise per unit flux of a cell (in K m²/W) at the centres of cells: i columns
    /// upstream of it and j rows beside it at `[(i + columns − 1) · rows + j]`, starting from i =
    /// −(columns − 1).
    pub fn influence(&self, grid: &Grid) -> Vec<f64> {
        let (columns, rows) = (grid.columns, grid.rows);
        let size = [grid.spacing_x, grid.spacing_y];
        let mut influence = vec![0.0; (2 * columns - 1) * rows];
        let mut along = vec![0.0; 2 * columns - 1];
        let mut across = vec![0.0; rows];
        let reach = (columns as f64 * size[0]).hypot(rows as f64 * size[1]);
        for [root, weight] in self.nodes(size[0].min(size[1]), reach) {
            let spread = 2.0 * self.diffusivity.sqrt() * root;
            let carried = self.speed * root * root;
            let upstream = carried - (columns - 1) as f64 * size[0];
            shares([upstream, size[0]], spread, &mut along);
            shares([0.0, size[1]], spread, &mut across);
            let factor = 2.0 * weight / (self.effusivity * PI.sqrt());
            for (values, share) in influence.chunks_exact_mut(rows).zip(&along) {
                if *share != 0.0 {
                    add_scaled(values, factor * share, &across);
                }
            }
        }
        influence
    }

    /// Nodes and weights for the integral over √t (in √s), for cells of `smallest` size on a grid
    /// of extent `reach` (in m).
    fn nodes(&self, smallest: f64, reach: f64) -> Vec<[f64; 2]> {
        let root = self.diffusivity.sqrt();
        let longest = STEP * root / self.speed;
        let last = FARTHEST * reach / root;
        let mut nodes = Vec::new();
        // Before that nothing has spread beyond its cell.
        let mut panel = [0.0, (smallest / (4.0 * NEGLIGIBLE * root)).min(longest)];
        loop {
            let [from, to] = panel;
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            for (node, weight) in quadrature::EIGHT {
                nodes.push([middle - half * node, half * weight]);
                nodes.push([middle + half * node, half * weight]);
            }
            let is_carried_off = self.speed * to * to > reach + 2.0 * NEGLIGIBLE * root * to;
            if is_carried_off || to > last {
                return nodes;
            }
            panel = [to, to + (STEP_RATIO * to).min(longest)];
        }
    }
}

/// Fractions of the heat released by a cell that are now over cells of the same size, the first at
/// a given distance and each further one `size` away, relative to the fraction without spreading
/// (all in m).
fn shares([first, size]: [f64; 2], spread: f64, shares: &mut [f64]) {
    let edge = |k: usize| (first + (k as f64 - 0.5) * size) / spread;
    let mut lower = edge(0);
    for (k, share) in shares.iter_mut().enumerate() {
        let upper = edge(k + 1);
        *share = half_difference(lower, upper);
        lower = upper;
    }
}

/// ½ (erf(upper) − erf(lower)), without cancellation far from zero.
fn half_difference(lower: f64, upper: f64) -> f64 {
    if lower > NEGLIGIBLE || upper < -NEGLIGIBLE {
        return 0.0;
    }
    if lower > 0.5 {
        return 0.5 * (libm::erfc(lower) - libm::erfc(upper));
    }
    if upper < -0.5 {
        return 0.5 * (libm::erfc(-upper) - libm::erfc(-lower));
    }
    0.5 * (libm::erf(upper) - libm::erf(lower))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn grid(columns: usize, rows: usize) -> Grid {
        let (spacing_x, spacing_y) = (2.0, 2.0);
        Grid { columns, rows, spacing_x, spacing_y, origin_x: 0.0, origin_y: 0.0 }
    }

    /// λ = 1, κ = ½, so that v a/κ of a cell of half-length 1 is 2v.
    fn body(speed: f64) -> MovingHalfSpace {
        MovingHalfSpace { speed, diffusivity: 0.5, effusivity: 2.0_f64.sqrt() }
    }

    /// Carslaw and Jaeger 1959, §10.5: at the centre of a square source of half-length l on a body
    /// at rest the rise is (1/(2πλ)) ∫∫ q dA/R = (4 q l/(πλ)) asinh 1.
    #[test]
    fn carslaw_jaeger_1959_square_source_at_rest() {
        let influence = body(0.0).influence(&grid(3, 3));
        assert_relative_eq!(influence[2 * 3], 4.0 / PI * 1.0_f64.asinh(), max_relative = 1e-7);
    }

    /// Jaeger 1942: a moving square source, compared with (1/2πλ) ∫∫ exp(−v(R + X)/2κ)/R dA by
    /// adaptive cubature (SciPy's dblquad, to 1e-9), one cell downstream, beside that, and upstream
    /// and beside.
    #[test]
    fn jaeger_1942_moving_square_source() {
        for (speed, expected) in [
            (0.25, [0.323_168_747_685_676, 0.187_703_343_750_828, 0.074_378_376_379_863]),
            (2.5, [0.269_876_057_980_032, 0.044_290_716_656_226, 2.416_345_922_294_8e-5]),
        ] {
            let influence = body(speed).influence(&grid(3, 3));
            let at = |i: usize, j: usize| influence[i * 3 + j];
            for (found, expected) in [at(1, 0), at(1, 1), at(3, 1)].into_iter().zip(expected) {
                assert_relative_eq!(found, expected, max_relative = 1e-7);
            }
        }
    }

    /// The limit of high speed: the cell's own half contributes (2q/(β√π)) √(Δx/2v), the cell k
    /// upstream the difference of two such roots, and adjacent rows nothing.
    #[test]
    fn a_fast_body_conducts_perpendicular_to_its_surface() {
        let (body, grid) = (body(1e6), grid(5, 3));
        let influence = body.influence(&grid);
        let root = |cells: f64| (cells * 2.0 / 1e6_f64).sqrt();
        let unit = 2.0 / (2.0 * PI).sqrt();
        assert_relative_eq!(influence[4 * 3], unit * root(0.5), max_relative = 1e-3);
        for k in 1..5 {
            let expected = unit * (root(k as f64 + 0.5) - root(k as f64 - 0.5));
            assert_relative_eq!(influence[(4 - k) * 3], expected, max_relative = 1e-3);
            assert!(influence[(4 - k) * 3 + 1] < 1e-3 * expected);
            assert!(influence[(4 + k) * 3] < 1e-6 * expected);
        }
    }
}
