//! A batch of rows: the work of one thread, whose results depend on nothing else.

use std::collections::HashMap;

use schlupf::kinematics::Kinematics;
use schlupf::{Error, Quantity, Watch};
use schlupf_case::{Case, CaseErrors, Cause, quantity_field};
use schlupf_tasks::loaded_solver::LoadedSolver;

use crate::chunks;
use crate::columns::{Outcome, Row, push};
use crate::design::{Entry, assignment};
use crate::error::StudyError;
use crate::order::groups;
use crate::study::Study;
use crate::table::{Cells, Column, Contents, Rows};

/// What a solver takes without another case.
const CONDITIONS: [Quantity; 4] =
    [Quantity::CreepageX, Quantity::CreepageY, Quantity::Spin, Quantity::Speed];

/// Solves the rows of a batch, and the fields of their cells if the study keeps them.
pub(crate) fn solve(
    study: &Study,
    contents: &Contents,
    batch: usize,
    watch: Watch,
) -> Result<(Rows, Option<Rows>), StudyError> {
    let indices = contents.rows_of(batch);
    let entries: Vec<Vec<Entry>> = indices.clone().map(|row| study.design.row(row)).collect();
    let varied = study.design.varied();
    let follows_wheel = follows_wheel(study);
    let conditions: Vec<Option<Quantity>> = varied
        .iter()
        .map(|varied| condition(varied.field.path))
        .map(|quantity| quantity.filter(|of| !follows_wheel || *of == Quantity::Spin))
        .collect();
    let is_condition: Vec<bool> = conditions.iter().map(Option::is_some).collect();
    let mut outcomes: HashMap<usize, Outcome> = HashMap::with_capacity(entries.len());
    for members in groups(&entries, &is_condition) {
        let group = Group { study, entries: &entries, conditions: &conditions, members: &members };
        group.solve(indices.start, watch, &mut outcomes)?;
    }
    let mut rows = empty(&contents.columns);
    let mut fields: Option<Rows> =
        study.fields.as_ref().map(|fields| empty(&chunks::columns(fields)));
    for (k, (index, entries)) in indices.zip(&entries).enumerate() {
        let outcome = outcomes.remove(&k);
        let outcome = outcome.unwrap_or_else(|| Outcome::Failed("not solved".to_owned()));
        let carried = study.design.carried().iter().map(|column| column.values[index]).collect();
        let row = Row { index, carried, entries, outcome: &outcome };
        push(&mut rows, &contents.columns, &row);
        if let (Some(cells), Some(fields), Outcome::Solved(solution)) =
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

/// Whether creepages follow from how the wheel turns, so that those of another speed or another
/// lateral creepage are only known to a case of its own.
fn follows_wheel(study: &Study) -> bool {
    const TURNING: [&str; 2] = ["kinematics.angular_velocity", "kinematics.yaw_angle"];
    let varied = study.design.varied().iter().map(|varied| varied.field.path);
    study.case.given().chain(varied).any(|path| TURNING.contains(&path))
}

/// The condition that a field gives, if a solver takes it without another case.
fn condition(path: &str) -> Option<Quantity> {
    CONDITIONS.into_iter().find(|quantity| quantity_field(*quantity) == path)
}

/// Rows of a batch that differ in conditions only, in the order in which they are solved.
struct Group<'a> {
    study: &'a Study,
    entries: &'a [Vec<Entry>],
    conditions: &'a [Option<Quantity>],
    members: &'a [usize],
}

impl Group<'_> {
    fn solve(
        &self,
        start: usize,
        watch: Watch,
        outcomes: &mut HashMap<usize, Outcome>,
    ) -> Result<(), StudyError> {
        let Some(first) = self.members.first() else { return Ok(()) };
        let Ok(case) = self.pose(*first, start, watch)? else {
            return self.alone(start, watch, outcomes);
        };
        // What the case makes of its creepages, say for another reference, it makes of each row.
        if self.kinematics(*first, &case.problem.kinematics) != case.problem.kinematics {
            return self.alone(start, watch, outcomes);
        }
        let mut solver = LoadedSolver::without_state(&case);
        for member in self.members {
            let kinematics = self.kinematics(*member, &case.problem.kinematics);
            let solved = solver.solve(&case, kinematics, None, watch);
            outcomes.insert(*member, outcome(&case, solved)?);
        }
        Ok(())
    }

    /// Each with a case of its own.
    fn alone(
        &self,
        start: usize,
        watch: Watch,
        outcomes: &mut HashMap<usize, Outcome>,
    ) -> Result<(), StudyError> {
        for member in self.members {
            let outcome = match self.pose(*member, start, watch)? {
                Err(reason) => Outcome::Failed(reason),
                Ok(case) => {
                    let motion = case.problem.kinematics;
                    let solved =
                        LoadedSolver::without_state(&case).solve(&case, motion, None, watch);
                    outcome(&case, solved)?
                }
            };
            outcomes.insert(*member, outcome);
        }
        Ok(())
    }

    /// The case of a row, or why there is none.
    fn pose(
        &self,
        member: usize,
        start: usize,
        watch: Watch,
    ) -> Result<Result<Case, String>, StudyError> {
        let varied = self.study.design.varied().iter();
        let assignments: Vec<String> = varied
            .zip(&self.entries[member])
            .map(|(varied, entry)| assignment(varied.field, entry))
            .collect();
        let pose = || -> Result<Case, CaseErrors> {
            let file = self.study.case.with(format!("row {}", start + member), &assignments)?;
            let case = file.pose(watch)?;
            case.require_steady("a study is")?;
            Ok(case)
        };
        match pose() {
            Ok(case) => Ok(Ok(case)),
            Err(errors) if errors.first.cause == Cause::Stopped => Err(StudyError::Stopped),
            Err(errors) => Ok(Err(errors.first.message)),
        }
    }

    /// The motion of a row; what does not vary is that of the case.
    fn kinematics(&self, member: usize, own: &Kinematics) -> Kinematics {
        let mut kinematics = *own;
        for (condition, entry) in self.conditions.iter().zip(&self.entries[member]) {
            let (Some(quantity), Entry::Number(number)) = (condition, entry) else { continue };
            match quantity {
                Quantity::CreepageX => kinematics.creepage_x = *number,
                Quantity::CreepageY => kinematics.creepage_y = *number,
                Quantity::Spin => kinematics.spin = *number,
                _ => kinematics.speed = *number,
            }
        }
        kinematics
    }
}

fn outcome(case: &Case, solved: Result<schlupf::Solution, Error>) -> Result<Outcome, StudyError> {
    match solved {
        Ok(mut solution) => {
            // A row is about the first contact of a wheel.
            let wheel = case.wheel.as_ref();
            let of_wheel = wheel.map(|wheel| (wheel.warnings(), wheel.other_contacts()));
            solution.warnings.extend(
                of_wheel.into_iter().flat_map(|(own, others)| own.into_iter().chain(others)),
            );
            Ok(Outcome::Solved(Box::new(solution)))
        }
        Err(Error::Stopped {}) => Err(StudyError::Stopped),
        Err(error) => Ok(Outcome::Failed(case.explain(&error).message)),
    }
}
