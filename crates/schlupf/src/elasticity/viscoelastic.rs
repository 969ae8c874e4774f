//! Two viscoelastic half-spaces in steady rolling.

use std::f64::consts::PI;
use std::fmt;

use rustfft::num_complex::Complex;

use super::half_space::without_mean;
use super::{Compliance, Elasticity, HalfSpace};
use crate::bodies::Material;
use crate::normal::{Grid, VectorField};
use crate::numerics::fourier::{RealTransform, smooth_from, wrapped};
use crate::numerics::{love, upstream};
use crate::reporting::{Error, Quantity, Requirement, Warning, require};

/// Largest f = E/E∞ − 1: of softer bodies pressure and tractions take minutes, or are not found.
const MOST_RELAXATION: f64 = 12.0 * (1.0 + 1e-9);

/// The standard linear solid: how a body creeps under constant stress.
///
/// Its compliance grows from 1/E, with the instantaneous modulus E of its [`Material`], to 1/E∞,
///
/// J(t) = 1/E + (1/E∞ − 1/E) (1 − exp(−t/τ)),
///
/// and Poisson's ratio stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StandardLinearSolid {
    /// Young's modulus after a long time E∞, in Pa; from 1/21 of the instantaneous one to all of
    /// it.
    pub relaxed_modulus: f64,
    /// Retardation time τ, in s.
    pub retardation_time: f64,
}

/// Two half-spaces of standard linear solids in steady rolling.
///
/// Material enters the patch ahead and leaves it behind, so what acted on it lies upstream. With
/// the displacement u_e = A t of elastic bodies, the distance L = v0 τ rolled in the retardation
/// time and f = E/E∞ − 1, each body has
///
/// u(x) = u_e(x) + f ∫₀^∞ exp(−s/L)/L u_e(x + s) ds
///
/// (Kalker 1991, *Viscoelastic multilayered cylinders rolling with dry friction*; G. Wang and K.
/// Knothe, J. Appl. Mech. 60 (1993), 310): in wave numbers A is multiplied by 1 + f/(1 − i k L).
/// The influence of a cell is integrated so, and the product is a convolution as that of
/// [`HalfSpace`], but not symmetric: rolling dissipates.
///
/// Limits: steady rolling; what couples pressure and tractions of unlike bodies is neglected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticHalfSpace {
    /// Two of each body.
    bodies: [HalfSpace; 2],
    /// f of each, dimensionless.
    ratios: [f64; 2],
    /// τ of each, in s.
    times: [f64; 2],
    /// 1/E* of each, in 1/Pa.
    compliances: [f64; 2],
    /// K of unlike bodies, the largest that they have at any time.
    dissimilarity: Option<f64>,
    /// In m/s; `None` where it is that of a problem.
    speed: Option<f64>,
}

impl ViscoelasticHalfSpace {
    /// Wheel and rail.
    ///
    /// # Errors
    /// A relaxed modulus above the instantaneous one or below 1/21 of it, or a negative time.
    pub fn new(bodies: [&Material; 2], solids: [StandardLinearSolid; 2]) -> Result<Self, Error> {
        let quantities = [
            (Quantity::WheelRelaxedModulus, Quantity::WheelRetardationTime),
            (Quantity::RailRelaxedModulus, Quantity::RailRetardationTime),
        ];
        for k in [0, 1] {
            let modulus = bodies[k].young_modulus;
            let range = Requirement::Between(modulus / (1.0 + MOST_RELAXATION), modulus);
            require(quantities[k].0, range, solids[k].relaxed_modulus)?;
            require(
                quantities[k].1,
                Requirement::Between(0.0, f64::MAX),
                solids[k].retardation_time,
            )?;
        }
        Ok(Self {
            bodies: [HalfSpace::new(bodies[0], bodies[0])?, HalfSpace::new(bodies[1], bodies[1])?],
            ratios: [0, 1].map(|k| bodies[k].young_modulus / solids[k].relaxed_modulus - 1.0),
            times: solids.map(|solid| solid.retardation_time),
            compliances: bodies.map(|m| (1.0 - m.poisson_ratio.powi(2)) / m.young_modulus),
            dissimilarity: dissimilarity(bodies, solids)?,
            speed: None,
        })
    }

    /// The same rolling at a speed, in m/s.
    pub(crate) fn at_speed(&self, speed: f64) -> Self {
        Self { speed: Some(speed), ..*self }
    }

