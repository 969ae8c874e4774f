//! CSV, JSON, .npy, summary and figures of a small rough contact.

use schlupf::interface::roughness::tangential_curve::SimilarBodies;
use schlupf::interface::roughness::{LoadCurveOptions, MicroModel};
use schlupf::reporting::Message;
use schlupf::surface::spectrum::{RadialSpectrum, Window};
use schlupf::surface::synthesis::{Roughness, SelfAffine};
use schlupf::{Status, unwatched};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::contact_law::{ContactLaw, Fit, Origin};
use schlupf_tasks::output::figures::FigureError;
use schlupf_tasks::output::roughness::{RoughnessReport, Spots};
use schlupf_tasks::output::table::Values;

/// Steel, 64² cells, two pressures.
fn report() -> RoughnessReport {
    let spectrum = SelfAffine {
        roughness: Roughness::Height(1e-6),
        hurst_exponent: 0.8,
        longest_wavelength: 1e-4,
        roll_off_wavelength: 1e-4,
        shortest_wavelength: 2.5e-5,
    };
    let surface = spectrum.surface(schlupf::surface::Lattice::square(64, 4e-4), 1).unwrap();
    let bodies = SimilarBodies { friction_coefficient: 0.4, poisson_ratio: 0.28 };
    let model = MicroModel {
        surface: surface.clone(),
        contact_modulus: 114e9,
        bodies,
        hardness: f64::INFINITY,
        mean_pressures: vec![4e8, 1e9],
    };
    let result = model.solve(&LoadCurveOptions::default(), &unwatched).unwrap();
    let share = |k: usize| if k.is_multiple_of(5) { 2e9 } else { 0.0 };
    let lattice = *surface.lattice();
    RoughnessReport {
        title: "a <rough> surface".to_owned(),
        spectrum: RadialSpectrum::of(&surface, Window::None),
        surface,
        bodies,
        contact_modulus: 114e9,
        hardness: f64::INFINITY,
        result,
        spots: Some(Spots {
            lattice,
            mean_pressure: 1e9,
            pressure: (0..64 * 64).map(share).collect(),
            gap: vec![0.0; 64 * 64],
            is_converged: true,
        }),
        remarks: vec!["a remark".to_owned()],
        warnings: vec![Message::new("beware", "surface", "a warning")],
    }
}

#[test]
fn the_table_has_every_point_and_reads_back() {
    let report = report();
    let table = report.csv().unwrap();
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(2)
        .map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let curves = &report.result.tangential;
    assert_eq!(rows.len(), curves[0].points.len() + curves[1].points.len());
    assert_eq!(table.lines().nth(1).unwrap().split(',').count(), rows[0].len());
    let point = &curves[0].points[7];
    assert_eq!(rows[7][..4], [4e8, point.displacement, point.traction, point.normalised_traction]);
    let fit = report.result.stiffness.fits[0].stiffness;
    assert!((rows[7][8] - (1.0 - (-fit * point.displacement).exp())).abs() < 1e-12);
}

/// All cells with their places, those that do not touch without pressure; nothing unless the spots
/// were asked for.
#[test]
fn the_spots_are_a_table_of_cells() {
    let mut report = report();
    let columns = |report: &RoughnessReport| {
        let mut tables = report.tables().into_iter();
        tables.find(|(name, _)| *name == "spots").map(|(_, columns)| columns)
    };
    let of = |name: &str| {
        let columns = columns(&report).unwrap();
        let column = columns.into_iter().find(|column| column.name == name).unwrap();
        let Values::Numbers(numbers) = column.values else { panic!("{name}") };
        numbers
    };
    let (x, y, pressure) = (of("x"), of("y"), of("pressure"));
    assert_eq!([x.len(), of("gap").len()], [64 * 64; 2]);
    let spacing = 4e-4 / 64.0;
    assert_eq!([x[65], y[65]], [spacing; 2]);
    assert_eq!(pressure.iter().filter(|p| **p > 0.0).count(), (64_usize * 64).div_ceil(5));
    report.spots = None;
    assert!(columns(&report).is_none());
}

#[test]
fn json_has_its_keys() {
    let report = report();
    let value: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
    let keys: Vec<&String> = value.as_object().unwrap().keys().collect();
    let expected = [
        "bodies",
        "contact_law",
        "normal",
        "pressures",
        "program",
        "remarks",
        "spectrum",
        "status",
        "surface",
        "title",
        "warnings",
    ];
    assert_eq!(keys, expected);
    assert!(value["bodies"]["hardness"].is_null());
    assert_eq!(value["surface"]["columns"], 64);
    assert_eq!(value["pressures"][1]["mean_pressure"], 1e9);
    let stiffness = report.result.stiffness.common.stiffness;
    assert_eq!(value["contact_law"]["stiffness"], stiffness);
    assert_eq!(value["contact_law"]["closed_form"]["slope_factor"], 0.45);
    assert_eq!(value["normal"]["approach"].as_array().unwrap().len(), 25);
}

