//! Undeformed distance of wheel and rail above a contact plane.
//!
//! Along the normal n of the plane, at (x, s): the height of the wheel's surface of revolution
//! minus that of the rail's prism, negative where they overlap. The rail's height follows from its
//! profile by Newton's method, the wheel's from two equations with the height n and the arc length
//! along the wheel's profile as unknowns,
//!
//! Q = Rᵀ(P − o),  Q_y = y₀ + y(s_w),  √(Q_x² + Q_z²) = R0 − z(s_w),
//!
//! so neither the slope of the flange nor the yaw angle is approximated. A roller's height follows
//! from the same equations with R0 + z. Where a profile changes along the way u, y and z are those
//! at the u of Q, which is Q_x along a rail and atan(−Q_x/Q_z) around a wheel.

use super::contact_plane::ContactPlane;
use super::pair::Pair;
use super::pose::{Pose, minus};
use super::profile_curve::CurvePoint;
use super::sections::SurfacePoint;
use super::surface::Surface;

/// Accuracy of a height, in m.
const ACCURACY: f64 = 1e-13;

/// Most steps of Newton's method.
const MOST_STEPS: usize = 40;

/// Longest step, in m.
const LONGEST_STEP: f64 = 3e-3;

/// Distance that stands for places that are beyond the end of a profile, in m.
pub(super) const CLEAR: f64 = 1e-2;

/// Wheel and rail above a plane.
pub(super) struct PlaneView<'a> {
    pair: &'a Pair,
    pose: Pose,
    plane: &'a ContactPlane,
    wheel: Swept<'a>,
    /// A roller, or a rail that changes along the track.
    rail: Option<Swept<'a>>,
}

/// A surface above a plane that its profile sweeps.
struct Swept<'a> {
    surface: &'a Surface,
    /// Position of the origin of the profile along the axle, in m.
    offset: f64,
    /// Nominal radius, in m; `None` along the track.
    radius: Option<f64>,
    /// Whether the radius or the height grows (1) or falls (−1) with the z of the profile.
    sign: f64,
    /// Origin of the plane in the axes of the body, in m.
    origin: [f64; 3],
    /// The plane's directions x, s and n there.
    axes: [[f64; 3]; 3],
}

/// Heights above a plane.
pub(super) struct Heights {
    /// Distance in rows along x, in m; [`CLEAR`] where a profile ends.
    pub distance: Vec<f64>,
    /// Which of them are beyond the end of a profile.
    pub is_beyond: Vec<bool>,
}

/// A point of the rail above a plane.
pub(super) struct RailPoint {
    /// Its arc length, in m.
    pub arc: f64,
    /// Its position in the plane, in m.
    pub s: f64,
    /// Its height, in m.
    pub n: f64,
    /// The slope of the height, dimensionless.
    pub slope: f64,
}

/// A solution on a surface: height in m, arc length in m.
type OnSurface = [f64; 2];

/// Why there is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Off {
    /// The profile ends, or turns away from the plane.
    End,
    /// The part of the profile is missing here along the way.
    Missing,
}

impl<'a> PlaneView<'a> {
    /// Of a wheel with a pose in the track.
    pub fn new(pair: &'a Pair, pose: &Pose, plane: &'a ContactPlane) -> Self {
        let axes = [plane.along(), plane.across(), plane.normal()];
        let wheel = Swept {
            surface: &pair.wheel,
            offset: pair.wheel_offset,
            radius: Some(pair.nominal_radius),
            sign: -1.0,
            origin: pose.in_body(minus(plane.origin, pose.centre)),
            axes: axes.map(|axis| pose.in_body(axis)),
        };
        let rail = (pair.roller.is_some() || pair.rail.is_varying()).then(|| Swept {
            surface: &pair.rail,
            offset: 0.0,
            radius: pair.roller,
            sign: 1.0,
            origin: minus(plane.origin, [0.0, 0.0, -pair.roller.unwrap_or(0.0)]),
            axes,
        });
        Self { pair, pose: *pose, plane, wheel, rail }
    }

