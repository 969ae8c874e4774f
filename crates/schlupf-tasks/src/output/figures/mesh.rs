//! The surface of a field over the patch, as polygons.

use schlupf::normal::BORDER;

use super::patch::Patch;
use super::sampler::Sampler;

/// A flat piece of a surface; x and y over a and b.
#[derive(Debug, Clone)]
pub(crate) struct Facet {
    /// Its corners.
    pub corners: Vec<[f64; 3]>,
    /// Edges on the two far lines of its mesh; the near ones are drawn by its neighbours, which
    /// come later and would cover them.
    pub edges: Vec<[[f64; 3]; 2]>,
    /// Whether it belongs to the wall between the rim of the surface and its base.
    pub wall: bool,
}

impl Facet {
    /// A part of a mesh, given by its corners on the floor.
    fn new(
        places: &[[f64; 2]],
        mesh: [[f64; 2]; 2],
        height: impl Fn([f64; 2]) -> [f64; 3],
    ) -> Self {
        let corners: Vec<[f64; 3]> = places.iter().map(|place| height(*place)).collect();
        let [[far_x, _], [_, far_y]] = mesh;
        let on_line = |p: [f64; 3], q: [f64; 3]| {
            (p[0] == q[0] && p[0] == far_x) || (p[1] == q[1] && p[1] == far_y)
        };
        let edges = (0..corners.len())
            .map(|index| [corners[index], corners[(index + 1) % corners.len()]])
            .filter(|[p, q]| on_line(*p, *q))
            .collect();
        Self { corners, edges, wall: false }
    }

    /// Mean height of the corners; for a wall, of its upper edge.
    pub(crate) fn value(&self) -> f64 {
        let count = if self.wall { 2 } else { self.corners.len() };
        self.corners.iter().take(count).map(|corner| corner[2]).sum::<f64>() / count.max(1) as f64
    }

    /// Centre of its projection onto the floor.
    pub(crate) fn place(&self) -> [f64; 2] {
        let count = self.corners.len().max(1) as f64;
        [0, 1].map(|axis| self.corners.iter().map(|corner| corner[axis]).sum::<f64>() / count)
    }
}

/// Meshes along a side: as many as can be distinguished, and an even number, for a node in the
/// middle.
const MESHES: usize = 40;

/// The same along x and y; more where a patch may be of several parts, so that each has enough.
fn meshes(patch: &Patch) -> [usize; 2] {
    let grid = &patch.fields().grid;
    let along = |cells: usize| cells.next_multiple_of(2).clamp(MESHES, 2 * MESHES);
    if patch.elliptic { [MESHES; 2] } else { [grid.columns, grid.rows].map(along) }
}

/// Extent of a surface: ±1 for a Hertzian patch, otherwise the grid with a border all around, on
/// which the foot of the surface is seen; normalised by a and b.
pub(crate) fn extent(patch: &Patch) -> [[f64; 2]; 2] {
    if patch.elliptic {
        return [[-1.0, 1.0]; 2];
    }
    let grid = &patch.fields().grid;
    let [a, b] = patch.semi_axes();
    let border = BORDER as f64 * grid.spacing_y;
    [
        [grid.edge_x(0) / a, grid.edge_x(grid.columns) / a],
        [(grid.edge_y(0) - border) / b, (grid.edge_y(grid.rows) + border) / b],
    ]
}

/// The surface in square meshes over the extent of the patch. For a Hertzian patch it ends at the
/// ellipse and drops from there to its base.
pub(crate) fn facets(patch: &Patch, sampler: &Sampler, base: f64) -> Vec<Facet> {
    let [x, y] = extent(patch);
    let [columns, rows] = meshes(patch);
    let height = |place: [f64; 2]| [place[0], place[1], sampler.value(place)];
    let mut facets = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            let mesh = [
                [i, i + 1].map(|i| between(x, i, columns)),
                [j, j + 1].map(|j| between(y, j, rows)),
            ];
            for square in parts(mesh, patch.elliptic) {
                if patch.elliptic {
                    facets.extend(rim_facets(square, mesh, (base, height)));
                } else {
                    facets.push(Facet::new(&square, mesh, height));
                }
            }
        }
    }
    facets
}

