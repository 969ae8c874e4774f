//! Flat maps of a rough surface: its heights, and the pressure in the contact spots.

use schlupf::surface::Lattice;

use super::{RoughnessReport, Spots};
use crate::output::figures::color::{ColorScale, Palette};
use crate::output::figures::frame::Frame;
use crate::output::figures::marks::{self, HEADING, Heading, short};
use crate::output::figures::svg::Drawing;
use crate::output::figures::{cells, units};
use crate::output::report::Report;

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
    let scale = ColorScale::linear(Palette::Signed, [-largest, largest]);
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
    let scale = ColorScale::linear(Palette::Mechanical, [0.0, high]);
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
            powers: false,
        };
        let width = (frame.right() + BAR).max(640.0);
        let bar_height = (frame.size[1] - 28.0).max(120.0);
        let height = frame.bottom().max(HEADING + 48.0 + bar_height) + 62.0;
        let mut drawing = Drawing::new(width, height);
        let (about, status) = (self.conditions.clone(), self.report.status());
        Heading::new(self.title, &self.report.title, about, status).draw(&mut drawing);
        drawing.rectangle(frame.corner, frame.size, OPEN);
        draw_cells(&mut drawing, &frame, lattice, (most, level, &self.scale));
        frame.draw_vertical(&mut drawing, &format!("$y$ ({})", unit.symbol));
        frame.draw_horizontal(&mut drawing, &format!("$x$ ({})", unit.symbol));
        let bar = [frame.right() + 30.0, frame.corner[1] + 28.0];
        marks::color_bar(&mut drawing, bar, bar_height, &self.scale, self.label);
        drawing.finish()
    }
}

/// The middle cells of squares of several, where there are many.
fn draw_cells(
    drawing: &mut Drawing,
    frame: &Frame,
    lattice: &Lattice,
    (most, level, scale): (usize, &dyn Fn(usize) -> Option<usize>, &ColorScale),
) {
    let stride = lattice.columns.max(lattice.rows).div_ceil(most);
    let counts = [lattice.columns, lattice.rows];
    let of = |column: usize, row: usize| {
        let middle = |k: usize, count: usize| (k * stride + stride / 2).min(count - 1);
        level(middle(row, lattice.rows) * lattice.columns + middle(column, lattice.columns))
    };
    let step = [0, 1].map(|axis| frame.size[axis] * stride as f64 / counts[axis] as f64);
    drawing.begin_clip(&frame.area());
    let place = ([frame.corner[0], frame.bottom()], step);
    cells::draw(drawing, place, counts.map(|n| n.div_ceil(stride)), (scale.palette, &of));
    drawing.end_group();
}
