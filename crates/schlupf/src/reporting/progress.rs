//! Progress of long computations, and the decision whether to continue.

use std::ops::ControlFlow;

use crate::reporting::Error;

/// What is being computed.
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
    /// Layers of stresses below the surface.
    Subsurface,
    /// Points below the surface.
    StressPoints,
    /// Layers in which the largest stresses are searched, and measures of them.
    LargestStress,
    /// States of a study.
    Study,
    /// States of a look-up table.
    Table,
}

impl Stage {
    /// What is counted, in words.
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
            Self::Subsurface => "layers",
            Self::StressPoints => "stresses, points",
            Self::LargestStress => "largest stresses, layers",
            Self::Study => "states",
            Self::Table => "states of the table",
        }
    }
}

/// Progress of a computation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Progress {
    /// What is being computed.
    pub stage: Stage,
    /// Number done.
    pub done: usize,
    /// Total number, if known beforehand.
    pub total: Option<usize>,
    /// Relative change or residual that decreases towards the tolerance, dimensionless; if there is
    /// one.
    pub change: Option<f64>,
}

impl Progress {
    /// A given number done, of an unknown total.
    pub fn count(stage: Stage, done: usize) -> Self {
        Self { stage, done, total: None, change: None }
    }

    /// The same, with a number done of a known total.
    #[must_use]
    pub fn of(self, done: usize, total: usize) -> Self {
        Self { done, total: Some(total), ..self }
    }
}

/// Receives the progress and decides whether to continue: after [`ControlFlow::Break`] the
/// computation ends with [`Error::Stopped`]. Several threads may call it at the same time.
///
/// ```
/// use schlupf::reporting::Progress;
/// use schlupf::{solver, Error, Options, Problem};
/// use std::ops::ControlFlow;
///
/// let stop = |_: Progress| ControlFlow::Break(());
/// let problem = Problem::builder().creepage_x(0.002).build()?;
/// let solved = solver::solve(&problem, &Options::default(), &stop);
/// assert!(matches!(solved, Err(Error::Stopped {})));
/// # Ok::<(), schlupf::Error>(())
/// ```
pub type Watch<'a> = &'a (dyn Fn(Progress) -> ControlFlow<()> + Sync);

/// Never interrupts.
pub fn unwatched(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Watches part of a computation: whatever it reports, the progress passed on is that of the whole,
/// with the part's residual if the whole has none.
pub(crate) fn within(
    watch: Watch<'_>,
    whole: Progress,
) -> impl Fn(Progress) -> ControlFlow<()> + Sync + '_ {
    move |part| watch(Progress { change: whole.change.or(part.change), ..whole })
}

/// Reports progress; an error if the computation is to stop.
pub(crate) fn tell(watch: Watch, progress: Progress) -> Result<(), Error> {
    match watch(progress) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Error::Stopped {}),
    }
}
