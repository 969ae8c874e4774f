//! `schlupf temperature`.

use clap::Args;
use schlupf::Watch;
use schlupf_case::{CaseError, CaseErrors, CaseFile, depths, length};
use schlupf_output::temperature::Temperatures;
use schlupf_tasks::temperature::{self, POINTS, Plan, Request};

use crate::arguments::{CaseArguments, OutputArguments, place};
use crate::curve::number_of_points;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::task::{Found, Task};

const X: &str = "--x";
const Y: &str = "--y";
const DEPTH: &str = "--depth";
const WAKE: &str = "--wake";

/// Where to look at the temperatures, and where to write them.
#[derive(Debug, Args)]
pub struct Temperature {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Position along rolling, such as "-3 mm" [default: the hottest point]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub x: Option<String>,
    /// Position across rolling [default: the hottest point]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub y: Option<String>,
    /// Depths of the profile, such as "0..2 mm" [default: as far as heat has penetrated]
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub depth: Option<String>,
    /// Length of the wake [default: twice the length of the contact]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub wake: Option<String>,
    /// Number of points of each line
    #[arg(long, value_name = "N", default_value_t = POINTS, value_parser = number_of_points)]
    pub points: usize,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Temperature {
    type Plan = Plan;
    type Report = Temperatures;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let request = self.request().map_err(CaseErrors::from)?;
        Ok(temperature::plan(&file, request, watch)?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<Temperatures>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}

impl Temperature {
    fn request(&self) -> Result<Request, CaseError> {
        let [x, y] = place([X, Y], [&self.x, &self.y])?;
        let depth = self.depth.as_deref().map(|text| depths(DEPTH, text)).transpose()?;
        let wake = self.wake.as_deref();
        let wake = wake.map(|text| length(WAKE, "the length of the wake", text)).transpose()?;
        Ok(Request { x, y, depth, wake, points: self.points, names: [X, Y, DEPTH, WAKE] })
    }
}