/// The header of NumPy's format 1.0: its length makes the data begin at a multiple of 64.
#[test]
fn heights_are_a_file_of_numpy() {
    let report = report();
    let bytes = report.own_file(RoughnessReport::HEIGHTS).unwrap();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let start = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!(start % 64, 0);
    assert_eq!(bytes[start - 1], b'\n');
    assert_eq!(bytes.len(), start + 8 * 64 * 64);
    let cell = start + 8 * 65;
    let height = f64::from_le_bytes(bytes[cell..cell + 8].try_into().unwrap());
    assert_eq!(height, report.surface.heights()[65]);
    let file = |format| report.own_file(format).unwrap();
    let [pressure, gap] = [RoughnessReport::PRESSURES, RoughnessReport::GAPS].map(file);
    assert_eq!((pressure.len(), gap.len()), (bytes.len(), bytes.len()));
    let value = |bytes: &[u8]| f64::from_le_bytes(bytes[cell..cell + 8].try_into().unwrap());
    assert_eq!([value(&pressure), value(&gap)], [2e9, 0.0]);
}

#[test]
fn the_summary_shows_statistics_pressures_and_warnings() {
    let mut report = report();
    report.hardness = 2.5e9;
    let text = report.summary().to_string();
    for part in [
        "a <rough> surface",
        "64 x 64 cells of 6.25 µm, 0.4 x 0.4 mm",
        "Sq                              1 µm",
        "in the spots at 1000 MPa: mean ",
        "E* = 114 GPa, ν = 0.28, μ0 = 0.4, hardness 2.5 GPa",
        "           400",
        "k_c",
        "closed form",
        "γ = 0.45",
        "converged; 25 loads",
        "\na remark\n",
    ] {
        assert!(text.contains(part), "{part:?} is not in\n{text}");
    }
    report.spots.as_mut().unwrap().is_converged = false;
    assert_eq!(report.status(), Status::NotConverged);
    assert!(report.summary().to_string().contains("NOT CONVERGED"));
}

fn texts(svg: &str) -> String {
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(roxmltree::Node::is_text);
    texts.filter_map(|node| node.text()).collect::<Vec<_>>().join(" ")
}

#[test]
fn the_figures_name_what_they_show() {
    let report = report();
    let drawings = report.drawings().unwrap();
    let fraction = report.result.normal.corrected_contact_fraction(1e9);
    let fraction = format!("{} % in contact", (1e4 * fraction).round() / 100.0);
    assert_eq!(
        drawings.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(),
        RoughnessReport::figure_names()
    );
    let parts: [&[&str]; 4] = [
        &["a <rough> surface", "400 MPa", "1000 MPa", "Eq. (8) with ", "displacement"],
        &["The surface", "height (µm)", " (µm)"],
        &["Contact spots", &fraction, "pressure (GPa)"],
        &["wave number", "mean over all directions", "10"],
    ];
    for ((name, svg), parts) in drawings.iter().zip(parts) {
        let texts = texts(svg);
        for part in parts {
            assert!(texts.contains(part), "{name}: {part:?} is not in {texts}");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf "), "{name}");
    }
    for figure in report.figures().unwrap() {
        assert!(figure.png.starts_with(b"\x89PNG"), "{}", figure.name);
    }
}

/// Eq. (8) is no pressure: it comes after them. Both panels tell which colour is which pressure.
#[test]
fn the_legends_list_the_pressures_and_then_the_law() {
    let svg = report().drawings().unwrap().remove(0).1;
    let document = roxmltree::Document::parse(&svg).unwrap();
    let lines = document.descendants().filter(|node| node.has_tag_name("text"));
    let line = |node: roxmltree::Node| -> String {
        node.descendants().filter(roxmltree::Node::is_text).filter_map(|n| n.text()).collect()
    };
    let lines: Vec<String> = lines.map(line).collect();
    let starts: Vec<&str> = lines
        .iter()
        .filter(|line| line.ends_with("MPa") || line.starts_with("Eq. (8)"))
        .map(|line| line.split(" with").next().unwrap())
        .collect();
    let law = "Eq. (8), fitted to each";
    assert_eq!(starts, ["400 MPa", "1000 MPa", law, "400 MPa", "1000 MPa", "Eq. (8)"]);
}

#[test]
fn what_is_not_there_is_not_drawn() {
    let mut report = report();
    report.spots = None;
    report.spectrum = RadialSpectrum::default();
    let names: Vec<_> = report.drawings().unwrap().into_iter().map(|d| d.0).collect();
    assert_eq!(names, RoughnessReport::figure_names()[..2]);
    report.result.tangential.clear();
    assert_eq!(report.drawings(), Err(FigureError::NoTangentialCurve));
}

/// Where k_c comes from stands in the result.
#[test]
fn a_contact_law_has_its_keys() {
    let law = ContactLaw {
        stiffness: 3e6,
        from: Origin::MicroModel,
        rms_height: Some(1e-6),
        slope_factor: None,
        fit: Some(Fit {
            mean_pressures: vec![1e9],
            stiffnesses: vec![3e6],
            spread: 0.0,
            root_mean_square_error: 0.02,
            largest_error: 0.04,
            closed_form: 3.3e6,
        }),
    };
    let value = serde_json::to_value(&law).unwrap();
    assert_eq!(value["fit"]["stiffnesses"][0], 3e6);
    assert!(value.get("slope_factor").is_none());
}
