//! Depth of wear across the profile.

use std::f64::consts::TAU;

use super::{Laws, RunPoint, State};

/// Depth of wear across the profile, on cells of equal width.
///
/// What a state wears off per distance, V, is distributed over the width of its patch by
/// w(y) = 3/(4b) (1 − ((y − y0)/b)²), the shape of the load of the strips of an ellipse of Hertz.
/// The circumference of the wheel spreads it, Δh = V w Δs/(2πR); the rail loses V w to each wheel
/// that passes. Volumes are conserved on any cells, because w is integrated over them.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Centres of the cells across the profile of the wheel, and across that of the rail, in m.
    pub y: Vec<f64>,
    /// Depth worn from the wheel over the run by Archard's law, in m.
    pub wheel_archard: Vec<f64>,
    /// Depth worn from the wheel over the run by energy, in m.
    pub wheel_energy: Vec<f64>,
    /// Depth worn from the rail by one passing wheel by Archard's law, mean over the run, in m.
    pub rail_archard: Vec<f64>,
    /// Depth worn from the rail by one passing wheel by energy, mean over the run, in m.
    pub rail_energy: Vec<f64>,
}

/// Cells across the narrowest patch, and most cells of a profile: positions within a metre to each
/// side and patches of 1 mm width need fewer.
const CELLS: f64 = 20.0;
const MOST: usize = 50_000;

impl Profile {
    /// Of states over a distance, in m.
    pub(super) fn of(states: &[State], points: &[RunPoint], laws: &Laws, distance: f64) -> Self {
        let places = |state: &State| [state.position_y, state.rail_position_y];
        let edges = states.iter().flat_map(|state| {
            places(state).map(|y| [y - state.semi_axis_y, y + state.semi_axis_y])
        });
        let (low, high) = edges.fold((f64::MAX, f64::MIN), |(low, high), [left, right]| {
            (low.min(left), high.max(right))
        });
        let widths = states.iter().map(|state| 2.0 * state.semi_axis_y);
        let narrowest = widths.fold(f64::MAX, f64::min);
        let count = ((high - low) / narrowest * CELLS).ceil().clamp(1.0, MOST as f64) as usize;
        let width = (high - low) / count as f64;
        // Of the wheel and of the rail, by both laws.
        let mut sums = [0; 2].map(|_| [0; 2].map(|_| vec![0.0; count]));
        for (state, point) in states.iter().zip(points) {
            let wear = [point.archard_wear, point.energy_wear / laws.densities[0]];
            for (sums, y) in sums.iter_mut().zip(places(state)) {
                let patch = [y, state.semi_axis_y];
                let first = ((y - patch[1] - low) / width).floor().max(0.0) as usize;
                let last = ((y + patch[1] - low) / width).ceil() as usize;
                for cell in first..last.min(count) {
                    let start = low + cell as f64 * width;
                    let part = within(patch, start + width) - within(patch, start);
                    for (sum, volume) in sums.iter_mut().zip(wear) {
                        sum[cell] += part / width * volume * state.distance;
                    }
                }
            }
        }
        let [wheel, rail] = sums;
        let times = |sums: &[f64], factor: f64| sums.iter().map(|sum| sum * factor).collect();
        let around = (TAU * laws.wheel_radius).recip();
        let denser = laws.densities[0] / laws.densities[1];
        Self {
            y: (0..count).map(|cell| low + (cell as f64 + 0.5) * width).collect(),
            wheel_archard: times(&wheel[0], around),
            wheel_energy: times(&wheel[1], around),
            rail_archard: times(&rail[0], distance.recip()),
            rail_energy: times(&rail[1], denser / distance),
        }
    }
}

/// Part of the wear of a patch (centre and half-width, in m) below a place y, in m: ∫ w dy.
fn within([center, half]: [f64; 2], y: f64) -> f64 {
    let u = ((y - center) / half).clamp(-1.0, 1.0);
    0.5 + 0.75 * u - 0.25 * u * u * u
}
