//! Steady states of a contact with steep friction, against an independent discretisation and
//! continuation.

use std::ops::Range;
use std::sync::Arc;

use crate::common::{problem, rolling};
use schlupf::bodies::Material;
use schlupf::elasticity::{HalfSpace, Winkler};
use schlupf::interface::Incremental;
use schlupf::interface::friction::{Exponential, Linear, SlipTerms};
use schlupf::interface::heat::Heat;
use schlupf::normal::patch::{Interpolation, Patch};
use schlupf::normal::{Grid, VectorField};
use schlupf::problem::Branch;
use schlupf::{Options, Problem, Solution, Status, Warning, solver, unwatched};

const SPEED: f64 = 15.0;
const COLD: f64 = 0.4;
const KINETIC: f64 = 0.05;

/// In Pa/m.
const BEDDING: f64 = 2e13;

/// The equations of longitudinal creepage on a bedding, cell by cell down the strips.
struct Equations {
    stiffness: f64,
    half_speed: f64,
    spacing: f64,
    pressure: Vec<f64>,
    /// Distance since the entry.
    distance: Vec<f64>,
    /// Displacement of every cell under its own traction.
    compliance: Vec<f64>,
    strips: Vec<Range<usize>>,
    /// Change of the displacement in passing a cell under the tractions, row by row.
    in_passing: Vec<Vec<f64>>,
}

/// A point of a branch: the creepage ξ and the traction on the rail in Pa.
#[derive(Clone)]
struct State {
    creepage: f64,
    traction: Vec<f64>,
}

/// Derivative at the first of some points of the polynomial through all of them (Lagrange), times
/// the distance to the second: a weight for each.
fn derivative(points: &[f64]) -> Vec<f64> {
    let way = points[0] - points[1];
    let mut weights = vec![0.0; points.len()];
    for j in 1..points.len() {
        let others = || (1..points.len()).filter(|m| *m != j);
        let above: f64 = others().map(|m| points[0] - points[m]).product();
        let below: f64 = others().map(|m| points[j] - points[m]).product();
        weights[j] = way * above / (below * (points[j] - points[0]));
        weights[0] -= weights[j];
    }
    weights
}

impl Equations {
    /// On an ellipse of the common problem.
    fn new(case: &Problem, across: usize, (stiffness, half_speed): (f64, f64)) -> Self {
        let normal = case.normal.normal_contact(None).unwrap();
        let patch = Patch::new(&normal, Grid::across(&normal.extent(), across, across));
        let grid = patch.grid;
        let interpolation = Interpolation::uncoupled(&patch);
        let mut compliance = case.interface.elasticity.compliance(&grid).unwrap();
        let cells = patch.len();
        let mut in_passing = vec![vec![0.0; cells]; cells];
        let mut fields = [0; 3].map(|_| VectorField::zeros(grid.len()));
        let [traction, displacement, passing] = &mut fields;
        let (mut passed, mut here) = (vec![0.0; 2 * cells], vec![0.0; 2 * cells]);
        let mut own = vec![0.0; cells];
        for j in 0..cells {
            let mut unit = vec![0.0; 2 * cells];
            unit[2 * j] = 1.0;
            interpolation.spread(&unit, traction);
            compliance.displacement(traction, displacement);
            for row in 0..grid.rows {
                for i in 1..grid.columns - 1 {
                    let at = row * grid.columns + i;
                    passing.x[at] = 0.5 * (displacement.x[at - 1] - displacement.x[at + 1]);
                }
            }
            interpolation.gather(displacement, &mut here);
            own[j] = here[2 * j];
            interpolation.gather_means(passing, &mut passed);
            for k in 0..cells {
                in_passing[k][j] = passed[2 * k];
            }
        }
        let pressure: Vec<f64> = patch.cells.iter().map(|cell| cell.pressure).collect();
        Self {
            stiffness,
            half_speed,
            spacing: grid.spacing_x,
            compliance: own,
            distance: patch.cells.iter().map(|cell| cell.since_entry.distance).collect(),
            strips: patch.strips.iter().map(|strip| strip.cells.clone()).collect(),
            pressure,
            in_passing,
        }
    }

