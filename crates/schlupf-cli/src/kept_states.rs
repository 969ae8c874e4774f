//! States that were solved for a look-up table, in a file beside it until it is whole.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use schlupf::analysis::table_building::{Keeper, Solved, Task};

use crate::failure::Failure;

/// A part of the work as three numbers.
type Key = [u64; 3];

/// What is kept of the states of a table. Its first line says of which; each other one is a part of
/// the work: its key, and the bits of three forces and whether it converged for each state.
#[derive(Debug)]
pub struct KeptStates {
    path: PathBuf,
    known: HashMap<Key, Vec<Solved>>,
    /// Length of the first line, in bytes.
    head: u64,
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
            None if head.starts_with(&earlier) => HashMap::new(),
            None => {
                let reason = "it does not hold states of this table: remove it to begin anew, or \
                              name another output";
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
        let head = head.len() as u64;
        Ok(Self { path, known, head, file: Mutex::new((file, None)) })
    }

    /// Number of states of an earlier run.
    pub fn count(&self) -> usize {
        self.known.values().map(Vec::len).sum()
    }

    /// Leaves them to the next run, if there are any.
    pub fn leave(self) {
        if fs::metadata(&self.path).is_ok_and(|file| file.len() <= self.head) {
            self.remove();
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    const TASK: Task = Task::Random { set: 0, state: 3 };

    /// States that a run has solved outlive a failure of the table; a file without any does not.
    #[test]
    fn states_are_left_if_there_are_any() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("t.npz");
        KeptStates::of(&output, "one").unwrap().leave();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        let kept = KeptStates::of(&output, "one").unwrap();
        kept.keep(TASK, &[Solved { force: [1.0, -2.0, 0.5], converged: true }]);
        kept.leave();
        let kept = KeptStates::of(&output, "one").unwrap();
        assert_eq!(kept.count(), 1);
        assert_eq!(kept.recall(TASK).unwrap()[0].force, [1.0, -2.0, 0.5]);
        kept.leave();
        assert!(KeptStates::of(&output, "another").is_err());
        assert!(KeptStates::of(&output, "one").unwrap().remove().is_none());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    /// What is empty or a first line that was cut is the table's own; all else is someone else's,
    /// and stays as it is.
    #[test]
    fn files_of_others_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("t.npz");
        let path = folder.path().join("t.npz.parts");
        for text in ["my notes", "one and more", "my notes\n", "one \n", "\n", "oneone\n1 2 3"] {
            fs::write(&path, text).unwrap();
            let refused = KeptStates::of(&output, "one").unwrap_err().to_string();
            assert!(refused.contains("t.npz.parts: it does not hold states of"), "{refused}");
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
        for text in ["", "on", "one", "one\n", "one\n1 2"] {
            fs::write(&path, text).unwrap();
            assert_eq!(KeptStates::of(&output, "one").unwrap().count(), 0);
            assert_eq!(fs::read_to_string(&path).unwrap(), "one\n", "{text:?}");
        }
    }
}
