//! The fields of a case file: one table from which reading, the check for unknown fields, the JSON
//! schema and the commented case file of `schlupf init` follow.

mod alternatives;
mod field;
mod suggestion;
mod table;

pub use alternatives::{
    ALTERNATIVES, Alternatives, MICRO_MODEL, OF_FILE, ROUGHNESS, STIFFNESSES, companion, related,
};
pub use field::{Choice, Default, Field, Kind, Section, UsedWith};
pub use schlupf::requirement::{Requirement, readable};
pub use suggestion::{NOT_PER_CENT, closest, closest_path, creepage_in_per_cent, is_per_cent};
pub use table::SECTIONS;

/// All fields, in the order of the case file.
pub fn all() -> impl Iterator<Item = &'static Field> {
    SECTIONS.iter().flat_map(|section| section.fields)
}

/// The field with a dotted path.
pub fn find(path: &str) -> Option<&'static Field> {
    all().find(|field| field.path == path)
}

/// The section with a name; the name of the top level is empty.
pub fn section(name: &str) -> Option<&'static Section> {
    SECTIONS.iter().find(|section| section.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_default_and_example_is_legal() {
        for field in all() {
            let texts = [field.default.text(), field.example].into_iter().flatten();
            for text in texts.filter(|text| !text.starts_with('[')) {
                assert!(field.read(&field.value_of(text)).is_ok(), "{}: {text}", field.path);
            }
        }
    }

    #[test]
    fn every_reference_to_a_field_or_choice_exists() {
        for field in all() {
            if let Default::Same(path) = field.default {
                assert!(find(path).is_some(), "{path}");
            }
            for (path, names) in field.uses() {
                let choices = find(path).unwrap().kind.choices();
                for name in names {
                    assert!(choices.iter().any(|choice| choice.name == *name), "{path} = {name}");
                }
            }
        }
        for alternatives in ALTERNATIVES {
            for path in alternatives.first.iter().chain(alternatives.second) {
                assert!(find(path).is_some(), "{path}");
            }
        }
    }

    #[test]
    fn every_path_is_unique_and_in_its_section() {
        let mut paths: Vec<_> = all().map(|field| field.path).collect();
        for section in SECTIONS {
            for field in section.fields {
                assert_eq!(field.section(), section.name);
            }
        }
        let count = paths.len();
        paths.sort_unstable();
        paths.dedup();
        assert_eq!(paths.len(), count);
    }
}
