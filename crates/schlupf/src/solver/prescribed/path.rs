//! The path of states along which the forces grow from those of vanishing unknown creepages to the
//! prescribed ones: f(x) = f₀ + s (f₁ − f₀), followed by the length of the path (Keller 1977), so
//! that it also turns where falling friction has its peak.

use nalgebra::{DMatrix, DVector};

use crate::reporting::{Error, Progress, Stage, Watch, tell};
use crate::solution::Solution;
use crate::solver::{Solver, settings};

use super::scaled::{Response, Scaled};

/// What was found along the path.
pub(super) struct Path {
    /// States with the prescribed forces, in their order along it: at first on the rising branch.
    pub states: Vec<Response>,
    /// The forces at the largest share s of the way to the prescribed ones, dimensionless.
    pub largest: DVector<f64>,
    /// Products with the compliance that it took, dimensionless.
    pub products: f64,
    /// Whether no state was missed: the path was followed to where the wheel locks, the forces no
    /// longer grow, or they have fallen far below their peak.
    pub is_complete: bool,
}

struct Point {
    response: Response,
    share: f64,
    /// Unit tangent (creepages and share).
    tangent: DVector<f64>,
}

struct Follower<'a> {
    scaled: &'a Scaled,
    solver: &'a mut dyn Solver,
    watch: Watch<'a>,
    start: DVector<f64>,
    /// f₁ − f₀.
    way: DVector<f64>,
    done: usize,
    products: f64,
}

/// Follows the path with a solver: to the first state if `is_single`, otherwise to its end.
pub(super) fn follow(
    scaled: &Scaled,
    solver: &mut dyn Solver,
    (is_single, watch): (bool, Watch),
) -> Result<Path, Error> {
    let nowhere = DVector::zeros(scaled.count());
    let none = |largest| Path { states: Vec::new(), largest, products: 0.0, is_complete: false };
    let Some(at_rest) = scaled.respond(nowhere.clone(), solver, watch)? else {
        return Ok(none(nowhere));
    };
    let start = at_rest.forces.clone();
    let way = &scaled.target - &start;
    if way.norm() <= f64::EPSILON {
        let states = vec![at_rest];
        return Ok(Path { states, is_complete: is_single, products: 0.0, largest: start });
    }
    let mut follower = Follower { scaled, solver, watch, start, way, done: 0, products: 0.0 };
    let mut path = follower.run(at_rest.clone(), Course::Forwards { is_single })?;
    let has_force_at_rest = follower.start.norm() > settings::no_force() * scaled.target.norm();
    let is_missed = match &path.states[..] {
        [] => at_rest.falls(),
        [only] => !is_single || only.falls(),
        [first, ..] => first.falls(),
    };
    if is_missed && has_force_at_rest {
        // Where the force at rest is the larger one, its peak and what lies beyond are behind it;
        // where rest itself lies beyond the peak, the rising branch is.
        path.states.extend(follower.run(at_rest, Course::Backwards)?.states);
        path.states = lowest(path.states);
        path.is_complete |= !path.states.is_empty();
    }
    Ok(Path { products: follower.products, ..path })
}

/// Of several states the one of least creepages where the forces rise, and the one where they fall.
fn lowest(mut states: Vec<Response>) -> Vec<Response> {
    let size = |state: &Response| state.creepages.norm();
    states.sort_by(|one, other| size(one).total_cmp(&size(other)));
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

/// Which way a path is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Course {
    /// With s growing at first: to the first state if `is_single`, otherwise to its end.
    Forwards { is_single: bool },
    /// With s falling at first: to its end.
    Backwards,
}

