//! A table from exact normal contacts.

use std::sync::Arc;

use crate::numerics::parallel;
use crate::reporting::{Error, Quantity, Requirement, Watch, WheelRailError, require};
use crate::wheel_rail::contact_plane::{ContactPlane, Joining, planes};
use crate::wheel_rail::gap::Gap;
use crate::wheel_rail::pair::Pair;
use crate::wheel_rail::pose::Attitude;
use crate::wheel_rail::pressed::Pressed;
use crate::wheel_rail::pressing::{Accuracy, Pressing, Raised};
use crate::wheel_rail::virtual_penetration::NormalMethod;

use super::checking::ContactTableErrors;
use super::contacts::{ContactTable, Seat};
use super::grid::{AXES, Axis, Grid, VALUES};
use super::outlines::Node as Point;
use super::overlaps::{Overlap, Overlaps};
use super::placement::Placement;

/// What a table covers, and how accurately.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTableOptions {
    /// Largest roll angle of the wheelset relative to the rail, either way, in rad.
    pub roll: f64,
    /// Largest yaw angle, either way, in rad.
    pub yaw: f64,
    /// Least and largest depth of an overlap, in m: below and beyond them contacts are as there,
    /// but for Hertz's dependence.
    pub depth: [f64; 2],
    /// Largest error of the normal force where the table is refined no more, for nineteen of twenty
    /// nodes; dimensionless.
    pub tolerance: f64,
    /// Most nodes.
    pub most_nodes: usize,
    /// Cells across a contact each way.
    pub cells: usize,
    /// Random poses in which its errors are measured.
    pub poses: usize,
}

impl Default for ContactTableOptions {
    fn default() -> Self {
        Self {
            roll: 0.015,
            yaw: 0.03,
            depth: [1e-5, 2e-4],
            tolerance: 5e-3,
            most_nodes: 200_000,
            cells: 32,
            poses: 400,
        }
    }
}

impl ContactTableOptions {
    /// # Errors
    /// Angles, depths or a tolerance that make no table.
    pub fn check(&self) -> Result<(), Error> {
        let angle = Requirement::Between(1e-4, 0.3);
        require(Quantity::RollAngle, angle, self.roll)?;
        require(Quantity::WheelsetYaw, angle, self.yaw)?;
        require(Quantity::Tolerance, Requirement::Between(1e-4, 0.5), self.tolerance)?;
        let [least, largest] = self.depth;
        require(Quantity::Approach, Requirement::Between(1e-8, 1e-3), least)?;
        require(Quantity::Approach, Requirement::Between(2.0 * least, 5e-3), largest)?;
        require(Quantity::NormalCells, Requirement::Between(16.0, 512.0), self.cells as f64)?;
        require(Quantity::RandomPoses, Requirement::AtLeast(1.0), self.poses as f64)
    }
}

/// First step along the profile of the wheel, in m, and first numbers of nodes of the other axes.
const FIRST_STEP: f64 = 3e-3;
const FIRST_NODES: [usize; AXES - 1] = [5, 3, 5];

/// By how much the error between nodes falls where their distance is halved.
const ORDER: f64 = 8.0;

/// Part of the nodes whose error decides.
const DECIDING: f64 = 0.95;

/// Secant steps to a depth, and to a place on the wheel.
const DEPTH_STEPS: usize = 12;
const PLACE_STEPS: usize = 6;

/// Accuracy of a depth, dimensionless, and of a place in steps of the table.
const DEPTH_ACCURACY: f64 = 1e-4;
const PLACE_ACCURACY: f64 = 1e-3;

/// Largest distance of places on the wheel between which another one lies, in steps of the table.
const NEAR: f64 = 4.0;

/// What is known of a node.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Node {
    /// Nothing yet.
    Unknown,
    /// No pose has a contact there.
    Never,
    /// Its contact was not found, say at the end of a profile.
    Failed,
    /// Its contact relative to that of Hertz.
    Contact([f64; VALUES]),
}

/// A pose in which an overlap has a given depth.
#[derive(Debug, Clone, Copy)]
struct Trial {
    /// Arc length of the point of the wheel that touches, in m.
    arc: f64,
    attitude: Attitude,
    height: f64,
    seat: Seat,
    /// Of the overlap, in m.
    place: f64,
}

