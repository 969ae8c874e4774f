//! Creep curves: creep forces against creepage in steady rolling, or creepage against force.
//!
//! A [`Path`] defines which creepages vary, a [`Sampling`] the points, and [`trace`] solves there,
//! from zero creepage outwards, so that every solution is close to the previous one. The slope at
//! zero creepage is exact, from the Jacobian of the equilibrium there; the maximum of the force is
//! found by additional solutions. Along a prescribed force ([`Path::over_force`]) the creepages are
//! found, and there is neither slope nor maximum.

mod path;
mod initial_slope;
mod maximum;
mod sampling;
mod warnings;
mod columns;

use crate::bodies::{Kinematics, ReferencePoint};
use crate::normal::NormalSummary;
use crate::problem::{Method, PrescribedForces, Problem};
use crate::reporting::{CurveError, Error, Progress, Stage, Watch, tell, within};
use crate::solution::{Area, Power, Resultant, Solution, Status, Work};
use crate::solver::Solver;

pub use initial_slope::InitialSlope;
pub use maximum::{Maximum, PLATEAU};
pub use path::{Abscissa, Creepages, Path, VariedForce};
pub use sampling::{MAX_POINTS, Sampling};

pub use warnings::CurveWarning;
use warnings::Warnings;

/// Creep forces against creepage.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CreepCurve {
    /// The method.
    pub method: Method,
    /// Which creepages vary.
    pub path: Path,
    /// The normal contact, the same at all points.
    pub normal: NormalSummary,
    /// Reference point of creepages and moments.
    pub reference: ReferencePoint,
    /// Whether forces of other directions are prescribed: then there is no initial slope.
    pub holds_forces: bool,
    /// The points in the order of the path.
    pub points: Vec<Point>,
    /// Slope where all varied creepages are zero. `None` if the path does not contain that point or
    /// a force is prescribed, or if a solution needed for it did not converge, which gives a
    /// warning.
    pub initial_slope: Option<InitialSlope>,
    /// Maxima of |F|, in the order of the path: one on each side of zero creepage, unless |F| still
    /// rises at the outer end of that side, or is largest at its inner end. None if a force varies.
    pub maxima: Vec<Maximum>,
    /// Warnings for whoever uses the results.
    pub warnings: Vec<CurveWarning>,
    /// Work of all solutions, including those for slope and maximum.
    pub work: Work,
}

impl CreepCurve {
    /// The maximum of |F| over the curve. `None` if it is at an end of the curve, which says
    /// nothing about what lies beyond.
    pub fn maximum(&self) -> Option<&Maximum> {
        let higher = |one: &&Maximum, other: &&Maximum| {
            one.traction_coefficient.total_cmp(&other.traction_coefficient)
        };
        let highest = self.maxima.iter().max_by(higher)?;
        let converged = self.points.iter().filter(|point| point.status == Status::Converged);
        let largest = converged.map(|point| point.traction_coefficient).fold(0.0, f64::max);
        (highest.traction_coefficient >= largest * (1.0 - PLATEAU)).then_some(highest)
    }

    /// Whether every point converged.
    pub fn is_converged(&self) -> bool {
        self.points.iter().all(|point| point.status == Status::Converged)
    }
}

/// A point of a creep curve: the results of one solution, without its fields. Forces act on the
/// wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Point {
    /// Abscissa of the curve; dimensionless, in 1/m for spin, in the unit of a force.
    pub abscissa: f64,
    /// Speed and creepages.
    pub kinematics: Kinematics,
    /// Forces and moment.
    pub force: Resultant,
    /// F/(μ0 N), and Mz/(μ0 N √(ab)); dimensionless.
    pub normalised: Resultant,
    /// |F|/N, dimensionless.
    pub traction_coefficient: f64,
    /// Estimated errors of the forces by the cells, if extrapolation is requested.
    pub error: Option<Resultant>,
    /// Power of friction and of the creep forces, if the method computes it.
    pub power: Option<Power>,
    /// Largest temperature rise, in K, if the method computes it.
    pub max_rise: Option<f64>,
    /// Contact, stick and slip areas.
    pub area: Area,
    /// Whether the solution converged.
    pub status: Status,
    /// Relative residual, dimensionless.
    pub residual: f64,
    /// Amount of work.
    pub work: Work,
}

impl Point {
    fn new(abscissa: f64, solution: &Solution) -> Self {
        Self {
            abscissa,
            kinematics: solution.kinematics,
            force: solution.force,
            normalised: solution.normalised,
            traction_coefficient: solution.traction_coefficient,
            error: solution.extrapolation.map(|found| found.error),
            power: solution.power,
            max_rise: solution.temperature.map(|largest| largest.max_rise),
            area: solution.area,
            status: solution.status,
            residual: solution.residual,
            work: solution.work,
        }
    }
}

