//! Which cases belong together: the steps of transient rolling and of shifts are cases of CONTACT,
//! and one case with a history here.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::Source;

use crate::import::contact::basic::{Basic, Motion};
use crate::import::contact::control::Control;
use crate::import::contact::given::Given;
use crate::import::contact::input::{Element, InputCase, Module};

use super::basic;
use super::case::Translation;
use super::contact::Contact;
use super::frame::WheelBody;

/// What becomes one case file.
#[derive(Debug)]
pub struct Job<'a> {
    /// The first of its cases, or the only one.
    pub first: &'a InputCase,
    /// The other steps of transient rolling and shifts.
    pub steps: Vec<&'a InputCase>,
    /// What the first step goes on from, if that is no step itself.
    pub before: Option<&'a InputCase>,
}

/// The case files of all cases, in the order of their first cases.
pub fn jobs(cases: &[InputCase]) -> Vec<Job<'_>> {
    let mut jobs: Vec<Job> = Vec::new();
    // The last case of every element with its job.
    let mut last: BTreeMap<(i64, Element), (&InputCase, usize)> = BTreeMap::new();
    for case in cases.iter().filter(|case| !case.is_skipped) {
        let module = case.module.number();
        let before = last.get(&(module, case.element)).copied();
        let goes_on = is_step(case) && case.control.previous.is(0);
        let place = match before {
            Some((before, place)) if goes_on && is_step(before) => {
                jobs[place].steps.push(case);
                place
            }
            _ => {
                let before = before.map(|(before, _)| before).filter(|_| goes_on);
                jobs.push(Job { first: case, steps: Vec::new(), before });
                jobs.len() - 1
            }
        };
        last.insert((module, case.element), (case, place));
    }
    jobs
}

/// Whether a case is a shift or a step of transient rolling.
pub fn is_step(case: &InputCase) -> bool {
    matches!(case.control.tangential.whole(), 1 | 2)
}

/// Translates a history.
pub fn translate(source: &Arc<Source>, job: &Job, wheel: WheelBody, stem: &str) -> Translation {
    let mut case = Translation::new(source);
    let Some((largest, of)) = job.largest() else { return case };
    let Some(written) = basic::write(&mut case, (&largest.control, of), wheel, stem) else {
        return case;
    };
    if largest.control.is_rolling()
        && let Some(motion) = &of.motion
    {
        let forces = basic::forces_at(&largest.control, of, written);
        basic::creepages(&mut case, &largest.control, motion, (written, forces));
    }
    if let Some(series) = job.series(&mut case, (of, written), (wheel, stem)) {
        series.write(&mut case);
        job.write_start(&mut case);
    }
    case
}

/// What a step ends with.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// Duration in ms, none at all before steady rolling; nothing in a shift.
    duration: Option<f64>,
    /// Creepages, or a shift in mm, where no forces are given.
    tangential: [f64; 2],
    /// In 1/m, or of a shift in rad.
    spin: f64,
    /// In kN.
    forces: basic::Forces,
    /// In m/s.
    speed: f64,
    /// In kN.
    load: f64,
}

impl Row {
    /// Whether both roll, and the motion of the other one is not this one.
    fn jumps_to(&self, next: &Self) -> bool {
        let motion = |row: &Self| (row.tangential, row.spin, row.speed);
        self.duration.is_some() && next.duration.is_some() && motion(self) != motion(next)
    }
}

/// Values at the end of every step.
struct Series(Vec<Row>);

