//! The fields of a case file: one table from which reading, the check for unknown fields, the JSON
//! schema and the commented case file of `schlupf init` follow.
//!
//! A field that takes one of several names has an enum (`choice`), which readers match
//! exhaustively: a new choice that is not read does not compile. The attribute `shapes_contact`
//! marks the fields that shape the contact; members of a family share the contact if none of those
//! changes.

#[macro_use]
mod path;
mod alternatives;
pub mod choice;
mod field;
mod suggestion;
mod table;

use crate::error::CaseError;
use crate::place::Place;
use schlupf::numerics::parallel;
use schlupf::reporting::shortened;

pub use alternatives::{
    ALTERNATIVES, Alternatives, HISTORY, MICRO_MODEL, OF_FILE, ROUGHNESS, STIFFNESSES, companions,
    related,
};
pub use choice::{Choice, Choose};
pub use field::{Allowed, Default, Field, Kind, Section, UsedWith};
pub use path::FieldPath;
pub use schlupf::reporting::{Requirement, readable};
pub use suggestion::{NOT_PER_CENT, closest, creepage_in_per_cent, is_per_cent};
use table::PATHS;
pub use table::SECTIONS;

/// All fields, in the order of the case file.
pub fn all() -> impl Iterator<Item = &'static Field> {
    SECTIONS.iter().flat_map(|section| section.fields)
}

/// The field with a dotted path that a user gives.
pub fn find(path: &str) -> Option<&'static Field> {
    all().find(|field| &*field.path == path)
}

/// The field with a dotted path that a user gives at a place.
///
/// # Errors
/// A path of no field, with the one that was probably meant.
pub fn named(path: &str, place: impl FnOnce() -> Place) -> Result<&'static Field, CaseError> {
    find(path).ok_or_else(|| {
        let (of, _) = path.rsplit_once('.').unwrap_or_default();
        let help = match (closest_path(path), section(of)) {
            (Some(meant), _) => format!("did you mean `{meant}`?"),
            (None, Some(section)) if !section.name.is_empty() => {
                let names: Vec<_> = section.fields.iter().map(Field::name).collect();
                format!("the fields of [{}] are {}", section.name, names.join(", "))
            }
            _ => "`schlupf init -` shows all fields".to_owned(),
        };
        CaseError::new(path, format!("unknown field `{}`", shortened(path)), place()).help(help)
    })
}

impl FieldPath {
    /// That of a literal.
    ///
    /// # Panics
    /// No field has this path.
    #[doc(hidden)]
    #[expect(clippy::panic, reason = "only when it is compiled: see the macro")]
    pub const fn known(path: &str) -> Self {
        let mut section = 0;
        while section < PATHS.len() {
            let mut place = 0;
            while place < PATHS[section].len() {
                if is_same(PATHS[section][place].as_bytes(), path.as_bytes()) {
                    return Self { section: section as u8, place: place as u8 };
                }
                place += 1;
            }
            section += 1;
        }
        panic!("no field of the case file has this path");
    }

    /// The field.
    pub fn field(self) -> &'static Field {
        &SECTIONS[usize::from(self.section)].fields[usize::from(self.place)]
    }

    /// Name of the section it stands in; empty for the top level.
    pub fn section(self) -> &'static str {
        SECTIONS[usize::from(self.section)].name
    }

    /// Last part of the path.
    pub fn name(self) -> &'static str {
        self.as_str().rsplit('.').next().unwrap_or_default()
    }

    /// The path as text.
    pub const fn as_str(self) -> &'static str {
        PATHS[self.section as usize][self.place as usize]
    }
}

/// Compares from the end, where paths of one length differ.
const fn is_same(one: &[u8], other: &[u8]) -> bool {
    let mut left = one.len();
    if left != other.len() {
        return false;
    }
    while left > 0 {
        left -= 1;
        if one[left] != other[left] {
            return false;
        }
    }
    true
}

