//! The contacts of a wheelset over its lateral position: the table that vehicle dynamics needs,
//! JSON, a summary and figures.

mod figure;
mod json;
mod summary;

use schlupf::Status;
use schlupf::reporting::{Column, Message, Record, Value, columns};
use schlupf::wheel_rail::{Contact, Pair, RollingRadiusDifference, Side, Sides, WheelSolution};
use std::sync::Arc;

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues};

/// Names of the figures.
const CONTACTS: &str = "contact_points";
const RADII: &str = "rolling_radius";

/// Both wheels at a lateral position, resting on their rails.
#[derive(Debug, Clone)]
pub struct WheelsetAt {
    /// Lateral position of the middle of the axle, in m.
    pub lateral: f64,
    /// Rolling radius of the left wheel minus that of the right one, of rigid bodies that neither
    /// roll about x nor yaw, in m.
    pub rigid: Option<f64>,
    /// The left and the right wheel, or why they were not found.
    pub wheels: Result<[WheelSolution; 2], String>,
}

impl WheelsetAt {
    /// Δr, the rolling radius of the left wheel minus that of the right one, each at the contact
    /// with the largest normal force, in m.
    pub fn rolling_radius_difference(&self) -> Option<f64> {
        let wheels = self.wheels.as_ref().ok()?;
        let [left, right] = wheels.each_ref().map(|wheel| wheel.contacts.first());
        Some(left?.rolling_radius - right?.rolling_radius)
    }

    /// One of the wheels, if both were found.
    fn wheel(&self, side: Side) -> Option<&WheelSolution> {
        self.wheels.as_ref().ok()?.iter().find(|wheel| wheel.side == side)
    }

    /// Whether all equations of both wheels are satisfied.
    fn status(&self) -> Status {
        let is = |wheel: &WheelSolution| wheel.status() == Status::Converged;
        let is_converged = self.wheels.as_ref().is_ok_and(|wheels| wheels.iter().all(is));
        if is_converged { Status::Converged } else { Status::NotConverged }
    }
}

/// The contacts of a wheelset over its lateral position.
#[derive(Debug, Clone)]
pub struct WheelsetReport {
    /// Title of the case.
    pub title: String,
    /// Profiles of both sides, for the figure.
    pub pairs: Sides<Arc<Pair>>,
    /// Vertical force on each wheel, in N.
    pub load: f64,
    /// The positions.
    pub positions: Vec<WheelsetAt>,
    /// Δr of rigid bodies that neither roll about x nor yaw, unless they do not touch in the
    /// middle.
    pub radii: Option<RollingRadiusDifference>,
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
    /// That of each by the wavelength of the nonlinear motion (EN 15302), dimensionless.
    pub nonlinear: Vec<Option<f64>>,
    /// That of each by harmonic linearisation, dimensionless.
    pub harmonic: Vec<Option<f64>>,
}

impl Record for Conicity {
    fn rows(&self) -> usize {
        self.amplitude.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Conicity:
        Amplitude => |curve, k| curve.amplitude[k],
        EquivalentConicity => |curve, k| curve.nonlinear[k],
        HarmonicConicity => |curve, k| curve.harmonic[k],
    };
}

/// A contact of a wheel, or a wheel that was not found.
struct Row<'a> {
    at: &'a WheelsetAt,
    side: Side,
    wheel: Option<&'a WheelSolution>,
    /// Number of the contact, from one; zero for none.
    number: usize,
    contact: Option<&'a Contact>,
}

/// Status of a position whose wheels were not found, as in the tables of studies.
pub(crate) const FAILED: &str = "failed";

impl Row<'_> {
    fn status(&self) -> &'static str {
        self.wheel.map_or(FAILED, |wheel| wheel.status().name())
    }

    /// What the wheel has.
    fn of_wheel(&self, value: impl Fn(&WheelSolution) -> f64) -> Option<f64> {
        self.wheel.map(value)
    }

    /// What the contact has.
    fn of_contact(&self, value: impl Fn(&Contact) -> f64) -> Option<f64> {
        self.contact.map(value)
    }
}

