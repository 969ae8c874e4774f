//! The steady state as one equilibrium: the history of an element, including its heat, is what lies
//! upstream of it in its strip. Traction, temperature and friction are found together.

use crate::equilibrium::{self, Equilibrium};
use crate::numerics::vector::{add_scaled, norm};
use crate::problem::Problem;
use crate::rolling::shared::contact::Displaced;

use super::level::{Descent, Level};
use super::steady_friction::{Change, FrictionCause, SteadyFriction};
use super::strip_law::{Cause, Changed, StripLaw};

/// The steady equilibrium on the first of several levels. The coarser ones, solved before, are part
/// of the preconditioner.
///
/// The linear response to p is b, the change of A p from cell to cell; and if friction depends on
/// heat or slip, also the change of A p along the passage of each cell.
pub(super) struct SteadyState<'a> {
    problem: &'a Problem,
    levels: &'a mut [Level],
}

impl<'a> SteadyState<'a> {
    /// The state on the first of `levels`, which must not be empty.
    pub fn new(problem: &'a Problem, levels: &'a mut [Level]) -> Self {
        Self { problem, levels }
    }

    fn level(&self) -> &Level {
        &self.levels[0]
    }

    fn is_coupled(&self) -> bool {
        self.level().friction.is_coupled
    }

    /// Evaluates friction at p, and the resulting bound.
    fn evaluate_friction(&mut self, p: &[f64], u: &[f64]) {
        if self.is_coupled() {
            let level = &mut self.levels[0];
            let passing = &u[level.size()..];
            level.friction.evaluate(self.problem, &level.contact.patch, p, passing);
            level.take_bound();
        }
    }
}

impl Equilibrium for SteadyState<'_> {
    fn size(&self) -> usize {
        self.level().size()
    }

    fn response_size(&self) -> usize {
        self.size() * if self.is_coupled() { 2 } else { 1 }
    }

    fn scale(&self, p: &[f64]) -> f64 {
        equilibrium::measure(self.level().strips.scale(), norm(p))
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        let is_coupled = self.is_coupled();
        let Level { contact, strips, workspace, .. } = &mut self.levels[0];
        let strips = Strips { law: strips, traction: p };
        relate(contact.product(p), &strips, &mut workspace.at_entry, u, is_coupled);
    }

    fn residual(&mut self, p: &[f64], u: &[f64], residual: &mut [f64]) {
        self.evaluate_friction(p, u);
        self.levels[0].strips.residual(p, u, residual);
    }

    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]) {
        let is_coupled = self.is_coupled();
        let Level { strips, friction, workspace, .. } = &mut self.levels[0];
        if !is_coupled {
            strips.tangent(&Changed { traction: v, response, bound: None }, None, product);
            return;
        }
        let change = Change { traction: v, passing: &response[v.len()..] };
        friction.bound_changes(change, None, &mut workspace.flux, &mut workspace.bound);
        let bound = Some(workspace.bound.as_slice());
        strips.tangent(&Changed { traction: v, response, bound }, None, product);
    }

    fn complete(&self, p: &mut [f64]) {
        self.level().strips.complete(p);
    }

    /// The state of rigid bodies, which is a good guess where friction follows a high slip speed.
    fn other_guess(&mut self, p: &mut [f64]) -> bool {
        if self.is_coupled() {
            let Level { contact, strips, friction, .. } = &mut self.levels[0];
            p.fill(0.0);
            strips.uncoupled_state([0.0; 2], p);
            friction.rigid_slip_state(self.problem, &contact.patch, strips.bound(), p);
        }
        self.is_coupled()
    }

    fn recycles(&self) -> bool {
        true
    }

    fn precondition(&mut self, v: &mut [f64]) {
        precondition(self.levels, v);
    }
}

/// The strips of a patch under a traction (in Pa).
struct Strips<'a> {
    law: &'a StripLaw,
    traction: &'a [f64],
}

/// The linear response from the result of a product: the displacement at the cells relative to the
/// upstream neighbour, and the change along the passage if required.
fn relate(
    mut made: Displaced,
    strips: &Strips,
    at_entry: &mut [f64],
    response: &mut [f64],
    is_coupled: bool,
) {
    let (b, passing) = response.split_at_mut(at_entry.len());
    made.at_cells(b);
    made.at_entries(at_entry);
    for (b, entry) in b.iter_mut().zip(at_entry) {
        *b -= *entry;
    }
    strips.law.relate(strips.traction, b);
    if is_coupled {
        made.change_in_passing(passing);
    }
}

/// Small changes of the data of the equilibrium.
pub(super) struct Direct {
    /// Of the data of the contact law.
    pub cause: Cause,
    /// Of the linear response at the same traction, in m; empty if there is none.
    pub response: Vec<f64>,
    /// Of μ pₙ at the same friction, in Pa.
    pub bound: Vec<f64>,
    /// Of the data of friction.
    pub friction: FrictionCause,
}

impl Direct {
    /// No change in any of `cells` cells.
    pub fn nothing(cells: usize) -> Self {
        Self {
            cause: Cause { rigid: vec![0.0; 2 * cells], stiffness: 0.0 },
            response: Vec::new(),
            bound: vec![0.0; cells],
            friction: FrictionCause::nothing(cells),
        }
    }
}

