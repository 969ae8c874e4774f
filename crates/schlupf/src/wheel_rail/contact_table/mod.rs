//! Contacts of a wheel on a rail at the speed of a simulation.
//!
//! Where the plane of a contact is follows from the overlap of the undeformed bodies
//! ([`super::contact_plane`]), so that it is computed, for every pose and with derivatives: as
//! integrals over few points of both profiles. The same integrals give the contact of Hertz with
//! the depth and the width of the overlap. What remains of the normal contact is a factor of its
//! force and of its semi-axes, and the centre of its pressure. These come from exact contacts and
//! are tabulated over the place on the wheel, roll, yaw and depth: they vary slowly and stay near
//! one.
//!
//! The semi-axes are those of the ellipse with the same second moments of the pressure, with its
//! centre in the centre of pressure.

mod outlines;
mod placement;
mod overlaps;
mod grid;
mod ellipse;
mod contacts;
mod checking;
mod building;
mod nodes;

pub use building::ContactTableOptions;
pub use checking::{ContactTableErrors, Spread};
pub use contacts::ContactTable;
pub(crate) use contacts::TabulatedContact;
pub use nodes::{ContactTableNodes, NodeAxis};
pub(crate) use placement::OfPose;
