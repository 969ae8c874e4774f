//! Unlike bodies: pressure displaces their surfaces tangentially, and tractions change the
//! pressure.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::cells;
use approx::assert_relative_eq;
use schlupf::bodies::{Body, Kinematics, Material};
use schlupf::elasticity::{
    Compliance, Convolution, Elasticity, HalfSpace, PressureCoupling, UnlikeBodies,
};
use schlupf::interface::ContactLaw;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::{Heat, Partition};
use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::normal::{
    Ellipse, Grid, Hertz, PressureSource, PressureTable, Radii, Tabulated, VectorField,
};
use schlupf::problem::{Driver, History, LongitudinalForce, PrescribedForces};
use schlupf::reporting::Warning;
use schlupf::solver::march;
use schlupf::surface::{HeightMap, Lattice};
use schlupf::{Error, Method, Options, Problem, Solution, Status, Transient, unwatched};

const fn elastic(shear_modulus: f64, poisson_ratio: f64) -> Material {
    let young_modulus = 2.0 * (1.0 + poisson_ratio) * shear_modulus;
    Material { young_modulus, poisson_ratio, ..Material::STEEL }
}

const STEEL: Material = elastic(82e9, 0.28);
const ALUMINIUM: Material = elastic(23e9, 0.31);
const CAST_IRON: Material = elastic(44e9, 0.26);
const RUBBER: Material = elastic(1e6, 0.45);
/// The most unlike partner of something rigid.
const CORK: Material = elastic(1e6, 0.0);

/// A wheel and a rail with Coulomb's law and without heat.
fn problem(
    [wheel, rail]: [Material; 2],
    unlike_bodies: UnlikeBodies,
    friction: f64,
    normal: impl PressureSource + 'static,
) -> Problem {
    let bodies = HalfSpace::new(&wheel, &rail).unwrap().with_unlike_bodies(unlike_bodies);
    let body = |material| Body { material, ..Body::STEEL };
    Problem::builder()
        .wheel(body(wheel))
        .rail(body(rail))
        .normal(normal)
        .elasticity(bodies)
        .contact_law(ContactLaw::Coulomb)
        .friction(Constant::new(friction).unwrap())
        .heat(Heat { model: None, partition: Partition::Given(0.5) })
        .speed(10.0)
        .build()
        .unwrap()
}

fn solve(problem: &Problem, options: &Options) -> Solution {
    let solution = Method::Full.solver(options).solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

// Cylinders of aluminium and steel, a = 0.1 mm and R = 25 mm, in a row of one metre: the problem of
// Bentall and Johnson 1967 with the numbers of the CONTACT user guide (Vollebregt 2022, §5.3).

const HALF_LENGTH: f64 = 0.1e-3;
const RADIUS: f64 = 25e-3;
const LOAD: f64 = 16_201.9;
const ROW: f64 = 1.0;

/// Cells along rolling over the contact.
const CELLS: usize = 200;

fn cylinders() -> PressureCoupling {
    HalfSpace::new(&ALUMINIUM, &STEEL).unwrap().pressure_coupling().unwrap()
}

/// The cylinders in plane strain, under a pressure that does not change: A_xx = −(2 (1 − ν)/(πG)) ∫
/// ln(|x − x'|/L) dx' (Johnson 1985, §2.3), with the mean over a cell undone as in the half-space.
#[derive(Debug)]
struct PlaneStrain;

impl Elasticity for PlaneStrain {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        // The rows share the load.
        let over = 2.0 / (PI * cylinders().contact_modulus() * grid.rows as f64);
        let length = grid.spacing_x;
        let primitive = |x: f64| x * (1.0 - (x.abs() / (10.0 * HALF_LENGTH)).ln());
        let at = |i: isize| {
            let x = i as f64 * length;
            over * (primitive(x + 0.5 * length) - primitive(x - 0.5 * length))
        };
        Ok(Box::new(Convolution::new(grid, |i, _| {
            let along = at(i) + (2.0 * at(i) - at(i + 1) - at(i - 1)) / 12.0;
            [along, along / (1.0 - cylinders().poisson_ratio), 0.0]
        })))
    }

    fn pressure_coupling(&self) -> Option<PressureCoupling> {
        Some(PressureCoupling { is_mutual: false, ..cylinders() })
    }
}

