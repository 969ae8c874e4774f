//! The steady state as one equilibrium: the history of an element, including its heat, is what lies
//! upstream of it in its strip. Traction, temperature and friction are found together.

use std::borrow::Cow;

use crate::bodies::Kinematics;
use crate::normal::patch::{Cell, Patch};
use crate::numerics::vector::norm;
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solver::equilibrium::{self, Equilibrium};
use crate::solver::prescribed::MovedEquilibrium;
use crate::solver::rolling::shared::contact::Displaced;
use crate::solver::rolling::shared::strip::Calibrated;

use super::level::{Descent, Level};
use super::steady_friction::{Change, FrictionCause, SteadyFriction};
use super::strip_law::{Cause, Changed, StripLaw};

/// The steady equilibrium on the first of several levels. The coarser ones, solved before, are part
/// of the preconditioner.
///
/// The linear response to p is b, the change of A p from cell to cell; and if friction depends on
/// heat or slip, also the change of A p along the passage of each cell.
pub(super) struct SteadyState<'a> {
    problem: Cow<'a, Problem>,
    levels: &'a mut [Level],
}

impl<'a> SteadyState<'a> {
    /// The state on the first of `levels`, which must not be empty.
    pub fn new(problem: &'a Problem, levels: &'a mut [Level]) -> Self {
        Self { problem: Cow::Borrowed(problem), levels }
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
            level.friction.evaluate(&self.problem, &level.contact.patch, p, passing);
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
        let (b, passing) = u.split_at_mut(p.len());
        let mut made = contact.product(p);
        relative(&made, &mut workspace.at_entry, b);
        strips.relate(p, b);
        if is_coupled {
            made.change_in_passing(passing);
        }
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

    /// The state of rigid bodies, which is a good guess where friction follows a high slip speed.
    fn other_guess(&mut self, p: &mut [f64]) -> bool {
        if self.is_coupled() {
            self.levels[0].rigid_state(&self.problem, p);
        }
        self.is_coupled()
    }

    fn precondition(&mut self, v: &mut [f64]) {
        precondition(self.levels, v);
    }
}

impl MovedEquilibrium for SteadyState<'_> {
    fn patch(&self) -> &Patch {
        &self.level().contact.patch
    }

    fn set_motion(&mut self, motion: &Kinematics) {
        self.problem.to_mut().kinematics = *motion;
        self.levels[0].set_motion(&self.problem);
    }

    fn change_by_motion(&mut self, change: &Kinematics, of_residual: &mut [f64]) {
        let change = Kinematics { speed: self.problem.kinematics.speed, ..*change };
        let mut direct = Direct::nothing(self.level().strips.len());
        for (k, cell) in self.level().contact.patch.cells.iter().enumerate() {
            direct.set_motion(k, cell, &change);
        }
        self.change_by(&direct, of_residual);
    }
}

/// Displacements at the cells relative to those where their material entered, in m.
fn relative(made: &Displaced, at_entry: &mut [f64], b: &mut [f64]) {
    made.at_cells(b);
    made.at_entries(at_entry);
    for (b, entry) in b.iter_mut().zip(at_entry) {
        *b -= *entry;
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

    /// The changes in a cell when its motion changes.
    pub fn set_motion(&mut self, k: usize, cell: &Cell, motion: &Kinematics) {
        let path = &cell.path_in;
        let rigid = path.rigid_slip(motion);
        let slip = motion.rigid_slip(cell.x, cell.y);
        for c in 0..2 {
            self.cause.rigid[2 * k + c] = rigid[c];
            self.friction.slip[k][c] = motion.speed * slip[c];
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
        friction.evaluate(&self.problem, &contact.patch, traction, &passing);
    }

    /// A part or a derivative of the linear response at the solution; returns whether the
    /// elasticity knows it.
    ///
    /// # Errors
    /// Those of the compliance on a finer grid.
    pub fn part_of_response(
        &mut self,
        what: Calibrated,
        response: &mut [f64],
    ) -> Result<bool, Error> {
        let is_coupled = self.is_coupled();
        let Level { contact, strips, traction, workspace, .. } = &mut self.levels[0];
        let (b, passing) = response.split_at_mut(workspace.at_entry.len());
        let made = match what {
            Calibrated::Displacement => Some(contact.product(traction)),
            Calibrated::BySize => contact.product_by_size(traction),
            Calibrated::OfLayer => contact.product_of_layer(traction),
        };
        let Some(mut made) = made else { return Ok(false) };
        relative(&made, &mut workspace.at_entry, b);
        if is_coupled {
            made.change_in_passing(passing);
        }
        let normal = self.problem.normal.normal_contact(None)?;
        strips.relate_part(what, (&self.problem, &normal), contact, (traction, b))
    }
}

/// Solves the strips of the first level one by one, with the long waves replaced by those of the
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
