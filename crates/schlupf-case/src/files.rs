//! Where the files that a case names come from.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

/// Largest file of data that is read, in bytes.
pub const LARGEST_FILE: u64 = 1 << 30;

/// Reads up to so many bytes.
///
/// # Errors
/// Whatever keeps them from being read, and more bytes.
pub fn read_up_to(most: u64, reader: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        let most = most >> 20;
        return Err(io::Error::other(format!(
            "it is larger than {most} MiB, the most that is read"
        )));
    }
    Ok(bytes)
}

/// Finds the files that a case names: in a folder, in memory, or wherever the caller has them.
pub trait Files: Debug + Send + Sync {
    /// The bytes of a file, by the name that the case gives it.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    fn read(&self, name: &str) -> io::Result<Vec<u8>>;

    /// Where it lies: what messages call it, and what tells whether two names mean the same file.
    fn locate(&self, name: &str) -> PathBuf {
        PathBuf::from(name)
    }
}

/// Data in place of a file, as a URL: `data:text/csv,y [mm],z [mm]…` (RFC 2397). Text may stand as
/// it is, with `%25` for `%`; bytes are in Base64. Lengths that are not in it stand in parameters,
/// in m.
#[derive(Debug, Clone, Copy)]
pub struct DataUrl<'a> {
    header: &'a str,
    body: &'a str,
}

impl<'a> DataUrl<'a> {
    /// That of a text, if it is one.
    pub fn of(text: &'a str) -> Option<Self> {
        let (header, body) = text.strip_prefix("data:")?.split_once(',')?;
        Some(Self { header, body })
    }

    /// The value of a field as tables have it: of data their name, else the value.
    pub fn label(value: &'a str) -> &'a str {
        Self::of(value).map_or(value, Self::name)
    }

    /// What it is, as the ending of a file: `csv` of `text/csv`.
    fn ending(self) -> &'a str {
        let media = self.header.split(';').next().unwrap_or_default();
        let kind = media.rsplit('/').next().unwrap_or_default();
        kind.strip_prefix("x-").unwrap_or(kind)
    }

    fn parameter(self, name: &str) -> Option<&'a str> {
        let mut parameters = self.header.split(';').filter_map(|text| text.split_once('='));
        parameters.find_map(|(own, value)| (own == name).then_some(value))
    }

    fn pair(self, names: [&str; 2]) -> Option<[f64; 2]> {
        let [x, y] = names.map(|name| self.parameter(name)?.parse().ok());
        Some([x?, y?])
    }

    /// What messages call it.
    fn name(self) -> &'a str {
        self.parameter("name").unwrap_or("data")
    }

    fn bytes(self) -> io::Result<Vec<u8>> {
        if self.header.ends_with(";base64") {
            return BASE64_STANDARD.decode(self.body).map_err(io::Error::other);
        }
        let mut parts = self.body.split('%');
        let mut bytes = parts.next().unwrap_or_default().as_bytes().to_vec();
        for part in parts {
            let code = part.get(..2).and_then(|code| u8::from_str_radix(code, 16).ok());
            bytes.push(code.unwrap_or(b'%'));
            bytes.extend(&part.as_bytes()[if code.is_some() { 2 } else { 0 }..]);
        }
        Ok(bytes)
    }
}

/// Files of a folder: relative paths start there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Folder(PathBuf);

impl Folder {
    /// A folder; the working directory where the path is empty.
    pub fn new(path: impl Into<PathBuf>) -> Arc<Self> {
        Arc::new(Self(path.into()))
    }

    /// The folder of a file.
    pub fn of(path: &Path) -> Arc<Self> {
        Self::new(path.parent().unwrap_or(Path::new("")))
    }
}

impl Files for Folder {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        read_up_to(LARGEST_FILE, File::open(self.locate(name))?)
    }

    fn locate(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

/// Files in memory, by their names.
impl Files for BTreeMap<String, Vec<u8>> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = self.get(name).cloned();
        bytes.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "no such file was given"))
    }
}

/// Files anywhere, by other names than their paths, which need not be text.
impl Files for BTreeMap<String, PathBuf> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        read_up_to(LARGEST_FILE, File::open(self.locate(name))?)
    }

    fn locate(&self, name: &str) -> PathBuf {
        self.get(name).cloned().unwrap_or_else(|| PathBuf::from(name))
    }
}

/// One of them.
#[derive(Debug, Clone)]
pub struct InputFile {
    name: String,
    files: Arc<dyn Files>,
}

impl InputFile {
    /// A file that a case names.
    pub fn new(name: impl Into<String>, files: Arc<dyn Files>) -> Self {
        Self { name: name.into(), files }
    }

