//! From the profiles of a wheel and a rail and the position of the wheelset to contacts: where they
//! are, their creepages, pressures and forces.
//!
//! The track frame has its origin between the rails in the plane of their tops: x along the track,
//! y to the left, z up. A wheel is a surface of revolution, a rail a prism or, on a test rig, a
//! roller; or either is a surface through sections. The steps, each in a file: the profiles as
//! smooth curves and in their places, with the deviations of the bodies; the vertical gap and its
//! regions of overlap under the wheel's exact locus of contact, or on a lattice; the planes of the
//! contacts; the undeformed distance above each; the normal contact
//! ([`crate::normal::rough_contact`]) in each, all of them sharing the vertical force; the
//! creepages from the rigid motion; the tangential problems.
//!
//! A right wheel is solved as the mirror image of a left one.
//!
//! Limits: unless it is asked for on the curved surface, the pressure of each contact is that in a
//! plane (a warning says how far a conformal one turns), while its rows slip as the surface; the
//! planes on a roller are parallel to x; the friction that helps to carry the wheel is that of
//! steady rolling.

mod side;
mod spline;
mod profile_curve;
mod sections;
mod surface;
mod seen;
mod pose;
mod deviation;
mod shapes;
mod rail_relief;
mod overlap;
mod pair;
mod relief;
mod gap;
mod contact_plane;
mod distance;
mod pressed;
mod opening;
mod virtual_penetration;
mod pressing;
mod creepage;
mod rows;
mod equilibrium;
mod patch;
mod holes;
mod drive;
mod time_step;
mod sliding;
mod contact_force;
mod turning;
mod coupled;
mod wheel;
mod settling;
mod resultant;
mod resting;
mod over_time;
mod conicity;
mod columns;
mod contact_table;

pub use conicity::{RestingWheelset, RigidContact, Roll, RollingRadiusDifference};
pub use contact_plane::Joining;
pub use contact_table::{
    ContactTable, ContactTableErrors, ContactTableNodes, ContactTableOptions, NodeAxis, Spread,
};
pub(crate) use contact_table::{OfPose, TabulatedContact};
pub use creepage::Motion;
pub use deviation::Deviation;
pub use drive::{Along, Drive};
pub use over_time::{WheelAt, WheelOverTime};
pub use pair::Pair;
pub use profile_curve::{CurvePoint, LEAST_SPACING, ProfileCurve};
pub use resting::resting_roll;
pub use rows::RowsMove;
pub use sections::{Interpolation, Section, Sections};
pub use shapes::{RailPlace, RailShape, Track, WheelShape};
pub use side::{Side, Sides};
pub use sliding::Tangential;
pub use surface::{Surface, Varying};
pub use time_step::Past;
pub use virtual_penetration::NormalMethod;
pub use wheel::{Contact, Position, Support, WheelOnRail, WheelSolution};
