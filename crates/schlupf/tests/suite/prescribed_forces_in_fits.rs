//! Fits of measured creep curves where some forces are prescribed in place of creepages: a wheel
//! that drifts sideways as it likes in spite of its spin.

use crate::common;
use std::sync::Arc;

use schlupf::analysis::identification::roughness::DEFAULT_GAMMA;
use schlupf::analysis::identification::{
    Component, Condition, CreepForceModel, DataPoint, Parameter, PolachModel, RollingContactModel,
    fit,
};
use schlupf::bodies::Kinematics;
use schlupf::interface::Incremental;
use schlupf::interface::friction::{Constant, Friction, FrictionConstant};
use schlupf::problem::{AreaReduction, Method, PrescribedForces};
use schlupf::{Options, Problem, Status, unwatched};

const BOTH: [Parameter; 2] =
    [Parameter::Friction(FrictionConstant::ColdCoefficient), Parameter::ContactStiffness];

/// Free sideways with a spin of 0.6/m, friction μ and stiffness k_c in 1/m.
fn drifting([coefficient, stiffness]: [f64; 2], creepage_x: f64) -> Problem {
    let kinematics = Kinematics { spin: 0.6, creepage_x, ..Kinematics::free_rolling(20.0) };
    Problem {
        prescribed: PrescribedForces { y: Some(0.0), ..PrescribedForces::default() },
        ..common::problem(kinematics)
    }
    .with_interface(|interface| {
        interface.contact_law = Incremental::new(stiffness).unwrap().into();
        interface.friction = Friction::new(Arc::new(Constant::new(coefficient).unwrap()), 20.0);
    })
}

fn options() -> Options {
    Options { cells_x: 14, cells_y: 14, ..Options::default() }
}

fn model(constants: [f64; 2]) -> RollingContactModel {
    let problem = drifting(constants, 0.0);
    RollingContactModel::new(&problem, &options(), &BOTH, DEFAULT_GAMMA).unwrap()
}

/// −F_x/N of the solver for prescribed forces.
fn ratio(constants: [f64; 2], creepage_x: f64) -> f64 {
    let problem = drifting(constants, creepage_x);
    let options = Options { tolerance: 1e-9, ..options() };
    let found = Method::Full.solver(&options).solve(&problem, &unwatched);
    let found = found.unwrap();
    assert!(found.kinematics.creepage_y.abs() > 1e-5, "it drifts");
    -found.force.x / found.normal.load
}

/// Derivatives by friction and stiffness with the lateral force held are those of central
/// differences, in each of which the drift is another one; the force held does not change.
#[test]
fn derivatives_hold_the_prescribed_force() {
    let constants = [0.35, 3e6];
    let mut model = model(constants);
    for creepage_x in [5e-4, 1.5e-3, 4e-3] {
        let condition =
            Condition { kinematics: drifting(constants, creepage_x).kinematics, load: None };
        let found = model.force_ratio(&condition, &unwatched).unwrap().unwrap();
        assert!((found.value[0] - ratio(constants, creepage_x)).abs() < 1e-5);
        assert!(found.value[1].abs() < 1e-5);
        for (k, by) in found.by_parameter.iter().enumerate() {
            let end = |change: f64| {
                let mut changed = constants;
                changed[k] *= 1.0 + change;
                ratio(changed, creepage_x)
            };
            let expected = (end(1e-3) - end(-1e-3)) / 2e-3;
            let [along, held] = by.map(|by| by * constants[k]);
            println!("{creepage_x} {k}: {along:.6} {expected:.6}, held {held:.1e}");
            assert!((along - expected).abs() < 2e-3 * expected.abs().max(0.02));
            assert!(held.abs() < 1e-4);
        }
    }
}

/// Constants come back from a curve of a wheel that drifts; a fit that took it for one that does
/// not would find others.
#[test]
fn constants_come_back_from_a_drifting_wheel() {
    let truth = [0.3, 2e6];
    let point = |creepage_x: &f64| DataPoint {
        condition: Condition { kinematics: drifting(truth, *creepage_x).kinematics, load: None },
        component: Component::Longitudinal,
        force_ratio: ratio(truth, *creepage_x),
        standard_deviation: None,
    };
    let data: Vec<_> = [3e-4, 6e-4, 1e-3, 1.5e-3, 2.5e-3, 5e-3, 0.01].iter().map(point).collect();
    let found = fit(&mut model([0.4, 5e6]), &data, 50, &unwatched).unwrap();
    assert_eq!(found.status, Status::Converged, "{:?}", found.warnings);
    for (estimate, truth) in found.estimates.iter().zip(truth) {
        assert!((estimate.value / truth - 1.0).abs() < 1e-3, "{estimate:?}");
    }
}

/// Data that vary the creepage of a force are refused, and Polach's method, which has creepages
/// only, refuses forces.
#[test]
fn what_cannot_be_fitted_is_refused() {
    let mut kinematics = drifting([0.3, 2e6], 1e-3).kinematics;
    kinematics.creepage_y = 1e-3;
    let condition = Condition { kinematics, load: None };
    let error = model([0.3, 2e6]).force_ratio(&condition, &unwatched).unwrap_err();
    assert_eq!(error.code(), "force-and-creepage");
    let problem = drifting([0.3, 2e6], 0.0);
    let error = PolachModel::new(&problem, AreaReduction::DRY, &BOTH[..1]).unwrap_err();
    assert_eq!(error.code(), "force-not-possible");
}