impl WheelsetReport {
    fn contacts(&self) -> impl Iterator<Item = Row<'_>> {
        let sides = |at| [Side::Left, Side::Right].map(|side| (at, side));
        self.positions.iter().flat_map(sides).flat_map(|(at, side): (&WheelsetAt, _)| {
            let wheel = at.wheel(side);
            let contacts = wheel.map_or(&[][..], |wheel| &wheel.contacts);
            let row = move |(number, contact)| Row { at, side, wheel, number, contact };
            let none = contacts.is_empty().then(|| row((0, None)));
            (1..).zip(contacts.iter().map(Some)).map(row).chain(none)
        })
    }

    /// What a row has in a column; unknown beyond the last row.
    fn of<V: Into<Value>>(&self, row: usize, value: impl Fn(&Row) -> V) -> Value {
        self.contacts().nth(row).map_or(Value::Unknown, |row| value(&row).into())
    }

    /// What the wheel of a row has.
    fn of_wheel(&self, row: usize, value: impl Fn(&WheelSolution) -> f64) -> Value {
        self.of(row, |row| row.of_wheel(&value))
    }

    /// What the contact of a row has.
    fn of_contact(&self, row: usize, value: impl Fn(&Contact) -> f64) -> Value {
        self.of(row, |row| row.of_contact(&value))
    }
}

/// One row for each contact of each wheel at each position, and one for a wheel that was not found.
impl Record for WheelsetReport {
    fn rows(&self) -> usize {
        self.contacts().count()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { WheelsetReport:
        LateralPosition => |all, k| all.of(k, |row| row.at.lateral),
        WheelSide "side" => |all, k| all.of(k, |row| Value::Name(row.side.name())),
        ContactNumber "contact" => |all, k| all.of(k, |row| row.number),
        WheelsetHeight => |all, k| all.of_wheel(k, |wheel| wheel.height),
        RollAngle => |all, k| all.of_wheel(k, |wheel| wheel.position.roll),
        RollingRadiusDifference => |all, k| all.of(k, |row| row.at.rolling_radius_difference()),
        RigidRollingRadiusDifference => |all, k| all.of(k, |row| row.at.rigid),
        PositionX "position.x" => |all, k| all.of_contact(k, |contact| contact.position[0]),
        PositionY "position.y" => |all, k| all.of_contact(k, |contact| contact.position[1]),
        PositionZ "position.z" => |all, k| all.of_contact(k, |contact| contact.position[2]),
        ContactAngle "angle" => |all, k| all.of_contact(k, |contact| contact.angle),
        RailPosition => |all, k| all.of_contact(k, |contact| contact.rail_position),
        WheelPosition => |all, k| all.of_contact(k, |contact| contact.wheel_position),
        RollingRadius => |all, k| all.of_contact(k, |contact| contact.rolling_radius),
        CreepageX => |all, k| all.of_contact(k, |c| c.solution.kinematics.creepage_x),
        CreepageY => |all, k| all.of_contact(k, |c| c.solution.kinematics.creepage_y),
        Spin => |all, k| all.of_contact(k, |c| c.solution.kinematics.spin),
        Load "normal.load" => |all, k| all.of_contact(k, |c| c.solution.normal.load),
        SemiAxisX "normal.semi_axis_x" => |all, k| {
            all.of_contact(k, |c| c.solution.normal.semi_axis_x)
        },
        SemiAxisY "normal.semi_axis_y" => |all, k| {
            all.of_contact(k, |c| c.solution.normal.semi_axis_y)
        },
        PeakPressure "normal.peak_pressure" => |all, k| {
            all.of_contact(k, |c| c.solution.normal.peak_pressure)
        },
        ForceX "force.x" => |all, k| all.of_contact(k, |c| c.solution.force.x),
        ForceY "force.y" => |all, k| all.of_contact(k, |c| c.solution.force.y),
        MomentZ "force.moment_z" => |all, k| {
            all.of(k, |row| row.contact.and_then(|c| c.solution.force.moment_z))
        },
        WheelForceX "wheel_force.x" => |all, k| all.of_wheel(k, |wheel| wheel.force[0]),
        WheelForceY "wheel_force.y" => |all, k| all.of_wheel(k, |wheel| wheel.force[1]),
        WheelForceZ "wheel_force.z" => |all, k| all.of_wheel(k, |wheel| wheel.force[2]),
        Convergence "status" => |all, k| all.of(k, |row| Value::Name(row.status())),
    };
}

impl Report for WheelsetReport {
    fn status(&self) -> Status {
        let mut status = self.positions.iter().map(WheelsetAt::status);
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

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        vec![("contacts", table::columns(self)), ("conicity", table::columns(&self.conicity))]
    }

    fn figure_names() -> Vec<String> {
        vec![CONTACTS.to_owned(), RADII.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let contacts = figure::contacts(self).ok_or(FigureError::NoContacts)?;
        let radii = figure::radii(self).ok_or(FigureError::NoContacts)?;
        Ok(vec![(CONTACTS.to_owned(), contacts), (RADII.to_owned(), radii)])
    }

    fn own_files() -> &'static [OwnFile] {
        const {
            &[OwnFile::new(
                Self::CONICITY,
                "conicity",
                "Write the equivalent conicity as CSV, one row for each amplitude",
            )]
        }
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
