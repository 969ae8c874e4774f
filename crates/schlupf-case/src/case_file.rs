//! A case file: what to solve and how, checked, with nothing solved yet.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;

use schlupf::Watch;
use schlupf::wheel_rail::{WheelOnRail, WheelSolution};

use crate::document::{self, Entry};
use crate::error::{CaseError, CaseErrors};
use crate::fields::{self, Field, Kind};
use crate::files::{Files, Folder, LARGEST_FILE, Recorder, read_up_to};
use crate::kept::Kept;
use crate::laws::Laws;
use crate::names::FieldNames;
use crate::place::{Place, Source};
use crate::profiles::ProfileReading;
use crate::read::{self, Parts};
use crate::settings::Settings;
use crate::template::template;

/// Largest case file that is read, in bytes, without data in place of files.
const LARGEST_CASE: u64 = 4 << 20;

/// Reads the text of a case or of a study, up to 4 MiB, or [`LARGEST_FILE`] where it has data in
/// place of files.
///
/// # Errors
/// Whatever keeps it from being read, and more bytes.
pub fn read_case(mut reader: impl Read) -> io::Result<Vec<u8>> {
    let mut start = Vec::new();
    reader.by_ref().take(LARGEST_CASE + 1).read_to_end(&mut start)?;
    let has_data = start.windows(5).any(|part| part == b"data:");
    read_up_to(if has_data { LARGEST_FILE } else { LARGEST_CASE }, start.chain(reader))
}

/// What stands in place of fields of a case file.
#[derive(Debug, Clone, Copy)]
pub struct Overrides<'a> {
    /// What messages call them, such as `--set`.
    pub option: &'a str,
    /// Each is `section.field=value`; an empty value takes the field out.
    pub assignments: &'a [String],
}

impl Overrides<'_> {
    /// No field is overridden.
    pub const NONE: Self = Self { option: "override", assignments: &[] };
}

/// A case file that was read and checked. Nothing is solved before [`Self::pose`].
#[derive(Debug, Clone)]
pub struct CaseFile {
    pub(crate) settings: Settings,
    /// The text that was read, without overrides.
    pub(crate) source: Arc<Source>,
    pub(crate) entries: Vec<Entry>,
    pub(crate) files: Arc<dyn Files>,
    pub(crate) parts: Parts,
    laws: Laws,
}

impl CaseFile {
    /// The text of the case that is solved when none is named.
    pub fn default_text() -> String {
        template()
    }

    /// Reads the text of a case. `name` is for messages, `files` finds the files that the case
    /// names.
    ///
    /// ```
    /// use schlupf_case::{CaseFile, Folder, Overrides};
    ///
    /// let text = "[kinematics]\nspeed = \"72 km/h\"";
    /// let assignments = &["normal.load=100 kN".to_owned()];
    /// let set = Overrides { option: "set", assignments };
    /// let file = CaseFile::from_str(text, "a case", Folder::new(""), set)?;
    /// let case = file.pose(&schlupf::unwatched)?;
    /// assert!((case.problem.kinematics.speed - 20.0).abs() < 1e-12);
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    pub fn from_str(
        text: &str,
        name: &str,
        files: Arc<dyn Files>,
        overrides: Overrides<'_>,
    ) -> Result<Self, CaseErrors> {
        let source = Arc::new(Source { name: name.to_owned(), text: text.to_owned() });
        let (mut entries, mut errors) = document::parse(&source)?;
        let option = overrides.option.into();
        for text in overrides.assignments {
            errors.extend(document::apply(&mut entries, &option, text).err());
        }
        Self::from_entries(entries, errors, source, (files, Kept::default()))
    }

    /// Reads a case file; relative paths start in its folder.
    pub fn from_path(path: &Path, overrides: Overrides<'_>) -> Result<Self, CaseErrors> {
        let bytes = File::open(path).and_then(read_case);
        Self::from_bytes(bytes, &path.display().to_string(), Folder::of(path), overrides)
    }

    /// The same from whatever can be read, such as standard input, as [`read_case`] does.
    pub fn from_reader(
        reader: impl Read,
        name: &str,
        files: Arc<dyn Files>,
        overrides: Overrides<'_>,
    ) -> Result<Self, CaseErrors> {
        Self::from_bytes(read_case(reader), name, files, overrides)
    }

