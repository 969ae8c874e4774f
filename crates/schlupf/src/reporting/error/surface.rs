//! What can be wrong with a rough surface.

use super::Error;
use crate::reporting::{Quantity, messages, readable};

messages! {
    /// Why heights are no rough surface, or none that can be solved for.
    SurfaceError:

    /// The hardness cannot carry the load.
    "beyond-hardness" BeyondHardness {
        /// The load, in N.
        load: f64,
        /// What the hardness can carry, in N.
        largest: f64,
    } Quantity::Load, |name, words| format!(
        "{name} must be positive and below what the hardness can carry, {} N, but is {} N",
        readable(*largest),
        readable(*load)
    );

    /// Waves of a rough surface are too short for the cells.
    "short-waves" ShortWaves {
        /// Shortest wavelength, in m.
        shortest: f64,
        /// Two cells, in m.
        two_cells: f64,
    } Quantity::ShortestWavelength, |name, words| format!(
        "{name} must be at least two cells, {} m, but is {} m",
        readable(*two_cells),
        readable(*shortest)
    );

    /// More than half of a surface has no height.
    "too-many-holes" TooManyHoles {
        /// Points without a height.
        holes: usize,
        /// All points.
        count: usize,
    } Quantity::Heights, |name, words| format!(
        "{name}: at most half of the points may be holes, but {holes} of {count} are"
    );

    /// The holes of a surface could not be filled.
    "holes-not-filled" HolesNotFilled {
        /// Iterations that were done.
        iterations: usize,
    } Quantity::Heights, |name, words| {
        format!("{name}: the holes are not filled after {iterations} iterations")
    };

    /// A surface or profile is flat.
    "flat" Flat {
        /// The height everywhere (in m); `None` of a profile on a straight line.
        height: Option<f64>,
    } Quantity::Heights, |name, words| match height {
        Some(height) => {
            format!("{name} must not be flat, but every height is {} m", readable(*height))
        }
        None => format!("{name} must not be flat, but its points lie on a straight line"),
    };

    /// Wavelengths are not those of adjacent one-third octave bands.
    "octave-bands" OctaveBands {
        /// Which one is not.
        index: usize,
        /// It, in m.
        wavelength: f64,
        /// The one that must follow, in m; `None` where it is the middle of no band.
        expected: Option<f64>,
    } Quantity::Heights, |name, words| {
        let is = readable(*wavelength);
        match expected {
            None => format!(
                "{name} must have finite levels at the middles of one-third octave bands, 10^(k/10) m, \
                 but has one at {is} m"
            ),
            Some(expected) => format!(
                "{name} must have all one-third octave bands up to {is} m once, but that of {} m is \
                 missing or one is given twice",
                readable(*expected)
            ),
        }
    };

    /// Two surfaces are on different lattices.
    "lattices-differ" LatticesDiffer {
        /// Columns and rows of both.
        cells: [[usize; 2]; 2],
        /// Distances of their points, in m.
        spacings: [[f64; 2]; 2],
    } Quantity::Heights, |name, words| {
        let lattice = |k: usize| {
            let ([columns, rows], [x, y]) = (cells[k], spacings[k].map(readable));
            format!("{columns} × {rows} cells of {x} × {y} m")
        };
        let [one, other] = [lattice(0), lattice(1)];
        format!("{name}: two surfaces must have the same lattice, but have {one} and {other}")
    };

    /// A form does not fit the surface.
    "no-form" NoForm {
        /// Its name.
        form: &'static str,
    } Quantity::Form, |name, words| format!("{name}: no {form} fits the surface");

    /// Approach and pressure of a rough contact do not increase together.
    "load-curve" LoadCurve {
        /// Points of the curve.
        points: usize,
    } Quantity::Heights, |name, words| format!(
        "{name}: approach and mean pressure must be positive and increase over at least three points, \
         but do not over {points} points"
    );

    /// A rough surface is in contact everywhere.
    "full-contact" FullContact {
        /// Mean pressure from which on it is, in Pa.
        pressure: f64,
        /// Largest mean pressure, in Pa.
        largest: f64,
        /// Hardness, in Pa; infinite for elastic bodies.
        hardness: f64,
    } Quantity::Heights, |name, words| {
        let cause = if hardness.is_finite() {
            format!(
                "{} MPa flatten it with a hardness of {} MPa, or its heights are in another unit",
                readable(1e-6 * largest),
                readable(1e-6 * hardness)
            )
        } else {
            "it is too smooth, the pressures are too large, or its heights are in another unit"
                .to_owned()
        };
        let pressure = readable(1e-6 * pressure);
        format!("{name}: all of the surface is in contact under {pressure} MPa: {cause}")
    };
}

impl std::error::Error for SurfaceError {}

impl From<SurfaceError> for Error {
    fn from(error: SurfaceError) -> Self {
        Self::Surface { error }
    }
}
