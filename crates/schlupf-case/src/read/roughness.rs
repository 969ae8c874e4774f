//! `[contact_law.roughness]`: k_c from heights, a spectrum or files.

use std::path::Path;
use std::sync::Arc;

use schlupf::elasticity::half_space::HalfSpace;
use schlupf::interface::roughness::load_curve::LoadCurveOptions;
use schlupf::interface::roughness::micro_model::{
    MicroModel, MicroModelResult, pressures_of_patch,
};
use schlupf::interface::roughness::stiffness::{TYPICAL_GAMMA, closed_form};
use schlupf::interface::roughness::tangential_curve::SimilarBodies;
use schlupf::material::{Material, contact_modulus};
use schlupf::normal::PressureSource;
use schlupf::surface::form::Form;
use schlupf::surface::holes::Holes;
use schlupf::surface::synthesis::{Roughness, SelfAffine};
use schlupf::unwatched;

use crate::error::{CaseError, Cause};
use crate::fields::{MICRO_MODEL, OF_FILE, ROUGHNESS, readable};
use crate::law_stiffness::{LawStiffness, MicroContact, MicroKey, StiffnessOrigin};
use crate::names;
use crate::place::Place;
use crate::settings::Settings;
use crate::surface::{Cells, RoughSurface, SurfaceOptions, SurfaceOrigin, SurfaceSource};

const SECTION: &str = "contact_law.roughness.";
const RMS_HEIGHT: &str = "contact_law.roughness.rms_height";
const OF_BODIES: [&str; 2] =
    ["contact_law.roughness.rms_height_wheel", "contact_law.roughness.rms_height_rail"];
const SLOPE_FACTOR: &str = "contact_law.roughness.slope_factor";
const RMS_SLOPE: &str = "contact_law.roughness.rms_slope";
const FILE: &str = "contact_law.roughness.file";
const SECOND_FILE: &str = "contact_law.roughness.second_file";
const LONGEST: &str = "contact_law.roughness.longest_wavelength";
const ROLL_OFF: &str = "contact_law.roughness.roll_off_wavelength";
const SHORTEST: &str = "contact_law.roughness.shortest_wavelength";
const HURST: &str = "contact_law.roughness.hurst";
const CUTOFF: &str = "contact_law.roughness.cutoff_wavelength";
const FORM: &str = "contact_law.roughness.form";
const PRESSURES: &str = "contact_law.roughness.pressures";
const HARDNESS: &str = "contact_law.roughness.hardness";

/// Hurst exponent and seed where none is given.
const TYPICAL_HURST: f64 = 0.8;
const FIRST_SEED: u64 = 1;

/// What of a case decides its k_c.
#[derive(Debug)]
pub struct Circumstances<'a> {
    /// Where relative paths start.
    pub folder: &'a Path,
    /// Wheel and rail.
    pub materials: [&'a Material; 2],
    /// The pressure of the patch.
    pub normal: &'a dyn PressureSource,
    /// A micro model that may be the same.
    pub solved: Option<&'a Arc<MicroContact>>,
}

/// What a micro model needs.
#[derive(Debug, Clone)]
pub struct MicroRequest {
    /// What its normal contact depends on.
    pub key: MicroKey,
    /// Friction and Poisson's ratio.
    pub bodies: SimilarBodies,
    /// Mean pressures of the tangential curves, in Pa.
    pub mean_pressures: Vec<f64>,
}

/// k_c from the roughness; `None` where none is given.
pub fn stiffness(
    settings: &Settings,
    at: &Circumstances,
) -> Result<Option<LawStiffness>, CaseError> {
    if let Some(request) = request(settings, at)? {
        let micro = micro_model(settings, request, at.solved)?;
        let stiffness = micro.result.stiffness.common.stiffness;
        let origin = StiffnessOrigin::MicroModel(Arc::new(micro));
        return Ok(Some(LawStiffness { stiffness, origin }));
    }
    let Some(given) = ROUGHNESS.iter().copied().find(|path| settings.is_given(path)) else {
        return Ok(None);
    };
    from_height(settings, &bodies(settings, at)?, given).map(Some)
}

/// What the micro model needs; `None` where nothing asks for one.
pub fn request(settings: &Settings, at: &Circumstances) -> Result<Option<MicroRequest>, CaseError> {
    let source = if settings.is_given(FILE) {
        files(settings, at.folder)?
    } else if let Some(of_file) = OF_FILE.iter().find(|path| settings.is_given(path)) {
        return Err(settings.missing_beside(FILE, of_file));
    } else if let Some(micro) = MICRO_MODEL.iter().find(|path| settings.is_given(path)) {
        spectrum(settings, micro)?
    } else {
        return Ok(None);
    };
    let mean_pressures = mean_pressures(settings, at.normal)?;
    let largest_pressure = mean_pressures.iter().copied().fold(0.0, f64::max);
    let key = MicroKey {
        source,
        contact_modulus: contact_modulus(at.materials[0], at.materials[1]),
        hardness: hardness(settings, largest_pressure)?,
        largest_pressure,
    };
    Ok(Some(MicroRequest { key, bodies: bodies(settings, at)?, mean_pressures }))
}

