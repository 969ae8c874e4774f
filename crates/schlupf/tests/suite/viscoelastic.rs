//! Two viscoelastic cylinders in steady rolling.
//!
//! Goal: pressure, approach and creepage under a given force, for retardation times from zero to
//! very long. Set-up and source: E. A. H. Vollebregt, *User guide for CONTACT*, 2025, §5.4, after
//! G. Wang and K. Knothe, J. Appl. Mech. 60 (1993), 310: R = 100 mm, PA6 with E = 3200 MPa, E∞ =
//! 1600 MPa, ν = 0.4; 600 N/mm, μ = 0.3, Fx = −0.6 μN, 1 m/s, 99 elements of 0.16 mm. Centre of
//! pressure and creepage are those of such elements by active sets in NumPy. On 0.16 mm that has
//! CONTACT's pressures and creepages (1.378, 1.365, 1.152, 0.9932 %); creepages here are those on
//! 0.04 mm, the first one Carter's.

use std::sync::Arc;

use approx::assert_relative_eq;
use schlupf::bodies::{Material, contact_modulus};
use schlupf::elasticity::{
    Elasticity, HalfSpace, Rigid, StandardLinearSolid, ViscoelasticHalfSpace,
};
use schlupf::element::{Element, Settings};
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::{Heat, Partition};
use schlupf::normal::{Ellipse, Hertz, Line, PressureSource, Radii};
use schlupf::problem::{Driver, FastMethod, LongitudinalForce, PrescribedForces, Transient};
use schlupf::solver::march;
use schlupf::{Error, Method, Options, Problem, Solution, unwatched};

const SHEAR_MODULUS: f64 = 1143e6;

fn polymer(shear_modulus: f64) -> Material {
    Material { young_modulus: 2.8 * shear_modulus, poisson_ratio: 0.4, ..Material::STEEL }
}

fn bodies(retardation_time: f64) -> ViscoelasticHalfSpace {
    let material = polymer(SHEAR_MODULUS);
    let relaxed_modulus = 0.5 * material.young_modulus;
    let solid = StandardLinearSolid { relaxed_modulus, retardation_time };
    ViscoelasticHalfSpace::new([&material; 2], [solid; 2]).unwrap()
}

fn problem(
    elasticity: impl Elasticity + 'static,
    normal: impl PressureSource + 'static,
    force: Option<f64>,
) -> Problem {
    let x = force.map(LongitudinalForce::Force);
    Problem::builder()
        .normal(normal)
        .elasticity(elasticity)
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(0.3).unwrap())
        .heat(Heat { model: None, partition: Partition::Given(0.5) })
        .speed(1.0)
        .creepage_x(0.01)
        .prescribed(PrescribedForces { x, ..PrescribedForces::default() })
        .build()
        .unwrap()
}

fn line(shear_modulus: f64) -> Line {
    let material = polymer(shear_modulus);
    Line::new([0.1, 0.1], 1.0, contact_modulus(&material, &material), 600e3).unwrap()
}

fn solved(problem: &Problem, [cells_x, cells_y]: [usize; 2]) -> Solution {
    let options = Options { cells_x, cells_y, ..Options::default() };
    Method::Full.solver(&options).solve(problem, &unwatched).unwrap()
}

#[test]
fn vollebregt_2025_wang_knothe_1993_two_cylinders() {
    let cases = [
        (0.0, 60.32e6, 2.50845e-3, 1.397e-2, 0.0),
        (0.009, 78.74e6, 2.36736e-3, 1.378e-2, 1.222e-3),
        (0.045, 84.72e6, 2.06321e-3, 1.171e-2, 0.595e-3),
        (2.0, 85.31e6, 1.45462e-3, 9.95e-3, 0.028e-3),
    ];
    for (time, pressure, approach, creepage, centre) in cases {
        let found = solved(&problem(bodies(time), line(SHEAR_MODULUS), Some(-108e3)), [80, 1]);
        assert_relative_eq!(found.normal.peak_pressure, pressure, max_relative = 1e-3);
        let approached = found.normal.approach.unwrap();
        assert_relative_eq!(approached, approach, max_relative = 1e-3);
        assert_relative_eq!(found.force.x, -108e3, max_relative = 1e-5);
        let braking = found.kinematics.creepage_x;
        assert_relative_eq!(braking, creepage, max_relative = 4e-3);
        let cells = &found.fields;
        let moment: f64 = (0..cells.x.len()).map(|k| cells.x[k] * cells.pressure[k]).sum();
        let sum: f64 = cells.pressure.iter().sum();
        assert_relative_eq!(moment / sum, centre, epsilon = 0.02e-3);
    }
}

