//! A step of a wheel over time: every contact goes on from what contacts before have left.

use std::sync::Arc;

use super::pressed::Pressed;
use super::side::Side;
use crate::bodies::Kinematics;
use crate::normal::{BORDER, Extent, Grid, NormalContact, Pressure, PressureTable};
use crate::problem::{
    Element, History, MAX_CELLS_TOGETHER, Method, Options, Problem, State, Transient,
};
use crate::reporting::{Error, Watch};
use crate::solution::Solution;
use crate::solver::{Solver, SteadySolver, march_from};

/// What the contacts of a wheel or of a wheelset leave for the next step in time.
#[derive(Debug, Clone)]
pub struct Past {
    pub(super) left: Vec<Left>,
    /// Sides of the cells of the lattice, in m.
    pub(super) spacing: [f64; 2],
    pub(super) step: Step,
}

/// How the next step goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Step {
    /// Rolling until nothing changes.
    Settle,
    /// Rolling over one cell.
    Roll,
    /// In a shift that takes so long, in s.
    Shift(f64),
}

/// What a contact leaves.
#[derive(Debug, Clone)]
pub(super) struct Left {
    pub side: Side,
    /// Middle of the patch on the lattice: along the track and along the rail, in m.
    middle: [f64; 2],
    normal: NormalContact,
    /// Elements with their columns and rows on the lattice.
    elements: Vec<([i64; 2], Element)>,
    /// Over its last step, if it has made one.
    motion: Option<Kinematics>,
}

impl Left {
    /// Of a contact without tangential tractions at a place along the track and along the rail, in
    /// m.
    pub fn pressed(side: Side, place: [f64; 2], normal: NormalContact) -> Self {
        let middle = middle(place, &normal);
        Self { side, middle, normal, elements: Vec::new(), motion: None }
    }

    /// Of one whose last step has a solution.
    pub fn of(
        side: Side,
        place: [f64; 2],
        (normal, solution): (NormalContact, &Solution),
        spacing: [f64; 2],
    ) -> Self {
        let State { grid, elements, motion, .. } = &solution.state;
        let middle = middle(place, &normal);
        let corner = [grid.origin_x, grid.origin_y];
        let first = [0, 1].map(|k| ((corner[k] + middle[k]) / spacing[k]).round() as i64);
        let place = |element: &Element| {
            let [i, j] = [element.index % grid.columns, element.index / grid.columns];
            [i as i64 + first[0], j as i64 + first[1]]
        };
        let elements = elements.iter().map(|e| (place(e), e.clone())).collect();
        Self { side, middle, normal, elements, motion: *motion }
    }

    /// Sides of the patch, in m.
    pub fn size(&self) -> [f64; 2] {
        let Extent { x, y } = self.normal.extent();
        [x[1] - x[0], y[1] - y[0]]
    }

    fn extent(&self) -> Extent {
        seen(&self.normal.extent(), self.middle)
    }
}

/// Solves one contact at the end of a step.
pub(super) struct TimeStep {
    pub past: Arc<Past>,
    pub side: Side,
    /// Where the contact is along the track and along the rail, in m.
    pub place: [f64; 2],
    pub options: Options,
}

impl TimeStep {
    /// That of a contact.
    pub fn new(past: &Arc<Past>, (pressed, side): (&Pressed, Side), options: &Options) -> Self {
        let place = [pressed.plane.origin[0], side.outwards() * pressed.plane.arcs[0]];
        Self { past: Arc::clone(past), side, place, options: options.clone() }
    }
}

impl Solver for TimeStep {
    fn method(&self) -> Method {
        Method::Full
    }

    fn options(&self) -> &Options {
        &self.options
    }

