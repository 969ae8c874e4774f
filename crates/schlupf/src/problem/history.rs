//! Creepages, speed and load over time: transient rolling, and shifts at rest before, between and
//! after it.

use std::ops::Range;

use crate::bodies::Kinematics;
use crate::numerics::interpolation::piecewise_linear;
use crate::problem::{LongitudinalForce, PrescribedForces};
use crate::reporting::{Error, ForceError, Place, Quantity, Requirement, require_at};

/// Quantities over time, linear between the times and constant outside. `None` means constant.
///
/// Where a time is that of the row before it, the bodies do not roll from one row to the next: in
/// one step everything changes at rest, and the wheel is shifted over the rail. A history with
/// shifts begins with one, from bodies apart, unless it starts rolling. What follows a shift begins
/// at the end of the time step that reaches it.
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
    /// Times, ascending, in s; empty if nothing changes.
    pub time: Vec<f64>,
    /// Whether the first row is a state of steady rolling, not one without tangential tractions.
    pub starts_rolling: bool,
    /// Shift of the wheel over the rail along rolling, on the way to each row, in m.
    pub shift_x: Option<Vec<f64>>,
    /// The same across rolling, in m.
    pub shift_y: Option<Vec<f64>>,
    /// Turn of the wheel over the rail about the reference point, likewise, in rad.
    pub turn: Option<Vec<f64>>,
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
    /// Longitudinal force on the wheel F_x, in N, in place of ξ and of the shift.
    pub force_x: Option<Vec<f64>>,
    /// Lateral force on the wheel F_y, in N, in place of η and of the shift.
    pub force_y: Option<Vec<f64>>,
    /// Moment on the wheel M_z, in N m, in place of φ and of the turn.
    pub moment_z: Option<Vec<f64>>,
}

/// A shift: x and y in m, and the turn in rad, as creepages over one metre.
pub(crate) type Shift = Kinematics;

/// A part of a history in which the wheel rolls throughout, with the shift before it, if any.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stretch {
    /// At the first time of the rest.
    pub shift: Option<Shift>,
    /// Its times ascend strictly.
    pub rolling: History,
}

impl History {
    /// Checks the tables, and that the wheel rolls at every time.
    pub fn check(&self, otherwise: &Kinematics) -> Result<(), Error> {
        let count = self.time.len();
        let fewest = if self.has_shifts() || self.starts_rolling { 1 } else { 2 };
        let is_over_time = count > 0
            || self.starts_rolling
            || self.tables().iter().any(|(_, table)| table.is_some());
        if count < fewest && is_over_time {
            return Err(Error::TooFew { quantity: Quantity::Time, fewest, count });
        }
        for (k, time) in self.time.iter().enumerate() {
            require_at(Quantity::Time, Requirement::Finite, *time, Place::Index(k + 1))?;
        }
        if let Some(pair) = self.time.windows(2).find(|pair| pair[1] < pair[0]) {
            let (quantity, before, after) = (Quantity::Time, pair[0], pair[1]);
            return Err(Error::NotAscending { quantity, axis: "", before, after });
        }
        for (quantity, table) in self.tables() {
            let length = table.as_ref().map_or(count, Vec::len);
            if length != count {
                return Err(Error::WrongCount { quantity, expected: count, count: length });
            }
        }
        for row in 0..count {
            self.check_row(row, otherwise)?;
        }
        Ok(())
    }

    fn check_row(&self, row: usize, otherwise: &Kinematics) -> Result<(), Error> {
        let time = self.time[row];
        let in_history = |error| Error::AtTime { error: Box::new(error), time };
        self.in_row(row, otherwise).check().map_err(in_history)?;
        for (quantity, table) in self.shifts() {
            let Some(shift) = table.as_ref().map(|shifts| shifts[row]) else { continue };
            require_at(quantity, Requirement::Magnitude(1.0), shift, Place::Time(time))?;
            if shift != 0.0 && !self.is_at_rest(row) {
                return Err(Error::ShiftInRolling { quantity, time });
            }
        }
        if let Some(load) = self.load.as_ref().map(|loads| loads[row]) {
            require_at(Quantity::HistoryLoad, Requirement::Positive, load, Place::Time(time))?;
        }
        Ok(())
    }

