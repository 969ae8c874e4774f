//! Times of forces with derivatives from a table as large as the standard one, whatever its values.

use std::f64::consts::{FRAC_PI_2, PI};
use std::hint::black_box;
use std::time::Instant;

use schlupf::problem::look_up_table::{LookUpTable, TableNodes};

/// Nodes of the standard table.
const NODES: [usize; 4] = [17, 33, 14, 21];

const STATES: usize = 100_000;
const ROUNDS: usize = 20;

/// A row each for states without order and for a motion that changes little from state to state.
pub fn table() -> String {
    let table = empty();
    let random = states(|k, part| (part * 0.618 * k as f64).fract());
    let smooth = states(|k, part| 0.5 + 0.4 * (1e-4 * part * k as f64).sin());
    let rows = [("in any order", random), ("of a run", smooth)].map(|(name, states)| {
        let time = time(&table, &states);
        format!("| {name} | {:.2} | {:.1} |", 1e6 * time, 1e-6 / time)
    });
    format!(
        "Forces with derivatives from the look-up table, a/b different each time, one thread:\n\n\
         | states | µs | millions a second |\n|---|--:|--:|\n{}",
        rows.join("\n")
    )
}

fn empty() -> LookUpTable {
    let line = |count: usize, last: f64, intervals: usize| -> Vec<f64> {
        (0..count).map(|k| last * (k as f64 / intervals as f64)).collect()
    };
    let [ratios, azimuths, inclinations, saturations] = NODES;
    let nodes = TableNodes {
        poisson_ratio: 0.28,
        axis_ratios: line(ratios, 2.0, ratios - 1).iter().map(|x| 10.0_f64.powf(x - 1.0)).collect(),
        azimuths: line(azimuths, PI, azimuths),
        inclinations: line(inclinations, FRAC_PI_2, inclinations - 1),
        saturations: line(saturations, 1.0, saturations - 1),
        values: vec![[0.0; 3]; NODES.iter().product()],
        creep_coefficients: vec![[4.0, 4.0, 1.5, 0.5]; ratios],
    };
    LookUpTable::new(nodes).unwrap()
}

/// a/b and normalised creepages from numbers between 0 and 1.
fn states(number: impl Fn(usize, f64) -> f64) -> Vec<(f64, [f64; 3])> {
    let of = |k: usize| {
        let [ratio, size] = [1.0, 1.7].map(|part| number(k, part));
        let size = 10.0_f64.powf(3.0 * size - 2.0);
        let creepages = [2.3, 3.1, 4.3].map(|part| size * (2.0 * number(k, part) - 1.0));
        (10.0_f64.powf(2.0 * ratio - 1.0), creepages)
    };
    (0..STATES).map(of).collect()
}

/// The fastest of some rounds, for one state, in s.
fn time(table: &LookUpTable, states: &[(f64, [f64; 3])]) -> f64 {
    let round = |_| {
        let start = Instant::now();
        for (ratio, creepages) in states {
            black_box(table.normalised_force(black_box(*ratio), black_box(*creepages)));
        }
        start.elapsed().as_secs_f64() / STATES as f64
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}