/// The row of cells on which the pressure is found.
fn row() -> Grid {
    let columns = 1500;
    let spacing_x = 3.0 * HALF_LENGTH / columns as f64;
    let [origin_x, origin_y] = [-1.5 * HALF_LENGTH, -0.5 * ROW];
    Grid { columns, rows: 1, spacing_x, spacing_y: ROW, origin_x, origin_y }
}

/// The pressure of the cylinders with an opening (in m) of each cell of the row: that of two like
/// rows of half the width.
fn pressed(opening: &[f64]) -> Vec<f64> {
    let grid = row();
    let Grid { columns, spacing_x, spacing_y, .. } = grid;
    let lattice = Lattice { columns, rows: 2, spacing_x, spacing_y: 0.5 * spacing_y };
    let distance = |(i, h): (usize, &f64)| grid.x(i).powi(2) / (2.0 * RADIUS) + h;
    let distance: Vec<f64> = opening.iter().enumerate().map(distance).collect();
    let map = HeightMap::new(lattice, distance.repeat(2)).unwrap();
    let modulus = cylinders().contact_modulus();
    let options = RoughContactOptions { tolerance: 1e-10, max_iterations: 2000 };
    let mut bodies = RoughContact::new(map, modulus, Boundary::Free).unwrap();
    let solution = bodies.solve(LOAD, &options, &unwatched).unwrap();
    assert!(solution.is_converged);
    solution.pressure[..columns].to_vec()
}

/// The cylinders in steady rolling under the pressure on the row.
fn rolling(pressure: &[f64], friction: f64) -> Problem {
    let grid = row();
    let x: Vec<f64> = (0..grid.columns).map(|i| grid.x(i)).collect();
    let table = PressureTable::new(&x, &[-0.25 * ROW, 0.25 * ROW], pressure.repeat(2)).unwrap();
    let normal = Tabulated::new(table, Some(LOAD)).unwrap();
    let problem = problem([ALUMINIUM, STEEL], UnlikeBodies::OneWay, friction, normal);
    problem.with_interface(|interface| interface.elasticity = Arc::new(PlaneStrain))
}

fn roll(problem: &Problem) -> Solution {
    solve(problem, &Options { cells_x: CELLS, cells_y: 1, ..Options::default() })
}

/// The opening (in m) of each cell of the row under the tractions of a solution, each of which is
/// spread over the cells of the row.
fn opened(solution: &Solution) -> Vec<f64> {
    let (grid, fields) = (row(), &solution.fields);
    let mut traction = VectorField::zeros(grid.len());
    let half = 0.5 * fields.grid.spacing_x;
    let middle = solution.normal.origin.unwrap()[0];
    for (k, [column, _]) in fields.cell.iter().enumerate() {
        let x = fields.grid.x(*column) + middle;
        for i in 0..grid.columns {
            let [from, to] = [grid.edge_x(i), grid.edge_x(i + 1)];
            let shared = (to.min(x + half) - from.max(x - half)).max(0.0);
            traction.x[i] += fields.traction_x[k] * shared / grid.spacing_x;
        }
    }
    cylinders().opening(&grid, &traction)
}

