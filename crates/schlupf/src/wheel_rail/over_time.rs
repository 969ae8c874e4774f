//! A wheel over time: its contacts go on from each other, step by step.
//!
//! In every step the contacts are those of steady rolling in the present position, in which a
//! vertical force is carried with the friction of steady rolling. Cells lie on a lattice that moves
//! with the wheelset along the track and stays in place on the rail across it. A contact goes on
//! from the elements on its cells, whichever contacts of the step before left them there: so
//! contacts move across the rail, split and merge.

use super::creepage::Motion;
use super::resultant::instant;
use super::sliding::Tangential;
use super::wheel::{Contact, WheelOnRail, WheelSolution, total_force};
use super::wheel::{Position, Support};
use crate::bodies::Kinematics;
use crate::normal::{BORDER, Extent, Grid, NormalContact, Pressure, PressureTable};
use crate::numerics::interpolation::mix;
use crate::problem::{Element, History, MAX_CELLS_TOGETHER, State, Transient};
use crate::reporting::{Error, Quantity, Unconverged, Warning, Watch};
use crate::solution::{Instant, Solution, Status};
use crate::solver::march_from;

/// A wheel at a time.
#[derive(Debug, Clone)]
pub struct WheelAt {
    /// The time, in s.
    pub time: f64,
    /// The wheel. Where the time is that of the instant before, the motion is that of a shift at
    /// rest, which takes one second; if rolling follows, it begins with the motion of the next
    /// instant.
    pub wheel: WheelOnRail,
}

/// A wheel over time, linear between the instants.
#[derive(Debug, Clone)]
pub struct WheelOverTime {
    /// The instants, at least two, with ascending times. It starts without tangential tractions.
    pub instants: Vec<WheelAt>,
}

/// Finds the contacts of a wheel in steady rolling.
pub type Contacts<'a> = &'a mut dyn FnMut(&WheelOnRail) -> Result<WheelSolution, Error>;

impl WheelOverTime {
    /// The wheel at the last instant, and forces, load and motion of every step: those of the whole
    /// wheel in the track, with the creepages of the contact with the largest normal force.
    /// `contacts` finds the contacts at each instant.
    ///
    /// # Errors
    /// Fewer than two instants, times that do not ascend, those of `contacts` and of
    /// [`march`](crate::solver::march), too many cells, and [`Error::Stopped`].
    pub fn march(
        &self,
        tangential: &Tangential,
        contacts: Contacts,
        watch: Watch,
    ) -> Result<(WheelSolution, Vec<Instant>), Error> {
        let (quantity, count) = (Quantity::Time, self.instants.len());
        let Some(first) = self.instants.first().filter(|_| count >= 2) else {
            return Err(Error::TooFew { quantity, fewest: 2, count });
        };
        let wheel = contacts(&first.wheel)?;
        let mut size = size(&wheel)?;
        for pair in self.instants.windows(2).filter(|pair| !is_same(&pair[0].wheel, &pair[1].wheel))
        {
            let then = self::size(&contacts(&pair[1].wheel)?)?;
            size = [0, 1].map(|k| size[k].min(then[k]));
        }
        let mut rolling = Rolling::new((wheel, size), tangential, watch)?;
        rolling.support = first.wheel.support;
        rolling.time = first.time;
        let mut was_at_rest = true;
        // Shifts and rolling begin at the end of the step before.
        let mut delay = 0.0;
        for pair in self.instants.windows(2) {
            let [before, after] = [&pair[0], &pair[1]];
            if after.time < before.time {
                let (before, after) = (before.time, after.time);
                return Err(Error::NotAscending { quantity, axis: "", before, after });
            }
            if after.time == before.time {
                let wheel = contacts(&after.wheel)?;
                rolling.step(wheel, None)?;
                was_at_rest = true;
                continue;
            }
            let starts = was_at_rest && rolling.instants.last().is_some();
            let motion = if starts { after.wheel.motion } else { before.wheel.motion };
            let from = WheelOnRail { motion, ..before.wheel.clone() };
            if was_at_rest {
                delay = rolling.time - before.time;
            }
            was_at_rest = false;
            let [start, end] = [before.time, after.time].map(|time| time + delay);
            let mut last: Option<WheelOnRail> = None;
            while rolling.time < end - 1e-9 * (end - start) {
                let at = |time: f64| {
                    let share = ((time - start) / (end - start)).clamp(0.0, 1.0);
                    between([&from, &after.wheel], share)
                };
                let duration = rolling.spacing[0] / at(rolling.time).motion.speed;
                let wheel = at(rolling.time + duration);
                let is_same = last.as_ref().is_some_and(|last| is_same(last, &wheel));
                let found = if is_same { rolling.wheel.clone() } else { contacts(&wheel)? };
                last = Some(wheel);
                rolling.step(found, Some(duration))?;
            }
        }
        Ok((rolling.told(), rolling.instants))
    }
}

