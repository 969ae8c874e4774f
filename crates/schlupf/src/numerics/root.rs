//! Roots, minima and fixed points.

/// The interval that remains after so many bisections about the point where `is_below`, which holds
/// at its first end, ceases to hold.
pub(crate) fn bisection(
    [mut low, mut high]: [f64; 2],
    halvings: u32,
    is_below: impl Fn(f64) -> bool,
) -> [f64; 2] {
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        *(if is_below(middle) { &mut low } else { &mut high }) = middle;
    }
    [low, high]
}

/// The golden section, ½ (√5 − 1).
pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The minimum of a function with a single minimum in an interval, by golden-section search with so
/// many steps.
pub(crate) fn golden_section(
    [mut low, mut high]: [f64; 2],
    steps: u32,
    value: impl Fn(f64) -> f64,
) -> f64 {
    for _ in 0..steps {
        let [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        if value(left) < value(right) {
            high = right;
        } else {
            low = left;
        }
    }
    0.5 * (low + high)
}

/// Maximum number of evaluations; a root to rounding error takes some five.
const EVALUATIONS: usize = 60;

/// Relative accuracy of a fixed point.
const ACCURACY: f64 = 1e-12;

/// Slopes between which one is remembered: others are those of a kink.
const STEEPEST: f64 = 10.0;
const FLATTEST: f64 = 0.5;

/// The x ≥ 0 with answer(x) = x: by the secant through the last two points, and by bisection if
/// that leaves the bracket. `answer` is never negative. If there are several roots, one of them is
/// returned.
pub(crate) fn fixed_point(start: f64, answer: impl FnMut(f64) -> f64) -> f64 {
    fixed_point_near(start, &mut 0.0, answer)
}

/// The same with an estimate of the slope of `answer`, which is improved for the next one of a
/// series of similar functions.
pub(crate) fn fixed_point_near(
    start: f64,
    slope: &mut f64,
    mut answer: impl FnMut(f64) -> f64,
) -> f64 {
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut tried = start;
    let mut last: Option<[f64; 2]> = None;
    for evaluation in 0..EVALUATIONS {
        let asked = answer(tried);
        let excess = asked - tried;
        if excess.abs() <= ACCURACY * tried.max(asked) {
            return asked;
        }
        if excess > 0.0 {
            low = tried;
        } else {
            high = tried;
        }
        let next = match last {
            // Every eighth step bisects, so that neither end of the interval stagnates.
            Some([before, excess_before]) if excess != excess_before && evaluation % 8 != 7 => {
                let change = (excess - excess_before) / (tried - before);
                *slope = (1.0 + change).clamp(-STEEPEST, FLATTEST);
                tried - excess / change
            }
            None => tried + excess / (1.0 - *slope),
            _ => f64::NAN,
        };
        last = Some([tried, excess]);
        tried = if next > low && next < high {
            next
        } else if high.is_finite() {
            0.5 * (low + high)
        } else {
            tried + 2.0 * excess
        };
    }
    tried
}

/// Evaluations in which a bracket must halve, or its middle is next.
const PATIENCE: usize = 4;

/// An interval in which a function that is below its target at the first end comes above it, by a
/// root or by a jump. Whatever is proposed as the next point, it shrinks to that point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bracket {
    ends: [f64; 2],
    /// Width when it last halved, and evaluations since.
    halved: (f64, usize),
}

impl Bracket {
    /// Between two ends, which may be infinite.
    pub fn new(ends: [f64; 2]) -> Self {
        Self { ends, halved: (f64::INFINITY, 0) }
    }

    /// Notes on which side of its target the function is at a point.
    pub fn note(&mut self, x: f64, is_below: bool) {
        self.ends[usize::from(!is_below)] = x;
        let width = self.width();
        if width.is_finite() && width > 0.5 * self.halved.0 {
            self.halved.1 += 1;
        } else {
            self.halved = (width, 0);
        }
    }

