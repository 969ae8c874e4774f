//! The law of a cell as one equation, for bristles of any stiffness.
//!
//! Per cell let q = p/(μ pₙ) and v the sliding over the way into it. The incremental law dq = k_c
//! (ds − q |ds|) with the stencil of the slip applied to q, of which τ is the weight of the cell
//! itself and c the part of the cells upstream, is
//!
//! τ q + c = k_c (v − |v| q).
//!
//! With the pull Y = p + γ v, κ = τ γ/k_c, G = c γ/k_c and m = γ |v| (all in Pa) this is a traction
//! p = R(Y, G) that follows from one number:
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

/// Power of |q| with which the first cell hides the entry from stencils, dimensionless.
const HIDDEN: i32 = 3;

/// What stands for p/(μ pₙ) at the entry in a stencil, given that of the first cell, with its
/// derivative; dimensionless both. It is zero, with which material enters, up to an error of fourth
/// order in the sliding of the first cell; bristles that relax on the way into that cell jump at the
/// entry, and a polynomial is not to pass through the jump.
pub(in crate::rolling) fn entry_value(first: [f64; 2]) -> ([f64; 2], Matrix) {
    let size = length(first).min(1.0);
    let hidden = size.powi(HIDDEN);
    let n = first.map(|q| if size > 0.0 { q / size } else { 0.0 });
    let steeper = f64::from(HIDDEN);
    let by = [0, 1]
        .map(|r| [0, 1].map(|c| hidden * (if r == c { 1.0 } else { 0.0 } + steeper * n[r] * n[c])));
    (first.map(|q| hidden * q), by)
}

/// What the material of a cell brings along, in Pa.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Bristles {
    /// κ; zero without bristles.
    pub own: f64,
    /// G.
    pub inherited: [f64; 2],
}

