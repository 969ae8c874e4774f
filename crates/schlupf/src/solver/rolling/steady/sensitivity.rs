//! Exact derivatives of the steady forces: F(p, θ) = 0 gives J dp/dθ = −∂F/∂θ with the Jacobian of
//! the converged equilibrium, one linear solution for each parameter θ.
//!
//! ∂F/∂θ is known in closed form: creepages and spin enter through the rigid slip, μ0 through the
//! bound μ pₙ, k_c through the law of each cell. A load that enlarges the patch scales all lengths.
//! Only the change of conduction along the surface with speeds and lengths is a finite difference
//! of two kernels.

use crate::bodies::Kinematics;
use crate::interface::friction::FrictionConstant;
use crate::interface::{InterfaceConstant, YieldLimit};
use crate::numerics::vector::{add_scaled, norm};
use crate::problem::{Direction, Problem};
use crate::reporting::{Error, Progress, Stage, Watch, tell};
use crate::solution::{Resultant, Sensitivity};
use crate::solver::equilibrium::{Continues, Directions, Equilibrium};
use crate::solver::rolling::shared::strip::Calibrated;
use crate::solver::{settings, summary};

use super::level::Level;
use super::steady_friction::{Scaling, SteadyFriction};
use super::steady_state::{Direct, SteadyState};

/// The derivatives at the solution of the first of `levels`, if all linear systems could be solved;
/// and the number of products, which those before spare with their directions. An error if it was
/// stopped.
pub(super) fn sensitivity(
    problem: &Problem,
    (levels, directions): (&mut [Level], &mut Directions),
    tolerance: f64,
    watch: Watch,
) -> Result<(Option<Sensitivity>, usize), Error> {
    let mut derivatives = Derivatives::new(problem, (levels, directions), tolerance, watch);
    let found = derivatives.all();
    derivatives.finished(found)
}

/// The same for changes by some motions at the centre of the patch, one derivative for each, less
/// accurate.
pub(super) fn by_motions(
    problem: &Problem,
    (levels, directions): (&mut [Level], &mut Directions),
    motions: &[Kinematics],
    watch: Watch,
) -> Result<(Option<Vec<Resultant>>, usize), Error> {
    let mut derivatives = Derivatives::new(problem, (levels, directions), 1.0, watch);
    let warmer = derivatives.warmer();
    let found = motions.iter().map(|motion| derivatives.along(motion, &warmer)).collect();
    derivatives.finished(found)
}

/// The same with respect to some constants of the interface only, one derivative for each.
pub(super) fn by_constants(
    problem: &Problem,
    (levels, directions): (&mut [Level], &mut Directions),
    tolerance: f64,
    (constants, watch): (&[InterfaceConstant], Watch),
) -> Result<(Option<Vec<Resultant>>, usize), Error> {
    let mut derivatives = Derivatives::new(problem, (levels, directions), tolerance, watch);
    let found = constants.iter().map(|constant| derivatives.by_constant(*constant)).collect();
    derivatives.finished(found)
}

struct Derivatives<'a> {
    problem: &'a Problem,
    levels: &'a mut [Level],
    directions: &'a mut Directions,
    products: usize,
    /// Whether the directions are those of the Jacobian.
    is_known: bool,
    watch: Watch<'a>,
    /// Why the last derivative was not found, if it was stopped.
    stopped: Option<Error>,
    accuracy: f64,
    step: Vec<f64>,
    response_step: Vec<f64>,
    change: Vec<f64>,
    response_change: Vec<f64>,
    /// All changes with their responses, in Pa and m per unit of the parameter.
    found: Vec<[Vec<f64>; 2]>,
}