    /// The contact modulus E* (in Pa) whose compliance is the mean of the instantaneous and the
    /// relaxed one: 1 + f/(1 − i k L) lies on the circle of radius ½ f about 1 + ½ f.
    pub(crate) fn mean_modulus(&self) -> f64 {
        let mean = |k: usize| self.compliances[k] * (1.0 + 0.5 * self.ratios[k]);
        (mean(0) + mean(1)).recip()
    }

    /// L, in m.
    ///
    /// # Errors
    /// Bodies without a speed.
    fn lengths(&self) -> Result<[f64; 2], Error> {
        let speed = self.speed.ok_or(Error::ViscoelasticUnsteady {})?;
        Ok(self.times.map(|time| time * speed))
    }

    /// Sum over both bodies of the influence of a cell and of its mean upstream, each with a weight
    /// of the body, `columns` to either side and `rows` to the left, row after row.
    fn influences<const N: usize>(
        &self,
        grid: &Grid,
        [columns, rows]: [usize; 2],
        (weights, influence): ([[f64; 2]; 2], impl Fn(usize, [f64; 2]) -> [f64; N]),
    ) -> Result<Vec<[f64; N]>, Error> {
        let (first, count) = (-(columns as isize), 2 * columns as isize + 1);
        let lengths = self.lengths()?;
        let mut all = Vec::new();
        for j in 0..rows {
            let y = j as f64 * grid.spacing_y;
            let mut row = vec![[0.0; N]; count as usize];
            for (k, [now, upstream]) in weights.into_iter().enumerate() {
                let kernel = |x: f64| influence(k, [x, y]);
                let means = upstream::means([first, count], (grid.spacing_x, lengths[k]), kernel);
                for (i, (sum, mean)) in row.iter_mut().zip(means).enumerate() {
                    let own = kernel((first + i as isize) as f64 * grid.spacing_x);
                    *sum = std::array::from_fn(|c| sum[c] + now * own[c] + upstream * mean[c]);
                }
            }
            all.extend(row);
        }
        Ok(all)
    }

    /// A_xx, A_yy and A_xy, in m/Pa.
    fn tangential(&self, grid: &Grid, reach: [usize; 2]) -> Result<Vec<[f64; 3]>, Error> {
        let size = [grid.spacing_x, grid.spacing_y];
        // Half of two alike bodies.
        let weights = self.ratios.map(|ratio| [0.5, 0.5 * ratio]);
        self.influences(
            grid,
            reach,
            (weights, |k: usize, at| self.bodies[k].influence_of(size, at)),
        )
    }

    /// How much farther apart pressure moves the surfaces than elastic ones of the
    /// [`Self::mean_modulus`].
    ///
    /// # Errors
    /// Bodies without a speed.
    pub(crate) fn normal_remainder(&self, grid: &Grid) -> Result<NormalRemainder, Error> {
        let size = [grid.spacing_x, grid.spacing_y];
        let potential = |_: usize, [x, y]: [f64; 2]| {
            let at = |p: f64, q: f64| {
                [love::corner([x + p * size[0], y + q * size[1]]).iter().sum::<f64>() / PI]
            };
            let row = |q: f64| [at(-0.5, q), at(0.5, q)];
            love::rectangle([row(-0.5), row(0.5)])
        };
        let weights = [0, 1].map(|k| self.compliances[k] * self.ratios[k]).map(|w| [-0.5 * w, w]);
        let padded = Padded::new(grid);
        let influences = self.influences(grid, padded.reach(0), (weights, potential))?;
        let [symbol] = padded.transforms(|i, j| padded.at(&influences, 0, [i, j]));
        Ok(NormalRemainder { transform: RealTransform::new(padded.filled, padded.size), symbol })
    }
}

/// The largest K that bodies have between instantaneous and relaxed, if they are unlike.
fn dissimilarity(
    bodies: [&Material; 2],
    solids: [StandardLinearSolid; 2],
) -> Result<Option<f64>, Error> {
    let relaxed =
        [0, 1].map(|k| Material { young_modulus: solids[k].relaxed_modulus, ..*bodies[k] });
    let mut pairs = vec![bodies, [&relaxed[0], &relaxed[1]]];
    if solids[0].retardation_time != solids[1].retardation_time {
        pairs.extend([[bodies[0], &relaxed[1]], [&relaxed[0], bodies[1]]]);
    }
    let mut largest = None;
    for [wheel, rail] in pairs {
        let unlike = HalfSpace::new(wheel, rail)?.unlike();
        largest =
            largest.into_iter().chain(unlike).max_by(|a: &f64, b| a.abs().total_cmp(&b.abs()));
    }
    Ok(largest)
}