    /// Distances at the positions `x` × `s` (in m, relative to the plane's origin), rows along x.
    pub fn heights(&self, x: &[f64], s: &[f64]) -> Heights {
        if self.plane.is_curved {
            return self.heights_along_normals(x, s);
        }
        let [rail_arc, wheel_arc] = self.plane.arcs;
        let wheel = self.wheel.heights(x, s, wheel_arc);
        let rail = if let Some(rail) = &self.rail {
            rail.heights(x, s, rail_arc)
        } else {
            let rows = self.rail_heights(s);
            let rows = rows.into_iter().map(|height| height.ok_or(Off::End));
            rows.flat_map(|height| x.iter().map(move |_| height)).collect()
        };
        let both = || wheel.iter().zip(&rail);
        let is_end = |one: &Result<f64, Off>, other: &Result<f64, Off>| {
            *one == Err(Off::End) && *other != Err(Off::Missing)
        };
        let distance = |(wheel, rail): (&Result<f64, Off>, &Result<f64, Off>)| match (wheel, rail) {
            (Ok(wheel), Ok(rail)) => wheel - rail,
            _ => CLEAR,
        };
        Heights {
            is_beyond: both().map(|(one, two)| is_end(one, two) || is_end(two, one)).collect(),
            distance: both().map(distance).collect(),
        }
    }

    /// The same normal to the rail's profile at every s, an arc length.
    fn heights_along_normals(&self, x: &[f64], s: &[f64]) -> Heights {
        let (mut distance, mut is_beyond) = (Vec::new(), Vec::new());
        for s in s {
            let arcs = self.plane.arcs.map(|arc| arc + s);
            let [along, ..] = self.plane.origin;
            let is_inside = (0.0..=self.pair.rail.length()).contains(&arcs[0]);
            let point = self.pair.rail.point(along, arcs[0]).filter(|_| is_inside);
            let Some(point) = point else {
                distance.resize(distance.len() + x.len(), CLEAR);
                is_beyond.resize(is_beyond.len() + x.len(), true);
                continue;
            };
            let [y, z] = point.place;
            let origin = [along, y, self.pair.rail_height(along, z)];
            let inclination = point.inclination();
            let plane = ContactPlane { origin, inclination, arcs, is_curved: false, ..*self.plane };
            let row = PlaneView::new(self.pair, &self.pose, &plane).heights(x, &[0.0]);
            distance.extend(row.distance);
            is_beyond.extend(row.is_beyond);
        }
        Heights { distance, is_beyond }
    }

    /// Heights of a straight rail at all s, in m, outwards from the origin of the plane.
    fn rail_heights(&self, s: &[f64]) -> Vec<Option<f64>> {
        let mut heights = vec![None; s.len()];
        for rows in outwards(s) {
            let mut rail = Some((0.0, self.plane.arcs[0]));
            for j in rows {
                rail = self.on_rail(s[j], rail);
                heights[j] = rail.and_then(|(_, arc)| self.rail_height(arc));
            }
        }
        heights
    }

    /// The arc length of the rail at s (in m), from that at another s.
    fn on_rail(&self, s: f64, from: Option<(f64, f64)>) -> Option<(f64, f64)> {
        let (before, arc) = from?;
        let [_, along_y, along_z] = self.plane.across();
        let [x, y, z] = self.plane.origin;
        let end = self.pair.rail.length();
        let mut arc = (arc + s - before).clamp(0.0, end);
        for _ in 0..MOST_STEPS {
            let point = self.pair.rail.point(x, arc)?;
            let slope = along_y * point.tangent[0] + along_z * point.tangent[1];
            if slope <= 0.0 {
                return None;
            }
            let off = along_y * (point.place[0] - y) + along_z * (point.place[1] - z) - s;
            let step = (off / slope).clamp(-LONGEST_STEP, LONGEST_STEP);
            let next = arc - step;
            if step.abs() < ACCURACY {
                return (0.0..=end).contains(&next).then_some((s, next));
            }
            arc = next.clamp(0.0, end);
        }
        None
    }

    /// The section of the rail at the origin at s, from a guess of its arc length; both in m.
    pub fn rail_point(&self, s: f64, guess: f64) -> Option<RailPoint> {
        let arc = if self.plane.is_curved {
            let arc = self.plane.arcs[0] + s;
            (0.0..=self.pair.rail.length()).contains(&arc).then_some(arc)?
        } else {
            self.on_rail(s, Some((s, guess)))?.1
        };
        let point = self.pair.rail.point(self.plane.origin[0], arc)?;
        let CurvePoint { place: [y, z], tangent, .. } = point;
        let ([_, s_y, s_z], [_, n_y, n_z]) = (self.plane.across(), self.plane.upright());
        let along = s_y * tangent[0] + s_z * tangent[1];
        let up = n_y * tangent[0] + n_z * tangent[1];
        let s = s_y * (y - self.plane.origin[1]) + s_z * (z - self.plane.origin[2]);
        Some(RailPoint { arc, s, n: self.rail_height(arc)?, slope: up / along })
    }

