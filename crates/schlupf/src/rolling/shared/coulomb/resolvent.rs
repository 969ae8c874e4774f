//! The law of a cell as one equation, for bristles of any stiffness.
//!
//! Per cell let q = p/(μ pₙ), v the sliding over the way into it, and wⱼ the weights of nodes upstream
//! at the distances dⱼ, as multiples of that way, in its derivative there. The incremental law
//! dq = k_c (ds − q |ds|) with that derivative applied to q is, with τ = −Σ wⱼ and c = Σ wⱼ qⱼ,
//!
//! (τ q + c) φ(k_c |v|) = k_c (v − |v| q),    φ(K) = K/Σ wⱼ (1 − exp(K dⱼ)).
//!
//! With φ = 1 this is of the order of the derivative. φ keeps the order and makes the equation exact
//! along every straight path (exponential fitting: Scharfetter and Gummel 1969): however far a cell
//! slides, it has forgotten what is upstream. From one node q = 0 it is the law in the total
//! displacement.
//!
//! With the pull Y = p + γ v, m = γ |v|, κ = τ φ γ/k_c and G = c φ γ/k_c (all in Pa) this is a traction
//! p = R(Y, c) that follows from one number:
//!
//! R = μpₙ (Y − G)/(μpₙ + κ + m), where m (μpₙ + κ + m) = |(κ + m) Y + μpₙ G|.
//!
//! Where k_c is infinite, m = max(0, |Y| − μpₙ), and R reduces what exceeds μpₙ to it: in stick m =
//! 0, in slip p = μpₙ along v. The derivative is then that of stick or of slip (semismooth Newton:
//! Alart and Curnier 1991; Hüeber, Stadler and Wohlmuth 2008).

use crate::state::MOST_PLACES;

pub(in crate::rolling) type Matrix = [[f64; 2]; 2];

fn length(q: [f64; 2]) -> f64 {
    (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// A traction or pull, reduced to a bound if it exceeds that; both in Pa.
pub(in crate::rolling) fn reduced(q: [f64; 2], bound: f64) -> [f64; 2] {
    let length = length(q);
    if length > bound { q.map(|q| q * (bound / length)) } else { q }
}

/// A traction (in Pa) over μ pₙ (in Pa), dimensionless; at most one in spite of the tolerance.
pub(in crate::rolling) fn saturation(traction: [f64; 2], bound: f64) -> [f64; 2] {
    let over = if bound > 0.0 { bound.recip() } else { 0.0 };
    reduced(traction.map(|p| over * p), 1.0)
}

/// A node upstream of a cell.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Node {
    /// Weight in the derivative at the cell, times the way into it; zero if there is no node.
    pub weight: f64,
    /// Distance over that way, dimensionless.
    pub distance: f64,
    /// p/(μ pₙ) there, dimensionless.
    pub saturation: [f64; 2],
}

/// What the material of a cell brings along.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Bristles {
    /// γ/k_c, in Pa; zero without bristles.
    compliance: f64,
    /// τ, dimensionless.
    own: f64,
    /// c, dimensionless.
    upstream: [f64; 2],
    nodes: [Node; MOST_PLACES],
}

impl Bristles {
    /// From γ/k_c (in Pa): one node, or three; with two φ would not be positive.
    pub fn new(compliance: f64, nodes: [Node; MOST_PLACES]) -> Self {
        let mut made = Self { compliance, nodes, ..Self::default() };
        for Node { weight, saturation, .. } in &nodes {
            made.own -= weight;
            made.upstream = [0, 1].map(|c| made.upstream[c] + weight * saturation[c]);
        }
        made
    }

    /// Reduces |c| to τ if it is larger, with the derivative of the result by c. q extrapolated to
    /// the cell is then at most one: a stencil overshoots a kink, and where it does, a larger
    /// sliding would go with a smaller traction, and a pull with several states.
    fn limit(&mut self) -> Matrix {
        let size = length(self.upstream);
        if size <= self.own {
            return IDENTITY;
        }
        let (share, n) = (self.own / size, self.upstream.map(|c| c / size));
        self.upstream = n.map(|n| self.own * n);
        across(share, n)
    }

