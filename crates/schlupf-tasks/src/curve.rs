//! Creep curves: one, or one for each value of a field, or of two fields.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::output::creep_curve::{CurveFamily, FieldValue, Member};
use schlupf::analysis::creep_curve::{
    self, CreepCurve, Creepages, MAX_POINTS, Path, Sampling, Spacing, VariedForce,
};
use schlupf::numerics::parallel;
use schlupf::{Problem, Quantity, Watch};
use schlupf_case::fields::Choice;
use schlupf_case::{Case, DataUrl, Family, FieldNames, FieldPath, field, fields, quantity_field};

use crate::TaskError;
use crate::request::{Kind, Rule, request};
use crate::task::{Found, Given, Task, Wanted};

request! {
    /// Which curves: what varies along each, what is another for each, and where the points are.
    Request {
        /// Vary the longitudinal creepage, such as 0..0.05; several creepages vary together.
        creepage_x: Option<[f64; 2]> = Kind::range(field!("kinematics.creepage_x"));
        /// Vary the lateral creepage.
        creepage_y: Option<[f64; 2]> = Kind::range(field!("kinematics.creepage_y"));
        /// Vary the spin creepage, such as "0..2 1/m".
        spin: Option<[f64; 2]> = Kind::range(field!("kinematics.spin"));
        /// Vary the total creepage in a direction, in place of both creepages.
        creepage: Option<[f64; 2]> = Kind::range(field!("kinematics.creepage_x"));
        /// Direction of the total creepage, from longitudinal (0 deg) to lateral (90 deg).
        direction: Option<f64> = Kind::angle();
        /// Vary the longitudinal force on the wheel, such as "0..-20 kN" (negative in braking), in
        /// place of all creepages: its creepage is found.
        force_x: Option<[f64; 2]> = Kind::range(field!("kinematics.force_x"));
        /// Vary the same over the load, such as 0..0.25 (positive in braking).
        traction_coefficient: Option<[f64; 2]> = Kind::range(field!("kinematics.traction_coefficient"));
        /// Vary the lateral force on the wheel.
        force_y: Option<[f64; 2]> = Kind::range(field!("kinematics.force_y"));
        /// Vary the spin moment on the wheel, such as "0..20 N m".
        moment_z: Option<[f64; 2]> = Kind::range(field!("kinematics.moment_z"));
        /// Draw one curve for each value of a field, such as 10, 20 and 30 m/s of kinematics.speed.
        /// At least three numbers make a map over the creepage and the field, two fields one of
        /// the largest force over both.
        over: Vec<Family> = Kind::family();
        /// Number of points of each curve.
        points: usize = Kind::count(2, MAX_POINTS), default(Sampling::default().points);
        /// Spacing of the points; by default refined over a creepage and even over a force.
        spacing: Option<&'static str> = Kind::choice(&SPACINGS);
        => RULES
    }
}

const REFINED: &str = "refined";

/// How the points of a curve are spaced.
const SPACINGS: [Choice; 2] = [
    Choice { name: REFINED, doc: "finer near zero creepage" },
    Choice { name: "even", doc: "equal steps" },
];

/// What may vary along a curve: creepages, then forces.
const VARIED: &[&str] = &[
    "creepage_x",
    "creepage_y",
    "spin",
    "creepage",
    "force_x",
    "traction_coefficient",
    "force_y",
    "moment_z",
];
/// Fields that say how the wheel moves in each direction.
const LONGITUDINAL: &[FieldPath] = &fields![
    "kinematics.creepage_x",
    "kinematics.angular_velocity",
    "kinematics.wheel_radius",
    "kinematics.force_x",
    "kinematics.traction_coefficient",
    "kinematics.wheel_torque",
];
const LATERAL: &[FieldPath] =
    &fields!["kinematics.creepage_y", "kinematics.yaw_angle", "kinematics.force_y"];
const TURNING: &[FieldPath] = &fields!["kinematics.spin", "kinematics.moment_z"];

const CREEPAGES: &[&str] = VARIED.split_at(4).0;
const FORCES: &[&str] = VARIED.split_at(4).1;

const RULES: &[Rule] = &[
    Rule::AnyOf(VARIED),
    Rule::Apart(FORCES, VARIED),
    Rule::Apart(&["creepage"], &["creepage_x", "creepage_y"]),
    Rule::With(&["creepage"], &["direction"]),
    Rule::With(&["direction"], &["creepage"]),
];

/// `curve`.
pub struct Curve;

impl Task for Curve {
    const NAME: &'static str = "curve";
    const ABOUT: &'static str = "Compute creep curves: forces against creepage";
    const HAS_SEVERAL: bool = true;
    type Request = Request;
    type Report = CurveFamily;

