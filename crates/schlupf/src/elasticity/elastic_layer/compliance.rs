//! The layer on one grid: u = A t.

use std::f64::consts::PI;
use std::fmt;

use super::super::Compliance;
use super::tridiagonal::{Pair, Tridiagonal, each};
use super::{LayerStiffness, Surroundings};
use crate::normal::{Grid, VectorField};
use crate::numerics::fourier::cosine::PairedCosine;

const ZERO: Pair = Pair { re: 0.0, im: 0.0 };

/// The layer on one grid.
pub struct LayerCompliance {
    grid: Grid,
    surroundings: Surroundings,
    couples_cells: bool,
    /// The power of the grid size with which displacements scale, dimensionless; `None` for
    /// constant stiffnesses per area.
    size_exponent: Option<f64>,
    lattice: Lattice,
    /// The systems along y, with the rows beyond the grid condensed.
    condensed: Tridiagonal,
    cosine: PairedCosine,
    /// Position of every column of the total area in the transform.
    places: Vec<usize>,
    spectrum: Vec<Pair>,
}

/// Stiffnesses of the lattice, of both components.
struct Lattice {
    /// Bedding c alone, in N/m³.
    plain_bedding: Pair,
    /// Bedding of each wave number along x: c + g_x (2 − 2 cos(π k/N))/Δx², in N/m³.
    bedding: Vec<Pair>,
    /// Coupling across rolling over Δy², in N/m³.
    coupling: Pair,
    /// The chains beyond the first and the last row, for each wave number.
    chains: Vec<[Chain; 2]>,
}

/// A chain of elements beyond a row.
#[derive(Debug, Clone, Copy)]
struct Chain {
    /// Stiffness that it adds to the row, in N/m³, and its derivative with respect to the logarithm
    /// of the grid size.
    stiffness: f64,
    stiffness_by_size: f64,
    /// Displacement of its end relative to that of the row, dimensionless.
    to_edge: f64,
}

/// The chain of `rows` elements, each on its bedding c + `along` and coupled by g to the next: from
/// the free end inwards s ← e g/(g + s), e = c + `along` + s. Both couplings are proportional to
/// the inverse square of the size.
fn condensed(bedding: f64, along: f64, coupling: f64, rows: usize) -> Chain {
    let end = Chain { stiffness: 0.0, stiffness_by_size: 0.0, to_edge: 1.0 };
    (0..rows).fold(end, |beyond, _| {
        let element = bedding + along + beyond.stiffness;
        let element_by_size = beyond.stiffness_by_size - 2.0 * along;
        let (share, rest) = (coupling / (coupling + element), element / (coupling + element));
        Chain {
            stiffness: coupling * rest,
            stiffness_by_size: share * share * element_by_size - 2.0 * rest * rest * coupling,
            to_edge: beyond.to_edge * share,
        }
    })
}

fn pair(of: [f64; 2]) -> Pair {
    Pair::new(of[0], of[1])
}

impl Lattice {
    fn new(stiffness: &[LayerStiffness; 2], grid: &Grid, surroundings: &Surroundings) -> Self {
        let waves = surroundings.columns;
        let plain = stiffness.map(|s| s.bedding);
        let along = stiffness.map(|s| s.coupling_along_x / grid.spacing_x.powi(2));
        let coupling = stiffness.map(|s| s.coupling_along_y / grid.spacing_y.powi(2));
        let along: Vec<[f64; 2]> = (0..waves)
            .map(|k| 2.0 - 2.0 * (PI * k as f64 / waves as f64).cos())
            .map(|eigenvalue| along.map(|along| along * eigenvalue))
            .collect();
        let chain = |along: &[f64; 2]| {
            [0, 1].map(|c| condensed(plain[c], along[c], coupling[c], surroundings.rows_beyond))
        };
        Self {
            plain_bedding: pair(plain),
            bedding: along.iter().map(|along| pair(plain) + pair(*along)).collect(),
            coupling: pair(coupling),
            chains: along.iter().map(chain).collect(),
        }
    }

