//! The elastic half-space.

use std::f64::consts::PI;
use std::fmt;
use std::sync::Arc;

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

use super::ellipsoidal_traction::EllipsoidalTraction;
use super::{Compliance, Elasticity, PressureCoupling, UnlikeBodies};
use crate::bodies::{Material, shear_modulus_and_poisson_ratio};
use crate::normal::{Grid, VectorField};
use crate::numerics::fourier::{smooth_from, wrapped};
use crate::numerics::love;
use crate::reporting::{Error, Quantity, Warning, require_positive};

/// Two half-spaces in contact.
///
/// The elastic half-space of Boussinesq and Cerruti: exact for bodies that are large compared with
/// the patch.
///
/// Traction is constant in each cell. The displacement difference at the centre of another cell is,
/// in closed form (Kalker 1990, §3.2; Love 1929), with sums over the corners X = x ± Δx/2, Y = y ±
/// Δy/2, signs (+, −, −, +) and r = √(X² + Y²),
///
/// πG A_xx = (1 − ν) X asinh(Y/|X|) + Y asinh(X/|Y|),  πG A_xy = −ν r,
/// πG A_yy = X asinh(Y/|X|) + (1 − ν) Y asinh(X/|Y|).
///
/// It depends only on the distance between the two cells, so the product is a convolution and costs
/// O(n log n) with the fast Fourier transform on a grid padded to twice its size.
///
/// On a surface with a curvature κ across rolling, cells Δy apart are inclined to each other by
/// κ Δy. The half-space of both is then that whose plane is half-way between them: the traction of
/// one is turned into it by half that angle, and the displacement out of it by the other half. With
/// the influence A_nn of pressure on the approach, A_± = ½ (A_yy ± A_nn),
///
/// A_yy → A₋ + A₊ cos κΔy,  A_nn → A₊ cos κΔy − A₋,  A_xy → A_xy cos ½κΔy,
///
/// and pressure displaces tangentially ([`PressureCoupling`]). In plane strain this is a disc in a
/// hole, apart from what is uniform in them; elsewhere it is the estimate of J. Blanco-Lorenzo et
/// al., Tribology International 103 (2016), in the symmetric form of E. A. H. Vollebregt, User
/// guide for CONTACT, §4.2. κ = 0 is the plane.
///
/// The mean over the cell is removed from its influence to second order (`Influences`), which makes
/// forces some four times as accurate and keeps A positive definite. Both components share one
/// complex field; columns k and −k of its transform are transformed across, multiplied and
/// transformed back a few at a time, within the cache.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpace {
    shear_modulus: f64,
    poisson_ratio: f64,
    dissimilarity: f64,
    unlike_bodies: UnlikeBodies,
    /// In 1/m.
    curvature: f64,
}

/// Dissimilarity below which bodies are alike.
const NOTICEABLE: f64 = 1e-3;

