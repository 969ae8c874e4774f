//! The elastic layer of Neuhaus and Sextro (2014, Figure 2): point elements with springs to the
//! rigid wheel and to each other, on the contact area and its surroundings; Eqs. (4)–(7).
//!
//! Per area the lattice is c u − g_x δ²u/Δx² − g_y δ²u/Δy² = t with free edges, for u_x and u_y
//! each with its own c and g. Along x a cosine transform (DCT-II) diagonalises it exactly; along y
//! a tridiagonal system remains for each wave number. Rows outside the contact carry no traction,
//! so they are condensed beforehand into the stiffness of the outermost contact rows: the static
//! condensation (6), (7) of the paper, done once. A product costs O(n log n).

use std::f64::consts::PI;
use std::fmt;
use std::sync::Arc;

use rustdct::{DctPlanner, TransformType2And3};

use super::{Compliance, Elasticity};
use crate::error::{Error, require, require_positive};
use crate::fourier::smooth_from;
use crate::grid::{Grid, VectorField};

/// Stiffnesses per area of the layer for one displacement component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerStiffness {
    /// Bedding c: traction over displacement, in N/m³.
    pub bedding: f64,
    /// Coupling g between neighbours along rolling, in N/m.
    pub coupling_along_x: f64,
    /// Coupling g between neighbours across rolling, in N/m.
    pub coupling_along_y: f64,
}

impl LayerStiffness {
    /// Decay lengths √(g/c) along and across rolling, in m.
    pub fn decay_lengths(&self) -> [f64; 2] {
        [self.coupling_along_x, self.coupling_along_y].map(|g| (g / self.bedding).sqrt())
    }
}

/// The paper's discrete springs for one displacement component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// From an element to the wheel, Δc, in N/m.
    pub bedding: f64,
    /// From an element to each of its four neighbours, Δc_k, in N/m.
    pub coupling: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Stiffness {
    PerArea([LayerStiffness; 2]),
    Discrete([Springs; 2]),
}

/// The coupled elastic layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticLayer {
    stiffness: Stiffness,
    margin: Option<f64>,
}

/// Margin in decay lengths √(g/c) where none is given.
const DEFAULT_MARGIN: f64 = 8.0;

/// Most cells of the layer along one direction: contact and surroundings.
const MAX_LAYER_CELLS: f64 = 16384.0;

impl ElasticLayer {
    /// A layer with stiffnesses per area for the displacements along and across rolling, with at
    /// least `margin` (in m) of surroundings on each side; eight decay lengths √(g/c) if none.
    pub fn new(x: LayerStiffness, y: LayerStiffness, margin: Option<f64>) -> Result<Self, Error> {
        for ([bedding, along, across], s) in [
            (["elasticity.bedding_x", "elasticity.coupling_x", "elasticity.coupling_x_across"], x),
            (["elasticity.bedding_y", "elasticity.coupling_y", "elasticity.coupling_y_across"], y),
        ] {
            require_positive(bedding, s.bedding, "N/m^3")?;
            require_coupling(along, s.coupling_along_x)?;
            require_coupling(across, s.coupling_along_y)?;
        }
        Self::checked(Stiffness::PerArea([x, y]), margin)
    }

    /// A layer with the paper's discrete springs. Refining the grid changes its physics.
    pub fn from_springs(x: Springs, y: Springs, margin: Option<f64>) -> Result<Self, Error> {
        for (names, s) in [
            (["elasticity.spring_x", "elasticity.spring_coupling_x"], x),
            (["elasticity.spring_y", "elasticity.spring_coupling_y"], y),
        ] {
            require_positive(names[0], s.bedding, "N/m")?;
            require_coupling(names[1], s.coupling)?;
        }
        Self::checked(Stiffness::Discrete([x, y]), margin)
    }

    fn checked(stiffness: Stiffness, margin: Option<f64>) -> Result<Self, Error> {
        if let Some(margin) = margin {
            let legal = margin >= 0.0 && margin.is_finite();
            require(legal, "elasticity.margin", "finite and not negative", margin, "m")?;
        }
        Ok(Self { stiffness, margin })
    }

    /// Stiffnesses per area on a grid: c = Δc/(Δx Δy), g = Δc_k Δx/Δy along x, Δc_k Δy/Δx along y.
    pub fn per_area(&self, grid: &Grid) -> [LayerStiffness; 2] {
        match self.stiffness {
            Stiffness::PerArea(stiffness) => stiffness,
            Stiffness::Discrete(springs) => springs.map(|s| LayerStiffness {
                bedding: s.bedding / grid.cell_area(),
                coupling_along_x: s.coupling * grid.spacing_x / grid.spacing_y,
                coupling_along_y: s.coupling * grid.spacing_y / grid.spacing_x,
            }),
        }
    }

