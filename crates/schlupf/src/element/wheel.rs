//! The element of a wheel on a rail, whose contacts come from a table.
//!
//! At the pose of a wheelset relative to a rail the table gives every contact; each moves as the
//! rigid wheelset does at its centre of pressure, and has the forces of a fast method on its
//! ellipse. All of them act on the wheelset together.

use std::sync::Arc;

use crate::Method;
use crate::interface::Interface;
use crate::numerics::dual::Dual;
use crate::reporting::{Error, Quantity, Warning, WheelRailError, require_positive};
use crate::wheel_rail::{ContactTable, Motion as RigidMotion, OfPose, Side, TabulatedContact};

use super::any_ellipse::AnyEllipse;
use super::evaluation::{Evaluation, Status};
use super::flash::Flash;
use super::rolling::Rolling;
use super::settings::{Motion, Settings};
use super::signals::Signal;
use super::wheel_motion::{Axes, Moving, Vector, Wheelset, cross};

/// Inputs, in their order. The rail's displacements and velocities follow as the negatives of the
/// wheelset's.
pub(super) const INPUTS: [Quantity; 17] = [
    Quantity::LateralPosition,
    Quantity::WheelsetHeight,
    Quantity::RollAngle,
    Quantity::WheelsetYaw,
    Quantity::Speed,
    Quantity::LateralVelocity,
    Quantity::VerticalVelocity,
    Quantity::RollRate,
    Quantity::AngularVelocity,
    Quantity::YawRate,
    Quantity::FrictionFactor,
    Quantity::WheelBulkTemperature,
    Quantity::RailBulkTemperature,
    Quantity::RailDisplacementY,
    Quantity::RailDisplacementZ,
    Quantity::RailVelocityY,
    Quantity::RailVelocityZ,
];

/// Inputs of which none is the negative of another one.
const VARIABLES: usize = 13;

/// Those of which the last ones are the negatives.
const OPPOSITES: [usize; 4] = [0, 1, 5, 6];

/// Inputs that change their sign in the mirror image of a right wheel.
const MIRRORED: [usize; 6] = [0, 2, 3, 5, 7, 9];

/// Outputs of the wheel as a whole.
const OF_WHEEL: [Quantity; 7] = [
    Quantity::WheelForceX,
    Quantity::WheelForceY,
    Quantity::WheelForceZ,
    Quantity::WheelMomentX,
    Quantity::WheelMomentY,
    Quantity::WheelMomentZ,
    Quantity::CreepPower,
];

/// Outputs of each contact.
const OF_CONTACT: [Quantity; 16] = [
    Quantity::Load,
    Quantity::Approach,
    Quantity::ContactAngle,
    Quantity::RailPosition,
    Quantity::WheelPosition,
    Quantity::RollingRadius,
    Quantity::SemiAxisX,
    Quantity::SemiAxisY,
    Quantity::CreepageX,
    Quantity::CreepageY,
    Quantity::Spin,
    Quantity::Friction,
    Quantity::MaxRise,
    Quantity::ForceX,
    Quantity::ForceY,
    Quantity::MomentZ,
];

/// Those of them that change their sign in the mirror image.
const OPPOSITE_OUTPUTS: [Quantity; 8] = [
    Quantity::ContactAngle,
    Quantity::WheelForceY,
    Quantity::WheelMomentX,
    Quantity::WheelMomentZ,
    Quantity::CreepageY,
    Quantity::Spin,
    Quantity::ForceY,
    Quantity::MomentZ,
];

/// Contacts of a wheel that are outputs, from the field side to the flange.
pub const CONTACTS: usize = 3;

/// A wheel on a rail as a function of the pose and the motion of its wheelset. Clones share the
/// table.
#[derive(Debug, Clone)]
pub(super) struct Wheel {
    table: Arc<ContactTable>,
    side: Side,
    /// As seen from the left; what it does not take as inputs counts.
    motion: RigidMotion,
    interface: Interface,
    law: AnyEllipse,
    flash: Option<Flash>,
    settings: Settings,
    start: Vec<f64>,
    /// What the method neglects.
    pub warnings: Vec<Warning>,
}

/// Of one contact.
struct Acting<T> {
    values: [T; OF_CONTACT.len()],
    force: Vector<T>,
    moment: Vector<T>,
    power: T,
}

/// What an element of a wheel is made of.
#[derive(Debug, Clone)]
pub struct WheelParts<'a> {
    /// Contacts of its pair of profiles.
    pub table: Arc<ContactTable>,
    /// Which wheel.
    pub side: Side,
    /// Where the wheelset is at the start: lateral position and height (in m), roll and yaw angle
    /// (in rad).
    pub pose: [f64; 4],
    /// How it moves at the start; the curve of the track counts throughout.
    pub motion: RigidMotion,
    /// Both bodies and the friction.
    pub interface: &'a Interface,
}

