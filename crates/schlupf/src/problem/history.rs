//! Creepages, speed and load over time: transient rolling, optionally starting with a shift at
//! rest.

use crate::bodies::Kinematics;
use crate::numerics::interpolation::piecewise_linear;
use crate::problem::{LongitudinalForce, PrescribedForces};
use crate::reporting::{
    Error, ForceError, Place, Quantity, Requirement, require_at, require_finite,
};

/// Quantities over time, linear between the times and constant outside. `None` means constant.
///
/// ```
/// use schlupf::problem::History;
/// use schlupf::bodies::Kinematics;
///
/// let creepage_x = Some(vec![0.0, 0.002]);
/// let history = History { time: vec![0.0, 1.0], creepage_x, ..History::default() };
/// let halfway = history.kinematics(0.5, &Kinematics::free_rolling(30.0));
/// assert_eq!((halfway.speed, halfway.creepage_x), (30.0, 0.001));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// Shift of the wheel over the rail at rest before it rolls, along and across rolling, in m.
    pub shift: Option<[f64; 2]>,
    /// Times, strictly ascending, in s; empty for a shift alone, or if nothing changes.
    pub time: Vec<f64>,
    /// Speed v0, in m/s.
    pub speed: Option<Vec<f64>>,
    /// Longitudinal creepage ξ, dimensionless.
    pub creepage_x: Option<Vec<f64>>,
    /// Lateral creepage η, dimensionless.
    pub creepage_y: Option<Vec<f64>>,
    /// Spin creepage φ, in 1/m.
    pub spin: Option<Vec<f64>>,
    /// Normal load, in N.
    pub load: Option<Vec<f64>>,
    /// Longitudinal force on the wheel F_x, in N, in place of ξ.
    pub force_x: Option<Vec<f64>>,
    /// Lateral force on the wheel F_y, in N, in place of η.
    pub force_y: Option<Vec<f64>>,
    /// Moment on the wheel M_z, in N m, in place of φ.
    pub moment_z: Option<Vec<f64>>,
}

impl History {
    /// Checks the tables, and that the wheel rolls at every time.
    pub fn check(&self, otherwise: &Kinematics) -> Result<(), Error> {
        if let Some([x, y]) = self.shift {
            require_finite(Quantity::ShiftX, x)?;
            require_finite(Quantity::ShiftY, y)?;
        }
        let count = self.time.len();
        let is_over_time = count > 0 || !self.is_constant();
        if count < 2 && is_over_time {
            return Err(Error::TooFew { quantity: Quantity::Time, fewest: 2, count });
        }
        for (k, time) in self.time.iter().enumerate() {
            require_at(Quantity::Time, Requirement::Finite, *time, Place::Index(k + 1))?;
        }
        if let Some(pair) = self.time.windows(2).find(|pair| pair[1] <= pair[0]) {
            let (quantity, before, after) = (Quantity::Time, pair[0], pair[1]);
            return Err(Error::NotAscending { quantity, axis: "", before, after });
        }
        for (quantity, table) in [
            (Quantity::HistorySpeed, &self.speed),
            (Quantity::HistoryCreepageX, &self.creepage_x),
            (Quantity::HistoryCreepageY, &self.creepage_y),
            (Quantity::HistorySpin, &self.spin),
            (Quantity::HistoryLoad, &self.load),
            (Quantity::HistoryForceX, &self.force_x),
            (Quantity::HistoryForceY, &self.force_y),
            (Quantity::HistoryMomentZ, &self.moment_z),
        ] {
            let length = table.as_ref().map_or(count, Vec::len);
            if length != count {
                return Err(Error::WrongCount { quantity, expected: count, count: length });
            }
        }
        for &time in &self.time {
            let in_history = |error| Error::AtTime { error: Box::new(error), time };
            self.kinematics(time, otherwise).check().map_err(in_history)?;
            if let Some(load) = self.load(time) {
                let place = Place::Time(time);
                require_at(Quantity::HistoryLoad, Requirement::Positive, load, place)?;
            }
        }
        Ok(())
    }

