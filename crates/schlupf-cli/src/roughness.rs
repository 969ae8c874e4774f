//! `schlupf roughness`.

use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, ValueHint};
use schlupf::interface::roughness::load_curve::LoadCurveOptions;
use schlupf::interface::roughness::micro_model::{MicroModel, MicroModelResult};
use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::surface::HeightMap;
use schlupf::surface::spectrum::{RadialSpectrum, Window};
use schlupf::{Error, Watch};
use schlupf_case::surface::{RoughSurface, SurfaceOrigin};
use schlupf_case::{
    Case, CaseErrors, FieldNames, Files, Folder, GivenByOption, RoughnessRequest, caveats,
    pressures,
};
use schlupf_output::roughness::{RoughnessReport, Spots};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

/// Which surface to press on which bodies, and where to write the results.
#[derive(Debug, Args)]
pub struct Roughness {
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
    /// Write the heights, of both surfaces together and without form, as .npy in m
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub heights: Option<PathBuf>,
    /// Write the pressures in all cells at the largest mean pressure as .npy in Pa
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub pressures: Option<PathBuf>,
    /// Write the gaps there as .npy in m; negative is the depth that was flattened
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub gaps: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A surface to press, and on what.
pub struct Plan {
    case: Case,
    request: RoughnessRequest,
}

impl Task for Roughness {
    type Plan = Plan;
    type Report = RoughnessReport;

    fn case(&self) -> CaseArguments {
        CaseArguments { case: self.case.clone(), overrides: self.overrides.clone() }
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn own_files(&self) -> Vec<OwnFile<'_>> {
        let heights = OwnFile::given("--heights", RoughnessReport::HEIGHTS, self.heights.as_ref());
        let pressures =
            OwnFile::given("--pressures", RoughnessReport::PRESSURES, self.pressures.as_ref());
        let gaps = OwnFile::given("--gaps", RoughnessReport::GAPS, self.gaps.as_ref());
        [heights, pressures, gaps].into_iter().flatten().collect()
    }

    fn plan(&self, case: Case, watch: Watch) -> Result<Plan, Failure> {
        Ok(Plan { request: request(self, &case, watch)?, case })
    }

