//! Files of surfaces, made by `surfaces/make.py` with NumPy and zipfile after ISO 25178-72 (none
//! comes from an instrument), and what is wrong with bad ones.

use std::collections::BTreeMap;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use approx::assert_relative_eq;
use schlupf::surface::form::Form;
use schlupf::surface::{HeightMap, Holes, Statistics};
use schlupf_case::surface::{
    self, Cells, MeasuredSurface, SurfaceData, SurfaceOptions, SurfaceOrigin, SurfaceSource,
};
use schlupf_case::{CaseError, FieldNames, Folder, InputFile};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

fn read(path: &Path, options: &SurfaceOptions) -> Result<MeasuredSurface, CaseError> {
    let file = InputFile::new(path.display().to_string(), Folder::new(""));
    surface::read(&file, options, FieldNames::CASE)
}

fn from_bytes(
    name: String,
    bytes: Vec<u8>,
    options: &SurfaceOptions,
) -> Result<MeasuredSurface, CaseError> {
    let files = Arc::new(BTreeMap::from([(name.clone(), bytes)]));
    surface::read(&InputFile::new(name, files), options, FieldNames::CASE)
}

fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/surfaces").join(name)
}

fn filled() -> SurfaceOptions {
    SurfaceOptions { holes: Holes::Fill, ..SurfaceOptions::default() }
}

#[track_caller]
fn map(name: &str, options: &SurfaceOptions) -> HeightMap {
    match read(&sample(name), options).unwrap().data {
        SurfaceData::Map(map) => map,
        data => panic!("{name} is no map: {data:?}"),
    }
}

/// The height of the samples at a point, as `make.py` has it.
fn expected(cell: usize) -> f64 {
    let (x, y) = (1.5e-6 * (cell % 24) as f64, 1.5e-6 * (cell / 24) as f64);
    0.4e-6 * (x / 3e-6).sin() + 0.1e-6 * (y / 2e-6).cos()
}

/// All formats hold the same surface, to their digits; holes are filled smoothly.
#[test]
fn every_format_gives_the_same_surface() {
    let in_micrometres = SurfaceOptions {
        unit: Some("um".to_owned()),
        spacing: Some([1.5e-6, 1.5e-6]),
        holes: Holes::Fill,
        cells: Cells::RefuseNonSquare,
    };
    let none: &[usize] = &[];
    let cases = [
        ("wave.x3p", SurfaceOptions::default(), none, 1e-20),
        ("wave_integers_holes.x3p", filled(), &[127, 383], 6e-12),
        ("wave_single_holes.x3p", filled(), &[127], 4e-14),
        ("wave.npy", in_micrometres.clone(), none, 1e-20),
        ("wave.csv", SurfaceOptions::default(), none, 1e-15),
        ("wave_holes.xyz", in_micrometres, &[127], 1e-15),
    ];
    for (name, options, holes, digits) in cases {
        let map = map(name, &options);
        let lattice = map.lattice();
        assert_eq!((lattice.columns, lattice.rows), (24, 16), "{name}");
        assert_relative_eq!(lattice.spacing_x, 1.5e-6, max_relative = 1e-6);
        assert_relative_eq!(lattice.spacing_y, 1.5e-6, max_relative = 1e-6);
        for (cell, height) in map.heights().iter().enumerate() {
            let tolerance = if holes.contains(&cell) { 0.1e-6 } else { digits };
            let miss = (height - expected(cell)).abs();
            assert!(miss <= tolerance, "{name}: {height} in cell {cell}, off by {miss}");
        }
    }
}

#[test]
fn a_profile_is_read_from_x3p_and_csv() {
    let SurfaceData::Profile(profile) =
        read(&sample("profile.x3p"), &SurfaceOptions::default()).unwrap().data
    else {
        panic!("no profile");
    };
    assert_eq!(profile.heights().len(), 100);
    assert_relative_eq!(profile.spacing(), 1.5e-6);
    assert_relative_eq!(
        profile.root_mean_square_height(),
        0.4e-6 / 2.0_f64.sqrt(),
        max_relative = 0.05
    );
    let height =
        |i: i32| if i == 40 { "nan".to_owned() } else { format!("{}", (f64::from(i) * 0.3).sin()) };
    let lines: Vec<String> = (0..100).map(|i| format!("{},{}", 2 * i, height(i))).collect();
    let text = format!("x [um],height [nm]\n{}\n", lines.join("\n"));
    let read = |options: &SurfaceOptions| {
        from_bytes("line.csv".to_owned(), text.clone().into_bytes(), options)
    };
    let SurfaceData::Profile(profile) = read(&filled()).unwrap().data else { panic!("no profile") };
    assert_relative_eq!(profile.spacing(), 2e-6, max_relative = 1e-12);
    let between = 0.5 * (profile.heights()[39] + profile.heights()[41]);
    assert_relative_eq!(profile.heights()[40], between, max_relative = 1e-9);
    let message = read(&SurfaceOptions::default()).unwrap_err().to_string();
    assert!(message.contains("1 of 100 are missing, the first in row 0, column 40"), "{message}");
}

