//! Stresses below the surface.

use crate::output::subsurface::{PROFILE_POINTS, StressReport};
use schlupf::analysis::subsurface::{Measure, PointStress, SubsurfaceStress};
use schlupf::normal::Grid;
use schlupf::reporting::MethodPurpose;
use schlupf::{Error, Solution, Watch};
use schlupf_case::{
    Case, CaseErrors, InputFile, POINT_COLUMNS, SubsurfaceRequest, field, read_points,
};

use crate::request::{Kind, request};
use crate::solve::solve;
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

request! {
    /// Where to look besides the volume of the case.
    Request {
        /// Position of the profile along rolling, such as "-3 mm"; by default that of the largest
        /// stress of von Mises.
        x: Option<f64> = Kind::position();
        /// Position of the profile across rolling; by default that of the largest stress of von
        /// Mises.
        y: Option<f64> = Kind::position();
        /// Table of points (CSV) at which stresses are wanted, too: columns x [mm], y [mm] and
        /// depth [mm].
        points: Option<InputFile> = Kind::table(&POINT_COLUMNS);
    }
}

/// `subsurface`.
pub struct Subsurface;

impl Task for Subsurface {
    const NAME: &'static str = "subsurface";
    const ABOUT: &'static str = "Compute the stresses below the surface of wheel or rail";
    const SOURCES: &'static str = "Love (1929); Ahmadi, Keer and Mura (1983).";
    type Request = Request;
    type Report = StressReport;

    fn run(
        of: &Given,
        request: Request,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<StressReport>, TaskError> {
        let points = request.points.as_ref();
        let points =
            points.map(|file| read_points(&request.asked.name("points"), file)).transpose()?;
        let case = of.case.pose(watch)?;
        if !case.method.has_fields() {
            let method = case.method.name();
            let error = Error::OtherMethod { purpose: MethodPurpose::Stress, method };
            return Err(case.explain(&error).into());
        }
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        let (rolling, wanted) = (case.rolling(None)?, case.subsurface()?);
        let solution = solve(&case, rolling, watch).map_err(explain)?.solution;
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
        let report = StressReport {
            status: solution.status,
            profile: profile(&stresses, [x, y], deepest),
            points,
            stresses,
            volume,
            largest,
            normal: solution.normal,
            warnings: Notice::of_first_contact(&case).into_iter().chain(warnings).collect(),
            title: case.title,
        };
        Ok(report.into())
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
    for (name, place, [first, last]) in [("x", request.x, x), ("y", request.y, y)] {
        let Some(place) = place.filter(|place| !(first..=last).contains(place)) else { continue };
        let [place, first, last] = [place, first, last].map(|place| 1e3 * place);
        let name = request.asked.name(name);
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
        Some(_) => field!("subsurface.margin"),
        None if points > most as f64 => field!("subsurface.layers"),
        None => field!("grid.cells_x"),
    };
    Err(case.contradiction(field, &reason).into())
}
