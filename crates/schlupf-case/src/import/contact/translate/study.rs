//! Cases that differ in numbers only, as studies: one case, and a table of what differs.

use std::fmt::Write;

use super::all::ImportedCase;
use crate::import::document::{Document, Field, quoted};

/// A study.
#[derive(Debug, Clone)]
pub struct ImportedStudy {
    /// The first of its cases, which the study names.
    pub case: ImportedCase,
    /// Numbers of all of its cases in the input file, in the order of its rows.
    pub numbers: Vec<usize>,
    /// Name of the study, and its text.
    pub study: (String, String),
    /// Name of the table of states, and its text.
    pub states: (String, String),
}

/// Cases and studies.
#[derive(Debug, Clone, Default)]
pub struct Grouped {
    /// Cases that differ from all others in more than numbers.
    pub cases: Vec<ImportedCase>,
    /// The others, in the order of their first cases.
    pub studies: Vec<ImportedStudy>,
}

/// Puts the cases together that differ in numbers only, whatever comes between them.
pub fn grouped(cases: Vec<ImportedCase>) -> Grouped {
    let mut groups: Vec<Vec<ImportedCase>> = Vec::new();
    for case in cases {
        let like = |group: &&mut Vec<ImportedCase>| {
            group.first().is_some_and(|first| is_like(&first.document, &case.document))
        };
        match groups.iter_mut().find(like) {
            Some(group) => group.push(case),
            None => groups.push(vec![case]),
        }
    }
    let mut grouped = Grouped::default();
    for mut group in groups {
        match study(&group) {
            Some(study) => grouped.studies.push(study),
            None => grouped.cases.append(&mut group),
        }
    }
    grouped
}

/// Whether two cases have the same fields with the same values, numbers aside.
fn is_like(one: &Document, other: &Document) -> bool {
    let (one, other) = (one.fields(), other.fields());
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.is_like(other))
}

/// The study of some cases, the first of which it names; none where nothing varies.
fn study(cases: &[ImportedCase]) -> Option<ImportedStudy> {
    let case = cases.first()?.clone();
    let numbers: Vec<usize> = cases.iter().flat_map(|case| case.numbers.clone()).collect();
    let columns: Vec<usize> = (0..case.document.fields().len())
        .filter(|place| {
            let of = |case: &ImportedCase| case.document.fields().get(*place).cloned();
            cases.iter().any(|other| of(other) != of(&case))
        })
        .collect();
    if columns.is_empty() {
        return None;
    }
    let stem = case.name.trim_end_matches(".toml");
    let (study, states) = (format!("{stem}_study.toml"), format!("{stem}_states.csv"));
    let of = ranges(&numbers);
    let mut text = format!("# A row for each of the cases {of} of an input of CONTACT.\n");
    // Writing to a string cannot fail.
    let [of_case, of_states] = [&case.name, &states].map(|name| quoted(name));
    let _ = write!(text, "\ncase = {of_case}\n\n[states]\nfile = {of_states}\n");
    let states = (states, table(cases, &columns));
    Some(ImportedStudy { study: (study, text), case, numbers, states })
}

/// Ascending numbers, with runs of them as ranges.
pub fn ranges(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [first, .., last] => format!("{first}–{last}"),
        run => run.iter().map(ToString::to_string).collect(),
    });
    runs.collect::<Vec<_>>().join(", ")
}

/// The numbers of some fields, by their places, a row for each case.
fn table(cases: &[ImportedCase], columns: &[usize]) -> String {
    let row = |case: &ImportedCase, cell: &dyn Fn(&Field) -> String| {
        let fields = case.document.fields();
        let cells: Vec<String> =
            columns.iter().filter_map(|place| fields.get(*place)).map(cell).collect();
        cells.join(",") + "\n"
    };
    let head = |field: &Field| match &field.number {
        Some((_, unit)) if !unit.is_empty() => format!("{} [{unit}]", field.path),
        _ => field.path.to_string(),
    };
    let number = |field: &Field| {
        field.number.as_ref().map_or_else(String::new, |(number, _)| number.clone())
    };
    let head = cases.first().map_or_else(String::new, |case| row(case, &head));
    cases.iter().fold(head, |text, case| text + &row(case, &number))
}
