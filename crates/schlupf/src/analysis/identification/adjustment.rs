//! Shared by the models: reading and changing constants of a problem, and changing the load.

use std::sync::Arc;

use crate::interface::ThirdBodyLayer;
use crate::interface::friction::{AdjustableFriction, Changes, Friction, FrictionConstant};
use crate::normal::{AtLoad, PressureSource};
use crate::problem::Problem;
use crate::reporting::{Error, FitError, ForceError};

use super::parameter::Parameter;

/// The value of a constant of a friction law, in its SI unit if it is not dimensionless.
pub(super) fn friction_constant(
    friction: &Friction,
    wanted: FrictionConstant,
) -> Result<f64, Error> {
    let law = friction.law.adjustable();
    let constants = law.map_or_else(Vec::new, AdjustableFriction::constants);
    if let Some((_, value)) = constants.iter().find(|(name, _)| *name == wanted) {
        return Ok(*value);
    }
    let constants = constants.iter().map(|(name, _)| name.quantity()).collect();
    Err(FitError::NoSuchConstant { quantity: wanted.quantity(), constants }.into())
}

/// Rejects prescribed forces: data have creepages.
pub(super) fn require_creepages(problem: &Problem) -> Result<(), Error> {
    let quantity = problem.prescribed.first();
    quantity.map_or(Ok(()), |quantity| Err(ForceError::NotPossible { quantity }.into()))
}

/// Rejects, for a model without heat, a constant that affects friction only in a hot contact.
pub(super) fn require_heat(
    has_heat: bool,
    parameters: &[Parameter],
    method: Option<&'static str>,
) -> Result<(), Error> {
    let needs_heat = |parameter: &&Parameter| {
        matches!(
            parameter,
            Parameter::Friction(
                FrictionConstant::TemperatureAtZeroFriction
                    | FrictionConstant::MinimumCoefficient
                    | FrictionConstant::HotCoefficient
                    | FrictionConstant::TemperatureRange
            )
        )
    };
    match parameters.iter().find(needs_heat).filter(|_| !has_heat) {
        Some(parameter) => {
            Err(FitError::NeedsHeat { quantity: parameter.quantity(), method }.into())
        }
        None => Ok(()),
    }
}

/// Friction with those parameters that are constants of its law set to new values (in their SI
/// units, or dimensionless).
pub(super) fn adjusted_friction(
    friction: &Friction,
    parameters: &[Parameter],
    values: &[f64],
) -> Result<Friction, Error> {
    let changes: Vec<(FrictionConstant, f64)> = parameters
        .iter()
        .zip(values)
        .filter_map(|(parameter, value)| match parameter {
            Parameter::Friction(constant) => Some((*constant, *value)),
            _ => None,
        })
        .collect();
    let mut friction = friction.clone();
    if let Some(law) = friction.law.adjustable() {
        friction.law = law.with_constants(&Changes(&changes))?;
    }
    Ok(friction)
}

/// The layer between the surfaces with those parameters that are constants of it set to new values,
/// in their SI units.
pub(super) fn adjusted_layer(
    layer: &ThirdBodyLayer,
    parameters: &[Parameter],
    values: &[f64],
) -> Result<ThirdBodyLayer, Error> {
    let (mut shear_modulus, mut limit) = (layer.shear_modulus(), layer.yield_limit());
    for (parameter, value) in parameters.iter().zip(values) {
        match (parameter, &mut limit) {
            (Parameter::LayerShearModulus, _) => shear_modulus = *value,
            (Parameter::LayerYieldStress, Some(limit)) => limit.stress = *value,
            (Parameter::LayerHardening, Some(limit)) => limit.hardening = *value,
            _ => {}
        }
    }
    let layer = ThirdBodyLayer::new(layer.thickness(), shear_modulus)?;
    limit.map_or(Ok(layer), |limit| layer.with_yield(limit))
}

/// The normal contact of a problem under a given load (in N), or under its own.
pub(super) fn loaded(
    problem: &Problem,
    load: Option<f64>,
) -> Result<Arc<dyn PressureSource>, Error> {
    let own = Arc::clone(&problem.normal);
    Ok(match load {
        Some(load) => Arc::new(AtLoad::new(own, load)?),
        None => own,
    })
}
