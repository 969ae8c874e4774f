//! The memory of the material in the contact: the state from which rolling continues.

use crate::grid::Grid;
use crate::heat::HeatStep;
use crate::patch::{Cell, Patch};

/// State of all elements in contact at one instant.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// The grid of the elements.
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
    /// Grid cell of the element.
    pub index: usize,
    /// Traction on the rail, mean over the cell, in Pa.
    pub traction: [f64; 2],
    /// Traction on the rail over μ pₙ, dimensionless.
    pub saturation: [f64; 2],
    /// Sliding distance since entry, in m.
    pub sliding: [f64; 2],
    /// Elastic part of the sliding on the path into the cell, divided by the length of that path,
    /// dimensionless.
    pub stretch: [f64; 2],
    /// Earlier places of its path, the latest first; empty where bristles are followed from cell to
    /// cell.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub track: Vec<TrackPoint>,
    /// Temperature rise times effusivity in the cell, in W √s/m².
    #[cfg_attr(feature = "serde", serde(rename = "rise"))]
    pub scaled_rise: f64,
    /// Slip speed in the cell, in m/s.
    pub slip_speed: f64,
    /// Coefficient of friction on leaving the cell, dimensionless; if friction has a memory.
    pub friction_on_leaving: Option<f64>,
    /// Plastic way of the layer between the surfaces on leaving the cell, in m.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "is_zero"))]
    pub plastic_way: f64,
    /// Heat received from entry until it leaves the cell, the latest step first.
    pub heat: Vec<HeatStep>,
}

/// A place that an element has passed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrackPoint {
    /// Way from there to the element, in m.
    pub distance: f64,
    /// Sliding distance from entry to there, in m.
    pub sliding: [f64; 2],
    /// Traction on the rail over μ pₙ there, dimensionless.
    pub saturation: [f64; 2],
}

#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(way: &f64) -> bool {
    *way == 0.0
}

impl State {
    /// A patch without previous tangential load.
    pub fn at_rest(patch: &Patch) -> Self {
        let element = |cell: &Cell| Element { index: cell.index, ..Element::default() };
        Self { grid: patch.grid, time: 0.0, elements: patch.cells.iter().map(element).collect() }
    }
}