    /// Cells of surroundings beyond the grid on each side, along x and along y. The number of
    /// columns is rounded up to one that the transform likes.
    pub fn surroundings(&self, grid: &Grid) -> Result<Surroundings, Error> {
        let stiffness = self.per_area(grid);
        let margin = |direction: usize| {
            let decay = stiffness.iter().map(|s| s.decay_lengths()[direction]).fold(0.0, f64::max);
            self.margin.unwrap_or(DEFAULT_MARGIN * decay)
        };
        let [margin_x, margin_y] = [0, 1].map(margin);
        let cells_x = (margin_x / grid.spacing_x).ceil();
        let cells_y = (margin_y / grid.spacing_y).ceil();
        let largest = 2.0 * cells_x.max(cells_y) + grid.columns.max(grid.rows) as f64;
        if largest > MAX_LAYER_CELLS {
            return Err(Error::Contradiction {
                quantity: "elasticity.margin",
                reason: format!(
                    "a margin of {} m on this grid makes a layer of {largest} cells in one \
                     direction, more than {MAX_LAYER_CELLS}",
                    margin_x.max(margin_y)
                ),
            });
        }
        let columns = smooth_from(grid.columns + 2 * cells_x as usize);
        let ahead = (columns - grid.columns) / 2;
        Ok(Surroundings { columns, first_column: ahead, rows_beyond: cells_y as usize })
    }
}

/// The total area A_total around a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Surroundings {
    /// Columns of the total area.
    pub columns: usize,
    /// Column of the total area at which the grid begins.
    pub first_column: usize,
    /// Rows of the total area on each side of the grid.
    pub rows_beyond: usize,
}

fn require_coupling(quantity: &'static str, value: f64) -> Result<(), Error> {
    require(value >= 0.0 && value.is_finite(), quantity, "finite and not negative", value, "N/m")
}

impl Elasticity for ElasticLayer {
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        match self.stiffness {
            Stiffness::PerArea(_) => Ok(Box::new(self.on(grid)?)),
            // All stiffnesses per area go with the inverse square of the size.
            Stiffness::Discrete(_) => self.growing(grid, 2.0),
        }
    }
}

impl ElasticLayer {
    fn on(&self, grid: &Grid) -> Result<LayerCompliance, Error> {
        let surroundings = self.surroundings(grid)?;
        Ok(LayerCompliance::new(&self.per_area(grid), surroundings, *grid))
    }

    /// The layer on a grid, where its displacements go with a power of the grid's size.
    pub(super) fn growing(&self, grid: &Grid, power: f64) -> Result<Box<dyn Compliance>, Error> {
        Ok(Box::new(LayerCompliance { growth: Some(power), ..self.on(grid)? }))
    }
}

/// The layer on one grid.
pub struct LayerCompliance {
    grid: Grid,
    surroundings: Surroundings,
    couples_cells: bool,
    /// The power of the grid's size with which displacements go, dimensionless; if it is not that of
    /// stiffnesses per area that stay.
    growth: Option<f64>,
    components: [Component; 2],
    transform: Arc<dyn TransformType2And3<f64>>,
    scratch: Vec<f64>,
    spectrum: Vec<f64>,
}

/// One displacement component.
struct Component {
    /// Bedding of each wave number along x: c + g_x (2 − 2 cos(π k/N))/Δx², in N/m³.
    bedding: Vec<f64>,
    /// Coupling across rolling over Δy², in N/m³.
    coupling: f64,
    /// The systems along y, the rows beyond the grid condensed.
    condensed: Tridiagonal,
    /// What lies beyond the first and the last row, for each wave number, in N/m³; and how it grows
    /// with the logarithm of the grid's size.
    outside_by_size: Vec<f64>,
    /// Displacement of the outermost row over that of the first or the last row of the grid, for
    /// each wave number, dimensionless.
    to_edge: Vec<f64>,
    /// Bedding c alone, in N/m³.
    plain_bedding: f64,
}

