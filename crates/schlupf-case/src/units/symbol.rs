//! Unit symbols and prefixes.

use std::f64::consts::PI;

use super::dimension::Dimension;

/// A unit: its size in SI base units and its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    pub(super) factor: f64,
    pub(super) dimension: Dimension,
}

impl Unit {
    pub(super) const ONE: Self = Self { factor: 1.0, dimension: Dimension::NONE };

    /// Product of this unit with a power of another.
    pub(super) fn times(self, other: Self, exponent: i32) -> Self {
        Self {
            factor: self.factor * other.factor.powi(exponent),
            dimension: self.dimension * other.dimension.power(exponent),
        }
    }
}

/// Symbol, size in SI base units, dimension; these take the SI prefixes.
const PREFIXED: &[(&str, f64, Dimension)] = &[
    ("m", 1.0, Dimension::LENGTH),
    ("g", 1e-3, Dimension::MASS),
    ("s", 1.0, Dimension::TIME),
    ("K", 1.0, Dimension::TEMPERATURE),
    ("rad", 1.0, Dimension::ANGLE),
    ("N", 1.0, Dimension::FORCE),
    ("Pa", 1.0, Dimension::PRESSURE),
    ("J", 1.0, Dimension::ENERGY),
    ("W", 1.0, Dimension::POWER),
    ("Hz", 1.0, Dimension::TIME.power(-1)),
    ("bar", 1e5, Dimension::PRESSURE),
];

/// Symbol, size in SI base units, dimension; these take no prefix.
const PLAIN: &[(&str, f64, Dimension)] = &[
    ("min", 60.0, Dimension::TIME),
    ("h", 3600.0, Dimension::TIME),
    ("t", 1e3, Dimension::MASS),
    ("deg", PI / 180.0, Dimension::ANGLE),
    ("°", PI / 180.0, Dimension::ANGLE),
    ("rev", 2.0 * PI, Dimension::ANGLE),
    ("rpm", 2.0 * PI / 60.0, Dimension { angle: 1, time: -1, ..Dimension::NONE }),
    ("mph", 0.44704, Dimension::mechanical(1, 0, -1)),
    ("in", 0.0254, Dimension::LENGTH),
    ("ft", 0.3048, Dimension::LENGTH),
    ("lbf", 4.448_221_615_260_5, Dimension::FORCE),
    ("psi", 6_894.757_293_168, Dimension::PRESSURE),
];

/// SI prefixes. `u` stands for µ, which Unicode has twice.
const PREFIXES: &[(&str, f64)] = &[
    ("T", 1e12),
    ("G", 1e9),
    ("M", 1e6),
    ("k", 1e3),
    ("h", 1e2),
    ("da", 1e1),
    ("d", 1e-1),
    ("c", 1e-2),
    ("m", 1e-3),
    ("u", 1e-6),
    ("\u{b5}", 1e-6),
    ("\u{3bc}", 1e-6),
    ("n", 1e-9),
    ("p", 1e-12),
];

/// The unit of a symbol such as `kN`. A symbol without prefix wins: `min` is no milli-inch.
pub(super) fn look_up(symbol: &str) -> Option<Unit> {
    let bare = PREFIXED.iter().chain(PLAIN).find(|(name, _, _)| *name == symbol);
    if let Some(&(_, factor, dimension)) = bare {
        return Some(Unit { factor, dimension });
    }
    PREFIXES.iter().find_map(|&(prefix, size)| {
        let rest = symbol.strip_prefix(prefix)?;
        let &(_, factor, dimension) = PREFIXED.iter().find(|(name, _, _)| *name == rest)?;
        Some(Unit { factor: size * factor, dimension })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_go_with_si_units_only() {
        assert_eq!(look_up("kN"), Some(Unit { factor: 1e3, dimension: Dimension::FORCE }));
        assert_eq!(look_up("kg"), Some(Unit { factor: 1.0, dimension: Dimension::MASS }));
        assert_eq!(look_up("µm"), look_up("um"));
        assert_eq!(look_up("μm"), look_up("um"));
        assert_eq!(look_up("kmph"), None);
        assert_eq!(look_up("kk"), None);
        assert_eq!(look_up("k"), None);
    }

    #[test]
    fn ambiguous_symbols_have_their_usual_meaning() {
        assert_eq!(look_up("min").map(|unit| unit.factor), Some(60.0));
        assert_eq!(look_up("m").map(|unit| unit.dimension), Some(Dimension::LENGTH));
        assert_eq!(look_up("h").map(|unit| unit.dimension), Some(Dimension::TIME));
        assert_eq!(look_up("ms").map(|unit| unit.factor), Some(1e-3));
        assert_eq!(look_up("Pa").map(|unit| unit.dimension), Some(Dimension::PRESSURE));
    }

    #[test]
    fn no_symbol_is_given_twice() {
        let mut names: Vec<_> = PREFIXED.iter().chain(PLAIN).map(|(name, _, _)| name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
