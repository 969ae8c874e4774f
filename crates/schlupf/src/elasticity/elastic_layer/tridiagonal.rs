//! Symmetric tridiagonal systems along y, of both components and all wave numbers side by side.

use rustfft::num_complex::Complex;

/// Values of both components: that of x as the real part, that of y as the imaginary part. The type
/// only serves to transform both at once along x; products of two such values are meaningless.
pub(super) type Pair = Complex<f64>;

/// Componentwise product of two pairs.
pub(super) fn each(a: Pair, b: Pair) -> Pair {
    Pair::new(a.re * b.re, a.im * b.im)
}

/// Factors of the systems, row after row, each for all wave numbers.
pub(super) struct Tridiagonal {
    inverse_pivot: Vec<Pair>,
    /// The ratio of the coupling to the next row to the pivot.
    ratio: Vec<Pair>,
}

impl Tridiagonal {
    /// Factorises systems of `rows` rows with the off-diagonal −`coupling`. `bedding` is the
    /// diagonal without the coupling between the rows, `outside` the contribution from beyond the
    /// first and the last row.
    pub(super) fn new(bedding: &[Pair], coupling: Pair, rows: usize, outside: &[Pair]) -> Self {
        let waves = bedding.len();
        let mut inverse_pivot: Vec<Pair> = Vec::with_capacity(rows * waves);
        for row in 0..rows {
            let ends = usize::from(row == 0) + usize::from(row + 1 == rows);
            for wave in 0..waves {
                let mut pivot = bedding[wave] + coupling * (2 - ends) as f64;
                pivot += outside[wave] * ends as f64;
                if row > 0 {
                    let above = inverse_pivot[(row - 1) * waves + wave];
                    pivot -= each(each(coupling, coupling), above);
                }
                inverse_pivot.push(Pair::new(pivot.re.recip(), pivot.im.recip()));
            }
        }
        let ratio = inverse_pivot.iter().map(|inverse| each(coupling, *inverse)).collect();
        Self { inverse_pivot, ratio }
    }

    /// Solves all systems in place.
    pub(super) fn solve(&self, values: &mut [Pair], waves: usize) {
        let last = values.len() - waves;
        for start in (waves..=last).step_by(waves) {
            let (above, here) = values.split_at_mut(start);
            let ratios = &self.ratio[start - waves..start];
            let sides = here[..waves].iter_mut().zip(&above[start - waves..]);
            for ((here, above), ratio) in sides.zip(ratios) {
                *here += each(*ratio, *above);
            }
        }
        for (value, inverse) in values[last..].iter_mut().zip(&self.inverse_pivot[last..]) {
            *value = each(*value, *inverse);
        }
        for start in (0..last).step_by(waves).rev() {
            let (here, below) = values.split_at_mut(start + waves);
            let row = start..start + waves;
            let factors = self.inverse_pivot[row.clone()].iter().zip(&self.ratio[row.clone()]);
            for ((here, below), (inverse, ratio)) in here[row].iter_mut().zip(below).zip(factors) {
                *here = each(*here, *inverse) + each(*ratio, *below);
            }
        }
    }
}
