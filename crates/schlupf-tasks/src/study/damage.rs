//! Damage over a run: a table of a study whose states follow one another along the track.

use std::io;
use std::path::{Path, PathBuf};

use crate::Notice;
use crate::output::damage::{DamageReport, LeftOut};
use crate::states::{CONTACTS, NO_CONTACT};
use schlupf::analysis::damage::{self, Laws, State};
use schlupf::reporting::Message;
use schlupf::{Status, Watch};
use schlupf_case::{CaseFile, FieldPath, InputFile, Setting, field};

use crate::TaskError;
use crate::request::{Kind, request};
use crate::study::batch::MORE_CONTACTS;
use crate::study::columns::{beside_field, contact_column};
use crate::study::counts::{Counts, WARNINGS};
use crate::study::error::StudyError;
use crate::study::plan::Study;
use crate::study::run;
use crate::study::table::{Cells, Contents, HAS_PARQUET, Reader};
use crate::task::{CaseArgument, Found, Given, Scratch, Task, Wanted};

/// Columns with the place of each state along the run, one of which a run needs.
const ALONG: [&str; 2] = ["distance", "time"];

/// The column with the place of the patch across the profile, which may be missing.
const ACROSS: &str = "position_y";

request! {
    /// Which run.
    Request {
        /// Table of `sweep` with a column distance or time, or a study of such states (.toml),
        /// which is solved.
        run: InputFile = Kind::file(), positional();
    }
}

/// `damage`: the section `[damage]` of the case has the laws; by default that of the study, which a
/// table keeps.
pub struct Damage;

impl Task for Damage {
    const NAME: &'static str = "damage";
    const ABOUT: &'static str =
        "Compute the damage over a run: energy, fatigue and wear across the profile";
    const SOURCES: &'static str = "Fatigue: Ekberg, Kabo and Andersson (2002). Wear: Archard (1953) with \
                                   coefficients of Jendel (2002); Braghin, Lewis, Dwyer-Joyce and Bruni \
                                   (2006).";
    const CASE: CaseArgument = CaseArgument::Positional(
        "with the laws in the section [damage]; by default that of the study, which its table keeps",
    );
    const HAS_SEVERAL: bool = true;
    type Request = Request;
    type Report = DamageReport;

    fn run(
        of: &Given,
        request: Request,
        _wanted: &Wanted,
        watch: Watch,
    ) -> Result<Found<DamageReport>, TaskError> {
        let found = plan(&request.run.path(), of)?.find_in(of.scratch, watch)?;
        Ok(found.into())
    }
}

/// A run and the case whose laws make damage of it, checked.
#[derive(Debug)]
struct Plan {
    path: PathBuf,
    /// Where the run is still to be solved.
    study: Option<Study>,
    case: CaseFile,
    laws: Laws,
    /// Whether the case is that of the table, of which the laws alone matter.
    is_of_table: bool,
}

/// Opens a run: the table of a study, or a study (.toml) of states along a run. Without a case of
/// its own the laws are those of the study's, which its table keeps, and overrides are of that.
///
/// # Errors
/// A study or case that is wrong, states that are no run, and overrides of what a table has solved.
fn plan(path: &Path, of: &Given) -> Result<Plan, StudyError> {
    let (option, assignments) = of.overrides;
    let is_study = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    let mut study = if is_study { Some(Study::from_path(path, None)?) } else { None };
    if let Some(own) = study.as_mut().filter(|_| of.is_default && !assignments.is_empty()) {
        let case = own.case_file().with(option, assignments)?;
        *own = Study::from_path(path, Some(&case))?;
    }
    let of_table = if let Some(study) = &study {
        let of = |name: &str| {
            let carried = study.design.carried().iter().find(|column| column.name == name)?;
            Some(carried.values.as_slice())
        };
        let along = ALONG.into_iter().find_map(|name| Some((name, of(name)?)));
        let along = along.ok_or_else(|| StudyError::table(path, no_run()))?;
        // Before they are solved.
        check_places(along, of(ACROSS))
            .map_err(|reason| StudyError::table(path, format!("of its states: {reason}")))?;
        None
    } else {
        case_in(path)?
    };
    let case = match (&study, &of_table) {
        (Some(study), _) if of.is_default => study.case_file().clone(),
        (None, Some(table)) if of.is_default => table.with(option, assignments)?,
        _ => of.case.clone(),
    };
    let varies = study.as_ref().filter(|_| of.is_default).map(|study| {
        let varied = study.design.varied().iter();
        varied.map(|varied| varied.field.path).collect::<Vec<_>>()
    });
    case.refuse_for_damage(assignments, varies.as_deref())?;
    let laws = case.damage_laws()?;
    let is_of_table = of_table.is_some();
    Ok(Plan { path: path.to_owned(), study, case, laws, is_of_table })
}

