//! The font of the figures: `DejaVu` Sans, reduced to the characters in use (see
//! `fonts/README.md`).
//!
//! It is embedded in the program for the PNG and in every SVG for browsers, so that both look the
//! same everywhere; programs that ignore embedded fonts use the next of [`FAMILIES`], which has the
//! same widths.

use std::ops::RangeInclusive;
use std::sync::Arc;

use resvg::usvg::fontdb::Database;

/// Font families of the text, best first.
pub(crate) const FAMILIES: &str = "'DejaVu Sans', Verdana, sans-serif";

const UPRIGHT: &[u8] = include_bytes!("../../../fonts/DejaVuSans.ttf");
const OBLIQUE: &[u8] = include_bytes!("../../../fonts/DejaVuSans-Oblique.ttf");
const UPRIGHT_WEB: &[u8] = include_bytes!("../../../fonts/DejaVuSans.woff2");
const OBLIQUE_WEB: &[u8] = include_bytes!("../../../fonts/DejaVuSans-Oblique.woff2");

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
pub(crate) fn with_boxes(svg: &str) -> String {
    let has = |c: char| c.is_control() || CHARACTERS.iter().any(|range| range.contains(&c));
    svg.chars().map(|c| if has(c) { c } else { BOX }).collect()
}

/// The fonts for the renderer.
pub(crate) fn database() -> Arc<Database> {
    let mut database = Database::new();
    database.load_font_data(UPRIGHT.to_vec());
    database.load_font_data(OBLIQUE.to_vec());
    database.set_sans_serif_family("DejaVu Sans");
    Arc::new(database)
}

/// The fonts as a style sheet.
pub(crate) fn faces() -> String {
    let face = |style, data| {
        format!(
            "@font-face{{font-family:'DejaVu Sans';font-style:{style};\
             src:url(data:font/woff2;base64,{})}}",
            base64(data)
        )
    };
    face("normal", UPRIGHT_WEB) + &face("italic", OBLIQUE_WEB)
}

fn base64(data: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(data.len().div_ceil(3) * 4);
    for chunk in data.chunks(3) {
        let byte = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let value = (word >> (18 - 6 * digit) & 63) as usize;
            text.push(if digit > chunk.len() { '=' } else { char::from(DIGITS[value]) });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;

    /// Test vectors of RFC 4648, section 10.
    #[test]
    fn rfc_4648_test_vectors() {
        for (data, text) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foobar", "Zm9vYmFy")] {
            assert_eq!(base64(data.as_bytes()), text);
        }
    }
}
