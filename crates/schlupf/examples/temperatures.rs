//! Temperatures below the contact and behind it, and how warm the wheel gets when it brakes for
//! long.

use schlupf::analysis::bulk_temperature::{Cooling, bulk_temperature};
use schlupf::analysis::temperature_field::{Side, TemperatureField};
use schlupf::solver::SteadySolver;
use schlupf::{Options, Problem, Solver, unwatched};

fn main() -> Result<(), schlupf::Error> {
    let problem = Problem::builder().speed(30.0).creepage_x(0.008).build()?;
    let mut solver = SteadySolver::new(&Options::default());
    let solution = solver.solve(&problem, &unwatched)?;

    let hottest = solution.temperature.unwrap_or_default();
    println!("{:.1} degC on the wheel at x = {:.2} mm", hottest.max_wheel, 1e3 * hottest.x);
    let field = TemperatureField::new(&problem, &solution)?;
    for micrometres in [0.0, 20.0, 50.0, 100.0, 200.0] {
        let depth = 1e-6 * micrometres;
        let below = field.at(Side::Wheel, hottest.x, hottest.y, depth);
        println!("  {micrometres:5} um below  {below:7.2} degC");
    }
    for millimetres in [10.0, 20.0, 50.0, 100.0] {
        let behind = field.at(Side::Rail, -1e-3 * millimetres, hottest.y, 0.0);
        println!("  {millimetres:5} mm behind {behind:7.2} degC");
    }

    let cooling = Cooling { film_coefficient: 40.0, area: 1.5, air_temperature: 20.0 };
    let balance = bulk_temperature(&problem, &mut solver, &cooling, &unwatched)?;
    println!("in the long run the wheel has {:.1} degC", balance.temperature);
    println!("  {:7.1} W of friction", balance.frictional_heat);
    println!("  {:7.1} W to the air", balance.convection);
    println!("  {:7.1} W to the rail", balance.conduction);
    Ok(())
}
