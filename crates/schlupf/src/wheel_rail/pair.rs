//! A wheel and a rail of one side, each in its place.
//!
//! Everything in this module and below is that of the *left* wheel, so y points outwards; a right
//! wheel is solved as the mirror image of a left one.

use super::deviation::Deviation;
use super::pose::{Pose, plus};
use super::profile_curve::{CurvePoint, ProfileCurve};
use super::rail_relief::RailRelief;
use super::seen::{Across, FLATTEST, Seen};
use super::shapes::{RailPlace, RailShape, Track, WheelShape};
use super::surface::Surface;
use crate::reporting::{Error, Quantity, Requirement, WheelRailError, require};

/// Bounds of lengths of the track and of the wheelset, in m.
const LENGTH: Requirement = Requirement::Between(1e-3, 10.0);

/// Largest angle by which a rail may lean, as a slope, dimensionless.
const STEEPEST_CANT: f64 = 0.5;

/// Step along a profile at which it is searched, in m.
const STEP: f64 = 1e-5;

/// Newton steps to a given y on the rail, and the least part of y in the rail's direction with
/// which they go.
const STEPS: usize = 6;
const SLOWEST: f64 = 0.05;

/// Bounds of the radius of a roller, in m.
const ROLLER: Requirement = Requirement::Between(1e-3, 1e4);

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
    pub(super) wheel: Surface,
    /// Along its profile at small steps; nothing where it is too steep to be seen from below.
    pub(super) candidates: Vec<Option<Candidate>>,
    /// Lowest and highest y of the wheel's profile, in m.
    pub(super) wheel_span: [f64; 2],
    /// In m.
    pub(super) nominal_radius: f64,
    /// Distance of the origin of the wheel's profile from the middle of the wheelset, in m.
    pub(super) wheel_offset: f64,
    /// The axes of the wheel in those of the wheelset.
    wheel_in_set: Pose,
    pub(super) wheel_deviation: Deviation,
    pub(super) rail_deviation: Deviation,
    /// Nominal radius of a roller, in m.
    pub(super) roller: Option<f64>,
    /// The rail's profile in its own coordinates.
    pub(super) rail_profile: Surface,
    /// In the track frame.
    pub(super) rail: Surface,
    pub(super) across: Across,
    /// What is seen of it at those positions.
    pub(super) rail_from_above: Vec<Option<Seen>>,
    /// The rail at steps along the track, if it or the wheel changes along the way.
    pub(super) relief: Option<RailRelief>,
    /// Origin of the rail's profile in the track frame, y and z in m.
    pub(super) rail_origin: [f64; 2],
    /// In m.
    gauge_depth: Option<f64>,
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
        let points = self.arc.iter().zip(&self.points);
        points.map(|(arc, point)| Candidate::new(*arc, point, nominal_radius)).collect()
    }
}

impl Candidate {
    /// A point of the profile at an arc length, of a wheel of a nominal radius; in m.
    pub fn new(arc: f64, point: &CurvePoint, nominal_radius: f64) -> Option<Self> {
        let ([y, z], [along, up]) = (point.place, point.tangent);
        let (radius, slope) = (nominal_radius - z, up / along);
        (along >= FLATTEST).then_some(Self { arc, y, radius, slope })
    }
}

impl Pair {
    /// Places the profiles: the rail turned by its cant about the origin of its profile and where
    /// it is said to be, the wheel with its flange back half their distance from the middle of the
    /// wheelset; then both as they deviate.
    ///
    /// # Errors
    /// A length that cannot be, or a profile without a running surface.
    pub fn new(wheel: &WheelShape, rail: &RailShape, track: &Track) -> Result<Self, Error> {
        require(Quantity::WheelRadiusX, LENGTH, wheel.nominal_radius)?;
        require(Quantity::Gauge, LENGTH, track.gauge)?;
        require(Quantity::GaugeDepth, Requirement::Between(0.0, 1.0), track.gauge_depth)?;
        let between = Requirement::Magnitude(10.0);
        require(Quantity::FlangeBackDistance, between, track.flange_back_distance)?;
        let position = Requirement::Between(-1.0, 1.0);
        require(Quantity::FlangeBackPosition, position, wheel.flange_back_position)?;
        require(Quantity::RailCant, Requirement::Magnitude(STEEPEST_CANT), rail.cant)?;
        let roller = (rail.radius != f64::INFINITY).then_some(rail.radius);
        if let Some(radius) = roller {
            require(Quantity::RailRadiusX, ROLLER, radius)?;
            if rail.profile.is_varying() {
                return Err(WheelRailError::VaryingRoller {}.into());
            }
        }
        wheel.deviation.check(Quantity::WheelDeviation)?;
        rail.deviation.check(Quantity::RailDeviation)?;
        let cant = rail.cant.atan();
        let (origin, gauge_depth) = rail_origin(rail, track)?;
        let Deviation { displacement: [_, dy, dz], roll, .. } = rail.deviation;
        let rail_origin = [origin[0] + dy, origin[1] + dz];
        let in_track = rail.profile.placed(cant + roll, rail_origin);
        let on_wheel = Samples::new(&wheel.profile.first());
        require_surface(&on_wheel, Quantity::WheelProfile)?;
        let on_rail = Samples::new(&in_track.first());
        require_surface(&on_rail, Quantity::RailProfile)?;
        let across = Across::between(on_rail.span());
        let wheel_offset = 0.5 * track.flange_back_distance - wheel.flange_back_position;
        Ok(Self {
            wheel: wheel.profile.clone(),
            candidates: on_wheel.candidates(wheel.nominal_radius),
            wheel_span: on_wheel.span(),
            nominal_radius: wheel.nominal_radius,
            wheel_offset,
            wheel_in_set: wheel.deviation.pose([0.0, wheel_offset, -wheel.nominal_radius]),
            wheel_deviation: wheel.deviation,
            rail_deviation: rail.deviation,
            roller,
            rail_from_above: across.rail(&on_rail.arc, &on_rail.points),
            across,
            relief: (wheel.profile.is_varying() || in_track.is_varying())
                .then(|| RailRelief::new(&in_track, wheel.nominal_radius)),
            rail_profile: rail.profile.clone(),
            rail: in_track,
            rail_origin,
            gauge_depth,
        })
    }

