//! Roughness of both bodies together, from files or from a spectrum.

use std::path::Path;

use schlupf::Error;
use schlupf::surface::form::{Form, FormRemoval};
use schlupf::surface::spectrum::{RadialSpectrum, Window, spectral_gradient};
use schlupf::surface::synthesis::{Roughness, SelfAffine};
use schlupf::surface::{HeightMap, Lattice, LineSpectrum};

use super::{FILE, MeasuredSurface, Reading, SurfaceData, SurfaceOptions};
use crate::FieldPath;
use crate::error::CaseError;
use crate::fields::readable;
use crate::files::InputFile;
use crate::names::FieldNames;
use crate::notice::Notice;
use crate::place::Place;

const RMS_SLOPE: FieldPath = field!("contact_law.roughness.rms_slope");
const SECOND_FILE: FieldPath = field!("contact_law.roughness.second_file");
const RMS_HEIGHT: FieldPath = field!("contact_law.roughness.rms_height");

/// What is removed from a measured surface.
#[derive(Clone, Copy)]
struct TakenOff {
    form: Option<Form>,
    /// In m.
    cutoff: Option<f64>,
}

/// Where the roughness of both bodies together comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceSource {
    /// Files or a spectrum.
    pub origin: SurfaceOrigin,
    /// Cells along x: the surface is resampled, or made with so many. As measured, or suitable,
    /// where left out.
    pub cells: Option<usize>,
    /// Of the random phases, where there are some.
    pub seed: u64,
}

/// Files or a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceOrigin {
    /// A self-affine surface.
    SelfAffine(SelfAffine),
    /// The surfaces of one or both bodies; their heights are added. A profile becomes a surface
    /// alike in all directions.
    Files {
        /// Where they are.
        files: Vec<InputFile>,
        /// What the files do not say.
        options: SurfaceOptions,
        /// What is removed from each of them.
        form: Option<Form>,
        /// Longer waves than this are removed after that (in m).
        cutoff: Option<f64>,
    },
}

/// A rough surface for the micro model.
#[derive(Debug, Clone)]
pub struct RoughSurface {
    /// Heights of both surfaces together, without form.
    pub surface: HeightMap,
    /// How it was made of what was given.
    pub remarks: Vec<String>,
    /// What is doubtful about it.
    pub notices: Vec<Notice>,
}

/// The micro model takes slopes for small: root mean square gradients from which that is doubtful,
/// and from which something else is wrong; dimensionless.
const DOUBTFUL_GRADIENT: f64 = 0.5;
const LARGEST_GRADIENT: f64 = 2.0;

/// From this part of filled points on a surface is doubtful, dimensionless.
const DOUBTFUL_FILLING: f64 = 0.05;

/// Waves that fit into a piece, at least, and the part of the variance that longer ones may have;
/// dimensionless.
const WAVES_ACROSS: f64 = 5.0;
const MOST_IN_LONG_WAVES: f64 = 0.5;

/// Range of heights of a tilt that is told, over that of the surface without it.
const VISIBLE_TILT: f64 = 0.1;

const NO_FORM: &str = "is a spectrum, which has no cylinder or sphere to remove";

/// Most cells along a side of a surface made from a line, unless the user asks for more.
const MOST_CELLS: usize = 1024;

impl SurfaceSource {
    /// Reads or makes the surface. Errors call the fields by these names.
    pub fn load(&self, names: FieldNames) -> Result<RoughSurface, CaseError> {
        let mut said = Said::default();
        let surface = match &self.origin {
            SurfaceOrigin::SelfAffine(spectrum) => self.self_affine(spectrum, names)?,
            SurfaceOrigin::Files { files, options, form, cutoff } => {
                let taken_off = TakenOff { form: *form, cutoff: *cutoff };
                let how = Reading { options, names, field: FILE };
                self.of_files(files, how, taken_off, &mut said)?
            }
        };
        let surface = surface.about_its_mean();
        let how = Reading { options: &SurfaceOptions::default(), names, field: FILE };
        surface.require_rough().map_err(|error| how.explained(&error))?;
        said.notices.extend(self.check_gradient(&surface, names)?);
        // A spectrum is that of many pieces.
        said.notices.extend(self.check_size(&surface).filter(|_| !said.has_spectrum));
        Ok(RoughSurface { surface, remarks: said.remarks, notices: said.notices })
    }

