//! Transient rolling: a problem whose motion and load change with time, or which starts from a
//! given state.

use crate::problem::{History, Problem, State};
use crate::reporting::Error;

/// Transient rolling.
#[derive(Debug, Clone)]
pub struct Transient {
    /// The contact. Speed, creepages or load given by the history override those of the problem.
    pub problem: Problem,
    /// Creepages, speed and load over time. Without times and without a shift, everything is
    /// constant, and the wheel rolls until nothing changes any more.
    pub history: History,
    /// Initial state. `None` means rest: no tangential traction, bulk temperatures.
    pub initial_state: Option<State>,
}

impl Transient {
    /// Constant conditions from rest: rolling to the steady state.
    pub fn to_steady_state(problem: &Problem) -> Self {
        let (problem, history) = (problem.clone(), History::default());
        Self { problem, history, initial_state: None }
    }

    /// Performs all checks possible before the patch is known.
    pub fn check(&self) -> Result<(), Error> {
        self.problem.check()?;
        if self.problem.interface.elasticity.viscoelastic().is_some() {
            return Err(Error::ViscoelasticUnsteady {});
        }
        self.history.check_forces(&self.problem.prescribed)?;
        self.history.check(&self.problem.kinematics)
    }
}
