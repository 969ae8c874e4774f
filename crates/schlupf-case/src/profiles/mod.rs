//! Profiles of wheels and rails: files of several formats, and some that are built in.
//!
//! A file is read as its points in metres, in the axes of the file, and these are put in the order
//! of the outline; then y is made to point outwards and z upwards, and what runs is cut out. The
//! axes are those that the case gives, or those of the shape, or where that is not clear those of
//! the format.

mod built_in;
mod miniprof;
mod orientation;
mod outline;
mod plain;
mod points;
mod reading;
mod simpack;
mod slices;

use std::ffi::OsStr;
use std::path::Path;
use std::sync::Arc;

use schlupf::Quantity;
use schlupf::wheel_rail::{ProfileCurve, Sections, Side, Surface};

use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::choice::{LateralAxis, VerticalAxis};
use crate::files::DataUrl;
use crate::notice::Notice;
use crate::settings::Settings;
use crate::side::sided;
use outline::{Change, NoLine, Outline};
use points::{Axes, Content, File, Row};
use reading::millimetres;

pub use plain::COLUMNS;
pub use reading::ProfileReading;
pub use slices::is_one as has_slices;

/// Whether a text names a file, not a profile that is built in, nor data in its place.
pub fn names_file(text: &str) -> bool {
    !built_in::is_name(text) && DataUrl::of(text).is_none()
}

/// Paths of the fields of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfileFields {
    profile: FieldPath,
    z: FieldPath,
    y: FieldPath,
    scale: FieldPath,
    smoothing: FieldPath,
    flange_back: Option<FieldPath>,
    quantity: Quantity,
}

/// Those of the wheel of a side, or of both.
pub fn of_wheel(settings: &Settings, side: Side) -> ProfileFields {
    ProfileFields {
        profile: sided!("wheel", "profile").of(settings, side),
        z: sided!("wheel", "profile_z").of(settings, side),
        y: sided!("wheel", "profile_y").of(settings, side),
        scale: sided!("wheel", "profile_scale").of(settings, side),
        smoothing: sided!("wheel", "profile_smoothing").of(settings, side),
        flange_back: Some(sided!("wheel", "flange_back_position").of(settings, side)),
        quantity: Quantity::WheelProfile,
    }
}

/// Those of the rail of a side, or of both.
pub fn of_rail(settings: &Settings, side: Side) -> ProfileFields {
    ProfileFields {
        profile: sided!("rail", "profile").of(settings, side),
        z: sided!("rail", "profile_z").of(settings, side),
        y: sided!("rail", "profile_y").of(settings, side),
        scale: sided!("rail", "profile_scale").of(settings, side),
        smoothing: sided!("rail", "profile_smoothing").of(settings, side),
        flange_back: None,
        quantity: Quantity::RailProfile,
    }
}

impl ProfileFields {
    /// What is given of it, and of what it depends on beside its file.
    fn shown(&self, settings: &Settings) -> Vec<String> {
        let own = [self.z, self.y, self.scale, self.smoothing, field!("track.gauge_depth")];
        own.into_iter().chain(self.flange_back).map(|path| settings.shown(path)).collect()
    }

    fn is_wheel(&self) -> bool {
        self.flange_back.is_some()
    }
}

/// A profile.
#[derive(Debug, Clone)]
pub struct Profile {
    /// y outwards and z up.
    pub shape: Shape,
    /// y of the flange back of a wheel, in m.
    pub flange_back: f64,
    /// What was read.
    pub reading: ProfileReading,
    /// What users should know of it.
    pub notices: Vec<Notice>,
}

/// What a profile is along the way.
#[derive(Debug, Clone)]
pub enum Shape {
    /// The same everywhere.
    Uniform(ProfileCurve),
    /// Slices along the track.
    Along(Arc<Sections>),
    /// Slices around the wheel.
    Around(Arc<Sections>),
}

impl Shape {
    /// As a surface of which a place is at the wheelset: of a rail along the track in m, of a wheel
    /// below the axle in rad.
    pub fn surface(&self, at: f64) -> Surface {
        match self {
            Self::Uniform(curve) => curve.clone().into(),
            Self::Along(sections) => Surface::along(Arc::clone(sections), at),
            Self::Around(sections) => Surface::around(Arc::clone(sections), at),
        }
    }
}

