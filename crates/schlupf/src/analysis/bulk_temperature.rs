//! The long-term bulk temperature of a wheel.
//!
//! A point of the wheel passes the contact once per revolution, too briefly to warm more than a
//! skin; over minutes the whole wheel warms until it loses as much heat as it receives. In the
//! steady state (Ertz and Knothe, *A comparison of analytical and numerical methods for the
//! calculation of temperatures in wheel/rail contact*, Wear 253, 2002)
//!
//! α_w ∫ q dA = h A (T_w − T_air) + 2 β_w (T_w − T_m) ∫ √(v_w L/π) dy:
//!
//! the wheel's share of the frictional heat leaves by convection from its surface and through the
//! contact into the cold rail. L is the length of the contact in a line y, v_w the speed of the
//! wheel's material there, and T_m the temperature to which both surfaces jump when they meet, the
//! mean of the bulk temperatures weighted by β√v. A half-space whose surface is held at T_w − T_m
//! below its bulk temperature absorbs 2 β_w (T_w − T_m) √(t/π) per unit area in a time t = L/v_w
//! (Carslaw and Jaeger 1959, §2.5), and v_w dy of its surface passes through the contact every
//! second.
//!
//! Limits: the wheel has one temperature apart from a thin skin; temperature-dependent friction is
//! that of the warm wheel; radiation and heat from brake blocks or bearings are neglected.

use crate::bodies::Kinematics;
use crate::normal::Grid;
use crate::normal::patch::Patch;
use crate::problem::Problem;
use crate::reporting::{
    Error, MethodPurpose, Progress, Quantity, Stage, Unconverged, Warning, Watch, require_finite,
    require_positive, within,
};
use crate::solution::{Solution, Status};
use crate::solver::reference_point::place;
use crate::solver::{Solver, summary};

/// Cooling of a wheel by the air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cooling {
    /// Heat transfer coefficient h, in W/(m² K).
    pub film_coefficient: f64,
    /// Area A of the wheel surface cooled by the air, in m².
    pub area: f64,
    /// Temperature of the air, in degC.
    pub air_temperature: f64,
}

impl Cooling {
    fn check(&self) -> Result<(), Error> {
        require_positive(Quantity::FilmCoefficient, self.film_coefficient)?;
        require_positive(Quantity::CooledArea, self.area)?;
        require_finite(Quantity::AirTemperature, self.air_temperature)
    }
}

/// The heat balance of a wheel.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct BulkTemperature {
    /// Bulk temperature of the wheel, in degC.
    pub temperature: f64,
    /// Frictional heat into the wheel, in W.
    pub frictional_heat: f64,
    /// Heat lost to the air, in W.
    pub convection: f64,
    /// Heat lost to the rail through the contact, in W.
    pub conduction: f64,
    /// Temperature to which both surfaces jump when they meet, in degC.
    pub entry_temperature: f64,
    /// The steady state at that temperature; not converged if it did not converge, or if the
    /// balance was not found.
    pub solution: Solution,
    /// Steady states solved.
    pub iterations: usize,
}

impl BulkTemperature {
    /// Heat received minus heat lost, in W.
    pub fn surplus(&self) -> f64 {
        self.frictional_heat - self.convection - self.conduction
    }
}

/// Largest admissible surplus relative to the frictional heat, dimensionless.
const BALANCED: f64 = 1e-6;

/// Maximum number of steady states before giving up.
const ITERATIONS: usize = 60;

/// Computes the bulk temperature of the wheel in steady rolling, replacing that given in the
/// problem. The rail keeps its own: every piece of it meets the wheel once.
///
/// ```
/// use schlupf::analysis::bulk_temperature::{Cooling, bulk_temperature};
/// use schlupf::solver::SteadySolver;
/// use schlupf::{Options, Problem, unwatched};
///
/// let problem = Problem::builder().creepage_x(0.008).build()?;
/// let options = Options { cells_x: 10, cells_y: 10, ..Options::default() };
/// let cooling = Cooling { film_coefficient: 40.0, area: 1.5, air_temperature: 20.0 };
/// let mut solver = SteadySolver::new(&options);
/// let balance = bulk_temperature(&problem, &mut solver, &cooling, &unwatched)?;
/// assert!(balance.surplus().abs() < 1e-3 * balance.frictional_heat);
/// # Ok::<(), schlupf::Error>(())
/// ```
///
/// # Errors
/// Whatever [`check`] and the solver reject, a method without heat, and [`Error::Stopped`].
pub fn bulk_temperature(
    problem: &Problem,
    solver: &mut dyn Solver,
    cooling: &Cooling,
    watch: Watch,
) -> Result<BulkTemperature, Error> {
    check(problem, cooling)?;
    let (problem, motion) = (problem.clone(), problem.kinematics);
    Balance { problem, motion, cooling: *cooling, solver, watch, iterations: 0 }.find()
}

/// Performs all checks possible before the first solution.
///
/// # Errors
/// A problem without heat model, and whatever [`Problem::check`] rejects.
pub fn check(problem: &Problem, cooling: &Cooling) -> Result<(), Error> {
    cooling.check()?;
    if problem.interface.heat.model.is_none() {
        return Err(Error::NoHeat {});
    }
    problem.check()
}

struct Balance<'a> {
    problem: Problem,
    /// At the centre of the patch in the last steady state, whose forces may be given.
    motion: Kinematics,
    cooling: Cooling,
    solver: &'a mut dyn Solver,
    watch: Watch<'a>,
    iterations: usize,
}

