//! Minimal residuals over all directions known so far, those of earlier linear systems included.
//!
//! The expensive part of the Jacobian is linear and the same in every Newton step: with a direction
//! z and its response L z, J z costs no product, whatever the tangent is now. So each system first
//! minimises its residual over the directions of those before it, and only then asks for new ones,
//! the preconditioned residuals (generalised conjugate residuals, Eisenstat, Elman and Schultz
//! 1983; recycling: Parks et al. 2006). Without earlier directions this is GMRES. Where the earlier
//! ones leave little of a new one, the next ones follow the residuals that the new ones alone would
//! leave: those of GMRES, begun from what the earlier ones left.

use super::{Continues, Equilibrium, LARGE};
use crate::error::Error;
use crate::numerics::vector::{add_combination, add_scaled, dot, dots, gram, norm};

/// Directions with their responses, the oldest first, and the workspace of a solution: kept, so
/// that only more directions than ever before allocate.
#[derive(Debug, Default)]
pub struct Directions {
    /// Those that are known, followed by room for more.
    all: Vec<Direction>,
    known: usize,
    whole: Projection,
    /// Over the new directions alone, once the recycled ones are in their way.
    alone: Projection,
}

#[derive(Debug, Default)]
struct Direction {
    z: Vec<f64>,
    /// L z.
    response: Vec<f64>,
}

/// Number of directions that are kept from one system to the next.
const KEPT: usize = 48;

/// Largest number of new directions for one system.
const MOST_NEW: usize = 120;

/// Part of J z that must be new for the direction to count, dimensionless.
const LEAST_NEW: f64 = 1e-6;

/// The same for all recycled directions at once, from products of pairs, which hold half as many
/// digits; the others are added one by one.
const LEAST_CERTAIN: f64 = 1e-3;

/// Part of J z that is new below which the recycled directions are in the way: what is left of −F
/// is hard to reach by what they leave of the preconditioned Jacobian, but not by the whole.
const LITTLE: f64 = 0.1;

/// Length of what is new in J z, relative to J z, below which it is made orthogonal once more:
/// cancellation has then made it inaccurate.
const INACCURATE: f64 = 0.5;

/// A linear system J d = −F that is being solved.
#[derive(Debug, Default)]
struct Projection {
    /// What is left of −F.
    rest: Vec<f64>,
    /// J z of the recycled directions, and then what is orthogonal to all before of that of each
    /// further one, at unit length; followed by room for more. With the triangle this stands for an
    /// orthonormal basis of all J z: W R⁻¹ for the recycled ones.
    basis: Vec<Vec<f64>>,
    /// Number of recycled directions.
    recycled: usize,
    /// The direction of each vector of the basis.
    numbers: Vec<usize>,
    /// J z of these directions in terms of the orthonormal basis: the columns of a triangular
    /// matrix, one after another, each one longer than the previous one.
    triangle: Vec<f64>,
    /// −F in terms of that basis, and then the weight of each direction.
    weights: Vec<f64>,
    /// Products of all pairs of J z.
    gram: Vec<f64>,
    /// Whether little of the last J z was new.
    is_nearly_known: bool,
    /// Products with the vectors of the basis, and then their factors in a sum.
    factors: Vec<f64>,
}

impl Projection {
    /// A system with the right-hand side −F.
    fn start(&mut self, rhs: impl Iterator<Item = f64>) {
        self.rest.clear();
        self.rest.extend(rhs);
        self.recycled = 0;
        self.numbers.clear();
        self.triangle.clear();
        self.weights.clear();
    }

    fn dimension(&self) -> usize {
        self.numbers.len()
    }

    /// Room for J z at a place of the basis.
    fn room(&mut self, place: usize, length: usize) -> &mut [f64] {
        if self.basis.len() == place {
            self.basis.push(Vec::new());
        }
        self.basis[place].resize(length, 0.0);
        &mut self.basis[place]
    }

