//! Coefficient of friction.
//!
//! Temperature laws: [`TemperatureLinear`], Eq. (23), and [`TemperaturePiecewiseLinear`].
//! Slip-speed laws: [`Exponential`], [`Rational`] and [`Linear`], which share the parameters of
//! [`SlipTerms`], and [`Polach`]. One of each kind may be combined, [`Product`], and any law may
//! vary [`Across`] the patch. Any law may lag, [`FrictionMemory`].

mod constants;
mod variation;
mod across;
mod constant;
mod slip_terms;
mod exponential;
mod linear;
mod memory;
mod polach;
mod product;
mod rational;
mod temperature_linear;
mod temperature_piecewise_linear;

pub use across::Across;
pub use constant::Constant;
pub use constants::{AdjustableFriction, Changes, FrictionConstant};
pub use exponential::Exponential;
pub use linear::Linear;
pub use memory::{FrictionMemory, Kept};
pub use polach::Polach;
pub use product::Product;
pub use rational::Rational;
pub use slip_terms::{SecondTerm, SlipTerms};
pub use temperature_linear::TemperatureLinear;
pub use temperature_piecewise_linear::TemperaturePiecewiseLinear;
pub use variation::Variation;

use std::fmt::Debug;
use std::sync::Arc;

use crate::reporting::{Error, Quantity, Requirement, require, require_finite, require_positive};

/// Variables on which a coefficient of friction may depend.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionState {
    /// Contact temperature relative to the reference temperature, in K.
    pub temperature: f64,
    /// Slip speed, in m/s.
    pub slip_speed: f64,
    /// Position across rolling, in m.
    pub y: f64,
}

/// A coefficient of friction and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionResponse {
    /// Coefficient of friction μ ≥ 0, dimensionless.
    pub coefficient: f64,
    /// ∂μ/∂T, in 1/K.
    pub by_temperature: f64,
    /// Derivative with respect to the slip speed, in s/m.
    pub by_slip_speed: f64,
    /// ∂μ/∂y, in 1/m.
    pub by_y: f64,
    /// ∂μ/∂μ0 at constant values of the other constants of the law, dimensionless. A law without a
    /// μ0 is scaled as a whole: μ/μ0.
    pub by_cold_coefficient: f64,
}

/// A law for the coefficient of friction. Extension point.
///
/// ```
/// use schlupf::interface::friction::{FrictionLaw, FrictionResponse, FrictionState};
/// use schlupf::{Options, Problem, solver, unwatched};
///
/// /// μ = μ0/(1 + (s/s0)²), which falls with the slip speed s.
/// #[derive(Debug)]
/// struct Falling {
///     /// μ0, dimensionless.
///     coefficient: f64,
///     /// s0, in m/s.
///     half_speed: f64,
/// }
///
/// impl FrictionLaw for Falling {
///     fn respond(&self, state: &FrictionState) -> FrictionResponse {
///         let ratio = state.slip_speed / self.half_speed;
///         let part = 1.0 / (1.0 + ratio * ratio);
///         FrictionResponse {
///             coefficient: self.coefficient * part,
///             by_slip_speed: -2.0 * self.coefficient * part * part * ratio / self.half_speed,
///             by_cold_coefficient: part,
///             ..FrictionResponse::default()
///         }
///     }
/// }
///
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let coefficient = |creepage| {
///     let law = Falling { coefficient: 0.4, half_speed: 3.0 };
///     let problem = Problem::builder().creepage_x(creepage).friction(law).build()?;
///     Ok::<_, schlupf::Error>(solver::solve(&problem, &options, &unwatched)?.traction_coefficient)
/// };
/// assert!(coefficient(0.05)? < coefficient(0.005)?);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub trait FrictionLaw: Debug + Send + Sync {
    /// The coefficient of friction; at the default state (no slip, reference temperature, y = 0) it
    /// is μ0. At a kink of the law the derivatives are one-sided.
    fn respond(&self, state: &FrictionState) -> FrictionResponse;

    /// Whether the coefficient depends on neither temperature nor slip speed.
    fn is_constant(&self) -> bool {
        false
    }

    /// Whether the coefficient may depend on the slip speed.
    fn follows_slip_speed(&self) -> bool {
        !self.is_constant()
    }

    /// Temperature relative to the reference (in K) above which the law does not hold for entering
    /// material.
    fn temperature_limit(&self) -> f64 {
        f64::INFINITY
    }

    /// The law as one whose constants can be fitted to measurements, if possible.
    fn adjustable(&self) -> Option<&dyn AdjustableFriction> {
        None
    }
}

