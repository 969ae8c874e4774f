//! The figures of made-up solutions: which there are, and that both files of each are sound.

use crate::common::{RECIPE, Recipe, solution};
use schlupf::Solution;
use schlupf::bodies::ReferenceSpeed;
use schlupf_tasks::output::figures::{Figure, FigureError, drawings, names, render};

fn text_of(svg: &str) -> String {
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    texts
        .map(|node| {
            node.descendants().filter(roxmltree::Node::is_text).filter_map(|n| n.text()).collect()
        })
        .collect::<Vec<String>>()
        .join("\n")
}

/// The names of the drawings, all of which are sound.
fn sound_drawings(solution: &Solution) -> Vec<String> {
    let drawings = drawings("a case", solution).unwrap();
    for (_, svg) in &drawings {
        assert_sound_drawing(svg);
    }
    drawings.into_iter().map(|(name, _)| name).collect()
}

fn assert_sound_drawing(svg: &str) {
    roxmltree::Document::parse(svg).unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

fn assert_sound(figure: &Figure) {
    assert_sound_drawing(&figure.svg);
    let document = roxmltree::Document::parse(&figure.svg).unwrap();
    let side =
        |name: &str| -> u32 { document.root_element().attribute(name).unwrap().parse().unwrap() };
    assert_eq!(figure.png[..8], *b"\x89PNG\r\n\x1a\n");
    let pixels = |at: usize| u32::from_be_bytes(figure.png[at..at + 4].try_into().unwrap());
    assert_eq!((pixels(16), pixels(20)), (2 * side("width"), 2 * side("height")));
    assert!(!figure.svg.contains("NaN") && !figure.svg.contains("inf"), "{}", figure.name);
}

#[test]
fn combined_slip_has_all_figures_of_the_paper_with_units() {
    let figures =
        render(drawings("combined slip", &solution(Recipe { direction: 0.8, ..RECIPE })).unwrap())
            .unwrap();
    let expected = [
        ("surface_pressure", "p*"),
        ("surface_force_x", "ΔFTx*"),
        ("surface_force_y", "ΔFTy*"),
        ("surface_slip", "(mm/s)"),
        ("surface_friction_power", "(W/mm²)"),
        ("surface_temperature", "(K)"),
        ("map_pressure", "pn (MPa)"),
        ("map_traction", "|t| (MPa)"),
        ("map_slip", "|vs| (mm/s)"),
        ("map_friction_power", "q (W/mm²)"),
        ("map_temperature", "ΔT (K)"),
        ("cut_y0", "traction on the rail (MPa)"),
        ("history", "force on the rail (kN)"),
    ];
    assert_eq!(figures.len(), expected.len());
    for (figure, (name, unit)) in figures.iter().zip(expected) {
        assert_sound(figure);
        assert_eq!(figure.name, name);
        let text = text_of(&figure.svg);
        assert!(text.contains(unit), "{name} lacks {unit}:\n{text}");
        assert!(text.contains("combined slip"));
        assert!(name == "history" || text.contains("rolling direction"), "{name}");
    }
}

#[test]
fn pure_longitudinal_slip_has_no_lateral_force() {
    let names = sound_drawings(&solution(RECIPE));
    assert!(names.contains(&"surface_force_x".to_owned()));
    assert!(!names.contains(&"surface_force_y".to_owned()));
}

/// A hill is drawn, not a pit; the label says that it is turned over.
#[test]
fn driving_is_drawn_like_braking_with_another_label() {
    let reversed = Recipe { direction: std::f64::consts::PI, ..RECIPE };
    for (recipe, label) in [(RECIPE, "\nΔFTx*"), (reversed, "\n\u{2212}ΔFTx*")] {
        let drawings = drawings("", &solution(recipe)).unwrap();
        let force = drawings.iter().find(|(name, _)| name == "surface_force_x").unwrap();
        assert!(text_of(&force.1).contains(label));
    }
}

#[test]
fn slender_patches_and_coarse_grids_are_drawn() {
    for semi_axes in [[2e-3, 20e-3], [20e-3, 2e-3]] {
        let recipe = Recipe { semi_axes, cells: 4, direction: 2.0, stick: 0.0 };
        assert_eq!(sound_drawings(&solution(recipe)).len(), 13);
    }
}

/// A pressure that is not that of Hertz: the cells are drawn as they are.
#[test]
fn a_patch_that_is_no_ellipse_is_drawn_by_its_cells() {
    let mut solution = solution(Recipe { cells: 12, ..RECIPE });
    for (pressure, x) in solution.fields.pressure.iter_mut().zip(&solution.fields.x) {
        *pressure *= if *x > 0.0 { 1.0 } else { 0.3 };
    }
    assert_eq!(sound_drawings(&solution).len(), 12);
    let drawings = drawings("tabulated", &solution).unwrap();
    assert!(drawings.iter().all(|(_, svg)| !svg.contains("<ellipse")));
}

#[test]
fn without_heat_there_are_no_figures_of_temperature() {
    let mut solution = solution(RECIPE);
    solution.fields.temperature_rise_wheel.fill(0.0);
    solution.fields.temperature_rise_rail.fill(0.0);
    solution.history.truncate(1);
    let names = sound_drawings(&solution);
    assert!(!names.iter().any(|name| name.contains("temperature") || name == "history"));
}

#[test]
fn numbers_that_are_none_do_not_spoil_the_rest() {
    let mut solution = solution(RECIPE);
    let fields = &mut solution.fields;
    fields.traction_x[10] = f64::NAN;
    fields.slip_x[20] = f64::INFINITY;
    fields.pressure[30] = f64::NAN;
    fields.temperature_rise_rail.fill(f64::NEG_INFINITY);
    fields.friction_coefficient.fill(f64::NAN);
    solution.history[3].force.x = f64::NAN;
    solution.history[5].time = f64::INFINITY;
    solution.normalised.x = f64::NAN;
    solution.kinematics.speed = f64::NAN;
    assert!(sound_drawings(&solution).len() > 8);
}

#[test]
fn nothing_to_draw_is_an_error() {
    let mut solution = solution(RECIPE);
    solution.normal.semi_axis_x = f64::NAN;
    assert_eq!(drawings("", &solution).unwrap_err(), FigureError::NoPatch);
}

#[test]
fn the_speed_to_which_creepages_refer_is_named() {
    let mut solution = solution(RECIPE);
    for (speed, name) in
        [(ReferenceSpeed::Vehicle, "v0 = 30 m/s"), (ReferenceSpeed::Mean, "V = 30 m/s")]
    {
        solution.kinematics.reference_speed = speed;
        let text = text_of(&drawings("a case", &solution).unwrap()[0].1);
        assert!(text.contains(name), "{text}");
    }
}

#[test]
fn titles_are_text_whatever_they_hold() {
    let mut solution = solution(RECIPE);
    solution.history.clear();
    let title = "<b> & \"$x_{y\" \u{0} — Räder über Ж ".repeat(20);
    for (_, svg) in drawings(&title, &solution).unwrap() {
        assert_sound_drawing(&svg);
        assert!(text_of(&svg).contains("<b> & \"$x_{y\""));
    }
}

#[test]
fn every_figure_has_a_name_that_is_known_before() {
    let known = names();
    let sideways = Recipe { direction: 0.5, ..RECIPE };
    let drawings = drawings("", &solution(sideways)).unwrap();
    assert_eq!(drawings.len(), known.len());
    assert!(drawings.iter().all(|(name, _)| known.contains(name)), "{known:?}");
}

/// What varies is given over time; constant conditions settle over the rolled distance. A varying
/// load explains the forces.
#[test]
fn histories_are_drawn_over_time_where_something_varies() {
    let mut solution = solution(RECIPE);
    let history = |solution: &Solution| {
        let drawings = drawings("", solution).unwrap();
        let svg = &drawings.iter().find(|(name, _)| name == "history").unwrap().1;
        assert_sound_drawing(svg);
        text_of(svg)
    };
    let text = history(&solution);
    assert!(text.contains("rolled distance (mm)") && !text.contains("time ("));
    assert!(!text.contains("load N"));
    solution.history[20].load = 60e3;
    let text = history(&solution);
    assert!(text.contains("time (ms)") && text.contains("load N (kN)"));
    // A shift at rest.
    solution.history[0].kinematics.speed = 0.0;
    let text = history(&solution);
    assert!(text.contains("Forces over time") && !text.contains("speed"), "{text}");
    solution.history[20].kinematics.speed = 20.0;
    let text = history(&solution);
    assert!(text.contains("time (ms)") && text.contains("speed v0 (m/s)"), "{text}");
    // A history that begins late fills the axis all the same.
    for instant in &mut solution.history {
        instant.time = 7.0 + 1e3 * instant.time;
    }
    let text = history(&solution);
    assert!(text.contains("time (s)"), "{text}");
    let ticks: Vec<f64> = text.lines().filter_map(|word| word.parse().ok()).collect();
    assert!(ticks.iter().filter(|tick| (7.0..=7.7).contains(*tick)).count() >= 3, "{text}");
}

/// Straight ahead there are no lateral forces, tractions and slips to be listed.
#[test]
fn components_that_are_zero_have_no_curve_and_no_name() {
    let text = |recipe: Recipe, name: &str| {
        let drawings = drawings("", &solution(recipe)).unwrap();
        text_of(&drawings.iter().find(|(other, _)| other == name).unwrap().1)
    };
    let sideways = Recipe { direction: 0.5, ..RECIPE };
    for (name, along, across) in
        [("cut_y0", "\u{2212}tx", "\u{2212}ty"), ("history", "\u{2212}Fx", "\u{2212}Fy")]
    {
        assert!(text(RECIPE, name).contains(along) && !text(RECIPE, name).contains(across));
        assert!(text(sideways, name).contains(along) && text(sideways, name).contains(across));
    }
    assert!(!text(RECIPE, "cut_y0").contains("vsy"));
}

/// A wheel of 180 °C heats a rail of 5 °C: rises of the two cannot be compared.
#[test]
fn temperatures_are_absolute_where_the_bulk_temperatures_differ() {
    let mut solution = solution(RECIPE);
    let temperature = solution.temperature.as_mut().unwrap();
    temperature.max_wheel += 160.0;
    temperature.max_rail -= 15.0;
    let drawings = drawings("", &solution).unwrap();
    for name in ["map_temperature", "surface_temperature"] {
        let svg = &drawings.iter().find(|(other, _)| other == name).unwrap().1;
        assert_sound_drawing(svg);
        let text = text_of(svg);
        assert!(text.contains("Temperature of the surface, wheel\n"), "{text}");
        assert!(text.contains("T (°C)") && !text.contains("ΔT"), "{text}");
        // Colours and surface begin near the bulk temperature, not at zero.
        assert!(text.contains("\n180\n"), "{text}");
    }
    let cut = &drawings.iter().find(|(name, _)| name == "cut_y0").unwrap().1;
    assert!(text_of(cut).contains("temperature (°C)"));
}

/// Teeth from row to row, as the cells make of an oblique stick–slip boundary, are no part of a
/// surface; the map shows the cells as they are.
#[test]
fn surfaces_have_no_teeth_from_row_to_row() {
    let mut solution = solution(RECIPE);
    let fields = &mut solution.fields;
    for (slip, [_, row]) in fields.slip_x.iter_mut().zip(&fields.cell) {
        *slip = if row.is_multiple_of(2) { 1.0 } else { 0.0 };
    }
    fields.slip_y.fill(0.0);
    let drawings = drawings("", &solution).unwrap();
    let heights = |name: &str| -> f64 {
        let text = text_of(&drawings.iter().find(|(other, _)| other == name).unwrap().1);
        let bar = text.rsplit("|vs| (m/s)").nth(1).unwrap();
        let numbers = bar.lines().rev().map_while(|line| line.parse::<f64>().ok());
        numbers.fold(0.0, f64::max)
    };
    assert!(heights("map_slip") > 0.7 && heights("surface_slip") < 0.7);
}

/// A wheel that is only shifted rolls nowhere and slips nowhere once it is at rest.
#[test]
fn a_shift_at_rest_has_no_slip_and_no_rolling_direction() {
    let mut solution = solution(RECIPE);
    solution.kinematics.speed = 0.0;
    solution.fields.slip_x.fill(0.0);
    solution.fields.slip_y.fill(0.0);
    for (name, svg) in drawings("a shift", &solution).unwrap() {
        let text = text_of(&svg);
        assert!(!text.contains("rolling direction"), "{name}");
        assert!(text.contains("at rest, N = "), "{name}: {text}");
        assert!(!text.contains("slip velocity"), "{name}: {text}");
    }
}

/// Wheel and rail coincide in the contact: dashes upon a solid curve of another colour. Where both
/// are hot, the axis does not begin at 0 °C.
#[test]
fn wheel_and_rail_do_not_hide_each_other() {
    let mut solution = solution(RECIPE);
    let temperature = solution.temperature.as_mut().unwrap();
    temperature.max_wheel += 160.0;
    temperature.max_rail += 130.0;
    let drawings = drawings("", &solution).unwrap();
    let cut = &drawings.iter().find(|(name, _)| name == "cut_y0").unwrap().1;
    let document = roxmltree::Document::parse(cut).unwrap();
    let dashed = |color: &str| {
        let mut all = document.descendants().filter(|node| node.attribute("stroke") == Some(color));
        all.any(|node| node.attribute("stroke-dasharray").is_some())
    };
    assert!(!dashed("#d55e00") && dashed("#0072b2"));
    let text = text_of(cut);
    let after = text.split("slip velocity").nth(1).unwrap();
    let axis = after.split("temperature (°C)").next().unwrap();
    let ticks: Vec<f64> = axis.lines().filter_map(|line| line.parse().ok()).collect();
    assert!(!ticks.is_empty() && ticks.iter().all(|tick| *tick > 100.0), "{text}");
}

fn map_of_traction(solution: &Solution) -> String {
    let drawings = drawings("", solution).unwrap();
    drawings.into_iter().find(|(name, _)| name == "map_traction").unwrap().1
}

/// The part that sticks is hatched: here at the leading edge, at positive x.
#[test]
fn the_part_that_sticks_is_hatched() {
    let svg = map_of_traction(&solution(RECIPE));
    let text = text_of(&svg);
    assert!(text.contains("\nstick\nstick–slip boundary"), "{text}");
    let document = roxmltree::Document::parse(&svg).unwrap();
    let is_hatched = |node: &roxmltree::Node| {
        node.has_tag_name("path") && node.attribute("fill") == Some("url(#stick)")
    };
    let hatched = document.descendants().find(is_hatched).unwrap().attribute("d").unwrap();
    let ellipse = document.descendants().find(|node| node.has_tag_name("ellipse")).unwrap();
    let middle: f64 = ellipse.attribute("cx").unwrap().parse().unwrap();
    let points = hatched.split(['M', 'L', 'z']).filter(|point| !point.is_empty());
    let xs: Vec<f64> =
        points.map(|point| point.split(' ').next().unwrap().parse().unwrap()).collect();
    let mean = xs.iter().sum::<f64>() / xs.len() as f64;
    assert!(mean > middle + 10.0, "{mean} {middle}");
}

/// A few cells of the rim that are said to stick at nearly full slip are no region.
#[test]
fn single_cells_that_stick_leave_no_border() {
    let mut solution = solution(Recipe { stick: 0.0, ..RECIPE });
    solution.fields.sliding.fill(true);
    solution.fields.sliding[0] = false;
    let text = text_of(&map_of_traction(&solution));
    assert!(text.contains("contact") && !text.contains("stick"), "{text}");
}

/// On a slender patch three arrows fit side by side.
#[test]
fn arrows_fit_a_slender_patch() {
    let recipe = Recipe { semi_axes: [1e-3, 10e-3], cells: 24, direction: 0.5, stick: 0.0 };
    let svg = map_of_traction(&solution(recipe));
    let document = roxmltree::Document::parse(&svg).unwrap();
    let is_arrows = |node: &roxmltree::Node| {
        node.has_tag_name("path") && node.attribute("fill") == Some("#000000")
    };
    let arrows = document.descendants().find(is_arrows).unwrap().attribute("d").unwrap();
    let points = |arrow: &str| -> Vec<f64> {
        let points = arrow.trim_end_matches('z').split('L');
        points.map(|point| point.split(' ').next().unwrap().parse().unwrap()).collect()
    };
    let widths = arrows.split('M').skip(1).map(|arrow| {
        let x = points(arrow);
        let end = |pick: fn(f64, f64) -> f64| x.iter().copied().reduce(pick).unwrap();
        end(f64::max) - end(f64::min)
    });
    let widths: Vec<f64> = widths.collect();
    let ellipse = document.descendants().find(|node| node.has_tag_name("ellipse")).unwrap();
    let half: f64 = ellipse.attribute("rx").unwrap().parse().unwrap();
    assert!(widths.len() > 40 && widths.iter().all(|width| *width < 0.7 * half), "{widths:?}");
}

/// Titles are any text: what the font lacks is a box in the PNG, not a gap, and itself in the SVG.
#[test]
fn characters_that_the_font_lacks_are_boxes() {
    let figure = |title: &str| {
        let history = drawings(title, &solution(RECIPE)).unwrap().pop();
        render(history.into_iter().collect()).unwrap().remove(0)
    };
    let [lacking, boxes, spaces] =
        ["wheel \u{8f6e}\u{8f68}", "wheel \u{25a1}\u{25a1}", "wheel   "].map(figure);
    assert!(text_of(&lacking.svg).contains('\u{8f6e}'));
    assert!(lacking.png == boxes.png && lacking.png != spaces.png);
    // Letters and signs of other languages than English and of mathematics are in the font.
    let [known, boxes] = ["ẞỹȘ≠∈ℝ", "□□□□□□"].map(figure);
    assert!(known.png != boxes.png);
}

/// The rim of a patch that is no ellipse follows the covered parts of its cells: here it is one in
/// truth, and the rim is nowhere more than a quarter of a cell from it.
#[test]
fn the_rim_of_any_patch_is_smooth() {
    let mut solution = solution(Recipe { cells: 24, ..RECIPE });
    let [a, b] = RECIPE.semi_axes;
    solution.fields.pressure.fill(5e8);
    let svg = map_of_traction(&solution);
    assert!(!svg.contains("<ellipse"));
    let document = roxmltree::Document::parse(&svg).unwrap();
    let is_rim = |node: &roxmltree::Node| {
        node.has_tag_name("path") && node.attribute("stroke-width") == Some("1.3")
    };
    let rims = document.descendants().filter(is_rim);
    let rim = rims.filter_map(|node| node.attribute("stroke").and(node.attribute("d")));
    let rim = rim.max_by_key(|path| path.len()).unwrap();
    let points = points_of(rim.trim_end_matches('z'));
    let ends = |axis: usize| {
        let values = || points.iter().map(|point| point[axis]);
        [values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max)]
    };
    let [x, y] = [ends(0), ends(1)];
    let half = |[low, high]: [f64; 2]| 0.5 * (high - low);
    assert!((half(y) / half(x) - b / a).abs() < 0.05 * b / a);
    for point in &points {
        let u = (point[0] - 0.5 * (x[0] + x[1])) / half(x);
        let v = (point[1] - 0.5 * (y[0] + y[1])) / half(y);
        let cells = 12.0 * (u.hypot(v) - 1.0);
        assert!(cells.abs() < 0.25, "{cells} at {u}, {v}");
    }
}

