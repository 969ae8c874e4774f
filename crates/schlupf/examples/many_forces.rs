//! A million creep forces by a fast method, in blocks on all cores with the feature `rayon`; prints
//! the time in s of the fastest of some rounds.

use std::time::Instant;

use schlupf::bodies::Kinematics;
use schlupf::interface::friction::Constant;
use schlupf::numerics::parallel;
use schlupf::problem::{AreaReduction, FastMethod};
use schlupf::solution::Resultant;
use schlupf::solver::simplified::FastContact;
use schlupf::{Error, Options, Problem};

const COUNT: usize = 1_000_000;
const BLOCK: usize = 4096;
const ROUNDS: usize = 5;

/// Normal load, in N.
const LOAD: f64 = 80e3;

/// What acts on the wheel.
struct Acting {
    force: Resultant,
    coefficient: f64,
    is_beyond_friction: bool,
}

fn main() -> Result<(), Error> {
    let problem = Problem::builder().load(LOAD).friction(Constant::new(0.4)?).build()?;
    let own = problem.kinematics;
    let creepages: Vec<f64> = (0..COUNT).map(|k| 0.02 * k as f64 / COUNT as f64).collect();
    let mut fastest = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let blocks = creepages.chunks(BLOCK).collect();
        let forces: Vec<Vec<Acting>> = parallel::try_map(blocks, |block: &[f64]| {
            let method = FastMethod::Polach(AreaReduction::DRY);
            let mut contact = FastContact::new(&problem, method, &Options::default())?;
            let force = |creepage: &f64| {
                let force = contact.force(&Kinematics { creepage_x: *creepage, ..own })?;
                let is_beyond_friction = contact.is_beyond_friction(&force);
                Ok(Acting { coefficient: force.tangential() / LOAD, force, is_beyond_friction })
            };
            block.iter().map(force).collect::<Result<_, Error>>()
        })?;
        fastest = fastest.min(start.elapsed().as_secs_f64());
        // The wheel is braked.
        let is_braked = |one: &Acting| one.force.x < 0.0 && one.coefficient < 0.4;
        assert!(
            forces.iter().flatten().skip(1).all(|one| is_braked(one) && !one.is_beyond_friction)
        );
    }
    println!("{fastest}");
    Ok(())
}
