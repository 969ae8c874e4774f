//! Traction of a point as a function of its sliding, Eq. (8).
//!
//! All laws are written for the traction on the *rail* divided by μ pₙ, q = −t/(μ pₙ): it points
//! along the sliding of the wheel, which avoids minus signs.

use std::fmt::Debug;
use std::sync::Arc;

use crate::error::{Error, require_positive};
use crate::quantity::Quantity;

/// A point that slides by an increment while it is carried over a cell.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slide {
    /// Traction on the rail divided by μ pₙ before the increment, dimensionless.
    pub traction: [f64; 2],
    /// Sliding distance since entry before the increment, in m.
    pub distance: [f64; 2],
    /// Increment of the sliding distance Δs, in m.
    pub increment: [f64; 2],
    /// Difference of the sliding, per length of one increment, between its end and its middle, in
    /// m: this, plus [`Self::turn_by_increment`] times the increment. An increment gives the
    /// direction of sliding half a cell upstream; this rotates it to the position of the point.
    pub turn: [f64; 2],
    /// Dependence of the turn on the increment, dimensionless.
    pub turn_by_increment: f64,
}

/// The response of the point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Response {
    /// Traction on the rail divided by μ pₙ, dimensionless; its magnitude is at most one.
    pub traction: [f64; 2],
    /// Its derivative with respect to the increment, row by row, in 1/m.
    pub by_increment: [[f64; 2]; 2],
    /// Its derivative with respect to the part of the turn that is independent of the increment,
    /// row by row, in 1/m.
    pub by_turn: [[f64; 2]; 2],
    /// Its derivative with respect to the previous traction: this times the identity matrix;
    /// dimensionless.
    pub by_traction: f64,
    /// Its derivative with respect to the previous distance, row by row, in 1/m.
    pub by_distance: [[f64; 2]; 2],
}

/// How a traction follows from the path of its point; k_c in 1/m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// From every part of it: dq = k_c (ds − q |ds|); Coulomb's law if k_c is infinite.
    Incremental {
        /// k_c.
        stiffness: f64,
    },
    /// From its ends.
    Total {
        /// k_c.
        stiffness: f64,
    },
}

impl Path {
    /// Whether both follow from the same of a path.
    pub fn is_like(&self, other: &Self) -> bool {
        matches!(
            (self, other),
            (Self::Incremental { .. }, Self::Incremental { .. })
                | (Self::Total { .. }, Self::Total { .. })
        )
    }
}

/// A law for the tangential traction. Extension point.
pub trait ContactLaw: Debug + Send + Sync {
    /// Traction after the increment.
    fn respond(&self, slide: &Slide) -> Response;

    /// The same law with another k_c (in 1/m); `None` if it has no such constant.
    fn with_stiffness(&self, _stiffness: f64) -> Result<Option<Arc<dyn ContactLaw>>, Error> {
        Ok(None)
    }

    /// k_c (in 1/m) of a law by which the traction over μ pₙ relaxes to the direction of sliding,
    /// dq = k_c (ds − q |ds|): if its bristles are stiff against the cells, they can be treated as
    /// in series with Coulomb's law. `None` for any other law.
    fn relaxation(&self) -> Option<f64> {
        None
    }

    /// How the traction follows from the path of the point.
    fn path(&self) -> Path;

    /// Whether this is Coulomb's law: where a point sticks, its traction is whatever equilibrium
    /// requires and no function of the sliding, so the solver must treat it in its own way.
    fn is_coulomb(&self) -> bool {
        false
    }
}

/// Eq. (8) of Neuhaus and Sextro (2014) in terms of the total sliding distance δ since entry: q =
/// (1 − exp(−k_c |δ|)) δ/|δ|. It holds for monotonic sliding in one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TotalDisplacement {
    stiffness: f64,
}

impl TotalDisplacement {
    /// The exponent k_c, in 1/m.
    pub fn new(stiffness: f64) -> Result<Self, Error> {
        require_positive(Quantity::ContactStiffness, stiffness)?;
        Ok(Self { stiffness })
    }

    fn response(traction: [f64; 2], by_distance: [[f64; 2]; 2]) -> Response {
        Response { traction, by_increment: by_distance, by_distance, ..Response::default() }
    }
}

