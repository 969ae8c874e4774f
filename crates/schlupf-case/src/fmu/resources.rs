//! The case of an FMU, with all files that it names.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::Path;
use std::sync::Arc;

use schlupf::Watch;
use schlupf::element::Element;
use sha2::{Digest, Sha256};

use crate::case_file::{CaseFile, Overrides};
use crate::error::CaseErrors;
use crate::files::{Files, LARGEST_FILE, Recorder, read_up_to};

const CASE: &str = "case.toml";
/// Where files are by the names that the case gives them.
const NAMES: &str = "files.json";

/// The text of a case, and the files that it names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Resources {
    case: String,
    files: BTreeMap<String, Vec<u8>>,
}

impl Resources {
    /// Those of a case with all its overrides, and its element.
    ///
    /// # Errors
    /// A case that has no element.
    pub fn of(file: &CaseFile, watch: Watch) -> Result<(Self, Element), CaseErrors> {
        let case = file.edited(&[], &file.folder())?;
        let recorder = Arc::new(Recorder::new(Arc::clone(&file.files)));
        let files = Arc::clone(&recorder) as Arc<dyn Files>;
        let element = element(&case, file.name(), files, watch)?;
        Ok((Self { case, files: recorder.found() }, element))
    }

    /// Those that an FMU has in a folder.
    ///
    /// # Errors
    /// Files that cannot be read.
    pub fn from_folder(folder: &Path) -> io::Result<Self> {
        let read = |name: &str| {
            let path = folder.join(name);
            let bytes = fs::File::open(&path).and_then(|file| read_up_to(LARGEST_FILE, file));
            bytes.map_err(|cause| {
                io::Error::new(cause.kind(), format!("{}: {cause}", path.display()))
            })
        };
        let names: BTreeMap<String, String> = serde_json::from_slice(&read(NAMES)?)?;
        let files = names.into_iter().map(|(name, place)| {
            // Nothing outside of the folder.
            let place = Path::new(&place).file_name().unwrap_or_default().to_string_lossy();
            Ok((name, read(&place)?))
        });
        let files = files.collect::<io::Result<_>>()?;
        let case = String::from_utf8(read(CASE)?).map_err(io::Error::other)?;
        Ok(Self { case, files })
    }

    /// The element of the case.
    ///
    /// # Errors
    /// A case that has none.
    pub fn element(&self, watch: Watch) -> Result<Element, CaseErrors> {
        element(&self.case, CASE, Arc::new(self.files.clone()), watch)
    }

    /// Names and bytes of the files in the folder.
    pub fn members(&self) -> Vec<(String, Vec<u8>)> {
        let places = self.files.keys().enumerate();
        let places = places.map(|(k, name)| (name.clone(), format!("file_{k}").into()));
        let names = serde_json::Value::Object(places.collect());
        let own = [(CASE, self.case.as_str()), (NAMES, &names.to_string())];
        let own = own.map(|(name, text)| (name.to_owned(), text.as_bytes().to_owned()));
        let files = self.files.values().enumerate();
        let files = files.map(|(k, bytes)| (format!("file_{k}"), bytes.clone()));
        own.into_iter().chain(files).collect()
    }

    /// A digest of them and of the version of the program.
    pub fn token(&self) -> String {
        let mut hasher = Sha256::new_with_prefix(concat!("schlupf ", env!("CARGO_PKG_VERSION")));
        for (name, bytes) in self.members() {
            hasher.update(format!("\n{name} {}\n", bytes.len()));
            hasher.update(bytes);
        }
        let digest = hasher.finalize();
        digest.iter().take(16).fold(String::new(), |mut text, byte| {
            // Writing to a string cannot fail.
            let _ = write!(text, "{byte:02x}");
            text
        })
    }
}

fn element(
    case: &str,
    name: &str,
    files: Arc<dyn Files>,
    watch: Watch,
) -> Result<Element, CaseErrors> {
    let file = CaseFile::from_str(case, name, files, Overrides::NONE)?;
    Ok(file.pose(watch)?.element()?)
}
