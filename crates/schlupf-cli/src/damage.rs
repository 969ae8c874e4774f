//! `schlupf damage`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf_case::CaseFile;
use schlupf_output::damage::DamageReport;
use schlupf_study::damage::{self, Plan};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::interrupt;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

/// Of which run, and where to write its damage.
#[derive(Debug, Args)]
pub struct Damage {
    /// Table of `schlupf sweep` with a column distance or time (.csv or .parquet), or a study of
    /// such states (.toml), which is solved
    #[arg(value_hint = ValueHint::FilePath)]
    pub run: PathBuf,
    /// Which case; its section [damage] has the laws of fatigue and wear. That of the study by
    /// default, which a table keeps.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Write the run as CSV, one row for each state
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub along: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Damage {
    type Plan = Plan;
    type Report = DamageReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        OwnFile::given("--along", DamageReport::RUN, self.along.as_ref()).into_iter().collect()
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        inputs.push(Input { what: "the run".to_owned(), path: self.run.clone(), except: None });
        inputs
    }

    fn plan(&self, file: CaseFile, _: Watch) -> Result<Plan, Failure> {
        let case_of = |of_study: Option<&CaseFile>| match of_study {
            Some(own) if self.case.case.is_none() => own.with("--set", &self.case.overrides),
            _ => Ok(file),
        };
        Ok(damage::plan(&self.run, case_of)?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<DamageReport>, Failure> {
        Ok(plan.find_in(interrupt::scratch, &progress.watch())?.into())
    }
}