impl Wheel {
    /// # Errors
    /// A method that computes fields, and bodies that it rejects.
    pub fn new(parts: WheelParts, method: &Method, settings: Settings) -> Result<Self, Error> {
        require_positive(Quantity::StandstillSpeed, settings.standstill_speed)?;
        let WheelParts { table, side, pose, motion, interface } = parts;
        if table.pair().is_moving() {
            return Err(WheelRailError::MovingDeviation {}.into());
        }
        let law =
            AnyEllipse::new(interface, method).ok_or(WheelRailError::MethodOfElement {})??;
        let warnings = law.warnings(interface);
        let [wheel, rail] = [&interface.wheel, &interface.rail].map(|body| body.bulk_temperature);
        let start = pose.into_iter().chain([
            motion.speed,
            motion.lateral_velocity,
            motion.vertical_velocity,
            motion.roll_rate,
            motion.angular_velocity,
            motion.yaw_rate,
            1.0,
            wheel,
            rail,
        ]);
        let start = start.chain(OPPOSITES.map(|_| 0.0)).collect();
        // The rolling speed of a contact stands for the angular velocity times a radius of one.
        let settings = Settings { motion: Motion::Velocities, rolling_radius: 1.0, ..settings };
        let (flash, interface) = (Flash::new(interface), interface.clone());
        Ok(Self { table, side, motion, interface, law, flash, settings, start, warnings })
    }

    pub fn inputs() -> Vec<Signal> {
        INPUTS.map(Signal::from).to_vec()
    }

    /// What the inputs are at the start, each in the unit of its quantity.
    pub fn start(&self) -> Vec<f64> {
        self.start.clone()
    }

    /// Those of the wheel, then those of each contact.
    pub fn outputs(&self) -> Vec<Signal> {
        let contact = |k: usize| {
            let known = OF_CONTACT.into_iter().filter(|of| self.has(*of));
            known.map(move |of| Signal::new(of, Some(k + 1)))
        };
        let of_wheel = OF_WHEEL.into_iter().map(Signal::from);
        of_wheel.chain((0..CONTACTS).flat_map(contact)).collect()
    }

    /// Whether a quantity of a contact is among the outputs.
    fn has(&self, of: Quantity) -> bool {
        match of {
            Quantity::MomentZ => self.law.has_moment(),
            Quantity::MaxRise => self.flash.is_some(),
            _ => true,
        }
    }

    /// Finds outputs and derivatives; as many inputs as there should be.
    pub fn evaluate(&self, inputs: &[f64], found: &mut Evaluation) -> Status {
        if !inputs.iter().all(|input| input.is_finite()) {
            found.fill(f64::NAN);
            return Status::NotFinite;
        }
        let signs = self.signs();
        let mut own: [f64; VARIABLES] = std::array::from_fn(|k| inputs[k]);
        for (k, opposite) in OPPOSITES.into_iter().enumerate() {
            own[opposite] -= inputs[VARIABLES + k];
        }
        let own = std::array::from_fn(|k| signs[k] * own[k]);
        if found.derivatives.is_empty() {
            self.find(own.map(Dual::<0>::from), found)
        } else {
            self.find(Dual::<VARIABLES>::variables(own), found)
        }
    }

    /// Signs of the variables of a wheel on its side, relative to those of the left one.
    fn signs(&self) -> [f64; VARIABLES] {
        let sign = self.side.outwards();
        std::array::from_fn(|k| if MIRRORED.contains(&k) { sign } else { 1.0 })
    }

    fn find<const N: usize>(&self, own: [Dual<N>; VARIABLES], found: &mut Evaluation) -> Status {
        let [
            lateral,
            height,
            roll,
            yaw,
            speed,
            v_y,
            v_z,
            roll_rate,
            angular_velocity,
            yaw_rate,
            ..,
        ] = own;
        let contacts = self.table.contacts([lateral, height, roll, yaw].map(|part| part.value));
        let radius = self.table.nominal_radius();
        let curvature = self.side.outwards() / self.motion.curve_radius;
        let wheelset = Wheelset {
            centre: [Dual::from(0.0), lateral, height + Dual::from(radius)],
            angles: [roll, yaw],
            velocity: [speed, v_y, v_z],
            turning: [roll_rate, angular_velocity, yaw_rate],
            along: (speed, curvature),
        };
        let mut of_wheel = [Dual::<N>::from(0.0); OF_WHEEL.len()];
        let signs = self.signs();
        let of_contact = (found.outputs.len() - OF_WHEEL.len()) / CONTACTS;
        let mut row = OF_WHEEL.len();
        let mut is_found = false;
        for (place, contact) in contacts.by_place().enumerate() {
            let acting = self.acting(&wheelset, contact, &own);
            let parts = acting.force.into_iter().chain(acting.moment).chain([acting.power]);
            of_wheel.iter_mut().zip(parts).for_each(|(sum, part)| *sum = *sum + part);
            is_found |= contact.load.value > 0.0;
            // Of more contacts than that the last one stays that at the flange.
            row = OF_WHEEL.len() + place.min(CONTACTS - 1) * of_contact;
            let values = OF_CONTACT.into_iter().zip(&acting.values);
            for value in values.filter(|(of, _)| self.has(*of)) {
                self.put(found, row, (value, &signs));
                row += 1;
            }
        }
        found.clear(row);
        for (row, value) in OF_WHEEL.into_iter().zip(&of_wheel).enumerate() {
            self.put(found, row, (value, &signs));
        }
        if !found.is_finite(OF_WHEEL.len()) {
            found.fill(f64::NAN);
            return Status::NotFinite;
        }
        match (is_found, contacts.is_covered()) {
            (true, true) => Status::Found,
            (true, false) => Status::OutsideTable,
            (false, _) => Status::NoContact,
        }
    }

