//! Slip at the cells, from what the material has slid since it entered, to third order.

use std::ops::Range;

use crate::normal::patch::Patch;
use crate::problem::MOST_PLACES;
use crate::solver::settings;

use super::resolvent::BristleState;

/// Number of nodes of the polynomial, which is of third order: the cell and the places of a track.
const NODES: usize = MOST_PLACES + 1;

/// The derivative along the path at a cell, times the path into it, of the polynomial through the
/// values at the cell and at those upstream of it; the entry, where the value is zero, is a node
/// too. The first cell of a strip is thus of first order, the second one of second order.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::solver::rolling) struct SlipStencil {
    /// Weights (dimensionless) of the cell itself and of the nodes upstream of it; zero where there
    /// is none.
    weight: [f64; NODES],
    /// Number of nodes upstream that are cells; one more is the entry.
    cells: usize,
    /// Path into the cell from the one upstream of it, or from the entry, in m.
    pub path: f64,
}

/// Values (x and y) at the cells upstream of one, the nearest first; zero where there is none.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::solver::rolling) struct UpstreamValues([[f64; 2]; NODES - 1]);

impl UpstreamValues {
    /// Goes on to the next cell, with the value at the present one.
    #[inline]
    pub fn advance(&mut self, value: [f64; 2]) {
        let [first, second, _] = self.0;
        self.0 = [value, first, second];
    }
}

impl SlipStencil {
    /// The stencil of every cell of a patch, without any weight for those that are not in `kept`.
    pub fn of(patch: &Patch, kept: &[Range<usize>]) -> Vec<Self> {
        let mut stencils = vec![Self::default(); patch.len()];
        for cells in kept {
            let distances: Vec<f64> =
                patch.cells[cells.clone()].iter().map(|cell| cell.since_entry.distance).collect();
            for (n, k) in cells.clone().enumerate() {
                stencils[k] = Self::at(&distances[..=n]);
            }
        }
        stencils
    }

    /// The values themselves in place of their derivatives: from the entry at once.
    pub fn since_entry(patch: &Patch, kept: &[Range<usize>]) -> Vec<Self> {
        let mut stencils = vec![Self::default(); patch.len()];
        for k in kept.iter().flat_map(Clone::clone) {
            stencils[k] = Self::at(&[patch.cells[k].since_entry.distance]);
        }
        stencils
    }

    /// At the last of some cells of a strip, with their distances since entry (in m).
    fn at(distances: &[f64]) -> Self {
        let mut upstream = distances.iter().rev();
        let own = upstream.next().copied().unwrap_or_default();
        let backs = upstream.chain([&0.0]).take(NODES - 1).map(|before| own - before);
        let mut stencil =
            Self { cells: distances.len().saturating_sub(1).min(NODES - 1), ..Self::default() };
        stencil.path = backs.clone().next().unwrap_or_default();
        stencil.weight = through(backs);
        stencil
    }

    /// τ, c and n from p/(μ pₙ) of the cells upstream, with γ/k_c in Pa.
    #[inline]
    pub fn bristles(&self, compliance: f64, saturation: &UpstreamValues) -> BristleState {
        let (own, order) = (self.weight[0], order(&self.weight));
        let upstream = self.of_upstream(saturation);
        BristleState { compliance, own, upstream, order, ..BristleState::default() }
    }

    /// The part of the cells upstream, in the unit of the values.
    #[inline]
    pub fn of_upstream(&self, UpstreamValues(values): &UpstreamValues) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (weight, value) in self.weight[1..].iter().zip(values) {
            sum = [0, 1].map(|c| sum[c] + weight * value[c]);
        }
        sum
    }

    /// The cells upstream of cell `k`, with their weights; dimensionless.
    pub fn upstream(&self, k: usize) -> impl Iterator<Item = (usize, f64)> {
        self.cells(k).filter(move |(cell, _)| *cell != k)
    }

    /// Its cells at cell `k`, with their weights; dimensionless.
    pub fn cells(&self, k: usize) -> impl Iterator<Item = (usize, f64)> {
        let weights = self.weight[..=self.cells].iter().copied().enumerate();
        weights.filter(|(_, weight)| *weight != 0.0).map(move |(at, weight)| (k - at, weight))
    }

    /// Weight of the cell itself, dimensionless.
    pub fn own(&self) -> f64 {
        self.weight[0]
    }

    /// Applied to values at the cells, x and y of each cell in turn, at cell `k`; in the unit of
    /// the values.
    pub fn apply(&self, values: &[f64], k: usize) -> [f64; 2] {
        let mut sum = [0.0; 2];
        let weights = &self.weight[..=self.cells];
        for (weight, value) in weights.iter().zip(values[..2 * k + 2].rchunks_exact(2)) {
            sum[0] += weight * value[0];
            sum[1] += weight * value[1];
        }
        sum
    }
}

/// Converts values since entry (x and y of each cell in turn) into their changes over the path into
/// each cell, in place.
pub(in crate::solver::rolling) fn slide(stencils: &[SlipStencil], values: &mut [f64]) {
    for (k, stencil) in stencils.iter().enumerate().rev() {
        let changed = stencil.apply(values, k);
        values[2 * k..2 * k + 2].copy_from_slice(&changed);
    }
}

/// Order of the derivative with some weights: the number of nodes upstream.
pub(in crate::solver::rolling) fn order(weight: &[f64; NODES]) -> usize {
    weight[1..].iter().filter(|weight| **weight != 0.0).count()
}

/// Weights (dimensionless) of the derivative at a place, times the path to the nearest node, of the
/// polynomial through it and nodes at some distances behind it (in m). A node that is too near to
/// the one before has none. Without a path it is the difference to the nearest.
pub(in crate::solver::rolling) fn through(backs: impl Iterator<Item = f64>) -> [f64; NODES] {
    let nodes = behind(backs);
    match nodes[1] {
        Some(nearest) if nearest < 0.0 => derivative(nodes).map(|weight| -nearest * weight),
        _ => [1.0, -1.0, 0.0, 0.0],
    }
}

/// A place and nodes at some distances behind it, less those that are too near to the one before.
fn behind(backs: impl Iterator<Item = f64>) -> [Option<f64>; NODES] {
    let mut nodes = [Some(0.0), None, None, None];
    let mut path = 0.0;
    let mut last = 0.0;
    for (node, back) in nodes[1..].iter_mut().zip(backs) {
        if path == 0.0 {
            path = back;
        } else if back - last < settings::nearest_node() * path {
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
        for (n, degree) in [(0, 1), (1, 2), (2, 3), (3, 3), (4, 3)] {
            let stencil = SlipStencil::at(&distances[..=n]);
            let d = distances[n];
            let path = if n == 0 { d } else { d - distances[n - 1] };
            for power in 1..=degree {
                let values: Vec<f64> =
                    distances.iter().flat_map(|d| [d.powi(power), 0.0]).collect();
                let [slip, _] = stencil.apply(&values, n);
                let exact = f64::from(power) * d.powi(power - 1) * path;
                assert_relative_eq!(slip, exact, max_relative = 1e-12);
            }
        }
    }
}
