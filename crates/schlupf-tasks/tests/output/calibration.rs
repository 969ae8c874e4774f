//! The figure of a made-up calibration.

use schlupf::Status;
use schlupf::analysis::calibration::side_by_side::{Answer, Course, Model, SideBySide};
use schlupf::normal::NormalSummary;
use schlupf_tasks::output::Report;
use schlupf_tasks::output::calibration::CalibrationReport;

fn course() -> Course {
    let models = [Model::HalfSpace, Model::Layer, Model::KalkerBed, Model::Fastsim];
    let answer = |model| Answer {
        model,
        force: vec![0.0, 0.6, 0.9],
        traction: vec![[-1.0, 0.0], [0.0, 0.8], [1.0, 0.0]],
        converged: true,
    };
    let answers = models.map(answer).to_vec();
    Course { creepage: vec![0.0, 1.0, 2.0], traction_at: 0.6, answers }
}

fn report(sides: SideBySide) -> CalibrationReport {
    let normal = NormalSummary {
        load: 1e5,
        semi_axis_x: 6e-3,
        semi_axis_y: 6e-3,
        peak_pressure: 1.3e9,
        approach: None,
        origin: None,
        parts: 1,
    };
    CalibrationReport {
        title: "made up".to_owned(),
        normal,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        tabulated: None,
        direct: None,
        fitted: None,
        warnings: Vec::new(),
        sides: Some(sides),
        status: Status::Converged,
    }
}

/// Forces on the rail are −F, as in all other figures; the Winkler bedding is not the fitted one of
/// the table.
#[test]
fn the_figure_names_signs_and_beds() {
    let (longitudinal, spin) = (course(), course());
    let sides = SideBySide { axis_ratio: 1.0, poisson_ratio: 0.28, longitudinal, spin };
    let svg = report(sides).drawings().unwrap().remove(0).1;
    let document = roxmltree::Document::parse(&svg).unwrap();
    let texts: Vec<String> = document
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| {
            let parts = node.descendants().filter(roxmltree::Node::is_text);
            parts.filter_map(|part| part.text()).collect()
        })
        .collect();
    for text in ["−Fx/μN", "−tx/(μp0)", "−Fy/μN", "−ty/(μp0)", "Winkler, Kalker's bed"]
    {
        assert!(texts.iter().any(|found| found == text), "{text} is not in {texts:?}");
    }
}
