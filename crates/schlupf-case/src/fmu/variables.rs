//! The variables of a force element.

use schlupf::Quantity;
use schlupf::element::{Element, Signal};

/// What a variable is of an element, by its place there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The time.
    Time,
    /// An input.
    Input(usize),
    /// An output.
    Output(usize),
    /// A state.
    State(usize),
    /// The rate of a state.
    Rate(usize),
}

/// A variable; its value reference is its place among all.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// What it is.
    pub role: Role,
    /// Its name.
    pub name: String,
    /// Short description.
    pub description: String,
    /// SI unit, temperatures in degC; empty if dimensionless.
    pub unit: String,
    /// Value at the start, in that unit, where it is given.
    pub start: Option<f64>,
    /// How large it is as a rule, in that unit, where that is known.
    pub nominal: Option<f64>,
}

/// All variables of an element: time, inputs, outputs that are no inputs, states and their rates.
pub fn variables(element: &Element) -> Vec<Variable> {
    let inputs = element.inputs();
    let given = element.start();
    let nominals = nominals(element);
    let mut all = vec![Variable::new(Role::Time, &Quantity::Time.into())];
    all.extend(inputs.iter().zip(given).enumerate().map(|(k, (of, start))| Variable {
        start: Some(start),
        ..Variable::new(Role::Input(k), of)
    }));
    let outputs = element.outputs().iter().enumerate();
    let own = outputs.filter(|(_, of)| !inputs.contains(of));
    all.extend(own.map(|(k, of)| Variable::new(Role::Output(k), of)));
    let states = element.states();
    all.extend(states.iter().zip(nominals).enumerate().map(|(k, (of, nominal))| Variable {
        start: Some(0.0),
        nominal: Some(nominal),
        ..Variable::new(Role::State(k), of)
    }));
    all.extend(states.iter().enumerate().map(|(k, of)| Variable::rate(k, of)));
    all
}

impl Variable {
    fn new(role: Role, of: &Signal) -> Self {
        Self {
            role,
            name: of.name().to_owned(),
            description: of.description(),
            unit: of.unit().to_owned(),
            start: None,
            nominal: None,
        }
    }

    fn rate(place: usize, of: &Signal) -> Self {
        let unit = of.unit();
        let unit = if unit.is_empty() { "1" } else { unit };
        Self {
            name: format!("der({})", of.name()),
            description: format!("rate of the {}", of.description()),
            unit: format!("{unit}/s"),
            ..Self::new(Role::Rate(place), of)
        }
    }
}

/// The elastic shifts at which the force of the linear theory is μN, as at the start.
fn nominals(element: &Element) -> Vec<f64> {
    let (inputs, states) = (element.inputs().len(), element.states().len());
    let mut element = element.clone();
    let mut found = element.evaluation();
    element.evaluate(&element.start(), &vec![0.0; states], &mut found);
    let row = |of: Quantity| element.outputs().iter().position(|output| *output == of);
    let value = |of: Quantity| row(of).map_or(f64::NAN, |row| found.outputs[row]);
    let limit = value(Quantity::Friction) * value(Quantity::Load);
    let forces = [Quantity::ForceX, Quantity::ForceY].map(row);
    let nominal = |state: usize| {
        let slopes = forces.iter().flatten().map(|row| found.derivative(*row, inputs + state));
        let nominal = limit / slopes.fold(0.0, |most: f64, slope| most.max(slope.abs()));
        if nominal.is_finite() && nominal > 0.0 { nominal } else { 1.0 }
    };
    (0..states).map(nominal).collect()
}
