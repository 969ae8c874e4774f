//! `[track]`, `[wheelset]`, and what left and right wheels and rails have of their own.

use super::{NORMAL_MODEL, SCALE, SMOOTHING, WHEEL_RADIUS, WHEEL_RAIL, quantity};
use crate::fields::choice::{Choose, ForceAxis, LateralAxis, VerticalAxis, WheelSide};
use crate::fields::field::Default::{Computed, Nothing, Same, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::profiles::COLUMNS as PROFILE_COLUMNS;
use crate::units::Measure;
use schlupf::reporting::Requirement::{self, Between, Finite, Inside, Magnitude, Radius};

const LENGTH: Requirement = Between(1e-3, 10.0);
pub(super) const ANGLE: Requirement = Inside(-1.0, 1.0);
pub(super) const SPEED: Requirement = Magnitude(1e4);
const TURNING: Requirement = Magnitude(1e6);
/// What tracks are wide, from scaled test rigs to broad gauges.
const TRACK_WIDTH: Requirement = Between(0.1, 2.2);

section! {
    Track "track"
        "Where the profiles are, if the normal contact is that of two profiles.";

    "gauge" [Gauge] quantity(&Measure::LENGTH), LENGTH, Text("1435 mm"),
        "distance of the gauge faces of both rails", shaping(), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(TRACK_WIDTH);
    "gauge_depth" [GaugeDepth] quantity(&Measure::LENGTH), Between(0.0, 1.0), Text("14 mm"),
        "depth below the top of the rail down to which the gauge is measured", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Between(0.0, 0.05));
    "curve_radius" [CurveRadius] quantity(&Measure::LENGTH), Radius(1.0, 1e9), Text("inf"),
        "radius of the curve: positive where the track turns to the left, negative to the right",
        shaping(), example("300 m"), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Radius(20.0, 1e6));
    "flange_back_distance" [FlangeBackDistance] quantity(&Measure::LENGTH), Magnitude(10.0),
        Text("1360 mm"), "distance of the flange backs of the wheelset", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL),
        usually(TRACK_WIDTH);
}

section! {
    Wheelset "wheelset"
        "Position and motion of the wheelset in the track (x forwards, y to the left, z up), if the \
         normal contact is that of two profiles; the wheel turns at kinematics.angular_velocity.";

    "side" [WheelSide] Kind::Choice(WheelSide::CHOICES), Finite, Text("right"),
        "which wheel is solved", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
    "track_position" [] quantity(&Measure::LENGTH), Magnitude(1e7),
        Text("0 m"), "place along the track, of a rail whose profile changes", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL);
    "pitch_angle" [] quantity(&Measure::ANGLE), Magnitude(1e6), Text("0 rad"),
        "angle around the wheel that is below the axle, of one whose profile changes: it grows in \
         rolling forwards", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
    "lateral_position" [LateralPosition] quantity(&Measure::LENGTH), Magnitude(1.0),
        Text("0 mm"), "lateral position of the middle of the axle", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(0.1));
    "yaw_angle" [WheelsetYaw] quantity(&Measure::ANGLE), ANGLE, Text("0 mrad"),
        "yaw angle about z", shaping(), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(0.2));
    "roll_angle" [RollAngle] quantity(&Measure::ANGLE), ANGLE,
        Computed("both wheels rest on their rails"), "roll angle about x", shaping(),
        example("0 mrad"), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(0.2));
    "height" [WheelsetHeight] quantity(&Measure::LENGTH), Magnitude(1.0), Nothing,
        "height of the middle of the axle above the nominal radius over z = 0 of the track, in place \
         of normal.load",
        shaping(), example("-0.1 mm"), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(0.05));
    "lateral_velocity" [LateralVelocity] quantity(&Measure::SPEED), SPEED, Text("0 m/s"),
        "lateral velocity of the middle of the axle", shaping(), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(10.0));
    "vertical_velocity" [VerticalVelocity] quantity(&Measure::SPEED), SPEED,
        Computed("0 m/s; under normal.load on slices that with which the wheel follows them"),
        "vertical velocity of the middle of the axle", shaping(), example("0.1 m/s"),
        with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(10.0));
    "yaw_rate" [YawRate] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Text("0 rad/s"),
        "angular velocity about the vertical axis", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
    "roll_rate" [RollRate] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Text("0 rad/s"),
        "angular velocity about the longitudinal axis", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL);
    "force_axis" [] Kind::Choice(ForceAxis::CHOICES), Finite, Text("track"),
        "axis of kinematics.force_x on the wheel: along the track, or along the wheelset", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL);
}

