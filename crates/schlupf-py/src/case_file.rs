//! A checked case.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use schlupf::normal::{PressureSource, PressureTable, Tabulated};
use schlupf::problem::State;
use schlupf::{Error, Watch};
use schlupf_case::fields::{self, Kind};
use schlupf_case::{CaseErrors, Folder, Laws, Overrides, Place, Setting};
use schlupf_tasks::solve::solve;

use crate::errors;
use crate::interruptible::interruptible;
use crate::laws::{self, Functions, Raised};
use crate::solution::Solution;

/// What messages call the assignments of the package.
const ARGUMENT: &str = "Case";

/// A case that was read and checked; nothing is solved yet.
#[pyclass(frozen, module = "schlupf._core")]
pub struct CaseFile {
    file: schlupf_case::CaseFile,
    functions: Functions,
}

impl CaseFile {
    /// A case that was read.
    pub fn new_from(file: schlupf_case::CaseFile) -> Self {
        Self { file, functions: Functions::default() }
    }

    /// Works with the case, its functions in place; Ctrl-C and exceptions of the functions stop it.
    pub fn run<R: Send, E: From<CaseErrors> + Send>(
        &self,
        py: Python<'_>,
        raised: &Arc<Raised>,
        work: impl FnOnce(&schlupf_case::CaseFile, Watch) -> Result<R, E> + Send,
    ) -> PyResult<Result<R, E>> {
        let own = self.own_laws(py, raised);
        interruptible(py, raised, |watch| {
            let file = self.file.clone().with_laws(own);
            work(&file.map_err(CaseErrors::from)?, watch)
        })
    }

    /// The case, without its functions.
    pub fn file(&self) -> &schlupf_case::CaseFile {
        &self.file
    }

    /// The laws of the case with its functions in place.
    fn own_laws(&self, py: Python<'_>, raised: &Arc<Raised>) -> Laws {
        let Functions { friction, partition } = self.functions.clone_ref(py);
        Laws {
            friction: friction.map(|function| laws::friction(function, raised)),
            partition: partition.map(|function| laws::partition(function, raised)),
            ..self.file.laws().clone()
        }
    }
}

#[pymethods]
impl CaseFile {
    /// From a TOML text; relative paths start in `folder`. Each assignment is
    /// `section.field=value`, with the value as in TOML.
    #[new]
    #[pyo3(signature = (text, name, folder, assignments))]
    fn new(
        py: Python<'_>,
        text: &str,
        name: &str,
        folder: PathBuf,
        assignments: Vec<String>,
    ) -> PyResult<Self> {
        let overrides = Overrides { option: ARGUMENT, assignments: &assignments };
        let file = schlupf_case::CaseFile::from_str(text, name, Folder::new(folder), overrides);
        checked(py, file)
    }

    /// From a file.
    #[staticmethod]
    fn from_file(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        checked(py, schlupf_case::CaseFile::from_path(&path, Overrides::NONE))
    }

    /// This case with other fields.
    fn with_fields(&self, py: Python<'_>, assignments: Vec<String>) -> PyResult<Self> {
        let file = self.file.with(ARGUMENT, &assignments);
        let file = file.map_err(|errors| errors::of_case(py, &errors))?;
        Ok(Self { file, functions: self.functions.clone_ref(py) })
    }

    /// This case with functions in place of its friction law and its heat partition, and with a
    /// pressure (in Pa) at places x and y (in m), rows along x, scaled to a load (in N) if there is
    /// one.
    #[pyo3(signature = (friction, partition, pressure, load))]
    fn with_laws(
        &self,
        py: Python<'_>,
        friction: Option<Py<PyAny>>,
        partition: Option<Py<PyAny>>,
        pressure: Option<[Vec<f64>; 3]>,
        load: Option<f64>,
    ) -> PyResult<Self> {
        let source = |[x, y, pressure]: [Vec<f64>; 3]| -> Result<Arc<dyn PressureSource>, Error> {
            let table = PressureTable::new(&x, &y, pressure)?;
            Ok(Arc::new(Tabulated::new(table, load)?))
        };
        let pressure = pressure.map(source).transpose();
        let pressure = pressure.map_err(|error| PyValueError::new_err(error.to_string()))?;
        let file = self.file.clone().with_laws(Laws { pressure, ..Laws::default() });
        let file = file.map_err(|error| errors::of_case(py, &error.into()))?;
        Ok(Self { file, functions: Functions { friction, partition } })
    }

    /// As TOML, with paths from `folder`.
    fn to_toml(&self, py: Python<'_>, folder: PathBuf) -> PyResult<String> {
        let text = self.file.edited(&[], &folder);
        text.map_err(|error| errors::of_case(py, &error.into()))
    }

    /// The value of a field in effect, in SI units; `None` if it has none.
    fn value<'py>(&self, py: Python<'py>, path: &str) -> PyResult<Bound<'py, PyAny>> {
        let field = fields::named(path, || Place::Default);
        let field = field.map_err(|error| errors::of_case(py, &error.into()))?;
        match self.file.value(field.path) {
            None => Ok(py.None().into_bound(py)),
            Some(Setting::Number(number)) if matches!(field.kind, Kind::Count) => {
                (number as i64).into_bound_py_any(py)
            }
            Some(Setting::Number(number)) => number.into_bound_py_any(py),
            Some(Setting::Text(text)) => text.into_bound_py_any(py),
            Some(Setting::Flag(flag)) => flag.into_bound_py_any(py),
            Some(Setting::Choice(name)) => name.into_bound_py_any(py),
            Some(Setting::Series(numbers)) => numbers.into_bound_py_any(py),
        }
    }

    /// Paths of the fields that are given.
    fn given(&self) -> Vec<String> {
        self.file.given().map(|path| path.to_string()).collect()
    }

    /// Fields in effect: path, value as text, and whether it is the default.
    fn effective(&self, py: Python<'_>) -> PyResult<Vec<(&'static str, String, bool)>> {
        let case = self.run(py, &Arc::default(), |file, watch| file.pose(watch))?;
        let case = case.map_err(|errors| errors::of_case(py, &errors))?;
        let fields = case.effective().into_iter();
        Ok(fields.map(|f| (f.path.as_str(), f.value, matches!(f.place, Place::Default))).collect())
    }

    /// Solves the case, from a state as JSON if there is one; in time with the fields of every so
    /// many steps.
    #[pyo3(signature = (initial_state=None, fields_every=0))]
    fn solve(
        &self,
        py: Python<'_>,
        initial_state: Option<&[u8]>,
        fields_every: usize,
    ) -> PyResult<Solution> {
        let state = initial_state.map(serde_json::from_slice::<State>).transpose();
        let state = state.map_err(|error| {
            PyValueError::new_err(format!("initial_state must be a state of a result: {error}"))
        })?;
        let report = self.run(py, &Arc::default(), |file, watch| {
            let mut case = file.pose(watch)?;
            case.options.fields_every = fields_every;
            let rolling = case.rolling(state)?;
            solve(&case, rolling, watch).map_err(|error| CaseErrors::from(case.explain(&error)))
        })?;
        report.map(Solution::new).map_err(|errors| errors::of_case(py, &errors))
    }
}

fn checked(py: Python<'_>, file: Result<schlupf_case::CaseFile, CaseErrors>) -> PyResult<CaseFile> {
    match file {
        Ok(file) => Ok(CaseFile { file, functions: Functions::default() }),
        Err(errors) => Err(errors::of_case(py, &errors)),
    }
}
