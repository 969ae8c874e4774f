//! Flat maps of the patch: colours, arrows, the stick–slip boundary.

use super::cells;
use super::chain::Chain;
use super::color::ColorScale;
use super::contour::{outline, stick_border, sticking};
use super::frame::Frame;
use super::marks::{self, Entry, HEADING, Heading, Sample};
use super::patch::Patch;
use super::quantity::Quantity;
use super::sampler::Sampler;
use super::svg::{Drawing, open_path};

/// Vectors drawn as arrows.
#[derive(Debug)]
pub(crate) struct Arrows {
    /// Component along rolling in every contact cell, in any unit.
    pub x: Vec<f64>,
    /// Component across rolling.
    pub y: Vec<f64>,
    /// Whether they vanish at the rim, as in [`Quantity`].
    pub vanish_at_rim: bool,
    /// Description in the legend.
    pub text: &'static str,
}

const MILLIMETRE: f64 = 1e-3;
const ARROW: &str = r##"fill="#000000" stroke="#ffffff" stroke-width="0.8""##;
const RIM: &str = r##"fill="none" stroke="#222222" stroke-width="1.3""##;
const BORDER: [&str; 2] = [
    r##"fill="none" stroke="#000000" stroke-width="4.4" stroke-linecap="round""##,
    r##"fill="none" stroke="#ffffff" stroke-width="2.2" stroke-linecap="round""##,
];

