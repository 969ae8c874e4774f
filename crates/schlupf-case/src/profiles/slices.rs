//! Slices along a rail (`.slcs`) or around a wheel (`.slcw`), as CONTACT has them: a list of
//! profiles and their places, with breaks between parts that belong together.

use std::path::Path;
use std::sync::Arc;

use schlupf::reporting::{quoted, quoted_path};
use schlupf::wheel_rail::{Interpolation, ProfileCurve, Section, Sections};

use super::outline::{self, Outline, distance};
use super::points::{File, Row};
use super::{
    Oriented, Profile, ProfileFields, ProfileReading, Reader, Shape, Taken, file_content, places,
};
use crate::error::CaseError;
use crate::settings::Settings;

const COMMENTS: &[char] = &['%', '!', '"'];

/// Least distance of two slices, in mm or rad.
const LEAST_STEP: f64 = 1e-3;

/// Difference of two numbers that are written for the same place, in the unit of the file.
const SAME: f64 = 1e-6;

/// Whether a file has slices, by its name.
pub fn is_one(name: &str) -> bool {
    let extension = Path::new(name).extension().unwrap_or_default();
    ["slcs", "slcw"].into_iter().any(|own| extension.eq_ignore_ascii_case(own))
}

/// A profile and its place.
struct Slice {
    line: usize,
    /// As it is written.
    given: f64,
    /// In m or rad.
    place: f64,
    name: String,
    /// Chord lengths from its beginning to its breaks in m, with the line that has them.
    breaks: Option<(usize, Vec<Option<f64>>)>,
}

/// What a file of slices says.
struct List {
    slices: Vec<Slice>,
    interpolation: Interpolation,
}

/// Reads the slices of a file with a name and its bytes.
pub fn read(
    settings: &Settings,
    fields: &ProfileFields,
    (name, bytes): (String, &[u8]),
) -> Result<Profile, CaseError> {
    let file = File::new(name.clone(), bytes, fields.profile)?;
    let is_wheel = fields.is_wheel();
    let is_of_wheel = name.to_ascii_lowercase().ends_with('w');
    file.check_body(
        [is_of_wheel, is_wheel],
        1,
        if is_of_wheel { "name ends in .slcw" } else { "name ends in .slcs" },
    )?;
    let list = Groups::new(&file).list(is_wheel)?;
    let files = list.slices.iter().map(|slice| {
        let (path, bytes) = settings.read_beside(fields.profile, &slice.name);
        let bytes = bytes.map_err(|error| {
            let message =
                format!("a slice must be a readable file, but is {}: {error}", quoted_path(&path));
            let help = "paths are relative to the file of the slices".to_owned();
            file.error(slice.line, message).of_file(&path, &error).help(help)
        })?;
        Ok((path, bytes))
    });
    let files = files.collect::<Result<Vec<_>, CaseError>>()?;
    // All states of a series along a crossing have the same surface.
    let texts = [name, fields.profile.to_string()].into_iter().chain(fields.shown(settings));
    let contents = std::iter::once(bytes).chain(files.iter().map(|(_, bytes)| bytes.as_slice()));
    let key: Vec<Vec<u8>> =
        texts.map(String::into_bytes).chain(contents.map(<[u8]>::to_vec)).collect();
    if let Some(profile) = settings.kept.known(&key) {
        return Ok(profile);
    }
    let profile = surface(settings, fields, (&file, &list), &files)?;
    settings.kept.keep(key, &profile);
    Ok(profile)
}

