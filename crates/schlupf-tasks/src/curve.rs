//! Creep curves: one, or one for each value of a field, or of two fields.

use std::sync::atomic::{AtomicUsize, Ordering};

use schlupf::creep_curve::{self, CreepCurve, Creepages, Path, Sampling, VariedForce};
use schlupf::{Problem, Quantity, Watch, parallel};
use schlupf_case::{Case, CaseFile, Family, FieldNames, quantity_field};
use schlupf_output::creep_curve::{CurveFamily, FieldValue, Member as Found};

use crate::TaskError;

/// Which curves.
#[derive(Debug, Clone)]
pub struct Request {
    /// What varies along each.
    pub varied: Varied,
    /// The fields that have other values for each curve, if there are several: at most two, of
    /// which the last varies fastest.
    pub over: Vec<Family>,
    /// Where the points are.
    pub sampling: Sampling,
    /// What messages call all that.
    pub names: Names,
}

/// Which creepages vary, or which force, and from where to where; the others are those of the case.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Varied {
    /// ξ, dimensionless.
    pub creepage_x: Option<[f64; 2]>,
    /// η, dimensionless.
    pub creepage_y: Option<[f64; 2]>,
    /// φ, in 1/m.
    pub spin: Option<[f64; 2]>,
    /// Total creepage, dimensionless, and its direction, in rad from longitudinal to lateral; in
    /// place of ξ and η.
    pub total: Option<([f64; 2], f64)>,
    /// A prescribed force (in the unit of its quantity) in place of its creepage; then no creepage
    /// varies.
    pub force: Option<(VariedForce, [f64; 2])>,
}

/// What messages call the parts of a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// ξ.
    pub creepage_x: &'static str,
    /// η.
    pub creepage_y: &'static str,
    /// φ.
    pub spin: &'static str,
    /// The total creepage.
    pub creepage: &'static str,
    /// The force that varies; of no matter if none does.
    pub force: &'static str,
    /// The family.
    pub over: &'static str,
    /// What varies, as it was given.
    pub given: String,
}

/// The curves to compute, checked.
#[derive(Debug)]
pub struct Plan {
    title: String,
    request: Request,
    members: Vec<Member>,
}

/// One curve to compute.
#[derive(Debug)]
struct Member {
    values: Vec<FieldValue>,
    case: Case,
    path: Path,
}

/// Poses the cases.
///
/// # Errors
/// A case that is wrong or has a history, and creepages that no wheel can have.
pub fn plan(file: &CaseFile, request: Request, watch: Watch) -> Result<Plan, TaskError> {
    let case = file.pose(watch)?;
    let members = request.members(&case, watch)?;
    members.iter().try_for_each(|member| request.check(member))?;
    Ok(Plan { title: case.title, request, members })
}

impl Plan {
    /// Traces all curves, on several threads.
    ///
    /// # Errors
    /// Whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<CurveFamily, TaskError> {
        let Self { title, request, members } = self;
        let sampling = request.sampling;
        let done: Vec<AtomicUsize> = members.iter().map(|_| AtomicUsize::new(0)).collect();
        let total = members.len() * sampling.points;
        let each = members.iter().zip(&done).collect();
        let found = parallel::try_map(each, |(member, own): (&Member, &AtomicUsize)| {
            let found = member.found(&sampling, &|progress| {
                own.store(progress.done, Ordering::Relaxed);
                let done = done.iter().map(|done| done.load(Ordering::Relaxed)).sum();
                watch(progress.of(done, total))
            });
            found.map_err(|error| request.failure(&member.case, &member.values, &error))
        })?;
        let over = request.over.iter().map(|family| family.field.to_owned()).collect();
        Ok(CurveFamily::new(title, over, sampling, found))
    }
}

impl Request {
    /// One, or one for each value of the family, or for each pair of values of two.
    fn members(&self, case: &Case, watch: Watch) -> Result<Vec<Member>, TaskError> {
        self.check_fields()?;
        let mut cases = vec![(Vec::new(), case.clone())];
        for family in &self.over {
            let mut each = Vec::with_capacity(cases.len() * family.values.len());
            for (values, case) in &cases {
                let members = family.members(case, watch)?;
                for (text, member) in family.values.iter().zip(members) {
                    let number = member.number(family.field);
                    let value = FieldValue { text: text.clone(), number };
                    each.push(([values, &[value][..]].concat(), member));
                }
            }
            cases = each;
        }
        let member = |(values, case): (Vec<FieldValue>, Case)| {
            let path = self.varied.path(&case);
            let path = path.map_err(|error| self.failure(&case, &values, &error))?;
            let case = self.varied.in_place_of_forces(case);
            Ok(Member { values, case, path })
        };
        let members = cases.into_iter().map(member).collect::<Result<Vec<_>, TaskError>>()?;
        self.check_map(&members)?;
        Ok(members)
    }