/// Friction, and the combined Poisson's ratio: with it the ratio of tangential to normal compliance is
/// that of two different bodies, too.
fn bodies(settings: &Settings, at: &Circumstances) -> Result<SimilarBodies, CaseError> {
    let combined = HalfSpace::new(at.materials[0], at.materials[1]);
    let combined = combined.map_err(|error| settings.explain(&error))?;
    Ok(SimilarBodies {
        friction_coefficient: settings.number("friction.coefficient")?,
        poisson_ratio: combined.poisson_ratio(),
    })
}

/// h_rms of both surfaces together, √(h₁² + h₂²), in m; `None` where no height is given.
fn rms_height(settings: &Settings) -> Result<Option<f64>, CaseError> {
    if let Some(height) = settings.optional_number(RMS_HEIGHT)? {
        return Ok(Some(height));
    }
    let [wheel, rail] = OF_BODIES.map(|path| settings.optional_number(path));
    Ok(match (wheel?, rail?) {
        (None, None) => None,
        (wheel, rail) => Some(wheel.unwrap_or(0.0).hypot(rail.unwrap_or(0.0))),
    })
}

fn from_height(
    settings: &Settings,
    bodies: &SimilarBodies,
    given: &str,
) -> Result<LawStiffness, CaseError> {
    let height = rms_height(settings)?.ok_or_else(|| settings.missing_beside(RMS_HEIGHT, given))?;
    let slope_factor = settings.optional_number(SLOPE_FACTOR)?.unwrap_or(TYPICAL_GAMMA);
    let stiffness = closed_form(bodies, slope_factor * height);
    let origin = StiffnessOrigin::ClosedForm { rms_height: height, slope_factor };
    Ok(LawStiffness { stiffness, origin })
}

fn spectrum(settings: &Settings, given: &str) -> Result<SurfaceSource, CaseError> {
    let needed = |path: &'static str| {
        settings.optional_number(path)?.ok_or_else(|| settings.missing_beside(path, given))
    };
    let longest_wavelength = needed(LONGEST)?;
    let shortest_wavelength = needed(SHORTEST)?;
    let roughness = match (settings.optional_number(RMS_SLOPE)?, rms_height(settings)?) {
        (Some(slope), _) => Roughness::Gradient(slope),
        (None, Some(height)) => Roughness::Height(height),
        (None, None) => return Err(settings.missing_beside(RMS_HEIGHT, given)),
    };
    if longest_wavelength < shortest_wavelength {
        let [longest, shortest] = [longest_wavelength, shortest_wavelength].map(readable);
        let message = format!(
            "{} must be at least the shortest wavelength, {shortest} m, but is {longest} m",
            settings.name(LONGEST)
        );
        return Err(settings.error(LONGEST, message));
    }
    let spectrum = SelfAffine {
        roughness,
        hurst_exponent: settings.optional_number(HURST)?.unwrap_or(TYPICAL_HURST),
        longest_wavelength,
        roll_off_wavelength: settings.optional_number(ROLL_OFF)?.unwrap_or(longest_wavelength),
        shortest_wavelength,
    };
    source(settings, SurfaceOrigin::SelfAffine(spectrum))
}

fn files(settings: &Settings, folder: &Path) -> Result<SurfaceSource, CaseError> {
    let given = |path: &str| settings.is_given(path);
    let yes = |path: &str| Ok(given(path) && settings.flag(path)?);
    let text = |path: &str| if given(path) { settings.text(path).map(Some) } else { Ok(None) };
    let spacing = settings.optional_number("contact_law.roughness.spacing")?;
    let fill = yes("contact_law.roughness.fill_holes")?;
    let square = yes("contact_law.roughness.square_cells")?;
    let form = match if given(FORM) { settings.choice(FORM)? } else { "plane" } {
        "none" => None,
        "cylinder" => Some(Form::Cylinder),
        "sphere" => Some(Form::Sphere),
        _ => Some(Form::Plane),
    };
    let options = SurfaceOptions {
        unit: text("contact_law.roughness.unit")?,
        spacing: spacing.map(|spacing| [spacing, spacing]),
        holes: if fill { Holes::Fill } else { Holes::Refuse },
        cells: if square { Cells::MakeSquare } else { Cells::RefuseNonSquare },
    };
    let cutoff = settings.optional_number(CUTOFF)?;
    let second = text(SECOND_FILE)?;
    let files = [settings.text(FILE)?].into_iter().chain(second);
    let files = files.map(|file| folder.join(file)).collect();
    source(settings, SurfaceOrigin::Files { files, options, form, cutoff })
}

