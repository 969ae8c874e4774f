//! JSON, CSV, summary and figure of made-up creep curves.

use std::collections::BTreeSet;

use crate::common::{RECIPE, solution};
use schlupf::analysis::creep_curve::{
    CreepCurve, Creepages, InitialSlope, Maximum, Path, Point, Sampling,
};
use schlupf::bodies::{Kinematics, ReferencePoint};
use schlupf::normal::NormalSummary;
use schlupf::reporting::Message;
use schlupf::solution::{Area, Power, Resultant, Work};
use schlupf::{Method, Status};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::creep_curve::{CurveFamily, FieldValue, Member};
use schlupf_tasks::output::figures::FigureError;

const LOAD: f64 = 80e3;

/// A curve that rises like a hyperbola to the bound, and falls with the temperature.
fn made_up(path: Path, bound: f64) -> CreepCurve {
    let sampling = Sampling::Refined(21);
    let point = |abscissa: f64| {
        let kinematics = path.at(abscissa).in_place_of(&Kinematics::free_rolling(30.0));
        let slip = 200.0 * abscissa;
        let size = bound * slip / (1.0 + slip * slip).sqrt() * (1.0 - 3.0 * abscissa.abs());
        let [x, y] = [kinematics.creepage_x, kinematics.creepage_y + 0.002 * kinematics.spin];
        let length = x.hypot(y).max(1e-300);
        let force = Resultant::new(
            -LOAD * size.abs() * x / length,
            -LOAD * size.abs() * y / length,
            -40.0 * size * f64::from(kinematics.spin != 0.0),
        );
        Point {
            abscissa,
            kinematics,
            force,
            normalised: normalised(&force),
            traction_coefficient: size.abs(),
            error: Some(Resultant::new(1.0, 0.5, 0.0)),
            power: Some(Power { friction: 1.0, creep: 1.0, ..Power::default() }),
            max_rise: Some(2e3 * abscissa.abs()),
            area: Area { contact: 1e-4, stick: Some(4e-5), slip: Some(6e-5) },
            status: Status::Converged,
            residual: 1e-8,
            work: Work { newton_iterations: 5, operator_products: 40.5, ..Work::default() },
        }
    };
    let points: Vec<Point> = sampling.abscissae(path.range()).into_iter().map(point).collect();
    let top = point(path.range()[1] * 0.3);
    let maximum = Maximum {
        abscissa: top.abscissa,
        kinematics: top.kinematics,
        force: top.force,
        normalised: top.normalised,
        traction_coefficient: 1.01 * bound,
        is_saturated: false,
    };
    let force = Resultant::new(-200.0 * bound * LOAD, -1.0, 0.0);
    CreepCurve {
        method: Method::Full,
        path,
        normal: NormalSummary { load: LOAD, ..solution(RECIPE).normal },
        reference: ReferencePoint::Patch,
        holds_forces: false,
        points,
        initial_slope: Some(InitialSlope {
            force,
            normalised: normalised(&force),
            kalker: Some(Resultant::new(4.2, 0.0, 0.0)),
        }),
        maxima: vec![maximum],
        warnings: Vec::new(),
        work: Work::default(),
    }
}

fn normalised(force: &Resultant) -> Resultant {
    let limit = 0.4 * LOAD;
    let moment_z = force.moment_z.map(|moment| moment / (limit * 5e-3));
    Resultant { x: force.x / limit, y: force.y / limit, moment_z }
}

fn over_x(from: f64, to: f64) -> Path {
    let [start, end] = [from, to].map(|x| Creepages { x, ..Creepages::default() });
    Path::new(start, end).unwrap()
}

fn unnumbered(text: &str) -> FieldValue {
    FieldValue { text: text.to_owned(), number: None }
}

fn family_of(path: Path, values: &[&str]) -> CurveFamily {
    let member = |(k, value): (usize, Option<&str>)| Member {
        values: value.map(unnumbered).into_iter().collect(),
        warnings: vec![Message::new("beware", "spin", "a warning")],
        curve: made_up(path, 0.4 / (1.0 + 0.1 * k as f64)),
    };
    let values: Vec<Option<&str>> =
        if values.is_empty() { vec![None] } else { values.iter().map(|v| Some(*v)).collect() };
    let over = values[0].map(|_| "kinematics.speed".to_owned()).into_iter().collect();
    let members = values.into_iter().enumerate().map(member).collect();
    CurveFamily::new("steel wheel".to_owned(), over, "refined", members)
}

