//! What can go wrong before and during a solution.

mod demand;
mod fit;
mod place;
mod surface;

use crate::message::{messages, with_unit};
use crate::quantity::Quantity;
use crate::requirement::{Requirement, readable};

pub(crate) use demand::{require, require_at, require_finite, require_positive, require_several};
pub use fit::{FitCause, FitError, FitStop};
pub use place::Place;
pub use surface::SurfaceError;

messages! {
    /// Why a problem cannot be solved as posed.
    ///
    /// A solution that was computed but did not converge is not an error: see
    /// [`Status`](crate::solution::Status).
    Error:

    /// A quantity has a value that the model does not allow.
    "invalid" Invalid {
        /// The quantity.
        quantity: Quantity,
        /// What it must be.
        requirement: Requirement,
        /// What it is, in the unit of the quantity.
        value: f64,
        /// Where.
        place: Place,
    } *quantity, |words| {
        let (name, unit) = (words.word(*quantity), quantity.unit());
        let requirement = requirement.text(unit, words);
        let value = format!("{} {unit}", readable(*value));
        format!("{name} must be {requirement}, but is {}{}", value.trim_end(), place.text())
    };

    /// The wheel does not roll forwards.
    "no-rolling" NoRolling {
        /// Longitudinal creepage, dimensionless.
        creepage_x: f64,
        /// Circumferential speed of the wheel, in m/s.
        rolling: f64,
    } Quantity::CreepageX, |words| format!(
        "{} must be smaller: the wheel must roll, with a positive circumferential speed, but \
         {creepage_x} is a {} wheel with a circumferential speed of {rolling} m/s",
        words.word(Quantity::CreepageX),
        if *rolling == 0.0 { "locked" } else { "reversed" }
    );

    /// Something that is wrong at a time of a history.
    "at-time" AtTime {
        /// What.
        error: Box<Error>,
        /// When, in s.
        time: f64,
    } over_time(error.quantity()), |words| {
        let history = words.word(over_time(error.quantity()));
        format!("{history}: at {time} s, {}", error.text(words))
    };

    /// Something is listed fewer times than needed.
    "too-few" TooFew {
        /// What.
        quantity: Quantity,
        /// How many are needed.
        fewest: usize,
        /// How many there are.
        count: usize,
    } *quantity, |words| {
        let name = words.word(*quantity);
        format!("{name} must have at least {fewest} entries, but has {count}")
    };

    /// A table has fewer positions than needed.
    "too-few-positions" TooFewPositions {
        /// The table.
        quantity: Quantity,
        /// Of what it has too few.
        axis: char,
        /// How many are needed.
        fewest: usize,
        /// How many there are.
        count: usize,
    } *quantity, |words| {
        let name = words.word(*quantity);
        format!("{name} must have at least {fewest} values of {axis}, but has {count}")
    };

    /// Another number of values than there are places for.
    "wrong-count" WrongCount {
        /// Of what.
        quantity: Quantity,
        /// How many are needed.
        expected: usize,
        /// How many there are.
        count: usize,
    } *quantity, |words| {
        let name = words.word(*quantity);
        format!("{name} must have {expected} values, but has {count}")
    };

    /// Numbers that must ascend do not.
    "not-ascending" NotAscending {
        /// The numbers, or the table that has them.
        quantity: Quantity,
        /// Which of them, if there are several; else empty.
        axis: &'static str,
        /// A number, in the unit of the quantity, or a position in m.
        before: f64,
        /// The one after it, in the same unit.
        after: f64,
    } *quantity, |words| {
        let unit = if axis.is_empty() { quantity.unit() } else { "m" };
        let [before, after] = [before, after].map(|value| with_unit(*value, unit));
        let name = words.word(*quantity);
        let of = if axis.is_empty() { String::new() } else { format!(" in {axis}") };
        format!("{name} must ascend strictly{of}, but {after} comes after {before}")
    };

    /// Positions of a table are not equidistant.
    "not-equidistant" NotEquidistant {
        /// Which.
        axis: char,
        /// A position, in m.
        position: f64,
        /// Where it was expected, in m.
        expected: f64,
    } Quantity::PressureTable, |words| format!(
        "{} must have ascending, equidistant positions {axis}, but has {position} m where {expected} m \
         was expected",
        words.word(Quantity::PressureTable)
    );

    /// The pressures of a table are not those of a contact.
    "table-peak" TablePeak {
        /// Largest pressure, in Pa.
        peak: f64,
        /// Least and largest that it may be, in Pa.
        range: [f64; 2],
    } Quantity::PressureTable, |words| format!(
        "{} must have a largest pressure between {:e} and {:e} Pa, but has {peak:e} Pa",
        words.word(Quantity::PressureTable),
        range[0],
        range[1]
    );

    /// A table of the pressure has no area.
    "no-area" NoArea {} Quantity::PressureTable, |words| {
        format!("{} must cover an area, but has none", words.word(Quantity::PressureTable))
    };

    /// More cells than can be solved for.
    "too-many-cells" TooManyCells {
        /// Cells along rolling.
        columns: usize,
        /// Cells across rolling.
        rows: usize,
        /// Most of them together.
        most: usize,
    } Quantity::CellsX, |words| format!(
        "{}: {columns} × {rows} cells are {}, more than {most}",
        words.word(Quantity::CellsX),
        *columns as u128 * *rows as u128
    );

    /// A reference point that the normal contact does not have.
    "no-origin" NoOrigin {} Quantity::Reference, |words| format!(
        "{}: \"file\" needs a normal contact from a file, but this one has none, and so no other \
         origin than the middle of the patch, \"patch\"",
        words.word(Quantity::Reference)
    );

    /// The motion at the middle of the patch is no rolling.
    "no-rolling-at-patch" NoRollingAtPatch {
        /// Where the reference point lies from the middle of the patch, x and y in m.
        place: [f64; 2],
        /// What is wrong there.
        error: Box<Error>,
    } Quantity::Reference, |words| format!(
        "{}: creepages at the middle of the patch, {:e} m and {:e} m from the origin of the file, \
         follow from those at the origin and from the spin: {}",
        words.word(Quantity::Reference),
        place[0],
        place[1],
        error.text(words)
    );

    /// A patch for which no layer was calibrated.
    "beyond-calibration" BeyondCalibration {
        /// a/b, dimensionless.
        axis_ratio: f64,
        /// Least and largest of the table, dimensionless.
        range: [f64; 2],
    } Quantity::Calibration, |words| format!(
        "{}: the patch has a/b = {axis_ratio:.4}, but the layer is calibrated for ratios between {} and \
         {}; give its stiffnesses, or take the half-space",
        words.word(Quantity::Calibration),
        range[0],
        range[1]
    );

    /// A layer with more cells than can be solved for.
    "layer-too-large" LayerTooLarge {
        /// Its margin, in m.
        margin: f64,
        /// Cells in one direction, dimensionless.
        cells: f64,
        /// Most of them, dimensionless.
        most: f64,
    } Quantity::Margin, |words| format!(
        "{}: a margin of {margin} m on this grid makes a layer of {cells} cells in one direction, more \
         than {most}",
        words.word(Quantity::Margin)
    );

    /// Two laws of a product with different cold coefficients.
    "unequal-friction" UnequalFriction {
        /// That of one, dimensionless.
        one: f64,
        /// That of the other, dimensionless.
        other: f64,
    } Quantity::FrictionCoefficient, |words| format!(
        "{}: both laws of a product must have the same μ0, but it is {one} of one and {other} of the \
         other",
        words.word(Quantity::FrictionCoefficient)
    );

    /// Friction has vanished before the material enters.
    "friction-vanishes" FrictionVanishes {
        /// Temperature of the entering material, in degC.
        entry: f64,
        /// Reference temperature, in degC.
        reference: f64,
        /// Rise at which friction vanishes, in K.
        limit: f64,
    } Quantity::ReferenceTemperature, |words| format!(
        "{}: the material enters the contact at {entry} degC, but friction vanishes {limit} K above the \
         reference temperature, at {reference} + {limit} = {} degC",
        words.word(Quantity::ReferenceTemperature),
        reference + limit
    );

    /// Friction that varies across rolling is not that of the law in the middle.
    "off-centre-factor" OffCentreFactor {
        /// The factor at y = 0, dimensionless.
        factor: f64,
    } Quantity::VariationFactor, |words| format!(
        "{}: the factor must be 1 at y = 0, where friction is {coefficient}, but is {factor} there: \
         divide all factors by it, and multiply {coefficient}",
        words.word(Quantity::VariationFactor),
        coefficient = words.word(Quantity::FrictionCoefficient)
    );

    /// The second term of friction is larger than what is left for it.
    "second-term" SecondTerm {
        /// Its size, dimensionless.
        second: f64,
        /// Coefficient of friction, dimensionless.
        coefficient: f64,
        /// Kinetic coefficient of friction, dimensionless.
        kinetic: f64,
    } Quantity::SecondCoefficient, |words| format!(
        "{} must be between 0 and {} - {} = {coefficient} - {kinetic}, but is {second}",
        words.word(Quantity::SecondCoefficient),
        words.word(Quantity::FrictionCoefficient),
        words.word(Quantity::KineticCoefficient)
    );

    /// A contact that is a line.
    "line-contact" LineContact {
        /// Sums of curvature along and across rolling, in 1/m.
        curvatures: [f64; 2],
        /// Largest ratio of both, dimensionless.
        most: f64,
    } flatter(curvatures), |words| format!(
        "{}: the curvature sums along and across rolling are {} and {} 1/m; a ratio beyond {most} is a \
         line contact, which has no elliptic patch",
        words.word(flatter(curvatures)),
        curvatures[0],
        curvatures[1]
    );

    /// Radii of two bodies that do not touch in a point.
    "curvature-sum" CurvatureSum {
        /// The radii of wheel and rail.
        radii: [Quantity; 2],
        /// The sum of curvatures, in 1/m.
        sum: f64,
    } radii[0], |words| {
        let [wheel, rail] = radii.map(|radius| words.word(radius));
        let is_along = radii[0] == Quantity::WheelRadiusX;
        let plane = if is_along { "along" } else { "across" };
        let requirement = if *sum == 0.0 {
            "is zero: a line contact, which has no elliptic patch; at least one radius must be finite"
                .to_owned()
        } else {
            format!("must be positive, but is {sum} 1/m")
        };
        format!("{wheel}: the sum of curvatures {plane} rolling ({wheel}, {rail}) {requirement}")
    };

    /// The contact reaches the edge of the distance that is given.
    "contact-at-edge" ContactAtEdge {
        /// Load, in N.
        load: f64,
        /// Which direction.
        axis: char,
        /// Position of the edge, in m.
        edge: f64,
    } Quantity::UndeformedDistance, |words| format!(
        "{}: under {load} N the contact reaches the edge of the distance that is given, at {axis} = \
         {:.6} mm: it must go on until the bodies are clear of each other (or its sign is wrong: it is \
         wheel minus rail, largest where they are farthest apart)",
        words.word(Quantity::UndeformedDistance),
        1e3 * edge
    );

    /// The normal contact was not found.
    "normal-contact-not-converged" NormalNotConverged {
        /// Iterations that were done.
        iterations: usize,
        /// Residual, dimensionless.
        residual: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } Quantity::UndeformedDistance, |words| format!(
        "{}: the normal contact does not converge: after {iterations} iterations its residual is \
         {residual:.1e}, above {tolerance:.1e}",
        words.word(Quantity::UndeformedDistance)
    );

    /// The place of the contact was not found.
    "contact-not-found" ContactNotFound {
        /// Rounds of the search.
        rounds: usize,
        /// Where the last one looked, x in m.
        x: [f64; 2],
        /// Where the last one looked, y in m.
        y: [f64; 2],
    } Quantity::UndeformedDistance, |words| format!(
        "{}: the contact was not found in {rounds} rounds; the last one looked at x = {:.6} to {:.6} \
         mm, y = {:.6} to {:.6} mm",
        words.word(Quantity::UndeformedDistance),
        x[0],
        x[1],
        y[0],
        y[1]
    );

    /// A load that leaves no pressure that numbers can hold.
    "no-pressure" NoPressure {
        /// Load, in N.
        load: f64,
        /// Semi-axes, in m.
        semi_axes: [f64; 2],
    } Quantity::Load, |words| format!(
        "{}: a load of {load:e} N on semi-axes of {:e} m and {:e} m leaves no pressure that a computer \
         can hold",
        words.word(Quantity::Load),
        semi_axes[0],
        semi_axes[1]
    );

    /// A rough surface that cannot be.
    "surface" Surface {
        /// Why.
        error: SurfaceError,
    } error.quantity(), |words| error.text(words);

    /// A bound of FASTSIM that a pressure does not have.
    "no-paraboloid" NoParaboloid {} Quantity::TractionBound, |words| format!(
        "{}: the pressure of a table or a profile has no paraboloid: it needs {}, with which it bounds \
         the traction itself",
        words.word(Quantity::TractionBound),
        words.choice(Quantity::TractionBound, "elliptic")
    );

    /// A history over which the wheel rolls too far.
    "history-too-long" HistoryTooLong {
        /// First and last time, in s.
        span: [f64; 2],
        /// Time steps that it would take, dimensionless.
        steps: f64,
        /// Most of them, dimensionless.
        most: f64,
    } Quantity::Time, |words| format!(
        "{}: from {:e} s to {:e} s the wheel rolls over up to {steps:.3e} cells, one a time step; at \
         most {most:e} are allowed, and time must resolve them",
        words.word(Quantity::Time),
        span[0],
        span[1]
    );

    /// A state to start from that cannot be.
    "impossible-state" ImpossibleState {} Quantity::InitialState, |words| format!(
        "{}: the state has an element outside the grid, two in one cell, one with more traction than \
         friction allows, or one whose slip speed, friction or heat cannot be",
        words.word(Quantity::InitialState)
    );

    /// A state to start from that was left on another grid.
    "state-of-another-grid" StateOfAnotherGrid {
        /// Columns and rows of its grid, and of that of the problem.
        cells: [[usize; 2]; 2],
        /// Size of the cells of both, in m.
        spacings: [[f64; 2]; 2],
    } Quantity::InitialState, |words| {
        let grid = |k: usize| {
            let ([columns, rows], [x, y]) = (cells[k], spacings[k]);
            format!("{columns} × {rows} cells of {x:e} × {y:e} m")
        };
        let name = words.word(Quantity::InitialState);
        let [left, here] = [grid(0), grid(1)];
        format!("{name}: the state was left on a grid of {left}, but this problem has {here}")
    };

    /// A history where rolling is steady.
    "not-steady" NotSteady {
        /// The history, or the initial state.
        quantity: Quantity,
        /// What is of steady rolling only.
        what: &'static str,
    } *quantity, |words| {
        let name = words.word(*quantity);
        let there = if *quantity == Quantity::InitialState { "an initial state" } else { "a history" };
        format!("{name}: {what} steady rolling, but there is {there}")
    };

    /// Whoever watched wanted no more of it.
    "stopped" Stopped {} Quantity::MaxIterations, |words| "stopped before the end".to_owned();

    /// A method that does not do what is asked for.
    "method" OtherMethod {
        /// What is needed of the method.
        reason: &'static str,
        /// Its name.
        method: &'static str,
    } Quantity::Method, |words| {
        format!("{}: {reason}, but the method is {method:?}", words.word(Quantity::Method))
    };

    /// No heat where something follows from it.
    "no-heat" NoHeat {} Quantity::HeatModel, |words| format!(
        "{}: the wheel warms by frictional heat only, but the heat model is \"none\"",
        words.word(Quantity::HeatModel)
    );

    /// A curve from a creepage to the same.
    "no-range" NoRange {
        /// The creepage.
        quantity: Quantity,
        /// Its value, in its unit if it has one.
        value: f64,
    } *quantity, |words| format!(
        "{} must be another at the end of a creep curve than at its start, as no other creepage varies, \
         but is {}",
        words.word(*quantity),
        with_unit(*value, quantity.unit())
    );

    /// A wheel that locks on a creep curve.
    "locks-on-curve" LocksOnCurve {
        /// The creepage that varies.
        quantity: Quantity,
        /// Where the wheel no longer rolls, in the unit of the creepage if it has one.
        value: f64,
    } quantity.own_component(), |words| format!(
        "{}: the wheel must roll throughout a creep curve, but at {} it does not",
        words.word(quantity.own_component()),
        quantity.equation(*value)
    );

    /// Motions of a calibration that were not solved.
    "calibration-not-converged" CalibrationNotConverged {
        /// a/b, dimensionless.
        axis_ratio: f64,
    } Quantity::Calibration, |words| format!(
        "{}: the motions of a/b = {axis_ratio} could not be solved",
        words.word(Quantity::Calibration)
    );

    /// Displacements for which no layer could be set up.
    "no-layer" NoLayer {} Quantity::SampleDisplacement, |words| format!(
        "{}: no layer could be set up on its grid",
        words.word(Quantity::SampleDisplacement)
    );

    /// Displacements against their load.
    "against-load" AgainstLoad {} Quantity::SampleDisplacement, |words| format!(
        "{}: the displacements run against their load: both are those of the wheel, the displacement \
         less that of the rail",
        words.word(Quantity::SampleDisplacement)
    );

    /// Displacements that no layer has.
    "unlike-a-layer" UnlikeALayer {
        /// Those along rolling, or across.
        quantity: Quantity,
        /// Deviation of the nearest layer, dimensionless.
        deviation: f64,
        /// Where they come from.
        sources: String,
    } *quantity, |words| format!(
        "{}: no elastic layer has the displacements of {sources}: the nearest is {:.0} % of them away; \
         check that tractions and displacements belong together, and their units",
        words.word(*quantity),
        100.0 * deviation
    );

    /// Data and parameters that do not go together.
    "fit" Fit {
        /// Why.
        error: FitError,
    } error.quantity(), |words| error.text(words);
}

impl std::error::Error for Error {}

impl From<SurfaceError> for Error {
    fn from(error: SurfaceError) -> Self {
        Self::Surface { error }
    }
}

impl From<FitError> for Error {
    fn from(error: FitError) -> Self {
        Self::Fit { error }
    }
}

impl Error {
    /// Whether the input may be right, but what follows from it was not found.
    pub fn is_of_convergence(&self) -> bool {
        matches!(self, Self::NormalNotConverged { .. } | Self::ContactNotFound { .. })
    }
}

/// The radius of the wheel in the direction in which the bodies are flatter.
fn flatter(curvatures: &[f64; 2]) -> Quantity {
    if curvatures[0] > curvatures[1] { Quantity::WheelRadiusY } else { Quantity::WheelRadiusX }
}

/// The history of a quantity.
fn over_time(quantity: Quantity) -> Quantity {
    match quantity {
        Quantity::Speed => Quantity::HistorySpeed,
        Quantity::CreepageY => Quantity::HistoryCreepageY,
        Quantity::Spin => Quantity::HistorySpin,
        _ => Quantity::HistoryCreepageX,
    }
}
