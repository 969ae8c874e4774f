//! What acts where wheel and rail meet: their elasticity, contact law, a layer between them,
//! friction and heat.

pub mod heat;
mod contact_law;
pub mod friction;
pub mod roughness;
mod third_body;

pub use contact_law::{ContactLaw, Incremental, TotalDisplacement};
pub(crate) use third_body::Flow;
pub use third_body::{ShearedPoint, ThirdBodyLayer, YieldLimit};

use std::sync::Arc;

use crate::bodies::{Body, Kinematics, Material, contact_modulus, shear_modulus_and_poisson_ratio};
use crate::elasticity::Elasticity;
use crate::normal::patch::Cell;
use crate::reporting::{Error, Warning};

use friction::{Friction, FrictionConstant, FrictionMemory, FrictionResponse, FrictionState};
use heat::{Conduction, Heat, Peclet};

/// A constant of the interface with respect to which forces can be differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InterfaceConstant {
    /// One of the friction law.
    Friction(FrictionConstant),
    /// k_c of the contact law, in 1/m.
    ContactStiffness,
    /// Shear modulus of the layer between the surfaces, in Pa.
    LayerShearModulus,
    /// Yield stress τ_c0 of that layer, in Pa.
    LayerYieldStress,
    /// Its hardening k_τ, in Pa/m.
    LayerHardening,
}

/// What acts where two bodies meet, whatever presses them together and however they move: their
/// elasticity, what is between their surfaces, friction and heat.
#[derive(Debug, Clone)]
pub struct Interface {
    /// The wheel.
    pub wheel: Body,
    /// The rail.
    pub rail: Body,
    /// Elastic deformation of the bodies under tangential traction.
    pub elasticity: Arc<dyn Elasticity>,
    /// The layer between the surfaces, if there is one.
    pub layer: Option<ThirdBodyLayer>,
    /// Dependence of the traction of a point on its sliding, Eq. (8).
    pub contact_law: ContactLaw,
    /// Coefficient of friction, Eq. (23).
    pub friction: Friction,
    /// Frictional heating, Eqs. (17)–(22).
    pub heat: Heat,
}

impl Interface {
    /// Compliance h/G of the layer between the surfaces (in m/Pa); zero if there is none.
    pub fn layer_compliance(&self) -> f64 {
        self.layer.map_or(0.0, |layer| layer.compliance())
    }

    /// What bounds the traction over the pressure in a cell (dimensionless) with a coefficient of
    /// friction and a layer that has not flowed yet.
    pub(crate) fn at_entry(&self, friction: f64, cell: &Cell) -> f64 {
        let pressure = cell.pressure_where_covered();
        self.layer.map_or(friction, |layer| {
            layer.pass(friction * pressure, 0.0, [0.0; 2]).bound / pressure
        })
    }

    /// Whether nothing that changes within the contact changes what bounds the traction.
    pub(crate) fn has_constant_bound(&self) -> bool {
        self.friction.law.is_constant() && !self.layer.is_some_and(|layer| layer.hardens())
    }

    /// A warning of a largest pressure (in Pa) that no body can bear.
    pub fn beyond_elastic(&self, pressure: f64) -> Option<Warning> {
        beyond_elastic([&self.wheel.material, &self.rail.material], pressure)
    }

    /// Heat partition and conduction of the two bodies at the speeds of `kinematics`.
    pub fn conduction(&self, kinematics: &Kinematics) -> Conduction {
        Conduction::new(&self.heat.partition, &self.wheel, &self.rail, kinematics)
    }

    /// Péclet numbers of the two bodies passing, at the speeds of `kinematics`, through a contact
    /// of semi-axes a and b (in m).
    pub fn peclet(&self, kinematics: &Kinematics, semi_axes: [f64; 2]) -> Peclet {
        let times = self.conduction(kinematics).contact_times();
        let diffusivities = [&self.wheel, &self.rail].map(|body| body.material.diffusivity());
        Peclet::new(semi_axes, times.map(|time| kinematics.speed / time), diffusivities)
    }

    /// Friction in a cell at y (in m) with a temperature rise times effusivity (in W √s/m²) and a
    /// slip speed (in m/s), Eq. (23).
    pub fn friction_response(
        &self,
        conduction: &Conduction,
        rise_times_effusivity: f64,
        slip_speed: f64,
        y: f64,
    ) -> FrictionResponse {
        let state = self.friction_state(conduction, rise_times_effusivity, slip_speed, y);
        self.friction.law.respond(&state)
    }

    /// The arguments of the friction law there.
    pub fn friction_state(
        &self,
        conduction: &Conduction,
        rise_times_effusivity: f64,
        slip_speed: f64,
        y: f64,
    ) -> FrictionState {
        let temperature = conduction.contact_temperature(rise_times_effusivity)
            - self.friction.reference_temperature;
        FrictionState { temperature, slip_speed, y }
    }

    /// Friction of material at y (in m) when it enters the contact.
    pub fn entry_friction(&self, conduction: &Conduction, y: f64) -> FrictionResponse {
        self.friction_response(conduction, 0.0, 0.0, y)
    }

    /// How friction lags behind its law, if it depends on anything that changes within the contact.
    pub fn friction_memory(&self) -> Option<FrictionMemory> {
        self.friction.memory.filter(|_| !self.friction.law.is_constant())
    }

    /// Contact modulus E* of both bodies, in Pa.
    pub fn contact_modulus(&self) -> f64 {
        contact_modulus(&self.wheel.material, &self.rail.material)
    }

    /// Combined Poisson's ratio of both bodies, dimensionless.
    pub(crate) fn poisson_ratio(&self) -> f64 {
        let [_, ratio] = shear_modulus_and_poisson_ratio(&self.wheel.material, &self.rail.material);
        ratio
    }

    /// Performs all checks possible before the patch is known, at a speed.
    pub fn check(&self, kinematics: &Kinematics) -> Result<(), Error> {
        self.wheel.check_wheel()?;
        self.rail.check_rail()?;
        self.heat.check()?;
        self.friction.check(self.conduction(kinematics).entry_temperature)
    }
}

/// Ratio of the largest pressure to E* above which even steel is no longer elastic: its hardness is
/// lower.
const YIELDING: f64 = 0.03;

/// A warning of a largest pressure (in Pa) that no body of one of two materials can bear.
pub fn beyond_elastic([one, other]: [&Material; 2], pressure: f64) -> Option<Warning> {
    let modulus = contact_modulus(one, other);
    (pressure > YIELDING * modulus).then_some(Warning::BeyondElastic { pressure, modulus })
}
