//! JSON, CSV, summary and figures of the damage over a made-up run.

use std::collections::BTreeSet;

use schlupf::Status;
use schlupf::analysis::damage::{Laws, RunPoint, State, of_run};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::damage::{DamageReport, LeftOut};

/// A patch that wanders across the profile while the slip grows.
fn report(states: usize, left_out: LeftOut) -> DamageReport {
    let state = |k: usize| {
        let part = k as f64 / states as f64;
        let slip_speed = 0.01 + 0.3 * part;
        State {
            distance: 10.0,
            middle: 10.0 * (k as f64 + 0.5),
            speed: 20.0,
            position_y: 5e-3 * (20.0 * part).sin(),
            rail_position_y: 5e-3 * (20.0 * part).sin(),
            is_further_contact: false,
            load: 80e3,
            semi_axis_x: 6e-3,
            semi_axis_y: 4e-3,
            peak_pressure: 1.6e9,
            contact_area: 7.5e-5,
            tangential_force: 30e3 * part,
            t_gamma: 30e3 * slip_speed / 20.0,
            friction_power: 30e3 * slip_speed,
            friction_coefficient: 0.4,
        }
    };
    let laws = Laws::default();
    let run: Vec<State> = (0..states).map(state).collect();
    let damage = of_run(&run, &laws).unwrap();
    DamageReport { title: "a run".to_owned(), laws, damage, left_out, warnings: Vec::new() }
}

#[test]
fn json_has_its_keys() {
    let document: serde_json::Value =
        serde_json::from_str(&report(50, LeftOut::default()).json()).unwrap();
    let keys = |value: &serde_json::Value| -> BTreeSet<String> {
        value.as_object().unwrap().keys().cloned().collect()
    };
    let set =
        |names: &str| -> BTreeSet<String> { names.split_whitespace().map(str::to_owned).collect() };
    let names = "program title status laws states distance duration energy t_gamma fatigue cracks archard \
                 energy_wear histograms left_out profile warnings";
    assert_eq!(keys(&document), set(names));
    assert_eq!(keys(&document["fatigue"]), set("max mean share mean_excess"));
    let wear = set("wheel_mass rail_mass_per_length wheel_volume");
    assert_eq!(keys(&document["archard"]), wear);
    assert_eq!(document["laws"]["shear_yield_stress"], 300e6);
    assert_eq!(document["histograms"][1]["quantity"], "fatigue_index");
    let columns = "y wheel_archard wheel_energy rail_archard rail_energy";
    assert_eq!(keys(&document["profile"]), set(columns));
    assert_eq!((&document["status"], &document["states"]), (&"converged".into(), &50.into()));
}

#[test]
fn tables_have_their_rows() {
    let report = report(50, LeftOut::default());
    let profile = report.csv().unwrap();
    assert!(profile.starts_with("# units: m, m, m, m, m; wheel: over the run"), "{profile}");
    assert_eq!(profile.lines().count(), 2 + report.damage.profile.y.len());
    let run = String::from_utf8(report.own_file(DamageReport::RUN).unwrap()).unwrap();
    let head =
        "distance,position_y,t_gamma,fatigue_index,crack_damage,energy,archard_wear,energy_wear";
    assert_eq!(run.lines().nth(1), Some(head));
    assert_eq!(run.lines().count(), 52);
    assert!(report.own_file("vtk").is_none());
}

#[test]
fn the_summary_fits_a_terminal_and_tells_what_is_left_out() {
    let text = report(50, LeftOut::default()).summary().to_string();
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    for part in ["a run", "0.5 km", "mean Tγ", "fatigue index", "k = 300 MPa", "converged"] {
        assert!(text.contains(part), "{part:?} is not in\n{text}");
    }
    let gaps = report(50, LeftOut { states: 3, distance: 30.0 });
    assert_eq!(gaps.status(), Status::NotConverged);
    assert!(gaps.summary().to_string().contains("3 states over 30 m are left out"));
}

/// Also of a single state, of one without slip, and of more states than points of a curve.
#[test]
fn figures_are_drawn_of_any_run() {
    for states in [1, 2, 5000] {
        let mut report = report(states, LeftOut { states: 1, distance: 1.0 });
        if states == 2 {
            // At rest in the middle, without slip.
            for point in &mut report.damage.points {
                *point = RunPoint { position_y: 0.0, t_gamma: 0.0, energy: 0.0, ..*point };
            }
        }
        let drawings = report.drawings().unwrap();
        let names: Vec<String> = drawings.iter().map(|(name, _)| name.clone()).collect();
        assert_eq!(names, DamageReport::figure_names());
        for (name, svg) in drawings {
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name} of {states}");
            assert!(svg.contains("some states are left out"));
            assert!(svg.len() < 300_000, "{name}: {}", svg.len());
        }
    }
    let figures = report(50, LeftOut::default()).figures().unwrap();
    assert_eq!(figures[0].png[..4], *b"\x89PNG");
}
