//! Shifts: steps in which the wheel does not roll. All material stays where it is, so that every
//! cell slides by the shift minus the change in the elastic displacement there: Cattaneo's and
//! Mindlin's problem, for any patch, elasticity, contact law and history.

use crate::bodies::Kinematics;
use crate::normal::patch::Cell;
use crate::problem::Shift;
use crate::reporting::{Error, Watch};
use crate::solver::rolling::marching::arrival::{Arrival, keep_in_place};
use crate::solver::settings;

use super::March;

/// Speed and creepages of bodies that do not roll.
const AT_REST: Kinematics = Kinematics::free_rolling(0.0);

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
        self.forget_trend();
        self.find_flow(&arrivals, shift, watch)?;
        self.forget_trend();
        for (k, (element, arrival)) in self.elements.iter_mut().zip(arrivals).enumerate() {
            element.heat = arrival.heat;
            element.scaled_rise = self.now.scaled_rise[k];
            element.friction_on_leaving = arrival.friction;
        }
        let shift = std::mem::replace(&mut self.now.over_step, AT_REST);
        (self.now.kinematics, self.powers) = (AT_REST, None);
        self.note(Some([shift.creepage_x, shift.creepage_y, shift.spin]));
        Ok(())
    }

    /// What changes in rolling does not go on in a shift, nor after it.
    fn forget_trend(&mut self) {
        self.forces.forget();
        self.trend.fill(0.0);
    }

    /// Friction is that at the temperature of the material, without slip.
    fn set_friction_at_rest(&mut self, arrivals: &[Arrival]) {
        let interface = &self.problem.interface;
        for (k, (cell, arrival)) in self.contact.patch.cells.iter().zip(arrivals).enumerate() {
            let (conduction, rise) = (&self.now.conduction, self.now.scaled_rise[k]);
            let law = || interface.friction_response(conduction, rise, 0.0, cell.y).coefficient;
            self.now.friction[k] = arrival.friction.unwrap_or_else(law);
        }
    }

    /// The equilibrium with the layer between the surfaces as it flows in the shift, if there is
    /// one: its limit of elasticity and the slip in turn.
    fn find_flow(
        &mut self,
        arrivals: &[Arrival],
        shift: &Shift,
        watch: Watch,
    ) -> Result<(), Error> {
        let Some(layer) = self.problem.interface.layer.filter(|l| l.yield_limit().is_some()) else {
            return self.find_equilibrium(arrivals, true, watch);
        };
        let friction = std::mem::take(&mut self.now.friction);
        let start = self.now.traction.clone();
        let pressures: Vec<f64> =
            self.contact.patch.cells.iter().map(Cell::pressure_where_covered).collect();
        let flow = |k: usize, slip: f64| {
            layer.pass(friction[k] * pressures[k], arrivals[k].plastic_displacement, [slip; 2])
        };
        // A bound that grows takes up some of the slip.
        let compliance = layer.compliance() + self.contact.cell_compliance();
        let share = (1.0 + layer.hardening() * compliance).recip();
        self.now.friction =
            (0..friction.len()).map(|k| flow(k, 0.0).bound / pressures[k]).collect();
        for _ in 0..settings::most_flows() {
            self.now.over_step = *shift;
            self.now.traction.clone_from(&start);
            self.find_equilibrium(arrivals, true, watch)?;
            let mut change = 0.0_f64;
            for (k, (element, arrival)) in self.elements.iter_mut().zip(arrivals).enumerate() {
                let [x, y] = [0, 1].map(|c| element.sliding[c] - arrival.sliding[c]);
                let flow = flow(k, x.hypot(y));
                element.plastic_displacement = flow.left;
                let missing = flow.bound / pressures[k] - self.now.friction[k];
                change = change.max(missing.abs() / friction[k]);
                self.now.friction[k] += share * missing;
            }
            if change <= self.options.tolerance {
                return Ok(());
            }
            self.outcome.residual = self.outcome.residual.max(change);
        }
        Ok(())
    }
}
