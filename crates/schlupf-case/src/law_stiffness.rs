//! The stiffness k_c of the contact law, and where it comes from.

use std::ops::RangeInclusive;
use std::sync::Arc;

use schlupf::Problem;
use schlupf::interface::roughness::MicroModelResult;
use schlupf::surface::spectrum::RadialSpectrum;

use crate::notice::Notice;
use crate::surface::SurfaceSource;

/// The stiffness k_c of the contact law, and where it comes from.
#[derive(Debug, Clone)]
pub struct LawStiffness {
    /// k_c, in 1/m.
    pub stiffness: f64,
    /// Where it comes from.
    pub origin: StiffnessOrigin,
}

/// Where k_c comes from.
#[derive(Debug, Clone)]
pub enum StiffnessOrigin {
    /// `contact_law.stiffness`.
    Given,
    /// The default.
    Default,
    /// k_c = 2(1 − ν)/(μ0 (2 − ν) γ h_rms).
    ClosedForm {
        /// h_rms of both surfaces together, in m.
        rms_height: f64,
        /// γ, dimensionless.
        slope_factor: f64,
    },
    /// The micro model of a rough surface.
    MicroModel(Arc<MicroContact>),
}

/// A micro model that was solved, kept for cases with the same surface and bodies.
#[derive(Debug, Clone)]
pub struct MicroContact {
    /// What its normal contact depends on.
    pub key: MicroKey,
    /// What it found.
    pub result: MicroModelResult,
    /// Number of its cells.
    pub cells: usize,
    /// Spectrum of the surface.
    pub spectrum: Arc<RadialSpectrum>,
    /// What the reader should know about the surface.
    pub notices: Vec<Notice>,
}

/// What the normal contact of a micro model depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct MicroKey {
    /// Where the surface comes from.
    pub source: SurfaceSource,
    /// Contact modulus E*, in Pa.
    pub contact_modulus: f64,
    /// Hardness, in Pa.
    pub hardness: f64,
    /// Largest mean pressure, in Pa.
    pub largest_pressure: f64,
}

/// A notice is given where the exponential misses μp by more than this part of it (root mean
/// square), and where k_c changes with the pressure by more than this part of it; dimensionless.
const NOTICEABLE_ERROR: f64 = 0.05;
const NOTICEABLE_SPREAD: f64 = 0.2;

/// Number of cells in contact below which the shape of the spots is not resolved: at the largest
/// and at the smallest pressure.
const FEWEST_CELLS: f64 = 200.0;
const FEWEST_CELLS_AT_LEAST: f64 = 30.0;

/// A notice is given where more than this part of the variance lies in waves longer than the
/// contact, dimensionless: k_c, ∝ 1/h_rms, would be 1/√(1 − 0.1), some 5 % larger without them.
const MOST_IN_WAVINESS: f64 = 0.1;

/// Heights of rough surfaces in contact, in m; others are in a wrong unit.
const USUAL_HEIGHTS: RangeInclusive<f64> = 1e-9..=1e-4;

impl LawStiffness {
    /// Whether it follows from a roughness, and so changes with the coefficient of friction.
    pub fn is_from_roughness(&self) -> bool {
        matches!(self.origin, StiffnessOrigin::ClosedForm { .. } | StiffnessOrigin::MicroModel(_))
    }

    /// What is doubtful about it.
    pub fn caveats(&self) -> Vec<Notice> {
        match &self.origin {
            StiffnessOrigin::Given | StiffnessOrigin::Default => Vec::new(),
            StiffnessOrigin::MicroModel(micro) => micro.caveats(),
            StiffnessOrigin::ClosedForm { rms_height, .. }
                if USUAL_HEIGHTS.contains(rms_height) =>
            {
                Vec::new()
            }
            StiffnessOrigin::ClosedForm { rms_height, .. } => {
                vec![Notice::UnusualHeight { rms_height: *rms_height }]
            }
        }
    }

    /// Whether waves longer than the contact of a problem, in the direction of rolling, matter.
    pub fn waviness(&self, problem: &Problem) -> Result<Option<Notice>, schlupf::Error> {
        let StiffnessOrigin::MicroModel(micro) = &self.origin else { return Ok(None) };
        let contact = problem.normal.normal_contact(None)?.summary;
        let length = 2.0 * contact.semi_axis_x;
        let share = micro.spectrum.share_of_longer(length);
        Ok((share > MOST_IN_WAVINESS).then_some(Notice::LongWaves { share, length }))
    }
}

impl MicroContact {
    /// Whether its normal contact serves another request, too: the same, and solved far enough
    /// down.
    pub fn serves(&self, key: &MicroKey, mean_pressures: &[f64]) -> bool {
        self.key == *key && self.result.covers(mean_pressures)
    }

    /// Where Eq. (8) with one k_c is not what the micro model finds.
    pub fn caveats(&self) -> Vec<Notice> {
        let caveats = caveats(&self.result, self.cells, &self.key);
        caveats.into_iter().chain(self.notices.iter().cloned()).collect()
    }
}

/// Mean pressure in elastic spots over E* from which on hard steel, too, yields; dimensionless.
const YIELDING: f64 = 0.03;

/// Elastic spots that carry more than any steel does.
fn yielding(result: &MicroModelResult, key: &MicroKey) -> Option<Notice> {
    let mean = result.normal.mean_spot_pressure(key.largest_pressure);
    let is_beyond = key.hardness.is_infinite() && mean > YIELDING * key.contact_modulus;
    let mean_pressure = key.largest_pressure;
    is_beyond.then_some(Notice::YieldingSpots { in_spots: mean, mean_pressure })
}

/// Where Eq. (8) with one k_c is not what a micro model of so many cells finds, or that is
/// doubtful.
pub fn caveats(result: &MicroModelResult, cells: usize, key: &MicroKey) -> Vec<Notice> {
    let mut caveats = Vec::from_iter(yielding(result, key));
    let stiffness = &result.stiffness;
    let [least, largest] = extremes(stiffness.mean_pressures.iter().copied());
    let in_contact = |pressure: f64| result.normal.contact_fraction(pressure) * cells as f64;
    let few = [(largest, FEWEST_CELLS, "largest"), (least, FEWEST_CELLS_AT_LEAST, "smallest")];
    let few = few.into_iter().map(|(pressure, fewest, at)| (in_contact(pressure), fewest, at));
    if let Some((cells, _, at)) = few.into_iter().find(|(cells, fewest, _)| cells < fewest) {
        caveats.push(Notice::FewCellsInContact { cells, at });
    }
    let root_mean_square_error = stiffness.common.root_mean_square_error;
    if root_mean_square_error > NOTICEABLE_ERROR {
        let largest_error = stiffness.common.largest_error;
        caveats.push(Notice::NotExponential { root_mean_square_error, largest_error });
    }
    if stiffness.spread > NOTICEABLE_SPREAD {
        let range = extremes(stiffness.fits.iter().map(|fit| fit.stiffness));
        let mean_pressure = [least, largest];
        caveats.push(Notice::StiffnessVaries { stiffness: range, mean_pressure });
    }
    if !result.normal.is_converged() {
        caveats.push(Notice::MicroModelNotConverged {});
    }
    if result.exponential.is_none() {
        caveats.push(Notice::NoClosedForm {});
    }
    caveats
}

/// The smallest and the largest of positive numbers.
fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, 0.0], |[least, largest], value| {
        [least.min(value), largest.max(value)]
    })
}
