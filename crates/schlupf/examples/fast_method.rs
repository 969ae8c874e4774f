//! Forces for a multibody code: Polach's method, set up once, then a tenth of a microsecond a
//! motion.

use schlupf::problem::{AreaReduction, FastMethod};
use schlupf::solver::simplified::FastContact;
use schlupf::{Error, Options, Problem};

fn main() -> Result<(), Error> {
    let problem = Problem::builder().load(80e3).build()?;
    let method = FastMethod::Polach(AreaReduction::DRY);
    let mut contact = FastContact::new(&problem, method, &Options::default())?;

    println!("time (s)  load (kN)  Fx (kN)  Fy (kN)");
    let mut motion = problem.kinematics;
    for step in 0..=10 {
        let time = 0.01 * f64::from(step);
        motion.creepage_x = 0.02 * time;
        motion.creepage_y = 0.001 * (20.0 * time).sin();
        let load = 80e3 + 5e3 * (50.0 * time).sin();
        contact.set_load(load)?;
        let force = contact.force(&motion)?;
        println!("{time:8.2}  {:9.2}  {:7.3}  {:7.3}", load / 1e3, force.x / 1e3, force.y / 1e3);
    }
    Ok(())
}
