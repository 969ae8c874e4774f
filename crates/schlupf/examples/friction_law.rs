//! A friction law of one's own: μ = μ0/(1 + (s/s0)²), which falls with the slip speed s.

use schlupf::interface::friction::{FrictionLaw, FrictionResponse, FrictionState};
use schlupf::solver;
use schlupf::{Options, Problem, unwatched};

/// Falls to half of μ0 at the slip speed s0.
#[derive(Debug)]
struct Falling {
    /// μ0, dimensionless.
    coefficient: f64,
    /// s0, in m/s.
    half_speed: f64,
}

impl FrictionLaw for Falling {
    fn respond(&self, state: &FrictionState) -> FrictionResponse {
        let ratio = state.slip_speed / self.half_speed;
        let part = 1.0 / (1.0 + ratio * ratio);
        FrictionResponse {
            coefficient: self.coefficient * part,
            by_slip_speed: -2.0 * self.coefficient * part * part * ratio / self.half_speed,
            by_cold_coefficient: part,
            ..FrictionResponse::default()
        }
    }
}

fn main() -> Result<(), schlupf::Error> {
    println!("creepage_x   |F|/N");
    for creepage in [0.001, 0.002, 0.005, 0.01, 0.02, 0.05] {
        let law = Falling { coefficient: 0.4, half_speed: 3.0 };
        let problem = Problem::builder().creepage_x(creepage).friction(law).build()?;
        let solution = solver::solve(&problem, &Options::default(), &unwatched)?;
        println!("{creepage:10}   {:.4}", solution.traction_coefficient);
        for warning in &solution.warnings {
            println!("  {warning}");
        }
    }
    Ok(())
}
