//! Why results did not converge.

use crate::reporting::{FitStop, Quantity, messages};

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
