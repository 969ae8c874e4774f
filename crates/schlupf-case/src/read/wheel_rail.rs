//! `[wheelset]`: a wheel on a rail, with normal.model = "wheel-rail".

use schlupf::problem::Driver;
use schlupf::wheel_rail::{
    Along, Drive, Joining, Motion, NormalMethod, Position, RowsMove, Side, Support, Tangential,
    WheelAt, WheelOnRail, WheelOverTime, WheelSolution,
};
use schlupf::{Error, Method, Watch};

use super::friction;
use super::history::starts_rolling;
use super::kinematics::rolling_radius;
use super::pairs::{self, Placed};
use super::roughness::OfRoughness;
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::choice::{
    BranchChoice, ForceAxis, NormalModel, NormalSolution, RowMotion, WheelSide,
};
use crate::fields::{Field, ROUGHNESS, section};
use crate::notice::Notice;
use crate::profiles::ProfileReading;
use crate::settings::Settings;

const LOAD: FieldPath = field!("normal.load");
const APPROACH: FieldPath = field!("normal.approach");
const HEIGHT: FieldPath = field!("wheelset.height");
const ROLL: FieldPath = field!("wheelset.roll_angle");

/// Cells across a contact where the case does not say how many.
const CELLS: usize = 64;

/// A wheel on a rail, as far as it is known without solving.
#[derive(Debug, Clone)]
pub struct WheelRequest {
    wheel: WheelOnRail,
    /// The same over time, if it changes.
    over_time: Option<WheelOverTime>,
    /// Whether the roll angle follows from both wheels resting on their rails.
    rests: bool,
    /// What was read of the profiles.
    readings: Vec<ProfileReading>,
    /// What users should know of them.
    notices: Vec<Notice>,
}

/// The wheel that a case describes, if its normal contact is that of two profiles.
pub fn request(settings: &Settings) -> Result<Option<WheelRequest>, CaseError> {
    if settings.chosen::<NormalModel>(field!("normal.model"))? != NormalModel::WheelRail {
        return Ok(None);
    }
    let explain = |error: Error| settings.explain(&error);
    let Placed { pairs, readings, notices } = pairs::placed(settings)?;
    let both = [&pairs.left, &pairs.right];
    let is_round = !both.iter().any(|pair| pair.wheel().is_varying());
    let is_straight = !both.iter().any(|pair| pair.rail().is_varying());
    let reason = "the profiles do not change along the way";
    refuse_idle(settings, field!("wheelset.pitch_angle"), is_round, reason)?;
    refuse_idle(settings, field!("wheelset.track_position"), is_straight, reason)?;
    let wheel = WheelOnRail {
        pairs,
        side: match settings.chosen(field!("wheelset.side"))? {
            WheelSide::Left => Side::Left,
            WheelSide::Right => Side::Right,
        },
        position: Position {
            lateral: settings.number(field!("wheelset.lateral_position"))?,
            yaw: settings.number(field!("wheelset.yaw_angle"))?,
            roll: settings.optional_number(ROLL)?.unwrap_or(0.0),
        },
        motion: motion(settings)?,
        follows: !settings.is_given(field!("wheelset.vertical_velocity")),
        drive: drive(settings)?,
        support: support(settings)?,
        joining: Joining {
            distance: settings.number(field!("normal.join_distance"))?,
            angle: settings.number(field!("normal.join_angle"))?,
        },
        rows: match settings.chosen(field!("normal.row_motion"))? {
            RowMotion::Automatic => RowsMove::Automatic,
            RowMotion::Surface => RowsMove::WithSurface,
            RowMotion::Plane => RowsMove::WithPlane,
        },
        normal_method: match settings.chosen(field!("normal.method"))? {
            NormalSolution::HalfSpaces => NormalMethod::HalfSpaces,
            NormalSolution::Conformal => NormalMethod::Conformal,
            NormalSolution::KikPiotrowski => NormalMethod::KikPiotrowski,
            NormalSolution::EllipseCorrected => NormalMethod::EllipseCorrected,
            NormalSolution::EquivalentEllipse => NormalMethod::EquivalentEllipse,
            NormalSolution::Analyn => NormalMethod::Analyn,
        },
        friction_variation: friction::variation_over_rail(settings)?,
        cells: settings
            .optional_number(field!("normal.cells"))?
            .map_or(CELLS, |cells| cells as usize),
    };
    wheel.check().map_err(explain)?;
    let rests = !settings.is_given(ROLL) && !settings.is_given(field!("history.roll_angle"));
    let over_time = over_time(settings, &wheel, rests)?;
    Ok(Some(WheelRequest { wheel, over_time, rests, readings, notices }))
}

