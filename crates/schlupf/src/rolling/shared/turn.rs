//! By how much sliding turns between the middle and the end of an increment.
//!
//! An increment tells the direction of sliding half a cell upstream of the point. The rigid slip is
//! known at the point itself; the elastic part is carried on from the last two increments.

use crate::interface::contact_law::Slide;
use crate::kinematics::Kinematics;

/// A way from cell to cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way {
    /// Its length, in m.
    pub distance: f64,
    /// Rigid slip on it, in m.
    pub rigid: [f64; 2],
}

/// Where the way before was shorter than this part of the present one, it says nothing: it was that
/// through the tip of an edge cell.
const SHORTEST_WAY: f64 = 0.3;

/// The slide with the turn on a way. `upstream` is the length of the way before and the elastic
/// part of the sliding over that length, where there was one.
pub(crate) fn with_turn(
    slide: Slide,
    kinematics: &Kinematics,
    way: &Way,
    upstream: Option<(f64, [f64; 2])>,
) -> Slide {
    let mut turn = kinematics.half_turn(way.distance);
    let upstream = upstream.filter(|(before, _)| *before > SHORTEST_WAY * way.distance);
    let Some((before, stretch)) = upstream else {
        return Slide { turn, turn_by_increment: 0.0, ..slide };
    };
    let share = elastic_share(way.distance, before);
    for c in 0..2 {
        turn[c] -= share * (way.rigid[c] + way.distance * stretch[c]);
    }
    Slide { turn, turn_by_increment: share, ..slide }
}

/// The elastic sliding per length changes by its difference over (d₁ + d₂)/2 from the middle of one
/// way to that of the next, and by this share of the difference over the second half of d₂.
fn elastic_share(distance: f64, before: f64) -> f64 {
    distance / (distance + before)
}
