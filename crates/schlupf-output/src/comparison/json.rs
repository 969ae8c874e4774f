//! A comparison as JSON, for other programs.

use schlupf::kinematics::Kinematics;
use schlupf::message::Message;
use schlupf::normal::NormalSummary;
use schlupf::solution::Resultant;
use serde::Serialize;

use super::{Comparison, Entry};
use crate::json::{PROGRAM, text};

/// All methods as a JSON document: SI units, forces on the wheel. What a method does not know is `null`,
/// all numbers where it has no answer.
pub(super) fn document(comparison: &Comparison) -> String {
    let first = comparison.answers().next();
    text(&Document {
        program: PROGRAM,
        title: &comparison.title,
        normal: first.map(|answer| &answer.solution.normal),
        kinematics: first.map(|answer| &answer.solution.kinematics),
        methods: comparison.entries.iter().map(Row::new).collect(),
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
    status: &'static str,
    reason: Option<&'a str>,
    force: Vector,
    normalised: Vector,
    traction_coefficient: Option<f64>,
    creep_power: Option<f64>,
    max_rise: Option<f64>,
    time: Option<f64>,
    time_again: Option<f64>,
}

#[derive(Default, Serialize)]
struct Vector {
    x: Option<f64>,
    y: Option<f64>,
    moment_z: Option<f64>,
}

impl From<&Resultant> for Vector {
    fn from(force: &Resultant) -> Self {
        Self { x: Some(force.x), y: Some(force.y), moment_z: Some(force.moment_z) }
    }
}

impl<'a> Row<'a> {
    fn new(entry: &'a Entry) -> Self {
        let answer = entry.answer.as_ref().ok();
        let solution = answer.map(|answer| &answer.solution);
        let vector = |force: Option<&Resultant>| force.map(Vector::from).unwrap_or_default();
        Self {
            name: entry.name,
            method: entry.method,
            elasticity: entry.elasticity,
            status: entry.status(),
            reason: entry.reason(),
            force: vector(solution.map(|solution| &solution.force)),
            normalised: vector(solution.map(|solution| &solution.normalised)),
            traction_coefficient: solution.map(|solution| solution.traction_coefficient),
            creep_power: solution.map(|solution| solution.power.creep),
            max_rise: solution.map(|solution| solution.temperature.max_rise),
            time: answer.map(|answer| answer.time),
            time_again: answer.map(|answer| answer.time_again),
        }
    }
}
