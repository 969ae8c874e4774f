//! `schlupf table`.

use std::path::{Path, PathBuf};

use clap::Args;
use schlupf::analysis::table_building::{LONGER_SIDE_EXPONENT, TableOptions, build, build_from};
use schlupf::{Error, Quantity};
use schlupf_case::look_up_table::{StatedError, StoredTable, TableFileError};

use crate::contact_table::{Common, ContactTableArguments, contact_table};
use crate::failure::{Failure, NOT_CONVERGED, SUCCESS};
use crate::kept_states::KeptStates;
use crate::notice::Notice;
use crate::outputs::{self, Input, Output};
use crate::progress::Progress;
use crate::{interrupt, report, stdout};

const OUTPUT: &str = "--output";

/// Which look-up table, and where to write it.
#[derive(Debug, Args)]
pub struct Table {
    #[command(flatten)]
    pub contacts: ContactTableArguments,
    /// Where to write the table: a .npz archive, which NumPy reads; that of creep forces resumes
    /// where it was interrupted
    #[arg(long, value_name = "FILE", default_value = "table.npz")]
    pub output: PathBuf,
    /// Combined Poisson's ratio of both bodies
    #[arg(long, conflicts_with = "case", value_name = "NU",
        default_value_t = TableOptions::default().poisson_ratio)]
    pub poisson_ratio: f64,
    /// Smallest a/b, length over width of the patch
    #[arg(long, conflicts_with = "case", value_name = "RATIO",
        default_value_t = TableOptions::default().axis_ratios[0])]
    pub smallest_axis_ratio: f64,
    /// Largest a/b
    #[arg(long, conflicts_with = "case", value_name = "RATIO",
        default_value_t = TableOptions::default().axis_ratios[1])]
    pub largest_axis_ratio: f64,
    /// Largest error of forces over μN in random states [default: 0.01]; of contacts that of the
    /// normal force between nodes [default: 0.005]
    #[arg(long, value_name = "PART")]
    pub tolerance: Option<f64>,
    /// Number of random states that decide, and of those that then measure the error [default:
    /// 1000]; of contacts that of random poses in which the error is measured [default: 400]
    #[arg(long, value_name = "N")]
    pub states: Option<usize>,
    /// Most nodes of the table: refining that would need more is not begun, and the first nodes are
    /// solved in any case
    #[arg(long, conflicts_with = "case", value_name = "N",
        default_value_t = TableOptions::default().most_solutions)]
    pub most_solutions: usize,
    /// A table made before, of the same Poisson's ratio: its nodes are not solved again
    #[arg(long, conflicts_with = "case", value_name = "FILE")]
    pub from: Option<PathBuf>,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
}

/// Makes a look-up table.
pub fn table(arguments: &Table) -> Result<u8, Failure> {
    if arguments.output.extension().is_none_or(|ending| ending != "npz") {
        let path = arguments.output.display();
        return Err(Failure::Arguments(format!("{OUTPUT} must end in .npz, but is {path}")));
    }
    let output = Output { option: OUTPUT.to_owned(), path: arguments.output.clone() };
    outputs::check(std::slice::from_ref(&output), None)?;
    if arguments.contacts.case.is_some() {
        let common = Common {
            tolerance: arguments.tolerance,
            poses: arguments.states,
            is_quiet: arguments.quiet,
        };
        return contact_table(&arguments.contacts, &common, &output);
    }
    let default = TableOptions::default();
    let options = TableOptions {
        poisson_ratio: arguments.poisson_ratio,
        axis_ratios: [arguments.smallest_axis_ratio, arguments.largest_axis_ratio],
        tolerance: arguments.tolerance.unwrap_or(default.tolerance),
        states: arguments.states.unwrap_or(default.states),
        most_solutions: arguments.most_solutions,
        ..default
    };
    let earlier =
        arguments.from.as_deref().map(|path| read(path, arguments, options.cells)).transpose()?;
    options.check().map_err(|error| refused(&error))?;
    let reserved = outputs::reserve(&[output], None)?;
    let kept = KeptStates::of(&arguments.output, &description(&options, earlier.as_ref()))?;
    interrupt::unfinished().keep_parts();
    let resumed = kept.count();
    let progress = Progress::start();
    let built = match &earlier {
        None => build(&options, &kept, &progress.watch()),
        Some(earlier) => build_from(&earlier.table, &options, &kept, &progress.watch()),
    };
    let built = match built {
        Ok(built) => built,
        Err(error) => {
            // A state that cannot be solved does not cost the others.
            kept.leave();
            return Err(refused(&error));
        }
    };
    drop(progress);
    let is_met = built.is_within_tolerance && built.unconverged == 0;
    let stored = StoredTable::new(built, &options);
    let bytes = stored.to_bytes().map_err(|error| unwritten(&error))?;
    let size = bytes.len();
    outputs::write(&[(arguments.output.clone(), bytes)], None)?;
    let unkept = kept.remove();
    drop(reserved);
    if let Some(failure) = unkept {
        report::warn(&Notice::StatesNotKept { reason: failure.to_string() }.into());
    }
    if !arguments.quiet {
        stdout::write(&summary(arguments, &stored, size, resumed))?;
    }
    Ok(if is_met { SUCCESS } else { NOT_CONVERGED })
}

