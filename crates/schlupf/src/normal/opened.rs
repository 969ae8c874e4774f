//! Normal contact of surfaces that tractions, or their own delayed displacement, have moved apart.

use std::sync::Arc;

use super::patch::Patch;
use super::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use super::{Extent, Grid, NormalContact, NormalSummary, Pressure, PressureSource, PressureTable};
use crate::reporting::{Error, Quantity, Warning, Watch};
use crate::surface::{HeightMap, Lattice};

/// Rim around the contact of the same bodies without tractions, relative to its sides: the contact
/// changes its size by less.
const RIM: f64 = 0.25;

const SOLVING: RoughContactOptions = RoughContactOptions { tolerance: 1e-8, max_iterations: 1000 };

/// The bodies of a pressure source under its load with their surfaces farther apart.
#[derive(Debug)]
pub(crate) struct Opened {
    source: Arc<dyn PressureSource>,
    cells: Cells,
    contact: NormalContact,
    /// On the cells, in Pa.
    pressure: Vec<f64>,
    touches_edge: bool,
}

/// Cells in and around a contact, in its frame.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cells {
    pub grid: Grid,
    /// Middles of the columns, in m.
    pub x: Vec<f64>,
    /// Middles of the rows, in m.
    pub y: Vec<f64>,
}

impl Cells {
    /// Those around a contact that has so many across it in each direction; a line has one row.
    fn around(contact: &NormalContact, across: usize) -> Self {
        let (extent, is_line) = (contact.extent(), contact.is_line());
        let columns = (across as f64 * (1.0 + 2.0 * RIM)) as usize;
        let line = |[from, to]: [f64; 2]| {
            let length = (1.0 + 2.0 * RIM) * (to - from);
            [0.5 * (from + to - length), length / columns as f64]
        };
        let [origin_x, spacing_x] = line(extent.x);
        let (rows, [origin_y, spacing_y]) = match extent.y {
            [from, to] if is_line => (1, [from, to - from]),
            across => (columns, line(across)),
        };
        let grid = Grid { columns, rows, spacing_x, spacing_y, origin_x, origin_y };
        let x = (0..columns).map(|i| grid.x(i)).collect();
        let y = (0..rows).map(|j| grid.y(j)).collect();
        Self { grid, x, y }
    }
}

impl Opened {
    /// The bodies as they are, with their contact modulus E* (in Pa); `None` if their undeformed
    /// distance is not known.
    ///
    /// # Errors
    /// As [`PressureSource::normal_contact`], a contact that is not found, and [`Error::Stopped`].
    pub fn new(
        source: &Arc<dyn PressureSource>,
        contact_modulus: f64,
        watch: Watch,
    ) -> Result<Option<Self>, Error> {
        let Some(around) = Self::around(source)? else { return Ok(None) };
        let opening = vec![0.0; around.cells.grid.len()];
        around.by(&opening, contact_modulus, watch).map(Some)
    }

    /// The pressure of the source on cells around its contact; `None` as in [`Self::new`].
    ///
    /// # Errors
    /// As [`PressureSource::normal_contact`].
    pub fn around(source: &Arc<dyn PressureSource>) -> Result<Option<Self>, Error> {
        let found = Self::on_cells(source, &source.normal_contact(None)?);
        let Cells { x, y, .. } = &found.cells;
        Ok(source.undeformed_distance(x, y).is_some().then_some(found))
    }

    /// The same pressure on cells around its contact.
    pub fn on_cells_around(&self) -> Self {
        Self::on_cells(&self.source, &self.contact)
    }

    fn on_cells(source: &Arc<dyn PressureSource>, contact: &NormalContact) -> Self {
        let (source, contact) = (Arc::clone(source), contact.clone());
        let cells = Cells::around(&contact, source.cells());
        let mut pressure = vec![0.0; cells.grid.len()];
        for cell in &Patch::new(&contact, cells.grid).cells {
            pressure[cell.index] = cell.pressure;
        }
        Self { source, cells, contact, pressure, touches_edge: false }
    }

    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The pressure on the cells, in Pa.
    pub fn pressure(&self) -> &[f64] {
        &self.pressure
    }

    /// The approach of the bodies, in m.
    pub fn approach(&self) -> f64 {
        self.contact.summary.approach.unwrap_or_default()
    }

    /// Largest difference of two openings (in m) where there is pressure, apart from its mean, over
    /// the approach; dimensionless.
    pub fn change(&self, [before, now]: [&[f64]; 2]) -> f64 {
        let loaded = self.pressure.iter().zip(before.iter().zip(now));
        let loaded = loaded.filter(|(pressure, _)| **pressure > 0.0);
        let differences: Vec<f64> = loaded.map(|(_, (before, now))| now - before).collect();
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        let largest = differences.iter().map(|d| (d - mean).abs()).fold(0.0, f64::max);
        largest / self.approach()
    }