impl Component {
    fn new(stiffness: &LayerStiffness, grid: &Grid, surroundings: &Surroundings) -> Self {
        let waves = surroundings.columns;
        let along = stiffness.coupling_along_x / grid.spacing_x.powi(2);
        let coupling = stiffness.coupling_along_y / grid.spacing_y.powi(2);
        let eigenvalue = |k: usize| 2.0 - 2.0 * (PI * k as f64 / waves as f64).cos();
        let bedding: Vec<f64> =
            (0..waves).map(|k| stiffness.bedding + along * eigenvalue(k)).collect();
        let chain = |b: &f64| {
            condensed(stiffness.bedding, b - stiffness.bedding, coupling, surroundings.rows_beyond)
        };
        let chains: Vec<Chain> = bedding.iter().map(chain).collect();
        let outside: Vec<f64> = chains.iter().map(|chain| chain.stiffness).collect();
        Self {
            condensed: Tridiagonal::new(&bedding, coupling, grid.rows, &outside),
            outside_by_size: chains.iter().map(|chain| chain.stiffness_by_size).collect(),
            to_edge: chains.iter().map(|chain| chain.to_edge).collect(),
            plain_bedding: stiffness.bedding,
            bedding,
            coupling,
        }
    }

    /// Minus the change of the stiffness with the logarithm of the grid's size, times the
    /// displacement of one row; `above` and `below` are those next to it, if there are.
    fn relief(&self, row: [&[f64]; 3], ends: usize, relief: &mut [f64]) {
        let [above, here, below] = row;
        let neighbours = usize::from(!above.is_empty()) + usize::from(!below.is_empty());
        for (wave, relief) in relief.iter_mut().enumerate() {
            let next_to =
                above.get(wave).copied().unwrap_or(0.0) + below.get(wave).copied().unwrap_or(0.0);
            let coupled = self.coupling * (neighbours as f64 * here[wave] - next_to);
            let bedded = (self.bedding[wave] - self.plain_bedding) * here[wave];
            let outside = ends as f64 * self.outside_by_size[wave] * here[wave];
            *relief = 2.0 * (bedded + coupled) - outside;
        }
    }
}

/// A chain of elements beyond a row.
#[derive(Debug, Clone, Copy)]
struct Chain {
    /// Stiffness that it adds to the row, in N/m³, and its change with the logarithm of the grid's size.
    stiffness: f64,
    stiffness_by_size: f64,
    /// Displacement of its end over that of the row, dimensionless.
    to_edge: f64,
}

/// The chain of `rows` elements, each on its bedding c + `along` and coupled by g to the next: from
/// the free end inwards s ← e g/(g + s), e = c + `along` + s. Both couplings go with the inverse square
/// of the size.
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

/// Factors of symmetric tridiagonal systems with the off-diagonal −`coupling`, one for each wave
/// number, side by side: row after row, each with all waves.
struct Tridiagonal {
    coupling: f64,
    inverse_pivot: Vec<f64>,
}

impl Tridiagonal {
    /// Systems of `rows` rows. `bedding` is the diagonal without the coupling between the rows,
    /// `outside` what lies beyond the first and the last one.
    fn new(bedding: &[f64], coupling: f64, rows: usize, outside: &[f64]) -> Self {
        let waves = bedding.len();
        let mut inverse_pivot = Vec::with_capacity(rows * waves);
        for row in 0..rows {
            let ends = usize::from(row == 0) + usize::from(row + 1 == rows);
            for wave in 0..waves {
                let mut pivot = bedding[wave] + (2 - ends) as f64 * coupling;
                pivot += ends as f64 * outside[wave];
                if row > 0 {
                    let above: f64 = inverse_pivot[(row - 1) * waves + wave];
                    pivot -= coupling * coupling * above;
                }
                inverse_pivot.push(pivot.recip());
            }
        }
        Self { coupling, inverse_pivot }
    }

    /// Solves all systems in place.
    fn solve(&self, values: &mut [f64], waves: usize) {
        let rows = values.len() / waves;
        for row in 1..rows {
            let (above, here) = values.split_at_mut(row * waves);
            let pivots = &self.inverse_pivot[(row - 1) * waves..row * waves];
            self.eliminate(&mut here[..waves], &above[(row - 1) * waves..], pivots);
        }
        for (value, pivot) in values.iter_mut().zip(&self.inverse_pivot) {
            *value *= pivot;
        }
        for row in (0..rows - 1).rev() {
            let (here, below) = values.split_at_mut((row + 1) * waves);
            let pivots = &self.inverse_pivot[row * waves..(row + 1) * waves];
            self.eliminate(&mut here[row * waves..], &below[..waves], pivots);
        }
    }

