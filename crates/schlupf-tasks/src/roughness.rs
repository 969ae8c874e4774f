//! A rough surface, its contact and its k_c.

use schlupf::interface::roughness::load_curve::LoadCurveOptions;
use schlupf::interface::roughness::micro_model::{MicroModel, MicroModelResult};
use schlupf::message::Message;
use schlupf::normal::rough_contact::{Boundary, RoughContact, RoughContactOptions};
use schlupf::surface::HeightMap;
use schlupf::surface::spectrum::{RadialSpectrum, Window};
use schlupf::{Error, Watch};
use schlupf_case::surface::{RoughSurface, SurfaceOrigin};
use schlupf_case::{CaseErrors, CaseFile, RoughnessRequest, caveats};
use schlupf_output::roughness::{RoughnessReport, Spots};

use crate::TaskError;

/// A surface to press, and on what.
#[derive(Debug)]
pub struct Plan {
    /// Title of the case.
    pub title: String,
    /// Surface, bodies and pressures.
    pub request: RoughnessRequest,
    /// What messages and results call a surface that is generated, if not by the case.
    pub generated: Option<String>,
    /// Whether the contact spots are wanted, too.
    pub with_spots: bool,
}

impl Plan {
    /// The surface of a case.
    ///
    /// # Errors
    /// A case that is wrong, or without a rough surface.
    pub fn of_case(file: &CaseFile, with_spots: bool, watch: Watch) -> Result<Self, TaskError> {
        let names = schlupf_case::FieldNames::CASE;
        let Some(request) = file.rough_contact(&[], None, names, watch)? else {
            return Err(TaskError::Request(
                "contact_law.roughness must have a surface to press: file, or rms_height, \
                 longest_wavelength and shortest_wavelength"
                    .to_owned(),
            ));
        };
        Ok(Self { title: file.title()?, request, generated: None, with_spots })
    }

    /// Presses it.
    ///
    /// # Errors
    /// A surface that cannot be read, or whatever the solver refuses.
    pub fn find(self, watch: Watch) -> Result<RoughnessReport, TaskError> {
        let rough = self.request.load()?;
        let explain = |error: Error| CaseErrors::from(self.request.explain(&error));
        let result = solve(&self.request, &rough, watch).map_err(explain)?;
        let spots = self.with_spots.then(|| spots(&self.request, &rough.surface, watch));
        let spots = spots.transpose().map_err(explain)?;
        Ok(self.report(rough, result, spots))
    }

    /// What was pressed, and what came out.
    fn report(
        &self,
        rough: RoughSurface,
        result: MicroModelResult,
        spots: Option<Spots>,
    ) -> RoughnessReport {
        let request = &self.request;
        let caveats = caveats(&result, rough.surface.lattice().len(), request.key());
        let warnings = rough.notices.into_iter().chain(caveats).map(Message::from).collect();
        RoughnessReport {
            title: self.name(),
            spectrum: RadialSpectrum::of(&rough.surface, Window::of(&rough.surface)),
            surface: rough.surface,
            bodies: *request.bodies(),
            contact_modulus: request.key().contact_modulus,
            hardness: request.key().hardness,
            result,
            spots,
            remarks: rough.remarks,
            warnings,
        }
    }

    /// What the surface is called.
    fn name(&self) -> String {
        match (&self.request.key().source.origin, &self.generated) {
            (SurfaceOrigin::SelfAffine(_), Some(text)) => format!("self-affine surface, {text}"),
            (SurfaceOrigin::SelfAffine(_), None) => format!("{}, self-affine surface", self.title),
            (SurfaceOrigin::Files { files, .. }, _) => {
                let names: Vec<String> =
                    files.iter().map(|file| file.path().display().to_string()).collect();
                names.join(" and ")
            }
        }
    }
}

/// The micro model.
fn solve(
    request: &RoughnessRequest,
    rough: &RoughSurface,
    watch: Watch,
) -> Result<MicroModelResult, Error> {
    let (key, bodies) = (request.key(), request.bodies());
    let model = MicroModel {
        surface: rough.surface.clone(),
        contact_modulus: key.contact_modulus,
        bodies: *bodies,
        hardness: key.hardness,
        mean_pressures: request.mean_pressures().to_vec(),
    };
    model.solve(&LoadCurveOptions::default(), watch)
}

/// The contact at the largest mean pressure.
fn spots(request: &RoughnessRequest, surface: &HeightMap, watch: Watch) -> Result<Spots, Error> {
    let key = request.key();
    let distance = surface.distance_to_plane();
    let contact = RoughContact::new(distance, key.contact_modulus, Boundary::Periodic)?;
    let mut contact = contact.with_hardness(key.hardness)?;
    let solution = contact.press(key.largest_pressure, &RoughContactOptions::default(), watch)?;
    Ok(Spots {
        mean_pressure: key.largest_pressure,
        is_converged: solution.is_converged,
        pressure: solution.pressure,
        gap: solution.gap,
    })
}
