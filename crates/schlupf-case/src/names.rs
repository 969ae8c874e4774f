//! What a case calls the quantities of the core, and what a command calls the fields of a case.

use std::borrow::Cow;
use std::cell::RefCell;

use schlupf::Quantity;
use schlupf::message::Words;

/// The field that gives a quantity.
const FIELDS: &[(Quantity, &str)] = &[
    (Quantity::Speed, "kinematics.speed"),
    (Quantity::CreepageX, "kinematics.creepage_x"),
    (Quantity::CreepageY, "kinematics.creepage_y"),
    (Quantity::Spin, "kinematics.spin"),
    (Quantity::Reference, "kinematics.reference"),
    (Quantity::WheelYoungModulus, "wheel.young_modulus"),
    (Quantity::WheelPoissonRatio, "wheel.poisson_ratio"),
    (Quantity::WheelConductivity, "wheel.conductivity"),
    (Quantity::WheelDensity, "wheel.density"),
    (Quantity::WheelSpecificHeat, "wheel.specific_heat"),
    (Quantity::WheelBulkTemperature, "wheel.bulk_temperature"),
    (Quantity::WheelRadiusX, "wheel.radius_x"),
    (Quantity::WheelRadiusY, "wheel.radius_y"),
    (Quantity::RailYoungModulus, "rail.young_modulus"),
    (Quantity::RailPoissonRatio, "rail.poisson_ratio"),
    (Quantity::RailConductivity, "rail.conductivity"),
    (Quantity::RailDensity, "rail.density"),
    (Quantity::RailSpecificHeat, "rail.specific_heat"),
    (Quantity::RailBulkTemperature, "rail.bulk_temperature"),
    (Quantity::RailRadiusX, "rail.radius_x"),
    (Quantity::RailRadiusY, "rail.radius_y"),
    (Quantity::PoissonRatio, "wheel.poisson_ratio"),
    (Quantity::Load, "normal.load"),
    (Quantity::PeakPressure, "normal.peak_pressure"),
    (Quantity::SemiAxisX, "normal.semi_axis_x"),
    (Quantity::SemiAxisY, "normal.semi_axis_y"),
    (Quantity::PressureTable, "normal.file"),
    (Quantity::UndeformedDistance, "normal.file"),
    (Quantity::NormalCells, "normal.cells"),
    (Quantity::BeddingX, "elasticity.bedding_x"),
    (Quantity::BeddingY, "elasticity.bedding_y"),
    (Quantity::CouplingX, "elasticity.coupling_x"),
    (Quantity::CouplingXAcross, "elasticity.coupling_x_across"),
    (Quantity::CouplingY, "elasticity.coupling_y"),
    (Quantity::CouplingYAcross, "elasticity.coupling_y_across"),
    (Quantity::SpringX, "elasticity.spring_x"),
    (Quantity::SpringY, "elasticity.spring_y"),
    (Quantity::SpringCouplingX, "elasticity.spring_coupling_x"),
    (Quantity::SpringCouplingY, "elasticity.spring_coupling_y"),
    (Quantity::Margin, "elasticity.margin"),
    (Quantity::Elasticity, "elasticity.model"),
    (Quantity::Calibration, "elasticity.calibration"),
    (Quantity::ContactStiffness, "contact_law.stiffness"),
    (Quantity::ContactRoughness, "contact_law.roughness"),
    (Quantity::FrictionModel, "friction.model"),
    (Quantity::FrictionCoefficient, "friction.coefficient"),
    (Quantity::TemperatureAtZeroFriction, "friction.temperature_at_zero_friction"),
    (Quantity::MinimumCoefficient, "friction.minimum_coefficient"),
    (Quantity::HotCoefficient, "friction.hot_coefficient"),
    (Quantity::TemperatureRange, "friction.temperature_range"),
    (Quantity::KineticCoefficient, "friction.kinetic_coefficient"),
    (Quantity::HalfSpeed, "friction.half_speed"),
    (Quantity::SecondCoefficient, "friction.second_coefficient"),
    (Quantity::SecondHalfSpeed, "friction.second_half_speed"),
    (Quantity::LimitRatio, "friction.limit_ratio"),
    (Quantity::Decay, "friction.decay"),
    (Quantity::ReferenceTemperature, "friction.reference_temperature"),
    (Quantity::MemoryDistance, "friction.memory_distance"),
    (Quantity::MemorySpeed, "friction.memory_speed"),
    (Quantity::VariationY, "friction.variation_y"),
    (Quantity::VariationFactor, "friction.variation_factor"),
    (Quantity::HeatModel, "heat.model"),
    (Quantity::HeatPartition, "heat.partition"),
    (Quantity::Time, "history.time"),
    (Quantity::HistorySpeed, "history.speed"),
    (Quantity::HistoryCreepageX, "history.creepage_x"),
    (Quantity::HistoryCreepageY, "history.creepage_y"),
    (Quantity::HistorySpin, "history.spin"),
    (Quantity::HistoryLoad, "history.load"),
    (Quantity::ShiftX, "history.shift_x"),
    (Quantity::ShiftY, "history.shift_y"),
    (Quantity::CellsX, "grid.cells_x"),
    (Quantity::CellsY, "grid.cells_y"),
    (Quantity::Method, "solver.method"),
    (Quantity::Driver, "solver.driver"),
    (Quantity::Branch, "solver.branch"),
    (Quantity::Tolerance, "solver.tolerance"),
    (Quantity::MaxIterations, "solver.max_iterations"),
    (Quantity::MaxSteps, "solver.max_steps"),
    (Quantity::SlipThreshold, "solver.slip_threshold"),
    (Quantity::Sensitivities, "solver.sensitivity"),
    (Quantity::PolachAreaAdhesion, "solver.polach_area_adhesion"),
    (Quantity::PolachAreaSlip, "solver.polach_area_slip"),
    (Quantity::InitialReduction, "fastsim.initial_reduction"),
    (Quantity::ReductionLimitRatio, "fastsim.reduction_limit_ratio"),
    (Quantity::ReductionDecay, "fastsim.reduction_decay"),
    (Quantity::TractionBound, "fastsim.bound"),
    (Quantity::FilmCoefficient, "cooling.film_coefficient"),
    (Quantity::CooledArea, "cooling.area"),
    (Quantity::AirTemperature, "cooling.air_temperature"),
    (Quantity::Heights, "contact_law.roughness.file"),
    (Quantity::HeightUnit, "contact_law.roughness.unit"),
    (Quantity::SpacingX, "contact_law.roughness.spacing"),
    (Quantity::SpacingY, "contact_law.roughness.spacing"),
    (Quantity::Columns, "contact_law.roughness.cells"),
    (Quantity::Rows, "contact_law.roughness.cells"),
    (Quantity::RmsHeight, "contact_law.roughness.rms_height"),
    (Quantity::RmsSlope, "contact_law.roughness.rms_slope"),
    (Quantity::HurstExponent, "contact_law.roughness.hurst"),
    (Quantity::LongestWavelength, "contact_law.roughness.longest_wavelength"),
    (Quantity::RollOffWavelength, "contact_law.roughness.roll_off_wavelength"),
    (Quantity::ShortestWavelength, "contact_law.roughness.shortest_wavelength"),
    (Quantity::CutoffWavelength, "contact_law.roughness.cutoff_wavelength"),
    (Quantity::Form, "contact_law.roughness.form"),
    (Quantity::MeanPressure, "contact_law.roughness.pressures"),
    (Quantity::Hardness, "contact_law.roughness.hardness"),
    (Quantity::SlopeFactor, "contact_law.roughness.slope_factor"),
];