/// Bodies that creep at once, or not while they pass, are elastic with one of their moduli.
#[test]
fn fast_and_slow_creep_is_elastic() {
    let crossed = |modulus| {
        let material = polymer(modulus);
        let modulus = contact_modulus(&material, &material);
        Hertz::new(Radii::along(0.1), Radii::across(0.05), modulus, 2e3).unwrap()
    };
    for (time, modulus) in [(0.0, 0.5 * SHEAR_MODULUS), (1e7, SHEAR_MODULUS)] {
        let material = polymer(modulus);
        let elastic = HalfSpace::new(&material, &material).unwrap();
        let expected = solved(&problem(elastic, crossed(modulus), None), [20, 20]);
        let found = solved(&problem(bodies(time), crossed(SHEAR_MODULUS), None), [20, 20]);
        let [found_at, expected_at] = [&found, &expected].map(|solution| solution.normal);
        assert_relative_eq!(found_at.peak_pressure, expected_at.peak_pressure, max_relative = 3e-3);
        assert_relative_eq!(found.force.x, expected.force.x, max_relative = 3e-3);
    }
}

/// Points of a curve share the pressure, which is that of load and speed.
#[test]
fn one_pressure_of_a_creep_curve() {
    let options = Options { cells_x: 12, cells_y: 1, ..Options::default() };
    let mut solver = Method::Full.solver(&options);
    let mut at = problem(bodies(0.01), line(SHEAR_MODULUS), None);
    let first = solver.rolling(&at, &unwatched).unwrap().unwrap();
    at.kinematics.creepage_x = 0.02;
    let next = solver.rolling(&at, &unwatched).unwrap().unwrap();
    assert!(Arc::ptr_eq(&first.normal, &next.normal) && next.kinematics.creepage_x == 0.02);
    at.kinematics.speed = 2.0;
    let faster = solver.rolling(&at, &unwatched).unwrap().unwrap();
    assert!(!Arc::ptr_eq(&first.normal, &faster.normal));
}

/// A pressure that is given stays, and steady rolling by time steps is the same; other histories
/// are refused, as are the force element and the fast methods.
#[test]
fn only_steady_rolling() {
    let ellipse = Ellipse::from_load(6e-3, 5e-3, 2e3).unwrap();
    let given = problem(bodies(0.01), ellipse, None);
    let steady = solved(&given, [12, 12]);
    assert_relative_eq!(steady.normal.semi_axis_x, 6e-3);
    let options = Options { cells_x: 12, cells_y: 12, ..Options::default() };
    let mut marching = Method::Full.solver_by(Driver::Marching, &options);
    let marched = marching.solve(&given, &unwatched).unwrap();
    assert_relative_eq!(marched.force.x, steady.force.x, max_relative = 2e-3);
    let by = (&Method::Full, &options);
    let refused = Element::new(&given, by, Settings::default()).map(|_| ());
    assert!(matches!(refused, Err(Error::ViscoelasticUnsteady {})));
    let mut fast = Method::Fast(FastMethod::KalkerLinear).solver(&options);
    let mut elastic = given.clone();
    elastic.interface.elasticity = Arc::new(Rigid);
    fast.solve(&elastic, &unwatched).unwrap();
    let refused = fast.solve(&given, &unwatched);
    assert!(matches!(refused, Err(Error::ViscoelasticFastMethod {})));
    let refused = march(&Transient::to_steady_state(&given), &options, &unwatched);
    assert!(matches!(refused, Err(Error::ViscoelasticUnsteady {})));
}