    /// Checks that no creepage over time has its force prescribed, here or in `otherwise`.
    pub fn check_forces(&self, otherwise: &PrescribedForces) -> Result<(), Error> {
        let x = self.force_x.as_ref().map(|_| Quantity::HistoryForceX);
        let y = self.force_y.as_ref().map(|_| Quantity::HistoryForceY);
        let moment_z = self.moment_z.as_ref().map(|_| Quantity::HistoryMomentZ);
        let x = x.or(otherwise.x.map(|force| force.given().0));
        let y = y.or(otherwise.y.map(|_| Quantity::ForceY));
        let moment_z = moment_z.or(otherwise.moment_z.map(|_| Quantity::MomentZ));
        for (force, creepage, table) in [
            (x, Quantity::HistoryCreepageX, &self.creepage_x),
            (y, Quantity::HistoryCreepageY, &self.creepage_y),
            (moment_z, Quantity::HistorySpin, &self.spin),
        ] {
            if let (Some(force), Some(_)) = (force, table) {
                return Err(ForceError::AndCreepage { force, creepage }.into());
            }
        }
        Ok(())
    }

    /// Whether the history is a shift without rolling.
    pub fn is_shift_only(&self) -> bool {
        self.shift.is_some() && self.time.is_empty()
    }

    /// Whether only the steady state ends it.
    pub fn is_endless(&self) -> bool {
        self.shift.is_none() && self.time.is_empty()
    }

    fn is_constant(&self) -> bool {
        let motion = [&self.speed, &self.creepage_x, &self.creepage_y, &self.spin, &self.load];
        let mut series = motion.into_iter().chain([&self.force_x, &self.force_y, &self.moment_z]);
        series.all(Option::is_none)
    }

    /// Speed and creepages at a time (in s).
    pub fn kinematics(&self, time: f64, otherwise: &Kinematics) -> Kinematics {
        let at = |table: &Option<Vec<f64>>, constant: f64| {
            table.as_ref().map_or(constant, |values| self.interpolate(values, time))
        };
        Kinematics {
            speed: at(&self.speed, otherwise.speed),
            creepage_x: at(&self.creepage_x, otherwise.creepage_x),
            creepage_y: at(&self.creepage_y, otherwise.creepage_y),
            spin: at(&self.spin, otherwise.spin),
        }
    }

    /// Time (in s) in which the wheel rolls a distance (in m), starting at a given time (in s).
    pub fn duration(&self, start: f64, distance: f64, otherwise: &Kinematics) -> f64 {
        let Some(speeds) = &self.speed else { return distance / otherwise.speed };
        let (mut from, mut left) = (start, distance);
        let mut speed = self.interpolate(speeds, start);
        for to in self.time[self.time.partition_point(|t| *t <= start)..].iter().copied() {
            let next = self.interpolate(speeds, to);
            let way = 0.5 * (to - from) * (speed + next);
            if way >= left {
                let acceleration = (next - speed) / (to - from);
                let at_end = (speed * speed + 2.0 * acceleration * left).max(0.0).sqrt();
                return from - start + 2.0 * left / (speed + at_end);
            }
            (from, left, speed) = (to, left - way, next);
        }
        from - start + left / speed
    }

    /// Means of speed and creepages between two times, in s.
    pub fn mean(&self, start: f64, end: f64, otherwise: &Kinematics) -> Kinematics {
        let over = |table: &Option<Vec<f64>>, constant: f64| {
            table
                .as_ref()
                .map_or(constant, |values| self.integral(values, start, end) / (end - start))
        };
        Kinematics {
            speed: over(&self.speed, otherwise.speed),
            creepage_x: over(&self.creepage_x, otherwise.creepage_x),
            creepage_y: over(&self.creepage_y, otherwise.creepage_y),
            spin: over(&self.spin, otherwise.spin),
        }
    }

    /// ∫ value dt, exact for values that are linear in between.
    fn integral(&self, values: &[f64], start: f64, end: f64) -> f64 {
        let first = self.time.partition_point(|t| *t <= start);
        let inside = self.time[first..].iter().copied().take_while(|t| *t < end);
        let (mut from, mut sum) = (start, 0.0);
        for to in inside.chain([end]) {
            sum += (to - from) * self.interpolate(values, 0.5 * (from + to));
            from = to;
        }
        sum
    }

