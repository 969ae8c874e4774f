//! Smooth curves through points.

/// Points on a smooth curve through the given ones, in order of increasing x: cubic between two
/// points, with slopes that prevent overshoots and oscillations (Fritsch and Butland, *SIAM J. Sci.
/// Stat. Comput.* 5, 1984). The curve is interrupted where points are not finite, and straight
/// where x does not change.
pub(crate) fn smooth(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    /// Number of pieces between two points.
    const PIECES: u32 = 8;
    let mut curve = Vec::with_capacity(points.len() * PIECES as usize);
    for k in 1..points.len() {
        let ([from, to], width) = ([points[k - 1], points[k]], points[k][0] - points[k - 1][0]);
        let slopes = [slope(points, k - 1), slope(points, k)];
        curve.push(from);
        if width == 0.0 || !slopes.iter().all(|slope| slope.is_finite()) {
            continue;
        }
        for piece in 1..PIECES {
            let t = f64::from(piece) / f64::from(PIECES);
            let rest = 1.0 - t;
            let y = rest * rest * ((1.0 + 2.0 * t) * from[1] + t * width * slopes[0])
                + t * t * ((1.0 + 2.0 * rest) * to[1] - rest * width * slopes[1]);
            curve.push([from[0] + t * width, y]);
        }
    }
    curve.extend(points.last());
    curve
}

/// Slope at a point: a harmonic mean of those before and after it, zero at a local extremum.
fn slope(points: &[[f64; 2]], k: usize) -> f64 {
    let secant = |k: usize| {
        let [before, after] = [points.get(k)?, points.get(k + 1)?];
        let secant = (after[1] - before[1]) / (after[0] - before[0]);
        secant.is_finite().then_some([after[0] - before[0], secant])
    };
    match (k.checked_sub(1).and_then(secant), secant(k)) {
        (None, None) => f64::NAN,
        (Some([_, slope]), None) | (None, Some([_, slope])) => slope,
        (Some([_, one]), Some([_, other])) if one * other <= 0.0 => 0.0,
        (Some([before, one]), Some([after, other])) => {
            let weight = (before + 2.0 * after) / (3.0 * (before + after));
            one * other / (weight * other + (1.0 - weight) * one)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::smooth;

    #[test]
    fn a_smooth_curve_goes_through_its_points_and_not_beyond_them() {
        let points = [[0.0, 0.0], [0.1, 1.0], [0.3, 1.2], [1.0, 0.5], [2.0, 0.5]];
        let curve = smooth(&points);
        assert!(points.iter().all(|point| curve.contains(point)));
        assert!(curve.windows(2).all(|pair| pair[1][0] > pair[0][0]));
        assert!(curve.iter().all(|point| (0.0..=1.2).contains(&point[1])));
        let backwards: Vec<[f64; 2]> = points.iter().rev().copied().collect();
        assert!(smooth(&backwards).iter().all(|point| (0.0..=1.2).contains(&point[1])));
    }

    #[test]
    fn a_line_stays_a_line_and_gaps_stay_gaps() {
        for [x, y] in smooth(&[[0.0, 1.0], [1.0, 3.0], [4.0, 9.0]]) {
            assert!((y - 1.0 - 2.0 * x).abs() < 1e-14);
        }
        let broken = smooth(&[[0.0, 1.0], [1.0, f64::NAN], [2.0, 1.0], [3.0, 2.0]]);
        assert_eq!(broken.iter().filter(|point| !point[1].is_finite()).count(), 1);
        assert_eq!(smooth(&[[0.0, 1.0]]), [[0.0, 1.0]]);
        assert_eq!(smooth(&[]), [[0.0; 2]; 0]);
    }
}
