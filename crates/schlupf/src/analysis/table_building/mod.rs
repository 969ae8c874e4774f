//! Makes look-up tables: solves the states at the nodes, and adds nodes until random states are
//! within the error that was asked for.
//!
//! States are solved with Coulomb's law on the half-space and extrapolated from two grids; where
//! these differ by more than 0.2 % of μN, from grids twice as fine. Slender patches have more cells
//! along their longer side: where they spin about a point within, the slip turns round over a
//! length like that of the shorter side.
//!
//! The limit of sliding without rolling is integrated. It changes fastest with the direction of the
//! creepages, where slender patches spin about a point within them, and needs no solution: nodes
//! are added until it alone is right everywhere. Then, after each round of solutions, intervals
//! around random states in which the table is off are halved.

mod full_sliding;
mod first_nodes;
mod states;
mod kept;
mod refinement;
mod random_states;

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::numerics::parallel;
use crate::problem::look_up_table::{LookUpTable, Shape, TableNodes};
use crate::reporting::{
    Error, Progress, Quantity, Requirement, Stage, Watch, require, require_several, tell,
};
use crate::solver::kalker_coefficients::interpolated_coefficients;
use first_nodes::first_nodes;
use full_sliding::FullSliding;
use random_states::RandomStates;
use refinement::{Additions, Grid};
use states::StateSolver;

pub use kept::{Keeper, NothingKept, Task};
pub use states::{LONGER_SIDE_EXPONENT, Solved};

/// Which table to make.
#[derive(Debug, Clone, PartialEq)]
pub struct TableOptions {
    /// ν, dimensionless.
    pub poisson_ratio: f64,
    /// Smallest and largest a/b, dimensionless, from 0.05 to 20.
    pub axis_ratios: [f64; 2],
    /// Largest error of forces over μN and moments over μN √(ab) in random states, dimensionless.
    pub tolerance: f64,
    /// Most solutions at nodes: a round that would need more is not begun.
    pub most_solutions: usize,
    /// Cells across the narrower side of the patch of the coarser of the two pairs of grids, at
    /// least 20; along the longer side there are more, by the square root of their ratio.
    pub cells: usize,
    /// Random states that decide whether the table is good enough, as many that confirm it, and as
    /// many that then measure its error.
    pub states: usize,
}

impl Default for TableOptions {
    /// The standard table: steel, a/b from 0.1 to 10, 1 %.
    fn default() -> Self {
        Self {
            poisson_ratio: 0.28,
            axis_ratios: [0.1, 10.0],
            tolerance: STANDARD_TOLERANCE,
            most_solutions: 200_000,
            cells: 24,
            states: 1000,
        }
    }
}

/// A table and how good it is.
#[derive(Debug, Clone, PartialEq)]
pub struct BuiltTable {
    /// The table.
    pub table: LookUpTable,
    /// Its error in rolling with slip: in random states that had no part in making it or in ending
    /// the work.
    pub error: TableError,
    /// Its error in sliding without rolling, likewise.
    pub sliding_error: TableError,
    /// Whether the tolerance was met by the random states that decide and by those that confirm it.
    pub is_within_tolerance: bool,
    /// Solutions at nodes.
    pub solutions: usize,
    /// Solutions of these, and of the random states, that did not converge.
    pub unconverged: usize,
    /// Rounds of refinement.
    pub rounds: usize,
}

/// Errors of forces over μN and moments over μN √(ab), the larger of both, in random states: a/b
/// and r uniform in their logarithms (r from 0.03 to 1000, or infinite), the direction of the
/// creepages uniform on the sphere in every other state; in the others the patch spins about a
/// point within it, uniform over its area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableError {
    /// Number of states.
    pub states: usize,
    /// Median, dimensionless.
    pub median: f64,
    /// 90 % are below this, dimensionless.
    pub ninety_percent: f64,
    /// The largest, dimensionless.
    pub largest: f64,
}

/// Poisson's ratios that differ by less are the same.
const SAME: f64 = 1e-9;

/// Fewest nodes of an axis to begin with.
const FEWEST: usize = 5;

/// Intervals of a/b to begin with.
const INTERVALS_OF_A_DECADE: f64 = 8.0;

/// The tolerance of the standard table.
const STANDARD_TOLERANCE: f64 = 0.01;

/// Nodes are added where the table is off by this part of the largest error, or of the tolerance,
/// because in other places it may be off by more.
const MARGIN: f64 = 0.5;

/// r in sliding without rolling.
const NEARLY_INFINITE: f64 = 1e12;

/// Most rounds of refinement; each adds at least one node to an axis.
const MOST_ROUNDS: usize = 60;