/// The surface through slices of which a list and the files have been read.
fn surface(
    settings: &Settings,
    fields: &ProfileFields,
    (file, List { slices, interpolation }): (&File, &List),
    files: &[(String, Vec<u8>)],
) -> Result<Profile, CaseError> {
    let is_wheel = fields.is_wheel();
    let mut sections = Vec::with_capacity(slices.len());
    let mut first: Option<(ProfileReading, f64, [Taken; 2])> = None;
    let mut notices = Vec::new();
    for (slice, (path, bytes)) in slices.iter().zip(files) {
        let mut reader = Reader { settings, fields, notices: Vec::new() };
        let content = reader.in_metres(file_content(path.clone(), bytes, fields)?)?;
        let outline = reader.outline(&content)?;
        let known = first.as_ref().map(|(.., [y, z])| [y, z]);
        let Oriented { points, y, z } = reader.oriented(&content, &outline, known)?;
        let points = across(points, &outline, is_wheel);
        let curve = reader.curve(&points)?;
        let breaks = match &slice.breaks {
            Some((line, breaks)) => arcs(breaks, (&points, &curve), is_wheel)
                .map_err(|message| file.error(*line, message))?,
            None => vec![Some(0.0), Some(curve.length())],
        };
        sections.push(Section { place: slice.place, curve, breaks });
        if first.is_none() {
            let flange_back = reader.flange_back(&content, &places(&points))?;
            let text = format!("{} slices, the first: {}", slices.len(), content.format);
            let reading = reader.reading(
                (file.source.name.clone(), &content),
                [&y, &z],
                (&outline, &points),
                flange_back,
            );
            first = Some((ProfileReading { format: text, ..reading }, flange_back, [y, z]));
        }
        // What is true of all slices is said once.
        for notice in reader.notices {
            let kind = std::mem::discriminant(&notice);
            if notices.iter().all(|other| std::mem::discriminant(other) != kind) {
                notices.push(notice);
            }
        }
    }
    let sections = if is_wheel {
        Sections::around(&sections, *interpolation)
    } else {
        Sections::new(&sections, *interpolation, fields.quantity)
    };
    let sections = sections.map_err(|error| file.error_of_all(error.text(&settings.names())))?;
    let sections = Arc::new(sections);
    let shape = if is_wheel { Shape::Around(sections) } else { Shape::Along(sections) };
    let (reading, flange_back, _) =
        first.ok_or_else(|| file.error_of_all("the file must have slices, but has none"))?;
    Ok(Profile { shape, flange_back, reading, notices })
}

/// The points of a slice by growing y: all of an open one, whose beginning counts for its breaks.
fn across(mut points: Vec<Row>, outline: &Outline, is_wheel: bool) -> Vec<Row> {
    if outline.is_closed {
        return outline::running_part(&points, true, is_wheel);
    }
    let is_inwards = |(first, last): (&Row, &Row)| first.place[0] > last.place[0];
    if points.first().zip(points.last()).is_some_and(is_inwards) {
        points.reverse();
    }
    points
}

/// Arc lengths of breaks (in m) along a curve through points. They are counted from the side of the
/// middle of the track on a rail, from the field side on a wheel.
fn arcs(
    breaks: &[Option<f64>],
    (points, curve): (&[Row], &ProfileCurve),
    is_wheel: bool,
) -> Result<Vec<Option<f64>>, String> {
    let length: f64 = points.windows(2).map(|pair| distance(&pair[0], &pair[1])).sum();
    let last = breaks.iter().rposition(Option::is_some);
    let mut before = f64::NEG_INFINITY;
    let mut arcs = Vec::with_capacity(breaks.len());
    for (k, chord) in breaks.iter().enumerate() {
        let Some(chord) = *chord else {
            arcs.push(None);
            continue;
        };
        // The end of the last part may be given as any number beyond.
        let chord = if Some(k) == last { chord.min(length) } else { chord };
        let [given, end] = [chord, length].map(|length| (1e6 * length).round() / 1e3);
        if chord > length {
            return Err(format!(
                "break {} must be within the slice, which is {end} mm long, but is {given} mm",
                k + 1
            ));
        }
        if chord <= before {
            let before = (1e6 * before).round() / 1e3;
            return Err(format!(
                "breaks must ascend, but break {} is {given} mm behind one of {before} mm",
                k + 1
            ));
        }
        before = chord;
        let share = chord / length;
        let share = if is_wheel { 1.0 - share } else { share };
        arcs.push(Some(share * curve.length()));
    }
    if is_wheel {
        arcs.reverse();
    }
    Ok(arcs)
}

/// The text, group of values by group of values: a group may go on in the next line, and what
/// follows its last value in a line is ignored.
struct Groups<'a> {
    file: &'a File,
    lines: std::vec::IntoIter<(usize, &'a str)>,
    /// Number of the last line read.
    line: usize,
}

impl<'a> Groups<'a> {
    fn new(file: &'a File) -> Self {
        let lines: Vec<_> = file.lines(COMMENTS).filter(|(_, line)| !line.is_empty()).collect();
        Self { file, lines: lines.into_iter(), line: 1 }
    }

    fn error(&self, message: impl Into<String>) -> CaseError {
        self.file.error(self.line, message)
    }

