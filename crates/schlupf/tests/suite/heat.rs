//! Frictional heat in the contact.

use std::sync::Arc;

use crate::common::{cells, motions, problem, rolling, solve};
use approx::assert_relative_eq;
use schlupf::analysis::temperature_field::{Side, TemperatureField};
use schlupf::bodies::{Body, Material};
use schlupf::elasticity::Rigid;
use schlupf::interface::friction::{Constant, TemperatureLinear};
use schlupf::interface::heat::{ConstantSource, Duhamel, Heat, HeatModel, Partition};
use schlupf::normal::Ellipse;
use schlupf::solver::reference::SemiEllipticSource;
use schlupf::{Options, Problem, Solution};

fn half_to_each(model: Arc<dyn HeatModel>) -> Heat {
    Heat { model: Some(model), partition: Partition::Given(0.5) }
}

/// Full slide of 1 m/s at 30 m/s, μ = 0.3, a = 5.88 mm, b = 10.54 mm, p0 = 770.4 MPa.
fn full_slide(model: Arc<dyn HeatModel>) -> Problem {
    let mut slide = problem(rolling(1.0 / 30.0, 0.0, 0.0));
    slide.normal = Arc::new(Ellipse::from_peak_pressure(5.88e-3, 10.54e-3, 770.4e6).unwrap());
    slide.interface.elasticity = Arc::new(Rigid);
    slide.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    slide.interface.heat = half_to_each(model);
    slide
}

/// Knothe and Liebelt 1995: the flash temperature is 1.2346 ½ q0 √(a/v)/β = 150.3 K at x = −0.65 a.
#[test]
fn knothe_liebelt_1995_flash_temperature() {
    for (along, allowed) in [(20, 5e-3), (40, 2e-3)] {
        let options = Options { cells_x: along, cells_y: 41, ..Options::default() };
        let hottest = solve(&full_slide(Arc::new(Duhamel)), &options).temperature.unwrap();
        println!("{along} cells: {} K at x/a = {}", hottest.max_rise, hottest.x / 5.88e-3);
        assert_relative_eq!(hottest.max_rise, 150.3, max_relative = allowed);
        assert!((hottest.x / 5.88e-3 + 0.65).abs() < 2.0 / along as f64);
        assert!(hottest.y.abs() < 1e-9);
        // q0 = μ p0 w, half of it into each body.
        let source = SemiEllipticSource {
            flux: 0.5 * 0.3 * 770.4e6,
            half_length: 5.88e-3,
            speed: 30.0,
            effusivity: Material::STEEL.effusivity(),
        };
        let there = source.temperature_rise(hottest.x);
        assert_relative_eq!(hottest.max_rise, there, max_relative = allowed);
    }
}

/// The same all along the middle row, whole cells, to 0.3 % of the largest rise at 40 cells; and at
/// the trailing edge, where 0.862 of it is left, to 0.2 %.
#[test]
fn knothe_liebelt_1995_along_the_row() {
    let options = Options { cells_x: 40, cells_y: 41, ..Options::default() };
    let slide = full_slide(Arc::new(Duhamel));
    let solution = solve(&slide, &options);
    let fields = &solution.fields;
    let source = SemiEllipticSource {
        flux: 0.5 * 0.3 * 770.4e6,
        half_length: 5.88e-3,
        speed: 30.0,
        effusivity: Material::STEEL.effusivity(),
    };
    let whole = |k: &usize| fields.y[*k].abs() < 1e-9 && fields.covered[*k] > 1.0 - 1e-9;
    let error = |k: usize| {
        (fields.temperature_rise_wheel[k] - source.temperature_rise(fields.x[k])).abs() / 150.3
    };
    let worst = (0..fields.len()).filter(whole).map(error).fold(0.0, f64::max);
    let field = TemperatureField::new(&slide, &solution).unwrap();
    let trailing = (field.at(Side::Rail, -5.88e-3, 0.0, 0.0) - 20.0) / 150.3;
    println!("worst {worst}, trailing edge {trailing}");
    assert!(worst < 3e-3, "{worst}");
    assert!((trailing - 0.862).abs() < 2e-3, "{trailing}");
}

/// Neuhaus and Sextro 2014, Eqs. (21), (22): the constant source is hottest at the trailing edge,
/// T = (1/√π) q0 √(4a/3v)/β = 158.6 K.
#[test]
fn neuhaus_sextro_2014_constant_source_at_the_trailing_edge() {
    let options = Options { cells_x: 40, cells_y: 41, ..Options::default() };
    let hottest = solve(&full_slide(Arc::new(ConstantSource)), &options).temperature.unwrap();
    println!("{} K at x = {} m", hottest.max_rise, hottest.x);
    assert_relative_eq!(hottest.max_rise, 158.6, max_relative = 3e-3);
    assert_relative_eq!(hottest.x, -5.88e-3, max_relative = 5e-3);
}

