//! Motion of the rows of a curved contact, from the rigid motion at the surface of every row.
//!
//! Where the bodies touch, both deform; with like materials the interface is half-way between the
//! undeformed surfaces. A particle of the wheel that is pushed in by w moves with u_x = −w x/R, as
//! its normal turns, so that at x = 0 it slips like a point at the distance r − w from the axle: as
//! the interface. (CONTACT takes the undeformed wheel; the difference is of the order of half the
//! overlap over the radius.) In the plane of the contact the interface is n(s) = (n_r + n_w)/2 of
//! the rail's profile and of the wheel's outline, which is what is seen of the wheel along the
//! track: the points of its surface whose normal has no component along the track. Bodies that
//! change along the way count as the prism and the body of revolution that their sections at the
//! origin make.
//!
//! The creepages of the plane are those of the material point Q of the wheel at its origin
//! ([`super::creepage`]). A row at s slips as the point Q + s s₀ + (n(s) − n(0)) n₀, in the tangent
//! of the interface there, and spins about its normal there:
//!
//! ξ(s) = vₓ/V,  η(s) = v·s(s)/V,  φ(s) = ω·n(s)/V.

use super::contact_plane::ContactPlane;
use super::creepage::Moving;
use super::distance::{PlaneView, RailPoint};
use super::pair::Pair;
use super::pose::{Pose, dot, minus};
use crate::bodies::{Kinematics, RowMotion, RowSlip};
use crate::reporting::Error;

/// With what the rows of a contact move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RowsMove {
    /// With the plane of the contact where the rail turns by up to 0.2 rad over it, with the
    /// surface from 0.3 rad on, and in between with a mean of both that changes smoothly, so that
    /// forces do not jump with the position.
    #[default]
    Automatic,
    /// With the surface of every row.
    WithSurface,
    /// With the plane of the contact, as in the planar contacts of CONTACT.
    WithPlane,
}

/// Turn of the surface over a contact beyond which a plane is a coarse picture of it, in rad.
pub(super) const CONFORMAL: f64 = 0.3;

/// The same from which on rows begin to follow the surface, in rad. A choice: the way to the other
/// bound only has to be long enough for forces that do not jump, and contacts that count as plane
/// are those that are compared with planar ones.
const CURVED: f64 = 0.2;

impl RowsMove {
    /// Share (dimensionless) of the motion of the surface where that turns by an angle, in rad.
    pub(super) fn share(self, turn: f64) -> f64 {
        match self {
            Self::WithPlane => 0.0,
            Self::WithSurface => 1.0,
            Self::Automatic => {
                let place = ((turn - CURVED) / (CONFORMAL - CURVED)).clamp(0.0, 1.0);
                place * place * (3.0 - 2.0 * place)
            }
        }
    }
}

/// Accuracy of a position on the outline, in m.
const ACCURACY: f64 = 1e-13;

/// Most steps of Newton's method, and the longest in m.
const MOST_STEPS: usize = 40;
const LONGEST_STEP: f64 = 3e-3;

/// Height above the plane and slope in it of a curve at s.
#[derive(Debug, Clone, Copy)]
struct Height {
    /// Position in the plane, in m.
    s: f64,
    /// In m.
    n: f64,
    /// dn/ds, dimensionless.
    slope: f64,
}

/// A wheel and a rail above the plane of a contact.
pub(super) struct Passing<'a> {
    pub pair: &'a Pair,
    /// That of the wheel.
    pub pose: &'a Pose,
    pub plane: &'a ContactPlane,
}

/// A point of the wheel's outline as seen along the track.
struct OutlinePoint {
    /// s and n above the plane, in m.
    place: [f64; 2],
    /// Their derivatives with respect to the arc length of the profile, dimensionless.
    tangent: [f64; 2],
}

