//! Runs a study: batches on all threads, each kept as soon as it is done, then the table.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::states::{FAILED, NO_CONTACT};
use schlupf::Watch;
use schlupf::numerics::parallel;
use schlupf::reporting::{Progress, Stage};
use tempfile::NamedTempFile;

pub use crate::study::solved::Solved;

use crate::study::batch;
use crate::study::chunks::{self, Chunks};
use crate::study::counts::{Counts, WARNINGS};
use crate::study::error::StudyError;
use crate::study::lock::OutputLock;
use crate::study::parts::{Parts, folder_with, sync};
use crate::study::plan::Study;
use crate::study::solved::no_fields;
use crate::study::table::{Cells, Contents, Format, Reader, Rows, Writer};

/// What a run has done.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Rows of the table.
    pub rows: usize,
    /// Rows that an earlier run had solved already.
    pub resumed: usize,
    /// Rows whose solution has not converged.
    pub not_converged: usize,
    /// Rows without a contact, which have no forces.
    pub no_contact: usize,
    /// Rows that could not be solved.
    pub failed: usize,
    /// The first row that failed, and why.
    pub first_failure: Option<(usize, String)>,
    /// Warnings of the rows, counted by their codes.
    pub warnings: Counts,
}

/// Solves the rows of a study, or of its share `[i, n]` from `[1, n]` to `[n, n]`, and writes their
/// table.
///
/// Batches that an earlier run of the same study has kept are not solved again. The table is the
/// same, byte for byte, on any number of threads and after any number of runs that ended early.
///
/// # Errors
/// Files that cannot be written, a file or batches of another study in their place, and
/// [`StudyError::Stopped`]. What is done is kept.
pub fn run(
    study: &Study,
    shard: [usize; 2],
    output: &Path,
    watch: Watch,
) -> Result<Report, StudyError> {
    let run = match Run::start(study, shard, output)? {
        Started::Done(report) => return Ok(report),
        Started::Open(run) => run,
    };
    let (solved, total) = (AtomicUsize::new(0), run.resumed + run.rows_of(&run.left));
    let told =
        |solved: usize| watch(Progress::count(Stage::Study, 0).of(run.resumed + solved, total));
    if told(0).is_break() {
        return Err(StudyError::Stopped);
    }
    let found = parallel::try_map(run.left.clone(), |batch| {
        // Progress is that of the study, but whoever watches may stop each solution.
        let within = |_| told(solved.load(Ordering::Relaxed));
        let found = solve(study, batch, &within)?;
        run.keep(batch, &found)?;
        let count = run.contents.rows_of(batch).len();
        let solved = solved.fetch_add(count, Ordering::Relaxed) + count;
        if told(solved).is_break() { Err(StudyError::Stopped) } else { Ok(found.warnings) }
    })?;
    let mut report = run.finish()?;
    for warnings in found {
        report.warnings.tell(warnings);
    }
    Ok(report)
}

/// Solves a batch of a study: on any machine the same.
///
/// # Errors
/// [`StudyError::Stopped`].
pub fn solve(study: &Study, batch: usize, watch: Watch) -> Result<Solved, StudyError> {
    batch::solve(study, &study.contents([1, 1]), batch, watch)
}

/// What there is at the start.
#[derive(Debug)]
pub enum Started {
    /// The table is there already.
    Done(Report),
    /// Batches are to be solved.
    Open(Box<Run>),
}

/// A run of a study whose batches are solved by the caller, say on other machines.
#[derive(Debug)]
pub struct Run {
    /// Until the table is in its place.
    lock: OutputLock,
    contents: Contents,
    output: PathBuf,
    parts: Parts,
    chunks: Option<Chunks>,
    left: Vec<usize>,
    resumed: usize,
}

impl Run {
    /// Begins a run, or goes on with one; see [`run`](fn@run).
    ///
    /// # Errors
    /// Files that cannot be written, and a file or batches of another study in their place.
    pub fn start(study: &Study, shard: [usize; 2], output: &Path) -> Result<Started, StudyError> {
        Format::of(output)?;
        let contents = study.contents(shard);
        if output.exists() {
            return existing(output, &contents).map(Started::Done);
        }
        let lock = OutputLock::take(output).map_err(|cause| StudyError::file(output, cause))?;
        // Another run may just have ended.
        if output.exists() {
            return existing(output, &contents).map(Started::Done);
        }
        let parts = Parts::of(output, &contents)?;
        let columns = study.fields.as_deref().map(chunks::columns);
        let chunks = columns.map(|columns| Chunks::of(output, &contents, columns, &parts));
        let chunks = match chunks.transpose() {
            // With a manifest the next try would take the other run's fields for its own.
            Err(error) if parts.is_new() => {
                parts.remove();
                return Err(error);
            }
            chunks => chunks?,
        };
        let (done, left): (Vec<usize>, Vec<usize>) =
            contents.own_batches().partition(|batch| parts.has(*batch));
        let output = output.to_owned();
        let mut run = Self { lock, contents, output, parts, chunks, left, resumed: 0 };
        run.resumed = run.rows_of(&done);
        Ok(Started::Open(Box::new(run)))
    }

