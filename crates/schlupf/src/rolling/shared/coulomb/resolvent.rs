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

/// What the material of a cell brings along, in Pa.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct Bristles {
    /// κ; zero without bristles.
    pub own: f64,
    /// G.
    pub inherited: [f64; 2],
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
    /// Under a pull, with a bound μ pₙ (both in Pa).
    pub fn to(pull: [f64; 2], bound: f64, bristles: &Bristles) -> Self {
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
            [0, 1].map(|r| {
                [0, 1].map(|c| (if r == c { own } else { 0.0 }) - part[r] * slides * n[c])
            })
        };
        let by_bound = (dot(inherited) - sliding) * steepness;
        let by_own = (dot(pull) - sliding) * steepness;
        let stiffer = -(own * by_own + bound * dot(inherited) * steepness);
        Self {
            traction,
            sliding,
            by_pull: block(share, free * steepness),
            by_inherited: block(-share, bound * steepness),
            by_bound: [0, 1].map(|c| {
                (1.0 - share) * (pull[c] - inherited[c]) / whole - part[c] * by_bound
            }),
            by_stiffness: [0, 1].map(|c| share * inherited[c] + part[c] * (own - stiffer)),
        }
    }

    /// Of the law in the total displacement: p = μpₙ (1 − exp(−k_c |S|)) S/|S|, with the pull p + γ
    /// S and γ/k_c (in Pa).
    pub fn in_total(pull: [f64; 2], bound: f64, compliance: f64) -> Self {
        let size = length(pull);
        // Concave, and negative where Newton's method begins.
        let mut sliding = (size - bound).max(0.0);
        for _ in 0..STEPS {
            let left = (-sliding / compliance).exp();
            let rest = size - bound * (1.0 - left) - sliding;
            let step = rest / (1.0 + bound * left / compliance);
            sliding += step;
            if step.abs() <= ACCURACY * sliding {
                break;
            }
        }
        let left = (-sliding / compliance).exp();
        let softness = (1.0 + bound * left / compliance).recip();
        let n = pull.map(|q| if size > 0.0 { q / size } else { 0.0 });
        let along = 1.0 - softness;
        let across = if size > 0.0 { 1.0 - sliding / size } else { along };
        let by_pull = [0, 1].map(|r| {
            [0, 1].map(|c| (if r == c { across } else { 0.0 }) + (along - across) * n[r] * n[c])
        });
        let stiffer = bound * left * sliding / compliance * softness;
        Self {
            traction: pull.map(|q| across * q),
            sliding,
            by_pull,
            by_bound: n.map(|n| n * (1.0 - left) * softness),
            by_stiffness: n.map(|n| n * stiffer),
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
        if excess > 0.0 { high = at } else { low = at }
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

pub(in crate::rolling) fn product_2x2(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [row[0] * b[0][0] + row[1] * b[1][0], row[0] * b[0][1] + row[1] * b[1][1]])
}