impl Balance<'_> {
    fn find(&mut self) -> Result<BulkTemperature, Error> {
        let rail = self.problem.interface.rail.bulk_temperature;
        let coldest = self.cooling.air_temperature.min(rail);
        let low = self.at(coldest)?;
        let hottest = self.hottest(&low)?;
        if low.surplus() <= BALANCED * low.frictional_heat || hottest <= coldest {
            return Ok(low);
        }
        let (low, high) = self.bracket(low, hottest)?;
        self.between(low, high)
    }

    /// The balance at a given bulk temperature of the wheel.
    fn at(&mut self, temperature: f64) -> Result<BulkTemperature, Error> {
        self.problem.interface.wheel.bulk_temperature = temperature;
        let progress = Progress::count(Stage::BulkTemperature, self.iterations);
        self.iterations += 1;
        let solution = self.solver.solve(&self.problem, &within(self.watch, progress))?;
        let known = solution.power.and_then(|power| Some((power.into_wheel, power.exchanged?)));
        let Some((frictional_heat, conduction)) = known else {
            let (purpose, method) = (MethodPurpose::BulkTemperature, solution.method.name());
            return Err(Error::OtherMethod { purpose, method });
        };
        let [x, y] = place(self.problem.reference, &solution.normal)?;
        self.motion = solution.kinematics.at([-x, -y]);
        let partition = self.problem.interface.conduction(&self.motion);
        Ok(BulkTemperature {
            temperature,
            entry_temperature: partition.entry_temperature,
            frictional_heat,
            convection: self.convection(temperature),
            conduction,
            solution,
            iterations: self.iterations,
        })
    }

    fn convection(&self, temperature: f64) -> f64 {
        let Cooling { film_coefficient, area, air_temperature } = self.cooling;
        film_coefficient * area * (temperature - air_temperature)
    }

    /// Heat flow through the contact divided by the step from the wheel's bulk temperature to its
    /// contact temperature, in W/K.
    fn chill(&self) -> Result<f64, Error> {
        let conduction = self.problem.interface.conduction(&self.motion);
        let wheel_speed = self.motion.speed / conduction.contact_times()[0];
        let normal = self.problem.normal.normal_contact(None)?;
        let options = self.solver.options();
        let grid = Grid::across(&normal.extent(), options.cells_x, options.cells_y);
        Ok(summary::chill(&self.problem, &Patch::new(&normal, grid), wheel_speed))
    }

    /// A temperature at which the wheel loses more heat than a cold one receives; below the one at
    /// which friction vanishes.
    fn hottest(&self, cold: &BulkTemperature) -> Result<f64, Error> {
        let weight = self.problem.interface.conduction(&self.motion).wheel_weight();
        let through = (1.0 - weight) * self.chill()?;
        let air = self.cooling.film_coefficient * self.cooling.area;
        let rail = self.problem.interface.rail.bulk_temperature;
        let given = cold.frictional_heat + air * self.cooling.air_temperature + through * rail;
        let limit = self.problem.interface.friction.reference_temperature
            + self.problem.interface.friction.law.temperature_limit();
        // Material enters the contact at the weighted mean of both bodies.
        let vanishing = (limit - (1.0 - weight) * rail) / weight;
        Ok((given / (air + through)).min(vanishing - 1e-6 * (vanishing - rail).abs()))
    }

    /// The balance at a temperature, or nearer to another one, where friction carries prescribed
    /// forces.
    fn towards(&mut self, from: f64, mut to: f64) -> Result<BulkTemperature, Error> {
        loop {
            match self.at(to) {
                Err(Error::Force { .. }) if self.iterations < ITERATIONS => to = 0.5 * (from + to),
                found => return found,
            }
        }
    }

    /// A temperature with a surplus and one without, from a guess of the latter. Where friction
    /// rises with temperature, or falls under a force that stays, the wheel becomes hotter than
    /// with the friction of a cold one.
    fn bracket(
        &mut self,
        mut low: BulkTemperature,
        guess: f64,
    ) -> Result<(BulkTemperature, BulkTemperature), Error> {
        let mut high = self.towards(low.temperature, guess)?;
        while high.surplus() > 0.0 && self.iterations < ITERATIONS {
            let next = high.temperature + 2.0 * (high.temperature - low.temperature);
            low = high;
            high = self.towards(low.temperature, next)?;
        }
        Ok((low, high))
    }

    /// Regula falsi between a temperature with a surplus and one without (Illinois).
    fn between(
        &mut self,
        mut low: BulkTemperature,
        mut high: BulkTemperature,
    ) -> Result<BulkTemperature, Error> {
        let (mut surplus, mut deficit) = (low.surplus(), high.surplus());
        let scale = [low.frictional_heat, low.convection, low.conduction]
            .into_iter()
            .fold(0.0, |scale: f64, heat| scale.max(heat.abs()));
        while self.iterations < ITERATIONS {
            for end in [&low, &high] {
                if end.surplus().abs() <= BALANCED * scale {
                    return Ok(end.clone());
                }
            }
            let share = surplus / (surplus - deficit);
            let temperature = low.temperature + share * (high.temperature - low.temperature);
            let middle = self.at(temperature)?;
            if middle.solution.status == Status::NotConverged {
                return Ok(middle);
            }
            if middle.surplus() > 0.0 {
                surplus = middle.surplus();
                deficit *= 0.5;
                low = middle;
            } else {
                deficit = middle.surplus();
                surplus *= 0.5;
                high = middle;
            }
        }
        low.solution.status = Status::NotConverged;
        let cause = Unconverged::HeatBalance { states: self.iterations, surplus: low.surplus() };
        low.solution.warnings.insert(0, Warning::of(cause));
        Ok(low)
    }
}