impl<'a> Derivatives<'a> {
    fn new(
        problem: &'a Problem,
        (levels, directions): (&'a mut [Level], &'a mut Directions),
        tolerance: f64,
        watch: Watch<'a>,
    ) -> Self {
        let (size, response_size) = (levels[0].size(), levels[0].response.len());
        levels[0].strips.is_exact = true;
        let (p, u) = (levels[0].traction.clone(), levels[0].response.clone());
        SteadyState::new(problem, levels).residual(&p, &u, &mut vec![0.0; size]);
        levels[0].strips.is_exact = false;
        // The derivatives at the last solution are nearly those at this one; and where all is
        // proportional, what two parameters do differs by the state itself.
        let state = levels[0].changes.drain(..).chain([[p, u]]);
        for [change, response] in state.filter(|[_, u]| u.len() == response_size) {
            directions.add(&change, &response);
        }
        Self {
            accuracy: (settings::accuracy_of_derivatives() * tolerance)
                .min(settings::least_accurate_derivatives())
                .max(f64::EPSILON * size as f64),
            products: 0,
            is_known: false,
            watch,
            stopped: None,
            problem,
            levels,
            directions,
            step: vec![0.0; size],
            response_step: vec![0.0; response_size],
            change: vec![0.0; size],
            response_change: vec![0.0; response_size],
            found: Vec::new(),
        }
    }

    /// What was found with the number of products, unless it was stopped.
    fn finished<T>(self, found: T) -> Result<(T, usize), Error> {
        self.levels[0].changes = self.found;
        self.stopped.map_or(Ok((found, self.products)), Err)
    }

    /// Change of the forces when the motion changes by another one.
    fn along(&mut self, motion: &Kinematics, warmer: &[f64]) -> Option<Resultant> {
        let [by_x, by_y] = self.problem.kinematics.contact_time_ratio_by_creepage();
        let time_ratio = by_x * motion.creepage_x + by_y * motion.creepage_y;
        let motion = Kinematics { speed: self.problem.kinematics.speed, ..*motion };
        self.by(&self.by_motion(&motion, time_ratio, warmer))
    }

    fn all(&mut self) -> Option<Sensitivity> {
        let warmer = self.warmer();
        Some(Sensitivity {
            creepage_x: self.along(&Direction::X.unit(), &warmer)?,
            creepage_y: self.along(&Direction::Y.unit(), &warmer)?,
            spin: self.along(&Direction::Spin.unit(), &warmer)?,
            load: match self.direct_by_load() {
                Some(direct) => Some(self.by_load(&direct)?),
                None => None,
            },
            friction_coefficient: self.by(&self.by_friction())?,
            contact_stiffness: self.by_stiffness()?,
        })
    }

    fn by_constant(&mut self, constant: InterfaceConstant) -> Option<Resultant> {
        match constant {
            InterfaceConstant::ContactStiffness => self.by_stiffness(),
            InterfaceConstant::LayerShearModulus => self.by_layer(),
            InterfaceConstant::LayerYieldStress => self.by_yield_limit([1.0, 0.0]),
            InterfaceConstant::LayerHardening => self.by_yield_limit([0.0, 1.0]),
            InterfaceConstant::Friction(FrictionConstant::ColdCoefficient) => {
                self.by(&self.by_friction())
            }
            InterfaceConstant::Friction(constant) => {
                let direct = self.by_friction_constant(constant)?;
                self.by(&direct)
            }
        }
    }

    /// Direct changes due to a constant of the friction law other than μ0.
    fn by_friction_constant(&self, constant: FrictionConstant) -> Option<Direct> {
        let law = self.problem.interface.friction.law.adjustable()?;
        let Level { contact, friction, .. } = &self.levels[0];
        let mut direct = Direct::nothing(self.levels[0].strips.len());
        for k in 0..contact.patch.len() {
            let states = friction.states(self.problem, &contact.patch, k);
            let [here, entry] = states.map(|state| law.by_constant(constant, &state));
            direct.friction.law[k] = here;
            direct.friction.entry[k] = entry;
        }
        Some(direct)
    }

    /// Derivative of the contact temperature in every cell (in K) with respect to ln(v0/(ωR)), at
    /// constant friction power.
    fn warmer(&self) -> Vec<f64> {
        let Level { contact, friction, .. } = &self.levels[0];
        let by_contact_time =
            |scaled_rise: &f64| friction.conduction.contact_temperature_by_time_ratio(*scaled_rise);
        let perpendicular = || friction.scaled_rise.iter().map(by_contact_time).collect();
        friction
            .contact_temperature_by(self.problem, &contact.patch, Scaling::ContactTime)
            .unwrap_or_else(perpendicular)
    }

