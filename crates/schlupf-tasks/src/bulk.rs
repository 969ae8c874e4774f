//! The bulk temperature of a wheel in the long run.

use crate::output::bulk_temperature::BulkReport;
use schlupf::analysis::bulk_temperature;
use schlupf::{Error, Watch};
use schlupf_case::CaseErrors;

use crate::request::Nothing;
use crate::task::{CaseArgument, Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

/// `bulk`: the section `[cooling]` of the case says what cools the wheel.
pub struct Bulk;

impl Task for Bulk {
    const NAME: &'static str = "bulk";
    const FUNCTION: &'static str = "bulk_temperature";
    const ABOUT: &'static str =
        "Compute the long-term bulk temperature of the wheel from its heat balance";
    const CASE: CaseArgument =
        CaseArgument::Positional("with what cools the wheel in the section [cooling]");
    type Request = Nothing;
    type Report = BulkReport;

    fn run(
        of: &Given,
        _request: Nothing,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<BulkReport>, TaskError> {
        let case = of.case.pose(watch)?;
        case.require_steady("the bulk temperature is that")?;
        let cooling = case.require_cooling()?;
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        bulk_temperature::check(&case.problem, &cooling).map_err(explain)?;
        let mut solver = case.solver_without_state();
        let balance =
            bulk_temperature::bulk_temperature(&case.problem, &mut *solver, &cooling, watch);
        let balance = balance.map_err(explain)?;
        let warnings = messages(&balance.solution.warnings);
        let report = BulkReport {
            cooling,
            rail_temperature: case.problem.interface.rail.bulk_temperature,
            wheel_radius: case.wheel_radius(),
            warnings: Notice::of_first_contact(&case).into_iter().chain(warnings).collect(),
            title: case.title,
            balance,
        };
        Ok(report.into())
    }
}
