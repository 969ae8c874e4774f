//! A table of work and times, as Markdown: `cargo xtask bench`.

mod common;
mod contact_laws;
mod look_up_table;
mod rough_contact;
mod wheel_rail;

use std::fs;
use std::hint::black_box;
use std::time::Instant;

use common::transforms::Transforms;
use common::{
    Bodies, Case, LAST_CREEPAGE, MOTION, POINTS, Product, cold, creep_curve, rolling, solve,
};
use schlupf::problem::{AreaReduction, Brush, FastMethod, SlopeReduction};
use schlupf::solution::Work;
use schlupf::solver::SteadySolver;
use schlupf::solver::simplified::FastContact;
use schlupf::{Status, unwatched};

const GRIDS: [usize; 5] = [20, 24, 40, 80, 160];

/// What one run of Neuhaus and Sextro (2014) took, in s.
const PAPER: f64 = 19.0;

/// A time is the best of so many passes over all cases, each of rounds for so long, in s, and of at
/// least so many.
const PASSES: usize = 3;
const MEASURED_FOR: f64 = 1.0;
const LEAST_ROUNDS: usize = 3;

/// Products, and transforms of one, in a round: they are short.
const PRODUCTS: usize = 20;

/// One row of the table.
struct Row {
    case: Case,
    /// Of a cold solution.
    work: Work,
    /// Of the same with the set-up there.
    solving: Work,
    /// Mean products and Newton steps of a point of the creep curve.
    warm_products: f64,
    warm_steps: f64,
    times: Times,
}

/// The best times so far, in s.
struct Times {
    cold: f64,
    /// Two solutions at rest, of which the first makes the set-up.
    first_at_rest: f64,
    second_at_rest: f64,
    /// A cold solution with the set-up there.
    solving: f64,
    /// Each point of the creep curve.
    curve: [f64; POINTS],
    product: f64,
    transforms: f64,
}

fn main() {
    // `cargo test --all-targets` runs benchmarks too, without this argument.
    if !std::env::args().any(|argument| argument == "--bench") {
        println!("run by `cargo xtask bench`");
        return;
    }
    if std::env::args().any(|argument| argument == "contact-laws") {
        println!("{}", contact_laws::table());
        return;
    }
    if std::env::args().any(|argument| argument == "look-up-table") {
        println!("{}", look_up_table::table());
        return;
    }
    if std::env::args().any(|argument| argument == "wheel-rail") {
        println!("{}", wheel_rail::table());
        return;
    }
    let families = [Bodies::Layer, Bodies::HalfSpace].map(|b| [(b, false), (b, true)]);
    let case = |(bodies, is_heated)| GRIDS.map(|cells| Case { bodies, is_heated, cells });
    let mut rows: Vec<Row> =
        families.into_iter().flatten().flat_map(case).map(Row::count).collect();
    for pass in 1..=PASSES {
        eprintln!("pass {pass} of {PASSES}");
        for row in &mut rows {
            row.times.measure(&row.case);
        }
    }
    println!("{}", heading());
    for row in &rows {
        println!("{}", row.line());
    }
    println!("\n{}\n\n{}", growth(&rows), against_the_paper(&rows));
    println!("\n{}", contact_laws::table());
    println!("\n{}", fast_methods());
    println!("\n{}", look_up_table::table());
    println!("\n{}", rough_contact::table());
    println!("\n{}", wheel_rail::table());
}

/// Motions of one round of a fast method.
const MOTIONS: usize = 200;

