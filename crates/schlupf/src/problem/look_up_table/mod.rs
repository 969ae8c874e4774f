//! Look-up tables of the forces of steady rolling, for programs that need them a million times a
//! second: multibody codes.
//!
//! With Coulomb's law, constant friction, Hertz's pressure and bodies alike,
//!
//! F/(μN) and Mz/(μN √(ab)) depend on a/b, ν and (ξ', η', φ') = G ab/(μN) (ξ, η, √(ab) φ) alone
//!
//! (Kalker 1990, §3.3). A table has one ν; its four axes are a/b, the part r/(1 + r) of the way
//! from adhesion to full sliding, and two angles, the direction of the creepages. Two mirror images
//! that are exact halve the range twice. Between nodes there are cubic splines in all axes, of
//!
//! R = (F (1 + r) − F_adhesion)/r,  F = (F_adhesion + r R)/(1 + r)
//!
//! (over μN), where F_adhesion is that of Kalker's linear theory. F and its derivatives are then
//! exactly Kalker's at zero, and F at r → ∞ is that of sliding without rolling.
//!
//! Limits: Coulomb's law, one coefficient of friction, elliptic patches, half-spaces. Bodies with
//! different constants have those of [`HalfSpace`](crate::elasticity::HalfSpace), and
//! another ν than the table's counts by its creep coefficients, which makes the forces exact
//! where they are small.
//!
//! The direction of ξ is the pole of the two angles, because there the forces are odd or even in
//! the distance; the spin, near which they change fastest, is away from it. Near the pole Fy and Mz
//! are a plane over η and φ, so that derivatives do not depend on the side. Nodes, not coefficients
//! of splines, are stored.

mod axis;
mod coordinates;

use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;

use nalgebra::DMatrix;
use wide::f32x4;

use crate::reporting::{Error, Place, Quantity, Requirement, require, require_at};
use axis::{Axis, Ends, FEWEST, Weights};

use coordinates::Coordinates;

pub(crate) use coordinates::Shape;

/// Nodes of a table and the values there: all that a table consists of.
#[derive(Debug, Clone, PartialEq)]
pub struct TableNodes {
    /// ν, dimensionless.
    pub poisson_ratio: f64,
    /// a/b at the nodes, dimensionless, positive, ascending, at least four.
    pub axis_ratios: Vec<f64>,
    /// Azimuths at the nodes, in rad, from 0 to below π, ascending, at least four.
    pub azimuths: Vec<f64>,
    /// Inclinations at the nodes, in rad, from 0 to π/2, ascending, at least four.
    pub inclinations: Vec<f64>,
    /// r/(1 + r) at the nodes, dimensionless, from 0 to 1, ascending, at least four.
    pub saturations: Vec<f64>,
    /// R of Fx, Fy and Mz at the nodes: for each a/b, each azimuth, each inclination one after the
    /// other those of all saturations.
    pub values: Vec<[f32; 3]>,
    /// Kalker's C11, C22, C23 and C33 for each a/b, dimensionless.
    pub creep_coefficients: Vec<[f64; 4]>,
}

/// Forces, moment and their derivatives, normalised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalisedForce {
    /// Fx/(μN), Fy/(μN) and Mz/(μN √(ab)), dimensionless.
    pub force: [f64; 3],
    /// Their derivatives with respect to ξ', η' and φ', dimensionless: a row each.
    pub by_creepage: [[f64; 3]; 3],
    /// Whether the table covers the shape of the patch; if not, these are the forces on the most
    /// slender patch that it covers.
    pub is_covered: bool,
}

/// A table that is ready for use.
#[derive(Clone, PartialEq)]
pub struct LookUpTable {
    nodes: TableNodes,
    axis_ratio: Axis,
    azimuth: Axis,
    inclination: Axis,
    saturation: Axis,
    /// Of Fx, Fy and Mz for each a/b, azimuth, inclination and saturation.
    coefficients: Vec<f32>,
    /// Distances between neighbours in a/b, azimuth, inclination and saturation.
    strides: [usize; 4],
    /// C11, C22, C23 and C33 for each coefficient in a/b.
    creep_coefficients: Vec<f32x4>,
}

/// Without its values.
impl fmt::Debug for LookUpTable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = self.axis_ratios();
        write!(formatter, "LookUpTable(a/b from {low} to {high}, {} nodes)", self.nodes.count())
    }
}

/// Fx, Fy and Mz.
const COMPONENTS: usize = 3;

/// Non-zero basis functions on an axis, and numbers that are computed together.
const WIDTH: usize = 4;

/// The components at the four nodes in saturation that count, one after the other.
type Row = [f32x4; COMPONENTS];

