//! Results as columns: name, quantity and getter of every number of a record.
//!
//! CSV, JSON, VTK and all other outputs read these tables, so a number added here appears in all of
//! them.

use crate::creep_curve::CreepCurve;
use crate::damage::{PassageProfile, Profile, RunPoint, WearCells};
use crate::interface::roughness::load_curve::LoadCurve;
use crate::interface::roughness::tangential_curve::TangentialCurve;
use crate::quantity::Quantity;
use crate::solution::{Fields, Instant, Power, Solution, Status, Strategy, Temperature};
use crate::subsurface::PointStress;
use crate::surface::spectrum::RadialSpectrum;
use crate::wheel_rail::{Contact, WheelSolution};

/// An entry of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number, in the unit of the quantity or dimensionless.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// A yes/no value.
    Flag(bool),
    /// One of several names.
    Name(&'static str),
    /// An unknown value.
    Unknown,
}

impl Value {
    /// The entry as a number (in the unit of the quantity, or dimensionless), if it is one; a flag
    /// is 0 or 1.
    pub fn number(self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(number),
            Self::Count(count) => Some(count as f64),
            Self::Flag(flag) => Some(f64::from(u8::from(flag))),
            Self::Name(_) | Self::Unknown => None,
        }
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Option<f64>> for Value {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Unknown, Self::Number)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<bool> for Value {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
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

/// A column of a record.
#[derive(Debug, Clone, Copy)]
pub struct Column<R: ?Sized> {
    /// Name in results.
    pub name: &'static str,
    /// The quantity in the column: symbol, unit, description.
    pub quantity: Quantity,
    /// The entry of a row.
    pub value: fn(&R, usize) -> Value,
}

impl<R: ?Sized> Column<R> {
    /// A column with the name of its quantity.
    pub const fn new(quantity: Quantity, value: fn(&R, usize) -> Value) -> Self {
        Self { name: quantity.name(), quantity, value }
    }

    /// The same column under another name.
    #[must_use]
    pub const fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }
}

/// A result consisting of rows with the same columns.
pub trait Record: Send + Sync + 'static {
    /// Number of rows.
    fn rows(&self) -> usize;

    /// The columns.
    fn columns() -> &'static [Column<Self>];
}

/// Defines the columns of a record: `quantity => |record, row| entry`, with another name in quotes
/// if that of the quantity says too much.
#[macro_export]
macro_rules! columns {
    ($record:ty: $($quantity:ident $($name:literal)? => |$r:pat_param, $k:pat_param| $value:expr),* $(,)?) => {{
        const COLUMNS: &[$crate::columns::Column<$record>] = &[$(
            $crate::columns::Column::new(
                $crate::Quantity::$quantity,
                |$r: &$record, $k: usize| $crate::columns::Value::from($value),
            )$(.named($name))?
        ),*];
        COLUMNS
    }};
}

/// Contact cells, strip by strip from the leading to the trailing edge; tractions on the wheel.
impl Record for Fields {
    fn rows(&self) -> usize {
        self.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Fields:
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
        }
    }
}

/// The scalars of a solution, one row, under the dotted names that they have in JSON.
impl Record for Solution {
    fn rows(&self) -> usize {
        1
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Solution:
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
        }
    }
}

/// A wheel as a whole, one row, under the dotted names that it has in JSON.
impl Record for WheelSolution {
    fn rows(&self) -> usize {
        1
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { WheelSolution:
            WheelsetHeight "wheelset.height" => |wheel, _| wheel.height,
            RollAngle "wheelset.roll_angle" => |wheel, _| wheel.position.roll,
            AngularVelocity "wheelset.angular_velocity" => |wheel, _| wheel.angular_velocity,
            WheelForceX "wheel_force.x" => |wheel, _| wheel.force[0],
            WheelForceY "wheel_force.y" => |wheel, _| wheel.force[1],
            WheelForceZ "wheel_force.z" => |wheel, _| wheel.force[2],
            ContactCount "contacts" => |wheel, _| wheel.contacts.len(),
        }
    }
}

