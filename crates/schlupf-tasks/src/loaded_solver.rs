//! A solver of a case under many conditions.

use std::sync::Arc;

use schlupf::kinematics::Kinematics;
use schlupf::normal::PressureSource;
use schlupf::normal::at_load::AtLoad;
use schlupf::{Error, Problem, Solution, Solver, Watch};
use schlupf_case::Case;

/// A solver that starts from its earlier solutions and keeps the normal contact of the latest load.
///
/// ```
/// use schlupf::kinematics::Kinematics;
/// use schlupf_case::{CaseFile, Folder, Overrides};
/// use schlupf_tasks::loaded_solver::LoadedSolver;
///
/// let text = "grid = { cells_x = 10, cells_y = 10 }";
/// let file = CaseFile::from_str(text, "a case", Folder::new(""), Overrides::NONE)?;
/// let case = file.pose(&schlupf::unwatched)?;
/// let mut solver = LoadedSolver::new(&case);
/// let motion = Kinematics { creepage_x: 0.002, ..case.problem.kinematics };
/// let solution = solver.solve(&case, motion, Some(60e3), &schlupf::unwatched)?;
/// assert_eq!(solution.normal.load, 60e3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct LoadedSolver {
    solver: Box<dyn Solver>,
    normal: Arc<dyn PressureSource>,
    load: Option<f64>,
}

impl LoadedSolver {
    /// A solver of a case of steady rolling.
    pub fn new(case: &Case) -> Self {
        Self::with(case, case.solver())
    }

    /// One whose solutions keep no state of the material.
    pub fn without_state(case: &Case) -> Self {
        Self::with(case, case.solver_without_state())
    }

    fn with(case: &Case, solver: Box<dyn Solver>) -> Self {
        Self { solver, normal: Arc::clone(&case.problem.normal), load: None }
    }

    /// Solves the case with another motion and another load (in N), as in a history; that of the
    /// case where there is none.
    ///
    /// # Errors
    /// Whatever the solver refuses, and another creepage where the case prescribes its force.
    pub fn solve(
        &mut self,
        case: &Case,
        kinematics: Kinematics,
        load: Option<f64>,
        watch: Watch,
    ) -> Result<Solution, Error> {
        case.problem.prescribed.check_motion(&case.problem.kinematics, &kinematics)?;
        let own = &case.problem.normal;
        if let Some(load) = load.filter(|load| self.load != Some(*load)) {
            self.normal = Arc::new(AtLoad::new(Arc::clone(own), load)?);
            self.normal.prepare(None, watch)?;
            self.load = Some(load);
        }
        let normal = if load.is_some() { Arc::clone(&self.normal) } else { Arc::clone(own) };
        let problem = Problem { kinematics, normal, ..case.problem.clone() };
        self.solver.solve(&problem, watch)
    }
}
