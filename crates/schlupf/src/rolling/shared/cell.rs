//! One cell on its own: the sliding s that solves μ pₙ law(s) + γ s = target.

use crate::interface::contact_law::{ContactLaw, Response, Slide};

/// Newton steps of a cell on its own.
const ITERATIONS: usize = 100;

/// Shortest part of such a step that is tried.
const SHORTEST: f64 = 1e-9;

/// Relative excess of a cell on its own that is left: far below any tolerance, above rounding.
const ACCURACY: f64 = 1e-13;

/// Relative excess from which on a last step needs no look at the law.
const NEAR: f64 = 1e-8;

/// Relative excess of a initial guess that needs no rival.
const GOOD: f64 = 1e-2;

/// The law of a contact, and γ (in Pa/m) beside it.
#[derive(Clone, Copy)]
pub(crate) struct CellSolver<'a> {
    pub law: &'a dyn ContactLaw,
    /// γ > 0, in Pa/m.
    pub gamma: f64,
}

impl CellSolver<'_> {
    /// Finds the sliding by Newton's method with a line search, from the increment in `slide`,
    /// where it leaves it. `bound` is μ pₙ. The equation is strongly monotone, so there is one.
    pub fn solve(&self, slide: &mut Slide, bound: f64, target: [f64; 2]) -> Response {
        // What cancels: a small pull is answered as exactly as a large one.
        let scale = bound * length(slide.traction) + length(target);
        let (mut response, mut rest) = self.first_guess(slide, bound, target, GOOD * scale);
        for _ in 0..ITERATIONS {
            let before = length(rest);
            if before <= ACCURACY * scale {
                break;
            }
            let step = solve_2x2(self.stiffness(&response, bound), rest);
            let start = slide.increment;
            if before <= NEAR * scale {
                // What is left after this step is beyond rounding.
                slide.increment = [start[0] - step[0], start[1] - step[1]];
                let fall = times(&response.by_increment, step);
                response.traction[0] -= fall[0];
                response.traction[1] -= fall[1];
                break;
            }
            let mut fraction = 1.0;
            loop {
                slide.increment = [start[0] - fraction * step[0], start[1] - fraction * step[1]];
                (response, rest) = self.excess(slide, bound, target);
                if length(rest) < before || fraction < SHORTEST {
                    break;
                }
                fraction *= 0.5;
            }
        }
        response
    }

    /// ∂(μ pₙ law)/∂s + γ, in Pa/m.
    pub fn stiffness(&self, response: &Response, bound: f64) -> [[f64; 2]; 2] {
        let [[xx, xy], [yx, yy]] = response.by_increment;
        [[bound * xx + self.gamma, bound * xy], [bound * yx, bound * yy + self.gamma]]
    }

    /// μ pₙ law(s) + γ s − target.
    fn excess(&self, slide: &Slide, bound: f64, target: [f64; 2]) -> (Response, [f64; 2]) {
        let response = self.law.respond(slide);
        let rest =
            |c: usize| bound * response.traction[c] + self.gamma * slide.increment[c] - target[c];
        (response, [rest(0), rest(1)])
    }

    /// The given increment, or that with Coulomb friction if the given one leaves more than `good`
    /// and this leaves less.
    fn first_guess(
        &self,
        slide: &mut Slide,
        bound: f64,
        target: [f64; 2],
        good: f64,
    ) -> (Response, [f64; 2]) {
        let given = self.excess(slide, bound, target);
        if length(given.1) <= good {
            return given;
        }
        let pull = length(target);
        let share = if pull > bound { 1.0 - bound / pull } else { 0.0 };
        let increment = target.map(|t| share * t / self.gamma);
        let like_coulomb = Slide { increment, ..*slide };
        let coulomb = self.excess(&like_coulomb, bound, target);
        if length(given.1) <= length(coulomb.1) {
            return given;
        }
        *slide = like_coulomb;
        coulomb
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

pub(crate) fn inverse_2x2(matrix: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [[a, b], [c, d]] = matrix;
    let determinant = a * d - b * c;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

pub(crate) fn solve_2x2(matrix: [[f64; 2]; 2], right: [f64; 2]) -> [f64; 2] {
    times(&inverse_2x2(matrix), right)
}

#[inline]
pub(crate) fn times(matrix: &[[f64; 2]; 2], v: [f64; 2]) -> [f64; 2] {
    let [[xx, xy], [yx, yy]] = *matrix;
    [xx * v[0] + xy * v[1], yx * v[0] + yy * v[1]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::contact_law::Incremental;

    /// From the softest law to Coulomb's, sticking and sliding, the local equation is solved.
    #[test]
    fn every_cell_finds_its_sliding() {
        for stiffness in [1.0, 1e6, 1e8, 1e12] {
            let law = Incremental::new(stiffness).unwrap();
            let cell = CellSolver { law: &law, gamma: 2e13 };
            for target in [[1e3, 0.0], [1e8, -5e7], [3e8, 2.9e8], [-4e9, 1e9], [0.0, 0.0]] {
                let mut slide = Slide { traction: [0.6, -0.7], ..Slide::default() };
                let response = cell.solve(&mut slide, 3e8, target);
                for c in 0..2 {
                    let sum = 3e8 * response.traction[c] + 2e13 * slide.increment[c];
                    assert!((sum - target[c]).abs() < 1e-6 * 3e8, "{stiffness} {target:?}: {sum}");
                }
            }
        }
    }
}
