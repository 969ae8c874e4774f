//! Cubic splines: interpolating (without a knot next to the ends) and smoothing (Reinsch 1967).

/// Slopes at the knots of the cubic spline through `values` at ascending `positions`; the third
/// derivative is continuous at the knots next to both ends, so up to cubics it is exact everywhere
/// (de Boor 1978). Per unit of the positions. There must be at least two knots.
pub(super) fn slopes(positions: &[f64], values: &[f64]) -> Vec<f64> {
    let last = positions.len() - 1;
    let width: Vec<f64> = positions.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chord: Vec<f64> =
        values.windows(2).zip(&width).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
    match last {
        1 => return vec![chord[0]; 2],
        2 => {
            let bend = (chord[1] - chord[0]) / (width[0] + width[1]);
            let at =
                |k: usize| chord[0] + bend * (2.0 * positions[k] - positions[0] - positions[1]);
            return (0..3).map(at).collect();
        }
        _ => {}
    }
    let mut system = Tridiagonal::with_capacity(last + 1);
    let span = width[0] + width[1];
    let right = (width[0] + 2.0 * span) * width[1] * chord[0] + width[0] * width[0] * chord[1];
    system.push([0.0, width[1], span], right / span);
    for k in 1..last {
        let [before, after] = [width[k - 1], width[k]];
        let right = 3.0 * (after * chord[k - 1] + before * chord[k]);
        system.push([after, 2.0 * (before + after), before], right);
    }
    let [inner, outer] = [width[last - 2], width[last - 1]];
    let span = inner + outer;
    let right = outer * outer * chord[last - 2] + (2.0 * span + outer) * inner * chord[last - 1];
    system.push([span, inner, 0.0], right / span);
    system.solve()
}

/// Weights of all values, in the value and in the slope at a knot k, of the cubic B-spline that has
/// the values at ascending `positions` as control points; at the ends it goes on straight. There
/// must be at least two positions; slopes are per unit of them.
pub(super) fn control(positions: &[f64], k: usize) -> (Vec<f64>, Vec<f64>) {
    let last = positions.len() - 1;
    // Beyond the ends, steps are as long as the last one.
    let width = |j: isize| {
        let j = j.clamp(0, last as isize - 1) as usize;
        positions[j + 1] - positions[j]
    };
    let k_signed = k as isize;
    let [h0, h1, h2, h3] = [-2, -1, 0, 1].map(|by| width(k_signed + by));
    let (before, after) = ((h1 + h2) * (h0 + h1 + h2), (h1 + h2) * (h1 + h2 + h3));
    let [low, high] = [h2 * h2 / before, h1 * h1 / after];
    let [low_slope, high_slope] = [-3.0 * h2 / before, 3.0 * h1 / after];
    let spread = |[low, own, high]: [f64; 3]| {
        let mut weights = vec![0.0; last + 1];
        weights[k] += own;
        for (weight, is_there, beside) in
            [(low, k > 0, k_signed - 1), (high, k < last, k_signed + 1)]
        {
            let mirrored = (2 * k_signed - beside) as usize;
            if is_there {
                weights[beside as usize] += weight;
            } else {
                weights[k] += 2.0 * weight;
                weights[mirrored] -= weight;
            }
        }
        weights
    };
    (
        spread([low, 1.0 - low - high, high]),
        spread([low_slope, -low_slope - high_slope, high_slope]),
    )
}

/// A tridiagonal system, eliminated as it is written.
struct Tridiagonal {
    /// Each row after elimination: the factor of the next unknown, and the right side.
    rows: Vec<[f64; 2]>,
}

impl Tridiagonal {
    fn with_capacity(rows: usize) -> Self {
        Self { rows: Vec::with_capacity(rows) }
    }

    fn push(&mut self, [before, own, after]: [f64; 3], right: f64) {
        let [factor, above] = self.rows.last().copied().unwrap_or_default();
        let pivot = own - before * factor;
        self.rows.push([after / pivot, (right - before * above) / pivot]);
    }

    fn solve(self) -> Vec<f64> {
        let mut next = 0.0;
        let back = self.rows.iter().rev().map(|[factor, right]| {
            next = right - factor * next;
            next
        });
        let mut solution: Vec<f64> = back.collect();
        solution.reverse();
        solution
    }
}

