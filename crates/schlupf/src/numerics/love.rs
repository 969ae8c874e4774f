//! Integrals of a kernel over a rectangle from sums over its corners (Love 1929).
//!
//! The integral over the rectangle is K(x₂, y₂) − K(x₂, y₁) − K(x₁, y₂) + K(x₁, y₁), where K is the
//! integral of the kernel from the origin to a corner. For y²/r³ and x²/r³ K is X asinh(Y/|X|) and
//! Y asinh(X/|Y|), for 1/r their sum. (With logarithms of Y + r, as it is usually written, slender
//! rectangles lose seven digits.)

/// X asinh(Y/|X|) and Y asinh(X/|Y|), in the unit of X and Y.
pub(crate) fn corner([x, y]: [f64; 2]) -> [f64; 2] {
    let times_asinh = |p: f64, q: f64| if p == 0.0 { 0.0 } else { p * (q / p.abs()).asinh() };
    [times_asinh(x, y), times_asinh(y, x)]
}

/// π G A_xx and π G A_yy of half-spaces from the two integrals for y²/r³ and x²/r³, in their unit.
pub(crate) fn tangential(poisson_ratio: f64, [along, across]: [f64; 2]) -> [f64; 2] {
    [(1.0 - poisson_ratio) * along + across, along + (1.0 - poisson_ratio) * across]
}

/// ½ (A_yy − A_nn) and ½ (A_yy + A_nn) of half-spaces, in their unit, from A_xx and A_yy: A_nn = (1
/// − ν)/(2 − ν) (A_xx + A_yy).
pub(crate) fn halves(poisson_ratio: f64, [xx, yy]: [f64; 2]) -> [f64; 2] {
    let normal = (1.0 - poisson_ratio) / (2.0 - poisson_ratio) * (xx + yy);
    [0.5 * (yy - normal), 0.5 * (yy + normal)]
}

/// The integrals over a rectangle from those to its corners, row by row.
pub(crate) fn rectangle<const N: usize>([[a, b], [c, d]]: [[[f64; N]; 2]; 2]) -> [f64; N] {
    std::array::from_fn(|k| d[k] - b[k] - c[k] + a[k])
}

/// The integrals over the cells of a regular lattice, whose first cell is centred at the origin,
/// row after row. Each corner is evaluated once.
pub(crate) fn cells<const N: usize>(
    spacing: [f64; 2],
    [columns, rows]: [usize; 2],
    corner: impl Fn([f64; 2]) -> [f64; N],
) -> Vec<[f64; N]> {
    let line = |j: usize| -> Vec<[f64; N]> {
        let y = (j as f64 - 0.5) * spacing[1];
        (0..=columns).map(|i| corner([(i as f64 - 0.5) * spacing[0], y])).collect()
    };
    let mut integrals = Vec::with_capacity(columns * rows);
    let mut below = line(0);
    for j in 1..=rows {
        let above = line(j);
        let pairs = below.windows(2).zip(above.windows(2));
        integrals.extend(pairs.map(|(b, a)| rectangle([[b[0], b[1]], [a[0], a[1]]])));
        below = above;
    }
    integrals
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Love 1929: ∫ dA/r over a square of half-side 1 about its centre is 8 asinh 1, and cells
    /// evaluated together give the same integrals as each on its own.
    #[test]
    fn love_1929_a_square() {
        let potential = |at: [f64; 2]| [corner(at).iter().sum::<f64>()];
        let square = cells([2.0, 2.0], [1, 1], potential);
        assert!((square[0][0] - 8.0 * 1.0_f64.asinh()).abs() < 1e-14);
        let parts = cells([2.0 / 3.0, 1.0], [2, 1], potential);
        let [whole, narrow] = [3.0, 1.0].map(|x: f64| {
            let at = |x: f64, y: f64| potential([x / 3.0, y]);
            rectangle([[at(-x, -0.5), at(x, -0.5)], [at(-x, 0.5), at(x, 0.5)]])[0]
        });
        assert!((parts[0][0] - narrow).abs() < 1e-14);
        assert!((parts[0][0] + 2.0 * parts[1][0] - whole).abs() < 1e-14);
    }
}
