//! The stiffness k_c of the contact law, and where it comes from.

use std::sync::Arc;

use schlupf::interface::roughness::micro_model::MicroModelResult;

use crate::fields::readable;
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
    /// What the reader should know about the surface.
    pub notices: Vec<String>,
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

/// Fewer cells in contact than these do not show the shape of the spots.
const FEWEST_CELLS: f64 = 200.0;

/// Heights of rough surfaces in contact, in m; others are in a wrong unit.
const USUAL_HEIGHTS: [f64; 2] = [1e-9, 1e-4];

impl LawStiffness {
    /// What is doubtful about it.
    pub fn caveats(&self) -> Vec<String> {
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
                if is_usual { Vec::new() } else { vec![text] }
            }
        }
    }
}

impl MicroContact {
    /// Where Eq. (8) with one k_c is not what the micro model finds.
    pub fn caveats(&self) -> Vec<String> {
        caveats(&self.result, self.cells).into_iter().chain(self.notices.iter().cloned()).collect()
    }
}

/// Where Eq. (8) with one k_c is not what a micro model of so many cells finds, or that is doubtful.
pub fn caveats(result: &MicroModelResult, cells: usize) -> Vec<String> {
    let mut caveats = Vec::new();
    let fraction = result.normal.points().last().map_or(0.0, |point| point.contact_fraction);
    let in_contact = fraction * cells as f64;
    if in_contact < FEWEST_CELLS {
        caveats.push(format!(
            "only {in_contact:.0} cells are in contact at the largest pressure: k_c is doubtful; more \
             cells or a larger surface make it better"
        ));
    }
    let stiffness = &result.stiffness;
    if stiffness.common.root_mean_square_error > NOTICEABLE_ERROR {
        caveats.push(format!(
            "Eq. (8) with one k_c misses {:.0} % of μp (root mean square), at most {:.0} %: the \
             surface does not load exponentially at these pressures",
            1e2 * stiffness.common.root_mean_square_error,
            1e2 * stiffness.common.largest_error
        ));
    }
    if stiffness.spread > NOTICEABLE_SPREAD {
        let values = || stiffness.fits.iter().map(|fit| fit.stiffness);
        caveats.push(format!(
            "k_c depends on the pressure: from {:.3e} to {:.3e} 1/m between {:.0} and {:.0} MPa",
            values().fold(f64::INFINITY, f64::min),
            values().fold(0.0, f64::max),
            1e-6 * stiffness.mean_pressures.iter().copied().fold(f64::INFINITY, f64::min),
            1e-6 * stiffness.mean_pressures.iter().copied().fold(0.0, f64::max)
        ));
    }
    if !result.normal.is_converged() {
        caveats.push(
            "the normal contact of the micro model did not converge at every pressure: do not trust \
             its k_c"
                .to_owned(),
        );
    }
    if result.exponential.is_none() {
        caveats.push(
            "fewer than three of the solved pressures bring 1 to 20 % of the surface into contact: the \
             closed form does not apply"
                .to_owned(),
        );
    }
    caveats
}
