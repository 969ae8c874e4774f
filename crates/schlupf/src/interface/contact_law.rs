//! How the traction of a point depends on its sliding, Eq. (8).
//!
//! Everything here is written for the traction on the *rail* over μ pₙ, q = −t/(μ pₙ): it points
//! along the sliding of the wheel, so no signs are in the way.

use std::fmt::Debug;

use crate::error::{Error, require_positive};

/// A point that slides by an increment while it is carried over a cell.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slide {
    /// Traction on the rail over μ pₙ before the increment, dimensionless.
    pub traction: [f64; 2],
    /// Sliding distance since entry before the increment, in m.
    pub distance: [f64; 2],
    /// Increment of the sliding distance Δs, in m.
    pub increment: [f64; 2],
    /// By how much the rigid slip, over one increment, differs between the end and the middle of
    /// the increment, in m. An increment tells the direction of sliding half a cell upstream; with
    /// spin this turns it to where the point is.
    pub turn: [f64; 2],
}

/// What the point answers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Response {
    /// Traction on the rail over μ pₙ, dimensionless; its magnitude is at most one.
    pub traction: [f64; 2],
    /// Its derivative with respect to the increment, row by row, in 1/m.
    pub by_increment: [[f64; 2]; 2],
}

/// A law for the tangential traction. Extension point.
pub trait ContactLaw: Debug + Send + Sync {
    /// Traction after the increment.
    fn respond(&self, slide: &Slide) -> Response;
}

/// Eq. (8) of Neuhaus and Sextro (2014) in terms of the total sliding distance δ since entry:
/// q = (1 − exp(−k_c |δ|)) δ/|δ|. It holds for monotone sliding in one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TotalDisplacement {
    stiffness: f64,
}

impl TotalDisplacement {
    /// The exponent k_c, in 1/m.
    pub fn new(stiffness: f64) -> Result<Self, Error> {
        require_positive("contact_law.stiffness", stiffness, "1/m")?;
        Ok(Self { stiffness })
    }
}

impl ContactLaw for TotalDisplacement {
    fn respond(&self, slide: &Slide) -> Response {
        let k = self.stiffness;
        let distance =
            [slide.distance[0] + slide.increment[0], slide.distance[1] + slide.increment[1]];
        let length = distance[0].hypot(distance[1]);
        let z = k * length;
        if z < SMALL {
            return Response { traction: distance.map(|d| k * d), by_increment: diagonal(k) };
        }
        let n = distance.map(|d| d / length);
        let saturation = -(-z).exp_m1();
        let along = k * (-z).exp();
        Response {
            traction: n.map(|n| saturation * n),
            by_increment: direction_tensor(n, along, saturation / length),
        }
    }
}

/// Eq. (8) applied to increments, right for any path:
/// q ← exp(−k_c |Δs|) q + (1 − exp(−k_c |Δs|)) Δs/|Δs|, q = 0 on entry.
///
/// Equal to [`TotalDisplacement`] for straight monotone sliding. With k_c → ∞ it is Coulomb's law.
/// (Dahl 1968 has the same law for friction in bearings.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Incremental {
    stiffness: f64,
}

impl Incremental {
    /// The exponent k_c, in 1/m.
    pub fn new(stiffness: f64) -> Result<Self, Error> {
        require_positive("contact_law.stiffness", stiffness, "1/m")?;
        Ok(Self { stiffness })
    }
}

impl ContactLaw for Incremental {
    fn respond(&self, slide: &Slide) -> Response {
        let (k, q) = (self.stiffness, slide.traction);
        let length = slide.increment[0].hypot(slide.increment[1]);
        let z = k * length;
        if z < SMALL {
            let traction = [q[0] + k * slide.increment[0], q[1] + k * slide.increment[1]];
            return Response { traction, by_increment: diagonal(k) };
        }
        let m = slide.increment.map(|s| s / length);
        let (share, slope) = turned_share(k, length, slide.turn);
        let at_end = [0, 1].map(|c| slide.increment[c] + share * slide.turn[c]);
        let end_length = at_end[0].hypot(at_end[1]).max(f64::MIN_POSITIVE);
        let n = at_end.map(|s| s / end_length);
        let (kept, saturation) = ((-z).exp(), -(-z).exp_m1());
        let across = direction_tensor(n, 0.0, saturation / end_length);
        // ∂(at_end)/∂(increment) = I + slope · turn ⊗ m
        let push = across.map(|row| slope * (row[0] * slide.turn[0] + row[1] * slide.turn[1]));
        Response {
            traction: std::array::from_fn(|c| kept * q[c] + saturation * n[c]),
            by_increment: std::array::from_fn(|r| {
                std::array::from_fn(|c| {
                    k * kept * (n[r] - q[r]) * m[c] + across[r][c] + push[r] * m[c]
                })
            }),
        }
    }
}

