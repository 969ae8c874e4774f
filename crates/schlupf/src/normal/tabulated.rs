//! Pressure from a table: from finite elements, a measurement, or another program.

use std::sync::Arc;

use super::{NormalContact, NormalSummary, Pressure, PressureSource};
use crate::normal::{Axis, Extent};
use crate::numerics::interpolation::mix;
use crate::reporting::{Error, Place, Quantity, Requirement, require_at, require_positive};

/// Samples below this fraction of the largest one are considered noise and set to zero.
const NOISE: f64 = 1e-4;

/// Largest and smallest peak pressure of a table, in Pa.
const PEAK_RANGE: [f64; 2] = [1.0, 1e14];

/// Normal pressure sampled on an equidistant rectangular lattice. In between, its square is
/// bilinear, and extrapolated to the edge of the contact, which is within one spacing of the outer
/// samples; it is scaled such that the load is that of the samples. Positions are relative to the
/// centre of the patch, whatever the origin of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureTable {
    x: Axis,
    y: Axis,
    pressure: Vec<f64>,
    /// The origin of these positions in the given coordinates, x and y in m.
    origin: [f64; 2],
}

/// Tolerance of equidistance, relative to the spacing: printed numbers are rounded.
const SPACING_TOLERANCE: f64 = 1e-2;

fn axis(name: char, positions: &[f64]) -> Result<Axis, Error> {
    let (quantity, fewest, count) = (Quantity::PressureTable, 2, positions.len());
    if count < fewest {
        return Err(Error::TooFewPositions { quantity, axis: name, fewest, count });
    }
    let spacing = (positions[count - 1] - positions[0]) / (count - 1) as f64;
    let axis = Axis { start: positions[0], spacing, count };
    let fits = |k: &usize| (positions[*k] - axis.at(*k)).abs() <= SPACING_TOLERANCE * spacing;
    if (0..count).all(|k| fits(&k)) {
        return Ok(axis);
    }
    let off = |step: &&[f64]| (step[1] - step[0] - spacing).abs();
    let worst = positions.windows(2).max_by(|one, other| off(one).total_cmp(&off(other)));
    let step = worst.map_or([0.0; 2], |step| [step[0], step[1]]);
    Err(Error::NotEquidistant { axis: name, step, spacing })
}

