//! The steady state, directly: one equilibrium for the whole patch, and the loop between traction
//! and temperature around it.

use crate::equilibrium::{self, Limits, Outcome, norm};
use crate::error::Error;
use crate::grid::Grid;
use crate::heat::HeatStep;
use crate::patch::Patch;
use crate::problem::{Options, Problem};
use crate::solution::{Instant, Solution, Status, Work};
use crate::state::{Element, State};

use super::Progress;
use super::contact::DiscreteContact;
use super::friction_heat::{set_friction_power, set_steady_temperatures};
use super::marching;
use super::snapshot::Snapshot;
use super::steady_state::SteadyState;
use super::summary;

/// Solves a problem for its steady state.
///
/// Where Newton's method fails, the state is marched to instead, and a warning says so.
///
/// # Errors
/// A history or an initial state, which only marching can follow, and whatever
/// [`Problem::check`] and [`Options::check`] refuse.
pub fn solve(
    problem: &Problem,
    options: &Options,
    report: &mut dyn FnMut(Progress),
) -> Result<Solution, Error> {
    problem.check()?;
    options.check()?;
    refuse_transient(problem)?;
    let mut steady = Steady::new(problem, options)?;
    while !steady.is_finished() {
        steady.find_equilibrium();
        steady.heat_up();
        report(steady.progress());
    }
    if steady.outcome.converged {
        return Ok(steady.into_solution());
    }
    let mut marched = marching::march(problem, options, report)?;
    marched.warnings.push(format!(
        "the steady equilibrium was not found at once (residual {:.1e} after {} Newton steps); this \
         is the end of a march",
        steady.outcome.residual, steady.outcome.iterations
    ));
    Ok(marched)
}

/// Coefficient of friction of a cell at its present temperature and slip speed, Eq. (23).
fn friction(problem: &Problem, patch: &Patch, now: &Snapshot, k: usize) -> f64 {
    let slip_speed = now.slip[k][0].hypot(now.slip[k][1]);
    problem.friction_coefficient(&now.conduction, now.rise[k], slip_speed, patch.cells[k].y)
}

fn refuse_transient(problem: &Problem) -> Result<(), Error> {
    let refuse = |quantity, what| {
        let reason = format!("{what} needs solver.driver = \"marching\", but it is \"steady\"");
        Err(Error::Contradiction { quantity, reason })
    };
    if problem.history.is_some() {
        return refuse("solver.driver", "a history");
    }
    if problem.initial_state.is_some() {
        return refuse("solver.initial_state", "an initial state");
    }
    Ok(())
}

/// All that changes from iteration to iteration.
struct Steady<'a> {
    problem: &'a Problem,
    options: &'a Options,
    contact: DiscreteContact,
    now: Snapshot,
    elements: Vec<Element>,
    outcome: Outcome,
    /// Relative change of the bound μ pₙ that the last temperatures ask for.
    change: f64,
    work: Work,
}

impl<'a> Steady<'a> {
    fn new(problem: &'a Problem, options: &'a Options) -> Result<Self, Error> {
        let normal = problem.normal.normal_contact(None)?;
        let grid = Grid::across(&normal.extent(), options.cells_x, options.cells_y);
        let contact = DiscreteContact::new(problem, &normal, grid)?;
        let conduction = problem.conduction(&problem.kinematics);
        let cells = contact.patch.len();
        let mut steady = Self {
            problem,
            options,
            now: Snapshot::blank(problem.kinematics, conduction, cells),
            elements: Vec::new(),
            outcome: Outcome::default(),
            change: f64::INFINITY,
            work: Work { cells, ..Work::default() },
            contact,
        };
        steady.now.friction = steady.entry_friction();
        Ok(steady)
    }

    fn is_finished(&self) -> bool {
        let iterations = self.work.outer_iterations;
        let failed = iterations > 0 && !self.outcome.converged;
        failed || self.change <= self.largest_change() || iterations >= self.options.max_iterations
    }

