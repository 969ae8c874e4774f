//! Forces of the fast methods without fields on an ellipse of any shape.

use crate::Method;
use crate::elasticity::HalfSpace;
use crate::interface::Interface;
use crate::numerics::dual::{Dual, Number};
use crate::numerics::interpolation::Cubics;
use crate::problem::look_up_table::LookUpTable;
use crate::problem::{AreaReduction, FastMethod};
use crate::reporting::{Error, Warning};
use crate::solver::kalker_coefficients::interpolated_coefficients;
use crate::solver::reference::CreepCoefficients;
use crate::solver::simplified::{Ellipse, polach, shen_hedrick_elkins, warnings};

/// ξ, η, φ, the friction limit, a and b.
pub(super) const VARIABLES: usize = 6;

/// Logarithm of the largest axis ratio, either way, and steps up to it.
const LARGEST: f64 = 4.0;
const STEPS: usize = 64;

/// Step of the logarithm of the axis ratio over which the forces of a table change, dimensionless.
const SHAPE_STEP: f64 = 1e-2;

/// A method on ellipses of bodies.
#[derive(Debug, Clone)]
pub(super) struct AnyEllipse {
    method: FastMethod,
    /// C11, C22, C23, C33 over the logarithm of the axis ratio.
    coefficients: Cubics<4>,
    shear_modulus: f64,
    /// h/G of a layer, in m/Pa.
    layer_compliance: f64,
}

impl AnyEllipse {
    /// `None` for methods that compute fields.
    pub fn new(interface: &Interface, method: &Method) -> Option<Result<Self, Error>> {
        let Method::Fast(method) = method else { return None };
        let is_fast = matches!(
            method,
            FastMethod::KalkerLinear
                | FastMethod::ShenHedrickElkins
                | FastMethod::Polach(..)
                | FastMethod::Table(..)
        );
        is_fast.then(|| Self::of(interface, method.clone()))
    }

    fn of(interface: &Interface, method: FastMethod) -> Result<Self, Error> {
        let bodies = HalfSpace::new(&interface.wheel.material, &interface.rail.material)?;
        let at = |log: f64| -> Result<_, Error> {
            let found = interpolated_coefficients(log.exp(), bodies.poisson_ratio())?;
            let CreepCoefficients { c11, c22, c23, c33 } = found;
            Ok([c11, c22, c23, c33])
        };
        Ok(Self {
            method,
            coefficients: Cubics::new([-LARGEST, LARGEST], STEPS, at)?,
            shear_modulus: bodies.shear_modulus(),
            layer_compliance: interface.layer_compliance(),
        })
    }

    /// What the method neglects of an interface.
    pub fn warnings(&self, interface: &Interface) -> Vec<Warning> {
        warnings::of_interface(interface, &self.method)
    }

    /// Whether it has a moment.
    pub fn has_moment(&self) -> bool {
        !matches!(self.method, FastMethod::Polach(..))
    }

    fn ellipse<T: Number>(&self, [a, b]: [T; 2]) -> Ellipse<T> {
        let ratio = a / b;
        let of_bodies = self.coefficients.at(ratio.value().ln());
        let of_bodies = of_bodies.map(|[c, slope]| ratio.chain(c, slope / ratio.value()));
        Ellipse::with_layer(of_bodies, [a, b], (self.shear_modulus, self.layer_compliance))
    }

    /// Fx, Fy (in N) and Mz (in N m; zero where the method has none) under ξ, η, φ (in 1/m), with
    /// a friction limit (in N), on semi-axes a and b (in m).
    pub fn force(&self, variables: [f64; VARIABLES]) -> [Dual<VARIABLES>; 3] {
        if let FastMethod::Table(table) = &self.method {
            return self.tabulated(table, variables);
        }
        let [xi, eta, spin, limit, a, b] = Dual::variables(variables);
        let (ellipse, creepages) = (self.ellipse([a, b]), [xi, eta, spin]);
        match &self.method {
            FastMethod::ShenHedrickElkins => {
                shen_hedrick_elkins::saturated(&ellipse, creepages, limit)
            }
            FastMethod::Polach(AreaReduction { area_adhesion, area_slip }) => {
                let reduction = [*area_adhesion, *area_slip].map(Dual::from);
                let [x, y] = polach::limited(&ellipse, creepages, limit, reduction);
                [x, y, Dual::from(0.0)]
            }
            _ => ellipse.linear_force(creepages),
        }
    }

    /// On patches of one shape F = μN f(G ab ξ/(μN), …).
    fn tabulated(&self, table: &LookUpTable, variables: [f64; VARIABLES]) -> [Dual<VARIABLES>; 3] {
        let [xi, eta, spin, limit, a, b] = variables;
        let (unit, lever) = (self.shear_modulus * a * b / limit, (a * b).sqrt());
        let creepages = [unit * xi, unit * eta, unit * lever * spin];
        let of_shape = |stretching: f64| {
            let root = stretching.sqrt();
            let ellipse = self.ellipse([a * root, b / root]);
            let shape = table.at(a / b * stretching, Some(ellipse.coefficients));
            table.force_at(&shape, creepages)
        };
        let found = of_shape(1.0);
        let [less, more] = [-SHAPE_STEP, SHAPE_STEP].map(|step| of_shape(step.exp()).force);
        let arms = [1.0, 1.0, lever];
        let force: [f64; 3] = std::array::from_fn(|row| limit * arms[row] * found.force[row]);
        std::array::from_fn(|row| {
            let by = found.by_creepage[row];
            let [by_x, by_y, by_spin] =
                std::array::from_fn(|k| limit * unit * arms[row] * arms[k] * by[k]);
            let (along, turning) = (xi * by_x + eta * by_y, spin * by_spin);
            let arm = if row == 2 { force[row] } else { 0.0 };
            let by_limit = (force[row] - along - turning) / limit;
            let by_size = along + 1.5 * turning + 0.5 * arm;
            let by_shape = limit * arms[row] * (more[row] - less[row]) / (2.0 * SHAPE_STEP);
            let by_axes = [(by_size + by_shape) / a, (by_size - by_shape) / b];
            let slopes = [by_x, by_y, by_spin, by_limit, by_axes[0], by_axes[1]];
            Dual { value: force[row], slopes }
        })
    }
}
