//! Normal contact of two elastic bodies of arbitrary shape: rough surfaces, or profiles of wheel
//! and rail.
//!
//! With the undeformed distance h(x, y), the displacement u = S p of both bodies and the approach
//! δ,
//!
//! gap g = h + u − δ ≥ 0,  p ≥ 0,  g p = 0,  ∫ p dA = N.
//!
//! This is the minimum of ½ pᵀSp + pᵀh under p ≥ 0 and the load, found by constrained conjugate
//! gradients (Polonsky and Keer 1999, Wear 231, 206), which are preconditioned (Vollebregt 2014, J.
//! Tribol. 136, 021402) and continued when the contact changes; see `conjugate_gradients.rs`. With
//! a hardness H also p ≤ H, and where p = H the material yields, −g being the flattened depth
//! (elastic–perfectly plastic cut-off; Almqvist et al. 2007, J. Tribol. 129, 306).
//!
//! Limits: half-spaces, small slopes, no friction in the normal problem.

mod area;
mod compliance;
mod conjugate_gradients;

use crate::reporting::{Error, Quantity, SurfaceError, Watch, require_positive};
use crate::surface::{HeightMap, Lattice};

pub(crate) use compliance::Curved;
use compliance::NormalCompliance;
use conjugate_gradients::{Equilibrium, Held, Outcome};

/// Surroundings of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Boundary {
    /// Periodic repetition: a piece of a large rough surface.
    Periodic,
    /// Nothing: a complete contact, such as a sphere or the patch of wheel and rail.
    Free,
}

/// Accuracy of the solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughContactOptions {
    /// Relative error of the energy, dimensionless; in practice also that of the pressure.
    pub tolerance: f64,
    /// Maximum number of iterations.
    pub max_iterations: usize,
}

impl Default for RoughContactOptions {
    fn default() -> Self {
        Self { tolerance: 1e-6, max_iterations: 500 }
    }
}

/// Two bodies that can be pressed together. Each solution starts from the previous one.
#[derive(Debug)]
pub struct RoughContact {
    distance: HeightMap,
    contact_modulus: f64,
    boundary: Boundary,
    hardness: f64,
    compliance: NormalCompliance,
    /// The last pressure; initially empty.
    pressure: Vec<f64>,
}

/// A solved normal contact. Fields are stored row by row, like the heights.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct RoughContactSolution {
    /// Whether the residual is below the tolerance.
    pub is_converged: bool,
    /// Duality gap divided by the elastic energy, dimensionless: it bounds the error of the energy.
    pub residual: f64,
    /// Iterations.
    pub iterations: usize,
    /// Products with the compliance or its approximate inverse.
    pub products: usize,
    /// Normal load N, in N.
    pub load: f64,
    /// Pressure, in Pa.
    pub pressure: Vec<f64>,
    /// Gap, in m; zero in contact, zero or negative where the material yields.
    pub gap: Vec<f64>,
    /// Approach of the bodies since first contact, in m: of distant points, or of the mean planes
    /// of a periodic surface.
    pub approach: f64,
    /// Mean gap, in m: the distance between the mean planes.
    pub mean_gap: f64,
    /// Area of all cells in contact, in m².
    pub contact_area: f64,
    /// The same corrected for the cells on the edge of the spots, in m² (Yastrebov et al. 2017).
    pub corrected_contact_area: f64,
    /// Area of all cells that yield, in m².
    pub plastic_area: f64,
    /// Whether the contact reaches the edge of the lattice, where free boundaries truncate it.
    pub touches_edge: bool,
}

