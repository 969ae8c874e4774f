//! Wheels and rails in their places, on both sides: their profiles, `[track]`, and what each side
//! has of its own.

use std::sync::Arc;

use schlupf::reporting::readable;
use schlupf::wheel_rail::{Deviation, Pair, RailPlace, RailShape, Side, Sides, Track, WheelShape};

use crate::FieldPath;
use crate::error::CaseError;
use crate::notice::Notice;
use crate::profiles::{self, Profile, ProfileFields, ProfileReading, Shape};
use crate::settings::Settings;
use crate::side::sided;

const TRACK_POSITION: FieldPath = field!("wheelset.track_position");

/// Difference of two depths that counts as none, in m.
const SAME_DEPTH: f64 = 1e-6;

/// The wheels and rails of both sides.
pub struct Placed {
    /// Where they are, each as seen from the left.
    pub pairs: Sides<Arc<Pair>>,
    /// What was read of the profiles.
    pub readings: Vec<ProfileReading>,
    /// What users should know of them.
    pub notices: Vec<Notice>,
}

/// The pairs of the last case, with what they were made of.
struct Made {
    shapes: [(WheelShape, RailShape); 2],
    track: Track,
    pairs: Sides<Arc<Pair>>,
}

/// Places the profiles of both sides; where these have the same, both have one pair.
pub fn placed(settings: &Settings) -> Result<Placed, CaseError> {
    let wheels = read(settings, profiles::of_wheel)?;
    let rails = read(settings, profiles::of_rail)?;
    let track = Track {
        gauge: settings.number(field!("track.gauge"))?,
        gauge_depth: settings.number(field!("track.gauge_depth"))?,
        flange_back_distance: settings.number(field!("track.flange_back_distance"))?,
    };
    let shapes = |side| -> Result<(WheelShape, RailShape), CaseError> {
        Ok((wheel(settings, side, wheels.of(side))?, rail(settings, side, rails.of(side))?))
    };
    let pair = |(wheel, rail): &(WheelShape, RailShape)| {
        Pair::new(wheel, rail, &track).map(Arc::new).map_err(|error| settings.explain(&error))
    };
    let shapes = [shapes(Side::Left)?, shapes(Side::Right)?];
    let key = vec![b"pairs".to_vec()];
    let known: Option<Arc<Made>> = settings.kept.known(&key);
    let known = known.filter(|made| made.shapes == shapes && made.track == track);
    let pairs = if let Some(made) = known {
        made.pairs.clone()
    } else {
        let [left, right] = &shapes;
        let pairs = if left == right {
            Sides::both(pair(left)?)
        } else {
            Sides { left: pair(left)?, right: pair(right)? }
        };
        settings.kept.keep(key, &Arc::new(Made { shapes, track, pairs: pairs.clone() }));
        pairs
    };
    let mut found = Placed { pairs, readings: Vec::new(), notices: Vec::new() };
    for profile in [&wheels.left, &wheels.right, &rails.left, &rails.right] {
        note(&mut found.readings, profile.reading.clone());
        for notice in &profile.notices {
            note(&mut found.notices, notice.clone());
        }
    }
    for side in [Side::Left, Side::Right] {
        if let Some(notice) = too_short(found.pairs.of(side), rails.of(side), &track) {
            note(&mut found.notices, notice);
        }
    }
    Ok(found)
}

/// Adds what is new.
fn note<T: PartialEq>(all: &mut Vec<T>, one: T) {
    if !all.contains(&one) {
        all.push(one);
    }
}

/// The profiles of both sides; where they are the same, it is read once.
fn read(
    settings: &Settings,
    fields: fn(&Settings, Side) -> ProfileFields,
) -> Result<Sides<Profile>, CaseError> {
    let [left, right] = [Side::Left, Side::Right].map(|side| fields(settings, side));
    let read = |fields| profiles::read(settings, fields);
    if left == right {
        return read(&left).map(Sides::both);
    }
    Ok(Sides { left: read(&left)?, right: read(&right)? })
}

/// A rail that ends above the gauge depth.
fn too_short(pair: &Pair, rail: &Profile, track: &Track) -> Option<Notice> {
    let (reached, wanted) = (pair.gauge_depth()?, track.gauge_depth);
    // Below a lip that is the inmost point nothing runs, but the file goes on.
    let ProfileReading { points: [all, running], size: [_, height], .. } = rail.reading;
    let goes_on = all > running && height > wanted;
    let is_short = wanted - reached > SAME_DEPTH && !goes_on;
    is_short.then_some(Notice::GaugeDepthNotReached { reached, wanted })
}

