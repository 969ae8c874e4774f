//! The law of a cell as one equation, for bristles of any stiffness.
//!
//! Per cell let q = p/(μ pₙ), v the sliding over the path into it, and τ and c the weight of the
//! cell itself and the part of n nodes upstream in the derivative there, times that path. The
//! incremental law dq = k_c (ds − q |ds|) with that derivative applied to q is
//!
//! (τ q + c) φ(k_c |v|) = k_c (v − |v| q),  φ(K) = (K + K²/2 + … + Kⁿ/n!)/(exp(K) − 1).
//!
//! With φ = 1 this is of the order n of the derivative, which φ = 1 − O(Kⁿ) keeps; however far a
//! cell slides, it forgets what is upstream, and no polynomial has to follow the exponential. With
//! one node this is exact along a straight path (exponential fitting: Scharfetter and Gummel 1969),
//! and with q = 0 there the law in the total displacement.
//!
//! With the trial traction Y = p + γ v, m = γ |v|, κ = τ φ γ/k_c and G = c φ γ/k_c (all in Pa) this
//! is a traction p = R(Y, c) that follows from one number:
//!
//! R = μpₙ (Y − G)/(μpₙ + κ + m), where m (μpₙ + κ + m) = |(κ + m) Y + μpₙ G|.
//!
//! Where k_c is infinite, m = max(0, |Y| − μpₙ), and R reduces what exceeds μpₙ to it: in stick m =
//! 0, in slip p = μpₙ along v. The derivative is then that of stick or of slip (semismooth Newton:
//! Alart and Curnier 1991; Hüeber, Stadler and Wohlmuth 2008).

pub(in crate::rolling) type Matrix = [[f64; 2]; 2];

fn length(q: [f64; 2]) -> f64 {
    (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// A traction or trial traction, reduced to a bound if it exceeds that; both in Pa.
pub(in crate::rolling) fn reduced(q: [f64; 2], bound: f64) -> [f64; 2] {
    let length = length(q);
    if length > bound { q.map(|q| q * (bound / length)) } else { q }
}

/// A traction (in Pa) over μ pₙ (in Pa), dimensionless; at most one in spite of the tolerance.
pub(in crate::rolling) fn saturation(traction: [f64; 2], bound: f64) -> [f64; 2] {
    let over = if bound > 0.0 { bound.recip() } else { 0.0 };
    reduced(traction.map(|p| over * p), 1.0)
}

/// What the material of a cell brings along.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct BristleState {
    /// γ/k_c, in Pa; zero without bristles.
    pub compliance: f64,
    /// τ, dimensionless.
    pub own: f64,
    /// c, dimensionless.
    pub upstream: [f64; 2],
    /// n: the nodes upstream.
    pub order: usize,
    /// A guess of m, in Pa; zero if there is none.
    pub guess: f64,
    /// Whether derivatives are exact. Where |c| is reduced to τ, Newton's method takes the
    /// reduction for a constant factor: where everything slides |c| is nearly τ, and would be
    /// reduced in one step and not in the next.
    pub is_exact: bool,
}

impl BristleState {
    /// Reduces |c| to τ if it is larger, with the derivative of the result by c. q extrapolated to
    /// the cell is then at most one: a stencil overshoots a kink, and where it does, a larger
    /// sliding would go with a smaller traction, and a trial traction with several states.
    fn limit(&mut self) -> Matrix {
        let size = length(self.upstream);
        if size <= self.own {
            return IDENTITY;
        }
        let (share, n) = (self.own / size, self.upstream.map(|c| c / size));
        self.upstream = n.map(|n| self.own * n);
        if self.is_exact {
            across(share, n)
        } else {
            IDENTITY.map(|row| row.map(|one| share * one))
        }
    }

    /// φ and its derivative by m (in 1/Pa), where m is given in Pa; linear and zero where it is so
    /// to rounding.
    fn memory(&self, sliding: f64) -> [f64; 2] {
        let relaxed = sliding / self.compliance;
        if relaxed > -f64::EPSILON.ln() {
            return [0.0; 2];
        }
        if relaxed < f64::EPSILON.sqrt() {
            let slope = if self.order == 1 { -0.5 } else { 0.0 };
            return [1.0 + slope * relaxed, slope / self.compliance];
        }
        let (mut term, mut sum, mut slope) = (1.0, 0.0, 0.0);
        for n in 1..=self.order {
            slope += term;
            term *= relaxed / n as f64;
            sum += term;
        }
        let grown = relaxed.exp_m1();
        let value = sum / grown;
        [value, (slope - value * (grown + 1.0)) / grown / self.compliance]
    }
}

const IDENTITY: Matrix = [[1.0, 0.0], [0.0, 1.0]];

/// The projection across a direction, times a factor.
fn across(factor: f64, n: [f64; 2]) -> Matrix {
    [0, 1].map(|r| [0, 1].map(|c| factor * (IDENTITY[r][c] - n[r] * n[c])))
}

/// The traction of a cell, and its derivatives.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Resolvent {
    /// p, in Pa.
    pub traction: [f64; 2],
    /// m: γ times the sliding, in Pa; zero where the cell sticks.
    pub sliding: f64,
    /// By the trial traction, dimensionless.
    pub by_trial: Matrix,
    /// By c, in Pa.
    pub by_upstream: Matrix,
    /// By μ pₙ, dimensionless.
    pub by_bound: [f64; 2],
    /// By the logarithm of k_c, in Pa.
    pub by_stiffness: [f64; 2],
}

