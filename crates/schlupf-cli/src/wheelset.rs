//! `schlupf wheelset`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf_case::{CaseErrors, CaseFile, range};
use schlupf_output::wheelset::WheelsetReport;
use schlupf_tasks::wheelset::{self, POINTS, Plan, RANGE, Request};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::curve::number_of_points;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

const LATERAL: &str = "--lateral-position";
const CONICITY: &str = "--conicity";

/// Where to put the wheelset, and where to write its contacts.
#[derive(Debug, Args)]
pub struct Wheelset {
    /// Which case, one with normal.model = "wheel-rail".
    #[command(flatten)]
    pub case: CaseArguments,
    /// Lateral positions of the wheelset [default: "-8..8 mm"]
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub lateral_position: Option<String>,
    /// Number of positions
    #[arg(long, value_name = "N", default_value_t = POINTS, value_parser = number_of_points)]
    pub points: usize,
    /// Write the equivalent conicity as CSV, one row for each amplitude
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub conicity: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Wheelset {
    type Plan = Plan;
    type Report = WheelsetReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        let conicity = self.conicity.as_ref();
        OwnFile::given(CONICITY, WheelsetReport::CONICITY, conicity).into_iter().collect()
    }

    fn plan(&self, file: CaseFile, _watch: Watch) -> Result<Plan, Failure> {
        let read = |text: &str| range(LATERAL, "wheelset.lateral_position", text);
        let given = self.lateral_position.as_deref().map(read).transpose();
        let range = given.map_err(CaseErrors::from)?.unwrap_or(RANGE);
        Ok(wheelset::plan(&file, Request { range, points: self.points })?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<WheelsetReport>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}