impl Follower<'_> {
    fn run(&mut self, at_rest: Response, course: Course) -> Result<Path, Error> {
        let is_backwards = course == Course::Backwards;
        let is_single = course == Course::Forwards { is_single: true };
        let mut onwards = DVector::zeros(self.scaled.count() + 1);
        onwards[self.scaled.count()] = if is_backwards { -1.0 } else { 1.0 };
        let tangent = self.tangent(&at_rest, &onwards);
        let mut here = Point { response: at_rest, share: 0.0, tangent };
        let mut path = Path {
            states: Vec::new(),
            largest: here.response.forces.clone(),
            products: 0.0,
            is_complete: false,
        };
        let (mut step, mut largest, mut stagnant) = (settings::first_step(), 0.0, 0);
        for _ in 0..settings::steps_of_path() {
            let Some((next, corrections)) = self.step(&here, step)? else {
                step *= 0.5;
                let size = here.response.creepages.norm();
                if step < settings::next_to_locked() * size && self.locks(&here, step) {
                    path.is_complete = true;
                    break;
                }
                if step < settings::least_step() * (1.0 + size) {
                    break;
                }
                continue;
            };
            // Once there is a state the largest forces are not asked for.
            let turns = path.states.is_empty() && self.rises(&here) && !self.rises(&next);
            let top = if turns { self.turn(&here, step)? } else { None };
            let Some(found) = self.crossings(&here, top.as_ref(), (step, &next))? else {
                step *= 0.5;
                if step < settings::least_step() {
                    break;
                }
                continue;
            };
            path.states.extend(found);
            if is_single && !path.states.is_empty() {
                path.states.truncate(1);
                path.is_complete = true;
                return Ok(path);
            }
            if path.states.len() >= 2 {
                path.states.truncate(2);
                path.is_complete = true;
                break;
            }
            for point in top.iter().map(|(_, top)| top).chain([&next]) {
                if point.share > largest {
                    largest = point.share;
                    path.largest = point.response.forces.clone();
                }
            }
            if !is_backwards
                && path.states.is_empty()
                && next.share < settings::fallen_force() * largest
            {
                path.is_complete = true;
                break;
            }
            let gained = (next.share - here.share).abs();
            stagnant = if gained < settings::stagnant_force() * step { stagnant + 1 } else { 0 };
            here = next;
            if stagnant == settings::stagnant_steps() {
                path.is_complete = true;
                break;
            }
            if corrections <= settings::few_corrections() {
                step *= 2.0;
            }
        }
        Ok(path)
    }

    /// Whether a step beyond a point would lock the wheel.
    fn locks(&self, here: &Point, step: f64) -> bool {
        let count = self.scaled.count();
        let beyond = &here.response.creepages + here.tangent.rows(0, count) * (4.0 * step);
        self.scaled.motion(&beyond).check().is_err()
    }

    fn rises(&self, point: &Point) -> bool {
        point.tangent[self.scaled.count()] > 0.0
    }

    /// The unit tangent at a state that goes on in the direction of another one.
    fn tangent(&self, at: &Response, before: &DVector<f64>) -> DVector<f64> {
        let count = self.scaled.count();
        let mut right = DVector::zeros(count + 1);
        right[count] = 1.0;
        let found = self.bordered(&at.jacobian, before).lu().solve(&right);
        found.filter(|t| t.norm() > 0.0).map_or_else(|| before.clone(), |t| t.normalize())
    }

    /// J and −(f₁ − f₀), above a row.
    fn bordered(&self, jacobian: &DMatrix<f64>, row: &DVector<f64>) -> DMatrix<f64> {
        let count = self.scaled.count();
        let mut matrix = DMatrix::zeros(count + 1, count + 1);
        matrix.view_mut((0, 0), (count, count)).copy_from(jacobian);
        matrix.view_mut((0, count), (count, 1)).copy_from(&-&self.way);
        matrix.set_row(count, &row.transpose());
        matrix
    }

    /// The point a step further along the path, with the number of corrections.
    fn step(&mut self, here: &Point, step: f64) -> Result<Option<(Point, usize)>, Error> {
        let count = self.scaled.count();
        let mut creepages = &here.response.creepages + here.tangent.rows(0, count) * step;
        let mut share = here.share + here.tangent[count] * step;
        for corrections in 0..=settings::most_corrections() {
            let Some(response) = self.respond(creepages)? else { return Ok(None) };
            let off = &response.forces - &self.start - &self.way * share;
            if off.norm() <= settings::off_path() * self.way.norm().min(1.0) {
                let tangent = self.tangent(&response, &here.tangent);
                return Ok(Some((Point { response, share, tangent }, corrections)));
            }
            let mut right = DVector::zeros(count + 1);
            right.rows_mut(0, count).copy_from(&-off);
            let matrix = self.bordered(&response.jacobian, &here.tangent);
            let Some(change) = matrix.lu().solve(&right) else { return Ok(None) };
            if change.norm() > 2.0 * step {
                return Ok(None);
            }
            creepages = response.creepages + change.rows(0, count);
            share += change[count];
        }
        Ok(None)
    }

    /// The states with the prescribed forces within a step that passes a turning point or not;
    /// `None` where one of them is not found.
    fn crossings(
        &mut self,
        here: &Point,
        top: Option<&(f64, Point)>,
        (step, next): (f64, &Point),
    ) -> Result<Option<Vec<Response>>, Error> {
        let mut places = vec![(0.0, here)];
        places.extend(top.map(|(place, top)| (*place, top)));
        places.push((step, next));
        let mut found = Vec::new();
        for pair in places.windows(2) {
            let ends = [pair[0], pair[1]];
            if (ends[0].1.share < 1.0) == (ends[1].1.share < 1.0) {
                continue;
            }
            match self.land(here, ends)? {
                Some(state) => found.push(state),
                None => return Ok(None),
            }
        }
        Ok(Some(found))
    }

    /// The state with the prescribed forces between two points, each with its distance from the
    /// one before: Newton's method, from closer by where it leaves them or ends on the other side
    /// of a turning point.
    fn land(
        &mut self,
        here: &Point,
        [low, high]: [(f64, &Point); 2],
    ) -> Result<Option<Response>, Error> {
        let rises = high.1.share > low.1.share;
        let end =
            |(place, point): (f64, &Point)| (place, point.share, point.response.creepages.clone());
        let (mut low, mut high) = (end(low), end(high));
        for _ in 0..=settings::halvings_of_step() {
            let part = (1.0 - low.1) / (high.1 - low.1);
            let span = &high.2 - &low.2;
            if let Some(found) = self.polish(&low.2, &span, part)? {
                let slope = self.tangent(&found, &here.tangent)[self.scaled.count()];
                if (slope > 0.0) == rises {
                    return Ok(Some(found));
                }
            }
            let middle = 0.5 * (low.0 + high.0);
            let Some((point, _)) = self.step(here, middle)? else { return Ok(None) };
            let is_low = (point.share < 1.0) == (low.1 < 1.0);
            *(if is_low { &mut low } else { &mut high }) =
                (middle, point.share, point.response.creepages);
        }
        Ok(None)
    }

    /// Newton's method for the prescribed forces, from a part of the way between two creepages, as
    /// long as it stays there.
    fn polish(
        &mut self,
        start: &DVector<f64>,
        span: &DVector<f64>,
        part: f64,
    ) -> Result<Option<Response>, Error> {
        let mut creepages = start + span * part;
        let tolerance = settings::accuracy_of_forces()
            * self.solver.options().tolerance
            * self.way.norm().min(1.0);
        let mut last = f64::INFINITY;
        for _ in 0..=settings::most_corrections() {
            let Some(response) = self.respond(creepages)? else { return Ok(None) };
            let off = &self.scaled.target - &response.forces;
            // At the accuracy of the solver corrections no longer help.
            let stays = off.norm() > 0.5 * last && off.norm() <= 10.0 * tolerance;
            if off.norm() <= tolerance || stays {
                return Ok(Some(response));
            }
            last = off.norm();
            let Some(change) = response.jacobian.clone().lu().solve(&off) else { return Ok(None) };
            creepages = response.creepages + change;
            let along = (&creepages - start).dot(span) / span.norm_squared();
            if !(-settings::beside_step()..=1.0 + settings::beside_step()).contains(&along) {
                return Ok(None);
            }
        }
        Ok(None)
    }

    /// Where the share is largest between a point where it rises and the one a step further, where
    /// it falls: how far from the first, and the point; `None` if that is the first.
    fn turn(&mut self, here: &Point, step: f64) -> Result<Option<(f64, Point)>, Error> {
        let mut best: Option<(f64, Point)> = None;
        let [mut low, mut high] = [0.0, step];
        for _ in 0..settings::halvings_of_step() {
            let middle = 0.5 * (low + high);
            let Some((point, _)) = self.step(here, middle)? else { break };
            *(if self.rises(&point) { &mut low } else { &mut high }) = middle;
            let highest = best.as_ref().map_or(here.share, |(_, best)| best.share);
            if point.share > highest {
                best = Some((middle, point));
            }
        }
        Ok(best)
    }

    fn respond(&mut self, creepages: DVector<f64>) -> Result<Option<Response>, Error> {
        tell(self.watch, Progress::count(Stage::Steady, self.done))?;
        self.done += 1;
        let response = self.scaled.respond(creepages, self.solver, self.watch)?;
        if let Some(Response { solution: Solution { work, .. }, .. }) = &response {
            self.products += work.operator_products + work.sensitivity_products as f64;
        }
        Ok(response)
    }
}