    /// Whether the contact reaches the outer cells.
    pub fn touches_edge(&self) -> bool {
        self.touches_edge
    }

    /// Refuses a contact that extends to where the undeformed distance is not known.
    ///
    /// # Errors
    /// [`Error::ContactAtEdge`].
    pub fn refuse_unknown_distance(&self) -> Result<(), Error> {
        let [known_x, known_y] = self.source.distance_bounds();
        let Extent { x, y } = self.contact.extent();
        let axes = [('x', known_x, x), ('y', known_y, y)];
        for (axis, known, found) in axes.into_iter().take(2 - usize::from(self.contact.is_line())) {
            let ends = [found[0] <= known[0], found[1] >= known[1]];
            if let Some(end) = ends.iter().position(|is_there| *is_there) {
                let NormalSummary { load, origin, .. } = self.contact.summary;
                let origin = origin.unwrap_or_default()[usize::from(axis == 'y')];
                return Err(Error::ContactAtEdge { load, axis, edge: known[end] + origin });
            }
        }
        Ok(())
    }

    /// The same bodies with an opening (in m) on the cells.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn by(&self, opening: &[f64], contact_modulus: f64, watch: Watch) -> Result<Self, Error> {
        let opened = self.up_to_edge(opening, contact_modulus, watch)?;
        if opened.touches_edge {
            let [x, y] = [&self.cells.x, &self.cells.y].map(|line| [line[0], line[line.len() - 1]]);
            return Err(Error::ContactNotFound { rounds: 1, x, y });
        }
        Ok(opened)
    }

    /// The same, which may touch the edge of the cells.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn up_to_edge(
        &self,
        opening: &[f64],
        contact_modulus: f64,
        watch: Watch,
    ) -> Result<Self, Error> {
        let Cells { grid, x, y } = &self.cells;
        let distance = self.source.undeformed_distance(x, y).unwrap_or_default();
        let lowest = distance.iter().copied().fold(f64::INFINITY, f64::min);
        let distance = distance.iter().zip(opening).map(|(d, opening)| d + opening).collect();
        let Grid { columns, rows, spacing_x, spacing_y, .. } = *grid;
        let lattice = Lattice { columns, rows, spacing_x, spacing_y };
        let is_line = rows == 1;
        let map = if is_line {
            HeightMap::row(lattice, distance)
        } else {
            HeightMap::new(lattice, distance)?
        };
        let opened = map.range()[0] - lowest;
        let mut bodies = RoughContact::new(map, contact_modulus, Boundary::Free)?
            .starting_from(self.pressure.clone());
        let before = &self.contact.summary;
        let solution = bodies.solve(before.load, &SOLVING, watch)?;
        if !solution.is_converged {
            return Err(Error::NormalNotConverged {
                quantity: Quantity::Elasticity,
                iterations: solution.iterations,
                residual: solution.residual,
                tolerance: SOLVING.tolerance,
            });
        }
        // The frame of the contact stays.
        let table = if is_line {
            // Two rows that are half as wide.
            let aside = 0.25 * spacing_y;
            PressureTable::where_it_is(
                x,
                &[y[0] - aside, y[0] + aside],
                solution.pressure.repeat(2),
            )
        } else {
            PressureTable::where_it_is(x, y, solution.pressure.clone())
        }?;
        let extent = table.extent();
        let half = |[from, to]: [f64; 2]| 0.5 * (to - from);
        let summary = NormalSummary {
            semi_axis_x: half(extent.x),
            semi_axis_y: half(extent.y),
            peak_pressure: table.peak(),
            approach: Some(solution.approach + opened),
            parts: table.parts(),
            ..*before
        };
        Ok(Self {
            source: Arc::clone(&self.source),
            cells: self.cells.clone(),
            contact: NormalContact {
                summary,
                pressure: Pressure::Tabulated(Arc::new(table), 1.0),
                rows: self.contact.rows.clone(),
            },
            pressure: solution.pressure,
            touches_edge: solution.touches_edge,
        })
    }
}

impl PressureSource for Opened {
    /// Under another load the surfaces are where the source has them.
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        match load.filter(|load| *load != self.contact.summary.load) {
            Some(load) => self.source.normal_contact(Some(load)),
            None => Ok(self.contact.clone()),
        }
    }

    fn load_exponent(&self) -> Option<f64> {
        None
    }

    fn caveat(&self) -> Option<Warning> {
        self.source.caveat()
    }
}
