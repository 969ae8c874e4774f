//! The fields of a case that a request gives in their place.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::path::PathBuf;
use std::sync::{Arc, LazyLock};

use schlupf::Watch;
use schlupf::reporting::quoted;
use schlupf_case::document::without_quotes;
use schlupf_case::fields::Kind;
use schlupf_case::{
    CaseError, FieldNames, FieldPath, Files, GivenByOption, InputFile, RoughnessRequest, field,
    pressures,
};

use super::Request;
use crate::TaskError;
use crate::request::{Asked, Face, Field, Form, Request as _};
use crate::task::Given;

const SECTION: &str = "contact_law.roughness";
const PRESSURES: FieldPath = field!("contact_law.roughness.pressures");

/// Mean pressures where nothing else says any.
const DEFAULT_PRESSURES: &str = "0.2..1.2 GPa";

/// What is given of a measured surface.
pub(super) const OF_SURFACE: &[&str] =
    &["second", "form", "cutoff", "unit", "spacing", "fill_holes", "square_cells", "seed"];

/// Fields of the roughness that `synthetic` gives, with its keys.
const KEYS: [(FieldPath, &str); 7] = [
    (field!("contact_law.roughness.rms_height"), "rms_height"),
    (field!("contact_law.roughness.rms_slope"), "rms_slope"),
    (field!("contact_law.roughness.hurst"), "hurst"),
    (LONGEST, "longest"),
    (field!("contact_law.roughness.roll_off_wavelength"), "roll_off"),
    (SHORTEST, "shortest"),
    (field!("contact_law.roughness.seed"), "seed"),
];
const LONGEST: FieldPath = field!("contact_law.roughness.longest_wavelength");
const SHORTEST: FieldPath = field!("contact_law.roughness.shortest_wavelength");

/// What options call the fields of the case that the request gives.
static OPTIONS: LazyLock<Names> = LazyLock::new(|| names(Face::Command));

/// What functions call them.
static ARGUMENTS: LazyLock<Names> = LazyLock::new(|| names(Face::Functions));

/// Paths of fields, and what they are called.
type Names = Vec<(FieldPath, String)>;

fn names(face: Face) -> Names {
    let of_case = of_case();
    let none = |_: &Field| Ok::<_, Infallible>(Vec::new());
    let Ok(asked) = Asked::new(face, Request::fields(), none);
    of_case.into_iter().map(|(name, path)| (path, asked.name(name))).collect()
}

/// The fields of the request that stand for one of the case, with its path.
fn of_case() -> Vec<(&'static str, FieldPath)> {
    let path = |field: Field| match field.form {
        Form::OfCase(path) => Some((field.name, path)),
        _ => None,
    };
    Request::fields().into_iter().filter_map(path).collect()
}