    /// Refuses a surface that is too steep to be one; what to say of one that is nearly so.
    fn check_gradient(
        &self,
        surface: &HeightMap,
        names: FieldNames,
    ) -> Result<Option<Notice>, CaseError> {
        let gradient = spectral_gradient(surface);
        if gradient <= DOUBTFUL_GRADIENT {
            return Ok(None);
        }
        if gradient <= LARGEST_GRADIENT {
            return Ok(Some(Notice::SteepSurface { gradient }));
        }
        let is = readable(gradient);
        let [low, high] = surface.range().map(|height| readable(height * 1e6));
        let (field, cause) = match &self.origin {
            SurfaceOrigin::SelfAffine(SelfAffine { roughness: Roughness::Gradient(_), .. }) => {
                (RMS_SLOPE, "")
            }
            SurfaceOrigin::SelfAffine(_) => {
                (RMS_HEIGHT, "; is it too high for the shortest wavelength?")
            }
            SurfaceOrigin::Files { .. } => (
                FILE,
                "; is the unit of the heights or the spacing of the points another, or do single heights \
                 stand for missing values?",
            ),
        };
        let message = format!(
            "{} must have a root mean square gradient of at most {LARGEST_GRADIENT}, but has {is} with \
             heights from {low} to {high} µm{cause}",
            names.name(field)
        );
        Err(CaseError::new(field, message, Place::Default))
    }

    /// What to say of a measured piece that is too small to be one of many.
    fn check_size(&self, surface: &HeightMap) -> Option<Notice> {
        let is_measured = matches!(self.origin, SurfaceOrigin::Files { .. });
        let lattice = surface.lattice();
        let part = lattice.length_x().min(lattice.length_y()) / WAVES_ACROSS;
        let spectrum = RadialSpectrum::of(surface, Window::of(surface));
        let share = spectrum.share_of_longer(part);
        (is_measured && share > MOST_IN_LONG_WAVES).then_some(Notice::SmallPiece { share })
    }

    fn self_affine(
        &self,
        spectrum: &SelfAffine,
        names: FieldNames,
    ) -> Result<HeightMap, CaseError> {
        let how = Reading { options: &SurfaceOptions::default(), names, field: FILE };
        let suitable = spectrum.suitable_lattice();
        let lattice = match self.cells {
            Some(cells) => Lattice::square(cells, suitable.length_x()),
            None => suitable,
        };
        spectrum.surface(lattice, self.seed).map_err(|error| how.explained(&error))
    }

    fn of_files(
        &self,
        files: &[InputFile],
        how: Reading,
        taken_off: TakenOff,
        said: &mut Said,
    ) -> Result<HeightMap, CaseError> {
        let mut data = Vec::new();
        for (file, field) in files.iter().zip([FILE, SECOND_FILE]) {
            let how = Reading { field, ..how };
            data.push((file.path(), how, self.one_file(file, how, taken_off, said)?));
        }
        let measured = data.iter().find_map(|(.., data)| match data {
            SurfaceData::Map(map) => Some(*map.lattice()),
            SurfaceData::Profile(_) | SurfaceData::Spectrum(_) => None,
        });
        let mut sum: Option<HeightMap> = None;
        for (k, (file, how, data)) in data.iter().enumerate() {
            let map = match data {
                SurfaceData::Map(map) => map.clone(),
                SurfaceData::Profile(profile) => {
                    let points = profile.heights().len();
                    let own = Lattice::square(points, points as f64 * profile.spacing());
                    let line = Line { spectrum: &profile.line_spectrum(), own };
                    said.line(file, &format!("a profile of {points} points"), &line);
                    self.extended(line, measured, k, said)
                        .map_err(|error| how.of_file(file, &error))?
                }
                SurfaceData::Spectrum(spectrum) => {
                    let line = Line { spectrum, own: spectrum.suitable_lattice() };
                    let [longest, shortest] =
                        spectrum.wavelengths().map(|length| readable(1e3 * length));
                    let what = format!("a spectrum of waves from {shortest} to {longest} mm");
                    said.line(file, &what, &line);
                    said.has_spectrum = true;
                    self.extended(line, measured, k, said)
                        .map_err(|error| how.of_file(file, &error))?
                }
            };
            sum = Some(match sum {
                None => map,
                Some(sum) => sum.plus(&map).map_err(|error| how.of_file(file, &error))?,
            });
        }
        sum.ok_or_else(|| {
            let place = Place::Default;
            CaseError::new(FILE, format!("{} must name a file", how.names.name(FILE)), place)
        })
    }

