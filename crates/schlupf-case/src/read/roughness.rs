//! `[contact_law.roughness]`: k_c from heights, a spectrum or files.

use std::sync::Arc;

use schlupf::Watch;
use schlupf::bodies::{Material, contact_modulus};
use schlupf::elasticity::HalfSpace;
use schlupf::interface::roughness::tangential_curve::SimilarBodies;
use schlupf::interface::roughness::{
    LoadCurveOptions, MicroModel, MicroModelResult, TYPICAL_GAMMA, closed_form, pressures_of_patch,
};
use schlupf::normal::NormalContact;
use schlupf::surface::Holes;
use schlupf::surface::form::Form;
use schlupf::surface::spectrum::{RadialSpectrum, Window};
use schlupf::surface::synthesis::{Roughness, SelfAffine};

use crate::error::CaseError;
use crate::fields::choice::FormTakenOff;
use crate::fields::{self, MICRO_MODEL, OF_FILE, ROUGHNESS, readable};
use crate::law_stiffness::{LawStiffness, MicroContact, MicroKey, StiffnessOrigin};
use crate::place::Place;
use crate::settings::Settings;
use crate::surface::{Cells, RoughSurface, SurfaceOptions, SurfaceOrigin, SurfaceSource};
use crate::{FieldPath, names};

const SECTION: &str = "contact_law.roughness.";
const RMS_HEIGHT: FieldPath = field!("contact_law.roughness.rms_height");
const OF_BODIES: [FieldPath; 2] =
    fields!["contact_law.roughness.rms_height_wheel", "contact_law.roughness.rms_height_rail"];
const SLOPE_FACTOR: FieldPath = field!("contact_law.roughness.slope_factor");
const RMS_SLOPE: FieldPath = field!("contact_law.roughness.rms_slope");
const FILE: FieldPath = field!("contact_law.roughness.file");
const SECOND_FILE: FieldPath = field!("contact_law.roughness.second_file");
const LONGEST: FieldPath = field!("contact_law.roughness.longest_wavelength");
const ROLL_OFF: FieldPath = field!("contact_law.roughness.roll_off_wavelength");
const SHORTEST: FieldPath = field!("contact_law.roughness.shortest_wavelength");
const HURST: FieldPath = field!("contact_law.roughness.hurst");
const CUTOFF: FieldPath = field!("contact_law.roughness.cutoff_wavelength");
const FORM: FieldPath = field!("contact_law.roughness.form");
const PRESSURES: FieldPath = field!("contact_law.roughness.pressures");
const HARDNESS: FieldPath = field!("contact_law.roughness.hardness");

/// Hurst exponent and seed where none is given.
const TYPICAL_HURST: f64 = 0.8;
const FIRST_SEED: u64 = 1;

/// k_c as far as it is known without solving.
#[derive(Debug, Clone)]
pub enum OfRoughness {
    /// This.
    Known(LawStiffness),
    /// What a micro model finds.
    MicroModel(MicroRequest),
}

/// What a micro model needs, as far as it is known without the patch.
#[derive(Debug, Clone)]
pub struct MicroRequest {
    source: SurfaceSource,
    /// E*, in Pa.
    contact_modulus: f64,
    /// In Pa.
    hardness: Option<f64>,
    bodies: SimilarBodies,
    /// In Pa; those of the patch where none are given.
    mean_pressures: Option<Vec<f64>>,
}

/// All that a micro model needs.
#[derive(Debug, Clone)]
pub struct MicroCase {
    /// What its normal contact depends on.
    pub key: MicroKey,
    /// Friction and Poisson's ratio.
    pub bodies: SimilarBodies,
    /// Mean pressures of the tangential curves, in Pa.
    pub mean_pressures: Vec<f64>,
}

/// k_c from the roughness, or what finds it; `None` where no roughness is given.
pub fn stiffness(
    settings: &Settings,
    materials: [&Material; 2],
) -> Result<Option<OfRoughness>, CaseError> {
    if let Some(request) = request(settings, materials)? {
        return Ok(Some(OfRoughness::MicroModel(request)));
    }
    let Some(given) = ROUGHNESS.iter().copied().find(|path| settings.is_given(*path)) else {
        return Ok(None);
    };
    let known = from_height(settings, &bodies(settings, materials)?, given)?;
    Ok(Some(OfRoughness::Known(known)))
}

