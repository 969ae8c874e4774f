//! JSON, CSV, summary and figure of a made-up fit.

use schlupf::Status;
use schlupf::analysis::creep_curve::Abscissa;
use schlupf::analysis::identification::{
    Component, Condition, DataPoint, Estimate, Fit, FittedCurves, FittedPoint, ModelPoint,
    Parameter, Series,
};
use schlupf::bodies::Kinematics;
use schlupf::interface::friction::FrictionConstant;
use schlupf::reporting::Message;
use schlupf::solution::Work;
use schlupf_tasks::output::Report;
use schlupf_tasks::output::figures::FigureError;
use schlupf_tasks::output::identification::{FitReport, FittedRoughness};

const SPEEDS: [f64; 2] = [10.0, 30.0];
const CREEPAGES: [f64; 4] = [-0.01, 0.002, 0.01, 0.05];

fn model_point(creepage: f64, curve: impl Fn(f64) -> f64) -> ModelPoint {
    ModelPoint { creepage, force_ratio: Some(curve(creepage)) }
}

fn condition(speed: f64, creepage_x: f64) -> Condition {
    let kinematics = Kinematics { creepage_x, ..Kinematics::free_rolling(speed) };
    Condition { kinematics, load: (speed > 20.0).then_some(60e3) }
}

fn curve(creepage: f64) -> f64 {
    0.3 * (200.0 * creepage).tanh()
}

fn report(status: Status) -> FitReport {
    let mut points = Vec::new();
    let mut series = Vec::new();
    for speed in SPEEDS {
        let first = points.len();
        for (k, creepage) in CREEPAGES.into_iter().enumerate() {
            let data = DataPoint {
                condition: condition(speed, creepage),
                component: Component::Longitudinal,
                force_ratio: curve(creepage) + 1e-3 * (k as f64 - 1.5),
                standard_deviation: Some(2e-3),
            };
            points.push(FittedPoint { data, fitted: curve(creepage) });
        }
        series.push(Series {
            component: Component::Longitudinal,
            condition: condition(speed, 0.0),
            members: (first..points.len()).collect(),
            curve: (-10..=50).map(|k| model_point(1e-3 * f64::from(k), curve)).collect(),
        });
    }
    let cold = Parameter::Friction(FrictionConstant::ColdCoefficient);
    let estimate = |parameter, value: f64| Estimate {
        parameter,
        start: 1.5 * value,
        value,
        standard_error: Some(0.01 * value),
        half_width: Some(0.02 * value),
    };
    let fit = Fit {
        status,
        estimates: vec![estimate(cold, 0.3), estimate(Parameter::Roughness, 5e-7)],
        correlation: vec![vec![1.0, -0.25], vec![-0.25, 1.0]],
        points,
        rms_residual: 1.1e-3,
        r_squared: Some(0.999),
        reduced_chi_squared: Some(0.4),
        degrees_of_freedom: 6,
        iterations: 5,
        warnings: Vec::new(),
        work: Work { newton_iterations: 50, operator_products: 400.5, ..Work::default() },
    };
    FitReport {
        title: "a <made-up> fit".to_owned(),
        data: "points.csv".to_owned(),
        load: 80e3,
        fit,
        curves: FittedCurves { abscissa: Abscissa::CreepageX, series },
        roughness: Some(FittedRoughness { gamma: 0.45, contact_stiffness: 1.2e7 }),
        names: ["friction.coefficient", "contact_law.roughness"].map(str::to_owned).to_vec(),
        case: None,
        warnings: vec![
            Message::new(Message::NOT_CONVERGED, "parameters", "for a reason"),
            Message::new("beware", "parameters", "beware"),
        ],
    }
}

/// The only drawing.
fn drawing(report: &impl Report) -> String {
    report.drawings().unwrap().remove(0).1
}

#[test]
fn json_has_parameters_intervals_and_points() {
    let value: serde_json::Value = serde_json::from_str(&report(Status::Converged).json()).unwrap();
    assert_eq!(value["status"], "converged");
    assert_eq!(value["parameters"][0]["name"], "friction.coefficient");
    assert_eq!(value["parameters"][1]["half_width_95"], 1e-8);
    assert_eq!(value["correlation"][0][1], -0.25);
    assert_eq!(value["roughness"]["contact_stiffness"], 1.2e7);
    let points = &value["points"];
    assert_eq!(points["load"].as_array().unwrap().len(), 8);
    assert_eq!((&points["load"][0], &points["load"][4]), (&80e3.into(), &60e3.into()));
    assert_eq!(points["component"][0], "x");
}

#[test]
fn the_table_has_a_row_for_each_force() {
    let text = report(Status::Converged).csv().unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 8);
    for row in rows {
        let [measured, fitted, residual] = [6, 7, 8].map(|k| row[k].parse::<f64>().unwrap());
        assert!((measured - fitted - residual).abs() < 1e-15);
    }
}

