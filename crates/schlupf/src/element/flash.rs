//! The largest flash temperature of a contact.

use std::f64::consts::PI;

use crate::bodies::Kinematics;
use crate::interface::Interface;
use crate::numerics::dual::Number;

/// max ∫ √((1 − s²)/(ξ − s)) ds from −1 to ξ, at ξ = 0.652; dimensionless.
const LARGEST: f64 = 2.188_306_674;

/// How bodies heat up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flash {
    /// Rise of the hotter surface over the rise times effusivity, in m² √s K/W.
    factor: f64,
}

impl Flash {
    /// `None` without a model of heat.
    pub fn new(interface: &Interface) -> Option<Self> {
        interface.heat.model.as_ref()?;
        let conduction = interface.conduction(&Kinematics::free_rolling(1.0));
        let [cold, hot] = [0.0, 1.0].map(|rise| conduction.surface_temperatures(rise));
        Some(Self { factor: (hot[0] - cold[0]).max(hot[1] - cold[1]) })
    }

    /// Largest temperature rise (in K) where the heat of friction (in W) is spread as the pressure
    /// of an ellipse with semi-axes a and b (in m), which both bodies pass at a speed V (in m/s):
    ///
    /// β ΔT = 2.188 q₀ √(a/(πV)), q₀ = 3P/(2πab),
    ///
    /// with the effusivity β, of the hotter surface under the problem's partition of heat: heat
    /// flows perpendicular to the surface only (Carslaw and Jaeger 1959, section 2.9), which fast
    /// rolling makes it do. Exact in sliding under Coulomb's law, but for the difference of the
    /// surfaces' speeds: of equal bodies it is 3.5 % too low at a creepage of 1.
    pub fn max_rise<T: Number>(self, power: T, ([a, b], speed): ([T; 2], T)) -> T {
        if power.value() <= 0.0 {
            return T::from(0.0);
        }
        let heated = b * (a * speed).sqrt();
        power / heated * (1.5 * LARGEST / (PI * PI.sqrt()) * self.factor)
    }
}
