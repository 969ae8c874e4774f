//! Stresses below the surfaces of wheel and rail, due to pressure and traction of the contact.
//!
//! Each body is a half-space, on whose cells pressure and traction are constant; the stresses at
//! any point are then sums of closed forms (`kernel`). [`SubsurfaceStress::at`] takes the sum for
//! a point, and [`SubsurfaceStress::layer`] for all points of a layer at a depth, as a convolution
//! by fast Fourier transform.
//!
//! Limits: elastic bodies that are large compared with the patch, without residual, thermal and
//! bending stresses. The loads are those of the solution, whatever its model of elasticity.
//! Cells of a solution are divided into pieces, at least 72 across the patch, each with its own
//! mean pressure. Loads that are constant in pieces have steps between them, which are felt down to
//! a depth of about one piece: there the stresses at the middles of the pieces are interpolated.

mod kernel;
mod load;
mod stress;
mod layer;
mod largest;

use crate::analysis::temperature_field::Side;
use crate::normal::Grid;
use crate::problem::Problem;
use crate::reporting::{
    Column, Error, MethodPurpose, Progress, Quantity, Record, Stage, Watch, WheelRailError,
    columns, require_finite, tell,
};
use crate::solution::Solution;

use kernel::corner;
pub use largest::{Largest, Measure, PointStress};
pub use layer::Layer;
use layer::LayerTransform;
pub use load::SurfaceLoad;
use load::divided;
pub use stress::Stress;

/// The stresses in one of the two bodies.
#[derive(Debug, Clone)]
pub struct SubsurfaceStress {
    grid: Grid,
    /// The same with every cell divided into pieces, and how many of them there are each way.
    finer: Grid,
    pieces: usize,
    side: Side,
    /// Dimensionless.
    poisson_ratio: f64,
    load: SurfaceLoad,
    /// By how much each load steps up at the corners of the pieces, row by row, in Pa.
    steps: Vec<[f64; 3]>,
}

/// Stresses in a box below the contact.
#[derive(Debug, Clone)]
pub struct StressVolume {
    /// The points of every layer are the middles of the cells of this grid.
    pub grid: Grid,
    /// Layers, in the order of the depths.
    pub layers: Vec<Layer>,
}

/// A vertical plane through a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Plane {
    /// Where y, in m, is constant.
    AlongRolling {
        /// Place of the plane across rolling, in m.
        y: f64,
    },
    /// Where x, in m, is constant.
    AcrossRolling {
        /// Place of the plane along rolling, in m.
        x: f64,
    },
}

impl StressVolume {
    /// The stress at a cell of a layer.
    pub fn at(&self, layer: usize, column: usize, row: usize) -> Stress {
        self.layers[layer].stress[self.grid.index(column, row)]
    }

    /// The stresses in a vertical plane, a row for each layer: linear between the two neighbouring
    /// rows (or columns) of points, and those of the outermost one beyond it.
    pub fn section(&self, plane: Plane) -> Vec<Vec<Stress>> {
        let Grid { rows, columns, spacing_x, spacing_y, .. } = self.grid;
        let (place, count, length) = match plane {
            Plane::AlongRolling { y } => ((y - self.grid.y(0)) / spacing_y, rows, columns),
            Plane::AcrossRolling { x } => ((x - self.grid.x(0)) / spacing_x, columns, rows),
        };
        let place = place.max(0.0);
        let lower = (place as usize).min(count.saturating_sub(1));
        let upper = (lower + 1).min(count.saturating_sub(1));
        let part = (place - lower as f64).min(1.0);
        let at = |layer: usize, line: usize, k: usize| match plane {
            Plane::AlongRolling { .. } => self.at(layer, k, line),
            Plane::AcrossRolling { .. } => self.at(layer, line, k),
        };
        let between = |layer: usize, k: usize| {
            at(layer, lower, k) * (1.0 - part) + at(layer, upper, k) * part
        };
        (0..self.layers.len())
            .map(|layer| (0..length).map(|k| between(layer, k)).collect())
            .collect()
    }
}