/// The same shape of the patch, as far as rounding goes.
const ROUNDING: f64 = 1e-9;

/// A table at one shape of the patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AtShape {
    pub shape: Shape,
    ratio: Weights,
    /// What the creep coefficients of the bodies add to the forces of adhesion: derivatives with
    /// respect to each component of x.
    correction: Option<[[f64; 3]; 3]>,
    is_covered: bool,
}

impl LookUpTable {
    /// A table with these nodes.
    ///
    /// # Errors
    /// Nodes that do not ascend or do not fill their range, values that are missing or not finite.
    pub fn new(nodes: TableNodes) -> Result<Self, Error> {
        nodes.check()?;
        let logarithms = nodes.axis_ratios.iter().map(|ratio| ratio.ln()).collect();
        let axis_ratio = Axis::new(logarithms, Ends::Open);
        let azimuth = Axis::new(nodes.azimuths.clone(), Ends::Periodic(PI));
        let inclination = Axis::new(nodes.inclinations.clone(), Ends::Mirrored);
        let saturation = Axis::new(nodes.saturations.clone(), Ends::Open);
        let axes = [&axis_ratio, &azimuth, &inclination, &saturation];
        let (coefficients, creep_coefficients) = splines(axes, &nodes).ok_or(Error::Invalid {
            quantity: Quantity::LookUpTable,
            requirement: Requirement::Finite,
            value: f64::NAN,
            place: Place::Only,
        })?;
        let [azimuths, inclinations, saturations] =
            [&azimuth, &inclination, &saturation].map(Axis::coefficients);
        let line = COMPONENTS * saturations;
        let strides = [azimuths * inclinations * line, inclinations * line, line, COMPONENTS];
        Ok(Self {
            nodes,
            axis_ratio,
            azimuth,
            inclination,
            saturation,
            coefficients,
            strides,
            creep_coefficients,
        })
    }

    /// Its nodes.
    pub fn nodes(&self) -> &TableNodes {
        &self.nodes
    }

    /// Range of a/b, dimensionless.
    pub fn axis_ratios(&self) -> [f64; 2] {
        let ratios = &self.nodes.axis_ratios;
        [ratios[0], ratios[ratios.len() - 1]]
    }

    /// Whether it covers patches of an a/b, dimensionless.
    pub fn covers(&self, axis_ratio: f64) -> bool {
        let [low, high] = self.axis_ratios();
        (low * (1.0 - ROUNDING)..=high * (1.0 + ROUNDING)).contains(&axis_ratio)
    }

    /// Forces and moment at a/b and (ξ', η', φ') = G ab/(μN) (ξ, η, √(ab) φ), all dimensionless.
    /// Allocates nothing. Values that are not finite give forces that are not.
    #[inline]
    pub fn normalised_force(&self, axis_ratio: f64, creepages: [f64; 3]) -> NormalisedForce {
        self.force_at(&self.at(axis_ratio, None), creepages)
    }

    /// What depends on the shape of the patch; with creep coefficients of another ν.
    #[inline]
    pub(crate) fn at(&self, axis_ratio: f64, own: Option<[f64; 4]>) -> AtShape {
        let [low, high] = self.axis_ratios();
        let ratio = self.axis_ratio.weights(axis_ratio.ln());
        let is_covered = self.covers(axis_ratio);
        let rows = &self.creep_coefficients[ratio.first..];
        let rows = splat(ratio.values).into_iter().zip(rows);
        let sum = rows.fold(f32x4::ZERO, |sum, (weight, row)| sum + weight * *row);
        let coefficients = sum.to_array().map(f64::from);
        let shape = Shape::new(axis_ratio.clamp(low, high), coefficients);
        let correction = own.map(|own| {
            let shape =
                Shape { coefficients: std::array::from_fn(|k| own[k] - coefficients[k]), ..shape };
            shape.adhesion_slopes()
        });
        AtShape { shape, ratio, correction, is_covered }
    }

