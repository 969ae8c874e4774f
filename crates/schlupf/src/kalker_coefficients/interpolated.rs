//! The coefficients from a table, for methods that need them within a microsecond.

use std::f64::consts::PI;

use super::table::{CHEBYSHEV, POISSON_RATIOS, RATIOS};
use super::{CreepCoefficients, check};
use crate::error::Error;

/// Semi-axes' ratios that the table spans: from 1/10 to 10.
const LARGEST_RATIO: f64 = 10.0;

/// The same as [`creep_coefficients`](super::creep_coefficients) within a microsecond and without
/// memory of its own: from a table of it, made by the program, in Chebyshev polynomials of ln(a/b)
/// and ν.
///
/// For a/b (dimensionless) from 0.1 to 10 and any ν (dimensionless) it is within 0.1 % of the
/// computation it is made from, and so within 1 % of the half-space. More slender ellipses go on
/// from the ends of the table as Kalker's limits do (1967; 1990, Table E.3): C11, C22 and C23 are
/// within 7 % of the computation at a/b = 1/30 and 30; of C33 there is only the limit.
pub fn interpolated_coefficients(
    axis_ratio: f64,
    poisson_ratio: f64,
) -> Result<CreepCoefficients, Error> {
    check(axis_ratio, poisson_ratio)?;
    let inside = axis_ratio.clamp(LARGEST_RATIO.recip(), LARGEST_RATIO);
    let mut values = tabulated(inside, poisson_ratio);
    if inside != axis_ratio {
        let limits = [axis_ratio, inside].map(|ratio| slender(ratio, poisson_ratio));
        for (value, (there, here)) in values.iter_mut().zip(limits[0].iter().zip(&limits[1])) {
            *value *= there / here;
        }
    }
    let [c11, c22, c23, c33] = values;
    Ok(CreepCoefficients { c11, c22, c23, c33 })
}

/// Whether the table spans an axes' ratio a/b (dimensionless), but for rounding.
pub(crate) fn is_tabulated(axis_ratio: f64) -> bool {
    const ROUNDING: f64 = 1e-9;
    axis_ratio.max(axis_ratio.recip()) <= LARGEST_RATIO * (1.0 + ROUNDING)
}

/// exp Σ c_ij T_i(ln(a/b)/ln 10) T_j(4ν − 1) for each of C11, C22, C23, C33.
fn tabulated(axis_ratio: f64, poisson_ratio: f64) -> [f64; 4] {
    let x = axis_ratio.ln() / LARGEST_RATIO.ln();
    let along: [f64; RATIOS] = polynomials(x);
    let across: [f64; POISSON_RATIOS] = polynomials(4.0 * poisson_ratio - 1.0);
    CHEBYSHEV.map(|coefficients| {
        let rows = coefficients.iter().zip(along);
        let sum = |row: &[f64; POISSON_RATIOS]| -> f64 {
            row.iter().zip(across).map(|(c, polynomial)| c * polynomial).sum()
        };
        rows.map(|(row, polynomial)| polynomial * sum(row)).sum::<f64>().exp()
    })
}

/// T_0(x) … T_(N−1)(x) by T_k = 2x T_(k−1) − T_(k−2).
fn polynomials<const N: usize>(x: f64) -> [f64; N] {
    let mut values = [1.0; N];
    values[1] = x;
    for k in 2..N {
        values[k] = 2.0 * x * values[k - 1] - values[k - 2];
    }
    values
}

/// C11, C22, C23, C33 of slender ellipses, in leading order and one more (Kalker 1967; 1990, Table
/// E.3), with g the smaller of a/b and b/a and Λ = ln(16/g²).
fn slender(axis_ratio: f64, nu: f64) -> [f64; 4] {
    let g = axis_ratio.min(axis_ratio.recip());
    let lambda = (16.0 / (g * g)).ln();
    if axis_ratio < 1.0 {
        let c23 =
            PI * g.sqrt() / 3.0 / (1.0 - nu) * (1.0 + nu * (0.5 * lambda + 4.0_f64.ln() - 5.0));
        return [
            PI * PI / (4.0 * (1.0 - nu)),
            PI * PI / 4.0,
            c23,
            PI * PI / (16.0 * (1.0 - nu) * g),
        ];
    }
    let rest = 3.0 - 4.0_f64.ln();
    let bulk = (1.0 - nu) * lambda + 2.0 * nu;
    let turn = (1.0 - nu) * lambda - 2.0 + 4.0 * nu;
    [
        2.0 * PI / ((lambda - 2.0 * nu) * g) * (1.0 + rest / (lambda - 2.0 * nu)),
        2.0 * PI / g * (1.0 + (1.0 - nu) * rest / bulk) / bulk,
        2.0 * PI / (3.0 * g.powf(1.5)) / turn,
        0.25 * PI * (1.0 - nu * (lambda - 2.0) / turn),
    ]
}
