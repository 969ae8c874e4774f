//! Where a stress is largest.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::layer::LayerTransform;
use super::{Stress, StressVolume, SubsurfaceStress};
use crate::normal::Grid;
use crate::numerics::parallel;
use crate::reporting::{Error, Progress, Stage, Watch, tell};

/// What is compared between points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Equivalent stress of von Mises.
    VonMises,
    /// Largest shear stress over all planes.
    Shear,
    /// Largest principal stress.
    Tension,
}

impl Measure {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::VonMises, Self::Shear, Self::Tension];

    /// Its value, in Pa.
    pub fn of(self, stress: &Stress) -> f64 {
        match self {
            Self::VonMises => stress.von_mises(),
            Self::Shear => stress.largest_shear(),
            Self::Tension => stress.principal()[0],
        }
    }
}

/// The stress at a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PointStress {
    /// Position along rolling, in m.
    pub x: f64,
    /// Position across rolling, in m.
    pub y: f64,
    /// Depth below the surface, in m.
    pub depth: f64,
    /// The stress there.
    pub stress: Stress,
}

/// Where a measure is largest in a body: on the surface and below.
///
/// Both are given because which of them is larger may depend on how finely the load is resolved:
/// along the edge of a sliding contact the stress on the surface grows with the number of cells,
/// and that below does not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Largest {
    /// The larger of the two.
    pub anywhere: PointStress,
    /// The largest on the surface, among the middles of the pieces of the load.
    pub surface: PointStress,
    /// The largest of the places below the surface where the stress falls in every direction;
    /// `None` where it falls from the surface on.
    pub below: Option<PointStress>,
}

/// Part of the distance between points to which a place is found.
const ACCURACY: f64 = 1e-3;

/// Factor by which steps towards a place are shortened.
const SHORTER: f64 = 0.25;

/// Ratio of the depths of neighbouring layers of the survey.
const RATIO: f64 = 1.25;

/// Cells around the loads that are searched, too.
const MARGIN: [usize; 2] = [2, 2];

/// A local maximum of the survey may lead to the largest one if it reaches this part of it.
const PROMISING: f64 = 0.9;

/// Most local maxima that are followed.
const MOST_STARTS: usize = 6;

/// Points that a thread computes at once.
const AT_ONCE: usize = 32;

impl SubsurfaceStress {
    /// The stress at (x, y) and at a depth (all in m), with its place.
    pub fn point(&self, [x, y, depth]: [f64; 3]) -> PointStress {
        PointStress { x, y, depth, stress: self.at([x, y], depth) }
    }

    /// The stresses at points, each with x, y and depth in m; on several threads.
    ///
    /// # Errors
    /// [`Error::Stopped`] if `watch` says so.
    pub fn points(&self, places: &[[f64; 3]], watch: Watch) -> Result<Vec<PointStress>, Error> {
        let done = AtomicUsize::new(0);
        let parts = parallel::try_map(places.chunks(AT_ONCE).collect(), |part: &[[f64; 3]]| {
            let before = done.fetch_add(part.len(), Ordering::Relaxed);
            tell(watch, Progress::count(Stage::StressPoints, 0).of(before, places.len()))?;
            Ok::<_, Error>(part.iter().map(|place| self.point(*place)).collect::<Vec<_>>())
        })?;
        Ok(parts.concat())
    }