/// What a body on one side has of its own: its profile, then other fields.
macro_rules! side {
    (
        $section:ident $heading:literal $about:literal, $common:literal $example:literal;
        $($field:tt)*
    ) => { section! {
        $section $heading $about;

        "profile" [] Kind::Path, Finite, Same(field!($common, ".profile")),
            "its profile", shaping(), example($example), with(NORMAL_MODEL, WHEEL_RAIL),
            of_columns(&[&PROFILE_COLUMNS]);
        "profile_z" [] Kind::Choice(VerticalAxis::CHOICES), Finite,
            Same(field!($common, ".profile_z")),
            "direction of z in the file", shaping(), example("auto"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_y" [] Kind::Choice(LateralAxis::CHOICES), Finite,
            Same(field!($common, ".profile_y")),
            "direction of y in the file", shaping(), example("auto"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_scale" [] Kind::Number, SCALE, Same(field!($common, ".profile_scale")),
            "factor of y and z in the file", shaping(), example("1.0"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_smoothing" [] quantity(&Measure::LENGTH), SMOOTHING,
            Same(field!($common, ".profile_smoothing")),
            "length over which it is smoothed", shaping(), example("0 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        $($field)*
    } };
}

macro_rules! wheel {
    ($section:ident $heading:literal $about:literal [$($deviation:ident)?]) => { side! {
        $section $heading $about, "wheel" "S1002";

        "radius_x" [] quantity(&Measure::LENGTH), Between(1e-3, 1e3),
            Same(field!("wheel.radius_x")),
            "its nominal rolling radius; the height of the axle and creepage_x are those of \
             wheel.radius_x",
            shaping(), example("0.46 m"), with(NORMAL_MODEL, WHEEL_RAIL), usually(WHEEL_RADIUS);
        "flange_back_position" [] quantity(&Measure::LENGTH), Between(-1.0, 1.0),
            Same(field!("wheel.flange_back_position")),
            "y of the flange back in its profile, with y outwards", shaping(), example("-70 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.2));
        "longitudinal_displacement" [] quantity(&Measure::LENGTH), Magnitude(1.0), Computed("0 mm"),
            "displacement of the profile's origin forwards from its place in the wheelset, along the \
             axes of that",
            shaping(), example("0 mm"), with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.05));
        "lateral_displacement" [$($deviation)?] quantity(&Measure::LENGTH), Magnitude(1.0),
            Computed("0 mm"), "displacement of that origin to the left", shaping(), example("0 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.05));
        "vertical_displacement" [] quantity(&Measure::LENGTH), Magnitude(1.0), Computed("0 mm"),
            "displacement of that origin upwards", shaping(), example("0 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.05));
        "roll_angle" [] quantity(&Measure::ANGLE), ANGLE, Computed("0 mrad"),
            "turn of the wheel about x through that origin, relative to the wheelset", shaping(),
            example("0 mrad"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "yaw_angle" [] quantity(&Measure::ANGLE), ANGLE, Computed("0 mrad"),
            "turn of the wheel about the z that has turned about x", shaping(), example("0 mrad"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "longitudinal_velocity" [] quantity(&Measure::SPEED), SPEED, Computed("0 m/s"),
            "velocity of that origin forwards, relative to the wheelset and along its axes",
            shaping(), example("0 m/s"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(10.0));
        "lateral_velocity" [] quantity(&Measure::SPEED), SPEED, Computed("0 m/s"),
            "velocity of that origin to the left", shaping(), example("0 m/s"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(10.0));
        "vertical_velocity" [] quantity(&Measure::SPEED), SPEED, Computed("0 m/s"),
            "velocity of that origin upwards", shaping(), example("0 m/s"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(10.0));
        "roll_rate" [] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Computed("0 rad/s"),
            "angular velocity about x relative to the wheelset; −ω yaw_angle if it turns about its own \
             axis", shaping(),
            example("0 rad/s"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "pitch_rate" [] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Computed("0 rad/s"),
            "angular velocity about y beyond that of the wheelset", shaping(), example("0 rad/s"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "yaw_rate" [] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Computed("0 rad/s"),
            "angular velocity about z relative to the wheelset; ω roll_angle if it turns about its own \
             axis",
            shaping(), example("0 rad/s"),
            with(NORMAL_MODEL, WHEEL_RAIL);
    } };
}

macro_rules! rail {
    ($section:ident $heading:literal $about:literal [$($deviation:ident)?]) => { side! {
        $section $heading $about, "rail" "60E1";

        "cant" [] Kind::Number, Magnitude(0.5), Same(field!("rail.cant")),
            "its inclination towards the middle", shaping(), example("0.025"),
            with(NORMAL_MODEL, WHEEL_RAIL),
            usually(Magnitude(0.1));
        "origin_y" [] quantity(&Measure::LENGTH), Magnitude(10.0), Same(field!("rail.origin_y")),
            "y of the origin of its profile in the track, outwards, in place of track.gauge",
            shaping(), example("760 mm"), with(NORMAL_MODEL, WHEEL_RAIL);
        "origin_z" [] quantity(&Measure::LENGTH), Magnitude(10.0), Same(field!("rail.origin_z")),
            "z of that origin in the track", shaping(), example("0 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "lateral_displacement" [$($deviation)?] quantity(&Measure::LENGTH), Magnitude(1.0),
            Computed("0 mm"), "irregularity: displacement to the left from its place in the track",
            shaping(), example("0 mm"), with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.05));
        "vertical_displacement" [] quantity(&Measure::LENGTH), Magnitude(1.0), Computed("0 mm"),
            "irregularity: displacement upwards, of a roller's profile on its axle", shaping(), example("0 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.05));
        "roll_angle" [] quantity(&Measure::ANGLE), ANGLE, Computed("0 mrad"),
            "irregularity: turn about x through the origin of its profile", shaping(),
            example("0 mrad"),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "lateral_velocity" [] quantity(&Measure::SPEED), SPEED, Computed("0 m/s"),
            "velocity of that origin to the left", shaping(), example("0 m/s"),
            with(NORMAL_MODEL, WHEEL_RAIL),
            usually(Magnitude(10.0));
        "vertical_velocity" [] quantity(&Measure::SPEED), SPEED, Computed("0 m/s"),
            "velocity of that origin upwards", shaping(), example("0 m/s"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(10.0));
        "roll_rate" [] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Computed("0 rad/s"),
            "angular velocity about x", shaping(), example("0 rad/s"),
            with(NORMAL_MODEL, WHEEL_RAIL);
    } };
}

wheel! {
    LeftWheel "left_wheel"
    "What the left wheel has of its own, and how it deviates from its place." [WheelDeviation]
}
wheel! {
    RightWheel "right_wheel"
    "What the right wheel has of its own, and how it deviates from its place." []
}
rail! {
    LeftRail "left_rail"
    "What the left rail has of its own, and how it deviates from its place." [RailDeviation]
}
rail! {
    RightRail "right_rail"
    "What the right rail has of its own, and how it deviates from its place." []
}
