//! Rolling with Coulomb's law itself on the half-space: work and accuracy.

use std::path::Path;
use std::sync::Arc;

use crate::common::{cells, half_space, problem, quantiles, rolling};
use schlupf::interface::friction::Constant;
use schlupf::interface::{ContactLaw, Incremental};
use schlupf::normal::Ellipse;
use schlupf::solution::Resultant;
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solution, Solver, Status, Warning, unwatched};

/// One line of `data/contact_creep.csv`.
struct Reference {
    semi_axes: [f64; 2],
    creepage: [f64; 3],
    force: [f64; 3],
    uncertain: f64,
}

fn references() -> Vec<Reference> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/contact_creep.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let line = |record: csv::StringRecord| {
        let n: Vec<f64> = record.iter().skip(2).map(|field| field.parse().unwrap()).collect();
        Reference {
            semi_axes: [n[0], n[1]],
            creepage: [n[2], n[3], n[4]],
            force: [n[5], n[6], n[7]],
            uncertain: n[8],
        }
    };
    reader.records().map(|record| line(record.unwrap())).collect()
}

/// Semi-axes (in m) with √(ab) = 5 mm.
fn semi_axes(ratio: f64) -> [f64; 2] {
    const MEAN: f64 = 5e-3;
    [MEAN * ratio.sqrt(), MEAN / ratio.sqrt()]
}

/// Creepages and spin (in 1/m), single and combined, from nearly all stick to all slip.
fn motions() -> Vec<[f64; 3]> {
    let sizes = [0.0002, 0.0006, 0.0012, 0.002, 0.003, 0.006, 0.02];
    let directions = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 600.0],
        [0.7, 0.7, 0.0],
        [0.7, -0.5, 200.0],
        [0.0, 1.0, 400.0],
        [0.0, -1.0, 400.0],
        [1.0, 0.0, -200.0],
    ];
    let of_size = |size: f64| directions.map(|direction| direction.map(|part| size * part));
    sizes.into_iter().flat_map(of_size).collect()
}

/// The contact of the validation data, 52.36 kN and μ = 0.3 between steel bodies.
fn coulomb([a, b]: [f64; 2], [xi, eta, spin]: [f64; 3]) -> Problem {
    let mut problem = problem(rolling(xi, eta, spin));
    problem.normal = Arc::new(Ellipse::from_load(a, b, 52_359.878).unwrap());
    problem.interface.elasticity = half_space();
    problem.interface.contact_law = ContactLaw::Coulomb;
    problem.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    problem
}

fn solve(problem: &Problem, across: usize) -> Solution {
    schlupf::solver::solve(problem, &cells(across), &unwatched).unwrap()
}

/// Errors of all forces (in % of μN and μN √(ab)) beyond what is uncertain of the reference, and
/// products: median, 90 % and largest of each.
fn compare(across: usize) -> [[f64; 3]; 2] {
    let (mut errors, mut products) = (Vec::new(), Vec::new());
    for reference in references() {
        let solution = solve(&coulomb(reference.semi_axes, reference.creepage), across);
        assert_eq!(solution.status, Status::Converged, "{:?}", reference.creepage);
        let force = solution.normalised;
        let got = [force.x, force.y, force.moment_z.unwrap()];
        let gaps: Vec<f64> =
            got.iter().zip(reference.force).map(|(got, known)| (got - known).abs()).collect();
        let error = gaps[0].hypot(gaps[1]).max(gaps[2]) - reference.uncertain;
        errors.push(100.0 * error.max(0.0));
        products.push(solution.work.operator_products);
    }
    let found = [quantiles(errors), quantiles(products)];
    println!("{across} cells: errors in % {:.3?}, products {:.1?}", found[0], found[1]);
    found
}

fn assert_below(found: [f64; 3], allowed: [f64; 3]) {
    let is_below = found.iter().zip(allowed).all(|(found, allowed)| *found <= allowed);
    assert!(is_below, "{found:?} exceeds {allowed:?}");
}

/// Vollebregt 2022 (CONTACT, extrapolated over grids): all 178 cases on 10 cells across within 1 %
/// for 90 %.
#[test]
fn vollebregt_2022_creep_forces_on_10_cells() {
    let [errors, _] = compare(10);
    assert_below(errors, [0.5, 1.0, 2.0]);
}

/// The same on 20 cells: 0.15 % in the median, 0.3 % for 90 %, 0.8 % at most; with 40 products for
/// 90 % and 50 at most.
#[test]
fn vollebregt_2022_creep_forces_on_20_cells() {
    let [errors, products] = compare(20);
    assert_below(errors, [0.15, 0.3, 0.8]);
    assert_below(products, [30.0, 40.0, 50.0]);
}

