//! Temperatures of wheel and rail below a point, and along its row with the wake: CSV, JSON and a
//! summary. The figure is among the figures.

mod figure;
mod json;
mod summary;

use schlupf::Quantity;
use schlupf::analysis::temperature_field::{Side, TemperatureField};
use schlupf::reporting::{Column, Message, Record, columns};
use schlupf::solution::Status;
use schlupf_case::Points;

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::Report;
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues, Table, Values, entries, entry};

/// Name of the figure.
const FIGURE: &str = "temperature";

/// Positions at which temperatures are requested.
#[derive(Debug, Clone, PartialEq)]
pub struct Positions {
    /// The point (x, y), in m.
    pub point: [f64; 2],
    /// Positions where its row enters and leaves the contact, x in m.
    pub passage: [f64; 2],
    /// Depths of the profile below the point, in m.
    pub depths: Vec<f64>,
    /// Length of the row behind the contact, in m.
    pub wake: f64,
    /// Depths of the row below the surface, in m; the surface is always included.
    pub row_depths: [f64; 2],
    /// Number of points of a row, at least two.
    pub points: usize,
}

/// Temperatures along a line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Line {
    /// Positions, in m: depths, or x of a row.
    pub position: Vec<f64>,
    /// Temperature of the wheel, in degC.
    pub wheel: Vec<f64>,
    /// Temperature of the rail, in degC.
    pub rail: Vec<f64>,
}

impl Line {
    /// Its columns, with the places of its points.
    fn columns(&self, place: Quantity) -> Vec<ColumnValues> {
        let values = Values::Numbers(self.position.clone());
        let places = ColumnValues { name: place.name(), quantity: place, values };
        std::iter::once(places).chain(table::columns(self)).collect()
    }

    /// Samples the temperatures at positions; `place` converts them to x, y and depth.
    fn sample(
        field: &TemperatureField,
        position: Vec<f64>,
        place: impl Fn(f64) -> [f64; 3],
    ) -> Self {
        let of = |side| {
            let value = |s: &f64| {
                let [x, y, depth] = place(*s);
                field.at(side, x, y, depth)
            };
            position.iter().map(value).collect()
        };
        Self { wheel: of(Side::Wheel), rail: of(Side::Rail), position }
    }
}

/// Temperatures along a row of the patch and its wake, at a depth.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Depth below the surface, in m.
    pub depth: f64,
    /// Temperatures against x.
    pub line: Line,
}

/// The requested temperatures.
#[derive(Debug, Clone)]
pub struct Temperatures {
    /// Title of the case.
    pub title: String,
    /// Whether the solution that they belong to converged.
    pub status: Status,
    /// Their positions.
    pub request: Positions,
    /// Bulk temperatures of wheel and rail, in degC.
    pub bulk: [f64; 2],
    /// Below the point, against the depth.
    pub profile: Line,
    /// Along the row: on the surface, and below it.
    pub rows: Vec<Row>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// Fraction of the row ahead of the contact, where the bodies still have their bulk temperatures.
const AHEAD: f64 = 0.08;

impl Temperatures {
    /// The profile below the point and the rows, from a field.
    pub fn sample(field: &TemperatureField, request: &Positions) -> (Line, Vec<Row>) {
        let Positions { point: [x, y], passage: [entry, exit], wake, points, .. } = *request;
        let profile = Line::sample(field, request.depths.clone(), |z| [x, y, z]);
        let range = [exit - wake, entry + AHEAD * (entry - exit)];
        let row = |depth: f64| Row {
            depth,
            line: Line::sample(field, row_positions(range, [exit, entry], points), |x| {
                [x, y, depth]
            }),
        };
        let depths = std::iter::once(0.0).chain(request.row_depths);
        (profile, depths.map(row).collect())
    }
}

/// Equidistant, plus points on both sides of the edges, where the temperature has a kink or a jump.
fn row_positions(range: [f64; 2], edges: [f64; 2], points: usize) -> Vec<f64> {
    let mut positions = Points::Range(range).evenly(points);
    let nearby = 1e-9 * (range[1] - range[0]);
    for edge in edges.into_iter().filter(|edge| (range[0]..range[1]).contains(edge)) {
        positions.extend([edge - nearby, edge + nearby]);
    }
    positions.sort_unstable_by(f64::total_cmp);
    positions
}

/// Temperatures along a line.
impl Record for Line {
    fn rows(&self) -> usize {
        self.position.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Line:
        WheelTemperature => |line, k| line.wheel[k],
        RailTemperature => |line, k| line.rail[k],
    };
}

impl Report for Temperatures {
    fn status(&self) -> Status {
        self.status
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

    /// Starts with the points of the profile below the point.
    fn csv(&self) -> Option<String> {
        let places = Table::default().with("line", "profile or row").with("x", "m").with("y", "m");
        let mut table = places.with("depth", "m").with_columns::<Line>();
        let [x, y] = self.request.point;
        push(&mut table, "profile", &self.profile, |depth| [x, y, depth]);
        for row in &self.rows {
            push(&mut table, "row", &row.line, |x| [x, y, row.depth]);
        }
        Some(table.csv(""))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        let rows = self.rows.iter().map(|row| ("rows", row.line.columns(Quantity::X)));
        let profile = ("profile", self.profile.columns(Quantity::Depth));
        std::iter::once(profile).chain(rows).collect()
    }

    fn figure_names() -> Vec<String> {
        vec![FIGURE.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let svg = figure::draw(self).ok_or(FigureError::NoTemperature)?;
        Ok(vec![(FIGURE.to_owned(), svg)])
    }
}

fn push(table: &mut Table, name: &str, line: &Line, place: impl Fn(f64) -> [f64; 3]) {
    for (k, position) in line.position.iter().enumerate() {
        let place = place(*position).map(|number| entry(number.into()));
        table.push([name.to_owned()].into_iter().chain(place).chain(entries(line, k)));
    }
}
