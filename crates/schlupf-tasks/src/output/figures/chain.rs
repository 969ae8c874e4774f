//! Contours as lines: the pieces in the squares of a grid joined, and their steps smoothed.

use std::collections::BTreeMap;

/// An edge of the grid, by the numbers of its ends in ascending order.
type Edge = [usize; 2];

/// Where a contour crosses an edge of the grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    /// The edge, by the numbers of its ends in ascending order.
    pub edge: Edge,
    /// The place, in m.
    pub at: [f64; 2],
}

/// A line through points.
#[derive(Debug)]
pub(crate) struct Chain {
    /// The points, in m; those of a closed line do not repeat the first.
    pub points: Vec<[f64; 2]>,
    /// Whether the last point is joined to the first.
    pub is_closed: bool,
}

/// Joins the pieces of a contour. Two squares meet at an edge, so at most two pieces do.
pub(crate) fn chains(pieces: &[[Crossing; 2]]) -> Vec<Chain> {
    let mut walk = Walk::new(pieces);
    let ends = |piece: &[Crossing; 2]| piece.map(|crossing| crossing.edge);
    let is_free = |walk: &Walk, edge: &Edge| walk.at[edge].len() == 1;
    // Open lines from their ends; what is left after that is closed.
    let free: Vec<Edge> =
        pieces.iter().flat_map(ends).filter(|edge| is_free(&walk, edge)).collect();
    let open = free.into_iter().filter_map(|edge| walk.from(edge, false)).collect::<Vec<_>>();
    let closed = pieces.iter().filter_map(|piece| walk.from(piece[0].edge, true));
    let mut chains: Vec<Chain> = open.into_iter().chain(closed).collect();
    chains.iter_mut().for_each(Chain::smooth);
    chains
}

/// Goes along pieces, each once.
struct Walk<'a> {
    pieces: &'a [[Crossing; 2]],
    /// The pieces that end at an edge.
    at: BTreeMap<Edge, Vec<usize>>,
    is_done: Vec<bool>,
}

impl<'a> Walk<'a> {
    fn new(pieces: &'a [[Crossing; 2]]) -> Self {
        let mut at: BTreeMap<Edge, Vec<usize>> = BTreeMap::new();
        for (index, piece) in pieces.iter().enumerate() {
            for crossing in piece {
                at.entry(crossing.edge).or_default().push(index);
            }
        }
        Self { pieces, at, is_done: vec![false; pieces.len()] }
    }

    /// The line from an edge; `None` if all pieces there are part of other lines.
    fn from(&mut self, mut edge: Edge, is_closed: bool) -> Option<Chain> {
        let mut points = Vec::new();
        while let Some([here, next]) = self.step(edge) {
            if points.is_empty() {
                points.push(here.at);
            }
            points.push(next.at);
            edge = next.edge;
        }
        if is_closed {
            points.pop();
        }
        (!points.is_empty()).then_some(Chain { points, is_closed })
    }

    /// The next piece from an edge, beginning there.
    fn step(&mut self, edge: Edge) -> Option<[Crossing; 2]> {
        let next = *self.at.get(&edge)?.iter().find(|index| !self.is_done[**index])?;
        self.is_done[next] = true;
        let [one, other] = self.pieces[next];
        Some(if one.edge == edge { [one, other] } else { [other, one] })
    }
}

impl Chain {
    /// Removes the steps that the cells leave in a slanting contour, without shrinking it (Taubin,
    /// *SIGGRAPH* 1995): alternate averaging and its opposite. Ends stay in place.
    fn smooth(&mut self) {
        const PASSES: usize = 30;
        const FACTORS: [f64; 2] = [0.5, -0.52];
        /// A shorter line is all bends and no steps.
        const LEAST: usize = 12;
        if self.points.len() < LEAST {
            return;
        }
        for factor in FACTORS.into_iter().cycle().take(2 * PASSES) {
            self.points = (0..self.points.len()).map(|k| self.moved(k, factor)).collect();
        }
    }

    /// A point moved by a fraction of its distance from the middle of its neighbours.
    fn moved(&self, k: usize, factor: f64) -> [f64; 2] {
        let count = self.points.len();
        let here = self.points[k];
        if !self.is_closed && (k == 0 || k + 1 == count) {
            return here;
        }
        let [before, after] = [self.points[(k + count - 1) % count], self.points[(k + 1) % count]];
        [0, 1].map(|axis| here[axis] + factor * (0.5 * (before[axis] + after[axis]) - here[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of a line through places, in any order and direction, crossing numbered edges.
    fn pieces(places: &[[f64; 2]], is_closed: bool) -> Vec<[Crossing; 2]> {
        let crossing = |k: usize| {
            let k = k % places.len();
            Crossing { edge: [k, k + 1], at: places[k] }
        };
        let count = if is_closed { places.len() } else { places.len() - 1 };
        let mut pieces: Vec<_> = (0..count).map(|k| [crossing(k), crossing(k + 1)]).collect();
        pieces.reverse();
        pieces.iter_mut().step_by(2).for_each(|piece| piece.reverse());
        pieces
    }

    #[test]
    fn pieces_are_joined() {
        let places = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        for is_closed in [false, true] {
            let chains = chains(&pieces(&places, is_closed));
            assert_eq!(chains.len(), 1);
            assert_eq!((chains[0].points.len(), chains[0].is_closed), (4, is_closed));
            assert!(chains[0].points.windows(2).all(|p| p[0][0] == p[1][0] || p[0][1] == p[1][1]));
        }
    }

    /// A circle with a step at every fourth of its points becomes round and keeps its size.
    #[test]
    fn steps_are_smoothed_and_sizes_are_kept() {
        let radius = |k: usize| if k.is_multiple_of(4) { 1.03 } else { 0.99 };
        let place = |k: usize| {
            let (sin, cos) = (k as f64 / 80.0 * std::f64::consts::TAU).sin_cos();
            [radius(k) * cos, radius(k) * sin]
        };
        let places: Vec<[f64; 2]> = (0..80).map(place).collect();
        for [x, y] in &chains(&pieces(&places, true))[0].points {
            assert!((x.hypot(*y) - 1.0).abs() < 2e-3, "{x} {y}");
        }
    }
}
