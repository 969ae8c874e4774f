//! The columns of a creep curve.

use crate::reporting::{Column, Record, columns};

use super::CreepCurve;

/// Points in the order of the path; forces on the wheel.
impl Record for CreepCurve {
    fn rows(&self) -> usize {
        self.points.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { CreepCurve:
        Speed => |curve, k| curve.points[k].kinematics.speed,
        CreepageX => |curve, k| curve.points[k].kinematics.creepage_x,
        CreepageY => |curve, k| curve.points[k].kinematics.creepage_y,
        Spin => |curve, k| curve.points[k].kinematics.spin,
        ForceX => |curve, k| curve.points[k].force.x,
        ForceY => |curve, k| curve.points[k].force.y,
        MomentZ => |curve, k| curve.points[k].force.moment_z,
        NormalisedX => |curve, k| curve.points[k].normalised.x,
        NormalisedY => |curve, k| curve.points[k].normalised.y,
        NormalisedMomentZ => |curve, k| curve.points[k].normalised.moment_z,
        TractionCoefficient => |curve, k| curve.points[k].traction_coefficient,
        ForceErrorX => |curve, k| curve.points[k].error.map(|error| error.x),
        ForceErrorY => |curve, k| curve.points[k].error.map(|error| error.y),
        MomentErrorZ => |curve, k| curve.points[k].error.and_then(|error| error.moment_z),
        FrictionPower => |curve, k| curve.points[k].power.map(|power| power.friction),
        CreepPower => |curve, k| curve.points[k].power.map(|power| power.creep),
        MaxRise => |curve, k| curve.points[k].max_rise,
        ContactArea => |curve, k| curve.points[k].area.contact,
        StickArea => |curve, k| curve.points[k].area.stick,
        SlipArea => |curve, k| curve.points[k].area.slip,
        Residual => |curve, k| curve.points[k].residual,
        Strategy => |curve, k| curve.points[k].work.strategy,
        NewtonIterations => |curve, k| curve.points[k].work.newton_iterations,
        OperatorProducts => |curve, k| curve.points[k].work.operator_products,
        Convergence "status" => |curve, k| curve.points[k].status,
    };
}