impl SubsurfaceStress {
    /// Stresses in a body due to the pressure and the traction of a solution, that of the last
    /// instant of a history.
    ///
    /// ```
    /// use schlupf::analysis::subsurface::{Measure, SubsurfaceStress};
    /// use schlupf::analysis::temperature_field::Side;
    /// use schlupf::{solver, Options, Problem, unwatched};
    ///
    /// let problem = Problem::builder().creepage_x(0.002).build()?;
    /// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
    /// let solution = solver::solve(&problem, &options, &unwatched)?;
    /// let rail = SubsurfaceStress::new(&problem, &solution, Side::Rail)?;
    /// let p0 = solution.normal.peak_pressure;
    /// let below = rail.at([0.0, 0.0], 0.5 * solution.normal.semi_axis_x);
    /// assert!(below.zz < -0.7 * p0 && below.von_mises() < 0.8 * p0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// A method without fields, and a contact on a curved surface.
    pub fn new(problem: &Problem, solution: &Solution, side: Side) -> Result<Self, Error> {
        let fields = &solution.fields;
        if fields.is_empty() {
            let method = solution.method.name();
            return Err(Error::OtherMethod { purpose: MethodPurpose::Stress, method });
        }
        let coupling = problem.interface.elasticity.pressure_coupling();
        if coupling.is_some_and(|coupling| coupling.curvature != 0.0) {
            return Err(WheelRailError::CurvedBelow {}.into());
        }
        let (load, pieces) = SurfaceLoad::of_solution(problem, solution, side)?;
        let body = match side {
            Side::Wheel => &problem.interface.wheel,
            Side::Rail => &problem.interface.rail,
        };
        Self::on(fields.grid, pieces, load, (side, body.material.poisson_ratio))
    }

    /// Stresses in a body with the given Poisson's ratio (dimensionless) due to loads on the cells
    /// of a grid, row by row.
    ///
    /// # Errors
    /// Another number of loads than of cells, and loads that are not finite.
    pub fn of_load(
        grid: Grid,
        load: SurfaceLoad,
        side: Side,
        poisson_ratio: f64,
    ) -> Result<Self, Error> {
        Self::on(grid, 1, load, (side, poisson_ratio))
    }

    /// Loads on the pieces of the cells of a grid.
    fn on(
        grid: Grid,
        pieces: usize,
        load: SurfaceLoad,
        (side, poisson_ratio): (Side, f64),
    ) -> Result<Self, Error> {
        let finer = divided(&grid, pieces);
        load.check(&finer)?;
        require_finite(Quantity::PoissonRatio, poisson_ratio)?;
        let steps = steps(&finer, &load);
        Ok(Self { grid, finer, pieces, side, poisson_ratio, load, steps })
    }

    /// The body.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The grid of the contact.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The stress at (x, y) and at the given `depth` below the surface of the body (all in m, the
    /// depth not negative).
    ///
    /// Two pieces deep and below, it is exact for loads that are constant in pieces. Less than one
    /// piece deep, it is interpolated linearly between the middles of the pieces, and between one
    /// and two pieces deep the one passes into the other; each direction goes by its own size of
    /// the pieces.
    pub fn at(&self, [x, y]: [f64; 2], depth: f64) -> Stress {
        let Grid { spacing_x, spacing_y, origin_x, origin_y, .. } = self.finer;
        let depth = depth.max(0.0);
        let along = nodes(x, [origin_x, spacing_x], depth);
        let across = nodes(y, [origin_y, spacing_y], depth);
        let mut sum = Stress::default();
        for (x, of_x) in along.into_iter().filter(|(_, weight)| *weight > 0.0) {
            for (y, of_y) in across.into_iter().filter(|(_, weight)| *weight > 0.0) {
                sum = sum + self.exact([x, y], depth) * (of_x * of_y);
            }
        }
        sum
    }

    /// The sum over the corners of all pieces.
    fn exact(&self, [x, y]: [f64; 2], depth: f64) -> Stress {
        let columns = self.finer.columns + 1;
        let mut sum = [0.0; 6];
        let corners = self.steps.iter().enumerate();
        for (k, steps) in corners.filter(|(_, steps)| **steps != [0.0; 3]) {
            let [i, j] = [k % columns, k / columns];
            let way = [x - self.finer.edge_x(i), y - self.finer.edge_y(j)];
            let response = corner(way, depth, self.poisson_ratio);
            for (step, stresses) in steps.iter().zip(&response) {
                for (total, stress) in sum.iter_mut().zip(stresses) {
                    *total += step * stress;
                }
            }
        }
        self.in_contact_frame(sum)
    }

