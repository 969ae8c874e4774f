//! Static condensation of the elastic layer, Eqs. (4)–(7) of Neuhaus and Sextro (2014), with dense
//! matrices as the paper writes it.
//!
//! The paper's (6) reads u_o = −C_oo⁻¹ C_oi u_i, and (7) C_red = C_ii − C_io C_oo⁻¹ C_oi. Because
//! C_red⁻¹ is the contact block of C⁻¹, the solver needs no condensed matrix: it restricts the
//! compliance to the contact. This module shows that the two are the same.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

use super::elastic_layer::LayerStiffness;

/// A rectangular lattice of point elements with free edges, one displacement component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lattice {
    /// Elements along rolling.
    pub columns: usize,
    /// Elements across rolling.
    pub rows: usize,
    /// Distance of the elements along rolling, in m.
    pub spacing_x: f64,
    /// Distance of the elements across rolling, in m.
    pub spacing_y: f64,
    /// Stiffnesses per area.
    pub stiffness: LayerStiffness,
}

impl Lattice {
    /// Spring to the wheel Δc, coupling springs along and across rolling, in N/m.
    pub fn springs(&self) -> [f64; 3] {
        let LayerStiffness { bedding, coupling_along_x, coupling_along_y } = self.stiffness;
        [
            bedding * self.spacing_x * self.spacing_y,
            coupling_along_x * self.spacing_y / self.spacing_x,
            coupling_along_y * self.spacing_x / self.spacing_y,
        ]
    }

    /// Stiffness matrix C of all elements, row after row, in N/m; Eq. (4).
    pub fn stiffness_matrix(&self) -> Mat<f64> {
        let count = self.columns * self.rows;
        let [bedding, along, across] = self.springs();
        let mut matrix = Mat::zeros(count, count);
        let mut connect = |p: usize, q: usize, spring: f64| {
            matrix[(p, p)] += spring;
            matrix[(q, q)] += spring;
            matrix[(p, q)] -= spring;
            matrix[(q, p)] -= spring;
        };
        for k in 0..count {
            if !(k + 1).is_multiple_of(self.columns) {
                connect(k, k + 1, along);
            }
            if k + self.columns < count {
                connect(k, k + self.columns, across);
            }
        }
        for k in 0..count {
            matrix[(k, k)] += bedding;
        }
        matrix
    }

    /// Reduced stiffness C_red = C_ii − C_io C_oo⁻¹ C_oi of the elements in `contact`, in N/m;
    /// Eq. (7). `None` where C_oo is not positive definite, which a bedding c > 0 rules out.
    pub fn reduced_stiffness(&self, contact: &[usize]) -> Option<Mat<f64>> {
        let matrix = self.stiffness_matrix();
        let inside = |k: &usize| contact.contains(k);
        let outside: Vec<usize> = (0..matrix.nrows()).filter(|k| !inside(k)).collect();
        let block = |rows: &[usize], columns: &[usize]| {
            Mat::from_fn(rows.len(), columns.len(), |i, j| matrix[(rows[i], columns[j])])
        };
        let factor = block(&outside, &outside).llt(Side::Lower).ok()?;
        let moved_outside = factor.solve(block(&outside, contact));
        Some(block(contact, contact) - block(contact, &outside) * moved_outside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elasticity::Elasticity;
    use crate::elasticity::elastic_layer::ElasticLayer;
    use crate::grid::{Extent, Grid, VectorField};

    const STIFFNESS: LayerStiffness =
        LayerStiffness { bedding: 1e13, coupling_along_x: 3.24e7, coupling_along_y: 3.24e7 };

    /// Neuhaus and Sextro 2014, Eq. (7): C_red⁻¹ is the contact block of C⁻¹, and that is what the
    /// solver's product applies, to 1e-10.
    #[test]
    fn neuhaus_sextro_2014_condensation_is_restriction_of_the_compliance() {
        let grid = Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-5e-3, 5e-3] }, 10, 7);
        let elastic = ElasticLayer::new(STIFFNESS, STIFFNESS, Some(3e-3)).unwrap();
        let around = elastic.surroundings(&grid).unwrap();
        let lattice = Lattice {
            columns: around.columns,
            rows: grid.rows + 2 * around.rows_beyond,
            spacing_x: grid.spacing_x,
            spacing_y: grid.spacing_y,
            stiffness: STIFFNESS,
        };
        // An ellipse of contact cells, on the grid and on the lattice.
        let in_contact =
            |i: usize, j: usize| (grid.x(i) / 6e-3).powi(2) + (grid.y(j) / 5e-3).powi(2) < 1.0;
        let cells: Vec<(usize, usize)> = (0..grid.rows)
            .flat_map(|j| (0..grid.columns).map(move |i| (i, j)))
            .filter(|(i, j)| in_contact(*i, *j))
            .collect();
        let contact: Vec<usize> = cells
            .iter()
            .map(|(i, j)| (j + around.rows_beyond) * around.columns + i + around.first_column)
            .collect();
        let n = contact.len();
        let identity = Mat::<f64>::identity(n, n);
        let reduced = lattice.reduced_stiffness(&contact).unwrap();
        let inverse = reduced.llt(Side::Lower).unwrap().solve(&identity);

        let full = lattice.stiffness_matrix();
        let unit = Mat::from_fn(full.nrows(), n, |i, j| f64::from(u8::from(i == contact[j])));
        let solved = full.llt(Side::Lower).unwrap().solve(&unit);
        let largest = (0..n).map(|i| inverse[(i, i)]).fold(0.0, f64::max);
        for i in 0..n {
            for j in 0..n {
                assert!((inverse[(i, j)] - solved[(contact[i], j)]).abs() < 1e-10 * largest);
            }
        }

        let mut compliance = elastic.compliance(&grid).unwrap();
        for (column, &(i, j)) in cells.iter().enumerate() {
            let mut traction = VectorField::zeros(grid.len());
            traction.x[grid.index(i, j)] = grid.cell_area().recip();
            let mut u = VectorField::zeros(grid.len());
            compliance.displacement(&traction, &mut u);
            for (row, &(i, j)) in cells.iter().enumerate() {
                let difference = u.x[grid.index(i, j)] - inverse[(row, column)];
                assert!(difference.abs() < 1e-10 * largest);
            }
        }
    }
}
