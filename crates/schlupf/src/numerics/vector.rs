//! Products, norms and sums of vectors.

/// Number of partial sums accumulated side by side.
const LANES: usize = 8;

/// Number of vectors that are worked on at once.
const FOUR: usize = 4;

/// Numbers of each of some vectors that are worked on before the next ones: those of one vector,
/// the sum, and of four others fit into the nearest cache.
const IN_CACHE: usize = 512;

/// v · w of vectors of equal length.
pub(crate) fn dot(v: &[f64], w: &[f64]) -> f64 {
    let (v, w) = (v.chunks_exact(LANES), w.chunks_exact(LANES));
    let rest: f64 = v.remainder().iter().zip(w.remainder()).map(|(v, w)| v * w).sum();
    let mut sums = [0.0; LANES];
    for (v, w) in v.zip(w) {
        for lane in 0..LANES {
            sums[lane] += v[lane] * w[lane];
        }
    }
    sums.iter().sum::<f64>() + rest
}

/// ‖v‖₂
pub(crate) fn norm(v: &[f64]) -> f64 {
    dot(v, v).sqrt()
}

/// ‖v‖₂/√n
pub(crate) fn root_mean_square(v: &[f64]) -> f64 {
    (dot(v, v) / v.len() as f64).sqrt()
}

/// w · v of each of some vectors, all of equal length.
pub(crate) fn dots(w: &[f64], vectors: &[Vec<f64>], products: &mut [f64]) {
    products.fill(0.0);
    for start in (0..w.len()).step_by(IN_CACHE) {
        add_dots(&w[start..], vectors, start, products);
    }
}

/// Products of all pairs of some vectors of equal length: of each vector with those before it and
/// with itself, one vector after another.
pub(crate) fn gram(vectors: &[Vec<f64>], products: &mut Vec<f64>) {
    products.clear();
    products.resize(vectors.len() * (vectors.len() + 1) / 2, 0.0);
    let length = vectors.first().map_or(0, Vec::len);
    for start in (0..length).step_by(IN_CACHE) {
        let mut rest = products.as_mut_slice();
        for (k, w) in vectors.iter().enumerate() {
            let (own, others) = rest.split_at_mut(k + 1);
            add_dots(&w[start..], &vectors[..=k], start, own);
            rest = others;
        }
    }
}

/// Adds the products of the first numbers of `w` with those of some vectors from `start` on.
fn add_dots(w: &[f64], vectors: &[Vec<f64>], start: usize, products: &mut [f64]) {
    let w = &w[..IN_CACHE.min(w.len())];
    let these = start..start + w.len();
    let (fours, sums) = (vectors.chunks_exact(FOUR), products.chunks_exact_mut(FOUR));
    for (four, sums) in fours.zip(sums) {
        let four: [&[f64]; FOUR] = std::array::from_fn(|n| &four[n][these.clone()]);
        for (sum, product) in sums.iter_mut().zip(four_dots(w, four)) {
            *sum += product;
        }
    }
    let done = vectors.len() - vectors.len() % FOUR;
    for (vector, sum) in vectors[done..].iter().zip(&mut products[done..]) {
        *sum += dot(w, &vector[these.clone()]);
    }
}

/// w · v of four vectors: each number of w is loaded once.
fn four_dots(w: &[f64], vectors: [&[f64]; FOUR]) -> [f64; FOUR] {
    let mut sums = [[0.0; FOUR]; FOUR];
    let whole = w.len() - w.len() % FOUR;
    let [a, b, c, d] = vectors.map(|vector| vector[..whole].chunks_exact(FOUR));
    let parts = w[..whole].chunks_exact(FOUR).zip(a.zip(b).zip(c.zip(d)));
    for (w, ((a, b), (c, d))) in parts {
        for lane in 0..FOUR {
            sums[0][lane] += w[lane] * a[lane];
            sums[1][lane] += w[lane] * b[lane];
            sums[2][lane] += w[lane] * c[lane];
            sums[3][lane] += w[lane] * d[lane];
        }
    }
    std::array::from_fn(|n| {
        let rest = w[whole..].iter().zip(&vectors[n][whole..]).map(|(w, v)| w * v);
        sums[n].iter().sum::<f64>() + rest.sum::<f64>()
    })
}

/// v ← v + Σ factor · vector, all of equal length.
pub(crate) fn add_combination(v: &mut [f64], factors: &[f64], vectors: &[Vec<f64>]) {
    for start in (0..v.len()).step_by(IN_CACHE) {
        let end = v.len().min(start + IN_CACHE);
        let v = &mut v[start..end];
        let pairs = (vectors.chunks_exact(FOUR), factors.chunks_exact(FOUR));
        for (four, factor) in pairs.0.zip(pairs.1) {
            let [a, b, c, d] = std::array::from_fn(|n| &four[n][start..end]);
            let parts = a.iter().zip(b).zip(c.iter().zip(d));
            for (v, ((a, b), (c, d))) in v.iter_mut().zip(parts) {
                *v += (factor[0] * a + factor[1] * b) + (factor[2] * c + factor[3] * d);
            }
        }
        let done = vectors.len() - vectors.len() % FOUR;
        for (vector, factor) in vectors[done..].iter().zip(&factors[done..]) {
            add_scaled(v, *factor, &vector[start..end]);
        }
    }
}

/// v ← v + factor · w
pub(crate) fn add_scaled(v: &mut [f64], factor: f64, w: &[f64]) {
    for (v, w) in v.iter_mut().zip(w) {
        *v += factor * w;
    }
}

#[cfg(test)]
mod tests {
    use super::{IN_CACHE, add_combination, dots, gram};

    /// Vectors of small whole numbers, whose sums have no rounding.
    fn vectors(count: usize, length: usize) -> Vec<Vec<f64>> {
        let number = |k: usize, i: usize| ((7 * k + 3 * i + k * i) % 11) as f64 - 5.0;
        (0..count).map(|k| (0..length).map(|i| number(k, i)).collect()).collect()
    }

    fn product(v: &[f64], w: &[f64]) -> f64 {
        v.iter().zip(w).map(|(v, w)| v * w).sum()
    }

    /// Any number of vectors, and lengths that leave something over everywhere.
    #[test]
    fn blocks_of_vectors_as_one_by_one() {
        for length in [0, 1, 6, IN_CACHE, 2 * IN_CACHE + 7] {
            for count in 0..10 {
                let vectors = vectors(count + 1, length);
                let (v, vectors) = (&vectors[count], &vectors[..count]);
                let expected: Vec<_> = vectors.iter().map(|w| product(v, w)).collect();
                let mut products = vec![f64::NAN; count];
                dots(v, vectors, &mut products);
                assert_eq!(products, expected);

                let pairs = vectors.iter().enumerate();
                let expected: Vec<_> =
                    pairs.flat_map(|(k, v)| vectors[..=k].iter().map(|w| product(v, w))).collect();
                gram(vectors, &mut products);
                assert_eq!(products, expected);

                let factors: Vec<_> = (0..count).map(|k| k as f64 - 2.0).collect();
                let mut expected = v.clone();
                for (factor, w) in factors.iter().zip(vectors) {
                    for (sum, w) in expected.iter_mut().zip(w) {
                        *sum += factor * w;
                    }
                }
                let mut sum = v.clone();
                add_combination(&mut sum, &factors, vectors);
                assert_eq!(sum, expected);
            }
        }
    }
}