fn keys(value: &serde_json::Value) -> BTreeSet<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

fn set(names: &'static str) -> BTreeSet<&'static str> {
    names.split_whitespace().collect()
}

/// The words of a drawing, by line.
fn text_of(svg: &str) -> Vec<String> {
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    let text = |node: roxmltree::Node| -> String {
        node.descendants().filter(roxmltree::Node::is_text).filter_map(|n| n.text()).collect()
    };
    texts.map(text).collect()
}

/// The only drawing.
fn drawing(report: &impl Report) -> String {
    report.drawings().unwrap().remove(0).1
}

#[test]
fn json_has_its_keys() {
    let family = family_of(over_x(0.0, 0.05), &["10 m/s", "20 m/s"]);
    let document: serde_json::Value = serde_json::from_str(&family.json()).unwrap();
    assert_eq!(keys(&document), set("program title path over map curves warnings"));
    let path = &document["path"];
    let names = "abscissa start end creepage_x creepage_y spin direction points spacing";
    assert_eq!(keys(path), set(names));
    assert_eq!(path["abscissa"], "creepage_x");
    assert_eq!(path["creepage_x"], serde_json::json!([0.0, 0.05]));
    assert!(path["spin"].is_null() && path["direction"].is_null());
    assert_eq!(document["over"]["values"], serde_json::json!(["10 m/s", "20 m/s"]));
    let curve = &document["curves"][1];
    let names = "value method normal reference initial_slope maximum maxima points work";
    assert_eq!(keys(curve), set(names));
    assert_eq!(curve["reference"], "patch");
    assert_eq!(curve["value"], "20 m/s");
    assert_eq!(keys(&curve["initial_slope"]), set("force normalised kalker"));
    assert_eq!(curve["initial_slope"]["kalker"]["x"], 4.2);
    let names = "abscissa kinematics force normalised traction_coefficient saturated";
    assert_eq!(keys(&curve["maximum"]), set(names));
    assert_eq!(curve["maximum"], curve["maxima"][0]);
    let names = "abscissa speed creepage_x creepage_y spin force_x force_y moment_z normalised_x \
                 normalised_y normalised_moment_z traction_coefficient force_error_x force_error_y \
                 moment_error_z friction_power creep_power \
                 max_rise contact_area stick_area slip_area status residual strategy \
                 newton_iterations operator_products";
    assert_eq!(keys(&curve["points"]), set(names));
    for (name, column) in curve["points"].as_object().unwrap() {
        assert_eq!(column.as_array().unwrap().len(), 21, "{name}");
    }
    let force = family.members[1].curve.points[7].force.x;
    let read = curve["points"]["force_x"][7].as_f64().unwrap();
    assert!((read / force - 1.0).abs() < 1e-15, "{read} {force}");
    assert_eq!(curve["points"]["status"][7], "converged");
    let warning = serde_json::json!({ "code": "beware", "quantity": "spin", "text": "a warning" });
    assert_eq!(document["warnings"], serde_json::json!([warning]));
}

#[test]
fn json_says_null_where_there_is_nothing() {
    let mut family = family_of(over_x(0.01, 0.05), &[]);
    let curve = &mut family.members[0].curve;
    curve.initial_slope = None;
    curve.maxima.clear();
    curve.points[3].status = Status::NotConverged;
    curve.points[3].force.x = f64::NAN;
    let document: serde_json::Value = serde_json::from_str(&family.json()).unwrap();
    assert!(document["over"].is_null());
    let curve = &document["curves"][0];
    assert!(curve["value"].is_null() && curve["initial_slope"].is_null());
    assert!(curve["maximum"].is_null());
    assert!(curve["points"]["force_x"][3].is_null());
    assert_eq!(curve["points"]["status"][3], "not-converged");
}

#[test]
fn csv_reads_back_to_the_same_numbers() {
    let family = family_of(over_x(0.0, 0.05), &["10 m/s", "a, \"b\""]);
    let text = family.csv().unwrap();
    assert!(text.starts_with("# units: as given, m/s, 1, 1, 1/m, N, N, N m, 1, "), "{text}");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let first = ["kinematics.speed", "speed", "creepage_x", "creepage_y", "spin", "force_x"];
    assert_eq!(header[..6], first);
    assert_eq!(header[25], "status");
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 42);
    let units = text.lines().next().unwrap().split(';').next().unwrap();
    assert_eq!(units.split(", ").count(), header.len());
    assert_eq!((&rows[0][0], &rows[41][0]), ("10 m/s", "a, \"b\""));
    let point = &family.members[1].curve.points[20];
    assert_eq!(rows[41][2].parse::<f64>().unwrap(), point.abscissa);
    assert_eq!(rows[41][5].parse::<f64>().unwrap(), point.force.x);
    assert_eq!(&rows[41][25], "converged");
}

