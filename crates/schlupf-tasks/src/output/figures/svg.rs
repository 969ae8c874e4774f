//! A drawing: shapes and text in user units, written as SVG.

use std::fmt::Write;

use super::color::INK;
use super::font;
use super::label::{self, TextStyle};

/// Stroke of grid lines.
pub(crate) const GRID_LINE: &str = r##"stroke="#dddddd" stroke-width="1""##;

/// Stroke of the line at zero.
pub(crate) const ZERO: &str = r##"stroke="#8a8a8a" stroke-width="1""##;

/// An SVG drawing with a white background, the origin at the upper left.
#[derive(Debug)]
pub(crate) struct Drawing {
    /// Width in user units, pixels at scale one.
    pub width: f64,
    /// Height in user units.
    pub height: f64,
    body: String,
    clips: usize,
}

/// Mark near the beginning of our drawings, by which they are recognised.
pub const MARK: &str = "drawn by schlupf";

impl Drawing {
    /// An empty drawing.
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self { width, height, body: String::new(), clips: 0 }
    }

    /// A straight line; `style` holds SVG attributes, here and below.
    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], style: &str) {
        self.path(&open_path(&[from, to]), style);
    }

    /// A polygon through the points.
    pub(crate) fn polygon(&mut self, points: &[[f64; 2]], style: &str) {
        self.path(&(open_path(points) + "z"), style);
    }

    /// An open line through the points.
    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], style: &str) {
        self.path(&open_path(points), &format!(r#"fill="none" {style}"#));
    }

    /// An axis-parallel rectangle from its upper left corner.
    pub(crate) fn rectangle(&mut self, corner: [f64; 2], size: [f64; 2], style: &str) {
        let ([x, y], [width, height]) = (corner, size);
        self.element(&format!(
            r#"<rect x="{x:.2}" y="{y:.2}" width="{width:.2}" height="{height:.2}" {style}/>"#
        ));
    }

    /// A path in SVG's path language; omitted if it is empty.
    pub(crate) fn path(&mut self, data: &str, style: &str) {
        if !data.is_empty() {
            self.element(&format!(r#"<path d="{data}" {style}/>"#));
        }
    }

    /// A shape given as an SVG element.
    pub(crate) fn shape(&mut self, element: &str) {
        self.element(element);
    }

    /// Text with the markup of [`label`].
    pub(crate) fn text(&mut self, at: [f64; 2], style: &TextStyle, markup: &str) {
        self.element(&label::element(at, style, &label::spans(markup, style.size)));
    }

    /// Text without markup, such as the title of a case.
    pub(crate) fn plain_text(&mut self, at: [f64; 2], style: &TextStyle, text: &str) {
        self.element(&label::element(at, style, &label::escape(text)));
    }

    /// Restricts drawing to a shape (an SVG element) until [`Self::end_group`].
    pub(crate) fn begin_clip(&mut self, shape: &str) {
        let clip = self.clips;
        self.clips += 1;
        self.element(&format!(
            r#"<clipPath id="clip{clip}">{shape}</clipPath><g clip-path="url(#clip{clip})">"#
        ));
    }

    /// Draws with common attributes until [`Self::end_group`].
    pub(crate) fn begin_group(&mut self, attributes: &str) {
        self.element(&format!("<g {attributes}>"));
    }

    /// Ends the innermost clip or group.
    pub(crate) fn end_group(&mut self) {
        self.element("</g>");
    }

    /// The SVG document.
    pub(crate) fn finish(self) -> String {
        let Self { width, height, body, .. } = self;
        format!(
            r##"<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0}" height="{height:.0}" viewBox="0 0 {width:.0} {height:.0}" font-family="{family}" fill="{INK}">
<desc>{MARK}</desc>
<style>{faces}</style>
<rect width="100%" height="100%" fill="#ffffff"/>
{body}</svg>
"##,
            family = font::FAMILIES,
            faces = font::faces(),
        )
    }

    fn element(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }
}

/// Path data of an open line through the points.
pub(crate) fn open_path(points: &[[f64; 2]]) -> String {
    let mut data = String::new();
    for (index, [x, y]) in points.iter().enumerate() {
        let command = if index == 0 { 'M' } else { 'L' };
        // Writing to a String cannot fail.
        let _ = write!(data, "{command}{x:.2} {y:.2}");
    }
    data
}
