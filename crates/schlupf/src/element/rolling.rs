//! Slip and rolling speed from the inputs, and creepages from both.

use crate::bodies::Kinematics;
use crate::interface::Interface;
use crate::interface::friction::FrictionState;
use crate::numerics::dual::Number;

use super::patch::step;
use super::settings::{Motion, Settings};

/// Part of v_s over which slip speeds are rounded, dimensionless.
const SLOW: f64 = 1e-2;

/// Creepage below which it says nothing of the rolling speed, dimensionless.
const SMALL_CREEPAGE: f64 = 1e-5;

/// How a wheel moves over the rail.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rolling<T> {
    /// Rigid slip along and across rolling (in m/s), and spin rate, in rad/s.
    pub slip: [T; 3],
    /// Rolling speed, in m/s; negative backwards.
    pub speed: T,
    /// Creepages in the direction of rolling forwards, without memory: dimensionless, and 1/m.
    pub creepages: [T; 3],
    /// To which they refer, in m/s, above zero.
    pub positive_speed: T,
    /// v_s, in m/s.
    standstill_speed: f64,
    /// Whether forces pass smoothly through standstill: creepages change their sign there.
    is_smooth: bool,
}

impl<T: Number> Rolling<T> {
    /// From the first four inputs.
    #[inline]
    pub fn new(settings: &Settings, [x, y, spin, last]: [T; 4]) -> Self {
        let standstill_speed = settings.standstill_speed;
        match settings.motion {
            Motion::Creepages => {
                let slip = [x, y, spin].map(|creepage| last * creepage);
                let sign = if last.value() < 0.0 { -1.0 } else { 1.0 };
                let creepages = [x, y, spin].map(|creepage| creepage * sign);
                let is_slow = last.value().abs() < standstill_speed;
                let positive_speed = if is_slow { T::from(standstill_speed) } else { last.abs() };
                let (speed, is_smooth) = (last, false);
                Self { slip, speed, creepages, positive_speed, standstill_speed, is_smooth }
            }
            Motion::Velocities => {
                let around = last * settings.rolling_radius;
                let (slip, speed) = ([x - around, y, spin], (x + around) * 0.5);
                let positive_speed = speed.hypot(T::from(standstill_speed));
                let creepages = slip.map(|slip| slip / positive_speed);
                let is_smooth = true;
                Self { slip, speed, creepages, positive_speed, standstill_speed, is_smooth }
            }
        }
    }

    /// V²/√(V² + v_s²), in m/s.
    pub fn passing_speed(&self) -> T {
        self.speed * self.speed / self.speed.hypot(T::from(self.standstill_speed))
    }

    /// Share of rolling forwards in the forces, dimensionless: by velocities with a slope that ends
    /// at ∓v_s.
    pub fn forwards(&self) -> T {
        if !self.is_smooth {
            return T::from(if self.speed.value() < 0.0 { 0.0 } else { 1.0 });
        }
        step((self.speed * self.standstill_speed.recip() + T::from(1.0)) * 0.5)
    }

    /// Fx, Fy (in N) and Mz (in N m) from those of rolling forwards: between forwards and backwards
    /// a part of each.
    pub fn through_standstill(&self, force: impl Fn([T; 3]) -> [T; 3]) -> [T; 3] {
        let share = self.forwards();
        let turned = |[x, y, about]: [T; 3]| [-x, -y, about];
        if share.value() >= 1.0 {
            return force(self.creepages);
        }
        let behind = turned(force(turned(self.creepages)));
        if share.value() <= 0.0 {
            return behind;
        }
        let ahead = force(self.creepages);
        [0, 1, 2].map(|k| behind[k] + share * (ahead[k] - behind[k]))
    }

    /// The speed (in m/s, above zero) with which creepages have the slip of the wheel.
    pub fn speed_of(&self, creepages: [T; 3]) -> T {
        let slip = self.slip[0].hypot(self.slip[1]);
        let least = T::from(SMALL_CREEPAGE);
        let total = creepages[0].hypot(creepages[1]);
        (slip + self.positive_speed * least) / (total + least)
    }

    /// Coefficient of friction at the slip speed and at the temperature of the entering material,
    /// for bulk temperatures of wheel and rail, in degC.
    pub fn friction(&self, interface: &Interface, bulk: [T; 2]) -> T {
        let law = &interface.friction.law;
        if law.is_constant() {
            return T::from(law.respond(&FrictionState::default()).coefficient);
        }
        let mut slip_speed = self.slip[0].hypot(self.slip[1]);
        if self.is_smooth {
            // Without the kink where the slip reverses.
            let rounding = T::from(SLOW * self.standstill_speed);
            slip_speed = slip_speed * slip_speed / slip_speed.hypot(rounding);
        }
        let weight = interface.conduction(&Kinematics::free_rolling(1.0)).wheel_weight();
        let [wheel, rail] = bulk;
        let entry = wheel * weight + rail * (1.0 - weight);
        let temperature = entry - T::from(interface.friction.reference_temperature);
        let state = FrictionState {
            temperature: temperature.value(),
            slip_speed: slip_speed.value(),
            y: 0.0,
        };
        let found = law.respond(&state);
        let by_slip = slip_speed.chain(0.0, found.by_slip_speed);
        temperature.chain(found.coefficient, found.by_temperature) + by_slip
    }
}
