//! Frictional heat in slow rolling, where it also flows along the surface: conduction in all
//! directions in both bodies (Jaeger 1942), each of which passes at its own speed.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::{self, cells, problem, rolling};
use approx::assert_relative_eq;
use schlupf::bodies::{Body, Kinematics, Material, contact_modulus};
use schlupf::elasticity::Rigid;
use schlupf::interface::friction::{Constant, TemperatureLinear};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::{Ellipse, Hertz, Radii};
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solution, Solver, Status, unwatched};

/// Semi-axis along rolling, in m.
const A: f64 = 5e-3;

const ALUMINIUM: Material = Material {
    young_modulus: 70e9,
    poisson_ratio: 0.33,
    conductivity: 200.0,
    density: 2700.0,
    specific_heat: 900.0,
};

const RUBBER: Material = Material {
    young_modulus: 5e6,
    poisson_ratio: 0.49,
    conductivity: 0.2,
    density: 1100.0,
    specific_heat: 1900.0,
};

/// A speed at which steel has a Péclet number v a/κ, in m/s.
fn speed(peclet: f64) -> f64 {
    peclet * Material::STEEL.diffusivity() / A
}

/// Rigid steel bodies, a = 5 mm, μ = 0.4, p0 = 1 GPa: the wheel slides by `slip` (in m/s; negative
/// when it spins) over the rail, which passes at a speed (in m/s).
fn slide(b: f64, speed: f64, slip: f64, partition: Partition) -> Problem {
    let mut slide = problem(rolling(slip / speed, 0.0, 0.0));
    slide.kinematics.speed = speed;
    slide.normal = Arc::new(Ellipse::from_peak_pressure(A, b, 1e9).unwrap());
    slide.interface.elasticity = Arc::new(Rigid);
    slide.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition };
    slide
}