impl HalfSpace {
    /// Combined constants of two bodies: 1/G = ½ (1/G₁ + 1/G₂), ν/G = ½ (ν₁/G₁ + ν₂/G₂).
    ///
    /// Unlike bodies also move tangentially under the pressure, and apart under tractions: see
    /// [`PressureCoupling`].
    ///
    /// ```
    /// use schlupf::bodies::Material;
    /// use schlupf::elasticity::HalfSpace;
    ///
    /// let steel = HalfSpace::new(&Material::STEEL, &Material::STEEL)?;
    /// assert!((steel.shear_modulus() / Material::STEEL.shear_modulus() - 1.0).abs() < 1e-12);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(first: &Material, second: &Material) -> Result<Self, Error> {
        let [shear_modulus, poisson_ratio] = shear_modulus_and_poisson_ratio(first, second);
        require_positive(Quantity::WheelYoungModulus, shear_modulus)?;
        let dilation = |m: &Material| (1.0 - 2.0 * m.poisson_ratio) / m.shear_modulus();
        let dissimilarity = 0.25 * shear_modulus * (dilation(first) - dilation(second));
        let unlike_bodies = UnlikeBodies::default();
        Ok(Self { shear_modulus, poisson_ratio, dissimilarity, unlike_bodies, curvature: 0.0 })
    }

    /// The same with less, or all, of what couples pressure and tractions of unlike bodies.
    #[must_use]
    pub fn with_unlike_bodies(self, unlike_bodies: UnlikeBodies) -> Self {
        Self { unlike_bodies, ..self }
    }

    /// K, if the bodies are unlike.
    pub(super) fn unlike(&self) -> Option<f64> {
        (self.dissimilarity.abs() > NOTICEABLE).then_some(self.dissimilarity)
    }

    /// Combined shear modulus G, in Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Combined Poisson's ratio ν, dimensionless.
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// A_xx, A_yy and A_xy (in m/Pa) of two cells `columns` and `rows` apart.
    pub fn influence(&self, grid: &Grid, columns: isize, rows: isize) -> [f64; 3] {
        let size = [grid.spacing_x, grid.spacing_y];
        self.influence_of(size, [columns as f64 * size[0], rows as f64 * size[1]])
    }

    /// A_xx, A_yy and A_xy (in m/Pa) of a cell of the given size (in m) at the point at the
    /// distance `[x, y]` (in m) from its centre.
    pub fn influence_of(&self, size: [f64; 2], [x, y]: [f64; 2]) -> [f64; 3] {
        let corner =
            |side_x: f64, side_y: f64| self.corner([x + side_x * size[0], y + side_y * size[1]]);
        let [below, above] =
            [-0.5, 0.5].map(|side_y| [-0.5, 0.5].map(|side_x| corner(side_x, side_y)));
        love::rectangle([below, above])
    }

    /// The influences of plane bodies on those `across` (in m) of each other on a curved surface.
    fn turned(&self, [xx, yy, xy]: [f64; 3], across: f64) -> [f64; 3] {
        let [less, more] = love::halves(self.poisson_ratio, [xx, yy]);
        let turn = self.curvature * across;
        [xx, less + more * turn.cos(), xy * (0.5 * turn).cos()]
    }

    /// Integrals of A_xx, A_yy and A_xy from the origin to a corner (x, y), in m³/N.
    fn corner(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let nu = self.poisson_ratio;
        let over = (PI * self.shear_modulus).recip();
        let [xx, yy] = love::tangential(nu, love::corner([x, y]));
        [over * xx, over * yy, -over * nu * (x * x + y * y).sqrt()]
    }
}

/// The influences on a grid, with the averaging over the cell removed to second order: the constant
/// traction of a cell represents a smooth one, whose displacement differs by −h²∇²u/12 from that of
/// its means. A single row has the same traction over its whole width, as in plane strain.
///
/// Each corner of the cells is evaluated once, and influences at distances of either sign follow
/// from the first quadrant, because A_xx and A_yy are even in x and in y, and A_xy is odd in both.
struct Influences {
    quadrant: Vec<[f64; 3]>,
    columns: usize,
}

impl Influences {
    /// Extends half way around the padded grid.
    fn new(bodies: &HalfSpace, grid: &Grid) -> Self {
        let reach = |cells: usize| smooth_from(2 * cells - 1) / 2 + 1;
        let (columns, rows) = (reach(grid.columns), reach(grid.rows));
        let plain = Self::plain(bodies, grid, [columns + 1, rows + 1]);
        let mut quadrant = Vec::with_capacity(columns * rows);
        for j in 0..rows as isize {
            for i in 0..columns as isize {
                quadrant.push(without_mean(|i, j| plain.at(i, j), grid, [i, j]));
            }
        }
        Self { quadrant, columns }
    }

    /// The uncorrected influences.
    fn plain(bodies: &HalfSpace, grid: &Grid, [columns, rows]: [usize; 2]) -> Self {
        let spacing = [grid.spacing_x, grid.spacing_y];
        let mut quadrant = love::cells(spacing, [columns, rows], |at| bodies.corner(at));
        if bodies.curvature != 0.0 {
            for (j, row) in quadrant.chunks_exact_mut(columns).enumerate() {
                let across = j as f64 * grid.spacing_y;
                for influence in row {
                    *influence = bodies.turned(*influence, across);
                }
            }
        }
        Self { quadrant, columns }
    }

    fn at(&self, columns: isize, rows: isize) -> [f64; 3] {
        let sign = if (columns < 0) == (rows < 0) { 1.0 } else { -1.0 };
        let [xx, yy, xy] =
            self.quadrant[rows.unsigned_abs() * self.columns + columns.unsigned_abs()];
        [xx, yy, sign * xy]
    }
}

