//! scratch
mod common;
use schlupf::interface::friction::{Friction, constant::Constant};
use schlupf::material::*;
use schlupf::method::*;
use schlupf::normal::ellipse::Ellipse;
use schlupf::simplified::FastContact;
use schlupf::{Method, Options, Problem};
use std::sync::Arc;
fn kalker() -> Problem {
    let mut p = common::problem(common::rolling(0.0, -6.25e-4, 0.625));
    p.normal = Arc::new(Ellipse::from_load(8e-3, 4e-3, 82e3).unwrap());
    p.friction.law = Arc::new(Constant::new(0.3).unwrap());
    let m = Material { young_modulus: 2.0 * 1.28 * 82e9, ..Material::STEEL };
    p.wheel.material = m;
    p.rail.material = m;
    p
}
#[test]
fn numbers() {
    for b in [TractionBound::Parabolic, TractionBound::Elliptic] {
        for n in [10, 20, 40, 80, 160] {
            let o = Options {
                method: Method::Fastsim(Brush { flexibilities: Flexibilities::Three, bound: b }),
                ..common::cells(n)
            };
            let mut f = FastContact::new(&kalker(), &o).unwrap();
            let s = f.solution();
            println!("{n} {:?} {} {}", s.normalised, s.power.friction, s.power.creep);
        }
    }
    for m in [
        Method::KalkerLinear,
        Method::ShenHedrickElkins,
        Method::Polach(AreaReduction { area_adhesion: 1.0, area_slip: 1.0 }),
    ] {
        let o = Options { method: m, ..common::cells(20) };
        let mut f = FastContact::new(&kalker(), &o).unwrap();
        let s = f.solution();
        println!("{:?} {:?} {:?}", m, s.normalised, s.warnings);
    }
}
