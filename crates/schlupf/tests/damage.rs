//! Damage over a run, against closed forms and values of the literature.

use std::f64::consts::{PI, TAU};

use schlupf::damage::{ArchardWear, EnergyWear, Laws, Profile, State, SurfaceFatigue, of_run};
use schlupf::{Error, Quantity};

const RADIUS: f64 = 0.46;

fn laws() -> Laws {
    Laws {
        fatigue: SurfaceFatigue::default(),
        archard: ArchardWear::default(),
        energy: EnergyWear::default(),
        wheel_radius: RADIUS,
        densities: [7850.0, 7800.0],
    }
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
        .map(|k| State { position_y: 1.7e-3 * f64::from(k * k % 5), ..sliding(100.0, 0.05) })
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
