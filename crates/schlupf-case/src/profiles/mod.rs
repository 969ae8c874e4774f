//! Profiles of wheels and rails: files of several formats, and some that are built in.
//!
//! A file is read as its points in metres, in the axes of the file; then y is made to point
//! outwards and z upwards.

mod built_in;
mod miniprof;
mod plain;
mod points;
mod simpack;

use std::ffi::OsStr;
use std::path::Path;

use schlupf::Quantity;
use schlupf::wheel_rail::ProfileCurve;

use crate::error::CaseError;
use crate::fields::choice::{LateralAxis, VerticalAxis};
use crate::settings::Settings;

pub use built_in::is_name as is_built_in;

/// Paths of the fields of a profile.
#[derive(Debug)]
pub struct ProfileFields {
    profile: &'static str,
    z: &'static str,
    y: &'static str,
    smoothing: &'static str,
    quantity: Quantity,
    is_wheel: bool,
}

/// Those of the wheel.
pub const WHEEL: ProfileFields = ProfileFields {
    profile: "wheel.profile",
    z: "wheel.profile_z",
    y: "wheel.profile_y",
    smoothing: "wheel.profile_smoothing",
    quantity: Quantity::WheelProfile,
    is_wheel: true,
};

/// Those of the rail.
pub const RAIL: ProfileFields = ProfileFields {
    profile: "rail.profile",
    z: "rail.profile_z",
    y: "rail.profile_y",
    smoothing: "rail.profile_smoothing",
    quantity: Quantity::RailProfile,
    is_wheel: false,
};

/// The curve of a profile, y outwards and z up.
pub fn curve(settings: &Settings, fields: &ProfileFields) -> Result<ProfileCurve, CaseError> {
    let smoothing = settings.number(fields.smoothing)?;
    let name = settings.text(fields.profile)?;
    let points = match built_in::points(&name, fields.is_wheel) {
        Some(points) => points,
        None => oriented(settings, fields, read(settings, fields)?)?,
    };
    ProfileCurve::new(&points, smoothing, fields.quantity)
        .map_err(|error| settings.error(fields.profile, error.text(&settings.names())))
}

/// The points of a file, in its axes.
fn read(settings: &Settings, fields: &ProfileFields) -> Result<Vec<[f64; 2]>, CaseError> {
    let (name, bytes) = settings.read_file(fields.profile).map_err(|error| {
        let names = built_in::names(fields.is_wheel);
        error.help(format!("paths are relative to the case file; built in are {names}"))
    })?;
    let ending = Path::new(&name).extension().map(OsStr::to_ascii_lowercase);
    let file = points::File::new(name, bytes, fields.profile)?;
    match ending.as_ref().and_then(|ending| ending.to_str()) {
        Some("prr" | "prw") => simpack::read(&file),
        Some("ban" | "whl") => miniprof::read(&file),
        _ if simpack::is_one(&file) => simpack::read(&file),
        _ if miniprof::is_one(&file) => miniprof::read(&file),
        _ => plain::read(&file),
    }
}

/// The points with y outwards and z up.
fn oriented(
    settings: &Settings,
    fields: &ProfileFields,
    mut points: Vec<[f64; 2]>,
) -> Result<Vec<[f64; 2]>, CaseError> {
    let is_down = match settings.chosen(fields.z)? {
        VerticalAxis::Up => false,
        VerticalAxis::Down => true,
        VerticalAxis::Auto => points::is_upside_down(&points),
    };
    if is_down {
        for [_, z] in &mut points {
            *z = -*z;
        }
    }
    let is_inwards = match settings.chosen(fields.y)? {
        LateralAxis::Outwards => false,
        LateralAxis::Inwards => true,
        LateralAxis::Auto => fields.is_wheel && points::has_flange_outside(&points),
    };
    if is_inwards {
        for [y, _] in &mut points {
            *y = -*y;
        }
    }
    Ok(points)
}
