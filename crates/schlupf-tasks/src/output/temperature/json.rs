//! Temperatures along lines as JSON, for other programs.

use schlupf::Status;
use schlupf::reporting::Message;
use serde::Serialize;

use super::{Row, Temperatures};
use crate::output::json::{PROGRAM, text};

/// The temperatures as a JSON document: lengths in m, temperatures in degC.
pub(super) fn document(temperatures: &Temperatures) -> String {
    let request = &temperatures.request;
    text(&Document {
        program: PROGRAM,
        title: &temperatures.title,
        status: temperatures.status,
        point: Point { x: request.point[0], y: request.point[1] },
        contact: Contact { leading_edge: request.passage[0], trailing_edge: request.passage[1] },
        bulk: Bulk { wheel: temperatures.bulk[0], rail: temperatures.bulk[1] },
        profile: Profile {
            depth: &temperatures.profile.position,
            wheel: &temperatures.profile.wheel,
            rail: &temperatures.profile.rail,
        },
        rows: temperatures.rows.iter().map(RowEntry::new).collect(),
        warnings: &temperatures.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    point: Point,
    contact: Contact,
    bulk: Bulk,
    profile: Profile<'a>,
    rows: Vec<RowEntry<'a>>,
    warnings: &'a [Message],
}

#[derive(Serialize)]
struct Point {
    x: f64,
    y: f64,
}

/// Contact of the point's row.
#[derive(Serialize)]
struct Contact {
    leading_edge: f64,
    trailing_edge: f64,
}

#[derive(Serialize)]
struct Bulk {
    wheel: f64,
    rail: f64,
}

#[derive(Serialize)]
struct Profile<'a> {
    depth: &'a [f64],
    wheel: &'a [f64],
    rail: &'a [f64],
}

#[derive(Serialize)]
struct RowEntry<'a> {
    depth: f64,
    x: &'a [f64],
    wheel: &'a [f64],
    rail: &'a [f64],
}

impl<'a> RowEntry<'a> {
    fn new(row: &'a Row) -> Self {
        let Row { depth, line } = row;
        Self { depth: *depth, x: &line.position, wheel: &line.wheel, rail: &line.rail }
    }
}
