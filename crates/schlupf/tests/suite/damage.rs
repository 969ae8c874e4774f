//! Damage over a run, against closed forms and values of the literature.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use crate::common::motions;
use schlupf::analysis::damage::{
    ArchardWear, CrackFunction, EnergyWear, Laws, Profile, ShakedownLimits, State, SurfaceFatigue,
    WearMap, of_passage, of_run,
};
use schlupf::bodies::Material;
use schlupf::elasticity::HalfSpace;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::Heat;
use schlupf::normal::Ellipse;
use schlupf::problem::{Brush, FastMethod, Method, TractionBound};
use schlupf::{Error, Options, Problem, Quantity, solver, unwatched};

const RADIUS: f64 = 0.46;

fn laws() -> Laws {
    Laws { wheel_radius: RADIUS, densities: [7850.0, 7800.0], ..Laws::default() }
}

/// A Hertzian contact with p0 = 3N/(2πab) that slides at so many m/s.
fn sliding(distance: f64, slip_speed: f64) -> State {
    let [load, a, b, friction_coefficient] = [80e3, 6e-3, 4e-3, 0.4];
    let friction_power = friction_coefficient * load * slip_speed;
    State {
        distance,
        middle: 0.5 * distance,
        speed: 20.0,
        position_y: 0.01,
        rail_position_y: 0.01,
        is_further_contact: false,
        load,
        semi_axis_x: a,
        semi_axis_y: b,
        peak_pressure: 1.5 * load / (PI * a * b),
        contact_area: PI * a * b,
        tangential_force: friction_coefficient * load,
        t_gamma: friction_power / 20.0,
        friction_power,
        friction_coefficient,
    }
}

fn integral(profile: &Profile, depth: &[f64]) -> f64 {
    let width = profile.y[1] - profile.y[0];
    depth.iter().sum::<f64>() * width
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} {expected}");
}

/// Ekberg, Kabo and Andersson 2002: FI is the utilised friction minus the shakedown limit k/p0 of
/// full sliding, so that it is zero where both are equal.
#[test]
fn ekberg_2002_surface_fatigue_is_the_distance_from_shakedown() {
    let fatigue = SurfaceFatigue { shear_yield_stress: 300e6 };
    let state = sliding(1.0, 0.1);
    near(fatigue.index(&state), 0.4 - 300e6 / state.peak_pressure, 1e-12);
    let free = State { tangential_force: 0.0, ..state };
    near(fatigue.index(&free), -300e6 / state.peak_pressure, 1e-12);
    let shakedown = SurfaceFatigue { shear_yield_stress: 0.4 * state.peak_pressure };
    assert!(shakedown.index(&state).abs() < 1e-12);
}

/// Braghin, Lewis, Dwyer-Joyce and Bruni 2006: 5.3 Tγ/A up to 10.4 N/mm², 55 µg/(m mm²) up to
/// 77.2 N/mm², and 61.9 µg/(m N) beyond; their rounded plateau differs by 0.3 % from the line.
#[test]
fn braghin_2006_wear_rates_are_those_of_the_three_regimes() {
    let law = EnergyWear::default();
    // µg/(m mm²), for Tγ/A in N/mm².
    let rate = |energy: f64| law.rate(energy * 1e6) * 1e9 * 1e-6;
    near(rate(5.0), 26.5, 1e-12);
    for energy in [10.4, 40.0, 77.2] {
        near(rate(energy), 55.0, 3e-3);
    }
    near(rate(100.0) - rate(77.2), 61.9 * 22.8, 1e-12);
    assert_eq!(law.rate(0.0), 0.0);
}

/// Jendel 2002: mild, severe, mild with the slip speed, catastrophic above 0.8 H.
#[test]
fn jendel_2002_wear_map_has_its_regimes() {
    let law = ArchardWear::default();
    let of = |speed: f64, pressure: f64| law.coefficient(speed, pressure * law.hardness);
    assert_eq!([of(0.1, 0.5), of(0.5, 0.5), of(0.9, 0.5)], [5e-4, 35e-4, 5e-4]);
    assert_eq!([of(0.1, 0.81), of(0.5, 0.81)], [350e-4; 2]);
    // V = k N s/(H v0), with all of the contact sliding at s.
    near(law.volume(&sliding(1.0, 0.5)), 35e-4 * 80e3 * 0.5 / (2.7e9 * 20.0), 1e-12);
}

