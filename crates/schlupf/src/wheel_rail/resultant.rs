//! A wheel as a whole: what all its contacts together do.

use super::wheel::{Contact, WheelSolution};
use crate::bodies::Kinematics;
use crate::solution::{
    Area, Fields, Instant, Power, Resultant, Solution, TGamma, Temperature, Work,
};

impl WheelSolution {
    /// Creepage of the nominal rolling radius R (in m) at a speed v0 (in m/s), 1 − ωR/v0,
    /// dimensionless.
    pub fn creepage(&self, radius: f64, speed: f64) -> f64 {
        1.0 - self.angular_velocity * radius / speed
    }

    /// The wheel as one state with `kinematics`, those of its nominal radius: forces in the track
    /// frame, without a moment; the traction coefficient is |F_x| over the vertical force, and
    /// powers, areas and Tγ are sums over the contacts. Sizes are those of the contact with the
    /// largest normal force, temperatures those of the hottest; there are no fields. `None`
    /// without contacts.
    pub fn resultant(&self, kinematics: Kinematics) -> Option<Solution> {
        let main = self.contacts.first()?;
        let limit = main.problem.interface.friction.cold_coefficient() * self.force[2];
        let [x, y, load] = self.force;
        let mut normal = main.solution.normal;
        normal.load = load;
        let residuals = self.contacts.iter().map(|contact| contact.solution.residual);
        let residual = residuals.fold(0.0, f64::max);
        Some(Solution {
            status: self.status(),
            residual,
            normal,
            kinematics,
            force: Resultant { x, y, moment_z: None },
            normalised: Resultant { x: x / limit, y: y / limit, moment_z: None },
            traction_coefficient: x.abs() / load,
            power: self.power(),
            t_gamma: self.t_gamma(),
            temperature: self.hottest(),
            area: self.area(),
            fields: Fields::default(),
            warnings: main
                .solution
                .warnings
                .iter()
                .cloned()
                .chain(self.further_warnings())
                .collect(),
            sensitivity: None,
            extrapolation: None,
            work: self.work(),
            ..main.solution.clone()
        })
    }

    fn sum(&self, part: impl Fn(&Solution) -> Option<f64>) -> Option<f64> {
        self.contacts.iter().map(|contact: &Contact| part(&contact.solution)).sum()
    }

    fn power(&self) -> Option<Power> {
        let sum = |part: fn(&Power) -> f64| self.sum(|solution| solution.power.as_ref().map(part));
        Some(Power {
            friction: sum(|power| power.friction)?,
            creep: sum(|power| power.creep)?,
            returned: sum(|power| power.returned)?,
            into_wheel: sum(|power| power.into_wheel)?,
            into_rail: sum(|power| power.into_rail)?,
            exchanged: self.sum(|solution| solution.power?.exchanged),
        })
    }

    fn t_gamma(&self) -> TGamma {
        let without_spin = self.sum(|solution| Some(solution.t_gamma.without_spin));
        TGamma {
            without_spin: without_spin.unwrap_or_default(),
            with_spin: self.sum(|solution| solution.t_gamma.with_spin),
            rows: [0.0; 2],
        }
    }

    fn area(&self) -> Area {
        Area {
            contact: self.sum(|solution| Some(solution.area.contact)).unwrap_or_default(),
            stick: self.sum(|solution| solution.area.stick),
            slip: self.sum(|solution| solution.area.slip),
        }
    }

    fn hottest(&self) -> Option<Temperature> {
        let each = self.contacts.iter().filter_map(|contact| contact.solution.temperature);
        each.max_by(|one, other| one.max_rise.total_cmp(&other.max_rise))
    }

    fn work(&self) -> Work {
        let mut sum = Work::default();
        let mut cells = 0;
        for Contact { solution, .. } in &self.contacts {
            sum.add(&solution.work);
            cells += solution.work.cells;
        }
        Work { cells, ..sum }
    }
}

/// The last step of a wheel at a time (in s) and after a distance, in m: forces and load in the
/// track, sums of powers and energies; creepages, or the shift, are those of the contact with the
/// largest normal force. `None` without contacts.
pub(super) fn instant(wheel: &WheelSolution, [time, distance]: [f64; 2]) -> Option<Instant> {
    let last = |contact: &Contact| contact.solution.history.last().copied();
    let instants = wheel.contacts.iter().map(last).collect::<Option<Vec<Instant>>>()?;
    let main = *instants.first()?;
    let sum = |part: fn(&Instant) -> Option<f64>| instants.iter().map(part).sum::<Option<f64>>();
    let [x, y, load] = wheel.force;
    Some(Instant {
        time,
        distance,
        load,
        force: Resultant { x, y, moment_z: None },
        friction_power: sum(|instant| instant.friction_power),
        creep_power: sum(|instant| instant.creep_power),
        stored_energy: sum(|instant| instant.stored_energy),
        max_rise: instants.iter().filter_map(|instant| instant.max_rise).reduce(f64::max),
        newton_iterations: instants.iter().map(|instant| instant.newton_iterations).sum(),
        residual: instants.iter().map(|instant| instant.residual).fold(0.0, f64::max),
        ..main
    })
}
