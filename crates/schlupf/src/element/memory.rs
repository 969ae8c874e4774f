//! The elastic shift of a contact: what it remembers of its motion.

use std::f64::consts::PI;

use crate::numerics::dual::Number;
use crate::solver::simplified::EllipticContact;

use super::patch::step;
use super::rolling::Rolling;

/// Relaxation of the creepages of a contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Memory {
    contact: EllipticContact,
    /// σ over a for each creepage, dimensionless.
    lengths: [f64; 3],
    /// Whether the forces of the method have a limit, at which all of the patch slides.
    has_limit: bool,
}

/// √3, the largest n of q, dimensionless: with it a shift at rest follows Cattaneo's curve, and n =
/// 3 of steady rolling, where all slides (Vermeulen and Johnson 1964), is n = 3/2 of q.
const LARGEST: f64 = 1.732_050_807_568_877_2;

/// Part of the n of sliding below which a patch at rest only deforms, dimensionless.
const ELASTIC: f64 = 0.8;

/// Least 1 − n²/3, dimensionless: the method's forces are those of sliding there.
const LEAST: f64 = 1e-9;

/// Speed over the relaxation lengths at which tractions vanish that the patch cannot bear any
/// more, or that there is no load for, in m/s.
const SHEDDING: f64 = 1.0;

/// Change of n in a step of time, dimensionless, and most of these steps: sliding takes some 100.
const SMALL_CHANGE: f64 = 0.02;
const MOST_STEPS: usize = 1000;

/// The patch of which creepages relax.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patch<T> {
    /// a and b, in m.
    pub semi_axes: [T; 2],
    /// μN, in N, above zero.
    pub limit: T,
    /// How far it is pressed on the rail: 0 without a load, 1 from the smallest patch on.
    pub pressed: T,
}

impl Memory {
    pub fn new(contact: &EllipticContact, poisson_ratio: f64, has_limit: bool) -> Self {
        let [a, b] = contact.normal.semi_axes();
        let [x, y] = shift_compliances([a, b], contact.shear_modulus, poisson_ratio)
            .map(|compliance| compliance + contact.layer_compliance() / (PI * a * b));
        let unit = contact.shear_modulus * a * b;
        let c = contact.coefficients;
        // The lateral force of spin relaxes as that of the lateral creepage does.
        let lateral = unit * c.c22 * y;
        let lengths = [unit * c.c11 * x, lateral, lateral].map(|s| s / a);
        Self { contact: *contact, lengths, has_limit }
    }

    /// Creepages or slip in the unit in which their length is n = G ab √((C11 ξ)² + (C22 η)² +
    /// (C23 √(ab) φ)²)/(μN): dimensionless, or in m/s.
    fn scaled<T: Number>(&self, patch: &Patch<T>, [x, y, spin]: [T; 3]) -> [T; 3] {
        if !self.has_limit {
            return [T::from(0.0); 3];
        }
        let ellipse = self.contact.ellipse(patch.semi_axes);
        let [c11, c22, c23, _] = ellipse.coefficients;
        let [a, b] = patch.semi_axes;
        let unit = a * b * self.contact.shear_modulus / patch.limit;
        [unit * c11 * x, unit * c22 * y, unit * c23 * ellipse.lever() * spin]
    }

    /// The creepages of steady rolling with the forces of an elastic shift, in m, and rad.
    pub fn steady<T: Number>(&self, patch: &Patch<T>, shift: [T; 3]) -> [T; 3] {
        let transient = self.transient(patch, shift);
        let over = length(self.scaled(patch, transient)) * LARGEST.recip();
        let left = T::from(1.0) - over * over;
        let left = if left.value() > LEAST { left } else { T::from(LEAST) }.sqrt();
        transient.map(|creepage| creepage / left)
    }

    /// Relaxation lengths, in m.
    fn lengths<T: Number>(&self, patch: &Patch<T>) -> [T; 3] {
        self.lengths.map(|length| patch.semi_axes[0] * length)
    }

    /// q, an elastic shift (in m, and rad) over the relaxation lengths: dimensionless, and in 1/m.
    fn transient<T: Number>(&self, patch: &Patch<T>, shift: [T; 3]) -> [T; 3] {
        let lengths = self.lengths(patch);
        std::array::from_fn(|k| shift[k] / lengths[k])
    }

