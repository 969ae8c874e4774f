//! Series of shifts: bodies at rest whose load, displacement, turn or forces change in steps.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::{cells, problem, rolling};
use approx::assert_relative_eq;
use schlupf::bodies::Material;
use schlupf::elasticity::HalfSpace;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::normal::{Ellipse, Hertz, Radii};
use schlupf::problem::History;
use schlupf::solver::march;
use schlupf::solver::reference::CattaneoMindlin;
use schlupf::{Problem, Solution, Status, Transient, unwatched};

const RADIUS: f64 = 5e-3;
const LOAD: f64 = 50e3;
const FRICTION: f64 = 0.3;
const MATERIAL: Material = Material { poisson_ratio: 0.0, ..Material::STEEL };

fn exact() -> CattaneoMindlin {
    CattaneoMindlin {
        radius: RADIUS,
        load: LOAD,
        friction_coefficient: FRICTION,
        shear_modulus: MATERIAL.shear_modulus(),
        poisson_ratio: MATERIAL.poisson_ratio,
    }
}

/// Two spheres with ν = 0, where Cattaneo's solution is exact, and Coulomb's law.
fn spheres() -> Problem {
    let mut spheres = problem(rolling(0.0, 0.0, 0.0));
    spheres.normal = Arc::new(Ellipse::from_load(RADIUS, RADIUS, LOAD).unwrap());
    spheres.interface.elasticity = Arc::new(HalfSpace::new(&MATERIAL, &MATERIAL).unwrap());
    spheres.interface.contact_law = ContactLaw::Coulomb;
    spheres.interface.friction.law = Arc::new(Constant::new(FRICTION).unwrap());
    spheres
}

