//! `schlupf temperature`.

use clap::Args;
use schlupf::temperature_field::{Side, TemperatureField};
use schlupf::{Error, Problem, Solution, Watch};
use schlupf_case::{Case, CaseError, CaseErrors, CaseFile, depths, length, position};
use schlupf_output::temperature::{Request, Temperatures};

use schlupf_tasks::messages;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::curve::number_of_points;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::task::{Found, Task};

/// Where to look at the temperatures, and where to write them.
#[derive(Debug, Args)]
pub struct Temperature {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Position along rolling, such as "-3 mm" [default: the hottest point]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub x: Option<String>,
    /// Position across rolling [default: the hottest point]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub y: Option<String>,
    /// Depths of the profile, such as "0..2 mm" [default: as far as heat has penetrated]
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub depth: Option<String>,
    /// Length of the wake [default: twice the length of the contact]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub wake: Option<String>,
    /// Number of points of each line
    #[arg(long, value_name = "N", default_value_t = 201, value_parser = number_of_points)]
    pub points: usize,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A case with where to look.
pub struct Plan {
    case: Case,
    wanted: Wanted,
}

impl Task for Temperature {
    type Plan = Plan;
    type Report = Temperatures;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let wanted = Wanted::read(self)?;
        let what = "temperatures below the surface and in the wake are those";
        let case = file.pose(watch)?;
        case.require_steady(what).map_err(CaseErrors::from)?;
        Ok(Plan { case, wanted })
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<Temperatures>, Failure> {
        let Plan { case, wanted } = plan;
        let explain = |error: Error| explain(&case, &error);
        let problem = &case.problem;
        let solution = case.solver().solve(problem, &progress.watch()).map_err(explain)?;
        let field = TemperatureField::new(problem, &solution).map_err(explain)?;
        let request = wanted.request(problem, &solution, &field)?;
        let (profile, rows) = Temperatures::sample(&field, &request);
        let caveats = TemperatureField::caveat(problem, &solution);
        let warnings = messages(solution.warnings.iter().chain(&caveats));
        let temperatures = Temperatures {
            status: solution.status,
            request,
            bulk: [&problem.wheel, &problem.rail].map(|body| body.bulk_temperature),
            profile,
            rows,
            warnings: case.notices.iter().cloned().chain(warnings).collect(),
            title: case.title,
        };
        Ok(temperatures.into())
    }
}

fn explain(case: &Case, error: &Error) -> Failure {
    Failure::Case(case.explain(error).into())
}

/// What the options ask for, lengths in m.
pub struct Wanted {
    x: Option<f64>,
    y: Option<f64>,
    depth: Option<[f64; 2]>,
    wake: Option<f64>,
    points: usize,
}

impl Wanted {
    fn read(arguments: &Temperature) -> Result<Self, Failure> {
        let read = || {
            let of = |option, what, text: &Option<String>| {
                text.as_deref().map(|text| position(option, what, text)).transpose()
            };
            Ok(Self {
                x: of("--x", "the place along rolling", &arguments.x)?,
                y: of("--y", "the place across rolling", &arguments.y)?,
                depth: arguments
                    .depth
                    .as_deref()
                    .map(|text| depths("--depth", text))
                    .transpose()?,
                wake: arguments
                    .wake
                    .as_deref()
                    .map(|text| length("--wake", "the length of the wake", text))
                    .transpose()?,
                points: arguments.points,
            })
        };
        read().map_err(|error: CaseError| Failure::Case(CaseErrors::from(error)))
    }

    /// With the defaults that the solution gives.
    fn request(
        &self,
        problem: &Problem,
        solution: &Solution,
        field: &TemperatureField,
    ) -> Result<Request, Failure> {
        let hottest = hottest_point(solution);
        let y = self.y.or(hottest.map(|point| point[1])).unwrap_or_else(|| middle(field));
        let passages = field.passages(y);
        let (Some(first), Some(last)) = (passages.first(), passages.last()) else {
            let [low, high] = field.width().map(millimetres);
            return Err(Failure::Arguments(format!(
                "--y must lie in the contact, between {low} and {high} mm, but is {} mm",
                millimetres(y)
            )));
        };
        let [entry, exit] = [first[0], last[1]];
        let x = self.x.unwrap_or_else(|| match hottest {
            // The edge of a row is a mean: the point of a cell that it cuts may lie ahead of it.
            Some(point) if self.y.is_none() => point[0].min(entry),
            _ => hottest_place(field, [entry, exit], y),
        });
        if x > entry {
            return Err(Failure::Arguments(format!(
                "--x must not lie ahead of the contact, which begins at x = {} mm in the row y = {} mm, \
                 but is {} mm",
                millimetres(entry),
                millimetres(y),
                millimetres(x)
            )));
        }
        let speed = solution.kinematics.speed;
        let diffusivity =
            problem.wheel.material.diffusivity().max(problem.rail.material.diffusivity());
        let reach = |way: f64| (diffusivity * way / speed).sqrt();
        let depth = self.depth.unwrap_or([0.0, DEEPEST * reach(entry - x.min(exit))]);
        let wake = self.wake.unwrap_or(WAKE * (entry - exit)).max(exit - x);
        let row_depths = ROW_DEPTHS.map(|part| part * reach(entry - exit));
        let (point, passage, points) = ([x, y], [entry, exit], self.points);
        Ok(Request { point, passage, depth, wake, row_depths, points })
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
