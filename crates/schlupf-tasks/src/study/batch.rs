//! A batch of rows: the work of one thread, whose results depend on nothing else.

use std::collections::HashMap;

use crate::messages;
use crate::states::{self, CONTACTS, NoState, StateSolver};
use schlupf::reporting::{Message, Tally};
use schlupf::{Solution, Watch};
use schlupf_case::{Case, field};

use crate::study::chunks;
use crate::study::columns::{Outcome, Row, push};
use crate::study::design::Entry;
use crate::study::error::StudyError;
use crate::study::order::groups;
use crate::study::plan::Study;
use crate::study::solved::Solved;
use crate::study::table::{Cells, Column, Contents, Rows};

/// Solves the rows of a batch, and the fields of their cells if the study keeps them.
pub(crate) fn solve(
    study: &Study,
    contents: &Contents,
    batch: usize,
    watch: Watch,
) -> Result<Solved, StudyError> {
    let indices = contents.rows_of(batch);
    let entries: Vec<Vec<Entry>> = indices.clone().map(|row| study.design.row(row)).collect();
    let varied: Vec<_> = study.design.varied().iter().map(|varied| varied.field).collect();
    let mut solver = StateSolver::new(study.case.clone(), varied.clone());
    let is_condition = entries.first().map_or_else(Vec::new, |entries| solver.conditions(entries));
    let mut outcomes: HashMap<usize, Outcome> = HashMap::with_capacity(entries.len());
    for member in groups(&entries, &is_condition).into_iter().flatten() {
        let name = format!("row {}", indices.start + member);
        let outcome = match solver.solve(&entries[member], &name, watch) {
            Ok((case, solution)) => {
                let notices = states::notices(case, &varied, &entries[member], &name);
                solved(case, solution, notices)
            }
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
    let mut warnings = Tally::default();
    for (k, (index, entries)) in indices.zip(&entries).enumerate() {
        let outcome = outcomes.remove(&k);
        let outcome = outcome.unwrap_or_else(|| Outcome::Failed("not solved".to_owned()));
        let carried = study.design.carried().iter().map(|column| column.values[index]).collect();
        if let Outcome::Solved { warnings: of_row, .. } = &outcome {
            for warning in of_row {
                warnings.note(warning.clone(), index);
            }
        }
        push(&mut rows, &Row { index, carried, entries, has_wheel, outcome: &outcome });
        if let (Some(cells), Some(fields), Outcome::Solved { solution, .. }) =
            (&mut fields, &study.fields, &outcome)
        {
            chunks::push(cells, fields, index, solution);
        }
    }
    Ok(Solved { rows, fields, warnings })
}

fn empty(columns: &[Column]) -> Rows {
    columns.iter().map(|column| Cells::empty(column.kind)).collect()
}

fn solved(case: &Case, solution: Solution, notices: Vec<Message>) -> Outcome {
    let wheel = case.wheel.clone();
    let mut warnings: Tally<Message, usize> = Tally::default();
    let mut note = |message: Message| warnings.note(message, 0);
    notices.into_iter().chain(messages(&solution.warnings)).for_each(&mut note);
    if let Some(wheel) = &wheel {
        messages(&wheel.further_warnings()).for_each(&mut note);
        let count = wheel.contacts.len();
        if count > CONTACTS {
            let text = format!("the wheel has {count} contacts, the table columns for {CONTACTS}");
            note(
                Message::new(MORE_CONTACTS, field!("normal.model").as_str(), text)
                    .graded(count as f64),
            );
        }
    }
    let warnings = warnings.into_iter().map(|of_row| of_row.worst).collect();
    Outcome::Solved { solution: Box::new(solution), wheel, warnings }
}

/// The code of a row of a wheel that has more contacts than the table.
pub(crate) const MORE_CONTACTS: &str = "more-contacts";
