//! The table.

/// A section: its heading, the quantity that all of it gives if it gives one, what it is about, the
/// tasks that alone use it if not all may, and its fields. Each of these has its name, the
/// quantities that it gives, its kind, requirement, default and meaning, and what else there is to
/// say of it.
macro_rules! section {
    (
        $section:ident $heading:literal $([$of:ident])? $about:literal $(for $($task:literal)+)?;
        $(
            $name:literal [$($quantity:ident)*] $kind:expr, $requirement:expr, $default:expr,
            $doc:literal $(, $attribute:ident($($value:expr),*))*;
        )*
    ) => {
        pub(super) struct $section;

        impl $section {
            pub(super) const PATHS: &[&str] = &[$(concat!($heading, ".", $name)),*];
            pub(super) const SECTION: Section = Section {
                name: $heading,
                quantities: &[$(schlupf::Quantity::$of)?],
                doc: $about,
                tasks: &[$($($task),+)?],
                fields: &[$(
                    Field::new(field!($heading, ".", $name), $kind, $requirement, $default, $doc)
                        .giving(&[$(schlupf::Quantity::$quantity),*])
                        $(.$attribute($($value),*))*
                ),*],
            };
        }
    };
}

mod contact_law;
mod damage;
mod elasticity;
mod layer;
mod friction;
mod solver;
mod subsurface;
mod wheel_rail;

use super::choice::{
    Choose, HeatChoice, LateralAxis, NormalModel, NormalSolution, PartitionChoice, Reference,
    RowMotion, StartChoice, VerticalAxis,
};
use super::field::Default::{Computed, Nothing, Same, Text};
use super::field::{Field, Kind, Section};
use super::path::FieldPath;
use crate::profiles::COLUMNS as PROFILE_COLUMNS;
use crate::tables::{TableColumn, layouts};
use crate::units::Measure;
use schlupf::Quantity;
use schlupf::reporting::Requirement::{self, Between, Finite, Inside, Magnitude, Radius};
use solver::{CELLS, METHOD};
use std::f64::consts::FRAC_PI_2;

impl Field {
    const fn giving(self, quantities: &'static [Quantity]) -> Self {
        Self { quantities, ..self }
    }

    /// The same; normal contact or elasticity may depend on it.
    const fn shaping(self) -> Self {
        Self { shapes_contact: true, ..self }
    }

    /// The same; a constant of a material, which is given with the others, used or not.
    const fn of_material(self) -> Self {
        Self { is_of_material: true, ..self }
    }

    /// The same; its file is a table with such columns.
    const fn of_columns(self, columns: &'static [&'static [TableColumn]]) -> Self {
        Self { columns, ..self }
    }

    const fn example(self, text: &'static str) -> Self {
        Self { example: Some(text), ..self }
    }

    /// The same with what its number is in almost all cases.
    const fn usually(self, usual: Requirement) -> Self {
        Self { usual: Some(usual), ..self }
    }

    /// The same; the default counts with these names of a choice only.
    const fn default_with(self, choice: FieldPath, names: &'static [&'static str]) -> Self {
        Self { default_with: Some((choice, names)), ..self }
    }

    /// The same; with these names of a choice the default is another one.
    const fn default_else(
        self,
        choice: FieldPath,
        names: &'static [&'static str],
        text: &'static str,
    ) -> Self {
        Self { other_default: Some(((choice, names), text)), ..self }
    }

    /// The same; it has no effect with these names of a choice.
    const fn idle_with(self, choice: FieldPath, names: &'static [&'static str]) -> Self {
        Self { idle_with: Some((choice, names)), ..self }
    }

    /// The same with a choice that it belongs to, besides the one it may have.
    const fn with(self, choice: FieldPath, names: &'static [&'static str]) -> Self {
        Self { used_with: [Some((choice, names)), self.used_with[0]], ..self }
    }
}

