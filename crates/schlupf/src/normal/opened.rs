//! Normal contact of surfaces that tangential tractions have moved apart.

use std::sync::Arc;

use super::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use super::{Extent, Grid, NormalContact, NormalSummary, Pressure, PressureSource, PressureTable};
use crate::reporting::{Error, Warning, Watch};
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
    /// Those around a contact that has so many across it in each direction.
    fn around(extent: &Extent, across: usize) -> Self {
        let columns = (across as f64 * (1.0 + 2.0 * RIM)) as usize;
        let line = |[from, to]: [f64; 2]| {
            let length = (1.0 + 2.0 * RIM) * (to - from);
            [0.5 * (from + to - length), length / columns as f64]
        };
        let ([origin_x, spacing_x], [origin_y, spacing_y]) = (line(extent.x), line(extent.y));
        let grid = Grid { columns, rows: columns, spacing_x, spacing_y, origin_x, origin_y };
        let x = (0..columns).map(|i| grid.x(i)).collect();
        let y = (0..columns).map(|j| grid.y(j)).collect();
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
        let contact = source.normal_contact(None)?;
        let cells = Cells::around(&contact.extent(), source.cells());
        if source.undeformed_distance(&cells.x, &cells.y).is_none() {
            return Ok(None);
        }
        let (source, opening) = (Arc::clone(source), vec![0.0; cells.grid.len()]);
        let as_they_are = Self { source, cells, contact, pressure: Vec::new() };
        as_they_are.by(&opening, contact_modulus, watch).map(Some)
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

    /// The same bodies with an opening (in m) on the cells.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn by(&self, opening: &[f64], contact_modulus: f64, watch: Watch) -> Result<Self, Error> {
        let Cells { grid, x, y } = &self.cells;
        let distance = self.source.undeformed_distance(x, y).unwrap_or_default();
        let distance = distance.iter().zip(opening).map(|(d, opening)| d + opening).collect();
        let Grid { columns, rows, spacing_x, spacing_y, .. } = *grid;
        let map = HeightMap::new(Lattice { columns, rows, spacing_x, spacing_y }, distance)?;
        let mut bodies = RoughContact::new(map, contact_modulus, Boundary::Free)?
            .starting_from(self.pressure.clone());
        let before = &self.contact.summary;
        let solution = bodies.solve(before.load, &SOLVING, watch)?;
        if !solution.is_converged {
            return Err(Error::NormalNotConverged {
                iterations: solution.iterations,
                residual: solution.residual,
                tolerance: SOLVING.tolerance,
            });
        }
        if solution.touches_edge {
            let [x, y] = [x, y].map(|line| [line[0], line[line.len() - 1]]);
            return Err(Error::ContactNotFound { rounds: 1, x, y });
        }
        // The frame of the contact stays.
        let table = PressureTable::where_it_is(x, y, solution.pressure.clone())?;
        let extent = table.extent();
        let half = |[from, to]: [f64; 2]| 0.5 * (to - from);
        let summary = NormalSummary {
            semi_axis_x: half(extent.x),
            semi_axis_y: half(extent.y),
            peak_pressure: table.peak(),
            approach: Some(solution.approach),
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