fn hot_layer(creepage_x: f64, model: Arc<dyn HeatModel>) -> Solution {
    let mut hot = problem(rolling(creepage_x, 0.0, 0.0));
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    hot.interface.heat = half_to_each(model);
    solve(&hot, &cells(40))
}

/// The layer with friction that falls with temperature, T_E = 700 K, against converged values of
/// the prototype, to 1 %.
#[test]
fn neuhaus_sextro_2014_layer_with_heat() {
    for (creepage, paper, force, rise) in [
        (0.02, false, -0.884, 140.0),
        (0.02, true, -0.889, 146.0),
        (0.05, false, -0.746, 271.0),
        (0.05, true, -0.746, 294.0),
    ] {
        let model: Arc<dyn HeatModel> =
            if paper { Arc::new(ConstantSource) } else { Arc::new(Duhamel) };
        let solution = hot_layer(creepage, model);
        println!("{} {}", solution.normalised.x, solution.temperature.unwrap().max_rise);
        assert_relative_eq!(solution.normalised.x, force, max_relative = 0.01);
        assert_relative_eq!(solution.temperature.unwrap().max_rise, rise, max_relative = 0.01);
    }
}

/// A hot wheel cools in the contact and the rail warms up, both to the mean weighted by β√v;
/// sliding adds to that.
#[test]
fn bulk_temperatures_mix_on_entry() {
    let mut slide = full_slide(Arc::new(Duhamel));
    slide.interface.wheel = Body { bulk_temperature: 150.0, ..Body::STEEL };
    slide.interface.rail = Body { bulk_temperature: 0.0, ..Body::STEEL };
    slide.interface.friction.reference_temperature = 0.0;
    let options = Options { cells_x: 40, cells_y: 41, ..Options::default() };
    let sliding = solve(&slide, &options).temperature.unwrap();
    println!("{} {}", sliding.max_rise_rail, sliding.max_rise_wheel);
    assert_relative_eq!(sliding.max_rise_rail, 75.0 + 150.3, epsilon = 0.002 * 150.3);
    assert_relative_eq!(sliding.max_rise_wheel, -75.0 + 150.3, epsilon = 0.002 * 150.3);
    slide.kinematics.creepage_x = 0.0;
    let rolling = solve(&slide, &options).temperature.unwrap();
    assert_relative_eq!(rolling.max_rail, 75.0, max_relative = 1e-12);
    assert_relative_eq!(rolling.max_rise_wheel, -75.0, max_relative = 1e-12);
}

/// Partition from the velocities: the slower wheel material stays longer and takes less.
#[test]
fn velocity_partition_heats_both_surfaces_alike() {
    let mut slide = full_slide(Arc::new(Duhamel));
    slide.interface.heat.partition = Partition::Velocity;
    let hottest = solve(&slide, &cells(20)).temperature.unwrap();
    assert_relative_eq!(hottest.max_rise_wheel, hottest.max_rise_rail, max_relative = 1e-12);
}

/// A wheel of aluminium that turns at 27 m/s over a rail that passes at 30 m/s.
#[test]
fn creepages_that_refer_to_the_mean_speed_give_the_same_temperatures() {
    let mut slide = full_slide(Arc::new(Duhamel));
    let aluminium = Material { conductivity: 200.0, density: 2700.0, ..Material::STEEL };
    let wheel = Body { bulk_temperature: 150.0, material: aluminium };
    slide.interface.wheel = wheel;
    slide.interface.heat.partition = Partition::Velocity;
    let [by_vehicle, by_mean] = motions([30.0, 27.0]).map(|motion| {
        slide.kinematics = motion;
        let found = solve(&slide, &cells(20)).temperature.unwrap();
        [found.max_rise_wheel, found.max_rise_rail]
    });
    for (one, other) in by_vehicle.into_iter().zip(by_mean) {
        assert_relative_eq!(one, other, max_relative = 1e-12);
    }
}

/// A floor keeps the friction from vanishing, and the solution says what is hot.
#[test]
fn a_floor_holds_at_high_slip() {
    let mut hot = problem(rolling(0.2, 0.0, 0.0));
    hot.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 300.0, 0.15).unwrap());
    hot.interface.heat = half_to_each(Arc::new(Duhamel));
    let solution = solve(&hot, &cells(20));
    let least = solution.fields.friction_coefficient.iter().copied().fold(1.0, f64::min);
    assert_eq!(least, 0.15);
    assert!(solution.temperature.unwrap().max_rise > 300.0);
}