impl RoughContact {
    /// Two bodies with the undeformed distance (see [`HeightMap::distance_to_plane`]) and the
    /// contact modulus E* (in Pa, see [`crate::bodies::contact_modulus`]).
    ///
    /// ```
    /// use schlupf::normal::rough_contact::{Boundary, RoughContact};
    /// use schlupf::solver::reference::Westergaard;
    /// use schlupf::surface::{HeightMap, Lattice};
    ///
    /// let wave = Westergaard { amplitude: 1e-6, wavelength: 1e-3, contact_modulus: 115e9 };
    /// let height = |x: f64| wave.amplitude * (std::f64::consts::TAU * x / wave.wavelength).cos();
    /// let surface = HeightMap::from_fn(Lattice::square(64, 1e-3), |x, _| height(x))?;
    /// let distance = surface.into_periodic().distance_to_plane();
    /// let mut contact = RoughContact::new(distance, 115e9, Boundary::Periodic)?;
    /// let mean_pressure = 0.3 * wave.closing_pressure();
    /// let pressed =
    ///     contact.press(mean_pressure, &Default::default(), &schlupf::unwatched)?;
    /// let exact = 1e-6 * wave.contact_fraction(0.3 * wave.closing_pressure());
    /// assert!((pressed.contact_area / exact - 1.0).abs() < 0.1);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn new(
        distance: HeightMap,
        contact_modulus: f64,
        boundary: Boundary,
    ) -> Result<Self, Error> {
        require_positive(Quantity::WheelYoungModulus, contact_modulus)?;
        if boundary == Boundary::Periodic {
            // Otherwise nothing determines where such a contact carries.
            distance.require_rough()?;
        }
        let compliance = NormalCompliance::new(distance.lattice(), contact_modulus, boundary);
        let (hardness, pressure) = (f64::INFINITY, Vec::new());
        Ok(Self { distance, contact_modulus, boundary, hardness, compliance, pressure })
    }

    /// The same with an upper limit of the pressure: the hardness H of the softer body, in Pa.
    pub fn with_hardness(self, hardness: f64) -> Result<Self, Error> {
        if !hardness.is_infinite() || hardness < 0.0 {
            require_positive(Quantity::Hardness, hardness)?;
        }
        Ok(Self { hardness, ..self })
    }

    /// The same on a surface that is curved across.
    pub(crate) fn curved(self, curved: Curved) -> Self {
        let how = (self.boundary, curved);
        let compliance =
            NormalCompliance::curved(self.distance.lattice(), self.contact_modulus, how);
        Self { compliance, ..self }
    }

    /// The same with a pressure on its cells (in Pa) from which its solution starts, or without one
    /// if that is empty.
    pub(crate) fn starting_from(self, pressure: Vec<f64>) -> Self {
        Self { pressure, ..self }
    }

    /// The undeformed distance.
    pub fn distance(&self) -> &HeightMap {
        &self.distance
    }

    /// Combined modulus E*, in Pa.
    pub fn contact_modulus(&self) -> f64 {
        self.contact_modulus
    }

    /// The hardness, in Pa; infinite for elastic bodies.
    pub fn hardness(&self) -> f64 {
        self.hardness
    }

    /// The bodies after a solution: flattened where they yielded, and elastic, because no load up
    /// to the same one makes them yield again.
    pub fn flattened(&self, solution: &RoughContactSolution) -> Result<Self, Error> {
        let depth = |cell: usize| {
            let has_yielded = solution.pressure[cell] >= self.hardness;
            if has_yielded { -solution.gap[cell] } else { 0.0 }
        };
        let heights = self.distance.heights().iter().enumerate();
        let heights = heights.map(|(cell, height)| height + depth(cell)).collect();
        let distance = HeightMap::new(*self.distance.lattice(), heights)?;
        let contact = Self::new(distance, self.contact_modulus, self.boundary)?;
        Ok(Self { pressure: solution.pressure.clone(), ..contact })
    }

    /// The surroundings of the surface.
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// Presses the bodies together with a mean pressure over the whole lattice, in Pa.
    pub fn press(
        &mut self,
        mean_pressure: f64,
        options: &RoughContactOptions,
        watch: Watch,
    ) -> Result<RoughContactSolution, Error> {
        require_positive(Quantity::MeanPressure, mean_pressure)?;
        self.solve(mean_pressure * self.distance.lattice().area(), options, watch)
    }

    /// Presses the bodies together with a load, in N.
    pub fn solve(
        &mut self,
        load: f64,
        options: &RoughContactOptions,
        watch: Watch,
    ) -> Result<RoughContactSolution, Error> {
        require_positive(Quantity::Load, load)?;
        require_positive(Quantity::Tolerance, options.tolerance)?;
        let largest = self.hardness * self.distance.lattice().area();
        if load >= largest {
            return Err(SurfaceError::BeyondHardness { load, largest }.into());
        }
        let mean_pressure = load / self.distance.lattice().area();
        let mut equilibrium = Equilibrium {
            distance: self.distance.heights(),
            held: Held::Total(load / self.distance.lattice().cell_area()),
            hardness: self.hardness,
            compliance: &mut self.compliance,
        };
        let start = if self.pressure.is_empty() {
            vec![mean_pressure; self.distance.lattice().len()]
        } else {
            std::mem::take(&mut self.pressure)
        };
        let outcome = equilibrium.solve(start, options, watch)?;
        self.pressure.clone_from(&outcome.pressure);
        Ok(self.solution(load, outcome, options))
    }

    /// Presses the bodies together until the undeformed distance has become `level` (in m) where
    /// they are in contact: their approach is the level minus the least distance. The load follows.
    ///
    /// # Errors
    /// A level at which they do not touch, and [`Error::Stopped`].
    pub(crate) fn solve_at_level(
        &mut self,
        level: f64,
        options: &RoughContactOptions,
        watch: Watch,
    ) -> Result<RoughContactSolution, Error> {
        require_positive(Quantity::Approach, level - self.distance.range()[0])?;
        require_positive(Quantity::Tolerance, options.tolerance)?;
        // An overlap is opened by some such pressure.
        let stiffness = self.contact_modulus / self.distance.lattice().area().sqrt();
        let overlap = |h: &f64| (stiffness * (level - h)).clamp(0.0, self.hardness);
        let start = self.distance.heights().iter().map(overlap).collect();
        let mut equilibrium = Equilibrium {
            distance: self.distance.heights(),
            held: Held::Level(level),
            hardness: self.hardness,
            compliance: &mut self.compliance,
        };
        let outcome = equilibrium.solve(start, options, watch)?;
        let load = outcome.pressure.iter().sum::<f64>() * self.distance.lattice().cell_area();
        self.pressure.clone_from(&outcome.pressure);
        Ok(self.solution(load, outcome, options))
    }

    fn solution(
        &self,
        load: f64,
        outcome: Outcome,
        options: &RoughContactOptions,
    ) -> RoughContactSolution {
        let lattice: &Lattice = self.distance.lattice();
        let is_contact = |cell: usize| outcome.pressure[cell] > 0.0;
        let [contact_area, corrected_contact_area] =
            area::contact_area(lattice, is_contact, self.boundary);
        let plastic = outcome.pressure.iter().filter(|pressure| **pressure >= self.hardness);
        RoughContactSolution {
            is_converged: outcome.residual <= options.tolerance,
            residual: outcome.residual,
            iterations: outcome.iterations,
            products: outcome.products,
            load,
            approach: outcome.level - self.distance.range()[0],
            mean_gap: outcome.gap.iter().sum::<f64>() / lattice.len() as f64,
            contact_area,
            corrected_contact_area,
            plastic_area: plastic.count() as f64 * lattice.cell_area(),
            touches_edge: area::touches_edge(lattice, is_contact),
            pressure: outcome.pressure,
            gap: outcome.gap,
        }
    }
}