const fn quantity(measure: &'static Measure) -> Kind {
    Kind::Quantity(measure)
}

/// Lists the sections and, apart from them, their paths: fields refer to each other by these.
macro_rules! sections {
    ($($section:path,)*) => {
        /// All sections, in the order of the case file.
        pub const SECTIONS: &[Section] = &[$(<$section>::SECTION),*];

        /// The paths of their fields.
        pub(super) const PATHS: &[&[&str]] = &[$(<$section>::PATHS),*];
    };
}

sections! {
    Title,
    Kinematics,
    Wheel,
    Rail,
    Normal,
    wheel_rail::Track,
    wheel_rail::Wheelset,
    wheel_rail::LeftWheel,
    wheel_rail::RightWheel,
    wheel_rail::LeftRail,
    wheel_rail::RightRail,
    elasticity::Elasticity,
    layer::Layer,
    contact_law::ContactLaw,
    contact_law::Roughness,
    friction::Friction,
    Heat,
    Cooling,
    subsurface::Subsurface,
    damage::Damage,
    solver::Grid,
    solver::Solver,
    solver::Fastsim,
    solver::Element,
    History,
}

/// Bounds that no rolling contact comes near, and within which no product or quotient leaves the
/// range of double precision. Each in the SI unit of its fields, temperatures in degC.
const MODULUS: Requirement = Between(1e3, 1e14);
const THERMAL: Requirement = Between(1e-6, 1e9);
const TEMPERATURE: Requirement = Between(-273.15, 1e5);
const CURVATURE: Requirement = Radius(1e-6, 1e12);
const ROLLING_RADIUS: Requirement = Between(1e-6, 1e6);
const SPEED: Requirement = Between(1e-6, 1e4);
const CREEPAGE: Requirement = Magnitude(1e6);
const TURNING: Requirement = Magnitude(1e6);
const OVER_LOAD: Requirement = Magnitude(1e3);
const TANGENTIAL: Requirement = Magnitude(1e12);
const LOAD: Requirement = Between(1e-9, 1e12);
const APPROACH: Requirement = Between(1e-12, 1.0);
const PEAK_PRESSURE: Requirement = Between(1.0, 1e14);
const SEMI_AXIS: Requirement = Between(1e-7, 1e2);
const SPACING: Requirement = Between(1e-9, 1e2);
const COOLED_AREA: Requirement = Between(1e-9, 1e6);
const INSTANT: Requirement = Magnitude(1e9);
const RETARDATION: Requirement = Between(0.0, 1e9);
const SCALE: Requirement = Between(1e-6, 1e6);
const SMOOTHING: Requirement = Between(0.0, 0.1);
/// Bodies that are shifted by more than the size of a wheel, or turned by more than a radian, do
/// not touch where they did.
const SHIFT: Requirement = Magnitude(1.0);

/// What numbers are in almost all cases, on track and on test rigs: another one may be in a wrong
/// unit. Each in the SI unit of its fields.
const ROLLING_SPEED: Requirement = Between(1e-4, 300.0);
/// A wheel that turns backwards or twice as fast is rare, and a percentage is not.
const PART_OF_SPEED: Requirement = Inside(-1.0, 1.0);
/// From small rollers on a disc to the flange of a wheel.
const SPIN_OF_WHEEL: Requirement = Magnitude(500.0);
const WHEEL_RADIUS: Requirement = Between(1e-3, 5.0);
const RADIUS: Requirement = Radius(1e-3, 100.0);
const LOAD_OF_WHEEL: Requirement = Between(0.1, 1e6);
const FORCE_OF_WHEEL: Requirement = Magnitude(1e6);

/// What stands in front of all sections.
struct Title;

impl Title {
    const PATHS: &[&str] = &["title"];
    const SECTION: Section = Section {
        name: "",
        quantities: &[],
        doc: "",
        tasks: &[],
        fields: &[Field::new(
            field!("title"),
            Kind::Text,
            Finite,
            Text("wheel on rail"),
            "title of summary and figures",
        )
        .example("steel wheel, 80 kN, braking")],
    };
}

