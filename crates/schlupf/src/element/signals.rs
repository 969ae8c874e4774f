//! What goes into an element and comes out of it, each as a quantity of the registry.

use crate::problem::Problem;
use crate::reporting::Quantity;

use super::law::Law;
use super::patch::Patches;
use super::settings::{Motion, Normal, Settings};

/// An input, output or state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signal {
    /// What it is, and its unit.
    pub quantity: Quantity,
    /// Of which contact of a wheel it is, from 1 on, if it is of one.
    pub contact: Option<usize>,
    name: String,
}

impl Signal {
    /// A quantity of the whole, or of one contact of a wheel.
    pub fn new(quantity: Quantity, contact: Option<usize>) -> Self {
        let name = match contact {
            None => quantity.name().to_owned(),
            Some(contact) => format!("contact_{contact}.{}", quantity.name()),
        };
        Self { quantity, contact, name }
    }

    /// Its name, the same in every version.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// SI unit, temperatures in degC; empty if dimensionless.
    pub fn unit(&self) -> &'static str {
        self.quantity.unit()
    }

    /// Short description.
    pub fn description(&self) -> String {
        let description = self.quantity.description();
        match self.contact {
            None => description.to_owned(),
            Some(contact) => format!("{description}, contact {contact} from the field side"),
        }
    }
}

impl From<Quantity> for Signal {
    fn from(quantity: Quantity) -> Self {
        Self::new(quantity, None)
    }
}

impl PartialEq<Quantity> for Signal {
    /// Whether it is that quantity as a whole, not of one of several contacts.
    fn eq(&self, quantity: &Quantity) -> bool {
        self.contact.is_none() && self.quantity == *quantity
    }
}

/// Number of inputs, and of states with memory.
pub(super) const INPUTS: usize = 8;
pub(super) const STATES: usize = 3;

/// The input that presses the wheel on the rail, and the factor of friction, before the bulk
/// temperatures.
pub(super) const NORMAL: usize = 4;
pub(super) const FACTOR: usize = 5;

/// Most columns of the derivatives.
pub(super) const VARIABLES: usize = INPUTS + STATES;

/// All outputs, in the order in which an element finds them.
pub(super) const OUTPUTS: [Quantity; 10] = [
    Quantity::ForceX,
    Quantity::ForceY,
    Quantity::MomentZ,
    Quantity::Load,
    Quantity::Approach,
    Quantity::SemiAxisX,
    Quantity::SemiAxisY,
    Quantity::Friction,
    Quantity::CreepPower,
    Quantity::MaxRise,
];

/// Inputs, outputs and states of an element.
#[derive(Debug, Clone)]
pub(super) struct Signals {
    pub inputs: Vec<Signal>,
    pub outputs: Vec<Signal>,
    /// The place of each of them among all.
    pub places: Vec<usize>,
    pub states: Vec<Signal>,
}

impl Signals {
    pub fn new(settings: &Settings, law: &Law, [has_approach, has_heat]: [bool; 2]) -> Self {
        let motion = match settings.motion {
            Motion::Creepages => {
                [Quantity::CreepageX, Quantity::CreepageY, Quantity::Spin, Quantity::Speed]
            }
            Motion::Velocities => [
                Quantity::VelocityX,
                Quantity::VelocityY,
                Quantity::SpinRate,
                Quantity::AngularVelocity,
            ],
        };
        let normal = match settings.normal {
            Normal::Load => Quantity::Load,
            Normal::Approach => Quantity::Approach,
        };
        let [x, y, spin, last] = motion;
        let inputs = [
            x,
            y,
            spin,
            last,
            normal,
            Quantity::FrictionFactor,
            Quantity::WheelBulkTemperature,
            Quantity::RailBulkTemperature,
        ]
        .map(Signal::from)
        .to_vec();
        let is_known = |place: &usize| match OUTPUTS[*place] {
            Quantity::MomentZ => law.has_moment(),
            Quantity::Approach => has_approach,
            Quantity::MaxRise => has_heat,
            _ => true,
        };
        let places: Vec<usize> = (0..OUTPUTS.len()).filter(is_known).collect();
        let outputs = places.iter().map(|place| OUTPUTS[*place].into()).collect();
        let states = [Quantity::ElasticShiftX, Quantity::ElasticShiftY, Quantity::ElasticTurn];
        let states =
            if settings.has_memory { states.map(Signal::from).to_vec() } else { Vec::new() };
        Self { inputs, outputs, places, states }
    }
}

/// The inputs of a problem.
pub(super) fn start(problem: &Problem, settings: &Settings, patches: &Patches) -> Vec<f64> {
    let kinematics = &problem.kinematics;
    let ([xi, eta, spin], speed) = (kinematics.creepages(), kinematics.speed);
    let [x, y, turning, last] = match settings.motion {
        Motion::Creepages => [xi, eta, spin, speed],
        Motion::Velocities => {
            [speed, speed * eta, speed * spin, speed * (1.0 - xi) / settings.rolling_radius]
        }
    };
    let [wheel, rail] = [&problem.interface.wheel, &problem.interface.rail];
    let normal = patches.start(settings.normal);
    vec![x, y, turning, last, normal, 1.0, wheel.bulk_temperature, rail.bulk_temperature]
}
