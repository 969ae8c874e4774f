//! What a march starts from: its grid, the state from which it continues, its validity, and its
//! elements in the cells of the patch.

use crate::interface::heat::HeatStep;
use crate::normal::patch::Patch;
use crate::normal::{BORDER, Grid, NormalContact};
use crate::problem::{Element, Options, State, TrackPoint, Transient};
use crate::reporting::{Error, StateError};

use super::arrival::positions;

/// Largest coefficient of friction allowed in a state, dimensionless.
const LARGEST_FRICTION: f64 = 1e3;

/// A march can only continue from a state on the grid on which the state was left.
pub(super) fn fitting(state: &State, grid: &Grid) -> Result<State, Error> {
    let mut taken = vec![false; grid.len()];
    let is_sound = |element: &Element| {
        let is_new =
            element.index < grid.len() && !std::mem::replace(&mut taken[element.index], true);
        let is_heat = |step: &HeatStep| {
            step.flux.is_finite() && step.duration > 0.0 && step.duration.is_finite()
        };
        let is_within = |[x, y]: [f64; 2]| x.hypot(y) <= 1.0 + 1e-6;
        let is_track = |track: &[TrackPoint]| {
            track.iter().all(|place| {
                let is_ahead = (0.0..f64::INFINITY).contains(&place.distance);
                is_ahead
                    && place.sliding.iter().all(|s| s.is_finite())
                    && is_within(place.saturation)
            }) && track.is_sorted_by(|one, next| one.distance <= next.distance)
        };
        let is_friction = |mu: f64| (0.0..=LARGEST_FRICTION).contains(&mu);
        is_new
            && is_within(element.saturation)
            && element.scaled_rise.is_finite()
            && (0.0..f64::INFINITY).contains(&element.slip_speed)
            && element.friction_on_leaving.is_none_or(is_friction)
            && (0.0..f64::INFINITY).contains(&element.plastic_displacement)
            && element.heat.iter().all(is_heat)
            && is_track(&element.track)
            && element.traction.iter().chain(&element.sliding).all(|v| v.is_finite())
    };
    check_grid(&state.grid, grid)?;
    if state.elements.is_empty() {
        return Err(StateError::NotKept {}.into());
    }
    if state.elements.iter().all(is_sound) {
        Ok(state.clone())
    } else {
        Err(StateError::Impossible {}.into())
    }
}

/// Elements are of the cells of a grid: on another one they mean nothing.
fn check_grid(of_state: &Grid, grid: &Grid) -> Result<(), Error> {
    let close = |p: f64, q: f64| (p - q).abs() <= 1e-9 * grid.spacing_x.hypot(grid.spacing_y);
    let fits = (of_state.columns, of_state.rows) == (grid.columns, grid.rows)
        && close(of_state.spacing_x, grid.spacing_x)
        && close(of_state.spacing_y, grid.spacing_y)
        && close(of_state.origin_x, grid.origin_x)
        && close(of_state.origin_y, grid.origin_y);
    if fits {
        return Ok(());
    }
    let both = [of_state, grid];
    Err(StateError::OfAnotherGrid {
        cells: both.map(|grid| [grid.columns.saturating_sub(2 * BORDER), grid.rows]),
        spacings: both.map(|grid| [grid.spacing_x, grid.spacing_y]),
    }
    .into())
}

/// The elements in the order of the patch; a cell that had none gets one without history.
pub(super) fn on_patch(patch: &Patch, elements: &[Element]) -> Vec<Element> {
    let at = positions(patch, elements);
    let blank = |index| Element { index, ..Element::default() };
    patch
        .cells
        .iter()
        .map(|c| at[c.index].map_or(blank(c.index), |e| elements[e].clone()))
        .collect()
}

/// A single grid over the largest patch.
pub(in crate::solver::rolling) fn grid_over_history(
    transient: &Transient,
    options: &Options,
) -> Result<Grid, Error> {
    let largest = transient.history.largest_load();
    let contact: NormalContact = transient.problem.normal.normal_contact(largest)?;
    Ok(Grid::across(&contact.extent(), options.cells_x, options.cells_y))
}

/// Maximum number of time steps of a history.
const MAX_HISTORY_STEPS: f64 = 1e6;

/// Checks that a history ends within the maximum number of steps of a cell (in m).
pub(super) fn check_length(transient: &Transient, spacing: f64) -> Result<(), Error> {
    let Transient { problem, history, .. } = transient;
    let [start, end] = history.span();
    let fastest = history.fastest(&problem.kinematics);
    let steps = (end - start) * fastest / spacing;
    let resolved = start.abs().max(end.abs()) * f64::EPSILON * 1e3;
    let is_resolved = resolved < spacing / fastest;
    if steps <= MAX_HISTORY_STEPS && is_resolved {
        return Ok(());
    }
    Err(Error::HistoryTooLong { span: [start, end], steps, most: MAX_HISTORY_STEPS })
}
