//! What can go wrong before and during a solution.

mod calibration;
mod curve;
mod place;
mod demand;
mod fit;
mod force;
mod over_time;
mod purpose;
mod state;
mod surface;
mod wheel_rail;
mod convergence;

use crate::reporting::{Quantity, Requirement, messages, readable};

pub(crate) use demand::{require, require_at, require_finite, require_positive, require_several};
use over_time::{OverTime, over_time};

pub use calibration::CalibrationError;
pub use curve::CurveError;
pub use fit::{FitCause, FitError, FitStop};
pub use force::ForceError;
pub use place::Place;
pub use purpose::MethodPurpose;
pub use state::StateError;
pub use surface::SurfaceError;
pub use wheel_rail::WheelRailError;

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
    } *quantity, |name, words| {
        let unit = quantity.unit();
        let rounded = readable(*value);
        let is_misleading = rounded.parse().is_ok_and(|rounded| requirement.holds(rounded));
        let value = if is_misleading { value.to_string() } else { rounded };
        let value = format!("{value} {unit}");
        let requirement = requirement.text(unit, words);
        format!("{name} must be {requirement}, but is {}{}", value.trim_end(), place.text())
    };

    /// The wheel is locked or reversed.
    "no-rolling" NoRolling {
        /// Longitudinal creepage, dimensionless.
        creepage_x: f64,
        /// That at which the wheel locks, dimensionless.
        limit: f64,
        /// Circumferential speed of the wheel, in m/s.
        rolling: f64,
    } Quantity::CreepageX, |name, words| format!(
        "{name} must be below {}, at which the wheel locks, but is {creepage_x}: a {} wheel with a \
         circumferential speed of {} m/s",
        readable(*limit),
        if *rolling == 0.0 { "locked" } else { "reversed" },
        readable(*rolling)
    );

    /// Something that is wrong at a time of a history.
    "at-time" [error] AtTime {
        /// What.
        error: Box<Error>,
        /// When, in s.
        time: f64,
    } over_time(error.quantity()), |name, words| {
        format!("at {} s, {}", readable(*time), error.text(&OverTime(words)))
    };

    /// A list has fewer entries than needed.
    "too-few" TooFew {
        /// What.
        quantity: Quantity,
        /// How many are needed.
        fewest: usize,
        /// How many there are.
        count: usize,
    } *quantity, |name, words| {
        let entries = if *fewest == 1 { "entry" } else { "entries" };
        format!("{name} needs at least {fewest} {entries}, got {count}")
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
    } *quantity, |name, words| {
        format!("{name} needs at least {fewest} values of {axis}, got {count}")
    };

    /// The number of values does not match the number of positions.
    "wrong-count" WrongCount {
        /// Of what.
        quantity: Quantity,
        /// How many are needed.
        expected: usize,
        /// How many there are.
        count: usize,
    } *quantity, |name, words| {
        format!("{name} needs {expected} values, got {count}")
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
    } *quantity, |name, words| {
        let unit = if axis.is_empty() { quantity.unit() } else { "m" };
        let [before, after] = [before, after].map(|value| format!("{value} {unit}"));
        let (before, after) = (before.trim_end(), after.trim_end());
        let of = if axis.is_empty() { String::new() } else { format!(" in {axis}") };
        let strictly = if *quantity == Quantity::Time { "" } else { " strictly" };
        format!("{name} must ascend{strictly}{of}, but {after} comes after {before}")
    };

    /// A shift where the wheel rolls.
    "shift-in-rolling" ShiftInRolling {
        /// The shift.
        quantity: Quantity,
        /// Until when the wheel rolls, in s.
        time: f64,
    } *quantity, |name, words| format!(
        "{name}: the wheel rolls until {} s; a shift needs a row of its own with the same time as \
         the row before",
        readable(*time)
    );

    /// The positions of a table are not equidistant.
    "not-equidistant" NotEquidistant {
        /// Which.
        axis: char,
        /// The two between which the step is farthest from the mean, in m.
        step: [f64; 2],
        /// The mean step, in m.
        spacing: f64,
    } Quantity::PressureTable, |name, words| format!(
        "{name} must have ascending, equidistant positions {axis}, but the step from {} m to {} m \
         differs from the mean of {} m",
        step[0],
        step[1],
        readable(*spacing)
    );

    /// The largest pressure of a table is not that of a contact.
    "table-peak" TablePeak {
        /// Largest pressure, in Pa.
        peak: f64,
        /// Least and largest that it may be, in Pa.
        range: [f64; 2],
    } Quantity::PressureTable, |name, words| format!(
        "{name} must have a largest pressure between {} and {} Pa, but has {} Pa",
        readable(range[0]),
        readable(range[1]),
        readable(*peak)
    );

    /// A pressure table covers no area.
    "no-area" NoArea {} Quantity::PressureTable, |name, words| {
        format!("{name} must cover an area, but has none")
    };

    /// The grid has more cells than can be solved for.
    "too-many-cells" TooManyCells {
        /// Cells along rolling.
        columns: usize,
        /// Cells across rolling.
        rows: usize,
        /// Most of them together.
        most: usize,
    } Quantity::CellsX, |name, words| format!(
        "{name}: {columns} × {rows} cells are {}, more than {most}",
        *columns as u128 * *rows as u128
    );

    /// The normal contact does not have this reference point.
    "no-origin" NoOrigin {} Quantity::Reference, |name, words| {
        let [file, patch] = ["file", "patch"].map(|point| words.choice(Quantity::Reference, point));
        format!(
            "{file} needs a normal contact read from a file; the only reference point of this one is \
             the middle of the patch, {patch}"
        )
    };

    /// Prescribed forces that cannot be.
    "force" [error: ForceError] Force {
        /// Why.
        error: ForceError,
    } error.quantity(), |name, words| error.text(words);

    /// The motion at the middle of the patch is no rolling.
    "no-rolling-at-patch" [error] NoRollingAtPatch {
        /// Where the reference point lies from the middle of the patch, x and y in m.
        place: [f64; 2],
        /// What is wrong there.
        error: Box<Error>,
    } Quantity::Reference, |name, words| format!(
        "{name}: creepages at the middle of the patch, {} m and {} m from the origin of the file, \
         follow from those at the origin and from the spin: {}",
        readable(place[0]),
        readable(place[1]),
        error.text(words)
    );

    /// No layer is calibrated for the axis ratio of the patch.
    "beyond-calibration" BeyondCalibration {
        /// a/b, dimensionless.
        axis_ratio: f64,
        /// Least and largest of the table, dimensionless.
        range: [f64; 2],
    } Quantity::Calibration, |name, words| format!(
        "{name}: the patch has a/b = {axis_ratio:.4}, but the layer is calibrated for ratios between \
         {} and {}; give its stiffnesses, or choose {}",
        range[0],
        range[1],
        words.choice(Quantity::Elasticity, "half-space")
    );

    /// The margin makes the layer larger than can be solved for.
    "layer-too-large" LayerTooLarge {
        /// Its margin, in m.
        margin: f64,
        /// Cells in one direction, dimensionless.
        cells: f64,
        /// Most of them, dimensionless.
        most: f64,
    } Quantity::Margin, |name, words| format!(
        "{name}: a margin of {} m on this grid makes a layer of {} cells in one direction, more than \
         {most}",
        readable(*margin),
        readable(*cells)
    );

    /// Two laws of a product have different cold coefficients.
    "unequal-friction" UnequalFriction {
        /// That of one, dimensionless.
        one: f64,
        /// That of the other, dimensionless.
        other: f64,
    } Quantity::FrictionCoefficient, |name, words| format!(
        "{name}: both laws of a product must have the same μ0, but one has {one} and the other {other}"
    );

    /// Friction has vanished before material enters.
    "friction-vanishes" FrictionVanishes {
        /// Temperature of the entering material, in degC.
        entry: f64,
        /// Reference temperature, in degC.
        reference: f64,
        /// Rise at which friction vanishes, in K.
        limit: f64,
    } Quantity::ReferenceTemperature, |name, words| format!(
        "{name}: the material enters the contact at {} degC, but friction vanishes {} K above the \
         reference temperature of {} degC, at {} degC",
        readable(*entry),
        readable(*limit),
        readable(*reference),
        readable(reference + limit)
    );

    /// The lateral factor of friction is not 1 at y = 0.
    "off-centre-factor" OffCentreFactor {
        /// What the factors are over.
        over: Quantity,
        /// The factor where it is zero, dimensionless.
        factor: f64,
    } Quantity::VariationFactor, |name, words| {
        let coefficient = words.word(Quantity::FrictionCoefficient);
        let over = over.symbol();
        format!(
            "{name}: the factor must be 1 at {over} = 0, where friction is {coefficient}, but is \
             {factor} there: divide all factors by it, and multiply {coefficient} by it"
        )
    };

    /// The second friction term is larger than the total decrease of friction.
    "second-term" SecondTerm {
        /// Its size, dimensionless.
        second: f64,
        /// Coefficient of friction, dimensionless.
        coefficient: f64,
        /// Kinetic coefficient of friction, dimensionless.
        kinetic: f64,
    } Quantity::SecondCoefficient, |name, words| format!(
        "{name} must be between 0 and {} - {} = {coefficient} - {kinetic}, but is {second}",
        words.word(Quantity::FrictionCoefficient),
        words.word(Quantity::KineticCoefficient)
    );

    /// The contact is too slender for an elliptic patch.
    "line-contact" LineContact {
        /// Sums of curvature along and across rolling, in 1/m.
        curvatures: [f64; 2],
        /// Largest ratio of both, dimensionless.
        most: f64,
    } flatter(curvatures), |name, words| format!(
        "{name}: the curvature sums along and across rolling are {} and {} 1/m; beyond a ratio of \
         {most} the contact is a line, without an elliptic patch",
        readable(curvatures[0]),
        readable(curvatures[1])
    );

    /// The bodies do not touch in a point.
    "curvature-sum" CurvatureSum {
        /// The radii of wheel and rail.
        radii: [Quantity; 2],
        /// The sum of curvatures, in 1/m.
        sum: f64,
    } radii[0], |name, words| {
        let [wheel, rail] = radii.map(|radius| words.word(radius));
        let is_along = radii[0] == Quantity::WheelRadiusX;
        let plane = if is_along { "along" } else { "across" };
        let requirement = if *sum == 0.0 {
            "is zero, a line contact without an elliptic patch; at least one radius must be finite"
                .to_owned()
        } else {
            format!("must be positive, but is {} 1/m", readable(*sum))
        };
        format!("{wheel}: the sum of curvatures {plane} rolling ({wheel}, {rail}) {requirement}")
    };

    /// The contact reaches the edge of the given distance.
    "contact-at-edge" ContactAtEdge {
        /// Load, in N.
        load: f64,
        /// Which direction.
        axis: char,
        /// Position of the edge, in m.
        edge: f64,
    } Quantity::UndeformedDistance, |name, words| format!(
        "{name}: under {} N the contact reaches the edge of the given distance, at {axis} = {:.6} mm: \
         the distance must extend until the bodies are clear of each other (or its sign is wrong: it \
         is wheel minus rail, largest where they are farthest apart)",
        readable(*load),
        1e3 * edge
    );

    /// The normal contact was not found.
    "normal-contact-not-converged" NormalNotConverged {
        /// What it follows from.
        quantity: Quantity,
        /// Iterations that were done.
        iterations: usize,
        /// Residual, dimensionless.
        residual: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } *quantity, |name, words| format!(
        "{name}: the normal contact does not converge: after {iterations} iterations its residual is \
         {residual:.1e}, above {tolerance:.1e}"
    );

    /// The contact could not be located.
    "contact-not-found" ContactNotFound {
        /// Rounds of the search.
        rounds: usize,
        /// Where the last one looked, x in m.
        x: [f64; 2],
        /// Where the last one looked, y in m.
        y: [f64; 2],
    } Quantity::UndeformedDistance, |name, words| format!(
        "{name}: the contact was not found in {rounds} rounds; the last one searched x = {:.6} to \
         {:.6} mm, y = {:.6} to {:.6} mm",
        1e3 * x[0],
        1e3 * x[1],
        1e3 * y[0],
        1e3 * y[1]
    );

    /// The pressure is beyond the range of floating-point numbers.
    "no-pressure" NoPressure {
        /// Load, in N.
        load: f64,
        /// Semi-axes, in m.
        semi_axes: [f64; 2],
    } Quantity::Load, |name, words| format!(
        "{name}: a load of {} N on semi-axes of {} m and {} m gives a pressure beyond the range of \
         floating-point numbers",
        readable(*load),
        readable(semi_axes[0]),
        readable(semi_axes[1])
    );

    /// A rough surface that cannot be.
    "surface" [error: SurfaceError] Surface {
        /// Why.
        error: SurfaceError,
    } error.quantity(), |name, words| error.text(words);

    /// The pressure has no paraboloid to bound the traction of FASTSIM.
    "no-paraboloid" NoParaboloid {} Quantity::TractionBound, |name, words| format!(
        "{name}: the pressure of a table or a profile, or that on a layer that flows, is no \
         paraboloid; choose {}, where the pressure itself bounds the traction",
        words.choice(Quantity::TractionBound, "elliptic")
    );

    /// Viscoelastic bodies other than in steady rolling at the speed of a problem.
    "viscoelastic-unsteady" ViscoelasticUnsteady {} Quantity::Elasticity, |name, words| format!(
        "{name}: viscoelastic bodies roll steadily only; choose {} for a history or a force element",
        words.choice(Quantity::Elasticity, "half-space")
    );

    /// Viscoelastic bodies with a fast method.
    "viscoelastic-fast-method" ViscoelasticFastMethod {} Quantity::Method, |name, words| format!(
        "{name}: the fast methods are for elastic bodies; choose {}, or {} of the bodies",
        words.choice(Quantity::Method, "full"),
        words.choice(Quantity::Elasticity, "half-space")
    );

    /// A line contact where an ellipse is assumed.
    "line-is-no-ellipse" LineIsNoEllipse {
        /// The method or the elasticity that assumes it.
        assumed_by: Quantity,
    } *assumed_by, |name, words| {
        let other = match assumed_by {
            Quantity::Method => "full",
            _ => "half-space",
        };
        format!(
            "{name} must not be one that assumes an elliptic patch, as the contact is a line; choose {}",
            words.choice(*assumed_by, other)
        )
    };

    /// Coulomb's law leaves tractions of rigid bodies undetermined.
    "coulomb-of-rigid-bodies" CoulombOfRigidBodies {} Quantity::Elasticity, |name, words| format!(
        "{name}: with Coulomb's law ({}) the bodies must be elastic, because nothing else determines \
         the traction where they stick",
        words.word(Quantity::ContactLaw)
    );

    /// Cells are too much wider than long.
    "too-few-across" TooFewAcross {
        /// How many cells are needed across rolling.
        fewest: usize,
        /// How many there are along rolling.
        columns: usize,
        /// How many there are across.
        count: usize,
    } Quantity::CellsY, |name, words| format!(
        "{name} must be at least {fewest} for {columns} cells along rolling on this patch, but is \
         {count}: cells must not be much wider than long where the edge of the patch runs through \
         many of them; take more across or fewer along"
    );

    /// Look-up tables hold for surfaces without a layer between them.
    "layer-with-table" LayerWithTable {} Quantity::LookUpTable, |name, words| format!(
        "{name}: a look-up table holds for surfaces without a layer between them; choose another {} \
         or leave out {}",
        words.word(Quantity::Method),
        words.word(Quantity::LayerThickness)
    );

    /// A force element needs a patch that keeps its shape under any load.
    "shape-of-element" ShapeOfElement {} Quantity::Load, |name, words| {
        format!("{name}: the patch of a force element must keep its shape under any load")
    };

    /// A force element by approach needs bodies of given radii.
    "approach-of-element" ApproachOfElement {} Quantity::Approach, |name, words| {
        "the normal contact has no approach that a force element could take as an input: the bodies \
         must have given radii"
            .to_owned()
    };

    /// The history takes more time steps than allowed.
    "history-too-long" HistoryTooLong {
        /// First and last time, in s.
        span: [f64; 2],
        /// Time steps that it would take, dimensionless.
        steps: f64,
        /// Most of them, dimensionless.
        most: f64,
    } Quantity::Time, |name, words| format!(
        "{name}: from {} s to {} s the wheel rolls over up to {} cells, one per time step; at most {} \
         are allowed, and no time step may be lost in rounding",
        readable(span[0]),
        readable(span[1]),
        readable(*steps),
        readable(*most)
    );

    /// A part of the history in which the wheel rolls has no time step, which takes a cell.
    "part-too-short" PartTooShort {
        /// First and last time of the part, in s.
        span: [f64; 2],
        /// Time in which the wheel rolls over a cell, in s.
        step: f64,
        /// Number of cells along rolling with which that is one step at least.
        cells: usize,
    } Quantity::Time, |name, words| format!(
        "{name}: no time step ends from {} s to {} s, since the wheel rolls over a cell in {} s: {} \
         must be at least {cells}",
        readable(span[0]),
        readable(span[1]),
        readable(*step),
        words.word(Quantity::CellsX)
    );

    /// A march cannot go on from a state.
    "state" [error: StateError] State {
        /// Why.
        error: StateError,
    } error.quantity(), |name, words| error.text(words);

    /// The caller stopped the computation.
    "stopped" Stopped {} Quantity::MaxIterations, |name, words| "stopped before the end".to_owned();

    /// Temperatures are needed, which the method does not compute.
    "method" OtherMethod {
        /// For what.
        purpose: MethodPurpose,
        /// The method.
        method: &'static str,
    } Quantity::Method, |name, words| {
        format!("{name}: {}; {method:?} has none", purpose.text())
    };

    /// Heat is needed, but there is no heat model.
    "no-heat" NoHeat {} Quantity::HeatModel, |name, words| format!(
        "{name}: the wheel is heated by friction only, but {}",
        words.choice(Quantity::HeatModel, "none")
    );

    /// A creep curve that cannot be computed.
    "curve" [error: CurveError] Curve {
        /// Why.
        error: CurveError,
    } error.quantity(), |name, words| error.text(words);

    /// A layer that cannot be calibrated.
    "calibration" [error: CalibrationError] Calibration {
        /// Why.
        error: CalibrationError,
    } error.quantity(), |name, words| error.text(words);

    /// Data and parameters that do not go together.
    "fit" [error: FitError] Fit {
        /// Why.
        error: FitError,
    } error.quantity(), |name, words| error.text(words);

    /// A wheel and a rail that cannot be solved for.
    "wheel-rail" [error: WheelRailError] WheelRail {
        /// Why.
        error: WheelRailError,
    } error.quantity(), |name, words| error.text(words);
}

impl std::error::Error for Error {}

/// The radius of the wheel in the direction in which the bodies are flatter.
fn flatter(curvatures: &[f64; 2]) -> Quantity {
    if curvatures[0] > curvatures[1] { Quantity::WheelRadiusY } else { Quantity::WheelRadiusX }
}
