//! Searches for the creepages that cause forces, with the derivatives of whatever solver: Newton's
//! method, and the path of states along which the forces grow from those of vanishing free
//! creepages to the goal: f(x) = f₀ + s (f₁ − f₀), followed by the length of the path (Keller
//! 1977), so that it also turns where falling friction has its peak.

use nalgebra::{DMatrix, DVector};

use crate::reporting::Error;
use crate::solver::settings;

/// What has forces for its free creepages, all without dimension.
pub(crate) trait Responds {
    /// The state at some creepages with which a wheel rolls; `None` if it is not found.
    fn respond(&mut self, creepages: DVector<f64>) -> Result<Option<Response>, Error>;

    /// Whether a wheel rolls with them.
    fn rolls(&self, creepages: &DVector<f64>) -> bool;
}

/// The state at some creepages.
#[derive(Clone)]
pub(crate) struct Response {
    /// Dimensionless.
    pub creepages: DVector<f64>,
    /// Dimensionless.
    pub forces: DVector<f64>,
    /// ∂(forces)/∂(creepages), dimensionless.
    pub jacobian: DMatrix<f64>,
}

impl Response {
    /// Whether it lies on a falling branch: between it and those at rest the path has turned.
    pub fn falls(&self) -> bool {
        self.jacobian.determinant() < 0.0
    }
}

/// What was found along a path.
#[derive(Default)]
pub(crate) struct Path {
    /// States with the forces of the goal, in their order along it: at first on the rising branch.
    pub states: Vec<Response>,
    /// The state at the largest share s of the way to the goal; `None` if not even that at rest is
    /// found.
    pub largest: Option<Response>,
    /// Whether no state was missed: the path was followed to where the wheel locks, the forces no
    /// longer grow, or they have fallen far below their peak.
    pub is_complete: bool,
}

/// A search for the creepages that cause some forces.
pub(crate) struct Search<'a> {
    system: &'a mut dyn Responds,
    target: &'a DVector<f64>,
    /// Error of the forces that does not matter.
    tolerance: f64,
    /// f₀, and f₁ − f₀.
    start: DVector<f64>,
    way: DVector<f64>,
}

#[derive(Clone)]
struct Point {
    response: Response,
    /// Share of the way that its forces have gone.
    share: f64,
    /// Unit tangent (creepages and share).
    tangent: DVector<f64>,
    /// Corrections that it took.
    corrections: usize,
}

impl Point {
    /// How fast the share grows along the path.
    fn slope(&self) -> f64 {
        self.tangent[self.tangent.len() - 1]
    }
}

struct Step {
    end: Point,
    /// A state with the forces of the goal before it.
    state: Option<Response>,
    /// Whether it ends at the peak.
    is_top: bool,
}

/// Which way a path is followed, and how far.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Course {
    /// With s growing at first, to the first state, or to the peak.
    ToFirst,
    /// The same to its end.
    Forwards,
    /// With s falling at first, to its end.
    Backwards,
}

