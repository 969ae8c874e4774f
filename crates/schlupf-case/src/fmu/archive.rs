//! The archive.

use std::io::{Cursor, Write};

use schlupf::Watch;
use schlupf::reporting::Message;
use zip::ZipWriter;
use zip::result::ZipError;
use zip::write::SimpleFileOptions;

use crate::FieldNames;
use crate::case_file::CaseFile;
use crate::error::CaseErrors;
use crate::fmu::description::{self, Heading, IDENTIFIER, Version};
use crate::fmu::resources::Resources;
use crate::fmu::variables::{Variable, variables};

/// The library for a platform.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Binary {
    /// Its folder in the archive, such as linux64 (FMI 2.0) or x86_64-linux (FMI 3.0).
    pub platform: String,
    /// The library.
    pub bytes: Vec<u8>,
}

/// An FMU without libraries.
#[derive(Debug, Clone, PartialEq)]
pub struct Fmu {
    title: String,
    resources: Resources,
    variables: Vec<Variable>,
    warnings: Vec<Message>,
}

impl Fmu {
    /// That of a case.
    ///
    /// # Errors
    /// A case that has no force element.
    pub fn of(file: &CaseFile, watch: Watch) -> Result<Self, CaseErrors> {
        let (resources, element) = Resources::of(file, watch)?;
        let warnings = element.warnings().iter().map(|warning| warning.message(&FieldNames::CASE));
        let (variables, warnings) = (variables(&element), warnings.collect());
        Ok(Self { title: file.title()?, resources, variables, warnings })
    }

    /// What the method of its element neglects.
    pub fn warnings(&self) -> &[Message] {
        &self.warnings
    }

    /// Its variables, in the order of their value references.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// `modelDescription.xml`.
    pub fn description(&self, version: Version) -> String {
        let heading = Heading { version, title: &self.title, token: &self.resources.token() };
        description::description(&heading, &self.variables)
    }

    /// The archive, with libraries.
    ///
    /// # Errors
    /// Archives that are too large.
    pub fn to_bytes(&self, version: Version, binaries: &[Binary]) -> Result<Vec<u8>, ZipError> {
        let description = self.description(version).into_bytes();
        let mut members = vec![("modelDescription.xml".to_owned(), description)];
        let resources = self.resources.members().into_iter();
        members.extend(resources.map(|(name, bytes)| (format!("resources/{name}"), bytes)));
        members.extend(binaries.iter().map(|binary| (binary.path(), binary.bytes.clone())));
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        // A fixed time makes the file the same whenever it is written.
        let options = SimpleFileOptions::default().last_modified_time(zip::DateTime::default());
        for (name, bytes) in &members {
            archive.start_file(name, options)?;
            archive.write_all(bytes)?;
        }
        Ok(archive.finish()?.into_inner())
    }
}

impl Binary {
    /// The folder of this platform.
    pub fn platform(version: Version) -> String {
        let [architecture, system] = [std::env::consts::ARCH, std::env::consts::OS];
        match (version, architecture, system) {
            (Version::Two, "x86_64", "linux") => "linux64".to_owned(),
            (Version::Two, "x86_64", "windows") => "win64".to_owned(),
            (Version::Two, _, "macos") => "darwin64".to_owned(),
            (_, _, "macos") => format!("{architecture}-darwin"),
            _ => format!("{architecture}-{system}"),
        }
    }

    fn path(&self) -> String {
        let ending = match &self.platform {
            platform if platform.contains("darwin") => "dylib",
            platform if platform.contains("win") => "dll",
            _ => "so",
        };
        format!("binaries/{}/{IDENTIFIER}.{ending}", self.platform)
    }
}
