//! All cases of an input file.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::{CaseError, FieldPath, Place, Source};
use schlupf::reporting::Message;

use crate::import::Notice;
use crate::import::contact::given::At;
use crate::import::contact::input::{self, InputCase, Module};
use crate::import::document::Document;

use super::case::Translation;
use super::frame::WheelBody;
use super::sequence::{self, Job};
use super::{basic, wheel_history, wheel_rail};

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
    /// Numbers of its cases in the input file, from 1: one, or the steps of a history.
    pub numbers: Vec<usize>,
    /// Where the first of them begins.
    pub place: Place,
    /// Where the values of fields stand, by their paths in the case file.
    pub places: Vec<(FieldPath, Place)>,
    /// Name of the case file.
    pub name: String,
    /// Title of the case.
    pub title: String,
    /// Text of the case file.
    pub text: String,
    /// Files that the case names, beside profiles, by their names.
    pub files: Vec<(String, Vec<u8>)>,
    pub(crate) document: Document,
}

/// What became of an input file.
#[derive(Debug)]
pub struct Import {
    /// The cases that are available.
    pub cases: Vec<ImportedCase>,
    /// What is not available, and what is wrong, each once, in the order of the file.
    pub errors: Vec<CaseError>,
    /// What is left out without harm.
    pub notices: Vec<Message>,
    /// Numbers of the cases that are not available.
    pub refused: Vec<usize>,
    /// Numbers of the cases that the file itself skips.
    pub skipped: Vec<usize>,
}

/// Imports an input file.
pub fn import(source: &Arc<Source>, options: &Options) -> Import {
    let input = input::read(source);
    let jobs = sequence::jobs(&input.cases);
    let is_one = jobs.len() == 1 && input.stop.is_none();
    let mut import = Import {
        cases: Vec::new(),
        errors: Vec::new(),
        notices: left_out(&input.cases),
        refused: Vec::new(),
        skipped: Vec::new(),
    };
    let skipped = input.cases.iter().filter(|case| case.is_skipped);
    import.skipped.extend(skipped.map(|case| case.number));
    let mut told = Vec::new();
    for job in &jobs {
        let stem = if is_one {
            options.stem.clone()
        } else {
            format!("{}_{}", options.stem, job.first.number)
        };
        let translation = translate(source, job, options, &stem);
        if translation.errors.is_empty() {
            told.extend(translation.notices.iter().cloned());
            import.cases.push(complete(source, job, translation, &stem));
        } else {
            import.refused.extend(job.all().map(|case| case.number));
            import.errors.extend(translation.errors);
        }
    }
    import.notices.extend(once_each(&told));
    import.refused.sort_unstable();
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

/// Notices, each once, with the first line that it is about and the number of others.
fn once_each(told: &[(Notice, At)]) -> impl Iterator<Item = Message> {
    let mut kinds: Vec<(Message, BTreeSet<usize>)> = Vec::new();
    for (notice, at) in told {
        let message = Message::from(notice.clone());
        let is_same =
            |known: &Message| known.code == message.code && known.quantity == message.quantity;
        match kinds.iter_mut().find(|(known, _)| is_same(known)) {
            Some((_, lines)) => drop(lines.insert(at.line)),
            None => kinds.push((message, BTreeSet::from([at.line]))),
        }
    }
    kinds.into_iter().map(|(message, lines)| {
        let first = lines.first().copied().unwrap_or_default();
        let others = match lines.len() {
            1 => String::new(),
            count => format!(" and {} more", count - 1),
        };
        message.about(&format!("line {first}{others}"))
    })
}

/// What is left out of the cases, each once.
fn left_out(cases: &[InputCase]) -> Vec<Message> {
    if cases.is_empty() {
        return Vec::new();
    }
    let names = "G, I, A, O, W, MAXGS … EPS, DQ, FACPHI";
    let settings = Notice::SettingsLeftOut { names };
    let grid = cases.iter().find_map(|case| match &case.module {
        Module::WheelRail(of) => of.search.as_ref().map(|search| search.element),
        Module::Basic(_) => None,
    });
    let grid = grid.map(|size| Notice::GridLeftOut { size: size.map(|given| given.value) });
    std::iter::once(settings).chain(grid).map(Message::from).collect()
}

fn translate(source: &Arc<Source>, job: &Job, options: &Options, stem: &str) -> Translation {
    let control = &job.first.control;
    match &job.first.module {
        Module::WheelRail(of) => {
            let of = match job.steady().map(|steady| &steady.module) {
                Some(Module::WheelRail(steady)) => steady,
                _ => of,
            };
            let mut case = wheel_rail::translate(source, (control, of), &options.folder);
            wheel_history::write(&mut case, job);
            case
        }
        Module::Basic(_) if job.is_history() => {
            sequence::translate(source, job, options.wheel, stem)
        }
        Module::Basic(of) => basic::translate(source, (control, of), options.wheel, stem),
    }
}

fn complete(source: &Arc<Source>, job: &Job, translation: Translation, stem: &str) -> ImportedCase {
    let mut document = translation.document;
    let case = job.first;
    let numbers = match job.steps.last() {
        Some(last) => format!("Cases {} to {}", case.number, last.number),
        None => format!("Case {}", case.number),
    };
    let head = format!(
        "{numbers} of {}, line {}: input of CONTACT, module {}.",
        file_name(&source.name),
        case.at.line,
        case.module.number()
    );
    document.comments.insert(0, head);
    let fallback = || format!("{}, case {}", file_name(&source.name), case.number);
    document.title = case.title.clone().unwrap_or_else(fallback);
    let places = translation.places.iter().map(|(path, at)| (*path, at.place(source)));
    ImportedCase {
        numbers: job.all().map(|case| case.number).collect(),
        place: case.at.place(source),
        places: places.collect(),
        name: format!("{stem}.toml"),
        title: document.title.clone(),
        text: document.to_toml(),
        files: document.files.clone(),
        document,
    }
}

/// The last part of a path.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