    /// φ and its derivative by m (in 1/Pa), where m is given in Pa.
    fn forgotten(&self, sliding: f64) -> [f64; 2] {
        let relaxed = sliding / self.compliance;
        let near = relaxed.exp_m1();
        let (mut sum, mut slope, mut curvature) = (0.0, 0.0, 0.0);
        for Node { weight, distance, .. } in &self.nodes {
            if *weight != 0.0 {
                let grown = grown(near, relaxed, *distance);
                sum -= weight * grown;
                slope -= weight * distance * (grown + 1.0);
                curvature -= weight * distance * distance;
            }
        }
        if relaxed < LINEAR {
            return [1.0 - 0.5 * curvature * relaxed, -0.5 * curvature / self.compliance];
        }
        let value = relaxed / sum;
        if value == 0.0 {
            return [0.0; 2];
        }
        [value, value / relaxed * (1.0 - value * slope) / self.compliance]
    }
}

/// Below this k_c |v| φ is linear, to rounding of what it does.
const LINEAR: f64 = 1e-8;

/// exp(x d) − 1 from exp(x) − 1: nodes are mostly one, two and three cells away.
fn grown(near: f64, x: f64, distance: f64) -> f64 {
    if distance == 1.0 {
        near
    } else if distance == 2.0 {
        near * (near + 2.0)
    } else if distance == 3.0 {
        near * (near * (near + 3.0) + 3.0)
    } else {
        (x * distance).exp_m1()
    }
}

const IDENTITY: Matrix = [[1.0, 0.0], [0.0, 1.0]];

/// The projection across a direction, times a factor.
fn across(factor: f64, n: [f64; 2]) -> Matrix {
    [0, 1].map(|r| [0, 1].map(|c| factor * (IDENTITY[r][c] - n[r] * n[c])))
}

/// The traction of a cell, and its derivatives.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Answer {
    /// In Pa.
    pub traction: [f64; 2],
    /// m: γ times the sliding, in Pa; zero where the cell sticks.
    pub sliding: f64,
    /// By the pull, dimensionless.
    pub by_pull: Matrix,
    /// By c, in Pa.
    pub by_upstream: Matrix,
    /// By μ pₙ, dimensionless.
    pub by_bound: [f64; 2],
    /// By the logarithm of k_c, in Pa.
    pub by_stiffness: [f64; 2],
}

/// Most steps to the sliding of a cell; most take three.
const STEPS: usize = 60;

/// Relative accuracy of that sliding.
const ACCURACY: f64 = 1e-14;

impl Answer {
    /// Under a pull, with a bound μ pₙ (both in Pa).
    pub fn to(pull: [f64; 2], bound: f64, bristles: &Bristles) -> Self {
        if bristles.compliance > 0.0 {
            return Self::of_bristles(pull, bound, bristles);
        }
        let size = length(pull);
        if size <= bound {
            return Self { traction: pull, by_pull: IDENTITY, ..Self::default() };
        }
        let (share, n) = (bound / size, pull.map(|p| p / size));
        Self {
            traction: n.map(|n| bound * n),
            sliding: size - bound,
            by_pull: across(share, n),
            by_bound: n,
            ..Self::default()
        }
    }

