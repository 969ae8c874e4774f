//! How far something that takes long has got, and whether it is to go on.

use std::ops::ControlFlow;

use crate::error::Error;

/// What goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Iterations of a normal contact.
    NormalContact,
    /// Loads of a rough contact.
    LoadCurve,
    /// Newton steps towards a steady state.
    Steady,
    /// Time steps.
    Marching,
    /// Points of a creep curve.
    Curve,
    /// Steady states towards the bulk temperature of the wheel.
    BulkTemperature,
    /// Forces that a fit has computed.
    Fit,
    /// Motions that a calibration has solved.
    Calibration,
}

impl Stage {
    /// What is counted, for people.
    pub fn counted(self) -> &'static str {
        match self {
            Self::NormalContact => "normal contact, iterations",
            Self::LoadCurve => "loads",
            Self::Steady => "Newton steps",
            Self::Marching => "time steps",
            Self::Curve => "points",
            Self::BulkTemperature => "steady states",
            Self::Fit => "fitting, forces",
            Self::Calibration => "calibrating, motions",
        }
    }
}

/// How far something has got.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Progress {
    /// What goes on.
    pub stage: Stage,
    /// How many of it are done.
    pub done: usize,
    /// All of them, where known beforehand.
    pub total: Option<usize>,
    /// Relative change or residual that falls towards the tolerance, dimensionless; if there is
    /// one.
    pub change: Option<f64>,
}

impl Progress {
    /// So many of something done, of an unknown number.
    pub fn count(stage: Stage, done: usize) -> Self {
        Self { stage, done, total: None, change: None }
    }

    /// The same with so many done of a known number.
    #[must_use]
    pub fn of(self, done: usize, total: usize) -> Self {
        Self { done, total: Some(total), ..self }
    }
}

/// Sees how far something has got, and says whether it is to go on: after [`ControlFlow::Break`] it
/// ends with [`Error::Stopped`]. Several threads may ask at the same time.
///
/// ```
/// use schlupf::{Error, Options, Problem, progress::Progress, rolling};
/// use std::ops::ControlFlow;
///
/// let stop = |_: Progress| ControlFlow::Break(());
/// let problem = Problem::builder().creepage_x(0.002).build()?;
/// let solved = rolling::steady::solve(&problem, &Options::default(), &stop);
/// assert!(matches!(solved, Err(Error::Stopped {})));
/// # Ok::<(), schlupf::Error>(())
/// ```
pub type Watch<'a> = &'a (dyn Fn(Progress) -> ControlFlow<()> + Sync);

/// Lets everything go on.
pub fn unwatched(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Watches a part of something: whatever it tells, the whole has got as far as this.
pub(crate) fn within(
    watch: Watch<'_>,
    whole: Progress,
) -> impl Fn(Progress) -> ControlFlow<()> + Sync + '_ {
    move |_| watch(whole)
}

/// Tells how far something has got; an error if it is to stop.
pub(crate) fn tell(watch: Watch, progress: Progress) -> Result<(), Error> {
    match watch(progress) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Error::Stopped {}),
    }
}
