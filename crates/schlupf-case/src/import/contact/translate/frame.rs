//! From the frame of an input file of module 3 to ours.

use std::f64::consts::PI;

use crate::import::contact::basic::Rolling;

/// Which body is the wheel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WheelBody {
    /// Body 1, above z = 0: signs stay as they are.
    #[default]
    First,
    /// Body 2.
    Second,
}

impl WheelBody {
    /// Its place in a pair of bodies.
    pub fn index(self) -> usize {
        match self {
            Self::First => 0,
            Self::Second => 1,
        }
    }
}

/// Which way the axes of the file point, seen in our frame.
///
/// In CONTACT slip is that of body 1 minus that of body 2, and z points into body 1. If body 2 is
/// the wheel, y points to the right, so that the slip of wheel minus rail is (−w_x, w_y) in our
/// axes. Rolling along −x turns both axes by π about z. Tractions on the wheel change alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Of x components of slips and forces, 1 or −1, dimensionless.
    pub component_x: f64,
    /// Of y components, 1 or −1, dimensionless.
    pub component_y: f64,
    /// Of x coordinates, 1 or −1, dimensionless.
    pub coordinate_x: f64,
    /// Of y coordinates, 1 or −1, dimensionless.
    pub coordinate_y: f64,
}

/// Largest deviation of the rolling direction from the axis, in rad.
const STRAIGHT: f64 = 1e-6;

impl Frame {
    /// That of a case; nothing for a direction of rolling that is not along x.
    pub fn new(wheel: WheelBody, rolling: Option<&Rolling>) -> Option<Self> {
        let direction = rolling.map_or(0.0, |rolling| rolling.direction.value);
        let turned = (direction - 2.0 * PI * (direction / (2.0 * PI)).round()).abs();
        let along = if turned < STRAIGHT {
            1.0
        } else if (turned - PI).abs() < STRAIGHT {
            -1.0
        } else {
            return None;
        };
        let side = match wheel {
            WheelBody::First => 1.0,
            WheelBody::Second => -1.0,
        };
        Some(Self {
            component_x: side * along,
            component_y: along,
            coordinate_x: along,
            coordinate_y: side * along,
        })
    }
}