fn solve(problem: &Problem, options: &Options) -> Solution {
    let solution = schlupf::solver::solve(problem, options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

/// Largest flux q0 of 0.01 m/s at μ p0 = 400 MPa, times a/λ, in K.
const UNIT: f64 = 0.01 * 400e6 * A / 50.0;

/// Johnson 1985, §3.2 and 4.2: under the flux q0 √(1 − x²/a² − y²/b²) on a body at rest the centre
/// is the hottest place, with q0 b K(e)/(2λ), b being the smaller semi-axis and K the complete
/// elliptic integral (as under Hertz's pressure the displacement), π q0 a/(4λ) on a circle. All of
/// the heat goes into the rail.
#[test]
fn carslaw_jaeger_1959_hertzian_flux_at_rest() {
    // K(0) and K(√(1 − 1/4)).
    for (b, elliptic) in [(A, 0.5 * PI), (0.5 * A, 2.156_515_647_499_643)] {
        let rest = slide(b, speed(1e-9), -0.01, Partition::Given(0.0));
        let expected = 0.5 * elliptic * b / A * UNIT;
        for (along, allowed) in [(11, 8e-3), (21, 3e-3), (41, 1e-3)] {
            let hottest = solve(&rest, &cells(along)).temperature.unwrap();
            println!("b = {b}, {along} cells: {} of {expected} K", hottest.max_rise_rail);
            assert_relative_eq!(hottest.max_rise_rail, expected, max_relative = allowed);
            assert!(hottest.x.abs() < 1e-9 && hottest.y.abs() < 1e-9);
            assert_eq!(hottest.max_rise_wheel, 0.0);
        }
    }
}

/// Jaeger 1942: the largest rise under a moving flux like Hertz's pressure over a circle, over q0
/// a/λ, and its place. Expected: (1/2πλ) ∫∫ q exp(−v(R + X)/2κ)/R dA in polar coordinates about the
/// place (SciPy, 5 digits).
#[test]
fn jaeger_1942_moving_hertzian_flux() {
    for (peclet, expected, place) in [
        (0.5, 0.714_62, -0.104),
        (1.0, 0.661_46, -0.178),
        (5.0, 0.455_56, -0.436),
        (20.0, 0.262_75, -0.595),
        (100.0, 0.122_26, -0.641),
    ] {
        let moving = slide(A, speed(peclet), -0.01, Partition::Given(0.0));
        let solution = solve(&moving, &cells(41));
        let hottest = solution.temperature.unwrap();
        println!("{peclet}: {} of {expected}, at {}", hottest.max_rise / UNIT, hottest.x / A);
        assert_relative_eq!(hottest.max_rise / UNIT, expected, max_relative = 3e-3);
        assert!((hottest.x / A - place).abs() < 0.05);
        assert_relative_eq!(solution.peclet[1], peclet, max_relative = 1e-12);
    }
}

/// From conduction in all directions to that perpendicular to the surface: where one takes the
/// other's place, at a Péclet number of 500 (times (a/b)² on a long patch), all changes by less
/// than 0.5 %.
#[test]
fn the_rises_are_continuous_where_conduction_along_the_surface_ends() {
    for (b, peclet) in [(A, 500.0), (2.0 * A, 500.0), (A / 3.0, 4500.0)] {
        for partition in [Partition::Velocity, Partition::Given(0.5)] {
            for along in [20, 40] {
                let at = |factor: f64| {
                    let slow = slide(b, factor * speed(peclet), 0.01, partition.clone());
                    solve(&slow, &cells(along))
                };
                // The wheel brakes, so it is the slower one.
                let factor =
                    if partition == Partition::Velocity { 1.0 + 0.01 / speed(peclet) } else { 1.0 };
                let [below, above] = [at(factor * 0.99999), at(factor * 1.00001)];
                assert_ne!(below.fields.temperature_rise_rail, above.fields.temperature_rise_rail);
                let change =
                    above.temperature.unwrap().max_rise / below.temperature.unwrap().max_rise - 1.0;
                println!("b = {b}, {along} cells, {partition:?}: {change}");
                assert!(change.abs() < 5e-3, "{change}");
                let heat = above.power.unwrap().into_wheel / below.power.unwrap().into_wheel - 1.0;
                assert!(heat.abs() < 1e-3, "{heat}");
            }
        }
    }
}

/// The wheel spins near standstill: Péclet numbers 100 of the wheel and 0.01 of the rail. Both
/// surfaces are equally hot everywhere, the heat is all there, and share and largest rise over q0
/// a/λ are those of an independent computation (NumPy, GMRES for the equal temperatures, 80 cells):
/// 0.8996 and 0.1057.
#[test]
fn jaeger_1942_partition_of_a_wheel_that_spins_near_standstill() {
    let slip = speed(100.0) - speed(0.01);
    let spinning = slide(A, speed(0.01), -slip, Partition::Velocity);
    let flux = 400e6 * slip;
    for (along, allowed) in [(20, 1e-2), (40, 4e-3), (80, 2e-3)] {
        let solution = solve(&spinning, &cells(along));
        let hottest = solution.temperature.unwrap();
        let share = solution.power.unwrap().into_wheel / solution.power.unwrap().friction;
        println!("{along}: {share}, {}", hottest.max_rise / (flux * A / 50.0));
        assert_relative_eq!(solution.peclet[0], 100.0, max_relative = 1e-9);
        assert_relative_eq!(share, 0.8996, max_relative = 1e-3);
        assert_relative_eq!(hottest.max_rise / (flux * A / 50.0), 0.1057, max_relative = allowed);
        let sum = solution.power.unwrap().into_wheel + solution.power.unwrap().into_rail;
        assert_relative_eq!(sum, solution.power.unwrap().friction, max_relative = 1e-10);
        assert_relative_eq!(sum, solution.power.unwrap().creep, max_relative = 1e-10);
        let fields = &solution.fields;
        for (wheel, rail) in fields.temperature_rise_wheel.iter().zip(&fields.temperature_rise_rail)
        {
            assert_relative_eq!(*wheel, *rail, max_relative = 1e-8);
        }
    }
}

/// Different bodies at rest: both half-spaces have the same kernel over 1/λ, so λ_w/(λ_w + λ_r) of
/// the heat goes into the wheel, and the circle's centre has π q0 a/(4 (λ_w + λ_r)).
#[test]
fn bodies_at_rest_share_by_their_conductivities() {
    let mut rest = slide(A, speed(1e-7), 1e-10, Partition::Velocity);
    rest.interface.wheel.material = ALUMINIUM;
    // So slow that even this is little.
    let flux = 400e6 * 1e-10;
    let solution = solve(&rest, &cells(41));
    let share = solution.power.unwrap().into_wheel
        / (solution.power.unwrap().friction + solution.power.unwrap().returned);
    assert_relative_eq!(share, 200.0 / 250.0, max_relative = 1e-6);
    let expected = 0.25 * PI * flux * A / 250.0;
    assert_relative_eq!(
        solution.temperature.unwrap().max_rise_wheel,
        expected,
        max_relative = 2e-3
    );
    assert_relative_eq!(solution.temperature.unwrap().max_rise_rail, expected, max_relative = 2e-3);
}

/// One row of cells, and two columns: the heat is still all there.
#[test]
fn the_coarsest_grids_keep_the_heat() {
    for (cells_x, cells_y) in [(2, 1), (30, 1), (2, 30)] {
        let options = Options { cells_x, cells_y, ..Options::default() };
        let solution = solve(&slide(A, speed(1.0), -0.01, Partition::Velocity), &options);
        let sum = solution.power.unwrap().into_wheel + solution.power.unwrap().into_rail;
        assert_relative_eq!(sum, solution.power.unwrap().creep, max_relative = 1e-10);
        let rise = solution.temperature.unwrap().max_rise / UNIT;
        assert!(rise > 0.1 && rise < 0.5 * PI, "{rise}");
    }
}

/// Holm 1967: two equal half-spaces at rest that touch in a circle exchange 2 λ a ΔT; the middle of
/// both surfaces has the mean temperature.
#[test]
fn holm_1967_constriction_between_bodies_at_rest() {
    for (along, allowed) in [(20, 1.5e-2), (40, 1e-2), (80, 6e-3)] {
        let mut rest = slide(A, speed(1e-7), 0.0, Partition::Given(0.5));
        rest.interface.wheel.bulk_temperature = 120.0;
        let solution = solve(&rest, &cells(along));
        println!("{along}: {} W", solution.power.unwrap().exchanged.unwrap());
        assert_relative_eq!(
            solution.power.unwrap().exchanged.unwrap(),
            50.0,
            max_relative = allowed
        );
        let middle = solution.fields.x.iter().zip(&solution.fields.y);
        let middle = middle.map(|(x, y)| x.hypot(*y)).enumerate();
        let (k, _) = middle.min_by(|p, q| p.1.total_cmp(&q.1)).unwrap();
        assert_relative_eq!(solution.fields.temperature_rise_rail[k], 50.0, max_relative = 1e-6);
        assert_relative_eq!(solution.fields.temperature_rise_wheel[k], -50.0, max_relative = 1e-6);
    }
}

/// The heat through the contact goes over into that of conduction perpendicular to the surface.
#[test]
fn exchanged_heat_is_continuous_where_conduction_along_the_surface_ends() {
    let at = |peclet: f64| {
        let mut slow = slide(A, speed(peclet), 0.0, Partition::Velocity);
        slow.interface.wheel.bulk_temperature = 120.0;
        solve(&slow, &cells(60)).power.unwrap().exchanged.unwrap()
    };
    let change = at(500.01) / at(499.99) - 1.0;
    println!("{change}");
    assert!(change.abs() < 0.02, "{change}");
}

/// A spinning wheel near standstill, friction falling with temperature (T_E = 700 K): as hot, as
/// strong and shared as in an independent computation (NumPy, the linear system of temperatures
/// under μ0 (1 − T/T_E) p w, 120 cells across): 353.4 K, 0.6249 of μ0 N, 0.8211 into the wheel;
/// 630.7 K if friction did not fall.
fn spinning() -> Problem {
    let mut spinning = slide(A, 1e-3, -0.1, Partition::Velocity);
    spinning.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    spinning
}

#[test]
fn friction_sees_the_temperature_of_a_wheel_that_spins_near_standstill() {
    for (along, allowed) in [(20, 3e-3), (40, 1.5e-3)] {
        let solution = solve(&spinning(), &cells(along));
        let work = solution.work;
        println!("{} {:?}", solution.normalised.x, solution.temperature.unwrap());
        println!("{} Newton steps, {} products", work.newton_iterations, work.operator_products);
        let share = solution.power.unwrap().into_wheel / solution.power.unwrap().friction;
        assert_relative_eq!(solution.temperature.unwrap().max_rise, 353.4, max_relative = allowed);
        assert_relative_eq!(solution.normalised.x, 0.6249, max_relative = allowed);
        assert_relative_eq!(share, 0.8211, max_relative = allowed);
        assert!(work.newton_iterations <= 30 && work.operator_products <= 150.0);
        let fields = &solution.fields;
        for (mu, rise) in fields.friction_coefficient.iter().zip(&fields.temperature_rise_rail) {
            assert_relative_eq!(*mu, 0.4 * (1.0 - rise / 700.0), max_relative = 1e-5);
        }
    }
    let mut constant = spinning();
    constant.interface.friction.law = Arc::new(Constant::new(0.4).unwrap());
    let hottest = solve(&constant, &cells(40)).temperature.unwrap().max_rise;
    assert_relative_eq!(hottest, 630.7, max_relative = 3e-3);
}

fn hertz(load: f64) -> Arc<Hertz> {
    let wheel = Radii { x: 0.46, y: f64::INFINITY };
    let rail = Radii { x: f64::INFINITY, y: 0.3 };
    let modulus = contact_modulus(&Material::STEEL, &Material::STEEL);
    Arc::new(Hertz::new(wheel, rail, modulus, load).unwrap())
}

/// A wheel of aluminium, with creepages that refer to the speed of the vehicle or to the mean.
#[test]
fn the_reference_of_creepages_does_not_change_temperatures() {
    let (rail, slip) = (speed(2.0), -0.3 * speed(2.0));
    let mut slide = slide(A, rail, slip, Partition::Velocity);
    slide.interface.wheel = Body { bulk_temperature: 40.0, material: ALUMINIUM };
    let [by_vehicle, by_mean] = common::motions([rail, rail - slip]).map(|motion| {
        slide.kinematics = motion;
        let found = solve(&slide, &cells(16));
        let hottest = found.temperature.unwrap();
        [hottest.max_rise_wheel, hottest.max_rise_rail, found.peclet[0], found.peclet[1]]
    });
    println!("{by_vehicle:?} {by_mean:?}");
    for (one, other) in by_vehicle.into_iter().zip(by_mean) {
        assert_relative_eq!(one, other, max_relative = 1e-9);
    }
}

/// The same on elastic bodies: derivatives by creepage and load agree with differences of
/// solutions.
#[test]
fn derivatives_know_the_conduction_along_the_surface() {
    for motion in common::motions([0.3, 0.315]) {
        check_derivatives(Kinematics { creepage_y: 0.01, ..motion });
    }
}

fn check_derivatives(motion: Kinematics) {
    let mut base = problem(motion);
    base.interface.friction.law = Arc::new(TemperatureLinear::new(0.4, 60.0, 0.0).unwrap());
    base.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    base.interface.elasticity = common::half_space();
    base.interface.wheel.bulk_temperature = 25.0;
    base.normal = hertz(30e3);
    let options = Options { tolerance: 1e-10, ..cells(16) };
    let found =
        SteadySolver::new(&options).solve_with_derivatives(&base, &unwatched).unwrap().unwrap();
    println!("rise {} K, {:?}", found.temperature.unwrap().max_rise, found.peclet);
    assert!(found.peclet[1] < 500.0 && found.temperature.unwrap().max_rise > 10.0);
    let sensitivity = found.sensitivity.unwrap();
    let force = |changed: &Kinematics| {
        let changed = Problem { kinematics: *changed, ..base.clone() };
        solve(&changed, &options).force
    };
    let step = 1e-5;
    for (c, derivative) in [(0, sensitivity.creepage_x), (1, sensitivity.creepage_y)] {
        let moved = |step: f64| {
            let mut moved = base.kinematics;
            if c == 0 {
                moved.creepage_x += step;
            } else {
                moved.creepage_y += step;
            }
            force(&moved)
        };
        let (more, less) = (moved(step), moved(-step));
        let expected = [more.x - less.x, more.y - less.y].map(|change| change / (2.0 * step));
        println!("{expected:?} {derivative:?}");
        let scale = expected[0].hypot(expected[1]);
        assert!((derivative.x - expected[0]).hypot(derivative.y - expected[1]) < 1e-4 * scale);
    }
    let loaded = |load: f64| {
        let loaded = Problem { normal: hertz(load), ..base.clone() };
        solve(&loaded, &options).force
    };
    let (more, less) = (loaded(30e3 + 3.0), loaded(30e3 - 3.0));
    let expected = [more.x - less.x, more.y - less.y].map(|change| change / 6.0);
    let derivative = sensitivity.load.unwrap();
    println!("{expected:?} {derivative:?}");
    assert!((derivative.x - expected[0]).hypot(derivative.y - expected[1]) < 1e-4 * 0.4);
}

/// At 30 m/s, aluminium on steel and rubber on steel: with the partition from the velocities both
/// surfaces are equally hot. Half to each heats rubber alone many times too much, and equal steel
/// bodies hardly differ.
#[test]
fn jaeger_1942_partition_of_different_bodies() {
    let hottest = |wheel: Material, partition| {
        let mut slide = slide(A, 30.0, 0.3, partition);
        slide.interface.wheel = Body { material: wheel, ..Body::STEEL };
        solve(&slide, &cells(20)).temperature.unwrap()
    };
    for wheel in [ALUMINIUM, RUBBER] {
        let common = hottest(wheel, Partition::Velocity);
        assert_relative_eq!(common.max_rise_wheel, common.max_rise_rail, max_relative = 1e-12);
        let halves = hottest(wheel, Partition::Given(0.5));
        println!("{common:?} {halves:?}");
        assert!(halves.max_rise > 1.15 * common.max_rise);
    }
    let rubber = hottest(RUBBER, Partition::Given(0.5)).max_rise;
    assert!(rubber > 10.0 * hottest(RUBBER, Partition::Velocity).max_rise);
    let [given, own] =
        [Partition::Given(0.5), Partition::Velocity].map(|p| hottest(Material::STEEL, p).max_rise);
    assert_relative_eq!(own, given, max_relative = 0.01);
}

/// Marching, the paper's heat model and temperatures below the surface conduct perpendicular to the
/// surface only: in slow rolling they say so, with the Péclet numbers. So does a surface that steel
/// does not stand.
#[test]
fn what_does_not_hold_is_said() {
    let slow = slide(A, speed(10.0), 0.01, Partition::Given(0.5));
    let marched = common::solve(&slow, &cells(10));
    let steady = solve(&slow, &cells(10));
    let is_about = |solution: &Solution, what: &str| {
        solution.warnings.iter().any(|warning| warning.to_string().contains(what))
    };
    assert!(is_about(&marched, "1.000e1 (wheel) and 1.000e1 (rail)"));
    assert!(!is_about(&steady, "heat"), "{:?}", steady.warnings);
    let excess = marched.temperature.unwrap().max_rise / steady.temperature.unwrap().max_rise - 1.0;
    assert!((excess - 0.10).abs() < 0.015, "{excess}");
    let mut hot = slide(A, 30.0, 4.0, Partition::Velocity);
    let limits = |problem: &Problem| {
        let solution = solve(problem, &cells(10));
        (
            solution.temperature.unwrap().max_rail,
            is_about(&solution, "austenitise"),
            is_about(&solution, "melting"),
        )
    };
    let (temperature, austenite, molten) = limits(&hot);
    assert!(temperature > 727.0 && temperature < 1380.0, "{temperature}");
    assert!(austenite && !molten);
    hot.kinematics.creepage_x = 0.05;
    let (temperature, austenite, molten) = limits(&hot);
    assert!(temperature < 727.0 && !austenite && !molten, "{temperature}");
    hot.kinematics.creepage_x = -0.7;
    let (temperature, austenite, molten) = limits(&hot);
    assert!(temperature > 1380.0 && molten && !austenite, "{temperature}");
}
