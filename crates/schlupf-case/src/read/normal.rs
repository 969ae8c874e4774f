//! `[normal]`.

use std::sync::Arc;

use schlupf::bodies::{Material, contact_modulus};
use schlupf::normal::profile::{Profile, UndeformedDistance, relative_radius};
use schlupf::normal::{Ellipse, Hertz, Line, PressureSource, PressureTable, Tabulated};

use super::bodies::{RAIL, WHEEL, radii};
use super::wheel_rail::refuse_micro_model;
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::choice::NormalModel;
use crate::settings::Settings;
use crate::tables::{self, NpyFile};

const FILE: FieldPath = field!("normal.file");
const LOAD: FieldPath = field!("normal.load");
const APPROACH: FieldPath = field!("normal.approach");
const SPACINGS: [FieldPath; 2] = fields!["normal.spacing_x", "normal.spacing_y"];

/// The source of the normal pressure.
pub fn source(
    settings: &Settings,
    [wheel, rail]: [&Material; 2],
) -> Result<Arc<dyn PressureSource>, CaseError> {
    Ok(match settings.chosen(field!("normal.model"))? {
        NormalModel::Hertz => Arc::new(hertz(settings, contact_modulus(wheel, rail))?),
        NormalModel::Line => Arc::new(line(settings, contact_modulus(wheel, rail))?),
        NormalModel::Ellipse => Arc::new(ellipse(settings)?),
        NormalModel::Tabulated => Arc::new(tabulated(settings)?),
        NormalModel::Profile => Arc::new(profile(settings, contact_modulus(wheel, rail))?),
        NormalModel::WheelRail => return Err(refuse_micro_model(settings)),
    })
}

fn hertz(settings: &Settings, contact_modulus: f64) -> Result<Hertz, CaseError> {
    let (wheel, rail) = (radii(settings, &WHEEL)?, radii(settings, &RAIL)?);
    let hertz = match settings.optional_number(APPROACH)? {
        Some(approach) => Hertz::from_approach(wheel, rail, contact_modulus, approach),
        None => Hertz::new(wheel, rail, contact_modulus, settings.number(LOAD)?),
    };
    hertz.map_err(|error| settings.explain(&error))
}

fn line(settings: &Settings, contact_modulus: f64) -> Result<Line, CaseError> {
    let radii = [radii(settings, &WHEEL)?, radii(settings, &RAIL)?].map(|body| body.x);
    let length = settings.number(field!("normal.length"))?;
    let line = match settings.optional_number(APPROACH)? {
        Some(approach) => Line::from_approach(radii, length, contact_modulus, approach),
        None => Line::new(radii, length, contact_modulus, given_load(settings)?),
    };
    line.map_err(|error| settings.explain(&error))
}

/// The load, which has no default.
fn given_load(settings: &Settings) -> Result<f64, CaseError> {
    if settings.is_given(LOAD) {
        return settings.number(LOAD);
    }
    Err(settings.missing_beside(LOAD, field!("normal.model")))
}

fn ellipse(settings: &Settings) -> Result<Ellipse, CaseError> {
    let a = settings.number(field!("normal.semi_axis_x"))?;
    let b = settings.number(field!("normal.semi_axis_y"))?;
    let ellipse = match settings.optional_number(field!("normal.peak_pressure"))? {
        Some(peak_pressure) => Ellipse::from_peak_pressure(a, b, peak_pressure),
        None => Ellipse::from_load(a, b, given_load(settings)?),
    };
    ellipse.map_err(|error| settings.explain(&error))
}

fn tabulated(settings: &Settings) -> Result<Tabulated, CaseError> {
    let table = table(settings)?;
    let load = settings.optional_number(field!("normal.load"))?;
    Tabulated::new(table, load).map_err(|error| settings.explain(&error))
}

fn table(settings: &Settings) -> Result<PressureTable, CaseError> {
    let file = File::read(settings)?;
    match file.npy(settings) {
        Some(npy) => tables::pressure_from_npy(&npy),
        None => tables::pressure_from_csv(file.name, file.bytes),
    }
}

fn profile(settings: &Settings, contact_modulus: f64) -> Result<Profile, CaseError> {
    let distance = || distance(settings);
    let cells = settings.count(field!("normal.cells"))?;
    let profile = match settings.optional_number(APPROACH)? {
        Some(approach) => Profile::from_approach(distance()?, contact_modulus, approach, cells),
        None => Profile::new(distance()?, contact_modulus, given_load(settings)?, cells),
    };
    profile.map_err(|error| settings.explain(&error))
}

fn distance(settings: &Settings) -> Result<UndeformedDistance, CaseError> {
    let file = File::read(settings)?;
    if let Some(npy) = file.npy(settings) {
        return tables::distance_from_npy(&npy);
    }
    let length = || settings.number(field!("normal.length"));
    tables::distance_from_csv(file.name, file.bytes, || rolling_radius(settings), length)
}

/// Relative radius along rolling of both bodies, in m.
fn rolling_radius(settings: &Settings) -> Result<f64, CaseError> {
    let radii = [radii(settings, &WHEEL)?, radii(settings, &RAIL)?];
    relative_radius(radii.map(|body| body.x)).map_err(|error| settings.explain(&error))
}

/// A file with values on a lattice or a line.
struct File {
    name: String,
    bytes: Vec<u8>,
    /// Along x and y (in m), of an .npy file.
    spacings: Option<[f64; 2]>,
    start: Option<[f64; 2]>,
}

impl File {
    /// It as an .npy file, if it is one.
    fn npy(&self, settings: &Settings) -> Option<NpyFile<'_>> {
        let (name, bytes, place) = (&self.name, &self.bytes, settings.place(FILE));
        let start = self.start;
        self.spacings.map(|spacings| NpyFile { name, bytes, spacings, start, place })
    }

    fn read(settings: &Settings) -> Result<Self, CaseError> {
        let (name, bytes) = settings.read_file(FILE)?;
        let file = settings.input_file(FILE)?;
        let own = file.spacings();
        if file.ending() == "npy" && own.is_none() {
            let spacing = |k: usize| {
                let given = settings.optional_number(SPACINGS[k])?;
                given.ok_or_else(|| settings.missing_beside(SPACINGS[k], FILE))
            };
            let spacings = Some([spacing(0)?, spacing(1)?]);
            return Ok(Self { name, bytes, spacings, start: None });
        }
        if let Some(spacing) = SPACINGS.into_iter().find(|path| settings.is_given(*path)) {
            let message = format!(
                "{spacing} must be given only with an array without positions, but is {} with {}, which holds its own positions",
                settings.shown(spacing),
                settings.shown(FILE)
            );
            return Err(settings.error(spacing, message));
        }
        Ok(Self { name, bytes, spacings: own, start: file.start() })
    }
}