section! {
    Kinematics "kinematics"
        "How the wheel moves over the rail. Braking has a positive creepage and a negative force.";

    "speed" [Speed] quantity(&Measure::SPEED), SPEED, Text("108 km/h"),
        "v0, speed of the vehicle, or of the circumference of a roller",
        usually(ROLLING_SPEED);
    "creepage_x" [CreepageX] Kind::Number, CREEPAGE, Text("0.0"),
        "ξ, longitudinal creepage: positive when braking", example("0.008"),
        usually(PART_OF_SPEED);
    "angular_velocity" [AngularVelocity] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Nothing,
        "ω of the wheel, in place of creepage_x", example("64.7 rad/s");
    "wheel_radius" [] quantity(&Measure::LENGTH), ROLLING_RADIUS, Same(field!("wheel.radius_x")),
        "R, rolling radius that goes with angular_velocity or wheel_torque", example("0.46 m"),
        idle_with(NORMAL_MODEL, WHEEL_RAIL), usually(WHEEL_RADIUS);
    "creepage_y" [CreepageY] Kind::Number, Inside(-1.0, 1.0), Text("0.0"), "η, lateral creepage",
        idle_with(NORMAL_MODEL, WHEEL_RAIL);
    "yaw_angle" [] quantity(&Measure::ANGLE), Inside(-FRAC_PI_2, FRAC_PI_2), Nothing,
        "α, slip angle, in place of creepage_y", example("0.5 deg"),
        idle_with(NORMAL_MODEL, WHEEL_RAIL);
    "spin" [Spin] quantity(&Measure::SPIN), TURNING, Text("0 1/m"), "φ, spin creepage",
        idle_with(NORMAL_MODEL, WHEEL_RAIL),
        usually(SPIN_OF_WHEEL);
    "force_x" [ForceX] quantity(&Measure::FORCE), TANGENTIAL, Nothing,
        "Fx on the wheel, in place of creepage_x, which is found: negative when braking; of two \
         profiles that of all contacts together",
        example("-20 kN"),
        usually(FORCE_OF_WHEEL);
    "traction_coefficient" [ForceOverLoad] Kind::Number, OVER_LOAD, Nothing,
        "-Fx/N, in place of creepage_x: positive when braking; of two profiles over the vertical \
         force",
        example("0.2"),
        usually(Magnitude(1.5));
    "wheel_torque" [WheelTorque] quantity(&Measure::TORQUE), TANGENTIAL, Nothing,
        "T on the wheel about its axle, in place of creepage_x, with Fx = T/wheel_radius (of two \
         profiles in balance with the tractions of all contacts): negative when braking",
        example("-9.2 kN m");
    "force_y" [ForceY] quantity(&Measure::FORCE), TANGENTIAL, Nothing,
        "Fy on the wheel, in place of creepage_y and shifts_y", example("5 kN"),
        usually(FORCE_OF_WHEEL);
    "moment_z" [MomentZ] quantity(&Measure::TORQUE), TANGENTIAL, Nothing,
        "Mz on the wheel, in place of spin and turns", example("-20 N m");
    "reference" [Reference] Kind::Choice(Reference::CHOICES), Finite, Text("patch"),
        "where creepages hold (those of a history, too) and about which point the moment is taken",
        idle_with(NORMAL_MODEL, WHEEL_RAIL);
}