/// Position of the flange back in profiles whose origin is at the running circle, in m.
const FLANGE_BACK: f64 = -0.07;

/// Distances of the tip of a flange from its back, in m.
const TIP: std::ops::RangeInclusive<f64> = 2e-3..=4e-2;

/// Least height of what counts as a flange, in m.
const LEAST_FLANGE: f64 = 0.015;

/// Least width or height of a profile, and its largest coordinate, in m.
const NARROWEST: f64 = 2e-3;
const LARGEST: f64 = 1.0;

/// Widths of profiles of full size, in m.
const FULL_SIZE: std::ops::RangeInclusive<f64> = 0.03..=0.3;

/// Reads a profile.
pub fn read(settings: &Settings, fields: &ProfileFields) -> Result<Profile, CaseError> {
    let name = settings.text(fields.profile)?;
    let built_in = built_in::points(&name, fields.is_wheel());
    let is_built_in = built_in.is_some();
    let content = if let Some(points) = built_in {
        let rows = points.into_iter().map(|place| Row { place, line: 0 }).collect();
        Content::of("built in", rows)
    } else {
        let (name, bytes) = file_bytes(settings, fields)?;
        if slices::is_one(&name) {
            return slices::read(settings, fields, (name, &bytes));
        }
        file_content(name, &bytes, fields)?
    };
    let mut reader = Reader { settings, fields, notices: Vec::new() };
    let content = reader.in_metres(content)?;
    let outline = if is_built_in {
        Outline { points: content.rows.clone(), is_closed: false, changes: Vec::new() }
    } else {
        reader.outline(&content)?
    };
    reader.profile(name, &content, &outline)
}

/// Name and bytes of the file of a profile.
fn file_bytes(settings: &Settings, fields: &ProfileFields) -> Result<(String, Vec<u8>), CaseError> {
    settings.read_file(fields.profile).map_err(|error| {
        let names = built_in::names(fields.is_wheel());
        error.help(format!(
            "relative paths are relative to the folder of the case; built in are {names}"
        ))
    })
}

/// What a file says.
fn file_content(name: String, bytes: &[u8], fields: &ProfileFields) -> Result<Content, CaseError> {
    let ending = Path::new(&name).extension().map(OsStr::to_ascii_lowercase);
    let file = File::new(name, bytes, fields.profile)?;
    let is_wheel = fields.is_wheel();
    let ending = ending.as_ref().and_then(|ending| ending.to_str()).unwrap_or_default();
    let content = match ending {
        "prr" | "prw" => simpack::read(&file, is_wheel),
        "ban" | "whl" | "mpt" => miniprof::read(&file, is_wheel),
        // Gensys: y towards the middle of the track, z down.
        "wheel" | "rail" => {
            let content = plain::read(&file)?;
            let axes = Axes { is_inwards: Some(true), is_down: Some(true) };
            Ok(Content { format: format!("Gensys, {}", content.format), axes, ..content })
        }
        _ if simpack::is_one(&file) => simpack::read(&file, is_wheel),
        _ if miniprof::is_one(&file) => miniprof::read(&file, is_wheel),
        _ => plain::read(&file),
    }?;
    match ending {
        "prw" | "whl" | "wheel" => {
            file.check_body([true, is_wheel], 1, &format!("name ends in .{ending}"))
        }
        "prr" | "ban" | "rail" => {
            file.check_body([false, is_wheel], 1, &format!("name ends in .{ending}"))
        }
        _ => Ok(()),
    }?;
    Ok(content)
}

/// Lowest and highest coordinate of points, in m.
fn range(rows: &[Row], axis: usize) -> [f64; 2] {
    rows.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], row| {
        [low.min(row.place[axis]), high.max(row.place[axis])]
    })
}

fn size(rows: &[Row]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let [low, high] = range(rows, axis);
        high - low
    })
}

fn places(rows: &[Row]) -> Vec<[f64; 2]> {
    rows.iter().map(|row| row.place).collect()
}

/// Reads one profile.
struct Reader<'a> {
    settings: &'a Settings,
    fields: &'a ProfileFields,
    notices: Vec<Notice>,
}

/// A direction that was taken, and how it is known.
#[derive(Clone)]
struct Taken {
    is: bool,
    from: &'static str,
}

/// Points with y outwards and z up, and how their directions are known.
struct Oriented {
    points: Vec<Row>,
    y: Taken,
    z: Taken,
}

