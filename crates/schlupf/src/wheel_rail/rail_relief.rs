//! A rail as it is seen from above, where it or the wheel changes along the way.

use super::sections::SurfacePoint;
use super::seen::{Across, FLATTEST, Seen};
use super::surface::Surface;

/// Step along the track, in m.
pub(super) const STEP: f64 = 2e-3;

/// Largest x over the radius of the wheel, dimensionless.
const FARTHEST: f64 = 0.13;

/// Step along a profile, in m.
const ALONG: f64 = 2e-4;

/// A rail as it is seen from above at steps along the track: a single time if it does not change.
#[derive(Debug, Clone)]
pub(super) struct RailRelief {
    pub across: Across,
    /// The steps, in m.
    pub x: Vec<f64>,
    columns: Vec<Vec<Option<Seen>>>,
}

/// Equal steps along a profile, in m.
pub(super) fn along(surface: &Surface) -> Vec<f64> {
    let count = (surface.length() / ALONG).ceil() as usize + 1;
    (0..count).map(|k| k as f64 * surface.length() / (count - 1) as f64).collect()
}

impl RailRelief {
    /// Of a rail in the track under a wheel of a radius, in m.
    pub fn new(rail: &Surface, radius: f64) -> Self {
        let reach = (FARTHEST * radius / STEP).ceil() as i32;
        let x: Vec<f64> = (-reach..=reach).map(|k| f64::from(k) * STEP).collect();
        let arcs = along(rail);
        let changing: &[f64] = if rail.is_varying() { &x } else { &[0.0] };
        let sections: Vec<Vec<Option<SurfacePoint>>> =
            changing.iter().map(|x| arcs.iter().map(|arc| rail.at(*x, *arc)).collect()).collect();
        let y = || sections.iter().flatten().flatten().map(|point| point.point.place[0]);
        let ends = [y().fold(f64::INFINITY, f64::min), y().fold(f64::NEG_INFINITY, f64::max)];
        let across = Across::coarsely(ends);
        let column = |section: &Vec<Option<SurfacePoint>>| {
            let line = arcs.iter().zip(section).map(|(arc, point)| {
                let SurfacePoint { point, rate } = (*point)?;
                let [y, z] = point.place;
                let slope = point.tangent[1] / point.tangent[0].max(FLATTEST);
                let inclination = point.inclination();
                let rise = ((rate[1] - slope * rate[0]) * inclination.cos()).atan();
                Some(Seen { y, z, arc: *arc, extra: [inclination, rise] })
            });
            across.seen_from_above(line)
        };
        let columns = sections.iter().map(column).collect();
        Self { across, x, columns }
    }

    /// What is seen at one of the steps.
    pub fn column(&self, i: usize) -> &[Option<Seen>] {
        &self.columns[i.min(self.columns.len() - 1)]
    }
}