macro_rules! body {
    (
        $section:ident $body:literal $about:literal, $radius_x:literal, $radius_y:literal,
        $along:expr, $usual:expr, { $($profile:tt)* };
        $young:ident, $relaxed:ident, $time:ident, [$($poisson:ident)*], $conductivity:ident, $density:ident,
        $specific_heat:ident, $temperature:ident, $of_radius_x:ident, $of_radius_y:ident
    ) => { section! {
        $section $body $about;

        "young_modulus" [$young] quantity(&Measure::PRESSURE), MODULUS, Text("210 GPa"),
            "E, Young's modulus", shaping(),
            usually(Between(1e6, 2e12));
        "relaxed_modulus" [$relaxed] quantity(&Measure::PRESSURE), MODULUS,
            Same(field!($body, ".young_modulus")),
            "E∞, Young's modulus after a long time, where young_modulus is the instantaneous one",
            shaping(), example("1.6 GPa"), with(elasticity::MODEL, elasticity::VISCOELASTIC);
        "retardation_time" [$time] quantity(&Measure::TIME), RETARDATION, Text("0 s"),
            "τ, retardation time: under constant stress the rest of the creep falls as exp(-t/τ)",
            shaping(), example("9 ms"), with(elasticity::MODEL, elasticity::VISCOELASTIC);
        "poisson_ratio" [$($poisson)*] Kind::Number, Between(0.0, 0.5), Text("0.28"),
            "ν, Poisson's ratio", shaping();
        "conductivity" [$conductivity] quantity(&Measure::CONDUCTIVITY), THERMAL,
            Text("50 W/(m K)"), "λ, thermal conductivity", with(HEAT_MODEL, HEATING), of_material(),
            usually(Between(0.1, 2500.0));
        "density" [$density] quantity(&Measure::DENSITY), THERMAL, Text("7850 kg/m^3"), "ρ, density",
            with(HEAT_MODEL, HEATING), of_material(),
            usually(Between(500.0, 25e3));
        "specific_heat" [$specific_heat] quantity(&Measure::SPECIFIC_HEAT), THERMAL,
            Text("450 J/(kg K)"), "c, specific heat", with(HEAT_MODEL, HEATING), of_material(),
            usually(Between(100.0, 5e3));
        "bulk_temperature" [$temperature] quantity(&Measure::TEMPERATURE), TEMPERATURE,
            Text("20 degC"), "temperature far from the contact",
            usually(Between(-80.0, 800.0));
        "radius_x" [$of_radius_x] quantity(&Measure::LENGTH), CURVATURE, Text($radius_x),
            "radius of curvature along rolling: \"inf\" where straight, negative where concave",
            shaping(), with(NORMAL_MODEL, $along),
            usually($usual);
        "radius_y" [$of_radius_y] quantity(&Measure::LENGTH), CURVATURE, Text($radius_y),
            "radius of curvature across rolling", shaping(), with(NORMAL_MODEL, &["hertz"]),
            usually(RADIUS);
        $($profile)*
    } };
}

body! {
    Wheel "wheel" "The wheel: elastic and thermal constants, temperature, curvature radii.",
    "0.46 m", "inf", &["hertz", "line", "profile", "wheel-rail"], Radius(1e-3, 5.0), {
        "profile" [WheelProfile] Kind::Path, Finite, Nothing,
            "profile: a file (CSV with the header `y [mm],z [mm]`, Simpack, Miniprof, or two columns in \
             mm) or the name of one that is built in, such as \"S1002\"",
            shaping(), example("S1002"), with(NORMAL_MODEL, WHEEL_RAIL), of_columns(&[&PROFILE_COLUMNS]);
        "profile_z" [] Kind::Choice(VerticalAxis::CHOICES), Finite, Text("auto"),
            "direction of z in the file", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_y" [] Kind::Choice(LateralAxis::CHOICES), Finite, Text("auto"),
            "direction of y in the file", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_scale" [] Kind::Number, SCALE, Text("1.0"),
            "factor of y and z in the file", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_smoothing" [ProfileSmoothing] quantity(&Measure::LENGTH), SMOOTHING, Text("0 mm"),
            "L: what is shorter along the profile is levelled out; 5 mm for a measured one", shaping(),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "flange_back_position" [FlangeBackPosition] quantity(&Measure::LENGTH), Between(-1.0, 1.0),
            Computed("-70 mm; 0 mm in files of Miniprof, and where the flange lies so"),
            "y of the flange back in the profile, with y outwards", shaping(), example("-70 mm"),
            with(NORMAL_MODEL, WHEEL_RAIL), usually(Magnitude(0.2));
    };
    WheelYoungModulus, WheelRelaxedModulus, WheelRetardationTime, [WheelPoissonRatio PoissonRatio], WheelConductivity, WheelDensity,
    WheelSpecificHeat, WheelBulkTemperature, WheelRadiusX, WheelRadiusY
}

