//! A slider with bristles in series as one equation of a cell, if what its material has done before
//! is known.
//!
//! With γ the stiffness of a cell and s its sliding, the traction follows from the pull p + γ s:
//! the bristles take up what they stretch by, and the slider the rest if |p| = μ pₙ. The stretch is
//! in the direction of p but for what is known, so that only the size of p is to be found. Where
//! the bound is small the stretch is a steep function of p, but p a smooth one of the pull.

use super::reduction::{Slope, reduced};
use super::stretch::Stretch;

/// What stretches the bristles over the last way of a path: W(q) + n W(z) (the latter where z
/// grows), as far as it is known from earlier places.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Series {
    /// Weight of q and z at the cell, dimensionless.
    pub weight: f64,
    /// The part of W(q) from earlier places, dimensionless.
    pub saturation: [f64; 2],
    /// The part of W(z) from earlier places, dimensionless.
    pub excess: f64,
}

/// Most evaluations of a saturation; most take four.
const EVALUATIONS: usize = 60;

/// Relative accuracy of a saturation.
const ACCURACY: f64 = 1e-13;

impl Series {
    /// The traction (in Pa) under a pull for a bound μ pₙ, both in Pa, with its derivatives at that
    /// bound; with bristles for which γ/k_c is `compliance`, in Pa.
    pub fn traction(&self, pull: [f64; 2], bound: f64, compliance: f64) -> ([f64; 2], Slope) {
        if compliance == 0.0 {
            return (reduced(pull, bound), Slope::at(pull, bound));
        }
        let pull = [0, 1].map(|c| pull[c] - compliance * self.saturation[c]);
        let length = (pull[0] * pull[0] + pull[1] * pull[1]).sqrt();
        let along = Along { series: self, bound, compliance };
        let (most, _) = along.pull(1.0);
        if length >= most {
            let n = pull.map(|pull| pull / length);
            return (n.map(|n| n * bound), Slope::of_sliding(n, bound / length));
        }
        let (size, stiffness) = along.saturation(length);
        let secant = if length > 0.0 { bound * size / length } else { bound / stiffness };
        let n = pull.map(|pull| if length > 0.0 { pull / length } else { 0.0 });
        let by_pull = [0, 1].map(|r| {
            [0, 1].map(|c| {
                let across = if r == c { secant } else { 0.0 };
                across + (bound / stiffness - secant) * n[r] * n[c]
            })
        });
        // A time step takes the bound as given: its derivative only says whether the cell slides.
        (pull.map(|pull| secant * pull), Slope { by_pull, by_bound: [0.0; 2] })
    }
}

/// The equation along the traction.
struct Along<'a> {
    series: &'a Series,
    /// μ pₙ, in Pa.
    bound: f64,
    /// γ/k_c, in Pa.
    compliance: f64,
}

