//! `schlupf table CASE`: the contacts of a wheel with two profiles.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use schlupf::wheel_rail::{ContactTable, ContactTableErrors, ContactTableOptions, Spread};
use schlupf_case::contact_table::{self, OptionNames};
use schlupf_case::{CaseErrors, direction};

use crate::arguments::CaseArguments;
use crate::failure::{Failure, NOT_CONVERGED, SUCCESS};
use crate::outputs::{self, Input, Output};
use crate::progress::Progress;
use crate::read_case::read_case;
use crate::stdout;

/// As options of the command.
const NAMES: OptionNames = OptionNames(|name| match name {
    "poses" => "--states".to_owned(),
    _ => format!("--{}", name.replace('_', "-")),
});

/// Of which wheel, and what the table covers.
#[derive(Debug, Args)]
pub struct ContactTableArguments {
    /// Case file of a wheel with two profiles, `-` for standard input: a table of its contacts in
    /// place of one of creep forces
    #[arg(value_hint = ValueHint::FilePath)]
    pub case: Option<PathBuf>,
    /// Override a field of the case, such as track.gauge="1437 mm"
    #[arg(long = "set", value_name = "SECTION.FIELD=VALUE", requires = "case")]
    pub overrides: Vec<String>,
    /// Largest roll angle of the wheelset relative to the rail, either way [default: 15 mrad]
    #[arg(long, value_name = "ANGLE", requires = "case")]
    pub largest_roll_angle: Option<String>,
    /// Largest yaw angle, either way [default: 30 mrad]
    #[arg(long, value_name = "ANGLE", requires = "case")]
    pub largest_yaw_angle: Option<String>,
    /// Most nodes of the table: refining that would need more is not begun
    #[arg(long, value_name = "N", requires = "case",
        default_value_t = ContactTableOptions::default().most_nodes)]
    pub most_nodes: usize,
}

/// What it shares with the table of creep forces.
pub struct Common {
    /// Largest error of the normal force between nodes, if it is given.
    pub tolerance: Option<f64>,
    /// Random poses, if they are given.
    pub poses: Option<usize>,
    /// Whether no summary is wanted.
    pub is_quiet: bool,
}

/// Makes the table of the contacts of a wheel.
pub fn contact_table(
    of: &ContactTableArguments,
    common: &Common,
    output: &Output,
) -> Result<u8, Failure> {
    let case = CaseArguments { case: of.case.clone(), overrides: of.overrides.clone() };
    let options = options(of, common)?;
    let file = read_case(&case)?;
    let outputs = [Output { option: output.option.clone(), path: output.path.clone() }];
    outputs::refuse_inputs(&outputs, None, &Input::of_case(&case, &file))?;
    let reserved = outputs::reserve(&outputs, None)?;
    let progress = Progress::start();
    let made = {
        let watch = progress.watch();
        file.pose(&watch)?.contact_table(&options, &watch).map_err(CaseErrors::from)
    };
    drop(progress);
    let (table, errors) = made?;
    let bytes = contact_table::to_bytes(&table, &errors);
    let bytes = bytes.map_err(|error| Failure::Arguments(format!("the table {error}")))?;
    let size = bytes.len();
    outputs::write(&[(output.path.clone(), bytes)], None)?;
    drop(reserved);
    if !common.is_quiet {
        stdout::write(&summary(output, (&table, &errors), size))?;
    }
    Ok(if errors.is_within_tolerance { SUCCESS } else { NOT_CONVERGED })
}

fn options(of: &ContactTableArguments, common: &Common) -> Result<ContactTableOptions, Failure> {
    let default = ContactTableOptions::default();
    let angle = |name: &str, given: &Option<String>, default: f64| match given {
        Some(text) => direction(&NAMES.0(name), text).map_err(CaseErrors::from),
        None => Ok(default),
    };
    let options = ContactTableOptions {
        roll: angle(contact_table::ROLL, &of.largest_roll_angle, default.roll)?,
        yaw: angle(contact_table::YAW, &of.largest_yaw_angle, default.yaw)?,
        tolerance: common.tolerance.unwrap_or(default.tolerance),
        most_nodes: of.most_nodes,
        poses: common.poses.unwrap_or(default.poses),
        ..default
    };
    let refused = contact_table::check(&options, &NAMES);
    refused.map_err(|error| Failure::Arguments(error.message))?;
    Ok(options)
}

fn summary(
    output: &Output,
    (table, errors): (&ContactTable, &ContactTableErrors),
    size: usize,
) -> String {
    let [places, rolls, yaws, depths] = table.nodes().axes.map(|axis| axis.count);
    let line = |name: &str, spread: &Spread, (factor, unit): (f64, &str)| {
        let Spread { median, ninety_percent, ninety_nine_percent, largest } = *spread;
        let number = |value: f64| format!("{:.3} {unit}", factor * value);
        format!(
            "{name:<11}median {}, 90 % below {}, 99 % below {}, largest {}\n",
            number(median),
            number(ninety_percent),
            number(ninety_nine_percent),
            number(largest),
        )
    };
    let failed = match errors.failed_nodes {
        0 => String::new(),
        count => format!("; {count} without an exact contact"),
    };
    let verdict = if errors.is_within_tolerance {
        ""
    } else {
        "not within the tolerance: the nodes are used up\n"
    };
    format!(
        "{}\n\nnodes      {places} x {rolls} x {yaws} x {depths}: place on the wheel, roll, yaw, \
         depth{failed}\n{verdict}errors of contacts in {} random poses against exact ones\n{}{}{}{}size       {:.2} \
         MB\n",
        output.path.display(),
        errors.poses,
        line("load", &errors.load, (100.0, "% of the wheel's")),
        line("place", &errors.place, (1e6, "um")),
        line("angle", &errors.angle, (1e3, "mrad")),
        line("centre", &errors.centre, (1e6, "um")),
        size as f64 / 1e6,
    )
}
