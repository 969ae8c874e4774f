//! Steady conduction in wheel and rail where heat also flows along the surface: slow rolling, and a
//! wheel that spins near standstill.
//!
//! Each body is a half-space that moves at its own speed under the patch, and the two surfaces
//! touch: with the partition from the velocities, q_w + q_r = q and T_w + G_w q_w = T_r + G_r q_r
//! hold in every cell. The heat into the wheel is split into a fixed share ε of q and an exchange e
//! with
//!
//! (G_w + G_r) e = T_r − T_w + G_r (1 − ε) q − G_w ε q.
//!
//! With a prescribed partition, e is due to the bulk temperatures alone.

use std::fmt;

use rustfft::num_complex::Complex;

use crate::bodies::Material;
use crate::normal::patch::{Interpolation, Patch};
use crate::normal::{Grid, VectorField};
use crate::numerics::fourier::{RealTransform, smooth_from};
use crate::numerics::vector::{add_scaled, dot, norm};

use super::moving_half_space::MovingHalfSpace;
use super::partition::Conduction;

/// Conducting bodies and their length scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Conductors {
    /// Partition, bulk temperatures and speeds.
    pub conduction: Conduction,
    /// Materials of wheel and rail.
    pub materials: [Material; 2],
    /// Speed of the rail v0, in m/s.
    pub speed: f64,
    /// Ratio of all lengths to those of the patch, dimensionless.
    pub scale: f64,
}

/// Temperatures of both surfaces, and the heat received by the bodies.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surfaces {
    /// Surface temperatures of wheel and rail in every cell, in degC.
    pub cells: Vec<[f64; 2]>,
    /// At the trailing edge of every strip, in degC.
    pub exits: Vec<[f64; 2]>,
    /// Frictional heat into wheel and rail, in W.
    pub into: [f64; 2],
    /// Heat from the wheel into the rail due to their bulk temperatures, in W.
    pub exchanged: f64,
    /// Whether the exchange between the bodies was found.
    pub is_found: bool,
}

/// Conduction in two bodies that touch in a patch.
pub(crate) struct ContactConduction {
    pub conductors: Conductors,
    /// Shares of wheel and rail without the exchange, dimensionless.
    shares: [f64; 2],
    /// Symbols of wheel and rail and of both together, divided by the number of points of the
    /// lattice.
    symbols: [Vec<Complex<f64>>; 3],
    /// The inverse of the last one.
    inverse: Vec<Complex<f64>>,
    /// Contact temperature per unit flux of a cell, by columns downstream, in K m²/W.
    downstream: Vec<f64>,
    transform: RealTransform,
    interpolation: Interpolation,
    /// Position of each cell on the grid.
    index: Vec<usize>,
    /// Cells in which the surfaces are made equally hot: those at least half covered by the patch.
    /// This makes their area right on average, which matters for the heat that flows in at the
    /// edge.
    joined: Vec<usize>,
    /// Exchange due to the bulk temperatures: flux into wheel and rail of each cell, in W/m².
    bulk_flux: Vec<f64>,
    /// Contact temperature without friction in each cell, in degC.
    pub unheated: Vec<f64>,
    /// Whether it was found, and whether everything requested since was found.
    is_found: [bool; 2],
    grid: Grid,
    source: VectorField,
    field: VectorField,
}

/// Index of the kernel of both bodies in [`ContactConduction::symbols`].
const TOGETHER: usize = 2;

/// Largest difference of the surface temperatures relative to that without exchange, dimensionless.
const ACCURACY: f64 = 1e-10;

/// The relative difference below which the exchange is rounding error.
const ROUNDING: f64 = 1e-13;

/// Maximum number of iterations; some twelve are enough on any grid.
const ITERATIONS: usize = 100;