/// Times of a force by the fast methods, from their set-up.
fn fast_methods() -> String {
    let methods = [
        FastMethod::KalkerLinear,
        FastMethod::ShenHedrickElkins,
        FastMethod::Polach(AreaReduction::DRY),
        FastMethod::Fastsim(Brush::KALKER),
        FastMethod::ModifiedFastsim(Brush::KALKER, SlopeReduction::DRY),
    ];
    let mut lines = vec![
        "Forces by the fast methods, set-up there, mean over a creep curve; FASTSIM on its cells across:\n\n\
         | method | friction | cells across | µs |\n|---|---|--:|--:|"
            .to_owned(),
    ];
    for method in methods {
        let grids: &[usize] = if method.has_fields() { &[10, 24] } else { &[24] };
        for is_heated in [false, true] {
            for &cells in grids.iter().filter(|_| method.has_fields() || !is_heated) {
                let case = Case { bodies: Bodies::HalfSpace, is_heated, cells };
                let at_rest = case.at_rest();
                let mut contact =
                    FastContact::new(&at_rest, method.clone(), &case.options()).unwrap();
                let mut best = f64::INFINITY;
                for _ in 0..10 * LEAST_ROUNDS {
                    better(&mut best, || {
                        for k in 0..MOTIONS {
                            let part = k as f64 / MOTIONS as f64;
                            let motion = rolling(LAST_CREEPAGE * part, 0.001, 0.2);
                            black_box(contact.force(black_box(&motion))).unwrap();
                        }
                    });
                }
                lines.push(format!(
                    "| {} | {} | {} | {:.3} |",
                    method.name(),
                    if is_heated { "falls with the temperature" } else { "constant" },
                    if method.has_fields() { cells.to_string() } else { "–".to_owned() },
                    1e6 * best / MOTIONS as f64
                ));
            }
        }
    }
    lines.join("\n")
}

impl Row {
    /// Counts the work of a case.
    fn count(case: Case) -> Self {
        let at_rest = case.at_rest();
        let problem = cold(&at_rest);
        let solution = schlupf::solver::solve(&problem, &case.options(), &unwatched).unwrap();
        assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
        let mut solver = case.solver_at_rest(&case.curve_options());
        let warm = creep_curve(&at_rest);
        let warm: Vec<Work> = warm.iter().map(|point| solve(&mut solver, point).work).collect();
        let mean = |count: fn(&Work) -> f64| warm.iter().map(count).sum::<f64>() / POINTS as f64;
        Self {
            case,
            work: solution.work,
            solving: solve(&mut case.solver_at_rest(&case.options()), &problem).work,
            warm_products: mean(|work| work.operator_products),
            warm_steps: mean(|work| work.newton_iterations as f64),
            times: Times::NONE,
        }
    }

    /// In s.
    fn warm_time(&self) -> f64 {
        self.times.curve.iter().sum::<f64>() / POINTS as f64
    }

    /// Time over that of some products, and over that of the transforms in them.
    fn ratios(&self, time: f64, products: f64) -> String {
        let over = |floor: f64| time / (products * floor);
        format!("{:.2} | {:.2}", over(self.times.product), over(self.times.transforms))
    }

    fn line(&self) -> String {
        let times = &self.times;
        format!(
            "| {} | {} | {} | {} | {:.1} | {} | {:.2} | {:.2} | {} | {:.1} | {:.1} | {:.2} | {} | \
             {:.1} | {:.1} |",
            self.case.name(),
            if self.case.is_heated { "yes" } else { "no" },
            self.case.cells,
            self.work.cells,
            self.work.operator_products,
            self.work.newton_iterations,
            1e3 * times.cold,
            1e3 * (times.first_at_rest - times.second_at_rest),
            self.ratios(times.solving, self.solving.operator_products),
            self.warm_products,
            self.warm_steps,
            1e3 * self.warm_time(),
            self.ratios(self.warm_time(), self.warm_products),
            1e6 * times.product,
            1e6 * times.transforms,
        )
    }
}

impl Times {
    const NONE: Self = Self {
        cold: f64::INFINITY,
        first_at_rest: f64::INFINITY,
        second_at_rest: f64::INFINITY,
        solving: f64::INFINITY,
        curve: [f64::INFINITY; POINTS],
        product: f64::INFINITY,
        transforms: f64::INFINITY,
    };