impl ContactLaw for TotalDisplacement {
    fn respond(&self, slide: &Slide) -> Response {
        let k = self.stiffness;
        let distance =
            [slide.distance[0] + slide.increment[0], slide.distance[1] + slide.increment[1]];
        let length = length_of(distance);
        let z = k * length;
        if z < SMALL {
            return Self::response(distance.map(|d| k * d), diagonal(k));
        }
        let n = distance.map(|d| d / length);
        let saturation = -(-z).exp_m1();
        let along = k * (-z).exp();
        let traction = n.map(|n| saturation * n);
        Self::response(traction, direction_tensor(n, along, saturation / length))
    }

    fn with_stiffness(&self, stiffness: f64) -> Result<Option<Arc<dyn ContactLaw>>, Error> {
        Ok(Some(Arc::new(Self::new(stiffness)?)))
    }

    fn path(&self) -> Path {
        Path::Total { stiffness: self.stiffness }
    }
}

/// Eq. (8) applied to increments, correct for any path: q ← exp(−k_c |Δs|) q + (1 − exp(−k_c |Δs|))
/// Δs/|Δs|, q = 0 on entry.
///
/// Equal to [`TotalDisplacement`] for straight monotonic sliding. For k_c → ∞ it is Coulomb's law.
/// (Dahl 1968 has the same law for friction in bearings.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Incremental {
    stiffness: f64,
}

impl Default for Incremental {
    /// The law with [`Self::DEFAULT_STIFFNESS`].
    fn default() -> Self {
        Self { stiffness: Self::DEFAULT_STIFFNESS }
    }
}

impl Incremental {
    /// Default exponent k_c for unknown roughness, in 1/m.
    pub const DEFAULT_STIFFNESS: f64 = 5e6;

    /// The exponent k_c, in 1/m.
    pub fn new(stiffness: f64) -> Result<Self, Error> {
        require_positive(Quantity::ContactStiffness, stiffness)?;
        Ok(Self { stiffness })
    }
}

impl ContactLaw for Incremental {
    fn respond(&self, slide: &Slide) -> Response {
        let (k, q) = (self.stiffness, slide.traction);
        let length = length_of(slide.increment);
        let z = k * length;
        if z < SMALL {
            let traction = [q[0] + k * slide.increment[0], q[1] + k * slide.increment[1]];
            let by_increment = diagonal(k);
            return Response { traction, by_increment, by_traction: 1.0, ..Response::default() };
        }
        let m = [slide.increment[0] / length, slide.increment[1] / length];
        let saturation = saturation_of(z);
        let kept = 1.0 - saturation;
        let (seen, seen_slope) = seen_turn(0.5 * z, saturation);
        let turned = turned_increment(k, slide, length, seen, seen_slope);
        let end_length = length_of(turned.at_end).max(f64::MIN_POSITIVE);
        let n = [turned.at_end[0] / end_length, turned.at_end[1] / end_length];
        let across = direction_tensor(n, 0.0, saturation / end_length);
        let by_end_of_increment = product(&across, &turned.by_increment);
        let fade = k * kept;
        let by_increment =
            |r: usize, c: usize| fade * (n[r] - q[r]) * m[c] + by_end_of_increment[r][c];
        Response {
            traction: [kept * q[0] + saturation * n[0], kept * q[1] + saturation * n[1]],
            by_increment: [
                [by_increment(0, 0), by_increment(0, 1)],
                [by_increment(1, 0), by_increment(1, 1)],
            ],
            by_turn: product(&across, &turned.by_turn),
            by_traction: kept,
            ..Response::default()
        }
    }

    fn with_stiffness(&self, stiffness: f64) -> Result<Option<Arc<dyn ContactLaw>>, Error> {
        Ok(Some(Arc::new(Self::new(stiffness)?)))
    }

    fn relaxation(&self) -> Option<f64> {
        Some(self.stiffness)
    }

    fn path(&self) -> Path {
        Path::Incremental { stiffness: self.stiffness }
    }
}

/// Coulomb's law, the limit k_c → ∞ of both others: a point either does not slide at all, with any
/// |q| ≤ 1, or it slides with q = Δs/|Δs|.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coulomb;

impl ContactLaw for Coulomb {
    /// Without an increment the point keeps its traction, which is one of those that it may have;
    /// every derivative with respect to the increment is then infinite.
    fn respond(&self, slide: &Slide) -> Response {
        let length = length_of(slide.increment);
        if length == 0.0 {
            let by_increment = diagonal(f64::INFINITY);
            let traction = slide.traction;
            return Response { traction, by_increment, by_traction: 1.0, ..Response::default() };
        }
        let traction = slide.increment.map(|s| s / length);
        let by_increment = direction_tensor(traction, 0.0, length.recip());
        Response { traction, by_increment, ..Response::default() }
    }