    /// Direct changes when the motion changes by `motion`, and ln(v0/(ωR)) by `contact_time_ratio`,
    /// where the contact temperature changes by `warmer` (in K).
    fn by_motion(&self, motion: &Kinematics, contact_time_ratio: f64, warmer: &[f64]) -> Direct {
        let Level { contact, friction, .. } = &self.levels[0];
        let mut direct = Direct::nothing(self.levels[0].strips.len());
        for (k, cell) in contact.patch.cells.iter().enumerate() {
            direct.set_motion(k, cell, motion);
            let by_temperature = friction.response[k].by_temperature;
            direct.friction.law[k] = by_temperature * contact_time_ratio * warmer[k];
            let entry = friction.conduction.contact_temperature_by_time_ratio(0.0);
            direct.friction.entry[k] =
                friction.lag.entry[k].by_temperature * contact_time_ratio * entry;
        }
        direct
    }

    fn by_friction(&self) -> Direct {
        let SteadyFriction { response, lag, .. } = &self.levels[0].friction;
        let mut direct = Direct::nothing(self.levels[0].strips.len());
        for (k, (response, entry)) in response.iter().zip(&lag.entry).enumerate() {
            direct.friction.law[k] = response.by_cold_coefficient;
            direct.friction.entry[k] = entry.by_cold_coefficient;
        }
        direct
    }

    fn by_stiffness(&mut self) -> Option<Resultant> {
        let stiffness = self.problem.interface.contact_law.stiffness();
        let mut direct = Direct::nothing(self.levels[0].strips.len());
        direct.cause.stiffness = 1.0;
        Some(scaled(&self.by(&direct)?, stiffness.recip()))
    }

    /// Derivative by the shear modulus of the layer, whose shear is inversely proportional to it.
    fn by_layer(&mut self) -> Option<Resultant> {
        let layer = self.problem.interface.layer?;
        let mut direct = Direct::nothing(self.levels[0].strips.len());
        direct.response = self.part_of_response(Calibrated::OfLayer)?;
        self.products += 1;
        Some(scaled(&self.by(&direct)?, -layer.shear_modulus().recip()))
    }

    /// Derivative by the yield stress, or by the hardening: by a change of both.
    fn by_yield_limit(&mut self, [stress, hardening]: [f64; 2]) -> Option<Resultant> {
        self.problem.interface.layer?.yield_limit()?;
        let cells = self.levels[0].strips.len();
        let mut direct = Direct::nothing(cells);
        let limit = YieldLimit { stress, hardening };
        if self.levels[0].friction.is_coupled {
            direct.friction.limit = limit;
            return self.by(&direct);
        }
        // A limit that does not change with the plastic displacement does not depend on the slip.
        SteadyState::new(self.problem, self.levels).evaluate_passing();
        self.products += 1;
        let friction = &self.levels[0].friction;
        direct.bound = (0..cells).map(|k| friction.bound_by_limit(k, limit)).collect();
        self.by(&direct)
    }

    /// Direct changes with the logarithm of the load, if the elasticity knows how it scales and the
    /// bodies are alike.
    fn direct_by_load(&mut self) -> Option<Direct> {
        let load_exponent = self.problem.normal.load_exponent()?;
        if self.levels[0].contact.pressed.is_some() {
            return None;
        }
        let mut direct = Direct::nothing(self.levels[0].strips.len());
        direct.response = vec![0.0; self.response_step.len()];
        if load_exponent != 0.0 {
            direct.response = self.part_of_response(Calibrated::BySize)?;
            self.products += 1;
        }
        let Level { contact, strips, friction, response, .. } = &self.levels[0];
        for u in &mut direct.response {
            *u *= load_exponent;
        }
        let kinematics = &self.problem.kinematics;
        let turning = Kinematics { spin: kinematics.spin, ..standing(self.problem) };
        let warmer = friction.contact_temperature_by(self.problem, &contact.patch, Scaling::Size);
        let changes = contact.patch.strips_by_size();
        for (k, cell) in contact.patch.cells.iter().enumerate() {
            // All paths grow; the contribution of spin grows with the square.
            direct.set_motion(k, cell, &turning);
            let rigid = cell.path_in.rigid_slip(kinematics);
            for (c, rigid) in rigid.into_iter().enumerate() {
                direct.cause.rigid[2 * k + c] += rigid;
                direct.cause.rigid[2 * k + c] *= load_exponent;
                direct.friction.slip[k][c] *= load_exponent;
            }
            if let Some(changes) = &changes {
                let [path, slip] = cell.row_by_size(&changes[k]);
                for c in 0..2 {
                    direct.cause.rigid[2 * k + c] += load_exponent * path[c];
                    direct.friction.slip[k][c] += load_exponent * kinematics.speed * slip[c];
                }
            }
            // T β is a flux times the square root of a time.
            let by_size = warmer.as_ref().map_or(0.5 * friction.scaled_rise[k], |warmer| {
                warmer[k] / friction.conduction.contact_factor()
            });
            direct.friction.scaled_rise[k] = load_exponent * by_size;
            direct.friction.law[k] = load_exponent * friction.response[k].by_y * cell.y;
            direct.friction.entry[k] = load_exponent * friction.lag.entry[k].by_y * cell.y;
            let is_layer = friction.yields(k);
            let growing = if is_layer { 0.0 } else { 1.0 - 2.0 * load_exponent };
            direct.bound[k] = growing * strips.bound()[k];
        }
        direct.friction.path = load_exponent;
        // The slip is the change of A p along the passage divided by the cell size, which grows.
        if friction.is_coupled {
            let size = strips.len() * 2;
            add_scaled(&mut direct.response[size..], -load_exponent, &response[size..]);
        }
        Some(direct)
    }

