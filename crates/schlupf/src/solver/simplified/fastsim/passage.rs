//! Slip and friction power along the path from one cell to the next.

use crate::bodies::Kinematics;
use crate::numerics::lanes::{Lanes, choose, difference, dot, scaled, sum};

use super::flexibility::Flexibility;
use super::path::Path;

/// A path with its slip and friction power.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage<T> {
    /// Length, in m.
    pub distance: T,
    /// Slip velocity of the wheel over the rail, mean over the path, in m/s.
    pub slip: [T; 2],
    /// Friction power per unit area, mean over the path, in W/m².
    pub power: T,
}

impl<T: Lanes> Passage<T> {
    /// A path with the tractions on the rail (in Pa) at both ends. If these differ by the increment
    /// of the traction in adhesion, nothing slips.
    pub fn new(
        flexibility: &Flexibility,
        motion: &Kinematics,
        path: &Path<T>,
        ends: [[T; 2]; 2],
    ) -> Self {
        Approach::new(flexibility, motion, path).passage(ends)
    }

    /// The heat released, in W/m².
    #[inline]
    pub fn heat(&self) -> T {
        self.power.max(T::from(0.0))
    }
}

/// What a path is, whatever the tractions at its ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Approach<T> {
    /// Growth of the traction on the rail along it in adhesion, in Pa.
    pub stick_increment: [T; 2],
    /// Ratio of the slip velocity to what is missing of that growth, in m/(s Pa).
    scale: T,
    /// In m.
    distance: T,
    /// k of modified FASTSIM, dimensionless.
    reduction: f64,
}

impl<T: Lanes> Approach<T> {
    #[inline]
    pub fn new(flexibility: &Flexibility, motion: &Kinematics, path: &Path<T>) -> Self {
        let rate = T::from(motion.speed) * path.per_distance;
        let stick_increment = flexibility.stick_increment(motion, path);
        let scale = rate * flexibility.along(stick_increment, path.rigid_slip(motion));
        let reduction = flexibility.reduction;
        Self { stick_increment, scale, distance: path.distance, reduction }
    }

    /// With the tractions on the rail (in Pa) at both ends.
    #[inline]
    pub fn passage(&self, [from, to]: [[T; 2]; 2]) -> Passage<T> {
        let missing = difference(self.stick_increment, difference(to, from));
        let slip = scaled(self.scale, missing);
        let power = T::from(0.5) * dot(sum(from, to), slip);
        Passage { distance: self.distance, slip, power }
    }

    /// The slip velocity that friction depends on, in m/s. Modified FASTSIM softens the springs on
    /// account of what is between the surfaces; only the springs of the bodies follow a bound that
    /// changes, so that a patch that slides does so at nearly the speed of the rigid slip.
    #[inline]
    fn felt_slip(&self, passage: &Passage<T>, [from, to]: [[T; 2]; 2]) -> [T; 2] {
        if self.reduction == 1.0 {
            return passage.slip;
        }
        let grown = scaled(T::from(self.reduction), difference(to, from));
        let felt = scaled(self.scale, difference(self.stick_increment, grown));
        let sticks = dot(passage.slip, passage.slip).at_most(T::from(0.0));
        choose(sticks, passage.slip, felt)
    }

    /// The slip speed that friction depends on, in m/s.
    #[inline]
    pub fn slip_speed(&self, passage: &Passage<T>, ends: [[T; 2]; 2]) -> T {
        let slip = self.felt_slip(passage, ends);
        dot(slip, slip).sqrt()
    }

    /// Change of the heat released (in W/m²) when the tractions at the ends (in Pa) change, both
    /// per unit of something.
    #[inline]
    pub fn heat_change(&self, passage: &Passage<T>, ends: [[T; 2]; 2], by: [[T; 2]; 2]) -> T {
        let zero = T::from(0.0);
        let slipping = scaled(-self.scale, difference(by[1], by[0]));
        let power = T::from(0.5)
            * (dot(sum(by[0], by[1]), passage.slip) + dot(sum(ends[0], ends[1]), slipping));
        T::choose(passage.power.at_most(zero), zero, power)
    }

    /// The slip speed that friction depends on, and its change (in m/s both), likewise.
    #[inline]
    pub fn slip_speed_with_change(
        &self,
        passage: &Passage<T>,
        ends: [[T; 2]; 2],
        by: [[T; 2]; 2],
    ) -> [T; 2] {
        let zero = T::from(0.0);
        let slipping = scaled(-self.scale, difference(by[1], by[0]));
        let felt = self.felt_slip(passage, ends);
        let speed = dot(felt, felt).sqrt();
        let faster = T::from(self.reduction) * dot(felt, slipping) / speed;
        [speed, T::choose(speed.at_most(zero), zero, faster)]
    }
}
