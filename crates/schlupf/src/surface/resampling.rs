//! The same surface on a finer or coarser lattice.

use super::{HeightMap, Lattice};
use crate::numerics::interpolation::catmull_rom;
use crate::reporting::Error;

impl HeightMap {
    /// The surface in `columns` × `rows` cells on the same area. Along a side that becomes coarser,
    /// cells take the mean of the cells they cover, which removes the waves that they could not
    /// represent; along one that becomes finer, heights are interpolated by cubics (Catmull and Rom
    /// 1974).
    pub fn resampled(&self, columns: usize, rows: usize) -> Result<Self, Error> {
        let old = self.lattice();
        let lattice = Lattice {
            columns,
            rows,
            spacing_x: old.length_x() / columns as f64,
            spacing_y: old.length_y() / rows as f64,
        };
        lattice.check()?;
        let along = Weights::between(old.columns, columns);
        let lines = self.heights().chunks_exact(old.columns);
        let wide: Vec<f64> = lines.flat_map(|line| along.apply(|i| line[i])).collect();
        let across = Weights::between(old.rows, rows);
        let mut heights = vec![0.0; lattice.len()];
        for i in 0..columns {
            for (j, height) in across.apply(|j| wide[j * columns + i]).enumerate() {
                heights[j * columns + i] = height;
            }
        }
        Self::new(lattice, heights)
    }

    /// The surface in square cells with the shorter side of the present ones, on the same area to
    /// within half a cell.
    pub fn with_square_cells(&self) -> Result<Self, Error> {
        let old = *self.lattice();
        if old.has_square_cells() {
            return Ok(self.clone());
        }
        let spacing = old.spacing_x.min(old.spacing_y);
        let columns = (old.length_x() / spacing).round() as usize;
        let rows = (old.length_y() / spacing).round() as usize;
        let resampled = self.resampled(columns, rows)?;
        let lattice = Lattice { columns, rows, spacing_x: spacing, spacing_y: spacing };
        Self::new(lattice, resampled.heights)
    }
}

/// Rounding of spacings in text files, dimensionless.
const ROUNDING: f64 = 1e-4;

impl Lattice {
    /// Whether the cells are square, to the rounding of a text file.
    pub fn has_square_cells(&self) -> bool {
        (self.spacing_x / self.spacing_y - 1.0).abs() <= ROUNDING
    }
}

/// Weights of the old cells in each new cell of a side.
struct Weights(Vec<Vec<(usize, f64)>>);

impl Weights {
    fn between(old: usize, new: usize) -> Self {
        let ratio = old as f64 / new as f64;
        let weights = (0..new).map(|cell| {
            if ratio > 1.0 { covered(cell, ratio, old) } else { cubic(cell, ratio, old) }
        });
        Self(weights.collect())
    }

    fn apply(&self, height: impl Fn(usize) -> f64) -> impl Iterator<Item = f64> {
        self.0.iter().map(move |weights| weights.iter().map(|(cell, w)| w * height(*cell)).sum())
    }
}

/// Weights for the mean over a new cell, `ratio` old cells long. Within an old cell the surface has
/// the slope given by its neighbours.
fn covered(cell: usize, ratio: f64, old: usize) -> Vec<(usize, f64)> {
    let (start, end) = (cell as f64 * ratio, (cell + 1) as f64 * ratio);
    let mut weights = Vec::with_capacity(ratio as usize + 6);
    for part in start.floor() as usize..(end.ceil() as usize).min(old) {
        let [from, to] = [start.max(part as f64), end.min(part as f64 + 1.0)];
        let share = (to - from) / ratio;
        weights.push((part, share));
        let offset = 0.5 * (from + to) - (part as f64 + 0.5);
        let [left, right] = [part.saturating_sub(1), (part + 1).min(old - 1)];
        let slope = share * offset / (right - left).max(1) as f64;
        weights.extend([(right, slope), (left, -slope)]);
    }
    weights
}

/// Weights of the four nearest old cells for the centre of a new one; beyond the edge the surface
/// is extrapolated linearly.
fn cubic(cell: usize, ratio: f64, old: usize) -> Vec<(usize, f64)> {
    let position = (cell as f64 + 0.5) * ratio - 0.5;
    let first = position.floor();
    let mut weights = Vec::with_capacity(8);
    for (offset, weight) in catmull_rom(position - first).into_iter().enumerate() {
        let index = first as i64 + offset as i64 - 1;
        let last = old as i64 - 1;
        // h(−n) = (1 + n) h(0) − n h(1), and likewise beyond the last one.
        let beyond = (-index).max(index - last).max(0) as f64;
        let edge = index.clamp(0, last);
        let inner = if index < 0 { 1 } else { last - 1 };
        weights.push((edge as usize, weight * (1.0 + beyond)));
        if beyond > 0.0 {
            weights.push((inner as usize, -weight * beyond));
        }
    }
    weights
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn tilted(columns: usize, rows: usize) -> HeightMap {
        let lattice = Lattice {
            columns,
            rows,
            spacing_x: 12.0 / columns as f64,
            spacing_y: 6.0 / rows as f64,
        };
        HeightMap::from_fn(lattice, |x, y| 2.0 + 3.0 * x - y).unwrap()
    }

    /// A plane is unchanged on any lattice, including its edges.
    #[test]
    fn a_plane_stays_a_plane() {
        for (columns, rows) in [(12, 6), (24, 13), (5, 4), (7, 17), (2, 2)] {
            let resampled = tilted(12, 6).resampled(columns, rows).unwrap();
            for (value, expected) in resampled.heights().iter().zip(tilted(columns, rows).heights())
            {
                assert_relative_eq!(*value, *expected, epsilon = 1e-12);
            }
        }
    }

    /// Coarser cells preserve the mean; a smooth wave is interpolated to third order.
    #[test]
    fn the_mean_stays_and_a_wave_is_kept() {
        let lattice = Lattice { columns: 48, rows: 3, spacing_x: 1.0, spacing_y: 1.0 };
        let wave = |x: f64| (std::f64::consts::TAU * x / 24.0).cos();
        let surface = HeightMap::from_fn(lattice, |x, _| wave(x)).unwrap();
        let coarse = surface.resampled(11, 2).unwrap();
        assert_relative_eq!(coarse.mean(), surface.mean(), epsilon = 1e-14);
        let fine = surface.resampled(96, 3).unwrap();
        for i in 4..92 {
            let x = fine.lattice().x(i);
            assert_relative_eq!(fine.heights()[i], wave(x), epsilon = 2e-3);
        }
    }

    #[test]
    fn cells_become_square() {
        let lattice = Lattice { columns: 10, rows: 8, spacing_x: 2.0, spacing_y: 1.0 };
        let surface = HeightMap::from_fn(lattice, |x, y| x + y).unwrap();
        let square = surface.with_square_cells().unwrap();
        let Lattice { columns, rows, spacing_x, spacing_y } = *square.lattice();
        assert_eq!((columns, rows, spacing_x, spacing_y), (20, 8, 1.0, 1.0));
        assert_relative_eq!(square.heights()[0], -9.5 - 3.5, epsilon = 1e-12);
    }
}