/// A grid padded for convolutions.
struct Padded {
    filled: [usize; 2],
    size: [usize; 2],
}

impl Padded {
    fn new(grid: &Grid) -> Self {
        let filled = [grid.columns, grid.rows];
        Self { filled, size: filled.map(|count| smooth_from(2 * count - 1)) }
    }

    /// Columns to either side, and rows to one, half way around and so many beyond.
    fn reach(&self, beyond: usize) -> [usize; 2] {
        [self.size[0] / 2 + beyond, self.size[1] / 2 + 1 + beyond]
    }

    /// Of influences within such a reach that at a distance in columns and rows, even in rows.
    fn at<const N: usize>(
        &self,
        influences: &[[f64; N]],
        beyond: usize,
        [i, j]: [isize; 2],
    ) -> [f64; N] {
        let columns = self.reach(beyond)[0];
        influences[j.unsigned_abs() * (2 * columns + 1) + (i + columns as isize) as usize]
    }

    /// The transforms of an influence at distances in columns and rows, over the number of points.
    fn transforms<const N: usize>(
        &self,
        influence: impl Fn(isize, isize) -> [f64; N],
    ) -> [Vec<Complex<f64>>; N] {
        let [nx, ny] = self.size;
        let over = ((nx * ny) as f64).recip();
        let places = (0..ny).flat_map(|j| (0..nx).map(move |i| (wrapped(i, nx), wrapped(j, ny))));
        let values: Vec<[f64; N]> = places.map(|(i, j)| influence(i, j)).collect();
        let mut transform = RealTransform::new(self.size, self.size);
        std::array::from_fn(|c| {
            transform.forward(&values.iter().map(|value| over * value[c]).collect::<Vec<_>>());
            transform.spectrum().to_vec()
        })
    }
}

/// Normal displacement under pressure beyond that of elastic bodies.
#[derive(Debug)]
pub(crate) struct NormalRemainder {
    transform: RealTransform,
    symbol: Vec<Complex<f64>>,
}

impl NormalRemainder {
    /// Under a pressure (in Pa) on the cells, in m.
    pub fn under(&mut self, pressure: &[f64]) -> Vec<f64> {
        let mut moved = vec![0.0; pressure.len()];
        self.transform.forward(pressure);
        for (value, factor) in self.transform.spectrum_mut().iter_mut().zip(&self.symbol) {
            *value *= factor;
        }
        self.transform.inverse(&mut moved);
        moved
    }
}

impl Elasticity for ViscoelasticHalfSpace {
    /// The influences with the mean over a cell removed to second order, as those of [`HalfSpace`].
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        let padded = Padded::new(grid);
        let plain = self.tangential(grid, padded.reach(1))?;
        let at = |i: isize, j: isize| {
            let [xx, yy, xy] = padded.at(&plain, 1, [i, j]);
            [xx, yy, if j < 0 { -xy } else { xy }]
        };
        let [xx, yy, xy] = padded.transforms(|i, j| without_mean(at, grid, [i, j]));
        let transform = RealTransform::new(padded.filled, padded.size);
        let held = [0, 1].map(|_| xx.clone());
        Ok(Box::new(Product { transform, influences: [xx, yy, xy], held }))
    }

    fn viscoelastic(&self) -> Option<&ViscoelasticHalfSpace> {
        self.speed.is_none().then_some(self)
    }

    fn caveat(&self) -> Option<Warning> {
        self.dissimilarity.map(|constant| Warning::DissimilarBodies { constant })
    }
}

/// The compliance on one grid.
struct Product {
    transform: RealTransform,
    /// Transforms of A_xx, A_yy and A_xy.
    influences: [Vec<Complex<f64>>; 3],
    /// Those of the traction.
    held: [Vec<Complex<f64>>; 2],
}

impl Compliance for Product {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        let Self { transform, influences: [xx, yy, xy], held: [x, y] } = self;
        for (held, traction) in [(&mut *x, &traction.x), (&mut *y, &traction.y)] {
            transform.forward(traction);
            held.copy_from_slice(transform.spectrum());
        }
        let moved = [(&*xx, &*xy, &mut displacement.x), (&*xy, &*yy, &mut displacement.y)];
        for (by_x, by_y, displacement) in moved {
            let values = transform.spectrum_mut().iter_mut().zip(by_x.iter().zip(by_y));
            for ((value, (by_x, by_y)), (x, y)) in values.zip(x.iter().zip(&*y)) {
                *value = by_x * x + by_y * y;
            }
            transform.inverse(displacement);
        }
    }

    fn couples_cells(&self) -> bool {
        true
    }
}