/// Refuses what goes with one contact only.
pub fn refuse_others(settings: &Settings, stiffness: &OfRoughness) -> Result<(), CaseError> {
    if let Some(path) = of_history(true).find(|path| settings.is_given(*path)) {
        let message = format!(
            "{path} must be left out with normal.model = \"wheel-rail\", where a history is of the \
             wheelset and stands in the case, but is given"
        );
        return Err(settings.error(path, message));
    }
    if settings.is_given(TIME) {
        refuse_in_history(settings)?;
    }
    if let Some(path) = OF_ONE_CONTACT.into_iter().find(|path| settings.is_given(*path)) {
        let message = format!(
            "{path} must be left out with normal.model = \"wheel-rail\", where the lateral creepage \
             and the spin follow from the motion of the wheelset, but is given"
        );
        let help = "kinematics.force_x, traction_coefficient or wheel_torque can be given";
        return Err(settings.error(path, message).help(help.to_owned()));
    }
    let is_high = settings.chosen::<BranchChoice>(BRANCH)? == BranchChoice::HighSlip;
    if is_high && drive(settings)?.is_force() {
        let message = format!(
            "{BRANCH} must be \"low-slip\" with a force and normal.model = \"wheel-rail\", which has \
             the motion of the rising branch only, but is \"high-slip\""
        );
        return Err(settings.error(BRANCH, message));
    }
    match stiffness {
        OfRoughness::Known(_) => Ok(()),
        OfRoughness::MicroModel(_) => Err(refuse_micro_model(settings)),
    }
}

const BRANCH: FieldPath = field!("solver.branch");

const TIME: FieldPath = field!("history.time");
const SHIFT_DURATION: FieldPath = field!("history.shift_duration");

/// What a wheelset over time does not have.
fn refuse_in_history(settings: &Settings) -> Result<(), CaseError> {
    let refuse = |path: FieldPath, requirement: &str| {
        let message = format!(
            "{path} must {requirement} with {TIME} and normal.model = \"wheel-rail\", but is {}",
            settings.shown(path)
        );
        Err(settings.error(path, message))
    };
    if super::method(settings)? != Method::Full {
        return refuse(field!("solver.method"), "be \"full\"");
    }
    if super::driver(settings)? == Some(Driver::Steady) {
        return refuse(field!("solver.driver"), "be \"marching\"");
    }
    Ok(())
}

/// What one contact and a wheelset both may have over time.
const OF_BOTH: [FieldPath; 4] =
    fields!["history.start", "history.speed", "history.creepage_x", "history.load"];

/// Fields of a history: those that only one contact has, or those that a wheelset has over time.
fn of_history(is_of_one_contact: bool) -> impl Iterator<Item = FieldPath> {
    let fields = section("history").into_iter().flat_map(|history| history.fields);
    let is_of_wheelset =
        |field: &Field| field.used_with[0].is_some() || OF_BOTH.contains(&field.path);
    fields
        .filter(move |field| is_of_wheelset(field) != is_of_one_contact && field.path != TIME)
        .map(|field| field.path)
}

