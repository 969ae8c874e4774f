//! The element of one contact.

use crate::bodies::ReferenceSpeed;
use crate::numerics::dual::{Dual, Number};
use crate::reporting::{Error, Quantity, Warning, require_positive};
use crate::solver::rolling;
use crate::solver::simplified::{self, EllipticContact};
use crate::{Method, Options, Problem};

use super::acting::Acting;
use super::evaluation::{Evaluation, Status};
use super::flash::Flash;
use super::law::Law;
use super::memory::{Memory, Patch};
use super::patch::{Patches, Pressed};
use super::rolling::Rolling;
use super::settings::{Motion, Settings};
use super::signals::{self, FACTOR, INPUTS, NORMAL, OUTPUTS, Signals, VARIABLES};

/// Friction below which a patch is one of this friction, so that it has a time scale;
/// dimensionless.
const SMALLEST_FRICTION: f64 = 1e-4;

/// A contact as a function of inputs and states. Clones are independent; that of a solver has
/// solved nothing yet.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    settings: Settings,
    signals: Signals,
    problem: Problem,
    patches: Patches,
    law: Law,
    memory: Memory,
    flash: Option<Flash>,
    /// What the method neglects.
    pub warnings: Vec<Warning>,
}

impl Contact {
    /// # Errors
    /// Whatever the problem and the method reject, a patch whose shape changes with the load, and
    /// an approach as an input where the normal contact has none.
    pub fn new(
        problem: &Problem,
        method: (&Method, &Options),
        settings: Settings,
    ) -> Result<Self, Error> {
        require_positive(Quantity::StandstillSpeed, settings.standstill_speed)?;
        require_positive(Quantity::RollingRadius, settings.rolling_radius)?;
        problem.check()?;
        if problem.interface.elasticity.viscoelastic().is_some() {
            return Err(Error::ViscoelasticUnsteady {});
        }
        method.1.check()?;
        if let Method::Fast(fast) = method.0 {
            fast.check()?;
        }
        let contact = EllipticContact::new(problem)?;
        let patches = Patches::new(problem, &contact, settings.normal)?;
        let mut moving = problem.clone();
        if settings.motion == Motion::Velocities {
            moving.kinematics.reference_speed = ReferenceSpeed::Mean;
        }
        let law = Law::new(&moving, method, &contact)?;
        let warnings = match method.0 {
            Method::Full => rolling::shared::warnings::of_any_motion(problem, &contact.normal),
            Method::Fast(fast) => {
                simplified::warnings::of_any_motion(problem, &contact.normal, fast)
            }
        };
        let flash = Flash::new(&problem.interface);
        let signals = Signals::new(&settings, &law, [patches.has_approach(), flash.is_some()]);
        let memory = Memory::new(&contact, problem.interface.poisson_ratio(), law.has_limit());
        let problem = problem.clone();
        Ok(Self { settings, signals, problem, patches, law, memory, flash, warnings })
    }

    pub fn signals(&self) -> &Signals {
        &self.signals
    }

    /// What the inputs are in the problem, each in the unit of its quantity.
    pub fn start(&self) -> Vec<f64> {
        signals::start(&self.problem, &self.settings, &self.patches)
    }

    /// Finds outputs, rates and derivatives.
    pub fn evaluate(&mut self, inputs: &[f64], states: &[f64], found: &mut Evaluation) -> Status {
        let given = Self::variables(inputs, states);
        if !given.iter().all(|number| number.is_finite()) {
            found.fill(f64::NAN);
            return Status::NotFinite;
        }
        if found.derivatives.is_empty() {
            let plain = given.map(Dual::<0>::from);
            self.find(&plain[..INPUTS + self.signals.states.len()], found)
        } else if self.settings.has_memory {
            self.find(&Dual::<VARIABLES>::variables(given), found)
        } else {
            let [inputs @ .., _, _, _] = given;
            self.find(&Dual::<INPUTS>::variables(inputs), found)
        }
    }

