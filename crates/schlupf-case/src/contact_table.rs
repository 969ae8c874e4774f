//! Tables of the contacts of a wheel on a rail, as files.
//!
//! A file is a `.npz` archive, which NumPy reads: `axes` with the first node and the step of each,
//! `values` at the nodes, `pair` with E*, the distance and the angle within which contacts share a
//! plane, and lengths of the profiles by which they are recognised; `metadata.json` with the
//! version of the format, names and numbers of nodes of the axes, the errors against exact
//! contacts, and a checksum of the arrays.

use std::borrow::Cow;
use std::sync::Arc;

use schlupf::Quantity;
use schlupf::reporting::Words;
use schlupf::wheel_rail::{
    ContactTable, ContactTableErrors, ContactTableNodes, ContactTableOptions, Joining, NodeAxis,
    Pair, Spread,
};
use serde::{Deserialize, Serialize};

use crate::FieldNames;
use crate::error::CaseError;
use crate::look_up_table::TableFileError;
use crate::look_up_table::archive::{METADATA, digest, pack, unpack};
use crate::look_up_table::npy;
use crate::place::Place;

const FORMAT: &str = "schlupf contact table";
const VERSION: u32 = 1;
/// In the order of the alphabet.
const ARRAYS: [&str; 3] = ["axes", "pair", "values"];
const VALUES: usize = 5;

/// Most nodes of a table.
const MOST_NODES: usize = 50_000_000;

/// Name of the largest roll angle as an argument.
pub const ROLL: &str = "largest_roll_angle";
/// Name of the largest yaw angle as an argument.
pub const YAW: &str = "largest_yaw_angle";

/// What options are called, spelled as an interface does.
pub struct OptionNames(pub fn(&str) -> String);

impl Words for OptionNames {
    fn word(&self, quantity: Quantity) -> Cow<'static, str> {
        let name = match quantity {
            Quantity::RollAngle => ROLL,
            Quantity::WheelsetYaw => YAW,
            Quantity::Tolerance => "tolerance",
            Quantity::RandomPoses => "poses",
            other => return FieldNames::CASE.word(other),
        };
        (self.0)(name).into()
    }
}

/// Refuses options that make no table.
///
/// # Errors
/// The option, what it must be, and what it is.
pub fn check(options: &ContactTableOptions, names: &OptionNames) -> Result<(), CaseError> {
    options.check().map_err(|error| {
        let name = names.word(error.quantity());
        CaseError::new(name, error.text(names), Place::File { name: String::new() })
    })
}

/// What a file says about its table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Metadata {
    format: String,
    version: u32,
    program: String,
    axes: Vec<String>,
    nodes: [usize; AXES.len()],
    /// Numbers in `pair`.
    pair: usize,
    is_within_tolerance: bool,
    failed_nodes: usize,
    poses: usize,
    errors: Vec<MetadataError>,
    sha256: String,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct MetadataError {
    of: String,
    median: f64,
    ninety_percent: f64,
    ninety_nine_percent: f64,
    largest: f64,
}

/// Names of the axes.
const AXES: [&str; 4] = ["wheel_arc_m", "roll_angle_rad", "yaw_angle_rad", "log_depth_m"];

/// The file of a table with its errors.
///
/// # Errors
/// Never, as long as memory lasts.
pub fn to_bytes(
    table: &ContactTable,
    errors: &ContactTableErrors,
) -> Result<Vec<u8>, TableFileError> {
    let ContactTableNodes { axes, values, pair, contact_modulus, joining } = table.nodes();
    let counts = axes.map(|axis| axis.count);
    let pair = [&[contact_modulus, joining.distance, joining.angle], pair.as_slice()].concat();
    let arrays = [
        npy::array(&[AXES.len(), 2], axes.into_iter().flat_map(|axis| [axis.start, axis.step])),
        npy::array(&[pair.len()], pair.iter().copied()),
        npy::array(&shape(&counts), values.into_iter().flatten()),
    ];
    let metadata = Metadata {
        format: FORMAT.to_owned(),
        version: VERSION,
        program: format!("schlupf {}", env!("CARGO_PKG_VERSION")),
        axes: AXES.map(str::to_owned).to_vec(),
        nodes: counts,
        pair: pair.len(),
        is_within_tolerance: errors.is_within_tolerance,
        failed_nodes: errors.failed_nodes,
        poses: errors.poses,
        errors: spreads(errors).map(|(of, spread)| stated(of, spread)).to_vec(),
        sha256: digest(&arrays),
    };
    let text = serde_json::to_vec_pretty(&metadata)
        .map_err(|error| TableFileError::NotATable(error.to_string()))?;
    pack(&text, &ARRAYS, &arrays)
}

