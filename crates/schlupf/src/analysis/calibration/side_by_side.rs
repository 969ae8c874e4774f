//! Comparison of the half-space with its substitutes: forces against creepage, and the traction
//! along the centre line of the patch. The contact law is stiff and friction constant, as in the
//! calibration.

use std::sync::Arc;

use crate::elasticity::elastic_layer::ElasticLayer;
use crate::elasticity::{Elasticity, RelativeStiffness};
use crate::numerics::parallel;
use crate::problem::{Brush, FastMethod, Method, Options, Problem};
use crate::reporting::{Error, Watch};
use crate::solution::{Solution, Status};

use super::kalker_bed::KalkerBed;
use super::rolling_contact::{FRICTION, PEAK_PRESSURE, RollingContact, SIZE};

/// A model of the comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Model {
    /// The elastic half-space, which the others approximate.
    HalfSpace,
    /// The calibrated layer.
    Layer,
    /// The Winkler bedding with Kalker's flexibilities.
    KalkerBed,
    /// FASTSIM of Kalker (1982).
    Fastsim,
}

/// Forces and traction of one model under growing creepage.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Answer {
    /// The model.
    pub model: Model,
    /// Force on the rail over μN for each creepage, dimensionless.
    pub force: Vec<f64>,
    /// Traction on the rail along the row nearest to y = 0, over μp0: x/a and traction, both
    /// dimensionless.
    pub traction: Vec<[f64; 2]>,
    /// Whether all solutions converged.
    pub converged: bool,
}

/// A growing creepage.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Course {
    /// Creepages, as fractions of that at which Kalker's linear theory gives the force μN;
    /// dimensionless.
    pub creepage: Vec<f64>,
    /// The creepage of the traction, normalised likewise; dimensionless.
    pub traction_at: f64,
    /// The models.
    pub answers: Vec<Answer>,
}

/// The half-space and its substitutes on one ellipse.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SideBySide {
    /// Axis ratio a/b, dimensionless.
    pub axis_ratio: f64,
    /// Combined Poisson's ratio ν, dimensionless.
    pub poisson_ratio: f64,
    /// Longitudinal creepage: forces and tractions along rolling.
    pub longitudinal: Course,
    /// Spin: forces and tractions across rolling.
    pub spin: Course,
}

/// Creepages of the forces.
const CREEPAGES: [f64; 24] = [
    0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1.0, 1.1, 1.2, 1.35, 1.5,
    1.7, 1.9, 2.1, 2.4, 2.7, 3.0,
];

/// Creepage of the traction.
const TRACTION_AT: f64 = 0.6;

/// Cells across the patch: an odd number of rows, so that one is at y = 0.
const CELLS: [usize; 2] = [48, 31];

/// Compares the models for an axis ratio a/b and a combined Poisson's ratio ν (both dimensionless),
/// the layer with these stiffnesses for displacements along and across rolling.
///
/// ```no_run
/// use schlupf::analysis::calibration::side_by_side::side_by_side;
/// use schlupf::elasticity::RelativeStiffness;
/// use schlupf::unwatched;
///
/// let stiffness = RelativeStiffness { bedding: 1.2, reach_along_x: 0.5, reach_along_y: 0.5 };
/// let compared = side_by_side(1.0, 0.28, [stiffness; 2], &unwatched)?;
/// assert!(compared.is_converged());
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// An axis ratio that is not positive, a Poisson's ratio outside 0 to 0.5, and [`Error::Stopped`].
pub fn side_by_side(
    axis_ratio: f64,
    poisson_ratio: f64,
    stiffness: [RelativeStiffness; 2],
    watch: Watch,
) -> Result<SideBySide, Error> {
    let contact = RollingContact::new(axis_ratio, poisson_ratio)?;
    let shear_modulus = contact.bodies.shear_modulus();
    let [x, y] = stiffness.map(|relative| relative.absolute(shear_modulus, SIZE));
    let models: Vec<(Model, Arc<dyn Elasticity>)> = vec![
        (Model::HalfSpace, Arc::new(contact.bodies)),
        (Model::Layer, Arc::new(ElasticLayer::new(x, y, None)?)),
        (Model::KalkerBed, Arc::new(KalkerBed { bodies: contact.bodies })),
        // FASTSIM uses no elasticity model.
        (Model::Fastsim, Arc::new(contact.bodies)),
    ];
    Ok(SideBySide {
        axis_ratio,
        poisson_ratio,
        longitudinal: course(&contact, &models, 0, watch)?,
        spin: course(&contact, &models, 1, watch)?,
    })
}

/// Longitudinal creepage (component 0) or spin (component 1).
fn course(
    contact: &RollingContact,
    models: &[(Model, Arc<dyn Elasticity>)],
    component: usize,
    watch: Watch,
) -> Result<Course, Error> {
    let motion = |part: f64| {
        contact.motion(if component == 0 { [part, 0.0, 0.0] } else { [0.0, 0.0, part] })
    };
    let answer = |(model, elasticity): &(Model, Arc<dyn Elasticity>)| {
        let mut solver = model.method().solver(&options());
        let problem = contact
            .problem
            .clone()
            .with_interface(|interface| interface.elasticity = Arc::clone(elasticity));
        let mut solve = |part: f64| {
            let problem = Problem { kinematics: motion(part), ..problem.clone() };
            solver.solve(&problem, watch)
        };
        let mut converged = true;
        let mut force = Vec::with_capacity(CREEPAGES.len());
        for part in CREEPAGES {
            let solution = solve(part)?;
            converged &= solution.status == Status::Converged;
            let normalised = solution.normalised;
            force.push(-if component == 0 { normalised.x } else { normalised.y });
        }
        let solution = solve(TRACTION_AT)?;
        converged &= solution.status == Status::Converged;
        let traction = middle_row(&solution, component);
        Ok::<_, Error>(Answer { model: *model, force, traction, converged })
    };
    let answers = parallel::try_map(models.iter().collect(), answer)?;
    Ok(Course { creepage: CREEPAGES.to_vec(), traction_at: TRACTION_AT, answers })
}

impl Model {
    fn method(self) -> Method {
        match self {
            Self::HalfSpace | Self::Layer | Self::KalkerBed => Method::Full,
            Self::Fastsim => Method::Fast(FastMethod::Fastsim(Brush::KALKER)),
        }
    }
}

fn options() -> Options {
    let [cells_x, cells_y] = CELLS;
    Options { cells_x, cells_y, tolerance: 1e-7, ..Options::default() }
}

/// Traction on the rail divided by μp0 against x/a, in the row at y = 0.
fn middle_row(solution: &Solution, component: usize) -> Vec<[f64; 2]> {
    let fields = &solution.fields;
    let traction = if component == 0 { &fields.traction_x } else { &fields.traction_y };
    let row = CELLS[1] / 2;
    let (length, bound) = (solution.normal.semi_axis_x, FRICTION * PEAK_PRESSURE);
    let in_row = |k: &usize| fields.cell[*k][1] == row;
    let point = |k: usize| [fields.x[k] / length, -traction[k] / bound];
    (0..fields.cell.len()).filter(in_row).map(point).collect()
}

impl SideBySide {
    /// Whether all solutions converged.
    pub fn is_converged(&self) -> bool {
        let answers = self.longitudinal.answers.iter().chain(&self.spin.answers);
        answers.into_iter().all(|answer| answer.converged)
    }
}