/// Levels of one-third octave bands as EN 15610 has them, in any order, become a surface with their
/// height, with the filter those of the short waves; a wrong row is named.
#[test]
fn a_spectrum_of_octave_bands_is_a_surface() {
    let bands = "wavelength [mm],level [dB]\n10,0.5\n8,-0.5\n4,-3.1\n5,-2.2\n6.3,-1.4\n3.15,-4\n";
    let source = |text: &str, cutoff: Option<f64>, form: Option<Form>| {
        let name = "rail.csv".to_owned();
        let files = Arc::new(BTreeMap::from([(name.clone(), text.as_bytes().to_vec())]));
        let files = vec![InputFile::new(name, files)];
        let options = SurfaceOptions::default();
        let origin = SurfaceOrigin::Files { files, options, form, cutoff };
        SurfaceSource { origin, cells: None, seed: 1 }.load(FieldNames::CASE)
    };
    let height = |levels: &[f64]| {
        1e-6 * levels.iter().map(|level| 10.0_f64.powf(level / 10.0)).sum::<f64>().sqrt()
    };
    let rough = source(bands, None, Some(Form::Plane)).unwrap();
    let found = Statistics::of(&rough.surface).unwrap().root_mean_square_height;
    let all = height(&[0.5, -0.5, -3.1, -2.2, -1.4, -4.0]);
    // Lines have the levels; oblique waves, which are longer along a line, come on top.
    assert!((1.0..1.8).contains(&(found / all)), "{found} {all}");
    assert!(rough.remarks[0].contains("spectrum of waves from 2.8"), "{:?}", rough.remarks);
    let rough = source(bands, Some(4e-3), None).unwrap();
    let filtered = Statistics::of(&rough.surface).unwrap().root_mean_square_height;
    assert!((0.2..0.6).contains(&(filtered / found)), "{filtered}");

    let refused = |text: &str, expected: &str| {
        let message = source(text, None, None).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    };
    refused(
        &bands.replace("6.3,", "6.6,"),
        "rail.csv:6:1: the surface: wavelengths must be centres of one-third octave bands",
    );
    refused(&bands.replace("6.3,-1.4\n", ""), "rail.csv:5");
    refused(&bands.replace("[dB]", "[um]"), "must name its unit, dB");
    refused(&bands.replace(",level [dB]", ",height [um]"), "column `height [um]`");
    let message = source(bands, None, Some(Form::Sphere)).unwrap_err().to_string();
    assert!(message.contains("is a spectrum, which has no cylinder or sphere"), "{message}");
}

/// Goal: what a file leaves out of its lattice is a hole: a column, single points, all but every
/// third. Positions have few digits: 0.35 µm printed as mm with four decimals, so that gaps are 0.3
/// or 0.4 µm.
#[test]
fn points_lie_on_the_nearest_lattice() {
    type Kept<'a> = &'a dyn Fn(usize, usize) -> bool;
    let height = |i: usize, j: usize| (i as f64 / 3.0).sin() + (j as f64 / 4.0).cos();
    let text = |kept: Kept, spacing: f64, digits: usize| {
        let points = (0..30).flat_map(|j| (0..40).map(move |i| (i, j)));
        let lines = points.filter(|(i, j)| kept(*i, *j)).map(|(i, j)| {
            let [x, y] = [i, j].map(|k| k as f64 * spacing);
            format!("{x:.digits$} {y:.digits$} {:.9}\n", 1e-4 * height(i, j))
        });
        lines.collect::<String>()
    };
    let all = |_, _| true;
    let column = |i, _| i != 17;
    let columns = |i: usize, _| !(5..=17).contains(&i);
    let cases: [(Kept, f64, usize, f64); 4] = [
        (&all, 0.35e-3, 4, 0.0),
        (&column, 1e-3, 6, 1.0 / 40.0),
        (&columns, 1e-3, 6, 13.0 / 40.0),
        (&columns, 0.35e-3, 4, 13.0 / 40.0),
    ];
    for (kept, spacing, digits, share) in cases {
        let options = SurfaceOptions { unit: Some("mm".to_owned()), ..filled() };
        let bytes = text(kept, spacing, digits).into_bytes();
        let surface = from_bytes("a.xyz".to_owned(), bytes, &options).unwrap();
        assert_relative_eq!(surface.filled, share, max_relative = 1e-12);
        let SurfaceData::Map(map) = surface.data else { panic!("no map") };
        assert_eq!((map.lattice().columns, map.lattice().rows), (40, 30), "{spacing} {share}");
        assert_relative_eq!(map.lattice().spacing_x, 1e-3 * spacing, max_relative = 5e-3);
        for (cell, found) in map.heights().iter().enumerate() {
            let (i, j) = (cell % 40, cell / 40);
            if kept(i, j) {
                assert_relative_eq!(*found, 1e-7 * height(i, j), epsilon = 1e-12);
            }
        }
    }
}

