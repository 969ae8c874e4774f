//! Warnings of many rows, counted by their codes.

use crate::warning_codes;
use schlupf::reporting::{Message, Tallied, Tally};

/// The column with the codes of the warnings of each row.
pub(crate) const WARNINGS: &str = "warnings";

/// Warnings of rows, counted by their codes; with the worst of each where it is known.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Counts {
    rows: usize,
    codes: Vec<Count>,
    worst: Tally<Message, usize>,
}

/// How many rows have a code.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Count {
    code: String,
    rows: usize,
    first: usize,
}

impl Counts {
    /// Counts the codes of a row, apart by spaces.
    pub(crate) fn add(&mut self, row: usize, codes: &str) {
        self.rows += 1;
        for code in codes.split_whitespace() {
            match self.codes.iter_mut().find(|count| count.code == code) {
                Some(count) => {
                    count.rows += 1;
                    count.first = count.first.min(row);
                }
                None => self.codes.push(Count { code: code.to_owned(), rows: 1, first: row }),
            }
        }
    }

    /// Takes the warnings of rows, whose codes are counted apart.
    pub(crate) fn tell(&mut self, warnings: Tally<Message, usize>) {
        self.worst.extend(warnings);
    }

    /// A warning for each code: in how many rows, and the worst of those that were solved now, or
    /// what the code means. Rows that have not converged are counted by their status.
    pub fn messages(&self) -> Vec<Message> {
        self.codes.iter().flat_map(|count| self.of(count)).collect()
    }

    fn of(&self, count: &Count) -> Vec<Message> {
        let Count { code, rows, first } = count;
        let counted = format!("{code} in {rows} of {} states", self.rows);
        let of_code = |found: &&Tallied<Message, usize>| found.worst.code == code;
        let mut found = self.worst.iter().filter(of_code).peekable();
        if code == Message::NOT_CONVERGED {
            return Vec::new();
        }
        if found.peek().is_some() {
            let told = |Tallied { worst, place, is_even, .. }: &Tallied<Message, usize>| {
                let which = if *is_even { "first" } else { "worst" };
                worst.clone().about(&format!("{counted}, {which} in row {place}"))
            };
            return found.map(told).collect();
        }
        let meaning = warning_codes().into_iter().find(|(known, _)| known == code);
        let told = |(code, meaning): (&'static str, &str)| {
            let meaning = meaning.trim_end_matches('.');
            let text = format!("{counted}, first in row {first}: {}", lower(meaning));
            Message::new(code, WARNINGS, text)
        };
        meaning.map(told).into_iter().collect()
    }
}

/// With a small letter in front.
fn lower(text: &str) -> String {
    let mut characters = text.chars();
    let first = characters.next().map(|first| first.to_lowercase().to_string());
    first.unwrap_or_default() + characters.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs of many states ended without their warnings.
    #[test]
    fn warnings_are_counted_by_their_codes_and_the_worst_is_told() {
        let mut counts = Counts::default();
        for (row, codes) in ["", "beyond-elastic hot-surface", "beyond-elastic", "not-converged"]
            .into_iter()
            .enumerate()
        {
            counts.add(row, codes);
        }
        let texts = |counts: &Counts| -> Vec<String> {
            counts.messages().into_iter().map(|message| message.text).collect()
        };
        assert_eq!(
            texts(&counts),
            [
                "beyond-elastic in 2 of 4 states, first in row 1: the pressure is above any \
                 elastic limit: wrong units?",
                "hot-surface in 1 of 4 states, first in row 1: a surface is so hot that steel \
                 austenitises or melts"
            ]
        );
        let mut solved = Tally::default();
        let beyond = |severity: f64| {
            Message::new("beyond-elastic", "load", format!("{severity} GPa")).graded(severity)
        };
        solved.note(beyond(4.0), 1);
        solved.note(beyond(9.0), 2);
        counts.tell(solved);
        let told = &counts.messages()[0];
        assert_eq!(told.text, "beyond-elastic in 2 of 4 states, worst in row 2: 9 GPa");
        assert_eq!((told.code, told.quantity.as_str()), ("beyond-elastic", "load"));
    }
}