/// Volumes and masses are those of the profile, for wheel and rail, by both laws.
#[test]
fn wear_across_the_profile_conserves_volume() {
    let mut states: Vec<State> = (0..7)
        .map(|k| {
            let position_y = 1.7e-3 * f64::from(k * k % 5);
            State { position_y, rail_position_y: -0.3 * position_y, ..sliding(100.0, 0.05) }
        })
        .collect();
    states[3].semi_axis_y = 7e-3;
    let damage = of_run(&states, &laws()).unwrap();
    let profile = &damage.profile;
    near(
        TAU * RADIUS * integral(profile, &profile.wheel_archard),
        damage.archard.wheel_volume,
        1e-9,
    );
    let energy = damage.energy_wear;
    near(TAU * RADIUS * integral(profile, &profile.wheel_energy), energy.wheel_volume, 1e-9);
    near(7850.0 * energy.wheel_volume, energy.wheel_mass, 1e-12);
    near(7800.0 * integral(profile, &profile.rail_energy), energy.rail_mass_per_length, 1e-9);
    let archard = damage.archard.rail_mass_per_length;
    near(7800.0 * integral(profile, &profile.rail_archard), archard, 1e-9);
}

/// A single place: h(y) = V s/(2πR) 3/(4b) (1 − (y/b)²), in its middle and at half its width.
#[test]
fn wear_in_one_place_has_the_shape_of_the_load() {
    let state = sliding(5000.0, 0.1);
    let damage = of_run(&[state], &laws()).unwrap();
    let profile = &damage.profile;
    assert_eq!(profile.y.len(), 20);
    near(profile.y[0], 0.01 - 4e-3 + 2e-4, 1e-9);
    let volume = 5e-4 * 80e3 * 0.1 / (2.7e9 * 20.0);
    let around = TAU * RADIUS;
    for (y, depth) in profile.y.iter().zip(&profile.wheel_archard) {
        // The mean of the parabola over a cell: 1 − u² − w²/12.
        let (u, w) = ((y - 0.01) / 4e-3, 0.1_f64);
        let shape = 0.75 / 4e-3 * (1.0 - u * u - w * w / 12.0);
        near(*depth, volume * 5000.0 / around * shape, 1e-9);
    }
}

#[test]
fn sums_are_those_over_the_distance() {
    let states = [sliding(100.0, 0.1), State { middle: 250.0, ..sliding(300.0, 0.3) }];
    let damage = of_run(&states, &laws()).unwrap();
    let (slow, fast) = (0.4 * 80e3 * 0.1 / 20.0, 0.4 * 80e3 * 0.3 / 20.0);
    assert_eq!((damage.states, damage.distance, damage.duration), (2, 400.0, 20.0));
    near(damage.energy, slow * 100.0 + fast * 300.0, 1e-12);
    near(damage.t_gamma.mean, damage.energy / 400.0, 1e-12);
    near(damage.t_gamma.max, fast, 1e-12);
    let slips = &damage.histograms[2];
    assert_eq!(slips.quantity, Quantity::SlipSpeed);
    near(slips.shares[0], 0.25, 1e-12);
    near(damage.points[1].energy, damage.energy, 1e-12);
    assert_eq!((damage.points[0].distance, damage.points[1].distance), (50.0, 250.0));
    // Twice the same state is that state over twice the distance.
    let [twice, once] = [of_run(&[states[1]; 2], &laws()), of_run(&[sliding(600.0, 0.3)], &laws())];
    let [twice, once] = [twice.unwrap(), once.unwrap()];
    near(twice.energy, once.energy, 1e-12);
    for (one, other) in twice.profile.wheel_energy.iter().zip(&once.profile.wheel_energy) {
        near(*one, *other, 1e-9);
    }
    near(twice.profile.rail_archard[7], once.profile.rail_archard[7], 1e-9);
}

#[test]
fn fatigue_counts_where_the_index_is_positive() {
    let state = sliding(100.0, 0.1);
    let index = SurfaceFatigue::default().index(&state);
    assert!(index > 0.0, "{index}");
    let free = State { tangential_force: 0.0, distance: 300.0, ..state };
    let fatigue = of_run(&[state, free], &laws()).unwrap().fatigue;
    near(fatigue.max, index, 1e-12);
    near(fatigue.share, 0.25, 1e-12);
    near(fatigue.mean_excess, 0.25 * index, 1e-12);
}

#[test]
fn what_is_no_run_is_refused() {
    let refused = |states: &[State], laws: &Laws| of_run(states, laws).unwrap_err().quantity();
    assert_eq!(refused(&[], &laws()), Quantity::Distance);
    let state = sliding(1.0, 0.1);
    assert_eq!(refused(&[State { speed: 0.0, ..state }], &laws()), Quantity::Speed);
    assert_eq!(refused(&[State { t_gamma: f64::NAN, ..state }], &laws()), Quantity::WearNumber);
    let soft = ArchardWear { hardness: -1.0, ..ArchardWear::default() };
    assert_eq!(refused(&[state], &Laws { archard: soft, ..laws() }), Quantity::WearHardness);
    let error: Error = of_run(&[State { distance: -1.0, ..state }], &laws()).unwrap_err();
    assert!(error.to_string().contains("distance"), "{error}");
}

