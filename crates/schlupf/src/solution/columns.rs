//! The columns of a solution.

use crate::reporting::{Column, Record, Value, columns};

use super::{Fields, Instant, Power, Solution, Status, Strategy, Temperature};

/// Contact cells, strip by strip from the leading to the trailing edge; tractions on the wheel.
impl Record for Fields {
    fn rows(&self) -> usize {
        self.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Fields:
        X => |fields, k| fields.x[k],
        Y => |fields, k| fields.y[k],
        Pressure => |fields, k| fields.pressure[k],
        TractionX => |fields, k| fields.traction_x[k],
        TractionY => |fields, k| fields.traction_y[k],
        SlipX => |fields, k| fields.slip_x[k],
        SlipY => |fields, k| fields.slip_y[k],
        DisplacementX => |fields, k| fields.displacement_x[k],
        DisplacementY => |fields, k| fields.displacement_y[k],
        Friction "friction_coefficient" => |fields, k| fields.friction_coefficient[k],
        FrictionPowerDensity "friction_power" => |fields, k| fields.friction_power[k],
        RiseWheel => |fields, k| fields.temperature_rise_wheel[k],
        RiseRail => |fields, k| fields.temperature_rise_rail[k],
        Covered => |fields, k| fields.covered[k],
        Sliding => |fields, k| fields.sliding[k],
    };
}

/// The scalars of a solution, one row, under the dotted names that they have in JSON.
impl Record for Solution {
    fn rows(&self) -> usize {
        1
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Solution:
        Load "normal.load" => |solution, _| solution.normal.load,
        SemiAxisX "normal.semi_axis_x" => |solution, _| solution.normal.semi_axis_x,
        SemiAxisY "normal.semi_axis_y" => |solution, _| solution.normal.semi_axis_y,
        PeakPressure "normal.peak_pressure" => |solution, _| solution.normal.peak_pressure,
        Approach "normal.approach" => |solution, _| solution.normal.approach,
        Speed "kinematics.speed" => |solution, _| solution.kinematics.speed,
        CreepageX "kinematics.creepage_x" => |solution, _| solution.kinematics.creepage_x,
        CreepageY "kinematics.creepage_y" => |solution, _| solution.kinematics.creepage_y,
        Spin "kinematics.spin" => |solution, _| solution.kinematics.spin,
        ForceX "force.x" => |solution, _| solution.force.x,
        ForceY "force.y" => |solution, _| solution.force.y,
        MomentZ "force.moment_z" => |solution, _| solution.force.moment_z,
        NormalisedX "normalised.x" => |solution, _| solution.normalised.x,
        NormalisedY "normalised.y" => |solution, _| solution.normalised.y,
        NormalisedMomentZ "normalised.moment_z" => |solution, _| solution.normalised.moment_z,
        TractionCoefficient => |solution, _| solution.traction_coefficient,
        ForceErrorX "extrapolation.error.x" => |solution, _| {
            solution.extrapolation.map(|found| found.error.x)
        },
        ForceErrorY "extrapolation.error.y" => |solution, _| {
            solution.extrapolation.map(|found| found.error.y)
        },
        MomentErrorZ "extrapolation.error.moment_z" => |solution, _| {
            solution.extrapolation.and_then(|found| found.error.moment_z)
        },
        FrictionPower "power.friction" => |solution, _| solution.power.map(|p| p.friction),
        CreepPower "power.creep" => |solution, _| solution.power.map(|p| p.creep),
        ReturnedPower "power.returned" => |solution, _| solution.power.map(|p| p.returned),
        HeatIntoWheel "power.into_wheel" => |solution, _| solution.power.map(|p| p.into_wheel),
        HeatIntoRail "power.into_rail" => |solution, _| solution.power.map(|p| p.into_rail),
        HeatExchanged "power.exchanged" => |solution, _| solution.power.and_then(|p| p.exchanged),
        WearNumber "t_gamma.without_spin" => |solution, _| solution.t_gamma.without_spin,
        WearNumber "t_gamma.with_spin" => |solution, _| solution.t_gamma.with_spin,
        MaxRise "temperature.max_rise" => |solution, _| solution.temperature.map(|t| t.max_rise),
        MaxRiseWheel "temperature.max_rise_wheel" => |solution, _| {
            solution.temperature.map(|t| t.max_rise_wheel)
        },
        MaxRiseRail "temperature.max_rise_rail" => |solution, _| {
            solution.temperature.map(|t| t.max_rise_rail)
        },
        MaxTemperatureWheel "temperature.max_wheel" => |solution, _| {
            solution.temperature.map(|t| t.max_wheel)
        },
        MaxTemperatureRail "temperature.max_rail" => |solution, _| {
            solution.temperature.map(|t| t.max_rail)
        },
        X "temperature.x" => |solution, _| solution.temperature.map(|t| t.x),
        Y "temperature.y" => |solution, _| solution.temperature.map(|t| t.y),
        PecletNumber "temperature.peclet_wheel" => |solution, _| solution.peclet[0],
        PecletNumber "temperature.peclet_rail" => |solution, _| solution.peclet[1],
        ContactArea "area.contact" => |solution, _| solution.area.contact,
        StickArea "area.stick" => |solution, _| solution.area.stick,
        SlipArea "area.slip" => |solution, _| solution.area.slip,
        Residual => |solution, _| solution.residual,
        Strategy "work.strategy" => |solution, _| solution.work.strategy,
        NewtonIterations "work.newton_iterations" => |solution, _| {
            solution.work.newton_iterations
        },
        OperatorProducts "work.operator_products" => |solution, _| {
            solution.work.operator_products
        },
    };
}

