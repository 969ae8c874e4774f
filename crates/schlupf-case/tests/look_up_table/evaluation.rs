//! Properties of the forces from the standard table.

use std::sync::Arc;

use schlupf::bodies::Kinematics;
use schlupf::normal::Ellipse;
use schlupf::problem::FastMethod;
use schlupf::problem::look_up_table::LookUpTable;
use schlupf::solution::{Resultant, Sensitivity};
use schlupf::solver::simplified::{EllipticContact, FastContact, FastSolver, TableContact};
use schlupf::{Options, Problem, Solver, unwatched};
use schlupf_case::look_up_table::standard;

fn table() -> Arc<LookUpTable> {
    standard().unwrap().table
}

/// Normalised creepages in all octants, from nearly none to nearly all sliding.
fn creepages() -> Vec<[f64; 3]> {
    let directions = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 1.0, 0.1],
        [-0.3, 0.8, 0.5],
        [0.5, -0.6, 0.4],
        [-0.2, -0.9, -0.7],
        [0.9, 1e-5, -2e-5],
    ];
    let sizes = [1e-4, 0.02, 0.1, 0.3, 1.0, 5.0];
    let of_size = |size: f64| directions.map(|direction| direction.map(|part| size * part));
    sizes.into_iter().flat_map(of_size).collect()
}

/// Mirror images in the plane y = 0 and in time (Kalker 1990, §3.3): ξ alone changes sign with Fx,
/// η and φ with Fy and Mz; to the rounding error of single precision.
#[test]
fn mirror_images_have_mirrored_forces() {
    for [xi, eta, spin] in creepages() {
        let force = |creepages| table().normalised_force(2.0, creepages).force;
        let [x, y, moment] = force([xi, eta, spin]);
        for (mirrored, expected) in [
            (force([-xi, eta, spin]), [-x, y, moment]),
            (force([xi, -eta, -spin]), [x, -y, -moment]),
        ] {
            let gap = |k: usize| (mirrored[k] - expected[k]).abs();
            assert!((0..3).all(|k| gap(k) < 1e-7), "{mirrored:?} {expected:?}");
        }
    }
}

/// Derivatives are those of the forces: central differences, whose own error is of second order,
/// between the knots of the splines, and away from |F| = μN, across which they are discontinuous.
#[test]
fn derivatives_are_those_of_central_differences() {
    let is_at_limit = |force: [f64; 3]| force[0].hypot(force[1]) > 1.0 - 1e-9;
    let mut across_the_limit = 0;
    for ratio in [0.1, 0.45, 1.0, 3.3, 10.0] {
        for at in creepages() {
            // In the direction of ξ, derivatives by η and φ depend a little on the side.
            let is_near_the_pole = at[1].abs().max(at[2].abs()) < 1e-3 * at[0].abs();
            let allowed = if is_near_the_pole { 2e-2 } else { 4e-3 };
            let found = table().normalised_force(ratio, at);
            let size = at.iter().map(|part| part * part).sum::<f64>().sqrt();
            let mut slope = |column: usize, step: f64| -> [f64; 3] {
                let moved = |sign: f64| {
                    let mut moved = at;
                    moved[column] += sign * step;
                    table().normalised_force(ratio, moved).force
                };
                let (plus, minus) = (moved(1.0), moved(-1.0));
                let is_kept = is_at_limit(found.force);
                if is_at_limit(plus) != is_kept || is_at_limit(minus) != is_kept {
                    across_the_limit += 1;
                    return std::array::from_fn(|row| found.by_creepage[row][column]);
                }
                std::array::from_fn(|row| (plus[row] - minus[row]) / (2.0 * step))
            };
            let slopes = [0, 1, 2].map(|column| slope(column, 3e-4 * size));
            let largest = slopes.as_flattened().iter().fold(0.0_f64, |most, s| most.max(s.abs()));
            // At small creepages errors are small beside the force whatever the slopes are.
            let allowed = (allowed / size).min(0.05 * largest.max(1e-2 / size));
            for (column, slopes) in slopes.iter().enumerate() {
                for (row, difference) in slopes.iter().enumerate() {
                    let exact = found.by_creepage[row][column];
                    let gap = (exact - difference).abs();
                    assert!(gap < allowed, "{ratio} {at:?} {row} {column}: {exact} {difference}");
                }
            }
        }
    }
    // Of 720 columns.
    assert!(across_the_limit <= 10, "{across_the_limit}");
}