    /// Forces and moment on a patch of a given shape.
    #[inline]
    pub(crate) fn force_at(&self, at: &AtShape, creepages: [f64; 3]) -> NormalisedForce {
        let AtShape { shape, is_covered, .. } = *at;
        let by_x = shape.adhesion_slopes();
        let scaled = |slopes: [[f64; 3]; 3]| {
            // From columns by x to rows by creepage.
            std::array::from_fn(|row| {
                std::array::from_fn(|column| slopes[column][row] * shape.scales[column])
            })
        };
        if creepages == [0.0; 3] {
            let by_x = at.correction.map_or(by_x, |correction| sum(by_x, correction));
            return NormalisedForce { force: [0.0; 3], by_creepage: scaled(by_x), is_covered };
        }
        let coordinates = shape.coordinates(creepages);
        let size = coordinates.size;
        let beyond = (1.0 + size).recip();
        let rest = if coordinates.pole < 1.0 {
            self.near_pole(at, &coordinates, size * beyond)
        } else {
            self.interpolated(at, &coordinates, size * beyond)
        };
        // For size → ∞ with size/(1 + size) and the direction, so that nothing overflows.
        let adhesion = shape.adhesion(coordinates.direction);
        let part = size * beyond;
        let mut force: [f64; 3] = std::array::from_fn(|k| part * (adhesion[k] + rest.values[k]));
        let mut slopes = [[0.0; 3]; 3];
        for (column, slopes) in slopes.iter_mut().enumerate() {
            let along = coordinates.direction[column];
            for (row, slope) in slopes.iter_mut().enumerate() {
                let of_rest = rest.by_saturation[row] * part * beyond * along
                    + rest.by_inclination[row] * coordinates.inclination_slopes[column]
                    + rest.by_azimuth[row] * coordinates.azimuth_slopes[column];
                let sum = by_x[column][row] + (rest.values[row] - force[row]) * along + of_rest;
                *slope = beyond * sum;
            }
        }
        if let Some(correction) = at.correction {
            correct(&correction, &coordinates, &mut force, &mut slopes);
        }
        if coordinates.direction[0] == 0.0 {
            // By symmetry, which the splines have to rounding error only.
            force[0] = 0.0;
        }
        limit(&mut force, &mut slopes);
        let [along, aside] = coordinates.signs;
        let signs = [along, aside, aside];
        for (column, slopes) in slopes.iter_mut().enumerate() {
            for (row, slope) in slopes.iter_mut().enumerate() {
                *slope *= signs[row] * signs[column];
            }
        }
        let force = std::array::from_fn(|k| signs[k] * force[k]);
        NormalisedForce { force, by_creepage: scaled(slopes), is_covered }
    }

    /// R and its derivatives near the direction of ξ, where Fy and Mz are linear in η and φ: a
    /// plane through those of both, so that derivatives do not depend on the side.
    fn near_pole(&self, at: &AtShape, coordinates: &Coordinates, saturation: f64) -> Rest {
        let pole = coordinates.pole;
        let (spin, across) = coordinates.azimuth.sin_cos();
        let [one, other] = [0.0, FRAC_PI_2].map(|azimuth| {
            let there = Coordinates { azimuth, pole: 1.0, ..*coordinates };
            self.interpolated(at, &there, saturation)
        });
        let odd = |one: f64, other: f64| across * one + spin * other;
        let even = |one: f64, other: f64| across * across * one + spin * spin * other;
        let mixed = |one: [f64; 3], other: [f64; 3], factors: [f64; 2]| {
            std::array::from_fn(|k| match k {
                0 => factors[0] * even(one[k], other[k]),
                _ => factors[1] * odd(one[k], other[k]),
            })
        };
        let turned =
            |k: usize| if k == 0 { 0.0 } else { across * other.values[k] - spin * one.values[k] };
        Rest {
            values: mixed(one.values, other.values, [1.0, pole]),
            by_saturation: mixed(one.by_saturation, other.by_saturation, [1.0, pole]),
            by_inclination: mixed(one.by_inclination, other.by_inclination, [pole, 1.0]),
            by_azimuth: std::array::from_fn(turned),
        }
    }

    /// R and its derivatives at a place of the table.
    #[inline]
    fn interpolated(&self, at: &AtShape, coordinates: &Coordinates, saturation: f64) -> Rest {
        let azimuth = self.azimuth.weights(coordinates.azimuth);
        let inclination = self.inclination.weights(coordinates.inclination);
        let saturation = self.saturation.weights(saturation);
        let ratios = splat(at.ratio.values);
        let [across, along] = [inclination.values, inclination.slopes].map(splat);
        let [around, turning] = [azimuth.values, azimuth.slopes].map(splat);
        let firsts = [at.ratio.first, azimuth.first, inclination.first, saturation.first];
        let first: usize = firsts.iter().zip(self.strides).map(|(first, step)| first * step).sum();
        let [planes, _, lines, _] = self.strides;
        let planes: [&[f32]; WIDTH] =
            std::array::from_fn(|k| &self.coefficients[first + k * planes..]);
        let extent = 3 * lines + WIDTH * COMPONENTS;
        let (mut values, mut by_inclination, mut by_azimuth) = (EMPTY, EMPTY, EMPTY);
        for i in 0..WIDTH {
            let start = i * self.strides[1];
            let parts = planes.map(|plane| &plane[start..start + extent]);
            let (mut value, mut slope) = (EMPTY, EMPTY);
            for j in 0..WIDTH {
                let mut sum = EMPTY;
                for (ratio, part) in ratios.iter().zip(parts) {
                    add(&mut sum, *ratio, &row(&part[j * lines..]));
                }
                add(&mut value, across[j], &sum);
                add(&mut slope, along[j], &sum);
            }
            add(&mut values, around[i], &value);
            add(&mut by_azimuth, turning[i], &value);
            add(&mut by_inclination, around[i], &slope);
        }
        let sums = [
            along_row(&values, saturation.values),
            along_row(&values, saturation.slopes),
            along_row(&by_inclination, saturation.values),
            along_row(&by_azimuth, saturation.values),
        ];
        Rest::new(sums)
    }
}

