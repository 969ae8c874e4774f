//! What a contact does to its wheel: forces in the track.

use super::contact_plane::ContactPlane;
use super::pair::Pair;
use super::pose::{Pose, cross, dot, minus, plus};
use super::pressed::Pressed;
use super::side::Side;
use super::sliding::Slid;
use crate::solution::{Resultant, Solution};

/// Force of a part of a contact, as seen from the left: on a curved surface each cell is one, in
/// the tangent plane where it is.
pub(super) struct Part {
    plane: ContactPlane,
    /// Along, across (outwards) and normal to the plane, in N.
    force: [f64; 3],
    /// About the normal of the plane, in N m.
    moment: f64,
}

impl Part {
    /// That of a whole contact with the resultant of its tractions and a normal force, in N.
    pub fn whole(plane: &ContactPlane, side: Side, tractions: &Resultant, normal: f64) -> Self {
        let sign = side.outwards();
        let force = [tractions.x, sign * tractions.y, normal];
        Self { plane: *plane, force, moment: sign * tractions.moment_z.unwrap_or(0.0) }
    }

    /// In the track, in N.
    pub fn force(&self) -> [f64; 3] {
        self.plane.resolved(self.force)
    }

    /// About the axle of a wheelset with a pose, in N m.
    pub fn torque(&self, pair: &Pair, pose: &Pose) -> f64 {
        let [along, across, normal] = self.force;
        // Pressure on a surface of revolution has no moment about its axis.
        let normal = if pair.wheel.is_varying() { normal } else { 0.0 };
        let force = self.plane.resolved([along, across, normal]);
        let axle = pose.turned([0.0, 1.0, 0.0]);
        let arm = minus(self.plane.origin, pose.centre);
        dot(cross(arm, force), axle) + self.moment * dot(self.plane.normal(), axle)
    }
}

/// The parts of a contact.
pub(super) fn parts(pair: &Pair, side: Side, (pressed, _, solution): &Slid) -> Vec<Part> {
    let Pressed { plane, force, .. } = pressed;
    let Solution { fields, normal, .. } = solution;
    if !plane.is_curved || fields.is_empty() {
        return vec![Part::whole(plane, side, &solution.force, *force)];
    }
    let (sign, area) = (side.outwards(), fields.grid.cell_area());
    let [x, y] = normal.origin.unwrap_or_default();
    let part = |k: usize| {
        let at = plane.at(pair, [fields.x[k] + x, sign * (fields.y[k] + y)]);
        let cell = [fields.traction_x[k], sign * fields.traction_y[k], fields.pressure[k]];
        Part { plane: at, force: cell.map(|stress| area * stress), moment: 0.0 }
    };
    (0..fields.x.len()).map(part).collect()
}

/// Force of a contact along, across and normal to its plane, in N.
pub(super) fn in_plane(pair: &Pair, side: Side, slid: &Slid) -> [f64; 3] {
    let parts = parts(pair, side, slid);
    let force = parts.iter().map(Part::force).fold([0.0; 3], plus);
    let plane = &slid.0.plane;
    [plane.along(), plane.across(), plane.normal()].map(|axis| dot(axis, force))
}
