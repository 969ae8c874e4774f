//! Frictional heating and surface temperatures, Eqs. (17)–(22).
//!
//! A material point carries the record of the heat it has received since it entered the contact. At
//! rolling speeds, heat flows perpendicular to the surface only (Knothe and Liebelt 1995), so this
//! record determines the temperature of the point. In slow rolling heat also flows along the
//! surface; then the steady driver solves for the temperatures of the whole patch
//! (`contact_conduction`).

mod constant_source;
mod moving_half_space;
mod partition;
pub(crate) mod contact_conduction;
mod duhamel;
mod peclet;
mod strip_weights;
pub(crate) mod strip_heat;

pub use constant_source::ConstantSource;
pub use duhamel::Duhamel;
pub use partition::{Conduction, Partition, PartitionLaw};
pub use peclet::Peclet;

use std::fmt::Debug;
use std::sync::Arc;

use crate::reporting::{Error, Quantity, Requirement, require};

/// Heat received by a material point in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HeatStep {
    /// Heat flux, both bodies together, in W/m².
    pub flux: f64,
    /// Duration of the step, in s.
    pub duration: f64,
}

/// A model of the temperature of a heated surface. Extension point.
///
/// ```
/// use std::sync::Arc;
///
/// use schlupf::interface::heat::{Heat, HeatModel, HeatStep};
/// use schlupf::{Options, Problem, solver, unwatched};
///
/// /// All heat so far as if it had come at once, halfway back in time: with E in J/m² and t in s,
/// /// β ΔT = E/√(π t/2).
/// #[derive(Debug)]
/// struct Burst;
///
/// impl Burst {
///     fn per_energy(record: &[HeatStep]) -> f64 {
///         let time: f64 = record.iter().map(|step| step.duration).sum();
///         1.0 / (0.5 * std::f64::consts::PI * time).sqrt()
///     }
/// }
///
/// impl HeatModel for Burst {
///     fn rise_times_effusivity(&self, record: &[HeatStep]) -> f64 {
///         let energy: f64 = record.iter().map(|step| step.flux * step.duration).sum();
///         if record.is_empty() { 0.0 } else { energy * Self::per_energy(record) }
///     }
///
///     fn derivatives(&self, record: &[HeatStep], by_flux: &mut [f64]) {
///         for (by_flux, step) in by_flux.iter_mut().zip(record) {
///             *by_flux = step.duration * Self::per_energy(record);
///         }
///     }
///
///     fn is_linear(&self) -> bool {
///         true
///     }
/// }
///
/// let heat = Heat { model: Some(Arc::new(Burst)), ..Heat::default() };
/// let problem = Problem::builder().creepage_x(0.01).heat(heat).build()?;
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let solution = solver::solve(&problem, &options, &unwatched)?;
/// assert!(solution.temperature.is_some_and(|found| found.max_rise > 50.0));
/// # Ok::<(), schlupf::Error>(())
/// ```
pub trait HeatModel: Debug + Send + Sync {
    /// Temperature rise times the effusivity β = √(λρc) (in W √s/m²) of a half-space that received
    /// all the heat in `record`, the latest step first.
    fn rise_times_effusivity(&self, record: &[HeatStep]) -> f64;

    /// Derivatives of the rise with respect to the flux of each step, in √s, in the order of the
    /// record.
    fn derivatives(&self, record: &[HeatStep], by_flux: &mut [f64]);

    /// Whether the derivatives are independent of the fluxes.
    fn is_linear(&self) -> bool;

    /// Whether it is exact conduction perpendicular to the surface, which is replaced by conduction
    /// in all directions where the two differ.
    fn is_conduction(&self) -> bool {
        false
    }
}

/// Whether both are the same model, or both none.
pub(crate) fn is_same(
    one: Option<&Arc<dyn HeatModel>>,
    other: Option<&Arc<dyn HeatModel>>,
) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => Arc::ptr_eq(one, other),
        _ => false,
    }
}

/// How friction heats the bodies.
///
/// ```
/// use schlupf::interface::heat::{Heat, Partition};
///
/// let half = Heat { partition: Partition::Given(0.5), ..Heat::default() };
/// assert!(half.check().is_ok() && Heat::none().model.is_none());
/// ```
#[derive(Debug, Clone)]
pub struct Heat {
    /// The model; `None` leaves the material at its entry temperature.
    pub model: Option<Arc<dyn HeatModel>>,
    /// How the heat is divided between the bodies.
    pub partition: Partition,
}

impl Default for Heat {
    /// Conduction perpendicular to the surface, with equal surface temperatures of both bodies.
    fn default() -> Self {
        Self { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity }
    }
}

impl Heat {
    /// No heating: the material keeps its entry temperature.
    pub fn none() -> Self {
        Self { model: None, ..Self::default() }
    }

    /// Whether model and partition are known to be the same.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.partition == other.partition && is_same(self.model.as_ref(), other.model.as_ref())
    }

    /// Checks the partition.
    pub fn check(&self) -> Result<(), Error> {
        match &self.partition {
            Partition::Velocity | Partition::Law(_) => Ok(()),
            Partition::Given(share) => {
                require(Quantity::HeatPartition, Requirement::Between(0.0, 1.0), *share)
            }
        }
    }

    /// Temperature rise times effusivity of a record, in W √s/m².
    pub fn rise_times_effusivity(&self, record: &[HeatStep]) -> f64 {
        self.model.as_ref().map_or(0.0, |model| model.rise_times_effusivity(record))
    }
}