/// The case of the study that a table is of, as far as damage needs it.
fn case_in(path: &Path) -> Result<Option<CaseFile>, StudyError> {
    let reader = Reader::open(path)?;
    let text = &reader.contents().case;
    let name = format!("the case of {}", path.display());
    Ok(if text.is_empty() { None } else { Some(CaseFile::for_damage(text, &name)?) })
}

impl Plan {
    /// The damage of the run; a study is solved in a folder that is made for it.
    ///
    /// A state holds half-way to those before and after it, along the column `distance`, or along
    /// `time` at its speed.
    ///
    /// # Errors
    /// A table that cannot be read, is a shard, or is of no run, those of
    /// [`run`](fn@crate::study::run::run), and whatever keeps the folder from being made.
    fn find_in(
        self,
        folder: impl Fn() -> io::Result<Scratch>,
        watch: Watch,
    ) -> Result<DamageReport, StudyError> {
        let Self { path, study, .. } = &self;
        let (run, counts) = match study {
            None => {
                let run = Run::read(path, self.own_speed())?;
                let counts = run.counts.clone();
                (run, counts)
            }
            Some(study) => {
                let fail = |cause| StudyError::file(path, cause);
                let folder = folder().map_err(fail)?;
                let table =
                    (*folder).as_ref().join(if HAS_PARQUET { "run.parquet" } else { "run.csv" });
                let done = run::run(study, [1, 1], &table, watch)?;
                (Run::read(&table, self.own_speed())?, done.warnings)
            }
        };
        run.report(&self, &counts)
    }
}

impl Plan {
    /// The speed of the case, where the table has none, in m/s.
    fn own_speed(&self) -> f64 {
        match self.case.value(SPEED) {
            Some(Setting::Number(speed)) => speed,
            _ => f64::NAN,
        }
    }
}

fn no_run() -> String {
    let [distance, time] = ALONG;
    format!("a run needs states with a column {distance} or {time}, but there is none")
}

/// Largest distance of a patch from the origin of the profile, in m: beyond, units were mistaken.
const FARTHEST: f64 = 1.0;

/// Refuses places along the run that do not increase, and places across the profile that cannot be.
fn check_places((name, places): (&str, &[f64]), across: Option<&[f64]>) -> Result<(), String> {
    if places.len() < 2 {
        return Err(format!("a run must have at least 2 states, but has {}", places.len()));
    }
    if let Some(row) = places.iter().position(|place| !place.is_finite()) {
        return Err(format!("{name} must be a number, but is none in row {row}"));
    }
    for (row, place) in across.unwrap_or_default().iter().enumerate() {
        if !place.is_finite() {
            return Err(format!("{ACROSS} must be a number, but is none in row {row}"));
        }
        if place.abs() > FARTHEST {
            return Err(format!(
                "{ACROSS} must be between -{FARTHEST} and {FARTHEST} m, but is {place} in row {row}"
            ));
        }
    }
    let falls = places.windows(2).position(|pair| pair[1] <= pair[0]);
    falls.map_or(Ok(()), |row| {
        let [one, next] = [places[row], places[row + 1]];
        Err(format!(
            "{name} must increase from row to row, but is {next} after {one} in row {}",
            row + 1
        ))
    })
}

