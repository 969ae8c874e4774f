//! Contacts of a wheel from a table.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::numerics::dual::Number;
use crate::reporting::{Error, WheelRailError};
use crate::wheel_rail::contact_plane::Joining;
use crate::wheel_rail::pair::Pair;
use crate::wheel_rail::pose::Attitude;

use super::ellipse::{Ellipses, Pressed};
use super::grid::{AXES, Axis, Grid, VALUES, YAWS};
use super::outlines::Outlines;
use super::overlaps::{MOST, Overlap, Overlaps};
use super::placement::{OfPose, POSE, Placement, ROLL, YAW};

/// ∫ (1 − t²)^1.5 dt from −1 to 1, and what that to the power of 2.5 is of it, dimensionless.
const SHAPE: f64 = 3.0 * PI / 8.0;
const DEPTH: f64 = 5.0 / 6.0;

/// Passes in which contacts raise each other's surfaces.
const PASSES: usize = 4;

/// The contacts of a wheel on a rail, interpolated. Everything is as seen from the left.
#[derive(Debug, Clone)]
pub struct ContactTable {
    pub(super) pair: Arc<Pair>,
    pub(super) outlines: Outlines,
    pub(super) ellipses: Ellipses,
    pub(super) grid: Grid,
    /// E*, in Pa.
    pub(super) contact_modulus: f64,
    pub(super) joining: Joining,
}

/// A contact of a wheel, with derivatives with respect to the pose.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TabulatedContact {
    /// Origin of its plane in the track, in m.
    pub position: [OfPose; 3],
    /// Inclination of the plane, positive where it rises outwards, in rad.
    pub inclination: OfPose,
    /// Position along the axle in the wheel's profile, in m.
    pub wheel_position: OfPose,
    /// Radius of the wheel there, in m.
    pub rolling_radius: OfPose,
    /// Normal force, in N.
    pub load: OfPose,
    /// Approach of the bodies, in m.
    pub approach: OfPose,
    /// Of the ellipse with the same second moments of the pressure, in m.
    pub semi_axes: [OfPose; 2],
    /// Centre of pressure relative to the origin, along x and s, in m.
    pub centre: [OfPose; 2],
}

/// What an overlap says about its contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seat {
    position: [OfPose; 3],
    inclination: OfPose,
    /// Arc length along the profile of the wheel, in m.
    pub arc: OfPose,
    /// Position along the axle and radius of the wheel, in m.
    on_wheel: [OfPose; 2],
    /// Depth of the parabola with the same integrals, vertically, in m.
    pub depth: OfPose,
    /// The same along the normal, in m.
    approach: OfPose,
    /// Hertz's contact.
    pub pressed: Pressed<OfPose>,
}

/// The contacts of a wheel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found {
    count: usize,
    contacts: [Option<TabulatedContact>; MOST],
    is_covered: bool,
}

impl Found {
    /// Whether the table covers all of them.
    pub fn is_covered(&self) -> bool {
        self.is_covered
    }

    /// By their place, from the field side to the flange.
    pub fn by_place(&self) -> impl Iterator<Item = &TabulatedContact> {
        self.contacts[..self.count].iter().rev().flatten()
    }
}

impl Seat {
    /// Origin of the plane in the track, in m.
    pub fn position(&self) -> [f64; 3] {
        self.position.map(|part| part.value)
    }
}

impl ContactTable {
    /// Without values, over axes.
    pub(super) fn over(
        pair: &Arc<Pair>,
        (contact_modulus, joining): (f64, Joining),
        mut axes: [Axis; AXES],
    ) -> Result<Self, Error> {
        let is_uniform = pair.wheel.uniform().is_some() && pair.rail.uniform().is_some();
        if !is_uniform || pair.roller.is_some() {
            return Err(WheelRailError::NoContactTable {}.into());
        }
        axes[YAWS].is_mirrored = true;
        let (pair, outlines) = (Arc::clone(pair), Outlines::new(pair));
        let (ellipses, grid) = (Ellipses::new()?, Grid::new(axes));
        Ok(Self { pair, outlines, ellipses, grid, contact_modulus, joining })
    }

    /// The profiles in their places.
    pub fn pair(&self) -> &Arc<Pair> {
        &self.pair
    }

    /// Nominal radius of the wheel, in m.
    pub fn nominal_radius(&self) -> f64 {
        self.pair.nominal_radius
    }

    /// Origin of the rail's profile in the track, outwards, in m.
    pub(crate) fn rail_origin(&self) -> f64 {
        self.pair.rail_origin[0]
    }

    /// The contacts of a wheelset at a lateral position and a height (in m), with a roll and a yaw
    /// angle (in rad).
    pub(crate) fn contacts(&self, [lateral, height, roll, yaw]: [f64; POSE]) -> Found {
        let attitude = Attitude { lateral, roll, yaw };
        let placement = Placement::new(&self.pair, attitude, height);
        let overlaps = Overlaps::new(&self.outlines, &placement, &self.joining);
        let [_, rolls, yaws, depths] = &self.grid.axes;
        let is_covered = overlaps.is_whole && roll.abs() <= rolls.end() && yaw.abs() <= yaws.end();
        let mut found = Found { count: 0, contacts: [None; MOST], is_covered };
        for overlap in overlaps.all() {
            if let Some(seat) = self.seat(&placement, overlap) {
                found.is_covered &= seat.depth.value.ln() <= depths.end();
                found.contacts[found.count] = Some(self.contact(&placement, &seat));
                found.count += 1;
            }
        }
        self.raised(&mut found);
        found
    }