    /// Minus the derivative of the stiffness with respect to the logarithm of the grid size, times
    /// the displacement of one row; `above` and `below` are its neighbours, if there are any.
    fn relief(&self, row: [&[Pair]; 3], ends: usize, relief: &mut [Pair]) {
        let [above, here, below] = row;
        let neighbours = usize::from(!above.is_empty()) + usize::from(!below.is_empty());
        for (wave, relief) in relief.iter_mut().enumerate() {
            let next_to =
                above.get(wave).copied().unwrap_or(ZERO) + below.get(wave).copied().unwrap_or(ZERO);
            let coupled = each(self.coupling, here[wave] * neighbours as f64 - next_to);
            let bedded = each(self.bedding[wave] - self.plain_bedding, here[wave]);
            let chain = pair(self.chains[wave].map(|chain| chain.stiffness_by_size));
            *relief = (bedded + coupled) * 2.0 - each(chain, here[wave]) * ends as f64;
        }
    }
}

impl LayerCompliance {
    pub(super) fn new(
        stiffness: &[LayerStiffness; 2],
        surroundings: Surroundings,
        grid: Grid,
    ) -> Self {
        let columns = surroundings.columns;
        let cosine = PairedCosine::new(columns);
        let lattice = Lattice::new(stiffness, &grid, &surroundings);
        let outside: Vec<Pair> =
            lattice.chains.iter().map(|chain| pair(chain.map(|c| c.stiffness))).collect();
        Self {
            couples_cells: stiffness
                .iter()
                .any(|s| s.coupling_along_x > 0.0 || s.coupling_along_y > 0.0),
            size_exponent: None,
            condensed: Tridiagonal::new(&lattice.bedding, lattice.coupling, grid.rows, &outside),
            places: (0..columns).map(|j| cosine.place(j)).collect(),
            spectrum: vec![ZERO; columns * grid.rows],
            grid,
            surroundings,
            lattice,
            cosine,
        }
    }

    /// The same for displacements that scale with a power of the grid size.
    pub(in crate::elasticity) fn growing(self, power: f64) -> Self {
        Self { size_exponent: Some(power), ..self }
    }

    /// Positions of the columns of the grid in the transform.
    fn grid_places(&self) -> &[usize] {
        let first = self.surroundings.first_column;
        &self.places[first..first + self.grid.columns]
    }

    /// Traction in the grid's rows, on the columns of the total area, transformed along x.
    fn transform_rows(&mut self, traction: &VectorField) {
        let mut spectrum = std::mem::take(&mut self.spectrum);
        let rows = spectrum.chunks_exact_mut(self.surroundings.columns);
        let x = traction.x.chunks_exact(self.grid.columns);
        let tractions = x.zip(traction.y.chunks_exact(self.grid.columns));
        for (row, (x, y)) in rows.zip(tractions) {
            row.fill(ZERO);
            for ((place, x), y) in self.grid_places().iter().zip(x).zip(y) {
                row[*place] = Pair::new(*x, *y);
            }
            self.cosine.forward(row);
        }
        self.spectrum = spectrum;
    }

    /// Transforms the spectrum, which is destroyed, back to the displacement of the grid.
    fn transform_back(&mut self, displacement: &mut VectorField) {
        let mut spectrum = std::mem::take(&mut self.spectrum);
        let columns = self.surroundings.columns;
        let inverse = 0.5 / columns as f64;
        let x = displacement.x.chunks_exact_mut(self.grid.columns);
        let displacements = x.zip(displacement.y.chunks_exact_mut(self.grid.columns));
        for (row, (x, y)) in spectrum.chunks_exact_mut(columns).zip(displacements) {
            self.cosine.inverse(row);
            for ((place, x), y) in self.grid_places().iter().zip(x).zip(y) {
                (*x, *y) = (inverse * row[*place].re, inverse * row[*place].im);
            }
        }
        self.spectrum = spectrum;
    }

    fn solve(&mut self, traction: &VectorField) {
        self.transform_rows(traction);
        self.condensed.solve(&mut self.spectrum, self.surroundings.columns);
    }

