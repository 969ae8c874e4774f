//! What a normal contact is made from, and what the rest of a case must know of it.

use crate::import::contact::basic::{Area, Motion};
use crate::import::contact::control::Control;
use crate::import::contact::material::Elastic;

use super::frame::Frame;

/// What the rest of the case must know of its normal contact.
#[derive(Debug, Clone, Copy)]
pub struct Contact {
    /// Normal load, in N.
    pub load: f64,
    /// The point at which creepages hold, in mm in the file's axes.
    pub centre: [f64; 2],
    /// Distance of the middle of the first row of elements from that of the contact, and width of
    /// a row, in mm in the file's axes; unknown before the contact is solved on a table.
    pub rows: Option<[f64; 2]>,
}

/// The normal problem of an input case of module 3.
#[derive(Debug, Clone, Copy)]
pub struct NormalProblem<'a> {
    /// Control digits.
    pub control: &'a Control,
    /// Loads.
    pub motion: &'a Motion,
    /// Materials.
    pub elastic: &'a Elastic,
    /// Potential contact area.
    pub area: &'a Area,
    /// Axes.
    pub frame: Frame,
}
