//! The stresses at all points of a layer at once.

use rustfft::num_complex::Complex;

use super::kernel::corner;
use super::load::divided;
use super::{Stress, SubsurfaceStress};
use crate::normal::Grid;
use crate::numerics::fourier::{RealTransform, smooth_from};
use crate::numerics::love;

/// The stresses at a depth.
#[derive(Debug, Clone)]
pub struct Layer {
    /// Depth below the surface, in m.
    pub depth: f64,
    /// Stress below the middle of every cell of the grid of the layer, row by row.
    pub stress: Vec<Stress>,
}

/// Convolution of the loads with the responses to a piece: the spectra of the loads are kept from
/// layer to layer.
pub(super) struct LayerTransform {
    grid: Grid,
    /// Pieces of a cell each way.
    pieces: usize,
    /// Transforms the responses, and the stresses back.
    transform: RealTransform,
    /// Columns and rows of the padded lattice.
    size: [usize; 2],
    /// Spectra of pressure and tractions.
    loads: [Vec<Complex<f64>>; 3],
}

/// The grid of layers around a body's contact, and columns and rows of the lattice of the pieces.
fn lattice(body: &SubsurfaceStress, margin: [usize; 2]) -> (Grid, [usize; 2]) {
    let of = &body.grid;
    let grid = Grid {
        columns: of.columns + 2 * margin[0],
        rows: of.rows + 2 * margin[1],
        origin_x: of.origin_x - margin[0] as f64 * of.spacing_x,
        origin_y: of.origin_y - margin[1] as f64 * of.spacing_y,
        ..*of
    };
    // Distances between a load and a point are shorter than this either way.
    let size = [(grid.columns, of.columns), (grid.rows, of.rows)]
        .map(|(all, n)| smooth_from(body.pieces * (all + n)));
    (grid, size)
}

impl LayerTransform {
    /// Number of points of the lattice (dimensionless), each of which takes some 200 bytes.
    pub fn points(body: &SubsurfaceStress, margin: [usize; 2]) -> f64 {
        let [columns, rows] = [body.grid.columns, body.grid.rows];
        let size = [(columns, margin[0]), (rows, margin[1])]
            .map(|(n, margin)| body.pieces as f64 * 2.0 * (n as f64 + margin as f64));
        size[0] * size[1]
    }

    pub fn new(body: &SubsurfaceStress, margin: [usize; 2]) -> Self {
        let of = &body.grid;
        let pieces = body.pieces;
        let (grid, size) = lattice(body, margin);
        let mut transform = RealTransform::new(size, size);
        let mut padded = vec![0.0; size[0] * size[1]];
        let mut spectrum = |values: &[f64]| {
            padded.fill(0.0);
            for (j, row) in values.chunks_exact(pieces * of.columns).enumerate() {
                let start = (j + pieces * margin[1]) * size[0] + pieces * margin[0];
                padded[start..start + row.len()].copy_from_slice(row);
            }
            transform.forward(&padded);
            transform.spectrum().to_vec()
        };
        let loads = body.load.fields().map(|(_, values)| spectrum(values));
        Self { grid, pieces, transform, size, loads }
    }

    /// The grid of the layers.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// The layer at a depth, in m.
    pub fn layer(&mut self, body: &SubsurfaceStress, depth: f64) -> Layer {
        let depth = depth.max(0.0);
        let middles: Vec<usize> = (0..self.grid.len()).map(|k| self.middle(k)).collect();
        Layer { depth, stress: self.stresses(body, depth, &middles) }
    }

    /// The stresses at a depth (in m) below the middles of all pieces, and the grid of these.
    pub fn of_pieces(&mut self, body: &SubsurfaceStress, depth: f64) -> (Grid, Vec<Stress>) {
        let grid = divided(&self.grid, self.pieces);
        let points = (0..grid.len()).map(|k| k / grid.columns * self.size[0] + k % grid.columns);
        (grid, self.stresses(body, depth, &points.collect::<Vec<usize>>()))
    }

    /// The stresses at a depth (in m) at points of the lattice.
    fn stresses(&mut self, body: &SubsurfaceStress, depth: f64, points: &[usize]) -> Vec<Stress> {
        let responses = self.responses(body, depth);
        let mut field = vec![0.0; self.size[0] * self.size[1]];
        let mut stresses = vec![[0.0; 6]; points.len()];
        for component in 0..6 {
            self.convolve(&responses, component, &mut field);
            for (stress, point) in stresses.iter_mut().zip(points) {
                stress[component] = field[*point];
            }
        }
        stresses.into_iter().map(|stress| body.in_contact_frame(stress)).collect()
    }

    /// The point of the lattice in the middle of a cell.
    fn middle(&self, cell: usize) -> usize {
        let [i, j] = [cell % self.grid.columns, cell / self.grid.columns];
        let [i, j] = [i, j].map(|k| k * self.pieces + self.pieces / 2);
        j * self.size[0] + i
    }

    /// A component of the stress at all points of the lattice.
    fn convolve(&mut self, responses: &[[f64; 18]], component: usize, field: &mut [f64]) {
        let mut sum = vec![Complex { re: 0.0, im: 0.0 }; self.loads[0].len()];
        for (load, spectrum) in self.loads.iter().enumerate() {
            let [columns, rows] = self.size;
            for (j, row) in field.chunks_exact_mut(columns).enumerate() {
                let start = (j + rows / 2) % rows * columns;
                for (i, value) in row.iter_mut().enumerate() {
                    *value = responses[start + (i + columns / 2) % columns][6 * load + component];
                }
            }
            self.transform.forward(field);
            let products = spectrum.iter().zip(self.transform.spectrum());
            for (total, (of_load, response)) in sum.iter_mut().zip(products) {
                *total += of_load * response;
            }
        }
        let points = field.len() as f64;
        let scaled = self.transform.spectrum_mut().iter_mut().zip(sum);
        scaled.for_each(|(value, total)| *value = total / points);
        self.transform.inverse(field);
    }

    /// Responses to the load of a piece at all points of the lattice, from the middle of its rows
    /// and columns on: it is periodic, and points beyond its half lie on the other side of the
    /// piece.
    fn responses(&self, body: &SubsurfaceStress, depth: f64) -> Vec<[f64; 18]> {
        let nu = body.poisson_ratio;
        let spacing = [body.finer.spacing_x, body.finer.spacing_y];
        // Distances from −n/2 on, so that every corner is needed once.
        let first = self.size.map(|n| -((n / 2) as f64));
        let corners = |at: [f64; 2]| {
            let way = std::array::from_fn(|c| at[c] + first[c] * spacing[c]);
            corner(way, depth, nu).as_flattened().try_into().unwrap_or([0.0; 18])
        };
        love::cells(spacing, self.size, corners)
    }
}
