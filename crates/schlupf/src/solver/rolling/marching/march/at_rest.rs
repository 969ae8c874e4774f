//! Shifts: steps in which the wheel does not roll. All material stays where it is, so that every
//! cell slides by the shift minus the change in the elastic displacement there: Cattaneo's and
//! Mindlin's problem, for any patch, elasticity, contact law and history.

use crate::bodies::Kinematics;
use crate::problem::Shift;
use crate::reporting::{Error, Watch};
use crate::solver::rolling::marching::arrival::{Arrival, keep_in_place};

use super::March;

/// Speed and creepages of bodies that do not roll.
const AT_REST: Kinematics = Kinematics { speed: 0.0, creepage_x: 0.0, creepage_y: 0.0, spin: 0.0 };

impl March<'_> {
    /// A shift at the first time of the present part of the history, under its load or its forces.
    pub(super) fn shift(&mut self, shift: &Shift, watch: Watch) -> Result<(), Error> {
        let standing = Kinematics { speed: self.problem.kinematics.speed, ..AT_REST };
        self.now.kinematics = AT_REST;
        self.now.over_step = *shift;
        self.now.conduction = self.problem.interface.conduction(&standing);
        let moves = self.follow_load(watch)?.is_some();
        self.stay_in_place();
        let patch = &self.contact.patch;
        let mut before = vec![0.0; 2 * patch.len()];
        self.contact.interpolation.gather(&self.displacement, &mut before);
        self.law.contact.calibration.add_at_cells(&self.now.traction, &mut before);
        let arrivals = keep_in_place(patch, &before, &self.past, moves, &self.elements);
        self.now.friction_power.fill(0.0);
        self.set_friction_at_rest(&arrivals);
        self.forces.forget();
        self.find_equilibrium(&arrivals, true, watch)?;
        self.forces.forget();
        for (k, (element, arrival)) in self.elements.iter_mut().zip(arrivals).enumerate() {
            element.heat = arrival.heat;
            element.scaled_rise = self.now.scaled_rise[k];
            element.friction_on_leaving = arrival.friction;
            element.plastic_displacement = arrival.plastic_displacement;
        }
        let shift = std::mem::replace(&mut self.now.over_step, AT_REST);
        (self.now.kinematics, self.powers) = (AT_REST, None);
        self.note(Some([shift.creepage_x, shift.creepage_y, shift.spin]));
        Ok(())
    }

    /// Friction is that at the temperature of the material, without slip.
    fn set_friction_at_rest(&mut self, arrivals: &[Arrival]) {
        let interface = &self.problem.interface;
        for (k, (cell, arrival)) in self.contact.patch.cells.iter().zip(arrivals).enumerate() {
            let (conduction, rise) = (&self.now.conduction, self.now.scaled_rise[k]);
            let law = || interface.friction_response(conduction, rise, 0.0, cell.y).coefficient;
            let friction = arrival.friction.unwrap_or_else(law);
            let pressure = cell.pressure_where_covered();
            let flow = interface.layer.map(|layer| {
                layer.pass(friction * pressure, arrival.plastic_displacement, [0.0; 2])
            });
            self.now.friction[k] = flow.map_or(friction, |flow| flow.bound / pressure);
        }
    }
}