/// The wheel over time, if the case has it.
fn over_time(
    settings: &Settings,
    wheel: &WheelOnRail,
    rests: bool,
) -> Result<Option<WheelOverTime>, CaseError> {
    let Some(times) = settings.series(TIME) else {
        let is_series = |path: &FieldPath| *path != field!("history.start");
        let given = of_history(false).filter(is_series).any(|path| settings.is_given(path))
            || starts_rolling(settings)?;
        return if given { settings.setting(TIME).map(|_| None) } else { Ok(None) };
    };
    if let Some(path) = of_history(false)
        .find(|path| settings.series(*path).is_some_and(|s| s.len() != times.len()))
    {
        let count = settings.series(path).map_or(0, <[f64]>::len);
        let message =
            format!("{path} must have as many entries as {TIME}, {}, but has {count}", times.len());
        return Err(settings.error(path, message));
    }
    if times.len() < 2 || times.windows(2).any(|pair| pair[1] < pair[0]) {
        let message = format!("{TIME} must have at least two instants, which must ascend");
        return Err(settings.error(TIME, message));
    }
    if wheel.pair().wheel().is_varying() || wheel.pair().rail().is_varying() {
        let message = format!(
            "{TIME} must be left out with profiles that change along the way, which have steady \
             states at every place only, but is given"
        );
        return Err(settings.error(TIME, message));
    }
    let radius = rolling_radius(settings)?;
    let instants = times.iter().enumerate().map(|(row, time)| {
        let wheel = at(settings, wheel, row, radius);
        wheel.check().map_err(|error| settings.explain(&error))?;
        Ok(WheelAt { time: *time, wheel })
    });
    let instants: Vec<WheelAt> = instants.collect::<Result<_, CaseError>>()?;
    let shift_duration = settings.number(SHIFT_DURATION)?;
    let starts_rolling = starts_rolling(settings)?;
    let mut history = WheelOverTime { instants, starts_rolling, rests, shift_duration };
    follow_positions(settings, &mut history)?;
    Ok(Some(history))
}

/// Velocities that are not given follow from the positions that are: in a row as the mean of the
/// intervals beside it.
fn follow_positions(settings: &Settings, history: &mut WheelOverTime) -> Result<(), CaseError> {
    type Place = fn(&WheelOnRail) -> f64;
    type Rate = fn(&mut WheelOnRail) -> &mut f64;
    let WheelOverTime { instants, shift_duration, .. } = history;
    let height: Place = |wheel| match wheel.support {
        Support::Height(height) => height,
        Support::Force(_) => 0.0,
    };
    let pairs: [([FieldPath; 3], Place, Rate); 4] = [
        (
            fields![
                "history.lateral_position",
                "history.lateral_velocity",
                "wheelset.lateral_velocity"
            ],
            |wheel| wheel.position.lateral,
            |wheel| &mut wheel.motion.lateral_velocity,
        ),
        (
            fields!["history.yaw_angle", "history.yaw_rate", "wheelset.yaw_rate"],
            |wheel| wheel.position.yaw,
            |wheel| &mut wheel.motion.yaw_rate,
        ),
        (
            fields!["history.roll_angle", "history.roll_rate", "wheelset.roll_rate"],
            |wheel| wheel.position.roll,
            |wheel| &mut wheel.motion.roll_rate,
        ),
        (
            fields!["history.height", "history.vertical_velocity", "wheelset.vertical_velocity"],
            height,
            |wheel| &mut wheel.motion.vertical_velocity,
        ),
    ];
    for ([position, velocity, constant], place, rate) in pairs {
        let is_given = settings.is_given(velocity) || settings.is_given(constant);
        if !settings.is_given(position) || is_given {
            continue;
        }
        let slope = |pair: &[WheelAt]| {
            let duration = pair[1].time - pair[0].time;
            let is_rest = duration == 0.0;
            let way = place(&pair[1].wheel) - place(&pair[0].wheel);
            if is_rest && way != 0.0 && *shift_duration == 0.0 {
                let message = format!(
                    "{position} must be the same at equal times, at which a wheelset without \
                     {SHIFT_DURATION} is not shifted, but changes at {} s",
                    pair[1].time
                );
                return Err(settings.error(position, message));
            }
            let duration = if is_rest { *shift_duration } else { duration };
            Ok((is_rest, if way == 0.0 { 0.0 } else { way / duration }))
        };
        let slopes: Vec<(bool, f64)> =
            instants.windows(2).map(slope).collect::<Result<_, CaseError>>()?;
        for (row, instant) in instants.iter_mut().enumerate() {
            let before = row.checked_sub(1).map(|k| slopes[k]);
            let after = slopes.get(row).copied().filter(|(is_rest, _)| !is_rest);
            *rate(&mut instant.wheel) = match (before, after) {
                (Some((false, before)), Some((_, after))) => 0.5 * (before + after),
                (Some((_, slope)), _) | (None, Some((_, slope))) => slope,
                (None, None) => 0.0,
            };
        }
    }
    Ok(())
}