/// The squares into which a mesh is divided: smaller ones where a surface drops steeply towards its
/// rim.
fn parts(mesh: [[f64; 2]; 2], elliptic: bool) -> Vec<[[f64; 2]; 4]> {
    let [x, y] = mesh;
    let far = x.map(f64::abs).into_iter().fold(0.0, f64::max).powi(2)
        + y.map(f64::abs).into_iter().fold(0.0, f64::max).powi(2);
    let count = if elliptic && far > 0.86 { 3 } else { 1 };
    let square = |index: usize| {
        let (i, j) = (index % count, index / count);
        let [x0, x1] = [i, i + 1].map(|k| between(x, k, count));
        let [y0, y1] = [j, j + 1].map(|k| between(y, k, count));
        [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    };
    (0..count * count).map(square).collect()
}

/// The end of part `index` of `count` equal parts of a range; exactly the end of the range for the
/// last one.
fn between([low, high]: [f64; 2], index: usize, count: usize) -> f64 {
    let share = index as f64 / count as f64;
    low * (1.0 - share) + high * share
}

/// The part of a square within the ellipse, and the wall at its rim.
fn rim_facets(
    square: [[f64; 2]; 4],
    mesh: [[f64; 2]; 2],
    (base, height): (f64, impl Fn([f64; 2]) -> [f64; 3] + Copy),
) -> Vec<Facet> {
    let (inside, rim) = within_ellipse(square);
    let mut facets = Vec::new();
    if inside.len() > 2 {
        facets.push(Facet::new(&inside, mesh, height));
    }
    if let [p, q] = rim[..] {
        let foot = |place: [f64; 2]| [place[0], place[1], base];
        let corners = vec![height(p), height(q), foot(q), foot(p)];
        facets.push(Facet { corners, edges: Vec::new(), wall: true });
    }
    facets
}

/// The part of a square within the unit circle, and the points where its edges cross the circle.
fn within_ellipse(square: [[f64; 2]; 4]) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let (mut inside, mut rim) = (Vec::new(), Vec::new());
    let is_inside = |[x, y]: [f64; 2]| x * x + y * y <= 1.0;
    for (index, &corner) in square.iter().enumerate() {
        let next = square[(index + 1) % 4];
        if is_inside(corner) {
            inside.push(corner);
        }
        if is_inside(corner) != is_inside(next) {
            let crossing = if is_inside(corner) {
                circle_crossing(corner, next)
            } else {
                circle_crossing(next, corner)
            };
            inside.push(crossing);
            rim.push(crossing);
        }
    }
    (inside, rim)
}

/// Point where the line from a point inside to one outside crosses the unit circle.
fn circle_crossing(inside: [f64; 2], outside: [f64; 2]) -> [f64; 2] {
    let [x, y] = inside;
    let [dx, dy] = [outside[0] - x, outside[1] - y];
    let (square, mixed) = (dx * dx + dy * dy, x * dx + y * dy);
    let root = (mixed * mixed + square * (1.0 - x * x - y * y)).max(0.0).sqrt();
    let share = ((root - mixed) / square).clamp(0.0, 1.0);
    [x + share * dx, y + share * dy]
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

    /// (−0.6, 0.8) lies on the circle except for rounding error.
    #[test]
    fn a_corner_on_the_rim_is_no_spike() {
        let (inside, _) = within_ellipse([[-0.65, 0.75], [-0.6, 0.75], [-0.6, 0.8], [-0.65, 0.8]]);
        assert!(inside.iter().all(|[x, y]| x.hypot(*y) < 1.0 + 1e-12));
    }

    #[test]
    fn a_square_outside_is_nothing() {
        let (inside, rim) = within_ellipse([[1.1, 1.1], [1.2, 1.1], [1.2, 1.2], [1.1, 1.2]]);
        assert!(inside.is_empty() && rim.is_empty());
    }
}
