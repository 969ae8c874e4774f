//! The warnings of all points, each kind reported once.

use crate::message::{Message, Words};
use crate::quantity::Quantity;
use crate::solution::Status;
use crate::warning::{Unconverged, Warning};

use super::Point;

/// A warning of a creep curve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct CurveWarning {
    /// The warning; the one of the first point that has it.
    pub warning: Warning,
    /// Where it applies; `None` for the whole curve.
    pub at: Option<Points>,
}

/// Points of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Points {
    /// The abscissa of the curve.
    pub abscissa: Quantity,
    /// Abscissa of the first of them, in its unit or dimensionless.
    pub first: f64,
    /// How many there are.
    pub count: usize,
}

impl CurveWarning {
    /// The message in the words of an interface.
    pub fn message(&self, words: &dyn Words) -> Message {
        let message = self.warning.message(words);
        let Some(Points { abscissa, first, count }) = self.at else { return message };
        let first = format!("{} = {}", words.word(abscissa), abscissa.six_digits(first));
        message.about(&match count {
            1 => first,
            2 => format!("{first} and one further point"),
            count => format!("{first} and {} further points", count - 1),
        })
    }
}

/// Warnings of a curve.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    kinds: Vec<Kind>,
    /// Warnings of the curve as a whole.
    others: Vec<Warning>,
}

/// Warnings that differ only in their values.
#[derive(Debug)]
struct Kind {
    /// The warning of the first point that has it.
    warning: Warning,
    /// Abscissa of that point.
    first: f64,
    /// Number of points that have it.
    count: usize,
    /// Whether it is the same at all of them.
    is_constant: bool,
}

/// Maximum number of points that a warning names.
const MOST_NAMES: usize = 12;

impl Warnings {
    /// Warnings of the solution at an abscissa.
    pub(super) fn note(&mut self, abscissa: f64, warnings: &[Warning]) {
        for warning in warnings {
            let is_same = |kind: &&mut Kind| {
                kind.warning.code() == warning.code()
                    && kind.warning.quantity() == warning.quantity()
            };
            match self.kinds.iter_mut().find(is_same) {
                Some(kind) => {
                    kind.count += 1;
                    kind.is_constant &= kind.warning == *warning;
                }
                None => self.kinds.push(Kind {
                    warning: warning.clone(),
                    first: abscissa,
                    count: 1,
                    is_constant: true,
                }),
            }
        }
    }

    /// Adds a warning of the curve as a whole.
    pub(super) fn extend(&mut self, warning: Option<Warning>) {
        self.others.extend(warning);
    }

    /// All of them, the points that did not converge first.
    pub(super) fn all(self, abscissa: Quantity, points: &[Point]) -> Vec<CurveWarning> {
        let of_curve = not_converged(abscissa, points).into_iter().chain(self.others);
        let of_curve = of_curve.map(|warning| CurveWarning { warning, at: None });
        let of_points =
            self.kinds.into_iter().map(|Kind { warning, first, count, is_constant }| {
                let is_everywhere = is_constant && count == points.len();
                let at = (!is_everywhere).then_some(Points { abscissa, first, count });
                CurveWarning { warning, at }
            });
        of_curve.chain(of_points).collect()
    }
}

fn not_converged(abscissa: Quantity, points: &[Point]) -> Option<Warning> {
    let failed = points.iter().filter(|point| point.status == Status::NotConverged);
    let failed: Vec<f64> = failed.map(|point| point.abscissa).collect();
    let places = failed.iter().take(MOST_NAMES).copied().collect();
    let (failed, count) = (failed.len(), points.len());
    (failed > 0).then(|| Warning::of(Unconverged::Points { abscissa, places, failed, count }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Names;

    #[test]
    fn warnings_that_differ_in_values_are_one() {
        let mut warnings = Warnings::default();
        let margin = |edge| Warning::SmallMargin { edge };
        let (always, once) = (Warning::BranchLost {}, Warning::NoSensitivity {});
        warnings.note(0.0, &[margin(0.013), always.clone()]);
        warnings.note(0.1, &[always.clone(), once]);
        warnings.note(0.2, &[margin(1e-7), always]);
        warnings.extend(Some(Warning::NoInitialSlope { abscissa: Quantity::Spin }));
        let counts: Vec<usize> = warnings.kinds.iter().map(|kind| kind.count).collect();
        assert_eq!(counts, [2, 3, 1]);
        let all = warnings.all(Quantity::Spin, &[]);
        let texts: Vec<String> = all.iter().map(|warning| warning.message(&Names).text).collect();
        assert!(texts[0].starts_with("no initial slope"));
        assert!(texts[1].starts_with("spin = 0 1/m and one further point: margin: "));
        assert!(texts[3].starts_with("spin = 0.1 1/m: sensitivity: "));
    }
}
