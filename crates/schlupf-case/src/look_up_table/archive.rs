//! A table as a `.npz` archive.

use std::io::{Cursor, Read, Write};
use std::sync::Arc;

use schlupf::analysis::table_building::{BuiltTable, TableOptions};
use schlupf::problem::look_up_table::{LookUpTable, TableNodes};
use sha2::{Digest, Sha256};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use crate::look_up_table::metadata::{FORMAT, Metadata, VERSION};
use crate::look_up_table::npy;

/// A table and what its file says about it.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredTable {
    /// The table.
    pub table: Arc<LookUpTable>,
    /// What its file says.
    pub metadata: Metadata,
}

/// Why a file is no table.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableFileError {
    /// Not an archive with the metadata of a table.
    #[error("must be a look-up table as `schlupf table` writes it, but {0}")]
    NotATable(String),
    /// Another version of the format.
    #[error(
        "is a look-up table of version {0}, but this program reads version {VERSION}: make it again \
         with `schlupf table`"
    )]
    Version(u64),
    /// Numbers that are not those that were written.
    #[error("is damaged: {0}")]
    Damaged(String),
    /// Numbers that make no table.
    #[error("is no usable table: {0}")]
    Unusable(schlupf::Error),
}

pub const METADATA: &str = "metadata.json";

/// Names of the arrays, in the order of the alphabet.
const ARRAYS: [&str; 6] =
    ["axis_ratios", "azimuths", "creep_coefficients", "inclinations", "saturations", "values"];

/// Most bytes of a member of the archive.
const LARGEST: u64 = 1 << 30;

/// Most nodes of a table.
const MOST_NODES: usize = 50_000_000;

impl StoredTable {
    /// A table that was just made.
    pub fn new(built: BuiltTable, options: &TableOptions) -> Self {
        let digest = digest(&arrays(built.table.nodes()));
        let metadata = Metadata::new(&built, options, digest);
        Self { table: Arc::new(built.table), metadata }
    }

    /// The file.
    ///
    /// # Errors
    /// Never, as long as memory lasts.
    pub fn to_bytes(&self) -> Result<Vec<u8>, TableFileError> {
        let fail = |cause: String| TableFileError::NotATable(cause);
        let text = serde_json::to_vec_pretty(&self.metadata);
        let text = text.map_err(|error| fail(error.to_string()))?;
        pack(&text, &ARRAYS, &arrays(self.table.nodes()))
    }

    /// Reads a file.
    ///
    /// # Errors
    /// A file that is no table, is damaged, or has another version.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, TableFileError> {
        let (metadata, arrays) = unpack(bytes, &ARRAYS)?;
        let metadata = read_metadata(&metadata)?;
        if digest(&arrays) != metadata.sha256 {
            let cause = "its checksum is not that of its numbers".to_owned();
            return Err(TableFileError::Damaged(cause));
        }
        let nodes = nodes(&metadata, &arrays)?;
        let table = LookUpTable::new(nodes).map_err(TableFileError::Unusable)?;
        Ok(Self { table: Arc::new(table), metadata })
    }
}

/// An archive with metadata and the named arrays.
pub fn pack(
    metadata: &[u8],
    names: &[&str],
    arrays: &[Vec<u8>],
) -> Result<Vec<u8>, TableFileError> {
    let fail = |cause: String| TableFileError::NotATable(cause);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    // Numbers hardly compress; a fixed time makes the file the same whenever it is written.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(zip::DateTime::default());
    let arrays = names.iter().zip(arrays);
    let members = arrays.map(|(name, bytes)| (format!("{name}.npy"), bytes.as_slice()));
    for (name, bytes) in std::iter::once((METADATA.to_owned(), metadata)).chain(members) {
        archive.start_file(name, options).map_err(|error| fail(error.to_string()))?;
        archive.write_all(bytes).map_err(|error| fail(error.to_string()))?;
    }
    let done = archive.finish().map_err(|error| fail(error.to_string()))?;
    Ok(done.into_inner())
}

