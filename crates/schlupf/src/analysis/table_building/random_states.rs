//! Random states that decide whether a table is good enough, and measure how good it is.

use std::f64::consts::PI;
use std::sync::atomic::{AtomicUsize, Ordering};

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::numerics::parallel;
use crate::problem::look_up_table::{LookUpTable, Shape};
use crate::reporting::{Error, Progress, Stage, Watch, tell};

use super::full_sliding::FullSliding;
use super::kept::{self, Keeper, Task};
use super::refinement::Place;
use super::states::StateSolver;
use super::{NEARLY_INFINITE, TableError, TableOptions, distance, shape};

/// Range of r.
const SIZES: [f64; 2] = [1.0 / 30.0, 1000.0];

/// States of sliding without rolling for each other one: they need no solution.
const SLIDING: usize = 10;

/// A state with its force, all normalised.
struct State {
    axis_ratio: f64,
    shape: Shape,
    creepages: [f64; 3],
    force: [f64; 3],
}

/// Random states with their forces.
pub(super) struct RandomStates {
    rolling: Vec<State>,
    sliding: Vec<State>,
    pub unconverged: usize,
}

/// What is drawn: a shape of the patch, r and the direction of x.
struct Drawn {
    axis_ratio: f64,
    shape: Shape,
    size: f64,
    direction: [f64; 3],
}

impl RandomStates {
    /// A set of states; each number has its own.
    pub fn new(
        options: &TableOptions,
        set: u64,
        keeper: &dyn Keeper,
        watch: Watch,
    ) -> Result<Self, Error> {
        let mut random = Pcg64Mcg::seed_from_u64(set);
        let mut uniform = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
        let mut draw = |count: usize| -> Result<Vec<Drawn>, Error> {
            (0..count)
                .map(|k| Drawn::new(options, k % 2 == 0, std::array::from_fn(|_| uniform())))
                .collect()
        };
        let (rolling, sliding) = (draw(options.states)?, draw(SLIDING * options.states)?);
        let total = rolling.len();
        let done = AtomicUsize::new(0);
        let rolling: Vec<_> = rolling.into_iter().enumerate().collect();
        let solved = parallel::try_map(rolling, |(state, drawn)| {
            let count = done.fetch_add(1, Ordering::Relaxed);
            tell(watch, Progress::count(Stage::Table, count).of(count, total))?;
            let Drawn { axis_ratio, shape, .. } = drawn;
            let creepages = drawn.creepages(drawn.size);
            let task = Task::Random { set, state };
            let known = kept::recall(keeper, task, 1).and_then(|known| known.first().copied());
            let solved = if let Some(known) = known {
                known
            } else {
                let cells = 2 * options.cells;
                let mut solver = StateSolver::new(axis_ratio, options.poisson_ratio, cells)?;
                let solved = solver.solve(creepages, &crate::reporting::unwatched)?;
                keeper.keep(task, &[solved]);
                solved
            };
            let state = State { axis_ratio, shape, creepages, force: solved.force };
            Ok::<_, Error>((state, solved.converged))
        })?;
        let integral = FullSliding::new();
        let sliding = parallel::try_map(sliding, |drawn| {
            let Drawn { axis_ratio, shape, direction, .. } = drawn;
            let force = integral.force(&shape, axis_ratio, direction);
            let creepages = drawn.creepages(NEARLY_INFINITE);
            Ok::<_, Error>(State { axis_ratio, shape, creepages, force })
        })?;
        let unconverged = solved.iter().filter(|(_, converged)| !converged).count();
        Ok(Self {
            rolling: solved.into_iter().map(|(state, _)| state).collect(),
            sliding,
            unconverged,
        })
    }

    /// The error of a table in rolling with slip.
    pub fn error(&self, table: &LookUpTable) -> TableError {
        error(&self.rolling, table)
    }

    /// The error of a table in sliding without rolling.
    pub fn sliding_error(&self, table: &LookUpTable) -> TableError {
        error(&self.sliding, table)
    }

    /// Where a table is off by more than an error; dimensionless.
    pub fn places_beyond(&self, table: &LookUpTable, error: f64) -> Vec<Place> {
        let states = self.rolling.iter().chain(&self.sliding);
        states.filter(|state| state.error(table) > error).map(State::place).collect()
    }

    /// The largest of all; dimensionless.
    pub fn largest_error(&self, table: &LookUpTable) -> f64 {
        self.error(table).largest.max(self.sliding_error(table).largest)
    }
}

impl Drawn {
    /// From numbers between 0 and 1; with a direction uniform on the sphere, or a point of the
    /// patch about which it spins, uniform over its area.
    fn new(
        options: &TableOptions,
        is_on_sphere: bool,
        [of_ratio, of_size, of_height, of_angle]: [f64; 4],
    ) -> Result<Self, Error> {
        let between = |[low, high]: [f64; 2], part: f64| low * (high / low).powf(part);
        let axis_ratio = between(options.axis_ratios, of_ratio);
        let shape = shape(axis_ratio, options.poisson_ratio)?;
        let (sine, cosine) = (2.0 * PI * of_angle).sin_cos();
        let direction = if is_on_sphere {
            let height = 2.0 * of_height - 1.0;
            let across = (1.0 - height * height).sqrt();
            [height, across * cosine, across * sine]
        } else {
            let radius = of_height.sqrt();
            let [x, y] =
                [radius * cosine * axis_ratio.sqrt(), radius * sine * axis_ratio.sqrt().recip()];
            let [along, across, spin] = shape.scales;
            let plain = [along * y, -across * x, spin];
            let length = plain.iter().map(|part| part * part).sum::<f64>().sqrt();
            plain.map(|part| part / length)
        };
        Ok(Self { axis_ratio, shape, size: between(SIZES, of_size), direction })
    }

    fn creepages(&self, size: f64) -> [f64; 3] {
        std::array::from_fn(|k| size * self.direction[k] / self.shape.scales[k])
    }
}

impl State {
    fn error(&self, table: &LookUpTable) -> f64 {
        let found = table.normalised_force(self.axis_ratio, self.creepages).force;
        distance(found, self.force)
    }

    fn place(&self) -> Place {
        let found = self.shape.coordinates(self.creepages);
        let saturation = found.size / (1.0 + found.size);
        [self.axis_ratio, found.azimuth, found.inclination, saturation]
    }
}

fn error(states: &[State], table: &LookUpTable) -> TableError {
    let mut errors: Vec<f64> = states.iter().map(|state| state.error(table)).collect();
    errors.sort_unstable_by(f64::total_cmp);
    let at = |part: f64| errors[((errors.len() - 1) as f64 * part).round() as usize];
    TableError { states: errors.len(), median: at(0.5), ninety_percent: at(0.9), largest: at(1.0) }
}