    /// Refuses fields that cannot vary beside the creepages, or together.
    fn check_fields(&self) -> Result<(), TaskError> {
        let over = self.names.over;
        for (k, Family { field, .. }) in self.over.iter().enumerate() {
            if let Some(name) = self.in_place_of(field) {
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
    fn check_map(&self, members: &[Member]) -> Result<(), TaskError> {
        let over = self.names.over;
        if self.over.len() < 2 {
            return Ok(());
        }
        if self.varied.force.is_some() {
            let force = self.names.force;
            let reason = format!(
                "{over} varies two fields for a map of the largest forces, but {force} prescribes \
                 the force: give {over} once, or vary a creepage"
            );
            return Err(TaskError::Request(reason));
        }
        for (k, family) in self.over.iter().enumerate() {
            let is_number = |member: &Member| member.values[k].number.is_some();
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

    fn check(&self, member: &Member) -> Result<(), TaskError> {
        let Member { values, case, path } = member;
        case.require_steady("a creep curve is")?;
        let of_wheel =
            [(self.names.creepage_y, self.varied.creepage_y), (self.names.spin, self.varied.spin)];
        let of_wheel = of_wheel.iter().find(|(_, varied)| varied.is_some()).map(|(name, _)| *name);
        let total = self.varied.total.map(|_| self.names.creepage);
        let other = |(force, _): (VariedForce, _)| force.creepage() != Quantity::CreepageX;
        let force = self.varied.force.filter(|force| other(*force)).map(|_| self.names.force);
        if let (Some(_), Some(name)) = (&case.wheel, of_wheel.or(total).or(force)) {
            return Err(TaskError::Request(format!(
                "{name} must be left out with normal.model = \"wheel-rail\", where lateral creepage \
                 and spin follow from the motion of the wheelset: a curve of a wheel varies {}",
                self.names.creepage_x
            )));
        }
        creep_curve::check(&case.problem, path, &self.sampling)
            .map_err(|error| self.failure(case, values, &error))
    }

    /// What varies and makes a field of the case count for nothing.
    fn in_place_of(&self, field: &str) -> Option<&'static str> {
        let Self { varied, names, .. } = self;
        let force = |creepage| {
            varied.force.filter(|(force, _)| force.creepage() == creepage).map(|_| names.force)
        };
        match field {
            "kinematics.creepage_x"
            | "kinematics.angular_velocity"
            | "kinematics.wheel_radius"
            | "kinematics.force_x"
            | "kinematics.traction_coefficient"
            | "kinematics.wheel_torque" => {
                let creepage = varied.creepage_x.map(|_| names.creepage_x);
                varied.total.map(|_| names.creepage).or(creepage).or(force(Quantity::CreepageX))
            }
            "kinematics.creepage_y" | "kinematics.yaw_angle" | "kinematics.force_y" => {
                let creepage = varied.creepage_y.map(|_| names.creepage_y);
                varied.total.map(|_| names.creepage).or(creepage).or(force(Quantity::CreepageY))
            }
            "kinematics.spin" | "kinematics.moment_z" => {
                varied.spin.map(|_| names.spin).or(force(Quantity::Spin))
            }
            _ => None,
        }
    }

    /// An error of the core about a curve: of what varies, with the fields that make the curve one
    /// of several, or of the case.
    fn failure(&self, case: &Case, values: &[FieldValue], error: &schlupf::Error) -> TaskError {
        let field = quantity_field(error.quantity());
        if self.in_place_of(field).is_some() {
            let given = &self.names.given;
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
}

impl Varied {
    /// The case without the forces of the creepages that vary in their place.
    fn in_place_of_forces(&self, mut case: Case) -> Case {
        let forces = &mut case.problem.prescribed;
        if self.creepage_x.or(self.total.map(|(range, _)| range)).is_some() {
            forces.x = None;
        }
        if self.creepage_y.or(self.total.map(|(range, _)| range)).is_some() {
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
        if let Some((force, range)) = self.force {
            return Path::over_force(force, range, own);
        }
        let spin = self.spin.unwrap_or([own.spin; 2]);
        if let Some((range, direction)) = self.total {
            return Path::in_direction(range, direction, spin);
        }
        let x = self.creepage_x.unwrap_or([own.x; 2]);
        let y = self.creepage_y.unwrap_or([own.y; 2]);
        let [start, end] = [0, 1].map(|k| Creepages { x: x[k], y: y[k], spin: spin[k] });
        Path::new(start, end)
    }
}

impl Member {
    fn found(&self, sampling: &Sampling, watch: Watch) -> Result<Found, schlupf::Error> {
        let curve = self.trace(sampling, watch)?;
        let of_curve = curve.warnings.iter().map(|w| w.message(&FieldNames::CASE));
        let warnings = self.case.notices.iter().cloned().chain(of_curve).collect();
        Ok(Found { values: self.values.clone(), warnings, curve })
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
