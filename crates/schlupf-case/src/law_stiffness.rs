//! The stiffness k_c of the contact law, and where it comes from.

use std::sync::Arc;

use schlupf::interface::roughness::micro_model::MicroModelResult;
use schlupf::message::Message;

use crate::fields::readable;
use crate::surface::{SurfaceSource, notice};

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
    /// What the reader should know about the surface.
    pub notices: Vec<Message>,
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

/// Notices where the exponential misses more than this part of μp (root mean square), or k_c changes by
/// more than this part of itself; dimensionless.
const NOTICEABLE_ERROR: f64 = 0.05;
const NOTICEABLE_SPREAD: f64 = 0.2;

/// Fewer cells in contact than these do not show the shape of the spots: at the largest and at the smallest pressure.
const FEWEST_CELLS: f64 = 200.0;
const FEWEST_CELLS_AT_LEAST: f64 = 30.0;

/// Heights of rough surfaces in contact, in m; others are in a wrong unit.
const USUAL_HEIGHTS: [f64; 2] = [1e-9, 1e-4];

impl LawStiffness {
    /// Whether it follows from a roughness, and so changes with the coefficient of friction.
    pub fn is_from_roughness(&self) -> bool {
        matches!(self.origin, StiffnessOrigin::ClosedForm { .. } | StiffnessOrigin::MicroModel(_))
    }

    /// What is doubtful about it.
    pub fn caveats(&self) -> Vec<Message> {
        match &self.origin {
            StiffnessOrigin::Given | StiffnessOrigin::Default => Vec::new(),
            StiffnessOrigin::MicroModel(micro) => micro.caveats(),
            StiffnessOrigin::ClosedForm { rms_height, .. } => {
                let [low, high] = USUAL_HEIGHTS;
                let is_usual = (low..=high).contains(rms_height);
                let text = format!(
                    "h_rms is {} m, outside of 1 nm to 100 µm: is its unit right?",
                    readable(*rms_height)
                );
                if is_usual { Vec::new() } else { vec![notice("unusual-height", text)] }
            }
        }
    }
}

impl MicroContact {
    /// Whether its normal contact serves another request, too: the same, and solved far enough down.
    pub fn serves(&self, key: &MicroKey, mean_pressures: &[f64]) -> bool {
        self.key == *key && self.result.covers(mean_pressures)
    }

    /// Where Eq. (8) with one k_c is not what the micro model finds.
    pub fn caveats(&self) -> Vec<Message> {
        let caveats = caveats(&self.result, self.cells, &self.key);
        caveats.into_iter().chain(self.notices.iter().cloned()).collect()
    }
}

/// Mean pressure in elastic spots over E* from which on hard steel, too, yields; dimensionless.
const YIELDING: f64 = 0.03;

/// Elastic spots that carry more than any steel does.
fn yielding(result: &MicroModelResult, key: &MicroKey) -> Option<Message> {
    let mean = result.normal.mean_spot_pressure(key.largest_pressure);
    let is_beyond = key.hardness.is_infinite() && mean > YIELDING * key.contact_modulus;
    is_beyond.then(|| {
        let text = format!(
            "the spots carry {:.1} GPa in the mean at {:.0} MPa, more than steel does before it yields \
             (2.5 to 3 GPa on rails): a hardness belongs to this surface",
            1e-9 * mean,
            1e-6 * key.largest_pressure
        );
        notice("yielding-spots", text)
    })
}

/// Where Eq. (8) with one k_c is not what a micro model of so many cells finds, or that is doubtful.
pub fn caveats(result: &MicroModelResult, cells: usize, key: &MicroKey) -> Vec<Message> {
    let mut caveats = Vec::from_iter(yielding(result, key));
    let pressures = result.stiffness.mean_pressures.iter().copied();
    let least = pressures.clone().fold(f64::INFINITY, f64::min);
    let in_contact = |pressure: f64| result.normal.contact_fraction(pressure) * cells as f64;
    let largest = pressures.fold(0.0, f64::max);
    for (pressure, fewest, which) in
        [(largest, FEWEST_CELLS, "largest"), (least, FEWEST_CELLS_AT_LEAST, "smallest")]
    {
        let found = in_contact(pressure);
        if found < fewest {
            caveats.push(notice(
            "few-cells-in-contact",
            format!(
                "only {found:.0} cells are in contact at the {which} pressure: k_c is doubtful; more cells \
                 or a larger surface make it better"
            )));
            break;
        }
    }
    let stiffness = &result.stiffness;
    if stiffness.common.root_mean_square_error > NOTICEABLE_ERROR {
        caveats.push(notice(
            "not-exponential",
            format!(
            "Eq. (8) with one k_c misses {:.0} % of μp (root mean square), at most {:.0} %: the \
             surface does not load exponentially at these pressures",
            1e2 * stiffness.common.root_mean_square_error,
            1e2 * stiffness.common.largest_error
        )));
    }
    if stiffness.spread > NOTICEABLE_SPREAD {
        let values = || stiffness.fits.iter().map(|fit| fit.stiffness);
        caveats.push(notice(
            "stiffness-varies",
            format!(
            "k_c depends on the pressure: from {:.3e} to {:.3e} 1/m between {:.0} and {:.0} MPa",
            values().fold(f64::INFINITY, f64::min),
            values().fold(0.0, f64::max),
            1e-6 * stiffness.mean_pressures.iter().copied().fold(f64::INFINITY, f64::min),
            1e-6 * stiffness.mean_pressures.iter().copied().fold(0.0, f64::max)
        )));
    }
    if !result.normal.is_converged() {
        caveats.push(notice(
            "micro-model-not-converged",

            "the normal contact of the micro model did not converge at every pressure: do not trust \
             its k_c"
                .to_owned(),
        ));
    }
    if result.exponential.is_none() {
        caveats.push(notice(
            "no-closed-form",

            "fewer than three of the solved pressures bring 1 to 20 % of the surface into contact: the \
             closed form does not apply"
                .to_owned(),
        ));
    }
    caveats
}
