//! The contact alone: patch and pressure, without creepages and tractions.

use schlupf::interface::beyond_elastic;
use schlupf::normal::patch::Patch;
use schlupf::normal::{Grid, NormalContact, NormalSummary};
use schlupf::reporting::{Column, Message, Record, columns};
use schlupf::{Error, Options, Status, Watch};
use schlupf_case::CaseErrors;
use serde::Serialize;

use crate::output::figures::color::{BLUE, GREEN, MUTED, VERMILION};
use crate::output::figures::marks::Heading;
use crate::output::figures::panels::{self, Curve, Panel, Stack};
use crate::output::figures::{Drawing, FigureError};
use crate::output::json::{self, PROGRAM};
use crate::output::report::{reasons, verdict};
use crate::output::summary::{entry, line};
use crate::output::table::{self, Arrays, ColumnValues};
use crate::output::{Report, Summary, significant as number};
use crate::request::Nothing;
use crate::task::{Found, Given, Task, Wanted};
use crate::{TaskError, messages};

/// `patch`: of a history that with the largest load.
pub struct ContactPatch;

impl Task for ContactPatch {
    const NAME: &'static str = "patch";
    const ABOUT: &'static str = "Find the contact alone: its patch and its pressure";
    type Request = Nothing;
    type Report = PatchReport;

    fn run(
        of: &Given,
        _request: Nothing,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<PatchReport>, TaskError> {
        let (title, options) = (of.case.title()?, of.case.options()?);
        let explain = |error: Error| CaseErrors::from(of.case.explain(&error));
        let mut report = PatchReport {
            title,
            status: Status::Converged,
            contacts: Vec::new(),
            cells: Vec::new(),
            warnings: of.case.notices(),
        };
        // What the contacts of a wheel share of the force depends on friction.
        let is_wheel = of.case.wheel().is_ok();
        let wheel = if is_wheel { of.case.pose(watch)?.wheel } else { None };
        if let Some(wheel) = wheel {
            report.status = wheel.status();
            report.warnings.extend(messages(&wheel.warnings()));
            for contact in &wheel.contacts {
                let normal = contact.problem.normal.normal_contact(None).map_err(explain)?;
                let [x, y, z] = contact.position;
                let place = Place { position: Position { x, y, z }, angle: contact.angle };
                report.add(&normal, Some(place), &options).map_err(explain)?;
            }
        } else {
            let normal = of.case.normal_contact(watch)?;
            report.add(&normal, None, &options).map_err(explain)?;
        }
        let [wheel, rail] = of.case.materials();
        let largest = report.contacts.iter().map(|contact| contact.normal.peak_pressure);
        let warning = beyond_elastic([&wheel, &rail], largest.fold(0.0, f64::max));
        report.warnings.extend(messages(&warning));
        Ok(report.into())
    }
}

/// The contacts of a case, with their cells.
#[derive(Debug, Clone)]
pub struct PatchReport {
    /// Title of the case.
    pub title: String,
    /// Whether the contacts of a wheel were found.
    pub status: Status,
    /// Several with a wheel on a rail, the one with the largest normal force first.
    pub contacts: Vec<Contact>,
    /// The cells of all.
    pub cells: Vec<Cell>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// A contact.
#[derive(Debug, Clone, Serialize)]
pub struct Contact {
    /// Where it is in the track, if it is one of a wheel.
    #[serde(flatten)]
    pub place: Option<Place>,
    /// Its load, its size and its largest pressure.
    pub normal: NormalSummary,
    /// Area, in m².
    pub area: f64,
    /// Load over area, in Pa.
    pub mean_pressure: f64,
    /// Number of cells.
    pub cells: usize,
    /// y of each row of cells (in m), and the largest pressure in it (in Pa).
    #[serde(skip)]
    pub across: Vec<[f64; 2]>,
}

/// Where a contact of a wheel is.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Place {
    /// Its position in the track.
    pub position: Position,
    /// Angle of its plane, in rad.
    pub angle: f64,
}

/// A position in the track: forwards, to the left and upwards, in m.
#[derive(Debug, Clone, Copy, Serialize)]
#[allow(missing_docs, reason = "the coordinates")]
pub struct Position {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// A cell of a contact.
#[derive(Debug, Clone, Copy)]
pub struct Cell {
    /// Number of the contact, from one.
    pub contact: usize,
    /// Centroid of its covered part along rolling, in m.
    pub x: f64,
    /// Centroid of its covered part across rolling, in m.
    pub y: f64,
    /// Covered part, dimensionless.
    pub covered: f64,
    /// Mean pressure over the whole cell, in Pa.
    pub pressure: f64,
}

impl PatchReport {
    /// Adds a contact, on the cells of the solver.
    fn add(
        &mut self,
        normal: &NormalContact,
        place: Option<Place>,
        options: &Options,
    ) -> Result<(), Error> {
        let grid = Grid::across(&normal.extent(), options.cells_x, options.cells_y);
        let (patch, summary) = (Patch::new(normal, grid), normal.summary);
        let area = patch.cells.iter().map(|cell| cell.covered).sum::<f64>() * grid.cell_area();
        let mean_pressure = summary.load / area;
        if !mean_pressure.is_finite() {
            let semi_axes = summary.semi_axes();
            return Err(Error::NoPressure { load: summary.load, semi_axes });
        }
        let mut across: Vec<_> = (0..grid.rows).map(|row| [grid.y(row), 0.0]).collect();
        for cell in &patch.cells {
            let [_, largest] = &mut across[cell.index / grid.columns];
            *largest = cell.pressure.max(*largest);
        }
        let (normal, cells) = (summary, patch.len());
        self.contacts.push(Contact { place, normal, area, mean_pressure, cells, across });
        let contact = self.contacts.len();
        self.cells.extend(patch.cells.iter().map(|cell| {
            let schlupf::normal::patch::Cell { x, y, covered, pressure, .. } = *cell;
            Cell { contact, x, y, covered, pressure }
        }));
        Ok(())
    }

