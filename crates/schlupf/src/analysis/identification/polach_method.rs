//! Creep forces of Polach's method, as a model for fits.

use crate::problem::{AreaReduction, FastMethod, Problem};
use crate::reporting::{Error, FitError, Progress, Stage, Watch, tell};
use crate::solution::Work;
use crate::solver::reference_point;
use crate::solver::simplified::polach::{Differentiated, differentiated_force};
use crate::solver::simplified::{EllipticContact, friction_state};

use super::adjustment::{
    adjusted_friction, friction_constant, loaded, require_creepages, require_heat,
};
use super::data::Condition;
use super::model::{CreepForceModel, ForceRatio};
use super::parameter::Parameter;

/// Polach's method (1999, 2005) with unknown reductions k_A, k_S and friction constants, where
/// friction depends on the slip speed of the contact as a whole.
#[derive(Debug)]
pub struct PolachModel {
    problem: Problem,
    reduction: AreaReduction,
    parameters: Vec<Parameter>,
    start: Vec<f64>,
    /// The contacts by load (in N).
    contacts: Vec<(Option<f64>, EllipticContact)>,
}

impl PolachModel {
    /// A model of a problem whose parameters start at their present values.
    ///
    /// # Errors
    /// A parameter that neither the method nor the friction law has, invalid reductions, and
    /// whatever [`Problem::check`] rejects.
    pub fn new(
        problem: &Problem,
        reduction: AreaReduction,
        parameters: &[Parameter],
    ) -> Result<Self, Error> {
        problem.check()?;
        require_creepages(problem)?;
        FastMethod::Polach(reduction).check()?;
        require_heat(false, parameters, Some("polach"))?;
        let start = parameters.iter().map(|parameter| match parameter {
            Parameter::Friction(constant) => {
                friction_constant(&problem.interface.friction, *constant)
            }
            Parameter::AreaAdhesion => Ok(reduction.area_adhesion),
            Parameter::AreaSlip => Ok(reduction.area_slip),
            Parameter::ContactStiffness
            | Parameter::Roughness
            | Parameter::LayerShearModulus
            | Parameter::LayerYieldStress
            | Parameter::LayerHardening => {
                let quantity = parameter.quantity();
                Err(FitError::NotOfMethod { quantity, method: "polach" }.into())
            }
        });
        Ok(Self {
            start: start.collect::<Result<_, _>>()?,
            problem: problem.clone(),
            reduction,
            parameters: parameters.to_vec(),
            contacts: Vec::new(),
        })
    }

    /// k_A and k_S at the present values.
    pub fn reduction(&self) -> AreaReduction {
        self.reduction
    }

    fn contact(&mut self, load: Option<f64>) -> Result<EllipticContact, Error> {
        if let Some((_, contact)) = self.contacts.iter().find(|(other, _)| *other == load) {
            return Ok(*contact);
        }
        let normal = loaded(&self.problem, load)?;
        let contact = EllipticContact::new(&Problem { normal, ..self.problem.clone() })?;
        self.contacts.push((load, contact));
        Ok(contact)
    }
}

impl CreepForceModel for PolachModel {
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn start(&self) -> Vec<f64> {
        self.start.clone()
    }

    fn set(&mut self, values: &[f64]) -> Result<(), Error> {
        for (parameter, value) in self.parameters.iter().zip(values) {
            match parameter {
                Parameter::AreaAdhesion => self.reduction.area_adhesion = *value,
                Parameter::AreaSlip => self.reduction.area_slip = *value,
                _ => {}
            }
        }
        self.problem.interface.friction =
            adjusted_friction(&self.problem.interface.friction, &self.parameters, values)?;
        self.problem.check()
    }

    fn force_ratio(
        &mut self,
        condition: &Condition,
        watch: Watch,
    ) -> Result<Option<ForceRatio>, Error> {
        tell(watch, Progress::count(Stage::Steady, 0))?;
        condition.kinematics.check()?;
        let contact = self.contact(condition.load)?;
        let place = reference_point::place(self.problem.reference, &contact.normal)?;
        let kinematics = condition.kinematics.at(place.map(|part| -part));
        self.problem.kinematics = kinematics;
        let (load, state) = (contact.normal.load, friction_state(&self.problem));
        let law = &self.problem.interface.friction.law;
        let limit = load * law.respond(&state).coefficient;
        let found = differentiated_force(&contact, &kinematics, limit, self.reduction);
        let Differentiated { force, by_limit, by_area_adhesion, by_area_slip } = found;
        let ratio = |force: [f64; 2]| force.map(|component| -component / load);
        let by_constant = |constant| {
            let by = law.adjustable().map_or(0.0, |law| law.by_constant(constant, &state));
            by_limit.map(|by_limit| -by_limit * by)
        };
        let by_parameter = self.parameters.iter().map(|parameter| match parameter {
            Parameter::Friction(constant) => by_constant(*constant),
            Parameter::AreaAdhesion => ratio(by_area_adhesion),
            Parameter::AreaSlip => ratio(by_area_slip),
            Parameter::ContactStiffness
            | Parameter::Roughness
            | Parameter::LayerShearModulus
            | Parameter::LayerYieldStress
            | Parameter::LayerHardening => [0.0; 2],
        });
        let by_parameter = by_parameter.collect();
        let value = ratio(force);
        let is_found = value.iter().all(|ratio| ratio.is_finite());
        Ok(is_found.then_some(ForceRatio { value, by_parameter }))
    }

    fn work(&self) -> Work {
        Work::default()
    }
}
