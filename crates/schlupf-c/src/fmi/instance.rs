//! An element as an FMU, whatever the version of the standard.

use std::path::Path;

use schlupf::element::{Element, Evaluation, Status};
use schlupf::{Warning, unwatched};
use schlupf_case::fmu::{Resources, Role, Variable, variables};

/// Why a function does not do its work.
#[derive(Debug)]
pub enum Failure {
    /// Nothing was found for these values; others may do.
    Discard(String),
    /// The call is wrong.
    Error(String),
}

/// A wrong call.
pub fn error<T>(message: impl Into<String>) -> Result<T, Failure> {
    Err(Failure::Error(message.into()))
}

/// What a call needs.
fn require(is_so: bool, message: &str) -> Result<(), Failure> {
    if is_so { Ok(()) } else { error(message) }
}

/// How an FMU is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    ModelExchange,
    CoSimulation,
}

/// What changes in a simulation, and can be restored.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Whether initialization is over.
    is_initialized: bool,
    /// In s.
    time: f64,
    inputs: Vec<f64>,
    states: Vec<f64>,
}

/// An element with its state.
#[derive(Debug)]
pub struct Instance {
    purpose: Use,
    variables: Vec<Variable>,
    element: Element,
    start: State,
    state: State,
    found: Evaluation,
    /// What was found for the state.
    status: Option<Status>,
}

impl Instance {
    /// From the resources of an FMU with this token.
    pub fn new(purpose: Use, folder: &Path, token: &str) -> Result<Self, String> {
        let resources = Resources::from_folder(folder).map_err(|error| error.to_string())?;
        let own = resources.token();
        if token != own {
            return Err(format!("the GUID or token must be {own}, but is {token}"));
        }
        let element = resources.element(&unwatched).map_err(|error| error.to_string())?;
        let start = State {
            is_initialized: false,
            time: 0.0,
            inputs: element.start(),
            states: vec![0.0; element.states().len()],
        };
        Ok(Self {
            purpose,
            variables: variables(&element),
            found: element.evaluation(),
            state: start.clone(),
            start,
            element,
            status: None,
        })
    }

    /// What its method neglects.
    pub fn warnings(&self) -> &[Warning] {
        self.element.warnings()
    }

    fn role(&self, reference: u32) -> Result<Role, Failure> {
        match self.variables.get(reference as usize) {
            Some(variable) => Ok(variable.role),
            None => error(format!("there is no variable with the value reference {reference}")),
        }
    }

    pub fn set_time(&mut self, time: f64) -> Result<(), Failure> {
        require(time.is_finite(), "the time must be finite")?;
        self.state.time = time;
        Ok(())
    }

    /// In s.
    pub fn time(&self) -> f64 {
        self.state.time
    }

    pub fn finish_initialization(&mut self) {
        self.state.is_initialized = true;
    }

    pub fn reset(&mut self) {
        self.state = self.start.clone();
        self.changed();
        self.element.forget();
    }

    pub fn get(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), Failure> {
        for (reference, value) in references.iter().zip(values) {
            *value = match self.role(*reference)? {
                Role::Time => self.state.time,
                Role::Input(k) => self.state.inputs[k],
                Role::State(k) => self.state.states[k],
                Role::Output(k) => self.evaluated()?.outputs[k],
                Role::Rate(k) => self.evaluated()?.rates[k],
            };
        }
        Ok(())
    }

    pub fn set(&mut self, references: &[u32], values: &[f64]) -> Result<(), Failure> {
        // First: a wrong reference does not undo what was set before it.
        self.changed();
        for (reference, value) in references.iter().zip(values) {
            let place = match self.role(*reference)? {
                Role::Input(k) => &mut self.state.inputs[k],
                Role::State(k) if !self.state.is_initialized => &mut self.state.states[k],
                _ => {
                    let name = &self.variables[*reference as usize].name;
                    return error(format!("{name} cannot be set here"));
                }
            };
            *place = *value;
        }
        Ok(())
    }

    fn changed(&mut self) {
        self.status = None;
    }

    fn evaluated(&mut self) -> Result<&Evaluation, Failure> {
        if self.status.is_none() {
            self.found = self.element.evaluation_without_derivatives();
        }
        self.find()
    }

    fn differentiated(&mut self) -> Result<&Evaluation, Failure> {
        if self.status.is_none() || self.found.derivatives.is_empty() {
            (self.found, self.status) = (self.element.evaluation(), None);
        }
        self.find()
    }

    fn find(&mut self) -> Result<&Evaluation, Failure> {
        let (element, State { inputs, states, .. }) = (&mut self.element, &self.state);
        let status =
            *self.status.get_or_insert_with(|| element.evaluate(inputs, states, &mut self.found));
        checked(status)?;
        Ok(&self.found)
    }