    fn run(
        of: &Given,
        request: Request,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<CurveFamily>, TaskError> {
        let case = of.case.pose(watch)?;
        let members = request.members(&case, watch)?;
        members.iter().try_for_each(|member| request.check(member))?;
        Ok(request.trace(case.title, &members, watch)?.into())
    }
}

/// One curve to compute.
#[derive(Debug)]
struct Planned {
    values: Vec<FieldValue>,
    case: Case,
    path: Path,
}

impl Request {
    /// Traces all curves, on several threads.
    fn trace(
        &self,
        title: String,
        members: &[Planned],
        watch: Watch,
    ) -> Result<CurveFamily, TaskError> {
        let sampling = self.sampling();
        let done: Vec<AtomicUsize> = members.iter().map(|_| AtomicUsize::new(0)).collect();
        let total = members.len() * sampling.points;
        let each = members.iter().zip(&done).collect();
        let found = parallel::try_map(each, |(member, own): (&Planned, &AtomicUsize)| {
            let traced = member.member(&sampling, &|progress| {
                own.store(progress.done, Ordering::Relaxed);
                let done = done.iter().map(|done| done.load(Ordering::Relaxed)).sum();
                watch(progress.of(done, total))
            });
            traced.map_err(|error| self.failure(&member.case, &member.values, &error))
        })?;
        let over = self.over.iter().map(|family| family.field.to_string()).collect();
        Ok(CurveFamily::new(title, over, sampling, found))
    }

    /// The force that varies, with its name and its range.
    fn force(&self) -> Option<(&'static str, VariedForce, [f64; 2])> {
        let ranges = [
            (VariedForce::X, self.force_x),
            (VariedForce::OverLoad, self.traction_coefficient),
            (VariedForce::Y, self.force_y),
            (VariedForce::MomentZ, self.moment_z),
        ];
        let mut forces = FORCES.iter().zip(ranges);
        forces.find_map(|(name, (force, range))| Some((*name, force, range?)))
    }

    /// The total creepage and its direction, if it varies.
    fn total(&self) -> Option<([f64; 2], f64)> {
        self.creepage.zip(self.direction)
    }

    /// The creepage changes fastest with a force where that is largest.
    fn sampling(&self) -> Sampling {
        let is_refined = self.spacing.map_or(self.force().is_none(), |name| name == REFINED);
        let spacing = if is_refined { Spacing::Refined } else { Spacing::Even };
        Sampling { points: self.points, spacing }
    }

    /// One, or one for each value of the family, or for each pair of values of two.
    fn members(&self, case: &Case, watch: Watch) -> Result<Vec<Planned>, TaskError> {
        self.check_fields()?;
        let mut cases = vec![(Vec::new(), case.clone())];
        for family in &self.over {
            let mut each = Vec::with_capacity(cases.len() * family.values.len());
            for (values, case) in &cases {
                let members = family.members(case, watch)?;
                for (text, member) in family.values.iter().zip(members) {
                    let number = member.number(family.field);
                    let value = FieldValue { text: DataUrl::label(text).to_owned(), number };
                    each.push(([values, &[value][..]].concat(), member));
                }
            }
            cases = each;
        }
        let member = |(values, case): (Vec<FieldValue>, Case)| {
            let path = self.path(&case);
            let path = path.map_err(|error| self.failure(&case, &values, &error))?;
            let case = self.in_place_of_forces(case);
            Ok(Planned { values, case, path })
        };
        let members = cases.into_iter().map(member).collect::<Result<Vec<_>, TaskError>>()?;
        self.check_map(&members)?;
        Ok(members)
    }

    /// Refuses fields that cannot vary beside the creepages, or together.
    fn check_fields(&self) -> Result<(), TaskError> {
        let over = self.asked.name("over");
        for (k, Family { field, .. }) in self.over.iter().enumerate() {
            if let Some(name) = self.in_place_of(*field) {
                let reason =
                    format!("{over} must not vary {field}, in place of which {name} varies");
                return Err(TaskError::Request(reason));
            }
            if self.over[..k].iter().any(|family| family.field == *field) {
                let reason = format!("{over} must vary two different fields, not {field} twice");
                return Err(TaskError::Request(reason));
            }
        }
        if self.over.len() > 2 {
            let reason =
                format!("{over} can vary two fields at most, but varies {}", self.over.len());
            return Err(TaskError::Request(reason));
        }
        Ok(())
    }

    /// Refuses two fields that do not make a map.
    fn check_map(&self, members: &[Planned]) -> Result<(), TaskError> {
        let over = self.asked.name("over");
        if self.over.len() < 2 {
            return Ok(());
        }
        if let Some((force, ..)) = self.force() {
            let force = self.asked.name(force);
            let reason = format!(
                "{over} varies two fields for a map of the largest forces, but {force} prescribes \
                 the force: give {over} once, or vary a creepage"
            );
            return Err(TaskError::Request(reason));
        }
        for (k, family) in self.over.iter().enumerate() {
            let is_number = |member: &Planned| member.values[k].number.is_some();
            if !members.iter().all(is_number) {
                let reason = format!(
                    "{over} varies two fields for a map, so both must be numbers, but {} is none",
                    family.field
                );
                return Err(TaskError::Request(reason));
            }
            if family.values.len() < 2 {
                let reason = format!(
                    "{over} varies two fields for a map, so both must have at least two values, \
                     but {} has one",
                    family.field
                );
                return Err(TaskError::Request(reason));
            }
        }
        Ok(())
    }

