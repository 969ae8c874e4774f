//! Laws that Python gives, as functions of arrays.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use schlupf::interface::friction::{FrictionLaw, FrictionResponse, FrictionState};
use schlupf::interface::heat::PartitionLaw;

/// Functions in place of the laws of a case.
#[derive(Default)]
pub struct Functions {
    /// μ of temperatures above the reference (in K), slip speeds (in m/s) and places y (in m).
    pub friction: Option<Py<PyAny>>,
    /// Share of the wheel in the heat, of the speeds of both surfaces, in m/s.
    pub partition: Option<Py<PyAny>>,
}

impl Functions {
    /// These functions once more.
    pub fn clone_ref(&self, py: Python<'_>) -> Self {
        let clone = |law: &Option<Py<PyAny>>| law.as_ref().map(|law| law.clone_ref(py));
        Self { friction: clone(&self.friction), partition: clone(&self.partition) }
    }
}

/// The first exception of functions that are called from any thread.
#[derive(Debug, Default)]
pub struct Raised(Mutex<Option<PyErr>>);

impl Raised {
    /// Whether there is one.
    pub fn is_set(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    /// It.
    pub fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn keep(&self, error: PyErr) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }
}

/// A function that takes arrays of one length and returns such an array.
#[derive(Debug)]
struct Function {
    function: Py<PyAny>,
    raised: Arc<Raised>,
}

impl Function {
    /// Its values; not numbers if it raises an exception, which is kept.
    fn call<const N: usize, const M: usize>(&self, arguments: [[f64; N]; M]) -> [f64; N] {
        if self.raised.is_set() {
            return [f64::NAN; N];
        }
        Python::attach(|py| {
            self.values(py, arguments).unwrap_or_else(|error| {
                self.raised.keep(error);
                [f64::NAN; N]
            })
        })
    }

    fn values<const N: usize, const M: usize>(
        &self,
        py: Python<'_>,
        arguments: [[f64; N]; M],
    ) -> PyResult<[f64; N]> {
        let arrays = arguments.map(|values| PyArray1::from_slice(py, &values));
        let arrays = pyo3::types::PyTuple::new(py, arrays)?;
        let values = self.function.bind(py).call1(arrays)?;
        let values: PyReadonlyArray1<'_, f64> = values.extract()?;
        let mut found = [f64::NAN; N];
        for (found, value) in found.iter_mut().zip(values.as_array()) {
            *found = *value;
        }
        Ok(found)
    }
}

/// Makes a friction law of a function.
pub fn friction(function: Py<PyAny>, raised: &Arc<Raised>) -> Arc<dyn FrictionLaw> {
    Arc::new(Friction(Function { function, raised: Arc::clone(raised) }))
}

/// Makes a law of the heat partition of a function.
pub fn partition(function: Py<PyAny>, raised: &Arc<Raised>) -> Arc<dyn PartitionLaw> {
    Arc::new(Share(Function { function, raised: Arc::clone(raised) }))
}

#[derive(Debug)]
struct Friction(Function);

impl FrictionLaw for Friction {
    /// One call for the coefficient and its derivatives, which are differences.
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        // In K, m/s and m: far above rounding, far below what friction changes over.
        const WARMER: f64 = 1e-3;
        const FASTER: f64 = 1e-6;
        const ASIDE: f64 = 1e-7;
        let FrictionState { temperature: t, slip_speed: v, y } = *state;
        let faster = FASTER * v.max(1.0);
        // Slip has no negative speed.
        let slower = (v - faster).max(0.0);
        let [here, warm, cold, fast, slow, left, right, reference] = self.0.call([
            [t, t + WARMER, t - WARMER, t, t, t, t, 0.0],
            [v, v, v, v + faster, slower, v, v, 0.0],
            [y, y, y, y, y, y + ASIDE, y - ASIDE, 0.0],
        ]);
        FrictionResponse {
            coefficient: here,
            by_temperature: (warm - cold) / (2.0 * WARMER),
            by_slip_speed: (fast - slow) / (v + faster - slower),
            by_y: (left - right) / (2.0 * ASIDE),
            by_cold_coefficient: here / reference,
        }
    }
}

#[derive(Debug)]
struct Share(Function);

impl PartitionLaw for Share {
    fn share(&self, [wheel, rail]: [f64; 2]) -> f64 {
        self.0.call([[wheel], [rail]])[0]
    }
}