/// Makes a table.
///
/// ```
/// use schlupf::analysis::table_building::{NothingKept, TableOptions, build};
/// use schlupf::unwatched;
///
/// let options = TableOptions {
///     axis_ratios: [0.9, 1.1],
///     tolerance: 0.3,
///     states: 10,
///     ..TableOptions::default()
/// };
/// let built = build(&options, &NothingKept, &unwatched)?;
/// assert!(built.error.median < 0.05);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Options outside their bounds, and [`Error::Stopped`].
pub fn build(
    options: &TableOptions,
    keeper: &dyn Keeper,
    watch: Watch,
) -> Result<BuiltTable, Error> {
    options.check()?;
    let (axes, solved) = (options.axes()?, BTreeMap::new());
    finish(Building { options, axes, solved, keeper }, watch)
}

/// The same, where nodes that an earlier table of the same ν has, too, are taken from there. They
/// are those of a table that converged.
///
/// # Errors
/// Those of [`build`], and another ν.
pub fn build_from(
    earlier: &LookUpTable,
    options: &TableOptions,
    keeper: &dyn Keeper,
    watch: Watch,
) -> Result<BuiltTable, Error> {
    options.check()?;
    let ratio = earlier.nodes().poisson_ratio;
    let same = Requirement::Between(ratio - SAME, ratio + SAME);
    require(Quantity::PoissonRatio, same, options.poisson_ratio)?;
    let solved = forces_of(earlier.nodes());
    finish(Building { options, axes: options.axes()?, solved, keeper }, watch)
}

/// Solves and refines until random states are within the tolerance.
fn finish(mut building: Building, watch: Watch) -> Result<BuiltTable, Error> {
    let (options, keeper) = (building.options, building.keeper);
    let mut sets = 0..;
    let mut draw = || RandomStates::new(options, sets.next().unwrap_or(u64::MAX), keeper, watch);
    let mut states = draw()?;
    let mut unconverged = states.unconverged;
    let mut round = 0;
    loop {
        round += 1;
        building.solve(round, watch)?;
        let nodes = building.nodes()?;
        let table = LookUpTable::new(nodes)?;
        let is_within = |states: &RandomStates| states.largest_error(&table) <= options.tolerance;
        let mut is_good = is_within(&states);
        if is_good {
            // Other states confirm it, or decide from then on.
            states = draw()?;
            unconverged += states.unconverged;
            is_good = is_within(&states);
        }
        let error = MARGIN * states.largest_error(&table).max(options.tolerance);
        let places = states.places_beyond(&table, error);
        let additions = Grid { nodes: table.nodes() }.additions(&places);
        let is_last = round == MOST_ROUNDS || !building.can_refine(&additions);
        if is_good || is_last {
            let measuring = draw()?;
            let at_nodes = building.solved.values().filter(|solved| !solved.converged);
            return Ok(BuiltTable {
                error: measuring.error(&table),
                sliding_error: measuring.sliding_error(&table),
                table,
                is_within_tolerance: is_good,
                solutions: building.solved.len(),
                unconverged: at_nodes.count() + unconverged + measuring.unconverged,
                rounds: round,
            });
        }
        building.refine(&additions);
    }
}

impl TableOptions {
    /// Checks them, as [`build`] does.
    ///
    /// # Errors
    /// Those outside their bounds.
    pub fn check(&self) -> Result<(), Error> {
        require(Quantity::PoissonRatio, Requirement::Between(0.0, 0.5), self.poisson_ratio)?;
        let [low, high] = self.axis_ratios;
        require(Quantity::AxisRatio, Requirement::Between(0.05, 20.0), low)?;
        require(Quantity::AxisRatio, Requirement::Between(0.05, 20.0), high)?;
        if low >= high {
            let (before, after) = (low, high);
            return Err(Error::NotAscending {
                quantity: Quantity::AxisRatio,
                axis: "",
                before,
                after,
            });
        }
        require(Quantity::Tolerance, Requirement::Between(1e-4, 0.5), self.tolerance)?;
        require(Quantity::CellsX, Requirement::Between(20.0, 200.0), self.cells as f64)?;
        require_several(Quantity::LookUpTable, 1, self.states)
    }

    /// Numbers of nodes to begin with, of a/b, azimuth, inclination and saturation. The error of
    /// the splines is of fourth order.
    fn first_counts(&self) -> [usize; 4] {
        let part = (STANDARD_TOLERANCE / self.tolerance).powf(0.25).min(1.0);
        let [low, high] = self.axis_ratios;
        let decades = (high / low).log10();
        let ratios = 1.0 + INTERVALS_OF_A_DECADE * decades;
        [ratios, 14.0, 9.0, 13.0].map(|count| ((part * count).round() as usize).max(FEWEST))
    }