impl<'a> Search<'a> {
    /// For forces with an error that does not matter.
    pub fn new(system: &'a mut dyn Responds, (target, tolerance): (&'a DVector<f64>, f64)) -> Self {
        Self { system, target, tolerance, start: target * 0.0, way: target.clone() }
    }

    /// Newton's method from some creepages.
    pub fn near(&mut self, creepages: DVector<f64>) -> Result<Option<Response>, Error> {
        self.land(creepages, f64::INFINITY)
    }

    /// Follows the path: to the first state if `is_single`, otherwise to its end.
    pub fn follow(&mut self, is_single: bool) -> Result<Path, Error> {
        let Some(at_rest) = self.respond(self.target * 0.0)? else { return Ok(Path::default()) };
        self.start.clone_from(&at_rest.forces);
        self.way = self.target - &self.start;
        if self.way.norm() <= f64::EPSILON {
            let (states, largest) = (vec![at_rest.clone()], Some(at_rest));
            return Ok(Path { states, largest, is_complete: is_single });
        }
        let course = if is_single { Course::ToFirst } else { Course::Forwards };
        let mut path = self.run(&at_rest, course)?;
        let is_missed = match &path.states[..] {
            [] => at_rest.falls(),
            [only] => !is_single || only.falls(),
            [first, ..] => first.falls(),
        };
        let has_force_at_rest = self.start.norm() > settings::no_force() * self.target.norm();
        if is_missed && has_force_at_rest {
            // Where the force at rest is the larger one, its peak and what lies beyond are behind
            // it; where rest itself lies beyond the peak, the rising branch is.
            path.states.extend(self.run(&at_rest, Course::Backwards)?.states);
            path.states = lowest(path.states);
            path.is_complete |= !path.states.is_empty();
        }
        Ok(path)
    }

    fn run(&mut self, at_rest: &Response, course: Course) -> Result<Path, Error> {
        let mut path = Path { largest: Some(at_rest.clone()), ..Path::default() };
        let onwards = if course == Course::Backwards { -1.0 } else { 1.0 };
        let tangent = self.tangent(at_rest, &(self.along_share() * onwards));
        let mut here = Point { response: at_rest.clone(), share: 0.0, tangent, corrections: 0 };
        let (mut length, mut largest, mut stagnant) = (settings::first_step(), 0.0, 0);
        let mut has_turned = false;
        for _ in 0..settings::steps_of_path() {
            // Once there is a state the largest forces are not asked for.
            let seeks_top = path.states.is_empty() && !has_turned;
            let Some(step) = self.step(&here, length, seeks_top)? else {
                length *= 0.5;
                let size = here.response.creepages.norm();
                let is_next_to_locked = length < settings::next_to_locked() * size;
                path.is_complete = is_next_to_locked && !self.rolls_beyond(&here, length);
                if path.is_complete || length < settings::least_step() * (1.0 + size) {
                    break;
                }
                continue;
            };
            let Step { end, state, is_top } = step;
            has_turned |= is_top;
            path.states.extend(state);
            if end.share > largest {
                largest = end.share;
                path.largest = Some(end.response.clone());
            }
            let gained = (end.share - here.share).abs();
            let is_stagnant = !is_top && gained < settings::stagnant_force() * length;
            stagnant = if is_stagnant { stagnant + 1 } else { 0 };
            let found = path.states.len();
            let is_over = match course {
                Course::ToFirst => found > 0 || is_top,
                Course::Forwards if found == 0 => end.share < settings::fallen_force() * largest,
                Course::Forwards | Course::Backwards => found >= 2,
            };
            path.is_complete = is_over || stagnant == settings::stagnant_steps();
            if path.is_complete {
                break;
            }
            if end.corrections <= settings::few_corrections() {
                length *= 2.0;
            }
            here = end;
        }
        Ok(path)
    }

    /// A step along the path, or to its peak if that is on the way; `None` if its end, or a state
    /// with the forces of the goal before it, is not found.
    fn step(&mut self, here: &Point, length: f64, seeks_top: bool) -> Result<Option<Step>, Error> {
        let Some(mut end) = self.onwards(here, length)? else { return Ok(None) };
        let is_top = seeks_top && here.slope() > 0.0 && end.slope() <= 0.0;
        if is_top {
            end = self.top(here, (length, end))?;
        }
        let mut step = Step { end, state: None, is_top };
        let end = &step.end;
        if (here.share < 1.0) == (end.share < 1.0) {
            return Ok(Some(step));
        }
        let span = &end.response.creepages - &here.response.creepages;
        let part = (1.0 - here.share) / (end.share - here.share);
        let found = self.land(&here.response.creepages + &span * part, span.norm())?;
        // Beside a peak there are two of them.
        let rises = end.share > here.share;
        let slope = |state: &Response| self.tangent(state, &here.tangent)[self.way.len()];
        step.state = found.filter(|state| (slope(state) > 0.0) == rises);
        Ok(step.state.is_some().then_some(step))
    }

    /// The point of the largest share between one where it rises and one so much further where it
    /// falls: where the slope vanishes, by the Illinois method (Dowell and Jarratt 1971).
    fn top(&mut self, here: &Point, (length, end): (f64, Point)) -> Result<Point, Error> {
        let mut ends = [(0.0, here.slope()), (length, end.slope())];
        let mut best = if end.share > here.share { end } else { here.clone() };
        let mut last = None;
        for _ in 0..settings::most_corrections() {
            let [(low, rising), (high, falling)] = ends;
            let place = low + (high - low) * rising / (rising - falling);
            let Some(point) = self.onwards(here, place)? else { break };
            let (slope, falls) = (point.slope(), usize::from(point.slope() <= 0.0));
            ends[falls] = (place, slope);
            if last.replace(falls) == Some(falls) {
                ends[1 - falls].1 *= 0.5;
            }
            if point.share > best.share {
                best = point;
            }
            if slope.abs() <= settings::stagnant_force() {
                break;
            }
        }
        Ok(best)
    }

    /// The point so much further along the path.
    fn onwards(&mut self, here: &Point, length: f64) -> Result<Option<Point>, Error> {
        let ahead = here.tangent.rows(0, self.way.len()) * length;
        let from = (&here.response.creepages + ahead, here.share + here.slope() * length);
        let accuracy = settings::off_path() * self.way.norm().min(1.0);
        self.correct(from, &here.tangent, (accuracy, 2.0 * length))
    }

    /// Whether the wheel would roll beyond a step from a point.
    fn rolls_beyond(&self, here: &Point, length: f64) -> bool {
        let ahead = here.tangent.rows(0, self.way.len()) * (4.0 * length);
        self.system.rolls(&(&here.response.creepages + ahead))
    }

    /// Newton's method for the goal.
    fn land(&mut self, start: DVector<f64>, reach: f64) -> Result<Option<Response>, Error> {
        let accuracy = self.tolerance * self.way.norm().min(1.0);
        let found = self.correct((start, 1.0), &self.along_share(), (accuracy, reach))?;
        Ok(found.map(|point| point.response))
    }

    /// Newton's method for a point of the path where it meets a plane across a row, from creepages
    /// and share: to an accuracy, and no farther away than `reach`.
    fn correct(
        &mut self,
        (mut creepages, mut share): (DVector<f64>, f64),
        row: &DVector<f64>,
        (accuracy, reach): (f64, f64),
    ) -> Result<Option<Point>, Error> {
        let (count, from) = (self.way.len(), creepages.clone());
        let mut last = f64::INFINITY;
        for corrections in 0..=settings::most_corrections() {
            let Some(response) = self.respond(creepages)? else { return Ok(None) };
            let off = &response.forces - &self.start - &self.way * share;
            // At the accuracy of the solver corrections no longer help.
            let stays = off.norm() > 0.5 * last && off.norm() <= 10.0 * self.tolerance;
            if off.norm() <= accuracy || stays {
                let tangent = self.tangent(&response, row);
                let gone = self.way.dot(&(&response.forces - &self.start));
                let share = gone / self.way.norm_squared();
                return Ok(Some(Point { response, share, tangent, corrections }));
            }
            last = off.norm();
            let matrix = self.bordered(&response.jacobian, row);
            let Some(change) = matrix.lu().solve(&(-off).push(0.0)) else { return Ok(None) };
            creepages = response.creepages + change.rows(0, count);
            share += change[count];
            if (&creepages - &from).norm() > reach {
                return Ok(None);
            }
        }
        Ok(None)
    }

    /// The unit tangent at a state that goes on in the direction of another one.
    fn tangent(&self, at: &Response, before: &DVector<f64>) -> DVector<f64> {
        let found = self.bordered(&at.jacobian, before).lu().solve(&self.along_share());
        found.filter(|t| t.norm() > 0.0).map_or_else(|| before.clone(), |t| t.normalize())
    }

    /// The direction in which the share grows at the same creepages.
    fn along_share(&self) -> DVector<f64> {
        DVector::zeros(self.way.len()).push(1.0)
    }

    /// J and −(f₁ − f₀), above a row.
    fn bordered(&self, jacobian: &DMatrix<f64>, row: &DVector<f64>) -> DMatrix<f64> {
        let count = self.way.len();
        let mut matrix = jacobian.clone().resize(count + 1, count + 1, 0.0);
        matrix.view_mut((0, count), (count, 1)).copy_from(&-&self.way);
        matrix.set_row(count, &row.transpose());
        matrix
    }

    fn respond(&mut self, creepages: DVector<f64>) -> Result<Option<Response>, Error> {
        if self.system.rolls(&creepages) { self.system.respond(creepages) } else { Ok(None) }
    }
}

/// Of several states the one of least creepages where the forces rise, and the one where they fall.
fn lowest(mut states: Vec<Response>) -> Vec<Response> {
    states.sort_by(|one, other| one.creepages.norm().total_cmp(&other.creepages.norm()));
    let mut kept = Vec::new();
    for falls in [false, true] {
        // Where none is of the kind, the next one of the other stands for it.
        let place = states.iter().position(|state| state.falls() == falls).unwrap_or(0);
        if place < states.len() {
            kept.push(states.remove(place));
        }
    }
    kept
}
