//! `schlupf wear`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf_case::CaseFile;
use schlupf_output::wear::WearReport;
use schlupf_tasks::wear::{self, Cells, Plan};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

/// Of which case, and where to write its damage.
#[derive(Debug, Args)]
pub struct Wear {
    /// Which case; its section [damage] has the laws.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Write the depths across the profile as CSV, one row for each row of cells
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub profile: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Wear {
    type Plan = Plan;
    type Report = WearReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        let profile = self.profile.as_ref();
        OwnFile::given("--profile", WearReport::PROFILE, profile).into_iter().collect()
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let is_written = self.profile.is_some() || self.outputs.csv.is_some();
        let cells = if is_written { Cells::Needed } else { Cells::IfAny };
        Ok(wear::plan(&file, cells, watch)?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<WearReport>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}
