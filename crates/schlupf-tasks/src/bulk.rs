//! The bulk temperature of a wheel in the long run.

use schlupf::bulk_temperature::{self, Cooling};
use schlupf::{Error, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile};
use schlupf_output::bulk_temperature::BulkReport;

use crate::{Notice, TaskError, messages};

/// A case with what cools its wheel, checked.
#[derive(Debug)]
pub struct Plan {
    case: Case,
    cooling: Cooling,
}

/// Poses the case; its section `[cooling]` says what cools the wheel.
///
/// # Errors
/// A case that is wrong, has a history, or does not say how the wheel is cooled.
pub fn plan(file: &CaseFile, watch: Watch) -> Result<Plan, TaskError> {
    let case = file.pose(watch)?;
    case.require_steady("the bulk temperature is that")?;
    let cooling = case.require_cooling()?;
    bulk_temperature::check(&case.problem, &cooling).map_err(|error| case.explain(&error))?;
    Ok(Plan { case, cooling })
}

impl Plan {
    /// Finds the balance of heat.
    ///
    /// # Errors
    /// Whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<BulkReport, TaskError> {
        let Self { case, cooling } = self;
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        let mut solver = case.solver_without_state();
        let balance =
            bulk_temperature::bulk_temperature(&case.problem, &mut *solver, &cooling, watch);
        let balance = balance.map_err(explain)?;
        let warnings = messages(&balance.solution.warnings);
        Ok(BulkReport {
            cooling,
            rail_temperature: case.problem.rail.bulk_temperature,
            wheel_radius: case.wheel_radius(),
            warnings: Notice::of_first_contact(&case).into_iter().chain(warnings).collect(),
            title: case.title,
            balance,
        })
    }
}