    /// A part or a derivative of the linear response, with nothing if the elasticity does not know
    /// it.
    fn part_of_response(&mut self, what: Calibrated) -> Option<Vec<f64>> {
        let mut response = vec![0.0; self.response_step.len()];
        let mut system = SteadyState::new(self.problem, self.levels);
        match system.part_of_response(what, &mut response) {
            Ok(is_known) => is_known.then_some(response),
            Err(error) => {
                self.stopped = Some(error);
                None
            }
        }
    }

    fn by_load(&mut self, direct: &Direct) -> Option<Resultant> {
        let load_exponent = self.problem.normal.load_exponent()?;
        let moved = self.by(direct)?;
        let Level { contact, traction, .. } = &self.levels[0];
        let whole = summary::resultant(&contact.patch, traction);
        // The area of the cells also grows, and so do the lever arms.
        let grown = moved.plus(load_exponent, &whole.scaled(2.0, 3.0));
        Some(scaled(&grown, contact.normal.load.recip()))
    }

    /// Change of the forces due to direct changes.
    fn by(&mut self, direct: &Direct) -> Option<Resultant> {
        let size = self.step.len();
        let mut residual = vec![0.0; size];
        let mut system = SteadyState::new(self.problem, self.levels);
        system.change_by(direct, &mut residual);
        let start = norm(&residual);
        self.change.fill(0.0);
        self.response_change.fill(0.0);
        let mut left = start;
        let mut product = vec![0.0; size];
        let mut before = f64::INFINITY;
        while left > self.accuracy * start && left < 0.5 * before {
            let targets = [self.step.as_mut_slice(), self.response_step.as_mut_slice()];
            let forcing = (0.5 * self.accuracy * start / left).min(0.5);
            let continues = || tell(self.watch, Progress::count(Stage::Steady, 0));
            let targets = (targets, &continues as Continues);
            let found = if std::mem::replace(&mut self.is_known, true) {
                self.directions.solve_again(&mut system, &residual, forcing, targets)
            } else {
                self.directions.solve(&mut system, &residual, forcing, targets)
            };
            match found {
                Ok(products) => self.products += products,
                Err(error) => {
                    self.stopped = Some(error);
                    return None;
                }
            }
            system.tangent_product(&self.step, &self.response_step, &mut product);
            add_scaled(&mut residual, 1.0, &product);
            add_scaled(&mut self.change, 1.0, &self.step);
            add_scaled(&mut self.response_change, 1.0, &self.response_step);
            (before, left) = (left, norm(&residual));
        }
        let is_good = left <= settings::inaccurate_derivatives() * self.accuracy * start;
        if !is_good || !start.is_finite() {
            return None;
        }
        self.found.push([self.change.clone(), self.response_change.clone()]);
        Some(summary::resultant(&self.levels[0].contact.patch, &self.change))
    }
}

/// The motion of the frame alone.
fn standing(problem: &Problem) -> Kinematics {
    let speed = problem.kinematics.speed;
    Kinematics::free_rolling(speed)
}

fn scaled(resultant: &Resultant, factor: f64) -> Resultant {
    resultant.scaled(factor, factor)
}