    /// The same motion with the creepages at another point, which lies at `place` (x and y in m)
    /// from the present one.
    pub(crate) fn at(&self, place: [f64; 2], otherwise: &Kinematics) -> Self {
        let moved = |own: &Option<Vec<f64>>, component: fn(&Kinematics) -> f64| {
            // Both are linear between the times, and so is their combination.
            let there = |time: &f64| component(&self.kinematics(*time, otherwise).at(place));
            (own.is_some() || self.spin.is_some())
                .then(|| self.time.iter().map(there).collect::<Vec<f64>>())
        };
        Self {
            creepage_x: moved(&self.creepage_x, |kinematics| kinematics.creepage_x),
            creepage_y: moved(&self.creepage_y, |kinematics| kinematics.creepage_y),
            ..self.clone()
        }
    }

    /// Forces in place of creepages at a time (in s): those of the history, and the others of
    /// `otherwise`.
    pub(crate) fn prescribed(&self, time: f64, otherwise: &PrescribedForces) -> PrescribedForces {
        let at =
            |table: &Option<Vec<f64>>| table.as_ref().map(|values| self.interpolate(values, time));
        PrescribedForces {
            x: at(&self.force_x).map(LongitudinalForce::Force).or(otherwise.x),
            y: at(&self.force_y).or(otherwise.y),
            moment_z: at(&self.moment_z).or(otherwise.moment_z),
        }
    }

    /// Normal load (in N) at a time (in s), if it changes.
    pub fn load(&self, time: f64) -> Option<f64> {
        self.load.as_ref().map(|values| self.interpolate(values, time))
    }

    /// Largest normal load, in N, if it changes.
    pub fn largest_load(&self) -> Option<f64> {
        self.load.as_ref().and_then(|loads| loads.iter().copied().reduce(f64::max))
    }

    /// Largest speed, in m/s.
    pub fn fastest(&self, otherwise: &Kinematics) -> f64 {
        let speeds = self.speed.as_deref().unwrap_or(&[]);
        speeds.iter().copied().reduce(f64::max).unwrap_or(otherwise.speed)
    }

    /// First and last time, in s.
    pub fn span(&self) -> [f64; 2] {
        let first = self.time.first().copied().unwrap_or(0.0);
        [first, self.time.last().copied().unwrap_or(first)]
    }

