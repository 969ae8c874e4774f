//! The surface of a field over the patch, as polygons.

use super::patch::Patch;
use super::sampler::Sampler;

/// A flat piece of a surface; x and y over a and b.
#[derive(Debug, Clone)]
pub(super) struct Facet {
    /// Its corners.
    pub corners: Vec<[f64; 3]>,
    /// Whether it belongs to the wall between the rim of the surface and zero.
    pub wall: bool,
}

impl Facet {
    /// Mean height of the corners; for a wall that of its upper edge.
    pub(super) fn value(&self) -> f64 {
        let count = if self.wall { 2 } else { self.corners.len() };
        self.corners.iter().take(count).map(|corner| corner[2]).sum::<f64>() / count.max(1) as f64
    }

    /// Middle of its projection to the floor.
    pub(super) fn place(&self) -> [f64; 2] {
        let count = self.corners.len().max(1) as f64;
        [0, 1].map(|axis| self.corners.iter().map(|corner| corner[axis]).sum::<f64>() / count)
    }
}

/// Meshes along each side: as many as can be told apart, and even, for a node in the middle.
const MESHES: usize = 40;

/// What a surface spans: ±1 for a Hertzian patch, else the grid; over a and b.
pub(super) fn extent(patch: &Patch) -> [[f64; 2]; 2] {
    if patch.elliptic {
        return [[-1.0, 1.0]; 2];
    }
    let grid = &patch.fields().grid;
    let [a, b] = patch.semi_axes();
    [
        [grid.edge_x(0) / a, grid.edge_x(grid.columns) / a],
        [
            (grid.edge_y(0) - 0.5 * grid.spacing_y) / b,
            (grid.edge_y(grid.rows) + 0.5 * grid.spacing_y) / b,
        ],
    ]
}

/// The surface in square meshes over the extent of the patch. Over a Hertzian patch it ends at the
/// ellipse and falls from there to zero.
pub(super) fn facets(patch: &Patch, sampler: &Sampler) -> Vec<Facet> {
    let [x, y] = extent(patch);
    let node = |[low, high]: [f64; 2], index: usize| low + (high - low) * index as f64 / MESHES as f64;
    let height = |place: [f64; 2]| [place[0], place[1], sampler.value(place)];
    let mut facets = Vec::new();
    for j in 0..MESHES {
        for i in 0..MESHES {
            let [x0, x1] = [node(x, i), node(x, i + 1)];
            let [y0, y1] = [node(y, j), node(y, j + 1)];
            let square = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
            if !patch.elliptic {
                facets.push(Facet { corners: square.map(height).to_vec(), wall: false });
                continue;
            }
            let (inside, rim) = within_ellipse(square);
            if inside.len() > 2 {
                let corners = inside.iter().map(|place| height(*place)).collect();
                facets.push(Facet { corners, wall: false });
            }
            if let [p, q] = rim[..] {
                let [top_p, top_q] = [height(p), height(q)];
                let foot = |place: [f64; 2]| [place[0], place[1], 0.0];
                facets.push(Facet { corners: vec![top_p, top_q, foot(q), foot(p)], wall: true });
            }
        }
    }
    facets
}

/// The part of a square within the unit circle, and where its edges cross the circle.
fn within_ellipse(square: [[f64; 2]; 4]) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let (mut inside, mut rim) = (Vec::new(), Vec::new());
    let is_inside = |[x, y]: [f64; 2]| x * x + y * y <= 1.0;
    for (index, &corner) in square.iter().enumerate() {
        let next = square[(index + 1) % 4];
        if is_inside(corner) {
            inside.push(corner);
        }
        if is_inside(corner) != is_inside(next) {
            let crossing = circle_crossing(corner, next);
            inside.push(crossing);
            rim.push(crossing);
        }
    }
    (inside, rim)
}

/// Where the line between a point inside and one outside crosses the unit circle.
fn circle_crossing(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    let [dx, dy] = [q[0] - p[0], q[1] - p[1]];
    let (square, mixed) = (dx * dx + dy * dy, p[0] * dx + p[1] * dy);
    let rest = p[0] * p[0] + p[1] * p[1] - 1.0;
    let root = (mixed * mixed - square * rest).max(0.0).sqrt();
    let shares = [(-mixed + root) / square, (-mixed - root) / square];
    let share = shares.into_iter().find(|share| (0.0..=1.0).contains(share)).unwrap_or(0.0);
    [p[0] + share * dx, p[1] + share * dy]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_across_the_rim_is_cut_at_the_circle() {
        let (inside, rim) = within_ellipse([[0.5, -0.1], [1.5, -0.1], [1.5, 0.1], [0.5, 0.1]]);
        assert_eq!((inside.len(), rim.len()), (4, 2));
        for [x, y] in rim {
            assert!((x.hypot(y) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_square_outside_is_nothing() {
        let (inside, rim) = within_ellipse([[1.1, 1.1], [1.2, 1.1], [1.2, 1.2], [1.1, 1.2]]);
        assert!(inside.is_empty() && rim.is_empty());
    }
}
