//! The contacts of a wheelset over its lateral position: the table that vehicle dynamics needs,
//! JSON, a summary and figures.

mod figure;
mod json;
mod summary;

use schlupf::Status;
use schlupf::columns;
use schlupf::columns::{Column, Record, Value};
use schlupf::message::Message;
use schlupf::wheel_rail::{Contact, Pair, WheelSolution};
use std::sync::Arc;

use crate::figures::{Drawing, FigureError};
use crate::report::Report;
use crate::summary::Summary;
use crate::table;

/// Names of the figures.
const CONTACTS: &str = "contact_points";
const RADII: &str = "rolling_radius";

/// Both wheels at a lateral position, resting on their rails.
#[derive(Debug, Clone)]
pub struct WheelsetAt {
    /// Lateral position of the middle of the axle, in m.
    pub lateral: f64,
    /// The left and the right wheel.
    pub wheels: [WheelSolution; 2],
}

impl WheelsetAt {
    /// Δr, the rolling radius of the left wheel minus that of the right one, each at the contact
    /// with the largest normal force, in m.
    pub fn rolling_radius_difference(&self) -> Option<f64> {
        let [left, right] = self.wheels.each_ref().map(|wheel| wheel.contacts.first());
        Some(left?.rolling_radius - right?.rolling_radius)
    }
}

/// The contacts of a wheelset over its lateral position.
#[derive(Debug, Clone)]
pub struct WheelsetReport {
    /// Title of the case.
    pub title: String,
    /// Profiles of both sides, for the figure.
    pub pair: Arc<Pair>,
    /// Vertical force on each wheel, in N.
    pub load: f64,
    /// The positions.
    pub positions: Vec<WheelsetAt>,
    /// Equivalent conicity over the amplitude of the lateral motion.
    pub conicity: Conicity,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// Equivalent conicity (dimensionless) over the amplitude of the lateral motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Conicity {
    /// Amplitudes, in m.
    pub amplitude: Vec<f64>,
    /// Of each, dimensionless.
    pub conicity: Vec<f64>,
}

impl Record for Conicity {
    fn rows(&self) -> usize {
        self.amplitude.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Conicity:
            Amplitude => |curve, k| curve.amplitude[k],
            EquivalentConicity => |curve, k| curve.conicity[k],
        }
    }
}

/// A contact of a wheel.
struct Row<'a> {
    at: &'a WheelsetAt,
    wheel: &'a WheelSolution,
    /// Its number, from one.
    number: usize,
    contact: &'a Contact,
}

impl WheelsetReport {
    fn contacts(&self) -> impl Iterator<Item = Row<'_>> {
        self.positions.iter().flat_map(|at| {
            at.wheels.iter().flat_map(move |wheel| {
                let contacts = (1..).zip(&wheel.contacts);
                contacts.map(move |(number, contact)| Row { at, wheel, number, contact })
            })
        })
    }

    /// What a row has in a column; unknown beyond the last row.
    fn of<V: Into<Value>>(&self, row: usize, value: impl Fn(&Row) -> V) -> Value {
        self.contacts().nth(row).map_or(Value::Unknown, |row| value(&row).into())
    }
}

/// One row for each contact of each wheel at each position.
impl Record for WheelsetReport {
    fn rows(&self) -> usize {
        self.contacts().count()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { WheelsetReport:
            LateralPosition => |all, k| all.of(k, |row| row.at.lateral),
            WheelSide "side" => |all, k| all.of(k, |row| Value::Name(row.wheel.side.name())),
            ContactNumber "contact" => |all, k| all.of(k, |row| row.number),
            WheelsetHeight => |all, k| all.of(k, |row| row.wheel.height),
            RollAngle => |all, k| all.of(k, |row| row.wheel.position.roll),
            RollingRadiusDifference => |all, k| all.of(k, |row| row.at.rolling_radius_difference()),
            PositionX "position.x" => |all, k| all.of(k, |row| row.contact.position[0]),
            PositionY "position.y" => |all, k| all.of(k, |row| row.contact.position[1]),
            PositionZ "position.z" => |all, k| all.of(k, |row| row.contact.position[2]),
            ContactAngle "angle" => |all, k| all.of(k, |row| row.contact.angle),
            RailPosition => |all, k| all.of(k, |row| row.contact.rail_position),
            WheelPosition => |all, k| all.of(k, |row| row.contact.wheel_position),
            RollingRadius => |all, k| all.of(k, |row| row.contact.rolling_radius),
            CreepageX => |all, k| all.of(k, |row| row.contact.solution.kinematics.creepage_x),
            CreepageY => |all, k| all.of(k, |row| row.contact.solution.kinematics.creepage_y),
            Spin => |all, k| all.of(k, |row| row.contact.solution.kinematics.spin),
            Load "normal.load" => |all, k| all.of(k, |row| row.contact.solution.normal.load),
            SemiAxisX "normal.semi_axis_x" => |all, k| {
                all.of(k, |row| row.contact.solution.normal.semi_axis_x)
            },
            SemiAxisY "normal.semi_axis_y" => |all, k| {
                all.of(k, |row| row.contact.solution.normal.semi_axis_y)
            },
            PeakPressure "normal.peak_pressure" => |all, k| {
                all.of(k, |row| row.contact.solution.normal.peak_pressure)
            },
            ForceX "force.x" => |all, k| all.of(k, |row| row.contact.solution.force.x),
            ForceY "force.y" => |all, k| all.of(k, |row| row.contact.solution.force.y),
            MomentZ "force.moment_z" => |all, k| {
                all.of(k, |row| row.contact.solution.force.moment_z)
            },
            WheelForceX "wheel_force.x" => |all, k| all.of(k, |row| row.wheel.force[0]),
            WheelForceY "wheel_force.y" => |all, k| all.of(k, |row| row.wheel.force[1]),
            WheelForceZ "wheel_force.z" => |all, k| all.of(k, |row| row.wheel.force[2]),
            Convergence "status" => |all, k| all.of(k, |row| row.contact.solution.status),
        }
    }
}

impl Report for WheelsetReport {
    fn status(&self) -> Status {
        let wheels = self.positions.iter().flat_map(|at| &at.wheels);
        let mut status = wheels.map(WheelSolution::status);
        let is_failed = status.any(|status| status == Status::NotConverged);
        if is_failed { Status::NotConverged } else { Status::Converged }
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        json::document(self)
    }

    fn summary(&self) -> Summary {
        summary::text(self)
    }

    fn csv(&self) -> Option<String> {
        Some(table::csv(self, "forces on the wheel; y to the left, z up"))
    }

    fn figure_names() -> Vec<String> {
        vec![CONTACTS.to_owned(), RADII.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let contacts = figure::contacts(self).ok_or(FigureError::NoContacts)?;
        let radii = figure::radii(self).ok_or(FigureError::NoContacts)?;
        Ok(vec![(CONTACTS.to_owned(), contacts), (RADII.to_owned(), radii)])
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        if format != Self::CONICITY {
            return None;
        }
        Some(table::csv(&self.conicity, "").into_bytes())
    }
}

impl WheelsetReport {
    /// Format of the table of the equivalent conicity.
    pub const CONICITY: &str = "conicity";
}
