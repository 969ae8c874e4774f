#[path = "../tests/common/mod.rs"]
mod common;
use common::{cells, layer, problem, rolling};
use schlupf::interface::contact_law::*;
use schlupf::*;
fn main() {
    let _ = layer();
    for (xi, eta, spin) in [
        (0.001, 0.0, 0.0),
        (0.002, 0.0, 0.0),
        (0.0, 0.001, 0.4),
        (0.0, 0.0, 1.0),
        (0.002, 0.002, 0.0),
    ] {
        for total in [0, 1, 2, 3] {
            let mut row = String::new();
            for n in [10, 20, 40, 80, 120] {
                let mut f = problem(rolling(xi, eta, spin));
                match total {
                    0 => f.contact_law = TotalDisplacement::new(5e6).unwrap().into(),
                    2 => f.contact_law = Incremental::new(1e8).unwrap().into(),
                    3 => f.contact_law = ContactLaw::Coulomb,
                    _ => {}
                }
                let s = rolling::steady::solve(&f, &cells(n), &unwatched).unwrap();
                row += &format!(
                    " {:.5} ({:.0})",
                    if xi > 0.0 { s.normalised.x } else { s.normalised.y },
                    s.work.operator_products
                );
            }
            println!("{xi} {eta} {spin} {total} {row}");
        }
    }
}
