//! Minimal residuals over all directions known so far, those of earlier linear systems included.
//!
//! The expensive part of the Jacobian is linear and the same in every Newton step: with a direction
//! z and its response L z, J z costs no product, whatever the tangent is now. So each system first
//! minimises its residual over the directions of those before it, and only then asks for new ones,
//! the preconditioned residuals (generalised conjugate residuals, Eisenstat, Elman and Schultz
//! 1983; recycling: Parks et al. 2006). Where the earlier ones leave little of a new one, the next
//! ones follow the residuals that the new ones alone would leave, as if the method had begun from
//! what the earlier ones left; the residual is still minimised over all. Where a residual leads to
//! nothing new, another one takes its place, and in the end the newest response, as in GMRES.

use super::{Continues, Equilibrium};
use crate::error::Error;
use crate::numerics::vector::{add_combination, add_scaled, dot, dots, gram, norm};
use crate::settings;

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

    fn is_used(&self) -> bool {
        self.dimension() > 0
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
        let is_certain = new > settings::least_new_part() * square;
        if is_certain {
            self.triangle.extend_from_slice(&self.factors);
            self.triangle.push(new.sqrt());
            self.numbers.push(number);
        }
        is_certain
    }

    /// Adds J z of a direction, removes its part of the rest, and returns whether anything of it
    /// was new.
    fn add(&mut self, number: usize, direction: &Direction, system: &mut impl Equilibrium) -> bool {
        let dimension = self.dimension();
        let w = self.room(dimension, direction.z.len());
        system.tangent_product(&direction.z, &direction.response, w);
        let before = norm(w);
        let start = self.triangle.len();
        self.triangle.resize(start + dimension, 0.0);
        let mut length = self.remove_known();
        if length < settings::cancelled_part() * before {
            length = self.remove_known();
        }
        self.is_nearly_known = length < settings::stagnating_part() * before;
        if length.is_nan() || length <= settings::least_new_part() * before {
            self.triangle.truncate(start);
            return false;
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
        true
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

    /// The newest vector of the basis that was added by itself.
    fn newest(&self) -> Option<&Vec<f64>> {
        let dimension = self.dimension();
        (dimension > self.recycled).then(|| &self.basis[dimension - 1])
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

/// What the next direction follows, after so many that led to nothing new.
fn leading<'a>(
    whole: &'a Projection,
    alone: &'a Projection,
    useless: usize,
) -> Option<&'a Vec<f64>> {
    let leaders = [alone.is_used().then_some(&alone.rest), Some(&whole.rest), whole.newest()];
    leaders.into_iter().flatten().nth(useless)
}

impl Directions {
    /// Solves J d = −`residual` until the linear residual falls below `forcing` times its initial
    /// value, or no direction brings anything new, or there are too many: Newton's method, which
    /// sees the true residual, decides what a step that is less exact is worth. Writes d and L d,
    /// and returns the number of products. `continues` is asked before each product.
    ///
    /// # Errors
    /// That of `continues`.
    pub(crate) fn solve(
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
        let (first_new, mut useless) = (*known, 0);
        let mut products = 0;
        while norm(&whole.rest) > goal && products < settings::most_directions() {
            continues()?;
            let Some(leading) = leading(whole, alone, useless) else { break };
            let number = *known;
            if all.len() == number {
                all.push(Direction::default());
            }
            all[number].lead_along(system, leading);
            products += 1;
            let is_new = whole.add(number, &all[number], system);
            *known += usize::from(is_new);
            useless = if is_new { 0 } else { useless + 1 };
            if alone.is_used() {
                alone.add(number, &all[number], system);
            } else if whole.stagnates() {
                for (number, new) in all.iter().enumerate().take(number + 1).skip(first_new) {
                    alone.add(number, new, system);
                }
                useless = 0;
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
        let old = self.known.saturating_sub(settings::directions_kept());
        self.all[..self.known].rotate_left(old);
        self.known -= old;
    }
}

impl Direction {
    /// Makes it what the preconditioner gives for a residual that is scaled to unit length.
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
    use super::{Directions, Equilibrium};
    use crate::numerics::vector::norm;
    use crate::settings;

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
        let rhs = |change: f64| -> Vec<f64> {
            (0..SIZE).map(|i| 1.0 + change * (i as f64).sin()).collect()
        };
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
}
