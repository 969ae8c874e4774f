//! Everything about the contact at one instant, cell by cell.

use crate::heat::HeatStep;
use crate::heat::partition::Conduction;
use crate::kinematics::Kinematics;
use crate::patch::{Patch, Strip};

/// The contact at one instant; per cell in the order of the patch, vectors as x, y of each cell.
#[derive(Debug, Clone)]
pub(super) struct Snapshot {
    pub kinematics: Kinematics,
    pub conduction: Conduction,
    /// Traction on the rail p, in Pa.
    pub traction: Vec<f64>,
    /// A p, in m: the displacement difference rail minus wheel.
    pub displacement: Vec<f64>,
    /// Sliding into each cell, in m.
    pub increment: Vec<[f64; 2]>,
    /// Slip speed on the way into each cell, in m/s.
    pub slip_speed: Vec<f64>,
    /// Coefficient of friction, dimensionless.
    pub friction: Vec<f64>,
    /// Temperature rise times effusivity in each cell, in W √s/m².
    pub rise: Vec<f64>,
    /// Work of friction per area on the way into each cell, in J/m².
    pub work_in: Vec<f64>,
    /// What happens on the way out of each strip.
    pub exits: Vec<Exit>,
}

/// From the last cell of a strip to its trailing edge.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Exit {
    /// Work of friction per area, in J/m².
    pub work: f64,
    /// Temperature rise times effusivity at the trailing edge, in W √s/m².
    pub rise: f64,
}

impl Snapshot {
    /// Nothing has happened in any of `cells` cells.
    pub fn blank(kinematics: Kinematics, conduction: Conduction, cells: usize) -> Self {
        Self {
            kinematics,
            conduction,
            traction: vec![0.0; 2 * cells],
            displacement: vec![0.0; 2 * cells],
            increment: vec![[0.0; 2]; cells],
            slip_speed: vec![0.0; cells],
            friction: vec![0.0; cells],
            rise: vec![0.0; cells],
            work_in: vec![0.0; cells],
            exits: Vec::new(),
        }
    }

    /// Traction on the rail in a cell, in Pa.
    pub fn traction_at(&self, k: usize) -> [f64; 2] {
        [self.traction[2 * k], self.traction[2 * k + 1]]
    }

    /// A p in a cell, in m.
    pub fn displacement_at(&self, k: usize) -> [f64; 2] {
        [self.displacement[2 * k], self.displacement[2 * k + 1]]
    }

    /// μ pₙ of each cell, in Pa.
    pub fn bound(&self, patch: &Patch) -> Vec<f64> {
        patch.cells.iter().zip(&self.friction).map(|(cell, mu)| mu * cell.pressure).collect()
    }

    /// The heat that an element receives for some work of friction on a way, at the present speed.
    /// What the bristles of the contact law return does not cool.
    pub fn heat_step(&self, work: f64, distance: f64) -> HeatStep {
        let duration = distance / self.kinematics.speed;
        HeatStep { flux: work.max(0.0) / duration, duration }
    }
}

/// How much of the traction of an edge cell works on the way between the edge and the cell.
///
/// Between two cells the work is ½ (p₁ + p₂)·Δs. A strip of whole cells would have cells without
/// traction beyond its edges, a full Δx away; the weights give the edge cell, whose way is shorter,
/// the work that it would have there. So rigid slip works with each cell's whole force, and the
/// elastic parts of a strip cancel as they must.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EdgeWeights {
    rigid: f64,
    elastic: f64,
}

impl EdgeWeights {
    /// Weights of the first cell of a strip.
    pub fn at_entry(patch: &Patch, strip: &Strip, coupled: bool) -> Self {
        let first = strip.cells.start;
        let to_edge = patch.cells[first].since_entry.distance;
        if strip.cells.len() == 1 {
            return Self::of_single_cell(patch, strip, coupled);
        }
        Self::new(patch, to_edge, patch.cells[first + 1].way_in.distance, coupled)
    }

    /// Weights of the last cell of a strip.
    pub fn at_exit(patch: &Patch, strip: &Strip, coupled: bool) -> Self {
        if strip.cells.len() == 1 {
            return Self::of_single_cell(patch, strip, coupled);
        }
        let last = strip.cells.end - 1;
        Self::new(patch, strip.exit.distance, patch.cells[last].way_in.distance, coupled)
    }

    fn of_single_cell(patch: &Patch, strip: &Strip, coupled: bool) -> Self {
        let through =
            patch.cells[strip.cells.start].since_entry.distance + strip.exit.distance;
        let rigid = patch.grid.spacing_x / through;
        Self { rigid, elastic: if coupled { rigid } else { 0.5 } }
    }

    fn new(patch: &Patch, to_edge: f64, to_neighbour: f64, coupled: bool) -> Self {
        let rigid = (patch.grid.spacing_x - 0.5 * to_neighbour) / to_edge;
        // Without coupling nothing moves at the edge: the traction rises from zero with u.
        Self { rigid, elastic: if coupled { rigid } else { 0.5 } }
    }

    /// Work per area (in J/m²) of the edge cell's traction p with its rigid slip and the elastic
    /// change of A p on the way.
    pub fn work(&self, p: [f64; 2], rigid: [f64; 2], elastic: [f64; 2]) -> f64 {
        (0..2).map(|c| p[c] * (self.rigid * rigid[c] - self.elastic * elastic[c])).sum()
    }
}
