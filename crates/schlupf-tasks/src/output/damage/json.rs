//! Damage over a run as JSON, for other programs.

use schlupf::Status;
use schlupf::analysis::damage::{CrackFunction, Laws, Profile, RunDamage, WearMap};
use schlupf::reporting::Message;
use serde::Serialize;

use super::{DamageReport, LeftOut};
use crate::output::json::{PROGRAM, text};
use crate::output::report::Report;
use crate::output::table::Arrays;

/// The damage as a JSON document: SI units.
pub fn document(report: &DamageReport) -> String {
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: report.status(),
        laws: LawsEntry::of(&report.laws),
        run: &report.damage,
        left_out: report.left_out,
        profile: Arrays(&report.damage.profile),
        warnings: &report.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    laws: LawsEntry,
    #[serde(flatten)]
    run: &'a RunDamage,
    left_out: LeftOut,
    profile: Arrays<'a, Profile>,
    warnings: &'a [Message],
}

/// The constants, under the names of their fields.
#[derive(Serialize)]
pub(crate) struct LawsEntry {
    shear_yield_stress: f64,
    hardness: f64,
    wear_map: WearMap,
    wear_rate_mild: f64,
    wear_rate_catastrophic: f64,
    cracks: CrackFunction,
    melting_temperature: f64,
    wheel_radius: f64,
    wheel_density: f64,
    rail_density: f64,
}

impl LawsEntry {
    pub(crate) fn of(laws: &Laws) -> Self {
        let Laws { fatigue, cracks, archard, energy, wheel_radius, densities, .. } = laws;
        Self {
            shear_yield_stress: fatigue.shear_yield_stress,
            hardness: archard.hardness,
            wear_map: archard.map.clone(),
            wear_rate_mild: energy.mild,
            wear_rate_catastrophic: energy.catastrophic,
            cracks: cracks.clone(),
            melting_temperature: laws.melting_temperature,
            wheel_radius: *wheel_radius,
            wheel_density: densities[0],
            rail_density: densities[1],
        }
    }
}