impl Reader<'_> {
    fn error(&self, message: String) -> CaseError {
        self.settings.error(self.fields.profile, message)
    }

    /// The points in metres: numbers without a unit are in mm, or in m where they would be too
    /// small by three orders of magnitude.
    fn in_metres(&mut self, mut content: Content) -> Result<Content, CaseError> {
        let field = self.fields.profile;
        let scale = self.settings.number(self.fields.scale)?;
        if scale != 1.0 {
            for row in &mut content.rows {
                row.place = row.place.map(|c| scale * c);
            }
            content.has_units = true;
        }
        if content.rows.is_empty() {
            return Err(self.error(format!("{field} must have rows of points, but has none")));
        }
        let [width, height] = size(&content.rows);
        let shown = |factor: f64| {
            let [width, height] = [width, height].map(|length| millimetres(factor * length));
            format!("{width} wide and {height} high")
        };
        if !content.has_units && FULL_SIZE.contains(&(1e3 * width)) {
            let text = format!(
                "the numbers have no unit and are taken for metres, so that the profile is {}; in mm it \
                 would be {}",
                shown(1e3),
                shown(1.0)
            );
            self.notices.push(Notice::ProfileUnits { field, text });
            let scaled = |row: Row| Row { place: row.place.map(|c| 1e3 * c), ..row };
            let rows = content.rows.into_iter().map(scaled).collect();
            return Ok(Content { rows, format: format!("{}, in m", content.format), ..content });
        }
        let others = [("m", 1e3), ("inches", 25.4), ("cm", 10.0), ("um", 1e-3)].into_iter();
        let others = others.filter(|(_, factor)| FULL_SIZE.contains(&(factor * width)));
        let others: Vec<String> = others
            .map(|(unit, factor)| {
                let other = if content.has_units {
                    format!("{factor} times as large ({unit} for mm)")
                } else {
                    format!("{unit} in place of mm")
                };
                format!("were its numbers {other}, it would be {}", shown(factor))
            })
            .collect();
        let other = (!others.is_empty()).then(|| others.join("; "));
        let is_off = |row: &&Row| row.place.iter().any(|c| c.abs() > LARGEST);
        if let Some(row) = content.rows.iter().find(is_off) {
            let off = row.place.into_iter().find(|c| c.abs() > LARGEST).unwrap_or_default();
            let (off, line) = (millimetres(off), row.line);
            let message =
                format!("{field} must be at most ±1 m, but is {off} in line {line} of the file");
            return Err(self.error(message).help(other));
        }
        if width.max(height) < NARROWEST {
            let least = millimetres(NARROWEST);
            let message =
                format!("{field} must be at least {least} wide or high, but is {}", shown(1.0));
            return Err(self.error(message).help(other));
        }
        if let Some(other) = other.filter(|_| !FULL_SIZE.contains(&width)) {
            let text = format!("the profile is {}; {other}", shown(1.0));
            self.notices.push(Notice::ProfileUnits { field, text });
        }
        let unit = if content.has_units { "" } else { ", in mm" };
        Ok(Content { format: format!("{}{unit}", content.format), ..content })
    }

    /// The points in the order of the outline.
    fn outline(&mut self, content: &Content) -> Result<Outline, CaseError> {
        let field = self.fields.profile;
        let outline = outline::outline(&content.rows).map_err(|no_line| {
            let (row, why) = match no_line {
                NoLine::Branches(row) => {
                    (row, "the points must form one line, but lines meet or cross")
                }
                NoLine::TooMany(row) => {
                    (row, "so many points must be in the order of the outline, but turn back")
                }
            };
            let [y, z] = row.place.map(millimetres);
            let line = row.line;
            self.error(format!("{field}: {why} at y = {y}, z = {z} (line {line} of the file)"))
        })?;
        for change in &outline.changes {
            let (field, text) = (field, change.text());
            self.notices.push(match change {
                Change::Overlap { .. } => Notice::ProfileOverlap { field, text },
                _ => Notice::ProfileOrder { field, text },
            });
        }
        self.check_columns(content, &outline)?;
        Ok(outline)
    }

    /// Refuses y and z that are probably swapped, and warns where a header says so or where the
    /// shape is as clear as it is.
    fn check_columns(&mut self, content: &Content, outline: &Outline) -> Result<(), CaseError> {
        let field = self.fields.profile;
        let points = places(&outline.points);
        if !orientation::is_high(&points, outline.is_closed) {
            return Ok(());
        }
        let turned: Vec<[f64; 2]> = points.iter().map(|[y, z]| [*z, *y]).collect();
        let [as_read, swapped] = [&points, &turned]
            .map(|points| orientation::downwards(points, self.fields.is_wheel()).abs());
        let is_swapped = swapped > as_read;
        let [width, height] = size(&content.rows).map(millimetres);
        let size = format!("the profile is {width} wide and {height} high");
        let help = "a header `y [mm],z [mm]` confirms the columns, `z [mm],y [mm]` swaps them";
        let text = match (is_swapped, content.has_units) {
            (true, false) => {
                let message = format!("{field}: y and z seem to be swapped: {size}");
                return Err(self.error(message).help(help.to_owned()));
            }
            (true, true) => format!("y and z seem to be swapped: {size}"),
            (false, false) => format!("{size}, its columns are taken for y and z; {help}"),
            (false, true) => return Ok(()),
        };
        self.notices.push(Notice::ProfileAxes { field, text });
        Ok(())
    }

    /// The profile, y outwards and z up.
    fn profile(
        mut self,
        name: String,
        content: &Content,
        outline: &Outline,
    ) -> Result<Profile, CaseError> {
        let fields = self.fields;
        for setting in &content.left_out {
            let (field, setting) = (fields.profile, setting.clone());
            self.notices.push(Notice::ProfileSetting { field, setting });
        }
        let Oriented { points, y, z } = self.oriented(content, outline, None)?;
        let running = outline::running_part(&points, outline.is_closed, fields.is_wheel());
        let curve = self.curve(&running)?;
        let flange_back = self.flange_back(content, &places(&running))?;
        let reading = self.reading((name, content), [&y, &z], (outline, &running), flange_back);
        Ok(Profile { shape: Shape::Uniform(curve), flange_back, reading, notices: self.notices })
    }

    fn curve(&self, points: &[Row]) -> Result<ProfileCurve, CaseError> {
        let (settings, fields) = (self.settings, self.fields);
        let smoothing = settings.number(fields.smoothing)?;
        ProfileCurve::new(&places(points), smoothing, fields.quantity)
            .map_err(|error| settings.error(fields.profile, error.text(&settings.names())))
    }

    /// The points with y outwards and z up, as the shape shows where it is not known already.
    fn oriented(
        &mut self,
        content: &Content,
        outline: &Outline,
        known: Option<[&Taken; 2]>,
    ) -> Result<Oriented, CaseError> {
        let mut points = outline.points.clone();
        let closed = |points: &[Row]| {
            let again = points.first().filter(|_| outline.is_closed);
            points.iter().chain(again).map(|row| row.place).collect::<Vec<_>>()
        };
        let z = match known {
            Some([_, z]) => z.clone(),
            None => self.vertical(content, &closed(&points))?,
        };
        for row in points.iter_mut().filter(|_| z.is) {
            row.place[1] = -row.place[1];
        }
        let y = match known {
            Some([y, _]) => y.clone(),
            None => self.lateral(content, &closed(&points))?,
        };
        for row in points.iter_mut().filter(|_| y.is) {
            row.place[0] = -row.place[0];
        }
        Ok(Oriented { points, y, z })
    }

    fn reading(
        &self,
        (name, content): (String, &Content),
        [y, z]: [&Taken; 2],
        (outline, running): (&Outline, &[Row]),
        flange_back: f64,
    ) -> ProfileReading {
        let fields = self.fields;
        let direction = |taken: &Taken, names: [&str; 2]| {
            format!("{} ({})", names[usize::from(taken.is)], taken.from)
        };
        let reading = ProfileReading {
            field: fields.profile,
            name,
            format: content.format.clone(),
            points: [content.rows.len(), running.len()],
            size: size(&content.rows),
            y: direction(y, ["outwards", "inwards"]),
            z: direction(z, ["up", "down"]),
            flange_back: fields.is_wheel().then_some(flange_back),
            spacing: [0.0; 2],
            holes: Vec::new(),
            order: outline.changes.iter().map(Change::text).collect(),
        };
        reading.spaced(running)
    }

    fn vertical(&mut self, content: &Content, points: &[[f64; 2]]) -> Result<Taken, CaseError> {
        let given = match self.settings.chosen(self.fields.z)? {
            VerticalAxis::Up => Some(false),
            VerticalAxis::Down => Some(true),
            VerticalAxis::Auto => None,
        };
        let shape = orientation::downwards(points, self.fields.is_wheel());
        Ok(self.taken(self.fields.z, [given, content.axes.is_down, None], shape, ["up", "down"]))
    }

    fn lateral(&mut self, content: &Content, points: &[[f64; 2]]) -> Result<Taken, CaseError> {
        let given = match self.settings.chosen(self.fields.y)? {
            LateralAxis::Outwards => Some(false),
            LateralAxis::Inwards => Some(true),
            LateralAxis::Auto => None,
        };
        let depth = self.settings.number(field!("track.gauge_depth"))?;
        let shape = orientation::inwards(points, self.fields.is_wheel(), depth);
        // Most rails are symmetrical.
        let by_default = (!self.fields.is_wheel()).then_some(false);
        let known = [given, content.axes.is_inwards, by_default];
        Ok(self.taken(self.fields.y, known, shape, ["outwards", "inwards"]))
    }

    /// A direction that is given, or that the shape shows, or that the format has, or that by
    /// default; says where the shape contradicts what is given or the format, or where there is
    /// none.
    fn taken(
        &mut self,
        field: FieldPath,
        [given, by_format, by_default]: [Option<bool>; 3],
        shape: f64,
        names: [&'static str; 2],
    ) -> Taken {
        let by_shape = (shape.abs() >= orientation::CLEAR).then_some(shape > 0.0);
        let contradicts =
            |other: Option<bool>| other.is_some() && by_shape.is_some_and(|is| Some(is) != other);
        let axis = &field[field.len() - 1..];
        let name = |is: bool| names[usize::from(is)];
        let (taken, text) = match (given, by_shape, by_format.or(by_default)) {
            (Some(is), ..) => {
                let text = contradicts(given).then(|| {
                    let (given, other) = (name(is), name(!is));
                    format!("{axis} is said to point {given}, but by its shape it points {other}")
                });
                (Taken { is, from: "given" }, text)
            }
            (None, Some(is), _) => {
                let text = contradicts(by_format).then(|| {
                    let (taken, other) = (name(is), name(!is));
                    format!(
                        "by its shape {axis} points {taken}, which is taken, but in files of this \
                         format it points {other}; {field} decides"
                    )
                });
                (Taken { is, from: "by its shape" }, text)
            }
            (None, None, Some(is)) => {
                let from = if by_format.is_some() { "by its format" } else { "by default" };
                (Taken { is, from }, None)
            }
            (None, None, None) => {
                let text = format!(
                    "the shape hardly shows where {axis} points; {} is taken; {field} decides",
                    name(false)
                );
                (Taken { is: false, from: "a guess" }, Some(text))
            }
        };
        self.notices.extend(text.map(|text| Notice::ProfileAxes { field, text }));
        taken
    }

    /// y of the flange back: that given, that of the format, or where the tip of the flange cannot
    /// belong to it the other one of both that are usual; in m.
    fn flange_back(&mut self, content: &Content, points: &[[f64; 2]]) -> Result<f64, CaseError> {
        let Some(field) = self.fields.flange_back else { return Ok(0.0) };
        if let Some(given) = self.settings.optional_number(field)? {
            return Ok(given);
        }
        let usual = content.flange_back.unwrap_or(FLANGE_BACK);
        let tip = orientation::flange_tip(points).filter(|[depth, _]| *depth > LEAST_FLANGE);
        let Some([_, tip]) = tip else { return Ok(usual) };
        let fits = |back: &f64| TIP.contains(&(tip - back));
        if fits(&usual) {
            return Ok(usual);
        }
        let other = [0.0, FLANGE_BACK].into_iter().find(fits);
        let taken = other.unwrap_or(usual);
        let [tip, usual, shown] = [tip, usual, taken].map(millimetres);
        let text = match other {
            Some(_) => format!(
                "the tip of the flange is at y = {tip}, so its back is taken to be at {shown}, not at \
                 {usual} as usual"
            ),
            None => format!(
                "the tip of the flange is at y = {tip}, too far from its back, which is taken to be at \
                 {usual}"
            ),
        };
        self.notices.push(Notice::FlangeBack { field, text });
        Ok(taken)
    }
}