/// Speeds with that of the row before, or else the first, where a row without a solution has none.
fn carried_on(mut speeds: Vec<f64>) -> Vec<f64> {
    let mut known = speeds.iter().copied().find(|speed| speed.is_finite()).unwrap_or(f64::NAN);
    for speed in &mut speeds {
        if speed.is_finite() {
            known = *speed;
        }
        *speed = known;
    }
    speeds
}

/// The columns of a contact that a run needs, in the order in which they are read; of a contact of
/// a wheel under the second name.
const NEEDED: [[&str; 2]; 12] = [
    ["normal.load"; 2],
    ["normal.semi_axis_x"; 2],
    ["normal.semi_axis_y"; 2],
    ["normal.peak_pressure"; 2],
    ["area.contact"; 2],
    ["force.x"; 2],
    ["force.y"; 2],
    ["normalised.x"; 2],
    ["normalised.y"; 2],
    ["t_gamma.without_spin"; 2],
    ["t_gamma.with_spin"; 2],
    ["power.friction", "friction_power"],
];

/// Places of a contact on the profiles of the wheel and of the rail.
const ON_PROFILES: [&str; 2] = ["wheel_position", "rail_position"];

/// The column of the speed of the vehicle.
const SPEED: FieldPath = field!("kinematics.speed");

/// The column that a table of a wheel with profiles has.
const OF_WHEEL: &str = "wheel_force.z";

/// The column that tells whether a state has a solution.
const STATUS: &str = "status";

/// The columns of a run.
struct Run {
    /// Of each contact.
    contacts: Vec<ContactColumns>,
    speed: Vec<f64>,
    status: Vec<String>,
    /// Which of the columns, and its numbers.
    along: (&'static str, Vec<f64>),
    /// Whether the wheel has more contacts than the table; empty if nothing is known of it.
    has_others: Vec<bool>,
    /// Warnings of all rows.
    counts: Counts,
}

/// The columns of a contact.
struct ContactColumns {
    needed: [Vec<f64>; NEEDED.len()],
    /// Place of the patch on the profiles of wheel and rail, if it is known.
    across: Option<[Vec<f64>; 2]>,
}

impl Run {
    /// The columns that may be read.
    fn names() -> Vec<String> {
        let alone = NEEDED.iter().map(|[alone, _]| *alone);
        let of_wheel = NEEDED.iter().map(|[_, of_wheel]| *of_wheel).chain(ON_PROFILES);
        let of_wheel =
            of_wheel.flat_map(|name| (0..CONTACTS).map(move |place| contact_column(place, name)));
        let others = [STATUS, WARNINGS, ACROSS, OF_WHEEL].into_iter().chain(ALONG);
        let results =
            alone.chain([SPEED.as_str()]).flat_map(|name| [name.to_owned(), beside_field(name)]);
        results.chain(others.map(str::to_owned)).chain(of_wheel).collect()
    }