    /// Its ends, in the unit of its points.
    pub fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// Its width, in the unit of its points; infinite until both ends are known.
    pub fn width(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// The next point, in the unit of the others: the one that is proposed, or the middle where
    /// that is not inside or where proposals do not narrow the bracket.
    pub fn next(&self, proposal: f64) -> f64 {
        let [low, high] = self.ends;
        let is_inside = proposal > low && proposal < high;
        let is_slow = self.halved.1 >= PATIENCE;
        if self.width().is_finite() && (is_slow || !is_inside) {
            0.5 * (low + high)
        } else {
            proposal
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn roots_and_minima_are_found() {
        let [below, above] = bisection([0.0, 4.0], 60, |x| x * x < 2.0);
        assert!(below * below < 2.0 && above * above >= 2.0 && above - below < 3e-16);
        // A minimum is only as sharp as the rounding of its value allows.
        let least = golden_section([-1.0, 3.0], 60, |x| (x - 0.3).powi(2));
        assert!((least - 0.3).abs() < 1e-8, "{least}");
    }

    /// Mild and steep decreases, an increase, a jump, and a root near zero; with few evaluations
    /// where the function is smooth.
    #[test]
    fn roots_are_found() {
        let count = |answer: &dyn Fn(f64) -> f64, root: f64| {
            let mut evaluations = 0;
            let found = fixed_point(0.4, |mu| {
                evaluations += 1;
                answer(mu)
            });
            assert_relative_eq!(found, root, epsilon = 1e-11);
            evaluations
        };
        assert_eq!(count(&|_| 0.3, 0.3), 2);
        assert!(count(&|mu| 0.4 - 0.2 * mu, 1.0 / 3.0) <= 4);
        assert!(count(&|mu| 0.4 / (1.0 + 9.0 * mu), (15.4_f64.sqrt() - 1.0) / 18.0) <= 9);
        assert!(count(&|mu| 0.1 + 0.5 * mu, 0.2) <= 5);
        let mut slope = 0.0;
        for (shift, most) in [(0.0, 4), (0.01, 3), (0.02, 3)] {
            let mut evaluations = 0;
            let found = fixed_point_near(0.3, &mut slope, |mu| {
                evaluations += 1;
                0.4 - shift - 0.2 * mu
            });
            assert_relative_eq!(found, (0.4 - shift) / 1.2, epsilon = 1e-11);
            assert!(evaluations <= most, "{shift}: {evaluations}");
        }
        count(&|mu| if mu > 0.25 { 0.1 } else { 0.4 }, 0.25);
        count(&|mu| (0.4 - 50.0 * mu).max(0.0), 0.4 / 51.0);
    }

    /// Proposals that cycle, that stagnate at one end and that leave the bracket do not keep it
    /// from closing, at a root and at a jump alike.
    #[test]
    fn brackets_close_whatever_is_proposed() {
        let root = |x: f64| x.powi(3) - 0.3;
        let jump = |x: f64| if x < 0.7 { -1e-3 } else { 2.0 };
        let proposals: [&dyn Fn(f64) -> f64; 4] =
            [&|x| if x > 0.68 { 0.6 } else { 0.8 }, &|x| x + 1e-9, &|x| x - 1e-9, &|_| 7.0];
        for (function, expected) in [(&root as &dyn Fn(f64) -> f64, 0.3_f64.cbrt()), (&jump, 0.7)] {
            for proposal in proposals {
                let mut bracket = Bracket::new([0.0, 1.0]);
                let (mut x, mut evaluations) = (0.9, 0);
                while bracket.width() > 1e-9 {
                    bracket.note(x, function(x) < 0.0);
                    x = bracket.next(proposal(x));
                    evaluations += 1;
                }
                assert_relative_eq!(bracket.ends()[0], expected, epsilon = 2e-9);
                assert!(evaluations <= 5 * 31, "{evaluations}");
            }
        }
    }
}
