//! Deadline of an answer, and progress on the terminal when it takes longer than a second.

use indicatif::{ProgressBar, ProgressStyle};
use quantities::{Language, format_number};
use questions::Patience;
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;
use words::terminal;

/// Shown after this time.
const QUIET: Duration = Duration::from_secs(1);

/// What does not poll for so long after the deadline is ended from outside: a library that reads, or a pass over a long recording.
const GRACE: Duration = Duration::from_millis(500);

/// Redrawn so often.
const TICK: Duration = Duration::from_millis(100);

static PATIENCE: OnceLock<(Patience, Option<Duration>)> = OnceLock::new();

fn caller() -> &'static (Patience, Option<Duration>) {
    PATIENCE.get_or_init(|| (Patience::endless(), None))
}

/// That of the caller of this process.
pub(crate) fn patience() -> &'static Patience {
    &caller().0
}

/// The deadline of the caller in seconds.
pub(crate) fn waited_s() -> Option<f64> {
    caller().1.map(|most| most.as_secs_f64())
}

/// As long as it lives the work goes on; a terminal shows so after a second, anything else shows nothing.
pub(crate) struct Waiting {
    done: Vec<(Sender<()>, JoinHandle<()>)>,
}

impl Waiting {
    /// From now on, for so long at most; `None` without end. A work that does not end by itself then is ended by `late`.
    pub(crate) fn begin(language: Language, most: Option<Duration>, late: impl FnOnce() + Send + 'static) -> Self {
        let (patience, most) = PATIENCE.get_or_init(|| {
            let patience = if most.is_some() { Patience::limited() } else { Patience::endless() };
            (patience, most)
        });
        let mut waiting = Self { done: Vec::new() };
        if let Some(most) = *most {
            waiting.beside(move |is_done| {
                if is_done.recv_timeout(most) == Err(RecvTimeoutError::Timeout) {
                    patience.cancel();
                    if is_done.recv_timeout(GRACE) == Err(RecvTimeoutError::Timeout) {
                        late();
                    }
                }
            });
        }
        if std::io::stderr().is_terminal() {
            waiting.beside(move |is_done| show(&is_done, patience, language));
        }
        waiting
    }

    fn beside(&mut self, work: impl FnOnce(Receiver<()>) + Send + 'static) {
        let (done, is_done) = channel::<()>();
        self.done.push((done, std::thread::spawn(move || work(is_done))));
    }
}

/// A sign of life, until the work is done.
fn show(is_done: &Receiver<()>, patience: &Patience, language: Language) {
    if is_done.recv_timeout(QUIET) != Err(RecvTimeoutError::Timeout) {
        return;
    }
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    while is_done.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
        bar.set_message(message(patience, language));
        bar.tick();
    }
    bar.finish_and_clear();
}

/// What is being done, with the share that is done where it is known.
fn message(patience: &Patience, language: Language) -> String {
    match patience.progress() {
        (done, Some(all)) if done <= all => {
            #[allow(clippy::cast_precision_loss, reason = "at most some millions")]
            let share = format_number(100.0 * done as f64 / all as f64, 0, language);
            terminal::calculating_share(&share, language)
        }
        _ => terminal::calculating(language).to_owned(),
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        for (done, thread) in self.done.drain(..) {
            drop(done);
            // What the thread drew is gone before the answer is written.
            let _ = thread.join();
        }
    }
}
