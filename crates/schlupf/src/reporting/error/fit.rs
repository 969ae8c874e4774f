//! What can be wrong with a fit.

use super::Error;
use crate::reporting::{Quantity, Words, messages, readable, with_unit};

messages! {
    /// Why parameters cannot be fitted to data.
    FitError:

    /// No parameter is to be fitted.
    "nothing-to-fit" NothingToFit {} Quantity::FitParameters, |name, words| {
        format!("{name}: there is nothing to fit")
    };

    /// There are fewer points than parameters.
    "too-few-points" TooFewPoints {
        /// What is to be fitted.
        parameters: Vec<Quantity>,
        /// Measured forces.
        points: usize,
    } first(parameters), |name, words| {
        let count = parameters.len();
        let names: Vec<_> = parameters.iter().map(|name| words.word(*name)).collect();
        let why = if *points == count {
            ": with as many points as parameters the scatter cannot be estimated unless the data have \
             standard deviations"
        } else {
            ""
        };
        let plural = |count: usize| if count == 1 { "" } else { "s" };
        format!(
            "{name}: {count} parameter{} ({}) cannot be determined from {points} measured force{}{why}",
            plural(count),
            names.join(", "),
            plural(*points)
        )
    };

    /// An initial value is outside the bounds of the fit.
    "start-out-of-range" StartOutOfRange {
        /// What is to be fitted.
        quantity: Quantity,
        /// The value, in its unit if it has one.
        value: f64,
        /// Least and largest value, in its unit if it has one.
        bounds: [f64; 2],
    } *quantity, |name, words| format!(
        "{name} must start a fit between {} and {}, but is {}",
        readable(bounds[0]),
        with_unit(bounds[1], quantity.unit()),
        with_unit(*value, quantity.unit())
    );

    /// Only some of the points have a standard deviation.
    "some-deviations" SomeDeviations {
        /// Points that have one.
        known: usize,
        /// All points.
        count: usize,
    } Quantity::StandardDeviation, |name, words| format!(
        "{name}: all points or none need a standard deviation, but {known} of {count} have one"
    );

    /// Measured forces have the wrong sign.
    "wrong-sign" WrongSign {
        /// Which forces.
        component: Quantity,
        /// Where, if not everywhere: speed in m/s.
        speed: Option<f64>,
        /// Load of those points (in N), if they have one of their own.
        load: Option<f64>,
    } Quantity::ForceRatio, |name, words| {
        let load = load.map_or(String::new(), |load| format!(" under {} N", readable(load)));
        let place = speed
            .map_or(String::new(), |speed| format!(" at some {} m/s{load}", readable(speed)));
        format!(
            "{name}: the {}s{place} have the opposite sign of those that creepages and spin give: they \
             must be those on the rail, -Fx/N over creepage_x and -Fy/N over creepage_y, as creep \
             curves show them",
            component.description()
        )
    };

    /// No forces or derivatives were found at the initial values.
    "no-start" NoStart {
        /// What is to be fitted first.
        quantity: Quantity,
        /// The motion at which no force was found, each number in its unit or dimensionless; `None`
        /// where the forces have no derivatives.
        at: Option<Vec<(Quantity, f64)>>,
    } *quantity, |name, words| match at {
        Some(motion) => format!(
            "{name}: with the start values no force was found at {}; start from others",
            listed(motion)
        ),
        None => format!("{name}: the forces have no derivatives at the start values"),
    };

    /// The fit stopped where the forces do not depend on the parameters.
    "fit-stuck" FitStuck {
        /// What is to be fitted first.
        quantity: Quantity,
        /// Why it stopped.
        stop: FitStop,
    } *quantity, |name, words| format!(
        "{name}: {}, and there the forces do not depend enough on the parameters to go on",
        stop.text(words)
    );

    /// No measured force depends on a parameter.
    "no-influence" NoInfluence {
        /// The parameter.
        quantity: Quantity,
        /// Its value, in its unit if it has one.
        value: f64,
    } *quantity, |name, words| format!(
        "{name}: the data do not determine it: near {} no measured force depends on it; {}",
        shown(*value, *quantity),
        where_it_shows(*quantity)
    );

    /// The data do not distinguish the parameters.
    "inseparable" Inseparable {
        /// Which.
        parameters: Vec<Quantity>,
    } first(parameters), |name, words| {
        let names: Vec<_> = parameters.iter().map(|name| words.word(*name)).collect();
        format!(
            "{name}: the data do not distinguish {}: another choice of them gives the same forces; fit \
             one of them less, or add points at other creepages or speeds",
            names.join(" and ")
        )
    };

    /// Forces proportional to the creepage do not determine friction.
    "linear-range" LinearRange {
        /// Largest force over μ0 N, dimensionless.
        largest: f64,
    } Quantity::FrictionCoefficient, |name, words| format!(
        "{name}: the data do not determine it: all forces are proportional to the creepage, the largest \
         is {largest:.2} μ0 N; {}",
        where_it_shows(Quantity::FrictionCoefficient)
    );

    /// The data do not determine a parameter.
    "undetermined" Undetermined {
        /// Which.
        quantity: Quantity,
        /// Its value, in its unit if it has one.
        value: f64,
        /// Half its 95 % interval over its size, dimensionless.
        relative: f64,
        /// What it goes together with, and the correlation, dimensionless.
        related: Vec<(Quantity, f64)>,
    } *quantity, |name, words| {
        let related: Vec<String> = related
            .iter()
            .map(|(name, r)| format!("{} (correlation {r:.3})", words.word(*name)))
            .collect();
        let with = if related.is_empty() {
            String::new()
        } else {
            format!(" together with {}", related.join(" and "))
        };
        let width = if *relative < 1e3 {
            format!("±{:.0} %", 100.0 * relative)
        } else {
            "more than ±100000 %".to_owned()
        };
        format!(
            "{name}: the data do not determine it{with}: at {} its 95 % interval is {width}; {}; add such \
             points, or do not fit it",
            shown(*value, *quantity),
            where_it_shows(*quantity)
        )
    };

    /// The friction law in use has no such constant.
    "no-such-constant" NoSuchConstant {
        /// The parameter.
        quantity: Quantity,
        /// The constants of the law.
        constants: Vec<Quantity>,
    } *quantity, |name, words| {
        let names: Vec<_> = constants.iter().map(|name| words.word(*name)).collect();
        let names = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
        format!("{name}: it is not a constant of the friction law in use, which has {names}")
    };

    /// A parameter affects the forces only with heat.
    "needs-heat" NeedsHeat {
        /// The parameter.
        quantity: Quantity,
        /// The method that has no heat; `None` where the heat model is none.
        method: Option<&'static str>,
    } *quantity, |name, words| {
        let why = match method {
            Some(method) => format!("{} has no heat", words.choice(Quantity::Method, method)),
            None => words.choice(Quantity::HeatModel, "none"),
        };
        format!("{name}: it affects the forces only where friction heats the contact, but {why}")
    };

    /// The method does not have the parameter.
    "not-of-method" NotOfMethod {
        /// The parameter.
        quantity: Quantity,
        /// The method in use.
        method: &'static str,
    } *quantity, |name, words| {
        let polach = words.choice(Quantity::Method, "polach");
        if *method == "polach" {
            format!(
                "{name}: {polach} has no contact law; its slope is reduced by {} and {}",
                words.word(Quantity::PolachAreaAdhesion),
                words.word(Quantity::PolachAreaSlip)
            )
        } else {
            format!("{name}: it is a constant of {polach}, but the method is {method:?}")
        }
    };

    /// The contact law in use has no k_c.
    "no-stiffness" NoStiffness {} Quantity::ContactStiffness, |name, words| {
        format!("{name}: the contact law in use has no such constant")
    };

    /// There is no layer between the surfaces.
    "no-layer" NoLayer {
        /// The parameter.
        quantity: Quantity,
    } *quantity, |name, words| format!("{name}: there is no layer between the surfaces");

    /// A constant of yielding is to be fitted, but the layer is elastic.
    "no-yield-limit" NoYieldLimit {
        /// The parameter.
        quantity: Quantity,
    } *quantity, |name, words| format!(
        "{name}: the layer is elastic; a fit starts from a {}, and the case has none",
        words.word(Quantity::LayerYieldStress)
    );

    /// k_c cannot be fitted together with the roughness that determines it.
    "stiffness-and-roughness" StiffnessAndRoughness {} Quantity::ContactStiffness, |name, words| {
        format!("{name}: it cannot be fitted together with the roughness that determines it")
    };
}

