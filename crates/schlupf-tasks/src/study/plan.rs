//! The study file: a case and what varies over it, as TOML.

use std::collections::BTreeSet;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use schlupf::Method;
use schlupf_case::document::{Content, Value};
use schlupf_case::fields::{self, Field, Kind};
use schlupf_case::{
    CaseError, CaseErrors, CaseFile, FieldPath, Folder, InputFile, Overrides, Place, Setting,
    Source, field, read_case,
};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::study::chunks::{self, FieldColumn};
use crate::study::columns::columns;
use crate::study::design::{self, Design, Sample, Values, Varied, assignment, read_states};
use crate::study::digest::{digest, varied_files};
use crate::study::error::StudyError;
use crate::study::table::{Column, Contents, ENDINGS, HAS_PARQUET, NEEDS_PARQUET};
use schlupf::reporting::shortened;

/// Fewest and most rows of a batch where each is solved in full, and where a fast method gives it:
/// as many as make some batches for each core of a machine, whatever its number of cores.
const BATCH: [usize; 2] = [16, 256];
const FAST_BATCH: [usize; 2] = [256, 4096];

/// Batches into which a study of few rows is divided.
const BATCHES: usize = 64;

/// Most rows of a study.
const MOST_ROWS: usize = 100_000_000;

/// A case and what varies over it.
#[derive(Debug, Clone)]
pub struct Study {
    /// The case, with the values of the first row where it needs them to be one.
    pub(crate) case: CaseFile,
    /// What varies.
    pub(crate) design: Design,
    rows: usize,
    batch: usize,
    /// Quantities of the cells that are kept, if any.
    pub(crate) fields: Option<Vec<&'static FieldColumn>>,
    /// What messages call it.
    name: String,
    /// The text of the case.
    text: String,
    digest: String,
    inputs: Vec<PathBuf>,
}

impl Study {
    /// What tells it from another study: case, design, files and version.
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// Reads a study file; relative paths in it start in its folder, `case` stands in place of the
    /// one that it names.
    ///
    /// # Errors
    /// A file that cannot be read, or in which something is wrong.
    pub fn from_path(path: &Path, case: Option<&CaseFile>) -> Result<Self, StudyError> {
        let bytes = File::open(path).and_then(read_case);
        let bytes = bytes.map_err(|cause| StudyError::file(path, cause))?;
        let name = path.display().to_string();
        let text = String::from_utf8(bytes).map_err(|_| {
            let place = Place::File { name: name.clone() };
            CaseError::new("", "the study must be text in UTF-8, but is not", place)
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut study = Self::from_str(&text, &name, folder, case)?;
        study.inputs.insert(0, path.to_owned());
        Ok(study)
    }

    /// Reads the text of a study; `name` is what messages call it, `case` stands in place of the
    /// one that it names.
    ///
    /// # Errors
    /// What is wrong in it, or in a file that it names.
    pub fn from_str(
        text: &str,
        name: &str,
        folder: &Path,
        case: Option<&CaseFile>,
    ) -> Result<Self, StudyError> {
        let source = Arc::new(Source { name: name.to_owned(), text: text.to_owned() });
        let table = DeTable::parse(&source.text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            let place = Place::Text { source: Arc::clone(&source), span };
            let message = error.message().trim().replace('\n', "; ");
            CaseError::new("", format!("not TOML: {message}"), place)
        })?;
        let reader = StudyReader { source: &source, folder, case };
        reader.study(table.get_ref())
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Its case, before anything varies.
    pub fn case_file(&self) -> &CaseFile {
        &self.case
    }

    /// What messages call it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The columns of its table.
    pub fn columns(&self) -> Vec<Column> {
        columns(&self.design, self.has_wheel())
    }

    /// Whether any of its states may be of a wheel with profiles.
    pub(crate) fn has_wheel(&self) -> bool {
        self.design.has_wheel(&self.case)
    }

    /// Files that were read for it, or that its case names.
    pub fn inputs(&self) -> &[PathBuf] {
        &self.inputs
    }

    /// What is in a table of one of so many shards.
    pub(crate) fn contents(&self, shard: [usize; 2]) -> Contents {
        Contents {
            program: concat!("schlupf ", env!("CARGO_PKG_VERSION")).to_owned(),
            study: self.digest.clone(),
            rows: self.rows,
            batch: self.batch,
            shard,
            columns: self.columns(),
            case: self.text.clone(),
        }
    }
}

/// Reads the parts of a study.
struct StudyReader<'a> {
    source: &'a Arc<Source>,
    folder: &'a Path,
    case: Option<&'a CaseFile>,
}

type Key<'a> = Spanned<std::borrow::Cow<'a, str>>;
type Table<'a> = DeTable<'a>;

/// Names at the top of a study.
const TOP: [&str; 6] = ["case", "batch", "fields", "vary", "sample", "states"];

impl StudyReader<'_> {
    fn study(&self, table: &Table<'_>) -> Result<Study, StudyError> {
        for (key, _) in table {
            self.known(key, "", &TOP)?;
        }
        let (design, mut inputs) = self.design(table)?;
        let rows = design.rows().filter(|rows| (1..=MOST_ROWS).contains(rows));
        let rows = rows.ok_or_else(|| {
            let message = match design.rows() {
                Some(0) => "a study must have rows, but has none".to_owned(),
                _ => format!("a study must have at most {MOST_ROWS} rows, but has more"),
            };
            self.error(&(0..0), message)
        })?;
        let (case, path) = self.case(table, &design)?;
        inputs.extend(path.clone());
        inputs.extend(case.files().into_iter().map(|(_, path)| path));
        inputs.extend(varied_files(&case, &design));
        let batch = match table.get("batch") {
            None => {
                let [least, most] = if is_fast(&case, &design) { FAST_BATCH } else { BATCH };
                rows.div_ceil(BATCHES).clamp(least, most)
            }
            Some(value) => self.count("batch", value, 1)?,
        };
        let fields = table.get("fields");
        if let Some(given) = fields {
            self.require_cells(&case, &design, &given.span())?;
        }
        let fields = fields.map(|value| self.fields(value)).transpose()?;
        // Paths are as the case has them, wherever it lies.
        let text = case.edited(&[], &case.folder())?;
        let digest = digest(&text, &design, (batch, fields.as_deref()), &inputs)?;
        let name = self.source.name.clone();
        Ok(Study { case, design, rows, batch, fields, name, text, digest, inputs })
    }

