//! The cells of a grid as rectangles of their colours.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::color::{Palette, paint};
use super::svg::Drawing;

/// The cells of each colour as one path; adjacent cells of one colour in a row form one rectangle.
/// The grid begins at its lower left corner in the drawing; `level` is the colour of the cell in a
/// column and a row, if it has one.
pub(crate) fn draw(
    drawing: &mut Drawing,
    ([left, bottom], [width, height]): ([f64; 2], [f64; 2]),
    [columns, rows]: [usize; 2],
    (palette, level): (Palette, &dyn Fn(usize, usize) -> Option<usize>),
) {
    let mut paths: BTreeMap<usize, String> = BTreeMap::new();
    for row in 0..rows {
        let mut column = 0;
        while column < columns {
            let Some(here) = level(column, row) else {
                column += 1;
                continue;
            };
            let count = (column..columns).take_while(|&c| level(c, row) == Some(here)).count();
            // Writing to a String cannot fail.
            let _ = write!(paths.entry(here).or_default(), "M{column} {row}h{count}v1h-{count}z");
            column += count;
        }
    }
    drawing.begin_group(&format!(
        r#"transform="matrix({width:.6} 0 0 {:.6} {left:.4} {bottom:.4})" shape-rendering="crispEdges""#,
        -height
    ));
    for (level, path) in paths {
        drawing.path(&path, &format!(r#"fill="{}""#, paint(palette, level)));
    }
    drawing.end_group();
}
