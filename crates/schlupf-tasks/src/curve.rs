//! Creep curves: one, or one for each value of a field, or of two fields.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::output::creep_curve::{CurveFamily, FieldValue, Member};
use schlupf::analysis::creep_curve::{
    self, CreepCurve, Creepages, MAX_POINTS, Path, Sampling, VariedForce,
};
use schlupf::numerics::parallel;
use schlupf::{Problem, Quantity, Watch};
use schlupf_case::fields::{Choice, readable};
use schlupf_case::quantity_field;
use schlupf_case::{Case, DataUrl, Family, FieldNames, FieldPath, Points, field, fields};

use crate::TaskError;
use crate::request::{Kind, Rule, request};
use crate::task::{Found, Given, Task, Wanted};

request! {
    /// Which curves: what varies along each, what is another for each, and where the points are.
    Request {
        /// Vary the longitudinal creepage, such as 0..0.05 or 0,0.001,0.05; several creepages vary
        /// together, each linearly with the others.
        creepage_x: Option<Points> = Kind::points(field!("kinematics.creepage_x"));
        /// Vary the lateral creepage.
        creepage_y: Option<Points> = Kind::points(field!("kinematics.creepage_y"));
        /// Vary the spin creepage, such as "0..2 1/m".
        spin: Option<Points> = Kind::points(field!("kinematics.spin"));
        /// Vary the total creepage in a direction, in place of both creepages.
        creepage: Option<Points> = Kind::points(field!("kinematics.creepage_x"));
        /// Direction of the total creepage, from longitudinal (0 deg) to lateral (90 deg).
        direction: Option<f64> = Kind::angle();
        /// Vary the longitudinal force on the wheel, such as "0..-20 kN" (negative in braking), in
        /// place of all creepages: its creepage is found.
        force_x: Option<Points> = Kind::points(field!("kinematics.force_x"));
        /// Vary the same over the load, such as 0..0.25 (positive in braking).
        traction_coefficient: Option<Points> = Kind::points(field!("kinematics.traction_coefficient"));
        /// Vary the lateral force on the wheel.
        force_y: Option<Points> = Kind::points(field!("kinematics.force_y"));
        /// Vary the spin moment on the wheel, such as "0..20 N m".
        moment_z: Option<Points> = Kind::points(field!("kinematics.moment_z"));
        /// Draw one curve for each value of a field, such as 10, 20 and 30 m/s of kinematics.speed.
        /// At least three numbers make a map over the creepage and the field, two fields one of
        /// the largest force over both.
        over: Vec<Family> = Kind::family();
        /// Number of points of each curve over a range; by default 41.
        points: Option<usize> = Kind::count(2, MAX_POINTS);
        /// Spacing of the points over a range; by default refined over a creepage and even over a
        /// force.
        spacing: Option<&'static str> = Kind::choice(&SPACINGS);
        => RULES
    }
}

const REFINED: &str = "refined";
const EVEN: &str = "even";

/// Shares of the way that agree with a straight line: also those of numbers in single precision.
const STRAIGHT: f64 = 1e-6;

/// What lies at a share of the way.
fn mix([from, to]: [f64; 2], share: f64) -> f64 {
    from * (1.0 - share) + to * share
}

/// The share of the way from the first value to the last at which each is.
fn shares(values: &[f64]) -> impl Fn(usize) -> f64 {
    let (from, to) = (values[0], values[values.len() - 1]);
    move |k| (values[k] - from) / (to - from)
}

/// How the points of a curve are spaced.
const SPACINGS: [Choice; 2] = [
    Choice { name: REFINED, doc: "finer near zero creepage" },
    Choice { name: EVEN, doc: "equal steps" },
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
    sampling: Sampling,
}

impl Request {
    /// Traces all curves, on several threads.
    fn trace(
        &self,
        title: String,
        members: &[Planned],
        watch: Watch,
    ) -> Result<CurveFamily, TaskError> {
        let done: Vec<AtomicUsize> = members.iter().map(|_| AtomicUsize::new(0)).collect();
        let total = members.iter().map(|member| member.sampling.points()).sum();
        let each = members.iter().zip(&done).collect();
        let found = parallel::try_map(each, |(member, own): (&Planned, &AtomicUsize)| {
            let traced = member.member(&|progress| {
                own.store(progress.done, Ordering::Relaxed);
                let done = done.iter().map(|done| done.load(Ordering::Relaxed)).sum();
                watch(progress.of(done, total))
            });
            traced.map_err(|error| self.failure(&member.case, &member.values, &error))
        })?;
        let over = self.over.iter().map(|family| family.field.to_string()).collect();
        Ok(CurveFamily::new(title, over, self.spacing(), found))
    }

    /// The quantities of [`VARIED`], with the points of those that vary.
    fn varied(&self) -> [(Quantity, Option<&Points>); VARIED.len()] {
        [
            (Quantity::CreepageX, self.creepage_x.as_ref()),
            (Quantity::CreepageY, self.creepage_y.as_ref()),
            (Quantity::Spin, self.spin.as_ref()),
            (Quantity::Creepage, self.creepage.as_ref()),
            (Quantity::ForceX, self.force_x.as_ref()),
            (Quantity::ForceOverLoad, self.traction_coefficient.as_ref()),
            (Quantity::ForceY, self.force_y.as_ref()),
            (Quantity::MomentZ, self.moment_z.as_ref()),
        ]
    }