impl PressureTable {
    /// A table of `pressure` (in Pa) at the positions `x` × `y` (in m, ascending and equidistant),
    /// rows along x: the value at (i, j) is `pressure[j * x.len() + i]`.
    ///
    /// # Errors
    /// Positions that are not equidistant, a wrong number of values, a value that is negative or
    /// not finite, or no positive value.
    pub fn new(x: &[f64], y: &[f64], pressure: Vec<f64>) -> Result<Self, Error> {
        let table = Self::where_it_is(x, y, pressure)?;
        let Extent { x, y } = table.extent();
        Ok(table.seen_from([0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])]))
    }

    /// The same with positions in the given coordinates, not relative to the centre of the patch.
    pub(crate) fn where_it_is(x: &[f64], y: &[f64], pressure: Vec<f64>) -> Result<Self, Error> {
        let (x, y) = (axis('x', x)?, axis('y', y)?);
        let (quantity, expected, count) =
            (Quantity::PressureTable, x.count * y.count, pressure.len());
        if count != expected {
            return Err(Error::WrongCount { quantity, expected, count });
        }
        for (k, value) in pressure.iter().enumerate() {
            let place = Place::Position([x.at(k % x.count), y.at(k / x.count)]);
            require_at(quantity, Requirement::NotNegative, *value, place)?;
        }
        let peak = pressure.iter().copied().fold(0.0, f64::max);
        if !(PEAK_RANGE[0]..=PEAK_RANGE[1]).contains(&peak) {
            return Err(Error::TablePeak { peak, range: PEAK_RANGE });
        }
        let is_noise = |p: f64| p < NOISE * peak;
        let pressure = pressure.into_iter().map(|p| if is_noise(p) { 0.0 } else { p }).collect();
        Ok(Self { x, y, pressure, origin: [0.0; 2] })
    }

    /// The same with positions relative to `origin` (in m).
    pub(crate) fn seen_from(&self, origin: [f64; 2]) -> Self {
        let mut table = self.clone();
        table.x.start -= origin[0];
        table.y.start -= origin[1];
        table.origin = [table.origin[0] + origin[0], table.origin[1] + origin[1]];
        table
    }

    /// The same with all pressures multiplied by a factor, dimensionless.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let pressure = self.pressure.iter().map(|p| factor * p).collect();
        Self { pressure, ..self.clone() }
    }

    /// Separate pressures as one table, in the coordinates that all of them have.
    ///
    /// # Errors
    /// As [`Self::new`], where there is none.
    pub(crate) fn union(tables: &[Self]) -> Result<Self, Error> {
        if let [one] = tables {
            return Ok(one.clone());
        }
        let axis = |of: fn(&Self) -> &Axis| {
            let spacing = tables.iter().map(|t| of(t).spacing).fold(f64::INFINITY, f64::min);
            let ends = |t: &Self| [of(t).start, of(t).at(of(t).count - 1)];
            let low = tables.iter().map(|t| ends(t)[0]).fold(f64::INFINITY, f64::min);
            let high = tables.iter().map(|t| ends(t)[1]).fold(f64::NEG_INFINITY, f64::max);
            Axis { start: low, spacing, count: ((high - low) / spacing).ceil() as usize + 1 }
        };
        let (x, y) = (axis(Self::axis_x), axis(Self::axis_y));
        let mut pressure = Vec::with_capacity(x.count * y.count);
        for y in y.positions() {
            let is_within = |t: &&Self| (t.y.start..=t.y.at(t.y.count - 1)).contains(&y);
            let lines: Vec<_> =
                tables.iter().filter(is_within).map(|t| (t.x, t.line_at(y))).collect();
            let at = |x: f64| lines.iter().map(|(axis, line)| along(axis, line, x)).sum::<f64>();
            pressure.extend(x.positions().into_iter().map(at));
        }
        Self::where_it_is(&x.positions(), &y.positions(), pressure)
    }

    /// Position of the origin of the table in the given coordinates, x and y in m.
    pub fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// Number of separate parts of the positive pressure; samples that touch at a corner are
    /// connected.
    pub fn parts(&self) -> usize {
        let (columns, rows) = (self.x.count, self.y.count);
        let mut is_open: Vec<bool> = self.pressure.iter().map(|p| *p > 0.0).collect();
        let mut parts = 0;
        let mut reached = Vec::new();
        for start in 0..is_open.len() {
            if !std::mem::take(&mut is_open[start]) {
                continue;
            }
            parts += 1;
            reached.push(start);
            while let Some(cell) = reached.pop() {
                let (i, j) = (cell % columns, cell / columns);
                for row in j.saturating_sub(1)..(j + 2).min(rows) {
                    for column in i.saturating_sub(1)..(i + 2).min(columns) {
                        let next = row * columns + column;
                        if std::mem::take(&mut is_open[next]) {
                            reached.push(next);
                        }
                    }
                }
            }
        }
        parts
    }

    /// ∫ p dA of the table, in N.
    pub fn load(&self) -> f64 {
        self.pressure.iter().sum::<f64>() * self.x.spacing * self.y.spacing
    }

    /// Largest pressure, in Pa.
    pub fn peak(&self) -> f64 {
        self.pressure.iter().copied().fold(0.0, f64::max)
    }

    /// The bounding rectangle of the positive pressure.
    pub fn extent(&self) -> Extent {
        let row = |j: usize| self.pressure[j * self.x.count..(j + 1) * self.x.count].to_vec();
        let column = |i: usize| (0..self.y.count).map(|j| self.at(i, j)).collect::<Vec<_>>();
        Extent {
            x: span((0..self.y.count).map(row), &self.x),
            y: span((0..self.x.count).map(column), &self.y),
        }
    }

    /// Whether it is the same in all rows.
    pub(crate) fn is_line(&self) -> bool {
        let (first, rest) = self.pressure.split_at(self.x.count);
        rest.chunks_exact(self.x.count).all(|row| row == first)
    }

    pub(crate) fn axis_x(&self) -> &Axis {
        &self.x
    }

    pub(crate) fn axis_y(&self) -> &Axis {
        &self.y
    }

    /// Pressure along x at a given y (in m), in Pa; the square is interpolated, because it is
    /// linear at the edge of a contact. Between a row in contact and one without, the square is
    /// extrapolated from inside, so that the edge between the two is in the right place.
    pub(crate) fn line_at(&self, y: f64) -> Vec<f64> {
        let position = ((y - self.y.start) / self.y.spacing).clamp(0.0, (self.y.count - 1) as f64);
        let j = (position.floor() as usize).min(self.y.count - 2);
        let share = position - j as f64;
        (0..self.x.count)
            .map(|i| {
                let square = [self.square(i, j, j + 1), self.square(i, j + 1, j)];
                mix(square, share).max(0.0).sqrt()
            })
            .collect()
    }

    /// Square of the pressure at column `i` and row `j`, in Pa²; if it is zero there but not in the
    /// row `beside`, the square extrapolated from that row and the next one, not above zero.
    fn square(&self, i: usize, j: usize, beside: usize) -> f64 {
        let (here, inside) = (self.at(i, j).powi(2), self.at(i, beside).powi(2));
        if here > 0.0 || inside == 0.0 {
            return here;
        }
        let further = (2 * beside).checked_sub(j).filter(|row| *row < self.y.count);
        let beyond = further.map_or(0.0, |row| self.at(i, row).powi(2));
        (2.0 * inside - beyond).min(0.0)
    }

    fn at(&self, i: usize, j: usize) -> f64 {
        self.pressure[j * self.x.count + i]
    }
}

