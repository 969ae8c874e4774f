//! The complete micro model, from surface to k_c.

use super::load_curve::{ExponentialRange, LoadCurve, LoadCurveOptions};
use super::stiffness::{ContactStiffness, TYPICAL_GAMMA, closed_form};
use super::tangential_curve::{SimilarBodies, TangentialCurve};
use crate::normal::rough_contact::{Boundary, RoughContact};
use crate::reporting::{Error, Quantity, Watch, require_positive};
use crate::surface::{HeightMap, Statistics};

/// Two rough bodies.
#[derive(Debug, Clone)]
pub struct MicroModel {
    /// Combined heights of both surfaces, without form, continued periodically.
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

/// Result of the micro model.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct MicroModelResult {
    /// Statistics of the surface.
    pub statistics: Statistics,
    /// Approach as a function of load.
    pub normal: LoadCurve,
    /// One curve for each mean pressure.
    pub tangential: Vec<TangentialCurve>,
    /// k_c.
    pub stiffness: ContactStiffness,
    /// The range in which the load grows exponentially, if the pressures include it.
    pub exponential: Option<ExponentialRange>,
    /// γ = ℓ/h_rms of that range, dimensionless.
    pub gamma: Option<f64>,
    /// k_c = 2(1 − ν)/(μ(2 − ν) γ h_rms) with [`TYPICAL_GAMMA`], in 1/m.
    pub closed_form: f64,
}

/// Ratio of the smallest mean pressure of a curve to the smallest one in the normal contact,
/// dimensionless.
const BELOW: f64 = 100.0;

impl MicroModel {
    /// Solves the normal contact as a function of load and fits k_c.
    ///
    /// ```
    /// use schlupf::interface::roughness::{LoadCurveOptions, MicroModel};
    /// use schlupf::interface::roughness::tangential_curve::SimilarBodies;
    /// use schlupf::surface::synthesis::{Roughness, SelfAffine};
    /// use schlupf::surface::Lattice;
    ///
    /// let roughness = Roughness::Height(1e-6);
    /// let (longest_wavelength, roll_off_wavelength, shortest_wavelength) = (5e-4, 2.5e-4, 5e-5);
    /// let hurst_exponent = 0.8;
    /// let spectrum = SelfAffine {
    ///     roughness, hurst_exponent, longest_wavelength, roll_off_wavelength, shortest_wavelength,
    /// };
    /// let model = MicroModel {
    ///     surface: spectrum.surface(Lattice::square(64, 1e-3), 1)?,
    ///     contact_modulus: 115e9,
    ///     bodies: SimilarBodies { friction_coefficient: 0.4, poisson_ratio: 0.28 },
    ///     hardness: f64::INFINITY,
    ///     mean_pressures: vec![300e6],
    /// };
    /// let found = model.solve(&LoadCurveOptions::default(), &schlupf::unwatched)?;
    /// assert!((found.stiffness.common.stiffness / found.closed_form).ln().abs() < 2.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn solve(
        &self,
        options: &LoadCurveOptions,
        watch: Watch,
    ) -> Result<MicroModelResult, Error> {
        self.bodies.check()?;
        let statistics = Statistics::of(&self.surface)?;
        for pressure in &self.mean_pressures {
            require_positive(Quantity::MeanPressure, *pressure)?;
        }
        let options = &self.reaching(options);
        let largest = self.largest_pressure();
        let distance = self.surface.distance_to_plane();
        let contact = RoughContact::new(distance, self.contact_modulus, Boundary::Periodic)?;
        let mut contact = contact.with_hardness(self.hardness)?;
        let normal = LoadCurve::compute(&mut contact, largest, options, watch)?;
        MicroModelResult::new(statistics, normal, &self.bodies, &self.mean_pressures)
    }

    /// Largest mean pressure, in Pa.
    fn largest_pressure(&self) -> f64 {
        self.mean_pressures.iter().copied().fold(0.0, f64::max)
    }

    /// Options that extend well below the smallest mean pressure, where its tangential curve ends.
    fn reaching(&self, options: &LoadCurveOptions) -> LoadCurveOptions {
        let least = self.mean_pressures.iter().copied().fold(f64::INFINITY, f64::min);
        let range = options.range.max(BELOW * self.largest_pressure() / least);
        LoadCurveOptions { range, ..*options }
    }
}

impl MicroModelResult {
    /// Whether the normal contact extends as far below the given mean pressures (in Pa) as one
    /// solved for them.
    pub fn covers(&self, mean_pressures: &[f64]) -> bool {
        let least = (1.0 - 1e-9) * BELOW * self.normal.smallest_pressure();
        mean_pressures.iter().all(|pressure| *pressure >= least)
    }

    /// Computes tangential curves at mean pressures (in Pa), and k_c, from a solved normal contact.
    pub fn new(
        statistics: Statistics,
        normal: LoadCurve,
        bodies: &SimilarBodies,
        mean_pressures: &[f64],
    ) -> Result<Self, Error> {
        let curve = |pressure: &f64| TangentialCurve::new(&normal, *pressure, bodies);
        let tangential: Vec<TangentialCurve> =
            mean_pressures.iter().map(curve).collect::<Result<_, _>>()?;
        let stiffness = ContactStiffness::fit(&tangential).ok_or(Error::TooFew {
            quantity: Quantity::MeanPressure,
            fewest: 1,
            count: 0,
        })?;
        let height = statistics.root_mean_square_height;
        let exponential = normal.exponential_range();
        Ok(Self {
            statistics,
            gamma: exponential.map(|range| range.length / height),
            exponential,
            normal,
            tangential,
            stiffness,
            closed_form: closed_form(bodies, TYPICAL_GAMMA * height),
        })
    }
}

/// Local pressures (in Pa) that represent a Hertzian patch with the largest pressure p0 (in Pa):
/// one sixth, one half and five sixths of the load are carried below them. The fraction of the load
/// carried at pressures below p is (p/p0)³.
///
/// ```
/// use schlupf::interface::roughness::pressures_of_patch;
///
/// // One half of the load is carried at lower pressures.
/// assert!((pressures_of_patch(1e9)[1] / 1e9 - 0.5_f64.cbrt()).abs() < 1e-12);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn pressures_of_patch(peak_pressure: f64) -> [f64; 3] {
    [1.0, 3.0, 5.0].map(|sixths: f64| peak_pressure * (sixths / 6.0).cbrt())
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Goal: the fractions of the load, by summing the pressure p0 √(1 − r²) over rings of the
    /// patch.
    #[test]
    fn the_pressures_of_a_patch_divide_its_load() {
        let rings: Vec<[f64; 2]> = (0..100_000)
            .map(|k| (f64::from(k) + 0.5) / 1e5)
            .map(|r| [(1.0 - r * r).sqrt(), (1.0 - r * r).sqrt() * r])
            .collect();
        let load: f64 = rings.iter().map(|[_, force]| force).sum();
        for (pressure, share) in pressures_of_patch(1.0).into_iter().zip([1.0, 3.0, 5.0]) {
            let below = rings.iter().filter(|[p, _]| *p < pressure);
            let carried: f64 = below.map(|[_, force]| force).sum();
            assert_relative_eq!(carried / load, share / 6.0, max_relative = 1e-3);
        }
    }
}
