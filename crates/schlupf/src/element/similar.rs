//! Contacts that are the same in other units.
//!
//! Patches of one shape, on bodies without a length of their own, differ in size only: with g the
//! unit of length and that of traction the same, the grid and its influences stay. Creepages and
//! speeds stay too, and the pressure matters by its product with friction, so that its unit s is a
//! factor of friction. All laws have lengths in the new unit: spin φ g, k_c g, conductivity λ/g.
//! Forces are g², moments g³ times those found.

use std::sync::Arc;

use crate::interface::Interface;
use crate::interface::friction::{FrictionLaw, FrictionResponse, FrictionState};
use crate::problem::Problem;

/// The contact of a problem under loads for which its grids serve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Similar {
    /// N, in N.
    load: f64,
    exponent: f64,
}

/// Units in which a contact is solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    /// Of lengths, dimensionless.
    pub length: f64,
    /// Of the pressure, dimensionless.
    pub pressure: f64,
}

impl Similar {
    /// `None` if something of the grids does not follow the size of the patch, or if the pressure
    /// does more than to bound the tractions.
    pub fn new(problem: &Problem) -> Option<Self> {
        let exponent = problem.normal.load_exponent()?;
        let Interface { elasticity, layer, .. } = &problem.interface;
        let contact = problem.normal.normal_contact(None).ok()?;
        let has_place = contact.rows.is_some() || contact.summary.origin.is_some();
        let is_free = elasticity.is_scale_free() && layer.is_none() && !has_place;
        let serves = elasticity.pressure_coupling().is_none() && (exponent == 0.0 || is_free);
        serves.then_some(Self { load: contact.summary.load, exponent })
    }

    /// Those in which a load (in N) is that of the problem.
    pub fn units(&self, load: f64) -> Units {
        let ratio = load / self.load;
        let length = ratio.powf(self.exponent);
        Units { length, pressure: ratio / (length * length) }
    }
}

impl Units {
    pub const SAME: Self = Self { length: 1.0, pressure: 1.0 };

    /// What acts at the interface, with a factor of friction (dimensionless).
    pub fn interface(&self, own: &Interface, factor: f64) -> Option<Interface> {
        let mut interface = own.clone();
        let friction = &mut interface.friction;
        let (length, factor) = (self.length, factor * self.pressure);
        friction.law = Arc::new(Scaled { law: Arc::clone(&own.friction.law), factor, length });
        friction.memory = friction.memory.map(|memory| memory.in_unit(length));
        let law = &mut interface.contact_law;
        if let Some(other) = law.with_stiffness(length * law.stiffness()).ok()? {
            *law = other;
        }
        for body in [&mut interface.wheel, &mut interface.rail] {
            body.material.conductivity /= length;
        }
        Some(interface)
    }

    /// Forces and moment over those found, dimensionless.
    pub fn forces(&self) -> [f64; 3] {
        let area = self.length * self.length;
        [area, area, area * self.length]
    }
}

/// A friction law times a factor, which is its constant, with another unit of length.
#[derive(Debug)]
struct Scaled {
    law: Arc<dyn FrictionLaw>,
    factor: f64,
    length: f64,
}

impl FrictionLaw for Scaled {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let found = self.law.respond(&FrictionState { y: self.length * state.y, ..*state });
        FrictionResponse {
            coefficient: self.factor * found.coefficient,
            by_temperature: self.factor * found.by_temperature,
            by_slip_speed: self.factor * found.by_slip_speed,
            by_y: self.factor * self.length * found.by_y,
            by_cold_coefficient: found.coefficient,
        }
    }

    fn is_constant(&self) -> bool {
        self.law.is_constant()
    }

    fn follows_slip_speed(&self) -> bool {
        self.law.follows_slip_speed()
    }

    fn temperature_limit(&self) -> f64 {
        self.law.temperature_limit()
    }
}