impl Resolvent {
    /// Under a trial traction, with a bound μ pₙ (both in Pa).
    pub fn at(trial: [f64; 2], bound: f64, bristles: &BristleState) -> Self {
        if bristles.compliance > 0.0 {
            return Self::with_bristles(trial, bound, bristles);
        }
        let size = length(trial);
        if size <= bound {
            return Self { traction: trial, by_trial: IDENTITY, ..Self::default() };
        }
        let (share, n) = (bound / size, trial.map(|p| p / size));
        Self {
            traction: n.map(|n| bound * n),
            sliding: size - bound,
            by_trial: across(share, n),
            by_bound: n,
            ..Self::default()
        }
    }

    fn with_bristles(trial: [f64; 2], bound: f64, bristles: &BristleState) -> Self {
        let mut bristles = *bristles;
        let by_c = bristles.limit();
        let (sliding, [left, fading]) = sliding(trial, bound, &bristles);
        let BristleState { compliance, own, upstream, .. } = bristles;
        let (kept, kept_slope) = (compliance * own * left, compliance * own * fading);
        let from = upstream.map(|c| compliance * left * c);
        let from_slope = upstream.map(|c| compliance * fading * c);
        let free = kept + sliding;
        let whole = bound + free;
        let along = [0, 1].map(|c| free * trial[c] + bound * from[c]);
        let size = length(along);
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let looser = 1.0 + kept_slope;
        // m follows from an excess of zero.
        let by_sliding = whole + sliding * looser - looser * dot(trial) - bound * dot(from_slope);
        let steepness = by_sliding.recip();
        let share = bound / whole;
        let traction = [0, 1].map(|c| share * (trial[c] - from[c]));
        let slides = [0, 1].map(|c| -share * from_slope[c] - traction[c] * looser / whole);
        let block = |own: f64, moved: f64| {
            let [x, y] = [n[0] * moved * steepness, n[1] * moved * steepness];
            [[own + slides[0] * x, slides[0] * y], [slides[1] * x, own + slides[1] * y]]
        };
        let by_bound = (dot(from) - sliding) * steepness;
        // κ and G go with γ/k_c at the same k_c m.
        let softer = sliding * kept_slope - kept;
        let stiffer = [0, 1].map(|c| sliding * from_slope[c] - from[c]);
        let by_stiffness = (softer * (dot(trial) - sliding) + bound * dot(stiffer)) * steepness;
        let by_inherited = block(-compliance * left * share, compliance * left * bound);
        Self {
            traction,
            sliding,
            by_trial: block(share, free),
            by_upstream: product_2x2(&by_inherited, &by_c),
            by_bound: [0, 1]
                .map(|c| (1.0 - share) * (trial[c] - from[c]) / whole + slides[c] * by_bound),
            by_stiffness: [0, 1].map(|c| {
                -share * stiffer[c] - traction[c] * softer / whole + slides[c] * by_stiffness
            }),
        }
    }

    /// Whether the cell slides.
    pub fn is_sliding(&self) -> bool {
        self.sliding > 0.0
    }

    /// The local Jacobian 1 − R′ (1 − γ B), where `stiffening` is γ B of the cell alone;
    /// dimensionless.
    pub fn jacobian(&self, stiffening: &Matrix) -> Matrix {
        let [[xx, xy], [yx, yy]] = product_2x2(&self.by_trial, stiffening);
        let by = &self.by_trial;
        [[1.0 - by[0][0] + xx, xy - by[0][1]], [yx - by[1][0], 1.0 - by[1][1] + yy]]
    }
}

