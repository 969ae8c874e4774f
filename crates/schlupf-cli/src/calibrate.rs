//! `schlupf calibrate`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf::calibration::CalibrationOptions;
use schlupf_case::{CaseErrors, CaseFile, InputFile, read_displacements};
use schlupf_output::calibration::CalibrationReport;
use schlupf_tasks::calibrate::{self, CELLS, Plan, Request};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, Task};

const DISPLACEMENTS: &str = "--displacements";

/// What to calibrate the layer to, and where to write the stiffnesses.
#[derive(Debug, Args)]
pub struct Calibrate {
    /// Which case; its patch and its bodies count.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Calibrate for this very patch instead of interpolating the table, and compare both
    #[arg(long, conflicts_with = "displacements")]
    pub direct: bool,
    /// Fit to displacements of a finite-element model (CSV with columns x, y, traction_x,
    /// displacement_x, …); may be given several times
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub displacements: Vec<PathBuf>,
    /// Cells across the patch on which layer and half-space are compared
    #[arg(long, value_name = "N", default_value_t = CalibrationOptions::default().cells,
          value_parser = number_of_cells)]
    pub cells: usize,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A number of cells on which a calibration means something and ends.
fn number_of_cells(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| CELLS.contains(count));
    let (least, largest) = (CELLS.start(), CELLS.end());
    count.ok_or_else(|| format!("must be a whole number between {least} and {largest}"))
}

impl Task for Calibrate {
    type Plan = Plan;
    type Report = CalibrationReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn plan(&self, case: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let read = |path: &PathBuf| read_displacements(DISPLACEMENTS, &InputFile::at(path));
        let displacements = self.displacements.iter().map(read).collect::<Result<Vec<_>, _>>();
        let request = Request {
            direct: self.direct,
            displacements: displacements.map_err(CaseErrors::from)?,
            cells: self.cells,
            with_sides: self.outputs.figures.is_some(),
        };
        Ok(calibrate::plan(case, request, watch)?)
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        inputs.extend(self.displacements.iter().map(|path| Input {
            what: DISPLACEMENTS.to_owned(),
            path: path.clone(),
            except: None,
        }));
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<CalibrationReport>, Failure> {
        progress.stage("calibrating");
        Ok(plan.find(&progress.watch())?.into())
    }
}
