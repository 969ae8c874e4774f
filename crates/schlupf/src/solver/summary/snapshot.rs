//! Everything about the contact at one instant, cell by cell.

use crate::bodies::Kinematics;
use crate::interface::heat::Conduction;
use crate::interface::heat::contact_conduction::Surfaces;
use crate::normal::NormalSummary;
use crate::normal::patch::Patch;

/// The contact at one instant; per cell in the order of the patch, vectors as x, y of each cell in
/// turn.
#[derive(Debug, Clone)]
pub(crate) struct Snapshot {
    pub kinematics: Kinematics,
    /// Means over the last time step; in steady rolling the same.
    pub over_step: Kinematics,
    pub conduction: Conduction,
    /// Traction on the rail p, in Pa.
    pub traction: Vec<f64>,
    /// A p, in m: the displacement difference rail minus wheel; with that under the pressure.
    pub displacement: Vec<f64>,
    /// Slip velocity of the wheel over the rail, mean over each cell, in m/s.
    pub slip: Vec<[f64; 2]>,
    /// Coefficient of friction, dimensionless.
    pub friction: Vec<f64>,
    /// Temperature rise times effusivity in each cell, in W √s/m².
    pub scaled_rise: Vec<f64>,
    /// Friction power per unit area p·slip in each cell, in W/m².
    pub friction_power: Vec<f64>,
    /// Elastic energy of the tangential tractions, in J.
    pub stored_energy: f64,
    /// Power of these tractions with the displacement under the pressure, in W.
    pub pressed_power: f64,
    /// Temperature rise times effusivity at the trailing edge of each strip, in W √s/m².
    pub scaled_exit_rise: Vec<f64>,
    /// Surface temperatures of both bodies if heat also flows along them: they do not follow from
    /// the rises then.
    pub surfaces: Option<Surfaces>,
}

/// A contact at one instant, as input of the summary.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub normal: &'a NormalSummary,
    pub patch: &'a Patch,
    pub now: &'a Snapshot,
}

impl Snapshot {
    /// A snapshot of `cells` cells in which nothing has happened.
    pub fn blank(kinematics: Kinematics, conduction: Conduction, cells: usize) -> Self {
        Self {
            kinematics,
            over_step: kinematics,
            conduction,
            traction: vec![0.0; 2 * cells],
            displacement: vec![0.0; 2 * cells],
            slip: vec![[0.0; 2]; cells],
            friction: vec![0.0; cells],
            scaled_rise: vec![0.0; cells],
            friction_power: vec![0.0; cells],
            stored_energy: 0.0,
            pressed_power: 0.0,
            scaled_exit_rise: Vec::new(),
            surfaces: None,
        }
    }

    /// Traction on the rail in a cell, in Pa.
    pub fn traction_at(&self, k: usize) -> [f64; 2] {
        [self.traction[2 * k], self.traction[2 * k + 1]]
    }

    /// Surface temperatures of wheel and rail in a cell, in degC.
    pub fn surface_temperatures(&self, k: usize) -> [f64; 2] {
        let follow = || self.conduction.surface_temperatures(self.scaled_rise[k]);
        self.surfaces.as_ref().map_or_else(follow, |surfaces| surfaces.cells[k])
    }

    /// The same at the trailing edge of a strip, in degC.
    pub fn exit_temperatures(&self, strip: usize) -> [f64; 2] {
        let follow = || self.conduction.surface_temperatures(self.scaled_exit_rise[strip]);
        self.surfaces.as_ref().map_or_else(follow, |surfaces| surfaces.exits[strip])
    }

    /// μ pₙ of each cell, in Pa.
    pub fn bound(&self, patch: &Patch) -> Vec<f64> {
        patch.cells.iter().zip(&self.friction).map(|(cell, mu)| mu * cell.pressure).collect()
    }
}