#[inline]
fn row(part: &[f32]) -> Row {
    let (quarters, _) = part[..WIDTH * COMPONENTS].as_chunks::<WIDTH>();
    std::array::from_fn(|k| f32x4::new(quarters[k]))
}

const EMPTY: Row = [f32x4::ZERO; COMPONENTS];

/// Adds a row with a weight.
#[inline]
fn add(sum: &mut Row, weight: f32x4, row: &Row) {
    for (sum, row) in sum.iter_mut().zip(row) {
        *sum += weight * *row;
    }
}

/// The components of a row with a weight for each of its nodes.
#[inline]
fn along_row(row: &Row, weights: f32x4) -> [f32; COMPONENTS] {
    let [w0, w1, w2, w3] = weights.to_array();
    let [a, b, c] = [
        row[0] * f32x4::from([w0, w0, w0, w1]),
        row[1] * f32x4::from([w1, w1, w2, w2]),
        row[2] * f32x4::from([w2, w3, w3, w3]),
    ]
    .map(f32x4::to_array);
    [a[0] + a[3] + b[2] + c[1], a[1] + b[0] + b[3] + c[2], a[2] + b[1] + c[0] + c[3]]
}

/// R of Fx, Fy and Mz, and its derivatives along the axes of the table.
struct Rest {
    values: [f64; 3],
    by_saturation: [f64; 3],
    by_inclination: [f64; 3],
    by_azimuth: [f64; 3],
}

impl Rest {
    #[inline]
    fn new(sums: [[f32; COMPONENTS]; 4]) -> Self {
        let [values, by_saturation, by_inclination, by_azimuth] =
            sums.map(|sums| sums.map(f64::from));
        Self { values, by_saturation, by_inclination, by_azimuth }
    }
}

/// Adds what own creep coefficients add: a linear force over (1 + r)², which leaves sliding as it
/// is.
fn correct(
    correction: &[[f64; 3]; 3],
    coordinates: &Coordinates,
    force: &mut [f64; 3],
    slopes: &mut [[f64; 3]; 3],
) {
    let (size, direction) = (coordinates.size, coordinates.direction);
    let beyond = (1.0 + size).recip();
    let part = size * beyond;
    for row in 0..3 {
        let along: f64 = (0..3).map(|column| correction[column][row] * direction[column]).sum();
        force[row] += along * part * beyond;
        for column in 0..3 {
            let turned = 2.0 * along * part * direction[column];
            slopes[column][row] += (correction[column][row] - turned) * beyond * beyond;
        }
    }
}

fn sum(one: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|column| std::array::from_fn(|row| one[column][row] + other[column][row]))
}

/// Each of four numbers, four times.
#[inline]
fn splat(numbers: f32x4) -> [f32x4; WIDTH] {
    numbers.to_array().map(f32x4::splat)
}

/// Scales a force that the splines let exceed the friction limit back to it; `slopes` are columns.
#[inline]
fn limit(force: &mut [f64; 3], slopes: &mut [[f64; 3]; 3]) {
    let squared = force[0] * force[0] + force[1] * force[1];
    if squared <= 1.0 {
        return;
    }
    let inverse = squared.sqrt().recip();
    let unit = [force[0] * inverse, force[1] * inverse];
    (force[0], force[1]) = (unit[0], unit[1]);
    for [x, y, _] in slopes {
        let outwards = unit[0] * *x + unit[1] * *y;
        *x = inverse * (*x - outwards * unit[0]);
        *y = inverse * (*y - outwards * unit[1]);
    }
}

impl TableNodes {
    /// Number of nodes.
    pub fn count(&self) -> usize {
        self.axis_ratios.len()
            * self.azimuths.len()
            * self.inclinations.len()
            * self.saturations.len()
    }