    /// Components with z into the body as components in the contact frame.
    fn in_contact_frame(&self, [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Stress {
        let sign = match self.side {
            Side::Wheel => 1.0,
            Side::Rail => -1.0,
        };
        Stress::new([xx, yy, zz, xy, sign * xz, sign * yz])
    }

    /// The stresses at a depth (in m) below the middles of the cells and of `margin` more columns
    /// and rows on each side, by fast Fourier transform.
    pub fn layer(&self, depth: f64, margin: [usize; 2]) -> Layer {
        LayerTransform::new(self, margin).layer(self, depth)
    }

    /// Number of points of the lattice of pieces on which layers with that margin are computed
    /// (dimensionless, beyond any whole number for a huge margin): each takes some 200 bytes.
    pub fn lattice_points(&self, margin: [usize; 2]) -> f64 {
        LayerTransform::points(self, margin)
    }

    /// The stresses in layers at the given depths (in m), each as [`Self::layer`] has it.
    ///
    /// # Errors
    /// [`Error::Stopped`] if `watch` says so.
    pub fn volume(
        &self,
        depths: &[f64],
        margin: [usize; 2],
        watch: Watch,
    ) -> Result<StressVolume, Error> {
        let mut transform = LayerTransform::new(self, margin);
        let mut layers = Vec::with_capacity(depths.len());
        for (k, depth) in depths.iter().enumerate() {
            tell(watch, Progress::count(Stage::Subsurface, 0).of(k, depths.len()))?;
            layers.push(transform.layer(self, *depth));
        }
        Ok(StressVolume { grid: transform.grid(), layers })
    }
}

/// Places (in m) at which a stress is needed for that at a place and at a depth (both in m), with
/// their weights: the place itself, and the middles of the two pieces around it. Pieces begin at
/// an origin and have a size (in m).
fn nodes(place: f64, [origin, spacing]: [f64; 2], depth: f64) -> [(f64, f64); 3] {
    let interpolated = (2.0 - depth / spacing).clamp(0.0, 1.0);
    let from_first = (place - origin) / spacing - 0.5;
    let lower = from_first.floor();
    let part = from_first - lower;
    let middle = |k: f64| origin + (lower + k + 0.5) * spacing;
    [
        (place, 1.0 - interpolated),
        (middle(0.0), interpolated * (1.0 - part)),
        (middle(1.0), interpolated * part),
    ]
}

/// The mixed differences of the loads: q(i, j) − q(i − 1, j) − q(i, j − 1) + q(i − 1, j − 1) at the
/// lower corner of piece (i, j).
fn steps(grid: &Grid, load: &SurfaceLoad) -> Vec<[f64; 3]> {
    let loads = load.fields().map(|(_, values)| values);
    let value = |c: usize, i: usize, j: usize| {
        let inside = (1..=grid.columns).contains(&i) && (1..=grid.rows).contains(&j);
        if inside { loads[c][grid.index(i - 1, j - 1)] } else { 0.0 }
    };
    let step = |i: usize, j: usize| {
        std::array::from_fn(|c| {
            value(c, i + 1, j + 1) - value(c, i, j + 1) - value(c, i + 1, j) + value(c, i, j)
        })
    };
    (0..=grid.rows).flat_map(|j| (0..=grid.columns).map(move |i| step(i, j))).collect()
}

/// Stresses at points below the surface.
impl Record for [PointStress] {
    fn rows(&self) -> usize {
        self.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { [PointStress]:
        X => |points, k| points[k].x,
        Y => |points, k| points[k].y,
        Depth => |points, k| points[k].depth,
        StressXx => |points, k| points[k].stress.xx,
        StressYy => |points, k| points[k].stress.yy,
        StressZz => |points, k| points[k].stress.zz,
        StressXy => |points, k| points[k].stress.xy,
        StressXz => |points, k| points[k].stress.xz,
        StressYz => |points, k| points[k].stress.yz,
        VonMisesStress => |points, k| points[k].stress.von_mises(),
        LargestShearStress => |points, k| points[k].stress.largest_shear(),
        LargestPrincipalStress => |points, k| points[k].stress.principal()[0],
        HydrostaticStress => |points, k| points[k].stress.hydrostatic(),
    };
}