/// The powers of a solution, one row.
impl Record for Power {
    fn rows(&self) -> usize {
        1
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Power:
        FrictionPower "friction" => |power, _| power.friction,
        CreepPower "creep" => |power, _| power.creep,
        ReturnedPower "returned" => |power, _| power.returned,
        HeatIntoWheel "into_wheel" => |power, _| power.into_wheel,
        HeatIntoRail "into_rail" => |power, _| power.into_rail,
        HeatExchanged "exchanged" => |power, _| power.exchanged,
    };
}

/// The largest temperatures of a solution, one row.
impl Record for Temperature {
    fn rows(&self) -> usize {
        1
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Temperature:
        MaxRise => |largest, _| largest.max_rise,
        MaxRiseWheel => |largest, _| largest.max_rise_wheel,
        MaxRiseRail => |largest, _| largest.max_rise_rail,
        MaxTemperatureWheel "max_wheel" => |largest, _| largest.max_wheel,
        MaxTemperatureRail "max_rail" => |largest, _| largest.max_rail,
        X => |largest, _| largest.x,
        Y => |largest, _| largest.y,
    };
}

/// Time steps; forces on the wheel.
impl Record for [Instant] {
    fn rows(&self) -> usize {
        self.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { [Instant]:
        Time => |steps, k| steps[k].time,
        Distance => |steps, k| steps[k].distance,
        Speed => |steps, k| steps[k].kinematics.speed,
        CreepageX => |steps, k| steps[k].kinematics.creepage_x,
        CreepageY => |steps, k| steps[k].kinematics.creepage_y,
        Spin => |steps, k| steps[k].kinematics.spin,
        ShiftX => |steps, k| steps[k].shift.map(|shift| shift[0]),
        ShiftY => |steps, k| steps[k].shift.map(|shift| shift[1]),
        Turn => |steps, k| steps[k].shift.map(|shift| shift[2]),
        Load => |steps, k| steps[k].load,
        ForceX => |steps, k| steps[k].force.x,
        ForceY => |steps, k| steps[k].force.y,
        MomentZ => |steps, k| steps[k].force.moment_z,
        FrictionPower => |steps, k| steps[k].friction_power,
        CreepPower => |steps, k| steps[k].creep_power,
        StoredEnergy => |steps, k| steps[k].stored_energy,
        MaxRise => |steps, k| steps[k].max_rise,
        Residual => |steps, k| steps[k].residual,
        NewtonIterations => |steps, k| steps[k].newton_iterations,
    };
}

impl From<Status> for Value {
    fn from(status: Status) -> Self {
        Self::Name(status.name())
    }
}

impl From<Option<Strategy>> for Value {
    fn from(strategy: Option<Strategy>) -> Self {
        strategy.map_or(Self::Unknown, |strategy| Self::Name(strategy.name()))
    }
}