    fn check(&self, member: &Planned) -> Result<(), TaskError> {
        let Planned { values, case, path } = member;
        case.require_steady("a creep curve is")?;
        let force = self.force().filter(|(_, force, _)| force.creepage() != Quantity::CreepageX);
        let creepage = CREEPAGES[1..].iter().copied().find(|name| self.asked.has(name));
        let other = creepage.or(force.map(|(name, ..)| name));
        if let (Some(_), Some(name)) = (&case.wheel, other) {
            let [name, creepage_x] = [name, "creepage_x"].map(|name| self.asked.name(name));
            return Err(TaskError::Request(format!(
                "{name} must be left out with normal.model = \"wheel-rail\", where lateral creepage \
                 and spin follow from the motion of the wheelset: a curve of a wheel varies \
                 {creepage_x}"
            )));
        }
        creep_curve::check(&case.problem, path, &self.sampling())
            .map_err(|error| self.failure(case, values, &error))
    }

    /// What varies and makes a field of the case count for nothing.
    fn in_place_of(&self, field: FieldPath) -> Option<String> {
        let force = |creepage| {
            self.force().filter(|(_, force, _)| force.creepage() == creepage).map(|(name, ..)| name)
        };
        let given = |name: &'static str| self.asked.has(name).then_some(name);
        let name = if LONGITUDINAL.contains(&field) {
            given("creepage").or(given("creepage_x")).or(force(Quantity::CreepageX))
        } else if LATERAL.contains(&field) {
            given("creepage").or(given("creepage_y")).or(force(Quantity::CreepageY))
        } else if TURNING.contains(&field) {
            given("spin").or(force(Quantity::Spin))
        } else {
            None
        };
        name.map(|name| self.asked.name(name))
    }

    /// An error of the core about a curve: of what varies, with the fields that make the curve one
    /// of several, or of the case.
    fn failure(&self, case: &Case, values: &[FieldValue], error: &schlupf::Error) -> TaskError {
        let field = quantity_field(error.quantity());
        if field.is_some_and(|field| self.in_place_of(field).is_some()) {
            let given = self.asked.given(&[CREEPAGES, &["direction"], FORCES].concat());
            let of_curve = self.over.iter().zip(values);
            let of_curve =
                of_curve.map(|(family, value)| format!("{} = {}", family.field, value.text));
            let of_curve: Vec<String> = of_curve.collect();
            let of_curve = if of_curve.is_empty() {
                String::new()
            } else {
                format!(" with {}", of_curve.join(", "))
            };
            TaskError::Request(format!("{given}{of_curve}: {}", error.text(&FieldNames::CASE)))
        } else {
            case.explain(error).into()
        }
    }

    /// The case without the forces of the creepages that vary in their place.
    fn in_place_of_forces(&self, mut case: Case) -> Case {
        let forces = &mut case.problem.prescribed;
        if self.creepage_x.or(self.creepage).is_some() {
            forces.x = None;
        }
        if self.creepage_y.or(self.creepage).is_some() {
            forces.y = None;
        }
        if self.spin.is_some() {
            forces.moment_z = None;
        }
        case
    }

    /// The creepages of a case with those that vary in their place.
    fn path(&self, case: &Case) -> Result<Path, schlupf::Error> {
        let own = Creepages::of(&case.motion);
        if let Some((_, force, range)) = self.force() {
            return Path::over_force(force, range, own);
        }
        let spin = self.spin.unwrap_or([own.spin; 2]);
        if let Some((range, direction)) = self.total() {
            return Path::in_direction(range, direction, spin);
        }
        let x = self.creepage_x.unwrap_or([own.x; 2]);
        let y = self.creepage_y.unwrap_or([own.y; 2]);
        let [start, end] = [0, 1].map(|k| Creepages { x: x[k], y: y[k], spin: spin[k] });
        Path::new(start, end)
    }
}

impl Planned {
    fn member(&self, sampling: &Sampling, watch: Watch) -> Result<Member, schlupf::Error> {
        let curve = self.trace(sampling, watch)?;
        let of_curve = curve.warnings.iter().map(|w| w.message(&FieldNames::CASE));
        let warnings = self.case.notices.iter().cloned().chain(of_curve).collect();
        Ok(Member { values: self.values.clone(), warnings, curve })
    }

    fn trace(&self, sampling: &Sampling, watch: Watch) -> Result<CreepCurve, schlupf::Error> {
        let Self { case, path, .. } = self;
        let problem = Problem { kinematics: case.motion, ..case.problem.clone() };
        let mut solver = case.solver_of_motion();
        let mut curve = creep_curve::trace(&mut *solver, &problem, path, sampling, watch)?;
        if let Some(wheel) = &case.wheel {
            curve.normal.load = wheel.force[2];
        }
        Ok(curve)
    }
}
