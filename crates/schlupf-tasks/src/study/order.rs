//! The order in which the states of a batch are solved: those that share a case after one another,
//! and within them each close to the one before, from which its solution starts.

use crate::study::design::Entry;

/// Rows that are ordered at once, dimensionless: to find the nearest takes the square of it.
const ORDERED: usize = 1024;

/// The rows of a batch in the order in which they are solved, in groups that differ only in what a
/// solver takes without another case: `is_condition` tells which entries these are.
pub(crate) fn groups(rows: &[Vec<Entry>], is_condition: &[bool]) -> Vec<Vec<usize>> {
    let case = |row: &[Entry]| -> Vec<Key> {
        let others = row.iter().zip(is_condition).filter(|(_, is_condition)| !**is_condition);
        others.map(|(entry, _)| Key::of(entry)).collect()
    };
    let mut groups: Vec<(Vec<Key>, Vec<usize>)> = Vec::new();
    let mut places = std::collections::HashMap::new();
    for (k, row) in rows.iter().enumerate() {
        let key = case(row);
        let place = *places.entry(key.clone()).or_insert(groups.len());
        if place == groups.len() {
            groups.push((key, Vec::new()));
        }
        groups[place].1.push(k);
    }
    let ordered = |members: &[usize]| -> Vec<usize> {
        let blocks = members.chunks(ORDERED);
        blocks.flat_map(|block| chain(rows, block, is_condition)).collect()
    };
    groups.into_iter().map(|(_, members)| ordered(&members)).collect()
}

/// What makes entries the same: the bits of a number, or the text.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Key {
    Number(u64),
    Text(String),
}

impl Key {
    fn of(entry: &Entry) -> Self {
        match entry {
            Entry::Number(number) => Self::Number(number.to_bits()),
            Entry::Text(text) => Self::Text(text.clone()),
        }
    }
}

/// From the smallest values on, always the nearest one that is left; distances are relative to the
/// ranges of the members.
fn chain(rows: &[Vec<Entry>], members: &[usize], is_condition: &[bool]) -> Vec<usize> {
    let number = |entry: &Entry| if let Entry::Number(number) = entry { *number } else { 0.0 };
    let conditions: Vec<usize> = (0..is_condition.len()).filter(|c| is_condition[*c]).collect();
    let scale = |c: usize| {
        let values = members.iter().map(|k| number(&rows[*k][c]));
        let (low, high) = values.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        (low, if high > low { (high - low).recip() } else { 0.0 })
    };
    let scales: Vec<(f64, f64)> = conditions.iter().map(|c| scale(*c)).collect();
    let place = |k: usize| -> Vec<f64> {
        let columns = conditions.iter().zip(&scales);
        columns.map(|(c, (low, scale))| (number(&rows[k][*c]) - low) * scale).collect()
    };
    let mut left: Vec<(usize, Vec<f64>)> = members.iter().map(|k| (*k, place(*k))).collect();
    let mut at = vec![0.0; conditions.len()];
    let mut order = Vec::with_capacity(members.len());
    while !left.is_empty() {
        let distance = |other: &[f64]| -> f64 {
            other.iter().zip(&at).map(|(there, here)| (there - here).powi(2)).sum()
        };
        let mut nearest = (0, f64::INFINITY);
        for (k, (_, there)) in left.iter().enumerate() {
            let distance = distance(there);
            if distance < nearest.1 {
                nearest = (k, distance);
            }
        }
        // Keeps the order of the rest, so that ties go to the earlier row.
        let (row, there) = left.remove(nearest.0);
        order.push(row);
        at = there;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(load: f64, creepage: f64) -> Vec<Entry> {
        vec![Entry::Number(load), Entry::Number(creepage)]
    }

    #[test]
    fn rows_of_a_case_follow_one_another_along_a_path() {
        let rows = [row(1.0, 0.3), row(2.0, 0.1), row(1.0, 0.1), row(1.0, 0.2), row(2.0, 0.0)];
        assert_eq!(groups(&rows, &[false, true]), [vec![2, 3, 0], vec![4, 1]]);
        assert_eq!(groups(&rows, &[true, true]).len(), 1);
        assert_eq!(groups(&rows, &[false, false]).len(), 5);
    }

    /// A batch of any size: each block of rows has its own way, and none is lost.
    #[test]
    fn many_rows_are_ordered_in_blocks() {
        let count = 2 * ORDERED + 1;
        let rows: Vec<_> = (0..count).map(|k| row(1.0, -(k as f64))).collect();
        let order = groups(&rows, &[true, true]).concat();
        let blocks = [ORDERED, 2 * ORDERED, count].map(|end| end - 1);
        assert_eq!([order[0], order[ORDERED], order[2 * ORDERED]], blocks);
        assert_eq!(order[ORDERED - 1], 0);
        let mut all = order;
        all.sort_unstable();
        assert!(all.into_iter().eq(0..count));
    }

    /// Not a number is near to nothing, but is not lost.
    #[test]
    fn no_row_is_lost() {
        let rows = [row(1.0, f64::NAN), row(1.0, 0.1), row(1.0, 0.1)];
        let mut all = groups(&rows, &[true, true]).concat();
        all.sort_unstable();
        assert_eq!(all, [0, 1, 2]);
    }
}
