//! Tables of the contacts of a wheel with two profiles.

use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use schlupf::wheel_rail::{ContactTableOptions, Spread};
use schlupf_case::contact_table::{self as file, OptionNames, ROLL, YAW};
use schlupf_case::{CaseErrors, direction};

use crate::case_file::CaseFile;
use crate::errors;

/// An angle in rad, or text with its unit.
#[derive(FromPyObject)]
pub enum Angle {
    Number(f64),
    Text(String),
}

impl Angle {
    fn read(given: Option<&Self>, argument: &str, default: f64) -> Result<f64, CaseErrors> {
        match given {
            None => Ok(default),
            Some(Self::Number(number)) => Ok(*number),
            Some(Self::Text(text)) => Ok(direction(argument, text)?),
        }
    }
}

/// Bytes of the file, whether it is within the tolerance, nodes without an exact contact, number of
/// poses, and the errors in them: median, 90 %, 99 %, largest.
type Made<'py> = (Bound<'py, PyBytes>, (bool, usize, usize), Vec<[f64; 4]>);

/// The table of a case: largest roll and yaw angle and tolerance if they are given; most nodes, and
/// random poses in which errors are measured.
#[pyfunction]
pub fn contact_table<'py>(
    py: Python<'py>,
    case: &CaseFile,
    angles: [Option<Angle>; 2],
    tolerance: Option<f64>,
    counts: [usize; 2],
) -> PyResult<Made<'py>> {
    let options = options(&angles, tolerance, counts);
    let options = options.map_err(|errors| errors::of_case(py, &errors))?;
    let made = case.run(py, &Arc::default(), |case, watch| -> Result<_, CaseErrors> {
        Ok(case.pose(watch)?.contact_table(&options, watch)?)
    })?;
    let (table, found) = made.map_err(|errors| errors::of_case(py, &errors))?;
    let bytes = file::to_bytes(&table, &found);
    let bytes = bytes.map_err(|error| PyValueError::new_err(format!("the table {error}")))?;
    let numbers = |of: &Spread| [of.median, of.ninety_percent, of.ninety_nine_percent, of.largest];
    let spreads = file::spreads(&found).map(|(_, spread)| numbers(spread));
    let made = (found.is_within_tolerance, found.failed_nodes, found.poses);
    Ok((PyBytes::new(py, &bytes), made, spreads.to_vec()))
}

fn options(
    [roll, yaw]: &[Option<Angle>; 2],
    tolerance: Option<f64>,
    [most_nodes, poses]: [usize; 2],
) -> Result<ContactTableOptions, CaseErrors> {
    let default = ContactTableOptions::default();
    let options = ContactTableOptions {
        roll: Angle::read(roll.as_ref(), ROLL, default.roll)?,
        yaw: Angle::read(yaw.as_ref(), YAW, default.yaw)?,
        tolerance: tolerance.unwrap_or(default.tolerance),
        most_nodes,
        poses,
        ..default
    };
    file::check(&options, &OptionNames(str::to_owned))?;
    Ok(options)
}
