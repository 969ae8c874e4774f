//! Several cases that differ in one field.

use std::path::PathBuf;
use std::sync::Arc;

use schlupf::Watch;
use schlupf::numerics::parallel;

use crate::case::Case;
use crate::case_file::CaseFile;
use crate::document;
use crate::error::{CaseError, CaseErrors};
use crate::fields::{self, FieldPath};
use crate::notice::Notice;
use crate::place::Place;
use crate::profiles;
use crate::range::even_values;
use schlupf::reporting::quoted;

/// A field and the values that it takes, one after the other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Family {
    /// Path of the field.
    pub field: FieldPath,
    /// Its values as text, without quotes.
    pub values: Vec<String>,
    shapes_contact: bool,
    is_path: bool,
    option: Arc<str>,
}

impl Family {
    /// Reads `section.field=value,value,…`, as `option` gives it. A comma within quotes or brackets
    /// does not separate values. A field that is a number may have a range instead, `START..END`
    /// with eleven values at even steps, or `START..END:COUNT`.
    pub fn parse(option: impl Into<Arc<str>>, text: &str) -> Result<Self, CaseError> {
        let option = option.into();
        let place = || Place::Override { option: Arc::clone(&option), text: text.to_owned() };
        let Some((path, values)) = text.split_once('=') else {
            let message = format!(
                "{option} must be of the form section.field=value,value,…, but is {}",
                quoted(text)
            );
            return Err(CaseError::new("", message, place()));
        };
        let path = path.trim();
        let field = fields::named(path, place)?;
        let refused = |reason: String| Err(CaseError::new(path, reason, place()));
        let is_number = matches!(field.kind, fields::Kind::Quantity(_) | fields::Kind::Number);
        let values: Vec<String> = if is_number && values.contains("..") {
            even_values(&option, field, &document::without_quotes(values.trim()))?
        } else if let Some(values) = split(values) {
            values.into_iter().map(document::without_quotes).collect()
        } else {
            return refused(format!("the values of {path} must have closed quotes and brackets"));
        };
        if values.iter().any(String::is_empty) {
            return refused(format!("every value of {path} must be given, but one is empty"));
        }
        let is_repeated = |(k, value): &(usize, &String)| values[..*k].contains(value);
        if let Some((_, value)) = values.iter().enumerate().find(is_repeated) {
            return refused(format!(
                "the values of {path} must differ, but {} is repeated",
                quoted(value)
            ));
        }
        let is_path = matches!(field.kind, fields::Kind::Path);
        let shapes_contact = field.shapes_contact;
        Ok(Self { field: field.path, values, shapes_contact, is_path, option })
    }

    /// Files that its values name for a case.
    pub fn files(&self, case: &CaseFile) -> Vec<PathBuf> {
        let named = self.values.iter().filter(|file| self.is_path && profiles::names_file(file));
        named.map(|file| case.files.locate(file)).collect()
    }

    /// The case with each of the values, or what is wrong with any of them; where all are right,
    /// the first that cannot be posed.
    ///
    /// ```
    /// use schlupf::unwatched;
    /// use schlupf_case::{CaseFile, Family, Folder, Overrides};
    ///
    /// let file = CaseFile::from_str("", "a case", Folder::new(""), Overrides::NONE)?;
    /// let case = file.pose(&unwatched)?;
    /// let speeds = Family::parse("--over", "kinematics.speed=10 m/s,20 m/s")?;
    /// let speeds = speeds.members(&case, &unwatched)?;
    /// assert_eq!(speeds[1].problem.kinematics.speed, 20.0);
    /// # Ok::<(), schlupf_case::CaseErrors>(())
    /// ```
    pub fn members(&self, case: &Case, watch: Watch) -> Result<Vec<Case>, CaseErrors> {
        let files = self.case_files(&case.file)?;
        parallel::try_map(files, |file| {
            let mut member = file.pose_like(case.micro_contact(), watch)?;
            // All contacts of a wheel belong together.
            if !self.shapes_contact && case.wheel.is_none() {
                // The same, and so a solver can tell.
                member.problem.normal = Arc::clone(&case.problem.normal);
                member.problem.interface.elasticity =
                    Arc::clone(&case.problem.interface.elasticity);
            }
            Ok(member)
        })
    }