/// Pressure along a line (in Pa) at a position in m: its square is linear.
fn along(axis: &Axis, line: &[f64], x: f64) -> f64 {
    let position = (x - axis.start) / axis.spacing;
    let k = position.floor();
    if !(0.0..=(line.len() - 2) as f64).contains(&k) {
        return 0.0;
    }
    let ends = [k as usize, k as usize + 1].map(|k| line[k].powi(2));
    mix(ends, position - k).sqrt()
}

/// A run of positive samples.
///
/// Near its edge a contact pressure is proportional to the square root of the distance, so its
/// square is taken to be linear between the samples, and the edge is where the line through the two
/// outer squares vanishes, within one spacing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Run {
    /// Positions (in m) with the square of the pressure there (in Pa²), from one edge to the other.
    nodes: Vec<[f64; 2]>,
}

impl Run {
    fn new(samples: &[f64], range: std::ops::Range<usize>, axis: &Axis) -> Self {
        let (first, last) = (range.start, range.end - 1);
        let square = |k: usize| samples[k].powi(2);
        // Where the pressure does not fall towards its end, it ends abruptly, halfway to the next
        // sample. The minimum distance keeps the outermost sample within the contact.
        let beyond = |outer: f64, inner: f64| {
            if inner > outer {
                ((outer / (inner - outer)).clamp(1e-3, 1.0), 0.0)
            } else {
                (0.5, outer)
            }
        };
        let [behind, ahead] = if first == last {
            [(0.5, square(first)); 2]
        } else {
            [(first, first + 1), (last, last - 1)]
                .map(|(outer, inner)| beyond(square(outer), square(inner)))
        };
        let mut nodes = Vec::with_capacity(range.len() + 2);
        nodes.push([axis.at(first) - behind.0 * axis.spacing, behind.1]);
        nodes.extend(range.map(|k| [axis.at(k), square(k)]));
        nodes.push([axis.at(last) + ahead.0 * axis.spacing, ahead.1]);
        Self { nodes }
    }

    /// Positions behind and ahead of it at which the pressure vanishes, in m.
    pub fn edges(&self) -> [f64; 2] {
        [self.nodes[0][0], self.nodes[self.nodes.len() - 1][0]]
    }

    /// ∫ p dx from `low` to `high` (in m) within the run, in N/m.
    pub fn integral(&self, low: f64, high: f64) -> f64 {
        let between = |pair: &[[f64; 2]]| {
            let [[start, at_start], [end, at_end]] = [pair[0], pair[1]];
            let [from, to] = [low.max(start), high.min(end)];
            if from >= to {
                return 0.0;
            }
            let root = |x: f64| mix([at_start, at_end], (x - start) / (end - start)).sqrt();
            let [p, q] = [root(from), root(to)];
            let sum = p + q;
            // ∫ of the root of a linear function.
            if sum > 0.0 { (to - from) * 2.0 / 3.0 * (sum - p * q / sum) } else { 0.0 }
        };
        let first = self.nodes.partition_point(|node| node[0] <= low).saturating_sub(1);
        let end = self.nodes.partition_point(|node| node[0] < high) + 1;
        self.nodes[first..end.min(self.nodes.len())].windows(2).map(between).sum()
    }
}

/// The runs of positive samples in a line.
pub(crate) fn positive_runs(samples: &[f64], axis: &Axis) -> Vec<Run> {
    let is_positive = |k: &usize| samples[*k] > 0.0;
    let mut runs = Vec::new();
    let mut start = 0;
    while let Some(first) = (start..samples.len()).find(is_positive) {
        let end = (first..samples.len()).find(|k| !is_positive(k)).unwrap_or(samples.len());
        runs.push(Run::new(samples, first..end, axis));
        start = end;
    }
    runs
}

fn span(lines: impl Iterator<Item = Vec<f64>>, axis: &Axis) -> [f64; 2] {
    let mut extent = [f64::INFINITY, f64::NEG_INFINITY];
    for run in lines.flat_map(|line| positive_runs(&line, axis)) {
        let edges = run.edges();
        extent = [extent[0].min(edges[0]), extent[1].max(edges[1])];
    }
    extent
}

/// Pressure from a table, optionally scaled to a load.
#[derive(Debug, Clone)]
pub struct Tabulated {
    table: Arc<PressureTable>,
    load: f64,
}

