//! Pressure from the shape of both bodies: a wheel's profile over that of a rail, new or worn.
//!
//! The undeformed distance h(x, y) of the bodies and their load N or their approach δ define a
//! normal contact of two elastic half-spaces, gap = h + u − δ ≥ 0, p ≥ 0, gap p = 0, ∫ p dA = N,
//! which [`super::rough_contact`] solves on cells. The approach is that since the first contact.
//! The patch may have any shape and several separate parts.
//!
//! The contact is first located on a coarse lattice, starting from a rectangle that is certain to
//! contain it; then it is solved on a lattice of [`Profile::DEFAULT_CELLS`] cells across it, along
//! x and y. The pressure on that lattice is used as a [`PressureTable`]. For a Hertzian contact
//! with the default, semi-axes, peak pressure, approach and creep forces are within 0.3 % of the
//! exact ones.
//!
//! The origin of the contact frame is the centre of the bounding rectangle of the patch under the
//! source's own load, and does not move when the load changes. Semi-axes are half the sides of that
//! rectangle.
//!
//! Limits: half-spaces, and one tangent plane for all parts of the patch (no flange with a steep
//! contact angle, no conformal contact in the flange root). Between the points of a file the
//! distance is cubic; its roughness and rounding are part of the shape, and affect the pressure: a
//! wave of amplitude Δ and length λ makes one of π E* Δ/λ.
//!
//! Contacts are cached, because a problem is asked for its patch many times. A change of
//! the load changes the shape, so the contact is recomputed instead of scaled (there is no
//! `growth`).

mod interpolation;
mod distance;
mod search;

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::hertz::curvature_sum;
use super::tabulated::PressureTable;
use super::{NormalContact, NormalSummary, Pressure, PressureSource};
use crate::normal::Extent;
use crate::reporting::{
    Error, Quantity, Requirement, Warning, Watch, require, require_positive, unwatched,
};

pub use distance::UndeformedDistance;

use search::{Held, Search, Solved};

/// Minimum number of points of the distance across each part of a patch, needed to resolve its
/// shape.
const FEWEST_POINTS: usize = 7;

/// Contact of two bodies of given shape under a load, or at an approach.
#[derive(Debug)]
pub struct Profile {
    distance: UndeformedDistance,
    contact_modulus: f64,
    held: Held,
    cells: usize,
    /// Solved contacts, the latest last.
    solved: Mutex<Vec<Placed>>,
}

/// A solved contact in the coordinates of the distance.
#[derive(Debug, Clone)]
struct Placed {
    load: f64,
    approach: f64,
    extent: Extent,
    table: Arc<PressureTable>,
}

/// Number of contacts kept for a history that returns to earlier loads.
const KEPT: usize = 256;

/// Range of the number of cells across a contact: fewer do not resolve its shape, more take too
/// long.
const CELLS_RANGE: [usize; 2] = [16, 512];

impl Profile {
    /// Number of cells across the contact in each direction that is sufficient for a smooth
    /// profile.
    pub const DEFAULT_CELLS: usize = 128;

    /// A contact with the undeformed distance, the contact modulus E* (in Pa), the load (in N), and
    /// the number of cells across the contact in each direction for the solution.
    ///
    /// ```
    /// use schlupf::normal::PressureSource;
    /// use schlupf::normal::profile::{Profile, UndeformedDistance};
    ///
    /// let y: Vec<f64> = (-80..=80).map(|k| 1e-4 * f64::from(k)).collect();
    /// let sphere = y.iter().map(|y| y * y / (2.0 * 0.3)).collect();
    /// let distance = UndeformedDistance::across(y, sphere, 0.3)?;
    /// let contact = Profile::new(distance, 115e9, 20e3, 32)?.normal_contact(None)?.summary;
    /// let hertz = (0.75_f64 * 20e3 * 0.3 / 115e9).cbrt();
    /// assert!((contact.semi_axis_x / hertz - 1.0).abs() < 0.05);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(
        distance: UndeformedDistance,
        contact_modulus: f64,
        load: f64,
        cells: usize,
    ) -> Result<Self, Error> {
        require_positive(Quantity::Load, load)?;
        Self::at(distance, contact_modulus, Held::Load(load), cells)
    }

    /// The same at an approach (in m) in place of a load.
    pub fn from_approach(
        distance: UndeformedDistance,
        contact_modulus: f64,
        approach: f64,
        cells: usize,
    ) -> Result<Self, Error> {
        require_positive(Quantity::Approach, approach)?;
        Self::at(distance, contact_modulus, Held::Approach(approach), cells)
    }

    fn at(
        distance: UndeformedDistance,
        contact_modulus: f64,
        held: Held,
        cells: usize,
    ) -> Result<Self, Error> {
        require_positive(Quantity::WheelYoungModulus, contact_modulus)?;
        let [least, most] = CELLS_RANGE;
        let range = Requirement::Between(least as f64, most as f64);
        require(Quantity::NormalCells, range, cells as f64)?;
        Ok(Self { distance, contact_modulus, held, cells, solved: Mutex::default() })
    }

    fn contact(&self, held: Held, watch: Watch) -> Result<Placed, Error> {
        let is_it = |contact: &&Placed| match held {
            Held::Load(load) => contact.load == load,
            Held::Approach(approach) => contact.approach == approach,
        };
        let known = self.kept().iter().find(is_it).cloned();
        if let Some(contact) = known {
            return Ok(contact);
        }
        let search = Search {
            distance: &self.distance,
            contact_modulus: self.contact_modulus,
            held,
            cells: self.cells,
            watch,
        };
        let contact = placed(search.solve()?)?;
        let mut kept = self.kept();
        if kept.len() >= KEPT {
            kept.remove(0);
        }
        kept.push(contact.clone());
        Ok(contact)
    }

    fn kept(&self) -> MutexGuard<'_, Vec<Placed>> {
        // Entries are inserted and removed as a whole, so a panic elsewhere leaves nothing half
        // done.
        self.solved.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// 1/R = 1/R_wheel + 1/R_rail (in m) from the radii along rolling of wheel and rail (in m):
