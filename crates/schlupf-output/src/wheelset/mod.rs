//! The contacts of a wheelset over its lateral position: the table that vehicle dynamics needs,
//! JSON, a summary and figures.

mod figure;
mod json;
mod summary;

use schlupf::Status;
use schlupf::columns;
use schlupf::columns::{Column, Record};
use schlupf::message::Message;
use schlupf::wheel_rail::{Contact, Pair, WheelSolution};
use std::sync::Arc;

use crate::figures::{Drawing, FigureError};
use crate::report::Report;
use crate::summary::Summary;
use crate::table::{Table, entries, entry};

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

/// A contact of a wheel, one row.
#[derive(Debug, Clone)]
pub(crate) struct Row<'a> {
    at: &'a WheelsetAt,
    wheel: &'a WheelSolution,
    contact: &'a Contact,
}

/// The columns of a contact in the table.
type Entry = (&'static str, &'static str, fn(&Row) -> Option<f64>);

/// Name, unit and value of the columns after side and number of a contact.
const COLUMNS: &[Entry] = &[
    ("wheelset_height", "m", |row| Some(row.wheel.height)),
    ("roll_angle", "rad", |row| Some(row.wheel.position.roll)),
    ("rolling_radius_difference", "m", |row| row.at.rolling_radius_difference()),
    ("position.x", "m", |row| Some(row.contact.position[0])),
    ("position.y", "m", |row| Some(row.contact.position[1])),
    ("position.z", "m", |row| Some(row.contact.position[2])),
    ("angle", "rad", |row| Some(row.contact.angle)),
    ("rail_position", "m", |row| Some(row.contact.rail_position)),
    ("wheel_position", "m", |row| Some(row.contact.wheel_position)),
    ("rolling_radius", "m", |row| Some(row.contact.rolling_radius)),
    ("creepage_x", "1", |row| Some(row.contact.solution.kinematics.creepage_x)),
    ("creepage_y", "1", |row| Some(row.contact.solution.kinematics.creepage_y)),
    ("spin", "1/m", |row| Some(row.contact.solution.kinematics.spin)),
    ("normal.load", "N", |row| Some(row.contact.solution.normal.load)),
    ("normal.semi_axis_x", "m", |row| Some(row.contact.solution.normal.semi_axis_x)),
    ("normal.semi_axis_y", "m", |row| Some(row.contact.solution.normal.semi_axis_y)),
    ("normal.peak_pressure", "Pa", |row| Some(row.contact.solution.normal.peak_pressure)),
    ("force.x", "N", |row| Some(row.contact.solution.force.x)),
    ("force.y", "N", |row| Some(row.contact.solution.force.y)),
    ("force.moment_z", "N m", |row| row.contact.solution.force.moment_z),
    ("wheel_force.x", "N", |row| Some(row.wheel.force[0])),
    ("wheel_force.y", "N", |row| Some(row.wheel.force[1])),
    ("wheel_force.z", "N", |row| Some(row.wheel.force[2])),
];

impl WheelsetReport {
    fn rows(&self) -> impl Iterator<Item = (usize, Row<'_>)> {
        self.positions.iter().flat_map(|at| {
            at.wheels.iter().flat_map(move |wheel| {
                let contacts = (1..).zip(&wheel.contacts);
                contacts.map(move |(k, contact)| (k, Row { at, wheel, contact }))
            })
        })
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

    /// One row for each contact of each wheel at each position.
    fn csv(&self) -> Option<String> {
        let mut table = Table::default()
            .with("lateral_position", "m")
            .with("side", "left or right")
            .with("contact", "number");
        for (name, unit, _) in COLUMNS {
            table = table.with(name, unit);
        }
        table = table.with("status", "converged or not-converged");
        for (number, row) in self.rows() {
            let first = [
                entry(row.at.lateral.into()),
                row.wheel.side.name().to_owned(),
                number.to_string(),
            ];
            let values = COLUMNS.iter().map(|(_, _, value)| entry(value(&row).into()));
            let status = row.contact.solution.status.name().to_owned();
            table.push(first.into_iter().chain(values).chain([status]));
        }
        Some(table.csv("forces on the wheel; y to the left, z up"))
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
        let mut table = Table::default().with_columns::<Conicity>();
        for row in 0..self.conicity.rows() {
            table.push(entries(&self.conicity, row));
        }
        Some(table.csv("").into_bytes())
    }
}

impl WheelsetReport {
    /// Format of the table of the equivalent conicity.
    pub const CONICITY: &str = "conicity";
}
