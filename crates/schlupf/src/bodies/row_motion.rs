//! Motion of the rows of a patch on curved surfaces.
//!
//! A contact is solved in a plane, in which the rigid slip over the speed is (ξ − φ y, η + φ x)
//! with three numbers for the whole patch. Where the surfaces turn across the patch, the same rigid
//! motion slips otherwise: along rolling by the distance of the row from the axle, across it in the
//! tangent of the surface there, and it spins about the normal there. The surfaces are prisms along
//! rolling in the rail, so every row y = const has a plane of its own, and its rigid slip is
//!
//! (ξ − φ y + Δξ(y), η + φ x + Δη(y) + Δφ(y) x).
//!
//! In the conformal contacts of CONTACT, too, the rigid slip is that of the surface in its local
//! tangent (Vollebregt, Detailed wheel/rail geometry processing with the conformal contact
//! approach, Multibody System Dynamics, 2021, doi 10.1007/s11044-020-09762-w).

use crate::numerics::interpolation::{hermite, hermite_bend, hermite_slope};
use crate::reporting::{Error, Place, Quantity, Requirement, require_at, require_several};

/// What the motion of a row has in addition to that of the plane. It stays the same when the
/// creepages of the plane change.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RowSlip {
    /// Longitudinal creepage Δξ, dimensionless.
    pub creepage_x: f64,
    /// Lateral creepage Δη at x = 0, dimensionless.
    pub creepage_y: f64,
    /// Spin creepage Δφ, in 1/m.
    pub spin: f64,
}

impl RowSlip {
    /// The additional rigid slip over the speed at x (in m), dimensionless.
    pub fn at(&self, x: f64) -> [f64; 2] {
        [self.creepage_x, self.creepage_y + self.spin * x]
    }

    /// Sum of multiples of some of them.
    fn sum(terms: &[(f64, &Self)]) -> Self {
        let total = |part: fn(&Self) -> f64| terms.iter().map(|(w, row)| w * part(row)).sum();
        Self {
            creepage_x: total(|row| row.creepage_x),
            creepage_y: total(|row| row.creepage_y),
            spin: total(|row| row.spin),
        }
    }

    fn times(&self, factor: f64) -> Self {
        Self::sum(&[(factor, self)])
    }
}

/// The same in a strip of cells, to first order in y across it: (Δξ + Δξ′ y, Δη + Δη′ y + Δφ x).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StripSlip {
    /// Δξ and Δη, continued to y = 0, dimensionless.
    pub creepages: [f64; 2],
    /// Δξ′ and Δη′, in 1/m.
    pub by_y: [f64; 2],
    /// Δφ, in 1/m.
    pub spin: f64,
}

impl StripSlip {
    /// The additional rigid slip over the speed at x, y (in m), dimensionless.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [along, across] = [0, 1].map(|c| self.creepages[c] + self.by_y[c] * y);
        [along, across + self.spin * x]
    }
}

/// [`RowSlip`] over y: a table between whose entries lie the cubics with the slopes of the
/// parabolas through three neighbours; linear beyond its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct RowMotion {
    /// Ascending, in m.
    y: Vec<f64>,
    rows: Vec<RowSlip>,
    /// Derivatives with respect to y.
    slopes: Vec<RowSlip>,
}

impl RowMotion {
    /// A table over ascending y, in m.
    ///
    /// # Errors
    /// Positions that do not ascend, fewer than two of them or another number of rows, and numbers
    /// that are not finite.
    pub fn new(y: Vec<f64>, rows: Vec<RowSlip>) -> Result<Self, Error> {
        require_several(Quantity::Y, 2, y.len())?;
        if y.len() != rows.len() {
            let (quantity, expected) = (Quantity::CreepageX, y.len());
            return Err(Error::WrongCount { quantity, expected, count: rows.len() });
        }
        for (k, y) in y.iter().enumerate() {
            require_at(Quantity::Y, Requirement::Finite, *y, Place::Index(k + 1))?;
        }
        if let Some(pair) = y.windows(2).find(|pair| pair[1] <= pair[0]) {
            let (quantity, before, after) = (Quantity::Y, pair[0], pair[1]);
            return Err(Error::NotAscending { quantity, axis: "", before, after });
        }
        for (y, row) in y.iter().zip(&rows) {
            for (quantity, value) in [
                (Quantity::CreepageX, row.creepage_x),
                (Quantity::CreepageY, row.creepage_y),
                (Quantity::Spin, row.spin),
            ] {
                require_at(quantity, Requirement::Finite, value, Place::Across(*y))?;
            }
        }
        let slopes = slopes(&y, &rows);
        Ok(Self { y, rows, slopes })
    }

