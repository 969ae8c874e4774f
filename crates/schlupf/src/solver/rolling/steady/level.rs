//! One of the nested grids on which a steady state is found, from the coarsest to the finest.

use crate::normal::{Grid, NormalContact};
use crate::problem::{Options, Problem};
use crate::reporting::{Error, Progress, Stage, Watch, tell};
use crate::solver::rolling::shared::contact::DiscreteContact;
use crate::solver::rolling::shared::strip::reduced;
use crate::solver::settings;

use super::steady_friction::SteadyFriction;
use super::strip_law::StripLaw;
use super::transfer::Transfer;

/// A grid with its discrete contact, and the previous solutions on it.
pub(super) struct Level {
    pub contact: DiscreteContact,
    pub strips: StripLaw,
    pub friction: SteadyFriction,
    /// Transfer to the next coarser level, if there is one.
    pub descent: Option<Descent>,
    /// Traction on the rail p of this level's solution, in Pa.
    pub traction: Vec<f64>,
    /// The linear response to it, in m.
    pub response: Vec<f64>,
    /// The same for the previous points, the latest first, in Pa.
    pub earlier: [Vec<f64>; 2],
    /// Derivatives of its last solution with their linear responses, in Pa and m per unit of the
    /// parameter.
    pub changes: Vec<[Vec<f64>; 2]>,
    /// Its initial guess from previous solutions alone, in Pa.
    pub predicted: Vec<f64>,
    /// Whether its solution corrects what is predicted of the next finer one.
    pub corrects: bool,
    /// Whether it is accurate to the tolerance that was asked for.
    pub is_found: bool,
    pub workspace: Workspace,
}

/// Buffers for a level's part in products and preconditioning.
#[derive(Default)]
pub(super) struct Workspace {
    /// Displacements where the material entered, in m.
    pub at_entry: Vec<f64>,
    /// Changes of heat fluxes, in W/m².
    pub flux: Vec<f64>,
    /// Changes of μ pₙ, in Pa.
    pub bound: Vec<f64>,
}

/// Transfer to the next coarser level and back, with buffers for tractions of that level.
pub(super) struct Descent {
    pub transfer: Transfer,
    /// Transferred tractions, in Pa.
    pub carried: Vec<f64>,
    /// The part of them already contained in this level, in Pa.
    pub known: Vec<f64>,
}

/// The nested grids of a normal contact, from the finest on.
pub(super) fn nested(
    problem: &Problem,
    (normal, finest): (&NormalContact, Grid),
    options: &Options,
    watch: Watch,
) -> Result<Vec<Level>, Error> {
    let (mut grid, mut cells) = (finest, [finest.columns_within(), finest.rows]);
    let mut levels: Vec<Level> = Vec::new();
    loop {
        tell(watch, Progress::count(Stage::Steady, 0))?;
        let level = Level::new(problem, normal, grid)?;
        levels.first().unwrap_or(&level).contact.require_rows()?;
        if let Some(finer) = levels.last_mut() {
            let transfer = Transfer::new(&finer.contact.patch, &level.contact.patch);
            let (carried, known) = (vec![0.0; level.size()], vec![0.0; level.size()]);
            finer.descent = Some(Descent { transfer, carried, known });
        }
        if !level.contact.compliance.couples_cells() && (!options.extrapolate || !levels.is_empty())
        {
            // Solved cell by cell; forces are extrapolated from two grids.
            levels.push(level);
            return Ok(levels);
        }
        let fewest = settings::fewest_cells_coarsened();
        levels.push(level);
        let halved = cells.map(|count| if count < fewest { count } else { count.div_ceil(2) });
        if halved == cells {
            return Ok(levels);
        }
        cells = halved;
        grid = Grid::across(&finest.extent(), cells[0], cells[1]);
    }
}

impl Level {
    fn new(problem: &Problem, normal: &NormalContact, grid: Grid) -> Result<Self, Error> {
        let mut contact = DiscreteContact::new(problem, normal, grid)?;
        let unknowns = 2 * contact.patch.len();
        let zeros = || vec![0.0; unknowns];
        let strips = StripLaw::new(problem, normal, &mut contact)?;
        Ok(Self {
            strips,
            friction: SteadyFriction::new(problem, &contact.patch),
            descent: None,
            traction: zeros(),
            response: Vec::new(),
            earlier: [zeros(), zeros()],
            changes: Vec::new(),
            predicted: zeros(),
            corrects: true,
            is_found: false,
            workspace: Workspace {
                at_entry: zeros(),
                flux: vec![0.0; contact.patch.len()],
                bound: vec![0.0; contact.patch.len()],
            },
            contact,
        })
    }

    /// Switches to another motion and other laws on the same grid.
    pub fn set_problem(&mut self, problem: &Problem) {
        self.friction.set_problem(problem, &self.contact);
        self.contact.set_laws(problem);
        if self.strips.set_problem(problem, &self.contact) {
            self.changes.clear();
        }
        self.take_bound();
    }

    /// Switches to another motion. Friction that depends on it must be evaluated next; friction
    /// that does not keeps its record of slip and heat until [`Self::set_problem`].
    pub fn set_motion(&mut self, problem: &Problem) {
        if self.friction.is_coupled {
            self.friction.set_problem(problem, &self.contact);
        }
        self.strips.set_problem(problem, &self.contact);
    }

    /// μ pₙ with the friction of the last evaluation.
    pub fn take_bound(&mut self) {
        self.strips.set_bound(&self.contact.patch.cells, self.friction.coefficients());
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        2 * self.strips.len()
    }

    /// Guesses the tractions where cells are not coupled: the solution, if friction is
    /// the present one.
    pub fn guess_uncoupled(&mut self, problem: &Problem) {
        let mut compliance = vec![0.0; self.size()];
        self.contact.product(&vec![1.0; self.size()]).at_cells(&mut compliance);
        let mut traction = std::mem::take(&mut self.traction);
        self.uncoupled_state(problem, &compliance, &mut traction);
        self.traction = traction;
    }

    /// The tractions of rigid bodies, with friction that follows their slip.
    pub fn rigid_state(&mut self, problem: &Problem, p: &mut [f64]) {
        self.uncoupled_state(problem, &vec![0.0; p.len()], p);
    }

    /// The tractions if cells were displaced by their own ones only, with the compliance (in m/Pa)
    /// of each in both directions, and friction followed the rigid slip.
    fn uncoupled_state(&mut self, problem: &Problem, compliance: &[f64], p: &mut [f64]) {
        p.fill(0.0);
        let patch = &self.contact.patch;
        if self.friction.is_coupled {
            let cold = vec![problem.interface.friction.cold_coefficient(); patch.len()];
            self.strips.set_bound(&patch.cells, &cold);
        }
        self.strips.uncoupled_state(compliance, p);
        if self.friction.is_coupled {
            let (on, strips) = ((problem, patch), &self.strips);
            self.friction.rigid_slip_state(on, strips.kept(), strips.bound(), p);
            self.strips.complete(p);
        }
    }

    /// Reduces tractions that exceed μ pₙ to the bound.
    pub fn clip(&mut self) {
        self.strips.complete(&mut self.traction);
        for (p, bound) in self.traction.chunks_exact_mut(2).zip(self.strips.bound()) {
            p.copy_from_slice(&reduced([p[0], p[1]], *bound));
        }
    }
}
