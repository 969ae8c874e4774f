//! Flat maps of a rough surface: its heights, and the pressure in the contact spots.

use std::collections::BTreeMap;
use std::fmt::Write;

use schlupf::surface::Lattice;

use super::curves_figure::remark;
use super::{RoughnessReport, Spots};
use crate::output::figures::color::{ColorScale, Palette, paint};
use crate::output::figures::frame::Frame;
use crate::output::figures::marks::{self, HEADING, short};
use crate::output::figures::svg::Drawing;
use crate::output::figures::units;

/// Maximum number of cells along a side in a map of the heights, and in one of the spots: larger
/// surfaces are shown with every second or third cell.
const MOST_HEIGHTS: usize = 256;
const MOST_SPOTS: usize = 520;

const MICROMETRE: f64 = 1e-6;
/// Colour of cells that are not in contact.
const OPEN: &str = r##"fill="#f1f1f1""##;

/// The heights about their mean.
pub(super) fn surface(report: &RoughnessReport) -> String {
    let heights = report.surface.about_its_mean();
    let [low, high] = heights.range().map(|height| height / MICROMETRE);
    let largest = high.max(-low);
    let scale = ColorScale { palette: Palette::Signed, low: -largest, high: largest };
    let conditions = format!(
        "$h$_{{rms}} = {} µm, $h'$_{{rms}} = {}; heights about their mean",
        short(report.result.statistics.root_mean_square_height / MICROMETRE),
        short(report.result.statistics.spectral_gradient)
    );
    let level = |cell: usize| Some(scale.level(heights.heights()[cell] / MICROMETRE));
    let map = Map { report, title: "The surface", conditions, label: "height (µm)", scale };
    map.draw(MOST_HEIGHTS, &level)
}

/// The pressure in the contact.
pub(super) fn spots(report: &RoughnessReport, spots: &Spots) -> String {
    let largest = spots.pressure.iter().copied().fold(0.0, f64::max);
    let high = (largest / 1e9).max(f64::MIN_POSITIVE);
    let scale = ColorScale { palette: Palette::Mechanical, low: 0.0, high };
    // The same fraction as in the summary: that of the cells is larger by half of their perimeter.
    let fraction = report.result.normal.corrected_contact_fraction(spots.mean_pressure);
    let conditions = format!(
        "mean pressure {} MPa: {} % in contact",
        short((spots.mean_pressure / 1e6).round()),
        short((1e4 * fraction).round() / 100.0)
    );
    let level = |cell: usize| {
        let pressure = spots.pressure[cell];
        (pressure > 0.0).then(|| scale.level(pressure / 1e9))
    };
    let title = "Contact spots";
    Map { report, title, conditions, label: "pressure (GPa)", scale }.draw(MOST_SPOTS, &level)
}

struct Map<'a> {
    report: &'a RoughnessReport,
    title: &'a str,
    conditions: String,
    label: &'a str,
    scale: ColorScale,
}

impl Map<'_> {
    /// The map against x and y to the same scale; `level` is the colour of a cell, if it has one.
    fn draw(&self, most: usize, level: &dyn Fn(usize) -> Option<usize>) -> String {
        const LARGEST: [f64; 2] = [560.0, 560.0];
        const LEFT: f64 = 96.0;
        const BAR: f64 = 150.0;
        let lattice = self.report.surface.lattice();
        let lengths = [lattice.length_x(), lattice.length_y()];
        let unit = units::pick(units::ROUGH_LENGTH, 0.5 * lengths[0].max(lengths[1]));
        let spans = lengths.map(|length| length / unit.size);
        let ratio = (LARGEST[0] / spans[0]).min(LARGEST[1] / spans[1]);
        let frame = Frame {
            corner: [LEFT, HEADING + 20.0],
            size: spans.map(|span| span * ratio),
            x: [-0.5 * spans[0], 0.5 * spans[0]],
            y: [-0.5 * spans[1], 0.5 * spans[1]],
        };
        let width = (frame.right() + BAR).max(640.0);
        let bar_height = (frame.size[1] - 28.0).max(120.0);
        let height = frame.bottom().max(HEADING + 48.0 + bar_height) + 62.0;
        let mut drawing = Drawing::new(width, height);
        let lines = [self.report.title.as_str(), self.conditions.as_str()];
        marks::title_block(&mut drawing, self.title, lines, remark(self.report));
        drawing.rectangle(frame.corner, frame.size, OPEN);
        draw_cells(&mut drawing, &frame, lattice, (most, level, &self.scale));
        frame.draw_vertical(&mut drawing, &format!("$y$ ({})", unit.symbol));
        frame.draw_horizontal(&mut drawing, &format!("$x$ ({})", unit.symbol));
        let bar = [frame.right() + 30.0, frame.corner[1] + 28.0];
        marks::color_bar(&mut drawing, bar, bar_height, &self.scale, self.label);
        drawing.finish()
    }
}

/// The cells of each colour as one path; adjacent cells of one colour in a row form one rectangle.
fn draw_cells(
    drawing: &mut Drawing,
    frame: &Frame,
    lattice: &Lattice,
    (most, level, scale): (usize, &dyn Fn(usize) -> Option<usize>, &ColorScale),
) {
    let stride = lattice.columns.max(lattice.rows).div_ceil(most);
    let [columns, rows] = [lattice.columns, lattice.rows].map(|count| count.div_ceil(stride));
    let of = |column: usize, row: usize| {
        let middle = |k: usize, count: usize| (k * stride + stride / 2).min(count - 1);
        level(middle(row, lattice.rows) * lattice.columns + middle(column, lattice.columns))
    };
    let mut paths: BTreeMap<usize, String> = BTreeMap::new();
    for row in 0..rows {
        let mut column = 0;
        while column < columns {
            let Some(here) = of(column, row) else {
                column += 1;
                continue;
            };
            let count = (column..columns).take_while(|&c| of(c, row) == Some(here)).count();
            // Writing to a String cannot fail.
            let _ = write!(paths.entry(here).or_default(), "M{column} {row}h{count}v1h-{count}z");
            column += count;
        }
    }
    let [x, y] = [frame.corner[0], frame.bottom()];
    drawing.begin_clip(&format!(
        r#"<rect x="{x:.2}" y="{:.2}" width="{:.2}" height="{:.2}"/>"#,
        frame.corner[1], frame.size[0], frame.size[1]
    ));
    let step = |size: f64, count: usize| size * stride as f64 / count as f64;
    drawing.begin_group(&format!(
        r#"transform="matrix({:.6} 0 0 {:.6} {x:.4} {y:.4})" shape-rendering="crispEdges""#,
        step(frame.size[0], lattice.columns),
        -step(frame.size[1], lattice.rows),
    ));
    for (level, path) in paths {
        drawing.path(&path, &format!(r#"fill="{}""#, paint(scale.palette, level)));
    }
    drawing.end_group();
    drawing.end_group();
}