impl Job<'_> {
    /// All of its cases.
    pub fn all(&self) -> impl Iterator<Item = &InputCase> {
        std::iter::once(self.first).chain(self.steps.iter().copied())
    }

    /// The steady rolling that its first step goes on from.
    pub fn steady(&self) -> Option<&InputCase> {
        self.before.filter(|before| before.control.tangential.is(3))
    }

    /// The steady rolling before, and all of its cases.
    pub fn states(&self) -> impl Iterator<Item = &InputCase> {
        self.steady().into_iter().chain(self.all())
    }

    /// Writes what the history starts with.
    pub fn write_start(&self, case: &mut Translation) {
        if self.steady().is_some() {
            case.document.text(field!("history.start"), "steady");
        }
    }

    /// Whether it becomes a history.
    pub fn is_history(&self) -> bool {
        let rolls = self.first.control.tangential.is(2);
        is_step(self.first) && (rolls || !self.steps.is_empty() || self.before.is_some())
    }

    /// The step with the largest load, of those that roll if any do.
    fn largest(&self) -> Option<(&InputCase, &Basic)> {
        let rolls = self.states().any(|step| step.control.is_rolling());
        let steps = self.states().filter(|step| !rolls || step.control.is_rolling());
        let loaded = steps.filter_map(|step| match &step.module {
            Module::Basic(of) => Some((step, of, of.motion?.normal.value)),
            Module::WheelRail(_) => None,
        });
        // The first of equal ones.
        let larger = |(_, _, one): &(_, _, f64), (_, _, other): &(_, _, f64)| one.total_cmp(other);
        let all: Vec<_> = loaded.collect();
        all.into_iter().rev().max_by(larger).map(|(step, of, _)| (step, &**of))
    }

    /// The series of a job, of which one step is written.
    fn series(
        &self,
        case: &mut Translation,
        (base, written): (&Basic, basic::Written),
        (wheel, stem): (WheelBody, &str),
    ) -> Option<Series> {
        let mut rows = Vec::new();
        for step in self.states() {
            let Module::Basic(of) = &step.module else { continue };
            if let Some(changed) = changed((self.first, base), of, step) {
                let what = "a change within a sequence of steps is not available";
                let may = "only load, creepages, shifts or forces, spin, speed and step may change";
                case.refuse(changed, what, may);
                return None;
            }
            let motion = of.motion.as_ref()?;
            let control = &step.control;
            if control.normal.is(1) && motion.normal.value <= 0.0 {
                case.refuse(motion.normal, "FN must be positive", "");
                return None;
            }
            let written = if control.normal.is(1) {
                let contact = Contact { load: motion.normal.value, ..written.contact };
                basic::Written { contact, ..written }
            } else {
                let mut own = Translation::new(case.source());
                let written = basic::write(&mut own, (control, of), wheel, stem);
                case.errors.extend(own.errors);
                written?
            };
            rows.push(row(case, (control, of), motion, written)?);
        }
        Some(Series(rows))
    }
}

fn row(
    case: &mut Translation,
    (control, of): (&Control, &Basic),
    motion: &Motion,
    written: basic::Written,
) -> Option<Row> {
    let forces = basic::forces_at(control, of, written);
    let [x, y] = basic::creepages_at(motion, written);
    // Those in place of which a force is given count for nothing.
    let tangential = [0, 1].map(|k| if forces[k].is_some() { 0.0 } else { [x, y][k] });
    let mut row = Row {
        duration: None,
        tangential,
        spin: motion.spin.value,
        forces,
        speed: 0.0,
        load: written.contact.load / 1e3,
    };
    if control.tangential.is(1) {
        basic::check_shift(case, control, motion);
        return Some(row);
    }
    if control.previous.is(3) {
        let what = "a step that is repeated (P = 3) is not available in transient rolling";
        case.refuse(control.previous, what, "P = 0 is a new step");
    }
    let rolling = of.rolling?;
    let step = if control.tangential.is(3) { 0.0 } else { rolling.step.value };
    row.duration = Some(1e3 * step / rolling.speed.value);
    row.spin *= 1e3;
    row.speed = rolling.speed.value / 1e3;
    Some(row)
}

impl Series {
    /// Times, shifts, and what changes over the times.
    fn write(&self, case: &mut Translation) {
        let Self(steps) = self;
        let rolls = steps.iter().any(|step| step.duration.is_some());
        // Rolling begins with the values of its first step, or with the steady state.
        let start = steps.first().filter(|first| first.duration.is_some_and(|time| time > 0.0));
        let start = start.map(|first| Row { duration: Some(0.0), ..*first });
        let rows = with_jumps(start.into_iter().chain(steps.iter().copied()));
        if steps.iter().any(|step| step.duration.is_none()) {
            write_shifts(case, &rows);
        }
        if rolls {
            write_times(case, &rows);
            write_motions(case, &rows);
        }
        let [force_x, force_y] =
            [0, 1].map(|k| rows.iter().filter_map(|row| row.forces[k]).collect::<Vec<f64>>());
        for (values, [constant, over_time]) in [
            (force_x, fields!["kinematics.force_x", "history.force_x"]),
            (force_y, fields!["kinematics.force_y", "history.force_y"]),
        ] {
            if changes(&values) {
                case.document.quantities(over_time, &values, "kN");
            } else if let Some(force) = values.first() {
                case.document.quantity(constant, *force, "kN");
            }
        }
        let load: Vec<f64> = rows.iter().map(|row| row.load).collect();
        if changes(&load) {
            case.document.quantities(field!("history.load"), &load, "kN");
        }
    }
}