body! {
    Rail "rail" "The rail: the same fields as the wheel.",
    "inf", "300 mm", &["hertz", "line", "profile", "wheel-rail"], RADIUS, {
        "angular_velocity" [] quantity(&Measure::ANGULAR_VELOCITY), TURNING, Nothing,
            "of a roller of radius radius_x, in place of kinematics.speed", example("20 rad/s"),
            with(NORMAL_MODEL, &["hertz", "line", "profile", "wheel-rail"]);
        "profile" [RailProfile] Kind::Path, Finite, Nothing,
            "profile: a file or the name of one that is built in, such as \"60E1\"; as for the wheel",
            shaping(), example("60E1"), with(NORMAL_MODEL, WHEEL_RAIL), of_columns(&[&PROFILE_COLUMNS]);
        "profile_z" [] Kind::Choice(VerticalAxis::CHOICES), Finite, Text("auto"),
            "direction of z in the file", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_y" [] Kind::Choice(LateralAxis::CHOICES), Finite, Text("auto"),
            "direction of y in the file", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_scale" [] Kind::Number, SCALE, Text("1.0"),
            "factor of y and z in the file", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
        "profile_smoothing" [] quantity(&Measure::LENGTH), SMOOTHING, Text("0 mm"),
            "L: what is shorter along the profile is levelled out; 5 mm for a measured one", shaping(),
            with(NORMAL_MODEL, WHEEL_RAIL);
        "cant" [RailCant] Kind::Number, Magnitude(0.5), Text("0.0"),
            "inclination of the rail towards the middle, such as 0.025 for 1:40; 0 for a profile that is \
             canted already",
            shaping(), with(NORMAL_MODEL, WHEEL_RAIL),
            usually(Magnitude(0.1));
        "origin_y" [RailOrigin] quantity(&Measure::LENGTH), Magnitude(10.0), Nothing,
            "y of the origin of the profile in the track, outwards, in place of track.gauge", shaping(),
            example("760 mm"), with(NORMAL_MODEL, WHEEL_RAIL);
        "origin_z" [] quantity(&Measure::LENGTH), Magnitude(10.0), Text("0 mm"),
            "z of that origin in the track", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
    };
    RailYoungModulus, RailRelaxedModulus, RailRetardationTime, [RailPoissonRatio], RailConductivity, RailDensity,
    RailSpecificHeat, RailBulkTemperature, RailRadiusX, RailRadiusY
}

