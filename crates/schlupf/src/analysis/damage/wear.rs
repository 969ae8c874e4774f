//! Laws of wear.

use super::{State, WearMap};

/// Archard's law (1953): the volume V = k ∫ p s dA/(H v0) is worn from each body per distance
/// rolled, with the pressure p, the slip speed s and the hardness H. With the traction μ p where
/// the bodies slide, ∫ p s dA is the friction power over μ.
///
/// The coefficient k is that of a [`WearMap`] at the slip speed and the pressure: those of a cell
/// in a [passage](super::of_passage); of a run, the mean slip speed of the patch
/// ([`State::slip_speed`]) and its largest pressure.
///
/// Limits: those of the map; over a run, friction that falls below the given μ means more sliding
/// at the same power.
#[derive(Debug, Clone, PartialEq)]
pub struct ArchardWear {
    /// Hardness H of the softer body, in Pa.
    pub hardness: f64,
    /// The coefficients.
    pub map: WearMap,
}

impl Default for ArchardWear {
    /// The map of Jendel (2002), and the hardness of rail steel R260, some 275 HB.
    fn default() -> Self {
        Self { hardness: 2.7e9, map: WearMap::default() }
    }
}

impl ArchardWear {
    /// The coefficient (dimensionless) for a slip speed (in m/s) and a pressure (in Pa).
    pub fn coefficient(&self, slip_speed: f64, pressure: f64) -> f64 {
        self.map.coefficient(slip_speed, pressure / self.hardness)
    }

    /// Depth worn per time in m/s, k p s/H, for a slip speed s (in m/s) and a pressure (in Pa).
    pub fn rate(&self, slip_speed: f64, pressure: f64) -> f64 {
        self.coefficient(slip_speed, pressure) * pressure * slip_speed / self.hardness
    }

    /// Volume worn from each body per distance rolled, in m².
    pub fn volume(&self, state: &State) -> f64 {
        let slip_speed = state.slip_speed();
        let coefficient = self.coefficient(slip_speed, state.peak_pressure);
        coefficient * state.load * slip_speed / (self.hardness * state.speed)
    }
}

/// Wear by the energy dissipated per area of contact and distance rolled, e = P/(v0 A), in the
/// form of Braghin, Lewis, Dwyer-Joyce and Bruni (2006) for a wheel of R8T on a rail of UIC 900A,
/// dry, from twin-disc tests: the mass worn per area and distance is
///
/// - c e, with c = 5.3 µg/(N m), up to e = 10.4 N/mm²: mild;
/// - constant up to 77.2 N/mm²: severe;
/// - rising beyond by 61.9 µg/(N m): catastrophic.
///
/// Over a run the mean over the patch enters, in a [passage](super::of_passage) the energy of each
/// cell.
///
/// Limits: dry; all frictional energy enters, that of spin included; the tests gave means over
/// their patch only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyWear {
    /// Mass per energy of mild wear, in kg/J.
    pub mild: f64,
    /// Mass per energy beyond severe wear, in kg/J.
    pub catastrophic: f64,
}

impl Default for EnergyWear {
    fn default() -> Self {
        Self { mild: 5.3e-9, catastrophic: 61.9e-9 }
    }
}

impl EnergyWear {
    /// Energies per area and distance between which wear is severe, in J/m³, which is Pa.
    pub const SEVERE: [f64; 2] = [10.4e6, 77.2e6];

    /// Mass worn per area and distance, in kg/m³, for an energy per area and distance, in Pa.
    pub fn rate(&self, energy: f64) -> f64 {
        let [low, high] = Self::SEVERE;
        self.mild * energy.min(low) + self.catastrophic * (energy - high).max(0.0)
    }

    /// Mass worn from each body per distance rolled, in kg/m.
    pub fn mass(&self, state: &State) -> f64 {
        let energy = state.energy_per_distance() / state.contact_area;
        self.rate(energy.max(0.0)) * state.contact_area
    }
}

/// What a run wears away.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct WearTotal {
    /// Mass worn from the wheel over the run, in kg.
    pub wheel_mass: f64,
    /// Mass worn from the rail by one passing wheel, mean over the run, in kg/m.
    pub rail_mass_per_length: f64,
    /// Volume worn from the wheel over the run, in m³.
    pub wheel_volume: f64,
}

impl WearTotal {
    /// From the volume over a distance, in m³ and m.
    pub(super) fn of_volumes(volume: f64, distance: f64, densities: [f64; 2]) -> Self {
        Self {
            wheel_mass: volume * densities[0],
            rail_mass_per_length: volume * densities[1] / distance,
            wheel_volume: volume,
        }
    }

    /// From the mass over a distance, in kg and m.
    pub(super) fn of_masses(mass: f64, distance: f64, densities: [f64; 2]) -> Self {
        Self {
            wheel_mass: mass,
            rail_mass_per_length: mass / distance,
            wheel_volume: mass / densities[0],
        }
    }
}