#[test]
fn the_summary_shows_values_with_their_digits() {
    let text = report(Status::NotConverged).summary().to_string();
    assert!(text.contains("0.3000      0.0060"), "{text}");
    assert!(text.contains("0.500       0.010 µm"), "{text}");
    assert!(text.contains("contact_law.stiffness = 1.2e7 1/m, with γ = 0.45"), "{text}");
    assert!(text.contains("NOT CONVERGED"), "{text}");
    assert!(text.contains("\n  for a reason\n") && !text.contains("beware"), "{text}");
}

#[test]
fn the_figure_shows_all_points_in_both_panels() {
    let svg = drawing(&report(Status::NotConverged));
    let document = roxmltree::Document::parse(&svg).unwrap();
    let dots = document.descendants().filter(|node| node.has_tag_name("circle")).count();
    // And one in the legend.
    assert_eq!(dots, 2 * 8 + 1);
    let text: String = document.descendants().filter_map(|node| node.text()).collect();
    for part in ["a <made-up> fit", "not converged", "10 m/s", "60 kN", "measured", "0.3000"] {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
    assert!(!svg.contains("NaN"), "{svg}");
    assert!(report(Status::Converged).figures().unwrap()[0].png.starts_with(b"\x89PNG"));
}

/// Both components of a measurement in one direction, at two speeds.
fn two_components() -> FitReport {
    let mut report = report(Status::Converged);
    let direction = std::f64::consts::FRAC_PI_6;
    let mut points = Vec::new();
    let mut series = Vec::new();
    for one in &report.curves.series {
        for component in [Component::Longitudinal, Component::Lateral] {
            let share = [direction.cos(), direction.sin()][component.index()];
            let first = points.len();
            for k in &one.members {
                let mut point = report.fit.points[*k];
                let motion = &mut point.data.condition.kinematics;
                motion.creepage_y = motion.creepage_x * direction.sin();
                motion.creepage_x *= direction.cos();
                point.data.component = component;
                point.data.force_ratio *= share;
                point.fitted *= share;
                points.push(point);
            }
            let members = (first..points.len()).collect();
            let scaled = |point: &ModelPoint| ModelPoint {
                force_ratio: point.force_ratio.map(|ratio| share * ratio),
                ..*point
            };
            let curve = one.curve.iter().map(scaled).collect();
            series.push(Series { component, condition: one.condition, members, curve });
        }
    }
    report.fit.points = points;
    report.curves = FittedCurves { abscissa: Abscissa::Total { direction }, series };
    report
}

/// A panel for each component and one of residuals, marks of their own, the legend with both and
/// the speeds.
#[test]
fn two_components_have_panels_and_marks_of_their_own() {
    let svg = drawing(&two_components());
    let document = roxmltree::Document::parse(&svg).unwrap();
    let count = |is: &dyn Fn(roxmltree::Node) -> bool| {
        document.descendants().filter(|node| is(*node)).count()
    };
    assert_eq!(count(&|node| node.has_tag_name("circle")), 2 * 8 + 1);
    let is_square = |node: roxmltree::Node| {
        node.has_tag_name("rect") && node.attribute("stroke") == Some("#ffffff")
    };
    assert_eq!(count(&is_square), 2 * 8 + 1);
    let is_frame =
        |node: roxmltree::Node| node.has_tag_name("rect") && node.attribute("fill") == Some("none");
    assert_eq!(count(&is_frame), 3);
    let text: String = document.descendants().filter_map(|node| node.text()).collect();
    for part in ["at 30° to the rolling direction", "10 m/s", "30 m/s, 60 kN"] {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
}

/// Where every point has a speed of its own there are crosses for the fit, and colours for the
/// speed.
#[test]
fn many_conditions_are_coloured_by_their_speed() {
    let mut report = report(Status::Converged);
    let one = report.fit.points[2];
    report.fit.points.clear();
    report.curves.series.clear();
    for k in 0..14_u8 {
        let mut point = one;
        let motion = &mut point.data.condition.kinematics;
        motion.speed = 10.0 + 2.5 * f64::from(k);
        motion.creepage_x = 1e-3 * f64::from(k);
        let condition = condition(motion.speed, 0.0);
        report.fit.points.push(point);
        report.curves.series.push(Series {
            component: Component::Longitudinal,
            condition,
            members: vec![usize::from(k)],
            curve: Vec::new(),
        });
    }
    let svg = drawing(&report);
    let document = roxmltree::Document::parse(&svg).unwrap();
    let dots = document.descendants().filter(|node| node.has_tag_name("circle"));
    let mut colors: Vec<_> = dots.filter_map(|node| node.attribute("fill")).collect();
    colors.sort_unstable();
    colors.dedup();
    // And the dark dot in the legend.
    assert_eq!(colors.len(), 14 + 1, "{colors:?}");
    let text: String = document.descendants().filter_map(|node| node.text()).collect();
    for part in ["10 m/s", "26.25 m/s", "42.5 m/s", "fitted"] {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
}

#[test]
fn without_a_range_of_creepages_there_is_no_figure() {
    let mut flat = report(Status::Converged);
    for point in &mut flat.fit.points {
        point.data.condition.kinematics.creepage_x = 0.0;
    }
    assert_eq!(flat.drawings().unwrap_err(), FigureError::NoPoints);
}
