//! All settings of a case: what was given, what is the default, and where it comes from.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use schlupf::Quantity;
use schlupf::reporting::WheelRailError;

use crate::FieldPath;
use crate::document::{Content, Entry, Origin, Value};
use crate::error::{CaseError, Cause};
use crate::fields::{
    self, ALTERNATIVES, Alternatives, Choose, Default, Field, NOT_PER_CENT, SECTIONS, UsedWith,
};
use crate::files::{Files, InputFile};
use crate::kept::Kept;
use crate::names::{self, FieldNames, Noting};
use crate::notice::Notice;
use crate::place::Place;
use crate::setting::{Refusal, Setting};
use schlupf::reporting::{quoted, quoted_path};

/// The settings of a case.
#[derive(Debug, Clone)]
pub struct Settings {
    given: HashMap<FieldPath, Given>,
    /// Where to say that something is missing.
    file: Place,
    /// What fields are called in messages.
    names: FieldNames,
    /// Files that fields name.
    files: Arc<dyn Files>,
    /// What was made from them.
    pub kept: Kept,
}

/// A field that was given.
#[derive(Debug, Clone)]
struct Given {
    setting: Setting,
    value: Value,
    origin: Origin,
    place: Place,
}

impl Settings {
    /// Reads every entry; whatever cannot stand there is an error. What is missing is missing in
    /// the case file called `name`; `names` are what messages call the fields.
    pub fn read(
        entries: &[Entry],
        name: &str,
        names: FieldNames,
        files: Arc<dyn Files>,
    ) -> (Self, Vec<CaseError>) {
        let file = Place::File { name: name.to_owned() };
        let kept = Kept::default();
        let mut settings = Self { given: HashMap::new(), file, names, files, kept };
        let mut errors = Vec::new();
        for entry in entries {
            match fields::named(&entry.path, || entry.origin.place(&entry.key)) {
                Err(unknown) => errors.push(unknown),
                Ok(field) => match field.read(&entry.value) {
                    Ok(setting) => settings.insert(field, setting, entry),
                    Err(refusal) => errors.push(settings.refused(field.path, &refusal, entry)),
                },
            }
        }
        if errors.is_empty() {
            errors = settings.contradictions();
        }
        (settings, errors)
    }

    /// What fields are called in messages.
    pub fn names(&self) -> FieldNames {
        self.names
    }

    /// The file that a field names.
    pub fn input_file(&self, path: FieldPath) -> Result<InputFile, CaseError> {
        Ok(InputFile::new(self.text(path)?, Arc::clone(&self.files)))
    }

    /// Name and bytes of the file that a field names.
    pub fn read_file(&self, path: FieldPath) -> Result<(String, Vec<u8>), CaseError> {
        let file = self.input_file(path)?;
        let name = file.path().display().to_string();
        let bytes = file.read().map_err(|error| {
            let message = format!(
                "{path} must be the path of a readable file, but is {}: {error}",
                quoted_path(&name)
            );
            let error = self.error(path, message).of_file(&name, &error);
            error.help("relative paths are relative to the folder of the case".to_owned())
        })?;
        Ok((name, bytes))
    }

    /// Path and bytes of a file that is named relative to the one that a field names.
    pub fn read_beside(&self, path: FieldPath, name: &str) -> (String, std::io::Result<Vec<u8>>) {
        let beside = self.text(path).unwrap_or_default();
        let folder = Path::new(&beside).parent().unwrap_or(Path::new(""));
        let file = InputFile::new(folder.join(name).to_string_lossy(), Arc::clone(&self.files));
        (file.path().display().to_string(), file.read())
    }

