//! The methods that solve a problem: the full equations, or one of the fast methods of vehicle
//! dynamics.
//!
//! The fast methods describe steady rolling of an elastic half-space: elasticity and contact law of
//! the problem are ignored; only the elastic constants of the bodies are used.

use std::sync::Arc;

use crate::problem::look_up_table::LookUpTable;
use crate::reporting::{Error, Quantity, Requirement, require};

/// A method.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Method {
    /// The full coupled equations.
    #[default]
    Full,
    /// One of the fast methods.
    Fast(FastMethod),
}

/// How a steady state of the full equations is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Driver {
    /// Directly.
    #[default]
    Steady,
    /// Step by step in time.
    Marching,
}

/// A fast method.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum FastMethod {
    /// Kalker's linear theory: forces and moment for small creepages.
    KalkerLinear,
    /// Shen, Hedrick and Elkins (1983): forces and moment.
    ShenHedrickElkins,
    /// Polach (1999, 2005): forces.
    Polach(AreaReduction),
    /// FASTSIM (Kalker 1982): forces, moment, fields, temperatures.
    Fastsim(Brush),
    /// FASTSIM with a slope that decreases with creepage (Spiryagin, Polach and Cole 2013).
    ModifiedFastsim(Brush, SlopeReduction),
    /// A look-up table of the half-space with Coulomb's law: forces, moment, derivatives.
    Table(Arc<LookUpTable>),
}

/// Reduction of the initial slope of the creep curve by Polach (2005).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaReduction {
    /// k_A in the area of adhesion, dimensionless, above 0 and at most 1.
    pub area_adhesion: f64,
    /// k_S in the area of slip, dimensionless, above 0 and at most k_A.
    pub area_slip: f64,
}

/// The bristles of FASTSIM.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Brush {
    /// Number of flexibilities.
    pub flexibilities: Flexibilities,
    /// The bound of the traction.
    pub bound: TractionBound,
}

/// The flexibilities of FASTSIM.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flexibilities {
    /// The mean of the three, weighted by the creepages.
    One,
    /// One each for longitudinal, lateral and spin creepage.
    Three,
}

/// The pressure that bounds the traction of FASTSIM.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TractionBound {
    /// The pressure of the normal contact: that of Hertz, or a table.
    Elliptic,
    /// The paraboloid 2N/(πab) (1 − x²/a² − y²/b²) with the same load.
    Parabolic,
}

/// Slope reduction of modified FASTSIM: Kalker's slope times k0 ((1 − α)/(1 + β ε) + α), where ε
/// grows with creepage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlopeReduction {
    /// k0 for vanishing creepage, dimensionless, above 0 and at most 1.
    pub initial: f64,
    /// α, the fraction of it that remains at large creepages, dimensionless, between 0 and 1.
    pub limit_ratio: f64,
    /// β, rate of the decrease, dimensionless, not negative.
    pub decay: f64,
}

/// A table is only equal to itself.
impl PartialEq for FastMethod {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::KalkerLinear, Self::KalkerLinear)
            | (Self::ShenHedrickElkins, Self::ShenHedrickElkins) => true,
            (Self::Polach(one), Self::Polach(other)) => one == other,
            (Self::Fastsim(one), Self::Fastsim(other)) => one == other,
            (Self::ModifiedFastsim(one, slope), Self::ModifiedFastsim(other, other_slope)) => {
                (one, slope) == (other, other_slope)
            }
            (Self::Table(one), Self::Table(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }
}

impl AreaReduction {
    /// Typical of dry rails: k_A = 1, k_S = 0.4 (Polach 2005).
    pub const DRY: Self = Self { area_adhesion: 1.0, area_slip: 0.4 };
}

impl Brush {
    /// Three flexibilities and the parabolic bound, as Kalker (1982) has them.
    pub const KALKER: Self =
        Self { flexibilities: Flexibilities::Three, bound: TractionBound::Parabolic };
}

impl SlopeReduction {
    /// k0 = 1, α = 0.025, β = 0.85: with these and the parabolic bound longitudinal forces match
    /// Polach's formula with k_A = 1, k_S = 0.4 within 4 % of μN (root mean square 2 %).
    pub const DRY: Self = Self { initial: 1.0, limit_ratio: 0.025, decay: 0.85 };