/// Metadata and the named arrays of an archive.
pub fn unpack(bytes: &[u8], names: &[&str]) -> Result<(Vec<u8>, Vec<Vec<u8>>), TableFileError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes))
        .map_err(|error| TableFileError::NotATable(format!("is no archive ({error})")))?;
    let metadata = member(&mut archive, METADATA)?;
    let arrays = names.iter().map(|name| member(&mut archive, &format!("{name}.npy")));
    Ok((metadata, arrays.collect::<Result<_, _>>()?))
}

fn read_metadata(bytes: &[u8]) -> Result<Metadata, TableFileError> {
    let unfit = |cause: String| TableFileError::NotATable(cause);
    let value: serde_json::Value = serde_json::from_slice(bytes)
        .map_err(|error| unfit(format!("{METADATA} is no JSON ({error})")))?;
    if value["format"] != FORMAT {
        return Err(unfit(format!("{METADATA} has another format")));
    }
    let version = value["version"].as_u64();
    match version {
        Some(version) if version == u64::from(VERSION) => {}
        Some(version) => return Err(TableFileError::Version(version)),
        None => return Err(unfit(format!("{METADATA} has no version"))),
    }
    let metadata: Metadata =
        serde_json::from_value(value).map_err(|error| unfit(format!("{METADATA}: {error}")))?;
    let count = metadata.nodes.iter().try_fold(1_usize, |product, n| product.checked_mul(*n));
    if count.is_none_or(|count| count > MOST_NODES) {
        return Err(unfit(format!("{METADATA} has too many nodes")));
    }
    Ok(metadata)
}

fn member(archive: &mut ZipArchive<Cursor<&[u8]>>, name: &str) -> Result<Vec<u8>, TableFileError> {
    let file = archive
        .by_name(name)
        .map_err(|error| TableFileError::NotATable(format!("has no {name} ({error})")))?;
    let mut bytes = Vec::new();
    file.take(LARGEST)
        .read_to_end(&mut bytes)
        .map_err(|error| TableFileError::Damaged(format!("{name}: {error}")))?;
    Ok(bytes)
}

fn nodes(metadata: &Metadata, arrays: &[Vec<u8>]) -> Result<TableNodes, TableFileError> {
    let [ratios, azimuths, inclinations, saturations] = metadata.nodes;
    let shaped = |index: usize| {
        let name = ARRAYS[index];
        TableFileError::Damaged(format!(
            "{name}.npy has another shape or type than {METADATA} says"
        ))
    };
    let line = |index: usize, count: usize| {
        npy::parse::<f64>(&arrays[index], &[count]).ok_or_else(|| shaped(index))
    };
    let creep = npy::parse::<f64>(&arrays[2], &[ratios, 4]).ok_or_else(|| shaped(2))?;
    let shape = [ratios, azimuths, inclinations, saturations, 3];
    let values = npy::parse::<f32>(&arrays[5], &shape).ok_or_else(|| shaped(5))?;
    Ok(TableNodes {
        poisson_ratio: metadata.poisson_ratio,
        axis_ratios: line(0, ratios)?,
        azimuths: line(1, azimuths)?,
        inclinations: line(3, inclinations)?,
        saturations: line(4, saturations)?,
        values: values.as_chunks().0.to_vec(),
        creep_coefficients: creep.as_chunks().0.to_vec(),
    })
}

/// The arrays in the order of their names.
fn arrays(nodes: &TableNodes) -> [Vec<u8>; 6] {
    let line = |values: &[f64]| npy::array(&[values.len()], values.iter().copied());
    let shape = [
        nodes.axis_ratios.len(),
        nodes.azimuths.len(),
        nodes.inclinations.len(),
        nodes.saturations.len(),
        3,
    ];
    [
        line(&nodes.axis_ratios),
        line(&nodes.azimuths),
        npy::array(&[shape[0], 4], nodes.creep_coefficients.iter().flatten().copied()),
        line(&nodes.inclinations),
        line(&nodes.saturations),
        npy::array(&shape, nodes.values.iter().flatten().copied()),
    ]
}

pub fn digest(arrays: &[Vec<u8>]) -> String {
    let mut hasher = Sha256::new();
    for bytes in arrays {
        hasher.update(bytes);
    }
    format!("{:x}", hasher.finalize())
}