    fn rail_height(&self, arc: f64) -> Option<f64> {
        let [_, normal_y, normal_z] = self.plane.upright();
        let [y, z] = self.pair.rail.point(self.plane.origin[0], arc)?.place;
        Some(normal_y * (y - self.plane.origin[1]) + normal_z * (z - self.plane.origin[2]))
    }
}

impl Swept<'_> {
    /// Heights at the positions `x` × `s` (in m), rows along x, outwards from the origin of the
    /// plane, where the arc length is near `arc`; in m.
    fn heights(&self, x: &[f64], s: &[f64], arc: f64) -> Vec<Result<f64, Off>> {
        let mut heights = vec![Err(Off::End); x.len() * s.len()];
        let middle = nearest_to_zero(x);
        for rows in outwards(s) {
            let mut along = Ok((0.0, [0.0, arc]));
            for j in rows {
                let found = |from: Result<(f64, OnSurface), Off>, at: f64| {
                    let (before, [n, arc]) = from?;
                    self.at([at, s[j]], [n, arc + s[j] - before]).map(|surface| (s[j], surface))
                };
                along = found(along, x[middle]);
                for columns in outwards(x) {
                    let mut beside = along;
                    for i in columns {
                        beside = found(beside, x[i]);
                        heights[j * x.len() + i] = beside.map(|(_, [n, _])| n);
                    }
                }
            }
        }
        heights
    }

    /// Height and arc length at (x, s), from a guess; all in m.
    fn at(&self, [x, s]: [f64; 2], guess: OnSurface) -> Result<OnSurface, Off> {
        let [along, across, normal] = self.axes;
        let base = [0, 1, 2].map(|k| self.origin[k] + x * along[k] + s * across[k]);
        let end = self.surface.length();
        // No more digits than a large radius leaves.
        let size = self.radius.unwrap_or(0.0);
        let accuracy = ACCURACY.max(8.0 * f64::EPSILON * size);
        let [mut n, mut arc] = [guess[0], guess[1].clamp(0.0, end)];
        for _ in 0..MOST_STEPS {
            let [q_x, q_y, q_z] = [0, 1, 2].map(|k| base[k] + n * normal[k]);
            let (height, height_by) = if self.radius.is_some() {
                let radius = q_x.hypot(q_z);
                (radius, (q_x * normal[0] + q_z * normal[2]) / radius)
            } else {
                (q_z, normal[2])
            };
            let mut by_height = [normal[1], height_by];
            let point = if let Some(profile) = self.surface.uniform() {
                profile.at(arc)
            } else {
                let (way, way_by) = if self.radius.is_some() {
                    let by = (q_x * normal[2] - q_z * normal[0]) / (height * height);
                    (q_x.atan2(-q_z), by)
                } else {
                    (q_x, normal[0])
                };
                let found = self.surface.at(way, arc).ok_or(Off::Missing)?;
                let SurfacePoint { point, rate } = found;
                by_height[0] -= rate[0] * way_by;
                by_height[1] -= self.sign * rate[1] * way_by;
                point
            };
            let off =
                [q_y - self.offset - point.place[0], height - size - self.sign * point.place[1]];
            let by_arc = [-point.tangent[0], -self.sign * point.tangent[1]];
            let determinant = by_height[0] * by_arc[1] - by_arc[0] * by_height[1];
            let step = [
                (off[0] * by_arc[1] - by_arc[0] * off[1]) / determinant,
                (by_height[0] * off[1] - off[0] * by_height[1]) / determinant,
            ];
            let [up, on] = step.map(|step| step.clamp(-LONGEST_STEP, LONGEST_STEP));
            n -= up;
            let next = arc - on;
            if up.abs().max(on.abs()) < accuracy {
                return if (0.0..=end).contains(&next) { Ok([n, next]) } else { Err(Off::End) };
            }
            arc = next.clamp(0.0, end);
            if !n.is_finite() {
                break;
            }
        }
        Err(Off::End)
    }
}

/// Indices from the position nearest to zero up, and from that before it down.
fn outwards(positions: &[f64]) -> [Vec<usize>; 2] {
    let middle = nearest_to_zero(positions);
    [(middle..positions.len()).collect(), (0..middle).rev().collect()]
}

/// Index of the position nearest to zero.
fn nearest_to_zero(positions: &[f64]) -> usize {
    let near =
        (0..positions.len()).min_by(|j, k| positions[*j].abs().total_cmp(&positions[*k].abs()));
    near.unwrap_or(0)
}