    /// A file without its form and waviness, in the cells that were asked for.
    fn one_file(
        &self,
        file: &InputFile,
        how: Reading,
        taken_off: TakenOff,
        said: &mut Said,
    ) -> Result<SurfaceData, CaseError> {
        let MeasuredSurface { data, filled } = how.file(file)?;
        let file = &*file.path();
        said.filling(file, filled, matches!(data, SurfaceData::Profile(_)));
        let data = match (data, taken_off.form) {
            (SurfaceData::Profile(profile), Some(Form::Cylinder | Form::Sphere)) => {
                let removal = profile.without_circle();
                let (profile, radius) = removal.map_err(|error| how.of_file(file, &error))?;
                said.form(file, radius);
                SurfaceData::Profile(profile)
            }
            (SurfaceData::Map(map), Some(form)) => {
                let removal = map.without_form(form).map_err(|error| how.of_file(file, &error))?;
                if form == Form::Plane {
                    said.tilt(file, &removal);
                } else {
                    said.form(file, removal.radius);
                }
                SurfaceData::Map(removal.surface)
            }
            (SurfaceData::Spectrum(_), Some(Form::Cylinder | Form::Sphere)) => {
                return Err(how.refusal(&file.display().to_string(), NO_FORM));
            }
            (data, _) => data,
        };
        let data = match (data, taken_off.cutoff) {
            (SurfaceData::Profile(profile), Some(cutoff)) => {
                profile.without_waviness(cutoff).map(SurfaceData::Profile)
            }
            (SurfaceData::Map(map), Some(cutoff)) => {
                map.without_waviness(cutoff).map(SurfaceData::Map)
            }
            (SurfaceData::Spectrum(spectrum), Some(cutoff)) => {
                spectrum.without_waviness(cutoff).map(SurfaceData::Spectrum)
            }
            (data, None) => Ok(data),
        };
        let map = match data.map_err(|error| how.explained(&error))? {
            SurfaceData::Map(map) => map,
            line => return Ok(line),
        };
        let Some(cells) = self.cells else { return Ok(SurfaceData::Map(map)) };
        let lattice = map.lattice();
        let rows = (lattice.rows as f64 * cells as f64 / lattice.columns as f64).round() as usize;
        let map = map.resampled(cells, rows).map_err(|error| how.of_file(file, &error))?;
        Ok(SurfaceData::Map(map))
    }

    /// The surface of the body `k` that has a line, on the lattice of the other surface if that is
    /// a map.
    fn extended(
        &self,
        line: Line,
        lattice: Option<Lattice>,
        k: usize,
        said: &mut Said,
    ) -> Result<HeightMap, Error> {
        let cells = self.cells.unwrap_or(line.own.columns.min(MOST_CELLS));
        let lattice = lattice.unwrap_or(Lattice::square(cells, line.own.length_x()));
        let (wavelength, [longest, shortest]) =
            (2.0 * lattice.spacing_x, line.spectrum.wavelengths());
        if wavelength > 1.01 * shortest {
            said.notices.push(Notice::WavesLeftOut { wavelength });
        }
        let side = lattice.length_x().max(lattice.length_y());
        if longest > 1.01 * side {
            said.notices.push(Notice::LongWavesLeftOut { longest, side });
        }
        line.spectrum.isotropic_surface(lattice, self.seed.wrapping_add(k as u64))
    }
}

/// A line across a surface, and the lattice that suits it.
#[derive(Clone, Copy)]
struct Line<'a> {
    spectrum: &'a LineSpectrum,
    own: Lattice,
}

/// What is said of a surface while it is made.
#[derive(Default)]
struct Said {
    remarks: Vec<String>,
    notices: Vec<Notice>,
    /// Whether a surface was made of a spectrum.
    has_spectrum: bool,
}

impl Said {
    /// Of a line from which a surface is made.
    fn line(&mut self, file: &Path, what: &str, line: &Line) {
        let height = readable(1e6 * line.spectrum.root_mean_square_height());
        self.remarks.push(format!("{}: from {what} with Rq = {height} µm", file.display()));
    }

    /// Of a tilt that was removed, if it is seen beside the roughness.
    fn tilt(&mut self, file: &Path, FormRemoval { surface, slope: [x, y], .. }: &FormRemoval) {
        let lattice = surface.lattice();
        let range = (x * lattice.length_x()).abs() + (y * lattice.length_y()).abs();
        let [low, high] = surface.range();
        if range > VISIBLE_TILT * (high - low) {
            let (name, angle) = (file.display(), x.hypot(*y).atan().to_degrees());
            self.remarks.push(format!("{name}: a tilt of {angle:.3} deg was removed"));
        }
    }

    /// Of a form of a radius (in m) that was removed.
    fn form(&mut self, file: &Path, radius: f64) {
        let name = file.display();
        let kind = if radius < 0.0 { "hollow" } else { "round" };
        let radius = readable(1e3 * radius.abs());
        self.remarks.push(format!("{name}: a {kind} form of radius {radius} mm was removed"));
    }

    /// Of a part of points that was filled.
    fn filling(&mut self, file: &Path, filled: f64, is_profile: bool) {
        if filled <= 0.0 {
            return;
        }
        let (name, share) = (file.display(), readable(1e2 * filled));
        let what = if is_profile { "points" } else { "cells" };
        let filling = format!("{name}: {share} % of the {what} had no height and were filled");
        if filled <= DOUBTFUL_FILLING {
            self.remarks.push(filling);
        } else {
            self.notices.push(Notice::FilledPoints { filling });
        }
    }
}
