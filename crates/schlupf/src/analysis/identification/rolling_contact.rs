//! Creep forces of the steady solver, as a model for fits.

use std::sync::Arc;

use crate::interface::InterfaceConstant;
use crate::interface::friction::FrictionConstant;
use crate::normal::PressureSource;
use crate::numerics::parallel;
use crate::problem::{Options, Problem};
use crate::reporting::{Error, FitError, Watch};
use crate::solution::{Resultant, Work};

use super::adjustment::{
    adjusted_friction, adjusted_layer, friction_constant, loaded, require_heat,
};
use super::data::Condition;
use super::held_forces::HeldForces;
use super::model::{CreepForceModel, ForceRatio};
use super::parameter::Parameter;
use super::roughness;

/// Steady rolling contact with unknown constants of friction and contact law.
///
/// Points under one load share one solver, so each starts from the previous solutions; different
/// loads are solved on several threads. Forces that the problem prescribes are held while the
/// constants change: measured is then the force of the other direction, over its creepage.
pub struct RollingContactModel {
    problem: Problem,
    options: Options,
    parameters: Vec<Parameter>,
    start: Vec<f64>,
    /// The constants with respect to which the solver differentiates.
    constants: Vec<InterfaceConstant>,
    /// μ0 k_c h_rms, dimensionless.
    roughness_number: f64,
    /// μ0 (dimensionless) and k_c (in 1/m) at the present values.
    coefficient: f64,
    stiffness: f64,
    contacts: Vec<LoadedContact>,
    work: Work,
}

/// A solver for one load.
struct LoadedContact {
    load: Option<f64>,
    normal: Arc<dyn PressureSource>,
    /// The load, in N.
    value: f64,
    solver: HeldForces,
}

const COLD: Parameter = Parameter::Friction(FrictionConstant::ColdCoefficient);

impl RollingContactModel {
    /// A model of a problem whose parameters start at their present values. `gamma` (dimensionless)
    /// is the ratio of the approach of rough surfaces to their height, see [`roughness`]; it is
    /// used only for [`Parameter::Roughness`].
    ///
    /// # Errors
    /// A parameter that is not a constant of the laws in use, k_c together with the roughness that
    /// determines it, and whatever [`Problem::check`] and [`Options::check`] reject.
    pub fn new(
        problem: &Problem,
        options: &Options,
        parameters: &[Parameter],
        gamma: f64,
    ) -> Result<Self, Error> {
        problem.check()?;
        options.check()?;
        let has_heat = problem.interface.heat.model.is_some();
        require_heat(has_heat, parameters, None)?;
        let materials = [&problem.interface.wheel.material, &problem.interface.rail.material];
        let number = roughness::stiffness_number(materials[0], materials[1], gamma)?;
        let mut model = Self {
            problem: problem.clone(),
            options: Options { sensitivity: false, keeps_state: false, ..options.clone() },
            parameters: parameters.to_vec(),
            start: Vec::new(),
            constants: Vec::new(),
            roughness_number: number,
            coefficient: problem.interface.friction.cold_coefficient(),
            stiffness: problem.interface.contact_law.stiffness(),
            contacts: Vec::new(),
            work: Work::default(),
        };
        let starts = parameters.iter().map(|parameter| model.present(*parameter));
        model.start = starts.collect::<Result<_, _>>()?;
        let of_both = |parameter: &&Parameter| {
            matches!(parameter, Parameter::ContactStiffness | Parameter::Roughness)
        };
        if parameters.iter().filter(of_both).count() > 1 {
            return Err(FitError::StiffnessAndRoughness {}.into());
        }
        model.constants = parameters.iter().filter_map(|parameter| constant(*parameter)).collect();
        Ok(model)
    }

    /// The problem with the present values.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// k_c at the present values, in 1/m.
    pub fn contact_stiffness(&self) -> f64 {
        self.stiffness
    }

    /// The value of a parameter in the problem, in its SI unit.
    fn present(&self, parameter: Parameter) -> Result<f64, Error> {
        let quantity = parameter.quantity();
        match parameter {
            Parameter::Friction(constant) => {
                friction_constant(&self.problem.interface.friction, constant)
            }
            Parameter::AreaAdhesion | Parameter::AreaSlip => {
                Err(FitError::NotOfMethod { quantity, method: "full" }.into())
            }
            Parameter::LayerShearModulus => {
                let layer = self.problem.interface.layer.ok_or(FitError::NoLayer { quantity })?;
                Ok(layer.shear_modulus())
            }
            Parameter::LayerYieldStress | Parameter::LayerHardening => {
                let layer = self.problem.interface.layer.ok_or(FitError::NoLayer { quantity })?;
                let limit = layer.yield_limit().ok_or(FitError::NoYieldLimit { quantity })?;
                let is_stress = parameter == Parameter::LayerYieldStress;
                Ok(if is_stress { limit.stress } else { limit.hardening })
            }
            _ if self.problem.interface.contact_law.with_stiffness(self.stiffness)?.is_none() => {
                Err(FitError::NoStiffness {}.into())
            }
            Parameter::ContactStiffness => Ok(self.stiffness),
            Parameter::Roughness => Ok(self.roughness_number / (self.coefficient * self.stiffness)),
        }
    }

    /// The index of the solver for a load.
    fn contact(&mut self, load: Option<f64>, watch: Watch) -> Result<usize, Error> {
        if let Some(k) = self.contacts.iter().position(|contact| contact.load == load) {
            return Ok(k);
        }
        let normal = loaded(&self.problem, load)?;
        normal.prepare(None, watch)?;
        let value = normal.normal_contact(None)?.summary.load;
        let solver = HeldForces::new(&self.options);
        self.contacts.push(LoadedContact { load, normal, value, solver });
        Ok(self.contacts.len() - 1)
    }