impl fmt::Debug for Product {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Product").finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::normal::Extent;

    /// The displacement under single cells is the elastic one and f times its mean upstream, here
    /// by a fine sum along x, with another retardation time in each body.
    #[test]
    fn a_cell_is_remembered_downstream() {
        let grid = Grid::across(&Extent { x: [-2e-3, 2e-3], y: [-1e-3, 1e-3] }, 8, 5);
        let [soft, hard] = [1e9, 3e9].map(|young_modulus| Material {
            young_modulus,
            poisson_ratio: 0.3,
            ..Material::STEEL
        });
        let solids = [(0.5e9, 1e-3), (2e9, 1e-4)].map(|(relaxed_modulus, retardation_time)| {
            StandardLinearSolid { relaxed_modulus, retardation_time }
        });
        let bodies = ViscoelasticHalfSpace::new([&soft, &hard], solids).unwrap().at_speed(2.0);
        let influences = bodies.tangential(&grid, [grid.columns, grid.rows + 1]).unwrap();
        let size = [grid.spacing_x, grid.spacing_y];
        for (i, j) in [(0, 0), (-3, 1), (4, 0), (-7, 4)] {
            let [x, y] = [f64::from(i) * size[0], f64::from(j) * size[1]];
            let mut expected = [0.0; 3];
            for (body, (ratio, length)) in bodies.bodies.iter().zip([(1.0, 2e-3), (0.5, 2e-4)]) {
                let steps = 40_000;
                let step = 30.0 * length / f64::from(steps);
                let own = body.influence_of(size, [x, y]);
                let mut mean = [0.0; 3];
                for k in 0..steps {
                    let s = (f64::from(k) + 0.5) * step;
                    let weight = step * (-s / length).exp() / length;
                    let ahead = body.influence_of(size, [x + s, y]);
                    mean = [0, 1, 2].map(|c| mean[c] + weight * ahead[c]);
                }
                expected = [0, 1, 2].map(|c| expected[c] + 0.5 * (own[c] + ratio * mean[c]));
            }
            let width = 2 * grid.columns + 1;
            let found = influences[j as usize * width + (i + grid.columns as i32) as usize];
            for c in 0..3 {
                let scale = expected[0].abs();
                assert_relative_eq!(found[c], expected[c], epsilon = 1e-4 * scale);
            }
        }
    }

    #[test]
    fn the_mean_modulus() {
        let steel = Material::STEEL;
        let solid = StandardLinearSolid {
            relaxed_modulus: 0.25 * steel.young_modulus,
            retardation_time: 1.0,
        };
        let bodies = ViscoelasticHalfSpace::new([&steel; 2], [solid; 2]).unwrap();
        let modulus = crate::bodies::contact_modulus(&steel, &steel);
        assert_relative_eq!(bodies.mean_modulus(), modulus / 2.5, max_relative = 1e-12);
        let harder = StandardLinearSolid { relaxed_modulus: 2.0 * steel.young_modulus, ..solid };
        assert!(ViscoelasticHalfSpace::new([&steel; 2], [solid, harder]).is_err());
        let grid = Grid::across(&Extent { x: [-1e-3, 1e-3], y: [-1e-3, 1e-3] }, 2, 2);
        assert!(matches!(bodies.compliance(&grid), Err(Error::ViscoelasticUnsteady {})));
    }

    /// K of one body instantaneous and the other relaxed is ½ (1 − 2ν)(1 − E∞/E)/(1 + E∞/E).
    #[test]
    fn bodies_that_become_unlike() {
        let steel = Material { poisson_ratio: 0.3, ..Material::STEEL };
        let constant = |[wheel, rail]: [(f64, f64); 2]| {
            let solids = [wheel, rail].map(|(part, retardation_time)| StandardLinearSolid {
                relaxed_modulus: part * steel.young_modulus,
                retardation_time,
            });
            match ViscoelasticHalfSpace::new([&steel; 2], solids).unwrap().caveat() {
                Some(Warning::DissimilarBodies { constant }) => constant.abs(),
                _ => 0.0,
            }
        };
        assert_eq!(constant([(0.25, 1.0); 2]), 0.0);
        for unlike in [[(0.25, 1.0), (1.0, 1.0)], [(0.25, 1.0), (0.25, 2.0)]] {
            assert_relative_eq!(constant(unlike), 0.5 * 0.4 * 0.75 / 1.25, max_relative = 1e-12);
        }
    }
}