/// The wheel between two instants.
fn between([before, after]: [&WheelOnRail; 2], share: f64) -> WheelOnRail {
    let mixed = |one: f64, other: f64| mix([one, other], share);
    let (p, q) = (before.position, after.position);
    let (m, n) = (before.motion, after.motion);
    let support = match (before.support, after.support) {
        (Support::Force(one), Support::Force(other)) => Support::Force(mixed(one, other)),
        (Support::Height(one), Support::Height(other)) => Support::Height(mixed(one, other)),
        (_, other) => other,
    };
    WheelOnRail {
        position: Position {
            lateral: mixed(p.lateral, q.lateral),
            yaw: mixed(p.yaw, q.yaw),
            roll: mixed(p.roll, q.roll),
        },
        motion: Motion {
            speed: mixed(m.speed, n.speed),
            lateral_velocity: mixed(m.lateral_velocity, n.lateral_velocity),
            vertical_velocity: mixed(m.vertical_velocity, n.vertical_velocity),
            angular_velocity: mixed(m.angular_velocity, n.angular_velocity),
            roll_rate: mixed(m.roll_rate, n.roll_rate),
            yaw_rate: mixed(m.yaw_rate, n.yaw_rate),
            ..n
        },
        support,
        ..after.clone()
    }
}

fn is_same(one: &WheelOnRail, other: &WheelOnRail) -> bool {
    one.position == other.position && one.motion == other.motion && one.support == other.support
}

/// Sides of the contact with the largest normal force, in m.
fn size(wheel: &WheelSolution) -> Result<[f64; 2], Error> {
    let Some(main) = wheel.contacts.first() else { return Ok([f64::INFINITY; 2]) };
    let Extent { x, y } = main.problem.normal.normal_contact(None)?.extent();
    Ok([x[1] - x[0], y[1] - y[0]])
}

/// What a contact leaves for the next step.
struct Left {
    /// Middle of the patch on the lattice: along the track and along the rail, in m.
    middle: [f64; 2],
    normal: NormalContact,
    /// Elements with their columns and rows on the lattice.
    elements: Vec<([i64; 2], Element)>,
    /// Over its last step, if it has made one.
    motion: Option<Kinematics>,
}

/// Everything that changes from step to step.
struct Rolling<'a> {
    tangential: &'a Tangential<'a>,
    watch: Watch<'a>,
    /// Sides of the cells, in m.
    spacing: [f64; 2],
    wheel: WheelSolution,
    left: Vec<Left>,
    /// In s.
    time: f64,
    /// Rolled since the start, in m.
    distance: f64,
    instants: Vec<Instant>,
    /// What carries the wheel.
    support: Support,
    /// The largest residual of states that were not found, dimensionless.
    missed: f64,
    /// The largest change of the vertical force from steady rolling to the present tractions,
    /// relative to it, dimensionless.
    change: f64,
}

impl<'a> Rolling<'a> {
    /// From a wheel without tangential tractions; the cells are those of a contact of the given
    /// size, in m.
    fn new(
        (wheel, size): (WheelSolution, [f64; 2]),
        tangential: &'a Tangential<'a>,
        watch: Watch<'a>,
    ) -> Result<Self, Error> {
        let mut left = Vec::new();
        for contact in &wheel.contacts {
            let normal = contact.problem.normal.normal_contact(None)?;
            let (middle, elements, motion) = (middle(contact, &normal), Vec::new(), None);
            left.push(Left { middle, normal, elements, motion });
        }
        let options = tangential.options;
        let spacing = [size[0] / options.cells_x as f64, size[1] / options.cells_y as f64];
        Ok(Self {
            tangential,
            watch,
            spacing,
            wheel,
            left,
            time: 0.0,
            distance: 0.0,
            instants: Vec::new(),
            support: Support::Height(0.0),
            missed: 0.0,
            change: 0.0,
        })
    }

    /// The last wheel, with what is to be said of all steps.
    fn told(&mut self) -> WheelSolution {
        let mut wheel = self.wheel.clone();
        wheel.change_in_time = self.change;
        if let Some(contact) = wheel.contacts.first_mut().filter(|_| self.missed > 0.0) {
            let solution = &mut contact.solution;
            let (residual, tolerance) = (self.missed, self.tangential.options.tolerance);
            if solution.status == Status::Converged {
                let missed = Unconverged::TimeStep { residual, tolerance };
                solution.warnings.insert(0, Warning::of(missed));
            }
            solution.status = Status::NotConverged;
            solution.residual = solution.residual.max(residual);
        }
        wheel
    }

