//! Contacts whose surface turns across the patch, so that every row has a rigid slip of its own.
//!
//! The surface of the examples is that of a flange root: in the plane of the contact, which leans
//! by 0.5 rad, an arc of radius 13 mm (that of the rail's gauge corner, EN 13674-1) on a wheel of
//! radius 0.46 m that rolls at Ω = V/0.46 m and moves outwards at 0.01 V. At y the surface has
//! turned by β = asin(y/R) and risen by n = R (1 − cos β), so with the rigid motion of the wheel
//!
//! Δξ = Ω n cos β₀/V,  Δη = v (cos(β₀ + β) − cos β₀)/V,  Δφ = −Ω (sin(β₀ + β) − sin β₀)/V.

use std::sync::Arc;

use crate::common::{self, cells, half_space, problem, rolling};
use approx::assert_relative_eq;
use schlupf::bodies::{Kinematics, Material, RowMotion, RowSlip, contact_modulus};
use schlupf::elasticity::{Elasticity, Winkler};
use schlupf::interface::friction::{Constant, TemperatureLinear};
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::interface::{ContactLaw, Incremental};
use schlupf::normal::{Hertz, NormalContact, PressureSource, Radii};
use schlupf::problem::{
    Brush, FastMethod, Flexibilities, LongitudinalForce, PrescribedForces, TractionBound,
};
use schlupf::solution::Resultant;
use schlupf::{Error, Method, Options, Problem, Solution, Status, Transient, unwatched};

const RADIUS: f64 = 13e-3;
const LEAN: f64 = 0.5;
const OVER_V: f64 = 1.0 / 0.46;
const OUTWARDS: f64 = 0.01;
const FRICTION: f64 = 0.4;

/// k_c of bristles that are soft against a cell, in 1/m.
const SOFT: f64 = 1e6;

/// A row of the flange root.
fn root(y: f64) -> RowSlip {
    let turned = (y / RADIUS).asin();
    RowSlip {
        creepage_x: OVER_V * RADIUS * (1.0 - turned.cos()) * LEAN.cos(),
        creepage_y: OUTWARDS * ((LEAN + turned).cos() - LEAN.cos()),
        spin: -OVER_V * ((LEAN + turned).sin() - LEAN.sin()),
    }
}

fn table(row: impl Fn(f64) -> RowSlip) -> Arc<RowMotion> {
    let y: Vec<f64> = (-60..=60).map(|k| 1e-4 * f64::from(k)).collect();
    let rows = y.iter().map(|y| row(*y)).collect();
    Arc::new(RowMotion::new(y, rows).unwrap())
}

/// A contact with rows of their own.
#[derive(Debug)]
struct Curved {
    inner: Arc<dyn PressureSource>,
    rows: Arc<RowMotion>,
}

impl PressureSource for Curved {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        let rows = Some(Arc::clone(&self.rows));
        Ok(NormalContact { rows, ..self.inner.normal_contact(load)? })
    }

    fn load_exponent(&self) -> Option<f64> {
        self.inner.load_exponent()
    }
}

/// Hertz: patches of 3 to 4 mm half-width under 80 kN.
fn hertz(load: f64) -> Arc<dyn PressureSource> {
    let wheel = Radii { x: 0.46, y: f64::INFINITY };
    let rail = Radii { x: f64::INFINITY, y: 0.08 };
    let modulus = contact_modulus(&Material::STEEL, &Material::STEEL);
    Arc::new(Hertz::new(wheel, rail, modulus, load).unwrap())
}

const LOAD: f64 = 80e3;

fn on_rows(rows: &Arc<RowMotion>, load: f64) -> Arc<dyn PressureSource> {
    Arc::new(Curved { inner: hertz(load), rows: Arc::clone(rows) })
}

/// A flange root with given creepages of its plane, whose spin is that of the motion.
fn curved(creepage_x: f64, creepage_y: f64) -> Problem {
    let motion = rolling(creepage_x, creepage_y, -OVER_V * LEAN.sin());
    Problem { normal: on_rows(&table(root), LOAD), ..problem(motion) }.with_interface(|interface| {
        interface.elasticity = half_space();
        interface.contact_law = incremental(SOFT);
    })
}

