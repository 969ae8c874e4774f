//! The surface of a wheel or a rail: the same profile everywhere, or sections that change along
//! the way.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use super::profile_curve::{CurvePoint, ProfileCurve};
use super::sections::{Sections, SurfacePoint};

/// The surface of a wheel or a rail.
#[derive(Debug, Clone, PartialEq)]
pub enum Surface {
    /// One profile, of a body of revolution or a prism.
    Uniform(ProfileCurve),
    /// Sections.
    Varying(Varying),
}

/// Sections as they pass a wheelset.
#[derive(Debug, Clone, PartialEq)]
pub struct Varying {
    sections: Arc<Sections>,
    /// The place that is at the wheelset: of a rail at x = 0 in m, of a wheel below the axle in
    /// rad.
    at: f64,
    /// Whether the way leads around a wheel.
    is_round: bool,
    /// By which the profiles are turned (in rad) and then moved (in m).
    placed: (f64, [f64; 2]),
}

impl From<ProfileCurve> for Surface {
    fn from(curve: ProfileCurve) -> Self {
        Self::Uniform(curve)
    }
}

impl Surface {
    /// A rail whose place `at` (in m) is at x = 0.
    pub fn along(sections: Arc<Sections>, at: f64) -> Self {
        Self::Varying(Varying { sections, at, is_round: false, placed: (0.0, [0.0; 2]) })
    }

    /// A wheel whose angle `at` (in rad) is below the axle.
    pub fn around(sections: Arc<Sections>, at: f64) -> Self {
        Self::Varying(Varying { sections, at, is_round: true, placed: (0.0, [0.0; 2]) })
    }

    /// Whether it changes along the way.
    pub fn is_varying(&self) -> bool {
        matches!(self, Self::Varying(_))
    }

    /// Its profile, or that of its first section.
    pub(super) fn first(&self) -> ProfileCurve {
        match self {
            Self::Uniform(curve) => curve.clone(),
            Self::Varying(Varying { sections, placed: (angle, way), .. }) => {
                sections.first().placed(*angle, *way)
            }
        }
    }

    /// Its profile if it is the same everywhere.
    pub fn uniform(&self) -> Option<&ProfileCurve> {
        match self {
            Self::Uniform(curve) => Some(curve),
            Self::Varying(_) => None,
        }
    }

    /// The lengths along the profile, of which that of sections is no arc length, in m.
    pub fn length(&self) -> f64 {
        match self {
            Self::Uniform(curve) => curve.length(),
            Self::Varying(varying) => varying.sections.length(),
        }
    }

    pub(super) fn is_smoothed(&self) -> bool {
        match self {
            Self::Uniform(curve) => curve.smoothing() > 0.0,
            Self::Varying(varying) => varying.sections.is_smoothed(),
        }
    }

    /// The point at a place along the way (from the wheelset; in m or rad) and along the profile
    /// (in m), if there is one.
    pub(super) fn at(&self, way: f64, along: f64) -> Option<SurfacePoint> {
        match self {
            Self::Uniform(curve) => Some(SurfacePoint { point: curve.at(along), rate: [0.0; 2] }),
            Self::Varying(varying) => varying.at(way, along),
        }
    }

    /// The point of its section there.
    pub fn point(&self, way: f64, along: f64) -> Option<CurvePoint> {
        Some(self.at(way, along)?.point)
    }

    /// The same with its profile turned by an angle (in rad, from y towards z), then moved by `way`
    /// (in m).
    #[must_use]
    pub fn placed(&self, angle: f64, way: [f64; 2]) -> Self {
        match self {
            Self::Uniform(curve) => Self::Uniform(curve.placed(angle, way)),
            Self::Varying(varying) => {
                let (before, [y, z]) = varying.placed;
                let (sin, cos) = angle.sin_cos();
                let moved = [cos * y - sin * z + way[0], sin * y + cos * z + way[1]];
                Self::Varying(Varying { placed: (before + angle, moved), ..varying.clone() })
            }
        }
    }
}

impl Varying {
    fn at(&self, way: f64, along: f64) -> Option<SurfacePoint> {
        let mut place = self.at + way;
        if self.is_round {
            place = (place + PI).rem_euclid(TAU) - PI;
        }
        let SurfacePoint { point, rate } = self.sections.at(place, along)?;
        let (angle, [y, z]) = self.placed;
        let (sin, cos) = angle.sin_cos();
        let turned = |[y, z]: [f64; 2]| [cos * y - sin * z, sin * y + cos * z];
        let place = turned(point.place);
        let point = CurvePoint {
            place: [place[0] + y, place[1] + z],
            tangent: turned(point.tangent),
            bend: turned(point.bend),
        };
        Some(SurfacePoint { point, rate: turned(rate) })
    }
}