/// Below this z = k_c |Δs| the law is linear to rounding.
const SMALL: f64 = 1e-12;

/// How much of the turn between middle and end of an increment of length `length` the traction
/// sees, and the derivative with respect to the length, in 1/m.
///
/// The law's exact answer to a direction that turns linearly on the way is coth(z/2) − 2/z of it,
/// z = k_c |Δs|: nothing while sticking, all of it in full sliding. Where the turn exceeds the
/// increment itself it says little about the direction, and is limited to the increment's length.
fn turned_share(stiffness: f64, length: f64, turn: [f64; 2]) -> (f64, f64) {
    let half = 0.5 * stiffness * length;
    let (seen, seen_slope) = if half < 1e-2 {
        (half / 3.0 * (1.0 - half * half / 15.0), 1.0 / 3.0 - half * half / 15.0)
    } else {
        let coth = half.tanh().recip();
        (coth - half.recip(), 1.0 - coth * coth + (half * half).recip())
    };
    let turn_squared = turn[0] * turn[0] + turn[1] * turn[1];
    let diagonal = (length * length + turn_squared).sqrt();
    let limit = length / diagonal;
    let limit_slope = turn_squared / diagonal.powi(3);
    (seen * limit, 0.5 * stiffness * seen_slope * limit + seen * limit_slope)
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

    fn slide(increment: [f64; 2]) -> Slide {
        Slide { increment, ..Slide::default() }
    }

    /// Neuhaus and Sextro 2014, Eq. (8): for a prescribed straight slip the two forms agree to
    /// rounding, however the path is cut.
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

    /// A reversal: after sliding back by s the incremental law gives 2e^(−ks) − 1 from saturation.
    #[test]
    fn dahl_1968_reversal() {
        let law = Incremental::new(K).unwrap();
        let state = Slide { traction: [1.0, 0.0], increment: [-2e-7, 0.0], ..Slide::default() };
        let expected = 2.0 * (-1.0_f64).exp() - 1.0;
        assert_relative_eq!(law.respond(&state).traction[0], expected, max_relative = 1e-14);
    }

    /// No law ever exceeds |t| = μ pₙ, and its derivative is that of its value.
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
                    ..slide(increment)
                };
                let answer = law.respond(&state);
                assert!(answer.traction[0].hypot(answer.traction[1]) <= 1.0);
                for c in 0..2 {
                    let h = 1e-6 * increment[0].hypot(increment[1]);
                    let shifted = |sign: f64| {
                        let mut other = state;
                        other.increment[c] += sign * h;
                        law.respond(&other).traction
                    };
                    let (plus, minus) = (shifted(1.0), shifted(-1.0));
                    for r in 0..2 {
                        let difference = (plus[r] - minus[r]) / (2.0 * h);
                        assert_relative_eq!(
                            answer.by_increment[r][c],
                            difference,
                            epsilon = 1e-5 * K,
                            max_relative = 1e-5
                        );
                    }
                }
            }
        }
    }

    /// The share of the turn and its slope are continuous where the series takes over, and all of
    /// a small turn is seen in full sliding.
    #[test]
    fn turned_share_is_smooth_and_saturates() {
        let turn = [0.0, 1e-10];
        let at = |half: f64| turned_share(K, 2.0 * half / K, turn);
        let (below, above) = (at(0.999_999e-2), at(1.000_001e-2));
        assert_relative_eq!(below.0, above.0, max_relative = 1e-4);
        assert_relative_eq!(below.1, above.1, max_relative = 1e-4);
        assert_relative_eq!(at(1e6).0, 1.0, max_relative = 1e-5);
    }
}