    /// p − μ pₙ q, with q from the law of a strip: of the third order through the cell and up to
    /// three nodes upstream, the last one of which is the entry.
    fn defect(&self, State { creepage, traction }: &State) -> Vec<f64> {
        let mut residual = vec![0.0; traction.len()];
        for strip in &self.strips {
            let mut q = vec![0.0; traction.len()];
            for k in strip.clone() {
                let here = self.distance[k];
                // A node nearer to the one before than 0.4 of the first way is left out.
                let mut nodes = vec![(Some(k), here)];
                let upstream = (strip.start..k).rev().map(|j| (Some(j), self.distance[j]));
                for node in upstream.chain([(None, 0.0)]).take(3) {
                    let last = nodes[nodes.len() - 1].1;
                    if nodes.len() == 1 || last - node.1 >= 0.4 * (here - nodes[1].1) {
                        nodes.push(node);
                    }
                }
                let points: Vec<f64> = nodes.iter().map(|node| node.1).collect();
                let weights = derivative(&points);
                let (mut v, mut c) = (0.0, 0.0);
                for ((cell, distance), weight) in nodes.iter().zip(&weights) {
                    let moved = cell.map_or(0.0, |j| self.compliance[j] * traction[j]);
                    v += weight * (creepage * distance - moved);
                    c += weight * cell.filter(|j| *j != k).map_or(0.0, |j| q[j]);
                }
                let (own, relaxed) = (weights[0], self.stiffness * v.abs());
                let c = c.clamp(-own, own);
                let terms = [relaxed, relaxed.powi(2) / 2.0, relaxed.powi(3) / 6.0];
                let left: f64 = terms[..nodes.len() - 1].iter().sum();
                let left = if relaxed > 0.0 { left / relaxed.exp_m1() } else { 1.0 };
                q[k] = (self.stiffness * v - left * c) / (relaxed + left * own);
                let passing: f64 =
                    self.in_passing[k].iter().zip(traction).map(|(a, p)| a * p).sum();
                let slip = (SPEED * (creepage - passing / self.spacing)).abs();
                let fall = (COLD - KINETIC) / (2.0 * self.half_speed);
                let friction = (COLD - fall * slip).max(KINETIC);
                residual[k] = traction[k] - friction * self.pressure[k] * q[k];
            }
        }
        residual
    }

    /// The same with its Jacobian by differences, the last column being that by the creepage.
    fn residual(&self, state: &State) -> (Vec<f64>, Vec<Vec<f64>>) {
        let cells = state.traction.len();
        let scale = COLD * self.pressure.iter().copied().fold(0.0, f64::max);
        let column = |j: usize| {
            let h = if j < cells { 1e-7 * scale } else { 1e-10 };
            let [plus, minus] = [h, -h].map(|h| {
                let mut moved = state.clone();
                match moved.traction.get_mut(j) {
                    Some(p) => *p += h,
                    None => moved.creepage += h,
                }
                self.defect(&moved)
            });
            let changes = plus.iter().zip(&minus).map(|(plus, minus)| (plus - minus) / (2.0 * h));
            changes.collect::<Vec<f64>>()
        };
        let columns: Vec<Vec<f64>> = (0..=cells).map(column).collect();
        let row = |k: usize| columns.iter().map(|column| column[k]).collect();
        (self.defect(state), (0..cells).map(row).collect())
    }

