//! Undeformed distance of two bodies: given at points, interpolated by cubics.
//!
//! Between two points the distance is Hermite's cubic with the slopes of the parabolas through
//! three neighbours (Bessel): exact for parabolas on any spacing, otherwise with an error of third
//! order in the spacing, and without oscillations beyond two intervals. On equidistant points these
//! are the cubics of Catmull and Rom (1974).

use super::interpolation::{Weights, weights_at};
use crate::normal::Extent;
use crate::reporting::{Error, Place, Quantity, Requirement, require_at, require_positive};

/// Undeformed distance of two bodies (profile of the wheel minus that of the rail) around their
/// contact. Only differences matter, so it may include any constant.
#[derive(Debug, Clone, PartialEq)]
pub struct UndeformedDistance {
    pub(super) shape: Shape,
}

/// Representation of the distance.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// d(y) + x²/(2R).
    Across { y: Vec<f64>, distance: Vec<f64>, radius: f64 },
    /// d(x) on a length across rolling, of a line contact.
    Along { x: Vec<f64>, distance: Vec<f64>, length: f64 },
    /// Given at the points x × y, rows along x.
    Lattice { x: Vec<f64>, y: Vec<f64>, distance: Vec<f64> },
}

/// Steps in each direction in which the lowest point is looked for around the lowest given one: the
/// distance is then within 10⁻⁴ of what it grows by between points.
const FINE: usize = 64;

/// Minimum number of points in each direction.
const FEWEST: usize = 4;

impl UndeformedDistance {
    /// Number of its points within a rectangle, in each direction in which it is given by points.
    pub(super) fn points_within(&self, extent: &Extent) -> Vec<usize> {
        let within = |line: &[f64], [from, to]: [f64; 2]| {
            line.iter().filter(|at| (from..=to).contains(*at)).count()
        };
        match &self.shape {
            Shape::Across { y, .. } => vec![within(y, extent.y)],
            Shape::Along { x, .. } => vec![within(x, extent.x)],
            Shape::Lattice { x, y, .. } => vec![within(x, extent.x), within(y, extent.y)],
        }
    }

    /// A distance given across at x = 0 by `distance` (in m) at the positions `y` (in m,
    /// ascending), with the relative rolling radius R (in m), 1/R = 1/R_wheel + 1/R_rail: d(y) +
    /// x²/(2R).
    pub fn across(y: Vec<f64>, distance: Vec<f64>, relative_radius: f64) -> Result<Self, Error> {
        require_positive(Quantity::WheelRadiusX, relative_radius)?;
        check_positions('y', &y)?;
        check_values(&distance, y.len())?;
        Ok(Self { shape: Shape::Across { y, distance, radius: relative_radius } })
    }

    /// The distance of two cylindrical bodies with parallel axes, given by `distance` (in m) at the
    /// positions `x` (in m, ascending), the same on a length across rolling, in m: a line contact,
    /// whose pressure does not change across.
    pub fn along(x: Vec<f64>, distance: Vec<f64>, length: f64) -> Result<Self, Error> {
        require_positive(Quantity::LineLength, length)?;
        check_positions('x', &x)?;
        check_values(&distance, x.len())?;
        Ok(Self { shape: Shape::Along { x, distance, length } })
    }

    /// A distance given (in m) at the positions `x` × `y` (in m, ascending), rows along x: the
    /// value at (i, j) is `distance[j * x.len() + i]`.
    pub fn on_lattice(x: Vec<f64>, y: Vec<f64>, distance: Vec<f64>) -> Result<Self, Error> {
        check_positions('x', &x)?;
        check_positions('y', &y)?;
        check_values(&distance, x.len() * y.len())?;
        Ok(Self { shape: Shape::Lattice { x, y, distance } })
    }

    /// The rectangle on which the distance is known, in m; unbounded along x if only a profile
    /// across is given.
    pub(crate) fn bounds(&self) -> [[f64; 2]; 2] {
        let ends = |v: &[f64]| [v[0], v[v.len() - 1]];
        match &self.shape {
            Shape::Across { y, .. } => [[f64::NEG_INFINITY, f64::INFINITY], ends(y)],
            Shape::Along { x, length, .. } => [ends(x), [-0.5 * length, 0.5 * length]],
            Shape::Lattice { x, y, .. } => [ends(x), ends(y)],
        }
    }

    /// Whether it is the same all across.
    pub(super) fn is_line(&self) -> bool {
        matches!(self.shape, Shape::Along { .. })
    }

    /// Distance (in m) at the positions `x` × `y` (in m), rows along x.
    pub(crate) fn sample(&self, x: &[f64], y: &[f64]) -> Vec<f64> {
        match &self.shape {
            Shape::Across { y: nodes, distance, radius } => {
                let rolling: Vec<f64> = x.iter().map(|x| 0.5 * x * x / radius).collect();
                let across = y.iter().map(|y| weights_at(nodes, *y).apply(|j| distance[j]));
                across.flat_map(|d| rolling.iter().map(move |r| d + r)).collect()
            }
            Shape::Along { x: nodes, distance, .. } => {
                let along = x.iter().map(|x| weights_at(nodes, *x).apply(|i| distance[i]));
                along.collect::<Vec<_>>().repeat(y.len())
            }
            Shape::Lattice { x: columns, y: rows, distance } => {
                let along: Vec<Weights> = x.iter().map(|x| weights_at(columns, *x)).collect();
                let across = y.iter().map(|y| weights_at(rows, *y));
                let lines = across.map(|weights| -> Vec<f64> {
                    let at = |i: usize| weights.apply(|j| distance[j * columns.len() + i]);
                    (0..columns.len()).map(at).collect()
                });
                lines
                    .flat_map(|line| along.iter().map(|w| w.apply(|i| line[i])).collect::<Vec<_>>())
                    .collect()
            }
        }
    }

