//! Fields as surfaces over the patch, as in Figures 4 to 7 of Neuhaus and Sextro (2014).

use std::f64::consts::TAU;

use super::color::{ColorScale, INK};
use super::frame::{LABEL_SIZE, TICK_SIZE, tick_line};
use super::label::{Anchor, TextStyle};
use super::marks::{self, HEADING, Heading};
use super::mesh::{self, Facet};
use super::patch::Patch;
use super::projection::Projection;
use super::quantity::Quantity;
use super::sampler::Sampler;
use super::svg::{Drawing, GRID_LINE, open_path};
use super::ticks::{Tick, round_axis, round_ticks};

const SIZE: [f64; 2] = [900.0, 740.0];

/// The surface of a quantity over x* = x/a and y* = y/b.
pub(crate) fn draw(patch: &Patch, quantity: &Quantity) -> String {
    let mut drawing = Drawing::new(SIZE[0], SIZE[1]);
    Heading::of(patch, &quantity.title).draw(&mut drawing);
    let base = quantity.base;
    let values = patch.smoothed(&quantity.values, quantity.vanishes_at_rim);
    let sampler = Sampler::new(patch, &values, quantity.vanishes_at_rim).above(base);
    let facets = mesh::facets(patch, &sampler, base);
    let heights = || facets.iter().flat_map(|facet| &facet.corners).map(|corner| corner[2]);
    let [low, high]: [f64; 2] = [heights().fold(base, f64::min), heights().fold(base, f64::max)];
    // A few stray values of the other sign do not move the floor of the box.
    let least = 0.05 * (high - base).max(base - low);
    let range = [
        if low > base - least { base } else { low },
        if high < base + least { base } else { high },
    ];
    let [x, y] = mesh::extent(patch);
    let (z, z_ticks) = round_axis(range[0], range[1], 5);
    let projection = Projection { ranges: [x, y, z], center: [402.0, 478.0], scale: 230.0 };
    let scale = quantity.colors(range);
    draw_box(&mut drawing, &projection, &z_ticks);
    draw_floor_axes(&mut drawing, &projection, patch.is_rolling());
    draw_upright(&mut drawing, &projection, &z_ticks, &quantity.label);
    if patch.elliptic {
        draw_rim(&mut drawing, &projection, base);
    }
    draw_facets(&mut drawing, &projection, facets, (&scale, base));
    marks::color_bar(&mut drawing, [792.0, HEADING + 60.0], 340.0, &scale, &quantity.label);
    drawing.finish()
}

