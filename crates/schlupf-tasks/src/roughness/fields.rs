//! The fields of a case that a request gives in their place.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use schlupf::Watch;
use schlupf::message::quoted;
use schlupf_case::{CaseError, FieldNames, Files, GivenByOption, RoughnessRequest, pressures};

use super::Request;
use crate::TaskError;
use crate::request::Face;
use crate::task::Given;

const SECTION: &str = "contact_law.roughness.";

/// Mean pressures where nothing else says any.
const DEFAULT_PRESSURES: &str = "0.2..1.2 GPa";

/// What is given of a measured surface.
const OF_SURFACE: [&str; 8] =
    ["second", "form", "cutoff", "unit", "spacing", "fill_holes", "square_cells", "seed"];

/// Fields of the roughness by the last part of their paths, with what gives them here: the field of
/// the request, and its option.
const FIELDS: [(&str, &str, &str); 12] = [
    ("file", "surface", "SURFACE"),
    ("second_file", "second", "--second"),
    ("form", "form", "--form"),
    ("cutoff_wavelength", "cutoff", "--cutoff"),
    ("unit", "unit", "--unit"),
    ("spacing", "spacing", "--spacing"),
    ("fill_holes", "fill_holes", "--fill-holes"),
    ("square_cells", "square_cells", "--square-cells"),
    ("cells", "cells", "--cells"),
    ("seed", "seed", "--seed"),
    ("hardness", "hardness", "--hardness"),
    ("pressures", "pressure", "--pressure"),
];

/// The same of those that `synthetic` gives, with its keys.
const KEYS: [(&str, &str); 7] = [
    ("rms_height", "rms_height"),
    ("rms_slope", "rms_slope"),
    ("hurst", "hurst"),
    ("longest_wavelength", "longest"),
    ("roll_off_wavelength", "roll_off"),
    ("shortest_wavelength", "shortest"),
    ("seed", "seed"),
];

/// What the options call a field of the case.
fn option(path: &str) -> Option<&'static str> {
    let field = path.strip_prefix(SECTION)?;
    FIELDS.iter().find(|(own, ..)| *own == field).map(|(.., option)| *option).or(key(field))
}

/// What functions call it.
fn argument(path: &str) -> Option<&'static str> {
    let field = path.strip_prefix(SECTION)?;
    FIELDS.iter().find(|(own, ..)| *own == field).map(|(_, name, _)| *name).or(key(field))
}

fn key(field: &str) -> Option<&'static str> {
    KEYS.iter().find(|(own, _)| *own == field).map(|(_, key)| *key)
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
        asked.require_one_of(&["surface", "synthetic"])?;
        if self.synthetic.is_none() {
            asked.require_with(&OF_SURFACE, "surface")?;
        }
        let fields = self.fields(of.is_default)?;
        let files = self.is_given().then(|| -> Arc<dyn Files> { Arc::new(self.files()) });
        let names = match (self.is_given(), asked.face()) {
            (false, _) => FieldNames::CASE,
            (true, Face::Command) => FieldNames::of_options(option),
            (true, Face::Functions) => FieldNames::of_options(argument),
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
        let files = [("surface", &self.surface), ("second", &self.second)];
        let named = files.into_iter().filter_map(|(name, file)| Some((name, file.as_ref()?)));
        named.map(|(name, file)| (name.to_owned(), file.path())).collect()
    }

    /// What a field of it says, as in a case file.
    fn value(&self, name: &str) -> Option<String> {
        let flag = |is_given: bool| is_given.then(|| "true".to_owned());
        let text = |text: &str| format!("{text:?}");
        match name {
            "surface" => self.surface.as_ref().map(|_| text(name)),
            "second" => self.second.as_ref().map(|_| text(name)),
            "form" => self.form.clone(),
            "cutoff" => self.cutoff.clone(),
            "unit" => self.unit.as_deref().map(text),
            "spacing" => self.spacing.clone(),
            "fill_holes" => flag(self.fill_holes),
            "square_cells" => flag(self.square_cells),
            "cells" => self.cells.clone(),
            "seed" => self.seed.clone(),
            "hardness" => self.hardness.clone(),
            // Its value may be refused, and has a default: see `fields`.
            _ => None,
        }
    }

    /// The fields of the case that it gives; pressures, too, where there is no case that has them.
    fn fields(&self, is_default: bool) -> Result<Vec<GivenByOption>, TaskError> {
        let mut fields = self.of_synthetic()?;
        let files = self.files();
        let mut give = |name: &str, text: String, field: String, value: String| {
            fields.push(GivenByOption { option: self.asked.name(name).into(), text, field, value });
        };
        for (field, name, _) in FIELDS {
            let Some(value) = self.value(name) else { continue };
            let text = files.get(name).map(|path| path.display().to_string());
            let text = text.unwrap_or_else(|| value.trim_matches('"').to_owned());
            give(name, text, format!("{SECTION}{field}"), value);
        }
        if let Some(friction) = &self.friction {
            let field = "friction.coefficient".to_owned();
            give("friction", friction.clone(), field, friction.clone());
        }
        let default = (self.is_given() && is_default).then(|| DEFAULT_PRESSURES.to_owned());
        if let Some(text) = self.pressure.clone().or(default) {
            let mut values = pressures(&self.asked.name("pressure"), &text)?;
            values.sort_by(f64::total_cmp);
            let array: Vec<String> =
                values.iter().map(|value| format!("\"{value:e} Pa\"")).collect();
            give("pressure", text, format!("{SECTION}pressures"), format!("[{}]", array.join(",")));
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
            match KEYS.iter().find(|(field, own)| key == *own || key == *field) {
                Some((field, _)) if !value.is_empty() => Ok(GivenByOption {
                    option: own.clone().into(),
                    text: part.trim().to_owned(),
                    field: format!("{SECTION}{field}"),
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
        let is_named = |field: &str| parts.iter().any(|part| part.field.ends_with(field));
        if !["longest_wavelength", "shortest_wavelength"].into_iter().all(is_named) {
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
            let mut fields =
                FIELDS.iter().filter(|(own, ..)| part.field.ends_with(&format!(".{own}")));
            let twice = fields.find_map(|(_, name, _)| Some((name, self.value(name)?)));
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
