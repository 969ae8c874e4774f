//! Friction from a creep curve: the one that CONTACT computes for a locomotive with μ = 0.33 (1 −
//! T/2084 K); its temperatures are some 11 % too high on the grid in use (Vollebregt 2022).

use schlupf::analysis::identification::roughness::DEFAULT_GAMMA;
use schlupf::analysis::identification::{
    Component, Condition, DataPoint, Parameter, RollingContactModel, fit,
};
use schlupf::bodies::{Body, Kinematics};
use schlupf::interface::Incremental;
use schlupf::interface::friction::constants::FrictionConstant;
use schlupf::normal::Ellipse;
use schlupf::{Error, Options, Problem, unwatched};

/// In N.
const LOAD: f64 = 106.7e3;

/// Creepages, and forces in N.
const CURVE: [[f64; 2]; 9] = [
    [0.0004, 9143.0],
    [0.0012, 22860.0],
    [0.002, 31010.0],
    [0.0028, 34590.0],
    [0.004, 35080.0],
    [0.02, 34640.0],
    [0.05, 33800.0],
    [0.1, 32480.0],
    [0.15, 31260.0],
];

fn main() -> Result<(), Error> {
    let cold = Body { bulk_temperature: 0.0, ..Body::STEEL };
    let problem = Problem::builder()
        .speed(10.0)
        .wheel(cold)
        .rail(cold)
        .normal(Ellipse::from_load(6.304e-3, 12.61e-3, LOAD)?)
        .contact_law(Incremental::new(1e8)?)
        .build()?;
    let data = CURVE.map(|[creepage_x, force]| {
        let kinematics = Kinematics { creepage_x, ..problem.kinematics };
        let condition = Condition { kinematics, load: None };
        let (component, force_ratio) = (Component::Longitudinal, force / LOAD);
        DataPoint { condition, component, force_ratio, standard_deviation: None }
    });
    let parameters =
        [FrictionConstant::ColdCoefficient, FrictionConstant::TemperatureAtZeroFriction]
            .map(Parameter::Friction);
    let options = Options { cells_x: 16, cells_y: 16, ..Options::default() };
    let mut model = RollingContactModel::new(&problem, &options, &parameters, DEFAULT_GAMMA)?;
    let found = fit(&mut model, &data, 50, &unwatched)?;
    println!("{} after {} iterations", found.status.name(), found.iterations);
    for estimate in &found.estimates {
        let symbol = estimate.parameter.quantity().symbol();
        let half_width = estimate.half_width.unwrap_or(f64::INFINITY);
        println!("{symbol} = {:.4} ± {half_width:.4}", estimate.value);
    }
    Ok(())
}