/// m (in Pa), and φ with its derivative there.
fn sliding(trial: [f64; 2], bound: f64, bristles: &BristleState) -> (f64, [f64; 2]) {
    let BristleState { compliance, own, upstream, guess, .. } = *bristles;
    let size = length(trial);
    // By the triangle inequality it is no larger.
    let (mut low, mut high) = (0.0, size.max(compliance * length(upstream)));
    let mut at = if guess > 0.0 { guess.min(high) } else { (size - bound).max(0.0) };
    // Newton's method, and bisection where its steps do not become half as long each time.
    let mut last = high;
    for _ in 0..2 * f64::MANTISSA_DIGITS {
        let memory = bristles.memory(at);
        let [left, fading] = memory;
        let free = compliance * own * left + at;
        let looser = 1.0 + compliance * own * fading;
        let from = bound * compliance * left;
        let along = [0, 1].map(|c| free * trial[c] + from * upstream[c]);
        let size = length(along);
        let excess = at * (bound + free) - size;
        if excess > 0.0 {
            high = at;
        } else {
            low = at;
        }
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let slope = bound + free + at * looser
            - looser * dot(trial)
            - bound * compliance * fading * dot(upstream);
        let next = at - excess / slope;
        let is_within = next >= low && next <= high && (next - at).abs() <= 0.5 * last;
        let next = if is_within { next } else { 0.5 * (low + high) };
        last = (next - at).abs();
        let before = std::mem::replace(&mut at, next);
        if last <= f64::EPSILON * (32.0 * next + bound) {
            return (next, memory);
        }
        // What a step leaves is of second order in the step.
        let is_small = last <= f64::EPSILON.sqrt() * compliance.min(bound);
        if is_small && is_within && !bristles.is_exact {
            return (next, [left + fading * (next - before), fading]);
        }
    }
    (at, bristles.memory(at))
}

