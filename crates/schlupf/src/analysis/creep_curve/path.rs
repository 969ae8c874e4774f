//! The path of a curve: through the space of creepages, or along a prescribed force.

use crate::bodies::Kinematics;
use crate::numerics::interpolation::mix;
use crate::numerics::root::bisection;
use crate::problem::{LongitudinalForce, PrescribedForces};
use crate::reporting::{CurveError, Error, Quantity, require_finite};

/// Longitudinal, lateral and spin creepage.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Creepages {
    /// Longitudinal creepage ξ, dimensionless.
    pub x: f64,
    /// Lateral creepage η, dimensionless.
    pub y: f64,
    /// Spin creepage φ, in 1/m.
    pub spin: f64,
}

impl Creepages {
    /// The creepages of a wheel.
    pub fn of(kinematics: &Kinematics) -> Self {
        Self { x: kinematics.creepage_x, y: kinematics.creepage_y, spin: kinematics.spin }
    }

    /// A motion with these creepages in place of its own.
    pub fn in_place_of(&self, motion: &Kinematics) -> Kinematics {
        Kinematics { creepage_x: self.x, creepage_y: self.y, spin: self.spin, ..*motion }
    }

    pub(super) fn components(&self) -> [f64; 3] {
        [self.x, self.y, self.spin]
    }
}

/// The creepage along a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Abscissa {
    /// The longitudinal creepage ξ.
    CreepageX,
    /// The lateral creepage η.
    CreepageY,
    /// The spin creepage φ.
    Spin,
    /// The total creepage ν in a fixed direction: ξ = ν cos θ, η = ν sin θ; dimensionless.
    Total {
        /// The direction θ, measured from x towards y, in rad.
        direction: f64,
    },
}

impl Abscissa {
    /// The corresponding quantity.
    pub fn quantity(self) -> Quantity {
        match self {
            Self::CreepageX => Quantity::CreepageX,
            Self::CreepageY => Quantity::CreepageY,
            Self::Spin => Quantity::Spin,
            Self::Total { .. } => Quantity::Creepage,
        }
    }
}

/// A force on the wheel that a curve prescribes in place of a creepage, which is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum VariedForce {
    /// The longitudinal force Fx, in N.
    X,
    /// The traction coefficient −Fx/N, dimensionless.
    OverLoad,
    /// The lateral force Fy, in N.
    Y,
    /// The moment Mz about the reference point, in N m.
    MomentZ,
}

impl VariedForce {
    /// The corresponding quantity.
    pub fn quantity(self) -> Quantity {
        match self {
            Self::X => Quantity::ForceX,
            Self::OverLoad => Quantity::ForceOverLoad,
            Self::Y => Quantity::ForceY,
            Self::MomentZ => Quantity::MomentZ,
        }
    }

    /// The creepage in the place of which it is.
    pub fn creepage(self) -> Quantity {
        match self {
            Self::X | Self::OverLoad => Quantity::CreepageX,
            Self::Y => Quantity::CreepageY,
            Self::MomentZ => Quantity::Spin,
        }
    }
}

/// A straight line in the space of creepages, with a direction; or a range of a prescribed force.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Path {
    start: Creepages,
    end: Creepages,
    abscissa: Varied,
    range: [f64; 2],
}

/// What varies.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(untagged))]
enum Varied {
    Creepage(Abscissa),
    Force(VariedForce),
}

impl Path {
    /// The line from `start` to `end`. Creepages that are equal in both stay constant; all others
    /// vary together, each linearly.
    ///
    /// The abscissa is the creepage that varies. If ξ and η vary in a fixed direction, it is the
    /// total creepage, positive towards the larger end; otherwise it is the first of ξ, η, φ that
    /// varies.
    pub fn new(start: Creepages, end: Creepages) -> Result<Self, Error> {
        for creepages in [&start, &end] {
            require_finite(Quantity::CreepageX, creepages.x)?;
            require_finite(Quantity::CreepageY, creepages.y)?;
            require_finite(Quantity::Spin, creepages.spin)?;
        }
        let (abscissa, component): (Abscissa, fn(&Creepages) -> f64) =
            if start.x != end.x && start.y != end.y && is_fixed_direction(&start, &end) {
                let larger = if start.x.hypot(start.y) > end.x.hypot(end.y) { start } else { end };
                let direction = larger.y.atan2(larger.x);
                let range = [start, end].map(|c| c.x * direction.cos() + c.y * direction.sin());
                let abscissa = Varied::Creepage(Abscissa::Total { direction });
                return Ok(Self { start, end, abscissa, range });
            } else if start.x != end.x {
                (Abscissa::CreepageX, |creepages| creepages.x)
            } else if start.y != end.y {
                (Abscissa::CreepageY, |creepages| creepages.y)
            } else if start.spin != end.spin {
                (Abscissa::Spin, |creepages| creepages.spin)
            } else {
                return Err(no_range(Quantity::Spin, end.spin));
            };
        let range = [component(&start), component(&end)];
        Ok(Self { start, end, abscissa: Varied::Creepage(abscissa), range })
    }

