//! Cells that are not coupled, solved one after another down the strips.

use crate::rolling::shared::cell::{inverse_2x2, times};
use crate::rolling::shared::passage::pair;
use crate::rolling::shared::strip::UpstreamValues;
use crate::settings;

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
        let [along, across] = compliance.map(|compliance| gamma * own * compliance);
        let stiffening = [[along, 0.0], [0.0, across]];
        for _ in 0..f64::MANTISSA_DIGITS {
            let before = pair(p, k);
            for c in 0..2 {
                displacement[2 * k + c] = compliance[c] * before[c];
            }
            let moved = self.stencils[k].apply(displacement, k);
            let trial = [0, 1].map(|c| before[c] + gamma * (self.rigid[2 * k + c] - moved[c]));
            let resolvent = self.resolvent((trial, gamma), saturation, (k, 0.0));
            let left = [0, 1].map(|c| before[c] - resolvent.traction[c]);
            let step = times(&inverse_2x2(resolvent.jacobian(&stiffening)), left);
            for c in 0..2 {
                p[2 * k + c] = before[c] - step[c];
            }
            if step[0].hypot(step[1]) <= f64::EPSILON * self.bound[k] {
                break;
            }
        }
        for c in 0..2 {
            displacement[2 * k + c] = compliance[c] * p[2 * k + c];
        }
    }
}
