//! Traction of a point as a function of its sliding, Eq. (8).
//!
//! All laws are written for the traction on the *rail* divided by μ pₙ, q = −t/(μ pₙ): it points
//! along the sliding of the wheel, which avoids minus signs.

use crate::reporting::{Error, Quantity, require_positive};

/// A law for the tangential traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLaw {
    /// Coulomb's law, the limit k_c → ∞ of both others: a point either does not slide at all, with
    /// any |q| ≤ 1, or it slides with q along its sliding.
    Coulomb,
    /// From every increment of the sliding.
    Incremental(Incremental),
    /// From the sliding distance since entry.
    TotalDisplacement(TotalDisplacement),
}

/// Eq. (8) applied to increments, correct for any path: dq = k_c (ds − q |ds|), q = 0 on entry.
///
/// Equal to [`TotalDisplacement`] for straight monotonic sliding. (Dahl 1968 has the same law for
/// friction in bearings.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Incremental {
    stiffness: f64,
}

/// Eq. (8) of Neuhaus and Sextro (2014) in terms of the total sliding distance δ since entry: q =
/// (1 − exp(−k_c |δ|)) δ/|δ|. It holds for monotonic sliding in one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TotalDisplacement {
    stiffness: f64,
}

impl Default for Incremental {
    /// The law with [`Self::DEFAULT_STIFFNESS`].
    fn default() -> Self {
        Self { stiffness: Self::DEFAULT_STIFFNESS }
    }
}

impl Incremental {
    /// Default exponent k_c for unknown roughness, in 1/m.
    pub const DEFAULT_STIFFNESS: f64 = 5e6;

    /// The exponent k_c, in 1/m.
    ///
    /// # Errors
    /// One that is not positive.
    pub fn new(stiffness: f64) -> Result<Self, Error> {
        require_positive(Quantity::ContactStiffness, stiffness)?;
        Ok(Self { stiffness })
    }
}

impl TotalDisplacement {
    /// The exponent k_c, in 1/m.
    ///
    /// # Errors
    /// One that is not positive.
    pub fn new(stiffness: f64) -> Result<Self, Error> {
        require_positive(Quantity::ContactStiffness, stiffness)?;
        Ok(Self { stiffness })
    }
}

impl From<Incremental> for ContactLaw {
    fn from(law: Incremental) -> Self {
        Self::Incremental(law)
    }
}

impl From<TotalDisplacement> for ContactLaw {
    fn from(law: TotalDisplacement) -> Self {
        Self::TotalDisplacement(law)
    }
}

impl Default for ContactLaw {
    /// That of [`Incremental::default`].
    fn default() -> Self {
        Incremental::default().into()
    }
}

impl ContactLaw {
    /// The exponent k_c (in 1/m), which is infinite for Coulomb's law.
    pub fn stiffness(&self) -> f64 {
        match self {
            Self::Coulomb => f64::INFINITY,
            Self::Incremental(law) => law.stiffness,
            Self::TotalDisplacement(law) => law.stiffness,
        }
    }

    /// The same law with another k_c (in 1/m); `None` for Coulomb's law, which has none.
    ///
    /// # Errors
    /// One that is not positive.
    pub fn with_stiffness(&self, stiffness: f64) -> Result<Option<Self>, Error> {
        Ok(match self {
            Self::Coulomb => None,
            Self::Incremental(_) => Some(Incremental::new(stiffness)?.into()),
            Self::TotalDisplacement(_) => Some(TotalDisplacement::new(stiffness)?.into()),
        })
    }

    /// Whether this is Coulomb's law.
    pub fn is_coulomb(&self) -> bool {
        *self == Self::Coulomb
    }
}
