//! What can be wrong with a rough surface.

use crate::message::messages;
use crate::quantity::Quantity;
use crate::requirement::readable;

messages! {
    /// Why heights are no rough surface, or none that can be solved for.
    SurfaceError:

    /// A load that the hardness cannot carry.
    "beyond-hardness" BeyondHardness {
        /// The load, in N.
        load: f64,
        /// What the hardness can carry, in N.
        largest: f64,
    } Quantity::Load, |words| format!(
        "{} must be positive and below what the hardness can carry, {largest} N, but is {load} N",
        words.word(Quantity::Load)
    );

    /// Waves that are too short for the cells.
    "short-waves" ShortWaves {
        /// Shortest wavelength, in m.
        shortest: f64,
        /// Two cells, in m.
        two_cells: f64,
    } Quantity::ShortestWavelength, |words| format!(
        "{} must be at least two cells, {} m, but is {} m",
        words.word(Quantity::ShortestWavelength),
        readable(*two_cells),
        readable(*shortest)
    );

    /// A surface with too many holes.
    "too-many-holes" TooManyHoles {
        /// Points without a height.
        holes: usize,
        /// All points.
        count: usize,
    } Quantity::Heights, |words| format!(
        "{}: at most half of the points may be holes, but {holes} of {count} are",
        words.word(Quantity::Heights)
    );

    /// Holes that were not filled.
    "holes-not-filled" HolesNotFilled {
        /// Iterations that were done.
        iterations: usize,
    } Quantity::Heights, |words| format!(
        "{}: the holes are not filled after {iterations} iterations",
        words.word(Quantity::Heights)
    );

    /// A surface or a profile that is flat.
    "flat" Flat {
        /// The height everywhere (in m); `None` of a profile on a straight line.
        height: Option<f64>,
    } Quantity::Heights, |words| {
        let name = words.word(Quantity::Heights);
        match height {
            Some(height) => format!("{name} must not be flat, but every height is {height} m"),
            None => format!("{name} must not be flat, but its points lie on a straight line"),
        }
    };

    /// Two surfaces on different lattices.
    "lattices-differ" LatticesDiffer {
        /// Columns and rows of both.
        cells: [[usize; 2]; 2],
        /// Distances of their points, in m.
        spacings: [[f64; 2]; 2],
    } Quantity::Heights, |words| {
        let lattice = |k: usize| {
            let ([columns, rows], [x, y]) = (cells[k], spacings[k]);
            format!("{columns} x {rows} cells of {x} m x {y} m")
        };
        let [one, other] = [lattice(0), lattice(1)];
        let name = words.word(Quantity::Heights);
        format!("{name}: two surfaces must have the same lattice, but have {one} and {other}")
    };

    /// A form that a surface does not have.
    "no-form" NoForm {
        /// Its name.
        form: &'static str,
    } Quantity::Form, |words| {
        format!("{}: no {form} fits the surface", words.word(Quantity::Form))
    };

    /// Approach and pressure that do not grow together.
    "load-curve" LoadCurve {
        /// Points of the curve.
        points: usize,
    } Quantity::Heights, |words| format!(
        "{}: approach and mean pressure must be positive and grow over at least three points, but do \
         not over {points} points",
        words.word(Quantity::Heights)
    );

    /// A surface that is in contact everywhere.
    "full-contact" FullContact {
        /// Mean pressure from which on it is, in Pa.
        pressure: f64,
        /// Largest mean pressure, in Pa.
        largest: f64,
        /// Hardness, in Pa; infinite for elastic bodies.
        hardness: f64,
    } Quantity::Heights, |words| {
        let cause = if hardness.is_finite() {
            format!(
                "{:.4} MPa flatten it with a hardness of {:.4} MPa, or its heights are in another unit",
                1e-6 * largest,
                1e-6 * hardness
            )
        } else {
            "it is too smooth for that, the pressures are too large, or its heights are in another unit"
                .to_owned()
        };
        let name = words.word(Quantity::Heights);
        let pressure = 1e-6 * pressure;
        format!("{name}: all of the surface is in contact under {pressure:.4} MPa: {cause}")
    };
}

impl std::error::Error for SurfaceError {}
