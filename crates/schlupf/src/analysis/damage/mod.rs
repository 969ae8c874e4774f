//! Damage of wheel and rail: dissipated energy, fatigue and wear, of one passage and over a run.
//!
//! [`of_passage`] takes the cells of a steady solution: wear rates in each, depths across the
//! profile, the surface-fatigue index and the place in the shakedown map ([`ShakedownLimits`]),
//! cracks by the wear number ([`CrackFunction`]), and what melts.
//!
//! [`of_run`] takes a run, which is a series of steady states, each with the distance over which it
//! holds; of every state only the resultants are needed. Sums over the distance s are
//!
//! - the energy E = ∫ P/v0 ds of the friction power P;
//! - the wear number Tγ = |ξ Fx| + |η Fy|, its mean and its distribution;
//! - the surface-fatigue index of every state ([`SurfaceFatigue`]) and the part of the run in which
//!   it is positive; the damage by cracks;
//! - the depth of wear across the profile ([`Profile`]) by two laws: [`ArchardWear`] and
//!   [`EnergyWear`].
//!
//! Limits: within a state of a run wear is distributed across the patch as the load is,
//! (1 − (y/b)²) over its width 2b, as if all of it slid; wear does not change the profiles; fatigue
//! and wear do not compete.

mod cracks;
mod fatigue;
mod histogram;
mod shakedown;
mod passage;
mod profile;
mod wear_map;
mod wear;
mod columns;

use crate::reporting::{Error, Quantity, require_finite, require_positive};

pub use cracks::CrackFunction;
pub use fatigue::{FatigueSummary, SurfaceFatigue};
pub use histogram::Histogram;
pub use passage::{
    Melting, Passage, PassageProfile, PassageWear, ShakedownPoint, WearCells, of_passage,
};
pub use profile::Profile;
pub use shakedown::ShakedownLimits;
pub use wear::{ArchardWear, EnergyWear, WearTotal};
pub use wear_map::WearMap;

/// A state of a run: the resultants of a steady rolling contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Distance over which it holds, in m.
    pub distance: f64,
    /// Its middle, in m from the start of the run.
    pub middle: f64,
    /// Speed of the vehicle v0, in m/s.
    pub speed: f64,
    /// Position of the centre of the patch across the profile of the wheel, in m.
    pub position_y: f64,
    /// The same across that of the rail, in m.
    pub rail_position_y: f64,
    /// Whether it is another contact of the wheel in the state before, over the same distance.
    pub is_further_contact: bool,
    /// Normal load N, in N; zero where the wheel does not touch the rail, and all that follows from
    /// it is of no matter.
    pub load: f64,
    /// Half the length a of the patch, in m.
    pub semi_axis_x: f64,
    /// Half the width b of the patch, in m.
    pub semi_axis_y: f64,
    /// Largest pressure p0, in Pa.
    pub peak_pressure: f64,
    /// Area of contact A, in m².
    pub contact_area: f64,
    /// Tangential force T = |F|, in N.
    pub tangential_force: f64,
    /// Wear number Tγ without spin, in N.
    pub t_gamma: f64,
    /// Friction power P, in W.
    pub friction_power: f64,
    /// Coefficient of friction μ that bounds the tractions, dimensionless.
    pub friction_coefficient: f64,
}

impl State {
    /// Frictional energy per distance rolled, P/v0, in N.
    pub fn energy_per_distance(&self) -> f64 {
        self.friction_power / self.speed
    }

    /// Mean slip speed, weighted by the pressure, in m/s: P/(μ N), because the traction is μ p
    /// where a body slides.
    pub fn slip_speed(&self) -> f64 {
        self.friction_power / (self.friction_coefficient * self.load)
    }

    /// Distance that it adds to the run, in m.
    fn way(&self) -> f64 {
        if self.is_further_contact { 0.0 } else { self.distance }
    }

    fn check(&self) -> Result<(), Error> {
        require_positive(Quantity::Distance, self.distance)?;
        require_positive(Quantity::Speed, self.speed)?;
        require_finite(Quantity::Distance, self.middle)?;
        if self.load == 0.0 {
            return Ok(());
        }
        let positive = [
            (Quantity::Load, self.load),
            (Quantity::SemiAxisX, self.semi_axis_x),
            (Quantity::SemiAxisY, self.semi_axis_y),
            (Quantity::PeakPressure, self.peak_pressure),
            (Quantity::ContactArea, self.contact_area),
            (Quantity::FrictionCoefficient, self.friction_coefficient),
        ];
        let finite = [
            (Quantity::Y, self.position_y),
            (Quantity::Y, self.rail_position_y),
            (Quantity::ForceRatio, self.tangential_force),
            (Quantity::WearNumber, self.t_gamma),
            (Quantity::FrictionPower, self.friction_power),
        ];
        positive.into_iter().try_for_each(|(quantity, value)| require_positive(quantity, value))?;
        finite.into_iter().try_for_each(|(quantity, value)| require_finite(quantity, value))
    }
}

