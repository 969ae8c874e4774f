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
use crate::numerics::vector::{add_combination, add_scaled, dot, dots, gram, norm};
use crate::reporting::Error;
use crate::solver::settings;

/// Directions with their responses, the oldest first, and the workspace of a solution: kept, so
/// that only more directions than ever before allocate.
#[derive(Debug, Default)]
pub struct Directions {
    /// Those that are known, followed by room for more.
    all: Vec<Direction>,
    known: usize,
    whole: Projection,
    /// Over the new directions alone, once the recycled space stagnates.
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
    /// A system without a basis, with the right-hand side −F.
    fn start(&mut self, rhs: impl Iterator<Item = f64>) {
        self.take(rhs);
        self.recycled = 0;
        self.numbers.clear();
        self.triangle.clear();
        self.weights.clear();
    }

    /// Another right-hand side.
    fn take(&mut self, rhs: impl Iterator<Item = f64>) {
        self.rest.clear();
        self.rest.extend(rhs);
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
            if self.adopt(number) {
                self.basis.swap(self.recycled, number);
                self.recycled += 1;
            } else {
                doubtful.push(number);
            }
        }
        self.weigh();
        for number in doubtful {
            self.add(number, &directions[number], system);
        }
    }

    /// Weighs the basis for a rest that is all of −F, and removes the part along it.
    fn weigh(&mut self) {
        let (dimension, recycled) = (self.dimension(), self.recycled);
        let basis = &self.basis[..dimension];
        self.weights.resize(dimension, 0.0);
        dots(&self.rest, basis, &mut self.weights);
        solve_transposed(&self.triangle, &mut self.weights[..recycled]);
        self.factors.clear();
        self.factors.extend(self.weights.iter().map(|weight| -weight));
        solve(&self.triangle, &mut self.factors[..recycled]);
        add_combination(&mut self.rest, &self.factors, basis);
    }

    /// Adds the column of a recycled direction to the triangle, unless too little of it is new for
    /// the products of pairs to tell.
    fn adopt(&mut self, number: usize) -> bool {
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

    /// Whether the recycled space stagnates.
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
        targets: ([&mut [f64]; 2], Continues),
    ) -> Result<usize, Error> {
        self.forget(system);
        self.whole.start(residual.iter().map(|r| -r));
        self.whole.recycle(&self.all[..self.known], system);
        self.find(system, forcing * norm(residual), targets)
    }

    /// The same with the Jacobian of the last system.
    ///
    /// # Errors
    /// That of `continues`.
    pub(crate) fn solve_again(
        &mut self,
        system: &mut impl Equilibrium,
        residual: &[f64],
        forcing: f64,
        targets: ([&mut [f64]; 2], Continues),
    ) -> Result<usize, Error> {
        self.whole.take(residual.iter().map(|r| -r));
        self.whole.weigh();
        self.find(system, forcing * norm(residual), targets)
    }

    /// Adds directions until the rest is small.
    fn find(
        &mut self,
        system: &mut impl Equilibrium,
        goal: f64,
        ([step, response], continues): ([&mut [f64]; 2], Continues),
    ) -> Result<usize, Error> {
        let Self { all, known, whole, alone } = self;
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

    /// Adds a direction with its response.
    pub(crate) fn add(&mut self, z: &[f64], response: &[f64]) {
        if self.all.len() == self.known {
            self.all.push(Direction::default());
        }
        let room = &mut self.all[self.known];
        self.known += 1;
        for (room, given) in [(&mut room.z, z), (&mut room.response, response)] {
            room.clear();
            room.extend_from_slice(given);
        }
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
mod tests;
