//! Tests of the directions that are kept.

use super::{Directions, Equilibrium};
use crate::numerics::vector::norm;
use crate::solver::settings;

/// J = L + a local part, and a diagonal preconditioner.
#[derive(Clone)]
struct Matrix {
    /// Rows of L.
    linear: Vec<Vec<f64>>,
    local: Vec<f64>,
    preconditioner: Vec<f64>,
}

impl Matrix {
    /// L of so many numbers, without a local part and a preconditioner.
    fn new(size: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let row = |i: usize| (0..size).map(|j| entry(i, j)).collect();
        Self {
            linear: (0..size).map(row).collect(),
            local: vec![0.0; size],
            preconditioner: vec![1.0; size],
        }
    }

    /// Diffusion and convection along a line, and a local part that changes with a number.
    fn line(number: usize) -> Self {
        let entry = |i: usize, j: usize| match (i, j) {
            _ if i == j => 2.0,
            _ if i == j + 1 => -1.3,
            _ if i + 1 == j => -0.7,
            _ => 0.0,
        };
        let local = |i: usize| 1.0 + ((i * i + number * i) % 7) as f64;
        let local: Vec<_> = (0..SIZE).map(local).collect();
        let preconditioner = local.iter().map(|local| (local + 2.0).recip()).collect();
        Self { local, preconditioner, ..Self::new(SIZE, entry) }
    }

    fn with_local(mut self, local: impl Fn(usize) -> f64) -> Self {
        self.local = (0..self.size()).map(local).collect();
        self
    }
}

const SIZE: usize = 150;

impl Equilibrium for Matrix {
    fn size(&self) -> usize {
        self.local.len()
    }

    fn scale(&self, _p: &[f64]) -> f64 {
        1.0
    }

    fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
        for (u, row) in u.iter_mut().zip(&self.linear) {
            *u = row.iter().zip(p).map(|(l, p)| l * p).sum();
        }
    }

    fn residual(&mut self, _p: &[f64], _u: &[f64], _residual: &mut [f64]) {}

    fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]) {
        for (i, product) in product.iter_mut().enumerate() {
            *product = response[i] + self.local[i] * v[i];
        }
    }

    fn precondition(&mut self, v: &mut [f64]) {
        for (v, over) in v.iter_mut().zip(&self.preconditioner) {
            *v *= over;
        }
    }
}

/// Solves J d = −F, checks that L d is that of d, and returns the number of products and the
/// part of F that is left.
fn attempt(
    directions: &mut Directions,
    matrix: &mut Matrix,
    residual: &[f64],
    forcing: f64,
) -> (usize, f64) {
    let zeros = vec![0.0; residual.len()];
    let [mut step, mut response, mut again, mut product] = [0; 4].map(|_| zeros.clone());
    let target = [step.as_mut_slice(), response.as_mut_slice()];
    let products = directions.solve(matrix, residual, forcing, (target, &|| Ok(()))).unwrap();
    matrix.compliance_product(&step, &mut again);
    for (one, two) in response.iter().zip(&again) {
        assert!((one - two).abs() <= 1e-12 * norm(&again), "{one} {two}");
    }
    matrix.tangent_product(&step, &again, &mut product);
    let rest: Vec<_> = product.iter().zip(residual).map(|(product, r)| product + r).collect();
    (products, norm(&rest) / norm(residual))
}

/// The same of a system that must be solved; returns the number of products.
fn solve(
    directions: &mut Directions,
    matrix: &mut Matrix,
    residual: &[f64],
    forcing: f64,
) -> usize {
    let (products, left) = attempt(directions, matrix, residual, forcing);
    assert!(left < forcing * (1.0 + 1e-6), "{left} {forcing}");
    products
}

fn unit(size: usize, place: usize) -> Vec<f64> {
    (0..size).map(|i| f64::from(u8::from(i == place))).collect()
}

/// Systems that differ by less and less: their directions depend on each other nearly, then
/// entirely.
#[test]
fn systems_are_solved_with_whatever_is_known() {
    let mut directions = Directions::default();
    let rhs =
        |change: f64| -> Vec<f64> { (0..SIZE).map(|i| 1.0 + change * (i as f64).sin()).collect() };
    let first = solve(&mut directions, &mut Matrix::line(0), &rhs(0.0), 1e-8);
    for (number, change) in [1.0, 1e-2, 1e-4, 1e-8, 1e-12, 0.0].into_iter().enumerate() {
        solve(&mut directions, &mut Matrix::line(number / 3), &rhs(change), 1e-8);
    }
    assert_eq!(solve(&mut directions, &mut Matrix::line(1), &rhs(0.0), 1e-6), 0);
    directions.clear();
    assert_eq!(solve(&mut directions, &mut Matrix::line(0), &rhs(0.0), 1e-8), first);
}

