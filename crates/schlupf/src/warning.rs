//! Whatever the reader of numbers must know.

use crate::error::FitStop;
use crate::message::messages;
use crate::quantity::Quantity;

messages! {
    /// A warning.
    Warning:

    /// The results did not converge.
    "not-converged" NotConverged {
        /// Why.
        cause: Unconverged,
    } cause.quantity(), |words| cause.text(words);

    /// The steady state was marched to.
    "marched" Marched {
        /// Residual at which Newton's method stopped, dimensionless.
        residual: f64,
        /// Newton steps that were done.
        newton_steps: usize,
    } Quantity::Driver, |words| format!(
        "the steady equilibrium was not found at once (residual {residual:.1e} after {newton_steps} \
         Newton steps); this is the end of a march, without derivatives"
    );

    /// There are several steady states.
    "several-states" SeveralStates {
        /// From where this one is reached.
        branch: &'static str,
        /// Its tangential force, in N.
        force: [f64; 2],
        /// From where the other one is reached.
        other_branch: &'static str,
        /// The tangential force of that, in N.
        other_force: [f64; 2],
    } Quantity::Branch, |words| format!(
        "friction falls so fast that there are several steady states: this one is reached from {branch} \
         slip, with Fx = {:.6e} N and Fy = {:.6e} N; from {other_branch} slip they are {:.6e} N and \
         {:.6e} N",
        force[0], force[1], other_force[0], other_force[1]
    );

    /// There may be several steady states.
    "branch-lost" BranchLost {} Quantity::Branch, |words| {
        "friction falls so fast that there may be several steady states; they could not be followed \
         along the creepage, so it is open which one this is"
            .to_owned()
    };

    /// Derivatives were not found.
    "no-sensitivity" NoSensitivity {} Quantity::Sensitivities, |words| format!(
        "{}: a linear system at the solution was not solved; the derivatives are left out",
        words.word(Quantity::Sensitivities)
    );

    /// A pressure that no body stands elastically.
    "beyond-elastic" BeyondElastic {
        /// Largest pressure, in Pa.
        pressure: f64,
        /// Contact modulus, in Pa.
        modulus: f64,
    } Quantity::PeakPressure, |words| format!(
        "{}: the largest pressure is {:.0} MPa, {:.1} % of the contact modulus, and steel has \
         yielded before 2.5 %: are load and shape in their right units?",
        words.word(Quantity::PeakPressure),
        1e-6 * pressure,
        1e2 * pressure / modulus
    );

    /// Surroundings of the layer that are too small.
    "small-margin" SmallMargin {
        /// Displacement at their outer edge over the largest one, dimensionless.
        edge: f64,
    } Quantity::Margin, |words| format!(
        "{}: the displacement at the outer edge of the layer is {:.1} % of the largest; a larger margin \
         is needed where that exceeds 1 %",
        words.word(Quantity::Margin),
        100.0 * edge
    );

    /// Power that the bristles return.
    "returned-power" ReturnedPower {
        /// That power, in W.
        returned: f64,
        /// Friction power, in W.
        friction: f64,
    } Quantity::ContactStiffness, |words| format!(
        "{}: the bristles return {returned:.3e} W of {friction:.3e} W friction power; that part \
         is cut off and does not cool. Where it is large in steady rolling, the grid is too coarse for \
         the contact law",
        words.word(Quantity::ContactStiffness)
    );

    /// Bodies whose pressure displaces their surfaces tangentially against each other.
    "dissimilar-bodies" DissimilarBodies {
        /// Dundurs' or Kalker's constant K, dimensionless.
        constant: f64,
    } Quantity::Elasticity, |words| format!(
        "{}: wheel and rail differ in their elastic constants (K = {constant:.3}); the tangential \
         displacement under the normal pressure is neglected",
        words.word(Quantity::Elasticity)
    );

    /// A calibrated layer for a patch of several parts.
    "layer-of-parts" LayerOfParts {
        /// How many.
        parts: usize,
    } Quantity::Calibration, |words| format!(
        "{}: the layer is calibrated for one elliptic patch; for the {parts} separate parts of this one \
         it takes the ellipse of their common extent, which is too soft; {} needs no calibration",
        words.word(Quantity::Calibration),
        words.choice(Quantity::Elasticity, "half-space")
    );

    /// A patch that a calibration takes for an ellipse.
    "taken-for-an-ellipse" TakenForAnEllipse {} Quantity::Calibration, |words| {
        "the patch is treated like the ellipse with the same extent".to_owned()
    };

    /// A distance of the bodies of few points.
    "coarse-distance" CoarseDistance {
        /// Points across the patch.
        points: usize,
        /// Parts of the patch.
        parts: usize,
        /// Points that each part needs.
        fewest: usize,
    } Quantity::UndeformedDistance, |words| format!(
        "{}: number of points of the distance across the patch: {points}. Its shape between them is a \
         guess; give {fewest} or more for each part (there {})",
        words.word(Quantity::UndeformedDistance),
        if *parts == 1 { "is 1".to_owned() } else { format!("are {parts}") }
    );

    /// Rolling so slowly that heat also flows along the surface.
    "slow-rolling" SlowRolling {
        /// Péclet numbers of wheel and rail, dimensionless.
        peclet: [f64; 2],
        /// Whether the patch is narrower than long, so that heat flows sideways, too.
        is_narrow: bool,
        /// Whether it is about temperatures below the surface and in the wake.
        is_field: bool,
    } Quantity::HeatModel, |words| {
        let what = if *is_field {
            "Temperatures below the surface and in the wake, unlike those in the contact,".to_owned()
        } else {
            format!(
                "Temperatures of all but steady rolling with {}, {} and {}",
                words.choice(Quantity::Method, "full"),
                words.choice(Quantity::Driver, "steady"),
                words.choice(Quantity::HeatModel, "duhamel")
            )
        };
        format!(
            "{}: the Péclet numbers v a/κ are {:.3e} (wheel) and {:.3e} (rail). {what} assume conduction \
             perpendicular to the surface only, which is too hot by about 1 % at a Péclet number of \
             100, by 10 % at 10 and without bound below{}",
            words.word(Quantity::HeatModel),
            peclet[0],
            peclet[1],
            if *is_narrow { " (less on a narrower patch)" } else { "" }
        )
    };

    /// A surface so hot that constants of material do not hold.
    "hot-surface" HotSurface {
        /// `wheel` or `rail`.
        body: &'static str,
        /// Largest temperature of its surface, in degC.
        temperature: f64,
        /// What happens there.
        limit: HeatLimit,
    } if *body == "wheel" { Quantity::WheelTemperature } else { Quantity::RailTemperature },
    |words| format!(
        "{}: the surface of the {body} reaches {temperature:.0} degC, {}: constants of material, \
         elasticity and friction do not hold there",
        words.word(Quantity::HeatModel),
        limit.text()
    );

    /// Temperatures below the surface by another heat model than in the cells.
    "heat-model-of-cells" HeatModelOfCells {} Quantity::HeatModel, |words| format!(
        "{}: below the surface and in the wake temperatures follow from the heat that is released, by \
         Duhamel's theorem; the heat model of the case holds for the cells only",
        words.word(Quantity::HeatModel)
    );

    /// Kalker's coefficients beyond their table.
    "slender-patch" SlenderPatch {
        /// The method.
        method: &'static str,
        /// a/b, dimensionless.
        axis_ratio: f64,
    } Quantity::Method, |words| format!(
        "{}: {method:?} takes Kalker's coefficients beyond their table, a/b = {axis_ratio:.4} where it \
         spans 1/10 to 10, from Kalker's limits: C11, C22 and C23 are off by up to 7 % at 1/30 and 30, \
         C33 is a limit only",
        words.word(Quantity::Method)
    );

    /// A patch that is no ellipse but counts as one.
    "counts-as-ellipse" CountsAsEllipse {
        /// The method.
        method: &'static str,
        /// Separate parts of the patch.
        parts: usize,
    } Quantity::Method, |words| {
        let apart = if *parts > 1 {
            format!(
                "; here that ellipse spans {parts} separate parts, and the gaps between them count as \
                 contact"
            )
        } else {
            String::new()
        };
        format!(
            "{}: {method:?} takes Kalker's coefficients of the ellipse with the length and width of the \
             patch{apart}",
            words.word(Quantity::Method)
        )
    };

    /// A method without memory of friction.
    "no-memory" NoMemory {
        /// The method.
        method: &'static str,
    } Quantity::MemoryDistance, |words| format!(
        "{}: {method:?} knows no memory; friction follows its law at once",
        words.word(Quantity::MemoryDistance)
    );

    /// A method without fields.
    "forces-only" ForcesOnly {
        /// The method.
        method: &'static str,
        /// Whether it gives the moment.
        has_moment: bool,
    } Quantity::Method, |words| format!(
        "{}: {method:?} gives {} only, no fields and no temperatures",
        words.word(Quantity::Method),
        if *has_moment { "forces and moment" } else { "forces" }
    );

    /// A method without temperatures where friction depends on them.
    "cold-friction" ColdFriction {
        /// The method.
        method: &'static str,
    } Quantity::FrictionModel, |words| format!(
        "{}: {method:?} knows no temperatures, so friction is that of material as warm as it enters",
        words.word(Quantity::FrictionModel)
    );

    /// A force above the friction limit.
    "beyond-friction" BeyondFriction {
        /// The method.
        method: &'static str,
        /// The force over the limit, dimensionless.
        ratio: f64,
    } Quantity::Method, |words| format!(
        "{}: the force of {method:?} is {ratio:.3} times the friction limit μN, and not to be trusted: \
         the method does not cut it off",
        words.word(Quantity::Method)
    );

    /// A balance of power that is not closed.
    "power-gap" PowerGap {
        /// Friction power, in W.
        friction: f64,
        /// Creep power, in W.
        creep: f64,
        /// Part by which they differ at least, dimensionless.
        part: f64,
    } Quantity::Method, |words| format!(
        "{}: the friction power of FASTSIM, {friction:.4e} W, differs from the creep power, {creep:.4e} \
         W, by more than {} %: temperatures are uncertain by as much",
        words.word(Quantity::Method),
        100.0 * part
    );

    /// A creep curve without the slope at its origin.
    "no-initial-slope" NoInitialSlope {
        /// What the curve is drawn over.
        abscissa: Quantity,
    } *abscissa, |words| format!(
        "no initial slope: the derivatives at {} = 0 were not found",
        abscissa.name()
    );

    /// Fitted parameters that go together.
    "correlated" Correlated {
        /// One.
        one: Quantity,
        /// The other.
        other: Quantity,
        /// Their correlation, dimensionless.
        correlation: f64,
    } *one, |words| format!(
        "{} and {} go together (correlation {correlation:.3}): each by itself is less certain than both",
        words.word(*one),
        words.word(*other)
    );

    /// A fitted parameter at the end of its range.
    "at-end-of-range" AtEndOfRange {
        /// Which.
        parameter: Quantity,
        /// Its value, in its unit if it has one.
        value: f64,
    } *parameter, |words| format!(
        "{} is at the end of its range, {value}: the data would have it beyond, and its interval counts \
         to one side only",
        words.word(*parameter)
    );

    /// Polach's reductions as no case can have them.
    "impossible-reduction" ImpossibleReduction {
        /// k_S, dimensionless.
        slip: f64,
        /// k_A, dimensionless.
        adhesion: f64,
    } Quantity::PolachAreaSlip, |words| format!(
        "{} is {slip:.4}, but must not exceed {} = {adhesion:.4}: no case can have them; hold one of \
         them",
        words.word(Quantity::PolachAreaSlip),
        words.word(Quantity::PolachAreaAdhesion)
    );

    /// Residuals of a fit that are no scatter.
    "systematic-residuals" SystematicResiduals {} Quantity::ForceRatio, |words| {
        "the residuals are no scatter, neighbours have the same sign: the model does not follow the \
         data, and the parameters are less certain than their intervals say"
            .to_owned()
    };

    /// Data that have little to do with the model.
    "unexplained" Unexplained {
        /// R², dimensionless.
        r_squared: f64,
    } Quantity::ForceRatio, |words| format!(
        "the model explains {:.0} % of the variance of the data only",
        100.0 * r_squared.max(0.0)
    );

    /// Residuals beyond the standard deviations of the data.
    "excess-scatter" ExcessScatter {
        /// How many times they are, dimensionless.
        factor: f64,
    } Quantity::StandardDeviation, |words| format!(
        "the residuals are {factor:.1} times what the standard deviations of the data allow: the \
         intervals are widened by that"
    );
}

