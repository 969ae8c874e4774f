//! `schlupf roughness`.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, ValueHint};
use schlupf::Watch;
use schlupf::message::quoted;
use schlupf_case::{
    CaseErrors, CaseFile, FieldNames, Files, GivenByOption, RoughnessRequest, pressures,
};
use schlupf_output::roughness::RoughnessReport;
use schlupf_tasks::roughness::Plan;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, OwnFile, Task};

/// Which surface to press on which bodies, and where to write the results.
#[derive(Debug, Args)]
pub struct Roughness {
    /// Surface or profile of one body, or of both together (.csv, .npy, .x3p, .xyz); without it and
    /// without --synthetic that of the case
    #[arg(value_hint = ValueHint::FilePath, conflicts_with = "synthetic")]
    pub surface: Option<PathBuf>,
    /// Surface of the other body, on the same lattice: their heights are added
    #[arg(long, value_name = "SURFACE", value_hint = ValueHint::FilePath, requires = "surface")]
    pub second: Option<PathBuf>,
    /// Make a self-affine surface, such as rms_height="1 um",hurst=0.8,longest="100 um",shortest="5
    /// um",seed=1; also rms_slope and roll_off
    #[arg(long, value_name = "KEY=VALUE,…")]
    pub synthetic: Option<String>,
    /// Form to remove from a measured surface [default: plane]
    #[arg(long, value_name = "plane|cylinder|sphere|none", requires = "surface")]
    pub form: Option<String>,
    /// Remove waves longer than this from a measured surface, such as "0.8 mm" (λc of the Gaussian
    /// filter, ISO 16610)
    #[arg(long, value_name = "LENGTH", requires = "surface")]
    pub cutoff: Option<String>,
    /// Unit of the heights of an .npy file, of all lengths of an .xyz file, such as um
    #[arg(long, value_name = "UNIT", requires = "surface")]
    pub unit: Option<String>,
    /// Spacing of the points of an .npy file or of heights alone, such as "1 um"
    #[arg(long, value_name = "LENGTH", requires = "surface")]
    pub spacing: Option<String>,
    /// Fill points without a height smoothly
    #[arg(long, requires = "surface")]
    pub fill_holes: bool,
    /// Resample a surface whose cells are not square
    #[arg(long, requires = "surface")]
    pub square_cells: bool,
    /// Cells along x of the resampled or synthetic surface
    #[arg(long, value_name = "N")]
    pub cells: Option<String>,
    /// Seed of a surface generated from a profile
    #[arg(long, value_name = "N", requires = "surface")]
    pub seed: Option<String>,
    /// Mean pressures: a range (six pressures) or a list [default: 0.2..1.2 GPa; those of
    /// the patch with --case]
    #[arg(long, allow_hyphen_values = true, value_name = "START..END|P,P,…")]
    pub pressure: Option<String>,
    /// Coefficient of friction [default: that of the case]
    #[arg(long, allow_hyphen_values = true, value_name = "MU")]
    pub friction: Option<String>,
    /// Hardness of the softer body, such as "2.5 GPa" [default: elastic bodies]
    #[arg(long, allow_hyphen_values = true, value_name = "PRESSURE")]
    pub hardness: Option<String>,
    /// Case file of the bodies [default: steel wheel and rail]
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
    /// Write the gaps there as .npy in m; a negative gap is the flattened depth
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub gaps: Option<PathBuf>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
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

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let title = file.title().map_err(CaseErrors::from)?;
        let request = request(self, &file, watch)?;
        let wanted = [&self.outputs.figures, &self.pressures, &self.gaps];
        let with_spots = wanted.into_iter().any(Option::is_some);
        Ok(Plan { title, request, generated: self.generated(), with_spots })
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&Task::case(self), file);
        for (what, path) in [("the surface", &self.surface), (SECOND, &self.second)] {
            let input =
                |path: &PathBuf| Input { what: what.to_owned(), path: path.clone(), except: None };
            inputs.extend(path.as_ref().map(input));
        }
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<RoughnessReport>, Failure> {
        progress.stage("reading the surface");
        Ok(plan.find(&progress.watch())?.into())
    }
}