/// Johnson 1985, §9.2: a line contact without traction stays elastic up to 3.33 k (Tresca) and
/// shakes down up to 4.00 k; from a friction of 0.37 on the surface decides, 1/μ, where the
/// surface-fatigue index is zero. The limits fall with friction.
#[test]
fn johnson_1985_shakedown_of_a_line_contact() {
    let free = ShakedownLimits::of(0.0, 0.3);
    near(free.elastic, 1.0 / 0.300, 0.005);
    near(free.shakedown, 4.0, 0.002);
    for friction in [0.37, 0.45, 0.8] {
        near(ShakedownLimits::of(friction, 0.3).shakedown, 1.0 / friction, 1e-3);
    }
    assert!(ShakedownLimits::of(0.3, 0.3).shakedown < 1.0 / 0.3);
    let all: Vec<ShakedownLimits> =
        (0..12).map(|k| ShakedownLimits::of(0.05 * f64::from(k), 0.3)).collect();
    assert!(all.iter().all(|limits| limits.elastic <= limits.shakedown * (1.0 + 1e-9)));
    assert!(all.windows(2).all(|pair| pair[1].shakedown <= pair[0].shakedown * (1.0 + 1e-9)));
    assert_eq!(ShakedownLimits::of(-0.2, 0.3), all[4]);
}

/// Burstow 2004: nothing up to 15 N, 10⁻⁵ at 65 N, nothing at 175 N, and wear beyond, at the slope
/// at which damage fell.
#[test]
fn burstow_2004_cracks_by_the_wear_number() {
    let cracks = CrackFunction::default();
    for (t_gamma, damage) in
        [(0.0, 0.0), (15.0, 0.0), (40.0, 0.5e-5), (65.0, 1e-5), (120.0, 0.5e-5), (285.0, -1e-5)]
    {
        assert!((cracks.of(t_gamma) - damage).abs() < 1e-15, "{t_gamma}");
    }
    assert_eq!(cracks.of(-3.0), 0.0);
    let rising = CrackFunction::new(vec![0.0, 15.0], vec![0.0, 1e-6]).unwrap();
    assert_eq!((rising.of(15.0), rising.of(200.0)), (1e-6, 1e-6));
    let refused = |t_gamma: &[f64], damage: &[f64]| {
        CrackFunction::new(t_gamma.to_vec(), damage.to_vec()).unwrap_err().quantity()
    };
    assert_eq!(refused(&[1.0], &[1.0]), Quantity::CrackWearNumber);
    assert_eq!(refused(&[1.0, 1.0], &[0.0, 1.0]), Quantity::CrackWearNumber);
    assert_eq!(refused(&[0.0, 1.0], &[0.0]), Quantity::CrackDamage);
    assert_eq!(refused(&[0.0, 1.0], &[0.0, f64::NAN]), Quantity::CrackDamage);
    // Half of the way at 40 N, half without wear number.
    let state = sliding(10.0, 0.1);
    let run = [State { t_gamma: 40.0, ..state }, State { t_gamma: 0.0, ..state }];
    let found = of_run(&run, &laws()).unwrap().cracks;
    near(found.max, 0.5e-5, 1e-12);
    near(found.mean, 0.25e-5, 1e-12);
}

/// A map has its coefficients from edge to edge, and what is none is refused.
#[test]
fn wear_maps_are_tables() {
    let map = WearMap::new(vec![0.0, 0.5], vec![0.0, 0.4], vec![1e-4, 2e-4, 3e-4, 4e-4]).unwrap();
    let of = |speed: f64, ratio: f64| map.coefficient(speed, ratio);
    assert_eq!(
        [of(0.0, 0.0), of(0.5, 0.39), of(0.49, 0.4), of(9.0, 9.0)],
        [1e-4, 2e-4, 3e-4, 4e-4]
    );
    let refused = |speeds: &[f64], ratios: &[f64], coefficients: &[f64]| {
        let map = WearMap::new(speeds.to_vec(), ratios.to_vec(), coefficients.to_vec());
        map.unwrap_err().quantity()
    };
    assert_eq!(refused(&[0.1], &[0.0], &[1e-4]), Quantity::LocalSlipSpeed);
    assert_eq!(refused(&[], &[0.0], &[]), Quantity::LocalSlipSpeed);
    assert_eq!(refused(&[0.0, 0.0], &[0.0], &[1e-4; 2]), Quantity::LocalSlipSpeed);
    assert_eq!(refused(&[0.0], &[0.0, f64::NAN], &[1e-4; 2]), Quantity::PressureRatio);
    assert_eq!(refused(&[0.0], &[0.0], &[1e-4; 2]), Quantity::WearCoefficient);
    assert_eq!(refused(&[0.0], &[0.0], &[-1e-4]), Quantity::WearCoefficient);
}

