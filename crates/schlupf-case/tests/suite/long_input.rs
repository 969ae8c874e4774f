//! Whatever is too long for a line is quoted short, by every reader, and rows are counted as a text
//! editor counts lines.

use std::collections::BTreeMap;
use std::sync::Arc;

use schlupf::bodies::Kinematics;
use schlupf::unwatched;
use schlupf_case::{
    CaseFile, Family, InputFile, Overrides, field, points, read_displacements, read_points,
};

use crate::support::read;

/// No message of a line or two, with the names of all fields of a section, is longer.
const LONGEST: usize = 1200;

/// A word that stands for a cell of 5 MB, a key of 100 kB or an array of 47 000 characters.
fn long() -> String {
    "1x".repeat(30_000)
}

fn with_file(case: &str, name: &str, text: String) -> String {
    let files = BTreeMap::from([(name.to_owned(), text.into_bytes())]);
    let file = CaseFile::from_str(case, "case.toml", Arc::new(files), Overrides::NONE);
    let case = file.and_then(|file| file.pose(&unwatched));
    case.err().map(|errors| errors.to_string()).unwrap_or_default()
}

#[track_caller]
fn assert_short(what: &str, message: &str) {
    assert!(!message.is_empty(), "{what} was accepted");
    assert!(message.chars().count() < LONGEST, "{what}: {} characters", message.chars().count());
}

#[test]
fn long_values_keys_and_units_are_quoted_short() {
    let long = long();
    let array = format!("[{}]", "\"1 s\",".repeat(12_000));
    for (what, text) in [
        ("a value", format!("[kinematics]\nspeed = \"{long}\"")),
        ("a unit", format!("[kinematics]\nspeed = \"1 {long}\"")),
        ("a number", format!("[kinematics]\ncreepage_x = \"{long}\"")),
        ("a number with a comma", format!("kinematics.speed = \"1,{} m/s\"", "0".repeat(60_000))),
        ("a choice", format!("[normal]\nmodel = \"{long}\"")),
        ("a key", format!("[kinematics]\n{long} = 1")),
        ("a section", format!("[{long}]\nspeed = 1")),
        ("an array", format!("[kinematics]\nspeed = {array}")),
        ("no TOML", format!("[kinematics]\nspeed = {long}")),
        ("a file", format!("[normal]\nmodel = \"tabulated\"\nfile = \"{long}\"")),
        ("a profile", format!("[normal]\nmodel = \"wheel-rail\"\n[wheel]\nprofile = \"{long}\"")),
    ] {
        let errors = read(&text, &[]).err().map(|errors| errors.to_string());
        assert_short(what, &errors.unwrap_or_default());
    }
    for (what, text) in [
        ("an override", long.clone()),
        ("a path of an override", format!("{long}=1")),
        ("a value of an override", format!("kinematics.speed={long}")),
        ("an array of an override", format!("kinematics.speed={array}")),
    ] {
        let errors = read("", &[&text]).err().map(|errors| errors.to_string());
        assert_short(what, &errors.unwrap_or_default());
    }
    for (what, text) in [
        ("a family", long.clone()),
        ("a field of a family", format!("{long}=1,2")),
        ("equal values of a family", format!("title={long},{long}")),
    ] {
        let error = Family::parse("--over", &text).err().map(|error| error.to_string());
        assert_short(what, &error.unwrap_or_default());
    }
    let error =
        points("--speed", field!("kinematics.speed"), &long).err().map(|error| error.to_string());
    assert_short("a range", &error.unwrap_or_default());
}

/// Tables with a long head, a long cell, a cell too many: of every kind that a case or a command
/// reads.
#[test]
fn long_cells_of_every_table_are_quoted_short() {
    let long = long();
    let motion = Kinematics::free_rolling(30.0);
    let points = |option: &str, text: String| {
        let files: Arc<BTreeMap<String, Vec<u8>>> =
            Arc::new(BTreeMap::from([("t.csv".to_owned(), text.into_bytes())]));
        let file = || InputFile::new("t.csv".to_owned(), files.clone());
        let error = match option {
            "--points" => read_points(option, &file()).err(),
            "--data" => schlupf_case::identification::read_data(option, &file(), &motion).err(),
            _ => read_displacements(option, &file()).err(),
        };
        error.map(|error| error.to_string()).unwrap_or_default()
    };
    let normal = |model: &str| format!("[normal]\nmodel = \"{model}\"\nfile = \"t.csv\"");
    let profile = "[normal]\nmodel = \"wheel-rail\"\n[wheel]\nprofile = \"t.csv\"\n\
                   [rail]\nprofile = \"60E1\"";
    for (what, head, case) in [
        ("pressure", "x [mm],y [mm],pressure [MPa]", normal("tabulated")),
        ("distance", "x [mm],y [mm],distance [um]", normal("profile")),
        ("history", "time [s],creepage_x,load [kN]", "history.file = \"t.csv\"".to_owned()),
        ("friction", "y [mm],factor", "friction.variation_file = \"t.csv\"".to_owned()),
        ("surface", "x [um],y [um],height [um]", "contact_law.roughness = \"t.csv\"".to_owned()),
        ("profile", "y [mm],z [mm]", profile.to_owned()),
        ("--points", "x [mm],y [mm],depth [mm]", String::new()),
        ("--data", "creepage_x,force_ratio", String::new()),
        ("--displacements", "x [mm],y [mm],traction_x [Pa]", String::new()),
    ] {
        let count = head.split(',').count();
        let row = |cell: &str| format!("{head}\n{}{cell}\n", "0,".repeat(count - 1));
        for (part, text) in [
            ("cell", row(&long)),
            ("comma", row(&format!("\"1,{}\"", "5".repeat(60_000)))),
            ("column", format!("{head},{long}\n")),
            ("unit", format!("{head} [{long}]\n")),
        ] {
            let is_option = what.starts_with("--");
            let message =
                if is_option { points(what, text) } else { with_file(&case, "t.csv", text) };
            assert_short(&format!("{what}, {part}"), &message);
        }
    }
}

/// Comments, empty lines, both ends of lines and a byte order mark, before a wrong cell in line 9.
#[test]
fn rows_are_counted_as_lines_of_an_editor() {
    let wrong = "\u{feff}# a\n\n# b\n\ntime [s],creepage_x\n# c\n\n0,0\n1,x\n";
    for text in [wrong.to_owned(), wrong.replace('\n', "\r\n")] {
        let message = with_file("history.file = \"h.csv\"", "h.csv", text);
        assert!(message.starts_with("h.csv:9:1: creepage_x must be a finite"), "{message}");
    }
}