/// The influence at a distance in columns and rows with the averaging over the cell removed to
/// second order, from that `at` distances.
pub(super) fn without_mean(
    at: impl Fn(isize, isize) -> [f64; 3],
    grid: &Grid,
    [i, j]: [isize; 2],
) -> [f64; 3] {
    let here = at(i, j);
    let beside = |j: isize| if grid.rows > 1 { at(i, j) } else { here };
    let neighbours = [at(i + 1, j), at(i - 1, j), beside(j + 1), beside(j - 1)];
    std::array::from_fn(|c| {
        let around: f64 = neighbours.iter().map(|neighbour| neighbour[c]).sum();
        here[c] + (4.0 * here[c] - around) / 12.0
    })
}

impl Elasticity for HalfSpace {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        let influences = Influences::new(self, grid);
        let convolution = Convolution::new(grid, |i, j| influences.at(i, j));
        Ok(Box::new(HalfSpaceCompliance { convolution, is_plane: self.curvature == 0.0 }))
    }

    fn is_scale_free(&self) -> bool {
        self.curvature == 0.0
    }

    fn under_ellipsoid(&self, semi_axes: [f64; 2]) -> Option<EllipsoidalTraction> {
        let ellipsoid =
            || EllipsoidalTraction::new(self.shear_modulus, self.poisson_ratio, semi_axes);
        (self.curvature == 0.0).then(ellipsoid)
    }

    fn curved(&self, curvature: f64) -> Option<Arc<dyn Elasticity>> {
        Some(Arc::new(Self { curvature, ..*self }))
    }

    fn caveat(&self) -> Option<Warning> {
        let constant = self.unlike().filter(|_| self.unlike_bodies == UnlikeBodies::Neglected)?;
        Some(Warning::DissimilarBodies { constant })
    }

    fn pressure_coupling(&self) -> Option<PressureCoupling> {
        let constant = self.unlike().filter(|_| self.unlike_bodies != UnlikeBodies::Neglected);
        let Self { shear_modulus, poisson_ratio, curvature, .. } = *self;
        let constant = constant.or((curvature != 0.0).then_some(0.0))?;
        let is_mutual = curvature != 0.0 || self.unlike_bodies == UnlikeBodies::Coupled;
        Some(PressureCoupling { constant, curvature, shear_modulus, poisson_ratio, is_mutual })
    }
}

/// The half-space on one grid. Displacements of plane bodies scale linearly with its size.
#[derive(Debug)]
struct HalfSpaceCompliance {
    convolution: Convolution,
    is_plane: bool,
}

impl Compliance for HalfSpaceCompliance {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        self.convolution.displacement(traction, displacement);
    }

    fn displacement_by_size(
        &mut self,
        traction: &VectorField,
        displacement: &mut VectorField,
    ) -> bool {
        if self.is_plane {
            self.convolution.displacement(traction, displacement);
        }
        self.is_plane
    }

    fn couples_cells(&self) -> bool {
        true
    }
}

/// Convolution with the influence of a cell, on a padded grid.
///
/// Both components share one complex field t_x + i t_y. For wave number k its transform F gives
/// that of u_x + i u_y as ½ (A_xx + A_yy) F(k) + (½ (A_xx − A_yy) + i A_xy) F*(−k). Columns i and
/// −i are therefore transformed across, multiplied and transformed back together, a few at a time,
/// so that they do not leave the cache.
pub struct Convolution {
    columns: usize,
    rows: usize,
    /// Padded sizes.
    size: [usize; 2],
    along: [Arc<dyn Fft<f64>>; 2],
    across: [Arc<dyn Fft<f64>>; 2],
    /// Of the wave numbers from zero to half way around in both directions, columns one after
    /// another.
    waves: Vec<Wave>,
    lines: Vec<Complex<f64>>,
    /// Columns that are worked on, and their mirror images.
    pairs: [Vec<Complex<f64>>; 2],
    scratch: Vec<Complex<f64>>,
}

/// The influence at one wave number, divided by the number of cells; in m/Pa.
#[derive(Debug, Clone, Copy)]
struct Wave {
    /// ½ (A_xx + A_yy).
    mean: f64,
    /// ½ (A_xx − A_yy) + i A_xy. The imaginary part is odd in both wave numbers.
    difference: Complex<f64>,
}

impl Wave {
    /// u_x + i u_y at k and at −k from t_x + i t_y there.
    #[inline]
    fn displaced(&self, [here, there]: [Complex<f64>; 2]) -> [Complex<f64>; 2] {
        let Self { mean, difference } = *self;
        [here * mean + difference * there.conj(), there * mean + difference * here.conj()]
    }