/// Rolling without creepage has the derivatives of Kalker's linear theory (Kalker 1967), and the
/// forces of small creepages are linear.
#[test]
fn kalker_1967_small_creepages() {
    let c = schlupf::solver::kalker_coefficients::interpolated_coefficients(1.0, 0.28).unwrap();
    let rest = table().normalised_force(1.0, [0.0; 3]);
    assert_eq!(rest.force, [0.0; 3]);
    let expected = [[-c.c11, 0.0, 0.0], [0.0, -c.c22, -c.c23], [0.0, c.c23, -c.c33]];
    for (found, expected) in rest.by_creepage.iter().zip(expected) {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-3 * c.c11, "{found} {expected}");
        }
    }
    let small = table().normalised_force(1.0, [1e-60, 0.0, 0.0]).force;
    assert!((small[0] + 1e-60 * c.c11).abs() < 1e-63);
}

/// No force exceeds μN. In large creepage it opposes the sliding; in spin alone the moment is that
/// of sliding without rolling, on a circle 3π/16 μN a.
#[test]
fn forces_end_at_the_friction_limit() {
    for ratio in [0.1, 1.0, 10.0] {
        for at in creepages() {
            let [x, y, _] = table().normalised_force(ratio, at).force;
            assert!(x.hypot(y) <= 1.0 + 1e-12, "{ratio} {at:?}");
        }
    }
    for size in [1e3, 1e30, 1e200] {
        let [x, y, moment] = table().normalised_force(1.0, [3.0 * size, -4.0 * size, 0.0]).force;
        assert!((x + 0.6).abs() < 2e-3 && (y - 0.8).abs() < 2e-3 && moment.abs() < 2e-3);
        let [x, y, moment] = table().normalised_force(1.0, [0.0, 0.0, size]).force;
        let expected = -3.0 * std::f64::consts::PI / 16.0;
        assert!(x.abs() < 1e-6 && y.abs() < 5e-3 && (moment - expected).abs() < 5e-3);
    }
}

/// The force grows with the creepage alone along it: never falls by more than 0.1 % of μN.
#[test]
fn forces_rise_with_the_creepage() {
    for ratio in [0.1, 0.3, 1.0, 2.0, 10.0] {
        for (row, direction) in [(0, [1.0, 0.0, 0.0]), (1, [0.0, 1.0, 0.0])] {
            let mut largest = 0.0_f64;
            for k in 0..400 {
                let size = 2.0 * f64::from(k) / 400.0;
                let at = direction.map(|part: f64| size * part);
                let force = table().normalised_force(ratio, at).force[row].abs();
                assert!(force > largest - 1e-3, "{ratio} {at:?}: {force} after {largest}");
                largest = largest.max(force);
            }
        }
    }
}

/// A shape outside the table is flagged and has the forces of the nearest one; at the ends the
/// table still holds. What is not finite stays so.
#[test]
fn what_the_table_does_not_cover_is_flagged() {
    let at = [0.2, 0.1, 0.3];
    for (ratio, is_covered) in [(0.1, true), (10.0, true), (0.09, false), (11.0, false)] {
        assert_eq!(table().normalised_force(ratio, at).is_covered, is_covered, "{ratio}");
    }
    let (inside, outside) =
        (table().normalised_force(10.0, at), table().normalised_force(50.0, at));
    assert_eq!(inside.force, outside.force);
    assert!(table().normalised_force(1.0, [f64::NAN, 0.0, 0.0]).force[0].is_nan());
    assert!(!table().normalised_force(f64::NAN, at).is_covered);
}

/// At standstill the forces go by the slip velocities, with finite derivatives, and without slip
/// there are none.
#[test]
fn standstill_has_finite_derivatives() {
    let problem = Problem::builder().build().unwrap();
    let table = table();
    let contact = TableContact::new(&table, EllipticContact::new(&problem).unwrap());
    let limit = 24e3;
    for slip in [[0.0; 3], [1e-9, 0.0, 0.0], [0.1, -0.2, 3.0]] {
        for speed in [0.0, 1e-6, 0.01, 20.0] {
            let found = contact.standstill_force(slip, speed, 0.01, limit);
            assert!(found.slopes.iter().flatten().all(|slope| slope.is_finite()));
            assert!(found.force.tangential() <= limit * (1.0 + 1e-9));
        }
    }
    let locked = contact.standstill_force([0.5, 0.0, 0.0], 0.0, 0.01, limit).force;
    assert!((locked.x + limit).abs() < 1e-3 * limit, "{locked:?}");
    let rest = contact.standstill_force([0.0; 3], 0.0, 0.01, limit);
    assert_eq!(rest.force.tangential(), 0.0);
    assert!(rest.slopes[0][0] < 0.0);
    // Spin alone: a frame turned by π rolls the other way, so its lateral force turns, too, and
    // vanishes where nothing rolls.
    let turning = |speed: f64| contact.standstill_force([0.0, 0.0, 2.0], speed, 0.01, limit).force;
    let [ahead, back, still] = [5.0, -5.0, 0.0].map(turning);
    assert!(ahead.y.abs() > 0.1 * limit && (ahead.y + back.y).abs() < 1e-9 * limit, "{ahead:?}");
    assert!((ahead.moment_z.unwrap() - back.moment_z.unwrap()).abs() < 1e-9 * limit);
    assert!(still.y.abs() < 1e-9 * limit, "{still:?}");
    // Slip without spin knows no direction of rolling.
    let sliding =
        |speed: f64| contact.standstill_force([0.01, 0.02, 0.0], speed, 0.01, limit).force;
    assert!((sliding(5.0).y - sliding(-5.0).y).abs() < 1e-6 * limit);
    // At speed both are the same but for v_s²/2v².
    let motion = Kinematics {
        creepage_x: 1e-3,
        creepage_y: 5e-4,
        spin: 0.2,
        ..Kinematics::free_rolling(20.0)
    };
    let slip = [20e-3, 10e-3, 4.0];
    let (one, other) =
        (contact.force(&motion, limit), contact.standstill_force(slip, 20.0, 0.01, limit));
    assert!((one.force.x - other.force.x).abs() < 1e-6 * limit);
}

