//! The commented case file of `schlupf init`, which is also the default case.

use crate::fields::{Default, Field, Kind, SECTIONS, Section, UsedWith, find};

const HEAD: &str = "\
# Case file of schlupf: rolling contact of wheel and rail.
#
# Quantities are text with a unit, dimensionless numbers are numbers. Whatever is left out has its
# default. Lines that begin with # are comments; those that hold a field show what else there is.

";

/// Where the comments of a section begin, in characters.
const COMMENT_COLUMN: usize = 46;

/// A case file with all fields and their meaning: the default case. Fields that only some models
/// use, or that replace others, are comments.
pub fn template() -> String {
    let sections: Vec<String> = SECTIONS.iter().map(section).collect();
    format!("{HEAD}{}", sections.join("\n"))
}

fn section(section: &Section) -> String {
    let mut lines = Vec::new();
    if !section.name.is_empty() {
        let comment = if section.fields.iter().any(is_active) { "" } else { "# " };
        lines.push(format!("# {}", section.doc));
        lines.push(format!("{comment}[{}]", section.name));
    }
    for field in section.fields {
        lines.push(line(field));
        lines.extend(
            field.kind.choices().iter().map(|choice| {
                format!("{:COMMENT_COLUMN$}#   {:?}: {}", "", choice.name, choice.doc)
            }),
        );
    }
    lines.join("\n") + "\n"
}

fn line(field: &Field) -> String {
    let assignment = field.assignment().unwrap_or_default();
    let comment = if is_active(field) { "" } else { "# " };
    let doc = match field.default {
        Default::Same(text) | Default::Computed(text) => format!("{}; default: {text}", field.doc),
        Default::Nothing | Default::Text(_) => field.doc.to_owned(),
    };
    format!("{:COMMENT_COLUMN$}# {doc}", format!("{comment}{assignment}"))
}

/// Whether the default case spells the field out: it has a fixed default, and the default models
/// use it.
fn is_active(field: &Field) -> bool {
    let is_default = |(model, names): UsedWith| {
        let default = find(model).and_then(|model| model.default.text());
        default.is_some_and(|default| names.contains(&default))
    };
    let is_used = field.uses().count() == 0 || field.uses().any(is_default);
    let is_array = matches!(field.kind, Kind::Quantities(_) | Kind::Numbers);
    field.default.text().is_some() && is_used && !is_array
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Case, CaseFile, Folder, Overrides};

    fn read(text: &str) -> Result<Case, crate::CaseErrors> {
        CaseFile::from_str(text, "case.toml", Folder::new(""), Overrides::NONE)?
            .pose(&schlupf::unwatched)
    }

    #[test]
    fn it_is_a_case_without_notices() {
        let case = read(&template()).unwrap();
        assert_eq!(case.notices, []);
        assert_eq!(case.problem.kinematics.creepage_x, 0.008);
        assert_eq!(case.problem.kinematics.speed, 30.0);
    }

    /// Every line that is a comment may be made a field: it may contradict or need others, but it
    /// is neither unknown nor of a wrong kind.
    #[test]
    fn every_commented_field_can_be_switched_on() {
        let text = template();
        let fields = text.lines().filter(|line| line.starts_with("# ") && line.contains(" = "));
        let mut count = 0;
        for line in fields {
            let switched = text
                .replacen(line, &line[2..], 1)
                .replace("# [history]", "[history]")
                .replace("# [cooling]", "[cooling]")
                .replace("# [subsurface]", "[subsurface]")
                .replace("# [damage]", "[damage]")
                .replace("# [contact_law.roughness]", "[contact_law.roughness]")
                .replace("# [layer]", "[layer]")
                .replace("# [fastsim]", "[fastsim]")
                .replace("# [track]", "[track]")
                .replace("# [wheelset]", "[wheelset]");
            if let Err(errors) = read(&switched) {
                let message = errors.to_string();
                let allowed =
                    ["together with", "is missing", "readable file", "a history must have"];
                assert!(allowed.iter().any(|part| message.contains(part)), "{line}: {message}");
            }
            count += 1;
        }
        assert!(count > 15);
    }
}