    /// A prescribed force over a range (in N or N m, dimensionless if it is over the load), with
    /// the creepages of the other directions; that of its own counts for nothing.
    ///
    /// # Errors
    /// Ends that are equal or not finite.
    pub fn over_force(
        force: VariedForce,
        range: [f64; 2],
        creepages: Creepages,
    ) -> Result<Self, Error> {
        let quantity = force.quantity();
        range.into_iter().try_for_each(|end| require_finite(quantity, end))?;
        if range[0] == range[1] {
            return Err(no_range(quantity, range[1]));
        }
        let mut given = creepages;
        match force {
            VariedForce::X | VariedForce::OverLoad => given.x = 0.0,
            VariedForce::Y => given.y = 0.0,
            VariedForce::MomentZ => given.spin = 0.0,
        }
        Ok(Self { start: given, end: given, abscissa: Varied::Force(force), range })
    }

    /// The total creepage (dimensionless) over a range in a fixed direction (in rad, from x towards
    /// y), with a spin creepage (in 1/m) that is constant or varies linearly.
    pub fn in_direction(range: [f64; 2], direction: f64, spin: [f64; 2]) -> Result<Self, Error> {
        require_finite(Quantity::Direction, direction)?;
        if range[0] == range[1] {
            return Err(no_range(Quantity::Creepage, range[1]));
        }
        let [start, end] = [0, 1].map(|end| {
            let [x, y] = components(range[end], direction);
            Creepages { x, y, spin: spin[end] }
        });
        Self::new(start, end).map(|path| Self {
            abscissa: Varied::Creepage(Abscissa::Total { direction }),
            range,
            ..path
        })
    }

    /// The quantity of the abscissa.
    pub fn quantity(&self) -> Quantity {
        match self.abscissa {
            Varied::Creepage(abscissa) => abscissa.quantity(),
            Varied::Force(force) => force.quantity(),
        }
    }

    /// The abscissa of the curve; `None` if that is a force.
    pub fn abscissa(&self) -> Option<Abscissa> {
        match self.abscissa {
            Varied::Creepage(abscissa) => Some(abscissa),
            Varied::Force(_) => None,
        }
    }

    /// The force that is the abscissa of the curve, if any.
    pub fn force(&self) -> Option<VariedForce> {
        match self.abscissa {
            Varied::Creepage(_) => None,
            Varied::Force(force) => Some(force),
        }
    }

    /// What is prescribed at an abscissa (in the unit of its quantity), where a problem prescribes
    /// its own.
    pub fn prescribed(&self, abscissa: f64, own: &PrescribedForces) -> PrescribedForces {
        let mut forces = *own;
        match self.force() {
            None => {}
            Some(VariedForce::X) => forces.x = Some(LongitudinalForce::Force(abscissa)),
            Some(VariedForce::OverLoad) => forces.x = Some(LongitudinalForce::OverLoad(abscissa)),
            Some(VariedForce::Y) => forces.y = Some(abscissa),
            Some(VariedForce::MomentZ) => forces.moment_z = Some(abscissa),
        }
        forces
    }

    /// Creepages at the start.
    pub fn start(&self) -> Creepages {
        self.start
    }

    /// Creepages at the end.
    pub fn end(&self) -> Creepages {
        self.end
    }

