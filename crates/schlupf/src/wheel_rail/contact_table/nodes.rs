//! A table as the numbers that it consists of.

use std::sync::Arc;

use crate::reporting::{Error, WheelRailError};
use crate::wheel_rail::contact_plane::Joining;
use crate::wheel_rail::pair::Pair;
use crate::wheel_rail::pose::{Pose, rotation};

use super::contacts::ContactTable;
use super::grid::{AXES, Axis, VALUES, YAWS};

/// Equal steps along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeAxis {
    /// Position of the first node: arc length along the wheel's profile in m, roll and yaw angle in
    /// rad, logarithm of the depth in m.
    pub start: f64,
    /// Distance of the nodes, in the unit of the position.
    pub step: f64,
    /// Number of nodes.
    pub count: usize,
}

/// The nodes of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTableNodes {
    /// Arc length along the wheel's profile, roll angle, yaw angle, logarithm of the depth.
    pub axes: [NodeAxis; AXES],
    /// At each node, the last axis fastest: normal force, length and width relative to Hertz's
    /// contact, and the centre of pressure along and across over its semi-axes; dimensionless.
    pub values: Vec<[f64; VALUES]>,
    /// The pair of profiles as a few lengths (in m), by which it is recognised.
    pub pair: Vec<f64>,
    /// E*, in Pa.
    pub contact_modulus: f64,
    /// Which contacts share a plane.
    pub joining: Joining,
}

/// Difference of a length of a pair (in m), and of moduli (dimensionless), from which on it is
/// another one.
const LENGTH: f64 = 1e-7;
const MODULUS: f64 = 1e-6;

/// Places along each profile at which a pair is recognised.
const PLACES: usize = 64;

impl ContactTable {
    /// What the table consists of.
    pub fn nodes(&self) -> ContactTableNodes {
        let axis = |axis: Axis| NodeAxis { start: axis.start, step: axis.step, count: axis.count };
        ContactTableNodes {
            axes: self.grid.axes.map(axis),
            values: self.grid.values().to_vec(),
            pair: recognised(&self.pair),
            contact_modulus: self.contact_modulus,
            joining: self.joining,
        }
    }

    /// The table of a pair with a contact modulus E* (in Pa) from its nodes.
    ///
    /// # Errors
    /// Nodes of another pair, other bodies, or another number of values.
    pub fn from_nodes(
        pair: &Arc<Pair>,
        (contact_modulus, joining): (f64, Joining),
        nodes: ContactTableNodes,
    ) -> Result<Self, Error> {
        let own = recognised(pair);
        let is_pair = nodes.pair.len() == own.len()
            && nodes.pair.iter().zip(&own).all(|(one, two)| (one - two).abs() <= LENGTH);
        let is_modulus = (nodes.contact_modulus / contact_modulus - 1.0).abs() <= MODULUS;
        let axis = |k: usize| {
            let NodeAxis { start, step, count } = nodes.axes[k];
            Axis { start, step, count, is_mirrored: k == YAWS }
        };
        let axes: [Axis; AXES] = std::array::from_fn(axis);
        let count: usize = axes.iter().map(|axis| axis.count).product();
        let is_axis = |axis: &Axis| {
            axis.start.is_finite() && axis.step > 0.0 && axis.step.is_finite() && axis.count >= 3
        };
        let is_contact = |values: &[f64; VALUES]| {
            values.iter().all(|value| value.is_finite())
                && values[..3].iter().all(|value| *value > 0.0)
        };
        if !(axes.iter().all(is_axis) && nodes.values.iter().all(is_contact)) {
            return Err(WheelRailError::BadContactTable {}.into());
        }
        if !(is_pair && is_modulus && nodes.joining == joining && nodes.values.len() == count) {
            return Err(WheelRailError::OtherContactTable {}.into());
        }
        let mut table = Self::over(pair, (contact_modulus, joining), axes)?;
        table.grid = table.grid.with(nodes.values);
        Ok(table)
    }
}

/// Lengths of a pair: points along both profiles in their places, and the radius of the wheel.
fn recognised(pair: &Pair) -> Vec<f64> {
    let along = |surface: &crate::wheel_rail::Surface| -> Vec<f64> {
        let arc = |k: usize| surface.length() * k as f64 / PLACES as f64;
        let points = (0..=PLACES).filter_map(|k| surface.point(0.0, arc(k)));
        points.flat_map(|point| point.place).collect()
    };
    let mut lengths = vec![pair.nominal_radius];
    lengths.extend(pair.wheel_origin());
    let upright = Pose { centre: [0.0; 3], rotation: rotation(0.0, 0.0) };
    lengths.extend(pair.wheel_in(&upright).rotation.into_iter().flatten());
    lengths.extend(along(&pair.wheel));
    lengths.extend(along(&pair.rail));
    lengths
}
