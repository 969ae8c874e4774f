//! Lattices that the points of a table lie on.

use schlupf::normal::Axis;

use super::columns::Columns;
use crate::error::CaseError;

/// Positions may differ from the lattice by this part of a spacing, or by half of their last digit
/// if that is more, but never by more than this part.
const ROUNDING: f64 = 0.01;
const LARGEST_ROUNDING: f64 = 0.25;

/// Half of the last digit, and what the lattice is off itself because of it.
const DIGIT: f64 = 0.75;

/// The lattice that positions of the column `name`, in any order, lie on: not every place of it
/// needs to be taken.
pub fn axis(name: &str, positions: &[f64], columns: &Columns) -> Result<Axis, CaseError> {
    let mut sorted = positions.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let mut gaps: Vec<f64> = sorted.windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_unstable_by(f64::total_cmp);
    if sorted.is_empty() {
        let file = columns.field();
        let message = format!("{file} must have at least two values of {name}, but has no rows");
        return Err(columns.error(columns.header_line, message));
    }
    let widest = gaps.last().copied().unwrap_or(0.0);
    if widest <= 0.0 {
        let message = format!("{name} must have at least two values, but is the same everywhere");
        return Err(columns.error(columns.header_line, message));
    }
    let digit = columns.digit(name);
    // Where no line is missing the widest gap is the spacing, else most of the gaps are.
    let median = |least: f64| {
        let wide = &gaps[gaps.partition_point(|gap| *gap <= least)..];
        wide.get(wide.len() / 2).copied().unwrap_or(widest)
    };
    let median = median((ROUNDING * widest).min(DIGIT * digit));
    let lattices = [widest, median].map(|gap| through(&sorted, gap));
    let fits = |axis: &&Axis| sorted.iter().all(|x| holds(axis, *x, digit));
    if let Some(axis) = lattices.iter().find(fits) {
        return Ok(*axis);
    }
    let axis = &lattices[1];
    let off = |row: &usize| (positions[*row] - axis.at(axis.nearest(positions[*row]))).abs();
    let row = (0..positions.len()).max_by(|one, other| off(one).total_cmp(&off(other)));
    let row = row.unwrap_or(0);
    let message = format!("{name} must be equidistant, but {}", steps(&sorted));
    Err(columns.error(columns.lines[row], message))
}

/// The smallest and the largest step of sorted positions (in m) that are not the same.
fn steps(sorted: &[f64]) -> String {
    let pairs = || {
        sorted.windows(2).map(|pair| (pair[1] - pair[0], pair[0])).filter(|(step, _)| *step > 0.0)
    };
    let by_step = |one: &(f64, f64), other: &(f64, f64)| one.0.total_cmp(&other.0);
    let [smallest, largest] = [pairs().min_by(by_step), pairs().max_by(by_step)].map(|pair| {
        let (step, from) = pair.unwrap_or((0.0, 0.0));
        format!(
            "{} mm (from {} mm to {} mm)",
            rounded(step * 1e3),
            rounded(from * 1e3),
            rounded((from + step) * 1e3)
        )
    });
    format!("its steps are between {smallest} and {largest}")
}

/// The lattice of about a spacing (in m) that is nearest to sorted positions, by least squares.
fn through(sorted: &[f64], spacing: f64) -> Axis {
    let gaps = || sorted.windows(2).map(|pair| pair[1] - pair[0]);
    // Few digits make a gap longer and the next one shorter: their mean spans wide ones better.
    let near = gaps().filter(|gap| (gap / spacing - 1.0).abs() < 0.5);
    let (count, sum) = near.fold((0.0, 0.0), |(count, sum), gap| (count + 1.0, sum + gap));
    let spacing = if count > 0.0 { sum / count } else { spacing };
    let steps = gaps().map(|gap| (gap / spacing).round());
    let indices: Vec<f64> = std::iter::once(0.0)
        .chain(steps.scan(0.0, |index, step| {
            *index += step;
            Some(*index)
        }))
        .collect();
    let count = sorted.len() as f64;
    let means = [&indices[..], sorted].map(|values| values.iter().sum::<f64>() / count);
    let pairs = || indices.iter().zip(sorted).map(|(k, x)| (k - means[0], x - means[1]));
    let squares: f64 = pairs().map(|(k, _)| k * k).sum();
    let spacing = pairs().map(|(k, x)| k * x).sum::<f64>() / squares;
    let last = indices.last().copied().unwrap_or(0.0);
    Axis { start: means[1] - means[0] * spacing, spacing, count: 1 + last as usize }
}

/// Whether a position (in m) is one of the lattice, to the rounding of a digit (in m).
fn holds(axis: &Axis, position: f64, digit: f64) -> bool {
    let rounding = (DIGIT * digit / axis.spacing).clamp(ROUNDING, LARGEST_ROUNDING);
    (position - axis.at(axis.nearest(position))).abs() <= rounding * axis.spacing
}

/// A length in mm without the digits that conversion adds.
pub fn rounded(length: f64) -> f64 {
    (length * 1e6).round() / 1e6
}
