//! The flash temperature of a full slide on elastic bodies, and what CONTACT prints for it.
//!
//! Set-up (Ertz and Knothe 2002; example of the User guide for CONTACT, "Temperature calculation"):
//! half-space with G = 82 GPa, ν = 0.28, a = 5.88 mm, b = 10.54 mm, N = 100 kN, 30 m/s, μ = 0.3,
//! half of the heat to each body, ξ = −1/30.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::{problem, rolling};
use schlupf::bodies::Material;
use schlupf::elasticity::HalfSpace;
use schlupf::element::{Element, Motion, Settings};
use schlupf::interface::Incremental;
use schlupf::interface::friction::Constant;
use schlupf::interface::heat::{Duhamel, Heat, Partition};
use schlupf::normal::Ellipse;
use schlupf::problem::FastMethod;
use schlupf::{Method, Options, Problem, Quantity, Solution, Status, unwatched};

/// The full slide with a stiffness k_c of the contact law, in 1/m.
fn full_slide_with(stiffness: f64) -> Problem {
    let mut slide = problem(rolling(-1.0 / 30.0, 0.0, 0.0));
    slide.normal = Arc::new(Ellipse::from_load(5.88e-3, 10.54e-3, 100e3).unwrap());
    let young_modulus = 2.0 * 82e9 * (1.0 + 0.28);
    let steel = Material { young_modulus, poisson_ratio: 0.28, ..Material::STEEL };
    slide.interface.elasticity = Arc::new(HalfSpace::new(&steel, &steel).unwrap());
    slide.interface.contact_law = Incremental::new(stiffness).unwrap().into();
    slide.interface.friction.law = Arc::new(Constant::new(0.3).unwrap());
    slide.interface.heat =
        Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Given(0.5) };
    slide
}

/// Its solution on cells across the patch.
fn full_slide(stiffness: f64, cells_x: usize, cells_y: usize) -> Solution {
    let slide = full_slide_with(stiffness);
    let options = Options { cells_x, cells_y, ..Options::default() };
    let solution = schlupf::solver::solve(&slide, &options, &unwatched).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.warnings);
    solution
}

/// Ertz and Knothe 2002: with the elastic slip of the half-space T_max = 152.7 ± 0.3 K, 2.4 K more
/// than that of rigid bodies; in Coulomb's limit k_c does not count, and finer cells come closer to
/// one value.
#[test]
fn ertz_knothe_2002_full_slide_on_the_half_space() {
    let rise = |stiffness, along| full_slide(stiffness, along, 61).temperature.unwrap().max_rise;
    let rises = [30, 59, 118, 236].map(|along| rise(1e9, along));
    println!("{rises:?}");
    for largest in rises {
        assert!((largest - 152.7).abs() < 0.3, "{largest}");
    }
    let steps = [rises[1] - rises[0], rises[2] - rises[1], rises[3] - rises[2]].map(f64::abs);
    assert!(steps[1] < 0.5 * steps[0] && steps[2] < 0.5 * steps[1], "{steps:?}");
    assert!((rise(1e8, 118) - rise(1e10, 118)).abs() < 1e-4);
}

/// The force element, whose bodies slide as rigid ones do: 2.4 K less.
#[test]
fn ertz_knothe_2002_full_slide_of_the_force_element() {
    let (method, options) = (Method::Fast(FastMethod::ShenHedrickElkins), Options::default());
    let settings = Settings { motion: Motion::Creepages, has_memory: false, ..Settings::default() };
    let mut element = Element::new(&full_slide_with(1e9), (&method, &options), settings).unwrap();
    let place = element.outputs().iter().position(|of| *of == Quantity::MaxRise).unwrap();
    let mut found = element.evaluation();
    element.evaluate(&element.start(), &[], &mut found);
    let rise = found.outputs[place];
    println!("{rise}");
    assert!((rise - (152.7 - 2.4)).abs() < 0.3, "{rise}");
}

/// Largest rise along the middle row, in K, from the friction powers of a solution, q constant
/// within each cell and each cell's weight 2(√(x + Δx/2) − √(x − Δx/2)); the own half cell,
/// 2√(Δx/2), is counted `own` times.
fn largest_in_the_middle_row(solution: &Solution, own: f64) -> f64 {
    let fields = &solution.fields;
    let in_row = |k: &usize| fields.y[*k].abs() < 1e-9 && fields.covered[*k] > 0.0;
    let row: Vec<usize> = (0..fields.len()).filter(in_row).collect();
    let half = 0.5 * fields.grid.spacing_x;
    let factor = 0.5 / (Material::STEEL.effusivity() * (PI * 30.0).sqrt());
    let rise = |here: usize| {
        let weight = |there: usize| {
            let way = (here - there) as f64 * 2.0 * half;
            2.0 * ((way + half).sqrt() - (way - half).sqrt())
        };
        let upstream: f64 =
            (0..here).map(|there| weight(there) * fields.friction_power[row[there]]).sum();
        factor * (upstream + own * 2.0 * half.sqrt() * fields.friction_power[row[here]])
    };
    (0..row.len()).map(rise).fold(0.0, f64::max)
}

/// Vollebregt, CONTACT: prints 166.8 K on the cells of its example, 0.2 × 0.5 mm, and 159.7 K on
/// eight times as many, 0.05 × 0.25 mm, because the cell itself is counted twice in the integral
/// over the way. That error falls with √Δx only: cells of 0.025 mm would give 157.7 K. Counted
/// once, all have 152.7 K.
#[test]
fn vollebregt_contact_counts_the_own_cell_twice() {
    for (along, across, printed) in [(59, 43, 166.8), (235, 85, 159.7), (470, 91, 157.7)] {
        let solution = full_slide(1e9, along, across);
        let [once, twice] = [1.0, 2.0].map(|own| largest_in_the_middle_row(&solution, own));
        println!("{along} × {across}: {once} once, {twice} twice");
        assert!((once - 152.7).abs() < 0.3, "{along}: {once}");
        assert!((twice - printed).abs() < 0.5, "{along}: {twice}");
    }
}