    /// What a field is called in messages.
    pub fn name(&self, path: FieldPath) -> &'static str {
        self.names.name(path)
    }

    fn refused(&self, path: FieldPath, refusal: &Refusal, entry: &Entry) -> CaseError {
        let place = entry.origin.place(&refusal.span);
        let message = refusal.message(self.name(path));
        CaseError::new(path, message, place).help(refusal.help.clone())
    }

    fn insert(&mut self, field: &Field, setting: Setting, entry: &Entry) {
        let place = entry.origin.place(&entry.value.span);
        let (value, origin) = (entry.value.clone(), entry.origin.clone());
        self.given.insert(field.path, Given { setting, value, origin, place });
    }

    /// Whether a field was given and belongs to the models that were chosen.
    pub fn is_given(&self, path: FieldPath) -> bool {
        self.given.contains_key(&path) && self.is_used(path.field())
    }

    /// Whether a field was given, with an effect or without.
    pub fn is_written(&self, path: FieldPath) -> bool {
        self.given.contains_key(&path)
    }

    /// Whether any of these fields was given.
    pub fn any_given(&self, paths: &[FieldPath]) -> bool {
        paths.iter().any(|path| self.is_given(*path))
    }

    /// A number, in SI units or degC: the one given or the default.
    pub fn number(&self, path: FieldPath) -> Result<f64, CaseError> {
        match self.setting(path)? {
            Setting::Number(number) => Ok(number),
            _ => Err(self.missing(path)),
        }
    }

    /// A number that may be left out.
    pub fn optional_number(&self, path: FieldPath) -> Result<Option<f64>, CaseError> {
        if self.is_given(path) { self.number(path).map(Some) } else { Ok(None) }
    }

    /// A number of cells or iterations.
    pub fn count(&self, path: FieldPath) -> Result<usize, CaseError> {
        self.number(path).map(|number| number as usize)
    }

    /// What was chosen.
    pub fn chosen<C: Choose>(&self, path: FieldPath) -> Result<C, CaseError> {
        C::named(self.choice(path)?).ok_or_else(|| self.missing(path))
    }

    /// The name that was chosen.
    fn choice(&self, path: FieldPath) -> Result<&'static str, CaseError> {
        match self.setting(path)? {
            Setting::Choice(name) => Ok(name),
            _ => Err(self.missing(path)),
        }
    }

    /// Whether or not.
    pub fn flag(&self, path: FieldPath) -> Result<bool, CaseError> {
        match self.setting(path)? {
            Setting::Flag(flag) => Ok(flag),
            _ => Err(self.missing(path)),
        }
    }

    /// Text or a path.
    pub fn text(&self, path: FieldPath) -> Result<String, CaseError> {
        match self.setting(path)? {
            Setting::Text(text) => Ok(text),
            _ => Err(self.missing(path)),
        }
    }

    /// Text or a path, where it was given.
    pub fn given_text(&self, path: FieldPath) -> Option<&str> {
        match &self.given.get(&path)?.setting {
            Setting::Text(text) => Some(text),
            _ => None,
        }
    }

    /// An array of numbers in SI units, where it was given.
    pub fn series(&self, path: FieldPath) -> Option<&[f64]> {
        match &self.given.get(&path)?.setting {
            Setting::Series(series) => Some(series),
            _ => None,
        }
    }

    /// A number or a name: the one given or the default.
    pub fn setting(&self, path: FieldPath) -> Result<Setting, CaseError> {
        if let Some(given) = self.given.get(&path) {
            return Ok(given.setting.clone());
        }
        let field = path.field();
        match field.default {
            Default::Text(_) => self
                .default_value(field)
                .and_then(|value| field.read(&value).ok())
                .ok_or_else(|| self.missing(path)),
            Default::Same(other) => self.same_as(field, other),
            Default::Nothing | Default::Computed(_) => Err(self.missing(path)),
        }
    }

    /// The default of a field, where it is fixed, with the models that were chosen.
    fn default_value(&self, field: &Field) -> Option<Value> {
        let other = field.other_default.filter(|(choice, _)| self.is_chosen(*choice));
        other.map_or_else(|| field.default_value(), |(_, text)| Some(field.value_of(text)))
    }

    /// The setting of another field, as the default of one that may have a stricter requirement.
    fn same_as(&self, field: &Field, other: FieldPath) -> Result<Setting, CaseError> {
        let setting = self.setting(other)?;
        match setting {
            Setting::Number(number) if !field.requirement.holds(number) => {
                let requirement = field.requirement.text(field.kind.unit(), &self.names);
                let message = format!(
                    "{} must be {requirement}, but is that of {other}, {}",
                    field.path,
                    self.shown(other)
                );
                let place = self.place(other);
                Err(CaseError::new(field.path, message, place).help(format!("give {}", field.path)))
            }
            setting => Ok(setting),
        }
    }

    /// Whether a field has the same value in other settings, to the digits that conversion leaves.
    pub fn agrees(&self, other: &Self, path: FieldPath) -> bool {
        const ROUNDING: f64 = 1e-12;
        match (self.setting(path), other.setting(path)) {
            (Ok(Setting::Number(one)), Ok(Setting::Number(other))) => {
                one == other || (one - other).abs() <= ROUNDING * one.abs().max(other.abs())
            }
            (Ok(one), Ok(other)) => one == other,
            _ => false,
        }
    }

    /// Where a field was given.
    pub fn place(&self, path: FieldPath) -> Place {
        self.given.get(&path).map_or(Place::Default, |given| given.place.clone())
    }

    /// A field's value as it was written, or its default.
    pub fn shown(&self, path: FieldPath) -> String {
        if let Some(given) = self.given.get(&path) {
            return given.value.content.shown();
        }
        let field = path.field();
        match (field.default, self.default_value(field)) {
            (_, Some(value)) => value.content.shown(),
            (Default::Same(other), _) => self.shown(other),
            (Default::Computed(text), _) => text.to_owned(),
            _ => String::new(),
        }
    }

    /// An error of a field, at its place.
    pub fn error(&self, path: FieldPath, message: impl Into<String>) -> CaseError {
        CaseError::new(path, message, self.place(path))
    }

    /// An error of the core, at the place of the field that it names; where that has its default,
    /// at that of a field that goes with it or that the error speaks of.
    pub fn explain(&self, error: &schlupf::Error) -> CaseError {
        if matches!(error, schlupf::Error::Stopped {}) {
            let stopped = CaseError::new("", error.to_string(), self.file.clone());
            return CaseError { cause: Cause::Stopped, ..stopped };
        }
        let noting = Noting::new(self.names);
        let (quantity, message) = (error.quantity(), error.text(&noting));
        let cause = match error {
            schlupf::Error::WheelRail { error: WheelRailError::Lifted { .. } } => Cause::NoContact,
            error if error.is_of_convergence() => Cause::NotConverged,
            _ => Cause::Input,
        };
        let path = names::quantity_field(quantity);
        let given = path
            .into_iter()
            .chain(path.into_iter().flat_map(fields::related))
            .chain(noting.fields())
            .find(|path| self.is_given(*path));
        let error = match given {
            Some(given) => self.error(given, message).help(self.per_cent(given, quantity)),
            None => CaseError::new(names::path(quantity), message, self.file.clone()),
        };
        CaseError { cause, ..error }
    }

    /// Advice where a given creepage is too large to be a part of one; the numbers of a history's
    /// file are not here.
    fn per_cent(&self, path: FieldPath, quantity: Quantity) -> Option<String> {
        let largest = match &self.given.get(&path)?.setting {
            Setting::Number(number) => *number,
            Setting::Series(series) => series.iter().fold(0.0, |a: f64, b| a.max(b.abs())),
            _ => f64::NAN,
        };
        let of_file = path == field!("history.file") && quantity == Quantity::HistoryCreepageX;
        let help = of_file.then(|| NOT_PER_CENT.to_owned());
        help.or_else(|| fields::creepage_in_per_cent(&path, largest))
    }

    fn missing(&self, path: FieldPath) -> CaseError {
        let mut companions = fields::companions(path).iter();
        if let Some(companion) = companions.find(|other| self.is_given(**other)) {
            return self.missing_beside(path, *companion);
        }
        let field = path.field();
        let model = field.uses().find(|used| self.is_chosen(*used));
        let because = model.map_or_else(String::new, |(model, _)| {
            format!(", which {model} = {} needs", self.shown(model))
        });
        let message = format!("{path} is missing{because}: {}", field.doc);
        let example = field.assignment();
        let place =
            model.map(|(model, _)| self.place(model)).filter(|place| *place != Place::Default);
        CaseError::new(path, message, place.unwrap_or_else(|| self.file.clone()))
            .help(example.map(|example| format!("such as {example}")))
    }

    /// A field is missing that another one, which was given, needs.
    pub fn missing_beside(&self, path: FieldPath, other: FieldPath) -> CaseError {
        let field = path.field();
        let name = self.name(path);
        let is_choice = !other.field().kind.choices().is_empty();
        let value = if is_choice { format!(" = {}", self.shown(other)) } else { String::new() };
        let other_name = self.name(other);
        let message = format!("{name} is missing, which {other_name}{value} needs: {}", field.doc);
        let example = field.assignment();
        CaseError::new(path, message, self.place(other))
            .help(example.map(|example| format!("such as {example}")))
    }

    /// A field is missing that something beside the solution needs.
    pub fn missing_for(&self, path: FieldPath, purpose: &str) -> CaseError {
        let field = path.field();
        let message = format!("{path} is missing, which {purpose} needs: {}", field.doc);
        let example = field.assignment();
        CaseError::new(path, message, self.file.clone())
            .help(example.map(|example| format!("such as {example} in [{}]", path.section())))
    }

    /// Whether a field belongs to the models that were chosen and the fields that were given.
    pub fn is_used(&self, field: &Field) -> bool {
        let companions = fields::companions(field.path);
        let has_one = companions.iter().any(|with| self.given.contains_key(with));
        if !companions.is_empty() && !has_one {
            return false;
        }
        if field.idle_with.is_some_and(|choice| self.is_chosen(choice)) {
            return false;
        }
        field.uses().count() == 0
            || field.uses().any(|used| self.is_chosen(used))
            || self.is_default_of_another(field.path)
    }

    /// Whether a field gives the value of another one that is used and was left out.
    fn is_default_of_another(&self, path: FieldPath) -> bool {
        let has_default = |field: &&Field| matches!(field.default, Default::Same(of) if of == path);
        let is_left_out = |field: &&Field| !self.given.contains_key(&field.path);
        fields::all().filter(has_default).filter(is_left_out).any(|field| self.is_used(field))
    }

    /// Whether a field is used, and not only a default of a section that may be left out and is.
    pub fn has_effect(&self, field: &Field) -> bool {
        let section = SECTIONS.iter().find(|section| section.name == field.section());
        let is_left_out = section.is_some_and(|section| {
            let is_optional = |field: &Field| !matches!(field.default, Default::Text(_));
            let is_given = |field: &Field| self.given.contains_key(&field.path);
            section.fields.iter().all(is_optional) && !section.fields.iter().any(is_given)
        });
        self.is_used(field) && !is_left_out && !self.is_replaced(field.path)
    }

    /// Whether a field is only a default, in place of which others are given, or which does not
    /// count with the models that were chosen.
    pub fn is_replaced(&self, path: FieldPath) -> bool {
        if self.is_given(path) {
            return false;
        }
        let any_given = |fields: &[FieldPath]| self.any_given(fields);
        let counts_with = path.field().default_with;
        counts_with.is_some_and(|choice| !self.is_chosen(choice))
            || ALTERNATIVES.iter().any(|Alternatives { first, second, .. }| {
                first.contains(&path) && any_given(second)
                    || second.contains(&path) && any_given(first)
            })
    }

    /// Whether a choice is made with one of these names, and counts itself.
    fn is_chosen(&self, (model, names): UsedWith) -> bool {
        self.choice(model).is_ok_and(|choice| names.contains(&choice))
            && self.is_used(model.field())
    }

    /// Fields that were given and have no effect. A model that was chosen by an override makes the
    /// file's fields of other models idle on purpose: no word about those.
    pub fn idle(&self) -> Vec<Notice> {
        let mut notices = Vec::new();
        for field in fields::all() {
            let Some(given) = self.given.get(&field.path).filter(|_| !self.is_used(field)) else {
                continue;
            };
            let path = field.path;
            let notice =
                |because| Notice::NoEffect { place: given.place.clone(), field: path, because };
            let idle_with = field.idle_with.filter(|choice| self.is_chosen(*choice));
            let uses = field.uses().filter(|_| idle_with.is_none()).chain(idle_with);
            let models: Vec<_> =
                uses.map(|(model, _)| model).filter(|model| self.is_used(model.field())).collect();
            let is_chosen = idle_with.is_none() && field.uses().any(|used| self.is_chosen(used));
            if models.is_empty() || is_chosen {
                let companions = fields::companions(path);
                if !companions.is_empty() {
                    let names: Vec<&str> = companions.iter().map(|path| &**path).collect();
                    notices.push(notice(format!("without {}", names.join(" or "))));
                }
                continue;
            }
            let overridden = |path| matches!(self.place(path), Place::Override { .. });
            let on_purpose = models.iter().any(|model| overridden(*model));
            if !(on_purpose && matches!(given.origin, Origin::File(_))) {
                let chosen: Vec<String> = models
                    .iter()
                    .map(|model| format!("{model} = {}", self.shown(*model)))
                    .collect();
                notices.push(notice(format!("with {}", chosen.join(" and "))));
            }
        }
        notices
    }

    /// Fields in use that were given as numbers far from what they are in almost all cases.
    pub fn unusual(&self) -> Vec<Notice> {
        let given = |field: &'static Field| {
            let given = self.given.get(&field.path).filter(|_| self.is_used(field))?;
            let values: &[f64] = match &given.setting {
                Setting::Number(number) => std::slice::from_ref(number),
                Setting::Series(series) => series,
                _ => return None,
            };
            Notice::of_unusual(field, values, &given.place)
        };
        fields::all().filter_map(given).collect()
    }

    fn contradictions(&self) -> Vec<CaseError> {
        let given =
            |paths: &'static [FieldPath]| paths.iter().copied().find(|path| self.is_given(*path));
        ALTERNATIVES
            .iter()
            .filter_map(|pair| Some((given(pair.first)?, given(pair.second)?, pair.reason)))
            .map(|(first, second, reason)| self.contradiction(first, second, reason))
            .collect()
    }

    fn contradiction(&self, first: FieldPath, second: FieldPath, reason: &str) -> CaseError {
        let overridden = |path| matches!(self.place(path), Place::Override { .. });
        let (later, earlier) = if overridden(first) && !overridden(second) {
            (first, second)
        } else {
            (second, first)
        };
        let [later_name, earlier_name] = [later, earlier].map(|path| self.name(path));
        let message = format!(
            "{later_name} must not be given together with {earlier_name}: {reason}, but {later_name} is \
             {} and {earlier_name} is {} ({})",
            self.given_as(later),
            self.given_as(earlier),
            self.place(earlier)
        );
        let remove = match self.place(later) {
            Place::Override { option, text } if !overridden(earlier) => {
                // Not every option can remove a field.
                let is_assignment =
                    text.split_once('=').is_some_and(|(path, _)| path.trim() == &*later);
                let or = format!(", or with {option} {earlier}=");
                format!(
                    "remove {earlier} from the file{}",
                    if is_assignment { or.as_str() } else { "" }
                )
            }
            _ => "remove one of them".to_owned(),
        };
        self.error(later, message).help(remove)
    }

    /// A field's value as the user gave it: what stands after its own option, else as in the case
    /// file.
    fn given_as(&self, path: FieldPath) -> String {
        let given = self.given.get(&path).map(|given| (&given.origin, &given.value.content));
        match given {
            Some((Origin::Override { option, text }, Content::Text(_)))
                if self.names.option(path) == Some(&**option) =>
            {
                quoted(text)
            }
            _ => self.shown(path),
        }
    }
}
