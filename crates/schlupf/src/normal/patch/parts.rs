//! The parts of a contact that do not touch each other.

use std::ops::Range;

use super::Patch;

/// A strip by its places in the grid.
#[derive(Debug)]
struct Run {
    row: usize,
    columns: Range<usize>,
}

impl Run {
    fn touches(&self, other: &Self) -> bool {
        self.row.abs_diff(other.row) <= 1
            && self.columns.start < other.columns.end
            && other.columns.start < self.columns.end
    }
}

impl Patch {
    /// Number of cells along and across rolling of the box around each part of the contact.
    pub(crate) fn sizes_of_parts(&self) -> Vec<[usize; 2]> {
        let runs = self.strips.iter().map(|strip| {
            let [first, last] = [strip.cells.start, strip.cells.end - 1]
                .map(|k| self.cells[k].index % self.grid.columns);
            Run { row: strip.row, columns: first.min(last)..first.max(last) + 1 }
        });
        parts(runs).iter().map(|part| size(part)).collect()
    }
}

fn parts(runs: impl Iterator<Item = Run>) -> Vec<Vec<Run>> {
    let mut parts: Vec<Vec<Run>> = Vec::new();
    for run in runs {
        let (joined, mut others): (Vec<_>, Vec<_>) =
            parts.into_iter().partition(|part| part.iter().any(|other| other.touches(&run)));
        others.push(joined.into_iter().flatten().chain([run]).collect());
        parts = others;
    }
    parts
}

fn size(part: &[Run]) -> [usize; 2] {
    let columns = extent(part.iter().flat_map(|run| [run.columns.start, run.columns.end - 1]));
    [columns, extent(part.iter().map(|run| run.row))]
}

/// Number of whole numbers from the smallest to the largest one.
fn extent(of: impl Iterator<Item = usize>) -> usize {
    let (least, most) = of.fold((usize::MAX, 0), |(least, most), n| (least.min(n), most.max(n)));
    (most + 1).saturating_sub(least)
}

#[cfg(test)]
mod tests {
    use super::{Run, parts, size};

    fn sizes(runs: &[(usize, std::ops::Range<usize>)]) -> Vec<[usize; 2]> {
        let runs = runs.iter().map(|(row, columns)| Run { row: *row, columns: columns.clone() });
        parts(runs).iter().map(|part| size(part)).collect()
    }

    #[test]
    fn parts_touch_along_sides_not_at_corners() {
        assert_eq!(sizes(&[(0, 2..4), (1, 4..6), (2, 5..9)]), [[2, 1], [5, 2]]);
    }

    /// Two prongs that a later row joins, and one behind another in the same rows.
    #[test]
    fn a_row_joins_what_was_apart() {
        let runs = [(0, 0..2), (0, 5..7), (1, 1..3), (1, 4..6), (1, 8..9), (2, 2..5)];
        assert_eq!(sizes(&runs), [[1, 1], [7, 3]]);
    }
}