    /// In rounds, so that all times see the same moods of the machine. What other programs do to it
    /// only ever adds, hence the best.
    fn measure(&mut self, case: &Case) {
        let (at_rest, options) = (case.at_rest(), case.options());
        let (problem, curve) = (cold(&at_rest), creep_curve(&at_rest));
        let (mut product, mut transforms) = (Product::new(case), Transforms::new(case));
        let start = Instant::now();
        let mut rounds = 0;
        while rounds < LEAST_ROUNDS || start.elapsed().as_secs_f64() < MEASURED_FOR {
            rounds += 1;
            better(&mut self.cold, || schlupf::solver::solve(&problem, &options, &unwatched));
            let mut solver = SteadySolver::new(&options);
            better(&mut self.first_at_rest, || solve(&mut solver, &at_rest));
            better(&mut self.second_at_rest, || solve(&mut solver, &at_rest));
            better(&mut self.solving, || solve(&mut solver, &problem));
            let mut solver = case.solver_at_rest(&case.curve_options());
            for (time, point) in self.curve.iter_mut().zip(&curve) {
                better(time, || solve(&mut solver, point));
            }
            for _ in 0..PRODUCTS {
                better(&mut self.product, || product.run());
            }
            for _ in 0..PRODUCTS {
                better(&mut self.transforms, || transforms.run());
            }
        }
    }
}

/// Notes how long something takes, in s, if that is less than before.
fn better<T>(best: &mut f64, work: impl FnOnce() -> T) {
    let start = Instant::now();
    let result = work();
    *best = best.min(start.elapsed().as_secs_f64());
    drop(result);
}

fn heading() -> String {
    let [xi, eta, spin] = MOTION;
    let machine = processor().map_or(String::new(), |name| format!(" on {name}"));
    format!(
        "Steady rolling, tolerance 1e-6, one thread{machine}. Times are the best of at least {} \
         rounds.\n\n\
         - cold: one solution from nothing, creepages {xi} and {eta}, spin {spin}/m; of it set-up: \
         what a first solution at rest takes longer than a second one\n\
         - warm: a point of a creep curve, mean over {POINTS} points {LAST_CREEPAGE} \
         (i/{POINTS})^1.5, each from those before, the first from nothing; set-up there\n\
         - /A: time, set-up there, over that of so many products with A; /T: over that of the fast \
         transforms in them\n\n\
         | elasticity | heat | cells across | contact cells | cold: products | Newton steps | ms | of \
         it set-up | /A | /T | warm: products | Newton steps | ms | /A | /T | product µs | its \
         transforms µs |\n\
         |---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|",
        PASSES * LEAST_ROUNDS
    )
}

/// What the processor calls itself, where the system says it.
fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// Times per contact cell on the finest grid over those on the coarsest one.
fn growth(rows: &[Row]) -> String {
    let [coarsest, .., finest] = GRIDS;
    let mut lines = vec![format!(
        "Growth of the time per contact cell from {coarsest} to {finest} cells across:\n\n\
         | elasticity | heat | cold | warm | product |\n|---|---|--:|--:|--:|"
    )];
    for family in rows.chunks_exact(GRIDS.len()) {
        let [first, .., last] = family else { continue };
        let growth = |time: fn(&Row) -> f64| {
            let per_cell = |row: &Row| time(row) / row.work.cells as f64;
            per_cell(last) / per_cell(first)
        };
        lines.push(format!(
            "| {} | {} | {:.2} | {:.2} | {:.2} |",
            first.case.name(),
            if first.case.is_heated { "yes" } else { "no" },
            growth(|row| row.times.cold),
            growth(Row::warm_time),
            growth(|row| row.times.product),
        ));
    }
    lines.join("\n")
}

fn against_the_paper(rows: &[Row]) -> String {
    let is_like = |row: &&Row| row.case.bodies == Bodies::Layer && row.case.is_heated;
    let lines = rows.iter().filter(is_like).map(|row| {
        format!(
            "- layer with heat, {} cells across, cold: {:.0} times as fast",
            row.case.cells,
            PAPER / row.times.cold
        )
    });
    let heading = format!(
        "Against the {PAPER} s of Neuhaus and Sextro (2014), who marched, on a grid they do not give:\n"
    );
    [heading].into_iter().chain(lines).collect::<Vec<_>>().join("\n")
}
