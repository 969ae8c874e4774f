//! What an element finds.

use crate::numerics::dual::Dual;

/// Whether all numbers are finite: 0 times them is 0, for several at once, where a branch for each
/// would take a quarter of a fast evaluation.
fn are_finite(numbers: &[f64]) -> bool {
    let (chunks, rest) = numbers.as_chunks::<4>();
    let mut zeros = [0.0; 4];
    for chunk in chunks {
        for (zero, number) in zeros.iter_mut().zip(chunk) {
            *zero += 0.0 * number;
        }
    }
    zeros.iter().chain(rest).all(|number| number.is_finite())
}

/// What became of an evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Status {
    /// Forces were found.
    #[default]
    Found,
    /// The wheel does not touch the rail: there are no forces.
    NoContact,
    /// An input or state is not finite, or too large; nor are the outputs.
    NotFinite,
    /// A solver did not find the state; the outputs are not finite.
    NotConverged,
    /// There are more or fewer inputs or states than the element has, or the room is that of
    /// another element; nothing was done.
    WrongSize,
    /// Forces were found, with contacts beyond the table of the wheel.
    OutsideTable,
}

impl Status {
    /// All of them: the place of each is its number in arrays.
    pub const ALL: [Self; 6] = [
        Self::Found,
        Self::NoContact,
        Self::NotFinite,
        Self::NotConverged,
        Self::WrongSize,
        Self::OutsideTable,
    ];

    /// Whether inputs are finite.
    pub(super) fn of_inputs(inputs: &[f64]) -> Self {
        if inputs.iter().all(|input| input.is_finite()) { Self::Found } else { Self::NotFinite }
    }

    /// Its name: words that stay the same in every version.
    pub fn name(self) -> &'static str {
        match self {
            Self::Found => "found",
            Self::NoContact => "no-contact",
            Self::NotFinite => "not-finite",
            Self::NotConverged => "not-converged",
            Self::WrongSize => "wrong-size",
            Self::OutsideTable => "outside-table",
        }
    }
}

/// Outputs, rates of the states, and all derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation {
    /// Outputs, each in the unit of its quantity.
    pub outputs: Vec<f64>,
    /// Rates of the states, each in the unit of its quantity over s.
    pub rates: Vec<f64>,
    /// Derivatives of outputs and rates, a row each, with respect to inputs and states, each in the
    /// unit of the one over the unit of the other.
    pub derivatives: Vec<f64>,
    columns: usize,
}

impl Evaluation {
    /// For so many inputs, outputs and states.
    pub(super) fn new([inputs, outputs, states]: [usize; 3]) -> Self {
        let columns = inputs + states;
        Self {
            outputs: vec![0.0; outputs],
            rates: vec![0.0; states],
            derivatives: vec![0.0; (outputs + states) * columns],
            columns,
        }
    }

    /// Whether there is room for so many inputs, outputs and states.
    pub(super) fn fits(&self, [inputs, outputs, states]: [usize; 3]) -> bool {
        let derivatives = (outputs + states) * (inputs + states);
        self.outputs.len() == outputs
            && self.rates.len() == states
            && (self.derivatives.is_empty() || self.derivatives.len() == derivatives)
    }

    /// Whether so many outputs are finite, with their derivatives, and all rates.
    pub(super) fn is_finite(&self, outputs: usize) -> bool {
        let rows =
            if self.rates.is_empty() { outputs } else { self.outputs.len() + self.rates.len() };
        let derivatives = (rows * self.columns).min(self.derivatives.len());
        let all: [&[f64]; 3] =
            [&self.outputs[..outputs], &self.rates, &self.derivatives[..derivatives]];
        all.into_iter().all(are_finite)
    }

    pub(super) fn without_derivatives(self) -> Self {
        Self { derivatives: Vec::new(), ..self }
    }

    /// The derivative of an output or, after them, a rate with respect to an input or, after them,
    /// a state, in the unit of the one over the unit of the other; not a number if there is none.
    pub fn derivative(&self, of: usize, by: usize) -> f64 {
        let row = self.derivatives.chunks_exact(self.columns).nth(of);
        row.and_then(|row| row.get(by)).copied().unwrap_or(f64::NAN)
    }

    /// An output with its derivatives with respect to all inputs, in the units of [`Self`].
    pub(super) fn put(&mut self, row: usize, value: f64, slopes: &[f64]) {
        self.outputs[row] = value;
        if !self.derivatives.is_empty() {
            self.derivatives[row * self.columns..][..self.columns].copy_from_slice(slopes);
        }
    }

    /// Outputs from a row on are zero.
    pub(super) fn clear(&mut self, row: usize) {
        self.outputs[row..].fill(0.0);
        if !self.derivatives.is_empty() {
            let end = self.outputs.len() * self.columns;
            self.derivatives[row * self.columns..end].fill(0.0);
        }
    }

    pub(super) fn set<const N: usize>(&mut self, row: usize, found: &Dual<N>) {
        let outputs = self.outputs.len();
        match self.rates.get_mut(row.wrapping_sub(outputs)) {
            Some(rate) => *rate = found.value,
            None => self.outputs[row] = found.value,
        }
        // N is zero without derivatives.
        self.derivatives[row * N..][..N].copy_from_slice(&found.slopes);
    }

    pub(super) fn fill(&mut self, value: f64) {
        for part in [&mut self.outputs, &mut self.rates, &mut self.derivatives] {
            part.fill(value);
        }
    }
}
