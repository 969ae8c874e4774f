//! What every module speaks: quantities with their units, requirements, errors and warnings,
//! progress, and results as columns.

mod quantity;
mod message;
mod requirement;
mod error;
mod warning;
mod tally;
mod progress;
mod columns;

pub use columns::{Column, Record, Value, columns, distinct};
pub use error::{
    CalibrationError, CurveError, Error, FitCause, FitError, FitStop, ForceError, MethodPurpose,
    Place, StateError, SurfaceError, WheelRailError,
};
pub(crate) use error::{require, require_at, require_finite, require_positive, require_several};
pub use message::{Message, Names, Subject, Words, cut, messages, quoted, quoted_path, shortened};
pub use progress::{Progress, Stage, Watch, unwatched};
pub(crate) use progress::{tell, within};
pub use quantity::Quantity;
pub use requirement::{Requirement, readable, with_unit};
pub(crate) use tally::places;
pub use tally::{Graded, Tallied, Tally};
pub(crate) use warning::Unconverged;
pub use warning::{HeatLimit, Warning};
