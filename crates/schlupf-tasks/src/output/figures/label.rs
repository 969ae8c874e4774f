//! Text with italics and subscripts.
//!
//! Markup: `$` starts and ends italics, `_` and `^` lower and raise the next character or the text
//! in braces that follows: `$p$_n (MPa)`, `mm^{2}`.

use std::fmt::Write;

use super::color::INK;

/// Position of the given point within the text.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Anchor {
    /// At its start.
    Start,
    /// At its centre.
    Middle,
    /// At its end.
    End,
}

/// Style of a text.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TextStyle {
    /// Font size in user units.
    pub size: f64,
    /// Position of the given point along the text.
    pub anchor: Anchor,
    /// Colour.
    pub color: &'static str,
    /// Clockwise rotation about the given point, in degrees.
    pub rotation: f64,
}

impl TextStyle {
    /// Upright dark text.
    pub(crate) const fn new(size: f64, anchor: Anchor) -> Self {
        Self { size, anchor, color: INK, rotation: 0.0 }
    }
}

/// The SVG element of a text whose content is given as SVG.
pub(crate) fn element(at: [f64; 2], style: &TextStyle, inner: &str) -> String {
    let [x, y] = at;
    let anchor = match style.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let mut attributes = format!(
        r#"x="{x:.2}" y="{y:.2}" font-size="{}" text-anchor="{anchor}" fill="{}""#,
        style.size, style.color
    );
    if style.rotation != 0.0 {
        // Writing to a String cannot fail.
        let _ = write!(attributes, r#" transform="rotate({:.2} {x:.2} {y:.2})""#, style.rotation);
    }
    // Spaces at the ends of spans are significant.
    format!(r#"<text {attributes} xml:space="preserve">{inner}</text>"#)
}

/// Markup as SVG text spans for a font size.
pub(crate) fn spans(markup: &str, size: f64) -> String {
    let mut inner = String::new();
    let mut baseline = 0.0;
    for run in runs(markup) {
        let (shift, scale) = match run.script {
            Script::Base => (0.0, 1.0),
            Script::Lower => (0.22, 0.72),
            Script::Upper => (-0.38, 0.72),
        };
        let style = if run.italic { r#" font-style="italic""# } else { "" };
        // A shift applies to all following text, so each run states its own relative to the
        // previous one. Writing to a String cannot fail.
        let _ = write!(
            inner,
            r#"<tspan dy="{:.2}" font-size="{:.2}"{style}>{}</tspan>"#,
            (shift - baseline) * size,
            scale * size,
            escape(&run.text)
        );
        baseline = shift;
    }
    inner
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Script {
    Base,
    Lower,
    Upper,
}

/// Characters with the same style.
#[derive(Debug)]
struct Run {
    text: String,
    italic: bool,
    script: Script,
}

fn runs(markup: &str) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut italic = false;
    let mut characters = markup.chars();
    while let Some(character) = characters.next() {
        let (text, script) = match character {
            '$' => {
                italic = !italic;
                continue;
            }
            '_' => (script(&mut characters), Script::Lower),
            '^' => (script(&mut characters), Script::Upper),
            other => (other.to_string(), Script::Base),
        };
        match runs.last_mut() {
            Some(run) if run.italic == italic && run.script == script => run.text.push_str(&text),
            _ => runs.push(Run { text, italic, script }),
        }
    }
    runs
}

/// The next character, or the text in braces.
fn script(characters: &mut std::str::Chars) -> String {
    match characters.next() {
        Some('{') => characters.by_ref().take_while(|&c| c != '}').collect(),
        Some(character) => character.to_string(),
        None => String::new(),
    }
}

/// Text with XML characters escaped and control characters removed.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

/// Approximate width of a text, in font sizes; accurate enough to keep labels apart.
pub(crate) fn width(text: &str) -> f64 {
    0.57 * text.chars().filter(|c| !"$_^{}".contains(*c)).count() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn xml_is_escaped_and_control_characters_are_dropped() {
        assert_eq!(escape("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot; ");
    }

    #[test]
    fn a_subscript_is_lowered_and_what_follows_is_raised_again() {
        let inner = spans("$p$_n (MPa)", 10.0);
        assert_eq!(
            inner,
            r#"<tspan dy="0.00" font-size="10.00" font-style="italic">p</tspan><tspan dy="2.20" font-size="7.20">n</tspan><tspan dy="-2.20" font-size="10.00"> (MPa)</tspan>"#
        );
    }

    #[test]
    fn unfinished_markup_is_no_panic() {
        for markup in ["$x", "a_", "b_{cd", "^"] {
            spans(markup, 10.0);
        }
    }
}