    /// The force that varies, with its name and its range.
    fn force(&self) -> Option<(&'static str, VariedForce, [f64; 2])> {
        let forces = [VariedForce::X, VariedForce::OverLoad, VariedForce::Y, VariedForce::MomentZ];
        let mut varied = VARIED.iter().zip(self.varied());
        varied.find_map(|(name, (quantity, points))| {
            let force = forces.into_iter().find(|force| force.quantity() == quantity)?;
            Some((*name, force, points?.ends()))
        })
    }

    /// The total creepage and its direction, if it varies.
    fn total(&self) -> Option<([f64; 2], f64)> {
        Some((self.creepage.as_ref()?.ends(), self.direction?))
    }

    /// What is given point by point: its name and quantity, and the points.
    fn each(&self) -> impl Iterator<Item = (&'static str, Quantity, &[f64])> {
        VARIED.iter().zip(self.varied()).filter_map(|(name, (quantity, points))| match points {
            Some(Points::Each(values)) => Some((*name, quantity, &values[..])),
            _ => None,
        })
    }

    /// How the points are spaced. The creepage changes fastest with a force where that is largest.
    fn spacing(&self) -> &'static str {
        let by_default = if self.force().is_some() { EVEN } else { REFINED };
        let given = self.each().next().map(|_| CurveFamily::GIVEN);
        given.or(self.spacing).unwrap_or(by_default)
    }

    /// The points along a path.
    fn sampling(&self, path: &Path) -> Sampling {
        let abscissa = path.quantity();
        if let Some((.., values)) = self.each().find(|(_, quantity, _)| *quantity == abscissa) {
            return Sampling::At(values.to_vec());
        }
        if let Some((.., values)) = self.each().next() {
            let share = shares(values);
            let at = |k: usize| mix(path.range(), share(k));
            return Sampling::At((0..values.len()).map(at).collect());
        }
        let points = self.points.unwrap_or(Sampling::default().points());
        if self.spacing() == REFINED { Sampling::Refined(points) } else { Sampling::Even(points) }
    }

    /// Refuses points that are given twice: by others, or by number and spacing.
    fn check_points(&self) -> Result<(), TaskError> {
        let Some((first, _, values)) = self.each().next() else { return Ok(()) };
        self.asked.check_range(first, &["points", "spacing"])?;
        let share = shares(values);
        for (other, _, others) in self.each().skip(1) {
            let [own, name] = [first, other].map(|name| self.asked.name(name));
            if others.len() != values.len() {
                let (count, points) = (others.len(), values.len());
                let reason = format!("{name} must have {points} points, as {own}, but has {count}");
                return Err(TaskError::Request(reason));
            }
            let of_others = shares(others);
            let off = (0..values.len()).find(|k| (of_others(*k) - share(*k)).abs() > STRAIGHT);
            if let Some(k) = off {
                let wanted = mix([others[0], others[others.len() - 1]], share(k));
                return Err(TaskError::Request(format!(
                    "{name} must vary linearly with {own}, but is {} in place of {} where that is {}",
                    readable(others[k]),
                    readable(wanted),
                    readable(values[k])
                )));
            }
        }
        Ok(())
    }

    /// One, or one for each value of the family, or for each pair of values of two.
    fn members(&self, case: &Case, watch: Watch) -> Result<Vec<Planned>, TaskError> {
        self.check_points()?;
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
            Ok(Planned { values, case, sampling: self.sampling(&path), path })
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
        let Planned { values, case, path, sampling } = member;
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
        creep_curve::check(&case.problem, path, sampling)
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
        if self.creepage_x.is_some() || self.creepage.is_some() {
            forces.x = None;
        }
        if self.creepage_y.is_some() || self.creepage.is_some() {
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
        let ends = |points: &Option<Points>, own| points.as_ref().map_or([own; 2], Points::ends);
        let spin = ends(&self.spin, own.spin);
        if let Some((range, direction)) = self.total() {
            return Path::in_direction(range, direction, spin);
        }
        let x = ends(&self.creepage_x, own.x);
        let y = ends(&self.creepage_y, own.y);
        let [start, end] = [0, 1].map(|k| Creepages { x: x[k], y: y[k], spin: spin[k] });
        Path::new(start, end)
    }
}

impl Planned {
    fn member(&self, watch: Watch) -> Result<Member, schlupf::Error> {
        let curve = self.trace(watch)?;
        let of_curve = curve.warnings.iter().map(|w| w.message(&FieldNames::CASE));
        let warnings = self.case.notices.iter().cloned().chain(of_curve).collect();
        Ok(Member { values: self.values.clone(), warnings, curve })
    }

    fn trace(&self, watch: Watch) -> Result<CreepCurve, schlupf::Error> {
        let Self { case, path, sampling, .. } = self;
        let problem = Problem { kinematics: case.motion, ..case.problem.clone() };
        let mut solver = case.solver_of_motion();
        let mut curve = creep_curve::trace(&mut *solver, &problem, path, sampling, watch)?;
        if let Some(wheel) = &case.wheel {
            curve.normal.load = wheel.force[2];
        }
        Ok(curve)
    }
}
