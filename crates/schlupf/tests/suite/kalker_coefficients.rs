//! Kalker's creep coefficients against tables.

use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;

use schlupf::Error;
use schlupf::solver::kalker_coefficients::{creep_coefficients, interpolated_coefficients};
use schlupf::solver::reference::CreepCoefficients;

/// Lines of `data/kalker_coefficients.csv`: a/b, ν, then C11, C22, C23 as printed and C11, C22,
/// C23, C33 converged; NaN where empty.
fn table() -> Vec<[f64; 9]> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/kalker_coefficients.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file).unwrap();
    let line = |record: csv::StringRecord| {
        std::array::from_fn(|k| record[k].parse::<f64>().unwrap_or(f64::NAN))
    };
    reader.records().map(|record| line(record.unwrap())).collect()
}

/// A way to the coefficients.
type Coefficients = fn(f64, f64) -> Result<CreepCoefficients, Error>;

/// Every `step`-th line from `first` on is met within 1 %.
fn compare(coefficients: Coefficients, first: usize, step: usize) {
    let mut largest = [0.0_f64; 4];
    let mut failed = Vec::new();
    for line in table().iter().skip(first).step_by(step) {
        let [axis_ratio, poisson_ratio, ..] = *line;
        let c = coefficients(axis_ratio, poisson_ratio).unwrap();
        for (k, got) in [c.c11, c.c22, c.c23, c.c33].into_iter().enumerate() {
            let error = (got / line[5 + k] - 1.0).abs();
            largest[k] = largest[k].max(error);
            if error > 0.01 {
                failed.push((axis_ratio, poisson_ratio, k, got, line[5 + k]));
            }
        }
    }
    println!("largest errors of C11, C22, C23, C33: {largest:.4?}");
    assert!(failed.is_empty(), "{failed:#?}");
}

/// Kalker 1990, Table E.3, converged with CONTACT: a/b from 0.1 to 10 and ν from 0 to ½.
#[test]
fn kalker_1990_creep_coefficients() {
    compare(creep_coefficients, 0, 9);
}

/// The same, all 76 lines.
#[test]
#[ignore = "long: cargo xtask long"]
fn kalker_1990_all_creep_coefficients() {
    compare(creep_coefficients, 0, 1);
}

/// The table meets all 76 lines, too.
#[test]
fn kalker_1990_interpolated_creep_coefficients() {
    compare(interpolated_coefficients, 0, 1);
}

fn values(c: &CreepCoefficients) -> [f64; 4] {
    [c.c11, c.c22, c.c23, c.c33]
}

/// Largest relative difference between table and computation, of the first `count` coefficients.
fn gap(axis_ratio: f64, poisson_ratio: f64, count: usize) -> f64 {
    let exact = values(&creep_coefficients(axis_ratio, poisson_ratio).unwrap());
    let table = values(&interpolated_coefficients(axis_ratio, poisson_ratio).unwrap());
    let gaps =
        exact.iter().zip(table).take(count).map(|(exact, table)| (table / exact - 1.0).abs());
    gaps.fold(0.0, f64::max)
}

/// Between its nodes the table is within 0.1 % of the computation; ν = 0 and ½ lie outside of all
/// nodes.
#[test]
#[ignore = "long: cargo xtask long"]
fn the_table_is_exact_between_its_nodes() {
    for (axis_ratio, poisson_ratio) in
        [(0.1, 0.5), (0.17, 0.03), (0.5, 0.28), (1.7, 0.0), (7.9, 0.41)]
    {
        let gap = gap(axis_ratio, poisson_ratio, 4);
        println!("{axis_ratio} {poisson_ratio}: {gap:.1e}");
        assert!(gap < 1e-3, "{axis_ratio} {poisson_ratio}: {gap}");
    }
}