    /// The pressure across every contact, the largest one in each row of its cells.
    fn across(&self) -> String {
        const COLORS: [&str; 4] = [BLUE, VERMILION, GREEN, MUTED];
        let curve = |((k, contact), color): ((usize, &Contact), &&str)| {
            let points = contact.across.iter().map(|[y, p]| [y / 1e-3, p / 1e6]).collect();
            let is_one = self.contacts.len() == 1;
            let name = if is_one { String::new() } else { format!("contact {}", k + 1) };
            Curve::solid(points, color, &name)
        };
        let contacts = self.contacts.iter().enumerate();
        let curves: Vec<Curve> = contacts.zip(COLORS.iter().cycle()).map(curve).collect();
        let widest = curves.iter().flat_map(|curve| &curve.points);
        let widest = widest.fold(0.0, |widest: f64, point| widest.max(point[0].abs()));
        let panel = Panel::new("$p$_n (MPa)", 280.0, curves);
        let stack = Stack::over([-widest, widest], "$y$ (mm)", vec![panel]);
        let about = "the largest one in each row of cells".to_owned();
        let title = "Normal pressure across rolling";
        panels::page(&Heading::new(title, &self.title, about, self.status), &[stack])
    }
}

/// A row for each cell.
impl Record for PatchReport {
    fn rows(&self) -> usize {
        self.cells.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { PatchReport:
        ContactNumber "contact" => |report, k| report.cells[k].contact,
        X => |report, k| report.cells[k].x,
        Y => |report, k| report.cells[k].y,
        Covered => |report, k| report.cells[k].covered,
        Pressure => |report, k| report.cells[k].pressure,
    };
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    contacts: &'a [Contact],
    cells: Arrays<'a, PatchReport>,
    warnings: &'a [Message],
}

impl Contact {
    /// Its lines of the summary.
    fn summarise(&self, text: &mut Summary) {
        let NormalSummary {
            load, semi_axis_x, semi_axis_y, peak_pressure, approach, parts, ..
        } = self.normal;
        entry(text, "load", load / 1e3, "kN", "");
        let across = format!("along rolling, {} mm across", number(semi_axis_y / 1e-3));
        entry(text, "semi-axes", semi_axis_x / 1e-3, "mm", &across);
        if parts > 1 {
            let remark = "separate; the semi-axes are half the extent of all together";
            entry(text, "parts of the patch", parts as f64, "", remark);
        }
        let cells = format!("in {} cells", self.cells);
        entry(text, "contact area", self.area / 1e-6, "mm²", &cells);
        entry(text, "largest pressure", peak_pressure / 1e6, "MPa", "");
        entry(text, "mean pressure", self.mean_pressure / 1e6, "MPa", "");
        if let Some(approach) = approach {
            entry(text, "approach", approach / 1e-3, "mm", "");
        }
    }
}

impl Report for PatchReport {
    fn status(&self) -> Status {
        self.status
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        json::text(&Document {
            program: PROGRAM,
            title: &self.title,
            status: self.status,
            contacts: &self.contacts,
            cells: Arrays(self),
            warnings: &self.warnings,
        })
    }

    fn summary(&self) -> Summary {
        let mut text = Summary::titled(&self.title);
        for (k, contact) in self.contacts.iter().enumerate() {
            text.blank();
            if let Some(Place { position: Position { x, y, z }, angle }) = contact.place {
                let [x, y, z] = [x, y, z].map(|part| number(1e3 * part));
                let place = format!("rad; at x = {x} mm, y = {y} mm, z = {z} mm in the track");
                entry(&mut text, &format!("contact {}, angle", k + 1), angle, "", &place);
            }
            contact.summarise(&mut text);
        }
        text.blank();
        line(&mut text, verdict(self.status));
        for reason in reasons(&self.warnings) {
            line(&mut text, &format!("  {reason}"));
        }
        text
    }

    fn csv(&self) -> Option<String> {
        Some(table::csv(self, "x and y in the frame of each contact"))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        vec![("cells", table::columns(self))]
    }

    fn figure_names() -> Vec<String> {
        vec![FIGURE.to_owned()]
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        Ok(vec![(FIGURE.to_owned(), self.across())])
    }
}

const FIGURE: &str = "pressure_across";
