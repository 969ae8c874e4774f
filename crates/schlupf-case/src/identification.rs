//! What `schlupf fit` is given: parameters, and measured points.

use schlupf::analysis::identification::{DataPoint, Parameter};
use schlupf::bodies::Kinematics;

use crate::error::CaseError;
use crate::fields::closest;
use crate::files::InputFile;
use crate::place::Place;
use crate::{names, tables};
use schlupf::reporting::quoted;

/// Dotted path of the field of a parameter. That of the roughness stands for its k_c.
pub fn field(parameter: Parameter) -> &'static str {
    names::path(parameter.quantity())
}

/// The parameters that an option lists, such as
/// `friction.coefficient,friction.temperature_at_zero_friction`.
pub fn parameters(option: &str, text: &str) -> Result<Vec<Parameter>, CaseError> {
    let place = || Place::Override { option: option.into(), text: text.to_owned() };
    let mut parameters = Vec::new();
    for name in text.split(',').map(str::trim) {
        let Some(parameter) = Parameter::all().find(|parameter| field(*parameter) == name) else {
            let names = || Parameter::all().map(field);
            let short = |full: &&str| full.rsplit('.').next() == name.rsplit('.').next();
            let meant = closest(name, names()).or_else(|| names().find(short));
            let help = match meant {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("what can be fitted: {}", names().collect::<Vec<_>>().join(", ")),
            };
            let message =
                format!("{option} must list what can be fitted, but has {}", quoted(name));
            return Err(CaseError::new(name, message, place()).help(help));
        };
        if parameters.contains(&parameter) {
            let message = format!("{option} must list a parameter once, but has {name} twice");
            return Err(CaseError::new(name, message, place()));
        }
        parameters.push(parameter);
    }
    Ok(parameters)
}

/// The measured points of a CSV file that `option` names. What it has no column for is that of
/// `kinematics` and of the case's load.
pub fn read_data(
    option: &str,
    file: &InputFile,
    kinematics: &Kinematics,
) -> Result<Vec<DataPoint>, CaseError> {
    let name = file.path().display().to_string();
    let what = "the file of measured points";
    let bytes = file.read().map_err(|error| CaseError::unreadable("", what, &name, &error))?;
    tables::creep_data_from_csv(option, name, bytes, kinematics)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_named_as_in_the_case_file() {
        let names = "friction.coefficient, contact_law.stiffness";
        let read: Vec<&str> = parameters("--fit", names).unwrap().into_iter().map(field).collect();
        assert_eq!(read, ["friction.coefficient", "contact_law.stiffness"]);
        for parameter in Parameter::all() {
            assert_eq!(parameters("--fit", field(parameter)), Ok(vec![parameter]));
        }
    }

    #[test]
    fn other_names_are_refused_with_a_suggestion() {
        let message = |text| parameters("--fit", text).unwrap_err().to_string();
        assert!(message("friction.coeficient").contains("did you mean `friction.coefficient`?"));
        assert!(message("stiffness").contains("did you mean `contact_law.stiffness`?"));
        assert!(message("normal.load").contains("what can be fitted: friction.coefficient, "));
        let twice = message("friction.decay,friction.decay");
        assert!(twice.contains("but has friction.decay twice"), "{twice}");
        assert!(message("").contains("but has \"\""));
    }
}