    /// With the derivatives that the variables have: with respect to inputs and states, or none.
    fn find<const N: usize>(&mut self, variables: &[Dual<N>], found: &mut Evaluation) -> Status {
        let (rolling, pressed, friction) = self.acting(variables);
        let (mut creepages, mut speed) = (rolling.creepages, rolling.positive_speed);
        if let Some(&[x, y, spin]) = variables[INPUTS..].first_chunk() {
            let shift = [x, y, spin];
            let patch = self.remembering(variables, friction);
            let rates = self.memory.rates(&patch, (&rolling, shift));
            for (k, rate) in rates.iter().enumerate() {
                found.set(self.signals.outputs.len() + k, rate);
            }
            creepages = self.memory.steady(&patch, shift);
            speed = rolling.speed_of(creepages);
        }
        let Pressed { load, semi_axes, .. } = pressed;
        let (factor, temperatures) =
            (variables[FACTOR], [variables[FACTOR + 1], variables[FACTOR + 2]]);
        let acting = Acting {
            creepages,
            speed,
            load,
            semi_axes,
            friction_factor: factor,
            temperatures,
            limit: friction * load,
        };
        let Some(force) = self.force(&rolling, &acting) else {
            found.fill(f64::NAN);
            return Status::NotConverged;
        };
        let [x, y, moment] = force;
        let [slip_x, slip_y, turning] = rolling.slip;
        let power = -(x * slip_x + y * slip_y + moment * turning);
        let [a, b] = semi_axes;
        let rise = self
            .flash
            .map_or(power, |flash| flash.max_rise(power, (semi_axes, rolling.positive_speed)));
        let all: [_; OUTPUTS.len()] =
            [&x, &y, &moment, &load, &pressed.approach, &a, &b, &friction, &power, &rise];
        for (row, place) in self.signals.places.iter().enumerate() {
            found.set(row, all[*place]);
        }
        if found.is_finite(found.outputs.len()) {
            status(variables)
        } else {
            found.fill(f64::NAN);
            Status::NotFinite
        }
    }

    /// What follows from the inputs alone: the motion, the patch and the coefficient of friction.
    #[inline]
    fn acting<T: Number>(&self, variables: &[T]) -> (Rolling<T>, Pressed<T>, T) {
        let [x, y, spin, last, amount, factor, wheel, rail] = std::array::from_fn(|k| variables[k]);
        let rolling = Rolling::new(&self.settings, [x, y, spin, last]);
        let factor = if factor.value() > 0.0 { factor } else { T::from(0.0) };
        let friction = rolling.friction(&self.problem.interface, [wheel, rail]) * factor;
        (rolling, self.patches.pressed(self.settings.normal, amount), friction)
    }

    /// Rows that one element evaluates in turn.
    pub fn rows_in_turn(&self) -> usize {
        self.law.rows_in_turn()
    }

    /// Forgets what a solver found, from which it would start.
    pub fn forget(&mut self) {
        self.law.forget();
    }

    /// The states after a time (in s) with constant inputs.
    ///
    /// The error is of second order in sub-steps of its own, which do not depend on the duration,
    /// so that none is too long.
    pub fn advance(&self, inputs: &[f64], states: &mut [f64], duration: f64) -> Status {
        let given = Self::variables(inputs, states);
        if !given.iter().chain([&duration]).all(|number| number.is_finite()) || duration < 0.0 {
            return Status::NotFinite;
        }
        let Some(own) = states.first_chunk_mut() else { return status(&given) };
        let (rolling, _, friction) = self.acting(&given);
        let patch = self.remembering(&given, friction);
        self.memory.advance(&patch, &rolling, (own, duration));
        status(&given)
    }

    /// Inputs and states.
    fn variables(inputs: &[f64], states: &[f64]) -> [f64; VARIABLES] {
        let mut given = [0.0; VARIABLES];
        given.iter_mut().zip(inputs.iter().chain(states)).for_each(|(own, value)| *own = *value);
        given
    }

    /// The patch of which creepages relax, however small load and friction are.
    fn remembering<T: Number>(&self, variables: &[T], friction: T) -> Patch<T> {
        let load = self.patches.load(self.settings.normal, variables[NORMAL]);
        let (load, semi_axes, pressed) = self.patches.at_least(load);
        let least = T::from(SMALLEST_FRICTION);
        let friction = (friction + friction.hypot(least * 2.0)) * 0.5;
        Patch { semi_axes, limit: friction * load, pressed }
    }

    /// Fx, Fy (in N) and Mz (in N m): between forwards and backwards a part of each.
    fn force<const N: usize>(
        &mut self,
        rolling: &Rolling<Dual<N>>,
        acting: &Acting<Dual<N>>,
    ) -> Option<[Dual<N>; 3]> {
        let share = rolling.forwards();
        let turned = |[x, y, about]: [Dual<N>; 3]| [-x, -y, about];
        if share.value >= 1.0 {
            return self.law.force(acting);
        }
        let creepages = turned(acting.creepages);
        let behind = turned(self.law.force(&Acting { creepages, ..*acting })?);
        if share.value <= 0.0 {
            return Some(behind);
        }
        let ahead = self.law.force(acting)?;
        Some(std::array::from_fn(|k| behind[k] + share * (ahead[k] - behind[k])))
    }
}

fn status<T: Number>(variables: &[T]) -> Status {
    if variables[NORMAL].value() > 0.0 { Status::Found } else { Status::NoContact }
}
