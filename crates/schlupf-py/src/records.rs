//! Records of the library as columns for NumPy.

use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schlupf::Quantity;
use schlupf::columns::{Record, Value};

/// All columns of a record, by name: each a dictionary with `values` (an array, or a list of
/// names), and what [`described`] adds.
pub fn columns<'py, R: Record + ?Sized>(
    py: Python<'py>,
    record: &R,
) -> PyResult<Bound<'py, PyDict>> {
    let table = PyDict::new(py);
    for column in R::columns() {
        let entries = || (0..record.rows()).map(|row| (column.value)(record, row));
        let is_known = |entry: &Value| !matches!(entry, Value::Unknown);
        let values = match entries().find(is_known) {
            Some(Value::Name(_)) => names(entries()).into_bound_py_any(py)?,
            Some(Value::Flag(_)) if entries().all(|entry| is_known(&entry)) => {
                let flags: Vec<bool> = entries().map(|entry| entry == Value::Flag(true)).collect();
                PyArray1::from_vec(py, flags).into_any()
            }
            Some(Value::Count(_)) if entries().all(|entry| is_known(&entry)) => {
                let counts = entries().map(|entry| entry.number().unwrap_or_default() as i64);
                PyArray1::from_vec(py, counts.collect()).into_any()
            }
            _ => {
                let numbers = entries().map(|entry| entry.number().unwrap_or(f64::NAN));
                PyArray1::from_vec(py, numbers.collect()).into_any()
            }
        };
        table.set_item(column.name, described(py, column.quantity, values)?)?;
    }
    Ok(table)
}

/// Values with `symbol`, `units`, `long_name` and `vector` of their quantity.
pub fn described<'py>(
    py: Python<'py>,
    quantity: Quantity,
    values: Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let entry = PyDict::new(py);
    entry.set_item("values", values)?;
    entry.set_item("symbol", quantity.symbol())?;
    entry.set_item("units", quantity.unit())?;
    entry.set_item("long_name", quantity.description())?;
    entry.set_item("vector", quantity.vector())?;
    Ok(entry)
}

fn names(entries: impl Iterator<Item = Value>) -> Vec<&'static str> {
    let name = |entry| if let Value::Name(name) = entry { name } else { "" };
    entries.map(name).collect()
}
