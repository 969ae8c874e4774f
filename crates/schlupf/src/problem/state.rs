//! The memory of the material in the contact: the state from which rolling continues.
//!
//! The heat records of a strip in steady rolling are one list: that of an element is the end of it.
//! A solution keeps its state only with [`Options::keeps_state`](crate::Options::keeps_state).

use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use crate::bodies::Kinematics;
use crate::interface::heat::HeatStep;
use crate::normal::Grid;
use crate::normal::patch::{Cell, Patch};

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
    /// Mean motion at the patch over the step that led here; that of the first step if it is not
    /// known.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Kinematics>,
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
    /// Earlier places of its path, the latest first.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "is_empty"))]
    pub track: Places,
    /// Temperature rise times effusivity in the cell, in W √s/m².
    #[cfg_attr(feature = "serde", serde(rename = "rise"))]
    pub scaled_rise: f64,
    /// Slip speed in the cell, in m/s.
    pub slip_speed: f64,
    /// Coefficient of friction on leaving the cell, dimensionless; if friction has a memory.
    pub friction_on_leaving: Option<f64>,
    /// Plastic displacement of the layer between the surfaces on leaving the cell, in m.
    #[cfg_attr(
        feature = "serde",
        serde(default, alias = "plastic_way", skip_serializing_if = "is_zero")
    )]
    pub plastic_displacement: f64,
    /// Heat received from entry until it leaves the cell, the latest step first.
    pub heat: HeatRecord,
}

/// Heat received by an element, the latest step first: a list of steps. Elements that have passed
/// the same places share them.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "Vec<HeatStep>", into = "Vec<HeatStep>"))]
pub struct HeatRecord {
    shared: Arc<[HeatStep]>,
    /// Number of steps at the front that came later and do not belong to it.
    later: usize,
}

impl HeatRecord {
    /// The end of a list of steps, without so many at the front.
    pub(crate) fn without(later: usize, shared: &Arc<[HeatStep]>) -> Self {
        Self { shared: Arc::clone(shared), later: later.min(shared.len()) }
    }
}

impl Deref for HeatRecord {
    type Target = [HeatStep];

    fn deref(&self) -> &[HeatStep] {
        &self.shared[self.later..]
    }
}

impl DerefMut for HeatRecord {
    fn deref_mut(&mut self) -> &mut [HeatStep] {
        &mut Arc::make_mut(&mut self.shared)[self.later..]
    }
}

impl PartialEq for HeatRecord {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl From<Vec<HeatStep>> for HeatRecord {
    fn from(steps: Vec<HeatStep>) -> Self {
        Self { shared: steps.into(), later: 0 }
    }
}

impl From<HeatRecord> for Vec<HeatStep> {
    fn from(record: HeatRecord) -> Self {
        record.to_vec()
    }
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

/// Largest number of places of a track.
pub(crate) const MOST_PLACES: usize = 3;

/// The last few places that an element has passed, the latest first.
#[derive(Debug, Clone, Copy, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "Vec<TrackPoint>", into = "Vec<TrackPoint>"))]
pub struct Places {
    places: [TrackPoint; MOST_PLACES],
    count: usize,
}

impl Deref for Places {
    type Target = [TrackPoint];

    fn deref(&self) -> &[TrackPoint] {
        &self.places[..self.count]
    }
}

impl DerefMut for Places {
    fn deref_mut(&mut self) -> &mut [TrackPoint] {
        &mut self.places[..self.count]
    }
}

impl PartialEq for Places {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl FromIterator<TrackPoint> for Places {
    /// The first places; older ones do not matter.
    fn from_iter<I: IntoIterator<Item = TrackPoint>>(places: I) -> Self {
        let mut track = Self::default();
        for (own, place) in track.places.iter_mut().zip(places) {
            *own = place;
            track.count += 1;
        }
        track
    }
}

impl From<Vec<TrackPoint>> for Places {
    fn from(places: Vec<TrackPoint>) -> Self {
        places.into_iter().collect()
    }
}

impl From<Places> for Vec<TrackPoint> {
    fn from(places: Places) -> Self {
        places.to_vec()
    }
}

#[cfg(feature = "serde")]
fn is_empty(track: &Places) -> bool {
    track.is_empty()
}

#[cfg(feature = "serde")]
#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(way: &f64) -> bool {
    *way == 0.0
}

impl State {
    /// Cells without previous tangential load.
    pub(crate) fn without_tractions(grid: Grid) -> Self {
        Self { grid, time: 0.0, elements: vec![Element::default()], motion: None }
    }

    /// A patch without previous tangential load.
    pub fn at_rest(patch: &Patch) -> Self {
        let element = |cell: &Cell| Element { index: cell.index, ..Element::default() };
        let elements = patch.cells.iter().map(element).collect();
        Self { grid: patch.grid, time: 0.0, elements, motion: None }
    }
}
