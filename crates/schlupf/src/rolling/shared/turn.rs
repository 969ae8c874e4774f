//! Rotation of the sliding direction between the middle and the end of an increment.
//!
//! An increment gives the direction of sliding half a cell upstream of the point. The rigid slip is
//! known at the point itself; the elastic part is extrapolated from the last two increments.

use crate::interface::contact_law::Slide;

/// A path from cell to cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way {
    /// Its length, in m.
    pub distance: f64,
    /// Rigid slip along it, in m.
    pub rigid: [f64; 2],
    /// Difference of the rigid slip over its length between its downstream end and its middle, in
    /// m.
    pub turn: [f64; 2],
}

/// A previous path shorter than this fraction of the present one is ignored: it was that through
/// the tip of an edge cell.
const SHORTEST_WAY: f64 = 0.3;

/// The slide with the turn along a path. `upstream` is the length of the previous path and the
/// elastic part of the sliding divided by that length, if there was one.
pub(crate) fn with_turn(slide: Slide, way: &Way, upstream: Option<(f64, [f64; 2])>) -> Slide {
    let mut turn = way.turn;
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

/// From the middle of one path to that of the next, over (d₁ + d₂)/2, the elastic sliding per
/// length changes by its difference; over the second half of d₂ it changes by this share of the
/// difference.
fn elastic_share(distance: f64, before: f64) -> f64 {
    distance / (distance + before)
}
