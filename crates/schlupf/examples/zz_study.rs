//! Scratch: products over reference cases.
use schlupf::interface::contact_law::*;
use schlupf::normal::ellipse::Ellipse;
use schlupf::*;
use std::sync::Arc;

fn q(v: &mut Vec<f64>, p: f64) -> f64 {
    v.sort_by(f64::total_cmp);
    if v.is_empty() {
        return f64::NAN;
    }
    v[((v.len() - 1) as f64 * p) as usize]
}

thread_local!(static KS: Vec<f64> = std::env::var("KS").ok().map_or(vec![1e6, 5e6, 3e7, 1e8, 1e9, 1e10, f64::INFINITY], |k| k.split(',').map(|k| k.parse().unwrap()).collect()));
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let cells: usize = args[1].parse().unwrap();
    let every: usize = args.get(2).map_or(1, |a| a.parse().unwrap());
    let fine: usize = args.get(3).map_or(0, |a| a.parse().unwrap());
    let text = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../data/contact_creep.csv"
    ))
    .unwrap();
    let rows: Vec<Vec<String>> = text
        .lines()
        .filter(|l| !l.starts_with('#'))
        .skip(1)
        .map(|l| l.split(',').map(String::from).collect())
        .collect();
    for k in KS.with(|k| k.clone()) {
        let mut over = 0.0;
        let (mut products, mut bad, mut marched, mut errors) = (vec![], vec![], 0, vec![]);
        let start = std::time::Instant::now();
        for row in
            rows.iter().step_by(every).filter(|r| std::env::var("ONLY").map_or(true, |o| r[0] == o))
        {
            let n = |i: usize| row[i].parse::<f64>().unwrap();
            let ratio: f64 =
                std::env::var("RATIO").ok().map_or(n(2) / n(3), |r| r.parse().unwrap());
            let (a, b) = (0.005 * ratio.sqrt(), 0.005 / ratio.sqrt());
            let law: ContactLaw = if k.is_infinite() {
                ContactLaw::Coulomb
            } else {
                Incremental::new(k).unwrap().into()
            };
            let solve = |cells: usize| {
                let mut problem = Problem::builder()
                    .creepage_x(n(4))
                    .creepage_y(n(5))
                    .spin(n(6))
                    .build()
                    .unwrap();
                problem.normal = Arc::new(Ellipse::from_peak_pressure(a, b, 1e9).unwrap());
                let m = material::Material {
                    young_modulus: 210e9,
                    poisson_ratio: 0.28,
                    ..material::Material::STEEL
                };
                problem.elasticity =
                    Arc::new(elasticity::half_space::HalfSpace::new(&m, &m).unwrap());
                problem.contact_law = law.clone();
                problem.friction = interface::friction::Friction::new(
                    Arc::new(interface::friction::constant::Constant::new(0.3).unwrap()),
                    20.0,
                );
                problem.heat.model = None;
                let options = Options { cells_x: cells, cells_y: cells, ..Options::default() };
                rolling::steady::solve(&problem, &options, &unwatched).unwrap()
            };
            let s = solve(cells);
            let is_marched = s.warnings.iter().any(|w| matches!(w, Warning::Marched { .. }));
            marched += usize::from(is_marched);
            if s.status != Status::Converged || is_marched {
                bad.push(row[0].clone());
            }
            products.push(s.work.operator_products);
            for k in 0..s.fields.len() {
                let t = s.fields.traction_x[k].hypot(s.fields.traction_y[k])
                    / (0.3 * s.fields.pressure[k]);
                if t > over {
                    over = t;
                }
            }
            let error = if fine > 0 {
                let f = solve(fine);
                (s.normalised.x - f.normalised.x).hypot(s.normalised.y - f.normalised.y)
            } else {
                (s.normalised.x - n(7)).hypot(s.normalised.y - n(8))
            };
            errors.push(100.0 * error);
        }
        let time = start.elapsed().as_secs_f64() / products.len() as f64;
        println!(
            "k {k:8.0e}  products {:.1}/{:.1}/{:.1}  error {:.3}/{:.3}/{:.3}  bad {} marched {marched} {:?}  {:.2} ms over {over:.4}",
            q(&mut products, 0.5),
            q(&mut products, 0.9),
            q(&mut products, 1.0),
            q(&mut errors, 0.5),
            q(&mut errors, 0.9),
            q(&mut errors, 1.0),
            bad.len(),
            &bad[..bad.len().min(5)],
            1e3 * time
        );
    }
}