impl ContactConduction {
    /// Conduction under a patch.
    pub fn new(patch: &Patch, conductors: Conductors) -> Self {
        let Conductors { conduction, materials, speed, scale } = conductors;
        let mut scaled = patch.grid;
        scaled.spacing_x *= scale;
        scaled.spacing_y *= scale;
        let speeds = conduction.contact_times().map(|time| speed / time);
        let influences = [0, 1].map(|body| {
            let (diffusivity, effusivity) =
                (materials[body].diffusivity(), materials[body].effusivity());
            MovingHalfSpace { speed: speeds[body], diffusivity, effusivity }.influence(&scaled)
        });
        let filled = [scaled.columns, scaled.rows];
        let size = filled.map(|cells| smooth_from(2 * cells - 1));
        let [wheel, rail] = [0, 1].map(|body| symbol(&influences[body], filled, size));
        let together: Vec<_> = wheel.iter().zip(&rail).map(|(wheel, rail)| wheel + rail).collect();
        let points = (size[0] * size[1]) as f64;
        let inverse = together.iter().map(|symbol| (symbol * points * points).inv()).collect();
        let cells = patch.len();
        let half = |k: &usize| patch.cells[*k].covered >= 0.5;
        let mut found = Self {
            conductors,
            shares: conduction.shares(),
            symbols: [wheel, rail, together],
            inverse,
            downstream: Vec::new(),
            transform: RealTransform::new(filled, size),
            interpolation: Interpolation::new(patch),
            index: patch.cells.iter().map(|cell| cell.index).collect(),
            joined: (0..cells).filter(half).collect(),
            bulk_flux: vec![0.0; 2 * cells],
            unheated: vec![0.0; cells],
            is_found: [true; 2],
            grid: scaled,
            source: VectorField::zeros(scaled.len()),
            field: VectorField::zeros(scaled.len()),
        };
        found.divide(patch);
        found.downstream = found.contact_influence(&influences);
        found.exchange_bulk_heat();
        found
    }

    /// Chooses shares that leave little to the exchange: those with equal mean temperatures under a
    /// flux proportional to the pressure.
    fn divide(&mut self, patch: &Patch) {
        if !self.conductors.conduction.has_equal_surfaces() {
            return;
        }
        let flux: Vec<f64> = patch.cells.iter().flat_map(|cell| [cell.pressure; 2]).collect();
        let rises = self.rises(&flux);
        let mean = |body: usize| -> f64 { rises.iter().skip(body).step_by(2).sum() };
        let [wheel, rail] = [mean(0), mean(1)];
        self.shares = [rail / (wheel + rail), wheel / (wheel + rail)];
    }

    fn contact_influence(&self, influences: &[Vec<f64>; 2]) -> Vec<f64> {
        let (columns, rows) = (self.grid.columns, self.grid.rows);
        let at = |downstream: usize, body: usize| {
            let influence = influences[body][(columns - 1 - downstream) * rows];
            self.weights()[body] * self.shares[body] * influence
        };
        (0..columns).map(|downstream| at(downstream, 0) + at(downstream, 1)).collect()
    }

    /// Weights of the surfaces of wheel and rail in the contact temperature, dimensionless.
    fn weights(&self) -> [f64; 2] {
        let wheel = self.conductors.conduction.wheel_weight();
        [wheel, 1.0 - wheel]
    }

    /// Contact temperature (in K m²/W) per unit flux of a cell of the same row so many columns
    /// upstream, without the change of the exchange.
    pub fn downstream(&self, columns: usize) -> f64 {
        self.downstream[columns]
    }

    /// Surface temperature rises of wheel and rail in each cell (in K) under the given fluxes into
    /// them (in W/m²). Those of the whole grid are left in the field.
    fn rises(&mut self, flux: &[f64]) -> Vec<f64> {
        self.interpolation.spread(flux, &mut self.source);
        conduct(&mut self.transform, &self.symbols[0], &self.source.x, &mut self.field.x);
        conduct(&mut self.transform, &self.symbols[1], &self.source.y, &mut self.field.y);
        let mut rises = vec![0.0; flux.len()];
        self.interpolation.gather_means(&self.field, &mut rises);
        rises
    }

