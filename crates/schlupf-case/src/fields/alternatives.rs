//! Fields of which only one side may be given.

use super::FieldPath;

/// Two groups of fields that say the same thing in different ways.
#[derive(Debug)]
pub struct Alternatives {
    /// One way.
    pub first: &'static [FieldPath],
    /// The other way.
    pub second: &'static [FieldPath],
    /// Why only one may be given.
    pub reason: &'static str,
}

const HEIGHTS: &[FieldPath] = &fields![
    "contact_law.roughness.rms_height",
    "contact_law.roughness.rms_height_wheel",
    "contact_law.roughness.rms_height_rail",
];

/// Fields that ask for the micro model, without a file.
pub const MICRO_MODEL: &[FieldPath] = &fields![
    "contact_law.roughness.longest_wavelength",
    "contact_law.roughness.roll_off_wavelength",
    "contact_law.roughness.shortest_wavelength",
    "contact_law.roughness.rms_slope",
    "contact_law.roughness.hurst",
    "contact_law.roughness.cells",
    "contact_law.roughness.seed",
    "contact_law.roughness.hardness",
    "contact_law.roughness.pressures",
];

/// Fields that go with a surface file.
pub const OF_FILE: &[FieldPath] = &fields![
    "contact_law.roughness.second_file",
    "contact_law.roughness.unit",
    "contact_law.roughness.spacing",
    "contact_law.roughness.form",
    "contact_law.roughness.cutoff_wavelength",
    "contact_law.roughness.fill_holes",
    "contact_law.roughness.square_cells",
];

/// Stiffnesses of the elasticity: so many per area, then those for each cell.
pub const STIFFNESSES: &[FieldPath] = &fields![
    "elasticity.bedding_x",
    "elasticity.bedding_y",
    "elasticity.coupling_x",
    "elasticity.coupling_x_across",
    "elasticity.coupling_y",
    "elasticity.coupling_y_across",
    "elasticity.spring_x",
    "elasticity.spring_y",
    "elasticity.spring_coupling_x",
    "elasticity.spring_coupling_y",
];
const PER_AREA: usize = 6;

/// All fields of the roughness.
pub const ROUGHNESS: &[FieldPath] = &fields![
    "contact_law.roughness.rms_height",
    "contact_law.roughness.rms_height_wheel",
    "contact_law.roughness.rms_height_rail",
    "contact_law.roughness.slope_factor",
    "contact_law.roughness.rms_slope",
    "contact_law.roughness.longest_wavelength",
    "contact_law.roughness.roll_off_wavelength",
    "contact_law.roughness.shortest_wavelength",
    "contact_law.roughness.hurst",
    "contact_law.roughness.file",
    "contact_law.roughness.second_file",
    "contact_law.roughness.unit",
    "contact_law.roughness.spacing",
    "contact_law.roughness.form",
    "contact_law.roughness.cutoff_wavelength",
    "contact_law.roughness.fill_holes",
    "contact_law.roughness.square_cells",
    "contact_law.roughness.cells",
    "contact_law.roughness.seed",
    "contact_law.roughness.hardness",
    "contact_law.roughness.pressures",
];

/// Fields that make a history, each by itself.
pub const HISTORY: &[FieldPath] = &fields![
    "history.file",
    "history.time",
    "history.shift_x",
    "history.shift_y",
    "history.turn",
    "history.shifts_x",
    "history.shifts_y",
    "history.turns",
];

/// Fields that prescribe the longitudinal force.
const LONGITUDINAL_FORCES: &[FieldPath] = &fields![
    "kinematics.force_x",
    "kinematics.traction_coefficient",
    "kinematics.wheel_torque",
    "history.force_x",
];

