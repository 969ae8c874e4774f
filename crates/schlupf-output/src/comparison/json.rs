//! A comparison as JSON, for other programs.

use serde::Serialize;

use super::{Comparison, Entry};
use crate::json::status;
use crate::json::{Kinematics, Normal, PROGRAM, Vector, text};

/// All methods as a JSON document: SI units, forces on the wheel. What a method does not know is `null`.
pub fn document(comparison: &Comparison) -> String {
    let first = comparison.entries.first();
    text(&Document {
        program: PROGRAM,
        title: &comparison.title,
        normal: first.map(|entry| (&entry.solution.normal).into()),
        kinematics: first.map(|entry| (&entry.solution.kinematics).into()),
        methods: comparison.entries.iter().map(Row::new).collect(),
        warnings: comparison.entries.iter().flat_map(Entry::warnings).collect(),
    })
}

#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    normal: Option<Normal>,
    kinematics: Option<Kinematics>,
    methods: Vec<Row>,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct Row {
    name: &'static str,
    method: &'static str,
    elasticity: Option<&'static str>,
    status: &'static str,
    force: Vector,
    normalised: Vector,
    traction_coefficient: f64,
    creep_power: f64,
    max_rise: f64,
    time: f64,
    time_again: f64,
}

impl Row {
    fn new(entry: &Entry) -> Self {
        let solution = &entry.solution;
        Self {
            name: entry.name,
            method: solution.method.name(),
            elasticity: entry.elasticity,
            status: status(solution.status),
            force: solution.force.into(),
            normalised: solution.normalised.into(),
            traction_coefficient: solution.traction_coefficient,
            creep_power: solution.power.creep,
            max_rise: solution.temperature.max_rise,
            time: entry.time,
            time_again: entry.time_again,
        }
    }
}
