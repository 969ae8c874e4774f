//! Coulomb's law with everything that it works together with, and clear errors where it does not.

use std::sync::Arc;

use crate::common::{cells, half_space, layer, problem, rolling};
use approx::assert_relative_eq;
use schlupf::analysis::creep_curve::{Creepages, Path, Sampling, trace};
use schlupf::bodies::Material;
use schlupf::elasticity::{Rigid, Winkler};
use schlupf::interface::friction::{
    Constant, Exponential, Friction, FrictionLaw, FrictionMemory, Polach, Product, SlipTerms,
    TemperatureLinear,
};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental};
use schlupf::normal::{Ellipse, PressureTable, Tabulated};
use schlupf::solution::Resultant;
use schlupf::solver::SteadySolver;
use schlupf::solver::kalker_coefficients::creep_coefficients;
use schlupf::{Error, Options, Problem, Solution, Status, Transient, unwatched};

/// Creepages and spin (in 1/m) with which about half of the patch sticks.
const MOTION: [f64; 3] = [0.0015, 0.001, 0.4];

fn coulomb([xi, eta, spin]: [f64; 3]) -> Problem {
    problem(rolling(xi, eta, spin)).with_interface(|interface| {
        interface.elasticity = half_space();
        interface.contact_law = ContactLaw::Coulomb;
    })
}

fn solve(problem: &Problem, options: &Options) -> Solution {
    let solution = schlupf::solver::solve(problem, options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.work);
    solution
}

/// Distance of Fx and Fy over μN, and of Mz over μN √(ab), the larger one.
fn gap(one: &Solution, two: &Solution) -> f64 {
    let (one, two) = (one.normalised, two.normalised);
    let moment = one.moment_z.unwrap() - two.moment_z.unwrap();
    (one.x - two.x).hypot(one.y - two.y).max(moment.abs())
}

/// |t| ≤ μ pₙ to the tolerance, what friction dissipates is what the creep forces put in, and
/// there is no slip at all except along the largest traction.
fn check_invariants(solution: &Solution) {
    let power = solution.power.unwrap();
    assert_relative_eq!(power.friction, power.creep, max_relative = 1e-6);
    let fields = &solution.fields;
    let largest = fields.pressure.iter().copied().fold(0.0, f64::max);
    for k in 0..fields.pressure.len() {
        let bound = fields.friction_coefficient[k] * fields.pressure[k];
        let traction = [fields.traction_x[k], fields.traction_y[k]];
        let slip = [fields.slip_x[k], fields.slip_y[k]];
        let (length, speed) = (traction[0].hypot(traction[1]), slip[0].hypot(slip[1]));
        assert!(length <= bound + 1e-4 * largest, "{length} above {bound}");
        if length < bound - 1e-4 * largest {
            assert_eq!(speed, 0.0);
        } else if speed > 1e-3 {
            let along = -(traction[0] * slip[0] + traction[1] * slip[1]) / (length * speed);
            assert!(along > 0.999, "{along}");
        }
    }
}

/// Friction that falls with slip, with temperature, with both, and with a memory: the power balance
/// closes, and the forces are those of a contact law with stiff bristles to 1.5 % of μN, which are
/// that far off where the leading edge sticks.
#[test]
fn friction_laws_and_heat() {
    let hot = || Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    let polach = || Arc::new(Polach::new(0.4, 0.4, 0.6).unwrap());
    let laws: [Arc<dyn FrictionLaw>; 4] = [
        Arc::new(Exponential(SlipTerms::new(0.4, 0.2, 0.5, None).unwrap())),
        polach(),
        hot(),
        Arc::new(Product::new(hot(), polach()).unwrap()),
    ];
    for law in laws {
        for size in [0.3, 1.0, 3.0, 10.0] {
            for memory in [None, Some(FrictionMemory::new(1e-4, 1e-6).unwrap())] {
                let mut warm = coulomb(MOTION.map(|part| size * part));
                warm.interface.friction =
                    Friction { memory, ..Friction::new(Arc::clone(&law), 20.0) };
                warm.interface.heat =
                    Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
                let solution = solve(&warm, &cells(24));
                check_invariants(&solution);
                assert!(solution.work.operator_products < 40.0, "{law:?} {:?}", solution.work);
                let stiff: ContactLaw = Incremental::new(1e9).unwrap().into();
                let stiff = solve(
                    &warm.with_interface(|interface| interface.contact_law = stiff),
                    &cells(24),
                );
                let gap = gap(&solution, &stiff);
                assert!(gap < 0.015, "{law:?} {size}: {gap}");
            }
        }
    }
}