    /// `own_speed` is the speed of the case, in m/s.
    fn read(path: &Path, own_speed: f64) -> Result<Self, StudyError> {
        let names = Self::names();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut reader = Reader::open_only(path, &names)?;
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
        let is_of_wheel = table.cells(OF_WHEEL).is_some();
        let contacts = if is_of_wheel { CONTACTS } else { 1 };
        let contacts = (0..contacts).map(|place| {
            let name = |[alone, of_wheel]: [&str; 2]| {
                if is_of_wheel { contact_column(place, of_wheel) } else { alone.to_owned() }
            };
            let mut needed: [Vec<f64>; NEEDED.len()] = Default::default();
            for (numbers, names) in needed.iter_mut().zip(NEEDED) {
                let name = name(names);
                *numbers = table.result(&name).ok_or_else(|| missing(&name))?;
            }
            let across = if is_of_wheel {
                let place = ON_PROFILES.map(|name| table.numbers(&contact_column(place, name)));
                let [Some(wheel), Some(rail)] = place else { return Err(missing(ON_PROFILES[0])) };
                Some([wheel, rail])
            } else {
                table.numbers(ACROSS).map(|across| [across.clone(), across])
            };
            Ok(ContactColumns { needed, across })
        });
        let contacts = contacts.collect::<Result<Vec<_>, StudyError>>()?;
        let status = table.texts(STATUS).ok_or_else(|| missing(STATUS))?;
        // That of a contact of a wheel is another one.
        let is_own = !is_of_wheel || table.cells(&beside_field(&SPEED)).is_some();
        let speed = table.numbers(&SPEED).filter(|_| is_own);
        let run = Self {
            contacts,
            speed: carried_on(speed.unwrap_or_else(|| vec![own_speed; status.len()])),
            status,
            along: along.ok_or_else(|| StudyError::table(path, no_run()))?,
            has_others: table.warned(MORE_CONTACTS),
            counts: table.counts(),
        };
        let (name, places) = &run.along;
        let across = table.numbers(ACROSS).filter(|_| !is_of_wheel);
        check_places((name, places), across.as_deref())
            .map_err(|reason| StudyError::table(path, reason))?;
        Ok(run)
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
        if *name != "time" {
            return (0..places.len()).map(interval).collect();
        }
        self.speed.iter().enumerate().map(|(k, speed)| interval(k) * speed).collect()
    }

    fn report(self, plan: &Plan, counts: &Counts) -> Result<DamageReport, StudyError> {
        let mut states = Vec::with_capacity(self.status.len());
        let [mut unsolved, mut powerless] = [Gap::default(); 2];
        // Those of the last state that has a force.
        let mut friction = vec![1.0; self.contacts.len()];
        let mut start = 0.0;
        for (row, distance) in self.distances().into_iter().enumerate() {
            let piece = Piece { distance, middle: start + 0.5 * distance };
            start += distance;
            match self.status[row].as_str() {
                NO_CONTACT => states.push(self.unloaded(row, piece)),
                status if status == Status::Converged.name() => {
                    let each = self.contacts.iter().zip(&mut friction).enumerate();
                    let each = each.filter(|(_, (contact, _))| contact.has(row));
                    let each: Vec<State> = each
                        .map(|(k, (contact, friction))| State {
                            is_further_contact: k > 0,
                            ..contact.state(row, self.unloaded(row, piece), friction)
                        })
                        .collect();
                    if each.iter().all(|state| state.friction_power.is_finite()) {
                        states.extend(each);
                    } else {
                        powerless.add(row, distance);
                    }
                }
                _ => unsolved.add(row, distance),
            }
        }
        if !states.iter().any(|state| state.load > 0.0) {
            let what = if powerless.rows > 0 { "friction power" } else { "solution" };
            let reason = format!("none of the states of the run has a {what}");
            return Err(StudyError::table(&plan.path, reason));
        }
        let Plan { path, case, laws, is_of_table, .. } = plan;
        let damage = damage::of_run(&states, laws).map_err(|error| case.explain(&error))?;
        let notices = if *is_of_table { Vec::new() } else { case.notices() };
        let Gap { rows, first, distance } = unsolved;
        let left_out = (rows > 0).then_some(Notice::LeftOut { rows, first, distance });
        let Gap { rows, first, distance } = powerless;
        let no_power = (rows > 0).then_some(Notice::NoFrictionPower { rows, first, distance });
        let others = self.has_others.iter().filter(|has| **has).count();
        let first = self.has_others.iter().position(|has| *has);
        let others = first.map(|first| Notice::MoreContacts { rows: others, first });
        let is_told = |message: &Message| {
            message.code == MORE_CONTACTS || notices.iter().any(|told| told.code == message.code)
        };
        let of_rows = counts.messages().into_iter().filter(|message| !is_told(message));
        let of_rows: Vec<Message> = of_rows.collect();
        let gaps = left_out.into_iter().chain(no_power).chain(others).map(Message::from);
        Ok(DamageReport {
            title: path.display().to_string(),
            laws: laws.clone(),
            damage,
            left_out: LeftOut {
                states: unsolved.rows + powerless.rows,
                distance: unsolved.distance + powerless.distance,
            },
            warnings: notices.into_iter().chain(gaps).chain(of_rows).collect(),
        })
    }

