//! `schlupf roughness`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use schlupf::interface::roughness::load_curve::LoadCurveOptions;
use schlupf::interface::roughness::micro_model::{MicroModel, MicroModelResult};
use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::surface::HeightMap;
use schlupf::surface::spectrum::{RadialSpectrum, Window};
use schlupf::{Error, Status};
use schlupf_case::surface::{RoughSurface, SurfaceOrigin, renamed};
use schlupf_case::{Case, CaseErrors, GivenByOption, RoughnessRequest, caveats, pressures};
use schlupf_output::figures;
use schlupf_output::roughness::{RoughnessReport, Spots, csv, json, npy, summary};

use crate::arguments::{CaseArguments, RoughnessArguments};
use crate::commands::read_case;
use crate::failure::{Failure, NOT_CONVERGED};
use crate::outputs::{self, Input};
use crate::progress::Progress;
use crate::report;
use crate::solve::figure_files;

/// Solves the micro model of a surface and writes what it says about k_c.
pub fn run(arguments: &RoughnessArguments) -> Result<ExitCode, Failure> {
    let case_arguments =
        CaseArguments { case: arguments.case.clone(), overrides: arguments.overrides.clone() };
    let case = read_case(&case_arguments)?;
    let request = request(arguments, &case)?;
    check_outputs(arguments, &case_arguments, &case)?;
    let progress = Progress::start();
    progress.stage("reading the surface");
    let rough = request.load().map_err(|error| in_options(arguments, error.into()))?;
    let explain = |error: Error| in_options(arguments, CaseErrors::from(request.explain(&error)));
    let result = solve(&case, &request, &rough, &progress).map_err(explain)?;
    let is_wanted = [&arguments.figures, &arguments.pressures, &arguments.gaps];
    let spots = match is_wanted.into_iter().flatten().next() {
        Some(_) => Some(spots(&request, &rough.surface, &progress).map_err(explain)?),
        None => None,
    };
    let report = describe(arguments, &case, (request, rough), (result, spots));
    let files = files(arguments, &report, &progress)?;
    drop(progress);
    outputs::write(&files, arguments.figures.as_deref())?;
    arguments.report.print(|| json::document(&report), || summary::text(&report))?;
    match report.status() {
        Status::Converged => Ok(ExitCode::SUCCESS),
        Status::NotConverged => {
            report::warn("not converged: the normal contact at one pressure at least");
            Ok(ExitCode::from(NOT_CONVERGED))
        }
    }
}

/// What the options and the case ask for.
fn request(arguments: &RoughnessArguments, case: &Case) -> Result<RoughnessRequest, Failure> {
    let fields = fields(arguments)?;
    let is_own = arguments.surface.is_none() && arguments.synthetic.is_none();
    let folder = (!is_own).then_some(Path::new(""));
    let request = case.rough_contact(&fields, folder);
    match request.map_err(|errors| in_options(arguments, errors))? {
        Some(request) => Ok(request),
        None => Err(Failure::Arguments(
            "there is no surface: name a file, or make one with --synthetic \
             rms_height=\"1 um\",hurst=0.8,longest=\"100 um\",shortest=\"5 um\""
                .to_owned(),
        )),
    }
}

/// Keys of --synthetic and their fields.
const KEYS: [(&str, &str); 7] = [
    ("rms_height", "rms_height"),
    ("rms_slope", "rms_slope"),
    ("hurst", "hurst"),
    ("longest", "longest_wavelength"),
    ("roll_off", "roll_off_wavelength"),
    ("shortest", "shortest_wavelength"),
    ("seed", "seed"),
];