    /// The nodes to begin with.
    fn axes(&self) -> Result<[Vec<f64>; 4], Error> {
        let between = |low: f64, high: f64, count: usize, intervals: usize| -> Vec<f64> {
            (0..count).map(|k| low + (high - low) * (k as f64 / intervals as f64)).collect()
        };
        let [ratios, azimuths, inclinations, saturations] = self.first_counts();
        let [low, high] = self.axis_ratios;
        let mut axis_ratios: Vec<f64> =
            between(low.ln(), high.ln(), ratios, ratios - 1).iter().map(|x| x.exp()).collect();
        // Without the rounding error of the logarithm.
        (axis_ratios[0], axis_ratios[ratios - 1]) = (low, high);
        let directions = [
            between(0.0, PI, azimuths, azimuths),
            between(0.0, FRAC_PI_2, inclinations, inclinations - 1),
        ];
        let [axis_ratios, azimuths, inclinations] = first_nodes(self, axis_ratios, directions)?;
        Ok([axis_ratios, azimuths, inclinations, between(0.0, 1.0, saturations, saturations - 1)])
    }
}

/// A node: the bits of a/b, azimuth, inclination and saturation.
type Node = [u64; 4];

/// A table that grows.
struct Building<'a> {
    options: &'a TableOptions,
    /// Nodes of a/b, azimuth, inclination and saturation.
    axes: [Vec<f64>; 4],
    solved: BTreeMap<Node, Solved>,
    keeper: &'a dyn Keeper,
}

/// Missing nodes of one a/b and azimuth: inclination and saturation.
type Missing = Vec<[f64; 2]>;

impl Building<'_> {
    /// Solves the nodes that are missing in a round.
    fn solve(&mut self, round: usize, watch: Watch) -> Result<(), Error> {
        let mut groups: Vec<([f64; 2], Missing)> = Vec::new();
        for ratio in &self.axes[0] {
            for azimuth in &self.axes[1] {
                let missing = self.missing(*ratio, *azimuth);
                if !missing.is_empty() {
                    groups.push(([*ratio, *azimuth], missing));
                }
            }
        }
        let (before, new) = (self.solved.len(), groups.iter().map(|(_, missing)| missing.len()));
        let total = before + new.sum::<usize>();
        let done = AtomicUsize::new(before);
        let (poisson_ratio, cells) = (self.options.poisson_ratio, self.options.cells);
        let keeper = self.keeper;
        let found = parallel::try_map(groups, |([ratio, azimuth], missing)| {
            let task = Task::Nodes { round, axis_ratio: ratio, azimuth };
            let nodes = missing
                .iter()
                .map(|[inclination, saturation]| node([ratio, azimuth, *inclination, *saturation]));
            // Each starts from the one before: all of them are kept, or none.
            if let Some(known) = kept::recall(keeper, task, missing.len()) {
                done.fetch_add(known.len(), Ordering::Relaxed);
                return Ok::<Vec<_>, Error>(nodes.zip(known).collect());
            }
            let shape = shape(ratio, poisson_ratio)?;
            let mut solver = StateSolver::new(ratio, poisson_ratio, cells)?;
            let solve = |[inclination, saturation]: &[f64; 2]| {
                let count = done.fetch_add(1, Ordering::Relaxed);
                tell(watch, Progress::count(Stage::Table, count).of(count, total))?;
                let creepages = shape.creepages(*saturation, *inclination, azimuth);
                solver.solve(creepages, &crate::reporting::unwatched)
            };
            let solved = missing.iter().map(solve).collect::<Result<Vec<_>, Error>>()?;
            keeper.keep(task, &solved);
            Ok(nodes.zip(solved).collect())
        })?;
        self.solved.extend(found.into_iter().flatten());
        Ok(())
    }

    /// Nodes at an a/b and an azimuth that are to be solved and have not been.
    fn missing(&self, ratio: f64, azimuth: f64) -> Missing {
        let [_, _, inclinations, saturations] = &self.axes;
        let mut missing = Vec::new();
        for inclination in inclinations {
            // All azimuths are the same in the direction of ξ.
            if *inclination == 0.0 && azimuth != 0.0 {
                continue;
            }
            for saturation in &saturations[1..saturations.len() - 1] {
                let node = node([ratio, azimuth, *inclination, *saturation]);
                if !self.solved.contains_key(&node) {
                    missing.push([*inclination, *saturation]);
                }
            }
        }
        missing
    }

    /// The table as it is.
    fn nodes(&self) -> Result<TableNodes, Error> {
        let [axis_ratios, azimuths, inclinations, saturations] = self.axes.clone();
        let poisson_ratio = self.options.poisson_ratio;
        let sliding = FullSliding::new();
        let of_ratios = parallel::try_map(axis_ratios.clone(), |ratio| {
            let shape = shape(ratio, poisson_ratio)?;
            let mut values = Vec::new();
            for azimuth in &azimuths {
                for inclination in &inclinations {
                    let direction = shape.direction(*inclination, *azimuth);
                    let adhesion = shape.adhesion(direction);
                    for saturation in &saturations {
                        let at = [ratio, *azimuth, *inclination, *saturation];
                        let force = self.force(at, || sliding.force(&shape, ratio, direction));
                        values.push(rest(force, adhesion, *saturation));
                    }
                }
            }
            Ok::<_, Error>((values, shape.coefficients))
        })?;
        let (values, creep_coefficients): (Vec<_>, Vec<_>) = of_ratios.into_iter().unzip();
        Ok(TableNodes {
            poisson_ratio,
            axis_ratios,
            azimuths,
            inclinations,
            saturations,
            values: values.concat(),
            creep_coefficients,
        })
    }

    /// The force at a node; not a number if it was not solved.
    fn force(
        &self,
        [ratio, azimuth, inclination, saturation]: [f64; 4],
        sliding: impl FnOnce() -> [f64; 3],
    ) -> [f64; 3] {
        if saturation == 0.0 {
            return [0.0; 3];
        }
        let is_along = inclination == 0.0;
        let azimuth = if is_along { 0.0 } else { azimuth };
        let solved = || self.solved.get(&node([ratio, azimuth, inclination, saturation]));
        let [x, y, moment] = if saturation == 1.0 {
            sliding()
        } else {
            solved().map_or([f64::NAN; 3], |solved| solved.force)
        };
        // Zero by symmetry, which the solver knows to rounding error only.
        match (is_along, inclination == FRAC_PI_2) {
            (true, _) => [x, 0.0, 0.0],
            (_, true) => [0.0, y, moment],
            _ => [x, y, moment],
        }
    }

    /// Whether there are nodes to add, and not too many.
    fn can_refine(&self, additions: &Additions) -> bool {
        let counts = self.axes.iter().zip(additions).map(|(axis, new)| axis.len() + new.len());
        let is_more = additions.iter().any(|new| !new.is_empty());
        is_more && counts.product::<usize>() <= self.options.most_solutions
    }

    /// Adds nodes.
    fn refine(&mut self, additions: &Additions) {
        for (axis, new) in self.axes.iter_mut().zip(additions) {
            axis.extend(new);
            axis.sort_unstable_by(f64::total_cmp);
        }
    }
}

