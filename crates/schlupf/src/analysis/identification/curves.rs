//! The fitted model between the data, for plotting.

use crate::analysis::creep_curve::Abscissa;
use crate::bodies::Kinematics;
use crate::reporting::{Error, Watch};

use super::data::{Component, Condition, DataPoint};
use super::model::CreepForceModel;

/// Data over one creepage, and the model between them.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FittedCurves {
    /// The creepage that varies most, or the total creepage if ξ and η vary in a fixed direction.
    pub abscissa: Abscissa,
    /// Points that differ only in it, series by series.
    pub series: Vec<Series>,
}

impl FittedCurves {
    /// Position of a point on the abscissa: dimensionless, or in 1/m for spin.
    pub fn place(&self, point: &DataPoint) -> f64 {
        value(self.abscissa, &point.condition.kinematics)
    }
}

/// Points that differ only in one creepage, or in the total one.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Series {
    /// Their component.
    pub component: Component,
    /// Their condition, except for the varying creepage.
    pub condition: Condition,
    /// Indices of the data points.
    pub members: Vec<usize>,
    /// The model between them. Empty if there is only one point.
    pub curve: Vec<ModelPoint>,
}

/// A point of a fitted model.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ModelPoint {
    /// Its creepage, dimensionless, or in 1/m for spin.
    pub creepage: f64,
    /// Force divided by load, dimensionless; `None` if the model found none.
    pub force_ratio: Option<f64>,
}

/// Maximum number of conditions for which curves are computed: beyond it, presumably every point
/// has its own condition.
const MOST_CONDITIONS: usize = 12;

/// Returns the series of the data with curves of the model, at its present values, with so many
/// points each (none if zero) in addition to those of the data. With more than twelve conditions
/// there are no curves.
///
/// ```
/// use schlupf::analysis::identification::{Component, Condition, DataPoint, Parameter};
/// use schlupf::analysis::identification::{PolachModel, sample_curves};
/// use schlupf::interface::friction::{Constant, FrictionConstant};
/// use schlupf::bodies::Kinematics;
/// use schlupf::problem::AreaReduction;
/// use schlupf::{Problem, unwatched};
///
/// let problem = Problem::builder().friction(Constant::new(0.4)?).build()?;
/// let data = [0.001, 0.01].map(|creepage_x| {
///     let kinematics = Kinematics { creepage_x, ..problem.kinematics };
///     let condition = Condition { kinematics, load: None };
///     let component = Component::Longitudinal;
///     DataPoint { condition, component, force_ratio: 0.3, standard_deviation: None }
/// });
/// let unknown = [Parameter::Friction(FrictionConstant::ColdCoefficient)];
/// let mut model = PolachModel::new(&problem, AreaReduction::DRY, &unknown)?;
/// let curves = sample_curves(&mut model, &data, 11, &unwatched)?;
/// assert_eq!(curves.series.len(), 1);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Invalid conditions, and [`Error::Stopped`].
pub fn sample_curves(
    model: &mut dyn CreepForceModel,
    data: &[DataPoint],
    points: usize,
    watch: Watch,
) -> Result<FittedCurves, Error> {
    let abscissa = abscissa(data);
    let mut series = group(data, abscissa);
    if conditions(&series) > MOST_CONDITIONS || points == 0 {
        return Ok(FittedCurves { abscissa, series });
    }
    for one in &mut series {
        let values = || one.members.iter().map(|k| value(abscissa, &data[*k].condition.kinematics));
        let (low, high) = (
            values().fold(f64::INFINITY, f64::min).min(0.0),
            values().fold(f64::NEG_INFINITY, f64::max).max(0.0),
        );
        if one.members.len() < 2 || low >= high {
            continue;
        }
        let mut places: Vec<f64> = (0..points).map(|k| place(low, high, k, points)).collect();
        let apart = 1e-9 * (high - low);
        places.retain(|at| values().all(|value| (value - at).abs() > apart));
        places.extend(values());
        places.sort_unstable_by(f64::total_cmp);
        places.dedup();
        for at in places {
            let mut condition = one.condition;
            set(abscissa, &mut condition.kinematics, at);
            let force = model.force_ratio(&condition, watch)?;
            let force_ratio = force.map(|force| force.value[one.component.index()]);
            one.curve.push(ModelPoint { creepage: at, force_ratio });
        }
    }
    Ok(FittedCurves { abscissa, series })
}