    /// Converts spectra of rows to displacements on all columns of the total area, in their order.
    fn on_all_columns(&mut self, mut rows: Vec<Pair>) -> Vec<Pair> {
        let columns = self.surroundings.columns;
        let inverse = 0.5 / columns as f64;
        let mut displacements = Vec::with_capacity(rows.len());
        for row in rows.chunks_exact_mut(columns) {
            self.cosine.inverse(row);
            displacements.extend(self.places.iter().map(|place| row[*place] * inverse));
        }
        displacements
    }

    /// Displacement in the grid's rows, on all columns of the total area, followed by its two
    /// outermost rows.
    fn rows_and_edges(&mut self, traction: &VectorField) -> Vec<Pair> {
        let columns = self.surroundings.columns;
        self.solve(traction);
        let mut values = self.spectrum.clone();
        let last = self.spectrum.len() - columns;
        for row in [0, last] {
            let row = self.spectrum[row..row + columns].iter().zip(&self.lattice.chains);
            values.extend(row.map(|(u, chain)| each(*u, pair(chain.map(|c| c.to_edge)))));
        }
        self.on_all_columns(values)
    }

    /// −A (dC/d ln size) A t, C being the stiffness.
    fn relieved(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        let columns = self.surroundings.columns;
        self.solve(traction);
        let rows = self.grid.rows;
        let mut relief = vec![ZERO; self.spectrum.len()];
        for (j, relief) in relief.chunks_exact_mut(columns).enumerate() {
            let row = |j: usize| &self.spectrum[j * columns..(j + 1) * columns];
            let above = if j > 0 { row(j - 1) } else { &[] };
            let below = if j + 1 < rows { row(j + 1) } else { &[] };
            let ends = usize::from(j == 0) + usize::from(j + 1 == rows);
            self.lattice.relief([above, row(j), below], ends, relief);
        }
        self.condensed.solve(&mut relief, columns);
        self.spectrum = relief;
        self.transform_back(displacement);
    }
}

/// Sets a component without traction to exactly zero. The transform of both components together
/// leaves it the rounding error of the other one, which a Krylov method for a stiff contact law
/// would treat as a second problem.
fn clear_at_rest(traction: &VectorField, displacement: &mut VectorField) {
    for (t, u) in [(&traction.x, &mut displacement.x), (&traction.y, &mut displacement.y)] {
        if t.iter().all(|t| *t == 0.0) {
            u.fill(0.0);
        }
    }
}

impl Compliance for LayerCompliance {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        self.solve(traction);
        self.transform_back(displacement);
        clear_at_rest(traction, displacement);
    }

    fn displacement_by_size(
        &mut self,
        traction: &VectorField,
        displacement: &mut VectorField,
    ) -> bool {
        if let Some(power) = self.size_exponent {
            self.displacement(traction, displacement);
            for u in displacement.x.iter_mut().chain(&mut displacement.y) {
                *u *= power;
            }
        } else {
            self.relieved(traction, displacement);
            clear_at_rest(traction, displacement);
        }
        true
    }

    fn couples_cells(&self) -> bool {
        self.couples_cells
    }

    fn edge_displacement(&mut self, traction: &VectorField) -> f64 {
        if !self.couples_cells {
            return 0.0;
        }
        let columns = self.surroundings.columns;
        let displacements = self.rows_and_edges(traction);
        let magnitude = |k: usize| displacements[k].norm();
        let inside = self.grid.rows * columns;
        let is_edge =
            |k: usize| k >= inside || k.is_multiple_of(columns) || (k + 1).is_multiple_of(columns);
        let largest = (0..inside).map(magnitude).fold(0.0, f64::max);
        let edge = (0..displacements.len()).filter(|k| is_edge(*k));
        let at_edge = edge.map(magnitude).fold(0.0, f64::max);
        if largest > 0.0 { at_edge / largest } else { 0.0 }
    }
}