/// What the micro model needs; `None` where nothing asks for one.
pub fn request(
    settings: &Settings,
    materials: [&Material; 2],
) -> Result<Option<MicroRequest>, CaseError> {
    let source = if settings.is_given(FILE) {
        files(settings)?
    } else if let Some(of_file) = OF_FILE.iter().copied().find(|path| settings.is_given(*path)) {
        return Err(settings.missing_beside(FILE, of_file));
    } else if let Some(micro) = MICRO_MODEL.iter().copied().find(|path| settings.is_given(*path)) {
        spectrum(settings, micro)?
    } else {
        return Ok(None);
    };
    let request = MicroRequest {
        source,
        contact_modulus: contact_modulus(materials[0], materials[1]),
        hardness: settings.optional_number(HARDNESS)?,
        bodies: bodies(settings, materials)?,
        mean_pressures: mean_pressures(settings)?,
    };
    if let Some(pressures) = &request.mean_pressures {
        request.at(settings, pressures)?;
    }
    Ok(Some(request))
}

impl MicroRequest {
    /// All that is needed, the pressures being those of the patch where none are given.
    pub fn on(
        &self,
        settings: &Settings,
        patch: impl FnOnce() -> Result<NormalContact, CaseError>,
    ) -> Result<MicroCase, CaseError> {
        match &self.mean_pressures {
            Some(pressures) => self.at(settings, pressures),
            None => self.at(settings, &pressures_of_patch(patch()?.summary.peak_pressure)),
        }
    }

    fn at(&self, settings: &Settings, mean_pressures: &[f64]) -> Result<MicroCase, CaseError> {
        let largest_pressure = mean_pressures.iter().copied().fold(0.0, f64::max);
        if let Some(hardness) = self.hardness {
            check_hardness(settings, hardness, largest_pressure)?;
        }
        let key = MicroKey {
            source: self.source.clone(),
            contact_modulus: self.contact_modulus,
            hardness: self.hardness.unwrap_or(f64::INFINITY),
            largest_pressure,
        };
        Ok(MicroCase { key, bodies: self.bodies, mean_pressures: mean_pressures.to_vec() })
    }
}