    /// Where measures are largest in the body. Layers whose depths grow by a quarter, from that of
    /// a piece of a cell to twice the smaller half of the loaded rectangle, show where the largest
    /// stresses may be; from there on places in between are found to a thousandth of the distance
    /// between points. What is less than a piece deep counts as the surface.
    ///
    /// # Errors
    /// [`Error::Stopped`] if `watch` says so.
    pub fn largest<const N: usize>(
        &self,
        measures: [Measure; N],
        watch: Watch,
    ) -> Result<[Largest; N], Error> {
        let mut transform = LayerTransform::new(self, MARGIN);
        let depths = self.surveyed_depths();
        let count = depths.len() + 1 + measures.len();
        let step = |k: usize| tell(watch, Progress::count(Stage::LargestStress, 0).of(k, count));
        step(0)?;
        let surface = transform.of_pieces(self, 0.0);
        let mut layers = Vec::with_capacity(depths.len());
        for (k, depth) in depths.iter().enumerate() {
            step(k + 1)?;
            layers.push(transform.layer(self, *depth));
        }
        let survey = StressVolume { grid: transform.grid(), layers };
        let mut found = Vec::with_capacity(N);
        for (k, measure) in measures.into_iter().enumerate() {
            step(depths.len() + 1 + k)?;
            let surface = on_surface(measure, &surface);
            let below = self.below(measure, &survey, watch)?;
            let deeper = below.filter(|p| measure.of(&p.stress) > measure.of(&surface.stress));
            found.push(Largest { anywhere: deeper.unwrap_or(surface), surface, below });
        }
        let nothing = self.point([0.0; 3]);
        let nothing = Largest { anywhere: nothing, surface: nothing, below: None };
        Ok(std::array::from_fn(|k| found.get(k).copied().unwrap_or(nothing)))
    }

    /// Depths from which places below the surface are searched, in m, in a geometric series.
    fn surveyed_depths(&self) -> Vec<f64> {
        let Some([x, y]) = self.loaded() else { return Vec::new() };
        let half = 0.5 * (x[1] - x[0]).min(y[1] - y[0]);
        let piece = self.finer.spacing_x.max(self.finer.spacing_y);
        let first = piece.min(half / 8.0);
        let count = (2.0 * half / first).ln() / RATIO.ln();
        // The layer above the first shows whether the stress falls from the surface on.
        (-1..=count.ceil() as i32).map(|k| first * RATIO.powi(k)).collect()
    }

    /// The rectangle that encloses all loads: from and to along x and y, in m.
    fn loaded(&self) -> Option<[[f64; 2]; 2]> {
        let columns = self.finer.columns + 1;
        let corners = self.steps.iter().enumerate().filter(|(_, step)| **step != [0.0; 3]);
        let places = corners.map(|(k, _)| {
            [self.finer.edge_x(k % columns), self.finer.edge_y(k / columns)].map(|at| [at, at])
        });
        places.reduce(|one, other| {
            std::array::from_fn(|c| [one[c][0].min(other[c][0]), one[c][1].max(other[c][1])])
        })
    }

    /// The largest of the local maxima below the surface.
    fn below(
        &self,
        measure: Measure,
        survey: &StressVolume,
        watch: Watch,
    ) -> Result<Option<PointStress>, Error> {
        let mut best: Option<(f64, PointStress)> = None;
        let largest = |best: &Option<(f64, PointStress)>| best.map_or(0.0, |(value, _)| value);
        for (value, start, ways) in local_maxima(measure, survey) {
            if value < PROMISING * largest(&best) {
                break;
            }
            let (value, point) = self.climb(measure, survey, (start, ways), watch)?;
            let shallowest = survey.layers.get(1).map_or(0.0, |layer| layer.depth);
            if point.depth >= shallowest && value > largest(&best) {
                best = Some((value, point));
            }
        }
        Ok(best.map(|(_, point)| point))
    }

