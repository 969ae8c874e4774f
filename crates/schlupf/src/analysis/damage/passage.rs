//! Damage of one passage: a wheel that rolls steadily over a place of the rail.

use super::{Laws, ShakedownLimits, State};
use crate::normal::patch::Patch;
use crate::problem::{Method, Problem};
use crate::reporting::Error;
use crate::solution::{Fields, Solution, TGamma};

/// What one passage of a steady rolling contact does to rail and wheel: every place of the rail
/// that the wheel passes, and every place of the wheel in a revolution.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Passage {
    /// The wear number.
    pub t_gamma: TGamma,
    /// Damage by cracks, the reciprocal of the number of such passages until there is one;
    /// dimensionless, negative where wear prevails.
    pub crack_damage: f64,
    /// Surface-fatigue index, dimensionless: see [`SurfaceFatigue`](super::SurfaceFatigue).
    pub fatigue_index: f64,
    /// The point in the shakedown map.
    pub shakedown: ShakedownPoint,
    /// Wear in every cell; `None` if the method has no fields.
    pub wear: Option<PassageWear>,
    /// What melts; `None` if the method has no fields, or the problem no heat.
    pub melting: Option<Melting>,
}

/// A point in the shakedown map, with the limits of a line contact at the same traction.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ShakedownPoint {
    /// Traction coefficient |F|/N, dimensionless.
    pub traction_coefficient: f64,
    /// Largest pressure over the yield stress in shear p0/k, dimensionless.
    pub load_factor: f64,
    /// p0/k up to which a line contact stays elastic, dimensionless.
    pub elastic_limit: f64,
    /// p0/k up to which a line contact shakes down, dimensionless.
    pub shakedown_limit: f64,
    /// Poisson's ratio of the limits, the mean of both bodies, dimensionless.
    pub poisson_ratio: f64,
}

/// Wear of one passage.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PassageWear {
    /// Energy dissipated by friction per distance rolled, in N.
    pub energy_per_distance: f64,
    /// Volume that Archard's law wears from each body per distance rolled, in m².
    pub archard_volume: f64,
    /// Mass that the law of energy wears from each body per distance rolled, in kg/m.
    pub energy_mass: f64,
    /// Largest depth over the profile by Archard's law, in m.
    pub archard_depth: f64,
    /// Largest depth over the profile of the rail by energy, in m.
    pub energy_depth: f64,
    /// Rates in every cell.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub cells: WearCells,
    /// Depths across the profile.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub profile: PassageProfile,
}

/// Wear rates in the cells of the contact, in the order of its fields.
#[derive(Debug, Clone, PartialEq)]
pub struct WearCells {
    /// Centroid along rolling, in m.
    pub x: Vec<f64>,
    /// Centroid across rolling, in m.
    pub y: Vec<f64>,
    /// Mean pressure over the cell, in Pa.
    pub pressure: Vec<f64>,
    /// Slip speed, in m/s.
    pub slip_speed: Vec<f64>,
    /// Depth that Archard's law wears off per distance in the contact, dimensionless.
    pub archard: Vec<f64>,
    /// Mass that the law of energy wears off per area and distance in the contact, in kg/m³.
    pub energy: Vec<f64>,
}

/// Depths of wear across the profile, for the rows of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct PassageProfile {
    /// Middle of each row, in m.
    pub y: Vec<f64>,
    /// Depth by Archard's law, in m.
    pub archard: Vec<f64>,
    /// Depth that the law of energy wears off the wheel, in m.
    pub wheel_energy: Vec<f64>,
    /// Depth that the law of energy wears off the rail, in m.
    pub rail_energy: Vec<f64>,
}

/// Where friction heats a surface beyond its melting temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Melting {
    /// Largest temperature of the two surfaces, in degC.
    pub max_temperature: f64,
    /// Its place along rolling, in m.
    pub x: f64,
    /// Its place across rolling, in m.
    pub y: f64,
    /// Area of the wheel that is hotter than its melting temperature, in m².
    pub wheel_area: f64,
    /// The same of the rail, in m².
    pub rail_area: f64,
    /// The larger of both over the area of contact, dimensionless.
    pub share: f64,
}

/// The damage of a passage by a solution of a problem.
///
/// ```
/// use schlupf::analysis::damage::{Laws, of_passage};
/// use schlupf::{solver, Options, Problem, unwatched};
///
/// let problem = Problem::builder().creepage_x(0.002).build()?;
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let solution = solver::solve(&problem, &options, &unwatched)?;
/// let passage = of_passage(&problem, &solution, &Laws::default())?;
/// let wear = passage.wear.unwrap();
/// assert!(wear.archard_depth > 0.0 && wear.archard_depth < 1e-6);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Constants of a law that cannot be.
pub fn of_passage(problem: &Problem, solution: &Solution, laws: &Laws) -> Result<Passage, Error> {
    laws.check()?;
    let normal = &solution.normal;
    let [_, speed] = solution.kinematics.surface_speeds();
    let state = State {
        distance: 1.0,
        middle: 0.5,
        speed,
        position_y: 0.0,
        rail_position_y: 0.0,
        is_further_contact: false,
        load: normal.load,
        semi_axis_x: normal.semi_axis_x,
        semi_axis_y: normal.semi_axis_y,
        peak_pressure: normal.peak_pressure,
        contact_area: solution.area.contact,
        tangential_force: solution.force.tangential(),
        t_gamma: solution.t_gamma.without_spin,
        friction_power: solution.power.map_or(0.0, |power| power.friction),
        friction_coefficient: 1.0,
    };
    let [wheel, rail] =
        [&problem.interface.wheel, &problem.interface.rail].map(|body| body.material.poisson_ratio);
    let poisson_ratio = 0.5 * (wheel + rail);
    let limits = ShakedownLimits::of(solution.traction_coefficient, poisson_ratio);
    let has_fields = !solution.fields.is_empty();
    let pressure = has_fields.then(|| pressure(problem, solution)).transpose()?;
    let wear = pressure.map(|p| wear(&solution.fields, &p, (state.speed, laws)));
    let is_heated = has_fields && problem.interface.heat.model.is_some();
    Ok(Passage {
        t_gamma: solution.t_gamma,
        crack_damage: laws.cracks.of(state.t_gamma),
        fatigue_index: laws.fatigue.index(&state),
        shakedown: ShakedownPoint {
            traction_coefficient: solution.traction_coefficient,
            load_factor: normal.peak_pressure / laws.fatigue.shear_yield_stress,
            elastic_limit: limits.elastic,
            shakedown_limit: limits.shakedown,
            poisson_ratio,
        },
        wear,
        melting: is_heated.then(|| melting(problem, &solution.fields, laws)),
    })
}

