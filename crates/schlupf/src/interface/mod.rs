//! What happens between the surfaces: contact law and friction.

pub mod contact_law;
pub mod friction;
pub mod roughness;
