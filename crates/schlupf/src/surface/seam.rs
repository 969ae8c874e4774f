//! A piece of a surface made to continue periodically: its edges are blended into each other.
//!
//! A periodic contact of a measured piece as it is would have a step all around, which carries like a wall. Along each
//! direction the last eighth is laid over the first one, h = s h(x) + c h(x + L) with s² + c² = 1: heights that do
//! not know of each other keep their root mean square, and both ends go on where the other stops.

use std::f64::consts::FRAC_PI_2;

use super::{HeightMap, Lattice};
use crate::error::Error;

/// Part of the side that is blended, dimensionless.
const PART: f64 = 0.125;

/// Cells to blend of so many.
fn margin(cells: usize) -> usize {
    (PART * cells as f64).round() as usize
}

impl HeightMap {
    /// A periodic piece of this surface, an eighth smaller in each direction, about its mean height.
    pub fn seamless(&self) -> Result<Self, Error> {
        let flat = self.about_its_mean();
        let lattice = *flat.lattice();
        let (columns, rows) = (lattice.columns, lattice.rows);
        let mut along = Vec::with_capacity(flat.heights().len());
        for row in flat.heights().chunks_exact(columns) {
            along.extend(blended(row, margin(columns)));
        }
        let kept = seamless_lattice(&lattice);
        let columns = kept.columns;
        let mut heights = vec![0.0; kept.len()];
        for i in 0..columns {
            let column: Vec<f64> = (0..rows).map(|j| along[j * columns + i]).collect();
            for (j, height) in blended(&column, margin(rows)).into_iter().enumerate() {
                heights[j * columns + i] = height;
            }
        }
        Ok(Self::new(kept, heights)?.about_its_mean())
    }
}

/// The lattice that is left of one.
pub(crate) fn seamless_lattice(lattice: &Lattice) -> Lattice {
    let left = |cells: usize| cells - margin(cells);
    Lattice { columns: left(lattice.columns), rows: left(lattice.rows), ..*lattice }
}

/// A line whose last `margin` points are laid over the first ones.
fn blended(line: &[f64], margin: usize) -> Vec<f64> {
    let kept = line.len() - margin;
    let mut blended = line[..kept].to_vec();
    for (i, height) in blended.iter_mut().take(margin).enumerate() {
        let (s, c) = (FRAC_PI_2 * (i as f64 + 0.5) / margin as f64).sin_cos();
        *height = s * *height + c * line[kept + i];
    }
    blended
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::statistics::Statistics;
    use crate::surface::synthesis::{Roughness, SelfAffine};

    /// A piece of a larger surface keeps height and gradient, and has no step where it begins again.
    #[test]
    fn a_seam_is_as_rough_as_the_rest() {
        let spectrum = SelfAffine {
            roughness: Roughness::Height(1e-6),
            hurst_exponent: 0.8,
            longest_wavelength: 50e-6,
            roll_off_wavelength: 50e-6,
            shortest_wavelength: 8e-6,
        };
        let whole = spectrum.surface(Lattice::square(512, 1.024e-3), 4).unwrap();
        let side = Lattice { columns: 200, rows: 160, spacing_x: 2e-6, spacing_y: 2e-6 };
        let piece = HeightMap::from_fn(side, |x, y| {
            let [i, j] = [x, y].map(|at| (at / 2e-6).round() as i64 + 256);
            whole.heights()[(j * 512 + i) as usize]
        })
        .unwrap();
        let periodic = piece.seamless().unwrap();
        let lattice = *periodic.lattice();
        assert_eq!([lattice.columns, lattice.rows], [175, 140]);
        let [before, after] = [&piece, &periodic].map(|map| Statistics::of(map).unwrap());
        let ratio = after.root_mean_square_height / before.root_mean_square_height;
        assert!((0.9..1.1).contains(&ratio), "{ratio}");
        let rows = periodic.heights().chunks_exact(lattice.columns);
        let steps = rows.map(|row| row[0] - row[lattice.columns - 1]);
        let step = (steps.map(|step| step * step).sum::<f64>() / lattice.rows as f64).sqrt();
        let expected = before.root_mean_square_gradient * lattice.spacing_x;
        assert!(step < 1.5 * expected, "{step:e} {expected:e}");
    }
}
