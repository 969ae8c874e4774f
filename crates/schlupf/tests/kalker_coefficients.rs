//! Kalker's creep coefficients against tables.

use std::path::Path;

use schlupf::kalker_coefficients::creep_coefficients;

/// Lines of `data/kalker_coefficients.csv`: a/b, ν, then C11, C22, C23 as printed and C11, C22, C23, C33
/// converged; NaN where empty.
fn table() -> Vec<[f64; 9]> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/kalker_coefficients.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file).unwrap();
    let line = |record: csv::StringRecord| {
        std::array::from_fn(|k| record[k].parse::<f64>().unwrap_or(f64::NAN))
    };
    reader.records().map(|record| line(record.unwrap())).collect()
}

/// Every `step`-th line from `first` on is met within 1 %, for a/b = 10 within 2 %.
fn compare(first: usize, step: usize) {
    let mut largest = [[0.0_f64; 4]; 2];
    let mut failed = Vec::new();
    for line in table().iter().skip(first).step_by(step) {
        let [axis_ratio, poisson_ratio, ..] = *line;
        let c = creep_coefficients(axis_ratio, poisson_ratio).unwrap();
        let is_long = axis_ratio >= 10.0;
        let allowed = if is_long { 0.02 } else { 0.01 };
        for (k, got) in [c.c11, c.c22, c.c23, c.c33].into_iter().enumerate() {
            let error = (got / line[5 + k] - 1.0).abs();
            let so_far = &mut largest[usize::from(is_long)][k];
            *so_far = so_far.max(error);
            if error > allowed {
                failed.push((axis_ratio, poisson_ratio, k, got, line[5 + k]));
            }
        }
    }
    println!("largest errors of C11, C22, C23, C33: {largest:.4?} (a/b below 10; 10)");
    assert!(failed.is_empty(), "{failed:#?}");
}

/// Kalker 1990, Table E.3, converged with CONTACT: a/b from 0.1 to 10 and ν from 0 to ½.
#[test]
fn kalker_1990_creep_coefficients() {
    compare(0, 9);
}

/// The same, all 76 lines.
#[test]
#[ignore = "takes a minute"]
fn kalker_1990_all_creep_coefficients() {
    compare(0, 1);
}
