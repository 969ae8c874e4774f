//! A comparison as text: one table.

use schlupf::bodies::ReferencePoint;

use super::{Answer, Comparison};
use crate::output::number::significant as number;
use crate::output::summary::{Summary, line, moment, without_noise};

/// Heading of a column, and getter of its number.
type Column = (&'static str, fn(&Answer) -> Option<f64>);

const COLUMNS: [Column; 7] = [
    ("Fx (kN)", |a| Some(without_noise(a.solution.force.x, a.solution.normalised.x) / 1e3)),
    ("Fy (kN)", |a| Some(without_noise(a.solution.force.y, a.solution.normalised.y) / 1e3)),
    ("Mz (N m)", |a| moment(&a.solution.force, &a.solution.normalised)),
    ("|F|/N", |a| Some(a.solution.traction_coefficient)),
    ("rise (K)", |a| Some(a.solution.temperature?.max_rise)),
    ("time (ms)", |a| Some(a.time * 1e3)),
    ("again (ms)", |a| Some(a.time_again * 1e3)),
];

/// Where not all have the same normal contact.
const PRESSURE: Column = ("p0 (MPa)", |a| Some(a.solution.normal.peak_pressure / 1e6));

/// Width of the names, in characters.
const NAMES: usize = 27;

/// All methods as text: forces on the wheel, the largest temperature rise, and times.
pub(super) fn text(comparison: &Comparison) -> Summary {
    let mut text = Summary::titled(&comparison.title);
    text.blank();
    if let Some(answer) = comparison.answers().next() {
        conditions(&mut text, answer);
    }
    let pressure = comparison.has_normal_methods().then_some(PRESSURE);
    let columns: Vec<Column> = COLUMNS.into_iter().chain(pressure).collect();
    let headings = columns.iter().map(|(heading, _)| (*heading).to_owned());
    row(&mut text, "on the wheel", headings, "");
    for entry in &comparison.entries {
        let answer = match &entry.answer {
            Ok(answer) => answer,
            Err(reason) => {
                line(&mut text, &format!("{:<NAMES$}  not available: {reason}", entry.name));
                continue;
            }
        };
        let remark = if entry.is_unconverged() { "  NOT CONVERGED" } else { "" };
        let shown = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), number);
        row(&mut text, entry.name, columns.iter().map(|(_, value)| shown(value(answer))), remark);
    }
    let note = "time: with set-up; again: the forces alone, with the set-up done; –: not given";
    line(&mut text, note);
    text
}

fn conditions(text: &mut Summary, answer: &Answer) {
    let (motion, normal) = (&answer.solution.kinematics, &answer.solution.normal);
    let mut parts = vec![
        format!("load {} kN", number(normal.load / 1e3)),
        format!(
            "semi-axes {} x {} mm",
            number(normal.semi_axis_x * 1e3),
            number(normal.semi_axis_y * 1e3)
        ),
        format!("speed {} m/s", number(motion.speed)),
        format!("creepage_x {}", number(motion.creepage_x)),
    ];
    if motion.creepage_y != 0.0 {
        parts.push(format!("creepage_y {}", number(motion.creepage_y)));
    }
    if motion.spin != 0.0 {
        parts.push(format!("spin {} 1/m", number(motion.spin)));
    }
    if answer.solution.reference == ReferencePoint::File {
        parts.push("creepages and moment at the origin of the file".to_owned());
    }
    line(text, &parts.join(", "));
    text.blank();
}

fn row(text: &mut Summary, name: &str, entries: impl Iterator<Item = String>, remark: &str) {
    let entries = entries.map(|entry| format!("{entry:>12}")).collect::<Vec<_>>().concat();
    line(text, &format!("{name:<NAMES$}{entries}{remark}"));
}
