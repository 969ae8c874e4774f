//! Figures in a directory: which files there are ours, as a manifest beside them says.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::failure::Failure;

/// Name of the manifest.
pub const MANIFEST: &str = "schlupf-figures.json";

/// The figures that were drawn into a directory, by their names, with the SHA-256 of each.
#[derive(Debug, Default)]
pub struct Figures {
    directory: PathBuf,
    digests: BTreeMap<String, String>,
}

impl Figures {
    /// Those of a directory, which may be missing yet.
    pub fn of(directory: &Path) -> Result<Self, Failure> {
        let path = directory.join(MANIFEST);
        let digests = match fs::read(&path) {
            Ok(bytes) => serde_json::from_slice(&bytes).map_err(|_| {
                let message = "it is no manifest of figures: remove it, or name another directory";
                Failure::file(&path, io::Error::new(ErrorKind::InvalidData, message))
            })?,
            Err(cause) if cause.kind() == ErrorKind::NotFound => BTreeMap::new(),
            Err(cause) => return Err(Failure::file(&path, cause)),
        };
        Ok(Self { directory: directory.to_owned(), digests })
    }

    /// Refuses to write over, or to remove later, a file that is not as it was drawn.
    pub fn refuse_foreign(&self, name: &str) -> Result<(), Failure> {
        let path = self.directory.join(name);
        if !path.exists() || self.is_ours(name) {
            return Ok(());
        }
        Err(Failure::Arguments(format!(
            "--figures must name a directory without other files of the names of figures, but {} is \
             none that {MANIFEST} lists, or has changed: remove it, or name another directory",
            path.display()
        )))
    }

    /// Whether a file is one that was drawn here, as it was drawn.
    fn is_ours(&self, name: &str) -> bool {
        let own = self.digests.get(name);
        own.is_some_and(|own| {
            fs::read(self.directory.join(name)).is_ok_and(|bytes| digest(&bytes) == *own)
        })
    }

    /// The directory with the figures that are drawn now, of all that may be.
    pub fn renewed(mut self, names: &[String], mut drawn: Vec<(PathBuf, Vec<u8>)>) -> Renewed {
        let mut stale = Vec::new();
        for name in names {
            let path = self.directory.join(name);
            if !drawn.iter().any(|(drawn, _)| *drawn == path) {
                if self.is_ours(name) {
                    stale.push(path);
                }
                self.digests.remove(name);
            }
        }
        for (path, bytes) in &drawn {
            let name = path.strip_prefix(&self.directory).ok().and_then(Path::to_str);
            self.digests.extend(name.map(|name| (name.to_owned(), digest(bytes))));
        }
        let text = serde_json::to_string_pretty(&self.digests).unwrap_or_default();
        drawn.push((self.directory.join(MANIFEST), (text + "\n").into_bytes()));
        Renewed { files: drawn, stale }
    }
}

/// What becomes of a directory of figures.
pub struct Renewed {
    /// The figures that are drawn now, and the manifest.
    pub files: Vec<(PathBuf, Vec<u8>)>,
    /// Those that were drawn before and are not drawn now.
    pub stale: Vec<PathBuf>,
}

/// Names of the files that a figure may have: the drawing, and the picture of the feature `png`.
pub fn figure_files(name: &str) -> [String; 2] {
    [format!("{name}.svg"), format!("{name}.png")]
}

fn digest(bytes: &[u8]) -> String {
    format!("{:x}", Sha256::digest(bytes))
}