    fn from_bytes(
        bytes: io::Result<Vec<u8>>,
        name: &str,
        files: Arc<dyn Files>,
        overrides: Overrides<'_>,
    ) -> Result<Self, CaseErrors> {
        let bytes =
            bytes.map_err(|error| CaseError::unreadable("", "the case file", name, &error))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = before.split(|byte| *byte == b'\n').count();
            let message = format!("the case file must be text in UTF-8, but is not in line {line}");
            CaseError::new("", message, Place::File { name: name.to_owned() })
        })?;
        Self::from_str(&text, name, files, overrides)
    }

    /// The same with other fields, each `section.field=value`, that an option, say of the command
    /// line, gives.
    pub fn with(
        &self,
        option: impl Into<Arc<str>>,
        assignments: &[String],
    ) -> Result<Self, CaseErrors> {
        let option = option.into();
        let mut entries = self.entries.clone();
        for assignment in assignments {
            document::apply(&mut entries, &option, assignment)?;
        }
        let files = (Arc::clone(&self.files), self.settings.kept.clone());
        let file = Self::from_entries(entries, Vec::new(), Arc::clone(&self.source), files)?;
        Ok(file.with_laws(self.laws.clone())?)
    }

    /// Its name, for messages.
    pub fn name(&self) -> &str {
        &self.source.name
    }

    /// The laws of the caller.
    pub fn laws(&self) -> &Laws {
        &self.laws
    }

    /// The same with laws of the caller in place of its own.
    ///
    /// ```
    /// use std::sync::Arc;
    ///
    /// use schlupf::interface::friction::Constant;
    /// use schlupf_case::{CaseFile, Folder, Laws, Overrides};
    ///
    /// let file = CaseFile::from_str("", "a case", Folder::new(""), Overrides::NONE)?;
    /// let friction = Arc::new(Constant::new(0.25).map_err(|error| file.explain(&error))?);
    /// let file = file.with_laws(Laws { friction: Some(friction), ..Laws::default() })?;
    /// let case = file.pose(&schlupf::unwatched)?;
    /// assert_eq!(case.problem.interface.friction.cold_coefficient(), 0.25);
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    ///
    /// # Errors
    /// Laws that no case can have.
    pub fn with_laws(mut self, laws: Laws) -> Result<Self, CaseError> {
        if laws.pressure.is_some() && self.parts.has_wheel() {
            let field = field!("normal.model");
            let message = format!(
                "{field} must describe one patch where its pressure is given, but is \"wheel-rail\""
            );
            return Err(self.settings.error(field, message));
        }
        self.parts.apply(&laws).map_err(|error| self.explain(&error))?;
        self.laws = laws;
        Ok(self)
    }

    /// The text of the case with all overrides in it, and the files that it takes by the names that
    /// it gives them: all that another place needs.
    ///
    /// # Errors
    /// A file that can no longer be read.
    pub fn packed(&self) -> Result<(String, BTreeMap<String, Vec<u8>>), CaseErrors> {
        let text = self.edited(&[], &self.folder())?;
        let recorder = Arc::new(Recorder::new(Arc::clone(&self.files)));
        let again = Self::from_str(&text, self.name(), recorder.clone(), Overrides::NONE)?;
        for path in again.given().filter(|path| matches!(path.field().kind, Kind::Path)) {
            // What has no effect in the case may be missing.
            let _ = again.settings.read_file(path);
        }
        Ok((text, recorder.found()))
    }

    /// Fields that have an effect with the models that were chosen, given or by default.
    pub fn effective(&self) -> impl Iterator<Item = &'static Field> {
        fields::all().filter(|field| self.settings.has_effect(field))
    }

    /// The wheel of a case of two profiles, with what determines where it touches.
    ///
    /// # Errors
    /// A case with another normal contact.
    pub fn wheel(&self) -> Result<&WheelOnRail, CaseError> {
        self.parts.wheel(&self.settings)
    }

    /// What was read of the profiles of the wheel and of the rail; nothing in a case without.
    pub fn profiles(&self) -> &[ProfileReading] {
        self.parts.profiles()
    }

    /// The left and the right wheel with all their contacts, both resting on their rails, at a
    /// lateral position (in m) in place of that of the case.
    ///
    /// # Errors
    /// A case with another normal contact, a height in place of the vertical force, and whatever
    /// keeps the contacts from being found.
    pub fn wheels_at(&self, lateral: f64, watch: Watch) -> Result<Vec<WheelSolution>, CaseError> {
        self.parts.wheels_at(&self.settings, lateral, watch)
    }

    fn from_entries(
        entries: Vec<Entry>,
        mut errors: Vec<CaseError>,
        source: Arc<Source>,
        (files, kept): (Arc<dyn Files>, Kept),
    ) -> Result<Self, CaseErrors> {
        let (mut settings, wrong_fields) =
            Settings::read(&entries, &source.name, FieldNames::CASE, Arc::clone(&files));
        settings.kept = kept;
        errors.extend(wrong_fields);
        errors.sort_by_key(|error| error.place.order());
        CaseErrors::check(errors)?;
        let parts = Parts::read(&settings)?;
        read::method(&settings)?;
        read::options(&settings)?;
        read::cooling(&settings)?;
        Ok(Self { settings, source, entries, files, parts, laws: Laws::default() })
    }
}
