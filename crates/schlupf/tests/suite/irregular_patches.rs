//! Coulomb's law on patches whose edge is not an ellipse: of wheels on rails, and of tables that
//! are coarse, angular and noisy. The steady state is found directly, with no more products than
//! under an elliptic pressure.

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

use crate::common::{Random, cells, half_space, problem, quantiles, rolling};
use schlupf::bodies::Kinematics;
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::normal::{PressureTable, Tabulated};
use schlupf::solution::Strategy;
use schlupf::wheel_rail::{
    Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve, RailShape,
    RowsMove, Side, Sides, Support, Tangential, Track, WheelOnRail, WheelShape,
};
use schlupf::{Error, Options, Problem, Quantity, Solution, unwatched};

fn is_marched(solution: &Solution) -> bool {
    solution.work.strategy == Some(Strategy::March)
}

fn assert_few(products: [f64; 3]) {
    let is_few = products.iter().zip([30.0, 40.0, 50.0]).all(|(found, most)| *found <= most);
    assert!(is_few, "{products:?}");
}

/// S1002 on 60E1 with a cant of 1:40.
fn wheel_and_rail() -> Arc<Pair> {
    let points = |name: &str| -> Vec<[f64; 2]> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
        let number = |text: &str| 1e-3 * text.parse::<f64>().unwrap();
        reader.records().flatten().map(|row| [number(&row[0]), -number(&row[1])]).collect()
    };
    let curve = |name, quantity| ProfileCurve::new(&points(name), 0.0, quantity).unwrap();
    let wheel = WheelShape {
        profile: curve("profile_s1002.csv", Quantity::WheelProfile).into(),
        nominal_radius: 0.46,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let profile = curve("profile_uic60_canted.csv", Quantity::RailProfile);
    let rail = RailShape::new(profile, 0.0);
    Arc::new(Pair::new(&wheel, &rail, &Track { gauge: 1.435, ..Track::default() }).unwrap())
}

/// Wheels that brake and drive, on grids of which the rows at the edge of the patch are covered in
/// part: no contact is marched, and products are what they are under an elliptic pressure.
#[test]
fn contacts_of_wheels_on_rails_are_found_directly() {
    let pair = wheel_and_rail();
    let mut random = Random(1);
    let mut products = Vec::new();
    for _ in 0..24 {
        let across = random.between(36.0, 66.0) as usize;
        let lateral = random.between(-4e-3, 4e-3);
        let wheel = WheelOnRail {
            pairs: Sides::both(Arc::clone(&pair)),
            side: Side::Left,
            position: Position { lateral, yaw: 0.0, roll: 0.0 },
            motion: Motion::straight(20.0, random.between(43.35, 43.5)),
            follows: false,
            drive: Drive::AngularVelocity,
            support: Support::Force([40e3, 80e3, 120e3][random.between(0.0, 3.0) as usize]),
            joining: Joining::default(),
            rows: RowsMove::default(),
            friction_variation: None,
            normal_method: NormalMethod::HalfSpaces,
            cells: across,
        };
        let options = cells(across);
        let interface = coulomb(problem(Kinematics::free_rolling(1.0))).interface;
        let tangential = Tangential::new(&interface, &options);
        let found = wheel.solve(&tangential, &unwatched).unwrap();
        for contact in &found.contacts {
            assert!(!is_marched(&contact.solution), "{across} cells, {:?}", wheel.motion);
            products.push(contact.solution.work.operator_products);
        }
    }
    let found = quantiles(products);
    println!("wheels on rails: products {found:.1?}");
    assert_few(found);
}

fn coulomb(given: Problem) -> Problem {
    let mut problem = given.with_interface(|interface| interface.elasticity = half_space());
    problem.interface.contact_law = ContactLaw::Coulomb;
    problem.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    problem
}

/// A pressure under 60 kN on a patch between a rhombus and a rectangle, leaning to one side, on a
/// lattice as coarse or fine as it comes, each sample off by up to a part.
fn table(random: &mut Random, noise: f64) -> Tabulated {
    let [a, b] = [0, 1].map(|_| random.between(2e-3, 8e-3));
    let [columns, rows] = [0, 1].map(|_| random.between(15.0, 60.0) as usize);
    let power = random.between(1.5, 5.0);
    let axis = |half: f64, count: usize| -> Vec<f64> {
        (0..count).map(|k| 1.15 * half * (2.0 * k as f64 / (count - 1) as f64 - 1.0)).collect()
    };
    let (x, y) = (axis(a, columns), axis(b, rows));
    let mut pressure = Vec::new();
    for y in &y {
        for x in &x {
            let (s, t) = (x / a, y / b);
            let rest = 1.0 - s.abs().powf(power) - t.abs().powf(power) * (1.0 + 0.4 * s);
            let off = 1.0 + noise * random.between(-1.0, 1.0);
            pressure.push(8e8 * rest.max(0.0).sqrt() * off);
        }
    }
    Tabulated::new(PressureTable::new(&x, &y, pressure).unwrap(), Some(60e3)).unwrap()
}