fn called(names: &'static Names, path: FieldPath) -> Option<&'static str> {
    if path.section() != SECTION {
        return None;
    }
    let name = names.iter().find(|(own, _)| *own == path);
    let key = || KEYS.iter().find(|(own, _)| *own == path);
    name.map(|(_, name)| name.as_str()).or_else(|| key().map(|(_, key)| *key))
}

/// Pressures (in Pa) in ascending order, as in a case file.
fn array(mut pressures: Vec<f64>) -> String {
    pressures.sort_unstable_by(f64::total_cmp);
    let each: Vec<String> = pressures.iter().map(|value| format!("\"{value:e} Pa\"")).collect();
    format!("[{}]", each.join(","))
}

impl Request {
    /// How a synthetic surface is made.
    pub(super) fn generated(&self) -> Option<String> {
        let seed = self.seed.as_ref().map_or_else(String::new, |seed| format!(",seed={seed}"));
        self.synthetic.as_ref().map(|text| format!("{text}{seed}"))
    }

    /// What this and the case ask for.
    pub(super) fn of_case(&self, of: &Given, watch: Watch) -> Result<RoughnessRequest, TaskError> {
        let asked = &self.asked;
        let fields = self.of_fields(of.is_default)?;
        let files = self.is_given().then(|| -> Arc<dyn Files> { Arc::new(self.files()) });
        let names = match (self.is_given(), asked.face()) {
            (false, _) => FieldNames::CASE,
            (true, Face::Command) => FieldNames::of_options(|path| called(&OPTIONS, path)),
            (true, Face::Functions) => FieldNames::of_options(|path| called(&ARGUMENTS, path)),
        };
        of.case.rough_contact(&fields, files, names, watch)?.ok_or_else(|| {
            let [surface, synthetic] = ["surface", "synthetic"].map(|name| asked.name(name));
            TaskError::Request(format!(
                "there is no surface: name one with {surface}, make one with {synthetic} \
                 rms_height=\"1 um\",hurst=0.8,longest=\"100 um\",shortest=\"5 um\", or give \
                 contact_law.roughness in the case: file, or rms_height, longest_wavelength and \
                 shortest_wavelength"
            ))
        })
    }

    /// Whether it has a surface of its own.
    fn is_given(&self) -> bool {
        self.surface.is_some() || self.synthetic.is_some()
    }

    /// The files that it names, by its fields: paths need not be text.
    fn files(&self) -> BTreeMap<String, PathBuf> {
        let named =
            ["surface", "second"].map(|name| Some((name.to_owned(), self.file(name)?.path())));
        named.into_iter().flatten().collect()
    }

    fn file(&self, name: &str) -> Option<&InputFile> {
        if name == "surface" { self.surface.as_ref() } else { self.second.as_ref() }
    }

    /// The fields of the case that it gives; pressures, too, where there is no case that has them.
    fn of_fields(&self, is_default: bool) -> Result<Vec<GivenByOption>, TaskError> {
        let mut fields = self.of_synthetic()?;
        let default = (self.is_given() && is_default).then(|| DEFAULT_PRESSURES.to_owned());
        for (name, path) in of_case() {
            let option = self.asked.name(name);
            let default = default.clone().filter(|_| path == PRESSURES);
            let Some(text) = self.asked.text(name).or(default) else { continue };
            let value = match Form::OfCase(path).of_case() {
                Some(Kind::Flag) => "true".to_owned(),
                // Paths need not be text: see `files`.
                Some(Kind::Path) => {
                    let data = self.file(name).filter(|file| file.data().is_some());
                    data.map_or(name, InputFile::name).to_owned()
                }
                Some(Kind::Text | Kind::Quantity(_)) => format!("{:?}", without_quotes(&text)),
                Some(Kind::Quantities(_)) => array(pressures(&option, &text)?),
                _ => text.clone(),
            };
            fields.push(GivenByOption { option: option.into(), text, field: path, value });
        }
        Ok(fields)
    }

    /// Those that `synthetic` gives.
    fn of_synthetic(&self) -> Result<Vec<GivenByOption>, CaseError> {
        let Some(text) = &self.synthetic else { return Ok(Vec::new()) };
        let own = self.asked.name("synthetic");
        let parts = text.split(',').map(|part| {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            let (key, value) = (key.trim(), value.trim());
            match KEYS.iter().find(|(field, own)| key == *own || key == field.name()) {
                Some((field, _)) if !value.is_empty() => Ok(GivenByOption {
                    option: own.clone().into(),
                    text: part.trim().to_owned(),
                    field: *field,
                    value: value.to_owned(),
                }),
                _ => {
                    let keys: Vec<&str> = KEYS.iter().map(|(_, key)| *key).collect();
                    let (keys, part) = (keys.join(", "), quoted(part));
                    Err(self.refused(format!(
                        "{own} must be key=value,key=value,… with the keys {keys}, but has {part}"
                    )))
                }
            }
        });
        let parts = parts.collect::<Result<Vec<_>, CaseError>>()?;
        self.refuse_repeated(&parts)?;
        let is_named = |field| parts.iter().any(|part| part.field == field);
        if ![LONGEST, SHORTEST].into_iter().all(is_named) {
            return Err(self.refused(format!(
                "{own} must name the longest and the shortest wavelength, such as \
                 rms_height=\"1 um\",longest=\"100 um\",shortest=\"5 um\", but is {}",
                quoted(text)
            )));
        }
        Ok(parts)
    }

    fn refused(&self, message: String) -> CaseError {
        self.asked.refuse("synthetic", message)
    }

    /// Refuses a key of `synthetic` that is given twice, or by another field, too.
    fn refuse_repeated(&self, parts: &[GivenByOption]) -> Result<(), CaseError> {
        let own = self.asked.name("synthetic");
        for (k, part) in parts.iter().enumerate() {
            let text = quoted(&part.text);
            if let Some(first) = parts[..k].iter().find(|first| first.field == part.field) {
                let first = quoted(&first.text);
                return Err(
                    self.refused(format!("{own} must give a key once, but has {first} and {text}"))
                );
            }
            let mut fields = of_case().into_iter().filter(|(_, path)| *path == part.field);
            let twice = fields.find_map(|(name, _)| Some((name, self.asked.text(name)?)));
            if let Some((name, value)) = twice {
                let (name, value) = (self.asked.name(name), quoted(&value));
                return Err(self.refused(format!(
                    "{own} must not give what {name} gives, but has {text} and {name} is {value}"
                )));
            }
        }
        Ok(())
    }
}
