//! Fast methods for the forces of steady rolling, with the problems and solutions of the full
//! solver: for multibody codes, and for comparisons.
//!
//! | method | computes | cost |
//! |---|---|---|
//! | Kalker's linear theory | forces, moment | a tenth of a microsecond |
//! | [`shen_hedrick_elkins`] | forces, moment | the same |
//! | [`polach`] | forces | the same |
//! | a [look-up table](crate::problem::look_up_table) | forces, moment, derivatives | the same |
//! | FASTSIM, modified FASTSIM | forces, moment, fields, temperatures | microseconds |
//!
//! All of them use Kalker's coefficients for the ellipse of the contact, which come from a table. A
//! [`FastContact`] is set up once; forces for other motions and loads then allocate nothing.

mod elliptic_contact;
mod fastsim;
pub mod polach;
pub mod shen_hedrick_elkins;
mod tabulated;
pub(crate) mod warnings;

use std::f64::consts::PI;
use std::sync::Arc;

use crate::bodies::{Kinematics, ReferencePoint};
use crate::normal::{Grid, NormalContact, NormalSummary};
use crate::problem::look_up_table::{AtShape, LookUpTable};
use crate::problem::{AreaReduction, FastMethod, Method, Options, Problem, State};
use crate::reporting::{
    Error, Progress, Quantity, Stage, Warning, Watch, require_positive, tell, unwatched,
};
use crate::solution::{Area, Fields, Instant, Power, Resultant, Solution, Status, Work};
use crate::solver::Solver;
use crate::solver::reference_point::AtPatch;
use crate::solver::summary::snapshot::View;
use crate::solver::summary::{self};

pub(crate) use elliptic_contact::Ellipse;
pub use elliptic_contact::{EllipticContact, friction_state};
pub use tabulated::{TableContact, TableForce};

use elliptic_contact::friction_limit;
use fastsim::Fastsim;

/// A contact set up for one of the fast methods.
#[derive(Debug, Clone)]
pub struct FastContact {
    at: AtPatch,
    method: FastMethod,
    options: Options,
    contact: EllipticContact,
    /// The contact of the set-up.
    set_up: NormalSummary,
    kernel: Kernel,
    /// μN at the motion of the last force (in N), where the method has one for the whole contact.
    limit: f64,
}

/// Data of a method in addition to the ellipse of the contact.
#[derive(Debug, Clone)]
enum Kernel {
    KalkerLinear,
    ShenHedrickElkins,
    Polach(AreaReduction),
    Fastsim(Box<Fastsim>),
    Table(Arc<LookUpTable>, Box<AtShape>),
}

impl Kernel {
    fn new(
        method: &FastMethod,
        problem: &Problem,
        options: &Options,
        normal: &NormalContact,
    ) -> Result<Self, Error> {
        let fastsim = |kind| {
            let fastsim = Fastsim::new(problem, options, kind, normal)?;
            Ok(Self::Fastsim(Box::new(fastsim)))
        };
        match *method {
            FastMethod::KalkerLinear => Ok(Self::KalkerLinear),
            FastMethod::ShenHedrickElkins => Ok(Self::ShenHedrickElkins),
            FastMethod::Polach(reduction) => Ok(Self::Polach(reduction)),
            FastMethod::Fastsim(brush) => fastsim((brush, None)),
            FastMethod::ModifiedFastsim(brush, reduction) => fastsim((brush, Some(reduction))),
            FastMethod::Table(_) if problem.interface.layer.is_some() => {
                Err(Error::LayerWithTable {})
            }
            FastMethod::Table(ref table) => {
                let contact = EllipticContact::of(problem, normal.summary)?;
                let shape = Box::new(TableContact::shape(table, &contact));
                Ok(Self::Table(Arc::clone(table), shape))
            }
        }
    }
}

impl FastContact {
    /// Sets up a problem for a method. This finds the normal contact, unless
    /// [`PressureSource::prepare`](crate::normal::PressureSource::prepare), which can be watched,
    /// has found it before.
    ///
    /// ```
    /// use schlupf::problem::FastMethod;
    /// use schlupf::solver::simplified::FastContact;
    /// use schlupf::{Options, Problem};
    ///
    /// let problem = Problem::builder().load(80e3).creepage_x(0.05).build()?;
    /// let method = FastMethod::ShenHedrickElkins;
    /// let mut contact = FastContact::new(&problem, method, &Options::default())?;
    /// // All slides.
    /// assert!((contact.force(&problem.kinematics)?.x + 0.4 * 80e3).abs() < 1.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// Viscoelastic bodies, and whatever [`FastMethod::check`], [`Problem::check`] and
    /// [`Options::check`] reject.
    pub fn new(problem: &Problem, method: FastMethod, options: &Options) -> Result<Self, Error> {
        options.check()?;
        method.check()?;
        if problem.interface.elasticity.viscoelastic().is_some() {
            return Err(Error::ViscoelasticFastMethod {});
        }
        let at = AtPatch::new(problem, &unwatched)?;
        let normal = at.problem.normal.normal_contact(None)?;
        normal.refuse_line(Quantity::Method)?;
        let kernel = Kernel::new(&method, &at.problem, options, &normal)?;
        let contact = EllipticContact::of(&at.problem, normal.summary)?;
        let (set_up, options) = (contact.normal, options.clone());
        Ok(Self { at, method, options, contact, set_up, kernel, limit: f64::INFINITY })
    }

