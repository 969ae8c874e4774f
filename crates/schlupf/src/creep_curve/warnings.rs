//! The warnings of all points, each kind once.

use crate::solution::Status;

use super::{Abscissa, Point};

/// Warnings of a curve.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    kinds: Vec<Kind>,
    /// Those of the curve as a whole.
    others: Vec<String>,
}

/// Warnings that differ in their numbers only.
#[derive(Debug)]
struct Kind {
    without_numbers: String,
    /// The warning of the first point that has one.
    text: String,
    /// Abscissa of that point.
    first: f64,
    /// How many points have it.
    points: usize,
    /// Whether it is the same at all of them.
    is_constant: bool,
}

/// Most points that a warning names.
const MOST_NAMES: usize = 12;

impl Warnings {
    /// Warnings of the solution at an abscissa.
    pub(super) fn note(&mut self, abscissa: f64, texts: &[String]) {
        for text in texts {
            let without_numbers: String = text.chars().filter(|c| !is_of_number(*c)).collect();
            match self.kinds.iter_mut().find(|kind| kind.without_numbers == without_numbers) {
                Some(kind) => {
                    kind.points += 1;
                    kind.is_constant &= kind.text == *text;
                }
                None => self.kinds.push(Kind {
                    without_numbers,
                    text: text.clone(),
                    first: abscissa,
                    points: 1,
                    is_constant: true,
                }),
            }
        }
    }

    /// A warning of the curve as a whole.
    pub(super) fn extend(&mut self, text: Option<String>) {
        self.others.extend(text);
    }

    /// All of them, the points that did not converge first.
    pub(super) fn texts(self, abscissa: Abscissa, points: &[Point]) -> Vec<String> {
        let mut texts: Vec<String> = not_converged(abscissa, points).into_iter().collect();
        texts.extend(self.others);
        texts.extend(self.kinds.into_iter().map(|kind| {
            if kind.is_constant && kind.points == points.len() {
                return kind.text;
            }
            let first = abscissa.equation(kind.first);
            match kind.points {
                1 => format!("{first}: {}", kind.text),
                2 => format!("{first} and one further point: {}", kind.text),
                count => format!("{first} and {} further points: {}", count - 1, kind.text),
            }
        }));
        texts
    }
}

/// Part of a number, or of one with its exponent.
fn is_of_number(c: char) -> bool {
    c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e')
}

fn not_converged(abscissa: Abscissa, points: &[Point]) -> Option<String> {
    let failed: Vec<&Point> = points.iter().filter(|p| p.status == Status::NotConverged).collect();
    if failed.is_empty() {
        return None;
    }
    let named: Vec<String> =
        failed.iter().take(MOST_NAMES).map(|point| abscissa.value(point.abscissa)).collect();
    let rest = match failed.len().saturating_sub(MOST_NAMES) {
        0 => String::new(),
        rest => format!(" and {rest} more"),
    };
    Some(format!(
        "not converged: {} of {} points, at {} = {}{rest}",
        failed.len(),
        points.len(),
        abscissa.name(),
        named.join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_that_differ_in_numbers_are_one() {
        let mut warnings = Warnings::default();
        warnings.note(0.0, &["the margin: 1.3 %".to_owned(), "always".to_owned()]);
        warnings.note(0.1, &["always".to_owned(), "once".to_owned()]);
        warnings.note(0.2, &["the margin: 1e-5 %".to_owned(), "always".to_owned()]);
        warnings.extend(Some("the curve".to_owned()));
        let kinds: Vec<usize> = warnings.kinds.iter().map(|kind| kind.points).collect();
        assert_eq!(kinds, [2, 3, 1]);
        let texts = warnings.texts(Abscissa::Spin, &[]);
        assert_eq!(texts[0], "the curve");
        assert_eq!(texts[1], "spin = 0 1/m and one further point: the margin: 1.3 %");
        assert_eq!(texts[3], "spin = 0.1 1/m: once");
    }
}
