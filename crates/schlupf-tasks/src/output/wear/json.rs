//! The damage per wheel passage as JSON, for other programs.

use schlupf::Status;
use schlupf::analysis::damage::{Passage, PassageProfile, WearCells};
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use schlupf::solution::Resultant;
use serde::Serialize;

use super::WearReport;
use crate::output::damage::json::LawsEntry;
use crate::output::json::{KinematicsEntry, PROGRAM, text};
use crate::output::table::Arrays;

/// The damage as a JSON document: SI units.
pub(super) fn document(report: &WearReport) -> String {
    let solution = &report.solution;
    let wear = report.passage.wear.as_ref();
    text(&Document {
        program: PROGRAM,
        title: &report.title,
        status: solution.status,
        kinematics: KinematicsEntry::of(&solution.kinematics),
        normal: &solution.normal,
        force: &solution.force,
        laws: LawsEntry::of(&report.laws),
        passage: &report.passage,
        profile: wear.map(|wear| Arrays(&wear.profile)),
        cells: wear.map(|wear| Arrays(&wear.cells)),
        warnings: &report.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    status: Status,
    kinematics: KinematicsEntry,
    normal: &'a NormalSummary,
    force: &'a Resultant,
    laws: LawsEntry,
    #[serde(flatten)]
    passage: &'a Passage,
    profile: Option<Arrays<'a, PassageProfile>>,
    cells: Option<Arrays<'a, WearCells>>,
    warnings: &'a [Message],
}
