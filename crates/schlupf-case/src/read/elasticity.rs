//! `[elasticity]`.

use std::sync::Arc;

use schlupf::analysis::calibration::KalkerBed;
use schlupf::bodies::Material;
use schlupf::elasticity::elastic_layer::{ElasticLayer, LayerStiffness, Springs};
use schlupf::elasticity::{
    CalibratedLayer, Elasticity, HalfSpace, Rigid, StandardLinearSolid, UnlikeBodies,
    ViscoelasticHalfSpace, Winkler,
};

use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::choice::{ElasticityModel, NormalModel, UnlikeBodiesModel};
use crate::settings::Settings;

const BEDDINGS: [FieldPath; 2] = fields!["elasticity.bedding_x", "elasticity.bedding_y"];

/// Couplings of the displacements along x and along y: along rolling, and across.
const COUPLINGS: [[FieldPath; 2]; 2] = [
    fields!["elasticity.coupling_x", "elasticity.coupling_x_across"],
    fields!["elasticity.coupling_y", "elasticity.coupling_y_across"],
];

const SPRINGS: [FieldPath; 4] = fields![
    "elasticity.spring_x",
    "elasticity.spring_y",
    "elasticity.spring_coupling_x",
    "elasticity.spring_coupling_y",
];

/// How the bodies deform.
pub fn elasticity(
    settings: &Settings,
    bodies: [&Material; 2],
) -> Result<Arc<dyn Elasticity>, CaseError> {
    Ok(match settings.chosen(field!("elasticity.model"))? {
        ElasticityModel::Rigid => Arc::new(Rigid),
        ElasticityModel::HalfSpace => {
            let unlike_bodies = match settings.chosen(field!("elasticity.unlike_bodies"))? {
                UnlikeBodiesModel::Coupled => UnlikeBodies::Coupled,
                UnlikeBodiesModel::OneWay => UnlikeBodies::OneWay,
                UnlikeBodiesModel::Neglected => UnlikeBodies::Neglected,
            };
            Arc::new(half_space(settings, bodies)?.with_unlike_bodies(unlike_bodies))
        }
        ElasticityModel::Viscoelastic => Arc::new(viscoelastic(settings, bodies)?),
        ElasticityModel::Winkler if settings.any_given(&BEDDINGS) => Arc::new(winkler(settings)?),
        ElasticityModel::Winkler => Arc::new(KalkerBed { bodies: half_space(settings, bodies)? }),
        ElasticityModel::ElasticLayer => layer(settings, bodies)?,
    })
}

fn layer(settings: &Settings, bodies: [&Material; 2]) -> Result<Arc<dyn Elasticity>, CaseError> {
    let margin = settings.optional_number(field!("elasticity.margin"))?;
    if settings.any_given(&SPRINGS) {
        return Ok(Arc::new(discrete(settings, margin)?));
    }
    if settings.any_given(&BEDDINGS) || settings.any_given(COUPLINGS.as_flattened()) {
        return Ok(Arc::new(per_area(settings, margin)?));
    }
    let layer = CalibratedLayer::new(bodies[0], bodies[1], margin);
    Ok(Arc::new(layer.map_err(|error| settings.explain(&error))?))
}

fn half_space(settings: &Settings, bodies: [&Material; 2]) -> Result<HalfSpace, CaseError> {
    HalfSpace::new(bodies[0], bodies[1]).map_err(|error| settings.explain(&error))
}

fn viscoelastic(
    settings: &Settings,
    bodies: [&Material; 2],
) -> Result<ViscoelasticHalfSpace, CaseError> {
    let model = field!("elasticity.model");
    if settings.chosen::<NormalModel>(field!("normal.model"))? == NormalModel::WheelRail {
        let message = format!(
            "{model} must not be viscoelastic with normal.model = \"wheel-rail\", whose pressure is \
             that of elastic bodies"
        );
        return Err(settings.error(model, message));
    }
    let approach = field!("normal.approach");
    if settings.is_given(approach) {
        let message =
            format!("{approach} must not be given for viscoelastic bodies: give normal.load");
        return Err(settings.error(approach, message));
    }
    let solid = |modulus, time| -> Result<StandardLinearSolid, CaseError> {
        let relaxed_modulus = settings.number(modulus)?;
        Ok(StandardLinearSolid { relaxed_modulus, retardation_time: settings.number(time)? })
    };
    let solids = [
        solid(field!("wheel.relaxed_modulus"), field!("wheel.retardation_time"))?,
        solid(field!("rail.relaxed_modulus"), field!("rail.retardation_time"))?,
    ];
    ViscoelasticHalfSpace::new(bodies, solids).map_err(|error| settings.explain(&error))
}

/// A bed with the stiffnesses that are given.
fn winkler(settings: &Settings) -> Result<Winkler, CaseError> {
    let [x, y] = [settings.number(BEDDINGS[0])?, settings.number(BEDDINGS[1])?];
    Winkler::new(x, y).map_err(|error| settings.explain(&error))
}

fn per_area(settings: &Settings, margin: Option<f64>) -> Result<ElasticLayer, CaseError> {
    let stiffness = |component: usize| -> Result<LayerStiffness, CaseError> {
        let [along, across] = COUPLINGS[component];
        Ok(LayerStiffness {
            bedding: settings.number(BEDDINGS[component])?,
            coupling_along_x: settings.number(along)?,
            coupling_along_y: settings.number(across)?,
        })
    };
    let (x, y) = (stiffness(0)?, stiffness(1)?);
    ElasticLayer::new(x, y, margin).map_err(|error| settings.explain(&error))
}

fn discrete(settings: &Settings, margin: Option<f64>) -> Result<ElasticLayer, CaseError> {
    let springs = |bedding: FieldPath, coupling: FieldPath| -> Result<Springs, CaseError> {
        Ok(Springs { bedding: settings.number(bedding)?, coupling: settings.number(coupling)? })
    };
    let x = springs(SPRINGS[0], SPRINGS[2])?;
    let y = springs(SPRINGS[1], SPRINGS[3])?;
    ElasticLayer::from_springs(x, y, margin).map_err(|error| settings.explain(&error))
}