/// Far facets first, so that near ones cover them.
fn draw_facets(
    drawing: &mut Drawing,
    projection: &Projection,
    mut facets: Vec<Facet>,
    (scale, base): (&ColorScale, f64),
) {
    let least_wall = 0.004 * (projection.ranges[2][1] - projection.ranges[2][0]);
    facets.retain(|facet| !facet.wall || (facet.value() - base).abs() > least_wall);
    facets
        .sort_by(|p, q| projection.distance(q.place()).total_cmp(&projection.distance(p.place())));
    drawing.begin_group(r##"stroke="#000000" stroke-opacity="0.45" stroke-width="0.5""##);
    for facet in facets {
        let corners: Vec<[f64; 2]> = facet.corners.iter().map(|c| projection.at(*c)).collect();
        let color = scale.paint(facet.value());
        // Walls are too narrow to be inflated about their centre.
        let stroke = if facet.wall { &color } else { "none" };
        let style = format!(r#"fill="{color}" stroke="{stroke}" stroke-opacity="1""#);
        drawing.polygon(&inflated(&corners), &style);
        let lines: String =
            facet.edges.iter().map(|edge| open_path(&edge.map(|c| projection.at(c)))).collect();
        drawing.path(&lines, r#"fill="none""#);
    }
    drawing.end_group();
}

/// A polygon slightly enlarged, so that no gap shows between two of them.
fn inflated(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    const OVERLAP: f64 = 0.7;
    let count = corners.len().max(1) as f64;
    let middle = [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / count);
    let outwards = |corner: &[f64; 2]| {
        let offset = [corner[0] - middle[0], corner[1] - middle[1]];
        let factor = OVERLAP / offset[0].hypot(offset[1]).max(OVERLAP);
        [corner[0] + factor * offset[0], corner[1] + factor * offset[1]]
    };
    corners.iter().map(outwards).collect()
}

/// Floor and back walls with grid lines.
fn draw_box(drawing: &mut Drawing, projection: &Projection, z_ticks: &[Tick]) {
    let [[x0, x1], [y0, y1], [z0, z1]] = projection.ranges;
    let mut line = |p: [f64; 3], q: [f64; 3]| {
        drawing.line(projection.at(p), projection.at(q), GRID_LINE);
    };
    for Tick { value: x, .. } in floor_ticks(x0, x1) {
        line([x, y0, z0], [x, y1, z0]);
        line([x, y1, z0], [x, y1, z1]);
    }
    for Tick { value: y, .. } in floor_ticks(y0, y1) {
        line([x0, y, z0], [x1, y, z0]);
        line([x0, y, z0], [x0, y, z1]);
    }
    for &Tick { value: z, .. } in z_ticks {
        line([x0, y0, z], [x0, y1, z]);
        line([x0, y1, z], [x1, y1, z]);
    }
    let edges =
        [[[x0, y0, z0], [x1, y0, z0]], [[x1, y0, z0], [x1, y1, z0]], [[x0, y0, z0], [x0, y0, z1]]];
    for [p, q] in edges {
        drawing.line(projection.at(p), projection.at(q), &tick_line());
    }
}

fn floor_ticks(low: f64, high: f64) -> Vec<Tick> {
    round_ticks(low, high, 4)
}

/// Ticks and label along the left vertical edge.
fn draw_upright(drawing: &mut Drawing, projection: &Projection, z_ticks: &[Tick], label: &str) {
    let [[x0, _], [y0, _], [_, z1]] = projection.ranges;
    for Tick { value: z, label } in z_ticks {
        let [left, height] = projection.at([x0, y0, *z]);
        drawing.line([left, height], [left - 5.0, height], &tick_line());
        let style = TextStyle::new(TICK_SIZE, Anchor::End);
        drawing.text([left - 9.0, height + 0.36 * TICK_SIZE], &style, label);
    }
    let [left, top] = projection.at([x0, y0, z1]);
    drawing.text([left, top - 16.0], &TextStyle::new(LABEL_SIZE, Anchor::Middle), label);
}

/// Ticks and labels along the two near edges of the floor, and the rolling direction if there is
/// one.
fn draw_floor_axes(drawing: &mut Drawing, projection: &Projection, is_rolling: bool) {
    let [[x0, x1], [y0, y1], [z0, _]] = projection.ranges;
    let [wide, deep] = [0.5 * (x1 - x0), 0.5 * (y1 - y0)];
    let floor = |x: f64, y: f64| projection.at([x, y, z0]);
    // Below the numbers of the vertical edge, on the side towards which the axis recedes.
    let beside = |[x, y]: [f64; 2], aside: f64| [x + aside, y + 1.2 * TICK_SIZE];
    let numbers = TextStyle::new(TICK_SIZE, Anchor::Middle);
    for Tick { value: x, label } in floor_ticks(x0, x1) {
        drawing.line(floor(x, y0), floor(x, y0 - 0.04 * deep), &tick_line());
        drawing.text(beside(floor(x, y0 - 0.04 * deep), -12.0), &numbers, &label);
    }
    for Tick { value: y, label } in floor_ticks(y0, y1) {
        drawing.line(floor(x1, y), floor(x1 + 0.04 * wide, y), &tick_line());
        drawing.text(beside(floor(x1 + 0.04 * wide, y), 16.0), &numbers, &label);
    }
    let [middle_x, middle_y] = [0.5 * (x0 + x1), 0.5 * (y0 + y1)];
    let turned = |rotation| TextStyle { rotation, ..TextStyle::new(LABEL_SIZE, Anchor::Middle) };
    let along_x = projection.angle([x0, y0], [x1, y0]);
    let along_y = projection.angle([x1, y0], [x1, y1]);
    drawing.text(floor(middle_x, y0 - 0.36 * deep), &turned(along_x), "$x$* = $x$/$a$");
    drawing.text(floor(x1 + 0.36 * wide, middle_y), &turned(along_y), "$y$* = $y$/$b$");
    if !is_rolling {
        return;
    }
    let aside = y0 - 0.54 * deep;
    let [tail, tip] = [floor(middle_x - 0.3 * wide, aside), floor(middle_x + 0.3 * wide, aside)];
    drawing.path(&marks::arrow(tail, tip, 9.0), &format!(r#"fill="{INK}""#));
    let style = TextStyle { size: TICK_SIZE, ..turned(along_x) };
    drawing.text(floor(middle_x, y0 - 0.67 * deep), &style, "rolling direction");
}

/// The rim of the patch at the base of the surface.
fn draw_rim(drawing: &mut Drawing, projection: &Projection, base: f64) {
    let points: Vec<[f64; 2]> = (0..=120)
        .map(|step| f64::from(step) / 120.0 * TAU)
        .map(|angle| projection.at([angle.cos(), angle.sin(), base]))
        .collect();
    drawing.polyline(&points, &format!(r#"stroke="{INK}" stroke-width="1.2""#));
}