    fn of_bristles(pull: [f64; 2], bound: f64, bristles: &Bristles) -> Self {
        let mut bristles = *bristles;
        let by_c = bristles.limit();
        let sliding = sliding(pull, bound, &bristles);
        let Bristles { compliance, own, upstream, .. } = bristles;
        let [left, fading] = bristles.forgotten(sliding);
        let (kept, kept_slope) = (compliance * own * left, compliance * own * fading);
        let from = upstream.map(|c| compliance * left * c);
        let from_slope = upstream.map(|c| compliance * fading * c);
        let free = kept + sliding;
        let whole = bound + free;
        let along = [0, 1].map(|c| free * pull[c] + bound * from[c]);
        let size = length(along);
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let looser = 1.0 + kept_slope;
        // m follows from an excess of zero.
        let by_sliding = whole + sliding * looser - looser * dot(pull) - bound * dot(from_slope);
        let steepness = by_sliding.recip();
        let share = bound / whole;
        let traction = [0, 1].map(|c| share * (pull[c] - from[c]));
        let slides = [0, 1].map(|c| -share * from_slope[c] - traction[c] * looser / whole);
        let block = |own: f64, moved: f64| {
            let moved = moved * steepness;
            [0, 1].map(|r| [0, 1].map(|c| own * IDENTITY[r][c] + slides[r] * moved * n[c]))
        };
        let by_bound = (dot(from) - sliding) * steepness;
        // κ and G go with γ/k_c at the same k_c m.
        let softer = sliding * kept_slope - kept;
        let stiffer = [0, 1].map(|c| sliding * from_slope[c] - from[c]);
        let by_stiffness = (softer * (dot(pull) - sliding) + bound * dot(stiffer)) * steepness;
        let by_inherited = block(-compliance * left * share, compliance * left * bound);
        Self {
            traction,
            sliding,
            by_pull: block(share, free),
            by_upstream: product_2x2(&by_inherited, &by_c),
            by_bound: [0, 1]
                .map(|c| (1.0 - share) * (pull[c] - from[c]) / whole + slides[c] * by_bound),
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
        let [[xx, xy], [yx, yy]] = product_2x2(&self.by_pull, stiffening);
        let by = &self.by_pull;
        [[1.0 - by[0][0] + xx, xy - by[0][1]], [yx - by[1][0], 1.0 - by[1][1] + yy]]
    }
}

/// m, in Pa.
fn sliding(pull: [f64; 2], bound: f64, bristles: &Bristles) -> f64 {
    let Bristles { compliance, own, upstream, .. } = *bristles;
    let size = length(pull);
    // By the triangle inequality it is no larger.
    let (mut low, mut high) = (0.0, size.max(compliance * length(upstream)));
    let mut at = (size - bound).max(0.0);
    for _ in 0..STEPS {
        let [left, fading] = bristles.forgotten(at);
        let free = compliance * own * left + at;
        let looser = 1.0 + compliance * own * fading;
        let from = bound * compliance * left;
        let along = [0, 1].map(|c| free * pull[c] + from * upstream[c]);
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
            - looser * dot(pull)
            - bound * compliance * fading * dot(upstream);
        let next = at - excess / slope;
        let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
        let is_near = (next - at).abs() <= ACCURACY * next;
        at = next;
        if is_near {
            break;
        }
    }
    at
}

pub(in crate::rolling) fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const H: f64 = 1e-6;

    /// Stencils of first and of third order, equally spaced and not.
    fn nodes(number: usize) -> Vec<[f64; 2]> {
        match number {
            0 => vec![[-1.0, 1.0]],
            1 => vec![[-3.0, 1.0], [1.5, 2.0], [-1.0 / 3.0, 3.0]],
            _ => vec![[-35.0 / 9.0, 1.0], [160.0 / 63.0, 1.75], [-28.0 / 45.0, 2.5]],
        }
    }

    fn bristles(
        number: usize,
        compliance: f64,
        change: [f64; 2],
        q: impl Fn(f64) -> [f64; 2],
    ) -> Bristles {
        let mut made = [Node::default(); MOST_PLACES];
        for (node, [weight, distance]) in made.iter_mut().zip(nodes(number)) {
            *node = Node { weight, distance, saturation: q(distance) };
        }
        for c in 0..2 {
            made[0].saturation[c] += change[c];
        }
        Bristles::new(compliance, made)
    }

    /// Changes of pull, bound, q at the first node and ln k_c.
    type Changes = ([f64; 2], f64, [f64; 2], f64);

