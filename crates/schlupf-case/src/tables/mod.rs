//! Files that a case names: tables of pressure, of undeformed distance, of friction over y, of
//! wear, and of time; displacements to calibrate with, measured points of creep curves, and points
//! below the surface.

mod across;
pub(crate) mod axis;
pub(crate) mod columns;
mod creep_data;
mod displacements;
mod distance;
pub(crate) mod lattice;
pub(crate) mod layouts;
pub(crate) mod npy;
mod points;
mod pressure;
mod records;
mod time;
mod wear_map;

pub use across::from_csv as variation_from_csv;
pub use columns::Column as TableColumn;
pub use creep_data::{COLUMNS as CREEP_COLUMNS, from_csv as creep_data_from_csv};
pub use displacements::{
    COLUMNS as DISPLACEMENT_COLUMNS, Displacements, read as read_displacements,
};
pub use distance::{from_csv as distance_from_csv, from_npy as distance_from_npy};
pub use lattice::NpyFile;
pub use points::{COLUMNS as POINT_COLUMNS, read as read_points};
pub use pressure::{from_csv as pressure_from_csv, from_npy as pressure_from_npy};
pub use records::Records;
pub use time::{check as check_history, from_csv as history_from_csv};
pub use wear_map::from_csv as wear_map_from_csv;
