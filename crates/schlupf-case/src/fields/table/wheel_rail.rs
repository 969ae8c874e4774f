//! `[track]` and `[wheelset]`.

use super::{NORMAL_MODEL, WHEEL_RAIL, quantity};
use crate::fields::choice::{Choose, ForceAxis, WheelSide};
use crate::fields::field::Default::{Computed, Nothing, Text};
use crate::fields::field::{Field, Kind, Section};
use crate::units::Measure;
use schlupf::reporting::Requirement::{self, Between, Finite, Inside, Magnitude};

const LENGTH: Requirement = Between(1e-3, 10.0);
const ANGLE: Requirement = Inside(-1.0, 1.0);
const SPEED: Requirement = Magnitude(1e4);
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
    "flange_back_distance" [FlangeBackDistance] quantity(&Measure::LENGTH), LENGTH,
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
        "height of the middle of the axle above the nominal radius over the tops of the rails, in \
         place of normal.load",
        shaping(), example("-0.1 mm"), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(0.05));
    "lateral_velocity" [LateralVelocity] quantity(&Measure::SPEED), SPEED, Text("0 m/s"),
        "lateral velocity of the middle of the axle", shaping(), with(NORMAL_MODEL, WHEEL_RAIL),
        usually(Magnitude(10.0));
    "vertical_velocity" [VerticalVelocity] quantity(&Measure::SPEED), SPEED, Text("0 m/s"),
        "vertical velocity of the middle of the axle", shaping(), with(NORMAL_MODEL, WHEEL_RAIL),
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
