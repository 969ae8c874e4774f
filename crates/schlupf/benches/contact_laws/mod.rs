//! Work and times with Coulomb's law and with stiff bristles.

use std::sync::Arc;
use std::time::Instant;

use schlupf::interface::contact_law::{ContactLaw, Incremental};
use schlupf::normal::ellipse::Ellipse;
use schlupf::rolling::steady::SteadySolver;
use schlupf::{Problem, Solution};

use super::common::{Bodies, Case, creep_curve, moving, rolling, solve};

const GRIDS: [usize; 4] = [20, 40, 80, 160];

/// Rounds of which the best counts.
const ROUNDS: usize = 3;

/// Semi-axes in m: that of the other tables, and a long patch.
const SEMI_AXES: [[f64; 2]; 2] = [[6e-3, 5e-3], [11.2e-3, 2.24e-3]];

/// A table of cold solutions without spin and with, and of points of a creep curve.
pub fn table() -> String {
    let stiff: ContactLaw = Incremental::new(1e8).unwrap().into();
    let laws = [("Coulomb", ContactLaw::Coulomb as ContactLaw), ("k_c = 1e8/m", stiff)];
    let mut lines = vec![
        "Half-space without heat; cold: creepages 0.003 and 0.001, spin 0 and 0.2/m; warm: as above:\n\n\
         | law | a/b | cells across | cold: products | ms | with spin: products | ms | warm: products | ms |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|"
            .to_owned(),
    ];
    for (name, law) in &laws {
        for [a, b] in SEMI_AXES {
            for cells in GRIDS {
                let case = Case { bodies: Bodies::HalfSpace, is_heated: false, cells };
                let at_rest = Problem {
                    contact_law: *law,
                    normal: Arc::new(Ellipse::from_peak_pressure(a, b, 1e9).unwrap()),
                    ..case.at_rest()
                };
                let measured = measured(&case, &at_rest)
                    .map(|[products, time]| format!("{products:.1} | {:.2}", 1e3 * time));
                let ratio = a / b;
                lines.push(format!("| {name} | {ratio:.1} | {cells} | {} |", measured.join(" | ")));
            }
        }
    }
    lines.join("\n")
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