/// Bentall and Johnson 1967: with little friction the creepage of free rolling is 0.457 κ a/R, κ =
/// 2K/(1 − ν), within 0.5 %: the force changes its sign there. The softer wheel turns faster.
#[test]
fn bentall_johnson_1967_free_rolling_with_little_friction() {
    let PressureCoupling { constant, poisson_ratio, .. } = cylinders();
    let kappa = 2.0 * constant / (1.0 - poisson_ratio);
    assert_relative_eq!(kappa, 0.2877, max_relative = 1e-3);
    let free = -0.457 * kappa * HALF_LENGTH / RADIUS;
    let mut problem = rolling(&pressed(&vec![0.0; row().len()]), 1e-4);
    let mut force = |creepage_x| {
        problem.kinematics.creepage_x = creepage_x;
        let solution = roll(&problem);
        let power = solution.power.unwrap();
        assert_relative_eq!(power.friction, power.creep, max_relative = 1e-6);
        solution.force.x
    };
    let [faster, slower] = [force(1.005 * free), force(0.995 * free)];
    assert!(faster > 0.0 && slower < 0.0, "{faster} {slower}");
}

/// Creepages under a force over μN with the pressure of Hertz and with that which the tractions
/// change, and the largest of the latter.
fn creepages(friction: f64, force: f64) -> ([f64; 2], f64) {
    let x = Some(LongitudinalForce::Force(force * friction * LOAD));
    let prescribed = PrescribedForces { x, ..PrescribedForces::default() };
    let roll = |pressure: &[f64]| roll(&Problem { prescribed, ..rolling(pressure, friction) });
    let first = roll(&pressed(&vec![0.0; row().len()]));
    let (mut last, mut largest) = (first.clone(), 0.0);
    for _ in 0..4 {
        let pressure = pressed(&opened(&last));
        largest = pressure.iter().copied().fold(0.0, f64::max);
        last = roll(&pressure);
    }
    ([first, last].map(|solution| solution.kinematics.creepage_x), largest)
}

/// CONTACT (Vollebregt 2022, §5.3), also on 200 cells, within 0.1 %: μ = 0.05, free rolling, forces
/// of both signs. CONTACT rolls towards negative x.
#[test]
fn vollebregt_2022_cylinders_of_aluminium_and_steel() {
    for (force, expected, largest) in [
        (0.0, [-4.281e-4, -4.294e-4], 103.6e6),
        (-0.75, [-2.094e-4, -2.108e-4], 103.2e6),
        (0.75, [-5.388e-4, -5.392e-4], 103.3e6),
    ] {
        let (found, peak) = creepages(0.05, force);
        for (found, expected) in found.into_iter().zip(expected) {
            assert_relative_eq!(found, expected, max_relative = 1e-3);
        }
        assert_relative_eq!(peak, largest, max_relative = 1e-3);
    }
}

/// Bufler 1959: free rolling without any slip. With t + i p bounded at both edges, the equations of
/// plane strain have the solution √(a² − x²) ((a + x)/(a − x))^{iε}, 2π ε = ln((1 + β)/(1 − β)),
/// ξ = 2 ε a/R and N = π E* a²/(4R) (1 + 4ε²); under the pressure of Hertz ξ = 2 β a/(π R).
#[test]
fn bufler_1959_free_rolling_without_slip() {
    let coupling = cylinders();
    let beta = coupling.constant / (1.0 - coupling.poisson_ratio);
    let epsilon = ((1.0 + beta) / (1.0 - beta)).ln() / (2.0 * PI);
    let a = (4.0 * LOAD / ROW * RADIUS / (PI * coupling.contact_modulus())).sqrt();
    let under_hertz = -2.0 * beta * a / (PI * RADIUS);
    let coupled = -2.0 * epsilon * a / (RADIUS * (1.0 + 4.0 * epsilon * epsilon).sqrt());
    let ([first, last], _) = creepages(10.0, 0.0);
    assert_relative_eq!(first, under_hertz, max_relative = 3e-3);
    assert_relative_eq!(last, coupled, max_relative = 3e-3);
    // The difference itself.
    assert_relative_eq!(last / first, coupled / under_hertz, max_relative = 1e-3);
}

// A round wheel on a crowned rail: a circle of contact.

const CROWN: f64 = 0.3;
const CIRCLE: f64 = 3e-3;

