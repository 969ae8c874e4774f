//! The coefficient of friction of the cells in steady rolling, which may lag behind its law: the
//! value with which the material leaves a cell is the initial value in the next one downstream.

use crate::interface::friction::{FrictionMemory, FrictionResponse, Kept};
use crate::normal::patch::Patch;
use crate::problem::Problem;

/// Coefficients of friction of every cell, and their tangent.
pub(super) struct Lag {
    memory: Option<FrictionMemory>,
    /// Coefficient of friction of each cell, dimensionless.
    pub coefficient: Vec<f64>,
    passages: Vec<Passage>,
    /// Friction of the material that enters, for the first cell of each strip.
    pub entry: Vec<FrictionResponse>,
}

/// Change of the friction of the material in a cell.
#[derive(Debug, Clone, Copy, Default)]
struct Passage {
    /// Decay of a difference along the path to the cell's point, and through the whole cell.
    kept: [Kept; 2],
    /// Coefficient on arrival minus that of the law, dimensionless.
    gap: f64,
    /// Coefficient on leaving, dimensionless.
    left: f64,
}

/// Variables on which the friction of a cell depends.
pub(super) struct FrictionInput {
    /// Coefficient according to the law, dimensionless.
    pub law: f64,
    /// Slip speed, in m/s.
    pub slip_speed: f64,
    /// Times to the cell's point and through the cell, in s.
    pub durations: [f64; 2],
    /// Whether the material enters here.
    pub is_first: bool,
}

/// Small changes of the variables on which the friction of a cell depends.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LagCause {
    /// Of the coefficient of the law, dimensionless.
    pub law: f64,
    /// Of the slip speed, in m/s.
    pub slip_speed: f64,
    /// Of the logarithm of the path through the cell, dimensionless.
    pub path: f64,
}

impl Lag {
    /// For the given number of cells; [`Self::set_problem`] sets the friction.
    pub fn new(cells: usize) -> Self {
        Self {
            memory: None,
            coefficient: vec![0.0; cells],
            passages: vec![Passage::default(); cells],
            entry: vec![FrictionResponse::default(); cells],
        }
    }

    /// Switches to another law.
    pub fn set_problem(&mut self, problem: &Problem, patch: &Patch) {
        self.memory = problem.interface.friction_memory();
        if self.memory.is_some() {
            let conduction = problem.interface.conduction(&problem.kinematics);
            for strip in &patch.strips {
                let first = strip.cells.start;
                self.entry[first] =
                    problem.interface.entry_friction(&conduction, patch.cells[first].y);
            }
        }
    }

    /// Sets the coefficient of a cell.
    pub fn pass(&mut self, k: usize, input: &FrictionInput) {
        let &FrictionInput { law, slip_speed, durations, is_first } = input;
        let Some(memory) = &self.memory else {
            self.coefficient[k] = law;
            return;
        };
        let arrived = if is_first { self.entry[k].coefficient } else { self.passages[k - 1].left };
        let kept = durations.map(|duration| memory.kept(slip_speed, duration));
        let gap = arrived - law;
        self.coefficient[k] = law + gap * kept[0].part;
        self.passages[k] = Passage { kept, gap, left: law + gap * kept[1].part };
    }

    /// Coefficient (dimensionless) with which the material leaves a cell, with friction memory.
    pub fn on_leaving(&self, k: usize) -> Option<f64> {
        self.memory.as_ref().map(|_| self.passages[k].left)
    }

    /// ∂μ/∂(coefficient of the law) in a cell, dimensionless.
    pub fn follows(&self, k: usize) -> f64 {
        if self.memory.is_some() { 1.0 - self.passages[k].kept[0].part } else { 1.0 }
    }

    /// Change of the coefficient in a cell (dimensionless). `carried` is that of the material on
    /// arrival, and then that on leaving.
    pub fn change(&self, k: usize, cause: &LagCause, carried: &mut f64) -> f64 {
        if self.memory.is_none() {
            return cause.law;
        }
        let Passage { kept, gap, .. } = &self.passages[k];
        let arrived = *carried;
        let [here, leaving] = kept.map(|kept| {
            let faded = kept.by_slip_speed * cause.slip_speed + kept.by_duration * cause.path;
            cause.law + (arrived - cause.law) * kept.part + gap * faded
        });
        *carried = leaving;
        here
    }
}