    /// The row at y (in m), and its first two derivatives with respect to y.
    pub fn at(&self, y: f64) -> [RowSlip; 3] {
        let last = self.y.len() - 1;
        let beyond = |end: usize| {
            let slope = self.slopes[end];
            [
                RowSlip::sum(&[(1.0, &self.rows[end]), (y - self.y[end], &slope)]),
                slope,
                RowSlip::default(),
            ]
        };
        if y <= self.y[0] {
            return beyond(0);
        }
        if y >= self.y[last] {
            return beyond(last);
        }
        let k = self.y.partition_point(|node| *node <= y) - 1;
        let width = self.y[k + 1] - self.y[k];
        let t = (y - self.y[k]) / width;
        let between = |weights: [f64; 4], over: f64| {
            let [from, to, out, into] = weights;
            RowSlip::sum(&[
                (from * over, &self.rows[k]),
                (to * over, &self.rows[k + 1]),
                (out * over * width, &self.slopes[k]),
                (into * over * width, &self.slopes[k + 1]),
            ])
        };
        let over = width.recip();
        [
            between(hermite(t), 1.0),
            between(hermite_slope(t), over),
            between(hermite_bend(t), over * over),
        ]
    }

    /// The rows about y (in m).
    pub fn strip(&self, y: f64) -> StripSlip {
        let [row, slope, _] = self.at(y);
        let by_y = [slope.creepage_x, slope.creepage_y];
        let [along, across] = [row.creepage_x, row.creepage_y];
        StripSlip { creepages: [along - by_y[0] * y, across - by_y[1] * y], by_y, spin: row.spin }
    }

    /// Derivative of that with respect to the logarithm of y.
    pub(crate) fn strip_by_size(&self, y: f64) -> StripSlip {
        let [_, slope, bend] = self.at(y);
        let bend = [bend.creepage_x, bend.creepage_y];
        StripSlip {
            creepages: bend.map(|bend| -bend * y * y),
            by_y: bend.map(|bend| bend * y),
            spin: slope.spin * y,
        }
    }

    /// The same with y and x measured from another origin, which lies at (x, y) (in m) in the
    /// present frame.
    #[must_use]
    pub fn seen_from(&self, [x, y]: [f64; 2]) -> Self {
        let moved = |row: &RowSlip| RowSlip { creepage_y: row.at(x)[1], ..*row };
        Self {
            y: self.y.iter().map(|node| node - y).collect(),
            rows: self.rows.iter().map(moved).collect(),
            slopes: self.slopes.iter().map(moved).collect(),
        }
    }

    /// The mirror image at y = 0.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mirrored =
            |row: &RowSlip| RowSlip { creepage_y: -row.creepage_y, spin: -row.spin, ..*row };
        let slope = |row: &RowSlip| mirrored(row).times(-1.0);
        Self {
            y: self.y.iter().rev().map(|y| -y).collect(),
            rows: self.rows.iter().rev().map(mirrored).collect(),
            slopes: self.slopes.iter().rev().map(slope).collect(),
        }
    }

    /// The same with all that it adds multiplied by a factor (dimensionless).
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let scaled = |rows: &[RowSlip]| rows.iter().map(|row| row.times(factor)).collect();
        Self { y: self.y.clone(), rows: scaled(&self.rows), slopes: scaled(&self.slopes) }
    }

    /// Positions of the table, in m, and what the rows there add.
    pub fn nodes(&self) -> impl Iterator<Item = (f64, &RowSlip)> {
        self.y.iter().copied().zip(&self.rows)
    }
}