    /// Smallest distance, where the bodies touch first, in m: found about the lowest given point.
    pub fn lowest(&self) -> f64 {
        let (Shape::Across { distance, .. }
        | Shape::Along { distance, .. }
        | Shape::Lattice { distance, .. }) = &self.shape;
        let least = (1..distance.len())
            .fold(0, |least, k| if distance[k] < distance[least] { k } else { least });
        let around = |line: &[f64], k: usize| -> Vec<f64> {
            let (from, to) = (line[k.saturating_sub(1)], line[(k + 1).min(line.len() - 1)]);
            (0..=FINE).map(|i| from + (to - from) * i as f64 / FINE as f64).collect()
        };
        let [x, y] = match &self.shape {
            Shape::Across { y, .. } => [vec![0.0], around(y, least)],
            Shape::Along { x, .. } => [around(x, least), vec![0.0]],
            Shape::Lattice { x, y, .. } => [around(x, least % x.len()), around(y, least / x.len())],
        };
        self.sample(&x, &y).into_iter().fold(distance[least], f64::min)
    }
}

const QUANTITY: Quantity = Quantity::UndeformedDistance;

fn check_positions(axis: char, positions: &[f64]) -> Result<(), Error> {
    let (quantity, fewest, count) = (QUANTITY, FEWEST, positions.len());
    if count < fewest {
        return Err(Error::TooFewPositions { quantity, axis, fewest, count });
    }
    let is_ascending = |pair: &[f64]| pair[0] < pair[1] && (pair[1] - pair[0]).is_finite();
    let axis = if axis == 'x' { "x" } else { "y" };
    match positions.windows(2).find(|pair| !is_ascending(pair)) {
        None => Ok(()),
        Some(pair) => {
            let (before, after) = (pair[0], pair[1]);
            Err(Error::NotAscending { quantity, axis, before, after })
        }
    }
}

fn check_values(distance: &[f64], expected: usize) -> Result<(), Error> {
    let count = distance.len();
    if count != expected {
        return Err(Error::WrongCount { quantity: QUANTITY, expected, count });
    }
    distance
        .iter()
        .enumerate()
        .try_for_each(|(k, d)| require_at(QUANTITY, Requirement::Finite, *d, Place::Index(k + 1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Both representations of a parabola are exact, between the points and up to the edge.
    #[test]
    fn a_parabola_is_exact() {
        let y: Vec<f64> = (0..9).map(|k| 1e-3 * (f64::from(k) + 0.2 * f64::from(k % 3))).collect();
        let x: Vec<f64> = (0..7).map(|k| 2e-3 * f64::from(k) - 6e-3).collect();
        let across = |y: f64| 3e-6 - 2e-3 * y + 1.5 * y * y;
        let radius = 0.4;
        let plane = |x: f64, y: f64| across(y) + 0.5 * x * x / radius;
        let line = y.iter().map(|y| across(*y)).collect();
        let field = y.iter().flat_map(|y| x.iter().map(|x| plane(*x, *y))).collect();
        let places = ([-5.7e-3, 0.1e-3, 3.3e-3], [y[0], 0.3e-3, 4.4e-3, y[8]]);
        for distance in [
            UndeformedDistance::across(y.clone(), line, radius).unwrap(),
            UndeformedDistance::on_lattice(x, y, field).unwrap(),
        ] {
            let values = distance.sample(&places.0, &places.1);
            for (k, value) in values.iter().enumerate() {
                let expected = plane(places.0[k % 3], places.1[k / 3]);
                assert_relative_eq!(*value, expected, max_relative = 1e-12, epsilon = 1e-18);
            }
        }
    }

    #[test]
    fn what_is_no_shape_is_refused_by_name() {
        let y = vec![0.0, 1.0, 2.0, 3.0];
        let across =
            |y: &[f64], d: &[f64], r: f64| UndeformedDistance::across(y.to_vec(), d.to_vec(), r);
        let cases = [
            (across(&y[..3], &y[..3], 1.0), "at least 4 values of y, got 3"),
            (
                across(&[0.0, 2.0, 1.0, 3.0], &y, 1.0),
                "ascend strictly in y, but 1 m comes after 2 m",
            ),
            (across(&y, &y[..3], 1.0), "needs 4 values, got 3"),
            (across(&y, &[0.0, 1.0, f64::NAN, 0.0], 1.0), "NaN m in place 3"),
            (across(&y, &y, -1.0), "wheel_radius_x must be positive"),
        ];
        for (result, expected) in cases {
            let message = result.unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
