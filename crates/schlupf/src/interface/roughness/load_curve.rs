//! Approach of two rough bodies as a function of load, d(P).

use crate::normal::rough_contact::{RoughContact, RoughContactOptions, RoughContactSolution};
use crate::numerics::interpolation::{hermite, hermite_slope};
use crate::numerics::vector::dot;
use crate::reporting::{
    Column, Error, Progress, Quantity, Record, Stage, SurfaceError, Watch, columns,
    require_positive, within,
};

/// A rough contact at one load. Everything is per unit nominal area.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LoadPoint {
    /// Mean pressure over the nominal area, in Pa.
    pub mean_pressure: f64,
    /// Approach since first contact, in m.
    pub approach: f64,
    /// Mean gap, in m.
    pub mean_gap: f64,
    /// Ratio of real to nominal contact area, dimensionless.
    pub contact_fraction: f64,
    /// The same with perimeter correction, dimensionless (Yastrebov et al. 2017).
    pub corrected_contact_fraction: f64,
    /// Largest pressure in a spot, in Pa.
    pub spot_pressure: f64,
    /// Fraction of the nominal area that yielded when this load was first applied, dimensionless.
    pub plastic_fraction: f64,
    /// Whether the solution converged.
    pub is_converged: bool,
    /// Iterations of the solution.
    pub iterations: usize,
}

/// The loads at which to solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadCurveOptions {
    /// Ratio of the largest to the smallest mean pressure, dimensionless.
    pub range: f64,
    /// Ratio of two neighbouring pressures, dimensionless.
    pub ratio: f64,
    /// Options for each load.
    pub contact: RoughContactOptions,
}

impl Default for LoadCurveOptions {
    /// Three decades with eight points each.
    fn default() -> Self {
        Self { range: 1e3, ratio: 10_f64.powf(0.125), contact: RoughContactOptions::default() }
    }
}

impl LoadCurveOptions {
    /// Number of steps from the largest to the smallest pressure.
    pub fn steps(&self) -> usize {
        (self.range.ln() / self.ratio.ln()).ceil().max(2.0) as usize
    }
}

/// The approach as a function of load, with its points in order of increasing pressure.
///
/// Between its points it is a monotonic cubic in ln p (Fritsch and Carlson 1980); below the first
/// one d ∝ p^(2/3), as for a single summit in Hertz contact.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCurve {
    points: Vec<LoadPoint>,
    /// dd/d ln p at the points.
    slopes: Vec<f64>,
}

/// The range in which the load grows exponentially with the approach, p ∝ exp(d/ℓ).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct ExponentialRange {
    /// Length ℓ = γ h_rms over which the load grows by a factor of e, in m.
    pub length: f64,
    /// Smallest and largest mean pressure of the range, in Pa.
    pub mean_pressure: [f64; 2],
    /// Root mean square deviation of ln p from the straight line, dimensionless.
    pub deviation: f64,
}

/// Range of the ratio of real to nominal contact area, dimensionless, in which the load is
/// exponential: below, a few summits dominate; above, the valleys close.
pub const EXPONENTIAL_RANGE: [f64; 2] = [0.01, 0.2];

impl LoadCurve {
    /// Solves the contact from the largest mean pressure (in Pa) downwards.
    ///
    /// Bodies that yield have previously carried the largest pressure: the points are those of the
    /// flattened surfaces, which are elastic from then on.
    pub fn compute(
        contact: &mut RoughContact,
        largest: f64,
        options: &LoadCurveOptions,
        watch: Watch,
    ) -> Result<Self, Error> {
        require_positive(Quantity::MeanPressure, largest)?;
        let steps = options.steps();
        let lattice = *contact.distance().lattice();
        let area = lattice.area();
        let hardness = contact.hardness();
        let mut flattened = None;
        let mut first = None;
        if contact.hardness().is_finite() {
            let solution = contact.press(largest, &options.contact, watch)?;
            flattened = Some(contact.flattened(&solution)?);
            first = Some(solution);
        }
        let contact = flattened.as_mut().unwrap_or(contact);
        let mut points = Vec::with_capacity(steps + 1);
        for step in 0..=steps {
            let pressure = largest * options.range.powf(-(step as f64) / steps as f64);
            let done = Progress::count(Stage::LoadCurve, step);
            let watch = within(watch, Progress { total: Some(steps + 1), ..done });
            let solution = contact.press(pressure, &options.contact, &watch)?;
            let mut point = LoadPoint::of(&solution, area);
            // The perimeter is corrected as for round spots, which overcorrects flat ones.
            let least = point.mean_pressure / hardness;
            point.corrected_contact_fraction = point.corrected_contact_fraction.max(least);
            if let Some(first) = first.take() {
                point.plastic_fraction = first.plastic_area / area;
                let least = point.plastic_fraction;
                point.corrected_contact_fraction = point.corrected_contact_fraction.max(least);
                point.is_converged &= first.is_converged;
                point.iterations += first.iterations;
            }
            points.push(point);
        }
        points.reverse();
        if points[points.len() - 1].contact_fraction > CLOSED {
            return Err(all_in_contact(&points, hardness, 2.0 * lattice.spacing_x));
        }
        Self::new(points)
    }

