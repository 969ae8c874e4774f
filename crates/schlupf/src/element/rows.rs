//! Many evaluations at once: the wheels of a train, the conditions of a table.

use crate::numerics::parallel;

use super::evaluation::{Evaluation, Status};
use super::held::Element;

/// Inputs and states of evaluations, one after the other.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a> {
    /// Inputs, each in the unit of its quantity.
    pub inputs: &'a [f64],
    /// States, each in the unit of its quantity.
    pub states: &'a [f64],
}

/// Room for what they find.
#[derive(Debug)]
pub struct Rows<'a> {
    /// Outputs, each in the unit of its quantity.
    pub outputs: &'a mut [f64],
    /// Rates of the states, each in the unit of its quantity over s.
    pub rates: &'a mut [f64],
    /// Derivatives, as those of an [`Evaluation`], each in the unit of the one over the unit of the
    /// other; none if they are not wanted.
    pub derivatives: Option<&'a mut [f64]>,
    /// What became of each.
    pub status: &'a mut [Status],
}

impl Rows<'_> {
    /// Those of the first evaluations, and the others; `widths` are the numbers of outputs, rates
    /// and derivatives of one.
    fn split(self, count: usize, widths: [usize; 3]) -> (Self, Self) {
        let [outputs, rates, derivatives] = widths.map(|width| count * width);
        let (outputs, later_outputs) = self.outputs.split_at_mut(outputs);
        let (rates, later_rates) = self.rates.split_at_mut(rates);
        let derivatives = self.derivatives.map(|all| all.split_at_mut(derivatives));
        let (derivatives, later_derivatives) = derivatives.unzip();
        let (status, later_status) = self.status.split_at_mut(count);
        (
            Self { outputs, rates, derivatives, status },
            Self {
                outputs: later_outputs,
                rates: later_rates,
                derivatives: later_derivatives,
                status: later_status,
            },
        )
    }

    fn put(&mut self, row: usize, found: &Evaluation) {
        let place = |all: &mut [f64], of: &[f64]| {
            all[row * of.len()..][..of.len()].copy_from_slice(of);
        };
        place(self.outputs, &found.outputs);
        place(self.rates, &found.rates);
        if let Some(derivatives) = &mut self.derivatives {
            place(derivatives, &found.derivatives);
        }
    }
}

impl Element {
    /// Evaluates rows of inputs and states. Blocks of rows run on all threads, each by an element
    /// of its own; a single block by this one. A block has 512 rows, 32 of FASTSIM, 16 of the full
    /// equations, however many threads there are.
    ///
    /// ```
    /// use schlupf::element::{Element, Given, Rows, Settings, Status};
    /// use schlupf::problem::{FastMethod, Method};
    /// use schlupf::{Options, Problem};
    ///
    /// let method = Method::Fast(FastMethod::ShenHedrickElkins);
    /// let method = (&method, &Options::default());
    /// let mut element = Element::new(&Problem::builder().build()?, method, Settings::default())?;
    /// let (width, mut status) = (element.outputs().len(), vec![Status::Found; 2]);
    /// let (mut outputs, mut rates) = (vec![0.0; 2 * width], vec![0.0; 2 * 3]);
    /// let inputs = [element.start(), element.start()].concat();
    /// let rows = Rows {
    ///     outputs: &mut outputs,
    ///     rates: &mut rates,
    ///     derivatives: None,
    ///     status: &mut status,
    /// };
    /// let given = Given { inputs: &inputs, states: &[0.0; 2 * 3] };
    /// assert_eq!(element.evaluate_rows(given, rows), Some(()));
    /// assert_eq!(outputs[0], outputs[width]);
    /// # Ok::<(), schlupf::Error>(())
    /// ```
    ///
    /// `None` if there are more or fewer numbers than as many rows as there are statuses have;
    /// nothing was done then.
    pub fn evaluate_rows(&mut self, given: Given, rows: Rows) -> Option<()> {
        let count = rows.status.len();
        let (inputs, states) = (self.inputs().len(), self.states().len());
        let outputs = self.outputs().len();
        let widths = [outputs, states, (outputs + states) * (inputs + states)];
        let derivatives = rows.derivatives.as_ref().map_or(count * widths[2], |all| all.len());
        let sizes = [given.inputs.len(), given.states.len(), rows.outputs.len(), rows.rates.len()];
        let needed = [inputs, states, outputs, states].map(|width| count * width);
        if sizes != needed || derivatives != count * widths[2] {
            return None;
        }
        let most = self.rows_in_turn();
        if count <= most {
            self.evaluate_block(given, rows);
            return Some(());
        }
        let (mut blocks, mut left, mut first) = (Vec::new(), rows, 0);
        while first < count {
            let size = most.min(count - first);
            let (block, later) = left.split(size, widths);
            let given = Given {
                inputs: &given.inputs[first * inputs..][..size * inputs],
                states: &given.states[first * states..][..size * states],
            };
            blocks.push((given, block));
            (left, first) = (later, first + size);
        }
        let own = &*self;
        parallel::map(blocks, |(given, block)| own.clone().evaluate_block(given, block));
        Some(())
    }

    fn evaluate_block(&mut self, given: Given, mut rows: Rows) {
        let (inputs, states) = (self.inputs().len(), self.states().len());
        let mut found = match rows.derivatives {
            Some(_) => self.evaluation(),
            None => self.evaluation_without_derivatives(),
        };
        for row in 0..rows.status.len() {
            let own = &given.inputs[row * inputs..][..inputs];
            let held = &given.states[row * states..][..states];
            rows.status[row] = self.evaluate(own, held, &mut found);
            rows.put(row, &found);
        }
    }
}
