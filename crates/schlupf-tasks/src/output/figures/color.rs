//! Colours of text and lines, and perceptually uniform colour maps.
//!
//! The maps are equidistant samples of viridis and inferno (matplotlib, van der Walt and Smith
//! 2015, CC0) and of vik (Crameri 2018, MIT), linear in between; with 33 samples the error is below
//! the resolution of eight bits.

use super::ticks::{Tick, round_powers, round_ticks};

/// Colour of text and axes.
pub(crate) const INK: &str = "#222222";
/// Colour of secondary elements: titles of the case, units, grid labels.
pub(crate) const MUTED: &str = "#5f5f5f";

/// Line colours that colour-blind readers can distinguish (Okabe and Ito 2008).
pub(crate) const BLUE: &str = "#0072b2";
/// Second line colour.
pub(crate) const VERMILION: &str = "#d55e00";
/// Third line colour.
pub(crate) const GREEN: &str = "#009e73";

/// A colour map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Palette {
    /// viridis: for mechanical quantities of one sign.
    Mechanical,
    /// inferno: for heat and temperature.
    Thermal,
    /// vik, white in the middle: for signed quantities, symmetric about zero.
    Signed,
}

/// Number of distinct colours in a figure.
pub(crate) const LEVELS: usize = 256;

/// Colours over a range of values.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ColorScale {
    /// The map.
    pub palette: Palette,
    /// Value of the first colour.
    pub low: f64,
    /// Value of the last colour.
    pub high: f64,
    /// Whether values are logarithms to base ten of what the ticks say.
    pub powers: bool,
}

impl ColorScale {
    /// Colours over a range of the values themselves.
    pub(crate) const fn linear(palette: Palette, [low, high]: [f64; 2]) -> Self {
        Self { palette, low, high, powers: false }
    }

    /// Round values within the range, about as many as given.
    pub(crate) fn ticks(&self, about: usize) -> Vec<Tick> {
        let ticks = if self.powers { round_powers } else { round_ticks };
        ticks(self.low, self.high, about)
    }

    /// The colour level of a value, clamped to the range.
    pub(crate) fn level(&self, value: f64) -> usize {
        let fraction = (value - self.low) / (self.high - self.low);
        (fraction.clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize
    }

    /// The colour of a value as an SVG paint.
    pub(crate) fn paint(&self, value: f64) -> String {
        paint(self.palette, self.level(value))
    }
}

/// The colour of a level as an SVG paint.
pub(crate) fn paint(palette: Palette, level: usize) -> String {
    let samples = match palette {
        Palette::Mechanical => &VIRIDIS,
        Palette::Thermal => &INFERNO,
        Palette::Signed => &VIK,
    };
    let position = level.min(LEVELS - 1) as f64 / (LEVELS - 1) as f64 * (samples.len() - 1) as f64;
    let below = (position as usize).min(samples.len() - 2);
    let share = position - below as f64;
    let mut color = 0;
    for shift in [16, 8, 0] {
        let channel = |sample: u32| f64::from(sample >> shift & 0xff);
        let mixed = channel(samples[below]) * (1.0 - share) + channel(samples[below + 1]) * share;
        color |= (mixed.round() as u32) << shift;
    }
    format!("#{color:06x}")
}

/// Colours of a series of curves, from dark to light, so that they also differ in greyscale.
pub(crate) fn series(count: usize) -> Vec<String> {
    /// The light end of the palette is invisible on white.
    const LIGHTEST: f64 = 0.78;
    if count == 1 {
        return vec![BLUE.to_owned()];
    }
    let level = |k: usize| LIGHTEST * k as f64 / (count - 1) as f64 * (LEVELS - 1) as f64;
    (0..count).map(|k| paint(Palette::Mechanical, level(k).round() as usize)).collect()
}

/// Colours of curves that have no order, such as those of methods (Okabe and Ito 2008, without the
/// yellow, which is too light); more curves than colours are ordered all the same.
pub(crate) fn unordered(count: usize) -> Vec<String> {
    const COLORS: [&str; 7] = [BLUE, VERMILION, GREEN, "#cc79a7", "#000000", "#e69f00", "#56b4e9"];
    if count > COLORS.len() {
        return series(count);
    }
    COLORS[..count].iter().map(|color| (*color).to_owned()).collect()
}

#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "two digits for each of red, green and blue")]
const VIRIDIS: [u32; 33] = [
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989,
    0x3b528b, 0x375b8d, 0x33638d, 0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e,
    0x21918c, 0x1f988b, 0x1fa088, 0x22a785, 0x28ae80, 0x32b67a, 0x3fbc73, 0x4ec36b,
    0x5ec962, 0x70cf57, 0x84d44b, 0x98d83e, 0xaddc30, 0xc2df23, 0xd8e219, 0xece51b,
    0xfde725,
];

#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "two digits for each of red, green and blue")]
const INFERNO: [u32; 33] = [
    0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2f0a5b, 0x3d0965, 0x4a0c6b,
    0x57106e, 0x64156e, 0x71196e, 0x7d1e6d, 0x8a226a, 0x972766, 0xa32c61, 0xb0315b,
    0xbc3754, 0xc73e4c, 0xd24644, 0xdb503b, 0xe45a31, 0xeb6628, 0xf1731d, 0xf68013,
    0xf98e09, 0xfb9d07, 0xfcac11, 0xfbbc21, 0xf9cb35, 0xf5db4c, 0xf2ea69, 0xf3f68a,
    0xfcffa4,
];

#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "two digits for each of red, green and blue")]
const VIK: [u32; 33] = [
    0x001261, 0x021f69, 0x022b71, 0x023779, 0x034481, 0x055189, 0x0c5e92, 0x1c6d9c,
    0x307da6, 0x488db2, 0x619ebd, 0x7aaec8, 0x94bed2, 0xadcddd, 0xc6dbe6, 0xdee6e9,
    0xece5e0, 0xeed9cd, 0xe9cab8, 0xe2baa2, 0xdbaa8d, 0xd59b79, 0xcf8c66, 0xc97e53,
    0xc27041, 0xbc622f, 0xb2511d, 0xa33e0d, 0x912d06, 0x811f06, 0x731406, 0x650907,
    0x590008,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_viridis_and_clamping() {
        let scale = ColorScale::linear(Palette::Mechanical, [0.0, 2.0]);
        assert_eq!(scale.paint(-1.0), "#440154");
        assert_eq!(scale.paint(2.0), "#fde725");
    }

    #[test]
    fn a_value_that_is_no_number_has_a_colour() {
        let scale = ColorScale::linear(Palette::Thermal, [0.0, 0.0]);
        assert_eq!(scale.paint(f64::NAN).len(), 7);
    }
}
