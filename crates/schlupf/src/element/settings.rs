//! What an element takes, and how it behaves at standstill.

/// How the motion of an element is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// By creepages ξ, η, φ and the speed v, with the slip v (ξ, η, φ).
    Creepages,
    /// By the wheel's forward velocity v_x, its lateral velocity v_y at the contact, its angular
    /// velocity ω about the axle and its spin rate about the normal, with the slip (v_x − ωR, v_y,
    /// ω_z) and the rolling speed V = (v_x + ωR)/2.
    Velocities,
}

/// What presses the wheel of an element on the rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Normal {
    /// The load, in N.
    Load,
    /// The approach of the bodies, in m.
    Approach,
}

/// What an element takes, and how it behaves at standstill.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// How its motion is given.
    pub motion: Motion,
    /// What presses the wheel on the rail.
    pub normal: Normal,
    /// Whether the elastic shift is its state.
    pub has_memory: bool,
    /// v_s, in m/s.
    pub standstill_speed: f64,
    /// Rolling radius of the wheel, in m; only for motions by velocities.
    pub rolling_radius: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            motion: Motion::Velocities,
            normal: Normal::Load,
            has_memory: true,
            standstill_speed: 0.01,
            rolling_radius: 0.46,
        }
    }
}