/// What turns rolling into damage.
#[derive(Debug, Clone, PartialEq)]
pub struct Laws {
    /// Fatigue of the surface.
    pub fatigue: SurfaceFatigue,
    /// Cracks by the wear number.
    pub cracks: CrackFunction,
    /// Wear by sliding distance and load.
    pub archard: ArchardWear,
    /// Wear by dissipated energy.
    pub energy: EnergyWear,
    /// Rolling radius of the wheel, in m.
    pub wheel_radius: f64,
    /// Densities of wheel and rail, in kg/m³.
    pub densities: [f64; 2],
    /// Temperature from which on the surfaces melt, in degC.
    pub melting_temperature: f64,
}

impl Default for Laws {
    /// The defaults of all laws, a wheel of 460 mm, steel; it melts at 1390 °C, the solidus of iron
    /// with 0.75 % of carbon on the line from 1493 °C at 0.17 % to 1147 °C at 2.1 %.
    fn default() -> Self {
        Self {
            fatigue: SurfaceFatigue::default(),
            cracks: CrackFunction::default(),
            archard: ArchardWear::default(),
            energy: EnergyWear::default(),
            wheel_radius: 0.46,
            densities: [7850.0; 2],
            melting_temperature: 1390.0,
        }
    }
}

impl Laws {
    /// Checks all constants.
    ///
    /// # Errors
    /// The first that is not positive and finite.
    pub fn check(&self) -> Result<(), Error> {
        require_positive(Quantity::ShearYieldStress, self.fatigue.shear_yield_stress)?;
        let Self { archard, energy, .. } = self;
        let constants = [
            (Quantity::WearHardness, archard.hardness),
            (Quantity::WearRateMild, energy.mild),
            (Quantity::WearRateCatastrophic, energy.catastrophic),
        ];
        constants
            .into_iter()
            .try_for_each(|(quantity, value)| require_positive(quantity, value))?;
        require_finite(Quantity::MeltingTemperature, self.melting_temperature)?;
        require_positive(Quantity::WheelRadiusX, self.wheel_radius)?;
        require_positive(Quantity::WheelDensity, self.densities[0])?;
        require_positive(Quantity::RailDensity, self.densities[1])
    }
}

/// The damage of a run.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RunDamage {
    /// Number of states.
    pub states: usize,
    /// Distance rolled, in m.
    pub distance: f64,
    /// Time that it took, in s.
    pub duration: f64,
    /// Energy dissipated by friction, in J.
    pub energy: f64,
    /// The wear number Tγ without spin.
    pub t_gamma: WearNumberSummary,
    /// Fatigue of the surface.
    pub fatigue: FatigueSummary,
    /// Damage by cracks of one passing wheel.
    pub cracks: CrackSummary,
    /// Wear by Archard's law.
    pub archard: WearTotal,
    /// Wear by energy.
    pub energy_wear: WearTotal,
    /// Parts of the distance by the wear number, the fatigue index and the mean slip speed.
    pub histograms: Vec<Histogram>,
    /// Depth of wear across the profile.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub profile: Profile,
    /// The run, a point for each state.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub points: Vec<RunPoint>,
}

/// Sums of the wear number Tγ.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct WearNumberSummary {
    /// ∫ Tγ ds, in J.
    pub sum: f64,
    /// Mean over the distance, in N.
    pub mean: f64,
    /// Largest value, in N.
    pub max: f64,
}

/// Damage by cracks over a run: see [`CrackFunction`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CrackSummary {
    /// Largest damage of a passage, dimensionless.
    pub max: f64,
    /// Mean over the distance, dimensionless; negative where wear prevails.
    pub mean: f64,
}

/// A state of a run with what it does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunPoint {
    /// Distance at the middle of the state, in m, from the start of the run.
    pub distance: f64,
    /// Position of the patch across the profile of the wheel, in m.
    pub position_y: f64,
    /// Wear number Tγ without spin, in N.
    pub t_gamma: f64,
    /// Surface-fatigue index, dimensionless.
    pub fatigue_index: f64,
    /// Damage by cracks of one passing wheel, dimensionless.
    pub crack_damage: f64,
    /// Energy dissipated up to the end of the state, in J.
    pub energy: f64,
    /// Volume worn from each body by Archard's law, per distance rolled, in m².
    pub archard_wear: f64,
    /// Mass worn from each body by energy, per distance rolled, in kg/m.
    pub energy_wear: f64,
}

