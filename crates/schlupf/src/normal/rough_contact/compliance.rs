//! Displacement of two elastic half-spaces under normal pressure, u = S p.
//!
//! *Periodic*: a wave of pressure displaces the surface by a wave, u_k = 2/(E*|k|) p_k (Westergaard
//! 1939; Johnson, *Contact Mechanics*, 1985, §13.2). The mean pressure causes no displacement:
//! displacements are relative to the mean plane.
//!
//! *Free*: pressure is constant in each cell and the displacement at the centre of another one,
//! with sums over the corners X = x ± Δx/2, Y = y ± Δy/2 and signs (+, −, −, +), is
//!
//! πE* u = p (X asinh(Y/|X|) + Y asinh(X/|Y|))      (Love 1929; Johnson 1985, §3.5).
//!
//! On a surface that is curved across, it is that of `elasticity/half_space.rs`.
//!
//! It depends only on the distance between two cells: a convolution, by Fourier transform on a grid
//! padded to twice its size.

use std::f64::consts::PI;

use super::Boundary;
use crate::numerics::fourier::{RealTransform, smooth_from};
use crate::numerics::love;
use crate::surface::Lattice;

/// How a surface is curved across.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Curved {
    /// Curvature, in 1/m.
    pub curvature: f64,
    /// Combined Poisson's ratio, dimensionless.
    pub poisson_ratio: f64,
}

/// S and its approximate inverse on one lattice.
#[derive(Debug)]
pub(super) struct NormalCompliance {
    transform: RealTransform,
    /// By wave number, divided by the number of points.
    symbol: Vec<f64>,
    /// E*|k|/2 by wave number, divided by the number of points.
    stiffness: Vec<f64>,
}

impl NormalCompliance {
    pub(super) fn new(lattice: &Lattice, contact_modulus: f64, boundary: Boundary) -> Self {
        Self::curved(lattice, contact_modulus, (boundary, Curved::default()))
    }

    pub(super) fn curved(
        lattice: &Lattice,
        contact_modulus: f64,
        (boundary, curved): (Boundary, Curved),
    ) -> Self {
        let filled = [lattice.columns, lattice.rows];
        let spacing = [lattice.spacing_x, lattice.spacing_y];
        let size = match boundary {
            Boundary::Periodic => filled,
            Boundary::Free => filled.map(|count| smooth_from(2 * count - 1)),
        };
        let transform = RealTransform::new(filled, size);
        let points = (size[0] * size[1]) as f64;
        let stiffness: Vec<f64> =
            transform.wave_numbers(spacing).map(|k| 0.5 * contact_modulus * k / points).collect();
        let symbol: Vec<f64> = match boundary {
            Boundary::Periodic => {
                let inverse = |s: &f64| if *s > 0.0 { (s * points * points).recip() } else { 0.0 };
                stiffness.iter().map(inverse).collect()
            }
            Boundary::Free => {
                let mut padded = RealTransform::new(size, size);
                padded.forward(&kernel(size, spacing, (contact_modulus, curved)));
                // Even in x and in y, so its transform is real.
                padded.spectrum().iter().map(|value| value.re / points).collect()
            }
        };
        Self { transform, symbol, stiffness }
    }

    /// Displacement (in m) under a pressure (in Pa).
    pub(super) fn displacement(&mut self, pressure: &[f64], displacement: &mut [f64]) {
        self.transform.forward(pressure);
        self.transform.multiply(&self.symbol);
        self.transform.inverse(displacement);
    }

    /// The pressure (in Pa) that would cause this displacement (in m) of an unbounded surface: an
    /// approximate inverse.
    pub(super) fn stiffness(&mut self, displacement: &[f64], pressure: &mut [f64]) {
        self.transform.forward(displacement);
        self.transform.multiply(&self.stiffness);
        self.transform.inverse(pressure);
    }
}