    /// One derivative of each unknown by each known times its seed, summed up over the others:
    /// over knowns for each unknown, or `transposed`.
    pub fn differentiate(
        &mut self,
        [unknowns, knowns]: [&[u32]; 2],
        seed: &[f64],
        (found, is_transposed): (&mut [f64], bool),
    ) -> Result<(), Failure> {
        let (outputs, inputs) = (self.element.outputs().len(), self.state.inputs.len());
        self.differentiated()?;
        found.fill(0.0);
        for (row, unknown) in unknowns.iter().enumerate() {
            let of = match self.role(*unknown)? {
                Role::Output(k) => k,
                Role::Rate(k) => outputs + k,
                _ => return error("unknowns must be outputs or rates of states"),
            };
            for (column, known) in knowns.iter().enumerate() {
                let by = match self.role(*known)? {
                    Role::Input(k) => k,
                    Role::State(k) => inputs + k,
                    _ => return error("knowns must be inputs or states"),
                };
                let (from, to) = if is_transposed { (row, column) } else { (column, row) };
                found[to] += self.found.derivative(of, by) * seed[from];
            }
        }
        Ok(())
    }

    /// Lets time pass from a time on (both in s), with constant inputs.
    pub fn step(&mut self, time: f64, duration: f64) -> Result<(), Failure> {
        let State { is_initialized, inputs, states, .. } = &mut self.state;
        let is_right = self.purpose == Use::CoSimulation && *is_initialized;
        require(is_right, "steps need co-simulation and the end of the initialization")?;
        let is_step = time.is_finite() && duration.is_finite() && duration >= 0.0;
        require(is_step, "a step must be finite and not negative")?;
        checked(self.element.advance(inputs, states, duration))?;
        self.state.time = time + duration;
        self.changed();
        Ok(())
    }

    pub fn number_of_states(&self) -> usize {
        self.state.states.len()
    }

    fn check_states(&self, count: usize) -> Result<(), Failure> {
        let states = self.number_of_states();
        require(count == states, &format!("there are {states} states, but {count} were named"))
    }

    pub fn set_states(&mut self, states: &[f64]) -> Result<(), Failure> {
        require(self.purpose == Use::ModelExchange, "states are set in model exchange only")?;
        self.check_states(states.len())?;
        self.state.states.copy_from_slice(states);
        self.changed();
        Ok(())
    }

    pub fn get_states(&self, states: &mut [f64]) -> Result<(), Failure> {
        self.check_states(states.len())?;
        states.copy_from_slice(&self.state.states);
        Ok(())
    }

    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Failure> {
        self.check_states(rates.len())?;
        rates.copy_from_slice(&self.evaluated()?.rates);
        Ok(())
    }

    pub fn nominals(&self, nominals: &mut [f64]) -> Result<(), Failure> {
        self.check_states(nominals.len())?;
        let all = self.variables.iter().filter_map(|variable| variable.nominal);
        nominals.iter_mut().zip(all).for_each(|(place, nominal)| *place = nominal);
        Ok(())
    }

    /// The state; what follows from it is the same, bit for bit, whenever it is restored.
    pub fn save(&mut self) -> State {
        self.changed();
        self.element.forget();
        self.state.clone()
    }

    pub fn restore(&mut self, state: &State) -> Result<(), Failure> {
        let is_own = state.inputs.len() == self.state.inputs.len()
            && state.states.len() == self.state.states.len();
        require(is_own, "the state is one of another FMU")?;
        self.state = state.clone();
        self.changed();
        self.element.forget();
        Ok(())
    }

    /// A state from its bytes.
    pub fn deserialized(&self, bytes: &[u8]) -> Result<State, Failure> {
        let (inputs, states) = (self.state.inputs.len(), self.state.states.len());
        let (words, rest) = bytes.as_chunks::<8>();
        let words: Vec<f64> = words.iter().map(|word| f64::from_le_bytes(*word)).collect();
        match words.as_slice() {
            [phase, time, values @ ..] if values.len() == inputs + states && rest.is_empty() => {
                let (inputs, states) = values.split_at(inputs);
                let is_initialized = *phase == 1.0;
                let (inputs, states) = (inputs.to_vec(), states.to_vec());
                Ok(State { is_initialized, time: *time, inputs, states })
            }
            _ => error("the bytes are not those of a state of this FMU"),
        }
    }
}

impl State {
    /// As bytes, the same on every platform.
    pub fn serialized(&self) -> Vec<u8> {
        let phase = f64::from(u8::from(self.is_initialized));
        let all = [phase, self.time].into_iter().chain(self.inputs.iter().copied());
        all.chain(self.states.iter().copied()).flat_map(f64::to_le_bytes).collect()
    }
}

fn checked(status: Status) -> Result<(), Failure> {
    let reason = match status {
        Status::Found | Status::NoContact | Status::OutsideTable => return Ok(()),
        Status::NotFinite => "an input or state is not finite",
        Status::NotConverged => "the solver did not converge",
        Status::WrongSize => return error("there are more or fewer inputs or states"),
    };
    Err(Failure::Discard(reason.to_owned()))
}
