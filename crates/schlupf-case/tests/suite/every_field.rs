//! Every field of the table with everything that cannot stand in it: each error names the field and
//! its line. Goal: no field forgets a check. Set-up: one case for each field and each bad value,
//! made from the table of fields itself.

use schlupf_case::fields::{self, Field, Kind, Requirement};
use schlupf_case::{CaseFile, Folder, Overrides};

/// A case with one field, and the line it stands in.
fn case(field: &Field, value: &str) -> (String, usize) {
    let assignment = format!("{} = {value}", field.name());
    match field.section() {
        "" => (assignment, 1),
        section => (format!("# bad on purpose\n[{section}]\n{assignment}"), 3),
    }
}

fn assert_refused(field: &Field, value: &str) {
    let (text, line) = case(field, value);
    let Err(errors) =
        CaseFile::from_str(&text, "case.toml", Folder::new("/nowhere"), Overrides::NONE)
    else {
        panic!("{text:?} was accepted")
    };
    let message = errors.first.to_string();
    assert_eq!(errors.first.field, field.path.as_str(), "{text:?}: {message}");
    let place = format!("case.toml:{line}:");
    for part in [place.as_str(), &field.path] {
        assert!(message.contains(part), "{text:?}: {part:?} is not in {message:?}");
    }
    let zeros = |text: &str| text.contains("000000");
    assert!(!zeros(&message), "{text:?}: a run of zeros in {message:?}");
}

/// Numbers just outside of what a field must be, in its SI unit.
fn outside(field: &Field) -> Vec<f64> {
    let step = |bound: f64, sign: f64| match field.kind {
        Kind::Count => bound + sign,
        _ if bound == 0.0 => sign,
        // Few digits, as somebody would write it.
        _ => format!("{:.3e}", bound + sign * 0.5 * bound.abs()).parse().unwrap(),
    };
    match field.requirement {
        Requirement::Finite => Vec::new(),
        Requirement::Magnitude(high) => vec![step(-high, -1.0), step(high, 1.0)],
        Requirement::Between(low, high) => vec![step(low, -1.0), step(high, 1.0)],
        Requirement::Inside(low, high) => vec![low, high],
        Requirement::AboveUpTo(low, high) => vec![low, step(high, 1.0)],
        Requirement::AtLeast(low) => vec![step(low, -1.0)],
        Requirement::Radius(low, high) => {
            vec![0.0, step(low, -1.0), -step(low, -1.0), step(high, 1.0), -step(high, 1.0)]
        }
        other => panic!("no field has the requirement {other:?}"),
    }
}

/// Everything that cannot be the number of a field, as TOML.
fn bad_numbers(field: &Field) -> Vec<String> {
    let mut values = vec!["true".to_owned(), "nan".to_owned(), "-inf".to_owned()];
    if !matches!(field.requirement, Requirement::Radius(..)) {
        values.push("inf".to_owned());
    }
    match field.kind {
        Kind::Quantity(measure) | Kind::Quantities(measure) => {
            let unit = measure.unit;
            values.extend(["1.5", "3", "\"1 kg\"", "\"1\"", "\"\"", "\"kg\""].map(str::to_owned));
            values.push(format!("\"nan {unit}\""));
            values.push(format!("\"-inf {unit}\""));
            values.push(format!("\"1e999 {unit}\""));
            values.extend(outside(field).iter().map(|number| format!("\"{number:e} {unit}\"")));
        }
        Kind::Count => {
            values.extend(["1.5", "\"3\"", "\"3 kg\""].map(str::to_owned));
            values.extend(outside(field).iter().map(|number| format!("{number}")));
        }
        _ => {
            values.extend(["\"1\"", "\"1 kg\"", "\"nan\""].map(str::to_owned));
            values.extend(outside(field).iter().map(|number| format!("{number:e}")));
        }
    }
    values
}

fn bad_values(field: &Field) -> Vec<String> {
    match field.kind {
        Kind::Text | Kind::Path => ["3", "true", "[]", "nan"].map(str::to_owned).to_vec(),
        Kind::Flag => ["1", "\"true\"", "\"yes\"", "[true]"].map(str::to_owned).to_vec(),
        Kind::Choice(_) => ["3", "true", "\"nothing of the kind\""].map(str::to_owned).to_vec(),
        Kind::Quantities(_) | Kind::Numbers => {
            let mut values: Vec<String> =
                bad_numbers(field).iter().map(|value| format!("[{value}]")).collect();
            values.extend(["3", "\"3\""].map(str::to_owned));
            values
        }
        Kind::Quantity(_) | Kind::Number | Kind::Count | Kind::NumberOr(_) => bad_numbers(field),
    }
}

#[test]
fn what_cannot_stand_in_a_field_is_refused_at_its_line() {
    let mut count = 0;
    for field in fields::all() {
        for value in bad_values(field) {
            assert_refused(field, &value);
            count += 1;
        }
    }
    assert!(count > 400, "{count}");
}

/// Fields without a default that a choice needs: missing, they are named at the line of the choice.
#[test]
fn what_a_choice_needs_is_missed_at_its_line() {
    for (section, choice, field) in
        [("normal", "tabulated", "normal.file"), ("normal", "ellipse", "normal.semi_axis_x")]
    {
        let text = format!("[{section}]\nmodel = \"{choice}\"");
        let errors =
            CaseFile::from_str(&text, "case.toml", Folder::new("/nowhere"), Overrides::NONE)
                .unwrap_err();
        let message = errors.to_string();
        assert!(message.contains(&format!("case.toml:2:9: {field} is missing")), "{message}");
    }
}
