//! One cell on its own: the sliding s that solves μ pₙ law(s) + γ s = target.

use crate::interface::contact_law::{ContactLaw, Response, Slide};

/// Newton steps of a cell on its own.
const ITERATIONS: usize = 100;

/// Shortest part of such a step that is tried.
const SHORTEST: f64 = 1e-9;

/// Relative accuracy of a cell on its own.
const ROUNDING: f64 = 1e-15;

/// The law of a contact, and γ (in Pa/m) beside it.
#[derive(Clone, Copy)]
pub(super) struct CellSolver<'a> {
    pub law: &'a dyn ContactLaw,
    /// γ > 0, in Pa/m.
    pub gamma: f64,
}

impl CellSolver<'_> {
    /// Finds the sliding by Newton's method with a line search, from the increment in `slide`,
    /// where it leaves it. `bound` is μ pₙ. The equation is strongly monotone, so there is one.
    pub fn solve(&self, slide: &mut Slide, bound: f64, target: [f64; 2]) -> Response {
        let (mut response, mut rest) = self.first_guess(slide, bound, target);
        let enough = ROUNDING * (bound + target[0].hypot(target[1]));
        for _ in 0..ITERATIONS {
            let length = rest[0].hypot(rest[1]);
            if length <= enough {
                break;
            }
            let step = solve_2x2(self.stiffness(&response, bound), rest);
            let start = slide.increment;
            let mut fraction = 1.0;
            loop {
                slide.increment = [0, 1].map(|c| start[c] - fraction * step[c]);
                (response, rest) = self.excess(slide, bound, target);
                if rest[0].hypot(rest[1]) < length || fraction < SHORTEST {
                    break;
                }
                fraction *= 0.5;
            }
        }
        response
    }

    /// ∂(μ pₙ law)/∂s + γ, in Pa/m.
    pub fn stiffness(&self, response: &Response, bound: f64) -> [[f64; 2]; 2] {
        let [[xx, xy], [yx, yy]] = response.by_increment.map(|row| row.map(|d| bound * d));
        [[xx + self.gamma, xy], [yx, yy + self.gamma]]
    }

    /// μ pₙ law(s) + γ s − target.
    fn excess(&self, slide: &Slide, bound: f64, target: [f64; 2]) -> (Response, [f64; 2]) {
        let response = self.law.respond(slide);
        let rest = [0, 1]
            .map(|c| bound * response.traction[c] + self.gamma * slide.increment[c] - target[c]);
        (response, rest)
    }

    /// The better of where the cell slid last and where it would with Coulomb friction.
    fn first_guess(&self, slide: &mut Slide, bound: f64, target: [f64; 2]) -> (Response, [f64; 2]) {
        let last = self.excess(slide, bound, target);
        let length = target[0].hypot(target[1]);
        let share = if length > bound { 1.0 - bound / length } else { 0.0 };
        let increment = target.map(|t| share * t / self.gamma);
        let like_coulomb = Slide { increment, ..*slide };
        let coulomb = self.excess(&like_coulomb, bound, target);
        if last.1[0].hypot(last.1[1]) <= coulomb.1[0].hypot(coulomb.1[1]) {
            return last;
        }
        *slide = like_coulomb;
        coulomb
    }
}

pub(super) fn inverse_2x2(matrix: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [[a, b], [c, d]] = matrix;
    let determinant = a * d - b * c;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

pub(super) fn solve_2x2(matrix: [[f64; 2]; 2], right: [f64; 2]) -> [f64; 2] {
    times(&inverse_2x2(matrix), right)
}

pub(super) fn times(matrix: &[[f64; 2]; 2], v: [f64; 2]) -> [f64; 2] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1])
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