    /// What varies, and the file that says so if there is one.
    fn design(&self, table: &Table<'_>) -> Result<(Design, Vec<PathBuf>), StudyError> {
        let parts = ["vary", "sample", "states"].map(|name| Some((name, table.get(name)?)));
        let mut given = parts.into_iter().flatten();
        let Some((name, value)) = given.next() else {
            let message = "a study needs one of [vary], [sample] and [states], but has none";
            return Err(self.error(&(0..0), message).into());
        };
        if let Some((other, value)) = given.next() {
            let message = format!("a study needs one of [{name}] and [{other}], but has both");
            return Err(self.error(&value.span(), message).into());
        }
        let section = self.section(name, value)?;
        match name {
            "vary" => Ok((Design::Factorial(self.factorial(section, &value.span())?), Vec::new())),
            "sample" => {
                Ok((Design::Rows(self.sample(section, &value.span())?, Vec::new()), Vec::new()))
            }
            _ => {
                let file = self.states(section, &value.span())?;
                let path = file.data().is_none().then(|| file.path());
                Ok((read_states(&file)?, path.into_iter().collect()))
            }
        }
    }

    fn factorial(
        &self,
        section: &Table<'_>,
        span: &std::ops::Range<usize>,
    ) -> Result<Vec<Varied>, CaseError> {
        let mut varied = Vec::new();
        for (key, value) in in_order(section) {
            self.add_varied(&mut varied, "", key, value)?;
        }
        if varied.is_empty() {
            return Err(self.error(span, "vary must have fields, but has none"));
        }
        Ok(varied)
    }

    /// Adds a field with its list, or those of a section.
    fn add_varied(
        &self,
        varied: &mut Vec<Varied>,
        parent: &str,
        key: &Key<'_>,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<(), CaseError> {
        let path = joined(parent, key.get_ref());
        if let DeValue::Table(section) = value.get_ref() {
            return in_order(section)
                .into_iter()
                .try_for_each(|(key, value)| self.add_varied(varied, &path, key, value));
        }
        let field = self.field(&path, &key.span())?;
        self.once(field, varied.iter().map(|varied| varied.field), &key.span())?;
        let DeValue::Array(entries) = value.get_ref() else {
            let message = format!("{path} must be a list of values, such as [1, 2]");
            return Err(self.error(&value.span(), message));
        };
        if entries.is_empty() {
            return Err(self.error(&value.span(), format!("{path} must have values, but has none")));
        }
        let values = self.values(field, entries)?;
        if let Some(twice) = values.repeated() {
            let Value { content, span } = Value::of(&entries[twice]);
            let shown = content.shown();
            let message = format!("the values of {path} must differ, but {shown} is repeated");
            return Err(self.error(&span, message));
        }
        varied.push(Varied { field, values });
        Ok(())
    }