impl Passing<'_> {
    /// The motion of rows at ascending s (in m) beyond that of the plane, `motion`; `None` where a
    /// profile ends or is nowhere seen from the plane.
    pub fn rows(
        &self,
        s: &[f64],
        moving: &Moving,
        motion: &Kinematics,
    ) -> Result<Option<RowMotion>, Error> {
        if s.len() < 2 {
            return Ok(None);
        }
        let Some(origin) = self.heights(&[0.0]).and_then(|heights| heights.first().copied()) else {
            return Ok(None);
        };
        let Some(heights) = self.heights(s) else { return Ok(None) };
        let row = |(s, height): (&f64, &Height)| {
            self.row((*s, &Height { n: height.n - origin.n, ..*height }), moving, motion)
        };
        let rows = s.iter().zip(&heights).map(row).collect();
        RowMotion::new(s.to_vec(), rows).map(Some)
    }

    fn row(&self, (s, height): (f64, &Height), moving: &Moving, motion: &Kinematics) -> RowSlip {
        let (across, normal) = (self.plane.across(), self.plane.upright());
        let away = [0, 1, 2].map(|k| height.s * across[k] + height.n * normal[k]);
        let velocity = moving.velocity(away);
        let cos = height.slope.hypot(1.0).recip();
        let sin = height.slope * cos;
        let along = [0, 1, 2].map(|k| cos * across[k] + sin * normal[k]);
        let upright = [0, 1, 2].map(|k| cos * normal[k] - sin * across[k]);
        let over = motion.speed.recip();
        RowSlip {
            creepage_x: velocity[0] * over / self.plane.along()[0]
                - (motion.creepage_x - motion.spin * s),
            creepage_y: dot(velocity, along) * over - motion.creepage_y,
            spin: dot(moving.turning, upright) * over - motion.spin,
        }
    }

    /// Of the interface at all s (in m).
    fn heights(&self, s: &[f64]) -> Option<Vec<Height>> {
        let view = PlaneView::new(self.pair, self.pose, self.plane);
        let near = |at: f64| [self.plane.arcs[0] + at, self.plane.arcs[1] + at];
        let mut from = None;
        let mut heights = Vec::with_capacity(s.len());
        for at in s {
            let [rail, wheel] = from.map_or_else(
                || near(*at),
                |(before, arcs): (f64, [f64; 2])| arcs.map(|arc| arc + at - before),
            );
            let RailPoint { arc, s, n, slope } = view.rail_point(*at, rail)?;
            let (wheel, outline) = self.outline_at(s, wheel)?;
            let [along, up] = outline.tangent;
            heights.push(Height {
                s,
                n: 0.5 * (n + outline.place[1]),
                slope: 0.5 * (slope + up / along),
            });
            from = Some((*at, [arc, wheel]));
        }
        Some(heights)
    }

    /// The outline at s, and its arc length, from a guess; all in m.
    fn outline_at(&self, s: f64, guess: f64) -> Option<(f64, OutlinePoint)> {
        let end = self.pair.wheel.length();
        let mut arc = guess.clamp(0.0, end);
        for _ in 0..MOST_STEPS {
            let point = self.outline(arc)?;
            if point.tangent[0] <= 0.0 {
                return None;
            }
            let step = (point.place[0] - s) / point.tangent[0];
            let next = arc - step.clamp(-LONGEST_STEP, LONGEST_STEP);
            if step.abs() < ACCURACY {
                return (0.0..=end).contains(&next).then_some((arc, point));
            }
            arc = next.clamp(0.0, end);
        }
        None
    }

    /// The point of the outline at an arc length of the wheel's profile, in m.
    fn outline(&self, arc: f64) -> Option<OutlinePoint> {
        let at = self.pose.in_body(minus(self.plane.origin, self.pose.centre));
        let point = self.pair.wheel.point(at[0].atan2(-at[2]), arc)?;
        let ([y, z], [ty, tz], [by, bz]) = (point.place, point.tangent, point.bend);
        let radius = self.pair.nominal_radius - z;
        let silhouette = self.pose.silhouette(tz / ty)?;
        let [sin, cos] = silhouette.sin_cos;
        let turn = (bz * ty - tz * by) / (ty * ty) * silhouette.by_slope;
        let place = [radius * sin, y + self.pair.wheel_offset, -radius * cos];
        let tangent = [-tz * sin + radius * cos * turn, ty, tz * cos + radius * sin * turn];
        let place = minus(self.pose.in_track(place), self.plane.origin);
        let tangent = self.pose.turned(tangent);
        let (across, normal) = (self.plane.across(), self.plane.upright());
        Some(OutlinePoint {
            place: [dot(place, across), dot(place, normal)],
            tangent: [dot(tangent, across), dot(tangent, normal)],
        })
    }
}
