//! X3P, the exchange format of surface metrology (ISO 25178-72:2017; before, ISO 5436-2): a zip
//! archive with `main.xml` and, mostly, the heights as a binary file. All lengths are in m.
//!
//! Read are surfaces (`SUR`) and profiles (`PRF`) on a regular lattice, of any type of number,
//! binary or as text, with invalid points as NaN, as empty text or in a file of bits. Not read are
//! point clouds (`PCL`) and several layers or profiles in a file. Checksums are those of the
//! archive.

use std::borrow::Cow;
use std::io::{Cursor, Read};

use roxmltree::{Document, Node};
use schlupf::surface::Lattice;
use zip::ZipArchive;

use super::{MeasuredSurface, Reading, finish};
use crate::error::CaseError;
use schlupf::reporting::{quoted, shortened};

/// What is wrong with a file, to follow its name in a sentence.
type Message = String;

/// Most bytes of main.xml, which may hold all heights as text.
const LARGEST_HEADER: usize = 1 << 30;

/// Most points: more do not fit into memory with what a solution needs.
const MOST_POINTS: usize = 1 << 28;

/// Reads a file.
pub fn read(name: &str, bytes: Vec<u8>, how: Reading) -> Result<MeasuredSurface, CaseError> {
    let (lattice, heights) = parse(bytes).map_err(|message| how.refusal(name, message))?;
    finish(name, lattice, heights, how)
}

type Archive = ZipArchive<Cursor<Vec<u8>>>;

fn parse(bytes: Vec<u8>) -> Result<(Lattice, Vec<f64>), Message> {
    let not_zip = |error| format!("must be an X3P file, a zip archive, but is not: {error}");
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(not_zip)?;
    let text = member(&mut archive, "main.xml", LARGEST_HEADER)?;
    let text = String::from_utf8(text).map_err(|_| "must have a main.xml in UTF-8".to_owned())?;
    let document = Document::parse(text.trim_start_matches('\u{feff}'))
        .map_err(|error| format!("must have a main.xml in XML, but it is not: {error}"))?;
    let root = document.root_element();
    let lattice = lattice(root)?;
    let height = Axis::of(root, "CZ")?;
    let record = find(root, &["Record3"])?;
    let heights = match (child(record, "DataLink"), child(record, "DataList")) {
        (Some(link), _) => binary(&mut archive, link, &lattice, &height)?,
        (None, Some(list)) => text_list(list, &lattice, &height)?,
        (None, None) => {
            return Err(
                "must have heights, but Record3 has neither DataLink nor DataList".to_owned()
            );
        }
    };
    Ok((lattice, heights))
}

/// A file of the archive, up to some bytes.
fn member(archive: &mut Archive, name: &str, largest: usize) -> Result<Vec<u8>, Message> {
    let wanted = plain(name);
    let names = archive.file_names().filter_map(Result::ok);
    let found = names.map(Cow::into_owned).find(|found| plain(found) == wanted);
    let file = archive
        .by_name(found.as_deref().unwrap_or(name))
        .map_err(|error| format!("must have a file {name} in its archive: {error}"))?;
    let mut bytes = Vec::new();
    // One more shows that there are too many.
    file.take(largest as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| format!("has a damaged file {name} in its archive: {error}"))?;
    if bytes.len() > largest {
        return Err(format!("must have at most {largest} bytes in {name}, but has more"));
    }
    Ok(bytes)
}

/// A path within the archive, which some programs begin with `./` or `/` or write with backslashes.
fn plain(name: &str) -> String {
    let name = name.replace('\\', "/");
    let parts = name.split('/').filter(|part| !["", "."].contains(part));
    parts.collect::<Vec<&str>>().join("/")
}

/// The child of a name, in any namespace.
fn child<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    node.children().find(|child| child.is_element() && child.tag_name().name() == name)
}

fn find<'a, 'input>(root: Node<'a, 'input>, path: &[&str]) -> Result<Node<'a, 'input>, Message> {
    let found = path.iter().try_fold(root, |node, name| child(node, name));
    found.ok_or_else(|| format!("must have {} in main.xml", path.join("/")))
}

fn text<'a>(root: Node<'a, '_>, path: &[&str]) -> Result<&'a str, Message> {
    Ok(find(root, path)?.text().unwrap_or_default().trim())
}

/// An axis of Record1.
struct Axis<'a> {
    name: &'a str,
    /// I: at regular steps; A: each value is stored.
    kind: &'a str,
    data_type: Option<&'a str>,
    increment: Option<f64>,
    offset: f64,
}

impl<'a> Axis<'a> {
    fn of(root: Node<'a, '_>, name: &'a str) -> Result<Self, Message> {
        let path = ["Record1", "Axes", name];
        let axis = find(root, &path)?;
        let number = |entry: &str| match child(axis, entry).and_then(|node| node.text()) {
            None => Ok(None),
            Some(text) => match text.trim().parse::<f64>() {
                Ok(number) if number.is_finite() => Ok(Some(number)),
                _ => Err(format!(
                    "must have a finite number as {entry} of {name}, but has {}",
                    quoted(text)
                )),
            },
        };
        Ok(Self {
            name,
            kind: text(axis, &["AxisType"])?,
            data_type: child(axis, "DataType").and_then(|node| node.text()).map(str::trim),
            increment: number("Increment")?,
            offset: number("Offset")?.unwrap_or(0.0),
        })
    }

