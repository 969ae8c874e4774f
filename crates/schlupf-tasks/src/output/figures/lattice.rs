//! Values over two axes, and their contours.

use super::chain::{Chain, Crossing, chains};
use super::smooth::smooth;

/// Values at the places of two axes.
#[derive(Debug, Clone)]
pub(crate) struct Lattice {
    /// Places along x, increasing.
    pub x: Vec<f64>,
    /// Places along y, increasing.
    pub y: Vec<f64>,
    /// A row for each place along y; not a number where there is none.
    pub rows: Vec<Vec<f64>>,
}

impl Lattice {
    /// The same with places in between, where the values are smooth and do not overshoot.
    pub(crate) fn refined(&self) -> Self {
        let refined = |places: &[f64], values: &mut dyn Iterator<Item = f64>| -> Vec<[f64; 2]> {
            let points: Vec<[f64; 2]> = places.iter().zip(values).map(|(x, v)| [*x, v]).collect();
            even(&smooth(&points), &points)
        };
        let along_x: Vec<Vec<[f64; 2]>> =
            self.rows.iter().map(|row| refined(&self.x, &mut row.iter().copied())).collect();
        let x: Vec<f64> = along_x.first().map_or(Vec::new(), |row| firsts(row));
        let columns: Vec<Vec<[f64; 2]>> = (0..x.len())
            .map(|k| refined(&self.y, &mut along_x.iter().map(|row| row[k][1])))
            .collect();
        let y: Vec<f64> = columns.first().map_or(Vec::new(), |column| firsts(column));
        let rows = (0..y.len()).map(|j| columns.iter().map(|column| column[j][1]).collect());
        Self { rows: rows.collect(), x, y }
    }

    /// The smallest and the largest value that is finite.
    pub(crate) fn range(&self) -> Option<[f64; 2]> {
        let finite = self.rows.iter().flatten().copied().filter(|value| value.is_finite());
        let range = |[low, high]: [f64; 2], value: f64| [low.min(value), high.max(value)];
        let [low, high] = finite.fold([f64::INFINITY, f64::NEG_INFINITY], range);
        (low <= high).then_some([low, high])
    }

    /// The lines on which the value is that of a level.
    pub(crate) fn contour(&self, level: f64) -> Vec<Chain> {
        let squares = self.places().filter_map(|(i, j)| self.square(i, j, level));
        chains(&squares.flat_map(crossings).collect::<Vec<_>>())
    }

    /// The part where values are below a level, as polygons; squares of a row that are below it all
    /// over make one.
    pub(crate) fn below(&self, level: f64) -> Vec<Vec<[f64; 2]>> {
        let mut polygons = Vec::new();
        let mut run: Option<[Corner; 2]> = None;
        let rectangle = |[first, last]: [Corner; 2]| {
            let ([left, bottom], [right, top]) = (first.at, last.at);
            vec![[left, bottom], [right, bottom], [right, top], [left, top]]
        };
        for (i, j) in self.places() {
            let square = self.square(i, j, level);
            let is_below = |square: &Square| square.iter().all(|corner| corner.value < 0.0);
            match (square.filter(is_below), square) {
                (Some([first, _, last, _]), _) if i > 1 => {
                    run = Some([run.map_or(first, |[first, _]| first), last]);
                }
                (Some([first, _, last, _]), _) => {
                    polygons.extend(run.replace([first, last]).map(rectangle));
                }
                (None, square) => {
                    polygons.extend(run.take().map(rectangle));
                    polygons.extend(square.map(below).filter(|polygon| polygon.len() > 2));
                }
            }
        }
        polygons.extend(run.map(rectangle));
        polygons
    }

    /// The squares, row by row, by their upper ends.
    fn places(&self) -> impl Iterator<Item = (usize, usize)> {
        let columns = self.x.len();
        (1..self.y.len()).flat_map(move |j| (1..columns).map(move |i| (i, j)))
    }

    /// A square, relative to a level; `None` where a value is unknown.
    fn square(&self, i: usize, j: usize, level: f64) -> Option<Square> {
        let corner = |i: usize, j: usize| {
            let value = self.rows[j][i] - level;
            let (node, at) = (j * self.x.len() + i, [self.x[i], self.y[j]]);
            value.is_finite().then_some(Corner { node, at, value })
        };
        Some([corner(i - 1, j - 1)?, corner(i, j - 1)?, corner(i, j)?, corner(i - 1, j)?])
    }
}

/// A corner of a square between four places.
#[derive(Debug, Clone, Copy)]
struct Corner {
    /// Its number on the lattice.
    node: usize,
    /// Its position, in m or in units of axes.
    at: [f64; 2],
    /// Value of the field above a level.
    value: f64,
}

/// The corners of a square in order.
type Square = [Corner; 4];