impl Tabulated {
    /// The table unchanged, or scaled to `load` (in N).
    ///
    /// ```
    /// use schlupf::normal::{PressureSource, PressureTable, Tabulated};
    ///
    /// let positions = [0.0, 2e-3, 4e-3, 6e-3];
    /// let row = [0.0, 1e9, 1e9, 0.0];
    /// let pressure = [[0.0; 4], row, row, [0.0; 4]].concat();
    /// let table = PressureTable::new(&positions, &positions, pressure)?;
    /// let half = Tabulated::new(table.clone(), Some(0.5 * table.load()))?;
    /// assert!((half.normal_contact(None)?.summary.peak_pressure - 0.5e9).abs() < 1.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(table: PressureTable, load: Option<f64>) -> Result<Self, Error> {
        let load = load.unwrap_or_else(|| table.load());
        require_positive(Quantity::Load, load)?;
        Ok(Self { table: Arc::new(table), load })
    }
}

impl PressureSource for Tabulated {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        let load = load.unwrap_or(self.load);
        require_positive(Quantity::Load, load)?;
        let factor = load / self.table.load();
        let extent = self.table.extent();
        let half = |range: [f64; 2]| 0.5 * (range[1] - range[0]);
        if half(extent.x) <= 0.0 {
            return Err(Error::NoArea {});
        }
        let summary = NormalSummary {
            load,
            semi_axis_x: half(extent.x),
            semi_axis_y: half(extent.y),
            peak_pressure: factor * self.table.peak(),
            approach: None,
            origin: Some(self.table.origin()),
            parts: self.table.parts(),
        };
        let pressure = Pressure::Tabulated(Arc::clone(&self.table), factor);
        Ok(NormalContact { summary, pressure, rows: None })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn hertz_table(count: usize) -> PressureTable {
        let (a, b) = (6e-3, 4e-3);
        let axis = |half: f64| -> Vec<f64> {
            (0..count).map(|k| half * 1.1 * (2.0 * k as f64 / (count - 1) as f64 - 1.0)).collect()
        };
        let (x, y) = (axis(a), axis(b));
        let value =
            |x: f64, y: f64| 1e9 * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt();
        let pressure = y.iter().flat_map(|y| x.iter().map(|x| value(*x, *y))).collect();
        PressureTable::new(&x, &y, pressure).unwrap()
    }

    /// The edge of a Hertzian table is found far more accurately than its spacing (6 % of a here).
    #[test]
    fn extent_of_a_hertzian_table_is_its_ellipse() {
        let extent = hertz_table(37).extent();
        assert_relative_eq!(extent.x[1], 6e-3, max_relative = 0.01);
        assert_relative_eq!(extent.y[0], -4e-3, max_relative = 0.01);
    }

    /// Noise around the patch is not contact, and the origin is the centre of the patch.
    #[test]
    fn noise_is_cut_and_the_patch_is_centred() {
        let clean = hertz_table(37);
        let shifted: Vec<f64> = (0..37).map(|k| 0.1 + clean.x.at(k)).collect();
        let across: Vec<f64> = (0..37).map(|k| clean.y.at(k)).collect();
        let noisy = clean.pressure.iter().map(|p| p + 1e-3).collect();
        let table = PressureTable::new(&shifted, &across, noisy).unwrap();
        let (one, two) = (clean.extent(), table.extent());
        assert_relative_eq!(one.x[0], two.x[0], max_relative = 1e-9);
        assert_relative_eq!(one.y[1], two.y[1], max_relative = 1e-9);
    }

    #[test]
    fn a_given_load_scales_the_table() {
        let table = hertz_table(61);
        let peak = table.peak();
        let half = Tabulated::new(table.clone(), Some(0.5 * table.load())).unwrap();
        let contact = half.normal_contact(None).unwrap().summary;
        assert_relative_eq!(contact.peak_pressure, 0.5 * peak, max_relative = 1e-14);
    }

    #[test]
    fn what_is_no_table_is_refused_by_name() {
        let refuse = |x: &[f64], y: &[f64], p: Vec<f64>| {
            PressureTable::new(x, y, p).unwrap_err().to_string()
        };
        let axis = [0.0, 1.0, 2.0];
        assert!(refuse(&axis, &[0.0, 1.0], vec![1.0; 5]).contains("needs 6 values, got 5"));
        assert!(refuse(&[0.0, 1.0, 3.0], &axis, vec![1.0; 9]).contains("equidistant"));
        assert!(refuse(&axis, &[0.0], vec![1.0; 3]).contains("at least 2 values of y"));
        assert!(refuse(&axis, &axis, vec![0.0; 9]).contains("largest pressure between"));
        assert!(refuse(&axis, &axis, vec![1e300; 9]).contains("1e300 Pa"));
        let mut hole = vec![1.0; 9];
        hole[4] = f64::NAN;
        assert!(refuse(&axis, &axis, hole).contains("x = 1 m, y = 1 m"));
    }
}
