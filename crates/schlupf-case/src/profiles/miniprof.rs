//! Miniprof's profiles, `.ban` and `.whl`: lines `Key=Value`, then rows of numbers in mm.
//! `ColumnDef` names the columns; without it the first two are X and Y.
//!
//! The X of a wheel grows outwards from its flange back, its Y towards the tip of the flange; the
//! X of a rail grows towards the middle of the track, its Y upwards. Files before Miniprof for
//! Windows begin with `MINIPROF` and have a head without keys, which ends with an empty line.
//! `"` begins a comment. Files of several parts (`.mpt`) have them between `[Profile1Points]` and
//! the next `[`.

use super::points::{Axes, Content, File, Row, Separator, begins_with_number};
use crate::error::CaseError;
use schlupf::message::quoted;

const MILLIMETRE: f64 = 1e-3;

const COLUMNS: &str = "ColumnDef";

/// Lines in which the name of the device stands in old files.
const FIRST_LINES: usize = 3;

/// Whether a file has the head of one of Miniprof's.
pub fn is_one(file: &File) -> bool {
    let has_key = |(_, line): (usize, &str)| {
        line.split_once('=').is_some_and(|(key, _)| key.trim().eq_ignore_ascii_case(COLUMNS))
    };
    is_old(file) || file.lines(&[]).any(has_key)
}

/// Whether it is older than Miniprof for Windows.
fn is_old(file: &File) -> bool {
    let is_name = |line: &str| {
        let line = line.trim_start_matches(['#', ' ']).to_ascii_uppercase();
        ["MINIPROF", "MINIWHEELPROF", "MINIRAILPROF"].iter().any(|name| line.starts_with(name))
    };
    file.source.text.lines().take(FIRST_LINES).any(is_name)
}

/// What the head says.
struct Head {
    columns: [usize; 2],
    offset: [f64; 2],
}

impl Head {
    fn set(&mut self, file: &File, line: usize, key: &str, value: &str) -> Result<(), CaseError> {
        let key = key.to_ascii_lowercase();
        match key.as_str() {
            // Keys may have no value.
            _ if value.is_empty() => {}
            "columndef" => self.columns = column_places(file, line, value)?,
            "xoffset" => self.offset[0] = file.number(line, value)?,
            "yoffset" => self.offset[1] = file.number(line, value)?,
            _ => {}
        }
        Ok(())
    }
}

/// The points of a file.
pub fn read(file: &File, is_wheel: bool) -> Result<Content, CaseError> {
    let mut head = Head { columns: [0, 1], offset: [0.0; 2] };
    let mut rows: Vec<(usize, &str)> = Vec::new();
    let mut is_head_without_keys = is_old(file);
    let mut part: Option<usize> = None;
    // A comment is not an empty line.
    let lines = (1..).zip(file.source.text.lines()).map(|(number, line)| {
        let code = line.split(['"', '!', '#', '%']).next().unwrap_or_default().trim();
        (number, code, line.trim().is_empty())
    });
    for (number, line, is_empty) in lines {
        if is_empty {
            is_head_without_keys = false;
        }
        if line.is_empty() || is_head_without_keys && !line.contains('=') {
            continue;
        }
        if line.starts_with('[') {
            // Several parts.
            if line.ends_with("Points]") {
                refuse_second(file, number, part.filter(|_| !rows.is_empty()))?;
                part = Some(number);
            }
        } else if let Some((key, value)) = line.split_once('=') {
            if part.is_none() {
                refuse_second(file, number, rows.first().map(|(line, _)| *line))?;
            }
            if rows.is_empty() {
                head.set(file, number, key.trim(), value.trim())?;
            }
        } else if !rows.is_empty() || begins_with_number(line) {
            // Before the first row there may be a line of text.
            rows.push((number, line));
        }
    }
    if rows.is_empty() {
        return Err(file.error_of_all("a Miniprof profile must have rows of X and Y, but has none"));
    }
    let texts = rows.iter().map(|(_, text)| *text);
    let separator = Separator::of(&texts);
    let points: Result<Vec<Row>, CaseError> = rows
        .iter()
        .map(|(line, text)| point(file, *line, &separator.cells(text, 0), &head))
        .collect();
    Ok(Content {
        axes: Axes { is_inwards: Some(!is_wheel), is_down: Some(is_wheel) },
        flange_back: is_wheel.then_some(0.0),
        ..Content::of(format!("Miniprof, in mm{}", separator.remark(texts)), points?)
    })
}

/// The point of a row, in m.
fn point(file: &File, line: usize, cells: &[&str], head: &Head) -> Result<Row, CaseError> {
    let last = head.columns[0].max(head.columns[1]);
    if cells.len() <= last {
        let (needed, given) = (last + 1, cells.len());
        let message = format!("a row must have at least {needed} numbers, but has {given}");
        return Err(file.error(line, message));
    }
    let mut place = [0.0; 2];
    for (k, column) in head.columns.into_iter().enumerate() {
        place[k] = MILLIMETRE * (file.number(line, cells[column])? + head.offset[k]);
    }
    Ok(Row { place, line })
}

/// Refuses what begins another profile at a line, after one that begins at `first`.
fn refuse_second(file: &File, line: usize, first: Option<usize>) -> Result<(), CaseError> {
    let Some(first) = first else { return Ok(()) };
    let message = format!(
        "a file must have one profile, but another one begins here, after that of line {first}"
    );
    Err(file.error(line, message).help("give each profile a file of its own".to_owned()))
}

/// Places of the columns X and Y.
fn column_places(file: &File, line: usize, definition: &str) -> Result<[usize; 2], CaseError> {
    let names: Vec<&str> = definition.split(',').map(str::trim).collect();
    let place = |wanted: &str| {
        let place = names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        place.ok_or_else(|| {
            file.error(
                line,
                format!("{COLUMNS} must name a column {wanted}, but is {}", quoted(definition)),
            )
        })
    };
    Ok([place("X")?, place("Y")?])
}
