//! The contacts of a wheel: as JSON, and for the summary.

use schlupf::Status;
use schlupf::normal::NormalSummary;
use schlupf::solution::{Area, Resultant, TGamma};
use schlupf::wheel_rail::{Contact, WheelSolution};
use serde::Serialize;

use crate::output::number::significant as number;
use crate::output::summary::{Summary, entry, line};

/// All contacts, their sum, and where the wheelset is.
#[derive(Serialize)]
pub(crate) struct WheelDocument<'a> {
    wheelset: WheelsetPosition,
    contacts: Vec<ContactDocument<'a>>,
    wheel_force: Vector,
}

#[derive(Serialize)]
struct WheelsetPosition {
    side: &'static str,
    lateral_position: f64,
    height: f64,
    yaw_angle: f64,
    roll_angle: f64,
    angular_velocity: f64,
}

/// A vector in the track frame.
#[derive(Serialize)]
struct Vector {
    x: f64,
    y: f64,
    z: f64,
}

#[derive(Serialize)]
struct ContactDocument<'a> {
    position: Vector,
    angle: f64,
    rise_angle: f64,
    rail_position: f64,
    wheel_position: f64,
    rolling_radius: f64,
    turn: f64,
    status: Status,
    speed: f64,
    creepage_x: f64,
    creepage_y: f64,
    spin: f64,
    normal: &'a NormalSummary,
    force: &'a Resultant,
    normalised: &'a Resultant,
    t_gamma: &'a TGamma,
    friction_power: Option<f64>,
    max_rise: Option<f64>,
    area: &'a Area,
    residual: f64,
}

impl<'a> WheelDocument<'a> {
    pub fn new(wheel: &'a WheelSolution) -> Self {
        Self {
            wheelset: WheelsetPosition {
                side: wheel.side.name(),
                lateral_position: wheel.position.lateral,
                height: wheel.height,
                yaw_angle: wheel.position.yaw,
                roll_angle: wheel.position.roll,
                angular_velocity: wheel.angular_velocity,
            },
            contacts: wheel.contacts.iter().map(ContactDocument::new).collect(),
            wheel_force: Vector::new(wheel.force),
        }
    }
}

impl Vector {
    fn new([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }
}

impl<'a> ContactDocument<'a> {
    fn new(contact: &'a Contact) -> Self {
        let solution = &contact.solution;
        let kinematics = &solution.kinematics;
        Self {
            position: Vector::new(contact.position),
            angle: contact.angle,
            rise_angle: contact.rise,
            rail_position: contact.rail_position,
            wheel_position: contact.wheel_position,
            rolling_radius: contact.rolling_radius,
            turn: contact.turn,
            status: solution.status,
            speed: kinematics.speed,
            creepage_x: kinematics.creepage_x,
            creepage_y: kinematics.creepage_y,
            spin: kinematics.spin,
            normal: &solution.normal,
            force: &solution.force,
            normalised: &solution.normalised,
            t_gamma: &solution.t_gamma,
            friction_power: solution.power.map(|power| power.friction),
            max_rise: solution.temperature.map(|temperature| temperature.max_rise),
            area: &solution.area,
            residual: solution.residual,
        }
    }
}

/// Where the wheel is, its contacts and its forces in the track.
pub(crate) fn summary(text: &mut Summary, wheel: &WheelSolution) {
    let position = &wheel.position;
    let attitude = format!(
        "to the left, yaw {} mrad, roll {} mrad",
        number(1e3 * position.yaw),
        number(1e3 * position.roll)
    );
    let name = format!("{} wheel", wheel.side.name());
    entry(text, &name, 1e3 * position.lateral, "mm", &attitude);
    entry(text, "  height", 1e3 * wheel.height, "mm", "of the wheelset above the nominal one");
    let turning = "about the axle";
    entry(text, "  angular velocity", wheel.angular_velocity, "rad/s", turning);
    for (k, contact) in wheel.contacts.iter().enumerate() {
        let [x, y, z] = contact.position.map(|part| number(1e3 * part));
        let place = format!("rad; at x = {x} mm, y = {y} mm, z = {z} mm in the track");
        entry(text, &format!("contact {}, angle", k + 1), contact.angle, "", &place);
        let Resultant { x, y, .. } = contact.solution.force;
        let tangential =
            format!("normal, {} longitudinal, {} lateral", number(x / 1e3), number(y / 1e3));
        entry(text, "  force", contact.solution.normal.load / 1e3, "kN", &tangential);
    }
    let [x, y, z] = wheel.force.map(|part| part / 1e3);
    let others = format!("along the track, {} to the left, {} upwards", number(y), number(z));
    entry(text, "force on the wheel", x, "kN", &others);
    if wheel.contacts.len() > 1 {
        line(text, "  what follows is contact 1, in its own frame");
    }
    text.blank();
}