    fn interpolate(&self, values: &[f64], time: f64) -> f64 {
        piecewise_linear(&self.time, values, time)[0]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const ROLLING: Kinematics =
        Kinematics { speed: 30.0, creepage_x: 0.0, creepage_y: 0.001, spin: 0.0 };

    /// A wheel that nearly stops rolls no farther in a step than elsewhere.
    #[test]
    fn a_step_covers_its_distance_however_the_speed_changes() {
        let history = History {
            time: vec![0.0, 1e-3, 2e-3, 3e-3],
            speed: Some(vec![30.0, 1e-3, 30.0, 30.0]),
            ..History::default()
        };
        let (distance, mut time, mut steps) = (6e-4, 0.0, 0);
        while time < 3e-3 {
            let duration = history.duration(time, distance, &ROLLING);
            let rolled = duration * history.mean(time, time + duration, &ROLLING).speed;
            assert_relative_eq!(rolled, distance, max_relative = 1e-9);
            time += duration;
            steps += 1;
        }
        // 15 mm while braking, and as much while it is driven; then 30 mm.
        assert!((100..=101).contains(&steps), "{steps}");
    }

    #[test]
    fn values_are_linear_in_between_and_constant_outside() {
        let history = History {
            time: vec![0.0, 1.0, 3.0],
            creepage_x: Some(vec![0.0, 0.002, 0.0]),
            ..History::default()
        };
        history.check(&ROLLING).unwrap();
        let at = |time| history.kinematics(time, &ROLLING);
        assert_eq!(at(-1.0).creepage_x, 0.0);
        assert_eq!(at(0.5).creepage_x, 0.001);
        assert_eq!(at(2.0).creepage_x, 0.001);
        assert_eq!(at(9.0).creepage_x, 0.0);
        assert_eq!(at(0.5).creepage_y, 0.001);
    }

    /// Means of a piecewise linear function are exact, also across kinks, and a step lasts as long
    /// as the wheel takes: v = 30 + 10 t for one second covers 35 m.
    #[test]
    fn means_are_exact_and_steps_take_their_time() {
        let history = History {
            time: vec![0.0, 1.0, 3.0],
            speed: Some(vec![30.0, 40.0, 40.0]),
            creepage_x: Some(vec![0.0, 0.002, 0.0]),
            ..History::default()
        };
        let mean = history.mean(0.5, 2.0, &ROLLING);
        // ∫ = ½ (0.001 + 0.002) 0.5 + ½ (0.002 + 0.001) 1
        assert_relative_eq!(mean.creepage_x, 0.00225 / 1.5, max_relative = 1e-14);
        assert_relative_eq!(history.duration(0.0, 35.0, &ROLLING), 1.0, max_relative = 1e-3);
        assert_relative_eq!(history.duration(2.0, 0.04, &ROLLING), 1e-3, max_relative = 1e-14);
    }

    /// A shift alone needs no times, but changes over time do.
    #[test]
    fn a_shift_needs_no_times() {
        let shift = History { shift: Some([1e-5, 0.0]), ..History::default() };
        shift.check(&ROLLING).unwrap();
        assert!(shift.is_shift_only());
        let changing = History { load: Some(vec![]), ..shift.clone() };
        assert!(
            changing
                .check(&ROLLING)
                .unwrap_err()
                .to_string()
                .contains("time needs at least 2 entries, got 0")
        );
        let endless = History { shift: Some([0.0, f64::NAN]), ..History::default() };
        assert!(endless.check(&ROLLING).unwrap_err().to_string().contains("shift_y"));
    }

    /// At every time, also between those of the table, the motion is that of the same rigid body.
    #[test]
    fn the_reference_point_does_not_change_the_motion() {
        let spins = [None, Some(vec![0.1, -0.4, 0.9])];
        for (creepage_x, spin) in [None, Some(vec![0.0, 0.002, 0.0])]
            .into_iter()
            .flat_map(|x| spins.clone().map(|s| (x.clone(), s)))
        {
            let history =
                History { time: vec![0.0, 1.0, 3.0], creepage_x, spin, ..History::default() };
            let turning = Kinematics { spin: 0.3, ..ROLLING };
            let place = [2e-3, -7e-3];
            let moved = history.at(place, &turning);
            for time in [-1.0, 0.0, 0.3, 1.0, 2.2, 5.0] {
                let expected = history.kinematics(time, &turning).at(place);
                let found = moved.kinematics(time, &turning.at(place));
                assert!((found.creepage_x - expected.creepage_x).abs() < 1e-15);
                assert!((found.creepage_y - expected.creepage_y).abs() < 1e-15);
                assert_eq!(found.spin, expected.spin);
            }
        }
    }

    #[test]
    fn what_is_no_history_is_refused() {
        let refuse = |history: History| history.check(&ROLLING).unwrap_err().to_string();
        let times = vec![0.0, 1.0];
        let once = History { time: vec![0.0], ..History::default() };
        assert!(refuse(once).contains("time needs at least 2 entries, got 1"));
        let backwards = History { time: vec![1.0, 1.0], ..History::default() };
        assert!(refuse(backwards).contains("ascend strictly"));
        let short = History { time: times.clone(), spin: Some(vec![0.0]), ..History::default() };
        assert!(refuse(short).contains("spin_history needs 2 values, got 1"));
        let locked =
            History { time: times, creepage_x: Some(vec![0.0, 2.0]), ..History::default() };
        let message = refuse(locked);
        assert!(
            message.contains("at 1 s, creepage_x_history must be below")
                && message.contains("reversed")
        );
    }
}
