//! `[kinematics]`.

use schlupf::bodies::{Kinematics, ReferencePoint};
use schlupf::problem::{LongitudinalForce, PrescribedForces};

use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::choice::{NormalModel, Reference};
use crate::fields::readable;
use crate::settings::Settings;

/// v0: the speed of the vehicle, or that of the circumference of a roller.
pub fn speed(settings: &Settings) -> Result<f64, CaseError> {
    const TURNING: FieldPath = field!("rail.angular_velocity");
    const RADIUS: FieldPath = field!("rail.radius_x");
    let Some(angular_velocity) = settings.optional_number(TURNING)? else {
        return settings.number(field!("kinematics.speed"));
    };
    let radius = settings.number(RADIUS)?;
    let speed = angular_velocity * radius;
    if speed > 0.0 && speed.is_finite() {
        return Ok(speed);
    }
    if radius.is_infinite() {
        let message = format!("{TURNING} is that of a roller, which needs its {RADIUS}");
        return Err(settings.error(TURNING, message));
    }
    let message = format!(
        "{TURNING} and {RADIUS} must be positive, for a roller to roll forwards, but are {} and {}",
        settings.shown(TURNING),
        settings.shown(RADIUS)
    );
    Err(settings.error(TURNING, message))
}

/// Rolling radius of the wheel, in m: with two profiles the nominal one.
pub fn rolling_radius(settings: &Settings) -> Result<f64, CaseError> {
    settings.number(match settings.chosen(field!("normal.model"))? {
        NormalModel::WheelRail => field!("wheel.radius_x"),
        _ => field!("kinematics.wheel_radius"),
    })
}

/// Creepages as given, or from the angular velocity and the yaw angle, in any combination.
pub fn kinematics(settings: &Settings) -> Result<Kinematics, CaseError> {
    let speed = speed(settings)?;
    if settings.chosen::<NormalModel>(field!("normal.model"))? == NormalModel::WheelRail {
        // Creepages follow from the motion of the wheelset.
        return Ok(Kinematics::free_rolling(speed));
    }
    let yaw_angle = settings.optional_number(field!("kinematics.yaw_angle"))?;
    let creepage_y = match yaw_angle {
        Some(angle) => -angle.sin(),
        None => settings.number(field!("kinematics.creepage_y"))?,
    };
    let creepage_x = match settings.optional_number(field!("kinematics.angular_velocity"))? {
        Some(angular_velocity) => {
            let radius = settings.number(field!("kinematics.wheel_radius"))?;
            let angle = yaw_angle.unwrap_or_else(|| -creepage_y.asin());
            let wheel = Kinematics::from_wheel(speed, angular_velocity, radius, angle);
            check_rolling(settings, &wheel)?;
            wheel.creepage_x
        }
        None => settings.number(field!("kinematics.creepage_x"))?,
    };
    let spin = settings.number(field!("kinematics.spin"))?;
    Ok(Kinematics { creepage_x, creepage_y, spin, ..Kinematics::free_rolling(speed) })
}

const FORCES: [FieldPath; 5] = fields![
    "kinematics.force_x",
    "kinematics.traction_coefficient",
    "kinematics.wheel_torque",
    "kinematics.force_y",
    "kinematics.moment_z",
];

/// Forces in place of creepages.
pub fn prescribed(settings: &Settings) -> Result<PrescribedForces, CaseError> {
    let [force_x, over_load, torque, y, moment_z] =
        FORCES.map(|path| settings.optional_number(path));
    let mut x = force_x?.map(LongitudinalForce::Force);
    x = x.or(over_load?.map(LongitudinalForce::OverLoad));
    if let Some(torque) = torque? {
        let radius = settings.number(field!("kinematics.wheel_radius"))?;
        x = Some(LongitudinalForce::Torque { torque, radius });
    }
    Ok(PrescribedForces { x, y: y?, moment_z: moment_z? })
}

/// The point at which the creepages hold and about which the moment is taken.
pub fn reference(settings: &Settings) -> Result<ReferencePoint, CaseError> {
    const FIELD: FieldPath = field!("kinematics.reference");
    match settings.chosen(FIELD)? {
        Reference::Patch => return Ok(ReferencePoint::Patch),
        Reference::File => {}
    }
    let model: NormalModel = settings.chosen(field!("normal.model"))?;
    match model {
        NormalModel::Tabulated | NormalModel::Profile | NormalModel::WheelRail => {
            return Ok(ReferencePoint::File);
        }
        NormalModel::Hertz | NormalModel::Line | NormalModel::Ellipse => {}
    }
    let message = format!(
        "{FIELD} must be \"patch\" with normal.model = {}, which has no file and so no other origin, but is \
         \"file\"",
        settings.shown(field!("normal.model"))
    );
    Err(settings.error(FIELD, message))
}

/// Checks that a wheel with an angular velocity rolls forwards; the core would name the creepage.
fn check_rolling(settings: &Settings, wheel: &Kinematics) -> Result<(), CaseError> {
    const FIELD: FieldPath = field!("kinematics.angular_velocity");
    let rolling = wheel.circumferential_speed();
    if rolling > 0.0 {
        return Ok(());
    }
    let state = if rolling == 0.0 { "locked" } else { "reversed" };
    let message = format!(
        "{FIELD} must be positive, for the wheel to roll, but is {}: a {state} wheel with a \
         circumferential speed of {} m/s",
        settings.shown(FIELD),
        readable(rolling)
    );
    Err(settings.error(FIELD, message))
}
