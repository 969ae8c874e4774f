//! The power spectral density of a rough surface against the wave number, both on logarithmic axes.

use super::RoughnessReport;
use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::marks::{Heading, short};
use crate::output::figures::panels::{self, Axis, Curve, Panel, Stack};
use crate::output::report::Report;

const HEIGHT: f64 = 420.0;
/// Maximum number of decades of the density shown: below them is rounding error.
const DECADES: f64 = 14.0;

/// The figure; `None` where there is nothing to draw.
pub(super) fn draw(report: &RoughnessReport) -> Option<String> {
    let spectrum = &report.spectrum;
    let pairs = spectrum.wave_numbers.iter().zip(&spectrum.densities);
    let points: Vec<[f64; 2]> = pairs.map(|(q, density)| [q.log10(), density.log10()]).collect();
    let highest = points.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max);
    let is_seen = |point: &&[f64; 2]| point[1] > highest - DECADES && point[0].is_finite();
    let seen: Vec<[f64; 2]> = points.iter().filter(is_seen).copied().collect();
    let [x, y] = ranges(&seen)?;
    let mut curves = Vec::new();
    if let Some(law) = spectrum.power_law() {
        let ends = law.wave_numbers.map(f64::log10);
        let line = through(&seen, ends, -2.0 * (1.0 + law.hurst_exponent));
        let hurst = short((100.0 * law.hurst_exponent).round() / 100.0);
        let text = format!("$C$ ~ $q$^{{\u{2212}2(1+H)}}, $H$ = {hurst}");
        curves.push(Curve::dashed(line.to_vec(), VERMILION, &text));
    }
    curves.insert(0, Curve::solid(seen, BLUE, "mean over all directions"));
    let lattice = report.surface.lattice();
    let longest = lattice.length_x().min(lattice.length_y());
    let conditions = format!(
        "{} x {} cells; waves from {} to {} µm",
        lattice.columns,
        lattice.rows,
        short(longest / 1e-6),
        short(2.0 * lattice.spacing_x.max(lattice.spacing_y) / 1e-6)
    );
    let title = "Power spectral density of the heights";
    let heading = Heading::new(title, &report.title, conditions, report.status());
    let panel = Panel::new("$C$($q$) (m^4)", HEIGHT, curves).with_axis(Axis::Given(y));
    let label = "wave number $q$ = 2π/wavelength (1/m)";
    let stack = Stack { powers: true, ..Stack::over(x, label, vec![panel]) };
    Some(panels::page(&heading, &[stack]))
}

/// Ranges that end at integer powers of ten of the density, and at the ends of the wave numbers.
fn ranges(points: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let (first, last) = (points.first()?[0], points.last()?[0]);
    let low = points.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min).floor();
    let high = points.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max).ceil();
    let margin = 0.02 * (last - first);
    (first < last && low < high).then_some([[first - margin, last + margin], [low, high]])
}

/// The two ends of a line of a given slope (in decades) through the middle of the points between
/// them.
fn through(points: &[[f64; 2]], ends: [f64; 2], slope: f64) -> [[f64; 2]; 2] {
    let inside = points.iter().filter(|point| (ends[0]..=ends[1]).contains(&point[0]));
    // Rings become dense at large wave numbers: each is weighted by its width.
    let mut sums = [0.0; 3];
    for [x, y] in inside {
        let weight = 10_f64.powf(ends[0] - x);
        sums = [sums[0] + weight, sums[1] + weight * x, sums[2] + weight * y];
    }
    let middle = [sums[1] / sums[0], sums[2] / sums[0]];
    ends.map(|x| [x, middle[1] + slope * (x - middle[0])])
}