impl Bristles {
    /// From c, τ and γ/k_c (in Pa).
    pub fn that_inherit(c: [f64; 2], own: f64, compliance: f64) -> Self {
        Self { own: compliance * own, inherited: c.map(|c| compliance * c) }
    }
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
    /// By what is inherited, dimensionless.
    pub by_inherited: Matrix,
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
        let answer = Self::unbounded(pull, bound, bristles);
        let size = length(answer.traction);
        if size <= bound { answer } else { answer.reduced(size, bound) }
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
            sliding: self.sliding,
            by_pull: block(self.by_pull),
            by_inherited: block(self.by_inherited),
            by_bound: [0, 1].map(|c| by_bound[c] + n[c]),
            by_stiffness: across(self.by_stiffness),
        }
    }

    fn unbounded(pull: [f64; 2], bound: f64, bristles: &Bristles) -> Self {
        let Bristles { own, inherited } = *bristles;
        if own == 0.0 && length(pull) <= bound {
            let by_pull = [[1.0, 0.0], [0.0, 1.0]];
            return Self { traction: pull, by_pull, ..Self::default() };
        }
        let sliding = sliding(pull, bound, bristles);
        let whole = bound + own + sliding;
        let free = own + sliding;
        let along = [0, 1].map(|c| free * pull[c] + bound * inherited[c]);
        let size = length(along);
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let steepness = (whole + sliding - dot(pull)).recip();
        let share = bound / whole;
        let traction = [0, 1].map(|c| share * (pull[c] - inherited[c]));
        let part = traction.map(|p| p / whole);
        let block = |own: f64, slides: f64| {
            [0, 1]
                .map(|r| [0, 1].map(|c| (if r == c { own } else { 0.0 }) - part[r] * slides * n[c]))
        };
        let by_bound = (dot(inherited) - sliding) * steepness;
        let by_own = (dot(pull) - sliding) * steepness;
        let stiffer = -(own * by_own + bound * dot(inherited) * steepness);
        Self {
            traction,
            sliding,
            by_pull: block(share, free * steepness),
            by_inherited: block(-share, bound * steepness),
            by_bound: [0, 1]
                .map(|c| (1.0 - share) * (pull[c] - inherited[c]) / whole - part[c] * by_bound),
            by_stiffness: [0, 1].map(|c| share * inherited[c] + part[c] * (own - stiffer)),
        }
    }

    /// Of a point that slides straight by s from a saturation q before, p = μpₙ (e q + (1 − e) s/|s|)
    /// with e = exp(−k_c |s|), under the pull p + γ s and with γ/k_c (in Pa).
    pub fn straight(pull: [f64; 2], bound: f64, before: [f64; 2], compliance: f64) -> Self {
        let Straight { sliding, left, relaxed, rest } = straight(pull, bound, before, compliance);
        let size = length(rest);
        let n = rest.map(|rest| if size > 0.0 { rest / size } else { 0.0 });
        let dot = |v: [f64; 2]| n[0] * v[0] + n[1] * v[1];
        let growth = bound * left / compliance;
        let steepness = (1.0 + growth * (1.0 - dot(before))).recip();
        let turn = if size > 0.0 { sliding / size } else { steepness };
        // The traction is the pull less m n.
        let by = |sliding: f64, rest: [f64; 2]| {
            let rest = [0, 1].map(|c| rest[c] + growth * before[c] * sliding);
            let along = dot(rest);
            [0, 1].map(|c| -n[c] * sliding - turn * (rest[c] - along * n[c]))
        };
        let column = |pull: [f64; 2]| {
            let moved = by(dot(pull) * steepness, pull);
            [pull[0] + moved[0], pull[1] + moved[1]]
        };
        let [[xx, yx], [xy, yy]] = [column([1.0, 0.0]), column([0.0, 1.0])];
        let raised = -(1.0 - left + left * dot(before)) * steepness;
        let faded = growth * sliding;
        let stiffer = -faded * (1.0 - dot(before)) * steepness;
        Self {
            traction: [0, 1].map(|c| bound * (left * before[c] + relaxed * n[c])),
            sliding,
            by_pull: [[xx, xy], [yx, yy]],
            by_bound: by(raised, before.map(|q| -left * q)),
            by_stiffness: by(stiffer, before.map(|q| faded * q)),
            ..Self::default()
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
    let Bristles { own, inherited } = *bristles;
    let size = length(pull);
    if own == 0.0 {
        return (size - bound).max(0.0);
    }
    // With the triangle inequality in place of the sum.
    let half = 0.5 * (bound + own - size);
    let rest = size * own + bound * length(inherited);
    let root = (half * half + rest).sqrt();
    let mut high = if half > 0.0 { rest / (half + root) } else { root - half };
    let (mut low, mut at) = (0.0, high);
    for _ in 0..STEPS {
        let along = [0, 1].map(|c| (own + at) * pull[c] + bound * inherited[c]);
        let size = length(along);
        let excess = at * (bound + own + at) - size;
        if excess > 0.0 {
            high = at
        } else {
            low = at
        }
        let n = along.map(|along| if size > 0.0 { along / size } else { 0.0 });
        let slope = bound + own + 2.0 * at - (n[0] * pull[0] + n[1] * pull[1]);
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

/// How a point slides straight: m in Pa, e and 1 − e, and the pull less what is left of the traction
/// before, in Pa.
struct Straight {
    sliding: f64,
    left: f64,
    relaxed: f64,
    rest: [f64; 2],
}

fn straight(pull: [f64; 2], bound: f64, before: [f64; 2], compliance: f64) -> Straight {
    let at = |sliding: f64| {
        let left = (-sliding / compliance).exp();
        let relaxed = -(-sliding / compliance).exp_m1();
        let rest = [0, 1].map(|c| pull[c] - bound * left * before[c]);
        Straight { sliding, left, relaxed, rest }
    };
    let size = length(pull);
    let (mut low, mut high) = ((size - bound).max(0.0), size + bound);
    let mut now = at(low);
    for _ in 0..STEPS {
        let Straight { sliding, left, relaxed, rest } = now;
        let length = length(rest);
        let excess = bound * relaxed + sliding - length;
        if excess > 0.0 {
            high = sliding
        } else {
            low = sliding
        }
        let along = if length > 0.0 { rest[0] * before[0] + rest[1] * before[1] } else { 0.0 };
        let along = if length > 0.0 { along / length } else { 0.0 };
        let next = sliding - excess / (1.0 + bound * left / compliance * (1.0 - along));
        let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
        let is_near = (next - sliding).abs() <= ACCURACY * next;
        now = at(next);
        if is_near {
            break;
        }
    }
    now
}

pub(in crate::rolling) fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const H: f64 = 1e-6;

    /// Central differences of an answer by each of its arguments.
    fn differences(at: impl Fn([f64; 2], f64, [f64; 2], f64) -> Answer) -> [[f64; 2]; 6] {
        let difference = |plus: Answer, minus: Answer| {
            [0, 1].map(|c| (plus.traction[c] - minus.traction[c]) / (2.0 * H))
        };
        let along = |c: usize, h: f64| [0, 1].map(|k| if k == c { h } else { 0.0 });
        let by_pull = |c| {
            difference(at(along(c, H), 0.0, [0.0; 2], 0.0), at(along(c, -H), 0.0, [0.0; 2], 0.0))
        };
        let by_inherited = |c| {
            difference(at([0.0; 2], 0.0, along(c, H), 0.0), at([0.0; 2], 0.0, along(c, -H), 0.0))
        };
        let by_bound = difference(at([0.0; 2], H, [0.0; 2], 0.0), at([0.0; 2], -H, [0.0; 2], 0.0));
        let by_stiffness =
            difference(at([0.0; 2], 0.0, [0.0; 2], H), at([0.0; 2], 0.0, [0.0; 2], -H));
        [by_pull(0), by_pull(1), by_inherited(0), by_inherited(1), by_bound, by_stiffness]
    }

    fn assert_derivatives(answer: &Answer, found: [[f64; 2]; 6]) {
        let [x, y, inherited_x, inherited_y, by_bound, by_stiffness] = found;
        for r in 0..2 {
            for (exact, found) in [
                (answer.by_pull[r][0], x[r]),
                (answer.by_pull[r][1], y[r]),
                (answer.by_inherited[r][0], inherited_x[r]),
                (answer.by_inherited[r][1], inherited_y[r]),
                (answer.by_bound[r], by_bound[r]),
                (answer.by_stiffness[r], by_stiffness[r]),
            ] {
                assert_relative_eq!(exact, found, epsilon = 1e-7, max_relative = 1e-6);
            }
        }
    }

    /// The law holds for the sliding that is found, τ q + c = k_c (v − |v| q), and derivatives are
    /// those of central differences, from soft bristles to none.
    #[test]
    fn the_law_holds_in_a_cell() {
        for pull in [[0.3, -0.2], [0.3, -0.8], [-2.0, 1.0], [1e-6, 0.0]] {
            for (own, c) in
                [(3.0, [0.2, 0.4]), (0.1, [-0.6, 0.3]), (1e-6, [0.5, -0.5]), (0.0, [0.0; 2])]
            {
                let bound = 0.5;
                let at = |pulled: [f64; 2], raised: f64, inherited: [f64; 2], stiffer: f64| {
                    let softer = (-stiffer).exp();
                    let bristles = Bristles {
                        own: softer * own,
                        inherited: [0, 1].map(|k| softer * own * c[k] + inherited[k]),
                    };
                    let pull = [0, 1].map(|k| pull[k] + pulled[k]);
                    Answer::to(pull, bound + raised, &bristles)
                };
                let answer = at([0.0; 2], 0.0, [0.0; 2], 0.0);
                let p = answer.traction;
                assert!(length(p) < bound * (1.0 + 1e-9));
                let slid = [0, 1].map(|k| pull[k] - p[k]);
                assert_relative_eq!(length(slid), answer.sliding, epsilon = 1e-12);
                for k in 0..2 {
                    let kept = own * p[k] / bound + own * c[k];
                    let stretched = slid[k] - answer.sliding * p[k] / bound;
                    assert_relative_eq!(kept, stretched, epsilon = 1e-10);
                }
                if own == 0.0 || own > 1e-3 {
                    let mut found = differences(at);
                    if own == 0.0 {
                        // Nothing is inherited without bristles.
                        [found[2], found[3]] =
                            [0, 1].map(|c| answer.by_inherited.map(|row| row[c]));
                    }
                    assert_derivatives(&answer, found);
                }
            }
        }
    }

    /// The same of straight paths: p/(μ pₙ) relaxes to the direction of sliding.
    #[test]
    fn the_law_holds_along_a_straight_path() {
        for pull in [[0.3, -0.2], [-2.0, 1.0], [1e-3, 2e-3]] {
            for (compliance, before) in [(3.0, [0.2, 0.4]), (0.1, [0.0; 2]), (0.05, [-0.9, 0.3])] {
                let bound = 0.5;
                let at = |pulled: [f64; 2], raised: f64, _: [f64; 2], stiffer: f64| {
                    let pull = [0, 1].map(|k| pull[k] + pulled[k]);
                    Answer::straight(pull, bound + raised, before, compliance * (-stiffer).exp())
                };
                let answer = at([0.0; 2], 0.0, [0.0; 2], 0.0);
                let slid = [0, 1].map(|k| pull[k] - answer.traction[k]);
                assert_relative_eq!(length(slid), answer.sliding, epsilon = 1e-12);
                let left = (-answer.sliding / compliance).exp();
                for k in 0..2 {
                    let along = slid[k] / answer.sliding;
                    let law = bound * (left * before[k] + (1.0 - left) * along);
                    assert_relative_eq!(answer.traction[k], law, epsilon = 1e-11);
                }
                assert_derivatives(&answer, differences(at));
            }
        }
    }
}
