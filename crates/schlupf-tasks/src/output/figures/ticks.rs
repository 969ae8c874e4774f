//! Ticks at round numbers.

use crate::output::number::significant;

/// A tick of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    /// Position, in the unit of the axis.
    pub value: f64,
    /// The number to write.
    pub label: String,
}

/// Between `about`/2 and `about`·2 ticks within the range, at multiples of 1, 2 or 5 times a power
/// of ten. An empty or non-finite range has none.
pub(crate) fn round_ticks(low: f64, high: f64, about: usize) -> Vec<Tick> {
    let range = high - low;
    if !(range.is_finite() && range > 0.0) {
        return Vec::new();
    }
    ticks_by(round_step(range, about), low, high)
}

/// The range widened to the next ticks, and the ticks; 0 to 1 if there is no range.
pub(crate) fn round_axis(low: f64, high: f64, about: usize) -> ([f64; 2], Vec<Tick>) {
    let range = high - low;
    if !(range.is_finite() && range > 0.0) {
        return round_axis(0.0, 1.0, about);
    }
    let step = round_step(range, about);
    let low = (low / step + 1e-6).floor() * step;
    let high = (high / step - 1e-6).ceil() * step;
    ([low, high], ticks_by(step, low, high))
}

/// At most about `about` ticks at powers of ten for a range of logarithms to base ten; their values
/// are logarithms, too.
pub(crate) fn powers_of_ten(low: f64, high: f64, about: usize) -> Vec<Tick> {
    let step = ((high - low) / about.max(1) as f64).ceil().max(1.0);
    if !(low.is_finite() && high.is_finite()) {
        return Vec::new();
    }
    let exponents = (low.ceil() as i32..=high.floor() as i32).map(f64::from);
    let shown = exponents.filter(|exponent| (exponent / step).fract() == 0.0);
    shown.map(|value| Tick { value, label: power_of_ten(value) }).collect()
}

/// Ticks for a range of logarithms to base ten, with the numbers themselves: powers of ten, and 2
/// and 5 times them where there are few.
pub(crate) fn round_powers(low: f64, high: f64, about: usize) -> Vec<Tick> {
    let digits: &[f64] =
        if 3.0 * (high - low) > 1.5 * about as f64 { &[1.0] } else { &[1.0, 2.0, 5.0] };
    let powers = powers_of_ten(low - 1.0, high, 2 * about).into_iter();
    let values = powers.flat_map(|tick| digits.iter().map(move |digit| tick.value + digit.log10()));
    let inside = values.filter(|value| (low - 1e-9..=high + 1e-9).contains(value));
    inside
        .map(|value| Tick {
            value,
            label: significant(10_f64.powf(value)).replace('-', "\u{2212}"),
        })
        .collect()
}

/// Ticks for a range of logarithms to base ten, of any length: at powers of ten, or at round
/// numbers where fewer than two of those lie within.
pub(crate) fn logarithmic_ticks(low: f64, high: f64, about: usize) -> Vec<Tick> {
    let [from, to] = [low, high].map(|exponent| 10_f64.powf(exponent));
    let even = round_ticks(from, to, about).into_iter();
    let even = even.map(|tick| Tick { value: tick.value.log10(), ..tick }).collect();
    let mut ticks = [powers_of_ten(low, high, about), round_powers(low, high, about)].into_iter();
    ticks.find(|ticks| ticks.len() >= 2).unwrap_or(even)
}

/// An integer power of ten, in the markup of labels.
pub(crate) fn power_of_ten(exponent: f64) -> String {
    format!("10^{{{exponent:.0}}}").replace('-', "\u{2212}")
}

/// The multiples of a step within a range.
fn ticks_by(step: f64, low: f64, high: f64) -> Vec<Tick> {
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    let decimals = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    (first..=last)
        .map(|multiple| multiple as f64 * step)
        .map(|value| Tick { value, label: number(value, decimals) })
        .collect()
}

/// 1, 2 or 5 times a power of ten, approximately `range` / `about`.
fn round_step(range: f64, about: usize) -> f64 {
    let raw = range / about.max(1) as f64;
    let magnitude = 10_f64.powf(raw.log10().floor());
    let digit = raw / magnitude;
    magnitude * [1.0, 2.0, 5.0].into_iter().find(|s| *s >= digit * 0.75).unwrap_or(10.0)
}

/// A number with a true minus sign; in powers of ten if the digits would not fit.
pub(crate) fn number(value: f64, decimals: usize) -> String {
    let text = if decimals > 4 || value.abs() >= 1e5 {
        if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
    } else {
        format!("{value:.decimals$}")
    };
    text.replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, about: usize) -> Vec<String> {
        round_ticks(low, high, about).into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels(-1.0, 1.0, 4), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(labels(0.0, 770.4, 5), ["0", "200", "400", "600"]);
        assert_eq!(labels(-6.9, 6.9, 6), ["−6", "−4", "−2", "0", "2", "4", "6"]);
    }

    #[test]
    fn a_round_axis_ends_at_ticks() {
        for high in [0.64, 0.93, 1.01, 7.3, 51.0, 118.0] {
            let ([low, top], ticks) = round_axis(0.0, high, 5);
            assert_eq!(low, 0.0);
            assert!(top >= high && (ticks[ticks.len() - 1].value - top).abs() < 1e-9 * top);
        }
    }

    #[test]
    fn powers_of_ten_are_thinned_out() {
        let labels = |low, high| {
            let ticks = powers_of_ten(low, high, 4).into_iter();
            ticks.map(|tick| tick.label).collect::<Vec<_>>()
        };
        assert_eq!(labels(-1.2, 1.1), ["10^{−1}", "10^{0}", "10^{1}"]);
        assert_eq!(labels(-4.3, 2.5), ["10^{−4}", "10^{−2}", "10^{0}", "10^{2}"]);
        assert!(labels(f64::NAN, 1.0).is_empty());
    }

    #[test]
    fn logarithmic_colours_have_numbers() {
        let labels = |low: f64, high: f64| -> Vec<String> {
            round_powers(low, high, 8).into_iter().map(|tick| tick.label).collect()
        };
        assert_eq!(labels(-1.0, 0.4), ["0.1", "0.2", "0.5", "1", "2"]);
        assert_eq!(labels(-6.0, -0.5).len(), 6);
    }

    #[test]
    fn short_logarithmic_axes_have_numbers() {
        let labels = |low: f64, high: f64| -> Vec<String> {
            let ticks = logarithmic_ticks(low.log10(), high.log10(), 5).into_iter();
            ticks
                .inspect(|tick| assert!((low.log10()..=high.log10()).contains(&tick.value)))
                .map(|tick| tick.label)
                .collect()
        };
        assert_eq!(labels(0.05, 300.0), ["10^{−1}", "10^{0}", "10^{1}", "10^{2}"]);
        assert_eq!(labels(0.9, 6.0), ["1", "2", "5"]);
        assert_eq!(labels(2.1, 4.2), ["2.5", "3.0", "3.5", "4.0"]);
        assert!(logarithmic_ticks(f64::NAN, 1.0, 5).is_empty());
        assert!(logarithmic_ticks(1.0, 1.0, 5).is_empty());
    }

    #[test]
    fn no_range_has_no_ticks() {
        assert!(round_ticks(1.0, 1.0, 5).is_empty());
        assert!(round_ticks(0.0, f64::NAN, 5).is_empty());
        assert!(round_ticks(0.0, f64::INFINITY, 5).is_empty());
    }
}
