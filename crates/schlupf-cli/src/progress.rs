//! A progress bar for whatever lasts over a second on a terminal.

use std::io::{IsTerminal, stderr};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use schlupf::rolling;

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
    Step(rolling::Progress),
    Stage(&'static str),
    Count(&'static str, usize),
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

    /// Time steps were done.
    pub fn step(&self, progress: rolling::Progress) {
        self.send(Message::Step(progress));
    }

    /// Something else begins.
    pub fn stage(&self, name: &'static str) {
        self.send(Message::Stage(name));
    }

    /// So many of something were done, of a number that nobody knows.
    pub fn count(&self, name: &'static str, done: usize) {
        self.send(Message::Count(name, done));
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
    let mut latest = Message::Stage("solving");
    loop {
        match messages.recv_timeout(PATIENCE.saturating_sub(start.elapsed())) {
            Ok(message) => latest = message,
            Err(RecvTimeoutError::Timeout) => break,
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
    let bar = ProgressBar::new_spinner().with_elapsed(start.elapsed());
    bar.enable_steady_tick(TICK);
    update(&bar, latest);
    for message in messages {
        update(&bar, message);
    }
    bar.finish_and_clear();
}

fn update(bar: &ProgressBar, message: Message) {
    match message {
        Message::Stage(name) => bar.set_message(name),
        Message::Count(name, done) => bar.set_message(format!("{name} {done}")),
        Message::Step(rolling::Progress { step, steps, change }) => {
            if let Some(steps) = steps {
                if bar.length().is_none() {
                    bar.set_style(style_of_known_length());
                }
                bar.set_length(steps as u64);
                bar.set_position(step as u64);
                bar.set_message("solving");
            } else {
                bar.set_message(format!("step {step}, relative change {change:.1e}"));
            }
        }
    }
}

fn style_of_known_length() -> ProgressStyle {
    ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
}
