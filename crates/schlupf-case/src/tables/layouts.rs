//! The columns of the tables that fields of a case name, in the order that messages show.

use super::columns::Column;
use crate::units::Measure;

/// Of a pressure on a lattice.
pub const PRESSURE: [Column; 3] = [
    Column { name: "x", measure: Some(&Measure::LENGTH), required: true, holes: false },
    Column { name: "y", measure: Some(&Measure::LENGTH), required: true, holes: false },
    Column { name: "pressure", measure: Some(&Measure::PRESSURE), required: true, holes: false },
];

/// Of an undeformed distance: on a lattice, or across or along alone.
pub const DISTANCE: [Column; 3] = [
    Column { name: "x", measure: Some(&Measure::LENGTH), required: false, holes: false },
    Column { name: "y", measure: Some(&Measure::LENGTH), required: false, holes: false },
    Column { name: "distance", measure: Some(&Measure::LENGTH), required: true, holes: false },
];

/// Of a history.
pub const HISTORY: [Column; 12] = [
    Column { name: "time", measure: Some(&Measure::TIME), required: true, holes: false },
    Column { name: "shifts_x", measure: Some(&Measure::LENGTH), required: false, holes: false },
    Column { name: "shifts_y", measure: Some(&Measure::LENGTH), required: false, holes: false },
    Column { name: "turns", measure: Some(&Measure::ANGLE), required: false, holes: false },
    Column { name: "creepage_x", measure: None, required: false, holes: false },
    Column { name: "creepage_y", measure: None, required: false, holes: false },
    Column { name: "spin", measure: Some(&Measure::SPIN), required: false, holes: false },
    Column { name: "speed", measure: Some(&Measure::SPEED), required: false, holes: false },
    Column { name: "load", measure: Some(&Measure::FORCE), required: false, holes: false },
    Column { name: "force_x", measure: Some(&Measure::FORCE), required: false, holes: false },
    Column { name: "force_y", measure: Some(&Measure::FORCE), required: false, holes: false },
    Column { name: "moment_z", measure: Some(&Measure::TORQUE), required: false, holes: false },
];

/// Of factors on friction over y.
pub const VARIATION: [Column; 2] = [
    Column { name: "y", measure: Some(&Measure::LENGTH), required: true, holes: false },
    Column { name: "factor", measure: None, required: true, holes: false },
];

/// Of a map of coefficients of wear.
pub const WEAR_MAP: [Column; 3] = [
    Column { name: "slip_speed", measure: Some(&Measure::SPEED), required: true, holes: false },
    Column { name: "pressure_ratio", measure: None, required: true, holes: false },
    Column { name: "coefficient", measure: None, required: true, holes: false },
];
