//! Slip at the cells, from what the material has slid since it entered, to third order.

use std::ops::Range;

use crate::patch::Patch;

/// Number of nodes of the polynomial: of third order.
pub(in crate::rolling) const NODES: usize = 4;

/// A node nearer than this part of the way into the cell is left out, dimensionless: its weight
/// would be large.
const NEAREST: f64 = 0.3;

/// The derivative along the path at a cell, times the way into it, of the polynomial through the
/// values at the cell and at those upstream of it; the entry, where the value is zero, is a node
/// too. The first cell of a strip is thus of first order, the second one of second order.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::rolling) struct SlipStencil {
    /// Number of cells: the cell itself and those upstream of it, one after another.
    pub count: usize,
    /// Their weights, dimensionless.
    pub weight: [f64; NODES],
    /// Way into the cell from the one upstream of it, or from the entry, in m.
    pub way: f64,
}

impl SlipStencil {
    /// The stencil of every cell, without any cell for those that are not in `kept`.
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

    /// At the last of the cells of a strip up to it, with their distances since entry (in m).
    fn at(distances: &[f64]) -> Self {
        let Some((own, upstream)) = distances.split_last() else { return Self::default() };
        let backs = upstream.iter().rev().chain(&[0.0]).map(|node| own - node);
        let way = own - upstream.last().unwrap_or(&0.0);
        let (weight, nodes) = through(backs);
        Self { count: nodes.min(distances.len()), weight, way }
    }

    /// Applied to values at the cells, x and y of each cell in turn, at cell `k`; in the unit of
    /// the values.
    pub fn apply(&self, k: usize, values: &[f64]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (back, weight) in self.weight[..self.count].iter().enumerate() {
            let j = k - back;
            sum[0] += weight * values[2 * j];
            sum[1] += weight * values[2 * j + 1];
        }
        sum
    }
}

/// Weights (dimensionless) of the derivative at a place, times the way to the nearest node, of the
/// polynomial through it and nodes at some distances behind it (in m), and their number. The nodes
/// end where one is too near to the one before. Without a way it is the difference to the nearest.
pub(in crate::rolling) fn through(backs: impl Iterator<Item = f64>) -> ([f64; NODES], usize) {
    let mut nodes = [0.0; NODES];
    let mut count = 1;
    for back in backs.take(NODES - 1) {
        if count > 1 && back + nodes[count - 1] < NEAREST * -nodes[1] {
            break;
        }
        nodes[count] = -back;
        count += 1;
    }
    let way = -nodes[1];
    if way <= 0.0 {
        return ([1.0, -1.0, 0.0, 0.0], count.min(2));
    }
    (derivative(&nodes[..count]).map(|weight| way * weight), count)
}

/// Weights of the derivative at the first of some nodes of the polynomial through all of them.
fn derivative(nodes: &[f64]) -> [f64; NODES] {
    let mut weights = [0.0; NODES];
    for (j, node) in nodes.iter().enumerate().skip(1) {
        let others = || nodes.iter().enumerate().skip(1).filter(|(m, _)| *m != j);
        let above: f64 = others().map(|(_, other)| nodes[0] - other).product();
        let below: f64 = others().map(|(_, other)| node - other).product();
        weights[j] = above / (below * (node - nodes[0]));
        weights[0] += (nodes[0] - node).recip();
    }
    weights
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Cubic functions of the path that vanish at the entry have their exact slip in every cell
    /// from the third on, square ones in the second, linear ones in the first.
    #[test]
    fn the_order_grows_along_the_strip() {
        let distances = [0.4e-3, 1.3e-3, 2.2e-3, 3.3e-3, 4.2e-3];
        for (last, degree) in [(0, 1), (1, 2), (2, 3), (3, 3), (4, 3)] {
            let stencil = SlipStencil::at(&distances[..=last]);
            let d = distances[last];
            let way = if last == 0 { d } else { d - distances[last - 1] };
            for power in 1..=degree {
                let value = |k: usize| distances[last - k].powi(power);
                let slip: f64 = (0..stencil.count).map(|k| stencil.weight[k] * value(k)).sum();
                let exact = f64::from(power) * d.powi(power - 1) * way;
                assert_relative_eq!(slip, exact, max_relative = 1e-12);
            }
        }
    }
}
