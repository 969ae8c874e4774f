//! The force element, for loops in Python.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use schlupf::Watch;
use schlupf::element::{Given, Rows, Signal, Status};
use schlupf_case::{CaseErrors, FieldNames};

use crate::case_file::CaseFile;
use crate::errors;

/// Outputs, rates, derivatives and statuses, one row after the other.
type Found<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<u8>>,
);

/// Name, unit and description of an input, output or state.
type Described = (String, &'static str, String);

/// An element.
#[pyclass(frozen, module = "schlupf._core")]
pub struct Element(Mutex<schlupf::element::Element>);

/// Names of the numbers of statuses.
#[pyfunction]
pub fn element_status() -> Vec<&'static str> {
    Status::ALL.iter().map(|status| status.name()).collect()
}

fn described(signals: &[Signal]) -> Vec<Described> {
    let one = |of: &Signal| (of.name().to_owned(), of.unit(), of.description());
    signals.iter().map(one).collect()
}

#[pymethods]
impl Element {
    /// Of a case.
    #[new]
    fn new(py: Python<'_>, case: &CaseFile) -> PyResult<Self> {
        let raised = Arc::default();
        let made = case.run(py, &raised, |file, watch: Watch| -> Result<_, CaseErrors> {
            Ok(file.pose(watch)?.element()?)
        })?;
        let made = made.map_err(|errors| errors::of_case(py, &errors))?;
        Ok(Self(Mutex::new(made)))
    }

    /// Inputs, outputs and states.
    fn signals(&self, py: Python<'_>) -> [Vec<Described>; 3] {
        let element = self.own(py);
        [element.inputs(), element.outputs(), element.states()].map(described)
    }

    /// Code, quantity and text of each warning.
    fn warnings(&self, py: Python<'_>) -> Vec<(String, String, String)> {
        let element = self.own(py);
        let messages = element.warnings().iter().map(|warning| warning.message(&FieldNames::CASE));
        messages.map(|told| (told.code.to_owned(), told.quantity, told.text)).collect()
    }

    /// The inputs of the case.
    fn start<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.own(py).start())
    }

    /// Evaluates rows of inputs and states, one after the other.
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        inputs: PyReadonlyArray1<'py, f64>,
        states: PyReadonlyArray1<'py, f64>,
        has_derivatives: bool,
    ) -> PyResult<Found<'py>> {
        let mut element = self.own(py);
        let (of_inputs, of_states) = (element.inputs().len(), element.states().len());
        let (given, of_outputs) = (inputs.as_slice()?, element.outputs().len());
        let count = given.len() / of_inputs;
        let of_derivatives = (of_outputs + of_states) * (of_inputs + of_states);
        let room = |width: usize| PyArray1::<f64>::zeros(py, count * width, false);
        let (outputs, rates) = (room(of_outputs), room(of_states));
        let derivatives = room(if has_derivatives { of_derivatives } else { 0 });
        let mut status = vec![Status::default(); count];
        let given = Given { inputs: given, states: states.as_slice()? };
        let (mut all_outputs, mut all_rates) = (outputs.try_readwrite()?, rates.try_readwrite()?);
        let mut all_derivatives = derivatives.try_readwrite()?;
        let all_derivatives = all_derivatives.as_slice_mut()?;
        let rows = Rows {
            outputs: all_outputs.as_slice_mut()?,
            rates: all_rates.as_slice_mut()?,
            derivatives: has_derivatives.then_some(all_derivatives),
            status: &mut status,
        };
        let own = &mut *element;
        let done = py.detach(|| own.evaluate_rows(given, rows));
        done.ok_or_else(|| PyValueError::new_err("inputs and states must have as many rows"))?;
        let numbers = status.into_iter().map(|status| status as u8);
        Ok((outputs, rates, derivatives.clone(), PyArray1::from_iter(py, numbers)))
    }

    /// States after a time with constant inputs, one row after the other.
    fn advance<'py>(
        &self,
        py: Python<'py>,
        inputs: PyReadonlyArray1<'py, f64>,
        states: PyReadonlyArray1<'py, f64>,
        duration: f64,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let element = self.own(py);
        let mut states = states.as_slice()?.to_vec();
        let of_states = element.states().len();
        if of_states > 0 {
            let (own, inputs) = (&*element, inputs.as_slice()?);
            py.detach(|| {
                let rows = inputs.chunks(own.inputs().len()).zip(states.chunks_mut(of_states));
                for (inputs, states) in rows {
                    if own.advance(inputs, states, duration) == Status::NotFinite {
                        states.fill(f64::NAN);
                    }
                }
            });
        }
        Ok(PyArray1::from_vec(py, states))
    }

    /// Forgets what a solver found.
    fn forget(&self, py: Python<'_>) {
        self.own(py).forget();
    }
}

impl Element {
    /// A panic within an evaluation leaves an element that goes on.
    fn own(&self, py: Python<'_>) -> MutexGuard<'_, schlupf::element::Element> {
        self.0.lock_py_attached(py).unwrap_or_else(PoisonError::into_inner)
    }
}