fn shape(counts: &[usize; AXES.len()]) -> Vec<usize> {
    [counts.as_slice(), &[VALUES]].concat()
}

/// The errors that a file states, with what they are of and their unit.
pub fn spreads(errors: &ContactTableErrors) -> [(&'static str, &Spread); 4] {
    [
        ("load_over_wheel_load", &errors.load),
        ("place_m", &errors.place),
        ("angle_rad", &errors.angle),
        ("centre_m", &errors.centre),
    ]
}

fn stated(of: &str, spread: &Spread) -> MetadataError {
    let Spread { median, ninety_percent, ninety_nine_percent, largest } = *spread;
    MetadataError { of: of.to_owned(), median, ninety_percent, ninety_nine_percent, largest }
}

/// A pair of profiles, and what else its table is for.
#[derive(Debug)]
pub struct Wanted<'a> {
    /// The profiles in their places.
    pub pair: &'a Arc<Pair>,
    /// E*, in Pa.
    pub contact_modulus: f64,
    /// Which contacts share a plane.
    pub joining: Joining,
}

/// The table in a file.
///
/// # Errors
/// A file that is no table, is damaged, has another version, or is the table of another pair.
pub fn from_bytes(bytes: &[u8], wanted: &Wanted) -> Result<Arc<ContactTable>, TableFileError> {
    let own = (wanted.contact_modulus, wanted.joining);
    let table = ContactTable::from_nodes(wanted.pair, own, read(bytes)?);
    Ok(Arc::new(table.map_err(TableFileError::Unusable)?))
}

fn read(bytes: &[u8]) -> Result<ContactTableNodes, TableFileError> {
    let (metadata, arrays) = unpack(bytes, &ARRAYS)?;
    let unfit = |cause: String| TableFileError::NotATable(cause);
    let value: serde_json::Value = serde_json::from_slice(&metadata)
        .map_err(|error| unfit(format!("{METADATA} is no JSON ({error})")))?;
    if value["format"] != FORMAT {
        return Err(unfit(format!("{METADATA} has another format")));
    }
    if let Some(version) = value["version"].as_u64().filter(|own| *own != u64::from(VERSION)) {
        return Err(TableFileError::Version(version));
    }
    let metadata: Metadata =
        serde_json::from_value(value).map_err(|error| unfit(format!("{METADATA}: {error}")))?;
    if digest(&arrays) != metadata.sha256 {
        let cause = "its checksum is not that of its numbers".to_owned();
        return Err(TableFileError::Damaged(cause));
    }
    let count = metadata.nodes.iter().try_fold(1_usize, |product, n| product.checked_mul(*n));
    if metadata.axes != AXES || !matches!(count, Some(2..=MOST_NODES)) {
        return Err(unfit(format!("{METADATA} has other axes")));
    }
    let shapes = [vec![AXES.len(), 2], vec![metadata.pair], shape(&metadata.nodes)];
    let numbers = |k: usize| {
        let name = ARRAYS[k];
        let shaped = || TableFileError::Damaged(format!("{name}.npy is not what {METADATA} says"));
        npy::parse::<f64>(&arrays[k], &shapes[k]).ok_or_else(shaped)
    };
    let (axes, pair, values) = (numbers(0)?, numbers(1)?, numbers(2)?);
    let [contact_modulus, distance, angle, lengths @ ..] = pair.as_slice() else {
        return Err(unfit("pair.npy is too short".to_owned()));
    };
    let axis =
        |k: usize| NodeAxis { start: axes[2 * k], step: axes[2 * k + 1], count: metadata.nodes[k] };
    Ok(ContactTableNodes {
        axes: std::array::from_fn(axis),
        values: values.as_chunks().0.to_vec(),
        pair: lengths.to_vec(),
        contact_modulus: *contact_modulus,
        joining: Joining { distance: *distance, angle: *angle },
    })
}