/// The derivatives of a solution, by creepages, load and friction, against central differences.
#[test]
fn a_solution_has_derivatives() {
    let method = FastMethod::Table(table());
    let options = Options { sensitivity: true, ..Options::default() };
    let force = |motion: [f64; 3], load: f64, friction: f64| -> (Resultant, Option<Sensitivity>) {
        let [xi, eta, spin] = motion;
        let problem = Problem::builder()
            .speed(20.0)
            .creepage_x(xi)
            .creepage_y(eta)
            .spin(spin)
            .load(load)
            .friction(schlupf::interface::friction::Constant::new(friction).unwrap())
            .build()
            .unwrap();
        let solution =
            FastSolver::new(method.clone(), &options).solve(&problem, &unwatched).unwrap();
        (solution.force, solution.sensitivity)
    };
    let (at, load, friction) = ([1e-3, -6e-4, 0.3], 80e3, 0.35);
    let (_, sensitivity) = force(at, load, friction);
    let sensitivity = sensitivity.unwrap();
    let check = |exact: Resultant, plus: Resultant, minus: Resultant, step: f64| {
        // The moment with a lever of about the size of the patch.
        let [exact_moment, plus_moment, minus_moment] =
            [exact, plus, minus].map(|force| force.moment_z.unwrap() / 5e-3);
        let pairs = [
            (exact.x, plus.x - minus.x),
            (exact.y, plus.y - minus.y),
            (exact_moment, plus_moment - minus_moment),
        ];
        let scale = pairs.iter().fold(0.0_f64, |scale, pair| scale.max(pair.0.abs()));
        for (exact, difference) in pairs {
            let gap = (exact - difference / (2.0 * step)).abs();
            assert!(gap < 2e-3 * scale, "{exact} {}", difference / (2.0 * step));
        }
    };
    let columns = [sensitivity.creepage_x, sensitivity.creepage_y, sensitivity.spin];
    for (column, exact) in columns.into_iter().enumerate() {
        let step = 1e-3 * at[column].abs();
        let moved = |sign: f64| {
            let mut moved = at;
            moved[column] += sign * step;
            force(moved, load, friction).0
        };
        check(exact, moved(1.0), moved(-1.0), step);
    }
    let step = 1e-3 * load;
    let [plus, minus] = [step, -step].map(|step| force(at, load + step, friction).0);
    check(sensitivity.load.unwrap(), plus, minus, step);
    let [plus, minus] = [1e-3, -1e-3].map(|step| force(at, load, friction + step).0);
    check(sensitivity.friction_coefficient, plus, minus, 1e-3);
}

/// A patch more slender than those of the table is told.
#[test]
fn a_slender_patch_is_warned_of() {
    let method = FastMethod::Table(table());
    for (semi_axes, is_told) in [([6e-3, 5e-3], false), ([20e-3, 1.5e-3], true)] {
        let ellipse = Ellipse::from_load(semi_axes[0], semi_axes[1], 10e3).unwrap();
        let problem = Problem::builder().normal(ellipse).creepage_x(1e-3).build().unwrap();
        let mut contact = FastContact::new(&problem, method.clone(), &Options::default()).unwrap();
        let warnings = contact.solution().warnings;
        let told = warnings.iter().any(|warning| warning.code() == "outside-table");
        assert_eq!(told, is_told, "{warnings:?}");
    }
}
