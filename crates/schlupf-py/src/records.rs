//! Records of the library as columns for NumPy.

use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use schlupf::reporting::{Record, Value};
use schlupf::solution::{Fields, Instant};
use schlupf::wheel_rail::{Contact, WheelSolution};
use schlupf::{Quantity, Solution};
use schlupf_tasks::output::Summary;
use schlupf_tasks::output::summary::Line;
use schlupf_tasks::output::table::{ColumnValues, Values};

/// Name, unit and meaning of columns.
type Described = Vec<(&'static str, &'static str, &'static str)>;

/// The columns of a solution, of a wheel, of its contacts, of cells and of instants, each under the
/// name of its record.
#[pyfunction]
pub fn column_table() -> Vec<(&'static str, Described)> {
    vec![
        ("solution", of_record::<Solution>()),
        ("wheel", of_record::<WheelSolution>()),
        ("contact", of_record::<Contact>()),
        ("cells", of_record::<Fields>()),
        ("instants", of_record::<[Instant]>()),
    ]
}

fn of_record<R: Record + ?Sized>() -> Described {
    let columns = R::COLUMNS.iter();
    columns.map(|of| (of.name, of.quantity.unit(), of.quantity.description())).collect()
}

/// Columns by name: each a dictionary with `values` (an array, or a list of names), and what
/// [`described`] adds.
pub fn arrays(py: Python<'_>, columns: Vec<ColumnValues>) -> PyResult<Bound<'_, PyDict>> {
    let table = PyDict::new(py);
    for ColumnValues { name, quantity, values } in columns {
        let values = match values {
            Values::Numbers(numbers) => PyArray1::from_vec(py, numbers).into_any(),
            Values::Counts(counts) => {
                let counts = counts.into_iter().map(|count| count as i64).collect();
                PyArray1::<i64>::from_vec(py, counts).into_any()
            }
            Values::Flags(flags) => PyArray1::from_vec(py, flags).into_any(),
            Values::Names(names) => names.into_bound_py_any(py)?,
        };
        table.set_item(name, described(py, quantity, values)?)?;
    }
    Ok(table)
}

/// The columns of fields at several instants, on one grid: arrays over instants, y and x; outside
/// of the contact not a number, or false.
pub fn on_grid<'py>(py: Python<'py>, instants: &[&Fields]) -> PyResult<Bound<'py, PyDict>> {
    let table = PyDict::new(py);
    for column in Fields::COLUMNS {
        let first = instants.iter().find(|fields| !fields.is_empty());
        let is_flag = first.is_some_and(|f| matches!((column.value)(f, 0), Value::Flag(_)));
        let values = if is_flag {
            let flag = |fields: &Fields, k| (column.value)(fields, k) == Value::Flag(true);
            filled(py, instants, false, flag)?
        } else {
            let number = |fields: &Fields, k| (column.value)(fields, k).number();
            filled(py, instants, f64::NAN, |fields, k| number(fields, k).unwrap_or(f64::NAN))?
        };
        table.set_item(column.name, described(py, column.quantity, values)?)?;
    }
    Ok(table)
}

/// The values of all cells of the grid; `blank` outside of the contact.
fn filled<'py, T: Element + Copy>(
    py: Python<'py>,
    instants: &[&Fields],
    blank: T,
    value: impl Fn(&Fields, usize) -> T,
) -> PyResult<Bound<'py, PyAny>> {
    let [rows, columns] =
        instants.first().map_or([0; 2], |fields| [fields.grid.rows, fields.grid.columns]);
    let mut values = vec![blank; instants.len() * rows * columns];
    for (fields, values) in instants.iter().zip(values.chunks_mut((rows * columns).max(1))) {
        for (k, [column, row]) in fields.cell.iter().enumerate() {
            values[row * columns + column] = value(fields, k);
        }
    }
    let values = PyArray1::from_vec(py, values);
    Ok(values.reshape([instants.len(), rows, columns])?.into_any())
}

/// The lines of a summary: an entry as name, value, unit and remark, anything else as text.
pub fn lines<'py>(py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyList>> {
    let list = PyList::empty(py);
    for line in &summary.lines {
        match line {
            Line::Entry { name, value, unit, remark } => {
                list.append((name, value, unit, remark))?;
            }
            other => list.append(other.to_string())?,
        }
    }
    Ok(list)
}

/// Values with `symbol`, `units`, `long_name`, `definition`, `source` and `vector` of their
/// quantity.
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
    entry.set_item("definition", quantity.definition())?;
    entry.set_item("source", quantity.source())?;
    entry.set_item("vector", quantity.vector())?;
    Ok(entry)
}