/// A friction law and its reference temperature.
#[derive(Debug, Clone)]
pub struct Friction {
    /// The law.
    pub law: Arc<dyn FrictionLaw>,
    /// Temperature from which the law's temperature is measured, in degC.
    pub reference_temperature: f64,
    /// How the coefficient lags behind the law; `None` means not at all.
    pub memory: Option<FrictionMemory>,
}

impl Friction {
    /// A law whose temperature is measured from `reference_temperature` (in degC), without memory.
    pub fn new(law: Arc<dyn FrictionLaw>, reference_temperature: f64) -> Self {
        Self { law, reference_temperature, memory: None }
    }

    /// Whether it is the same law with the same constants, known by its place in memory.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law)
            && self.reference_temperature == other.reference_temperature
            && self.memory == other.memory
    }

    /// Cold coefficient μ0, dimensionless.
    pub fn cold_coefficient(&self) -> f64 {
        self.law.respond(&FrictionState::default()).coefficient
    }

    /// Checks the law for material that enters at `entry_temperature`, in degC.
    pub fn check(&self, entry_temperature: f64) -> Result<(), Error> {
        require_finite(Quantity::ReferenceTemperature, self.reference_temperature)?;
        let limit = self.law.temperature_limit();
        if entry_temperature - self.reference_temperature < limit {
            return Ok(());
        }
        let reference = self.reference_temperature;
        Err(Error::FrictionVanishes { entry: entry_temperature, reference, limit })
    }
}

/// A cold coefficient of friction must be positive and finite.
fn require_coefficient(value: f64) -> Result<(), Error> {
    require_positive(Quantity::FrictionCoefficient, value)
}

/// A coefficient to which friction falls must be neither negative nor above μ0.
fn require_below(quantity: Quantity, value: f64, coefficient: f64) -> Result<(), Error> {
    let at_most = Requirement::UpTo(Quantity::FrictionCoefficient, coefficient);
    require(quantity, at_most, value)
}

#[cfg(test)]
mod tests {
    use super::across::Across;
    use super::constant::Constant;
    use super::constants::{Changes, FrictionConstant};
    use super::exponential::Exponential;
    use super::linear::Linear;
    use super::polach::Polach;
    use super::product::Product;
    use super::rational::Rational;
    use super::slip_terms::{SecondTerm, SlipTerms};
    use super::temperature_linear::TemperatureLinear;
    use super::temperature_piecewise_linear::TemperaturePiecewiseLinear;
    use super::variation::Variation;
    use super::*;

    type Law = Arc<dyn FrictionLaw>;

    /// One law of each kind, all with this μ0.
    fn laws(coefficient: f64) -> Vec<Law> {
        let second = Some(SecondTerm { coefficient: 0.05, half_speed: 0.4 });
        let terms = SlipTerms::new(coefficient, 0.1, 2.0, second).unwrap();
        let mut laws: Vec<Law> = vec![
            Arc::new(Constant::new(coefficient).unwrap()),
            Arc::new(TemperatureLinear::new(coefficient, 700.0, 0.1).unwrap()),
            Arc::new(TemperaturePiecewiseLinear::new(coefficient, 0.2, 500.0).unwrap()),
            Arc::new(Exponential(terms)),
            Arc::new(Rational(terms)),
            Arc::new(Linear(terms)),
            Arc::new(Polach::new(coefficient, 0.4, 0.6).unwrap()),
        ];
        for k in [1, 2] {
            let product = Product::new(Arc::clone(&laws[k]), Arc::clone(&laws[k + 2]));
            laws.push(Arc::new(product.unwrap()));
        }
        let table = || (vec![-4e-3, -1e-3, 3e-3], vec![0.5, 1.1, 0.7]);
        for k in 0..laws.len() {
            let (y, factor) = table();
            let variation = Variation::over_y(y, factor).unwrap();
            laws.push(Arc::new(Across::new(Arc::clone(&laws[k]), variation)));
        }
        laws
    }

    /// States away from the kinks of the laws: cold, warm, hot; nearly sticking, sliding; all over
    /// y.
    fn states() -> Vec<FrictionState> {
        let mut states = Vec::new();
        for temperature in [-30.0, 20.0, 300.0, 480.0, 650.0, 2000.0] {
            for slip_speed in [0.01, 0.3, 1.7, 3.0, 30.0] {
                for y in [-5e-3, -2e-3, 1e-3, 4e-3] {
                    states.push(FrictionState { temperature, slip_speed, y });
                }
            }
        }
        states
    }