/// Numbers stand in the CSV in their SI unit.
#[test]
fn csv_has_the_numbers_of_a_family_in_si_units() {
    let mut family = family_of(over_x(0.0, 0.05), &["36 km/h", "72 km/h"]);
    for (member, speed) in family.members.iter_mut().zip([10.0, 20.0]) {
        member.values[0].number = Some((speed, "m/s"));
    }
    let text = family.csv().unwrap();
    assert!(text.starts_with("# units: m/s, m/s, 1, "), "{text}");
    assert!(text.lines().nth(2).unwrap().starts_with("1e1,"));
    assert!(text.lines().last().unwrap().starts_with("2e1,"));
}

#[test]
fn csv_of_a_fixed_direction_has_the_total_creepage() {
    let path = Path::in_direction([0.0, 0.05], 0.5, [0.0; 2]).unwrap();
    let text = family_of(path, &[]).csv().unwrap();
    assert_eq!(text.lines().nth(1).unwrap().split(',').next(), Some("creepage"));
    assert!(text.lines().last().unwrap().starts_with("5e-2,"));
}

#[test]
fn the_summary_is_compact_and_says_what_it_leaves_out() {
    let mut family = family_of(over_x(-0.05, 0.05), &["10 m/s"]);
    let curve = &mut family.members[0].curve;
    let copies: Vec<Point> = curve.points.iter().flat_map(|point| [*point; 5]).collect();
    curve.points = copies;
    curve.points[7].status = Status::NotConverged;
    let text = family.summary().to_string();
    assert!(text.lines().count() <= 36, "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 100));
    for part in [
        "steel wheel",
        "kinematics.speed = 10 m/s",
        "load 80 kN, speed 30 m/s",
        "|F|/N",
        "rise (K)",
        "NOT CONVERGED",
        "of 105 points; CSV and JSON have all",
        "Kalker's C11 = 4.2",
        "|F|/N = 0.404 at creepage_x = 0.015",
    ] {
        assert!(text.contains(part), "{part:?} is not in\n{text}");
    }
    assert!(!text.contains("Mz"), "{text}");
}

#[test]
fn the_summary_says_why_there_is_no_slope_and_no_maximum() {
    let mut family = family_of(over_x(0.01, 0.05), &[]);
    let curve = &mut family.members[0].curve;
    curve.initial_slope = None;
    let top = curve.maxima.pop().unwrap();
    let text = family.summary().to_string();
    assert!(text.contains("none: the curve does not reach zero creepage"), "{text}");
    assert!(text.contains("none within the range: |F|/N is largest at an end"), "{text}");
    family.members[0].curve.maxima = vec![Maximum { is_saturated: true, ..top }];
    family.members[0].curve.holds_forces = true;
    let text = family.summary().to_string();
    assert!(text.contains("none: forces are prescribed"), "{text}");
    assert!(text.contains("saturated: within 0.1 % from creepage_x = 0.015 on"), "{text}");
}

#[test]
fn warnings_name_their_curve_unless_they_are_common() {
    let mut family = family_of(over_x(0.0, 0.05), &["10 m/s", "20 m/s"]);
    family.members[1].warnings.push(Message::new("other", "spin", "another"));
    family.members[0].warnings.push(Message::new("no-effect", "spin", "no effect"));
    let CurveFamily { title, over, spacing, members, .. } = family;
    let family = CurveFamily::new(title, over, spacing, members);
    let expected =
        ["a warning", "kinematics.speed = 10 m/s: no effect", "kinematics.speed = 20 m/s: another"];
    let texts: Vec<&str> = family.warnings.iter().map(|message| &*message.text).collect();
    assert_eq!(texts, expected);
}

#[test]
fn the_figure_names_axes_members_and_marks() {
    let mut family = family_of(over_x(0.0, 0.05), &["10 m/s", "20 m/s", "40 m/s"]);
    family.members[2].curve.points[9].status = Status::NotConverged;
    let figure = family.figures().unwrap().remove(0);
    assert_eq!(figure.name, "creep_curve");
    assert_eq!(figure.png[..8], *b"\x89PNG\r\n\x1a\n");
    let text = text_of(&figure.svg);
    for part in [
        "Creep curves",
        "steel wheel",
        "force on the rail −Fx/N",
        "largest temp. rise (K)",
        "longitudinal creepage ξ",
        "speed",
        "10 m/s",
        "40 m/s",
        "initial slope",
        "maximum of |F|",
        "not converged",
        "not converged at some points",
    ] {
        assert!(text.iter().any(|line| line == part), "{part:?} is not in {text:?}");
    }
    assert_eq!(text.iter().filter(|line| line.contains("Fy")).count(), 0);
    assert_eq!(figure.svg.matches("<circle").count(), 4, "three maxima and one in the legend");
}

#[test]
fn every_abscissa_has_its_axis_and_panels() {
    let [spin, lateral] = [(0.0, 2.0), (0.05, 0.0)].map(|(y, spin)| {
        let end = Creepages { y, spin, ..Creepages::default() };
        Path::new(Creepages::default(), end).unwrap()
    });
    let total = Path::in_direction([-0.05, 0.05], 30_f64.to_radians(), [0.0; 2]).unwrap();
    let of = |path: Path| text_of(&drawing(&family_of(path, &[])));
    let text = of(spin);
    for part in ["spin creepage φ (1/m)", "force on the rail −Fy/N", "moment −Mz (N m)"] {
        assert!(text.contains(&part.to_owned()), "{part:?} is not in {text:?}");
    }
    assert!(of(lateral).contains(&"lateral creepage η".to_owned()));
    let text = of(total);
    assert!(text.contains(&"creepage ν at 30° to the rolling direction".to_owned()), "{text:?}");
    assert!(text.contains(&"force on the rail −Fν/N".to_owned()), "{text:?}");
}

#[test]
fn one_and_many_members_have_colours_of_their_own() {
    let values: Vec<String> = (0..8).map(|k| format!("{k} m/s")).collect();
    let names: Vec<&str> = values.iter().map(String::as_str).collect();
    let family = family_of(over_x(0.0, 0.05), &names);
    let svg = drawing(&family);
    let strokes = svg.split("stroke=\"#").skip(1).map(|rest| rest[..6].to_owned());
    assert!(strokes.collect::<BTreeSet<String>>().len() >= 8);
    assert_eq!(text_of(&svg).iter().filter(|line| line.ends_with("m/s")).count(), 8);
    let alone = drawing(&family_of(over_x(0.0, 0.05), &[]));
    assert!(alone.contains("#0072b2") && text_of(&alone).contains(&"Creep curve".to_owned()));
}

#[test]
fn numbers_that_are_none_do_not_spoil_the_rest() {
    let mut family = family_of(over_x(0.0, 0.05), &["<&>", "\u{0}"]);
    let curve = &mut family.members[0].curve;
    curve.points[4].force.x = f64::NAN;
    curve.points[5].max_rise = None;
    curve.points[6].status = Status::NotConverged;
    curve.points[6].force.y = f64::NAN;
    curve.initial_slope.as_mut().unwrap().force.x = f64::NAN;
    curve.maxima[0].force.x = f64::NAN;
    assert!(text_of(&drawing(&family)).contains(&"<&>".to_owned()));
    for point in family.members.iter_mut().flat_map(|member| &mut member.curve.points) {
        point.force = Resultant { x: f64::NAN, y: f64::NAN, moment_z: None };
    }
    assert_eq!(family.drawings().unwrap_err(), FigureError::NoCurve);
    family.members.clear();
    assert_eq!(family.drawings().unwrap_err(), FigureError::NoCurve);
}

/// The first line of a drawing with a colour, as its path.
fn first_line(svg: &str) -> &str {
    let line = svg.split("<path").find(|path| path.contains("fill=\"none\"")).unwrap();
    line.split("d=\"").nth(1).unwrap().split('"').next().unwrap()
}

#[test]
fn given_points_are_joined_by_straight_lines() {
    let mut family = family_of(over_x(0.0, 0.05), &[]);
    family.members[0].curve.initial_slope = None;
    let smooth = drawing(&family);
    family.spacing = CurveFamily::GIVEN;
    let given = drawing(&family);
    let places = |svg: &str| first_line(svg).matches(['M', 'L']).count();
    assert!(places(&smooth) > 50);
    // The maximum lies between two of them.
    assert_eq!(places(&given), 21 + 1);
}

/// Values of a range are written in full where they name a state, but not in a legend.
#[test]
fn values_in_a_legend_have_four_digits() {
    let svg = drawing(&family_of(over_x(0.0, 0.05), &["12.8571429 m/s", "20 m/s", "full"]));
    let text = text_of(&svg);
    for part in ["12.86 m/s", "20 m/s", "full"] {
        assert!(text.contains(&part.to_owned()), "{part:?} is not in {text:?}");
    }
}

/// Numbers from dark to light; names have no order, so neither have their colours.
#[test]
fn names_have_colours_without_an_order() {
    let drawn = |values: &[&str]| drawing(&family_of(over_x(0.0, 0.05), values));
    let [blue, purple] = ["#0072b2", "#440154"].map(|color| format!(r#"stroke="{color}""#));
    let names = drawn(&["full", "fastsim", "polach"]);
    assert!(names.contains(&blue) && !names.contains(&purple));
    for numbers in [["10 m/s", "20 m/s"], ["-1", "+.5"], ["\"60 kN\"", "\"80 kN\""]] {
        let numbers = drawn(&numbers);
        assert!(numbers.contains(&purple) && !numbers.contains(&blue));
    }
}

/// The upper edges of the plot areas, and the lower end of what is written above the first.
fn edges(svg: &str) -> (Vec<f64>, Vec<[f64; 2]>) {
    let document = roxmltree::Document::parse(svg).unwrap();
    let number = |node: &roxmltree::Node, name| node.attribute(name).unwrap().parse::<f64>();
    let of = |tag: &'static str| document.descendants().filter(move |node| node.has_tag_name(tag));
    let frames = of("rect").filter(|node| node.attribute("fill") == Some("none"));
    let frames = frames.map(|node| number(&node, "y").unwrap()).collect();
    let texts = of("text").map(|node| ["x", "y"].map(|name| number(&node, name).unwrap()));
    (frames, texts.collect())
}

/// Two components, slopes, maxima, saturation and a failure: the legend needs two rows.
#[test]
fn a_long_legend_stays_above_the_curves() {
    let path = Path::in_direction([0.0, 0.05], 45_f64.to_radians(), [0.0; 2]).unwrap();
    let mut family = family_of(path, &["0.2", "0.4"]);
    for member in &mut family.members {
        let curve = &mut member.curve;
        curve.points.iter_mut().for_each(|point| point.force.x *= 1.4);
        let maximum = Maximum { is_saturated: true, ..curve.maxima[0] };
        curve.maxima.push(maximum);
        curve.points[3].status = Status::NotConverged;
    }
    let (frames, texts) = edges(&drawing(&family));
    let [left, right, room] = [92.0, 600.0, 5.0];
    let inside = |[x, y]: &&[f64; 2]| *x > left && *x < right && *y > frames[0] - room;
    let written: Vec<&[f64; 2]> = texts.iter().filter(inside).collect();
    assert!(written.iter().all(|[_, y]| *y > frames[0] + 330.0), "{frames:?} {written:?}");
    let rows: BTreeSet<i64> = texts
        .iter()
        .filter(|[x, y]| *x > left && *x < right && *y < frames[0] && *y > 100.0)
        .map(|[_, y]| *y as i64)
        .collect();
    assert_eq!(rows.len(), 2, "{rows:?}");
}

/// Full sliding is said to set in where the force is almost its largest: the mark is on the curve.
#[test]
fn the_mark_of_saturation_lies_on_its_curve() {
    let mut family = family_of(over_x(0.0, 0.05), &[]);
    let curve = &mut family.members[0].curve;
    for point in &mut curve.points {
        point.force.x = -LOAD * point.abscissa;
    }
    let force = Resultant::new(-0.9 * LOAD, 0.0, 0.0);
    curve.maxima[0] = Maximum { abscissa: 0.0251, is_saturated: true, force, ..curve.maxima[0] };
    curve.initial_slope = None;
    let svg = drawing(&family);
    let document = roxmltree::Document::parse(&svg).unwrap();
    let circles = document.descendants().filter(|node| node.has_tag_name("circle"));
    let middle = |node: roxmltree::Node| {
        ["cx", "cy"].map(|name| node.attribute(name).unwrap().parse::<f64>().unwrap())
    };
    let [x, y] = circles.map(middle).next().unwrap();
    // The curve is a straight line from the corner at the lower left to 0.05 at the right edge.
    let path = svg.split("d=\"M").find(|path| path.contains("#0072b2")).unwrap();
    let points = path.split('"').next().unwrap().split('L').map(|point| {
        let mut numbers = point.split(' ').map(|number| number.parse::<f64>().unwrap());
        [numbers.next().unwrap(), numbers.next().unwrap()]
    });
    let points: Vec<[f64; 2]> = points.collect();
    let ([x0, y0], [x1, y1]) = (points[0], points[points.len() - 1]);
    assert!((y - y0 - (y1 - y0) * (x - x0) / (x1 - x0)).abs() < 0.1, "{x} {y} {points:?}");
}

/// A line has no bound: it leaves the picture and does not press the other curves down. Alone it
/// sets the axis.
#[test]
fn a_line_does_not_set_the_axis_of_bounded_forces() {
    let line = |curve: &mut CreepCurve| {
        let slope = curve.initial_slope.as_ref().unwrap().force;
        let force = |at: f64| Resultant::new(slope.x * at, slope.y * at, 0.0);
        curve.points.iter_mut().for_each(|point| point.force = force(point.abscissa));
        curve.maxima.clear();
    };
    let largest_tick = |family: &CurveFamily| -> f64 {
        let svg = family.drawings().unwrap().remove(0).1;
        assert!(svg.contains("clip-path"));
        let texts = text_of(&svg);
        texts.iter().filter_map(|text| text.parse().ok()).fold(0.0, f64::max)
    };
    let mut family = family_of(over_x(0.0, 0.05), &["one", "other"]);
    family.members.iter_mut().for_each(|member| {
        member.curve.points.iter_mut().for_each(|point| point.max_rise = None);
    });
    line(&mut family.members[1].curve);
    assert!(largest_tick(&family) < 0.5, "{}", largest_tick(&family));
    line(&mut family.members[0].curve);
    assert!(largest_tick(&family) > 2.0, "{}", largest_tick(&family));
}

/// Curves over numbers of one field.
fn family_of_speeds(speeds: &[f64]) -> CurveFamily {
    let names: Vec<String> = speeds.iter().map(|speed| format!("{speed} m/s")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut family = family_of(over_x(0.0, 0.05), &names);
    for (member, speed) in family.members.iter_mut().zip(speeds) {
        member.values[0].number = Some((*speed, "m/s"));
    }
    family
}

/// Every speed with every load; the bound falls with the speed, as that of `made_up` curves.
fn family_of_speeds_and_loads() -> CurveFamily {
    let mut family = family_of_speeds(&[10.0, 20.0, 30.0]);
    let over = ["kinematics.speed", "normal.load"].map(str::to_owned).to_vec();
    let with_load = |member: &Member, load: f64| {
        let value = FieldValue { text: format!("{load} N"), number: Some((load, "N")) };
        let mut member = member.clone();
        member.values.push(value);
        member.curve.maxima[0].traction_coefficient -= 1e-7 * load;
        member
    };
    let pairs = |member: &Member| [8e4, 6e4].map(|load| with_load(member, load));
    let members = family.members.iter().flat_map(pairs).collect();
    CurveFamily::new(std::mem::take(&mut family.title), over, family.spacing, members)
}

#[test]
fn curves_over_a_number_have_a_map() {
    let mut family = family_of_speeds(&[30.0, 10.0, 20.0]);
    family.members[2].curve.points[9].status = Status::NotConverged;
    let map = family.map().unwrap();
    assert_eq!((&*map.x.name, &*map.y.name), ("creepage_x", "kinematics.speed"));
    assert_eq!((map.y.unit, &map.y.values), ("m/s", &vec![10.0, 20.0, 30.0]));
    let adhesion = map.column("traction_coefficient").unwrap();
    for (row, member) in adhesion.rows.iter().zip([1, 2, 0]) {
        for (k, value) in row.iter().enumerate() {
            let point = &family.members[member].curve.points[k];
            let expected = Some(point.traction_coefficient).filter(|_| (member, k) != (2, 9));
            assert_eq!((*value, map.x.values[k]), (expected, point.abscissa));
        }
    }
    let document: serde_json::Value = serde_json::from_str(&family.json()).unwrap();
    assert_eq!(keys(&document["map"]), set("x y columns"));
    assert_eq!(document["map"]["y"]["values"], serde_json::json!([10.0, 20.0, 30.0]));
    let forces = &document["map"]["columns"]["force_x"];
    assert_eq!((&forces["unit"], forces["values"][1][9].is_null()), (&"N".into(), true));
    assert_eq!(forces["values"][0][3], document["curves"][1]["points"]["force_x"][3]);
    assert!(family_of_speeds(&[10.0, 20.0]).map().is_none());
    assert!(family_of(over_x(0.0, 0.05), &["a", "b", "c"]).map().is_none());
}

#[test]
fn two_fields_have_a_map_of_the_largest_forces() {
    let mut family = family_of_speeds_and_loads();
    let map = family.map().unwrap();
    assert_eq!((&*map.x.name, &*map.y.name), ("kinematics.speed", "normal.load"));
    assert_eq!(map.y.values, [6e4, 8e4]);
    let adhesion = &map.column("traction_coefficient").unwrap().rows;
    for (y, load) in [6e4, 8e4].into_iter().enumerate() {
        for (x, k) in [0.0, 1.0, 2.0].into_iter().enumerate() {
            let expected = 1.01 * 0.4 / (1.0 + 0.1 * k) - 1e-7 * load;
            assert!((adhesion[y][x].unwrap() - expected).abs() < 1e-12);
        }
    }
    assert_eq!(map.column("creepage_x").unwrap().rows[0][0], Some(0.015));
    let document: serde_json::Value = serde_json::from_str(&family.json()).unwrap();
    assert_eq!(document["over"][1]["values"], serde_json::json!(["80000 N", "60000 N"]));
    assert_eq!(document["curves"][1]["value"], serde_json::json!(["10 m/s", "60000 N"]));
    let table = family.csv().unwrap();
    assert!(table.starts_with("# units: m/s, N, m/s, 1, "), "{table}");
    assert!(table.lines().nth(2).unwrap().starts_with("1e1,8e4,"));
    assert!(
        family.summary().to_string().contains("kinematics.speed = 30 m/s, normal.load = 60000")
    );
    // The largest force of a curve with a gap is not known.
    family.members[1].curve.points[9].status = Status::NotConverged;
    let map = family.map().unwrap();
    assert_eq!(map.column("traction_coefficient").unwrap().rows[0][0], None);
}

#[test]
fn maps_have_axes_and_labelled_contours() {
    let names = |family: &CurveFamily| -> Vec<String> {
        family.drawings().unwrap().into_iter().map(|(name, _)| name).collect()
    };
    let family = family_of_speeds(&[10.0, 20.0, 30.0]);
    assert_eq!(names(&family), ["creep_curve", "creep_map", "creep_map_temperature"]);
    let text = text_of(&family.drawings().unwrap()[1].1);
    for part in ["Adhesion", "longitudinal creepage ξ", "speed (m/s)", "|F|/N"] {
        assert!(text.iter().any(|line| line == part), "{part:?} is not in {text:?}");
    }
    // Each at the colour bar, and in black and as a halo on its line.
    assert!(text.iter().filter(|line| *line == "0.35").count() >= 3, "{text:?}");
    let family = family_of_speeds_and_loads();
    assert_eq!(names(&family), ["creep_map", "creep_map_creepage"]);
    let text = text_of(&family.drawings().unwrap()[0].1);
    assert!(text.iter().any(|line| line == "load (kN)"), "{text:?}");
    let all = CurveFamily::figure_names();
    assert!(names(&family).iter().all(|name| all.contains(name)));
}