    /// The contact in the representation of the method.
    pub fn contact(&self) -> &EllipticContact {
        &self.contact
    }

    /// Switches to another problem; the set-up is kept if the bodies and the normal contact are the
    /// same.
    pub fn set_problem(&mut self, problem: &Problem) -> Result<(), Error> {
        let bodies =
            |problem: &Problem| [problem.interface.wheel.material, problem.interface.rail.material];
        let fits = Arc::ptr_eq(&self.at.problem.normal, &problem.normal)
            && problem.interface.elasticity.viscoelastic().is_none()
            && self.at.problem.interface.layer == problem.interface.layer
            && bodies(&self.at.problem) == bodies(problem);
        if !fits {
            *self = Self::new(problem, self.method.clone(), &self.options)?;
            return Ok(());
        }
        self.at = AtPatch::new(problem, &unwatched)?;
        if let Kernel::Fastsim(fastsim) = &mut self.kernel {
            fastsim.set_friction(&self.at.problem);
        }
        Ok(())
    }

    /// Switches to another load (in N); the patch grows according to its source. Allocates nothing,
    /// unless the load changes the shape of the patch.
    pub fn set_load(&mut self, load: f64) -> Result<(), Error> {
        let problem = &self.at.problem;
        let Some(exponent) = problem.normal.load_exponent() else {
            let contact = problem.normal.normal_contact(Some(load))?;
            self.contact = EllipticContact::of(problem, contact.summary)?;
            self.kernel = Kernel::new(&self.method, problem, &self.options, &contact)?;
            return Ok(());
        };
        require_positive(Quantity::Load, load)?;
        let (normal, before) = (self.set_up.under(load, exponent), self.contact.normal);
        if let Kernel::Fastsim(fastsim) = &mut self.kernel {
            fastsim.rescale(
                normal.semi_axis_x / before.semi_axis_x,
                normal.peak_pressure / before.peak_pressure,
            );
        }
        self.contact = self.contact.resized(normal);
        Ok(())
    }

    /// Forces and moment on the wheel for the given motion; a moment that the method does not
    /// compute is `None`. Allocates nothing.
    ///
    /// # Errors
    /// Whatever [`Kinematics::check`] rejects.
    pub fn force(&mut self, motion: &Kinematics) -> Result<Resultant, Error> {
        motion.check()?;
        self.at.set_motion(motion);
        let force = self.present_force();
        Ok(self.at.resultant_back(&force))
    }

    /// What the method neglects whatever the motion is.
    pub fn warnings(&self) -> Vec<Warning> {
        warnings::of_any_motion(&self.at.problem, &self.contact.normal, &self.method)
    }

    /// Whether a force that [`Self::force`] has just found exceeds friction.
    #[inline]
    pub fn is_beyond_friction(&self, force: &Resultant) -> bool {
        warnings::is_beyond_friction(&self.method, force, self.limit)
    }

    /// The warning about a force that [`Self::force`] has just found, if it exceeds friction.
    /// Allocates nothing.
    pub fn beyond_friction(&self, force: &Resultant) -> Option<Warning> {
        warnings::beyond_friction(&self.method, force, self.limit)
    }

    fn present_force(&mut self) -> Resultant {
        let (problem, contact) = (&self.at.problem, &self.contact);
        let motion = &problem.kinematics;
        let mut limit = || {
            self.limit = friction_limit(problem, contact.normal.load);
            self.limit
        };
        match &mut self.kernel {
            Kernel::KalkerLinear => {
                limit();
                contact.linear_force(motion)
            }
            Kernel::ShenHedrickElkins => shen_hedrick_elkins::force(contact, motion, limit()),
            Kernel::Polach(reduction) => polach::force(contact, motion, limit(), *reduction),
            Kernel::Fastsim(fastsim) => fastsim.force(problem, contact),
            Kernel::Table(table, at) => {
                TableContact::at(table, **at, *contact).force(motion, limit()).force
            }
        }
    }

    /// The solution of the problem. If the method has no fields there are no cells, and
    /// temperatures, areas of stick and slip, and all other unknown quantities are `None`.
    pub fn solution(&mut self) -> Solution {
        self.solution_with(self.options.sensitivity)
    }

    /// The same, with derivatives if those are wanted and the method has them.
    fn solution_with(&mut self, has_derivatives: bool) -> Solution {
        let solution = self.solution_at_patch(has_derivatives);
        self.at.back(solution)
    }