/// The passage of a contact in Coulomb's full sliding at ξ: slip speed s = |ξ| v0 all over, so
/// Archard's depth is k s/(H v0) times the load of each strip, 3N/(4b) (1 − (y/b)²), and the mild
/// law of energy wears 5.3 µg/J.
#[test]
fn a_sliding_passage_has_closed_forms() {
    let (a, b, friction, creepage) = (6e-3, 4e-3, 0.3, 0.01);
    let problem = Problem::builder().creepage_x(creepage).build().unwrap();
    let contact = Ellipse::from_peak_pressure(a, b, 0.9e9).unwrap();
    let mut problem = Problem { normal: Arc::new(contact), ..problem }
        .with_interface(|interface| interface.heat = Heat::none());
    problem.interface.contact_law = ContactLaw::Coulomb;
    problem.interface.friction.law = Arc::new(Constant::new(friction).unwrap());
    let steel = Material::STEEL;
    problem.interface.elasticity = Arc::new(HalfSpace::new(&steel, &steel).unwrap());
    let options = Options { cells_x: 24, cells_y: 24, ..Options::default() };
    let solution = solver::solve(&problem, &options, &unwatched).unwrap();
    let passage = of_passage(&problem, &solution, &laws()).unwrap();
    let (load, speed) = (solution.normal.load, solution.kinematics.speed);
    let slip_speed = creepage * speed;
    let wear = passage.wear.as_ref().unwrap();
    // Elastic slip is a part of the slip of some per cent, whose sum over a strip vanishes.
    let volume = 35e-4 * load * slip_speed / (2.7e9 * speed);
    near(wear.archard_volume, volume, 0.01);
    near(wear.energy_per_distance, solution.power.unwrap().friction / speed, 1e-12);
    near(wear.energy_mass, 5.3e-9 * wear.energy_per_distance, 1e-9);
    let profile = &wear.profile;
    let width = profile.y[1] - profile.y[0];
    near(profile.archard.iter().sum::<f64>() * width, wear.archard_volume, 1e-12);
    near(7800.0 * profile.rail_energy.iter().sum::<f64>() * width, wear.energy_mass, 1e-12);
    near(7850.0 * profile.wheel_energy.iter().sum::<f64>() * width, wear.energy_mass, 1e-12);
    for (y, depth) in profile.y.iter().zip(&profile.archard) {
        let (u, w) = (y / b, width / b);
        let expected = volume * 0.75 / b * (1.0 - u * u - w * w / 12.0);
        assert!((depth - expected).abs() < 0.02 * volume / b, "{y}: {depth} {expected}");
    }
    let k = 300e6;
    assert!((passage.fatigue_index - (friction - k / 0.9e9)).abs() < 1e-4 * friction);
    near(passage.shakedown.load_factor, 3.0, 1e-9);
    near(passage.shakedown.traction_coefficient, friction, 1e-4);
    assert_eq!(passage.melting, None);
    near(passage.t_gamma.without_spin, creepage * friction * load, 1e-4);
    near(passage.crack_damage, CrackFunction::default().of(passage.t_gamma.without_spin), 1e-12);
}

/// Wear per distance along the rail, but for the elastic part of the slip.
#[test]
fn the_reference_of_creepages_does_not_change_wear() {
    let problem = Problem::builder().build().unwrap();
    let mut problem = problem.with_interface(|interface| interface.heat = Heat::none());
    problem.interface.contact_law = ContactLaw::Coulomb;
    let steel = Material::STEEL;
    problem.interface.elasticity = Arc::new(HalfSpace::new(&steel, &steel).unwrap());
    let options = Options { cells_x: 16, cells_y: 16, ..Options::default() };
    let [by_vehicle, by_mean] = motions([30.0, 10.0]).map(|kinematics| {
        problem.kinematics = kinematics;
        let solution = solver::solve(&problem, &options, &unwatched).unwrap();
        of_passage(&problem, &solution, &laws()).unwrap().wear.unwrap()
    });
    near(by_mean.energy_per_distance, by_vehicle.energy_per_distance, 1e-4);
    near(by_mean.energy_mass, by_vehicle.energy_mass, 1e-4);
    near(by_mean.archard_volume, by_vehicle.archard_volume, 1e-4);
}

