//! Contact time of the material of a cell when the load changes and the edges of the patch move.
//!
//! In a row, the patch extends from its middle c by l to either side. For round bodies l² changes
//! linearly with time, and this is assumed within a step: by G. Material at a distance x from the
//! middle moves by Δx in a step, and relative to the middle by s = Δx + Δc; it met the edge θ steps
//! ago, where
//!
//! (x + θ s)² = l² − θ G,
//!
//! at the leading edge, or, where the patch has overtaken it, at the trailing edge. With stationary
//! edges θ Δx is the distance from the leading edge.

use std::ops::Range;

use crate::normal::patch::Patch;

use super::past::{Past, Reach};

/// Motion of the edges of a strip within a step.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Motion {
    /// Middle of the strip at the end of the step, in m.
    middle: f64,
    /// s: displacement of the material relative to the middle, in m; without rolling −Δc.
    passed: f64,
    /// G: increase of the square of the half-length, in m².
    gain: f64,
    /// Δx, in m.
    spacing: f64,
}

impl Motion {
    /// Path in contact (in m) until now of material that is at x, with the leading edge at `edge`,
    /// in m.
    pub fn path_until_end(&self, x: f64, edge: f64) -> f64 {
        self.path(x - self.middle, edge - self.middle)
    }

    /// The same until the start of the step, when the material was at x and the edge at `edge`, in
    /// m.
    pub fn path_until_start(&self, x: f64, edge: f64) -> f64 {
        let middle = self.middle - (self.passed - self.spacing);
        self.path(x - middle, edge - middle)
    }

    /// Fraction of a step without rolling (dimensionless) for which material at x has been in
    /// contact, with the edge at `edge` at its end, in m.
    pub fn part_at_rest(&self, x: f64, edge: f64) -> f64 {
        let part = self.path(x - self.middle, edge - self.middle) / self.spacing;
        if self.gain > 0.0 { part.min(1.0) } else { 1.0 }
    }

    /// Whether material at x (in m), in contact over a path (in m), has entered over the leading
    /// edge.
    pub fn is_from_leading_edge(&self, x: f64, path: f64) -> bool {
        x - self.middle + path * self.passed / self.spacing > 0.0
    }

    fn path(&self, x: f64, half: f64) -> f64 {
        if self.gain == 0.0 && self.passed == self.spacing {
            return half - x;
        }
        // s² θ² + 2 b θ − (l² − x²) = 0
        let b = x * self.passed + 0.5 * self.gain;
        let c = ((half - x) * (half + x)).max(0.0);
        let root = (b * b + self.passed * self.passed * c).sqrt();
        // The form without cancellation.
        let steps = if b > 0.0 { c / (b + root) } else { (root - b) / self.passed.powi(2) };
        steps * self.spacing
    }
}

/// The motion of every strip in a step in which the wheel has rolled over a cell, or not at all (in
/// m), from the past of the same cells. If a row is not covered over its
/// full width, its mean edges describe how it fills, not how they move: such a strip takes G from
/// the nearest strip that is.
pub(super) fn motions(patch: &Patch, past: &Past, rolled: f64) -> Vec<Motion> {
    let spacing = patch.grid.spacing_x;
    let reaches: Vec<Reach> = patch.strips.iter().map(|s| Reach::of(patch, s)).collect();
    let measured: Vec<Option<Motion>> = (patch.strips.iter().zip(&reaches))
        .map(|(strip, reach)| measured(patch, (&strip.cells, reach), past, rolled))
        .collect();
    let is_sound = |n: usize| {
        let reach = &reaches[n];
        measured[n].is_some() && reach.is_inside(&reaches) && reach.is_inside(&past.reaches)
    };
    let sound: Vec<usize> = (0..reaches.len()).filter(|n| is_sound(*n)).collect();
    let motion = |n: usize| {
        let reach = &reaches[n];
        let beside = |other: &&usize| reaches[**other].row.abs_diff(reach.row);
        let overlapping = sound.iter().filter(|other| reaches[**other].overlaps(reach));
        let model = overlapping.min_by_key(beside).and_then(|other| measured[*other]);
        let middle = reach.middle;
        match (model, measured[n]) {
            (Some(model), Some(own)) => Motion { gain: model.gain, ..own },
            (Some(model), None) => Motion { middle, ..model },
            (None, Some(own)) => own,
            (None, None) => {
                // A new isolated strip: it starts at its middle, at the start of the step.
                let half = patch.cells[patch.strips[n].cells.start].entry_x() - middle;
                Motion { middle, passed: rolled, gain: half * half, spacing }
            }
        }
    };
    (0..reaches.len()).map(motion).collect()
}