/// Values of the smoothing spline f at the ascending `positions`, which minimises
///
/// Σ wₖ (valueₖ − f(sₖ))² + λ ∫ f″² ds,   λ = (L/2π)⁴,
///
/// where wₖ is the length that a knot stands for (Reinsch 1967). A wave of length L is halved; one
/// of twice that length loses 6 %. `length` is L, in the unit of the positions.
pub(super) fn smoothed(positions: &[f64], values: &[f64], length: f64) -> Vec<f64> {
    let count = positions.len();
    if length <= 0.0 || count < 3 {
        return values.to_vec();
    }
    let lambda = (length / std::f64::consts::TAU).powi(4);
    let width: Vec<f64> = positions.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let weight = |k: usize| {
        0.5 * (k.checked_sub(1).map_or(0.0, |k| width[k]) + width.get(k).copied().unwrap_or(0.0))
    };
    let over: Vec<f64> = (0..count).map(|k| lambda / weight(k)).collect();
    // Second differences of interior knot k + 1 at the knots k, k + 1, k + 2.
    let difference = |k: usize| {
        let [before, after] = [width[k].recip(), width[k + 1].recip()];
        [before, -before - after, after]
    };
    let inner = count - 2;
    let mut bands = vec![[0.0; 3]; inner];
    let mut right = vec![0.0; inner];
    for k in 0..inner {
        let own = difference(k);
        right[k] = (0..3).map(|i| own[i] * values[k + i]).sum();
        bands[k][0] = (width[k] + width[k + 1]) / 3.0
            + (0..3).map(|i| own[i] * own[i] * over[k + i]).sum::<f64>();
        if k + 1 < inner {
            let next = difference(k + 1);
            bands[k][1] = width[k + 1] / 6.0
                + own[1] * next[0] * over[k + 1]
                + own[2] * next[1] * over[k + 2];
        }
        if k + 2 < inner {
            bands[k][2] = own[2] * difference(k + 2)[0] * over[k + 2];
        }
    }
    solve_banded(&mut bands, &mut right);
    let mut smooth = values.to_vec();
    for (k, curvature) in right.iter().enumerate() {
        for (i, part) in difference(k).into_iter().enumerate() {
            smooth[k + i] -= over[k + i] * part * curvature;
        }
    }
    smooth
}

/// Solves a symmetric, positive definite system of which each row has its diagonal and the two
/// entries right of it: L D Lᵀ in place.
fn solve_banded(bands: &mut [[f64; 3]], right: &mut [f64]) {
    let count = right.len();
    for k in 0..count {
        let [pivot, one, two] = bands[k];
        let factors = [one / pivot, two / pivot];
        if k + 1 < count {
            bands[k + 1][0] -= factors[0] * one;
            bands[k + 1][1] -= factors[0] * two;
            right[k + 1] -= factors[0] * right[k];
        }
        if k + 2 < count {
            bands[k + 2][0] -= factors[1] * two;
            right[k + 2] -= factors[1] * right[k];
        }
        bands[k] = [pivot, factors[0], factors[1]];
    }
    for k in (0..count).rev() {
        let [pivot, one, two] = bands[k];
        let after = |by: usize| right.get(k + by).copied().unwrap_or(0.0);
        right[k] = right[k] / pivot - one * after(1) - two * after(2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// de Boor 1978: a spline without a knot next to the ends reproduces cubics on any spacing.
    #[test]
    fn de_boor_1978_cubics_are_exact() {
        let positions = [0.0, 0.3, 1.1, 1.2, 2.5, 3.0];
        let value = |s: f64| 1.0 - 2.0 * s + 0.5 * s * s + 0.25 * s * s * s;
        let slope = |s: f64| -2.0 + s + 0.75 * s * s;
        for count in [4, 6] {
            let at = &positions[..count];
            let values: Vec<f64> = at.iter().map(|s| value(*s)).collect();
            for (s, found) in at.iter().zip(slopes(at, &values)) {
                assert!((found - slope(*s)).abs() < 1e-13, "{found} at {s}");
            }
        }
        let parabola: Vec<f64> = positions[..3].iter().map(|s| s * s).collect();
        for (s, found) in positions.iter().zip(slopes(&positions[..3], &parabola)) {
            assert!((found - 2.0 * s).abs() < 1e-14);
        }
    }

    /// Reinsch 1967: straight lines stay, and a wave of length Λ is divided by 1 + (L/Λ)⁴.
    #[test]
    fn reinsch_1967_waves_lose_what_their_length_says() {
        let positions: Vec<f64> = (0..4001).map(|k| 0.01 * f64::from(k)).collect();
        for (ratio, share) in [(1.0, 0.5), (0.5, 16.0 / 17.0), (2.0, 1.0 / 17.0)] {
            let wave = |s: f64| (std::f64::consts::TAU * s / 2.0).sin();
            let values: Vec<f64> = positions.iter().map(|s| 3.0 - 2.0 * s + wave(*s)).collect();
            let smooth = smoothed(&positions, &values, 2.0 * ratio);
            for (s, found) in positions.iter().zip(&smooth).skip(1500).take(1000) {
                let expected = 3.0 - 2.0 * s + share * wave(*s);
                assert!((found - expected).abs() < 1e-3, "{ratio}: {found} {expected}");
            }
        }
    }
}