    fn shifts(&self) -> [(Quantity, &Option<Vec<f64>>); 3] {
        [
            (Quantity::HistoryShiftX, &self.shift_x),
            (Quantity::HistoryShiftY, &self.shift_y),
            (Quantity::HistoryTurn, &self.turn),
        ]
    }

    fn tables(&self) -> Vec<(Quantity, &Option<Vec<f64>>)> {
        let over_time = [
            (Quantity::HistorySpeed, &self.speed),
            (Quantity::HistoryCreepageX, &self.creepage_x),
            (Quantity::HistoryCreepageY, &self.creepage_y),
            (Quantity::HistorySpin, &self.spin),
            (Quantity::HistoryLoad, &self.load),
            (Quantity::HistoryForceX, &self.force_x),
            (Quantity::HistoryForceY, &self.force_y),
            (Quantity::HistoryMomentZ, &self.moment_z),
        ];
        over_time.into_iter().chain(self.shifts()).collect()
    }

    /// Whether a row is reached at rest.
    fn is_at_rest(&self, row: usize) -> bool {
        match row.checked_sub(1) {
            Some(before) => self.time[row] == self.time[before],
            None => self.has_shifts() && !self.starts_rolling,
        }
    }

    fn has_shifts(&self) -> bool {
        self.shifts().iter().any(|(_, table)| table.is_some())
    }

    /// The parts in which the wheel rolls throughout; at least one.
    pub(crate) fn stretches(&self) -> Vec<Stretch> {
        let count = self.time.len();
        let mut starts: Vec<usize> = (1..count).filter(|row| self.is_at_rest(*row)).collect();
        starts.insert(0, 0);
        let ends = starts[1..].iter().copied().chain([count]);
        let stretch = |(start, end): (usize, usize)| {
            let is_shifted = count > 0 && self.is_at_rest(start);
            let shift = is_shifted.then(|| self.shift_to(start));
            Stretch { shift, rolling: self.rows(start..end) }
        };
        starts.iter().copied().zip(ends).map(stretch).collect()
    }

    /// Shift and turn on the way to a row.
    fn shift_to(&self, row: usize) -> Shift {
        let [creepage_x, creepage_y, spin] =
            self.shifts().map(|(_, table)| table.as_ref().map_or(0.0, |values| values[row]));
        Shift { creepage_x, creepage_y, spin, ..Shift::free_rolling(1.0) }
    }

