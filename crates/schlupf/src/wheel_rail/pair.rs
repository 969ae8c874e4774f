//! A wheel and a rail of one side, each in its place.
//!
//! Everything in this module and below is that of the *left* wheel, so y points outwards; a right
//! wheel is solved as the mirror image of a left one.

use super::profile_curve::{CurvePoint, ProfileCurve};
use super::seen::{Across, FLATTEST, Seen};
use crate::reporting::{Error, Quantity, Requirement, WheelRailError, require};

/// Bounds of lengths of the track and of the wheelset, in m.
const LENGTH: Requirement = Requirement::Between(1e-3, 10.0);

/// Largest angle by which a rail may lean, as a slope, dimensionless.
const STEEPEST_CANT: f64 = 0.5;

/// Step along a profile at which it is searched, in m.
const STEP: f64 = 1e-5;

/// The wheels of a wheelset.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelShape {
    /// Profile: z up, zero where the radius is the nominal one.
    pub profile: ProfileCurve,
    /// Nominal rolling radius, in m.
    pub nominal_radius: f64,
    /// Position y of the flange back in the coordinates of the profile, in m; negative.
    pub flange_back_position: f64,
}

/// The rails of a track.
#[derive(Debug, Clone, PartialEq)]
pub struct RailShape {
    /// Profile, with z up.
    pub profile: ProfileCurve,
    /// Inclination towards the middle of the track as a slope, such as 1/40; dimensionless.
    pub cant: f64,
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

/// Points along a profile at small equal steps.
struct Samples {
    /// Arc lengths, in m.
    arc: Vec<f64>,
    points: Vec<CurvePoint>,
}

/// A point of the wheel's profile that may touch the rail.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    /// Arc length along the profile, in m.
    pub arc: f64,
    /// In the coordinates of the profile, in m.
    pub y: f64,
    /// Radius of the wheel there, in m.
    pub radius: f64,
    /// Slope dz/dy of the profile, dimensionless.
    pub slope: f64,
}

/// The left wheel and the left rail.
#[derive(Debug, Clone)]
pub struct Pair {
    pub(super) wheel: ProfileCurve,
    /// Along its profile at small steps; nothing where it is too steep to be seen from below.
    pub(super) candidates: Vec<Option<Candidate>>,
    /// Lowest and highest y of the wheel's profile, in m.
    pub(super) wheel_span: [f64; 2],
    /// In m.
    pub(super) nominal_radius: f64,
    /// Distance of the origin of the wheel's profile from the middle of the wheelset, in m.
    pub(super) wheel_offset: f64,
    /// The rail's profile in its own coordinates.
    pub(super) rail_profile: ProfileCurve,
    /// In the track frame.
    pub(super) rail: ProfileCurve,
    pub(super) across: Across,
    /// What is seen of it at those positions.
    pub(super) rail_from_above: Vec<Option<Seen>>,
    /// Origin of the rail's profile in the track frame, y and z in m.
    pub(super) rail_origin: [f64; 2],
    /// In m.
    gauge_depth: f64,
}

/// Where the gauge of a rail is measured.
struct GaugePoint {
    /// Inmost y, in m.
    inmost: f64,
    /// z of the top, in m.
    top: f64,
    /// Depth below the top down to which the inmost point was looked for, in m.
    depth: f64,
}

impl Samples {
    fn new(curve: &ProfileCurve) -> Self {
        let count = (curve.length() / STEP).ceil() as usize + 1;
        let step = curve.length() / (count - 1) as f64;
        let arc: Vec<f64> = (0..count).map(|k| k as f64 * step).collect();
        let points = arc.iter().map(|s| curve.at(*s)).collect();
        Self { arc, points }
    }

