//! What tells a study from another one.

use std::collections::BTreeSet;
use std::path::PathBuf;

use schlupf_case::CaseFile;
use schlupf_case::fields::Kind;
use sha2::{Digest, Sha256};

use crate::study::chunks::FieldColumn;
use crate::study::design::{Design, Values, assignment};
use crate::study::error::StudyError;

/// Files that values of the design name, as far as they are there: a row without its file fails.
pub(crate) fn varied_files(case: &CaseFile, design: &Design) -> Vec<PathBuf> {
    let mut files = BTreeSet::new();
    for varied in design.varied().iter().filter(|varied| matches!(varied.field.kind, Kind::Path)) {
        let entries = (0..varied.values.len()).map(|k| varied.values.entry(k));
        let assignments: BTreeSet<String> =
            entries.map(|entry| assignment(varied.field, &entry)).collect();
        for assignment in assignments {
            let Ok(case) = case.with("a row", &[assignment]) else { continue };
            let named = case.files().into_iter().filter(|(field, _)| *field == varied.field.path);
            files.extend(named.map(|(_, path)| path).filter(|path| path.is_file()));
        }
    }
    files.into_iter().collect()
}

/// A sum over all that the table depends on.
pub(crate) fn digest(
    case: &str,
    design: &Design,
    (batch, fields): (usize, Option<&[&'static FieldColumn]>),
    inputs: &[PathBuf],
) -> Result<String, StudyError> {
    let mut sum = Sha256::new();
    let mut add = |bytes: &[u8]| {
        sum.update((bytes.len() as u64).to_le_bytes());
        sum.update(bytes);
    };
    add(env!("CARGO_PKG_VERSION").as_bytes());
    add(case.as_bytes());
    add(&batch.to_le_bytes());
    for varied in design.varied() {
        add(varied.field.path.as_bytes());
        match &varied.values {
            Values::Numbers(numbers) => {
                let bytes: Vec<u8> =
                    numbers.iter().flat_map(|n| n.to_bits().to_le_bytes()).collect();
                add(&bytes);
            }
            Values::Texts(texts) => texts.iter().for_each(|text| add(text.as_bytes())),
        }
    }
    for carried in design.carried() {
        add(carried.name.as_bytes());
    }
    add(&[u8::from(matches!(design, Design::Factorial(_)))]);
    for field in fields.into_iter().flatten() {
        add(field.name.as_bytes());
    }
    for path in inputs {
        add(&std::fs::read(path).map_err(|cause| StudyError::file(path, cause))?);
    }
    Ok(sum.finalize().iter().map(|byte| format!("{byte:02x}")).take(16).collect())
}
