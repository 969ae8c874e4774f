//! `schlupf temperature`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use schlupf::temperature_field::{Side, TemperatureField};
use schlupf::{Error, Problem, Solution, Status};
use schlupf_case::{Case, CaseError, CaseErrors, depths, length, position};
use schlupf_output::figures;
use schlupf_output::temperature::{Request, Temperatures, csv, json, summary};

use crate::arguments::TemperatureArguments;
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::{self, Input};
use crate::progress::Progress;
use crate::report;
use crate::solve::figure_files;

/// Solves a case and writes temperatures below a point and along its row.
pub fn run(arguments: &TemperatureArguments) -> Result<ExitCode, Failure> {
    let case = read_case(&arguments.case)?;
    let wanted = Wanted::read(arguments)?;
    let explain = |error: Error| Failure::Case(case.explain(&error).into());
    let what = "temperatures below the surface and in the wake are those";
    case.require_steady(what).map_err(CaseErrors::from)?;
    check_outputs(arguments, &case)?;
    let progress = Progress::start();
    let solution = case.solver().solve(&case.problem, &progress.watch());
    let mut solution = solution.map_err(explain)?;
    let field = TemperatureField::new(&case.problem, &solution).map_err(explain)?;
    let request = wanted.request(&case.problem, &solution, &field)?;
    let (profile, rows) = Temperatures::sample(&field, &request);
    solution.warnings.splice(0..0, case.notices.iter().cloned());
    solution.warnings.extend(TemperatureField::caveat(&case.problem, &solution));
    let temperatures = Temperatures {
        title: case.title,
        status: solution.status,
        request,
        bulk: [case.problem.wheel.bulk_temperature, case.problem.rail.bulk_temperature],
        profile,
        rows,
        warnings: solution.warnings,
    };
    let files = files(arguments, &temperatures, &progress)?;
    drop(progress);
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| json::document(&temperatures), || summary::text(&temperatures))?;
    match solution.status {
        Status::Converged => Ok(ExitCode::SUCCESS),
        Status::NotConverged => {
            let residual = solution.residual;
            report::warn(&format!("not converged: the relative residual is {residual:.1e}"));
            Ok(ExitCode::from(NOT_CONVERGED))
        }
    }
}

/// What the options ask for, lengths in m.
struct Wanted {
    x: Option<f64>,
    y: Option<f64>,
    depth: Option<[f64; 2]>,
    wake: Option<f64>,
    points: usize,
}

impl Wanted {
    fn read(arguments: &TemperatureArguments) -> Result<Self, Failure> {
        let read = || {
            let of = |option, what, text: &Option<String>| {
                text.as_deref().map(|text| position(option, what, text)).transpose()
            };
            Ok(Self {
                x: of("--x", "the place along rolling", &arguments.x)?,
                y: of("--y", "the place across rolling", &arguments.y)?,
                depth: arguments
                    .depth
                    .as_deref()
                    .map(|text| depths("--depth", text))
                    .transpose()?,
                wake: arguments
                    .wake
                    .as_deref()
                    .map(|text| length("--wake", "the length of the wake", text))
                    .transpose()?,
                points: arguments.points,
            })
        };
        read().map_err(|error: CaseError| Failure::Case(CaseErrors::from(error)))
    }