/// The wheel and rail under the load of that circle, with creepages and the spin times the circle's
/// radius over μ a/R.
fn crossed(
    bodies: [Material; 2],
    unlike_bodies: UnlikeBodies,
    friction: f64,
    [x, y, spin]: [f64; 3],
) -> Problem {
    let combined = HalfSpace::new(&bodies[0], &bodies[1]).unwrap();
    let modulus = combined.shear_modulus() / (1.0 - combined.poisson_ratio());
    let load = 4.0 / 3.0 * modulus * CIRCLE.powi(3) / CROWN;
    let hertz = Hertz::new(Radii::along(CROWN), Radii::across(CROWN), modulus, load).unwrap();
    let scale = friction * CIRCLE / CROWN;
    let problem = problem(bodies, unlike_bodies, friction, hertz);
    let kinematics = Kinematics {
        creepage_x: scale * x,
        creepage_y: scale * y,
        spin: scale * spin / CIRCLE,
        ..problem.kinematics
    };
    Problem { kinematics, ..problem }
}

/// Where the pressure acts along rolling, over the radius of the circle.
fn centre(solution: &Solution) -> f64 {
    let fields = &solution.fields;
    let moment: f64 = fields.x.iter().zip(&fields.pressure).map(|(x, p)| x * p).sum();
    moment / fields.pressure.iter().sum::<f64>() / CIRCLE
}

/// Johnson 1985, Eq. (3.42b): the pressure of Hertz on a circle draws the surfaces towards its
/// middle, in all by 2K/(3G) p0 a²/r (1 − (1 − r²/a²)^{3/2}).
#[test]
fn johnson_1985_displacement_under_hertz() {
    let (a, p0, count, spacing) = (6e-3, 1e9, 161, 1e-4);
    let origin = -0.5 * count as f64 * spacing;
    let grid = Grid {
        columns: count,
        rows: count,
        spacing_x: spacing,
        spacing_y: spacing,
        origin_x: origin,
        origin_y: origin,
    };
    let root = |r: f64| (1.0 - (r / a).powi(2)).max(0.0).sqrt();
    let cells = (0..grid.len()).map(|k| grid.x(k % count).hypot(grid.y(k / count)));
    let pressure: Vec<f64> = cells.map(|r| p0 * root(r)).collect();
    let coupling = cylinders();
    let u = coupling.displacement(&grid, &pressure);
    let scale = 2.0 * coupling.constant * p0 / (3.0 * coupling.shear_modulus);
    for [i, j] in [[100, 80], [90, 110], [150, 70], [60, 20]] {
        let [x, y] = [grid.x(i), grid.y(j)];
        let r = x.hypot(y);
        let towards_the_middle = scale * a * a / r * (1.0 - root(r).powi(3));
        let k = grid.index(i, j);
        assert_relative_eq!(u.x[k].hypot(u.y[k]), towards_the_middle, max_relative = 1e-3);
        assert_relative_eq!(u.x[k] * y, u.y[k] * x, epsilon = 1e-3 * r * towards_the_middle);
        assert!(u.x[k] * x + u.y[k] * y > 0.0, "rail minus wheel");
    }
}

/// Full sliding, t = −μ p along rolling: where the pressure acts and its maximum, against an
/// independent computation on 192 cells (Polonsky and Keer's conjugate gradients within a fixed
/// point between pressure and tractions).
#[test]
fn sliding_moves_the_pressure() {
    for (bodies, moved, largest) in
        [([CORK, STEEL], 0.1183, 0.9959), ([RUBBER, STEEL], 0.0217, 0.9998)]
    {
        let problem = crossed(bodies, UnlikeBodies::Coupled, 0.5, [20.0, 0.0, 0.0]);
        let hertz = problem.normal.normal_contact(None).unwrap().summary.peak_pressure;
        let solution = solve(&problem, &cells(40));
        assert_relative_eq!(centre(&solution), moved, max_relative = 0.01);
        assert_relative_eq!(solution.normal.peak_pressure / hertz, largest, max_relative = 2e-3);
        assert!(solution.warnings.is_empty(), "{:?}", solution.warnings);
    }
}

