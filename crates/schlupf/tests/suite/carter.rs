//! Rolling in plane strain, against Carter, and on a slender ellipse, against strips of Carter.
//!
//! Plane strain is an elasticity of its own here, written against the public traits: one row of
//! cells, each as wide as the contact, with the logarithmic influence of a strip load.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::{self, problem, rolling};
use schlupf::bodies::Material;
use schlupf::elasticity::{Compliance, Convolution, Elasticity, HalfSpace};
use schlupf::interface::friction::Constant;
use schlupf::interface::{ContactLaw, Incremental};
use schlupf::normal::{Ellipse, Grid, Line, PressureSource, PressureTable, Tabulated};
use schlupf::solver::reference::{Carter, HainesOllerton};
use schlupf::{Error, Options, Problem, Solution, Status, unwatched};

const CYLINDERS: Carter = Carter {
    half_length: 5e-3,
    peak_pressure: 1e9,
    friction_coefficient: 0.3,
    shear_modulus: 82e9,
    poisson_ratio: 0.28,
};

/// Length of a line contact with a = 1 mm, in m.
const LENGTH: f64 = 0.2;

/// Creepages over that of full sliding.
const CREEPAGES: [f64; 8] = [0.01, 0.03, 0.1, 0.25, 0.5, 0.75, 0.9, 1.2];

/// Two half-spaces under tractions that do not change across rolling.
#[derive(Debug, Clone, Copy)]
struct PlaneStrain {
    /// Combined shear modulus G, in Pa.
    shear_modulus: f64,
    /// Combined Poisson's ratio ν, dimensionless.
    poisson_ratio: f64,
    /// Distance from the load of the points that stay in place, in m. The displacement under a line
    /// load has a constant that plane strain leaves open; in rolling only differences count. Well
    /// outside the contact, it leaves the compliance positive definite.
    reach: f64,
}

impl PlaneStrain {
    const STEEL: Self = Self {
        shear_modulus: CYLINDERS.shear_modulus,
        poisson_ratio: CYLINDERS.poisson_ratio,
        reach: 10.0 * CYLINDERS.half_length,
    };

    /// A_xx, A_yy and A_xy (in m/Pa) of cells of a length (in m) on the middle of one `columns`
    /// apart: A_xx = −(2 (1 − ν)/(πG)) ∫ ln(|x − x'|/L) dx' (Johnson 1985, §2.3), and across, in
    /// pure shear, A_yy = −(2/(πG)) ∫ ln(|x − x'|/L) dx'.
    fn influence(&self, length: f64, columns: isize) -> [f64; 3] {
        let primitive = |x: f64| x * ((x.abs() / self.reach).ln() - 1.0);
        let x = columns as f64 * length;
        let integral = primitive(x + 0.5 * length) - primitive(x - 0.5 * length);
        let across = -2.0 * integral / (PI * self.shear_modulus);
        [(1.0 - self.poisson_ratio) * across, across, 0.0]
    }
}

impl Elasticity for PlaneStrain {
    /// With the mean over the cell undone as in the half-space: h²u''/12. The rows share the load.
    fn compliance(&self, grid: &Grid) -> Result<Box<dyn Compliance>, Error> {
        let rows = grid.rows as f64;
        let at = |i: isize| self.influence(grid.spacing_x, i).map(|entry| entry / rows);
        Ok(Box::new(Convolution::new(grid, |i, _| {
            let (here, ahead, behind) = (at(i), at(i + 1), at(i - 1));
            std::array::from_fn(|c| here[c] + (2.0 * here[c] - ahead[c] - behind[c]) / 12.0)
        })))
    }
}

/// p0 √(1 − x²/a²), the same for all y, in a table with 1000 samples on each side.
fn cylinders() -> Tabulated {
    let a = CYLINDERS.half_length;
    let x: Vec<f64> = (-1000..=1000).map(|k| 1e-3 * a * f64::from(k)).collect();
    let pressure = |x: &f64| CYLINDERS.peak_pressure * (1.0 - (x / a).powi(2)).max(0.0).sqrt();
    let line: Vec<f64> = x.iter().map(pressure).collect();
    Tabulated::new(PressureTable::new(&x, &[-a, a], line.repeat(2)).unwrap(), None).unwrap()
}

