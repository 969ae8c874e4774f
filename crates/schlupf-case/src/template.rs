//! The commented case file of `schlupf init`, which is also the default case.

use std::collections::BTreeMap;

use crate::fields::{Field, Kind, SECTIONS, Section, UsedWith};
use crate::presets::Preset;

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
    write(HEAD, &Template::default())
}

/// The same with the fields of a preset that names its sections, such as a condition of the rail.
pub fn template_with(preset: &Preset) -> String {
    let Preset { name, doc, source, fields, .. } = preset;
    let head = format!("{}\n#\n# {name}: {doc}\n# ({source})\n\n", HEAD.trim_end());
    let given = fields.iter().map(|(path, literal)| (path.as_str(), literal.as_str())).collect();
    write(&head, &Template { given })
}

fn write(head: &str, template: &Template) -> String {
    let sections: Vec<String> = SECTIONS.iter().map(|section| template.section(section)).collect();
    format!("{head}{}", sections.join("\n"))
}

/// Fields that have other values than in the default case.
#[derive(Default)]
struct Template<'a> {
    /// Literals by dotted paths.
    given: BTreeMap<&'a str, &'a str>,
}

impl Template<'_> {
    fn section(&self, section: &Section) -> String {
        let mut lines = Vec::new();
        if !section.name.is_empty() {
            let is_active = section.fields.iter().any(|field| self.is_active(field));
            let comment = if is_active { "" } else { "# " };
            lines.push(format!("# {}", section.doc));
            lines.push(format!("{comment}[{}]", section.name));
        }
        for field in section.fields {
            lines.push(self.line(field));
            lines.extend(field.kind.choices().iter().map(|choice| {
                format!("{:COMMENT_COLUMN$}#   {:?}: {}", "", choice.name, choice.doc)
            }));
        }
        lines.join("\n") + "\n"
    }

    fn line(&self, field: &Field) -> String {
        let assignment = match self.given.get(&*field.path) {
            Some(literal) => format!("{} = {literal}", field.name()),
            None => field.assignment().unwrap_or_default(),
        };
        let comment = if self.is_active(field) { "" } else { "# " };
        let doc = match field.default.in_words() {
            Some(text) => format!("{}; default: {text}", field.doc),
            None => field.doc.to_owned(),
        };
        format!("{:COMMENT_COLUMN$}# {doc}", format!("{comment}{assignment}"))
    }

    /// Whether the case spells the field out: it is given, or it has a fixed default and the
    /// models of the case use it.
    fn is_active(&self, field: &Field) -> bool {
        let is_chosen = |(model, names): UsedWith| {
            let given = self.given.get(&*model).map(|literal| literal.trim_matches('"'));
            let chosen = given.or_else(|| model.field().default.text());
            chosen.is_some_and(|chosen| names.contains(&chosen))
        };
        let is_used = field.uses().count() == 0 || field.uses().any(is_chosen);
        let is_array = matches!(field.kind, Kind::Quantities(_) | Kind::Numbers);
        let is_default = field.default.text().is_some() && is_used && !is_array;
        is_default || self.given.contains_key(&*field.path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets::conditions;
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

    /// A condition makes the same case as its fields do, and its head says where they come from.
    #[test]
    fn conditions_are_cases_with_their_fields() {
        assert_eq!(conditions().count(), 5);
        for condition in conditions() {
            let text = template_with(condition);
            assert!(text.contains(&condition.source), "{text}");
            let case = read(&text).unwrap();
            assert_eq!(case.notices, [], "{}", condition.name);
            let assignments = condition.assignments();
            let set = Overrides { option: "preset", assignments: &assignments };
            let same = CaseFile::from_str("", "preset", Folder::new(""), set).unwrap();
            let same = same.pose(&schlupf::unwatched).unwrap();
            let of = |case: &Case| {
                format!("{:?} {:?}", case.problem.interface.friction, case.problem.interface.layer)
            };
            assert_eq!(of(&case), of(&same));
        }
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
                .replace("# [wheelset]", "[wheelset]")
                .replace("# [left_wheel]", "[left_wheel]")
                .replace("# [right_wheel]", "[right_wheel]")
                .replace("# [left_rail]", "[left_rail]")
                .replace("# [right_rail]", "[right_rail]");
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