/// The forces at the nodes of a table, but those that are not solved.
fn forces_of(nodes: &TableNodes) -> BTreeMap<Node, Solved> {
    let mut solved = BTreeMap::new();
    let mut values = nodes.values.iter();
    for (ratio, coefficients) in nodes.axis_ratios.iter().zip(&nodes.creep_coefficients) {
        let shape = Shape::new(*ratio, *coefficients);
        for azimuth in &nodes.azimuths {
            for inclination in &nodes.inclinations {
                let adhesion = shape.adhesion(shape.direction(*inclination, *azimuth));
                for (saturation, value) in nodes.saturations.iter().zip(values.by_ref()) {
                    let is_end = *saturation == 0.0 || *saturation == 1.0;
                    if is_end || (*inclination == 0.0 && *azimuth != 0.0) {
                        continue;
                    }
                    let force = |k: usize| saturation * (adhesion[k] + f64::from(value[k]));
                    let force = std::array::from_fn(force);
                    let at = node([*ratio, *azimuth, *inclination, *saturation]);
                    solved.insert(at, Solved { force, converged: true });
                }
            }
        }
    }
    solved
}

/// R at a node: see [`crate::problem::look_up_table`].
fn rest(force: [f64; 3], adhesion: [f64; 3], saturation: f64) -> [f32; 3] {
    if saturation == 0.0 {
        return [0.0; 3];
    }
    std::array::from_fn(|k| (force[k] / saturation - adhesion[k]) as f32)
}

/// Of forces over μN and moments over μN √(ab), the larger of both; dimensionless.
fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
    let [x, y, moment]: [f64; 3] = std::array::from_fn(|k| one[k] - other[k]);
    x.hypot(y).max(moment.abs())
}

fn shape(axis_ratio: f64, poisson_ratio: f64) -> Result<Shape, Error> {
    let c = interpolated_coefficients(axis_ratio, poisson_ratio)?;
    Ok(Shape::new(axis_ratio, [c.c11, c.c22, c.c23, c.c33]))
}

fn node(at: [f64; 4]) -> Node {
    at.map(f64::to_bits)
}