/// A table made before, which must not be written over.
fn read(path: &Path, arguments: &Table, cells: usize) -> Result<StoredTable, Failure> {
    let outputs = [Output { option: OUTPUT.to_owned(), path: arguments.output.clone() }];
    let input = Input { what: "that of --from".to_owned(), path: path.to_owned(), except: None };
    outputs::refuse_inputs(&outputs, None, &[input])?;
    let bytes = std::fs::read(path).map_err(|cause| Failure::file(path, cause))?;
    let refused =
        |reason: String| Failure::Arguments(format!("--from: {} {reason}", path.display()));
    let stored = StoredTable::from_bytes(&bytes).map_err(|error| refused(error.to_string()))?;
    let of = &stored.metadata;
    if of.unconverged > 0 {
        return Err(refused(format!("has {} states that did not converge", of.unconverged)));
    }
    if of.cells != cells {
        let reason = format!("must have been solved on {cells} cells, but was on {}", of.cells);
        return Err(refused(reason));
    }
    if of.longer_side_exponent != LONGER_SIDE_EXPONENT {
        let reason = "must have been solved on more cells along the longer side of the patch, but \
                      was on as many as across it: make the table anew";
        return Err(refused(reason.to_owned()));
    }
    Ok(stored)
}

/// By the names of the options.
fn refused(error: &Error) -> Failure {
    let option = match error.quantity() {
        Quantity::PoissonRatio => "--poisson-ratio",
        Quantity::AxisRatio => "--smallest-axis-ratio, --largest-axis-ratio",
        Quantity::Tolerance => "--tolerance",
        Quantity::LookUpTable => "--states",
        _ => return Failure::Arguments(error.to_string()),
    };
    Failure::Arguments(format!("{option}: {error}"))
}

fn unwritten(error: &TableFileError) -> Failure {
    Failure::Arguments(format!("{OUTPUT}: the table {error}"))
}

/// One line about the table that is to be made: states of another one are not taken for its own.
fn description(options: &TableOptions, earlier: Option<&StoredTable>) -> String {
    let from = earlier.map_or("", |earlier| earlier.metadata.sha256.as_str());
    format!("schlupf {} {options:?} {from}", env!("CARGO_PKG_VERSION"))
}

fn summary(arguments: &Table, stored: &StoredTable, size: usize, resumed: usize) -> String {
    let metadata = &stored.metadata;
    let [ratios, azimuths, inclinations, saturations] = metadata.nodes;
    let percent = |part: f64| format!("{:.2} %", 100.0 * part);
    let of_set = |error: &StatedError| {
        format!(
            "median {}, 90 % below {}, largest {} of μN in {} random states",
            percent(error.median),
            percent(error.ninety_percent),
            percent(error.largest),
            error.states,
        )
    };
    let sliding = metadata
        .sliding_error
        .as_ref()
        .map_or(String::new(), |error| format!("\nsliding    {}", of_set(error)));
    let verdict = if metadata.is_within_tolerance {
        String::new()
    } else {
        format!("\nnot within {}: the states to solve are used up", percent(metadata.tolerance))
    };
    let unconverged = match metadata.unconverged {
        0 => String::new(),
        count => format!(", {count} of them not converged"),
    };
    let resumed = match resumed {
        0 => String::new(),
        count => format!("; {count} were there already"),
    };
    format!(
        "{}\n\nnodes      {ratios} x {azimuths} x {inclinations} x {saturations}: a/b, azimuth, \
         inclination, saturation\nsolved     {} states{unconverged}{resumed}\nerror      {}{sliding}{verdict}\n\
         size       {:.2} MB\n",
        arguments.output.display(),
        metadata.solutions,
        of_set(&metadata.error),
        size as f64 / 1e6,
    )
}