    /// A curve from points of a computation or a measurement: at least three, with increasing
    /// pressure and approach.
    pub fn new(points: Vec<LoadPoint>) -> Result<Self, Error> {
        let grows = |pair: &[LoadPoint]| {
            pair[1].mean_pressure > pair[0].mean_pressure && pair[1].approach > pair[0].approach
        };
        let is_positive = points.first().is_some_and(|p| p.mean_pressure > 0.0 && p.approach > 0.0);
        if points.len() < 3 || !is_positive || !points.windows(2).all(grows) {
            return Err(SurfaceError::LoadCurve { points: points.len() }.into());
        }
        let slopes = slopes(&points);
        Ok(Self { points, slopes })
    }

    /// Points in order of increasing pressure.
    pub fn points(&self) -> &[LoadPoint] {
        &self.points
    }

    /// Whether all points converged.
    pub fn is_converged(&self) -> bool {
        self.points.iter().all(|point| point.is_converged)
    }

    /// Largest mean pressure, in Pa.
    pub fn largest_pressure(&self) -> f64 {
        self.points.last().map_or(0.0, |point| point.mean_pressure)
    }

    /// Smallest solved mean pressure, in Pa.
    pub fn smallest_pressure(&self) -> f64 {
        self.points.first().map_or(0.0, |point| point.mean_pressure)
    }

    /// Mean pressure in the spots under a mean pressure, both in Pa.
    pub fn mean_spot_pressure(&self, mean_pressure: f64) -> f64 {
        mean_pressure / self.corrected_contact_fraction(mean_pressure)
    }

    /// Approach (in m) under a mean pressure (in Pa), and its derivative dd/d ln p (in m).
    pub fn approach(&self, mean_pressure: f64) -> [f64; 2] {
        let Some((below, width, t)) = self.interval(mean_pressure) else {
            let first = &self.points[0];
            let approach =
                first.approach * (mean_pressure / first.mean_pressure).powf(HERTZ_EXPONENT);
            return [approach, HERTZ_EXPONENT * approach];
        };
        let [low, high] = [below, below + 1].map(|k| self.points[k].approach);
        let [from, to] = [below, below + 1].map(|k| self.slopes[k] * width);
        let cubic = |weights: [f64; 4]| dot(&weights, &[low, high, from, to]);
        [cubic(hermite(t)), cubic(hermite_slope(t)) / width]
    }

    /// The interval that contains a mean pressure (in Pa): its lower point, its width in ln p, and
    /// the fraction from the lower point, both dimensionless. Beyond the last point the last
    /// interval is extended; `None` before the first.
    fn interval(&self, mean_pressure: f64) -> Option<(usize, f64, f64)> {
        let above = self.points.partition_point(|point| point.mean_pressure < mean_pressure);
        let above = above.min(self.points.len() - 1);
        let low = self.points[above.checked_sub(1)?].mean_pressure;
        let width = (self.points[above].mean_pressure / low).ln();
        Some((above - 1, width, (mean_pressure / low).ln() / width))
    }