/// Influence of the cell at the origin on all cells; distances beyond half the size are negative.
fn kernel(
    size: [usize; 2],
    spacing: [f64; 2],
    (contact_modulus, curved): (f64, Curved),
) -> Vec<f64> {
    let over = (PI * contact_modulus).recip();
    let reach = size.map(|count| count / 2 + 1);
    let quadrant = love::cells(spacing, reach, |at| {
        let [x, y] = love::corner(at);
        [x + y, x]
    });
    let influence = |i: usize, j: usize| {
        let [both, x] = quadrant[j * reach[0] + i];
        over * if curved.curvature == 0.0 {
            both
        } else {
            let (y, nu) = (both - x, curved.poisson_ratio);
            let tangential = love::tangential(nu, [x, y]).map(|part| part / (1.0 - nu));
            let [less, more] = love::halves(nu, tangential);
            more * (curved.curvature * j as f64 * spacing[1]).cos() - less
        }
    };
    let distance = |k: usize, count: usize| k.min(count - k);
    let cells = (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| [i, j]));
    cells.map(|[i, j]| influence(distance(i, size[0]), distance(j, size[1]))).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::super::{RoughContact, RoughContactOptions};
    use super::*;
    use crate::surface::HeightMap;

    const MODULUS: f64 = 115e9;

    /// Westergaard 1939: a wave of pressure p cos(k·x) displaces the surface by 2p/(E*|k|)
    /// cos(k·x).
    #[test]
    fn westergaard_1939_a_wave_of_pressure() {
        let lattice = Lattice { columns: 12, rows: 15, spacing_x: 1e-6, spacing_y: 2e-6 };
        let mut compliance = NormalCompliance::new(&lattice, MODULUS, Boundary::Periodic);
        let k = [2.0 * TAU / lattice.length_x(), 3.0 * TAU / lattice.length_y()];
        let wave: Vec<f64> = lattice.points().map(|[x, y]| (k[0] * x + k[1] * y).cos()).collect();
        let pressure: Vec<f64> = wave.iter().map(|w| 1e9 + 2e8 * w).collect();
        let mut moved = vec![0.0; lattice.len()];
        compliance.displacement(&pressure, &mut moved);
        let amplitude = 2.0 * 2e8 / (MODULUS * k[0].hypot(k[1]));
        for (u, w) in moved.iter().zip(&wave) {
            assert_relative_eq!(*u, amplitude * w, epsilon = 1e-12 * amplitude);
        }
        let mut back = vec![0.0; lattice.len()];
        compliance.stiffness(&moved, &mut back);
        for (p, w) in back.iter().zip(&wave) {
            assert_relative_eq!(*p, 2e8 * w, epsilon = 1e-3);
        }
    }

    /// Vollebregt 2018, Vehicle System Dynamics 56, 1622: flange root of 10.2 mm on a gauge corner
    /// of 10 mm at 45°, approach 90.89 µm, with influence functions by finite elements: 99.32 kN
    /// and 1034 MPa; half-spaces that are not bent have 91.84 kN and 1012 MPa. Here the distance is
    /// that of circles, which differs by up to 0.4 µm.
    #[test]
    fn vollebregt_2018_flange_root() {
        let lattice = Lattice { columns: 51, rows: 39, spacing_x: 4e-4, spacing_y: 4e-4 };
        let middle = [0.5 * (51.0 - 1.0) * 4e-4, 0.5 * (39.0 - 1.0) * 4e-4];
        let first = lattice.points().next().unwrap();
        let distance = lattice.points().map(|[x, y]| {
            let (x, s) = (x - first[0] - middle[0], y - first[1] - middle[1]);
            let along = x * x * std::f64::consts::FRAC_1_SQRT_2 / (2.0 * 0.46);
            0.2e-3 - 0.290_89e-3 * (s / 10e-3).cos() + along
        });
        let distance = HeightMap::new(lattice, distance.collect());
        let contact = RoughContact::new(distance.unwrap(), 82e9 / 0.72, Boundary::Free).unwrap();
        let curved = Curved { curvature: 100.0, poisson_ratio: 0.28 };
        let expected = [
            (Curved::default(), 91.84e3, 1012e6, [5e-3; 2]),
            (curved, 99.32e3, 1034e6, [0.025, 0.04]),
        ];
        let mut contact = Some(contact);
        for (curved, load, pressure, tolerance) in expected {
            let mut bent = contact.take().unwrap().curved(curved);
            let options = RoughContactOptions { tolerance: 1e-8, max_iterations: 500 };
            let found = bent.solve_at_level(0.0, &options, &crate::unwatched).unwrap();
            let largest = found.pressure.iter().copied().fold(0.0, f64::max);
            assert_relative_eq!(found.load, load, max_relative = tolerance[0]);
            assert_relative_eq!(largest, pressure, max_relative = tolerance[1]);
            contact = Some(bent);
        }
    }

    /// Boussinesq 1885: at large distances a loaded cell acts as a point force, u = F/(πE* r); and
    /// Love 1929: under uniform pressure the centre of a square of half-side a sinks by 8 a
    /// asinh(1) p/(πE*).
    #[test]
    fn boussinesq_1885_love_1929_a_loaded_cell() {
        let lattice = Lattice { columns: 41, rows: 31, spacing_x: 1e-6, spacing_y: 2e-6 };
        let mut compliance = NormalCompliance::new(&lattice, MODULUS, Boundary::Free);
        let (mut pressure, mut moved) = (vec![0.0; lattice.len()], vec![0.0; lattice.len()]);
        pressure[0] = 1e9;
        compliance.displacement(&pressure, &mut moved);
        let [x, y] = [40.0 * lattice.spacing_x, 30.0 * lattice.spacing_y];
        let expected = 1e9 * lattice.cell_area() / (PI * MODULUS * x.hypot(y));
        assert_relative_eq!(moved[lattice.len() - 1], expected, max_relative = 1e-3);
        let square = Lattice { rows: 2, columns: 2, spacing_x: 2e-6, spacing_y: 2e-6 };
        let mut moved = [0.0; 4];
        NormalCompliance::new(&square, MODULUS, Boundary::Free)
            .displacement(&[1e9, 0.0, 0.0, 0.0], &mut moved);
        let expected = 1e9 * 8e-6 * 1.0_f64.asinh() / (PI * MODULUS);
        assert_relative_eq!(moved[0], expected, max_relative = 1e-12);
    }
}