    fn inputs(&self, plan: &Plan) -> Vec<Input> {
        let mut inputs = Input::of_case(&Task::case(self), &plan.case);
        for (what, path) in [("the surface", &self.surface), ("--second", &self.second)] {
            let input =
                |path: &PathBuf| Input { what: what.to_owned(), path: path.clone(), except: None };
            inputs.extend(path.as_ref().map(input));
        }
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<RoughnessReport>, Failure> {
        let Plan { case, request } = plan;
        progress.stage("reading the surface");
        let rough = request.load().map_err(CaseErrors::from)?;
        let explain = |error: Error| Failure::Case(request.explain(&error).into());
        let result = solve(&case, &request, &rough, progress).map_err(explain)?;
        let is_wanted = [&self.outputs.figures, &self.pressures, &self.gaps];
        let is_wanted = is_wanted.into_iter().any(Option::is_some);
        let spots = is_wanted.then(|| spots(&request, &rough.surface, progress)).transpose();
        let spots = spots.map_err(explain)?;
        Ok(describe(self, &case, (request, rough), (result, spots)).into())
    }
}

/// What the options and the case ask for.
fn request(arguments: &Roughness, case: &Case, watch: Watch) -> Result<RoughnessRequest, Failure> {
    let fields = fields(arguments)?;
    let is_own = arguments.surface.is_none() && arguments.synthetic.is_none();
    let files = (!is_own).then(|| -> Arc<dyn Files> { Folder::new("") });
    let names = if is_own { FieldNames::CASE } else { NAMES };
    match case.rough_contact(&fields, files, names, watch)? {
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
fn fields(arguments: &Roughness) -> Result<Vec<GivenByOption>, Failure> {
    let file = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
    let flag = |is_given: bool| is_given.then(|| "true".to_owned());
    let quoted = |text: String| format!("{text:?}");
    let options = [
        ("file", file(&arguments.surface).map(quoted)),
        ("second_file", file(&arguments.second).map(quoted)),
        ("form", arguments.form.clone()),
        ("cutoff_wavelength", arguments.cutoff.clone()),
        ("unit", arguments.unit.clone().map(quoted)),
        ("spacing", arguments.spacing.clone()),
        ("fill_holes", flag(arguments.fill_holes)),
        ("square_cells", flag(arguments.square_cells)),
        ("cells", arguments.cells.clone()),
        ("seed", arguments.seed.clone()),
        ("hardness", arguments.hardness.clone()),
    ];
    let mut fields = Vec::new();
    let mut push = |option, text: String, field: &str, value: String| {
        fields.push(GivenByOption { option, text, field: field.to_owned(), value });
    };
    for (name, value) in options {
        if let (Some(value), Some(option)) = (value, NAMES.option(&field(name))) {
            let text = value.trim_matches('"').to_owned();
            push(option, text, &field(name), value);
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
fn synthetic(arguments: &Roughness) -> Result<Vec<(String, String, String)>, Failure> {
    let Some(text) = &arguments.synthetic else { return Ok(Vec::new()) };
    let parts = text.split(',').map(|part| {
        let (key, value) = part.split_once('=').unwrap_or((part, ""));
        let (key, value) = (key.trim(), value.trim());
        let field = KEYS.iter().find(|(name, field)| key == *name || key == *field);
        match field {
            Some((_, field)) if !value.is_empty() => {
                Ok((part.trim().to_owned(), self::field(field), value.to_owned()))
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
const NAMES: FieldNames = FieldNames::of_options(&[
    ("contact_law.roughness.file", "SURFACE"),
    ("contact_law.roughness.second_file", "--second"),
    ("contact_law.roughness.form", "--form"),
    ("contact_law.roughness.cutoff_wavelength", "--cutoff"),
    ("contact_law.roughness.unit", "--unit"),
    ("contact_law.roughness.spacing", "--spacing"),
    ("contact_law.roughness.fill_holes", "--fill-holes"),
    ("contact_law.roughness.square_cells", "--square-cells"),
    ("contact_law.roughness.cells", "--cells"),
    ("contact_law.roughness.seed", "--seed"),
    ("contact_law.roughness.hardness", "--hardness"),
    ("contact_law.roughness.pressures", "--pressure"),
    ("contact_law.roughness.rms_height", "rms_height"),
    ("contact_law.roughness.rms_slope", "rms_slope"),
    ("contact_law.roughness.hurst", "hurst"),
    ("contact_law.roughness.longest_wavelength", "longest"),
    ("contact_law.roughness.roll_off_wavelength", "roll_off"),
    ("contact_law.roughness.shortest_wavelength", "shortest"),
]);

/// A field of the roughness.
fn field(name: &str) -> String {
    format!("contact_law.roughness.{name}")
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
    arguments: &Roughness,
    case: &Case,
    (request, rough): (RoughnessRequest, RoughSurface),
    (result, spots): (MicroModelResult, Option<Spots>),
) -> RoughnessReport {
    let title = match (&request.key().source.origin, &arguments.synthetic) {
        (SurfaceOrigin::SelfAffine(_), Some(text)) => format!("self-affine surface, {text}"),
        (SurfaceOrigin::SelfAffine(_), None) => format!("{}, self-affine surface", case.title),
        (SurfaceOrigin::Files { files, .. }, _) => {
            let names: Vec<String> =
                files.iter().map(|file| file.path().display().to_string()).collect();
            names.join(" and ")
        }
    };
    let caveats = caveats(&result, rough.surface.lattice().len(), request.key());
    let warnings = rough.notices.into_iter().chain(caveats).collect();
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