    /// An output of a wheel on its side, by its own inputs.
    fn put<const N: usize>(
        &self,
        found: &mut Evaluation,
        row: usize,
        ((of, value), signs): ((Quantity, &Dual<N>), &[f64; VARIABLES]),
    ) {
        let sign = if OPPOSITE_OUTPUTS.contains(&of) { self.side.outwards() } else { 1.0 };
        let mut slopes = [0.0; INPUTS.len()];
        for (k, slope) in value.slopes.iter().enumerate() {
            slopes[k] = sign * signs[k] * slope;
        }
        for (k, opposite) in OPPOSITES.into_iter().enumerate() {
            slopes[VARIABLES + k] = -slopes[opposite];
        }
        found.put(row, sign * value.value, &slopes);
    }

    fn acting<const N: usize>(
        &self,
        wheelset: &Wheelset<Dual<N>>,
        contact: &TabulatedContact,
        own: &[Dual<N>; VARIABLES],
    ) -> Acting<Dual<N>> {
        let lift = |of: OfPose| {
            let slopes = std::array::from_fn(|k| of.slopes.get(k).copied().unwrap_or(0.0));
            Dual { value: of.value, slopes }
        };
        let (load, approach, inclination) =
            (lift(contact.load), lift(contact.approach), lift(contact.inclination));
        let axes = Axes::new(inclination);
        let [a, b] = contact.semi_axes.map(lift);
        let [ahead, beside] = contact.centre.map(lift);
        let away = axes.resolved([ahead, beside, Dual::from(0.0)]);
        let under = axes.resolved([Dual::from(0.0), Dual::from(0.0), -approach]);
        let [at, under] = {
            let origin = contact.position.map(lift);
            let at: Vector<_> = [0, 1, 2].map(|k| origin[k] + away[k]);
            [at, [0, 1, 2].map(|k| at[k] + under[k])]
        };
        let Moving { slip: [x, y], spin_rate, around } = wheelset.at(under, &axes);
        let rolling = Rolling::new(&self.settings, [x - around, y, spin_rate, -around]);
        let [factor, wheel, rail] = [10, 11, 12].map(|k| own[k]);
        let factor = if factor.value > 0.0 { factor } else { Dual::from(0.0) };
        let friction = rolling.friction(&self.interface, [wheel, rail]) * factor;
        let limit = friction * load;
        let [xi, eta, spin] = rolling.creepages;
        let force = rolling.through_standstill(|[xi, eta, spin]| {
            let variables = [xi, eta, spin, limit, a, b];
            let found = self.law.force(variables.map(|variable| variable.value));
            found.map(|force| force.of(&variables))
        });
        let [force_x, force_y, moment_z] =
            if limit.value > NO_FORCE { force } else { [Dual::from(0.0); 3] };
        let total = axes.resolved([force_x, force_y, load]);
        let about_normal = axes.resolved([Dual::from(0.0), Dual::from(0.0), moment_z]);
        let arm = [0, 1, 2].map(|k| at[k] - wheelset.centre[k]);
        let turning = cross(arm, total);
        let power = -(force_x * x + force_y * y + moment_z * spin_rate);
        let rail_position = at_origin(contact.position[1], self.table.rail_origin());
        let values = [
            load,
            approach,
            -inclination,
            lift(rail_position),
            lift(contact.wheel_position),
            lift(contact.rolling_radius),
            a,
            b,
            xi,
            eta,
            spin,
            friction,
            self.flash
                .map_or(power, |flash| flash.max_rise(power, ([a, b], rolling.positive_speed))),
            force_x,
            force_y,
            moment_z,
        ];
        let moment = [0, 1, 2].map(|k| turning[k] + about_normal[k]);
        Acting { values, force: total, moment, power }
    }
}

/// Friction limit below which there are no tangential forces, in N.
const NO_FORCE: f64 = 1e-9;

fn at_origin(position: OfPose, origin: f64) -> OfPose {
    position - OfPose::from(origin)
}