fn source(settings: &Settings, origin: SurfaceOrigin) -> Result<SurfaceSource, CaseError> {
    let number = |path| settings.optional_number(path);
    let cells = number("contact_law.roughness.cells")?.map(|cells| cells as usize);
    let seed = number("contact_law.roughness.seed")?.map_or(FIRST_SEED, |seed| seed as u64);
    Ok(SurfaceSource { origin, cells, seed })
}

/// The solved micro model; its normal contact is taken over where it is the same.
fn micro_model(
    settings: &Settings,
    request: MicroRequest,
    solved: Option<&Arc<MicroContact>>,
) -> Result<MicroContact, CaseError> {
    let explain = |error: schlupf::Error| explain(settings, &error);
    let MicroRequest { key, bodies, mean_pressures } = request;
    if let Some(solved) = solved.filter(|solved| solved.serves(&key, &mean_pressures)) {
        let (statistics, normal) = (solved.result.statistics, solved.result.normal.clone());
        let result = MicroModelResult::new(statistics, normal, &bodies, &mean_pressures);
        let (result, notices) = (result.map_err(explain)?, solved.notices.clone());
        return Ok(MicroContact { key, result, cells: solved.cells, notices });
    }
    let rough = load(settings, &key.source)?;
    let cells = rough.surface.lattice().len();
    let model = MicroModel {
        surface: rough.surface,
        contact_modulus: key.contact_modulus,
        bodies,
        hardness: key.hardness,
        mean_pressures,
    };
    let result = model.solve(&LoadCurveOptions::default(), &unwatched).map_err(explain)?;
    Ok(MicroContact { key, result, cells, notices: rough.notices })
}

/// Reads or makes the surface.
pub fn load(settings: &Settings, source: &SurfaceSource) -> Result<RoughSurface, CaseError> {
    source.load(settings.names()).map_err(|error| placed(settings, error))
}

/// Mean pressures of the tangential curves, in Pa.
fn mean_pressures(settings: &Settings, normal: &dyn PressureSource) -> Result<Vec<f64>, CaseError> {
    match settings.series(PRESSURES) {
        Some([]) => {
            let message =
                format!("{} must have at least one entry, but is empty", settings.name(PRESSURES));
            Err(settings.error(PRESSURES, message))
        }
        Some(pressures) => Ok(pressures.to_vec()),
        None => {
            let contact = normal.normal_contact(None).map_err(|error| settings.explain(&error))?;
            Ok(pressures_of_patch(contact.summary.peak_pressure).to_vec())
        }
    }
}

/// The hardness (in Pa), which must be more than all of the surface carries.
fn hardness(settings: &Settings, largest_pressure: f64) -> Result<f64, CaseError> {
    let Some(hardness) = settings.optional_number(HARDNESS)? else { return Ok(f64::INFINITY) };
    if hardness > largest_pressure {
        return Ok(hardness);
    }
    let message = format!(
        "{} must be above the largest mean pressure, {} Pa, but is {} Pa",
        settings.name(HARDNESS),
        readable(largest_pressure),
        readable(hardness)
    );
    Err(settings.error(HARDNESS, message))
}

/// An error of a surface, in terms of the case. One in a line of the file stays there; all others are at
/// the field that names it.
fn placed(settings: &Settings, error: CaseError) -> CaseError {
    let place = match error.place {
        Place::Text { .. } => error.place,
        _ => place_of(settings, &error.field),
    };
    CaseError { place, cause: Cause::Input, ..error }
}

fn place_of(settings: &Settings, field: &str) -> Place {
    let fields = [field, FILE, SHORTEST].into_iter().chain(ROUGHNESS.iter().copied());
    let mut given = fields.filter(|path| settings.is_given(path));
    given.next().map_or(Place::Default, |path| settings.place(path))
}

/// An error of the micro model, at the place of the roughness if it is about that.
pub fn explain(settings: &Settings, error: &schlupf::Error) -> CaseError {
    let field = names::path(error.quantity()).unwrap_or_default();
    if !field.starts_with(SECTION) {
        return settings.explain(error);
    }
    let message = format!("the micro model of the roughness: {}", error.text(&settings.names()));
    placed(settings, CaseError::new(field, message, Place::Default))
}
