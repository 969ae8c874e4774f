//! Planes in which contacts are solved, or of whose surface they have the direction.
//!
//! The origin of a plane is on the rail, at the means of x and y of a region of overlap; its
//! inclination is the mean of the rail's, all weighted with the overlap to the power of 2.5. The
//! least gap would be off by millimetres where both bodies conform. Neighbouring regions that are
//! close and similarly inclined share a plane.

use super::overlap::Region;
use super::pair::Pair;

/// When neighbouring regions share one plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joining {
    /// Largest distance, in m.
    pub distance: f64,
    /// Largest difference of their inclinations, in rad.
    pub angle: f64,
}

impl Default for Joining {
    /// 8 mm and 20°.
    fn default() -> Self {
        Self { distance: 8e-3, angle: 20_f64.to_radians() }
    }
}

/// A plane that touches the rail. Its directions: along the track, rising with the rail; s,
/// outwards along the surface; n, out of the rail. On a curved surface s is the arc length along
/// the rail's profile, the distance is normal to the profile at every s, and the plane has the
/// direction of the force.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContactPlane {
    /// In the track, in m.
    pub origin: [f64; 3],
    /// Of s, positive where it rises outwards; in rad.
    pub inclination: f64,
    /// Angle by which it rises forwards, in rad.
    pub rise: f64,
    /// Arc lengths of both profiles near the origin, of the rail and of the wheel, in m.
    pub arcs: [f64; 2],
    /// First guess of the overlap, relative to the origin along x and s, in m.
    pub guess: [[f64; 2]; 2],
    /// Bounds along x and s, beyond which a neighbouring contact has its own plane; in m.
    pub limits: [[f64; 2]; 2],
    /// Whether the contact is on the curved surface of the rail.
    pub is_curved: bool,
}

impl ContactPlane {
    /// s as a direction in the track, dimensionless.
    pub fn across(&self) -> [f64; 3] {
        let (sin, cos) = self.inclination.sin_cos();
        [0.0, cos, sin]
    }

    /// The direction along the track, rising with the rail, dimensionless.
    pub fn along(&self) -> [f64; 3] {
        let (sin, cos) = self.rise.sin_cos();
        let [_, y, z] = self.upright();
        [cos, sin * y, sin * z]
    }

    /// n as a direction in the track, dimensionless.
    pub fn normal(&self) -> [f64; 3] {
        let (sin, cos) = self.rise.sin_cos();
        let [_, y, z] = self.upright();
        [-sin, cos * y, cos * z]
    }

    /// The normal of the rail's profile, dimensionless.
    pub fn upright(&self) -> [f64; 3] {
        let (sin, cos) = self.inclination.sin_cos();
        [0.0, -sin, cos]
    }

    /// A vector in the track with components along, across and normal to the plane, in the unit of
    /// those.
    pub fn resolved(&self, [along, across, normal]: [f64; 3]) -> [f64; 3] {
        let [x, s, n] = [self.along(), self.across(), self.normal()];
        [0, 1, 2].map(|k| along * x[k] + across * s[k] + normal * n[k])
    }

    /// The tangent plane at x and s (in m) of a contact on the curved surface.
    pub fn at(&self, pair: &Pair, [x, s]: [f64; 2]) -> Self {
        let [along, ..] = self.origin;
        let point = pair.rail.point(along, self.arcs[0] + s);
        let Some(point) = point else { return *self };
        let [y, z] = point.place;
        Self { origin: [along + x, y, z], inclination: point.inclination(), ..*self }
    }

    /// Position along s of a point of the rail, y and z in m.
    fn position(&self, pair: &Pair, [y, z]: [f64; 2]) -> f64 {
        let [_, s_y, s_z] = self.across();
        let along = s_y * (y - self.origin[1]) + s_z * (z - self.origin[2]);
        if !self.is_curved {
            return along;
        }
        pair.rail_arc([self.origin[0], y], self.arcs[0] + along) - self.arcs[0]
    }

    /// The inclination of the surface at s (in m) relative to the plane, in rad.
    pub fn turn(&self, pair: &Pair, s: f64) -> f64 {
        let point = pair.rail.point(self.origin[0], self.arcs[0] + s);
        point.map_or(0.0, |point| point.inclination() - self.inclination)
    }
}