    /// Lowest and highest y, in m.
    fn span(&self) -> [f64; 2] {
        let y = || self.points.iter().map(|point| point.place[0]);
        [y().fold(f64::INFINITY, f64::min), y().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// As candidates for contact on a wheel of a nominal radius, in m.
    fn candidates(&self, nominal_radius: f64) -> Vec<Option<Candidate>> {
        let candidate = |(arc, point): (&f64, &CurvePoint)| {
            let ([y, z], [along, up]) = (point.place, point.tangent);
            let (radius, slope) = (nominal_radius - z, up / along);
            (along >= FLATTEST).then_some(Candidate { arc: *arc, y, radius, slope })
        };
        self.arc.iter().zip(&self.points).map(candidate).collect()
    }
}

impl Pair {
    /// Places the profiles: the rail turned by its cant about the origin of its profile, its top at
    /// z = 0 and its gauge point, the inmost point down to the gauge depth, half the gauge from the
    /// middle; the wheel with its flange back half their distance from the middle of the wheelset.
    ///
    /// # Errors
    /// A length that cannot be, or a profile without a running surface.
    pub fn new(wheel: &WheelShape, rail: &RailShape, track: &Track) -> Result<Self, Error> {
        require(Quantity::WheelRadiusX, LENGTH, wheel.nominal_radius)?;
        require(Quantity::Gauge, LENGTH, track.gauge)?;
        require(Quantity::GaugeDepth, Requirement::Between(0.0, 1.0), track.gauge_depth)?;
        require(Quantity::FlangeBackDistance, LENGTH, track.flange_back_distance)?;
        let position = Requirement::Between(-1.0, 1.0);
        require(Quantity::FlangeBackPosition, position, wheel.flange_back_position)?;
        require(Quantity::RailCant, Requirement::Magnitude(STEEPEST_CANT), rail.cant)?;
        let turned = rail.profile.placed(rail.cant.atan(), [0.0; 2]);
        let samples = Samples::new(&turned);
        require_surface(&samples, Quantity::RailProfile)?;
        let GaugePoint { inmost, top, depth } = gauge_point(&samples, track.gauge_depth);
        let rail_origin = [0.5 * track.gauge - inmost, -top];
        let in_track = turned.placed(0.0, rail_origin);
        let on_wheel = Samples::new(&wheel.profile);
        require_surface(&on_wheel, Quantity::WheelProfile)?;
        let on_rail = Samples::new(&in_track);
        let across = Across::between(on_rail.span());
        Ok(Self {
            wheel: wheel.profile.clone(),
            candidates: on_wheel.candidates(wheel.nominal_radius),
            wheel_span: on_wheel.span(),
            nominal_radius: wheel.nominal_radius,
            wheel_offset: 0.5 * track.flange_back_distance - wheel.flange_back_position,
            rail_from_above: across.rail(&on_rail.arc, &on_rail.points),
            across,
            rail_profile: rail.profile.clone(),
            rail: in_track,
            rail_origin,
            gauge_depth: depth,
        })
    }

    /// An error for a contact at a lateral position in the track (in m) that reaches the end of the
    /// rail's profile, or of the wheel's, near arc lengths on the rail and on the wheel (in m).
    pub(super) fn at_end(&self, is_rail: bool, arcs: [f64; 2], position: f64) -> Error {
        let (profile, curve, arc) = if is_rail {
            (Quantity::RailProfile, &self.rail_profile, arcs[0])
        } else {
            (Quantity::WheelProfile, &self.wheel, arcs[1])
        };
        let [end, _] = curve.at(arc.clamp(0.0, curve.length())).place;
        WheelRailError::AtProfileEnd { profile, end, position }.into()
    }

    /// Depth below the top of the rail down to which its gauge is measured, in m: less than asked
    /// for where the profile ends above, so that the rail is too far inwards.
    pub fn gauge_depth(&self) -> f64 {
        self.gauge_depth
    }

    /// Origin of the rail's profile in the track, y outwards and z up, in m.
    pub fn rail_origin(&self) -> [f64; 2] {
        self.rail_origin
    }

    /// Distance of the origin of the wheel's profile from the middle of the wheelset, in m.
    pub fn wheel_offset(&self) -> f64 {
        self.wheel_offset
    }

    /// The rail's profile in the track, y outwards.
    pub fn rail(&self) -> &ProfileCurve {
        &self.rail
    }

    /// The wheel's profile in its own coordinates.
    pub fn wheel(&self) -> &ProfileCurve {
        &self.wheel
    }
}

fn require_surface(samples: &Samples, profile: Quantity) -> Result<(), Error> {
    if samples.points.iter().any(|point| point.tangent[0] > FLATTEST) {
        return Ok(());
    }
    Err(WheelRailError::NoRunningSurface { profile }.into())
}

/// The inmost point of a rail down to a depth below its top, in m.
fn gauge_point(samples: &Samples, depth: f64) -> GaugePoint {
    let place = |k: usize| samples.points[k].place;
    let highest = (0..samples.points.len()).max_by(|j, k| place(*j)[1].total_cmp(&place(*k)[1]));
    let highest = highest.unwrap_or(0);
    let top = place(highest)[1];
    let level = top - depth;
    let mut inmost = place(highest)[0];
    for k in (0..highest).rev() {
        let [y, z] = place(k);
        if z < level {
            let [y_above, z_above] = place(k + 1);
            inmost = inmost.min(y_above + (y - y_above) * (level - z_above) / (z - z_above));
            return GaugePoint { inmost, top, depth };
        }
        inmost = inmost.min(y);
    }
    GaugePoint { inmost, top, depth: top - place(0)[1] }
}
