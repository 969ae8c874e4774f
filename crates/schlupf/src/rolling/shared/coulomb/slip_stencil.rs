//! Slip at the cells, from what the material has slid since it entered, to third order.

use std::ops::Range;

use crate::patch::Patch;
use crate::state::MOST_PLACES;

use super::Discretisation;

/// Number of nodes of the polynomial, which is of third order: the cell and the places of a track.
const NODES: usize = MOST_PLACES + 1;

/// A node nearer than this part of the way into the cell is left out, dimensionless: its weight
/// would be large.
const NEAREST: f64 = 0.4;

/// The same for a node downstream, which takes its weight from the cell itself: nearer ones would
/// leave it less than a quarter.
const NEAREST_AHEAD: f64 = 0.8;

/// Number of cells of a stencil.
const CELLS: usize = NODES + 1;

/// The derivative along the path at a cell, times the way into it, of the polynomial through the
/// values at the cell and at those upstream of it; the entry, where the value is zero, is a node
/// too. The first cell of a strip is thus of first order, the second one of second order.
///
/// Where the direction of sliding turns fast along the path, it is more accurate with one node
/// downstream in place of the last one upstream: a mixture of both is of third order, too.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct SlipStencil {
    /// Weights (dimensionless) of the next cell downstream, the cell itself and those upstream of
    /// it; zero where there is none.
    weight: [f64; CELLS],
    /// Way into the cell from the one upstream of it, or from the entry, in m.
    pub way: f64,
}

/// Ratios of length to width (dimensionless) of a patch up to which the nodes are upstream only,
/// and from which one of them is downstream.
const LONG: [f64; 2] = [1.25, 2.5];

impl SlipStencil {
    /// The stencil of every cell of a patch with a ratio of length to width (dimensionless),
    /// without any weight for those that are not in `kept`.
    pub fn of(
        patch: &Patch,
        kept: &[Range<usize>],
        ratio: f64,
        discretisation: Discretisation,
    ) -> Vec<Self> {
        let [round, long] = LONG;
        let most = discretisation.most_ahead();
        let ahead = ((ratio / round).ln() / (long / round).ln()).clamp(0.0, most);
        let mut stencils = vec![Self::default(); patch.len()];
        for cells in kept {
            let distances: Vec<f64> =
                patch.cells[cells.clone()].iter().map(|cell| cell.since_entry.distance).collect();
            for (n, k) in cells.clone().enumerate() {
                stencils[k] = Self::at(&distances, n, ahead);
            }
        }
        stencils
    }

    /// The values themselves in place of their derivatives.
    pub fn since_entry(patch: &Patch, kept: &[Range<usize>]) -> Vec<Self> {
        let mut stencils = vec![Self::default(); patch.len()];
        for k in kept.iter().flat_map(Clone::clone) {
            let way = patch.cells[k].since_entry.distance;
            stencils[k] = Self { weight: [0.0, 1.0, 0.0, 0.0, 0.0], way };
        }
        stencils
    }

    /// At one of the cells of a strip, with their distances since entry (in m), with the share
    /// `ahead` (dimensionless) of that with a node downstream, except at the ends of the strip.
    fn at(distances: &[f64], n: usize, ahead: f64) -> Self {
        let own = distances[n];
        let before = |back: usize| n.checked_sub(back).map_or(0.0, |at| distances[at]);
        let upstream = || (1..=n + 1).map(|back| own - before(back));
        let mut stencil = Self { weight: [0.0; CELLS], way: own - before(1) };
        let to_next = distances.get(n + 1).map_or(0.0, |next| next - own);
        let inside = if n > 0 && to_next >= NEAREST_AHEAD * stencil.way { ahead } else { 0.0 };
        let behind = through(upstream()).map(|weight| (1.0 - inside) * weight);
        stencil.weight[1..].copy_from_slice(&behind);
        if inside > 0.0 {
            let mixed = around(to_next, upstream());
            for (sum, weight) in stencil.weight.iter_mut().zip(mixed) {
                *sum += inside * weight;
            }
        }
        // The entry has no value.
        if let Some(beyond) = stencil.weight.get_mut(n + 2..) {
            beyond.fill(0.0);
        }
        stencil
    }

    /// Its cells at cell `k`, with their weights; dimensionless.
    pub fn cells(&self, k: usize) -> impl Iterator<Item = (usize, f64)> {
        let weights = self.weight.into_iter().enumerate().filter(|(_, weight)| *weight != 0.0);
        weights.map(move |(place, weight)| (k + 1 - place, weight))
    }

    /// Weight of the cell itself, dimensionless.
    pub fn own(&self) -> f64 {
        self.weight[1]
    }

