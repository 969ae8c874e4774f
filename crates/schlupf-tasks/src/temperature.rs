//! Temperatures below the surface and in the wake.

use crate::output::temperature::{Positions, Temperatures};
use schlupf::analysis::creep_curve::MAX_POINTS;
use schlupf::analysis::temperature_field::{Side, TemperatureField};
use schlupf::{Error, Problem, Solution, Watch};
use schlupf_case::{CaseErrors, Points};

use crate::request::{Kind, request};
use crate::task::{Found, Given, Task, Wanted};
use crate::{Notice, TaskError, messages};

request! {
    /// Where to look; what is left out follows from the solution.
    Request {
        /// Position along rolling, such as "-3 mm"; by default that of the hottest point.
        x: Option<f64> = Kind::position();
        /// Position across rolling; by default that of the hottest point.
        y: Option<f64> = Kind::position();
        /// Depths of the profile, such as "0..2 mm" or "0,0.1,2 mm"; by default as far as heat has
        /// penetrated.
        depth: Option<Points> = Kind::depths();
        /// Length of the wake; by default twice the length of the contact.
        wake: Option<f64> = Kind::length();
        /// Number of points of each line that is a range.
        points: usize = Kind::count(2, MAX_POINTS), default(201);
    }
}

/// `temperature`.
pub struct Temperature;

impl Task for Temperature {
    const NAME: &'static str = "temperature";
    const ABOUT: &'static str =
        "Compute temperatures below a point and along its row, including the wake";
    const SOURCES: &'static str =
        "Conduction perpendicular to the surface: Carslaw and Jaeger (1959).";
    type Request = Request;
    type Report = Temperatures;

    fn run(
        of: &Given,
        request: Request,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<Temperatures>, TaskError> {
        let case = of.case.pose(watch)?;
        case.require_steady("temperatures below the surface and in the wake are those")?;
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        let problem = &case.problem;
        let solution = case.steady_state(case.solver(), watch).map_err(explain)?;
        let field = TemperatureField::new(problem, &solution).map_err(explain)?;
        let positions = request.positions(problem, &solution, &field)?;
        let (profile, rows) = Temperatures::sample(&field, &positions);
        let caveats = TemperatureField::caveat(problem, &solution);
        let warnings = messages(solution.warnings.iter().chain(&caveats));
        let report = Temperatures {
            status: solution.status,
            request: positions,
            bulk: [&problem.interface.wheel, &problem.interface.rail]
                .map(|body| body.bulk_temperature),
            profile,
            rows,
            warnings: Notice::of_first_contact(&case).into_iter().chain(warnings).collect(),
            title: case.title,
        };
        Ok(report.into())
    }
}

impl Request {
    /// With the defaults that the solution gives.
    fn positions(
        &self,
        problem: &Problem,
        solution: &Solution,
        field: &TemperatureField,
    ) -> Result<Positions, TaskError> {
        let hottest = hottest_point(solution);
        let y = self.y.or(hottest.map(|point| point[1])).unwrap_or_else(|| middle(field));
        let passages = field.passages(y);
        let (Some(first), Some(last)) = (passages.first(), passages.last()) else {
            return Err(self.outside(field, y));
        };
        let [entry, exit] = [first[0], last[1]];
        let x = self.x.unwrap_or_else(|| match hottest {
            // The edge of a row is a mean: the point of a cell that it cuts may lie ahead of it.
            Some(point) if self.y.is_none() => point[0].min(entry),
            _ => hottest_place(field, [entry, exit], y),
        });
        if x > entry {
            return Err(self.ahead(x, entry, y));
        }
        let speed = solution.kinematics.speed;
        let diffusivity = problem
            .interface
            .wheel
            .material
            .diffusivity()
            .max(problem.interface.rail.material.diffusivity());
        let reach = |way: f64| (diffusivity * way / speed).sqrt();
        let deep = || Points::Range([0.0, DEEPEST * reach(entry - x.min(exit))]);
        let depths = self.depth.clone().unwrap_or_else(deep).evenly(self.points);
        let wake = self.wake.unwrap_or(WAKE * (entry - exit)).max(exit - x);
        let row_depths = ROW_DEPTHS.map(|part| part * reach(entry - exit));
        let (point, passage, points) = ([x, y], [entry, exit], self.points);
        Ok(Positions { point, passage, depths, wake, row_depths, points })
    }

    fn outside(&self, field: &TemperatureField, y: f64) -> TaskError {
        let [low, high] = field.width().map(millimetres);
        TaskError::Request(format!(
            "{} must lie in the contact, between {low} and {high} mm, but is {} mm",
            self.asked.name("y"),
            millimetres(y)
        ))
    }

    fn ahead(&self, x: f64, entry: f64, y: f64) -> TaskError {
        TaskError::Request(format!(
            "{} must not lie ahead of the contact, which begins at x = {} mm in the row y = {} mm, but \
             is {} mm",
            self.asked.name("x"),
            millimetres(entry),
            millimetres(y),
            millimetres(x)
        ))
    }
}

/// The hottest point (x, y) of the contact, in m; `None` where all of it has one temperature.
fn hottest_point(solution: &Solution) -> Option<[f64; 2]> {
    const ALIKE: f64 = 1e-9;
    let rises = &solution.fields.temperature_rise_rail;
    let least = rises.iter().copied().fold(f64::INFINITY, f64::min);
    let temperature = solution.temperature?;
    let spread = temperature.max_rise_rail - least;
    (spread > ALIKE * temperature.max_rise.abs()).then_some([temperature.x, temperature.y])
}

/// The middle of the contact, y in m.
fn middle(field: &TemperatureField) -> f64 {
    let [low, high] = field.width();
    0.5 * (low + high)
}

/// Where a row is hottest on the surface, x in m.
fn hottest_place(field: &TemperatureField, [entry, exit]: [f64; 2], y: f64) -> f64 {
    const PLACES: u32 = 400;
    let heat = |x: f64| field.at(Side::Wheel, x, y, 0.0).max(field.at(Side::Rail, x, y, 0.0));
    let place = |k: u32| entry + (exit - entry) * f64::from(k) / f64::from(PLACES);
    let hotter = |p: &f64, q: &f64| heat(*p).total_cmp(&heat(*q));
    (1..=PLACES).map(place).max_by(hotter).unwrap_or(exit)
}

/// Depth of the profile, in √(κt) of the time since entry, at least that of the passage.
const DEEPEST: f64 = 5.0;
/// Length of the wake over that of the contact.
const WAKE: f64 = 2.0;
/// Depths of the rows below the surface, in √(κt) of the passage.
const ROW_DEPTHS: [f64; 2] = [0.5, 1.0];

/// Four digits are enough to find the mistake.
fn millimetres(value: f64) -> f64 {
    let value = value / 1e-3;
    format!("{value:.3e}").parse().unwrap_or(value)
}
