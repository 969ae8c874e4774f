//! FASTSIM: Kalker's simplified theory, a brush of uncoupled bristles.
//!
//! The displacement of a point is proportional to its traction, u = L t, so a strip needs only one
//! pass from its leading to its trailing edge: over a path dx in adhesion the traction on the rail
//! grows by (ξ/L1 − φ y/L3, η/L2 + φ x/L3) dx, and it is limited to μ pₙ where it slides. Friction
//! may depend on slip speed and temperature, which come from the same pass: each cell finds the
//! coefficient that is consistent with the slip and the heat it causes.
//!
//! Sources: Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System
//! Dynamics 11 (1982) 1–13; there, L1, L2, L3 follow from equal forces in full adhesion. The cells
//! are those of the full solver, with exact path lengths and mean pressures where they are cut by
//! the edge of the patch, so the forces of full adhesion and of full sliding are exact on any grid.
//! Limits: with three flexibilities the sliding direction at large creepage is that of (ξ/L1,
//! η/L2), and the friction power differs from the creep power if there is spin; one flexibility
//! avoids both, but its forces with spin are less accurate.

mod cell;
mod flexibility;
mod passage;

use std::f64::consts::FRAC_2_PI;
use std::sync::Arc;

use crate::error::Error;
use crate::grid::Grid;
use crate::heat::strip_heat::StripHeat;
use crate::heat::{HeatModel, HeatStep};
use crate::interface::third_body::Flow;
use crate::kinematics::Kinematics;
use crate::method::{Brush, SlopeReduction, TractionBound};
use crate::normal::{NormalContact, NormalSummary, Pressure};
use crate::numerics::root::fixed_point_near;
use crate::patch::Patch;
use crate::problem::{Options, Problem};
use crate::solution::Resultant;
use crate::summary::snapshot::Snapshot;

use super::elliptic_contact::{EllipticContact, friction_limit};
use cell::{Carried, cut};
use flexibility::{Flexibility, slope_reduction};
use passage::{Approach, Passage};

/// Bristles, and their softening in modified FASTSIM.
type Kind = (Brush, Option<SlopeReduction>);

/// A patch of bristles.
#[derive(Debug)]
pub(super) struct Fastsim {
    brush: Brush,
    reduction: Option<SlopeReduction>,
    /// The cells, with the pressure that bounds the traction.
    pub patch: Patch,
    /// Traction on the rail, mean over the covered part of each cell, in Pa.
    traction: Vec<[f64; 2]>,
    /// Coefficient of friction, dimensionless.
    friction: Vec<f64>,
    flexibility: Flexibility,
    heat: StripHeat,
    /// Heat model and speed (in m/s) for which the heat was set up.
    heated: (Option<Arc<dyn HeatModel>>, f64),
}

impl Fastsim {
    /// The patch of a normal contact of a problem; `reduction` selects modified FASTSIM.
    pub fn new(
        problem: &Problem,
        options: &Options,
        (brush, reduction): Kind,
        normal: &NormalContact,
    ) -> Result<Self, Error> {
        let grid = Grid::across(&normal.extent(), options.cells_x, options.cells_y);
        let mut patch = Patch::new(normal, grid);
        if brush.bound == TractionBound::Parabolic {
            let flows = problem.layer.is_some_and(|layer| layer.yield_limit().is_some());
            if flows || matches!(normal.pressure, Pressure::Tabulated(..)) {
                return Err(Error::NoParaboloid {});
            }
            make_parabolic(&mut patch, &normal.summary);
        }
        let mut fastsim = Self {
            brush,
            reduction,
            traction: vec![[0.0; 2]; patch.len()],
            friction: vec![0.0; patch.len()],
            flexibility: Flexibility::RIGID,
            heat: StripHeat::new(&patch),
            heated: (None, 0.0),
            patch,
        };
        fastsim.set_friction(problem);
        Ok(fastsim)
    }

    /// Switches to another friction law.
    pub fn set_friction(&mut self, problem: &Problem) {
        let conduction = problem.conduction(&problem.kinematics);
        for (friction, cell) in self.friction.iter_mut().zip(&self.patch.cells) {
            let by_law = problem.friction_response(&conduction, 0.0, 0.0, cell.y).coefficient;
            *friction = problem.at_entry(by_law, cell);
        }
    }