/// The planes of regions that are sorted by y, those of contacts on the curved surface or not.
pub(super) fn planes(
    pair: &Pair,
    regions: &[Region],
    (joining, is_curved): (&Joining, bool),
) -> Vec<ContactPlane> {
    let mut joined: Vec<Region> = Vec::new();
    for region in regions {
        match joined.iter_mut().rev().find(|other| belongs(other, region, joining)) {
            Some(other) => *other = union(other, region),
            None => joined.push(*region),
        }
    }
    let mut planes: Vec<ContactPlane> =
        joined.iter().map(|region| plane(pair, region, is_curved)).collect();
    for k in 0..joined.len() {
        for j in 0..k {
            let (one, two) = (&joined[j], &joined[k]);
            let [end, start] = [one.ends[1], two.ends[0]];
            if end[0] <= start[0] || ahead(one, two) <= 0.0 {
                let middle = [0.5 * (end[0] + start[0]), 0.5 * (end[1] + start[1])];
                let [low, high] =
                    [planes[k].position(pair, middle), planes[j].position(pair, middle)];
                planes[k].limits[1][0] = planes[k].limits[1][0].max(low);
                planes[j].limits[1][1] = planes[j].limits[1][1].min(high);
            } else {
                let is_behind = one.along[1] <= two.along[0];
                let [back, front] = if is_behind { [j, k] } else { [k, j] };
                let middle = 0.5 * (joined[back].along[1] + joined[front].along[0]);
                let at = |plane: &ContactPlane| middle - plane.origin[0];
                let [low, high] = [at(&planes[front]), at(&planes[back])];
                planes[front].limits[0][0] = planes[front].limits[0][0].max(low);
                planes[back].limits[0][1] = planes[back].limits[0][1].min(high);
            }
        }
    }
    planes
}

/// How far one region is before or behind another one, in m.
fn ahead(one: &Region, two: &Region) -> f64 {
    (two.along[0] - one.along[1]).max(one.along[0] - two.along[1]).max(0.0)
}

fn belongs(one: &Region, two: &Region, joining: &Joining) -> bool {
    let [end, start] = [one.ends[1], two.ends[0]];
    let beside = if end[0] > start[0] { 0.0 } else { (start[0] - end[0]).hypot(start[1] - end[1]) };
    let turn = (two.inclination - one.inclination).abs().max((two.rise - one.rise).abs());
    beside.hypot(ahead(one, two)) <= joining.distance && turn <= joining.angle
}

fn union(one: &Region, two: &Region) -> Region {
    let weight = one.weight + two.weight;
    let mean =
        |one_value: f64, two_value: f64| (one.weight * one_value + two.weight * two_value) / weight;
    let heavier = if one.weight >= two.weight { one } else { two };
    let outmost = if one.ends[1][0] > two.ends[1][0] { one } else { two };
    Region {
        weight,
        x: mean(one.x, two.x),
        y: mean(one.y, two.y),
        inclination: mean(one.inclination, two.inclination),
        rise: mean(one.rise, two.rise),
        ends: [one.ends[0], outmost.ends[1]],
        along: [one.along[0].min(two.along[0]), one.along[1].max(two.along[1])],
        nearest: heavier.nearest,
    }
}

fn plane(pair: &Pair, region: &Region, is_curved: bool) -> ContactPlane {
    let near = region.nearest;
    let arc = pair.rail_arc([region.x, region.y], near.rail[1]);
    let z = pair.rail.point(region.x, arc).map_or(near.rail[0], |point| point.place[1]);
    let mut plane = ContactPlane {
        origin: [region.x, region.y, pair.rail_height(region.x, z)],
        inclination: region.inclination,
        rise: region.rise,
        arcs: [arc, near.wheel[1] + arc - near.rail[1]],
        guess: [region.along.map(|x| x - region.x), [0.0; 2]],
        limits: [[f64::NEG_INFINITY, f64::INFINITY]; 2],
        is_curved,
    };
    plane.guess[1] = region.ends.map(|end| plane.position(pair, end));
    plane
}