    /// The nearest place of the surveyed box from which no step leads to a larger value, and the
    /// value. Steps (in m, each way) go to the six neighbours and to the top of the parabola
    /// through them along each axis; they are shortened where no neighbour is better.
    fn climb(
        &self,
        measure: Measure,
        survey: &StressVolume,
        (start, ways): ([f64; 3], [f64; 3]),
        watch: Watch,
    ) -> Result<(f64, PointStress), Error> {
        let grid = &survey.grid;
        let found = |[x, y, depth]: [f64; 3]| {
            let x = x.clamp(grid.x(0), grid.x(grid.columns - 1));
            let y = y.clamp(grid.y(0), grid.y(grid.rows - 1));
            let place = [x, y, depth.max(0.0)];
            // Without the digits that rounding leaves where a place is zero.
            let rounded = |axis: usize| {
                let unit = 0.01 * ACCURACY * ways[axis];
                (place[axis] / unit).round() * unit + 0.0
            };
            let point = self.point(std::array::from_fn(rounded));
            (measure.of(&point.stress), point)
        };
        let mut best = found(start);
        let mut part = 0.5;
        while part > ACCURACY {
            tell(watch, Progress::count(Stage::LargestStress, 0))?;
            let place = [best.1.x, best.1.y, best.1.depth];
            let ways = ways.map(|way| part * way);
            let moved = |axis: usize, by: f64| {
                let mut place = place;
                place[axis] += by;
                found(place)
            };
            let pairs = [0, 1, 2].map(|axis| [-1.0, 1.0].map(|to| moved(axis, to * ways[axis])));
            let top = found(std::array::from_fn(|axis| {
                place[axis] + ways[axis] * to_top(best.0, pairs[axis].map(|(value, _)| value))
            }));
            let neighbours = pairs.into_iter().flatten().max_by(|p, q| p.0.total_cmp(&q.0));
            match neighbours.filter(|next| next.0 > best.0.max(top.0)) {
                Some(next) => best = next,
                None => part *= SHORTER,
            }
            if top.0 > best.0 {
                best = top;
            }
        }
        Ok(best)
    }
}

/// From the middle of three values to the top of the parabola through them, in distances between
/// them and no further than one.
fn to_top(middle: f64, [before, after]: [f64; 2]) -> f64 {
    let bend = 2.0 * middle - before - after;
    if bend > 0.0 { (0.5 * (after - before) / bend).clamp(-1.0, 1.0) } else { 0.0 }
}

/// The largest value of a measure on the surface.
fn on_surface(measure: Measure, (grid, stresses): &(Grid, Vec<Stress>)) -> PointStress {
    let mut best = (f64::NEG_INFINITY, PointStress::default());
    for (k, stress) in stresses.iter().enumerate() {
        let value = measure.of(stress);
        if value > best.0 {
            let [x, y] = [grid.x(k % grid.columns), grid.y(k / grid.columns)];
            best = (value, PointStress { x, y, depth: 0.0, stress: *stress });
        }
    }
    best.1
}

/// Points below the first layer of a survey whose value no neighbour exceeds, the largest first:
/// value, place and distances to the neighbours along x, along y and down (in m).
fn local_maxima(measure: Measure, survey: &StressVolume) -> Vec<(f64, [f64; 3], [f64; 3])> {
    let StressVolume { grid, layers } = survey;
    let of_layer = |stresses: &[Stress]| stresses.iter().map(|s| measure.of(s)).collect();
    let values: Vec<Vec<f64>> = layers.iter().map(|layer| of_layer(&layer.stress)).collect();
    let [columns, rows] = [grid.columns, grid.rows];
    let mut maxima = Vec::new();
    for (k, layer) in layers.iter().enumerate().skip(1) {
        for at in 0..grid.len() {
            let [i, j] = [at % columns, at / columns];
            let value = values[k][at];
            let beside = [
                (i > 0).then(|| values[k][at - 1]),
                (i + 1 < columns).then(|| values[k][at + 1]),
                (j > 0).then(|| values[k][at - columns]),
                (j + 1 < rows).then(|| values[k][at + columns]),
                Some(values[k - 1][at]),
                values.get(k + 1).map(|below| below[at]),
            ];
            if value > 0.0 && beside.into_iter().flatten().all(|other| value >= other) {
                let ways = [grid.spacing_x, grid.spacing_y, (RATIO - 1.0) * layer.depth];
                maxima.push((value, [grid.x(i), grid.y(j), layer.depth], ways));
            }
        }
    }
    maxima.sort_unstable_by(|one, other| other.0.total_cmp(&one.0));
    maxima.truncate(MOST_STARTS);
    maxima
}
