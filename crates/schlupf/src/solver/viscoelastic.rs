//! The pressure of viscoelastic bodies in steady rolling.
//!
//! Their displacement under pressure is not symmetric, and there is no energy to be minimised. It
//! is split into that of elastic bodies and a remainder S': the pressure is that of the elastic
//! bodies whose surfaces S' p moves apart, again and again. With the mean of instantaneous and
//! relaxed compliance ([`ViscoelasticHalfSpace::mean_modulus`]) S' is at most f/(2 + f) of the
//! elastic part, wave by wave, and the constraints do not enlarge a difference: an iteration
//! reduces the error at least by that factor. Anderson mixing makes it faster.
//!
//! The first cells are around the contact of the instantaneous bodies. Where the pressure reaches
//! their edge, others around the contact so far take their place.

use std::sync::Arc;

use crate::elasticity::ViscoelasticHalfSpace;
use crate::normal::{Opened, PressureSource};
use crate::numerics::anderson::Anderson;
use crate::problem::Problem;
use crate::reporting::{Error, Quantity, Watch};

/// Largest change of the displacement over the approach at which the pressure is found.
const TOLERANCE: f64 = 1e-6;

/// Iterations after which the search is given up.
const MOST_PRESSURES: usize = 300;

/// The problem of viscoelastic bodies at its speed, with their pressure; one that is given stays.
/// `None` for elastic bodies. Solvers do this on their own.
///
/// # Errors
/// A contact that is not found, and [`Error::Stopped`].
pub fn viscoelastic_rolling(problem: &Problem, watch: Watch) -> Result<Option<Problem>, Error> {
    let Some(bodies) = problem.interface.elasticity.viscoelastic() else { return Ok(None) };
    problem.check()?;
    problem.normal.prepare(None, watch)?;
    let bodies = bodies.at_speed(problem.kinematics.speed);
    let mut problem = problem.clone();
    if let Some((opened, _)) = pressed(&problem.normal, &bodies, watch)? {
        problem.normal = Arc::new(opened);
    }
    problem.interface.elasticity = Arc::new(bodies);
    Ok(Some(problem))
}

/// The last pressure of viscoelastic bodies: it follows from their contact and their speed.
#[derive(Default)]
pub(crate) struct LastPressure {
    /// The problem that was given, and that at its speed.
    last: Option<[Problem; 2]>,
}

impl LastPressure {
    /// [`viscoelastic_rolling`] with the last pressure, if it is that of the problem.
    pub fn rolling(&mut self, problem: &Problem, watch: Watch) -> Result<Option<Problem>, Error> {
        let is_same = |given: &Problem| {
            Arc::ptr_eq(&given.normal, &problem.normal)
                && Arc::ptr_eq(&given.interface.elasticity, &problem.interface.elasticity)
                && given.kinematics.speed == problem.kinematics.speed
        };
        let Some([_, last]) = self.last.as_ref().filter(|[given, _]| is_same(given)) else {
            let found = viscoelastic_rolling(problem, watch)?;
            self.last = found.clone().map(|found| [problem.clone(), found]);
            return Ok(found);
        };
        let mut rolling = problem.clone();
        rolling.normal = Arc::clone(&last.normal);
        rolling.interface.elasticity = Arc::clone(&last.interface.elasticity);
        Ok(Some(rolling))
    }
}

/// The contact on cells around it, and the pressures on the way to it; `None` if the undeformed
/// distance is not known.
fn pressed(
    source: &Arc<dyn PressureSource>,
    bodies: &ViscoelasticHalfSpace,
    watch: Watch,
) -> Result<Option<(Opened, usize)>, Error> {
    let Some(mut opened) = Opened::around(source)? else { return Ok(None) };
    let modulus = bodies.mean_modulus();
    let (mut is_around, mut iterations) = (false, 0);
    loop {
        let mut remainder = bodies.normal_remainder(&opened.cells().grid)?;
        let mut mixing = Anderson::default();
        let mut opening = remainder.under(opened.pressure());
        loop {
            iterations += 1;
            opened = opened.up_to_edge(&opening, modulus, watch)?;
            let next = remainder.under(opened.pressure());
            let residual = opened.change([&opening, &next]);
            if iterations > MOST_PRESSURES {
                let (quantity, tolerance) = (Quantity::Elasticity, TOLERANCE);
                return Err(Error::NormalNotConverged {
                    quantity,
                    iterations,
                    residual,
                    tolerance,
                });
            }
            if opened.touches_edge() {
                is_around = false;
                break;
            }
            if residual <= TOLERANCE {
                if is_around {
                    opened.refuse_unknown_distance()?;
                    return Ok(Some((opened, iterations)));
                }
                is_around = true;
                break;
            }
            opening = mixing.next(&opening, &next);
        }
        opened = opened.on_cells_around();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::{Material, contact_modulus};
    use crate::elasticity::StandardLinearSolid;
    use crate::normal::Line;
    use crate::reporting::unwatched;

    #[test]
    fn few_pressures_of_soft_bodies() {
        let rubber = Material { young_modulus: 1e9, poisson_ratio: 0.4, ..Material::STEEL };
        let modulus = contact_modulus(&rubber, &rubber);
        let line: Arc<dyn PressureSource> =
            Arc::new(Line::new([0.1, 0.1], 0.1, modulus, 20e3).unwrap());
        for (ratio, most) in [(1.0, 20), (12.0, 150)] {
            for length in [0.0, 1e-3, 1e-2, 3e-2, 1.0] {
                let solid = StandardLinearSolid {
                    relaxed_modulus: rubber.young_modulus / (1.0 + ratio),
                    retardation_time: length,
                };
                let bodies = ViscoelasticHalfSpace::new([&rubber; 2], [solid; 2]).unwrap();
                let (_, count) =
                    pressed(&line, &bodies.at_speed(1.0), &unwatched).unwrap().unwrap();
                assert!(count <= most, "{count} pressures for f = {ratio}, L = {length} m");
            }
        }
    }
}
