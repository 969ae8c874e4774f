//! Damage over a run: a table of a study whose states follow one another along the track.

use std::path::{Path, PathBuf};

use schlupf::damage::{self, State};
use schlupf::message::Message;
use schlupf::{Status, Watch};
use schlupf_case::{Case, CaseErrors, CaseFile};
use schlupf_output::damage::{DamageReport, LeftOut};
use schlupf_tasks::Notice;

use crate::error::StudyError;
use crate::run;
use crate::study::Study;
use crate::table::{Cells, Contents, Reader};

/// Columns with the place of each state along the run, one of which a run needs.
const ALONG: [&str; 2] = ["distance", "time"];

/// The column with the place of the patch across the profile, which may be missing.
const ACROSS: &str = "position_y";

/// A run and the case whose laws make damage of it, checked.
#[derive(Debug)]
pub struct Plan {
    path: PathBuf,
    /// Where the run is still to be solved.
    study: Option<Study>,
    case: Case,
}

/// Opens a run: the table of a study (.csv or .parquet), or a study (.toml) of states along a run.
/// `case_of` tells the case with the laws, from that of the study if there is one.
///
/// # Errors
/// A study or case that is wrong, and states that are no run.
pub fn plan(
    path: &Path,
    case_of: impl FnOnce(Option<&CaseFile>) -> Result<CaseFile, CaseErrors>,
    watch: Watch,
) -> Result<Plan, StudyError> {
    let is_study = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    let study = if is_study { Some(Study::from_path(path)?) } else { None };
    if let Some(study) = &study {
        let is_along = |name: &str| ALONG.contains(&name);
        if !study.design.carried().iter().any(|column| is_along(column.name)) {
            return Err(StudyError::table(path, no_run()));
        }
    } else {
        Reader::open(path)?;
    }
    let case = case_of(study.as_ref().map(Study::case_file))?.pose(watch)?;
    case.damage_laws()?;
    Ok(Plan { path: path.to_owned(), study, case })
}

impl Plan {
    /// The damage of the run; a study is solved, without keeping its table.
    ///
    /// A state holds half-way to those before and after it, along the column `distance`, or along
    /// `time` at its speed.
    ///
    /// # Errors
    /// A table that cannot be read, is a shard, or is of no run, and those of
    /// [`run`](fn@crate::run::run).
    pub fn find(self, watch: Watch) -> Result<DamageReport, StudyError> {
        let Self { path, study, case } = self;
        let run = match study {
            None => Run::read(&path)?,
            Some(study) => {
                let fail = |cause| StudyError::file(&path, cause);
                let folder = tempfile::tempdir().map_err(fail)?;
                let table = folder.path().join("run.parquet");
                run::run(&study, [1, 1], &table, watch)?;
                Run::read(&table)?
            }
        };
        run.report(&path, &case)
    }
}

fn no_run() -> String {
    let [distance, time] = ALONG;
    format!("a run needs states with a column {distance} or {time}, but there is none")
}

/// The columns that a run needs, in the order in which they are read.
const NEEDED: [&str; 12] = [
    "kinematics.speed",
    "normal.load",
    "normal.semi_axis_x",
    "normal.semi_axis_y",
    "normal.peak_pressure",
    "area.contact",
    "force.x",
    "force.y",
    "normalised.x",
    "normalised.y",
    "t_gamma.without_spin",
    "t_gamma.with_spin",
];

/// The columns of a run.
struct Run {
    needed: [Vec<f64>; NEEDED.len()],
    /// Friction power, not a number where the method gives none.
    power: Vec<f64>,
    is_solved: Vec<bool>,
    /// Which of the columns, and its numbers.
    along: (&'static str, Vec<f64>),
    across: Option<Vec<f64>>,
}

impl Run {
    fn read(path: &Path) -> Result<Self, StudyError> {
        let mut reader = Reader::open(path)?;
        let contents = reader.contents().clone();
        let [shard, shards] = contents.shard;
        if shards != 1 {
            let reason =
                format!("it is shard {shard}/{shards} of a study: merge all of them before");
            return Err(StudyError::table(path, reason));
        }
        let mut columns: Vec<Cells> =
            contents.columns.iter().map(|column| Cells::empty(column.kind)).collect();
        while let Some(rows) = reader.next_batch()? {
            for (all, part) in columns.iter_mut().zip(rows) {
                all.append(part);
            }
        }
        let table = Table { contents, columns };
        let along = ALONG.into_iter().find_map(|name| Some((name, table.numbers(name)?)));
        let missing = |name: &str| {
            StudyError::table(path, format!("a run needs the column {name}, which is missing"))
        };
        let mut needed: [Vec<f64>; NEEDED.len()] = Default::default();
        for (numbers, name) in needed.iter_mut().zip(NEEDED) {
            *numbers = table.numbers(name).ok_or_else(|| missing(name))?;
        }
        let run = Self {
            needed,
            power: table.numbers("power.friction").ok_or_else(|| missing("power.friction"))?,
            is_solved: table.is_solved().ok_or_else(|| missing("status"))?,
            along: along.ok_or_else(|| StudyError::table(path, no_run()))?,
            across: table.numbers(ACROSS),
        };
        run.check_order(path)?;
        Ok(run)
    }