/// The layer and uncoupled springs converge with the grid, too.
#[test]
fn other_elasticities() {
    for elasticity in [layer(), Arc::new(Winkler::new(2e13, 2e13).unwrap())] {
        for size in [0.3, 1.0, 3.0] {
            let mut soft = coulomb(MOTION.map(|part| size * part));
            soft.interface.elasticity = Arc::clone(&elasticity);
            let [coarse, fine] = [24, 96].map(|across| solve(&soft, &cells(across)));
            check_invariants(&coarse);
            let gap = gap(&coarse, &fine);
            assert!(gap < 0.006, "{elasticity:?} {size}: {gap}");
        }
    }
}

/// Uncoupled springs under longitudinal creepage: the traction grows as c ξ times the distance
/// since entry until it meets μ pₙ (Winkler's bed; here per strip, summed by hand).
#[test]
fn winkler_sticks_in_proportion_to_the_distance() {
    let bedding = 2e13;
    let mut springs = coulomb([0.001, 0.0, 0.0]);
    springs.interface.elasticity = Arc::new(Winkler::new(bedding, bedding).unwrap());
    let solution = solve(&springs, &cells(40));
    let (a, b) = (6e-3_f64, 5e-3_f64);
    let fields = &solution.fields;
    let mut sticking = 0;
    for k in 0..fields.x.len() {
        let edge = a * (1.0 - (fields.y[k] / b).powi(2)).max(0.0).sqrt();
        let grown = bedding * 0.001 * (edge - fields.x[k]);
        if fields.covered[k] > 0.999 && grown < 0.8 * 0.4 * fields.pressure[k] {
            assert_relative_eq!(-fields.traction_x[k], grown, max_relative = 0.02);
            sticking += 1;
        }
    }
    assert!(sticking > 100, "{sticking}");
}

/// A table of Hertz's pressure gives the forces of the ellipse, although the displacement is then
/// calibrated on a finer grid; and two parts one behind the other, a bean and a flat pressure are
/// found, too.
#[test]
fn patches_of_any_shape() {
    let axis: Vec<f64> = (0..161).map(|k| 8e-3 * (f64::from(k) / 80.0 - 1.0)).collect();
    let root = |square: f64| 1e9 * (1.0 - square).max(0.0).sqrt();
    let under = |pressure: &dyn Fn(f64, f64) -> f64, across: usize| {
        let values = axis.iter().flat_map(|y| axis.iter().map(|x| pressure(*x, *y))).collect();
        let table = PressureTable::new(&axis, &axis, values).unwrap();
        let mut problem = coulomb(MOTION);
        problem.normal = Arc::new(Tabulated::new(table, None).unwrap());
        let solution = solve(&problem, &cells(across));
        check_invariants(&solution);
        solution
    };
    let square = |part: f64| part * part;
    let hertz = |x: f64, y: f64| root(square(x / 5e-3) + square(y / 5e-3));
    let mut exact = coulomb(MOTION);
    exact.normal = Arc::new(Ellipse::from_peak_pressure(5e-3, 5e-3, 1e9).unwrap());
    let gap_to_exact = gap(&under(&hertz, 24), &solve(&exact, &cells(24)));
    assert!(gap_to_exact < 0.003, "{gap_to_exact}");
    let two = |x: f64, y: f64| root(square((x.abs() - 4e-3) / 3e-3) + square(y / 4e-3));
    let bean = |x: f64, y: f64| root(square((x + 150.0 * y * y) / 4e-3) + square(y / 6e-3));
    let flat = |x: f64, y: f64| if x.abs() < 5e-3 && y.abs() < 3e-3 { 5e8 } else { 0.0 };
    let shapes: [&dyn Fn(f64, f64) -> f64; 3] = [&two, &bean, &flat];
    // Of two parts each one has less than half the cells along x.
    let grids = [(36, 0.004), (24, 0.004), (24, 0.015)];
    for (number, (shape, (across, allowed))) in shapes.into_iter().zip(grids).enumerate() {
        let gap = gap(&under(shape, across), &under(shape, 80));
        assert!(gap < allowed, "{number}: {gap}");
    }
}

