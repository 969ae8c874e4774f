//! Which cases belong together: the steps of transient rolling are cases of CONTACT, and one case
//! with a history here.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::Source;

use crate::import::contact::basic::{Basic, Motion, Rolling};
use crate::import::contact::control::Control;
use crate::import::contact::given::Given;
use crate::import::contact::input::{Element, InputCase, Module};

use super::basic;
use super::case::Translation;
use super::frame::WheelBody;

/// What becomes one case file.
#[derive(Debug)]
pub struct Job<'a> {
    /// The first of its cases, or the only one.
    pub first: &'a InputCase,
    /// The other steps of transient rolling.
    pub steps: Vec<&'a InputCase>,
    /// What the first step goes on from.
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
        let goes_on = is_transient(case) && case.control.previous.is(0);
        let place = match before {
            Some((before, place)) if goes_on && is_transient(before) => {
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

/// Whether a case is a step of transient rolling between given bodies.
pub fn is_transient(case: &InputCase) -> bool {
    matches!(case.module, Module::Basic(_)) && case.control.tangential.is(2)
}

/// Translates the steps of transient rolling.
pub fn translate(source: &Arc<Source>, job: &Job, wheel: WheelBody, stem: &str) -> Translation {
    let mut case = Translation::new(source);
    let Module::Basic(of_first) = &job.first.module else { return case };
    let control = &job.first.control;
    if let Some(step) = job.all().find(|step| step.control.previous.is(3)) {
        let what = "a step that is repeated (P = 3) is not available in transient rolling";
        case.refuse(step.control.previous, what, "P = 0 is a new step");
    }
    let Some(written) = basic::write(&mut case, (control, of_first), wheel, stem) else {
        return case;
    };
    if let Some(before) = job.before {
        start(&mut case, before, of_first, |case, shift, of| {
            basic::write_shift(case, &shift.control, of, written.frame);
        });
    }
    let series = job.series(&mut case, wheel, stem);
    series.write(&mut case);
    case
}

/// What transient rolling begins with: a contact without tractions, or a shift.
fn start(
    case: &mut Translation,
    before: &InputCase,
    of_first: &Basic,
    shift: impl FnOnce(&mut Translation, &InputCase, &Motion),
) {
    let Module::Basic(of) = &before.module else { return };
    match before.control.tangential.whole() {
        1 => {
            let same = of.motion.zip(of_first.motion).filter(|(a, b)| a.normal == b.normal);
            match same {
                Some((motion, _)) => shift(case, before, &motion),
                None => case.refuse(
                    before.control.previous,
                    "a shift under another normal force than that of the first step is not available",
                    "",
                ),
            }
        }
        3 => case.refuse(
            before.control.tangential,
            "transient rolling that goes on from steady rolling is not available",
            "P = 2 begins without tractions",
        ),
        // A contact without friction has no tractions.
        _ => {}
    }
}

/// Values at the end of every step.
#[derive(Debug, Default)]
struct Series {
    /// In ms.
    time: Vec<f64>,
    creepage_x: Vec<f64>,
    creepage_y: Vec<f64>,
    /// In 1/m.
    spin: Vec<f64>,
    /// In kN; none where the creepages are given.
    force_x: Vec<f64>,
    force_y: Vec<f64>,
    /// In m/s.
    speed: Vec<f64>,
    /// In kN.
    load: Vec<f64>,
}

impl Job<'_> {
    /// All of its cases.
    pub fn all(&self) -> impl Iterator<Item = &InputCase> {
        std::iter::once(self.first).chain(self.steps.iter().copied())
    }

    fn series(&self, case: &mut Translation, wheel: WheelBody, stem: &str) -> Series {
        let mut series = Series { time: vec![0.0], ..Series::default() };
        let Module::Basic(of_first) = &self.first.module else { return series };
        let mut time = 0.0;
        for (place, step) in self.all().enumerate() {
            let Module::Basic(of) = &step.module else { continue };
            if let Some(changed) = changed((self.first, of_first), of, step) {
                let what = "a change within a sequence of steps is not available";
                let may = "only load, creepages or forces, spin, speed and step may change";
                case.refuse(changed, what, may);
                return series;
            }
            let mut own = Translation::new(case.source());
            let written = basic::write(&mut own, (&step.control, of), wheel, stem);
            let (Some(written), Some(rolling)) = (written, of.rolling) else {
                case.errors.extend(own.errors);
                return series;
            };
            if place > 0 {
                case.notices.extend(own.notices);
                case.errors.extend(own.errors);
            }
            time += 1e3 * rolling.step.value / rolling.speed.value;
            series.time.push(time);
            let count = if place == 0 { 2 } else { 1 };
            for _ in 0..count {
                series.push((&step.control, of), &rolling, written);
            }
        }
        series
    }
}

impl Series {
    fn push(
        &mut self,
        (control, of): (&Control, &Basic),
        rolling: &Rolling,
        written: basic::Written,
    ) {
        let Some(motion) = &of.motion else { return };
        let [x, y] = basic::creepages_at(motion, written);
        let [force_x, force_y] = basic::forces_at(control, of, written);
        // Those in place of which a force is given count for nothing.
        self.creepage_x.push(if force_x.is_some() { 0.0 } else { x });
        self.creepage_y.push(if force_y.is_some() { 0.0 } else { y });
        self.force_x.extend(force_x);
        self.force_y.extend(force_y);
        self.spin.push(1e3 * motion.spin.value);
        self.speed.push(rolling.speed.value / 1e3);
        self.load.push(written.contact.load / 1e3);
    }

    /// Times, and what changes over them.
    fn write(&self, case: &mut Translation) {
        let changes = |values: &[f64]| values.windows(2).any(|pair| pair[0] != pair[1]);
        let document = &mut case.document;
        document.quantities(field!("history.time"), &self.time, "ms");
        if changes(&self.creepage_x) {
            document.numbers(field!("history.creepage_x"), &self.creepage_x);
        }
        if changes(&self.creepage_y) {
            document.numbers(field!("history.creepage_y"), &self.creepage_y);
        }
        if changes(&self.force_x) {
            document.quantities(field!("history.force_x"), &self.force_x, "kN");
        }
        if changes(&self.force_y) {
            document.quantities(field!("history.force_y"), &self.force_y, "kN");
        }
        if changes(&self.spin) {
            document.quantities(field!("history.spin"), &self.spin, "1/m");
        }
        if changes(&self.speed) {
            document.quantities(field!("history.speed"), &self.speed, "m/s");
        }
        if changes(&self.load) {
            document.quantities(field!("history.load"), &self.load, "kN");
        }
    }
}

/// The digit of what a step has other than the first one, though it may not.
fn changed((begin, first): (&InputCase, &Basic), of: &Basic, step: &InputCase) -> Option<Given> {
    let direction = |of: &Basic| of.rolling.map(|rolling| rolling.direction);
    [
        (first.friction == of.friction, step.control.friction_law),
        (first.elastic == of.elastic, step.control.influence),
        (direction(first) == direction(of), step.control.influence),
        (first.heat == of.heat, step.control.heat),
        (first.area == of.area, step.control.grid),
        (first.distance == of.distance, step.control.distance),
        (begin.control.force.whole() == step.control.force.whole(), step.control.force),
    ]
    .into_iter()
    .find_map(|(is_same, digit)| (!is_same).then_some(digit))
}