/// The section with a name; the name of the top level is empty.
pub fn section(name: &str) -> Option<&'static Section> {
    SECTIONS.iter().find(|section| section.name == name)
}

/// Values that a thread looks at in turn.
const PART: usize = 65536;

/// Which of some values of a field (in SI units) is farthest from what it is in almost all cases,
/// and how many are beyond that, if there are any.
pub fn unusual(field: &Field, values: &[f64]) -> Option<(usize, usize)> {
    let usual = field.usual?;
    let has_some = |part: &[f64]| part.iter().any(|value| !usual.holds(*value));
    let parts = parallel::map(values.chunks(PART).collect(), has_some);
    if !parts.contains(&true) {
        return None;
    }
    let beyond = || (0..values.len()).filter(|place| !usual.holds(values[*place]));
    let remoteness = |place: &usize| usual.remoteness(values[*place]);
    let farthest = beyond().max_by(|one, other| remoteness(one).total_cmp(&remoteness(other)));
    farthest.map(|place| (place, beyond().count()))
}

/// The dotted path that was probably meant: a field of the same section with a similar name, or a
/// field of the same name in another section.
pub fn closest_path(path: &str) -> Option<FieldPath> {
    let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
    let in_section = || all().filter(|field| field.section() == section);
    if let Some(neighbour) = closest(name, in_section().map(Field::name)) {
        return in_section().find(|field| field.name() == neighbour).map(|field| field.path);
    }
    let namesakes = || all().filter(|field| field.name() == name).map(|field| field.path);
    let meant = closest(path, namesakes().map(FieldPath::as_str));
    namesakes().find(|path| meant.is_none_or(|meant| meant == &**path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setting::Setting;

    #[test]
    fn every_default_and_example_is_legal() {
        for field in all() {
            let texts = [field.default.text(), field.example].into_iter().flatten();
            for text in texts.filter(|text| !text.starts_with('[')) {
                assert!(field.read(&field.value_of(text)).is_ok(), "{}: {text}", field.path);
            }
        }
    }

    /// What is usual comprises the defaults and the examples, and is allowed.
    #[test]
    fn every_default_and_example_is_usual() {
        let mut count = 0;
        for field in all() {
            let Some(usual) = field.usual else { continue };
            count += 1;
            for (bound, _) in usual.bounds().into_iter().flatten() {
                let is_allowed = [0.999, 1.001].map(|near| field.requirement.holds(bound * near));
                assert!(is_allowed.contains(&true), "{}: {bound}", field.path);
            }
            let texts = [field.default.text(), field.example].into_iter().flatten();
            for text in texts.filter(|text| !text.starts_with('[')) {
                let values = match field.read(&field.value_of(text)) {
                    Ok(Setting::Number(number)) => [number],
                    other => panic!("{}: {other:?}", field.path),
                };
                assert_eq!(unusual(field, &values), None, "{}: {text}", field.path);
            }
        }
        assert!(count > 50, "{count}");
    }

    #[test]
    fn every_reference_to_a_choice_exists() {
        for field in all() {
            for (path, names) in field.uses() {
                let choices = path.field().kind.choices();
                for name in names {
                    assert!(choices.iter().any(|choice| choice.name == *name), "{path} = {name}");
                }
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

    #[test]
    fn misspelt_and_misplaced_fields_are_recognised() {
        assert_eq!(closest_path("kinematics.creepage"), Some(field!("kinematics.creepage_x")));
        assert_eq!(closest_path("kinematics.sped"), Some(field!("kinematics.speed")));
        assert_eq!(closest_path("kinematics.load"), Some(field!("normal.load")));
        assert_eq!(closest_path("load"), Some(field!("normal.load")));
        assert_eq!(closest_path("wheel.youngs_modulus"), Some(field!("wheel.young_modulus")));
        assert_eq!(closest_path("friction.mu"), None);
        assert_eq!(closest_path("grid.cell_x"), Some(field!("grid.cells_x")));
        assert_eq!(closest_path("contactlaw.stiffness"), Some(field!("contact_law.stiffness")));
    }
}
