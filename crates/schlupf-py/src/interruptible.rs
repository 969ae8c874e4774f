//! Long computations that Ctrl-C stops, without the lock of the interpreter.

use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;
use schlupf::{Progress, Watch};

use crate::laws::Raised;

/// How often Python is asked for signals.
const PERIOD: Duration = Duration::from_millis(50);

/// Does the work on a thread of its own while this one waits for signals, which Python handles on
/// its main thread only.
///
/// # Errors
/// What a handler of signals raises, such as `KeyboardInterrupt`, or a function that the work
/// calls; the work has ended then.
pub fn interruptible<R: Send>(
    py: Python<'_>,
    raised: &Raised,
    work: impl FnOnce(Watch) -> R + Send,
) -> PyResult<R> {
    let is_stopped = AtomicBool::new(false);
    let watch = |_: Progress| {
        if is_stopped.load(Ordering::Relaxed) || raised.is_set() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let mut interrupt = None;
    let result = py.detach(|| {
        thread::scope(|scope| {
            let (done, is_done) = channel::<()>();
            let worker = scope.spawn(|| {
                // Dropped at the end, also by a panic.
                let _done = done;
                work(&watch)
            });
            while is_done.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
                if interrupt.is_none() {
                    #[expect(
                        clippy::redundant_closure_for_method_calls,
                        reason = "the method is of one lifetime only"
                    )]
                    let handled = Python::attach(|py| py.check_signals());
                    interrupt = handled.err();
                    is_stopped.store(interrupt.is_some(), Ordering::Relaxed);
                }
            }
            worker.join()
        })
    });
    if let Some(error) = raised.take() {
        return Err(error);
    }
    match (interrupt, result) {
        (Some(error), _) => Err(error),
        (None, Ok(result)) => Ok(result),
        // PyO3 makes an exception of it.
        (None, Err(panic)) => resume_unwind(panic),
    }
}

/// Does work of microseconds on this thread; only exceptions of the functions that it calls stop
/// it.
///
/// # Errors
/// What such a function raises.
pub fn brief<R: Send>(
    py: Python<'_>,
    raised: &Raised,
    work: impl FnOnce(Watch) -> R + Send,
) -> PyResult<R> {
    let watch = |_: Progress| {
        if raised.is_set() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let result = py.detach(|| work(&watch));
    raised.take().map_or(Ok(result), Err)
}
