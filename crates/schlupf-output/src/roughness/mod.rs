//! A rough surface, its contact and its k_c: CSV, JSON, .npy and a summary. The figures are among the figures.

pub mod csv;
pub mod json;
pub mod npy;
pub mod summary;

use schlupf::Status;
use schlupf::interface::roughness::micro_model::MicroModelResult;
use schlupf::interface::roughness::tangential_curve::SimilarBodies;
use schlupf::surface::HeightMap;
use schlupf::surface::spectrum::RadialSpectrum;

/// A rough surface with what the micro model found.
#[derive(Debug, Clone)]
pub struct RoughnessReport {
    /// Where the surface comes from.
    pub title: String,
    /// Heights of both surfaces together, without form.
    pub surface: HeightMap,
    /// Its power spectral density.
    pub spectrum: RadialSpectrum,
    /// Friction and Poisson's ratio.
    pub bodies: SimilarBodies,
    /// Contact modulus E*, in Pa.
    pub contact_modulus: f64,
    /// Hardness, in Pa; infinite for elastic bodies.
    pub hardness: f64,
    /// The micro model.
    pub result: MicroModelResult,
    /// The contact at one mean pressure, for a map.
    pub spots: Option<Spots>,
    /// How the surface was made of what was given.
    pub remarks: Vec<String>,
    /// Whatever the reader of the numbers must know.
    pub warnings: Vec<String>,
}

/// Where a surface carries.
#[derive(Debug, Clone)]
pub struct Spots {
    /// Mean pressure, in Pa.
    pub mean_pressure: f64,
    /// Pressure in every cell, row after row, in Pa.
    pub pressure: Vec<f64>,
    /// Gap in every cell, row after row, in m; negative where the material has yielded, by the depth that was flattened.
    pub gap: Vec<f64>,
    /// Whether this solution converged.
    pub is_converged: bool,
}

impl RoughnessReport {
    /// Whether the contact converged at all pressures.
    pub fn status(&self) -> Status {
        let spots = self.spots.as_ref().is_none_or(|spots| spots.is_converged);
        if self.result.normal.is_converged() && spots {
            Status::Converged
        } else {
            Status::NotConverged
        }
    }
}