    /// Newton's method at a creepage, in shorter steps where the equations have kinks; nothing
    /// where it does not find a state near by.
    fn correct(&self, mut state: State) -> Option<(State, Vec<f64>)> {
        let scale = COLD * self.pressure.iter().copied().fold(0.0, f64::max);
        let start = state.traction.clone();
        for _ in 0..40 {
            let (residual, jacobian) = self.residual(&state);
            let [step, tangent] = solve(jacobian, residual.clone())?;
            if largest(&step) < 1e-11 * scale {
                return Some((state, tangent));
            }
            let shortened = |part: f64| State {
                traction: state.traction.iter().zip(&step).map(|(p, d)| p - part * d).collect(),
                ..state
            };
            let parts = [1.0, 0.5, 0.25, 0.1, 0.03, 0.01];
            let better =
                parts.into_iter().map(|part| (part, shortened(part))).find(|(part, next)| {
                    norm(&self.defect(next)) < (1.0 - 0.1 * part) * norm(&residual)
                });
            // At the end there is nothing but rounding.
            state = better.map_or_else(|| shortened(1.0), |(_, next)| next);
            let away: Vec<f64> = state.traction.iter().zip(&start).map(|(p, q)| p - q).collect();
            if largest(&away) > NEAR * scale {
                return None;
            }
        }
        None
    }

    /// Follows a branch from a state to a creepage, as far as it goes without turning back: by
    /// tangents, in steps as small as needed.
    fn follow(&self, state: State, to: f64) -> (State, usize) {
        let Some((mut state, mut tangent)) = self.correct(state) else {
            panic!("no state to start from")
        };
        let (mut step, mut steps) = (1e-3 * (to - state.creepage), 0);
        while state.creepage != to {
            let left = to - state.creepage;
            let now = if step.abs() < left.abs() { step } else { left };
            let ahead = State {
                creepage: if step.abs() < left.abs() { state.creepage + now } else { to },
                traction: state.traction.iter().zip(&tangent).map(|(p, t)| p - now * t).collect(),
            };
            match self.correct(ahead) {
                Some(found) => {
                    (state, tangent) = found;
                    step *= 1.5;
                    steps += 1;
                }
                None => step *= 0.5,
            }
            if step.abs() < 1e-12 {
                return (state, steps);
            }
        }
        (state, steps)
    }
}

/// Largest correction of the traction that still counts as near, over μ0 p0.
const NEAR: f64 = 0.02;

fn largest(values: &[f64]) -> f64 {
    values.iter().map(|value| value.abs()).fold(0.0, f64::max)
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// J⁻¹ of a right side and of the last column of J, by Gauss's elimination with pivots.
fn solve(mut rows: Vec<Vec<f64>>, right: Vec<f64>) -> Option<[Vec<f64>; 2]> {
    let n = right.len();
    rows.iter_mut().zip(right).for_each(|(row, value)| row.push(value));
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()))?;
        rows.swap(k, pivot);
        let (above, below) = rows.split_at_mut(k + 1);
        let lead = &above[k];
        if lead[k].abs() < 1e-14 {
            return None;
        }
        for row in below {
            let factor = row[k] / lead[k];
            if factor != 0.0 {
                row.iter_mut().zip(lead).skip(k).for_each(|(a, b)| *a -= factor * b);
            }
        }
    }
    let mut solutions = [n + 1, n].map(|column| rows.iter().map(|row| row[column]).collect());
    for solution in &mut solutions {
        let x: &mut Vec<f64> = solution;
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
            x[k] = (x[k] - known) / rows[k][k];
        }
    }
    Some(solutions)
}

fn falling(creepage: f64, stiffness: f64, half_speed: f64) -> Problem {
    let mut falling = problem(rolling(creepage, 0.0, 0.0));
    falling.kinematics.speed = SPEED;
    falling.interface.elasticity = Arc::new(Winkler::new(BEDDING, BEDDING).unwrap());
    falling.interface.contact_law = Incremental::new(stiffness).unwrap().into();
    let law = Linear(SlipTerms::new(COLD, KINETIC, half_speed, None).unwrap());
    falling.interface.friction.law = Arc::new(law);
    falling
}