section! {
    Normal "normal"
        "Where the normal pressure comes from.";

    "model" [] Kind::Choice(NormalModel::CHOICES), Finite, Text("hertz"),
        "source of the pressure", shaping();
    "load" [Load] quantity(&Measure::FORCE), LOAD, Text("80 kN"), "N, normal load; with \"wheel-rail\" the vertical force on the wheel", shaping(),
        default_with(NORMAL_MODEL, &["hertz"]),
        usually(LOAD_OF_WHEEL);
    "approach" [Approach] quantity(&Measure::LENGTH), APPROACH, Nothing,
        "δ, approach of the bodies since they touch, in place of load, which is found", shaping(),
        example("0.05 mm"), with(NORMAL_MODEL, &["hertz", "line", "profile"]),
        usually(Between(1e-7, 1e-3));
    "length" [LineLength] quantity(&Measure::LENGTH), SEMI_AXIS, Nothing,
        "L, length of a line contact across rolling, on which the whole load acts; with \"profile\" for \
         a file of x alone",
        shaping(),
        example("20 mm"), with(NORMAL_MODEL, &["line", "profile"]),
        usually(Between(1e-4, 2.0));
    "semi_axis_x" [SemiAxisX] quantity(&Measure::LENGTH), SEMI_AXIS, Nothing,
        "a, semi-axis along rolling", shaping(), example("6 mm"),
        with(NORMAL_MODEL, &["ellipse"]),
        usually(Between(1e-5, 0.05));
    "semi_axis_y" [SemiAxisY] quantity(&Measure::LENGTH), SEMI_AXIS, Nothing,
        "b, semi-axis across rolling", shaping(), example("5 mm"),
        with(NORMAL_MODEL, &["ellipse"]),
        usually(Between(1e-5, 0.05));
    "peak_pressure" [PeakPressure] quantity(&Measure::PRESSURE), PEAK_PRESSURE, Nothing,
        "p0, largest pressure, in place of load", shaping(), example("1 GPa"),
        with(NORMAL_MODEL, &["ellipse"]),
        usually(Between(1e6, 2e10));
    "file" [PressureTable UndeformedDistance] Kind::Path, Finite, Nothing,
        "CSV with the header `x [mm],y [mm],pressure [MPa]`, or with \"profile\" `x [mm],y \
         [mm],distance [um]`, `y [mm],distance [mm]` (across at x = 0) or `x [mm],distance [mm]` \
         (along, for a line contact); or .npy in Pa or \
         m, each row along x",
        shaping(), example("pressure.csv"), with(NORMAL_MODEL, FILES),
        of_columns(&[&layouts::PRESSURE, &layouts::DISTANCE]);
    "spacing_x" [] quantity(&Measure::LENGTH), SPACING, Nothing,
        "spacing of the columns of an .npy file", shaping(), example("0.5 mm"),
        with(NORMAL_MODEL, FILES);
    "spacing_y" [] quantity(&Measure::LENGTH), SPACING, Nothing,
        "spacing of the rows of an .npy file", shaping(), example("0.5 mm"),
        with(NORMAL_MODEL, FILES);
    "cells" [NormalCells] Kind::Count, Between(16.0, 512.0), Text("128"),
        "cells across the contact each way, on which the pressure of profiles is found (64 with \
         \"wheel-rail\")",
        shaping(), with(NORMAL_MODEL, &["profile", "wheel-rail"]),
        default_with(NORMAL_MODEL, &["profile"]);
    "join_distance" [JoinDistance] quantity(&Measure::LENGTH), Between(0.0, 1.0), Text("8 mm"),
        "distance up to which neighbouring contacts share a plane", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL);
    "join_angle" [JoinAngle] quantity(&Measure::ANGLE), Between(0.0, FRAC_PI_2), Text("20 deg"),
        "difference of their angles up to which they do", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
    "row_motion" [RowMotion] Kind::Choice(RowMotion::CHOICES), Finite, Text("automatic"),
        "with what the rows across a curved contact move", shaping(),
        with(NORMAL_MODEL, WHEEL_RAIL);
    "method" [] Kind::Choice(NormalSolution::CHOICES), Finite, Text("half-spaces"),
        "how the contacts of two profiles are found", shaping(), with(NORMAL_MODEL, WHEEL_RAIL);
}

/// Path of the source of the pressure.
const NORMAL_MODEL: FieldPath = field!("normal.model");
/// The model of two profiles and a position.
const WHEEL_RAIL: &[&str] = &["wheel-rail"];
/// Models that read a file.
const FILES: &[&str] = &["tabulated", "profile"];

/// Path of the model of the surface temperature.
const HEAT_MODEL: FieldPath = field!("heat.model");
/// Models in which friction heats.
const HEATING: &[&str] = &["duhamel", "constant-source"];

