//! `schlupf fit`.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf::identification::roughness::DEFAULT_GAMMA;
use schlupf_case::identification::parameters;
use schlupf_case::{CaseErrors, CaseFile, InputFile};
use schlupf_output::identification::FitReport;
use schlupf_tasks::fit::{self, GAMMA, MAX_STEPS, Names, Plan, Request};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

const DATA: &str = "--data";
const FIT: &str = "--fit";

/// Points of a curve in the figure.
const CURVE_POINTS: usize = 41;

/// What to fit to which data, and where to write it.
#[derive(Debug, Args)]
pub struct Fit {
    /// Which case; its values are those to start from.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Measured points (CSV): creepage_x, creepage_y or spin [1/m], force_ratio (-Fx/N over
    /// creepage_x, -Fy/N over creepage_y) or force_ratio_x, force_ratio_y, and where they differ
    /// from the case speed [m/s], load [kN]; standard_deviation where known
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub data: PathBuf,
    /// Parameters to fit, such as friction.coefficient,contact_law.stiffness; contact_law.roughness
    /// is the r.m.s. height of both surfaces together, in place of the stiffness
    #[arg(long = "fit", value_name = "SECTION.FIELD,…")]
    pub parameters: String,
    /// γ, for contact_law.roughness: the rough surfaces approach by γ times that height when the
    /// pressure grows e-fold
    #[arg(long, value_name = "NUMBER", default_value_t = DEFAULT_GAMMA, value_parser = gamma)]
    pub gamma: f64,
    /// Maximum number of steps of the fit
    #[arg(long, value_name = "N", default_value_t = MAX_STEPS,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub max_steps: u32,
    /// Write the case with the fitted values, keeping comments and layout
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub write_case: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A γ that theory or measurement may have.
fn gamma(text: &str) -> Result<f64, String> {
    let gamma = text.parse().ok().filter(|gamma| GAMMA.contains(gamma));
    let (least, largest) = (GAMMA.start(), GAMMA.end());
    gamma.ok_or_else(|| format!("must be a number between {least} and {largest}"))
}

impl Task for Fit {
    type Plan = Plan;
    type Report = FitReport;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        let case = OwnFile::given("--write-case", FitReport::CASE, self.write_case.as_ref());
        case.into_iter().collect()
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let parameters = parameters(FIT, &self.parameters).map_err(CaseErrors::from)?;
        let request = Request {
            parameters,
            data: InputFile::at(&self.data),
            gamma: self.gamma,
            max_steps: self.max_steps as usize,
            curve_points: if self.outputs.figures.is_some() { CURVE_POINTS } else { 0 },
            fitted_case: self.write_case.clone(),
            names: Names {
                data: DATA,
                parameters: FIT,
                given: format!("{} {DATA}", self.parameters),
            },
        };
        Ok(fit::plan(&file, request, watch)?)
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        inputs.push(Input { what: DATA.to_owned(), path: self.data.clone(), except: None });
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<FitReport>, Failure> {
        progress.stage("fitting");
        let fit::Found { report, failure } = plan.find(&progress.watch())?;
        Ok(Found { report, failure: failure.map(Failure::from) })
    }
}
