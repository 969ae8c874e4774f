//! A comparison as JSON, for other programs.

use schlupf::bodies::Kinematics;
use schlupf::normal::NormalSummary;
use schlupf::reporting::{Column, Message, Record};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::Comparison;
use crate::output::json::{PROGRAM, text};
use crate::output::table::Entry;

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

#[derive(serde::Serialize)]
struct Document<'a> {
    program: &'static str,
    title: &'a str,
    normal: Option<&'a NormalSummary>,
    kinematics: Option<&'a Kinematics>,
    methods: Vec<Row<'a>>,
    warnings: &'a [Message],
}

#[derive(serde::Serialize)]
struct Row<'a> {
    name: &'static str,
    method: &'static str,
    elasticity: Option<&'static str>,
    normal_method: Option<&'static str>,
    status: &'static str,
    reason: Option<&'a str>,
    #[serde(flatten)]
    numbers: Nested<'a>,
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

/// The numbers of a method, with an object for every vector.
struct Nested<'a>(&'a Comparison, usize);

impl Serialize for Nested<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let vector =
            |column: &Column<Comparison>| column.quantity.vector().map(|(vector, _)| vector);
        for columns in Comparison::COLUMNS
            .chunk_by(|one, next| vector(one).is_some() && vector(one) == vector(next))
        {
            let entry = |column: &Column<Comparison>| Entry((column.value)(self.0, self.1));
            match vector(&columns[0]) {
                None => map.serialize_entry(columns[0].name, &entry(&columns[0]))?,
                Some(name) => {
                    let parts = columns
                        .iter()
                        .filter_map(|column| Some((column.quantity.vector()?.1, entry(column))));
                    map.serialize_entry(name, &Object(parts.collect()))?;
                }
            }
        }
        map.end()
    }
}

/// Entries with their names.
struct Object(Vec<(&'static str, Entry)>);

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, entry)| (name, entry)))
    }
}