    /// Rates of an elastic shift, in m/s, and rad/s.
    pub fn rates<T: Number>(
        &self,
        patch: &Patch<T>,
        (rolling, shift): (&Rolling<T>, [T; 3]),
    ) -> [T; 3] {
        let transient = self.transient(patch, shift);
        let decay = self.decay(patch, (rolling, transient));
        std::array::from_fn(|k| rolling.slip[k] * patch.pressed - decay * transient[k])
    }

    /// An elastic shift (in m, and rad) after a time (in s) with constant inputs: by sub-steps in
    /// which it changes by a small part of sliding, each with the decay in its middle.
    pub fn advance(
        &self,
        patch: &Patch<f64>,
        rolling: &Rolling<f64>,
        (states, duration): (&mut [f64; 3], f64),
    ) {
        let after = |from: [f64; 3], middle: [f64; 3], time: f64| {
            let lengths = self.lengths(patch);
            let decay = self.decay(patch, (rolling, self.transient(patch, middle)));
            std::array::from_fn(|k| {
                let parts = decay * time / lengths[k];
                let left = if parts > 0.0 { -(-parts).exp_m1() / parts } else { 1.0 };
                let rate = rolling.slip[k] * patch.pressed - decay * from[k] / lengths[k];
                from[k] + rate * time * left
            })
        };
        let mut left = duration;
        for _ in 0..MOST_STEPS {
            let rates = self.transient(patch, self.rates(patch, (rolling, *states)));
            let change = length(self.scaled(patch, rates));
            let time = left.min(SMALL_CHANGE / change.max(f64::MIN_POSITIVE));
            let middle = after(*states, *states, 0.5 * time);
            *states = after(*states, middle, time);
            left -= time;
            if left <= 0.0 {
                return;
            }
        }
        *states = after(*states, *states, left);
    }

    /// The speed over the relaxation lengths with which q decays, in m/s.
    fn decay<T: Number>(&self, patch: &Patch<T>, (rolling, transient): (&Rolling<T>, [T; 3])) -> T {
        let (passing, one) = (rolling.passing_speed(), T::from(1.0));
        let [slip, held] = [rolling.slip, transient].map(|of| self.scaled(patch, of));
        let [sliding, over] = [slip, held].map(length);
        let both = passing.hypot(sliding * LARGEST.recip());
        let mut decay = passing + (one - patch.pressed) * SHEDDING;
        if sliding.value() > 0.0 && over.value() > 0.0 {
            // Sliding begins near the n of steady rolling, and only in the direction of the slip.
            let along = dot(slip, held) / (sliding * over);
            let part = step((over * both / sliding - T::from(ELASTIC)) * (1.0 - ELASTIC).recip());
            decay = decay + (both - passing) * part * (one + along) * 0.5;
        }
        let excess = over * LARGEST.recip() - one;
        if excess.value() > 0.0 {
            let part = excess / (one + excess);
            decay = decay + part * part * SHEDDING;
        }
        decay
    }
}

fn dot<T: Number>(one: [T; 3], other: [T; 3]) -> T {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

fn length<T: Number>(of: [T; 3]) -> T {
    dot(of, of).sqrt()
}

/// Shift over force along x and y of two half-spaces that stick on an ellipse (in m/N), with their
/// combined constants G (in Pa) and ν:
///
/// (1/(πG)) ((1 − ν) I + ν I_c), I_c = (1/(4ab)) ∮ c² R dθ,  1/R² = cos²θ/a² + sin²θ/b²,
///
/// with c = cos θ for a shift along x, sin θ along y, and 1 in I (Mindlin 1949).
fn shift_compliances([a, b]: [f64; 2], shear_modulus: f64, poisson_ratio: f64) -> [f64; 2] {
    // The trapezoidal rule converges exponentially, the faster the rounder the ellipse.
    let count = (64.0 * (a / b).max(b / a)).ceil().min(1e5);
    let mut sums = [0.0; 2];
    for k in 0..count as usize {
        let (sin, cos) = (2.0 * PI * k as f64 / count).sin_cos();
        let radius = (cos / a).hypot(sin / b).recip();
        sums[0] += cos * cos * radius;
        sums[1] += sin * sin * radius;
    }
    let [x, y] = sums.map(|sum| sum * PI / (2.0 * a * b * count));
    [x, y].map(|own| ((1.0 - poisson_ratio) * (x + y) + poisson_ratio * own) / (PI * shear_modulus))
}
