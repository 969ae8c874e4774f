//! What the material in the contact remembers: the state from which rolling goes on.

use crate::grid::Grid;
use crate::heat::HeatStep;
use crate::patch::{Cell, Patch};

/// State of all elements in contact at one instant.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// The grid on which the elements stand.
    pub grid: Grid,
    /// Time, in s.
    pub time: f64,
    /// The elements in contact.
    pub elements: Vec<Element>,
}

/// A point contact element.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Element {
    /// Cell of the grid in which it is.
    pub index: usize,
    /// Traction on the rail, mean over the cell, in Pa.
    pub traction: [f64; 2],
    /// Traction on the rail over μ pₙ, dimensionless.
    pub saturation: [f64; 2],
    /// Sliding distance since entry, in m.
    pub sliding: [f64; 2],
    /// Elastic part of the sliding on the way into the cell, over that way, dimensionless.
    pub stretch: [f64; 2],
    /// Temperature rise times effusivity in the cell, in W √s/m².
    pub rise: f64,
    /// Slip speed in the cell, in m/s.
    pub slip_speed: f64,
    /// Coefficient of friction with which it leaves the cell, dimensionless; if friction remembers.
    pub friction_on_leaving: Option<f64>,
    /// Heat received since entry and until it leaves the cell, the latest step first.
    pub heat: Vec<HeatStep>,
}

impl State {
    /// A patch that has not been loaded tangentially yet.
    pub fn at_rest(patch: &Patch) -> Self {
        let element = |cell: &Cell| Element { index: cell.index, ..Element::default() };
        Self { grid: patch.grid, time: 0.0, elements: patch.cells.iter().map(element).collect() }
    }
}
