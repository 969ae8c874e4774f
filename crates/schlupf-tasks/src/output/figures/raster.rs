//! Conversion of SVG to PNG.

use std::fmt::Display;
use std::ops::RangeInclusive;
use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};

use super::{FigureError, MARK};

/// Pixels per user unit, for print.
const SCALE: f32 = 2.0;

const UPRIGHT: &[u8] = include_bytes!("../../../fonts/DejaVuSans.ttf");
const OBLIQUE: &[u8] = include_bytes!("../../../fonts/DejaVuSans-Oblique.ttf");

/// The characters of [`UPRIGHT`] and [`OBLIQUE`].
const CHARACTERS: [RangeInclusive<char>; 19] = [
    ' '..='~',
    '\u{a0}'..='\u{24f}',
    '\u{386}'..='\u{38a}',
    '\u{38c}'..='\u{38c}',
    '\u{38e}'..='\u{3a1}',
    '\u{3a3}'..='\u{3ce}',
    '\u{400}'..='\u{45f}',
    '\u{1e00}'..='\u{1efb}',
    '\u{2010}'..='\u{2026}',
    '\u{2070}'..='\u{2071}',
    '\u{2074}'..='\u{208e}',
    '\u{2090}'..='\u{209c}',
    '\u{2100}'..='\u{2109}',
    '\u{210b}'..='\u{2149}',
    '\u{214b}'..='\u{214b}',
    '\u{214e}'..='\u{214e}',
    '\u{2190}'..='\u{2193}',
    '\u{2200}'..='\u{22ff}',
    BOX..=BOX,
];

/// What stands for a character that the fonts lack.
const BOX: char = '\u{25a1}';

/// A drawing for the renderer, which would leave out characters that the fonts lack: it gets a box
/// for each of them. Programs that show the SVG take them from another font.
fn with_boxes(svg: &str) -> String {
    let has = |c: char| c.is_control() || CHARACTERS.iter().any(|range| range.contains(&c));
    svg.chars().map(|c| if has(c) { c } else { BOX }).collect()
}

/// The fonts for the renderer.
pub(crate) fn fonts() -> Arc<Database> {
    let mut database = Database::new();
    database.load_font_data(UPRIGHT.to_vec());
    database.load_font_data(OBLIQUE.to_vec());
    database.set_sans_serif_family("DejaVu Sans");
    Arc::new(database)
}

/// The drawing as a PNG file.
pub(crate) fn png(svg: &str, fonts: &Arc<Database>) -> Result<Vec<u8>, FigureError> {
    let options = Options {
        fontdb: fonts.clone(),
        font_family: "DejaVu Sans".to_owned(),
        ..Options::default()
    };
    let tree = Tree::from_str(&with_boxes(svg), &options).map_err(render_error)?;
    let size = tree.size();
    let [width, height] = [size.width(), size.height()].map(|side| (side * SCALE).ceil() as u32);
    let mut pixels = Pixmap::new(width, height).ok_or_else(|| render_error("no size"))?;
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    encode(&pixels).map_err(render_error)
}

/// Without transparency, which a figure on white does not need, and optimised for speed rather than
/// size.
fn encode(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let opaque: Vec<u8> =
        pixels.data().chunks_exact(4).flat_map(|rgba| &rgba[..3]).copied().collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.add_text_chunk("Comment".to_owned(), MARK.to_owned())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&opaque)?;
    writer.finish()?;
    Ok(file)
}

fn render_error(error: impl Display) -> FigureError {
    FigureError::Render(error.to_string())
}