    /// The abscissa at the start and at the end; dimensionless, in 1/m for spin, in the unit of a
    /// force.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Creepages at an abscissa (dimensionless, in 1/m for spin, in the unit of a force), as far
    /// as they are given.
    pub fn at(&self, abscissa: f64) -> Creepages {
        let [from, to] = self.range;
        let share = (abscissa - from) / (to - from);
        let along = |start: f64, end: f64| {
            if start == end { start } else { mix([start, end], share) }
        };
        let mut creepages = Creepages {
            x: along(self.start.x, self.end.x),
            y: along(self.start.y, self.end.y),
            spin: along(self.start.spin, self.end.spin),
        };
        // Avoids the rounding error of `share`.
        match self.abscissa {
            Varied::Creepage(Abscissa::CreepageX) => creepages.x = abscissa,
            Varied::Creepage(Abscissa::CreepageY) => creepages.y = abscissa,
            Varied::Creepage(Abscissa::Spin) => creepages.spin = abscissa,
            Varied::Creepage(Abscissa::Total { direction }) => {
                [creepages.x, creepages.y] = components(abscissa, direction);
            }
            Varied::Force(_) => {}
        }
        creepages
    }

    /// Whether the path starts from, ends at or runs through the zero of all varied creepages. That
    /// of a force does not: which creepages cause none is not known.
    pub fn has_origin(&self) -> bool {
        if self.force().is_some() {
            return false;
        }
        let [from, to] = self.range;
        let contains_zero = from.min(to) <= 0.0 && from.max(to) >= 0.0;
        let [start, end] = [self.start, self.end].map(|creepages| creepages.components());
        let origin = self.at(0.0).components();
        contains_zero
            && (0..3).filter(|c| start[*c] != end[*c]).all(|c| {
                let largest = start[c].abs().max(end[c].abs());
                origin[c].abs() <= ROUNDING * largest
            })
    }

    /// The first abscissa (dimensionless, or in 1/m for spin), counted from the start, at which the
    /// wheel no longer rolls: it is locked, or η is ±1. `None` if it always rolls, or if a force
    /// varies. `motion` says to which speed creepages refer.
    pub fn locks_at(&self, motion: &Kinematics) -> Option<f64> {
        if self.force().is_some() {
            return None;
        }
        let motion = Kinematics { speed: 1.0, ..*motion };
        let rolls = |abscissa: f64| self.at(abscissa).in_place_of(&motion).check().is_ok();
        let [from, to] = self.range;
        if !rolls(from) {
            return Some(from);
        }
        // The creepages of a rolling wheel form a convex set: a wheel that rolls at both ends rolls
        // throughout.
        if rolls(to) {
            return None;
        }
        let [_, locked] = bisection([from, to], f64::MANTISSA_DIGITS, rolls);
        Some(locked)
    }
}

fn no_range(quantity: Quantity, value: f64) -> Error {
    CurveError::NoRange { quantity, value }.into()
}

/// Relative rounding error of computed creepages.
const ROUNDING: f64 = 1e-12;

/// ξ and η of a total creepage in a direction (in rad), without rounding error along the axes.
fn components(creepage: f64, direction: f64) -> [f64; 2] {
    let clean = |part: f64| if part.abs() < ROUNDING { 0.0 } else { creepage * part };
    [clean(direction.cos()), clean(direction.sin())]
}

