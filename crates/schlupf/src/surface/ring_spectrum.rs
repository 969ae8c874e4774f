//! The spectrum of an isotropic surface from that of a line across it.
//!
//! The spectrum of a line across an isotropic surface is C₁(qₓ) = ∫ C(√(qₓ² + q_y²)) dq_y, an Abel
//! transform (Nayak 1971). A single line scatters: the standard deviation of the variance of each
//! of its waves is as large as the variance itself, and inverting the transform amplifies this.
//! Therefore the surface is sought whose spectrum C, constant in rings, makes the line likely
//! (Whittle 1953) and is smooth: with the mean variance I_k of the line in band k, n_k independent
//! waves in it, and S_k = Σ_j K_kj exp θ_j of the rings' ln C = θ,
//!
//! Σ_k n_k (ln S_k + I_k/S_k) + λ Σ_j ψ(d_j)
//!
//! is minimised, where d_j is the change of the exponent d ln C/d ln q from ring to ring and ψ(d) =
//! ½ ε² ln(1 + d²/ε²) tolerates abrupt beginnings and ends of a spectrum. The minimum is found by
//! Fisher's scoring with Levenberg–Marquardt damping. C is positive by construction.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Cholesky, DMatrix, DVector};

/// A spectrum of an isotropic surface, constant in rings of wave vectors.
#[derive(Debug, Clone, PartialEq)]
pub struct RingSpectrum {
    /// Edges of the rings, in rad/m.
    edges: Vec<f64>,
    /// C(q) in each ring, in m⁴.
    densities: Vec<f64>,
}

/// Number of bands of wave numbers per decade, where there are as many waves.
const BANDS_IN_DECADE: f64 = 25.0;

/// λ and ε, dimensionless.
const SMOOTHNESS: f64 = 1.0;
const FORGIVEN: f64 = 5.0;

/// Fraction of the largest variance below which nothing is left; dimensionless.
const FLOOR: f64 = 1e-14;

/// Maximum number of scoring steps, the decrease that ends them, and the largest change of ln C in
/// one step.
const STEPS: usize = 300;
const SETTLED: f64 = 1e-6;
const LARGEST_CHANGE: f64 = 5.0;
const LARGEST_DAMPING: f64 = 1e12;

impl RingSpectrum {
    /// The spectrum of the surface of a line that has these mean variances (in m²) in bands of wave
    /// numbers with this step (in rad/m), from so many observations of each wave; without longer
    /// waves.
    pub(super) fn of_line(
        step: f64,
        bands: &[usize],
        variances: &[f64],
        observations: f64,
    ) -> Self {
        let edges: Vec<f64> = bands.iter().map(|band| (*band as f64 - 0.5) * step).collect();
        let largest = variances.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let relative = variances.iter().map(|mean| mean.max(FLOOR * largest) / largest).collect();
        let likelihood = Likelihood::new(relative, bands, observations);
        let densities = likelihood.most_likely();
        // The rings were counted in waves, the line in units of its largest variance.
        let unit = largest / (step * step);
        Self { densities: densities.iter().map(|theta| unit * theta.exp()).collect(), edges }
    }

    /// C(q) (in m⁴) at a wave number (in rad/m); zero outside all rings.
    pub fn density(&self, wave_number: f64) -> f64 {
        let above = self.edges.partition_point(|edge| *edge <= wave_number);
        above.checked_sub(1).and_then(|ring| self.densities.get(ring)).copied().unwrap_or(0.0)
    }

    /// Root mean square height √(2π ∫ C q dq), in m.
    pub fn root_mean_square_height(&self) -> f64 {
        self.height_between([0.0, f64::INFINITY])
    }

    /// Root mean square height (in m) of the waves between two wave numbers (in rad/m).
    pub fn height_between(&self, [low, high]: [f64; 2]) -> f64 {
        self.moment([low, high], |q| PI * q * q).sqrt()
    }

    /// Root mean square gradient √(2π ∫ C q³ dq), dimensionless.
    pub fn root_mean_square_gradient(&self) -> f64 {
        self.moment([0.0, f64::INFINITY], |q| 0.5 * PI * q.powi(4)).sqrt()
    }

    /// The same spectrum with all heights multiplied by a factor (dimensionless).
    pub(super) fn scaled(self, factor: f64) -> Self {
        let densities = self.densities.iter().map(|density| factor * factor * density).collect();
        Self { densities, ..self }
    }

    fn moment(&self, [low, high]: [f64; 2], integral: impl Fn(f64) -> f64) -> f64 {
        let rings = self.edges.windows(2).zip(&self.densities);
        let part = |edges: &[f64]| {
            let [from, to] = [edges[0], edges[1]].map(|edge| edge.clamp(low, high));
            integral(to) - integral(from)
        };
        rings.map(|(edges, density)| density * part(edges)).sum()
    }
}

/// First wave of each band, and the end of the last one.
pub(super) fn bands(mut first: usize, end: usize) -> Vec<usize> {
    let widening = libm::pow(10.0, BANDS_IN_DECADE.recip());
    let mut bands = vec![first];
    loop {
        let next = (first + 1).max((first as f64 * widening).ceil() as usize);
        if next >= end {
            bands.push(end);
            return bands;
        }
        bands.push(next);
        first = next;
    }
}

/// Area of a disc within the distance `half_width` of a line through its centre.
fn strip(radius: f64, half_width: f64) -> f64 {
    let angle = if half_width < radius { (half_width / radius).asin() } else { FRAC_PI_2 };
    radius * radius * (2.0 * angle + (2.0 * angle).sin())
}

