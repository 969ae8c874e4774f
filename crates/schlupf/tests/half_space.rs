//! Rolling on the elastic half-space with nearly Coulomb friction, against CONTACT.

mod common;

use std::path::Path;
use std::sync::Arc;

use common::{cells, problem, rolling, solve};
use schlupf::elasticity::half_space::HalfSpace;
use schlupf::interface::contact_law::Incremental;
use schlupf::interface::friction::constant::Constant;
use schlupf::material::Material;
use schlupf::normal::ellipse::Ellipse;

/// One line of `data/contact_creep.csv`, without its name.
struct Reference {
    semi_axes: [f64; 2],
    creepage: [f64; 3],
    force: [f64; 3],
}

fn references() -> Vec<Reference> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/contact_creep.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file).unwrap();
    let line = |record: csv::StringRecord| {
        let n = |k: usize| record[k].parse::<f64>().unwrap();
        Reference {
            semi_axes: [n(2), n(3)],
            creepage: [n(4), n(5), n(6)],
            force: [n(7), n(8), n(9)],
        }
    };
    reader.records().map(|record| line(record.unwrap())).collect()
}

/// Vollebregt 2022 (CONTACT, extrapolated over grids): forces of every fifteenth case with
/// k_c = 1e8/m at 20 cells across, marched to the steady state, within 1 % of μN for pure
/// longitudinal or lateral creepage and 2 % with spin or combined.
#[test]
fn vollebregt_2022_creep_forces_on_the_half_space() {
    for reference in references().iter().step_by(15) {
        let [xi, eta, spin] = reference.creepage;
        let [a, b] = reference.semi_axes;
        let mut coulomb = problem(rolling(xi, eta, spin));
        coulomb.normal = Arc::new(Ellipse::from_load(a, b, 52_359.878).unwrap());
        coulomb.elasticity = Arc::new(HalfSpace::new(&Material::STEEL, &Material::STEEL).unwrap());
        coulomb.contact_law = Arc::new(Incremental::new(1e8).unwrap());
        coulomb.friction.law = Arc::new(Constant::new(0.3).unwrap());
        let force = solve(&coulomb, &cells(20)).normalised;
        let pure = spin == 0.0 && (xi == 0.0 || eta == 0.0);
        let allowed = if pure { 0.01 } else { 0.02 };
        for (got, expected) in [force.x, force.y, force.moment_z].iter().zip(reference.force) {
            assert!(
                (got - expected).abs() < allowed,
                "ξ {xi}, η {eta}, φ {spin}: {force:?}, not {:?}",
                reference.force
            );
        }
    }
}
