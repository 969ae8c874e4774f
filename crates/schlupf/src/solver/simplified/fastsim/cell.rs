//! One step of FASTSIM: the traction on the rail from cell to cell down a strip.

#![expect(clippy::inline_always, reason = "a call would pass dozens of lanes through the memory")]

use crate::numerics::lanes::{Lanes, choose, dot, scaled, sum};

/// State that a cell passes on to the next one downstream.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carried<T: Lanes> {
    /// Traction on the rail, mean over the covered part of the cell, in Pa.
    pub traction: [T; 2],
    /// The square of its length, and its direction.
    square: T,
    direction: [T; 2],
    /// μ pₙ, in Pa.
    bound: T,
    /// Whether it slides.
    is_sliding: T::Mask,
}

impl<T: Lanes> Carried<T> {
    /// That of material that enters.
    pub fn entering() -> Self {
        let zero = T::from(0.0);
        let is_sliding = T::from(1.0).at_most(zero);
        let nothing = [zero; 2];
        Self { traction: nothing, square: zero, direction: nothing, bound: zero, is_sliding }
    }

    /// The path to the next cell, along which the traction would grow by `rigid` (in Pa) in
    /// adhesion.
    #[inline(always)]
    pub fn along(&self, rigid: [T; 2]) -> Step<T> {
        let grown = sum(self.traction, rigid);
        let square = dot(grown, grown);
        let length = square.sqrt();
        Step {
            grown,
            square,
            straight: scaled(T::from(1.0) / length, grown),
            turn: Turn::new(self.direction, rigid),
            bound: self.bound,
            turns: self.is_sliding & T::from(f64::MIN_POSITIVE).at_most(self.bound),
        }
    }

    /// The state after a small change of the traction, which changes the bound if it slides; in Pa
    /// both.
    #[inline(always)]
    pub fn moved(&self, change: [T; 2], bound: T) -> Self {
        let traction = sum(self.traction, change);
        let along = scaled(T::from(1.0) / bound, traction);
        Self {
            traction,
            square: T::choose(self.is_sliding, bound * bound, self.square),
            direction: choose(self.is_sliding, along, self.direction),
            bound,
            is_sliding: self.is_sliding,
        }
    }

    /// The traction with its length and direction.
    #[inline(always)]
    pub fn held(&self) -> Held<T> {
        let Self { traction, square, direction, .. } = *self;
        Held { traction, square, direction }
    }
}

/// A traction that will be limited, in Pa.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held<T> {
    traction: [T; 2],
    square: T,
    direction: [T; 2],
}

impl<T: Lanes> Held<T> {
    /// A traction, in Pa.
    #[inline(always)]
    pub fn of(traction: [T; 2]) -> Self {
        let square = dot(traction, traction);
        let direction = scaled(T::from(1.0) / square.sqrt(), traction);
        Self { traction, square, direction }
    }

    /// The traction limited to a bound (both in Pa), and its derivative with respect to the bound,
    /// dimensionless.
    #[inline(always)]
    pub fn under(&self, bound: T) -> [[T; 2]; 2] {
        let fits = self.square.at_most(bound * bound);
        let cut = scaled(bound, self.direction);
        let nothing = [T::from(0.0); 2];
        [choose(fits, self.traction, cut), choose(fits, nothing, self.direction)]
    }
}

/// A path from a cell to the next one, whatever the bound there.
///
/// If the traction in adhesion exceeds the bound the cell slides, with the traction along it. From
/// one sliding cell to the next the direction turns towards the growth in adhesion according to the
/// solution for constant growth and bound: tan ψ/2 decreases by the factor e^(−|growth|/μpₙ), where
/// ψ is the angle between the two. The error is therefore of second order in the cell size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<T: Lanes> {
    /// Traction in adhesion, in Pa, the square of its length, and its direction.
    grown: [T; 2],
    square: T,
    straight: [T; 2],
    turn: Turn<T>,
    /// μ pₙ in the cell before, in Pa.
    bound: T,
    /// Whether that cell slides.
    turns: T::Mask,
}

impl<T: Lanes> Step<T> {
    /// The state under μ pₙ (in Pa), and the derivative of its traction with respect to that bound,
    /// dimensionless.
    #[inline(always)]
    pub fn under(&self, bound: T) -> (Carried<T>, [T; 2]) {
        let (zero, one) = (T::from(0.0), T::from(1.0));
        let sticks = self.square.at_most(bound * bound);
        let (mut direction, mut by_bound) = (self.straight, self.straight);
        if T::any(self.turns) {
            let (turned, by_mean) = self.turn.under(T::from(0.5) * (self.bound + bound));
            direction = choose(self.turns, turned, direction);
            let turning = T::choose(self.turns, T::from(0.5) * by_mean, zero);
            let across = [-direction[1], direction[0]];
            by_bound = sum(direction, scaled(bound * turning, across));
        }
        let carried = Carried {
            traction: choose(sticks, self.grown, scaled(bound, direction)),
            square: T::choose(sticks, self.square, bound * bound),
            direction: choose(sticks, self.straight, direction),
            bound,
            is_sliding: T::choose(sticks, one, zero).at_most(zero),
        };
        (carried, choose(sticks, [zero; 2], by_bound))
    }
}

/// How a direction of sliding turns towards a growth of the traction in adhesion.
#[derive(Debug, Clone, Copy)]
struct Turn<T: Lanes> {
    from: [T; 2],
    /// Length (in Pa) and direction of the growth.
    length: T,
    towards: [T; 2],
    /// tan ψ/2 at first, dimensionless.
    half: T,
    is_pulled: T::Mask,
}