/// Computes a creep curve of a problem, whose own creepages are used only where the path keeps
/// them: see [`Path::new`].
///
/// The solver may be reused for several curves: they share its set-up if they have the normal
/// contact and the elasticity in common. Points that do not converge are kept and marked, and a
/// warning names them.
///
/// ```
/// use schlupf::analysis::creep_curve::{Creepages, Path, Sampling, trace};
/// use schlupf::solver::SteadySolver;
/// use schlupf::{Options, Problem, unwatched};
///
/// let start = Creepages { x: 0.0, y: 0.0, spin: 0.0 };
/// let path = Path::new(start, Creepages { x: 0.02, ..start })?;
/// let sampling = Sampling::Even(4);
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let problem = Problem::builder().build()?;
/// let curve =
///     trace(&mut SteadySolver::new(&options), &problem, &path, &sampling, &unwatched)?;
/// assert!(curve.is_converged() && curve.points[0].force.x.abs() < 1e-6);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Whatever [`check`] rejects, before anything is solved, a force that no creepage causes, and
/// [`Error::Stopped`].
pub fn trace(
    solver: &mut dyn Solver,
    problem: &Problem,
    path: &Path,
    sampling: &Sampling,
    watch: Watch,
) -> Result<CreepCurve, Error> {
    check(problem, path, sampling)?;
    let method = solver.method();
    let normal = problem.normal.normal_contact(None)?.summary;
    let mut abscissae = sampling.abscissae(path.range());
    let is_downwards = abscissae.first() > abscissae.last();
    abscissae.sort_unstable_by(f64::total_cmp);
    solver.forget();
    let mut solver = Points {
        problem: problem.clone(),
        own: problem.prescribed,
        path,
        solver,
        watch,
        progress: Progress { total: Some(abscissae.len()), ..Progress::count(Stage::Curve, 0) },
        work: Work::default(),
    };
    let mut warnings = Warnings::default();
    let mut solve_side = |side: &[f64]| -> Result<Vec<Point>, Error> {
        let mut points = Vec::with_capacity(side.len());
        for &abscissa in side {
            let solution = solver.solve(abscissa)?;
            warnings.note(abscissa, &solution.warnings);
            points.push(Point::new(abscissa, &solution));
            solver.progress.done += 1;
            tell(watch, solver.progress)?;
        }
        Ok(points)
    };
    let first_positive = abscissae.partition_point(|abscissa| *abscissa < 0.0);
    let (below, above) = abscissae.split_at(first_positive);
    let outwards: Vec<f64> = below.iter().rev().copied().collect();
    let sides = [solve_side(above)?, solve_side(&outwards)?];
    let mut maxima = match path.force() {
        None => maximum::of_sides(&mut solver, &sides)?,
        Some(_) => Vec::new(),
    };
    let slope = initial_slope::find(&mut solver, &normal)?;
    warnings.extend(slope.warning);
    let [above, below] = sides;
    let mut points: Vec<Point> = below.into_iter().rev().chain(above).collect();
    if is_downwards {
        points.reverse();
        maxima.reverse();
    }
    Ok(CreepCurve {
        method,
        path: *path,
        normal,
        reference: solver.problem.reference,
        holds_forces: !problem.prescribed.is_none(),
        warnings: warnings.all(path.quantity(), &points),
        points,
        initial_slope: slope.value,
        maxima,
        work: solver.work,
    })
}

/// Performs all checks possible before the first solution.
///
/// # Errors
/// Points out of order, a wheel that does not roll somewhere on the path, and whatever
/// [`Problem::check`] rejects there.
pub fn check(problem: &Problem, path: &Path, sampling: &Sampling) -> Result<(), Error> {
    sampling.check()?;
    sampling.check_order(path)?;
    if let Some(locked) = path.locks_at(&problem.kinematics) {
        let quantity = path.quantity();
        return Err(CurveError::Locks { quantity, value: locked }.into());
    }
    let motion = &problem.kinematics;
    let [start, end] = [path.start(), path.end()].map(|end| end.in_place_of(motion));
    problem.prescribed.check_motion(&start, &end)?;
    let mut there = problem.clone();
    sampling.abscissae(path.range()).into_iter().try_for_each(|abscissa| {
        there.kinematics = path.at(abscissa).in_place_of(motion);
        there.prescribed = path.prescribed(abscissa, &problem.prescribed);
        there.check()
    })
}

/// Solves the points one after another, each starting from the previous ones.
struct Points<'a> {
    problem: Problem,
    /// What the problem itself prescribes.
    own: PrescribedForces,
    path: &'a Path,
    solver: &'a mut dyn Solver,
    watch: Watch<'a>,
    progress: Progress,
    /// All work so far.
    work: Work,
}

impl Points<'_> {
    fn move_to(&mut self, abscissa: f64) {
        let motion = &self.problem.kinematics;
        self.problem.kinematics = self.path.at(abscissa).in_place_of(motion);
        self.problem.prescribed = self.path.prescribed(abscissa, &self.own);
    }

    fn solve(&mut self, abscissa: f64) -> Result<Solution, Error> {
        self.move_to(abscissa);
        let watch = within(self.watch, self.progress);
        let solution = self.solver.solve(&self.problem, &watch)?;
        self.work.add(&solution.work);
        Ok(solution)
    }

    /// The solution with its derivatives, if it is found directly.
    fn differentiate(&mut self, abscissa: f64) -> Result<Option<Solution>, Error> {
        self.move_to(abscissa);
        let watch = within(self.watch, self.progress);
        let solution = self.solver.solve_with_derivatives(&self.problem, &watch)?;
        if let Some(solution) = &solution {
            self.work.add(&solution.work);
        }
        Ok(solution)
    }

    fn point(&mut self, abscissa: f64) -> Result<Point, Error> {
        self.solve(abscissa).map(|solution| Point::new(abscissa, &solution))
    }
}
