//! `schlupf sweep` and `schlupf merge`.

use std::path::{Path, PathBuf};

use clap::Args;
use schlupf_tasks::study::run::Report;
use schlupf_tasks::study::table::ENDINGS;
use schlupf_tasks::study::{Study, merge, run};

use crate::failure::{Failure, NOT_CONVERGED, SUCCESS};
use crate::outputs::{self, Input, Output};
use crate::progress::Progress;
use crate::{interrupt, report, stdout};

const OUTPUT: &str = "--output";

/// Which study, and where to write its table.
#[derive(Debug, Args)]
pub struct Sweep {
    /// Study file (TOML): a case and what varies over it
    pub study: PathBuf,
    /// Where to write the table
    #[arg(long, value_name = "FILE", help = format!(
        "Where to write the table, a row for each state: {ENDINGS}; run again, it resumes"
    ))]
    pub output: PathBuf,
    /// Solve one share of so many only, such as 1/8; `schlupf merge` puts them together
    #[arg(long, value_name = "I/N", value_parser = shard, default_value = "1/1")]
    pub shard: Shard,
    /// Print no summary
    #[arg(long)]
    pub quiet: bool,
}

/// Which tables, and where to write the whole.
#[derive(Debug, Args)]
pub struct Merge {
    /// Tables of all shards of a study
    #[arg(required = true)]
    pub tables: Vec<PathBuf>,
    /// Where to write the table of the whole study
    #[arg(long, value_name = "FILE",
        help = format!("Where to write the table of the whole study: {ENDINGS}"))]
    pub output: PathBuf,
    /// Print no summary
    #[arg(long)]
    pub quiet: bool,
}

/// A share, counted from 1, and of how many.
#[derive(Debug, Clone, Copy)]
pub struct Shard([usize; 2]);

fn shard(text: &str) -> Result<Shard, String> {
    let parts = text.split_once('/');
    let parts = parts.and_then(|(i, n)| Some([i.trim().parse().ok()?, n.trim().parse().ok()?]));
    let shard = parts.filter(|[i, n]| (1..=*n).contains(i));
    shard.map(Shard).ok_or_else(|| "must be I/N with I from 1 to N, such as 2/8".to_owned())
}

/// Solves a study.
pub fn sweep(arguments: &Sweep) -> Result<u8, Failure> {
    let progress = Progress::start();
    check(&arguments.output)?;
    progress.stage("reading the study");
    let study = Study::from_path(&arguments.study, None)?;
    let input =
        |path: &PathBuf| Input { what: "the study".to_owned(), path: path.clone(), except: None };
    let inputs: Vec<Input> = study.inputs().iter().map(input).collect();
    outputs::refuse_inputs(&[output(&arguments.output)], None, &inputs)?;
    let directory = outputs::make_directory(&arguments.output)?;
    interrupt::unfinished().keep_parts();
    let report = run::run(&study, arguments.shard.0, &arguments.output, &progress.watch())?;
    drop(progress);
    drop(directory);
    told(&report, &arguments.output, arguments.quiet)
}

/// Puts the tables of shards together.
pub fn merge(arguments: &Merge) -> Result<u8, Failure> {
    check(&arguments.output)?;
    let input = |path: &PathBuf| Input {
        what: "one of the tables to merge".to_owned(),
        path: path.clone(),
        except: None,
    };
    let inputs: Vec<Input> = arguments.tables.iter().map(input).collect();
    outputs::refuse_inputs(&[output(&arguments.output)], None, &inputs)?;
    let _directory = outputs::make_directory(&arguments.output)?;
    let report = merge::merge(&arguments.tables, &arguments.output)?;
    told(&report, &arguments.output, arguments.quiet)
}

fn output(path: &Path) -> Output {
    Output { option: OUTPUT.to_owned(), path: path.to_owned() }
}

fn check(path: &Path) -> Result<(), Failure> {
    outputs::check(&[output(path)], None)
}

/// Prints what was done.
fn told(done: &Report, path: &Path, is_quiet: bool) -> Result<u8, Failure> {
    if !is_quiet {
        let Report { rows, resumed, not_converged, no_contact, failed, .. } = done;
        let solved = rows - failed - not_converged - no_contact;
        let parts = [
            (*no_contact, "without contact"),
            (*not_converged, "not converged"),
            (*failed, "failed"),
        ];
        let parts = parts.into_iter();
        let parts = parts.filter(|(count, _)| *count > 0);
        let mut parts: Vec<String> =
            parts.map(|(count, what)| format!(", {count} {what}")).collect();
        if *resumed > 0 {
            parts.push(format!("; {resumed} were there already"));
        }
        if let Some((row, reason)) = &done.first_failure {
            parts.push(format!("\nfirst failure: row {row}: {reason}"));
        }
        let parts = parts.concat();
        let text = format!("{}\n\n{rows} states, {solved} converged{parts}\n", path.display());
        stdout::write(&text)?;
    }
    done.warnings.messages().iter().for_each(report::warn);
    Ok(if done.is_converged() { SUCCESS } else { NOT_CONVERGED })
}