    /// Distance of two points, in m. Some instruments count backwards.
    fn spacing(&self) -> Result<f64, Message> {
        let name = self.name;
        if self.kind != "I" {
            let kind = shortened(self.kind);
            return Err(format!(
                "must have points at regular steps, but {name} has AxisType {kind}"
            ));
        }
        match self.increment.map(f64::abs) {
            Some(step) if step > 0.0 => Ok(step),
            Some(step) => Err(format!("must have a step of {name} that is not {step} m")),
            None => Err(format!("must have an Increment of {name}")),
        }
    }

    /// From a stored number to m. Where each value is stored, some programs write a step of zero.
    fn value(&self, number: f64) -> f64 {
        let step = self.increment.filter(|step| *step != 0.0 || self.kind != "A");
        step.unwrap_or(1.0) * number + self.offset
    }
}

fn lattice(root: Node<'_, '_>) -> Result<Lattice, Message> {
    let kind = text(root, &["Record1", "FeatureType"])?;
    if !["SUR", "PRF"].contains(&kind) {
        return Err(format!("must be a surface (SUR) or a profile (PRF), but is {}", quoted(kind)));
    }
    let size = |name: &str| {
        let text = text(root, &["Record3", "MatrixDimension", name])?;
        let count = text.parse::<usize>().ok().filter(|count| *count > 0);
        count.ok_or_else(|| format!("must have a positive {name}, but has {}", quoted(text)))
    };
    let [columns, rows, layers] = [size("SizeX")?, size("SizeY")?, size("SizeZ")?];
    if layers != 1 || (kind == "PRF" && rows != 1 && columns != 1) {
        return Err(format!(
            "must have one layer or one profile, but has SizeX, SizeY, SizeZ = {columns}, {rows}, {layers}"
        ));
    }
    if columns.saturating_mul(rows) > MOST_POINTS {
        return Err(format!("must have at most {MOST_POINTS} points, but has {columns} by {rows}"));
    }
    let spacing = |axis: &'static str| Axis::of(root, axis)?.spacing();
    // The points of a profile lie along x, also where the matrix holds them in a column.
    let (spacing_x, spacing_y) = match (columns, rows) {
        (_, 1) => (spacing("CX")?, spacing("CX")?),
        (1, _) if kind == "PRF" => (spacing("CX")?, spacing("CX")?),
        (1, _) => (spacing("CY")?, spacing("CY")?),
        _ => (spacing("CX")?, spacing("CY")?),
    };
    Ok(Lattice { columns, rows, spacing_x, spacing_y })
}

/// Heights in a file of the archive, little-endian, x running fastest.
fn binary(
    archive: &mut Archive,
    link: Node<'_, '_>,
    lattice: &Lattice,
    axis: &Axis<'_>,
) -> Result<Vec<f64>, Message> {
    let data_type = axis.data_type.unwrap_or("D");
    let width = match data_type {
        "I" => 2,
        "L" | "F" => 4,
        "D" => 8,
        _ => {
            return Err(format!(
                "must have numbers of type I, L, F or D, but has {}",
                quoted(data_type)
            ));
        }
    };
    let name = text(link, &["PointDataLink"])?;
    let wanted = lattice.len() * width;
    let bytes = member(archive, name, wanted)?;
    if bytes.len() != wanted {
        let found = bytes.len();
        return Err(format!(
            "must have {wanted} bytes in {name} for {} by {} numbers of type {data_type}, but has {found}",
            lattice.columns, lattice.rows
        ));
    }
    let mut heights = match data_type {
        "I" => each(&bytes, |bytes| f64::from(i16::from_le_bytes(bytes))),
        "L" => each(&bytes, |bytes| f64::from(i32::from_le_bytes(bytes))),
        "F" => each(&bytes, |bytes| f64::from(f32::from_le_bytes(bytes))),
        _ => each(&bytes, f64::from_le_bytes),
    };
    for height in &mut heights {
        *height = axis.value(*height);
    }
    if child(link, "ValidPointsLink").is_some() {
        let name = text(link, &["ValidPointsLink"])?;
        let wanted = lattice.len().div_ceil(8);
        let bits = member(archive, name, wanted)?;
        if bits.len() != wanted {
            let found = bits.len();
            return Err(format!("must have {wanted} bytes in {name}, but has {found}"));
        }
        for (k, height) in heights.iter_mut().enumerate() {
            if bits[k / 8] >> (k % 8) & 1 == 0 {
                *height = f64::NAN;
            }
        }
    }
    Ok(heights)
}

fn each<const N: usize>(bytes: &[u8], convert: impl Fn([u8; N]) -> f64) -> Vec<f64> {
    bytes.as_chunks::<N>().0.iter().map(|bytes| convert(*bytes)).collect()
}

/// Heights as text, the last of the numbers apart by semicolons; empty where invalid.
fn text_list(list: Node<'_, '_>, lattice: &Lattice, axis: &Axis<'_>) -> Result<Vec<f64>, Message> {
    let data = list.children().filter(Node::is_element);
    let height = |node: Node<'_, '_>| {
        let text = node.text().unwrap_or_default();
        let last = text.rsplit(';').next().unwrap_or_default().trim();
        if last.is_empty() || last.eq_ignore_ascii_case("nan") {
            return Ok(f64::NAN);
        }
        let number = last.parse::<f64>().ok().filter(|number| number.is_finite());
        let number = number
            .ok_or_else(|| format!("must have numbers in DataList, but has {}", quoted(last)));
        Ok(axis.value(number?))
    };
    let heights: Result<Vec<f64>, Message> = data.map(height).collect();
    let heights = heights?;
    if heights.len() != lattice.len() {
        return Err(format!(
            "must have {} by {} heights in DataList, but has {}",
            lattice.columns,
            lattice.rows,
            heights.len()
        ));
    }
    Ok(heights)
}