/// Tables without noise, and with 3 % of it. With 20 % some are found only from faster motions.
#[test]
fn coarse_angular_and_noisy_tables_are_solved_directly() {
    for noise in [0.0, 0.03, 0.2] {
        let mut random = Random(7);
        let mut products = Vec::new();
        for number in 0..40 {
            let normal = Arc::new(table(&mut random, noise));
            let size = 10_f64.powf(random.between(-3.5, -2.2));
            let (sin, cos) = random.between(0.0, TAU).sin_cos();
            let spin = [0.0, 90.0 * size, -300.0 * size][number % 3];
            let motion = rolling(size * cos, size * sin, spin);
            let across = random.between(16.0, 70.0) as usize;
            let problem = Problem { normal, ..coulomb(problem(motion)) };
            let options = cells(across);
            let solution = schlupf::solver::solve(&problem, &options, &unwatched).unwrap();
            assert!(!is_marched(&solution), "noise {noise}, table {number}, {across} cells");
            products.push(solution.work.operator_products);
        }
        let found = quantiles(products);
        println!("tables with a noise of {noise}: products {found:.1?}");
        if noise < 0.1 {
            assert_few(found);
        } else {
            assert!(found[0] <= 30.0 && found[1] <= 50.0 && found[2] <= 2000.0, "{found:?}");
        }
    }
}

/// Circles of a radius of 1 mm at some places along y (in m), 1 GPa under each, on a lattice.
fn circles(at: &[f64], farthest: f64, spacing: f64) -> Tabulated {
    let axis = |farthest: f64| -> Vec<f64> {
        let count = (farthest / spacing).round() as i32;
        (-count..=count).map(|k| f64::from(k) * spacing).collect()
    };
    let (x, y) = (axis(1.2e-3), axis(farthest));
    let under = |x: f64, y: f64| (1.0 - (x * x + y * y) * 1e6).max(0.0).sqrt();
    let sum = |x: f64, y: f64| at.iter().map(|at| under(x, y - at)).sum::<f64>();
    let pressure: Vec<_> =
        y.iter().flat_map(|y| x.iter().map(move |x| 1e9 * sum(*x, *y))).collect();
    let load = at.len() as f64 * 2e3;
    Tabulated::new(PressureTable::new(&x, &y, pressure).unwrap(), Some(load)).unwrap()
}

/// Two circles far apart, twenty samples across each: some motions are found only along those from
/// high slip, by ten times the work. Each circle has the force of one alone.
#[test]
fn a_state_that_is_not_found_is_approached_from_faster_motions() {
    let solve = |normal: Tabulated, creepage: f64, options: &Options| {
        let motion = rolling(creepage, creepage, 0.0);
        let problem = Problem { normal: Arc::new(normal), ..coulomb(problem(motion)) };
        let solution = schlupf::solver::solve(&problem, options, &unwatched).unwrap();
        assert!(!is_marched(&solution), "{creepage}");
        solution
    };
    let mut products = [Vec::new(), Vec::new()];
    for k in 0..12 {
        let creepage = 1e-5 * f64::from(20 + 2 * k);
        let on = Options { cells_x: 36, cells_y: 90, ..Options::default() };
        let two = solve(circles(&[-8e-3, 8e-3], 9.2e-3, 1e-4), creepage, &on);
        let one = solve(circles(&[0.0], 1.2e-3, 1e-4), creepage, &cells(36));
        let gap = (two.normalised.x - one.normalised.x).abs();
        assert!(gap < 2e-3, "{creepage}: {gap}");
        let followed = two.work.strategy == Some(Strategy::Continuation);
        products[usize::from(followed)].push(two.work.operator_products);
    }
    let [cold, followed] = products;
    println!("{cold:.0?} {followed:.0?}");
    assert!(followed.len() <= 6 && followed.iter().all(|of| *of < 800.0), "{followed:?}");
    let [median, _, largest] = quantiles(cold);
    assert!(median < 100.0 && largest < 200.0, "{median} {largest}");
}

/// Cells that are too wide are those of each part: two circles on rows that would be many on one
/// patch of their width, but are three on each.
#[test]
fn each_part_needs_its_cells_across() {
    let normal = Arc::new(circles(&[-8e-3, 8e-3], 9.2e-3, 2.5e-5));
    let problem = Problem { normal, ..coulomb(problem(rolling(1e-3, 1e-3, 0.0))) };
    let on = |cells_y| Options { cells_x: 40, cells_y, ..Options::default() };
    let solve = |cells_y| schlupf::solver::solve(&problem, &on(cells_y), &unwatched);
    let refused = solve(27).unwrap_err();
    let Error::TooFewAcross { fewest, columns: 40, count: 27 } = refused else {
        panic!("{refused:?}")
    };
    let products = solve(fewest).unwrap().work.operator_products;
    assert!(products < 100.0, "{fewest}: {products}");
}