    /// Adds J z of all recycled directions at once, and removes their part of the rest: by the
    /// triangle from the products of all pairs (Cholesky), each vector being read once.
    fn recycle(&mut self, directions: &[Direction], system: &mut impl Equilibrium) {
        for (place, Direction { z, response }) in directions.iter().enumerate() {
            system.tangent_product(z, response, self.room(place, z.len()));
        }
        gram(&self.basis[..directions.len()], &mut self.gram);
        let mut doubtful = Vec::new();
        for number in 0..directions.len() {
            if self.take(number) {
                self.basis.swap(self.recycled, number);
                self.recycled += 1;
            } else {
                doubtful.push(number);
            }
        }
        let taken = &self.basis[..self.recycled];
        self.weights.resize(self.recycled, 0.0);
        dots(&self.rest, taken, &mut self.weights);
        solve_transposed(&self.triangle, &mut self.weights);
        self.factors.clear();
        self.factors.extend(self.weights.iter().map(|weight| -weight));
        solve(&self.triangle, &mut self.factors);
        add_combination(&mut self.rest, &self.factors, taken);
        for number in doubtful {
            self.add(number, &directions[number], system);
        }
    }

    /// Adds the column of a recycled direction to the triangle, unless too little of it is new for
    /// the products of pairs to tell.
    fn take(&mut self, number: usize) -> bool {
        let products = &self.gram[number * (number + 1) / 2..];
        let square = products[number];
        self.factors.clear();
        self.factors.extend(self.numbers.iter().map(|taken| products[*taken]));
        solve_transposed(&self.triangle, &mut self.factors);
        let new = square - dot(&self.factors, &self.factors);
        let is_certain = new > LEAST_CERTAIN * LEAST_CERTAIN * square;
        if is_certain {
            self.triangle.extend_from_slice(&self.factors);
            self.triangle.push(new.sqrt());
            self.numbers.push(number);
        }
        is_certain
    }

    /// Adds J z of a direction, and removes its part of the rest.
    fn add(&mut self, number: usize, direction: &Direction, system: &mut impl Equilibrium) {
        let dimension = self.dimension();
        let w = self.room(dimension, direction.z.len());
        system.tangent_product(&direction.z, &direction.response, w);
        let before = norm(w);
        let start = self.triangle.len();
        self.triangle.resize(start + dimension, 0.0);
        let mut length = self.remove_known();
        if length < INACCURATE * before {
            length = self.remove_known();
        }
        self.is_nearly_known = length < LITTLE * before;
        if length.is_nan() || length <= LEAST_NEW * before {
            self.triangle.truncate(start);
            return;
        }
        let over = length.recip();
        let w = &mut self.basis[dimension];
        for w in w.iter_mut() {
            *w *= over;
        }
        let part = dot(w, &self.rest);
        add_scaled(&mut self.rest, -part, w);
        self.triangle.push(length);
        self.numbers.push(number);
        self.weights.push(part);
    }

    /// Removes what is along the basis from the vector after it, adds it to the last column of the
    /// triangle, and returns the length of what is left.
    fn remove_known(&mut self) -> f64 {
        let dimension = self.dimension();
        let (basis, room) = self.basis.split_at_mut(dimension);
        let Some(w) = room.first_mut() else { return 0.0 };
        self.factors.clear();
        self.factors.resize(dimension, 0.0);
        dots(w, basis, &mut self.factors);
        let (triangle, column) = self.triangle.split_at_mut(size_of_triangle(dimension));
        let (of_recycled, _) = self.factors.split_at_mut(self.recycled);
        solve_transposed(triangle, of_recycled);
        for (entry, part) in column.iter_mut().zip(&self.factors) {
            *entry += part;
        }
        solve(triangle, &mut self.factors[..self.recycled]);
        for factor in &mut self.factors {
            *factor = -*factor;
        }
        add_combination(w, &self.factors, basis);
        norm(w)
    }

    /// Whether the recycled directions are in the way of new ones.
    fn stagnates(&self) -> bool {
        self.recycled > 0 && self.is_nearly_known
    }