impl SteadyState<'_> {
    /// Change of F at the same traction, in Pa.
    pub fn change_by(&mut self, direct: &Direct, change: &mut [f64]) {
        let is_coupled = self.is_coupled();
        let size = self.size();
        let mut response = direct.response.clone();
        response.resize(self.response_size(), 0.0);
        let Level { contact, strips, friction, workspace, .. } = &mut self.levels[0];
        let nothing = vec![0.0; size];
        if is_coupled {
            let unloaded = Change { traction: &nothing, passing: &response[size..] };
            let cause = Some(&direct.friction);
            friction.bound_changes(unloaded, cause, &mut workspace.flux, &mut workspace.bound);
        } else {
            let cells = contact.patch.cells.iter().zip(&direct.friction.law).enumerate();
            for (bound, (k, (cell, law))) in workspace.bound.iter_mut().zip(cells) {
                *bound = if friction.yields(k) { 0.0 } else { cell.pressure * law };
            }
        }
        for (bound, direct) in workspace.bound.iter_mut().zip(&direct.bound) {
            *bound += direct;
        }
        let b = &response[..size];
        let bound = Some(workspace.bound.as_slice());
        let changed = Changed { traction: &nothing, response: b, bound };
        strips.tangent(&changed, Some(&direct.cause), change);
    }

    /// Slip, heat and friction at the solution, where they do not bear on it.
    pub fn evaluate_passing(&mut self) {
        let Level { contact, friction, traction, .. } = &mut self.levels[0];
        let mut passing = vec![0.0; traction.len()];
        contact.product(traction).change_in_passing(&mut passing);
        friction.evaluate(self.problem, &contact.patch, traction, &passing);
    }

    /// Derivative of the linear response at the solution with respect to the logarithm of the patch
    /// size; returns whether the elasticity knows it.
    pub fn response_by_size(&mut self, response: &mut [f64]) -> bool {
        let is_coupled = self.is_coupled();
        let Level { contact, strips, traction, workspace, .. } = &mut self.levels[0];
        let made = contact.product_by_size(traction);
        let is_known = made.is_some();
        if let Some(made) = made {
            let strips = Strips { law: strips, traction };
            relate(made, &strips, &mut workspace.at_entry, response, is_coupled);
        }
        // The law has added the calibration of the layer, which does not depend on the size.
        if is_known && let Some(mut of_layer) = self.calibration_of_layer() {
            let size = of_layer.len();
            self.slide(&mut of_layer);
            add_scaled(&mut response[..size], -1.0, &of_layer);
        }
        is_known
    }

    /// What the law adds to the shear of the layer between the surfaces at the present traction,
    /// where the displacement is calibrated; in m.
    fn calibration_of_layer(&mut self) -> Option<Vec<f64>> {
        let Level { contact, traction, .. } = &mut self.levels[0];
        if !contact.compliance.couples_cells() {
            return None;
        }
        let cells = contact.patch.cells.iter();
        let pressure: Vec<f64> = cells.flat_map(|cell| [cell.pressure; 2]).collect();
        let mut missing = vec![0.0; traction.len()];
        contact.product_of_layer(&pressure)?.at_cells(&mut missing);
        let layer = contact.layer_compliance;
        for (at, missing) in missing.iter_mut().enumerate() {
            let cell = &contact.patch.cells[at / 2];
            *missing = (layer / cell.covered - *missing / cell.pressure) * traction[at];
        }
        Some(missing)
    }

    /// Sliding over the way into each cell from displacements relative to the entry (in m), without
    /// what the law adds to any displacement.
    fn slide(&mut self, b: &mut [f64]) {
        let Level { strips, traction, workspace, .. } = &mut self.levels[0];
        workspace.at_entry.fill(0.0);
        strips.relate(traction, &mut workspace.at_entry);
        strips.relate(traction, b);
        add_scaled(b, -1.0, &workspace.at_entry);
    }

    /// The part of the linear response at the present traction that is the shear of the layer
    /// between the surfaces. Returns whether there is one.
    ///
    /// Where the displacement is calibrated, so is this.
    pub fn response_of_layer(&mut self, response: &mut [f64]) -> bool {
        let is_coupled = self.is_coupled();
        let calibration = self.calibration_of_layer();
        let Level { contact, traction, workspace, .. } = &mut self.levels[0];
        let (b, passing) = response.split_at_mut(workspace.at_entry.len());
        let Some(mut made) = contact.product_of_layer(traction) else { return false };
        made.at_cells(b);
        if is_coupled {
            made.change_in_passing(passing);
        }
        if let Some(calibration) = calibration {
            add_scaled(b, 1.0, &calibration);
        }
        self.slide(b);
        true
    }
}

/// One pass down the strips of the first level, with its long waves replaced by those of the
/// coarser levels.
fn precondition(levels: &mut [Level], v: &mut [f64]) {
    let Some((level, coarser)) = levels.split_first_mut() else { return };
    let Some(Descent { transfer, carried, known }) = &mut level.descent else {
        sweep(&mut level.strips, &level.friction, v);
        return;
    };
    level.strips.complete(v);
    transfer.restrict(v, carried);
    sweep(&mut level.strips, &level.friction, v);
    transfer.restrict(v, known);
    precondition(coarser, carried);
    for (carried, known) in carried.iter_mut().zip(known) {
        *carried -= *known;
    }
    transfer.add_prolonged(carried, v);
    level.strips.complete(v);
}

fn sweep(strips: &mut StripLaw, friction: &SteadyFriction, v: &mut [f64]) {
    strips.precondition(v, friction.is_coupled.then_some(friction));
}
