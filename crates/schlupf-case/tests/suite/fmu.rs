//! FMUs: descriptions, resources and archives.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::sync::Arc;

use roxmltree::{Document, Node};
use schlupf::unwatched;
use schlupf_case::fmu::{Binary, Fmu, Resources, Role, Version};
use schlupf_case::{CaseFile, Folder, Overrides};
use zip::ZipArchive;

const CASE: &str = "title = \"a < b & \\\"c\\\"\"\nsolver.method = \"shen-hedrick-elkins\"\n";

fn case(text: &str) -> CaseFile {
    CaseFile::from_str(text, "case", Folder::new(""), Overrides::NONE).unwrap()
}

fn fmu(text: &str) -> Fmu {
    Fmu::of(&case(text), &unwatched).unwrap()
}

fn named<'a>(document: &'a Document, name: &str) -> Vec<Node<'a, 'a>> {
    document.descendants().filter(|node| node.has_tag_name(name)).collect()
}

/// Every quantity of the element with its unit in base units; each variable once.
#[test]
fn a_description_has_every_variable_once() {
    let fmu = fmu(CASE);
    let names: Vec<&str> = fmu.variables().iter().map(|of| of.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "time",
            "velocity_x",
            "velocity_y",
            "spin_rate",
            "angular_velocity",
            "load",
            "friction_factor",
            "wheel_bulk_temperature",
            "rail_bulk_temperature",
            "force_x",
            "force_y",
            "moment_z",
            "approach",
            "semi_axis_x",
            "semi_axis_y",
            "friction",
            "creep_power",
            "max_rise",
            "elastic_shift_x",
            "elastic_shift_y",
            "elastic_turn",
            "der(elastic_shift_x)",
            "der(elastic_shift_y)",
            "der(elastic_turn)",
        ]
    );
    let text = fmu.description(Version::Two);
    let document = Document::parse(&text).unwrap();
    assert_eq!(document.root_element().attribute("modelName"), Some("a < b & \"c\""));
    let unit = |name: &str| {
        let units = named(&document, "Unit");
        let unit = units.into_iter().find(|unit| unit.attribute("name") == Some(name)).unwrap();
        let base = unit.first_element_child().unwrap();
        base.attributes().map(|of| format!("{} {}", of.name(), of.value())).collect::<Vec<_>>()
    };
    assert_eq!(unit("N m"), ["kg 1", "m 2", "s -2"]);
    assert_eq!(unit("W"), ["kg 1", "m 2", "s -3"]);
    assert_eq!(unit("degC"), ["K 1", "offset 273.15"]);
    assert_eq!(unit("rad/s"), ["s -1", "rad 1"]);
    assert_eq!(unit("m/s"), ["m 1", "s -1"]);
    // Of the messages that the library tells.
    let categories = named(&document, "Category");
    let categories: Vec<_> = categories.iter().filter_map(|of| of.attribute("name")).collect();
    assert_eq!(categories, ["logStatusWarning", "logStatusDiscard", "logStatusError"]);
    // A rate names its state, counted from one.
    let rate = named(&document, "ScalarVariable").pop().unwrap();
    assert_eq!(rate.attribute("valueReference"), Some("23"));
    let real = rate.first_element_child().unwrap();
    assert_eq!(real.attribute("derivative"), Some("21"));
    assert_eq!(named(&document, "Outputs")[0].children().filter(Node::is_element).count(), 9);
    let text = fmu.description(Version::Three);
    let document = Document::parse(&text).unwrap();
    assert_eq!(named(&document, "Float64").len(), names.len());
    assert_eq!(named(&document, "Output").len(), 9);
}

/// Without memory there are no states; an approach as an input is no output, but the load is one.
#[test]
fn variables_are_those_of_the_element() {
    let fmu = fmu(&format!("{CASE}[element]\nmemory = false\nnormal = \"approach\""));
    let has = |name: &str| fmu.variables().iter().filter(|of| of.name == name).count();
    assert_eq!([has("load"), has("approach")], [1, 1]);
    assert!(!fmu.variables().iter().any(|of| matches!(of.role, Role::State(_) | Role::Rate(_))));
    let text = fmu.description(Version::Two);
    assert!(!text.contains("<Derivatives>"));
}