    /// Adds what the directions make of d and L d.
    fn add_to(&mut self, step: &mut [f64], response: &mut [f64], directions: &[Direction]) {
        solve(&self.triangle, &mut self.weights);
        for (number, weight) in self.numbers.iter().zip(&self.weights) {
            add_scaled(step, *weight, &directions[*number].z);
            add_scaled(response, *weight, &directions[*number].response);
        }
    }
}

/// Entries of a triangular matrix.
fn size_of_triangle(dimension: usize) -> usize {
    dimension * (dimension + 1) / 2
}

/// Solves R x = b in place, with as many columns of a triangular matrix as b has numbers.
fn solve(triangle: &[f64], b: &mut [f64]) {
    for i in (0..b.len()).rev() {
        let column = &triangle[size_of_triangle(i)..];
        let value = b[i] / column[i];
        b[i] = value;
        add_scaled(&mut b[..i], -value, &column[..i]);
    }
}

/// Solves Rᵀ x = b in place, with as many columns of a triangular matrix as b has numbers.
fn solve_transposed(triangle: &[f64], b: &mut [f64]) {
    for i in 0..b.len() {
        let column = &triangle[size_of_triangle(i)..];
        b[i] = (b[i] - dot(&b[..i], &column[..i])) / column[i];
    }
}

impl Directions {
    /// Solves J d = −`residual` until the linear residual falls below `forcing` times its initial
    /// value. Writes d and L d, and returns the number of products. `continues` is asked before
    /// each product of a large system.
    ///
    /// # Errors
    /// That of `continues`.
    pub(super) fn solve(
        &mut self,
        system: &mut impl Equilibrium,
        residual: &[f64],
        forcing: f64,
        ([step, response], continues): ([&mut [f64]; 2], Continues),
    ) -> Result<usize, Error> {
        self.forget(system);
        let goal = forcing * norm(residual);
        let Self { all, known, whole, alone } = self;
        whole.start(residual.iter().map(|r| -r));
        whole.recycle(&all[..*known], system);
        alone.start(whole.rest.iter().copied());
        let first_new = *known;
        let mut products = 0;
        while norm(&whole.rest) > goal && products < MOST_NEW {
            if system.size() > LARGE {
                continues()?;
            }
            if all.len() == *known {
                all.push(Direction::default());
            }
            let (dimension, are_alone) = (whole.dimension(), alone.dimension() > 0);
            let leading = if are_alone { &alone.rest } else { &whole.rest };
            let number = *known;
            all[number].lead_along(system, leading);
            whole.add(number, &all[number], system);
            *known += 1;
            products += 1;
            if !are_alone && whole.stagnates() {
                for (number, new) in all.iter().enumerate().take(*known).skip(first_new) {
                    alone.add(number, new, system);
                }
            } else if whole.dimension() == dimension {
                break;
            } else if are_alone {
                alone.add(number, &all[number], system);
            }
        }
        step.fill(0.0);
        response.fill(0.0);
        whole.add_to(step, response, all);
        Ok(products)
    }

    /// Forgets all directions.
    pub(super) fn clear(&mut self) {
        self.known = 0;
    }

    /// Forgets the oldest directions, and all of another system.
    fn forget(&mut self, system: &impl Equilibrium) {
        let is_of_this = |direction: &Direction| {
            direction.z.len() == system.size() && direction.response.len() == system.response_size()
        };
        if !self.all[..self.known].iter().all(is_of_this) {
            self.known = 0;
        }
        let old = self.known.saturating_sub(KEPT);
        self.all[..self.known].rotate_left(old);
        self.known -= old;
    }
}

impl Direction {
    /// Makes it what the preconditioner gives for the residual, scaled to unit length.
    fn lead_along(&mut self, system: &mut impl Equilibrium, residual: &[f64]) {
        let Self { z, response } = self;
        z.clear();
        z.extend_from_slice(residual);
        let over = norm(z).max(f64::MIN_POSITIVE).recip();
        for z in z.iter_mut() {
            *z *= over;
        }
        system.precondition(z);
        response.resize(system.response_size(), 0.0);
        system.compliance_product(z, response);
    }
}

