//! The fast transforms of one product alone: the floor of its time.

use std::sync::Arc;

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use schlupf::elasticity::Convolution;

use super::{Bodies, Case, elastic_layer};

/// The transforms of one product, on lines of the same lengths and numbers. Zeros take as long as
/// anything else.
pub enum Transforms {
    /// FFT of each row, for both components at once; and back.
    Layer(Pass),
    /// FFT of each row that the grid has, then of each column of the padded grid; and back.
    HalfSpace { along: Pass, across: Pass },
}

/// Transforms of equal lines, to wave numbers and back.
pub struct Pass {
    plans: [Arc<dyn Fft<f64>>; 2],
    lines: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Transforms {
    pub fn new(case: &Case) -> Self {
        let grid = case.grid();
        match case.bodies {
            Bodies::Layer => {
                let columns = elastic_layer().surroundings(&grid).unwrap().columns;
                Self::Layer(Pass::new(columns, grid.rows))
            }
            Bodies::HalfSpace => {
                let [columns, rows] = Convolution::new(&grid, |_, _| [0.0; 3]).padded_size();
                let along = Pass::new(columns, grid.rows);
                Self::HalfSpace { along, across: Pass::new(rows, columns) }
            }
        }
    }

    pub fn run(&mut self) {
        match self {
            Self::Layer(pass) => pass.run(),
            Self::HalfSpace { along, across } => {
                along.run();
                across.run();
            }
        }
    }
}

impl Pass {
    fn new(length: usize, count: usize) -> Self {
        let mut planner = FftPlanner::new();
        let plans = [planner.plan_fft_forward(length), planner.plan_fft_inverse(length)];
        let scratch = plans.iter().map(|plan| plan.get_inplace_scratch_len()).max().unwrap();
        let zero = Complex::new(0.0, 0.0);
        Self { plans, lines: vec![zero; length * count], scratch: vec![zero; scratch] }
    }

    fn run(&mut self) {
        for plan in &self.plans {
            plan.process_with_scratch(&mut self.lines, &mut self.scratch);
        }
    }
}