/// All pairs of groups that exclude each other.
pub const ALTERNATIVES: &[Alternatives] = &[
    Alternatives {
        first: &fields!["kinematics.angular_velocity"],
        second: &fields!["kinematics.creepage_x", "history.creepage_x", "history.speed"],
        reason: "the angular velocity determines the longitudinal creepage at a given speed",
    },
    Alternatives {
        first: &fields!["rail.angular_velocity"],
        second: &fields!["kinematics.speed", "history.speed"],
        reason: "the angular velocity of a roller determines the speed of its circumference",
    },
    Alternatives {
        first: &fields!["rail.origin_y"],
        second: &fields!["track.gauge", "track.gauge_depth"],
        reason: "a rail is placed by the origin of its profile or by its gauge",
    },
    Alternatives {
        first: LONGITUDINAL_FORCES,
        second: &fields![
            "kinematics.creepage_x",
            "kinematics.angular_velocity",
            "history.creepage_x",
            "history.angular_velocity",
            "history.shift_x",
            "history.shifts_x",
        ],
        reason: "a longitudinal force determines the longitudinal creepage or shift",
    },
    Alternatives {
        first: &fields!["kinematics.force_x", "history.force_x"],
        second: &fields!["kinematics.traction_coefficient", "kinematics.wheel_torque"],
        reason: "all of them prescribe the longitudinal force",
    },
    Alternatives {
        first: &fields!["kinematics.traction_coefficient"],
        second: &fields!["kinematics.wheel_torque"],
        reason: "both prescribe the longitudinal force",
    },
    Alternatives {
        first: &fields!["kinematics.force_y", "history.force_y"],
        second: &fields![
            "kinematics.creepage_y",
            "kinematics.yaw_angle",
            "history.creepage_y",
            "history.shift_y",
            "history.shifts_y",
        ],
        reason: "the lateral force determines the lateral creepage or shift",
    },
    Alternatives {
        first: &fields!["kinematics.moment_z", "history.moment_z"],
        second: &fields!["kinematics.spin", "history.spin", "history.turn", "history.turns"],
        reason: "the moment determines the spin or the turn",
    },
    Alternatives {
        first: &fields!["kinematics.yaw_angle"],
        second: &fields!["kinematics.creepage_y", "history.creepage_y"],
        reason: "the yaw angle determines the lateral creepage",
    },
    Alternatives {
        first: &fields!["normal.peak_pressure"],
        second: &fields!["normal.load", "history.load"],
        reason: "with the semi-axes, the peak pressure determines the load",
    },
    Alternatives {
        first: &fields!["normal.approach"],
        second: &fields!["normal.load", "history.load"],
        reason: "the approach determines the load",
    },
    Alternatives {
        first: STIFFNESSES.split_at(PER_AREA).0,
        second: STIFFNESSES.split_at(PER_AREA).1,
        reason: "stiffnesses are given per area (bedding, coupling) or for each cell (spring)",
    },
    Alternatives {
        first: &fields!["elasticity.calibration"],
        second: STIFFNESSES,
        reason: "the calibration gives all stiffnesses",
    },
    Alternatives {
        first: &fields!["contact_law.stiffness"],
        second: ROUGHNESS,
        reason: "the roughness determines k_c",
    },
    Alternatives {
        first: &fields!["contact_law.roughness.rms_height"],
        second: &fields![
            "contact_law.roughness.rms_height_wheel",
            "contact_law.roughness.rms_height_rail",
        ],
        reason: "h_rms is that of both surfaces together, or given for each of them",
    },
    Alternatives {
        first: &fields!["contact_law.roughness.rms_slope"],
        second: HEIGHTS,
        reason: "with its spectrum, the slope determines the height of a surface",
    },
    Alternatives {
        first: &fields!["contact_law.roughness.file", "contact_law.roughness.second_file"],
        second: &fields![
            "contact_law.roughness.rms_height",
            "contact_law.roughness.rms_height_wheel",
            "contact_law.roughness.rms_height_rail",
            "contact_law.roughness.slope_factor",
            "contact_law.roughness.rms_slope",
            "contact_law.roughness.longest_wavelength",
            "contact_law.roughness.roll_off_wavelength",
            "contact_law.roughness.shortest_wavelength",
            "contact_law.roughness.hurst",
        ],
        reason: "the surface comes from a file or from a spectrum",
    },
    Alternatives {
        first: &fields!["contact_law.roughness.slope_factor"],
        second: MICRO_MODEL,
        reason: "γ is of the closed form; the micro model finds its own",
    },
    Alternatives {
        first: &fields!["history.file"],
        second: &fields![
            "history.time",
            "history.speed",
            "history.creepage_x",
            "history.creepage_y",
            "history.spin",
            "history.load",
            "history.force_x",
            "history.force_y",
            "history.moment_z",
            "history.shifts_x",
            "history.shifts_y",
            "history.turns",
        ],
        reason: "a history comes from a file or stands in the case",
    },
    Alternatives {
        first: &fields!["history.angular_velocity"],
        second: &fields!["history.creepage_x"],
        reason: "the angular velocity determines the longitudinal creepage at a given speed",
    },
    Alternatives {
        first: &fields!["history.height"],
        second: &fields!["history.load"],
        reason: "the height determines the load",
    },
    Alternatives {
        first: &fields!["history.shift_x", "history.shift_y", "history.turn"],
        second: &fields!["history.shifts_x", "history.shifts_y", "history.turns"],
        reason: "there is one shift, at the first instant, or one for each",
    },
    Alternatives {
        first: &fields!["friction.variation_file"],
        second: &fields![
            "friction.variation_y",
            "friction.variation_inclination",
            "friction.variation_factor",
        ],
        reason: "friction over y comes from a file or stands in the case",
    },
    Alternatives {
        first: &fields!["friction.variation_y"],
        second: &fields!["friction.variation_inclination"],
        reason: "friction varies over the patch or over the profile of the rail",
    },
    Alternatives {
        first: &fields!["damage.wear_map"],
        second: &fields![
            "damage.wear_coefficient_mild",
            "damage.wear_coefficient_severe",
            "damage.wear_coefficient_catastrophic",
        ],
        reason: "the coefficients are those of the map of KTH, or those of a file",
    },
];

