//! Tangential force against displacement of a rough contact, Figure 3 of Neuhaus and Sextro (2014).
//!
//! For similar elastic bodies with Coulomb friction in every spot, the traction under a tangential
//! force Q is that of full sliding under P minus that of full sliding under P*, the load whose
//! contact area still sticks (Ciavarella 1998, Int. J. Solids Struct. 35, 2349; Jäger 1998, J.
//! Tribol. 120, 677):
//!
//! Q = μ (P − P*),  u = μ c (d(P) − d(P*)),  c = (2 − ν)/(2 (1 − ν)).
//!
//! Bodies that have yielded under P or more unload elastically, and so d(P*) must be that of
//! surfaces flattened by the largest load ([`super::load_curve::LoadCurve::compute`]).
//!
//! P* falls from P (full stick) to 0 (full sliding, at a finite displacement). Exact for ν = 0;
//! otherwise the small displacement transverse to the force is neglected, and c is that of circular
//! spots.

use super::load_curve::LoadCurve;
use crate::numerics::interpolation::piecewise_linear;
use crate::reporting::{
    Column, Error, Quantity, Record, Requirement, columns, require, require_positive,
};

/// Friction and elasticity of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SimilarBodies {
    /// Coefficient of friction μ, dimensionless.
    pub friction_coefficient: f64,
    /// Poisson's ratio ν of both bodies, dimensionless.
    pub poisson_ratio: f64,
}

impl SimilarBodies {
    /// Ratio of tangential to normal compliance c = (2 − ν)/(2 (1 − ν)), dimensionless (Mindlin
    /// 1949).
    pub fn compliance_ratio(&self) -> f64 {
        (2.0 - self.poisson_ratio) / (2.0 * (1.0 - self.poisson_ratio))
    }

    /// Checks both values.
    pub fn check(&self) -> Result<(), Error> {
        require_positive(Quantity::FrictionCoefficient, self.friction_coefficient)?;
        let legal = Requirement::Between(0.0, 0.5);
        require(Quantity::PoissonRatio, legal, self.poisson_ratio)
    }
}

/// A point of the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct TangentialPoint {
    /// Relative tangential displacement of the two bodies, in m.
    pub displacement: f64,
    /// Tangential force per unit nominal area, in Pa.
    pub traction: f64,
    /// The same relative to that of full sliding, Q/(μP), dimensionless.
    pub normalised_traction: f64,
    /// Displacement relative to that at the onset of full sliding, dimensionless.
    pub normalised_displacement: f64,
    /// Slope of the traction, in Pa/m.
    pub stiffness: f64,
    /// Part of the displacement due to sliding of spots, u − q/k(0), in m.
    pub micro_slip: f64,
    /// Fraction of the contact that slides, dimensionless.
    pub sliding_fraction: f64,
}

/// The curve at one mean pressure.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct TangentialCurve {
    /// Mean pressure over the nominal area, in Pa.
    pub mean_pressure: f64,
    /// Traction of full sliding μp, in Pa.
    pub limit: f64,
    /// Displacement at the onset of full sliding, in m.
    pub full_sliding_displacement: f64,
    /// Slope in full stick, per unit area, in Pa/m.
    pub initial_stiffness: f64,
    /// From rest to full sliding, and one point beyond.
    pub points: Vec<TangentialPoint>,
}

/// Number of points up to full sliding, and the relative distance of the last one beyond it.
const POINTS: usize = 100;
const BEYOND: f64 = 1.25;

impl TangentialCurve {
    /// The curve at a mean pressure (in Pa) within those of the normal curve.
    pub fn new(
        normal: &LoadCurve,
        mean_pressure: f64,
        bodies: &SimilarBodies,
    ) -> Result<Self, Error> {
        bodies.check()?;
        let (least, largest) = (normal.smallest_pressure(), normal.largest_pressure());
        let computed = Requirement::Between(least * (1.0 - 1e-12), largest * (1.0 + 1e-12));
        require(Quantity::MeanPressure, computed, mean_pressure)?;
        let factor = bodies.friction_coefficient * bodies.compliance_ratio();
        let limit = bodies.friction_coefficient * mean_pressure;
        let [approach, slope] = normal.approach(mean_pressure);
        let mut curve = Self {
            mean_pressure,
            limit,
            full_sliding_displacement: factor * approach,
            initial_stiffness: limit / (factor * slope),
            points: Vec::with_capacity(POINTS + 2),
        };
        let area = normal.contact_fraction(mean_pressure);
        for k in 0..=POINTS {
            // Equal steps of the displacement of a sphere.
            let share = (1.0 - k as f64 / POINTS as f64).powf(1.5);
            let sticking = share * mean_pressure;
            let [still, slope] = normal.approach(sticking);
            let displacement = factor * (approach - still);
            let stiffness = if share > 0.0 { limit * share / (factor * slope) } else { 0.0 };
            let sliding_fraction = 1.0 - normal.contact_fraction(sticking) / area;
            curve.push(displacement, 1.0 - share, stiffness, sliding_fraction);
        }
        curve.push(BEYOND * curve.full_sliding_displacement, 1.0, 0.0, 1.0);
        Ok(curve)
    }

    fn push(&mut self, displacement: f64, share: f64, stiffness: f64, sliding_fraction: f64) {
        let traction = share * self.limit;
        self.points.push(TangentialPoint {
            displacement,
            traction,
            normalised_traction: share,
            normalised_displacement: displacement / self.full_sliding_displacement,
            stiffness,
            micro_slip: displacement - traction / self.initial_stiffness,
            sliding_fraction,
        });
    }

    /// Q/(μP) (dimensionless) at a displacement (in m), by linear interpolation between the points.
    pub fn normalised_traction(&self, displacement: f64) -> f64 {
        let points =
            self.points.iter().map(|point| (point.displacement, point.normalised_traction));
        let (displacements, tractions): (Vec<f64>, Vec<f64>) = points.unzip();
        piecewise_linear(&displacements, &tractions, displacement)[0]
    }
}

/// Displacements of a rough surface at one mean pressure.
impl Record for TangentialCurve {
    fn rows(&self) -> usize {
        self.points.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { TangentialCurve:
        SurfaceDisplacement "displacement" => |curve, k| curve.points[k].displacement,
        SurfaceTraction "traction" => |curve, k| curve.points[k].traction,
        NormalisedTraction => |curve, k| curve.points[k].normalised_traction,
        NormalisedDisplacement => |curve, k| curve.points[k].normalised_displacement,
        TangentialStiffness "stiffness" => |curve, k| curve.points[k].stiffness,
        MicroSlip => |curve, k| curve.points[k].micro_slip,
        SlidingFraction => |curve, k| curve.points[k].sliding_fraction,
    };
}