    /// Refuses a field that varies already, written in another way.
    fn once(
        &self,
        field: &Field,
        mut others: impl Iterator<Item = &'static Field>,
        span: &std::ops::Range<usize>,
    ) -> Result<(), CaseError> {
        if others.any(|other| other.path == field.path) {
            return Err(self.error(span, format!("{} is given twice", field.path)));
        }
        Ok(())
    }

    fn values(
        &self,
        field: &'static Field,
        entries: &[Spanned<DeValue<'_>>],
    ) -> Result<Values, CaseError> {
        let number = |entry| match self.setting(field, &Value::of(entry))? {
            Setting::Number(number) if !matches!(field.kind, Kind::Count) => Ok(Some(number)),
            _ => Ok(None),
        };
        // A number or one of several names: a million numbers are no texts besides.
        let numbers: Option<Vec<f64>> = entries.iter().map(number).collect::<Result<_, _>>()?;
        if let Some(numbers) = numbers {
            return Ok(Values::Numbers(numbers));
        }
        let text = |entry| match self.setting(field, &Value::of(entry))? {
            Setting::Number(number) if matches!(field.kind, Kind::Count) => Ok(number.to_string()),
            Setting::Number(number) => Ok(format!("{number:?}")),
            Setting::Text(text) => Ok(text),
            Setting::Flag(flag) => Ok(flag.to_string()),
            Setting::Choice(name) => Ok(name.to_owned()),
            Setting::Series(_) => {
                let message = format!("{} is a list and cannot vary", field.path);
                Err(self.error(&entry.span(), message))
            }
        };
        entries.iter().map(text).collect::<Result<_, _>>().map(Values::Texts)
    }

    fn setting(&self, field: &'static Field, value: &Value) -> Result<Setting, CaseError> {
        field.read(value).map_err(|refusal| {
            let message = refusal.message(&field.path);
            self.error(&value.span, message).help(refusal.help)
        })
    }

    fn sample(
        &self,
        section: &Table<'_>,
        span: &std::ops::Range<usize>,
    ) -> Result<Vec<Varied>, CaseError> {
        for (key, _) in section {
            self.known(key, "sample", &["method", "count", "seed", "range"])?;
        }
        let missing = |name: &str| self.error(span, format!("sample.{name} is missing"));
        let method = section.get("method").ok_or_else(|| missing("method"))?;
        let name = method.get_ref().as_str().unwrap_or_default();
        let method_named = |method: &design::Method| method.name() == name;
        let all = design::Method::ALL;
        let known = || all.map(|method| format!("{:?}", method.name())).join(" or ");
        let chosen = all.into_iter().find(method_named).ok_or_else(|| {
            self.error(&method.span(), format!("sample.method must be {}", known()))
        })?;
        let count = section.get("count").ok_or_else(|| missing("count"))?;
        let count = self.count("sample.count", count, 1)?;
        let seed = section.get("seed");
        let seed = seed.map(|seed| self.count("sample.seed", seed, 0)).transpose()?.unwrap_or(0);
        let range = section.get("range").ok_or_else(|| missing("range"))?;
        let mut ranges = Vec::new();
        for (key, value) in in_order(self.section("sample.range", range)?) {
            self.add_range(&mut ranges, "", key, value)?;
        }
        let most = chosen.most_fields();
        if ranges.is_empty() || ranges.len() > most {
            let message = match ranges.len() {
                0 => "sample.range must have fields, but has none".to_owned(),
                found => format!("{name} can vary at most {most} fields, but there are {found}"),
            };
            return Err(self.error(&range.span(), message));
        }
        let sample = Sample { method: chosen, count, seed: seed as u64 };
        let varied = ranges.into_iter().enumerate().map(|(dimension, (field, range))| {
            let values = Values::Numbers(sample.values(dimension, range));
            Varied { field, values }
        });
        Ok(varied.collect())
    }

    fn add_range(
        &self,
        ranges: &mut Vec<(&'static Field, [f64; 2])>,
        parent: &str,
        key: &Key<'_>,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<(), CaseError> {
        let path = joined(parent, key.get_ref());
        if let DeValue::Table(section) = value.get_ref() {
            return in_order(section)
                .into_iter()
                .try_for_each(|(key, value)| self.add_range(ranges, &path, key, value));
        }
        let field = self.field(&path, &key.span())?;
        self.once(field, ranges.iter().map(|(field, _)| *field), &key.span())?;
        let ends = match value.get_ref() {
            DeValue::Array(ends) if ends.len() == 2 => self.values(field, ends)?,
            _ => Values::Texts(Vec::new()),
        };
        let (Values::Numbers(ends), Kind::Quantity(_) | Kind::Number | Kind::NumberOr(_)) =
            (ends, field.kind)
        else {
            let message = format!("{path} must be a range of numbers, such as [1, 2]");
            return Err(self.error(&value.span(), message));
        };
        if !(ends[1] - ends[0]).is_finite() {
            let message = format!("the range of {path} must be finite, but is not");
            return Err(self.error(&value.span(), message));
        }
        if ends[0] >= ends[1] {
            let message = format!("the range of {path} must increase, but does not");
            return Err(self.error(&value.span(), message));
        }
        ranges.push((field, [ends[0], ends[1]]));
        Ok(())
    }

    /// Which quantities of the cells are kept.
    fn fields(&self, value: &Spanned<DeValue<'_>>) -> Result<Vec<&'static FieldColumn>, CaseError> {
        let section = self.section("fields", value)?;
        if !HAS_PARQUET {
            return Err(self.error(&value.span(), format!("a section [fields] {NEEDS_PARQUET}")));
        }
        for (key, _) in section {
            self.known(key, "fields", &["columns"])?;
        }
        let Some(columns) = section.get("columns") else { return Ok(chunks::all()) };
        let names = || chunks::all().into_iter().map(|field| field.name);
        let refused = |message: String| self.error(&columns.span(), message);
        let Content::Array(entries) = Content::of(columns.get_ref()) else {
            return Err(refused("fields.columns must be a list of names".to_owned()));
        };
        let mut found: Vec<&'static FieldColumn> = Vec::new();
        for entry in &entries {
            let Content::Text(name) = &entry.content else {
                return Err(refused("fields.columns must be a list of names".to_owned()));
            };
            let Some(field) = chunks::all().into_iter().find(|field| field.name == *name) else {
                let help = fields::closest(name, names());
                let help = help.map(|meant| format!("did you mean `{meant}`?"));
                let message = format!("fields.columns: there is no `{}`", shortened(name));
                return Err(self.error(&entry.span, message).help(help));
            };
            if found.iter().any(|other| other.name == field.name) {
                return Err(refused(format!("fields.columns has `{name}` twice")));
            }
            found.push(field);
        }
        if found.is_empty() {
            return Err(refused("fields.columns must have names, but has none".to_owned()));
        }
        Ok(found)
    }

    /// Refuses fields of methods all of which give forces only.
    fn require_cells(
        &self,
        case: &CaseFile,
        design: &Design,
        span: &std::ops::Range<usize>,
    ) -> Result<(), CaseError> {
        // A method that is wrong is told by its rows.
        let lacks_cells =
            |method: Result<Method, CaseErrors>| method.is_ok_and(|method| !method.has_fields());
        let of_name = |name: &String| {
            let assignments = [format!("{METHOD}={name}")];
            Ok(case.with(FIRST_ROW, &assignments)?.method()?)
        };
        let varied = design.varied().iter().find(|varied| varied.field.path == METHOD);
        let none_has = match varied.map(|varied| &varied.values) {
            Some(Values::Texts(names)) => {
                let names: BTreeSet<&String> = names.iter().collect();
                names.into_iter().all(|name| lacks_cells(of_name(name)))
            }
            _ => lacks_cells(case.method().map_err(CaseErrors::from)),
        };
        if none_has {
            let message = format!("fields need a {METHOD} that has cells: full or fastsim");
            return Err(self.error(span, message));
        }
        Ok(())
    }

    fn states(
        &self,
        section: &Table<'_>,
        span: &std::ops::Range<usize>,
    ) -> Result<InputFile, CaseError> {
        for (key, _) in section {
            self.known(key, "states", &["file"])?;
        }
        let file = section.get("file").and_then(|file| file.get_ref().as_str());
        let file = file.ok_or_else(|| {
            self.error(span, format!("states.file must be the path of a {ENDINGS} file"))
        })?;
        Ok(InputFile::new(file, Folder::new(self.folder)))
    }

    /// The case with its path, if it is a file.
    fn case(
        &self,
        table: &Table<'_>,
        design: &Design,
    ) -> Result<(CaseFile, Option<PathBuf>), StudyError> {
        let first = design.row(0);
        let given = design.varied().iter().zip(&first);
        let assignments: Vec<String> =
            given.map(|(varied, entry)| assignment(varied.field, entry)).collect();
        let of_row = Overrides { option: FIRST_ROW, assignments: &assignments };
        let path = table.get("case").filter(|_| self.case.is_none()).map(|value| {
            let path = value.get_ref().as_str();
            let message = "case must be the path of a case file";
            path.map(|path| self.folder.join(path))
                .ok_or_else(|| self.error(&value.span(), message))
        });
        let path = path.transpose()?;
        let read = |overrides: Overrides<'_>| match (&path, self.case) {
            (Some(path), _) => CaseFile::from_path(path, overrides),
            (None, Some(case)) => case.with(overrides.option, overrides.assignments),
            (None, None) => {
                let text = CaseFile::default_text();
                CaseFile::from_str(&text, "default case", Folder::new(""), overrides)
            }
        };
        // Where it is no case without what varies, it is one with it.
        let case =
            read(Overrides::NONE).or_else(|errors: CaseErrors| read(of_row).map_err(|_| errors))?;
        Ok((case, path))
    }

    fn section<'t>(
        &self,
        name: &str,
        value: &'t Spanned<DeValue<'_>>,
    ) -> Result<&'t Table<'t>, CaseError> {
        match value.get_ref() {
            DeValue::Table(table) => Ok(table),
            _ => Err(self.error(&value.span(), format!("{name} must be a section: [{name}]"))),
        }
    }

    fn count(
        &self,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        least: i64,
    ) -> Result<usize, CaseError> {
        let number = match Content::of(value.get_ref()) {
            Content::Integer(number) if number >= least => usize::try_from(number).ok(),
            _ => None,
        };
        number.filter(|number| *number <= MOST_ROWS).ok_or_else(|| {
            let message = format!("{name} must be a whole number from {least} to {MOST_ROWS}");
            self.error(&value.span(), message)
        })
    }

    fn field(
        &self,
        path: &str,
        span: &std::ops::Range<usize>,
    ) -> Result<&'static Field, CaseError> {
        fields::named(path, || self.place(span))
    }