    fn list(mut self, is_wheel: bool) -> Result<List, CaseError> {
        let [offset, scale] = self.numbers("offset and scale of the places")?;
        if scale <= 0.0 {
            return Err(self.error(format!("the scale must be positive, but is {scale}")));
        }
        let count = self.count("the number of slices")?;
        if count < 2 {
            let message = format!("there must be at least 2 slices, but there are {count}");
            let help = "a profile that does not change is given as its own file".to_owned();
            return Err(self.error(message).help(help));
        }
        let [breaks, kinks, accelerations] = self.counts("the number of breaks")?;
        let [method, perturbation, _] = self.counts("the interpolation")?;
        let interpolation = match method {
            1 => Interpolation::Through,
            2 => Interpolation::Smooth,
            _ => {
                let message = format!(
                    "the interpolation must be 1 (through the slices) or 2 (smoother), but is {method}"
                );
                return Err(self.error(message));
            }
        };
        if perturbation != 0 {
            let message = format!(
                "PERTURB must be 0, as perturbations are not available, but is {perturbation}"
            );
            return Err(self.error(message));
        }
        let unit = if is_wheel { 1.0 } else { 1e-3 };
        let mut slices: Vec<Slice> = Vec::new();
        for _ in 0..count {
            let (given, name) = self.named("a slice must have its place and its file in quotes")?;
            let (line, place) = (self.line, unit * scale * (offset + given));
            if let Some(before) = slices.last()
                && place - before.place < LEAST_STEP * unit
            {
                return Err(self.error(format!(
                    "slices must ascend by at least {LEAST_STEP} {}, but {given} follows {}",
                    if is_wheel { "rad" } else { "mm" },
                    before.given
                )));
            }
            slices.push(Slice { line, given, place, name, breaks: None });
        }
        for _ in 0..usize::from(kinks > 0) + usize::from(accelerations > 0) {
            self.line("the numbers of parts")?;
        }
        for slice in slices.iter_mut().filter(|_| breaks > 1) {
            let mut numbers =
                self.group("the breaks of a slice", breaks.saturating_add(1))?.into_iter();
            let at = numbers.next().unwrap_or_default();
            if (at - slice.given).abs() > SAME * at.abs().max(1.0) {
                return Err(self.error(format!(
                    "breaks must be those of the slice at {}, but are of {at}",
                    slice.given
                )));
            }
            let lengths = numbers.map(|length| (length >= 0.0).then_some(1e-3 * length)).collect();
            slice.breaks = Some((self.line, lengths));
        }
        if let Some((line, text)) = self.lines.next() {
            let message = format!("the file must end here, but goes on with {}", quoted(text));
            return Err(self.file.error(line, message));
        }
        Ok(List { slices, interpolation })
    }

    fn line(&mut self, what: &str) -> Result<&'a str, CaseError> {
        let Some((line, text)) = self.lines.next() else {
            return Err(self.error(format!("the file must go on with {what}, but ends")));
        };
        self.line = line;
        Ok(text)
    }

    /// So many numbers.
    fn group(&mut self, what: &str, count: usize) -> Result<Vec<f64>, CaseError> {
        let mut numbers = Vec::new();
        while numbers.len() < count {
            let text = self.line(what)?;
            for word in words(text).take(count - numbers.len()) {
                numbers.push(self.file.number(self.line, word)?);
            }
        }
        Ok(numbers)
    }

    fn numbers<const N: usize>(&mut self, what: &str) -> Result<[f64; N], CaseError> {
        let numbers = self.group(what, N)?;
        Ok(std::array::from_fn(|k| numbers[k]))
    }

    /// A count, and up to two more in its line.
    fn counts(&mut self, what: &str) -> Result<[usize; 3], CaseError> {
        let text = self.line(what)?;
        let mut counts = [0; 3];
        for (k, word) in words(text).take(3).enumerate() {
            match word.parse() {
                Ok(count) => counts[k] = count,
                Err(_) if k > 0 => break,
                Err(_) => {
                    let message = format!("{what} must be a whole number, but is {}", quoted(word));
                    return Err(self.error(message));
                }
            }
        }
        Ok(counts)
    }

    fn count(&mut self, what: &str) -> Result<usize, CaseError> {
        Ok(self.counts(what)?[0])
    }

    /// A number and a name in quotes.
    fn named(&mut self, requirement: &str) -> Result<(f64, String), CaseError> {
        let mut text = self.line("slices")?.to_owned();
        if !text.contains('\'') {
            text = format!("{text} {}", self.line("the file of a slice")?);
        }
        let mut parts = text.split('\'');
        let (Some(number), Some(name), Some(_)) = (parts.next(), parts.next(), parts.next()) else {
            return Err(self.error(format!("{requirement}, but is {}", quoted(&text))));
        };
        let place = self.file.number(self.line, number.trim().trim_end_matches(','))?;
        Ok((place, name.trim().replace('\\', "/")))
    }
}

/// What stands between spaces and commas.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split([' ', '\t', ',']).filter(|word| !word.is_empty())
}