    fn eliminate(&self, here: &mut [f64], neighbour: &[f64], pivots: &[f64]) {
        for ((here, neighbour), pivot) in here.iter_mut().zip(neighbour).zip(pivots) {
            *here += self.coupling * pivot * neighbour;
        }
    }
}

impl LayerCompliance {
    fn new(stiffness: &[LayerStiffness; 2], surroundings: Surroundings, grid: Grid) -> Self {
        let transform = DctPlanner::new().plan_dct2(surroundings.columns);
        Self {
            grid,
            surroundings,
            couples_cells: stiffness
                .iter()
                .any(|s| s.coupling_along_x > 0.0 || s.coupling_along_y > 0.0),
            growth: None,
            components: stiffness.map(|s| Component::new(&s, &grid, &surroundings)),
            scratch: vec![0.0; transform.get_scratch_len()],
            spectrum: vec![0.0; surroundings.columns * grid.rows],
            transform,
        }
    }

    /// Traction of the grid's rows, on the columns of the total area, transformed along x.
    fn transform_rows(&mut self, traction: &[f64]) {
        let Surroundings { columns, first_column, .. } = self.surroundings;
        self.spectrum.fill(0.0);
        let rows = self.spectrum.chunks_exact_mut(columns);
        for (row, traction) in rows.zip(traction.chunks_exact(self.grid.columns)) {
            row[first_column..first_column + self.grid.columns].copy_from_slice(traction);
            self.transform.process_dct2_with_scratch(row, &mut self.scratch);
        }
    }

    fn component_displacement(&mut self, c: usize, traction: &[f64], displacement: &mut [f64]) {
        let columns = self.surroundings.columns;
        self.transform_rows(traction);
        self.components[c].condensed.solve(&mut self.spectrum, columns);
        self.transform_back(displacement);
    }

    /// From the spectrum to the displacement of the grid.
    fn transform_back(&mut self, displacement: &mut [f64]) {
        let Surroundings { columns, first_column, .. } = self.surroundings;
        let inverse = 2.0 / columns as f64;
        let rows = self.spectrum.chunks_exact_mut(columns);
        for (row, displacement) in rows.zip(displacement.chunks_exact_mut(self.grid.columns)) {
            self.transform.process_dct3_with_scratch(row, &mut self.scratch);
            for (u, value) in displacement.iter_mut().zip(&row[first_column..]) {
                *u = inverse * value;
            }
        }
    }

    /// −A (dC/d ln size) A t of one component, C being the stiffness.
    fn component_by_size(&mut self, c: usize, traction: &[f64], displacement: &mut [f64]) {
        let columns = self.surroundings.columns;
        self.transform_rows(traction);
        let component = &self.components[c];
        component.condensed.solve(&mut self.spectrum, columns);
        let rows = self.grid.rows;
        let mut relief = vec![0.0; self.spectrum.len()];
        for (j, relief) in relief.chunks_exact_mut(columns).enumerate() {
            let row = |j: usize| &self.spectrum[j * columns..(j + 1) * columns];
            let above = if j > 0 { row(j - 1) } else { &[] };
            let below = if j + 1 < rows { row(j + 1) } else { &[] };
            let ends = usize::from(j == 0) + usize::from(j + 1 == rows);
            component.relief([above, row(j), below], ends, relief);
        }
        component.condensed.solve(&mut relief, columns);
        self.spectrum = relief;
        self.transform_back(displacement);
    }

    /// One component of the displacement in the grid's rows, on all columns of the total area, and
    /// after them the two outermost rows of that.
    fn rows_and_edges(&mut self, c: usize, traction: &[f64]) -> Vec<f64> {
        let columns = self.surroundings.columns;
        self.transform_rows(traction);
        let component = &self.components[c];
        component.condensed.solve(&mut self.spectrum, columns);
        let mut values = self.spectrum.clone();
        let last = self.spectrum.len() - columns;
        for row in [0, last] {
            let row = &self.spectrum[row..row + columns];
            values.extend(row.iter().zip(&component.to_edge).map(|(u, share)| u * share));
        }
        let inverse = 2.0 / columns as f64;
        for row in values.chunks_exact_mut(columns) {
            self.transform.process_dct3_with_scratch(row, &mut self.scratch);
            for u in row {
                *u *= inverse;
            }
        }
        values
    }

