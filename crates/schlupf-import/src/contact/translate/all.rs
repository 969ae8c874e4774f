//! All cases of an input file.

use std::sync::Arc;

use schlupf_case::{CaseError, Source};

use crate::contact::input::{self, InputCase, Module};

use super::case::Translation;
use super::frame::WheelBody;
use super::{basic, wheel_rail};

/// How an input file is imported.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// What the names of the case files begin with.
    pub stem: String,
    /// What stands before the relative paths of profiles: empty, or a folder with its slash.
    pub folder: String,
    /// Which body of module 3 is the wheel.
    pub wheel: WheelBody,
}

/// A case file.
#[derive(Debug, Clone)]
pub struct ImportedCase {
    /// Number of the case in the input file, from 1.
    pub number: usize,
    /// Its first line there.
    pub line: usize,
    /// Name of the case file.
    pub name: String,
    /// Title of the case.
    pub title: String,
    /// Text of the case file.
    pub text: String,
    /// Files that the case names, beside profiles, by their names.
    pub files: Vec<(String, Vec<u8>)>,
}

/// What became of an input file.
#[derive(Debug)]
pub struct Import {
    /// The cases that are available.
    pub cases: Vec<ImportedCase>,
    /// What is not available, and what is wrong, each once, in the order of the file.
    pub errors: Vec<CaseError>,
    /// Numbers of the cases that are not available.
    pub refused: Vec<usize>,
    /// Numbers of the cases that the file itself skips.
    pub skipped: Vec<usize>,
}

/// Imports an input file.
pub fn import(source: &Arc<Source>, options: &Options) -> Import {
    let input = input::read(source);
    let is_one = input.cases.len() == 1 && input.stop.is_none();
    let mut import =
        Import { cases: Vec::new(), errors: Vec::new(), refused: Vec::new(), skipped: Vec::new() };
    for case in &input.cases {
        if case.is_skipped {
            import.skipped.push(case.number);
            continue;
        }
        let stem =
            if is_one { options.stem.clone() } else { format!("{}_{}", options.stem, case.number) };
        let translation = translate(source, case, options, &stem);
        if translation.errors.is_empty() {
            import.cases.push(complete(source, case, translation, &stem));
        } else {
            import.refused.push(case.number);
            import.errors.extend(translation.errors);
        }
    }
    import.errors.extend(input.stop);
    import.errors.sort_by_key(|error| error.place.order());
    // What a case keeps is refused with every case that keeps it.
    let mut known: Vec<CaseError> = Vec::new();
    import.errors.retain(|error| {
        // Errors of one line stand together.
        let mut of_line = known.iter().rev().take_while(|known| known.place == error.place);
        let is_new = !of_line.any(|known| known == error);
        if is_new {
            known.push(error.clone());
        }
        is_new
    });
    import
}

fn translate(source: &Arc<Source>, case: &InputCase, options: &Options, stem: &str) -> Translation {
    match &case.module {
        Module::WheelRail(of) => {
            wheel_rail::translate(source, (&case.control, of), &options.folder)
        }
        Module::Basic(of) => basic::translate(source, (&case.control, of), options.wheel, stem),
    }
}

fn complete(
    source: &Arc<Source>,
    case: &InputCase,
    translation: Translation,
    stem: &str,
) -> ImportedCase {
    let mut document = translation.document;
    let module = match case.module {
        Module::WheelRail(_) => 1,
        Module::Basic(_) => 3,
    };
    let head = format!(
        "Case {} of {}, line {}: input of CONTACT, module {module}.",
        case.number,
        file_name(&source.name),
        case.line
    );
    document.comments.insert(0, head);
    let fallback = || format!("{}, case {}", file_name(&source.name), case.number);
    document.title = case.title.clone().unwrap_or_else(fallback);
    ImportedCase {
        number: case.number,
        line: case.line,
        name: format!("{stem}.toml"),
        title: document.title.clone(),
        text: document.to_toml(),
        files: document.files,
    }
}

/// The last part of a path.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
