//! Warnings: what users of results should know.

mod heat_limit;

use crate::reporting::{FitStop, Quantity, messages, readable};

pub use heat_limit::HeatLimit;

messages! {
    /// A warning.
    Warning:

    /// The results did not converge.
    "not-converged" NotConverged {
        /// Why.
        cause: Unconverged,
    } cause.quantity(), |name, words| cause.text(words), severity cause.severity();

    /// The steady state was marched to.
    "marched" Marched {
        /// Residual at which Newton's method stopped, dimensionless.
        residual: f64,
        /// Newton steps that were done.
        newton_steps: usize,
    } Quantity::Driver, |name, words| format!(
        "the steady equilibrium was not found directly (residual {residual:.1e} after {newton_steps} \
         Newton steps); this is the end of a march, without derivatives"
    ), severity *residual;

    /// There are several steady states.
    "several-states" SeveralStates {
        /// Whether this one is reached from low slip (or from high slip).
        from_low_slip: bool,
        /// Its tangential force, in N.
        force: [f64; 2],
        /// The tangential force of the state that is reached from the other side, in N.
        other_force: [f64; 2],
    } Quantity::Branch, |name, words| {
        let [here, there] = if *from_low_slip { ["low", "high"] } else { ["high", "low"] };
        let [x, y] = force;
        let [other_x, other_y] = other_force;
        format!(
            "friction falls so fast that there are several steady states: this one is reached from \
             {here} slip, with Fx = {x:.6e} N and Fy = {y:.6e} N; from {there} slip they are \
             {other_x:.6e} N and {other_y:.6e} N"
        )
    };

    /// Several motions have the prescribed forces.
    "several-motions" SeveralMotions {
        /// Whether this one is on the rising branch (or on the falling one).
        is_low: bool,
        /// Creepages of the other one: longitudinal and lateral, dimensionless, and spin, in 1/m.
        creepages: [f64; 3],
    } Quantity::Branch, |name, words| {
        let [here, there] = if *is_low { ["rising", "falling"] } else { ["falling", "rising"] };
        let [x, y, spin] = creepages;
        let [words_x, words_y, words_spin] =
            [Quantity::CreepageX, Quantity::CreepageY, Quantity::Spin].map(|q| words.word(q));
        format!(
            "friction falls, and two motions have the prescribed forces: this one is on the {here} \
             branch of the creep curve; that on the {there} branch has {words_x} = {x:.6e}, \
             {words_y} = {y:.6e} and {words_spin} = {spin:.6e} 1/m"
        )
    };

    /// The other motion with the prescribed forces was asked for, and there is none.
    "one-motion" OneMotion {} Quantity::Branch, |name, words| format!(
        "{name} asks for the falling branch of the creep curve, but only one motion with the \
         prescribed forces was found, on the rising one"
    );

    /// There may be several steady states.
    "branch-lost" BranchLost {} Quantity::Branch, |name, words| {
        "friction falls so fast that there may be several steady states; they could not all be \
         followed along the creepage: there may be another one than this, on either branch"
            .to_owned()
    };

    /// Derivatives were not found.
    "no-sensitivity" NoSensitivity {} Quantity::Sensitivities, |name, words| format!(
        "{name}: a linear system at the solution was not solved; the derivatives are left out"
    );

    /// Forces were not extrapolated.
    "no-extrapolation" NoExtrapolation {} Quantity::Extrapolate, |name, words| format!(
        "{name}: there is no second grid, half as fine and solved, which takes the steady driver and \
         16 cells in each direction (8 on a layer); the forces are those of the grid alone"
    );

    /// A pressure beyond the elastic range of any metal.
    "beyond-elastic" BeyondElastic {
        /// Largest pressure, in Pa.
        pressure: f64,
        /// Contact modulus, in Pa.
        modulus: f64,
    } Quantity::PeakPressure, |name, words| format!(
        "{name}: the largest pressure is {} MPa, {:.0} % of the contact modulus, which is beyond \
         elasticity with small strains: check load and radii and their units",
        readable(1e-6 * pressure),
        1e2 * pressure / modulus
    ), severity pressure / modulus;

    /// Surroundings of the layer that are too small.
    "small-margin" SmallMargin {
        /// Displacement at their outer edge over the largest one, dimensionless.
        edge: f64,
    } Quantity::Margin, |name, words| format!(
        "{name}: the displacement at the outer edge of the layer is {:.1} % of the largest; above 1 % \
         a larger margin is needed",
        100.0 * edge
    ), severity *edge;

    /// Power that the bristles return.
    "returned-power" ReturnedPower {
        /// That power, in W.
        returned: f64,
        /// Friction power, in W.
        friction: f64,
    } Quantity::ContactStiffness, |name, words| format!(
        "{name}: {returned:.3e} W of {friction:.3e} W friction power are returned, by the bristles \
         or, with Coulomb's law, by the error of the grid; that part is discarded: it neither heats \
         nor cools. Where it is large in steady rolling, the grid is too coarse for the contact law"
    ), severity returned / friction.abs();

    /// Bodies whose pressure displaces their surfaces tangentially against each other.
    "dissimilar-bodies" DissimilarBodies {
        /// Dundurs' or Kalker's constant K, dimensionless.
        constant: f64,
    } Quantity::Elasticity, |name, words| format!(
        "{name}: wheel and rail differ in their elastic constants (K = {constant:.3}); that pressure \
         displaces their surfaces tangentially, and tractions change it, is neglected"
    ), severity constant.abs();

    /// A pressure that the tractions of unlike bodies would change.
    "unchanged-pressure" UnchangedPressure {
        /// Kalker's constant K, dimensionless.
        constant: f64,
        /// Whether this concerns the derivatives only.
        in_derivatives: bool,
    } Quantity::Elasticity, |name, words| format!(
        "{name}: wheel and rail differ in their elastic constants (K = {constant:.3}); {}",
        if *in_derivatives {
            "the derivatives are those under an unchanged pressure"
        } else {
            "the change of the pressure by the tractions is neglected"
        }
    ), severity constant.abs();

    /// A calibrated layer for a patch of several parts.
    "layer-of-parts" LayerOfParts {
        /// How many.
        parts: usize,
    } Quantity::Calibration, |name, words| format!(
        "{name}: the layer is calibrated for one elliptic patch; for the {parts} separate parts of this \
         one it takes the ellipse of their common extent, which is too compliant; {} needs no \
         calibration",
        words.choice(Quantity::Elasticity, "half-space")
    ), severity *parts as f64;

    /// A patch that a calibration takes for an ellipse.
    "equivalent-ellipse" EquivalentEllipse {} Quantity::Calibration, |name, words| {
        "the patch is treated like the ellipse of the same extent".to_owned()
    };

    /// A distance of the bodies of few points.
    "coarse-distance" CoarseDistance {
        /// Points across the patch.
        points: usize,
        /// Parts of the patch.
        parts: usize,
        /// Points that each part needs.
        fewest: usize,
    } Quantity::UndeformedDistance, |name, words| format!(
        "{name}: the distance is given at {points} point{} across the patch, too few to determine its \
         shape; give at least {fewest}{}",
        if *points == 1 { "" } else { "s" },
        if *parts == 1 { String::new() } else { format!(" in each of its {parts} parts") }
    ), severity -(*points as f64);

    /// A patch that has shrunk to few cells.
    "few-cells" FewCells {
        /// Cells along rolling in its longest strip.
        cells: usize,
        /// Cells along rolling under the largest load.
        of: usize,
    } Quantity::HistoryLoad, |name, words| format!(
        "{name}: under the smallest load the patch spans {cells} cells along rolling, because the grid \
         has {of} for the largest one; increase {}",
        words.word(Quantity::CellsX)
    ), severity -(*cells as f64);

    /// Rolling so slowly that heat also flows along the surface.
    "slow-rolling" SlowRolling {
        /// Péclet numbers of wheel and rail, dimensionless.
        peclet: [f64; 2],
        /// Whether the patch is narrower than long, so that heat flows sideways, too.
        is_narrow: bool,
        /// Whether it is about temperatures below the surface and in the wake.
        is_field: bool,
    } Quantity::HeatModel, |name, words| {
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
        let [wheel, rail] = peclet;
        format!(
            "{name}: the Péclet numbers v a/κ are {wheel:.3e} (wheel) and {rail:.3e} (rail). {what} \
             assume conduction perpendicular to the surface only, which overestimates them by about \
             1 % at a Péclet number of 100, by 10 % at 10 and without bound below{}",
            if *is_narrow { " (less on a narrower patch)" } else { "" }
        )
    }, severity -peclet[0].min(peclet[1]);

    /// A surface so hot that material constants do not hold.
    "hot-surface" HotSurface {
        /// Which one: the bulk temperature of the wheel, or of the rail.
        body: Quantity,
        /// Its largest temperature, in degC.
        temperature: f64,
        /// What happens there.
        limit: HeatLimit,
    } *body, |name, words| format!(
        "{name}: the surface of the {} reaches {temperature:.0} degC, {}: material constants, elasticity \
         and friction are not valid there",
        if *body == Quantity::WheelBulkTemperature { "wheel" } else { "rail" },
        limit.text()
    ), severity *temperature;

    /// Temperatures below the surface by another heat model than in the cells.
    "heat-model-of-cells" HeatModelOfCells {} Quantity::HeatModel, |name, words| format!(
        "{name}: below the surface and in the wake temperatures follow from the heat released, by \
         Duhamel's theorem; the heat model of the case applies to the cells only"
    );

    /// Kalker's coefficients beyond their table.
    "slender-patch" SlenderPatch {
        /// The method.
        method: &'static str,
        /// a/b, dimensionless.
        axis_ratio: f64,
    } Quantity::Method, |name, words| format!(
        "{name} = {method:?} needs Kalker's coefficients at a/b = {axis_ratio:.4}, beyond their table \
         (1/10 to 10), and takes them from Kalker's limits: C11, C22 and C23 are off by up to 7 % at \
         1/30 and 30, C33 is a limit only"
    ), severity axis_ratio.ln().abs();

    /// A patch that a look-up table does not cover.
    "outside-table" OutsideTable {
        /// a/b, dimensionless.
        axis_ratio: f64,
        /// Range of the table, dimensionless.
        range: [f64; 2],
    } Quantity::Method, |name, words| format!(
        "{name}: the look-up table covers a/b from {} to {}, but the patch has {axis_ratio:.4}; its \
         forces beyond the linear range are those of the nearest a/b in the table",
        readable(range[0]),
        readable(range[1])
    ), severity axis_ratio.ln().abs();

    /// A patch that is no ellipse but counts as one.
    "counts-as-ellipse" CountsAsEllipse {
        /// The method.
        method: &'static str,
        /// Separate parts of the patch.
        parts: usize,
    } Quantity::Method, |name, words| {
        let apart = if *parts > 1 {
            format!("; that ellipse spans {parts} separate parts and counts the gaps as contact")
        } else {
            String::new()
        };
        format!(
            "{name} = {method:?} takes Kalker's coefficients of the ellipse with the length and width of \
             the patch{apart}"
        )
    }, severity *parts as f64;

    /// A method without memory of friction.
    "no-memory" NoMemory {
        /// The method.
        method: &'static str,
    } Quantity::MemoryDistance, |name, words| format!(
        "{name}: {method:?} has no friction memory; friction follows its law instantly"
    );

    /// A layer that yields, in a method that takes it to be elastic.
    "no-yield" NoYield {
        /// The method.
        method: &'static str,
    } Quantity::LayerYieldStress, |name, words| format!(
        "{name}: {method:?} takes the layer to be elastic whatever the traction"
    );

    /// A method without temperatures where friction depends on them.
    "cold-friction" ColdFriction {
        /// The method.
        method: &'static str,
    } Quantity::Method, |name, words| format!(
        "{name} = {method:?} has no temperatures, so friction is that at the temperature of the \
         entering material"
    );

    /// A force above the friction limit.
    "beyond-friction" BeyondFriction {
        /// The method.
        method: &'static str,
        /// The force over the limit, dimensionless.
        ratio: f64,
    } Quantity::Method, |name, words| format!(
        "{name}: the force of {method:?} is {ratio:.3} times the friction limit μN, which the method \
         does not enforce; do not use it"
    ), severity *ratio;

    /// A balance of power that is not closed.
    "power-gap" PowerGap {
        /// Friction power, in W.
        friction: f64,
        /// Creep power, in W.
        creep: f64,
        /// Part by which they differ at least, dimensionless.
        part: f64,
    } Quantity::Method, |name, words| format!(
        "{name}: the friction power of FASTSIM, {friction:.4e} W, differs from the creep power, \
         {creep:.4e} W, by more than {} %; temperatures and wear are uncertain by as much",
        100.0 * part
    ), severity (friction - creep).abs() / creep.abs();

    /// A creep curve without the slope at its origin.
    "no-initial-slope" NoInitialSlope {
        /// What the curve is drawn over.
        abscissa: Quantity,
    } *abscissa, |name, words| {
        format!("no initial slope: the derivatives at {name} = 0 were not found")
    };

    /// Fitted parameters that go together.
    "correlated" Correlated {
        /// One.
        one: Quantity,
        /// The other.
        other: Quantity,
        /// Their correlation, dimensionless.
        correlation: f64,
    } *one, |name, words| format!(
        "{name} and {} are correlated ({correlation:.3}): each by itself is less certain than both \
         together",
        words.word(*other)
    ), severity correlation.abs();

    /// A fitted parameter at the end of its range.
    "at-end-of-range" AtEndOfRange {
        /// Which.
        parameter: Quantity,
        /// Its value, in its unit if it has one.
        value: f64,
    } *parameter, |name, words| format!(
        "{name} is at the end of its range, {}: the data favour a value beyond it, and its interval is \
         one-sided",
        readable(*value)
    );

    /// Polach's reductions as no case can have them.
    "impossible-reduction" ImpossibleReduction {
        /// k_S, dimensionless.
        slip: f64,
        /// k_A, dimensionless.
        adhesion: f64,
    } Quantity::PolachAreaSlip, |name, words| format!(
        "{name} is {slip:.4}, but must not exceed {} = {adhesion:.4}: no case accepts them; fit only \
         one of the two",
        words.word(Quantity::PolachAreaAdhesion)
    );

    /// Residuals of a fit that are no scatter.
    "systematic-residuals" SystematicResiduals {} Quantity::ForceRatio, |name, words| {
        "the residuals are not random, neighbours have the same sign: the model does not follow the \
         data, and the parameters are less certain than their intervals suggest"
            .to_owned()
    };

    /// Data that have little to do with the model.
    "unexplained" Unexplained {
        /// R², dimensionless.
        r_squared: f64,
    } Quantity::ForceRatio, |name, words| format!(
        "the model explains only {:.0} % of the variance of the data",
        100.0 * r_squared.max(0.0)
    ), severity -r_squared;

    /// A result about the first of several contacts of a wheel.
    "one-contact" OneContact {
        /// How many the wheel has.
        contacts: usize,
        /// Normal force of the first over that of all, dimensionless.
        share: f64,
    } Quantity::ContactAngle, |name, words| format!(
        "the wheel has {contacts} contacts, and this is about the first of them, which carries \
         {:.0} % of the normal forces", 100.0 * share
    ), severity -share;

    /// A contact whose surface is curved more than a plane can show.
    "conformal-contact" ConformalContact {
        /// Angle by which the surface turns over the contact, in rad.
        turn: f64,
        /// Whether its rows slip as the surface there.
        has_rows: bool,
    } Quantity::ContactAngle, |name, words| {
        let spin = if *has_rows {
            "the spin follows the surface over the patch"
        } else {
            "the spin of the plane's middle is taken for all of it"
        };
        format!(
            "{name}: the surface turns by {turn:.2} rad over a contact, which is solved in a plane: \
             beyond 0.3 rad the pressure is too high (normal.method = \"conformal\" has that of the \
             surface); {spin}"
        )
    }, severity *turn;

    /// A vertical force that jumps over the load as the wheel is lowered.
    "jumping-force" JumpingForce {
        /// Vertical force over the load, minus one; dimensionless.
        residual: f64,
    } Quantity::Load, |name, words| format!(
        "{name}: the vertical force jumps over the load as the wheel is lowered, where cells or whole \
         contacts come to touch; the nearest state differs from the load by {:.2} % of it",
        100.0 * residual
    );

    /// The heights of both wheels jump past each other as the wheelset rolls.
    "jumping-height" JumpingHeight {
        /// Height of the wheel above the other one, in m.
        difference: f64,
    } Quantity::RollAngle, |name, words| format!(
        "{name}: the heights at which both wheels rest jump past each other as the wheelset rolls, where \
         contacts come to touch; this wheel stays {:.1} um above the other one", 1e6 * difference
    );

    /// A patch of several parts on profiles that were not smoothed.
    "rough-profile" RoughProfile {
        /// Parts of the patch.
        parts: usize,
    } Quantity::ProfileSmoothing, |name, words| format!(
        "{name}: a contact has {parts} separate parts, as noise of measured profiles makes them; smooth \
         measured profiles, over some 5 mm"
    ), severity *parts as f64;

    /// A part of a contact under which a profile has no points.
    "hole-under-contact" HoleUnderContact {
        /// Of the wheel or of the rail.
        profile: Quantity,
        /// y of the points on both sides of it, outwards from the origin of the profile, in m.
        ends: [f64; 2],
        /// Part of the width of the contact, dimensionless.
        share: f64,
    } *profile, |name, words| format!(
        "{name} has no points between y = {:.2} and {:.2} mm, under {:.0} % of the width of a contact: \
         its shape there is that of the curve that bridges them",
        1e3 * ends[0],
        1e3 * ends[1],
        1e2 * share
    ), severity *share;

    /// A profile whose points are too far apart for a contact.
    "coarse-profile" CoarseProfile {
        /// Of the wheel or of the rail.
        profile: Quantity,
        /// Distance of its points, in m.
        step: f64,
        /// Width of the contact, in m.
        width: f64,
    } *profile, |name, words| format!(
        "{name}: points every {:.2} mm are too coarse for a contact that is {:.2} mm wide: its shape \
         there is that of the curve through them",
        1e3 * step,
        1e3 * width
    ), severity step / width;

    /// Residuals beyond the standard deviations of the data.
    "excess-scatter" ExcessScatter {
        /// How many times they are, dimensionless.
        factor: f64,
    } Quantity::StandardDeviation, |name, words| format!(
        "the residuals are {factor:.1} times what the standard deviations of the data allow; the \
         intervals are widened accordingly"
    ), severity *factor;
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
    } Quantity::Tolerance, |name, words| format!(
        "after {newton_steps} Newton steps the equilibrium has a residual of {residual:.1e}, above the \
         tolerance {tolerance:.1e}"
    ), severity *residual;

    /// The equilibrium of a time step.
    "time-step" TimeStep {
        /// Worst residual, dimensionless.
        residual: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } Quantity::Tolerance, |name, words| format!(
        "the worst equilibrium of a time step has a residual of {residual:.1e}, above the tolerance \
         {tolerance:.1e}"
    ), severity *residual;

    /// Prescribed forces that a time step did not end with.
    "missed-force" MissedForce {
        /// What is prescribed.
        force: Quantity,
        /// End of the first such step, in s.
        time: f64,
    } *force, |name, words| format!(
        "no creepages were found with which the time step that ends at {time:.4e} s has the {name} \
         prescribed: it may be beyond friction"
    );

    /// A march that ended early.
    "short-march" ShortMarch {
        /// Time steps that were done.
        steps: usize,
    } Quantity::MaxSteps, |name, words| format!(
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
    } Quantity::MaxSteps, |name, words| format!(
        "after {steps} time steps traction or temperature still changes by {change:.1e} within a \
         passage of the patch, above the tolerance {tolerance:.1e}"
    ), severity *change;

    /// Pressure and tractions of unlike bodies.
    "pressure" Pressure {
        /// Pressures that were found.
        iterations: usize,
        /// Change of the opening by the last tractions over the approach, dimensionless.
        change: f64,
        /// Tolerance, dimensionless.
        tolerance: f64,
    } Quantity::Tolerance, |name, words| format!(
        "after {iterations} pressures the tractions still move the surfaces of the unlike bodies by \
         {change:.1e} of their approach, above the tolerance {tolerance:.1e}"
    ), severity *change;

    /// Surfaces that are not equally hot.
    "heat-exchange" HeatExchange {} Quantity::HeatModel, |name, words| {
        "the exchange of heat that makes the surfaces of wheel and rail equally hot was not found; \
         temperatures are wrong"
            .to_owned()
    };

    /// A wheel whose heat is not balanced.
    "heat-balance" HeatBalance {
        /// Steady states that were found.
        states: usize,
        /// Heat that the wheel receives more than it gives, in W.
        surplus: f64,
    } Quantity::WheelBulkTemperature, |name, words| format!(
        "after {states} steady states the wheel still receives {surplus:.1e} W more than it gives off"
    ), severity surplus.abs();

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
    } *abscissa, |name, words| {
        let named: Vec<String> = places.iter().map(|place| abscissa.six_digits(*place)).collect();
        let rest = match failed.saturating_sub(places.len()) {
            0 => String::new(),
            rest => format!(" and {rest} more"),
        };
        format!("{failed} of {count} points, at {name} = {}{rest}", named.join(", "))
    }, severity *failed as f64;

    /// A fit that is at no minimum.
    "fit" Fit {
        /// Why it stopped.
        stop: FitStop,
    } Quantity::FitParameters, |name, words| stop.text(words);
}

/// As a message with the names of the quantities.
#[cfg(feature = "serde")]
impl serde::Serialize for Warning {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.message(&crate::reporting::Names).serialize(serializer)
    }
}