    /// One component of the displacement on the total area, row after row, in m; without
    /// condensation.
    pub fn total_displacement(&mut self, component: usize, traction: &[f64]) -> Vec<f64> {
        let Surroundings { columns, rows_beyond, .. } = self.surroundings;
        self.transform_rows(traction);
        let mut values = vec![0.0; rows_beyond * columns];
        values.extend_from_slice(&self.spectrum);
        values.resize(values.len() + rows_beyond * columns, 0.0);
        let rows = values.len() / columns;
        let Component { bedding, coupling, .. } = &self.components[component];
        let free = vec![0.0; columns];
        Tridiagonal::new(bedding, *coupling, rows, &free).solve(&mut values, columns);
        for row in values.chunks_exact_mut(columns) {
            self.transform.process_dct3_with_scratch(row, &mut self.scratch);
        }
        let inverse = 2.0 / columns as f64;
        for u in &mut values {
            *u *= inverse;
        }
        values
    }
}

impl Compliance for LayerCompliance {
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
        self.component_displacement(0, &traction.x, &mut displacement.x);
        self.component_displacement(1, &traction.y, &mut displacement.y);
    }

    fn displacement_by_size(
        &mut self,
        traction: &VectorField,
        displacement: &mut VectorField,
    ) -> bool {
        if let Some(power) = self.growth {
            self.displacement(traction, displacement);
            for u in displacement.x.iter_mut().chain(&mut displacement.y) {
                *u *= power;
            }
        } else {
            self.component_by_size(0, &traction.x, &mut displacement.x);
            self.component_by_size(1, &traction.y, &mut displacement.y);
        }
        true
    }

    fn couples_cells(&self) -> bool {
        self.couples_cells
    }

    fn is_short_ranged(&self) -> bool {
        true
    }

    fn edge_displacement(&mut self, traction: &VectorField) -> f64 {
        if !self.couples_cells {
            return 0.0;
        }
        let columns = self.surroundings.columns;
        let x = self.rows_and_edges(0, &traction.x);
        let y = self.rows_and_edges(1, &traction.y);
        let magnitude = |k: usize| x[k].hypot(y[k]);
        let inside = self.grid.rows * columns;
        let is_edge =
            |k: usize| k >= inside || k.is_multiple_of(columns) || (k + 1).is_multiple_of(columns);
        let largest = (0..inside).map(magnitude).fold(0.0, f64::max);
        let at_edge = (0..x.len()).filter(|k| is_edge(*k)).map(magnitude).fold(0.0, f64::max);
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
    use super::*;
    use crate::grid::Extent;
    use approx::assert_relative_eq;

    fn layer() -> LayerStiffness {
        LayerStiffness { bedding: 1e13, coupling_along_x: 3.24e7, coupling_along_y: 2e7 }
    }

    fn grid() -> Grid {
        Grid::across(&Extent { x: [-6e-3, 6e-3], y: [-5e-3, 5e-3] }, 12, 9)
    }

    fn compliance(margin: f64) -> LayerCompliance {
        let elastic = ElasticLayer::new(layer(), layer(), Some(margin)).unwrap();
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
        let mut u = VectorField::zeros(grid.len());
        compliance.displacement(&traction, &mut u);
        let total = compliance.total_displacement(0, &traction.x);
        let Surroundings { columns, first_column, rows_beyond } = compliance.surroundings;
        for j in 0..grid.rows {
            for i in 0..grid.columns {
                let there = total[(j + rows_beyond) * columns + i + first_column];
                assert_relative_eq!(
                    u.x[grid.index(i, j)],
                    there,
                    max_relative = 1e-10,
                    epsilon = 1e-18
                );
            }
        }
    }

    /// Constant traction on the total area of a free-edged lattice moves it by t/c everywhere.
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

    /// The paper's springs on a grid are the layer's stiffnesses per area of that grid.
    #[test]
    fn neuhaus_sextro_2014_discrete_springs() {
        let grid = grid();
        let area = grid.cell_area();
        let springs = Springs { bedding: 1e13 * area, coupling: 3e7 };
        let layer = ElasticLayer::from_springs(springs, springs, None).unwrap().per_area(&grid);
        assert_relative_eq!(layer[0].bedding, 1e13, max_relative = 1e-14);
        let ratio = grid.spacing_x / grid.spacing_y;
        assert_relative_eq!(layer[1].coupling_along_x, 3e7 * ratio, max_relative = 1e-14);
        assert_relative_eq!(layer[1].coupling_along_y, 3e7 / ratio, max_relative = 1e-14);
    }
}