/// Dotted path of the field that gives a quantity, if one does.
pub fn path(quantity: Quantity) -> Option<&'static str> {
    FIELDS.iter().find(|(of, _)| *of == quantity).map(|(_, path)| *path)
}

/// The same, empty where there is none.
pub fn quantity_field(quantity: Quantity) -> &'static str {
    path(quantity).unwrap_or_default()
}

/// What fields are called where options of a command give them.
#[derive(Debug, Clone, Copy)]
pub struct FieldNames {
    options: &'static [(&'static str, &'static str)],
}

impl FieldNames {
    /// As the case file has them.
    pub const CASE: Self = Self { options: &[] };

    /// Some by options: pairs of a dotted path and the option.
    pub const fn of_options(options: &'static [(&'static str, &'static str)]) -> Self {
        Self { options }
    }

    /// The option that gives a field, if one does.
    pub fn option(self, path: &str) -> Option<&'static str> {
        self.options.iter().find(|(of, _)| *of == path).map(|(_, option)| *option)
    }

    /// What a field is called.
    pub fn name(self, path: &str) -> &str {
        self.option(path).unwrap_or(path)
    }

    /// How a flag is set: `fill_holes = true`, or by its option.
    pub fn switch(self, path: &str) -> String {
        let field = path.rsplit('.').next().unwrap_or(path);
        self.option(path).map_or_else(|| format!("{field} = true"), str::to_owned)
    }
}

impl Words for FieldNames {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        match (quantity, path(quantity)) {
            (Quantity::Heights, _) => "the surface".into(),
            (Quantity::InitialState, _) => "the initial state".into(),
            (_, Some(path)) => self.name(path).into(),
            (_, None) => quantity.name().into(),
        }
    }
}

/// Words that notes which quantities it was asked for.
pub struct Noting {
    names: FieldNames,
    asked: RefCell<Vec<Quantity>>,
}

impl Noting {
    /// Those of the names.
    pub fn new(names: FieldNames) -> Self {
        Self { names, asked: RefCell::default() }
    }

    /// The fields of all quantities that were asked for.
    pub fn fields(self) -> impl Iterator<Item = &'static str> {
        self.asked.into_inner().into_iter().filter_map(path)
    }
}

impl Words for Noting {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        self.asked.borrow_mut().push(quantity);
        self.names.word(quantity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields;

    #[test]
    fn every_quantity_has_one_field_that_exists() {
        for (k, (quantity, path)) in FIELDS.iter().enumerate() {
            let is_section = fields::section(path).is_some();
            assert!(is_section || fields::find(path).is_some(), "{path}");
            assert!(FIELDS[..k].iter().all(|(other, _)| other != quantity), "{quantity:?}");
        }
    }

    /// A number has the same unit in the core and in the case file.
    #[test]
    fn fields_have_the_unit_of_their_quantity() {
        for (quantity, path) in FIELDS {
            let Some(field) = fields::find(path) else { continue };
            let has_unit = matches!(field.kind, fields::Kind::Quantity(_));
            if has_unit && *quantity != Quantity::SlopeFactor {
                assert_eq!(field.kind.unit(), quantity.unit(), "{path}");
            }
        }
    }
}