/// The curves of a drawing with a stroke colour, as points of the drawing.
fn curves(svg: &str, color: &str) -> Vec<Vec<[f64; 2]>> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let is_curve = |node: &roxmltree::Node| {
        node.attribute("fill") == Some("none") && node.attribute("stroke") == Some(color)
    };
    let paths = document.descendants().filter(is_curve).filter_map(|node| node.attribute("d"));
    paths.map(points_of).collect()
}

fn points_of(path: &str) -> Vec<[f64; 2]> {
    let points = path.split(['M', 'L']).filter(|point| !point.is_empty());
    let numbers = points.map(|point| point.split(' ').map(|number| number.parse().unwrap()));
    numbers.map(|mut n| [n.next().unwrap(), n.next().unwrap()]).collect()
}

/// Along y = 0 every curve reaches from the trailing to the leading edge, where the traction is
/// zero, whether the rim is known exactly or from the covered parts of the cells.
#[test]
fn curves_of_the_cut_end_at_the_edges_of_the_patch() {
    for is_elliptic in [true, false] {
        let mut solution = solution(RECIPE);
        if !is_elliptic {
            solution.fields.pressure.iter_mut().for_each(|pressure| *pressure *= 0.8);
        }
        let drawings = drawings("", &solution).unwrap();
        let cut = &drawings.iter().find(|(name, _)| name == "cut_y0").unwrap().1;
        let document = roxmltree::Document::parse(cut).unwrap();
        let plot = document
            .descendants()
            .find(|node| node.has_tag_name("rect") && node.attribute("fill") == Some("none"));
        let number = |name: &str| plot.unwrap().attribute(name).unwrap().parse::<f64>().unwrap();
        let [left, width] = ["x", "width"].map(number);
        let blue = curves(cut, "#0072b2");
        let red = curves(cut, "#d55e00");
        let [traction, slip, rise] = [&blue[0], &blue[1], &red[0]];
        let height = |curve: &[[f64; 2]]| [curve[0][1], curve[curve.len() - 1][1]];
        let [trailing, leading] = height(traction);
        assert!((trailing - leading).abs() < 0.02);
        assert!(traction.iter().all(|point| point[1] <= trailing + 0.02));
        let ends = |curve: &[[f64; 2]]| [curve[0][0], curve[curve.len() - 1][0]];
        let [a, cell] = [RECIPE.semi_axes[0], solution.fields.grid.spacing_x];
        let range = if is_elliptic { 2.12 * a } else { 1.06 * (2.0 * a + 4.0 * cell) };
        for curve in [traction, slip, rise] {
            let along = ends(curve).map(|x| ((x - left) / width - 0.5) * range);
            // The strip is as high as a cell, and its edges are their means over it.
            assert!(
                (along[0] + a).abs() < 0.02 * a && (along[1] - a).abs() < 0.02 * a,
                "{along:?}"
            );
        }
    }
}

/// Where everything slides, the traction is the bound, and both are seen.
#[test]
fn the_bound_is_seen_beneath_the_traction() {
    let drawings = drawings("", &solution(Recipe { stick: 0.0, ..RECIPE })).unwrap();
    let cut = &drawings.iter().find(|(name, _)| name == "cut_y0").unwrap().1;
    let document = roxmltree::Document::parse(cut).unwrap();
    let curve = |color: &str| {
        let mut drawn =
            document.descendants().filter(|node| node.attribute("fill") == Some("none"));
        drawn.find(|node| node.attribute("stroke") == Some(color)).unwrap()
    };
    let [bound, traction] = ["#c6c6c6", "#0072b2"].map(curve);
    let points = |curve: roxmltree::Node| points_of(curve.attribute("d").unwrap());
    for (one, other) in points(bound).iter().zip(points(traction)) {
        assert!((one[0] - other[0]).abs() < 0.1 && (one[1] - other[1]).abs() < 1.0);
    }
    let width = |curve: roxmltree::Node| -> f64 {
        curve.attribute("stroke-width").unwrap().parse().unwrap()
    };
    assert!(width(bound) > 2.0 * width(traction));
}