/// A line along y, an array of one dimension or of one column, and a column of an X3P file are
/// profiles.
#[test]
fn a_line_in_any_direction_is_a_profile() {
    let height = |i: usize| (i as f64 * 0.3).sin();
    let lines: Vec<String> = (0..100).map(|i| format!("3,{},{}", 2 * i, height(i))).collect();
    let csv = format!("x [um],y [um],height [nm]\n{}\n", lines.join("\n")).into_bytes();
    let array = |shape: &str| {
        let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((header.len() as u16).to_le_bytes());
        bytes.extend(header.as_bytes());
        bytes.extend((0..100).flat_map(|i| height(i).to_le_bytes()));
        bytes
    };
    let data: Vec<u8> = (0..100).flat_map(|i| (1e3 * height(i)).round().to_le_bytes()).collect();
    let column = HEADER
        .replace("SUR", "PRF")
        .replace("<SizeX>3", "<SizeX>1")
        .replace("<SizeY>2", "<SizeY>100")
        .replace("<Increment>1e-6", "<Increment>2e-6")
        .replace("<DataType>I</DataType><Increment>1e-9", "<DataType>D</DataType><Increment>1e-12");
    let x3p = archive(&[("main.xml", column.as_bytes()), ("d.bin", &data)]);
    let options = SurfaceOptions {
        unit: Some("nm".to_owned()),
        spacing: Some([2e-6, 2e-6]),
        ..SurfaceOptions::default()
    };
    let files = [
        ("a.csv", csv),
        ("a.npy", array("(100,)")),
        ("a.npy", array("(1, 100)")),
        ("a.npy", array("(100, 1)")),
        ("a.x3p", x3p),
    ];
    for (name, bytes) in files {
        let read = from_bytes(name.to_owned(), bytes, &options).unwrap();
        let SurfaceData::Profile(profile) = read.data else { panic!("{name} is no profile") };
        assert_relative_eq!(profile.spacing(), 2e-6, max_relative = 1e-9);
        let step = profile.heights()[1] - profile.heights()[0];
        let slope = (profile.heights()[99] - profile.heights()[0] - 1e-9 * height(99)) / 99.0;
        assert_relative_eq!(step - slope, 1e-9 * height(1), epsilon = 2e-12);
    }
    let gaps = lines.iter().enumerate().filter(|(i, _)| *i < 45 || *i == 99);
    let gaps: Vec<&str> = gaps.map(|(_, line)| line.as_str()).collect();
    let text = format!("x [um],y [um],height [nm]\n{}\n", gaps.join("\n"));
    let refused = from_bytes("a.csv".to_owned(), text.into_bytes(), &filled()).unwrap_err();
    assert!(refused.to_string().contains("at most half of the points may be holes"), "{refused}");
}

/// Cells that are not square are refused, or the surface is resampled.
#[test]
fn cells_are_made_square_when_asked_for() {
    let name = "wave_not_square.x3p";
    let message = read(&sample(name), &SurfaceOptions::default()).unwrap_err().to_string();
    assert!(message.contains("must have square cells, but they are 1.5 µm by 3 µm"), "{message}");
    let square = SurfaceOptions { cells: Cells::MakeSquare, ..SurfaceOptions::default() };
    let map = map(name, &square);
    assert_eq!((map.lattice().columns, map.lattice().rows), (24, 16));
    assert!(map.lattice().has_square_cells());
}

