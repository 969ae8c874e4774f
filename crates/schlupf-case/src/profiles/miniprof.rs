//! Miniprof's profiles, `.ban` and `.whl`: lines `Key=Value`, then rows of numbers in mm.
//! `ColumnDef` names the columns; without it the first two are X and Y.
//!
//! The X of a wheel grows outwards from its flange back, its Y towards the tip of the flange; the
//! X of a rail grows towards the middle of the track, its Y upwards. Files before Miniprof for
//! Windows begin with `MINIPROF` and have a head without keys, which ends where rows of numbers
//! begin. `"` begins a comment. Files of several parts (`.mpt`) have them between
//! `[Profile1Points]` and the next `[`.

use super::points::{Axes, Content, File, Row, Separator, begins_with_number, is_row};
use crate::error::CaseError;
use schlupf::reporting::quoted;

const MILLIMETRE: f64 = 1e-3;

const COLUMNS: &str = "ColumnDef";

/// Lines in which the name of the device stands in old files, and whether it says which body it is.
const FIRST_LINES: usize = 3;
const DEVICES: [(&str, Option<bool>); 3] =
    [("MINIPROF", None), ("MINIWHEELPROF", Some(true)), ("MINIRAILPROF", Some(false))];

/// Rows of numbers one after the other that no head has.
const FIRST_ROWS: usize = 8;

/// Whether a file has the head of one of Miniprof's.
pub fn is_one(file: &File) -> bool {
    let has_key = |(_, line): (usize, &str)| {
        line.split_once('=').is_some_and(|(key, _)| key.trim().eq_ignore_ascii_case(COLUMNS))
    };
    devices(file).next().is_some() || file.lines(&[]).any(has_key)
}

/// Those whose names the first lines of a file from before Miniprof for Windows have, with the
/// lines.
fn devices(file: &File) -> impl Iterator<Item = (usize, (&str, Option<bool>))> {
    let lines = (1..).zip(file.source.text.lines().take(FIRST_LINES));
    lines.filter_map(|(number, line)| {
        let line = line.trim_start_matches(['#', ' ']).to_ascii_uppercase();
        let device = DEVICES.into_iter().find(|(name, _)| line.starts_with(name));
        device.map(|device| (number, device))
    })
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
    for (line, (name, is)) in devices(file) {
        file.check_body([is.unwrap_or(is_wheel), is_wheel], line, &format!("device is {name}"))?;
    }
    let mut part: Option<usize> = None;
    // A comment is not an empty line.
    let lines = file.lines(&['"', '!', '#', '%']).zip(file.source.text.lines());
    let lines = lines.filter(|((_, code), text)| !code.is_empty() || text.trim().is_empty());
    let lines: Vec<(usize, &str)> = lines.map(|(line, _)| line).collect();
    let is_begin = |lines: &&[(usize, &str)]| lines.iter().all(|(_, line)| is_row(line));
    // A head without keys has numbers, too.
    let begin = match devices(file).next() {
        Some(_) => lines.windows(FIRST_ROWS).find(is_begin).map_or(usize::MAX, |rows| rows[0].0),
        None => 0,
    };
    for (number, line) in lines {
        if line.is_empty() || number < begin && !line.contains('=') {
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
        let message = "a Miniprof profile must have rows of X and Y, but has none";
        let help = format!("a head without keys ends with the first {FIRST_ROWS} rows of numbers");
        let help = devices(file).next().map(|_| help);
        return Err(file.error_of_all(message).help(help));
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