/// The rows with the changes of motion between steps that roll, of which each has one motion
/// throughout: at rest, and without a shift.
fn with_jumps(steps: impl Iterator<Item = Row>) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for row in steps {
        let before = rows.last().filter(|before| before.jumps_to(&row));
        let jump =
            before.map(|before| Row { duration: None, tangential: [0.0; 2], spin: 0.0, ..*before });
        rows.extend(jump);
        rows.push(row);
    }
    rows
}

/// Shifts, one for each row.
fn write_shifts(case: &mut Translation, rows: &[Row]) {
    let shifts = |value: fn(&Row) -> f64| {
        let of = |row: &Row| if row.duration.is_none() { value(row) } else { 0.0 };
        rows.iter().map(of).collect::<Vec<f64>>()
    };
    let [has_x, has_y] = [0, 1].map(|k| rows.iter().all(|row| row.forces[k].is_none()));
    let document = &mut case.document;
    if has_x {
        document.quantities(field!("history.shifts_x"), &shifts(|row| row.tangential[0]), "mm");
    }
    if has_y {
        document.quantities(field!("history.shifts_y"), &shifts(|row| row.tangential[1]), "mm");
    }
    let turns = shifts(|row| row.spin);
    if turns.iter().any(|turn| *turn != 0.0) || !has_x && !has_y {
        document.quantities(field!("history.turns"), &turns, "rad");
    }
}

pub fn changes(values: &[f64]) -> bool {
    values.windows(2).any(|pair| pair[0] != pair[1])
}

fn write_times(case: &mut Translation, rows: &[Row]) {
    let mut time = 0.0;
    let times: Vec<f64> = rows
        .iter()
        .map(|row| {
            time += row.duration.unwrap_or(0.0);
            time
        })
        .collect();
    case.document.quantities(field!("history.time"), &times, "ms");
}

/// What changes of the rolling motion. In a shift it is that of the next step, with which the wheel
/// begins to roll.
fn write_motions(case: &mut Translation, rows: &[Row]) {
    let of = |value: fn(&Row) -> f64| {
        let rolling = |row: &&Row| row.duration.is_some();
        let at = |k: usize| {
            let next = rows[k..].iter().find(rolling);
            next.or(rows[..k].iter().rev().find(rolling)).map_or(0.0, value)
        };
        (0..rows.len()).map(at).collect::<Vec<f64>>()
    };
    let document = &mut case.document;
    let [x, y] = [of(|row| row.tangential[0]), of(|row| row.tangential[1])];
    if changes(&x) {
        document.numbers(field!("history.creepage_x"), &x);
    }
    if changes(&y) {
        document.numbers(field!("history.creepage_y"), &y);
    }
    let (spin, speed) = (of(|row| row.spin), of(|row| row.speed));
    if changes(&spin) {
        document.quantities(field!("history.spin"), &spin, "1/m");
    }
    if changes(&speed) {
        document.quantities(field!("history.speed"), &speed, "m/s");
    }
}

/// The digit of what a step has other than the first one, though it may not.
fn changed((begin, first): (&InputCase, &Basic), of: &Basic, step: &InputCase) -> Option<Given> {
    let rolls = step.control.is_rolling();
    let direction = |of: &Basic| of.rolling.map(|rolling| rolling.direction);
    [
        (first.friction == of.friction, step.control.friction_law),
        (first.elastic == of.elastic, step.control.influence),
        (!rolls || direction(first) == direction(of), step.control.influence),
        (first.heat == of.heat, step.control.heat),
        (first.area == of.area, step.control.grid),
        (first.distance == of.distance, step.control.distance),
        (begin.control.force.whole() == step.control.force.whole(), step.control.force),
    ]
    .into_iter()
    .find_map(|(is_same, digit)| (!is_same).then_some(digit))
}
