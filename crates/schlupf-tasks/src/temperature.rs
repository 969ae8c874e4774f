//! Temperatures below the surface and in the wake.

use schlupf::temperature_field::{Side, TemperatureField};
use schlupf::{Error, Problem, Solution, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile};
use schlupf_output::temperature::{Request as Positions, Temperatures};

use crate::{Notice, TaskError, messages};

/// Points of each line by default.
pub const POINTS: usize = 201;

/// Where to look; what is left out follows from the solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Place along rolling, in m; by default the hottest point.
    pub x: Option<f64>,
    /// Place across rolling, in m; by default the hottest point.
    pub y: Option<f64>,
    /// Depths of the profile, in m; by default as far as heat has penetrated.
    pub depth: Option<[f64; 2]>,
    /// Length of the wake, in m; by default twice that of the contact.
    pub wake: Option<f64>,
    /// Points of each line, at least two.
    pub points: usize,
    /// What messages call x, y, the depths and the wake.
    pub names: [&'static str; 4],
}

/// Places may be so far from the middle of the patch, in m.
const FARTHEST: f64 = 1e3;

/// A case with where to look.
#[derive(Debug)]
pub struct Plan {
    case: Case,
    request: Request,
}

/// Poses the case.
///
/// # Errors
/// A case that is wrong or has a history.
pub fn plan(file: &CaseFile, request: Request, watch: Watch) -> Result<Plan, TaskError> {
    request.check()?;
    let case = file.pose(watch)?;
    case.require_steady("temperatures below the surface and in the wake are those")?;
    Ok(Plan { case, request })
}

impl Plan {
    /// Solves the case and looks.
    ///
    /// # Errors
    /// A place outside of the contact, or whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<Temperatures, TaskError> {
        let Self { case, request } = self;
        let explain = |error: Error| CaseErrors::from(case.explain(&error));
        let problem = &case.problem;
        let solution = case.solver().solve(problem, watch).map_err(explain)?;
        let field = TemperatureField::new(problem, &solution).map_err(explain)?;
        let positions = request.positions(problem, &solution, &field)?;
        let (profile, rows) = Temperatures::sample(&field, &positions);
        let caveats = TemperatureField::caveat(problem, &solution);
        let warnings = messages(solution.warnings.iter().chain(&caveats));
        Ok(Temperatures {
            status: solution.status,
            request: positions,
            bulk: [&problem.wheel, &problem.rail].map(|body| body.bulk_temperature),
            profile,
            rows,
            warnings: Notice::of_first_contact(&case).into_iter().chain(warnings).collect(),
            title: case.title,
        })
    }
}

impl Request {
    fn check(&self) -> Result<(), TaskError> {
        let [x, y, depth, wake] = self.names;
        let is_place = |place: &f64| place.abs() <= FARTHEST;
        let is_length = |length: &f64| (0.0..=FARTHEST).contains(length);
        let wrong = |name: &str, requirement: &str, value: f64| {
            Err(TaskError::Request(format!("{name} must be {requirement}, but is {value} m")))
        };
        for (name, place) in [(x, self.x), (y, self.y)] {
            if let Some(place) = place.filter(|place| !is_place(place)) {
                return wrong(name, "at most ±1000 m", place);
            }
        }
        let lengths = [(depth, self.depth.map(|d| d[0])), (depth, self.depth.map(|d| d[1]))];
        for (name, length) in lengths.into_iter().chain([(wake, self.wake)]) {
            if let Some(length) = length.filter(|length| !is_length(length)) {
                return wrong(name, "between 0 and 1000 m", length);
            }
        }
        match self.depth {
            Some([start, end]) if end <= start => wrong(depth, "a range that increases", end),
            _ => Ok(()),
        }
    }

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
        let diffusivity =
            problem.wheel.material.diffusivity().max(problem.rail.material.diffusivity());
        let reach = |way: f64| (diffusivity * way / speed).sqrt();
        let depth = self.depth.unwrap_or([0.0, DEEPEST * reach(entry - x.min(exit))]);
        let wake = self.wake.unwrap_or(WAKE * (entry - exit)).max(exit - x);
        let row_depths = ROW_DEPTHS.map(|part| part * reach(entry - exit));
        let (point, passage, points) = ([x, y], [entry, exit], self.points);
        Ok(Positions { point, passage, depth, wake, row_depths, points })
    }

    fn outside(&self, field: &TemperatureField, y: f64) -> TaskError {
        let [low, high] = field.width().map(millimetres);
        TaskError::Request(format!(
            "{} must lie in the contact, between {low} and {high} mm, but is {} mm",
            self.names[1],
            millimetres(y)
        ))
    }

    fn ahead(&self, x: f64, entry: f64, y: f64) -> TaskError {
        TaskError::Request(format!(
            "{} must not lie ahead of the contact, which begins at x = {} mm in the row y = {} mm, but \
             is {} mm",
            self.names[0],
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