    fn is_coulomb(&self) -> bool {
        true
    }

    fn path(&self) -> Path {
        Path::Incremental { stiffness: f64::INFINITY }
    }
}

/// Below this z = k_c |Δs| the law is linear to rounding error.
const SMALL: f64 = 1e-12;

/// The increment as if all of it had the direction of its end, and its derivatives.
struct TurnedIncrement {
    at_end: [f64; 2],
    by_increment: [[f64; 2]; 2],
    by_turn: [[f64; 2]; 2],
}

/// Rotates an increment s of length |s| from its middle to its end: s + share · T, where T is the
/// turn.
fn turned_increment(
    stiffness: f64,
    slide: &Slide,
    length: f64,
    seen: f64,
    seen_slope: f64,
) -> TurnedIncrement {
    let (s, own) = (slide.increment, slide.turn_by_increment);
    let turn = [slide.turn[0] + own * s[0], slide.turn[1] + own * s[1]];
    // A turn larger than the increment itself says little about the direction: it is limited to the
    // increment's length, by |s|/√(|s|² + |T|²).
    let turn_squared = turn[0] * turn[0] + turn[1] * turn[1];
    let diagonal = (length * length + turn_squared).sqrt();
    let limit = length / diagonal;
    let share = seen * limit;
    let over_cubed = diagonal.powi(3).recip();
    let share_slope = 0.5 * stiffness * seen_slope * limit + seen * turn_squared * over_cubed;
    let bent = seen * length * over_cubed;
    let mixed = -bent * turn[0] * turn[1];
    let by_turn =
        [[share - bent * turn[0] * turn[0], mixed], [mixed, share - bent * turn[1] * turn[1]]];
    let grown = share_slope / length;
    let by_increment = |r: usize, c: usize| turn[r] * grown * s[c] + own * by_turn[r][c];
    TurnedIncrement {
        at_end: [s[0] + share * turn[0], s[1] + share * turn[1]],
        by_increment: [
            [1.0 + by_increment(0, 0), by_increment(0, 1)],
            [by_increment(1, 0), 1.0 + by_increment(1, 1)],
        ],
        by_turn,
    }
}

/// The fraction of the turn between the middle and the end of an increment that affects the
/// traction, and its derivative, for z/2 = k_c |Δs|/2: the exact response of the law to a linearly
/// rotating direction is coth(z/2) − 2/z of it, which is zero in stick and one in full sliding.
///
/// `saturation` is 1 − exp(−z).
fn seen_turn(half: f64, saturation: f64) -> (f64, f64) {
    if half < 1e-2 {
        return (half / 3.0 * (1.0 - half * half / 15.0), 1.0 / 3.0 - half * half / 15.0);
    }
    let coth = (2.0 - saturation) / saturation;
    (coth - half.recip(), 1.0 - coth * coth + (half * half).recip())
}