/// The fields that the options give.
fn fields(arguments: &RoughnessArguments) -> Result<Vec<GivenByOption>, Failure> {
    let file = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
    let flag = |is_given: bool| is_given.then(|| "true".to_owned());
    let quoted = |text: String| format!("{text:?}");
    let options = [
        ("SURFACE", "file", file(&arguments.surface).map(quoted)),
        ("--second", "second_file", file(&arguments.second).map(quoted)),
        ("--form", "form", arguments.form.clone()),
        ("--cutoff", "cutoff_wavelength", arguments.cutoff.clone()),
        ("--unit", "unit", arguments.unit.clone().map(quoted)),
        ("--spacing", "spacing", arguments.spacing.clone()),
        ("--fill-holes", "fill_holes", flag(arguments.fill_holes)),
        ("--square-cells", "square_cells", flag(arguments.square_cells)),
        ("--cells", "cells", arguments.cells.clone()),
        ("--seed", "seed", arguments.seed.clone()),
        ("--hardness", "hardness", arguments.hardness.clone()),
    ];
    let mut fields = Vec::new();
    let mut push = |option, text: String, field: &str, value: String| {
        fields.push(GivenByOption { option, text, field: field.to_owned(), value });
    };
    for (option, name, value) in options {
        if let Some(value) = value {
            let text = value.trim_matches('"').to_owned();
            push(option, text, &format!("contact_law.roughness.{name}"), value);
        }
    }
    for (text, field, value) in synthetic(arguments)? {
        push("--synthetic", text, &field, value);
    }
    if let Some(friction) = &arguments.friction {
        push("--friction", friction.clone(), "friction.coefficient", friction.clone());
    }
    let is_given = arguments.surface.is_some() || arguments.synthetic.is_some();
    let default = (is_given && arguments.case.is_none()).then(|| DEFAULT_PRESSURES.to_owned());
    if let Some(text) = arguments.pressure.clone().or(default) {
        let mut values = pressures("--pressure", &text).map_err(CaseErrors::from)?;
        values.sort_by(f64::total_cmp);
        let array: Vec<String> = values.iter().map(|value| format!("\"{value:e} Pa\"")).collect();
        let array = format!("[{}]", array.join(","));
        push("--pressure", text, "contact_law.roughness.pressures", array);
    }
    Ok(fields)
}

/// Mean pressures where nothing else says any.
const DEFAULT_PRESSURES: &str = "0.2..1.2 GPa";

/// Text, field and value of every part of --synthetic.
fn synthetic(arguments: &RoughnessArguments) -> Result<Vec<(String, String, String)>, Failure> {
    let Some(text) = &arguments.synthetic else { return Ok(Vec::new()) };
    let parts = text.split(',').map(|part| {
        let (key, value) = part.split_once('=').unwrap_or((part, ""));
        let (key, value) = (key.trim(), value.trim());
        let field = KEYS.iter().find(|(name, field)| key == *name || key == *field);
        match field {
            Some((_, field)) if !value.is_empty() => {
                let field = format!("contact_law.roughness.{field}");
                Ok((part.trim().to_owned(), field, value.to_owned()))
            }
            _ => Err(Failure::Arguments(format!(
                "--synthetic must be key=value,key=value,… with the keys {}, but has {part:?}",
                KEYS.map(|(name, _)| name).join(", ")
            ))),
        }
    });
    let parts = parts.collect::<Result<Vec<(String, String, String)>, Failure>>()?;
    let is_named = |field: &str| parts.iter().any(|(_, path, _)| path.ends_with(field));
    if !["longest_wavelength", "shortest_wavelength"].into_iter().all(is_named) {
        return Err(Failure::Arguments(format!(
            "--synthetic must name the longest and the shortest wavelength, such as \
             rms_height=\"1 um\",longest=\"100 um\",shortest=\"5 um\", but is {text:?}"
        )));
    }
    Ok(parts)
}

/// What fields of a case are called as options.
const NAMES: &[(&str, &str)] = &[
    ("contact_law.roughness.file", "SURFACE"),
    ("contact_law.roughness.second_file", "--second"),
    ("contact_law.roughness.form", "--form"),
    ("contact_law.roughness.cutoff_wavelength", "--cutoff"),
    ("contact_law.roughness.unit", "--unit"),
    ("contact_law.roughness.spacing", "--spacing"),
    ("contact_law.roughness.cells", "--cells"),
    ("contact_law.roughness.hardness", "--hardness"),
    ("contact_law.roughness.pressures", "--pressure"),
    ("contact_law.roughness.longest_wavelength", "longest"),
    ("contact_law.roughness.roll_off_wavelength", "roll_off"),
    ("contact_law.roughness.shortest_wavelength", "shortest"),
    ("contact_law.roughness.", ""),
    ("fill_holes = true fills them", "--fill-holes fills them"),
    ("square_cells = true resamples it", "--square-cells resamples it"),
    ("; paths are relative to the case file", ""),
];

/// Errors in terms of the options where these give the surface, else of the case.
fn in_options(arguments: &RoughnessArguments, errors: CaseErrors) -> Failure {
    if arguments.surface.is_none() && arguments.synthetic.is_none() {
        return Failure::Case(errors);
    }
    let named = |error: schlupf_case::CaseError| renamed(error, NAMES);
    let CaseErrors { first, others } = errors;
    let others = others.into_iter().map(named).collect();
    Failure::Case(CaseErrors { first: Box::new(named(*first)), others })
}