/// Slopes at the nodes of the parabolas through each of them and its neighbours.
fn slopes(y: &[f64], rows: &[RowSlip]) -> Vec<RowSlip> {
    let last = y.len() - 1;
    let chord = |k: usize| {
        let over = (y[k + 1] - y[k]).recip();
        RowSlip::sum(&[(over, &rows[k + 1]), (-over, &rows[k])])
    };
    if last == 1 {
        return vec![chord(0); 2];
    }
    let at = |k: usize| {
        let middle = k.clamp(1, last - 1);
        let [before, after] = [chord(middle - 1), chord(middle)];
        let bend = (y[middle + 1] - y[middle - 1]).recip();
        let from = (2.0 * y[k] - y[middle] - y[middle - 1]) * bend;
        RowSlip::sum(&[(1.0 - from, &before), (from, &after)])
    };
    (0..=last).map(at).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn parabola(y: f64) -> RowSlip {
        RowSlip {
            creepage_x: 1.0 + y * (3.0 - y),
            creepage_y: 0.5 * y - y * y,
            spin: 2.0 - 0.25 * y,
        }
    }

    fn table() -> RowMotion {
        let y = vec![-3.0, -2.5, -1.0, 0.0, 0.75, 2.0];
        let rows = y.iter().map(|y| parabola(*y)).collect();
        RowMotion::new(y, rows).unwrap()
    }

    /// A parabola is met everywhere, with its slope, and continued by its tangents.
    #[test]
    fn parabolas_are_exact() {
        let table = table();
        for y in [-3.0, -2.7, -1.0, -0.4, 0.5, 1.9, 2.0] {
            let [row, slope, _] = table.at(y);
            assert_relative_eq!(row.creepage_x, parabola(y).creepage_x, epsilon = 1e-13);
            assert_relative_eq!(row.creepage_y, parabola(y).creepage_y, epsilon = 1e-13);
            assert_relative_eq!(row.spin, parabola(y).spin, epsilon = 1e-13);
            assert_relative_eq!(slope.creepage_x, 3.0 - 2.0 * y, epsilon = 1e-13);
            assert_relative_eq!(slope.creepage_y, 0.5 - 2.0 * y, epsilon = 1e-13);
        }
        let tangent = parabola(2.0).creepage_x + 0.5 * (3.0 - 2.0 * 2.0);
        assert_relative_eq!(table.at(2.5)[0].creepage_x, tangent, epsilon = 1e-13);
    }

    /// What is linear in y is the same in every strip.
    #[test]
    fn strips_follow_the_rows() {
        let table = table();
        for y in [-2.7, -0.4, 1.9] {
            let slip = table.strip(y).at([0.3, y]);
            let [row, slope, bend] = table.at(y);
            assert_relative_eq!(slip[0], row.at(0.3)[0], epsilon = 1e-13);
            assert_relative_eq!(slip[1], row.at(0.3)[1], epsilon = 1e-13);
            assert_relative_eq!(bend.creepage_x, -2.0, epsilon = 1e-12);
            let [near, grown] = [table.strip(y * (1.0 - 1e-6)), table.strip(y * (1.0 + 1e-6))];
            let by_size = table.strip_by_size(y);
            assert_relative_eq!(slope.spin * y, by_size.spin, epsilon = 1e-13);
            for c in 0..2 {
                let change = (grown.creepages[c] - near.creepages[c]) / 2e-6;
                assert_relative_eq!(by_size.creepages[c], change, epsilon = 1e-8);
                let change = (grown.by_y[c] - near.by_y[c]) / 2e-6;
                assert_relative_eq!(by_size.by_y[c], change, epsilon = 1e-8);
            }
        }
    }

    /// The slip at a place is the same wherever the origin is, and that of the mirror image is
    /// mirrored.
    #[test]
    fn the_origin_does_not_change_the_slip() {
        let (table, [x, y]) = (table(), [0.7, -1.3]);
        let [there, mirrored] = [table.seen_from([0.2, -0.4]), table.mirrored()];
        let slip = table.at(y)[0].at(x);
        let moved = there.at(y + 0.4)[0].at(x - 0.2);
        let image = mirrored.at(-y)[0].at(x);
        for c in 0..2 {
            assert_relative_eq!(moved[c], slip[c], epsilon = 1e-13);
            assert_relative_eq!(image[c], if c == 0 { slip[c] } else { -slip[c] }, epsilon = 1e-13);
        }
        assert_relative_eq!(
            mirrored.at(-y)[1].creepage_x,
            -table.at(y)[1].creepage_x,
            epsilon = 1e-13
        );
    }

    #[test]
    fn tables_without_order_are_refused() {
        let rows = vec![RowSlip::default(); 2];
        let message = |y: &[f64]| RowMotion::new(y.to_vec(), rows.clone()).unwrap_err().to_string();
        assert!(message(&[0.0]).contains("y needs at least 2 entries, got 1"));
        assert!(message(&[0.0; 2]).contains("y must ascend strictly, but 0 m comes after 0 m"));
        assert!(message(&[0.0, f64::NAN]).contains("is NaN m in place 2"));
        assert!(message(&[0.0, 1.0, 2.0]).contains("creepage_x needs 3 values, got 2"));
        let endless = RowSlip { spin: f64::INFINITY, ..RowSlip::default() };
        let error = RowMotion::new(vec![0.0, 1.0], vec![endless; 2]).unwrap_err().to_string();
        assert!(error.contains("spin") && error.contains("at y = 0 m"), "{error}");
    }
}