impl std::error::Error for FitError {}

/// Why a fit did not reach a minimum.
#[derive(Debug, Clone, PartialEq)]
pub struct FitStop {
    /// Steps that were done.
    pub steps: usize,
    /// What stopped it.
    pub cause: FitCause,
}

/// What stopped a fit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FitCause {
    /// A parameter reached its search bound.
    RanOut {
        /// Which.
        quantity: Quantity,
        /// Its value, in its unit or dimensionless.
        value: f64,
    },
    /// A force was not found at a motion, each number in its unit or dimensionless.
    NotFound(Vec<(Quantity, f64)>),
    /// Something was refused.
    Refused(Box<Error>),
    /// Nothing but the number of steps.
    Steps,
}

impl FitStop {
    /// It as a sentence in the words of a face.
    pub fn text(&self, words: &dyn Words) -> String {
        let cause = match &self.cause {
            FitCause::RanOut { quantity, value } => {
                let end = with_unit(*value, quantity.unit());
                format!("{} reached its search bound, {end}", words.word(*quantity))
            }
            FitCause::NotFound(motion) => format!("no force was found at {}", listed(motion)),
            FitCause::Refused(error) => error.text(words),
            FitCause::Steps => "more steps or other start values may help".to_owned(),
        };
        format!("after {} steps the fit is at no minimum; {cause}", self.steps)
    }
}