fn wheel(settings: &Settings, side: Side, profile: &Profile) -> Result<WheelShape, CaseError> {
    let nominal_radius = settings.number(field!("wheel.radius_x"))?;
    let own_radius = sided!("wheel", "radius_x").number(settings, side)?;
    let pitch = settings.number(field!("wheelset.pitch_angle"))?;
    Ok(WheelShape {
        profile: profile.shape.surface(pitch).placed(0.0, [0.0, nominal_radius - own_radius]),
        nominal_radius,
        flange_back_position: profile.flange_back,
        deviation: deviation(settings, side, &DEVIATION_OF_WHEEL)?,
    })
}

fn rail(settings: &Settings, side: Side, profile: &Profile) -> Result<RailShape, CaseError> {
    let origin = sided!("rail", "origin_y").of(settings, side);
    let place = match settings.optional_number(origin)? {
        Some(y) => RailPlace::Origin([y, sided!("rail", "origin_z").number(settings, side)?]),
        None => RailPlace::Gauge,
    };
    let along = settings.number(TRACK_POSITION)?;
    if let Shape::Along(sections) = &profile.shape {
        let [from, to] = sections.span();
        if !(from..=to).contains(&along) {
            let [from, to] = [from, to].map(readable);
            let message = format!(
                "{TRACK_POSITION} must be within the slices of {}, from {from} m to {to} m, but is {} m",
                profile.reading.name,
                readable(along)
            );
            return Err(settings.error(TRACK_POSITION, message));
        }
    }
    Ok(RailShape {
        profile: profile.shape.surface(along),
        cant: sided!("rail", "cant").number(settings, side)?,
        place,
        radius: settings.number(field!("rail.radius_x"))?,
        deviation: deviation(settings, side, &DEVIATION_OF_RAIL)?,
    })
}

/// Fields of a deviation along or about x, y and z, of the left and of the right side; where there
/// is none, it does not deviate so.
struct DeviationFields {
    displacement: [Option<[FieldPath; 2]>; 3],
    angles: [Option<[FieldPath; 2]>; 2],
    velocity: [Option<[FieldPath; 2]>; 3],
    turning: [Option<[FieldPath; 2]>; 3],
}

macro_rules! own {
    ($body:literal, $name:literal) => {
        Some([field!("left_", $body, ".", $name), field!("right_", $body, ".", $name)])
    };
}

const DEVIATION_OF_WHEEL: DeviationFields = DeviationFields {
    displacement: [
        own!("wheel", "longitudinal_displacement"),
        own!("wheel", "lateral_displacement"),
        own!("wheel", "vertical_displacement"),
    ],
    angles: [own!("wheel", "roll_angle"), own!("wheel", "yaw_angle")],
    velocity: [
        own!("wheel", "longitudinal_velocity"),
        own!("wheel", "lateral_velocity"),
        own!("wheel", "vertical_velocity"),
    ],
    turning: [own!("wheel", "roll_rate"), own!("wheel", "pitch_rate"), own!("wheel", "yaw_rate")],
};

const DEVIATION_OF_RAIL: DeviationFields = DeviationFields {
    displacement: [
        None,
        own!("rail", "lateral_displacement"),
        own!("rail", "vertical_displacement"),
    ],
    angles: [own!("rail", "roll_angle"), None],
    velocity: [None, own!("rail", "lateral_velocity"), own!("rail", "vertical_velocity")],
    turning: [own!("rail", "roll_rate"), None, None],
};

/// How a body deviates, as seen from the left.
fn deviation(
    settings: &Settings,
    side: Side,
    fields: &DeviationFields,
) -> Result<Deviation, CaseError> {
    let number = |paths: Option<[FieldPath; 2]>| match paths {
        Some([left, right]) => {
            let own = settings.optional_number(if side == Side::Left { left } else { right })?;
            Ok(own.unwrap_or(0.0))
        }
        None => Ok(0.0),
    };
    let vector = |[x, y, z]: [Option<[FieldPath; 2]>; 3]| -> Result<[f64; 3], CaseError> {
        Ok([number(x)?, number(y)?, number(z)?])
    };
    let deviation = Deviation {
        displacement: vector(fields.displacement)?,
        roll: number(fields.angles[0])?,
        yaw: number(fields.angles[1])?,
        velocity: vector(fields.velocity)?,
        turning: vector(fields.turning)?,
    };
    Ok(if side == Side::Left { deviation } else { deviation.mirrored() })
}
