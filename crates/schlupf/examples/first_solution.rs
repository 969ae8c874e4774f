//! A braking wheel: forces, power and temperature of steady rolling.

use schlupf::{Options, Problem, solver, unwatched};

fn main() -> Result<(), schlupf::Error> {
    let problem = Problem::builder().load(80e3).speed(30.0).creepage_x(0.008).build()?;
    let solution = solver::solve(&problem, &Options::default(), &unwatched)?;
    println!("status            {}", solution.status.name());
    println!("longitudinal      {:.2} kN", solution.force.x / 1e3);
    println!("traction          {:.4} of the load", solution.traction_coefficient);
    if let (Some(power), Some(hottest)) = (solution.power, solution.temperature) {
        println!("friction power    {:.3} kW", power.friction / 1e3);
        println!("temperature rise  {:.1} K", hottest.max_rise);
    }
    Ok(())
}
