//! A rough surface, its contact and its k_c: CSV, JSON, .npy and a summary. The figures are among
//! the figures.

mod curves_figure;
mod height_map;
mod json;
mod npy;
mod spectrum_figure;
mod summary;

use schlupf::Status;
use schlupf::interface::roughness::MicroModelResult;
use schlupf::interface::roughness::tangential_curve::{SimilarBodies, TangentialCurve};
use schlupf::reporting::{Column, Message, Record, columns};
use schlupf::surface::spectrum::RadialSpectrum;
use schlupf::surface::{HeightMap, Lattice};

use crate::output::figures::{Drawing, FigureError};
use crate::output::report::{OwnFile, Report};
use crate::output::summary::Summary;
use crate::output::table::{self, ColumnValues, Table, entries, entry};

/// Names of the figures.
const FIGURES: [&str; 4] =
    ["roughness_curves", "roughness_surface", "roughness_spots", "roughness_spectrum"];

/// A rough surface with the results of the micro model.
#[derive(Debug, Clone)]
pub struct RoughnessReport {
    /// Origin of the surface.
    pub title: String,
    /// Combined heights of both surfaces, without form.
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
    /// Processing steps from the given data to the surface.
    pub remarks: Vec<String>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<Message>,
}

/// The contact spots of a surface.
#[derive(Debug, Clone)]
pub struct Spots {
    /// The cells of the surface.
    pub lattice: Lattice,
    /// Mean pressure, in Pa.
    pub mean_pressure: f64,
    /// Pressure in every cell, row after row, in Pa.
    pub pressure: Vec<f64>,
    /// Gap in every cell, row after row, in m; negative where the material has yielded, by the
    /// flattened depth.
    pub gap: Vec<f64>,
    /// Whether this solution converged.
    pub is_converged: bool,
}

/// All cells of the surface, row after row; those with a pressure touch.
impl Record for Spots {
    fn rows(&self) -> usize {
        self.lattice.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Spots:
        X => |spots, k| (k % spots.lattice.columns) as f64 * spots.lattice.spacing_x,
        Y => |spots, k| (k / spots.lattice.columns) as f64 * spots.lattice.spacing_y,
        Pressure => |spots, k| spots.pressure[k],
        Gap => |spots, k| spots.gap[k],
    };
}

impl RoughnessReport {
    /// Format of the combined heights of both surfaces without form, in m.
    pub const HEIGHTS: &str = "heights";
    /// Format of the pressures in all cells at one mean pressure, in Pa.
    pub const PRESSURES: &str = "pressures";
    /// Format of the gaps there, in m.
    pub const GAPS: &str = "gaps";
}

impl Report for RoughnessReport {
    /// Whether the contact converged at all pressures.
    fn status(&self) -> Status {
        let spots = self.spots.as_ref().is_none_or(|spots| spots.is_converged);
        if self.result.normal.is_converged() && spots {
            Status::Converged
        } else {
            Status::NotConverged
        }
    }

    fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    fn json(&self) -> String {
        json::document(self)
    }

    fn summary(&self) -> Summary {
        summary::text(self)
    }

    /// Curve after curve; the last column is Eq. (8) with the k_c of its pressure.
    fn csv(&self) -> Option<String> {
        let table = Table::default().with("mean_pressure", "Pa").with_columns::<TangentialCurve>();
        let mut table = table.with("exponential", "1");
        let result = &self.result;
        for (curve, fit) in result.tangential.iter().zip(&result.stiffness.fits) {
            for (row, point) in curve.points.iter().enumerate() {
                let exponential = -(-fit.stiffness * point.displacement).exp_m1();
                let [first, last] =
                    [curve.mean_pressure, exponential].map(|number| entry(number.into()));
                table.push([first].into_iter().chain(entries(curve, row)).chain([last]));
            }
        }
        Some(table.csv("the last column is Eq. (8) with the k_c of this pressure"))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<ColumnValues>)> {
        let curves = self.result.tangential.iter().map(|curve| ("curves", table::columns(curve)));
        let own = [
            ("spectrum", table::columns(&self.spectrum)),
            ("loads", table::columns(&self.result.normal)),
        ];
        let spots = self.spots.as_ref().map(|spots| ("spots", table::columns(spots)));
        own.into_iter().chain(curves).chain(spots).collect()
    }

    fn figure_names() -> Vec<String> {
        FIGURES.map(str::to_owned).to_vec()
    }

    fn drawings(&self) -> Result<Vec<Drawing>, FigureError> {
        let [curves, surface, spots, spectrum] = FIGURES.map(str::to_owned);
        let mut drawings = vec![
            (curves, curves_figure::draw(self).ok_or(FigureError::NoTangentialCurve)?),
            (surface, height_map::surface(self)),
        ];
        drawings.extend(self.spots.as_ref().map(|found| (spots, height_map::spots(self, found))));
        drawings.extend(spectrum_figure::draw(self).map(|svg| (spectrum, svg)));
        Ok(drawings)
    }

    fn own_files() -> &'static [OwnFile] {
        const {
            &[
                OwnFile::new(
                    Self::HEIGHTS,
                    "heights",
                    "Write the heights, of both surfaces together and without form, as .npy in m",
                ),
                OwnFile::new(
                    Self::PRESSURES,
                    "pressures",
                    "Write the pressures in all cells at the largest mean pressure as .npy in Pa",
                )
                .part(),
                OwnFile::new(
                    Self::GAPS,
                    "gaps",
                    "Write the gaps there as .npy in m; a negative gap is the flattened depth",
                )
                .part(),
            ]
        }
    }

    fn own_file(&self, format: &str) -> Option<Vec<u8>> {
        let contact = |k: usize| npy::contact(self).map(|fields| fields[k].clone());
        match format {
            Self::HEIGHTS => Some(npy::heights(self)),
            Self::PRESSURES => contact(0),
            Self::GAPS => contact(1),
            _ => None,
        }
    }
}