/// Extrapolated from 10 and 20 cells, and from 20 and 40: errors are less than half of those on
/// the finer grid, in the median and for 90 %. The size of the estimated error of the finer grid is
/// right to half of it in the median and never off by more than the error itself, as far as the
/// reference can tell.
#[test]
fn vollebregt_2022_extrapolated_creep_forces() {
    for (across, allowed) in [(20, [0.03, 0.09, 0.39]), (40, [0.01, 0.04, 0.11])] {
        let (mut errors, mut products) = (Vec::new(), Vec::new());
        let (mut plainly, mut missed) = (Vec::new(), Vec::new());
        for reference in references() {
            let problem = coulomb(reference.semi_axes, reference.creepage);
            let options = Options { extrapolate: true, ..cells(across) };
            let solution = schlupf::solver::solve(&problem, &options, &unwatched).unwrap();
            let found = solution.extrapolation.unwrap();
            let plain = solve(&problem, across).normalised;
            let [x, y, moment] = reference.force;
            let gap = |force: Resultant| {
                let aside = (force.moment_z.unwrap() - moment).abs();
                (force.x - x).hypot(force.y - y).max(aside)
            };
            errors.push(100.0 * (gap(found.normalised) - reference.uncertain).max(0.0));
            plainly.push(100.0 * (gap(plain) - reference.uncertain).max(0.0));
            let limit = 0.3 * 52_359.878;
            let (known, estimated) =
                ((plain.x - x).hypot(plain.y - y), found.error.x.hypot(found.error.y) / limit);
            if known > 5.0 * reference.uncertain && known > 2e-4 {
                missed.push((estimated / known - 1.0).abs());
            }
            products.push(solution.work.operator_products);
        }
        assert!(missed.len() > 5, "{}", missed.len());
        println!("{} estimates", missed.len());
        let found = [errors, plainly, missed, products].map(quantiles);
        println!("{across} cells extrapolated: {found:.3?}");
        assert_below(found[0], allowed);
        assert!(found[0][0] <= 0.5 * found[1][0] && found[0][1] <= 0.5 * found[1][1]);
        assert_below(found[2], [0.5, 1.0, 1.0]);
        assert_below(found[3], [30.0, 40.0, 50.0]);
    }
    let few = Options { extrapolate: true, ..cells(12) };
    let problem = coulomb(semi_axes(1.0), [1e-3, 0.0, 0.0]);
    let alone = schlupf::solver::solve(&problem, &few, &unwatched).unwrap();
    assert_eq!(alone.extrapolation, None);
    assert!(alone.warnings.contains(&Warning::NoExtrapolation {}), "{:?}", alone.warnings);
}

/// The same on 40 cells: 0.05 %, 0.1 % and 0.3 %.
#[test]
fn vollebregt_2022_creep_forces_on_40_cells() {
    let [errors, products] = compare(40);
    assert_below(errors, [0.05, 0.1, 0.3]);
    assert_below(products, [30.0, 40.0, 50.0]);
}

/// Forces on few cells against those on 160, for long and for wide patches. The largest errors are
/// those under spin at a/b = 5, where cells are five times as long as wide.
#[test]
#[ignore = "long: cargo xtask long"]
fn slender_patches_converge_as_fast() {
    let (mut on_20, mut on_40) = (Vec::new(), Vec::new());
    for ratio in [0.2, 2.0, 5.0] {
        for motion in motions() {
            let problem = coulomb(semi_axes(ratio), motion);
            let fine = solve(&problem, 160).normalised;
            for (across, errors) in [(20, &mut on_20), (40, &mut on_40)] {
                let force = solve(&problem, across).normalised;
                let moments = [force, fine].map(|force| force.moment_z.unwrap());
                let gap = (force.x - fine.x).hypot(force.y - fine.y);
                errors.push(100.0 * gap.max((moments[0] - moments[1]).abs()));
            }
        }
    }
    let found = [on_20, on_40].map(quantiles);
    println!("errors in % of slender patches: {found:.3?}");
    assert_below(found[0], [0.15, 0.5, 1.0]);
    assert_below(found[1], [0.03, 0.15, 0.3]);
}

/// Products of a cold solution hardly depend on the grid.
#[test]
#[ignore = "long: cargo xtask long"]
fn cold_work_does_not_grow_with_the_grid() {
    for (across, step) in [(20, 1), (40, 1), (80, 5), (160, 11)] {
        let mut products = Vec::new();
        for ratio in [0.2, 0.5, 1.0, 2.0, 5.0] {
            for motion in motions().into_iter().step_by(step) {
                let solution = solve(&coulomb(semi_axes(ratio), motion), across);
                assert_eq!(solution.status, Status::Converged, "{ratio} {motion:?}");
                products.push(solution.work.operator_products);
            }
        }
        let found = quantiles(products);
        println!("{across} cells: products {found:.1?}");
        assert_below(found, [30.0, 40.0, 50.0]);
    }
}