    fn assert_close(exact: f64, difference: f64, law: &Law, state: &FrictionState) {
        let error = (exact - difference).abs();
        assert!(error <= 1e-6 * (1e-3 + exact.abs()), "{exact} {difference} {law:?} {state:?}");
    }

    #[test]
    fn derivatives_are_those_of_central_differences() {
        let mu0 = 0.4;
        let [more, less] = [1.0 + 1e-5, 1.0 - 1e-5].map(|part| laws(part * mu0));
        for (k, law) in laws(mu0).iter().enumerate() {
            for state in states() {
                let response = law.respond(&state);
                let difference = |step: f64, change: &dyn Fn(&mut FrictionState, f64)| {
                    let [plus, minus] = [step, -step].map(|step| {
                        let mut state = state;
                        change(&mut state, step);
                        law.respond(&state).coefficient
                    });
                    (plus - minus) / (2.0 * step)
                };
                let by_temperature = difference(1e-2, &|state, step| state.temperature += step);
                assert_close(response.by_temperature, by_temperature, law, &state);
                let by_slip_speed = difference(1e-5, &|state, step| state.slip_speed += step);
                assert_close(response.by_slip_speed, by_slip_speed, law, &state);
                let by_y = difference(1e-7, &|state, step| state.y += step);
                assert_close(response.by_y, by_y, law, &state);
                let [plus, minus] = [&more, &less].map(|laws| laws[k].respond(&state).coefficient);
                let by_cold = (plus - minus) / (2e-5 * mu0);
                assert_close(response.by_cold_coefficient, by_cold, law, &state);
            }
        }
    }

    #[test]
    fn derivatives_by_constants_are_those_of_central_differences() {
        const PART: f64 = 1e-5;
        for law in laws(0.4) {
            let adjustable = law.adjustable().unwrap();
            let constants = adjustable.constants();
            for constant in FrictionConstant::ALL {
                let own = constants.iter().find(|(own, _)| *own == constant);
                for state in states() {
                    let exact = adjustable.by_constant(constant, &state);
                    let Some((_, value)) = own else {
                        assert_eq!(exact, 0.0, "{constant:?} {law:?}");
                        continue;
                    };
                    let [plus, minus] = [1.0 + PART, 1.0 - PART].map(|part| {
                        let changes = [(constant, part * value)];
                        let changed = adjustable.with_constants(&Changes(&changes)).unwrap();
                        changed.respond(&state).coefficient
                    });
                    let difference = (plus - minus) / (2.0 * PART * value);
                    assert_close(exact * value, difference * value, &law, &state);
                }
            }
        }
    }

    #[test]
    fn friction_is_cold_at_the_default_state_and_never_negative() {
        for law in laws(0.4) {
            let cold = law.respond(&FrictionState::default()).coefficient;
            assert!((cold - 0.4).abs() < 1e-15, "{law:?}: {cold}");
            for state in states() {
                let coefficient = law.respond(&state).coefficient;
                assert!(coefficient > 0.0 && coefficient.is_finite(), "{law:?}: {coefficient}");
            }
        }
    }

    #[test]
    fn a_law_is_constant_if_it_depends_on_y_at_most() {
        let laws = laws(0.4);
        let is_constant: Vec<bool> = laws.iter().map(|law| law.is_constant()).collect();
        let expected: Vec<bool> = (0..laws.len()).map(|k| k % (laws.len() / 2) == 0).collect();
        assert_eq!(is_constant, expected);
    }

    /// A law that says it does not depend on the slip speed has no derivative by it anywhere.
    #[test]
    fn a_law_follows_the_slip_speed_if_its_derivative_says_so() {
        for law in laws(0.4) {
            let changes = |state: &FrictionState| law.respond(state).by_slip_speed != 0.0;
            let follows = states().iter().any(changes);
            assert_eq!(law.follows_slip_speed(), follows, "{law:?}");
        }
    }

    #[test]
    fn material_enters_colder_than_where_friction_vanishes() {
        let check = |floor, entry| {
            let law = Arc::new(TemperatureLinear::new(0.4, 700.0, floor).unwrap());
            Friction::new(law, 20.0).check(entry)
        };
        check(0.0, 719.0).unwrap();
        check(0.1, 800.0).unwrap();
        let message = check(0.0, 720.0).unwrap_err().to_string();
        assert!(message.contains("enters the contact at 720 degC"), "{message}");
        assert!(message.contains("reference temperature of 20 degC, at 720 degC"), "{message}");
    }
}
