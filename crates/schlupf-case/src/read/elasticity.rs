//! `[elasticity]`.

use std::sync::Arc;

use schlupf::elasticity::Elasticity;
use schlupf::elasticity::calibrated_layer::CalibratedLayer;
use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness, Springs};
use schlupf::elasticity::half_space::HalfSpace;
use schlupf::elasticity::rigid::Rigid;
use schlupf::elasticity::winkler::Winkler;
use schlupf::material::Material;

use crate::error::CaseError;
use crate::settings::Settings;

const PER_AREA: [&str; 4] = [
    "elasticity.bedding_x",
    "elasticity.bedding_y",
    "elasticity.coupling_x",
    "elasticity.coupling_y",
];

const SPRINGS: [&str; 4] = [
    "elasticity.spring_x",
    "elasticity.spring_y",
    "elasticity.spring_coupling_x",
    "elasticity.spring_coupling_y",
];

/// How the bodies deform.
pub fn model(
    settings: &Settings,
    bodies: [&Material; 2],
) -> Result<Arc<dyn Elasticity>, CaseError> {
    match settings.choice("elasticity.model")? {
        "rigid" => Ok(Arc::new(Rigid)),
        "half-space" => {
            let half_space = HalfSpace::new(bodies[0], bodies[1]);
            Ok(Arc::new(half_space.map_err(|error| settings.explain(&error))?))
        }
        "winkler" => {
            let bedding_x = settings.number("elasticity.bedding_x")?;
            let bedding_y = settings.number("elasticity.bedding_y")?;
            let winkler = Winkler::new(bedding_x, bedding_y);
            Ok(Arc::new(winkler.map_err(|error| settings.explain(&error))?))
        }
        _ => {
            let margin = settings.optional_number("elasticity.margin")?;
            if settings.any_given(&SPRINGS) {
                Ok(Arc::new(discrete(settings, margin)?))
            } else if settings.any_given(&PER_AREA) {
                Ok(Arc::new(per_area(settings, margin)?))
            } else {
                let layer = CalibratedLayer::new(bodies[0], bodies[1], margin);
                Ok(Arc::new(layer.map_err(|error| settings.explain(&error))?))
            }
        }
    }
}

fn per_area(settings: &Settings, margin: Option<f64>) -> Result<ElasticLayer, CaseError> {
    let stiffness = |bedding: &str, coupling: &str| -> Result<LayerStiffness, CaseError> {
        let coupling = settings.number(coupling)?;
        Ok(LayerStiffness {
            bedding: settings.number(bedding)?,
            coupling_along_x: coupling,
            coupling_along_y: coupling,
        })
    };
    let x = stiffness("elasticity.bedding_x", "elasticity.coupling_x")?;
    let y = stiffness("elasticity.bedding_y", "elasticity.coupling_y")?;
    ElasticLayer::new(x, y, margin).map_err(|error| settings.explain(&error))
}

fn discrete(settings: &Settings, margin: Option<f64>) -> Result<ElasticLayer, CaseError> {
    let springs = |bedding: &str, coupling: &str| -> Result<Springs, CaseError> {
        Ok(Springs { bedding: settings.number(bedding)?, coupling: settings.number(coupling)? })
    };
    let x = springs(SPRINGS[0], SPRINGS[2])?;
    let y = springs(SPRINGS[1], SPRINGS[3])?;
    ElasticLayer::from_springs(x, y, margin).map_err(|error| settings.explain(&error))
}
