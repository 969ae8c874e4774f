//! The two bodies: their materials, and their rigid motion as seen from the contact.

mod material;
mod kinematics;
mod row_motion;

pub use kinematics::{Kinematics, ReferencePoint, ReferenceSpeed};
pub(crate) use material::shear_modulus_and_poisson_ratio;
pub use material::{Body, Material, contact_modulus};
pub use row_motion::{RowMotion, RowSlip, StripSlip};
