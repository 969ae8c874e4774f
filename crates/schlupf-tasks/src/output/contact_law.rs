//! The stiffness k_c of the contact law in results.

use serde::Serialize;

use crate::output::number::significant as number;

/// k_c and its origin.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactLaw {
    /// k_c, in 1/m; infinite with Coulomb's law, and then left out.
    #[serde(skip_serializing_if = "is_infinite")]
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
    /// There is none, because the law is Coulomb's.
    Coulomb,
}

impl Origin {
    /// Its name, for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Default => "default",
            Self::ClosedForm => "closed form",
            Self::MicroModel => "micro model",
            Self::Coulomb => "Coulomb's law",
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

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
fn is_infinite(stiffness: &f64) -> bool {
    stiffness.is_infinite()
}

impl ContactLaw {
    /// Whether there are no bristles.
    pub fn is_coulomb(&self) -> bool {
        self.from == Origin::Coulomb
    }

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
            (None, None) if self.is_coulomb() => "Coulomb's law: no bristles".to_owned(),
            (None, None) if self.from == Origin::Default => "k_c, the default".to_owned(),
            (None, None) => "k_c, as given".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An infinite k_c has no number; the law is named instead.
    #[test]
    fn coulombs_law_is_named() {
        let law = |stiffness: f64, from: Origin| ContactLaw {
            stiffness,
            from,
            rms_height: None,
            slope_factor: None,
            fit: None,
        };
        let json = |law: &ContactLaw| serde_json::to_string(law).unwrap();
        let coulomb = law(f64::INFINITY, Origin::Coulomb);
        assert_eq!(json(&coulomb), r#"{"from":"coulomb"}"#);
        assert_eq!(coulomb.remark(), "Coulomb's law: no bristles");
        assert_eq!(json(&law(5e6, Origin::Given)), r#"{"stiffness":5000000.0,"from":"given"}"#);
    }
}