    /// (G_w + G_r) e in the joined cells, in K.
    fn parting(&mut self, exchange: &[f64]) -> Vec<f64> {
        let mut flux = vec![0.0; 2 * self.index.len()];
        for (k, value) in self.joined.iter().zip(exchange) {
            flux[2 * k] = *value;
        }
        self.interpolation.spread(&flux, &mut self.source);
        let symbol = &self.symbols[TOGETHER];
        conduct(&mut self.transform, symbol, &self.source.x, &mut self.field.x);
        self.interpolation.gather_means(&self.field, &mut flux);
        self.joined.iter().map(|k| flux[2 * k]).collect()
    }

    /// Estimates the exchange that makes the surfaces differ by the given amount in the joined
    /// cells: that of bodies which touch everywhere.
    fn estimate(&mut self, parting: &[f64]) -> Vec<f64> {
        self.source.x.fill(0.0);
        for (k, value) in self.joined.iter().zip(parting) {
            self.source.x[self.index[*k]] = *value;
        }
        conduct(&mut self.transform, &self.inverse, &self.source.x, &mut self.field.x);
        self.joined.iter().map(|k| self.field.x[self.index[*k]]).collect()
    }

    /// Solves (G_w + G_r) e = `difference` in the joined cells, by generalised conjugate residuals
    /// (Eisenstat, Elman and Schultz 1983).
    fn exchange(&mut self, difference: &[f64]) -> Vec<f64> {
        let mut residual = difference.to_vec();
        let mut exchange = vec![0.0; residual.len()];
        let start = norm(&residual);
        let mut past: Vec<[Vec<f64>; 2]> = Vec::new();
        while past.len() < ITERATIONS && norm(&residual) > ACCURACY * start {
            let mut direction = self.estimate(&residual);
            let mut product = self.parting(&direction);
            for [earlier, its_product] in &past {
                let along = dot(&product, its_product);
                add_scaled(&mut direction, -along, earlier);
                add_scaled(&mut product, -along, its_product);
            }
            let length = norm(&product);
            if length == 0.0 {
                break;
            }
            for value in direction.iter_mut().chain(&mut product) {
                *value /= length;
            }
            let step = dot(&residual, &product);
            add_scaled(&mut exchange, step, &direction);
            add_scaled(&mut residual, -step, &product);
            past.push([direction, product]);
        }
        // False if a number is NaN.
        self.is_found[1] &= norm(&residual) <= ACCURACY * start;
        exchange
    }

    /// Adds an exchange to the fluxes into wheel and rail.
    fn add_exchange(&self, exchange: &[f64], flux: &mut [f64]) {
        for (k, value) in self.joined.iter().zip(exchange) {
            flux[2 * k] += value;
            flux[2 * k + 1] -= value;
        }
    }

    fn exchange_bulk_heat(&mut self) {
        let [wheel, rail] = self.conductors.conduction.bulk_temperatures();
        let mut flux = vec![0.0; self.bulk_flux.len()];
        if wheel != rail {
            let exchange = self.exchange(&vec![rail - wheel; self.joined.len()]);
            self.add_exchange(&exchange, &mut flux);
        }
        let rises = self.rises(&flux);
        let of = |k: usize| self.mean([wheel + rises[2 * k], rail + rises[2 * k + 1]]);
        self.unheated = (0..self.index.len()).map(of).collect();
        self.bulk_flux = flux;
        self.is_found[0] = self.is_found[1];
    }

    /// The contact temperature of two surfaces.
    fn mean(&self, surfaces: [f64; 2]) -> f64 {
        let [wheel, rail] = self.weights();
        wheel * surfaces[0] + rail * surfaces[1]
    }

    /// Fluxes into wheel and rail for a friction power per unit area, mean over each cell (in
    /// W/m²).
    fn divided(&mut self, power: &[f64]) -> Vec<f64> {
        let shares = self.shares;
        let mut flux: Vec<f64> = power.iter().flat_map(|q| shares.map(|share| share * q)).collect();
        if self.conductors.conduction.has_equal_surfaces() {
            let rises = self.rises(&flux);
            let difference: Vec<f64> =
                self.joined.iter().map(|k| rises[2 * k + 1] - rises[2 * k]).collect();
            if norm(&difference) > ROUNDING * norm(&rises) {
                let exchange = self.exchange(&difference);
                self.add_exchange(&exchange, &mut flux);
            }
        }
        flux
    }

