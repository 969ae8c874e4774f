//! A comparison of methods as text, tables and figure.

use crate::common::{RECIPE, solution};
use schlupf::problem::{AreaReduction, FastMethod};
use schlupf::reporting::Message;
use schlupf::{Method, Solution, Status};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::comparison::{Answer, Comparison, Entry};
use schlupf_tasks::output::figures::{Figure, FigureError};

/// The full method and Polach's, which gives neither moment nor temperature.
fn comparison() -> Comparison {
    let full = solution(RECIPE);
    let mut polach = Solution {
        method: Method::Fast(FastMethod::Polach(AreaReduction::DRY)),
        ..solution(RECIPE)
    };
    (polach.force.moment_z, polach.normalised.moment_z) = (None, None);
    polach.temperature = None;
    let entry = |name, method, elasticity, solution| Entry {
        name,
        method,
        elasticity,
        normal: None,
        answer: Ok(Answer { solution, time: 2.5e-3, time_again: 1e-7 }),
    };
    let entries = vec![
        entry("full, half-space", "full", Some("half-space"), full),
        entry("Polach", "polach", None, polach),
    ];
    let warnings = vec![Message::new("beware", "method", "full, half-space: a warning")];
    Comparison { title: "both".to_owned(), entries, warnings }
}

/// The same with a method in between that cannot answer.
fn with_a_gap() -> Comparison {
    let mut comparison = comparison();
    let gap = Entry {
        name: "full, elastic layer",
        method: "full",
        elasticity: Some("elastic-layer"),
        normal: None,
        answer: Err("no \"stiffness\", anywhere".to_owned()),
    };
    comparison.entries.insert(1, gap);
    comparison
}

fn figure(comparison: &Comparison) -> Figure {
    comparison.figures().unwrap().remove(0)
}

/// All texts of a figure.
fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let text = |node: roxmltree::Node| {
        let parts = node.descendants().filter(roxmltree::Node::is_text);
        parts.filter_map(|part| part.text().map(str::to_owned)).collect()
    };
    document.descendants().filter(|node| node.has_tag_name("text")).map(text).collect()
}

#[test]
fn json_has_null_for_what_is_not_given() {
    let document: serde_json::Value = serde_json::from_str(&comparison().json()).unwrap();
    let [full, polach] = [0, 1].map(|k| &document["methods"][k]);
    assert_eq!(
        (full["method"].as_str(), full["elasticity"].as_str()),
        (Some("full"), Some("half-space"))
    );
    assert_eq!(polach["method"], "polach");
    assert!(polach["force"]["moment_z"].is_null() && polach["max_rise"].is_null());
    assert!(polach["elasticity"].is_null() && polach["force"]["x"].is_number());
    assert_eq!(polach["time_again"], 1e-7);
    assert_eq!(document["warnings"][0]["code"], "beware");
}

#[test]
fn csv_has_empty_entries_for_what_is_not_given() {
    let table = comparison().csv().unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    let at = |row: usize, name: &str| {
        rows[row][headers.iter().position(|header| header == name).unwrap()].to_owned()
    };
    assert_eq!((at(0, "method"), at(1, "method")), ("full".to_owned(), "polach".to_owned()));
    assert_eq!((at(1, "moment_z"), at(1, "max_rise"), at(1, "elasticity")), Default::default());
    assert_eq!(at(0, "moment_z").parse::<f64>().unwrap(), 3.0);
    assert_eq!(at(1, "status"), "converged");
}

#[test]
fn the_table_marks_what_is_not_given_or_not_converged() {
    let mut comparison = comparison();
    comparison.entries[0].answer.as_mut().unwrap().solution.status = Status::NotConverged;
    assert_eq!(comparison.status(), Status::NotConverged);
    let text = comparison.summary().to_string();
    let line = |name: &str| text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("full, half-space").ends_with("NOT CONVERGED"), "{text}");
    assert_eq!(line("Polach").matches('–').count(), 2, "{text}");
}

#[test]
fn the_figure_has_a_bar_or_a_word_for_every_number() {
    let figure = figure(&comparison());
    assert_eq!(figure.name, "comparison");
    let texts = texts(&figure.svg);
    assert!(texts.iter().any(|text| text == "Polach"), "{texts:?}");
    assert_eq!(texts.iter().filter(|text| *text == "not given").count(), 2);
    // The time is 2.5 ms from nothing.
    assert!(texts.iter().any(|text| text == "time (ms)"), "{texts:?}");
    assert_eq!(texts.iter().filter(|text| *text == "2.5").count(), 2, "{texts:?}");
    let nothing = Comparison { title: String::new(), entries: Vec::new(), warnings: Vec::new() };
    assert_eq!(nothing.figures().unwrap_err(), FigureError::NothingToCompare);
}

