//! JSON, CSV, VTK and the summary of a made-up solution.

use std::collections::BTreeSet;

use crate::common::{RECIPE, solution};
use schlupf::reporting::{Column, Message, Record};
use schlupf::solution::{Extrapolation, Resultant};
use schlupf::wheel_rail::{Contact, WheelSolution};
use schlupf::{Solution, Status, unwatched};
use schlupf_case::{CaseFile, Folder, Overrides};
use schlupf_tasks::output::Report;
use schlupf_tasks::output::solution::SolutionReport;
use schlupf_tasks::solve::solve;

/// The keys that the interface fixes, as paths.
const KEYS: &str = "program title status normal normal.load normal.semi_axis_x normal.semi_axis_y \
    normal.peak_pressure normal.approach kinematics kinematics.speed kinematics.creepage_x \
    kinematics.creepage_y kinematics.spin force force.x force.y force.moment_z normalised \
    normalised.x normalised.y normalised.moment_z traction_coefficient power power.friction \
    power.creep t_gamma t_gamma.without_spin t_gamma.with_spin temperature temperature.max_rise \
    temperature.max_rise_wheel temperature.max_rise_rail temperature.max_wheel \
    temperature.max_rail temperature.x temperature.y area area.contact area.stick area.slip \
    sensitivity history warnings residual work work.newton_iterations work.operator_products \
    work.outer_iterations work.steps work.cells";

/// Those that came later.
const ADDED_KEYS: &str = "history.shift_x history.shift_y history.turn work.strategy normal.origin_x normal.origin_y normal.parts power.returned power.into_wheel power.into_rail power.exchanged \
    temperature.peclet_wheel temperature.peclet_rail history.time history.speed history.creepage_x \
    history.creepage_y history.spin history.load history.force_x history.force_y \
    history.moment_z history.max_rise history.distance history.friction_power history.creep_power \
    history.stored_energy history.residual history.newton_iterations reference reference.point reference.patch reference.patch.creepage_x \
    reference.patch.creepage_y reference.patch.spin reference.patch.moment_z reference.file";

fn paths(value: &serde_json::Value, prefix: &str, found: &mut BTreeSet<String>) {
    for (key, value) in value.as_object().into_iter().flatten() {
        let path = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
        paths(value, &path, found);
        found.insert(path);
    }
}

fn report(title: &str, solution: Solution) -> SolutionReport {
    SolutionReport {
        title: title.to_owned(),
        contact_law: None,
        solution,
        wheel: None,
        warnings: Vec::new(),
    }
}

#[test]
fn json_has_the_keys_of_the_interface_and_no_others() {
    let document = report("a \"case\"", solution(RECIPE)).json();
    let value: serde_json::Value = serde_json::from_str(&document).unwrap();
    let mut found = BTreeSet::new();
    paths(&value, "", &mut found);
    let mut expected: BTreeSet<String> =
        KEYS.split_whitespace().chain(ADDED_KEYS.split_whitespace()).map(str::to_owned).collect();
    expected.insert("method".to_owned());
    expected.insert("work.sensitivity_products".to_owned());
    expected.insert("sensitivity.load".to_owned());
    for parameter in
        ["creepage_x", "creepage_y", "spin", "friction_coefficient", "contact_stiffness"]
    {
        expected.insert(format!("sensitivity.{parameter}"));
        for component in ["x", "y", "moment_z"] {
            expected.insert(format!("sensitivity.{parameter}.{component}"));
        }
    }
    assert_eq!(found, expected);
    assert_eq!(value["sensitivity"]["creepage_x"]["x"], -2.5e6);
    assert!(value["sensitivity"]["load"].is_null());
    assert_eq!(value["title"], "a \"case\"");
    assert_eq!(value["status"], "converged");
    assert_eq!(value["program"], concat!("schlupf ", env!("CARGO_PKG_VERSION")));
    assert_eq!(value["history"]["force_x"].as_array().unwrap().len(), 40);
}

#[test]
fn json_gives_back_the_same_numbers() {
    let solution = solution(RECIPE);
    let value: serde_json::Value =
        serde_json::from_str(&report("case", solution.clone()).json()).unwrap();
    assert_eq!(value["force"]["x"].as_f64(), Some(solution.force.x));
    assert_eq!(value["power"]["returned"].as_f64(), Some(solution.power.unwrap().returned));
    assert_eq!(value["work"]["cells"].as_u64(), Some(solution.fields.len() as u64));
}

