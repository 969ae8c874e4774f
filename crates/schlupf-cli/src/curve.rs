//! `schlupf curve`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};

use schlupf::creep_curve::{self, CreepCurve, Creepages, Sampling, Spacing};
use schlupf::{Watch, parallel};
use schlupf_case::{Case, CaseErrors, Family, direction, range};
use schlupf_output::creep_curve::{CurveFamily, Member, csv, json, summary};
use schlupf_output::figures;

use crate::arguments::{CurveArguments, SpacingArgument};
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::Input;
use crate::progress::Progress;
use crate::solve::figure_files;
use crate::{outputs, report};

const CREEPAGE_X: &str = "--creepage-x";
const CREEPAGE_Y: &str = "--creepage-y";
const SPIN: &str = "--spin";
const CREEPAGE: &str = "--creepage";
const OVER: &str = "--over";

/// Computes creep curves and writes them.
pub fn run(arguments: &CurveArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    let varied = Varied::read(arguments)?;
    let family = arguments.over.as_deref().map(|text| Family::parse(OVER, text)).transpose();
    let family = family.map_err(CaseErrors::from)?;
    let sampling = sampling(arguments);
    let tasks = tasks(&case, &varied, family.as_ref())?;
    for task in &tasks {
        task.check(&sampling, &varied)?;
    }
    check_outputs(arguments, &tasks)?;
    let progress = Progress::start();
    let members = members(&tasks, &sampling, &progress)?;
    let over = family.map(|family| family.field.to_owned());
    let family = CurveFamily { title: case.title, over, sampling, members };
    let files = files(arguments, &family, &progress)?;
    drop(progress);
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| json::document(&family), || summary::text(&family))?;
    if family.is_converged() {
        return Ok(ExitCode::SUCCESS);
    }
    for member in &family.members {
        let name = family.name(member).map_or_else(String::new, |name| format!("{name}: "));
        let failures = member.curve.warnings.iter();
        for failure in failures.filter(|text| text.starts_with("not converged: ")) {
            report::warn(&format!("{name}{failure}"));
        }
    }
    Ok(ExitCode::from(NOT_CONVERGED))
}

/// All curves, on several threads.
fn members(
    tasks: &[Task],
    sampling: &Sampling,
    progress: &Progress,
) -> Result<Vec<Member>, Failure> {
    let watch = progress.watch();
    let done: Vec<AtomicUsize> = tasks.iter().map(|_| AtomicUsize::new(0)).collect();
    let total = Some(tasks.len() * sampling.points);
    let each = tasks.iter().zip(&done).collect();
    parallel::try_map(each, |(task, own): (&Task, &AtomicUsize)| {
        let curve = task.trace(sampling, &|progress| {
            own.store(progress.done, Ordering::Relaxed);
            let done = done.iter().map(|done| done.load(Ordering::Relaxed)).sum();
            watch(schlupf::Progress { done, total, ..progress })
        })?;
        let notices = task.case.notices.clone();
        Ok(Member { value: task.value.clone(), notices, curve })
    })
}

fn sampling(arguments: &CurveArguments) -> Sampling {
    let spacing = match arguments.spacing {
        SpacingArgument::Refined => Spacing::Refined,
        SpacingArgument::Even => Spacing::Even,
    };
    Sampling { points: arguments.points, spacing }
}

/// Which creepages vary, and from where to where.
struct Varied {
    creepage_x: Option<[f64; 2]>,
    creepage_y: Option<[f64; 2]>,
    spin: Option<[f64; 2]>,
    /// Total creepage, and its direction in rad.
    total: Option<([f64; 2], f64)>,
    /// The options as they were given, for messages.
    text: String,
}

impl Varied {
    fn read(arguments: &CurveArguments) -> Result<Self, Failure> {
        let CurveArguments { creepage_x, creepage_y, spin, creepage, direction: angle, .. } =
            arguments;
        let range = |option, field, text: &Option<String>| {
            let text = text.as_deref();
            text.map(|text| range(option, field, text)).transpose().map_err(CaseErrors::from)
        };
        let given = [
            (CREEPAGE_X, creepage_x),
            (CREEPAGE_Y, creepage_y),
            (SPIN, spin),
            (CREEPAGE, creepage),
            ("--direction", angle),
        ];
        let text = given
            .iter()
            .filter_map(|(option, text)| Some(format!("{option} {}", text.as_ref()?)))
            .collect::<Vec<_>>()
            .join(" ");
        let total = match (range(CREEPAGE, "kinematics.creepage_x", creepage)?, angle) {
            (Some(range), Some(angle)) => {
                Some((range, direction("--direction", angle).map_err(CaseErrors::from)?))
            }
            _ => None,
        };
        Ok(Self {
            creepage_x: range(CREEPAGE_X, "kinematics.creepage_x", creepage_x)?,
            creepage_y: range(CREEPAGE_Y, "kinematics.creepage_y", creepage_y)?,
            spin: range(SPIN, "kinematics.spin", spin)?,
            total,
            text,
        })
    }

