//! The interface between the surfaces: contact law and friction.

pub mod heat;
mod contact_law;
pub mod friction;
pub mod roughness;
mod third_body;

pub use contact_law::{ContactLaw, Incremental, TotalDisplacement};
pub(crate) use third_body::Flow;
pub use third_body::{ShearedPoint, ThirdBodyLayer, YieldLimit};

use self::friction::constants::FrictionConstant;

/// A constant of the interface with respect to which forces can be differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InterfaceConstant {
    /// One of the friction law.
    Friction(FrictionConstant),
    /// k_c of the contact law, in 1/m.
    ContactStiffness,
    /// Shear modulus of the layer between the surfaces, in Pa.
    LayerShearModulus,
    /// Yield stress τ_c0 of that layer, in Pa.
    LayerYieldStress,
    /// Its hardening k_τ, in Pa/m.
    LayerHardening,
}