section! {
    Heat "heat"
        "Frictional heating of both surfaces.";

    "model" [HeatModel] Kind::Choice(HeatChoice::CHOICES), Finite, Text("duhamel"),
        "model of the surface temperature", with(METHOD, CELLS);
    "partition" [HeatPartition] Kind::NumberOr(PartitionChoice::CHOICES), Between(0.0, 1.0),
        Text("velocity"),
        "share of the wheel, or \"velocity\"", with(HEAT_MODEL, HEATING);
}

section! {
    Cooling "cooling"
        "What cools the wheel in the long run, for `schlupf bulk`." for "bulk";

    "film_coefficient" [FilmCoefficient] quantity(&Measure::HEAT_TRANSFER), THERMAL, Nothing,
        "h, heat transfer coefficient between the wheel and the air", example("40 W/(m^2 K)"),
        usually(Between(0.5, 5e4));
    "area" [CooledArea] quantity(&Measure::AREA), COOLED_AREA, Nothing,
        "A, surface of the wheel that the air cools", example("1.5 m^2"),
        usually(Between(1e-4, 100.0));
    "air_temperature" [AirTemperature] quantity(&Measure::TEMPERATURE), TEMPERATURE,
        Same(field!("rail.bulk_temperature")),
        "temperature of the air", example("20 degC"),
        usually(Between(-80.0, 200.0));
}