    /// That at the wave number with the opposite sign in one direction.
    #[inline]
    fn mirrored(&self) -> Self {
        Self { difference: self.difference.conj(), ..*self }
    }
}

const ZERO: Complex<f64> = Complex { re: 0.0, im: 0.0 };

/// Number of columns that are worked on at once: those of a cache line.
const COLUMNS_AT_ONCE: usize = 4;

impl Convolution {
    /// The convolution with the influence [A_xx, A_yy, A_xy] (in m/Pa) at a distance in columns and
    /// rows.
    pub fn new(grid: &Grid, influence: impl Fn(isize, isize) -> [f64; 3]) -> Self {
        Self::of(grid, &influence)
    }

    /// The same; what is generic is compiled again in every crate that uses it.
    fn of(grid: &Grid, influence: &dyn Fn(isize, isize) -> [f64; 3]) -> Self {
        let size = [smooth_from(2 * grid.columns - 1), smooth_from(2 * grid.rows - 1)];
        let mut planner = FftPlanner::new();
        let along = [planner.plan_fft_forward(size[0]), planner.plan_fft_inverse(size[0])];
        let across = [planner.plan_fft_forward(size[1]), planner.plan_fft_inverse(size[1])];
        let scratch = along.iter().chain(&across).map(|fft| fft.get_inplace_scratch_len()).max();
        let mut convolution = Self {
            columns: grid.columns,
            rows: grid.rows,
            size,
            along,
            across,
            waves: Vec::new(),
            lines: vec![ZERO; size[0] * grid.rows],
            pairs: [0, 1].map(|_| vec![ZERO; COLUMNS_AT_ONCE * size[1]]),
            scratch: vec![ZERO; scratch.unwrap_or(0)],
        };
        convolution.set_influence(influence);
        convolution
    }

    /// Columns and rows of the padded grid: the lengths of the transforms.
    pub fn padded_size(&self) -> [usize; 2] {
        self.size
    }

    /// Transforms the influence. A_xx and A_yy are even in x and in y, A_xy is odd in both, so all
    /// three transforms are real, two fit into one complex field, and a quarter of them is enough.
    fn set_influence(&mut self, influence: &dyn Fn(isize, isize) -> [f64; 3]) {
        let [nx, ny] = self.size;
        let mut axial = vec![ZERO; nx * ny];
        let mut cross = vec![ZERO; nx * ny];
        for j in 0..ny {
            for i in 0..nx {
                let [xx, yy, xy] = influence(wrapped(i, nx), wrapped(j, ny));
                axial[j * nx + i] = Complex::new(0.5 * (xx + yy), 0.5 * (xx - yy));
                // Half way around, an odd function meets itself with the opposite sign.
                let is_half_way = 2 * i == nx || 2 * j == ny;
                cross[j * nx + i] = Complex::new(if is_half_way { 0.0 } else { xy }, 0.0);
            }
        }
        let normalised = 1.0 / (nx * ny) as f64;
        let [axial, cross] = [axial, cross].map(|field| self.quarter_of_transform(field));
        let pairs = axial.iter().zip(&cross);
        self.waves = pairs
            .map(|(a, c)| Wave {
                mean: normalised * a.re,
                difference: Complex::new(a.im, c.re) * normalised,
            })
            .collect();
    }

    /// Transform of a whole field at the wave numbers up to half way around, in transposed order:
    /// columns one after another.
    fn quarter_of_transform(&mut self, mut field: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
        let [nx, ny] = self.size;
        self.along[0].process_with_scratch(&mut field, &mut self.scratch);
        let mut quarter = Vec::with_capacity((nx / 2 + 1) * (ny / 2 + 1));
        let mut column = vec![ZERO; ny];
        for i in 0..=nx / 2 {
            for (value, line) in column.iter_mut().zip(field.chunks_exact(nx)) {
                *value = line[i];
            }
            self.across[0].process_with_scratch(&mut column, &mut self.scratch);
            quarter.extend_from_slice(&column[..=ny / 2]);
        }
        quarter
    }