    /// Together with the residual of the equilibrium, the change of the bound stays within the
    /// tolerance.
    fn largest_change(&self) -> f64 {
        0.5 * self.options.tolerance
    }

    /// Coefficients of friction of material that has just entered.
    fn entry_friction(&self) -> Vec<f64> {
        let cells = 0..self.contact.patch.len();
        cells.map(|k| friction(self.problem, &self.contact.patch, &self.now, k)).collect()
    }

    /// Newton–Raphson on Eq. (13), for the whole patch at once.
    fn find_equilibrium(&mut self) {
        let limits = Limits {
            tolerance: 0.5 * self.options.tolerance,
            max_iterations: self.options.max_iterations,
        };
        let bound = self.now.bound(&self.contact.patch);
        let law = self.problem.contact_law.as_ref();
        let mut system = SteadyState::new(&mut self.contact, law, self.now.kinematics, bound);
        self.outcome = equilibrium::solve(&mut system, &mut self.now.traction, &limits);
        self.elements = system.elements(&self.now.traction);
        self.work.newton_iterations += self.outcome.iterations;
        self.work.operator_products += self.outcome.products as f64 + 1.0;
        self.contact.product(&self.now.traction, &mut self.now.displacement);
    }

    /// Friction power and temperatures, Eqs. (17)–(22), and the friction that follows.
    fn heat_up(&mut self) {
        let mut change = vec![0.0; self.now.traction.len()];
        self.contact.change_in_passing(&mut change);
        let patch = &self.contact.patch;
        set_friction_power(&mut self.now, patch, &change);
        let bound = self.now.bound(patch);
        let solved = self.now.clone();
        let law = |now: &Snapshot, k: usize| friction(self.problem, patch, now, k);
        let heat = &self.problem.heat;
        let records = set_steady_temperatures(&mut self.now, patch, heat, law);
        let wanted = self.now.bound(patch);
        self.remember(records);
        let moved: Vec<f64> = wanted.iter().zip(&bound).map(|(w, b)| w - b).collect();
        let scale = norm(&bound);
        self.change = if scale > 0.0 { norm(&moved) / scale } else { norm(&moved) };
        self.work.outer_iterations += 1;
        if self.is_finished() {
            // The friction power is that of the traction found.
            self.now.friction = solved.friction;
            self.now.friction_power = solved.friction_power;
        }
    }

    fn remember(&mut self, records: Vec<Vec<HeatStep>>) {
        for (k, (element, record)) in self.elements.iter_mut().zip(records).enumerate() {
            element.heat = record;
            element.rise = self.now.rise[k];
            element.slip_speed = self.now.slip[k][0].hypot(self.now.slip[k][1]);
        }
    }

    fn progress(&self) -> Progress {
        Progress { step: self.work.outer_iterations, steps: None, change: self.change }
    }

    fn into_solution(mut self) -> Solution {
        let residual = self.outcome.residual.max(self.change);
        let status = if residual <= self.options.tolerance {
            Status::Converged
        } else {
            Status::NotConverged
        };
        let mut warnings = summary::warnings(self.problem, &mut self.contact, &self.now);
        if status == Status::NotConverged {
            let warning = format!(
                "not converged: after {} iterations between traction and temperature, friction \
                 still changes by {:.1e}, above the tolerance {:.1e}",
                self.work.outer_iterations, self.change, self.options.tolerance
            );
            warnings.insert(0, warning);
        }
        let patch = &self.contact.patch;
        let instant = Instant {
            time: 0.0,
            kinematics: self.now.kinematics,
            load: self.contact.normal.load,
            force: summary::force(patch, &self.now),
            max_rise: summary::temperature(patch, &self.now).max_rise,
            newton_iterations: self.work.newton_iterations,
            residual,
        };
        let account = summary::Account {
            status,
            residual,
            history: vec![instant],
            warnings,
            work: self.work,
            state: State { grid: patch.grid, time: 0.0, elements: self.elements },
        };
        summary::solution(self.problem, self.options, (&self.contact, &self.now), account)
    }
}