impl Alternatives {
    /// The fields on the other side of one.
    pub fn opposite(&self, path: FieldPath) -> &'static [FieldPath] {
        if self.first.contains(&path) {
            self.second
        } else if self.second.contains(&path) {
            self.first
        } else {
            &[]
        }
    }
}

/// Fields that count only beside one of others that have no default.
const COMPANIONS: &[(FieldPath, &[FieldPath])] = &[
    (field!("rail.origin_z"), &fields!["rail.origin_y"]),
    (field!("left_rail.origin_z"), &fields!["left_rail.origin_y", "rail.origin_y"]),
    (field!("right_rail.origin_z"), &fields!["right_rail.origin_y", "rail.origin_y"]),
    (field!("friction.second_half_speed"), &fields!["friction.second_coefficient"]),
    (field!("friction.memory_speed"), &fields!["friction.memory_distance"]),
    (field!("cooling.area"), &fields!["cooling.film_coefficient"]),
    (field!("cooling.air_temperature"), &fields!["cooling.film_coefficient"]),
];

/// The fields without any of which this one does not count; empty if it always does.
pub fn companions(path: FieldPath) -> &'static [FieldPath] {
    COMPANIONS.iter().find(|(of, _)| *of == path).map_or(&[], |(_, companions)| companions)
}

/// Fields that decide together with another one whether a case is possible.
const RELATED: &[(FieldPath, &[FieldPath])] = &[(
    field!("friction.reference_temperature"),
    &fields![
        "friction.temperature_at_zero_friction",
        "friction.temperature_range",
        "wheel.bulk_temperature",
        "rail.bulk_temperature",
    ],
)];

/// Fields to look at when another one is refused but has its default: its alternatives, and those
/// that it has to fit.
pub fn related(path: FieldPath) -> impl Iterator<Item = FieldPath> {
    let alternatives = ALTERNATIVES.iter().flat_map(move |pair| pair.opposite(path));
    let related = RELATED.iter().filter(move |(of, _)| *of == path).flat_map(|(_, paths)| *paths);
    alternatives.chain(related).copied()
}
