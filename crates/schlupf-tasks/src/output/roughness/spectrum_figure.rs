//! The power spectral density of a rough surface against the wave number, both on logarithmic axes.

use super::RoughnessReport;
use super::curves_figure::remark;
use crate::output::figures::color::{BLUE, VERMILION};
use crate::output::figures::frame::{Frame, LABEL_SIZE, TICK_SIZE, outline, tick_line};
use crate::output::figures::label::{Anchor, TextStyle};
use crate::output::figures::marks::{self, Entry, HEADING, Sample, short};
use crate::output::figures::panels::WIDTH;
use crate::output::figures::svg::{Drawing, GRID_LINE};
use crate::output::figures::ticks::power_of_ten;

const CORNER: [f64; 2] = [104.0, HEADING + 36.0];
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
    let frame = frame(&seen)?;
    let mut drawing = Drawing::new(WIDTH, CORNER[1] + HEIGHT + 66.0);
    heading(&mut drawing, report);
    draw_axes(&mut drawing, &frame);
    let at: Vec<[f64; 2]> = seen.iter().map(|point| frame.at(*point)).collect();
    let stroke = format!(r#"stroke="{BLUE}" stroke-width="1.8" stroke-linejoin="round""#);
    drawing.polyline(&at, &stroke);
    let mut entries = vec![entry(&stroke, "mean over all directions")];
    if let Some(law) = spectrum.power_law() {
        let stroke = format!(r#"stroke="{VERMILION}" stroke-width="1.8" stroke-dasharray="7 4""#);
        let ends = law.wave_numbers.map(f64::log10);
        let exponent = -2.0 * (1.0 + law.hurst_exponent);
        let line = through(&seen, ends, exponent);
        drawing.polyline(&line.map(|point| frame.at(point)), &stroke);
        let hurst = short((100.0 * law.hurst_exponent).round() / 100.0);
        entries.push(entry(&stroke, &format!("$C$ ~ $q$^{{\u{2212}2(1+H)}}, $H$ = {hurst}")));
    }
    drawing.rectangle(frame.corner, frame.size, &outline());
    marks::legend(&mut drawing, [CORNER[0], CORNER[1] - 10.0], frame.size[0], &entries);
    Some(drawing.finish())
}

fn entry(stroke: &str, text: &str) -> Entry {
    Entry { sample: Sample::Line(vec![stroke.to_owned()]), text: text.to_owned() }
}

fn heading(drawing: &mut Drawing, report: &RoughnessReport) {
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
    marks::title_block(drawing, title, [&report.title, &conditions], remark(report));
}

/// A frame that ends at integer powers of ten of the density, and at the ends of the wave numbers.
fn frame(points: &[[f64; 2]]) -> Option<Frame> {
    let (first, last) = (points.first()?[0], points.last()?[0]);
    let low = points.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min).floor();
    let high = points.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max).ceil();
    let is_range = first < last && low < high;
    let margin = 0.02 * (last - first);
    is_range.then_some(Frame {
        corner: CORNER,
        size: [WIDTH - CORNER[0] - 30.0, HEIGHT],
        x: [first - margin, last + margin],
        y: [low, high],
    })
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

/// Ticks at powers of ten, and small ones between those of the wave number.
fn draw_axes(drawing: &mut Drawing, frame: &Frame) {
    let whole = |[low, high]: [f64; 2]| (low.ceil() as i32..=high.floor() as i32).map(f64::from);
    for x in whole(frame.x) {
        let at = frame.at([x, frame.y[0]]);
        drawing.line([at[0], frame.corner[1]], at, GRID_LINE);
        drawing.line(at, [at[0], at[1] + 6.0], &tick_line());
        let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
        drawing.text([at[0], at[1] + 11.0 + TICK_SIZE], &style, &power_of_ten(x));
    }
    for x in whole([frame.x[0] - 1.0, frame.x[1]])
        .flat_map(|x| (2..10).map(move |k| x + f64::from(k).log10()))
    {
        if x > frame.x[0] && x < frame.x[1] {
            let at = frame.at([x, frame.y[0]]);
            drawing.line(at, [at[0], at[1] + 3.0], &tick_line());
        }
    }
    let step = ((frame.y[1] - frame.y[0]) / 8.0).ceil().max(1.0);
    for y in whole(frame.y).filter(|y| (y / step).fract() == 0.0) {
        let at = frame.at([frame.x[0], y]);
        drawing.line(at, [frame.right(), at[1]], GRID_LINE);
        drawing.line(at, [at[0] - 5.0, at[1]], &tick_line());
        let style = TextStyle::new(TICK_SIZE, Anchor::End);
        drawing.text([at[0] - 9.0, at[1] + 0.36 * TICK_SIZE], &style, &power_of_ten(y));
    }
    let style = TextStyle::new(LABEL_SIZE, Anchor::Middle);
    let middle = [frame.corner[0] + 0.5 * frame.size[0], frame.bottom() + 50.0];
    drawing.text(middle, &style, "wave number $q$ = 2π/wavelength (1/m)");
    let style = TextStyle { rotation: -90.0, ..style };
    let middle = [frame.corner[0] - 66.0, frame.corner[1] + 0.5 * frame.size[1]];
    drawing.text(middle, &style, "$C$($q$) (m^4)");
}
