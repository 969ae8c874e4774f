#[path = "../tests/common/mod.rs"]
mod common;
use common::{cells, layer, problem, rolling};
use schlupf::interface::contact_law::*;
use schlupf::interface::friction::linear::Linear;
use schlupf::interface::friction::slip_terms::SlipTerms;
use schlupf::problem::Branch;
use schlupf::*;
use std::sync::Arc;
fn main() {
    for winkler in [false, true] {
        for k in [1e7, 1e8, 1e9] {
            for n in [8, 12] {
                for h in [0.001, 0.002, 0.004, 0.008] {
                    let mut row = String::new();
                    for i in 0..12 {
                        let xi = 0.0002 + 0.0002 * f64::from(i);
                        let mut f = problem(rolling(xi, 0.0, 0.0));
                        f.kinematics.speed = 15.0;
                        f.elasticity = if winkler {
                            Arc::new(
                                schlupf::elasticity::winkler::Winkler::new(2e13, 2e13).unwrap(),
                            )
                        } else {
                            layer()
                        };
                        f.contact_law = Incremental::new(k).unwrap().into();
                        f.friction.law =
                            Arc::new(Linear(SlipTerms::new(0.4, 0.05, h, None).unwrap()));
                        let on = |branch| {
                            let options = Options { branch, ..cells(n) };
                            let s = rolling::steady::solve(&f, &options, &unwatched).unwrap();
                            (
                                s.normalised.x,
                                s.work.steps,
                                s.warnings.iter().any(|w| w.to_string().contains("several")),
                            )
                        };
                        let (l, h) = (on(Branch::LowSlip), on(Branch::HighSlip));
                        row += &format!(
                            " {:.0}{}{}",
                            1e4 * (l.0 - h.0),
                            if l.2 { "*" } else { "" },
                            if l.1 + h.1 > 0 { "M" } else { "" }
                        );
                    }
                    println!("{winkler} {k:e} {n} {h} {row}");
                }
            }
        }
    }
}