    /// The case file with each of the values.
    fn case_files(&self, case: &CaseFile) -> Result<Vec<CaseFile>, CaseErrors> {
        let with = |value: &String| case.with(Arc::clone(&self.option), &[self.assignment(value)]);
        let files = all_or_errors(self.values.iter().map(with).collect())?;
        self.check_effect(&files)?;
        for (k, (file, value)) in files.iter().zip(&self.values).enumerate() {
            let mut earlier = files[..k].iter().zip(&self.values);
            let same =
                earlier.find(|(earlier, _)| earlier.settings.agrees(&file.settings, self.field));
            if let Some((_, same)) = same {
                let reason = format!(
                    "the values of {} must differ, but {} and {} are equal",
                    self.field,
                    quoted(same),
                    quoted(value)
                );
                return Err(self.refused(value, reason).into());
            }
        }
        Ok(files)
    }

    /// Refuses a field that none of the cases uses.
    fn check_effect(&self, files: &[CaseFile]) -> Result<(), CaseErrors> {
        let idle = |file: &CaseFile| {
            let mut idle = file.settings.idle().into_iter();
            idle.find_map(|notice| match notice {
                Notice::NoEffect { field, because, .. } if field == self.field => Some(because),
                _ => None,
            })
        };
        let reasons: Vec<String> = files.iter().map_while(idle).collect();
        match (reasons.first(), self.values.first()) {
            (Some(because), Some(value)) if reasons.len() == files.len() => {
                let field = self.field;
                let reason =
                    format!("{field} must have an effect to be varied, but has none {because}");
                Err(self.refused(value, reason).into())
            }
            _ => Ok(()),
        }
    }

    fn assignment(&self, value: &str) -> String {
        format!("{}={value}", self.field)
    }

    fn refused(&self, value: &str, reason: String) -> CaseError {
        let (option, text) = (Arc::clone(&self.option), self.assignment(value));
        CaseError::new(self.field, reason, Place::Override { option, text })
    }
}

/// All results, or all errors.
fn all_or_errors<R>(results: Vec<Result<R, CaseErrors>>) -> Result<Vec<R>, CaseErrors> {
    let mut found = Vec::new();
    let mut errors = Vec::new();
    for result in results {
        match result {
            Ok(result) => found.push(result),
            Err(wrong) => errors.extend(wrong.iter().cloned()),
        }
    }
    CaseErrors::check(errors)?;
    Ok(found)
}