    /// Refuses places along the run that do not increase.
    fn check_order(&self, path: &Path) -> Result<(), StudyError> {
        let (name, places) = &self.along;
        let refused = |reason: String| Err(StudyError::table(path, reason));
        if places.len() < 2 {
            return refused(format!("a run must have at least 2 states, but has {}", places.len()));
        }
        if let Some(row) = places.iter().position(|place| !place.is_finite()) {
            return refused(format!("{name} must be a number, but is none in row {row}"));
        }
        let falls = places.windows(2).position(|pair| pair[1] <= pair[0]);
        falls.map_or(Ok(()), |row| {
            let [one, next] = [places[row], places[row + 1]];
            refused(format!(
                "{name} must increase from row to row, but is {next} after {one} in row {}",
                row + 1
            ))
        })
    }

    /// The distance over which each state holds, in m.
    fn distances(&self) -> Vec<f64> {
        let (name, places) = &self.along;
        let last = places.len() - 1;
        let middle = |k: usize| 0.5 * (places[k] + places[k + 1]);
        let interval = |k: usize| {
            let start = if k == 0 { places[0] } else { middle(k - 1) };
            let end = if k == last { places[last] } else { middle(k) };
            end - start
        };
        let [speeds, ..] = &self.needed;
        let distance = |k: usize| {
            if *name == "time" { interval(k) * speeds[k] } else { interval(k) }
        };
        (0..places.len()).map(distance).collect()
    }

    fn report(self, path: &Path, case: &Case) -> Result<DamageReport, StudyError> {
        let laws = case.damage_laws()?;
        let distances = self.distances();
        let mut states = Vec::with_capacity(distances.len());
        let mut left_out = LeftOut::default();
        let mut first = None;
        // That of the last state that has a force.
        let mut friction = 1.0;
        for (row, distance) in distances.into_iter().enumerate() {
            if let Some(state) = self.state(row, distance, &mut friction) {
                states.push(state);
            } else {
                first.get_or_insert(row);
                left_out.states += 1;
                // Where a state has failed, its speed may be unknown, too.
                left_out.distance += if distance.is_finite() { distance } else { 0.0 };
            }
        }
        if states.is_empty() {
            return Err(StudyError::table(path, "none of the states of the run has a solution"));
        }
        let damage = damage::of_run(&states, &laws).map_err(|error| case.explain(&error))?;
        let notice = first.map(|first| Notice::LeftOut {
            rows: left_out.states,
            first,
            distance: left_out.distance,
        });
        let warnings = case.notices.iter().cloned().chain(notice.map(Message::from)).collect();
        let title = path.display().to_string();
        Ok(DamageReport { title, laws, damage, left_out, warnings })
    }

    /// The state of a row; `None` without a solution.
    fn state(&self, row: usize, distance: f64, friction: &mut f64) -> Option<State> {
        let [speed, load, a, b, peak, area, x, y, of_x, of_y, t_gamma, with_spin] =
            self.needed.each_ref().map(|numbers| numbers[row]);
        if !self.is_solved[row] {
            return None;
        }
        let force = x.hypot(y);
        // F/(μ0 N) tells μ0.
        let bound = force / (of_x.hypot(of_y) * load);
        if bound.is_finite() && bound > 0.0 {
            *friction = bound;
        }
        let power = self.power[row];
        Some(State {
            distance,
            speed,
            position_y: self.across.as_ref().map_or(0.0, |across| across[row]),
            load,
            semi_axis_x: a,
            semi_axis_y: b,
            peak_pressure: peak,
            contact_area: area,
            tangential_force: force,
            t_gamma,
            friction_power: if power.is_nan() { with_spin * speed } else { power },
            friction_coefficient: *friction,
        })
    }
}

/// A table in memory.
struct Table {
    contents: Contents,
    columns: Vec<Cells>,
}

impl Table {
    fn cells(&self, name: &str) -> Option<&Cells> {
        let place = self.contents.columns.iter().position(|column| column.name == name)?;
        self.columns.get(place)
    }

    fn numbers(&self, name: &str) -> Option<Vec<f64>> {
        match self.cells(name)? {
            Cells::Numbers(numbers) => Some(numbers.clone()),
            _ => None,
        }
    }

    fn is_solved(&self) -> Option<Vec<bool>> {
        match self.cells("status")? {
            Cells::Texts(texts) => {
                Some(texts.iter().map(|status| status == Status::Converged.name()).collect())
            }
            _ => None,
        }
    }
}
