//! The columns of a passage, of a run and of their profiles.

use crate::reporting::{Column, Record, columns};

use super::{PassageProfile, Profile, RunPoint, WearCells};

/// Depth of wear across the profile.
impl Record for Profile {
    fn rows(&self) -> usize {
        self.y.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { Profile:
        Y => |profile, k| profile.y[k],
        WearDepth "wheel_archard" => |profile, k| profile.wheel_archard[k],
        WearDepth "wheel_energy" => |profile, k| profile.wheel_energy[k],
        WearDepth "rail_archard" => |profile, k| profile.rail_archard[k],
        WearDepth "rail_energy" => |profile, k| profile.rail_energy[k],
    };
}

/// Wear rates in the cells of the contact.
impl Record for WearCells {
    fn rows(&self) -> usize {
        self.x.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { WearCells:
        X => |cells, k| cells.x[k],
        Y => |cells, k| cells.y[k],
        Pressure => |cells, k| cells.pressure[k],
        LocalSlipSpeed "slip_speed" => |cells, k| cells.slip_speed[k],
        WearRateArchard "archard" => |cells, k| cells.archard[k],
        WearRateEnergy "energy" => |cells, k| cells.energy[k],
    };
}

/// Depth of wear of a passage across the profile.
impl Record for PassageProfile {
    fn rows(&self) -> usize {
        self.y.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { PassageProfile:
        Y => |profile, k| profile.y[k],
        WearDepth "archard" => |profile, k| profile.archard[k],
        WearDepth "wheel_energy" => |profile, k| profile.wheel_energy[k],
        WearDepth "rail_energy" => |profile, k| profile.rail_energy[k],
    };
}

/// States of a run with the damage that they do.
impl Record for [RunPoint] {
    fn rows(&self) -> usize {
        self.len()
    }

    const COLUMNS: &'static [Column<Self>] = columns! { [RunPoint]:
        Distance => |points, k| points[k].distance,
        Y "position_y" => |points, k| points[k].position_y,
        WearNumber => |points, k| points[k].t_gamma,
        FatigueIndex => |points, k| points[k].fatigue_index,
        CrackDamage => |points, k| points[k].crack_damage,
        DissipatedEnergy "energy" => |points, k| points[k].energy,
        WearVolume "archard_wear" => |points, k| points[k].archard_wear,
        WearMass "energy_wear" => |points, k| points[k].energy_wear,
    };
}
