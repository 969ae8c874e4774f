//! Time of the wheels of the Manchester benchmark, from profiles and position to forces.

use std::sync::Arc;
use std::time::Instant;

use schlupf::bodies::Body;
use schlupf::elasticity::HalfSpace;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::Heat;
use schlupf::interface::{ContactLaw, Incremental};
use schlupf::wheel_rail::{
    Deviation, Drive, Joining, Motion, NormalMethod, Pair, Position, ProfileCurve, RailShape,
    RowsMove, Side, Sides, Support, Tangential, Track, WheelOnRail, WheelShape,
};
use schlupf::{Options, Problem, Quantity, Status, unwatched};

/// Rounds of which the best counts.
const ROUNDS: usize = 3;

/// As Markdown.
pub fn table() -> String {
    let wheels = manchester();
    let stiff: ContactLaw = Incremental::new(1e8).unwrap().into();
    let laws = [("Coulomb", ContactLaw::Coulomb as ContactLaw), ("k_c = 1e8/m", stiff)];
    let mut lines = vec![format!(
        "{} wheels of the Manchester contact benchmark (S1002 on 60E1, 10 kN vertical force), search, \
         normal contact of 64² cells and friction of 24², one thread:\n\n\
         | law | heat | rounds | products | s | ms for a wheel |\n|---|---|--:|--:|--:|--:|",
        wheels.len()
    )];
    for (name, law) in &laws {
        for heat in [Heat::none(), Heat::default()] {
            let is_heated = heat.model.is_some();
            let mut best = f64::INFINITY;
            let mut work = [0.0; 2];
            for _ in 0..ROUNDS {
                let start = Instant::now();
                work = solve(&wheels, law, &heat);
                best = best.min(start.elapsed().as_secs_f64());
            }
            let count = wheels.len() as f64;
            lines.push(format!(
                "| {name} | {} | {:.1} | {:.1} | {best:.2} | {:.0} |",
                if is_heated { "yes" } else { "no" },
                work[0] / count,
                work[1] / count,
                1e3 * best / count
            ));
        }
    }
    lines.join("\n")
}

/// Rounds and products of all wheels.
fn solve(wheels: &[WheelOnRail], law: &ContactLaw, heat: &Heat) -> [f64; 2] {
    let elasticity = HalfSpace::new(&Body::STEEL.material, &Body::STEEL.material).unwrap();
    let builder = Problem::builder()
        .contact_law(*law)
        .friction(Constant::new(0.3).unwrap())
        .heat(heat.clone())
        .elasticity(elasticity);
    let options = Options::default();
    let interface = builder.build().unwrap().interface;
    let tangential = Tangential::new(&interface, &options);
    let mut work = [0.0; 2];
    for wheel in wheels {
        let solution = wheel.solve(&tangential, &unwatched).unwrap();
        assert_eq!(solution.status(), Status::Converged);
        work[0] += solution.rounds as f64;
        work[1] += solution.contacts.iter().map(|c| c.solution.work.operator_products).sum::<f64>();
    }
    work
}

/// Rows of a table in the data folder, as text.
fn rows(name: &str) -> Vec<Vec<String>> {
    let path = format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn curve(name: &str, quantity: Quantity) -> ProfileCurve {
    let number = |text: &String| 1e-3 * text.parse::<f64>().unwrap();
    let points: Vec<[f64; 2]> =
        rows(name).iter().map(|row| [number(&row[0]), -number(&row[1])]).collect();
    ProfileCurve::new(&points, 0.0, quantity).unwrap()
}

/// The wheels of all rows and of the states midway between them, turned into the frame of this
/// project.
fn manchester() -> Vec<WheelOnRail> {
    let wheel = WheelShape {
        profile: curve("profile_s1002.csv", Quantity::WheelProfile).into(),
        nominal_radius: 0.46,
        flange_back_position: -70e-3,
        deviation: Deviation::default(),
    };
    let profile = curve("profile_uic60_canted.csv", Quantity::RailProfile);
    let rail = RailShape::new(profile, 0.0);
    let pair = Arc::new(Pair::new(&wheel, &rail, &Track::default()).unwrap());
    let wheel = |is_left: bool, [y, yaw, roll, pitch_rate]: [f64; 4]| WheelOnRail {
        pairs: Sides::both(Arc::clone(&pair)),
        side: if is_left { Side::Left } else { Side::Right },
        position: Position { lateral: -1e-3 * y, yaw: -yaw, roll },
        motion: Motion::straight(2.0, -pitch_rate),
        follows: false,
        drive: Drive::AngularVelocity,
        support: Support::Force(10e3),
        joining: Joining::default(),
        rows: RowsMove::default(),
        friction_variation: None,
        normal_method: NormalMethod::HalfSpaces,
        cells: 64,
    };
    let given = rows("manchester_a22.csv");
    let numbers = |row: &[String]| [1, 2, 3, 4].map(|k| row[k].parse::<f64>().unwrap());
    let own = given.iter().map(|row| wheel(row[0] == "left", numbers(row)));
    let beside = given.windows(2).filter(|rows| rows[0][0] == rows[1][0]);
    let between = beside.map(|rows| {
        let [one, two] = [numbers(&rows[0]), numbers(&rows[1])];
        wheel(rows[0][0] == "left", std::array::from_fn(|k| 0.5 * (one[k] + two[k])))
    });
    own.chain(between).collect()
}
