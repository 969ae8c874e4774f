//! Standard output.

use std::io::{ErrorKind, Write, stdout};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;

/// Whether a text is being written.
static IS_WRITING: AtomicBool = AtomicBool::new(false);

/// Whether whoever reads standard output has a part of a text only.
pub fn is_writing() -> bool {
    IS_WRITING.load(Ordering::Relaxed)
}

/// Writes to standard output. A reader that has seen enough (`| head`) is no failure.
pub fn write(text: &str) -> Result<(), Failure> {
    let mut stdout = stdout().lock();
    IS_WRITING.store(true, Ordering::Relaxed);
    let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
    IS_WRITING.store(false, Ordering::Relaxed);
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::file(Path::new("standard output"), error))
        }
        _ => Ok(()),
    }
}
