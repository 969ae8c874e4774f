//! Where a stress is largest.

use super::{Stress, StressVolume, SubsurfaceStress};

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
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// Part of the distance between points to which a place is found.
const ACCURACY: f64 = 1e-3;

impl SubsurfaceStress {
    /// The stress at (x, y) and at a depth (all in m), with its place.
    pub fn point(&self, [x, y, depth]: [f64; 3]) -> PointStress {
        PointStress { x, y, depth, stress: self.at([x, y], depth) }
    }

    /// Where a measure is largest within a volume: from its largest points on and below the surface
    /// on to places in between, with steps that are halved where none of them leads further. `None`
    /// for an empty volume.
    pub fn largest(&self, measure: Measure, volume: &StressVolume) -> Option<PointStress> {
        let starts = [0..1, 1..volume.layers.len()].map(|layers| {
            let layers = volume.layers.get(layers)?;
            let points = layers.iter().flat_map(|layer| {
                let values = layer.stress.iter().enumerate();
                values.map(|(k, stress)| (measure.of(stress), layer.depth, k))
            });
            let (_, depth, k) = points.max_by(|p, q| p.0.total_cmp(&q.0))?;
            let grid = &volume.grid;
            Some([grid.x(k % grid.columns), grid.y(k / grid.columns), depth])
        });
        let climbed = starts.into_iter().flatten().map(|start| self.climb(measure, volume, start));
        climbed.max_by(|p, q| p.0.total_cmp(&q.0)).map(|(_, point)| point)
    }

    /// The nearest place from which no step leads to a larger value, and the value.
    fn climb(
        &self,
        measure: Measure,
        volume: &StressVolume,
        start: [f64; 3],
    ) -> (f64, PointStress) {
        let depths = || volume.layers.iter().map(|layer| layer.depth);
        let deepest = depths().fold(0.0, f64::max);
        let apart = depths().map(|other| (other - start[2]).abs()).filter(|apart| *apart > 0.0);
        let apart = apart.fold(f64::INFINITY, f64::min);
        let down = if apart.is_finite() { apart } else { 0.0 };
        let found = |place: [f64; 3]| {
            let point = self.point(place);
            (measure.of(&point.stress), point)
        };
        let mut best = found(start);
        let mut step = 0.5;
        while step > ACCURACY {
            let ways = [volume.grid.spacing_x, volume.grid.spacing_y, down].map(|way| step * way);
            let further = (0..6).map(|k| {
                let mut place = [best.1.x, best.1.y, best.1.depth];
                place[k / 2] += if k % 2 == 0 { ways[k / 2] } else { -ways[k / 2] };
                place[2] = place[2].clamp(0.0, deepest);
                found(place)
            });
            match further.max_by(|p, q| p.0.total_cmp(&q.0)) {
                Some(next) if next.0 > best.0 => best = next,
                _ => step *= 0.5,
            }
        }
        best
    }
}
