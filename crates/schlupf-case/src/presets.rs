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
    use schlupf::problem::{FastMethod, SlopeReduction};

    use super::*;
    use crate::{CaseFile, Folder, Overrides};

    /// The settings of a preset in a case of nothing else.
    fn case(group: &str, name: &str) -> CaseFile {
        let preset = presets().iter().find(|p| p.group == group && p.name == name).unwrap();
        let assignments = preset.assignments();
        let set = Overrides { option: "preset", assignments: &assignments };
        CaseFile::from_str("", name, Folder::new(""), set).unwrap()
    }

    /// Hou, Kalousek and Magel (1997), by way of the user guide for CONTACT: the limit of
    /// elasticity u_c0 (in mm) and τ_c0 (in MPa), and the slope k_u beyond (in MPa/mm), of which
    /// k_τ = k_u (G/h)/(G/h − k_u).
    #[test]
    fn hou_1997_layers() {
        for (name, elastic, stress, slope) in [
            ("magnetite", 0.070, 560.0, 0.0),
            ("clay", 0.040, 200.0, 400.0),
            ("sand", 0.050, 400.0, -200.0),
            ("molybdenum_disulphide", 0.020, 20.0, 20.0),
        ] {
            let case = case("layers", name).pose(&schlupf::unwatched).unwrap();
            let layer = case.problem.interface.layer.unwrap();
            let limit = layer.yield_limit().unwrap();
            let stiffness = stress / elastic;
            let near = |found: f64, expected: f64| {
                assert!((found - expected).abs() <= 3e-4 * expected.abs(), "{name}: {found}");
            };
            near(layer.compliance().recip(), 1e9 * stiffness);
            near(limit.stress, 1e6 * stress);
            near(limit.hardening, 1e9 * slope * stiffness / (stiffness - slope));
        }
    }

    #[test]
    fn the_locomotive_of_the_core_is_the_preset() {
        let case = case("methods", "eurosprinter").pose(&schlupf::unwatched).unwrap();
        let schlupf::Method::Fast(FastMethod::ModifiedFastsim(_, reduction)) = case.method else {
            panic!("{:?}", case.method)
        };
        assert_eq!(reduction, SlopeReduction::LOCOMOTIVE);
    }

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