/// The surfaces of unlike bodies slip even without creepage. Exchanging them turns the force.
#[test]
fn exchanged_bodies_turn_the_force() {
    for [one, other] in [[RUBBER, STEEL], [CAST_IRON, STEEL]] {
        let force = |bodies| {
            let solution =
                solve(&crossed(bodies, UnlikeBodies::Coupled, 0.3, [0.0; 3]), &cells(20));
            assert!(solution.work.outer_iterations <= 6, "{:?}", solution.work);
            assert!(solution.work.operator_products <= 120.0, "{:?}", solution.work);
            let power = solution.power.unwrap();
            assert_relative_eq!(power.friction, power.creep, max_relative = 1e-5);
            solution.normalised.x
        };
        let [there, back] = [force([one, other]), force([other, one])];
        assert!(there < -0.1);
        assert_relative_eq!(there, -back, max_relative = 1e-5);
    }
}

/// Forces on 20 and 40 cells differ from those on 80 cells by less than 0.4 and 0.2 % of μN.
#[test]
fn forces_converge_with_the_grid() {
    for bodies in [[RUBBER, STEEL], [CAST_IRON, STEEL]] {
        for motion in [[0.0; 3], [0.5, 0.2, 0.5]] {
            let problem = crossed(bodies, UnlikeBodies::Coupled, 0.3, motion);
            let at = |count| {
                let solution = solve(&problem, &cells(count));
                [solution.normalised.x, solution.normalised.y]
            };
            let [coarse, medium, fine] = [at(20), at(40), at(80)];
            for c in 0..2 {
                assert!((coarse[c] - fine[c]).abs() < 4e-3, "{coarse:?} {fine:?}");
                assert!((medium[c] - fine[c]).abs() < 2e-3, "{medium:?} {fine:?}");
            }
        }
    }
}

/// Bodies that are alike: nothing is coupled, whatever is asked for, bit for bit.
#[test]
fn alike_bodies_are_solved_once() {
    let at = |unlike_bodies| {
        let problem = crossed([STEEL; 2], unlike_bodies, 0.3, [0.5, 0.2, 0.5]);
        let solution = solve(&problem, &cells(16));
        assert_eq!((solution.work.outer_iterations, solution.warnings.len()), (1, 0));
        [solution.force.x, solution.force.y, solution.force.moment_z.unwrap()].map(f64::to_bits)
    };
    let coupled = at(UnlikeBodies::Coupled);
    assert_eq!(coupled, at(UnlikeBodies::OneWay));
    assert_eq!(coupled, at(UnlikeBodies::Neglected));
}

/// Prescribed forces: the creepages that are found cause them.
#[test]
fn prescribed_forces_are_those_of_the_creepages() {
    let mut problem = crossed([CAST_IRON, STEEL], UnlikeBodies::Coupled, 0.3, [0.0; 3]);
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let x = Some(LongitudinalForce::Force(0.1 * load));
    problem.prescribed = PrescribedForces { x, ..PrescribedForces::default() };
    let found = solve(&problem, &cells(16));
    problem.prescribed = PrescribedForces::default();
    problem.kinematics = found.kinematics;
    let given = solve(&problem, &cells(16));
    assert_relative_eq!(found.force.x, 0.1 * load, max_relative = 1e-4);
    assert_relative_eq!(given.force.x, 0.1 * load, max_relative = 1e-4);
}

/// Marching arrives at the state that is found directly.
#[test]
fn marching_arrives_at_the_same_state() {
    let problem = crossed([RUBBER, STEEL], UnlikeBodies::Coupled, 0.3, [0.3, 0.2, 0.2]);
    let direct = solve(&problem, &cells(16));
    let mut marching = Method::Full.solver_by(Driver::Marching, &cells(16));
    let marched = marching.solve(&problem, &unwatched).unwrap();
    assert_eq!(marched.status, Status::Converged, "{:?}", marched.warnings);
    assert_relative_eq!(direct.force.x, marched.force.x, max_relative = 1e-4);
    assert_relative_eq!(direct.force.y, marched.force.y, max_relative = 1e-4);
}

