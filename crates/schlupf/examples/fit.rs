//! Friction from a creep curve: the one that CONTACT computes for a locomotive with μ = 0.33 (1 −
//! T/2084 K); its temperatures are some 11 % too high on the grid in use (Vollebregt 2022).

use schlupf::analysis::identification::roughness::DEFAULT_GAMMA;
use schlupf::analysis::identification::{
    Component, Condition, DataPoint, Parameter, RollingContactModel, fit,
};
use schlupf::bodies::{Body, Kinematics};
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::FrictionConstant;
use schlupf::normal::Ellipse;
use schlupf::{Error, Options, Problem, unwatched};

/// Creepages, and forces over the load of 106.7 kN.
const CREEPAGES: [f64; 6] = [0.0012, 0.002, 0.004, 0.02, 0.05, 0.15];
const RATIOS: [f64; 6] = [0.2142, 0.2906, 0.3288, 0.3247, 0.3168, 0.293];

fn main() -> Result<(), Error> {
    let cold = Body { bulk_temperature: 0.0, ..Body::STEEL };
    let ellipse = Ellipse::from_load(6.304e-3, 12.61e-3, 106.7e3)?;
    let builder = Problem::builder().speed(10.0).wheel(cold).rail(cold).normal(ellipse);
    let problem = builder.contact_law(ContactLaw::Coulomb).build()?;
    let data = [0, 1, 2, 3, 4, 5].map(|k| {
        let kinematics = Kinematics { creepage_x: CREEPAGES[k], ..problem.kinematics };
        let condition = Condition { kinematics, load: None };
        let (component, force_ratio) = (Component::Longitudinal, RATIOS[k]);
        DataPoint { condition, component, force_ratio, standard_deviation: None }
    });
    let parameters =
        [FrictionConstant::ColdCoefficient, FrictionConstant::TemperatureAtZeroFriction]
            .map(Parameter::Friction);
    let options = Options { cells_x: 16, cells_y: 16, ..Options::default() };
    let mut model = RollingContactModel::new(&problem, &options, &parameters, DEFAULT_GAMMA)?;
    for estimate in &fit(&mut model, &data, 50, &unwatched)?.estimates {
        let half_width = estimate.half_width.unwrap_or(f64::INFINITY);
        let symbol = estimate.parameter.quantity().symbol();
        println!("{symbol} = {:.4} ± {half_width:.4}", estimate.value);
    }
    Ok(())
}
