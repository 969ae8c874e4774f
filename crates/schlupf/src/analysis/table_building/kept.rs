//! What has been solved for a table, kept by whoever makes it, so that work that ends early goes on
//! where it was.

use super::states::Solved;

/// A part of the work, always the same for the same options.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Task {
    /// The nodes of an a/b and an azimuth that a round adds.
    Nodes {
        /// From 1.
        round: usize,
        /// a/b, dimensionless.
        axis_ratio: f64,
        /// Direction of the creepages, in rad.
        azimuth: f64,
    },
    /// A random state.
    Random {
        /// Which set, from 0.
        set: u64,
        /// Which state of it, from 0.
        state: usize,
    },
}

/// Keeps what has been solved. It is asked from several threads.
pub trait Keeper: Sync {
    /// What was kept of a part of the work, with the same options.
    fn recall(&self, task: Task) -> Option<Vec<Solved>>;

    /// Keeps a part.
    fn keep(&self, task: Task, solved: &[Solved]);
}

/// Keeps nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct NothingKept;

impl Keeper for NothingKept {
    fn recall(&self, _: Task) -> Option<Vec<Solved>> {
        None
    }

    fn keep(&self, _: Task, _: &[Solved]) {}
}

/// What was kept of a part, if it has as many states.
pub(super) fn recall(keeper: &dyn Keeper, task: Task, count: usize) -> Option<Vec<Solved>> {
    keeper.recall(task).filter(|solved| solved.len() == count)
}
