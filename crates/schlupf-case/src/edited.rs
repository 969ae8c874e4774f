//! A case file with other values, its comments and layout kept.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, TableLike, Value};

use crate::document::{Content, Entry, Origin};
use crate::error::CaseError;
use crate::fields::{self, Kind, readable};
use crate::place::{Place, Source};
use crate::{FieldPath, profiles};

/// A text that is being edited.
pub struct Edited {
    document: DocumentMut,
    name: String,
}

impl Edited {
    /// The text of a case file.
    pub fn new(source: &Source) -> Result<Self, CaseError> {
        let name = source.name.clone();
        let place = || Place::File { name: name.clone() };
        let document = source.text.parse();
        let document =
            document.map_err(|error| CaseError::new("", format!("not TOML: {error}"), place()))?;
        Ok(Self { document, name })
    }

    /// Makes the text give these entries and no others. `folder` is where relative paths start, if
    /// the text goes to another folder.
    pub fn take_over(
        &mut self,
        entries: &[Entry],
        folder: Option<&PathBuf>,
    ) -> Result<(), CaseError> {
        for field in fields::all() {
            let is_given = entries.iter().any(|entry| *entry.path == *field.path);
            if !is_given {
                self.remove(&field.path);
            }
        }
        for entry in entries {
            let is_path =
                fields::find(&entry.path).is_some_and(|field| matches!(field.kind, Kind::Path));
            match (&entry.value.content, folder) {
                (Content::Text(file), Some(folder)) if is_path && profiles::names_file(file) => {
                    let file = absolute(&folder.join(file)).into_os_string().into_string();
                    let file = file.map_err(|file| self.no_text(&entry.path, &file))?;
                    self.set(&entry.path, file.into())?;
                }
                (content, _) if matches!(entry.origin, Origin::Override { .. }) => {
                    self.set(&entry.path, value_of(content))?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn no_text(&self, field: &str, path: &OsStr) -> CaseError {
        let message = format!(
            "{field} must be a path in UTF-8 for a case in another folder, but is {}",
            path.display()
        );
        CaseError::new(field, message, Place::File { name: self.name.clone() })
    }

    /// Sets a field to a number in its SI unit, to six digits.
    pub fn set_number(&mut self, path: FieldPath, number: f64) -> Result<(), CaseError> {
        let text = readable(number);
        let unit = path.field().kind.unit();
        let value = if unit.is_empty() {
            text.parse::<f64>().unwrap_or(number).into()
        } else {
            format!("{text} {unit}").into()
        };
        self.set(&path, value)
    }

    /// The text.
    pub fn finish(self) -> String {
        self.document.to_string()
    }

    fn set(&mut self, path: &str, mut value: Value) -> Result<(), CaseError> {
        let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
        let mut table: &mut dyn TableLike = self.document.as_table_mut();
        for key in section.split('.').filter(|key| !key.is_empty()) {
            let item = table.entry(key).or_insert_with(|| {
                let mut table = Table::new();
                // One that only holds another has no line of its own.
                table.set_implicit(true);
                Item::Table(table)
            });
            if let Some(short) = item.as_value_mut().filter(|old| old.is_str() && name == "file") {
                // A file alone stands for the section that names it.
                *value.decor_mut() = short.decor().clone();
                *short = value;
                return Ok(());
            }
            if let Some(short) = item.as_value_mut().filter(|old| old.is_str()) {
                let file = std::mem::replace(short, Value::InlineTable(InlineTable::new()));
                if let Value::InlineTable(table) = short {
                    table.insert("file", file);
                }
            }
            table = item.as_table_like_mut().ok_or_else(|| {
                let place = Place::File { name: self.name.clone() };
                CaseError::new(path, format!("{section} is no section"), place)
            })?;
        }
        match table.get_mut(name).and_then(Item::as_value_mut) {
            Some(old) => {
                // Blanks before and a comment behind.
                *value.decor_mut() = old.decor().clone();
                *old = value;
            }
            None => {
                table.insert(name, Item::Value(value));
            }
        }
        Ok(())
    }

    /// Takes out a field, or a section with all of its fields.
    pub fn remove(&mut self, path: &str) {
        let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
        let mut table: &mut dyn TableLike = self.document.as_table_mut();
        for key in section.split('.').filter(|key| !key.is_empty()) {
            if name == "file" && table.get(key).is_some_and(Item::is_str) {
                table.remove(key);
                return;
            }
            let Some(inner) = table.get_mut(key).and_then(Item::as_table_like_mut) else { return };
            table = inner;
        }
        table.remove(name);
    }
}

fn value_of(content: &Content) -> Value {
    match content {
        Content::Text(text) => text.as_str().into(),
        Content::Integer(number) => (*number).into(),
        Content::Float(number) => (*number).into(),
        Content::Flag(flag) => (*flag).into(),
        Content::Array(entries) => {
            Value::Array(entries.iter().map(|entry| value_of(&entry.content)).collect::<Array>())
        }
        // No field takes it, so no case that was read has it.
        Content::Other(name) => (*name).into(),
    }
}

/// The path from the root, as far as it can be known.
pub fn absolute(path: &Path) -> PathBuf {
    let path = if path == Path::new("") { Path::new(".") } else { path };
    std::fs::canonicalize(path)
        .or_else(|_| std::path::absolute(path))
        .unwrap_or_else(|_| path.to_owned())
}

#[cfg(test)]
mod tests {
    use schlupf::unwatched;

    use crate::{Case, CaseFile, FieldPath, Folder, Overrides};
    use std::path::Path;

    fn read(text: &str, folder: &Path, overrides: &[String]) -> Case {
        let overrides = Overrides { option: "set", assignments: overrides };
        let file = CaseFile::from_str(text, "case.toml", Folder::new(folder), overrides).unwrap();
        file.pose(&unwatched).unwrap()
    }

    fn edited(text: &str, overrides: &[&str], values: &[(FieldPath, f64)], folder: &str) -> String {
        let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
        let case = read(text, Path::new("here"), &overrides);
        let text = case.edited(values, Path::new(folder)).unwrap();
        read(&text, Path::new(folder), &[]);
        text
    }

    #[test]
    fn comments_and_layout_stay() {
        let text = "# mine\ntitle = \"a\"\n\n[friction]   # law\ncoefficient  = 0.40  # guessed\n\n[grid]\ncells_x = 8\ncells_y = 9\n";
        let values = [
            (field!("friction.coefficient"), 0.330_236_480_8),
            (field!("friction.temperature_at_zero_friction"), 1853.087),
            (field!("contact_law.stiffness"), 4.871_234_5e6),
        ];
        assert_eq!(
            edited(text, &["grid.cells_x=10", "grid.cells_y="], &values, "here"),
            "# mine\ntitle = \"a\"\n\n[friction]   # law\ncoefficient  = 0.330236  # guessed\n\
             temperature_at_zero_friction = \"1853.09 K\"\n\n[grid]\ncells_x = 10\n\n\
             [contact_law]\nstiffness = \"4.87123e6 1/m\"\n"
        );
    }

    #[test]
    fn inline_tables_and_dotted_keys_are_edited_in_place() {
        let values = [(field!("friction.coefficient"), 0.3)];
        let text = "friction = { coefficient = 0.4 }\n";
        assert_eq!(edited(text, &[], &values, "here"), "friction = { coefficient = 0.3 }\n");
        let text = "friction.model = \"constant\"\n";
        let new = "friction.model = \"constant\"\nfriction.coefficient = 0.3\n";
        assert_eq!(edited(text, &[], &values, "here"), new);
    }

    /// A case has k_c or the roughness that it follows from, in whichever way that is written.
    #[test]
    fn a_stiffness_takes_the_place_of_a_roughness() {
        let new = "[contact_law]\nstiffness = \"4e6 1/m\"\n";
        for old in [
            "[contact_law]\nroughness = { rms_height = \"1 um\" }\n",
            "[contact_law]\nroughness.rms_height = \"1 um\"\n",
            "[contact_law.roughness]\nrms_height = \"1 um\"\n",
        ] {
            let text = edited(old, &[], &[(field!("contact_law.stiffness"), 4e6)], "here");
            assert_eq!(text.trim_start_matches('\n'), new, "{old}");
        }
    }

    /// A file alone stands for the section that names it, until there is more to say.
    #[test]
    fn the_short_form_of_a_section_grows() {
        let text = "[contact_law]\nroughness = \"line.csv\"\n[solver]\nmethod = \"polach\"\n";
        let grown = edited(text, &["contact_law.roughness.cells=64"], &[], "here");
        assert!(grown.contains("roughness = { file = \"line.csv\", cells = 64 }"), "{grown}");
        let overrides = ["contact_law.roughness.file=", "contact_law.stiffness=4e6 1/m"];
        let gone = edited(text, &overrides, &[], "here");
        assert!(!gone.contains("roughness") && gone.contains("4e6 1/m"), "{gone}");
    }

    #[test]
    fn fields_of_nested_sections_are_set_there() {
        let text = edited("", &["contact_law.roughness.rms_height=1 um"], &[], "here");
        assert_eq!(text.trim(), "[contact_law.roughness]\nrms_height = \"1 um\"");
        let text = "[contact_law]\nroughness = { rms_height = \"1 um\" }\n";
        let text = edited(text, &["contact_law.roughness.rms_height=2 um"], &[], "here");
        assert_eq!(text, "[contact_law]\nroughness = { rms_height = \"2 um\" }\n");
    }

    #[test]
    fn paths_lead_to_the_same_files_from_another_folder() {
        let folder = std::env::temp_dir();
        let text = "[friction]\nmodel = \"constant\"\nvariation_file = \"f.csv\"\n";
        let case = |text: &str, folder: &Path| read(text, folder, &[]);
        let place = folder.join(format!("schlupf-{}", std::process::id()));
        std::fs::create_dir(&place).unwrap();
        std::fs::write(place.join("f.csv"), "y [mm],factor\n-1,1\n1,1\n").unwrap();
        let read = case(text, &place);
        assert_eq!(read.edited(&[], &place).unwrap(), text);
        let moved = read.edited(&[], &folder).unwrap();
        case(&moved, &folder);
        let line = "x [um],height [um]\n0,0\n1,1\n2,0.5\n3,0.8\n";
        std::fs::write(place.join("line.csv"), line).unwrap();
        let short = "contact_law.roughness = \"line.csv\"\nsolver.method = \"polach\"\n";
        let moved = case(short, &place).edited(&[], &folder).unwrap();
        let line = super::absolute(&place.join("line.csv")).display().to_string();
        assert!(moved.starts_with(&format!("contact_law.roughness = {line:?}\n")), "{moved}");
        std::fs::remove_dir_all(&place).unwrap();
    }
}