    /// A state in which the wheel does not touch the rail.
    fn unloaded(&self, row: usize, piece: Piece) -> State {
        State {
            distance: piece.distance,
            middle: piece.middle,
            speed: self.speed[row],
            position_y: 0.0,
            rail_position_y: 0.0,
            is_further_contact: false,
            load: 0.0,
            semi_axis_x: 0.0,
            semi_axis_y: 0.0,
            peak_pressure: 0.0,
            contact_area: 0.0,
            tangential_force: 0.0,
            t_gamma: 0.0,
            friction_power: 0.0,
            friction_coefficient: 0.0,
        }
    }
}

impl ContactColumns {
    /// Whether there is such a contact in a row that has a solution.
    fn has(&self, row: usize) -> bool {
        let [load, ..] = &self.needed;
        load[row].is_finite()
    }

    /// The state of a row that has a solution; without a friction power that is not a number.
    fn state(&self, row: usize, piece: State, friction: &mut f64) -> State {
        let [load, a, b, peak, area, x, y, of_x, of_y, t_gamma, with_spin, power] =
            self.needed.each_ref().map(|numbers| numbers[row]);
        let force = x.hypot(y);
        // F/(μ0 N) tells μ0.
        let bound = force / (of_x.hypot(of_y) * load);
        if bound.is_finite() && bound > 0.0 {
            *friction = bound;
        }
        let [position_y, rail_position_y] = match &self.across {
            Some(across) => across.each_ref().map(|places| places[row]),
            None => [0.0; 2],
        };
        State {
            position_y,
            rail_position_y,
            load,
            semi_axis_x: a,
            semi_axis_y: b,
            peak_pressure: peak,
            contact_area: area,
            tangential_force: force,
            t_gamma,
            friction_power: if power.is_nan() { with_spin * piece.speed } else { power },
            friction_coefficient: *friction,
            ..piece
        }
    }
}

/// The piece of the run over which a state holds, in m.
#[derive(Clone, Copy)]
struct Piece {
    distance: f64,
    middle: f64,
}

/// States that are left out.
#[derive(Clone, Copy, Default)]
struct Gap {
    rows: usize,
    first: usize,
    distance: f64,
}

impl Gap {
    fn add(&mut self, row: usize, distance: f64) {
        if self.rows == 0 {
            self.first = row;
        }
        self.rows += 1;
        self.distance += distance;
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

    /// The warnings of all rows.
    fn counts(&self) -> Counts {
        let mut counts = Counts::default();
        if let Some(Cells::Texts(texts)) = self.cells(WARNINGS) {
            texts.iter().enumerate().for_each(|(row, codes)| counts.add(row, codes));
        }
        counts
    }

    /// In which rows a warning is given.
    fn warned(&self, code: &str) -> Vec<bool> {
        match self.cells(WARNINGS) {
            Some(Cells::Texts(texts)) => {
                texts.iter().map(|text| text.split(' ').any(|word| word == code)).collect()
            }
            _ => Vec::new(),
        }
    }

    fn texts(&self, name: &str) -> Option<Vec<String>> {
        match self.cells(name)? {
            Cells::Texts(texts) => Some(texts.clone()),
            _ => None,
        }
    }

    /// The numbers of a result, which a field of the same name may have beside it.
    fn result(&self, name: &str) -> Option<Vec<f64>> {
        self.numbers(&beside_field(name)).or_else(|| self.numbers(name))
    }
}