    /// Rise of the contact temperature (in K) due to a friction power per unit area, mean over each
    /// cell (in W/m²).
    pub fn contact_rise(&mut self, power: &[f64], rise: &mut [f64]) {
        let flux = self.divided(power);
        let rises = self.rises(&flux);
        for (rise, surfaces) in rise.iter_mut().zip(rises.chunks_exact(2)) {
            *rise = self.mean([surfaces[0], surfaces[1]]);
        }
    }

    /// Both surfaces under a friction power per unit area, mean over each cell (in W/m²).
    pub fn surfaces(&mut self, patch: &Patch, power: &[f64]) -> Surfaces {
        self.is_found[1] = self.is_found[0];
        let flux = self.divided(power);
        let bulk = self.conductors.conduction.bulk_temperatures();
        let bulk_flux = std::mem::take(&mut self.bulk_flux);
        let exchanged = self.at_cells_and_exits(patch, &bulk_flux);
        self.bulk_flux = bulk_flux;
        let heated = self.at_cells_and_exits(patch, &flux);
        let is_common = self.conductors.conduction.has_equal_surfaces();
        let both = |(exchanged, heated): ([f64; 2], [f64; 2])| {
            // Where the surfaces touch they are equally hot, also in cells that are not joined.
            let entry = self.mean([bulk[0] + exchanged[0], bulk[1] + exchanged[1]]);
            let rise = if is_common { [self.mean(heated); 2] } else { heated };
            rise.map(|rise| entry + rise)
        };
        let [cells, exits] = [0, 1].map(|place| {
            let pairs = exchanged[place].iter().copied().zip(heated[place].iter().copied());
            pairs.map(both).collect()
        });
        let area = patch.grid.cell_area();
        let whole = |flux: &[f64], body| area * flux.iter().skip(body).step_by(2).sum::<f64>();
        let into = [0, 1].map(|body| whole(&flux, body));
        let exchanged = whole(&self.bulk_flux, 1);
        Surfaces { cells, exits, into, exchanged, is_found: self.is_found[1] }
    }

    /// Rises of wheel and rail (in K) in the cells and at the trailing edges, linear between
    /// columns.
    fn at_cells_and_exits(&mut self, patch: &Patch, flux: &[f64]) -> [Vec<[f64; 2]>; 2] {
        let rises = self.rises(flux);
        let cells = rises.chunks_exact(2).map(|rise| [rise[0], rise[1]]).collect();
        let grid = &patch.grid;
        let at_exit = |strip: &crate::normal::patch::Strip| {
            let position = (patch.exit(strip) - grid.x(0)) / grid.spacing_x;
            let column = position.floor().clamp(0.0, (grid.columns - 2) as f64);
            let (first, part) = (grid.index(column as usize, strip.row), position - column);
            let between = |values: &[f64]| (1.0 - part) * values[first] + part * values[first + 1];
            [between(&self.field.x), between(&self.field.y)]
        };
        [cells, patch.strips.iter().map(at_exit).collect()]
    }
}

impl fmt::Debug for ContactConduction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ContactConduction").field("grid", &self.grid).finish_non_exhaustive()
    }
}

/// The transform of an influence on a lattice of `size` points, divided by their number.
fn symbol(influence: &[f64], [columns, rows]: [usize; 2], size: [usize; 2]) -> Vec<Complex<f64>> {
    let points = (size[0] * size[1]) as f64;
    let mut periodic = vec![0.0; size[0] * size[1]];
    for (k, values) in influence.chunks_exact(rows).enumerate() {
        let i = (k + size[0] + 1 - columns) % size[0];
        for (j, value) in values.iter().enumerate() {
            periodic[j * size[0] + i] = value / points;
            periodic[(size[1] - j) % size[1] * size[0] + i] = value / points;
        }
    }
    let mut transform = RealTransform::new(size, size);
    transform.forward(&periodic);
    transform.spectrum().to_vec()
}