#[test]
fn json_stays_valid_where_numbers_are_not() {
    let mut solution = solution(RECIPE);
    solution.status = Status::NotConverged;
    solution.force.x = f64::NAN;
    solution.residual = f64::INFINITY;
    solution.normal.approach = None;
    let value: serde_json::Value =
        serde_json::from_str(&report("case", solution.clone()).json()).unwrap();
    assert!(value["force"]["x"].is_null());
    assert!(value["residual"].is_null());
    assert!(value["normal"]["approach"].is_null());
    assert_eq!(value["status"], "not-converged");
}

#[test]
fn csv_reads_back_to_the_same_numbers() {
    let solution = solution(RECIPE);
    let text = report("", solution.clone()).csv().unwrap();
    assert!(
        text.starts_with("# units: m, m, Pa, Pa, Pa, m/s, m/s, m, m, 1, W/m^2, K, K, 1, 0 or 1")
    );
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(
        header.join(", "),
        "x, y, pressure, traction_x, traction_y, slip_x, slip_y, displacement_x, displacement_y, \
         friction_coefficient, friction_power, temperature_rise_wheel, temperature_rise_rail, \
         covered, sliding"
    );
    let rows: Vec<[f64; 15]> = reader.deserialize().map(Result::unwrap).collect();
    let fields = &solution.fields;
    assert_eq!(rows.len(), fields.len());
    for (cell, row) in rows.iter().enumerate() {
        let read = [row[0], row[1], row[2], row[3], row[6], row[10], row[11]];
        let written = [
            fields.x[cell],
            fields.y[cell],
            fields.pressure[cell],
            fields.traction_x[cell],
            fields.slip_y[cell],
            fields.friction_power[cell],
            fields.temperature_rise_wheel[cell],
        ];
        assert_eq!(read, written);
        assert_eq!(row[14] == 1.0, fields.sliding[cell]);
    }
}

#[test]
fn vtk_has_a_value_for_every_cell_of_the_grid() {
    let solution = solution(RECIPE);
    let file =
        report("Rad\nauf Schiene, µ", solution.clone()).own_file(SolutionReport::VTK).unwrap();
    let grid = &solution.fields.grid;
    let text = String::from_utf8_lossy(&file);
    let header: Vec<&str> = text.lines().take(8).collect();
    assert_eq!(header[0], "# vtk DataFile Version 3.0");
    assert_eq!(header[1], "Rad auf Schiene,  ");
    assert_eq!(header[2..4], ["BINARY", "DATASET STRUCTURED_POINTS"]);
    assert_eq!(header[4], format!("DIMENSIONS {} {} 1", grid.columns + 1, grid.rows + 1));
    assert_eq!(header[7], format!("CELL_DATA {}", grid.len()));

    let start = find(&file, b"SCALARS pressure double 1\nLOOKUP_TABLE default\n");
    let (cell, &[column, row]) = solution.fields.cell.iter().enumerate().nth(100).unwrap();
    let at = start + 8 * grid.index(column, row);
    let value = f64::from_be_bytes(file[at..at + 8].try_into().unwrap());
    assert_eq!(value, solution.fields.pressure[cell]);

    let scalars = text.matches("LOOKUP_TABLE").count();
    let vectors = text.matches("VECTORS").count();
    let data = 8 * grid.len() * (scalars + 3 * vectors);
    assert!(file.len() > data && file.len() < data + 1200);
}

/// Where in the file the data behind a head begins.
fn find(file: &[u8], head: &[u8]) -> usize {
    file.windows(head.len()).position(|window| window == head).unwrap() + head.len()
}

#[test]
fn summary_fits_a_terminal() {
    let mut solution = solution(RECIPE);
    let text = report("steel wheel", solution.clone()).summary().to_string();
    assert!(text.lines().count() <= 35);
    assert!(text.lines().all(|line| line.chars().count() <= 100));
    for part in ["steel wheel", "5.88 mm", "770 MPa", "108 km/h"] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    solution.status = Status::NotConverged;
    let mut failed = report("", solution.clone());
    failed.warnings.push(Message::new(Message::NOT_CONVERGED, "solver", "after 9 steps"));
    let text = failed.summary().to_string();
    assert_eq!(text.to_lowercase().matches("not converged").count(), 1, "{text}");
    assert!(text.contains("after 9 steps") && text.contains("(not settled)"), "{text}");
}