#[test]
fn each_defect_of_a_file_is_named() {
    let plain = SurfaceOptions::default();
    let with_unit = SurfaceOptions { unit: Some("um".to_owned()), ..plain.clone() };
    let wrong_unit = SurfaceOptions { unit: Some("s".to_owned()), ..plain.clone() };
    let files = [
        ("wave_integers_holes.x3p", &plain, "2 of 384 are missing, the first in row 5, column 7"),
        ("wave_single_holes.x3p", &plain, "1 of 384 are missing, the first in row 5, column 7"),
        ("flat.x3p", &plain, "the surface must not be flat, but every height is 1e-6 m"),
        ("wave.npy", &plain, "contact_law.roughness.unit must be a unit of length, m, mm or µm"),
        ("wave.npy", &with_unit, "contact_law.roughness.spacing must be given"),
        ("wave_holes.xyz", &plain, "contact_law.roughness.unit must be a unit of length"),
        ("wave_holes.xyz", &wrong_unit, "`s` is the unit of a time"),
        ("wave_holes.xyz", &with_unit, "1 of 384 are missing"),
        ("make.py", &plain, "must be a .csv, .npy, .x3p or .xyz file, but is not"),
        ("none.x3p", &plain, "must be a readable file"),
    ];
    for (name, options, expected) in files {
        let message = read(&sample(name), options).unwrap_err().to_string();
        assert!(message.contains(expected), "{name}: {message}");
    }
    let texts = [
        ("a.csv", "x,y,height [um]\n0,0,1\n", "a.csv:1:1: column `x` must name its unit"),
        ("a.csv", "x [um],y [um],z [um]\n0,0,1\n", "has a column `z [um]`"),
        (
            "a.csv",
            "x [um],y [um],height [um]\n0,0,1\n1,0,2\n0,2,3\n0,3.3,4\n",
            "y must be equidistant, but its steps are between 0.0013 mm (from 0.002 mm to 0.0033 mm) and \
             0.002 mm (from 0 mm to 0.002 mm)",
        ),
        ("a.csv", "x [um],height [um]\n0,1\n1,2\n2,3\n1,2\n", "stands in line 3 too"),
        ("a.csv", "x [um],height [um]\n0,1\n1,2\n", "needs at least 64 entries, got 2"),
        ("a.csv", "x [um],y [um],height [um]\n0,0,1\nnan,0,2\n", "a.csv:3:1: x must be a finite"),
        ("a.xyz", "0 0 1\n1 0 2\n0 1\n", "a.xyz:3:1: a row must have 3 entries"),
        ("a.xyz", "0 0 1\n1 0 up\n", "a.xyz:2:1: height must be a finite number, but is \"up\""),
        ("a.xyz", "", "must have at least two values of x"),
        (
            "a.csv",
            "x [um],y [um],height [m]\n0,0,0\n1,0,2\n",
            "a.csv:3:1: contact_law.roughness.file must have",
        ),
        ("a.xyz", "0 0 1\n1 0 -3.4e38\n", "at most 1 m, but this one is -3.4e32 m"),
        ("a.x3p", "x", "must be an X3P file, a zip archive"),
        ("a.npy", "x", "must be an .npy file"),
    ];
    for (name, text, expected) in texts {
        let bytes = text.as_bytes().to_vec();
        let message = from_bytes(name.to_owned(), bytes, &with_unit).unwrap_err().to_string();
        assert!(message.contains(expected), "{name}: {message}");
    }
}