/// Beyond its ends it follows Kalker's limits, continuously: C11, C22 and C23 within 7 % at a/b =
/// 1/30 and 30.
#[test]
#[ignore = "long: cargo xtask long"]
fn the_table_goes_on_as_kalkers_limits() {
    for (axis_ratio, poisson_ratio) in
        [(1.0 / 30.0, 0.28), (30.0, 0.28), (1.0 / 30.0, 0.5), (30.0, 0.0)]
    {
        let gap = gap(axis_ratio, poisson_ratio, 3);
        println!("{axis_ratio} {poisson_ratio}: {gap:.1e}");
        assert!(gap < 0.07, "{axis_ratio} {poisson_ratio}: {gap}");
    }
    for end in [0.1_f64, 10.0] {
        let [inside, outside] = [end.powf(1.0 - 1e-9), end.powf(1.0 + 1e-9)]
            .map(|ratio| values(&interpolated_coefficients(ratio, 0.28).unwrap()));
        for (inside, outside) in inside.iter().zip(outside) {
            assert!((outside / inside - 1.0).abs() < 1e-7, "{end}");
        }
    }
    let extreme = interpolated_coefficients(1e-6, 0.25).unwrap();
    assert!(values(&extreme).iter().all(|c| *c > 0.0 && c.is_finite()), "{extreme:?}");
}

/// Number of Chebyshev polynomials in ln(a/b) and in ν.
const RATIOS: usize = 12;
const POISSON_RATIOS: usize = 5;

/// Makes `src/kalker_coefficients/table.rs` from direct computations at the zeros of Chebyshev's
/// polynomials; with SCHLUPF_PIN=1 it writes the numbers, and it compares with what was there.
#[test]
#[ignore = "long: cargo xtask long"]
fn the_table_is_that_of_the_computation() {
    let node = |k: usize, n: usize| (PI * (k as f64 + 0.5) / n as f64).cos();
    let mut logarithms = vec![[[0.0; POISSON_RATIOS]; RATIOS]; 4];
    for i in 0..RATIOS {
        for j in 0..POISSON_RATIOS {
            let ratio = 10.0_f64.powf(node(i, RATIOS));
            let c = creep_coefficients(ratio, 0.25 * (1.0 + node(j, POISSON_RATIOS))).unwrap();
            for (values, c) in logarithms.iter_mut().zip([c.c11, c.c22, c.c23, c.c33]) {
                values[i][j] = c.ln();
            }
        }
    }
    let polynomial = |degree: usize, k: usize, n: usize| {
        let norm = if degree == 0 { 1.0 } else { 2.0 } / n as f64;
        norm * (PI * degree as f64 * (k as f64 + 0.5) / n as f64).cos()
    };
    let head = "pub(super) const CHEBYSHEV: [[[f64; POISSON_RATIOS]; RATIOS]; 4] = [\n";
    let mut text = head.to_owned();
    for values in &logarithms {
        text.push_str("    [\n");
        for m in 0..RATIOS {
            let coefficient = |n: usize| -> f64 {
                let terms = (0..RATIOS * POISSON_RATIOS).map(|k| {
                    let (i, j) = (k / POISSON_RATIOS, k % POISSON_RATIOS);
                    values[i][j] * polynomial(m, i, RATIOS) * polynomial(n, j, POISSON_RATIOS)
                });
                terms.sum()
            };
            let row: Vec<String> =
                (0..POISSON_RATIOS).map(|n| format!("{:.7}", coefficient(n))).collect();
            writeln!(text, "        [{}],", row.join(", ")).unwrap();
        }
        text.push_str("    ],\n");
    }
    text.push_str("];\n");
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("src/solver/kalker_coefficients/table.rs");
    let old = std::fs::read_to_string(&file).unwrap();
    let start = old.find(head).unwrap();
    if std::env::var_os("SCHLUPF_PIN").is_some() {
        std::fs::write(&file, old[..start].to_owned() + &text).unwrap();
    }
    assert_eq!(old[start..], text);
}