    fn known(&self, key: &Key<'_>, section: &str, names: &[&str]) -> Result<(), CaseError> {
        let name: &str = key.get_ref();
        if names.contains(&name) {
            return Ok(());
        }
        let path = joined(section, name);
        let help = match fields::closest(name, names.iter().copied()) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!("there are {}", names.join(", ")),
        };
        Err(self
            .error(&key.span(), format!("unknown field `{}` of a study", shortened(&path)))
            .help(help))
    }

    fn error(&self, span: &std::ops::Range<usize>, message: impl Into<String>) -> CaseError {
        CaseError::new("", message, self.place(span))
    }

    fn place(&self, span: &std::ops::Range<usize>) -> Place {
        if *span == (0..0) {
            Place::File { name: self.source.name.clone() }
        } else {
            Place::Text { source: Arc::clone(self.source), span: span.clone() }
        }
    }
}

/// The field with the method.
const METHOD: FieldPath = field!("solver.method");

/// What messages call the values of the first row.
const FIRST_ROW: &str = "row 0";

/// The entries of a table as they stand in the text.
fn in_order<'t, 'i>(table: &'t Table<'i>) -> Vec<(&'t Key<'i>, &'t Spanned<DeValue<'i>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

fn joined(parent: &str, name: &str) -> String {
    if parent.is_empty() { name.to_owned() } else { format!("{parent}.{name}") }
}

/// Whether all rows are solved by a fast method.
fn is_fast(case: &CaseFile, design: &Design) -> bool {
    let is_varied =
        |path: FieldPath| design.varied().iter().any(|varied| varied.field.path == path);
    let method = case.value(METHOD);
    !is_varied(METHOD) && method.is_some_and(|method| method != Setting::Choice("full"))
}
