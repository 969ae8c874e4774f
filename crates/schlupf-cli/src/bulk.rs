//! `schlupf bulk`.

use clap::Args;
use schlupf::Watch;
use schlupf_case::CaseFile;
use schlupf_output::bulk_temperature::BulkReport;
use schlupf_tasks::bulk::{self, Plan};

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
        Ok(bulk::plan(&file, watch)?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<BulkReport>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}
