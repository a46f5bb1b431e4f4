//! Time limit of an answer, and progress on the terminal when it takes longer than a second.

use indicatif::{ProgressBar, ProgressStyle};
use quantities::{Language, format_number};
use questions::Progress;
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;
use words::terminal;

/// Time after which the progress is shown.
const QUIET: Duration = Duration::from_secs(1);

/// Time after the deadline at which work that does not poll is ended from outside: a library that reads, or a pass over
/// a long recording.
const GRACE: Duration = Duration::from_millis(500);

/// Refresh interval of the progress.
const TICK: Duration = Duration::from_millis(100);

static PATIENCE: OnceLock<(Progress, Option<Duration>)> = OnceLock::new();

fn caller() -> &'static (Progress, Option<Duration>) {
    PATIENCE.get_or_init(|| (Progress::endless(), None))
}

/// Returns progress and cancellation of the caller of this process.
pub(crate) fn progress() -> &'static Progress {
    &caller().0
}

/// Returns the deadline of the caller \[s\].
pub(crate) fn waited_s() -> Option<f64> {
    caller().1.map(|most| most.as_secs_f64())
}

/// Guard of a running work; while it lives, a terminal shows the progress after a second.
pub(crate) struct Waiting {
    done: Vec<(Sender<()>, JoinHandle<()>)>,
}

impl Waiting {
    /// Starts the clock with a time limit of `most`; `None` for no limit. Work that does not end by itself is ended by
    /// `late`.
    pub(crate) fn begin(language: Language, most: Option<Duration>, late: impl FnOnce() + Send + 'static) -> Self {
        let (progress, most) = PATIENCE.get_or_init(|| {
            let progress = if most.is_some() { Progress::limited() } else { Progress::endless() };
            (progress, most)
        });
        let mut waiting = Self { done: Vec::new() };
        if let Some(most) = *most {
            waiting.spawn(move |is_done| {
                if is_done.recv_timeout(most) == Err(RecvTimeoutError::Timeout) {
                    progress.cancel();
                    if is_done.recv_timeout(GRACE) == Err(RecvTimeoutError::Timeout) {
                        late();
                    }
                }
            });
        }
        if std::io::stderr().is_terminal() {
            waiting.spawn(move |is_done| show(&is_done, progress, language));
        }
        waiting
    }

    fn spawn(&mut self, work: impl FnOnce(Receiver<()>) + Send + 'static) {
        let (done, is_done) = channel::<()>();
        self.done.push((done, std::thread::spawn(move || work(is_done))));
    }
}

/// Shows the progress until the work is done.
fn show(is_done: &Receiver<()>, progress: &Progress, language: Language) {
    if is_done.recv_timeout(QUIET) != Err(RecvTimeoutError::Timeout) {
        return;
    }
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    while is_done.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
        bar.set_message(message(progress, language));
        bar.tick();
    }
    bar.finish_and_clear();
}

/// Returns the text of the progress, with the completed share if it is known.
fn message(progress: &Progress, language: Language) -> String {
    match progress.progress() {
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
            // The progress line is removed before the answer is written.
            let _ = thread.join();
        }
    }
}