    /// With the defaults that the solution gives.
    fn request(
        &self,
        problem: &Problem,
        solution: &Solution,
        field: &TemperatureField,
    ) -> Result<Request, Failure> {
        let hottest = hottest_point(solution);
        let y = self.y.or(hottest.map(|point| point[1])).unwrap_or_else(|| middle(field));
        let passages = field.passages(y);
        let (Some(first), Some(last)) = (passages.first(), passages.last()) else {
            let [low, high] = field.width().map(millimetres);
            return Err(Failure::Arguments(format!(
                "--y must lie in the contact, between {low} and {high} mm, but is {} mm",
                millimetres(y)
            )));
        };
        let [entry, exit] = [first[0], last[1]];
        let x = self.x.unwrap_or_else(|| match hottest {
            // The edge of a row is a mean: the point of a cell that it cuts may lie ahead of it.
            Some(point) if self.y.is_none() => point[0].min(entry),
            _ => hottest_place(field, [entry, exit], y),
        });
        if x > entry {
            return Err(Failure::Arguments(format!(
                "--x must not lie ahead of the contact, which begins at x = {} mm in the row y = {} mm, \
                 but is {} mm",
                millimetres(entry),
                millimetres(y),
                millimetres(x)
            )));
        }
        let speed = solution.kinematics.speed;
        let diffusivity =
            problem.wheel.material.diffusivity().max(problem.rail.material.diffusivity());
        let reach = |way: f64| (diffusivity * way / speed).sqrt();
        let depth = self.depth.unwrap_or([0.0, DEEPEST * reach(entry - x.min(exit))]);
        let wake = self.wake.unwrap_or(WAKE * (entry - exit)).max(exit - x);
        let row_depths = ROW_DEPTHS.map(|part| part * reach(entry - exit));
        let (point, passage, points) = ([x, y], [entry, exit], self.points);
        Ok(Request { point, passage, depth, wake, row_depths, points })
    }
}

/// The hottest point (x, y) of the contact, in m; `None` where all of it has one temperature.
fn hottest_point(solution: &Solution) -> Option<[f64; 2]> {
    const ALIKE: f64 = 1e-9;
    let rises = &solution.fields.temperature_rise_rail;
    let least = rises.iter().copied().fold(f64::INFINITY, f64::min);
    let temperature = &solution.temperature;
    let spread = temperature.max_rise_rail - least;
    (spread > ALIKE * temperature.max_rise.abs()).then_some([temperature.x, temperature.y])
}

/// The middle of the contact, y in m.
fn middle(field: &TemperatureField) -> f64 {
    let [low, high] = field.width();
    0.5 * (low + high)
}

/// Where a row is hottest on the surface, x in m.
fn hottest_place(field: &TemperatureField, [entry, exit]: [f64; 2], y: f64) -> f64 {
    const PLACES: u32 = 400;
    let heat = |x: f64| field.at(Side::Wheel, x, y, 0.0).max(field.at(Side::Rail, x, y, 0.0));
    let place = |k: u32| entry + (exit - entry) * f64::from(k) / f64::from(PLACES);
    let hotter = |p: &f64, q: &f64| heat(*p).total_cmp(&heat(*q));
    (1..=PLACES).map(place).max_by(hotter).unwrap_or(exit)
}

/// Depth of the profile, in √(κt) of the time since entry, at least that of the passage.
const DEEPEST: f64 = 5.0;
/// Length of the wake over that of the contact.
const WAKE: f64 = 2.0;
/// Depths of the rows below the surface, in √(κt) of the passage.
const ROW_DEPTHS: [f64; 2] = [0.5, 1.0];

/// Four digits are enough to find the mistake.
fn millimetres(value: f64) -> f64 {
    let value = value / 1e-3;
    format!("{value:.3e}").parse().unwrap_or(value)
}

fn check_outputs(arguments: &TemperatureArguments, case: &Case) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = [("--json", json), ("--csv", arguments.csv.as_deref())]
        .into_iter()
        .filter_map(|(option, path)| Some((option, path?)))
        .collect();
    let inputs = Input::of_case(&arguments.case, case);
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names = figure_files(figures::TEMPERATURE);
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

/// All files in memory: what cannot be made is known before the first one is written.
fn files(
    arguments: &TemperatureArguments,
    temperatures: &Temperatures,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), json::document(temperatures).into_bytes()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path.clone(), csv::table(temperatures).into_bytes()));
    }
    if let Some(directory) = &arguments.figures {
        progress.stage("drawing figures");
        let figure = figures::temperature(temperatures)?;
        let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
        files.push((svg, figure.svg.into_bytes()));
        files.push((png, figure.png));
    }
    Ok(files)
}