impl fmt::Debug for LayerCompliance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LayerCompliance")
            .field("grid", &self.grid)
            .field("surroundings", &self.surroundings)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::super::ElasticLayer;
    use super::*;
    use crate::normal::Extent;
    use approx::assert_relative_eq;

    impl LayerCompliance {
        /// Displacement on the total area, row after row, as pairs of x and y in m; without
        /// condensation.
        fn total_displacement(&mut self, traction: &VectorField) -> Vec<Pair> {
            let Surroundings { columns, rows_beyond, .. } = self.surroundings;
            self.transform_rows(traction);
            let mut values = vec![ZERO; rows_beyond * columns];
            values.extend_from_slice(&self.spectrum);
            values.resize(values.len() + rows_beyond * columns, ZERO);
            let rows = values.len() / columns;
            let Lattice { bedding, coupling, .. } = &self.lattice;
            let free = vec![ZERO; columns];
            Tridiagonal::new(bedding, *coupling, rows, &free).solve(&mut values, columns);
            self.on_all_columns(values)
        }
    }

    fn layer() -> LayerStiffness {
        LayerStiffness { bedding: 1e13, coupling_along_x: 3.24e7, coupling_along_y: 2e7 }
    }

    fn grid() -> Grid {
        Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-5e-3, 5e-3] }, 12, 9)
    }

    fn compliance(margin: f64) -> LayerCompliance {
        let stiffer =
            LayerStiffness { bedding: 3e13, coupling_along_x: 1e7, coupling_along_y: 5e7 };
        let elastic = ElasticLayer::new(layer(), stiffer, Some(margin)).unwrap();
        let grid = grid();
        LayerCompliance::new(&elastic.per_area(&grid), elastic.surroundings(&grid).unwrap(), grid)
    }

    /// The condensed rows change nothing: the product equals the solution on the total area.
    #[test]
    fn condensed_rows_equal_the_total_area() {
        let grid = grid();
        let mut compliance = compliance(5e-3);
        let mut traction = VectorField::zeros(grid.len());
        for (k, t) in traction.x.iter_mut().enumerate() {
            *t = 1e8 * ((k * k % 17) as f64 - 5.0);
        }
        for (k, t) in traction.y.iter_mut().enumerate() {
            *t = 1e8 * ((k * k % 13) as f64 - 3.0);
        }
        let mut u = VectorField::zeros(grid.len());
        compliance.displacement(&traction, &mut u);
        let total = compliance.total_displacement(&traction);
        let Surroundings { columns, first_column, rows_beyond } = compliance.surroundings;
        for j in 0..grid.rows {
            for i in 0..grid.columns {
                let there = total[(j + rows_beyond) * columns + i + first_column];
                let k = grid.index(i, j);
                assert_relative_eq!(u.x[k], there.re, max_relative = 1e-10, epsilon = 1e-18);
                assert_relative_eq!(u.y[k], there.im, max_relative = 1e-10, epsilon = 1e-18);
            }
        }
    }

    /// Constant traction on the total area of a lattice with free edges displaces it by t/c
    /// everywhere.
    #[test]
    fn uniform_traction_acts_on_the_bedding_alone() {
        let grid = grid();
        let zero_margin = ElasticLayer::new(layer(), layer(), Some(0.0)).unwrap();
        let surroundings = Surroundings { columns: grid.columns, first_column: 0, rows_beyond: 0 };
        let mut compliance = LayerCompliance::new(&zero_margin.per_area(&grid), surroundings, grid);
        let traction = VectorField { x: vec![1e8; grid.len()], y: vec![0.0; grid.len()] };
        let mut u = VectorField::zeros(grid.len());
        compliance.displacement(&traction, &mut u);
        for u in &u.x {
            assert_relative_eq!(*u, 1e-5, max_relative = 1e-12);
        }
        assert_relative_eq!(compliance.edge_displacement(&traction), 1.0, max_relative = 1e-12);
    }
    /// Both components are transformed together, and yet one without traction stays exactly zero.
    #[test]
    fn a_component_without_traction_does_not_move() {
        let mut compliance = compliance(5e-3);
        let cells = compliance.grid.len();
        let traction = VectorField { x: vec![1e8; cells], y: vec![0.0; cells] };
        let mut u = VectorField::zeros(cells);
        compliance.displacement(&traction, &mut u);
        assert!(u.x.iter().all(|u| *u > 1e-6) && u.y.iter().all(|u| *u == 0.0));
    }
}
