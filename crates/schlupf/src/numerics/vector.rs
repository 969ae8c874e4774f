//! Products, norms and sums of vectors.

/// Number of partial sums accumulated side by side.
const LANES: usize = 8;

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

/// v ← v + factor · w
pub(crate) fn add_scaled(v: &mut [f64], factor: f64, w: &[f64]) {
    for (v, w) in v.iter_mut().zip(w) {
        *v += factor * w;
    }
}
