//! `schlupf compare`.

use clap::Args;
use schlupf::Watch;
use schlupf_case::CaseFile;
use schlupf_output::comparison::Comparison;
use schlupf_tasks::compare::{self, Plan};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::task::{Found, Task};

/// What to compare, and where to write it.
#[derive(Debug, Args)]
pub struct Compare {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Compare {
    type Plan = Plan;
    type Report = Comparison;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        Ok(compare::plan(&file, watch)?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<Comparison>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}