impl ContactTable {
    /// The table of a pair of profiles whose bodies have a contact modulus E*, in Pa. It is refined
    /// along the axis on which the normal force between nodes is least certain. With its errors.
    ///
    /// # Errors
    /// Profiles that change along the way, a roller; [`Error::Stopped`].
    pub fn build(
        pair: &Arc<Pair>,
        (contact_modulus, joining): (f64, Joining),
        options: &ContactTableOptions,
        watch: Watch,
    ) -> Result<(Self, ContactTableErrors), Error> {
        options.check()?;
        let mut table = Self::empty(pair, (contact_modulus, joining), options)?;
        let mut known = vec![Node::Unknown; table.grid.count()];
        loop {
            known = table.completed(known, (options.cells, watch))?;
            if !known.iter().any(|node| matches!(node, Node::Contact(_))) {
                return Err(WheelRailError::EmptyContactTable {}.into());
            }
            let values = filled(&table.grid, &known);
            table.grid = table.grid.with(values);
            let errors: [f64; AXES] = std::array::from_fn(|axis| table.uncertainty(axis, &known));
            let worst = (0..AXES).max_by(|one, two| errors[*one].total_cmp(&errors[*two]));
            let worst = worst.unwrap_or_default();
            let finer = table.grid.refined(worst);
            let is_within_tolerance = errors[worst] <= options.tolerance;
            if is_within_tolerance || finer.count() > options.most_nodes {
                let failed = known.iter().filter(|node| **node == Node::Failed).count();
                let errors = table.errors(options.poses, (is_within_tolerance, failed), watch)?;
                return Ok((table, errors));
            }
            let mut nodes = vec![Node::Unknown; finer.count()];
            for (index, node) in known.iter().enumerate() {
                let mut place = table.grid.node(index);
                place[worst] *= 2;
                nodes[finer.index(place)] = *node;
            }
            (table.grid, known) = (finer, nodes);
        }
    }

    /// Without values.
    fn empty(
        pair: &Arc<Pair>,
        (contact_modulus, joining): (f64, Joining),
        options: &ContactTableOptions,
    ) -> Result<Self, Error> {
        let [roll, yaw] = [options.roll, options.yaw];
        let ends = [[-roll, roll], [0.0, yaw], options.depth.map(f64::ln)];
        let [rolls, yaws, depths] =
            std::array::from_fn(|k| Axis::between(ends[k], FIRST_NODES[k] - 1));
        let mut table = Self::over(pair, (contact_modulus, joining), [rolls, rolls, yaws, depths])?;
        let nodes = &table.outlines.nodes;
        let ends = [0, nodes.len() - 1].map(|k| nodes[k].arc);
        let steps = ((ends[1] - ends[0]) / FIRST_STEP).ceil().max(2.0) as usize;
        table.grid.axes[0] = Axis::between(ends, steps);
        Ok(table)
    }

    /// With the contacts of nodes that are not known.
    fn completed(
        &self,
        mut known: Vec<Node>,
        (cells, watch): (usize, Watch),
    ) -> Result<Vec<Node>, Error> {
        let [places, rolls, yaws, depths] = self.grid.axes.map(|axis| axis.count);
        let mut lines = Vec::new();
        for roll in 0..rolls {
            for yaw in 0..yaws {
                lines.extend((0..depths).map(|depth| [roll, yaw, depth]));
            }
        }
        let at = |place: usize, [roll, yaw, depth]: [usize; 3]| {
            self.grid.index([place, roll, yaw, depth])
        };
        let found = parallel::try_map(lines, |line| {
            let mut nodes: Vec<Node> = (0..places).map(|place| known[at(place, line)]).collect();
            if nodes.contains(&Node::Unknown) {
                self.complete(line, (cells, watch), &mut nodes)?;
            }
            Ok::<_, Error>((line, nodes))
        })?;
        for (line, nodes) in found {
            for (place, node) in nodes.into_iter().enumerate() {
                known[at(place, line)] = node;
            }
        }
        Ok(known)
    }

    /// The nodes along the wheel at a roll angle, a yaw angle and a depth.
    fn complete(
        &self,
        [roll, yaw, depth]: [usize; AXES - 1],
        how: (usize, Watch),
        line: &mut [Node],
    ) -> Result<(), Error> {
        let [_, rolls, yaws, depths] = self.grid.axes;
        let attitude = Attitude { lateral: 0.0, roll: rolls.at(roll), yaw: yaws.at(yaw) };
        let depth = depths.at(depth).exp();
        let points = self.outlines.nodes.iter();
        let trials: Vec<Vec<Trial>> =
            points.map(|point| self.trials(point, attitude, depth)).collect();
        for two in trials.windows(2) {
            for one in &two[0] {
                for other in &two[1] {
                    self.between([one, other], depth, how, line)?;
                }
            }
        }
        let never = line.iter_mut().filter(|node| **node == Node::Unknown);
        never.for_each(|node| *node = Node::Never);
        Ok(())
    }