/// `creepage_x = 0.1, speed = 30 m/s`.
fn listed(values: &[(Quantity, f64)]) -> String {
    let equation = |(quantity, value): &(Quantity, f64)| {
        format!("{} = {}", quantity.name(), with_unit(*value, quantity.unit()))
    };
    values.iter().map(equation).collect::<Vec<_>>().join(", ")
}

fn first(parameters: &[Quantity]) -> Quantity {
    parameters.first().copied().unwrap_or(Quantity::FitParameters)
}

/// Which points of a creep curve depend on a parameter.
fn where_it_shows(parameter: Quantity) -> &'static str {
    match parameter {
        Quantity::FrictionCoefficient => "it shows where the force bends over and at its maximum",
        Quantity::TemperatureAtZeroFriction
        | Quantity::MinimumCoefficient
        | Quantity::HotCoefficient
        | Quantity::TemperatureRange => "it shows at creepages and speeds that heat the contact",
        Quantity::ContactStiffness
        | Quantity::ContactRoughness
        | Quantity::LayerShearModulus
        | Quantity::PolachAreaAdhesion => {
            "it shows at small creepages and where the force bends over"
        }
        Quantity::LayerYieldStress | Quantity::LayerHardening => {
            "it shows where the layer flows, at large creepages"
        }
        Quantity::PolachAreaSlip => "it shows at small creepages and on the way to the maximum",
        _ => "it shows at slip speeds over which friction falls",
    }
}

/// A value of four digits with the unit of its quantity.
fn shown(value: f64, quantity: Quantity) -> String {
    let value: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    let number =
        if (1e-3..1e5).contains(&value) { value.to_string() } else { format!("{value:e}") };
    format!("{number} {}", quantity.unit()).trim_end().to_owned()
}

impl From<FitError> for Error {
    fn from(error: FitError) -> Self {
        Self::Fit { error }
    }
}