/// White lines over the part that sticks.
const HATCHING: &str = r##"<pattern id="stick" width="9" height="9" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path d="M0 4.5H9" stroke="#ffffff" stroke-width="1.3" stroke-opacity="0.75"/></pattern>"##;
const HATCHED: &str = r#"fill="url(#stick)""#;
/// The same in the legend, on a background.
const HATCHED_SAMPLE: [&str; 2] =
    [r##"stroke="#7d7d7d" stroke-width="13""##, r#"stroke="url(#stick)" stroke-width="13""#];

/// The map of a quantity over x and y in mm, both to the same scale.
pub(crate) fn draw(patch: &Patch, quantity: &Quantity, arrows: Option<&Arrows>) -> String {
    let layout = Layout::new(patch);
    let mut drawing = Drawing::new(layout.width, layout.height);
    Heading::of(patch, &quantity.title).draw(&mut drawing);
    let frame = &layout.frame;
    frame.draw_grid(&mut drawing);
    let scale = quantity.colors(quantity.range());
    begin_patch_clip(&mut drawing, patch, frame);
    draw_cells(&mut drawing, frame, patch, (quantity, &scale));
    drawing.end_group();
    draw_rim(&mut drawing, patch, frame);
    let mut border = stick_border(patch);
    border.retain(|chain| chain.points.iter().any(|point| patch.contains(*point)));
    drawing.shape(HATCHING);
    begin_patch_clip(&mut drawing, patch, frame);
    drawing.path(&polygons_path(frame, &sticking(patch)), HATCHED);
    for stroke in BORDER {
        drawing.path(&chains_path(frame, &border), stroke);
    }
    drawing.end_group();
    if let Some(arrows) = arrows {
        draw_arrows(&mut drawing, patch, frame, arrows);
    }
    if patch.is_rolling() {
        let center = [frame.corner[0] + 0.5 * frame.size[0], HEADING + 14.0];
        marks::rolling_direction(&mut drawing, center);
    }
    frame.draw_vertical(&mut drawing, "$y$ (mm)");
    frame.draw_horizontal(&mut drawing, "$x$ (mm)");
    marks::color_bar(&mut drawing, layout.bar, layout.bar_height, &scale, &quantity.label);
    marks::legend(&mut drawing, layout.legend, layout.width - 48.0, &entries(&border, arrows));
    drawing.finish()
}

struct Layout {
    width: f64,
    height: f64,
    frame: Frame,
    bar: [f64; 2],
    bar_height: f64,
    legend: [f64; 2],
}

impl Layout {
    /// The plot as large as its proportions allow, with the colour bar to its right and the legend
    /// below.
    fn new(patch: &Patch) -> Self {
        const LARGEST: [f64; 2] = [600.0, 520.0];
        const LEAST_HEIGHT: f64 = 200.0;
        /// A narrower patch may be longer, so that arrows fit, up to a factor.
        const NARROWEST: f64 = 100.0;
        const LONGER: f64 = 1.7;
        const BAR: f64 = 150.0;
        let ranges = ranges(patch).map(|range| range.map(|end| end / MILLIMETRE));
        let spans = ranges.map(|[low, high]| high - low);
        let scale = (LARGEST[0] / spans[0]).min(LARGEST[1] / spans[1]);
        let narrow = spans[0].min(spans[1]) * scale;
        let scale = scale * (NARROWEST / narrow).clamp(1.0, LONGER);
        let size = spans.map(|span| span * scale);
        let width = (84.0 + size[0] + BAR).max(640.0);
        let left = 84.0 + 0.5 * (width - 84.0 - size[0] - BAR);
        let area = size[1].max(LEAST_HEIGHT);
        let top = HEADING + 36.0;
        let frame = Frame {
            corner: [left, top + 0.5 * (area - size[1])],
            size,
            x: ranges[0],
            y: ranges[1],
            powers: false,
        };
        let bar_height = area - 28.0;
        let below = frame.bottom().max(top + area - 40.0) + 78.0;
        Self {
            width,
            height: below + 34.0,
            bar: [frame.right() + 30.0, top + 28.0],
            bar_height,
            legend: [24.0, below],
            frame,
        }
    }
}

/// Extent of the map, in m: the patch and a margin.
fn ranges(patch: &Patch) -> [[f64; 2]; 2] {
    let grid = &patch.fields().grid;
    if patch.elliptic {
        return patch.semi_axes().map(|axis| [-1.08 * axis, 1.08 * axis]);
    }
    [
        [grid.edge_x(0), grid.edge_x(grid.columns)],
        [grid.edge_y(0) - grid.spacing_y, grid.edge_y(grid.rows) + grid.spacing_y],
    ]
}

/// A contact cell beside a place without one: the smooth rim may pass through its corner.
fn neighbour(patch: &Patch, column: usize, row: usize) -> Option<usize> {
    let before = |index: usize| index.checked_sub(1);
    (before(column).and_then(|column| patch.cell(column, row)))
        .or_else(|| patch.cell(column + 1, row))
        .or_else(|| patch.cell(column, before(row)?))
        .or_else(|| patch.cell(column, row + 1))
}

fn draw_cells(
    drawing: &mut Drawing,
    frame: &Frame,
    patch: &Patch,
    (quantity, scale): (&Quantity, &ColorScale),
) {
    let fields = patch.fields();
    let grid = &fields.grid;
    let level = |column: usize, row: usize| {
        let cell = patch.cell(column, row).or_else(|| neighbour(patch, column, row))?;
        let value = quantity.values[cell];
        // The patch is clipped at its rim, so its cells show the mean over the part that remains.
        let partial = quantity.vanishes_at_rim && fields.covered[cell] > 0.0;
        Some(scale.level(if partial { value / fields.covered[cell] } else { value }))
    };
    let origin = frame.at([grid.origin_x / MILLIMETRE, grid.origin_y / MILLIMETRE]);
    let [x, y] = frame.scale().map(|scale| scale / MILLIMETRE);
    let place = (origin, [grid.spacing_x * x, grid.spacing_y * y]);
    cells::draw(drawing, place, [grid.columns, grid.rows], (scale.palette, &level));
}

/// Clips to the patch: its ellipse, or what its cells cover.
fn begin_patch_clip(drawing: &mut Drawing, patch: &Patch, frame: &Frame) {
    if patch.elliptic {
        drawing.begin_clip(&ellipse(patch, frame, ""));
        return;
    }
    let path = chains_path(frame, &outline(patch));
    drawing.begin_clip(&format!(r#"<path d="{path}" clip-rule="evenodd"/>"#));
}

fn ellipse(patch: &Patch, frame: &Frame, style: &str) -> String {
    let [x, y] = frame.at([0.0, 0.0]);
    let [a, b] = patch.semi_axes();
    let [rx, ry] = [a / MILLIMETRE * frame.scale()[0], b / MILLIMETRE * frame.scale()[1]];
    format!(r#"<ellipse cx="{x:.2}" cy="{y:.2}" rx="{rx:.2}" ry="{ry:.2}" {style}/>"#)
}

fn draw_rim(drawing: &mut Drawing, patch: &Patch, frame: &Frame) {
    if patch.elliptic {
        drawing.shape(&ellipse(patch, frame, RIM));
    } else {
        drawing.path(&chains_path(frame, &outline(patch)), RIM);
    }
}

fn chains_path(frame: &Frame, chains: &[Chain]) -> String {
    let end = |chain: &Chain| if chain.is_closed { "z" } else { "" };
    chains.iter().map(|chain| path(frame, &chain.points) + end(chain)).collect()
}

fn polygons_path(frame: &Frame, polygons: &[Vec<[f64; 2]>]) -> String {
    polygons.iter().map(|polygon| path(frame, polygon) + "z").collect()
}

/// A line through points in m.
fn path(frame: &Frame, points: &[[f64; 2]]) -> String {
    let place = |point: &[f64; 2]| frame.at(point.map(|coordinate| coordinate / MILLIMETRE));
    open_path(&points.iter().map(place).collect::<Vec<_>>())
}

/// Arrows on a lattice about the centre, the longest almost as long as their spacing, which is
/// smaller where the patch is slender. Those that would touch the rim are omitted.
fn draw_arrows(drawing: &mut Drawing, patch: &Patch, frame: &Frame, arrows: &Arrows) {
    const SPACINGS: [f64; 2] = [20.0, 36.0];
    const ACROSS: f64 = 3.4;
    /// Half the length of the longest arrow over the spacing; what must be inside the patch.
    const HALF: f64 = 0.45;
    const CLEAR: f64 = 0.55;
    let narrow = frame.size[0].min(frame.size[1]);
    let spacing = (narrow / ACROSS).clamp(SPACINGS[0], SPACINGS[1]);
    let largest = arrows.x.iter().zip(&arrows.y).map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    if !(largest.is_finite() && largest > 0.0) {
        return;
    }
    let [a, b] = patch.semi_axes();
    let [x, y] = [&arrows.x, &arrows.y].map(|v| Sampler::new(patch, v, arrows.vanish_at_rim));
    let steps = |axis: usize| {
        let half = (0.5 * frame.size[axis] / spacing) as i32;
        let step = spacing / frame.scale()[axis] * MILLIMETRE;
        let middle = 0.5 * (ranges(patch)[axis][0] + ranges(patch)[axis][1]);
        (-half..=half).map(move |index| middle + f64::from(index) * step)
    };
    let mut path = String::new();
    for place in steps(1).flat_map(|y| steps(0).map(move |x| [x, y])) {
        let normalised = [place[0] / a, place[1] / b];
        let vector = [x.value(normalised) / largest, y.value(normalised) / largest];
        if vector[0].hypot(vector[1]) < 0.08 {
            continue;
        }
        let along = |share: f64| {
            let shift = |i: usize| share * spacing * vector[i] / frame.scale()[i] * MILLIMETRE;
            [place[0] + shift(0), place[1] + shift(1)]
        };
        if [-CLEAR, CLEAR].into_iter().all(|share| patch.contains(along(share))) {
            let [tail, tip] =
                [-HALF, HALF].map(|share| frame.at(along(share).map(|c| c / MILLIMETRE)));
            path += &marks::arrow(tail, tip, 0.25 * spacing);
        }
    }
    drawing.path(&path, ARROW);
}

fn entries(border: &[Chain], arrows: Option<&Arrows>) -> Vec<Entry> {
    let mut entries = vec![Entry::line(RIM, "contact")];
    if !border.is_empty() {
        let mut entry = |strokes: [&str; 2], text: &str| {
            let sample = Sample::Line(strokes.map(str::to_owned).to_vec());
            entries.push(Entry { sample, text: text.to_owned() });
        };
        entry(HATCHED_SAMPLE, "stick");
        entry(BORDER, "stick–slip boundary");
    }
    if let Some(arrows) = arrows {
        entries
            .push(Entry { sample: Sample::Arrow(ARROW.to_owned()), text: arrows.text.to_owned() });
    }
    entries
}
