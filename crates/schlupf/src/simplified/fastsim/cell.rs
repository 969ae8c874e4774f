//! One step of FASTSIM: the traction on the rail from cell to cell down a strip.

/// State that a cell passes on to the next one downstream.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Carried {
    /// Traction on the rail, mean over the covered part of the cell, in Pa.
    pub traction: [f64; 2],
    /// μ pₙ, in Pa.
    pub bound: f64,
    /// Whether it slides.
    pub is_sliding: bool,
}

impl Carried {
    /// The state after a path along which the traction would grow by `rigid` (in Pa) in adhesion,
    /// under μ pₙ (in Pa).
    ///
    /// If the sum exceeds the bound the cell slides, with the traction along that sum. From one
    /// sliding cell to the next the direction turns towards `rigid` according to the solution for
    /// constant `rigid` and bound: tan ψ/2 decreases by the factor e^(−|rigid|/μpₙ), where ψ is the
    /// angle between the two. The error is therefore of second order in the cell size.
    #[inline]
    pub fn next(&self, rigid: [f64; 2], bound: f64) -> Self {
        let sum = [self.traction[0] + rigid[0], self.traction[1] + rigid[1]];
        let square = sum[0] * sum[0] + sum[1] * sum[1];
        if square <= bound * bound {
            return Self { traction: sum, bound, is_sliding: false };
        }
        let direction = if self.is_sliding && self.bound > 0.0 {
            turned(self.traction.map(|t| t / self.bound), rigid, 0.5 * (self.bound + bound))
        } else {
            let length = square.sqrt();
            sum.map(|s| s / length)
        };
        Self { traction: direction.map(|d| bound * d), bound, is_sliding: true }
    }
}

/// A traction (in Pa) limited to a bound, in Pa.
pub(super) fn cut(traction: [f64; 2], bound: f64) -> [f64; 2] {
    let square = traction[0] * traction[0] + traction[1] * traction[1];
    if square <= bound * bound {
        return traction;
    }
    let share = bound / square.sqrt();
    traction.map(|t| share * t)
}

/// A direction after turning towards a traction increment `pull` (in Pa) under a bound (in Pa).
#[inline]
fn turned(direction: [f64; 2], pull: [f64; 2], bound: f64) -> [f64; 2] {
    let length = (pull[0] * pull[0] + pull[1] * pull[1]).sqrt();
    if length == 0.0 {
        return direction;
    }
    let along = pull.map(|p| p / length);
    let cos = direction[0] * along[0] + direction[1] * along[1];
    let sin = along[0] * direction[1] - along[1] * direction[0];
    // Exactly opposite to the pull there is no side to turn to.
    let half = if 1.0 + cos > 0.0 { sin / (1.0 + cos) * (-length / bound).exp() } else { 0.0 };
    let over = (1.0 + half * half).recip();
    let (cos, sin) = ((1.0 - half * half) * over, 2.0 * half * over);
    [along[0] * cos - along[1] * sin, along[1] * cos + along[0] * sin]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

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
        let [x, y] = turned([2.0_f64.cos(), 2.0_f64.sin()], [1.3, 0.0], 1.0);
        assert_relative_eq!(y.atan2(x), exact, max_relative = 1e-7);
    }

    #[test]
    fn traction_grows_until_it_slides() {
        let start = Carried::default();
        let sticking = start.next([3.0, 0.0], 5.0);
        assert_eq!((sticking.traction, sticking.is_sliding), ([3.0, 0.0], false));
        let sliding = sticking.next([3.0, 0.0], 4.0);
        assert_eq!((sliding.traction, sliding.is_sliding), ([4.0, 0.0], true));
        let turned_away = sliding.next([-30.0, 0.0], 4.0);
        assert_relative_eq!(turned_away.traction[0], -4.0, max_relative = 1e-12);
    }
}