    /// Ratio of real to nominal contact area (dimensionless) under a mean pressure (in Pa), by
    /// power laws between the points.
    pub fn contact_fraction(&self, mean_pressure: f64) -> f64 {
        let fraction = |point: &LoadPoint| point.contact_fraction;
        let Some((below, _, t)) = self.interval(mean_pressure) else {
            let first = &self.points[0];
            return fraction(first) * (mean_pressure / first.mean_pressure).powf(HERTZ_EXPONENT);
        };
        let [low, high] = [below, below + 1].map(|k| fraction(&self.points[k]));
        low * (high / low).powf(t)
    }

    /// The same with perimeter correction, dimensionless: the correction changes slowly, so that of
    /// the next point is used.
    pub fn corrected_contact_fraction(&self, mean_pressure: f64) -> f64 {
        let next = self.points.iter().find(|point| point.mean_pressure >= mean_pressure);
        let correction = next
            .or(self.points.last())
            .map_or(1.0, |point| point.corrected_contact_fraction / point.contact_fraction);
        correction * self.contact_fraction(mean_pressure)
    }

    /// The straight line ln p over d that fits best in [`EXPONENTIAL_RANGE`]; `None` with fewer
    /// than three points in it.
    pub fn exponential_range(&self) -> Option<ExponentialRange> {
        let [least, most] = EXPONENTIAL_RANGE;
        let is_in = |point: &&LoadPoint| (least..=most).contains(&point.contact_fraction);
        let points: Vec<&LoadPoint> = self.points.iter().filter(is_in).collect();
        let (first, last) = (points.first()?, points.last()?);
        if points.len() < 3 {
            return None;
        }
        let count = points.len() as f64;
        let mean = |value: &dyn Fn(&LoadPoint) -> f64| {
            points.iter().map(|point| value(point)).sum::<f64>() / count
        };
        let log = |point: &LoadPoint| point.mean_pressure.ln();
        let (middle, level) = (mean(&|point| point.approach), mean(&log));
        let square = mean(&|point| (point.approach - middle).powi(2));
        let product = mean(&|point| (point.approach - middle) * (log(point) - level));
        let slope = product / square;
        let deviation =
            mean(&|point| (log(point) - level - slope * (point.approach - middle)).powi(2)).sqrt();
        Some(ExponentialRange {
            length: slope.recip(),
            mean_pressure: [first.mean_pressure, last.mean_pressure],
            deviation,
        })
    }
}

/// Contact fraction above which there are no valleys left for the load to close, dimensionless.
const CLOSED: f64 = 0.999;

fn all_in_contact(points: &[LoadPoint], hardness: f64, shortest: f64) -> Error {
    let is_closed = |point: &&LoadPoint| point.contact_fraction > CLOSED;
    let first = points.iter().find(is_closed).map_or(0.0, |point| point.mean_pressure);
    let largest = points.last().map_or(0.0, |point| point.mean_pressure);
    SurfaceError::FullContact { pressure: first, largest, hardness, shortest }.into()
}

/// d ∝ p^(2/3) and A ∝ p^(2/3) (Hertz 1882).
const HERTZ_EXPONENT: f64 = 2.0 / 3.0;

/// Derivatives dd/d ln p at the points: that of the parabola through three of them, limited so that
/// the cubics are monotonic. At the first point that of Hertz contact.
fn slopes(points: &[LoadPoint]) -> Vec<f64> {
    let widths: Vec<f64> =
        points.windows(2).map(|p| (p[1].mean_pressure / p[0].mean_pressure).ln()).collect();
    let secants: Vec<f64> = points
        .windows(2)
        .zip(&widths)
        .map(|(p, width)| (p[1].approach - p[0].approach) / width)
        .collect();
    let last = points.len() - 1;
    let slope = |k: usize| {
        if k == 0 {
            return (HERTZ_EXPONENT * points[0].approach).min(3.0 * secants[0]);
        }
        if k == last {
            let bend =
                (secants[last - 1] - secants[last - 2]) / (widths[last - 1] + widths[last - 2]);
            let end = secants[last - 1] + bend * widths[last - 1];
            return end.clamp(0.0, 3.0 * secants[last - 1]);
        }
        let mean =
            (widths[k] * secants[k - 1] + widths[k - 1] * secants[k]) / (widths[k - 1] + widths[k]);
        mean.min(3.0 * secants[k - 1].min(secants[k]))
    };
    (0..=last).map(slope).collect()
}