    fn solve_given(&mut self, problem: &Problem, watch: Watch) -> Result<Solution, Error> {
        let Past { left, spacing, step } = &*self.past;
        let normal = problem.normal.normal_contact(None)?;
        let middle = middle(self.place, &normal);
        let extent = seen(&normal.extent(), middle);
        let own = left.iter().filter(|left| left.side == self.side);
        let touching: Vec<&Left> = own.filter(|left| overlap(&extent, &left.extent())).collect();
        let before = union(&touching, middle)?.unwrap_or_else(|| normal.clone());
        let (grid, first) = window(&normal.extent().union(&before.extent()), (middle, *spacing))?;
        let elements = touching.iter().flat_map(|left| &left.elements);
        let mut elements: Vec<Element> = elements
            .filter_map(|(place, element)| {
                let [i, j] = [0, 1].map(|k| usize::try_from(place[k] - first[k]).ok());
                let (i, j) = (i?, j?);
                let index = (i < grid.columns && j < grid.rows).then(|| grid.index(i, j))?;
                Some(Element { index, ..element.clone() })
            })
            .collect();
        if elements.is_empty() {
            elements.push(Element::default());
        }
        let motion = touching.first().and_then(|left| left.motion);
        let Some(history) = history(&problem.kinematics, (*step, spacing[0])) else {
            return SteadySolver::on(grid, &self.options).solve(problem, watch);
        };
        let transient = Transient {
            problem: problem.clone(),
            history,
            initial_state: Some(State { grid, time: 0.0, elements, motion }),
        };
        march_from(&transient, Some(&before), &self.options, watch)
    }
}

/// One step over a distance (in m) with constant creepages, or the shift that they are; nothing in
/// steady rolling.
fn history(kinematics: &Kinematics, (step, distance): (Step, f64)) -> Option<History> {
    let Kinematics { speed, creepage_x, creepage_y, spin, .. } = *kinematics;
    Some(match step {
        Step::Settle => return None,
        // The rolling speed of a contact is not quite that of the wheelset.
        Step::Roll => History { time: vec![0.0, distance / speed], ..History::default() },
        Step::Shift(duration) => {
            let [shift_x, shift_y, turn] =
                [creepage_x, creepage_y, spin].map(|part| Some(vec![speed * duration * part]));
            History { time: vec![0.0], shift_x, shift_y, turn, ..History::default() }
        }
    })
}

/// The cells of the lattice over an extent in the frame of a contact, with the column and row of
/// the first one.
fn window(
    extent: &Extent,
    (middle, spacing): ([f64; 2], [f64; 2]),
) -> Result<(Grid, [i64; 2]), Error> {
    let [(i, columns), (j, rows)] = [(0, extent.x), (1, extent.y)].map(|(k, side)| {
        let at = |edge: f64| (edge + middle[k]) / spacing[k];
        let first = at(side[0]).floor() as i64;
        (first, (at(side[1]).ceil() as i64 - first).max(1) as usize)
    });
    if columns * rows > MAX_CELLS_TOGETHER {
        return Err(Error::TooManyCells { columns, rows, most: MAX_CELLS_TOGETHER });
    }
    let first = [i - BORDER as i64, j];
    let [spacing_x, spacing_y] = spacing;
    let grid = Grid {
        columns: columns + 2 * BORDER,
        rows,
        spacing_x,
        spacing_y,
        origin_x: first[0] as f64 * spacing_x - middle[0],
        origin_y: first[1] as f64 * spacing_y - middle[1],
    };
    Ok((grid, first))
}

/// Middle of the patch of a contact on the lattice, in m.
fn middle(place: [f64; 2], normal: &NormalContact) -> [f64; 2] {
    let [x, y] = normal.summary.origin.unwrap_or_default();
    [place[0] + x, place[1] + y]
}

/// An extent about a point, on the lattice.
fn seen(extent: &Extent, middle: [f64; 2]) -> Extent {
    let moved = |side: [f64; 2], k: usize| side.map(|edge| edge + middle[k]);
    Extent { x: moved(extent.x, 0), y: moved(extent.y, 1) }
}

fn overlap(one: &Extent, other: &Extent) -> bool {
    let meet = |p: [f64; 2], q: [f64; 2]| p[0] < q[1] && q[0] < p[1];
    meet(one.x, other.x) && meet(one.y, other.y)
}

/// The pressure of contacts together, in the frame of another contact with its middle at a place.
fn union(touching: &[&Left], middle: [f64; 2]) -> Result<Option<NormalContact>, Error> {
    let tables: Vec<PressureTable> = touching
        .iter()
        .filter_map(|left| {
            let Pressure::Tabulated(table, factor) = &left.normal.pressure else { return None };
            let from = [0, 1].map(|k| middle[k] - left.middle[k]);
            Some(table.scaled(*factor).seen_from(from))
        })
        .collect();
    let Some(largest) = touching.first() else { return Ok(None) };
    let table = PressureTable::union(&tables)?;
    let summary = largest.normal.summary;
    Ok(Some(NormalContact {
        summary,
        pressure: Pressure::Tabulated(table.into(), 1.0),
        rows: None,
    }))
}