/// Finer near zero, where creep curves have the largest curvature.
fn place(low: f64, high: f64, k: usize, points: usize) -> f64 {
    let root = |x: f64| x.signum() * x.abs().sqrt();
    let share = k as f64 / (points - 1).max(1) as f64;
    let rooted = root(low) + share * (root(high) - root(low));
    rooted * rooted.abs()
}

/// The creepage that varies most, or the total creepage if ξ and η vary in a fixed direction.
fn abscissa(data: &[DataPoint]) -> Abscissa {
    /// A typical √(ab), in m.
    const LEVER: f64 = 5e-3;
    let range = |abscissa: Abscissa| {
        let values = || data.iter().map(|point| value(abscissa, &point.condition.kinematics));
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let ranges = [
        (Abscissa::CreepageX, range(Abscissa::CreepageX)),
        (Abscissa::CreepageY, range(Abscissa::CreepageY)),
        (Abscissa::Spin, LEVER * range(Abscissa::Spin)),
    ];
    let larger = |one: (Abscissa, f64), next: (Abscissa, f64)| {
        if next.1 > one.1 { next } else { one }
    };
    let [x, y, _] = ranges.map(|(_, range)| range);
    match ranges.into_iter().fold((Abscissa::CreepageX, 0.0), larger).0 {
        Abscissa::Spin => Abscissa::Spin,
        single if x == 0.0 || y == 0.0 => single,
        single => direction(data).map_or(single, |direction| Abscissa::Total { direction }),
    }
}

/// Direction (in rad, from x towards y) of the largest total creepage, if all others have the same
/// or the opposite direction.
fn direction(data: &[DataPoint]) -> Option<f64> {
    /// Tolerance of the direction, in rad: creepages are written with few digits.
    const APART: f64 = 0.01;
    let creepages = || {
        let motions = data.iter().map(|point| &point.condition.kinematics);
        motions.map(|motion| [motion.creepage_x, motion.creepage_y])
    };
    let [x, y] = creepages().max_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])))?;
    let (sin, cos) = y.atan2(x).sin_cos();
    let is_along = |[x, y]: [f64; 2]| (y * cos - x * sin).abs() <= APART * x.hypot(y);
    creepages().all(is_along).then(|| y.atan2(x))
}

fn value(abscissa: Abscissa, kinematics: &Kinematics) -> f64 {
    match abscissa {
        Abscissa::CreepageX => kinematics.creepage_x,
        Abscissa::CreepageY => kinematics.creepage_y,
        Abscissa::Spin => kinematics.spin,
        Abscissa::Total { direction } => {
            kinematics.creepage_x * direction.cos() + kinematics.creepage_y * direction.sin()
        }
    }
}

fn set(abscissa: Abscissa, kinematics: &mut Kinematics, at: f64) {
    match abscissa {
        Abscissa::CreepageX => kinematics.creepage_x = at,
        Abscissa::CreepageY => kinematics.creepage_y = at,
        Abscissa::Spin => kinematics.spin = at,
        Abscissa::Total { direction } => {
            kinematics.creepage_x = at * direction.cos();
            kinematics.creepage_y = at * direction.sin();
        }
    }
}

/// Number of different conditions; both components may have the same.
fn conditions(series: &[Series]) -> usize {
    let is_first =
        |k: &usize| series[..*k].iter().all(|other| other.condition != series[*k].condition);
    (0..series.len()).filter(is_first).count()
}

fn group(data: &[DataPoint], abscissa: Abscissa) -> Vec<Series> {
    let mut series: Vec<Series> = Vec::new();
    for (k, point) in data.iter().enumerate() {
        let mut condition = point.condition;
        set(abscissa, &mut condition.kinematics, 0.0);
        let fits =
            |one: &&mut Series| one.condition == condition && one.component == point.component;
        match series.iter_mut().find(fits) {
            Some(one) => one.members.push(k),
            None => series.push(Series {
                component: point.component,
                condition,
                members: vec![k],
                curve: Vec::new(),
            }),
        }
    }
    series
}
