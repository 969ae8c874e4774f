//! Cells that are not coupled, solved one after another down the strips.

use crate::solver::rolling::shared::passage::pair;
use crate::solver::rolling::shared::strip::{LoneCell, UpstreamValues};
use crate::solver::settings;

use super::StripLaw;

impl StripLaw {
    /// The tractions if every cell were displaced by its own one only, with the compliance (in
    /// m/Pa) of each in both directions: cell by cell from the leading edge.
    pub fn uncoupled_state(&self, compliance: &[f64], p: &mut [f64]) {
        let mut displacement = vec![0.0; p.len()];
        for cells in &self.contact.slaved.kept {
            let mut saturation = UpstreamValues::default();
            for k in cells.clone() {
                self.solve_uncoupled((k, pair(compliance, k)), &saturation, &mut displacement, p);
                if self.remembers() {
                    saturation.advance(self.saturated(p, k));
                }
            }
        }
        self.contact.slaved.complete(p);
    }

    /// The traction of cell `k` (in Pa) and its displacement (in m) in place, from what is
    /// upstream.
    fn solve_uncoupled(
        &self,
        (k, compliance): (usize, [f64; 2]),
        saturation: &UpstreamValues,
        displacement: &mut [f64],
        p: &mut [f64],
    ) {
        let own = self.stencils[k].own();
        let mean = 0.5 * (compliance[0] + compliance[1]);
        let [x, y] = pair(&self.rigid, k);
        let gamma = if mean > 0.0 {
            (own * mean).recip()
        } else {
            // So stiff that the traction moves nothing.
            let slides = x.hypot(y);
            let per_length = if slides > 0.0 { slides.recip() } else { self.law.stiffness() };
            settings::rigidity() * self.bound[k] * per_length
        };
        displacement[2 * k..2 * k + 2].fill(0.0);
        let upstream = self.stencils[k].apply(displacement, k);
        let sliding = [0, 1].map(|c| gamma * (self.rigid[2 * k + c] - upstream[c]));
        let stiffening = compliance.map(|compliance| gamma * own * compliance);
        let cell = LoneCell { sliding, stiffening, bound: self.bound[k] };
        cell.solve(&mut p[2 * k..2 * k + 2], |trial| {
            self.resolvent((trial, gamma), saturation, (k, 0.0))
        });
        for c in 0..2 {
            displacement[2 * k + c] = compliance[c] * p[2 * k + c];
        }
    }
}