/// The micro model; that of the case is taken over where it is the same.
fn solve(
    case: &Case,
    request: &RoughnessRequest,
    rough: &RoughSurface,
    progress: &Progress,
) -> Result<MicroModelResult, Error> {
    let (key, bodies) = (request.key(), request.bodies());
    let mean_pressures = request.mean_pressures();
    if let Some(solved) = case.micro_contact().filter(|solved| solved.serves(key, mean_pressures)) {
        let normal = solved.result.normal.clone();
        return MicroModelResult::new(solved.result.statistics, normal, bodies, mean_pressures);
    }
    let model = MicroModel {
        surface: rough.surface.clone(),
        contact_modulus: key.contact_modulus,
        bodies: *bodies,
        hardness: key.hardness,
        mean_pressures: mean_pressures.to_vec(),
    };
    model.solve(&LoadCurveOptions::default(), &progress.watch())
}

/// The contact at the largest mean pressure.
fn spots(
    request: &RoughnessRequest,
    surface: &HeightMap,
    progress: &Progress,
) -> Result<Spots, Error> {
    let key = request.key();
    let distance = surface.distance_to_plane();
    let contact = RoughContact::new(distance, key.contact_modulus, Boundary::Periodic)?;
    let mut contact = contact.with_hardness(key.hardness)?;
    let solution =
        contact.press(key.largest_pressure, &RoughContactOptions::default(), &progress.watch())?;
    Ok(Spots {
        mean_pressure: key.largest_pressure,
        is_converged: solution.is_converged,
        pressure: solution.pressure,
        gap: solution.gap,
    })
}

fn describe(
    arguments: &RoughnessArguments,
    case: &Case,
    (request, rough): (RoughnessRequest, RoughSurface),
    (result, spots): (MicroModelResult, Option<Spots>),
) -> RoughnessReport {
    let title = match (&request.key().source.origin, &arguments.synthetic) {
        (SurfaceOrigin::SelfAffine(_), Some(text)) => format!("self-affine surface, {text}"),
        (SurfaceOrigin::SelfAffine(_), None) => format!("{}, self-affine surface", case.title),
        (SurfaceOrigin::Files { files, .. }, _) => {
            let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
            names.join(" and ")
        }
    };
    let mut warnings = rough.notices;
    warnings.extend(caveats(&result, rough.surface.lattice().len(), request.key()));
    RoughnessReport {
        title,
        spectrum: RadialSpectrum::of(&rough.surface, Window::of(&rough.surface)),
        surface: rough.surface,
        bodies: *request.bodies(),
        contact_modulus: request.key().contact_modulus,
        hardness: request.key().hardness,
        result,
        spots,
        remarks: rough.remarks,
        warnings,
    }
}

fn check_outputs(
    arguments: &RoughnessArguments,
    case_arguments: &CaseArguments,
    case: &Case,
) -> Result<(), Failure> {
    let json = arguments.report.json_file();
    let outputs: Vec<(&str, &Path)> = [
        ("--json", json),
        ("--csv", arguments.csv.as_deref()),
        ("--heights", arguments.heights.as_deref()),
        ("--pressures", arguments.pressures.as_deref()),
        ("--gaps", arguments.gaps.as_deref()),
    ]
    .into_iter()
    .filter_map(|(option, path)| Some((option, path?)))
    .collect();
    let mut inputs = Input::of_case(case_arguments, case);
    for (what, path) in [("the surface", &arguments.surface), ("--second", &arguments.second)] {
        let input =
            |path: &PathBuf| Input { what: what.to_owned(), path: path.clone(), except: None };
        inputs.extend(path.as_ref().map(input));
    }
    match &arguments.figures {
        None => outputs::check(&outputs, &inputs),
        Some(directory) => {
            let names: Vec<String> =
                figures::ROUGHNESS.iter().flat_map(|name| figure_files(name)).collect();
            outputs::check_with_directory(&outputs, &inputs, ("--figures", directory), &names)
        }
    }
}

/// All files in memory: what cannot be made is known before the first one is written.
fn files(
    arguments: &RoughnessArguments,
    report: &RoughnessReport,
    progress: &Progress,
) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    if let Some(path) = arguments.report.json_file() {
        files.push((path.to_owned(), json::document(report).into_bytes()));
    }
    if let Some(path) = &arguments.csv {
        files.push((path.clone(), csv::table(report).into_bytes()));
    }
    if let Some(path) = &arguments.heights {
        files.push((path.clone(), npy::heights(report)));
    }
    if let Some(fields) = npy::contact(report) {
        for (path, field) in [&arguments.pressures, &arguments.gaps].into_iter().zip(fields) {
            files.extend(path.iter().map(|path| (path.clone(), field.clone())));
        }
    }
    if let Some(directory) = &arguments.figures {
        progress.stage("drawing figures");
        for figure in figures::roughness(report)? {
            let [svg, png] = figure_files(&figure.name).map(|name| directory.join(name));
            files.push((svg, figure.svg.into_bytes()));
            files.push((png, figure.png));
        }
    }
    Ok(files)
}
