//! Warnings of many points: of those that are alike the worst one, where it is, and how many there
//! are.

use crate::reporting::{Message, Warning};

/// What can be told apart by its kind and compared within it.
pub trait Graded {
    /// Whether it is of the same kind: about the same quantity, with the same code.
    fn is_like(&self, other: &Self) -> bool;

    /// How severe it is among those of its kind, dimensionless: the larger, the worse.
    fn severity(&self) -> f64;
}

impl Graded for Warning {
    fn is_like(&self, other: &Self) -> bool {
        self.code() == other.code() && self.quantity() == other.quantity()
    }

    fn severity(&self) -> f64 {
        self.severity()
    }
}

impl Graded for Message {
    fn is_like(&self, other: &Self) -> bool {
        self.code == other.code && self.quantity == other.quantity
    }

    fn severity(&self) -> f64 {
        self.severity
    }
}

/// Warnings of one kind, at one point or at many.
#[derive(Debug, Clone, PartialEq)]
pub struct Tallied<W, P> {
    /// The worst of them; of equal ones that at the first place.
    pub worst: W,
    /// Where it is.
    pub place: P,
    /// How many there are.
    pub count: usize,
    /// Whether all of them are equally severe.
    pub is_even: bool,
}

impl<W, P> Tallied<W, P> {
    /// The same warning, `count` times, for the first time at a place.
    pub fn new(worst: W, place: P, count: usize) -> Self {
        Self { worst, place, count, is_even: true }
    }
}

impl<P> Tallied<Message, P> {
    /// The worst of them as a message that tells its place, in words, and how many there are;
    /// `point` is what they are called.
    pub fn message(self, place: &str, point: &str) -> Message {
        self.worst.about(&places(place, point, self.count, self.is_even))
    }
}

/// A place with how many more of its kind there are: `x`, `x and 3 more points`, or `x, the worst
/// of 4 points`.
pub(crate) fn places(place: &str, point: &str, count: usize, is_even: bool) -> String {
    match count {
        0 | 1 => place.to_owned(),
        2 if is_even => format!("{place} and one more {point}"),
        _ if is_even => format!("{place} and {} more {point}s", count - 1),
        _ => format!("{place}, the worst of {count} {point}s"),
    }
}

/// Warnings of many points, each kind once, in the order in which the kinds were counted.
#[derive(Debug, Clone, PartialEq)]
pub struct Tally<W, P>(Vec<Tallied<W, P>>);

impl<W, P> Default for Tally<W, P> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<W: Graded, P: PartialOrd> Tally<W, P> {
    /// Counts a warning at a place.
    pub fn note(&mut self, warning: W, place: P) {
        self.add(Tallied::new(warning, place, 1));
    }

    /// Counts warnings that were counted elsewhere.
    pub fn add(&mut self, new: Tallied<W, P>) {
        let Some(old) = self.0.iter_mut().find(|old| old.worst.is_like(&new.worst)) else {
            return self.0.push(new);
        };
        let [before, now] = [old.worst.severity(), new.worst.severity()];
        let (count, is_even) = (old.count + new.count, old.is_even && new.is_even && before == now);
        if now > before || now == before && new.place < old.place {
            *old = new;
        }
        (old.count, old.is_even) = (count, is_even);
    }

    /// Each kind.
    pub fn iter(&self) -> std::slice::Iter<'_, Tallied<W, P>> {
        self.0.iter()
    }
}

impl<W, P> IntoIterator for Tally<W, P> {
    type Item = Tallied<W, P>;
    type IntoIter = std::vec::IntoIter<Tallied<W, P>>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a, W: Graded, P: PartialOrd> IntoIterator for &'a Tally<W, P> {
    type Item = &'a Tallied<W, P>;
    type IntoIter = std::slice::Iter<'a, Tallied<W, P>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<W: Graded, P: PartialOrd> Extend<Tallied<W, P>> for Tally<W, P> {
    fn extend<I: IntoIterator<Item = Tallied<W, P>>>(&mut self, others: I) {
        others.into_iter().for_each(|other| self.add(other));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The warning of a curve was that of its first hot point.
    #[test]
    fn the_worst_of_a_kind_is_kept_with_its_place_and_their_number() {
        let mut tally = Tally::default();
        let margin = |edge| Warning::SmallMargin { edge };
        tally.note(margin(0.02), "a");
        tally.note(margin(0.4), "b");
        tally.note(Warning::NoSensitivity {}, "b");
        tally.note(margin(0.03), "c");
        tally.note(Warning::NoSensitivity {}, "c");
        let [margins, sensitivity] = tally.0.as_slice() else { panic!("{tally:?}") };
        assert_eq!((margins.worst.clone(), margins.place, margins.count), (margin(0.4), "b", 3));
        assert_eq!(places("b", "point", 3, margins.is_even), "b, the worst of 3 points");
        assert_eq!((sensitivity.place, sensitivity.count), ("b", 2));
        assert_eq!(places("b", "point", 2, sensitivity.is_even), "b and one more point");
        // Tallies of parts are that of the whole.
        let mut other = Tally::default();
        other.add(Tallied::new(margin(0.5), "d", 2));
        tally.extend(other);
        let all: Vec<_> = tally.into_iter().map(|kind| (kind.place, kind.count)).collect();
        assert_eq!(all, [("d", 5), ("b", 2)]);
    }
}
