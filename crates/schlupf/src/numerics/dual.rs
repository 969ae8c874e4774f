//! Numbers that carry their derivatives: forward differentiation of formulas that are written once.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// What a formula is written for: plain numbers, or [`Dual`] ones. All parts are dimensionless, or
/// have the unit of what they stand for.
pub trait Number:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Mul<f64, Output = Self>
    + Neg<Output = Self>
{
    /// The number itself, without derivatives, in the unit of what it stands for or dimensionless.
    fn value(self) -> f64;

    /// A function of the number, from its value and its slope there.
    #[must_use]
    fn chain(self, value: f64, slope: f64) -> Self;

    /// √x, with a slope of zero at zero: a length whose parts vanish.
    #[must_use]
    fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    /// eˣ.
    #[must_use]
    fn exp(self) -> Self {
        let power = self.value().exp();
        self.chain(power, power)
    }

    /// arctan x.
    #[must_use]
    fn atan(self) -> Self {
        let x = self.value();
        self.chain(x.atan(), (1.0 + x * x).recip())
    }

    /// x to a power, for x > 0.
    #[must_use]
    fn powf(self, power: f64) -> Self {
        let x = self.value();
        let raised = x.powf(power);
        self.chain(raised, power * raised / x)
    }

    /// |x|; at zero with the slope of positive numbers.
    #[must_use]
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }

    /// √(x² + y²).
    #[must_use]
    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }
}

impl Number for f64 {
    fn value(self) -> f64 {
        self
    }

    fn chain(self, value: f64, _slope: f64) -> Self {
        value
    }
}

/// A number with its derivatives with respect to N variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number, in the unit of what it stands for, or dimensionless.
    pub value: f64,
    /// Its derivatives, in the unit of the number over those of the variables.
    pub slopes: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// Variables with these values (in their own units), each the one of its own place.
    pub fn variables(values: [f64; N]) -> [Self; N] {
        std::array::from_fn(|k| {
            let mut slopes = [0.0; N];
            slopes[k] = 1.0;
            Self { value: values[k], slopes }
        })
    }

    /// The number as a function of M others, from its derivatives with respect to its variables.
    #[inline]
    pub fn of<const M: usize>(&self, variables: &[Dual<M>; N]) -> Dual<M> {
        let mut slopes = [0.0; M];
        for (by, variable) in self.slopes.iter().zip(variables) {
            for (slope, part) in slopes.iter_mut().zip(&variable.slopes) {
                *slope += by * part;
            }
        }
        Dual { value: self.value, slopes }
    }

    /// Sums of the derivatives with weights.
    #[inline]
    fn weighted(self, other: Self, own: f64, others: f64) -> [f64; N] {
        std::array::from_fn(|k| own * self.slopes[k] + others * other.slopes[k])
    }
}

impl<const N: usize> Number for Dual<N> {
    fn value(self) -> f64 {
        self.value
    }

    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, slopes: self.slopes.map(|part| slope * part) }
    }
}

impl<const N: usize> From<f64> for Dual<N> {
    fn from(value: f64) -> Self {
        Self { value, slopes: [0.0; N] }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slopes: self.weighted(other, 1.0, 1.0) }
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slopes: self.weighted(other, 1.0, -1.0) }
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slopes: self.weighted(other, other.value, self.value),
        }
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let (value, part) = (self.value / other.value, other.value.recip());
        Self { value, slopes: self.weighted(other, part, -value * part) }
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        self.chain(factor * self.value, factor)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Dual, Number};

    /// Every operation in one formula, against central differences.
    #[test]
    fn derivatives_are_those_of_central_differences() {
        fn formula<T: Number>([x, y]: [T; 2]) -> T {
            let length = x.hypot(y) + (-x).exp() * y.atan() - (x * 2.0).sqrt() / y;
            length * y.powf(1.5) + (T::from(1.0) - y).abs()
        }
        let at = [0.7, 1.9];
        let found = formula(Dual::variables(at));
        assert_eq!(found.value, formula(at));
        for k in 0..2 {
            let [more, less] = [1e-6, -1e-6].map(|step| {
                let mut moved = at;
                moved[k] += step;
                formula(moved)
            });
            assert!((found.slopes[k] - (more - less) / 2e-6).abs() < 1e-8);
        }
    }
}
