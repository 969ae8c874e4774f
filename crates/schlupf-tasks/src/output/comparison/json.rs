//! A comparison as JSON, for other programs.

use schlupf::bodies::Kinematics;
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use serde::Serialize;

use super::Comparison;
use crate::output::json::{PROGRAM, text};
use crate::output::table::Nested;

/// All methods as a JSON document: SI units, forces on the wheel. Unknown quantities are `null`, as
/// are all numbers of a method without an answer.
pub(super) fn document(comparison: &Comparison) -> String {
    let first = comparison.answers().next();
    text(&Document {
        program: PROGRAM,
        title: &comparison.title,
        normal: first.map(|answer| &answer.solution.normal),
        kinematics: first.map(|answer| &answer.solution.kinematics),
        methods: (0..comparison.entries.len()).map(|row| Row::new(comparison, row)).collect(),
        warnings: &comparison.warnings,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    normal: Option<&'a NormalSummary>,
    kinematics: Option<&'a Kinematics>,
    methods: Vec<Row<'a>>,
    warnings: &'a [Message],
}

#[derive(Serialize)]
struct Row<'a> {
    name: &'static str,
    method: &'static str,
    elasticity: Option<&'static str>,
    normal_method: Option<&'static str>,
    status: &'static str,
    reason: Option<&'a str>,
    #[serde(flatten)]
    numbers: Nested<'a, Comparison>,
}

impl<'a> Row<'a> {
    fn new(comparison: &'a Comparison, row: usize) -> Self {
        let entry = &comparison.entries[row];
        Self {
            name: entry.name,
            method: entry.method,
            elasticity: entry.elasticity,
            normal_method: entry.normal,
            status: entry.status(),
            reason: entry.reason(),
            numbers: Nested(comparison, row),
        }
    }
}
