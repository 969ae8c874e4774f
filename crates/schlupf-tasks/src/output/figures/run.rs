//! Runs of contact cells in a row of the grid, from the trailing to the leading edge.

use super::patch::Patch;

/// Covered fraction below which a cell is skipped.
pub(crate) const SLIVER: f64 = 0.25;

/// A run of contact cells.
#[derive(Debug)]
pub(crate) struct Run {
    /// The cells without slivers at the rim, which carry little information, and whose small
    /// numbers scatter.
    cells: Vec<usize>,
    /// Trailing and leading edge, x in m.
    edges: [f64; 2],
}

/// All runs in a row.
pub(crate) fn runs(patch: &Patch, row: usize) -> Vec<Run> {
    let columns: Vec<usize> = (0..patch.fields().grid.columns).collect();
    let cells = |columns: &[usize]| -> Vec<usize> {
        columns.iter().filter_map(|column| patch.cell(*column, row)).collect()
    };
    let parts = columns.split(|column| patch.cell(*column, row).is_none());
    parts.filter(|part| !part.is_empty()).map(|part| Run::new(patch, &cells(part))).collect()
}

impl Run {
    fn new(patch: &Patch, cells: &[usize]) -> Self {
        Self { edges: edges(patch, cells), cells: without_slivers(patch, cells) }
    }

    /// The values of its cells against x in m, from edge to edge. What vanishes at the rim is a
    /// mean over the whole cell and is shown as that over its covered part.
    pub(crate) fn profile(
        &self,
        patch: &Patch,
        values: &[f64],
        vanishes_at_rim: bool,
    ) -> Vec<[f64; 2]> {
        let fields = patch.fields();
        let part = |cell: usize| if vanishes_at_rim { fields.covered[cell] } else { 1.0 };
        let mut knots: Vec<[f64; 2]> =
            self.cells.iter().map(|&cell| [fields.x[cell], values[cell] / part(cell)]).collect();
        if vanishes_at_rim {
            let [trailing, leading] = self.edges;
            knots.insert(0, [trailing, 0.0]);
            knots.push([leading, 0.0]);
        } else {
            extend(&mut knots, self.edges);
        }
        knots
    }
}

/// The cells of a row that are not slivers; all of them if they all are.
pub(crate) fn without_slivers(patch: &Patch, cells: &[usize]) -> Vec<usize> {
    let is_sliver = |cell: &usize| patch.fields().covered[*cell] <= SLIVER;
    let all = cells.iter().all(is_sliver);
    cells.iter().copied().filter(|cell| all || !is_sliver(cell)).collect()
}

/// Mean edges of a run over the height of its row: the covered parts of its cells, counted from the
/// edges of its best covered cell.
fn edges(patch: &Patch, cells: &[usize]) -> [f64; 2] {
    let fields = patch.fields();
    let covered: Vec<f64> = cells.iter().map(|&cell| fields.covered[cell]).collect();
    let best = (0..cells.len()).max_by(|one, other| covered[*one].total_cmp(&covered[*other]));
    let best = best.unwrap_or_default();
    let length = |part: &[f64]| part.iter().sum::<f64>() / covered[best] * fields.grid.spacing_x;
    let column = fields.cell[cells[best]][0];
    [
        fields.grid.edge_x(column + 1) - length(&covered[..=best]),
        fields.grid.edge_x(column) + length(&covered[best..]),
    ]
}

/// Extends knots to the ends of a range by straight lines, which do not change their sign.
pub(crate) fn extend(knots: &mut Vec<[f64; 2]>, [start, end]: [f64; 2]) {
    let extended = |knots: &[[f64; 2]], at: f64| {
        let outer = *knots.first()?;
        let inner = *knots.get(1).unwrap_or(&outer);
        let slope = (inner[1] - outer[1]) / (inner[0] - outer[0]);
        let change = if slope.is_finite() { slope * (at - outer[0]) } else { 0.0 };
        let value = outer[1] + change;
        Some([at, if value * outer[1] < 0.0 { 0.0 } else { value }])
    };
    let first = extended(knots, start);
    let backwards: Vec<[f64; 2]> = knots.iter().rev().copied().collect();
    let last = extended(&backwards, end);
    knots.splice(0..0, first);
    knots.extend(last);
}

#[cfg(test)]
mod tests {
    use super::extend;

    #[test]
    fn knots_are_extended_without_a_change_of_sign() {
        let mut knots = vec![[1.0, 1.0], [2.0, 3.0], [3.0, 4.0]];
        extend(&mut knots, [0.0, 3.5]);
        assert_eq!(knots, [[0.0, 0.0], [1.0, 1.0], [2.0, 3.0], [3.0, 4.0], [3.5, 4.5]]);
        let mut single = vec![[1.0, 2.0]];
        extend(&mut single, [0.0, 3.0]);
        assert_eq!(single, [[0.0, 2.0], [1.0, 2.0], [3.0, 2.0]]);
    }
}
