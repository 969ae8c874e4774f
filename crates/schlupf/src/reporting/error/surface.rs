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

    /// A wavelength is not the centre of a one-third octave band.
    "no-octave-band" NoOctaveBand {
        /// Which one.
        index: usize,
        /// It, in m.
        wavelength: f64,
    } Quantity::Heights, |name, words| format!(
        "{name}: wavelengths must be centres of one-third octave bands, 10^(k/10) m from 1e-7 to 100 m, \
         but one is {} m",
        readable(*wavelength)
    );

    /// A level of a one-third octave band is in a wrong unit, or none.
    "no-level" NoLevel {
        /// Which one.
        index: usize,
        /// It, in dB re 1 µm.
        level: f64,
        /// What levels may be.
        range: [f64; 2],
    } Quantity::Heights, |name, words| format!(
        "{name} must have levels from {} to {} dB re 1 µm, but one is {}",
        range[0],
        range[1],
        readable(*level)
    );

    /// A one-third octave band is given twice.
    "octave-band-twice" OctaveBandTwice {
        /// Which one.
        index: usize,
        /// Its wavelength, in m.
        wavelength: f64,
    } Quantity::Heights, |name, words| format!(
        "{name} must have every one-third octave band once, but that of {} m is given twice",
        readable(*wavelength)
    );

    /// A one-third octave band is missing between others.
    "octave-band-missing" OctaveBandMissing {
        /// The one after it.
        index: usize,
        /// The wavelength of that, in m.
        wavelength: f64,
        /// The longer one before it, in m.
        before: f64,
    } Quantity::Heights, |name, words| format!(
        "{name} must have all one-third octave bands from its longest to its shortest, but has none \
         between {} m and {} m",
        readable(*before),
        readable(*wavelength)
    );

    /// A lattice has no room for the waves of a line, or too large cells.
    "no-wave-fits" NoWaveFits {
        /// The longest and the shortest wave, in m.
        waves: [f64; 2],
        /// Side and two cells of the lattice, in m.
        lattice: [f64; 2],
    } Quantity::Heights, |name, words| format!(
        "{name}: none of its waves, {} to {} m, is on a surface with a side of {} m and two cells of {} m",
        readable(waves[1]),
        readable(waves[0]),
        readable(lattice[0]),
        readable(lattice[1])
    );

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
        /// The shortest wave that its cells resolve, in m.
        shortest: f64,
    } Quantity::Heights, |name, words| {
        let cause = if hardness.is_finite() {
            format!(
                "{} MPa flatten it with a hardness of {} MPa, or its heights are in another unit",
                readable(1e-6 * largest),
                readable(1e-6 * hardness)
            )
        } else {
            format!(
                "it lacks waves shorter than {} mm, is too smooth under these pressures, or its \
                 heights are in another unit",
                readable(1e3 * shortest)
            )
        };
        let pressure = readable(1e-6 * pressure);
        format!("{name} is in contact everywhere under {pressure} MPa: {cause}")
    };
}

impl std::error::Error for SurfaceError {}

impl From<SurfaceError> for Error {
    fn from(error: SurfaceError) -> Self {
        Self::Surface { error }
    }
}
