//! Generalised minimal residual method (Saad and Schultz 1986), preconditioned from the right.

use super::{Continues, Equilibrium, LARGE};
use crate::error::Error;
use crate::numerics::vector::{add_scaled, dot, norm};

/// Workspace of the Krylov method: kept between solutions, so that only a larger Krylov space than
/// before allocates.
#[derive(Debug)]
pub(crate) struct Gmres {
    /// Largest dimension of the Krylov space.
    max_dimension: usize,
    basis: Vec<Vec<f64>>,
    /// M⁻¹ v of each vector of the basis: a pass of the preconditioner costs more than keeping it.
    directions: Vec<Vec<f64>>,
    /// L M⁻¹ v of each vector of the basis.
    responses: Vec<Vec<f64>>,
    /// Columns of the triangular matrix, one after another, each one longer than the previous one.
    triangle: Vec<f64>,
    rotations: Vec<(f64, f64)>,
    projected: Vec<f64>,
    weights: Vec<f64>,
}

/// Start of a column in a packed triangular matrix.
fn start_of_column(k: usize) -> usize {
    k * (k + 1) / 2
}

/// Largest dimension of a Krylov space unless another one is asked for: if that is not sufficient,
/// the step is inexact.
const MAX_DIMENSION: usize = 120;

impl Default for Gmres {
    fn default() -> Self {
        Self::new(MAX_DIMENSION)
    }
}

impl Gmres {
    /// An empty workspace.
    pub fn new(max_dimension: usize) -> Self {
        Self {
            max_dimension,
            basis: Vec::new(),
            directions: Vec::new(),
            responses: Vec::new(),
            triangle: Vec::new(),
            rotations: Vec::new(),
            projected: Vec::new(),
            weights: Vec::new(),
        }
    }

    /// Solves J d = −`residual` until the linear residual falls below `forcing` times its initial
    /// value. Writes d and L d (which costs no product: it is combined from those of the Krylov
    /// space), and returns the number of products. `continues` is asked before each product of a
    /// large system; the others are solved in a moment.
    ///
    /// # Errors
    /// That of `continues`.
    pub fn solve(
        &mut self,
        system: &mut impl Equilibrium,
        residual: &[f64],
        forcing: f64,
        ([step, response], continues): ([&mut [f64]; 2], Continues),
    ) -> Result<usize, Error> {
        let start = norm(residual);
        self.prepare(system);
        for (v, r) in self.basis[0].iter_mut().zip(residual) {
            *v = -r / start;
        }
        self.projected.push(start);
        while self.rotations.len() < self.max_dimension.min(residual.len()) {
            if self.projected[self.rotations.len()].abs() <= forcing * start {
                break;
            }
            if system.size() > LARGE {
                continues()?;
            }
            self.extend(system);
        }
        self.combine(step, response);
        Ok(self.rotations.len())
    }

    /// Empties the space for a new system.
    fn prepare(&mut self, system: &impl Equilibrium) {
        self.triangle.clear();
        self.rotations.clear();
        self.projected.clear();
        self.grow(system, 0);
    }

    /// Allocates vectors of the right length for one more dimension.
    fn grow(&mut self, system: &impl Equilibrium, dimension: usize) {
        if self.basis.len() <= dimension {
            self.basis.push(Vec::new());
            self.directions.push(Vec::new());
            self.responses.push(Vec::new());
        }
        self.basis[dimension].resize(system.size(), 0.0);
        self.directions[dimension].resize(system.size(), 0.0);
        self.responses[dimension].resize(system.response_size(), 0.0);
    }

    /// Performs one Arnoldi step, with the Givens rotation that keeps the projected matrix
    /// triangular.
    fn extend(&mut self, system: &mut impl Equilibrium) {
        let k = self.rotations.len();
        self.grow(system, k + 1);
        let direction = &mut self.directions[k];
        direction.copy_from_slice(&self.basis[k]);
        system.precondition(direction);
        system.compliance_product(direction, &mut self.responses[k]);
        let (earlier, later) = self.basis.split_at_mut(k + 1);
        let w = &mut later[0];
        system.tangent_product(&self.directions[k], &self.responses[k], w);

        self.triangle.resize(start_of_column(k + 1), 0.0);
        let column = &mut self.triangle[start_of_column(k)..];
        for (entry, v) in column.iter_mut().zip(earlier) {
            *entry = dot(w, v);
            add_scaled(w, -*entry, v);
        }
        let length = norm(w);
        for (i, (cosine, sine)) in self.rotations.iter().enumerate() {
            let (upper, lower) = (column[i], column[i + 1]);
            column[i] = cosine * upper + sine * lower;
            column[i + 1] = cosine * lower - sine * upper;
        }
        let radius = column[k].hypot(length).max(f64::MIN_POSITIVE);
        let (cosine, sine) = (column[k] / radius, length / radius);
        column[k] = radius;
        self.rotations.push((cosine, sine));
        let projected = self.projected[k];
        self.projected[k] = cosine * projected;
        self.projected.push(-sine * projected);
        if length > 0.0 {
            let over = length.recip();
            for w in w {
                *w *= over;
            }
        }
    }

    /// d = Σ weight · direction, L d = Σ weight · response.
    fn combine(&mut self, step: &mut [f64], response: &mut [f64]) {
        step.fill(0.0);
        response.fill(0.0);
        let dimension = self.rotations.len();
        self.weights.clear();
        self.weights.extend_from_slice(&self.projected[..dimension]);
        for i in (0..dimension).rev() {
            for j in i + 1..dimension {
                self.weights[i] -= self.triangle[start_of_column(j) + i] * self.weights[j];
            }
            self.weights[i] /= self.triangle[start_of_column(i) + i];
            add_scaled(step, self.weights[i], &self.directions[i]);
            add_scaled(response, self.weights[i], &self.responses[i]);
        }
    }
}
