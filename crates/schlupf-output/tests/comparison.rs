//! A comparison of methods as text, tables and figure.

mod common;

use common::{RECIPE, solution};
use schlupf::method::AreaReduction;
use schlupf::solution::Temperature;
use schlupf::{Method, Solution, Status};
use schlupf_output::comparison::{Comparison, Entry, csv, json, summary};
use schlupf_output::figures::{self, FigureError};

/// The full method and Polach's, which gives neither moment nor temperature.
fn comparison() -> Comparison {
    let full = solution(RECIPE);
    let mut polach = Solution { method: Method::Polach(AreaReduction::DRY), ..solution(RECIPE) };
    polach.force.moment_z = f64::NAN;
    polach.normalised.moment_z = f64::NAN;
    polach.temperature = Temperature { max_rise: f64::NAN, ..polach.temperature };
    let entry = |name, elasticity, solution| Entry {
        name,
        elasticity,
        solution,
        time: 2e-3,
        time_again: 1e-7,
    };
    let entries =
        vec![entry("full, half-space", Some("half-space"), full), entry("Polach", None, polach)];
    Comparison { title: "both".to_owned(), entries }
}

#[test]
fn json_has_null_for_what_is_not_given() {
    let document: serde_json::Value = serde_json::from_str(&json::document(&comparison())).unwrap();
    let [full, polach] = [0, 1].map(|k| &document["methods"][k]);
    assert_eq!(
        (full["method"].as_str(), full["elasticity"].as_str()),
        (Some("full"), Some("half-space"))
    );
    assert_eq!(polach["method"], "polach");
    assert!(polach["force"]["moment_z"].is_null() && polach["max_rise"].is_null());
    assert!(polach["elasticity"].is_null() && polach["force"]["x"].is_number());
    assert_eq!(polach["time_again"], 1e-7);
    assert!(document["warnings"][0].as_str().unwrap().starts_with("full, half-space: a warning"));
}

#[test]
fn csv_has_empty_entries_for_what_is_not_given() {
    let table = csv::table(&comparison());
    let mut reader = ::csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
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
    comparison.entries[0].solution.status = Status::NotConverged;
    assert!(!comparison.is_converged());
    let text = summary::text(&comparison);
    let line = |name: &str| text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("full, half-space").ends_with("NOT CONVERGED"), "{text}");
    assert_eq!(line("Polach").matches('–').count(), 2, "{text}");
}

#[test]
fn the_figure_has_a_bar_or_a_word_for_every_number() {
    let figure = figures::comparison(&comparison()).unwrap();
    assert_eq!(figure.name, "comparison");
    let document = roxmltree::Document::parse(&figure.svg).unwrap();
    let texts: Vec<String> = document
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| {
            node.descendants()
                .filter(roxmltree::Node::is_text)
                .filter_map(|part| part.text())
                .collect()
        })
        .collect();
    assert!(texts.iter().any(|text| text == "Polach"), "{texts:?}");
    assert_eq!(texts.iter().filter(|text| *text == "not given").count(), 2);
    let nothing = Comparison { title: String::new(), entries: Vec::new() };
    assert_eq!(figures::comparison(&nothing).unwrap_err(), FigureError::NothingToCompare);
}