/// The nominal shift is that at which the force of Kalker's linear theory is μN.
#[test]
fn nominal_states_are_those_at_the_friction_limit() {
    let linear =
        case(&CASE.replace("shen-hedrick-elkins", "kalker-linear")).pose(&unwatched).unwrap();
    let mut element = linear.element().unwrap();
    let nominal = fmu(CASE).variables()[18].nominal.unwrap();
    let mut found = element.evaluation();
    element.evaluate(&element.start(), &[nominal, 0.0, 0.0], &mut found);
    let friction = linear.problem.interface.friction.cold_coefficient();
    let limit = friction * linear.problem.normal.normal_contact(None).unwrap().summary.load;
    assert!((found.outputs[0] / -limit - 1.0).abs() < 1e-9, "{}", found.outputs[0] / limit);
}

/// An FMU stands alone: with the text of the case, overrides in it, and the files that it names.
#[test]
fn resources_make_the_element_again() {
    let folder = tempfile::tempdir().unwrap();
    let table = include_bytes!("../../src/look_up_table/standard.npz").to_vec();
    let text = "[solver]\nmethod = \"table\"\ntable = \"../tables/my table.npz\"\n";
    let files = BTreeMap::from([("../tables/my table.npz".to_owned(), table)]);
    let assignments = &["normal.load=60 kN".to_owned()];
    let set = Overrides { option: "--set", assignments };
    let file = CaseFile::from_str(text, "case", Arc::new(files), set).unwrap();
    let (resources, mut element) = Resources::of(&file, &unwatched).unwrap();
    for (name, bytes) in resources.members() {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    let again = Resources::from_folder(folder.path()).unwrap();
    assert_eq!(again, resources);
    assert_eq!(again.token(), resources.token());
    let mut same = again.element(&unwatched).unwrap();
    assert_eq!(same.start()[4], 60e3);
    let [mut one, mut other] = [element.evaluation(), same.evaluation()];
    element.evaluate(&element.start(), &[1e-3, 0.0, 0.0], &mut one);
    same.evaluate(&same.start(), &[1e-3, 0.0, 0.0], &mut other);
    assert_eq!(one, other);
    // Whatever changes is another FMU.
    std::fs::write(folder.path().join("case.toml"), "").unwrap();
    let other = Resources::from_folder(folder.path()).unwrap();
    assert_ne!(other.token(), resources.token());
    // Without its table there is no element.
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    std::fs::write(folder.path().join("files.json"), "{}").unwrap();
    let without = Resources::from_folder(folder.path()).unwrap();
    assert!(without.element(&unwatched).unwrap_err().to_string().contains("solver.table"));
}

#[test]
fn an_archive_has_every_part_in_its_place() {
    let fmu = fmu(CASE);
    let binaries = ["linux64", "win64", "aarch64-darwin"]
        .map(|platform| Binary { platform: platform.to_owned(), bytes: vec![7; 10] });
    let bytes = fmu.to_bytes(Version::Two, &binaries).unwrap();
    assert_eq!(bytes, fmu.to_bytes(Version::Two, &binaries).unwrap());
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut names: Vec<String> =
        archive.file_names().map(|name| name.unwrap().into_owned()).collect();
    names.sort();
    assert_eq!(
        names,
        [
            "binaries/aarch64-darwin/schlupf.dylib",
            "binaries/linux64/schlupf.so",
            "binaries/win64/schlupf.dll",
            "modelDescription.xml",
            "resources/case.toml",
            "resources/files.json",
        ]
    );
    let mut text = String::new();
    archive.by_name("modelDescription.xml").unwrap().read_to_string(&mut text).unwrap();
    assert_eq!(text, fmu.description(Version::Two));
}

/// A wheel with profiles has no force element.
#[test]
fn a_case_without_an_element_is_refused() {
    let text = "[normal]\nmodel = \"wheel-rail\"\nload = \"80 kN\"\n[wheel]\nprofile = \"S1002\"\n\
                [rail]\nprofile = \"60E1\"\ncant = 0.025\n[solver]\nmethod = \"kalker-linear\"\n";
    let error = Fmu::of(&case(text), &unwatched).unwrap_err();
    assert!(error.to_string().contains("normal.model"), "{error}");
}
