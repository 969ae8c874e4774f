//! CSV, JSON, summary and figure of made-up temperatures along lines.

use schlupf::Status;
use schlupf::reporting::Message;
use schlupf_tasks::output::Report;
use schlupf_tasks::output::figures::FigureError;
use schlupf_tasks::output::temperature::{Line, Positions, Row, Temperatures};

/// A hot wheel (100 °C) on a cold rail, which mix in the contact from x = 6 to −6 mm.
fn made_up(points: u32) -> Temperatures {
    let share = |k: u32| f64::from(k) / f64::from(points - 1);
    let positions = |start: f64, end: f64| -> Vec<f64> {
        (0..points).map(|k| start + (end - start) * share(k)).collect()
    };
    let line = |position: Vec<f64>| {
        let wheel = position.iter().map(|s| 100.0 - 3e3 * (s - 4e-3).abs()).collect();
        let rail = position.iter().map(|s| 3e3 * (s - 4e-3).abs()).collect();
        Line { position, wheel, rail }
    };
    let row = |depth| Row { depth, line: line(positions(-20e-3, 8e-3)) };
    Temperatures {
        title: "a <hot> wheel".to_owned(),
        status: Status::Converged,
        request: Positions {
            point: [-3e-3, 0.0],
            passage: [6e-3, -6e-3],
            depths: vec![0.0, 1e-3],
            wake: 14e-3,
            row_depths: [40e-6, 80e-6],
            points: points as usize,
        },
        bulk: [100.0, 0.0],
        profile: line(positions(0.0, 1e-3)),
        rows: [0.0, 40e-6, 80e-6].map(row).to_vec(),
        warnings: vec![
            Message::new("beware", "heat", "a warning"),
            Message::new(Message::NOT_CONVERGED, "heat", "a reason"),
        ],
    }
}

/// The only drawing.
fn drawing(report: &impl Report) -> String {
    report.drawings().unwrap().remove(0).1
}

#[test]
fn the_table_has_every_point_and_reads_back() {
    let temperatures = made_up(5);
    let table = temperatures.csv().unwrap();
    let rows: Vec<Vec<&str>> = table.lines().skip(2).map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 4 * 5);
    assert_eq!(&rows[4][..4], ["profile", "-3e-3", "0e0", "1e-3"]);
    let of = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    assert_eq!(of(10, 3), 40e-6);
    assert_eq!(of(6, 1), temperatures.rows[0].line.position[1]);
    assert_eq!(of(6, 5), temperatures.rows[0].line.rail[1]);
}

#[test]
fn json_has_its_keys() {
    let temperatures = made_up(5);
    let value: serde_json::Value = serde_json::from_str(&temperatures.json()).unwrap();
    let keys: Vec<&String> = value.as_object().unwrap().keys().collect();
    let expected =
        ["bulk", "contact", "point", "profile", "program", "rows", "status", "title", "warnings"];
    assert_eq!(keys, expected);
    assert_eq!(value["contact"]["trailing_edge"], -6e-3);
    assert_eq!(value["rows"][2]["depth"], 80e-6);
    assert_eq!(value["rows"][0]["wheel"].as_array().unwrap().len(), 5);
    assert_eq!(value["profile"]["depth"][4], 1e-3);
}

#[test]
fn the_summary_shows_some_points_and_all_warnings() {
    let text = made_up(101).summary().to_string();
    for part in [
        "a <hot> wheel",
        "below x = -3 mm, y = 0 mm",
        "in contact from x = 6 to -6 mm",
        "(11 of 101 points; CSV and JSON have all)",
        "bulk temperatures: wheel 100 °C, rail 0 °C",
        "  a reason",
    ] {
        assert!(text.contains(part), "{part:?} is not in\n{text}");
    }
    assert!(made_up(2).summary().to_string().contains("depth (mm)"));
}

#[test]
fn the_figure_names_wheel_rail_and_depths() {
    let mut temperatures = made_up(40);
    temperatures.status = Status::NotConverged;
    let svg = drawing(&temperatures);
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let document = roxmltree::Document::parse(&svg).unwrap();
    let texts: String = document
        .descendants()
        .filter(roxmltree::Node::is_text)
        .filter_map(|node| node.text())
        .collect::<Vec<_>>()
        .join(" ");
    for part in ["a <hot> wheel", "contact", "not converged"] {
        assert!(texts.contains(part), "{part:?}");
    }
    for body in ["wheel", "rail"] {
        for depth in ["", ", 40 µm deep", ", 80 µm deep"] {
            assert!(texts.contains(&format!("{body}{depth}")), "{body}{depth}");
        }
    }
    assert!(temperatures.figures().unwrap()[0].png.starts_with(b"\x89PNG"));
    let mut nothing = made_up(5);
    nothing.profile = Line::default();
    assert_eq!(nothing.drawings(), Err(FigureError::NoTemperature));
    let mut broken = made_up(5);
    broken.rows[0].line.wheel[2] = f64::NAN;
    assert!(!drawing(&broken).contains("NaN"));
}
