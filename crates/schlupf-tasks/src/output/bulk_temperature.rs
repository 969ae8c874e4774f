//! The long-term bulk temperature of a wheel: a summary, and JSON.

use std::f64::consts::TAU;

use serde::Serialize;

use schlupf::analysis::bulk_temperature::{BulkTemperature, Cooling};
use schlupf::bodies::ReferencePoint;
use schlupf::reporting::Message;
use schlupf::solution::Status;

use crate::output::figures::{self, Drawing, FigureError};
use crate::output::json::{self, PROGRAM};
use crate::output::number::significant as number;
use crate::output::report::{Report, reasons, verdict};
use crate::output::summary::{Summary, entry, friction_power, line, without_noise};
use crate::output::table;

/// The heat balance of a wheel, with its input.
#[derive(Debug, Clone)]
pub struct BulkReport {
    /// Title of the case.
    pub title: String,
    /// The cooling of the wheel.
    pub cooling: Cooling,
    /// Bulk temperature of the rail, in degC.
    pub rail_temperature: f64,
    /// Rolling radius of the wheel (in m), if it has one.
    pub wheel_radius: Option<f64>,
    /// The balance.
    pub balance: BulkTemperature,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

impl BulkReport {
    /// Duration of a revolution, in s.
    fn revolution(&self) -> Option<f64> {
        let solution = &self.balance.solution;
        let (motion, _) = solution.seen_from(ReferencePoint::Patch)?;
        let speed = motion.circumferential_speed();
        self.wheel_radius.map(|radius| TAU * radius / speed)
    }
}

/// The balance as a JSON document: SI units, temperatures in degC.
fn document(report: &BulkReport) -> String {
    let BulkReport { balance, cooling, .. } = report;
    let flows = Flows {
        frictional: balance.frictional_heat,
        convection: balance.convection,
        conduction: balance.conduction,
        surplus: balance.surplus(),
    };
    json::text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: balance.solution.status,
        temperature: Temperatures {
            wheel: balance.temperature,
            rail: report.rail_temperature,
            air: cooling.air_temperature,
            entry: balance.entry_temperature,
        },
        cooling: CoolingEntry { film_coefficient: cooling.film_coefficient, area: cooling.area },
        heat_per_revolution: report.revolution().map(|time| flows.times(time)),
        heat: flows,
        iterations: balance.iterations,
        solution: json::Document::new(&report.title, &balance.solution, &report.warnings),
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    temperature: Temperatures,
    cooling: CoolingEntry,
    heat: Flows,
    heat_per_revolution: Option<Flows>,
    iterations: usize,
    solution: json::Document<'a>,
}

/// In degC.
#[derive(Serialize)]
struct Temperatures {
    wheel: f64,
    rail: f64,
    air: f64,
    entry: f64,
}

#[derive(Serialize)]
struct CoolingEntry {
    film_coefficient: f64,
    area: f64,
}

/// Heat flows of the wheel in W, or in J per revolution.
#[derive(Serialize)]
struct Flows {
    frictional: f64,
    convection: f64,
    conduction: f64,
    surplus: f64,
}

impl Flows {
    fn times(&self, time: f64) -> Self {
        Self {
            frictional: self.frictional * time,
            convection: self.convection * time,
            conduction: self.conduction * time,
            surplus: self.surplus * time,
        }
    }
}

/// The balance as text: temperatures, heat received and lost, forces, status and warnings.
fn text(report: &BulkReport) -> Summary {
    let mut text = Summary::titled(&report.title);
    text.blank();
    temperatures(&mut text, report);
    heat(&mut text, report);
    forces(&mut text, report);
    status(&mut text, report);
    text
}

fn temperatures(text: &mut Summary, report: &BulkReport) {
    let BulkReport { balance, cooling, .. } = report;
    let others = format!(
        "rail {} °C, air {} °C",
        number(report.rail_temperature),
        number(cooling.air_temperature)
    );
    entry(text, "bulk temp. of wheel", balance.temperature, "°C", &others);
    let remark = "to which both surfaces jump when they meet";
    entry(text, "temp. on entry", balance.entry_temperature, "°C", remark);
    let surface = balance.solution.temperature;
    let rail = format!("of the rail {} °C", number(surface.map(|surface| surface.max_rail)));
    entry(text, "hottest surface", surface.map(|surface| surface.max_wheel), "°C", &rail);
    text.blank();
}

fn heat(text: &mut Summary, report: &BulkReport) {
    let BulkReport { balance, cooling, .. } = report;
    let revolution = report.revolution();
    let mut flow = |name: &str, power: f64, remark: &str| {
        let work = revolution.map(|time| format!("{} J per revolution", number(power * time)));
        let parts: Vec<String> =
            work.into_iter().chain((!remark.is_empty()).then(|| remark.to_owned())).collect();
        entry(text, name, power / 1e3, "kW", &parts.join(", "));
    };
    let convection = format!("h A = {} W/K", number(cooling.film_coefficient * cooling.area));
    flow("frictional heat", balance.frictional_heat, "");
    flow("  to the air", balance.convection, &convection);
    flow("  to the rail", balance.conduction, "through the contact");
    text.blank();
}

fn forces(text: &mut Summary, report: &BulkReport) {
    let solution = &report.balance.solution;
    let x = without_noise(solution.force.x, solution.normalised.x);
    let y = without_noise(solution.force.y, solution.normalised.y);
    let lateral = format!("lateral {} kN, with the friction of the warm wheel", number(y / 1e3));
    entry(text, "longitudinal force", x / 1e3, "kN", &lateral);
    entry(text, "traction coefficient", solution.traction_coefficient, "", "|F|/N");
    friction_power(text, solution);
    text.blank();
}

fn status(text: &mut Summary, report: &BulkReport) {
    let balance = &report.balance;
    let verdict = verdict(balance.solution.status);
    let imbalance = balance.surplus() / 1e3;
    line(
        text,
        &format!(
            "{verdict}: {} kW left over after {} steady states",
            number(imbalance),
            balance.iterations
        ),
    );
    for reason in reasons(&report.warnings) {
        line(text, &format!("  {reason}"));
    }
}

impl Report for BulkReport {
    fn status(&self) -> Status {
        self.balance.solution.status
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        document(self)
    }

    fn summary(&self) -> Summary {
        text(self)
    }

    /// The fields of the contact in the long-term state.
    fn csv(&self) -> Option<String> {
        Some(table::csv(&self.balance.solution.fields, "contact of the warm wheel"))
    }

    fn figure_names() -> Vec<String> {
        figures::names()
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        figures::drawings(&self.title, &self.balance.solution)
    }
}
