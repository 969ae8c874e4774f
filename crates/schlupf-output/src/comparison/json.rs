//! A comparison as JSON, for other programs.

use serde::Serialize;

use schlupf::solution::Resultant;

use super::{Answer, Comparison, Entry};
use crate::json::{Kinematics, Normal, PROGRAM, Vector, text};

/// All methods as a JSON document: SI units, forces on the wheel. What a method does not know is `null`, all
/// numbers where it has no answer.
pub fn document(comparison: &Comparison) -> String {
    let first = comparison.answers().next();
    text(&Document {
        program: PROGRAM,
        title: &comparison.title,
        normal: first.map(|answer| (&answer.solution.normal).into()),
        kinematics: first.map(|answer| (&answer.solution.kinematics).into()),
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
    methods: Vec<Row<'a>>,
    warnings: Vec<String>,
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
    traction_coefficient: f64,
    creep_power: f64,
    max_rise: f64,
    time: f64,
    time_again: f64,
}

const UNKNOWN: Resultant = Resultant { x: f64::NAN, y: f64::NAN, moment_z: f64::NAN };

impl<'a> Row<'a> {
    fn new(entry: &'a Entry) -> Self {
        let answer = entry.answer.as_ref();
        let number = |value: fn(&Answer) -> f64| answer.map_or(f64::NAN, value);
        Self {
            name: entry.name,
            method: entry.method,
            elasticity: entry.elasticity,
            status: entry.status(),
            reason: entry.reason(),
            force: answer.map_or(UNKNOWN, |answer| answer.solution.force).into(),
            normalised: answer.map_or(UNKNOWN, |answer| answer.solution.normalised).into(),
            traction_coefficient: number(|answer| answer.solution.traction_coefficient),
            creep_power: number(|answer| answer.solution.power.creep),
            max_rise: number(|answer| answer.solution.temperature.max_rise),
            time: number(|answer| answer.time),
            time_again: number(|answer| answer.time_again),
        }
    }
}
