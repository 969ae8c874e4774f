//! The contacts of a wheelset as JSON, for other programs.

use schlupf::Status;
use schlupf::reporting::Message;
use schlupf::wheel_rail::Side;
use serde::Serialize;

use super::{Conicity, FAILED, WheelsetAt, WheelsetReport};
use crate::output::json::{PROGRAM, text};
use crate::output::report::Report;
use crate::output::solution::wheel::WheelDocument;
use crate::output::table::Arrays;

/// The report as a JSON document, in SI units.
pub(super) fn document(report: &WheelsetReport) -> String {
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: report.status(),
        load: report.load,
        positions: report.positions.iter().map(Position::new).collect(),
        equivalent_conicity: Arrays(&report.conicity),
        warnings: &report.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    load: f64,
    positions: Vec<Position<'a>>,
    equivalent_conicity: Arrays<'a, Conicity>,
    warnings: &'a [Message],
}

#[derive(Serialize)]
struct Position<'a> {
    #[serde(rename = "lateral_position")]
    lateral: f64,
    rolling_radius_difference: Option<f64>,
    rigid_rolling_radius_difference: Option<f64>,
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<&'a str>,
    left: Option<WheelDocument<'a>>,
    right: Option<WheelDocument<'a>>,
}

impl<'a> Position<'a> {
    fn new(at: &'a WheelsetAt) -> Self {
        let error = at.wheels.as_ref().err().map(String::as_str);
        let wheel = |side| at.wheel(side).map(WheelDocument::new);
        Self {
            lateral: at.lateral,
            rolling_radius_difference: at.rolling_radius_difference(),
            rigid_rolling_radius_difference: at.rigid,
            status: if error.is_some() { FAILED } else { at.status().name() },
            error,
            left: wheel(Side::Left),
            right: wheel(Side::Right),
        }
    }
}
