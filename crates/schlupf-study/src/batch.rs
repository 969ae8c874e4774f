//! A batch of rows: the work of one thread, whose results depend on nothing else.

use std::collections::HashMap;

use schlupf::{Solution, Warning, Watch};
use schlupf_case::Case;
use schlupf_tasks::states::{CONTACTS, NoState, StateSolver};

use crate::chunks;
use crate::columns::{Outcome, Row, push};
use crate::design::Entry;
use crate::error::StudyError;
use crate::order::groups;
use crate::study::Study;
use crate::table::{Cells, Column, Contents, Rows};

/// Solves the rows of a batch, and the fields of their cells if the study keeps them.
pub(crate) fn solve(
    study: &Study,
    contents: &Contents,
    batch: usize,
    watch: Watch,
) -> Result<(Rows, Option<Rows>), StudyError> {
    let indices = contents.rows_of(batch);
    let entries: Vec<Vec<Entry>> = indices.clone().map(|row| study.design.row(row)).collect();
    let fields = study.design.varied().iter().map(|varied| varied.field).collect();
    let mut solver = StateSolver::new(study.case.clone(), fields);
    let is_condition = entries.first().map_or_else(Vec::new, |entries| solver.conditions(entries));
    let mut outcomes: HashMap<usize, Outcome> = HashMap::with_capacity(entries.len());
    for member in groups(&entries, &is_condition).into_iter().flatten() {
        let name = format!("row {}", indices.start + member);
        let outcome = match solver.solve(&entries[member], &name, watch) {
            Ok((case, solution)) => solved(case, solution),
            Err(NoState::NoContact) => Outcome::NoContact,
            Err(NoState::Failed(errors)) => Outcome::Failed(errors.first.message),
            Err(NoState::Stopped) => return Err(StudyError::Stopped),
        };
        outcomes.insert(member, outcome);
    }
    let mut rows = empty(&contents.columns);
    let mut fields: Option<Rows> =
        study.fields.as_ref().map(|fields| empty(&chunks::columns(fields)));
    let has_wheel = study.has_wheel();
    for (k, (index, entries)) in indices.zip(&entries).enumerate() {
        let outcome = outcomes.remove(&k);
        let outcome = outcome.unwrap_or_else(|| Outcome::Failed("not solved".to_owned()));
        let carried = study.design.carried().iter().map(|column| column.values[index]).collect();
        push(&mut rows, &Row { index, carried, entries, has_wheel, outcome: &outcome });
        if let (Some(cells), Some(fields), Outcome::Solved { solution, .. }) =
            (&mut fields, &study.fields, &outcome)
        {
            chunks::push(cells, fields, index, solution);
        }
    }
    Ok((rows, fields))
}

fn empty(columns: &[Column]) -> Rows {
    columns.iter().map(|column| Cells::empty(column.kind)).collect()
}

fn solved(case: &Case, solution: Solution) -> Outcome {
    let wheel = case.wheel.clone();
    let mut codes: Vec<&'static str> = solution.warnings.iter().map(Warning::code).collect();
    if let Some(wheel) = &wheel {
        let others = wheel.contacts.iter().skip(1).flat_map(|of| &of.solution.warnings);
        codes.extend(wheel.warnings().iter().chain(others).map(Warning::code));
        codes.extend((wheel.contacts.len() > CONTACTS).then_some(MORE_CONTACTS));
    }
    codes.sort_unstable();
    codes.dedup();
    Outcome::Solved { solution: Box::new(solution), wheel, codes }
}

/// The code of a row of a wheel that has more contacts than the table.
pub(crate) const MORE_CONTACTS: &str = "more-contacts";