#[test]
fn rounding_noise_is_no_force_and_no_rise_has_no_place() {
    let mut solution = solution(RECIPE);
    (solution.force.y, solution.normalised.y) = (3.1e-9, 1e-13);
    (solution.force.moment_z, solution.normalised.moment_z) = (Some(-2e-12), Some(-6e-15));
    solution.temperature = Some(schlupf::solution::Temperature::default());
    let text = report("", solution.clone()).summary().to_string();
    let line = |name: &str| text.lines().find(|line| line.starts_with(name)).unwrap();
    let words = |name: &str| line(name).split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(words("lateral force"), "lateral force 0 kN 0 μ0 N");
    assert_eq!(words("moment"), "moment 0 N m 0 μ0 N √(ab)");
    assert_eq!(words("largest temp"), "largest temp. rise 0 K");
    assert_eq!(words("Péclet"), "Péclet number 2500 v a/κ of the wheel, 2600 of the rail");
}

#[test]
fn minus_zero_is_zero() {
    let mut solution = solution(RECIPE);
    solution.kinematics.creepage_y = -0.0;
    solution.fields.traction_y.fill(-0.0);
    assert!(!report("", solution.clone()).json().contains("-0.0,"));
    assert!(!report("", solution.clone()).csv().unwrap().contains("-0e0"));
}

/// The number of columns with a value, each of which is that of the JSON under its dotted keys.
fn count_in_json<R: Record>(record: &R, document: &serde_json::Value) -> usize {
    let compare = |column: &Column<R>| {
        let path = column.name.replace('.', "/");
        let found = document.pointer(&format!("/{path}"));
        let found = found.unwrap_or_else(|| panic!("no {} in the JSON", column.name));
        let number = (column.value)(record, 0).number();
        // Reading JSON rounds the last digit. A list counts by its length.
        let length = found.as_array().map(|list| list.len() as f64);
        let is_same = match (found.as_f64().or(length), number) {
            (Some(found), Some(number)) => (found - number).abs() <= 1e-15 * number.abs(),
            (found, number) => found == number,
        };
        assert!(is_same, "{}: {found} is not {number:?}", column.name);
        number.is_some()
    };
    R::COLUMNS.iter().filter(|column| compare(column)).count()
}

/// The columns of a study are the scalars of the JSON under their dotted keys, with their values.
#[test]
fn columns_of_a_solution_are_the_keys_of_its_json() {
    let mut solution = solution(RECIPE);
    let (force, normalised) = (solution.force, solution.normalised);
    let error = Resultant::new(1.0, 2.0, 3.0);
    solution.extrapolation = Some(Extrapolation { force, normalised, error });
    let document: serde_json::Value =
        serde_json::from_str(&report("case", solution.clone()).json()).unwrap();
    let count = count_in_json(&solution, &document);
    assert!(count > 30, "{count}");
    // The other way round: every scalar of these sections has a column.
    let sections = "normal kinematics force normalised power t_gamma temperature area";
    let known = ["normal.origin_x", "normal.origin_y", "normal.parts"];
    for section in sections.split(' ') {
        for key in document[section].as_object().unwrap().keys() {
            let name = format!("{section}.{key}");
            let has_column = Solution::COLUMNS.iter().any(|column| column.name == name);
            assert!(has_column || known.contains(&&*name), "{name} has no column");
        }
    }
}

/// The same of a wheel and of each of its contacts.
#[test]
fn columns_of_a_wheel_and_its_contacts_are_the_keys_of_their_json() {
    let text = r#"
kinematics = { speed = "20 m/s", creepage_x = 0.002 }
wheel = { profile = "S1002", radius_x = "460 mm" }
rail = { profile = "60E1", cant = 0.025 }
normal = { model = "wheel-rail", load = "80 kN", cells = 24 }
wheelset = { side = "right", lateral_position = "-6 mm" }
grid = { cells_x = 10, cells_y = 10 }
"#;
    let file = CaseFile::from_str(text, "a wheel", Folder::new(""), Overrides::NONE).unwrap();
    let case = file.pose(&unwatched).unwrap();
    let report = solve(&case, case.rolling(None).unwrap(), &unwatched).unwrap();
    let document: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
    let wheel = report.wheel.unwrap();
    assert_eq!(count_in_json(&*wheel, &document), WheelSolution::COLUMNS.len());
    for (contact, document) in wheel.contacts.iter().zip(document["contacts"].as_array().unwrap()) {
        assert_eq!(count_in_json(contact, document), Contact::COLUMNS.len());
    }
}