fn is_fixed_direction(start: &Creepages, end: &Creepages) -> bool {
    let cross = start.x * end.y - start.y * end.x;
    cross.abs() <= ROUNDING * start.x.hypot(start.y) * end.x.hypot(end.y)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;

    fn creepages(x: f64, y: f64, spin: f64) -> Creepages {
        Creepages { x, y, spin }
    }

    fn path(start: [f64; 3], end: [f64; 3]) -> Path {
        let [start, end] = [start, end].map(|[x, y, spin]| creepages(x, y, spin));
        Path::new(start, end).unwrap()
    }

    #[test]
    fn the_abscissa_is_what_varies() {
        let abscissa = |start, end| path(start, end).abscissa().unwrap();
        assert_eq!(abscissa([0.0, 0.01, 0.0], [0.05, 0.01, 0.0]), Abscissa::CreepageX);
        assert_eq!(abscissa([0.01, 0.0, 0.0], [0.01, 0.05, 0.0]), Abscissa::CreepageY);
        assert_eq!(abscissa([0.0; 3], [0.0, 0.0, 2.0]), Abscissa::Spin);
        assert_eq!(abscissa([0.0; 3], [0.02, 0.0, 2.0]), Abscissa::CreepageX);
        assert_eq!(abscissa([0.01, 0.0, 0.0], [0.05, 0.02, 0.0]), Abscissa::CreepageX);
        let diagonal = path([0.0; 3], [0.03, 0.04, 0.0]);
        assert!(matches!(diagonal.abscissa(), Some(Abscissa::Total { .. })));
        assert_relative_eq!(diagonal.range()[1], 0.05, max_relative = 1e-14);
        let backwards = path([-0.03, -0.04, 0.0], [0.003, 0.004, 0.0]);
        assert_relative_eq!(backwards.range()[0], 0.05, max_relative = 1e-14);
        assert_relative_eq!(backwards.range()[1], -0.005, max_relative = 1e-14);
    }

    #[test]
    fn values_on_the_path_are_exact() {
        let path = path([0.0, 0.002, 0.0], [0.05, 0.002, 0.5]);
        for value in [0.0, 1e-4, 0.0123, 0.05] {
            let at = path.at(value);
            assert_eq!((at.x, at.y), (value, 0.002));
            assert_relative_eq!(at.spin, 10.0 * value, max_relative = 1e-14);
        }
        let lateral = Path::in_direction([-0.02, 0.05], FRAC_PI_2, [0.0; 2]).unwrap();
        assert_eq!(lateral.at(0.05), creepages(0.0, 0.05, 0.0));
        assert_eq!(lateral.range(), [-0.02, 0.05]);
        let driving = Path::in_direction([0.0, 0.05], PI, [0.3; 2]).unwrap();
        assert_eq!(driving.at(0.05), creepages(-0.05, 0.0, 0.3));
    }

    #[test]
    fn the_origin_is_where_all_that_varies_vanishes() {
        assert!(path([0.0, 0.002, 0.1], [0.05, 0.002, 0.1]).has_origin());
        assert!(path([-0.01, 0.0, -0.2], [0.03, 0.0, 0.6]).has_origin());
        assert!(!path([0.01, 0.0, 0.0], [0.03, 0.0, 0.0]).has_origin());
        assert!(!path([0.0, 0.0, 0.1], [0.03, 0.0, 0.6]).has_origin());
    }

    #[test]
    fn a_wheel_locks_where_its_circumference_stands_still() {
        let at = |start, end| path(start, end).locks_at(&Kinematics::free_rolling(1.0));
        assert_eq!(at([0.0; 3], [0.99, 0.0, 0.0]), None);
        assert_eq!(at([0.0; 3], [-5.0, 0.0, 0.0]), None);
        assert_relative_eq!(at([0.0; 3], [1.5, 0.0, 0.0]).unwrap(), 1.0, max_relative = 1e-12);
        assert_eq!(at([1.5, 0.0, 0.0], [0.0; 3]), Some(1.5));
        assert_relative_eq!(at([0.0; 3], [0.0, -2.0, 0.0]).unwrap(), -1.0, max_relative = 1e-12);
        let lateral = at([0.0, 0.6, 0.0], [1.0, 0.6, 0.0]).unwrap();
        assert_relative_eq!(lateral, 0.8, max_relative = 1e-12);
    }

    /// Its creepages are those of the case, and only its own force is prescribed.
    #[test]
    fn a_force_is_in_the_place_of_a_creepage() {
        let case = creepages(0.01, 0.002, 0.3);
        let own = PrescribedForces { moment_z: Some(5.0), ..PrescribedForces::default() };
        let path = Path::over_force(VariedForce::OverLoad, [-0.1, 0.3], case).unwrap();
        assert_eq!((path.abscissa(), path.at(0.2)), (None, Creepages { x: 0.0, ..case }));
        assert_eq!(path.quantity(), Quantity::ForceOverLoad);
        assert_eq!(
            (path.has_origin(), path.locks_at(&Kinematics::free_rolling(1.0))),
            (false, None)
        );
        let braking = Some(LongitudinalForce::OverLoad(0.2));
        assert_eq!(path.prescribed(0.2, &own), PrescribedForces { x: braking, ..own });
        for range in [[2.0, 2.0], [0.0, f64::INFINITY]] {
            assert!(Path::over_force(VariedForce::Y, range, case).is_err());
        }
    }

    #[test]
    fn a_point_is_no_path() {
        let message = Path::new(Creepages::default(), Creepages::default()).unwrap_err();
        assert!(message.to_string().contains("no other creepage varies"));
        let nowhere = Creepages { x: f64::NAN, ..Creepages::default() };
        assert!(Path::new(Creepages::default(), nowhere).is_err());
        assert!(Path::in_direction([0.1, 0.1], 0.3, [0.0; 2]).is_err());
        assert!(Path::in_direction([0.0, 0.1], f64::INFINITY, [0.0; 2]).is_err());
    }
}
