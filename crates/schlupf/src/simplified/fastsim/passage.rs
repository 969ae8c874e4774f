//! Slip and friction power along the path from one cell to the next.

use crate::kinematics::Kinematics;
use crate::patch::Travel;
use crate::row_motion::StripSlip;

use super::flexibility::Flexibility;

/// A path with its slip and friction power.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Passage {
    /// Length, in m.
    pub distance: f64,
    /// Slip velocity of the wheel over the rail, mean over the path, in m/s.
    pub slip: [f64; 2],
    /// Friction power per unit area, mean over the path, in W/m².
    pub power: f64,
}

impl Passage {
    /// A path with the tractions on the rail (in Pa) at both ends. If these differ by the increment
    /// of the traction in adhesion, nothing slips.
    pub fn new(
        flexibility: &Flexibility,
        motion: &Kinematics,
        path: (&Travel, &StripSlip),
        ends: [[f64; 2]; 2],
    ) -> Self {
        Approach::new(flexibility, motion, path).passage(ends)
    }

    /// The heat released, in W/m².
    pub fn heat(&self) -> f64 {
        self.power.max(0.0)
    }
}

/// What a path is, whatever the tractions at its ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Approach {
    /// Growth of the traction on the rail along it in adhesion, in Pa.
    pub stick_increment: [f64; 2],
    /// Ratio of the slip velocity to what is missing of that growth, in m/(s Pa).
    scale: f64,
    /// In m.
    distance: f64,
    /// k of modified FASTSIM, dimensionless.
    reduction: f64,
}

impl Approach {
    pub fn new(
        flexibility: &Flexibility,
        motion: &Kinematics,
        (way, row): (&Travel, &StripSlip),
    ) -> Self {
        let rate = motion.speed / way.distance;
        let stick_increment = flexibility.stick_increment(motion, (way, row));
        let scale = rate * flexibility.along(stick_increment, way.rigid_slip_in_row(motion, row));
        let reduction = flexibility.reduction;
        Self { stick_increment, scale, distance: way.distance, reduction }
    }

    /// With the tractions on the rail (in Pa) at both ends.
    #[inline]
    pub fn passage(&self, [from, to]: [[f64; 2]; 2]) -> Passage {
        let Self { stick_increment, scale, distance, .. } = *self;
        let slip = [0, 1].map(|c| scale * (stick_increment[c] - (to[c] - from[c])));
        let power = 0.5 * ((from[0] + to[0]) * slip[0] + (from[1] + to[1]) * slip[1]);
        Passage { distance, slip, power }
    }

    /// The slip speed that friction depends on, in m/s. Modified FASTSIM softens the springs on
    /// account of what is between the surfaces; only the springs of the bodies follow a bound that
    /// changes, so that a patch that slides does so at nearly the speed of the rigid slip.
    #[inline]
    pub fn slip_speed(&self, passage: &Passage, [from, to]: [[f64; 2]; 2]) -> f64 {
        let [x, y] = if self.reduction == 1.0 || passage.slip == [0.0; 2] {
            passage.slip
        } else {
            let grown = |c: usize| self.reduction * (to[c] - from[c]);
            [0, 1].map(|c| self.scale * (self.stick_increment[c] - grown(c)))
        };
        (x * x + y * y).sqrt()
    }
}