#[test]
fn a_method_without_an_answer_says_why() {
    let comparison = with_a_gap();
    assert_eq!(comparison.status(), Status::Converged);
    let document: serde_json::Value = serde_json::from_str(&comparison.json()).unwrap();
    let gap = &document["methods"][1];
    assert_eq!(gap["status"], "not-available");
    assert_eq!(gap["reason"], "no \"stiffness\", anywhere");
    assert!(gap["force"]["x"].is_null() && gap["time"].is_null(), "{gap}");
    assert!(document["methods"][0]["reason"].is_null());
    let text = comparison.summary().to_string();
    let reason = "not available: no \"stiffness\", anywhere";
    assert!(text.lines().any(|line| line.ends_with(reason)), "{text}");
    let table = comparison.csv().unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    let width = reader.headers().unwrap().len();
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    let filled: Vec<&str> = rows[1].iter().filter(|entry| !entry.is_empty()).collect();
    assert_eq!(rows[1].len(), width);
    let expected = ["full", "elastic-layer", "not-available", "no \"stiffness\", anywhere"];
    assert_eq!(filled, expected);
}

/// The figure has no row for it, but a note.
#[test]
fn the_figure_leaves_out_what_has_no_answer() {
    let texts = texts(&figure(&with_a_gap()).svg);
    assert!(!texts.iter().any(|text| text == "full, elastic layer"), "{texts:?}");
    let note = "full, elastic layer: not available: no \"stiffness\", anywhere";
    assert!(texts.iter().any(|text| text == note), "{texts:?}");
    let mut nothing = with_a_gap();
    nothing.entries.retain(|entry| entry.answer.is_err());
    assert_eq!(nothing.figures().unwrap_err(), FigureError::NothingToCompare);
}

/// Whatever the signs and sizes, the numbers end within the frames of their columns.
#[test]
fn numbers_stay_within_their_frame() {
    for values in [[0.03319, 0.1403], [-0.01803, 0.1403], [-0.1403, -1e-5], [0.1403, -0.1403]] {
        let mut comparison = comparison();
        for (entry, value) in comparison.entries.iter_mut().zip(values) {
            let solution = &mut entry.answer.as_mut().unwrap().solution;
            solution.force.x = -value * solution.normal.load;
        }
        let svg = figure(&comparison).svg;
        let document = roxmltree::Document::parse(&svg).unwrap();
        let number = |node: roxmltree::Node, name: &str| -> f64 {
            node.attribute(name).unwrap().parse().unwrap()
        };
        let is_frame = |node: &roxmltree::Node| {
            node.has_tag_name("rect") && node.attribute("fill") == Some("none")
        };
        let frame = document.descendants().find(is_frame).unwrap();
        let [left, width] = ["x", "width"].map(|name| number(frame, name));
        let [top, height] = ["y", "height"].map(|name| number(frame, name));
        let mut seen = 0;
        for node in document.descendants().filter(|node| node.has_tag_name("text")) {
            let [x, y] = ["x", "y"].map(|name| number(node, name));
            let is_inside = x > left && x < left + width && y > top && y < top + height;
            let Some(text) = node.text().filter(|_| is_inside) else { continue };
            // A digit of the font has 0.636 of its size, a minus sign 0.838.
            let length = 13.0 * (0.636 * text.chars().count() as f64 + 0.21);
            let ends = match node.attribute("text-anchor") {
                Some("end") => [x - length, x],
                Some("start") => [x, x + length],
                _ => [x - 0.5 * length, x + 0.5 * length],
            };
            assert!(ends[0] > left && ends[1] < left + width, "{text} at {ends:?}");
            seen += 1;
        }
        assert_eq!(seen, 2);
    }
}

/// A logarithmic axis has no zero from which a bar could start: two dots for each of the methods.
#[test]
fn times_are_dots() {
    let comparison = comparison();
    let svg = figure(&comparison).svg;
    let document = roxmltree::Document::parse(&svg).unwrap();
    let dots = document.descendants().filter(|node| node.has_tag_name("circle"));
    assert_eq!(dots.count(), 2 * comparison.entries.len());
}

/// A second solution may take longer than the first: the number is to the right of both dots.
#[test]
fn times_are_not_written_under_dots() {
    let mut comparison = comparison();
    for entry in &mut comparison.entries {
        let answer = entry.answer.as_mut().unwrap();
        answer.time_again = 3.0 * answer.time;
    }
    let svg = figure(&comparison).svg;
    let document = roxmltree::Document::parse(&svg).unwrap();
    let number = |node: roxmltree::Node, name: &str| -> f64 {
        node.attribute(name).unwrap().parse().unwrap()
    };
    let circles = document.descendants().filter(|node| node.has_tag_name("circle"));
    let dots: Vec<[f64; 2]> = circles.map(|node| ["cx", "cy"].map(|n| number(node, n))).collect();
    let times = document.descendants().filter(|node| node.text() == Some("2.5"));
    let mut seen = 0;
    for time in times.filter(|node| node.has_tag_name("text")) {
        let row = dots.iter().filter(|[_, y]| (y - number(time, "y")).abs() < 10.0);
        assert!(row.clone().all(|[x, _]| *x + 4.0 < number(time, "x")), "{dots:?}");
        seen += row.count();
    }
    assert_eq!(seen, dots.len());
}
