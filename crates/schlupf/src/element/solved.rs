//! Forces by a method that solves for the tractions of the patch.

use std::fmt;
use std::sync::Arc;

use crate::bodies::{Kinematics, ReferenceSpeed};
use crate::normal::AtLoad;
use crate::numerics::dual::{Dual, Number};
use crate::reporting::{Error, unwatched};
use crate::solution::{Resultant, Status};
use crate::solver::simplified::FastContact;
use crate::solver::{Solver, SteadySolver, settings};
use crate::{Method, Options, Problem};

use super::acting::Acting;
use super::similar::{Similar, Units};

/// A solver of the contact, with the problem that it solves.
pub(super) struct Solved {
    own: Problem,
    options: Options,
    solver: Solving,
    /// What the solver was given last, under which conditions, and in which units.
    problem: Problem,
    posed: [f64; VARIABLES],
    units: Units,
}

/// What finds the forces: all equations, or a fast method, which needs no solution with its fields.
enum Solving {
    Full(Box<SteadySolver>, Option<Similar>),
    Fast(Box<FastContact>),
}

impl Solving {
    fn new(problem: &Problem, method: &Method, options: &Options) -> Result<Self, Error> {
        Ok(match method {
            Method::Full => Self::Full(Box::new(SteadySolver::new(options)), Similar::new(problem)),
            Method::Fast(fast) => {
                Self::Fast(Box::new(FastContact::new(problem, fast.clone(), options)?))
            }
        })
    }

    fn forget(&mut self) {
        if let Self::Full(solver, _) = self {
            solver.forget();
        }
    }
}

/// Creepages, speed, load, friction factor and bulk temperatures, on which its forces depend.
const VARIABLES: usize = 8;
const SPIN: usize = 2;
const SPEED: usize = 3;
const LOAD: usize = 4;
const FACTOR: usize = 5;

type Found = [Dual<VARIABLES>; 3];

/// Of forces and moment by each variable, where known.
type Slopes = [Option<[f64; 3]>; VARIABLES];

impl Solved {
    /// # Errors
    /// What the method rejects.
    pub fn new(problem: &Problem, method: &Method, options: &Options) -> Result<Self, Error> {
        let options = Options { sensitivity: false, keeps_state: false, ..options.clone() };
        let own = problem.without_forces();
        let solver = Solving::new(&own, method, &options)?;
        Ok(Self::with(solver, own, options))
    }

    /// With a solver that has solved nothing yet.
    fn with(solver: Solving, own: Problem, options: Options) -> Self {
        let (problem, posed, units) = (own.clone(), [f64::NAN; VARIABLES], Units::SAME);
        Self { own, options, solver, problem, posed, units }
    }

    /// Fx, Fy (in N) and Mz (in N m); `None` where they are not found.
    pub fn force<const N: usize>(&mut self, at: &Acting<Dual<N>>) -> Option<[Dual<N>; 3]> {
        let reference = self.own.kinematics.reference_speed;
        let ([xi, eta, spin], stretch) = stretched(at.creepages, reference);
        let [wheel, rail] = at.temperatures;
        let speed = at.speed * stretch;
        let variables = [xi, eta, spin, speed, at.load, at.friction_factor, wheel, rail];
        let values = variables.map(|variable| variable.value);
        if N == 0 {
            return Some(self.solve(values)?.map(Dual::from));
        }
        let found = self.differentiated(values)?;
        Some(found.map(|force| force.of(&variables)))
    }

    /// See [`super::law::Law::rows_in_turn`].
    pub fn rows_in_turn(&self) -> usize {
        match self.solver {
            Solving::Full(..) => 16,
            Solving::Fast(_) => 32,
        }
    }

    /// Forgets what was found.
    pub fn forget(&mut self) {
        self.solver.forget();
    }

    fn differentiated(&mut self, at: [f64; VARIABLES]) -> Option<Found> {
        let (force, by) = match &mut self.solver {
            Solving::Fast(_) => (self.solve(at)?, [None; VARIABLES]),
            Solving::Full(..) => self.solve_with_slopes(at)?,
        };
        let mut found = force.map(Dual::from);
        let has_other_friction = !self.own.interface.friction.law.is_constant();
        for (k, by) in by.into_iter().enumerate() {
            let slope = match by {
                Some(slope) => slope,
                None if k < SPEED || k == LOAD || k == FACTOR || has_other_friction => {
                    self.central_difference(at, k)?
                }
                None => continue,
            };
            for (force, slope) in found.iter_mut().zip(slope) {
                force.slopes[k] = slope;
            }
        }
        Some(found)
    }