#[cfg(test)]
mod tests {
    use super::{Directions, Equilibrium, KEPT};
    use crate::numerics::vector::norm;

    /// Diffusion and convection along a line, L, and a local part that changes from system to
    /// system, with the latter's inverse as preconditioner.
    struct Line {
        local: Vec<f64>,
    }

    impl Line {
        fn new(number: usize) -> Self {
            let local = |i: usize| 1.0 + ((i * i + number * i) % 7) as f64;
            Self { local: (0..SIZE).map(local).collect() }
        }
    }

    const SIZE: usize = 150;

    impl Equilibrium for Line {
        fn size(&self) -> usize {
            SIZE
        }

        fn scale(&self, _p: &[f64]) -> f64 {
            1.0
        }

        fn compliance_product(&mut self, p: &[f64], u: &mut [f64]) {
            for i in 0..SIZE {
                let before = if i > 0 { p[i - 1] } else { 0.0 };
                let after = p.get(i + 1).copied().unwrap_or(0.0);
                u[i] = 2.0 * p[i] - 1.3 * before - 0.7 * after;
            }
        }

        fn defect(&mut self, _p: &[f64], _u: &[f64]) -> f64 {
            0.0
        }

        fn residual(&mut self, _p: &[f64], _u: &[f64], _residual: &mut [f64]) {}

        fn tangent_product(&mut self, v: &[f64], response: &[f64], product: &mut [f64]) {
            for i in 0..SIZE {
                product[i] = response[i] + self.local[i] * v[i];
            }
        }

        fn precondition(&mut self, v: &mut [f64]) {
            for (v, local) in v.iter_mut().zip(&self.local) {
                *v /= local + 2.0;
            }
        }
    }

    /// Solves J d = −F, and checks that it is solved: what is left, and that L d is that of d.
    fn solve(directions: &mut Directions, line: &mut Line, rhs: &[f64], forcing: f64) -> usize {
        let (mut step, mut response) = (vec![0.0; SIZE], vec![0.0; SIZE]);
        let target = [step.as_mut_slice(), response.as_mut_slice()];
        let products = directions.solve(line, rhs, forcing, (target, &|| Ok(()))).unwrap();
        let (mut again, mut product) = (vec![0.0; SIZE], vec![0.0; SIZE]);
        line.compliance_product(&step, &mut again);
        for (one, two) in response.iter().zip(&again) {
            assert!((one - two).abs() < 1e-12 * norm(&again), "{one} {two}");
        }
        line.tangent_product(&step, &again, &mut product);
        let rest: Vec<_> = product.iter().zip(rhs).map(|(product, rhs)| product + rhs).collect();
        let allowed = forcing * (1.0 + 1e-6) * norm(rhs);
        assert!(norm(&rest) < allowed, "{} {allowed}", norm(&rest));
        products
    }

    /// Systems that differ by less and less: their directions depend on each other nearly, then
    /// entirely, and are more than are kept.
    #[test]
    fn systems_are_solved_with_whatever_is_known() {
        let mut directions = Directions::default();
        let rhs = |change: f64| -> Vec<f64> {
            (0..SIZE).map(|i| 1.0 + change * (i as f64).sin()).collect()
        };
        let first = solve(&mut directions, &mut Line::new(0), &rhs(0.0), 1e-8);
        for (number, change) in [1.0, 1e-2, 1e-4, 1e-8, 1e-12, 0.0].into_iter().enumerate() {
            let mut line = Line::new(number / 3);
            solve(&mut directions, &mut line, &rhs(change), 1e-8);
            assert!(directions.known < 2 * KEPT + first);
        }
        let mut line = Line::new(1);
        assert_eq!(solve(&mut directions, &mut line, &rhs(0.0), 1e-6), 0);
        directions.clear();
        assert_eq!(solve(&mut directions, &mut Line::new(0), &rhs(0.0), 1e-8), first);
    }
}
