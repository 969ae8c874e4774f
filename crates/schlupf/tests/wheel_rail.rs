//! Wheel on rail from two profiles and a position.

use std::sync::Arc;

use schlupf::elasticity::half_space::HalfSpace;
use schlupf::interface::contact_law::{Coulomb, Incremental, ContactLaw};
use schlupf::interface::friction::constant::Constant;
use schlupf::kinematics::{Kinematics, ReferencePoint};
use schlupf::material::{Body, Material, contact_modulus};
use schlupf::normal::PressureSource;
use schlupf::wheel_rail::{
    Joining, Motion, Pair, Position, ProfileCurve, RailShape, Side, Support, Tangential, Track,
    WheelOnRail, WheelShape, WheelSolution,
};
use schlupf::{Error, Method, Options, Problem, Quantity, unwatched};

/// A table of the data folder: its rows as text.
fn table(name: &str) -> Vec<Vec<String>> {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn profile(name: &str, quantity: Quantity) -> ProfileCurve {
    let number = |text: &String| text.parse::<f64>().unwrap();
    let points: Vec<[f64; 2]> =
        table(name).iter().map(|row| [1e-3 * number(&row[0]), -1e-3 * number(&row[1])]).collect();
    ProfileCurve::new(&points, 0.0, quantity).unwrap()
}

fn pair() -> Arc<Pair> {
    let wheel = WheelShape {
        profile: profile("profile_s1002.csv", Quantity::WheelProfile),
        nominal_radius: 0.46,
        flange_back_position: -70e-3,
    };
    let rail = RailShape { profile: profile("profile_uic60_canted.csv", Quantity::RailProfile), cant: 0.0 };
    Arc::new(Pair::new(&wheel, &rail, &Track::default()).unwrap())
}

fn solve(wheel: &WheelOnRail, law: &Arc<dyn ContactLaw>) -> Result<WheelSolution, Error> {
    let material = Material { young_modulus: 2.0 * 82e9 * 1.28, poisson_ratio: 0.28, ..Body::STEEL.material };
    let body = Body { material, ..Body::STEEL };
    let elasticity = HalfSpace::new(&material, &material).unwrap();
    let problem = |kinematics: Kinematics, normal: Arc<dyn PressureSource>| {
        let mut problem = Problem::builder()
            .wheel(body)
            .rail(body)
            .kinematics(kinematics)
            .reference(ReferencePoint::File)
            .friction(Constant::new(0.3)?)
            .heat(schlupf::heat::Heat::none())
            .elasticity(elasticity.clone())
            .build()?;
        problem.normal = normal;
        problem.contact_law = Arc::clone(law);
        Ok(problem)
    };
    let options = Options::default();
    let solver = |options: &Options| Method::Full.solver(options);
    let tangential = Tangential { problem: &problem, contact_modulus: contact_modulus(&material, &material), solver: &solver, options: &options };
    wheel.solve(&tangential, &unwatched)
}

#[test]
fn manchester_table() {
    let pair = pair();
    println!("rail origin {:?} wheel {}", pair.rail_origin(), pair.wheel_offset());
    let law: Arc<dyn ContactLaw> = match std::env::var("LAW").as_deref() {
        Ok("coulomb") => Arc::new(Coulomb),
        _ => Arc::new(Incremental::new(1e8).unwrap()),
    };
    for row in table("manchester_a22.csv") {
        let v: Vec<f64> = row.iter().skip(1).map(|t| t.parse().unwrap()).collect();
        let side = if row[0] == "left" { Side::Left } else { Side::Right };
        let wheel = WheelOnRail {
            pair: Arc::clone(&pair),
            side,
            position: Position { lateral: -1e-3 * v[0], yaw: -v[1], roll: v[2] },
            motion: Motion { speed: 2.0, lateral_velocity: 0.0, vertical_velocity: 0.0, angular_velocity: -v[3], roll_rate: 0.0, yaw_rate: 0.0 },
            support: Support::Force(1e4),
            joining: Joining::default(),
            cells: 64,
        };
        let start = std::time::Instant::now();
        let solution = match solve(&wheel, &law) { Ok(s) => s, Err(e) => { println!("{} {}: {e}", row[0], v[0]); continue } };
        let time = start.elapsed().as_secs_f64();
        let c = &solution.contacts[0];
        let s = &c.solution;
        let fn_ = s.normal.load;
        println!("{} {:4.1} n{} r{} z {:8.5} x {:8.5} y {:8.5} zc {:8.5} angle {:9.6} yr {:7.4} yw {:7.4} xi {:9.2e} eta {:9.2e} phi {:9.2e} Fn {:8.5} Fx {:8.5} Fs {:8.5} Mn {:8.3} app {:8.5} pmax {:8.5} time {:.3} {:?}",
            row[0], v[0], solution.contacts.len(), solution.rounds,
            1e3*solution.height + v[4], 1e3*c.position[0]-v[5], 1e3*c.position[1]+v[6], 1e3*c.position[2]+v[7], c.angle+v[8],
            1e3*c.rail_position - side.outwards()*-v[9], 1e3*c.wheel_position - side.outwards()*-v[10],
            s.kinematics.creepage_x+v[11], s.kinematics.creepage_y-v[12], 1e-3*s.kinematics.spin-v[13],
            fn_/v[14]-1.0, (-s.force.x-v[15])/(0.3*v[14]), (s.force.y-v[16])/(0.3*v[14]), 1e3*s.force.moment_z.unwrap()-v[17],
            1e3*s.normal.approach.unwrap()/v[18]-1.0, 1e-6*s.normal.peak_pressure/v[19]-1.0, time, s.status);
    }
}