/// The pressure of the normal contact in each cell, which is not always what bounds the traction
/// of a fast method.
fn pressure(problem: &Problem, solution: &Solution) -> Result<Vec<f64>, Error> {
    let fields = &solution.fields;
    if !matches!(solution.method, Method::Fast(_)) {
        return Ok(fields.pressure.clone());
    }
    let normal = problem.normal.normal_contact(Some(solution.normal.load))?;
    let mut whole = vec![0.0; fields.grid.len()];
    for cell in &Patch::new(&normal, fields.grid).cells {
        whole[cell.index] = cell.pressure;
    }
    Ok(fields.cell.iter().map(|[column, row]| whole[fields.grid.index(*column, *row)]).collect())
}

fn wear(fields: &Fields, pressure: &[f64], (speed, laws): (f64, &Laws)) -> PassageWear {
    let Laws { archard, energy, densities, .. } = laws;
    let slip = fields.slip_x.iter().zip(&fields.slip_y);
    let slip_speed: Vec<f64> = slip.map(|(x, y)| x.hypot(*y)).collect();
    // Cells at the edge are in contact in part, and wear there.
    let by_slip = |k: usize| {
        let covered = fields.covered[k];
        covered * archard.rate(slip_speed[k], pressure[k] / covered) / speed
    };
    let by_energy = |k: usize| {
        let covered = fields.covered[k];
        covered * energy.rate((fields.friction_power[k] / (speed * covered)).max(0.0))
    };
    let count = fields.len();
    let cells = WearCells {
        x: fields.x.clone(),
        y: fields.y.clone(),
        pressure: pressure.to_vec(),
        archard: (0..count).map(by_slip).collect(),
        energy: (0..count).map(by_energy).collect(),
        slip_speed,
    };
    let area = fields.grid.cell_area();
    let profile = profile(fields, &cells, *densities);
    let sum = |values: &[f64]| values.iter().sum::<f64>() * area;
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    PassageWear {
        energy_per_distance: sum(&fields.friction_power) / speed,
        archard_volume: sum(&cells.archard),
        energy_mass: sum(&cells.energy),
        archard_depth: largest(&profile.archard),
        energy_depth: largest(&profile.rail_energy),
        cells,
        profile,
    }
}

/// What the cells of every row wear off together.
fn profile(fields: &Fields, cells: &WearCells, densities: [f64; 2]) -> PassageProfile {
    let grid = &fields.grid;
    let rows = || fields.cell.iter().map(|[_, row]| *row);
    let first = rows().min().unwrap_or(0);
    let count = rows().max().map_or(0, |last| last + 1 - first);
    let along = |rates: &[f64]| {
        let mut depths = vec![0.0; count];
        for ([_, row], rate) in fields.cell.iter().zip(rates) {
            depths[row - first] += rate * grid.spacing_x;
        }
        depths
    };
    let mass = along(&cells.energy);
    let [wheel_energy, rail_energy] =
        densities.map(|density| mass.iter().map(|mass| mass / density).collect());
    PassageProfile {
        y: (0..count).map(|row| grid.y(first + row)).collect(),
        archard: along(&cells.archard),
        wheel_energy,
        rail_energy,
    }
}

fn melting(problem: &Problem, fields: &Fields, laws: &Laws) -> Melting {
    let rises = [&fields.temperature_rise_wheel, &fields.temperature_rise_rail];
    let bulk =
        [&problem.interface.wheel, &problem.interface.rail].map(|body| body.bulk_temperature);
    let temperature = |body: usize, k: usize| bulk[body] + rises[body][k];
    let mut melting = Melting {
        max_temperature: f64::NEG_INFINITY,
        x: 0.0,
        y: 0.0,
        wheel_area: 0.0,
        rail_area: 0.0,
        share: 0.0,
    };
    let area = fields.grid.cell_area();
    let mut all = 0.0;
    for k in 0..fields.len() {
        let covered = fields.covered[k] * area;
        all += covered;
        let [wheel, rail] = [temperature(0, k), temperature(1, k)];
        melting.wheel_area += if wheel > laws.melting_temperature { covered } else { 0.0 };
        melting.rail_area += if rail > laws.melting_temperature { covered } else { 0.0 };
        if wheel.max(rail) > melting.max_temperature {
            melting.max_temperature = wheel.max(rail);
            [melting.x, melting.y] = [fields.x[k], fields.y[k]];
        }
    }
    melting.share = melting.wheel_area.max(melting.rail_area) / all;
    melting
}
