//! Nodes in the shape of the patch and the direction of the creepages that are dense enough for
//! sliding without rolling.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::numerics::parallel;
use crate::problem::look_up_table::{LookUpTable, Shape, TableNodes};
use crate::reporting::Error;

use super::full_sliding::FullSliding;
use super::{MARGIN, NEARLY_INFINITE, TableOptions, distance, rest, shape};

/// Intervals are halved where the error in their middle is at least this part of the largest.
const PART: f64 = 0.5;

/// Rounds of halving: the function has kinks at the edge of the patch of vanishing width only.
const MOST_ROUNDS: usize = 20;

/// Axes of a/b, azimuth and inclination.
type Axes = [Vec<f64>; 3];

/// Nodes of a/b, azimuth and inclination, from those given, between which sliding without rolling
/// is right.
pub(super) fn first_nodes(
    options: &TableOptions,
    axis_ratios: Vec<f64>,
    [azimuths, inclinations]: [Vec<f64>; 2],
) -> Result<Axes, Error> {
    let sliding = Sliding { integral: FullSliding::new(), poisson_ratio: options.poisson_ratio };
    let mut axes = [axis_ratios, azimuths, inclinations];
    for _ in 0..MOST_ROUNDS {
        let table = sliding.table(&axes)?;
        let middles: [Vec<f64>; 3] = std::array::from_fn(|axis| middles(axis, &axes[axis]));
        let mut errors: [Vec<f64>; 3] = Default::default();
        for axis in 0..3 {
            errors[axis] = parallel::try_map(middles[axis].clone(), |middle| {
                let mut across = axes.clone();
                across[axis] = vec![middle];
                sliding.largest_error(&table, &across)
            })?;
        }
        let largest = errors.iter().flatten().fold(0.0_f64, |largest, error| largest.max(*error));
        let allowed = MARGIN * options.tolerance;
        if largest <= allowed {
            break;
        }
        for (axis, (middles, errors)) in axes.iter_mut().zip(middles.iter().zip(errors)) {
            let halved = middles.iter().zip(errors);
            let halved = halved.filter(|(_, error)| *error >= allowed.max(PART * largest));
            axis.extend(halved.map(|(middle, _)| middle));
            axis.sort_unstable_by(f64::total_cmp);
        }
    }
    Ok(axes)
}

/// Sliding without rolling in all directions.
struct Sliding {
    integral: FullSliding,
    poisson_ratio: f64,
}

impl Sliding {
    fn force(&self, ratio: f64, shape: &Shape, [azimuth, inclination]: [f64; 2]) -> [f64; 3] {
        self.integral.force(shape, ratio, shape.direction(inclination, azimuth))
    }

    /// A table that is the same at all saturations.
    fn table(&self, [axis_ratios, azimuths, inclinations]: &Axes) -> Result<LookUpTable, Error> {
        let saturations = vec![0.0, 0.25, 0.75, 1.0];
        let of_ratios = parallel::try_map(axis_ratios.clone(), |ratio| {
            let shape = shape(ratio, self.poisson_ratio)?;
            let mut values = Vec::new();
            for azimuth in azimuths {
                for inclination in inclinations {
                    let [x, y, moment] = self.force(ratio, &shape, [*azimuth, *inclination]);
                    // Zero by symmetry.
                    let force = match (*inclination == 0.0, *inclination == FRAC_PI_2) {
                        (true, _) => [x, 0.0, 0.0],
                        (_, true) => [0.0, y, moment],
                        _ => [x, y, moment],
                    };
                    let adhesion = shape.adhesion(shape.direction(*inclination, *azimuth));
                    values.extend([rest(force, adhesion, 1.0); 4]);
                }
            }
            Ok::<_, Error>((values, shape.coefficients))
        })?;
        let (values, creep_coefficients): (Vec<_>, Vec<_>) = of_ratios.into_iter().unzip();
        LookUpTable::new(TableNodes {
            poisson_ratio: self.poisson_ratio,
            axis_ratios: axis_ratios.clone(),
            azimuths: azimuths.clone(),
            inclinations: inclinations.clone(),
            saturations,
            values: values.concat(),
            creep_coefficients,
        })
    }

    /// The largest error of a table at all points of a grid; dimensionless.
    fn largest_error(&self, table: &LookUpTable, axes: &Axes) -> Result<f64, Error> {
        let mut largest = 0.0_f64;
        let [axis_ratios, azimuths, inclinations] = axes;
        for ratio in axis_ratios {
            let shape = shape(*ratio, self.poisson_ratio)?;
            for azimuth in azimuths {
                for inclination in inclinations {
                    let exact = self.force(*ratio, &shape, [*azimuth, *inclination]);
                    let direction = shape.direction(*inclination, *azimuth);
                    let creepages =
                        std::array::from_fn(|k| NEARLY_INFINITE * direction[k] / shape.scales[k]);
                    let found = table.normalised_force(*ratio, creepages).force;
                    largest = largest.max(distance(found, exact));
                }
            }
        }
        Ok(largest)
    }
}

/// The middles between neighbours: of a/b, azimuths (which repeat themselves), inclinations.
fn middles(axis: usize, nodes: &[f64]) -> Vec<f64> {
    let pairs = nodes.windows(2);
    match axis {
        0 => pairs.map(|pair| (f64::midpoint(pair[0].ln(), pair[1].ln())).exp()).collect(),
        1 => {
            let last = f64::midpoint(nodes[nodes.len() - 1], PI);
            pairs.map(|pair| f64::midpoint(pair[0], pair[1])).chain([last]).collect()
        }
        _ => pairs.map(|pair| f64::midpoint(pair[0], pair[1])).collect(),
    }
}
