//! `schlupf bulk`.

use clap::Args;
use schlupf::bulk_temperature::{self, Cooling};
use schlupf::{Error, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile};
use schlupf_output::bulk_temperature::BulkReport;

use schlupf_tasks::messages;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::task::{Found, Task};

/// Whose balance to find, and where to write it.
#[derive(Debug, Args)]
pub struct Bulk {
    /// Which case; its section [cooling] says what cools the wheel.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A case with what cools its wheel.
pub struct Plan {
    case: Case,
    cooling: Cooling,
}

impl Task for Bulk {
    type Plan = Plan;
    type Report = BulkReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let case = file.pose(watch)?;
        case.require_steady("the bulk temperature is that").map_err(CaseErrors::from)?;
        let cooling = case.require_cooling().map_err(CaseErrors::from)?;
        bulk_temperature::check(&case.problem, &cooling).map_err(|error| explain(&case, &error))?;
        Ok(Plan { case, cooling })
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<BulkReport>, Failure> {
        let Plan { case, cooling } = plan;
        let mut solver = case.solver();
        let watch = progress.watch();
        let balance =
            bulk_temperature::bulk_temperature(&case.problem, &mut *solver, &cooling, &watch);
        let balance = balance.map_err(|error| explain(&case, &error))?;
        let warnings = messages(&balance.solution.warnings);
        let report = BulkReport {
            cooling,
            rail_temperature: case.problem.rail.bulk_temperature,
            wheel_radius: case.wheel_radius(),
            warnings: case.notices.iter().cloned().chain(warnings).collect(),
            title: case.title,
            balance,
        };
        Ok(report.into())
    }
}

fn explain(case: &Case, error: &Error) -> Failure {
    Failure::Case(case.explain(error).into())
}
