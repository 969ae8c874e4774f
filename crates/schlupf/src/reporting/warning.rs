//! Warnings: what users of results should know.

mod heat_limit;
mod unconverged;

use crate::reporting::{Quantity, messages, readable};

pub use heat_limit::HeatLimit;
pub(crate) use unconverged::Unconverged;

messages! {
    /// A warning.
    Warning:

    /// Results did not converge; the text says which, and by how much.
    "not-converged" NotConverged {
        /// Why.
        cause: Unconverged,
    } cause.quantity(), |name, words| cause.text(words), severity cause.severity();

    /// The steady state was not found directly but by marching, without derivatives.
    "marched" Marched {
        /// Residual at which Newton's method stopped, dimensionless.
        residual: f64,
        /// Newton steps that were done.
        newton_steps: usize,
    } Quantity::Driver, |name, words| format!(
        "the steady equilibrium was not found directly (residual {residual:.1e} after {newton_steps} \
         Newton steps); this is the end of a march, without derivatives"
    ), severity *residual;

    /// Falling friction has several steady states; the text has the forces of both.
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

    /// Two creepages cause the prescribed forces on falling friction; the text has the others.
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

    /// The falling branch is asked for, but only one motion has these forces.
    "one-motion" OneMotion {} Quantity::Branch, |name, words| format!(
        "{name} asks for the falling branch of the creep curve, but only one motion with the \
         prescribed forces was found, on the rising one"
    );

    /// There may be several steady states, not all of which could be followed.
    "branch-lost" BranchLost {} Quantity::Branch, |name, words| {
        "friction falls so fast that there may be several steady states; they could not all be \
         followed along the creepage: there may be another one than this, on either branch"
            .to_owned()
    };

    /// The derivatives were not found and are omitted.
    "no-sensitivity" NoSensitivity {} Quantity::Sensitivities, |name, words| format!(
        "{name}: a linear system at the solution was not solved; the derivatives are left out"
    );

    /// No second grid for `solver.extrapolate`: too few cells, marching, or not solved.
    "no-extrapolation" NoExtrapolation {} Quantity::Extrapolate, |name, words| format!(
        "{name}: there is no second grid, half as fine and solved, which takes the steady driver and \
         16 cells in each direction (8 on a layer); the forces are those of the grid alone"
    );

    /// The pressure is above any elastic limit: wrong units?
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

    /// The surroundings of the elastic layer are too small.
    "small-margin" SmallMargin {
        /// Displacement at their outer edge over the largest one, dimensionless.
        edge: f64,
    } Quantity::Margin, |name, words| format!(
        "{name}: the displacement at the outer edge of the layer is {:.1} % of the largest; above 1 % \
         a larger margin is needed",
        100.0 * edge
    ), severity *edge;

    /// Power returned by the bristles is discarded: the grid is too coarse for the contact law.
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

    /// Wheel and rail have different elastic constants, which is neglected.
    "dissimilar-bodies" DissimilarBodies {
        /// Dundurs' or Kalker's constant K, dimensionless.
        constant: f64,
    } Quantity::Elasticity, |name, words| format!(
        "{name}: wheel and rail differ in their elastic constants (K = {constant:.3}); that pressure \
         displaces their surfaces tangentially, and tractions change it, is neglected"
    ), severity constant.abs();

    /// Unlike bodies, whose tractions change the pressure: neglected, or only in derivatives.
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

    /// The calibrated layer treats a patch of several parts as one ellipse.
    "layer-of-parts" LayerOfParts {
        /// How many.
        parts: usize,
    } Quantity::Calibration, |name, words| format!(
        "{name}: the layer is calibrated for one elliptic patch; for the {parts} separate parts of this \
         one it takes the ellipse of their common extent, which is too compliant; {} needs no \
         calibration",
        words.choice(Quantity::Elasticity, "half-space")
    ), severity *parts as f64;

    /// A calibration treats the patch like the ellipse with the same extent.
    "equivalent-ellipse" EquivalentEllipse {} Quantity::Calibration, |name, words| {
        "the patch is treated like the ellipse of the same extent".to_owned()
    };

    /// The undeformed distance has too few points across the patch.
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

    /// The patch shrinks to few cells under a load that falls in a history.
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

    /// These temperatures neglect that heat flows along the surface.
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

    /// A surface is so hot that steel austenitises or melts.
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

    /// Temperatures below the surface use another heat model than the cells.
    "heat-model-of-cells" HeatModelOfCells {} Quantity::HeatModel, |name, words| format!(
        "{name}: below the surface and in the wake temperatures follow from the heat released, by \
         Duhamel's theorem; the heat model of the case applies to the cells only"
    );

    /// Kalker's coefficients are extrapolated beyond their table.
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

    /// The patch is more slender than those of the look-up table.
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

    /// Kalker's coefficients are those of an ellipse with the extent of the patch.
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

    /// The method does not support friction memory.
    "no-memory" NoMemory {
        /// The method.
        method: &'static str,
    } Quantity::MemoryDistance, |name, words| format!(
        "{name}: {method:?} has no friction memory; friction follows its law instantly"
    );

    /// The method takes the layer between the surfaces to be elastic.
    "no-yield" NoYield {
        /// The method.
        method: &'static str,
    } Quantity::LayerYieldStress, |name, words| format!(
        "{name}: {method:?} takes the layer to be elastic whatever the traction"
    );

    /// Friction depends on the temperature, which the method does not compute.
    "cold-friction" ColdFriction {
        /// The method.
        method: &'static str,
    } Quantity::Method, |name, words| format!(
        "{name} = {method:?} has no temperatures, so friction is that at the temperature of the \
         entering material"
    );

    /// The force is above the friction limit.
    "beyond-friction" BeyondFriction {
        /// The method.
        method: &'static str,
        /// The force over the limit, dimensionless.
        ratio: f64,
    } Quantity::Method, |name, words| format!(
        "{name}: the force of {method:?} is {ratio:.3} times the friction limit μN, which the method \
         does not enforce; do not use it"
    ), severity *ratio;

    /// Friction power and creep power of FASTSIM differ.
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

    /// The derivatives at zero creepage were not found.
    "no-initial-slope" NoInitialSlope {
        /// What the curve is drawn over.
        abscissa: Quantity,
    } *abscissa, |name, words| {
        format!("no initial slope: the derivatives at {name} = 0 were not found")
    };

    /// Two fitted parameters are strongly correlated.
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

    /// A fitted parameter is at the end of its range.
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

    /// K_S is above k_A: no case can have them.
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

    /// Neighbouring residuals have the same sign.
    "systematic-residuals" SystematicResiduals {} Quantity::ForceRatio, |name, words| {
        "the residuals are not random, neighbours have the same sign: the model does not follow the \
         data, and the parameters are less certain than their intervals suggest"
            .to_owned()
    };

    /// The model explains little of the variance of the data.
    "unexplained" Unexplained {
        /// R², dimensionless.
        r_squared: f64,
    } Quantity::ForceRatio, |name, words| format!(
        "the model explains only {:.0} % of the variance of the data",
        100.0 * r_squared.max(0.0)
    ), severity -r_squared;

    /// The wheel has more contacts than the first, which this result is about.
    "one-contact" OneContact {
        /// How many the wheel has.
        contacts: usize,
        /// Normal force of the first over that of all, dimensionless.
        share: f64,
    } Quantity::ContactAngle, |name, words| format!(
        "the wheel has {contacts} contacts, and this is about the first of them, which carries \
         {:.0} % of the normal forces", 100.0 * share
    ), severity -share;

    /// The surface turns by more than 0.3 rad over a contact that is solved in a plane: its
    /// pressure is too high, and its spin perhaps that of the plane.
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

    /// The curvature of the rail varies over a contact whose half-spaces are bent with one.
    ///
    /// Balls in grooves with another curvature than their own: up to 8 % of the largest pressure,
    /// with tractions 13 %, and 17 % of the approach for each radian.
    "uneven-curvature" UnevenCurvature {
        /// Angle by which the surface turns away from one of that curvature, in rad.
        angle: f64,
        /// The mean curvature, in 1/m.
        curvature: f64,
    } Quantity::ContactAngle, |name, words| format!(
        "{name}: the surface of a contact turns by up to {angle:.2} rad away from one of the mean \
         curvature with which it is solved, {curvature:.0} 1/m: the largest pressure and the approach \
         are off by up to {:.0} %", 17.0 * angle
    ), severity *angle;

    /// The vertical force jumps over the load; results are those of the nearest state.
    "jumping-force" JumpingForce {
        /// Vertical force over the load, minus one; dimensionless.
        residual: f64,
    } Quantity::Load, |name, words| format!(
        "{name}: the vertical force jumps over the load as the wheel is lowered, where cells or whole \
         contacts come to touch; the nearest state differs from the load by {:.2} % of it",
        100.0 * residual
    );

    /// The heights at which both wheels rest jump past each other as the roll angle varies.
    "jumping-height" JumpingHeight {
        /// Height of the wheel above the other one, in m.
        difference: f64,
    } Quantity::RollAngle, |name, words| format!(
        "{name}: the heights at which both wheels rest jump past each other as the wheelset rolls, where \
         contacts come to touch; this wheel stays {:.1} um above the other one", 1e6 * difference
    );

    /// A contact has many parts on profiles that were not smoothed.
    "rough-profile" RoughProfile {
        /// Parts of the patch.
        parts: usize,
    } Quantity::ProfileSmoothing, |name, words| format!(
        "{name}: a contact has {parts} separate parts, as noise of measured profiles makes them; smooth \
         measured profiles, over some 5 mm"
    ), severity *parts as f64;

    /// A profile has no points under more than a third of a contact.
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

    /// The points of a profile are more than a third of a contact apart.
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

    /// Residuals are larger than the standard deviations of the data explain.
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

    /// Whether pressure and tractions that belong together were not found.
    pub(crate) fn is_of_pressure(&self) -> bool {
        matches!(self, Self::NotConverged { cause: Unconverged::Pressure { .. } })
    }
}

/// As a message with the names of the quantities.
#[cfg(feature = "serde")]
impl serde::Serialize for Warning {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.message(&crate::reporting::Names).serialize(serializer)
    }
}
