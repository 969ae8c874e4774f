//! What a simulator holds.

use crate::reporting::{Error, Warning};
use crate::{Method, Options, Problem};

use super::contact::Contact;
use super::evaluation::{Evaluation, Status};
use super::law::FAST_ROWS;
use super::settings::Settings;
use super::signals::Signal;
use super::wheel::{Wheel, WheelParts};

/// A contact, or a wheel on a rail, as a function of inputs and states. Clones are independent;
/// that of a solver has solved nothing yet.
#[derive(Debug, Clone)]
pub struct Element {
    kind: Kind,
    inputs: Vec<Signal>,
    outputs: Vec<Signal>,
    states: Vec<Signal>,
}

#[derive(Debug, Clone)]
enum Kind {
    Contact(Box<Contact>),
    Wheel(Box<Wheel>),
}

impl Element {
    /// An element for the contact of a problem, whose motion and load are those of
    /// [`Self::start`], by a method.
    ///
    /// ```
    /// use schlupf::element::{Element, Settings};
    /// use schlupf::problem::{FastMethod, Method};
    /// use schlupf::{Options, Problem};
    ///
    /// let problem = Problem::builder().load(80e3).creepage_x(0.001).build()?;
    /// let method = Method::Fast(FastMethod::ShenHedrickElkins);
    /// let method = (&method, &Options::default());
    /// let mut element = Element::new(&problem, method, Settings::default())?;
    /// let mut found = element.evaluation();
    /// // Steady rolling is reached within a second.
    /// let (mut inputs, mut states) = (element.start(), [0.0; 3]);
    /// element.advance(&inputs, &mut states, 1.0);
    /// element.evaluate(&inputs, &states, &mut found);
    /// // Fx and its slope by the first elastic shift, after eight inputs.
    /// assert!(found.outputs[0] < 0.0 && found.derivative(0, 8) < 0.0);
    /// // The wheel lifts off.
    /// inputs[4] = 0.0;
    /// element.evaluate(&inputs, &states, &mut found);
    /// assert_eq!(found.outputs[0], 0.0);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// # Errors
    /// Whatever the problem and the method reject, viscoelastic bodies, a patch whose shape changes
    /// with the load, and an approach as an input where the normal contact has none.
    pub fn new(
        problem: &Problem,
        method: (&Method, &Options),
        settings: Settings,
    ) -> Result<Self, Error> {
        let contact = Contact::new(problem, method, settings)?;
        let signals = contact.signals();
        let (inputs, outputs) = (signals.inputs.clone(), signals.outputs.clone());
        let states = signals.states.clone();
        Ok(Self { kind: Kind::Contact(Box::new(contact)), inputs, outputs, states })
    }

    /// An element for a wheel on a rail, by a fast method without fields. It has no memory, and its
    /// rolling radius follows from its contacts.
    ///
    /// # Errors
    /// A method with fields, and bodies that a method rejects.
    pub fn of_wheel(parts: WheelParts, method: &Method, settings: Settings) -> Result<Self, Error> {
        let wheel = Wheel::new(parts, method, settings)?;
        let inputs = Wheel::inputs();
        let outputs = wheel.outputs();
        Ok(Self { kind: Kind::Wheel(Box::new(wheel)), inputs, outputs, states: Vec::new() })
    }

    /// Its inputs, in their order.
    pub fn inputs(&self) -> &[Signal] {
        &self.inputs
    }

    /// Its outputs, in their order.
    pub fn outputs(&self) -> &[Signal] {
        &self.outputs
    }

    /// Its states, in their order: none without memory.
    pub fn states(&self) -> &[Signal] {
        &self.states
    }

    /// What the inputs are in the problem, each in the unit of its quantity.
    pub fn start(&self) -> Vec<f64> {
        match &self.kind {
            Kind::Contact(contact) => contact.start(),
            Kind::Wheel(wheel) => wheel.start(),
        }
    }

    /// What its method neglects at the load of its problem.
    ///
    /// ```
    /// use schlupf::element::{Element, Settings};
    /// use schlupf::problem::{FastMethod, Method};
    /// use schlupf::{Options, Problem};
    ///
    /// // Friction falls with the temperature of the contact, which the method does not find.
    /// let problem = Problem::builder().load(80e3).build()?;
    /// let method = Method::Fast(FastMethod::ShenHedrickElkins);
    /// let element = Element::new(&problem, (&method, &Options::default()), Settings::default())?;
    /// assert_eq!(element.warnings()[0].code(), "cold-friction");
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    pub fn warnings(&self) -> &[Warning] {
        match &self.kind {
            Kind::Contact(contact) => &contact.warnings,
            Kind::Wheel(wheel) => &wheel.warnings,
        }
    }

    /// Room for what [`Self::evaluate`] finds.
    pub fn evaluation(&self) -> Evaluation {
        Evaluation::new(self.counts())
    }

    /// The same without derivatives, which then are not computed.
    pub fn evaluation_without_derivatives(&self) -> Evaluation {
        self.evaluation().without_derivatives()
    }

    fn counts(&self) -> [usize; 3] {
        [self.inputs.len(), self.outputs.len(), self.states.len()]
    }

    fn takes(&self, inputs: &[f64], states: &[f64]) -> bool {
        inputs.len() == self.inputs.len() && states.len() == self.states.len()
    }

    /// Finds outputs, rates and derivatives. Fast methods without fields allocate nothing. A solver
    /// starts from what it found last, which changes the result within its tolerance only.
    pub fn evaluate(&mut self, inputs: &[f64], states: &[f64], found: &mut Evaluation) -> Status {
        if !self.takes(inputs, states) || !found.fits(self.counts()) {
            return Status::WrongSize;
        }
        match &mut self.kind {
            Kind::Contact(contact) => contact.evaluate(inputs, states, found),
            Kind::Wheel(wheel) => wheel.evaluate(inputs, found),
        }
    }

    /// Rows that one element evaluates in turn.
    pub(super) fn rows_in_turn(&self) -> usize {
        match &self.kind {
            Kind::Contact(contact) => contact.rows_in_turn(),
            Kind::Wheel(_) => FAST_ROWS,
        }
    }

    /// Forgets what a solver found, from which it would start.
    pub fn forget(&mut self) {
        if let Kind::Contact(contact) = &mut self.kind {
            contact.forget();
        }
    }

    /// The states after a time (in s) with constant inputs.
    ///
    /// The error is of second order in sub-steps of its own, which do not depend on the duration,
    /// so that none is too long.
    pub fn advance(&self, inputs: &[f64], states: &mut [f64], duration: f64) -> Status {
        if !self.takes(inputs, states) {
            return Status::WrongSize;
        }
        match &self.kind {
            Kind::Contact(contact) => contact.advance(inputs, states, duration),
            Kind::Wheel(_) => Status::of_inputs(inputs),
        }
    }
}
