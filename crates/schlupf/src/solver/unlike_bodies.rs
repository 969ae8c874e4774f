//! Normal and tangential contact of unlike bodies, one after the other until neither changes
//! (Panagiotopoulos 1975; Kalker 1990, §4.1): the pressure is found with the opening that the
//! tractions cause, and the tractions with that pressure and the displacement under it.

use std::sync::Arc;

use crate::elasticity::PressureCoupling;
use crate::normal::profile::UndeformedDistance;
use crate::normal::{Grid, Opened, VectorField};
use crate::problem::Problem;
use crate::reporting::{Error, Unconverged, Warning, Watch};
use crate::solution::{Fields, Solution, Status};
use crate::solver::settings;

/// The solution of a problem by what solves it under one pressure, to a tolerance of the opening
/// relative to the approach; without iterations if the bodies are alike, or if their undeformed
/// distance is not known.
pub(crate) fn settled(
    problem: &Problem,
    (tolerance, watch): (f64, Watch),
    mut solve: impl FnMut(&Problem) -> Result<Solution, Error>,
) -> Result<Solution, Error> {
    let coupling = problem.interface.elasticity.pressure_coupling();
    let Some(coupling) = coupling.filter(|coupling| coupling.is_mutual) else {
        return solve(problem);
    };
    problem.check()?;
    problem.normal.prepare(None, watch)?;
    let modulus = coupling.contact_modulus();
    let Some(opened) = Opened::new(&problem.normal, modulus, watch)? else {
        return solve(problem);
    };
    let mut opening = vec![0.0; opened.cells().grid.len()];
    let mut opened = Arc::new(opened);
    let mut problem = problem.clone();
    let (mut before, mut iterations) = (None, 0);
    loop {
        iterations += 1;
        problem.normal = Arc::clone(&opened) as _;
        let mut solution = solve(&problem)?;
        // A first guess if forces are prescribed.
        problem.kinematics = solution.kinematics;
        if let Some(before) = &before {
            solution.work.add(before);
        }
        let cells = opened.cells();
        let next = opening_under(&solution.fields, &coupling, [&cells.x, &cells.y])?;
        let next = next.sample(&cells.x, &cells.y);
        let change = opened.change([&opening, &next]);
        let is_found = change <= tolerance || solution.status != Status::Converged;
        if is_found || iterations == settings::most_pressures() {
            let missed = Unconverged::Pressure { iterations, change, tolerance };
            return Ok(finished(solution, (!is_found).then_some(missed), coupling.constant));
        }
        before = Some(solution.work);
        opened = Arc::new(opened.by(&next, modulus, watch)?);
        opening = next;
    }
}

/// The solution with what is said about it, if the pressure `missed` the tolerance or not.
pub(crate) fn finished(
    mut solution: Solution,
    missed: Option<Unconverged>,
    constant: f64,
) -> Solution {
    let unchanged = |warning: &Warning| matches!(warning, Warning::UnchangedPressure { .. });
    solution.warnings.retain(|warning| !unchanged(warning));
    if solution.sensitivity.is_some() && constant != 0.0 {
        let in_derivatives = true;
        solution.warnings.push(Warning::UnchangedPressure { constant, in_derivatives });
    }
    if let Some(missed) = missed {
        if let Unconverged::Pressure { change, .. } = missed {
            solution.residual = solution.residual.max(change);
        }
        solution.status = Status::NotConverged;
        solution.warnings.insert(0, Warning::of(missed));
    }
    solution
}

/// How far the tractions of a solution move the surfaces apart (in m), on the grid of the tractions
/// extended to x and y (in m, ascending).
pub(crate) fn opening_under(
    fields: &Fields,
    coupling: &PressureCoupling,
    [x, y]: [&[f64]; 2],
) -> Result<UndeformedDistance, Error> {
    let within = fields.grid;
    // Cells to add in front of the first and behind the last.
    let beyond = |[first, last]: [f64; 2], line: &[f64], spacing: f64| {
        let rim = |length: f64| (length / spacing).ceil().max(0.0) as usize + 2;
        [rim(first - line[0]), rim(line[line.len() - 1] - last)]
    };
    let ends = |at: &dyn Fn(usize) -> f64, count: usize| [at(0), at(count - 1)];
    let columns = ends(&|i| within.x(i), within.columns);
    let rows = ends(&|j| within.y(j), within.rows);
    let [left, right] = beyond(columns, x, within.spacing_x);
    let [below, above] = beyond(rows, y, within.spacing_y);
    let grid = Grid {
        columns: left + within.columns + right,
        rows: below + within.rows + above,
        origin_x: within.origin_x - left as f64 * within.spacing_x,
        origin_y: within.origin_y - below as f64 * within.spacing_y,
        ..within
    };
    let mut traction = VectorField::zeros(grid.len());
    for (k, [column, row]) in fields.cell.iter().enumerate() {
        let index = grid.index(column + left, row + below);
        (traction.x[index], traction.y[index]) = (fields.traction_x[k], fields.traction_y[k]);
    }
    let opening = coupling.opening(&grid, &traction);
    let x = (0..grid.columns).map(|i| grid.x(i)).collect();
    let y = (0..grid.rows).map(|j| grid.y(j)).collect();
    UndeformedDistance::on_lattice(x, y, opening)
}
