//! Minimal residuals over all directions known so far, those of earlier linear systems included.
//!
//! The expensive part of the Jacobian is linear and the same in every Newton step: with a direction
//! z and its response L z, J z costs no product, whatever the tangent is now. So each system first
//! minimises its residual over the directions of those before it, and only then asks for new ones,
//! the preconditioned residuals (generalised conjugate residuals, Eisenstat, Elman and Schultz
//! 1983; recycling: Parks et al. 2006). Without earlier directions this is GMRES.

use super::{Continues, Equilibrium, LARGE};
use crate::error::Error;
use crate::numerics::vector::{add_scaled, dot, norm};

/// Directions with their responses, the oldest first, and the workspace of a solution: kept, so
/// that only more directions than ever before allocate.
#[derive(Debug, Default)]
pub struct Directions {
    /// Those that are known, followed by room for more.
    all: Vec<Direction>,
    known: usize,
    projection: Projection,
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

/// Length of what is new in J z, relative to J z, below which it is made orthogonal once more:
/// cancellation has then made it inaccurate.
const INACCURATE: f64 = 0.5;

/// A linear system J d = −F that is being solved.
#[derive(Debug, Default)]
struct Projection {
    /// What is left of −F.
    rest: Vec<f64>,
    /// Orthonormal basis of all J z, followed by room for more.
    basis: Vec<Vec<f64>>,
    /// The direction of each vector of the basis.
    numbers: Vec<usize>,
    /// J z of these directions in terms of the basis: the columns of a triangular matrix, one after
    /// another, each one longer than the previous one.
    triangle: Vec<f64>,
    /// −F in terms of the basis, and then the weight of each direction.
    weights: Vec<f64>,
}

impl Projection {
    fn start(&mut self, residual: &[f64]) {
        self.rest.clear();
        self.rest.extend(residual.iter().map(|r| -r));
        self.numbers.clear();
        self.triangle.clear();
        self.weights.clear();
    }

    fn dimension(&self) -> usize {
        self.numbers.len()
    }

    /// Adds J z of a direction, and removes its part of the rest.
    fn add(&mut self, number: usize, direction: &Direction, system: &mut impl Equilibrium) {
        let dimension = self.dimension();
        if self.basis.len() == dimension {
            self.basis.push(Vec::new());
        }
        let (basis, room) = self.basis.split_at_mut(dimension);
        let Some(w) = room.first_mut() else { return };
        w.resize(direction.z.len(), 0.0);
        system.tangent_product(&direction.z, &direction.response, w);
        let before = norm(w);
        let start = self.triangle.len();
        self.triangle.resize(start + dimension, 0.0);
        let column = &mut self.triangle[start..];
        let mut length = remove(w, basis, column);
        if length < INACCURATE * before {
            length = remove(w, basis, column);
        }
        if length.is_nan() || length <= LEAST_NEW * before {
            self.triangle.truncate(start);
            return;
        }
        let over = length.recip();
        for w in w.iter_mut() {
            *w *= over;
        }
        let part = dot(w, &self.rest);
        add_scaled(&mut self.rest, -part, w);
        self.triangle.push(length);
        self.numbers.push(number);
        self.weights.push(part);
    }

    /// Turns −F in terms of the basis into the weights of the directions.
    fn weigh(&mut self) {
        for i in (0..self.dimension()).rev() {
            let start = i * (i + 1) / 2;
            let weight = self.weights[i] / self.triangle[start + i];
            self.weights[i] = weight;
            for (earlier, entry) in self.weights[..i].iter_mut().zip(&self.triangle[start..]) {
                *earlier -= entry * weight;
            }
        }
    }
}

/// Removes the components along the vectors of an orthonormal basis, adds them to `column`, and
/// returns the length of what is left.
fn remove(w: &mut [f64], basis: &[Vec<f64>], column: &mut [f64]) -> f64 {
    for (entry, q) in column.iter_mut().zip(basis) {
        let part = dot(w, q);
        *entry += part;
        add_scaled(w, -part, q);
    }
    norm(w)
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
        let Self { all, known, projection } = self;
        projection.start(residual);
        for (number, direction) in all[..*known].iter().enumerate() {
            projection.add(number, direction, system);
        }
        let mut products = 0;
        while norm(&projection.rest) > goal && products < MOST_NEW {
            if system.size() > LARGE {
                continues()?;
            }
            if all.len() == *known {
                all.push(Direction::default());
            }
            let dimension = projection.dimension();
            all[*known].lead_along(system, &projection.rest);
            projection.add(*known, &all[*known], system);
            *known += 1;
            products += 1;
            if projection.dimension() == dimension {
                break;
            }
        }
        projection.weigh();
        step.fill(0.0);
        response.fill(0.0);
        for (number, weight) in projection.numbers.iter().zip(&projection.weights) {
            add_scaled(step, *weight, &all[*number].z);
            add_scaled(response, *weight, &all[*number].response);
        }
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
