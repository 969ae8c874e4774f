//! The contacts of a wheelset over its lateral position.

use std::sync::Arc;

use schlupf::message::Message;
use schlupf::wheel_rail::{RollingRadiusDifference, Support, WheelSolution};
use schlupf::{Watch, parallel};
use schlupf_case::CaseFile;
use schlupf_output::wheelset::{Conicity, WheelsetAt, WheelsetReport};

use crate::solve::of_wheel;
use crate::{TaskError, messages};

/// Lateral positions by default, in m, and their number.
pub const RANGE: [f64; 2] = [-8e-3, 8e-3];
/// Number of positions by default.
pub const POINTS: usize = 33;

/// Step of the amplitudes of the equivalent conicity, and of the positions from which it is found,
/// in m.
const AMPLITUDE_STEP: f64 = 1e-3;
const RADIUS_STEP: f64 = 5e-5;

/// Where to put the wheelset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// First and last lateral position, in m.
    pub range: [f64; 2],
    /// Number of positions.
    pub points: usize,
}

impl Default for Request {
    fn default() -> Self {
        Self { range: RANGE, points: POINTS }
    }
}

/// A case with where to put its wheelset.
#[derive(Debug)]
pub struct Plan {
    file: CaseFile,
    request: Request,
    load: f64,
}

/// Checks the case.
///
/// # Errors
/// A case without profiles, or with a height in place of the vertical force.
pub fn plan(file: &CaseFile, request: Request) -> Result<Plan, TaskError> {
    let file = file.clone();
    let wheel = file.wheel()?;
    let Support::Force(load) = wheel.support else {
        return Err(TaskError::Request(
            "wheelset.height must be left out for the contacts of a wheelset that rests on both \
             rails: give normal.load"
                .to_owned(),
        ));
    };
    Ok(Plan { file, request, load })
}

impl Plan {
    /// Finds all contacts.
    ///
    /// # Errors
    /// Whatever keeps the contacts of any position from being found.
    pub fn find(self, watch: Watch) -> Result<WheelsetReport, TaskError> {
        let Self { file, request, load } = self;
        let [from, to] = request.range;
        let last = request.points.max(2) - 1;
        let lateral: Vec<f64> =
            (0..=last).map(|k| from + (to - from) * k as f64 / last as f64).collect();
        let positions = parallel::try_map(lateral, |lateral| {
            let wheels = file.wheels_at(lateral, watch)?;
            let wheels: [WheelSolution; 2] = wheels
                .try_into()
                .map_err(|_| TaskError::Request("the wheelset must have two wheels".to_owned()))?;
            Ok::<_, TaskError>(WheelsetAt { lateral, wheels })
        })?;
        let pair = Arc::clone(&file.wheel()?.pair);
        let largest = from.abs().max(to.abs());
        let intervals = (largest / RADIUS_STEP).ceil().max(1.0) as usize;
        let explain = |error| TaskError::from(file.explain(&error));
        let radii =
            RollingRadiusDifference::new(&pair, largest, intervals, watch).map_err(explain)?;
        let conicity = conicity(&radii, largest).map_err(explain)?;
        let warnings = file.notices().into_iter().chain(of_positions(&positions)).collect();
        Ok(WheelsetReport { title: file.title()?, pair, load, positions, conicity, warnings })
    }
}

fn conicity(radii: &RollingRadiusDifference, largest: f64) -> Result<Conicity, schlupf::Error> {
    let count = (largest / AMPLITUDE_STEP + 1e-9).floor() as usize;
    let mut amplitude: Vec<f64> = (1..=count).map(|k| k as f64 * AMPLITUDE_STEP).collect();
    if amplitude.is_empty() {
        amplitude.push(largest);
    }
    // Rounding must not take the last one beyond the positions.
    let within = amplitude.iter().map(|amplitude| amplitude.min(largest));
    let conicity = within.map(|a| radii.equivalent_conicity(a)).collect::<Result<_, _>>()?;
    Ok(Conicity { amplitude, conicity })
}

/// What to know about the contacts, each kind of message once for each wheel.
fn of_positions(positions: &[WheelsetAt]) -> Vec<Message> {
    let mut found: Vec<Message> = Vec::new();
    for at in positions {
        for wheel in &at.wheels {
            let first = wheel.contacts.first().into_iter();
            let first = first.flat_map(|contact| messages(&contact.solution.warnings));
            let place = format!("{} wheel at {} mm", wheel.side.name(), millimetres(at.lateral));
            for message in first.chain(of_wheel(wheel)) {
                let is_known = found.iter().any(|known| known.code == message.code);
                if message.is_of_convergence() || !is_known {
                    found.push(message.about(&place));
                }
            }
        }
    }
    found
}

/// A length in mm with six digits after the point at most.
fn millimetres(length: f64) -> f64 {
    (1e9 * length).round() / 1e6
}