    /// How far the normal force between the nodes of an axis is uncertain, as far as it is known:
    /// from what interpolation over every second node makes of the others.
    fn uncertainty(&self, axis: usize, known: &[Node]) -> f64 {
        let count = self.grid.axes[axis].count;
        let coarse = self.grid.coarsened(axis);
        let odd = known.iter().enumerate().filter_map(|(index, node)| {
            let Node::Contact([load, ..]) = node else { return None };
            let place = self.grid.node(index);
            let is_between = place[axis] % 2 == 1 && place[axis] + 1 < count;
            is_between.then(|| {
                let at = std::array::from_fn(|k| self.grid.axes[k].at(place[k]));
                (coarse.at(at)[0][0] / load - 1.0).abs()
            })
        });
        let mut errors: Vec<f64> = odd.collect();
        errors.sort_unstable_by(f64::total_cmp);
        let place = (DECIDING * errors.len() as f64) as usize;
        let error = errors.get(place.min(errors.len().saturating_sub(1)));
        error.map_or(f64::INFINITY, |error| error / ORDER)
    }

    /// Poses in which a point of the wheel touches and its overlap has a depth, in m.
    fn trials(&self, node: &Point, attitude: Attitude, depth: f64) -> Vec<Trial> {
        let placement = Placement::new(&self.pair, attitude, 0.0);
        let posed = placement.at(node);
        // The slope of the line of candidates across the track.
        let beside = |by: f64| {
            let slope = node.slope;
            placement.at(&Point { y: node.y + by, radius: node.radius - slope * by, ..*node })
        };
        let [before, after] = [-1e-6, 1e-6].map(beside);
        let rise = (after.place[2] - before.place[2]) / (after.place[1] - before.place[1]);
        let touches = self.outlines.with_slope(rise).into_iter();
        let trial = |y: f64| {
            let lateral = y - posed.place[1];
            let height = self.outlines.rail(y)?.z - posed.place[2];
            let attitude = Attitude { lateral, ..attitude };
            self.at_depth((attitude, height), (node.arc, y), depth)
        };
        touches.filter_map(trial).collect()
    }

    /// The pose, lowered from a touching height, in which the overlap around y has a depth.
    fn at_depth(
        &self,
        (attitude, touching): (Attitude, f64),
        (arc, y): (f64, f64),
        depth: f64,
    ) -> Option<Trial> {
        let mut lowered = depth;
        for _ in 0..DEPTH_STEPS {
            let height = touching - lowered;
            let seat = self.around(attitude, height, y)?;
            let found = seat.depth.value;
            if (found / depth - 1.0).abs() < DEPTH_ACCURACY {
                let place = seat.arc.value;
                return Some(Trial { arc, attitude, height, seat, place });
            }
            // The depth grows by as much as the wheel is lowered.
            lowered += (depth - found) / -seat.depth.slopes[super::placement::HEIGHT];
        }
        None
    }

    /// The overlap that contains y, in m.
    fn around(&self, attitude: Attitude, height: f64, y: f64) -> Option<Seat> {
        let placement = Placement::new(&self.pair, attitude, height);
        let overlaps = Overlaps::new(&self.outlines, &placement, &self.joining);
        let contains = |of: &&Overlap| (of.ends[0][0] - 1e-3..=of.ends[1][0] + 1e-3).contains(&y);
        let overlap = overlaps.all().iter().find(contains)?;
        self.seat(&placement, overlap)
    }

    /// Fills the nodes of a line whose places are between those of two poses.
    fn between(
        &self,
        [one, other]: [&Trial; 2],
        depth: f64,
        (cells, watch): (usize, Watch),
        line: &mut [Node],
    ) -> Result<(), Error> {
        let places = self.grid.axes[0];
        let [from, to] = [one.place, other.place].map(|at| (at - places.start) / places.step);
        if (to - from).abs() > NEAR {
            return Ok(());
        }
        let (low, high) = (from.min(to).ceil().max(0.0), from.max(to).floor());
        let mut k = low;
        while k <= high && k < line.len() as f64 {
            let index = k as usize;
            if matches!(line[index], Node::Unknown | Node::Failed) {
                let trial = self.at_place([one, other], places.at(index), depth);
                let found = match trial {
                    Some(trial) => self.exact(&trial, cells, watch)?,
                    None => None,
                };
                line[index] = found.map_or(Node::Failed, Node::Contact);
            }
            k += 1.0;
        }
        Ok(())
    }