    /// A file by its path from the working directory.
    pub fn at(path: &Path) -> Self {
        let name = path.to_string_lossy().into_owned();
        Self::new(name.clone(), Arc::new(BTreeMap::from([(name, path.to_owned())])))
    }

    /// The data that stand in its place, if they do.
    pub fn data(&self) -> Option<DataUrl<'_>> {
        DataUrl::of(&self.name)
    }

    /// What a case calls it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it lies, or what messages call its data.
    pub fn path(&self) -> PathBuf {
        self.data().map_or_else(|| self.files.locate(&self.name), |data| data.name().into())
    }

    /// The ending of its name, which says its format, in small letters.
    pub fn ending(&self) -> String {
        let path = self.path();
        let of_path = || path.extension().unwrap_or_default().to_string_lossy();
        self.data().map_or_else(of_path, |data| data.ending().into()).to_lowercase()
    }

    /// Distances of its points along x and y (in m), where its data have them.
    pub fn spacings(&self) -> Option<[f64; 2]> {
        self.data()?.pair(["spacing_x", "spacing_y"])
    }

    /// The unit of its values, where its data have it.
    pub fn unit(&self) -> Option<&str> {
        self.data()?.parameter("unit")
    }

    /// Its first place along x and y (in m), where its data have it.
    pub fn start(&self) -> Option<[f64; 2]> {
        self.data()?.pair(["start_x", "start_y"])
    }

    /// What is in it.
    ///
    /// # Errors
    /// Whatever keeps it from being read.
    pub fn read(&self) -> io::Result<Vec<u8>> {
        self.data().map_or_else(|| self.files.read(&self.name), DataUrl::bytes)
    }
}

impl PartialEq for InputFile {
    fn eq(&self, other: &Self) -> bool {
        self.path() == other.path() && (self.data().is_none() || self.name == other.name)
    }
}

/// Remembers what was read.
#[derive(Debug)]
pub(crate) struct Recorder {
    files: Arc<dyn Files>,
    read: Mutex<BTreeMap<String, Vec<u8>>>,
}

impl Recorder {
    pub fn new(files: Arc<dyn Files>) -> Self {
        Self { files, read: Mutex::default() }
    }

    /// What was read, by names.
    pub fn found(&self) -> BTreeMap<String, Vec<u8>> {
        self.read.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl Files for Recorder {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = self.files.read(name)?;
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        read.insert(name.to_owned(), bytes.clone());
        Ok(bytes)
    }

    fn locate(&self, name: &str) -> PathBuf {
        self.files.locate(name)
    }
}

/// Text in UTF-8 or UTF-16, or in a code page of which only ASCII is understood: comments and names
/// from measuring devices are in any, numbers are in ASCII. `None` for what is no text.
pub(crate) fn text(bytes: &[u8]) -> Option<String> {
    // ASCII in UTF-16 without a byte order mark.
    let is_every_second =
        |zero: usize| bytes.len() > 3 && (0..4).all(|k| (bytes[k] == 0) == (k % 2 == zero));
    let is_little = bytes.starts_with(&[0xff, 0xfe]) || is_every_second(1);
    let is_big = bytes.starts_with(&[0xfe, 0xff]) || is_every_second(0);
    let text = if is_little || is_big {
        let unit = |pair: &[u8]| {
            let pair = [pair[0], pair[1]];
            if is_little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) }
        };
        let units: Vec<u16> = bytes.chunks_exact(2).map(unit).collect();
        String::from_utf16_lossy(&units)
    } else {
        match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
        }
    };
    (!text.contains('\0')).then(|| text.trim_start_matches('\u{feff}').to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of RFC 2397 and of RFC 4648.
    #[test]
    fn data_stand_in_place_of_a_file() {
        let read = |url: &str| InputFile::new(url, Folder::new("none")).read().unwrap();
        assert_eq!(read("data:,A%20brief%20note"), b"A brief note");
        assert_eq!(read("data:text/csv,y [mm]\n50 %\n%"), b"y [mm]\n50 %\n%");
        assert_eq!(read("data:;base64,Zm9vYmE="), b"fooba");
        assert!(InputFile::new("data:;base64,Zm9", Folder::new("none")).read().is_err());
    }

    #[test]
    fn data_say_their_format_name_and_spacings() {
        let url = "data:application/x-npy;name=heights;spacing_x=1e-6;spacing_y=2e-6;base64,";
        let file = InputFile::new(url, Folder::new("none"));
        assert_eq!((&*file.ending(), file.path()), ("npy", PathBuf::from("heights")));
        assert_eq!(file.spacings(), Some([1e-6, 2e-6]));
        assert_ne!(file, InputFile::new(format!("{url}AA=="), Folder::new("none")));
        assert_eq!(InputFile::at(Path::new("a/B.CSV")).ending(), "csv");
    }
}