impl Roughness {
    /// The options of a synthetic surface.
    fn generated(&self) -> Option<String> {
        let seed = self.seed.as_ref().map_or_else(String::new, |seed| format!(",seed={seed}"));
        self.synthetic.as_ref().map(|text| format!("{text}{seed}"))
    }
}

/// What the options and the case ask for.
fn request(
    arguments: &Roughness,
    case: &CaseFile,
    watch: Watch,
) -> Result<RoughnessRequest, Failure> {
    let fields = fields(arguments)?;
    let is_own = arguments.surface.is_none() && arguments.synthetic.is_none();
    let files = (!is_own).then(|| -> Arc<dyn Files> { Arc::new(files(arguments)) });
    let names = if is_own { FieldNames::CASE } else { FieldNames::of_options(option) };
    match case.rough_contact(&fields, files, names, watch)? {
        Some(request) => Ok(request),
        None => Err(Failure::Arguments(
            "there is no surface: name a file, or make one with --synthetic \
             rms_height=\"1 um\",hurst=0.8,longest=\"100 um\",shortest=\"5 um\""
                .to_owned(),
        )),
    }
}

/// A field of the roughness, as this command gives it.
struct Given {
    /// Last part of its path.
    field: &'static str,
    /// The option.
    option: Option<&'static str>,
    /// The key of --synthetic.
    key: Option<&'static str>,
    /// What the option says, as in a case file.
    value: fn(&Roughness) -> Option<String>,
}

impl Given {
    const fn by_option(
        field: &'static str,
        option: &'static str,
        value: fn(&Roughness) -> Option<String>,
    ) -> Self {
        Self { field, option: Some(option), key: None, value }
    }

    const fn by_key(field: &'static str, key: &'static str) -> Self {
        Self { field, option: None, key: Some(key), value: |_| None }
    }

    /// Dotted path of the field.
    fn path(&self) -> String {
        format!("{SECTION}{}", self.field)
    }
}

const SECTION: &str = "contact_law.roughness.";
const SURFACE: &str = "SURFACE";
const SECOND: &str = "--second";

/// All of them.
const GIVEN: [Given; 18] = [
    Given::by_option("file", SURFACE, |a| a.surface.as_ref().map(|_| as_toml(SURFACE))),
    Given::by_option("second_file", SECOND, |a| a.second.as_ref().map(|_| as_toml(SECOND))),
    Given::by_option("form", "--form", |a| a.form.clone()),
    Given::by_option("cutoff_wavelength", "--cutoff", |a| a.cutoff.clone()),
    Given::by_option("unit", "--unit", |a| a.unit.as_deref().map(as_toml)),
    Given::by_option("spacing", "--spacing", |a| a.spacing.clone()),
    Given::by_option("fill_holes", "--fill-holes", |a| a.fill_holes.then(|| "true".to_owned())),
    Given::by_option("square_cells", "--square-cells", |a| {
        a.square_cells.then(|| "true".to_owned())
    }),
    Given::by_option("cells", "--cells", |a| a.cells.clone()),
    Given::by_key("rms_height", "rms_height"),
    Given::by_key("rms_slope", "rms_slope"),
    Given::by_key("hurst", "hurst"),
    Given::by_key("longest_wavelength", "longest"),
    Given::by_key("roll_off_wavelength", "roll_off"),
    Given::by_key("shortest_wavelength", "shortest"),
    Given { key: Some("seed"), ..Given::by_option("seed", "--seed", |a| a.seed.clone()) },
    Given::by_option("hardness", "--hardness", |a| a.hardness.clone()),
    // Its value may be refused, and has a default: see `fields`.
    Given::by_option("pressures", "--pressure", |_| None),
];

/// What a field of a case is called here.
fn option(path: &str) -> Option<&'static str> {
    let field = path.strip_prefix(SECTION)?;
    GIVEN.iter().find(|given| given.field == field).and_then(|given| given.option.or(given.key))
}

fn as_toml(text: &str) -> String {
    format!("{text:?}")
}

/// The files that options name, by the options: paths need not be text.
fn files(arguments: &Roughness) -> BTreeMap<String, PathBuf> {
    let files = [(SURFACE, &arguments.surface), (SECOND, &arguments.second)];
    files
        .into_iter()
        .filter_map(|(option, path)| Some((option.to_owned(), path.clone()?)))
        .collect()
}