/// positive if convex, negative if concave, infinite if flat.
///
/// ```
/// use schlupf::normal::profile::relative_radius;
///
/// // A wheel on a straight rail.
/// assert_eq!(relative_radius([0.46, f64::INFINITY])?, 0.46);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn relative_radius(radii: [f64; 2]) -> Result<f64, Error> {
    let radii = [(Quantity::WheelRadiusX, radii[0]), (Quantity::RailRadiusX, radii[1])];
    let curvature = curvature_sum(radii)?;
    Ok(curvature.recip())
}

fn placed(solved: Solved) -> Result<Placed, Error> {
    let Solved { x, y, pressure, load, approach } = solved;
    let table = PressureTable::where_it_is(&x, &y, pressure)?;
    Ok(Placed { load, approach, extent: table.extent(), table: Arc::new(table) })
}

impl PressureSource for Profile {
    fn normal_contact(&self, load: Option<f64>) -> Result<NormalContact, Error> {
        if let Some(load) = load {
            require_positive(Quantity::Load, load)?;
        }
        let own = self.contact(self.held, &unwatched)?.extent;
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let origin = [middle(own.x), middle(own.y)];
        let held = load.map_or(self.held, Held::Load);
        let Placed { load, approach, extent, table } = self.contact(held, &unwatched)?;
        let half = |[from, to]: [f64; 2]| 0.5 * (to - from);
        let summary = NormalSummary {
            load,
            semi_axis_x: half(extent.x),
            semi_axis_y: half(extent.y),
            peak_pressure: table.peak(),
            approach: Some(approach),
            origin: Some(origin),
            parts: table.parts(),
        };
        let table = Arc::new(table.seen_from(origin));
        let pressure = Pressure::Tabulated(table, 1.0);
        Ok(NormalContact { summary, pressure, rows: None })
    }

    fn prepare(&self, load: Option<f64>, watch: Watch) -> Result<(), Error> {
        for held in [self.held, load.map_or(self.held, Held::Load)] {
            self.contact(held, watch)?;
        }
        Ok(())
    }

    /// Beyond the given points it rises steeply: the contact does not reach there.
    fn undeformed_distance(&self, x: &[f64], y: &[f64]) -> Option<Vec<f64>> {
        let [middle_x, middle_y] = self.normal_contact(None).ok()?.summary.origin?;
        let [along, across] = self.distance.bounds();
        let within = |line: &[f64], middle: f64, [from, to]: [f64; 2]| -> [Vec<f64>; 2] {
            let at = line.iter().map(|at| at + middle);
            let kept = at.clone().map(|at| at.clamp(from, to));
            let beyond = at.zip(kept.clone()).map(|(at, kept)| (at - kept).abs());
            [kept.collect(), beyond.collect()]
        };
        let [x, beyond_x] = within(x, middle_x, along);
        let [y, beyond_y] = within(y, middle_y, across);
        let beyond = beyond_y.iter().flat_map(|y| beyond_x.iter().map(move |x| x + y));
        let distance = self.distance.sample(&x, &y);
        Some(distance.iter().zip(beyond).map(|(d, beyond)| d + beyond).collect())
    }

    fn distance_bounds(&self) -> [[f64; 2]; 2] {
        let origin = self.normal_contact(None).ok().and_then(|contact| contact.summary.origin);
        let (bounds, origin) = (self.distance.bounds(), origin.unwrap_or_default());
        [0, 1].map(|c| bounds[c].map(|end| end - origin[c]))
    }

    fn cells(&self) -> usize {
        self.cells
    }

    fn load_exponent(&self) -> Option<f64> {
        None
    }

    fn caveat(&self) -> Option<Warning> {
        let own = self.contact(self.held, &unwatched).ok()?;
        let parts = own.table.parts();
        let across = self.distance.points_within(&own.extent);
        let fewest = across.into_iter().min()?;
        let is_coarse = fewest < FEWEST_POINTS * parts;
        let (points, fewest) = (fewest, FEWEST_POINTS);
        is_coarse.then_some(Warning::CoarseDistance { points, parts, fewest })
    }
}
