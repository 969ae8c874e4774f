//! `schlupf curve`.

use clap::{ArgGroup, Args, ValueEnum};
use schlupf::Watch;
use schlupf::creep_curve::{MAX_POINTS, Sampling, Spacing, VariedForce};
use schlupf_case::{
    CaseError, CaseErrors, CaseFile, Family, Place, direction, quantity_field, range,
};
use schlupf_output::creep_curve::CurveFamily;
use schlupf_tasks::curve::{self, Names, Plan, Request, Varied};

use crate::arguments::{CaseArguments, OutputArguments};
use crate::failure::Failure;
use crate::outputs::Input;
use crate::progress::Progress;
use crate::task::{Found, Task};

const CREEPAGE_X: &str = "--creepage-x";
const CREEPAGE_Y: &str = "--creepage-y";
const SPIN: &str = "--spin";
const CREEPAGE: &str = "--creepage";
const DIRECTION: &str = "--direction";
const FORCE_X: &str = "--force-x";
const TRACTION_COEFFICIENT: &str = "--traction-coefficient";
const FORCE_Y: &str = "--force-y";
const MOMENT_Z: &str = "--moment-z";
const OVER: &str = "--over";

/// Which creep curves, and where to write them.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("varied")
    .args(["creepage_x", "creepage_y", "spin", "creepage"]).multiple(true))]
#[command(group = ArgGroup::new("forces")
    .args(["force_x", "traction_coefficient", "force_y", "moment_z"]).conflicts_with("varied"))]
#[command(group = ArgGroup::new("abscissa").args(["creepage_x", "creepage_y", "spin", "creepage",
    "force_x", "traction_coefficient", "force_y", "moment_z"]).required(true).multiple(true))]
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
    /// Vary the longitudinal force on the wheel, such as "0..-20 kN" (negative in braking): its
    /// creepage is found
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub force_x: Option<String>,
    /// Vary the same over the load, such as 0..0.25 (positive in braking)
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub traction_coefficient: Option<String>,
    /// Vary the lateral force on the wheel
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub force_y: Option<String>,
    /// Vary the spin moment on the wheel, such as "0..20 N m"
    #[arg(long, value_name = "START..END", allow_hyphen_values = true)]
    pub moment_z: Option<String>,
    /// Number of points
    #[arg(long, value_name = "N", default_value_t = Sampling::default().points,
          value_parser = number_of_points)]
    pub points: usize,
    /// Spacing of the points; refined over a creepage, even over a force unless given
    #[arg(long, value_enum)]
    pub spacing: Option<SpacingArgument>,
    /// Draw one curve for each value of a field, such as kinematics.speed="10 m/s,20 m/s" or
    /// kinematics.speed="5..50 m/s:10"; three numbers or more make a map, given twice it is one of
    /// the largest force over both fields
    #[arg(long, value_name = "SECTION.FIELD=VALUE,…")]
    pub over: Vec<String>,
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
        Ok(curve::plan(&file, self.request().map_err(CaseErrors::from)?, watch)?)
    }

    fn inputs(&self, file: &CaseFile) -> Vec<Input> {
        let mut inputs = Input::of_case(&self.case, file);
        // What is wrong with the option is told with the plan.
        let families = self.over.iter().filter_map(|text| Family::parse(OVER, text).ok());
        let files = families.flat_map(|family| family.files(file));
        inputs.extend(files.map(|path| Input { what: OVER.to_owned(), path, except: None }));
        inputs
    }

    fn find(&self, plan: Plan, progress: &Progress) -> Result<Found<CurveFamily>, Failure> {
        Ok(plan.find(&progress.watch())?.into())
    }
}

impl Curve {
    fn request(&self) -> Result<Request, CaseError> {
        let over = self.over.iter().map(|text| Family::parse(OVER, text));
        Ok(Request {
            varied: self.varied()?,
            over: over.collect::<Result<_, _>>()?,
            sampling: self.sampling(),
            names: Names {
                creepage_x: CREEPAGE_X,
                creepage_y: CREEPAGE_Y,
                spin: SPIN,
                creepage: CREEPAGE,
                force: self.force().map_or(FORCE_X, |(_, option, _)| option),
                over: OVER,
                given: self.given(),
            },
        })
    }

    fn varied(&self) -> Result<Varied, CaseError> {
        // Clap drops what an option requires where that conflicts with another one.
        if let Some(text) = self.direction.as_deref().filter(|_| self.creepage.is_none()) {
            let place = Place::Override { option: DIRECTION.into(), text: text.to_owned() };
            let reason = format!("{DIRECTION} is that of {CREEPAGE}, which is not given");
            return Err(CaseError::new("", reason, place));
        }
        let range = |option, field, text: &Option<String>| {
            text.as_deref().map(|text| range(option, field, text)).transpose()
        };
        let total = range(CREEPAGE, "kinematics.creepage_x", &self.creepage)?;
        let angle = self.direction.as_deref().map(|text| direction(DIRECTION, text)).transpose()?;
        let force = self.force().map(|(force, option, text)| {
            let field = quantity_field(force.quantity());
            schlupf_case::range(option, field, text).map(|range| (force, range))
        });
        Ok(Varied {
            force: force.transpose()?,
            creepage_x: range(CREEPAGE_X, "kinematics.creepage_x", &self.creepage_x)?,
            creepage_y: range(CREEPAGE_Y, "kinematics.creepage_y", &self.creepage_y)?,
            spin: range(SPIN, "kinematics.spin", &self.spin)?,
            total: total.zip(angle),
        })
    }

    /// The force that varies, its option and the range.
    fn force(&self) -> Option<(VariedForce, &'static str, &str)> {
        let forces = [
            (VariedForce::X, FORCE_X, &self.force_x),
            (VariedForce::OverLoad, TRACTION_COEFFICIENT, &self.traction_coefficient),
            (VariedForce::Y, FORCE_Y, &self.force_y),
            (VariedForce::MomentZ, MOMENT_Z, &self.moment_z),
        ];
        forces.into_iter().find_map(|(force, option, text)| Some((force, option, text.as_deref()?)))
    }

    /// The options as they were given.
    fn given(&self) -> String {
        let given = [
            (CREEPAGE_X, &self.creepage_x),
            (CREEPAGE_Y, &self.creepage_y),
            (SPIN, &self.spin),
            (CREEPAGE, &self.creepage),
            (DIRECTION, &self.direction),
            (FORCE_X, &self.force_x),
            (TRACTION_COEFFICIENT, &self.traction_coefficient),
            (FORCE_Y, &self.force_y),
            (MOMENT_Z, &self.moment_z),
        ];
        let given =
            given.iter().filter_map(|(option, text)| Some(format!("{option} {}", text.as_ref()?)));
        given.collect::<Vec<_>>().join(" ")
    }

    fn sampling(&self) -> Sampling {
        let spacing = match self.spacing {
            Some(SpacingArgument::Even) => Spacing::Even,
            // The creepage changes fastest with a force where that is largest.
            None if self.force().is_some() => Spacing::Even,
            Some(SpacingArgument::Refined) | None => Spacing::Refined,
        };
        Sampling { points: self.points, spacing }
    }
}