/// The wheel with the values of a row of its history.
fn at(settings: &Settings, wheel: &WheelOnRail, row: usize, radius: f64) -> WheelOnRail {
    let mut wheel = wheel.clone();
    let creepage = 1.0 - wheel.motion.angular_velocity * radius / wheel.motion.speed;
    let value = |path: FieldPath| settings.series(path).map(|series| series[row]);
    let Position { lateral, yaw, roll } = &mut wheel.position;
    let motion = &mut wheel.motion;
    for (own, path) in [lateral, yaw, roll, &mut motion.speed].into_iter().zip(fields![
        "history.lateral_position",
        "history.yaw_angle",
        "history.roll_angle",
        "history.speed",
    ]) {
        *own = value(path).unwrap_or(*own);
    }
    // A creepage stays what it is at another speed, an angular velocity too.
    let creepage = value(field!("history.creepage_x")).unwrap_or(creepage);
    if !settings.is_given(field!("kinematics.angular_velocity")) {
        motion.angular_velocity = (1.0 - creepage) * motion.speed / radius;
    }
    let rates = [
        &mut motion.angular_velocity,
        &mut motion.lateral_velocity,
        &mut motion.vertical_velocity,
        &mut motion.yaw_rate,
        &mut motion.roll_rate,
    ];
    for (own, path) in rates.into_iter().zip(fields![
        "history.angular_velocity",
        "history.lateral_velocity",
        "history.vertical_velocity",
        "history.yaw_rate",
        "history.roll_rate",
    ]) {
        *own = value(path).unwrap_or(*own);
    }
    let [load, height] = [field!("history.load"), field!("history.height")].map(value);
    let support = load.map(Support::Force).or(height.map(Support::Height));
    wheel.support = support.unwrap_or(wheel.support);
    wheel
}

/// Forces in place of creepages that a wheelset does not leave open.
const OF_ONE_CONTACT: [FieldPath; 2] = fields!["kinematics.force_y", "kinematics.moment_z"];

const FORCES: [FieldPath; 3] =
    fields!["kinematics.force_x", "kinematics.traction_coefficient", "kinematics.wheel_torque"];

/// A micro model needs one patch.
pub fn refuse_micro_model(settings: &Settings) -> CaseError {
    let given = ROUGHNESS.iter().copied().find(|path| settings.is_given(*path));
    let path = given.unwrap_or(field!("contact_law.stiffness"));
    let message = format!(
        "{path}: the micro model of a roughness needs one patch, but normal.model is \"wheel-rail\""
    );
    settings.error(path, message).help(
        "find k_c for a typical patch by `schlupf roughness` and give contact_law.stiffness"
            .to_owned(),
    )
}

/// A case without profiles, where they are needed.
pub fn no_profiles(settings: &Settings) -> CaseError {
    let message = format!(
        "normal.model must be \"wheel-rail\" for the contacts of a wheelset, but is {}",
        settings.shown(field!("normal.model"))
    );
    settings.error(field!("normal.model"), message)
}

/// A wheel without contacts.
pub fn no_contact(settings: &Settings) -> CaseError {
    let message = "normal.model: wheel and rail do not touch".to_owned();
    settings.error(field!("normal.model"), message)
}

fn support(settings: &Settings) -> Result<Support, CaseError> {
    if settings.is_written(APPROACH) {
        let message = format!(
            "{APPROACH} must not be given with {} = {}, but is {}: the contacts of a wheel have \
             {HEIGHT} in common",
            field!("normal.model"),
            settings.shown(field!("normal.model")),
            settings.shown(APPROACH)
        );
        return Err(settings.error(APPROACH, message));
    }
    match settings.optional_number(HEIGHT)? {
        Some(_) if !settings.is_given(ROLL) && !settings.is_given(field!("history.roll_angle")) => {
            Err(settings.missing_beside(ROLL, HEIGHT))
        }
        Some(height) => Ok(Support::Height(height)),
        None if settings.is_given(LOAD) => Ok(Support::Force(settings.number(LOAD)?)),
        None => Err(settings.missing_beside(LOAD, field!("normal.model"))),
    }
}

