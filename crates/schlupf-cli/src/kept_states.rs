//! States that were solved for a look-up table, in a file beside it until it is whole.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use schlupf::table_building::{Keeper, Solved, Task};

use crate::failure::Failure;

/// A part of the work as three numbers.
type Key = [u64; 3];

/// What is kept of the states of a table. Its first line says of which; each other one is a part of
/// the work: its key, and the bits of three forces and whether it converged for each state.
#[derive(Debug)]
pub struct KeptStates {
    path: PathBuf,
    known: HashMap<Key, Vec<Solved>>,
    /// The file, and why it can no longer be written.
    file: Mutex<(File, Option<io::Error>)>,
}

impl KeptStates {
    /// Those of an output, from an earlier run that was to make the same table.
    pub fn of(output: &Path, what: &str) -> Result<Self, Failure> {
        let mut name = output.file_name().unwrap_or_default().to_owned();
        name.push(".parts");
        let path = output.with_file_name(name);
        let fail = |cause: io::Error| Failure::file(&path, cause);
        let head = format!("{what}\n");
        let earlier = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(cause) if cause.kind() == ErrorKind::NotFound => String::new(),
            Err(cause) => return Err(fail(cause)),
        };
        // What was being written when the run ended is not whole.
        let whole = earlier.rfind('\n').map_or("", |end| &earlier[..=end]);
        let known = match whole.strip_prefix(&head) {
            Some(lines) => lines.lines().filter_map(part).collect(),
            None if whole.is_empty() => HashMap::new(),
            None => {
                let reason = "it has states of another table: remove it to begin anew, or name \
                              another output";
                return Err(fail(io::Error::new(ErrorKind::AlreadyExists, reason)));
            }
        };
        let mut options = File::options();
        let file = options.create(true).truncate(false).write(true).open(&path).map_err(fail)?;
        file.set_len(whole.len() as u64).map_err(fail)?;
        drop(file);
        let mut file = File::options().append(true).open(&path).map_err(fail)?;
        if whole.is_empty() {
            file.write_all(head.as_bytes()).map_err(fail)?;
        }
        Ok(Self { path, known, file: Mutex::new((file, None)) })
    }

    /// Number of states of an earlier run.
    pub fn count(&self) -> usize {
        self.known.values().map(Vec::len).sum()
    }

    /// Removes them: the table is whole. Tells why some of them could not be kept.
    pub fn remove(self) -> Option<Failure> {
        let (file, failed) = self.file.into_inner().unwrap_or_else(PoisonError::into_inner);
        drop(file);
        let _ = fs::remove_file(&self.path);
        failed.map(|cause| Failure::file(&self.path, cause))
    }
}

impl Keeper for KeptStates {
    fn recall(&self, task: Task) -> Option<Vec<Solved>> {
        self.known.get(&key(task)).cloned()
    }

    fn keep(&self, task: Task, solved: &[Solved]) {
        let [a, b, c] = key(task);
        let mut line = format!("{a:x} {b:x} {c:x}");
        for state in solved {
            let [x, y, moment] = state.force.map(f64::to_bits);
            // Writing to a string cannot fail.
            let _ = write!(line, " {x:x} {y:x} {moment:x} {:x}", u64::from(state.converged));
        }
        line.push('\n');
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        // After a line that is not whole no other one would count.
        if file.1.is_none() {
            file.1 = file.0.write_all(line.as_bytes()).err();
        }
    }
}

fn key(task: Task) -> Key {
    match task {
        Task::Nodes { round, axis_ratio, azimuth } => {
            [round as u64, axis_ratio.to_bits(), azimuth.to_bits()]
        }
        // Rounds begin with 1.
        Task::Random { set, state } => [0, set, state as u64],
    }
}

fn part(line: &str) -> Option<(Key, Vec<Solved>)> {
    let numbers = line.split(' ').map(|word| u64::from_str_radix(word, 16).ok());
    let numbers: Vec<u64> = numbers.collect::<Option<_>>()?;
    let (key, states) = numbers.split_first_chunk::<3>()?;
    let (states, []) = states.as_chunks::<4>() else { return None };
    let solved = |[x, y, moment, converged]: &[u64; 4]| Solved {
        force: [*x, *y, *moment].map(f64::from_bits),
        converged: *converged == 1,
    };
    Some((*key, states.iter().map(solved).collect()))
}