    /// Applied to values at the cells, x and y of each cell in turn, at cell `k`, with that of the
    /// next cell downstream given as `ahead`; in the unit of the values.
    pub fn apply(&self, values: &[f64], k: usize, ahead: [f64; 2]) -> [f64; 2] {
        let mut sum = ahead.map(|ahead| self.weight[0] * ahead);
        let behind = values[..2 * k + 2].rchunks_exact(2);
        for (weight, value) in self.weight[1..].iter().zip(behind) {
            sum[0] += weight * value[0];
            sum[1] += weight * value[1];
        }
        sum
    }
}

/// Converts values since entry (x and y of each cell in turn) into their changes over the way into
/// each cell, in place.
pub(in crate::rolling) fn slide(stencils: &[SlipStencil], values: &mut [f64]) {
    let mut ahead = [0.0; 2];
    for (k, stencil) in stencils.iter().enumerate().rev() {
        let since_entry = [values[2 * k], values[2 * k + 1]];
        let changed = stencil.apply(values, k, ahead);
        values[2 * k..2 * k + 2].copy_from_slice(&changed);
        ahead = since_entry;
    }
}

/// Weights (dimensionless) of the derivative at a place, times the way to the nearest node
/// upstream, of the polynomial through a node at a distance ahead of it (in m), the place itself,
/// and the two nodes behind it, one after another.
fn around(ahead: f64, backs: impl Iterator<Item = f64>) -> [f64; CELLS] {
    let [_, nearest, next, _] = behind(backs);
    let way = nearest.map_or(0.0, |node| -node);
    let [_, ahead, rest @ ..] = derivative([Some(0.0), Some(ahead), nearest, next]);
    let own = -(ahead + rest[0] + rest[1]);
    [ahead, own, rest[0], rest[1], 0.0].map(|weight| way * weight)
}

/// Weights (dimensionless) of the derivative at a place, times the way to the nearest node, of the
/// polynomial through it and nodes at some distances behind it (in m). A node that is too near to
/// the one before has none. Without a way it is the difference to the nearest.
pub(in crate::rolling) fn through(backs: impl Iterator<Item = f64>) -> [f64; NODES] {
    let nodes = behind(backs);
    match nodes[1] {
        Some(nearest) if nearest < 0.0 => derivative(nodes).map(|weight| -nearest * weight),
        _ => [1.0, -1.0, 0.0, 0.0],
    }
}

/// A place and nodes at some distances behind it, less those that are too near to the one before.
fn behind(backs: impl Iterator<Item = f64>) -> [Option<f64>; NODES] {
    let mut nodes = [Some(0.0), None, None, None];
    let mut way = 0.0;
    let mut last = 0.0;
    for (node, back) in nodes[1..].iter_mut().zip(backs) {
        if way == 0.0 {
            way = back;
        } else if back - last < NEAREST * way {
            continue;
        }
        *node = Some(-back);
        last = back;
    }
    nodes
}

/// Weights of the derivative at the first of some nodes of the polynomial through all of them.
fn derivative(nodes: [Option<f64>; NODES]) -> [f64; NODES] {
    let mut weights = [0.0; NODES];
    let others = || nodes.iter().enumerate().skip(1).filter_map(|(j, node)| Some((j, (*node)?)));
    for (j, node) in others() {
        let rest = || others().filter(|(m, _)| *m != j).map(|(_, other)| other);
        let above: f64 = rest().map(|other| -other).product();
        let below: f64 = rest().map(|other| node - other).product();
        weights[j] = above / (below * node);
        weights[0] -= node.recip();
    }
    weights
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Cubic functions of the path that vanish at the entry have their exact slip in every cell
    /// from the third on, square ones in the second, linear ones in the first, wherever the nodes
    /// are.
    #[test]
    fn the_order_grows_along_the_strip() {
        let distances = [0.4e-3, 1.3e-3, 2.2e-3, 3.3e-3, 4.2e-3];
        for ahead in [0.0, 0.3, 1.0] {
            for (n, degree) in [(0, 1), (1, 2), (2, 3), (3, 3), (4, 3)] {
                let stencil = SlipStencil::at(&distances, n, ahead);
                let d = distances[n];
                let way = if n == 0 { d } else { d - distances[n - 1] };
                for power in 1..=degree {
                    let values: Vec<f64> =
                        distances.iter().flat_map(|d| [d.powi(power), 0.0]).collect();
                    let ahead = distances.get(n + 1).map_or(0.0, |d| d.powi(power));
                    let [slip, _] = stencil.apply(&values, n, [ahead, 0.0]);
                    let exact = f64::from(power) * d.powi(power - 1) * way;
                    assert_relative_eq!(slip, exact, max_relative = 1e-12);
                }
            }
        }
    }
}
