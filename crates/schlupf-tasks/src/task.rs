//! What every task has, and how faces reach all of them.

use std::io;
use std::path::{Path, PathBuf};

use schlupf::Watch;
use schlupf_case::{CaseErrors, CaseFile};

use crate::TaskError;
use crate::output::report::{OwnFile, Report};
use crate::request::{Asked, Field, Request, Rule};

/// Something that a case can be asked: one name and one request for all faces.
pub trait Task {
    /// Its name: the command, and the function in Python.
    const NAME: &'static str;
    /// The function in Python, where that has another name.
    const FUNCTION: &'static str = Self::NAME;
    /// What it does, in an imperative sentence without full stop.
    const ABOUT: &'static str;
    /// Publications that it rests on, for its documentation.
    const SOURCES: &'static str = "";
    /// How a command names the case, and which one that is.
    const CASE: CaseArgument = CaseArgument::Positional(
        "of a rolling contact; by default a steel wheel braking on a steel rail",
    );
    /// Whether what it finds has several results with a status each, so that functions return it
    /// although some have not converged.
    const HAS_SEVERAL: bool = false;
    /// What it is asked.
    type Request: Request;
    /// What it finds.
    type Report: Report + 'static;

    /// Checks whatever can be checked before the work, and does it.
    ///
    /// # Errors
    /// A case or request that is wrong, and whatever the solver refuses.
    fn run(
        of: &Given,
        request: Self::Request,
        wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<Self::Report>, TaskError>;

    /// Names of the figures that it may draw of a case.
    fn figure_names(_case: &CaseFile, _asked: &Asked) -> Vec<String> {
        Self::Report::figure_names()
    }
}

/// How a command names the case, and which one that is, to follow "a case".
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CaseArgument {
    /// By its path alone.
    Positional(&'static str),
    /// By an option: the task is about something else first.
    Option(&'static str),
}

impl CaseArgument {
    /// Which one it is.
    pub fn doc(self) -> &'static str {
        match self {
            Self::Positional(doc) | Self::Option(doc) => doc,
        }
    }
}

/// The case of a task.
pub struct Given<'a> {
    /// It, with what overrides its fields.
    pub case: &'a CaseFile,
    /// Whether it is the default one because none was named.
    pub is_default: bool,
    /// What overrides fields, as `section.field=value`, with what messages call it.
    pub overrides: (&'static str, &'a [String]),
    /// Makes a folder to work in, which goes with what is returned.
    pub scratch: &'a (dyn Fn() -> io::Result<Scratch> + Sync),
}

impl<'a> Given<'a> {
    /// A case as it is. Where a task needs a folder to work in, it has none.
    pub fn of(case: &'a CaseFile) -> Self {
        Self {
            case,
            is_default: false,
            overrides: ("", &[]),
            scratch: &|| Err(io::Error::other("no folder to work in was given")),
        }
    }
}

/// A folder that is removed when this is dropped.
pub type Scratch = Box<dyn AsRef<Path>>;

/// What a face is going to take of a report, where that changes the work.
#[derive(Debug, Clone, Default)]
pub struct Wanted {
    /// The figures.
    pub figures: bool,
    /// The table as CSV.
    pub table: bool,
    /// Files of its own: their formats, and where they are going to lie.
    pub files: Vec<(&'static str, PathBuf)>,
}

impl Wanted {
    /// Where a file of a format is going to lie, if it is wanted.
    pub fn file(&self, format: &str) -> Option<&Path> {
        self.files.iter().find(|(own, _)| *own == format).map(|(_, path)| path.as_path())
    }
}

/// What a task has found.
pub struct Found<R: ?Sized> {
    /// The results.
    pub report: Box<R>,
    /// Why not all that was wanted can be written.
    pub failure: Option<CaseErrors>,
}

impl<R> From<R> for Found<R> {
    fn from(report: R) -> Self {
        Self { report: Box::new(report), failure: None }
    }
}

/// A task as faces see it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// [`Task::NAME`].
    pub name: &'static str,
    /// [`Task::FUNCTION`].
    pub function: &'static str,
    /// [`Task::ABOUT`].
    pub about: &'static str,
    /// [`Task::SOURCES`].
    pub sources: &'static str,
    /// [`Task::CASE`].
    pub case: CaseArgument,
    /// [`Task::HAS_SEVERAL`].
    pub has_several: bool,
    /// The fields of its request.
    pub fields: fn() -> Vec<Field>,
    /// What holds between them.
    pub rules: &'static [Rule],
    /// The files of its own that it can write.
    pub own_files: fn() -> &'static [OwnFile],
    /// Names of all figures that it can draw.
    pub all_figures: fn() -> Vec<String>,
    /// [`Task::figure_names`].
    pub figure_names: fn(&CaseFile, &Asked) -> Vec<String>,
    /// Reads the request: what is wrong with it is known before the case is read.
    pub read: fn(&Asked) -> Result<Work, TaskError>,
}

/// [`Task::run`] with a request that was read.
pub type Work =
    Box<dyn FnOnce(&Given, &Wanted, Watch) -> Result<Found<dyn Report>, TaskError> + Send>;

impl Entry {
    pub(crate) const fn of<T: Task>() -> Self {
        Self {
            name: T::NAME,
            function: T::FUNCTION,
            about: T::ABOUT,
            sources: T::SOURCES,
            case: T::CASE,
            has_several: T::HAS_SEVERAL,
            fields: T::Request::fields,
            rules: T::Request::RULES,
            own_files: T::Report::own_files,
            all_figures: T::Report::figure_names,
            figure_names: T::figure_names,
            read: |asked| {
                let request = T::Request::read(asked)?;
                Ok(Box::new(|of, wanted, watch| {
                    let Found { report, failure } = T::run(of, request, wanted, watch)?;
                    Ok(Found { report: report as Box<dyn Report>, failure })
                }))
            },
        }
    }

    /// Whether it is about what must be given first, besides which the case is optional: a function
    /// of its own in Python, not one of the case.
    pub fn is_of_argument(&self) -> bool {
        (self.fields)().iter().any(|field| field.is_positional && field.is_needed())
    }
}