fn on_branch(problem: &Problem, across: usize, branch: Branch) -> Solution {
    let options =
        Options { cells_x: across, cells_y: across, tolerance: 1e-9, ..Options::default() };
    let problem = Problem { branch, ..problem.clone() };
    let solution = solver::solve(&problem, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

/// Goal: the state that is found from low slip and from high slip solves the equations as they are
/// put together here. Set-up: a = 6, b = 5 mm, p0 = 1 GPa on a bedding; μ from 0.4 to 0.05 at twice
/// the half speed, 15 m/s. Source: an independent discretisation.
#[test]
fn states_solve_the_equations() {
    let stiffness = 1e7;
    for (across, creepage, half_speed) in [(12, 2e-4, 1e-3), (12, 8e-4, 4e-3), (8, 4e-4, 2e-3)] {
        let case = falling(creepage, stiffness, half_speed);
        let equations = Equations::new(&case, across, (stiffness, half_speed));
        let bound: Vec<f64> = equations.pressure.iter().map(|p| COLD * p).collect();
        for branch in [Branch::LowSlip, Branch::HighSlip] {
            let found = on_branch(&case, across, branch);
            assert_eq!(found.work.steps, 0, "marched");
            let traction = found.fields.traction_x.iter().map(|t| -t).collect();
            let residual = equations.defect(&State { creepage, traction });
            assert!(norm(&residual) < 1e-7 * norm(&bound), "{branch:?}: {:e}", norm(&residual));
        }
    }
}

/// Goal: where each branch leads to the motion there is one state, that of the continuation from
/// both sides. Set-up and source as above, with friction that falls over five times the slip.
#[test]
fn one_state_is_that_of_a_continuation_from_both_sides() {
    let (across, stiffness, half_speed) = (10, 1e7, 0.1);
    for creepage in [4e-4, 1e-3] {
        let case = falling(creepage, stiffness, half_speed);
        let equations = Equations::new(&case, across, (stiffness, half_speed));
        let at_rest = vec![0.0; equations.pressure.len()];
        let sliding = equations.pressure.iter().map(|p| KINETIC * p).collect();
        let found = on_branch(&case, across, Branch::LowSlip);
        let area = 4.0 * 6e-3 * 5e-3 / (across * across) as f64;
        for (start, traction) in [(1e-9, at_rest), (0.05, sliding)] {
            let (state, _) = equations.follow(State { creepage: start, traction }, creepage);
            assert_eq!(state.creepage, creepage, "the branch turns back before");
            let expected = state.traction.iter().sum::<f64>() * area / (COLD * found.normal.load);
            assert!((expected + found.normalised.x).abs() < 1e-6, "{expected}");
        }
    }
}

/// Where a branch cannot be followed to the motion, which here only too few Newton steps prevent,
/// the state is one of the motion all the same, and a warning says that it may be on either branch.
#[test]
fn a_branch_that_is_lost_is_told() {
    let half_space = HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap();
    let terms = SlipTerms::new(0.4, 0.1, 0.05, None).unwrap();
    let case = Problem::builder()
        .creepage_x(0.003)
        .creepage_y(0.001)
        .elasticity(half_space)
        .contact_law(Incremental::new(1e10).unwrap())
        .friction(Exponential(terms))
        .heat(Heat::none())
        .build()
        .unwrap();
    let options = |max_iterations: usize| Options {
        cells_x: 14,
        cells_y: 8,
        max_iterations,
        ..Options::default()
    };
    let solve = |steps| solver::solve(&case, &options(steps), &unwatched).unwrap();
    let is_told = |solution: &Solution| solution.warnings.contains(&Warning::BranchLost {});
    let (few, enough) = (solve(4), solve(200));
    assert!(is_told(&few) && !is_told(&enough), "{:?} {:?}", few.warnings, enough.warnings);
    assert_eq!([few.status, enough.status], [Status::Converged; 2]);
    assert!(few.residual < 1e-6 && few.work.steps == 0);
}