/// Bristles from k_c = 10⁷/m to 10¹⁰/m take no more than twice as many products as the limit may,
/// on any grid.
#[test]
#[ignore = "long: cargo xtask long"]
fn stiff_bristles_take_no_more_work() {
    for (across, step) in [(20, 1), (40, 5), (80, 13)] {
        for stiffness in [1e7, 3e7, 1e8, 1e9, 1e10] {
            let mut products = Vec::new();
            for ratio in [0.2, 0.5, 1.0, 2.0, 5.0] {
                for motion in motions().into_iter().step_by(step) {
                    let problem = bristly(ratio, motion, stiffness);
                    let solution = solve(&problem, across);
                    assert_eq!(solution.status, Status::Converged, "{ratio} {motion:?}");
                    assert_eq!(solution.work.steps, 0, "{ratio} {motion:?}");
                    products.push(solution.work.operator_products);
                }
            }
            let found = quantiles(products);
            println!("{across} cells, k_c = {stiffness:e}/m: products {found:.1?}");
            assert_below(found, [40.0, 80.0, 100.0]);
        }
    }
}

fn bristly(ratio: f64, motion: [f64; 3], stiffness: f64) -> Problem {
    let contact_law = Incremental::new(stiffness).unwrap().into();
    coulomb(semi_axes(ratio), motion)
        .with_interface(|interface| interface.contact_law = contact_law)
}

/// As k_c grows by tenths from soft bristles to stiff ones, no force bends by more than 0.1 % of μN
/// from one value to the next, where cells at the edge no longer follow their bristles but their
/// neighbours; and the stiffest ones lead to Coulomb's law.
#[test]
fn forces_do_not_jump_with_the_stiffness_of_the_bristles() {
    let motions = [[1e-3, 0.0, 0.0], [7e-4, 7e-4, 0.0], [0.0, 5e-4, 0.15], [0.0, 0.0, 0.3]];
    for across in [20, 40] {
        for (ratio, motion) in [0.5, 1.0, 2.0].into_iter().flat_map(|r| motions.map(|m| (r, m))) {
            let of = |problem: &Problem| {
                let force = solve(problem, across).normalised;
                [force.x, force.y, force.moment_z.unwrap()]
            };
            let at = |step: i32| of(&bristly(ratio, motion, 8e6 * 1.1_f64.powi(step)));
            let forces: Vec<[f64; 3]> = (0..28).map(at).collect();
            let bend = |three: &[[f64; 3]]| {
                let of = |c: usize| (three[0][c] - 2.0 * three[1][c] + three[2][c]).abs();
                of(0).max(of(1)).max(of(2))
            };
            let largest = forces.windows(3).map(bend).fold(0.0, f64::max);
            let limit = of(&coulomb(semi_axes(ratio), motion));
            let stiffest = of(&bristly(ratio, motion, 1e13));
            let off = (0..3).map(|c| (limit[c] - stiffest[c]).abs()).fold(0.0, f64::max);
            println!("{across} cells, a/b = {ratio}, {motion:?}: {largest:.5}, {off:.5}");
            assert!(largest < 1e-3, "{across} {ratio} {motion:?}: {largest}");
            assert!(off < 1e-5, "{across} {ratio} {motion:?}: {off}");
        }
    }
}

/// Points of a creep curve start from the points before.
#[test]
fn warm_work_along_a_creep_curve() {
    const POINTS: u32 = 30;
    let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 200.0], [0.8, 0.4, 50.0]];
    let base = coulomb(semi_axes(1.0), [0.0; 3]);
    for (across, allowed) in
        [(20, [16.0, 18.0, 20.0]), (40, [18.0, 20.0, 23.0]), (80, [18.5, 21.0, 27.0])]
    {
        let mut products = Vec::new();
        for direction in directions {
            let mut solver = SteadySolver::new(&cells(across));
            for point in 1..=POINTS {
                let size = 0.008 * (f64::from(point) / f64::from(POINTS)).powf(1.5);
                let [xi, eta, spin] = direction.map(|part| size * part);
                let problem = Problem { kinematics: rolling(xi, eta, spin), ..base.clone() };
                let solution = solver.solve(&problem, &unwatched).unwrap();
                assert_eq!(solution.status, Status::Converged, "{direction:?} {point}");
                if point > 1 {
                    products.push(solution.work.operator_products);
                }
            }
        }
        let found = quantiles(products);
        println!("{across} cells: warm products {found:.1?}");
        assert_below(found, allowed);
    }
}