/// Friction, and the combined Poisson's ratio: with it the ratio of tangential to normal compliance
/// is that of two different bodies, too.
fn bodies(settings: &Settings, materials: [&Material; 2]) -> Result<SimilarBodies, CaseError> {
    let combined = HalfSpace::new(materials[0], materials[1]);
    let combined = combined.map_err(|error| settings.explain(&error))?;
    Ok(SimilarBodies {
        friction_coefficient: settings.number(field!("friction.coefficient"))?,
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
    given: FieldPath,
) -> Result<LawStiffness, CaseError> {
    let height = rms_height(settings)?.ok_or_else(|| settings.missing_beside(RMS_HEIGHT, given))?;
    let slope_factor = settings.optional_number(SLOPE_FACTOR)?.unwrap_or(TYPICAL_GAMMA);
    let stiffness = closed_form(bodies, slope_factor * height);
    let origin = StiffnessOrigin::ClosedForm { rms_height: height, slope_factor };
    Ok(LawStiffness { stiffness, origin })
}

fn spectrum(settings: &Settings, given: FieldPath) -> Result<SurfaceSource, CaseError> {
    let needed = |path: FieldPath| {
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

fn files(settings: &Settings) -> Result<SurfaceSource, CaseError> {
    let given = |path: FieldPath| settings.is_given(path);
    let yes = |path: FieldPath| Ok(given(path) && settings.flag(path)?);
    let text = |path: FieldPath| if given(path) { settings.text(path).map(Some) } else { Ok(None) };
    let spacing = settings.optional_number(field!("contact_law.roughness.spacing"))?;
    let fill = yes(field!("contact_law.roughness.fill_holes"))?;
    let square = yes(field!("contact_law.roughness.square_cells"))?;
    let form = if given(FORM) { settings.chosen(FORM)? } else { FormTakenOff::Plane };
    let form = match form {
        FormTakenOff::Plane => Some(Form::Plane),
        FormTakenOff::Cylinder => Some(Form::Cylinder),
        FormTakenOff::Sphere => Some(Form::Sphere),
        FormTakenOff::Nothing => None,
    };
    let options = SurfaceOptions {
        unit: text(field!("contact_law.roughness.unit"))?,
        spacing: spacing.map(|spacing| [spacing, spacing]),
        holes: if fill { Holes::Fill } else { Holes::Refuse },
        cells: if square { Cells::MakeSquare } else { Cells::RefuseNonSquare },
    };
    let cutoff = settings.optional_number(CUTOFF)?;
    let mut files = vec![settings.input_file(FILE)?];
    if given(SECOND_FILE) {
        files.push(settings.input_file(SECOND_FILE)?);
    }
    source(settings, SurfaceOrigin::Files { files, options, form, cutoff })
}

fn source(settings: &Settings, origin: SurfaceOrigin) -> Result<SurfaceSource, CaseError> {
    let number = |path| settings.optional_number(path);
    let cells = number(field!("contact_law.roughness.cells"))?.map(|cells| cells as usize);
    let seed = number(field!("contact_law.roughness.seed"))?.map_or(FIRST_SEED, |seed| seed as u64);
    Ok(SurfaceSource { origin, cells, seed })
}

/// The solved micro model; its normal contact is taken over where it is the same.
pub fn solve(
    settings: &Settings,
    case: MicroCase,
    solved: Option<&Arc<MicroContact>>,
    watch: Watch,
) -> Result<LawStiffness, CaseError> {
    let micro = micro_contact(settings, case, solved, watch)?;
    let stiffness = micro.result.stiffness.common.stiffness;
    Ok(LawStiffness { stiffness, origin: StiffnessOrigin::MicroModel(Arc::new(micro)) })
}

fn micro_contact(
    settings: &Settings,
    case: MicroCase,
    solved: Option<&Arc<MicroContact>>,
    watch: Watch,
) -> Result<MicroContact, CaseError> {
    let explain = |error: schlupf::Error| explain(settings, &error);
    let MicroCase { key, bodies, mean_pressures } = case;
    if let Some(solved) = solved.filter(|solved| solved.serves(&key, &mean_pressures)) {
        let (statistics, normal) = (solved.result.statistics, solved.result.normal.clone());
        let result = MicroModelResult::new(statistics, normal, &bodies, &mean_pressures);
        let (result, notices) = (result.map_err(explain)?, solved.notices.clone());
        let (cells, spectrum) = (solved.cells, Arc::clone(&solved.spectrum));
        return Ok(MicroContact { key, result, cells, spectrum, notices });
    }
    let rough = load(settings, &key.source)?;
    let cells = rough.surface.lattice().len();
    let spectrum = RadialSpectrum::of(&rough.surface, Window::of(&rough.surface));
    let model = MicroModel {
        surface: rough.surface,
        contact_modulus: key.contact_modulus,
        bodies,
        hardness: key.hardness,
        mean_pressures,
    };
    let result = model.solve(&LoadCurveOptions::default(), watch).map_err(explain)?;
    Ok(MicroContact { key, result, cells, spectrum: Arc::new(spectrum), notices: rough.notices })
}

/// Reads or makes the surface.
pub fn load(settings: &Settings, source: &SurfaceSource) -> Result<RoughSurface, CaseError> {
    source.load(settings.names()).map_err(|error| placed(settings, error))
}

/// Mean pressures of the tangential curves (in Pa), where they are given.
fn mean_pressures(settings: &Settings) -> Result<Option<Vec<f64>>, CaseError> {
    let given = settings.series(PRESSURES);
    if given.is_some_and(<[f64]>::is_empty) {
        let message =
            format!("{} must have at least one entry, but is empty", settings.name(PRESSURES));
        return Err(settings.error(PRESSURES, message));
    }
    Ok(given.map(<[f64]>::to_vec))
}

/// Checks that the hardness (in Pa) is more than all of the surface carries.
fn check_hardness(
    settings: &Settings,
    hardness: f64,
    largest_pressure: f64,
) -> Result<(), CaseError> {
    if hardness > largest_pressure {
        return Ok(());
    }
    let message = format!(
        "{} must be above the largest mean pressure, {} Pa, but is {} Pa",
        settings.name(HARDNESS),
        readable(largest_pressure),
        readable(hardness)
    );
    Err(settings.error(HARDNESS, message))
}

/// An error of a surface, in terms of the case. One in a line of the file stays there; all others
/// are at the field that names it.
fn placed(settings: &Settings, error: CaseError) -> CaseError {
    let place = match error.place {
        Place::Text { .. } => error.place,
        Place::File { .. } | Place::Override { .. } | Place::Default => {
            place_of(settings, &error.field)
        }
    };
    CaseError { place, ..error }
}

fn place_of(settings: &Settings, field: &str) -> Place {
    let own = fields::find(field).map(|field| field.path);
    let others = [FILE, SHORTEST].into_iter().chain(ROUGHNESS.iter().copied());
    let mut given = own.into_iter().chain(others).filter(|path| settings.is_given(*path));
    given.next().map_or(Place::Default, |path| settings.place(path))
}

/// An error of the micro model, at the place of the roughness if it is about that.
pub fn explain(settings: &Settings, error: &schlupf::Error) -> CaseError {
    let field = names::path(error.quantity());
    if !field.starts_with(SECTION) {
        return settings.explain(error);
    }
    let message = error.text(&settings.names());
    placed(settings, CaseError::new(field, message, Place::Default))
}
