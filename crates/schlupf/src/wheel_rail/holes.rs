//! Parts of a contact under which a profile has too few points, so that its shape there is that of
//! the spline alone.

use super::pair::Pair;
use super::pressed::Pressed;
use super::surface::Surface;
use crate::reporting::{Quantity, Warning};

/// Part of the width of a contact above which a step between two points is too long,
/// dimensionless: with fewer than two points inside, the curvature under it is not known.
const LARGEST_SHARE: f64 = 1.0 / 3.0;

/// Usual steps from which on a step is a hole.
const HOLE: f64 = 2.0;

/// Holes and steps that are too long of both profiles under a contact.
pub(super) fn under(pair: &Pair, pressed: &Pressed) -> Vec<Warning> {
    let columns = pressed.x.len();
    let is_pressed = |row: &[f64]| row.iter().any(|pressure| *pressure > 0.0);
    let rows = pressed.s.iter().zip(pressed.pressure.chunks(columns));
    let across: Vec<f64> = rows.filter(|(_, row)| is_pressed(row)).map(|(s, _)| *s).collect();
    let (Some(first), Some(last)) = (across.first(), across.last()) else { return Vec::new() };
    let profiles =
        [(Quantity::RailProfile, &pair.rail_profile), (Quantity::WheelProfile, &pair.wheel)];
    let warning = |((profile, surface), arc): ((Quantity, &Surface), f64)| {
        let curve = surface.uniform()?;
        let [step, share, from, to] = curve.widest_step([arc + first, arc + last])?;
        if share <= LARGEST_SHARE {
            return None;
        }
        let is_hole = step > HOLE * curve.usual_step();
        Some(if is_hole {
            Warning::HoleUnderContact { profile, ends: [from, to], share }
        } else {
            Warning::CoarseProfile { profile, step, width: last - first }
        })
    };
    profiles.into_iter().zip(pressed.plane.arcs).filter_map(warning).collect()
}