impl LoadPoint {
    /// The point of a solution over a nominal area, in m².
    fn of(solution: &RoughContactSolution, area: f64) -> Self {
        Self {
            mean_pressure: solution.load / area,
            approach: solution.approach,
            mean_gap: solution.mean_gap,
            contact_fraction: solution.contact_area / area,
            corrected_contact_fraction: solution.corrected_contact_area / area,
            spot_pressure: solution.pressure.iter().copied().fold(0.0, f64::max),
            plastic_fraction: solution.plastic_area / area,
            is_converged: solution.is_converged,
            iterations: solution.iterations,
        }
    }
}

/// Loads on a rough surface.
impl Record for LoadCurve {
    fn rows(&self) -> usize {
        self.points().len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { LoadCurve:
        MeanPressure => |curve, k| curve.points()[k].mean_pressure,
        Approach => |curve, k| curve.points()[k].approach,
        MeanGap => |curve, k| curve.points()[k].mean_gap,
        ContactFraction => |curve, k| curve.points()[k].contact_fraction,
        CorrectedContactFraction => |curve, k| curve.points()[k].corrected_contact_fraction,
        SpotPressure => |curve, k| curve.points()[k].spot_pressure,
        PlasticFraction => |curve, k| curve.points()[k].plastic_fraction,
        Iterations => |curve, k| curve.points()[k].iterations,
    };
}

/// As its points.
#[cfg(feature = "serde")]
impl serde::Serialize for LoadCurve {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.points().serialize(serializer)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Points of a curve d(p), with contact fractions between 0.1 % and 100 %.
    pub(super) fn points(approach: impl Fn(f64) -> f64) -> Vec<LoadPoint> {
        let pressures = (0..=24).map(|k| 1e9 * 10_f64.powf(f64::from(k - 24) / 8.0));
        let point = |mean_pressure: f64| LoadPoint {
            mean_pressure,
            approach: approach(mean_pressure),
            mean_gap: 1e-6 - approach(mean_pressure),
            contact_fraction: 0.3 * mean_pressure / 1e9,
            corrected_contact_fraction: 0.3 * mean_pressure / 1e9,
            spot_pressure: 1e10,
            plastic_fraction: 0.0,
            is_converged: true,
            iterations: 1,
        };
        pressures.map(point).collect()
    }

    /// Hertz 1882: the interpolation keeps d ∝ p^(2/3) between the points and below them.
    #[test]
    fn hertz_1882_between_the_points() {
        let hertz = |p: f64| 1e-6 * (p / 1e9).powf(2.0 / 3.0);
        let curve = LoadCurve::new(points(hertz)).unwrap();
        for p in [1e3, 0.9e6, 1.01e6, 3.3e7, 7.7e8, 0.99e9, 1e9] {
            let [approach, slope] = curve.approach(p);
            assert_relative_eq!(approach, hertz(p), max_relative = 1e-3);
            assert_relative_eq!(slope, 2.0 / 3.0 * hertz(p), max_relative = 2e-2);
        }
        assert_eq!(curve.approach(0.0), [0.0, 0.0]);
        assert_relative_eq!(curve.contact_fraction(1e8), 0.03, max_relative = 1e-12);
    }

    /// An exponential is identified with its length, from 1 to 20 % of contact.
    #[test]
    fn an_exponential_has_its_length() {
        let curve = LoadCurve::new(points(|p| 3e-7 * (p / 1e5).ln())).unwrap();
        let range = curve.exponential_range().unwrap();
        assert_relative_eq!(range.length, 3e-7, max_relative = 1e-9);
        assert!(range.deviation < 1e-9 && range.mean_pressure[0] > 3e7);
        assert!(range.mean_pressure[1] < 0.67e9);
    }

    #[test]
    fn a_curve_that_does_not_grow_is_refused() {
        let message = LoadCurve::new(points(|_| 1e-6)).unwrap_err().to_string();
        assert!(message.contains("must be positive and increase"), "{message}");
        let few = points(|p| p)[..2].to_vec();
        assert!(LoadCurve::new(few).is_err());
    }
}
