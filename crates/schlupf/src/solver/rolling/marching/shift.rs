//! Two bodies at rest, pressed together and shifted tangentially: Cattaneo's and Mindlin's problem,
//! for any patch, elasticity and contact law.
//!
//! No material is transported, so there is one equilibrium: every cell slides by the shift minus
//! the elastic deformation of the bodies, with the same shift in all cells.

use crate::bodies::Kinematics;
use crate::normal::VectorField;
use crate::problem::{Element, Places};
use crate::reporting::{Error, Watch};
use crate::solver::equilibrium::{Limits, Newton, Outcome};
use crate::solver::prescribed::ForceGoal;
use crate::solver::rolling::shared::contact::DiscreteContact;

use super::step::Step;
use super::step_response::Known;
use super::time_step::{TimeStepLaw, Track};

/// Speed and creepages of bodies that do not roll.
pub(super) const AT_REST: Kinematics =
    Kinematics { speed: 0.0, creepage_x: 0.0, creepage_y: 0.0, spin: 0.0 };

/// A shift added to the history of the elements.
pub(super) struct Shift<'a> {
    /// Along and across rolling, in m.
    pub distance: [f64; 2],
    pub contact: &'a mut DiscreteContact,
    /// A p of the previous traction on the whole grid, in m.
    pub displacement: &'a VectorField,
    pub law: &'a mut TimeStepLaw,
    /// μ pₙ of each cell, in Pa.
    pub bound: &'a [f64],
    /// The elements in the order of the patch.
    pub elements: &'a mut [Element],
}

impl Shift<'_> {
    /// Finds the equilibrium after the shift, starting from the traction on the rail p before it
    /// (in Pa), and stores it there and in the elements.
    pub fn find(
        self,
        newton: &mut Newton,
        p: &mut Vec<f64>,
        limits: &Limits,
        watch: Watch,
    ) -> Result<Outcome, Error> {
        let mut before = vec![0.0; p.len()];
        self.contact.interpolation.gather(self.displacement, &mut before);
        self.law.contact.calibration.add_at_cells(p, &mut before);
        let sliding = before.chunks_exact(2);
        let displacement = sliding.flat_map(|u| [0, 1].map(|c| self.distance[c] + u[c])).collect();
        let cells = self.elements.len();
        let known = Known {
            displacement,
            path: vec![0.0; cells],
            in_contact: vec![1.0; cells],
            in_place: vec![false; cells],
        };
        let past = |element: &Element| Track {
            saturation: element.saturation,
            sliding: element.sliding,
            ..Track::default()
        };
        let step = Step {
            tracks: self.elements.iter().map(past).collect(),
            contact: self.contact,
            law: self.law,
            bound: self.bound,
            known,
            largest: 0.0,
        };
        let goal = (&ForceGoal::default(), &mut { AT_REST });
        let (outcome, moved) = step.solve(newton, p, goal, (limits, watch))?;
        for (k, (element, moved)) in self.elements.iter_mut().zip(moved).enumerate() {
            element.traction = [p[2 * k], p[2 * k + 1]];
            element.saturation = moved.saturation;
            element.sliding = moved.sliding;
            element.track = Places::default();
        }
        Ok(outcome)
    }
}
