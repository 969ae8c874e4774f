//! The long-term bulk temperature of a wheel.

use crate::common::{cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::analysis::bulk_temperature::{BulkTemperature, Cooling, bulk_temperature};
use schlupf::bodies::Material;
use schlupf::interface::friction::{TemperatureLinear, TemperaturePiecewiseLinear};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::problem::LongitudinalForce;
use schlupf::solver::SteadySolver;
use schlupf::{Problem, Quantity, Status, unwatched};
use std::sync::Arc;

const COOLING: Cooling = Cooling { film_coefficient: 40.0, area: 1.5, air_temperature: 10.0 };

fn braking(creepage: f64) -> Problem {
    let mut braking = problem(rolling(creepage, 0.0, 0.0));
    braking.interface.elasticity = half_space();
    braking.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    braking.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    braking
}

fn warmed(problem: &Problem, cooling: &Cooling) -> BulkTemperature {
    let warmed =
        bulk_temperature(problem, &mut SteadySolver::new(&cells(20)), cooling, &unwatched).unwrap();
    assert_eq!(warmed.solution.status, Status::Converged, "{:?}", warmed.solution.warnings);
    warmed
}

/// What the wheel receives it gives; the friction is that of the warm wheel.
#[test]
fn the_balance_closes() {
    for creepage in [0.001, 0.01, 0.05] {
        let warmed = warmed(&braking(creepage), &COOLING);
        let given = warmed.convection + warmed.conduction;
        assert_relative_eq!(warmed.frictional_heat, given, max_relative = 2e-6);
        assert!(warmed.temperature > 10.0 && warmed.iterations < 20, "{}", warmed.iterations);
        let mut there = braking(creepage);
        there.interface.wheel.bulk_temperature = warmed.temperature;
        let again = schlupf::solver::solve(&there, &cells(20), &unwatched).unwrap();
        assert_relative_eq!(
            again.power.unwrap().friction,
            warmed.solution.power.unwrap().friction,
            max_relative = 1e-5
        );
    }
}

/// A force in place of the creepage that causes it warms the wheel alike, also where friction can
/// hardly carry it: hotter wheels, which are tried on the way, cannot.
#[test]
fn a_prescribed_force_is_that_of_its_creepage() {
    let cooling = Cooling { film_coefficient: 4.0, ..COOLING };
    for (creepage, speed) in [(0.004, 30.0), (0.0045, 80.0)] {
        let mut given = braking(creepage);
        given.kinematics.speed = speed;
        let mut driven = given.clone();
        let given = warmed(&given, &cooling);
        driven.kinematics.creepage_x = 0.0;
        driven.prescribed.x = Some(LongitudinalForce::Force(given.solution.force.x));
        let found = warmed(&driven, &cooling);
        assert_relative_eq!(found.solution.kinematics.creepage_x, creepage, max_relative = 1e-4);
        assert_relative_eq!(found.temperature, given.temperature, max_relative = 1e-4);
        assert_relative_eq!(found.entry_temperature, given.entry_temperature, max_relative = 1e-4);
    }
}

/// Ertz and Knothe 2002: without air the rail alone cools the wheel. With equal bodies, half of the
/// heat goes into each, the contact has the mean temperature, and
/// ½ P = 2 β ½ (T_w − T_r) ∫ √(v L/π) dy, for an ellipse ∫ √L dy = √(2a) b B(½, 5/4).
#[test]
fn ertz_knothe_2002_cooled_by_the_rail_alone() {
    let mut slow = braking(0.002);
    slow.interface.heat.partition = Partition::Given(0.5);
    let cooling = Cooling { film_coefficient: 1e-9, ..COOLING };
    let warmed = warmed(&slow, &cooling);
    // B(½, 5/4) = Γ(½) Γ(5/4)/Γ(7/4)
    let beta = 1.772_453_850_905_516 * 0.906_402_477_055_477 / 0.919_062_526_848_883;
    let width = (2.0 * 6e-3_f64).sqrt() * 5e-3 * beta;
    let through = Material::STEEL.effusivity() * (30.0 / std::f64::consts::PI).sqrt() * width;
    let expected = 20.0 + 0.5 * warmed.solution.power.unwrap().friction / through;
    assert_relative_eq!(warmed.temperature, expected, max_relative = 2e-3);
}

/// By hand, with both ways out: ½ P = h A (T_w − T_air) + ½ G (T_w − T_r), G = 2 β √(v/π) ∫ √L dy
/// as above, at the friction power P of the result.
#[test]
fn a_balance_by_hand() {
    let mut slow = braking(0.01);
    slow.interface.heat.partition = Partition::Given(0.5);
    let warmed = warmed(&slow, &COOLING);
    let beta = 1.772_453_850_905_516 * 0.906_402_477_055_477 / 0.919_062_526_848_883;
    let width = (2.0 * 6e-3_f64).sqrt() * 5e-3 * beta;
    let through = 2.0 * Material::STEEL.effusivity() * (30.0 / std::f64::consts::PI).sqrt() * width;
    let air = COOLING.film_coefficient * COOLING.area;
    let received =
        0.5 * warmed.solution.power.unwrap().friction + air * 10.0 + 0.5 * through * 20.0;
    assert_relative_eq!(warmed.temperature, received / (air + 0.5 * through), max_relative = 2e-3);
    assert_relative_eq!(warmed.entry_temperature, 0.5 * (warmed.temperature + 20.0));
    assert!(warmed.surplus().abs() < 1e-5 * warmed.frictional_heat);
}

/// Friction that rises with the temperature makes the wheel hotter than with its cold friction.
#[test]
fn rising_friction_is_balanced_too() {
    let mut rising = braking(0.01);
    let cold = Arc::new(TemperaturePiecewiseLinear::new(0.3, 0.3, 100.0).unwrap());
    rising.interface.friction.law = cold;
    let cold = warmed(&rising, &COOLING);
    rising.interface.friction.law =
        Arc::new(TemperaturePiecewiseLinear::new(0.3, 0.9, 100.0).unwrap());
    let hot = warmed(&rising, &COOLING);
    assert!(hot.temperature > cold.temperature + 10.0, "{} {}", hot.temperature, cold.temperature);
    assert_relative_eq!(hot.frictional_heat, hot.convection + hot.conduction, max_relative = 2e-6);
}

/// A stronger wind, a colder wheel; and never hotter than friction allows.
#[test]
fn more_air_less_heat() {
    let calm = warmed(&braking(0.01), &COOLING).temperature;
    let windy = warmed(&braking(0.01), &Cooling { film_coefficient: 200.0, ..COOLING }).temperature;
    assert!(windy < calm);
    let glowing = warmed(&braking(0.5), &Cooling { film_coefficient: 0.1, ..COOLING });
    assert!(glowing.solution.temperature.unwrap().max_wheel < 20.0 + 700.0);
}

#[test]
fn what_cannot_warm_is_refused() {
    let mut cold = braking(0.01);
    cold.interface.heat.model = None;
    let error = bulk_temperature(&cold, &mut SteadySolver::new(&cells(8)), &COOLING, &unwatched)
        .unwrap_err();
    assert!(error.quantity() == Quantity::HeatModel);
    let still = Cooling { area: 0.0, ..COOLING };
    let error =
        bulk_temperature(&braking(0.01), &mut SteadySolver::new(&cells(8)), &still, &unwatched)
            .unwrap_err();
    assert!(error.to_string().starts_with("cooled_area"), "{error}");
}

/// A wheel that rolls without friction goes to where air and rail balance.
#[test]
fn without_friction_air_and_rail_balance() {
    let mut idle = braking(0.0);
    idle.interface.rail.bulk_temperature = 20.0;
    let warm_air = Cooling { air_temperature: 50.0, ..COOLING };
    let warmed = warmed(&idle, &warm_air);
    assert!((20.0..50.0).contains(&warmed.temperature), "{}", warmed.temperature);
    assert_relative_eq!(warmed.convection, -warmed.conduction, max_relative = 1e-5);
}