/// The pressure of FASTSIM's paraboloid bounds the traction only: the body is worn by that of the
/// normal contact, as with the ellipsoid.
#[test]
fn what_bounds_the_traction_of_fastsim_is_not_the_pressure() {
    let problem = Problem::builder().creepage_x(0.012).build().unwrap();
    let problem = problem.with_interface(|interface| interface.heat = Heat::none());
    let options = Options { cells_x: 20, cells_y: 20, ..Options::default() };
    let wear = [TractionBound::Parabolic, TractionBound::Elliptic].map(|bound| {
        let brush = Brush { bound, ..Brush::KALKER };
        let method = Method::Fast(FastMethod::Fastsim(brush));
        let solution = method.solver(&options).solve(&problem, &unwatched).unwrap();
        of_passage(&problem, &solution, &laws()).unwrap().wear.unwrap()
    });
    assert_eq!(wear[0].cells.pressure, wear[1].cells.pressure);
    near(wear[0].archard_volume, wear[1].archard_volume, 0.02);
}

/// Two parts of a patch, with the gap between them: the index is that of the largest pressure, as
/// in the shakedown map.
#[test]
fn several_parts_have_the_index_of_the_largest_pressure() {
    let state = State { semi_axis_x: 6e-3, semi_axis_y: 14e-3, ..sliding(1.0, 0.1) };
    let fatigue = SurfaceFatigue { shear_yield_stress: 300e6 };
    near(fatigue.index(&state), 0.4 - 300e6 / state.peak_pressure, 1e-12);
}

/// Cells are hotter than a limit where their temperatures say so; a method without fields has
/// neither wear nor melting, and the rest as well.
#[test]
fn what_is_hotter_than_the_limit_melts() {
    let problem = Problem::builder().creepage_x(0.05).build().unwrap();
    let options = Options { cells_x: 16, cells_y: 16, ..Options::default() };
    let solution = solver::solve(&problem, &options, &unwatched).unwrap();
    let hottest = solution.temperature.unwrap();
    let at = |melting_temperature: f64| {
        let laws = Laws { melting_temperature, ..laws() };
        of_passage(&problem, &solution, &laws).unwrap().melting.unwrap()
    };
    let cold = at(5000.0);
    assert_eq!((cold.wheel_area, cold.rail_area, cold.share), (0.0, 0.0, 0.0));
    near(cold.max_temperature, hottest.max_wheel.max(hottest.max_rail), 1e-12);
    let all = at(-10.0);
    near(all.share, 1.0, 1e-12);
    near(all.wheel_area, solution.area.contact, 1e-9);
    let middle = at(0.5 * (cold.max_temperature + 20.0));
    assert!((0.01..0.99).contains(&middle.share), "{middle:?}");
    let fast = Method::Fast(FastMethod::KalkerLinear);
    let solution = fast.solver(&options).solve(&problem, &unwatched).unwrap();
    let passage = of_passage(&problem, &solution, &laws()).unwrap();
    assert_eq!((passage.wear, passage.melting), (None, None));
    assert!(passage.shakedown.load_factor > 1.0);
}

/// On the surface of a sliding line contact, with A = √(1 − x²) and B = 2μx of p0 (Johnson 1985,
/// §7.1): σxx = −A − B, σzz = −A, σyy = ν (σxx + σzz), σxz = μA. From μ = 0.3 on it yields there
/// first, by Tresca's criterion on the planes of any two of the principal stresses.
#[test]
fn johnson_1985_first_yield_on_the_surface() {
    const POINTS: i32 = 4000;
    for (friction, nu) in [(0.3, 0.28), (0.5, 0.28), (0.5, 0.3)] {
        let shear = |k: i32| {
            let x = f64::from(k) / f64::from(POINTS);
            let (a, b) = ((1.0 - x * x).sqrt(), 2.0 * friction * x);
            let [xx, zz, xz] = [-a - b, -a, friction * a];
            let root = ((xx - zz).powi(2) + 4.0 * xz * xz).sqrt();
            let mut principal = [0.5 * (xx + zz + root), nu * (xx + zz), 0.5 * (xx + zz - root)];
            principal.sort_by(f64::total_cmp);
            0.5 * (principal[2] - principal[0])
        };
        let largest = (-POINTS..=POINTS).map(shear).fold(0.0, f64::max);
        let found = ShakedownLimits::of(friction, nu).elastic;
        near(found, largest.recip(), 0.01);
    }
}
