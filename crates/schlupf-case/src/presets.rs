//! Constants to start with, each with its source.

use std::sync::LazyLock;

use toml::{Table, Value};

/// Constants of a material, a roughness, friction or a method.
#[derive(Debug, Clone, PartialEq)]
pub struct Preset {
    /// `materials`, `roughnesses`, `friction`, `layers`, `methods` or `conditions`.
    pub group: String,
    /// Its name within the group.
    pub name: String,
    /// What it is.
    pub doc: String,
    /// Where its numbers come from.
    pub source: String,
    /// Fields with their values as TOML: within the section of the group, those of methods and
    /// conditions by their dotted paths.
    pub fields: Vec<(String, String)>,
}

impl Preset {
    /// The section that its fields belong to; a material may belong to the rail instead.
    pub fn section(&self) -> &'static str {
        match self.group.as_str() {
            "materials" => "wheel",
            "roughnesses" => "contact_law.roughness",
            "friction" => "friction",
            "layers" => "layer",
            _ => "",
        }
    }

    /// Its fields as assignments `section.field=value`.
    ///
    /// ```
    /// use schlupf_case::presets;
    ///
    /// let wet = presets().iter().find(|preset| preset.name == "polach_wet").unwrap();
    /// assert!(wet.assignments().contains(&"friction.coefficient=0.3".to_owned()));
    /// assert!(wet.source.contains("Polach"));
    /// ```
    pub fn assignments(&self) -> Vec<String> {
        let section = self.section();
        let prefix = if section.is_empty() { String::new() } else { format!("{section}.") };
        self.fields.iter().map(|(field, value)| format!("{prefix}{field}={value}")).collect()
    }
}

/// The conditions of rails, by name: friction, and what else they change, for a first guess.
pub fn conditions() -> impl Iterator<Item = &'static Preset> {
    presets().iter().filter(|preset| preset.group == "conditions")
}

/// All of them, by group.
pub fn presets() -> &'static [Preset] {
    static PRESETS: LazyLock<Vec<Preset>> = LazyLock::new(read);
    &PRESETS
}

fn read() -> Vec<Preset> {
    let groups: Table = toml::from_str(include_str!("presets.toml")).unwrap_or_default();
    let of_group = |(group, presets): (String, Value)| {
        let presets = presets.as_table().cloned().unwrap_or_default();
        presets.into_iter().map(move |(name, entry)| preset(&group, name, &entry))
    };
    groups.into_iter().flat_map(of_group).collect()
}

fn preset(group: &str, name: String, entry: &Value) -> Preset {
    let text = |key| entry.get(key).and_then(Value::as_str).unwrap_or_default().to_owned();
    let mut fields = Vec::new();
    if let Some(table) = entry.get("fields").and_then(Value::as_table) {
        flatten("", table, &mut fields);
    }
    Preset { group: group.to_owned(), name, doc: text("doc"), source: text("source"), fields }
}

/// The fields of nested tables by their dotted paths.
fn flatten(parent: &str, table: &Table, fields: &mut Vec<(String, String)>) {
    for (name, value) in table {
        let path = if parent.is_empty() { name.clone() } else { format!("{parent}.{name}") };
        match value {
            Value::Table(table) => flatten(&path, table, fields),
            value => fields.push((path, value.to_string())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CaseFile, Folder, Overrides};

    #[test]
    fn every_preset_makes_a_case_without_notices() {
        assert!(presets().len() > 8);
        for preset in presets() {
            let Preset { name, doc, source, fields, .. } = preset;
            assert!(![name, doc, source].iter().any(|text| text.is_empty()), "{preset:?}");
            assert!(!fields.is_empty(), "{name}");
            let assignments = preset.assignments();
            let set = Overrides { option: "preset", assignments: &assignments };
            let file = CaseFile::from_str("", name, Folder::new(""), set).unwrap();
            assert_eq!(file.given().count(), fields.len(), "{name}");
            assert_eq!(file.notices(), [], "{name}");
        }
    }
}