    /// k0 = 0.54, α = 0.02, β = 0.31: a locomotive, with friction that falls with the slip speed (μ
    /// = 0.1368 + 0.2232 · 2^(−s/0.99 m/s) there), from measurements of Engel et al. (1998).
    ///
    /// Source: Spiryagin, Polach and Cole (2013) by way of Vollebregt's user guide for CONTACT,
    /// which have β = 0.62: their ε is half of ours. With 0.31 the curve of CONTACT is met within
    /// 0.8 % of μ0 N.
    pub const LOCOMOTIVE: Self = Self { initial: 0.54, limit_ratio: 0.02, decay: 0.31 };
}

impl Method {
    /// Name in case files and results.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Fast(method) => method.name(),
        }
    }

    /// Whether it computes the traction at every point, with temperatures, rather than forces only.
    /// If so, it takes the motion of every row ([`crate::bodies::RowMotion`]), else that of the
    /// plane.
    pub fn has_fields(&self) -> bool {
        match self {
            Self::Full => true,
            Self::Fast(method) => method.has_fields(),
        }
    }
}

impl FastMethod {
    /// Name in case files and results.
    pub fn name(&self) -> &'static str {
        match self {
            Self::KalkerLinear => "kalker-linear",
            Self::ShenHedrickElkins => "shen-hedrick-elkins",
            Self::Polach(_) => "polach",
            Self::Fastsim(_) => "fastsim",
            Self::ModifiedFastsim(..) => "modified-fastsim",
            Self::Table(_) => "table",
        }
    }

    /// Whether it computes the traction at every point, with temperatures, rather than forces only.
    pub fn has_fields(&self) -> bool {
        matches!(self, Self::Fastsim(_) | Self::ModifiedFastsim(..))
    }

    /// Whether it computes derivatives of the forces.
    pub fn has_derivatives(&self) -> bool {
        matches!(self, Self::Table(_))
    }

    /// Checks the parameters of the method.
    pub fn check(&self) -> Result<(), Error> {
        match self {
            Self::Polach(reduction) => reduction.check(),
            Self::ModifiedFastsim(_, reduction) => reduction.check(),
            Self::KalkerLinear | Self::ShenHedrickElkins | Self::Fastsim(_) | Self::Table(_) => {
                Ok(())
            }
        }
    }
}

impl AreaReduction {
    fn check(self) -> Result<(), Error> {
        let Self { area_adhesion, area_slip } = self;
        part(Quantity::PolachAreaAdhesion, area_adhesion)?;
        part(Quantity::PolachAreaSlip, area_slip)?;
        let at_most = Requirement::UpTo(Quantity::PolachAreaAdhesion, area_adhesion);
        require(Quantity::PolachAreaSlip, at_most, area_slip)
    }
}

impl SlopeReduction {
    fn check(self) -> Result<(), Error> {
        let Self { initial, limit_ratio, decay } = self;
        part(Quantity::InitialReduction, initial)?;
        require(Quantity::ReductionLimitRatio, Requirement::Between(0.0, 1.0), limit_ratio)?;
        require(Quantity::ReductionDecay, Requirement::NotNegative, decay)
    }
}

fn part(quantity: Quantity, value: f64) -> Result<(), Error> {
    require(quantity, Requirement::AboveUpTo(0.0, 1.0), value)
}

/// By its name.
#[cfg(feature = "serde")]
impl serde::Serialize for Method {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impossible_parameters_are_named() {
        let message = |method: FastMethod| method.check().unwrap_err().to_string();
        let polach = |area_adhesion, area_slip| {
            FastMethod::Polach(AreaReduction { area_adhesion, area_slip })
        };
        assert!(message(polach(1.1, 0.4)).starts_with("polach_area_adhesion"));
        assert!(message(polach(0.5, 0.0)).starts_with("polach_area_slip"));
        assert!(message(polach(0.3, 0.4)).contains("between 0 and polach_area_adhesion = 0.3"));
        let modified = |initial, limit_ratio, decay| {
            let reduction = SlopeReduction { initial, limit_ratio, decay };
            FastMethod::ModifiedFastsim(Brush::KALKER, reduction)
        };
        assert!(message(modified(f64::NAN, 0.1, 1.0)).starts_with("initial_reduction"));
        assert!(message(modified(1.0, 1.1, 1.0)).starts_with("reduction_limit_ratio"));
        assert!(message(modified(1.0, 0.1, -1.0)).starts_with("reduction_decay"));
        assert_eq!(polach(1.0, 1.0).check(), Ok(()));
    }
}
