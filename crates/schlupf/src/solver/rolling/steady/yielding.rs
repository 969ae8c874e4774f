//! Plastic flow of the layer between the surfaces in steady rolling: what bounds the traction of a
//! cell follows from the path that its material has flowed upstream.

use crate::interface::{Flow, ThirdBodyLayer, YieldLimit};
use crate::normal::patch::{Cell, Patch};

/// The layer in every cell.
pub(super) struct Yielding {
    layer: ThirdBodyLayer,
    limit: YieldLimit,
    /// Pressure over the covered part of each cell, in Pa.
    pressure: Vec<f64>,
    flows: Vec<Flow>,
    /// Whether the layer hardens within the cell to what friction allows.
    catches_up: Vec<bool>,
    /// What bounds the traction over the pressure, dimensionless.
    pub coefficient: Vec<f64>,
}

/// Small changes of what the flow in a cell depends on.
pub(super) struct FlowCause {
    /// Of the coefficient of friction, dimensionless.
    pub friction: f64,
    /// Of the slip until the cell's point and through the cell, in m.
    pub slips: [f64; 2],
    /// Of the limit of elasticity.
    pub limit: YieldLimit,
}

impl YieldLimit {
    /// What a change by this adds to the limit after a plastic displacement (in m), in Pa.
    fn raised(&self, path: f64) -> f64 {
        self.stress + self.hardening * path
    }
}

impl Yielding {
    /// Of the layer of a problem on a patch, if it has a limit of elasticity.
    pub fn new(layer: Option<ThirdBodyLayer>, patch: &Patch) -> Option<Self> {
        let layer = layer?;
        let limit = layer.yield_limit()?;
        let pressure = patch.cells.iter().map(Cell::pressure_where_covered);
        let cells = patch.len();
        Some(Self {
            layer,
            limit,
            pressure: pressure.collect(),
            flows: vec![Flow::default(); cells],
            catches_up: vec![false; cells],
            coefficient: vec![0.0; cells],
        })
    }

    /// Sets the bound of a cell with a coefficient of friction, under slips (in m) until the cell's
    /// point and through the cell.
    pub fn pass(&mut self, k: usize, is_first: bool, friction: f64, slips: [f64; 2]) {
        let flowed = if is_first { 0.0 } else { self.flows[k - 1].left };
        self.flows[k] = self.layer.pass(friction * self.pressure[k], flowed, slips);
        self.catches_up[k] = self.flows[k].left > flowed && !self.flows[k].yields[1];
        self.coefficient[k] = self.flows[k].bound / self.pressure[k];
    }

    /// Whether the layer bounds the traction of a cell, and not friction.
    pub fn yields(&self, k: usize) -> bool {
        self.flows[k].yields[0]
    }

    /// The plastic displacement with which the material leaves a cell, in m.
    pub fn on_leaving(&self, k: usize) -> f64 {
        self.flows[k].left
    }

    /// Change of the coefficient of a cell, dimensionless. `carried` is that of the plastic
    /// displacement (in m) on arrival, and then that on leaving.
    pub fn change(&self, k: usize, cause: &FlowCause, carried: &mut f64) -> f64 {
        let flow = &self.flows[k];
        let arrived = *carried;
        if flow.yields[1] {
            *carried = arrived + cause.slips[1];
        } else if self.catches_up[k] {
            // Where it has hardened to μ pₙ: τ_c0 + k_τ w = μ pₙ.
            let missing = self.pressure[k] * cause.friction - cause.limit.raised(flow.left);
            *carried = missing / self.limit.hardening;
        }
        if !flow.yields[0] {
            return cause.friction;
        }
        if flow.bound <= 0.0 {
            return 0.0;
        }
        let flowed = self.limit.hardening * (arrived + cause.slips[0]);
        (flowed + cause.limit.raised(flow.here)) / self.pressure[k]
    }
}
