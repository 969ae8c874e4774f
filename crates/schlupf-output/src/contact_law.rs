//! The stiffness k_c of the contact law in results.

use serde::Serialize;

use crate::number::significant as number;

/// k_c and its origin.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactLaw {
    /// k_c, in 1/m.
    pub stiffness: f64,
    /// Its origin.
    pub from: Origin,
    /// Combined h_rms of both surfaces (in m), if k_c comes from a roughness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rms_height: Option<f64>,
    /// γ of the closed form, or as found by the micro model; dimensionless.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slope_factor: Option<f64>,
    /// The fit of the micro model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<Fit>,
}

/// Where k_c comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Origin {
    /// It is given.
    Given,
    /// It is the default.
    Default,
    /// The closed form with a roughness.
    ClosedForm,
    /// The micro model of a rough surface.
    MicroModel,
}

impl Origin {
    /// Its name, for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Default => "default",
            Self::ClosedForm => "closed form",
            Self::MicroModel => "micro model",
        }
    }
}

/// Fit of Eq. (8) to the tangential curves of a micro model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fit {
    /// Mean pressures, in Pa.
    pub mean_pressures: Vec<f64>,
    /// k_c at each of them, in 1/m.
    pub stiffnesses: Vec<f64>,
    /// Difference between the largest and smallest of them relative to the common k_c,
    /// dimensionless.
    pub spread: f64,
    /// Root mean square misfit of the common k_c to Q/(μP), dimensionless.
    pub root_mean_square_error: f64,
    /// Largest misfit, dimensionless.
    pub largest_error: f64,
    /// k_c of the closed form with γ = 0.45, in 1/m.
    pub closed_form: f64,
}

impl ContactLaw {
    /// The origin of k_c, in words.
    pub(crate) fn remark(&self) -> String {
        let height = number(self.rms_height.unwrap_or(0.0) / 1e-6);
        match (&self.fit, self.slope_factor) {
            (Some(fit), _) => format!(
                "k_c, micro model: h_rms = {height} µm, Eq. (8) misses {} % of μp (rms)",
                number((1e3 * fit.root_mean_square_error).round() / 10.0)
            ),
            (None, Some(factor)) => {
                format!("k_c, closed form: h_rms = {height} µm, γ = {}", number(factor))
            }
            (None, None) if self.from == Origin::Default => "k_c, the default".to_owned(),
            (None, None) => "k_c, as given".to_owned(),
        }
    }
}