    /// A pose between two whose overlap is at a place, in m.
    fn at_place(&self, [one, other]: [&Trial; 2], place: f64, depth: f64) -> Option<Trial> {
        let (mut low, mut high) = (*one, *other);
        let accuracy = PLACE_ACCURACY * self.grid.axes[0].step;
        for _ in 0..PLACE_STEPS {
            let part = ((place - low.place) / (high.place - low.place)).clamp(0.1, 0.9);
            let part = if part.is_finite() { part } else { 0.5 };
            let point = self.point(low.arc + part * (high.arc - low.arc))?;
            let attitude = Attitude { lateral: 0.0, ..low.attitude };
            let near = |trial: &Trial| (trial.attitude.lateral - low.attitude.lateral).abs();
            let trials = self.trials(&point, attitude, depth).into_iter();
            let trial = trials.min_by(|one, two| near(one).total_cmp(&near(two)))?;
            if (trial.place - place).abs() < accuracy {
                return Some(trial);
            }
            let is_below = (trial.place - place) * (high.place - low.place) < 0.0;
            *(if is_below { &mut low } else { &mut high }) = trial;
        }
        let off = |trial: &Trial| (trial.place - place).abs();
        let nearest = if off(&low) < off(&high) { low } else { high };
        (off(&nearest) < 0.1 * self.grid.axes[0].step).then_some(nearest)
    }

    /// A point of the wheel between its nodes.
    fn point(&self, arc: f64) -> Option<Point> {
        let nodes = &self.outlines.nodes;
        let after = nodes.partition_point(|node| node.arc <= arc);
        let (before, after) = (nodes.get(after.checked_sub(1)?)?, nodes.get(after)?);
        let part = (arc - before.arc) / (after.arc - before.arc);
        let mix = |of: fn(&Point) -> f64| of(before) + part * (of(after) - of(before));
        Some(Point {
            arc,
            y: mix(|node| node.y),
            radius: mix(|node| node.radius),
            slope: mix(|node| node.slope),
            width: before.width,
        })
    }

    /// The exact contact of a pose relative to that of Hertz; `None` where there is none.
    fn exact(
        &self,
        trial: &Trial,
        cells: usize,
        watch: Watch,
    ) -> Result<Option<[f64; VALUES]>, Error> {
        let pair = &self.pair;
        let gap = Gap::new(pair, &trial.attitude)?;
        let regions = gap.regions(trial.height, pair.radius_along());
        let y = trial.seat.position()[1];
        let planes = planes(pair, &regions, (&self.joining, false));
        let away = |plane: &ContactPlane| (plane.origin[1] - y).abs();
        let plane = planes.iter().min_by(|one, two| away(one).total_cmp(&away(two)));
        let Some(plane) = plane else { return Ok(None) };
        let pose = pair.wheel_in(&trial.attitude.at_height(pair.nominal_radius, trial.height));
        let pressing = Pressing {
            pair,
            pose: &pose,
            contact_modulus: self.contact_modulus,
            poisson_ratio: 0.0,
            method: NormalMethod::HalfSpaces,
            watch,
        };
        let raised = Raised { everywhere: 0.0, opening: None };
        let pressed = match pressing.solve(plane, raised, Accuracy::Cells(cells)) {
            Err(Error::Stopped { .. }) => return Err(Error::Stopped {}),
            found => found.ok().flatten(),
        };
        Ok(pressed.map(|pressed| relative(&pressed, &trial.seat)))
    }
}

/// Load, second moments and centre of a pressure relative to a contact of Hertz.
fn relative(pressed: &Pressed, seat: &Seat) -> [f64; VALUES] {
    let squares: [fn(f64, f64) -> f64; 2] = [|x, _| x * x, |_, s| s * s];
    let ([along, across], [ahead, beside]) = (pressed.means(squares), pressed.centre());
    // ∫ p x² dA = N a²/5 for a semi-ellipsoid.
    let axis = |square: f64, middle: f64| (5.0 * (square - middle * middle)).sqrt();
    let [a, b] = seat.pressed.semi_axes.map(|axis| axis.value);
    let load = pressed.force / seat.pressed.load.value;
    [load, axis(along, ahead) / a, axis(across, beside) / b, ahead / a, beside / b]
}

/// All values: between the nodes along the wheel that have contacts, and constant beyond them.
fn filled(grid: &Grid, known: &[Node]) -> Vec<[f64; VALUES]> {
    let mut values = vec![[1.0, 1.0, 1.0, 0.0, 0.0]; known.len()];
    let stride = known.len() / grid.axes[0].count;
    for line in 0..stride {
        let own: Vec<(usize, [f64; VALUES])> = (0..grid.axes[0].count)
            .filter_map(|place| match known[place * stride + line] {
                Node::Contact(values) => Some((place, values)),
                _ => None,
            })
            .collect();
        for place in 0..grid.axes[0].count {
            let after = own.partition_point(|(known, _)| *known < place);
            let before = after.checked_sub(1).map(|before| own[before]);
            values[place * stride + line] = match (before, own.get(after)) {
                (Some((before, low)), Some((after, high))) => {
                    let part = (place - before) as f64 / (after - before) as f64;
                    std::array::from_fn(|v| low[v] + part * (high[v] - low[v]))
                }
                (Some((_, one)), None) => one,
                (None, Some((_, one))) => *one,
                (None, None) => continue,
            };
        }
    }
    values
}