fn product(a: &[[f64; 2]; 2], b: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let entry = |r: usize, c: usize| a[r][0] * b[0][c] + a[r][1] * b[1][c];
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

/// 1 − exp(−z), to rounding error.
fn saturation_of(z: f64) -> f64 {
    // Where nothing cancels the plain form is faster.
    if z > 0.5 { 1.0 - (-z).exp() } else { -(-z).exp_m1() }
}

/// √(x² + y²); the lengths that occur are far from overflow.
fn length_of([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// along · n nᵀ + across · (I − n nᵀ)
fn direction_tensor(n: [f64; 2], along: f64, across: f64) -> [[f64; 2]; 2] {
    let mixed = (along - across) * n[0] * n[1];
    [
        [across + (along - across) * n[0] * n[0], mixed],
        [mixed, across + (along - across) * n[1] * n[1]],
    ]
}

fn diagonal(k: f64) -> [[f64; 2]; 2] {
    [[k, 0.0], [0.0, k]]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const K: f64 = 5e6;

    /// Neuhaus and Sextro 2014, Eq. (8): for a prescribed straight slip the two forms agree to
    /// rounding error, however the path is divided.
    #[test]
    fn neuhaus_sextro_2014_both_forms_agree_for_a_straight_path() {
        let (total, incremental) =
            (TotalDisplacement::new(K).unwrap(), Incremental::new(K).unwrap());
        let direction = [0.6, -0.8];
        let mut state = Slide::default();
        let mut length = 0.0;
        for step in [1e-9, 3e-8, 1e-7, 5e-7, 2e-6] {
            state.increment = direction.map(|d| d * step);
            length += step;
            let answers = [total.respond(&state), incremental.respond(&state)];
            let expected = 1.0 - (-K * length).exp();
            for answer in answers {
                for (got, along) in answer.traction.iter().zip(direction) {
                    assert_relative_eq!(*got, expected * along, max_relative = 1e-13);
                }
            }
            state.traction = answers[1].traction;
            state.distance = direction.map(|d| d * length);
        }
    }

    /// A reversal: after sliding back by s from saturation the incremental law gives 2e^(−ks) − 1.
    #[test]
    fn dahl_1968_reversal() {
        let law = Incremental::new(K).unwrap();
        let state = Slide { traction: [1.0, 0.0], increment: [-2e-7, 0.0], ..Slide::default() };
        let expected = 2.0 * (-1.0_f64).exp() - 1.0;
        assert_relative_eq!(law.respond(&state).traction[0], expected, max_relative = 1e-14);
    }

    /// A change of one input of a slide.
    type Change = fn(&mut Slide, usize, f64);

    /// No law ever exceeds |t| = μ pₙ, and its derivatives are consistent with its value.
    #[test]
    fn derivatives_are_those_of_the_traction() {
        let laws: [&dyn ContactLaw; 2] =
            [&TotalDisplacement::new(K).unwrap(), &Incremental::new(K).unwrap()];
        for law in laws {
            for increment in [[1e-9, 2e-9], [-3e-7, 1e-7], [1e-6, -4e-6], [1e-10, 0.0]] {
                let state = Slide {
                    traction: [0.3, -0.5],
                    distance: [1e-7, -2e-7],
                    turn: [1e-8, -5e-8],
                    turn_by_increment: 0.4,
                    increment,
                };
                let answer = law.respond(&state);
                assert!(answer.traction[0].hypot(answer.traction[1]) <= 1.0);
                let kept = [[answer.by_traction, 0.0], [0.0, answer.by_traction]];
                let h = 1e-6 * increment[0].hypot(increment[1]);
                let checks: [(Change, f64, [[f64; 2]; 2]); 4] = [
                    (|s, c, h| s.increment[c] += h, h, answer.by_increment),
                    (|s, c, h| s.turn[c] += h, h, answer.by_turn),
                    (|s, c, h| s.distance[c] += h, h, answer.by_distance),
                    (|s, c, h| s.traction[c] += h, 1e-6, kept),
                ];
                for (number, (change, h, derivative)) in checks.into_iter().enumerate() {
                    check_derivative(law, &state, (change, h), &derivative, number);
                }
            }
        }
    }

    fn check_derivative(
        law: &dyn ContactLaw,
        state: &Slide,
        (change, h): (Change, f64),
        derivative: &[[f64; 2]; 2],
        number: usize,
    ) {
        for c in 0..2 {
            let shifted = |sign: f64| {
                let mut other = *state;
                change(&mut other, c, sign * h);
                law.respond(&other).traction
            };
            let (plus, minus) = (shifted(1.0), shifted(-1.0));
            for r in 0..2 {
                let difference = (plus[r] - minus[r]) / (2.0 * h);
                let scale = if number == 3 { 1.0 } else { K };
                assert!(
                    (derivative[r][c] - difference).abs() < 1e-5 * (scale + difference.abs()),
                    "{law:?} {state:?} {number}: {derivative:?} {difference}"
                );
            }
        }
    }

    /// The effective turn is continuous where the series takes over, and complete in full sliding.
    #[test]
    fn seen_turn_is_smooth_and_saturates() {
        let seen = |half: f64| seen_turn(half, saturation_of(2.0 * half));
        let (below, above) = (seen(0.999_999e-2), seen(1.000_001e-2));
        assert_relative_eq!(below.0, above.0, max_relative = 1e-4);
        assert_relative_eq!(below.1, above.1, max_relative = 1e-4);
        assert_relative_eq!(seen(1e6).0, 1.0, max_relative = 1e-5);
    }
}
