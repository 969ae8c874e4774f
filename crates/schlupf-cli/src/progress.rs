//! A progress bar for whatever lasts over a second on a terminal.

use std::io::{IsTerminal, stderr};
use std::ops::ControlFlow;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressStyle};
use schlupf_tasks::output::significant;

const PATIENCE: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(100);

/// A progress bar that shows up after a second, from a thread of its own: one step may be long.
#[derive(Debug)]
pub struct Progress {
    /// `None` where there is no terminal.
    thread: Option<(Sender<Message>, JoinHandle<()>)>,
}

/// What goes on.
#[derive(Debug, Clone, Copy)]
enum Message {
    Doing(&'static str),
    Got(schlupf::Progress),
}

impl Progress {
    /// Waits for the first second to pass.
    pub fn start() -> Self {
        if !stderr().is_terminal() {
            return Self { thread: None };
        }
        let (sender, receiver) = channel();
        Self { thread: Some((sender, std::thread::spawn(move || show(&receiver)))) }
    }

    /// What a computation is watched with.
    pub fn watch(&self) -> impl Fn(schlupf::Progress) -> ControlFlow<()> + Sync {
        |progress| {
            self.send(Message::Got(progress));
            ControlFlow::Continue(())
        }
    }

    /// Something else begins.
    pub fn stage(&self, name: &'static str) {
        self.send(Message::Doing(name));
    }

    fn send(&self, message: Message) {
        if let Some((sender, _)) = &self.thread {
            // The thread listens until the sender is dropped.
            let _ = sender.send(message);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.thread.take() {
            drop(sender);
            // Only the bar would suffer from a panic in its thread.
            let _ = thread.join();
        }
    }
}

fn show(messages: &Receiver<Message>) {
    let start = Instant::now();
    let mut latest = Message::Doing("solving");
    loop {
        match messages.recv_timeout(PATIENCE.saturating_sub(start.elapsed())) {
            Ok(message) => latest = message,
            Err(RecvTimeoutError::Timeout) => break,
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
    let bar = ProgressBar::new_spinner().with_elapsed(start.elapsed());
    bar.enable_steady_tick(TICK);
    let mut pace = None;
    update(&bar, latest, &mut pace);
    for message in messages {
        update(&bar, message, &mut pace);
    }
    bar.finish_and_clear();
}

/// How much was done when the bar began, part of which an earlier run may have done.
struct Pace {
    done: usize,
    since: Instant,
}

impl Pace {
    /// What is done a second since then, and the time that the rest takes at that rate.
    fn text(&self, done: usize, total: usize) -> String {
        let rate = done.saturating_sub(self.done) as f64 / self.since.elapsed().as_secs_f64();
        if !(rate.is_finite() && rate > 0.0) {
            return String::new();
        }
        let left = Duration::from_secs_f64((total.saturating_sub(done) as f64 / rate).min(1e9));
        format!("{}/s, {} left", significant(rate), HumanDuration(left))
    }
}

fn update(bar: &ProgressBar, message: Message, pace: &mut Option<Pace>) {
    let progress = match message {
        Message::Doing(name) => return bar.set_message(name),
        Message::Got(progress) => progress,
    };
    let (name, done) = (progress.stage.counted(), progress.done);
    if let Some(total) = progress.total {
        if bar.length().is_none() {
            bar.set_style(style_of_known_length());
        }
        bar.set_length(total as u64);
        bar.set_position(done as u64);
        let pace = pace.get_or_insert_with(|| Pace { done, since: Instant::now() });
        bar.set_prefix(pace.text(done, total));
        bar.set_message(format!("{name}{}", residual(progress.change)));
    } else {
        bar.set_message(format!("{name} {done}{}", residual(progress.change)));
    }
}

fn residual(change: Option<f64>) -> String {
    // The first one may still be infinite.
    let change = change.filter(|change| change.is_finite());
    change.map_or_else(String::new, |change| format!(", residual {change:.1e}"))
}

fn style_of_known_length() -> ProgressStyle {
    ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {prefix}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
}
