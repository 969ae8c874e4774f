//! Roughness of both bodies together, from files or from a spectrum.

use std::path::{Path, PathBuf};

use schlupf::Error;
use schlupf::surface::form::Form;
use schlupf::surface::profile::Profile;
use schlupf::surface::synthesis::SelfAffine;
use schlupf::surface::{HeightMap, Lattice};

use super::{SurfaceData, SurfaceOptions, read, refusal};
use crate::error::CaseError;
use crate::place::Place;

/// Where the roughness of both bodies together comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceSource {
    /// Files or a spectrum.
    pub origin: SurfaceOrigin,
    /// Cells along x: the surface is resampled, or made with so many. As measured, or suitable, where
    /// left out.
    pub cells: Option<usize>,
    /// Of the random phases, where there are some.
    pub seed: u64,
}

/// Files or a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceOrigin {
    /// A self-affine surface.
    SelfAffine(SelfAffine),
    /// The surfaces of one or both bodies; their heights are added. A profile becomes a surface alike in
    /// all directions.
    Files {
        /// Where they are.
        files: Vec<PathBuf>,
        /// What the files do not say.
        options: SurfaceOptions,
        /// What is taken off each of them.
        form: Option<Form>,
    },
}

/// A rough surface for the micro model.
#[derive(Debug, Clone)]
pub struct RoughSurface {
    /// Heights of both surfaces together, without form.
    pub surface: HeightMap,
    /// What the reader should know about it.
    pub notices: Vec<String>,
}

/// Most cells along a side of a surface made from a profile, unless the user asks for more.
const MOST_CELLS: usize = 1024;

impl SurfaceSource {
    /// Reads or makes the surface. Errors name fields of `surface`; see [`renamed`].
    pub fn load(&self) -> Result<RoughSurface, CaseError> {
        let mut notices = Vec::new();
        let surface = match &self.origin {
            SurfaceOrigin::SelfAffine(spectrum) => self.self_affine(spectrum)?,
            SurfaceOrigin::Files { files, options, form } => {
                self.of_files(files, options, *form, &mut notices)?
            }
        };
        let surface = surface.about_its_mean();
        surface.require_rough().map_err(|error| explained(&error))?;
        Ok(RoughSurface { surface, notices })
    }

    fn self_affine(&self, spectrum: &SelfAffine) -> Result<HeightMap, CaseError> {
        let suitable = spectrum.suitable_lattice();
        let lattice = match self.cells {
            Some(cells) => Lattice::square(cells, suitable.length_x()),
            None => suitable,
        };
        spectrum.surface(lattice, self.seed).map_err(|error| explained(&error))
    }

    fn of_files(
        &self,
        files: &[PathBuf],
        options: &SurfaceOptions,
        form: Option<Form>,
        notices: &mut Vec<String>,
    ) -> Result<HeightMap, CaseError> {
        let mut data = Vec::new();
        for file in files {
            data.push((file, self.one_file(file, options, form, notices)?));
        }
        let measured = data.iter().find_map(|(_, data)| match data {
            SurfaceData::Map(map) => Some(*map.lattice()),
            SurfaceData::Profile(_) => None,
        });
        let mut sum: Option<HeightMap> = None;
        for (k, (file, data)) in data.iter().enumerate() {
            let map = match data {
                SurfaceData::Map(map) => map.clone(),
                SurfaceData::Profile(profile) => {
                    let seed = self.seed.wrapping_add(k as u64);
                    self.extended(profile, measured, seed, notices)?
                }
            };
            sum = Some(match sum {
                None => map,
                Some(sum) => sum.plus(&map).map_err(|error| of_file(file, &error))?,
            });
        }
        sum.ok_or_else(|| {
            let place = Place::Default;
            CaseError::new("surface.file", "surface.file must name a file", place)
        })
    }

    /// A file without its form, in the cells that were asked for.
    fn one_file(
        &self,
        file: &Path,
        options: &SurfaceOptions,
        form: Option<Form>,
        notices: &mut Vec<String>,
    ) -> Result<SurfaceData, CaseError> {
        let map = match read(file, options)? {
            SurfaceData::Map(map) => map,
            SurfaceData::Profile(profile) => {
                if matches!(form, Some(Form::Cylinder | Form::Sphere)) {
                    let name = file.display().to_string();
                    let reason = "is a profile, of which only a straight line can be taken off";
                    let message = format!("surface.form must be plane: {name} {reason}");
                    return Err(CaseError::new("surface.form", message, Place::File { name }));
                }
                return Ok(SurfaceData::Profile(profile));
            }
        };
        let map = match form {
            None => map,
            Some(form) => {
                let removal = map.without_form(form).map_err(|error| of_file(file, &error))?;
                if form != Form::Plane {
                    let (radius, name) = (removal.radius * 1e3, file.display());
                    notices.push(format!("{name}: a form of radius {radius:.4e} mm was taken off"));
                }
                removal.surface
            }
        };
        let Some(cells) = self.cells else { return Ok(SurfaceData::Map(map)) };
        let lattice = map.lattice();
        let rows = (lattice.rows as f64 * cells as f64 / lattice.columns as f64).round() as usize;
        let map = map.resampled(cells, rows).map_err(|error| of_file(file, &error))?;
        Ok(SurfaceData::Map(map))
    }

    /// A surface with the spectrum of a profile, on the lattice of the other surface if that is a map.
    fn extended(
        &self,
        profile: &Profile,
        lattice: Option<Lattice>,
        seed: u64,
        notices: &mut Vec<String>,
    ) -> Result<HeightMap, CaseError> {
        let points = profile.heights().len();
        let length = points as f64 * profile.spacing();
        let cells = self.cells.unwrap_or(points.min(MOST_CELLS));
        let lattice = lattice.unwrap_or(Lattice::square(cells, length));
        if lattice.spacing_x > 1.01 * profile.spacing() {
            notices.push(format!(
                "waves of the profile shorter than {:.3} µm, two cells, are left out; more cells would \
                 keep them",
                2e6 * lattice.spacing_x
            ));
        }
        profile.isotropic_surface(lattice, seed).map_err(|error| explained(&error))
    }
}

fn of_file(file: &Path, error: &Error) -> CaseError {
    refusal(&file.display().to_string(), format!("cannot be used: {error}"))
}

/// An error of the core, at no place yet.
fn explained(error: &Error) -> CaseError {
    let field = match error {
        Error::Invalid { quantity, .. } | Error::Contradiction { quantity, .. } => quantity,
        _ => "surface",
    };
    CaseError::new(field, error.to_string(), Place::Default)
}

/// The same error in terms of who asked: each name or advice of the first kind becomes that of the second.
pub fn renamed(error: CaseError, names: &[(&str, &str)]) -> CaseError {
    let translate = |text: &str| {
        names.iter().fold(text.to_owned(), |text, (general, own)| text.replace(general, own))
    };
    CaseError {
        field: translate(&error.field),
        message: translate(&error.message),
        help: error.help.as_deref().map(translate),
        ..error
    }
}