/// The damage of a run.
///
/// ```
/// use schlupf::analysis::damage::{Laws, State, of_run};
///
/// let state = State {
///     distance: 1000.0,
///     middle: 500.0,
///     speed: 20.0,
///     position_y: 0.0,
///     rail_position_y: 0.0,
///     is_further_contact: false,
///     load: 80e3,
///     semi_axis_x: 6e-3,
///     semi_axis_y: 4e-3,
///     peak_pressure: 1.6e9,
///     contact_area: 7.5e-5,
///     tangential_force: 20e3,
///     t_gamma: 40.0,
///     friction_power: 800.0,
///     friction_coefficient: 0.4,
/// };
/// let damage = of_run(&[state; 3], &Laws::default())?;
/// assert_eq!((damage.distance, damage.energy), (3000.0, 120e3));
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// Sums are over all contacts. Where a wheel has several, the fatigue of a place of the run is that
/// of the contact with the largest index.
///
/// # Errors
/// No state, and numbers that are not positive or not finite.
pub fn of_run(states: &[State], laws: &Laws) -> Result<RunDamage, Error> {
    laws.check()?;
    if states.is_empty() {
        return Err(Error::TooFew { quantity: Quantity::Distance, fewest: 1, count: 0 });
    }
    states.iter().try_for_each(State::check)?;
    let count = states.iter().filter(|state| !state.is_further_contact).count();
    let distance: f64 = states.iter().map(State::way).sum();
    let duration = states.iter().map(|state| state.way() / state.speed).sum();
    let states: &[State] =
        &states.iter().filter(|state| state.load > 0.0).copied().collect::<Vec<_>>();
    let points = points(states, laws);
    let sum = |value: &dyn Fn(&State) -> f64| -> f64 {
        states.iter().map(|state| value(state) * state.distance).sum()
    };
    let t_gamma = sum(&|state| state.t_gamma);
    let largest = states.iter().map(|state| state.t_gamma).fold(f64::NEG_INFINITY, f64::max);
    let each = states.iter().zip(&points);
    let cracks = CrackSummary {
        max: points.iter().map(|point| point.crack_damage).fold(f64::NEG_INFINITY, f64::max),
        mean: each.map(|(s, point)| point.crack_damage * s.distance).sum::<f64>() / distance,
    };
    let archard: Vec<f64> = points.iter().map(|point| point.archard_wear).collect();
    let by_energy: Vec<f64> = points.iter().map(|point| point.energy_wear).collect();
    let total = |values: &[f64]| -> f64 {
        states.iter().zip(values).map(|(state, value)| value * state.distance).sum()
    };
    Ok(RunDamage {
        states: count,
        distance,
        duration,
        energy: sum(&State::energy_per_distance),
        t_gamma: WearNumberSummary { sum: t_gamma, mean: t_gamma / distance, max: largest },
        fatigue: FatigueSummary::of(states, &points, distance),
        cracks,
        archard: WearTotal::of_volumes(total(&archard), distance, laws.densities),
        energy_wear: WearTotal::of_masses(total(&by_energy), distance, laws.densities),
        histograms: histograms(states, &points),
        profile: Profile::of(states, &points, laws, distance),
        points,
    })
}

fn points(states: &[State], laws: &Laws) -> Vec<RunPoint> {
    let mut energy = 0.0;
    let point = |state: &State| {
        energy += state.energy_per_distance() * state.distance;
        RunPoint {
            distance: state.middle,
            position_y: state.position_y,
            t_gamma: state.t_gamma,
            fatigue_index: laws.fatigue.index(state),
            crack_damage: laws.cracks.of(state.t_gamma),
            energy,
            archard_wear: laws.archard.volume(state),
            energy_wear: laws.energy.mass(state),
        }
    };
    states.iter().map(point).collect()
}

fn histograms(states: &[State], points: &[RunPoint]) -> Vec<Histogram> {
    let weights: Vec<f64> = states.iter().map(|state| state.distance).collect();
    let of = |quantity, values: Vec<f64>| Histogram::of(quantity, &values, &weights);
    vec![
        of(Quantity::WearNumber, points.iter().map(|point| point.t_gamma).collect()),
        of(Quantity::FatigueIndex, points.iter().map(|point| point.fatigue_index).collect()),
        of(Quantity::SlipSpeed, states.iter().map(State::slip_speed).collect()),
    ]
}
