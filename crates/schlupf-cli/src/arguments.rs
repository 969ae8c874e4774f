//! Arguments of the command line.

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use clap::{ArgGroup, Args, Parser, Subcommand, ValueEnum, ValueHint};
use clap_complete::Shell;
use schlupf::calibration::CalibrationOptions;
use schlupf::creep_curve::{MAX_POINTS, Sampling};
use schlupf::identification::roughness::DEFAULT_GAMMA;

use crate::failure::Failure;
use crate::stdout;

const EXIT_CODES: &str = "\
Exit codes:
  0  converged
  1  the file system failed
  2  bad input
  3  not converged: the results are written and marked; if the normal contact was not found, there are none";

/// Rolling contact of wheel and rail: forces, stress, slip and temperature in the contact patch.
#[derive(Debug, Parser)]
#[command(name = "schlupf", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// Threads for what can be computed at the same time; all cores when left out. Results do not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = number_of_threads)]
    pub threads: Option<usize>,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a case
    #[command(after_help = EXIT_CODES)]
    Solve(Box<SolveArguments>),
    /// Compute creep curves: forces over creepage
    #[command(after_help = EXIT_CODES)]
    Curve(Box<CurveArguments>),
    /// From rough surfaces to the contact stiffness k_c: statistics, contact area, tangential curves
    #[command(after_help = EXIT_CODES)]
    Roughness(Box<RoughnessArguments>),
    /// Compare all methods on a case: forces, temperature, time
    #[command(after_help = EXIT_CODES)]
    Compare(Box<CompareArguments>),
    /// Temperatures of wheel and rail below a point, and along its row with the wake
    #[command(after_help = EXIT_CODES)]
    Temperature(Box<TemperatureArguments>),
    /// Long-term bulk temperature of the wheel, from its heat balance, in place of the case's
    #[command(after_help = EXIT_CODES)]
    Bulk(BulkArguments),
    /// Stiffnesses of the elastic layer: from the table, calibrated anew, or fitted to displacements
    #[command(after_help = EXIT_CODES)]
    Calibrate(Box<CalibrateArguments>),
    /// Find constants of friction and contact law from measured creep forces
    #[command(after_help = EXIT_CODES)]
    Fit(Box<FitArguments>),
    /// Check a case file and say what it would solve
    Check(CaseArguments),
    /// Write a commented case file to start from
    Init(InitArguments),
    /// Print the JSON schema of a case file
    Schema,
    /// Print a completion script for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// Which case.
#[derive(Debug, Args)]
pub struct CaseArguments {
    /// Case file (TOML); a steel wheel braking on a steel rail when none is named
    #[arg(value_hint = ValueHint::FilePath)]
    pub case: Option<PathBuf>,
    /// Set a field in place of the file, such as normal.load="60 kN"; an empty value takes it out
    #[arg(long = "set", value_name = "SECTION.FIELD=VALUE")]
    pub overrides: Vec<String>,
}

/// What stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// What of the results is shown.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Write the results as JSON; `-` is standard output, then without the summary
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub json: Option<PathBuf>,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
}

impl ReportArguments {
    /// The file of the JSON, if it goes into one.
    pub fn json_file(&self) -> Option<&Path> {
        self.json.as_deref().filter(|path| *path != Path::new(STANDARD_OUTPUT))
    }

    /// Prints the JSON, if it goes to standard output, else the summary, unless none is wanted.
    pub fn print(
        &self,
        json: impl FnOnce() -> String,
        summary: impl FnOnce() -> String,
    ) -> Result<(), Failure> {
        if self.json.is_some() && self.json_file().is_none() {
            stdout::write(&json())
        } else if self.quiet {
            Ok(())
        } else {
            stdout::write(&summary())
        }
    }
}

/// What to solve and where to write it.
#[derive(Debug, Args)]
pub struct SolveArguments {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Write the fields as CSV, one row for each cell in contact
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Write the fields for `ParaView` (VTK)
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub vtk: Option<PathBuf>,
    /// Draw all figures (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// Start from the state that --final-state has written
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub initial_state: Option<PathBuf>,
    /// Write the state at the end, to go on from
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub final_state: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// Which creep curves, and where to write them.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("varied")
    .args(["creepage_x", "creepage_y", "spin", "creepage"]).required(true).multiple(true))]