/// Exact derivatives against central differences, with the active set of the solution.
#[test]
fn derivatives_are_those_of_central_differences() {
    let hot = |coefficient: f64| -> Arc<dyn FrictionLaw> {
        Arc::new(TemperatureLinear::new(coefficient, 700.0, 0.0).unwrap())
    };
    let constant = |coefficient: f64| -> Arc<dyn FrictionLaw> {
        Arc::new(Constant::new(coefficient).unwrap())
    };
    let laws: [&dyn Fn(f64) -> Arc<dyn FrictionLaw>; 2] = [&constant, &hot];
    for law in laws {
        let at = |motion: [f64; 3], coefficient: f64, load: f64| {
            let mut rubbing = coulomb(motion);
            rubbing.normal = Arc::new(Ellipse::from_load(6e-3, 5e-3, load).unwrap());
            rubbing.interface.friction.law = law(coefficient);
            rubbing.interface.heat =
                Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
            let options = Options { tolerance: 1e-11, sensitivity: true, ..cells(14) };
            solve(&rubbing, &options)
        };
        let exact = at(MOTION, 0.4, 80e3).sensitivity.unwrap();
        assert_eq!(exact.contact_stiffness, Resultant::default());
        let check = |exact: &Resultant, plus: &Solution, minus: &Solution, h: f64| {
            let over = |plus: f64, minus: f64| (plus - minus) / (2.0 * h);
            let [x, y] = [over(plus.force.x, minus.force.x), over(plus.force.y, minus.force.y)];
            let size = x.hypot(y);
            assert!((exact.x - x).abs() < 1e-4 * size, "{exact:?} {x} {y}");
            assert!((exact.y - y).abs() < 1e-4 * size, "{exact:?} {x} {y}");
            let moments = [plus, minus].map(|solution| solution.force.moment_z.unwrap());
            let moment = over(moments[0], moments[1]);
            let aside = (exact.moment_z.unwrap() - moment).abs();
            assert!(aside < 1e-4 * size.mul_add(5e-3, moment.abs()), "{exact:?} {moment}");
        };
        let moved = |c: usize, h: f64| {
            let mut motion = MOTION;
            motion[c] += h;
            at(motion, 0.4, 80e3)
        };
        for (c, (exact, h)) in
            [(exact.creepage_x, 1e-8), (exact.creepage_y, 1e-8), (exact.spin, 1e-5)]
                .into_iter()
                .enumerate()
        {
            check(&exact, &moved(c, h), &moved(c, -h), h);
        }
        let by_friction = exact.friction_coefficient;
        check(&by_friction, &at(MOTION, 0.4 + 1e-6, 80e3), &at(MOTION, 0.4 - 1e-6, 80e3), 1e-6);
        let by_load = exact.load.unwrap();
        check(&by_load, &at(MOTION, 0.4, 80e3 + 0.2), &at(MOTION, 0.4, 80e3 - 0.2), 0.2);
    }
}

/// Everything is proportional to the motion as long as next to nothing slides, and without motion
/// there is nothing.
#[test]
fn the_smallest_motions() {
    let force = |size: f64| {
        let force = solve(&coulomb(MOTION.map(|part| size * part)), &cells(20)).normalised;
        [force.x / size, force.y / size]
    };
    for (small, smaller) in force(1e-4).into_iter().zip(force(1e-9)) {
        assert_relative_eq!(small, smaller, max_relative = 2e-2);
    }
    let nothing = solve(&coulomb([0.0; 3]), &cells(20));
    assert_eq!(nothing.force.tangential(), 0.0);
}