    pub(super) fn seat(&self, placement: &Placement, overlap: &Overlap) -> Option<Seat> {
        let Overlap { weight, shape, moments, .. } = *overlap;
        let part = OfPose::from(1.0) / weight;
        let [x, y, inclination, arc] = moments.map(|moment| moment * part);
        let rail = self.outlines.rail(y.value)?;
        let z = y.chain(rail.z, rail.slope);
        let depth = weight / shape * DEPTH.recip();
        let width = shape / (depth * depth.sqrt()) * SHAPE.recip();
        let (sin, cos) = inclination.value.sin_cos();
        let cos = inclination.chain(cos, -sin);
        let position = [x, y, z];
        let on_wheel = Self::on_wheel(placement, position);
        let approach = depth * cos;
        let semi_axes = [(on_wheel[1] * depth * 2.0).sqrt(), width / cos];
        let pressed = self.ellipses.pressed(self.contact_modulus, approach, semi_axes);
        let is_sound = pressed.load.value > 0.0;
        is_sound.then_some(Seat { position, inclination, arc, on_wheel, depth, approach, pressed })
    }

    /// Position along the axle of a point in the track, and its distance from the axle, in m.
    fn on_wheel(placement: &Placement, place: [OfPose; 3]) -> [OfPose; 2] {
        let of_pose = |value: f64, slopes: [f64; POSE]| OfPose { value, slopes };
        let wheel = &placement.wheel;
        let centre = [0, 1, 2].map(|k| {
            let [by_roll, by_yaw] = placement.turned.map(|by| by.centre[k]);
            let moved = [f64::from(k == 1), f64::from(k == 2)];
            of_pose(wheel.centre[k], [moved[0], moved[1], by_roll, by_yaw])
        });
        let [axle_x, axle_y, axle_z] = [0, 1, 2].map(|k| {
            let [by_roll, by_yaw] = placement.turned.map(|by| by.rotation[k][1]);
            of_pose(wheel.rotation[k][1], [0.0, 0.0, by_roll, by_yaw])
        });
        let [x, y, z] = [0, 1, 2].map(|k| place[k] - centre[k]);
        let along = x * axle_x + y * axle_y + z * axle_z;
        [along, (x * x + y * y + z * z - along * along).sqrt()]
    }

    /// Place in the grid.
    pub(super) fn place(attitude: &Attitude, seat: &Seat) -> [f64; AXES] {
        [seat.arc.value, attitude.roll, attitude.yaw.abs(), seat.depth.value.ln()]
    }

    fn contact(&self, placement: &Placement, seat: &Seat) -> TabulatedContact {
        let attitude = &placement.attitude;
        let forward = if attitude.yaw < 0.0 { -1.0 } else { 1.0 };
        let found = self.grid.at(Self::place(attitude, seat));
        let unit = |k: usize| {
            let mut slopes = [0.0; POSE];
            slopes[k] = 1.0;
            OfPose { value: 0.0, slopes }
        };
        let log_depth = seat.depth.chain(0.0, seat.depth.value.recip());
        let axes = [seat.arc, unit(ROLL), unit(YAW) * forward, log_depth];
        let value = |k: usize| {
            let mut slopes = [0.0; POSE];
            for (axis, by) in axes.iter().zip(&found[1..]) {
                for (slope, part) in slopes.iter_mut().zip(&axis.slopes) {
                    *slope += by[k] * part;
                }
            }
            OfPose { value: found[0][k], slopes }
        };
        let [load, long, wide, ahead, beside] = std::array::from_fn::<_, VALUES, _>(value);
        let [a, b] = seat.pressed.semi_axes;
        let [along, rolling_radius] = seat.on_wheel;
        let semi_axes = [a * long, b * wide];
        TabulatedContact {
            position: seat.position,
            inclination: seat.inclination,
            wheel_position: along - OfPose::from(self.pair.wheel_offset),
            rolling_radius,
            load: seat.pressed.load * load,
            approach: seat.approach,
            semi_axes,
            centre: [a * ahead * forward, b * beside],
        }
    }

    /// Contacts in planes of their own move each other's surfaces apart.
    fn raised(&self, found: &mut Found) {
        if found.count < 2 {
            return;
        }
        let alone = found.contacts;
        for _ in 0..PASSES {
            let before = found.contacts;
            for (k, contact) in alone.iter().enumerate() {
                let Some(contact) = contact else { continue };
                let others = before.iter().enumerate().filter(|(j, _)| *j != k);
                let rise = others.filter_map(|(_, other)| Some(self.rise(contact, &(*other)?)));
                let rise = rise.fold(OfPose::from(0.0), |sum, part| sum + part);
                found.contacts[k] = Some(contact.lifted(rise));
            }
        }
    }

    /// How far another contact moves the surfaces apart, in m.
    fn rise(&self, at: &TabulatedContact, other: &TabulatedContact) -> OfPose {
        let [x, y, z] = [0, 1, 2].map(|k| at.position[k] - other.position[k]);
        let turn = at.inclination - other.inclination;
        let facing = turn.chain(turn.value.cos(), -turn.value.sin());
        let distance = (x * x + y * y + z * z).sqrt();
        other.load * facing / (distance * (PI * self.contact_modulus))
    }
}

impl TabulatedContact {
    /// With surfaces that have been moved apart, as a contact of Hertz.
    fn lifted(&self, rise: OfPose) -> Self {
        let part = OfPose::from(1.0) - rise / self.approach;
        if part.value <= 0.0 {
            return Self { load: OfPose::from(0.0), ..*self };
        }
        let root = part.sqrt();
        Self {
            load: self.load * part * root,
            semi_axes: self.semi_axes.map(|axis| axis * root),
            ..*self
        }
    }
}