/// The fields that the options give.
fn fields(arguments: &Roughness) -> Result<Vec<GivenByOption>, Failure> {
    let mut fields = synthetic(arguments)?;
    let files = files(arguments);
    for given in &GIVEN {
        if let (Some(option), Some(value)) = (given.option, (given.value)(arguments)) {
            let text = files.get(option).map(|path| path.display().to_string());
            let text = text.unwrap_or_else(|| value.trim_matches('"').to_owned());
            fields.push(GivenByOption { option: option.into(), text, field: given.path(), value });
        }
    }
    if let Some(friction) = &arguments.friction {
        let (option, field) = ("--friction", "friction.coefficient".to_owned());
        fields.push(GivenByOption {
            option: option.into(),
            text: friction.clone(),
            field,
            value: friction.clone(),
        });
    }
    let is_given = arguments.surface.is_some() || arguments.synthetic.is_some();
    let default = (is_given && arguments.case.is_none()).then(|| DEFAULT_PRESSURES.to_owned());
    if let Some(text) = arguments.pressure.clone().or(default) {
        let mut values = pressures("--pressure", &text).map_err(CaseErrors::from)?;
        values.sort_by(f64::total_cmp);
        let array: Vec<String> = values.iter().map(|value| format!("\"{value:e} Pa\"")).collect();
        let (field, value) = (format!("{SECTION}pressures"), format!("[{}]", array.join(",")));
        fields.push(GivenByOption { option: "--pressure".into(), text, field, value });
    }
    Ok(fields)
}

/// Mean pressures where nothing else says any.
const DEFAULT_PRESSURES: &str = "0.2..1.2 GPa";

/// The fields that --synthetic gives.
fn synthetic(arguments: &Roughness) -> Result<Vec<GivenByOption>, Failure> {
    let Some(text) = &arguments.synthetic else { return Ok(Vec::new()) };
    let parts = text.split(',').map(|part| {
        let (key, value) = part.split_once('=').unwrap_or((part, ""));
        let (key, value) = (key.trim(), value.trim());
        let is_meant = |own: &str, given: &Given| key == own || key == given.field;
        let given = GIVEN.iter().find(|given| given.key.is_some_and(|own| is_meant(own, given)));
        match given {
            Some(given) if !value.is_empty() => Ok(GivenByOption {
                option: "--synthetic".into(),
                text: part.trim().to_owned(),
                field: given.path(),
                value: value.to_owned(),
            }),
            _ => Err(Failure::Arguments(format!(
                "--synthetic must be key=value,key=value,… with the keys {}, but has {}",
                GIVEN.iter().filter_map(|given| given.key).collect::<Vec<_>>().join(", "),
                quoted(part)
            ))),
        }
    });
    let parts = parts.collect::<Result<Vec<_>, Failure>>()?;
    refuse_repeated(arguments, &parts)?;
    let is_named = |field: &str| parts.iter().any(|part| part.field.ends_with(field));
    if !["longest_wavelength", "shortest_wavelength"].into_iter().all(is_named) {
        return Err(Failure::Arguments(format!(
            "--synthetic must name the longest and the shortest wavelength, such as \
             rms_height=\"1 um\",longest=\"100 um\",shortest=\"5 um\", but is {}",
            quoted(text)
        )));
    }
    Ok(parts)
}

/// Refuses a key of --synthetic that is given twice, or by an option, too.
fn refuse_repeated(arguments: &Roughness, parts: &[GivenByOption]) -> Result<(), Failure> {
    for (k, part) in parts.iter().enumerate() {
        if let Some(first) = parts[..k].iter().find(|first| first.field == part.field) {
            return Err(Failure::Arguments(format!(
                "--synthetic must give a key once, but has {} and {}",
                quoted(&first.text),
                quoted(&part.text)
            )));
        }
        let mut given = GIVEN.iter().filter(|given| given.path() == part.field);
        let twice = given.find_map(|given| Some((given.option?, (given.value)(arguments)?)));
        if let Some((option, value)) = twice {
            return Err(Failure::Arguments(format!(
                "--synthetic must not give what {option} gives, but has {} and {option} is {}",
                quoted(&part.text),
                quoted(&value)
            )));
        }
    }
    Ok(())
}