/// An X3P file of these members.
fn archive(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in members {
        writer.start_file(*name, SimpleFileOptions::default()).unwrap();
        writer.write_all(content).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

const HEADER: &str = "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1>\
<FeatureType>SUR</FeatureType><Axes>\
<CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX>\
<CY><AxisType>I</AxisType><Increment>-1e-6</Increment></CY>\
<CZ><AxisType>A</AxisType><DataType>I</DataType><Increment>1e-9</Increment></CZ></Axes></Record1>\
<Record3><MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ></MatrixDimension>\
<DataLink><PointDataLink>d.bin</PointDataLink></DataLink></Record3></p:ISO5436_2>";

#[test]
fn each_defect_of_an_x3p_file_is_named() {
    let data: Vec<u8> = (-2_i16..4).flat_map(i16::to_le_bytes).collect();
    let read = |header: &str, data: &[u8]| {
        let bytes = archive(&[("main.xml", header.as_bytes()), ("d.bin", data)]);
        from_bytes("a.x3p".to_owned(), bytes, &SurfaceOptions::default())
    };
    let SurfaceData::Map(map) = read(HEADER, &data).unwrap().data else { panic!("no map") };
    for (height, expected) in map.heights().iter().zip([-2e-9, -1e-9, 0.0, 1e-9, 2e-9, 3e-9]) {
        assert_relative_eq!(*height, expected, max_relative = 1e-14);
    }
    // As some programs write it.
    let legal = [
        (">d.bin<", ">./d.bin<"),
        (">d.bin<", ">/d.bin<"),
        (">d.bin<", ">.\\d.bin<"),
        ("<DataType>I</DataType><Increment>1e-9", "<DataType>I</DataType><Increment>0"),
    ];
    for (from, to) in legal {
        let data: Vec<u8> = [0_i16, 0, 1, 0, 0, 0].into_iter().flat_map(i16::to_le_bytes).collect();
        let found = read(&HEADER.replace(from, to), &data);
        assert!(found.is_ok(), "{from:?} -> {to:?}: {}", found.unwrap_err());
    }
    let cases = [
        ("SUR", "PCL", "must be a surface (SUR) or a profile (PRF), but is \"PCL\""),
        ("SUR", "PRF", "SizeX, SizeY, SizeZ = 3, 2, 1"),
        ("<Record1>", "<Record9>", "must have a main.xml in XML"),
        ("<SizeX>3", "<SizeX>4", "must have 16 bytes in d.bin for 4 by 2 numbers of type I"),
        ("<SizeX>3", "<SizeX>2", "must have at most 8 bytes in d.bin, but has more"),
        ("<SizeX>3", "<SizeX>0", "must have a positive SizeX, but has \"0\""),
        ("<SizeX>3", "<SizeX>99999999999", "must have at most 268435456 points"),
        ("<SizeZ>1", "<SizeZ>2", "must have one layer"),
        ("<Increment>1e-6", "<Increment>0", "must have a step of CX that is not 0 m"),
        ("<Increment>1e-6", "<Increment>x", "must have a finite number as Increment of CX"),
        ("<Increment>1e-6</Increment>", "", "must have an Increment of CX"),
        ("<AxisType>I", "<AxisType>A", "must have points at regular steps, but CX has AxisType A"),
        ("<DataType>I", "<DataType>Q", "must have numbers of type I, L, F or D, but has \"Q\""),
        ("<PointDataLink>d", "<PointDataLink>e", "must have a file e.bin in its archive"),
        ("DataLink>", "Data>", "neither DataLink nor DataList"),
        ("<FeatureType>SUR</FeatureType>", "", "must have Record1/FeatureType in main.xml"),
        (
            "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>",
            "<DataList><Datum>1</Datum></DataList>",
            "must have 3 by 2 heights in DataList, but has 1",
        ),
        (
            "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>",
            "<DataList><Datum>up</Datum></DataList>",
            "must have numbers in DataList, but has \"up\"",
        ),
        ("</DataLink>", "<ValidPointsLink>d.bin</ValidPointsLink></DataLink>", "at most 1 bytes"),
    ];
    for (from, to, expected) in cases {
        let header = HEADER.replace(from, to);
        let message = read(&header, &data).unwrap_err().to_string();
        assert!(message.contains(expected), "{from:?} -> {to:?}: {message}");
    }
    let no_header = archive(&[("d.bin", &data)]);
    let message = from_bytes("a.x3p".to_owned(), no_header, &SurfaceOptions::default());
    assert!(message.unwrap_err().to_string().contains("must have a file main.xml"));
}

/// No file makes it panic, however it is cut off or garbled.
#[test]
fn damaged_files_are_refused() {
    for name in ["wave.x3p", "wave_integers_holes.x3p", "profile.x3p", "wave.npy"] {
        let bytes = std::fs::read(sample(name)).unwrap();
        let options =
            SurfaceOptions { unit: Some("um".to_owned()), spacing: Some([1e-6, 1e-6]), ..filled() };
        for length in (0..bytes.len()).step_by(7) {
            let cut = from_bytes(name.to_owned(), bytes[..length].to_vec(), &options);
            assert!(cut.is_err(), "{name} cut to {length}");
        }
        for at in (0..bytes.len()).step_by(11) {
            let mut garbled = bytes.clone();
            garbled[at] ^= 0x55;
            let _ = from_bytes(name.to_owned(), garbled, &options);
        }
    }
}
