//! The law of a cell as one equation, for bristles of any stiffness.
//!
//! Per cell let q = p/(μ pₙ), v the sliding over the way into it, and wⱼ the weights of the stencil
//! that gives v, of the nodes upstream at the distances dⱼ, as multiples of that way. The incremental
//! law dq = k_c (ds − q |ds|) with that stencil applied to q is
//!
//! Σⱼ wⱼ g(k_c |v| dⱼ) (qⱼ − q) = k_c (v − |v| q),    g(x) = x/(eˣ − 1).
//!
//! With g = 1 this is of the order of the stencil. g keeps the order, because Σ wⱼ dⱼⁿ = 0 for the
//! powers n > 1 that the stencil differentiates exactly, and makes the equation exact along every
//! straight path (exponential fitting: Scharfetter and Gummel 1969): however far a cell slides, it
//! has forgotten what is farther upstream. From one node q = 0 it is the law in the total
//! displacement.
//!
//! With the pull Y = p + γ v, m = γ |v|, κ = −γ/k_c Σ wⱼ gⱼ and G = γ/k_c Σ wⱼ gⱼ qⱼ (all in Pa)
//! this is a traction p = R(Y; q₁, q₂, …) that follows from one number:
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
    pub compliance: f64,
    pub nodes: [Node; MOST_PLACES],
}

/// κ, G and wⱼ gⱼ γ/k_c, and the derivatives of the first two by m.
#[derive(Debug, Clone, Copy, Default)]
struct Inherited {
    own: f64,
    own_slope: f64,
    from: [f64; 2],
    from_slope: [f64; 2],
    shares: [f64; MOST_PLACES],
}

impl Bristles {
    /// After a sliding of m, in Pa.
    fn at(&self, sliding: f64) -> Inherited {
        let mut sum = Inherited::default();
        let relaxed = sliding / self.compliance;
        let nearest = relaxed.exp();
        for (node, share) in self.nodes.iter().zip(&mut sum.shares) {
            let Node { weight, distance, saturation } = *node;
            if weight == 0.0 {
                continue;
            }
            let [value, slope] =
                bernoulli(distance * relaxed, || power(nearest, relaxed, distance));
            *share = self.compliance * weight * value;
            let steeper = weight * distance * slope;
            sum.own -= *share;
            sum.own_slope -= steeper;
            for c in 0..2 {
                sum.from[c] += *share * saturation[c];
                sum.from_slope[c] += steeper * saturation[c];
            }
        }
        sum
    }

    /// A bound of |G|, in Pa.
    fn most_inherited(&self) -> f64 {
        let of = |node: &Node| node.weight.abs() * length(node.saturation);
        self.compliance * self.nodes.iter().map(of).sum::<f64>()
    }
}

/// exp(x d) from exp(x): nodes are mostly one, two and three cells away.
fn power(exp: f64, x: f64, distance: f64) -> f64 {
    if distance == 1.0 {
        exp
    } else if distance == 2.0 {
        exp * exp
    } else if distance == 3.0 {
        exp * exp * exp
    } else {
        (x * distance).exp()
    }
}

/// x/(eˣ − 1) and its derivative, for x ≥ 0.
fn bernoulli(x: f64, exp: impl FnOnce() -> f64) -> [f64; 2] {
    if x < SERIES {
        let square = x * x;
        let value = 1.0 - 0.5 * x + square * (1.0 / 12.0 - square * (1.0 / 720.0));
        return [value, -0.5 + x * (1.0 / 6.0 - square * (1.0 / 180.0))];
    }
    let value = x / (exp() - 1.0);
    [value, (value * (1.0 - x) - value * value) / x]
}

/// Below this x these are their series, to rounding.
const SERIES: f64 = 1e-2;