    /// Replaces the transforms of the lines by those of the displacement, all columns from `first`
    /// on that are worked on at once, and their mirror images.
    fn convolve_across(&mut self, first: usize) {
        let [nx, ny] = self.size;
        let last = (first + COLUMNS_AT_ONCE).min(nx / 2 + 1);
        let count = last - first;
        // Column i is at place i − first, column nx − i at the same place of the mirror images.
        let opposite: [usize; COLUMNS_AT_ONCE] =
            std::array::from_fn(|place| (nx - first - place) % nx);
        let Self { lines, pairs: [columns, mirrored], across, scratch, .. } = self;
        for (j, line) in lines.chunks_exact(nx).enumerate() {
            for (place, (there, here)) in opposite.iter().zip(&line[first..last]).enumerate() {
                columns[place * ny + j] = *here;
                mirrored[place * ny + j] = line[*there];
            }
        }
        let (columns, mirrored) = (&mut columns[..count * ny], &mut mirrored[..count * ny]);
        for column in columns.chunks_exact_mut(ny).chain(mirrored.chunks_exact_mut(ny)) {
            column[self.rows..].fill(ZERO);
        }
        across[0].process_with_scratch(columns, scratch);
        across[0].process_with_scratch(mirrored, scratch);
        let waves = self.waves[first * (ny / 2 + 1)..].chunks_exact(ny / 2 + 1);
        let both = columns.chunks_exact_mut(ny).zip(mirrored.chunks_exact_mut(ny));
        for (waves, (column, mirrored)) in waves.zip(both) {
            multiply(waves, column, mirrored);
        }
        across[1].process_with_scratch(columns, scratch);
        across[1].process_with_scratch(mirrored, scratch);
        for (j, line) in lines.chunks_exact_mut(nx).enumerate() {
            for (place, there) in opposite[..count].iter().enumerate() {
                // Columns that are their own mirror images are there twice, both the same.
                line[first + place] = columns[place * ny + j];
                line[*there] = mirrored[place * ny + j];
            }
        }
    }
}

/// Multiplies a column and its mirror image by the influence in wave-number space.
fn multiply(waves: &[Wave], column: &mut [Complex<f64>], mirrored: &mut [Complex<f64>]) {
    let (half, rest) = (column.len() / 2, column.len().div_ceil(2));
    [column[0], mirrored[0]] = waves[0].displaced([column[0], mirrored[0]]);
    let pairs = column[1..].iter_mut().zip(mirrored[1..].iter_mut().rev());
    let there = waves[1..=half].iter().copied();
    let back = waves[1..rest].iter().rev().map(Wave::mirrored);
    for (wave, (here, there)) in there.chain(back).zip(pairs) {
        [*here, *there] = wave.displaced([*here, *there]);
    }
}

impl Compliance for Convolution {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        let (nx, columns) = (self.size[0], self.columns);
        let rows = traction.x.chunks_exact(columns).zip(traction.y.chunks_exact(columns));
        for (line, (x, y)) in self.lines.chunks_exact_mut(nx).zip(rows) {
            for ((value, x), y) in line.iter_mut().zip(x).zip(y) {
                *value = Complex::new(*x, *y);
            }
            line[columns..].fill(ZERO);
        }
        self.along[0].process_with_scratch(&mut self.lines, &mut self.scratch);
        for first in (0..=nx / 2).step_by(COLUMNS_AT_ONCE) {
            self.convolve_across(first);
        }
        self.along[1].process_with_scratch(&mut self.lines, &mut self.scratch);
        let rows = displacement.x.chunks_exact_mut(columns);
        let rows = rows.zip(displacement.y.chunks_exact_mut(columns));
        for (line, (x, y)) in self.lines.chunks_exact(nx).zip(rows) {
            for ((value, x), y) in line.iter().zip(x).zip(y) {
                (*x, *y) = (value.re, value.im);
            }
        }
    }

    fn couples_cells(&self) -> bool {
        true
    }
}