    /// The creepages of a case with those that vary in their place.
    fn path(&self, case: &Case) -> Result<creep_curve::Path, schlupf::Error> {
        let own = Creepages::of(&case.problem.kinematics);
        let spin = self.spin.unwrap_or([own.spin; 2]);
        if let Some((range, direction)) = self.total {
            return creep_curve::Path::in_direction(range, direction, spin);
        }
        let x = self.creepage_x.unwrap_or([own.x; 2]);
        let y = self.creepage_y.unwrap_or([own.y; 2]);
        let [start, end] = [0, 1].map(|k| Creepages { x: x[k], y: y[k], spin: spin[k] });
        creep_curve::Path::new(start, end)
    }

    /// The option that makes a field of the case count for nothing.
    fn option_in_place_of(&self, field: &str) -> Option<&'static str> {
        match field {
            "kinematics.creepage_x" | "kinematics.angular_velocity" | "kinematics.wheel_radius" => {
                self.total.map(|_| CREEPAGE).or(self.creepage_x.map(|_| CREEPAGE_X))
            }
            "kinematics.creepage_y" | "kinematics.yaw_angle" => {
                self.total.map(|_| CREEPAGE).or(self.creepage_y.map(|_| CREEPAGE_Y))
            }
            "kinematics.spin" => self.spin.map(|_| SPIN),
            _ => None,
        }
    }
}

/// One curve to compute.
struct Task {
    value: Option<String>,
    case: Case,
    path: creep_curve::Path,
}

/// One task, or one for each member of the family.
fn tasks(case: &Case, varied: &Varied, family: Option<&Family>) -> Result<Vec<Task>, Failure> {
    let task = |value: Option<&String>, case: Case| {
        let path = varied.path(&case).map_err(|error| varied.failure(&case, &error))?;
        Ok(Task { value: value.cloned(), case, path })
    };
    let Some(family) = family else {
        return Ok(vec![task(None, case.clone())?]);
    };
    if let Some(option) = varied.option_in_place_of(family.field) {
        let field = family.field;
        let reason = format!("{OVER} must not vary {field}, in place of which {option} varies");
        return Err(Failure::Arguments(reason));
    }
    let members = family.members(case)?;
    family.values.iter().zip(members).map(|(value, case)| task(Some(value), case)).collect()
}

impl Varied {
    /// An error of the core about a curve: of the options that ask for it, or of the case.
    fn failure(&self, case: &Case, error: &schlupf::Error) -> Failure {
        let (schlupf::Error::Invalid { quantity, .. }
        | schlupf::Error::Contradiction { quantity, .. }) = error
        else {
            return Failure::Case(case.explain(error).into());
        };
        let is_of_option = self.option_in_place_of(quantity).is_some();
        if is_of_option {
            Failure::Arguments(format!("{}: {error}", self.text))
        } else {
            Failure::Case(case.explain(error).into())
        }
    }
}

impl Task {
    fn check(&self, sampling: &Sampling, varied: &Varied) -> Result<(), Failure> {
        self.case.require_steady("a creep curve is").map_err(CaseErrors::from)?;
        creep_curve::check(&self.case.problem, &self.path, sampling)
            .map_err(|error| varied.failure(&self.case, &error))
    }

    fn trace(&self, sampling: &Sampling, watch: Watch) -> Result<CreepCurve, Failure> {
        let mut solver = self.case.solver();
        creep_curve::trace(&mut *solver, &self.case.problem, &self.path, sampling, watch)
            .map_err(|error| Failure::Case(self.case.explain(&error).into()))
    }
}

fn check_outputs(arguments: &CurveArguments, tasks: &[Task]) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = [("--json", json), ("--csv", arguments.csv.as_deref())]
        .into_iter()
        .filter_map(|(option, path)| Some((option, path?)))
        .collect();
    let of_task = |task: &Task| Input::of_case(&arguments.case, &task.case);
    let inputs: Vec<Input> = tasks.iter().flat_map(of_task).collect();
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names = figure_files(figures::CREEP_CURVE);
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

/// All files in memory: what cannot be made is known before the first one is written.
fn files(
    arguments: &CurveArguments,
    family: &CurveFamily,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), json::document(family).into_bytes()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path.clone(), csv::table(family).into_bytes()));
    }
    if let Some(directory) = &arguments.figures {
        progress.stage("drawing figures");
        let figure = figures::creep_curve(family)?;
        let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
        files.push((svg, figure.svg.into_bytes()));
        files.push((png, figure.png));
    }
    Ok(files)
}
