//! Rolling under a pressure that was measured, on a lattice of 2 mm by 2 mm.

use schlupf::normal::{PressureTable, Tabulated};
use schlupf::{Options, Problem, solver, unwatched};

/// In MPa; rows across rolling, from right to left, each along rolling.
const PRESSURE: [[f64; 9]; 7] = [
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 210.0, 390.0, 440.0, 380.0, 220.0, 0.0, 0.0],
    [0.0, 290.0, 620.0, 780.0, 830.0, 790.0, 610.0, 300.0, 0.0],
    [0.0, 420.0, 730.0, 890.0, 960.0, 900.0, 720.0, 410.0, 0.0],
    [0.0, 260.0, 540.0, 700.0, 760.0, 710.0, 550.0, 270.0, 0.0],
    [0.0, 0.0, 130.0, 310.0, 360.0, 300.0, 140.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
];

/// In m.
const SPACING: f64 = 2e-3;

fn positions(count: usize) -> Vec<f64> {
    (0..count).map(|k| SPACING * k as f64).collect()
}

fn main() -> Result<(), schlupf::Error> {
    let pressure = PRESSURE.as_flattened().iter().map(|megapascal| 1e6 * megapascal).collect();
    let table = PressureTable::new(&positions(9), &positions(7), pressure)?;
    println!("load of the table  {:.1} kN", table.load() / 1e3);

    // Scaled to the load that was on the wheel.
    let normal = Tabulated::new(table, Some(90e3))?;
    let problem = Problem::builder().normal(normal).creepage_x(0.003).creepage_y(0.001).build()?;
    let solution = solver::solve(&problem, &Options::default(), &unwatched)?;
    println!("largest pressure   {:.0} MPa", solution.normal.peak_pressure / 1e6);
    println!("longitudinal       {:.2} kN", solution.force.x / 1e3);
    println!("lateral            {:.2} kN", solution.force.y / 1e3);
    Ok(())
}
