//! Work and times with bristles of every stiffness and with Coulomb's law.

use std::sync::Arc;
use std::time::Instant;

use schlupf::interface::{ContactLaw, Incremental};
use schlupf::normal::Ellipse;
use schlupf::solver::SteadySolver;
use schlupf::{Problem, Solution};

use super::common::{Bodies, Case, creep_curve, moving, rolling, solve};

const GRIDS: [usize; 4] = [20, 40, 80, 160];

/// Rounds of which the best counts.
const ROUNDS: usize = 3;

/// Semi-axes in m: that of the other tables, and a long patch.
const SEMI_AXES: [[f64; 2]; 2] = [[6e-3, 5e-3], [11.2e-3, 2.24e-3]];

/// Stiffnesses in 1/m; the last one is Coulomb's law.
const STIFFNESSES: [f64; 6] = [5e6, 3e7, 1e8, 1e9, 1e10, f64::INFINITY];

/// A table of cold solutions without spin and with, and of points of a creep curve: a row for each
/// stiffness and shape, with the grids in its cells.
pub fn table() -> String {
    let mut lines = vec![format!(
        "Half-space without heat, on {}; cold: creepages 0.003 and 0.001, spin 0 and 0.2/m; \
         warm: as above:\n\n\
         | k_c, 1/m | a/b | cold: products | ms | with spin: products | ms | warm: products | ms |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|",
        joined(&GRIDS.map(|cells| format!("{cells}²")))
    )];
    for [a, b] in SEMI_AXES {
        for stiffness in STIFFNESSES {
            let contact_law = if stiffness.is_finite() {
                Incremental::new(stiffness).unwrap().into()
            } else {
                ContactLaw::Coulomb
            };
            let on_grids = GRIDS.map(|cells| {
                let case = Case { bodies: Bodies::HalfSpace, is_heated: false, cells };
                let normal = Arc::new(Ellipse::from_peak_pressure(a, b, 1e9).unwrap());
                measured(
                    &case,
                    &Problem { normal, ..case.at_rest() }
                        .with_interface(|interface| interface.contact_law = contact_law),
                )
            });
            let cells: [String; 3] = std::array::from_fn(|n| {
                let products = joined(&on_grids.map(|of| format!("{:.0}", of[n][0])));
                let times = joined(&on_grids.map(|of| format!("{:.2}", 1e3 * of[n][1])));
                format!("{products} | {times}")
            });
            let name = if stiffness.is_finite() {
                format!("{stiffness:.0e}")
            } else {
                "∞ (Coulomb)".into()
            };
            lines.push(format!("| {name} | {:.1} | {} |", a / b, cells.join(" | ")));
        }
    }
    lines.join("\n")
}

/// Values for each grid in one cell of the table.
fn joined(values: &[String; GRIDS.len()]) -> String {
    values.join(" / ")
}

/// Products and the best time in s: cold without spin and with, and a point of the creep curve.
fn measured(case: &Case, at_rest: &Problem) -> [[f64; 2]; 3] {
    let cold = |spin: f64| {
        let problem = moving(at_rest, rolling(0.003, 0.001, spin));
        best(|| vec![solve(&mut SteadySolver::new(&case.options()), &problem)])
    };
    let curve = creep_curve(at_rest);
    let warm = best(|| {
        let mut solver = SteadySolver::new(&case.curve_options());
        curve.iter().map(|point| solve(&mut solver, point)).collect()
    });
    [cold(0.0), cold(0.2), warm]
}

/// Mean products of some solutions, and the best time of one, in s.
fn best(run: impl Fn() -> Vec<Solution>) -> [f64; 2] {
    let rounds = (0..ROUNDS).map(|_| {
        let start = Instant::now();
        let solutions = run();
        let count = solutions.len() as f64;
        let products: f64 = solutions.iter().map(|s| s.work.operator_products).sum();
        [products / count, start.elapsed().as_secs_f64() / count]
    });
    rounds.fold([0.0, f64::INFINITY], |best, round| [round[0], best[1].min(round[1])])
}