pub struct CurveArguments {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Vary the longitudinal creepage, such as 0..0.05; several of these options vary all together
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub creepage_x: Option<String>,
    /// Vary the lateral creepage
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub creepage_y: Option<String>,
    /// Vary the spin creepage, such as "0..2 1/m"
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub spin: Option<String>,
    /// Vary the total creepage in the direction of --direction
    #[arg(
        long,
        value_name = "START..END",
        allow_hyphen_values = true,
        requires = "direction",
        conflicts_with_all = ["creepage_x", "creepage_y"]
    )]
    pub creepage: Option<String>,
    /// Direction of the total creepage, from longitudinal (0 deg) to lateral (90 deg)
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, requires = "creepage")]
    pub direction: Option<String>,
    /// Number of points
    #[arg(long, value_name = "N", default_value_t = Sampling::default().points,
          value_parser = number_of_points)]
    pub points: usize,
    /// How the points are spaced: finer near zero creepage, or evenly
    #[arg(long, value_enum, default_value_t = SpacingArgument::Refined)]
    pub spacing: SpacingArgument,
    /// Draw one curve for each value of a field, such as kinematics.speed="10 m/s,20 m/s"
    #[arg(long, value_name = "SECTION.FIELD=VALUE,…")]
    pub over: Option<String>,
    /// Write the curves as CSV, one row for each point
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Draw the figure `creep_curve` (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// Where to look at the temperatures, and where to write them.
#[derive(Debug, Args)]
pub struct TemperatureArguments {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Place along rolling, such as "-3 mm"; the hottest one when left out
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub x: Option<String>,
    /// Place across rolling; that of the hottest point when left out
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub y: Option<String>,
    /// Depths of the profile, such as "0..2 mm"; as far as heat has come when left out
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub depth: Option<String>,
    /// Length of the wake; twice the length of the contact when left out
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub wake: Option<String>,
    /// Number of points of each line
    #[arg(long, value_name = "N", default_value_t = 201, value_parser = number_of_points)]
    pub points: usize,
    /// Write the temperatures as CSV, one row for each point
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Draw the figure `temperature` (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// Whose balance to find, and where to write it.
#[derive(Debug, Args)]
pub struct BulkArguments {
    /// Which case; its section [cooling] says what cools the wheel.
    #[command(flatten)]
    pub case: CaseArguments,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// What to calibrate the layer to, and where to write the stiffnesses.
#[derive(Debug, Args)]
pub struct CalibrateArguments {
    /// Which case; its patch and its bodies count.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Calibrate against the half-space anew, beside the table
    #[arg(long, conflicts_with = "displacements")]
    pub anew: bool,
    /// Fit to displacements of a finite-element model (CSV with columns x, y, traction_x, displacement_x, …); may be
    /// given several times
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub displacements: Vec<PathBuf>,
    /// Cells across the patch on which layer and half-space are compared
    #[arg(long, value_name = "N", default_value_t = CalibrationOptions::default().cells,
          value_parser = number_of_cells)]
    pub cells: usize,
    /// Draw the figure `calibration` (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath,
          conflicts_with = "displacements")]
    pub figures: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// What to fit to which data, and where to write it.
#[derive(Debug, Args)]
pub struct FitArguments {
    /// Which case; its values are those to start from.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Measured points (CSV): creepage_x, creepage_y or spin [1/m], force_ratio (-Fx/N over creepage_x,
    /// -Fy/N over creepage_y) or force_ratio_x, force_ratio_y, and where they differ from the case speed
    /// [m/s], load [kN]; standard_deviation where known
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub data: PathBuf,
    /// What to find, such as friction.coefficient,contact_law.stiffness; contact_law.roughness is the
    /// r.m.s. height of both surfaces together, in place of the stiffness
    #[arg(long, value_name = "SECTION.FIELD,…")]
    pub fit: String,
    /// γ, for contact_law.roughness: the rough surfaces approach by γ times that height when the pressure
    /// grows e-fold
    #[arg(long, value_name = "NUMBER", default_value_t = DEFAULT_GAMMA, value_parser = gamma)]
    pub gamma: f64,
    /// Most steps of the fit
    #[arg(long, value_name = "N", default_value_t = 100,
          value_parser = clap::value_parser!(u32).range(1..))]
    pub max_steps: u32,
    /// Write data, fit and residuals as CSV, one row for each measured force
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Draw the figure `fit` (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// Write the case with the values found, comments and layout kept
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub write_case: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// A number of threads that a machine can have.
fn number_of_threads(text: &str) -> Result<usize, String> {
    const MOST: usize = 1024;
    let count = text.parse().ok().filter(|count| (1..=MOST).contains(count));
    count.ok_or_else(|| format!("must be a whole number between 1 and {MOST}"))
}

/// A γ that theory or measurement may have.
fn gamma(text: &str) -> Result<f64, String> {
    let gamma = text.parse().ok().filter(|gamma| (0.01..=10.0).contains(gamma));
    gamma.ok_or_else(|| "must be a number between 0.01 and 10".to_owned())
}

/// What to compare, and where to write it.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Write the table as CSV, one row for each method
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Draw the figure `comparison` (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// Which surface to press on which bodies, and where to write the results.
#[derive(Debug, Args)]
pub struct RoughnessArguments {
    /// Surface or profile of one body, or of both together (.csv, .npy, .x3p, .xyz); without it and without
    /// --synthetic that of the case
    #[arg(value_hint = ValueHint::FilePath, conflicts_with = "synthetic")]
    pub surface: Option<PathBuf>,
    /// Surface of the other body, on the same lattice: their heights are added
    #[arg(long, value_name = "SURFACE", value_hint = ValueHint::FilePath, requires = "surface")]
    pub second: Option<PathBuf>,
    /// Make a self-affine surface, such as rms_height="1 um",hurst=0.8,longest="100 um",shortest="5 um",seed=1;
    /// also rms_slope and roll_off
    #[arg(long, value_name = "KEY=VALUE,…")]
    pub synthetic: Option<String>,
    /// What is taken off a measured surface [default: plane]
    #[arg(long, value_name = "plane|cylinder|sphere|none", requires = "surface")]
    pub form: Option<String>,
    /// Take longer waves than this off a measured surface, such as "0.8 mm" (λc of the Gaussian filter, ISO 16610)
    #[arg(long, value_name = "LENGTH", requires = "surface")]
    pub cutoff: Option<String>,
    /// Unit of the heights of an .npy file, of all lengths of an .xyz file, such as um
    #[arg(long, value_name = "UNIT", requires = "surface")]
    pub unit: Option<String>,
    /// Distance of the points of an .npy file, such as "1 um"
    #[arg(long, value_name = "LENGTH", requires = "surface")]
    pub spacing: Option<String>,
    /// Fill points without a height smoothly
    #[arg(long, requires = "surface")]
    pub fill_holes: bool,
    /// Resample a surface whose cells are not square
    #[arg(long, requires = "surface")]
    pub square_cells: bool,
    /// Cells along x: the surface is resampled, or made with so many
    #[arg(long, value_name = "N")]
    pub cells: Option<String>,
    /// Seed of the surface made from a profile
    #[arg(long, value_name = "N", requires = "surface")]
    pub seed: Option<String>,
    /// Mean pressures: a range, of which six are taken, or a list [default: 0.2..1.2 GPa; those of the
    /// patch with --case]
    #[arg(long, allow_hyphen_values = true, value_name = "START..END|P,P,…")]
    pub pressure: Option<String>,
    /// Coefficient of friction [default: that of the case]
    #[arg(long, allow_hyphen_values = true, value_name = "MU")]
    pub friction: Option<String>,
    /// Hardness of the softer body, such as "2.5 GPa" [default: elastic bodies]
    #[arg(long, allow_hyphen_values = true, value_name = "PRESSURE")]
    pub hardness: Option<String>,
    /// Case file of the bodies; steel wheel and rail when none is named
    #[arg(long, value_name = "CASE", value_hint = ValueHint::FilePath)]
    pub case: Option<PathBuf>,
    /// Set a field of the case, such as wheel.young_modulus="200 GPa"
    #[arg(long = "set", value_name = "SECTION.FIELD=VALUE")]
    pub overrides: Vec<String>,
    /// Write the tangential curves as CSV, one row for each point
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub csv: Option<PathBuf>,
    /// Write the heights, of both surfaces together and without form, as .npy in m
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub heights: Option<PathBuf>,
    /// Write the pressures in all cells at the largest mean pressure as .npy in Pa
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub pressures: Option<PathBuf>,
    /// Write the gaps there as .npy in m; negative is the depth that was flattened
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub gaps: Option<PathBuf>,
    /// Draw curves, surface, contact spots and spectrum (PNG and SVG) into a directory, created if missing
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub figures: Option<PathBuf>,
    /// What of the results is shown.
    #[command(flatten)]
    pub report: ReportArguments,
}

/// A number of cells on which a calibration means something and ends.
fn number_of_cells(text: &str) -> Result<usize, String> {
    const CELLS: RangeInclusive<usize> = 10..=80;
    let count = text.parse().ok().filter(|count| CELLS.contains(count));
    let (least, largest) = (CELLS.start(), CELLS.end());
    count.ok_or_else(|| format!("must be a whole number between {least} and {largest}"))
}

/// How the points of a curve are spaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SpacingArgument {
    /// Steps grow from zero creepage outwards
    Refined,
    /// All steps are equal
    Even,
}

/// A number of points that makes a curve.
fn number_of_points(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| (2..=MAX_POINTS).contains(count));
    count.ok_or_else(|| format!("must be a whole number between 2 and {MAX_POINTS}"))
}

/// Where to write a case file.
#[derive(Debug, Args)]
pub struct InitArguments {
    /// Where to; `-` is standard output
    #[arg(default_value = "case.toml", value_hint = ValueHint::FilePath)]
    pub file: PathBuf,
    /// Overwrite the file if there is one
    #[arg(long)]
    pub force: bool,
}
