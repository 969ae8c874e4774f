//! `schlupf subsurface`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf_case::{CaseError, CaseErrors, CaseFile, InputFile};
use schlupf_output::subsurface::StressReport;
use schlupf_tasks::subsurface::{self, Plan, Request};

use crate::arguments::{CaseArguments, OutputArguments, place};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

const X: &str = "--x";
const Y: &str = "--y";
const POINTS: &str = "--points";

/// Where to look at the stresses, and where to write them.
#[derive(Debug, Args)]
pub struct Subsurface {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Position of the profile along rolling, such as "-3 mm" [default: the largest von Mises
    /// stress]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub x: Option<String>,
    /// Position of the profile across rolling [default: the largest von Mises stress]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub y: Option<String>,
    /// Also the stresses at the points of this table (CSV): columns x [mm], y [mm] and depth [mm]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub points: Option<PathBuf>,
    /// Write the stresses in all layers as a VTK file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub vtk: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

impl Task for Subsurface {
    type Plan = Plan;
    type Report = StressReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        OwnFile::given("--vtk", StressReport::VTK, self.vtk.as_ref()).into_iter().collect()
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let points = self.points.iter().cloned();
        let points = points.map(|path| Input { what: POINTS.to_owned(), path, except: None });
        Input::of_case(&self.case, file).into_iter().chain(points).collect()
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let request = self.request().map_err(CaseErrors::from)?;
        Ok(subsurface::plan(&file, request, watch)?)
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<StressReport>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}

impl Subsurface {
    fn request(&self) -> Result<Request, CaseError> {
        let [x, y] = place([X, Y], [&self.x, &self.y])?;
        let points = self.points.as_deref().map(|path| (POINTS, InputFile::at(path)));
        Ok(Request { x, y, points, names: [X, Y] })
    }
}