pub(in crate::rolling) fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const H: f64 = 1e-6;

    /// Changes of trial traction, bound, c and ln k_c.
    type Changes = ([f64; 2], f64, [f64; 2], f64);

    /// Derivatives against central differences.
    fn assert_derivatives(resolvent: &Resolvent, at: impl Fn(Changes) -> Resolvent) {
        let difference = |plus: Changes, minus: Changes| {
            let [plus, minus] = [plus, minus].map(|change| at(change).traction);
            [0, 1].map(|c| (plus[c] - minus[c]) / (2.0 * H))
        };
        let along = |c: usize, h: f64| [0, 1].map(|k| if k == c { h } else { 0.0 });
        let none = [0.0; 2];
        for c in 0..2 {
            let tried = |h: f64| (along(c, h), 0.0, none, 0.0);
            let upstream = |h: f64| (none, 0.0, along(c, h), 0.0);
            let [by_trial, by_upstream] =
                [difference(tried(H), tried(-H)), difference(upstream(H), upstream(-H))];
            for r in 0..2 {
                assert_relative_eq!(resolvent.by_trial[r][c], by_trial[r], epsilon = 1e-6);
                assert_relative_eq!(resolvent.by_upstream[r][c], by_upstream[r], epsilon = 1e-6);
            }
        }
        let by_bound = difference((none, H, none, 0.0), (none, -H, none, 0.0));
        let by_stiffness = difference((none, 0.0, none, H), (none, 0.0, none, -H));
        for r in 0..2 {
            assert_relative_eq!(resolvent.by_bound[r], by_bound[r], epsilon = 1e-6);
            assert_relative_eq!(resolvent.by_stiffness[r], by_stiffness[r], epsilon = 1e-6);
        }
    }

    /// The law holds for the sliding that is found, from soft bristles to none.
    #[test]
    fn the_law_holds_in_a_cell() {
        let bound = 0.5;
        for (order, own, c) in [
            (1, 1.0, [0.3, -0.4]),
            (2, 1.5, [-0.9, 0.2]),
            (3, 1.8, [1.5, -1.6]),
            (3, 1.8, [0.0; 2]),
        ] {
            for compliance in [3.0, 0.1, 1e-3, 0.0] {
                for trial in [[0.3, -0.2], [0.3, -0.8], [-2.0, 1.0], [1e-3, 0.0]] {
                    let at = |(tried, raised, changed, stiffer): Changes| {
                        let compliance = compliance * f64::exp(-stiffer);
                        let upstream = [0, 1].map(|k| c[k] + changed[k]);
                        let made = BristleState {
                            compliance,
                            own,
                            upstream,
                            order,
                            is_exact: true,
                            ..BristleState::default()
                        };
                        Resolvent::at([0, 1].map(|k| trial[k] + tried[k]), bound + raised, &made)
                    };
                    let resolvent = at(([0.0; 2], 0.0, [0.0; 2], 0.0));
                    assert_derivatives(&resolvent, at);
                    let p = resolvent.traction;
                    assert!(length(p) <= bound * (1.0 + 1e-12));
                    let slid = [0, 1].map(|k| trial[k] - p[k]);
                    assert_relative_eq!(length(slid), resolvent.sliding, epsilon = 1e-12);
                    let reduced = (own / length(c)).min(1.0);
                    let relaxed = resolvent.sliding / compliance;
                    let terms = [relaxed, relaxed.powi(2) / 2.0, relaxed.powi(3) / 6.0];
                    let left = terms[..order].iter().sum::<f64>() / relaxed.exp_m1();
                    let left = if relaxed < 100.0 { compliance * left } else { 0.0 };
                    for k in 0..2 {
                        let kept = left * (own * p[k] / bound + reduced * c[k]);
                        let stretched = slid[k] - resolvent.sliding * p[k] / bound;
                        assert_relative_eq!(kept, stretched, epsilon = 1e-10);
                    }
                }
            }
        }
    }

    /// A state of which Newton's method alone goes to and fro for ever between 1.1·10⁻⁵ and
    /// 8.4·10⁻⁴, and many others: the law holds in all.
    #[test]
    fn the_sliding_is_found_from_anywhere() {
        let bound = 1.0;
        let check = |trial: [f64; 2], bristles: BristleState| {
            let resolvent = Resolvent::at(trial, bound, &bristles);
            let BristleState { compliance, own, upstream, .. } = bristles;
            let [left, _] = bristles.memory(resolvent.sliding);
            for k in 0..2 {
                let q = resolvent.traction[k] / bound;
                let kept = compliance * left * (own * q + upstream[k]);
                let stretched = trial[k] - resolvent.traction[k] - resolvent.sliding * q;
                assert_relative_eq!(kept, stretched, epsilon = 1e-11);
            }
        };
        let own = 11.0 / 6.0;
        let of = |compliance, upstream| BristleState {
            guess: 0.0,
            compliance,
            own,
            upstream,
            order: 3,
            is_exact: true,
        };
        check([0.785_664, -0.281_233], of(6.130_85e-5, [1.216_533, 0.205_007]));
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed * 48_271 % 2_147_483_647;
            seed as f64 / 2_147_483_647.0
        };
        for _ in 0..20_000 {
            let (angle, turn) = (6.3 * random(), 6.3 * random());
            let (size, share) = (2.0 * random(), own * random());
            let upstream = [share * turn.cos(), share * turn.sin()];
            check(
                [size * angle.cos(), size * angle.sin()],
                of(10_f64.powf(-7.0 * random()), upstream),
            );
        }
    }

    /// From one node on a straight path p/(μ pₙ) relaxes to its direction exactly.
    #[test]
    fn straight_paths_are_exact() {
        let (bound, along, sliding) = (0.5, [0.6, -0.8], 0.7);
        for relaxed in [1e-4, 0.3, 1.0, 3.0, 30.0] {
            let at = |slid: f64| along.map(|n| -(-slid).exp_m1() * n);
            let before = at(2.0 * relaxed);
            let exact = at(3.0 * relaxed).map(|q| bound * q);
            let trial = [0, 1].map(|c| exact[c] + sliding * along[c]);
            let (compliance, upstream) = (sliding / relaxed, before.map(|q| -q));
            let bristles = BristleState {
                compliance,
                own: 1.0,
                upstream,
                order: 1,
                is_exact: true,
                ..BristleState::default()
            };
            let resolvent = Resolvent::at(trial, bound, &bristles);
            assert_relative_eq!(resolvent.sliding, sliding, max_relative = 1e-10);
            for (found, exact) in resolvent.traction.into_iter().zip(exact) {
                assert_relative_eq!(found, exact, max_relative = 1e-9);
            }
        }
    }
}
