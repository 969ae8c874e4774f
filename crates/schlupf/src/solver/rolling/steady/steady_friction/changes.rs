//! Changes of friction and of what bounds the traction, for tangents.

use crate::interface::YieldLimit;
use crate::solver::rolling::shared::passage;
use crate::solver::rolling::shared::passage::{pair, slip, speed_of};
use crate::solver::rolling::steady::lag::LagCause;
use crate::solver::rolling::steady::yielding::FlowCause;

use super::SteadyFriction;

/// Small changes in the cells on which friction depends.
#[derive(Clone, Copy)]
pub(in crate::solver::rolling::steady) struct Change<'a> {
    /// Of the traction, in Pa.
    pub traction: &'a [f64],
    /// Of A p along the passage of the cell, in m.
    pub passing: &'a [f64],
}

/// Small changes of the arguments of friction, cell by cell.
pub(in crate::solver::rolling::steady) struct FrictionCause {
    /// Of the rigid slip velocity, in m/s.
    pub slip: Vec<[f64; 2]>,
    /// Of the rise times effusivity, in W √s/m².
    pub scaled_rise: Vec<f64>,
    /// Of the coefficient of the law at the same slip and rise, dimensionless.
    pub law: Vec<f64>,
    /// Of the coefficient of the entering material, for the first cell of each strip;
    /// dimensionless.
    pub entry: Vec<f64>,
    /// Of the logarithm of all paths, dimensionless.
    pub path: f64,
    /// Of the limit of elasticity of the layer between the surfaces.
    pub limit: YieldLimit,
}

/// No change of that limit.
const UNCHANGED: YieldLimit = YieldLimit { stress: 0.0, hardening: 0.0 };

impl FrictionCause {
    /// No change in any of `cells` cells.
    pub fn nothing(cells: usize) -> Self {
        Self {
            slip: vec![[0.0; 2]; cells],
            scaled_rise: vec![0.0; cells],
            law: vec![0.0; cells],
            entry: vec![0.0; cells],
            path: 0.0,
            limit: UNCHANGED,
        }
    }
}

impl SteadyFriction {
    /// Change of the heat flux due to a change of the traction of a cell, in W/m².
    pub fn flux_change(&self, k: usize, traction: [f64; 2]) -> f64 {
        let power = passage::power(traction, self.slip[k]);
        if self.power[k] >= 0.0 { power * self.flux_over_power[k] } else { 0.0 }
    }

    /// Change of μ pₙ in a cell (in Pa) whose traction changes by `traction` and by `by_bound` per
    /// Pa of it, where `upstream` contains the changes of flux of the preceding cells; at constant
    /// slip.
    pub fn raised_bound(
        &self,
        k: usize,
        upstream: &[f64],
        traction: [f64; 2],
        by_bound: [f64; 2],
    ) -> f64 {
        if !self.heat.has_model() || self.yields(k) {
            return 0.0;
        }
        let own = self.heat.own_weight(k);
        let inherited = self.heat.weighted(k, &upstream[..k]);
        let by_rise = self.pressure[k] * self.lag.follows(k) * self.by_rise(k);
        let raised = by_rise * (inherited + own * self.flux_change(k, traction));
        raised / (1.0 - by_rise * own * self.flux_change(k, by_bound))
    }

    /// Change of μ pₙ in every cell (in Pa) due to another change, and to a cause. `flux` is a
    /// buffer for the changes of the heat flux.
    pub fn bound_changes(
        &mut self,
        Change { traction, passing }: Change,
        cause: Option<&FrictionCause>,
        flux: &mut [f64],
        bound: &mut [f64],
    ) {
        for (k, flux) in flux.iter_mut().enumerate() {
            let slid = self.slip_change(passing, cause, k);
            let input = passage::power(pair(&self.traction, k), slid);
            *flux = self.flux_change(k, pair(traction, k));
            if self.power[k] >= 0.0 {
                *flux += input * self.flux_over_power[k];
            }
        }
        let mut risen = std::mem::take(&mut self.risen);
        self.rise_changes(flux, &mut risen);
        let (mut carried, mut flowed) = (0.0, 0.0);
        for k in 0..self.heat.len() {
            let v = self.slip[k];
            let slid = self.slip_change(passing, cause, k);
            if k == self.heat.first(k) {
                carried = cause.map_or(0.0, |cause| cause.entry[k]);
                flowed = 0.0;
            }
            let speed = speed_of(v);
            let faster = if speed > 0.0 { (v[0] * slid[0] + v[1] * slid[1]) / speed } else { 0.0 };
            let scaled_rise = risen[k] + cause.map_or(0.0, |cause| cause.scaled_rise[k]);
            let law = self.by_rise(k) * scaled_rise
                + self.response[k].by_slip_speed * faster
                + cause.map_or(0.0, |cause| cause.law[k]);
            let path = cause.map_or(0.0, |cause| cause.path);
            let lagged = LagCause { law, slip_speed: faster, path };
            let mut change = self.lag.change(k, &lagged, &mut carried);
            if let Some(yielding) = &self.yielding {
                let slips = self.heat.durations(k).map(|time| (faster + speed * path) * time);
                let limit = cause.map_or(UNCHANGED, |cause| cause.limit);
                let cause = FlowCause { friction: change, slips, limit };
                change = yielding.change(k, &cause, &mut flowed);
            }
            bound[k] = self.pressure[k] * change;
        }
        self.risen = risen;
    }

    /// Changes of the rises times effusivity (in W √s/m²) due to those of the heat fluxes, in W/m².
    fn rise_changes(&mut self, flux: &[f64], risen: &mut [f64]) {
        let conduction = self.conduction_along.as_mut().filter(|_| self.conductors.is_some());
        let Some(conduction) = conduction else {
            for (k, risen) in risen.iter_mut().enumerate() {
                *risen = self.heat.weighted(k, &flux[..=k]);
            }
            return;
        };
        let heat = flux.iter().zip(&self.flux_over_power).map(|(flux, over)| flux / over);
        conduction.contact_rise(&heat.collect::<Vec<f64>>(), risen);
        let factor = self.conduction.contact_factor();
        for risen in risen {
            *risen /= factor;
        }
    }

    /// Change of the slip velocity (in m/s) due to that of A p along the passage of a cell (in m),
    /// and to a cause.
    fn slip_change(&self, change: &[f64], cause: Option<&FrictionCause>, k: usize) -> [f64; 2] {
        let per_length = self.kinematics.speed / self.spacing;
        let given = cause.map_or([0.0; 2], |cause| cause.slip[k]);
        slip(given, per_length, pair(change, k))
    }
}
