//! Creep curves at several speeds, each on a thread of its own with the feature `rayon`.

use schlupf::analysis::creep_curve::{Creepages, Path, Sampling, trace};
use schlupf::numerics::parallel;
use schlupf::solver::SteadySolver;
use schlupf::{Error, Options, Problem, unwatched};

fn main() -> Result<(), Error> {
    let standstill = Creepages { x: 0.0, y: 0.0, spin: 0.0 };
    let path = Path::new(standstill, Creepages { x: 0.05, ..standstill })?;
    let sampling = Sampling::Refined(11);
    let options = Options { cells_x: 16, cells_y: 16, ..Options::default() };

    let speeds = [10.0, 20.0, 40.0];
    let curves = parallel::try_map(speeds.to_vec(), |speed| {
        let problem = Problem::builder().speed(speed).build()?;
        let mut solver = SteadySolver::new(&options);
        trace(&mut solver, &problem, &path, &sampling, &unwatched)
    })?;

    for (speed, curve) in speeds.iter().zip(&curves) {
        println!("{speed} m/s\n  creepage_x   |F|/N   rise (K)");
        for point in &curve.points {
            let (creepage, traction) = (point.abscissa, point.traction_coefficient);
            let rise = point.max_rise.unwrap_or(0.0);
            println!("  {creepage:10.6}  {traction:.4}  {rise:9.2}");
        }
        if let Some(maximum) = curve.maximum() {
            println!("  largest traction {:.4}", maximum.traction_coefficient);
        }
    }
    Ok(())
}
