//! Coupling of normal and tangential contact between unlike bodies.

use std::f64::consts::PI;

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use crate::normal::{Grid, VectorField};
use crate::numerics::fourier::smooth_from;
use crate::numerics::love;

/// What is solved of the coupling of normal and tangential contact between unlike bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum UnlikeBodies {
    /// Pressure displaces the surfaces tangentially, and tractions change the pressure
    /// (Panagiotopoulos 1975).
    #[default]
    Coupled,
    /// Pressure displaces the surfaces tangentially, but tractions do not change it (the process of
    /// Johnson; Kalker 1990, §4.1).
    OneWay,
    /// Neither.
    Neglected,
}

/// Tangential displacement under pressure and normal displacement under tangential traction.
///
/// On a half-space a normal force draws the surface towards it, and a tangential force raises it
/// ahead and lowers it behind (Boussinesq 1885, Cerruti 1882; Johnson, *Contact Mechanics*, 1985,
/// §3.2 and §3.6). Of two bodies only the difference of both is felt: with K = ¼ G ((1 − 2ν₁)/G₁ −
/// (1 − 2ν₂)/G₂) (Kalker 1990, §1.7), the pressure p and the traction t on the wheel, at r = (x −
/// x', y − y'),
///
/// u = −K/(πG) ∫ p r/|r|² dA,  h = K/(πG) ∫ t · r/|r|² dA.
///
/// On a surface with a curvature κ across rolling ([`HalfSpace`](super::HalfSpace)) there is also
/// what the tangential displacement of one place and the pressure at another have in common as
/// these are inclined to each other: K **r**/(πG r²) → K **r**/(πG r²) + (A_xy sin ½κΔy, A₊ sin
/// κΔy).
///
/// u is the tangential displacement, wheel minus rail, and h how far the tractions move the
/// surfaces apart. Both are constant in a cell, for which ∫∫ x/r² = Y ln r + X atan(Y/X) in sums
/// over its corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureCoupling {
    /// K, dimensionless.
    pub constant: f64,
    /// κ, in 1/m.
    pub curvature: f64,
    /// Combined shear modulus G, in Pa.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio ν, dimensionless.
    pub poisson_ratio: f64,
    /// Whether tractions change the pressure.
    pub is_mutual: bool,
}

impl PressureCoupling {
    /// The contact modulus of the same bodies, E* = G/(1 − ν), in Pa.
    pub fn contact_modulus(&self) -> f64 {
        self.shear_modulus / (1.0 - self.poisson_ratio)
    }

    /// Tangential displacement, rail minus wheel (in m), of the cells of a grid under their
    /// pressure (in Pa).
    pub fn displacement(&self, grid: &Grid, pressure: &[f64]) -> VectorField {
        let field: Vec<_> = pressure.iter().map(|p| Complex::new(*p, 0.0)).collect();
        let moved = self.convolved(grid, &field);
        VectorField {
            x: moved.iter().map(|u| u.re).collect(),
            y: moved.iter().map(|u| u.im).collect(),
        }
    }

    /// How far the traction on the wheel (in Pa) moves the surfaces apart in each cell of a grid,
    /// in m.
    pub fn opening(&self, grid: &Grid, traction: &VectorField) -> Vec<f64> {
        let pairs = traction.x.iter().zip(&traction.y);
        let conjugate: Vec<_> = pairs.map(|(x, y)| Complex::new(*x, -y)).collect();
        self.convolved(grid, &conjugate).iter().map(|h| h.re).collect()
    }

    /// The convolution of a complex field with what couples, in m per unit of the field.
    fn convolved(&self, grid: &Grid, field: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let size = [smooth_from(2 * grid.columns - 1), smooth_from(2 * grid.rows - 1)];
        let [nx, ny] = size;
        let over = ((nx * ny) as f64).recip();
        let mut padded = vec![Complex::default(); nx * ny];
        let rows = field.chunks_exact(grid.columns);
        for (line, row) in padded.chunks_exact_mut(nx).zip(rows) {
            line[..grid.columns].copy_from_slice(row);
        }
        let mut kernel = self.kernel(grid, size);
        transform(&mut padded, size, false);
        transform(&mut kernel, size, false);
        for (value, wave) in padded.iter_mut().zip(&kernel) {
            *value *= over * wave;
        }
        transform(&mut padded, size, true);
        let lines = padded.chunks_exact(nx).take(grid.rows);
        lines.flat_map(|line| &line[..grid.columns]).copied().collect()
    }

