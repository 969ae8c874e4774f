//! Parts of a contact under which a profile has no points, so that its shape there is that of the
//! spline alone.

use super::pair::Pair;
use super::pressed::Pressed;
use super::profile_curve::ProfileCurve;
use crate::quantity::Quantity;
use crate::warning::Warning;

/// Part of the width of a contact above which a step between two points is a hole, dimensionless:
/// with fewer than two points inside, the curvature under it is not known.
const LARGEST_SHARE: f64 = 1.0 / 3.0;

/// Holes of both profiles under a contact.
pub(super) fn under(pair: &Pair, pressed: &Pressed) -> Vec<Warning> {
    let columns = pressed.x.len();
    let is_pressed = |row: &[f64]| row.iter().any(|pressure| *pressure > 0.0);
    let rows = pressed.s.iter().zip(pressed.pressure.chunks(columns));
    let across: Vec<f64> = rows.filter(|(_, row)| is_pressed(row)).map(|(s, _)| *s).collect();
    let (Some(first), Some(last)) = (across.first(), across.last()) else { return Vec::new() };
    let profiles = [
        (Quantity::RailProfile, &pair.rail, pair.rail_origin[0]),
        (Quantity::WheelProfile, &pair.wheel, 0.0),
    ];
    let hole = |((profile, curve, origin), arc): ((Quantity, &ProfileCurve, f64), f64)| {
        let (share, ends) = curve.widest_step([arc + first, arc + last])?;
        let ends = ends.map(|place| place[0] - origin);
        (share > LARGEST_SHARE).then_some(Warning::HoleUnderContact { profile, ends, share })
    };
    profiles.into_iter().zip(pressed.plane.arcs).filter_map(hole).collect()
}