    /// Switches to another load, which changes all lengths and all pressures by a factor.
    pub fn rescale(&mut self, length: f64, pressure: f64) {
        self.patch.rescale(length, pressure);
        // The paths have changed.
        self.heated.1 = 0.0;
    }

    /// Forces and moment on the wheel.
    pub fn force(&mut self, problem: &Problem, contact: &EllipticContact) -> Resultant {
        let motion = &problem.kinematics;
        self.flexibility = Flexibility::new(self.brush, contact, motion);
        if let Some(reduction) = self.reduction {
            let limit = friction_limit(problem, contact.normal.load);
            let factor = slope_reduction(reduction, contact.stress_gradient(motion, limit));
            self.flexibility = self.flexibility.softened(factor);
        }
        if problem.has_constant_bound() {
            self.pass(motion);
        } else {
            self.pass_with_friction(problem);
        }
        self.resultant()
    }

    /// Sets the heat model and the speed, if they have changed.
    fn prepare_heat(&mut self, problem: &Problem) {
        let (model, speed) = (problem.heat.model.as_ref(), problem.kinematics.speed);
        let is_same_model = match (&self.heated.0, model) {
            (None, None) => true,
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            _ => false,
        };
        if is_same_model && self.heated.1 == speed {
            return;
        }
        self.heated = (model.map(Arc::clone), speed);
        let ways = self.patch.cells.iter().map(|cell| cell.path_in.distance);
        self.heat.set(model, ways.map(|way| [way / speed; 2]));
    }

    /// Passes from the leading to the trailing edges with the present friction.
    fn pass(&mut self, motion: &Kinematics) {
        for strip in &self.patch.strips {
            let mut carried = Carried::default();
            for k in strip.cells.clone() {
                let cell = &self.patch.cells[k];
                let rigid = self.flexibility.stick_increment(motion, (&cell.path_in, &cell.row));
                carried = carried.next(rigid, self.friction[k] * cell.pressure_where_covered());
                self.traction[k] = carried.traction;
            }
        }
    }

    /// The same for friction that depends on slip and heat.
    ///
    /// A point that arrives with more traction than its coefficient here would have allowed there
    /// loses the excess without slip and heat: see [`Self::path_in`].
    fn pass_with_friction(&mut self, problem: &Problem) {
        self.prepare_heat(problem);
        let Self { patch, traction, friction, flexibility, heat, .. } = self;
        let motion = &problem.kinematics;
        let conduction = problem.conduction(motion);
        let mut last = [problem.friction.cold_coefficient(); 2];
        let mut slope = 0.0;
        for strip in &patch.strips {
            let mut carried = Carried::default();
            let mut pressure_before = 0.0;
            let mut flowed = 0.0;
            for k in strip.cells.clone() {
                let cell = &patch.cells[k];
                let inherited = heat.inherited(k);
                let approach = Approach::new(flexibility, motion, (&cell.path_in, &cell.row));
                let pressure_here = cell.pressure_where_covered();
                let arrive = |mu: f64| {
                    let next = carried.next(approach.stick_increment, mu * pressure_here);
                    let ends = [cut(carried.traction, mu * pressure_before), next.traction];
                    let passage = approach.passage(ends);
                    (next, passage, approach.slip_speed(&passage, ends))
                };
                let start = (2.0 * last[0] - last[1]).max(0.0);
                let mut flow = Flow::default();
                let mu = fixed_point_near(start, &mut slope, |mu| {
                    let (_, passage, slip_speed) = arrive(mu);
                    let scaled_rise = heat.scaled_rise(k, inherited, passage.heat());
                    let friction = problem
                        .friction_response(&conduction, scaled_rise, slip_speed, cell.y)
                        .coefficient;
                    let Some(layer) = &problem.layer else { return friction };
                    let slip = slip_speed * passage.distance / motion.speed;
                    flow = layer.pass(friction * pressure_here, flowed, [slip; 2]);
                    flow.bound / pressure_here
                });
                flowed = flow.left;
                let (next, passage, _) = arrive(mu);
                heat.flux[k] = passage.heat();
                (friction[k], traction[k]) = (mu, next.traction);
                last = [mu, last[0]];
                carried = next;
                pressure_before = pressure_here;
            }
        }
    }

