//! Elastic deformation of the two bodies under tangential traction, u = A t.

mod calibration_table;
pub mod elastic_layer;
mod ellipsoidal_traction;
mod pressure_coupling;
mod half_space;
mod viscoelastic;
mod calibrated_layer;
mod rigid;
mod winkler;

pub use half_space::{Convolution, HalfSpace};
pub use pressure_coupling::{PressureCoupling, UnlikeBodies};

pub use calibrated_layer::{
    AXIS_RATIO_RANGE, CalibratedLayer, RelativeStiffness, tabulated_stiffness,
};
pub use ellipsoidal_traction::EllipsoidalTraction;
pub use rigid::Rigid;
pub use viscoelastic::{StandardLinearSolid, ViscoelasticHalfSpace};
pub use winkler::Winkler;

use std::fmt::Debug;
use std::sync::Arc;

use crate::normal::{Grid, VectorField};
use crate::reporting::{Error, Warning};

/// A model of elasticity. Extension point.
///
/// ```
/// use schlupf::elasticity::{Compliance, Elasticity};
/// use schlupf::normal::{Grid, VectorField};
/// use schlupf::{Error, Options, Problem, solver, unwatched};
///
/// /// Springs whose compliance (in m³/N) is the same along and across.
/// #[derive(Debug, Clone)]
/// struct Springs(f64);
///
/// impl Elasticity for Springs {
///     fn compliance(&self, _grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
///         Ok(Box::new(self.clone()))
///     }
/// }
///
/// impl Compliance for Springs {
///     fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField) {
///         for (u, t) in displacement.x.iter_mut().zip(&traction.x) {
///             *u = self.0 * t;
///         }
///         for (u, t) in displacement.y.iter_mut().zip(&traction.y) {
///             *u = self.0 * t;
///         }
///     }
///
///     fn couples_cells(&self) -> bool {
///         false
///     }
/// }
///
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let force = |springs| {
///     let problem = Problem::builder().elasticity(springs).creepage_x(2e-4).build()?;
///     Ok::<_, Error>(solver::solve(&problem, &options, &unwatched)?.force.x.abs())
/// };
/// assert!(force(Springs(5e-14))? > force(Springs(1e-13))?);
/// # Ok::<(), Error>(())
/// ```
pub trait Elasticity: Debug + Send + Sync {
    /// The compliance on the cells of a grid.
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error>;

    /// The compliance of the same bodies as on `grid`, on cells of which a whole number make up one
    /// of its cells along and across rolling. A model with properties that follow from its grid
    /// takes them from `grid`.
    fn compliance_on_finer(
        &self,
        _grid: &Grid,
        finer: &Grid,
    ) -> Result<Box<dyn Compliance>, Error> {
        self.compliance(finer)
    }

    /// The exact displacement under a semi-ellipsoidal traction on an ellipse with the given
    /// semi-axes (in m), if the model knows it.
    fn under_ellipsoid(&self, _semi_axes: [f64; 2]) -> Option<EllipsoidalTraction> {
        None
    }

    /// How pressure displaces the surfaces tangentially and tractions move them apart, if the model
    /// does not neglect it.
    fn pressure_coupling(&self) -> Option<PressureCoupling> {
        None
    }

    /// The same for bodies whose common surface is curved across rolling, with a curvature in 1/m,
    /// positive where the rail is convex; `None` if the model is for plane surfaces only.
    fn curved(&self, _curvature: f64) -> Option<Arc<dyn Elasticity>> {
        None
    }

    /// The bodies, if they are viscoelastic and their speed is that of a problem.
    fn viscoelastic(&self) -> Option<&ViscoelasticHalfSpace> {
        None
    }

    /// Whether displacements under a traction grow with the size of the grid, all lengths growing
    /// alike: bodies without a length of their own.
    fn is_scale_free(&self) -> bool {
        false
    }

    /// Whether its stiffnesses are those for an elliptic patch.
    fn assumes_ellipse(&self) -> bool {
        false
    }

    /// What the model neglects for the given bodies, if whoever uses the results should know.
    fn caveat(&self) -> Option<Warning> {
        None
    }

    /// The same for a patch of several separate parts, if the model assumes a single one.
    fn caveat_of_parts(&self, _parts: usize) -> Option<Warning> {
        None
    }
}

/// Displacement from traction on the cells of one grid; positive semidefinite, and symmetric where
/// the bodies are elastic.
pub trait Compliance: Debug + Send + Sync {
    /// Displacement difference u, wheel minus rail (in m), of every cell of the grid under the
    /// traction t on the wheel (in Pa).
    fn displacement(&mut self, traction: &VectorField, displacement: &mut VectorField);

    /// Derivative of the displacement (in m) with respect to the logarithm of the grid size, all
    /// lengths growing alike. Returns whether the model knows it; if not, nothing is written.
    fn displacement_by_size(
        &mut self,
        _traction: &VectorField,
        _displacement: &mut VectorField,
    ) -> bool {
        false
    }

    /// Whether a loaded cell displaces its neighbours. If not, nothing is displaced ahead of the
    /// leading edge.
    fn couples_cells(&self) -> bool;

    /// Ratio of the largest displacement at the outer edge of the modelled surface to the largest
    /// one anywhere, dimensionless; zero if the model has no outer edge.
    fn edge_displacement(&mut self, _traction: &VectorField) -> f64 {
        0.0
    }
}