    /// Forces under conditions of one load, up to the first that is not found.
    fn under_load(
        &self,
        contact: &mut LoadedContact,
        conditions: &[Condition],
        watch: Watch,
    ) -> Result<Vec<(ForceRatio, Work)>, Error> {
        let mut forces = Vec::with_capacity(conditions.len());
        for Condition { kinematics, .. } in conditions {
            self.problem.prescribed.check_motion(&self.problem.kinematics, kinematics)?;
            let (kinematics, normal) = (*kinematics, Arc::clone(&contact.normal));
            let problem = Problem { kinematics, normal, ..self.problem.clone() };
            let wanted = (&self.constants[..], watch);
            let found = contact.solver.solve(&problem, contact.value, wanted)?;
            let Some((solution, by)) = found else { break };
            let ratio = |force: [f64; 2]| force.map(|component| -component / contact.value);
            let derivatives = (0..by.len()).map(|k| ratio(self.by_parameter(k, &by)));
            let by_parameter = derivatives.collect();
            let value = ratio([solution.force.x, solution.force.y]);
            forces.push((ForceRatio { value, by_parameter }, solution.work));
        }
        Ok(forces)
    }

    /// Derivatives of the force (in N) with respect to a parameter, where `by` contains those with
    /// respect to the constants requested.
    fn by_parameter(&self, k: usize, by: &[Resultant]) -> [f64; 2] {
        let pair = |force: &Resultant| [force.x, force.y];
        let own = pair(&by[k]);
        let roughness = self.parameters.iter().position(|p| *p == Parameter::Roughness);
        match (self.parameters[k], roughness) {
            // k_c ∝ 1/(μ0 h_rms).
            (Parameter::Roughness, _) => {
                let height = self.roughness_number / (self.coefficient * self.stiffness);
                own.map(|by_stiffness| -by_stiffness * self.stiffness / height)
            }
            (COLD, Some(r)) => {
                let softer = self.stiffness / self.coefficient;
                let by_stiffness = pair(&by[r]);
                [own[0] - softer * by_stiffness[0], own[1] - softer * by_stiffness[1]]
            }
            _ => own,
        }
    }
}

/// The constant with respect to which the solver differentiates for a parameter.
fn constant(parameter: Parameter) -> Option<InterfaceConstant> {
    match parameter {
        Parameter::Friction(constant) => Some(InterfaceConstant::Friction(constant)),
        Parameter::ContactStiffness | Parameter::Roughness => {
            Some(InterfaceConstant::ContactStiffness)
        }
        Parameter::LayerShearModulus => Some(InterfaceConstant::LayerShearModulus),
        Parameter::LayerYieldStress => Some(InterfaceConstant::LayerYieldStress),
        Parameter::LayerHardening => Some(InterfaceConstant::LayerHardening),
        Parameter::AreaAdhesion | Parameter::AreaSlip => None,
    }
}

impl CreepForceModel for RollingContactModel {
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn start(&self) -> Vec<f64> {
        self.start.clone()
    }

    fn set(&mut self, values: &[f64]) -> Result<(), Error> {
        let (mut stiffness, mut height) = (self.stiffness, None);
        for (parameter, value) in self.parameters.iter().zip(values) {
            match parameter {
                Parameter::ContactStiffness => stiffness = *value,
                Parameter::Roughness => height = Some(*value),
                _ => {}
            }
        }
        let friction =
            adjusted_friction(&self.problem.interface.friction, &self.parameters, values)?;
        let layer =
            self.problem.interface.layer.map(|own| adjusted_layer(&own, &self.parameters, values));
        let layer = layer.transpose()?;
        let coefficient = friction.cold_coefficient();
        if let Some(height) = height {
            stiffness = self.roughness_number / (coefficient * height);
        }
        let mut problem = self.problem.clone().with_interface(|interface| {
            interface.layer = layer;
            interface.friction = friction;
        });
        if let Some(law) = self.problem.interface.contact_law.with_stiffness(stiffness)? {
            problem.interface.contact_law = law;
        }
        problem.check()?;
        self.problem = problem;
        (self.coefficient, self.stiffness) = (coefficient, stiffness);
        for contact in &mut self.contacts {
            contact.solver.forget();
        }
        Ok(())
    }

    fn force_ratio(
        &mut self,
        condition: &Condition,
        watch: Watch,
    ) -> Result<Option<ForceRatio>, Error> {
        let mut forces = self.force_ratios(std::slice::from_ref(condition), watch)?;
        Ok(forces.pop().flatten())
    }

    fn force_ratios(
        &mut self,
        conditions: &[Condition],
        watch: Watch,
    ) -> Result<Vec<Option<ForceRatio>>, Error> {
        let contact = conditions.iter().map(|condition| self.contact(condition.load, watch));
        let contact = contact.collect::<Result<Vec<usize>, Error>>()?;
        let of_contact = |k: usize| {
            let own = contact.iter().zip(conditions).filter(|(contact, _)| **contact == k);
            own.map(|(_, condition)| *condition).collect::<Vec<Condition>>()
        };
        let mut contacts = std::mem::take(&mut self.contacts);
        let each = contacts.iter_mut().enumerate().collect();
        let found = parallel::map(each, |(k, contact)| {
            self.under_load(contact, &of_contact(k), watch).map(Vec::into_iter)
        });
        self.contacts = contacts;
        let mut found = found.into_iter().collect::<Result<Vec<_>, Error>>()?;
        let forces = contact.iter().map(|k| {
            let (force, work) = found[*k].next()?;
            self.work.add(&work);
            Some(force)
        });
        Ok(forces.collect())
    }

    fn work(&self) -> Work {
        self.work
    }
}