section! {
    History "history"
        "Transient rolling: values over time, linear in between, from arrays or from a CSV file; \
         and shifts at rest before it, between equal times, or alone.";

    "time" [Time] Kind::Quantities(&Measure::TIME), INSTANT, Nothing,
        "instants, ascending; the wheel is at rest between equal ones", shaping(), example("[\"0 s\", \"1 ms\"]");
    "start" [] Kind::Choice(StartChoice::CHOICES), Finite, Text("rest"),
        "the state at the first instant";
    "creepage_x" [HistoryCreepageX] Kind::Numbers, CREEPAGE, Nothing,
        "ξ at these instants; likewise the others", example("[0.0, 0.002]"),
        usually(PART_OF_SPEED);
    "creepage_y" [HistoryCreepageY] Kind::Numbers, Inside(-1.0, 1.0), Nothing,
        "η", example("[0.0, 0.0]");
    "spin" [HistorySpin] Kind::Quantities(&Measure::SPIN), TURNING, Nothing,
        "φ", example("[\"0 1/m\", \"0 1/m\"]"),
        usually(SPIN_OF_WHEEL);
    "speed" [HistorySpeed] Kind::Quantities(&Measure::SPEED), SPEED, Nothing,
        "v0", example("[\"30 m/s\", \"30 m/s\"]"),
        usually(ROLLING_SPEED);
    "load" [HistoryLoad] Kind::Quantities(&Measure::FORCE), LOAD, Nothing,
        "N", shaping(), example("[\"80 kN\", \"60 kN\"]"),
        usually(LOAD_OF_WHEEL);
    "force_x" [HistoryForceX] Kind::Quantities(&Measure::FORCE), TANGENTIAL, Nothing,
        "Fx on the wheel, in place of creepage_x and shifts_x", example("[\"0 kN\", \"-20 kN\"]"),
        usually(FORCE_OF_WHEEL);
    "force_y" [HistoryForceY] Kind::Quantities(&Measure::FORCE), TANGENTIAL, Nothing,
        "Fy on the wheel, in place of creepage_y and shifts_y", example("[\"0 kN\", \"5 kN\"]"),
        usually(FORCE_OF_WHEEL);
    "moment_z" [HistoryMomentZ] Kind::Quantities(&Measure::TORQUE), TANGENTIAL, Nothing,
        "Mz on the wheel, in place of spin and turns", example("[\"0 N m\", \"-20 N m\"]");
    "shift_x" [ShiftX] quantity(&Measure::LENGTH), SHIFT, Nothing,
        "shift of the wheel over the rail along rolling, at rest, at the first instant; times may \
         be left out then",
        example("0.015 mm");
    "shift_y" [ShiftY] quantity(&Measure::LENGTH), SHIFT, Nothing,
        "the same across rolling", example("0 mm");
    "turn" [Turn] quantity(&Measure::ANGLE), SHIFT, Nothing,
        "turn of the wheel over the rail about z, likewise", example("0.1 mrad");
    "shifts_x" [HistoryShiftX] Kind::Quantities(&Measure::LENGTH), SHIFT, Nothing,
        "shifts along rolling, each on the way to its instant, which is the first one or equals \
         the one before; without times all are at rest",
        example("[\"0.01 mm\", \"-0.02 mm\"]");
    "shifts_y" [HistoryShiftY] Kind::Quantities(&Measure::LENGTH), SHIFT, Nothing,
        "the same across rolling", example("[\"0 mm\", \"0 mm\"]");
    "turns" [HistoryTurn] Kind::Quantities(&Measure::ANGLE), SHIFT, Nothing,
        "turns about z, likewise", example("[\"0 mrad\", \"0.1 mrad\"]");
    "lateral_position" [] Kind::Quantities(&Measure::LENGTH), Magnitude(1.0), Nothing,
        "that of the wheelset; likewise the others", shaping(),
        example("[\"0 mm\", \"3 mm\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "yaw_angle" [] Kind::Quantities(&Measure::ANGLE), wheel_rail::ANGLE, Nothing, "yaw angle", shaping(),
        example("[\"0 mrad\", \"3 mrad\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "roll_angle" [] Kind::Quantities(&Measure::ANGLE), wheel_rail::ANGLE, Nothing, "roll angle", shaping(),
        example("[\"0 mrad\", \"-1 mrad\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "height" [] Kind::Quantities(&Measure::LENGTH), Magnitude(1.0), Nothing,
        "height, in place of load", shaping(),
        example("[\"-0.1 mm\", \"-0.1 mm\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "lateral_velocity" [] Kind::Quantities(&Measure::SPEED), wheel_rail::SPEED, Nothing, "lateral velocity",
        shaping(), example("[\"0 m/s\", \"0.1 m/s\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "vertical_velocity" [] Kind::Quantities(&Measure::SPEED), wheel_rail::SPEED, Nothing,
        "vertical velocity", shaping(), example("[\"0 m/s\", \"0.1 m/s\"]"),
        with(NORMAL_MODEL, WHEEL_RAIL);
    "yaw_rate" [] Kind::Quantities(&Measure::ANGULAR_VELOCITY), TURNING, Nothing, "yaw rate",
        shaping(), example("[\"0 rad/s\", \"0.1 rad/s\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "roll_rate" [] Kind::Quantities(&Measure::ANGULAR_VELOCITY), TURNING, Nothing, "roll rate",
        shaping(), example("[\"0 rad/s\", \"0.1 rad/s\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "angular_velocity" [] Kind::Quantities(&Measure::ANGULAR_VELOCITY), TURNING, Nothing,
        "angular velocity of the wheel, in place of creepage_x", shaping(),
        example("[\"60 rad/s\", \"64.7 rad/s\"]"), with(NORMAL_MODEL, WHEEL_RAIL);
    "shift_duration" [ShiftDuration] quantity(&Measure::TIME), Between(0.0, 1e3), Text("0 s"),
        "how long the motion of the wheelset acts between equal times, as a shift at rest",
        example("1 s"), with(NORMAL_MODEL, WHEEL_RAIL);
    "file" [] Kind::Path, Finite, Nothing,
        "CSV with a header such as `time [s],creepage_x,load [kN]`, in place of the arrays",
        shaping(), example("history.csv"), of_columns(&[&layouts::HISTORY]);
}
