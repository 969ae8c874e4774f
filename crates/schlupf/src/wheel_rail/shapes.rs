//! What determines wheels and rails and where they are.

use super::deviation::Deviation;
use super::surface::Surface;

/// A wheel of a wheelset.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelShape {
    /// Profile: z up, zero where the radius is the nominal one.
    pub profile: Surface,
    /// Nominal rolling radius, in m.
    pub nominal_radius: f64,
    /// Position y of the flange back in the coordinates of the profile, in m; negative.
    pub flange_back_position: f64,
    /// How it deviates from its place in the wheelset, as seen from the left.
    pub deviation: Deviation,
}

/// A rail, or a roller of a test rig.
#[derive(Debug, Clone, PartialEq)]
pub struct RailShape {
    /// Profile, with z up; of a roller zero where the radius is the nominal one, and the same
    /// everywhere.
    pub profile: Surface,
    /// Inclination towards the middle of the track as a slope, such as 1/40; dimensionless.
    pub cant: f64,
    /// Where it is.
    pub place: RailPlace,
    /// Nominal radius of a roller, whose axle is so far below the origin of the track, in m;
    /// infinite for a rail.
    pub radius: f64,
    /// How it deviates from its place in the track, as seen from the left.
    pub deviation: Deviation,
}

/// Where the profile of a rail is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RailPlace {
    /// Its gauge point, the inmost point down to the gauge depth, is half the gauge from the middle
    /// of the track; its top is at z = 0, or if it is that of a roller, its origin. Of sections
    /// the first one counts.
    Gauge,
    /// Its origin is at y (outwards) and z in the track, in m.
    Origin([f64; 2]),
}

/// What determines where the profiles are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Distance of the gauge faces, in m.
    pub gauge: f64,
    /// Depth below the top of the rail down to which the gauge is measured, in m.
    pub gauge_depth: f64,
    /// Distance of the flange backs of the wheelset, in m.
    pub flange_back_distance: f64,
}

impl Default for Track {
    /// 1435 mm, 14 mm below the top of the rail; 1360 mm between the flange backs.
    fn default() -> Self {
        Self { gauge: 1.435, gauge_depth: 14e-3, flange_back_distance: 1.360 }
    }
}

impl RailShape {
    /// A straight rail that is placed by its gauge, with a cant as a slope, dimensionless.
    pub fn new(profile: impl Into<Surface>, cant: f64) -> Self {
        let (profile, place) = (profile.into(), RailPlace::Gauge);
        let deviation = Deviation::default();
        Self { profile, cant, place, radius: f64::INFINITY, deviation }
    }
}