    /// The wheel in the track, in a wheelset there.
    pub(super) fn wheel_in(&self, wheelset: &Pose) -> Pose {
        wheelset.then(&self.wheel_in_set)
    }

    /// Origin of the wheel's profile in the axes of the wheelset, in m.
    pub(super) fn wheel_origin(&self) -> [f64; 3] {
        let place = [0.0, self.wheel_offset, -self.nominal_radius];
        plus(place, self.wheel_deviation.displacement)
    }

    /// Radius (in m) that a wheel above a plane has for the same distance along rolling.
    pub(super) fn radius_along(&self) -> f64 {
        let curvature = self.roller.map_or(0.0, f64::recip) + self.nominal_radius.recip();
        curvature.recip()
    }

    /// Arc length of the rail at x and y, from a guess; all in m.
    pub(super) fn rail_arc(&self, [x, y]: [f64; 2], guess: f64) -> f64 {
        let mut arc = guess;
        for _ in 0..STEPS {
            let Some(point) = self.rail.point(x, arc) else { break };
            arc += (y - point.place[0]) / point.tangent[0].max(SLOWEST);
        }
        arc
    }

    /// Height (in m) at x of what is at `z` at x = 0 (in m): on a roller, on its circle.
    pub(super) fn rail_height(&self, x: f64, z: f64) -> f64 {
        self.roller.map_or(z, |radius| ((radius + z).powi(2) - x * x).sqrt() - radius)
    }

    /// An error for a contact at a lateral position in the track (in m) that reaches the end of the
    /// rail's profile, or of the wheel's, near arc lengths on the rail and on the wheel (in m).
    pub(super) fn at_end(&self, is_rail: bool, arcs: [f64; 2], position: f64) -> Error {
        let (profile, curve, arc) = if is_rail {
            (Quantity::RailProfile, &self.rail_profile, arcs[0])
        } else {
            (Quantity::WheelProfile, &self.wheel, arcs[1])
        };
        let end = curve.point(0.0, arc.clamp(0.0, curve.length()));
        let end = end.map_or(f64::NAN, |point| point.place[0]);
        WheelRailError::AtProfileEnd { profile, end, position }.into()
    }

    /// Depth below the top of the rail down to which its gauge is measured, if it is, in m: less
    /// than asked for where the profile ends above, so that the rail is too far inwards.
    pub fn gauge_depth(&self) -> Option<f64> {
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

    /// Height of the axle over z = 0 of the track in the nominal position, in m.
    pub fn nominal_radius(&self) -> f64 {
        self.nominal_radius
    }

    /// Whether wheel or rail deviate with a velocity.
    pub(crate) fn is_moving(&self) -> bool {
        self.wheel_deviation.is_moving() || self.rail_deviation.is_moving()
    }

    /// The rail in the track, y outwards.
    pub fn rail(&self) -> &Surface {
        &self.rail
    }

    /// The wheel in its own coordinates.
    pub fn wheel(&self) -> &Surface {
        &self.wheel
    }
}

/// The origin of the profile of a rail in the track, and the depth down to which its gauge was
/// measured, if it was; in m.
fn rail_origin(rail: &RailShape, track: &Track) -> Result<([f64; 2], Option<f64>), Error> {
    if let RailPlace::Origin(place) = rail.place {
        for part in place {
            require(Quantity::RailOrigin, Requirement::Magnitude(10.0), part)?;
        }
        return Ok((place, None));
    }
    let samples = Samples::new(&rail.profile.first().placed(rail.cant.atan(), [0.0; 2]));
    require_surface(&samples, Quantity::RailProfile)?;
    let GaugePoint { inmost, top, depth } = gauge_point(&samples, track.gauge_depth);
    let z = if rail.radius.is_finite() { 0.0 } else { -top };
    Ok(([0.5 * track.gauge - inmost, z], Some(depth)))
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