/// Kalker 1967: at zero creepage all sticks and the slope of the creep curve is C11, here of
/// `kalker_coefficients`, to which it tends with the cell's size; its end is saturated.
#[test]
fn kalker_1967_initial_slope() {
    let mut base = coulomb([0.0; 3]);
    base.normal = Arc::new(Ellipse::from_peak_pressure(5e-3, 5e-3, 1e9).unwrap());
    let start = Creepages::default();
    let path = Path::new(start, Creepages { x: 0.02, ..start }).unwrap();
    let sampling = Sampling::Refined(10);
    let slope_on = |across: usize| {
        let mut solver = SteadySolver::new(&cells(across));
        let curve = trace(&mut solver, &base, &path, &sampling, &unwatched).unwrap();
        assert!(curve.is_converged());
        let last = curve.points.last().unwrap();
        assert_relative_eq!(last.normalised.x, -1.0, max_relative = 1e-3);
        curve.initial_slope.unwrap().kalker.unwrap().x
    };
    let [coarse, fine] = [16, 32].map(slope_on);
    let exact = creep_coefficients(1.0, Material::STEEL.poisson_ratio).unwrap().c11;
    assert_relative_eq!(fine, exact, max_relative = 0.02);
    assert_relative_eq!(2.0 * fine - coarse, exact, max_relative = 0.005);
}

/// On a patch with these semi-axes, in m.
fn on_ellipse(mut problem: Problem, [a, b]: [f64; 2]) -> Problem {
    problem.normal = Arc::new(Ellipse::from_peak_pressure(a, b, 1e9).unwrap());
    problem
}

/// Cells that are wider than long where the edge runs through many of them: on as few across as
/// are allowed the force is nearly that of a square grid; fewer, which have wrong solutions, are
/// refused, under Coulomb's law and with bristles.
#[test]
fn cells_that_are_too_wide_are_refused() {
    for (b, cells_y) in [(5e-3, 6), (25e-3, 13), (100e-3, 26), (1e-3, 3)] {
        let problem = on_ellipse(coulomb([1e-3, 1e-3, 0.0]), [5e-3, b]);
        let on = |cells_y| Options { cells_x: 40, cells_y, ..Options::default() };
        let (wide, square) = (solve(&problem, &on(cells_y)), solve(&problem, &on(40)));
        assert!(gap(&wide, &square) < 0.01, "{b}: {}", gap(&wide, &square));
        let products = wide.work.operator_products;
        assert!(products < 60.0, "{b}: {products}");

        let [fewest, columns, count] = [cells_y, 40, cells_y - 1];
        if fewest > 3 {
            let refusal = Error::TooFewAcross { fewest, columns, count };
            let refused = schlupf::solver::solve(&problem, &on(count), &unwatched);
            assert_eq!(refused.unwrap_err(), refusal);
            let transient = Transient::to_steady_state(&problem);
            let refused = schlupf::solver::march(&transient, &on(count), &unwatched);
            assert_eq!(refused.unwrap_err(), refusal);

            let mut stiff = problem;
            stiff.interface.contact_law = Incremental::new(1e8).unwrap().into();
            let refused = schlupf::solver::solve(&stiff, &on(count), &unwatched);
            assert_eq!(refused.unwrap_err(), refusal);
        }
    }
}

/// Nothing but elasticity determines the traction where bodies stick, so rigid ones are refused.
#[test]
fn rigid_bodies_are_refused() {
    let mut rigid = coulomb(MOTION);
    rigid.interface.elasticity = Arc::new(Rigid);
    let refused = schlupf::solver::solve(&rigid, &cells(8), &unwatched);
    assert_eq!(refused.unwrap_err(), Error::CoulombOfRigidBodies {});
}
