//! Shifts and transient rolling of module 1: a history of the wheelset.

use crate::FieldPath;
use crate::import::contact::control::Control;
use crate::import::contact::given::Given;
use crate::import::contact::input::{InputCase, Module};
use crate::import::contact::wheel_rail::WheelRail;

use super::case::Translation;
use super::sequence::{self, Job};

/// Writes the history of a job, whose first case is written.
pub fn write(case: &mut Translation, job: &Job) {
    if !sequence::is_step(job.first) {
        return;
    }
    let Module::WheelRail(first) = &job.first.module else { return };
    let mut rows: Vec<Row> = Vec::new();
    for step in job.states() {
        let Module::WheelRail(of) = &step.module else { continue };
        if let Some(digit) = changed((job.first, first), of, step) {
            let what = "a change within a sequence of steps is not available";
            return case.refuse(
                digit,
                what,
                "only position and velocity of the wheelset may change",
            );
        }
        if step.control.previous.is(3) {
            let what = "a step that is repeated (P = 3) is not available in a history";
            return case.refuse(step.control.previous, what, "P = 0 is a new step");
        }
        let Some(row) = Row::of(&step.control, of, rows.first()) else { return };
        if rows.is_empty() && job.steady().is_none() {
            rows.push(Row { duration: 0.0, ..row });
        }
        rows.push(row);
    }
    job.write_start(case);
    if rows.iter().skip(1).any(|row| row.duration == 0.0) {
        case.document.quantity(field!("history.shift_duration"), 1.0, "s");
    } else {
        rows = with_jumps(&rows);
    }
    write_rows(case, &rows, &job.first.control);
}

/// The rows with changes of the velocities between steps, of which each has its own throughout: at
/// rest, without a shift.
fn with_jumps(steps: &[Row]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for row in steps {
        let before = rows.last().filter(|before| before.velocities() != row.velocities());
        rows.extend(before.map(|before| Row { duration: 0.0, position: before.position, ..*row }));
        rows.push(*row);
    }
    rows
}

/// What a step ends with.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// In s; nothing where the wheel does not roll.
    duration: f64,
    /// As in the file.
    position: [Given; 6],
    velocity: [Given; 6],
    /// What makes the latter one in a second.
    rate: f64,
    is_steady: bool,
}

impl Row {
    /// A shift in which the wheel goes on along the rail by half an element or more is rolling, of
    /// a second, or at the speed of the steady rolling before; the first one is not.
    fn of(control: &Control, of: &WheelRail, first: Option<&Self>) -> Option<Self> {
        let (position, velocity, search) = (of.position?, of.velocity?, of.search.as_ref()?);
        let (element, [way, ..]) = (search.element[0].value, velocity);
        let steady = first.filter(|first| first.is_steady);
        let mut row = Self {
            duration: 0.0,
            position,
            velocity,
            rate: 1.0,
            is_steady: control.tangential.is(3),
        };
        if control.tangential.is(2) {
            row.duration = search.step.value * element / way.value;
        } else if control.tangential.is(1) && first.is_some() && way.value >= 0.5 * element {
            row.duration = steady.map_or(1.0, |steady| way.value / steady.velocity[0].value);
            row.rate = row.duration.recip();
        }
        Some(row)
    }

    /// As in the file, in a second.
    fn velocities(&self) -> [f64; 6] {
        self.velocity.map(|velocity| self.rate * velocity.value)
    }
}

/// A column: the place of its value, the factor and the unit that make it of one.
type Column = (FieldPath, usize, f64, &'static str);

/// Of positions but the third, which is a height or a force; y to the right, z downwards there.
const POSITIONS: [Column; 3] = [
    (field!("history.lateral_position"), 1, -1.0, "mm"),
    (field!("history.roll_angle"), 3, 1e3, "mrad"),
    (field!("history.yaw_angle"), 4, -1e3, "mrad"),
];
const HEIGHT: Column = (field!("history.height"), 2, -1.0, "mm");
const LOAD: Column = (field!("history.load"), 2, 1e-3, "kN");
const VELOCITIES: [Column; 6] = [
    (field!("history.speed"), 0, 1e-3, "m/s"),
    (field!("history.lateral_velocity"), 1, -1.0, "mm/s"),
    (field!("history.vertical_velocity"), 2, -1.0, "mm/s"),
    (field!("history.roll_rate"), 3, 1.0, "rad/s"),
    (field!("history.yaw_rate"), 4, -1.0, "rad/s"),
    (ANGULAR_VELOCITY, 5, -1.0, "rad/s"),
];
const ANGULAR_VELOCITY: FieldPath = field!("history.angular_velocity");

fn write_rows(case: &mut Translation, rows: &[Row], control: &Control) {
    let mut time = 0.0;
    let times: Vec<f64> = rows
        .iter()
        .map(|row| {
            time += row.duration;
            time
        })
        .collect();
    case.document.quantities(field!("history.time"), &times, "s");
    let support = if control.normal.is(0) { HEIGHT } else { LOAD };
    let positions = POSITIONS.into_iter().chain([support]).map(|column| (column, false));
    for ((path, place, factor, unit), is_velocity) in
        positions.chain(VELOCITIES.map(|column| (column, true)))
    {
        let of = |row: &Row| {
            if is_velocity { row.velocities()[place] } else { row.position[place].value }
        };
        let values: Vec<f64> = rows.iter().map(|row| factor * of(row)).collect();
        if sequence::changes(&values) || path == ANGULAR_VELOCITY {
            case.document.quantities(path, &values, unit);
        }
    }
}

/// The digit of what a step has other than the first one, though it may not.
fn changed(
    (begin, first): (&InputCase, &WheelRail),
    of: &WheelRail,
    step: &InputCase,
) -> Option<Given> {
    let (one, other) = (&begin.control, &step.control);
    [
        (first.friction == of.friction, other.friction_law),
        (first.elastic == of.elastic, other.influence),
        (first.heat == of.heat, other.heat),
        (first.search == of.search, other.grid),
        (first.track == of.track && first.rail == of.rail, other.distance),
        (first.rail_deviation == of.rail_deviation, other.distance),
        (first.wheelset == of.wheelset && first.wheel == of.wheel, other.extra),
        (first.wheel_deviation == of.wheel_deviation, other.extra),
        (one.force == other.force, other.force),
        (one.normal == other.normal, other.normal),
    ]
    .into_iter()
    .find_map(|(is_same, digit)| (!is_same).then_some(digit))
}