/// The end of a history at rest.
fn after(problem: &Problem, history: History, cells_across: usize) -> Solution {
    let transient = Transient { history, ..Transient::to_steady_state(problem) };
    let options = cells(cells_across);
    let solution = march(&transient, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    let steps = solution.history.len();
    assert!(solution.work.newton_iterations <= 30 * steps, "{:?}", solution.work);
    solution
}

fn at_rest(steps: usize) -> History {
    History { time: vec![0.0; steps], ..History::default() }
}

/// Mindlin and Deresiewicz 1953 (Johnson 1985, §7.4): after loading to δ₀ the force falls as twice
/// that of half the way back, T(δ) = T(δ₀) − 2 T((δ₀ − δ)/2), and reloading closes the loop; within
/// 0.2 % of μN.
#[test]
fn mindlin_deresiewicz_1953_unloading() {
    let (exact, full) = (exact(), exact().full_sliding_shift());
    let steps = [0.8, -0.3, -0.6, -0.7, 0.8, 0.8];
    let shift_x = Some(steps.map(|step| step * full).to_vec());
    let found = after(&spheres(), History { shift_x, ..at_rest(6) }, 40).history;
    let force = |share: f64| exact.force_over_limit(share * full);
    let down = |way: f64| force(0.8) - 2.0 * force(way / 2.0);
    let expected = [force(0.8), down(0.3), down(0.9), down(1.6), -down(0.8), force(0.8)];
    for (instant, expected) in found.iter().zip(expected) {
        let normalised = -instant.force.x / (FRICTION * LOAD);
        assert_relative_eq!(normalised, expected, epsilon = 2e-3);
        assert_eq!((instant.time, instant.distance, instant.kinematics.speed), (0.0, 0.0, 0.0));
    }
}

/// Forces in place of shifts, along one axis or both: the shift is that of Mindlin 1949 within
/// 0.5 % of the one at full sliding.
#[test]
fn mindlin_1949_forces_in_place_of_shifts() {
    let (exact, full) = (exact(), exact().full_sliding_shift());
    let forces = [-0.3, -0.6, -0.9, -0.5].map(|share| share * FRICTION * LOAD).to_vec();
    let way = |share: f64| exact.shift(share) / full;
    let total = [way(0.3), way(0.6), way(0.9), way(0.9) - 2.0 * way(0.2)];
    let history =
        History { force_x: Some(forces.clone()), shift_y: Some(vec![0.0; 4]), ..at_rest(4) };
    let along = after(&spheres(), history, 40).history;
    let [x, y] = [0.6, -0.8].map(|part| Some(forces.iter().map(|f| part * f).collect()));
    let history = History { force_x: x, force_y: y, turn: Some(vec![0.0; 4]), ..at_rest(4) };
    let oblique = after(&spheres(), history, 40).history;
    let mut sums = [[0.0; 2]; 2];
    for (k, expected) in total.into_iter().enumerate() {
        for (sum, instant) in sums.iter_mut().zip([&along[k], &oblique[k]]) {
            let [x, y, turn] = instant.shift.unwrap();
            assert!(turn.abs() < 1e-9);
            (sum[0], sum[1]) = (sum[0] + x / full, sum[1] + y / full);
        }
        assert_relative_eq!(sums[0][0], expected, epsilon = 5e-3);
        assert_relative_eq!(sums[1][0], 0.6 * expected, epsilon = 5e-3);
        assert_relative_eq!(sums[1][1], -0.8 * expected, epsilon = 5e-3);
        assert_relative_eq!(along[k].force.x, forces[k], max_relative = 1e-5);
    }
}

/// Complete elliptic integrals K and E of a modulus, by the arithmetic-geometric mean.
fn elliptic(modulus: f64) -> [f64; 2] {
    let (mut a, mut b, mut c) = (1.0_f64, (1.0 - modulus * modulus).sqrt(), modulus);
    let (mut sum, mut weight) = (0.5 * c * c, 0.5);
    while c.abs() > 1e-15 {
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        weight *= 2.0;
        sum += weight * c * c;
    }
    let first = PI / (2.0 * a);
    [first, first * (1.0 - sum)]
}

/// Twist of one sphere β (in rad) and moment (in N m) at a stick radius c (in m): Lubkin 1951, β =
/// 3μN/(4πGa²) (K − E) with the modulus √(1 − c²/a²), and the moments (16/3) G r³ dβ of the twists
/// added at stick radii r.
fn lubkin(stick: f64) -> [f64; 2] {
    let modulus = MATERIAL.shear_modulus();
    let twist = |r: f64| {
        let [first, second] = elliptic((1.0 - (r / RADIUS).powi(2)).max(0.0).sqrt());
        0.75 * FRICTION * LOAD / (PI * modulus * RADIUS.powi(2)) * (first - second)
    };
    let count = 4000;
    let width = (RADIUS - stick) / f64::from(count);
    let middles = (0..count).map(|k| stick + (f64::from(k) + 0.5) * width);
    let inner: f64 = middles.map(|r| 3.0 * r * r * twist(r) * width).sum();
    [twist(stick), 16.0 / 3.0 * modulus * (stick.powi(3) * twist(stick) + inner)]
}

/// A turn of two spheres: M = (16/3) G a³ β without slip, each turning by β (Reissner and Sagoci
/// 1944), and with slip as Lubkin 1951 has it: by turn within 0.5 %, by moment within 1 %.
#[test]
fn lubkin_1951_turn() {
    let modulus = MATERIAL.shear_modulus();
    // Nearly no slip.
    let [twist, moment] = lubkin(0.999 * RADIUS);
    assert_relative_eq!(moment, 16.0 / 3.0 * modulus * RADIUS.powi(3) * twist, max_relative = 2e-3);
    for share in [0.9, 0.7, 0.5, 0.3] {
        let [twist, moment] = lubkin(share * RADIUS);
        let turned =
            after(&spheres(), History { turn: Some(vec![-2.0 * twist]), ..at_rest(1) }, 40);
        let found = turned.force.moment_z.unwrap();
        let history =
            History { moment_z: Some(vec![moment]), shift_x: Some(vec![0.0]), ..at_rest(1) };
        let [_, _, turn] = after(&spheres(), history, 40).history[0].shift.unwrap();
        assert_relative_eq!(found, moment, max_relative = 5e-3);
        assert_relative_eq!(turn, -2.0 * twist, max_relative = 1e-2);
    }
}

/// Mindlin and Deresiewicz 1953, oblique loading: where the force grows by less than μ times the
/// load nothing slips, and T = ∫ K dδ with K ∝ a; in 16 steps within
/// 0.2 %.
#[test]
fn mindlin_deresiewicz_1953_oblique_loading() {
    let count = 16;
    let loads: Vec<f64> =
        (0..=count).map(|k| LOAD * (1.0 + 2.0 / f64::from(count) * f64::from(k))).collect();
    // δ grows with the square root of the load, T with its 5/6th power.
    let full = exact().full_sliding_shift();
    let by = |load: f64| 0.4 * full * (load / LOAD).sqrt();
    let stiffness = FRICTION * LOAD * 1.5 / full;
    let steps = loads.windows(2).map(|pair| by(pair[1]) - by(pair[0]));
    let shift_x = Some(std::iter::once(0.0).chain(steps).collect());
    let history = History { load: Some(loads), shift_x, ..at_rest(17) };
    let mut growing = spheres();
    let modulus = MATERIAL.shear_modulus() / (1.0 - MATERIAL.poisson_ratio);
    let crown = 4.0 / 3.0 * modulus * RADIUS.powi(3) / LOAD;
    let (wheel, rail) = (Radii::along(crown), Radii::across(crown));
    growing.normal = Arc::new(Hertz::new(wheel, rail, modulus, LOAD).unwrap());
    let found = after(&growing, history, 40);
    let expected = stiffness * 0.4 * full * 0.5 / (5.0 / 6.0) * (3.0_f64.powf(5.0 / 6.0) - 1.0);
    assert_relative_eq!(found.force.x, -expected, max_relative = 2e-3);
    assert_eq!(found.area.slip, Some(0.0));
}