fn with_law(base: &Problem, contact_law: ContactLaw) -> Problem {
    base.clone().with_interface(|interface| interface.contact_law = contact_law)
}

fn incremental(stiffness: f64) -> ContactLaw {
    Incremental::new(stiffness).unwrap().into()
}

fn hot(mut base: Problem) -> Problem {
    base.interface.friction.law = Arc::new(TemperatureLinear::new(FRICTION, 700.0, 0.05).unwrap());
    base.interface.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    base
}

fn solve(problem: &Problem, options: &Options) -> Solution {
    let solution = Method::Full.solver(options).solve(problem, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

fn parts(force: &Resultant) -> [f64; 3] {
    [force.x, force.y, force.moment_z.unwrap() / 5e-3]
}

/// Asserts that two forces differ by less than a part of μN, with the moment over 5 mm.
fn assert_alike(name: &str, one: &Resultant, other: &Resultant, tolerance: f64) {
    for (one, other) in parts(one).into_iter().zip(parts(other)) {
        let off = (one - other).abs() / (FRICTION * LOAD);
        assert!(off < tolerance, "{name}: {one} instead of {other}, {off:.1e} of μN");
    }
}

fn combined(one: &Resultant, factor: f64, other: &Resultant, times: f64) -> Resultant {
    let sum = |part: fn(&Resultant) -> f64| factor * part(one) + times * part(other);
    Resultant::new(sum(|f| f.x), sum(|f| f.y), sum(|f| f.moment_z.unwrap()))
}

/// What differs for the full method: laws, elasticity, heat.
fn kinds() -> [(&'static str, Problem); 5] {
    let base = || curved(1e-3, -2e-3);
    let stiff: ContactLaw = ContactLaw::Coulomb;
    let uncoupled: Arc<dyn Elasticity> = Arc::new(Winkler::new(2e13, 1e13).unwrap());
    [
        ("soft bristles", base()),
        ("stiff bristles", with_law(&base(), incremental(1e8))),
        ("Coulomb", with_law(&base(), stiff)),
        ("Winkler", base().with_interface(|interface| interface.elasticity = uncoupled)),
        ("hot", hot(base())),
    ]
}

/// Rows that add nothing change no bit, in steady rolling, over time and in FASTSIM.
#[test]
fn rows_that_add_nothing_change_nothing() {
    let nothing = table(|_| RowSlip::default());
    let fastsim = Method::Fast(FastMethod::Fastsim(Brush::KALKER));
    for (name, problem) in kinds() {
        let plane = Problem { normal: hertz(LOAD), ..problem.clone() };
        let rows = Problem { normal: on_rows(&nothing, LOAD), ..problem };
        for method in [Method::Full, fastsim.clone()] {
            let solve =
                |problem: &Problem| method.solver(&cells(12)).solve(problem, &unwatched).unwrap();
            let [one, other] = [solve(&plane), solve(&rows)];
            assert_eq!(one.force, other.force, "{name}");
            assert_eq!(one.fields.traction_x, other.fields.traction_x, "{name}");
            assert_eq!(one.power, other.power, "{name}");
            assert_eq!(one.work, other.work, "{name}");
        }
        let [one, other] = [&plane, &rows].map(|problem| common::solve(problem, &cells(8)));
        assert_eq!(one.force, other.force, "{name}");
    }
}

/// A plane that leans otherwise: rows that add a constant lateral creepage, a constant spin and the
/// longitudinal slip of that spin are a plane with these creepages, to rounding and the tolerance.
#[test]
fn a_plane_has_constant_spin() {
    let tilted = table(|y| RowSlip { creepage_x: -0.7 * y, creepage_y: 4e-4, spin: 0.7 });
    let options = Options { tolerance: 1e-11, ..cells(14) };
    for (name, problem) in kinds() {
        let motion = problem.kinematics;
        let kinematics =
            Kinematics { creepage_y: motion.creepage_y + 4e-4, spin: motion.spin + 0.7, ..motion };
        let plane = Problem { kinematics, normal: hertz(LOAD), ..problem.clone() };
        let rows = Problem { normal: on_rows(&tilted, LOAD), ..problem };
        let [one, other] = [solve(&plane, &options), solve(&rows, &options)];
        assert_alike(name, &other.force, &one.force, 1e-10);
        let [wear, other_wear] = [one.t_gamma, other.t_gamma];
        assert_relative_eq!(wear.without_spin, other_wear.without_spin, max_relative = 1e-8);
        let [wear, other_wear] = [wear, other_wear].map(|wear| wear.with_spin.unwrap());
        assert_relative_eq!(wear, other_wear, max_relative = 1e-8);
        let [one, other] = [one.power.unwrap(), other.power.unwrap()];
        assert_relative_eq!(one.creep, other.creep, max_relative = 1e-9);
    }
}

/// Marching ends in the state that the steady solver finds, within 1e-4 of μN.
#[test]
fn marching_ends_in_the_steady_state() {
    let options = Options { max_steps: 4000, ..cells(16) };
    for (name, problem) in kinds() {
        let off = |problem: &Problem| {
            let marched = common::solve(problem, &options);
            let last = marched.history.last().unwrap();
            let (friction, creep) = (last.friction_power.unwrap(), last.creep_power.unwrap());
            assert_relative_eq!(friction, creep, max_relative = 1e-3);
            let steady = parts(&solve(problem, &options).force);
            let off = parts(&marched.force).into_iter().zip(steady);
            off.map(|(one, other)| (one - other).abs() / (FRICTION * LOAD)).fold(0.0, f64::max)
        };
        let off = off(&problem);
        println!("{name}: {off:.1e} of μN");
        assert!(off < 1e-4, "{name}: {off}");
    }
}

/// All power of the creep forces, row by row, becomes frictional heat, whatever the law: the mean
/// of p·(rigid slip) over the cells is that of p·slip, because elasticity does no work.
#[test]
fn the_power_balance_closes_row_by_row() {
    for (name, problem) in kinds() {
        for creepages in [[1e-4, 0.0], [1e-3, -2e-3], [2e-2, 1e-2]] {
            let motion = Kinematics {
                creepage_x: creepages[0],
                creepage_y: creepages[1],
                ..problem.kinematics
            };
            let solution = solve(&Problem { kinematics: motion, ..problem.clone() }, &cells(24));
            let power = solution.power.unwrap();
            // Σ p·slip of the rows by hand, with the closed form in the middle of each cell.
            let fields = &solution.fields;
            let by_hand = |k: usize| {
                let (x, y) = (fields.x[k], fields.y[k]);
                let (row, plane) = (root(y), motion.rigid_slip(x, y));
                let slip = [plane[0] + row.creepage_x, plane[1] + row.creepage_y + row.spin * x];
                -motion.speed * (fields.traction_x[k] * slip[0] + fields.traction_y[k] * slip[1])
            };
            let sum: f64 = (0..fields.x.len()).map(by_hand).sum();
            let by_hand = sum * fields.grid.cell_area();
            let plane = -motion.speed
                * (motion.creepage_x * solution.force.x
                    + motion.creepage_y * solution.force.y
                    + motion.spin * solution.force.moment_z.unwrap());
            println!(
                "{name} {creepages:?}: {:.5} {:.5}",
                power.friction / power.creep,
                plane / power.creep
            );
            assert_relative_eq!(power.friction, power.creep, max_relative = 1e-4);
            assert_relative_eq!(power.creep, by_hand, max_relative = 1e-3);
        }
    }
}

/// Tγ is the sum of the sizes of its parts, by hand from tractions, the motion of the plane and the
/// closed form of the rows; rows that turn a contact of pure longitudinal creepage sideways count.
#[test]
fn wear_numbers_are_those_of_the_rows() {
    let base = curved(2e-3, -1e-3);
    for problem in [with_law(&base, ContactLaw::Coulomb), base] {
        let solution = solve(&problem, &cells(24));
        let (motion, fields) = (solution.kinematics, &solution.fields);
        let mut parts = [0.0; 3];
        for k in 0..fields.x.len() {
            let (x, y, row) = (fields.x[k], fields.y[k], root(fields.y[k]));
            let [along, across] = [fields.traction_x[k], fields.traction_y[k]];
            parts[0] += along * motion.creepage_x;
            parts[1] += across * (motion.creepage_y + row.creepage_y);
            parts[2] +=
                along * (row.creepage_x - motion.spin * y) + across * (motion.spin + row.spin) * x;
        }
        let [x, y, spin] = parts.map(|part| (part * fields.grid.cell_area()).abs());
        let plane = (motion.creepage_x * solution.force.x).abs()
            + (motion.creepage_y * solution.force.y).abs();
        let wear = solution.t_gamma;
        assert_relative_eq!(wear.without_spin, x + y, max_relative = 1e-3);
        assert_relative_eq!(wear.with_spin.unwrap(), x + y + spin, max_relative = 1e-3);
        assert!((wear.without_spin / plane - 1.0).abs() > 2e-3, "{wear:?} {plane}");
    }
}

/// Full sliding without elasticity to speak of: the traction of every cell opposes the rigid slip
/// of its row, in the full method and in FASTSIM with one flexibility, and so do the forces.
#[test]
fn fastsim_slides_as_the_full_method() {
    let problem = with_law(&curved(0.15, 0.08), ContactLaw::Coulomb);
    let brush = Brush { flexibilities: Flexibilities::One, bound: TractionBound::Elliptic };
    let full = solve(&problem, &cells(24));
    let mut solver = Method::Fast(FastMethod::Fastsim(brush)).solver(&cells(24));
    let fast = solver.solve(&problem, &unwatched).unwrap();
    assert_alike("FASTSIM", &fast.force, &full.force, 2e-3);
    for solution in [&full, &fast] {
        let fields = &solution.fields;
        let [mut x, mut y] = [0.0; 2];
        for k in 0..fields.x.len() {
            let row = root(fields.y[k]);
            let plane = problem.kinematics.rigid_slip(fields.x[k], fields.y[k]);
            let [along, across] =
                [plane[0] + row.creepage_x, plane[1] + row.creepage_y + row.spin * fields.x[k]];
            let bound = FRICTION * fields.pressure[k] * fields.grid.cell_area();
            x -= bound * along / along.hypot(across);
            y -= bound * across / along.hypot(across);
        }
        let moment_z = solution.force.moment_z.unwrap();
        assert_alike("rigid", &solution.force, &Resultant::new(x, y, moment_z), 2e-3);
    }
}

/// Exact derivatives with respect to creepages, load, μ0 and k_c against central differences of
/// whole solutions: within 2e-6 of μN for a change by the scale of the parameter.
#[test]
fn derivatives_are_those_of_the_solutions() {
    let rows = table(root);
    let options = Options { tolerance: 1e-11, sensitivity: true, ..cells(14) };
    let bases = [curved(1e-3, -2e-3), hot(curved(1e-3, -2e-3))];
    for base in bases {
        let exact = solve(&base, &options).sensitivity.unwrap();
        let moved = |set: fn(&mut Kinematics, f64), by: f64| {
            let mut problem = base.clone();
            set(&mut problem.kinematics, by);
            problem
        };
        let loaded =
            |by: f64| Problem { normal: on_rows(&rows, LOAD * (1.0 + by)), ..base.clone() };
        let stiffer = |by: f64| with_law(&base, incremental(SOFT * (1.0 + by)));
        let rougher = |by: f64| {
            let mut problem = base.clone();
            let mu = FRICTION * (1.0 + by);
            problem.interface.friction.law = if base.interface.heat.model.is_some() {
                Arc::new(TemperatureLinear::new(mu, 700.0, 0.05).unwrap())
            } else {
                Arc::new(Constant::new(mu).unwrap())
            };
            problem
        };
        let check = |name: &str, exact: &Resultant, at: &dyn Fn(f64) -> Problem, scale: f64| {
            let h = 2e-5;
            let [plus, minus] = [h, -h].map(|by| solve(&at(by), &options).force);
            let found = combined(&plus, 0.5 / h, &minus, -0.5 / h);
            assert_alike(name, &combined(exact, scale, exact, 0.0), &found, 2e-6);
        };
        let x: fn(&mut Kinematics, f64) = |motion, by| motion.creepage_x += 1e-3 * by;
        let y: fn(&mut Kinematics, f64) = |motion, by| motion.creepage_y += 1e-3 * by;
        let spin: fn(&mut Kinematics, f64) = |motion, by| motion.spin += 0.2 * by;
        check("ξ", &exact.creepage_x, &|by| moved(x, by), 1e-3);
        check("η", &exact.creepage_y, &|by| moved(y, by), 1e-3);
        check("φ", &exact.spin, &|by| moved(spin, by), 0.2);
        check("N", &exact.load.unwrap(), &loaded, LOAD);
        check("μ0", &exact.friction_coefficient, &rougher, FRICTION);
        check("k_c", &exact.contact_stiffness, &stiffer, SOFT);
    }
}

/// Prescribed forces are those of the creepages that are found for them. (Hot friction falls, so
/// that one force may have several creepages.)
#[test]
fn prescribed_forces_find_their_creepages() {
    for (name, problem) in kinds().into_iter().filter(|(name, _)| *name != "hot") {
        let given = solve(&problem, &cells(16));
        let prescribed = PrescribedForces {
            x: Some(LongitudinalForce::Force(given.force.x)),
            y: Some(given.force.y),
            moment_z: None,
        };
        let free = Kinematics { creepage_x: 0.0, creepage_y: 0.0, ..problem.kinematics };
        let problem = Problem { kinematics: free, prescribed, ..problem };
        let mut solver = Method::Full.solver(&cells(16));
        let found = solver.solve(&problem, &unwatched).unwrap();
        assert_eq!(found.status, Status::Converged, "{name}");
        assert_alike(name, &found.force, &given.force, 1e-4);
        let [one, other] = [found.kinematics, given.kinematics];
        assert!((one.creepage_x - other.creepage_x).abs() < 1e-6, "{name}: {one:?}");
        assert!((one.creepage_y - other.creepage_y).abs() < 1e-6, "{name}: {one:?}");
    }
}

/// The mirror image of rows and motion has the mirror image of the forces.
#[test]
fn mirror_images_are_mirrored() {
    let image = Arc::new(table(root).mirrored());
    for (name, problem) in kinds() {
        let motion = problem.kinematics;
        let kinematics =
            Kinematics { creepage_y: -motion.creepage_y, spin: -motion.spin, ..motion };
        let mirrored = Problem { kinematics, normal: on_rows(&image, LOAD), ..problem.clone() };
        let [one, other] = [&problem, &mirrored].map(|problem| solve(problem, &cells(15)).force);
        let back = Resultant::new(other.x, -other.y, -other.moment_z.unwrap());
        assert_alike(name, &back, &one, 1e-10);
    }
}

/// A history over which the motion changes: the powers of every step balance with the elastic
/// energy.
#[test]
fn powers_of_every_step_balance() {
    let problem = curved(1e-3, -2e-3);
    let history = schlupf::problem::History {
        time: vec![0.0, 2e-3],
        creepage_x: Some(vec![0.0, 2e-3]),
        ..Default::default()
    };
    let transient = Transient { history, ..Transient::to_steady_state(&problem) };
    let solution = common::follow(&transient, &cells(16));
    assert!(solution.history.len() > 20);
    for pair in solution.history.windows(2) {
        let duration = pair[1].time - pair[0].time;
        let stored = (pair[1].stored_energy.unwrap() - pair[0].stored_energy.unwrap()) / duration;
        let (creep, friction) = (pair[1].creep_power.unwrap(), pair[1].friction_power.unwrap());
        assert_relative_eq!(creep, friction + stored, max_relative = 1e-6);
    }
}