/// What turns the wheel: a force on all of its contacts together, or its angular velocity.
fn drive(settings: &Settings) -> Result<Drive, CaseError> {
    let [force, coefficient, torque] = FORCES.map(|path| settings.optional_number(path));
    let along = match settings.chosen(field!("wheelset.force_axis"))? {
        ForceAxis::Track => Along::Track,
        ForceAxis::Wheelset => Along::Wheelset,
    };
    let force = force?.map(|force| Drive::Force { force, along });
    let coefficient = coefficient?.map(Drive::OverLoad);
    let torque = torque?.map(Drive::Torque);
    refuse_idle(
        settings,
        field!("wheelset.force_axis"),
        force.is_none(),
        "kinematics.force_x is not given",
    )?;
    Ok(force.or(coefficient).or(torque).unwrap_or(Drive::AngularVelocity))
}

/// An error if a field is given that would be ignored.
fn refuse_idle(
    settings: &Settings,
    field: FieldPath,
    is_idle: bool,
    reason: &str,
) -> Result<(), CaseError> {
    if is_idle && settings.is_given(field) {
        return Err(settings.error(field, format!("{field} would be ignored: {reason}")));
    }
    Ok(())
}

/// The motion of the wheelset; the wheel turns at its angular velocity, or so that the creepage of
/// its nominal radius is that given.
fn motion(settings: &Settings) -> Result<Motion, CaseError> {
    const CREEPAGE: FieldPath = field!("kinematics.creepage_x");
    let speed = super::kinematics::speed(settings)?;
    let given = settings.optional_number(field!("kinematics.angular_velocity"))?;
    let angular_velocity = if let Some(angular_velocity) = given {
        angular_velocity
    } else {
        let creepage = settings.number(CREEPAGE)?;
        if creepage >= 1.0 {
            let message =
                format!("{CREEPAGE} must be below 1, at which the wheel locks, but is {creepage}");
            return Err(settings.error(CREEPAGE, message));
        }
        (1.0 - creepage) * speed / rolling_radius(settings)?
    };
    Ok(Motion {
        speed,
        curve_radius: settings.number(field!("track.curve_radius"))?,
        lateral_velocity: settings.number(field!("wheelset.lateral_velocity"))?,
        vertical_velocity: settings
            .optional_number(field!("wheelset.vertical_velocity"))?
            .unwrap_or(0.0),
        angular_velocity,
        roll_rate: settings.number(field!("wheelset.roll_rate"))?,
        yaw_rate: settings.number(field!("wheelset.yaw_rate"))?,
    })
}

impl WheelRequest {
    /// The contacts of the wheel, or with another lateral position as `place` (in m) those of the
    /// left and of the right wheel resting on both rails.
    pub fn solve(
        &self,
        place: Option<f64>,
        tangential: &Tangential,
        watch: Watch,
    ) -> Result<Vec<WheelSolution>, Error> {
        match (place, &self.over_time) {
            (Some(lateral), _) => {
                let position = Position { lateral, ..self.wheel.position };
                // A force is that on the wheel of the case.
                let own = WheelOnRail { position, ..self.wheel.clone() };
                let mut both = own.solve_resting(tangential, watch)?;
                both.sort_by_key(|wheel| wheel.side == Side::Right);
                Ok(Vec::from(both))
            }
            (None, Some(history)) => {
                let (mut wheel, instants) = history.march(tangential, watch)?;
                // The history of the wheel is told as that of its main contact.
                if let Some(main) = wheel.contacts.first_mut() {
                    main.solution.history = instants;
                }
                Ok(vec![wheel])
            }
            (None, None) if self.rests => {
                self.wheel.solve_resting(tangential, watch).map(Vec::from)
            }
            (None, None) => Ok(vec![self.wheel.solve(tangential, watch)?]),
        }
    }

    /// What was read of the profiles.
    pub fn readings(&self) -> &[ProfileReading] {
        &self.readings
    }

    /// What users should know of the profiles.
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// The wheel as described.
    pub fn wheel(&self) -> &WheelOnRail {
        &self.wheel
    }

    /// The same, to be changed.
    pub fn wheel_mut(&mut self) -> &mut WheelOnRail {
        &mut self.wheel
    }
}