    /// Forces and moment, with the derivatives that the solver knows.
    fn solve_with_slopes(&mut self, at: [f64; VARIABLES]) -> Option<([f64; 3], Slopes)> {
        self.pose(at)?;
        let Solving::Full(solver, _) = &mut self.solver else { return None };
        let found = solver.solve_with_all_slopes(&self.problem, &unwatched).ok()?;
        let found = found.filter(|found| found.status == Status::Converged)?;
        let by = found.sensitivity?;
        let Units { length, pressure } = self.units;
        let mut slopes = [None; VARIABLES];
        let mut set = |place: usize, by: &Resultant, unit: f64| {
            slopes[place] = Some(self.forces(&by.scaled(unit, unit)));
        };
        set(0, &by.creepage_x, 1.0);
        set(1, &by.creepage_y, 1.0);
        set(SPIN, &by.spin, length);
        set(FACTOR, &by.friction_coefficient, pressure);
        if let Some(by) = by.load {
            set(LOAD, &by, (pressure * length * length).recip());
        }
        Some((self.forces(&found.force), slopes))
    }

    /// Puts other conditions into the problem.
    fn pose(&mut self, at: [f64; VARIABLES]) -> Option<()> {
        let [creepage_x, creepage_y, spin, speed, load, factor, wheel, rail] = at;
        let is_other_load = self.posed[LOAD] != load;
        // The same law is the same by its place in memory.
        let mut is_other = self.posed[FACTOR..] != at[FACTOR..];
        if let Solving::Full(_, Some(similar)) = &self.solver {
            self.units = similar.units(load);
            is_other |= is_other_load;
        }
        // Until all is posed.
        self.posed = [f64::NAN; VARIABLES];
        let problem = &mut self.problem;
        let spin = self.units.length * spin;
        problem.kinematics =
            Kinematics { speed, creepage_x, creepage_y, spin, ..self.own.kinematics };
        if is_other {
            problem.interface = self.units.interface(&self.own.interface, factor)?;
            problem.interface.wheel.bulk_temperature = wheel;
            problem.interface.rail.bulk_temperature = rail;
        }
        match &mut self.solver {
            Solving::Fast(contact) => {
                if is_other {
                    contact.set_problem(problem).ok()?;
                }
                if is_other || is_other_load {
                    contact.set_load(load).ok()?;
                }
            }
            Solving::Full(_, None) if is_other_load => {
                let own = Arc::clone(&self.own.normal);
                problem.normal = Arc::new(AtLoad::new(own, load).ok()?);
            }
            Solving::Full(..) => {}
        }
        self.posed = at;
        Some(())
    }

    /// Forces and moment of the contact from those of the problem.
    fn forces(&self, found: &Resultant) -> [f64; 3] {
        let units = self.units.forces();
        let Resultant { x, y, moment_z } = *found;
        [units[0] * x, units[1] * y, units[2] * moment_z.unwrap_or(0.0)]
    }

    fn solve(&mut self, at: [f64; VARIABLES]) -> Option<[f64; 3]> {
        self.pose(at)?;
        let found = match &mut self.solver {
            Solving::Fast(contact) => contact.force(&self.problem.kinematics).ok()?,
            Solving::Full(solver, _) => {
                let found = solver.solve(&self.problem, &unwatched).ok()?;
                (found.status == Status::Converged).then_some(found.force)?
            }
        };
        Some(self.forces(&found))
    }

    /// The derivative of the forces with respect to one of the variables.
    fn central_difference(&mut self, at: [f64; VARIABLES], place: usize) -> Option<[f64; 3]> {
        let step = settings::difference() * at[place].abs().max(SMALLEST[place]);
        let mut side = |step: f64| {
            let mut moved = at;
            moved[place] += step;
            self.solve(moved)
        };
        let (more, less) = (side(step)?, side(-step)?);
        Some(std::array::from_fn(|k| (more[k] - less[k]) * 0.5 / step))
    }
}

/// What counts as small for a difference, each in the unit of its variable.
const SMALLEST: [f64; VARIABLES] = [1e-4, 1e-4, 1e-2, 0.0, 0.0, 1e-3, 100.0, 100.0];

/// Creepages and the factor by which they shrink while the speed grows, so that a wheel that spins
/// or slides at standstill rolls and has the same slip: √⁸(1 + m⁸) with m below one where it
/// rolls, by 3·10⁻⁷ more than one at a creepage of 0.1.
fn stretched<T: Number>([xi, eta, spin]: [T; 3], reference: ReferenceSpeed) -> ([T; 3], T) {
    // Of the vehicle's speed a wheel locks at ξ = 1, of the mean at 2.
    let along = match reference {
        ReferenceSpeed::Vehicle => 4.0,
        ReferenceSpeed::Mean => 0.28,
    };
    let square = xi * xi * along + eta * eta * 4.0;
    let fourth = square * square;
    let stretch = (T::from(1.0) + fourth * fourth).powf(0.125);
    ([xi, eta, spin].map(|creepage| creepage / stretch), stretch)
}

/// With a solver of its own, which has solved nothing yet.
impl Clone for Solved {
    fn clone(&self) -> Self {
        let solver = match &self.solver {
            Solving::Full(_, similar) => {
                Solving::Full(Box::new(SteadySolver::new(&self.options)), *similar)
            }
            Solving::Fast(contact) => Solving::Fast(contact.clone()),
        };
        Self::with(solver, self.own.clone(), self.options.clone())
    }
}

impl fmt::Debug for Solved {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Solved").field("problem", &self.own).finish_non_exhaustive()
    }
}