    /// The same with the centre of the patch as its reference point.
    fn solution_at_patch(&mut self, has_derivatives: bool) -> Solution {
        let force = self.present_force();
        let (problem, normal) = (&self.at.problem, &self.contact.normal);
        let limit = friction_limit(problem, normal.load);
        let warnings = warnings::of(problem, normal, &self.method, &force, limit);
        let mut account = summary::SolverReport {
            method: Method::Fast(self.method.clone()),
            status: Status::Converged,
            residual: 0.0,
            history: Vec::new(),
            field_history: Vec::new(),
            warnings,
            sensitivity: None,
            work: Work::default(),
            state: State { grid: Grid::default(), time: 0.0, elements: Vec::new(), motion: None },
        };
        // In steady rolling the dissipated power equals the power of the creep forces.
        let creep_power = summary::creep_power(&problem.kinematics, &force);
        let mut instant = Instant {
            time: 0.0,
            distance: 0.0,
            kinematics: problem.kinematics,
            shift: None,
            load: normal.load,
            force,
            friction_power: creep_power,
            creep_power,
            stored_energy: None,
            max_rise: None,
            newton_iterations: 0,
            residual: 0.0,
        };
        if let Kernel::Fastsim(fastsim) = &mut self.kernel {
            let now = fastsim.snapshot(problem);
            instant.max_rise = Some(summary::temperature(&fastsim.patch, &now).max_rise);
            let power = summary::power(&fastsim.patch, &now, &force);
            instant.friction_power = power.map(|power| power.friction);
            instant.creep_power = power.map(|power| power.creep);
            account.history = vec![instant];
            let view = View { normal, patch: &fastsim.patch, now: &now };
            account.warnings.extend(summary::caveats::of_temperatures(problem, view));
            account.work.cells = fastsim.patch.len();
            let mut solution = summary::solution(problem, &self.options, view, account);
            if problem.interface.heat.model.is_some() {
                solution.warnings.extend(solution.power.and_then(warnings::of_power));
            }
            return solution;
        }
        account.history = vec![instant];
        if let (Kernel::Table(table, at), true) = (&self.kernel, has_derivatives) {
            let contact = TableContact::at(table, **at, self.contact);
            account.sensitivity = Some(contact.sensitivity(&self.at.problem));
        }
        self.without_fields(force, account)
    }

    fn without_fields(&self, force: Resultant, account: summary::SolverReport) -> Solution {
        let (problem, normal) = (&self.at.problem, self.contact.normal);
        let motion = problem.kinematics;
        let contact_area = PI * normal.semi_axis_x * normal.semi_axis_y;
        // In steady rolling the dissipated power equals the power of the creep forces.
        let power = summary::creep_power(&motion, &force).map(|creep| {
            let shares = problem.interface.conduction(&motion).shares();
            let [into_wheel, into_rail] = shares.map(|share| share * creep);
            Power { friction: creep, creep, returned: 0.0, into_wheel, into_rail, exchanged: None }
        });
        Solution {
            method: account.method,
            status: account.status,
            residual: account.residual,
            normal,
            reference: ReferencePoint::Patch,
            kinematics: motion,
            force,
            normalised: summary::normalised(problem, &normal, &force),
            traction_coefficient: force.tangential() / normal.load,
            power,
            t_gamma: summary::t_gamma(&motion, &force, [0.0; 2]),
            temperature: None,
            peclet: problem.interface.peclet(&motion, normal.semi_axes()).numbers,
            area: Area { contact: contact_area, stick: None, slip: None },
            fields: Fields::default(),
            history: account.history,
            field_history: account.field_history,
            warnings: account.warnings,
            sensitivity: account.sensitivity,
            extrapolation: None,
            work: account.work,
            state: account.state,
        }
    }
}

/// Steady states of a fast method.
#[derive(Debug)]
pub struct FastSolver {
    method: FastMethod,
    options: Options,
    contact: Option<FastContact>,
}

impl FastSolver {
    /// A solver without a set-up.
    pub fn new(method: FastMethod, options: &Options) -> Self {
        Self { method, options: options.clone(), contact: None }
    }
}

impl Solver for FastSolver {
    fn method(&self) -> Method {
        Method::Fast(self.method.clone())
    }

    fn options(&self) -> &Options {
        &self.options
    }

    fn solve_given(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let has_derivatives = self.options.sensitivity;
        Ok(self.contact(problem, watch)?.solution_with(has_derivatives))
    }

    fn has_derivatives(&self) -> bool {
        self.method.has_derivatives()
    }

    fn solve_given_with_derivatives(
        &mut self,
        problem: &Problem,
        watch: Watch,
    ) -> Result<Option<Solution>, Error> {
        if !self.has_derivatives() {
            return Ok(None);
        }
        Ok(Some(self.contact(problem, watch)?.solution_with(true)))
    }
}

impl FastSolver {
    /// The contact, set up for a problem.
    fn contact(&mut self, problem: &Problem, watch: Watch) -> Result<&mut FastContact, Error> {
        tell(watch, Progress::count(Stage::Steady, 0))?;
        problem.normal.prepare(None, watch)?;
        if let Some(contact) = &mut self.contact {
            contact.set_problem(problem)?;
        }
        match &mut self.contact {
            Some(contact) => Ok(contact),
            none => Ok(none.insert(FastContact::new(problem, self.method.clone(), &self.options)?)),
        }
    }
}