/// A load that falls while the wheel rolls: the displacement under the pressure changes, too, and
/// the power balance closes in every step. The pressure itself stays that of Hertz, with a warning.
#[test]
fn falling_loads_keep_the_power_balance() {
    let problem = crossed([RUBBER, STEEL], UnlikeBodies::Coupled, 0.3, [0.3, 0.2, 0.0]);
    let load = problem.normal.normal_contact(None).unwrap().summary.load;
    let history = History {
        time: vec![0.0, 3.0 * CIRCLE / problem.kinematics.speed],
        load: Some(vec![load, 0.8 * load]),
        ..History::default()
    };
    let transient = Transient { history, ..Transient::to_steady_state(&problem) };
    let solution = march(&transient, &cells(16), &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    let neglects = |warning: &Warning| {
        matches!(warning, Warning::UnchangedPressure { in_derivatives: false, .. })
    };
    assert!(solution.warnings.iter().any(neglects), "{:?}", solution.warnings);
    for pair in solution.history.windows(2) {
        let gained = pair[1].stored_energy.unwrap() - pair[0].stored_energy.unwrap();
        let duration = pair[1].time - pair[0].time;
        let put_in = pair[1].creep_power.unwrap() * duration;
        let friction = pair[1].friction_power.unwrap() * duration;
        assert_relative_eq!(put_in, friction + gained, max_relative = 1e-6);
    }
}

/// Spence 1975: a soft sphere that is pressed onto a rigid one sticks within a radius c that is a
/// constant share of that of the patch, ln((1 + c)/(1 − c))/(2c) = (μ/β) K(√(1 − c²)) where the
/// tractions do not change the pressure: 0.6233 for ν = 0 and μ = 0.2986; within half a cell.
#[test]
fn spence_1975_compression_in_steps() {
    let rigid = elastic(1e12, 0.0);
    let load = |k: i32| 0.1 * f64::from(k).powi(3);
    let modulus = 2.0 * CORK.shear_modulus();
    let hertz = Hertz::new(Radii::along(CROWN), Radii::across(CROWN), modulus, load(1));
    let pressed = problem([CORK, rigid], UnlikeBodies::OneWay, 0.2986, hertz.unwrap());
    for count in [30, 50] {
        let history = History {
            time: vec![0.0; count],
            shift_x: Some(vec![0.0; count]),
            load: Some((1..=count as i32).map(load).collect()),
            ..History::default()
        };
        let transient = Transient { history, ..Transient::to_steady_state(&pressed) };
        let options = Options { slip_threshold: 0.995, ..cells(count) };
        let found = march(&transient, &options, &unwatched).unwrap();
        assert_eq!(found.status, Status::Converged, "{:?}", found.warnings);
        let share = (found.area.stick.unwrap() / found.area.contact).sqrt();
        println!("{count}: {share}");
        assert_relative_eq!(share, 0.6233, epsilon = 1.0 / count as f64);
    }
}

/// What is neglected is said: a pressure that is given, and derivatives.
#[test]
fn what_is_neglected_is_said() {
    let mut problem = crossed([RUBBER, STEEL], UnlikeBodies::Coupled, 0.3, [0.3, 0.2, 0.0]);
    let says = |solution: &Solution, in_derivatives: bool| {
        solution.warnings.iter().any(|warning| {
            matches!(warning, Warning::UnchangedPressure { in_derivatives: only, .. }
                if *only == in_derivatives)
        })
    };
    let coupled = solve(&problem, &Options { sensitivity: true, ..cells(12) });
    assert!(says(&coupled, true) && coupled.sensitivity.is_some());
    let hertz = problem.normal.normal_contact(None).unwrap().summary;
    let given = Ellipse::from_load(hertz.semi_axis_x, hertz.semi_axis_y, hertz.load).unwrap();
    problem.normal = Arc::new(given);
    let solution = solve(&problem, &cells(12));
    assert!(says(&solution, false), "{:?}", solution.warnings);
}