fn of_bodies(
    (normal, elasticity): (Arc<dyn PressureSource>, Arc<dyn Elasticity>),
    creepage: f64,
    stiffness: f64,
) -> Problem {
    let mut coulomb = problem(rolling(creepage, 0.0, 0.0));
    coulomb.normal = normal;
    coulomb.interface.elasticity = elasticity;
    coulomb.interface.contact_law = Incremental::new(stiffness).unwrap().into();
    coulomb.interface.friction.law =
        Arc::new(Constant::new(CYLINDERS.friction_coefficient).unwrap());
    coulomb
}

/// Steady rolling under a longitudinal creepage, with the contact law's k_c (in 1/m) and cells
/// along and across.
fn solve(
    bodies: (Arc<dyn PressureSource>, Arc<dyn Elasticity>),
    creepage: f64,
    stiffness: f64,
    [cells_x, cells_y]: [usize; 2],
) -> Solution {
    let coulomb = of_bodies(bodies, creepage, stiffness);
    let options = Options { cells_x, cells_y, slip_threshold: 0.99, ..Options::default() };
    let solution = schlupf::solver::solve(&coulomb, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    assert_eq!(solution.work.steps, 0, "marched: {:?}", solution.warnings);
    assert!(solution.work.newton_iterations <= 60, "{:?}", solution.work);
    solution
}

/// Two cylinders under a creepage as a share of that of full sliding.
fn roll(share: f64, stiffness: f64, cells: usize) -> Solution {
    let creepage = share * CYLINDERS.full_sliding_creepage();
    let bodies = (Arc::new(cylinders()) as _, Arc::new(PlaneStrain::STEEL) as _);
    solve(bodies, creepage, stiffness, [cells, 1])
}

/// Force over that of Carter, less one.
fn error(share: f64, stiffness: f64, cells: usize) -> f64 {
    let exact = CYLINDERS.force_over_limit(share * CYLINDERS.full_sliding_creepage());
    roll(share, stiffness, cells).normalised.x / exact - 1.0
}

/// Carter 1926: the force within 1 %, also of a small force itself, for nearly rigid bristles on
/// any sensible grid.
#[test]
fn carter_1926_creep_curve() {
    for (stiffness, cells) in [(1e8, 100), (1e9, 50), (1e9, 100), (1e10, 200)] {
        let errors = CREEPAGES.map(|share| error(share, stiffness, cells));
        println!("k_c = {stiffness:e}/m, {cells} cells: {errors:+.4?}");
        assert!(errors.iter().all(|e| e.abs() < 0.01), "{stiffness:e} {cells}: {errors:+.4?}");
    }
}

/// Carter 1926 is the limit: with nearly rigid bristles twice the cells halve the error, and ten
/// times the stiffness leaves less than 0.3 of what the bristles yield (not a tenth: next to the
/// leading edge, where the pressure vanishes, no bristle is stiff).
#[test]
fn carter_1926_is_the_limit_of_cells_and_stiffness() {
    for share in [0.1, 0.5, 0.75] {
        let by_cells = [50, 100, 200].map(|cells| error(share, 1e10, cells).abs());
        let rigid = error(share, 1e10, 200);
        let yielding = [1e7, 1e8, 1e9].map(|stiffness| rigid - error(share, stiffness, 200));
        println!("{share}: {by_cells:.5?} {yielding:.5?}");
        assert!(by_cells.windows(2).all(|e| e[1] < 0.6 * e[0]), "{share}: {by_cells:?}");
        assert!(yielding.windows(2).all(|e| e[1] < 0.3 * e[0]), "{share}: {yielding:?}");
        assert!(yielding[2] > 0.0, "{share}: {yielding:?}");
    }
}

/// Carter 1926: the traction within 1 % (relative L2), and a sticking zone at the leading edge of
/// the length 2c to a cell: the one in which it ends counts as either.
#[test]
fn carter_1926_traction() {
    for share in [0.1, 0.253, 0.5, 0.777, 0.9] {
        let creepage = share * CYLINDERS.full_sliding_creepage();
        let solution = roll(share, 1e9, 200);
        let fields = &solution.fields;
        let mut squares = [0.0; 2];
        for (x, traction) in fields.x.iter().zip(&fields.traction_x) {
            let exact = CYLINDERS.traction(creepage, *x);
            squares[0] += (traction - exact).powi(2);
            squares[1] += exact.powi(2);
        }
        let difference = f64::sqrt(squares[0] / squares[1]);
        let stick = fields.sliding.iter().position(|slides| *slides).unwrap();
        let length = fields.grid.spacing_x * stick as f64;
        let exact = 2.0 * CYLINDERS.stick_half_length(creepage);
        let off = (length - exact) / fields.grid.spacing_x;
        println!("{share}: traction {difference:.4}, stick {off:+.2} cells");
        assert!(difference < 0.01, "{share}: {difference}");
        assert!(off.abs() < 1.0, "{share}: {length} m, exactly {exact} m");
        assert!(fields.sliding[stick..].iter().all(|slides| *slides), "{share}");
    }
}

/// Haines and Ollerton 1963: on a half-space an ellipse of a/b = 0.1 rolls as strips of Carter
/// would, within 1.5 % of μN for any ν, under every creepage.
#[test]
fn haines_ollerton_1963_creep_curve() {
    for poisson_ratio in [0.0, 0.28, 0.5] {
        let material = Material { poisson_ratio, ..Material::STEEL };
        let strips = HainesOllerton {
            semi_axis_x: 2e-3,
            semi_axis_y: 20e-3,
            peak_pressure: 1e9,
            friction_coefficient: CYLINDERS.friction_coefficient,
            shear_modulus: material.shear_modulus(),
            poisson_ratio,
        };
        let ellipse = Arc::new(Ellipse::from_peak_pressure(2e-3, 20e-3, 1e9).unwrap());
        let half_space = Arc::new(HalfSpace::new(&material, &material).unwrap());
        let errors = CREEPAGES.map(|share| {
            let creepage = share * strips.full_sliding_creepage();
            let bodies = (Arc::clone(&ellipse) as _, Arc::clone(&half_space) as _);
            let force = solve(bodies, creepage, 1e9, [40, 40]).normalised.x;
            force - strips.force_over_limit(creepage)
        });
        println!("ν = {poisson_ratio}: {errors:+.4?}");
        assert!(errors.iter().all(|e| e.abs() < 0.015), "ν = {poisson_ratio}: {errors:+.4?}");
    }
}

/// Carter 1926: a line contact in one row of the half-space, within 0.5 % of μN in steady rolling
/// and at the end of a march. Bristles are as nearly rigid as above, relative to the contact's
/// length. CONTACT has 0.6480 μN on 55 elements of 0.04 mm under 2.4·10⁻⁴ (Vollebregt 2022, user
/// guide, §5.2).
#[test]
fn carter_1926_line_contact() {
    let carter = of_line_contact();
    let rigid = 1e11;
    for share in CREEPAGES {
        let creepage = share * carter.full_sliding_creepage();
        let exact = carter.force_over_limit(creepage);
        let force = solve(line_contact(LENGTH), creepage, rigid, [100, 1]).normalised.x;
        println!("{share}: {force:+.4}, exactly {exact:+.4}");
        assert!((force - exact).abs() < 0.005, "{share}: {force}, exactly {exact}");
    }
    let creepage = 2.4e-4;
    let force = solve(line_contact(LENGTH), creepage, rigid, [50, 1]).normalised.x;
    assert!((force + 0.648).abs() < 0.015, "{force}");
    let marching = of_bodies(line_contact(LENGTH), creepage, rigid);
    let options = Options { cells_x: 40, cells_y: 1, ..Options::default() };
    let marched = common::solve(&marching, &options).normalised.x;
    assert!((marched - carter.force_over_limit(creepage)).abs() < 0.005, "{marched}");
    assert!((marched - force).abs() < 1e-3, "{marched}, {force} at once");
}

/// Cattaneo 1938 (Johnson 1985, §7.2(a)): a shift of two cylinders leaves a middle of the length 2c
/// sticking, c² = a² (1 − |Q|/μN), in which the traction of full sliding is reduced by one of the
/// same shape; to 1 % of μp0 in the cells' means.
#[test]
fn cattaneo_1938_line_contact() {
    let carter = of_line_contact();
    let [a, limit] = [carter.half_length, carter.friction_coefficient * carter.peak_pressure];
    let mut coulomb = of_bodies(line_contact(LENGTH), 0.0, 1.0);
    coulomb.interface.contact_law = ContactLaw::Coulomb;
    let options = Options { cells_x: 100, cells_y: 1, ..Options::default() };
    let solution = schlupf::solver::shift(&coulomb, [1e-6, 0.0], &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    let force = solution.normalised.x.abs();
    assert!((0.3..0.7).contains(&force), "{force}");
    let c = a * (1.0 - force).sqrt();
    let fields = &solution.fields;
    let half = |x: f64, half: f64| (half * half - x * x).max(0.0).sqrt() / a;
    for (x, traction) in fields.x.iter().zip(&fields.traction_x) {
        let exact = limit * (half(*x, a) - half(*x, c));
        assert!((traction.abs() - exact).abs() < 0.01 * limit, "{x}: {traction}, exactly {exact}");
    }
}

/// Rows across show the ends, where there is more traction; the middle row has the force of plane
/// strain within 1 %.
#[test]
fn the_middle_of_a_line_contact_is_in_plane_strain() {
    let carter = of_line_contact();
    let creepage = 0.5 * carter.full_sliding_creepage();
    let solution = solve(line_contact(20e-3), creepage, 1e11, [24, 25]);
    let fields = &solution.fields;
    let of_row = |row: usize| -> f64 {
        let cells = (0..fields.len()).filter(|cell| fields.cell[*cell][1] == row);
        let force: [f64; 2] = cells.fold([0.0; 2], |[t, p], cell| {
            [t + fields.traction_x[cell], p + fields.pressure[cell]]
        });
        force[0] / force[1] / carter.friction_coefficient
    };
    let (middle, end) = (of_row(12), of_row(0));
    println!("middle {middle:+.4}, end {end:+.4}");
    assert!((middle - carter.force_over_limit(creepage)).abs() < 0.01, "{middle}");
    assert!(end.abs() > middle.abs() + 0.01, "{end}");
}

/// CONTACT's example of Carter's problem (Vollebregt 2022, user guide, §5.2): steel cylinders with
/// G = 82 GPa, ν = 0.28, R = 0.5 m, 35.78 kN on 200 mm; of a length in m.
fn line_contact(length: f64) -> (Arc<dyn PressureSource>, Arc<dyn Elasticity>) {
    let steel = Material { young_modulus: 2.56 * 82e9, poisson_ratio: 0.28, ..Material::STEEL };
    let modulus = schlupf::bodies::contact_modulus(&steel, &steel);
    let line = Line::new([0.5, f64::INFINITY], length, modulus, 178.9e3 * length).unwrap();
    (Arc::new(line), Arc::new(HalfSpace::new(&steel, &steel).unwrap()))
}

fn of_line_contact() -> Carter {
    let contact = line_contact(LENGTH).0.normal_contact(None).unwrap().summary;
    let (half_length, peak_pressure) = (contact.semi_axis_x, contact.peak_pressure);
    Carter { half_length, peak_pressure, ..CYLINDERS }
}