impl Along<'_> {
    /// Pull (in Pa) at a saturation, without what is known of q, and its derivative.
    fn pull(&self, size: f64) -> (f64, f64) {
        let Series { weight, excess, .. } = self.series;
        let at = Stretch::of([size, 0.0], 1.0);
        let growth = Stretch::growth(weight * at.excess, *excess);
        let change = at.saturation_change([1.0, 0.0], 0.0);
        let (n, turn) = (at.direction[0], at.turn_of_size(change[0]));
        let stretch = weight * size + n * growth.value;
        let grown = growth.change(weight * at.excess_change(change), 0.0);
        let by_size = weight + turn * growth.value + n * grown;
        (self.bound * size + self.compliance * stretch, self.bound + self.compliance * by_size)
    }

    /// The saturation under a pull (in Pa) that is less than that of sliding, with the derivative
    /// of the pull there, in Pa; by Newton's method within a bracket, because the pull grows with
    /// the saturation.
    fn saturation(&self, pull: f64) -> (f64, f64) {
        let (mut low, mut high) = (0.0, 1.0);
        let mut size = pull / (pull + self.pull(1.0).0);
        let mut stiffness = self.bound;
        for _ in 0..EVALUATIONS {
            let (reached, by_size) = self.pull(size);
            stiffness = by_size;
            let missing = pull - reached;
            if missing.abs() <= ACCURACY * pull || high - low <= ACCURACY * size {
                break;
            }
            if missing > 0.0 {
                low = size;
            } else {
                high = size;
            }
            let next = size + missing / by_size;
            size = if next > low && next < high { next } else { 0.5 * (low + high) };
        }
        (size, stiffness)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const BOUND: f64 = 50.0;
    const COMPLIANCE: f64 = 12.0;

    /// The last two make every case slide.
    const PULLS: [[f64; 2]; 7] = [
        [3.0, -2.0],
        [30.0, 20.0],
        [60.0, -40.0],
        [-0.01, 0.02],
        [1e-7, 0.0],
        [300.0, -400.0],
        [-200.0, 100.0],
    ];

    fn cases() -> Vec<Series> {
        let fresh = Series { weight: 1.0, ..Series::default() };
        let grows = Series { weight: 1.8, saturation: [-0.7, 0.2], excess: -0.4 };
        let falls = Series { weight: 1.5, saturation: [-1.4, 0.3], excess: -4.0 };
        let fell_fast = Series { weight: 11.0 / 6.0, saturation: [-1.7, 0.1], excess: 0.8 };
        vec![fresh, grows, falls, fell_fast]
    }

    /// In stick the traction solves p + γ/k_c (W(q) + n W(z)) = pull, with the growth of z for
    /// W(z); in slip it is the bound, along what is left of the pull.
    #[test]
    fn bristles_take_up_the_pull() {
        for series in cases() {
            for pull in PULLS {
                let (p, slope) = series.traction(pull, BOUND, COMPLIANCE);
                let at = Stretch::of(p, BOUND);
                let grown = Stretch::growth(series.weight * at.excess, series.excess).value;
                let left = [0, 1].map(|c| {
                    let q = series.weight * at.saturation[c] + series.saturation[c];
                    pull[c] - COMPLIANCE * (q + at.direction[c] * grown) - p[c]
                });
                assert_eq!(
                    slope.is_sliding(),
                    pull[0].hypot(pull[1]) > 200.0,
                    "{series:?} {pull:?}"
                );
                if slope.is_sliding() {
                    assert_relative_eq!(p[0].hypot(p[1]), BOUND, max_relative = 1e-12);
                    assert!(left[0] * p[0] + left[1] * p[1] > 0.0, "{left:?}");
                    let aside = left[0] * p[1] - left[1] * p[0];
                    assert!(aside.abs() < 1e-9 * BOUND * BOUND, "{left:?}");
                } else {
                    assert!(left[0].hypot(left[1]) < 1e-9, "{series:?} {pull:?} {left:?}");
                }
            }
        }
    }

    /// The traction follows the pull smoothly through zero, also where it was large before.
    #[test]
    fn nothing_jumps_where_the_traction_vanishes() {
        for series in cases() {
            let known = series.saturation.map(|q| COMPLIANCE * q);
            let at =
                |pull: f64| series.traction([known[0] + pull, known[1]], BOUND, COMPLIANCE).0[0];
            let slope = at(1e-3) / 1e-3;
            assert_relative_eq!(at(-1e-3), -at(1e-3), max_relative = 1e-9);
            for pull in [1e-2, 1e-1, 1.0] {
                assert_relative_eq!(at(pull) / pull, slope, max_relative = 0.02);
            }
        }
    }

    /// The derivatives against central differences, in stick and in slip.
    #[test]
    fn slopes_are_those_of_central_differences() {
        const H: f64 = 1e-4;
        for series in cases() {
            for pull in [[3.0, -2.0], [30.0, 20.0], [90.0, -80.0], [300.0, 400.0]] {
                let (_, slope) = series.traction(pull, BOUND, COMPLIANCE);
                for c in 0..2 {
                    let moved = |h: f64| {
                        let mut pull = pull;
                        pull[c] += h;
                        series.traction(pull, BOUND, COMPLIANCE).0
                    };
                    let (plus, minus) = (moved(H), moved(-H));
                    for r in 0..2 {
                        let by_pull = (plus[r] - minus[r]) / (2.0 * H);
                        assert_relative_eq!(slope.by_pull[r][c], by_pull, epsilon = 1e-6);
                    }
                }
            }
        }
    }
}
