//! Runs a study: batches on all threads, each kept as soon as it is done, then the table.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use schlupf::progress::{Progress, Stage};
use schlupf::{Watch, parallel};

use crate::batch;
use crate::error::StudyError;
use crate::parts::{Parts, sync};
use crate::study::Study;
use crate::table::{Cells, Contents, Format, Reader, Rows, Writer};

/// What a run has done.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Report {
    /// Rows of the table.
    pub rows: usize,
    /// Rows that an earlier run had solved already.
    pub resumed: usize,
    /// Rows whose solution has not converged.
    pub not_converged: usize,
    /// Rows that could not be solved.
    pub failed: usize,
    /// The first row that failed, and why.
    pub first_failure: Option<(usize, String)>,
}

/// Solves the rows of a study, or of its share `[i, n]` from `[1, n]` to `[n, n]`, and writes their
/// table.
///
/// Batches that an earlier run of the same study has kept are not solved again. The table is the
/// same, byte for byte, on any number of threads and after any number of runs that ended early.
///
/// # Errors
/// A study that has no case in any row, files that cannot be written, a file or batches of another
/// study in their place, and [`StudyError::Stopped`]. What is done is kept.
pub fn run(
    study: &Study,
    shard: [usize; 2],
    output: &Path,
    watch: Watch,
) -> Result<Report, StudyError> {
    let format = Format::of(output)?;
    let contents = study.contents(shard);
    if output.exists() {
        return existing(output, &contents);
    }
    let parts = Parts::of(output, &contents)?;
    let (done, left): (Vec<usize>, Vec<usize>) =
        contents.own_batches().partition(|batch| parts.has(*batch));
    let rows_of = |batches: &[usize]| batches.iter().map(|b| contents.rows_of(*b).len()).sum();
    let (resumed, rest): (usize, usize) = (rows_of(&done), rows_of(&left));
    let (solved, total) = (AtomicUsize::new(0), resumed + rest);
    let tell = |done: usize| {
        let progress = Progress::count(Stage::Study, 0).of(resumed + done, total);
        if watch(progress).is_break() { Err(StudyError::Stopped) } else { Ok(()) }
    };
    tell(0)?;
    parallel::try_map(left, |batch| {
        // Progress is that of the study, but whoever watches may stop each solution.
        let within = |_| {
            watch(
                Progress::count(Stage::Study, 0)
                    .of(resumed + solved.load(Ordering::Relaxed), total),
            )
        };
        let rows = batch::solve(study, &contents, batch, &within)?;
        parts.keep(batch, &rows)?;
        let count = contents.rows_of(batch).len();
        tell(solved.fetch_add(count, Ordering::Relaxed) + count)
    })?;
    let mut report = Report { resumed, ..Report::default() };
    assemble(output, format, &contents, &mut |batch| {
        let rows = parts.rows(batch, &contents)?;
        report.add(&contents, &rows);
        Ok(rows)
    })?;
    parts.remove();
    Ok(report)
}

/// A table that is there already.
fn existing(output: &Path, contents: &Contents) -> Result<Report, StudyError> {
    let mut reader = Reader::open(output)?;
    if reader.contents() != contents {
        let reason = "it is the table of another study or shard: remove it, or name another output";
        return Err(StudyError::table(output, reason));
    }
    let mut report = Report::default();
    while let Some(rows) = reader.next_batch()? {
        report.add(contents, &rows);
    }
    report.resumed = report.rows;
    Ok(report)
}

/// Writes a table of the batches of its share: all of it, or nothing.
pub(crate) fn assemble(
    output: &Path,
    format: Format,
    contents: &Contents,
    rows_of: &mut dyn FnMut(usize) -> Result<Rows, StudyError>,
) -> Result<(), StudyError> {
    let folder = output.parent().unwrap_or(Path::new(""));
    let folder = if folder == Path::new("") { Path::new(".") } else { folder };
    let unfinished = tempfile::Builder::new().prefix(".schlupf-").tempfile_in(folder);
    let unfinished: tempfile::TempPath =
        unfinished.map_err(|cause| StudyError::file(output, cause))?.into_temp_path();
    let path: PathBuf = unfinished.to_path_buf();
    let mut writer = Writer::create(&path, format, contents)?;
    for batch in contents.own_batches() {
        writer.append(&rows_of(batch)?)?;
    }
    writer.finish()?;
    #[cfg(unix)]
    {
        // As any other new file, not readable by its owner alone.
        use std::os::unix::fs::PermissionsExt;
        let _ = std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o644));
    }
    unfinished.persist(output).map_err(|error| StudyError::file(output, error.error))?;
    sync(folder);
    Ok(())
}

impl Report {
    /// Counts the rows of a batch.
    pub(crate) fn add(&mut self, contents: &Contents, rows: &Rows) {
        let column = |name: &str| {
            let place = contents.columns.iter().position(|column| column.name == name);
            place.and_then(|place| rows.get(place))
        };
        let (Some(Cells::Counts(index)), Some(Cells::Texts(status)), Some(Cells::Texts(error))) =
            (column("index"), column("status"), column("error"))
        else {
            return;
        };
        self.rows += index.len();
        for ((index, status), error) in index.iter().zip(status).zip(error) {
            match status.as_str() {
                crate::columns::FAILED => {
                    self.failed += 1;
                    let index = usize::try_from(*index).unwrap_or_default();
                    self.first_failure.get_or_insert_with(|| (index, error.clone()));
                }
                status if status == schlupf::Status::NotConverged.name() => self.not_converged += 1,
                _ => {}
            }
        }
    }

    /// Whether every row has a solution that converged.
    pub fn is_converged(&self) -> bool {
        self.failed == 0 && self.not_converged == 0
    }
}
