//! The patch of an element under any load.

use crate::numerics::dual::Number;
use crate::problem::Problem;
use crate::reporting::Error;
use crate::solver::simplified::EllipticContact;

use super::settings::Normal;

/// Patches of one shape, whose lengths grow with a power of the load.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patches {
    /// N (in N), a and b (in m) of one of them.
    load: f64,
    semi_axes: [f64; 2],
    /// Its approach in m, where the normal contact has one.
    approach: Option<f64>,
    exponent: f64,
}

/// One of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressed<T> {
    /// N, in N.
    pub load: T,
    /// In m.
    pub approach: T,
    /// a and b, in m.
    pub semi_axes: [T; 2],
}

/// Part of the load of the problem below which a patch grows no smaller, so that a wheel that
/// touches the rail has a time scale.
const SMALLEST_LOAD: f64 = 1e-3;

impl Patches {
    pub fn new(problem: &Problem, contact: &EllipticContact, by: Normal) -> Result<Self, Error> {
        let normal = contact.normal;
        let exponent = problem.normal.load_exponent().ok_or(Error::ShapeOfElement {})?;
        // N ∝ d^(3/2) is a ∝ N^(1/3).
        let has_approach = normal.approach.is_some() && (exponent - 1.0 / 3.0).abs() < 1e-12;
        let approach = normal.approach.filter(|_| has_approach);
        if by == Normal::Approach && approach.is_none() {
            return Err(Error::ApproachOfElement {});
        }
        Ok(Self { load: normal.load, semi_axes: normal.semi_axes(), approach, exponent })
    }

    /// Whether they have an approach.
    pub fn has_approach(&self) -> bool {
        self.approach.is_some()
    }

    /// Load (in N) or approach (in m) of the problem.
    pub fn start(&self, by: Normal) -> f64 {
        match by {
            Normal::Load => self.load,
            Normal::Approach => self.approach.unwrap_or(f64::NAN),
        }
    }

    /// The patch under a load (in N) or approach (in m): nothing under none.
    #[inline]
    pub fn pressed<T: Number>(&self, by: Normal, amount: T) -> Pressed<T> {
        let value = amount.value();
        if value <= 0.0 {
            let [load, approach, a, b] = [0.0; 4].map(T::from);
            return Pressed { load, approach, semi_axes: [a, b] };
        }
        let unit = self.approach.unwrap_or(f64::NAN);
        let (growth, power) = match by {
            Normal::Load => ((value / self.load).powf(self.exponent), self.exponent),
            Normal::Approach => ((value / unit).sqrt(), 0.5),
        };
        // What grows with some power of the lengths.
        let grown = |size: f64, powers: f64| amount.chain(size, powers * power * size / value);
        let (load, approach) = match by {
            Normal::Load => (amount, grown(growth * growth * unit, 2.0)),
            Normal::Approach => (grown(growth * growth * growth * self.load, 3.0), amount),
        };
        Pressed { load, approach, semi_axes: self.semi_axes.map(|axis| grown(growth * axis, 1.0)) }
    }

    /// The load (in N) of a load or an approach (in m); negative without contact.
    pub fn load<T: Number>(&self, by: Normal, amount: T) -> T {
        match by {
            Normal::Load => amount,
            Normal::Approach if amount.value() > 0.0 => self.pressed(by, amount).load,
            Normal::Approach => T::from(0.0),
        }
    }

    /// Load (in N), a and b (in m) of a patch that no load makes smaller than a thousandth of the
    /// problem's load does, and the part of the load up to that, at most 1.
    pub fn at_least<T: Number>(&self, load: T) -> (T, [T; 2], T) {
        let smallest = SMALLEST_LOAD * self.load;
        let part = step(load * smallest.recip());
        let root = (load * load + T::from(4.0 * smallest * smallest)).sqrt();
        let load = (load + root) * 0.5;
        let growth = (load * self.load.recip()).powf(self.exponent);
        (load, self.semi_axes.map(|axis| growth * axis), part)
    }
}

/// A smooth step from 0 below zero to 1 from one on.
pub(super) fn step<T: Number>(at: T) -> T {
    if at.value() <= 0.0 {
        return T::from(0.0);
    }
    if at.value() >= 1.0 {
        return T::from(1.0);
    }
    at * at * (T::from(3.0) - at * 2.0)
}