    fn resultant(&self) -> Resultant {
        let [mut x, mut y, mut moment_z] = [0.0; 3];
        for (cell, [px, py]) in self.patch.cells.iter().zip(&self.traction) {
            x -= cell.covered * px;
            y -= cell.covered * py;
            moment_z -= cell.covered * (cell.x * py - cell.y * px);
        }
        let area = self.patch.grid.cell_area();
        Resultant::new(area * x, area * y, area * moment_z)
    }

    /// All quantities in the cells after the last pass.
    pub fn snapshot(&mut self, problem: &Problem) -> Snapshot {
        let motion = &problem.kinematics;
        let conduction = problem.conduction(motion);
        let mut now = Snapshot::blank(*motion, conduction, self.patch.len());
        now.friction.copy_from_slice(&self.friction);
        let compliance = [self.flexibility.longitudinal, self.flexibility.lateral];
        for (k, cell) in self.patch.cells.iter().enumerate() {
            for (c, flexibility) in compliance.iter().enumerate() {
                now.traction[2 * k + c] = cell.covered * self.traction[k][c];
                now.displacement[2 * k + c] = flexibility * self.traction[k][c];
            }
        }
        self.prepare_heat(problem);
        for strip in 0..self.patch.strips.len() {
            self.warm(&mut now, strip);
        }
        now
    }

    /// Slip, friction power and temperatures of a strip.
    fn warm(&mut self, now: &mut Snapshot, strip: usize) {
        let strip = self.patch.strips[strip].clone();
        let mut path_in = Passage::default();
        for k in strip.cells.clone() {
            let cell = self.patch.cells[k];
            if k == strip.cells.start {
                path_in = self.path_in(&now.kinematics, k, None);
            }
            let is_last = k + 1 == strip.cells.end;
            let way_out = if is_last {
                let ends = [self.traction[k], [0.0; 2]];
                let way = (&strip.exit, &cell.row);
                Passage::new(&self.flexibility, &now.kinematics, way, ends)
            } else {
                self.path_in(&now.kinematics, k + 1, Some(k))
            };
            let heat = path_in.heat();
            let inherited = self.heat.inherited(k);
            now.scaled_rise[k] = self.heat.scaled_rise(k, inherited, heat);
            self.heat.flux[k] = heat;
            // Half of each path belongs to the cell, and all of a path from or to an edge.
            let shares = [
                if k == strip.cells.start { 1.0 } else { 0.5 } * cell.path_in.distance,
                if is_last { strip.exit.distance } else { 0.5 * way_out.distance },
            ];
            let mean = |of: fn(&Passage) -> f64| {
                (shares[0] * of(&path_in) + shares[1] * of(&way_out)) / (shares[0] + shares[1])
            };
            now.slip[k] = [mean(|way| way.slip[0]), mean(|way| way.slip[1])];
            now.friction_power[k] = cell.covered * mean(|way| way.power);
            path_in = way_out;
        }
        let duration = strip.exit.distance / now.kinematics.speed;
        let way_out = HeatStep { flux: path_in.heat(), duration };
        now.scaled_exit_rise.push(self.heat.scaled_exit_rise_after(&strip, way_out));
    }

    /// The path into a cell, from the previous cell if there is one.
    ///
    /// Where friction decreases along the strip, a part of the traction can no longer be sustained
    /// and springs back. The resulting slip and heat in a cell depend on the cell size, and so
    /// would friction that depends on them; this part is therefore ignored.
    fn path_in(&self, motion: &Kinematics, k: usize, before: Option<usize>) -> Passage {
        let held = |j: usize| {
            cut(self.traction[j], self.friction[k] * self.patch.cells[j].pressure_where_covered())
        };
        let ends = [before.map_or([0.0; 2], held), self.traction[k]];
        let cell = &self.patch.cells[k];
        Passage::new(&self.flexibility, motion, (&cell.path_in, &cell.row), ends)
    }
}

/// Replaces the pressure by 2N/(πab) (1 − x²/a² − y²/b²). Its mean over the covered part of a cell
/// follows from the moment of the path since entry, as 1 − x²/a² − y²/b² = (x_e² − x²)/a² with
/// x_e(y) the leading edge.
fn make_parabolic(patch: &mut Patch, normal: &NormalSummary) {
    let (a, b) = (normal.semi_axis_x, normal.semi_axis_y);
    let peak = FRAC_2_PI * normal.load / (a * b);
    for cell in &mut patch.cells {
        cell.pressure = peak * cell.covered * 2.0 * cell.since_entry.moment_x / (a * a);
    }
}
