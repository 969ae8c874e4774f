use schlupf::interface::contact_law::*;
use schlupf::normal::ellipse::Ellipse;
use schlupf::*;
use std::sync::Arc;
fn main() {
    let k: f64 = std::env::args().nth(1).unwrap().parse().unwrap();
    for (name, xi, eta, spin) in [
        ("xi", 0.001, 0.0, 0.0),
        ("xi2", 0.002, 0.0, 0.0),
        ("eta", 0.0, 0.001, 0.0),
        ("spin", 0.0, 0.0, 0.5),
    ] {
        for total in [true, false] {
            let mut row = String::new();
            for cells in [10, 20, 40, 80, 120] {
                let mut problem =
                    Problem::builder().creepage_x(xi).creepage_y(eta).spin(spin).build().unwrap();
                problem.normal = Arc::new(Ellipse::from_peak_pressure(0.005, 0.005, 1e9).unwrap());
                let m = material::Material {
                    young_modulus: 210e9,
                    poisson_ratio: 0.28,
                    ..material::Material::STEEL
                };
                problem.elasticity =
                    Arc::new(elasticity::half_space::HalfSpace::new(&m, &m).unwrap());
                problem.contact_law = if total {
                    TotalDisplacement::new(k).unwrap().into()
                } else {
                    Incremental::new(k).unwrap().into()
                };
                problem.friction = interface::friction::Friction::new(
                    Arc::new(interface::friction::constant::Constant::new(0.3).unwrap()),
                    20.0,
                );
                problem.heat.model = None;
                let options = Options { cells_x: cells, cells_y: cells, ..Options::default() };
                let s = rolling::steady::solve(&problem, &options, &unwatched).unwrap();
                row += &format!(" {:9.5}", 100.0 * (s.normalised.x + s.normalised.y));
            }
            println!("{name:5} {} {row}", if total { "total" } else { "incr " });
        }
    }
}
