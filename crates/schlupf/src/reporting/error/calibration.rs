//! Why a layer cannot be calibrated.

use super::Error;
use crate::reporting::{Quantity, messages, readable};

messages! {
    /// Why no layer is found.
    CalibrationError:

    /// Motions of a calibration were not solved.
    "calibration-not-converged" NotConverged {
        /// a/b, dimensionless.
        axis_ratio: f64,
    } Quantity::Calibration, |name, words| format!(
        "{name}: the motions of a/b = {} could not be solved",
        readable(*axis_ratio)
    );

    /// No layer could be set up for given displacements.
    "no-layer" NoLayer {} Quantity::SampleDisplacement, |name, words| format!("{name}: no layer could be set up on its grid");

    /// Displacements oppose their load.
    "against-load" AgainstLoad {} Quantity::SampleDisplacement, |name, words| format!(
        "{name}: the displacements oppose their load: tractions must be those on the wheel, \
         displacements those of the wheel minus those of the rail"
    );

    /// No layer has the given displacements.
    "unlike-a-layer" UnlikeALayer {
        /// Those along rolling, or across.
        quantity: Quantity,
        /// Deviation of the nearest layer, dimensionless.
        deviation: f64,
    } *quantity, |name, words| format!(
        "{name}: no elastic layer has such displacements: the nearest is {:.0} % of them away; check \
         that tractions and displacements belong together, and their units",
        100.0 * deviation
    );
}

impl std::error::Error for CalibrationError {}

impl From<CalibrationError> for Error {
    fn from(error: CalibrationError) -> Self {
        Self::Calibration { error }
    }
}
