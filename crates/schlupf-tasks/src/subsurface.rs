//! Stresses below the surface.

use schlupf::error::MethodPurpose;
use schlupf::grid::Grid;
use schlupf::subsurface::{Measure, PointStress, SubsurfaceStress};
use schlupf::{Error, Solution, Watch};
use schlupf_case::{
    Case, CaseErrors, CaseFile, InputFile, Rolling, SubsurfaceRequest, read_points,
};
use schlupf_output::subsurface::{PROFILE_POINTS, StressReport};

use crate::solve::solve;
use crate::{Notice, TaskError, messages};

/// Where to look besides the volume of the case.
#[derive(Debug, Clone)]
pub struct Request {
    /// Place of the profile along rolling, in m; by default that of the largest stress of von
    /// Mises.
    pub x: Option<f64>,
    /// The same across rolling, in m.
    pub y: Option<f64>,
    /// A table of points, with what messages call it.
    pub points: Option<(&'static str, InputFile)>,
    /// What messages call x and y.
    pub names: [&'static str; 2],
}

/// Places may be so far from the middle of the patch, in m.
const FARTHEST: f64 = 1e3;

/// A case with where to look.
pub struct Plan {
    case: Case,
    rolling: Rolling,
    volume: SubsurfaceRequest,
    request: Request,
    points: Option<Vec<[f64; 3]>>,
}

/// Poses the case.
///
/// # Errors
/// A case that is wrong, or a place that is none.
pub fn plan(file: &CaseFile, request: Request, watch: Watch) -> Result<Plan, TaskError> {
    for (name, place) in request.names.iter().zip([request.x, request.y]) {
        if let Some(place) = place.filter(|place| !(-FARTHEST..=FARTHEST).contains(place)) {
            let text = format!("{name} must be at most ±{FARTHEST} m, but is {place} m");
            return Err(TaskError::Request(text));
        }
    }
    let points = request.points.as_ref().map(|(name, file)| read_points(name, file)).transpose();
    let points = points.map_err(CaseErrors::from)?;
    let case = file.pose(watch)?;
    if !case.method.has_fields() {
        let method = case.method.name();
        let error = Error::OtherMethod { purpose: MethodPurpose::Stress, method };
        return Err(CaseErrors::from(case.explain(&error)).into());
    }
    let rolling = case.rolling(None).map_err(CaseErrors::from)?;
    let volume = case.subsurface().map_err(CaseErrors::from)?;
    Ok(Plan { case, rolling, volume, request, points })
}

impl Plan {
    /// Solves the case and computes the stresses.
    ///
    /// # Errors
    /// More points than can be stored, or whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<StressReport, TaskError> {
        let Self { case, rolling, volume: wanted, request, points } = self;
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        let solved = solve(&case, rolling, watch).map_err(explain)?;
        let solution = solved.solution;
        let stresses =
            SubsurfaceStress::new(&case.problem, &solution, wanted.side).map_err(explain)?;
        check_size(&case, &wanted, &solution, &stresses)?;
        let depths = wanted.depths(&solution.normal);
        let margin = wanted.margin(&solution.normal, stresses.grid());
        let volume = stresses.volume(&depths, margin, watch).map_err(explain)?;
        check_planes(&volume.grid, &request)?;
        let largest = stresses.largest(Measure::ALL, watch).map_err(explain)?;
        let by_default = largest[0].anywhere;
        let [x, y] = [request.x.unwrap_or(by_default.x), request.y.unwrap_or(by_default.y)];
        let deepest = depths.last().copied().unwrap_or(0.0);
        let points = points.map(|points| stresses.points(&points, watch)).transpose();
        let points = points.map_err(explain)?;
        let warnings = messages(&solution.warnings);
        Ok(StressReport {
            status: solution.status,
            profile: profile(&stresses, [x, y], deepest),
            points,
            stresses,
            volume,
            largest,
            normal: solution.normal,
            warnings: Notice::of_first_contact(&case).into_iter().chain(warnings).collect(),
            title: case.title,
        })
    }
}

/// Stresses below a point, from the surface to a depth in m.
fn profile(stresses: &SubsurfaceStress, [x, y]: [f64; 2], deepest: f64) -> Vec<PointStress> {
    let last = PROFILE_POINTS - 1;
    let depth = |k: usize| deepest * k as f64 / last as f64;
    (0..=last).map(|k| stresses.point([x, y, depth(k)])).collect()
}

/// Refuses planes beside the layers, which have no stresses there.
fn check_planes(grid: &Grid, request: &Request) -> Result<(), TaskError> {
    let x = [grid.edge_x(0), grid.edge_x(grid.columns)];
    let y = [grid.edge_y(0), grid.edge_y(grid.rows)];
    let given = request.names.into_iter().zip([(request.x, x), (request.y, y)]);
    for (name, (place, [first, last])) in given {
        let Some(place) = place.filter(|place| !(first..=last).contains(place)) else { continue };
        let [place, first, last] = [place, first, last].map(|place| 1e3 * place);
        return Err(TaskError::Request(format!(
            "{name} must be within the layers, {first:.3} to {last:.3} mm, but is {place} mm: \
             subsurface.margin makes them wider"
        )));
    }
    Ok(())
}

/// Refuses a volume that no memory holds.
fn check_size(
    case: &Case,
    wanted: &SubsurfaceRequest,
    solution: &Solution,
    stresses: &SubsurfaceStress,
) -> Result<(), CaseErrors> {
    let points = wanted.points(&solution.normal, &solution.fields.grid);
    let margin = wanted.margin(&solution.normal, stresses.grid());
    let lattice = stresses.lattice_points(margin);
    let [most, most_of_lattice] =
        [SubsurfaceRequest::MOST_POINTS, SubsurfaceRequest::MOST_LATTICE_POINTS];
    let reason = if points > most as f64 {
        format!("{points:.3e} points in all layers together are more than {most}")
    } else if lattice > most_of_lattice as f64 {
        format!("a layer is computed on {lattice:.3e} points, more than {most_of_lattice}")
    } else {
        return Ok(());
    };
    let field = match wanted.margin {
        Some(_) => "subsurface.margin",
        None if points > most as f64 => "subsurface.layers",
        None => "grid.cells_x",
    };
    Err(case.contradiction(field, &reason).into())
}