/// A contact of a wheel, one row, under the dotted names that it has in JSON.
impl Record for Contact {
    fn rows(&self) -> usize {
        1
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Contact:
            PositionX "position.x" => |contact, _| contact.position[0],
            PositionY "position.y" => |contact, _| contact.position[1],
            PositionZ "position.z" => |contact, _| contact.position[2],
            ContactAngle "angle" => |contact, _| contact.angle,
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
        }
    }
}

/// The powers of a solution, one row.
impl Record for Power {
    fn rows(&self) -> usize {
        1
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Power:
            FrictionPower "friction" => |power, _| power.friction,
            CreepPower "creep" => |power, _| power.creep,
            ReturnedPower "returned" => |power, _| power.returned,
            HeatIntoWheel "into_wheel" => |power, _| power.into_wheel,
            HeatIntoRail "into_rail" => |power, _| power.into_rail,
            HeatExchanged "exchanged" => |power, _| power.exchanged,
        }
    }
}

/// The largest temperatures of a solution, one row.
impl Record for Temperature {
    fn rows(&self) -> usize {
        1
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Temperature:
            MaxRise => |largest, _| largest.max_rise,
            MaxRiseWheel => |largest, _| largest.max_rise_wheel,
            MaxRiseRail => |largest, _| largest.max_rise_rail,
            MaxTemperatureWheel "max_wheel" => |largest, _| largest.max_wheel,
            MaxTemperatureRail "max_rail" => |largest, _| largest.max_rail,
            X => |largest, _| largest.x,
            Y => |largest, _| largest.y,
        }
    }
}

/// Time steps; forces on the wheel.
impl Record for [Instant] {
    fn rows(&self) -> usize {
        self.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { [Instant]:
            Time => |steps, k| steps[k].time,
            Distance => |steps, k| steps[k].distance,
            Speed => |steps, k| steps[k].kinematics.speed,
            CreepageX => |steps, k| steps[k].kinematics.creepage_x,
            CreepageY => |steps, k| steps[k].kinematics.creepage_y,
            Spin => |steps, k| steps[k].kinematics.spin,
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
        }
    }
}

/// Points in the order of the path; forces on the wheel.
impl Record for CreepCurve {
    fn rows(&self) -> usize {
        self.points.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { CreepCurve:
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
        }
    }
}

/// Depth of wear across the profile.
impl Record for Profile {
    fn rows(&self) -> usize {
        self.y.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { Profile:
            Y => |profile, k| profile.y[k],
            WearDepth "wheel_archard" => |profile, k| profile.wheel_archard[k],
            WearDepth "wheel_energy" => |profile, k| profile.wheel_energy[k],
            WearDepth "rail_archard" => |profile, k| profile.rail_archard[k],
            WearDepth "rail_energy" => |profile, k| profile.rail_energy[k],
        }
    }
}

/// Wear rates in the cells of the contact.
impl Record for WearCells {
    fn rows(&self) -> usize {
        self.x.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { WearCells:
            X => |cells, k| cells.x[k],
            Y => |cells, k| cells.y[k],
            Pressure => |cells, k| cells.pressure[k],
            LocalSlipSpeed "slip_speed" => |cells, k| cells.slip_speed[k],
            WearRateArchard "archard" => |cells, k| cells.archard[k],
            WearRateEnergy "energy" => |cells, k| cells.energy[k],
        }
    }
}

/// Depth of wear of a passage across the profile.
impl Record for PassageProfile {
    fn rows(&self) -> usize {
        self.y.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { PassageProfile:
            Y => |profile, k| profile.y[k],
            WearDepth "archard" => |profile, k| profile.archard[k],
            WearDepth "wheel_energy" => |profile, k| profile.wheel_energy[k],
            WearDepth "rail_energy" => |profile, k| profile.rail_energy[k],
        }
    }
}

