//! The micro model in one: surface in, k_c out.

use super::load_curve::{ExponentialRange, LoadCurve, LoadCurveOptions, LoadPoint};
use super::stiffness::{ContactStiffness, TYPICAL_GAMMA, closed_form};
use super::tangential_curve::{SimilarBodies, TangentialCurve};
use crate::error::{Error, require_positive};
use crate::normal::rough_contact::{Boundary, RoughContact};
use crate::surface::HeightMap;
use crate::surface::statistics::Statistics;

/// Two rough bodies.
#[derive(Debug, Clone)]
pub struct MicroModel {
    /// Heights of both surfaces together, without form, continued periodically.
    pub surface: HeightMap,
    /// Contact modulus E*, in Pa.
    pub contact_modulus: f64,
    /// Friction and Poisson's ratio.
    pub bodies: SimilarBodies,
    /// Hardness of the softer body, in Pa; infinite for elastic bodies.
    pub hardness: f64,
    /// Mean pressures of the tangential curves, in Pa.
    pub mean_pressures: Vec<f64>,
}

/// What the micro model finds.
#[derive(Debug, Clone)]
pub struct MicroModelResult {
    /// Of the surface.
    pub statistics: Statistics,
    /// Approach over load.
    pub normal: LoadCurve,
    /// A curve for each mean pressure.
    pub tangential: Vec<TangentialCurve>,
    /// k_c.
    pub stiffness: ContactStiffness,
    /// Where the load grows exponentially, if the pressures reach it.
    pub exponential: Option<ExponentialRange>,
    /// γ = ℓ/h_rms of that range, dimensionless.
    pub gamma: Option<f64>,
    /// k_c = 2(1 − ν)/(μ(2 − ν) γ h_rms) with [`TYPICAL_GAMMA`], in 1/m.
    pub closed_form: f64,
}

impl MicroModel {
    /// Solves the normal contact over the load (`each` sees every point) and fits k_c.
    pub fn solve(
        &self,
        options: &LoadCurveOptions,
        each: &mut dyn FnMut(&LoadPoint),
    ) -> Result<MicroModelResult, Error> {
        self.bodies.check()?;
        let statistics = Statistics::of(&self.surface)?;
        for pressure in &self.mean_pressures {
            require_positive("normal.pressure", *pressure, "Pa")?;
        }
        let largest = self.mean_pressures.iter().copied().fold(0.0, f64::max);
        let distance = self.surface.distance_to_plane();
        let contact = RoughContact::new(distance, self.contact_modulus, Boundary::Periodic)?;
        let mut contact = contact.with_hardness(self.hardness)?;
        let normal = LoadCurve::compute(&mut contact, largest, options, each)?;
        let tangential: Result<Vec<TangentialCurve>, Error> = self
            .mean_pressures
            .iter()
            .map(|pressure| TangentialCurve::new(&normal, *pressure, &self.bodies))
            .collect();
        let tangential = tangential?;
        let stiffness = ContactStiffness::fit(&tangential).ok_or(Error::Contradiction {
            quantity: "normal.pressure",
            reason: "at least one mean pressure is needed".to_owned(),
        })?;
        let height = statistics.root_mean_square_height;
        let exponential = normal.exponential_range();
        Ok(MicroModelResult {
            statistics,
            gamma: exponential.map(|range| range.length / height),
            exponential,
            normal,
            tangential,
            stiffness,
            closed_form: closed_form(&self.bodies, TYPICAL_GAMMA * height),
        })
    }
}
