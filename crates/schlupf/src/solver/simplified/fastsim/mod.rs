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

mod path;
mod cell;
mod flexibility;
mod passage;
mod side_by_side;

use std::f64::consts::FRAC_2_PI;
use std::sync::Arc;

use crate::bodies::Kinematics;
use crate::interface::Flow;
use crate::interface::heat::strip_heat::StripHeat;
use crate::interface::heat::{HeatModel, HeatStep, is_same};
use crate::normal::patch::Patch;
use crate::normal::{Grid, NormalContact, NormalSummary, Pressure};
use crate::numerics::root::fixed_point_near;
use crate::problem::{Brush, Options, Problem, SlopeReduction, TractionBound};
use crate::reporting::Error;
use crate::solution::Resultant;
use crate::solver::summary::snapshot::Snapshot;

use super::elliptic_contact::{EllipticContact, friction_limit};
use cell::{Carried, Held};
use flexibility::{Flexibility, slope_reduction};
use passage::{Approach, Passage};
use path::Path;
use side_by_side::{Found, FourStrips, WithFriction, Workspace, four_by_four};

/// Bristles, and their softening in modified FASTSIM.
type Kind = (Brush, Option<SlopeReduction>);

/// A patch of bristles.
#[derive(Debug, Clone)]
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
    /// The strips of the patch, and work arrays for passes down them.
    strips: Vec<FourStrips>,
    workspace: Workspace,
    heat: StripHeat,
    /// Whether the rises are sums of what the cells upstream contribute.
    is_linear: bool,
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
            let flows = problem.interface.layer.is_some_and(|layer| layer.yield_limit().is_some());
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
            strips: four_by_four(&patch),
            workspace: Workspace::new(&patch),
            heat: StripHeat::new(&patch),
            is_linear: false,
            heated: (None, 0.0),
            patch,
        };
        fastsim.set_friction(problem);
        Ok(fastsim)
    }

    /// Switches to another friction law.
    pub fn set_friction(&mut self, problem: &Problem) {
        let conduction = problem.interface.conduction(&problem.kinematics);
        for (friction, cell) in self.friction.iter_mut().zip(&self.patch.cells) {
            let by_law =
                problem.interface.friction_response(&conduction, 0.0, 0.0, cell.y).coefficient;
            *friction = problem.interface.at_entry(by_law, cell);
        }
    }

    /// Switches to another load, which changes all lengths and all pressures by a factor.
    pub fn rescale(&mut self, length: f64, pressure: f64) {
        self.patch.rescale(length, pressure);
        for strips in &mut self.strips {
            strips.take_paths(&self.patch);
        }
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
        if problem.interface.has_constant_bound() {
            self.pass(motion);
        } else {
            self.pass_with_friction(problem);
        }
        self.resultant()
    }

    /// Sets the heat model and the speed, if they have changed.
    fn prepare_heat(&mut self, problem: &Problem) {
        let (model, speed) = (problem.interface.heat.model.as_ref(), problem.kinematics.speed);
        if is_same(self.heated.0.as_ref(), model) && self.heated.1 == speed {
            return;
        }
        self.heated = (model.map(Arc::clone), speed);
        let ways = self.patch.cells.iter().map(|cell| cell.path_in.distance);
        self.heat.set(model, ways.map(|way| [way / speed; 2]));
        self.is_linear = self.workspace.take_weights(&self.heat, &mut self.strips);
    }

    /// Passes from the leading to the trailing edges with the present friction.
    fn pass(&mut self, motion: &Kinematics) {
        for strips in &self.strips {
            let moved = (&self.flexibility, motion);
            strips.pass(moved, &self.friction, &mut self.traction);
        }
    }

    /// The same for friction that depends on slip and heat, or on how a layer flows.
    fn pass_with_friction(&mut self, problem: &Problem) {
        self.prepare_heat(problem);
        let flows = problem.interface.layer.is_some_and(|layer| layer.yield_limit().is_some());
        if flows || !self.is_linear {
            self.pass_one_by_one(problem);
            return;
        }
        let Self { strips, workspace, traction, friction, flexibility, heat, .. } = self;
        let pass = WithFriction::new(problem, flexibility);
        let mut found = Found { traction, friction, flux: &mut heat.flux };
        for strips in strips {
            pass.pass(strips, workspace, &mut found);
        }
    }

    /// The same for any layer and any model of heat, strip by strip; see [`WithFriction::pass`].
    fn pass_one_by_one(&mut self, problem: &Problem) {
        let Self { patch, traction, friction, flexibility, heat, .. } = self;
        let motion = &problem.kinematics;
        let conduction = problem.interface.conduction(motion);
        for strip in &patch.strips {
            let mut last = [problem.interface.friction.cold_coefficient(); 2];
            let mut slope = 0.0;
            let mut carried = Carried::entering();
            let mut pressure_before = 0.0;
            let mut flowed = 0.0;
            for k in strip.cells.clone() {
                let cell = &patch.cells[k];
                let inherited = heat.inherited(k);
                let approach = Approach::new(flexibility, motion, &Path::into_cell(cell));
                let pressure_here = cell.pressure_where_covered();
                let (step, before) = (carried.along(approach.stick_increment), carried.held());
                let arrive = |mu: f64| {
                    let (next, _) = step.under(mu * pressure_here);
                    let [from, _] = before.under(mu * pressure_before);
                    let ends = [from, next.traction];
                    let passage = approach.passage(ends);
                    (next, passage, approach.slip_speed(&passage, ends))
                };
                let start = (2.0 * last[0] - last[1]).max(0.0);
                let mut flow = Flow::default();
                let mu = fixed_point_near(start, &mut slope, |mu| {
                    let (_, passage, slip_speed) = arrive(mu);
                    let scaled_rise = heat.scaled_rise(k, inherited, passage.heat());
                    let friction = problem
                        .interface
                        .friction_response(&conduction, scaled_rise, slip_speed, cell.y)
                        .coefficient;
                    let Some(layer) = &problem.interface.layer else { return friction };
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
        let conduction = problem.interface.conduction(motion);
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
        let mut path_in = self.path_in(&now.kinematics, strip.cells.start, None);
        for k in strip.cells.clone() {
            let cell = self.patch.cells[k];
            let is_last = k + 1 == strip.cells.end;
            let way_out = if is_last {
                let ends = [self.traction[k], [0.0; 2]];
                let path = Path::of(&strip.exit, &cell.row);
                Passage::new(&self.flexibility, &now.kinematics, &path, ends)
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
            let mean = |of: fn(&Passage<f64>) -> f64| {
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
    fn path_in(&self, motion: &Kinematics, k: usize, before: Option<usize>) -> Passage<f64> {
        let held = |j: usize| {
            let bound = self.friction[k] * self.patch.cells[j].pressure_where_covered();
            Held::of(self.traction[j]).under(bound)[0]
        };
        let ends = [before.map_or([0.0; 2], held), self.traction[k]];
        let cell = &self.patch.cells[k];
        Passage::new(&self.flexibility, motion, &Path::into_cell(cell), ends)
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

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use approx::assert_relative_eq;

    use super::*;
    use crate::interface::friction::{
        Exponential, FrictionLaw, FrictionResponse, FrictionState, Polach, Product, SlipTerms,
        TemperatureLinear,
    };
    use crate::interface::heat::{ConstantSource, Heat};

    /// A law that counts how often it is asked.
    #[derive(Debug)]
    struct Counted {
        law: Arc<dyn FrictionLaw>,
        count: AtomicUsize,
    }

    impl FrictionLaw for Counted {
        fn respond(&self, state: &FrictionState) -> FrictionResponse {
            self.count.fetch_add(1, Ordering::Relaxed);
            self.law.respond(state)
        }

        fn follows_slip_speed(&self) -> bool {
            self.law.follows_slip_speed()
        }
    }

    fn laws() -> [Arc<dyn FrictionLaw>; 3] {
        let hot: Arc<dyn FrictionLaw> = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.05).unwrap());
        let fast: Arc<dyn FrictionLaw> = Arc::new(Polach::new(0.4, 0.4, 0.2).unwrap());
        let both = Product::new(Arc::clone(&hot), Arc::clone(&fast)).unwrap();
        [hot, fast, Arc::new(both)]
    }

    /// The patch of a contact of 80 kN under a law, and the ellipse.
    fn set_up(law: Arc<dyn FrictionLaw>, kind: Kind) -> (Problem, Fastsim, EllipticContact) {
        let mut problem = Problem::builder().load(80e3).build().unwrap();
        problem.interface.friction.law = law;
        let options = Options { cells_x: 23, cells_y: 22, ..Options::default() };
        let normal = problem.normal.normal_contact(None).unwrap();
        let contact = EllipticContact::of(&problem, normal.summary).unwrap();
        let fastsim = Fastsim::new(&problem, &options, kind, &normal).unwrap();
        (problem, fastsim, contact)
    }

    fn motions() -> impl Iterator<Item = Kinematics> {
        let creepages = [
            [1e-4, 0.0, 0.0],
            [2e-3, 1e-3, 0.3],
            [-4e-3, 3e-3, -0.8],
            [0.02, 0.0, 0.0],
            [-0.2, 0.05, 2.0],
            [0.0, 0.0, 3.0],
        ];
        creepages.into_iter().map(|[creepage_x, creepage_y, spin]| Kinematics {
            creepage_x,
            creepage_y,
            spin,
            ..Kinematics::free_rolling(30.0)
        })
    }

    /// Four strips side by side, by Newton's method, give the tractions, coefficients and heat of
    /// one cell after another with a bracket, for friction that depends on the temperature, on the
    /// slip speed and on both; with 22 rows the last strips are not four. Friction falls so slowly
    /// that no cell has two solutions.
    #[test]
    fn strips_side_by_side_are_those_one_by_one() {
        for kind in [(Brush::KALKER, None), (Brush::KALKER, Some(SlopeReduction::DRY))] {
            for law in laws() {
                let (mut problem, mut fastsim, contact) = set_up(law, kind);
                for motion in motions() {
                    problem.kinematics = motion;
                    fastsim.force(&problem, &contact);
                    let together = (
                        fastsim.traction.clone(),
                        fastsim.friction.clone(),
                        fastsim.heat.flux.clone(),
                    );
                    fastsim.pass_one_by_one(&problem);
                    let hottest = fastsim.heat.flux.iter().copied().fold(0.0, f64::max);
                    for k in 0..fastsim.patch.len() {
                        let bound = 0.4 * fastsim.patch.cells[k].pressure_where_covered();
                        for c in 0..2 {
                            let (one, other) = (together.0[k][c], fastsim.traction[k][c]);
                            assert_relative_eq!(one, other, epsilon = 1e-9 * bound);
                        }
                        assert_relative_eq!(together.1[k], fastsim.friction[k], epsilon = 1e-9);
                        let (one, other) = (together.2[k], fastsim.heat.flux[k]);
                        assert_relative_eq!(one, other, epsilon = 1e-8 * hottest);
                    }
                }
            }
        }
    }

    /// The law is asked at most 3.5 times in a cell, the lanes without a cell included, if friction
    /// depends on the temperature, and six times if it falls with the slip speed.
    #[test]
    fn newtons_method_takes_few_steps() {
        for (law, most) in laws().into_iter().zip([3.5, 6.0, 6.0]) {
            let counted = Arc::new(Counted { law, count: AtomicUsize::new(0) });
            let law = Arc::clone(&counted);
            let (mut problem, mut fastsim, contact) = set_up(law, (Brush::KALKER, None));
            for motion in motions() {
                problem.kinematics = motion;
                counted.count.store(0, Ordering::Relaxed);
                fastsim.force(&problem, &contact);
                let asked = counted.count.load(Ordering::Relaxed) as f64;
                let each = asked / fastsim.patch.len() as f64;
                assert!(each < most, "{:?} {motion:?}: {each}", counted.law);
            }
        }
    }

    /// A model of heat that is not linear goes strip by strip, and heats.
    #[test]
    fn models_that_are_not_linear_are_followed() {
        let [hot, ..] = laws();
        let (mut problem, mut fastsim, contact) = set_up(hot, (Brush::KALKER, None));
        problem.kinematics = Kinematics { creepage_x: 0.1, ..Kinematics::free_rolling(30.0) };
        let exact = fastsim.force(&problem, &contact).x;
        problem.interface.heat =
            Heat { model: Some(Arc::new(ConstantSource)), ..problem.interface.heat };
        let model = fastsim.force(&problem, &contact).x;
        assert!(!fastsim.is_linear);
        assert_relative_eq!(model, exact, max_relative = 0.1);
        assert!(model != exact);
    }

    /// Without creepage across rolling or spin there is no moment, however many rows there are and
    /// however they come to be side by side; also where cells could stick as well as slide.
    #[test]
    fn strips_do_not_depend_on_those_beside_them() {
        let steep = SlipTerms::new(0.4, 0.1, 0.1, None).unwrap();
        for cells_y in [17, 21, 22, 23, 24] {
            let law: Arc<dyn FrictionLaw> = Arc::new(Exponential(steep));
            let (mut problem, ..) = set_up(Arc::clone(&law), (Brush::KALKER, None));
            let options = Options { cells_x: 24, cells_y, ..Options::default() };
            let normal = problem.normal.normal_contact(None).unwrap();
            let contact = EllipticContact::of(&problem, normal.summary).unwrap();
            let kind = (Brush::KALKER, None);
            let mut fastsim = Fastsim::new(&problem, &options, kind, &normal).unwrap();
            for creepage_x in [1e-3, 3e-3, 1e-2] {
                problem.kinematics = Kinematics { creepage_x, ..Kinematics::free_rolling(40.0) };
                let force = fastsim.force(&problem, &contact);
                let limit = 0.4 * 80e3 * contact.lever();
                assert!(force.moment_z.unwrap().abs() < 1e-9 * limit, "{cells_y}: {force:?}");
            }
        }
    }
}
