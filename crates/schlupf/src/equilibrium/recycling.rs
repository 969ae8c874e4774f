//! Minimal residuals over all directions known so far, those of earlier linear systems included.
//!
//! The expensive part of the Jacobian is linear and the same in every Newton step: with a direction
//! z and its response L z, J z costs no product, whatever the tangent is now. So each system first
//! minimises its residual over the directions of those before it, and only then asks for new ones,
//! the preconditioned residuals (generalised conjugate residuals, Eisenstat, Elman and Schultz
//! 1983; recycling: Parks et al. 2006). Without earlier directions this is GMRES.

use super::Equilibrium;
use crate::numerics::vector::{add_scaled, dot, norm};

/// Directions with their responses, the oldest first.
#[derive(Debug, Default)]
pub struct Directions {
    known: Vec<Direction>,
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

/// A linear system J d = −F that is being solved.
struct Projection {
    /// What is left of −F.
    rest: Vec<f64>,
    /// Orthonormal basis of all J z.
    basis: Vec<Vec<f64>>,
    /// The direction of each vector of the basis, and J z in terms of the basis.
    columns: Vec<(usize, Vec<f64>)>,
    /// −F in terms of the basis.
    projected: Vec<f64>,
}

impl Projection {
    /// Adds J z of a direction, and removes its part of the rest.
    fn add(&mut self, direction: usize, mut w: Vec<f64>) {
        let before = norm(&w);
        let mut column = vec![0.0; self.basis.len()];
        // Twice, because J z of a recycled direction may nearly depend on others.
        for _ in 0..2 {
            for (entry, q) in column.iter_mut().zip(&self.basis) {
                let part = dot(&w, q);
                *entry += part;
                add_scaled(&mut w, -part, q);
            }
        }
        let length = norm(&w);
        if length.is_nan() || length <= LEAST_NEW * before {
            return;
        }
        for w in &mut w {
            *w /= length;
        }
        let part = dot(&w, &self.rest);
        add_scaled(&mut self.rest, -part, &w);
        column.push(length);
        self.columns.push((direction, column));
        self.projected.push(part);
        self.basis.push(w);
    }

    /// The weight of the direction of each vector of the basis.
    fn weights(&self) -> Vec<f64> {
        let mut weights = self.projected.clone();
        for i in (0..weights.len()).rev() {
            weights[i] /= self.columns[i].1[i];
            for j in 0..i {
                weights[j] -= self.columns[i].1[j] * weights[i];
            }
        }
        weights
    }
}

impl Directions {
    /// Solves J d = −`residual` until the linear residual falls below `forcing` times its initial
    /// value. Writes d and L d, and returns the number of products.
    pub(super) fn solve(
        &mut self,
        system: &mut impl Equilibrium,
        residual: &[f64],
        forcing: f64,
        [step, response]: [&mut [f64]; 2],
    ) -> usize {
        self.forget(system);
        let goal = forcing * norm(residual);
        let mut projection = Projection {
            rest: residual.iter().map(|r| -r).collect(),
            basis: Vec::new(),
            columns: Vec::new(),
            projected: Vec::new(),
        };
        for (number, direction) in self.known.iter().enumerate() {
            projection.add(number, direction.through(system));
        }
        let mut products = 0;
        while norm(&projection.rest) > goal && products < MOST_NEW {
            let dimension = projection.basis.len();
            let direction = Direction::along(system, &projection.rest);
            projection.add(self.known.len(), direction.through(system));
            self.known.push(direction);
            products += 1;
            if projection.basis.len() == dimension {
                break;
            }
        }
        step.fill(0.0);
        response.fill(0.0);
        for ((number, _), weight) in projection.columns.iter().zip(projection.weights()) {
            add_scaled(step, weight, &self.known[*number].z);
            add_scaled(response, weight, &self.known[*number].response);
        }
        products
    }

    /// Removes the oldest directions, and all of another system.
    fn forget(&mut self, system: &impl Equilibrium) {
        let is_of_this = |direction: &Direction| {
            direction.z.len() == system.size() && direction.response.len() == system.response_size()
        };
        self.known.retain(is_of_this);
        self.known.drain(..self.known.len().saturating_sub(KEPT));
    }
}

impl Direction {
    /// The preconditioned residual, of unit length.
    fn along(system: &mut impl Equilibrium, residual: &[f64]) -> Self {
        let mut z = residual.to_vec();
        system.precondition(&mut z);
        let over = norm(&z).max(f64::MIN_POSITIVE).recip();
        for z in &mut z {
            *z *= over;
        }
        let mut response = vec![0.0; system.response_size()];
        system.compliance_product(&z, &mut response);
        Self { z, response }
    }

    /// J z.
    fn through(&self, system: &mut impl Equilibrium) -> Vec<f64> {
        let mut product = vec![0.0; self.z.len()];
        system.tangent_product(&self.z, &self.response, &mut product);
        product
    }
}
