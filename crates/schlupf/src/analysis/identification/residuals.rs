//! Differences between computed and measured forces, as residuals of a least-squares problem.

use nalgebra::DMatrix;

use crate::numerics::least_squares::Residuals;
use crate::reporting::{Error, Progress, Stage, Watch, within};

use super::data::{Condition, DataPoint};
use super::model::{CreepForceModel, ForceRatio};
use super::parameter::{Parameter, Scale};

/// A parameter and its scaling in the fit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coordinate {
    pub parameter: Parameter,
    pub scale: Scale,
    /// In the SI unit of the parameter, if that is not dimensionless.
    pub start: f64,
}

impl Coordinate {
    pub fn new(parameter: Parameter, start: f64) -> Self {
        Self { parameter, scale: parameter.scale(), start }
    }

    /// The value (in its SI unit, if it is not dimensionless) of a scaled coordinate.
    fn value(&self, moved: f64) -> f64 {
        let [low, high] = self.parameter.bounds();
        // Rounding error may exceed a bound.
        self.scale.value(moved, self.start).clamp(low, high)
    }

    /// Smallest and largest scaled coordinate, dimensionless.
    fn bounds(&self) -> [f64; 2] {
        self.parameter.bounds().map(|bound| self.scale.moved(bound, self.start))
    }
}

/// Residuals (computed minus measured, divided by the standard deviation if there is one) and their
/// derivatives with respect to the scaled coordinates.
pub(super) struct Weighted<'a> {
    pub model: &'a mut dyn CreepForceModel,
    data: &'a [DataPoint],
    pub coordinates: Vec<Coordinate>,
    /// The points in the order of solution.
    order: Vec<usize>,
    /// The last evaluation of the model.
    last: Option<Evaluation>,
    /// Why the last residuals could not be computed.
    pub failure: Option<Failure>,
    watch: Watch<'a>,
    solved: usize,
}

/// An evaluation of the model.
struct Evaluation {
    moved: Vec<f64>,
    residuals: Vec<f64>,
    jacobian: DMatrix<f64>,
}

/// Reason why there are no residuals.
#[derive(Debug, Clone)]
pub(super) enum Failure {
    /// The model does not allow these values or this condition.
    Refused(Error),
    /// The force was not found under this condition.
    NotFound(Condition),
}

impl<'a> Weighted<'a> {
    pub fn new(
        model: &'a mut dyn CreepForceModel,
        data: &'a [DataPoint],
        watch: Watch<'a>,
    ) -> Self {
        let pairs = model.parameters().iter().zip(model.start());
        let coordinates = pairs.map(|(parameter, start)| Coordinate::new(*parameter, start));
        let coordinates = coordinates.collect();
        Self {
            model,
            data,
            coordinates,
            order: order(data),
            last: None,
            failure: None,
            watch,
            solved: 0,
        }
    }

    /// Values (in SI units, or dimensionless) of scaled coordinates.
    pub fn values(&self, moved: &[f64]) -> Vec<f64> {
        let pairs = self.coordinates.iter().zip(moved);
        pairs.map(|(coordinate, moved)| coordinate.value(*moved)).collect()
    }

    fn evaluate(&mut self, moved: &[f64]) -> Result<Vec<f64>, Failure> {
        if let Some(last) = self.last.as_ref().filter(|last| last.moved == moved) {
            return Ok(last.residuals.clone());
        }
        let values = self.values(moved);
        self.model.set(&values).map_err(Failure::Refused)?;
        let mut residuals = vec![0.0; self.data.len()];
        let mut jacobian = DMatrix::zeros(self.data.len(), values.len());
        // Both components of one measurement have the same.
        let mut conditions: Vec<Condition> =
            self.order.iter().map(|row| self.data[*row].condition).collect();
        conditions.dedup();
        let mut forces = self.solve(&conditions)?.into_iter().zip(conditions);
        let mut last: Option<(ForceRatio, Condition)> = None;
        for &row in &self.order {
            let point = &self.data[row];
            if last.as_ref().is_none_or(|(_, condition)| *condition != point.condition) {
                last = forces.next();
            }
            let Some((force, _)) = &last else { break };
            let component = point.component.index();
            let weight = point.standard_deviation.map_or(1.0, f64::recip);
            residuals[row] = weight * (force.value[component] - point.force_ratio);
            for (column, by) in force.by_parameter.iter().enumerate() {
                let slope = self.coordinates[column].scale.slope(values[column]);
                jacobian[(row, column)] = weight * slope * by[component];
            }
        }
        let (moved, known) = (moved.to_vec(), residuals.clone());
        self.last = Some(Evaluation { moved, residuals: known, jacobian });
        self.failure = None;
        Ok(residuals)
    }

    fn solve(&mut self, conditions: &[Condition]) -> Result<Vec<ForceRatio>, Failure> {
        let watch = within(self.watch, Progress::count(Stage::Fit, self.solved));
        self.solved += conditions.len();
        let forces = self.model.force_ratios(conditions, &watch).map_err(Failure::Refused)?;
        let pairs = forces.into_iter().zip(conditions);
        pairs.map(|(force, condition)| force.ok_or(Failure::NotFound(*condition))).collect()
    }
}

impl Residuals for Weighted<'_> {
    fn residuals(&mut self, moved: &[f64]) -> Result<Option<Vec<f64>>, Error> {
        match self.evaluate(moved) {
            Ok(residuals) => Ok(Some(residuals)),
            Err(Failure::Refused(Error::Stopped {})) => Err(Error::Stopped {}),
            Err(failure) => {
                self.failure = Some(failure);
                Ok(None)
            }
        }
    }

    fn bounds(&self, parameter: usize) -> [f64; 2] {
        self.coordinates[parameter].bounds()
    }

    /// Computed together with the residuals.
    fn jacobian(
        &mut self,
        moved: &[f64],
        _residuals: &[f64],
    ) -> Result<Option<DMatrix<f64>>, Error> {
        let is_known = self.residuals(moved)?.is_some();
        Ok(self.last.as_ref().filter(|_| is_known).map(|last| last.jacobian.clone()))
    }
}

/// The points in an order in which each is close to the previous one: load by load, speed by speed,
/// from small to large creepages on either side of zero.
pub(super) fn order(data: &[DataPoint]) -> Vec<usize> {
    /// A length that converts spin into a creepage.
    const LEVER: f64 = 5e-3;
    let key = |point: &DataPoint| {
        let Condition { kinematics, load } = &point.condition;
        let parts = [kinematics.creepage_x, kinematics.creepage_y, LEVER * kinematics.spin];
        let size: f64 = parts.iter().map(|part| part.abs()).sum();
        let side = f64::from(parts.iter().sum::<f64>() < 0.0);
        let [x, y, z] = parts;
        [load.unwrap_or(0.0), kinematics.speed, side, size, x, y, z]
    };
    let mut order: Vec<usize> = (0..data.len()).collect();
    let compare = |one: &usize, other: &usize| {
        let pairs = key(&data[*one]).into_iter().zip(key(&data[*other]));
        pairs.map(|(a, b)| a.total_cmp(&b)).find(|o| o.is_ne()).unwrap_or(one.cmp(other))
    };
    order.sort_by(compare);
    order
}
