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
//! With u the direction of (κ + m) Y + μpₙ G, primes for derivatives by m, and
//! d = μpₙ + κ + m + m (1 + κ′) − (1 + κ′) u·Y − μpₙ u·G′,
//!
//! dm = u·[(κ + m) dY + μpₙ dG]/d,
//! dR = [μpₙ (dY − dG − G′ dm) − R (1 + κ′) dm]/(μpₙ + κ + m).
//!
//! Where k_c is infinite, m = max(0, |Y| − μpₙ), and R reduces what exceeds μpₙ to it: in stick m =
//! 0, in slip p = μpₙ along v. The derivative is then that of stick or of slip (semismooth Newton:
//! Alart and Curnier 1991; Hüeber, Stadler and Wohlmuth 2008).

pub(in crate::solver::rolling) type Matrix = [[f64; 2]; 2];

fn length(q: [f64; 2]) -> f64 {
    (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// A traction or trial traction, reduced to a bound if it exceeds that; both in Pa.
pub(in crate::solver::rolling) fn reduced(q: [f64; 2], bound: f64) -> [f64; 2] {
    let length = length(q);
    if length > bound { q.map(|q| q * (bound / length)) } else { q }
}

/// A traction (in Pa) over μ pₙ (in Pa), dimensionless; at most one in spite of the tolerance.
pub(in crate::solver::rolling) fn saturation(traction: [f64; 2], bound: f64) -> [f64; 2] {
    let over = if bound > 0.0 { bound.recip() } else { 0.0 };
    reduced(traction.map(|p| over * p), 1.0)
}

/// What the material of a cell brings along.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::solver::rolling) struct BristleState {
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

    /// φ and its derivative by m (in 1/Pa), where m is given in Pa; zero beyond K = −ln ε, where φ
    /// is less than 10⁻¹¹.
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
pub(in crate::solver::rolling) struct Resolvent {
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
        let (sliding, memory) = sliding(trial, bound, &bristles);
        let balance = Balance::at(sliding, memory, (trial, bound), &bristles);
        let Balance { kept, kept_slope, whole, along: n, .. } = balance;
        let [from, from_slope] =
            memory.map(|memory| bristles.upstream.map(|c| bristles.compliance * memory * c));
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let free_slope = 1.0 + kept_slope;
        // m follows from an excess of zero.
        let steepness = balance.slope.recip();
        let share = bound / whole;
        let traction = [0, 1].map(|c| share * (trial[c] - from[c]));
        let slides = [0, 1].map(|c| -share * from_slope[c] - traction[c] * free_slope / whole);
        let block = |own: f64, moved: f64| {
            let [x, y] = [n[0] * moved * steepness, n[1] * moved * steepness];
            [[own + slides[0] * x, slides[0] * y], [slides[1] * x, own + slides[1] * y]]
        };
        let by_bound = (dot(from) - sliding) * steepness;
        // κ and G go with γ/k_c at the same k_c m.
        let kept_by = sliding * kept_slope - kept;
        let from_by = [0, 1].map(|c| sliding * from_slope[c] - from[c]);
        let by_stiffness = (kept_by * (dot(trial) - sliding) + bound * dot(from_by)) * steepness;
        let left = bristles.compliance * memory[0];
        let by_inherited = block(-left * share, left * bound);
        Self {
            traction,
            sliding,
            by_trial: block(share, kept + sliding),
            by_upstream: product_2x2(&by_inherited, &by_c),
            by_bound: [0, 1]
                .map(|c| (1.0 - share) * (trial[c] - from[c]) / whole + slides[c] * by_bound),
            by_stiffness: [0, 1].map(|c| {
                -share * from_by[c] - traction[c] * kept_by / whole + slides[c] * by_stiffness
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

/// The equation of m at a trial value.
struct Balance {
    /// κ, in Pa.
    kept: f64,
    /// Its derivative by m, dimensionless.
    kept_slope: f64,
    /// μpₙ + κ + m, in Pa.
    whole: f64,
    /// The direction of (κ + m) Y + μpₙ G.
    along: [f64; 2],
    /// m (μpₙ + κ + m) − |(κ + m) Y + μpₙ G|, in Pa².
    excess: f64,
    /// Its derivative by m, in Pa.
    slope: f64,
}

impl Balance {
    /// At m (in Pa), with φ and its derivative there.
    fn at(
        sliding: f64,
        [left, fading]: [f64; 2],
        (trial, bound): ([f64; 2], f64),
        bristles: &BristleState,
    ) -> Self {
        let BristleState { compliance, own, upstream, .. } = *bristles;
        let (kept, kept_slope) = (compliance * own * left, compliance * own * fading);
        let (free, whole) = (kept + sliding, bound + kept + sliding);
        let from = bound * compliance * left;
        let along = [0, 1].map(|c| free * trial[c] + from * upstream[c]);
        let size = length(along);
        let along = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| along[0] * v[0] + along[1] * v[1];
        let free_slope = 1.0 + kept_slope;
        let slope = whole + sliding * free_slope
            - free_slope * dot(trial)
            - bound * compliance * fading * dot(upstream);
        Self { kept, kept_slope, whole, along, excess: sliding * whole - size, slope }
    }
}

/// m (in Pa), and φ with its derivative there.
fn sliding(trial: [f64; 2], bound: f64, bristles: &BristleState) -> (f64, [f64; 2]) {
    let BristleState { compliance, guess, .. } = *bristles;
    let size = length(trial);
    // By the triangle inequality it is no larger.
    let (mut low, mut high) = (0.0, size.max(compliance * length(bristles.upstream)));
    let mut at = if guess > 0.0 { guess.min(high) } else { (size - bound).max(0.0) };
    // Newton's method, and bisection where its steps do not become half as long each time.
    let mut last = high;
    for _ in 0..2 * f64::MANTISSA_DIGITS {
        let memory = bristles.memory(at);
        let Balance { excess, slope, .. } = Balance::at(at, memory, (trial, bound), bristles);
        if excess > 0.0 {
            high = at;
        } else {
            low = at;
        }
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
            let [left, fading] = memory;
            return (next, [left + fading * (next - before), fading]);
        }
    }
    (at, bristles.memory(at))
}

pub(in crate::solver::rolling) fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}

#[cfg(test)]
mod tests;
