//! An input file as its cases.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::{CaseError, Source};

use super::basic::Basic;
use super::control::Control;
use super::given::{At, Given, whole};
use super::reader::{Reader, Reading};
use super::wheel_rail::WheelRail;

/// A case with all that counts for it, whether it was given with it or with an earlier one.
#[derive(Debug, Clone)]
pub struct InputCase {
    /// Its number in the file, from 1.
    pub number: usize,
    /// Where it begins.
    pub at: At,
    /// What its comments call it.
    pub title: Option<String>,
    /// Its control digits.
    pub control: Control,
    /// What the module has.
    pub module: Module,
    /// The result element and the contact that it belongs to: what a case keeps is theirs.
    pub element: Element,
    /// Whether it is only prepared, and not solved: digit R.
    pub is_skipped: bool,
}

/// What a case has, by module.
#[derive(Debug, Clone)]
pub enum Module {
    /// Module 1.
    WheelRail(Box<WheelRail>),
    /// Module 3.
    Basic(Box<Basic>),
}

impl Module {
    /// Its number.
    pub fn number(&self) -> i64 {
        match self {
            Self::WheelRail(_) => 1,
            Self::Basic(_) => 3,
        }
    }
}

/// REID and CPID.
pub type Element = [i64; 2];

/// An input file.
#[derive(Debug)]
pub struct Input {
    /// The cases up to where it ends, or cannot be read on.
    pub cases: Vec<InputCase>,
    /// Why it cannot be read on.
    pub stop: Option<CaseError>,
}

/// Most cases of a file.
const MOST_CASES: usize = 100_000;

/// Reads all cases.
pub fn read(source: &Arc<Source>) -> Input {
    let mut reader = Reader::new(Arc::clone(source));
    let mut cases = Vec::new();
    let stop = read_cases(&mut reader, &mut cases).err();
    Input { cases, stop }
}

fn read_cases(reader: &mut Reader, cases: &mut Vec<InputCase>) -> Reading<()> {
    let mut basics: BTreeMap<Element, (Basic, usize)> = BTreeMap::new();
    let mut wheels: BTreeMap<Element, (WheelRail, usize)> = BTreeMap::new();
    let mut stays: Option<(i64, Element)> = None;
    let mut end = 0;
    while !reader.is_at_end() {
        let start = reader.next();
        let (module, element) = match stays.take() {
            Some(stays) => stays,
            None => match module(reader)? {
                Some(begins) => begins,
                None => return Ok(()),
            },
        };
        let number = cases.len() + 1;
        if number > MOST_CASES {
            let message = format!("the file must have {MOST_CASES} cases at most, but has more");
            return Err(reader.error("MODULE", start, message));
        }
        let title = reader.title(end, start.line);
        let mut control = Control::read(reader, module)?;
        if !basics.contains_key(&element) && !wheels.contains_key(&element) {
            // The first case begins without tractions, whatever its digit P says.
            control.previous.value = 2.0;
        }
        let module_number = module;
        let module = if module == 1 {
            let (wheel, count) = wheels.entry(element).or_default();
            check_first(reader, &control, *count == 0)?;
            wheel.read(reader, &control)?;
            *count += 1;
            Module::WheelRail(Box::new(wheel.clone()))
        } else {
            let (basic, count) = basics.entry(element).or_default();
            check_first(reader, &control, *count == 0)?;
            basic.read(reader, &control)?;
            *count += 1;
            Module::Basic(Box::new(basic.clone()))
        };
        end = reader.line();
        let following = control.following.whole();
        if matches!(following, 0 | 2) {
            stays = Some((module_number, element));
        }
        let is_skipped = following >= 2;
        cases.push(InputCase { number, at: start, title, control, module, element, is_skipped });
    }
    Ok(())
}

/// A module and the element that it works on; nothing at the end of the cases.
fn module(reader: &mut Reader) -> Reading<Option<(i64, Element)>> {
    let ([module], [result, contact]) =
        reader.numbers_and([whole("MODULE")], [whole("REID"), whole("CPID")])?;
    let element = [result, contact].map(|given| given.map_or(1, Given::whole));
    match module.whole() {
        0 => Ok(None),
        number @ (1 | 3) => Ok(Some((number, element))),
        other => {
            let message = format!("MODULE must be 0, 1 or 3, but is {other}");
            Err(reader.error("MODULE", module.at, message))
        }
    }
}

/// The first case of an element has nothing to keep.
fn check_first(reader: &Reader, control: &Control, is_first: bool) -> Reading<()> {
    if !is_first {
        return Ok(());
    }
    let kept = [control.friction_law].into_iter().filter(|law| law.is(1)).chain(
        [control.grid, control.influence, control.distance].into_iter().filter(|d| d.value < 2.0),
    );
    for digit in kept {
        // The track of module 1 is checked part by part, because there are more of them.
        if digit.name == "Z" && digit.value > 0.0 {
            continue;
        }
        let (name, value) = (digit.name, digit.whole());
        let message = format!("{name} = {value} keeps what an earlier case has, but there is none");
        return Err(reader.error(name, digit.at, message));
    }
    Ok(())
}