/// The oldest directions are forgotten: what only they solve needs products again, and what the
/// latest solve does not.
#[test]
fn the_latest_directions_are_kept() {
    let size = 2 * settings::directions_kept();
    let mut identity = Matrix::new(size, |i, j| f64::from(u8::from(i == j)));
    let mut directions = Directions::default();
    for place in 0..size {
        assert_eq!(solve(&mut directions, &mut identity, &unit(size, place), 1e-8), 1);
    }
    assert_eq!(directions.known, settings::directions_kept() + 1);
    for place in settings::directions_kept()..size {
        assert_eq!(solve(&mut directions, &mut identity, &unit(size, place), 1e-8), 0);
    }
    assert_eq!(solve(&mut directions, &mut identity, &unit(size, 0), 1e-8), 1);
}

/// Pairs of directions of which all but 10⁻⁵ is the same once the local part is small: products
/// of pairs cannot tell them apart to 10⁻⁸, but they are all that the next system needs.
#[test]
fn nearly_equal_recycled_directions_count() {
    let size = 10;
    let pairs = Matrix::new(size, |i, j| f64::from(u8::from(i / 2 == j / 2)));
    let mut directions = Directions::default();
    let mut begin = pairs.clone().with_local(|_| 100.0);
    for place in 0..size {
        solve(&mut directions, &mut begin, &unit(size, place), 1e-8);
    }
    let mut system = pairs.with_local(|i| 1e-5 * (1.0 + i as f64));
    let rhs: Vec<_> = (0..size).map(|i| 1.0 + (i as f64).sin()).collect();
    assert_eq!(solve(&mut directions, &mut system, &rhs, 1e-8), 0);
}

/// Rotations of planes by a right angle and a little: from one direction in each plane what is
/// left of the system is small, of both signs and spread, while all planes together are solved
/// in a few products.
#[test]
fn recycled_directions_in_the_way_of_new_ones_do_not_lead() {
    let (planes, size) = (20, 40);
    let rotation = Matrix::new(size, |i, j| match (i % 2, j % 2) {
        (1, 0) if i == j + 1 => 1.0,
        (0, 1) if j == i + 1 => -1.0,
        _ => 0.0,
    });
    let mut directions = Directions::default();
    let mut begin = rotation.clone().with_local(|_| 10.0);
    for plane in 0..planes {
        assert_eq!(solve(&mut directions, &mut begin, &unit(size, 2 * plane), 0.5), 1);
    }
    let mut system =
        rotation.with_local(|i| 0.05 * ((i / 2) as f64 + 0.5 - 0.5 * planes as f64) / 10.0);
    let rhs: Vec<_> = (0..size).map(|i| 1.0 + (i as f64).sin()).collect();
    let products = solve(&mut directions, &mut system, &rhs, 1e-6);
    assert!(directions.alone.is_used());
    let fresh = solve(&mut Directions::default(), &mut system, &rhs, 1e-6);
    assert!(products <= fresh + 1, "{products} {fresh}");
    assert!(products < planes / 2, "{products}");
}

/// The residual that the new direction alone leaves leads back into what is known already,
/// while that over all directions leads on.
#[test]
fn a_residual_that_leads_nowhere_gives_way_to_another() {
    let columns = [[1.0, 0.0, 0.0], [1.0, 5e-4, 5e-4], [0.0, 0.0, 1.0]];
    let mut system = Matrix::new(3, |i, j| columns[j][i]);
    let mut directions = Directions::default();
    solve(&mut directions, &mut system, &unit(3, 0), 1e-8);
    solve(&mut directions, &mut system, &unit(3, 1), 1e-6);
}

/// A cyclic shift: residuals stay as they are until the last direction.
#[test]
fn residuals_that_stand_still_do_not_end_the_search() {
    let size = 20;
    let mut shift = Matrix::new(size, |i, j| f64::from(u8::from(i == (j + 1) % size)));
    let products = solve(&mut Directions::default(), &mut shift, &unit(size, 0), 1e-8);
    assert!(products <= 2 * size, "{products}");
}

/// A system without a solution ends, and so does one with NaN; the systems after them are
/// solved.
#[test]
fn what_cannot_be_solved_ends_and_harms_no_later_system() {
    let size = 10;
    let mut system = Matrix::new(size, |i, j| f64::from(u8::from(i == j && i > 0)));
    let mut directions = Directions::default();
    let (products, left) = attempt(&mut directions, &mut system, &[1.0; 10], 1e-8);
    assert!(products <= 5, "{products}");
    assert!((left - 0.1_f64.sqrt()).abs() < 1e-12, "{left}");

    let mut broken = system.clone().with_local(|_| f64::NAN);
    let (mut step, mut response) = ([0.0; 10], [0.0; 10]);
    let target = [step.as_mut_slice(), response.as_mut_slice()];
    directions.solve(&mut broken, &[1.0; 10], 1e-8, (target, &|| Ok(()))).unwrap();

    let mut good = system.with_local(|_| 1.0);
    solve(&mut directions, &mut good, &[1.0; 10], 1e-8);
}
