//! A rough contact that options of the command line ask for.

use std::sync::Arc;

use schlupf::Watch;
use schlupf::interface::roughness::tangential_curve::SimilarBodies;

use crate::FieldPath;
use crate::case_file::CaseFile;
use crate::document::{self, Entry, Origin};
use crate::error::{CaseError, CaseErrors};
use crate::files::Files;
use crate::law_stiffness::MicroKey;
use crate::names::FieldNames;
use crate::read::{self, MicroCase};
use crate::settings::Settings;
use crate::surface::RoughSurface;

/// A field that an option gives.
#[derive(Debug, Clone)]
pub struct GivenByOption {
    /// The option, such as `--unit`.
    pub option: Arc<str>,
    /// What stands after it.
    pub text: String,
    /// Path of the field.
    pub field: FieldPath,
    /// Its value, as in a case file.
    pub value: String,
}

/// What a micro model needs, and where its errors stand.
#[derive(Debug, Clone)]
pub struct RoughnessRequest {
    request: MicroCase,
    settings: Settings,
}

const ROUGHNESS: &str = "contact_law.roughness.";

impl CaseFile {
    /// The rough contact of the bodies of this case with what options give: with `files`, which
    /// finds theirs, in place of its own roughness, else in addition to it; `names` are what errors
    /// call the fields. `None` where there is no surface.
    pub fn rough_contact(
        &self,
        options: &[GivenByOption],
        files: Option<Arc<dyn Files>>,
        names: FieldNames,
        watch: Watch,
    ) -> Result<Option<RoughnessRequest>, CaseErrors> {
        let mut entries = self.entries.clone();
        // Whatever method the case is solved by, and whatever its k_c is.
        entries.retain(|entry| !is_replaced(entry, files.is_some()));
        for given in options {
            let origin =
                Origin::Override { option: Arc::clone(&given.option), text: given.text.clone() };
            document::assign(&mut entries, origin, &given.field, &given.value);
        }
        let files = files.unwrap_or_else(|| Arc::clone(&self.files));
        let (settings, errors) = Settings::read(&entries, &self.source.name, names, files);
        CaseErrors::check(errors)?;
        let request = read::micro_case(&settings, watch)?;
        Ok(request.map(|request| RoughnessRequest { request, settings }))
    }
}

fn is_replaced(entry: &Entry, by_options: bool) -> bool {
    let path = entry.path.as_str();
    fields!["solver.method", "contact_law.stiffness"].iter().any(|field| **field == *path)
        || by_options && path.starts_with(ROUGHNESS)
}

impl RoughnessRequest {
    /// What the normal contact depends on.
    pub fn key(&self) -> &MicroKey {
        &self.request.key
    }

    /// Friction and Poisson's ratio.
    pub fn bodies(&self) -> &SimilarBodies {
        &self.request.bodies
    }

    /// Mean pressures of the tangential curves, in Pa.
    pub fn mean_pressures(&self) -> &[f64] {
        &self.request.mean_pressures
    }

    /// Reads or makes the surface.
    pub fn load(&self) -> Result<RoughSurface, CaseError> {
        read::load_roughness(&self.settings, &self.request.key.source)
    }

    /// An error of the core, at the place of the field that it names.
    pub fn explain(&self, error: &schlupf::Error) -> CaseError {
        read::explain_roughness(&self.settings, error)
    }
}