/// Place where the contour crosses the edge of a square that begins at a corner.
fn crossing(corners: &Square, index: usize) -> Option<Crossing> {
    let (one, other) = (corners[index], corners[(index + 1) % 4]);
    let (f, g) = (one.value, other.value);
    let share = f / (f - g);
    let at = [0, 1].map(|axis| one.at[axis] + share * (other.at[axis] - one.at[axis]));
    let edge = [one.node.min(other.node), one.node.max(other.node)];
    ((f >= 0.0) != (g >= 0.0)).then_some(Crossing { edge, at })
}

/// Places where the contour crosses the edges of a square, joined in pairs.
fn crossings(corners: Square) -> Vec<[Crossing; 2]> {
    let places: Vec<Crossing> = (0..4).filter_map(|index| crossing(&corners, index)).collect();
    places.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// The part of a square below the level.
fn below(corners: Square) -> Vec<[f64; 2]> {
    let of_edge = |index: usize| {
        let Corner { at, value, .. } = corners[index];
        let crossing = crossing(&corners, index).map(|crossing| crossing.at);
        (value < 0.0).then_some(at).into_iter().chain(crossing)
    };
    (0..4).flat_map(of_edge).collect()
}

fn firsts(points: &[[f64; 2]]) -> Vec<f64> {
    points.iter().map(|point| point[0]).collect()
}

/// A smooth curve at the same number of places between any two points: where it is interrupted,
/// there is not a number.
fn even(curve: &[[f64; 2]], points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    const PIECES: u32 = 8;
    let mut curve = curve.iter().peekable();
    let mut places = Vec::with_capacity(points.len() * PIECES as usize);
    for pair in points.windows(2) {
        for piece in 0..PIECES {
            let x = pair[0][0] + f64::from(piece) / f64::from(PIECES) * (pair[1][0] - pair[0][0]);
            let near = 0.25 / f64::from(PIECES) * (pair[1][0] - pair[0][0]);
            while curve.next_if(|point| point[0] < x - near).is_some() {}
            let value = curve.peek().filter(|point| (point[0] - x).abs() <= near);
            places.push([x, value.map_or(f64::NAN, |point| point[1])]);
        }
    }
    places.extend(points.last());
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(value: impl Fn(f64, f64) -> f64) -> Lattice {
        let x: Vec<f64> = (0..9).map(|k| f64::from(k * k) / 32.0 - 1.0).collect();
        let y: Vec<f64> = (0..7).map(|k| f64::from(k) / 3.0 - 1.0).collect();
        let rows = y.iter().map(|y| x.iter().map(|x| value(*x, *y)).collect()).collect();
        Lattice { x, y, rows }
    }

    #[test]
    fn a_plane_has_straight_contours() {
        let fine = lattice(|x, y| x + 2.0 * y).refined();
        assert_eq!((fine.x.len(), fine.y.len()), (65, 49));
        let lines = fine.contour(0.5);
        assert_eq!(lines.len(), 1);
        assert!(!lines[0].is_closed);
        for [x, y] in &lines[0].points {
            assert!((x + 2.0 * y - 0.5).abs() < 1e-9, "{x} {y}");
        }
    }

    #[test]
    fn what_is_below_a_level_has_its_area() {
        let area = |polygon: &Vec<[f64; 2]>| {
            let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
            0.5 * edges.map(|(p, q)| p[0] * q[1] - q[0] * p[1]).sum::<f64>()
        };
        let plane = lattice(|x, y| x + 2.0 * y).refined();
        for (level, expected) in [(0.0, 2.0), (-2.0, 0.25), (-4.0, 0.0), (4.0, 4.0)] {
            let found: f64 = plane.below(level).iter().map(area).sum();
            assert!((found - expected).abs() < 1e-9, "{level}: {found}");
        }
        let whole = plane.below(4.0);
        assert_eq!(whole.len(), plane.y.len() - 1, "a rectangle for each row");
    }

    #[test]
    fn a_hill_has_closed_ones_and_what_is_unknown_has_none() {
        let hill = lattice(|x, y| -x * x - y * y).refined();
        let lines = hill.contour(-0.25);
        assert!(lines.len() == 1 && lines[0].is_closed);
        for [x, y] in &lines[0].points {
            assert!((x.hypot(*y) - 0.5).abs() < 0.03, "{x} {y}");
        }
        let gap = lattice(|x, y| if x > 0.5 { f64::NAN } else { x + y }).refined();
        assert_eq!(gap.range().map(|[low, _]| low), Some(-2.0));
        let lines = gap.contour(0.0);
        assert!(lines.iter().flat_map(|line| &line.points).all(|point| point[0] <= 0.6));
        assert!(lattice(|_, _| f64::NAN).range().is_none());
    }
}