    fn check(&self) -> Result<(), Error> {
        const TABLE: Quantity = Quantity::LookUpTable;
        require(Quantity::PoissonRatio, Requirement::Between(0.0, 0.5), self.poisson_ratio)?;
        let axes = [&self.axis_ratios, &self.azimuths, &self.inclinations, &self.saturations];
        let ranges = [
            Requirement::Between(1e-6, 1e6),
            Requirement::Between(0.0, PI),
            Requirement::Between(0.0, FRAC_PI_2),
            Requirement::Between(0.0, 1.0),
        ];
        for (axis, range) in axes.into_iter().zip(ranges) {
            crate::reporting::require_several(TABLE, FEWEST, axis.len())?;
            for (k, node) in axis.iter().enumerate() {
                require_at(TABLE, range, *node, Place::Index(k + 1))?;
            }
            if let Some(pair) = axis.windows(2).find(|pair| pair[1] <= pair[0]) {
                let (before, after) = (pair[0], pair[1]);
                return Err(Error::NotAscending { quantity: TABLE, axis: "", before, after });
            }
        }
        let ends = [
            (self.azimuths[0], 0.0),
            (self.inclinations[0], 0.0),
            (self.inclinations[self.inclinations.len() - 1], FRAC_PI_2),
            (self.saturations[0], 0.0),
            (self.saturations[self.saturations.len() - 1], 1.0),
        ];
        for (end, needed) in ends {
            require(TABLE, Requirement::Between(needed, needed), end)?;
        }
        require(TABLE, Requirement::Inside(0.0, PI), self.azimuths[self.azimuths.len() - 1])?;
        for (expected, count) in [
            (self.count(), self.values.len()),
            (self.axis_ratios.len(), self.creep_coefficients.len()),
        ] {
            if expected != count {
                return Err(Error::WrongCount { quantity: TABLE, expected, count });
            }
        }
        let unfit = self.values.iter().flatten().find(|value| !value.is_finite());
        unfit.map_or(Ok(()), |value| require(TABLE, Requirement::Finite, f64::from(*value)))
    }
}

type Coefficients = (Vec<f32>, Vec<f32x4>);

/// Coefficients of the splines through all values, and through the creep coefficients.
fn splines(axes: [&Axis; 4], nodes: &TableNodes) -> Option<Coefficients> {
    // Signs of Fx, and of Fy and Mz.
    let azimuth = [1.0, -1.0].map(|sign| [sign, sign]);
    let inclination = [[1.0, -1.0], [-1.0, 1.0]];
    let open = axes[0].interpolation([1.0; 2])?;
    let saturation = axes[3].interpolation([1.0; 2])?;
    let counts = axes.map(|axis| axis.nodes().len());
    let mut whole: Vec<[f32; COMPONENTS]> =
        vec![[0.0; COMPONENTS]; axes.iter().map(|axis| axis.coefficients()).product()];
    for component in 0..COMPONENTS {
        let parity = usize::from(component > 0);
        let matrices = [
            open.clone(),
            axes[1].interpolation(azimuth[parity])?,
            axes[2].interpolation(inclination[parity])?,
            saturation.clone(),
        ];
        let mut field: Vec<f64> =
            nodes.values.iter().map(|value| f64::from(value[component])).collect();
        let mut shape = counts;
        for (axis, matrix) in matrices.iter().enumerate() {
            field = along(&field, shape, axis, matrix);
            shape[axis] = matrix.nrows();
        }
        for (whole, value) in whole.iter_mut().zip(field) {
            whole[component] = value as f32;
        }
    }
    let creep = (0..open.nrows()).map(|row| {
        let mut sum = [0.0; WIDTH];
        for (column, values) in nodes.creep_coefficients.iter().enumerate() {
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum += open[(row, column)] * value;
            }
        }
        f32x4::from(sum.map(|value: f64| value as f32))
    });
    Some((whole.concat(), creep.collect()))
}

/// A field on a grid of a given shape with a matrix applied along one of its axes.
fn along(field: &[f64], shape: [usize; 4], axis: usize, matrix: &DMatrix<f64>) -> Vec<f64> {
    let inner: usize = shape[axis + 1..].iter().product();
    let (rows, columns) = matrix.shape();
    let mut result = Vec::with_capacity(field.len() / columns * rows);
    for block in field.chunks_exact(columns * inner) {
        for row in 0..rows {
            let start = result.len();
            result.resize(start + inner, 0.0);
            for (column, line) in block.chunks_exact(inner).enumerate() {
                let weight = matrix[(row, column)];
                for (sum, value) in result[start..].iter_mut().zip(line) {
                    *sum += weight * value;
                }
            }
        }
    }
    result
}
