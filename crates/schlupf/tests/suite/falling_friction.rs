//! Solutions with friction that falls with the slip speed, with the temperature too, or varies
//! across the patch.

use std::sync::Arc;

use crate::common::{at_once, cells, half_space, problem, rolling, solve};
use approx::assert_relative_eq;
use schlupf::bodies::{Material, contact_modulus};
use schlupf::elasticity::Rigid;
use schlupf::interface::Incremental;
use schlupf::interface::friction::{
    Across, Constant, Exponential, FrictionLaw, Polach, Product, SecondTerm, SlipTerms,
    TemperaturePiecewiseLinear, Variation,
};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::{Hertz, Radii};
use schlupf::{Options, Problem};

type Law = Arc<dyn FrictionLaw>;

/// Falls with the temperature and the slip speed, and from the right to the left.
fn all_at_once(coefficient: f64) -> Law {
    let hot = TemperaturePiecewiseLinear::new(coefficient, 0.2, 600.0).unwrap();
    let polach = Polach::new(coefficient, 0.4, 0.6).unwrap();
    let product = Product::new(Arc::new(hot), Arc::new(polach)).unwrap();
    let across = Variation::over_y(vec![-5e-3, 7e-3], vec![1.25, 0.65]);
    Arc::new(Across::new(Arc::new(product), across.unwrap()))
}

fn warm(law: Law, creepage: f64) -> Problem {
    let mut warm = problem(rolling(creepage, 0.3 * creepage, 0.2));
    warm.interface.friction.law = law;
    warm.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    warm
}

/// Rigid bodies slide at v0 ξ everywhere, so μ is that of this speed, by hand: with half speeds of
/// 0.3 m/s and 0.6 m/s, 0.6 m/s leaves 1/4 and 1/2 of the terms.
#[test]
fn sliding_rigid_bodies_have_the_friction_of_their_slip_speed() {
    let second = Some(SecondTerm { coefficient: 0.08, half_speed: 0.6 });
    let mut sliding = problem(rolling(0.02, 0.0, 0.0));
    sliding.interface.elasticity = Arc::new(Rigid);
    sliding.interface.contact_law = Incremental::new(1e9).unwrap().into();
    sliding.interface.friction.law =
        Arc::new(Exponential(SlipTerms::new(0.4, 0.2, 0.3, second).unwrap()));
    let solution = at_once(&sliding, &cells(16));
    assert_relative_eq!(solution.traction_coefficient, 0.2 + 0.03 + 0.04, max_relative = 1e-9);
}

/// Hertz pressure has ∫ y² p dA = N b²/5, so a factor 1 + y/2b leaves the force μN and gives a
/// moment of μ N b/10.
#[test]
fn hertz_1882_moment_of_friction_that_varies_across() {
    let b = 5e-3;
    let mut sliding = problem(rolling(0.1, 0.0, 0.0));
    sliding.interface.elasticity = Arc::new(Rigid);
    let constant: Law = Arc::new(Constant::new(0.4).unwrap());
    let across = Across::new(constant, Variation::over_y(vec![-b, b], vec![0.5, 1.5]).unwrap());
    sliding.interface.friction.law = Arc::new(across);
    let solution = at_once(&sliding, &cells(40));
    let limit = 0.4 * solution.normal.load;
    assert_relative_eq!(solution.force.x, -limit, max_relative = 1e-3);
    assert_relative_eq!(solution.force.moment_z.unwrap(), limit * b / 10.0, max_relative = 1e-2);
}

/// Steady and marched solve the same discrete equations.
#[test]
fn the_steady_state_is_the_end_of_marching() {
    let exponential = Exponential(SlipTerms::new(0.4, 0.2, 0.5, None).unwrap());
    for law in [Arc::new(exponential) as Law, all_at_once(0.4)] {
        for creepage in [0.002, 0.02] {
            let warm = warm(Arc::clone(&law), creepage);
            let options = Options { tolerance: 1e-8, ..cells(16) };
            let (steady, marched) = (at_once(&warm, &options), solve(&warm, &options));
            assert!(steady.work.operator_products < 60.0, "{:?}", steady.work);
            assert_relative_eq!(steady.force.x, marched.force.x, max_relative = 1e-6);
            assert_relative_eq!(steady.force.y, marched.force.y, max_relative = 1e-6);
            assert_relative_eq!(
                steady.power.unwrap().friction,
                steady.power.unwrap().creep,
                max_relative = 1e-6
            );
        }
    }
}

/// Derivatives of the forces by the load, with which the patch grows over the table, and by μ0
/// against central differences of whole solutions.
#[test]
fn derivatives_are_those_of_central_differences() {
    let hertz = |load: f64| {
        let wheel = Radii { x: 0.46, y: f64::INFINITY };
        let rail = Radii { x: f64::INFINITY, y: 0.3 };
        let modulus = contact_modulus(&Material::STEEL, &Material::STEEL);
        Arc::new(Hertz::new(wheel, rail, modulus, load).unwrap())
    };
    let (load, mu0) = (80e3, 0.4);
    let with = |load: f64, mu0: f64| {
        Problem { normal: hertz(load), ..warm(all_at_once(mu0), 0.006) }
            .with_interface(|interface| interface.elasticity = half_space())
    };
    let options = Options { tolerance: 1e-11, sensitivity: true, ..cells(14) };
    let at = |load: f64, mu0: f64| at_once(&with(load, mu0), &options);
    let exact = at(load, mu0).sensitivity.unwrap();
    let h = 2e-5;
    let by_load = [at(load * (1.0 + h), mu0).force, at(load * (1.0 - h), mu0).force];
    let by_mu0 = [at(load, mu0 * (1.0 + h)).force, at(load, mu0 * (1.0 - h)).force];
    for (exact, [plus, minus], scale) in
        [(exact.load.unwrap(), by_load, load), (exact.friction_coefficient, by_mu0, mu0)]
    {
        let lever = 5e-3;
        for (exact, difference) in [
            (exact.x, plus.x - minus.x),
            (exact.y, plus.y - minus.y),
            (
                exact.moment_z.unwrap() / lever,
                (plus.moment_z.unwrap() - minus.moment_z.unwrap()) / lever,
            ),
        ] {
            let error = (exact * scale - difference / (2.0 * h)).abs() / (mu0 * load);
            assert!(error < 2e-6, "{error:e}: {} {}", exact * scale, difference / (2.0 * h));
        }
    }
}

/// Products with A do not depend on the grid, and are hardly more than with constant friction.
#[test]
fn work_does_not_grow_with_the_grid() {
    for cells_across in [24, 48, 96] {
        for creepage in [0.001, 0.004, 0.02] {
            let work = at_once(&warm(all_at_once(0.4), creepage), &cells(cells_across)).work;
            assert!(work.operator_products < 50.0 && work.newton_iterations <= 16, "{work:?}");
        }
    }
}