/// Likelihood of a line and smoothness of the spectrum; wave numbers are counted in waves.
struct Likelihood {
    /// I.
    line: Vec<f64>,
    /// n.
    independent: Vec<f64>,
    /// K: variance of a wave in a band (row) for C = 1 in a ring (column).
    shares: DMatrix<f64>,
    /// Inverse distances between the rings in ln q.
    closeness: Vec<f64>,
}

impl Likelihood {
    fn new(line: Vec<f64>, bands: &[usize], observations: f64) -> Self {
        let count = line.len();
        let edge = |band: usize| bands[band] as f64 - 0.5;
        let waves = |band: usize| (bands[band + 1] - bands[band]) as f64;
        let shares = DMatrix::from_fn(count, count, |band, ring| {
            let within = |radius: f64| strip(radius, edge(band + 1)) - strip(radius, edge(band));
            (within(edge(ring + 1)) - within(edge(ring))) / waves(band)
        });
        let middle = |ring: usize| 0.5 * (edge(ring) * edge(ring + 1)).ln();
        let closeness = (1..count).map(|ring| (middle(ring) - middle(ring - 1)).recip()).collect();
        let independent = (0..count).map(|band| observations * waves(band)).collect();
        Self { line, independent, shares, closeness }
    }

    /// The θ = ln C for which the line is most likely.
    fn most_likely(&self) -> Vec<f64> {
        let count = self.line.len();
        let mut theta: Vec<f64> =
            (0..count).map(|ring| (self.line[ring] / self.shares[(ring, ring)]).ln()).collect();
        let mut cost = self.cost(&theta);
        let mut damping = 1e-3;
        for _ in 0..STEPS {
            let (matrix, gradient) = self.scoring(&theta);
            let (trial, trial_cost) = loop {
                if let Some(trial) = moved(&theta, &matrix, &gradient, damping) {
                    let trial_cost = self.cost(&trial);
                    if trial_cost <= cost {
                        damping = (0.2 * damping).max(1e-12);
                        break (trial, trial_cost);
                    }
                }
                damping *= 5.0;
                // If no step is downhill any more the rest is rounding error.
                if damping > LARGEST_DAMPING {
                    return theta;
                }
            };
            let is_settled = cost - trial_cost < SETTLED;
            (theta, cost) = (trial, trial_cost);
            if is_settled {
                break;
            }
        }
        theta
    }

    /// Variances S of a wave in each band.
    fn model(&self, theta: &[f64]) -> Vec<f64> {
        let densities: Vec<f64> = theta.iter().map(|theta| theta.exp()).collect();
        let of_band = |band: usize| {
            // A ring contributes to no band beyond it.
            let seen = densities.iter().enumerate().skip(band);
            seen.map(|(ring, density)| self.shares[(band, ring)] * density).sum()
        };
        (0..theta.len()).map(of_band).collect()
    }

    /// Change of the exponent at every inner ring.
    fn bends<'a>(&'a self, theta: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        (2..theta.len()).map(|ring| {
            (theta[ring] - theta[ring - 1]) * self.closeness[ring - 1]
                - (theta[ring - 1] - theta[ring - 2]) * self.closeness[ring - 2]
        })
    }

    fn cost(&self, theta: &[f64]) -> f64 {
        let model = self.model(theta);
        let terms = self.independent.iter().zip(&self.line).zip(&model);
        let misfit: f64 = terms.map(|((n, line), s)| n * (s.ln() + line / s)).sum();
        let rough = |d: f64| 0.5 * FORGIVEN * FORGIVEN * (d / FORGIVEN).powi(2).ln_1p();
        misfit + SMOOTHNESS * self.bends(theta).map(rough).sum::<f64>()
    }

    /// Fisher's information with the penalty, and the gradient.
    fn scoring(&self, theta: &[f64]) -> (DMatrix<f64>, Vec<f64>) {
        let count = theta.len();
        let model = self.model(theta);
        let mut matrix = DMatrix::zeros(count, count);
        let mut gradient = vec![0.0; count];
        for (band, (variance, line)) in model.iter().zip(&self.line).enumerate() {
            let slope = |ring: usize| self.shares[(band, ring)] * theta[ring].exp() / variance;
            let slopes: Vec<f64> = (band..count).map(slope).collect();
            let n = self.independent[band];
            for (i, a) in (band..count).zip(&slopes) {
                gradient[i] += n * (1.0 - line / variance) * a;
                for (j, b) in (band..count).zip(&slopes) {
                    matrix[(i, j)] += n * a * b;
                }
            }
        }
        for (first, bend) in self.bends(theta).enumerate() {
            let weight = SMOOTHNESS / (1.0 + (bend / FORGIVEN).powi(2));
            let [left, right] = [self.closeness[first], self.closeness[first + 1]];
            let row = [left, -left - right, right];
            for (i, a) in (first..).zip(row) {
                gradient[i] += weight * bend * a;
                for (j, b) in (first..).zip(row) {
                    matrix[(i, j)] += weight * a * b;
                }
            }
        }
        (matrix, gradient)
    }
}

/// θ after a damped step; `None` if its matrix is not positive definite.
fn moved(theta: &[f64], matrix: &DMatrix<f64>, gradient: &[f64], damping: f64) -> Option<Vec<f64>> {
    let count = theta.len();
    let mut damped = matrix.clone();
    for k in 0..count {
        damped[(k, k)] += damping * (matrix[(k, k)] + 1e-12);
    }
    let right = DVector::from_iterator(count, gradient.iter().map(|slope| -slope));
    let step = Cholesky::new(damped)?.solve(&right);
    let largest = step.amax();
    let factor = if largest > LARGEST_CHANGE { LARGEST_CHANGE / largest } else { 1.0 };
    Some(theta.iter().zip(&step).map(|(theta, step)| theta + factor * step).collect())
}
