//! `modelDescription.xml`.

use std::fmt::Write as _;

use crate::fmu::variables::{Role, Variable};
use crate::units::{Dimension, dimension};

/// A version of FMI.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

/// Name of the library in an FMU.
pub(super) const IDENTIFIER: &str = "schlupf";

/// Zero of degC, in K.
const ZERO_CELSIUS: f64 = 273.15;

/// What a description says of the FMU as a whole.
pub(super) struct Heading<'a> {
    pub version: Version,
    /// Title of the case.
    pub title: &'a str,
    pub token: &'a str,
}

/// The description of an FMU.
pub(super) fn description(heading: &Heading, variables: &[Variable]) -> String {
    let Heading { version, title, token } = heading;
    let [standard, key, state, derivatives, slope] = match version {
        Version::Two => ["2.0", "guid", "FMUstate", "Derivative", "\" numberOfEventIndicators=\"0"],
        Version::Three => ["3.0", "instantiationToken", "FMUState", "Derivatives", ""],
    };
    let abilities = format!(
        "modelIdentifier=\"{IDENTIFIER}\" canGetAndSet{state}=\"true\" \
         canSerialize{state}=\"true\" providesDirectional{derivatives}=\"true\"{}",
        match version {
            Version::Two => " canNotUseMemoryManagementFunctions=\"true\"",
            Version::Three => " providesAdjointDerivatives=\"true\"",
        }
    );
    let own = variables.iter().enumerate();
    let all: String = own.clone().map(|(k, of)| variable(*version, k, of, variables)).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"{standard}\" modelName=\"{}\" {key}=\"{token}\" \
         description=\"Force element of a rolling contact\" \
         generationTool=\"schlupf {}\" variableNamingConvention=\"structured{slope}\">\n\
         <ModelExchange {abilities}/>\n\
         <CoSimulation {abilities} canHandleVariableCommunicationStepSize=\"true\"/>\n\
         <UnitDefinitions>\n{}</UnitDefinitions>\n\
         <LogCategories><Category name=\"logStatusWarning\"/>\
         <Category name=\"logStatusDiscard\"/><Category name=\"logStatusError\"/>\
         </LogCategories>\n\
         <ModelVariables>\n{all}</ModelVariables>\n\
         <ModelStructure>\n{}</ModelStructure>\n\
         </fmiModelDescription>\n",
        escaped(title),
        env!("CARGO_PKG_VERSION"),
        units(variables),
        structure(*version, variables),
    )
}

/// The units of all variables, each once.
fn units(variables: &[Variable]) -> String {
    let mut names: Vec<&str> = variables.iter().map(|variable| variable.unit.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    names.into_iter().filter(|name| !name.is_empty()).map(unit).collect()
}

fn unit(name: &str) -> String {
    let (dimension, offset) = match name {
        "degC" => (Dimension::TEMPERATURE, format!(" offset=\"{ZERO_CELSIUS}\"")),
        _ => (dimension(name).unwrap_or_default(), String::new()),
    };
    let Dimension { length, mass, time, temperature, angle } = dimension;
    let exponents = [("kg", mass), ("m", length), ("s", time), ("K", temperature), ("rad", angle)];
    let exponents = exponents.iter().filter(|(_, exponent)| *exponent != 0);
    let exponents: Vec<String> =
        exponents.map(|(base, exponent)| format!(" {base}=\"{exponent}\"")).collect();
    let exponents = exponents.concat();
    format!("<Unit name=\"{}\"><BaseUnit{exponents}{offset}/></Unit>\n", escaped(name))
}

fn variable(version: Version, place: usize, of: &Variable, all: &[Variable]) -> String {
    let [causality, initial] = match of.role {
        Role::Time => ["independent", ""],
        // Of inputs the standard forbids to write it.
        Role::Input(_) => ["input", ""],
        Role::Output(_) => ["output", "calculated"],
        Role::State(_) => ["local", "exact"],
        Role::Rate(_) => ["local", "calculated"],
    };
    let mut common = format!(
        "name=\"{}\" valueReference=\"{place}\" description=\"{}\" causality=\"{causality}\" \
         variability=\"continuous\"",
        escaped(&of.name),
        escaped(&of.description)
    );
    if !initial.is_empty() {
        // Writing to a string cannot fail.
        let _ = write!(common, " initial=\"{initial}\"");
    }
    let mut real = String::new();
    let state = match of.role {
        Role::Rate(k) => all.iter().position(|other| other.role == Role::State(k)),
        _ => None,
    };
    let state = state.map(|state| match version {
        // Counted from one.
        Version::Two => (state + 1).to_string(),
        Version::Three => state.to_string(),
    });
    let number = |number: f64| format!("{number:?}");
    let attributes = [
        ("unit", Some(escaped(&of.unit)).filter(|unit| !unit.is_empty())),
        ("nominal", of.nominal.map(number)),
        ("start", of.start.map(number)),
        ("derivative", state),
    ];
    for (name, value) in attributes {
        if let Some(value) = value {
            let _ = write!(real, " {name}=\"{value}\"");
        }
    }
    match version {
        Version::Two => format!("<ScalarVariable {common}><Real{real}/></ScalarVariable>\n"),
        Version::Three => format!("<Float64 {common}{real}/>\n"),
    }
}

/// Outputs and rates, which depend on all inputs and states.
fn structure(version: Version, variables: &[Variable]) -> String {
    let places = |is_one: fn(Role) -> bool| -> Vec<usize> {
        let all = variables.iter().enumerate();
        all.filter(|(_, of)| is_one(of.role)).map(|(place, _)| place).collect()
    };
    let outputs = places(|role| matches!(role, Role::Output(_)));
    let rates = places(|role| matches!(role, Role::Rate(_)));
    let lists = [
        ("Output", &outputs),
        (if version == Version::Two { "Derivative" } else { "ContinuousStateDerivative" }, &rates),
        ("InitialUnknown", &[outputs.clone(), rates.clone()].concat()),
    ];
    let list = |(name, places): (&str, &Vec<usize>)| {
        let unknowns = places.iter().map(|place| match version {
            Version::Two => format!("<Unknown index=\"{}\"/>\n", place + 1),
            Version::Three => format!("<{name} valueReference=\"{place}\"/>\n"),
        });
        let unknowns = unknowns.collect::<Vec<_>>().concat();
        match version {
            Version::Two if !places.is_empty() => format!("<{name}s>\n{unknowns}</{name}s>\n"),
            Version::Two | Version::Three => unknowns,
        }
    };
    lists.map(list).concat()
}

/// As the value of an attribute.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '"' => escaped.push_str("&quot;"),
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
