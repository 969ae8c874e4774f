//! `schlupf curve`.

use std::sync::atomic::{AtomicUsize, Ordering};

use clap::{ArgGroup, Args, ValueEnum};
use schlupf::creep_curve::{self, CreepCurve, Creepages, MAX_POINTS, Sampling, Spacing};
use schlupf::{Watch, parallel};
use schlupf_case::{
    Case, CaseErrors, CaseFile, Family, FieldNames, direction, quantity_field, range,
};
use schlupf_output::creep_curve as output;
use schlupf_output::creep_curve::CurveFamily;

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, Task};

const CREEPAGE_X: &str = "--creepage-x";
const CREEPAGE_Y: &str = "--creepage-y";
const SPIN: &str = "--spin";
const CREEPAGE: &str = "--creepage";
const OVER: &str = "--over";

/// Which creep curves, and where to write them.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("varied")
    .args(["creepage_x", "creepage_y", "spin", "creepage"]).required(true).multiple(true))]
pub struct Curve {
    /// Which case.
    #[command(flatten)]
    pub case: CaseArguments,
    /// Vary the longitudinal creepage, such as 0..0.05; several such options vary together
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub creepage_x: Option<String>,
    /// Vary the lateral creepage
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub creepage_y: Option<String>,
    /// Vary the spin creepage, such as "0..2 1/m"
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub spin: Option<String>,
    /// Vary the total creepage in the direction of --direction
    #[arg(
        long,
        value_name = "START..END",
        allow_hyphen_values = true,
        requires = "direction",
        conflicts_with_all = ["creepage_x", "creepage_y"]
    )]
    pub creepage: Option<String>,
    /// Direction of the total creepage, from longitudinal (0 deg) to lateral (90 deg)
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, requires = "creepage")]
    pub direction: Option<String>,
    /// Number of points
    #[arg(long, value_name = "N", default_value_t = Sampling::default().points,
          value_parser = number_of_points)]
    pub points: usize,
    /// Spacing of the points
    #[arg(long, value_enum, default_value_t = SpacingArgument::Refined)]
    pub spacing: SpacingArgument,
    /// Draw one curve for each value of a field, such as kinematics.speed="10 m/s,20 m/s"
    #[arg(long, value_name = "SECTION.FIELD=VALUE,…")]
    pub over: Option<String>,
    /// Where to write the results.
    #[command(flatten)]
    pub outputs: OutputArguments,
}

/// A number of points that makes a curve.
pub fn number_of_points(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| (2..=MAX_POINTS).contains(count));
    count.ok_or_else(|| format!("must be a whole number between 2 and {MAX_POINTS}"))
}

/// How the points of a curve are spaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SpacingArgument {
    /// Finer near zero creepage
    Refined,
    /// Equal steps
    Even,
}

/// The curves to compute.
pub struct Plan {
    title: String,
    family: Option<Family>,
    sampling: Sampling,
    members: Vec<Member>,
}

impl Task for Curve {
    type Plan = Plan;
    type Report = CurveFamily;

    fn case(&self) -> CaseArguments {
        self.case.clone()
    }

    fn outputs(&self) -> &OutputArguments {
        &self.outputs
    }

    fn plan(&self, file: CaseFile, watch: Watch) -> Result<Plan, Failure> {
        let varied = Varied::read(self)?;
        let family = self.over.as_deref().map(|text| Family::parse(OVER, text)).transpose();
        let family = family.map_err(CaseErrors::from)?;
        let sampling = self.sampling();
        let case = file.pose(watch)?;
        let members = members(&case, &varied, family.as_ref(), watch)?;
        members.iter().try_for_each(|member| member.check(&sampling, &varied))?;
        Ok(Plan { title: case.title, family, sampling, members })
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        // What is wrong with the option is told with the plan.
        let family = self.over.as_deref().and_then(|text| Family::parse(OVER, text).ok());
        let files = family.map(|family| family.files(file)).unwrap_or_default();
        let input = |path| Input { what: OVER.to_owned(), path, except: None };
        inputs.extend(files.into_iter().map(input));
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<CurveFamily>, Failure> {
        let Plan { title, family, sampling, members } = plan;
        let found = found(&members, &sampling, progress)?;
        let over = family.map(|family| family.field.to_owned());
        Ok(CurveFamily::new(title, over, sampling, found).into())
    }
}

impl Curve {
    fn sampling(&self) -> Sampling {
        let spacing = match self.spacing {
            SpacingArgument::Refined => Spacing::Refined,
            SpacingArgument::Even => Spacing::Even,
        };
        Sampling { points: self.points, spacing }
    }
}

/// All curves, on several threads.
fn found(
    members: &[Member],
    sampling: &Sampling,
    progress: &Progress,
) -> Result<Vec<output::Member>, Failure> {
    let watch = progress.watch();
    let done: Vec<AtomicUsize> = members.iter().map(|_| AtomicUsize::new(0)).collect();
    let total = members.len() * sampling.points;
    let each = members.iter().zip(&done).collect();
    parallel::try_map(each, |(member, own): (&Member, &AtomicUsize)| {
        let curve = member.trace(sampling, &|progress| {
            own.store(progress.done, Ordering::Relaxed);
            let done = done.iter().map(|done| done.load(Ordering::Relaxed)).sum();
            watch(progress.of(done, total))
        })?;
        let of_curve = curve.warnings.iter().map(|w| w.message(&FieldNames::CASE));
        let warnings = member.case.notices.iter().cloned().chain(of_curve).collect();
        Ok(output::Member { value: member.value.clone(), warnings, curve })
    })
}

/// Which creepages vary, and from where to where.
struct Varied {
    creepage_x: Option<[f64; 2]>,
    creepage_y: Option<[f64; 2]>,
    spin: Option<[f64; 2]>,
    /// Total creepage, and its direction in rad.
    total: Option<([f64; 2], f64)>,
    /// The options as they were given, for messages.
    text: String,
}

impl Varied {
    fn read(arguments: &Curve) -> Result<Self, Failure> {
        let Curve { creepage_x, creepage_y, spin, creepage, direction: angle, .. } = arguments;
        let range = |option, field, text: &Option<String>| {
            let text = text.as_deref();
            text.map(|text| range(option, field, text)).transpose().map_err(CaseErrors::from)
        };
        let given = [
            (CREEPAGE_X, creepage_x),
            (CREEPAGE_Y, creepage_y),
            (SPIN, spin),
            (CREEPAGE, creepage),
            ("--direction", angle),
        ];
        let text = given
            .iter()
            .filter_map(|(option, text)| Some(format!("{option} {}", text.as_ref()?)))
            .collect::<Vec<_>>()
            .join(" ");
        let total = match (range(CREEPAGE, "kinematics.creepage_x", creepage)?, angle) {
            (Some(range), Some(angle)) => {
                Some((range, direction("--direction", angle).map_err(CaseErrors::from)?))
            }
            _ => None,
        };
        Ok(Self {
            creepage_x: range(CREEPAGE_X, "kinematics.creepage_x", creepage_x)?,
            creepage_y: range(CREEPAGE_Y, "kinematics.creepage_y", creepage_y)?,
            spin: range(SPIN, "kinematics.spin", spin)?,
            total,
            text,
        })
    }

