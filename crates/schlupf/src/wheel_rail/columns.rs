//! The columns of a wheel and of its contacts.

use crate::reporting::{Column, Record, columns};

use super::{Contact, WheelSolution};

/// A wheel as a whole, one row, under the dotted names that it has in JSON.
impl Record for WheelSolution {
    fn rows(&self) -> usize {
        1
    }

    const COLUMNS: &'static [Column<Self>] = columns! { WheelSolution:
        WheelsetHeight "wheelset.height" => |wheel, _| wheel.height,
        RollAngle "wheelset.roll_angle" => |wheel, _| wheel.position.roll,
        AngularVelocity "wheelset.angular_velocity" => |wheel, _| wheel.angular_velocity,
        WheelForceX "wheel_force.x" => |wheel, _| wheel.force[0],
        WheelForceY "wheel_force.y" => |wheel, _| wheel.force[1],
        WheelForceZ "wheel_force.z" => |wheel, _| wheel.force[2],
        ContactCount "contacts" => |wheel, _| wheel.contacts.len(),
    };
}

/// A contact of a wheel, one row, under the dotted names that it has in JSON.
impl Record for Contact {
    fn rows(&self) -> usize {
        1
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Contact:
        PositionX "position.x" => |contact, _| contact.position[0],
        PositionY "position.y" => |contact, _| contact.position[1],
        PositionZ "position.z" => |contact, _| contact.position[2],
        ContactAngle "angle" => |contact, _| contact.angle,
        RiseAngle "rise_angle" => |contact, _| contact.rise,
        RailPosition => |contact, _| contact.rail_position,
        WheelPosition => |contact, _| contact.wheel_position,
        RollingRadius => |contact, _| contact.rolling_radius,
        Speed => |contact, _| contact.solution.kinematics.speed,
        CreepageX => |contact, _| contact.solution.kinematics.creepage_x,
        CreepageY => |contact, _| contact.solution.kinematics.creepage_y,
        Spin => |contact, _| contact.solution.kinematics.spin,
        Load "normal.load" => |contact, _| contact.solution.normal.load,
        SemiAxisX "normal.semi_axis_x" => |contact, _| contact.solution.normal.semi_axis_x,
        SemiAxisY "normal.semi_axis_y" => |contact, _| contact.solution.normal.semi_axis_y,
        PeakPressure "normal.peak_pressure" => |contact, _| {
            contact.solution.normal.peak_pressure
        },
        ForceX "force.x" => |contact, _| contact.solution.force.x,
        ForceY "force.y" => |contact, _| contact.solution.force.y,
        MomentZ "force.moment_z" => |contact, _| contact.solution.force.moment_z,
        NormalisedX "normalised.x" => |contact, _| contact.solution.normalised.x,
        NormalisedY "normalised.y" => |contact, _| contact.solution.normalised.y,
        NormalisedMomentZ "normalised.moment_z" => |contact, _| {
            contact.solution.normalised.moment_z
        },
        WearNumber "t_gamma.without_spin" => |contact, _| contact.solution.t_gamma.without_spin,
        WearNumber "t_gamma.with_spin" => |contact, _| contact.solution.t_gamma.with_spin,
        FrictionPower "friction_power" => |contact, _| {
            contact.solution.power.map(|power| power.friction)
        },
        MaxRise "max_rise" => |contact, _| contact.solution.temperature.map(|t| t.max_rise),
        ContactArea "area.contact" => |contact, _| contact.solution.area.contact,
        Residual => |contact, _| contact.solution.residual,
    };
}
