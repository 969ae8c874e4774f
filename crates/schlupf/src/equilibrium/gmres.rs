//! Generalised minimal residuals (Saad and Schultz 1986), preconditioned from the right.

use super::{Equilibrium, add_scaled, dot, norm};

/// Workspace of the Krylov method: kept between solutions.
#[derive(Debug, Default)]
pub(super) struct Gmres {
    basis: Vec<Vec<f64>>,
    directions: Vec<Vec<f64>>,
    compliance_directions: Vec<Vec<f64>>,
    hessenberg: Vec<Vec<f64>>,
    rotations: Vec<(f64, f64)>,
    projected: Vec<f64>,
}

/// Largest dimension of the Krylov space.
const MAX_DIMENSION: usize = 120;

impl Gmres {
    /// Solves J d = −`residual` until the linear residual falls below `forcing` times its start.
    /// Writes d and A d (which costs no product: it is combined from those of the Krylov space),
    /// and returns the number of products with A.
    pub fn solve(
        &mut self,
        system: &mut impl Equilibrium,
        residual: &[f64],
        forcing: f64,
        [step, compliance_step]: [&mut [f64]; 2],
    ) -> usize {
        let size = residual.len();
        let start = norm(residual);
        self.clear();
        self.projected.push(start);
        self.basis.push(residual.iter().map(|r| -r / start).collect());
        while self.rotations.len() < MAX_DIMENSION.min(size) {
            if self.projected[self.rotations.len()].abs() <= forcing * start {
                break;
            }
            self.extend(system);
        }
        self.combine(step, compliance_step);
        self.rotations.len()
    }

    fn clear(&mut self) {
        self.basis.clear();
        self.directions.clear();
        self.compliance_directions.clear();
        self.hessenberg.clear();
        self.rotations.clear();
        self.projected.clear();
    }

    /// One Arnoldi step, and the Givens rotation that keeps the projected matrix triangular.
    fn extend(&mut self, system: &mut impl Equilibrium) {
        let k = self.rotations.len();
        let mut direction = self.basis[k].clone();
        system.precondition(&mut direction);
        let mut compliance = vec![0.0; direction.len()];
        system.compliance_product(&direction, &mut compliance);
        let mut w = vec![0.0; direction.len()];
        system.tangent_product(&direction, &compliance, &mut w);
        self.directions.push(direction);
        self.compliance_directions.push(compliance);

        let mut column = Vec::with_capacity(k + 2);
        for v in &self.basis {
            let overlap = dot(&w, v);
            add_scaled(&mut w, -overlap, v);
            column.push(overlap);
        }
        let length = norm(&w);
        for (i, (cosine, sine)) in self.rotations.iter().enumerate() {
            let (upper, lower) = (column[i], column[i + 1]);
            column[i] = cosine * upper + sine * lower;
            column[i + 1] = cosine * lower - sine * upper;
        }
        let radius = column[k].hypot(length).max(f64::MIN_POSITIVE);
        let (cosine, sine) = (column[k] / radius, length / radius);
        column[k] = radius;
        self.hessenberg.push(column);
        self.rotations.push((cosine, sine));
        let projected = self.projected[k];
        self.projected[k] = cosine * projected;
        self.projected.push(-sine * projected);
        if length > 0.0 {
            for w in &mut w {
                *w /= length;
            }
        }
        self.basis.push(w);
    }

    fn combine(&self, step: &mut [f64], compliance_step: &mut [f64]) {
        step.fill(0.0);
        compliance_step.fill(0.0);
        let dimension = self.rotations.len();
        let mut weights = self.projected[..dimension].to_vec();
        for i in (0..dimension).rev() {
            for j in i + 1..dimension {
                weights[i] -= self.hessenberg[j][i] * weights[j];
            }
            weights[i] /= self.hessenberg[i][i];
            add_scaled(step, weights[i], &self.directions[i]);
            add_scaled(compliance_step, weights[i], &self.compliance_directions[i]);
        }
    }
}