/// Measured at the cell next to the middle of the strip that was in contact before, whose entry is
/// the mean of the edge over the row.
fn measured(
    patch: &Patch,
    (cells, reach): (&Range<usize>, &Reach),
    past: &Past,
    rolled: f64,
) -> Option<Motion> {
    let center = usize::midpoint(cells.start, cells.end);
    let known = |k: &usize| past.at(patch.cells[*k].index).is_some();
    let k = cells.clone().filter(known).min_by_key(|k| k.abs_diff(center))?;
    let before = past.at(patch.cells[k].index)?;
    let half = patch.cells[k].entry_x() - reach.middle;
    let half_before = before.entry_x - before.middle;
    let spacing = patch.grid.spacing_x;
    Some(Motion {
        middle: reach.middle,
        passed: rolled + reach.middle - before.middle,
        gain: (half - half_before) * (half + half_before),
        spacing,
    })
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::numerics::root::bisection;

    /// Stationary edges: the path is the distance from the leading edge.
    #[test]
    fn edges_that_stay() {
        let still = Motion { middle: 1.0, passed: 0.1, gain: 0.0, spacing: 0.1 };
        assert_relative_eq!(still.path_until_end(1.7, 2.0), 0.3, max_relative = 1e-12);
        assert_relative_eq!(still.path_until_start(1.7, 2.0), 0.3, max_relative = 1e-12);
        // The same without the short cut.
        let nearly = Motion { gain: 1e-15, ..still };
        assert_relative_eq!(nearly.path_until_end(1.7, 2.0), 0.3, max_relative = 1e-12);
    }

    /// l² = 1 + 2t, the material at x − t: the path since x(t) = l(t), by bisection; for growing
    /// and shrinking patches, and for material overtaken at the trailing edge.
    #[test]
    fn material_meets_the_edge_where_it_was() {
        for (gain, x) in [(0.2, 0.5), (0.2, 0.99), (-0.15, 0.9), (-0.4, 0.2), (0.5, -0.98)] {
            let motion = Motion { middle: 0.0, passed: 0.1, gain, spacing: 0.1 };
            let outside =
                |steps: f64| (x + 0.1 * steps).abs() - (1.0 - steps * gain).max(0.0).sqrt();
            let [low, _] = bisection([0.0, 1e3], 200, |steps| outside(steps) <= 0.0);
            assert_relative_eq!(motion.path_until_end(x, 1.0), 0.1 * low, max_relative = 1e-9);
            let leads = motion.is_from_leading_edge(x, 0.1 * low);
            assert_eq!(leads, x + 0.1 * low > 0.0, "{gain} {x}");
        }
    }

    /// Material that stays in contact gains one step: the same law evaluated at both ends of the
    /// step.
    #[test]
    fn a_step_adds_a_step() {
        let motion = Motion { middle: 0.02, passed: 0.12, gain: 0.05, spacing: 0.1 };
        let (x, edge) = (0.3, 1.02);
        // The previous edge: l² = 1 − G, about a middle 0.02 farther back.
        let before = (1.0_f64 - 0.05).sqrt();
        let gained = motion.path_until_end(x, edge) - motion.path_until_start(x + 0.1, before);
        assert_relative_eq!(gained, 0.1, max_relative = 1e-12);
    }
}