    /// The creepages of a case with those that vary in their place.
    fn path(&self, case: &Case) -> Result<creep_curve::Path, schlupf::Error> {
        let own = Creepages::of(&case.problem.kinematics);
        let spin = self.spin.unwrap_or([own.spin; 2]);
        if let Some((range, direction)) = self.total {
            return creep_curve::Path::in_direction(range, direction, spin);
        }
        let x = self.creepage_x.unwrap_or([own.x; 2]);
        let y = self.creepage_y.unwrap_or([own.y; 2]);
        let [start, end] = [0, 1].map(|k| Creepages { x: x[k], y: y[k], spin: spin[k] });
        creep_curve::Path::new(start, end)
    }

    /// The option that makes a field of the case count for nothing.
    fn option_in_place_of(&self, field: &str) -> Option<&'static str> {
        match field {
            "kinematics.creepage_x" | "kinematics.angular_velocity" | "kinematics.wheel_radius" => {
                self.total.map(|_| CREEPAGE).or(self.creepage_x.map(|_| CREEPAGE_X))
            }
            "kinematics.creepage_y" | "kinematics.yaw_angle" => {
                self.total.map(|_| CREEPAGE).or(self.creepage_y.map(|_| CREEPAGE_Y))
            }
            "kinematics.spin" => self.spin.map(|_| SPIN),
            _ => None,
        }
    }
}

/// One curve to compute.
pub struct Member {
    value: Option<String>,
    case: Case,
    path: creep_curve::Path,
}

/// One, or one for each value of the family.
fn members(
    case: &Case,
    varied: &Varied,
    family: Option<&Family>,
    watch: Watch,
) -> Result<Vec<Member>, Failure> {
    let member = |value: Option<&String>, case: Case| {
        let path = varied.path(&case).map_err(|error| varied.failure(&case, &error))?;
        Ok(Member { value: value.cloned(), case, path })
    };
    let Some(family) = family else {
        return Ok(vec![member(None, case.clone())?]);
    };
    if let Some(option) = varied.option_in_place_of(family.field) {
        let field = family.field;
        let reason = format!("{OVER} must not vary {field}, in place of which {option} varies");
        return Err(Failure::Arguments(reason));
    }
    let members = family.members(case, watch)?;
    family.values.iter().zip(members).map(|(value, case)| member(Some(value), case)).collect()
}

impl Varied {
    /// An error of the core about a curve: of the options that ask for it, or of the case.
    fn failure(&self, case: &Case, error: &schlupf::Error) -> Failure {
        let field = quantity_field(error.quantity());
        let is_of_option = self.option_in_place_of(field).is_some();
        if is_of_option {
            Failure::Arguments(format!("{}: {}", self.text, error.text(&FieldNames::CASE)))
        } else {
            Failure::Case(case.explain(error).into())
        }
    }
}

impl Member {
    fn check(&self, sampling: &Sampling, varied: &Varied) -> Result<(), Failure> {
        self.case.require_steady("a creep curve is").map_err(CaseErrors::from)?;
        creep_curve::check(&self.case.problem, &self.path, sampling)
            .map_err(|error| varied.failure(&self.case, &error))
    }

    fn trace(&self, sampling: &Sampling, watch: Watch) -> Result<CreepCurve, Failure> {
        let mut solver = self.case.solver();
        creep_curve::trace(&mut *solver, &self.case.problem, &self.path, sampling, watch)
            .map_err(|error| Failure::Case(self.case.explain(&error).into()))
    }
}