impl Warning {
    /// A warning that results did not converge.
    pub(crate) fn of(cause: Unconverged) -> Self {
        Self::NotConverged { cause }
    }
}

messages! {
    /// Why results did not converge.
    Unconverged:

    /// The equilibrium of bodies that do not roll.
    "equilibrium" Equilibrium {
        /// Newton steps that were done.
        newton_steps: usize,
        /// Residual, dimensionless.
        residual: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } Quantity::Tolerance, |words| format!(
        "after {newton_steps} Newton steps the equilibrium has a residual of {residual:.1e}, above the \
         tolerance {tolerance:.1e}"
    );

    /// The equilibrium of a time step.
    "time-step" TimeStep {
        /// Worst residual, dimensionless.
        residual: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } Quantity::Tolerance, |words| format!(
        "the worst equilibrium of a time step has a residual of {residual:.1e}, above the tolerance \
         {tolerance:.1e}"
    );

    /// A march that ended early.
    "short-march" ShortMarch {
        /// Time steps that were done.
        steps: usize,
    } Quantity::MaxSteps, |words| format!(
        "the march ends after {steps} time steps, before the material has passed the patch twice"
    );

    /// A march that has not become steady.
    "unsteady-march" UnsteadyMarch {
        /// Time steps that were done.
        steps: usize,
        /// Change within a passage of the patch, dimensionless.
        change: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } Quantity::MaxSteps, |words| format!(
        "after {steps} time steps traction or temperature still change by {change:.1e} within a passage \
         of the patch, above the tolerance {tolerance:.1e}"
    );

    /// Surfaces that are not equally hot.
    "heat-exchange" HeatExchange {} Quantity::HeatModel, |words| {
        "the exchange of heat between wheel and rail that makes their surfaces equally hot was not \
         found; temperatures are wrong"
            .to_owned()
    };

    /// A wheel whose heat is not balanced.
    "heat-balance" HeatBalance {
        /// Steady states that were found.
        states: usize,
        /// Heat that the wheel receives more than it gives, in W.
        surplus: f64,
    } Quantity::WheelBulkTemperature, |words| format!(
        "after {states} steady states the wheel still receives {surplus:.1e} W more than it gives"
    );

    /// Points of a curve.
    "points" Points {
        /// What the curve is drawn over.
        abscissa: Quantity,
        /// Where the first of them lie, in the unit of that quantity, or dimensionless.
        places: Vec<f64>,
        /// How many there are.
        failed: usize,
        /// All points.
        count: usize,
    } *abscissa, |words| {
        let named: Vec<String> = places.iter().map(|place| abscissa.six_digits(*place)).collect();
        let rest = match failed.saturating_sub(places.len()) {
            0 => String::new(),
            rest => format!(" and {rest} more"),
        };
        let (name, named) = (abscissa.name(), named.join(", "));
        format!("{failed} of {count} points, at {name} = {named}{rest}")
    };

    /// A fit that is at no minimum.
    "fit" Fit {
        /// Why it stopped.
        stop: FitStop,
    } Quantity::FitParameters, |words| stop.text(words);
}

/// What a surface is too hot for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum HeatLimit {
    /// Steel melts.
    Melting,
    /// Steel austenitises (A1).
    Austenite,
    /// Most materials fail.
    AnyMaterial,
}

impl HeatLimit {
    fn text(self) -> &'static str {
        match self {
            Self::Melting => "above the melting range of steel",
            Self::Austenite => "above 727 degC, where steel starts to austenitise",
            Self::AnyMaterial => "more than most materials withstand",
        }
    }
}