    /// Starts a run of batches of all shares that other machines solve and send as
    /// [text](Solved::to_text).
    ///
    /// # Errors
    /// Those of [`Self::start`], and a study that keeps fields, before anything is made.
    pub fn start_elsewhere(study: &Study, output: &Path) -> Result<Started, StudyError> {
        if study.fields.is_some() {
            return Err(no_fields());
        }
        Self::start(study, [1, 1], output)
    }

    /// The batches that are left, for [`solve`].
    pub fn left(&self) -> &[usize] {
        &self.left
    }

    /// Keeps a batch: it is on the disk then.
    ///
    /// # Errors
    /// Files that cannot be written.
    pub fn keep(&self, batch: usize, solved: &Solved) -> Result<(), StudyError> {
        // The rows come last: a batch that has them is done.
        if let (Some(chunks), Some(fields)) = (&self.chunks, &solved.fields) {
            chunks.keep(batch, fields, &self.parts)?;
        }
        self.parts.keep(batch, &solved.rows)
    }

    /// Writes the table, when all batches are kept.
    ///
    /// # Errors
    /// A batch that is missing, and files that cannot be read or written.
    pub fn finish(self) -> Result<Report, StudyError> {
        let Self { lock, contents, output, parts, resumed, .. } = self;
        let mut report = Report { resumed, ..Report::default() };
        assemble(&output, parts.unfinished(), &contents, &mut |batch| {
            let rows = parts.rows(batch, &contents)?;
            report.add(&contents, &rows);
            Ok(rows)
        })?;
        parts.remove();
        drop(lock);
        Ok(report)
    }

    fn rows_of(&self, batches: &[usize]) -> usize {
        batches.iter().map(|batch| self.contents.rows_of(*batch).len()).sum()
    }
}

/// A table that is there already.
pub(crate) fn existing(output: &Path, contents: &Contents) -> Result<Report, StudyError> {
    let mut reader = Reader::open(output)?;
    if reader.contents() != contents {
        let what = contents.other(reader.contents());
        let reason = format!("it is the table of {what}: remove it, or name another output");
        return Err(StudyError::table(output, reason));
    }
    let mut report = Report::default();
    while let Some(rows) = reader.next_batch()? {
        report.add(contents, &rows);
    }
    let expected: usize = contents.own_batches().map(|batch| contents.rows_of(batch).len()).sum();
    if report.rows != expected {
        let reason = format!(
            "it has {} rows of {expected}, so it was cut: remove it, or name another output",
            report.rows
        );
        return Err(StudyError::table(output, reason));
    }
    report.resumed = report.rows;
    Parts::remove_done(output, contents)?;
    Ok(report)
}

/// Writes a table of the batches of its share into a new file and puts that in its place: all of
/// it, or nothing.
pub(crate) fn assemble(
    output: &Path,
    unfinished: io::Result<NamedTempFile>,
    contents: &Contents,
    rows_of: &mut dyn FnMut(usize) -> Result<Rows, StudyError>,
) -> Result<(), StudyError> {
    let format = Format::of(output)?;
    let unfinished = unfinished.map_err(|cause| StudyError::file(output, cause))?.into_temp_path();
    let mut writer = Writer::create(&unfinished, format, contents)?;
    for batch in contents.own_batches() {
        writer.append(&rows_of(batch)?)?;
    }
    writer.finish()?;
    unfinished.persist(output).map_err(|error| StudyError::file(output, error.error))?;
    sync(folder_with(output));
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
        if let Some(Cells::Texts(codes)) = column(WARNINGS) {
            for (index, codes) in index.iter().zip(codes) {
                self.warnings.add(usize::try_from(*index).unwrap_or_default(), codes);
            }
        }
        for ((index, status), error) in index.iter().zip(status).zip(error) {
            match status.as_str() {
                FAILED => {
                    self.failed += 1;
                    let index = usize::try_from(*index).unwrap_or_default();
                    self.first_failure.get_or_insert_with(|| (index, error.clone()));
                }
                NO_CONTACT => self.no_contact += 1,
                status if status == schlupf::Status::NotConverged.name() => self.not_converged += 1,
                _ => {}
            }
        }
    }

    /// Whether every row with a contact has a solution that converged.
    pub fn is_converged(&self) -> bool {
        self.failed == 0 && self.not_converged == 0
    }
}
