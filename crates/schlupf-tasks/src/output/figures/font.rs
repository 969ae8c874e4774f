//! The font of the figures: `DejaVu` Sans, reduced to the characters in use (see
//! `fonts/README.md`).
//!
//! It is embedded in the program for the PNG and in every SVG for browsers, so that both look the
//! same everywhere; programs that ignore embedded fonts use the next of [`FAMILIES`], which has the
//! same widths.

/// Font families of the text, best first.
pub(crate) const FAMILIES: &str = "'DejaVu Sans', Verdana, sans-serif";

const UPRIGHT: &[u8] = include_bytes!("../../../fonts/DejaVuSans.woff2");
const OBLIQUE: &[u8] = include_bytes!("../../../fonts/DejaVuSans-Oblique.woff2");

/// The fonts as a style sheet; none in a browser, where they would be larger than what they are in.
pub(crate) fn faces() -> String {
    if cfg!(target_family = "wasm") {
        return String::new();
    }
    let face = |style, data| {
        format!(
            "@font-face{{font-family:'DejaVu Sans';font-style:{style};\
             src:url(data:font/woff2;base64,{})}}",
            base64(data)
        )
    };
    face("normal", UPRIGHT) + &face("italic", OBLIQUE)
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