/// The parts of a text between its commas; `None` where quotes or brackets are not closed.
fn split(text: &str) -> Option<Vec<&str>> {
    let mut parts = Vec::new();
    let mut start = 0;
    let mut depth = 0_usize;
    let mut quote = None;
    for (at, character) in text.char_indices() {
        if let Some(open) = quote {
            quote = Some(open).filter(|open| *open != character);
            continue;
        }
        match character {
            '"' | '\'' => quote = Some(character),
            '[' | '(' | '{' => depth += 1,
            ']' | ')' | '}' => depth = depth.checked_sub(1)?,
            ',' if depth == 0 => {
                parts.push(text[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(text[start..].trim());
    (depth == 0 && quote.is_none()).then_some(parts)
}

#[cfg(test)]
mod tests {
    use schlupf::unwatched;

    use super::*;
    use crate::case_file::{CaseFile, Overrides};
    use crate::files::Folder;

    fn values(text: &str) -> Vec<String> {
        Family::parse("--over", text).unwrap().values
    }

    fn message(text: &str) -> String {
        Family::parse("--over", text).unwrap_err().to_string()
    }

    #[test]
    fn commas_separate_values_outside_quotes_and_brackets() {
        assert_eq!(values("kinematics.speed=10 m/s, 20 m/s"), ["10 m/s", "20 m/s"]);
        assert_eq!(values("normal.file=\"a,b.csv\",'c.csv'"), ["a,b.csv", "c.csv"]);
        assert_eq!(values("wheel.conductivity=50 W/(m K)"), ["50 W/(m K)"]);
        assert_eq!(values("friction.coefficient=0.1,0.2,0.3").len(), 3);
        assert_eq!(split("[1,2],[3]").unwrap(), ["[1,2]", "[3]"]);
    }

    #[test]
    fn a_range_has_values_at_even_steps_in_its_own_unit() {
        let eleven = values("kinematics.speed=10..20 m/s");
        assert_eq!((eleven.len(), &*eleven[0], &*eleven[10]), (11, "10 m/s", "20 m/s"));
        let loads = values("normal.load=60 kN..80 kN:3");
        assert_eq!(loads, ["60 kN", "70 kN", "80 kN"]);
        assert_eq!(values("normal.load=\"500 N..1 kN:2\""), ["500 N", "1000 N"]);
        assert_eq!(values("friction.coefficient=0.3..0.1:4")[1], "0.233333333");
        assert_eq!(values("normal.file=../a.csv,../b.csv").len(), 2);
        assert!(message("kinematics.speed=1..20").contains("the unit is missing"));
        assert!(
            message("kinematics.speed=1..2 m/s:1").contains("between 2 and 1000, but is \"1\"")
        );
        assert!(message("kinematics.speed=..2 m/s").contains("must be a range, such as "));
        assert!(message("kinematics.speed=2..2 m/s").contains("differ from its start"));
    }

    #[test]
    fn what_is_no_family_is_refused_with_its_value() {
        assert!(message("kinematics.speed").contains("section.field=value,value,…, but is"));
        assert!(message("kinematics.sped=1 m/s").contains("did you mean `kinematics.speed`?"));
        assert!(message("kinematics.speed=1 m/s,,2 m/s").contains("one is empty"));
        assert!(message("kinematics.speed=").contains("one is empty"));
        assert!(message("kinematics.speed=1 m/s,1 m/s").contains("\"1 m/s\" is repeated"));
        assert!(message("normal.file=\"a,b").contains("closed quotes"));
        assert!(message("normal.load=1 kN),2 kN").contains("closed quotes and brackets"));
    }

    #[test]
    fn every_member_is_read_as_a_case_and_every_error_is_reported() {
        let case = CaseFile::from_str("", "case.toml", Folder::new(""), Overrides::NONE).unwrap();
        let case = case.pose(&unwatched).unwrap();
        let of = |text| Family::parse("--over", text).unwrap().members(&case, &unwatched);
        let members = of("normal.load=60 kN,80 kN").unwrap();
        let loads: Vec<f64> = members
            .iter()
            .map(|member| member.problem.normal.normal_contact(None).unwrap().summary.load)
            .collect();
        assert_eq!(loads, [60e3, 80e3]);
        let errors = of("normal.load=60 kN,80 m,-1 kN").unwrap_err().to_string();
        assert!(
            errors.contains("--over normal.load=80 m: normal.load must be a force"),
            "{errors}"
        );
        assert!(errors.contains("--over normal.load=-1 kN: "), "{errors}");
        assert_eq!(errors.lines().count(), 2);
    }

    /// Curves that would be the same are none of a family.
    #[test]
    fn values_without_effect_or_equal_ones_are_refused() {
        let case = CaseFile::from_str("", "case.toml", Folder::new(""), Overrides::NONE).unwrap();
        let case = case.pose(&unwatched).unwrap();
        let refused = |text| {
            let family = Family::parse(String::from("over"), text).unwrap();
            family.members(&case, &unwatched).unwrap_err().to_string()
        };
        let equal = refused("normal.load=80 kN,60 kN,80000 N");
        assert!(equal.contains("but \"80 kN\" and \"80000 N\" are equal"), "{equal}");
        let idle = refused("normal.semi_axis_x=5 mm,6 mm");
        let expected = "over normal.semi_axis_x=5 mm: normal.semi_axis_x must have an effect to be \
                        varied, but has none with normal.model = \"hertz\"";
        assert!(idle.starts_with(expected), "{idle}");
    }
}