    /// x + i y of what couples the cell at the origin with all cells; those beyond half the size
    /// are behind it.
    fn kernel(&self, grid: &Grid, [nx, ny]: [usize; 2]) -> Vec<Complex<f64>> {
        let reach = [nx / 2 + 1, ny / 2 + 1];
        let over = (PI * self.shear_modulus).recip();
        let mut quadrant = love::cells([grid.spacing_x, grid.spacing_y], reach, |[x, y]| {
            let logarithm = 0.5 * (x * x + y * y).ln();
            let both = [y * logarithm + x * (y / x).atan(), x * logarithm + y * (x / y).atan()];
            both.map(|part| self.constant * over * part)
        });
        if self.curvature != 0.0 {
            let nu = self.poisson_ratio;
            let plane = love::cells([grid.spacing_x, grid.spacing_y], reach, |[x, y]| {
                let [xx, yy] = love::tangential(nu, love::corner([x, y]));
                [xx, yy, -nu * x.hypot(y)].map(|part| over * part)
            });
            for (k, (both, [xx, yy, xy])) in quadrant.iter_mut().zip(plane).enumerate() {
                let turn = self.curvature * (k / reach[0]) as f64 * grid.spacing_y;
                let [_, more] = love::halves(nu, [xx, yy]);
                both[0] += xy * (0.5 * turn).sin();
                both[1] += more * turn.sin();
            }
        }
        let away =
            |k: usize, count: usize| if 2 * k <= count { (k, 1.0) } else { (count - k, -1.0) };
        let cells = (0..ny).flat_map(|j| (0..nx).map(move |i| (away(i, nx), away(j, ny))));
        cells
            .map(|((i, ahead), (j, left))| {
                let [x, y] = quadrant[j * reach[0] + i];
                Complex::new(ahead * x, left * y)
            })
            .collect()
    }
}

/// Fourier transform in both directions, in place, without a factor.
fn transform(field: &mut [Complex<f64>], [nx, ny]: [usize; 2], is_inverse: bool) {
    let mut planner = FftPlanner::new();
    let mut plan = |count: usize| {
        if is_inverse { planner.plan_fft_inverse(count) } else { planner.plan_fft_forward(count) }
    };
    plan(nx).process(field);
    let across = plan(ny);
    let mut column = vec![Complex::default(); ny];
    for i in 0..nx {
        for (j, value) in column.iter_mut().enumerate() {
            *value = field[j * nx + i];
        }
        across.process(&mut column);
        for (j, value) in column.iter().enumerate() {
            field[j * nx + i] = *value;
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::{BORDER, Extent};

    fn grid() -> Grid {
        Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-4e-3, 5e-3] }, 7, 9)
    }

    fn coupling() -> PressureCoupling {
        let (constant, shear_modulus, poisson_ratio) = (0.1, 36e9, 0.3);
        PressureCoupling { constant, curvature: 0.0, shear_modulus, poisson_ratio, is_mutual: true }
    }

    /// Boussinesq 1885: far away a loaded cell acts as a point force, u = −K/(πG) P r/r².
    #[test]
    fn boussinesq_1885_a_force_draws_the_surface() {
        let grid = Grid { columns: 40, rows: 30, ..grid() };
        let (coupling, mut pressure) = (coupling(), vec![0.0; grid.len()]);
        pressure[grid.index(3, 2)] = 1e9;
        let u = coupling.displacement(&grid, &pressure);
        let [x, y] = [33.0 * grid.spacing_x, 25.0 * grid.spacing_y];
        let point = 0.1 / (PI * 36e9) * 1e9 * grid.cell_area() / (x * x + y * y);
        let there = grid.index(36, 27);
        assert_relative_eq!(u.x[there], point * x, max_relative = 1e-3);
        assert_relative_eq!(u.y[there], point * y, max_relative = 1e-3);
        assert_relative_eq!(u.x[grid.index(0, 2)], -u.x[grid.index(6, 2)], max_relative = 1e-9);
        assert!(u.x[grid.index(3, 2)].abs() < 1e-9 * u.x[there].abs());
    }

    /// Betti 1872: the work of one state on the displacements of the other is the same both ways;
    /// displacement rail minus wheel is paired with the traction on the rail. On a curved surface,
    /// too.
    #[test]
    fn betti_1872_both_couplings_are_one() {
        let (grid, coupling) = (grid(), PressureCoupling { curvature: 80.0, ..coupling() });
        let value = |k: usize| 1e8 * ((k * k % 23) as f64 - 9.0);
        let pressure: Vec<f64> = (0..grid.len()).map(|k| value(k).abs()).collect();
        let traction = VectorField {
            x: (0..grid.len()).map(|k| value(2 * k + 1)).collect(),
            y: (0..grid.len()).map(|k| value(3 * k + 1)).collect(),
        };
        let (u, h) = (coupling.displacement(&grid, &pressure), coupling.opening(&grid, &traction));
        let normal: f64 = h.iter().zip(&pressure).map(|(h, p)| h * p).sum();
        let along: f64 = u.x.iter().zip(&traction.x).map(|(u, t)| -u * t).sum();
        let across: f64 = u.y.iter().zip(&traction.y).map(|(u, t)| -u * t).sum();
        assert_relative_eq!(normal, along + across, max_relative = 1e-9);
    }

    /// Johnson 1985, §2.4: under plane strain the pressure strains the surface in proportion, here
    /// ∂u/∂x = −2 K p/G, whatever its distribution.
    #[test]
    fn johnson_1985_strain_under_a_line_of_pressure() {
        let grid = Grid { rows: 1, spacing_y: 1e3, ..grid() };
        let pressure: Vec<f64> = (0..grid.len()).map(|k| 1e7 * (k % 5) as f64).collect();
        let u = coupling().displacement(&grid, &pressure);
        for i in BORDER..grid.columns - BORDER {
            let mean = 0.5 * (pressure[i] + pressure[i - 1]);
            let strain = -(u.x[i] - u.x[i - 1]) / grid.spacing_x;
            assert_relative_eq!(strain, -2.0 * 0.1 * mean / 36e9, max_relative = 1e-4);
        }
    }
}