impl fmt::Debug for Convolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Convolution").field("size", &self.size).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::Extent;

    fn grid() -> Grid {
        Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-4e-3, 4e-3] }, 7, 10)
    }

    fn steel() -> HalfSpace {
        HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap()
    }

    /// The mirrored influences equal those computed directly.
    #[test]
    fn influences_are_even_and_odd() {
        let (grid, bodies) = (grid(), steel());
        let influences = Influences::plain(&bodies, &grid, [8, 8]);
        for (i, j) in [(-3, 2), (3, -2), (-1, -4), (0, -5), (-6, 0)] {
            let (mirrored, direct) = (influences.at(i, j), bodies.influence(&grid, i, j));
            for c in 0..3 {
                assert_relative_eq!(mirrored[c], direct[c], max_relative = 1e-12, epsilon = 1e-24);
            }
        }
    }

    /// The convolution equals the direct sum over all pairs of cells.
    #[test]
    fn fourier_transform_sums_the_influences() {
        let (grid, bodies) = (grid(), steel());
        let mut compliance = bodies.compliance(&grid).unwrap();
        let influences = Influences::new(&bodies, &grid);
        let value = |k: usize| 1e8 * ((k * k % 23) as f64 - 9.0);
        let traction = VectorField {
            x: (0..grid.len()).map(value).collect(),
            y: (0..grid.len()).map(|k| value(3 * k + 1)).collect(),
        };
        let mut u = VectorField::zeros(grid.len());
        compliance.displacement(&traction, &mut u);
        for (i, j) in [(0, 0), (4, 3), (10, 9)] {
            let mut sum = [0.0; 2];
            for row in 0..grid.rows {
                for column in 0..grid.columns {
                    let apart = [i as isize - column as isize, j as isize - row as isize];
                    let [xx, yy, xy] = influences.at(apart[0], apart[1]);
                    let k = grid.index(column, row);
                    sum[0] += xx * traction.x[k] + xy * traction.y[k];
                    sum[1] += xy * traction.x[k] + yy * traction.y[k];
                }
            }
            let k = grid.index(i, j);
            assert_relative_eq!(u.x[k], sum[0], max_relative = 1e-9);
            assert_relative_eq!(u.y[k], sum[1], max_relative = 1e-9);
        }
    }

    /// Cerruti 1882: at large distances a cell acts as a point force, u_x = F/(πG) ((1 − ν)/r + ν
    /// x²/r³), u_y = F/(πG) ν x y/r³ for two equal bodies together.
    #[test]
    fn cerruti_1882_point_force_far_away() {
        let (grid, bodies) = (grid(), steel());
        let force = grid.cell_area();
        let (x, y) = (40.0 * grid.spacing_x, 70.0 * grid.spacing_y);
        let r = x.hypot(y);
        let scale = force / (PI * bodies.shear_modulus());
        let [xx, yy, xy] = bodies.influence(&grid, 40, 70);
        assert_relative_eq!(xx, scale * (0.72 / r + 0.28 * x * x / r.powi(3)), max_relative = 1e-3);
        assert_relative_eq!(yy, scale * (0.72 / r + 0.28 * y * y / r.powi(3)), max_relative = 1e-3);
        assert_relative_eq!(xy, scale * 0.28 * x * y / r.powi(3), max_relative = 1e-3);
    }

    /// Love 1929: uniform traction on a square displaces its centre by the integral ∫∫ dA/r = 8 a
    /// asinh(1) with the half-side a (ν = 0).
    #[test]
    fn love_1929_uniform_traction_on_a_square() {
        let rubber = Material { poisson_ratio: 0.0, ..Material::STEEL };
        let bodies = HalfSpace::new(&rubber, &rubber).unwrap();
        let square = Grid::across(&Extent { x: [-1e-3, 1e-3], y: [-1e-3, 1e-3] }, 1, 1);
        let [xx, _, xy] = bodies.influence(&square, 0, 0);
        let exact = 8e-3 * 1.0_f64.asinh() / (PI * bodies.shear_modulus());
        assert_relative_eq!(xx, exact, max_relative = 1e-13);
        assert_eq!(xy, 0.0);
    }

    #[test]
    fn different_bodies_combine_to_their_mean_compliance() {
        let soft = Material { young_modulus: 70e9, poisson_ratio: 0.33, ..Material::STEEL };
        let bodies = HalfSpace::new(&Material::STEEL, &soft).unwrap();
        let (g1, g2) = (Material::STEEL.shear_modulus(), soft.shear_modulus());
        assert_relative_eq!(
            bodies.shear_modulus(),
            2.0 * g1 * g2 / (g1 + g2),
            max_relative = 1e-14
        );
        let neglected = bodies.with_unlike_bodies(UnlikeBodies::Neglected);
        assert!(matches!(neglected.caveat(), Some(Warning::DissimilarBodies { .. })));
        assert_eq!((bodies.caveat(), neglected.pressure_coupling()), (None, None));
        assert!(bodies.pressure_coupling().is_some());
        assert_eq!(steel().pressure_coupling(), None);
        let nu = (0.28 / g1 + 0.33 / g2) / (1.0 / g1 + 1.0 / g2);
        assert_relative_eq!(bodies.poisson_ratio(), nu, max_relative = 1e-14);
    }
}