    /// Goes on to the contacts of a wheel, rolling over one cell (within a duration in s) or in a
    /// shift.
    fn step(&mut self, wheel: WheelSolution, duration: Option<f64>) -> Result<(), Error> {
        let mut wheel = wheel;
        let carried = wheel.force[2];
        let mut left = Vec::new();
        for contact in &mut wheel.contacts {
            let (solution, own) = self.go_on(contact, duration)?;
            for found in [&contact.solution, &solution] {
                if found.status != Status::Converged {
                    self.missed = self.missed.max(found.residual);
                }
            }
            contact.solution = solution;
            left.push(own);
        }
        wheel.force = total_force(&wheel.contacts);
        if let Support::Force(_) = self.support {
            let change = wheel.force[2] / carried - 1.0;
            if change.abs() > self.change.abs() {
                self.change = change;
            }
        }
        self.left = left;
        if let Some(duration) = duration {
            self.time += duration;
            self.distance += self.spacing[0];
        }
        self.instants.extend(instant(&wheel, [self.time, self.distance]));
        self.wheel = wheel;
        Ok(())
    }

    /// A contact at the end of a step, and what it leaves.
    fn go_on(&self, contact: &Contact, duration: Option<f64>) -> Result<(Solution, Left), Error> {
        let normal = contact.problem.normal.normal_contact(None)?;
        let middle = middle(contact, &normal);
        let extent = seen(&normal.extent(), middle, [0.0; 2]);
        let touching: Vec<&Left> = self
            .left
            .iter()
            .filter(|left| overlap(&extent, &seen(&left.normal.extent(), left.middle, [0.0; 2])))
            .collect();
        let before = union(&touching, middle)?.unwrap_or_else(|| normal.clone());
        let (grid, first) = self.window(&normal.extent().union(&before.extent()), middle)?;
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
        let initial_state = Some(State { grid, time: 0.0, elements, motion });
        let problem = contact.problem.clone();
        let rolled = duration.map(|_| self.spacing[0]);
        let history = history(&problem.kinematics, rolled);
        let transient = Transient { problem, history, initial_state };
        let options = self.tangential.options;
        let solution = march_from(&transient, Some(&before), options, self.watch)?;
        let place = |element: &Element| {
            let [i, j] = [element.index % grid.columns, element.index / grid.columns];
            [i as i64 + first[0], j as i64 + first[1]]
        };
        let elements = &solution.state.elements;
        let elements = elements.iter().map(|e| (place(e), e.clone())).collect();
        let motion = solution.state.motion;
        Ok((solution, Left { middle, normal, elements, motion }))
    }

    /// The cells of the lattice over an extent in the frame of a contact, with the column and row
    /// of the first one.
    fn window(&self, extent: &Extent, middle: [f64; 2]) -> Result<(Grid, [i64; 2]), Error> {
        let [(i, columns), (j, rows)] = [(0, extent.x), (1, extent.y)].map(|(k, side)| {
            let at = |edge: f64| (edge + middle[k]) / self.spacing[k];
            let first = at(side[0]).floor() as i64;
            (first, (at(side[1]).ceil() as i64 - first).max(1) as usize)
        });
        if columns * rows > MAX_CELLS_TOGETHER {
            return Err(Error::TooManyCells { columns, rows, most: MAX_CELLS_TOGETHER });
        }
        let first = [i - BORDER as i64, j];
        let [spacing_x, spacing_y] = self.spacing;
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
}

/// One step over a distance (in m) with constant creepages, or the shift that they are within one
/// second.
fn history(kinematics: &Kinematics, rolled: Option<f64>) -> History {
    if let Some(rolled) = rolled {
        // The rolling speed of a contact is not quite that of the wheelset.
        return History { time: vec![0.0, rolled / kinematics.speed], ..History::default() };
    }
    let Kinematics { speed, creepage_x, creepage_y, spin } = *kinematics;
    let [shift_x, shift_y, turn] =
        [creepage_x, creepage_y, spin].map(|part| Some(vec![speed * part]));
    History { time: vec![0.0], shift_x, shift_y, turn, ..History::default() }
}

/// Middle of the patch of a contact on the lattice, in m.
fn middle(contact: &Contact, normal: &NormalContact) -> [f64; 2] {
    let [x, y] = normal.summary.origin.unwrap_or_default();
    [contact.position[0] + x, contact.rail_arc + y]
}

/// An extent about one point as seen from another.
fn seen(extent: &Extent, middle: [f64; 2], from: [f64; 2]) -> Extent {
    let moved = |side: [f64; 2], k: usize| side.map(|edge| edge + middle[k] - from[k]);
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
