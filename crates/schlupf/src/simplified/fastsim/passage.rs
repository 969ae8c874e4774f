//! Slip and friction power along the path from one cell to the next.

use crate::kinematics::Kinematics;
use crate::patch::Travel;

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
        way: &Travel,
        [from, to]: [[f64; 2]; 2],
    ) -> Self {
        let rate = motion.speed / way.distance;
        let stick_increment = flexibility.stick_increment(motion, way);
        let scale = rate * flexibility.along(stick_increment, way.rigid_slip(motion));
        let slip = [0, 1].map(|c| scale * (stick_increment[c] - (to[c] - from[c])));
        let power = 0.5 * ((from[0] + to[0]) * slip[0] + (from[1] + to[1]) * slip[1]);
        Self { distance: way.distance, slip, power }
    }

    /// The heat released, in W/m².
    pub fn heat(&self) -> f64 {
        self.power.max(0.0)
    }
}