    /// Derivatives against central differences.
    fn assert_derivatives(answer: &Answer, weight: f64, at: impl Fn(Changes) -> Answer) {
        let difference = |plus: Changes, minus: Changes| {
            let [plus, minus] = [plus, minus].map(|change| at(change).traction);
            [0, 1].map(|c| (plus[c] - minus[c]) / (2.0 * H))
        };
        let along = |c: usize, h: f64| [0, 1].map(|k| if k == c { h } else { 0.0 });
        let none = [0.0; 2];
        for c in 0..2 {
            let pulled = |h: f64| (along(c, h), 0.0, none, 0.0);
            let upstream = |h: f64| (none, 0.0, along(c, h), 0.0);
            let [by_pull, by_node] =
                [difference(pulled(H), pulled(-H)), difference(upstream(H), upstream(-H))];
            for r in 0..2 {
                let of_node = weight * answer.by_upstream[r][c];
                assert_relative_eq!(answer.by_pull[r][c], by_pull[r], epsilon = 1e-6);
                assert_relative_eq!(of_node, by_node[r], epsilon = 1e-6);
            }
        }
        let by_bound = difference((none, H, none, 0.0), (none, -H, none, 0.0));
        let by_stiffness = difference((none, 0.0, none, H), (none, 0.0, none, -H));
        for r in 0..2 {
            assert_relative_eq!(answer.by_bound[r], by_bound[r], epsilon = 1e-6);
            assert_relative_eq!(answer.by_stiffness[r], by_stiffness[r], epsilon = 1e-6);
        }
    }

    /// The law holds for the sliding that is found, from soft bristles to none.
    #[test]
    fn the_law_holds_in_a_cell() {
        let bound = 0.5;
        let q = |distance: f64| [0.5 - 0.1 * distance, 0.1 * distance * distance - 0.3];
        for number in 0..3 {
            for compliance in [3.0, 0.1, 1e-3, 0.0] {
                for pull in [[0.3, -0.2], [0.3, -0.8], [-2.0, 1.0], [1e-3, 0.0]] {
                    let at = |(pulled, raised, upstream, stiffer): Changes| {
                        let made = bristles(number, compliance * f64::exp(-stiffer), upstream, q);
                        Answer::to([0, 1].map(|k| pull[k] + pulled[k]), bound + raised, &made)
                    };
                    let answer = at(([0.0; 2], 0.0, [0.0; 2], 0.0));
                    assert_derivatives(&answer, nodes(number)[0][0], at);
                    let p = answer.traction;
                    assert!(length(p) <= bound * (1.0 + 1e-12));
                    let slid = [0, 1].map(|k| pull[k] - p[k]);
                    assert_relative_eq!(length(slid), answer.sliding, epsilon = 1e-12);
                    let relaxed = answer.sliding / compliance;
                    let (mut own, mut sum, mut c) = (0.0, 0.0, [0.0; 2]);
                    for [weight, distance] in nodes(number) {
                        own -= weight;
                        sum -= weight * (relaxed * distance).exp_m1();
                        c = [0, 1].map(|k| c[k] + weight * q(distance)[k]);
                    }
                    let reduced = (own / length(c)).min(1.0);
                    let left = if compliance > 0.0 { compliance * relaxed / sum } else { 0.0 };
                    for k in 0..2 {
                        let kept = left * (own * p[k] / bound + reduced * c[k]);
                        let stretched = slid[k] - answer.sliding * p[k] / bound;
                        assert_relative_eq!(kept, stretched, epsilon = 1e-10);
                    }
                }
            }
        }
    }

    /// On a straight path with uniform sliding p/(μ pₙ) relaxes to its direction exactly,
    /// whatever the stencil and however far a cell slides.
    #[test]
    fn straight_paths_are_exact() {
        let (bound, along) = (0.5, [0.6, -0.8]);
        for number in 0..3 {
            for relaxed in [1e-4, 0.3, 1.0, 3.0, 30.0] {
                let sliding = 0.7;
                let since = 3.0;
                let q = |distance: f64| {
                    let slid: f64 = relaxed * (since - distance);
                    along.map(|n| -(-slid).exp_m1() * n)
                };
                let exact = q(0.0).map(|q| bound * q);
                let pull = [0, 1].map(|c| exact[c] + sliding * along[c]);
                let answer =
                    Answer::to(pull, bound, &bristles(number, sliding / relaxed, [0.0; 2], q));
                assert_relative_eq!(answer.sliding, sliding, max_relative = 1e-10);
                for c in 0..2 {
                    assert_relative_eq!(answer.traction[c], exact[c], max_relative = 1e-9);
                }
            }
        }
    }
}