    /// Some rows, without shifts.
    pub(crate) fn rows(&self, rows: Range<usize>) -> Self {
        let of = |table: &Option<Vec<f64>>| table.as_ref().map(|all| all[rows.clone()].to_vec());
        Self {
            time: self.time[rows.clone()].to_vec(),
            starts_rolling: self.starts_rolling && rows.start == 0,
            shift_x: None,
            shift_y: None,
            turn: None,
            speed: of(&self.speed),
            creepage_x: of(&self.creepage_x),
            creepage_y: of(&self.creepage_y),
            spin: of(&self.spin),
            load: of(&self.load),
            force_x: of(&self.force_x),
            force_y: of(&self.force_y),
            moment_z: of(&self.moment_z),
        }
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
            (x, Quantity::HistoryShiftX, &self.shift_x),
            (y, Quantity::HistoryCreepageY, &self.creepage_y),
            (y, Quantity::HistoryShiftY, &self.shift_y),
            (moment_z, Quantity::HistorySpin, &self.spin),
            (moment_z, Quantity::HistoryTurn, &self.turn),
        ] {
            if let (Some(force), Some(_)) = (force, table) {
                return Err(ForceError::AndCreepage { force, creepage }.into());
            }
        }
        Ok(())
    }

    /// Whether nothing happens but shifts.
    pub fn is_at_rest_throughout(&self) -> bool {
        !self.is_endless() && (0..self.time.len()).all(|row| self.is_at_rest(row))
    }

    /// Whether only the steady state ends it.
    pub fn is_endless(&self) -> bool {
        self.time.is_empty()
    }

    /// Speed and creepages of a row.
    fn in_row(&self, row: usize, otherwise: &Kinematics) -> Kinematics {
        self.rows(row..row + 1).kinematics(self.time[row], otherwise)
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
            reference_speed: otherwise.reference_speed,
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
            reference_speed: otherwise.reference_speed,
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
        let rows = || 0..self.time.len();
        let turns = self.spin.is_some();
        let moved = |own: &Option<Vec<f64>>, component: fn(&Kinematics) -> f64| {
            // Both are linear between the times, and so is their combination.
            let there = |row: usize| component(&self.in_row(row, otherwise).at(place));
            (own.is_some() || turns).then(|| rows().map(there).collect::<Vec<f64>>())
        };
        let shifted = |own: &Option<Vec<f64>>, component: fn(&Kinematics) -> f64| {
            let there = |row: usize| component(&self.shift_to(row).at(place));
            (own.is_some() || self.turn.is_some()).then(|| rows().map(there).collect::<Vec<f64>>())
        };
        Self {
            creepage_x: moved(&self.creepage_x, |kinematics| kinematics.creepage_x),
            creepage_y: moved(&self.creepage_y, |kinematics| kinematics.creepage_y),
            shift_x: shifted(&self.shift_x, |shift| shift.creepage_x),
            shift_y: shifted(&self.shift_y, |shift| shift.creepage_y),
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

/// Of a part of a history (its first and last time, in s) without a step over a cell, which takes a
/// time (in s), of so many cells along rolling.
pub(crate) fn part_too_short(span: [f64; 2], (step, cells): (f64, usize)) -> Error {
    let cells = (cells as f64 * step / (span[1] - span[0])).ceil() as usize;
    Error::PartTooShort { span, step, cells }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    const ROLLING: Kinematics = Kinematics { creepage_y: 0.001, ..Kinematics::free_rolling(30.0) };

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

    /// Rolling for 2 s, two shifts, rolling for 1 s, a shift.
    #[test]
    fn shifts_divide_a_history() {
        let history = History {
            time: vec![0.0, 2.0, 2.0, 2.0, 3.0, 3.0],
            load: Some(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]),
            ..History::default()
        };
        history.check(&ROLLING).unwrap();
        let loads = |history: &History| {
            let of = |stretch: Stretch| (stretch.shift.is_some(), stretch.rolling.load.unwrap());
            history.stretches().into_iter().map(of).collect::<Vec<_>>()
        };
        let later = [(true, vec![3.0]), (true, vec![4.0, 5.0]), (true, vec![6.0])];
        let mut expected = vec![(false, vec![1.0, 2.0])];
        expected.extend(later);
        assert_eq!(loads(&history), expected);
        // Shifts begin at once.
        let shifts = Some(vec![1e-3, 0.0, 2e-3, 0.0, 0.0, 3e-3]);
        let shifted = History { shift_y: shifts, ..history.clone() };
        shifted.check(&ROLLING).unwrap();
        expected[0].0 = true;
        assert_eq!(loads(&shifted), expected);
        assert_eq!(shifted.stretches()[1].shift.unwrap().creepage_y, 2e-3);
        assert!(!shifted.is_at_rest_throughout() && !shifted.rows(1..2).is_at_rest_throughout());
        let turning = History { turn: Some(vec![0.0, 1e-3, 0.0, 0.0, 0.0, 0.0]), ..history };
        let message = turning.check(&ROLLING).unwrap_err().to_string();
        assert!(message.contains("the wheel rolls until 2 s"), "{message}");
    }

    /// One shift needs one time.
    #[test]
    fn a_shift_is_a_history() {
        let of = |shift: f64| History {
            time: vec![0.0],
            shift_y: Some(vec![shift]),
            ..History::default()
        };
        of(1e-5).check(&ROLLING).unwrap();
        assert!(of(1e-5).is_at_rest_throughout());
        assert!(of(f64::NAN).check(&ROLLING).unwrap_err().to_string().contains("shift_y"));
        let none = History { time: vec![], shift_y: Some(vec![]), ..History::default() };
        let message = none.check(&ROLLING).unwrap_err().to_string();
        assert!(message.contains("time needs at least 1 entry, got 0"), "{message}");
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
        let backwards = History { time: vec![1.0, 0.5], ..History::default() };
        assert!(refuse(backwards).contains("ascend, but"));
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