/// States of a run with the damage that they do.
impl Record for [RunPoint] {
    fn rows(&self) -> usize {
        self.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { [RunPoint]:
            Distance => |points, k| points[k].distance,
            Y "position_y" => |points, k| points[k].position_y,
            WearNumber => |points, k| points[k].t_gamma,
            FatigueIndex => |points, k| points[k].fatigue_index,
            CrackDamage => |points, k| points[k].crack_damage,
            DissipatedEnergy "energy" => |points, k| points[k].energy,
            WearVolume "archard_wear" => |points, k| points[k].archard_wear,
            WearMass "energy_wear" => |points, k| points[k].energy_wear,
        }
    }
}

/// Stresses at points below the surface.
impl Record for [PointStress] {
    fn rows(&self) -> usize {
        self.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { [PointStress]:
            X => |points, k| points[k].x,
            Y => |points, k| points[k].y,
            Depth => |points, k| points[k].depth,
            StressXx => |points, k| points[k].stress.xx,
            StressYy => |points, k| points[k].stress.yy,
            StressZz => |points, k| points[k].stress.zz,
            StressXy => |points, k| points[k].stress.xy,
            StressXz => |points, k| points[k].stress.xz,
            StressYz => |points, k| points[k].stress.yz,
            VonMisesStress => |points, k| points[k].stress.von_mises(),
            LargestShearStress => |points, k| points[k].stress.largest_shear(),
            LargestPrincipalStress => |points, k| points[k].stress.principal()[0],
            HydrostaticStress => |points, k| points[k].stress.hydrostatic(),
        }
    }
}

/// Loads on a rough surface.
impl Record for LoadCurve {
    fn rows(&self) -> usize {
        self.points().len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { LoadCurve:
            MeanPressure => |curve, k| curve.points()[k].mean_pressure,
            Approach => |curve, k| curve.points()[k].approach,
            MeanGap => |curve, k| curve.points()[k].mean_gap,
            ContactFraction => |curve, k| curve.points()[k].contact_fraction,
            CorrectedContactFraction => |curve, k| curve.points()[k].corrected_contact_fraction,
            SpotPressure => |curve, k| curve.points()[k].spot_pressure,
            PlasticFraction => |curve, k| curve.points()[k].plastic_fraction,
            Iterations => |curve, k| curve.points()[k].iterations,
        }
    }
}

/// Power spectral density of a surface.
impl Record for RadialSpectrum {
    fn rows(&self) -> usize {
        self.wave_numbers.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { RadialSpectrum:
            WaveNumber => |spectrum, k| spectrum.wave_numbers[k],
            SpectralDensity => |spectrum, k| spectrum.densities[k],
        }
    }
}

/// Displacements of a rough surface at one mean pressure.
impl Record for TangentialCurve {
    fn rows(&self) -> usize {
        self.points.len()
    }

    fn columns() -> &'static [Column<Self>] {
        columns! { TangentialCurve:
            SurfaceDisplacement "displacement" => |curve, k| curve.points[k].displacement,
            SurfaceTraction "traction" => |curve, k| curve.points[k].traction,
            NormalisedTraction => |curve, k| curve.points[k].normalised_traction,
            NormalisedDisplacement => |curve, k| curve.points[k].normalised_displacement,
            TangentialStiffness "stiffness" => |curve, k| curve.points[k].stiffness,
            MicroSlip => |curve, k| curve.points[k].micro_slip,
            SlidingFraction => |curve, k| curve.points[k].sliding_fraction,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<R: Record + ?Sized>() {
        let mut names: Vec<&str> = R::columns().iter().map(|column| column.name).collect();
        names.sort_unstable();
        let count = names.len();
        names.dedup();
        assert_eq!(names.len(), count, "{names:?}");
    }

    #[test]
    fn no_record_has_two_columns_of_one_name() {
        check::<Fields>();
        check::<[Instant]>();
        check::<Power>();
        check::<Temperature>();
        check::<CreepCurve>();
        check::<Profile>();
        check::<[RunPoint]>();
        check::<[PointStress]>();
        check::<LoadCurve>();
        check::<TangentialCurve>();
    }
}