/// The traction of a cell, and its derivatives.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Answer {
    /// In Pa.
    pub traction: [f64; 2],
    /// m: γ times the sliding, in Pa; zero where the cell sticks.
    pub sliding: f64,
    /// By the pull, dimensionless.
    pub by_pull: Matrix,
    /// By G, dimensionless.
    pub by_inherited: Matrix,
    /// ∂G/∂q of every node, in Pa.
    pub shares: [f64; MOST_PLACES],
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
    /// Under a pull, with a bound μ pₙ (both in Pa). Where p/(μ pₙ) has a kink, a stencil of third
    /// order overshoots it: tractions are reduced to the bound.
    pub fn to(pull: [f64; 2], bound: f64, bristles: &Bristles) -> Self {
        let answer = if bristles.compliance > 0.0 {
            Self::of_bristles(pull, bound, bristles)
        } else {
            Self { traction: pull, by_pull: [[1.0, 0.0], [0.0, 1.0]], ..Self::default() }
        };
        let size = length(answer.traction);
        if size <= bound { answer } else { answer.reduced(size, bound) }
    }

    fn of_bristles(pull: [f64; 2], bound: f64, bristles: &Bristles) -> Self {
        let sliding = sliding(pull, bound, bristles);
        let Inherited { own, own_slope, from, from_slope, shares } = bristles.at(sliding);
        let free = own + sliding;
        let whole = bound + free;
        let along = [0, 1].map(|c| free * pull[c] + bound * from[c]);
        let size = length(along);
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let looser = 1.0 + own_slope;
        // m follows from an excess of zero.
        let by_sliding = whole + sliding * looser - looser * dot(pull) - bound * dot(from_slope);
        let steepness = by_sliding.recip();
        let share = bound / whole;
        let traction = [0, 1].map(|c| share * (pull[c] - from[c]));
        let slides = [0, 1].map(|c| -share * from_slope[c] - traction[c] * looser / whole);
        let block = |own: f64, moved: f64| {
            let moved = moved * steepness;
            [0, 1]
                .map(|r| [0, 1].map(|c| if r == c { own } else { 0.0 } + slides[r] * moved * n[c]))
        };
        let by_bound = (dot(from) - sliding) * steepness;
        // κ and G go with γ/k_c at the same k_c m.
        let softer = [sliding * own_slope - own, sliding * dot(from_slope) - dot(from)];
        let by_stiffness = (softer[0] * (dot(pull) - sliding) + bound * softer[1]) * steepness;
        Self {
            traction,
            sliding,
            by_pull: block(share, free),
            by_inherited: block(-share, bound),
            shares,
            by_bound: [0, 1]
                .map(|c| (1.0 - share) * (pull[c] - from[c]) / whole + slides[c] * by_bound),
            by_stiffness: [0, 1].map(|c| {
                let stiffer = sliding * from_slope[c] - from[c];
                -share * stiffer - traction[c] * softer[0] / whole + slides[c] * by_stiffness
            }),
        }
    }

    /// Reduced from a size to a bound, in Pa.
    fn reduced(self, size: f64, bound: f64) -> Self {
        let share = bound / size;
        let n = self.traction.map(|p| p / size);
        let across = |v: [f64; 2]| {
            let along = n[0] * v[0] + n[1] * v[1];
            [0, 1].map(|c| share * (v[c] - along * n[c]))
        };
        let block = |m: Matrix| {
            let columns = [0, 1].map(|c| across([m[0][c], m[1][c]]));
            [0, 1].map(|r| [columns[0][r], columns[1][r]])
        };
        let by_bound = across(self.by_bound);
        Self {
            traction: n.map(|n| bound * n),
            sliding: self.sliding + (size - bound),
            by_pull: block(self.by_pull),
            by_inherited: block(self.by_inherited),
            by_bound: [0, 1].map(|c| by_bound[c] + n[c]),
            by_stiffness: across(self.by_stiffness),
            ..self
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
    // By the triangle inequality it lies between these.
    let size = length(pull);
    let (mut low, mut high) = (0.0, size.max(bristles.most_inherited()));
    let mut at = (size - bound).max(0.0);
    for _ in 0..STEPS {
        let Inherited { own, own_slope, from, from_slope, .. } = bristles.at(at);
        let free = own + at;
        let along = [0, 1].map(|c| free * pull[c] + bound * from[c]);
        let size = length(along);
        let excess = at * (bound + free) - size;
        if excess > 0.0 {
            high = at;
        } else {
            low = at;
        }
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let looser = 1.0 + own_slope;
        let slope = bound + free + at * looser - looser * dot(pull) - bound * dot(from_slope);
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

    /// Stencils of first to third order, equally spaced and not.
    fn nodes(number: usize) -> Vec<[f64; 2]> {
        match number {
            0 => vec![[-1.0, 1.0]],
            1 => vec![[-2.0, 1.0], [0.5, 2.0]],
            2 => vec![[-3.0, 1.0], [1.5, 2.0], [-1.0 / 3.0, 3.0]],
            _ => vec![[-3.6, 1.0], [3.0 / 1.75, 1.75], [-4.0 / 9.0, 2.5]],
        }
    }

    fn bristles(number: usize, compliance: f64, q: impl Fn(f64) -> [f64; 2]) -> Bristles {
        let mut made = Bristles { compliance, ..Bristles::default() };
        for (node, [weight, distance]) in made.nodes.iter_mut().zip(nodes(number)) {
            *node = Node { weight, distance, saturation: q(distance) };
        }
        made
    }

    /// Changes of pull, bound, q at the first node and ln k_c.
    type Changes = ([f64; 2], f64, [f64; 2], f64);

    /// Derivatives against central differences.
    fn assert_derivatives(answer: &Answer, at: impl Fn(Changes) -> Answer) {
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
                let of_node = answer.by_inherited[r][c] * answer.shares[0];
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
        for number in 0..4 {
            for compliance in [3.0, 0.1, 1e-3, 0.0] {
                for pull in [[0.3, -0.2], [0.3, -0.8], [-2.0, 1.0], [1e-3, 0.0]] {
                    let at = |(pulled, raised, upstream, stiffer): Changes| {
                        let mut made = bristles(number, compliance * f64::exp(-stiffer), q);
                        for c in 0..2 {
                            made.nodes[0].saturation[c] += upstream[c];
                        }
                        Answer::to([0, 1].map(|k| pull[k] + pulled[k]), bound + raised, &made)
                    };
                    let answer = at(([0.0; 2], 0.0, [0.0; 2], 0.0));
                    assert_derivatives(&answer, at);
                    let p = answer.traction;
                    assert!(length(p) <= bound * (1.0 + 1e-12));
                    if length(p) > bound * (1.0 - 1e-12) {
                        continue;
                    }
                    let slid = [0, 1].map(|k| pull[k] - p[k]);
                    assert_relative_eq!(length(slid), answer.sliding, epsilon = 1e-12);
                    for k in 0..2 {
                        let kept = nodes(number).iter().fold(0.0, |sum, [weight, distance]| {
                            let x = distance * answer.sliding / compliance;
                            let g = if compliance > 0.0 { x / x.exp_m1() } else { 0.0 };
                            sum + compliance * weight * g * (q(*distance)[k] - p[k] / bound)
                        });
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
        for number in 0..4 {
            for relaxed in [1e-4, 0.3, 1.0, 3.0, 30.0] {
                let sliding = 0.7;
                let since = 3.0;
                let q = |distance: f64| {
                    let slid: f64 = relaxed * (since - distance);
                    along.map(|n| -(-slid).exp_m1() * n)
                };
                let exact = q(0.0).map(|q| bound * q);
                let pull = [0, 1].map(|c| exact[c] + sliding * along[c]);
                let answer = Answer::to(pull, bound, &bristles(number, sliding / relaxed, q));
                assert_relative_eq!(answer.sliding, sliding, max_relative = 1e-10);
                for c in 0..2 {
                    assert_relative_eq!(answer.traction[c], exact[c], max_relative = 1e-9);
                }
            }
        }
    }
}
