//! Why a march cannot go on from a state.

use super::Error;
use crate::reporting::{Quantity, messages, readable};

messages! {
    /// What is wrong with a state to start from.
    StateError:

    /// A solution did not keep the state of the material.
    "no-state" NotKept {} Quantity::Method, |_name, _words| "a march that goes on from a \
         solution, and temperatures below the surface, need a solution that keeps the state of the \
         material".to_owned();

    /// The initial state is inconsistent.
    "impossible-state" Impossible {} Quantity::InitialState, |name, words| format!(
        "{name}: the state has an element outside the grid, two in one cell, one with more traction \
         than friction allows, or one with an impossible slip speed, friction or heat"
    );

    /// The initial state belongs to another grid.
    "state-of-another-grid" OfAnotherGrid {
        /// Columns and rows of its grid, and of that of the problem.
        cells: [[usize; 2]; 2],
        /// Size of the cells of both, in m.
        spacings: [[f64; 2]; 2],
    } Quantity::InitialState, |name, words| {
        let grid = |k: usize| {
            let ([columns, rows], [x, y]) = (cells[k], spacings[k].map(readable));
            format!("{columns} × {rows} cells of {x} × {y} m")
        };
        let [left, here] = [grid(0), grid(1)];
        format!("{name}: the state was left on a grid of {left}, but this problem has {here}")
    };
}

impl std::error::Error for StateError {}

impl From<StateError> for Error {
    fn from(error: StateError) -> Self {
        Self::State { error }
    }
}
