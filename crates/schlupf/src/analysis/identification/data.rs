//! Measured points of creep curves.

use crate::bodies::Kinematics;
use crate::reporting::{Error, FitError, Quantity, require_finite, require_positive};

/// The measured component of the force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Component {
    /// Along rolling.
    Longitudinal,
    /// Across rolling.
    Lateral,
}

impl Component {
    /// Index in (x, y).
    pub fn index(self) -> usize {
        match self {
            Self::Longitudinal => 0,
            Self::Lateral => 1,
        }
    }
}

/// The condition under which a force was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Condition {
    /// Speed and creepages.
    pub kinematics: Kinematics,
    /// Normal load (in N), if different from that of the problem.
    pub load: Option<f64>,
}

/// A measured point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct DataPoint {
    /// The condition.
    pub condition: Condition,
    /// The component of the force.
    pub component: Component,
    /// Force on the rail divided by the load, −Fx/N or −Fy/N, dimensionless: as in creep curves,
    /// with the sign of the creepage.
    pub force_ratio: f64,
    /// Standard deviation of the measurement, dimensionless, if known.
    pub standard_deviation: Option<f64>,
}

/// A measured point and the model's value there.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FittedPoint {
    /// The measurement.
    pub data: DataPoint,
    /// Computed force on the rail divided by the load, dimensionless.
    pub fitted: f64,
}

impl FittedPoint {
    /// Measured minus computed force, divided by the load, dimensionless.
    pub fn residual(&self) -> f64 {
        self.data.force_ratio - self.fitted
    }
}

/// Checks the points on their own, without the model.
pub(super) fn check(data: &[DataPoint]) -> Result<(), Error> {
    for point in data {
        point.condition.kinematics.check()?;
        require_finite(Quantity::ForceRatio, point.force_ratio)?;
        if let Some(load) = point.condition.load {
            require_positive(Quantity::Load, load)?;
        }
        if let Some(deviation) = point.standard_deviation {
            require_positive(Quantity::StandardDeviation, deviation)?;
        }
    }
    let known = data.iter().filter(|point| point.standard_deviation.is_some()).count();
    if known != 0 && known != data.len() {
        return Err(FitError::SomeDeviations { known, count: data.len() }.into());
    }
    Ok(())
}

/// Speeds and loads that differ by less than this relative difference belong to the same series,
/// dimensionless.
const SAME: f64 = 0.05;

/// Series: points of one component at one speed (in m/s) under one load (in N), up to the tolerance
/// above.
pub(super) fn series(data: &[DataPoint]) -> Vec<Vec<usize>> {
    let is_near = |one: f64, other: f64| (one - other).abs() <= SAME * one.abs().max(other.abs());
    let is_of = |one: &DataPoint, other: &DataPoint| {
        let (here, there) = (&one.condition, &other.condition);
        let loads = match (here.load, there.load) {
            (Some(one), Some(other)) => is_near(one, other),
            (None, None) => true,
            _ => false,
        };
        one.component == other.component
            && loads
            && is_near(here.kinematics.speed, there.kinematics.speed)
    };
    let mut series: Vec<Vec<usize>> = Vec::new();
    for (k, point) in data.iter().enumerate() {
        match series.iter_mut().find(|series| is_of(&data[series[0]], point)) {
            Some(series) => series.push(k),
            None => series.push(vec![k]),
        }
    }
    series
}

/// Checks that measured forces have the signs of the computed ones (forces divided by the load,
/// dimensionless), each component as a whole, and each series of it.
pub(super) fn check_signs(data: &[DataPoint], computed: &[f64]) -> Result<(), Error> {
    /// Number of points that make a series, and the cosine between measured and computed forces
    /// below which they are considered opposite.
    const ENOUGH: usize = 3;
    const AGAINST: f64 = -0.5;
    let runs_against = |points: &[usize]| {
        let sum = |of: &dyn Fn(usize) -> f64| points.iter().map(|k| of(*k)).sum::<f64>();
        let measured = sum(&|k| data[k].force_ratio.powi(2));
        let product = sum(&|k| data[k].force_ratio * computed[k]);
        product < AGAINST * (measured * sum(&|k| computed[k].powi(2))).sqrt()
    };
    let of_component = |component| {
        (0..data.len()).filter(|k| data[*k].component == component).collect::<Vec<usize>>()
    };
    let components = [Component::Longitudinal, Component::Lateral].map(of_component);
    let long = series(data).into_iter().filter(|series| series.len() >= ENOUGH);
    for points in components.into_iter().chain(long) {
        if runs_against(&points) {
            return Err(wrong_sign(data, &points));
        }
    }
    Ok(())
}

fn wrong_sign(data: &[DataPoint], points: &[usize]) -> Error {
    let first = &data[points[0]];
    let component = match first.component {
        Component::Longitudinal => Quantity::ForceX,
        Component::Lateral => Quantity::ForceY,
    };
    let of = data.iter().filter(|point| point.component == first.component).count();
    let is_part = of != points.len();
    let speed = is_part.then_some(first.condition.kinematics.speed);
    let load = first.condition.load.filter(|_| is_part);
    FitError::WrongSign { component, speed, load }.into()
}