/// The field of a source whose transform is multiplied by a symbol.
fn conduct(
    transform: &mut RealTransform,
    symbol: &[Complex<f64>],
    source: &[f64],
    field: &mut [f64],
) {
    transform.forward(source);
    for (value, factor) in transform.spectrum_mut().iter_mut().zip(symbol) {
        *value *= factor;
    }
    transform.inverse(field);
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::*;
    use crate::bodies::{Body, Kinematics};
    use crate::interface::heat::Partition;
    use crate::normal::{Ellipse, PressureSource};

    const RADIUS: f64 = 5e-3;

    /// Rises of the rail in every cell relative to q a/λ, with a uniform flux q over a circle going
    /// entirely into the rail, and the patch; at a Péclet number v a/κ.
    fn under_uniform_circle(peclet: f64, cells: usize) -> (Vec<f64>, Patch) {
        let source = Ellipse::from_peak_pressure(RADIUS, RADIUS, 1e9).unwrap();
        let contact = source.normal_contact(None).unwrap();
        let patch = Patch::new(&contact, Grid::across(&contact.extent(), cells, cells));
        let speed = peclet * Material::STEEL.diffusivity() / RADIUS;
        let kinematics = Kinematics::free_rolling(speed);
        let given = Partition::Given(0.0);
        let conductors = Conductors {
            conduction: Conduction::new(&given, &Body::STEEL, &Body::STEEL, &kinematics),
            materials: [Material::STEEL; 2],
            speed,
            scale: 1.0,
        };
        let flux: Vec<f64> = patch.cells.iter().map(|cell| cell.covered).collect();
        let mut conduction = ContactConduction::new(&patch, conductors);
        let surfaces = conduction.surfaces(&patch, &flux);
        assert!(surfaces.is_found);
        let unit = RADIUS / Material::STEEL.conductivity;
        let rise = |surfaces: &[f64; 2]| (surfaces[1] - Body::STEEL.bulk_temperature) / unit;
        (surfaces.cells.iter().map(rise).collect(), patch)
    }

    /// Carslaw and Jaeger 1959, §10.5: under a uniform flux over a circle at rest the rise is q a/λ
    /// at the centre and 8 q a/(3πλ) on average; the mean converges with the cells.
    #[test]
    fn carslaw_jaeger_1959_uniform_circle_at_rest() {
        for (cells, allowed) in [(11, 1e-2), (21, 4e-3), (41, 1.5e-3)] {
            let (rises, patch) = under_uniform_circle(1e-9, cells);
            let largest = rises.iter().copied().fold(0.0, f64::max);
            let covered = patch.cells.iter().map(|cell| cell.covered);
            let area: f64 = covered.clone().sum();
            let mean = covered.zip(&rises).map(|(part, rise)| part * rise).sum::<f64>() / area;
            println!("{cells} cells: {largest} and {mean}");
            assert_relative_eq!(largest, 1.0, max_relative = 2.5e-3);
            assert_relative_eq!(mean, 8.0 / (3.0 * PI), max_relative = allowed);
        }
    }

    /// Tian and Kennedy 1994: a moving uniform circle, at most 2 q a/(λ √(π (1.273 + v a/2κ))), an
    /// interpolation between the limits that is accurate to 2.5 %.
    #[test]
    fn tian_kennedy_1994_moving_uniform_circle() {
        for peclet in [0.2, 1.0, 4.0, 10.0, 40.0, 100.0, 400.0] {
            let (rises, _) = under_uniform_circle(peclet, 41);
            let largest = rises.iter().copied().fold(0.0, f64::max);
            let expected = 2.0 / (PI * (1.273 + 0.5 * peclet)).sqrt();
            println!("{peclet}: {largest}, {expected}");
            assert_relative_eq!(largest, expected, max_relative = 0.025);
        }
    }
}