impl<T: Lanes> Turn<T> {
    #[inline(always)]
    fn new(from: [T; 2], pull: [T; 2]) -> Self {
        let (zero, one, least) = (T::from(0.0), T::from(1.0), T::from(f64::MIN_POSITIVE));
        let length = dot(pull, pull).sqrt();
        let towards = scaled(one / length, pull);
        let cos = dot(from, towards);
        let sin = towards[0] * from[1] - towards[1] * from[0];
        // Exactly opposite to the pull there is no side to turn to.
        let half = T::choose(least.at_most(one + cos), sin / (one + cos), zero);
        Self { from, length, towards, half, is_pulled: least.at_most(length) }
    }

    /// The direction under a bound (in Pa), and the derivative of its angle with respect to the
    /// bound, in 1/Pa.
    #[inline(always)]
    fn under(&self, bound: T) -> ([T; 2], T) {
        let Self { from, length, towards, half, is_pulled } = *self;
        let (one, two) = (T::from(1.0), T::from(2.0));
        let over_bound = one / bound;
        let nearer = length * over_bound;
        let half = half * (-nearer).decay();
        let over = one / (one + half * half);
        let [cos, sin] = [(one - half * half) * over, two * half * over];
        let turned = [towards[0] * cos - towards[1] * sin, towards[1] * cos + towards[0] * sin];
        let by_bound = T::choose(is_pulled, sin * nearer * over_bound, T::from(0.0));
        (choose(is_pulled, turned, from), by_bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    use wide::f64x4;

    /// θ' = −|w| sin θ/g from θ = 2 rad over |w|/g = 1.3, by small steps (Euler with step halving
    /// and extrapolation).
    #[test]
    fn the_turn_is_that_of_its_equation() {
        let euler = |steps: u32| {
            let mut theta = 2.0_f64;
            for _ in 0..steps {
                theta -= 1.3 / f64::from(steps) * theta.sin();
            }
            theta
        };
        let exact = 2.0 * euler(80_000) - euler(40_000);
        let ([x, y], _) = Turn::new([2.0_f64.cos(), 2.0_f64.sin()], [1.3, 0.0]).under(1.0);
        assert_relative_eq!(y.atan2(x), exact, max_relative = 1e-7);
    }

    #[test]
    fn traction_grows_until_it_slides() {
        let start = Carried::entering();
        let (sticking, _) = start.along([3.0, 0.0]).under(5.0);
        assert_eq!((sticking.traction, sticking.is_sliding), ([3.0, 0.0], false));
        let (sliding, _) = sticking.along([3.0, 0.0]).under(4.0);
        assert_eq!((sliding.traction, sliding.is_sliding), ([4.0, 0.0], true));
        let (turned_away, _) = sliding.along([-30.0, 0.0]).under(4.0);
        assert_relative_eq!(turned_away.traction[0], -4.0, max_relative = 1e-12);
    }

    /// Derivatives by the bound against central differences, and four lanes against single cells:
    /// cells that stick, that begin to slide, and that slide on and turn; and one without any pull.
    #[test]
    fn derivatives_are_those_of_differences_in_every_lane() {
        let sliding = Carried {
            traction: [3.0, -4.0],
            square: 25.0,
            direction: [0.6, -0.8],
            bound: 5.0,
            is_sliding: true,
        };
        let sticking = Carried { is_sliding: false, ..sliding };
        let cells = [
            (sticking, [0.5, 0.2], 9.0),
            (sticking, [0.5, 2.2], 3.0),
            (sliding, [2.5, 3.2], 4.5),
            (sliding, [0.0, 0.0], 4.5),
        ];
        let lanes = |of: &dyn Fn(usize) -> f64| f64x4::from([0, 1, 2, 3].map(of));
        let together = Carried {
            traction: [0, 1].map(|c| lanes(&|n| cells[n].0.traction[c])),
            square: lanes(&|n| cells[n].0.square),
            direction: [0, 1].map(|c| lanes(&|n| cells[n].0.direction[c])),
            bound: lanes(&|n| cells[n].0.bound),
            is_sliding: lanes(&|n| if cells[n].0.is_sliding { 0.0 } else { 1.0 })
                .at_most(f64x4::from(0.0)),
        };
        let pulls = [0, 1].map(|c| lanes(&|n| cells[n].1[c]));
        let (many, many_by_bound) = together.along(pulls).under(lanes(&|n| cells[n].2));
        let many_cut = together.held().under(lanes(&|n| cells[n].2));
        for (n, (from, pull, bound)) in cells.into_iter().enumerate() {
            let (step, held) = (from.along(pull), from.held());
            let at = |bound: f64| [step.under(bound).0.traction, held.under(bound)[0]];
            let by_bound = [step.under(bound).1, held.under(bound)[1]];
            let [more, less] = [at(bound + 1e-5), at(bound - 1e-5)];
            for c in 0..2 {
                for (part, exact) in by_bound.iter().enumerate() {
                    let difference = (more[part][c] - less[part][c]) / 2e-5;
                    assert_relative_eq!(exact[c], difference, epsilon = 1e-9);
                }
                let [next, limited] = at(bound);
                let close = |lane: f64x4, value: f64| {
                    assert_relative_eq!(lane.to_array()[n], value, epsilon = 1e-13);
                };
                close(many.traction[c], next[c]);
                close(many_by_bound[c], by_bound[0][c]);
                close(many_cut[0][c], limited[c]);
            }
        }
    }
}
