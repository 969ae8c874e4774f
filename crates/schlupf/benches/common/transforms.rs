//! The fast transforms of one product alone: the floor of its time.

use std::sync::Arc;

use rustdct::{DctPlanner, TransformType2And3};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use schlupf::elasticity::half_space::Convolution;

use super::{Bodies, Case, elastic_layer};

/// The transforms of one product, on lines of the same lengths and numbers. Zeros take as long as
/// anything else.
pub enum Transforms {
    /// DCT-II and DCT-III of each row, for both components.
    Layer { plan: Arc<dyn TransformType2And3<f64>>, lines: Vec<f64>, scratch: Vec<f64> },
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
                let plan = DctPlanner::new().plan_dct2(columns);
                let scratch = vec![0.0; plan.get_scratch_len()];
                Self::Layer { plan, lines: vec![0.0; 2 * columns * grid.rows], scratch }
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
            Self::Layer { plan, lines, scratch } => {
                for line in lines.chunks_exact_mut(plan.len()) {
                    plan.process_dct2_with_scratch(line, scratch);
                    plan.process_dct3_with_scratch(line, scratch);
                }
            }
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
